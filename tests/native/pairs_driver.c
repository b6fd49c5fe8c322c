/* Double-double arithmetic and the averages in it, for a test to call. */
#include "exact_inputs.h"
#include "records.h"

static sf_pair one(int operation, sf_pair a, sf_pair b) {
    switch (operation) {
    case 0:
        return sfp_add(a, b);
    case 1:
        return sfp_sub(a, b);
    case 2:
        return sfp_mul(a, b);
    case 3:
        return sfp_div(a, b);
    case 4:
        return sfp_square(a);
    case 5:
        return sfp_sqrt(a);
    case 6:
        return pair_angles_atan2(a, b);
    default:
        return sfp_times(0.1, a);
    }
}

/* n times two pairs in, n pairs out */
void operate(int operation, long n, const double *in, double *out) {
    for (long i = 0; i < n; i++) {
        const sf_pair r = one(operation, sfp_of(in[4 * i], in[4 * i + 1]), sfp_of(in[4 * i + 2], in[4 * i + 3]));
        out[2 * i] = r.high, out[2 * i + 1] = r.low;
    }
}

/* h, h_A, h_AA, h_AAA at an amplitude on a piece; 0 where there are no pairs */
int known(const char *name, const double *design, int piece, double A, double *out) {
    for (unsigned k = 0; k < sizeof records / sizeof records[0]; k++) {
        sf_exactly exactly;
        sf_pair values[4];
        if (strcmp(records[k]->name, name) != 0 || !sf_make_exact(records[k], design, 0.0, 0.0, &exactly))
            continue;
        const sf_pair at = sfp_point(A), beyond = piece > 0 ? sfp_sub(at, exactly.b[piece - 1]) : at;
        exactly.mechanism->averaged_in_pairs(exactly.mechanism, piece, 4, at, beyond, exactly.p, values);
        for (int i = 0; i < 4; i++)
            out[2 * i] = values[i].high, out[2 * i + 1] = values[i].low;
        return 1;
    }
    return 0;
}
