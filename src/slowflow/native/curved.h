/* Means over a cycle of what a force has beside its steps, r = f - steps, where that is no polynomial. Takes its pieces
 * as straight lines (straight.h); returns moments <r^(n) cos^p psi> along u = B + A cos psi: values, and intervals that
 * hold them on boxes of both ends of the motion, B + A and B - A.
 *
 * r' is continuous (derivations/asymmetric/curved.py): moments of r and r' have slopes without terms from moving
 * angles, and those of r'' only where r'' jumps.
 *
 * Values are sums by Gauss's rule between the angles at which the motion passes an end, on 2, 4, 8, ... panels until
 * twice as many change nothing. On a box the force and its derivatives are evaluated on intervals of u, panel by panel
 * of the angle. That alone would be off by the width of the panels: a moment is its value in the middle of the box and
 * what its slopes, held on all of the box, can change it by. So it is held the better the smaller the box, by the
 * square of that.
 */
#pragma once

#include "program.h"
#include "turning_points.h"

enum {
    SF_CURVED_NODES = 16,   /* of Gauss's rule on a panel */
    SF_CURVED_PANELS = 256, /* between two ends, at most */
    SF_BOX_PANELS = 40,     /* of the angle on boxes */
    SF_MOST_CURVED = 2 * SF_MOST_BREAKS + 1,
    SF_CURVED_ORDERS = 4, /* r and three derivatives */
    SF_CURVED_POWERS = 3
};

/* by how much sums on twice as many panels may differ, and sums err, of the integral of the size */
#define SF_SUMS_AGREE 0x1p-46
#define SF_SUMS_ERROR 0x1p-46

/* Means over each panel of (1 + cos)^i (1 - cos)^j, of the cosine, and of its products with 1 + cos and 1 - cos: one
 * sign on each panel. */
enum {
    SF_WEIGHT_30,
    SF_WEIGHT_21,
    SF_WEIGHT_12,
    SF_WEIGHT_03,
    SF_WEIGHT_20,
    SF_WEIGHT_11,
    SF_WEIGHT_02,
    SF_WEIGHT_10,
    SF_WEIGHT_01,
    SF_WEIGHT_00,
    SF_WEIGHT_COSINE,
    SF_WEIGHT_UP,
    SF_WEIGHT_DOWN,
    SF_WEIGHTS
};

/* A piece: what the steps are on it, a + b u; whether its lines are those of -f(-u); f and derivatives in doubles, and
 * f to f''' on intervals. */
typedef struct {
    const double *steps;
    int mirrored;
    sf_straight at, on;
} sf_curved_piece;

/* end, bend -- where each piece but the last ends, and what f'' gains there; wall -- the u that no motion passes, below
 * and above; cosine, over_panels -- at the edges of the panels, and on them; edge, segment -- of narrow segments of u
 * the ends, and what r and three derivatives are not below on them, with a minus, and not above */
typedef struct {
    int pieces, orders, enclosed, segments;
    const double *edge, *segment, *end, *bend, *wall, *node, *weight, *cosine, *over_panels[SF_WEIGHTS];
    sf_curved_piece piece[SF_MOST_CURVED];
    sf_reader reader;
} sf_curved;

static void sf_leave_curved(sf_curved *of) { sf_leave_room(&of->reader); }

static const double *sf_take(const double **next, ptrdiff_t n) {
    const double *const found = *next;
    *next += n;
    return found;
}

/* The same in one array: how many pieces, derivatives, whether intervals are known, how many integers and segments;
 * then what is pointed to, in that order, the integers and the numbers of lines. 0 where it is none; leaves room to be
 * freed.
 */
