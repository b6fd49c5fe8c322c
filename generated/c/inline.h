/* How functions of the generated headers are declared, and what their comments say.

   Written by `make derive`; never edit.

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are those in floating point. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/codegen/rounding.py). Others are measured: the worst error of all
   outputs that was found, by a search that the Python module of the same name describes.
   u = 2^-53, kappa is the relative condition number of an output in all arguments. */

#ifndef INLINE_H
#define INLINE_H

/* what exported.c defines otherwise */
#ifndef SF_KERNEL
#define SF_KERNEL static inline
#endif

/* of what several kernels call, which the compiler takes apart again: each needs some of its results */
#ifdef __GNUC__
#define SF_COMMON static inline __attribute__((always_inline))
#else
#define SF_COMMON static inline
#endif

/* before a loop over a table, which then vectorises with what is around it */
#if defined(__GNUC__) && !defined(__clang__)
#define SF_UNROLLED _Pragma("GCC unroll 32")
#else
#define SF_UNROLLED
#endif

/* around kernels of one family, which take the same arguments, whether each needs them or not */
#if defined(__GNUC__)
#define SF_FAMILY_BEGIN _Pragma("GCC diagnostic push") _Pragma("GCC diagnostic ignored \"-Wunused-parameter\"")
#define SF_FAMILY_END _Pragma("GCC diagnostic pop")
#else
#define SF_FAMILY_BEGIN
#define SF_FAMILY_END
#endif

#endif
