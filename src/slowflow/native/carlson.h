/* Carlson's integrals R_F and R_D, in pairs that know how far they may be off. Takes three numbers of which one may be
 * 0; returns both integrals. Their series about equal numbers are derived: bounded_carlson.h, which the derivation
 * prints.
 */
#pragma once

#include "bounded.h"
#include "bounded_carlson.h"

typedef struct {
    sf_bounded R_F, R_D;
} bounded_carlson;

/* The share by which three numbers differ from a mean of theirs, of doubles. */
static inline double bounded_carlson_apart(double x, double y, double z, double mean) {
    return sfi_most(sfi_most(fabs(x - mean), fabs(y - mean)), fabs(z - mean)) / mean;
}

/* Both of (x, y, z), of which one may be 0. The arguments are duplicated until they are nearly equal. */
static bounded_carlson bounded_carlson_of(sf_bounded x, sf_bounded y, sf_bounded z) {
    sf_bounded sum = sfb_point(0);
    double scale = 1;
    bounded_carlson out;
    int n;
    for (n = 0; n < SFB_MOST_DUPLICATIONS; n++) {
        const double a = x.x.high, b = y.x.high, c = z.x.high;
        if (bounded_carlson_apart(a, b, c, (a + b + c) / 3) <= SFB_EQUAL &&
            bounded_carlson_apart(a, b, c, (a + b + 3 * c) / 5) <= SFB_EQUAL)
            break;
        const sf_bounded p = sfb_sqrt(x), q = sfb_sqrt(y), r = sfb_sqrt(z);
        const sf_bounded lambda = sfb_add(sfb_mul(p, q), sfb_mul(r, sfb_add(p, q)));
        sum = sfb_add(sum, sfb_times(scale, sfb_inverse(sfb_mul(r, sfb_add(z, lambda)))));
        x = sfb_times(0.25, sfb_add(x, lambda));
        y = sfb_times(0.25, sfb_add(y, lambda));
        z = sfb_times(0.25, sfb_add(z, lambda));
        scale *= 0.25;
    }
    if (n == SFB_MOST_DUPLICATIONS) { /* or an argument is NaN */
        out.R_F = out.R_D = sfb_of(sfp_point(0), HUGE_VAL);
        return out;
    }
    {
        const sf_bounded mean = sfb_div(sfb_add(sfb_add(x, y), z), sfb_point(3)), over = sfb_inverse(mean);
        const sf_bounded one = sfb_mul(sfb_sub(mean, x), over), other = sfb_mul(sfb_sub(mean, y), over);
        out.R_F = sfb_mul(sfb_sqrt(over), bounded_carlson_R_F_series(one, other));
    }
    {
        const sf_bounded mean = sfb_div(sfb_add(sfb_add(x, y), sfb_times(3, z)), sfb_point(5));
        const sf_bounded over = sfb_inverse(mean);
        const sf_bounded one = sfb_mul(sfb_sub(mean, x), over), other = sfb_mul(sfb_sub(mean, y), over);
        const sf_bounded last = sfb_mul(sfb_mul(over, sfb_sqrt(over)), bounded_carlson_R_D_series(one, other));
        out.R_D = sfb_add(sfb_times(3, sum), sfb_times(scale, last));
    }
    return out;
}
