/* Structural and quadratic damping, and dry friction of what is attached.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/extensions/dissipation.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are those in floating point. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/codegen/rounding.py).
   Others are measured: the worst error of all outputs that was found, by a search for it with A 1e-09 to 1000, F_0
   1e-09 to 1000, I 1e-12 to 1000 or 0, I_0 1e-12 to 1 or 0, I_0A 1e-09 to 1e+06 of either sign or 0, I_0AA 1e-09 to
   1e+09 of either sign or 0, I_0AAA 1e-09 to 1e+12 of either sign or 0, I_0_over_A 1e-12 to 1e+06 or 0, I_A 1e-09
   to 1e+06 of either sign or 0, I_over_A 1e-12 to 1e+06 or 0, Omega 0.001 to 1000, R 1e-09 to 1e+06 of either sign
   or 0, R_A 1e-09 to 1e+06 of either sign or 0, c_2 1e-12 to 1000 or 0, d 1e-12 to 1000 or 0, eta 1e-12 to 1 or 0,
   h 1e-12 to 1000 of either sign or 0, h_A 1e-09 to 1e+06 of either sign or 0, h_AA 1e-09 to 1e+09 of either sign
   or 0, h_AAA 1e-09 to 1e+12 of either sign or 0, h_over_A 1e-09 to 1e+06 of either sign or 0, m 1e-12 to 1 or 0,
   steepest 1e-09 to 1e+06 or 0, u_cr 1e-06 to 1, x 0.001 to 1000, zeta 1e-12 to 1 or 0.
   u = 2^-53, kappa is the relative condition number of an output in all arguments. */

#ifndef DISSIPATION_H
#define DISSIPATION_H

#include <math.h>

#include "inline.h"

SF_FAMILY_BEGIN

/* Quadratic damping's factor of A^2 Omega^2 in I.
   Equation from (19). Domain: any. Operations: 1.
   Measured, error / u (1 + kappa): 0.69 */
SF_KERNEL double dissipation_quadratic(double c_2)
{
    return 0.84882636315677518 * c_2;
}

/* The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.
   Equation from (23). Domain: A > 0, d > 0. Operations: 3.
   Proved, error / u (1 + kappa): 2.01 */
SF_KERNEL double dissipation_restoring(double A, double F_0, double d)
{
    return F_0 + F_0 / (A * d);
}

/* I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.
   Equation from (19). Domain: A > 0. Operations: 2.
   Proved, error / u (1 + kappa): 1.01, 0.0, 0.0, 0.0 */
SF_KERNEL void dissipation_at_rest(double A, double m, double eta, double *out)
{
    out[0] = A * eta + m;
    out[1] = eta;
    out[2] = 0.0;
    out[3] = 0.0;
}

/* The same where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. Operations: 13.
   Proved, error / u (1 + kappa): 1.01, 1.01, 0.67, 0.86 */
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

/* What m, then eta, does to I_0, I_0A and I_0AA: friction acts throughout.
   Equation from (19). Domain: A > 0. Operations: 0.
   Proved, error / u (1 + kappa): 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 */
SF_KERNEL void dissipation_rest_moves(double A, double *out)
{
    for (int k = 0; k < 6; k++)
        out[k] = 0.0;
    out[0] = 1.0;
    out[3] = A;
    out[4] = 1.0;
}

/* What m, then eta, then u_cr does to them where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. Operations: 11.
   Proved, error / u (1 + kappa): 0.67, 0.76, 0.81, 0.0, 0.0, 0.0, 0.67, 0.76, 0.81 */
