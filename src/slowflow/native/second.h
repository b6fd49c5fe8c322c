/* The second approximation's curve: in go points of the first one's, out come those that they move to.
 *
 * Each point takes the shortest way. The distance counts ln A, R/F_0, in which the curve keeps away from itself however
 * sharp its peak is over Omega, and ln Omega, for where R hardly depends on that. What is no small correction is left
 * out. The balance is generated; it is the one of slowflow/second/, where the same is done on NumPy.
 *
 * A way is smooth along the curve: every sixteenth point goes its own, those between start from where they are
 * expected.
 */
#ifndef SF_SECOND_H
#define SF_SECOND_H

#include "curve.h"
#include "onset.h"
#include "second_approximation.h"
#include "second_work.h"

enum {
    SF_LANES = 64,
    SF_APART = 16,   /* points from one that goes its own way to the next */
    SF_BESIDE_B = 36 /* points beside a breakpoint */
};

/* changes between points that went their own way, as many as what is looked for is away where it is not between them */
#define SF_AWAY 2.
/* step to the frequency of a given R after which Newton's iteration takes over */
#define SF_MATCHED 1e-5

typedef struct {
    const sf_model *model;
    double F_0;
    sf_wanted wanted;
} sf_second;

/* ==== The balance ================================================================================================= */

static void sf_second_known(const sf_model *model, ptrdiff_t n, const double *A, double *known) {
    model->mechanism->averaged(n, A, model->p, known);
    model->mechanism->harmonics(n, A, model->p, known + 4 * n);
}

static void sf_second_of(const sf_second *second, double Omega, double A, const double *known, sf_balance *out) {
    second_approximation_response(Omega, A, second->F_0, second->model->m, second->model->zeta, known[0], known[1],
                                  known[2], known[4], known[5], known[6], known[8], known[9], known[10], out->values);
}

static void sf_second_at(const sf_second *second, double Omega, double A, sf_balance *out) {
    double known[SF_KNOWN];
    sf_second_known(second->model, 1, &A, known);
    sf_second_of(second, Omega, A, known, out);
}

/* Where the third harmonic is above its resonance. */
static inline int sf_off_resonance(double Omega, double A, double h) {
    return fabs(h) < SECOND_APPROXIMATION_RESONANCE * A * Omega * Omega;
}

/* Where the harmonics are a correction: the force's, and friction's, which take u_max below A. */
static inline int sf_is_small(double Omega, double A, double h, double A_1, double u_max) {
    return sf_off_resonance(Omega, A, h) && fabs(A_1 / A - 1) < SF_HARMONICS && fabs(u_max / A - 1) < SF_SMALL;
}

static int sf_second_is_small(const sf_second *second, double Omega, double A) {
    double h[4];
    sf_balance at;
    second->model->mechanism->averaged(1, &A, second->model->p, h);
    sf_second_at(second, Omega, A, &at);
    return sf_is_small(Omega, A, h[0], at.A_1, at.u_max);
}

static inline double sf_clipped(double step) { return fmin(fmax(step, -SF_LONGEST), SF_LONGEST); }

static inline double sf_grown(double x) { return fabs(x) < SF_SHORT ? sf_short_exp(x) : exp(x); }

/* ==== Newton's iteration in lanes ================================================================================= */

/* Points under way: where they are, and which they are. */
typedef struct {
    double Omega[SF_LANES], A[SF_LANES], R[SF_LANES];
    int which[SF_LANES];
    int n;
} sf_lanes;

/* Points where they end: with the last step, infinite where none was taken, and -1 where none is wanted; and what is
 * looked for there, F_A or u_max, of points that went their own way. */
typedef struct {
    double *Omega, *A, *R, *step, *value;
} sf_moved;

/* Whole vectors of lanes: the last one again and again. */
static int sf_whole_lanes(sf_lanes *lanes) {
    int n = lanes->n, i;
    for (i = n; i < SF_LANES && i % SF_VECTOR != 0; i++)
        lanes->Omega[i] = lanes->Omega[n - 1], lanes->A[i] = lanes->A[n - 1], lanes->R[i] = lanes->R[n - 1];
    return i;
}

/* Steps of the lanes to logarithms, which are taken: values times exp(step). */
static void sf_take_steps(int n, const double *steps, const double *grown, double *values) {
    int i;
    for (i = 0; i < n; i++)
        values[i] *= fabs(steps[i]) < SF_SHORT ? grown[i] : exp(steps[i]);
}

/* The frequency at which the cosine balance is R, the one given where R hardly depends on it. */
static void sf_second_match(const sf_second *second, int n, const double *known, sf_lanes *lanes) {
    double out[SF_BALANCE * SF_LANES], matches[SF_MATCH * SF_LANES], way[SF_LANES] = {0};
    int i, k;
    for (k = 0; k < SF_MATCHING; k++) {
        int open = 0;
        sf_second_balances(n, lanes->Omega, lanes->A, second->F_0, second->model->m, second->model->zeta, known, out);
        sf_second_matches(n, lanes->Omega, lanes->R, way, second->F_0, out, matches);
        sf_take_steps(n, matches, matches + n, lanes->Omega);
        for (i = 0; i < n; i++) {
            way[i] += matches[i];
            open |= fabs(matches[i]) > SF_MATCHED;
        }
        if (!open)
            break;
    }
}

