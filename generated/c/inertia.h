/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance.

   Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/paper/averaging.py,
   derivations/paper/slow_flow.py, derivations/extensions/inertia.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef INERTIA_H
#define INERTIA_H

#include <math.h>

#include "inline.h"

#include "arithmetic_doubles.h"
#define OF(name) inertia_##name
#include "inertia_generic.h"
#include "arithmetic_end.h"

/* Amplitude of the force on the mass.
   Equation beside (3). Domain: Omega >= 0. Operations: 2. Error / u (1 + kappa): proved 0.51. */
SF_KERNEL double inertia_force(double Omega, double F_0) {
    return F_0 * Omega * Omega;
}

/* Its slopes by Omega, F_0.
   Equation beside (3). Domain: Omega >= 0. Operations: 3. Error / u (1 + kappa): proved 0.34, 0.34. */
SF_KERNEL void inertia_force_slopes(double Omega, double F_0, double *out) {
    out[0] = 2.0 * F_0 * Omega;
    out[1] = Omega * Omega;
}

/* The F_0 of a force at one frequency.
   Equation beside (3). Domain: Omega > 0. Operations: 2. Error / u (1 + kappa): proved 0.51. */
SF_KERNEL double inertia_amplitude(double Omega, double force) {
    return force / (Omega * Omega);
}

/* The Omega from which on the force exceeds what holds a mass at rest, 4 mu/pi on the average.
   Equation beside (3). Domain: F_0 > 0, holds >= 0. Operations: 2. Error / u (1 + kappa): measured 0.61. */
SF_KERNEL double inertia_moves_from(double F_0, double holds) {
    const double turn = holds / F_0;
    return sqrt(turn);
}

/* Frequency of a state that transmits sqrt(1 - reduction) of what drives it, though it moves.
   Equation from (23). Domain: A > F_0 sqrt(reduction), 0 <= reduction < 1, h <= 0. Operations: 8. Error / u (1 +
   kappa): measured 0.78. */
SF_KERNEL double inertia_isolation(double A, double F_0, double reduction, double h) {
    const double removed = F_0 * sqrt(reduction);
    const double turn = -2.0 * h / (A - removed * removed / A);
    return sqrt(turn);
}

/* The amplitude F_0 of the excitation for which (Omega, A) is a steady state.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.3. */
SF_KERNEL double inertia_level(double Omega, double A, double m, double zeta, double h) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double I_ = 2.0 * A * Omega * zeta + m;
    return sqrt(I_ * I_ + R * R) / t0;
}

/* Zero at a steady state.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 13. Error / u (1 + kappa): measured 0.81. */
SF_KERNEL double inertia_F(double Omega, double A, double F_0, double m, double zeta, double h) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double I_ = 2.0 * A * Omega * zeta + m;
    const double t1 = F_0 * t0;
    return R * R + (I_ - t1) * (I_ + t1);
}

/* Omega^5 times the derivative of level^2 by Omega.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 13. Error / u (1 + kappa): proved 5.26. */
SF_KERNEL double inertia_level_slope(double Omega, double A, double m, double zeta, double h) {
    const double R = A * Omega * Omega + h;
    const double t0 = A * Omega * zeta;
    const double I_ = m + 2.0 * t0;
    return -4.0 * I_ * (m + t0) - 4.0 * R * h;
}

/* dOmega/dA along the response.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 21. Error / u (1 + kappa): measured 1.1. */
SF_KERNEL double inertia_Omega_A(double Omega, double A, double m, double zeta, double h, double h_A) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = Omega * zeta;
    const double t2 = A * t1;
    const double I_ = m + 2.0 * t2;
    return -2.0 * Omega * (2.0 * I_ * t1 + R * (h_A + t0)) / (-4.0 * I_ * (m + t2) - 4.0 * R * h);
}

/* x = 1/Omega where the level of an amplitude is least, by its `terms`.
   Equation from (24). Domain: fall > 0, linear >= 0, rest > 0. Operations: 8. Error / u (1 + kappa): measured 1.3. */
SF_KERNEL double inertia_least(double fall, double linear, double rest) {
    return 8.0 * fall / (linear + sqrt(64.0 * fall * rest + linear * linear));
}

/* dOmega/dA where the level of an amplitude is least: what a rounding of A does to Omega there.
   Equation from (24). Domain: x of `least`, h < 0. Operations: 24. Error / u (1 + kappa): measured 1.7. */
SF_KERNEL double inertia_least_Omega_A(double x, double A, double m, double zeta, double h, double h_A) {
    const double t0 = x * x;
    const double t1 = 3.0 * m * zeta;
    const double t2 = 2.0 * x;
    return (4.0 * A * zeta * zeta + h + h_A * (A + 2.0 * h * t0) + t1 * x) / (t0 * (A * t1 + h * h * t2 + m * m
        * t2));
}

/* dR/dA at a fold by k = h - A h_A: of the two with F_A = 0 the larger, the other; -R/I with the first.
   Equation from (30). Domain: Omega > 0, A > 0, zeta > 0, k other than 0. Operations: 24. Error / u (1 + kappa):
   measured 1.1. */
