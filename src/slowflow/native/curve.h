/* The response curve at one forcing. Takes a model; returns its segments, points along them, states at a frequency.
 *
 * Its events are zeros of SF_PEAK and SF_REST; between them each root is an arc, and the folds cut an arc into segments
 * along which Omega is monotone too. So a segment holds at most one state at any frequency, and one stability.
 */
#pragma once

#include "resolve.h"
#include "root_lanes.h"

static void sf_add_response_event(const sf_zero *zero, int biquadratic, sf_graph *graph) {
    const int up = zero->rising ? 1 : -1;
    if (zero->question == SF_REST) /* h^2 rises with h - c, and falls as h + c rises */
        sf_add_event(graph, zero->A, 0, SF_TO_ZERO, biquadratic == (zero->channel == 0) ? up : -up);
    else if (zero->channel == 0)
        sf_add_event(graph, zero->A, zero->Omega, SF_PAIR_LOW, 2 * up);
    else
        sf_add_event(graph, zero->A, zero->Omega, SF_PAIR_HIGH, -2 * up);
}

/* Whether a force's F has no term in Omega and a minimum inside: then it is a second root that comes from Omega = 0. */
static int sf_is_biquadratic(const sf_model *model, double F_0, double A) {
    sf_isolated q;
    if (sf_inertial(model))
        return 0;
    const sf_sample at = sf_sample_at(model, A);
    if (model->by_laws) {
        sf_law_polynomial by_laws;
        sf_make_law_polynomial(model, &at, SF_OF_RESPONSE, F_0, sf_is_beyond(model, A), &by_laws);
        return by_laws.c[1] == 0 && by_laws.c[2] < 0;
    }
    sf_isolate_response(&q, A, at.h, model->m, model->zeta, F_0);
    return q.exist && q.w1 == 0;
}

/* For an excitation by inertia, before an event at A: that a frequency comes from or goes to inf at A = F_0. */
static void sf_add_infinity(const sf_model *model, double F_0, double A, int *passed, sf_graph *graph) {
    if (*passed || A < F_0)
        return;
    *passed = 1;
    const sf_sample at = sf_sample_at(model, F_0);
    sf_add_event(graph, F_0, HUGE_VAL, SF_TO_INFINITY, sf_least_x(model, &at) > 0 ? 1 : -1);
}

/* Whether zero k of sorted ones lies so close above another one of the same question that between them there may be no
 * double: what lies there, as a whole curve where h passes through 0 by steps larger than F_0, is lost then. */
static int sf_is_zero_close(const sf_zero *at, int k) {
    for (int i = k - 1; i >= 0 && at[k].A - at[i].A <= SF_COINCIDE * at[k].A; i--)
        if (at[i].question == at[k].question)
            return 1;
    return 0;
}

/* By rising A, those from number `first` on. */
static void sf_sort_events(sf_graph *graph, int first) {
    int j;
    for (int i = first + 1; i < graph->events; i++) {
        const sf_event event = graph->event[i];
        for (j = i; j > first && graph->event[j - 1].A > event.A; j--)
            graph->event[j] = graph->event[j - 1];
        graph->event[j] = event;
    }
}

/* Those of the peaks by other laws of damping that are on a piece; part: its number, or -1 for all */
static void sf_add_law_peaks(const sf_model *model, const sf_law_points *peaks, int part, sf_graph *graph) {
    for (int k = 0; k < peaks->n; k++) {
        const double w = peaks->at[k].Omega;
        if (part >= 0 && peaks->at[k].part != part)
            continue;
        const sf_sample at = sf_sample_at(model, peaks->at[k].A);
        const int up = sf_rises_at_peak(model, &at, w), low = sf_bends_at_peak(model, &at, w);
        sf_add_event(graph, at.A, w, low != sf_inertial(model) ? SF_PAIR_LOW : SF_PAIR_HIGH, up == low ? 2 : -2);
    }
}

