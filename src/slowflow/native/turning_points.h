/* Means over a cycle by the motion's ends, B + A and B - A, on boxes. Takes charts of a force and a box of x and y in
 * one; returns intervals that hold A, B, c_0 = <f>, s_0 = <f cos psi> and their slopes on all of it.
 *
 * The charts are those of slowflow/off_centre/turning_points.py, the mathematics
 * derivations/asymmetric/off_centre.py's. U_k and V_k are the means of (A cos psi - a)^k/k! above a step with 1 + cos
 * psi and 1 - cos psi. Both rise with either end of the motion, so that the values at two corners of a box hold them,
 * as tightly as can be.
 */
#pragma once

#include <stddef.h>

#include "elementary.h"
#include "off_centre.h"
#include "off_centre_intervals.h"

enum {
    SF_MOST_LINES = 32,  /* steps of a force, on both sides */
    SF_MOST_POWERS = 64, /* of u, in a piece */
    SF_OF_MOTION = 14    /* intervals that are known of a box */
};

/* by how much each step of a recursion errs by itself, over the sum of its terms: its own eight roundings, and those of
 * A, a and A^2 - a^2; where it begins its root and its angle */
#define SF_STEP_ERROR 0x1p-49
/* of a share of the cycle, and of steps that, rounded, do not add up to the last piece */
#define SF_SHARE_ERROR 0x1p-48
/* a root is taken for no less: it is a factor of products that vanish with it */
#define SF_TINY_ROOT 0x1p-400

/* What is known of a box, in the order in which the loop gives it: X and Y are A_x and A_y, X_x and Y_y their slopes,
 * c_x ... those of c_0. c_3 = <f'''> and s_2 = <f'' cos psi>, next to B = 0. */
typedef struct {
    sf_interval A, B, c_0, s_0, c_x, c_y, c_xx, c_yy, X, Y, X_x, Y_y, c_3, s_2;
} sf_ended;

/* The charts of a force. Rows of powers hold derivatives at u = 0 from the 0th on.
 * line, gain -- the steps' places by rising u, and what derivatives gain there, seen from u = 0 outwards
 * piece -- by rising u; last, even -- the odd part of the last one, which all of u has but for what is bounded, and
 *         what else it has
 * large -- the amplitude from which on motions are large against all steps; infinite where that is not used
 * outer, size -- bounds of the derivatives of what is bounded, and of the terms that these are made of
 * upper, lower, place, rooted -- of each chart the pieces at both ends, the ends where x = 0 and y = 0, and whether x
 *         and y are roots */
typedef struct {
    int lines, highest, charts;
    const double *line, *gain, *piece, *last, *even, *size, *outer, *upper, *lower, *place[2], *rooted[2];
    double large;
} sf_charts;

/* The same in one array: three numbers, `large`, and then what is pointed to, in that order; 0 where it is none. */
static int sf_read_charts(const double *packed, ptrdiff_t n, sf_charts *of) {
    const double *next = packed + 4;
    ptrdiff_t needed;
    if (n < 4 || !(packed[0] >= 0 && packed[0] <= SF_MOST_LINES && packed[1] >= 0 && packed[1] < SF_MOST_POWERS))
        return 0;
    of->lines = (int)packed[0], of->highest = (int)packed[1], of->charts = (int)packed[2], of->large = packed[3];
    const int powers = of->highest + 1;
    needed = 4 + of->lines + (ptrdiff_t)(2 * of->lines + 1 + 3) * powers + 3 + 6 * (ptrdiff_t)of->charts;
    if (n != needed)
        return 0;
    of->line = next, next += of->lines;
    of->gain = next, next += of->lines * powers;
    of->piece = next, next += (of->lines + 1) * powers;
    of->last = next, next += powers;
    of->even = next, next += powers;
    of->size = next, next += powers;
    of->outer = next, next += 3;
    of->upper = next, next += of->charts;
    of->lower = next, next += of->charts;
    for (int i = 0; i < 2; i++)
        of->place[i] = next, next += of->charts;
    for (int i = 0; i < 2; i++)
        of->rooted[i] = next, next += of->charts;
    return 1;
}