/* Newton's iteration of the lanes; match: whether they are so far that their frequencies should first match R. */
static void sf_second_settle(const sf_second *second, sf_lanes *lanes, int match, const sf_moved *moved) {
    const double F_0 = second->F_0;
    double known[SF_KNOWN * SF_LANES], out[SF_BALANCE * SF_LANES], newton[SF_NEWTON * SF_LANES];
    int i, k;
    for (k = 0; k < SF_STEPS && lanes->n > 0; k++) {
        const int n = sf_whole_lanes(lanes), count = lanes->n;
        const double *size = newton, *done = newton + n, *R = newton + 2 * n, *x = newton + 3 * n, *z = newton + 5 * n;
        sf_second_known(second->model, n, lanes->A, known);
        if (match)
            sf_second_match(second, n, known, lanes);
        sf_second_balances(n, lanes->Omega, lanes->A, F_0, second->model->m, second->model->zeta, known, out);
        sf_second_newton(n, lanes->Omega, lanes->A, F_0, out, newton);
        sf_take_steps(count, x, x + n, lanes->A);
        sf_take_steps(count, z, z + n, lanes->Omega);
        lanes->n = 0;
        for (i = 0; i < count; i++) {
            const double Omega = lanes->Omega[i], A = lanes->A[i];
            const int which = lanes->which[i], to = lanes->n;
            moved->Omega[which] = Omega, moved->A[which] = A, moved->R[which] = R[i], moved->step[which] = size[i];
            if (size[i] > done[i]) { /* NaN ends it too */
                lanes->Omega[to] = Omega, lanes->A[to] = A, lanes->R[to] = R[i];
                lanes->which[to] = which, lanes->n++;
            }
        }
    }
    lanes->n = 0; /* what is not settled by now does not settle */
}

static void sf_enter_lane(const sf_second *second, int which, double Omega, double A, double R, int match,
                          sf_lanes *lanes, const sf_moved *moved) {
    lanes->Omega[lanes->n] = Omega, lanes->A[lanes->n] = A, lanes->R[lanes->n] = R;
    lanes->which[lanes->n++] = which;
    if (lanes->n == SF_LANES)
        sf_second_settle(second, lanes, match, moved);
}

/* ==== From the first approximation's points ======================================================================= */

/* The first approximation's points; h and R there, and how far along its stretch each lies. */
typedef struct {
    long n;
    const double *Omega, *A;
    const long long *branch;
    double *h, *R, *along;
} sf_first;

/* Where a point's stretch ends, along which the ways are smooth: with its branch, or a piece of the force. */
static long sf_stretch_end(const sf_model *model, const sf_first *first, long from) {
    long i;
    int k;
    for (i = from + 1; i < first->n && first->branch[i] == first->branch[from]; i++)
        for (k = 0; k < model->breaks; k++)
            if ((first->A[i] > model->b[k]) != (first->A[from] > model->b[k]))
                return i;
    return i;
}

static int sf_is_settled(const sf_second *second, const sf_moved *moved, long i) {
    return moved->step[i] >= 0 &&
           moved->step[i] <= SF_MOVED + SF_ROUNDING * moved->A[i] * moved->Omega[i] * moved->Omega[i] / second->F_0;
}

/* The point of a stretch that goes its own way, by its number: the last one is the stretch's end. */
static inline long sf_anchor(long from, long to, long k)
{
    return from + k * SF_APART < to - 1 ? from + k * SF_APART : to - 1;
}

/* Whether neighbours that went their own way ended apart as they were: elsewhere ways cross, as next to a tip. */
static int sf_are_parallel(const sf_second *second, const sf_first *first, const sf_moved *moved, long a, long b) {
    const double x = moved->A[b] / first->A[b] - moved->A[a] / first->A[a];
    const double y = ((moved->R[b] - first->R[b]) - (moved->R[a] - first->R[a])) / second->F_0;
    const double z = SF_WEIGHT * (moved->Omega[b] / first->Omega[b] - moved->Omega[a] / first->Omega[a]);
    return sf_is_settled(second, moved, a) && sf_is_settled(second, moved, b) &&
           sqrt(x * x + y * y + z * z) < 0.5 * (first->along[b] - first->along[a]);
}

/* The four points nearest to a gap that went their own way: how far along they lie, where each went to from where, and
 * the factors of their weights. */
typedef struct {
    double along[4], Omega[4], A[4], R[4], factor[4];
} sf_beside_gap;

/* 0 where what is between cannot be told from them. */
static int sf_look_beside(const sf_second *second, const sf_first *first, const sf_moved *moved, const long own[4],
                          sf_beside_gap *beside) {
    int j, k;
    for (j = 0; j < 3; j++)
        if (!sf_are_parallel(second, first, moved, own[j], own[j + 1]))
            return 0;
    for (j = 0; j < 4; j++) {
        double apart = 1;
        for (k = 0; k < 4; k++)
            if (k != j)
                apart *= first->along[own[j]] - first->along[own[k]];
        beside->along[j] = first->along[own[j]], beside->factor[j] = 1 / apart;
        beside->Omega[j] = moved->Omega[own[j]] / first->Omega[own[j]];
        beside->A[j] = moved->A[own[j]] / first->A[own[j]];
        beside->R[j] = moved->R[own[j]] - first->R[own[j]];
    }
    return 1;
}

/* Where a point of a gap is expected. */
static void sf_expected(const sf_first *first, const sf_beside_gap *beside, long i, double *Omega, double *A, double *R)
{
    const double along = first->along[i], *at = beside->along, *factor = beside->factor;
    const double first_two = (along - at[0]) * (along - at[1]), last_two = (along - at[2]) * (along - at[3]);
    const double weight[4] = {factor[0] * (along - at[1]) * last_two, factor[1] * (along - at[0]) * last_two,
                              factor[2] * (along - at[3]) * first_two, factor[3] * (along - at[2]) * first_two};
    double at_Omega = 0, at_A = 0, at_R = 0;
    int j;
    for (j = 0; j < 4; j++)
        at_Omega += weight[j] * beside->Omega[j], at_A += weight[j] * beside->A[j], at_R += weight[j] * beside->R[j];
    *Omega = first->Omega[i] * at_Omega, *A = first->A[i] * at_A, *R = first->R[i] + at_R;
}

