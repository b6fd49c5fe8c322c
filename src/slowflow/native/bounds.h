/* How far amplitudes go. Takes a model and a forcing; returns an amplitude above that of every steady state there, or
 * why there is none.
 */
#pragma once

#include "arc_links.h"
#include "scan.h"

/* Amplitudes to begin at are not larger: squares of endless ones are doubles, which a stiffness that is 0 makes 0. */
#define SF_SQUARED (0x1p511 / SF_ENDLESS)

/* The last Omega > 0 at which the level of a force is stationary, its minimum over Omega > 0; 0 if there is none. */
static double sf_last_stationary(const sf_model *model, const sf_sample *at) {
    sf_quartic cubic;
    double w[2];
    const int n = sf_unpolished_peak_roots(&cubic, at->A, at->h, model->m, model->zeta, w);
    return n > 0 ? sf_polish_cubic(&cubic, w[n - 1]) : 0;
}

/* The lowest F_0 for which A is a steady state: the minimum of its level over Omega >= 0, and where it lies. */
static double sf_least_forcing(const sf_model *model, const sf_sample *at, double *Omega) {
    if (sf_is_of_laws(model, 0))
        return sf_least_by_laws(model, at, Omega);
    const double last = sf_last_stationary(model, at);
    const double at_rest = sf_level(model, at, 0), level = sf_level(model, at, last);
    *Omega = level < at_rest ? last : 0;
    return level < at_rest ? level : at_rest;
}

/* A damping ratio that no cycle of this amplitude or more has less than. */
SF_FLAT static double sf_least_zeta(const sf_model *model, double A) { return sf_law_terms_below(model, A).zeta[0]; }

/* What |h| is at most at a state of an amplitude: the frequencies that damping leaves to it fall as the amplitude
 * rises. */
static double sf_most_restoring(const sf_model *model, double F_0, double A) {
    double most = HUGE_VAL;
    if (model->zeta > 0)
        most = fmin(most, slow_flow_most_restoring(A, F_0, sf_friction_throughout(model), sf_least_zeta(model, A)));
    if (model->d > 0)
        most = fmin(most, dissipation_restoring(A, F_0, model->d));
    return most;
}

/* h_A from A on: beyond the last breakpoint h is followed to where it has no bound in doubles. What else is known of a
 * cell is left out where all is in place. */
SF_FLAT static sf_interval sf_slope_from(const sf_model *model, const sf_sample *at) {
    sf_known here, there;
    sf_cell cell;
    const sf_sample far = sf_sample_without_k_at(model, SF_ENDLESS * fmax(at->A, 1));
    sf_know(at, &here);
    sf_know(&far, &there);
    sf_make_cell(model, &here, &there, &cell);
    return cell.h_A;
}

/* Whether no amplitude from A on is that of a steady state at F_0 or less: |h| is too large, and rises. */
static int sf_bounds(const sf_model *model, double F_0, double A) {
    const sf_sample at = sf_sample_without_k_at(model, A);
    if (!(fabs(at.h) > sf_most_restoring(model, F_0, A)))
        return 0;
    const sf_interval h_A = sf_slope_from(model, &at);
    return at.h > 0 ? h_A.lo >= 0 : h_A.hi <= 0;
}

/* Whether h lies, on amplitudes from A on, where no state at F_0 can have it. most: what |h| is at most in one at A */
static int sf_excludes(const sf_model *model, double F_0, double most, double A, sf_interval h) {
    double values[4];
    if (!sf_inertial(model))
        return h.lo > most || h.hi < -most;
    /* of all states above F_0 zeta^2 A is half of |h| at most */
    inertia_bound(A, F_0, sf_least_zeta(model, A), h.lo, 0, 0, 0, 0.5, values);
    if (A > F_0 && (h.lo >= 0 || (model->zeta > 0 && values[0] > 0)))
        return 1;
    dissipation_structural_bound(A, F_0, model->eta, fmax(fabs(h.lo), fabs(h.hi)), 0, values);
    return model->eta > 0 && values[0] > 0;
}