/* ==== Steps ====================================================================================================== */

/* L_k, U_k and V_k of a step. */
typedef struct {
    sf_interval L[SF_MOST_POWERS], U[SF_MOST_POWERS], V[SF_MOST_POWERS];
} sf_ladder;

/* At one corner, into the ends from the first to the last: 0 is the lower one, 1 the upper.
 * over, under: how far the upper end of the motion is above the step, and its lower end below it */
static inline void sf_climb(double over, double under, int highest, int first, int last, sf_ladder *out) {
    int exponent;
    /* in a unit of length in which nothing underflows */
    const double size = frexp(sfi_most(over, fabs(under)), &exponent), unit = ldexp(1, exponent);
    const double o = ldexp(over, -exponent), u = ldexp(under, -exponent);
    const double A = 0.5 * (o + u), a = 0.5 * (u - o), span = o * u;
    const int above = over > 0 && size > 0, passed = above && under > 0;
    /* L_(k-1), L_k, M_(k-1) and M_k, and what they may be off by */
    double at[4] = {0, above, 0, 0}, error[4], scale = 1;
    if (passed) {
        const double root = sqrt(span);
        off_centre_begin(A, a, root > SF_TINY_ROOT ? root : SF_TINY_ROOT, atan2(root, a), at);
    }
    for (int k = 0; k < 4; k++)
        error[k] = passed ? SF_STEP_ERROR * fabs(at[k]) : 0;
    for (int k = 0; k <= highest; k++) {
        if (k > 0 && above) {
            double next[2], raised[2];
            off_centre_up(k, A, a, span, at[0], at[1], at[2], at[3], next);
            /* the same sums of what their terms may be off by, these terms' own roundings too: nothing cancels */
            off_centre_up(k, A, -fabs(a), fabs(span), error[0] + SF_STEP_ERROR * at[0],
                          error[1] + SF_STEP_ERROR * at[1], error[2] + SF_STEP_ERROR * fabs(at[2]),
                          error[3] + SF_STEP_ERROR * at[3], raised);
            at[0] = at[1], at[1] = sfi_most(next[0], 0), error[0] = error[1], error[1] = raised[0];
            at[2] = at[3], at[3] = sfi_most(next[1], 0), error[2] = error[3], error[3] = raised[1];
        }
        for (int side = first; side <= last; side++) {
            const double off = (side ? 1 : -1) * (error[1] + error[3]) * (1 + 0x1p-40);
            const double L = scale * sfi_most(at[1] + off, 0), U = scale * sfi_most(at[1] + at[3] + off, 0),
                         V = scale * sfi_most(at[1] - at[3] + off, 0);
            if (side)
                out->L[k].hi = L, out->U[k].hi = U, out->V[k].hi = V;
            else
                out->L[k].lo = L, out->U[k].lo = U, out->V[k].lo = V;
        }
        scale *= unit;
    }
}

/* On a box: at both of its corners, the lesser with the least of either end. */
static void sf_make_ladder(sf_interval over, sf_interval under, int highest, sf_ladder *out) {
    const int point = over.lo == over.hi && under.lo == under.hi;
    sf_climb(over.lo, under.hi, highest, 0, point, out);
    if (!point)
        sf_climb(over.hi, under.lo, highest, 1, 1, out);
}

/* A weighted sum of intervals, and the size of its terms. */
typedef struct {
    double lo, hi, size;
} sf_weighted;

static inline void sf_weigh(sf_weighted *sum, double weight, sf_interval range) {
    sum->lo += weight * (weight >= 0 ? range.lo : range.hi);
    sum->hi += weight * (weight >= 0 ? range.hi : range.lo);
    sum->size += fabs(weight) * sfi_most(fabs(range.lo), fabs(range.hi));
}

/* c_0, s_0, P_1, Q_1, P_2, Q_2, c_3: P_n and Q_n are the means of f^(n) with 1 + cos psi and with 1 - cos psi, but for
 * what f and its derivatives gain at steps. */
