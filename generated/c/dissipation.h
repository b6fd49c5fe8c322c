/* Structural and quadratic damping, and dry friction of what is attached.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/dissipation.py, derivations/gradients.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/emit/rounding.py).
   Others are measured: the worst error of all outputs that was found, by a search for it with A 1e-09 to 1000, A_p
   1e-09 to 1000 of either sign or 0, F_0 1e-09 to 1000, F_0_p 1e-09 to 1000 of either sign or 0, I 1e-12 to 1000 or
   0, I_0 1e-12 to 1 or 0, I_0A 1e-09 to 1e+06 of either sign or 0, I_0AA 1e-09 to 1e+09 of either sign or 0, I_0AAA
   1e-09 to 1e+12 of either sign or 0, I_0AAp 1e-09 to 1000 of either sign or 0, I_0Ap 1e-09 to 1000 of either sign
   or 0, I_0_over_A 1e-12 to 1e+06 or 0, I_0p 1e-09 to 1000 of either sign or 0, I_A 1e-09 to 1e+06 of either sign
   or 0, I_over_A 1e-12 to 1e+06 or 0, Omega 0.001 to 1000, Omega_p 1e-09 to 1000 of either sign or 0, R 1e-09 to
   1e+06 of either sign or 0, R_A 1e-09 to 1e+06 of either sign or 0, beside 1e-09 to 1e+06 of either sign or 0, c_2
   1e-12 to 1000 or 0, d 1e-12 to 1000 or 0, d_p 1e-09 to 1000 of either sign or 0, end_p 1e-09 to 1000 of either
   sign or 0, eta 1e-12 to 1 or 0, forcing_p 1e-09 to 1000 of either sign or 0, frequency_p 1e-09 to 1000 of either
   sign or 0, h 1e-12 to 1000 of either sign or 0, h_A 1e-09 to 1e+06 of either sign or 0, h_AA 1e-09 to 1e+09 of
   either sign or 0, h_AAA 1e-09 to 1e+12 of either sign or 0, h_AAp 1e-09 to 1000 of either sign or 0, h_Ap 1e-09
   to 1000 of either sign or 0, h_over_A 1e-09 to 1e+06 of either sign or 0, h_p 1e-09 to 1000 of either sign or 0,
   k 1e-09 to 1000 of either sign, m 1e-12 to 1 or 0, steepest 1e-09 to 1e+06 or 0, u_cr 1e-06 to 1, x 0.001 to
   1000, zeta 1e-12 to 1 or 0, zeta_p 1e-09 to 1000 of either sign or 0.
   u = 2^-53, kappa is the relative condition number of an output in all arguments. */

#ifndef DISSIPATION_H
#define DISSIPATION_H

#include <math.h>

/* what exported.c defines otherwise */
#ifndef SF_KERNEL
#define SF_KERNEL static inline
#endif

/* Quadratic damping's factor of A^2 Omega^2 in I.
   Equation from (19). Domain: any.
   Operations: 1 structured, 1 common subexpressions, 1 power chains
   Measured, error / u (1 + kappa): 0.69
 */
SF_KERNEL double dissipation_quadratic(double c_2)
{
    return 0.84882636315677518 * c_2;
}

/* The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.
   Equation from (23). Domain: A > 0, d > 0.
   Operations: 3 structured, 3 common subexpressions, 3 power chains
   Proved, error / u (1 + kappa): 2.01
 */
SF_KERNEL double dissipation_restoring(double A, double F_0, double d)
{
    return F_0 + F_0 / (A * d);
}

/* I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.
   Equation from (19). Domain: A > 0.
   Operations: 2 structured, 2 common subexpressions, 2 power chains
   Proved, error / u (1 + kappa): 1.01, 0.0, 0.0, 0.0
 */
SF_KERNEL void dissipation_at_rest(double A, double m, double eta, double *out)
{
    out[0] = A * eta + m;
    out[1] = eta;
    out[2] = 0.0;
    out[3] = 0.0;
}

