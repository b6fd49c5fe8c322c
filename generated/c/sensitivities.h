/* How answers move with the parameters: what the implicit function theorem asks for.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/extensions/dissipation.py, derivations/extensions/inertia.py, derivations/systems/gradients.py; never
   edit.

   What arguments and comments mean is in inline.h. */

#ifndef SENSITIVITIES_H
#define SENSITIVITIES_H

#include <math.h>

#include "inline.h"

SF_FAMILY_BEGIN

/* By A, Omega and F_0, of what vanishes by `conventions.SYSTEMS`; then the sizes of these.
   Equation from (23)-(34). Domain: Omega > 0, A > 0. Operations: 272. Error / u (1 + kappa): measured 1.1. */
SF_KERNEL void sensitivities_slopes(double Omega, double A, double R, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double zeta_A, double zeta_AA, double zeta_AAA, double d, double d_3, double h, double h_A, double h_AA, double h_AAA, double S_Omega, double S_OmegaOmega, double S_F, double S_FOmega, double *out) {
    const double Omega2 = Omega * Omega;
    const double A2 = A * A;
    const double t0 = A2 * Omega2;
    const double Omega3 = Omega * Omega2;
    const double t1 = Omega3 * d_3;
    const double t2 = 2.0 * zeta;
    const double t3 = Omega * t2;
    const double A3 = A * A2;
    const double t4 = A * t3 + A3 * t1 + d * t0;
    const double I_ = I_0 + t4;
    const double t5 = Omega2 + h_A;
    const double t6 = A * Omega2;
    const double t7 = 2.0 * A;
    const double t8 = t7 * zeta_A;
    const double t9 = 3.0 * A2 * t1 + Omega * t8 + 2.0 * d * t6 + t3;
    const double t10 = I_0A + t9;
    const double t11 = 2.0 * R;
    const double t12 = Omega * t11;
    const double t13 = Omega * d;
    const double t14 = 3.0 * d_3;
    const double t15 = t0 * t14 + t13 * t7 + t2;
    const double t16 = 2.0 * Omega;
    const double t17 = t16 * zeta_A;
    const double t18 = Omega * t7;
    const double t19 = t18 * zeta_AA;
    const double t20 = t13 + t14 * t6 + zeta_A;
    const double t21 = t16 * t20;
    const double t22 = 4.0 * A;
    const double t23 = 9.0 * d_3;
    const double t24 = t0 * t23 + t13 * t22 + t2;
    const double t25 = t24 + t8;
    const double t26 = A * t10;
    const double t27 = 2.0 * (I_ * t25 + t12 + t15 * t26 + t18 * t5);
    const double t28 = 4.0 * Omega;
    const double t29 = t10 * t28;
    const double t30 = I_ + t26;
    const double t31 = t28 * zeta_AA;
    const double t32 = t17 + t19 + t21;
    const double t33 = 2.0 * t13 + t23 * t6 + zeta_A;
    const double t34 = A * t15;
    const double t35 = Omega * t34;
    const double t36 = t7 * (A * Omega * t14 + d);
    const double t37 = A * t15 * t15;
    const double t38 = Omega2 + fabs(h_A);
    const double t39 = fabs(h);
    const double t40 = t39 + t6;
    const double t41 = 2.0 * t40;
    const double t42 = t9 + fabs(I_0A);
    const double t43 = t4 + fabs(I_0);
    const double t44 = 2.0 * t43;
    const double t45 = fabs(h_AA);
    const double t46 = fabs(I_0AA);
    const double t47 = t28 * t43;
    const double t48 = t31 * t43;
    const double t49 = A * t28;
    const double t50 = A * t42;
    const double t51 = 2.0 * t15 * t50 + t25 * t44 + t28 * t40 + t38 * t49;
    const double t52 = 8.0 * Omega;
    const double t53 = t42 * t52;
    const double t54 = 2.0 * t42;
    const double t55 = t43 + t50;
    for (int k = 0; k < 48; k++)
        out[k] = 0.0;
    out[0] = 2.0 * (I_ * t10 + R * t5);
    out[1] = -S_Omega + t7 * (I_ * t15 + t12);
    out[2] = -S_F;
    out[3] = 2.0 * (I_ * I_0AA + I_ * t17 + I_ * t19 + I_ * t21 + R * h_AA + t10 * t10 + t5 * t5);
    out[4] = t27;
    out[6] = 2.0 * (I_ * I_0AAA + 6.0 * I_ * t1 + I_ * t16 * zeta_AA + I_ * t18 * zeta_AAA + 2.0 * I_0AA * t10 + R
        * h_AAA + 3.0 * h_AA * t5 + t10 * (I_0AA + t32) + t20 * t29 + t29 * zeta_A + t30 * t31);
    out[7] = 2.0 * (2.0 * I_ * t33 + I_0AA * t34 + h_AA * t18 + t10 * t24 + t10 * t25 + t15 * t18 * t20 + t28 * t5
        + t7 * zeta_AA * (I_ + t35) + 2.0 * zeta_A * (t30 + t35));
    out[9] = t27;
    out[10] = -S_OmegaOmega + t7 * (I_ * t36 + t11 + t37 + 4.0 * t6);
    out[11] = -S_FOmega;
    out[12] = t5;
    out[13] = t18;
    out[17] = 1.0;
    out[19] = 1.0;
    out[21] = 1.0;
    out[24] = t38 * t41 + t42 * t44;
    out[25] = t7 * (t15 * t43 + t16 * t40) + fabs(S_Omega);
    out[26] = fabs(S_F);
    out[27] = A * t48 + t20 * t47 + 2.0 * t38 * t38 + t41 * t45 + 2.0 * t42 * t42 + t44 * t46 + t47 * zeta_A;
    out[28] = t51;
    out[30] = A * t47 * zeta_AAA + 12.0 * t1 * t43 + t20 * t53 + 6.0 * t38 * t45 + t41 * fabs(h_AAA) + 4.0 * t42 *
        t46 + t44 * fabs(I_0AAA) + t48 + t52 * t55 * zeta_AA + t53 * zeta_A + t54 * (t32 + t46);
    out[31] = t15 * t46 * t7 + 4.0 * t20 * t35 + t22 * zeta_AA * (t35 + t43) + t24 * t54 + t25 * t54 + 4.0 * t33 *
        t43 + t38 * t52 + t45 * t49 + 4.0 * zeta_A * (t35 + t55);
    out[33] = t51;
    out[34] = t7 * (t36 * t43 + t37 + 2.0 * t39 + 6.0 * t6) + fabs(S_OmegaOmega);
    out[35] = fabs(S_FOmega);
    out[36] = t38;
    out[37] = t18;
    out[41] = 1.0;
    out[43] = 1.0;
    out[45] = 1.0;
}

