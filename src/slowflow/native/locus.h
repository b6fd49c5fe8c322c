/* The fold locus and its level crossings: in go a model and a range of A, out come arcs, folds, cusps, isola points.
 *
 * Between neighbouring stations (cusps, isola points, turning points, ends at Omega = 0, breakpoints) the number of
 * branches is constant, and along each branch Omega and the level F_0 are monotone. So a branch has a fold at F_0 there
 * if and only if its ends lie on both sides of F_0.
 */
#ifndef SF_LOCUS_H
#define SF_LOCUS_H

#include "scan.h"
#include "work.h"

/* The last Omega > 0 at which sqrt(R^2 + I^2) is stationary, its minimum over Omega > 0; 0 if there is none. */
static double sf_last_stationary(const sf_model *model, const sf_sample *at) {
    double w[2];
    const int n = sf_peak_roots(at->A, at->h, model->m, model->zeta, w);
    return n > 0 ? w[n - 1] : 0;
}

/* The lowest F_0 for which A is a steady state: the minimum over Omega >= 0 of sqrt(R^2 + I^2), and where it lies. */
static double sf_least_forcing(const sf_model *model, const sf_sample *at, double *Omega) {
    const double last = sf_last_stationary(model, at);
    const double at_rest = sf_level(model, at, 0), level = sf_level(model, at, last);
    *Omega = level < at_rest ? last : 0;
    return level < at_rest ? level : at_rest;
}

/* An amplitude above that of every steady state at F_0 or less, for zeta > 0. I <= F_0 limits A Omega, and with it the
 * restoring force that R <= F_0 leaves: |h| <= F_0 + (A Omega)^2/A. That has to fail on every rung of a ladder of
 * amplitudes from the bound on, and h has to keep its sign there: where it changes, |h| is small on the way. */
static sf_status sf_amplitude_bound(const sf_model *model, double F_0, double *A_max) {
    const double c = slow_flow_limit_envelope(1, F_0, model->m, model->zeta);
    double A = fmax(1e-6, F_0), h[2];
    int i, holds = 0, was_positive = 0;
    for (i = 0; i < model->breaks; i++)
        A = fmax(A, 2 * model->b[i]);
    *A_max = A;
    for (i = 0; i < SF_RUNGS; i++) {
        const double next = A * (i < SF_FINE_RUNGS ? 2 : 16);
        model->mechanism->averaged_2(1, &A, model->p, h);
        if (i > 0 && (h[0] > 0) != was_positive)
            *A_max = A;
        was_positive = h[0] > 0;
        holds = !(fabs(h[0]) > 1.01 * F_0 + c * (c / A));
        if (holds)
            *A_max = next;
        A = next;
    }
    return holds ? SF_NO_BOUND : SF_OK;
}

/* Where to stop at F_0: above every steady state, or, undamped, at the mechanism's reach or a multiple of F_0. */
static sf_status sf_range(const sf_model *model, double F_0, double *A_max) {
    if (model->zeta > 0)
        return sf_amplitude_bound(model, F_0, A_max);
    *A_max = model->mechanism->reach;
    if (!(*A_max < HUGE_VAL)) {
        *A_max = 100 * F_0;
        if (model->breaks > 0)
            *A_max = fmax(*A_max, 2 * model->b[model->breaks - 1]);
    }
    return SF_OK;
}

/* ==== Roots of the two quartics along A ============================================================================ */

static int sf_fold_count(const sf_model *model, const sf_sample *at) {
    sf_isolated q;
    if (model->zeta == 0) /* the factor R = 0 is the backbone, at the level m */
        return at->h_A < 0;
    sf_isolate_fold(&q, at->A, at->h, at->h_A, model->m, model->zeta);
    return sf_count(&q);
}

