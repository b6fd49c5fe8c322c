/* Stationary random vibration by statistical linearization.

   Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/extensions/linearization.py;
   never edit.

   What arguments and comments mean is in inline.h. */

#ifndef LINEARIZATION_H
#define LINEARIZATION_H

#include <math.h>

#include "inline.h"

/* Friction and viscous damping ratio in the mean over u, then their slopes by ln(sigma_u).
   Equation (3). Domain: level > 0, sigma_u > 0. Operations: 11. */
SF_KERNEL void linearization_over_displacements(double level, double within, double sigma_u, double mu, double zeta, double zeta_2, double *out) {
    const double t0 = sigma_u * sigma_u * zeta_2;
    out[0] = mu * within;
    out[1] = t0 + zeta;
    out[2] = -0.79788456080286541 * level * mu * exp(-0.5 * level * level);
    out[3] = 2.0 * t0;
}

/* Damping of the linear oscillator, its slope by ln(sigma_v), and what of it is dry friction's.
   Equation (3). Domain: sigma_v > 0. Operations: 14. */
SF_KERNEL void linearization_equivalent_damping(double sigma_v, double mu, double zeta, double c_2, double c_3, double *out) {
    const double t0 = c_3 * sigma_v * sigma_v;
    const double t1 = 1.5957691216057308 * c_2 * sigma_v;
    const double t2 = 0.79788456080286541 * mu / sigma_v;
    out[0] = 3.0 * t0 + t1 + t2 + 2.0 * zeta;
    out[1] = 6.0 * t0 + t1 - t2;
    out[2] = t2;
}

/* Mean square of the damping force of (3).
   Equation (3). Domain: level > 0. Operations: 65. */
SF_KERNEL double linearization_damping_force(double level, double within, double sigma_u, double sigma_v, double mu, double zeta, double c_2, double c_3, double zeta_2) {
    const double t0 = 0.79788456080286541 * c_2;
    const double t1 = 12.0 * c_3;
    const double sigma_u2 = sigma_u * sigma_u;
    const double t2 = sigma_u2 * zeta_2;
    const double t3 = mu * within;
    const double t4 = 8.0 * zeta;
    const double t5 = 3.1915382432114616 * t3;
    const double t6 = 8.0 * t2;
    const double sigma_v2 = sigma_v * sigma_v;
    const double sigma_u4 = sigma_u2 * sigma_u2;
    const double sigma_v3 = sigma_v * sigma_v2;
    const double sigma_v4 = sigma_v2 * sigma_v2;
    const double sigma_v6 = sigma_v3 * sigma_v3;
    const double sigma_v5 = sigma_v * sigma_v4;
    return 15.0 * c_3 * c_3 * sigma_v6 + 16.0 * c_3 * sigma_v5 * t0 + mu * mu * within + sigma_v *
        (-0.31830988618379069 * level * mu * t6 * exp(-0.5 * level * level) + t2 * t5 + t5 * zeta) + sigma_v2 * (2.0
        * c_2 * t3 + 12.0 * sigma_u4 * zeta_2 * zeta_2 + t2 * t4 + 4.0 * zeta * zeta) + sigma_v3 * (c_3 * t5 + t0 *
        t4 + t0 * t6) + sigma_v4 * (3.0 * c_2 * c_2 + t1 * t2 + t1 * zeta);
}

/* Z, and the slopes of -ln Z by ln k and ln c.
   Equation (3). Domain: Omega > 0, k > 0, c > 0. Operations: 10. */
SF_KERNEL void linearization_response(double Omega, double k, double c, double *out) {
    const double t0 = Omega * Omega;
    const double t1 = c * c * t0;
    const double t2 = k - t0;
    const double Z = t1 + t2 * t2;
    const double t3 = 2.0 / Z;
    out[0] = Z;
    out[1] = -k * t2 * t3;
    out[2] = -t1 * t3;
}

/* Of the slope of -ln Z by ln k the least and the largest, and the largest k^2/Z, at any frequency.
   Equation (3). Domain: 0 < ratio < 1/2. Operations: 11. */
SF_KERNEL void linearization_steepest(double ratio, double *out) {
    const double t0 = 1.0 / (ratio - 1.0);
    const double t1 = 0.5 / ratio;
    const double t2 = 1.0 / (ratio + 1.0);
    out[0] = t0 * t1;
    out[1] = t1 * t2;
    out[2] = -0.25 * t0 * t2 / (ratio * ratio);
}

/* What a pole of 1/Z adds to I_0, its slopes by ln k and ln c, then to I_2 and its slopes.
   Equation (3). Domain: 0 < theta < pi/2, k > 0, c > 0. Operations: 94. */
SF_KERNEL void linearization_resonance(double theta, double k, double c, double slope, double G, double E_re, double E_im, double D_re, double D_im, double *out) {
    const double t0 = theta * (slope - 1.0);
    const double t1 = cos(t0);
    const double t2 = sin(t0);
    const double t3 = cos(theta);
    const double t4 = 1.0 / t3;
    const double t5 = 0.5 * G * t4 / c;
    const double t6 = t5 / k;
    const double t7 = sin(theta);
    const double t8 = t4 * t7;
    const double t9 = E_re * t8;
    const double t10 = 0.5 * t9;
    const double t11 = 0.5 * D_re;
    const double t12 = 1.0 / (t3 * t3);
    const double t13 = t7 * t7;
    const double t14 = t12 * t13;
    const double t15 = E_im * t14;
    const double t16 = 0.5 * slope;
    const double t17 = E_re * t16;
    const double t18 = -0.5 * D_im - 0.5 * E_im * slope + t11 * t8 + 0.5 * t15 + t17 * t8;
    const double t19 = E_im * t8;
    const double t20 = 0.5 * t19;
    const double t21 = 0.5 * D_im * t8 + E_im * t16 * t8 - 0.5 * E_re * t14 + t11 + t17;
    const double t22 = D_re * t8 - E_im + slope * t9 + t15;
    const double t23 = D_im * t8 - E_re * t12 * t13 + E_re + slope * t19;
    const double t24 = theta * (slope + 1.0);
    const double t25 = cos(t24);
    const double t26 = sin(t24);
    out[0] = t6 * (E_im * t1 + E_re * t2);
    out[1] = t6 * (t1 * (-E_im + t10 - t18) + t2 * (-E_re - t20 + t21));
    out[2] = t6 * (t1 * (t22 - t9) + t2 * (t19 - t23));
    out[3] = t5 * (E_im * t25 + E_re * t26);
    out[4] = t5 * (t25 * (-t10 - t18) + t26 * (t20 + t21));
    out[5] = t5 * (t25 * (t22 + t9) + t26 * (-t19 - t23));
}

#endif