static int sf_read_curved(const double *packed, ptrdiff_t n, sf_curved *of) {
    const double *next = packed + 5;
    memset(&of->reader, 0, sizeof of->reader);
    if (n < 5 || !(packed[0] >= 1 && packed[0] <= SF_MOST_CURVED && packed[1] >= 1 && packed[1] <= SF_CURVED_ORDERS &&
                   packed[3] >= 0 && packed[3] < n && packed[4] >= 0 && packed[4] < n))
        return 0;
    of->pieces = (int)packed[0], of->orders = (int)packed[1], of->enclosed = packed[2] != 0,
    of->segments = (int)packed[4];
    const ptrdiff_t pieces = of->pieces, integers = (ptrdiff_t)packed[3];
    if (n < 6 + (1 + 2 * SF_CURVED_ORDERS) * of->segments + 5 * pieces + 2 * SF_CURVED_NODES + 1 +
                (1 + SF_WEIGHTS) * SF_BOX_PANELS + integers)
        return 0;
    of->edge = sf_take(&next, of->segments + 1), of->segment = sf_take(&next, 2 * SF_CURVED_ORDERS * of->segments);
    of->end = sf_take(&next, pieces - 1), of->bend = sf_take(&next, pieces - 1), of->wall = sf_take(&next, 2);
    for (int i = 0; i < pieces; i++)
        of->piece[i].steps = sf_take(&next, 2), of->piece[i].mirrored = *sf_take(&next, 1) != 0;
    of->node = sf_take(&next, SF_CURVED_NODES), of->weight = sf_take(&next, SF_CURVED_NODES);
    of->cosine = sf_take(&next, SF_BOX_PANELS + 1);
    for (int k = 0; k < SF_WEIGHTS; k++)
        of->over_panels[k] = sf_take(&next, SF_BOX_PANELS);
    int *const word = sf_room_for(&of->reader, (int)integers + 1, sizeof *word);
    if (word == NULL)
        return 0;
    for (ptrdiff_t i = 0; i < integers; i++)
        word[i] = (int)*sf_take(&next, 1);
    of->reader.word = word, of->reader.last_word = word + integers;
    of->reader.number = next, of->reader.last_number = packed + n;
    for (int i = 0; i < pieces; i++) {
        sf_read_straight(&of->reader, sf_in_doubles, 1, of->orders, &of->piece[i].at);
        if (of->enclosed)
            sf_read_straight(&of->reader, sf_on_intervals, 1, SF_CURVED_ORDERS, &of->piece[i].on);
    }
    return of->reader.status == SF_READ;
}

static double sf_curved_edge(const sf_curved *of, int number) {
    return number < 0 ? -HUGE_VAL : number < of->pieces - 1 ? of->end[number] : HUGE_VAL;
}

/* ==== Numbers ===================================================================================================== */

/* <r^(n) cos^p>, and the means of what r^(n) is rounded by */
typedef struct {
    double value[SF_CURVED_ORDERS][SF_CURVED_POWERS], size[SF_CURVED_ORDERS];
} sf_moments;

/* The angles from low to high of a motion, on one piece. */
typedef struct {
    double A, B, low, high;
    int piece;
} sf_swing;

static void sf_add_moments(const sf_moments *more, int highest, sf_moments *out) {
    for (int n = 0; n <= highest; n++) {
        out->size[n] += more->size[n];
        for (int p = 0; p < SF_CURVED_POWERS; p++)
            out->value[n][p] += more->value[n][p];
    }
}

/* Up to r^(highest), by so many panels, summed each by itself: so few roundings enter. They are dense next to both
 * ends, in the third power. */
