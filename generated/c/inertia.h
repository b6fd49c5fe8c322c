/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/oscillator.py, derivations/averaging.py, derivations/slow_flow.py, derivations/inertia.py, derivations/gradients.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/emit/rounding.py).
   Others are measured: the worst error of all outputs that was found, by a search for it with A 0.01 to 1, F_0 0.03
   to 0.1, Omega 0.3 to 2, cubic up to 1 of either sign, fall 0.001 to 1, force 0.001 to 0.1, h 0.001 to 1 of either
   sign, h_A up to 2 of either sign, h_AA up to 5 of either sign, h_AAA up to 20 of either sign, holds 0.001 to 0.1,
   k 0.04 to 4, linear 0.0001 to 0.03, lost 0.001 to 0.5, m 0.001 to 0.03, other up to 1 of either sign, rest 0.001
   to 1, share up to 0.5 of either sign, x 0.5 to 3, zeta 0.004 to 0.1.
   u = 2^-53, kappa is the relative condition number of an output in all arguments. */

#ifndef INERTIA_H
#define INERTIA_H

#include <math.h>

/* what exported.c defines otherwise */
#ifndef SF_KERNEL
#define SF_KERNEL static inline
#endif

/* Amplitude of the force on the mass.
   Equation beside (3). Domain: Omega >= 0.
   Operations: 2 structured, 2 common subexpressions, 2 power chains
   Proved, error / u (1 + kappa): 0.51
 */
SF_KERNEL double inertia_force(double Omega, double F_0)
{
    return F_0 * Omega * Omega;
}

/* Its slopes by Omega, F_0.
   Equation beside (3). Domain: Omega >= 0.
   Operations: 3 structured, 3 common subexpressions, 3 power chains
   Proved, error / u (1 + kappa): 0.34, 0.34
 */
SF_KERNEL void inertia_force_slopes(double Omega, double F_0, double *out)
{
    out[0] = 2.0 * F_0 * Omega;
    out[1] = Omega * Omega;
}

/* The F_0 of a force at one frequency.
   Equation beside (3). Domain: Omega > 0.
   Operations: 2 structured, 2 common subexpressions, 2 power chains
   Proved, error / u (1 + kappa): 0.51
 */
SF_KERNEL double inertia_amplitude(double Omega, double force)
{
    return force / (Omega * Omega);
}

/* The Omega from which on the force exceeds what holds a mass at rest, 4 mu/pi on the average.
   Equation beside (3). Domain: F_0 > 0, holds >= 0.
   Operations: 2 structured, 2 common subexpressions, 2 power chains
   Measured, error / u (1 + kappa): 0.61
 */
SF_KERNEL double inertia_moves_from(double F_0, double holds)
{
    const double turn = holds / F_0;
    return sqrt(turn);
}

/* The amplitude F_0 of the excitation for which (Omega, A) is a steady state.
   Equation from (24). Domain: Omega > 0, A > 0.
   Operations: 13 structured, 12 common subexpressions, 12 power chains
   Measured, error / u (1 + kappa): 1.3
 */
SF_KERNEL double inertia_level(double Omega, double A, double m, double zeta, double h)
{
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double I_ = 2.0 * A * Omega * zeta + m;
    return sqrt(I_ * I_ + R * R) / t0;
}

/* Zero at a steady state.
   Equation from (24). Domain: Omega > 0, A > 0.
   Operations: 16 structured, 13 common subexpressions, 13 power chains
   Measured, error / u (1 + kappa): 0.81
 */
SF_KERNEL double inertia_F(double Omega, double A, double F_0, double m, double zeta, double h)
{
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double I_ = 2.0 * A * Omega * zeta + m;
    const double t1 = F_0 * t0;
    return R * R + (I_ - t1) * (I_ + t1);
}

/* Omega^5 times the derivative of level^2 by Omega.
   Equation from (24). Domain: Omega > 0, A > 0.
   Operations: 15 structured, 13 common subexpressions, 13 power chains
   Proved, error / u (1 + kappa): 5.26
 */
SF_KERNEL double inertia_level_slope(double Omega, double A, double m, double zeta, double h)
{
    const double R = A * Omega * Omega + h;
    const double t0 = A * Omega * zeta;
    const double I_ = m + 2.0 * t0;
    return -4.0 * I_ * (m + t0) - 4.0 * R * h;
}