/* Whether a point's way ends where the harmonics are a correction. */
static int sf_is_kept(const sf_second *second, const sf_first *first, const sf_moved *moved, long i, double h,
                      double A_1, double u_max)
{
    const double far = exp(SF_SMALL), Omega = moved->Omega[i], A = moved->A[i];
    return sf_is_settled(second, moved, i) && A < far * first->A[i] && far * A > first->A[i] &&
           Omega < far * first->Omega[i] && far * Omega > first->Omega[i] && sf_is_small(Omega, A, h, A_1, u_max);
}

/* What is looked for at the points of a stretch that went their own way; NaN where one is not kept. */
static void sf_second_look(const sf_second *second, const sf_first *first, long from, long to, long anchors,
                           const sf_moved *moved) {
    double Omega[SF_LANES], A[SF_LANES], known[SF_KNOWN * SF_LANES], out[SF_BALANCE * SF_LANES];
    long k, i, n;
    for (k = 0; k < anchors; k += SF_LANES) {
        n = anchors - k < SF_LANES ? anchors - k : SF_LANES;
        for (i = 0; i < SF_LANES; i++) {
            const long at = sf_anchor(from, to, k + (i < n ? i : n - 1));
            Omega[i] = moved->Omega[at], A[i] = moved->A[at];
        }
        sf_second_known(second->model, SF_LANES, A, known);
        sf_second_balances(SF_LANES, Omega, A, second->F_0, second->model->m, second->model->zeta, known, out);
        for (i = 0; i < n; i++) {
            const long at = sf_anchor(from, to, k + i);
            if (!sf_is_kept(second, first, moved, at, known[i], out[SF_LANES + i], out[i]))
                moved->value[at] = NAN;
            else
                moved->value[at] = second->wanted == SF_TOP_ONLY ? out[i] : out[5 * SF_LANES + i] * A[i];
        }
    }
}

/* Whether what is looked for is far from what lies between own[at] and own[at + 1]; best: the largest u_max so far. */
static int sf_is_away(const sf_second *second, const sf_moved *moved, const long own[4], int at, double best) {
    const double one = moved->value[own[at]], other = moved->value[own[at + 1]];
    double change = 0;
    int j;
    for (j = 0; j < 4; j++)
        if (isnan(moved->value[own[j]]))
            return 0;
    for (j = 0; j < 3; j++)
        change = fmax(change, fabs(moved->value[own[j + 1]] - moved->value[own[j]]));
    if (second->wanted == SF_TOP_ONLY)
        return fmax(one, other) + SF_AWAY * change < best;
    return second->wanted == SF_FOLDS_ONLY && one * other > 0 && fmin(fabs(one), fabs(other)) > SF_AWAY * change;
}

static void sf_second_stretch(const sf_second *second, const sf_first *first, long from, long to,
                              const sf_moved *moved) {
    const long anchors = (to - 1 - from + SF_APART - 1) / SF_APART + 1;
    double best = 0;
    sf_beside_gap beside;
    sf_lanes lanes;
    long i, k;
    if (anchors < 4) {
        lanes.n = 0;
        for (i = from; i < to; i++)
            if (sf_off_resonance(first->Omega[i], first->A[i], first->h[i]))
                sf_enter_lane(second, (int)i, first->Omega[i], first->A[i], first->R[i], 1, &lanes, moved);
        sf_second_settle(second, &lanes, 1, moved);
        return;
    }
    lanes.n = 0;
    for (k = 0; k < anchors; k++) {
        i = sf_anchor(from, to, k);
        if (sf_off_resonance(first->Omega[i], first->A[i], first->h[i]))
            sf_enter_lane(second, (int)i, first->Omega[i], first->A[i], first->R[i], 1, &lanes, moved);
    }
    sf_second_settle(second, &lanes, 1, moved);
    if (second->wanted != SF_EVERY_POINT)
        sf_second_look(second, first, from, to, anchors, moved);
    for (k = 0; k < anchors && second->wanted == SF_TOP_ONLY; k++)
        best = fmax(best, moved->value[sf_anchor(from, to, k)]); /* of numbers, if one is none */
    for (k = 0; k + 1 < anchors; k++) {
        const long left = k == 0 ? 0 : k + 3 > anchors ? anchors - 4 : k - 1, end = sf_anchor(from, to, k + 1);
        const long own[4] = {sf_anchor(from, to, left), sf_anchor(from, to, left + 1), sf_anchor(from, to, left + 2),
                             sf_anchor(from, to, left + 3)};
        if (second->wanted != SF_EVERY_POINT && sf_is_away(second, moved, own, (int)(k - left), best)) {
            for (i = sf_anchor(from, to, k) + 1; i < end; i++)
                moved->step[i] = -1;
            continue;
        }
        if (!sf_look_beside(second, first, moved, own, &beside))
            continue;
        for (i = sf_anchor(from, to, k) + 1; i < end; i++) {
            double Omega, A, R;
            if (!sf_off_resonance(first->Omega[i], first->A[i], first->h[i]))
                continue;
            sf_expected(first, &beside, i, &Omega, &A, &R);
            sf_enter_lane(second, (int)i, Omega, A, R, 0, &lanes, moved);
        }
    }
    sf_second_settle(second, &lanes, 0, moved);
    for (i = from; i < to; i++) /* what has not come from there goes its own way */
        if (!(moved->step[i] < 0) && !sf_is_settled(second, moved, i) &&
            sf_off_resonance(first->Omega[i], first->A[i], first->h[i]))
            sf_enter_lane(second, (int)i, first->Omega[i], first->A[i], first->R[i], 1, &lanes, moved);
    sf_second_settle(second, &lanes, 1, moved);
}