/* The same where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0.
   Operations: 19 structured, 16 common subexpressions, 13 power chains
   Proved, error / u (1 + kappa): 1.01, 1.01, 0.67, 0.86
 */
SF_KERNEL void dissipation_released(double A, double m, double eta, double u_cr, double *out)
{
    const double t0 = m * u_cr;
    const double A2 = A * A;
    const double A3 = A * A2;
    const double A4 = A2 * A2;
    out[0] = A * eta + t0 / A;
    out[1] = eta - t0 / A2;
    out[2] = 2.0 * t0 / A3;
    out[3] = -6.0 * t0 / A4;
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0.
   Operations: 9 structured, 9 common subexpressions, 9 power chains
   Proved, error / u (1 + kappa): 4.01
 */
SF_KERNEL double dissipation_I(double Omega, double A, double I_0, double zeta, double d)
{
    return A * A * Omega * Omega * d + 2.0 * A * Omega * zeta + I_0;
}

/* dI/dA.
   Equation (23). Domain: Omega > 0, A > 0.
   Operations: 8 structured, 8 common subexpressions, 8 power chains
   Proved, error / u (1 + kappa): 2.61
 */
SF_KERNEL double dissipation_I_A(double Omega, double A, double I_0A, double zeta, double d)
{
    return 2.0 * A * Omega * Omega * d + I_0A + 2.0 * Omega * zeta;
}

/* R, R_A, I and I_A over Omega^2, at x = 1/Omega.
   Equation (23). Domain: x >= 0, A > 0.
   Operations: 23 structured, 18 common subexpressions, 18 power chains
   Proved, error / u (1 + kappa): 1.01, 1.34, 4.01, 2.61
 */
SF_KERNEL void dissipation_far(double x, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A, double *out)
{
    const double t0 = x * x;
    const double t1 = 2.0 * A;
    const double t2 = x * zeta;
    out[0] = A + h * t0;
    out[1] = h_A * t0 + 1.0;
    out[2] = A * A * d + I_0 * t0 + t1 * t2;
    out[3] = I_0A * t0 + d * t1 + 2.0 * t2;
}

/* Zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0.
   Operations: 17 structured, 16 common subexpressions, 16 power chains
   Measured, error / u (1 + kappa): 1.2
 */
SF_KERNEL double dissipation_F(double Omega, double A, double F_0, double I_0, double zeta, double d, double h)
{
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double I_ = A * A * d * t0 + 2.0 * A * Omega * zeta + I_0;
    return R * R + (-F_0 + I_) * (F_0 + I_);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0.
   Operations: 26 structured, 20 common subexpressions, 20 power chains
   Measured, error / u (1 + kappa): 0.86
 */
SF_KERNEL double dissipation_F_A(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega * zeta;
    const double I_ = A * A * d * t0 + A * t2 + I_0;
    return 2.0 * (I_ * (I_0A + 2.0 * d * t1 + t2) + R * (h_A + t0));
}

/* d2F/dA2.
   Equation (24). Domain: Omega > 0, A > 0.
   Operations: 35 structured, 27 common subexpressions, 27 power chains
   Measured, error / u (1 + kappa): 1.5
 */
SF_KERNEL double dissipation_F_AA(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double d, double h, double h_A, double h_AA)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega * zeta;
    const double t3 = d * t0;
    const double I_ = A * A * t3 + A * t2 + I_0;
    const double t4 = h_A + t0;
    const double t5 = I_0A + 2.0 * d * t1 + t2;
    return 2.0 * (I_ * I_0AA + 2.0 * I_ * t3 + R * h_AA + t4 * t4 + t5 * t5);
}

/* F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.
   Equation (24). Domain: A > 0.
   Operations: 28 structured, 26 common subexpressions, 23 power chains
   Proved, error / u (1 + kappa): 0.67, 0.51, 2.51, 0.67, 0.86
 */
SF_KERNEL void dissipation_response_quartic(double A, double I_0, double zeta, double d, double h, double *out)
{
    const double t0 = 4.0 * zeta;
    const double A2 = A * A;
    const double A3 = A * A2;
    const double A4 = A2 * A2;
    out[0] = I_0 * I_0 + h * h;
    out[1] = A * I_0 * t0;
    out[2] = 2.0 * A * h + A2 * (2.0 * I_0 * d + 4.0 * zeta * zeta);
    out[3] = A3 * d * t0;
    out[4] = A2 + A4 * d * d;
}

/* F_A/2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.
   Equation (30). Domain: A > 0.
   Operations: 32 structured, 29 common subexpressions, 28 power chains
   Proved, error / u (1 + kappa): 1.01, 1.67, 4.76, 0.81, 0.84
 */
SF_KERNEL void dissipation_fold_quartic(double A, double I_0, double I_0A, double zeta, double d, double h, double h_A, double *out)
{
    const double t0 = 2.0 * I_0;
    const double A2 = A * A;
    const double t1 = A2 * d;
    const double A3 = A * A2;
    out[0] = I_0 * I_0A + h * h_A;
    out[1] = 2.0 * A * I_0A * zeta + t0 * zeta;
    out[2] = A * h_A + A * (d * t0 + 4.0 * zeta * zeta) + I_0A * t1 + h;
    out[3] = 6.0 * t1 * zeta;
    out[4] = A + 2.0 * A3 * d * d;
}

/* F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.
   Equation (24). Domain: x >= 0, A > 0.
   Operations: 42 structured, 35 common subexpressions, 34 power chains
   Proved, error / u (1 + kappa): -, -, 0.67
   Measured, error / u (1 + kappa): 1.2
 */
SF_KERNEL void dissipation_far_by_inertia(double x, double A, double F_0, double I_0, double zeta, double d, double h, double *out)
{
    const double t0 = x * x;
    const double A2 = A * A;
    const double t1 = A2 * d;
    const double t2 = A * x * zeta;
    const double t3 = A + h * t0;
    const double t4 = I_0 * t0 + t1 + 2.0 * t2;
    const double A3 = A * A2;
    out[0] = -F_0 * F_0 + t3 * t3 + t4 * t4;
    out[1] = A * h + 2.0 * A2 * zeta * zeta + I_0 * t1 + 3.0 * I_0 * t2 + t0 * (I_0 * I_0 + h * h);
    out[2] = A3 * d * zeta;
}

/* Both positive: no state above A, while |h| grows by steepest dA at most.
   Equation from (23), (24). Domain: A > 0.
   Operations: 12 structured, 10 common subexpressions, 10 power chains
   Proved, error / u (1 + kappa): -, 3.76
   Measured, error / u (1 + kappa): 0.84
 */
SF_KERNEL void dissipation_structural_bound(double A, double F_0, double eta, double h, double steepest, double *out)
{
    const double t0 = A - F_0;
    const double t1 = A * eta;
    out[0] = -F_0 * fabs(h) + t0 * t1;
    out[1] = -F_0 * steepest + eta * t0 + t1;
}

/* What no amplitude exceeds.
   Equation from (23), (24). Domain: d > 0.
   Operations: 3 structured, 3 common subexpressions, 3 power chains
   Measured, error / u (1 + kappa): 1.2
 */
SF_KERNEL double dissipation_quadratic_bound(double F_0, double d)
{
    return sqrt(F_0) / sqrt(d);
}

/* F and F_A; derivatives by A and by Omega of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 91 structured, 47 common subexpressions, 47 power chains
   Proved, error / u (1 + kappa): -, 5.01, 5.01, 3.26, -, -
   Measured, error / u (1 + kappa): 1.5
 */
SF_KERNEL void dissipation_folds(double Omega, double A, double F_0, double I_0A, double I_0AA, double zeta, double d, double h_A, double h_AA, double R, double I_, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = h_A + t0;
    const double t2 = 2.0 * Omega;
    const double t3 = A * d;
    const double t4 = 2.0 * t0;
    const double t5 = I_0A + t2 * zeta + t3 * t4;
    const double t6 = 2.0 * (I_ * t5 + R * t1);
    const double t7 = Omega * R;
    const double t8 = A * Omega;
    const double t9 = d * t8 + zeta;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = t6;
    out[2] = t6;
    out[3] = 4.0 * A * (I_ * t9 + t7);
    out[4] = 2.0 * (I_ * I_0AA + I_ * d * t4 + R * h_AA + t1 * t1 + t5 * t5);
    out[5] = 4.0 * (A * t5 * t9 + I_ * (t2 * t3 + zeta) + t1 * t8 + t7);
}

/* F and F_A/2, in A and R; derivatives by the one and by the other of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 64 structured, 44 common subexpressions, 44 power chains
   Measured, error / u (1 + kappa): 0.57
 */
SF_KERNEL void dissipation_folds_in_R(double Omega, double A, double F_0, double I_0AA, double zeta, double d, double h_AA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 1.0 / Omega;
    const double t1 = A * Omega * d;
    const double t2 = t0 * (t1 + zeta);
    const double t3 = I_A - R_A * t2;
    const double t4 = 1.0 / A;
    const double t5 = R_A * t4;
    const double t6 = t0 * (2.0 * t1 + zeta);
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * I_A + R * R_A;
    out[2] = 2.0 * I_ * t3;
    out[3] = 2.0 * (I_ * t2 + R);
    out[4] = I_ * (I_0AA + 2.0 * Omega * Omega * d - t5 * t6) + I_A * t3 + R * (h_AA - t5);
    out[5] = I_ * t4 * t6 + I_A * t2 + R * t4 + R_A;
}

/* F and F_A/2 by inertia over Omega^4, x = 1/Omega, in A and R; derivatives by the one and by the other of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 68 structured, 45 common subexpressions, 45 power chains
   Measured, error / u (1 + kappa): 0.7
 */
SF_KERNEL void dissipation_folds_far(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double zeta, double d, double h, double h_A, double h_AA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 1.0 / h;
    const double t1 = t0 / x;
    const double t2 = t1 * (A * zeta + I_0 * x);
    const double t3 = I_A - R_A * t2;
    const double t4 = x * x;
    const double t5 = h_A * t0;
    const double t6 = t1 * (I_0A * x + zeta);
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * I_A + R * R_A;
    out[2] = 2.0 * I_ * t3;
    out[3] = 2.0 * (I_ * t2 + R);
    out[4] = I_ * (I_0AA * t4 - R_A * t6 + 2.0 * d) + I_A * t3 + R * (-R_A * t5 + h_AA * t4);
    out[5] = I_ * t6 + I_A * t2 + R * t5 + R_A;
}

/* The same in A and x; derivatives by the one and by the other of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 48 structured, 40 common subexpressions, 40 power chains
   Measured, error / u (1 + kappa): 0.75
 */
SF_KERNEL void dissipation_folds_far_in_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double zeta, double d, double h, double h_A, double h_AA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = I_ * I_A + R * R_A;
    const double t1 = R * x;
    const double t2 = A * zeta + I_0 * x;
    const double t3 = x * x;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = t0;
    out[2] = 2.0 * t0;
    out[3] = 4.0 * (I_ * t2 + h * t1);
    out[4] = I_ * (I_0AA * t3 + 2.0 * d) + I_A * I_A + R * h_AA * t3 + R_A * R_A;
    out[5] = 2.0 * (I_ * (I_0A * x + zeta) + I_A * t2 + R_A * h * x + h_A * t1);
}

#endif