static double sf_fold_branch(const sf_model *model, const sf_sample *at, int count, int index) {
    sf_isolated q;
    if (model->zeta == 0)
        return slow_flow_zeta0_undamped_Omega(fmin(at->h_A, 0));
    sf_isolate_fold(&q, at->A, at->h, at->h_A, model->m, model->zeta);
    return sf_wanted_root(&q, count, index);
}

static int sf_response_count(const sf_model *model, const sf_sample *at, double F_0) {
    sf_isolated q;
    sf_isolate_response(&q, at->A, at->h, model->m, model->zeta, F_0);
    return sf_count(&q);
}

static double sf_response_branch(const sf_model *model, const sf_sample *at, double F_0, int count, int index) {
    sf_isolated q;
    sf_isolate_response(&q, at->A, at->h, model->m, model->zeta, F_0);
    return sf_wanted_root(&q, count, index);
}

/* ==== Arcs between events ========================================================================================== */

typedef struct {
    const sf_model *model;
    double F_0; /* < 0 for the fold locus */
} sf_curve;

static int sf_count_at(const sf_curve *curve, double A) {
    sf_sample at;
    sf_sample_at(curve->model, A, &at);
    return curve->F_0 < 0 ? sf_fold_count(curve->model, &at) : sf_response_count(curve->model, &at, curve->F_0);
}

static double sf_branch_at(const sf_curve *curve, const sf_sample *at, int count, int index) {
    return curve->F_0 < 0 ? sf_fold_branch(curve->model, at, count, index)
                          : sf_response_branch(curve->model, at, curve->F_0, count, index);
}

/* The number of roots in each interval; where one is too narrow to hold an amplitude, the event's gain tells. */
static void sf_count_intervals(const sf_curve *curve, sf_graph *graph) {
    int k;
    for (k = 0; k + 1 < graph->events; k++) {
        const double low = graph->event[k].A, high = graph->event[k + 1].A, middle = 0.5 * (low + high);
        if (middle > low + 0x1p-51 * low && middle < high)
            graph->count[k] = sf_count_at(curve, middle);
        else if (k > 0 && graph->event[k].kind != SF_CUT)
            graph->count[k] = graph->count[k - 1] + graph->event[k].gain;
        else /* next to a breakpoint, or between its two sides */
            graph->count[k] = graph->event[k + 1].kind == SF_CUT ? 0 : sf_count_at(curve, low);
        if (graph->count[k] < 0 || graph->count[k] > 3) {
            graph->status = SF_UNRESOLVED;
            graph->count[k] = 0;
        }
    }
}

/* Arcs that end at an event, each with the Omega that it has there. */
static void sf_end_all(const sf_curve *curve, sf_graph *graph, const sf_sample *at, int interval, int end) {
    int i;
    for (i = 0; i < graph->count[interval]; i++)
        sf_end(graph, graph->first[interval] + i, end, at->A,
               sf_branch_at(curve, at, graph->count[interval], i));
}

/* Which two of the roots meet at A, the lower pair or the upper, and where: as the event says, or, where it is none of
 * these but roots vanish all the same (a breakpoint that is an extremum to rounding), by the critical value next to 0. */
static int sf_lower_pair(const sf_curve *curve, const sf_event *event, const sf_sample *at, double *Omega) {
    const sf_model *model = curve->model;
    sf_isolated q;
    int lower;
    *Omega = event->Omega;
    if (event->kind == SF_PAIR_LOW || event->kind == SF_PAIR_HIGH)
        return event->kind == SF_PAIR_LOW;
    if (curve->F_0 < 0)
        sf_isolate_fold(&q, at->A, at->h, at->h_A, model->m, model->zeta);
    else
        sf_isolate_response(&q, at->A, at->h, model->m, model->zeta, curve->F_0);
    lower = q.w1 > 0 && fabs(q.f1) < fabs(q.f2);
    *Omega = lower ? q.w1 : q.w2;
    return lower;
}