enum { SF_C_0, SF_S_0, SF_P_1, SF_Q_1, SF_P_2, SF_Q_2, SF_C_3, SF_SUMS };

/* Adds a step with gains D to the sums. One on the left is that of -f(-u), in which 1 + cos psi and 1 - cos psi change.
 * turn: 1 for a step on the right, else what D is multiplied with there, but for odd powers with its negative; from:
 * the first power that counts */
static void sf_add_step(const double *D, int from, int right, double turn, const sf_ladder *ladder, int highest,
                        sf_weighted *sums) {
    const sf_interval *P = right ? ladder->U : ladder->V, *Q = right ? ladder->V : ladder->U;
    const double side = right ? 1 : -1;
    for (int k = from; k <= highest; k++) {
        const double gain = right || k % 2 == 0 ? turn * D[k] : -turn * D[k];
        const sf_interval M = {0.5 * (ladder->U[k].lo - ladder->V[k].hi), 0.5 * (ladder->U[k].hi - ladder->V[k].lo)};
        if (gain == 0)
            continue;
        sf_weigh(&sums[SF_C_0], side * gain, ladder->L[k]);
        sf_weigh(&sums[SF_S_0], gain, M);
        if (k >= 1)
            sf_weigh(&sums[SF_P_1], gain, P[k - 1]), sf_weigh(&sums[SF_Q_1], gain, Q[k - 1]);
        if (k >= 2)
            sf_weigh(&sums[SF_P_2], side * gain, P[k - 2]), sf_weigh(&sums[SF_Q_2], side * gain, Q[k - 2]);
        if (k >= 3)
            sf_weigh(&sums[SF_C_3], gain, ladder->L[k - 3]);
    }
}

/* The highest power that a polynomial with these derivatives has. */
static int sf_degree(const double *D, int highest) {
    while (highest > 0 && D[highest] == 0)
        highest--;
    return highest;
}

/* Adds a polynomial: what it has besides a straight line is a step on either side of u = 0, with powers of one sign. */
static void sf_add_piece(const double *D, sf_interval top, sf_interval bottom, sf_interval A, int highest,
                         sf_weighted *sums, sf_interval *straight) {
    const sf_interval down = sfi_neg(bottom), slope = sfi_point(highest > 0 ? D[1] : 0);
    const int degree = sf_degree(D, highest);
    if (degree > 1) {
        sf_ladder ladder;
        sf_make_ladder(top, down, degree, &ladder);
        sf_add_step(D, 2, 1, 1, &ladder, degree, sums);
        sf_make_ladder(down, top, degree, &ladder);
        sf_add_step(D, 2, 0, -1, &ladder, degree, sums);
    }
    straight[SF_C_0] = sfi_add(sfi_mul(sfi_times(0.5, sfi_add(top, bottom)), slope), sfi_point(D[0]));
    straight[SF_S_0] = sfi_mul(sfi_times(0.5, A), slope);
    straight[SF_P_1] = straight[SF_Q_1] = slope;
    straight[SF_P_2] = straight[SF_Q_2] = straight[SF_C_3] = sfi_point(0);
}

/* The sums of so many terms, with their roundings, and what a straight line has. */
static void sf_sum_up(const sf_weighted *sums, int terms, const sf_interval *straight, sf_interval *out) {
    for (int i = 0; i < SF_SUMS; i++) {
        const double slack = (terms + 2) * 0x1p-52 * sums[i].size + (sums[i].size > 0 ? terms * SFI_LEAST : 0);
        out[i] = sfi_add(sfi_of(sums[i].lo - slack, sums[i].hi + slack), straight[i]);
    }
}

/* ==== What the force and its slope gain at steps that are passed ================================================= */

/* One end of a motion next to a step: the root of how far it is past that, the square of this root where x = 0, X, and
 * whether x is a root. */
typedef struct {
    sf_interval root, X;
    double far;
    int rooted;
} sf_near;