/* What of the response to an excitation by inertia is next to Omega = inf: the amplitude that it tends to, and whether
 * above that there is one more frequency than below, not one less. There F over Omega^4 is x (c_1 + c_2 x) next to x =
 * 0, c_1 >= 0; for c_2 < 0 a pair meets at x = -c_1/(2 c_2), at an amplitude that is lower by c_1^2/|c_2| over F_0^2,
 * or less. Where that is within the rounding of that amplitude there are no doubles between them in which signs of F
 * tell the frequencies apart: such a pair is none of the events. */
typedef struct {
    double A;
    int falls;
} sf_far_end;

static int sf_meets_far(const sf_model *model, const sf_law_polynomial *end, const sf_law_point *peak) {
    const sf_sample at = sf_sample_at(model, peak->A);
    return peak->Omega / end->unit * end->c[1] > -end->c[2] && sf_bends_at_peak(model, &at, peak->Omega);
}

/* Leaves out of the peaks a pair that rounds to the end. */
static sf_far_end sf_far_end_of(const sf_model *model, double F_0, sf_law_points *peaks) {
    sf_far_end out = {dissipation_full_by_inertia(F_0, model->d), 0};
    const sf_sample at = sf_sample_at(model, out.A);
    sf_law_polynomial q;
    sf_make_law_polynomial(model, &at, SF_OF_RESPONSE, F_0, sf_is_beyond(model, out.A), &q);
    out.falls = q.c[2] < 0 && q.c[1] * q.c[1] <= SF_HARDLY * -q.c[2] * q.F_0 * q.F_0;
    for (int i = 0; out.falls && i < peaks->n; i++)
        if (sf_meets_far(model, &q, &peaks->at[i])) {
            if (peaks->at[i].A < out.A * (1 - SF_ERROR))
                out.falls = 0;
            else
                peaks->at[i--] = peaks->at[--peaks->n];
        }
    return out;
}

/* By quadratic damping alone, where h = 0 frequencies come from 0, as all but h falls with Omega^2: next to there
 * h/Omega^2 is -A -+ r with r^2 = F_0^2 - (d A^2)^2: both on one side, or one on either. */
static void sf_add_where_nothing_pulls(const sf_model *model, double F_0, const sf_stretch *piece, sf_zeros *zeros,
                                       sf_graph *graph) {
    sf_clear_zeros(zeros);
    if (!(model->zeta == 0 && model->m == 0 && model->eta == 0 && sf_has_force(piece)))
        return;
    sf_ask_all(model, SF_STIFFNESS, 0, piece, zeros);
    for (int k = 0; k < zeros->n; k++) {
        const double A = zeros->at[k].A;
        double beyond[3]; /* A^2 - r^2 */
        dissipation_far_by_inertia(0, A, F_0, 0, 0, model->d, 0, beyond);
        if (zeros->at[k].channel == 0 && beyond[0] < 0)
            sf_add_event(graph, A, 0, SF_TO_ZERO, 0);
        else if (zeros->at[k].channel == 0 && beyond[0] < A * A)
            sf_add_event(graph, A, 0, SF_PAIR_LOW, zeros->at[k].rising ? -2 : 2);
    }
    zeros->undecided = 0;
}

/* The events of other laws of damping under an excitation by inertia, which leaves none at rest: a frequency comes from
 * inf, or goes there. */
static void sf_inertial_law_graph(const sf_model *model, double F_0, sf_work *work) {
    sf_law_points *peaks = &work->points.found;
    const sf_far_end end = sf_far_end_of(model, F_0, peaks);
    sf_graph *graph = &work->response;
    const sf_sample at = sf_sample_at(model, 0);
    graph->close = 0;
    for (int k = 0; k < peaks->undecided; k++)
        graph->close |= fabs(peaks->doubt[k] - end.A) > (end.falls ? SF_HARDLY * end.A : 0);
    sf_add_event(graph, 0, inertia_moves_from(F_0, slow_flow_held(model->m, fmax(-at.h, 0))), SF_CUT, 0);
    sf_add_event(graph, end.A, HUGE_VAL, SF_TO_INFINITY, end.falls ? 1 : -1);
    sf_add_law_peaks(model, peaks, -1, graph);
    for (int i = 0; i < work->pieces.n; i++) {
        if (i + 1 < work->pieces.n)
            sf_add_event(graph, model->b[i], 0, SF_THROUGH, 0);
        sf_add_where_nothing_pulls(model, F_0, &work->pieces.at[i], &work->zeros, graph);
        if (work->zeros.status != SF_OK)
            graph->status = work->zeros.status;
    }
    sf_sort_events(graph, 1);
}

