/* Sums and products with their rounding errors: double-double arithmetic by Dekker, Knuth and fma.

   C99. Build without contraction and without fast-math: the error terms would be optimised away. fma() is worth a
   hardware instruction; without it the results are the same and slower. */

#pragma once

#include <math.h>

#if defined(__GNUC__)
#define TWOFOLD_INLINE static inline __attribute__((always_inline))
#else
#define TWOFOLD_INLINE static inline
#endif

/* a + b and its rounding error */
TWOFOLD_INLINE double twofold_two_sum(double a, double b, double *low) {
    const double s = a + b;
    const double t = s - a;
    *low = (a - (s - t)) + (b - t);
    return s;
}

/* a b and its rounding error */
TWOFOLD_INLINE double twofold_two_product(double a, double b, double *low) {
    const double p = a * b;
    *low = fma(a, b, -p);
    return p;
}

/* The sum of n doubles, distilled until they no longer overlap: its sign is certain. */
TWOFOLD_INLINE double twofold_distilled(double *terms, int n) {
    double sum = 0;
    for (int pass = 0; pass < n; pass++)
        for (int i = 1; i < n; i++)
            terms[i] = twofold_two_sum(terms[i], terms[i - 1], &terms[i - 1]);
    for (int i = 0; i < n; i++)
        sum += terms[i];
    return sum;
}
