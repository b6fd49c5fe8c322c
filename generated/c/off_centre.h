/* Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/off_centre.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/emit/rounding.py); others are measured (docs/stability.md). */

#ifndef OFF_CENTRE_H
#define OFF_CENTRE_H

#include <math.h>

/* h, h_A, h_AA, h_AAA along the balance of the mean.
   Equation (20), (31). Domain: A > 0, c_1 other than 0.
   Operations: 124 structured, 107 common subexpressions, 105 power chains
   Proved, error / u (1 + kappa): 0.0, 2.01, 28.01, -
 */
static inline void off_centre_averaged(double A, double c_1, double c_2, double c_3, double s_0, double s_1, double s_2, double s_3, double *out)
{
    const double t0 = 1.0 / c_1;
    const double B_A = -s_1 * t0;
    const double t1 = 1.0 / A;
    const double t2 = 2.0 * s_2;
    const double B_A2 = B_A * B_A;
    const double B_AA = t0 * t1 * (-A * (B_A * t2 + B_A2 * c_2 + c_2) + s_1);
    const double A2 = A * A;
    const double t3 = 1.0 / A2;
    const double t4 = 2.0 * s_1;
    const double t5 = 3.0 * B_A;
    const double t6 = B_AA * s_2;
    const double B_A3 = B_A * B_A2;
    const double t7 = B_AA * c_2;
    const double B_AAA = t0 * t3 * (A * (c_2 + s_2 * t5) - A2 * (3.0 * B_A2 * s_3 + B_A3 * c_3 + c_3 * t5 + s_3 + t5
        * t7 + 3.0 * t6) - t4);
    const double t8 = 6.0 * B_A;
    const double A3 = A * A2;
    out[0] = -2.0 * s_0;
    out[1] = -B_A * t4 - 2.0 * c_1 + 2.0 * s_0 * t1;
    out[2] = -4.0 * B_A * c_2 + 4.0 * B_A * s_1 * t1 - B_A2 * t2 - B_AA * t4 + 2.0 * c_1 * t1 - 4.0 * s_0 * t3 -
        t2;
    out[3] = 6.0 * B_A * c_2 * t1 - 12.0 * B_A * s_1 * t3 - 6.0 * B_A2 * c_3 + 6.0 * B_A2 * s_2 * t1 - 2.0 * B_A3
        * s_3 + 6.0 * B_AA * s_1 * t1 - B_AAA * t4 - 6.0 * c_1 * t3 - 2.0 * c_3 + 4.0 * s_2 * t1 - s_3 * t8 - t6 *
        t8 - 6.0 * t7 + 12.0 * s_0 / A3;
}

/* What vanishes at a steady state: the balance of the mean and F; slopes of each by A and B.
   Equation (24) and the mean of (3). Domain: A > 0.
   Operations: 28 structured, 25 common subexpressions, 25 power chains
   Proved, error / u (1 + kappa): 1.01, -, 0.0, 0.0, -, 1.51
 */
static inline void off_centre_state(double Omega, double A, double F_0, double m, double zeta, double load, double c_0, double c_1, double s_0, double s_1, double *out)
{
    const double t0 = 2.0 * s_0;
    const double t1 = Omega * Omega;
    const double R = A * t1 - t0;
    const double t2 = Omega * zeta;
    const double I_ = 2.0 * A * t2 + m;
    out[0] = c_0 - load;
    out[1] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[2] = s_1;
    out[3] = c_1;
    out[4] = 4.0 * I_ * t2 + 2.0 * R * (-2.0 * c_1 + t1 + t0 / A);
    out[5] = -4.0 * R * s_1;
}

/* What vanishes at a fold at F_0 with cos phi = -2 t/(1 + t^2): the balance, F_A along it times c_1 and a positive number, R and I of one Omega; slopes of each by A, B and t.
   Equation (24), (30) and the mean of (3). Domain: A > 0, |t| <= 1.
   Operations: 233 structured, 137 common subexpressions, 134 power chains
   Proved, error / u (1 + kappa): 1.01, 11.51, -, 0.0, 0.0, 0.0, -, 13.01, 4.01, 6.34, 1.01, 45.68
 */