/* The arcs between its events: peaks, static states and breakpoints. Needs the pieces of work. */
static void sf_response_graph(const sf_model *model, double F_0, sf_work *work) {
    const int laws = model->by_laws, inertial = sf_inertial(model), is_apart = laws && inertial;
    sf_graph *graph = &work->response;
    sf_zeros *zeros = &work->zeros;
    int passed = laws || !inertial;
    graph->events = 0, graph->status = laws ? sf_find_law_peaks(model, F_0, work) : SF_OK;
    if (is_apart) {
        sf_inertial_law_graph(model, F_0, work);
    } else {
        graph->close = laws && work->points.found.undecided > 0;
        sf_add_event(graph, 0, inertial ? inertia_moves_from(F_0, model->m) : HUGE_VAL, SF_CUT, 0);
    }
    for (int i = 0; !is_apart && i < work->pieces.n && graph->status == SF_OK; i++) {
        const int first = graph->events;
        sf_clear_zeros(zeros);
        if (laws)
            sf_add_law_peaks(model, &work->points.found, i, graph);
        else
            sf_ask_all(model, SF_PEAK, F_0, &work->pieces.at[i], zeros);
        sf_ask_all(model, SF_REST, F_0, &work->pieces.at[i], zeros);
        sf_sort_zeros(zeros);
        graph->close |= zeros->undecided;
        for (int k = 0; k < zeros->n; k++) {
            graph->close |= !laws && sf_is_zero_close(zeros->at, k);
            if (inertial) /* no level of an amplitude is above it: a peak is below F_0 by rounding alone */
                zeros->at[k].A = fmax(zeros->at[k].A, F_0);
            sf_add_infinity(model, F_0, zeros->at[k].A, &passed, graph);
            sf_add_response_event(&zeros->at[k], sf_is_biquadratic(model, F_0, zeros->at[k].A), graph);
        }
        sf_sort_events(graph, first);
        if (zeros->status != SF_OK)
            graph->status = zeros->status;
        if (i + 1 < work->pieces.n) {
            sf_add_infinity(model, F_0, model->b[i], &passed, graph);
            sf_add_event(graph, model->b[i], 0, SF_THROUGH, 0);
        }
    }
    sf_add_infinity(model, F_0, work->A_max, &passed, graph);
    sf_add_event(graph, work->A_max, 0, SF_CUT, 0);
    if (!is_apart)
        sf_merge_events(graph);
    if (graph->status == SF_OK)
        sf_trace_arcs(model, F_0, graph);
}

/* The arc that a fold lies on, or -1. */
static int sf_arc_of_fold(const sf_model *model, double F_0, const sf_graph *graph, const sf_fold *fold) {
    double nearest = HUGE_VAL;
    int found = -1;
    const sf_sample at = sf_sample_at(model, fold->A);
    for (int i = 0; i < graph->arcs; i++) {
        const sf_arc *arc = &graph->arc[i];
        if (fold->corner || !(arc->A[0] <= fold->A && fold->A <= arc->A[1]))
            continue; /* an arc ends at every breakpoint already */
        const double off = fabs(sf_branch_at(model, &at, F_0, arc->count, arc->index) - fold->Omega);
        if (off < nearest)
            nearest = off, found = i;
    }
    return found;
}

/* By the sign of F_A. Where the resonance is so sharp that of R rounding of A Omega^2 leaves nothing, F has it up to
 * its sign, which is that of F_Omega there: F rises at the last root. */