/* Event k, between intervals k - 1 and k: arcs of the richer side end, all others go on. */
static void sf_link(const sf_curve *curve, sf_graph *graph, int k) {
    const sf_event *event = &graph->event[k];
    const int left = graph->count[k - 1], right = graph->count[k];
    const int rich = left >= right ? k - 1 : k, poor = left >= right ? k : k - 1;
    const int rich_end = left >= right, lost = graph->count[rich] - graph->count[poor];
    const int first_rich = graph->first[rich], first_poor = graph->first[poor];
    int gone = 0, i; /* index of the first arc of the richer side that does not go on */
    sf_sample at;
    sf_sample_at(curve->model, event->A, &at);
    if (event->kind == SF_CUT) {
        sf_end_all(curve, graph, &at, k - 1, 1);
        sf_end_all(curve, graph, &at, k, 0);
        return;
    }
    if (lost % 2 == 1)
        sf_end(graph, first_rich, rich_end, event->A, 0);
    if (lost >= 2) {
        double Omega;
        const int lower = sf_lower_pair(curve, event, &at, &Omega) && lost == 2;
        const int pair = lower ? first_rich : first_rich + graph->count[rich] - 2;
        gone = lower || lost == 3 ? 0 : graph->count[rich] - 2;
        sf_end(graph, pair, rich_end, event->A, Omega);
        sf_end(graph, pair + 1, rich_end, event->A, Omega);
        sf_meet(graph, pair, rich_end, pair + 1, rich_end);
    }
    for (i = 0; i < graph->count[poor]; i++) {
        const int other = first_rich + (i < gone ? i : i + lost);
        const double Omega = sf_branch_at(curve, &at, graph->count[poor], i);
        sf_end(graph, first_poor + i, 1 - rich_end, event->A, Omega);
        sf_end(graph, other, rich_end, event->A, Omega);
        sf_meet(graph, first_poor + i, 1 - rich_end, other, rich_end);
    }
}

static void sf_trace_arcs(const sf_curve *curve, sf_graph *graph) {
    sf_sample at;
    int k;
    sf_count_intervals(curve, graph);
    sf_make_arcs(graph);
    if (graph->events < 2)
        return;
    for (k = 1; k + 1 < graph->events; k++)
        sf_link(curve, graph, k);
    if (graph->event[0].A > 0) {
        sf_sample_at(curve->model, graph->event[0].A, &at);
        sf_end_all(curve, graph, &at, 0, 0);
    } else { /* the response comes from A = 0, Omega = inf */
        for (k = 0; k < graph->count[0]; k++)
            sf_end(graph, k, 0, 0, HUGE_VAL);
    }
    sf_sample_at(curve->model, graph->event[graph->events - 1].A, &at);
    sf_end_all(curve, graph, &at, graph->events - 2, 1);
}

/* ==== The fold locus =============================================================================================== */

/* All samples up to A_max: one chart for each piece of the force; returns their number, or -1. */
static int sf_charts(const sf_model *model, double F_0, double A_max, sf_nodes *chart, sf_status *status) {
    int n = 0, i;
    const double end = model->breaks > 0 && model->b[0] < A_max ? model->b[0] : A_max;
    *status = sf_nodes_from_zero(model, F_0, end, &chart[n++]);
    for (i = 0; i < model->breaks && model->b[i] < A_max && *status == SF_OK; i++) {
        const double last = i + 1 < model->breaks && model->b[i + 1] < A_max ? model->b[i + 1] : A_max;
        *status = sf_nodes_above(model, model->b[i], last, &chart[n++]);
    }
    return n;
}

static void sf_locus_zeros(const sf_model *model, const sf_nodes *nodes, sf_zeros *found) {
    found->n = 0, found->status = SF_OK;
    sf_find_zeros(model, SF_STIFFNESS, 0, nodes, found);
    if (model->zeta == 0) {
        sf_find_zeros(model, SF_UNDAMPED, 0, nodes, found);
    } else {
        sf_find_zeros(model, SF_ISOLA, 0, nodes, found);
        sf_find_zeros(model, SF_CUSP, 0, nodes, found);
        sf_find_zeros(model, SF_TURN, 0, nodes, found);
    }
    sf_sort_zeros(found);
}

