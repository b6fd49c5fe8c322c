/* Critical forcings: in goes a model, out come detachment, the onset of folds, and the peak at a forcing.
 *
 * Cusps and isola points are explicit in A (questions.h), so the onset needs no locus. The pieces of the force are
 * looked through from below; the last, which has no end, as far as a state at the best forcing found so far can lie.
 */
#ifndef SF_ONSET_H
#define SF_ONSET_H

#include "locus.h"

static sf_status sf_detachment(const sf_model *model, double *F_cr, double *Omega_cr, double *u_cr) {
    sf_sample at;
    *F_cr = *Omega_cr = *u_cr = NAN;
    if (model->breaks == 0)
        return SF_NONE;
    sf_sample_at(model, model->b[0], &at);
    *u_cr = at.A + fabs(model->mechanism->mean_offset(at.A, model->p));
    *F_cr = sf_least_forcing(model, &at, Omega_cr);
    return SF_OK;
}

static void sf_consider(const sf_model *model, const sf_sample *at, double w, sf_onset_kind kind, sf_onset *best) {
    const double level = sf_level(model, at, w);
    if (level < best->F_SN)
        best->F_SN = level, best->Omega = w, best->A = at->A, best->kind = kind;
}

/* Cusps and isola points among the nodes of one chart, where the level is least. */
static void sf_consider_extrema(const sf_model *model, const sf_nodes *nodes, sf_zeros *zeros, sf_onset *best) {
    int i, softens = 0;
    zeros->n = 0;
    for (i = 0; i < nodes->n; i++)
        softens |= nodes->at[i].h_A >= 0;
    if (softens) {
        sf_find_zeros(model, SF_STIFFNESS, 0, nodes, zeros);
        sf_find_zeros(model, SF_ISOLA, 0, nodes, zeros);
    }
    sf_find_zeros(model, SF_CUSP, 0, nodes, zeros);
    for (i = 0; i < zeros->n; i++) {
        const sf_zero *zero = &zeros->at[i];
        double w = zero->Omega;
        sf_sample at;
        sf_sample_at(model, zero->A, &at);
        if (zero->question == SF_STIFFNESS) {
            best->rest = fmin(best->rest, sf_level(model, &at, 0));
            continue;
        }
        if (zero->question == SF_CUSP)
            sf_polish_cusp(model, &w, &at);
        if (sf_is_minimum(model, zero->question, &at, w))
            sf_consider(model, &at, w, zero->question == SF_CUSP ? SF_CUSP_KIND : SF_ISOLA_KIND, best);
    }
}

/* Folds that sit on breakpoint k fill the Omega for which F_A changes its sign there: from where the locus below ends, or
 * from R = 0, where the locus above comes in with h_A infinite; between, the level may be stationary (F_Omega = 0). */
static void sf_consider_corner(const sf_model *model, int k, sf_onset *best) {
    sf_sample at, above;
    double w[3];
    int i, n;
    sf_sample_at(model, model->b[k], &at);
    if (model->jump[k] == 0) { /* the locus goes on, but its level turns where h_AA jumps */
        n = sf_fold_roots(at.A, at.h, at.h_A, model->m, model->zeta, w);
        for (i = 0; i < n; i++)
            sf_consider(model, &at, w[i], SF_CORNER_KIND, best);
        return;
    }
    sf_sample_at(model, nextafter(model->b[k], HUGE_VAL), &above);
    n = sf_fold_roots(at.A, at.h, at.h_A, model->m, model->zeta, w);
    for (i = 0; i < n; i++)
        sf_consider(model, &at, w[i], SF_CORNER_KIND, best);
    if (at.h < 0)
        sf_consider(model, &at, slow_flow_backbone(at.A, at.h), SF_CORNER_KIND, best);
    n = sf_peak_roots(at.A, at.h, model->m, model->zeta, w);
    for (i = 0; i < n; i++)
        if ((sf_half_F_A(model, &at, w[i]) > 0) != (sf_half_F_A(model, &above, w[i]) > 0))
            sf_consider(model, &at, w[i], SF_CORNER_KIND, best);
}

