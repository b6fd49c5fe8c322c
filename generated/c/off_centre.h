/* Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/off_centre.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef OFF_CENTRE_H
#define OFF_CENTRE_H

#include <math.h>

#include "inline.h"

/* Along the balance, by coordinates of the motion's ends: A's slope, and what F_A gains there by R.
   Equation (30) and the mean of (3). Domain: A > 0. Operations: 7. Error / u (1 + kappa): proved 1.01, 2.01. */
SF_KERNEL void off_centre_ended_along(double A, double s_0, double c_x, double c_y, double X, double Y, double *out) {
    const double t0 = -X * c_y + Y * c_x;
    out[0] = t0;
    out[1] = A * c_x * c_y + s_0 * t0;
}

/* L_-1, L_0, M_-1, M_0 of a step at B + a that the motion passes at psi = angle.
   Equation the mean of (3). Domain: root = sqrt(A^2 - a^2). Operations: 7. Error / u (1 + kappa): measured 0.99. */
SF_KERNEL void off_centre_begin(double A, double a, double root, double angle, double *out) {
    const double t0 = 0.31830988618379069 / root;
    const double t1 = 1.0 / A;
    out[0] = t0;
    out[1] = 0.31830988618379069 * angle;
    out[2] = a * t0 * t1;
    out[3] = 0.31830988618379069 * root * t1;
}

/* L_k and M_k from the two below each; span = A^2 - a^2.
   Equation the mean of (3). Domain: k >= 1. Operations: 19. Error / u (1 + kappa): proved 14.01, -; measured 0.51. */
SF_KERNEL void off_centre_up(double k, double A, double a, double span, double L_2, double L_1, double M_2, double M_1, double *out) {
    const double t0 = 2.0 * k;
    const double t1 = k + 1.0;
    out[0] = (-L_1 * a * (t0 - 1.0) + L_2 * span) / (k * k);
    out[1] = (2.0 * A * L_1 - M_1 * a * (t0 + 1.0) + M_2 * span) / (t1 * t1);
}

/* L_(k-2) and M_(k-2) from the two above each.
   Equation the mean of (3). Domain: root > 0. Operations: 21. Error / u (1 + kappa): proved 14.01, -; measured
   0.72. */
SF_KERNEL void off_centre_down(double k, double A, double a, double root, double L_1, double L_k, double M_1, double M_k, double *out) {
    const double t0 = 1.0 / (root * root);
    const double t1 = 2.0 * k;
    const double t2 = k + 1.0;
    out[0] = t0 * (L_1 * a * (t1 - 1.0) + L_k * k * k);
    out[1] = t0 * (-2.0 * A * L_1 + M_1 * a * (t1 + 1.0) + M_k * t2 * t2);
}

#endif