SF_KERNEL void dissipation_released_moves(double A, double m, double u_cr, double *out)
{
    const double t0 = 1.0 / A;
    const double A2 = A * A;
    const double t1 = 1.0 / A2;
    const double A3 = A * A2;
    const double t2 = 2.0 / A3;
    out[0] = t0 * u_cr;
    out[1] = -t1 * u_cr;
    out[2] = t2 * u_cr;
    out[3] = A;
    out[4] = 1.0;
    out[5] = 0.0;
    out[6] = m * t0;
    out[7] = -m * t1;
    out[8] = m * t2;
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. Operations: 9.
   Proved, error / u (1 + kappa): 4.01 */
SF_KERNEL double dissipation_I(double Omega, double A, double I_0, double zeta, double d)
{
    return A * A * Omega * Omega * d + 2.0 * A * Omega * zeta + I_0;
}

/* dI/dA.
   Equation (23). Domain: Omega > 0, A > 0. Operations: 8.
   Proved, error / u (1 + kappa): 2.61 */
SF_KERNEL double dissipation_I_A(double Omega, double A, double I_0A, double zeta, double d)
{
    return 2.0 * A * Omega * Omega * d + I_0A + 2.0 * Omega * zeta;
}

/* R, R_A, I and I_A over Omega^2, at x = 1/Omega.
   Equation (23). Domain: x >= 0, A > 0. Operations: 18.
   Proved, error / u (1 + kappa): 1.01, 1.34, 4.01, 2.61 */
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
   Equation (24). Domain: Omega > 0, A > 0. Operations: 16.
   Measured, error / u (1 + kappa): 1.2 */
SF_KERNEL double dissipation_F(double Omega, double A, double F_0, double I_0, double zeta, double d, double h)
{
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double I_ = A * A * d * t0 + 2.0 * A * Omega * zeta + I_0;
    return R * R + (-F_0 + I_) * (F_0 + I_);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. Operations: 20.
   Measured, error / u (1 + kappa): 0.86 */
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
   Equation (24). Domain: Omega > 0, A > 0. Operations: 27.
   Measured, error / u (1 + kappa): 1.5 */
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

/* d2F/dOmega2.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 23.
   Measured, error / u (1 + kappa): 1.3 */
SF_KERNEL double dissipation_F_OmegaOmega(double Omega, double A, double I_0, double zeta, double d, double h)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * A;
    const double I_ = A * A * d * t0 + I_0 + Omega * t2 * zeta;
    const double t3 = A * d;
    const double t4 = Omega * t3 + zeta;
    return 4.0 * A * (I_ * t3 + R + 2.0 * t1 + t2 * t4 * t4);
}

/* d3F/dA dOmega2.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 35.
   Measured, error / u (1 + kappa): 1.5 */
SF_KERNEL double dissipation_F_AOmegaOmega(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega;
    const double t3 = t2 * zeta;
    const double t4 = A * A * d;
    const double I_ = A * t3 + I_0 + t0 * t4;
    const double t5 = A * d;
    return 4.0 * (A * (h_A + t0) + 4.0 * A * (Omega * t5 + zeta) * (t2 * t5 + zeta) + 2.0 * I_ * t5 + R + 4.0 *
        t1 + t4 * (I_0A + 2.0 * d * t1 + t3));
}

/* dOmega/dA along the response.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 31.
   Measured, error / u (1 + kappa): 1.9 */
SF_KERNEL double dissipation_Omega_A(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * zeta;
    const double t3 = A * t2;
    const double t4 = A * A * d;
    const double I_ = I_0 + Omega * t3 + t0 * t4;
    return -2.0 * (I_ * (I_0A + Omega * t2 + 2.0 * d * t1) + R * (h_A + t0)) / (4.0 * A * Omega * R + 2.0 * I_ *
        (2.0 * Omega * t4 + t3));
}

/* The same of an excitation by inertia.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 29.
   Measured, error / u (1 + kappa): 1.4 */
SF_KERNEL double dissipation_Omega_A_by_inertia(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = Omega * zeta;
    const double t3 = A * t2;
    const double I_ = A * A * d * t0 + I_0 + 2.0 * t3;
    return 2.0 * Omega * (I_ * (I_0A + 2.0 * d * t1 + 2.0 * t2) + R * (h_A + t0)) / (4.0 * I_ * (I_0 + t3) + 4.0
        * R * h);
}

/* Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 55.
   Measured, error / u (1 + kappa): 0.98 */
SF_KERNEL double dissipation_cusp_bend(double Omega, double A, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega;
    const double t3 = t2 * zeta;
    const double t4 = d * t0;
    const double I_ = A * A * t4 + A * t3 + I_0;
    const double t5 = h_A + t0;
    const double t6 = I_0A + 2.0 * d * t1 + t3;
    const double F_AAA = 2.0 * (I_ * I_0AAA + 2.0 * I_0AA * t6 + R * h_AAA + 3.0 * h_AA * t5 + 4.0 * t4 * t6 + t6 *
        (I_0AA + 2.0 * t4));
    const double t7 = Omega * R;
    const double t8 = A * Omega;
    const double t9 = d * t8 + zeta;
    const double F_Omega = 4.0 * A * (I_ * t9 + t7);
    const double F_AOmega = 4.0 * (A * t6 * t9 + I_ * (A * d * t2 + zeta) + t5 * t8 + t7);
    return -F_AAA * F_AOmega * F_Omega / A;
}

/* At an isola point: negative at a saddle of F; and as `cusp_bend`.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 81.
   Measured, error / u (1 + kappa): 1.4 */
SF_KERNEL void dissipation_isola_bend(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double d, double h, double h_A, double h_AA, double *out)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * zeta;
    const double t2 = Omega * t1;
    const double t3 = A * A;
    const double t4 = Omega2 * t3;
    const double I_ = A * t2 + I_0 + d * t4;
    const double t5 = R * h_AA;
    const double t6 = 2.0 * d;
    const double t7 = Omega2 * t6;
    const double t8 = Omega2 + h_A;
    const double t9 = I_0A + t0 * t6 + t2;
    const double t10 = t8 * t8 + t9 * t9;
    const double F_AA = 2.0 * (I_ * I_0AA + I_ * t7 + t10 + t5);
    const double t11 = t3 * t6;
    const double t12 = A * t1 + Omega * t11;
    const double G_AOmega = 2.0 * A * Omega * t8 + t12 * t9;
    const double G_OmegaOmega = t12 * t12 + 4.0 * t4;
    const double S_AA = I_ * (I_0AA + t7) + t5;
    const double t13 = 2.0 * R;
    const double t14 = A * d;
    const double t15 = Omega * t14;
    const double S_AOmega = I_ * (t1 + 4.0 * t15) + Omega * t13;
    const double S_OmegaOmega = A * t13 + I_ * t11;
    const double t16 = 4.0 * S_OmegaOmega;
    const double Omega3 = Omega * Omega2;
    const double t17 = I_0A * Omega + Omega2 * zeta + Omega3 * t14 - h_A * t15 - h_A * zeta;
    const double t18 = -8.0 * G_AOmega * S_AOmega + 4.0 * G_OmegaOmega * S_AA + S_AA * t16 - 4.0 * S_AOmega *
        S_AOmega + t10 * t16 + 16.0 * t17 * t17 * t3;
    out[0] = t18;
    out[1] = F_AA * t18;
}

