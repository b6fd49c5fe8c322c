/* Arithmetic on pairs that know how far they may be off. Takes numbers of some thirty digits with a bound of their
 * error; returns such numbers. And Carlson's integrals of them, which closed forms of averages are made of: these
 * divide by what may be small, and lose digits that doubles do not have.
 *
 * An operation on pairs errs by less than SFB_ERROR of its result, a sum by that of its terms (pair.h). Bounds are
 * doubles; they are rounded up by a factor, which is more than their own few roundings.
 */
#pragma once

#include "interval.h"
#include "pair_angles.h"

typedef struct {
    sf_pair x;
    double off;
} sf_bounded;

#define SFB_ERROR 0x1p-100
#define SFB_UP (1 + 0x1p-40)
/* no pair has lost more to underflow */
#define SFB_LEAST 0x1p-960
/* arguments of Carlson's integrals are nearly equal when they differ by so much, relatively; after as many duplications
 * as that takes from any doubles */
#define SFB_EQUAL 0x1p-14
enum { SFB_MOST_DUPLICATIONS = 600 };

TWOFOLD_INLINE sf_bounded sfb_of(sf_pair x, double off) { return (sf_bounded){x, off}; }
TWOFOLD_INLINE sf_bounded sfb_point(double x) { return sfb_of(sfp_point(x), 0); }
/* of a constant that is no double: the pair next to it */
TWOFOLD_INLINE sf_bounded sfb_around(double high, double low) {
    return sfb_of(sfp_of(high, low), SFB_ERROR * fabs(high));
}
TWOFOLD_INLINE double sfb_size(sf_bounded a) { return fabs(a.x.high) * SFB_UP; }
TWOFOLD_INLINE sf_bounded sfb_neg(sf_bounded a) { return sfb_of(sfp_neg(a.x), a.off); }
TWOFOLD_INLINE sf_bounded sfb_add(sf_bounded a, sf_bounded b) {
    return sfb_of(sfp_add(a.x, b.x), (a.off + b.off + SFB_ERROR * (sfb_size(a) + sfb_size(b))) * SFB_UP);
}
TWOFOLD_INLINE sf_bounded sfb_sub(sf_bounded a, sf_bounded b) { return sfb_add(a, sfb_neg(b)); }
TWOFOLD_INLINE sf_bounded sfb_mul(sf_bounded a, sf_bounded b) {
    const double one = sfb_size(a), other = sfb_size(b);
    const double off = one * b.off + other * a.off + a.off * b.off + SFB_ERROR * one * other;
    return sfb_of(sfp_mul(a.x, b.x), off * SFB_UP + SFB_LEAST);
}
TWOFOLD_INLINE sf_bounded sfb_times(double c, sf_bounded a) {
    return sfb_of(sfp_times(c, a.x), fabs(c) * (a.off + SFB_ERROR * sfb_size(a)) * SFB_UP + SFB_LEAST);
}
TWOFOLD_INLINE sf_bounded sfb_square(sf_bounded a) { return sfb_mul(a, a); }
/* nothing is known of a quotient by what may be 0 */
static inline sf_bounded sfb_div(sf_bounded a, sf_bounded b) {
    const double inverse = 1 / b.x.high, quotient = a.x.high * inverse, ratio = b.off * fabs(inverse) * SFB_UP;
    const double left = fma(-quotient, b.x.high, a.x.high) + fma(-quotient, b.x.low, a.x.low);
    const double size = fabs(quotient) * SFB_UP;
    if (!(ratio < 0.5 && fabs(b.x.high) > SFB_LEAST))
        return sfb_of(sfp_point(quotient), HUGE_VAL);
    return sfb_of(sfp_of(quotient, left * inverse),
                  ((a.off * fabs(inverse) + size * ratio) * (1 + 2 * ratio) + SFB_ERROR * size) * SFB_UP +
                      SFB_LEAST * sfi_most(fabs(inverse), 1));
}
static inline sf_bounded sfb_inverse(sf_bounded a) { return sfb_div(sfb_point(1), a); }
/* of what is not negative */
static inline sf_bounded sfb_sqrt(sf_bounded a) {
    const double root = sqrt(a.x.high), inverse = 1 / root, square_low = fma(root, root, -a.x.high);
    if (!(a.x.high * (1 - 0x1p-40) > a.off && a.x.high > SFB_LEAST))
        return sfb_of(sfp_point(0), sqrt((fmax(a.x.high, 0) + a.off) * SFB_UP) * SFB_UP + 0x1p-480);
    return sfb_of(sfp_of(root, 0.5 * (a.x.low - square_low) * inverse), (a.off * inverse + SFB_ERROR * root) * SFB_UP);
}
/* The angle of (x, y) from 0 to pi/2: a point that is moved by so much is seen under no larger angle than the arcsine
 * of its share, which is less than twice the share. */
static inline sf_bounded sfb_atan2(sf_bounded y, sf_bounded x) {
    const sf_pair angle = pair_angles_atan2(y.x, x.x);
    const double shift = (y.off + x.off) * SFB_UP, away = fmax(fabs(y.x.high), fabs(x.x.high));
    if (!(shift < 0.5 * away))
        return sfb_of(angle, HUGE_VAL);
    return sfb_of(angle, (2 * shift / away + SFB_ERROR * angle.high) * SFB_UP + SFB_LEAST);
}

/* The doubles around it. */
static inline sf_interval sfb_interval(sf_bounded a) {
    const double off = (a.off + 0x1p-50 * fabs(a.x.low)) * SFB_UP;
    if (!(off < HUGE_VAL && fabs(a.x.high) < HUGE_VAL))
        return sfi_of(-HUGE_VAL, HUGE_VAL);
    return sfi_of(sfi_down(a.x.high + (a.x.low - off)), sfi_up(a.x.high + (a.x.low + off)));
}
/* of an interval, whose ends lie near to each other */
static inline sf_bounded sfb_within(sf_interval a) {
    const double middle = 0.5 * a.lo + 0.5 * a.hi;
    return sfb_of(sfp_point(middle), sfi_most(sfi_up(a.hi - middle), sfi_up(middle - a.lo)) * SFB_UP);
}
