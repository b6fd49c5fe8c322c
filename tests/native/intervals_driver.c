/* Interval arithmetic and the averages on intervals, for a test to call. */
#include "elementary.h"
#include "exact_inputs.h"
#include "records.h"

static sf_interval elementary(int function, sf_interval a, sf_interval b) {
    switch (function) {
    case 0:
        return sfi_exp(a);
    case 1:
        return sfi_log(a);
    case 2:
        return sfi_root(a);
    case 3:
        return sfi_cbrt(a);
    case 4:
        return sfi_sin(a);
    case 5:
        return sfi_cos(a);
    case 6:
        return sfi_tan(a);
    case 7:
        return sfi_sinh(a);
    case 8:
        return sfi_cosh(a);
    case 9:
        return sfi_tanh(a);
    case 10:
        return sfi_asin(a);
    case 11:
        return sfi_acos(a);
    case 12:
        return sfi_atan(a);
    case 13:
        return sfi_asinh(a);
    case 14:
        return sfi_acosh(a);
    case 15:
        return sfi_atanh(a);
    case 16:
        return sfi_log1p(a);
    default:
        return sfi_power(a, b);
    }
}

static sf_interval one(int operation, sf_interval a, sf_interval b) {
    switch (operation) {
    case 0:
        return sfi_add(a, b);
    case 1:
        return sfi_sub(a, b);
    case 2:
        return sfi_mul(a, b);
    case 3:
        return sfi_div(a, b);
    case 4:
        return sfi_square(a);
    case 5:
        return sfi_sqrt(a);
    case 6:
        return sfi_atan2(a, b);
    case 7:
        return sfi_times(0.1, a);
    default:
        return elementary(operation - 8, a, b);
    }
}

/* n pairs of intervals in, n intervals out */
void operate(int operation, long n, const double *in, double *out) {
    for (long i = 0; i < n; i++) {
        const sf_interval r = one(operation, sfi_of(in[4 * i], in[4 * i + 1]), sfi_of(in[4 * i + 2], in[4 * i + 3]));
        out[2 * i] = r.lo, out[2 * i + 1] = r.hi;
    }
}

/* h, h_A, h_AA, h_AAA and h - A h_A at an amplitude of a piece, given by how much it exceeds the piece's beginning, and
 * the amplitude; 0 where no proof is possible */
int known(const char *name, const double *design, int piece, double beyond, double *out) {
    for (unsigned k = 0; k < sizeof records / sizeof records[0]; k++) {
        sf_inputs inputs;
        sf_interval values[6];
        if (strcmp(records[k]->name, name) != 0 || !sf_give(records[k], design, 0.0, 0.0, &inputs))
            continue;
        values[5] = sf_beyond(&inputs, piece, sfi_point(beyond));
        inputs.mechanism->averaged_within(inputs.mechanism, piece, values[5], sfi_point(beyond), inputs.p, values);
        for (int i = 0; i < 6; i++)
            out[2 * i] = values[i].lo, out[2 * i + 1] = values[i].hi;
        return 1;
    }
    return 0;
}

static sf_bounded on_bounded(int operation, sf_bounded a, sf_bounded b, sf_bounded c) {
    switch (operation) {
    case 0:
        return sfb_add(a, b);
    case 1:
        return sfb_sub(a, b);
    case 2:
        return sfb_mul(a, b);
    case 3:
        return sfb_div(a, b);
    case 4:
        return sfb_square(a);
    case 5:
        return sfb_sqrt(a);
    case 6:
        return sfb_atan2(a, b);
    case 7:
        return sfb_times(0.1, a);
    case 8:
        return bounded_carlson_of(a, b, c).R_F;
    default:
        return bounded_carlson_of(a, b, c).R_D;
    }
}

/* n times three pairs with what they may be off in, n such out, and the doubles around them */
void operate_bounded(int operation, long n, const double *in, double *out) {
    for (long i = 0; i < n; i++) {
        const double *x = in + 9 * i;
        const sf_bounded r = on_bounded(operation, sfb_of(sfp_of(x[0], x[1]), x[2]), sfb_of(sfp_of(x[3], x[4]), x[5]),
                                        sfb_of(sfp_of(x[6], x[7]), x[8]));
        const sf_interval around = sfb_interval(r);
        out[5 * i] = r.x.high, out[5 * i + 1] = r.x.low, out[5 * i + 2] = r.off;
        out[5 * i + 3] = around.lo, out[5 * i + 4] = around.hi;
    }
}