/* F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each.
   Equation from (24). Domain: F_0 > I_0. Operations: 10.
   Measured, error / u (1 + kappa): 0.51 */
SF_KERNEL void dissipation_static(double F_0, double I_0, double I_0A, double h, double h_A, double *out)
{
    const double c = sqrt((F_0 - I_0) * (F_0 + I_0));
    const double t0 = I_0 * I_0A / c;
    out[0] = -c + h;
    out[1] = c + h;
    out[2] = h_A + t0;
    out[3] = h_A - t0;
}

/* F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.
   Equation (24). Domain: A > 0. Operations: 23.
   Proved, error / u (1 + kappa): 0.67, 0.51, 2.51, 0.67, 0.86 */
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
   Equation (30). Domain: A > 0. Operations: 28.
   Proved, error / u (1 + kappa): 1.01, 1.67, 4.76, 0.81, 0.84 */
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

/* Largest amplitude that the forcing can hold at this frequency, where friction acts throughout.
   Equation (27). Domain: Omega > 0, F_0 > m, one of zeta, eta, d > 0. Operations: 16.
   Measured, error / u (1 + kappa): 0.89 */
SF_KERNEL double dissipation_limit_envelope(double Omega, double F_0, double m, double zeta, double eta, double d)
{
    const double t0 = 2.0 * Omega * zeta + eta;
    return (2.0 * F_0 - 2.0 * m) / (t0 + sqrt(-4.0 * Omega * Omega * d * (-F_0 + m) + t0 * t0));
}

/* F_A/2 by R, I and their slopes.
   Equation (30). Domain: Omega >= 0, A > 0. Operations: 3.
   Proved, error / u (1 + kappa): 1.01 */
SF_KERNEL double dissipation_F_A_halved(double R, double R_A, double I_, double I_A)
{
    return I_ * I_A + R * R_A;
}

/* R where F_Omega = 0.
   Equation from (24). Domain: Omega >= 0, A > 0. Operations: 4.
   Proved, error / u (1 + kappa): 1.51 */
SF_KERNEL double dissipation_R_of_peak(double Omega, double A, double zeta, double d, double I_)
{
    return I_ * (-A * d - zeta / Omega);
}

/* Of what 4/A times the least F_A/2 is not below where |k| <= A^2 |h_AA|/2, friction throughout: 1, A^2.
   Equation from (30). Domain: Omega >= 0. Operations: 13.
   Proved, error / u (1 + kappa): -, 1.01
   Measured, error / u (1 + kappa): 0.78 */
SF_KERNEL void dissipation_least_scaled(double Omega, double zeta, double eta, double d, double h_AA, double *out)
{
    const double t0 = 2.0 * Omega * zeta + eta;
    const double Omega2 = Omega * Omega;
    const double Omega4 = Omega2 * Omega2;
    out[0] = 4.0 * t0 * t0;
    out[1] = 8.0 * Omega4 * d * d - 0.25 * h_AA * h_AA;
}

/* F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.
   Equation (24). Domain: x >= 0, A > 0. Operations: 34.
   Proved, error / u (1 + kappa): -, -, 0.67
   Measured, error / u (1 + kappa): 1.2 */
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

