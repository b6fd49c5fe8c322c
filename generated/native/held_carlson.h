/* Carlson's integrals R_F and R_D, in pairs that know how far they may be off.

   Written by `make derive`; never edit.
   Input: the series in derivations/forces/elliptic.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#ifndef HELD_CARLSON_H
#define HELD_CARLSON_H

#include "held.h"

typedef struct {
    sf_held R_F, R_D;
} held_carlson;

/* The share by which three numbers differ from a mean of theirs, of doubles. */
static inline double held_carlson_apart(double x, double y, double z, double mean)
{
    return sfi_most(sfi_most(fabs(x - mean), fabs(y - mean)), fabs(z - mean)) / mean;
}

/* R_F of numbers that are nearly equal, over their mean to the power -1/2: x, y are what the first two lack of the
 * mean, over it. Terms of degree 4 and more, below 2^-50, are doubles; what they err by and the terms of degree 8 and more,
 * which are left out, are below SFH_ERROR: the coefficient of degree N is no larger than N + 1. */
static inline sf_held held_carlson_R_F_series(sf_held x, sf_held y)
{
    const sf_held z = sfh_sub(sfh_neg(x), y);
    const sf_held t0 = sfh_mul(x, y);
    const sf_held E2 = sfh_add(sfh_add(t0, sfh_mul(x, z)), sfh_mul(y, z));
    const sf_held E3 = sfh_mul(t0, z);
    const double e2 = E2.x.high;
    const double e3 = E3.x.high;
    const double e2_2 = e2 * e2;
    const double e2_3 = e2 * e2_2;
    const double rest = -0.068181818181818177 * e2 * e3 + 0.0625 * e2_2 * e3 + 0.041666666666666664 * e2_2 -
        0.02403846153846154 * e2_3 + 0.028846153846153848 * e3 * e3;
    const double off = SFH_ERROR + E2.off + E3.off;
    return sfh_add(sfh_add(sfh_add(sfh_neg(sfh_mul(sfh_around(0.10000000000000001, -5.551115123125783e-18), E2)),
        sfh_mul(sfh_around(0.071428571428571425, 3.9650822308041303e-18), E3)), sfh_point(1.0)), sfh_of(sfp_point(rest), off));
}

/* R_D of numbers that are nearly equal, over their mean to the power -3/2: x, y are what the first two lack of the
 * mean, over it. Terms of degree 4 and more, below 2^-50, are doubles; what they err by and the terms of degree 8 and more,
 * which are left out, are below SFH_ERROR: the coefficient of degree N is no larger than N + 1. */
static inline sf_held held_carlson_R_D_series(sf_held x, sf_held y)
{
    const sf_held z = sfh_sub(sfh_neg(sfh_mul(sfh_around(0.33333333333333331, 1.8503717077085941e-17), x)),
        sfh_mul(sfh_around(0.33333333333333331, 1.8503717077085941e-17), y));
    const sf_held z2 = sfh_square(z);
    const sf_held t0 = sfh_mul(x, y);
    const sf_held t1 = sfh_mul(x, z);
    const sf_held t2 = sfh_mul(y, z);
    const sf_held t3 = sfh_add(sfh_times(3.0, t1), sfh_times(3.0, t2));
    const sf_held E2 = sfh_add(sfh_add(t0, t3), sfh_times(3.0, z2));
    const sf_held t4 = sfh_times(3.0, t0);
    const sf_held E3 = sfh_mul(z, sfh_add(sfh_add(t3, t4), z2));
    const sf_held E4 = sfh_mul(z2, sfh_add(sfh_add(t1, t2), t4));
    const sf_held z3 = sfh_mul(z, z2);
    const sf_held E5 = sfh_mul(t0, z3);
    const double e2 = E2.x.high;
    const double e3 = E3.x.high;
    const double e4 = E4.x.high;
    const double e5 = E5.x.high;
    const double e2_2 = e2 * e2;
    const double e2_3 = e2 * e2_2;
    const double rest = -0.17307692307692307 * e2 * e3 + 0.14999999999999999 * e2 * e4 - 0.13235294117647059 * e2 * e5 +
        0.16544117647058823 * e2_2 * e3 + 0.10227272727272728 * e2_2 - 0.0625 * e2_3 + 0.074999999999999997 * e3 *
        e3 - 0.13235294117647059 * e3 * e4 - 0.13636363636363635 * e4 + 0.11538461538461539 * e5;
    const double off = SFH_ERROR + E2.off + E3.off + E4.off + E5.off;
    return sfh_add(sfh_add(sfh_add(sfh_neg(sfh_mul(sfh_around(0.21428571428571427, 1.1895246692412391e-17), E2)),
        sfh_mul(sfh_around(0.16666666666666666, 9.2518585385429707e-18), E3)), sfh_point(1.0)), sfh_of(sfp_point(rest), off));
}

/* Both of (x, y, z), of which one may be 0. The arguments are duplicated until they are nearly equal. */
static held_carlson held_carlson_of(sf_held x, sf_held y, sf_held z)
{
    sf_held sum = sfh_point(0);
    double scale = 1;
    held_carlson out;
    int n;
    for (n = 0; n < SFH_MOST_DUPLICATIONS; n++) {
        const double a = x.x.high, b = y.x.high, c = z.x.high;
        if (held_carlson_apart(a, b, c, (a + b + c) / 3) <= SFH_EQUAL && held_carlson_apart(a, b, c, (a + b + 3 * c) / 5) <= SFH_EQUAL)
            break;
        const sf_held p = sfh_sqrt(x), q = sfh_sqrt(y), r = sfh_sqrt(z);
        const sf_held lambda = sfh_add(sfh_mul(p, q), sfh_mul(r, sfh_add(p, q)));
        sum = sfh_add(sum, sfh_times(scale, sfh_inverse(sfh_mul(r, sfh_add(z, lambda)))));
        x = sfh_times(0.25, sfh_add(x, lambda));
        y = sfh_times(0.25, sfh_add(y, lambda));
        z = sfh_times(0.25, sfh_add(z, lambda));
        scale *= 0.25;
    }
    if (n == SFH_MOST_DUPLICATIONS) { /* or an argument is NaN */
        out.R_F = out.R_D = sfh_of(sfp_point(0), HUGE_VAL);
        return out;
    }
    {
        const sf_held mean = sfh_div(sfh_add(sfh_add(x, y), z), sfh_point(3)), over = sfh_inverse(mean);
        const sf_held one = sfh_mul(sfh_sub(mean, x), over), other = sfh_mul(sfh_sub(mean, y), over);
        out.R_F = sfh_mul(sfh_sqrt(over), held_carlson_R_F_series(one, other));
    }
    {
        const sf_held mean = sfh_div(sfh_add(sfh_add(x, y), sfh_times(3, z)), sfh_point(5)), over = sfh_inverse(mean);
        const sf_held one = sfh_mul(sfh_sub(mean, x), over), other = sfh_mul(sfh_sub(mean, y), over);
        const sf_held last = sfh_mul(sfh_mul(over, sfh_sqrt(over)), held_carlson_R_D_series(one, other));
        out.R_D = sfh_add(sfh_times(3, sum), sfh_times(scale, last));
    }
    return out;
}

#endif
