/* The second approximation's curve. Takes points of the first one's; returns those that they move to.
 *
 * Each point takes the shortest way. The distance counts ln A, R/F_0, in which the curve keeps away from itself however
 * sharp its peak is over Omega, and ln Omega, for where R hardly depends on that. What is no small correction is left
 * out. The balance is generated.
 *
 * A way is smooth along the curve: every sixteenth point goes its own, those between start from where they are
 * expected.
 */
#pragma once

#include "curve.h"
#include "second_newton.h"

enum {
    SF_APART = 16,   /* points from one that goes its own way to the next */
    SF_AROUND_B = 36 /* points around a breakpoint */
};

/* changes between points that went their own way, as many as what is looked for is away where it is not between them */
#define SF_AWAY 2.

/* ==== From the first approximation's points ======================================================================= */

/* The first approximation's points; h and R there, and how far along its stretch each lies. */
typedef struct {
    long n;
    const double *Omega, *A;
    const long long *branch;
    double *h, *R, *arc;
} sf_first;

/* Where a point's stretch ends, along which the ways are smooth: with its branch, or a piece of the force. */
static long sf_stretch_end(const sf_model *model, const sf_first *first, long from) {
    long i;
    for (i = from + 1; i < first->n && first->branch[i] == first->branch[from]; i++)
        for (int k = 0; k < model->breaks; k++)
            if ((first->A[i] > model->b[k]) != (first->A[from] > model->b[k]))
                return i;
    return i;
}

static int sf_is_settled(const sf_second *second, const sf_solved *solved, long i) {
    return solved->step[i] >= 0 &&
           solved->step[i] <= SF_MOVED + SF_ROUNDING * solved->A[i] * solved->Omega[i] * solved->Omega[i] / second->F_0;
}

/* The point of a stretch that goes its own way, by its number: the last one is the stretch's end. */
static inline long sf_anchor(long from, long to, long k) {
    return from + k * SF_APART < to - 1 ? from + k * SF_APART : to - 1;
}

/* Whether neighbours that went their own way ended apart as they were: elsewhere ways cross, as next to a tip. */
static int sf_are_parallel(const sf_second *second, const sf_first *first, const sf_solved *solved, long a, long b) {
    const double x = solved->A[b] / first->A[b] - solved->A[a] / first->A[a];
    const double y = ((solved->R[b] - first->R[b]) - (solved->R[a] - first->R[a])) / second->F_0;
    const double z = SF_WEIGHT * (solved->Omega[b] / first->Omega[b] - solved->Omega[a] / first->Omega[a]);
    return sf_is_settled(second, solved, a) && sf_is_settled(second, solved, b) &&
           sqrt(x * x + y * y + z * z) < 0.5 * (first->arc[b] - first->arc[a]);
}

/* The four points nearest to a gap that went their own way: how far along they lie, where each went to from where, and
 * the factors of their weights. */
typedef struct {
    double arc[4], Omega[4], A[4], R[4], factor[4];
} sf_stencil;

/* 0 where the points between cannot be interpolated from them. */
static int sf_take_stencil(const sf_second *second, const sf_first *first, const sf_solved *solved, const long own[4],
                           sf_stencil *stencil) {
    for (int j = 0; j < 3; j++)
        if (!sf_are_parallel(second, first, solved, own[j], own[j + 1]))
            return 0;
    for (int j = 0; j < 4; j++) {
        double apart = 1;
        for (int k = 0; k < 4; k++)
            if (k != j)
                apart *= first->arc[own[j]] - first->arc[own[k]];
        stencil->arc[j] = first->arc[own[j]], stencil->factor[j] = 1 / apart;
        stencil->Omega[j] = solved->Omega[own[j]] / first->Omega[own[j]];
        stencil->A[j] = solved->A[own[j]] / first->A[own[j]];
        stencil->R[j] = solved->R[own[j]] - first->R[own[j]];
    }
    return 1;
}