static void sf_sum_panels(const sf_curved *of, const sf_swing *on, int highest, int panels, sf_lanes *lanes,
                          sf_moments *out) {
    const sf_curved_piece *piece = &of->piece[on->piece];
    const double least = sf_curved_edge(of, on->piece - 1), most = sf_curved_edge(of, on->piece);
    const double far = fabs(on->A) + fabs(on->B), a = piece->steps[0], b = piece->steps[1], span = on->high - on->low;
    memset(out, 0, sizeof *out);
    for (int panel = 0; panel < panels; panel++) {
        double u[SF_CURVED_NODES], cosine[SF_CURVED_NODES], w[SF_CURVED_NODES];
        double values[SF_CURVED_ORDERS][SF_CURVED_NODES];
        sf_moments of_panel = {0};
        for (int j = 0; j < SF_CURVED_NODES; j++) {
            const double x = (panel + of->node[j]) / panels, inside = x * (1 - x);
            cosine[j] = cos(on->low + span * (x * x * x * (10 - 15 * x + 6 * x * x)));
            w[j] = span * of->weight[j] / (panels * SFI_PI) * 30 * (inside * inside);
            u[j] = fmin(fmax(on->B + on->A * cosine[j], least), most) * (piece->mirrored ? -1 : 1);
        }
        for (int j = 0; j < SF_CURVED_NODES; j += SF_LANES) {
            const double *const at[] = {u + j};
            sf_abreast(lanes, &piece->at, 1, SF_LANES, at, NULL, &values[0][j], SF_CURVED_NODES, 1);
        }
        for (int j = 0; j < SF_CURVED_NODES; j++) {
            double size[SF_CURVED_ORDERS + 1] = {0};
            for (int n = 0; n < of->orders; n++)
                size[n] = fabs(values[n][j]);
            size[0] += fabs(a) + fabs(b * u[j]), size[1] += fabs(b);
            for (int n = 0; n <= highest; n++) {
                const double sign = piece->mirrored && n % 2 == 0 ? -1 : 1, x = piece->mirrored ? -u[j] : u[j];
                double term = w[j] * (sign * values[n][j] - (n == 0 ? a + b * x : n == 1 ? b : 0));
                for (int p = 0; p < SF_CURVED_POWERS; p++, term *= cosine[j])
                    of_panel.value[n][p] += term;
                of_panel.size[n] += w[j] * (size[n] + (n + 1 < of->orders ? far * size[n + 1] : 0));
            }
        }
        sf_add_moments(&of_panel, highest, out);
    }
}

/* Until twice as many panels change no sum by more than rounding; NaN where they do not settle. A third derivative is
 * as near as sums of the others require. */
static void sf_settle_panels(const sf_curved *of, const sf_swing *on, int highest, sf_lanes *lanes, sf_moments *out) {
    sf_moments last;
    for (int panels = 2, known = 1; known && panels <= SF_CURVED_PANELS; panels *= 2) {
        int agree = panels > 2;
        sf_sum_panels(of, on, highest, panels, lanes, out);
        for (int n = 0; n <= highest; n++) {
            known = known && isfinite(out->size[n]);
            for (int p = 0; n < 3 && p < SF_CURVED_POWERS && panels > 2; p++)
                agree = agree && fabs(out->value[n][p] - last.value[n][p]) <= SF_SUMS_AGREE * out->size[n];
        }
        if (agree)
            return;
        last = *out;
    }
    for (int n = 0; n <= highest; n++) {
        out->size[n] = NAN;
        for (int p = 0; p < SF_CURVED_POWERS; p++)
            out->value[n][p] = NAN;
    }
}

/* The angle at which a motion passes a place. */
static double sf_angle_at(double A, double a) {
    return a >= A ? 0 : a <= -A ? SFI_PI : atan2(sqrt((A - a) * (A + a)), a);
}

/* All moments up to r^(highest). A motion with a negative A is one turned by half; one that passes a wall has none. */
static void sf_curved_moments(const sf_curved *of, double A, double B, int highest, sf_moments *out) {
    const double size = fabs(A);
    const int within = B - size > of->wall[0] && B + size < of->wall[1];
    sf_lanes lanes;
    sf_swing on = {size, B, 0, SFI_PI, 0};
    int is_past = 0; /* whether u = 0 is, about which a force acts that is small beside the motion */
    lanes.holds = NULL;
    memset(out, 0, sizeof *out);
    while (on.piece < of->pieces) {
        const double end = sf_curved_edge(of, on.piece), start = sf_curved_edge(of, on.piece - 1);
        const int cut = !is_past && start < 0 && end > 0;
        sf_moments found;
        is_past |= cut;
        on.low = isinf(end) && !cut ? 0 : sf_angle_at(size, (cut ? 0 : end) - B);
        if (within && on.high > on.low) {
            sf_settle_panels(of, &on, highest, &lanes, &found);
            sf_add_moments(&found, highest, out);
        }
        on.high = on.low, on.piece += !cut;
    }
    for (int n = 0; n <= highest; n++)
        for (int p = 0; p < SF_CURVED_POWERS; p++)
            out->value[n][p] = !within ? NAN : A < 0 && p % 2 ? -out->value[n][p] : out->value[n][p];
}

