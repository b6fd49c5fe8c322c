/* Steady states at a frequency. Takes a model; returns the amplitudes.
 *
 * They are the zeros of F along the amplitude, each in an interval that is proved to hold no other one, and where
 * none is inconclusive that is all. Else the response curve in segments gives the amplitudes on them, and a proof's
 * in their place where doubles are inconclusive and the proof decides. The number changes where Omega passes a fold:
 * so doubles are inconclusive next to one, and wherever the folds were. */
#pragma once

#include "curve.h"

/* no fewer than there are at a frequency */
enum { SF_MOST_STATES = SF_MOST_SEGMENTS };

/* A state among those by rising A; one at an end of its segment, where another begins, is one with that, and a fold is
 * not stable. Two inside segments are two, even where their amplitudes are the same double. */
static int sf_add_state(double found, int is_stable, int is_end, int n, double *A, unsigned char *stable) {
    int i;
    for (i = n; i > 0 && A[i - 1] > found; i--)
        ;
    for (int j = i > 0 ? i - 1 : 0; is_end && j <= i && j < n; j++)
        if (fabs(A[j] - found) <= SF_SAME * found) {
            stable[j] = (unsigned char)(stable[j] && is_stable);
            return n;
        }
    for (int j = n; j > i; j--)
        A[j] = A[j - 1], stable[j] = stable[j - 1];
    A[i] = found, stable[i] = (unsigned char)is_stable;
    return n + 1;
}

/* Whether an amplitude is that of a fold, which has its digits. */
static int sf_is_of_fold(const sf_folds *folds, double Omega, double A) {
    int i = 0;
    while (i < folds->n && !(folds->at[i].Omega == Omega && folds->at[i].A == A))
        i++;
    return i < folds->n;
}

/* The amplitude at which a segment has the given Omega, to its last digit. At an end it shifts by no more than
 * rounding. */
static double sf_settled_amplitude(const sf_model *model, const sf_exactly *exactly, double F_0, const sf_work *work,
                                   const sf_segment *segment, int is_end, double Omega) {
    const double A = sf_amplitude_on(model, F_0, segment, Omega);
    const int piece = sf_piece_of(model, 0.5 * (segment->A[0] + segment->A[1]));
    sf_settling of = {sfp_point(Omega), sfp_point(A), sfp_point(F_0)};
    if (exactly == NULL || (is_end && sf_is_of_fold(&work->folds, Omega, A)))
        return A;
    if ((sf_piece_of(model, A) != piece ||
         !sf_settle_near(slow_flow_pairs_state_step, SF_VARY_A, 2, exactly, model, NULL, &of)) &&
        !sf_settle_state_above(exactly, model, piece, Omega, F_0, A, &of))
        of.A.high = sf_state_between(exactly, model, Omega, F_0, A);
    if (is_end)
        return fabs(of.A.high - A) <= SF_FEW_ROUNDINGS * A ? of.A.high : A;
    return segment->A[0] * (1 - SF_SAME) <= of.A.high && of.A.high <= segment->A[1] * (1 + SF_SAME) ? of.A.high : A;
}

/* Of two states with the same double the lower one is stable if the next below is not: F crosses 0 upward and downward
 * in turn along the amplitude, beginning below 0. */
static void sf_order_same(int n, const double *A, unsigned char *stable) {
    for (int i = 0; i + 1 < n; i++)
        if (A[i] == A[i + 1] && stable[i] != stable[i + 1]) {
            stable[i] = (unsigned char)(i == 0 || !stable[i - 1]);
            stable[i + 1] = (unsigned char)!stable[i];
        }
}

/* The states of the segments at Omega, by rising A; returns their number. */
static int sf_states_of_segments(const sf_model *model, const sf_exactly *exactly, double F_0, const sf_work *work,
                                 double Omega, double *A, unsigned char *stable) {
    int n = 0;
    for (int i = 0; i < work->skeleton.segments; i++) {
        const sf_segment *segment = &work->skeleton.segment[i];
        const int is_end = Omega == segment->Omega[0] || Omega == segment->Omega[1];
        const int is_at_rest = is_end && Omega == segment->Omega[0] && segment->A[0] == 0;
        if (sf_holds(segment, Omega) && !is_at_rest)
            n = sf_add_state(sf_settled_amplitude(model, exactly, F_0, work, segment, is_end, Omega), segment->stable,
                             is_end, n, A, stable);
    }
    sf_order_same(n, A, stable);
    return n;
}

/* Whether Omega is that of a fold to within what rounding may make of F there. */
static int sf_is_at_fold(const sf_model *model, double F_0, const sf_folds *folds, double Omega) {
    for (int i = 0; i < folds->n; i++) {
        if (fabs(folds->at[i].Omega - Omega) > SF_DISTINCT * fmax(folds->at[i].Omega, Omega))
            continue;
        const sf_sample at = sf_sample_at(model, folds->at[i].A);
        if (sf_is_F_close(model, &at, F_0, Omega))
            return 1;
    }
    return 0;
}

