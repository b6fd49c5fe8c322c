/* The equation of motion of any mechanism, in the values of its force.

   Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/extensions/motion.py,
   derivations/extensions/switching.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef MOTION_H
#define MOTION_H

#include <math.h>

#include "inline.h"

/* What friction has to hold at rest; cosine of theta = Omega tau.
   Equation (3). Domain: any. Operations: 2. Error / u (1 + kappa): proved 1.01. */
SF_KERNEL double motion_push(double cosine, double F_0, double f) {
    return F_0 * cosine - f;
}

/* Derivatives of the push by theta, u, F_0.
   Equation (3). Domain: any. Operations: 1. Error / u (1 + kappa): proved 0.34, 0.0, 0.0. */
SF_KERNEL void motion_push_slopes(double cosine, double sine, double F_0, double f_u, double *out) {
    out[0] = -F_0 * sine;
    out[1] = -f_u;
    out[2] = cosine;
}

/* The cosine of theta at which a mass at rest breaks away against friction mu or -mu.
   Equation (3). Domain: F_0 > 0. Operations: 2. Error / u (1 + kappa): proved 3.01. */
SF_KERNEL double motion_breakaway(double F_0, double friction, double f) {
    return (f + friction) / F_0;
}

/* u'' of a slipping mass; friction is mu sign(u').
   Equation (3). Domain: any. Operations: 6. Error / u (1 + kappa): proved 3.01. */
SF_KERNEL double motion_acceleration(double cosine, double v, double F_0, double zeta, double friction, double f) {
    return F_0 * cosine - f - friction - 2.0 * v * zeta;
}

/* Friction, quadratic damping, both times the sign of u', and the others; zeta by the slope of all by u'; and what the slope by u adds to f_u.
   Equation (3). Domain: any. Operations: 20. Error / u (1 + kappa): proved 5.01, 4.26, 0.51. */
SF_KERNEL void motion_resistance(double v, double zeta, double friction, double quadratic, double c_3, double zeta_2, double u, double *out) {
    const double v2 = v * v;
    const double t0 = u * u * zeta_2;
    const double v3 = v * v2;
    out[0] = c_3 * v3 + friction + quadratic * v2 + 2.0 * t0 * v;
    out[1] = 1.5 * c_3 * v2 + quadratic * v + t0 + zeta;
    out[2] = 4.0 * u * v * zeta_2;
}

/* The zeta of structural damping at one frequency, and its slope by Omega.
   Equation beside (3). Domain: Omega > 0. Operations: 4. Error / u (1 + kappa): proved 0.34, 0.51. */
SF_KERNEL void motion_structural(double Omega, double eta, double *out) {
    const double t0 = 0.5 * eta;
    out[0] = t0 / Omega;
    out[1] = -t0 / (Omega * Omega);
}

/* Derivatives of the rates by u, v: of the first, then of the second.
   Equation (3). Domain: Omega > 0. Operations: 4. Error / u (1 + kappa): proved 0.0, 0.51, 0.67, 0.67. */
SF_KERNEL void motion_rates_by_state(double Omega, double zeta, double f_u, double *out) {
    const double t0 = 1.0 / Omega;
    out[0] = 0.0;
    out[1] = t0;
    out[2] = -f_u * t0;
    out[3] = -2.0 * t0 * zeta;
}

/* Derivatives of the rates by Omega, F_0, zeta, friction, f: of the first, then of the second.
   Equation (3). Domain: Omega > 0. Operations: 13. Error / u (1 + kappa): proved 6.01 at most. */
SF_KERNEL void motion_rates_by_parameter(double cosine, double v, double Omega, double F_0, double zeta, double friction, double f, double *out) {
    const double t0 = 1.0 / (Omega * Omega);
    const double t1 = 2.0 * v;
    const double t2 = 1.0 / Omega;
    const double t3 = -t2;
    for (int k = 0; k < 10; k++)
        out[k] = 0.0;
    out[0] = -t0 * v;
    out[5] = -t0 * (F_0 * cosine - f - friction - t1 * zeta);
    out[6] = cosine * t2;
    out[7] = -t1 * t2;
    out[8] = t3;
    out[9] = t3;
}

/* What u' gains of a deviation of u where u'' changes at an edge.
   Equation beside (3). Domain: v other than 0. Operations: 2. Error / u (1 + kappa): proved 3.01. */
SF_KERNEL double motion_across(double before, double after, double v) {
    return (after - before) / v;
}

/* What is left of a deviation of u' where the velocity changes its sign and u'' with it; 0 where the mass stops.
   Equation beside (3). Domain: before other than 0. Operations: 1. Error / u (1 + kappa): proved 0.34. */
SF_KERNEL double motion_turned(double before, double after) {
    return after / before;
}

/* What u' is of a deviation of u where the push on a mass at rest, with these slopes, breaks it away.
   Equation beside (3). Domain: Omega > 0, by_theta other than 0. Operations: 3. Error / u (1 + kappa): proved 0.61. */
SF_KERNEL double motion_released(double after, double Omega, double by_theta, double by_u) {
    return after * by_u / (Omega * by_theta);
}

#endif
