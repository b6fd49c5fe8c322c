/* Elementary functions of closed intervals of doubles. Takes intervals; returns one that holds every value.
 *
 * Where an argument leaves a function's domain nothing is known: NaN.
 */
#pragma once

#include "interval.h"

/* what a function of the C library may err by, relatively; it is known to err by some ulps */
#define SFI_FUNCTION 0x1p-46
/* what represents any larger value at the lower end: products of six of them are doubles */
#define SFI_LARGEST 0x1p160
#define SFI_PI 3.14159265358979312

static inline sf_interval sfi_unknown(void) { return sfi_of(NAN, NAN); }

/* A function's values at the ends of its argument, rounded outwards. */
static inline sf_interval sfi_apart(double lo, double hi) {
    lo -= isinf(lo) ? 0 : SFI_FUNCTION * fabs(lo);
    hi += isinf(hi) ? 0 : SFI_FUNCTION * fabs(hi);
    return sfi_of(lo > SFI_LARGEST ? SFI_LARGEST : lo, hi < -SFI_LARGEST ? -SFI_LARGEST : hi);
}

/* A function that rises, on its domain. */
#define SFI_RISING(name, function, least, most)                                                                        \
    static inline sf_interval name(sf_interval a) {                                                                    \
        return a.lo >= (least) && a.hi <= (most) ? sfi_apart(function(a.lo), function(a.hi)) : sfi_unknown();          \
    }

SFI_RISING(sfi_exp, exp, -HUGE_VAL, HUGE_VAL)
SFI_RISING(sfi_log, log, 0, HUGE_VAL)
SFI_RISING(sfi_log1p, log1p, -1, HUGE_VAL)
SFI_RISING(sfi_root, sqrt, 0, HUGE_VAL)
SFI_RISING(sfi_cbrt, cbrt, 0, HUGE_VAL)
SFI_RISING(sfi_sinh, sinh, -HUGE_VAL, HUGE_VAL)
SFI_RISING(sfi_tanh, tanh, -HUGE_VAL, HUGE_VAL)
SFI_RISING(sfi_asin, asin, -1, 1)
SFI_RISING(sfi_atan, atan, -HUGE_VAL, HUGE_VAL)
SFI_RISING(sfi_asinh, asinh, -HUGE_VAL, HUGE_VAL)
SFI_RISING(sfi_acosh, acosh, 1, HUGE_VAL)
SFI_RISING(sfi_atanh, atanh, -1, 1)

/* falls */
static inline sf_interval sfi_acos(sf_interval a) {
    return a.lo >= -1 && a.hi <= 1 ? sfi_apart(acos(a.hi), acos(a.lo)) : sfi_unknown();
}

/* between two poles */
static inline sf_interval sfi_tan(sf_interval a) {
    return floor(a.lo / SFI_PI + 0.5) == floor(a.hi / SFI_PI + 0.5) ? sfi_apart(tan(a.lo), tan(a.hi)) : sfi_unknown();
}

static inline sf_interval sfi_cosh(sf_interval a) {
    const double least = sfi_most(sfi_most(a.lo, -a.hi), 0), most = sfi_most(fabs(a.lo), fabs(a.hi));
    return a.lo <= a.hi ? sfi_apart(cosh(least), cosh(most)) : sfi_unknown();
}

/* Whether an interval may hold a place, or one that is some periods of 2 pi off: a rounding more of a turn is allowed
 * for. */
static inline int sfi_holds_turn(sf_interval a, double place) {
    const double from = (a.lo - place) / (2 * SFI_PI), to = (a.hi - place) / (2 * SFI_PI);
    return ceil(from - 0x1p-50 * (1 + fabs(from))) <= floor(to + 0x1p-50 * (1 + fabs(to)));
}

/* A function of period 2 pi between its values at the ends: 1 at its maximum, -1 half a period off. */
static inline sf_interval sfi_wave(sf_interval a, double maximum, double at_lo, double at_hi) {
    if (!(a.lo > -HUGE_VAL && a.hi < HUGE_VAL && a.lo <= a.hi))
        return sfi_of(-1, 1);
    return sfi_of(sfi_holds_turn(a, maximum + SFI_PI) ? -1 : sfi_least(at_lo, at_hi) - 0x1p-48,
                  sfi_holds_turn(a, maximum) ? 1 : sfi_most(at_lo, at_hi) + 0x1p-48);
}
static inline sf_interval sfi_sin(sf_interval a) { return sfi_wave(a, 0.5 * SFI_PI, sin(a.lo), sin(a.hi)); }
static inline sf_interval sfi_cos(sf_interval a) { return sfi_wave(a, 0, cos(a.lo), cos(a.hi)); }

/* Not negative, to a power: monotone in either. */
static inline sf_interval sfi_power(sf_interval a, sf_interval b) {
    const double lo_lo = pow(a.lo, b.lo), lo_hi = pow(a.lo, b.hi), hi_lo = pow(a.hi, b.lo), hi_hi = pow(a.hi, b.hi);
    if (!(a.lo >= 0 && a.lo <= a.hi && b.lo <= b.hi))
        return sfi_unknown();
    return sfi_apart(sfi_least(sfi_least(lo_lo, lo_hi), sfi_least(hi_lo, hi_hi)),
                     sfi_most(sfi_most(lo_lo, lo_hi), sfi_most(hi_lo, hi_hi)));
}