/* As `cusp_bend`, for an excitation by inertia.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 54.
   Measured, error / u (1 + kappa): 0.78 */
SF_KERNEL double dissipation_cusp_bend_by_inertia(double Omega, double A, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = Omega * zeta;
    const double t3 = 2.0 * t2;
    const double t4 = d * t0;
    const double I_ = A * A * t4 + A * t3 + I_0;
    const double t5 = h_A + t0;
    const double t6 = I_0A + 2.0 * d * t1 + t3;
    const double F_AAA = 2.0 * (I_ * I_0AAA + 2.0 * I_0AA * t6 + R * h_AAA + 3.0 * h_AA * t5 + 4.0 * t4 * t6 + t6 *
        (I_0AA + 2.0 * t4));
    const double t7 = A * Omega;
    const double t8 = d * t7;
    const double F_AOmega = 4.0 * (A * t6 * (t8 + zeta) + I_ * (2.0 * t8 + zeta) + Omega * R + t5 * t7);
    return F_AAA * F_AOmega * (I_ * (A * t2 + I_0) + R * h);
}

/* As `isola_bend`, for an excitation by inertia.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 61.
   Measured, error / u (1 + kappa): 1.7 */
SF_KERNEL void dissipation_isola_bend_by_inertia(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double d, double h, double h_A, double h_AA, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = Omega * zeta;
    const double t3 = 2.0 * t2;
    const double t4 = A * A;
    const double t5 = d * t0;
    const double I_ = A * t3 + I_0 + t4 * t5;
    const double t6 = h_A + t0;
    const double t7 = 2.0 * d;
    const double t8 = I_0A + t1 * t7 + t3;
    const double F_AA = 2.0 * (I_ * I_0AA + 2.0 * I_ * t5 + R * h_AA + t6 * t6 + t8 * t8);
    const double t9 = A * Omega;
    const double t10 = d * t9;
    const double F_AOmega = 4.0 * (A * t8 * (t10 + zeta) + I_ * (2.0 * t10 + zeta) + Omega * R + t6 * t9);
    const double t11 = A * zeta;
    const double F_OmegaOmega = (-4.0 * I_ * t11 - 8.0 * h * t9 - 4.0 * (A * t2 + I_0) * (Omega * t4 * t7 + 2.0 *
        t11)) / Omega;
    const double t12 = F_AA * F_OmegaOmega - F_AOmega * F_AOmega;
    out[0] = t12;
    out[1] = F_AA * t12;
}

/* The amplitude that the response tends to as Omega grows.
   Equation from (24). Domain: F_0 > 0. Operations: 10.
   Measured, error / u (1 + kappa): 1.4 */
SF_KERNEL double dissipation_full_by_inertia(double F_0, double d)
{
    return 1.4142135623730951 * F_0 / sqrt(sqrt(4.0 * F_0 * F_0 * d * d + 1.0) + 1.0);
}

/* Both positive: no state above A, while |h| grows by steepest dA at most.
   Equation from (23), (24). Domain: A > 0. Operations: 10.
   Proved, error / u (1 + kappa): -, 3.76
   Measured, error / u (1 + kappa): 0.84 */
SF_KERNEL void dissipation_structural_bound(double A, double F_0, double eta, double h, double steepest, double *out)
{
    const double t0 = A - F_0;
    const double t1 = A * eta;
    out[0] = -F_0 * fabs(h) + t0 * t1;
    out[1] = -F_0 * steepest + eta * t0 + t1;
}

/* What no amplitude exceeds.
   Equation from (23), (24). Domain: d > 0. Operations: 3.
   Measured, error / u (1 + kappa): 1.2 */
SF_KERNEL double dissipation_quadratic_bound(double F_0, double d)
{
    return sqrt(F_0) / sqrt(d);
}

/* F and F_A/2; derivatives by A and by R of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 44.
   Proved, error / u (1 + kappa): -, 1.01, 3.51, 3.01, -, -
   Measured, error / u (1 + kappa): 0.68 */
SF_KERNEL void dissipation_folds_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
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

/* F and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 35.
   Proved, error / u (1 + kappa): -, 2.26, 3.51, 3.01, -, -
   Measured, error / u (1 + kappa): 0.42 */
SF_KERNEL void dissipation_peaks_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = A * d;
    const double t1 = 1.0 / Omega;
    const double t2 = t0 + t1 * zeta;
    const double t3 = t1 * (Omega * t0 + zeta);
    const double t4 = I_A - R_A * t3;
    const double Omega2 = Omega * Omega;
    const double Omega3 = Omega * Omega2;
    const double t5 = 0.5 * I_ * zeta / (A * Omega3);
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * t2 + R;
    out[2] = 2.0 * I_ * t4;
    out[3] = 2.0 * (I_ * t3 + R);
    out[4] = I_ * d + R_A * t5 + t2 * t4;
    out[5] = t2 * t3 - t5 + 1.0;
}