/* dOmega/dA along the response.
   Equation from (24). Domain: Omega > 0, A > 0.
   Operations: 25 structured, 21 common subexpressions, 21 power chains
   Measured, error / u (1 + kappa): 1.1
 */
SF_KERNEL double inertia_Omega_A(double Omega, double A, double m, double zeta, double h, double h_A)
{
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = Omega * zeta;
    const double t2 = A * t1;
    const double I_ = m + 2.0 * t2;
    return -2.0 * Omega * (2.0 * I_ * t1 + R * (h_A + t0)) / (-4.0 * I_ * (m + t2) - 4.0 * R * h);
}

/* 1/Omega^2 below the low frequency of an amplitude, and above the high one, where it has that.
   Equation from (24). Domain: A > 0, where F has a root.
   Operations where falling: 36 structured, 31 common subexpressions, 30 power chains
   Operations where rising: 36 structured, 31 common subexpressions, 30 power chains
   Measured, error / u (1 + kappa): 1.1
 */
SF_KERNEL void inertia_outer_falling(double A, double F_0, double m, double zeta, double h, double *out)
{
    const double t0 = zeta * zeta;
    const double t1 = A * t0;
    const double falls = -A * (h + 2.0 * t1);
    const double t2 = m * m;
    const double square = h * h + t2;
    const double over = (A - F_0) * (A + F_0);
    const double A2 = A * A;
    const double A3 = A * A2;
    const double inner = -A2 * t2 + 4.0 * A3 * t0 * (h + t1) + F_0 * F_0 * square;
    const double spread = sqrt(0.5 * inner + 0.5 * fabs(inner));
    const double t3 = falls + spread;
    out[0] = t3 / square;
    out[1] = over / t3;
}

SF_KERNEL void inertia_outer_rising(double A, double F_0, double m, double zeta, double h, double *out)
{
    const double t0 = zeta * zeta;
    const double t1 = A * t0;
    const double falls = -A * (h + 2.0 * t1);
    const double t2 = m * m;
    const double square = h * h + t2;
    const double over = (A - F_0) * (A + F_0);
    const double A2 = A * A;
    const double A3 = A * A2;
    const double inner = -A2 * t2 + 4.0 * A3 * t0 * (h + t1) + F_0 * F_0 * square;
    const double spread = sqrt(0.5 * inner + 0.5 * fabs(inner));
    const double t3 = falls - spread;
    out[0] = over / t3;
    out[1] = t3 / square;
}

SF_KERNEL void inertia_outer(double A, double F_0, double m, double zeta, double h, double *out)
{
    if (2.0 * A * zeta * zeta + h <= 0.0) {
        inertia_outer_falling(A, F_0, m, zeta, h, out);
        return;
    }
    inertia_outer_rising(A, F_0, m, zeta, h, out);
}

/* What the least level of an amplitude follows from; it has one where the first, fall, is positive.
   Equation from (24). Domain: A > 0.
   Operations: 11 structured, 11 common subexpressions, 11 power chains
   Proved, error / u (1 + kappa): 1.61, 0.76, 0.67
 */
SF_KERNEL void inertia_terms(double A, double m, double zeta, double h, double *out)
{
    out[0] = -A * (2.0 * A * zeta * zeta + h);
    out[1] = 12.0 * A * m * zeta;
    out[2] = h * h + m * m;
}

/* x = 1/Omega where the level of an amplitude is least, by its `terms`.
   Equation from (24). Domain: fall > 0, linear >= 0, rest > 0.
   Operations: 8 structured, 8 common subexpressions, 8 power chains
   Measured, error / u (1 + kappa): 1.3
 */
SF_KERNEL double inertia_least(double fall, double linear, double rest)
{
    return 8.0 * fall / (linear + sqrt(64.0 * fall * rest + linear * linear));
}

/* dOmega/dA where the level of an amplitude is least: what a rounding of A does to Omega there.
   Equation from (24). Domain: x of `least`, h < 0.
   Operations: 28 structured, 24 common subexpressions, 24 power chains
   Measured, error / u (1 + kappa): 1.7
 */
SF_KERNEL double inertia_least_Omega_A(double x, double A, double m, double zeta, double h, double h_A)
{
    const double t0 = x * x;
    const double t1 = 3.0 * m * zeta;
    const double t2 = 2.0 * x;
    return (4.0 * A * zeta * zeta + h + h_A * (A + 2.0 * h * t0) + t1 * x) / (t0 * (A * t1 + h * h * t2 + m * m
        * t2));
}