/* What a parameter does to what vanishes, with the opposite sign.
   Equation from (23)-(34). Domain: Omega > 0, A > 0. Operations: 120. Error / u (1 + kappa): proved -, -, -, -,
   0.0, 0.0, 0.0, 0.0; measured 0.67. */
SF_KERNEL void sensitivities_right(double Omega, double A, double R, double I_0, double I_0A, double I_0AA, double zeta, double zeta_A, double zeta_AA, double d, double d_3, double h_A, double h_AA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double zeta_Ap, double zeta_AAp, double d_p, double d_3p, double forcing_p, double frequency_p, double end_p, double *out) {
    const double t0 = 2.0 * zeta;
    const double t1 = Omega * t0;
    const double A2 = A * A;
    const double Omega2 = Omega * Omega;
    const double t2 = A2 * Omega2;
    const double Omega3 = Omega * Omega2;
    const double A3 = A * A2;
    const double t3 = A3 * Omega3;
    const double I_ = A * t1 + I_0 + d * t2 + d_3 * t3;
    const double t4 = 2.0 * Omega;
    const double t5 = A * t4;
    const double t6 = I_0p + d_3p * t3 + d_p * t2 + t5 * zeta_p;
    const double t7 = I_ * zeta_p;
    const double t8 = I_ * t5;
    const double t9 = Omega2 + h_A;
    const double t10 = 2.0 * A;
    const double t11 = Omega2 * t10;
    const double t12 = I_ * d_p;
    const double t13 = A2 * Omega3;
    const double t14 = 3.0 * I_ * d_3p;
    const double t15 = t4 * zeta_A;
    const double t16 = 3.0 * d_3;
    const double t17 = A * t15 + I_0A + d * t11 + t1 + t13 * t16;
    const double t18 = 4.0 * Omega;
    const double t19 = A * t17;
    const double t20 = I_ + t19;
    const double t21 = Omega * d;
    out[0] = -2.0 * (I_ * t6 + R * h_p);
    out[1] = -2.0 * (I_ * I_0Ap + R * h_Ap + h_p * t9 + t11 * t12 + t13 * t14 + t17 * t6 + t4 * t7 + t8 * zeta_Ap);
    out[2] = -2.0 * (6.0 * A * Omega3 * d_3p * t20 + I_ * I_0AAp + 2.0 * I_0Ap * t17 + 2.0 * Omega2 * d_p * (I_ +
        2.0 * t19) + R * h_AAp + h_AA * h_p + 2.0 * h_Ap * t9 + t17 * t18 * zeta_p + t18 * t20 * zeta_Ap + t6 *
        (I_0AA + t15 + t4 * (A * Omega2 * t16 + t21 + zeta_A) + t5 * zeta_AA) + t8 * zeta_AAp);
    out[3] = -t10 * (h_p * t4 + t12 * t5 + t14 * t2 + t6 * (t0 + t10 * t21 + t16 * t2) + 2.0 * t7);
    out[4] = -h_p;
    out[5] = forcing_p;
    out[6] = frequency_p;
    out[7] = end_p;
}