static int sf_is_stable(const sf_model *model, double F_0, const sf_segment *segment) {
    const sf_sample at = sf_sample_at(model, 0.5 * (segment->A[0] + segment->A[1]));
    const double Omega = sf_branch_at(model, &at, F_0, segment->count, segment->index);
    if (model->by_laws)
        return sf_law_F_A(model, &at, Omega, sf_is_beyond(model, at.A)) > 0;
    if (sf_inertial(model) || !(at.A * Omega * Omega > SF_SHARP * F_0))
        return sf_half_F_A(model, &at, Omega) > 0;
    const double I = slow_flow_I(Omega, at.A, model->m, model->zeta);
    const double R = sqrt(fmax(0, (F_0 - I) * (F_0 + I))) * ((segment->count - segment->index) % 2 == 1 ? 1 : -1);
    return R * (at.h_A + Omega * Omega) + 2 * model->zeta * Omega * I > 0;
}

/* The segments of one step of a tour: its arc cut at its folds, in order along the curve. */
static void sf_add_step(const sf_model *model, double F_0, const sf_arc *arc, int upward, int curve,
                        const sf_folds *folds, const int *arc_of, int number, sf_skeleton *out) {
    sf_segment segment;
    double A = arc->A[1 - upward], Omega = arc->Omega[1 - upward];
    segment.index = arc->index, segment.count = arc->count, segment.curve = curve, segment.upward = upward;
    for (;;) { /* the nearest fold ahead */
        int next = -1;
        for (int i = 0; i < folds->n; i++) {
            const double ahead = upward ? folds->at[i].A - A : A - folds->at[i].A;
            if (arc_of[i] == number && ahead > 0 &&
                (next < 0 || (upward ? folds->at[i].A < folds->at[next].A : folds->at[i].A > folds->at[next].A)))
                next = i;
        }
        segment.A[1 - upward] = A, segment.Omega[1 - upward] = Omega;
        A = next < 0 ? arc->A[upward] : folds->at[next].A;
        Omega = next < 0 ? arc->Omega[upward] : folds->at[next].Omega;
        segment.A[upward] = A, segment.Omega[upward] = Omega;
        segment.stable = sf_is_stable(model, F_0, &segment);
        out->segment[out->segments++] = segment;
        if (next < 0)
            return;
    }
}

/* The last digits of the folds, also where segments end in them. What lies on which arc was decided by the numbers
 * before. Returns how far off one of them is left, relatively. */
static double sf_settle_skeleton(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room) {
    sf_work *work = &room->work;
    const sf_folds before = work->folds;
    const double off = sf_settle_or_prove(model, inputs, F_0, room, &work->folds);
    for (int i = 0; i < before.n; i++)
        for (int k = 0; k < work->skeleton.segments; k++)
            for (int end = 0; end < 2; end++) {
                sf_segment *segment = &work->skeleton.segment[k];
                if (segment->A[end] == before.at[i].A && segment->Omega[end] == before.at[i].Omega)
                    segment->A[end] = work->folds.at[i].A, segment->Omega[end] = work->folds.at[i].Omega;
            }
    return off;
}

static sf_status sf_make_skeleton(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room) {
    sf_work *work = &room->work;
    sf_skeleton *out = &work->skeleton;
    int arc_of[SF_MOST_FOLDS], lost = 0;
    const int laws = model->by_laws;
    const sf_status status = sf_decided_folds(model, inputs, F_0, room, &work->folds);
    out->segments = out->curves = 0, out->start[0] = 0;
    if (status != SF_OK)
        return status;
    sf_response_graph(model, F_0, work);
    if (work->response.status != SF_OK)
        return work->response.status;
    sf_make_tour(&work->response, &work->tour);
    for (int i = 0; i < work->folds.n; i++) {
        arc_of[i] = sf_arc_of_fold(model, F_0, &work->response, &work->folds.at[i]);
        lost |= arc_of[i] < 0 && !work->folds.at[i].corner;
    }
    if (!sf_inertial(model)) { /* of which there is no proof */
        room->inconclusive |= work->response.close | lost;
        room->undecided |= work->response.close;
    }
    for (int c = 0; c < work->tour.curves; c++) {
        for (int i = work->tour.start[c]; i < work->tour.start[c + 1]; i++) {
            const int arc = work->tour.step[i] / 2;
            sf_add_step(model, F_0, &work->response.arc[arc], work->tour.step[i] % 2, c, &work->folds, arc_of, arc,
                        out);
        }
        out->closed[c] = work->tour.closed[c];
        out->start[c + 1] = out->segments;
        out->curves = c + 1;
    }
    if (!laws && inputs != NULL && sf_settle_skeleton(model, inputs, F_0, room) > SF_FEW_DIGITS && !sf_inertial(model))
        room->inconclusive = room->undecided = 1;
    return SF_OK;
}

