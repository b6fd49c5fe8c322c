/* Series of Carlson's integrals R_F and R_D, in pairs that know how far they may be off.

   Written by `make derive` from the series in derivations/forces/elliptic.py; never edit. */

#ifndef BOUNDED_CARLSON_H
#define BOUNDED_CARLSON_H

#include "bounded.h"

#include "arithmetic_bounded.h"

/* R_F of numbers that are nearly equal, over their mean to the power -1/2: x, y are what the first two lack of the
 * mean, over it. Terms of degree 4 and more, below 2^-50, are doubles; what they err by and the terms of degree 8 and more,
 * which are left out, are below SFB_ERROR: the coefficient of degree N is no larger than N + 1. */
static inline sf_bounded bounded_carlson_R_F_series(sf_bounded x, sf_bounded y) {
    const sf_bounded z = SUB(NEG(x), y);
    const sf_bounded t0 = MUL(x, y);
    const sf_bounded E2 = ADD(ADD(t0, MUL(x, z)), MUL(y, z));
    const sf_bounded E3 = MUL(t0, z);
    const double e2 = E2.x.high;
    const double e3 = E3.x.high;
    const double e2_2 = e2 * e2;
    const double e2_3 = e2 * e2_2;
    const double rest = -0.068181818181818177 * e2 * e3 + 0.0625 * e2_2 * e3 + 0.041666666666666664 * e2_2 -
        0.02403846153846154 * e2_3 + 0.028846153846153848 * e3 * e3;
    const double off = SFB_ERROR + E2.off + E3.off;
    return sfb_add(ADD(ADD(NEG(MUL(CONSTANT(0.10000000000000001, -5.551115123125783e-18), E2)),
        MUL(CONSTANT(0.071428571428571425, 3.9650822308041303e-18), E3)), POINT(1.0)), sfb_of(sfp_point(rest), off));
}

/* R_D of numbers that are nearly equal, over their mean to the power -3/2: x, y are what the first two lack of the
 * mean, over it. Terms of degree 4 and more, below 2^-50, are doubles; what they err by and the terms of degree 8 and more,
 * which are left out, are below SFB_ERROR: the coefficient of degree N is no larger than N + 1. */
static inline sf_bounded bounded_carlson_R_D_series(sf_bounded x, sf_bounded y) {
    const sf_bounded z = SUB(NEG(MUL(CONSTANT(0.33333333333333331, 1.8503717077085941e-17), x)),
        MUL(CONSTANT(0.33333333333333331, 1.8503717077085941e-17), y));
    const sf_bounded z2 = SQUARE(z);
    const sf_bounded t0 = MUL(x, y);
    const sf_bounded t1 = MUL(x, z);
    const sf_bounded t2 = MUL(y, z);
    const sf_bounded t3 = ADD(TIMES(3.0, t1), TIMES(3.0, t2));
    const sf_bounded E2 = ADD(ADD(t0, t3), TIMES(3.0, z2));
    const sf_bounded t4 = TIMES(3.0, t0);
    const sf_bounded E3 = MUL(z, ADD(ADD(t3, t4), z2));
    const sf_bounded E4 = MUL(z2, ADD(ADD(t1, t2), t4));
    const sf_bounded z3 = MUL(z, z2);
    const sf_bounded E5 = MUL(t0, z3);
    const double e2 = E2.x.high;
    const double e3 = E3.x.high;
    const double e4 = E4.x.high;
    const double e5 = E5.x.high;
    const double e2_2 = e2 * e2;
    const double e2_3 = e2 * e2_2;
    const double rest = -0.17307692307692307 * e2 * e3 + 0.14999999999999999 * e2 * e4 - 0.13235294117647059 * e2 * e5 +
        0.16544117647058823 * e2_2 * e3 + 0.10227272727272728 * e2_2 - 0.0625 * e2_3 + 0.074999999999999997 * e3 *
        e3 - 0.13235294117647059 * e3 * e4 - 0.13636363636363635 * e4 + 0.11538461538461539 * e5;
    const double off = SFB_ERROR + E2.off + E3.off + E4.off + E5.off;
    return sfb_add(ADD(ADD(NEG(MUL(CONSTANT(0.21428571428571427, 1.1895246692412391e-17), E2)),
        MUL(CONSTANT(0.16666666666666666, 9.2518585385429707e-18), E3)), POINT(1.0)), sfb_of(sfp_point(rest), off));
}

#include "arithmetic_end.h"
#endif