static sf_event_kind sf_locus_event(const sf_zero *zero) {
    if (zero->question == SF_STIFFNESS)
        return SF_TO_ZERO;
    if (zero->question == SF_TURN)
        return zero->channel == 0 ? SF_PAIR_LOW : SF_PAIR_HIGH;
    return SF_THROUGH;
}

/* By how much the number of roots changes at a turning point: where a maximum of F_A over Omega rises above zero a pair
 * is born. */
static int sf_locus_gain(const sf_zero *zero) {
    if (zero->question != SF_TURN)
        return 0;
    return zero->rising == (zero->channel == 0) ? 2 : -2;
}

/* The locus up to A_max in work, with its cusps and isola points, on samples that also serve for the response at F_0,
 * or, with F_0 = 0, for none. */
static sf_status sf_fold_locus(const sf_model *model, double F_0, double A_max, sf_work *work) {
    const sf_curve curve = {model, -1};
    sf_status status;
    int i, k;
    const int charts = sf_charts(model, F_0, A_max, work->chart, &status);
    sf_graph *graph = &work->locus;
    graph->events = 0, graph->status = SF_OK;
    work->extrema.n = 0, work->extrema.status = SF_OK;
    work->charts = charts;
    if (status != SF_OK)
        return status;
    for (i = 0; i < charts; i++) {
        const sf_nodes *nodes = &work->chart[i];
        sf_locus_zeros(model, nodes, &work->zeros);
        sf_add_event(graph, nodes->at[0].A, 0, SF_CUT, 0);
        for (k = 0; k < work->zeros.n; k++) {
            const sf_zero *zero = &work->zeros.at[k];
            sf_add_event(graph, zero->A, zero->Omega, sf_locus_event(zero), sf_locus_gain(zero));
            if (zero->question == SF_CUSP || zero->question == SF_ISOLA || zero->question == SF_UNDAMPED)
                sf_add_zero(&work->extrema, zero->A, zero->Omega, zero->question, zero->channel, zero->rising);
        }
        sf_add_event(graph, nodes->at[nodes->n - 1].A, 0, SF_CUT, 0);
        if (work->zeros.status != SF_OK)
            return work->zeros.status;
    }
    sf_merge_events(graph);
    if (graph->status == SF_OK)
        sf_trace_arcs(&curve, graph);
    return graph->status;
}

/* Newton on F = F_A = 0 with residuals in double-double; whether it came to rest inside the box. */
static int sf_polish_fold(const sf_model *model, double F_0, const double A_range[2], const double w_range[2],
                             double *w, double *A) {
    double last = HUGE_VAL;
    int i;
    for (i = 0; i < 8; i++) {
        sf_quartic s;
        sf_sample at;
        double F, F_A, F_AA, F_Omega, F_AOmega, determinant, step_A, step_w, moved;
        sf_sample_at(model, *A, &at);
        s.A = *A, s.h = at.h, s.h_A = at.h_A, s.m = model->m, s.zeta = model->zeta, s.F_0 = F_0;
        s.kind = SF_RESPONSE;
        F = sf_value_fine(&s, *w);
        s.kind = SF_FOLD;
        F_A = 2 * sf_value_fine(&s, *w);
        F_AA = 2 * sf_half_F_AA(model, &at, *w);
        F_Omega = sf_F_Omega(model, &at, *w);
        F_AOmega = 4 * sf_quarter_F_AOmega(model, &at, *w);
        determinant = F_A * F_AOmega - F_Omega * F_AA;
        step_A = (F_Omega * F_A - F_AOmega * F) / determinant;
        step_w = (F_AA * F - F_A * F_A) / determinant;
        moved = fabs(step_A) / *A + fabs(step_w) / *w;
        if (!(moved < 0.1) || (moved > 0.5 * last && last > 1e-13))
            return 0;
        if (moved > 0.5 * last) /* only rounding is left */
            return 1;
        *A += step_A, *w += step_w;
        if (!(*A >= A_range[0] && *A <= A_range[1] && *w >= w_range[0] * (1 - 0x1p-48) &&
              *w <= w_range[1] * (1 + 0x1p-48)))
            return 0;
        if (moved <= 0x1p-52)
            return 1;
        last = moved;
    }
    return last <= 1e-13;
}

