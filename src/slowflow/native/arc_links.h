/* Arcs and how they go on. Takes a model and the events along the amplitude, of its response or of its fold locus;
 * returns the roots Omega of each interval between them, counted, and which arcs meet at each event.
 */
#pragma once

#include "work.h"

/* ==== Roots of the two quartics along A =========================================================================== */

/* In place of a forcing where the quartic is not the response's: that of the fold locus. */
#define SF_ON_LOCUS -1.

static void sf_isolate_at(const sf_model *model, const sf_sample *at, double F_0, sf_isolated *q) {
    if (F_0 < 0)
        sf_isolate_fold(q, at->A, at->h, at->h_A, model->m, model->zeta);
    else
        sf_isolate_response(q, at->A, at->h, model->m, model->zeta, F_0);
}

/* Whether roots are those of a polynomial of laws.h: of any laws, and of the response to an excitation by inertia. */
static int sf_is_of_laws(const sf_model *model, double F_0) {
    return model->by_laws || (F_0 >= 0 && sf_inertial(model));
}

static void sf_make_law_polynomial_at(const sf_model *model, const sf_sample *at, double F_0, sf_law_polynomial *q) {
    sf_make_law_polynomial(model, at, F_0 < 0 ? SF_OF_FOLDS : SF_OF_RESPONSE, F_0, sf_is_beyond(model, at->A), q);
}

/* How many roots there are at an amplitude; negative where that is beyond the range of doubles. */
static int sf_count_at(const sf_model *model, const sf_sample *at, double F_0) {
    sf_law_polynomial by_laws;
    sf_isolated q;
    sf_place place[3];
    if (sf_is_of_laws(model, F_0)) {
        sf_make_law_polynomial_at(model, at, F_0, &by_laws);
        return sf_law_count(&by_laws);
    }
    if (F_0 < 0 && model->zeta == 0) /* the factor R = 0 is the backbone, at the level m */
        return at->h_A < 0;
    sf_isolate_at(model, at, F_0, &q);
    return sf_places(q.exist, q.f0 < 0, q.f1 > 0, q.f2 < 0, place);
}

/* Root number `index` of `count`. */
static double sf_branch_at(const sf_model *model, const sf_sample *at, double F_0, int count, int index) {
    sf_law_polynomial by_laws;
    sf_isolated q;
    if (sf_is_of_laws(model, F_0) && (F_0 >= 0 || at->A > 0)) {
        sf_make_law_polynomial_at(model, at, F_0, &by_laws);
        return sf_law_branch(&by_laws, count, index);
    }
    if (F_0 < 0 && (model->eta != 0 || model->d != 0 || model->released)) /* at A = 0 there is no quartic */
        return NAN;
    /* at A = 0, where the quartic is none, what damping is too weak to hide begins at the stiffness there */
    if (F_0 < 0 && (model->zeta == 0 || (at->A == 0 && fabs(at->h_A) < HUGE_VAL)))
        return slow_flow_undamped_Omega(fmin(at->h_A, 0));
    sf_isolate_at(model, at, F_0, &q);
    return sf_root_at(&q, sf_place_of(q.exist, q.f0, q.f1, q.f2, count, index));
}

/* ==== Arcs between events ========================================================================================= */

/* Whether the numbers of a response's roots next to an event are not what it makes of them: roots coincide within
 * rounding.
 * Between events that are hardly apart rounding may have changed their order. */
static int sf_contradicts(double F_0, const sf_graph *graph, int k) {
    const sf_event *event = &graph->event[k];
    if (k == 0 || F_0 < 0 || event->kind == SF_CUT || event->kind == SF_THROUGH)
        return 0;
    return event->A - event[-1].A > SF_HARDLY * event->A && event[1].A - event->A > SF_HARDLY * event->A &&
           graph->count[k] - graph->count[k - 1] != event->gain;
}

/* The number of roots in each interval; where no amplitude lies inside, it follows from the event's gain. */
static void sf_count_intervals(const sf_model *model, double F_0, sf_graph *graph) {
    for (int k = 0; k + 1 < graph->events; k++) {
        const double low = graph->event[k].A, high = graph->event[k + 1].A, middle = 0.5 * (low + high);
        const int is_wide = middle > low + SF_NO_WIDTH * low && middle < high;
        if (!is_wide && k > 0 && graph->event[k].kind != SF_CUT) {
            graph->count[k] = graph->count[k - 1] + graph->event[k].gain;
        } else if (!is_wide && graph->event[k + 1].kind == SF_CUT) { /* between the sides of a breakpoint */
            graph->count[k] = 0;
        } else { /* or next to one */
            const sf_sample at = sf_sample_at(model, is_wide ? middle : low);
            graph->count[k] = sf_count_at(model, &at, F_0);
        }
        if (graph->count[k] < 0 || graph->count[k] > 3 || sf_contradicts(F_0, graph, k)) {
            graph->status = SF_UNRESOLVED;
            graph->count[k] = 0;
        }
    }
}