/* Whether doubles leave open which peaks and static states up to A_max a response curve has; of a force, without other
 * laws. */
static int sf_are_events_close(const sf_model *model, double F_0, double A_max, sf_work *work) {
    work->A_max = A_max;
    sf_stretches_up_to(model, work->A_max, &work->pieces);
    sf_response_graph(model, F_0, work);
    return work->response.close || work->response.status != SF_OK;
}

/* ==== Points ====================================================================================================== */

/* An amplitude below the state at Omega of the branch that comes from A = 0, Omega = inf. */
static double sf_tail_amplitude(const sf_model *model, double F_0, const sf_segment *segment, double Omega) {
    double A = slow_flow_tail(Omega, F_0, model->m);
    A = fmin(A, 0.5 * segment->A[1]);
    for (int i = 0; i < 500; i++) {
        const sf_sample at = sf_sample_at(model, A);
        if (sf_branch_at(model, &at, F_0, segment->count, segment->index) > Omega)
            break;
        A *= 0.25;
    }
    return A;
}

/* A last Newton step on F at fixed Omega, where F_A leaves one; the residual is in double-double. */
static double sf_polish_amplitude(const sf_model *model, double F_0, double Omega, const sf_sample *at) {
    const int laws = model->by_laws;
    sf_quartic s;
    s.kind = SF_RESPONSE;
    s.A = at->A, s.h = at->h, s.h_A = at->h_A, s.F_0 = sf_force(model, F_0, Omega);
    s.m = laws ? sf_law_I(model, at->A, Omega) : model->m, s.zeta = laws ? 0 : model->zeta; /* the same I */
    const double step = sf_value_fine(&s, Omega) / (laws ? sf_law_F_A(model, at, Omega, sf_is_beyond(model, at->A))
                                                         : 2 * sf_half_F_A(model, at, Omega));
    return fabs(step) < SF_LAST_STEP * at->A ? at->A - step : at->A;
}

/* The amplitude at which a segment has the given Omega, which must lie in its range. */
static double sf_amplitude_on(const sf_model *model, double F_0, const sf_segment *segment, double Omega) {
    const int falls = segment->Omega[0] > segment->Omega[1];
    double lo = segment->A[0], hi = segment->A[1], A;
    sf_sample at;
    if (Omega == segment->Omega[0] || Omega == segment->Omega[1])
        return Omega == segment->Omega[0] ? lo : hi;
    if (lo == 0 && segment->Omega[0] == HUGE_VAL) {
        lo = sf_tail_amplitude(model, F_0, segment, Omega);
        A = lo;
    } else {
        A = lo + (hi - lo) * ((Omega - segment->Omega[0]) / (segment->Omega[1] - segment->Omega[0]));
    }
    double last = hi - lo;
    for (int i = 0; i < 200; i++) {
        double slope;
        if (!(A > lo && A < hi))
            A = sf_amid(0, lo, hi);
        at = sf_sample_at(model, A);
        const double w = sf_branch_at(model, &at, F_0, segment->count, segment->index);
        if ((w > Omega) == falls)
            lo = A;
        else
            hi = A;
        slope = model->by_laws ? sf_law_Omega_A(model, &at, w)
                               : (sf_inertial(model) ? inertia_Omega_A : slow_flow_Omega_A)(w, A, model->m, model->zeta,
                                                                                            at.h, at.h_A);
        double next = A - (w - Omega) / slope;
        const double shift = fabs(next - A);
        if (shift <= SF_AT_ROOT * A || !(lo < hi))
            break;
        if (!(next > lo && next < hi) || shift > SF_SLOW * last)
            next = sf_amid(0, lo, hi);
        if (!(next > lo && next < hi))
            break;
        last = fabs(next - A);
        A = next;
    }
    A = sf_polish_amplitude(model, F_0, Omega, &at);
    return fmin(fmax(A, segment->A[0]), segment->A[1]);
}