/* h, R, and the distance along each stretch in the metric of the ways. */
static void sf_measure_first(const sf_second *second, const sf_first *first) {
    const sf_model *model = second->model;
    double h[4 * SF_LANES];
    long i, k;
    for (i = 0; i < first->n; i += SF_LANES) {
        const long n = first->n - i < SF_LANES ? first->n - i : SF_LANES;
        model->mechanism->averaged_2(n, first->A + i, model->p, h);
        for (k = 0; k < n; k++) {
            first->h[i + k] = h[k];
            first->R[i + k] = slow_flow_R(first->Omega[i + k], first->A[i + k], h[k]);
        }
    }
    first->along[0] = 0;
    for (i = 1; i < first->n; i++) {
        const double x = (first->A[i] - first->A[i - 1]) / first->A[i];
        const double y = (first->R[i] - first->R[i - 1]) / second->F_0;
        const double z = SF_WEIGHT * (first->Omega[i] - first->Omega[i - 1]) / first->Omega[i];
        first->along[i] = first->along[i - 1] + sqrt(x * x + y * y + z * z);
    }
}

/* ==== The curve =================================================================================================== */

static void sf_second_free(sf_second_curve *curve) {
    free(curve->point);
    free(curve->closed);
    free(curve);
}

/* The frequency near the one given at which A is a steady state, and the last step to its logarithm. */
static double sf_second_frequency(const sf_second *second, double A, double Omega, double *step) {
    double known[SF_KNOWN];
    int k;
    sf_second_known(second->model, 1, &A, known);
    *step = HUGE_VAL;
    for (k = 0; k < SF_STEPS && fabs(*step) > SF_DONE; k++) {
        sf_balance at;
        sf_second_of(second, Omega, A, known, &at);
        *step = sf_clipped(at.F / (at.F_Omega * Omega));
        Omega *= sf_grown(-*step);
    }
    return Omega;
}

/* The amplitudes beside a breakpoint at which the force jumps, by rising size over it: its fold has another close
 * above. */
static double sf_beside(int k) { return k == 0 ? 1 - 1e-6 : k == 1 ? 1 : 1 + pow(10, -13 + (k - 2) * (11. / 33)); }

static int sf_passes(const sf_second_point *a, const sf_second_point *b, double at) {
    return a->part == b->part && (a->A > at) != (b->A > at);
}

/* Balances at whole vectors of states; phi where every point is wanted, else none. */
static void sf_second_told(const sf_second *second, int n, const double *Omega, const double *A, const double *known,
                           double *out) {
    int i;
    if (second->wanted == SF_EVERY_POINT) {
        sf_second_answers(n, Omega, A, second->F_0, second->model->m, second->model->zeta, known, out);
        return;
    }
    sf_second_balances(n, Omega, A, second->F_0, second->model->m, second->model->zeta, known, out);
    for (i = 0; i < n; i++)
        out[2 * n + i] = NAN;
}

/* A point of a curve from lane i of n. */
static void sf_from_lane(int n, const double *Omega, const double *A, const double *out, int i, sf_second_point *point)
{
    int k;
    point->Omega = Omega[i], point->A = A[i];
    for (k = 0; k < SF_BALANCE; k++)
        point->at.values[k] = out[k * n + i];
}

/* More points between two that lie on both sides of breakpoint b, where the force jumps: folds are close there. They
 * are sought as sf_second_frequency does, all at once. */
static long sf_second_across(const sf_second *second, double b, const sf_second_point *from, const sf_second_point *to,
                             sf_second_point *out) {
    const int rising = to->A > b;
    const double share = (b - from->A) / (to->A - from->A), low = fmin(from->A, to->A), high = fmax(from->A, to->A);
    double known[SF_KNOWN * SF_LANES], at[SF_BALANCE * SF_LANES];
    int under_way[SF_LANES], open, k, i, n;
    sf_lanes lanes;
    long found = 0;
    lanes.n = 0;
    for (k = 0; k < SF_BESIDE_B; k++) {
        const double A = b * sf_beside(rising ? k : SF_BESIDE_B - 1 - k);
        if (!(A > low && A < high))
            continue;
        lanes.Omega[lanes.n] = from->Omega + share * (to->Omega - from->Omega);
        lanes.R[lanes.n] = 0, lanes.A[lanes.n++] = A;
    }
    if (lanes.n == 0)
        return 0;
    n = sf_whole_lanes(&lanes), open = lanes.n;
    for (i = 0; i < lanes.n; i++)
        under_way[i] = 1;
    sf_second_known(second->model, n, lanes.A, known);
    for (k = 0; k < SF_STEPS && open > 0; k++) {
        sf_second_balances(n, lanes.Omega, lanes.A, second->F_0, second->model->m, second->model->zeta, known, at);
        for (i = 0; i < lanes.n; i++) {
            const double step = sf_clipped(at[4 * n + i] / (at[6 * n + i] * lanes.Omega[i]));
            if (!under_way[i])
                continue;
            lanes.Omega[i] *= sf_grown(-step);
            if (fabs(step) <= SF_DONE)
                under_way[i] = 0, open--;
        }
    }
    sf_second_told(second, n, lanes.Omega, lanes.A, known, at);
    for (i = 0; i < lanes.n; i++)
        if (!under_way[i]) {
            out[found].part = from->part;
            sf_from_lane(n, lanes.Omega, lanes.A, at, i, &out[found++]);
        }
    return found;
}

enum { SF_NOT_WANTED = 2 };

