/* Curves from roots. Takes events along the amplitude; returns arcs, which of their ends meet, and curves through
 * them.
 *
 * Between neighbouring events the number of roots Omega is constant and each root is an arc, continuous in A. At an
 * event a pair of arcs may meet and end, or the lowest may end at Omega = 0; all others go on.
 */
#pragma once

#include "zeros.h"

enum { SF_MOST_EVENTS = 112, SF_MOST_ARCS = 3 * SF_MOST_EVENTS };

typedef enum {
    SF_THROUGH,    /* all arcs go on */
    SF_CUT,        /* all arcs end: an end of the range, or a jump */
    SF_PAIR_LOW,   /* the two lowest of the richer side meet at Omega */
    SF_PAIR_HIGH,  /* the two highest */
    SF_TO_ZERO,    /* the lowest of the richer side ends at Omega = 0 */
    SF_TO_INFINITY /* the highest of the richer side ends at Omega = inf */
} sf_event_kind;

/* gain: by how much the number of roots changes, where it is known */
typedef struct {
    double A, Omega;
    sf_event_kind kind;
    int gain;
} sf_event;

/* ends 0 and 1 by rising A; partner: 2 * arc + end of the end that it meets, or -1 */
typedef struct {
    double A[2], Omega[2];
    int partner[2];
    int interval, count, index;
} sf_arc;

/* interval k lies between events k and k + 1, and first[k] is the first of its arcs; close: whether rounding may have
 * decided which events there are */
typedef struct {
    sf_status status;
    int events, arcs, close;
    sf_event event[SF_MOST_EVENTS];
    int count[SF_MOST_EVENTS], first[SF_MOST_EVENTS];
    sf_arc arc[SF_MOST_ARCS];
} sf_graph;

/* steps of all curves in order: 2 * arc + (1 where A rises along it); start[c] is the first step of curve c */
typedef struct {
    int curves;
    int start[SF_MOST_ARCS + 1], closed[SF_MOST_ARCS];
    int step[SF_MOST_ARCS];
} sf_tour;

static inline void sf_add_event(sf_graph *graph, double A, double Omega, sf_event_kind kind, int gain) {
    if (graph->events == SF_MOST_EVENTS) {
        graph->status = SF_TOO_MANY;
        return;
    }
    sf_event *event = &graph->event[graph->events++];
    event->A = A, event->Omega = Omega, event->kind = kind, event->gain = gain;
}

/* With little friction and damping the lower pair meets so near Omega = 0 that rounding may take the place where one of
 * its arcs ends there for the earlier one. Then the two events are one: an arc comes from Omega = 0. */
static inline void sf_merge_events(sf_graph *graph) {
    int n = 0;
    for (int i = 0; i < graph->events; i++) {
        const sf_event *event = &graph->event[i];
        sf_event *last = n > 0 ? &graph->event[n - 1] : NULL;
        if (last != NULL && event->A - last->A <= SF_COINCIDE * event->A &&
            ((last->kind == SF_PAIR_LOW && event->kind == SF_TO_ZERO) ||
             (last->kind == SF_TO_ZERO && event->kind == SF_PAIR_LOW))) {
            last->kind = SF_TO_ZERO;
            last->gain += event->gain;
        } else {
            graph->event[n++] = *event;
        }
    }
    graph->events = n;
}

static inline void sf_end(sf_graph *graph, int arc, int end, double A, double Omega) {
    graph->arc[arc].A[end] = A, graph->arc[arc].Omega[end] = Omega;
}

static inline void sf_meet(sf_graph *graph, int one, int end_one, int other, int end_other) {
    graph->arc[one].partner[end_one] = 2 * other + end_other;
    graph->arc[other].partner[end_other] = 2 * one + end_one;
}

static inline void sf_make_arcs(sf_graph *graph) {
    graph->arcs = 0;
    for (int k = 0; k + 1 < graph->events; k++) {
        graph->first[k] = graph->arcs;
        for (int i = 0; i < graph->count[k]; i++) {
            sf_arc *arc = &graph->arc[graph->arcs++];
            arc->interval = k, arc->count = graph->count[k], arc->index = i;
            arc->partner[0] = arc->partner[1] = -1;
        }
    }
}

/* The arcs from an end on, along the curve, until it ends or closes. */
static inline int sf_follow(const sf_graph *graph, int end, int *visited, int *step) {
    int n = 0;
    while (end >= 0 && !visited[end / 2]) {
        const int arc = end / 2, upward = 1 - end % 2;
        visited[arc] = 1;
        step[n++] = 2 * arc + upward;
        end = graph->arc[arc].partner[upward];
    }
    return n;
}

static inline void sf_reverse(int *step, int n) {
    for (int i = 0; i < n / 2; i++) {
        const int swap = step[i];
        step[i] = step[n - 1 - i] ^ 1;
        step[n - 1 - i] = swap ^ 1;
    }
    if (n % 2)
        step[n / 2] ^= 1;
}

static inline void sf_tour_from(const sf_graph *graph, int end, int closed, int *visited, sf_tour *tour) {
    const int at = tour->start[tour->curves];
    int *step = &tour->step[at];
    const int n = sf_follow(graph, end, visited, step);
    if (n == 0)
        return;
    const int first = step[0], last = step[n - 1];
    if (!closed && graph->arc[first / 2].Omega[1 - first % 2] > graph->arc[last / 2].Omega[last % 2])
        sf_reverse(step, n);
    tour->closed[tour->curves++] = closed;
    tour->start[tour->curves] = at + n;
}

/* Open curves from one loose end to the other, at the lower Omega first, then the closed ones. The curve that reaches
 * A = 0 is the first: its end is the lowest. */
static inline void sf_make_tour(const sf_graph *graph, sf_tour *tour) {
    int visited[SF_MOST_ARCS];
    memset(visited, 0, sizeof visited);
    tour->curves = 0, tour->start[0] = 0;
    for (int arc = 0; arc < graph->arcs && graph->arc[arc].interval == 0; arc++)
        if (graph->arc[arc].partner[0] < 0)
            sf_tour_from(graph, 2 * arc, 0, visited, tour);
    for (int arc = 0; arc < graph->arcs; arc++)
        for (int end = 0; end < 2; end++)
            if (graph->arc[arc].partner[end] < 0)
                sf_tour_from(graph, 2 * arc + end, 0, visited, tour);
    for (int arc = 0; arc < graph->arcs; arc++)
        sf_tour_from(graph, 2 * arc, 1, visited, tour);
}
