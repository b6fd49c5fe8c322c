/* Folds by other laws of damping. Takes a model and a forcing; returns all of them, by rising Omega.
 *
 * Those inside of pieces are points of a system (points.h). On a breakpoint at which the force jumps, or beyond which
 * nothing rubs, F_A may change its sign without passing 0: there are corners.
 */
#ifndef SF_LAW_FOLDS_H
#define SF_LAW_FOLDS_H

#include "exact_inputs.h"
#include "locus.h"
#include "points.h"

/* Whether the side above breakpoint i is stable at a state on it: by the force's jump, or by what rubs no more. */
static int sf_law_is_stable_above(const sf_model *model, int i, const sf_sample *at, double w) {
    if (model->jump[i] != 0)
        return slow_flow_R(w, at->A, at->h) * model->jump[i] > 0;
    return sf_law_F_A(model, at, w, 1) > 0;
}

/* Whether folds may sit on a breakpoint. */
static int sf_has_law_corner(const sf_model *model, int i) {
    return model->jump[i] != 0 || (i == 0 && model->released);
}

/* given: NULL where the oscillator as it was given is not known, by which a jump that is 0 by rounding is told */
static void sf_add_law_corners(const sf_model *model, const sf_given *given, double F_0, double A_max, sf_folds *folds) {
    int i, k;
    for (k = 0; k < model->breaks && model->b[k] < A_max; k++) {
        const int is_none = model->jump[k] == 0 && (given == NULL || sf_is_continuous_at(given, k));
        const int is_corner = sf_has_law_corner(model, k);
        double w[3];
        sf_sample at;
        int n;
        if (is_none && !is_corner)
            continue;
        sf_sample_at(model, model->b[k], &at);
        n = sf_law_frequencies(model, &at, SF_OF_RESPONSE, F_0, 0, w);
        folds->undecided |= !is_none && sf_is_corner_close(model, F_0, model->jump[k], &at, n, w);
        for (i = 0; is_corner && i < n && w[i] < HUGE_VAL; i++) {
            const int below = sf_law_F_A(model, &at, w[i], 0) > 0;
            if (below != sf_law_is_stable_above(model, k, &at, w[i]))
                sf_add_fold(folds, w[i], at.A, below, 1);
        }
    }
}

/* Every fold at F_0, by rising Omega. */
static sf_status sf_law_folds(const sf_model *model, const sf_given *given, double F_0, sf_work *work, sf_folds *folds) {
    const sf_law_points *found = &work->points.found;
    sf_status status;
    int i;
    folds->n = folds->undecided = folds->close = 0, folds->status = SF_OK;
    if (!sf_inertial(model) && !(F_0 > sf_friction_throughout(model)) && !model->released)
        return SF_STICKS;
    status = sf_range_at(model, F_0, &work->A_max);
    if (status != SF_OK && status != SF_UNBOUNDED)
        return status;
    sf_stretches_up_to(model, work->A_max, &work->pieces);
    sf_search_pieces(model, SF_LAW_FOLDS, F_0, &work->pieces, &work->points);
    if (found->status != SF_OK)
        return found->status;
    folds->undecided = found->undecided > 0 || (!sf_inertial(model) && fabs(F_0 - model->m) <= SF_CLOSE * model->m);
    for (i = 0; i < found->n; i++) {
        sf_sample at;
        sf_sample_at(model, found->at[i].A, &at);
        sf_add_fold(folds, found->at[i].Omega, at.A, sf_law_F_AA(model, &at, found->at[i].Omega) < 0, 0);
    }
    sf_add_law_corners(model, given, F_0, work->A_max, folds);
    return folds->status;
}

#endif
