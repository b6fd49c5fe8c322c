/* Folds that a proof decides where doubles are inconclusive. Takes a model and the oscillator's exact inputs, or NULL
 * where no proof is possible; returns its folds at a forcing and whether their number stays undecided.
 *
 * Doubles are inconclusive where a value whose sign decides is as small as rounding may make it: where F_0 is next to a
 * level at which folds are born or meet or next to 4 mu/pi, and next to a breakpoint at which the force hardly jumps.
 * There the proof, which takes some ten times as long, has the last word; elsewhere it is not used.
 */
#pragma once

#include "certify.h"
#include "refine.h"

/* Needs the corners of work. */
static int sf_are_corners_close(const sf_model *model, const sf_inputs *inputs, double F_0, const sf_work *work) {
    for (int k = 0; k < model->breaks && model->b[k] < work->A_max; k++) {
        const double J = model->jump[k];
        /* a jump that is 0 by rounding is none only if the force as it was given has none */
        const int is_none = J == 0 && (inputs == NULL || sf_is_continuous_at(inputs, k));
        const sf_corner *corner = &work->corner[k];
        if (!is_none && sf_is_corner_close(model, F_0, J, &corner->at, corner->n, corner->Omega))
            return 1;
    }
    return 0;
}

/* Whether F_0 is off the forcing that leaves the mass at rest by no more than rounding may make of it. */
static int sf_nearly_sticks(const sf_model *model, double F_0) {
    const double friction = model->mechanism->dissipation(0, 0, model->damping);
    return !sf_inertial(model) && F_0 <= friction * (1 + SF_CLOSE) && F_0 >= friction * (1 - SF_CLOSE);
}

/* A fold in the middle of its enclosure; which way a sweep leaves it is that in doubles where it is not proved. */
static void sf_add_proved_fold(const sf_model *model, const sf_enclosure *fold, sf_folds *folds) {
    const double Omega = sf_middle(fold->Omega), A = sf_middle(fold->A);
    const sf_sample at = sf_sample_at(model, A);
    sf_add_fold(folds, Omega, A, fold->sign != 0 ? fold->sign < 0 : sf_half_F_AA(model, &at, Omega) < 0, fold->corner);
}

/* What doubles found, where the enclosure holds it, else its middle. */
static double sf_within(sf_interval enclosure, double known) {
    return enclosure.lo <= known && known <= enclosure.hi ? known : sf_middle(enclosure);
}

/* The folds that are proved; 0 if doubles do not decide. Next to a breakpoint at which the force hardly jumps doubles
 * may have as many folds, but with a frequency of the other side of the resonance. */
static int sf_take_proved_folds(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room,
                                sf_folds *folds) {
    const sf_certificate *found = &room->found;
    if (sf_certify_folds(model, inputs, F_0, room) != SF_OK || !sf_is_proved(found))
        return 0;
    int same = folds->status == SF_OK && found->n == folds->n;
    for (int i = 0; i < found->n; i++)
        same = same && folds->at[i].corner == found->at[i].corner;
    for (int i = 0; same && i < found->n; i++) {
        const sf_enclosure *fold = &found->at[i];
        folds->at[i].Omega = sf_within(fold->Omega, folds->at[i].Omega);
        folds->at[i].A = sf_within(fold->A, folds->at[i].A);
        if (fold->sign != 0)
            folds->at[i].up = fold->sign < 0;
    }
    if (!same) {
        folds->n = 0, folds->status = SF_OK;
        for (int i = 0; i < found->n; i++)
            sf_add_proved_fold(model, &found->at[i], folds);
    }
    return folds->status == SF_OK;
}

/* Every fold as sf_saddle_nodes has them. There is no proof by other laws of damping. */
static sf_status sf_decided_folds(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room,
                                  sf_folds *folds) {
    sf_status status = sf_saddle_nodes(model, F_0, &room->work, folds);
    room->inconclusive = room->undecided = 0, room->proofs = 0;
    if (status == SF_STICKS || status == SF_NO_BOUND)
        return status;
    folds->status = status;
    room->inconclusive = status != SF_OK || folds->undecided || folds->close || sf_nearly_sticks(model, F_0) ||
                         sf_are_corners_close(model, inputs, F_0, &room->work);
    if (room->inconclusive)
        room->undecided = !sf_take_proved_folds(model, model->by_laws ? NULL : inputs, F_0, room, folds);
    folds->undecided = room->undecided;
    return folds->status;
}

/* Whether the averaged force is proportional to the amplitude: there are no folds then, however near to 4 mu/pi. */
static int sf_is_linear(const sf_model *model) {
    if (model->breaks > 0 || sf_inertial(model))
        return 0;
    const sf_sample at = sf_sample_without_k_at(model, fmin(1, 0.5 * model->mechanism->reach));
    return at.h_AA == 0 && fabs(at.k) <= SF_LINEAR * fabs(at.h);
}

/* Whether a fold is of a peak so sharp that rounding of A Omega^2 alone takes a point off the response: Newton's method
 * may stay anywhere along the backbone there. */
static int sf_is_sharp(const sf_folds *folds, double F_0) {
    int i = 0;
    while (i < folds->n && !(folds->at[i].A * folds->at[i].Omega * folds->at[i].Omega > SF_SHARP * F_0))
        i++;
    return i < folds->n;
}

/* The last digits of folds, of which proofs have what Newton's method leaves. Returns how far off one is left,
 * relatively. */
static double sf_settle_or_prove(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room,
                                 sf_folds *folds) {
    const double off = inputs == NULL ? 0 : sf_settle_folds(&inputs->exactly, model, F_0, folds);
    if (inputs == NULL || off > SF_FEW_DIGITS || !(off > SF_FEW_ROUNDINGS || sf_is_sharp(folds, F_0)))
        return off;
    const sf_folds settled = *folds;
    if (!sf_take_proved_folds(model, inputs, F_0, room, folds) || folds->n != settled.n)
        *folds = settled;
    return off;
}

/* The same to their last digit. */
static sf_status sf_settled_folds(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room,
                                  sf_folds *folds) {
    const int laws = model->by_laws;
    if (sf_is_linear(model) && !sf_sticks(model, F_0)) {
        folds->n = folds->undecided = 0;
        return folds->status = SF_OK;
    }
    const sf_status status = sf_decided_folds(model, inputs, F_0, room, folds);
    if (status == SF_OK && !laws && sf_settle_or_prove(model, inputs, F_0, room, folds) > SF_FEW_DIGITS)
        folds->undecided = 1;
    return status;
}