/* c_n and s_n up to n = orders: where r'' jumps c_3 and s_3 have what that adds. */
static void sf_curved_means(const sf_curved *of, double A, double B, int orders, double *c, double *s) {
    sf_moments found;
    sf_curved_moments(of, A, B, orders, &found);
    for (int n = 0; n <= orders; n++)
        c[n] = found.value[n][0], s[n] = found.value[n][1];
    for (int i = 0; orders > 2 && i < of->pieces - 1; i++) {
        const double a = of->end[i] - B, root = sqrt((A - a) * (A + a));
        if (of->bend[i] != 0 && fabs(a) < A)
            c[3] += of->bend[i] / (SFI_PI * root), s[3] += of->bend[i] * a / (SFI_PI * A * root);
    }
}

/* ==== On boxes ==================================================================================================== */

/* c_0, s_0, c_1 +- s_1, moments of r'' with (1 + cos)^2, (1 - cos)^2 and both, c_3 and s_2; of s_0 what it varies with
 * either end by, twice */
typedef struct {
    sf_interval c_0, s_0, P_1, Q_1, P_P, Q_Q, P_Q, c_3, s_2, by_top, by_bottom;
} sf_remainder;

static sf_interval sf_about(double value, double error) {
    return isnan(value + error) ? sf_any_number : sfi_of(value - error, value + error);
}

/* In the middle. */
static sf_remainder sf_remainder_at(const sf_moments *at) {
    const double *const r = at->value[0], *const first = at->value[1], *const second = at->value[2];
    const double doubt[3] = {SF_SUMS_ERROR * at->size[0], 2 * SF_SUMS_ERROR * at->size[1],
                             4 * SF_SUMS_ERROR * at->size[2]};
    return (sf_remainder){sf_about(r[0], doubt[0]),
                          sf_about(r[1], doubt[0]),
                          sf_about(first[0] + first[1], doubt[1]),
                          sf_about(first[0] - first[1], doubt[1]),
                          sf_about(second[0] + 2 * second[1] + second[2], doubt[2]),
                          sf_about(second[0] - 2 * second[1] + second[2], doubt[2]),
                          sf_about(second[0] - second[2], doubt[2]),
                          sf_any_number,
                          sf_any_number,
                          sf_any_number,
                          sf_any_number};
}

/* Narrows what is known of r and three derivatives on a panel by what is known of all segments in between: where
 * these are far apart a formula by itself may say next to nothing, as u^3/(1 + u^2) about 0. */
static void sf_by_segments(const sf_curved *of, double low, double high, int k, sf_interval out[][SF_BOX_PANELS]) {
    int first = 0, beyond = of->segments;
    if (!(of->edge[0] <= low && high <= of->edge[of->segments]))
        return;
    for (int last = of->segments; last - first > 1;) {
        const int middle = (first + last) / 2;
        *(of->edge[middle] <= low ? &first : &last) = middle;
    }
    for (beyond = first + 1; of->edge[beyond] < high; beyond++)
        ;
    double most[2 * SF_CURVED_ORDERS];
    memcpy(most, of->segment + 2 * SF_CURVED_ORDERS * first, sizeof most);
    for (int i = first + 1; i < beyond; i++)
        for (int j = 0; j < 2 * SF_CURVED_ORDERS; j++) {
            const double one = of->segment[2 * SF_CURVED_ORDERS * i + j];
            most[j] = one > most[j] ? one : most[j];
        }
    for (int n = 0; n < SF_CURVED_ORDERS; n++)
        out[n][k] = sf_both(out[n][k], sfi_of(-most[2 * n], most[2 * n + 1]));
}