SF_KERNEL void inertia_fold_slopes(double Omega, double A, double m, double zeta, double k, double *out) {
    const double t0 = 2.0 * Omega * zeta;
    const double I_ = A * t0 + m;
    const double part = -8.0 * A * I_ * Omega * zeta / (k * k) + 1.0;
    const double root = sqrt(0.5 * part + 0.5 * fabs(part));
    const double t1 = 1.0 / A;
    const double steep = -0.5 * k * t1 * (root + 1.0);
    const double t2 = t0 / steep;
    out[0] = steep;
    out[1] = I_ * t1 * t2;
    out[2] = t2;
}

/* The F_0 of a force at a fold, by the one of `fold_slopes` that is not its own.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 10. Error / u (1 + kappa): measured 0.91. */
SF_KERNEL double inertia_fold_force(double Omega, double A, double m, double zeta, double other) {
    const double I_ = 2.0 * A * Omega * zeta + m;
    return sqrt(A * A * other * other + I_ * I_);
}

/* The F_0 of a fold, by the one of `fold_slopes` that is not its own.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 0.73. */
SF_KERNEL double inertia_fold_level(double Omega, double A, double m, double zeta, double other) {
    const double I_ = 2.0 * A * Omega * zeta + m;
    return sqrt(A * A * other * other + I_ * I_) / (Omega * Omega);
}

/* -R/I where the level is least and R small beside A Omega^2.
   Equation from (24). Domain: Omega > 0, A > 0, zeta > 0. Operations: 22. Error / u (1 + kappa): measured 1.2. */
SF_KERNEL double inertia_peak_share(double Omega, double A, double m, double zeta) {
    const double t0 = A * Omega * zeta;
    const double t1 = 2.0 * t0;
    const double I_ = m + t1;
    const double Omega2 = Omega * Omega;
    const double Omega4 = Omega2 * Omega2;
    const double part = A * A * Omega4 - 4.0 * I_ * (m + t0);
    const double root = sqrt(0.5 * part + 0.5 * fabs(part));
    return (-2.0 * m - t1) / (A * Omega2 + root);
}

/* Omega of a steady state with that -R/I.
   Equation from (24). Domain: A > 0, F_0 > 0. Operations: 13. Error / u (1 + kappa): measured 1.2. */
SF_KERNEL double inertia_Omega_of_share(double A, double F_0, double m, double zeta, double share) {
    const double of_I = F_0 / sqrt(share * share + 1.0);
    return (A * zeta + sqrt(A * A * zeta * zeta + m * of_I)) / of_I;
}

/* Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 30. Error / u (1 + kappa): measured 0.88. */
SF_KERNEL double inertia_cusp_bend(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA, double h_AAA) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = A * Omega;
    const double t2 = t1 * zeta;
    const double I_ = m + 2.0 * t2;
    const double t3 = h_A + t0;
    return 8.0 * (4.0 * I_ * (m + t2) + 4.0 * R * h) * (R * h_AAA + 3.0 * h_AA * t3) * (I_ * zeta + Omega * R +
        t1 * t3 + 2.0 * t1 * zeta * zeta);
}

/* At an isola point: negative where the level has a saddle in (A, Omega).
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 55. Error / u (1 + kappa): measured 1.7. */
SF_KERNEL double inertia_hessian(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = 2.0 * A;
    const double t2 = Omega * t1;
    const double I_ = m + t2 * zeta;
    const double t3 = h_A + t0;
    const double t4 = zeta * zeta;
    const double t5 = 4.0 * t4;
    const double t6 = t0 * t5 + t3 * t3;
    const double G_AOmega = A * Omega * t5 + t2 * t3;
    const double t7 = A * A;
    const double G_OmegaOmega = 4.0 * t0 * t7 + t5 * t7;
    const double t8 = R * h_AA;
    const double t9 = I_ * zeta;
    const double t10 = Omega * R;
    const double S_AOmega = 2.0 * t10 + 2.0 * t9;
    const double S_OmegaOmega = R * t1;
    const double t11 = 4.0 * S_OmegaOmega;
    const double t12 = -h_A + t0;
    return -24.0 * A * (t10 + t9) * (t6 + t8) / Omega - 8.0 * G_AOmega * S_AOmega + 4.0 * G_OmegaOmega * t8 -
        4.0 * S_AOmega * S_AOmega + t11 * t6 + t11 * t8 + 16.0 * t12 * t12 * t4 * t7;
}

/* Positive where no state has an amplitude A > F_0, if zeta^2 A <= lost |h|; three derivatives by A.
   Equation from (24). Domain: A > 0, h < 0, lost <= 1/2. Operations: 20. Error / u (1 + kappa): proved 14.01,
   14.01, 12.01, 10.01. */
SF_KERNEL void inertia_bound(double A, double F_0, double zeta, double h, double h_A, double h_AA, double h_AAA, double lost, double *out) {
    const double t0 = F_0 * F_0;
    const double t1 = zeta * zeta * (1.0 - lost);
    const double t2 = 24.0 * t1;
    const double A2 = A * A;
    const double A3 = A * A2;
    out[0] = 4.0 * A3 * t1 + h * t0;
    out[1] = 12.0 * A2 * t1 + h_A * t0;
    out[2] = A * t2 + h_AA * t0;
    out[3] = h_AAA * t0 + t2;
}

/* What zeta^2 A is of |h|: `lost` of the `bound`.
   Equation from (24). Domain: h < 0. Operations: 3. Error / u (1 + kappa): proved 0.61. */
SF_KERNEL double inertia_share(double A, double zeta, double h) {
    const double twice = zeta * zeta;
    return -A * twice / h;
}

#endif
