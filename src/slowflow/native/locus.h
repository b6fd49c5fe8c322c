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

/* The last Omega > 0 at which the level is stationary, its minimum over Omega > 0; 0 if there is none. */
static double sf_last_stationary(const sf_model *model, const sf_sample *at) {
    sf_quartic cubic;
    double w[2];
    int n;
    if (sf_inertial(model)) {
        const double x = sf_least_x(model, at);
        return x > 0 ? 1 / x : 0;
    }
    n = sf_unpolished_peak_roots(&cubic, at->A, at->h, model->m, model->zeta, w);
    return n > 0 ? sf_polish_cubic(&cubic, w[n - 1]) : 0;
}

/* The lowest F_0 for which A is a steady state: the minimum of its level over Omega >= 0, and where it lies. */
static double sf_least_forcing(const sf_model *model, const sf_sample *at, double *Omega) {
    const double last = sf_last_stationary(model, at);
    const double at_rest = sf_level(model, at, 0), level = sf_level(model, at, last);
    *Omega = level < at_rest ? last : 0;
    return level < at_rest ? level : at_rest;
}

/* Whether no amplitude from A on is that of a steady state at F_0 or less: |h| is too large. Beyond the last breakpoint
 * h is followed to where it has no bound in doubles: there |h| must rise. */
static int sf_bounds(const sf_model *model, double F_0, double A) {
    sf_sample at, far;
    sf_known here, there;
    sf_cell cell;
    sf_sample_without_k_at(model, A, &at);
    if (!(fabs(at.h) > slow_flow_most_restoring(A, F_0, model->m, model->zeta)))
        return 0;
    sf_sample_without_k_at(model, SF_ENDLESS * fmax(A, 1), &far);
    sf_know(&at, &here);
    sf_know(&far, &there);
    sf_make_slopes(model, &at, &far, &here, &there, &cell);
    return at.h > 0 ? cell.h_A.lo >= 0 : cell.h_A.hi <= 0;
}

/* Whether h lies, on amplitudes from A on, where no state at F_0 can have it. most: what |h| is at most in one at A */
static int sf_excludes(const sf_model *model, double F_0, double most, double A, sf_interval h) {
    double values[4];
    if (!sf_inertial(model))
        return h.lo > most || h.hi < -most;
    /* of all states above F_0 zeta^2 A is half of |h| at most */
    inertia_bound(A, F_0, model->zeta, h.lo, 0, 0, 0, 0.5, values);
    return A > F_0 && values[0] > 0;
}

/* The same where it is h that is known between two amplitudes: up to the reach, or an endless amplitude. */
static int sf_bounds_bent(const sf_model *model, double F_0, double A) {
    const double most = slow_flow_most_restoring(A, F_0, model->m, model->zeta);
    const double end = fmin(model->reach, SF_ENDLESS * fmax(A, 1));
    double next;
    int i;
    if (!(A < end))
        return 0;
    for (; A < end; A = next) {
        sf_interval bent[2];
        next = fmin(2 * A, end);
        for (i = model->breaks - 1; i >= 0; i--)
            if (A < model->b[i] && model->b[i] < next)
                next = model->b[i];
        model->mechanism->bent(sfi_of(A, next), model->p, bent);
        if (!sf_excludes(model, F_0, most, A, bent[0]))
            return 0;
    }
    return 1;
}

/* Whether an excitation by inertia has no state above F_0 from A on: what excludes states at an amplitude is positive
 * on all that follow if its slopes are; the third is a sum of h_AAA, which is monotone, and of a number. */
static int sf_inertial_bounds(const sf_model *model, double F_0, double A) {
    sf_sample at, far;
    double lost[2] = {0.5, 0.5}, values[4];
    int i;
    sf_sample_at(model, A, &at);
    sf_sample_at(model, SF_ENDLESS * fmax(A, 1), &far);
    /* zeta^2 A is at most so much of |h|: of all states half of it, and less where |h|/A is known to rise */
    if (at.k >= 0 && at.h_AA <= 0 && fmax(at.h_AAA, far.h_AAA) <= 0 && at.h < 0)
        lost[1] = fmin(inertia_share(A, model->zeta, at.h), 0.5);
    for (i = 0; i < 2; i++) {
        inertia_bound(A, F_0, model->zeta, at.h, at.h_A, at.h_AA, fmin(at.h_AAA, far.h_AAA), lost[i], values);
        if (values[0] > 0 && values[1] > 0 && values[2] > 0 && values[3] > 0)
            return 1;
    }
    return 0;
}