/* Where the points of a gap are expected, from..from + n; a loop that vectorises. */
static void sf_expected(const sf_first *first, const sf_stencil *stencil, long from, int n, double *restrict Omega,
                        double *restrict A, double *restrict R) {
    const double *restrict far = first->arc + from, *restrict first_Omega = first->Omega + from;
    const double *restrict first_A = first->A + from, *restrict first_R = first->R + from;
    const sf_stencil gap = *stencil;
    for (int i = 0; i < n; i++) {
        const double at[4] = {far[i] - gap.arc[0], far[i] - gap.arc[1], far[i] - gap.arc[2], far[i] - gap.arc[3]};
        const double first_two = at[0] * at[1], last_two = at[2] * at[3];
        const double weight[4] = {gap.factor[0] * at[1] * last_two, gap.factor[1] * at[0] * last_two,
                                  gap.factor[2] * at[3] * first_two, gap.factor[3] * at[2] * first_two};
        double at_Omega = 0, at_A = 0, at_R = 0;
        for (int j = 0; j < 4; j++)
            at_Omega += weight[j] * gap.Omega[j], at_A += weight[j] * gap.A[j], at_R += weight[j] * gap.R[j];
        Omega[i] = first_Omega[i] * at_Omega, A[i] = first_A[i] * at_A, R[i] = first_R[i] + at_R;
    }
}

/* Whether a point's way ends where the harmonics are a correction. */
static int sf_is_kept(const sf_second *second, const sf_first *first, const sf_solved *solved, long i, double h,
                      double A_1, double u_max) {
    const double far = exp(SF_SMALL), Omega = solved->Omega[i], A = solved->A[i];
    return sf_is_settled(second, solved, i) && A < far * first->A[i] && far * A > first->A[i] &&
           Omega < far * first->Omega[i] && far * Omega > first->Omega[i] && sf_is_small(Omega, A, h, A_1, u_max);
}

/* What is looked for at the points of a stretch that went their own way; NaN where one is not kept. */
static void sf_second_look(const sf_second *second, const sf_first *first, long from, long to, long anchors,
                           const sf_solved *solved) {
    double Omega[SF_LANES], A[SF_LANES], known[SF_KNOWN * SF_LANES], out[SF_BALANCE * SF_LANES];
    for (long k = 0; k < anchors; k += SF_LANES) {
        const long n = anchors - k < SF_LANES ? anchors - k : SF_LANES;
        for (long i = 0; i < SF_LANES; i++) {
            const long at = sf_anchor(from, to, k + (i < n ? i : n - 1));
            Omega[i] = solved->Omega[at], A[i] = solved->A[at];
        }
        sf_second_known(second->model, SF_LANES, A, known);
        sf_lane_balances(second, 0, SF_LANES, Omega, A, known, out);
        for (long i = 0; i < n; i++) {
            const long at = sf_anchor(from, to, k + i);
            if (!sf_is_kept(second, first, solved, at, known[i], out[SF_LANES + i], out[i]))
                solved->value[at] = NAN;
            else
                solved->value[at] = second->extent == SF_TOP_ONLY ? out[i] : out[5 * SF_LANES + i] * A[i];
        }
    }
}

/* Whether what is looked for is far from what lies between own[at] and own[at + 1]; best: the largest u_max so far. */
static int sf_is_away(const sf_second *second, const sf_solved *solved, const long own[4], int at, double best) {
    const double one = solved->value[own[at]], other = solved->value[own[at + 1]];
    double change = 0;
    for (int j = 0; j < 4; j++)
        if (isnan(solved->value[own[j]]))
            return 0;
    for (int j = 0; j < 3; j++)
        change = fmax(change, fabs(solved->value[own[j + 1]] - solved->value[own[j]]));
    if (second->extent == SF_TOP_ONLY)
        return fmax(one, other) + SF_AWAY * change < best;
    return second->extent == SF_FOLDS_ONLY && one * other > 0 && fmin(fabs(one), fabs(other)) > SF_AWAY * change;
}

