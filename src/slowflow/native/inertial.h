/* Excitation by inertia, F_0 Omega^2. Takes a sample; returns where its level is least, and Omega without h.
 *
 * The level of an amplitude, the F_0 for which it is a steady state at Omega, falls from inf at Omega = 0 to its least
 * and rises from there to A as Omega tends to inf; or it only falls to A. So an amplitude below F_0 has one frequency,
 * and one above it two or none (derivations/extensions/inertia.py): sf_law_frequencies has them.
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

/* of -R/I, up to which R follows from I better than from h where that is all rounding; how many are tried until none
 * changes Omega */
#define SF_LARGEST_SHARE 0.5
enum { SF_MOST_SHARES = 100 };

/* Omega of a fold, or of a peak, by I and what R is of it there, without h; 0 where that is too much. */
static inline double sf_Omega_by_share(const sf_model *model, double F_0, const sf_sample *at, int fold,
                                       double *ratio) {
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