/* F_A/2 and F_AA/2; derivatives by A and by R of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 66.
   Proved, error / u (1 + kappa): 1.01, 3.01, -, -, -, -
   Measured, error / u (1 + kappa): 0.72 */
SF_KERNEL void dissipation_cusps_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 2.0 * d;
    const double t1 = Omega * Omega * t0;
    const double t2 = 1.0 / A;
    const double t3 = R_A * t2;
    const double t4 = h_AA - t3;
    const double t5 = 1.0 / Omega;
    const double t6 = A * Omega;
    const double t7 = t5 * (d * t6 + zeta);
    const double t8 = I_A - R_A * t7;
    const double t9 = t5 * (t0 * t6 + zeta);
    const double t10 = I_0AA + t1;
    const double t11 = t10 - t3 * t9;
    const double t12 = I_ * t2;
    const double t13 = 2.0 * I_A;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * I_0AA + I_ * t1 + I_A * I_A + R * h_AA + R_A * R_A;
    out[2] = I_ * t11 + I_A * t8 + R * t4;
    out[3] = I_A * t7 + R * t2 + R_A + t12 * t9;
    out[4] = I_ * I_0AAA - I_ * t0 * t3 + R * h_AAA + 2.0 * R_A * t4 + t10 * t8 + t11 * t13;
    out[5] = h_AA + t0 * t12 + t10 * t7 + t13 * t2 * t9 + 2.0 * t3;
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 51.
   Proved, error / u (1 + kappa): 1.01, 2.26, -, -, -, -
   Measured, error / u (1 + kappa): 0.71 */
SF_KERNEL void dissipation_isolas_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = A * d;
    const double t1 = 1.0 / Omega;
    const double t2 = t0 + t1 * zeta;
    const double t3 = 1.0 / A;
    const double t4 = R_A * t3;
    const double t5 = Omega * t0;
    const double t6 = t1 * (t5 + zeta);
    const double t7 = I_A - R_A * t6;
    const double t8 = t1 * (2.0 * t5 + zeta);
    const double t9 = I_ * t3;
    const double Omega2 = Omega * Omega;
    const double Omega3 = Omega * Omega2;
    const double t10 = 0.5 * zeta / Omega3;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * t2 + R;
    out[2] = I_ * (I_0AA + 2.0 * Omega2 * d - t4 * t8) + I_A * t7 + R * (h_AA - t4);
    out[3] = I_A * t6 + R * t3 + R_A + t8 * t9;
    out[4] = I_ * d + I_ * t10 * t4 + t2 * t7;
    out[5] = -t10 * t9 + t2 * t6 + 1.0;
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 97.
   Proved, error / u (1 + kappa): 1.01, -, -, -, -, -
   Measured, error / u (1 + kappa): 0.73 */
SF_KERNEL void dissipation_turns_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = R * R_A;
    const double t1 = A * R_A;
    const double t2 = 2.0 * d;
    const double t3 = I_ * t2;
    const double t4 = A * A;
    const double t5 = I_A * d;
    const double t6 = zeta / Omega;
    const double t7 = I_ * t6;
    const double t8 = I_A * t6;
    const double t9 = 1.0 / A;
    const double Omega2 = Omega * Omega;
    const double t10 = t7 * t9;
    const double t11 = A * t5;
    const double t12 = A * t6;
    const double Omega3 = Omega * Omega2;
    const double t13 = 0.5 * zeta / Omega3;
    const double t14 = I_A * t13;
    const double t15 = d * d * t4;
    const double t16 = 4.0 * t15;
    const double t17 = 2.0 * zeta * zeta / Omega2;
    const double t18 = 6.0 * d;
    const double t19 = I_ * t13 * t9;
    out[0] = I_ * I_A + t0;
    out[1] = A * t3 + A * t8 + R + t1 + t4 * t5 + t7;
    out[2] = I_ * I_0AA + 2.0 * I_ * Omega2 * d + I_A * I_A + R * h_AA - R_A * t10 - R_A * t3 - R_A * t8 - t0 * t9
        - t1 * t5;
    out[3] = R * t9 + R_A + t10 + t11 + t3 + t8;
    out[4] = A * Omega * t2 * zeta + A * h_AA + I_0AA * d * t4 + I_0AA * t12 + 2.0 * Omega2 * t15 + R_A * t14 -
        R_A * t16 - R_A * t17 + R_A * t19 - t1 * t18 * t6 + 4.0 * t11 + t3 + 2.0 * t8;
    out[5] = t12 * t18 - t14 + t16 + t17 - t19 + 2.0;
}

