/* Structural and quadratic damping, and dry friction of what is attached.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/extensions/dissipation.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef DISSIPATION_H
#define DISSIPATION_H

#include <math.h>

#include "inline.h"

#include "arithmetic_doubles.h"
#define OF(name) dissipation_##name
#include "dissipation_generic.h"
#include "arithmetic_end.h"

/* The factor of A^2 Omega^2 in I of quadratic damping.
   Equation from (19). Domain: any. Operations: 1. Error / u (1 + kappa): measured 0.69. */
SF_KERNEL double dissipation_quadratic(double c_2) {
    return 0.84882636315677518 * c_2;
}

/* The factor of A^3 Omega^3 in I of cubic damping.
   Equation from (19). Domain: any. Operations: 1. Error / u (1 + kappa): proved 0.51. */
SF_KERNEL double dissipation_cubic(double c_3) {
    return 0.75 * c_3;
}

/* The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.
   Equation from (23). Domain: A > 0, d > 0. Operations: 3. Error / u (1 + kappa): proved 2.01. */
SF_KERNEL double dissipation_restoring(double A, double F_0, double d) {
    return F_0 + F_0 / (A * d);
}

/* What m, then eta, does to I_0, I_0A and I_0AA: friction acts throughout.
   Equation from (19). Domain: A > 0. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.0, 0.0, 0.0. */
SF_KERNEL void dissipation_rest_moves(double A, double *out) {
    for (int k = 0; k < 6; k++)
        out[k] = 0.0;
    out[0] = 1.0;
    out[3] = A;
    out[4] = 1.0;
}

/* What m, then eta, then u_cr does to them where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. Operations: 11. Error / u (1 + kappa): proved 0.81 at most. */
SF_KERNEL void dissipation_released_moves(double A, double m, double u_cr, double *out) {
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

/* What zeta_2 does to the first three of `viscous`.
   Equation from (19). Domain: A > 0. Operations: 3. Error / u (1 + kappa): proved 0.34, 0.0, 0.0. */
SF_KERNEL void dissipation_viscous_moves(double A, double *out) {
    out[0] = 0.25 * A * A;
    out[1] = 0.5 * A;
    out[2] = 0.5;
}

/* Zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 21. Error / u (1 + kappa): measured 0.51. */
SF_KERNEL double dissipation_F(double Omega, double A, double F_0, double I_0, double zeta, double d, double d_3, double h) {
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
SF_KERNEL double dissipation_F_A(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A) {
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
   Equation (24). Domain: Omega > 0, A > 0. Operations: 48. Error / u (1 + kappa): measured 1. */
SF_KERNEL double dissipation_F_AA(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double zeta_A, double zeta_AA, double d, double d_3, double h, double h_A, double h_AA) {
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
SF_KERNEL double dissipation_F_OmegaOmega(double Omega, double A, double I_0, double zeta, double d, double d_3, double h) {
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
SF_KERNEL double dissipation_F_AOmegaOmega(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A) {
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
SF_KERNEL double dissipation_Omega_A(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A) {
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
SF_KERNEL double dissipation_Omega_A_by_inertia(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A) {
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
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 98. Error / u (1 + kappa): measured 1.2. */
SF_KERNEL double dissipation_cusp_bend(double Omega, double A, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA) {
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
SF_KERNEL void dissipation_isola_bend(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double zeta_A, double zeta_AA, double d, double d_3, double h, double h_A, double h_AA, double *out) {
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

/* F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^6.
   Equation (24). Domain: A > 0. Operations: 34. Error / u (1 + kappa): proved 0.67, 0.51, 2.51, 2.51, 3.67, 0.76,
   0.78. */
SF_KERNEL void dissipation_response_polynomial(double A, double I_0, double zeta, double d, double d_3, double h, double *out) {
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
SF_KERNEL void dissipation_fold_polynomial(double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A, double *out) {
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
SF_KERNEL double dissipation_limit_envelope(double Omega, double F_0, double m, double zeta, double eta, double d) {
    const double t0 = 2.0 * Omega * zeta + eta;
    return (2.0 * F_0 - 2.0 * m) / (t0 + sqrt(-4.0 * Omega * Omega * d * (-F_0 + m) + t0 * t0));
}

/* F_A/2 by R, I and their slopes.
   Equation (30). Domain: Omega >= 0, A > 0. Operations: 3. Error / u (1 + kappa): proved 1.01. */
SF_KERNEL double dissipation_F_A_halved(double R, double R_A, double I_, double I_A) {
    return I_ * I_A + R * R_A;
}

/* F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.
   Equation (24). Domain: x >= 0, A > 0. Operations: 34. Error / u (1 + kappa): proved -, -, 0.67; measured 1.2. */
SF_KERNEL void dissipation_far_by_inertia(double x, double A, double F_0, double I_0, double zeta, double d, double h, double *out) {
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
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 102. Error / u (1 + kappa): measured 0.93. */
SF_KERNEL double dissipation_cusp_bend_by_inertia(double Omega, double A, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA) {
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
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 102. Error / u (1 + kappa): measured 1.8. */
SF_KERNEL void dissipation_isola_bend_by_inertia(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double zeta_A, double zeta_AA, double d, double d_3, double h, double h_A, double h_AA, double *out) {
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
SF_KERNEL double dissipation_full_by_inertia(double F_0, double d) {
    return 1.4142135623730951 * F_0 / sqrt(sqrt(4.0 * F_0 * F_0 * d * d + 1.0) + 1.0);
}

/* Both positive: no state above A, while |h| grows by steepest dA at most.
   Equation from (23), (24). Domain: A > 0. Operations: 10. Error / u (1 + kappa): proved -, 3.76; measured 0.86. */
SF_KERNEL void dissipation_structural_bound(double A, double F_0, double eta, double h, double steepest, double *out) {
    const double t0 = A - F_0;
    const double t1 = A * eta;
    out[0] = -F_0 * fabs(h) + t0 * t1;
    out[1] = -F_0 * steepest + eta * t0 + t1;
}

/* What no amplitude exceeds.
   Equation from (23), (24). Domain: d > 0. Operations: 3. Error / u (1 + kappa): measured 1.2. */
SF_KERNEL double dissipation_quadratic_bound(double F_0, double d) {
    return sqrt(F_0) / sqrt(d);
}

#endif