/* Whether the spring is far from its slope at rest, and an amplitude that is much less is reached: where a response is
 * cut that does not close. */
static int sf_is_far(const sf_model *model, double F_0, double A) {
    sf_sample at, rest, less;
    sf_sample_at(model, A, &at);
    sf_sample_at(model, 0, &rest);
    sf_sample_at(model, A / SF_STATIC_MULTIPLE, &less);
    /* the slope at rest and what zeta^2 A is of |h|, as shares of |h|/A */
    const double shares = at.h < 0 ? -fabs(rest.h_A) * A / at.h + inertia_share(A, model->zeta, at.h) : HUGE_VAL;
    return SF_STATIC_MULTIPLE * shares <= 1 && less.A > F_0 &&
           sf_inertial_count(model, &less, F_0) == 2;
}

/* The reach of a mechanism, where nothing bounds the response below it: SF_UNBOUNDED if it goes beyond. */
static sf_status sf_cut_at_reach(const sf_model *model, double F_0, double *A_max) {
    sf_isolated q;
    sf_sample at;
    *A_max = model->reach;
    sf_sample_at(model, *A_max, &at);
    sf_isolate_response(&q, at.A, at.h, model->m, model->zeta, F_0);
    return sf_count(&q) > 0 ? SF_UNBOUNDED : SF_OK;
}

/* An amplitude above that of every steady state at F_0 or less, for zeta > 0, in steps that grow; SF_UNBOUNDED where a
 * response does not close, with an amplitude at which to cut it. */
static sf_status sf_amplitude_bound(const sf_model *model, double F_0, double *A_max) {
    const int bent = model->mechanism->bent != NULL;
    int (*const bounds)(const sf_model *, double, double) =
        bent ? sf_bounds_bent : sf_inertial(model) ? sf_inertial_bounds : sf_bounds;
    double A = F_0, step = 2, cut = model->reach;
    int i;
    if (model->breaks > 0)
        A = fmax(A, 2 * model->b[model->breaks - 1]);
    for (i = 0; i < SF_RUNGS; i++) {
        if (A < HUGE_VAL && bounds(model, F_0, A)) {
            *A_max = A;
            return SF_OK;
        }
        if (sf_inertial(model) && !(cut < HUGE_VAL) && (sf_is_far(model, F_0, A) || i + 1 == SF_RUNGS))
            cut = A;
        A *= step;
        if (i >= SF_FINE_RUNGS && step < SF_COARSEST)
            step *= 2;
    }
    if (bent && !sf_inertial(model) && cut < HUGE_VAL)
        return sf_cut_at_reach(model, F_0, A_max);
    *A_max = cut;
    return sf_inertial(model) ? SF_UNBOUNDED : SF_NO_BOUND;
}

/* Where to stop at F_0: above every steady state, or, undamped, at the mechanism's reach or a multiple of F_0 that is
 * doubled until the fold, whose R is k, has passed F_0 or has ended for good; or, with SF_UNBOUNDED, where a response
 * is cut that does not close. */
static sf_status sf_range_at(const sf_model *model, double F_0, double *A_max) {
    int i;
    if (model->zeta > 0)
        return sf_amplitude_bound(model, F_0, A_max);
    *A_max = model->reach;
    if (*A_max < HUGE_VAL)
        return SF_OK;
    *A_max = SF_STATIC_MULTIPLE * F_0;
    if (model->breaks > 0)
        *A_max = fmax(*A_max, 2 * model->b[model->breaks - 1]);
    for (i = 0; !sf_inertial(model) && i < SF_RUNGS; i++, *A_max *= 2) {
        sf_sample at;
        sf_sample_at(model, *A_max, &at);
        if (at.h_A < 0 ? slow_flow_zeta0_undamped_level(model->m, at.k) > F_0 : at.h_AA >= 0)
            break;
        if (at.h_AA == 0 && at.h_AAA == 0)
            break;
    }
    return SF_OK;
}

/* ==== Roots of the two quartics along A =========================================================================== */

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
    if (sf_inertial(model))
        return sf_inertial_overflows(model, at, F_0) ? -1 : sf_inertial_count(model, at, F_0);
    sf_isolate_response(&q, at->A, at->h, model->m, model->zeta, F_0);
    return sf_count(&q);
}

