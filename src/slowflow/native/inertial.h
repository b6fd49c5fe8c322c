/* Excitation by inertia, F_0 Omega^2. Takes a sample and an amplitude of the excitation; returns the frequencies
 * there.
 *
 * The level of an amplitude, the F_0 for which it is a steady state at Omega, falls from inf at Omega = 0 to its least
 * and rises from there to A as Omega tends to inf; or it only falls to A. So an amplitude below F_0 has one frequency,
 * and one above it two or none (derivations/extensions/inertia.py).
 */
#pragma once

#include "model.h"

/* Its damping, which has to be viscous too. */
static inline int sf_inertial_damping_of(const double *inputs, double *damping) {
    if (!(inputs[0] >= 0 && inputs[0] < HUGE_VAL && inputs[1] > 0 && inputs[1] < HUGE_VAL))
        return 0;
    damping[0] = slow_flow_friction(inputs[0]);
    damping[1] = inputs[1];
    return 1;
}

static inline double sf_inertial_level(double Omega, double A, const double *damping, double h) {
    return inertia_level(Omega, A, damping[0], damping[1], h);
}

/* Makes a copy of a record that of the same mechanism excited by inertia. */
static inline void sf_excite_by_inertia(sf_mechanism *record) {
    record->inertial = 1, record->level = sf_inertial_level, record->damping_of = sf_inertial_damping_of;
}

/* x = 1/Omega where the level is least; 0 where it only falls. */
static inline double sf_least_x(const sf_model *model, const sf_sample *at) {
    double terms[3];
    inertia_terms(at->A, model->m, model->zeta, at->h, terms);
    return at->A > 0 && terms[0] > 0 ? inertia_least(terms[0], terms[1], terms[2]) : 0;
}

/* Whether squares of h are beyond the range of doubles: then no frequency is found at A. */
static inline int sf_inertial_overflows(const sf_model *model, const sf_sample *at, double F_0) {
    double outer[2];
    inertia_outer(at->A, F_0, model->m, model->zeta, at->h, outer);
    return at->h != 0 && !(outer[0] < HUGE_VAL) && at->A < F_0;
}

/* of -R/I, up to which R follows from I better than from h where that is all rounding; how many are tried until none
 * changes Omega */
#define SF_LARGEST_SHARE 0.5
enum { SF_MOST_SHARES = 100 };

/* Omega of a fold, or of a peak, by I and what R is of it there, without h; 0 where that is too much. */
static inline double sf_Omega_by_share(const sf_model *model, double F_0, const sf_sample *at, int fold, double *ratio)
{
    double w = 0, last, slopes[3];
    *ratio = 0;
    for (int i = 0; i < SF_MOST_SHARES; i++) {
        last = w, w = inertia_Omega_of_share(at->A, F_0, model->m, model->zeta, *ratio);
        if (fold) {
            inertia_fold_slopes(w, at->A, model->m, model->zeta, at->k, slopes);
            *ratio = slopes[2];
        } else {
            *ratio = inertia_peak_share(w, at->A, model->m, model->zeta);
        }
        if (!(fabs(*ratio) <= SF_LARGEST_SHARE))
            return 0;
        if (fabs(w - last) <= 0x1p-52 * w)
            return w;
    }
    return 0;
}

/* How many frequencies there are at A. */
static inline int sf_inertial_count(const sf_model *model, const sf_sample *at, double F_0) {
    double peak[2];
    if (at->A < F_0)
        return 1;
    const double x = sf_least_x(model, at);
    if (x == 0)
        return 0;
    inertia_peak(x, at->A, F_0, model->m, model->zeta, at->h, 0, peak);
    return peak[0] < 0 ? (at->A > F_0 ? 2 : 1) : 0;
}

/* Newton's steps in x = 1/Omega, kept in the bracket; F rises with x for +1 and falls for -1. */
static inline double sf_inertial_solve(const sf_model *model, const sf_sample *at, double F_0, double x, double lo,
                                       double hi, double rising)
{
    x = fmin(fmax(x, lo), hi);
    for (int i = 0; i < 200; i++) {
        const double Omega = 1 / x, F = inertia_F(Omega, at->A, F_0, model->m, model->zeta, at->h);
        const double slope = inertia_level_slope(Omega, at->A, model->m, model->zeta, at->h);
        double next = x + F / (Omega * slope);
        const double before = x;
        if (rising * F < 0)
            lo = x;
        else
            hi = x;
        if (!(next >= lo && next <= hi))
            next = 0.5 * (lo + hi);
        x = next;
        if (fabs(x - before) <= 0x1p-52 * before)
            break;
    }
    return 1 / x;
}

/* Frequency number `index` of `count`; where rounding hides a pair, the place where it meets. Without its cubic term,
 * which only raises F, F over Omega^4 is a quadratic in x^2, whose roots lie outside of those of F. */
static inline double sf_inertial_root(const sf_model *model, const sf_sample *at, double F_0, int count, int index) {
    const double least = sf_least_x(model, at);
    const int high = count == 2 && index == 1, shown = sf_inertial_count(model, at, F_0);
    double outer[2], x;
    inertia_outer(at->A, F_0, model->m, model->zeta, at->h, outer);
    if (high && at->A <= F_0)
        return HUGE_VAL;
    if (shown < (high ? 2 : 1))
        return 1 / least;
    if (high) {
        x = sqrt(fmax(outer[1], 0)) * (1 - 0x1p-40);
        return sf_inertial_solve(model, at, F_0, x, x, least, -1);
    }
    x = sqrt(outer[0]) * (1 + 0x1p-40);
    return sf_inertial_solve(model, at, F_0, x, least, x, 1);
}

/* All of them, by their size; returns their number. */
static inline int sf_inertial_roots(const sf_model *model, const sf_sample *at, double F_0, double Omega[3]) {
    const int n = sf_inertial_count(model, at, F_0);
    for (int i = 0; i < n; i++)
        Omega[i] = sf_inertial_root(model, at, F_0, n, i);
    return n;
}
