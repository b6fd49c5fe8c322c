/* Power series, coefficient by coefficient: what the generated forces are written in.
 *
 * Coefficient n of a product is a[0] b[n] + a[n] b[0] and a sum over lower coefficients. These sums are known before
 * coefficient n is begun; four of them, of four products, are added side by side. */
#pragma once

#include <math.h>

#include "clones.h"

/* The tail of order 24 falls below a rounding in steps of a fifth of the radius of convergence. Longer steps by orders
 * up to 32 cost as much, shorter ones by 20 more. */
enum { SF_ORDER = 24, SF_TERMS = SF_ORDER + 1 };
/* of a piece, and of the fours of sums that it has */
enum { SF_MOST_SERIES = 256, SF_MOST_FOURS = 64 };

typedef double sf_series[SF_TERMS];

#if defined(__GNUC__)
#define SF_INLINE inline __attribute__((always_inline))

typedef double sf_four __attribute__((vector_size(32)));

#define sf_four_of(a, b, c, d) ((sf_four){a, b, c, d})
#define sf_lane(fours, k) ((fours)[(k) / 4][(k) % 4])
#define sf_plus(a, b) ((a) + (b))
#define sf_less(a, b) ((a) - (b))
#define sf_times(a, b) ((a) * (b))
#else
#define SF_INLINE inline

typedef struct {
    double at[4];
} sf_four;

#define sf_four_of(a, b, c, d) ((sf_four){{a, b, c, d}})
#define sf_lane(fours, k) ((fours)[(k) / 4].at[(k) % 4])
#define SF_EACH_OF_FOUR(name, op)                                                                                      \
    static inline sf_four name(sf_four a, sf_four b) {                                                                 \
        for (int k = 0; k < 4; k++)                                                                                    \
            a.at[k] op b.at[k];                                                                                        \
        return a;                                                                                                      \
    }
SF_EACH_OF_FOUR(sf_plus, +=)
SF_EACH_OF_FOUR(sf_less, -=)
SF_EACH_OF_FOUR(sf_times, *=)
#endif

#define sf_all(a) sf_four_of(a, a, a, a)
#define sf_more(sum, a, b) sf_plus(sum, sf_times(a, b))

static const double sf_over[SF_TERMS + 1] = {0.0,      1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,
                                             1.0 / 7,  1.0 / 8,  1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13,
                                             1.0 / 14, 1.0 / 15, 1.0 / 16, 1.0 / 17, 1.0 / 18, 1.0 / 19, 1.0 / 20,
                                             1.0 / 21, 1.0 / 22, 1.0 / 23, 1.0 / 24, 1.0 / 25};

/* What coefficient n is made of, series by series: those of order 0, 1, n - 1 and n, of which the last are put in one
 * by one, and reciprocals of those of order 0. Sums hold a[j] b[n - j] for 1 < j < n - 1: what was known last is added
 * last. For n < 3 they hold all 0 < j < n, and `last` is zero. */
typedef struct {
    int n;
    const double *first, *second, *last, *w, *over;
    const sf_four *sum;
} sf_coefficients;