/* A point of the first approximation's enters a lane; not where the third harmonic is below its resonance. */
static void sf_go_own_way(const sf_second *second, const sf_first *first, long i, sf_lanes *lanes,
                          const sf_solved *solved) {
    if (sf_off_resonance(first->Omega[i], first->A[i], first->h[i]))
        sf_enter_lane(second, (int)i, first->Omega[i], first->A[i], first->R[i], 1, lanes, solved);
}

static void sf_second_stretch(const sf_second *second, const sf_first *first, long from, long to,
                              const sf_solved *solved) {
    const long anchors = (to - 1 - from + SF_APART - 1) / SF_APART + 1;
    const int all = anchors < 4; /* go their own way */
    double best = 0;
    double Omega[SF_APART], A[SF_APART], R[SF_APART];
    sf_stencil stencil;
    sf_lanes lanes;
    long i;
    lanes.n = 0;
    for (long k = 0; k < (all ? to - from : anchors); k++)
        sf_go_own_way(second, first, all ? from + k : sf_anchor(from, to, k), &lanes, solved);
    sf_second_settle(second, &lanes, 1, solved);
    if (all)
        return;
    if (second->extent != SF_EVERY_POINT)
        sf_second_look(second, first, from, to, anchors, solved);
    for (long k = 0; k < anchors && second->extent == SF_TOP_ONLY; k++)
        best = fmax(best, solved->value[sf_anchor(from, to, k)]); /* of numbers, if one is none */
    for (long k = 0; k + 1 < anchors; k++) {
        const long left = k == 0 ? 0 : k + 3 > anchors ? anchors - 4 : k - 1, end = sf_anchor(from, to, k + 1);
        const long own[4] = {sf_anchor(from, to, left), sf_anchor(from, to, left + 1), sf_anchor(from, to, left + 2),
                             sf_anchor(from, to, left + 3)};
        if (second->extent != SF_EVERY_POINT && sf_is_away(second, solved, own, (int)(k - left), best)) {
            for (i = sf_anchor(from, to, k) + 1; i < end; i++)
                solved->step[i] = -1;
            continue;
        }
        if (!sf_take_stencil(second, first, solved, own, &stencil))
            continue;
        i = sf_anchor(from, to, k) + 1;
        sf_expected(first, &stencil, i, (int)(end - i), Omega, A, R);
        for (int j = 0; i < end; i++, j++)
            if (sf_off_resonance(first->Omega[i], first->A[i], first->h[i]))
                sf_enter_lane(second, (int)i, Omega[j], A[j], R[j], 0, &lanes, solved);
    }
    sf_second_settle(second, &lanes, 0, solved);
    /* what has not come from there goes its own way, and what has left its neighbours: its steps crossed a corner */
    for (long k = 0; k + 1 < anchors; k++) {
        const long start = sf_anchor(from, to, k), end = sf_anchor(from, to, k + 1);
        for (i = start + 1; i < end; i++)
            if (!(solved->step[i] < 0) &&
                !(sf_are_parallel(second, first, solved, start, i) && sf_are_parallel(second, first, solved, i, end)))
                sf_go_own_way(second, first, i, &lanes, solved);
    }
    sf_second_settle(second, &lanes, 1, solved);
}

/* How far each point lies from the one before it, in the metric of the ways; 0 of the first. A loop that vectorises. */
static void sf_distances(long n, double F_0, const double *restrict Omega, const double *restrict A,
                         const double *restrict R, double *restrict out) {
    out[0] = 0;
    for (long i = 1; i < n; i++) {
        const double x = (A[i] - A[i - 1]) / A[i], y = (R[i] - R[i - 1]) / F_0;
        const double z = SF_WEIGHT * (Omega[i] - Omega[i - 1]) / Omega[i];
        out[i] = sqrt(x * x + y * y + z * z);
    }
}