static double sf_response_branch(const sf_model *model, const sf_sample *at, double F_0, int count, int index) {
    sf_isolated q;
    if (sf_inertial(model))
        return sf_inertial_root(model, at, F_0, count, index);
    sf_isolate_response(&q, at->A, at->h, model->m, model->zeta, F_0);
    return sf_wanted_root(&q, count, index);
}

/* ==== Arcs between events ========================================================================================= */

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

/* Whether the numbers of a response's roots beside an event are not what it makes of them: roots coincide within
 * rounding.
 * Between events that are hardly apart rounding may have changed their order. */
static int sf_contradicts(const sf_curve *curve, const sf_graph *graph, int k) {
    const sf_event *event = &graph->event[k];
    if (k == 0 || curve->F_0 < 0 || event->kind == SF_CUT || event->kind == SF_THROUGH)
        return 0;
    return event->A - event[-1].A > SF_HARDLY * event->A && event[1].A - event->A > SF_HARDLY * event->A &&
           graph->count[k] - graph->count[k - 1] != event->gain;
}

/* The number of roots in each interval; where one is too narrow to hold an amplitude, the event's gain tells. */
static void sf_count_intervals(const sf_curve *curve, sf_graph *graph) {
    int k;
    for (k = 0; k + 1 < graph->events; k++) {
        const double low = graph->event[k].A, high = graph->event[k + 1].A, middle = 0.5 * (low + high);
        if (middle > low + SF_NO_WIDTH * low && middle < high)
            graph->count[k] = sf_count_at(curve, middle);
        else if (k > 0 && graph->event[k].kind != SF_CUT)
            graph->count[k] = graph->count[k - 1] + graph->event[k].gain;
        else /* next to a breakpoint, or between its two sides */
            graph->count[k] = graph->event[k + 1].kind == SF_CUT ? 0 : sf_count_at(curve, low);
        if (graph->count[k] < 0 || graph->count[k] > 3 || sf_contradicts(curve, graph, k)) {
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
 * these but roots vanish all the same (a breakpoint that is an extremum to rounding), by the critical value next to
 * 0. */
static int sf_lower_pair(const sf_curve *curve, const sf_event *event, const sf_sample *at, double *Omega) {
    const sf_model *model = curve->model;
    sf_isolated q;
    int lower;
    *Omega = event->Omega;
    if (event->kind == SF_PAIR_LOW || event->kind == SF_PAIR_HIGH)
        return event->kind == SF_PAIR_LOW;
    if (sf_inertial(model) && curve->F_0 >= 0) {
        *Omega = 1 / sf_least_x(model, at);
        return 0;
    }
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
    if (event->kind == SF_TO_INFINITY && lost == 1) {
        gone = graph->count[poor];
        sf_end(graph, first_rich + gone, rich_end, event->A, HUGE_VAL);
    } else if (lost % 2 == 1) {
        sf_end(graph, first_rich, rich_end, event->A, 0);
    }
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
    if (graph->event[0].A > 0 || curve->F_0 < 0) {
        sf_sample_at(curve->model, graph->event[0].A, &at);
        sf_end_all(curve, graph, &at, 0, 0);
    } else { /* the response comes from A = 0, at one frequency */
        for (k = 0; k < graph->count[0]; k++)
            sf_end(graph, k, 0, 0, graph->event[0].Omega);
    }
    sf_sample_at(curve->model, graph->event[graph->events - 1].A, &at);
    sf_end_all(curve, graph, &at, graph->events - 2, 1);
}

/* ==== The fold locus ============================================================================================== */

static void sf_ask_all(const sf_model *model, sf_question question, double F_0, const sf_stretch *piece,
                       sf_zeros *found) {
    const sf_asked asked = sf_asked_of(question, model, F_0);
    sf_find_zeros(&asked, piece, found);
}

/* undecided: whether rounding may hide some at which the level turns */
static void sf_locus_zeros(const sf_model *model, const sf_stretch *piece, sf_zeros *found) {
    int undecided;
    sf_clear_zeros(found);
    sf_ask_all(model, SF_STIFFNESS, 0, piece, found);
    found->undecided = 0;
    if (model->zeta == 0) {
        sf_ask_all(model, SF_UNDAMPED, 0, piece, found);
    } else {
        sf_ask_all(model, SF_ISOLA, 0, piece, found);
        sf_ask_all(model, SF_CUSP, 0, piece, found);
        undecided = found->undecided;
        sf_ask_all(model, SF_TURN, 0, piece, found);
        found->undecided = undecided;
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

/* The locus up to A_max in work, with its cusps and isola points. */
static sf_status sf_fold_locus(const sf_model *model, double A_max, sf_work *work) {
    const sf_curve curve = {model, -1};
    int i, k;
    sf_graph *graph = &work->locus;
    graph->events = 0, graph->status = SF_OK;
    work->A_max = A_max;
    sf_clear_zeros(&work->extrema);
    sf_stretches_up_to(model, A_max, &work->pieces);
    for (i = 0; i < work->pieces.n; i++) {
        const sf_stretch *piece = &work->pieces.at[i];
        if (!sf_has_force(piece))
            continue;
        sf_locus_zeros(model, piece, &work->zeros);
        sf_add_event(graph, i == 0 ? 0 : nextafter(piece->first.A, HUGE_VAL), 0, SF_CUT, 0);
        for (k = 0; k < work->zeros.n; k++) {
            const sf_zero *zero = &work->zeros.at[k];
            sf_add_event(graph, zero->A, zero->Omega, sf_locus_event(zero), sf_locus_gain(zero));
            if (zero->question == SF_CUSP || zero->question == SF_ISOLA || zero->question == SF_UNDAMPED)
                sf_add_zero(&work->extrema, *zero);
        }
        sf_add_event(graph, piece->last.A, 0, SF_CUT, 0);
        work->extrema.undecided |= work->zeros.undecided;
        if (work->zeros.status != SF_OK)
            return work->zeros.status;
    }
    sf_merge_events(graph);
    if (graph->status == SF_OK)
        sf_trace_arcs(&curve, graph);
    return graph->status;
}

/* ==== Folds at a forcing ========================================================================================== */

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

/* All frequencies at an amplitude, by their size; returns their number. */
static int sf_frequencies(const sf_model *model, const sf_sample *at, double F_0, double Omega[3]) {
    return sf_inertial(model) ? sf_inertial_roots(model, at, F_0, Omega)
                              : sf_response_roots(at->A, at->h, model->m, model->zeta, F_0, Omega);
}

/* Whether a step of Newton's method is all that Omega is off a root of F = 0, which it then becomes. */
static int sf_is_next_to_root(const sf_model *model, double F_0, const sf_sample *at, double *Omega) {
    sf_quartic s;
    double C, D, step;
    if (sf_inertial(model))
        return 0;
    s.kind = SF_RESPONSE;
    s.A = at->A, s.h = at->h, s.h_A = 0, s.m = model->m, s.zeta = model->zeta, s.F_0 = F_0;
    sf_derivative_coefficients(&s);
    C = sf_cubic(&s, *Omega), D = sf_cubic_slope(&s, *Omega), step = sf_value_fine(&s, *Omega) / (s.k * C);
    if (!(fabs(step) <= SF_LAST_STEP * *Omega && fabs(step * D) * fabs(step) <= SF_CORRECTED * fabs(C) * *Omega))
        return 0;
    *Omega -= step;
    return 1;
}

/* Omega from F = 0, where at a fold it does not depend on A to first order: the root next to the one by I. */
static double sf_settled_Omega(const sf_model *model, double F_0, const sf_sample *at, double Omega) {
    double w[3], nearest = HUGE_VAL;
    int i, n, place = 0;
    if (sf_is_next_to_root(model, F_0, at, &Omega))
        return Omega;
    n = sf_frequencies(model, at, F_0, w);
    if (n == 0) /* beyond the tip of the curve by rounding: Omega from F_A = 0 after all */
        n = sf_fold_roots(at->A, at->h, at->h_A, model->m, model->zeta, w);
    for (i = 0; i < n; i++)
        if (fabs(w[i] - Omega) < nearest)
            nearest = fabs(w[i] - Omega), place = i;
    return n > 0 ? w[place] : Omega;
}

/* Whether the side below breakpoint b is stable at the state (b, w): F_A > 0. Where the state is, to rounding, the end
 * of the fold locus below, the sign of SF_FOLD_AT there decides, which decided whether that has a zero next to b. To
 * first order F and F_A are multiples of it, and F_A at the state is less by F_AOmega F/F_Omega; without viscous
 * damping it is F, and F_A is 0. */
static int sf_is_stable_below(const sf_model *model, double F_0, const sf_sample *at, double w) {
    const sf_asked asked = sf_asked_of(SF_FOLD_AT, model, F_0);
    sf_answer fold;
    if (sf_inertial(model))
        return sf_half_F_A(model, at, w) > 0;
    sf_ask(&asked, 1, at, &fold);
    if (fold.exists[0] && fabs(fold.Omega[0] - w) < SF_NEAR_END * w) {
        const double turn = 4 * sf_quarter_F_AOmega(model, at, w) / sf_F_Omega(model, at, w);
        double moves[2] = {1, 0}; /* of F and F_A */
        if (model->zeta > 0)
            slow_flow_fold_moves(at->A, at->k, slow_flow_R(w, at->A, at->h), moves);
        return fold.y[0] * (moves[1] - turn * moves[0]) > 0;
    }
    return sf_half_F_A(model, at, w) > 0;
}

/* Folds on a breakpoint where the force jumps by J: next to it F_A = 2 R h_A + ... has the sign of R J. */
static void sf_corner_folds(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    int k, i;
    for (k = 0; k < model->breaks; k++) {
        sf_corner *corner = &work->corner[k];
        const double *w = corner->Omega;
        sf_sample at;
        if (model->jump[k] == 0 || !(model->b[k] < work->A_max))
            continue;
        sf_sample_at(model, model->b[k], &at);
        corner->n = sf_frequencies(model, &at, F_0, corner->Omega);
        for (i = 0; i < corner->n && w[i] < HUGE_VAL; i++) {
            const double R = slow_flow_R(w[i], at.A, at.h);
            const int stable_below = sf_is_stable_below(model, F_0, &at, w[i]), stable_above = R * model->jump[k] > 0;
            if (stable_below != stable_above)
                sf_add_fold(folds, w[i], at.A, stable_below, 1);
        }
    }
}

/* The level on an arc of the fold locus less F_0. */
static double sf_excess(const sf_model *model, double F_0, const sf_arc *arc, double A, double *Omega) {
    sf_sample at;
    sf_sample_at(model, A, &at);
    *Omega = A == arc->A[0]   ? arc->Omega[0]
             : A == arc->A[1] ? arc->Omega[1]
                              : sf_fold_branch(model, &at, arc->count, arc->index);
    return *Omega > 0 ? sf_level(model, &at, *Omega) - F_0 : HUGE_VAL;
}

/* Where the level, which is monotone along the arc, passes F_0: regula falsi (Illinois), and halves where that is
 * slow. */
static double sf_level_crossing(const sf_model *model, double F_0, const sf_arc *arc, double low, double high,
                                double *Omega)
{
    double a = arc->A[0], b = arc->A[1], f_a = low, f_b = high;
    int i;
    for (i = 0; i < 400; i++) {
        double A = b - f_b * ((b - a) / (f_b - f_a)), f;
        if (!(A > a && A < b) || i % 4 == 3)
            A = sf_amid(0, a, b);
        if (!(A > a && A < b) || b - a <= 0x1p-52 * b)
            break;
        f = sf_excess(model, F_0, arc, A, Omega);
        if ((f < 0) == (low < 0)) {
            a = A, f_a = f, f_b *= 0.5;
        } else {
            b = A, f_b = f, f_a *= 0.5;
        }
        if (f == 0)
            break;
    }
    sf_excess(model, F_0, arc, fabs(f_a) < fabs(f_b) ? a : b, Omega);
    return fabs(f_a) < fabs(f_b) ? a : b;
}

/* The folds of an excitation by inertia inside of pieces: where the level passes F_0 along the arcs of the fold
 * locus. */
static sf_status sf_locus_folds(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    const sf_status status = sf_fold_locus(model, work->A_max, work);
    int i;
    if (status != SF_OK)
        return status;
    folds->undecided |= work->extrema.undecided;
    for (i = 0; i < work->locus.arcs; i++) {
        const sf_arc *arc = &work->locus.arc[i];
        double Omega, A;
        const double low = sf_excess(model, F_0, arc, arc->A[0], &Omega),
                     high = sf_excess(model, F_0, arc, arc->A[1], &Omega);
        sf_sample at;
        folds->undecided |= fabs(low) <= SF_CLOSE * F_0 || fabs(high) <= SF_CLOSE * F_0;
        if (!sf_opposite(low, high))
            continue;
        A = sf_level_crossing(model, F_0, arc, low, high, &Omega);
        sf_sample_at(model, A, &at);
        Omega = sf_settled_Omega(model, F_0, &at, Omega);
        sf_add_fold(folds, Omega, A, sf_half_F_AA(model, &at, Omega) < 0, 0);
    }
    return SF_OK;
}

/* Every fold at F_0 > m, by rising Omega; the pieces up to the largest amplitude stay in work. */
static sf_status sf_saddle_nodes(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    sf_zeros *found = &work->zeros;
    sf_status status;
    int i, k;
    folds->n = folds->undecided = folds->close = 0, folds->status = SF_OK;
    if (sf_sticks(model, F_0))
        return SF_STICKS;
    status = sf_range_at(model, F_0, &work->A_max);
    if (status != SF_OK && status != SF_UNBOUNDED)
        return status;
    if (sf_inertial(model)) {
        status = sf_locus_folds(model, F_0, work, folds);
        if (status != SF_OK)
            return status;
        sf_corner_folds(model, F_0, work, folds);
        return folds->status;
    }
    sf_stretches_up_to(model, work->A_max, &work->pieces);
    for (i = 0; i < work->pieces.n; i++) {
        sf_clear_zeros(found);
        sf_ask_all(model, SF_FOLD_AT, F_0, &work->pieces.at[i], found);
        if (found->status != SF_OK)
            return found->status;
        folds->undecided |= found->undecided, folds->close |= found->close;
        for (k = 0; k < found->n; k++) {
            const double A = found->at[k].A;
            double Omega;
            sf_sample at;
            sf_sample_at(model, A, &at);
            Omega = sf_settled_Omega(model, F_0, &at, found->at[k].Omega);
            /* leaving a fold, a sweep goes the way of the saddle: up where the stable branch lies below it */
            sf_add_fold(folds, Omega, A, sf_half_F_AA(model, &at, Omega) < 0, 0);
        }
    }
    sf_corner_folds(model, F_0, work, folds);
    return folds->status;
}

/* ==== The locus itself ============================================================================================ */

/* The forcing at an extremum: at a cusp in the form that loses no digits where damping is small. */
static double sf_extremum_level(const sf_model *model, const sf_zero *zero, const sf_sample *at) {
    if (zero->question != SF_CUSP)
        return sf_level(model, at, zero->Omega);
    if (sf_inertial(model))
        return inertia_amplitude(zero->Omega, zero->level);
    /* by what the record's excitation differs from a force */
    return zero->level *
           (sf_level(model, at, zero->Omega) / slow_flow_level(zero->Omega, at->A, model->m, model->zeta, at->h));
}

static sf_extremum sf_extremum_at(const sf_model *model, const sf_zero *zero) {
    sf_extremum out;
    sf_sample at;
    sf_sample_at(model, zero->A, &at);
    out.Omega = zero->Omega;
    out.A = zero->A;
    out.F_0 = sf_extremum_level(model, zero, &at);
    out.minimum = sf_is_minimum(model, zero->question, &at, out.Omega);
    out.saddle = zero->question == SF_ISOLA && (sf_inertial(model) ? inertia_hessian : slow_flow_hessian)(
                                                   out.Omega, at.A, model->m, model->zeta, at.h, at.h_A, at.h_AA) < 0;
    out.isola = zero->question == SF_ISOLA;
    return out;
}

static double sf_locus_weight(const sf_arc *arc, double A_max) {
    const double way = fabs(arc->Omega[1] / (1 + arc->Omega[1]) - arc->Omega[0] / (1 + arc->Omega[0]));
    return (isnan(way) ? 0 : way) +
           (arc->A[1] - arc->A[0]) / A_max + SF_SPREAD;
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
            /* of a force that jumps at u = 0 no Omega is known at A = 0, where the locus begins */
            const int from = isnan(arc->Omega[1 - upward]), to = steps + last - (last && isnan(arc->Omega[upward]));
            if (Omega == NULL) {
                n += to - from;
                continue;
            }
            for (k = from; k < to; k++, n++) {
                const double share = 0.5 - 0.5 * cos(3.14159265358979312 * (upward ? k : steps - k) / steps);
                const int end = k == 0 ? 1 - upward : upward;
                sf_sample at;
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
