/* Structural and quadratic damping, and dry friction of what is attached.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/dissipation.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/emit/rounding.py); others are measured (docs/stability.md). */

#ifndef DISSIPATION_H
#define DISSIPATION_H

#include <math.h>

/* Quadratic damping's factor of A^2 Omega^2 in I.
   Equation from (19). Domain: any.
   Operations: 1 structured, 1 common subexpressions, 1 power chains
 */
static inline double dissipation_quadratic(double c_2)
{
    return 0.84882636315677518 * c_2;
}

/* The largest |h| of a state with this amplitude, as quadratic damping bounds its frequency.
   Equation from (23). Domain: A > 0, d > 0.
   Operations: 3 structured, 3 common subexpressions, 3 power chains
   Proved, error / u (1 + kappa): 2.01
 */
static inline double dissipation_restoring(double A, double F_0, double d)
{
    return F_0 + F_0 / (A * d);
}

/* Friction and quadratic damping, both times the sign of u'; and the zeta of the slope of all by u'.
   Equation (3). Domain: any.
   Operations: 5 structured, 5 common subexpressions, 5 power chains
   Proved, error / u (1 + kappa): 1.01, 1.01
 */
static inline void dissipation_resistance(double v, double zeta, double friction, double quadratic, double *out)
{
    out[0] = friction + quadratic * v * v;
    out[1] = quadratic * v + zeta;
}

/* I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.
   Equation from (19). Domain: A > 0.
   Operations: 2 structured, 2 common subexpressions, 2 power chains
   Proved, error / u (1 + kappa): 1.01, 0.0, 0.0, 0.0
 */