/* h, R, and the distance along each stretch in the metric of the ways. */
static void sf_measure_first(const sf_second *second, const sf_first *first) {
    const sf_model *model = second->model;
    double h[4 * SF_LANES];
    for (long i = 0; i < first->n; i += SF_LANES) {
        const long n = first->n - i < SF_LANES ? first->n - i : SF_LANES;
        model->mechanism->averaged_2(model->mechanism, n, first->A + i, model->p, h);
        for (long k = 0; k < n; k++) {
            first->h[i + k] = h[k];
            first->R[i + k] = slow_flow_R(first->Omega[i + k], first->A[i + k], h[k]);
        }
    }
    sf_distances(first->n, second->F_0, first->Omega, first->A, first->R, first->arc);
    for (long i = 1; i < first->n; i++)
        first->arc[i] += first->arc[i - 1];
}

/* ==== The curve =================================================================================================== */

typedef struct {
    double Omega, A;
    sf_balance at;
    int part;
} sf_second_point;

/* How many points of the first approximation were left out, of how many, and the frequencies between which they lie. */
typedef struct {
    long lost, of;
    double low, high;
} sf_left_out;

/* branches: connected stretches of the curve */
typedef struct {
    long n, branches;
    sf_left_out left;
    sf_second_point *point;
    unsigned char *closed;
} sf_second_curve;

static void sf_second_free(sf_second_curve *curve) {
    free(curve->point);
    free(curve->closed);
    free(curve);
}

/* Newton's method to a steady state from near by: in Omega at an amplitude, or in A at a frequency. Returns the last
 * step to its logarithm. */
static double sf_second_approach(const sf_second *second, int by_A, double *Omega, double *A) {
    double *const x = by_A ? A : Omega, step = HUGE_VAL, known[SF_KNOWN];
    for (int k = 0; k < SF_STEPS && fabs(step) > SF_DONE; k++) {
        sf_balance at;
        if (by_A || k == 0)
            sf_second_known(second->model, 1, A, known);
        sf_second_of(second, *Omega, *A, known, &at);
        step = sf_clipped(at.F / ((by_A ? at.F_A : at.F_Omega) * *x));
        *x *= sf_grown(-step);
    }
    return step;
}

/* The amplitudes around a breakpoint at which the force jumps, by rising size over it: its fold has another close
 * above. */
static double sf_around(int k) { return k == 0 ? 1 - 1e-6 : k == 1 ? 1 : 1 + pow(10, -13 + (k - 2) * (11. / 33)); }

static int sf_passes(const sf_second_point *a, const sf_second_point *b, double at) {
    return a->part == b->part && (a->A > at) != (b->A > at);
}

/* A point of a curve from lane i of n. */
static void sf_from_lane(int n, const double *Omega, const double *A, const double *out, int i,
                         sf_second_point *point) {
    point->Omega = Omega[i], point->A = A[i];
    for (int k = 0; k < SF_BALANCE; k++)
        point->at.values[k] = out[k * n + i];
}

/* More points between two that lie on both sides of breakpoint b, where the force jumps: folds are close there. They
 * are sought as sf_second_approach does, all at once. */
static long sf_second_across(const sf_second *second, double b, const sf_second_point *from, const sf_second_point *to,
                             sf_second_point *out) {
    const int rising = to->A > b;
    const double ratio = (b - from->A) / (to->A - from->A), low = fmin(from->A, to->A), high = fmax(from->A, to->A);
    double known[SF_KNOWN * SF_LANES], at[SF_BALANCE * SF_LANES];
    int under_way[SF_LANES];
    sf_lanes lanes;
    long found = 0;
    lanes.n = 0;
    for (int k = 0; k < SF_AROUND_B; k++) {
        const double A = b * sf_around(rising ? k : SF_AROUND_B - 1 - k);
        if (!(A > low && A < high))
            continue;
        lanes.Omega[lanes.n] = from->Omega + ratio * (to->Omega - from->Omega);
        lanes.R[lanes.n] = 0, lanes.A[lanes.n++] = A;
    }
    if (lanes.n == 0)
        return 0;
    int n = sf_whole_lanes(&lanes), open = lanes.n;
    for (int i = 0; i < lanes.n; i++)
        under_way[i] = 1;
    sf_second_known(second->model, n, lanes.A, known);
    for (int k = 0; k < SF_STEPS && open > 0; k++) {
        sf_lane_balances(second, 0, n, lanes.Omega, lanes.A, known, at);
        for (int i = 0; i < lanes.n; i++) {
            const double step = sf_clipped(at[4 * n + i] / (at[6 * n + i] * lanes.Omega[i]));
            if (!under_way[i])
                continue;
            lanes.Omega[i] *= sf_grown(-step);
            if (fabs(step) <= SF_DONE)
                under_way[i] = 0, open--;
        }
    }
    sf_lane_balances(second, second->extent == SF_EVERY_POINT, n, lanes.Omega, lanes.A, known, at);
    for (int i = 0; i < lanes.n; i++)
        if (!under_way[i]) {
            out[found].part = from->part;
            sf_from_lane(n, lanes.Omega, lanes.A, at, i, &out[found++]);
        }
    return found;
}

