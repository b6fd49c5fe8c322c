/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene zeta = 0.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
   derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef SLOW_FLOW_ZETA0_H
#define SLOW_FLOW_ZETA0_H

#include <math.h>

#include "inline.h"

SF_FAMILY_BEGIN

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. Operations: 0. Error / u (1 + kappa): measured 0. */
SF_KERNEL double slow_flow_zeta0_limit_envelope(double Omega, double F_0, double m, double zeta) {
    return INFINITY;
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: A > 0. Operations: 6. Error / u (1 + kappa): proved 0.81, 0.67, 0.0. */
#define SLOW_FLOW_ZETA0_DETACHMENT_COUNT 3
SF_KERNEL void slow_flow_zeta0_detachment(double A, double m, double zeta, double h, double *out) {
    const double t0 = m * m;
    const double t1 = h * h;
    out[0] = t0 * (t0 + t1);
    out[1] = -2.0 * t0 - t1;
    out[2] = 1.0;
}

/* Omega of the folds.
   Equation from (30). Domain: h_A <= 0. Operations: 1. Error / u (1 + kappa): measured 0.67. */
SF_KERNEL double slow_flow_zeta0_undamped_Omega(double h_A) {
    return sqrt(-h_A);
}

/* Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A.
   Equation from (24), (30). Domain: F_0 > m. Operations: 9. Error / u (1 + kappa): measured 0.62. */
SF_KERNEL void slow_flow_zeta0_fold(double F_0, double m, double k, double k_A, double *out) {
    const double excess = (F_0 - m) * (F_0 + m);
    const double least = sqrt(excess);
    out[0] = (k - least) * (k + least);
    out[1] = 2.0 * k * k_A;
}

/* The forcing of a fold, whose R is k.
   Equation from (24), (30). Domain: h_A <= 0. Operations: 4. Error / u (1 + kappa): measured 0.99. */
SF_KERNEL double slow_flow_zeta0_undamped_level(double m, double k) {
    return sqrt(k * k + m * m);
}

/* The sign of the level's slope along A on the undamped folds; and, where that is 0, of the slope's own.
   Equation from (24), (30). Domain: h_A <= 0. Operations: 2. Error / u (1 + kappa): proved 0.34, 0.34. */
SF_KERNEL void slow_flow_zeta0_undamped_rises(double h_AA, double h_AAA, double k, double *out) {
    out[0] = -h_AA * k;
    out[1] = -h_AAA * k;
}

/* The factors of F_AA/2 at the folds, each with its slope along A: h_AA, R.
   Equation from (30), (33). Domain: A > 0. Operations: 3. Error / u (1 + kappa): proved 0.0, 0.0, 1.01, 0.34. */
SF_KERNEL void slow_flow_zeta0_undamped(double A, double h, double h_A, double h_AA, double h_AAA, double *out) {
    out[0] = h_AA;
    out[1] = h_AAA;
    out[2] = -A * h_A + h;
    out[3] = -A * h_AA;
}

SF_FAMILY_END

#endif