/* What gains D_0 pi of f and D_1 pi of f' share in c_x and c_xx where a motion passes them, or in -c_y and -c_yy.
 * c_1 + s_1 has D_0 root_y/(root_x A), and c_1 - s_1 the inverse of that ratio; c_2 +- s_2 the same of D_1. */
static void sf_share_of_step(const sf_near *own, const sf_near *other, sf_interval A, double D_0, double D_1,
                             double sign, sf_interval *fraction, sf_interval *slope) {
    const int is_own = own->rooted && own->far == 0;
    const sf_interval X = own->X, far = sfi_point(own->rooted ? own->far : -0.25);
    sf_interval ratio = sfi_point(1), turn = sfi_point(0);
    if (!is_own) {
        /* of a root x/root rises from 0 to 1, and is 1 where the step is the chart's own; of an end 1/2 over it falls
         */
        ratio = own->rooted ? sfi_of(X.lo / sqrt(X.lo * X.lo + own->far), X.hi / sqrt(X.hi * X.hi + own->far))
                            : sfi_of(0.5 / own->root.hi, 0.5 / own->root.lo);
        ratio = sfi_of(sfi_down(sfi_down(ratio.lo)) * (1 - 0x1p-51), sfi_up(sfi_up(ratio.hi)) * (1 + 0x1p-51));
        turn = sfi_div(far, sfi_mul(sfi_square(own->root), own->root));
    }
    const sf_interval over = sfi_div(other->root, A);
    const sf_interval of_force = sfi_mul(ratio, over);
    *fraction = sfi_add(*fraction, sfi_mul(of_force, sfi_point(D_0)));
    *slope =
        sfi_add(*slope, sfi_add(sfi_mul(sfi_mul(over, sfi_sub(turn, sfi_div(sfi_mul(ratio, X), A))), sfi_point(D_0)),
                                sfi_mul(sfi_mul(X, of_force), sfi_point(2 * sign * D_1))));
}

/* What a step's gains of f, f' and f'' share in c_3 and s_2 where all of the motions pass it. One on the left is that
 * of -f(-u), of which derivatives and the cosine change their signs. */
static void sf_share_near(const double *D, int highest, int right, sf_interval over, sf_interval under,
                          sf_interval *c_3, sf_interval *s_2) {
    const sf_interval A = sfi_times(0.5, sfi_add(over, under)), a = sfi_times(0.5, sfi_sub(under, over));
    const sf_interval root = sfi_sqrt(sfi_mul(over, under)), none = sfi_point(0);
    sf_interval begin[4], down[2], last[2];
    double gain[3];
    for (int k = 0; k < 3; k++)
        gain[k] = k > highest ? 0 : right || k % 2 == 0 ? D[k] : -D[k];
    if (gain[0] == 0 && gain[1] == 0 && gain[2] == 0)
        return;
    off_centre_intervals_begin(A, a, root, none, begin);
    off_centre_intervals_down(none, A, a, root, begin[0], none, begin[2], begin[3], down);
    off_centre_intervals_down(sfi_point(-1), A, a, root, down[0], begin[0], down[1], begin[2], last);
    *c_3 = sfi_add(*c_3, sfi_add(sfi_mul(sfi_point(gain[2]), begin[0]),
                                 sfi_add(sfi_mul(sfi_point(gain[1]), down[0]), sfi_mul(sfi_point(gain[0]), last[0]))));
    *s_2 = sfi_add(*s_2, sfi_add(sfi_mul(sfi_point(gain[1]), begin[2]), sfi_mul(sfi_point(gain[0]), down[1])));
}

/* ==== On a box =================================================================================================== */

static const sf_interval sf_any_number = {-HUGE_VAL, HUGE_VAL};

/* What both hold, each being known to hold the value; an end that is not known hides no other. */
static inline sf_interval sf_both(sf_interval a, sf_interval b) { return sfi_of(fmax(a.lo, b.lo), fmin(a.hi, b.hi)); }