static void sf_order(double range[2], double a, double b) {
    range[0] = fmin(a, b);
    range[1] = fmax(a, b);
}

/* Omega from F = 0: at a fold it does not depend on A to first order. The locus's Omega does, and next to a breakpoint so
 * steeply that an A known to its last place leaves it open. w_range says where to look. */
static sf_point sf_settled_fold(const sf_model *model, double F_0, const double w_range[2], sf_point found) {
    double w[3], nearest = HUGE_VAL;
    sf_sample at;
    int i, n, place = 0;
    sf_sample_at(model, found.A, &at);
    n = sf_response_roots(at.A, at.h, model->m, model->zeta, F_0, w);
    if (n == 0) /* beyond the tip of the curve by rounding: Omega from F_A = 0 after all */
        n = sf_fold_roots(at.A, at.h, at.h_A, model->m, model->zeta, w);
    for (i = 0; i < n; i++) {
        const double off = fmax(w_range[0] - w[i], fmax(w[i] - w_range[1], 0));
        if (off < nearest)
            nearest = off, place = i;
    }
    if (n > 0)
        found.Omega = w[place];
    return found;
}

/* The fold at F_0 on an arc of the locus whose ends lie on both sides of it. */
static sf_point sf_crossing(const sf_model *model, double F_0, const sf_arc *arc, const double level[2]) {
    const int rising = level[0] < F_0;
    double lo = arc->A[0], hi = arc->A[1], w_lo = arc->Omega[0], w_hi = arc->Omega[1], last = hi - lo;
    double A = lo + (hi - lo) * ((F_0 - level[0]) / (level[1] - level[0]));
    double w_range[2];
    sf_point found;
    int i;
    found.A = lo, found.Omega = w_lo;
    for (i = 0; i < 200; i++) {
        sf_sample at;
        double w, y, slope, next, moved;
        if (!(A > lo && A < hi)) {
            A = 0.5 * (lo + hi);
            if (!(A > lo && A < hi))
                break;
        }
        sf_sample_at(model, A, &at);
        w = sf_fold_branch(model, &at, arc->count, arc->index);
        y = sf_level(model, &at, w) - F_0;
        found.A = A, found.Omega = w;
        if ((y < 0) == rising)
            lo = A, w_lo = w;
        else
            hi = A, w_hi = w;
        slope = -sf_F_Omega(model, &at, w) * sf_half_F_AA(model, &at, w) /
                (4 * sf_quarter_F_AOmega(model, &at, w) * (y + F_0));
        next = A - y / slope;
        moved = fabs(next - A);
        if (moved < 0.01 * A || hi - lo < 1e-3 * A) {
            sf_point try = found;
            double A_range[2];
            A_range[0] = lo, A_range[1] = hi;
            sf_order(w_range, w_lo, w_hi);
            if (sf_polish_fold(model, F_0, A_range, w_range, &try.Omega, &try.A)) {
                w_range[0] = w_range[1] = try.Omega;
                return sf_settled_fold(model, F_0, w_range, try);
            }
        }
        if (moved > 0.6 * last)
            next = 0.5 * (lo + hi);
        last = fabs(next - A);
        A = next;
    }
    sf_order(w_range, w_lo, w_hi);
    return sf_settled_fold(model, F_0, w_range, found);
}

/* ==== Folds at a forcing =========================================================================================== */