/* What holds r and three derivatives between so many places. */
static void sf_curved_between(const sf_curved *of, int n, const double *low, const double *high,
                              sf_interval out[][SF_BOX_PANELS]) {
    sf_interval x[SF_MOST_REGISTERS];
    for (int order = 0; order < SF_CURVED_ORDERS; order++)
        for (int k = 0; k < n; k++)
            out[order][k] = sfi_of(HUGE_VAL, -HUGE_VAL);
    for (int i = 0; i < of->pieces; i++) {
        const sf_curved_piece *piece = &of->piece[i];
        const double start = sf_curved_edge(of, i - 1), end = sf_curved_edge(of, i);
        sf_fill_both(&piece->on, x);
        for (int k = 0; k < n; k++) {
            const sf_interval u = {fmax(low[k], start), fmin(high[k], end)};
            if (u.lo > u.hi)
                continue;
            x[0] = piece->mirrored ? sfi_neg(u) : u;
            sf_run_on_intervals(&piece->on, x);
            for (int order = 0; order < SF_CURVED_ORDERS; order++) {
                sf_interval one = x[piece->on.output[order]];
                if (piece->mirrored && order % 2 == 0)
                    one = sfi_neg(one);
                if (order == 0)
                    one = sfi_sub(one, sfi_add(sfi_mul(sfi_point(piece->steps[1]), u), sfi_point(piece->steps[0])));
                if (order == 1)
                    one = sfi_sub(one, sfi_point(piece->steps[1]));
                /* what is not known of one piece is not known at all */
                out[order][k].lo = isnan(one.lo) ? -HUGE_VAL : fmin(out[order][k].lo, one.lo);
                out[order][k].hi = isnan(one.hi) ? HUGE_VAL : fmax(out[order][k].hi, one.hi);
            }
        }
    }
}

/* What holds them on each panel: u rises with both ends, so that it is between those of its edges. */
static void sf_curved_on_panels(const sf_curved *of, sf_interval top, sf_interval bottom,
                                sf_interval out[][SF_BOX_PANELS]) {
    double ends[2][SF_BOX_PANELS + 1], low[SF_BOX_PANELS], high[SF_BOX_PANELS];
    for (int k = 0; k <= SF_BOX_PANELS; k++) {
        const double fraction = 0.5 * (1 + of->cosine[k]);
        ends[0][k] = top.lo * fraction + bottom.lo * (1 - fraction);
        ends[1][k] = top.hi * fraction + bottom.hi * (1 - fraction);
    }
    for (int k = 0; k < SF_BOX_PANELS; k++) {
        low[k] = fmin(ends[0][k], ends[0][k + 1]), high[k] = fmax(ends[1][k], ends[1][k + 1]);
        low[k] -= 0x1p-50 * fabs(low[k]), high[k] += 0x1p-50 * fabs(high[k]);
    }
    sf_curved_between(of, SF_BOX_PANELS, low, high, out);
    for (int k = 0; of->segments > 0 && k < SF_BOX_PANELS; k++)
        sf_by_segments(of, low[k], high[k], k, out);
}

/* The mean over the cycle of what is held on each panel. Either end has its own roundings: next to a wall the upper one
 * may be large. */
static sf_interval sf_mean_of_panels(const sf_curved *of, const sf_interval *values, int weights) {
    double total[2] = {0, 0}, size[2] = {0, 0};
    for (int k = 0; k < SF_BOX_PANELS; k++) {
        const double w = of->over_panels[weights][k], low = w * values[k].lo, high = w * values[k].hi;
        total[w < 0] += low, size[w < 0] += fabs(low);
        total[w >= 0] += high, size[w >= 0] += fabs(high);
    }
    for (int i = 0; i < 2; i++)
        total[i] += isfinite(total[i]) ? (i ? 0x1p-48 : -0x1p-48) * size[i] : 0;
    return sfi_of(total[0], total[1]);
}

/* A value next to the middle, by what it varies with either end by, twice, which is held. */
static sf_interval sf_near_middle(sf_interval value, sf_interval by_top, sf_interval by_bottom, const double *radius) {
    const double change =
        0.5 * (sf_magnitude(by_top) * radius[0] + sf_magnitude(by_bottom) * radius[1]) * (1 + 0x1p-48);
    return isnan(change) ? sf_any_number : sfi_of(value.lo - change, value.hi + change);
}