/* Of a polynomial with these derivatives at 0, of any signs, what its n-th one does not exceed up to a size. */
static double sf_far(const double *D, int n, int highest, double size) {
    double sum = 0, power = 1;
    for (int k = n; k <= highest; k++) {
        sum += fabs(D[k]) * power;
        power *= size / (k - n + 1);
    }
    return sum;
}

/* The share of the cycle that is not above the last step, nor below the first, at most. */
static double sf_share_inside(const sf_charts *of, sf_interval top, sf_interval bottom) {
    double inside = 1;
    for (int side = 0; side < 2; side++) {
        const double line = of->line[side ? 0 : of->lines - 1];
        const double over = side ? line - bottom.hi : top.lo - line, under = side ? top.hi - line : line - bottom.lo;
        if (over > 0)
            inside -=
                under > 0 ? sfi_most(atan2(sqrt(over * under), 0.5 * (under - over)) / SFI_PI - SF_SHARE_ERROR, 0) : 1;
    }
    return sfi_most(sfi_least(inside, 1), 0);
}

/* The sums of a motion that is large against all steps: by the last piece's odd part alone, and what the force has
 * next to it as something bounded. There steps cancel, and with them what is known of their sum. */
static void sf_sum_large(const sf_charts *of, sf_interval top, sf_interval bottom, sf_interval A, sf_interval *out) {
    const int order[SF_SUMS] = {0, 0, 1, 1, 2, 2, 2}, highest = of->highest;
    const double size = sfi_most(fabs(top.hi), fabs(bottom.lo)) * (1 + 0x1p-50);
    const double inside = sf_share_inside(of, top, bottom);
    sf_weighted sums[SF_SUMS] = {{0, 0, 0}};
    sf_interval straight[SF_SUMS];
    sf_add_piece(of->last, top, bottom, A, highest, sums, straight);
    sf_sum_up(sums, 2 * highest, straight, out);
    out[SF_C_3] = sf_any_number;
    for (int i = 0; i < SF_C_3; i++) {
        /* the mean of the weight's size, and the most that it is */
        const double mean = i == SF_S_0 ? 2 / SFI_PI : 1, most = i < SF_P_1 ? 1 : 2, outer = of->outer[order[i]];
        const double even = sf_far(of->even, order[i], highest, size);
        /* nearer, but for steps that, rounded, do not add up to the last piece: of large motions that is more */
        const double nearer = outer * sfi_least(most * inside, mean) + even * mean +
                              SF_SHARE_ERROR * sf_far(of->size, order[i], highest, size);
        const double bound = sfi_least(sfi_most(outer, even) * mean, nearer) * (1 + 0x1p-40);
        out[i] = sfi_add(out[i], sfi_of(-bound, bound));
    }
}

/* c_0 ... c_yy from the sums and shares. */
static void sf_end_up(const sf_interval *sum, const sf_interval *fraction, sf_ended *out) {
    const sf_interval s_1 = sfi_times(0.5, sfi_sub(sum[SF_P_1], sum[SF_Q_1])), bent = sfi_div(s_1, out->A);
    out->c_0 = sum[SF_C_0], out->s_0 = sum[SF_S_0], out->c_3 = sum[SF_C_3];
    out->s_2 = sfi_times(0.5, sfi_sub(sum[SF_P_2], sum[SF_Q_2]));
    out->c_x = sfi_add(sfi_mul(out->X, sum[SF_P_1]), fraction[0]);
    out->c_y = sfi_neg(sfi_add(sfi_mul(out->Y, sum[SF_Q_1]), fraction[1]));
    out->c_xx = sfi_add(
        sfi_add(sfi_mul(out->X_x, sum[SF_P_1]), sfi_mul(sfi_square(out->X), sfi_sub(sfi_times(2, sum[SF_P_2]), bent))),
        fraction[2]);
    out->c_yy = sfi_sub(
        sfi_sub(sfi_mul(sfi_square(out->Y), sfi_sub(sfi_times(2, sum[SF_Q_2]), bent)), sfi_mul(out->Y_y, sum[SF_Q_1])),
        fraction[3]);
}