static int sf_holds(const sf_segment *segment, double Omega) {
    return fmin(segment->Omega[0], segment->Omega[1]) <= Omega && Omega <= fmax(segment->Omega[0], segment->Omega[1]);
}

/* ==== The window ================================================================================================== */

/* The part of a segment between two frequencies; 0 if there is none. */
static int sf_clip(const sf_model *model, double F_0, const sf_segment *segment, double low, double high,
                   sf_segment *out) {
    *out = *segment;
    if (fmax(segment->Omega[0], segment->Omega[1]) <= low || fmin(segment->Omega[0], segment->Omega[1]) >= high)
        return 0;
    for (int end = 0; end < 2; end++) {
        const double edge = fmin(fmax(segment->Omega[end], low), high);
        if (edge != segment->Omega[end]) {
            out->A[end] = sf_amplitude_on(model, F_0, segment, edge);
            out->Omega[end] = edge;
        }
    }
    return 1;
}

static void sf_close_run(sf_skeleton *shown, int closed) {
    if (shown->start[shown->curves] < shown->segments) {
        shown->closed[shown->curves++] = closed;
        shown->start[shown->curves] = shown->segments;
    }
}

/* One curve inside the window: a curve that leaves it is split there. */
static void sf_show_curve(const sf_model *model, double F_0, const sf_skeleton *all, int curve, double low, double high,
                          sf_skeleton *shown) {
    const int first = all->start[curve], n = all->start[curve + 1] - first;
    int shift = 0, whole = 1;
    sf_segment segment;
    for (int i = 0; i < n; i++) { /* the start of a closed curve is no end: begin behind a place outside the window */
        const sf_segment *p = &all->segment[first + i];
        if (sf_last_of(p, p->Omega) < low || sf_last_of(p, p->Omega) > high) {
            whole = 0;
            shift = i + 1;
        }
    }
    if (!all->closed[curve])
        shift = 0;
    for (int i = 0; i < n; i++) {
        const sf_segment *p = &all->segment[first + (i + shift) % n];
        if (!sf_clip(model, F_0, p, low, high, &segment)) {
            sf_close_run(shown, 0);
            continue;
        }
        segment.curve = shown->curves;
        shown->segment[shown->segments++] = segment;
        if (sf_last_of(&segment, segment.Omega) != sf_last_of(p, p->Omega))
            sf_close_run(shown, 0);
    }
    sf_close_run(shown, all->closed[curve] && whole);
}

/* ==== Samples ===================================================================================================== */

/* What counts as much in the sharing out of points: a frequency and an amplitude of 1, or half the highest frequency
 * and the highest amplitude that are shown, if they are more; the sum of all weights. */
typedef struct {
    double Omega, A, total;
} sf_sharing;

/* Weight of a segment: its extent in Omega and A, with a floor for short ones. */
static double sf_weight(const sf_segment *segment, const sf_sharing *sharing) {
    return fabs(segment->Omega[1] - segment->Omega[0]) / sharing->Omega +
           fabs(segment->A[1] - segment->A[0]) / sharing->A + SF_SPREAD;
}

static void sf_share_out(const sf_skeleton *shown, sf_sharing *sharing) {
    sharing->Omega = sharing->A = 1, sharing->total = 0;
    for (int i = 0; i < shown->segments; i++) {
        const sf_segment *segment = &shown->segment[i];
        sharing->Omega = fmax(sharing->Omega, 0.5 * fmax(segment->Omega[0], segment->Omega[1]));
        sharing->A = fmax(sharing->A, segment->A[1]);
    }
    for (int i = 0; i < shown->segments; i++)
        sharing->total += sf_weight(&shown->segment[i], sharing);
}

static int sf_steps_of(const sf_segment *segment, double samples, const sf_sharing *sharing) {
    return (int)ceil(samples * sf_weight(segment, sharing) / sharing->total);
}

/* The shown segments in a window, and the number of points on them; -1 where it is beyond the range of doubles how far
 * they extend. */
