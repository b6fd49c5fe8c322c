/* The balance of the second approximation at many states at once, built for wide vectors. */
#pragma once

#include <stddef.h>

#include "inertia.h"

enum {
    SF_KNOWN = 12,  /* rows of averages: h, h_3 and h_5, each with three derivatives */
    SF_BALANCE = 9, /* rows of the balance: u_max, A_1, phi, R, F, F_A, F_Omega, R_A, R_Omega */
    SF_MATCH = 2,   /* rows of a step to the frequency of a given R: the step to ln Omega, and sf_short_exp of it */
    SF_NEWTON = 7   /* rows of a step of Newton's: its size, the one that ends the iteration, R after it, the steps to
                       ln A and to ln Omega, each with its sf_short_exp */
};

/* d/dOmega of the square of the force of an excitation by inertia. */
static inline double sf_force_squared_slope(double Omega, double F_0) {
    double slopes[2];
    inertia_force_slopes(Omega, F_0, slopes);
    return 2 * inertia_force(Omega, F_0) * slopes[0];
}

/* Row k of the n states, of which there are whole vectors, begins at known[k * n], and at out[k * n].
 *
 * inertial: whether the force is F_0 Omega^2; phases: whether phi is required, else it is NaN */
void sf_second_balances(ptrdiff_t n, const double *Omega, const double *A, double F_0, int inertial, int phases,
                        double m, double zeta, const double *known, double *out);

/* exp(x) to rounding up to |x| = SF_SHORT */
#define SF_SHORT 1e-3
static inline double sf_short_exp(double x) { return 1 + x * (1 + x * (0.5 + x * (1. / 6 + x * (1. / 24)))); }

/* Steps from balances; way: how far ln Omega has gone already. */
void sf_second_matches(ptrdiff_t n, const double *Omega, const double *R, const double *way, double F_0,
                       const double *balances, double *out);
void sf_second_newton(ptrdiff_t n, const double *Omega, const double *A, double F_0, const double *balances,
                      double *out);
