/* Arithmetic on closed intervals of doubles, rounded outwards. Takes intervals; returns one that holds every result.
 *
 * What is not known is NaN, or reaches to infinity: a test that asks whether something is proved fails there. 0 times
 * infinity is 0, as infinity represents arbitrarily large numbers.
 *
 * Each operation is rounded to nearest and then moved by more than an ulp, so that no rounding mode is switched.
 */
#pragma once

#include <math.h>

#include "angles.h"

typedef struct {
    double lo, hi;
} sf_interval;

#define SFI_ULP 0x1p-52
#define SFI_LEAST 0x1p-1022
#define SFI_SMALL 0x1p-960 /* no product above it has lost digits to underflow */

/* of a sum, a root: exact where it is subnormal, and 0 only if it is exactly 0 */
#if defined(__FMA__) /* the same numbers, as a product with a power of two is not rounded */
static inline double sfi_down(double x) { return fma(-SFI_ULP, fabs(x), x); }
static inline double sfi_up(double x) { return fma(SFI_ULP, fabs(x), x); }
#else
static inline double sfi_down(double x) { return x - SFI_ULP * fabs(x); }
static inline double sfi_up(double x) { return x + SFI_ULP * fabs(x); }
#endif
static inline double sfi_least(double a, double b) { return a < b ? a : b; }
static inline double sfi_most(double a, double b) { return a > b ? a : b; }
/* Of a product, which may underflow; 0 times anything is 0. */
static inline double sfi_product_down(double a, double b) {
    const double product = a * b;
    if (fabs(product) > SFI_SMALL)
        return sfi_down(product);
    return a == 0 || b == 0 ? 0 : sfi_down(product) - SFI_LEAST;
}
static inline double sfi_product_up(double a, double b) {
    const double product = a * b;
    if (fabs(product) > SFI_SMALL)
        return sfi_up(product);
    return a == 0 || b == 0 ? 0 : sfi_up(product) + SFI_LEAST;
}

static inline sf_interval sfi_of(double lo, double hi) { return (sf_interval){lo, hi}; }
static inline sf_interval sfi_point(double x) { return sfi_of(x, x); }
/* of a constant that is no double */
static inline sf_interval sfi_around(double x) { return sfi_of(sfi_down(x), sfi_up(x)); }
static inline sf_interval sfi_hull(double a, double b) { return sfi_of(sfi_least(a, b), sfi_most(a, b)); }
static inline sf_interval sfi_neg(sf_interval a) { return sfi_of(-a.hi, -a.lo); }
static inline sf_interval sfi_add(sf_interval a, sf_interval b) {
    return sfi_of(sfi_down(a.lo + b.lo), sfi_up(a.hi + b.hi));
}
static inline sf_interval sfi_sub(sf_interval a, sf_interval b) {
    return sfi_of(sfi_down(a.lo - b.hi), sfi_up(a.hi - b.lo));
}

/* by c > 0 */
static inline sf_interval sfi_times(double c, sf_interval a) {
    return sfi_of(sfi_product_down(c, a.lo), sfi_product_up(c, a.hi));
}

/* of a.lo >= 0; one test shows that a product is far from underflow, as most are */
static inline sf_interval sfi_mul_positive(sf_interval a, sf_interval b) {
    if (a.lo * b.lo > SFI_SMALL)
        return sfi_of(sfi_down(a.lo * b.lo), sfi_up(a.hi * b.hi));
    if (a.lo * b.hi < -SFI_SMALL)
        return sfi_of(sfi_down(a.hi * b.lo), sfi_up(a.lo * b.hi));
    if (b.lo >= 0)
        return sfi_of(sfi_product_down(a.lo, b.lo), sfi_product_up(a.hi, b.hi));
    if (b.hi <= 0)
        return sfi_of(sfi_product_down(a.hi, b.lo), sfi_product_up(a.lo, b.hi));
    return sfi_of(sfi_product_down(a.hi, b.lo), sfi_product_up(a.hi, b.hi));
}

