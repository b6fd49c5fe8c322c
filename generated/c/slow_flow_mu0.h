/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
   derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef SLOW_FLOW_MU0_H
#define SLOW_FLOW_MU0_H

#include <math.h>

#include "inline.h"

SF_FAMILY_BEGIN

/* F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24). Domain: A > 0. Operations: 10. Error / u (1 + kappa): proved -, 0.0, 1.61, 0.34; measured 0.92. */
SF_KERNEL void slow_flow_mu0_response_quartic(double A, double F_0, double m, double zeta, double h, double *out) {
    const double t0 = A * A;
    out[0] = (-F_0 + h) * (F_0 + h);
    out[1] = 0.0;
    out[2] = 2.0 * A * h + 4.0 * t0 * zeta * zeta;
    out[3] = t0;
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: A > 0. Operations: 14. Error / u (1 + kappa): proved 4.01, 5.67, 0.0. */
#define SLOW_FLOW_MU0_DETACHMENT_COUNT 3
SF_KERNEL void slow_flow_mu0_detachment(double A, double m, double zeta, double h, double *out) {
    const double t0 = h * h;
    const double zeta2 = zeta * zeta;
    const double t1 = A * zeta2;
    const double t2 = 4.0 * t1;
    const double zeta4 = zeta2 * zeta2;
    out[0] = -t0 * t2 * (h + t1);
    out[1] = 4.0 * A * A * zeta4 + h * t2 - t0;
    out[2] = 1.0;
}

/* Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega.
   Equation from (24), (30). Domain: A > 0, F_0 > m, k^2 >= F_0^2 - m^2. Operations: 39. Error / u (1 + kappa):
   measured 1.4. */
SF_KERNEL void slow_flow_mu0_fold(double A, double F_0, double m, double zeta, double h, double h_A, double k, double k_A, double *out) {
    const double excess = F_0 * F_0;
    const double least = sqrt(excess);
    const double t0 = 1.0 / k;
    const double t1 = least * t0;
    const double share = sqrt((1.0 - t1) * (t1 + 1.0));
    const double t2 = excess / F_0;
    const double lag = share * t2;
    const double t3 = t0 * t2;
    const double t4 = 1.0 / (zeta * zeta);
    const double t5 = 1.0 / A;
    const double t6 = t4 * t5;
    const double t7 = 0.25 * lag * lag;
    out[0] = -F_0 * t3 + h + t6 * t7;
    out[1] = F_0 * k_A * t2 * t2 * (F_0 / excess + 0.5 * t3 * t6) / (k * k) + h_A - t4 * t7 / (A * A);
    out[2] = 0.5 * lag * t5 / zeta;
}

/* Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A.
   Equation from (30), (34). Domain: A > 0, h_A > 0; for m = 0 any h_A. Operations: 9. Error / u (1 + kappa): proved
   2.34, 1.67. */
SF_KERNEL void slow_flow_mu0_isola(double A, double m, double zeta, double h, double h_A, double h_AA, double *out) {
    const double t0 = 2.0 * zeta * zeta;
    const double bracket = A * (h_A + t0) + h;
    const double bracket_A = A * h_AA + 2.0 * h_A + t0;
    out[0] = bracket;
    out[1] = bracket_A;
}

SF_FAMILY_END

#endif
