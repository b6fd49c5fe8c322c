/* The arctangent of pairs: the next of PAIR_ANGLES_CUT + 1 angles is taken off, a power series has the rest
 * (derivations/codegen/arctangent.py). The derivation prints both: pair_angle_series.h.
 */
#pragma once

#include "pair.h"
#include "pair_angle_series.h"

#if defined(__GNUC__)
#define PAIR_ANGLES_CONST __attribute__((const))
#else
#define PAIR_ANGLES_CONST
#endif

/* The angle whose tangent is y/x, 0 <= y <= x: where an angle and its complement are needed, it is computed once. */
PAIR_ANGLES_CONST static sf_pair pair_angles_acute(sf_pair y, sf_pair x) {
    const sf_pair t = sfp_div(y, x);
    const int k = t.high > 0 ? (int)(PAIR_ANGLES_CUT * t.high + 0.5) : 0; /* of no number, as in an unused lane, too */
    const double c = (double)k / PAIR_ANGLES_CUT;
    const sf_pair z = k == 0 ? t : sfp_div(sfp_sub(t, sfp_point(c)), sfp_add(sfp_point(1.0), sfp_times(c, t)));
    const sf_pair w = sfp_square(z);
    double tail = pair_angles_others[0];
    for (int i = 1; i < PAIR_ANGLES_OTHERS; i++)
        tail = tail * w.high + pair_angles_others[i];
    sf_pair e = sfp_add(sfp_mul(w, sfp_point(tail)), pair_angles_first[0]);
    for (int i = 1; i < PAIR_ANGLES_FIRST; i++)
        e = sfp_add(sfp_mul(w, e), pair_angles_first[i]);
    return sfp_add(pair_angles_table[k], sfp_add(z, sfp_mul(z, sfp_mul(w, e))));
}

/* The angle of (x, y) from 0 to pi/2, x and y not negative, not both 0. */
TWOFOLD_INLINE sf_pair pair_angles_atan2(sf_pair y, sf_pair x) {
    const int steep = y.high > x.high;
    const sf_pair angle = pair_angles_acute(steep ? x : y, steep ? y : x);
    return steep ? sfp_sub(pair_angles_half_pi, angle) : angle;
}

/* The angle of (y, x): as pair_angles_atan2(x, y). */
TWOFOLD_INLINE sf_pair pair_angles_atan2_swapped(sf_pair y, sf_pair x) {
    const int steep = y.high > x.high;
    const sf_pair angle = pair_angles_acute(steep ? x : y, steep ? y : x);
    return steep ? angle : sfp_sub(pair_angles_half_pi, angle);
}