static inline sf_interval sfi_mul(sf_interval a, sf_interval b) {
    if (a.lo >= 0)
        return sfi_mul_positive(a, b);
    if (a.hi <= 0)
        return sfi_neg(sfi_mul_positive(sfi_neg(a), b));
    if (b.lo >= 0)
        return sfi_mul_positive(b, a);
    if (b.hi <= 0)
        return sfi_neg(sfi_mul_positive(sfi_neg(b), a));
    if (!(a.lo <= a.hi && b.lo <= b.hi))
        return sfi_point(NAN);
    return sfi_of(sfi_least(sfi_product_down(a.lo, b.hi), sfi_product_down(a.hi, b.lo)),
                  sfi_most(sfi_product_up(a.lo, b.lo), sfi_product_up(a.hi, b.hi)));
}

static inline sf_interval sfi_square(sf_interval a) {
    if (a.lo > 0 && a.lo * a.lo > SFI_SMALL && a.lo <= a.hi)
        return sfi_of(sfi_down(a.lo * a.lo), sfi_up(a.hi * a.hi));
    const double lo = a.lo > 0 ? a.lo : a.hi < 0 ? -a.hi : 0, hi = sfi_most(-a.lo, a.hi);
    if (!(a.lo <= a.hi))
        return sfi_point(NAN);
    return sfi_of(sfi_most(sfi_product_down(lo, lo), 0), sfi_product_up(hi, hi));
}

/* 1/a of an interval on one side of 0, which it may touch; of any other, or one that is not known, it is any number */
static inline sf_interval sfi_inverse(sf_interval a) {
    if (!(a.lo <= a.hi))
        return sfi_of(-HUGE_VAL, HUGE_VAL);
    if (a.lo >= 0)
        return sfi_of(sfi_most(sfi_down(1 / a.hi) - SFI_LEAST, 0), a.lo > 0 ? sfi_up(1 / a.lo) + SFI_LEAST : HUGE_VAL);
    if (a.hi <= 0)
        return sfi_of(a.hi < 0 ? sfi_down(1 / a.hi) - SFI_LEAST : -HUGE_VAL,
                      sfi_least(sfi_up(1 / a.lo) + SFI_LEAST, 0));
    return sfi_of(-HUGE_VAL, HUGE_VAL);
}
/* of the part that is not negative */
static inline sf_interval sfi_sqrt(sf_interval a) {
    return sfi_of(a.lo > 0 ? sfi_most(sfi_down(sqrt(a.lo)), 0) : 0, a.hi <= 0 ? 0 : sfi_up(sqrt(a.hi)));
}

static inline sf_interval sfi_div(sf_interval a, sf_interval b) { return sfi_mul(a, sfi_inverse(b)); }

/* what lies within a relative error of it */
static inline sf_interval sfi_within(sf_interval a, double error) {
    return sfi_mul(a, sfi_of(sfi_down(1 - error), sfi_up(1 + error)));
}

/* The angle of (x, y) from 0 to pi/2, x and y not negative: it rises with y and falls with x. The arctangent (angles.h)
 * errs by less than four roundings: one of the quotient, a small part of one by its series, one within that, one at the
 * end. */
static inline sf_interval sfi_atan2(sf_interval y, sf_interval x) {
    return sfi_of(sfi_most(sfi_down(sfi_down(angles_atan2(sfi_most(y.lo, 0), x.hi))), 0),
                  sfi_up(sfi_up(angles_atan2(y.hi, sfi_most(x.lo, 0)))));
}

/* The part that both hold; each is known to hold the value. */
static inline sf_interval sfi_both(sf_interval a, sf_interval b) {
    return sfi_of(b.lo > a.lo ? b.lo : a.lo, b.hi < a.hi ? b.hi : a.hi);
}

/* What holds both. */
static inline sf_interval sfi_join(sf_interval a, sf_interval b) {
    return sfi_of(sfi_least(a.lo, b.lo), sfi_most(a.hi, b.hi));
}

static inline int sfi_positive(sf_interval a) { return a.lo > 0; }
static inline int sfi_negative(sf_interval a) { return a.hi < 0; }
static inline int sfi_has_sign(sf_interval a) { return a.lo > 0 || a.hi < 0; }

/* The largest absolute value; NaN where an end is. */
static inline double sf_magnitude(sf_interval a) {
    const double low = fabs(a.lo), high = fabs(a.hi);
    return low >= high ? low : high >= low ? high : NAN;
}
