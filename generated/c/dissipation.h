/* Structural and quadratic damping, and dry friction of what is attached.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/extensions/dissipation.py; never edit.

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are those in floating point. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/codegen/rounding.py).
   Others are measured: the worst error of all outputs that was found, by a search that dissipation.py describes.
   u = 2^-53, kappa is the relative condition number of an output in all arguments. */

#ifndef DISSIPATION_H
#define DISSIPATION_H

#include <math.h>

#include "inline.h"

SF_FAMILY_BEGIN

/* The factor of A^2 Omega^2 in I of quadratic damping.
   Equation from (19). Domain: any. Operations: 1. Error / u (1 + kappa): measured 0.69. */
SF_KERNEL double dissipation_quadratic(double c_2)
{
    return 0.84882636315677518 * c_2;
}

/* The factor of A^3 Omega^3 in I of cubic damping.
   Equation from (19). Domain: any. Operations: 1. Error / u (1 + kappa): proved 0.51. */
SF_KERNEL double dissipation_cubic(double c_3)
{
    return 0.75 * c_3;
}

/* The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.
   Equation from (23). Domain: A > 0, d > 0. Operations: 3. Error / u (1 + kappa): proved 2.01. */
SF_KERNEL double dissipation_restoring(double A, double F_0, double d)
{
    return F_0 + F_0 / (A * d);
}

/* I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.
   Equation from (19). Domain: A > 0. Operations: 2. Error / u (1 + kappa): proved 1.01, 0.0, 0.0, 0.0. */
SF_KERNEL void dissipation_at_rest(double A, double m, double eta, double *out)
{
    out[0] = A * eta + m;
    out[1] = eta;
    out[2] = 0.0;
    out[3] = 0.0;
}

/* The same where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. Operations: 13. Error / u (1 + kappa): proved 1.01, 1.01, 0.67, 0.86. */
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
   Equation from (19). Domain: A > 0. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.0, 0.0, 0.0. */
SF_KERNEL void dissipation_rest_moves(double A, double *out)
{
    for (int k = 0; k < 6; k++)
        out[k] = 0.0;
    out[0] = 1.0;
    out[3] = A;
    out[4] = 1.0;
}

/* What m, then eta, then u_cr does to them where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. Operations: 11. Error / u (1 + kappa): proved 0.81 at most. */
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

/* The viscous damping ratio of a cycle, and three derivatives by A.
   Equation from (19). Domain: A > 0. Operations: 6. Error / u (1 + kappa): proved 1.01, 0.34, 0.0, 0.0. */
SF_KERNEL void dissipation_viscous(double A, double zeta, double zeta_2, double *out)
{
    const double t0 = 0.5 * zeta_2;
    out[0] = 0.25 * A * A * zeta_2 + zeta;
    out[1] = A * t0;
    out[2] = t0;
    out[3] = 0.0;
}

/* What zeta_2 does to the first three of `viscous`.
   Equation from (19). Domain: A > 0. Operations: 3. Error / u (1 + kappa): proved 0.34, 0.0, 0.0. */
SF_KERNEL void dissipation_viscous_moves(double A, double *out)
{
    out[0] = 0.25 * A * A;
    out[1] = 0.5 * A;
    out[2] = 0.5;
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. Operations: 14. Error / u (1 + kappa): proved 7.01. */
SF_KERNEL double dissipation_I(double Omega, double A, double I_0, double zeta, double d, double d_3)
{
    const double A2 = A * A;
    const double Omega2 = Omega * Omega;
    const double A3 = A * A2;
    const double Omega3 = Omega * Omega2;
    return 2.0 * A * Omega * zeta + A2 * Omega2 * d + A3 * Omega3 * d_3 + I_0;
}

/* dI/dA.
   Equation (23). Domain: Omega > 0, A > 0. Operations: 17. Error / u (1 + kappa): proved 7.26. */
SF_KERNEL double dissipation_I_A(double Omega, double A, double I_0A, double zeta, double zeta_A, double d, double d_3)
{
    const double t0 = 2.0 * Omega;
    const double Omega2 = Omega * Omega;
    const double Omega3 = Omega * Omega2;
    return 3.0 * A * A * Omega3 * d_3 + 2.0 * A * Omega2 * d + A * t0 * zeta_A + I_0A + t0 * zeta;
}

/* R, R_A, I and I_A over Omega^2, at x = 1/Omega.
   Equation (23). Domain: x >= 0, A > 0. Operations: 21. Error / u (1 + kappa): proved 1.01, 1.34, 4.01, 4.51. */
SF_KERNEL void dissipation_far(double x, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double h, double h_A, double *out)
{
    const double t0 = x * x;
    const double t1 = 2.0 * A;
    const double t2 = x * zeta;
    out[0] = A + h * t0;
    out[1] = h_A * t0 + 1.0;
    out[2] = A * A * d + I_0 * t0 + t1 * t2;
    out[3] = I_0A * t0 + d * t1 + t1 * x * zeta_A + 2.0 * t2;
}

/* Zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 21. Error / u (1 + kappa): measured 0.51. */
SF_KERNEL double dissipation_F(double Omega, double A, double F_0, double I_0, double zeta, double d, double d_3, double h)
{
    const double Omega2 = Omega * Omega;
    const double R = A * Omega2 + h;
    const double A2 = A * A;
    const double A3 = A * A2;
    const double Omega3 = Omega * Omega2;
    const double I_ = 2.0 * A * Omega * zeta + A2 * Omega2 * d + A3 * Omega3 * d_3 + I_0;
    return R * R + (-F_0 + I_) * (F_0 + I_);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. Operations: 31. Error / u (1 + kappa): measured 0.64. */
SF_KERNEL double dissipation_F_A(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * Omega;
    const double t2 = t1 * zeta;
    const double A2 = A * A;
    const double Omega3 = Omega * Omega2;
    const double t3 = Omega3 * d_3;
    const double A3 = A * A2;
    const double I_ = A * t2 + A2 * Omega2 * d + A3 * t3 + I_0;
    return 2.0 * (I_ * (A * t1 * zeta_A + 3.0 * A2 * t3 + I_0A + 2.0 * d * t0 + t2) + R * (Omega2 + h_A));
}

/* d2F/dA2.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 48. Error / u (1 + kappa): measured 0.89. */
SF_KERNEL double dissipation_F_AA(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double zeta_A, double zeta_AA, double d, double d_3, double h, double h_A, double h_AA)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * Omega;
    const double t2 = t1 * zeta;
    const double A2 = A * A;
    const double Omega3 = Omega * Omega2;
    const double t3 = Omega3 * d_3;
    const double A3 = A * A2;
    const double I_ = A * t2 + A2 * Omega2 * d + A3 * t3 + I_0;
    const double t4 = t1 * zeta_A;
    const double t5 = I_ * t1;
    const double t6 = Omega2 + h_A;
    const double t7 = A * t4 + 3.0 * A2 * t3 + I_0A + 2.0 * d * t0 + t2;
    return 2.0 * (A * t5 * zeta_AA + I_ * I_0AA + I_ * t4 + R * h_AA + t5 * (Omega * d + 3.0 * d_3 * t0 +
        zeta_A) + t6 * t6 + t7 * t7);
}

/* d2F/dOmega2.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 35. Error / u (1 + kappa): measured 0.84. */
SF_KERNEL double dissipation_F_OmegaOmega(double Omega, double A, double I_0, double zeta, double d, double d_3, double h)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * zeta;
    const double t2 = A * Omega;
    const double A2 = A * A;
    const double t3 = A2 * Omega2;
    const double A3 = A * A2;
    const double Omega3 = Omega * Omega2;
    const double I_ = A3 * Omega3 * d_3 + I_0 + d * t3 + t1 * t2;
    const double t4 = 3.0 * d_3;
    const double t5 = 2.0 * A;
    const double t6 = Omega * d * t5 + t1 + t3 * t4;
    return t5 * (A * t6 * t6 + I_ * t5 * (d + t2 * t4) + 2.0 * R + 4.0 * t0);
}