/* Whether the least forcing rises from the last breakpoint to A_max, from above the best so far: then nothing there is
 * better. It rises while h < 0 and h_A < 0; both vary as the force does, so that a coarse chart shows it. */
static int sf_nothing_above(const sf_model *model, double b, double best, double A_max) {
    double w, e = SF_FIRST_ABOVE, A = nextafter(b, HUGE_VAL), h[2];
    sf_sample at;
    sf_sample_at(model, b, &at);
    if (!(sf_least_forcing(model, &at, &w) > best))
        return 0;
    while (A < A_max) {
        model->mechanism->averaged_2(1, &A, model->p, h);
        if (!(h[0] < 0 && h[1] < 0))
            return 0;
        e *= SF_STEP_NEAR;
        A = b + b * e * e / (2 * (1 + e));
        A = fmax(A, nextafter(b, HUGE_VAL));
    }
    return 1;
}

static int sf_is_linear(const sf_nodes *nodes) {
    int i;
    for (i = 0; i < nodes->n; i++)
        if (nodes->at[i].h_AA != 0)
            return 0;
    return 1;
}

/* The last piece, from the breakpoint b or from 0. */
static sf_status sf_onset_in_last(const sf_model *model, double b, sf_work *work, sf_onset *best) {
    sf_nodes *nodes = &work->chart[0];
    double F_0 = best->F_SN, A_max;
    int i;
    if (!(F_0 < HUGE_VAL))
        F_0 = SF_RAISE * fmax(model->m, 1e-6);
    for (i = 0; i < SF_RAISES; i++) {
        sf_status status = sf_amplitude_bound(model, F_0, &A_max);
        if (status != SF_OK)
            return status;
        if (SF_SKIP && b > 0 && best->F_SN <= F_0 && sf_nothing_above(model, b, best->F_SN, A_max))
            return SF_OK;
        status = b > 0 ? sf_nodes_above(model, b, A_max, nodes)
                       : sf_nodes_from_zero(model, 0, A_max, nodes);
        if (status != SF_OK)
            return status;
        if (b == 0 && sf_is_linear(nodes))
            return SF_NONE;
        sf_consider_extrema(model, nodes, &work->zeros, best);
        if (best->F_SN <= F_0)
            return SF_OK;
        F_0 = best->F_SN < HUGE_VAL ? best->F_SN : SF_RAISE * F_0;
    }
    return SF_NONE;
}

static sf_status sf_onset_undamped(const sf_model *model, sf_work *work) {
    const sf_status status = sf_saddle_nodes(model, 2 * model->m + 1, work, &work->folds);
    if (status != SF_OK)
        return status;
    return work->folds.n > 0 ? SF_UNBOUNDED : SF_NONE;
}

/* The lowest forcing that has a fold. */
static sf_status sf_find_onset(const sf_model *model, sf_work *work, sf_onset *best) {
    sf_status status = SF_OK;
    int k;
    best->F_SN = best->rest = HUGE_VAL;
    best->Omega = best->A = NAN, best->kind = SF_NO_KIND;
    work->zeros.status = SF_OK;
    if (model->zeta == 0) {
        best->F_SN = NAN;
        return sf_onset_undamped(model, work);
    }
    for (k = 0; k < model->breaks && status == SF_OK; k++) {
        status = k == 0 ? sf_nodes_from_zero(model, 0, model->b[0], &work->chart[0])
                        : sf_nodes_above(model, model->b[k - 1], model->b[k], &work->chart[0]);
        if (status == SF_OK)
            sf_consider_extrema(model, &work->chart[0], &work->zeros, best);
        sf_consider_corner(model, k, best);
    }
    if (status == SF_OK)
        status = sf_onset_in_last(model, model->breaks > 0 ? model->b[model->breaks - 1] : 0, work, best);
    if (status == SF_OK)
        status = work->zeros.status;
    if (best->kind == SF_NO_KIND) {
        best->F_SN = NAN;
        return status == SF_OK ? SF_NONE : status;
    }
    return status;
}