enum { SF_NOT_WANTED = 2 };

/* The points that are kept, with their balances; kept: whether each is, or SF_NOT_WANTED. */
static void sf_keep_points(const sf_second *second, const sf_first *first, const sf_solved *solved, unsigned char *kept,
                           sf_second_curve *curve) {
    double known[SF_KNOWN * SF_LANES], out[SF_BALANCE * SF_LANES];
    sf_lanes lanes;
    long i = 0;
    while (i < first->n) {
        for (lanes.n = 0; i < first->n && lanes.n < SF_LANES; i++) {
            const int here = sf_is_settled(second, solved, i);
            kept[i] = SF_NOT_WANTED;
            if (solved->step[i] < 0)
                continue;
            lanes.Omega[lanes.n] = here ? solved->Omega[i] : first->Omega[i];
            lanes.A[lanes.n] = here ? solved->A[i] : first->A[i], lanes.R[lanes.n] = 0;
            lanes.which[lanes.n++] = (int)i;
        }
        if (lanes.n == 0)
            return;
        const int n = sf_whole_lanes(&lanes);
        sf_second_known(second->model, n, lanes.A, known);
        sf_lane_balances(second, second->extent == SF_EVERY_POINT, n, lanes.Omega, lanes.A, known, out);
        for (int k = 0; k < lanes.n; k++) {
            const long at = lanes.which[k];
            kept[at] = (unsigned char)sf_is_kept(second, first, solved, at, known[k], out[n + k], out[k]);
            if (kept[at])
                sf_from_lane(n, lanes.Omega, lanes.A, out, k, &curve->point[curve->n++]);
        }
    }
}

/* What is left of each branch: the part that each point belongs to, whether a part is closed, and what is lost. */
static void sf_keep_parts(const sf_first *first, const int *closed, const unsigned char *kept, sf_second_curve *curve) {
    long to, n = 0;
    for (long from = 0; from < first->n; from = to) {
        int whole = closed[first->branch[from]], inside = 0;
        for (to = from; to < first->n && first->branch[to] == first->branch[from]; to++)
            whole &= kept[to] != 0;
        for (long i = from; i < to; i++) {
            if (kept[i] == SF_NOT_WANTED)
                continue;
            if (kept[i]) {
                if (!inside)
                    curve->closed[curve->branches++] = (unsigned char)whole;
                curve->point[n++].part = (int)curve->branches - 1;
            } else {
                sf_left_out *left = &curve->left;
                left->low = left->lost > 0 ? fmin(left->low, first->Omega[i]) : first->Omega[i];
                left->high = left->lost > 0 ? fmax(left->high, first->Omega[i]) : first->Omega[i];
                left->lost++;
            }
            inside = kept[i];
        }
    }
}