/* d3F/dA dOmega2.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 59. Error / u (1 + kappa): measured 0.76. */
SF_KERNEL double dissipation_F_AOmegaOmega(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * zeta;
    const double t2 = Omega * t1;
    const double A2 = A * A;
    const double t3 = A2 * Omega2;
    const double Omega3 = Omega * Omega2;
    const double t4 = Omega3 * d_3;
    const double A3 = A * A2;
    const double I_ = A * t2 + A3 * t4 + I_0 + d * t3;
    const double t5 = 2.0 * d;
    const double t6 = A * Omega;
    const double t7 = 9.0 * d_3;
    const double t8 = 3.0 * d_3;
    const double t9 = 2.0 * A * zeta_A;
    return 4.0 * (A * I_ * (t5 + t6 * t7) + A * (Omega2 + h_A) + A * (t1 + t3 * t8 + t5 * t6) * (4.0 * d * t6 +
        t1 + t3 * t7 + t9) + A2 * (d + t6 * t8) * (3.0 * A2 * t4 + I_0A + Omega * t9 + t0 * t5 + t2) + R + 4.0 * t0);
}

/* dOmega/dA along the response.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 46. Error / u (1 + kappa): measured 0.78. */
SF_KERNEL double dissipation_Omega_A(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * zeta;
    const double t2 = A * t1;
    const double A2 = A * A;
    const double t3 = A2 * d;
    const double Omega3 = Omega * Omega2;
    const double A3 = A * A2;
    const double t4 = A3 * d_3;
    const double I_ = I_0 + Omega * t2 + Omega2 * t3 + Omega3 * t4;
    const double t5 = 2.0 * Omega;
    return -2.0 * (I_ * (A * t5 * zeta_A + 3.0 * A2 * Omega3 * d_3 + I_0A + Omega * t1 + 2.0 * d * t0) + R *
        (Omega2 + h_A)) / (4.0 * A * Omega * R + 2.0 * I_ * (3.0 * Omega2 * t4 + t2 + t3 * t5));
}

/* The same of an excitation by inertia.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 42. Error / u (1 + kappa): measured 0.95. */
SF_KERNEL double dissipation_Omega_A_by_inertia(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = Omega * zeta;
    const double t2 = A * t1;
    const double A2 = A * A;
    const double Omega3 = Omega * Omega2;
    const double t3 = Omega3 * d_3;
    const double A3 = A * A2;
    const double t4 = A3 * t3;
    const double I_ = A2 * Omega2 * d + I_0 + 2.0 * t2 + t4;
    const double t5 = 2.0 * Omega;
    return t5 * (I_ * (A * t5 * zeta_A + 3.0 * A2 * t3 + I_0A + 2.0 * d * t0 + 2.0 * t1) + R * (Omega2 + h_A)) /
        (4.0 * I_ * (I_0 + t2 - 0.5 * t4) + 4.0 * R * h);
}

/* Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 98. Error / u (1 + kappa): measured 0.93. */
SF_KERNEL double dissipation_cusp_bend(double Omega, double A, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * zeta;
    const double t2 = Omega * t1;
    const double A2 = A * A;
    const double t3 = A2 * Omega2;
    const double Omega3 = Omega * Omega2;
    const double t4 = Omega3 * d_3;
    const double A3 = A * A2;
    const double I_ = A * t2 + A3 * t4 + I_0 + d * t3;
    const double t5 = 2.0 * Omega;
    const double t6 = t5 * zeta_AA;
    const double t7 = A * t5;
    const double t8 = Omega2 + h_A;
    const double t9 = t5 * zeta_A;
    const double t10 = A * t9 + 3.0 * A2 * t4 + I_0A + 2.0 * d * t0 + t2;
    const double t11 = 4.0 * Omega;
    const double t12 = t10 * t11;
    const double t13 = A * t10;
    const double t14 = Omega * d;
    const double t15 = 3.0 * d_3;
    const double t16 = t0 * t15 + t14 + zeta_A;
    const double F_AAA = 2.0 * (I_ * I_0AAA + 6.0 * I_ * t4 + I_ * t6 + I_ * t7 * zeta_AAA + 2.0 * I_0AA * t10 + R *
        h_AAA + 3.0 * h_AA * t8 + t10 * (A * t6 + I_0AA + t16 * t5 + t9) + t11 * zeta_AA * (I_ + t13) + t12 * t16 +
        t12 * zeta_A);
    const double t17 = R * t5;
    const double t18 = 2.0 * A;
    const double t19 = t1 + t14 * t18 + t15 * t3;
    const double F_Omega = t18 * (I_ * t19 + t17);
    const double F_AOmega = 2.0 * (I_ * (4.0 * A * t14 + 9.0 * d_3 * t3 + t1 + t18 * zeta_A) + t13 * t19 + t17 + t7
        * t8);
    return -F_AAA * F_AOmega * F_Omega / A;
}

/* At an isola point: negative at a saddle of F; and as `cusp_bend`.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 133. Error / u (1 + kappa): measured 0.71. */
SF_KERNEL void dissipation_isola_bend(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double zeta_A, double zeta_AA, double d, double d_3, double h, double h_A, double h_AA, double *out)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * zeta;
    const double t2 = Omega * t1;
    const double A2 = A * A;
    const double t3 = A2 * Omega2;
    const double A3 = A * A2;
    const double Omega3 = Omega * Omega2;
    const double t4 = Omega3 * d_3;
    const double I_ = A * t2 + A3 * t4 + I_0 + d * t3;
    const double t5 = R * h_AA;
    const double t6 = Omega * zeta_A;
    const double t7 = Omega * d;
    const double t8 = 3.0 * d_3;
    const double t9 = 2.0 * Omega;
    const double t10 = 2.0 * A;
    const double t11 = Omega * t10;
    const double t12 = t11 * zeta_AA;
    const double t13 = Omega2 + h_A;
    const double t14 = 2.0 * d;
    const double t15 = 3.0 * A2;
    const double t16 = I_0A + t0 * t14 + t10 * t6 + t15 * t4 + t2;
    const double t17 = t13 * t13 + t16 * t16;
    const double F_AA = 2.0 * (I_ * I_0AA + I_ * t12 + 2.0 * I_ * t6 + I_ * t9 * (t0 * t8 + t7 + zeta_A) + t17 + t5);
    const double t18 = A * t1 + 2.0 * A2 * t7 + A3 * Omega2 * t8;
    const double G_AOmega = t11 * t13 + t16 * t18;
    const double G_OmegaOmega = t18 * t18 + 4.0 * t3;
    const double S_AA = I_ * (6.0 * A * t4 + I_0AA + Omega2 * t14 + t12 + 4.0 * t6) + t5;
    const double S_AOmega = I_ * (4.0 * A * t7 + 9.0 * d_3 * t3 + t1 + t10 * zeta_A) + R * t9;
    const double S_OmegaOmega = I_ * (A2 * t14 + 6.0 * A3 * Omega * d_3) + R * t10;
    const double t19 = 4.0 * S_OmegaOmega;
    const double Omega4 = Omega2 * Omega2;
    const double t20 = A * Omega3 * t14 + I_0A * t9 + Omega2 * t1 + Omega4 * d_3 * t15 - h_A * t1 - h_A * t10 * t7 -
        h_A * t3 * t8 + 4.0 * t0 * zeta_A;
    const double t21 = 4.0 * A2 * t20 * t20 - 8.0 * G_AOmega * S_AOmega + 4.0 * G_OmegaOmega * S_AA + S_AA * t19 -
        4.0 * S_AOmega * S_AOmega + t17 * t19;
    out[0] = t21;
    out[1] = F_AA * t21;
}

