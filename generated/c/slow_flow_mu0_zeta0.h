/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0 and zeta = 0.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/offset.py, derivations/along.py, derivations/slopes.py, derivations/bounds.py, derivations/gradients.py, derivations/newton.py, derivations/resultants.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/emit/rounding.py); others are measured (docs/stability.md). */

#ifndef SLOW_FLOW_MU0_ZETA0_H
#define SLOW_FLOW_MU0_ZETA0_H

#include <math.h>

#include "angles.h"

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
   Proved, error / u (1 + kappa): 0.0
 */
static inline double slow_flow_mu0_zeta0_I(double Omega, double A, double m, double zeta)
{
    (void)(Omega);
    (void)(A);
    (void)(m);
    (void)(zeta);
    return 0.0;
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0.
   Operations: 6 structured, 6 common subexpressions, 6 power chains
 */
static inline double slow_flow_mu0_zeta0_F(double Omega, double A, double F_0, double m, double zeta, double h)
{
    (void)(m);
    (void)(zeta);
    const double R = A * Omega * Omega + h;
    return -F_0 * F_0 + R * R;
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0.
   Operations: 7 structured, 6 common subexpressions, 6 power chains
 */
static inline double slow_flow_mu0_zeta0_F_A(double Omega, double A, double m, double zeta, double h, double h_A)
{
    (void)(m);
    (void)(zeta);
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    return 2.0 * R * (h_A + t0);
}

/* d2F/dA2.
   Equation (24), (33). Domain: Omega > 0, A > 0.
   Operations: 9 structured, 8 common subexpressions, 8 power chains
 */
static inline double slow_flow_mu0_zeta0_F_AA(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA)
{
    (void)(m);
    (void)(zeta);
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = h_A + t0;
    return 2.0 * (R * h_AA + t1 * t1);
}

/* dF/dOmega.
   Equation (24), (34). Domain: Omega > 0, A > 0.
   Operations: 6 structured, 6 common subexpressions, 6 power chains
   Proved, error / u (1 + kappa): 2.76
 */
static inline double slow_flow_mu0_zeta0_F_Omega(double Omega, double A, double m, double zeta, double h)
{
    (void)(m);
    (void)(zeta);
    const double R = A * Omega * Omega + h;
    return 4.0 * A * Omega * R;
}

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0.
   Operations: 9 structured, 8 common subexpressions, 8 power chains
   Proved, error / u (1 + kappa): 3.01
 */
static inline double slow_flow_mu0_zeta0_F_AOmega(double Omega, double A, double m, double zeta, double h, double h_A)
{
    (void)(m);
    (void)(zeta);
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    return 4.0 * Omega * (A * (h_A + t0) + R);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0.
   Operations: 4 structured, 4 common subexpressions, 4 power chains
 */
static inline double slow_flow_mu0_zeta0_phase(double Omega, double A, double m, double zeta, double h)
{
    (void)(m);
    (void)(zeta);
    const double R = A * Omega * Omega + h;
    const double I_ = 0.0;
    return angles_atan2(-I_, -R);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline double slow_flow_mu0_zeta0_limit_envelope(double Omega, double F_0, double m, double zeta)
{
    (void)(Omega);
    (void)(F_0);
    (void)(m);
    (void)(zeta);
    return INFINITY;
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
   Proved, error / u (1 + kappa): 0.0
 */
static inline double slow_flow_mu0_zeta0_equivalent_damping(double Omega, double A, double m, double zeta)
{
    (void)(Omega);
    (void)(A);
    (void)(m);
    (void)(zeta);
    return 0.0;
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0.
   Operations: 7 structured, 6 common subexpressions, 6 power chains
 */
static inline double slow_flow_mu0_zeta0_stability(double Omega, double A, double m, double zeta, double h, double h_A)
{
    (void)(m);
    (void)(zeta);
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    return R * (h_A + t0) / A;
}

/* F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24). Domain: A > 0.
   Operations: 6 structured, 6 common subexpressions, 6 power chains
   Proved, error / u (1 + kappa): -, 0.0, 0.34, 0.34
 */
static inline void slow_flow_mu0_zeta0_response_quartic(double A, double F_0, double m, double zeta, double h, double *out)
{
    (void)(m);
    (void)(zeta);
    out[0] = (-F_0 + h) * (F_0 + h);
    out[1] = 0.0;
    out[2] = 2.0 * A * h;
    out[3] = A * A;
}

/* F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24), (30). Domain: A > 0.
   Operations: 3 structured, 3 common subexpressions, 3 power chains
   Proved, error / u (1 + kappa): 0.34, 0.0, 1.01, 0.0
 */
static inline void slow_flow_mu0_zeta0_fold_quartic(double A, double m, double zeta, double h, double h_A, double *out)
{
    (void)(m);
    (void)(zeta);
    out[0] = h * h_A;
    out[1] = 0.0;
    out[2] = A * h_A + h;
    out[3] = A;
}

/* F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.
   Equation (34). Domain: A > 0.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
   Proved, error / u (1 + kappa): 0.0, 0.0, 0.0
 */
static inline void slow_flow_mu0_zeta0_peak_cubic(double A, double m, double zeta, double h, double *out)
{
    (void)(m);
    (void)(zeta);
    out[0] = 0.0;
    out[1] = h;
    out[2] = A;
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: A > 0.
   Operations: 1 structured, 1 common subexpressions, 1 power chains
   Proved, error / u (1 + kappa): 0.34, 0.0
 */
#define SLOW_FLOW_MU0_ZETA0_DETACHMENT_COUNT 2
static inline void slow_flow_mu0_zeta0_detachment(double A, double m, double zeta, double h, double *out)
{
    (void)(A);
    (void)(m);
    (void)(zeta);
    out[0] = -h * h;
    out[1] = 1.0;
}

/* The forcing F_0 for which (Omega, A) is a steady state.
   Equation (24). Domain: Omega >= 0, A > 0.
   Operations: 4 structured, 4 common subexpressions, 4 power chains
 */
static inline double slow_flow_mu0_zeta0_level(double Omega, double A, double m, double zeta, double h)
{
    (void)(m);
    (void)(zeta);
    const double R = A * Omega * Omega + h;
    return fabs(R);
}

/* Omega of the folds.
   Equation from (30). Domain: h_A <= 0.
   Operations: 1 structured, 1 common subexpressions, 1 power chains
 */
static inline double slow_flow_mu0_zeta0_undamped_Omega(double h_A)
{
    return sqrt(-h_A);
}

/* Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A.
   Equation from (24), (30). Domain: F_0 > m.
   Operations: 7 structured, 7 common subexpressions, 7 power chains
 */
static inline void slow_flow_mu0_zeta0_fold(double F_0, double m, double k, double k_A, double *out)
{
    (void)(m);
    const double excess = F_0 * F_0;
    const double least = sqrt(excess);
    out[0] = (k - least) * (k + least);
    out[1] = 2.0 * k * k_A;
}

/* The forcing of a fold, whose R is k.
   Equation from (24), (30). Domain: h_A <= 0.
   Operations: 1 structured, 1 common subexpressions, 1 power chains
 */
static inline double slow_flow_mu0_zeta0_undamped_level(double m, double k)
{
    (void)(m);
    return fabs(k);
}

/* The sign of the level's slope along A on the undamped folds; and, where that is 0, of the slope's own.
   Equation from (24), (30). Domain: h_A <= 0.
   Operations: 2 structured, 2 common subexpressions, 2 power chains
   Proved, error / u (1 + kappa): 0.34, 0.34
 */
static inline void slow_flow_mu0_zeta0_undamped_rises(double h_AA, double h_AAA, double k, double *out)
{
    out[0] = -h_AA * k;
    out[1] = -h_AAA * k;
}

/* The factors of F_AA/2 at the folds, each with its slope along A: h_AA, R.
   Equation from (30), (33). Domain: A > 0.
   Operations: 3 structured, 3 common subexpressions, 3 power chains
   Proved, error / u (1 + kappa): 0.0, 0.0, 1.01, 0.34
 */
static inline void slow_flow_mu0_zeta0_undamped(double A, double h, double h_A, double h_AA, double h_AAA, double *out)
{
    out[0] = h_AA;
    out[1] = h_AAA;
    out[2] = -A * h_A + h;
    out[3] = -A * h_AA;
}

#endif
