/* How answers move with the parameters: what the implicit function theorem asks for.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/extensions/dissipation.py, derivations/extensions/inertia.py, derivations/systems/gradients.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are those in floating point. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/codegen/rounding.py).
   Others are measured: the worst error of all outputs that was found, by a search for it with A 1e-09 to 1000, A_p
   1e-09 to 1000 of either sign or 0, F_0 1e-09 to 1000, F_0_p 1e-09 to 1000 of either sign or 0, I_0 1e-12 to 1 or
   0, I_0A 1e-09 to 1e+06 of either sign or 0, I_0AA 1e-09 to 1e+09 of either sign or 0, I_0AAA 1e-09 to 1e+12 of
   either sign or 0, I_0AAp 1e-09 to 1000 of either sign or 0, I_0Ap 1e-09 to 1000 of either sign or 0, I_0p 1e-09
   to 1000 of either sign or 0, Omega 0.001 to 1000, Omega_p 1e-09 to 1000 of either sign or 0, R 1e-09 to 1e+06 of
   either sign or 0, S_F 1e-09 to 1000 of either sign or 0, S_FOmega 1e-09 to 1000 of either sign or 0, S_Omega
   1e-09 to 1000 of either sign or 0, S_OmegaOmega 1e-09 to 1000 of either sign or 0, d 1e-12 to 1000 or 0, d_p
   1e-09 to 1000 of either sign or 0, end_p 1e-09 to 1000 of either sign or 0, force 1e-09 to 1000, force_F 1e-09 to
   1000 of either sign or 0, force_Omega 1e-09 to 1000 of either sign or 0, forcing_p 1e-09 to 1000 of either sign
   or 0, frequency_p 1e-09 to 1000 of either sign or 0, h 1e-12 to 1000 of either sign or 0, h_A 1e-09 to 1e+06 of
   either sign or 0, h_AA 1e-09 to 1e+09 of either sign or 0, h_AAA 1e-09 to 1e+12 of either sign or 0, h_AAp 1e-09
   to 1000 of either sign or 0, h_Ap 1e-09 to 1000 of either sign or 0, h_p 1e-09 to 1000 of either sign or 0, zeta
   1e-12 to 1 or 0, zeta_p 1e-09 to 1000 of either sign or 0.
   u = 2^-53, kappa is the relative condition number of an output in all arguments. */

#ifndef SENSITIVITIES_H
#define SENSITIVITIES_H

#include <math.h>

#include "inline.h"

SF_FAMILY_BEGIN

/* By A, Omega and F_0, of what vanishes by `conventions.SYSTEMS`; then the sizes of these.
   Equation from (23)-(34). Domain: Omega > 0, A > 0. Operations: 174.
   Measured, error / u (1 + kappa): 0.98 */
SF_KERNEL void sensitivities_slopes(double Omega, double A, double R, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double S_Omega, double S_OmegaOmega, double S_F, double S_FOmega, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = d * t0;
    const double t2 = 2.0 * Omega;
    const double t3 = t2 * zeta;
    const double t4 = A * A * t1 + A * t3;
    const double I_ = I_0 + t4;
    const double t5 = h_A + t0;
    const double t6 = A * t0;
    const double t7 = 2.0 * t6;
    const double t8 = d * t7;
    const double t9 = t3 + t8;
    const double t10 = I_0A + t9;
    const double t11 = Omega * R;
    const double t12 = A * Omega;
    const double t13 = d * t12 + zeta;
    const double t14 = 4.0 * A;
    const double t15 = 2.0 * t1;
    const double t16 = A * d;
    const double t17 = t16 * t2 + zeta;
    const double t18 = A * t13;
    const double t19 = 4.0 * (I_ * t17 + t10 * t18 + t11 + t12 * t5);
    const double t20 = 2.0 * t10;
    const double t21 = 2.0 * A * t13 * t13;
    const double t22 = A * t2;
    const double t23 = t0 + fabs(h_A);
    const double t24 = fabs(h);
    const double t25 = t24 + t6;
    const double t26 = 2.0 * t25;
    const double t27 = t9 + fabs(I_0A);
    const double t28 = t4 + fabs(I_0);
    const double t29 = 2.0 * t28;
    const double t30 = Omega * t25;
    const double t31 = fabs(h_AA);
    const double t32 = fabs(I_0AA);
    const double t33 = 4.0 * t28;
    const double t34 = 4.0 * t12;
    const double t35 = t13 * t14;
    const double t36 = t17 * t33 + t23 * t34 + t27 * t35 + 4.0 * t30;
    const double t37 = 8.0 * t27;
    const double t38 = 8.0 * Omega;
    for (int k = 0; k < 48; k++)
        out[k] = 0.0;
    out[0] = 2.0 * (I_ * t10 + R * t5);
    out[1] = -S_Omega + t14 * (I_ * t13 + t11);
    out[2] = -S_F;
    out[3] = 2.0 * (I_ * I_0AA + I_ * t15 + R * h_AA + t10 * t10 + t5 * t5);
    out[4] = t19;
    out[6] = 2.0 * (I_ * I_0AAA + I_0AA * t20 + R * h_AAA + 3.0 * h_AA * t5 + 4.0 * t1 * t10 + t10 * (I_0AA +
        t15));
    out[7] = 4.0 * (I_ * d * t2 + I_0AA * t18 + h_AA * t12 + t13 * t8 + t17 * t20 + t2 * t5);
    out[9] = t19;
    out[10] = -S_OmegaOmega + t14 * (I_ * t16 + R + t21 + t7);
    out[11] = -S_FOmega;
    out[12] = t5;
    out[13] = t22;
    out[17] = 1.0;
    out[19] = 1.0;
    out[21] = 1.0;
    out[24] = t23 * t26 + t27 * t29;
    out[25] = t14 * (t13 * t28 + t30) + fabs(S_Omega);
    out[26] = fabs(S_F);
    out[27] = t1 * t33 + 2.0 * t23 * t23 + t26 * t31 + 2.0 * t27 * t27 + t29 * t32;
    out[28] = t36;
    out[30] = t1 * t37 + 6.0 * t23 * t31 + t26 * fabs(h_AAA) + 4.0 * t27 * t32 + 2.0 * t27 * (t15 + t32) + t29 *
        fabs(I_0AAA);
    out[31] = 8.0 * d * t13 * t6 + d * t28 * t38 + t17 * t37 + t23 * t38 + t31 * t34 + t32 * t35;
    out[33] = t36;
    out[34] = t14 * (t16 * t28 + t21 + t24 + 3.0 * t6) + fabs(S_OmegaOmega);
    out[35] = fabs(S_FOmega);
    out[36] = t23;
    out[37] = t22;
    out[41] = 1.0;
    out[43] = 1.0;
    out[45] = 1.0;
}