/* The piece in the middle of the motion: the others are passed least. */
static int sf_middle_piece(const sf_charts *of, sf_interval top, sf_interval bottom, int chart) {
    const double at = 0.25 * (top.lo + top.hi + bottom.lo + bottom.hi);
    int piece = 0;
    while (piece < of->lines && of->line[piece] < at)
        piece++;
    if (piece < (int)of->lower[chart])
        piece = (int)of->lower[chart];
    return piece > (int)of->upper[chart] ? (int)of->upper[chart] : piece;
}

/* Where motions pass no step, x = B + A and y = A - B: the part with A >= 0. */
static inline void sf_above_diagonal(sf_interval *x, sf_interval *y) {
    const double x_lo = sfi_least(sfi_most(x->lo, -y->hi), x->hi);
    y->lo = sfi_least(sfi_most(y->lo, -x->hi), y->hi), x->lo = x_lo;
}

/* By the values at corners alone. */
static void sf_on_all(const sf_charts *of, sf_interval x, sf_interval y, int chart, sf_ended *out) {
    const int lower = (int)of->lower[chart], upper = (int)of->upper[chart], highest = of->highest;
    const int root_x = of->rooted[0][chart] != 0, root_y = of->rooted[1][chart] != 0;
    const double place_x = of->place[0][chart], place_y = of->place[1][chart];
    sf_interval sum[SF_SUMS], straight[SF_SUMS];
    sf_interval fraction[4] = {{0, 0}, {0, 0}, {0, 0}, {0, 0}};
    sf_weighted sums[SF_SUMS] = {{0, 0, 0}};
    sf_interval c_3 = {0, 0}, s_2 = {0, 0};
    if (lower == upper)
        sf_above_diagonal(&x, &y);
    const sf_interval past_x = root_x ? sfi_square(x) : x, past_y = root_y ? sfi_square(y) : y;
    const sf_interval top = sfi_add(past_x, sfi_point(place_x)), bottom = sfi_sub(sfi_point(place_y), past_y);
    out->A = sfi_times(0.5, sfi_add(sfi_add(past_x, past_y), sfi_sub(sfi_point(place_x), sfi_point(place_y))));
    out->B = sfi_times(0.5, sfi_add(top, bottom));
    const int nowhere = out->A.hi < 0;
    const int outer = out->B.lo <= 0 && out->B.hi >= 0; /* elsewhere nobody asks for c_3 and s_2 */
    out->A = sfi_of(sfi_most(out->A.lo, 0), sfi_most(out->A.hi, 0));
    out->X = root_x ? x : sfi_point(0.5), out->X_x = sfi_point(root_x);
    out->Y = root_y ? y : sfi_point(0.5), out->Y_y = sfi_point(root_y);

    const int base = sf_middle_piece(of, top, bottom, chart);
    sf_add_piece(of->piece + base * (highest + 1), top, bottom, out->A, highest, sums, straight);
    for (int line = lower; line < upper; line++) {
        const double *gain = of->gain + line * (highest + 1);
        const double beyond_x = place_x - of->line[line], beyond_y = of->line[line] - place_y;
        /* from the coordinates themselves: exact where a step is near */
        const sf_interval above = sfi_add(past_x, sfi_point(beyond_x)), below = sfi_add(past_y, sfi_point(beyond_y));
        const sf_interval over = sfi_of(sfi_most(above.lo, 0), sfi_most(above.hi, 0));
        const sf_interval under = sfi_of(sfi_most(below.lo, 0), sfi_most(below.hi, 0));
        const int right = line >= base;
        sf_ladder ladder;
        sf_make_ladder(right ? over : under, right ? under : over, highest, &ladder);
        sf_add_step(gain, 0, right, 1, &ladder, highest, sums);
        if (outer)
            sf_share_near(gain, highest, right, right ? above : below, right ? below : above, &c_3, &s_2);
        if (gain[0] != 0 || (highest > 0 && gain[1] != 0)) {
            const double D_0 = gain[0] / SFI_PI, D_1 = (highest > 0 ? gain[1] : 0) / SFI_PI;
            const sf_near at_x = {sfi_sqrt(over), out->X, beyond_x, root_x},
                          at_y = {sfi_sqrt(under), out->Y, beyond_y, root_y};
            sf_share_of_step(&at_x, &at_y, out->A, D_0, D_1, 1, &fraction[0], &fraction[2]);
            sf_share_of_step(&at_y, &at_x, out->A, D_0, D_1, -1, &fraction[1], &fraction[3]);
        }
    }
    for (int i = 0; i < 4; i++) /* the factor 1/pi is rounded */
        fraction[i] = sfi_of(sfi_down(sfi_down(fraction[i].lo)), sfi_up(sfi_up(fraction[i].hi)));
    sf_sum_up(sums, (highest + 1) * (upper - lower + 2), straight, sum);
    for (int i = 0; nowhere && i < SF_SUMS; i++)
        sum[i] = sf_any_number;
    sf_end_up(sum, fraction, out);
    out->c_3 = outer ? sfi_add(out->c_3, c_3) : sf_any_number;
    out->s_2 = outer ? sfi_add(out->s_2, s_2) : sf_any_number;
    if (out->A.lo > of->large) {
        sf_ended nearer = *out;
        sf_sum_large(of, top, bottom, out->A, sum);
        sf_end_up(sum, fraction, &nearer);
        out->c_0 = sf_both(out->c_0, nearer.c_0), out->s_0 = sf_both(out->s_0, nearer.s_0);
        out->c_x = sf_both(out->c_x, nearer.c_x), out->c_y = sf_both(out->c_y, nearer.c_y);
        out->c_xx = sf_both(out->c_xx, nearer.c_xx), out->c_yy = sf_both(out->c_yy, nearer.c_yy);
    }
}