/* The first of n amplitudes inside an enclosure of a state, its middle if there is none. */
static double sf_first_within(sf_interval within, int n, const double *A) {
    for (int i = 0; i < n; i++)
        if (within.lo <= A[i] && A[i] <= within.hi)
            return A[i];
    return sf_middle(within);
}

/* The states that are proved, those found moved into their enclosures; 0 if doubles do not decide. */
static int sf_take_proved_states(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room,
                                 double Omega, int *n, double *A, unsigned char *stable) {
    const sf_certificate *found = &room->found;
    double before[SF_MOST_STATES];
    room->proofs++;
    if (sf_certify_states(model, inputs, F_0, Omega, room) != SF_OK || !sf_is_proved(found))
        return 0;
    const int same = found->n == *n;
    memcpy(before, A, (size_t)*n * sizeof *A);
    for (int i = 0; i < found->n; i++) {
        const sf_interval within = found->at[i].A;
        A[i] = same ? sfi_least(sfi_most(A[i], within.lo), within.hi) : sf_first_within(within, *n, before);
        stable[i] = (unsigned char)(found->at[i].sign > 0);
    }
    *n = found->n;
    return 1;
}

/* The steady states at Omega by rising A, from the segments; returns their number. undecided: whether doubles do not
 * resolve it */
static int sf_states_on_curve(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room, double Omega,
                              double *A, unsigned char *stable, int *undecided) {
    if (model->by_laws)
        inputs = NULL;
    int n = sf_states_of_segments(model, inputs == NULL ? NULL : &inputs->exactly, F_0, &room->work, Omega, A, stable);
    if (room->inconclusive || sf_is_at_fold(model, F_0, &room->work.folds, Omega))
        *undecided = inputs == NULL || !sf_take_proved_states(model, inputs, F_0, room, Omega, &n, A, stable);
    return n;
}

/* An amplitude above all states at a frequency: there I exceeds F_0, even if F_0 - m is all but rounding. */
static double sf_above_states(const sf_model *model, double F_0, double Omega) {
    return slow_flow_limit_envelope(Omega, F_0 * (1 + SF_CLOSE), model->m, model->zeta) * (1 + SF_CLOSE);
}

/* The steady states at Omega by rising A where no number of doubles is near to deciding how many there are, each
 * settled to its last digit; returns their number, or -1. Without friction and with little of it, without viscous
 * damping and for an excitation by inertia the curve is used. */
static int sf_clear_states(const sf_model *model, const sf_exactly *exactly, double F_0, double Omega, sf_work *work,
                           double *A, unsigned char *stable) {
    sf_task task = sf_task_of(SF_STATE, model, F_0);
    sf_zeros *found = &work->zeros;
    int n = 0;
    if (sf_inertial(model) || !(model->zeta > 0) || sf_nearly_sticks(model, F_0))
        return -1;
    const double A_max = sf_above_states(model, F_0, Omega);
    if (!(A_max > SF_FIRST && A_max < SF_ENDLESS))
        return -1;
    task.Omega = Omega;
    sf_stretches_up_to(model, A_max, &work->pieces);
    for (int i = 0; i < work->pieces.n; i++) {
        sf_clear_zeros(found);
        sf_find_zeros(&task, &work->pieces.at[i], found);
        if (found->status != SF_OK || found->undecided || found->close)
            return -1;
        sf_sort_zeros(found);
        for (int k = 0; k < found->n; k++) {
            sf_settling of = {sfp_point(Omega), sfp_point(found->at[k].A), sfp_point(F_0)};
            if (n == SF_MOST_STATES || sf_piece_of(model, of.A.high) != i ||
                !sf_settle_near(slow_flow_pairs_state_step, SF_VARY_A, 2, exactly, model, NULL, &of))
                return -1;
            A[n] = of.A.high, stable[n++] = (unsigned char)found->at[k].rising;
        }
    }
    return n;
}

/* The steady states at Omega by rising A, at most SF_MOST_STATES. undecided: whether doubles do not resolve their
 * number */
static sf_status sf_states(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room, double Omega,
                           int *n, double *A, unsigned char *stable, int *undecided) {
    *undecided = 0;
    *n = inputs == NULL || model->by_laws
             ? -1
             : sf_clear_states(model, &inputs->exactly, F_0, Omega, &room->work, A, stable);
    if (*n >= 0)
        return SF_OK;
    *n = 0;
    if (!room->followed)
        room->status = sf_make_skeleton(model, inputs, F_0, room);
    room->followed = 1;
    if (room->status == SF_OK)
        *n = sf_states_on_curve(model, inputs, F_0, room, Omega, A, stable, undecided);
    return room->status;
}