/* The least level of an amplitude less F_0, and its slope along A.
   Equation from (24). Domain: x of `least`, h < 0.
   Operations: 23 structured, 19 common subexpressions, 19 power chains
   Measured, error / u (1 + kappa): 0.87
 */
SF_KERNEL void inertia_peak(double x, double A, double F_0, double m, double zeta, double h, double h_A, double *out)
{
    const double t0 = A * zeta;
    const double t1 = m * x;
    const double drag = t0 + t1;
    const double share = drag / h;
    const double t2 = x * x;
    const double root = sqrt(share * share + t2);
    out[0] = -F_0 + root * (2.0 * t0 + t1);
    out[1] = (-share * (h_A * t2 + 1.0) + 2.0 * t2 * zeta) / root;
}

/* Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A.
   Equation from (24), (30). Domain: x of `least`, h < 0.
   Operations: 73 structured, 50 common subexpressions, 50 power chains
   Measured, error / u (1 + kappa): 1.2
 */
SF_KERNEL void inertia_isola(double x, double A, double m, double zeta, double h, double h_A, double h_AA, double *out)
{
    const double t0 = A * zeta;
    const double t1 = m * x;
    const double t2 = t0 + t1;
    const double t3 = x * x;
    const double t4 = h * t3;
    const double t5 = 2.0 * zeta;
    const double t6 = h_A * t3;
    const double t7 = t6 + 1.0;
    const double t8 = 8.0 * x;
    const double t9 = 4.0 * h;
    out[0] = t2 * t7 - t4 * t5;
    out[1] = h_AA * t2 * t3 - t5 * t6 + t7 * zeta + (2.0 * h_A * t2 * x + m * t7 - t9 * x * zeta) * (16.0 * A *
        zeta * zeta - h_A * (-4.0 * A - 8.0 * t4) + 12.0 * t1 * zeta + t9) / (-h * h * t8 - m * m * t8 - 12.0 * m *
        t0);
}

/* The same without its slope by k = h - A h_A and cubic = 3 h - A h_A, small where h is like A^3.
   Equation from (24), (30). Domain: x of `least`, h < 0.
   Operations: 21 structured, 18 common subexpressions, 17 power chains
   Measured, error / u (1 + kappa): 1.1
 */
SF_KERNEL double inertia_isola_apart(double x, double A, double m, double zeta, double h, double k, double cubic)
{
    const double t0 = A * zeta;
    const double t1 = m * x;
    const double drag = t0 + t1;
    const double x2 = x * x;
    const double x3 = x * x2;
    return (-cubic * t0 * x2 + drag * drag * (-2.0 * t0 - t1) / h - k * m * x3) / A;
}

/* dR/dA at a fold by k = h - A h_A: of the two with F_A = 0 the larger, the other; -R/I with the first.
   Equation from (30). Domain: Omega > 0, A > 0, zeta > 0, k other than 0.
   Operations: 28 structured, 24 common subexpressions, 24 power chains
   Measured, error / u (1 + kappa): 1.1
 */