/* F and F_A/2; derivatives by A and by Omega of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 38.
   Proved, error / u (1 + kappa): -, 1.01, 1.01, 3.26, 3.01, -
   Measured, error / u (1 + kappa): 0.43 */
SF_KERNEL void dissipation_folds_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = I_ * I_A + R * R_A;
    const double t1 = Omega * R;
    const double t2 = A * Omega;
    const double t3 = d * t2;
    const double t4 = t3 + zeta;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = t0;
    out[2] = 2.0 * t0;
    out[3] = 4.0 * A * (I_ * t4 + t1);
    out[4] = I_ * (I_0AA + 2.0 * Omega * Omega * d) + I_A * I_A + R * h_AA + R_A * R_A;
    out[5] = 2.0 * (A * I_A * t4 + I_ * (2.0 * t3 + zeta) + R_A * t2 + t1);
}

/* F and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 48.
   Proved, error / u (1 + kappa): -, -, 1.01, 3.26, -, 10.51
   Measured, error / u (1 + kappa): 0.52 */
SF_KERNEL void dissipation_peaks_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = zeta / Omega;
    const double t1 = 3.0 * zeta;
    const double t2 = A * d;
    const double t3 = Omega * t2;
    const double t4 = I_0 * d + t3 * (t1 + t3) + 2.0 * zeta * zeta;
    const double t5 = t1 + 2.0 * t3;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = A * t4 + I_0 * t0 + R;
    out[2] = 2.0 * (I_ * I_A + R * R_A);
    out[3] = 4.0 * A * (I_ * (t3 + zeta) + Omega * R);
    out[4] = I_0A * (t0 + t2) + R_A + t3 * t5 + t4;
    out[5] = A * A * d * t5 + 2.0 * A * Omega - I_0 * zeta / (Omega * Omega);
}

/* F_A/2 and F_AA/2; derivatives by A and by Omega of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 54.
   Proved, error / u (1 + kappa): 1.01, 2.51, 2.01, -, 3.51, -
   Measured, error / u (1 + kappa): 0.76 */
SF_KERNEL void dissipation_cusps_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 2.0 * d;
    const double t1 = Omega * Omega * t0;
    const double t2 = I_A * I_A + R * h_AA + R_A * R_A;
    const double t3 = I_0AA + t1;
    const double t4 = A * Omega;
    const double t5 = t0 * t4 + zeta;
    const double t6 = A * (d * t4 + zeta);
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * I_0AA + I_ * t1 + t2;
    out[2] = I_ * t3 + t2;
    out[3] = 2.0 * (I_ * t5 + I_A * t6 + Omega * R + R_A * t4);
    out[4] = I_ * I_0AAA + 3.0 * I_A * t3 + R * h_AAA + 3.0 * R_A * h_AA;
    out[5] = 2.0 * (I_ * Omega * t0 + 2.0 * I_A * t5 + 2.0 * Omega * R_A + h_AA * t4 + t3 * t6);
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 57.
   Proved, error / u (1 + kappa): 1.01, -, 3.01, -, -, 10.51
   Measured, error / u (1 + kappa): 0.9 */
SF_KERNEL void dissipation_isolas_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = zeta / Omega;
    const double t1 = 3.0 * zeta;
    const double t2 = A * d;
    const double t3 = Omega * t2;
    const double t4 = I_0 * d + t3 * (t1 + t3) + 2.0 * zeta * zeta;
    const double t5 = Omega * Omega;
    const double t6 = A * Omega;
    const double t7 = 2.0 * t3;
    const double t8 = t1 + t7;
    out[0] = I_ * I_A + R * R_A;
    out[1] = A * t4 + I_0 * t0 + R;
    out[2] = I_ * (I_0AA + 2.0 * d * t5) + I_A * I_A + R * h_AA + R_A * R_A;
    out[3] = 2.0 * (A * I_A * (t3 + zeta) + I_ * (t7 + zeta) + Omega * R + R_A * t6);
    out[4] = I_0A * (t0 + t2) + R_A + t3 * t8 + t4;
    out[5] = A * A * d * t8 - I_0 * zeta / t5 + 2.0 * t6;
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 84.
   Proved, error / u (1 + kappa): 1.01, -, 3.01, -, -, -
   Measured, error / u (1 + kappa): 1.2 */