/* d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p.
   Equation from (23)-(34). Domain: Omega > 0, A > 0. Operations: 79. Error / u (1 + kappa): measured 0.67. */
SF_KERNEL void sensitivities_of_state(double Omega, double A, double I_0, double I_0A, double zeta, double zeta_A, double d, double d_3, double h, double h_A, double force, double force_Omega, double force_F, double h_p, double I_0p, double zeta_p, double d_p, double d_3p, double A_p, double Omega_p, double F_0_p, double *out) {
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * Omega;
    const double t2 = A * t1;
    const double A2 = A * A;
    const double t3 = A2 * Omega2;
    const double A3 = A * A2;
    const double Omega3 = Omega * Omega2;
    const double t4 = A3 * Omega3;
    const double I_ = I_0 + d * t3 + d_3 * t4 + t2 * zeta;
    const double t5 = A_p * h_A + h_p;
    const double R_moved = A_p * Omega2 + Omega_p * t2 + t5;
    const double t6 = 3.0 * d_3;
    const double I_moved = 2.0 * A * Omega_p * zeta + A2 * A_p * Omega3 * t6 + A2 * Omega_p * d * t1 + A3 * Omega2 *
        Omega_p * t6 + A_p * I_0A + 2.0 * A_p * d * t0 + A_p * t1 * zeta + A_p * t2 * zeta_A + I_0p + d_3p * t4 +
        d_p * t3 + t2 * zeta_p;
    const double t7 = 1.0 / force;
    const double t8 = hypot(h, I_);
    const double t9 = 1.0 / t8;
    out[0] = (-I_ * R_moved + I_moved * R) / (I_ * I_ + R * R);
    out[1] = t7 * (I_ * I_moved * t9 + h * t5 * t9 - t7 * t8 * (F_0_p * force_F + Omega_p * force_Omega));
}

/* Force, its slopes by Omega and F_0; of its square S_Omega, S_OmegaOmega, S_F, S_FOmega: a force.
   Equation (3). Domain: Omega >= 0. Operations: 1. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0. */
SF_KERNEL void sensitivities_by_force(double Omega, double F_0, double *out) {
    for (int k = 0; k < 7; k++)
        out[k] = 0.0;
    out[0] = F_0;
    out[2] = 1.0;
    out[5] = 2.0 * F_0;
}

/* Force, its slopes by Omega and F_0; of its square S_Omega, S_OmegaOmega, S_F, S_FOmega: an excitation by inertia.
   Equation beside (3). Domain: Omega >= 0. Operations: 14. Error / u (1 + kappa): proved 0.51, 0.34, 0.34, 0.67,
   0.81, 0.67, 0.61. */
SF_KERNEL void sensitivities_by_inertia(double Omega, double F_0, double *out) {
    const double Omega2 = Omega * Omega;
    const double t0 = 2.0 * F_0;
    const double t1 = F_0 * F_0;
    const double Omega3 = Omega * Omega2;
    const double Omega4 = Omega2 * Omega2;
    out[0] = F_0 * Omega2;
    out[1] = Omega * t0;
    out[2] = Omega2;
    out[3] = 4.0 * Omega3 * t1;
    out[4] = 12.0 * Omega2 * t1;
    out[5] = Omega4 * t0;
    out[6] = 8.0 * F_0 * Omega3;
}

SF_FAMILY_END

#endif