/* F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each.
   Equation from (24). Domain: F_0 > I_0. Operations: 10. Error / u (1 + kappa): measured 0.71. */
SF_KERNEL void dissipation_static(double F_0, double I_0, double I_0A, double h, double h_A, double *out)
{
    const double c = sqrt((F_0 - I_0) * (F_0 + I_0));
    const double t0 = I_0 * I_0A / c;
    out[0] = -c + h;
    out[1] = c + h;
    out[2] = h_A + t0;
    out[3] = h_A - t0;
}

/* F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^6.
   Equation (24). Domain: A > 0. Operations: 34. Error / u (1 + kappa): proved 0.67, 0.51, 2.51, 2.51, 3.67, 0.76,
   0.78. */
SF_KERNEL void dissipation_response_polynomial(double A, double I_0, double zeta, double d, double d_3, double h, double *out)
{
    const double t0 = 4.0 * zeta;
    const double A2 = A * A;
    const double t1 = 2.0 * I_0;
    const double A3 = A * A2;
    const double A4 = A2 * A2;
    const double A5 = A * A4;
    const double A6 = A3 * A3;
    out[0] = I_0 * I_0 + h * h;
    out[1] = A * I_0 * t0;
    out[2] = 2.0 * A * h + A2 * (d * t1 + 4.0 * zeta * zeta);
    out[3] = A3 * (d * t0 + d_3 * t1);
    out[4] = A2 + A4 * (d * d + d_3 * t0);
    out[5] = 2.0 * A5 * d * d_3;
    out[6] = A6 * d_3 * d_3;
}

/* F_A/2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^6.
   Equation (30). Domain: A > 0. Operations: 56. Error / u (1 + kappa): proved 1.01, 2.01, 7.15, 6.01, 6.17, 0.86,
   0.88. */
SF_KERNEL void dissipation_fold_polynomial(double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A, double *out)
{
    const double t0 = 2.0 * I_0;
    const double A2 = A * A;
    const double A3 = A * A2;
    const double t1 = 2.0 * zeta_A;
    const double A4 = A2 * A2;
    const double t2 = A4 * d_3;
    const double A5 = A * A4;
    out[0] = I_0 * I_0A + h * h_A;
    out[1] = A * (2.0 * I_0A * zeta + t0 * zeta_A) + t0 * zeta;
    out[2] = A * h_A + A * (d * t0 + 4.0 * zeta * zeta) + A2 * (I_0A * d + 4.0 * zeta * zeta_A) + h;
    out[3] = A2 * (3.0 * I_0 * d_3 + 6.0 * d * zeta) + A3 * (I_0A * d_3 + d * t1);
    out[4] = A + A3 * (2.0 * d * d + 8.0 * d_3 * zeta) + t1 * t2;
    out[5] = 5.0 * d * t2;
    out[6] = 3.0 * A5 * d_3 * d_3;
}

/* Largest amplitude that the forcing can hold at this frequency, where friction acts throughout.
   Equation (27). Domain: Omega > 0, F_0 > m, one of zeta, eta, d > 0. Operations: 16. Error / u (1 + kappa):
   measured 0.89. */
SF_KERNEL double dissipation_limit_envelope(double Omega, double F_0, double m, double zeta, double eta, double d)
{
    const double t0 = 2.0 * Omega * zeta + eta;
    return (2.0 * F_0 - 2.0 * m) / (t0 + sqrt(-4.0 * Omega * Omega * d * (-F_0 + m) + t0 * t0));
}

/* F_A/2 by R, I and their slopes.
   Equation (30). Domain: Omega >= 0, A > 0. Operations: 3. Error / u (1 + kappa): proved 1.01. */
SF_KERNEL double dissipation_F_A_halved(double R, double R_A, double I_, double I_A)
{
    return I_ * I_A + R * R_A;
}

/* R where F_Omega = 0.
   Equation from (24). Domain: Omega >= 0, A > 0. Operations: 9. Error / u (1 + kappa): proved 4.76. */
SF_KERNEL double dissipation_R_of_peak(double Omega, double A, double zeta, double d, double d_3, double I_)
{
    return I_ * (-1.5 * A * A * Omega * d_3 - A * d - zeta / Omega);
}

/* F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.
   Equation (24). Domain: x >= 0, A > 0. Operations: 34. Error / u (1 + kappa): proved -, -, 0.67; measured 1.2. */
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
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 102. Error / u (1 + kappa): measured 0.81. */
SF_KERNEL double dissipation_cusp_bend_by_inertia(double Omega, double A, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * zeta;
    const double t2 = Omega * t1;
    const double A2 = A * A;
    const double t3 = A2 * Omega2;
    const double Omega3 = Omega * Omega2;
    const double t4 = Omega3 * d_3;
    const double A3 = A * A2;
    const double t5 = A3 * t4;
    const double I_ = A * t2 + I_0 + d * t3 + t5;
    const double t6 = 2.0 * Omega;
    const double t7 = t6 * zeta_AA;
    const double t8 = A * t6;
    const double t9 = Omega2 + h_A;
    const double t10 = t6 * zeta_A;
    const double t11 = A * t10 + 3.0 * A2 * t4 + I_0A + 2.0 * d * t0 + t2;
    const double t12 = 4.0 * Omega;
    const double t13 = t11 * t12;
    const double t14 = A * t11;
    const double t15 = Omega * d;
    const double t16 = 3.0 * d_3;
    const double t17 = t0 * t16 + t15 + zeta_A;
    const double F_AAA = 2.0 * (I_ * I_0AAA + 6.0 * I_ * t4 + I_ * t7 + I_ * t8 * zeta_AAA + 2.0 * I_0AA * t11 + R *
        h_AAA + 3.0 * h_AA * t9 + t11 * (A * t7 + I_0AA + t10 + t17 * t6) + t12 * zeta_AA * (I_ + t14) + t13 * t17 +
        t13 * zeta_A);
    const double t18 = 2.0 * A;
    const double F_AOmega = 2.0 * (I_ * (4.0 * A * t15 + 9.0 * d_3 * t3 + t1 + t18 * zeta_A) + R * t6 + t14 * (t1 +
        t15 * t18 + t16 * t3) + t8 * t9);
    return F_AAA * F_AOmega * (I_ * (A * Omega * zeta + I_0 - 0.5 * t5) + R * h);
}