SF_KERNEL void inertia_fold_slopes(double Omega, double A, double m, double zeta, double k, double *out)
{
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
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 10 structured, 10 common subexpressions, 10 power chains
   Measured, error / u (1 + kappa): 0.91
 */
SF_KERNEL double inertia_fold_force(double Omega, double A, double m, double zeta, double other)
{
    const double I_ = 2.0 * A * Omega * zeta + m;
    return sqrt(A * A * other * other + I_ * I_);
}

/* The F_0 of a fold, by the one of `fold_slopes` that is not its own.
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 12 structured, 12 common subexpressions, 12 power chains
   Measured, error / u (1 + kappa): 0.73
 */
SF_KERNEL double inertia_fold_level(double Omega, double A, double m, double zeta, double other)
{
    const double I_ = 2.0 * A * Omega * zeta + m;
    return sqrt(A * A * other * other + I_ * I_) / (Omega * Omega);
}

/* -R/I where the level is least and R small beside A Omega^2.
   Equation from (24). Domain: Omega > 0, A > 0, zeta > 0.
   Operations: 29 structured, 24 common subexpressions, 22 power chains
   Measured, error / u (1 + kappa): 1.2
 */
SF_KERNEL double inertia_peak_share(double Omega, double A, double m, double zeta)
{
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
   Equation from (24). Domain: A > 0, F_0 > 0.
   Operations: 13 structured, 13 common subexpressions, 13 power chains
   Measured, error / u (1 + kappa): 1.2
 */
SF_KERNEL double inertia_Omega_of_share(double A, double F_0, double m, double zeta, double share)
{
    const double of_I = F_0 / sqrt(share * share + 1.0);
    return (A * zeta + sqrt(A * A * zeta * zeta + m * of_I)) / of_I;
}

/* Positive where the level rises with A along the fold locus, negative where it falls.
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 41 structured, 32 common subexpressions, 32 power chains
   Measured, error / u (1 + kappa): 1.3
 */
SF_KERNEL double inertia_level_rise(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA)
{
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = A * Omega;
    const double t2 = t1 * zeta;
    const double I_ = m + 2.0 * t2;
    const double t3 = h_A + t0;
    const double t4 = zeta * zeta;
    return 8.0 * (4.0 * I_ * (m + t2) + 4.0 * R * h) * (R * h_AA + 4.0 * t0 * t4 + t3 * t3) * (I_ * zeta + Omega
        * R + t1 * t3 + 2.0 * t1 * t4);
}

/* Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum.
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 37 structured, 30 common subexpressions, 30 power chains
   Measured, error / u (1 + kappa): 0.87
 */
SF_KERNEL double inertia_cusp_bend(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA, double h_AAA)
{
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
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 83 structured, 55 common subexpressions, 55 power chains
   Measured, error / u (1 + kappa): 1.7
 */
SF_KERNEL double inertia_hessian(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA)
{
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
   Equation from (24). Domain: A > 0, h < 0, lost <= 1/2.
   Operations: 34 structured, 21 common subexpressions, 20 power chains
   Proved, error / u (1 + kappa): 14.01, 14.01, 12.01, 10.01
 */
SF_KERNEL void inertia_bound(double A, double F_0, double zeta, double h, double h_A, double h_AA, double h_AAA, double lost, double *out)
{
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
   Equation from (24). Domain: h < 0.
   Operations: 3 structured, 3 common subexpressions, 3 power chains
   Proved, error / u (1 + kappa): 0.61
 */
SF_KERNEL double inertia_share(double A, double zeta, double h)
{
    const double twice = zeta * zeta;
    return -A * twice / h;
}

/* A_p, Omega_p, F_0_p of a steady state; with Omega = 0 a peak at rest; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 61 structured, 49 common subexpressions, 46 power chains
   Proved, error / u (1 + kappa): -, 0.0, 0.0, -, -, 0.0, 0.0
 */
SF_KERNEL void inertia_moves_of_state(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(end_p);
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * Omega;
    const double t2 = A * t1;
    const double t3 = m + t2 * zeta;
    const double t4 = t3 * zeta;
    const double F_A = 2.0 * (R * (Omega2 + h_A) + t1 * t4);
    const double Omega3 = Omega * Omega2;
    const double F_Omega = 4.0 * A * (Omega * R + t4) - 4.0 * F_0 * F_0 * Omega3;
    const double F_p = 2.0 * (R * h_p + t3 * (m_p + t2 * zeta_p));
    const double Omega4 = Omega2 * Omega2;
    out[0] = (2.0 * F_0 * Omega4 * forcing_p - F_Omega * frequency_p - F_p) / F_A;
    out[1] = frequency_p;
    out[2] = forcing_p;
    out[3] = F_A;
    out[4] = 4.0 * Omega * t3 * zeta + 2.0 * (Omega2 + fabs(h_A)) * (t0 + fabs(h));
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of a fold at a forcing; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 127 structured, 82 common subexpressions, 79 power chains
 */
SF_KERNEL void inertia_moves_of_fold(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h_AAA);
    (void)(h_AAp);
    (void)(end_p);
    (void)(frequency_p);
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = A * Omega;
    const double t2 = 2.0 * t1;
    const double t3 = m + t2 * zeta;
    const double t4 = Omega2 + h_A;
    const double t5 = zeta * zeta;
    const double t6 = Omega2 * t5;
    const double F_AA = 2.0 * (R * h_AA + t4 * t4 + 4.0 * t6);
    const double t7 = Omega * R + t3 * zeta;
    const double F_AOmega = 4.0 * (t1 * t4 + t2 * t5 + t7);
    const double Omega3 = Omega * Omega2;
    const double t8 = 4.0 * F_0 * F_0 * Omega3;
    const double t9 = 4.0 * A;
    const double F_Omega = t7 * t9 - t8;
    const double t10 = m_p + t2 * zeta_p;
    const double F_p = 2.0 * (R * h_p + t10 * t3);
    const double t11 = 2.0 * Omega;
    const double F_Ap = 2.0 * (R * h_Ap + h_p * t4 + t10 * t11 * zeta + t11 * t3 * zeta_p);
    const double t12 = 1.0 / F_Omega;
    const double Omega4 = Omega2 * Omega2;
    const double t13 = 2.0 * F_0 * Omega4 * forcing_p;
    const double t14 = t0 + fabs(h);
    const double t15 = Omega2 + fabs(h_A);
    out[0] = -t12 * (-F_AOmega * F_p + F_AOmega * t13 + F_Ap * F_Omega) / F_AA;
    out[1] = t12 * (-F_p + t13);
    out[2] = forcing_p;
    out[3] = F_AA;
    out[4] = 2.0 * t14 * fabs(h_AA) + 2.0 * t15 * t15 + 8.0 * t6;
    out[5] = F_Omega;
    out[6] = t8 + t9 * (Omega * t14 + t3 * zeta);
}

/* A_p, Omega_p, F_0_p of a fold at a forcing, on a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 63 structured, 46 common subexpressions, 43 power chains
   Proved, error / u (1 + kappa): 0.0, -, 0.0, 4.67, -, 0.0, 0.0
 */
SF_KERNEL void inertia_moves_of_corner_fold(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(frequency_p);
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * Omega;
    const double t2 = A * t1;
    const double t3 = m + t2 * zeta;
    const double t4 = t3 * zeta;
    const double F_A = 2.0 * (R * (Omega2 + h_A) + t1 * t4);
    const double Omega3 = Omega * Omega2;
    const double t5 = 4.0 * F_0 * F_0 * Omega3;
    const double t6 = 4.0 * A;
    const double F_Omega = -t5 + t6 * (Omega * R + t4);
    const double F_p = 2.0 * (R * h_p + t3 * (m_p + t2 * zeta_p));
    const double Omega4 = Omega2 * Omega2;
    out[0] = end_p;
    out[1] = (2.0 * F_0 * Omega4 * forcing_p - F_A * end_p - F_p) / F_Omega;
    out[2] = forcing_p;
    out[3] = F_Omega;
    out[4] = t5 + t6 * (Omega * (t0 + fabs(h)) + t3 * zeta);
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of a peak at a forcing; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 124 structured, 82 common subexpressions, 79 power chains
 */
SF_KERNEL void inertia_moves_of_peak(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(end_p);
    (void)(frequency_p);
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = A * Omega;
    const double t2 = 2.0 * t1;
    const double t3 = m + t2 * zeta;
    const double t4 = t3 * zeta;
    const double t5 = Omega2 + h_A;
    const double F_A = 2.0 * (2.0 * Omega * t4 + R * t5);
    const double t6 = 2.0 * zeta * zeta;
    const double F_AOmega = 4.0 * (Omega * R + t1 * t5 + t1 * t6 + t4);
    const double t7 = 12.0 * F_0 * F_0 * Omega2;
    const double t8 = A * t6;
    const double t9 = 4.0 * A;
    const double F_OmegaOmega = -t7 + t9 * (R + 2.0 * t0 + t8);
    const double t10 = m_p + t2 * zeta_p;
    const double F_p = 2.0 * (R * h_p + t10 * t3);
    const double F_Omegap = t9 * (Omega * h_p + t10 * zeta + t3 * zeta_p);
    const double t11 = 1.0 / F_A;
    const double t12 = F_0 * forcing_p;
    const double Omega4 = Omega2 * Omega2;
    const double t13 = 2.0 * Omega4 * t12;
    const double t14 = fabs(h);
    const double Omega3 = Omega * Omega2;
    out[0] = t11 * (-F_p + t13);
    out[1] = t11 * (-F_A * F_Omegap + 8.0 * F_A * Omega3 * t12 + F_AOmega * F_p - F_AOmega * t13) / F_OmegaOmega;
    out[2] = forcing_p;
    out[3] = F_A;
    out[4] = 4.0 * Omega * t3 * zeta + 2.0 * (Omega2 + fabs(h_A)) * (t0 + t14);
    out[5] = F_OmegaOmega;
    out[6] = t7 + t9 * (3.0 * t0 + t14 + t8);
}

/* A_p, Omega_p, F_0_p of where two folds meet; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 145 structured, 105 common subexpressions, 102 power chains
 */
SF_KERNEL void inertia_moves_of_cusp(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(end_p);
    (void)(forcing_p);
    (void)(frequency_p);
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = A * Omega;
    const double t2 = 2.0 * t1;
    const double t3 = m + t2 * zeta;
    const double t4 = Omega2 + h_A;
    const double F_AAA = 2.0 * (R * h_AAA + 3.0 * h_AA * t4);
    const double t5 = zeta * zeta;
    const double t6 = Omega * R + t3 * zeta;
    const double F_AOmega = 4.0 * (t1 * t4 + t2 * t5 + t6);
    const double t7 = 4.0 * Omega;
    const double F_AAOmega = t7 * (A * h_AA + 2.0 * Omega2 + 2.0 * h_A + 4.0 * t5);
    const double Omega3 = Omega * Omega2;
    const double F_Omega = 4.0 * A * t6 - 4.0 * F_0 * F_0 * Omega3;
    const double t8 = m_p + t2 * zeta_p;
    const double F_p = 2.0 * (R * h_p + t3 * t8);
    const double t9 = 2.0 * Omega;
    const double F_Ap = 2.0 * (R * h_Ap + h_p * t4 + t3 * t9 * zeta_p + t8 * t9 * zeta);
    const double F_AAp = 2.0 * (8.0 * Omega2 * zeta * zeta_p + R * h_AAp + h_AA * h_p + 2.0 * h_Ap * t4);
    const double t10 = 1.0 / F_AOmega;
    const double t11 = Omega2 + fabs(h_A);
    const double t12 = t0 + fabs(h);
    const double Omega4 = Omega2 * Omega2;
    out[0] = t10 * (F_AAOmega * F_Ap - F_AAp * F_AOmega) / F_AAA;
    out[1] = -F_Ap * t10;
    out[2] = 0.5 * t10 * (F_AOmega * F_p - F_Ap * F_Omega) / (F_0 * Omega4);
    out[3] = F_AAA;
    out[4] = 6.0 * t11 * fabs(h_AA) + 2.0 * t12 * fabs(h_AAA);
    out[5] = F_AOmega;
    out[6] = 4.0 * t1 * t11 + 8.0 * t1 * t5 + t12 * t7 + 4.0 * t3 * zeta;
}

/* A_p, Omega_p, F_0_p of where an isolated curve is born; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 181 structured, 113 common subexpressions, 111 power chains
 */
SF_KERNEL void inertia_moves_of_isola(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h_AAA);
    (void)(h_AAp);
    (void)(end_p);
    (void)(forcing_p);
    (void)(frequency_p);
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = A * Omega;
    const double t2 = 2.0 * t1;
    const double t3 = m + t2 * zeta;
    const double t4 = Omega2 + h_A;
    const double t5 = zeta * zeta;
    const double t6 = Omega2 * t5;
    const double F_AA = 2.0 * (R * h_AA + t4 * t4 + 4.0 * t6);
    const double t7 = 2.0 * t5;
    const double F_AOmega = 4.0 * (Omega * R + t1 * t4 + t1 * t7 + t3 * zeta);
    const double t8 = 12.0 * F_0 * F_0 * Omega2;
    const double t9 = A * t7;
    const double t10 = 4.0 * A;
    const double F_OmegaOmega = t10 * (R + 2.0 * t0 + t9) - t8;
    const double t11 = m_p + t2 * zeta_p;
    const double F_p = 2.0 * (R * h_p + t11 * t3);
    const double t12 = t3 * zeta_p;
    const double t13 = 2.0 * Omega;
    const double t14 = t11 * zeta;
    const double F_Ap = 2.0 * (R * h_Ap + h_p * t4 + t12 * t13 + t13 * t14);
    const double F_Omegap = t10 * (Omega * h_p + t12 + t14);
    const double t15 = 4.0 * F_p;
    const double t16 = F_Ap * Omega;
    const double t17 = F_AA * F_OmegaOmega - F_AOmega * F_AOmega;
    const double t18 = 1.0 / (Omega * t17);
    const double t19 = Omega2 + fabs(h_A);
    const double t20 = fabs(h);
    const double t21 = t0 + t20;
    const double Omega4 = Omega2 * Omega2;
    const double t22 = 4.0 * Omega * t21 + 4.0 * t1 * t19 + 8.0 * t1 * t5 + 4.0 * t3 * zeta;
    out[0] = t18 * (F_AOmega * F_Omegap * Omega - F_AOmega * t15 - F_OmegaOmega * t16);
    out[1] = -t18 * (F_AA * F_Omegap * Omega - F_AA * t15 - F_AOmega * t16);
    out[2] = 0.5 * F_p / (F_0 * Omega4);
    out[3] = t17;
    out[4] = t22 * t22 + (t10 * (3.0 * t0 + t20 + t9) + t8) * (2.0 * t19 * t19 + 2.0 * t21 * fabs(h_AA) + 8.0 *
        t6);
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of the least forcing on a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 98 structured, 69 common subexpressions, 67 power chains
   Proved, error / u (1 + kappa): 0.0, -, -, 3.56, -, 0.0, 0.0
 */
SF_KERNEL void inertia_moves_of_corner_top(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(forcing_p);
    (void)(frequency_p);
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = A * Omega;
    const double t2 = 2.0 * t1;
    const double I_ = m + t2 * zeta;
    const double t3 = I_ * zeta;
    const double t4 = Omega2 + h_A;
    const double F_A = 2.0 * (2.0 * Omega * t3 + R * t4);
    const double t5 = 2.0 * zeta * zeta;
    const double F_AOmega = 4.0 * (Omega * R + t1 * t4 + t1 * t5 + t3);
    const double t6 = 12.0 * F_0 * F_0 * Omega2;
    const double t7 = A * t5;
    const double t8 = 4.0 * A;
    const double F_OmegaOmega = -t6 + t8 * (R + 2.0 * t0 + t7);
    const double t9 = m_p + t2 * zeta_p;
    const double F_p = 2.0 * (I_ * t9 + R * h_p);
    const double F_Omegap = t8 * (I_ * zeta_p + Omega * h_p + t9 * zeta);
    const double t10 = F_A * end_p;
    const double Omega4 = Omega2 * Omega2;
    out[0] = end_p;
    out[1] = (-F_AOmega * Omega * end_p - F_Omegap * Omega + 4.0 * F_p + 4.0 * t10) / (F_OmegaOmega * Omega);
    out[2] = 0.5 * (F_p + t10) / (F_0 * Omega4);
    out[3] = F_OmegaOmega;
    out[4] = t6 + t8 * (3.0 * t0 + t7 + fabs(h));
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of where the fold locus meets a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 110 structured, 80 common subexpressions, 77 power chains
 */
SF_KERNEL void inertia_moves_of_corner_end(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h_AAA);
    (void)(h_AAp);
    (void)(forcing_p);
    (void)(frequency_p);
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = A * Omega;
    const double t2 = 2.0 * t1;
    const double t3 = m + t2 * zeta;
    const double t4 = Omega2 + h_A;
    const double t5 = zeta * zeta;
    const double F_AA = 2.0 * (4.0 * Omega2 * t5 + R * h_AA + t4 * t4);
    const double t6 = Omega * R + t3 * zeta;
    const double F_AOmega = 4.0 * (t1 * t4 + t2 * t5 + t6);
    const double Omega3 = Omega * Omega2;
    const double F_Omega = 4.0 * A * t6 - 4.0 * F_0 * F_0 * Omega3;
    const double t7 = m_p + t2 * zeta_p;
    const double F_p = 2.0 * (R * h_p + t3 * t7);
    const double t8 = 2.0 * Omega;
    const double F_Ap = 2.0 * (R * h_Ap + h_p * t4 + t3 * t8 * zeta_p + t7 * t8 * zeta);
    const double t9 = 1.0 / F_AOmega;
    const double t10 = F_AA * end_p;
    const double Omega4 = Omega2 * Omega2;
    out[0] = end_p;
    out[1] = -t9 * (F_Ap + t10);
    out[2] = -0.5 * t9 * (-F_AOmega * F_p + F_Ap * F_Omega + F_Omega * t10) / (F_0 * Omega4);
    out[3] = F_AOmega;
    out[4] = 4.0 * Omega * (t0 + fabs(h)) + 8.0 * t1 * t5 + 4.0 * t1 * (Omega2 + fabs(h_A)) + 4.0 * t3 * zeta;
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of where the backbone meets a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 47 structured, 39 common subexpressions, 36 power chains
   Proved, error / u (1 + kappa): 0.0, 4.34, -, 0.34, 0.34, 0.0, 0.0
 */
SF_KERNEL void inertia_moves_of_corner_backbone(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h);
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(forcing_p);
    (void)(frequency_p);
    const double t0 = 2.0 * A * Omega;
    const double I_ = m + t0 * zeta;
    const double t1 = 4.0 * I_ * zeta;
    const double F_A = Omega * t1;
    const double Omega2 = Omega * Omega;
    const double Omega3 = Omega * Omega2;
    const double F_Omega = A * t1 - 4.0 * F_0 * F_0 * Omega3;
    const double R_A = Omega2 + h_A;
    const double F_p = 2.0 * I_ * (m_p + t0 * zeta_p);
    const double t2 = 1.0 / t0;
    const double t3 = R_A * end_p;
    const double Omega4 = Omega2 * Omega2;
    out[0] = end_p;
    out[1] = -t2 * (h_p + t3);
    out[2] = 0.5 * t2 * (F_A * end_p * t0 - F_Omega * h_p - F_Omega * t3 + F_p * t0) / (F_0 * Omega4);
    out[3] = t0;
    out[4] = t0;
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of at Omega = 0 on a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 44 structured, 39 common subexpressions, 36 power chains
   Proved, error / u (1 + kappa): 0.0, 0.0, -, 0.0, 0.0, 0.0, 0.0
 */
SF_KERNEL void inertia_moves_of_corner_rest(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double m_p, double zeta_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(forcing_p);
    const double Omega2 = Omega * Omega;
    const double R = A * Omega2 + h;
    const double t0 = 2.0 * Omega;
    const double t1 = A * t0;
    const double I_ = m + t1 * zeta;
    const double t2 = I_ * zeta;
    const double F_A = 2.0 * (R * (Omega2 + h_A) + t0 * t2);
    const double Omega3 = Omega * Omega2;
    const double F_Omega = 4.0 * A * (Omega * R + t2) - 4.0 * F_0 * F_0 * Omega3;
    const double F_p = 2.0 * (I_ * (m_p + t1 * zeta_p) + R * h_p);
    const double Omega4 = Omega2 * Omega2;
    out[0] = end_p;
    out[1] = frequency_p;
    out[2] = 0.5 * (F_A * end_p + F_Omega * frequency_p + F_p) / (F_0 * Omega4);
    out[3] = 1.0;
    out[4] = 1.0;
    out[5] = 1.0;
    out[6] = 1.0;
}

/* F_A, F_Omega and R, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 66 structured, 37 common subexpressions, 36 power chains
 */
SF_KERNEL void inertia_beside(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double *out)
{
    const double Omega2 = Omega * Omega;
    const double t0 = A * Omega2;
    const double R = h + t0;
    const double t1 = 2.0 * Omega;
    const double t2 = A * t1 * zeta + m;
    const double t3 = t2 * zeta;
    const double F_A = 2.0 * (R * (Omega2 + h_A) + t1 * t3);
    const double Omega3 = Omega * Omega2;
    const double t4 = 4.0 * F_0 * F_0 * Omega3;
    const double t5 = 4.0 * A;
    const double F_Omega = -t4 + t5 * (Omega * R + t3);
    const double t6 = t2 * zeta;
    const double t7 = t0 + fabs(h);
    out[0] = F_A;
    out[1] = 4.0 * Omega * t6 + 2.0 * t7 * (Omega2 + fabs(h_A));
    out[2] = F_Omega;
    out[3] = t4 + t5 * (Omega * t7 + t6);
    out[4] = R;
    out[5] = t7;
}

/* d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 56 structured, 46 common subexpressions, 46 power chains
 */
SF_KERNEL void inertia_moves_of_phase(double Omega, double A, double F_0, double m, double zeta, double h, double h_A, double h_p, double m_p, double zeta_p, double A_p, double Omega_p, double F_0_p, double *out)
{
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = 2.0 * A * Omega;
    const double I_ = m + t1 * zeta;
    const double t2 = A_p * h_A + h_p;
    const double R_moved = A_p * t0 + Omega_p * t1 + t2;
    const double t3 = 2.0 * zeta;
    const double I_moved = A * Omega_p * t3 + A_p * Omega * t3 + m_p + t1 * zeta_p;
    const double t4 = 1.0 / F_0;
    const double t5 = hypot(h, I_);
    const double t6 = 1.0 / t5;
    out[0] = (-I_ * R_moved + I_moved * R) / (I_ * I_ + R * R);
    out[1] = t4 * (-F_0_p * t4 * t5 + I_ * I_moved * t6 + h * t2 * t6 - 2.0 * Omega_p * t5 / Omega) / t0;
}

#endif