/* The points that are kept, with their balances; kept: whether each is, or SF_NOT_WANTED. */
static void sf_keep_points(const sf_second *second, const sf_first *first, const sf_moved *moved, unsigned char *kept,
                           sf_second_curve *curve) {
    double known[SF_KNOWN * SF_LANES], out[SF_BALANCE * SF_LANES];
    sf_lanes lanes;
    long i = 0;
    int k;
    while (i < first->n) {
        for (lanes.n = 0; i < first->n && lanes.n < SF_LANES; i++) {
            const int here = sf_is_settled(second, moved, i);
            kept[i] = SF_NOT_WANTED;
            if (moved->step[i] < 0)
                continue;
            lanes.Omega[lanes.n] = here ? moved->Omega[i] : first->Omega[i];
            lanes.A[lanes.n] = here ? moved->A[i] : first->A[i], lanes.R[lanes.n] = 0;
            lanes.which[lanes.n++] = (int)i;
        }
        if (lanes.n == 0)
            return;
        {
            const int n = sf_whole_lanes(&lanes);
            sf_second_known(second->model, n, lanes.A, known);
            sf_second_told(second, n, lanes.Omega, lanes.A, known, out);
            for (k = 0; k < lanes.n; k++) {
                const long at = lanes.which[k];
                kept[at] = (unsigned char)sf_is_kept(second, first, moved, at, known[k], out[n + k], out[k]);
                if (kept[at])
                    sf_from_lane(n, lanes.Omega, lanes.A, out, k, &curve->point[curve->n++]);
            }
        }
    }
}

/* What is left of each branch: the part that each point belongs to, whether a part is closed, and what is lost. */
static void sf_keep_parts(const sf_first *first, const unsigned char *closed, const unsigned char *kept,
                          sf_second_curve *curve) {
    long from, to, i, n = 0;
    for (from = 0; from < first->n; from = to) {
        int whole = closed[first->branch[from]], inside = 0;
        for (to = from; to < first->n && first->branch[to] == first->branch[from]; to++)
            whole &= kept[to] != 0;
        for (i = from; i < to; i++) {
            if (kept[i] == SF_NOT_WANTED)
                continue;
            if (kept[i]) {
                if (!inside)
                    curve->closed[curve->parts++] = (unsigned char)whole;
                curve->point[n++].part = (int)curve->parts - 1;
            } else {
                curve->lost_low = curve->lost > 0 ? fmin(curve->lost_low, first->Omega[i]) : first->Omega[i];
                curve->lost_high = curve->lost > 0 ? fmax(curve->lost_high, first->Omega[i]) : first->Omega[i];
                curve->lost++;
            }
            inside = kept[i];
        }
    }
}

/* The points in order where some have overtaken others: only at a fold, where stability changes, Omega turns. */
static void sf_order_points(sf_second_curve *curve) {
    long from, to, i, j;
    for (from = 0; from < curve->n; from = to) {
        sf_second_point *point = curve->point;
        double rising;
        for (to = from + 1; to < curve->n && point[to].part == point[from].part &&
                            (point[to].at.F_A > 0) == (point[from].at.F_A > 0);
             to++)
            ;
        rising = point[to - 1].Omega >= point[from].Omega ? 1 : -1;
        for (i = from + 1; i < to; i++) {
            const sf_second_point one = point[i];
            for (j = i; j > from && rising * point[j - 1].Omega > rising * one.Omega; j--)
                point[j] = point[j - 1];
            point[j] = one;
        }
    }
}

/* The curve with more points where it passes breakpoint b; 0 if there is no memory. */
static int sf_insert_beside(const sf_second *second, double b, sf_second_curve *curve) {
    sf_second_point *more;
    long i, n = 0, passing = 0;
    for (i = 1; i < curve->n; i++)
        passing += sf_passes(&curve->point[i - 1], &curve->point[i], b);
    if (passing == 0)
        return 1;
    more = malloc((size_t)(curve->n + passing * SF_BESIDE_B) * sizeof *more);
    if (more == NULL)
        return 0;
    for (i = 0; i < curve->n; i++) {
        if (i > 0 && sf_passes(&curve->point[i - 1], &curve->point[i], b))
            n += sf_second_across(second, b, &curve->point[i - 1], &curve->point[i], more + n);
        more[n++] = curve->point[i];
    }
    free(curve->point);
    curve->point = more, curve->n = n;
    return 1;
}

static int sf_second_move(const sf_second *second, const sf_first *first, const unsigned char *closed, double *room,
                          unsigned char *kept, sf_second_curve *curve) {
    const sf_moved moved = {room, room + first->n, room + 2 * first->n, room + 3 * first->n,
                            room + 7 * first->n};
    long from, to;
    int k;
    sf_measure_first(second, first);
    memcpy(moved.Omega, first->Omega, (size_t)first->n * sizeof *moved.Omega);
    memcpy(moved.A, first->A, (size_t)first->n * sizeof *moved.A);
    memcpy(moved.R, first->R, (size_t)first->n * sizeof *moved.R);
    for (from = 0; from < first->n; from++)
        moved.step[from] = HUGE_VAL;
    for (from = 0; from < first->n; from = to) {
        to = sf_stretch_end(second->model, first, from);
        sf_second_stretch(second, first, from, to, &moved);
    }
    sf_keep_points(second, first, &moved, kept, curve);
    sf_keep_parts(first, closed, kept, curve);
    for (k = 0; k < second->model->breaks; k++)
        if (second->model->jump[k] != 0 && !sf_insert_beside(second, second->model->b[k], curve))
            return 0;
    sf_order_points(curve);
    return 1;
}

/* The curve that n points of the first approximation's move to, on branches from 0 on, some of which are closed; to be
 * freed by sf_second_free. NULL if there is no memory. */