/* As `isola_bend`, for an excitation by inertia.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 102. Error / u (1 + kappa): measured 1.5. */
SF_KERNEL void dissipation_isola_bend_by_inertia(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double zeta_A, double zeta_AA, double d, double d_3, double h, double h_A, double h_AA, double *out)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * zeta;
    const double t2 = Omega * t1;
    const double A2 = A * A;
    const double t3 = A2 * Omega2;
    const double A3 = A * A2;
    const double Omega3 = Omega * Omega2;
    const double t4 = Omega3 * d_3;
    const double t5 = A3 * t4;
    const double I_ = A * t2 + I_0 + d * t3 + t5;
    const double t6 = 2.0 * zeta_A;
    const double t7 = 2.0 * Omega;
    const double t8 = I_ * t7;
    const double t9 = Omega2 + h_A;
    const double t10 = Omega * d;
    const double t11 = 3.0 * d_3;
    const double t12 = A * t6;
    const double t13 = 3.0 * A2 * t4 + I_0A + Omega * t12 + 2.0 * d * t0 + t2;
    const double F_AA = 2.0 * (A * t8 * zeta_AA + I_ * I_0AA + I_ * Omega * t6 + R * h_AA + t13 * t13 + t8 * (t0 *
        t11 + t10 + zeta_A) + t9 * t9);
    const double t14 = A * t10;
    const double F_AOmega = 2.0 * (A * t13 * (t1 + t11 * t3 + 2.0 * t14) + A * t7 * t9 + I_ * (9.0 * d_3 * t3 + t1 +
        t12 + 4.0 * t14) + R * t7);
    const double t15 = A3 * Omega2;
    const double F_OmegaOmega = (-8.0 * A * Omega * h - 4.0 * I_ * (A * zeta - 1.5 * d_3 * t15) - 4.0 * (A * t1 +
        2.0 * A2 * t10 + t11 * t15) * (A * Omega * zeta + I_0 - 0.5 * t5)) / Omega;
    const double t16 = F_AA * F_OmegaOmega - F_AOmega * F_AOmega;
    out[0] = t16;
    out[1] = F_AA * t16;
}

/* The amplitude that the response tends to as Omega grows.
   Equation from (24). Domain: F_0 > 0. Operations: 10. Error / u (1 + kappa): measured 1.4. */
SF_KERNEL double dissipation_full_by_inertia(double F_0, double d)
{
    return 1.4142135623730951 * F_0 / sqrt(sqrt(4.0 * F_0 * F_0 * d * d + 1.0) + 1.0);
}

/* Both positive: no state above A, while |h| grows by steepest dA at most.
   Equation from (23), (24). Domain: A > 0. Operations: 10. Error / u (1 + kappa): proved -, 3.76; measured 0.85. */
SF_KERNEL void dissipation_structural_bound(double A, double F_0, double eta, double h, double steepest, double *out)
{
    const double t0 = A - F_0;
    const double t1 = A * eta;
    out[0] = -F_0 * fabs(h) + t0 * t1;
    out[1] = -F_0 * steepest + eta * t0 + t1;
}

/* What no amplitude exceeds.
   Equation from (23), (24). Domain: d > 0. Operations: 3. Error / u (1 + kappa): measured 1.2. */
SF_KERNEL double dissipation_quadratic_bound(double F_0, double d)
{
    return sqrt(F_0) / sqrt(d);
}

/* F and F_A/2; derivatives by A and by R of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 73. Error / u (1 + kappa): proved -, 1.01, 9.26,
   8.26, -, -; measured 0.83. */
SF_KERNEL void dissipation_folds_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 1.0 / Omega;
    const double t1 = 2.0 * zeta;
    const double t2 = 2.0 * A;
    const double Omega2 = Omega * Omega;
    const double t3 = A * A * Omega2 * d_3;
    const double t4 = t0 * (Omega * d * t2 + t1 + 3.0 * t3);
    const double t5 = R_A * t4;
    const double t6 = 1.0 / A;
    const double t7 = R_A * t6;
    const double t8 = 0.5 * I_A;
    const double t9 = A * Omega;
    const double t10 = 4.0 * d;
    const double t11 = t0 * (t1 + t10 * t9 + t2 * zeta_A + 9.0 * t3);
    const double t12 = 0.5 * I_;
    const double Omega3 = Omega * Omega2;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * I_A + R * R_A;
    out[2] = 2.0 * I_ * (I_A - 0.5 * t5);
    out[3] = I_ * t4 + 2.0 * R;
    out[4] = R * (h_AA - t7) + t12 * (12.0 * A * Omega3 * d_3 + 2.0 * I_0AA + 8.0 * Omega * zeta_A + Omega2 * t10
        - t11 * t7 + 4.0 * t9 * zeta_AA) + t8 * (2.0 * I_A - t5);
    out[5] = R * t6 + R_A + t11 * t12 * t6 + t4 * t8;
}

/* F and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 61. Error / u (1 + kappa): proved -, 6.01, 9.26, 8.26,
   -, -; measured 0.92. */
SF_KERNEL void dissipation_peaks_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = A * d;
    const double t1 = 1.0 / Omega;
    const double t2 = t1 * zeta;
    const double t3 = A * A * d_3;
    const double t4 = 2.0 * zeta;
    const double t5 = 2.0 * t0;
    const double t6 = Omega * Omega;
    const double t7 = 3.0 * t3;
    const double t8 = t1 * (Omega * t5 + t4 + t6 * t7);
    const double t9 = R_A * t8;
    const double t10 = I_ * t1;
    const double t11 = 0.25 * t10 * (-t4 / t6 + t7) / A;
    const double t12 = 0.25 * Omega * t7 + 0.5 * t2 + 0.25 * t5;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * (1.5 * Omega * t3 + t0 + t2) + R;
    out[2] = 2.0 * I_ * (I_A - 0.5 * t9);
    out[3] = I_ * t8 + 2.0 * R;
    out[4] = I_ * (3.0 * A * Omega * d_3 + d) - R_A * t11 + t10 * zeta_A + t12 * (2.0 * I_A - t9);
    out[5] = t11 + t12 * t8 + 1.0;
}

/* F_A/2 and F_AA/2; derivatives by A and by R of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 125. Error / u (1 + kappa): proved 1.01, 10.26,
   -, -, -, -; measured 0.71. */