/* pi times the mean of (1 + cos)^i (1 - cos)^(2 - i) over the part of a cycle in which u is beyond an end: it rises
 * with both ends of the motion, with any weight. */
static double sf_mean_beyond(double end, double top, double bottom, int i) {
    const double over = top - end, under = end - bottom;
    const double angle = over <= 0 ? 0 : under <= 0 ? SFI_PI : atan2(sqrt(fmax(over * under, 0)), 0.5 * (under - over));
    const double sine = sin(angle), square = 0.5 * (angle + sine * cos(angle));
    return angle + (i - 1) * 2 * sine + (i == 1 ? -square : square);
}

/* What jumps of r'' move its moment by between the middle of a box and elsewhere on it. */
static sf_interval sf_jumps(const sf_curved *of, sf_interval top, sf_interval bottom, const double *middle, int i) {
    sf_interval sum = {0, 0};
    for (int k = 0; k < of->pieces - 1; k++) {
        const double end = of->end[k], bend = of->bend[k] / SFI_PI, slack = 0x1p-46 * fabs(bend) * SFI_PI;
        if (bend == 0)
            continue;
        const double here = sf_mean_beyond(end, middle[0], middle[1], i);
        const double one = bend * (sf_mean_beyond(end, top.lo, bottom.lo, i) - here);
        const double other = bend * (sf_mean_beyond(end, top.hi, bottom.hi, i) - here);
        sum = sfi_add(sum, sfi_of(fmin(one, other) - slack, fmax(one, other) + slack));
    }
    return sum;
}

/* On a box around a motion whose ends are in `middle`, of which the moments are known. */
static void sf_remainder_on(const sf_curved *of, const sf_remainder *at, const double *middle, sf_interval top,
                            sf_interval bottom, sf_remainder *out) {
    const double radius[2] = {fmax(top.hi - middle[0], middle[0] - top.lo) * (1 + 0x1p-50),
                              fmax(bottom.hi - middle[1], middle[1] - bottom.lo) * (1 + 0x1p-50)};
    sf_interval r[SF_CURVED_ORDERS][SF_BOX_PANELS], third[4];
    sf_interval *const squares[3] = {&out->P_P, &out->P_Q, &out->Q_Q};
    const sf_interval nearly[3] = {at->P_P, at->P_Q, at->Q_Q};
    if (!(radius[0] > 0 || radius[1] > 0)) {
        *out = *at;
        return;
    }
    sf_curved_on_panels(of, top, bottom, r);
    for (int k = 0; k < 4; k++)
        third[k] = sf_mean_of_panels(of, r[3], SF_WEIGHT_30 + k);
    for (int k = 0; k < 3; k++)
        *squares[k] = sf_both(sf_mean_of_panels(of, r[2], SF_WEIGHT_20 + k),
                              sfi_add(sf_near_middle(nearly[k], third[k], third[k + 1], radius),
                                      sf_jumps(of, top, bottom, middle, 2 - k)));
    out->P_1 = sf_both(sf_mean_of_panels(of, r[1], SF_WEIGHT_10), sf_near_middle(at->P_1, out->P_P, out->P_Q, radius));
    out->Q_1 = sf_both(sf_mean_of_panels(of, r[1], SF_WEIGHT_01), sf_near_middle(at->Q_1, out->P_Q, out->Q_Q, radius));
    out->by_top = sf_mean_of_panels(of, r[1], SF_WEIGHT_UP),
    out->by_bottom = sf_mean_of_panels(of, r[1], SF_WEIGHT_DOWN);
    out->c_0 = sf_both(sf_mean_of_panels(of, r[0], SF_WEIGHT_00), sf_near_middle(at->c_0, out->P_1, out->Q_1, radius));
    out->s_0 = sf_both(sf_mean_of_panels(of, r[0], SF_WEIGHT_COSINE),
                       sf_near_middle(at->s_0, out->by_top, out->by_bottom, radius));
    out->c_3 = sf_mean_of_panels(of, r[3], SF_WEIGHT_00), out->s_2 = sf_mean_of_panels(of, r[2], SF_WEIGHT_COSINE);
    for (int k = 0; k < of->pieces - 1; k++) /* where r'' jumps within a motion the mean of its slope has no bound */
        if (of->bend[k] != 0 && bottom.lo <= of->end[k] && of->end[k] <= top.hi)
            out->c_3 = sf_any_number;
}