static void sf_add_fold(sf_folds *folds, double Omega, double A, int up, int corner) {
    int i;
    if (folds->n == SF_MOST_FOLDS) {
        folds->status = SF_TOO_MANY;
        return;
    }
    for (i = folds->n++; i > 0 && folds->at[i - 1].Omega > Omega; i--)
        folds->at[i] = folds->at[i - 1];
    folds->at[i].Omega = Omega, folds->at[i].A = A, folds->at[i].up = up, folds->at[i].corner = corner;
}

/* Folds on a breakpoint where the force jumps: F_A changes its sign between b and the next amplitude, without a zero. */
static void sf_corner_folds(const sf_model *model, double F_0, double A_max, sf_folds *folds) {
    int k, i, n;
    for (k = 0; k < model->breaks; k++) {
        sf_sample at, above;
        double w[3];
        if (model->jump[k] == 0 || !(model->b[k] < A_max))
            continue;
        sf_sample_at(model, model->b[k], &at);
        sf_sample_at(model, nextafter(model->b[k], HUGE_VAL), &above);
        n = sf_response_roots(at.A, at.h, model->m, model->zeta, F_0, w);
        for (i = 0; i < n; i++) {
            const int stable_below = sf_half_F_A(model, &at, w[i]) > 0;
            if (stable_below != (sf_half_F_A(model, &above, w[i]) > 0))
                sf_add_fold(folds, w[i], at.A, stable_below, 1);
        }
    }
}

/* Every fold at F_0 > m, by rising Omega, from a locus that reaches A_max. */
static void sf_folds_at(const sf_model *model, double F_0, double A_max, const sf_graph *locus, sf_folds *folds) {
    int i, end;
    folds->n = 0, folds->status = SF_OK;
    for (i = 0; i < locus->arcs; i++) {
        const sf_arc *arc = &locus->arc[i];
        double level[2];
        for (end = 0; end < 2; end++) {
            sf_sample at;
            sf_sample_at(model, arc->A[end], &at);
            level[end] = sf_level(model, &at, arc->Omega[end]);
        }
        if (sf_opposite(level[0] - F_0, level[1] - F_0)) {
            /* leaving a fold, a sweep goes the way of the saddle: up where the stable branch lies below it */
            const sf_point at = sf_crossing(model, F_0, arc, level);
            sf_sample sample;
            sf_sample_at(model, at.A, &sample);
            sf_add_fold(folds, at.Omega, at.A, sf_half_F_AA(model, &sample, at.Omega) < 0, 0);
        }
    }
    sf_corner_folds(model, F_0, A_max, folds);
}

static sf_status sf_saddle_nodes(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    sf_status status;
    folds->n = 0;
    if (sf_sticks(model, F_0))
        return SF_STICKS;
    status = sf_range(model, F_0, &work->A_max);
    if (status == SF_OK)
        status = sf_fold_locus(model, F_0, work->A_max, work);
    if (status != SF_OK)
        return status;
    sf_folds_at(model, F_0, work->A_max, &work->locus, folds);
    return folds->status;
}

/* ==== The locus itself ============================================================================================= */

/* One Newton step on F_A = F_AA = 0, with the residual of F_A in double-double. */
static void sf_polish_cusp(const sf_model *model, double *w, sf_sample *at) {
    sf_quartic s;
    double f, g, a, b, c, d, determinant, step_w, step_A;
    s.kind = SF_FOLD;
    s.A = at->A, s.h = at->h, s.h_A = at->h_A, s.m = model->m, s.zeta = model->zeta, s.F_0 = 0;
    f = sf_value_fine(&s, *w), g = sf_half_F_AA(model, at, *w);
    a = 2 * sf_quarter_F_AOmega(model, at, *w), b = g;
    c = sf_half_F_AAOmega(model, at, *w), d = sf_half_F_AAA(at, *w);
    determinant = a * d - b * c;
    step_w = (g * b - f * d) / determinant;
    step_A = (f * c - g * a) / determinant;
    if (!(fabs(step_w) < 1e-6 * *w && fabs(step_A) < 1e-6 * at->A))
        return;
    *w += step_w;
    sf_sample_at(model, at->A + step_A, at);
}