SF_KERNEL void dissipation_cusps_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = Omega * zeta_A;
    const double t1 = 4.0 * t0;
    const double t2 = A * zeta_AA;
    const double t3 = Omega * t2;
    const double t4 = 2.0 * t3;
    const double Omega2 = Omega * Omega;
    const double t5 = Omega2 * d;
    const double t6 = 2.0 * t5;
    const double Omega3 = Omega * Omega2;
    const double t7 = Omega3 * d_3;
    const double t8 = A * t7;
    const double t9 = 6.0 * t8;
    const double t10 = 1.0 / A;
    const double t11 = R_A * t10;
    const double t12 = h_AA - t11;
    const double t13 = 1.0 / Omega;
    const double t14 = 2.0 * zeta;
    const double t15 = Omega * d;
    const double t16 = 2.0 * t15;
    const double t17 = A * A * Omega2 * d_3;
    const double t18 = t13 * (A * t16 + t14 + 3.0 * t17);
    const double t19 = I_A - 0.5 * R_A * t18;
    const double t20 = 2.0 * zeta_A;
    const double t21 = t13 * (4.0 * A * t15 + A * t20 + t14 + 9.0 * t17);
    const double t22 = 2.0 * I_0AA + 8.0 * t0 - t11 * t21 + 4.0 * t3 + 4.0 * t5 + 12.0 * t8;
    const double t23 = 0.5 * I_;
    const double t24 = 0.5 * t18;
    const double t25 = t10 * t21;
    const double t26 = 6.0 * I_;
    const double t27 = I_ * t13 * (9.0 * A * Omega2 * d_3 + t16 + t2 + t20);
    const double t28 = I_0AA + t1 + t4 + t6 + t9;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * I_0AA + I_ * t1 + I_ * t4 + I_ * t6 + I_ * t9 + I_A * I_A + R * h_AA + R_A * R_A;
    out[2] = I_A * t19 + R * t12 + t22 * t23;
    out[3] = I_A * t24 + R * t10 + R_A + t23 * t25;
    out[4] = 2.0 * A * I_ * Omega * zeta_AAA + I_ * I_0AAA + I_A * t22 + Omega * t26 * zeta_AA + R * h_AAA + 2.0 *
        R_A * t12 - t11 * t27 + t19 * t28 + t26 * t7;
    out[5] = I_A * t25 + h_AA + t10 * t27 + 2.0 * t11 + t24 * t28;
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 95. Error / u (1 + kappa): proved 1.01, 6.01, -, -, -,
   -; measured 0.67. */
SF_KERNEL void dissipation_isolas_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = A * d;
    const double t1 = 1.0 / Omega;
    const double t2 = t1 * zeta;
    const double t3 = A * A * d_3;
    const double t4 = 1.0 / A;
    const double t5 = R_A * t4;
    const double Omega2 = Omega * Omega;
    const double t6 = 2.0 * zeta;
    const double t7 = 2.0 * t0;
    const double t8 = 3.0 * t3;
    const double t9 = t1 * (Omega * t7 + Omega2 * t8 + t6);
    const double t10 = 2.0 * I_A - R_A * t9;
    const double t11 = 0.5 * I_A;
    const double t12 = 4.0 * Omega;
    const double t13 = A * d_3;
    const double t14 = t1 * (2.0 * A * zeta_A + 9.0 * Omega2 * t3 + t0 * t12 + t6);
    const double t15 = 0.5 * I_;
    const double t16 = I_ * t1;
    const double t17 = 0.25 * t16 * (t8 - t6 / Omega2);
    const double t18 = 0.25 * Omega * t8 + 0.5 * t2 + 0.25 * t7;
    const double Omega3 = Omega * Omega2;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * (1.5 * Omega * t3 + t0 + t2) + R;
    out[2] = R * (h_AA - t5) + t10 * t11 + t15 * (A * t12 * zeta_AA + 2.0 * I_0AA + 8.0 * Omega * zeta_A + 4.0 *
        Omega2 * d + 12.0 * Omega3 * t13 - t14 * t5);
    out[3] = R * t4 + R_A + t11 * t9 + t14 * t15 * t4;
    out[4] = I_ * (3.0 * Omega * t13 + d) + t10 * t18 + t16 * zeta_A - t17 * t5;
    out[5] = t17 * t4 + t18 * t9 + 1.0;
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 241. Error / u (1 + kappa): proved 1.01, -, -, -, -, -;
   measured 1.3. */
SF_KERNEL void dissipation_turns_by_R(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = R * R_A;
    const double t1 = A * R_A;
    const double t2 = 2.0 * I_ * d;
    const double A2 = A * A;
    const double t3 = I_A * d;
    const double t4 = 1.0 / Omega;
    const double t5 = I_ * t4;
    const double t6 = t5 * zeta;
    const double t7 = t5 * zeta_A;
    const double t8 = t4 * zeta;
    const double t9 = I_A * t8;
    const double t10 = A2 * d_3;
    const double t11 = I_ * Omega;
    const double t12 = 4.5 * t11;
    const double A3 = A * A2;
    const double t13 = A3 * d_3;
    const double t14 = I_A * Omega;
    const double t15 = 1.5 * t14;
    const double t16 = 1.0 / A;
    const double Omega2 = Omega * Omega;
    const double t17 = d_3 * t1;
    const double Omega3 = Omega * Omega2;
    const double t18 = t10 * t15;
    const double t19 = t16 * t6;
    const double t20 = A * t3;
    const double t21 = A * d_3;
    const double t22 = 4.0 * zeta_A;
    const double t23 = A * zeta;
    const double t24 = A2 * d;
    const double t25 = Omega * d;
    const double t26 = A2 * zeta;
    const double t27 = 2.0 * zeta_AA;
    const double t28 = A * t8;
    const double t29 = I_A * t4;
    const double t30 = 2.0 * zeta_A;
    const double t31 = d_3 * t26;
    const double t32 = 12.0 * t31;
    const double t33 = t13 * zeta_A;
    const double t34 = 3.0 * t33;
    const double t35 = 0.5 / Omega3;
    const double t36 = I_ * t35;
    const double t37 = t36 * zeta_A;
    const double t38 = I_A * t35 * zeta;
    const double t39 = A2 * d * d;
    const double t40 = 4.0 * t39;
    const double t41 = 2.0 / Omega2;
    const double t42 = t41 * zeta * zeta;
    const double t43 = 2.25 * t5;
    const double t44 = t41 * zeta_A;
    const double t45 = 6.0 * d;
    const double t46 = 15.0 * t13 * t25;
    const double t47 = 6.0 * Omega2;
    const double A4 = A2 * A2;
    const double t48 = A4 * d_3 * d_3;
    const double t49 = t16 * t36 * zeta;
    const double t50 = 0.75 * t10 * t29;
    const double t51 = t24 * t30 * t4;
    const double t52 = 13.5 * Omega2 * t48;
    const double Omega4 = Omega2 * Omega2;
    out[0] = I_ * I_A + t0;
    out[1] = A * t2 + A * t7 + A * t9 + A2 * t3 + R + t1 + t10 * t12 + t13 * t15 + t6;
    out[2] = 2.0 * A * I_ * Omega * zeta_AA + 6.0 * A * I_ * Omega3 * d_3 + I_ * I_0AA + 4.0 * I_ * Omega * zeta_A
        + 2.0 * I_ * Omega2 * d + I_A * I_A + R * h_AA - R_A * t18 - R_A * t19 - R_A * t2 - R_A * t7 - R_A * t9 - t0
        * t16 - t1 * t3 - t12 * t17;
    out[3] = R * t16 + R_A + t12 * t21 + t18 + t19 + t2 + t20 + t7 + t9;
    out[4] = A * h_AA + A * t29 * t30 + A * t5 * zeta_AA + A3 * t25 * t27 + 3.0 * A4 * Omega2 * d_3 * zeta_AA +
        1.5 * I_0AA * Omega * t13 + I_0AA * t24 + I_0AA * t28 + Omega * t22 * t24 + 2.0 * Omega2 * t39 + 9.0 *
        Omega3 * d * t13 + 9.0 * Omega4 * t48 - R_A * t32 - R_A * t34 + R_A * t37 + R_A * t38 - R_A * t40 - R_A *
        t42 - R_A * t46 + R_A * t49 - R_A * t50 - R_A * t51 - R_A * t52 - t1 * t44 * zeta - t1 * t45 * t8 + 9.0 *
        t10 * t14 + 9.0 * t11 * t21 - t17 * t43 + t2 + 4.0 * t20 + t22 * t23 + 2.0 * t23 * t25 + t26 * t27 + t31 *
        t47 + t33 * t47 + 2.0 * t7 + 2.0 * t9;
    out[5] = t21 * t43 + t23 * t44 + t28 * t45 + t32 + t34 - t37 - t38 + t40 + t42 + t46 - t49 + t50 + t51 + t52 +
        2.0;
}