/* A value next to the middle of a box, by its slopes on all of it. */
static sf_interval sf_from_middle(sf_interval middle, sf_interval by_x, sf_interval r_x, sf_interval by_y,
                                  sf_interval r_y) {
    return sfi_add(middle, sfi_add(sfi_mul(by_x, r_x), sfi_mul(by_y, r_y)));
}

/* The same by what is known in the middle: off by the square of the box, where pieces and steps cancel. */
static void sf_tighten(const sf_ended *middle, sf_interval r_x, sf_interval r_y, sf_ended *out) {
    sf_interval slopes[3];
    off_centre_intervals_ended_slopes(out->A, out->s_0, out->c_x, out->c_y, out->X, out->Y, slopes);
    out->c_x = sf_both(out->c_x, sf_from_middle(middle->c_x, out->c_xx, r_x, slopes[2], r_y));
    out->c_y = sf_both(out->c_y, sf_from_middle(middle->c_y, slopes[2], r_x, out->c_yy, r_y));
    off_centre_intervals_ended_slopes(out->A, out->s_0, out->c_x, out->c_y, out->X, out->Y, slopes);
    out->c_0 = sf_both(out->c_0, sf_from_middle(middle->c_0, out->c_x, r_x, out->c_y, r_y));
    out->s_0 = sf_both(out->s_0, sf_from_middle(middle->s_0, slopes[0], r_x, slopes[1], r_y));
}

/* On a box within the limits of its chart, and at a point of it: of a box that touches A = 0 the part in which A is not
 * negative. Where `load` is a number that <f> is not, nothing else is made tighter. */
static void sf_on_ends(const sf_charts *of, const double *low, const double *at, const double *high, int chart,
                       double load, sf_ended *out, sf_ended *middle) {
    const sf_interval x = {low[0], high[0]}, y = {low[1], high[1]};
    sf_on_all(of, x, y, chart, out);
    *middle = *out;
    if ((x.lo == x.hi && y.lo == y.hi) || sfi_has_sign(sfi_sub(out->c_0, sfi_point(load))))
        return;
    sf_on_all(of, sfi_point(at[0]), sfi_point(at[1]), chart, middle);
    if (middle->A.lo > 0)
        sf_tighten(middle, sfi_sub(x, sfi_point(at[0])), sfi_sub(y, sfi_point(at[1])), out);
}
