/* Loops built once more for wide vectors, and which of these builds runs here.
 *
 *   SF_WIDE   before a function whose loop vectorises
 *   SF_FMA    before a function of scalar code that calls fma()
 *   SF_INDEPENDENT  before the for of such a loop: gcc does not heed restrict on local pointers, and gives up on loops
 *                   that need more than ten checks of overlap
 *
 * The clones differ in speed only: no build contracts a*b + c, and fma() rounds once with and without the instruction.
 * "arch=x86-64-v3" asks for features (gcc 12); "arch=haswell" would ask for that very model of processor.
 * SF_NO_CLONES leaves the compiler's own target, for builds with -march and for comparing the clones.
 */
#ifndef SF_CLONES_H
#define SF_CLONES_H

#include <stddef.h>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__) && !defined(SF_NO_CLONES)
#if __GNUC__ >= 12
#define SF_WIDE __attribute__((flatten, target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#define SF_FMA __attribute__((flatten, target_clones("default", "arch=x86-64-v3")))
#define SF_CLONES "baseline, x86-64-v3, x86-64-v4"
#define SF_CHOSEN \
    (__builtin_cpu_supports("x86-64-v4") ? "x86-64-v4" : __builtin_cpu_supports("x86-64-v3") ? "x86-64-v3" : "baseline")
#else
#define SF_WIDE __attribute__((flatten, target_clones("default", "avx2", "avx512f")))
#define SF_FMA __attribute__((flatten, target_clones("default", "fma")))
#define SF_CLONES "baseline, avx2, avx512f"
#define SF_CHOSEN (__builtin_cpu_supports("avx512f") ? "avx512f" : __builtin_cpu_supports("avx2") ? "avx2" : "baseline")
#endif
#elif defined(__GNUC__)
#define SF_WIDE __attribute__((flatten))
#define SF_FMA __attribute__((flatten))
#else
#define SF_WIDE
#define SF_FMA
#endif

#ifndef SF_CLONES
#define SF_CLONES "one build"
#define SF_CHOSEN "the compiler's target"
#endif

#if defined(__GNUC__) && !defined(__clang__)
#define SF_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SF_INDEPENDENT
#endif

#if defined(__clang__)
#define SF_COMPILER "clang " __VERSION__
#elif defined(__GNUC__)
#define SF_COMPILER "gcc " __VERSION__
#else
#define SF_COMPILER "unknown"
#endif

#endif