/* F and F_A/2; derivatives by A and by Omega of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 59. Error / u (1 + kappa): proved -, 1.01, 1.01,
   7.26, 10.26, -; measured 0.5. */
SF_KERNEL void dissipation_folds_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = I_ * I_A + R * R_A;
    const double t1 = 2.0 * Omega;
    const double t2 = R * t1;
    const double t3 = 2.0 * zeta;
    const double t4 = A * t1;
    const double Omega2 = Omega * Omega;
    const double t5 = A * A * Omega2 * d_3;
    const double t6 = d * t4 + t3 + 3.0 * t5;
    const double t7 = 2.0 * A;
    const double t8 = 4.0 * Omega;
    const double Omega3 = Omega * Omega2;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = t0;
    out[2] = 2.0 * t0;
    out[3] = t7 * (I_ * t6 + t2);
    out[4] = I_ * (6.0 * A * Omega3 * d_3 + I_0AA + 2.0 * Omega2 * d + t4 * zeta_AA + t8 * zeta_A) + I_A * I_A + R
        * h_AA + R_A * R_A;
    out[5] = A * I_A * t6 + I_ * (A * d * t8 + t3 + 9.0 * t5 + t7 * zeta_A) + R_A * t4 + t2;
}

/* F and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 101. Error / u (1 + kappa): proved -, -, 1.01, 7.26, -,
   -; measured 0.68. */
SF_KERNEL void dissipation_peaks_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 1.0 / Omega;
    const double t1 = I_0 * t0;
    const double t2 = 3.0 * zeta;
    const double t3 = A * Omega;
    const double t4 = d * t3;
    const double t5 = I_0 * d + t4 * (t2 + t4) + 2.0 * zeta * zeta;
    const double t6 = 5.0 * d;
    const double t7 = 3.0 * d_3;
    const double t8 = t3 * (t3 * t7 + t6) + 8.0 * zeta;
    const double t9 = 3.0 * I_0 + t3 * t8;
    const double A2 = A * A;
    const double t10 = 0.5 * A2;
    const double t11 = d_3 * t10 * t9;
    const double t12 = 2.0 * zeta;
    const double t13 = 2.0 * t4;
    const double t14 = Omega * Omega;
    const double t15 = A2 * t7;
    const double t16 = 2.0 * A;
    const double A3 = A * A2;
    const double t17 = d_3 * t14;
    const double t18 = t13 + t2;
    const double t19 = d_3 * t3;
    const double t20 = t3 * (6.0 * t19 + t6) + t8;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = A * t5 + Omega * t11 + R + t1 * zeta;
    out[2] = 2.0 * (I_ * I_A + R * R_A);
    out[3] = t16 * (I_ * (t12 + t13 + t14 * t15) + 2.0 * Omega * R);
    out[4] = 0.5 * I_0A * (Omega * t15 + d * t16 + t0 * t12) + R_A + t10 * t17 * t20 + t18 * t4 + t19 * t9 + t5 +
        zeta_A * (A * (3.0 * t4 + 4.0 * zeta) + 4.0 * A3 * t17 + t1);
    out[5] = A2 * d * t18 + 0.5 * A3 * Omega * d_3 * t20 - I_0 * zeta / t14 + t11 + 2.0 * t3;
}

/* F_A/2 and F_AA/2; derivatives by A and by Omega of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 99. Error / u (1 + kappa): proved 1.01, 8.26,
   8.26, -, -, -; measured 1.2. */
SF_KERNEL void dissipation_cusps_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double Omega2 = Omega * Omega;
    const double t0 = 2.0 * d;
    const double t1 = Omega2 * t0;
    const double t2 = 4.0 * zeta_A;
    const double t3 = Omega * t2;
    const double t4 = 2.0 * A;
    const double t5 = Omega * t4;
    const double t6 = t5 * zeta_AA;
    const double t7 = A * d_3;
    const double Omega3 = Omega * Omega2;
    const double t8 = 6.0 * Omega3;
    const double t9 = t7 * t8;
    const double t10 = I_A * I_A + R * h_AA + R_A * R_A;
    const double t11 = I_0AA + t1 + t3 + t6 + t9;
    const double t12 = 2.0 * zeta;
    const double t13 = A * A * Omega2 * d_3;
    const double t14 = A * (A * Omega * t0 + t12 + 3.0 * t13);
    const double t15 = 4.0 * Omega;
    const double t16 = d * t15;
    const double t17 = A * t16 + t12 + 9.0 * t13 + t4 * zeta_A;
    const double t18 = I_ * zeta_AA;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * I_0AA + I_ * t1 + I_ * t3 + I_ * t6 + I_ * t9 + t10;
    out[2] = I_ * t11 + t10;
    out[3] = I_ * t17 + I_A * t14 + 2.0 * Omega * R + R_A * t5;
    out[4] = I_ * I_0AAA + I_ * d_3 * t8 + I_ * t5 * zeta_AAA + 3.0 * I_A * t11 + 6.0 * Omega * t18 + R * h_AAA +
        3.0 * R_A * h_AA;
    out[5] = 18.0 * I_ * Omega2 * t7 + I_ * t16 + I_ * t2 + 2.0 * I_A * t17 + R_A * t15 + h_AA * t5 + t11 * t14 +
        t18 * t4;
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 125. Error / u (1 + kappa): proved 1.01, -, 10.26, -,
   -, -; measured 0.49. */
SF_KERNEL void dissipation_isolas_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 1.0 / Omega;
    const double t1 = I_0 * t0;
    const double t2 = 3.0 * zeta;
    const double t3 = A * Omega;
    const double t4 = d * t3;
    const double t5 = I_0 * d + t4 * (t2 + t4) + 2.0 * zeta * zeta;
    const double A2 = A * A;
    const double t6 = A2 * Omega;
    const double t7 = 5.0 * d;
    const double t8 = 3.0 * d_3;
    const double t9 = t3 * (t3 * t8 + t7) + 8.0 * zeta;
    const double t10 = d_3 * (3.0 * I_0 + t3 * t9);
    const double t11 = 0.5 * t10;
    const double t12 = 2.0 * t3;
    const double Omega2 = Omega * Omega;
    const double t13 = 2.0 * d;
    const double t14 = 6.0 * d_3;
    const double t15 = 2.0 * zeta;
    const double t16 = 2.0 * t4;
    const double t17 = A2 * Omega2;
    const double t18 = d_3 * t17;
    const double A3 = A * A2;
    const double t19 = A3 * d_3;
    const double t20 = t16 + t2;
    const double t21 = 0.5 * t3 * (t14 * t3 + t7) + 0.5 * t9;
    const double Omega3 = Omega * Omega2;
    out[0] = I_ * I_A + R * R_A;
    out[1] = A * t5 + R + t1 * zeta + t11 * t6;
    out[2] = I_ * (A * Omega3 * t14 + I_0AA + 4.0 * Omega * zeta_A + Omega2 * t13 + t12 * zeta_AA) + I_A * I_A + R
        * h_AA + R_A * R_A;
    out[3] = A * I_A * (t15 + t16 + t17 * t8) + I_ * (2.0 * A * zeta_A + t15 + 9.0 * t18 + 4.0 * t4) + 2.0 * Omega
        * R + R_A * t12;
    out[4] = 0.5 * I_0A * (A * t13 + t0 * t15 + t6 * t8) + R_A + t10 * t3 + t18 * t21 + t20 * t4 + t5 + zeta_A *
        (A * (3.0 * t4 + 4.0 * zeta) + 4.0 * Omega2 * t19 + t1);
    out[5] = A2 * d * t20 + A2 * t11 - I_0 * zeta / Omega2 + Omega * t19 * t21 + t12;
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 203. Error / u (1 + kappa): proved 1.01, -, 10.26, -,
   -, -; measured 1.3. */
