/* Peaks by other laws of damping. Takes a model and a forcing; returns the points at which the level of an amplitude is
 * stationary, what happens there, and the highest one at which stable motions end.
 */
#pragma once

#include "locus.h"
#include "points.h"

/* The peak where I knows no frequency: F_Omega = 0 leaves R = 0, and F = 0 then I = F_0, each of one variable. Where
 * damping is weak F bends so much next to it that boxes have to be small, as small as what rounding leaves of
 * R. Next to an end of a piece it is not known on which it is, nor where h vanishes, whether Omega^2 > 0. */
static void sf_find_structural_peak(const sf_model *model, double F_0, const sf_stretches *pieces,
                                    sf_law_points *found) {
    sf_law_point point = {0};
    sf_known known;
    int is_inside = 0, is_on_end = 0;
    point.A = dissipation_limit_envelope(1, F_0, model->m, 0, model->eta, 0);
    const double low = point.A * (1 - SF_ERROR), high = point.A * (1 + SF_ERROR);
    for (int i = 0; i < pieces->n; i++) {
        const double a = pieces->at[i].first.A, b = pieces->at[i].last.A;
        is_on_end |= (low <= a && a <= high) || (low <= b && b <= high);
        if (a < low && high < b && sf_has_force(&pieces->at[i]))
            is_inside = 1, point.part = i;
    }
    const sf_sample at = sf_sample_at(model, point.A);
    sf_know(&at, &known);
    found->n = found->undecided = 0, found->status = SF_OK;
    if (is_on_end || (is_inside && !sfi_has_sign(known.h))) {
        found->doubt[found->undecided++] = point.A;
    } else if (is_inside && known.h.hi < 0) {
        point.Omega = slow_flow_backbone(point.A, at.h);
        found->at[found->n++] = point;
    }
}

/* All peaks on the pieces of work. */
static sf_status sf_find_law_peaks(const sf_model *model, double F_0, sf_work *work) {
    if (!sf_inertial(model) && model->zeta == 0 && model->d == 0 && !model->released)
        sf_find_structural_peak(model, F_0, &work->pieces, &work->points.found);
    else
        sf_search_pieces(model, SF_LAW_PEAKS, F_0, &work->pieces, &work->points);
    return work->points.found.status;
}

/* Whether F rises with A at a peak: by the R that F_Omega = 0 leaves, in which nothing cancels. */
static int sf_rises_at_peak(const sf_model *model, const sf_sample *at, double w) {
    const sf_law_terms of = sf_law_terms_below(model, at->A);
    const double I = dissipation_I(w, at->A, of.rest[0], of.zeta[0], of.d, of.d_3);
    if (sf_inertial(model))
        return sf_law_F_A(model, at, w, sf_is_beyond(model, at->A)) > 0;
    return dissipation_F_A_halved(dissipation_R_of_peak(w, at->A, of.zeta[0], of.d, of.d_3, I), w * w + at->h_A, I,
                                  dissipation_I_A(w, at->A, of.rest[1], of.zeta[0], of.zeta[1], of.d, of.d_3)) > 0;
}

/* Whether F has a maximum over Omega at a peak; under an excitation by inertia F_OmegaOmega is what vanishes where the
 * level is stationary, by 1/Omega, times a positive number. */
static int sf_bends_at_peak(const sf_model *model, const sf_sample *at, double w) {
    const sf_law_terms of = sf_law_terms_below(model, at->A);
    const double *rest = of.rest, *zeta = of.zeta;
    double far[4], f[6];
    if (!sf_inertial(model))
        return dissipation_F_OmegaOmega(w, at->A, rest[0], zeta[0], of.d, of.d_3, at->h) < 0;
    dissipation_far(1 / w, at->A, rest[0], rest[1], zeta[0], zeta[1], of.d, at->h, at->h_A, far);
    dissipation_peaks_far_by_x(1 / w, at->A, 0, rest[0], rest[1], rest[2], rest[3], zeta[0], zeta[1], zeta[2], zeta[3],
                               of.d, 0, at->h, at->h_A, at->h_AA, at->h_AAA, far[0], far[2], far[1], far[3], f);
    return f[5] < 0;
}

/* Whether stable motions end in a static state: the spring pulls there, or nowhere, F rises, and no frequency goes on
 * above. */
static int sf_is_static_top(const sf_model *model, double F_0, const sf_sample *rest, double A) {
    double w[2];
    const sf_sample at = sf_sample_at(model, A);
    if (!(sf_law_F_A(model, &at, 0, sf_is_beyond(model, A)) > 0) ||
        (at.h > 0 && !(rest->h > 0 || (rest->h == 0 && !(rest->h_A < 0)))))
        return 0;
    const int n = sf_law_stationary(model, &at, w);
    for (int i = 0; i < n; i++)
        if (sf_law_level(model, &at, w[i]) < F_0 * (1 - SF_CLOSE))
            return 0;
    return 1;
}

/* The highest peak as sf_peak has it: where a pair of frequencies ends that is there below. With SF_UNRESOLVED A is the
 * highest amplitude at which doubles do not resolve whether there is one, if it is known. */
static sf_status sf_law_peak(const sf_model *model, double F_0, double most, sf_work *work, double *A, double *Omega) {
    const sf_law_points *peaks = &work->points.found;
    double highest = 0, doubt = 0;
    if (!sf_inertial(model) && !(F_0 > sf_friction_throughout(model)) && !model->released)
        return SF_STICKS;
    const sf_status status = sf_range_at(model, F_0, &work->A_max);
    if (status != SF_OK)
        return status;
    sf_stretches_up_to(model, fmin(work->A_max, most), &work->pieces);
    if (sf_find_law_peaks(model, F_0, work) != SF_OK)
        return peaks->status;
    for (int i = 0; i < peaks->n; i++) {
        const sf_sample at = sf_sample_at(model, peaks->at[i].A);
        if (at.A > highest && sf_rises_at_peak(model, &at, peaks->at[i].Omega) &&
            !sf_bends_at_peak(model, &at, peaks->at[i].Omega))
            highest = at.A, *Omega = peaks->at[i].Omega;
    }
    for (int i = work->pieces.n - 1; i >= 0 && highest == 0 && !sf_inertial(model); i--) {
        sf_clear_zeros(&work->zeros);
        sf_ask_all(model, SF_REST, F_0, &work->pieces.at[i], &work->zeros);
        if (work->zeros.status != SF_OK)
            return work->zeros.status;
        for (int k = 0; k < work->zeros.n; k++)
            if (work->zeros.at[k].A > highest &&
                sf_is_static_top(model, F_0, &work->pieces.at[0].first, work->zeros.at[k].A))
                highest = work->zeros.at[k].A, *Omega = 0;
    }
    for (int i = 0; i < peaks->undecided; i++)
        doubt = fmax(doubt, peaks->doubt[i]);
    if (highest > 0 || doubt > 0)
        *A = fmax(highest, doubt);
    if (doubt > highest)
        return SF_UNRESOLVED;
    if (highest == 0)
        return !sf_inertial(model) && F_0 <= model->m && !(most < HUGE_VAL) ? SF_STICKS : SF_NONE;
    return SF_OK;
}
