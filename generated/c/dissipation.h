/* Structural and quadratic damping, and dry friction of what is attached.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/dissipation.py, derivations/gradients.py
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

/* What m, then eta, does to I_0, I_0A and I_0AA: friction acts throughout.
   Equation from (19). Domain: A > 0.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
   Proved, error / u (1 + kappa): 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
 */
static inline void dissipation_rest_moves(double A, double *out)
{
    out[0] = 1.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = A;
    out[4] = 1.0;
    out[5] = 0.0;
}

/* What m, then eta, then u_cr does to them where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0.
   Operations: 14 structured, 12 common subexpressions, 11 power chains
   Proved, error / u (1 + kappa): 0.67, 0.76, 0.81, 0.0, 0.0, 0.0, 0.67, 0.76, 0.81
 */
static inline void dissipation_released_moves(double A, double m, double u_cr, double *out)
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

/* A_p, Omega_p, F_0_p of a steady state; with Omega = 0 a peak at rest; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 84 structured, 56 common subexpressions, 56 power chains
   Proved, error / u (1 + kappa): -, 0.0, 0.0, -, -, 0.0, 0.0
 */
static inline void dissipation_moves_of_state(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AA);
    (void)(I_0AAA);
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(I_0Ap);
    (void)(I_0AAp);
    (void)(end_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * A * t0;
    const double t3 = 2.0 * Omega;
    const double t4 = t3 * zeta;
    const double t5 = A * t4 + d * t2;
    const double I_ = I_0 + t5;
    const double t6 = 2.0 * d * t1 + t4;
    const double F_A = 2.0 * (I_ * (I_0A + t6) + R * (h_A + t0));
    const double F_Omega = 4.0 * A * (I_ * (A * Omega * d + zeta) + Omega * R);
    const double F_p = 2.0 * (I_ * (A * t3 * zeta_p + I_0p + d_p * t2) + R * h_p);
    out[0] = (2.0 * F_0 * forcing_p - F_Omega * frequency_p - F_p) / F_A;
    out[1] = frequency_p;
    out[2] = forcing_p;
    out[3] = F_A;
    out[4] = 2.0 * (t0 + fabs(h_A)) * (t1 + fabs(h)) + 2.0 * (t5 + fabs(I_0)) * (t6 + fabs(I_0A));
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of a fold at a forcing; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 209 structured, 110 common subexpressions, 110 power chains
 */
static inline void dissipation_moves_of_fold(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AAA);
    (void)(h_AAA);
    (void)(h_AAp);
    (void)(I_0AAp);
    (void)(end_p);
    (void)(frequency_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * A * t0;
    const double t3 = 2.0 * Omega;
    const double t4 = t3 * zeta;
    const double t5 = A * t4 + d * t2;
    const double I_ = I_0 + t5;
    const double t6 = 2.0 * d;
    const double t7 = h_A + t0;
    const double t8 = t1 * t6 + t4;
    const double t9 = I_0A + t8;
    const double F_AA = 2.0 * (I_ * I_0AA + I_ * t0 * t6 + R * h_AA + t7 * t7 + t9 * t9);
    const double t10 = Omega * R;
    const double t11 = A * Omega;
    const double t12 = A * t3;
    const double t13 = d * t11 + zeta;
    const double F_AOmega = 4.0 * (A * t13 * t9 + I_ * (d * t12 + zeta) + t10 + t11 * t7);
    const double t14 = 4.0 * A;
    const double F_Omega = t14 * (I_ * t13 + t10);
    const double t15 = I_0p + d_p * t2 + t12 * zeta_p;
    const double F_p = 2.0 * (I_ * t15 + R * h_p);
    const double F_Ap = 2.0 * (I_ * I_0Ap + 2.0 * I_ * d_p * t1 + I_ * t3 * zeta_p + R * h_Ap + h_p * t7 + t15 * t9);
    const double t16 = 1.0 / F_Omega;
    const double t17 = 2.0 * F_0 * forcing_p;
    const double t18 = t1 + fabs(h);
    const double t19 = t5 + fabs(I_0);
    const double t20 = t0 + fabs(h_A);
    const double t21 = t8 + fabs(I_0A);
    out[0] = -t16 * (-F_AOmega * F_p + F_AOmega * t17 + F_Ap * F_Omega) / F_AA;
    out[1] = t16 * (-F_p + t17);
    out[2] = forcing_p;
    out[3] = F_AA;
    out[4] = 4.0 * d * t0 * t19 + 2.0 * t18 * fabs(h_AA) + 2.0 * t19 * fabs(I_0AA) + 2.0 * t20 * t20 + 2.0 * t21 *
        t21;
    out[5] = F_Omega;
    out[6] = t14 * (Omega * t18 + t13 * t19);
}

/* A_p, Omega_p, F_0_p of a fold at a forcing, on a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 75 structured, 51 common subexpressions, 51 power chains
   Proved, error / u (1 + kappa): 0.0, -, 0.0, -, -, 0.0, 0.0
 */
static inline void dissipation_moves_of_corner_fold(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AA);
    (void)(I_0AAA);
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(I_0Ap);
    (void)(I_0AAp);
    (void)(frequency_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * A * t0;
    const double t3 = 2.0 * Omega;
    const double t4 = t3 * zeta;
    const double t5 = A * t4 + d * t2;
    const double I_ = I_0 + t5;
    const double F_A = 2.0 * (I_ * (I_0A + 2.0 * d * t1 + t4) + R * (h_A + t0));
    const double t6 = A * Omega * d + zeta;
    const double t7 = 4.0 * A;
    const double F_Omega = t7 * (I_ * t6 + Omega * R);
    const double F_p = 2.0 * (I_ * (A * t3 * zeta_p + I_0p + d_p * t2) + R * h_p);
    out[0] = end_p;
    out[1] = (2.0 * F_0 * forcing_p - F_A * end_p - F_p) / F_Omega;
    out[2] = forcing_p;
    out[3] = F_Omega;
    out[4] = t7 * (Omega * (t1 + fabs(h)) + t6 * (t5 + fabs(I_0)));
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of a peak at a forcing; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 176 structured, 93 common subexpressions, 93 power chains
 */
static inline void dissipation_moves_of_peak(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AA);
    (void)(I_0AAA);
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(I_0Ap);
    (void)(I_0AAp);
    (void)(end_p);
    (void)(frequency_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * A * t0;
    const double t3 = 2.0 * Omega;
    const double t4 = t3 * zeta;
    const double t5 = A * t4 + d * t2;
    const double I_ = I_0 + t5;
    const double t6 = h_A + t0;
    const double t7 = 2.0 * t1;
    const double t8 = d * t7 + t4;
    const double t9 = I_0A + t8;
    const double F_A = 2.0 * (I_ * t9 + R * t6);
    const double t10 = A * Omega;
    const double t11 = A * d;
    const double t12 = d * t10 + zeta;
    const double F_AOmega = 4.0 * (A * t12 * t9 + I_ * (t11 * t3 + zeta) + Omega * R + t10 * t6);
    const double t13 = 2.0 * A * t12 * t12;
    const double t14 = 4.0 * A;
    const double F_OmegaOmega = t14 * (I_ * t11 + R + t13 + t7);
    const double t15 = A * t3 * zeta_p + I_0p + d_p * t2;
    const double F_p = 2.0 * (I_ * t15 + R * h_p);
    const double F_Omegap = t14 * (I_ * d_p * t10 + I_ * zeta_p + Omega * h_p + t12 * t15);
    const double t16 = 1.0 / F_A;
    const double t17 = 2.0 * F_0 * forcing_p;
    const double t18 = fabs(h);
    const double t19 = t5 + fabs(I_0);
    out[0] = t16 * (-F_p + t17);
    out[1] = -t16 * (F_A * F_Omegap - F_AOmega * F_p + F_AOmega * t17) / F_OmegaOmega;
    out[2] = forcing_p;
    out[3] = F_A;
    out[4] = 2.0 * t19 * (t8 + fabs(I_0A)) + 2.0 * (t0 + fabs(h_A)) * (t1 + t18);
    out[5] = F_OmegaOmega;
    out[6] = t14 * (3.0 * t1 + t11 * t19 + t13 + t18);
}

/* A_p, Omega_p, F_0_p of where two folds meet; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 381 structured, 161 common subexpressions, 161 power chains
 */
static inline void dissipation_moves_of_cusp(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(end_p);
    (void)(forcing_p);
    (void)(frequency_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * A;
    const double t3 = d * t0;
    const double t4 = 2.0 * Omega;
    const double t5 = t4 * zeta;
    const double t6 = A * t5 + t2 * t3;
    const double I_ = I_0 + t6;
    const double t7 = h_A + t0;
    const double t8 = 2.0 * t1;
    const double t9 = d * t8;
    const double t10 = t5 + t9;
    const double t11 = I_0A + t10;
    const double t12 = 2.0 * t11;
    const double t13 = 2.0 * t3;
    const double t14 = I_0AA + t13;
    const double F_AAA = 2.0 * (I_ * I_0AAA + I_0AA * t12 + R * h_AAA + 3.0 * h_AA * t7 + t11 * t14 + 4.0 * t11 *
        t3);
    const double t15 = Omega * R;
    const double t16 = A * Omega;
    const double t17 = d * t4;
    const double t18 = A * t17 + zeta;
    const double t19 = d * t16 + zeta;
    const double t20 = A * t19;
    const double F_AOmega = 4.0 * (I_ * t18 + t11 * t20 + t15 + t16 * t7);
    const double F_AAOmega = 4.0 * (I_ * t17 + I_0AA * t20 + h_AA * t16 + t12 * t18 + t19 * t9 + t4 * t7);
    const double F_Omega = 4.0 * A * (I_ * t19 + t15);
    const double t21 = t4 * zeta_p;
    const double t22 = d_p * t0;
    const double t23 = A * t21 + I_0p + t2 * t22;
    const double F_p = 2.0 * (I_ * t23 + R * h_p);
    const double F_Ap = 2.0 * (I_ * I_0Ap + I_ * d_p * t8 + I_ * t21 + R * h_Ap + h_p * t7 + t11 * t23);
    const double t24 = 4.0 * Omega;
    const double F_AAp = 2.0 * (I_ * I_0AAp + I_0Ap * t12 + R * h_AAp + h_AA * h_p + 2.0 * h_Ap * t7 + t11 * t24 *
        zeta_p + t14 * t23 + 2.0 * t22 * (A * t12 + I_));
    const double t25 = 1.0 / F_AOmega;
    const double t26 = t0 + fabs(h_A);
    const double t27 = t1 + fabs(h);
    const double t28 = fabs(I_0AA);
    const double t29 = t10 + fabs(I_0A);
    const double t30 = 4.0 * t29;
    const double t31 = t6 + fabs(I_0);
    out[0] = t25 * (F_AAOmega * F_Ap - F_AAp * F_AOmega) / F_AAA;
    out[1] = -F_Ap * t25;
    out[2] = 0.5 * t25 * (F_AOmega * F_p - F_Ap * F_Omega) / F_0;
    out[3] = F_AAA;
    out[4] = 6.0 * t26 * fabs(h_AA) + 2.0 * t27 * fabs(h_AAA) + t28 * t30 + 8.0 * t29 * t3 + 2.0 * t29 * (t13 +
        t28) + 2.0 * t31 * fabs(I_0AAA);
    out[5] = F_AOmega;
    out[6] = 4.0 * t16 * t26 + 4.0 * t18 * t31 + t20 * t30 + t24 * t27;
}

/* A_p, Omega_p, F_0_p of where an isolated curve is born; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 300 structured, 139 common subexpressions, 139 power chains
 */
static inline void dissipation_moves_of_isola(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AAA);
    (void)(h_AAA);
    (void)(h_AAp);
    (void)(I_0AAp);
    (void)(end_p);
    (void)(forcing_p);
    (void)(frequency_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * A * t0;
    const double t3 = 2.0 * Omega;
    const double t4 = t3 * zeta;
    const double t5 = A * t4 + d * t2;
    const double I_ = I_0 + t5;
    const double t6 = d * t0;
    const double t7 = h_A + t0;
    const double t8 = 2.0 * t1;
    const double t9 = d * t8 + t4;
    const double t10 = I_0A + t9;
    const double F_AA = 2.0 * (I_ * I_0AA + 2.0 * I_ * t6 + R * h_AA + t10 * t10 + t7 * t7);
    const double t11 = A * Omega;
    const double t12 = A * d;
    const double t13 = t12 * t3 + zeta;
    const double t14 = d * t11 + zeta;
    const double t15 = A * t14;
    const double F_AOmega = 4.0 * (I_ * t13 + Omega * R + t10 * t15 + t11 * t7);
    const double t16 = 2.0 * A * t14 * t14;
    const double t17 = 4.0 * A;
    const double F_OmegaOmega = t17 * (I_ * t12 + R + t16 + t8);
    const double t18 = A * t3 * zeta_p + I_0p + d_p * t2;
    const double F_p = 2.0 * (I_ * t18 + R * h_p);
    const double t19 = I_ * zeta_p;
    const double t20 = I_ * d_p;
    const double F_Ap = 2.0 * (I_ * I_0Ap + R * h_Ap + h_p * t7 + t10 * t18 + t19 * t3 + t20 * t8);
    const double F_Omegap = t17 * (Omega * h_p + t11 * t20 + t14 * t18 + t19);
    const double t21 = F_AA * F_OmegaOmega - F_AOmega * F_AOmega;
    const double t22 = 1.0 / t21;
    const double t23 = t0 + fabs(h_A);
    const double t24 = fabs(h);
    const double t25 = t1 + t24;
    const double t26 = t9 + fabs(I_0A);
    const double t27 = t5 + fabs(I_0);
    const double t28 = 4.0 * t27;
    const double t29 = 4.0 * Omega * t25 + 4.0 * t11 * t23 + t13 * t28 + 4.0 * t15 * t26;
    out[0] = t22 * (F_AOmega * F_Omegap - F_Ap * F_OmegaOmega);
    out[1] = -t22 * (F_AA * F_Omegap - F_AOmega * F_Ap);
    out[2] = 0.5 * F_p / F_0;
    out[3] = t21;
    out[4] = t17 * (3.0 * t1 + t12 * t27 + t16 + t24) * (2.0 * t23 * t23 + 2.0 * t25 * fabs(h_AA) + 2.0 * t26 *
        t26 + 2.0 * t27 * fabs(I_0AA) + t28 * t6) + t29 * t29;
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of the least forcing on a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 139 structured, 78 common subexpressions, 78 power chains
   Proved, error / u (1 + kappa): 0.0, -, -, -, -, 0.0, 0.0
 */
static inline void dissipation_moves_of_corner_top(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AA);
    (void)(I_0AAA);
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(I_0Ap);
    (void)(I_0AAp);
    (void)(forcing_p);
    (void)(frequency_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * A * t0;
    const double t3 = 2.0 * Omega;
    const double t4 = t3 * zeta;
    const double t5 = A * t4 + d * t2;
    const double I_ = I_0 + t5;
    const double t6 = h_A + t0;
    const double t7 = 2.0 * t1;
    const double t8 = I_0A + d * t7 + t4;
    const double F_A = 2.0 * (I_ * t8 + R * t6);
    const double t9 = A * Omega;
    const double t10 = A * d;
    const double t11 = d * t9 + zeta;
    const double F_AOmega = 4.0 * (A * t11 * t8 + I_ * (t10 * t3 + zeta) + Omega * R + t6 * t9);
    const double t12 = 2.0 * A * t11 * t11;
    const double t13 = 4.0 * A;
    const double F_OmegaOmega = t13 * (I_ * t10 + R + t12 + t7);
    const double t14 = A * t3 * zeta_p + I_0p + d_p * t2;
    const double F_p = 2.0 * (I_ * t14 + R * h_p);
    const double F_Omegap = t13 * (I_ * d_p * t9 + I_ * zeta_p + Omega * h_p + t11 * t14);
    out[0] = end_p;
    out[1] = -(F_AOmega * end_p + F_Omegap) / F_OmegaOmega;
    out[2] = 0.5 * (F_A * end_p + F_p) / F_0;
    out[3] = F_OmegaOmega;
    out[4] = t13 * (3.0 * t1 + t10 * (t5 + fabs(I_0)) + t12 + fabs(h));
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of where the fold locus meets a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 178 structured, 100 common subexpressions, 100 power chains
 */
static inline void dissipation_moves_of_corner_end(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AAA);
    (void)(h_AAA);
    (void)(h_AAp);
    (void)(I_0AAp);
    (void)(forcing_p);
    (void)(frequency_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = A * A * t0;
    const double t3 = 2.0 * Omega;
    const double t4 = t3 * zeta;
    const double t5 = A * t4 + d * t2;
    const double I_ = I_0 + t5;
    const double t6 = 2.0 * d;
    const double t7 = h_A + t0;
    const double t8 = t1 * t6 + t4;
    const double t9 = I_0A + t8;
    const double F_AA = 2.0 * (I_ * I_0AA + I_ * t0 * t6 + R * h_AA + t7 * t7 + t9 * t9);
    const double t10 = Omega * R;
    const double t11 = A * Omega;
    const double t12 = A * t3;
    const double t13 = d * t12 + zeta;
    const double t14 = d * t11 + zeta;
    const double t15 = A * t14;
    const double F_AOmega = 4.0 * (I_ * t13 + t10 + t11 * t7 + t15 * t9);
    const double F_Omega = 4.0 * A * (I_ * t14 + t10);
    const double t16 = I_0p + d_p * t2 + t12 * zeta_p;
    const double F_p = 2.0 * (I_ * t16 + R * h_p);
    const double F_Ap = 2.0 * (I_ * I_0Ap + 2.0 * I_ * d_p * t1 + I_ * t3 * zeta_p + R * h_Ap + h_p * t7 + t16 * t9);
    const double t17 = 1.0 / F_AOmega;
    const double t18 = F_AA * end_p;
    out[0] = end_p;
    out[1] = -t17 * (F_Ap + t18);
    out[2] = -0.5 * t17 * (-F_AOmega * F_p + F_Ap * F_Omega + F_Omega * t18) / F_0;
    out[3] = F_AOmega;
    out[4] = 4.0 * Omega * (t1 + fabs(h)) + 4.0 * t11 * (t0 + fabs(h_A)) + 4.0 * t13 * (t5 + fabs(I_0)) + 4.0 *
        t15 * (t8 + fabs(I_0A));
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of where the backbone meets a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 57 structured, 43 common subexpressions, 43 power chains
   Proved, error / u (1 + kappa): 0.0, 4.34, -, 0.34, 0.34, 0.0, 0.0
 */
static inline void dissipation_moves_of_corner_backbone(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AA);
    (void)(I_0AAA);
    (void)(h);
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(I_0Ap);
    (void)(I_0AAp);
    (void)(forcing_p);
    (void)(frequency_p);
    const double t0 = 2.0 * Omega;
    const double t1 = t0 * zeta;
    const double t2 = Omega * Omega;
    const double t3 = A * A * t2;
    const double I_ = A * t1 + I_0 + d * t3;
    const double t4 = A * d;
    const double t5 = 2.0 * I_;
    const double F_A = t5 * (I_0A + t1 + 2.0 * t2 * t4);
    const double F_Omega = 4.0 * A * I_ * (Omega * t4 + zeta);
    const double R_A = h_A + t2;
    const double t6 = A * t0;
    const double F_p = t5 * (I_0p + d_p * t3 + t6 * zeta_p);
    const double t7 = 1.0 / t6;
    const double t8 = R_A * end_p;
    out[0] = end_p;
    out[1] = -t7 * (h_p + t8);
    out[2] = 0.5 * t7 * (F_A * end_p * t6 - F_Omega * h_p - F_Omega * t8 + F_p * t6) / F_0;
    out[3] = t6;
    out[4] = t6;
    out[5] = 1.0;
    out[6] = 1.0;
}

/* A_p, Omega_p, F_0_p of at Omega = 0 on a breakpoint; then what must not vanish, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 53 structured, 43 common subexpressions, 43 power chains
   Proved, error / u (1 + kappa): 0.0, 0.0, -, 0.0, 0.0, 0.0, 0.0
 */
static inline void dissipation_moves_of_corner_rest(double Omega, double A, double F_0, double I_0, double I_0A, double I_0AA, double I_0AAA, double zeta, double d, double h, double h_A, double h_AA, double h_AAA, double h_p, double h_Ap, double h_AAp, double I_0p, double I_0Ap, double I_0AAp, double zeta_p, double d_p, double end_p, double forcing_p, double frequency_p, double *out)
{
    (void)(I_0AA);
    (void)(I_0AAA);
    (void)(h_AA);
    (void)(h_AAA);
    (void)(h_Ap);
    (void)(h_AAp);
    (void)(I_0Ap);
    (void)(I_0AAp);
    (void)(forcing_p);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega;
    const double t3 = t2 * zeta;
    const double t4 = A * A * t0;
    const double I_ = A * t3 + I_0 + d * t4;
    const double F_A = 2.0 * (I_ * (I_0A + 2.0 * d * t1 + t3) + R * (h_A + t0));
    const double F_Omega = 4.0 * A * (I_ * (A * Omega * d + zeta) + Omega * R);
    const double F_p = 2.0 * (I_ * (A * t2 * zeta_p + I_0p + d_p * t4) + R * h_p);
    out[0] = end_p;
    out[1] = frequency_p;
    out[2] = 0.5 * (F_A * end_p + F_Omega * frequency_p + F_p) / F_0;
    out[3] = 1.0;
    out[4] = 1.0;
    out[5] = 1.0;
    out[6] = 1.0;
}

/* F_A, F_Omega and R, each with its size.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 91 structured, 45 common subexpressions, 45 power chains
 */
static inline void dissipation_beside(double Omega, double A, double F_0, double I_0, double I_0A, double zeta, double d, double h, double h_A, double *out)
{
    (void)(F_0);
    const double t0 = Omega * Omega;
    const double t1 = A * t0;
    const double R = h + t1;
    const double t2 = 2.0 * Omega * zeta;
    const double t3 = A * A * d * t0 + A * t2;
    const double I_ = I_0 + t3;
    const double t4 = 2.0 * d * t1 + t2;
    const double F_A = 2.0 * (I_ * (I_0A + t4) + R * (h_A + t0));
    const double t5 = A * Omega * d + zeta;
    const double t6 = 4.0 * A;
    const double F_Omega = t6 * (I_ * t5 + Omega * R);
    const double t7 = t1 + fabs(h);
    const double t8 = t3 + fabs(I_0);
    out[0] = F_A;
    out[1] = 2.0 * t7 * (t0 + fabs(h_A)) + 2.0 * t8 * (t4 + fabs(I_0A));
    out[2] = F_Omega;
    out[3] = t6 * (Omega * t7 + t5 * t8);
    out[4] = R;
    out[5] = t7;
}

/* d/dp of the phase (25) and of the transmissibility of a state that moves by A_p, Omega_p, F_0_p.
   Equation from (23)-(34). Domain: Omega > 0, A > 0.
   Operations: 82 structured, 59 common subexpressions, 59 power chains
 */
static inline void dissipation_moves_of_phase(double Omega, double A, double F_0, double I_0, double I_0A, double zeta, double d, double h, double h_A, double h_p, double I_0p, double zeta_p, double d_p, double A_p, double Omega_p, double F_0_p, double *out)
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
    const double t7 = I_ * I_;
    const double t8 = 1.0 / F_0;
    const double t9 = sqrt(h * h + t7);
    const double t10 = 1.0 / t9;
    out[0] = (-I_ * R_moved + I_moved * R) / (R * R + t7);
    out[1] = t8 * (-F_0_p * t8 * t9 + I_ * I_moved * t10 + h * t10 * t6);
}

#endif