static long sf_show(const sf_model *model, double F_0, double low, double high, double samples, sf_work *work) {
    sf_skeleton *shown = &work->shown;
    sf_sharing sharing;
    long points = 0;
    shown->segments = shown->curves = 0, shown->start[0] = 0;
    for (int i = 0; i < work->skeleton.curves; i++)
        sf_show_curve(model, F_0, &work->skeleton, i, low, high, shown);
    sf_share_out(shown, &sharing);
    if (!(sharing.total < HUGE_VAL))
        return -1;
    for (int i = 0; i < shown->segments; i++)
        points += sf_steps_of(&shown->segment[i], samples, &sharing);
    return points + shown->curves;
}

enum { SF_SHARES = 16 };

/* How far along a segment the k-th of n - 1 points inside lies: they crowd towards its ends, where A or Omega may stand
 * still. */
static double sf_share_at(int k, int n) { return 0.5 - 0.5 * cos(3.14159265358979312 * k / n); }

/* The same of all of them. Cosines of sums, from those of every sixteenth angle and of the first sixteen, take a
 * fraction of the time of one each. */
static void sf_shares(int n, double *fraction) {
    const double step = 3.14159265358979312 / n;
    double cosine[SF_SHARES], sine[SF_SHARES];
    for (int i = 0; i < SF_SHARES; i++)
        cosine[i] = cos(step * i), sine[i] = sin(step * i);
    for (int i = 1; i < n && i < SF_SHARES; i++)
        fraction[i - 1] = 0.5 - 0.5 * cosine[i];
    for (int k = SF_SHARES; k < n; k += SF_SHARES) {
        const double at_cosine = cos(step * k), at_sine = sin(step * k);
        const int here = n - k < SF_SHARES ? n - k : SF_SHARES;
        for (int i = 0; i < here; i++)
            fraction[k + i - 1] = 0.5 - 0.5 * (at_cosine * cosine[i] - at_sine * sine[i]);
    }
}

static void sf_turn_round(int n, double *x) {
    for (int k = 0; k < n / 2; k++) {
        const double kept = x[k];
        x[k] = x[n - 1 - k], x[n - 1 - k] = kept;
    }
}

/* n - 1 rising numbers between two. Where they span orders of magnitude half of them are shared out among these, as
 * Omega changes with each of A's; the others follow the top. */
static void sf_numbers_between(double low, double high, int n, double *x) {
    const int many = low > 0 && high > 100 * low, orders = n / 2, plain = n + 1 - orders;
    int i = 1, j = 1;
    if (!many) {
        sf_shares(n, x);
        for (int k = 0; k < n - 1; k++)
            x[k] = low + (high - low) * x[k];
        return;
    }
    for (int k = 0; k < n - 1; k++) {
        const double of_plain = i < plain ? low + (high - low) * sf_share_at(i, plain) : HUGE_VAL;
        const double of_orders = j < orders ? low * exp(sf_share_at(j, orders) * log(high / low)) : HUGE_VAL;
        x[k] = of_plain <= of_orders ? of_plain : of_orders;
        of_plain <= of_orders ? i++ : j++;
    }
}

/* Omega at n amplitudes inside a segment: by blocks, and one at a time where these do not count the roots that there
 * are, for an excitation by inertia, or by other laws of damping. */
static void sf_frequencies_along(const sf_model *model, double F_0, const sf_segment *segment, int n, const double *A,
                                 double *Omega) {
    const int in_lanes = !sf_inertial(model) && !model->by_laws;
    sf_quartics block;
    sf_jobs jobs;
    for (int first = 0; first < n; first += SF_QUARTICS) {
        const int here = n - first < SF_QUARTICS ? n - first : SF_QUARTICS;
        double averages[2 * SF_QUARTICS];
        jobs.n = 0;
        if (in_lanes) {
            model->mechanism->averaged_2(model->mechanism, here, A + first, model->p, averages);
            for (int i = 0; i < here; i++) {
                block.A[i] = A[first + i], block.h[i] = averages[i];
                block.m[i] = model->m, block.zeta[i] = model->zeta, block.F_0[i] = F_0;
            }
            sf_isolate_lanes(here, &block);
        }
        for (int i = 0; i < here; i++) {
            sf_place place[3];
            if (in_lanes && block.signs[i] != SF_UNSURE &&
                sf_places_of_signs((int)block.signs[i], place) == segment->count) {
                sf_add_job(&block, i, place[segment->index], &jobs);
            } else {
                const sf_sample at = sf_sample_at(model, A[first + i]);
                Omega[first + i] = sf_branch_at(model, &at, F_0, segment->count, segment->index);
            }
        }
        sf_refine_lanes(&jobs);
        for (int k = 0; k < jobs.n; k++)
            Omega[first + jobs.of[k]] = sf_root_of_job(&jobs, k);
    }
}