/* The same where it is h that is known between two amplitudes: up to the reach, or an endless amplitude.
 *
 * most -- what |h| is at most at a state; step -- from each of these amplitudes to the next */
static int sf_bounds_bent_by(const sf_model *model, double F_0, double A, double most, double step) {
    const double end = fmin(model->reach, SF_ENDLESS * fmax(A, 1));
    double next;
    if (!(A < end))
        return 0;
    for (; A < end; A = next) {
        sf_interval bent[2];
        next = fmin(step * A, end);
        for (int i = model->breaks - 1; i >= 0; i--)
            if (A < model->b[i] && model->b[i] < next)
                next = model->b[i];
        model->mechanism->bent(model->mechanism, sfi_of(A, next), model->p, bent);
        if (!sf_excludes(model, F_0, most, A, bent[0]))
            return 0;
    }
    return 1;
}

static int sf_bounds_bent(const sf_model *model, double F_0, double A) {
    return sf_bounds_bent_by(model, F_0, A, sf_most_restoring(model, F_0, A), 2);
}

/* Whether an excitation by inertia has no state above F_0 from A on by viscous damping: what excludes states at an
 * amplitude is positive on all that follow if its slopes are; the third is a sum of h_AAA, which is monotone, and of a
 * number. */
static int sf_viscous_bounds(const sf_model *model, double F_0, double A) {
    double lost[2] = {0.5, 0.5}, values[4];
    const double zeta = sf_least_zeta(model, A);
    const sf_sample at = sf_sample_at(model, A);
    const sf_sample far = sf_sample_at(model, SF_ENDLESS * fmax(A, 1));
    /* zeta^2 A is at most so much of |h|: of all states half of it, and less where |h|/A is known to rise */
    if (at.k >= 0 && at.h_AA <= 0 && fmax(at.h_AAA, far.h_AAA) <= 0 && at.h < 0)
        lost[1] = fmin(inertia_share(A, zeta, at.h), 0.5);
    for (int i = 0; i < 2; i++) {
        inertia_bound(A, F_0, zeta, at.h, at.h_A, at.h_AA, fmin(at.h_AAA, far.h_AAA), lost[i], values);
        if (values[0] > 0 && values[1] > 0 && values[2] > 0 && values[3] > 0)
            return 1;
    }
    return 0;
}

/* The same by any law: also whether nothing pulls back, where R >= A Omega^2 exceeds F_0 Omega^2, or structural damping
 * bounds states. */
static int sf_inertial_bounds(const sf_model *model, double F_0, double A) {
    double values[2];
    if (model->zeta > 0 && sf_viscous_bounds(model, F_0, A))
        return 1;
    if (!model->by_laws)
        return 0;
    const sf_sample at = sf_sample_without_k_at(model, A);
    const sf_interval h_A = sf_slope_from(model, &at);
    if (A > F_0 && at.h >= 0 && h_A.lo >= 0)
        return 1;
    dissipation_structural_bound(A, F_0, model->eta, at.h, fmax(fabs(h_A.lo), fabs(h_A.hi)), values);
    return model->eta > 0 && values[0] > 0 && values[1] > 0;
}

/* Whether the spring is far from its slope at rest, and an amplitude that is much less is reached: where a response is
 * cut that does not close. */
static int sf_is_far(const sf_model *model, double F_0, double A) {
    const sf_sample at = sf_sample_at(model, A);
    const sf_sample rest = sf_sample_at(model, 0);
    const sf_sample less = sf_sample_at(model, A / SF_STATIC_MULTIPLE);
    /* the slope at rest and what zeta^2 A is of |h|, as shares of |h|/A */
    const double shares =
        at.h < 0 ? -fabs(rest.h_A) * A / at.h + inertia_share(A, sf_least_zeta(model, A), at.h) : HUGE_VAL;
    return SF_STATIC_MULTIPLE * shares <= 1 && less.A > F_0 && sf_count_at(model, &less, F_0) == 2;
}