/* The points in order where some have overtaken others: only at a fold, where stability changes, Omega turns. */
static void sf_order_points(sf_second_curve *curve) {
    long to, j;
    for (long from = 0; from < curve->n; from = to) {
        sf_second_point *point = curve->point;
        for (to = from + 1;
             to < curve->n && point[to].part == point[from].part && (point[to].at.F_A > 0) == (point[from].at.F_A > 0);
             to++)
            ;
        const double rising = point[to - 1].Omega >= point[from].Omega ? 1 : -1;
        for (long i = from + 1; i < to; i++) {
            if (!(rising * point[i - 1].Omega > rising * point[i].Omega))
                continue; /* as nearly all are: to take one out and put it back copies it twice */
            const sf_second_point one = point[i];
            for (j = i; j > from && rising * point[j - 1].Omega > rising * one.Omega; j--)
                point[j] = point[j - 1];
            point[j] = one;
        }
    }
}

/* The curve with more points where it passes breakpoint b; 0 if there is no memory. */
static int sf_insert_near(const sf_second *second, double b, sf_second_curve *curve) {
    sf_second_point *more;
    long n = 0, passing = 0;
    for (long i = 1; i < curve->n; i++)
        passing += sf_passes(&curve->point[i - 1], &curve->point[i], b);
    if (passing == 0)
        return 1;
    more = malloc((size_t)(curve->n + passing * SF_AROUND_B) * sizeof *more);
    if (more == NULL)
        return 0;
    for (long i = 0; i < curve->n; i++) {
        if (i > 0 && sf_passes(&curve->point[i - 1], &curve->point[i], b))
            n += sf_second_across(second, b, &curve->point[i - 1], &curve->point[i], more + n);
        more[n++] = curve->point[i];
    }
    free(curve->point);
    curve->point = more, curve->n = n;
    return 1;
}

static int sf_second_move(const sf_second *second, const sf_first *first, const int *closed, double *room,
                          unsigned char *kept, sf_second_curve *curve) {
    const sf_solved solved = {room, room + first->n, room + 2 * first->n, room + 3 * first->n, room + 7 * first->n};
    long to;
    sf_measure_first(second, first);
    memcpy(solved.Omega, first->Omega, (size_t)first->n * sizeof *solved.Omega);
    memcpy(solved.A, first->A, (size_t)first->n * sizeof *solved.A);
    memcpy(solved.R, first->R, (size_t)first->n * sizeof *solved.R);
    for (long from = 0; from < first->n; from++)
        solved.step[from] = HUGE_VAL;
    for (long from = 0; from < first->n; from = to) {
        to = sf_stretch_end(second->model, first, from);
        sf_second_stretch(second, first, from, to, &solved);
    }
    sf_keep_points(second, first, &solved, kept, curve);
    sf_keep_parts(first, closed, kept, curve);
    for (int k = 0; k < second->model->breaks; k++)
        if (second->model->jump[k] != 0 && !sf_insert_near(second, second->model->b[k], curve))
            return 0;
    sf_order_points(curve);
    return 1;
}

/* The curve that n points of the first approximation's move to, on branches from 0 on, some of which are closed; to be
 * freed by sf_second_free. NULL if there is no memory. */
static sf_second_curve *sf_second_follow(const sf_model *model, double F_0, sf_wanted extent, long n,
                                         const sf_points *points, const int *closed) {
    const sf_second second = {model, F_0, extent};
    sf_second_curve *curve = calloc(1, sizeof *curve);
    double *room = malloc((size_t)(8 * n + 1) * sizeof *room);
    unsigned char *kept = malloc((size_t)n + 1);
    int done = 0;
    if (curve != NULL) {
        curve->left.of = n;
        curve->point = malloc((size_t)(n + 1) * sizeof *curve->point);
        curve->closed = malloc((size_t)n + 1);
    }
    if (curve != NULL && room != NULL && kept != NULL && curve->point != NULL && curve->closed != NULL) {
        const sf_first first = {n, points->Omega, points->A, points->branch, room + 4 * n, room + 5 * n, room + 6 * n};
        done = n == 0 || sf_second_move(&second, &first, closed, room, kept, curve);
    }
    free(room);
    free(kept);
    if (!done && curve != NULL) {
        sf_second_free(curve);
        curve = NULL;
    }
    return curve;
}
