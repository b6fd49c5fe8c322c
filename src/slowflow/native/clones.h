/* Loops built once more for wide vectors, and which of these builds runs here.
 *
 *   SF_WIDE   before a function whose loop vectorises
 *   SF_FMA    before a function of scalar code that calls fma()
 *   SF_FLAT   before one that is built once, with all that it calls in place: what is called does not vectorise
 *   SF_ALWAYS before one that is in place wherever it is called
 *   SF_INDEPENDENT  before the for of such a loop: gcc does not heed restrict on local pointers, and gives up on loops
 *                   that need more than ten checks of overlap
 *   SF_EACH   in place of the for of one over whole vectors of SF_WIDEST numbers: code for a rest would be as long as
 *             the loop itself, and loops are long
 *
 * The clones differ in speed only: no build contracts a*b + c, and fma() rounds once with and without the instruction.
 * "arch=x86-64-v3" asks for features (gcc 12); "arch=haswell" would ask for that very model of processor.
 * SF_NO_CLONES leaves the compiler's own target, for builds with -march and for comparing the clones; SF_HERE, as
 * "x86-64-v4", is the one target of a build that runs on no other machine.
 */
#pragma once

#include <stddef.h>
#include <stdlib.h> /* defines __GLIBC__; stddef.h is the compiler's */

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) && !defined(SF_NO_CLONES)
#define SF_HAS(feature) __builtin_cpu_supports(feature)
#if __GNUC__ >= 12
#define SF_V3 "arch=x86-64-v3"
#define SF_V4 "arch=x86-64-v4"
#define SF_FMA_TARGET SF_V3
#define SF_WIDE_CHOSEN (SF_HAS("x86-64-v4") ? "x86-64-v4" : SF_FMA_CHOSEN)
#define SF_FMA_CHOSEN (SF_HAS("x86-64-v3") ? "x86-64-v3" : "baseline")
#else
#define SF_V3 "avx2"
#define SF_V4 "avx512f"
#define SF_FMA_TARGET "fma"
#define SF_WIDE_CHOSEN (SF_HAS("avx512f") ? "avx512f" : SF_HAS("avx2") ? "avx2" : "baseline")
#define SF_FMA_CHOSEN (SF_HAS("fma") ? "fma" : "baseline")
#endif
#ifdef SF_HERE
#define SF_WIDE __attribute__((flatten, target("arch=" SF_HERE)))
#define SF_FMA __attribute__((flatten, target(SF_FMA_TARGET)))
#define SF_WIDE_BUILDS "arch=" SF_HERE
#define SF_FMA_BUILDS SF_FMA_TARGET
#else
#define SF_WIDE __attribute__((flatten, target_clones("default", SF_V3, SF_V4)))
#define SF_FMA __attribute__((flatten, target_clones("default", SF_FMA_TARGET)))
#define SF_WIDE_BUILDS "baseline, " SF_V3 ", " SF_V4
#define SF_FMA_BUILDS "baseline, " SF_FMA_TARGET
#endif
#define SF_PROCESSOR (SF_HAS("avx512f") ? "fma, avx2, avx512f" : SF_HAS("avx2") ? "fma, avx2" : "no avx2")
#else
#define SF_WIDE SF_FLAT
#define SF_FMA SF_WIDE
#define SF_WIDE_BUILDS "one"
#define SF_FMA_BUILDS "one"
#define SF_WIDE_CHOSEN "the compiler's target"
#define SF_FMA_CHOSEN "the compiler's target"
#define SF_PROCESSOR "unknown"
#endif

#if defined(__GNUC__)
#define SF_FLAT __attribute__((flatten))
#define SF_ALWAYS static inline __attribute__((always_inline))
#else
#define SF_FLAT
#define SF_ALWAYS static inline
#endif

#if defined(__GNUC__) && !defined(__clang__)
#define SF_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SF_INDEPENDENT
#endif

/* numbers in a vector */
enum { SF_WIDEST = 8 };
#define SF_WHOLE(n) ((n) & ~(ptrdiff_t)(SF_WIDEST - 1))
#define SF_EACH(i, n)                                                                                                  \
    SF_INDEPENDENT                                                                                                     \
    for (ptrdiff_t i = 0; i < SF_WHOLE(n); i++)

#if defined(__clang__)
#define SF_COMPILER "clang " __VERSION__
#elif defined(__GNUC__)
#define SF_COMPILER "gcc " __VERSION__
#else
#define SF_COMPILER "unknown"
#endif