/* ==== Peak ========================================================================================================= */

/* The highest zero of one question in one chart, from above: for SF_PEAK only where A has a maximum along the curve. */
static int sf_highest(const sf_model *model, sf_question question, double F_0, const sf_nodes *nodes,
                         sf_zeros *found, sf_point *out) {
    sf_search search;
    sf_probe low, high;
    int i, k;
    search.model = model, search.question = question, search.F_0 = F_0, search.found = found;
    for (i = nodes->n - 1; i >= 0; i--) {
        low.at = nodes->at[i];
        sf_ask(question, model, F_0, &low.at, &low.answer);
        found->n = 0, found->status = SF_OK;
        if (i < nodes->n - 1)
            for (search.channel = 0; search.channel < sf_channels(question); search.channel++)
                sf_between(&search, &low, &high, 0);
        sf_sort_zeros(found);
        for (k = found->n - 1; k >= 0; k--)
            if (question == SF_REST || found->at[k].rising == found->at[k].channel) {
                out->A = found->at[k].A, out->Omega = found->at[k].Omega;
                return 1;
            }
        high = low;
    }
    return 0;
}

/* Whether the curve has its peak on a breakpoint, to rounding: F there is below zero, and above on the next amplitude. */
static int sf_peak_on_breakpoint(const sf_model *model, double F_0, double b, sf_point *out) {
    sf_sample at;
    sf_answer below, above;
    sf_sample_at(model, b, &at);
    sf_ask(SF_PEAK, model, F_0, &at, &below);
    sf_sample_at(model, nextafter(b, HUGE_VAL), &at);
    sf_ask(SF_PEAK, model, F_0, &at, &above);
    out->A = b, out->Omega = below.Omega[1];
    return below.exists[1] && above.exists[1] && below.y[1] < 0 && above.y[1] >= 0;
}

/* The charts from the last to the first. */
static sf_status sf_highest_of_all(const sf_model *model, sf_question question, double F_0, double A_max,
                                      sf_work *work, sf_point *out) {
    int k;
    for (k = model->breaks; k >= 0; k--) {
        const double start = k > 0 ? model->b[k - 1] : 0;
        sf_status status;
        if (!(start < A_max))
            continue;
        status = k == 0 ? sf_nodes_from_zero(model, F_0, A_max, &work->chart[0])
                        : sf_nodes_above(model, start, A_max, &work->chart[0]);
        if (status != SF_OK)
            return status;
        if (sf_highest(model, question, F_0, &work->chart[0], &work->zeros, out))
            return work->zeros.status;
        if (k > 0 && question == SF_PEAK && sf_peak_on_breakpoint(model, F_0, start, out))
            return SF_OK;
        A_max = start;
    }
    return SF_NONE;
}

/* The highest peak of the response at F_0, isolas included, and its frequency; where A only falls with Omega, the static
 * amplitude at Omega = 0. For zeta > 0. */
static sf_status sf_peak(const sf_model *model, double F_0, sf_work *work, double *A, double *Omega) {
    sf_point found;
    sf_status status;
    double A_max;
    *A = *Omega = NAN;
    if (sf_sticks(model, F_0))
        return SF_STICKS;
    if (model->zeta == 0)
        return SF_UNBOUNDED;
    status = sf_amplitude_bound(model, F_0, &A_max);
    if (status == SF_OK)
        status = sf_highest_of_all(model, SF_PEAK, F_0, A_max, work, &found);
    if (status == SF_NONE)
        status = sf_highest_of_all(model, SF_REST, F_0, A_max, work, &found);
    if (status == SF_OK)
        *A = found.A, *Omega = found.Omega;
    return status;
}

#endif