SF_KERNEL void dissipation_turns_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = A * R_A;
    const double t1 = 2.0 * d;
    const double t2 = I_ * t1;
    const double t3 = A * t2;
    const double A2 = A * A;
    const double t4 = A2 * d;
    const double t5 = I_A * t4;
    const double t6 = 1.0 / Omega;
    const double t7 = I_ * zeta;
    const double t8 = I_A * zeta;
    const double t9 = A * t8;
    const double t10 = Omega * Omega;
    const double t11 = 4.0 * A;
    const double t12 = A * zeta;
    const double t13 = d * d;
    const double t14 = 1.0 / t10;
    const double A3 = A * A2;
    out[0] = I_ * I_A + R * R_A;
    out[1] = R + t0 + t3 + t5 + t6 * t7 + t6 * t9;
    out[2] = I_ * I_0AA + I_A * I_A + R * h_AA + R_A * R_A + t10 * t2;
    out[3] = 2.0 * (Omega * R + Omega * t0 + Omega * t3 + Omega * t5 + t7 + t9);
    out[4] = A * h_AA + 2.0 * A2 * t10 * t13 + I_0AA * t12 * t6 + I_0AA * t4 + I_A * d * t11 + Omega * t1 * t12 +
        2.0 * R_A + t2 + 2.0 * t6 * t8;
    out[5] = 8.0 * A3 * Omega * t13 + Omega * t11 + t11 * t6 * zeta * zeta - t14 * t7 - t14 * t9 + 12.0 * t4 *
        zeta;
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 45.
   Proved, error / u (1 + kappa): -, 1.01, 4.01, 3.51, 13.67, 11.67
   Measured, error / u (1 + kappa): 0.53 */