/* Arcs that end at an event, each with the Omega that it has there. */
static void sf_end_all(const sf_model *model, double F_0, sf_graph *graph, const sf_sample *at, int interval, int end) {
    for (int i = 0; i < graph->count[interval]; i++)
        sf_end(graph, graph->first[interval] + i, end, at->A, sf_branch_at(model, at, F_0, graph->count[interval], i));
}

/* Which two of the roots meet at A, the lower pair or the upper, and where: by the event, or, where it is none of
 * these but roots vanish all the same (a breakpoint that is an extremum to rounding), by the critical value next to
 * 0. */
static int sf_lower_pair(const sf_model *model, double F_0, const sf_event *event, const sf_sample *at, double *Omega) {
    sf_law_polynomial by_laws;
    sf_isolated q;
    int lower;
    *Omega = event->Omega;
    if (event->kind == SF_PAIR_LOW || event->kind == SF_PAIR_HIGH)
        return event->kind == SF_PAIR_LOW;
    if (sf_is_of_laws(model, F_0)) {
        sf_make_law_polynomial_at(model, at, F_0, &by_laws);
        lower = by_laws.w[0] > 0 && fabs(by_laws.f[1]) < fabs(by_laws.f[2]);
        *Omega = sf_law_Omega(&by_laws, by_laws.w[!lower]);
        return by_laws.by_x ? !lower : lower;
    }
    sf_isolate_at(model, at, F_0, &q);
    lower = q.w1 > 0 && fabs(q.f1) < fabs(q.f2);
    *Omega = lower ? q.w1 : q.w2;
    return lower;
}

/* Event k, between intervals k - 1 and k: arcs of the richer side end, all others go on. */
static void sf_link(const sf_model *model, double F_0, sf_graph *graph, int k) {
    const sf_event *event = &graph->event[k];
    const int left = graph->count[k - 1], right = graph->count[k];
    const int rich = left >= right ? k - 1 : k, poor = left >= right ? k : k - 1;
    const int rich_end = left >= right, lost = graph->count[rich] - graph->count[poor];
    const int first_rich = graph->first[rich], first_poor = graph->first[poor];
    int gone = 0; /* index of the first arc of the richer side that does not go on */
    const sf_sample at = sf_sample_at(model, event->A);
    if (event->kind == SF_CUT) {
        sf_end_all(model, F_0, graph, &at, k - 1, 1);
        sf_end_all(model, F_0, graph, &at, k, 0);
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
        const int lower = sf_lower_pair(model, F_0, event, &at, &Omega) && lost == 2;
        const int pair = lower ? first_rich : first_rich + graph->count[rich] - 2;
        gone = lower || lost == 3 ? 0 : graph->count[rich] - 2;
        sf_end(graph, pair, rich_end, event->A, Omega);
        sf_end(graph, pair + 1, rich_end, event->A, Omega);
        sf_meet(graph, pair, rich_end, pair + 1, rich_end);
    }
    for (int i = 0; i < graph->count[poor]; i++) {
        const int other = first_rich + (i < gone ? i : i + lost);
        /* by other laws, where one ends at Omega = 0 and another begins they meet; without, one goes by */
        const int is_at_rest = i == 0 && lost == 0 && event->kind == SF_TO_ZERO && model->by_laws;
        const double Omega = is_at_rest ? 0 : sf_branch_at(model, &at, F_0, graph->count[poor], i);
        sf_end(graph, first_poor + i, 1 - rich_end, event->A, Omega);
        sf_end(graph, other, rich_end, event->A, Omega);
        sf_meet(graph, first_poor + i, 1 - rich_end, other, rich_end);
    }
}

/* F_0: of the response, or SF_ON_LOCUS */
static void sf_trace_arcs(const sf_model *model, double F_0, sf_graph *graph) {
    sf_sample at;
    sf_count_intervals(model, F_0, graph);
    sf_make_arcs(graph);
    if (graph->events < 2)
        return;
    for (int k = 1; k + 1 < graph->events; k++)
        sf_link(model, F_0, graph, k);
    if (graph->event[0].A > 0 || F_0 < 0) {
        at = sf_sample_at(model, graph->event[0].A);
        sf_end_all(model, F_0, graph, &at, 0, 0);
    } else { /* the response comes from A = 0, at one frequency */
        for (int k = 0; k < graph->count[0]; k++)
            sf_end(graph, k, 0, 0, graph->event[0].Omega);
    }
    at = sf_sample_at(model, graph->event[graph->events - 1].A);
    sf_end_all(model, F_0, graph, &at, graph->events - 2, 1);
}
