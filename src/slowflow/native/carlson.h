/* Carlson's integrals R_F and R_D, in pairs that know how far they may be off. Takes three numbers of which one may be 0;
 * returns both integrals. Their series about equal numbers are derived: held_carlson.h, which the derivation prints.
 */
#pragma once

#include "held.h"
#include "held_carlson.h"

typedef struct {
    sf_held R_F, R_D;
} held_carlson;

/* The share by which three numbers differ from a mean of theirs, of doubles. */
static inline double held_carlson_apart(double x, double y, double z, double mean)
{
    return sfi_most(sfi_most(fabs(x - mean), fabs(y - mean)), fabs(z - mean)) / mean;
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