SF_KERNEL void dissipation_folds_far_by_R(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
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

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 53.
   Proved, error / u (1 + kappa): -, 3.26, 4.51, 4.01, -, -
   Measured, error / u (1 + kappa): 0.91 */
SF_KERNEL void dissipation_peaks_far_by_R(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 1.0 / h;
    const double t1 = 1.0 / x;
    const double t2 = A * zeta;
    const double t3 = t1 * t2;
    const double t4 = I_0 * x + t2;
    const double t5 = t0 * t4;
    const double t6 = I_A - R_A * t1 * t5;
    const double t7 = I_ * t1;
    const double t8 = I_ * t0;
    const double x2 = x * x;
    const double x3 = x * x2;
    const double t9 = 0.5 * t2 / x3;
    const double t10 = I_0 + t3;
    const double t11 = 1.0 / (h * h);
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * (I_0 * t0 + t0 * t3) + R;
    out[2] = 2.0 * I_ * t6;
    out[3] = 2.0 * (R + t5 * t7);
    out[4] = t0 * (I_ * I_0A + R_A * t8 * t9 - h_A * t10 * t8 + t10 * t6 + t7 * zeta);
    out[5] = -I_ * t11 * t9 + t1 * t10 * t11 * t4 + 1.0;
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 72.
   Proved, error / u (1 + kappa): 1.01, 4.01, 13.01, 11.67, -, -
   Measured, error / u (1 + kappa): 0.84 */
SF_KERNEL void dissipation_cusps_far_by_R(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 2.0 * d;
    const double t1 = x * x;
    const double t2 = I_0AA * t1;
    const double t3 = h_AA * t1;
    const double t4 = 1.0 / h;
    const double t5 = h_A * t4;
    const double t6 = R_A * t5;
    const double t7 = h_AA * t1 - t6;
    const double t8 = A * zeta + I_0 * x;
    const double t9 = t4 / x;
    const double t10 = R_A * t9;
    const double t11 = I_A - t10 * t8;
    const double t12 = I_0A * x + zeta;
    const double t13 = t0 + t2;
    const double t14 = -t10 * t12 + t13;
    const double t15 = t12 * t9;
    const double t16 = t8 * t9;
    const double t17 = t4 * (I_ * I_0AA + R * h_AA);
    const double t18 = 2.0 * I_A;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * t0 + I_ * t2 + I_A * I_A + R * t3 + R_A * R_A;
    out[2] = I_ * t14 + I_A * t11 + R * t7;
    out[3] = I_ * t15 + I_A * t16 + R * t5 + R_A;
    out[4] = I_ * I_0AAA * t1 + R * h_AAA * t1 - R_A * t17 + 2.0 * R_A * t7 + t11 * t13 + t14 * t18;
    out[5] = t13 * t16 + t15 * t18 + t17 + t3 + 2.0 * t6;
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 69.
   Proved, error / u (1 + kappa): 1.01, 3.26, 15.01, 13.01, -, -
   Measured, error / u (1 + kappa): 0.7 */
SF_KERNEL void dissipation_isolas_far_by_R(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 1.0 / h;
    const double t1 = 1.0 / x;
    const double t2 = A * zeta;
    const double t3 = t1 * t2;
    const double x2 = x * x;
    const double t4 = h_A * t0;
    const double t5 = R_A * t1;
    const double t6 = I_0 * x + t2;
    const double t7 = t0 * t6;
    const double t8 = I_A - t5 * t7;
    const double t9 = t0 * (I_0A * x + zeta);
    const double t10 = I_ * t1;
    const double x3 = x * x2;
    const double t11 = 0.5 * I_ * t2 / x3;
    const double t12 = I_0 + t3;
    const double t13 = 1.0 / (h * h);
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * (I_0 * t0 + t0 * t3) + R;
    out[2] = I_ * (I_0AA * x2 + 2.0 * d - t5 * t9) + I_A * t8 + R * (-R_A * t4 + h_AA * x2);
    out[3] = I_A * t1 * t7 + R * t4 + R_A + t10 * t9;
    out[4] = t0 * (I_ * I_0A - I_ * t12 * t4 + R_A * t0 * t11 + t10 * zeta + t12 * t8);
    out[5] = t1 * t12 * t13 * t6 - t11 * t13 + 1.0;
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 40.
   Proved, error / u (1 + kappa): -, 1.01, 1.01, 2.01, 3.67, 7.67
   Measured, error / u (1 + kappa): 0.59 */
SF_KERNEL void dissipation_folds_far_by_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
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

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 54.
   Proved, error / u (1 + kappa): -, 7.51, 1.01, 2.01, 16.21, 8.51
   Measured, error / u (1 + kappa): 0.91 */
SF_KERNEL void dissipation_peaks_far_by_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = R * h;
    const double t1 = A * zeta;
    const double t2 = I_0 * x;
    const double t3 = 2.0 * t1;
    const double t4 = A * A;
    const double t5 = d / x;
    const double t6 = t2 + t3 + t4 * t5;
    const double t7 = t1 + t2;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * I_0 + t0 + t1 * t6;
    out[2] = 2.0 * (I_ * I_A + R * R_A);
    out[3] = 4.0 * (I_ * t7 + t0 * x);
    out[4] = I_0 * I_A + I_0A * (I_ + t1 * x) + R * h_A + R_A * h + t3 * (A * t5 + zeta) + t6 * zeta;
    out[5] = 2.0 * I_0 * t7 + 2.0 * h * h * x + t1 * (I_0 - d * t4 / (x * x));
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 62.
   Proved, error / u (1 + kappa): 1.01, 3.34, 3.01, 7.67, 4.21, -
   Measured, error / u (1 + kappa): 0.75 */
SF_KERNEL void dissipation_cusps_far_by_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 2.0 * d;
    const double x2 = x * x;
    const double t1 = I_0AA * x2;
    const double t2 = R * x2;
    const double t3 = I_A * I_A + R_A * R_A + h_AA * t2;
    const double t4 = t0 + t1;
    const double t5 = R * x;
    const double t6 = R_A * x;
    const double t7 = I_0A * x + zeta;
    const double t8 = A * zeta + I_0 * x;
    const double x3 = x * x2;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * t0 + I_ * t1 + t3;
    out[2] = I_ * t4 + t3;
    out[3] = 2.0 * (I_ * t7 + I_A * t8 + h * t6 + h_A * t5);
    out[4] = I_ * I_0AAA * x2 + 3.0 * I_A * t4 + 3.0 * R_A * h_AA * x2 + h_AAA * t2;
    out[5] = 2.0 * (I_ * I_0AA * x + 2.0 * I_A * t7 + h * h_AA * x3 + 2.0 * h_A * t6 + h_AA * t5 + t4 * t8);
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 65.
   Proved, error / u (1 + kappa): 1.01, 7.51, 3.67, 7.67, 16.21, 8.51 */
SF_KERNEL void dissipation_isolas_far_by_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = A * zeta;
    const double t1 = I_0 * x;
    const double t2 = 2.0 * t0;
    const double t3 = A * A;
    const double t4 = d / x;
    const double t5 = t1 + t2 + t3 * t4;
    const double t6 = x * x;
    const double t7 = R * h_A;
    const double t8 = R_A * h;
    const double t9 = t0 + t1;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * I_0 + R * h + t0 * t5;
    out[2] = I_ * (I_0AA * t6 + 2.0 * d) + I_A * I_A + R * h_AA * t6 + R_A * R_A;
    out[3] = 2.0 * (I_ * (I_0A * x + zeta) + I_A * t9 + t7 * x + t8 * x);
    out[4] = I_0 * I_A + I_0A * (I_ + t0 * x) + t2 * (A * t4 + zeta) + t5 * zeta + t7 + t8;
    out[5] = 2.0 * I_0 * t9 + 2.0 * h * h * x + t0 * (I_0 - d * t3 / t6);
}

SF_FAMILY_END

#endif