/* from amplitude to amplitude: a cube of A, as h may grow, changes by less than the half that is left of zeta^2 A */
#define SF_FINE_STEP 1.0905

/* Under an excitation by inertia an amplitude from which on h on finer intervals excludes states; infinite where none
 * is found. */
static double sf_bent_by_inertia(const sf_model *model, double F_0) {
    double A = model->breaks > 0 ? fmax(F_0, 2 * model->b[model->breaks - 1]) : F_0;
    for (int i = 0; i < SF_RUNGS && A < HUGE_VAL; i++, A *= 2)
        if (sf_bounds_bent_by(model, F_0, A, HUGE_VAL, SF_FINE_STEP))
            return A;
    return HUGE_VAL;
}

/* The averaged force of a mass that no spring holds is proportional to A, and 0. */
static int sf_is_free(const sf_model *model) {
    if (model->breaks > 0)
        return 0;
    const sf_sample at = sf_sample_without_k_at(model, fmin(1, 0.5 * model->mechanism->reach));
    return at.h == 0 && at.h_A == 0 && at.h_AA == 0;
}

/* Whether a spring is there whose force does not grow far away, of which averages in closed form know. */
static int sf_levels_off(const sf_model *model) {
    const double last = model->breaks > 0 ? fmax(1, model->b[model->breaks - 1]) : 1;
    if (model->mechanism->bent != NULL || model->mechanism->reach < HUGE_VAL)
        return 0;
    const sf_sample near = sf_sample_without_k_at(model, SF_NEAR_ENDLESS * last);
    const sf_sample far = sf_sample_without_k_at(model, SF_ENDLESS * last);
    return fabs(far.h) <= fabs(near.h) * (1 + 1 / SF_NEAR_ENDLESS);
}

/* What a spring does to the mass far away, in a word. */
static const char *sf_spring(const sf_model *model) {
    return sf_is_free(model) ? "none" : sf_levels_off(model) ? "levels off" : "holds";
}

/* Whether a finite force at Omega = 0 displaces the mass without bound. */
static int sf_lets_go(const sf_model *model) {
    return !sf_inertial(model) && (sf_is_free(model) || sf_levels_off(model));
}

/* As sf_range_at, of a mass that the spring does not hold: damping limits its motions at Omega, and none at 0. */
static sf_status sf_bound_by_damping(const sf_model *model, double F_0, double *A_max) {
    const double last = model->breaks > 0 ? model->b[model->breaks - 1] : 0;
    if (model->lowest == 0) {
        *A_max = SF_STATIC_MULTIPLE * fmax(F_0, last);
        return SF_UNBOUNDED;
    }
    *A_max = 2 * dissipation_limit_envelope(model->lowest, F_0, model->m, model->zeta, 0, model->d);
    *A_max = fmax(*A_max, 2 * last);
    return SF_OK;
}

/* What other laws of damping alone bound amplitudes by. */
static double sf_bound_of_laws(const sf_model *model, double F_0) {
    if (sf_inertial(model))
        return model->d > 0 ? 2 * dissipation_quadratic_bound(F_0, model->d) : HUGE_VAL;
    /* I is not less than its structural part */
    return model->eta > 0 ? 2 * (F_0 - sf_friction_throughout(model)) / model->eta : HUGE_VAL;
}

/* An amplitude above that of every steady state at F_0 or less, where something damps, in steps that grow; SF_UNBOUNDED
 * where a response does not close, with an amplitude at which to cut it; by other laws SF_NO_BOUND also where numbers
 * up to it leave the range of doubles. */