SF_KERNEL void dissipation_turns_by_Omega(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = A * R_A;
    const double t1 = 2.0 * I_;
    const double t2 = d * t1;
    const double A2 = A * A;
    const double t3 = A2 * d;
    const double t4 = I_A * t3;
    const double t5 = 1.0 / Omega;
    const double t6 = I_ * zeta;
    const double t7 = A * t5;
    const double t8 = I_ * zeta_A;
    const double t9 = I_A * zeta;
    const double t10 = I_ * d_3;
    const double t11 = A2 * t10;
    const double t12 = 4.5 * t11;
    const double t13 = 1.5 * I_A;
    const double A3 = A * A2;
    const double t14 = A3 * Omega;
    const double t15 = d_3 * t14;
    const double t16 = 4.0 * Omega;
    const double t17 = I_ * zeta_AA;
    const double t18 = 2.0 * Omega;
    const double t19 = A * t18;
    const double Omega2 = Omega * Omega;
    const double Omega3 = Omega * Omega2;
    const double t20 = A * t10;
    const double t21 = t1 * zeta_A;
    const double t22 = 2.0 * t9;
    const double t23 = A * t16;
    const double t24 = A3 * d_3;
    const double t25 = 3.0 * Omega2;
    const double t26 = 4.0 * A;
    const double t27 = zeta * zeta_A;
    const double t28 = 9.0 * Omega;
    const double t29 = 2.0 * A2;
    const double t30 = A2 * d_3;
    const double t31 = A3 * d;
    const double t32 = 6.0 * Omega2;
    const double A4 = A2 * A2;
    const double t33 = A4 * d_3;
    const double t34 = d * d;
    const double t35 = d_3 * d_3;
    const double t36 = 1.0 / Omega2;
    const double t37 = A * t36;
    const double Omega4 = Omega2 * Omega2;
    const double A5 = A * A4;
    out[0] = I_ * I_A + R * R_A;
    out[1] = A * t2 + Omega * t12 + R + t0 + t13 * t15 + t4 + t5 * t6 + t7 * t8 + t7 * t9;
    out[2] = I_ * I_0AA + I_A * I_A + Omega2 * t2 + 6.0 * Omega3 * t20 + R * h_AA + R_A * R_A + t16 * t8 + t17 *
        t19;
    out[3] = A * t21 + A * t22 + I_ * d * t23 + I_A * t24 * t25 + 9.0 * Omega2 * t11 + R * t18 + t0 * t18 + t18 *
        t4 + 2.0 * t6;
    out[4] = A * h_AA + 9.0 * A4 * Omega4 * t35 + 1.5 * I_0AA * t15 + I_0AA * t3 + I_0AA * t7 * zeta + I_A * d *
        t26 + I_A * t28 * t30 + 2.0 * I_A * t7 * zeta_A + Omega2 * t29 * t34 + 9.0 * Omega3 * d_3 * t31 + 2.0 * R_A
        + d * t19 * zeta + t16 * t3 * zeta_A + t17 * t7 + t18 * t31 * zeta_AA + t2 + t20 * t28 + t21 * t5 + t22 * t5
        + t24 * t32 * zeta_A + t25 * t33 * zeta_AA + t26 * t27 + t29 * zeta * zeta_AA + t30 * t32 * zeta;
    out[5] = 4.0 * A2 * t27 * t5 + 27.0 * A5 * Omega3 * t35 + 6.0 * Omega * t33 * zeta_A + 30.0 * Omega2 * d * t33
        + t12 + t13 * t24 + 8.0 * t14 * t34 + 24.0 * t15 * zeta + t23 + 12.0 * t3 * zeta + 4.0 * t31 * zeta_A - t36
        * t6 - t37 * t8 - t37 * t9 + 4.0 * t7 * zeta * zeta;
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 54. Error / u (1 + kappa): proved -, 1.01, 4.01,
   3.51, 24.51, 12.34; measured 0.7. */
SF_KERNEL void dissipation_folds_far_by_R(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 1.0 / h;
    const double t1 = t0 / x;
    const double t2 = t1 * (A * zeta + I_0 * x);
    const double t3 = I_A - R_A * t2;
    const double t4 = x * x;
    const double t5 = h_A * t0;
    const double t6 = t1 * (A * zeta_A + I_0A * x + zeta);
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * I_A + R * R_A;
    out[2] = 2.0 * I_ * t3;
    out[3] = 2.0 * (I_ * t2 + R);
    out[4] = I_ * (2.0 * A * x * zeta_AA + I_0AA * t4 - R_A * t6 + 2.0 * d + 4.0 * x * zeta_A) + I_A * t3 + R *
        (-R_A * t5 + h_AA * t4);
    out[5] = I_ * t6 + I_A * t2 + R * t5 + R_A;
}

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 56. Error / u (1 + kappa): proved -, 3.26, 4.51, 4.01,
   -, -; measured 0.97. */
SF_KERNEL void dissipation_peaks_far_by_R(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
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
    out[4] = t0 * (A * t7 * zeta_A + I_ * I_0A + R_A * t8 * t9 - h_A * t10 * t8 + t10 * t6 + t7 * zeta);
    out[5] = -I_ * t11 * t9 + t1 * t10 * t11 * t4 + 1.0;
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 99. Error / u (1 + kappa): proved 1.01, 8.01,
   21.51, 12.34, -, -; measured 0.63. */
SF_KERNEL void dissipation_cusps_far_by_R(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 2.0 * d;
    const double t1 = 4.0 * x * zeta_A;
    const double t2 = x * x;
    const double t3 = I_0AA * t2;
    const double t4 = h_AA * t2;
    const double t5 = 2.0 * I_;
    const double t6 = A * zeta_AA;
    const double t7 = t6 * x;
    const double t8 = 1.0 / h;
    const double t9 = h_A * t8;
    const double t10 = R_A * t9;
    const double t11 = h_AA * t2 - t10;
    const double t12 = A * zeta + I_0 * x;
    const double t13 = t8 / x;
    const double t14 = R_A * t13;
    const double t15 = I_A - t12 * t14;
    const double t16 = A * zeta_A + I_0A * x + zeta;
    const double t17 = t0 + t1 + t3 + 2.0 * t7;
    const double t18 = -t14 * t16 + t17;
    const double t19 = t12 * t13;
    const double t20 = t13 * t16;
    const double t21 = I_ * x;
    const double t22 = t13 * (I_ * t6 + I_0AA * t21 + R * h_AA * x + t5 * zeta_A);
    const double t23 = 2.0 * I_A;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * t0 + I_ * t1 + I_ * t3 + I_A * I_A + R * t4 + R_A * R_A + t5 * t7;
    out[2] = I_ * t18 + I_A * t15 + R * t11;
    out[3] = I_ * t20 + I_A * t19 + R * t9 + R_A;
    out[4] = A * t5 * x * zeta_AAA + I_ * I_0AAA * t2 + R * h_AAA * t2 + 2.0 * R_A * t11 - R_A * t22 + t15 * t17 +
        t18 * t23 + 6.0 * t21 * zeta_AA;
    out[5] = 2.0 * t10 + t17 * t19 + t20 * t23 + t22 + t4;
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 80. Error / u (1 + kappa): proved 1.01, 3.26, 25.84,
   13.67, -, -; measured 0.46. */
SF_KERNEL void dissipation_isolas_far_by_R(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
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
    const double t9 = A * zeta_A;
    const double t10 = t0 * (I_0A * x + t9 + zeta);
    const double t11 = I_ * t1;
    const double x3 = x * x2;
    const double t12 = 0.5 * I_ * t2 / x3;
    const double t13 = I_0 + t3;
    const double t14 = 1.0 / (h * h);
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * (I_0 * t0 + t0 * t3) + R;
    out[2] = I_ * (2.0 * A * x * zeta_AA + I_0AA * x2 + 2.0 * d - t10 * t5 + 4.0 * x * zeta_A) + I_A * t8 + R *
        (-R_A * t4 + h_AA * x2);
    out[3] = I_A * t1 * t7 + R * t4 + R_A + t10 * t11;
    out[4] = t0 * (I_ * I_0A - I_ * t13 * t4 + R_A * t0 * t12 + t11 * t9 + t11 * zeta + t13 * t8);
    out[5] = t1 * t13 * t14 * t6 - t12 * t14 + 1.0;
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 49. Error / u (1 + kappa): proved -, 1.01, 1.01,
   2.01, 8.01, 8.34; measured 0.5. */
SF_KERNEL void dissipation_folds_far_by_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = I_ * I_A + R * R_A;
    const double t1 = R * x;
    const double t2 = A * zeta + I_0 * x;
    const double t3 = x * x;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = t0;
    out[2] = 2.0 * t0;
    out[3] = 4.0 * (I_ * t2 + h * t1);
    out[4] = I_ * (2.0 * A * x * zeta_AA + I_0AA * t3 + 2.0 * d + 4.0 * x * zeta_A) + I_A * I_A + R * h_AA * t3 +
        R_A * R_A;
    out[5] = 2.0 * (I_ * (A * zeta_A + I_0A * x + zeta) + I_A * t2 + R_A * h * x + h_A * t1);
}

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 59. Error / u (1 + kappa): proved -, 7.01, 1.01, 2.01,
   -, 8.51; measured 0.55. */
SF_KERNEL void dissipation_peaks_far_by_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = R * h;
    const double t1 = A * zeta;
    const double t2 = 2.0 * t1;
    const double t3 = I_0 * x;
    const double t4 = A * A;
    const double t5 = d / x;
    const double t6 = t3 + t4 * t5;
    const double t7 = t2 + t6;
    const double t8 = t1 + t3;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = I_ * I_0 + t0 + t1 * t7;
    out[2] = 2.0 * (I_ * I_A + R * R_A);
    out[3] = 4.0 * (I_ * t8 + t0 * x);
    out[4] = A * zeta_A * (4.0 * t1 + t6) + I_0 * I_A + I_0A * (I_ + t1 * x) + R * h_A + R_A * h + t2 * (A * t5 +
        zeta) + t7 * zeta;
    out[5] = 2.0 * I_0 * t8 + 2.0 * h * h * x + t1 * (I_0 - d * t4 / (x * x));
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. Operations: 87. Error / u (1 + kappa): proved 1.01, 6.01,
   6.01, 8.34, 13.41, -; measured 0.58. */
SF_KERNEL void dissipation_cusps_far_by_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = 2.0 * d;
    const double x2 = x * x;
    const double t1 = I_0AA * x2;
    const double t2 = 4.0 * x * zeta_A;
    const double t3 = 2.0 * I_;
    const double t4 = A * zeta_AA;
    const double t5 = t4 * x;
    const double t6 = R * x2;
    const double t7 = I_A * I_A + R_A * R_A + h_AA * t6;
    const double t8 = t0 + t1 + t2 + 2.0 * t5;
    const double t9 = R * x;
    const double t10 = R_A * x;
    const double t11 = A * zeta + I_0 * x;
    const double t12 = A * zeta_A + I_0A * x + zeta;
    const double t13 = I_ * x;
    const double x3 = x * x2;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * t0 + I_ * t1 + I_ * t2 + t3 * t5 + t7;
    out[2] = I_ * t8 + t7;
    out[3] = 2.0 * (I_ * t12 + I_A * t11 + h * t10 + h_A * t9);
    out[4] = A * t3 * x * zeta_AAA + I_ * I_0AAA * x2 + 3.0 * I_A * t8 + 3.0 * R_A * h_AA * x2 + h_AAA * t6 + 6.0
        * t13 * zeta_AA;
    out[5] = 2.0 * (I_ * t4 + I_0AA * t13 + 2.0 * I_A * t12 + h * h_AA * x3 + 2.0 * h_A * t10 + h_AA * t9 + t11 *
        t8 + t3 * zeta_A);
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 77. Error / u (1 + kappa): proved 1.01, 7.01, 8.01,
   8.34, -, 8.51; measured 0.71. */
SF_KERNEL void dissipation_isolas_far_by_x(double x, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double R, double I_, double R_A, double I_A, double *out)
{
    const double t0 = A * zeta;
    const double t1 = 2.0 * t0;
    const double t2 = I_0 * x;
    const double t3 = A * A;
    const double t4 = d / x;
    const double t5 = t2 + t3 * t4;
    const double t6 = t1 + t5;
    const double t7 = x * x;
    const double t8 = 2.0 * x;
    const double t9 = R * h_A;
    const double t10 = R_A * h;
    const double t11 = t0 + t2;
    const double t12 = A * zeta_A;
    out[0] = I_ * I_A + R * R_A;
    out[1] = I_ * I_0 + R * h + t0 * t6;
    out[2] = I_ * (A * t8 * zeta_AA + I_0AA * t7 + 2.0 * d + 4.0 * x * zeta_A) + I_A * I_A + R * h_AA * t7 + R_A *
        R_A;
    out[3] = 2.0 * (I_ * (I_0A * x + t12 + zeta) + I_A * t11 + t10 * x + t9 * x);
    out[4] = I_0 * I_A + I_0A * (I_ + t0 * x) + t1 * (A * t4 + zeta) + t10 + t12 * (4.0 * t0 + t5) + t6 * zeta +
        t9;
    out[5] = 2.0 * I_0 * t11 + h * h * t8 + t0 * (I_0 - d * t3 / t7);
}

SF_FAMILY_END

#endif