static inline void dissipation_at_rest(double A, double m, double eta, double *out)
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
static inline void dissipation_released(double A, double m, double eta, double u_cr, double *out)
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
static inline double dissipation_I(double Omega, double A, double I_0, double zeta, double d)
{
    return A * A * Omega * Omega * d + 2.0 * A * Omega * zeta + I_0;
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0.
   Operations: 26 structured, 20 common subexpressions, 20 power chains
 */
static inline double dissipation_F_A(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
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
 */
static inline double dissipation_F_AA(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double d, double h, double h_A, double h_AA)
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

/* dF/dOmega.
   Equation (24). Domain: Omega > 0, A > 0.
   Operations: 20 structured, 18 common subexpressions, 18 power chains
 */
static inline double dissipation_F_Omega(double Omega, double A, double I_0, double zeta, double d, double h)
{
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = A * Omega;
    const double I_ = A * A * d * t0 + I_0 + 2.0 * t1 * zeta;
    return 4.0 * A * (I_ * (d * t1 + zeta) + Omega * R);
}

/* d2F/dOmega2.
   Equation (24). Domain: Omega > 0, A > 0.
   Operations: 28 structured, 23 common subexpressions, 23 power chains
 */
static inline double dissipation_F_OmegaOmega(double Omega, double A, double I_0, double zeta, double d, double h)
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

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0.
   Operations: 39 structured, 30 common subexpressions, 30 power chains
 */
static inline double dissipation_F_AOmega(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * Omega;
    const double t3 = 2.0 * zeta;
    const double I_ = A * A * d * t0 + I_0 + t2 * t3;
    const double t4 = d * t2;
    return 4.0 * (A * (t4 + zeta) * (I_0A + Omega * t3 + 2.0 * d * t1) + I_ * (2.0 * t4 + zeta) + Omega * R + t2
        * (h_A + t0));
}

/* d3F/dA dOmega2.
   Equation (24). Domain: Omega > 0, A > 0.
   Operations: 48 structured, 35 common subexpressions, 35 power chains
 */
static inline double dissipation_F_AOmegaOmega(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
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
   Equation from (24). Domain: Omega > 0, A > 0.
   Operations: 40 structured, 31 common subexpressions, 31 power chains
 */
static inline double dissipation_Omega_A(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
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

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0.
   Operations: 26 structured, 20 common subexpressions, 20 power chains
 */
static inline double dissipation_stability(double Omega, double A, double I_0, double I_0A, double zeta, double d, double h, double h_A)
{
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega * zeta;
    const double I_ = A * A * d * t0 + A * t2 + I_0;
    return (I_ * (I_0A + 2.0 * d * t1 + t2) + R * (h_A + t0)) / A;
}

/* F + F_0^2 as a polynomial in Omega: coefficients of 1, Omega, ..., Omega^4.
   Equation (24). Domain: A > 0.
   Operations: 28 structured, 26 common subexpressions, 23 power chains
   Proved, error / u (1 + kappa): 0.67, 0.51, 2.51, 0.67, 0.86
 */
static inline void dissipation_response_quartic(double A, double I_0, double zeta, double d, double h, double *out)
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
static inline void dissipation_fold_quartic(double A, double I_0, double I_0A, double zeta, double d, double h, double h_A, double *out)
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
   Equation (27). Domain: Omega > 0, F_0 > m, one of zeta, eta, d > 0.
   Operations: 19 structured, 16 common subexpressions, 16 power chains
 */
static inline double dissipation_limit_envelope(double Omega, double F_0, double m, double zeta, double eta, double d)
{
    const double t0 = 2.0 * Omega * zeta + eta;
    return (2.0 * F_0 - 2.0 * m) / (t0 + sqrt(-4.0 * Omega * Omega * d * (-F_0 + m) + t0 * t0));
}

/* D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D.
   Equation from (30). Domain: x >= 0, A > 0.
   Operations: 33 structured, 31 common subexpressions, 29 power chains
 */
static inline double dissipation_turn_share(double x, double A, double I_0, double I_0A, double zeta, double d)
{
    const double A2 = A * A;
    const double t0 = A2 * d;
    const double x2 = x * x;
    const double x3 = x * x2;
    const double A3 = A * A2;
    return 4.0 * A3 * d * d + 9.0 * t0 * x * zeta + x2 * (2.0 * A * I_0 * d + 4.0 * A * zeta * zeta + I_0A * t0)
        + x3 * (A * I_0A * zeta + I_0 * zeta);
}

/* F and F_A; derivatives by A and by Omega of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0.
   Operations: 91 structured, 47 common subexpressions, 47 power chains
   Proved, error / u (1 + kappa): -, 5.01, 5.01, 3.26, -, -
 */
static inline void dissipation_folds(double Omega, double A, double F_0, double I_0A, double I_0AA, double zeta, double d, double h_A, double h_AA, double R, double I_, double *out)
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

/* F and F_Omega/(4 A Omega); derivatives by A and by Omega of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0.
   Operations: 88 structured, 54 common subexpressions, 54 power chains
   Proved, error / u (1 + kappa): -, -, 5.01, 3.26, -, 10.51
 */
static inline void dissipation_peaks(double Omega, double A, double F_0, double I_0, double I_0A, double zeta, double d, double h_A, double R, double I_, double *out)
{
    const double t0 = zeta / Omega;
    const double t1 = 3.0 * zeta;
    const double t2 = A * d;
    const double t3 = Omega * t2;
    const double t4 = I_0 * d + t3 * (t1 + t3) + 2.0 * zeta * zeta;
    const double t5 = Omega * Omega;
    const double t6 = h_A + t5;
    const double t7 = 2.0 * Omega;
    const double t8 = t1 + 2.0 * t3;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = A * t4 + I_0 * t0 + R;
    out[2] = 2.0 * (I_ * (I_0A + 2.0 * t2 * t5 + t7 * zeta) + R * t6);
    out[3] = 4.0 * A * (I_ * (t3 + zeta) + Omega * R);
    out[4] = I_0A * (t0 + t2) + t3 * t8 + t4 + t6;
    out[5] = A * A * d * t8 + A * t7 - I_0 * zeta / t5;
}

/* F_A and F_AA; derivatives by A and by Omega of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0.
   Operations: 171 structured, 64 common subexpressions, 64 power chains
   Proved, error / u (1 + kappa): 5.01, -, -, -, -, -
 */
static inline void dissipation_cusps(double Omega, double A, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h_A, double h_AA, double h_AAA, double R, double I_, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = h_A + t0;
    const double t2 = 2.0 * Omega;
    const double t3 = d * t0;
    const double t4 = 2.0 * t3;
    const double t5 = A * t4 + I_0A + t2 * zeta;
    const double t6 = 2.0 * (I_ * I_0AA + I_ * t4 + R * h_AA + t1 * t1 + t5 * t5);
    const double t7 = A * Omega;
    const double t8 = d * t2;
    const double t9 = A * t8 + zeta;
    const double t10 = A * (d * t7 + zeta);
    const double t11 = 2.0 * t5;
    const double t12 = I_0AA + t4;
    out[0] = 2.0 * (I_ * t5 + R * t1);
    out[1] = t6;
    out[2] = t6;
    out[3] = 4.0 * (I_ * t9 + Omega * R + t1 * t7 + t10 * t5);
    out[4] = 2.0 * (I_ * I_0AAA + I_0AA * t11 + R * h_AAA + 3.0 * h_AA * t1 + t12 * t5 + 4.0 * t3 * t5);
    out[5] = 4.0 * (I_ * t8 + h_AA * t7 + t1 * t2 + t10 * t12 + t11 * t9);
}

/* F_A and F_Omega/(4 A Omega); derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0.
   Operations: 125 structured, 66 common subexpressions, 66 power chains
   Proved, error / u (1 + kappa): 5.01, -, -, -, -, 10.51
 */
static inline void dissipation_isolas(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double d, double h_A, double h_AA, double R, double I_, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = h_A + t0;
    const double t2 = 2.0 * Omega;
    const double t3 = A * d;
    const double t4 = 2.0 * t0;
    const double t5 = I_0A + t2 * zeta + t3 * t4;
    const double t6 = zeta / Omega;
    const double t7 = 3.0 * zeta;
    const double t8 = Omega * t3;
    const double t9 = I_0 * d + t8 * (t7 + t8) + 2.0 * zeta * zeta;
    const double t10 = t2 * t3;
    const double t11 = t10 + t7;
    out[0] = 2.0 * (I_ * t5 + R * t1);
    out[1] = A * t9 + I_0 * t6 + R;
    out[2] = 2.0 * (I_ * I_0AA + I_ * d * t4 + R * h_AA + t1 * t1 + t5 * t5);
    out[3] = 4.0 * (A * Omega * t1 + A * t5 * (t8 + zeta) + I_ * (t10 + zeta) + Omega * R);
    out[4] = I_0A * (t3 + t6) + t1 + t11 * t8 + t9;
    out[5] = A * A * d * t11 + A * t2 - I_0 * zeta / t0;
}

/* F_A and F_AOmega/Omega, less constant factors; derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0.
   Operations: 166 structured, 111 common subexpressions, 110 power chains
   Proved, error / u (1 + kappa): 5.01, -, -, -, -, 13.17
 */
static inline void dissipation_turns(double Omega, double A, double I_0, double I_0A, double I_0AA, double zeta, double d, double h, double h_A, double h_AA, double R, double I_, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = h_A + t0;
    const double t2 = 2.0 * Omega;
    const double t3 = A * d;
    const double t4 = 2.0 * t3;
    const double t5 = I_0A + t0 * t4 + t2 * zeta;
    const double t6 = 2.0 * h_A;
    const double t7 = 4.0 * A;
    const double t8 = zeta * zeta;
    const double A2 = A * A;
    const double t9 = 2.0 * d;
    const double t10 = A2 * d * zeta;
    const double t11 = A * I_0A;
    const double t12 = I_0 + t11;
    const double t13 = zeta / Omega;
    const double t14 = d * d;
    const double t15 = Omega * t3;
    const double t16 = A2 * t14;
    const double A3 = A * A2;
    out[0] = 2.0 * (I_ * t5 + R * t1);
    out[1] = A * t6 + 8.0 * A * t8 + A2 * I_0A * t9 + I_0 * d * t7 + 18.0 * Omega * t10 + 2.0 * h + t0 * (8.0 * A3
        * t14 + t7) + 2.0 * t12 * t13;
    out[2] = 2.0 * (I_ * I_0AA + I_ * t0 * t9 + R * h_AA + t1 * t1 + t5 * t5);
    out[3] = 4.0 * (A * Omega * t1 + A * t5 * (t15 + zeta) + I_ * (t2 * t3 + zeta) + Omega * R);
    out[4] = 2.0 * (A * I_0AA * (t13 + t3) + A * h_AA + I_0 * t9 + I_0A * t13 + I_0A * (t13 + t4) + 2.0 * t0 *
        (6.0 * t16 + 1.0) + t11 * t9 + 18.0 * t15 * zeta + t6 + 4.0 * t8);
    out[5] = 2.0 * (Omega * t7 * (2.0 * t16 + 1.0) + 9.0 * t10 - t12 * zeta / t0);
}

/* F, for Omega = 0; derivatives by A and by Omega.
   Equation from (24). Domain: Omega > 0, A > 0.
   Operations: 27 structured, 25 common subexpressions, 25 power chains
   Proved, error / u (1 + kappa): -, 5.01, 3.26
 */
static inline void dissipation_rest(double Omega, double A, double F_0, double I_0A, double zeta, double d, double h_A, double R, double I_, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = A * d;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = 2.0 * (I_ * (I_0A + 2.0 * Omega * zeta + 2.0 * t0 * t1) + R * (h_A + t0));
    out[2] = 4.0 * A * (I_ * (Omega * t1 + zeta) + Omega * R);
}

/* F_A, for Omega = 0; derivatives by A and by Omega.
   Equation from (30). Domain: Omega > 0, A > 0.
   Operations: 64 structured, 38 common subexpressions, 38 power chains
   Proved, error / u (1 + kappa): 5.01, -, -
 */
static inline void dissipation_stiffness(double Omega, double A, double I_0A, double I_0AA, double zeta, double d, double h_A, double h_AA, double R, double I_, double *out)
{
    const double t0 = Omega * Omega;
    const double t1 = h_A + t0;
    const double t2 = 2.0 * Omega;
    const double t3 = A * d;
    const double t4 = 2.0 * t0;
    const double t5 = I_0A + t2 * zeta + t3 * t4;
    const double t6 = A * Omega;
    out[0] = 2.0 * (I_ * t5 + R * t1);
    out[1] = 2.0 * (I_ * I_0AA + I_ * d * t4 + R * h_AA + t1 * t1 + t5 * t5);
    out[2] = 4.0 * (A * t5 * (d * t6 + zeta) + I_ * (t2 * t3 + zeta) + Omega * R + t1 * t6);
}

#endif