static sf_second_curve *sf_second_follow(const sf_model *model, double F_0, sf_wanted wanted, long n,
                                         const double *Omega, const double *A, const long long *branch,
                                         const unsigned char *closed)
{
    const sf_second second = {model, F_0, wanted};
    sf_second_curve *curve = calloc(1, sizeof *curve);
    double *room = malloc((size_t)(8 * n + 1) * sizeof *room);
    unsigned char *kept = malloc((size_t)n + 1);
    int done = 0;
    if (curve != NULL) {
        curve->of = n;
        curve->point = malloc((size_t)(n + 1) * sizeof *curve->point);
        curve->closed = malloc((size_t)n + 1);
    }
    if (curve != NULL && room != NULL && kept != NULL && curve->point != NULL && curve->closed != NULL) {
        const sf_first first = {n, Omega, A, branch, room + 4 * n, room + 5 * n, room + 6 * n};
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

/* ==== Zeros in a bracket ========================================================================================== */

typedef double sf_function(const void *given, double x);

/* The zero between a and b, at which the function has the signs of f_a and f_b, to a relative width; Chandrupatla's
 * choice between the inverse quadratic and the middle. */
static double sf_zero_between(sf_function *f, const void *given, double a, double f_a, double b, double f_b,
                              double width) {
    double share = 0.5, c = a, f_c = f_a;
    int i;
    for (i = 0; i < 200; i++) {
        const double x = a + share * (b - a), f_x = f(given, x);
        double least;
        if ((f_x < 0) == (f_a < 0))
            c = a, f_c = f_a;
        else
            c = b, f_c = f_b, b = a, f_b = f_a;
        a = x, f_a = f_x;
        least = 0.5 * width * fabs(fabs(f_a) < fabs(f_b) ? a : b) / fabs(b - a);
        if (!(least < 0.5) || f_x == 0)
            break;
        {
            const double xi = (a - b) / (c - b), phi = (f_a - f_b) / (f_c - f_b);
            if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
                share =
                    f_a / (f_b - f_a) * f_c / (f_b - f_c) + (c - a) / (b - a) * f_a / (f_c - f_a) * f_b / (f_c - f_b);
            else
                share = 0.5;
        }
        share = fmin(fmax(share, least), 1 - least);
    }
    return fabs(f_a) < fabs(f_b) ? a : b;
}

/* ==== Folds ======================================================================================================= */

/* Where F_A is asked between two points of a curve, by amplitude. */
typedef struct {
    const sf_second *second;
    double A[2], Omega[2];
} sf_second_between;

static double sf_Omega_between(const sf_second_between *between, double A) {
    const double share = (A - between->A[0]) / (between->A[1] - between->A[0]);
    double step;
    return sf_second_frequency(between->second, A, between->Omega[0] + share * (between->Omega[1] - between->Omega[0]),
                               &step);
}

static double sf_slope_between(const void *given, double A) {
    const sf_second_between *between = given;
    double known[SF_KNOWN];
    sf_balance at;
    const double Omega = sf_Omega_between(between, A);
    sf_second_known(between->second->model, 1, &A, known);
    sf_second_of(between->second, Omega, A, known, &at);
    return at.F_A;
}

/* Where F_A changes its sign between two neighbouring points; 0 where it cannot be found. */
static int sf_second_fold_between(const sf_second *second, const sf_second_point *one, const sf_second_point *other,
                                  sf_second_fold *fold) {
    const sf_second_point *low = one->A < other->A ? one : other, *high = one->A < other->A ? other : one;
    const sf_second_between between = {second, {low->A, high->A}, {low->Omega, high->Omega}};
    const double f_low = sf_slope_between(&between, low->A), f_high = sf_slope_between(&between, high->A);
    sf_balance at;
    int k;
    if (!sf_opposite(f_low, f_high) || !(low->A < high->A))
        return 0;
    fold->A = sf_zero_between(sf_slope_between, &between, low->A, f_low, high->A, f_high, 0x1p-50);
    fold->corner = 0, fold->up = f_low > 0;
    for (k = 0; k < second->model->breaks; k++)
        if (fabs(fold->A - second->model->b[k]) <= 0x1p-49 * second->model->b[k])
            fold->corner = 1, fold->A = second->model->b[k];
    /* next to a tip the frequency may slip to its other side, and the slope with it */
    if (!fold->corner &&
        !(fabs(sf_slope_between(&between, fold->A)) <= SF_VANISHED * fmax(fabs(f_low), fabs(f_high))))
        return 0;
    fold->Omega = sf_Omega_between(&between, fold->A);
    sf_second_at(second, fold->Omega, fold->A, &at);
    fold->u_max = at.u_max, fold->A_1 = at.A_1;
    return 1;
}

static int sf_is_same_fold(const sf_second_fold *a, const sf_second_fold *b) {
    return fabs(a->Omega - b->Omega) <= SF_SETTLED * b->Omega && fabs(a->A - b->A) <= SF_SETTLED * b->A &&
           a->corner == b->corner && a->up == b->up;
}

/* Every fold between points of the curve, by rising Omega. */
static void sf_folds_on(const sf_model *model, double F_0, const sf_second_curve *curve, sf_second_folds *out) {
    const sf_second here = {model, F_0, SF_EVERY_POINT}, *second = &here;
    long i;
    int k;
    out->n = out->lost = out->tried = 0, out->status = SF_OK;
    for (i = 1; i < curve->n; i++) {
        const sf_second_point *one = &curve->point[i - 1], *other = &curve->point[i];
        sf_second_fold fold;
        if (one->part != other->part || (one->at.F_A > 0) == (other->at.F_A > 0))
            continue;
        out->tried++;
        if (!sf_second_fold_between(second, one, other, &fold)) {
            out->lost++;
            continue;
        }
        /* where points crowd the curve may turn to and fro within rounding */
        for (k = 0; k < out->n && !sf_is_same_fold(&out->at[k], &fold); k++)
            ;
        if (k < out->n)
            continue;
        if (out->n == SF_MOST_FOLDS) {
            out->status = SF_TOO_MANY;
            return;
        }
        for (k = out->n++; k > 0 && out->at[k - 1].Omega > fold.Omega; k--)
            out->at[k] = out->at[k - 1];
        out->at[k] = fold;
    }
}

/* ==== States ====================================================================================================== */

/* The state at a frequency between two amplitudes with one in between; 0 where it is not found. */
static int sf_second_state(const sf_second *second, double Omega, double low, double A, double high,
                           sf_second_point *out) {
    sf_balance at_low, at_high, at;
    double step = HUGE_VAL;
    int between, k;
    sf_second_at(second, Omega, low, &at_low);
    sf_second_at(second, Omega, high, &at_high);
    between = (at_low.F > 0) != (at_high.F > 0);
    for (k = 0; k < SF_STEPS && fabs(step) > 0x1p-52 * A; k++) {
        sf_second_at(second, Omega, A, &at);
        if (between && (at.F > 0) == (at_high.F > 0))
            high = A;
        else if (between)
            low = A;
        step = at.F / at.F_A;
        if (between && !(A - step >= low && A - step <= high) && fabs(step) > SF_DONE * A)
            A = sqrt(low * high);
        else
            A = fmin(fmax(A - step, low), high);
    }
    out->Omega = Omega, out->A = A;
    sf_second_at(second, Omega, A, &out->at);
    return fabs(step) <= SF_DONE * A;
}

/* The states at a frequency where the curve crosses it, by rising A; out has room for as many as sf_most_crossings
 * says. */
static int sf_states_on(const sf_model *model, double F_0, const sf_second_curve *curve, double Omega,
                        sf_second_point *out) {
    const sf_second here = {model, F_0, SF_EVERY_POINT}, *second = &here;
    int n = 0, k;
    long i;
    for (i = 1; i < curve->n; i++) {
        const sf_second_point *one = &curve->point[i - 1], *other = &curve->point[i];
        sf_second_point found;
        double share;
        if (one->part != other->part || (one->Omega > Omega) == (other->Omega > Omega))
            continue;
        share = (Omega - one->Omega) / (other->Omega - one->Omega);
        if (!sf_second_state(second, Omega, fmin(one->A, other->A), exp(log(one->A) + share * log(other->A / one->A)),
                             fmax(one->A, other->A), &found))
            continue;
        /* a curve that turns beside a corner may cross a frequency to and fro within rounding */
        for (k = 0; k < n && fabs(out[k].A - found.A) > SF_SETTLED * found.A; k++)
            ;
        if (k < n)
            continue;
        for (k = n++; k > 0 && out[k - 1].A > found.A; k--)
            out[k] = out[k - 1];
        out[k] = found;
    }
    return n;
}

static long sf_most_crossings(const sf_second_curve *curve, double Omega) {
    long i, n = 0;
    for (i = 1; i < curve->n; i++)
        n += curve->point[i - 1].part == curve->point[i].part &&
             (curve->point[i - 1].Omega > Omega) != (curve->point[i].Omega > Omega);
    return n;
}

/* ==== Critical forcings =========================================================================================== */

/* F, F_A and F_AA over F_0^2 by ln A, at a state given by logarithms. */
static void sf_second_cusp_at(const sf_second *second, double ln_Omega, double ln_A, double out[2]) {
    const double Omega = exp(ln_Omega), A = exp(ln_A), per = A / (second->F_0 * second->F_0);
    double k[SF_KNOWN], folds[3];
    sf_second_known(second->model, 1, &A, k);
    second_approximation_folds(Omega, A, second->F_0, second->model->m, second->model->zeta, k[0], k[1], k[2], k[3],
                               k[4], k[5], k[6], k[7], k[8], k[9], k[10], k[11], folds);
    out[0] = folds[1] * per, out[1] = folds[2] * per * A;
}

/* The lowest forcing that has a fold, from the first approximation's cusp: F_A = F_AA = 0, which do not hold F_0, by
 * Newton's iteration with differences for slopes. */
static sf_second_status sf_second_cusp(const sf_model *model, const sf_onset *first, sf_onset *out, double *u_max) {
    const sf_second second = {model, first->F_SN, SF_EVERY_POINT};
    const double from[2] = {log(first->Omega), log(first->A)}, apart = 0x1p-20;
    double x[2] = {from[0], from[1]}, g[2], moved = HUGE_VAL, Omega, A, k[SF_KNOWN], balance[3];
    int i;
    for (i = 0; i < SF_STEPS && moved > 0x1p-50; i++) {
        double by[2][2], determinant, step[2];
        int j;
        sf_second_cusp_at(&second, x[0], x[1], g);
        for (j = 0; j < 2; j++) {
            double up[2], down[2];
            sf_second_cusp_at(&second, x[0] + (j == 0) * apart, x[1] + (j == 1) * apart, up);
            sf_second_cusp_at(&second, x[0] - (j == 0) * apart, x[1] - (j == 1) * apart, down);
            by[0][j] = (up[0] - down[0]) / (2 * apart), by[1][j] = (up[1] - down[1]) / (2 * apart);
        }
        determinant = by[0][0] * by[1][1] - by[0][1] * by[1][0];
        step[0] = -(g[0] * by[1][1] - g[1] * by[0][1]) / determinant;
        step[1] = -(g[1] * by[0][0] - g[0] * by[1][0]) / determinant;
        moved = fmax(fabs(step[0]), fabs(step[1]));
        if (!(moved < HUGE_VAL))
            return SF_FAR_SECOND;
        for (j = 0; j < 2; j++)
            x[j] += step[j] * fmin(1, SF_LONGEST / moved);
    }
    Omega = exp(x[0]), A = exp(x[1]);
    if (!(moved <= SF_DONE && fabs(x[0] - from[0]) <= SF_SMALL && fabs(x[1] - from[1]) <= SF_SMALL))
        return SF_FAR_SECOND;
    sf_second_known(model, 1, &A, k);
    second_approximation_detachment(Omega, A, model->m, model->zeta, k[0], k[1], k[2], k[4], k[5], k[6], k[8], k[9],
                                    k[10], balance);
    out->F_SN = balance[0];
    if (!(fabs(log(out->F_SN / first->F_SN)) <= SF_SMALL && sf_second_is_small(&second, Omega, A)))
        return SF_FAR_SECOND;
    out->Omega = Omega, out->A = A, out->kind = SF_CUSP_KIND, out->rest = first->rest;
    *u_max = balance[1];
    return SF_OK_SECOND;
}

/* A at which the largest displacement is u at a frequency: above it by what friction's harmonics take off; and the
 * forcing, u_max and what vanishes where the forcing is least. */
static double sf_second_reaching(const sf_model *model, double u, double Omega, double balance[3]) {
    double A = u;
    int i;
    for (i = 0; i < SF_STEPS; i++) {
        double k[SF_KNOWN];
        sf_second_known(model, 1, &A, k);
        second_approximation_detachment(Omega, A, model->m, model->zeta, k[0], k[1], k[2], k[4], k[5], k[6], k[8], k[9],
                                        k[10], balance);
        if (fabs(u / balance[1] - 1) <= SF_ROUNDING)
            break;
        A *= u / balance[1];
    }
    return A;
}

typedef struct {
    const sf_model *model;
    double u;
} sf_second_reach;

static double sf_turning_at(const void *given, double Omega) {
    const sf_second_reach *reach = given;
    double balance[3];
    sf_second_reaching(reach->model, reach->u, Omega, balance);
    return balance[2];
}

/* The lowest forcing whose largest displacement is u_cr; no iteration over A and Omega at once: next to u_cr, above
 * which the harmonics change, it gets stuck. */
static sf_second_status sf_second_detach(const sf_model *model, double F_first, double Omega_first, double u_cr,
                                         double *F_cr, double *Omega_cr) {
    const sf_second_reach reach = {model, u_cr};
    const sf_second second = {model, F_first, SF_EVERY_POINT};
    int i;
    if (Omega_first == 0)
        return SF_STATIC_SECOND;
    for (i = 10; i >= 0; i--) {
        const double width = ldexp(SF_SMALL, -i), low = Omega_first * exp(-width), high = Omega_first * exp(width);
        const double f_low = sf_turning_at(&reach, low), f_high = sf_turning_at(&reach, high);
        double balance[3], A;
        if (!(f_low < 0 && f_high > 0))
            continue;
        *Omega_cr = sf_zero_between(sf_turning_at, &reach, low, f_low, high, f_high, 0x1p-46);
        A = sf_second_reaching(model, u_cr, *Omega_cr, balance);
        *F_cr = balance[0];
        /* without damping it is nought to rounding */
        if (fabs(A / u_cr - 1) < SF_SMALL && fabs(*F_cr - F_first) < SF_SMALL * F_first + SF_DONE * u_cr &&
            sf_second_is_small(&second, *Omega_cr, A))
            return SF_OK_SECOND;
    }
    return SF_FAR_SECOND;
}

/* What vanishes where u_max is largest along the curve, by frequency; near a peak A hardly depends on that. */
typedef struct {
    const sf_second *second;
    double A;
} sf_second_near;

static double sf_amplitude_near(const sf_second_near *near, double Omega, double balance[3]) {
    double A = near->A, step = HUGE_VAL, k[SF_KNOWN];
    int i;
    for (i = 0; i < SF_STEPS && fabs(step) > SF_DONE; i++) {
        sf_balance at;
        sf_second_at(near->second, Omega, A, &at);
        step = sf_clipped(at.F / (at.F_A * A));
        A *= sf_grown(-step);
    }
    sf_second_known(near->second->model, 1, &A, k);
    second_approximation_detachment(Omega, A, near->second->model->m, near->second->model->zeta, k[0], k[1], k[2], k[4],
                                    k[5], k[6], k[8], k[9], k[10], balance);
    return fabs(step) <= SF_DONE ? A : NAN;
}

static double sf_turning_near(const void *given, double Omega) {
    double balance[3];
    sf_amplitude_near(given, Omega, balance);
    return balance[2];
}

/* The highest peak of a curve; `far` where there is none between its points. */
static sf_second_status sf_peak_on(const sf_model *model, double F_0, const sf_second_curve *curve,
                                   sf_second_point *out) {
    const sf_second here = {model, F_0, SF_EVERY_POINT}, *second = &here;
    sf_second_near near = {second, 0};
    const sf_second_point *top = NULL, *low, *high;
    double f_low, f_high, balance[3];
    long i;
    for (i = 1; i + 1 < curve->n; i++)
        if (curve->point[i - 1].part == curve->point[i + 1].part &&
            (top == NULL || curve->point[i].at.u_max > top->at.u_max))
            top = &curve->point[i];
    if (top == NULL || !(top->at.u_max >= top[-1].at.u_max && top->at.u_max >= top[1].at.u_max))
        return SF_FAR_SECOND;
    low = top[-1].Omega < top[1].Omega ? top - 1 : top + 1, high = low == top - 1 ? top + 1 : top - 1;
    near.A = top->A;
    f_low = sf_turning_near(&near, low->Omega), f_high = sf_turning_near(&near, high->Omega);
    if (!(low->Omega < high->Omega && sf_opposite(f_low, f_high) && f_low == f_low && f_high == f_high))
        return SF_FAR_SECOND;
    out->Omega = sf_zero_between(sf_turning_near, &near, low->Omega, f_low, high->Omega, f_high, 0x1p-46);
    out->A = sf_amplitude_near(&near, out->Omega, balance);
    if (!(out->A > 0))
        return SF_FAR_SECOND;
    sf_second_at(second, out->Omega, out->A, &out->at);
    return SF_OK_SECOND;
}

#endif
