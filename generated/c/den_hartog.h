/* Den Hartog's exact solution of the linear oscillator with dry friction, without stops.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/den_hartog.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs. */

#ifndef DEN_HARTOG_H
#define DEN_HARTOG_H

#include <math.h>

/* Response function.
   Equation (37). Domain: Omega > 0, Omega != 1.
   Operations: 2 structured, 2 common subexpressions, 2 power chains
 */
static inline double den_hartog_V(double Omega)
{
    return -1.0 / ((Omega * Omega - 1.0));
}

/* Damping function.
   Equation (37). Domain: Omega > 0, Omega != 1, 1/3, 1/5, ....
   Operations: 7 structured, 6 common subexpressions, 6 power chains
 */
static inline double den_hartog_U(double Omega)
{
    const double t0 = 3.1415926535897931 / Omega;
    return sin(t0) / ((Omega * cos(t0) + Omega));
}

/* S is the maximum of this over 0 < tau < pi/Omega.
   Equation (37). Domain: 0 < tau < pi/Omega, Omega > 0, Omega != 1, 1/3, 1/5, ....
   Operations: 21 structured, 18 common subexpressions, 18 power chains
 */
static inline double den_hartog_S_ratio(double tau, double Omega)
{
    const double t0 = 3.1415926535897931 / Omega;
    const double U = sin(t0) / ((Omega * cos(t0) + Omega));
    const double t1 = Omega * tau;
    const double t2 = Omega * U;
    return Omega * (t2 * cos(t1) - t2 * cos(tau) + sin(tau)) / sin(t1);
}

/* Amplitude of the motion.
   Equation (35). Domain: F_0 |V| > mu |U|, Omega > 0, Omega != 1, 1/3, 1/5, ....
   Operations: 17 structured, 16 common subexpressions, 16 power chains
 */
static inline double den_hartog_amplitude(double Omega, double F_0, double mu)
{
    const double V = -1.0 / ((Omega * Omega - 1.0));
    const double t0 = 3.1415926535897931 / Omega;
    const double U = sin(t0) / ((Omega * cos(t0) + Omega));
    return sqrt(F_0 * F_0 * V * V - U * U * mu * mu);
}

/* The motion has no stops while its amplitude exceeds this.
   Equation (36). Domain: Omega > 0, Omega != 1, 1/3, 1/5, ....
   Operations: 22 structured, 21 common subexpressions, 19 power chains
 */
static inline double den_hartog_bound(double Omega, double F_0, double S)
{
    const double Omega2 = Omega * Omega;
    const double V = -1.0 / (Omega2 - 1.0);
    const double t0 = 3.1415926535897931 / Omega;
    const double U = sin(t0) / ((Omega * cos(t0) + Omega));
    const double Omega4 = Omega2 * Omega2;
    return F_0 * fabs(S) * fabs(V) / (sqrt(Omega4 * U * U + S * S));
}

/* Displacement tau after a maximum.
   Equation from (37). Domain: 0 <= tau <= pi/Omega, Omega > 0, Omega != 1, 1/3, 1/5, ....
   Operations: 24 structured, 21 common subexpressions, 21 power chains
 */
static inline double den_hartog_motion(double tau, double Omega, double A, double mu)
{
    const double t0 = 3.1415926535897931 / Omega;
    const double U = sin(t0) / ((Omega * cos(t0) + Omega));
    const double t1 = Omega * tau;
    const double t2 = U * mu;
    return A * cos(t1) - Omega * t2 * sin(tau) - mu * cos(tau) + mu + t2 * sin(t1);
}

#endif