static sf_status sf_amplitude_bound(const sf_model *model, double F_0, double *A_max) {
    const int bent = model->mechanism->bent != NULL, inertial = sf_inertial(model), laws = model->by_laws;
    int (*const bounds)(const sf_model *, double, double) = bent       ? sf_bounds_bent
                                                            : inertial ? sf_inertial_bounds
                                                                       : sf_bounds;
    double A = fmin(F_0, SF_SQUARED), step = 2, cut = model->reach, bound = sf_bound_of_laws(model, F_0);
    sf_status status = SF_OK;
    const int is_free = laws && sf_is_free(model) && model->eta == 0;
    if (is_free && inertial && model->zeta == 0 && model->m == 0)
        return SF_NO_BOUND;
    if (model->breaks > 0)
        A = fmax(A, 2 * model->b[model->breaks - 1]);
    for (int i = 0; i < SF_RUNGS && A < bound && !(is_free && !inertial); i++) {
        if (A < HUGE_VAL && bounds(model, F_0, A)) {
            bound = A;
            break;
        }
        if (inertial && !(cut < HUGE_VAL) && (sf_is_far(model, F_0, A) || i + 1 == SF_RUNGS))
            cut = A;
        A *= step;
        if (i >= SF_FINE_RUNGS && step < SF_COARSEST)
            step *= 2;
    }
    if (bent && inertial && !(bound < HUGE_VAL))
        bound = sf_bent_by_inertia(model, F_0);
    *A_max = cut;
    if (bound < HUGE_VAL && !(bent && model->reach < bound)) {
        *A_max = bound;
    } else if (model->reach < HUGE_VAL && F_0 * F_0 < HUGE_VAL) { /* what goes on beyond the reach has a state there */
        const sf_sample at = sf_sample_at(model, model->reach);
        status = sf_count_at(model, &at, F_0) > 0 ? SF_UNBOUNDED : SF_OK;
    } else if (inertial) {
        status = model->zeta_2 > 0 ? SF_NO_BOUND : SF_UNBOUNDED; /* that zeta grows bounds it, or may */
    } else {
        status = SF_NO_BOUND;
    }
    return laws && status != SF_NO_BOUND && !sf_laws_are_in_range(model, F_0, *A_max) ? SF_NO_BOUND : status;
}

/* Where a response is cut that is unbounded without viscous damping: at the mechanism's reach, or at a multiple of the
 * static deflection, doubled until the fold Omega^2 = -h_A, whose R is k, has passed F_0 or has ended for good. */
static double sf_undamped_cut(const sf_model *model, double F_0) {
    double A = model->reach;
    if (A < HUGE_VAL)
        return A;
    A = fmin(SF_STATIC_MULTIPLE * F_0, SF_SQUARED);
    if (model->breaks > 0)
        A = fmax(A, 2 * model->b[model->breaks - 1]);
    for (int i = 0; !sf_inertial(model) && i < SF_RUNGS; i++, A *= 2) {
        const sf_sample at = sf_sample_at(model, A);
        if (at.h_A < 0 ? slow_flow_undamped_level(model->m, at.k) > F_0 : at.h_AA >= 0)
            break;
        if (at.h_AA == 0 && at.h_AAA == 0)
            break;
    }
    return A;
}

/* Where to stop at F_0: above every steady state, or, with SF_UNBOUNDED, where a response is cut that does not close;
 * undamped ones are cut too. */
static sf_status sf_range_by_spring(const sf_model *model, double F_0, double *A_max) {
    if (model->by_laws || model->zeta > 0)
        return sf_amplitude_bound(model, F_0, A_max);
    *A_max = sf_undamped_cut(model, F_0);
    return SF_OK;
}

/* The same, also of a mass that damping at Omega alone limits. */
static sf_status sf_range_at(const sf_model *model, double F_0, double *A_max) {
    sf_status status = sf_range_by_spring(model, F_0, A_max);
    if (status == SF_NO_BOUND && model->eta == 0 && sf_lets_go(model)) {
        status = sf_bound_by_damping(model, F_0, A_max);
        if (model->by_laws && !sf_laws_are_in_range(model, F_0, *A_max))
            status = SF_NO_BOUND;
    }
    return status;
}