/* A positive multiple of F_AA F_OmegaOmega - F_AOmega^2. */
static double sf_hessian(const sf_model *model, const sf_sample *at, double w) {
    const double F_AOmega = sf_quarter_F_AOmega(model, at, w);
    return sf_quarter_F_OmegaOmega(model, at, w) * sf_half_F_AA(model, at, w) - 2 * F_AOmega * F_AOmega;
}

/* Whether the level has a minimum along the fold locus at a cusp or an isola point, from its second derivative. */
static int sf_is_minimum(const sf_model *model, sf_question question, const sf_sample *at, double w) {
    if (question != SF_ISOLA)
        return sf_F_Omega(model, at, w) / at->A * sf_half_F_AAA(at, w) * sf_quarter_F_AOmega(model, at, w) < 0;
    return sf_half_F_AA(model, at, w) * sf_hessian(model, at, w) > 0;
}

static sf_extremum sf_extremum_at(const sf_model *model, const sf_zero *zero) {
    sf_extremum out;
    sf_sample at;
    out.Omega = zero->Omega;
    sf_sample_at(model, zero->A, &at);
    if (zero->question == SF_CUSP)
        sf_polish_cusp(model, &out.Omega, &at);
    out.A = at.A;
    out.F_0 = sf_level(model, &at, out.Omega);
    out.minimum = sf_is_minimum(model, zero->question, &at, out.Omega);
    out.saddle = zero->question == SF_ISOLA && sf_hessian(model, &at, out.Omega) < 0;
    out.isola = zero->question == SF_ISOLA;
    return out;
}

static double sf_locus_weight(const sf_arc *arc, double A_max) {
    return fabs(arc->Omega[1] / (1 + arc->Omega[1]) - arc->Omega[0] / (1 + arc->Omega[0])) +
           (arc->A[1] - arc->A[0]) / A_max + 1e-3;
}

/* About `samples` points along the locus in work, in order along each branch; returns their number, and with Omega NULL
 * only that. */
static long sf_draw_locus(const sf_model *model, long samples, sf_work *work, double *Omega, double *A, double *F_0,
                             long long *branch) {
    const sf_graph *locus = &work->locus;
    double total = 0;
    long n = 0;
    int c, i, k;
    sf_make_tour(locus, &work->tour);
    for (i = 0; i < locus->arcs; i++)
        total += sf_locus_weight(&locus->arc[i], work->A_max);
    for (c = 0; c < work->tour.curves; c++)
        for (i = work->tour.start[c]; i < work->tour.start[c + 1]; i++) {
            const int upward = work->tour.step[i] % 2, last = i + 1 == work->tour.start[c + 1];
            const sf_arc *arc = &locus->arc[work->tour.step[i] / 2];
            const int steps = (int)ceil((double)samples * sf_locus_weight(arc, work->A_max) / total);
            for (k = 0; k < steps + last; k++, n++) {
                const double share = 0.5 - 0.5 * cos(3.14159265358979312 * (upward ? k : steps - k) / steps);
                const int end = k == 0 ? 1 - upward : upward;
                sf_sample at;
                if (Omega == NULL)
                    continue;
                A[n] = k == 0 || k == steps ? arc->A[end] : arc->A[0] + (arc->A[1] - arc->A[0]) * share;
                sf_sample_at(model, A[n], &at);
                Omega[n] = k == 0 || k == steps ? arc->Omega[end]
                                                : sf_fold_branch(model, &at, arc->count, arc->index);
                F_0[n] = sf_level(model, &at, Omega[n]);
                branch[n] = c;
            }
        }
    return n;
}

#endif
