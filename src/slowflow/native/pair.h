/* Arithmetic on pairs: a number is the sum of a double and of what its rounding left, which makes some 32 digits.
 *
 * Takes pairs whose low part is below an ulp of the high one; returns such pairs, right to a few times 2^-104 of the
 * result; a sum to as much of its terms. Overflow and underflow of a part are not looked for: what is computed in pairs
 * corrects a number that is known, and is used only where it is small against that.
 */
#pragma once

#include <math.h>

#include "twofold.h"

typedef struct {
    double high, low;
} sf_pair;

/* high and low may overlap by some places, |high| >= |low| */
static inline sf_pair sfp_of(double high, double low) {
    const double sum = high + low;
    return (sf_pair){sum, low - (sum - high)};
}
static inline sf_pair sfp_point(double x) { return (sf_pair){x, 0}; }
static inline sf_pair sfp_neg(sf_pair a) { return (sf_pair){-a.high, -a.low}; }
static inline sf_pair sfp_add(sf_pair a, sf_pair b) {
    double low;
    const double high = twofold_two_sum(a.high, b.high, &low);
    return sfp_of(high, low + (a.low + b.low));
}
static inline sf_pair sfp_sub(sf_pair a, sf_pair b) { return sfp_add(a, sfp_neg(b)); }
static inline sf_pair sfp_mul(sf_pair a, sf_pair b) {
    double low;
    const double high = twofold_two_product(a.high, b.high, &low);
    return sfp_of(high, fma(a.high, b.low, fma(a.low, b.high, low)));
}
/* by a double */
static inline sf_pair sfp_times(double c, sf_pair a) {
    double low;
    const double high = twofold_two_product(c, a.high, &low);
    return sfp_of(high, fma(c, a.low, low));
}
static inline sf_pair sfp_square(sf_pair a) {
    double low;
    const double high = twofold_two_product(a.high, a.high, &low);
    return sfp_of(high, fma(2 * a.high, a.low, low));
}
/* by long division: a quotient in double, and what it leaves, of which the first part is exact */
static inline sf_pair sfp_div(sf_pair a, sf_pair b) {
    const double first = a.high / b.high;
    const double left = fma(-first, b.high, a.high) + fma(-first, b.low, a.low);
    return sfp_of(first, left / b.high);
}
static inline sf_pair sfp_inverse(sf_pair a) { return sfp_div(sfp_point(1), a); }
/* of what is not negative */
static inline sf_pair sfp_sqrt(sf_pair a) {
    const double root = sqrt(a.high);
    double low;
    const double square = twofold_two_product(root, root, &low);
    if (!(root > 0))
        return sfp_point(root);
    return sfp_of(root, ((a.high - square) - low + a.low) / (2 * root));
}
