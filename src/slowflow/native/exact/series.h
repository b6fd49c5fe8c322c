/* Power series, coefficient by coefficient: what the generated forces are written in.
 *
 * Coefficient n of a product is a[0] b[n] + a[n] b[0] and a sum over lower coefficients. These sums are known before
 * coefficient n is begun; four of them, of four products, are added side by side. */
#ifndef SF_SERIES_H
#define SF_SERIES_H

#include <math.h>

#include "clones.h"

/* The tail of order 24 falls below a rounding in steps of a fifth of the radius of convergence. Longer steps by orders
 * up to 32 cost as much, shorter ones by 20 more. */
enum { SF_ORDER = 24, SF_TERMS = SF_ORDER + 1 };

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
#define SF_EACH(name, op)                              \
    static inline sf_four name(sf_four a, sf_four b)   \
    {                                                  \
        for (int k = 0; k < 4; k++)                    \
            a.at[k] op b.at[k];                        \
        return a;                                      \
    }
SF_EACH(sf_plus, +=)
SF_EACH(sf_less, -=)
SF_EACH(sf_times, *=)
#endif

#define sf_all(a) sf_four_of(a, a, a, a)
#define sf_more(sum, a, b) sf_plus(sum, sf_times(a, b))

static const double sf_over[SF_TERMS + 1] = {
    0.0,       1.0,       1.0 / 2,   1.0 / 3,   1.0 / 4,   1.0 / 5,   1.0 / 6,   1.0 / 7,   1.0 / 8,
    1.0 / 9,   1.0 / 10,  1.0 / 11,  1.0 / 12,  1.0 / 13,  1.0 / 14,  1.0 / 15,  1.0 / 16,  1.0 / 17,
    1.0 / 18,  1.0 / 19,  1.0 / 20,  1.0 / 21,  1.0 / 22,  1.0 / 23,  1.0 / 24,  1.0 / 25};

/* What coefficient n is made of, series by series: those of order 0, 1, n - 1 and n, of which the last are put in one
 * by one, and reciprocals of those of order 0. Sums hold a[j] b[n - j] for 1 < j < n - 1: what was known last is added
 * last. For n < 3 they hold all 0 < j < n, and `last` is zero. */
typedef struct {
    int n;
    const double *first, *second, *last, *w, *over;
    const sf_four *sum;
} sf_coefficients;

/* sum number `sum`, of a b, for 0 < j < n */
static SF_INLINE double sf_below(const sf_coefficients *c, int a, int b, int sum)
{
    return sf_lane(c->sum, sum) + (c->second[a] * c->last[b] + c->last[a] * c->second[b]);
}

static SF_INLINE double sf_product(const sf_coefficients *c, int a, int b, int sum)
{
    return (sf_below(c, a, b, sum) + c->w[a] * c->first[b]) + c->first[a] * c->w[b];
}

static SF_INLINE double sf_square(const sf_coefficients *c, int a, int sum)
{
    return sf_lane(c->sum, sum) + 2.0 * (c->second[a] * c->last[a] + c->first[a] * c->w[a]);
}

/* of q = a/b, over = 1/b; the sum is that of b q */
static SF_INLINE double sf_quotient(const sf_coefficients *c, int a, int b, int q, int sum)
{
    return (c->w[a] - sf_below(c, b, q, sum)) * c->over[q] - c->w[b] * (c->first[q] * c->over[q]);
}

static SF_INLINE double sf_reciprocal(const sf_coefficients *c, int b, int q, int sum)
{
    return -sf_below(c, b, q, sum) * c->over[q] - c->w[b] * (c->first[q] * c->over[q]);
}

/* of s = sqrt(a), over = 1/(2 s); the sum is that of s s */
static SF_INLINE double sf_root(const sf_coefficients *c, int a, int s, int sum)
{
    return (c->w[a] - (sf_lane(c->sum, sum) + 2.0 * c->second[s] * c->last[s])) * c->over[s];
}

/* of q = a^r, over = 1/a, from a q' = r a' q; the sums are those of (t a') q and a (t q') */
static SF_INLINE double sf_power(const sf_coefficients *c, int a, int q, int sum, double r)
{
    const int n = c->n;
    const double rising = sf_lane(c->sum, sum) + (c->second[a] * c->last[q] + (n - 1) * c->last[a] * c->second[q]);
    const double falling = sf_lane(c->sum, sum + 1) + ((n - 1) * c->second[a] * c->last[q] + c->last[a] * c->second[q]);
    return (r * (n * c->w[a] * c->first[q] + rising) - falling) * c->over[q] * sf_over[n];
}

/* of y from b y' = a', over = 1/b; the sum is that of b (t y') */
static SF_INLINE double sf_of_ratio(const sf_coefficients *c, int a, int b, int y, int sum)
{
    const int n = c->n;
    const double inner = (n - 1) * c->second[b] * c->last[y] + c->last[b] * c->second[y];
    return (n * c->w[a] - (sf_lane(c->sum, sum) + inner)) * c->over[y] * sf_over[n];
}

/* of y from y' = a' b; the sum is that of (t a') b */
static SF_INLINE double sf_of_rate(const sf_coefficients *c, int a, int b, int sum)
{
    const int n = c->n;
    const double inner = c->second[a] * c->last[b] + (n - 1) * c->last[a] * c->second[b];
    return (sf_lane(c->sum, sum) + inner + n * c->w[a] * c->first[b]) * sf_over[n];
}

#endif