/* Whether A hardly changes while Omega does, as where Omega^2 is small against h_A: doubles of A do not give Omega
 * there. */
static int sf_is_steep(const sf_segment *segment) {
    const double low = fmin(segment->Omega[0], segment->Omega[1]), high = fmax(segment->Omega[0], segment->Omega[1]);
    return segment->A[1] - segment->A[0] < SF_HARDLY * segment->A[1] * ((high - low) / high);
}

/* n - 1 points inside a segment in the order of its numbers by rising A: at amplitudes, or where it is steep at
 * frequencies.
 * Rounding takes none beyond its ends, between which Omega is monotone. */
static void sf_points_inside(const sf_model *model, double F_0, const sf_segment *segment, int n, double *Omega,
                             double *A) {
    const double low = fmin(segment->Omega[0], segment->Omega[1]), high = fmax(segment->Omega[0], segment->Omega[1]);
    if (sf_is_steep(segment)) {
        sf_numbers_between(low, high, n, Omega);
        if (segment->Omega[0] > segment->Omega[1])
            sf_turn_round(n - 1, Omega);
        for (int k = 0; k < n - 1; k++)
            A[k] = sf_amplitude_on(model, F_0, segment, Omega[k]);
        return;
    }
    sf_numbers_between(segment->A[0], segment->A[1], n, A);
    sf_frequencies_along(model, F_0, segment, n - 1, A, Omega);
    for (int k = 0; k < n - 1; k++)
        Omega[k] = Omega[k] < low ? low : Omega[k] > high ? high : Omega[k];
}

/* The points of one curve as they are drawn. */
typedef struct {
    double *Omega, *A;
    long long *branch;
    unsigned char *stable;
} sf_points;

/* bytes of each */
enum { SF_OF_POINT = 2 * sizeof(double) + sizeof(long long) + 1 };

/* n points in one block of memory. */
static sf_points sf_points_in(double *room, long n) {
    return (sf_points){room, room + n, (long long *)(void *)(room + 2 * n), (unsigned char *)(room + 3 * n)};
}

/* Points of all shown segments in order, but for those at rest, at which the response to an excitation by inertia
 * begins; returns how many are left. */
static long sf_draw(const sf_model *model, double F_0, double samples, const sf_skeleton *shown, const sf_points *out) {
    double *const Omega = out->Omega, *const A = out->A;
    sf_sharing sharing;
    long at = 0, kept = 0;
    sf_share_out(shown, &sharing);
    for (int i = 0; i < shown->segments; i++) {
        const sf_segment *segment = &shown->segment[i];
        const int n = sf_steps_of(segment, samples, &sharing), starts = i == shown->start[segment->curve];
        const long first = at;
        if (starts)
            A[at] = sf_first_of(segment, segment->A), Omega[at++] = sf_first_of(segment, segment->Omega);
        sf_points_inside(model, F_0, segment, n, Omega + at, A + at);
        if (!segment->upward)
            sf_turn_round(n - 1, A + at), sf_turn_round(n - 1, Omega + at);
        at += n - 1;
        A[at] = sf_last_of(segment, segment->A), Omega[at++] = sf_last_of(segment, segment->Omega);
        memset(out->stable + first, segment->stable != 0, (size_t)(at - first));
        for (long point = first; point < at; point++)
            out->branch[point] = segment->curve;
    }
    for (long point = 0; point < at; point++)
        if (A[point] > 0) {
            Omega[kept] = Omega[point], A[kept] = A[point];
            out->branch[kept] = out->branch[point], out->stable[kept++] = out->stable[point];
        }
    return kept;
}