/* What a parameter does to what vanishes, with the opposite sign.
   Equation from (23)-(34). Domain: Omega > 0, A > 0. Operations: 74.
   Proved, error / u (1 + kappa): -, -, -, -, 0.0, 0.0, 0.0, 0.0
   Measured, error / u (1 + kappa): 0.68 */
SF_KERNEL void sensitivities_right(double Omega, double A, double R, double I_0, double I_0A, double I_0AA, double zeta, double d, double h_A, double h_AA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double forcing_p, double frequency_p, double end_p, double *out)
{
    const double t0 = 2.0 * Omega;
    const double t1 = t0 * zeta;
    const double t2 = Omega * Omega;
    const double t3 = A * A * t2;
    const double I_ = A * t1 + I_0 + d * t3;
    const double t4 = A * t0 * zeta_p + I_0p + d_p * t3;
    const double t5 = I_ * zeta_p;
    const double t6 = h_A + t2;
    const double t7 = 2.0 * t2;
    const double t8 = d_p * t7;
    const double t9 = d * t7;
    const double t10 = A * t9 + I_0A + t1;
    const double t11 = 2.0 * t10;
    const double t12 = A * Omega;
    out[0] = -2.0 * (I_ * t4 + R * h_p);
    out[1] = -2.0 * (A * I_ * t8 + I_ * I_0Ap + R * h_Ap + h_p * t6 + t0 * t5 + t10 * t4);
    out[2] = -2.0 * (I_ * I_0AAp + I_0Ap * t11 + 4.0 * Omega * t10 * zeta_p + R * h_AAp + h_AA * h_p + 2.0 * h_Ap
        * t6 + t4 * (I_0AA + t9) + t8 * (A * t11 + I_));
    out[3] = -4.0 * A * (I_ * d_p * t12 + Omega * h_p + t4 * (d * t12 + zeta) + t5);
    out[4] = -h_p;
    out[5] = forcing_p;
    out[6] = frequency_p;
    out[7] = end_p;
}

/* d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p.
   Equation from (23)-(34). Domain: Omega > 0, A > 0. Operations: 60.
   Measured, error / u (1 + kappa): 0.63 */
SF_KERNEL void sensitivities_of_state(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A, double force, double force_Omega, double force_F, double h_p, double I_0p, double zeta_p, double d_p, double A_p, double Omega_p, double F_0_p, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega;
    const double t3 = A * t2;
    const double t4 = A * A;
    const double t5 = t0 * t4;
    const double I_ = I_0 + d * t5 + t3 * zeta;
    const double t6 = A_p * h_A + h_p;
    const double R_moved = A_p * t0 + Omega_p * t3 + t6;
    const double I_moved = 2.0 * A * Omega_p * zeta + A_p * I_0A + 2.0 * A_p * d * t1 + A_p * t2 * zeta + I_0p +
        Omega_p * d * t2 * t4 + d_p * t5 + t3 * zeta_p;
    const double t7 = 1.0 / force;
    const double t8 = hypot(h, I_);
    const double t9 = 1.0 / t8;
    out[0] = (-I_ * R_moved + I_moved * R) / (I_ * I_ + R * R);
    out[1] = t7 * (I_ * I_moved * t9 + h * t6 * t9 - t7 * t8 * (F_0_p * force_F + Omega_p * force_Omega));
}

/* Force, its slopes by Omega and F_0; of its square S_Omega, S_OmegaOmega, S_F, S_FOmega: a force.
   Equation (3). Domain: Omega >= 0. Operations: 1.
   Proved, error / u (1 + kappa): 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 */
SF_KERNEL void sensitivities_by_force(double Omega, double F_0, double *out)
{
    for (int k = 0; k < 7; k++)
        out[k] = 0.0;
    out[0] = F_0;
    out[2] = 1.0;
    out[5] = 2.0 * F_0;
}

/* Force, its slopes by Omega and F_0; of its square S_Omega, S_OmegaOmega, S_F, S_FOmega: an excitation by inertia.
   Equation beside (3). Domain: Omega >= 0. Operations: 14.
   Proved, error / u (1 + kappa): 0.51, 0.34, 0.34, 0.67, 0.81, 0.67, 0.61 */
SF_KERNEL void sensitivities_by_inertia(double Omega, double F_0, double *out)
{
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