static void sf_add_remainder(const sf_remainder *of, sf_ended *out) {
    const sf_interval X_X = sfi_square(out->X), Y_Y = sfi_square(out->Y);
    out->c_0 = sfi_add(out->c_0, of->c_0), out->s_0 = sfi_add(out->s_0, of->s_0);
    out->c_x = sfi_add(out->c_x, sfi_mul(out->X, of->P_1)), out->c_y = sfi_sub(out->c_y, sfi_mul(out->Y, of->Q_1));
    out->c_xx = sfi_add(out->c_xx, sfi_add(sfi_mul(out->X_x, of->P_1), sfi_mul(X_X, of->P_P)));
    out->c_yy = sfi_add(out->c_yy, sfi_sub(sfi_mul(Y_Y, of->Q_Q), sfi_mul(out->Y_y, of->Q_1)));
    out->c_3 = sfi_add(out->c_3, of->c_3), out->s_2 = sfi_add(out->s_2, of->s_2);
}

/* Both ends of the motions on a box in a chart. */
static void sf_ends_of(const sf_charts *of, int chart, sf_interval x, sf_interval y, sf_interval *top,
                       sf_interval *bottom) {
    if (of->lower[chart] == of->upper[chart])
        sf_above_diagonal(&x, &y);
    *top = sfi_add(of->rooted[0][chart] != 0 ? sfi_square(x) : x, sfi_point(of->place[0][chart]));
    *bottom = sfi_sub(sfi_point(of->place[1][chart]), of->rooted[1][chart] != 0 ? sfi_square(y) : y);
}

static inline double sf_width(sf_interval of) { return of.hi - of.lo; }

/* Adds the remainder to what is known on a box, and in its middle. */
static void sf_add_curved(const sf_curved *of, const sf_charts *charts, int chart, const double *low, const double *at,
                          const double *high, sf_ended *here, sf_ended *middle) {
    sf_interval top, bottom, top_at, bottom_at;
    sf_remainder near, whole, inside;
    sf_moments moments;
    sf_ends_of(charts, chart, sfi_of(low[0], high[0]), sfi_of(low[1], high[1]), &top, &bottom);
    sf_ends_of(charts, chart, sfi_point(at[0]), sfi_point(at[1]), &top_at, &bottom_at);
    const double ends[2] = {0.5 * (top_at.lo + top_at.hi), 0.5 * (bottom_at.lo + bottom_at.hi)};
    sf_curved_moments(of, 0.5 * (ends[0] - ends[1]), 0.5 * (ends[0] + ends[1]), 2, &moments);
    near = sf_remainder_at(&moments);
    sf_remainder_on(of, &near, ends, top, bottom, &whole);
    /* the middle is off `ends` by rounding: by what slopes on the box bound, or where these are large those next to it
     */
    const double radius[2] = {top_at.hi - top_at.lo, bottom_at.hi - bottom_at.lo};
    inside = whole;
    inside.c_0 = sf_both(whole.c_0, sf_near_middle(near.c_0, whole.P_1, whole.Q_1, radius));
    inside.s_0 = sf_both(whole.s_0, sf_near_middle(near.s_0, whole.by_top, whole.by_bottom, radius));
    inside.P_1 = sf_both(whole.P_1, sf_near_middle(near.P_1, whole.P_P, whole.P_Q, radius));
    inside.Q_1 = sf_both(whole.Q_1, sf_near_middle(near.Q_1, whole.P_Q, whole.Q_Q, radius));
    const double nearly[2] = {2 * sf_width(near.P_1), 2 * sf_width(near.Q_1)};
    if (!(sf_width(inside.P_1) <= nearly[0] && sf_width(inside.Q_1) <= nearly[1]))
        sf_remainder_on(of, &near, ends, top_at, bottom_at, &inside);
    sf_add_remainder(&whole, here), sf_add_remainder(&inside, middle);
}