static inline void off_centre_fold(double t, double A, double F_0, double m, double zeta, double load, double c_0, double c_1, double c_2, double s_0, double s_1, double s_2, double *out)
{
    const double t0 = c_1 * c_1;
    const double t1 = 4.0 * t;
    const double t2 = t0 * t1;
    const double t3 = s_1 * s_1;
    const double t4 = t1 * t3;
    const double t5 = 8.0 * s_0;
    const double t6 = t * t5;
    const double t7 = t * t;
    const double t8 = F_0 * t7;
    const double t9 = m * t7;
    const double t10 = t7 + 1.0;
    const double t11 = zeta * zeta;
    const double t12 = 2.0 * t;
    const double t13 = F_0 * t12;
    const double t14 = 4.0 * A;
    const double t15 = 8.0 * c_1;
    const double t16 = t * t15;
    const double t17 = A * t16;
    const double t18 = 8.0 * s_1;
    const double t19 = A * t * t18;
    const double t20 = A * t11;
    const double t21 = t15 * t20;
    const double t22 = 8.0 * F_0;
    const double t23 = t11 * t22;
    const double t24 = t * t7;
    const double t25 = 16.0 * t20 * t7;
    const double t26 = t7 * t7;
    const double t27 = t18 * t20;
    const double t28 = F_0 * F_0;
    const double t29 = m * m;
    const double t30 = 32.0 * s_0 * t20;
    const double t31 = F_0 * (1.0 - t7) - m * t10;
    out[0] = c_0 - load;
    out[1] = -A * t2 + A * t4 + c_1 * (F_0 - m + t6 + t8 + t9);
    out[2] = -t10 * t11 * t14 * (2.0 * s_0 * t10 + t13) + t31 * t31;
    out[3] = s_1;
    out[4] = c_1;
    out[5] = 0.0;
    out[6] = F_0 * s_2 + c_2 * t19 - m * s_2 - s_2 * t17 + s_2 * t6 + s_2 * t8 + s_2 * t9 + t2 - t4 - c_1 * t6 / A;
    out[7] = F_0 * c_2 - c_2 * m - c_2 * t17 + c_2 * t6 + c_2 * t8 + c_2 * t9 + s_1 * t16 + s_2 * t19;
    out[8] = c_1 * m * t12 + c_1 * t13 + c_1 * t5 - t0 * t14 + t14 * t3;
    out[9] = -c_1 * t25 - t * t23 - t21 * t26 - t21 - t23 * t24;
    out[10] = -s_1 * t25 - t26 * t27 - t27;
    out[11] = 8.0 * F_0 * m * t24 + 4.0 * t * t29 - t * t30 - t1 * t28 - t20 * t22 - 24.0 * t20 * t8 + 4.0 * t24 *
        t28 + 4.0 * t24 * t29 - t24 * t30;
}

/* The second of what vanishes at a fold over c_1; resists = (c_1^2 - s_1^2)/c_1.
   Equation (30). Domain: A > 0, |t| <= 1.
   Operations: 14 structured, 13 common subexpressions, 13 power chains
   Proved, error / u (1 + kappa): 8.51
 */
static inline double off_centre_turns(double t, double A, double F_0, double m, double resists, double s_0)
{
    const double t0 = t * t;
    return -4.0 * A * resists * t + F_0 * t0 + F_0 + m * t0 - m + 8.0 * s_0 * t;
}

/* L_-1, L_0, M_-1, M_0 of a step at B + a that the motion passes at psi = angle.
   Equation the mean of (3). Domain: root = sqrt(A^2 - a^2).
   Operations: 7 structured, 7 common subexpressions, 7 power chains
 */
static inline void off_centre_begin(double A, double a, double root, double angle, double *out)
{
    const double t0 = 0.31830988618379069 / root;
    const double t1 = 1.0 / A;
    out[0] = t0;
    out[1] = 0.31830988618379069 * angle;
    out[2] = a * t0 * t1;
    out[3] = 0.31830988618379069 * root * t1;
}

/* L_k and M_k from the two below each.
   Equation the mean of (3). Domain: k >= 1.
   Operations: 26 structured, 23 common subexpressions, 23 power chains
 */
static inline void off_centre_up(double k, double A, double a, double L_2, double L_1, double M_2, double M_1, double *out)
{
    const double t0 = 2.0 * k;
    const double t1 = A + a;
    const double t2 = A - a;
    const double t3 = k + 1.0;
    out[0] = (-L_1 * a * (t0 - 1.0) + L_2 * t1 * t2) / (k * k);
    out[1] = (2.0 * A * L_1 - M_1 * a * (t0 + 1.0) + M_2 * t1 * t2) / (t3 * t3);
}

/* L_(k-2) and M_(k-2) from the two above each.
   Equation the mean of (3). Domain: root > 0.
   Operations: 22 structured, 21 common subexpressions, 21 power chains
   Proved, error / u (1 + kappa): 14.01, -
 */
static inline void off_centre_down(double k, double A, double a, double root, double L_1, double L_k, double M_1, double M_k, double *out)
{
    const double t0 = 1.0 / (root * root);
    const double t1 = 2.0 * k;
    const double t2 = k + 1.0;
    out[0] = t0 * (L_1 * a * (t1 - 1.0) + L_k * k * k);
    out[1] = t0 * (-2.0 * A * L_1 + M_1 * a * (t1 + 1.0) + M_k * t2 * t2);
}

#endif
