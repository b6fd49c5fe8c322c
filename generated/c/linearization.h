/* Stationary random vibration by statistical linearization.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/paper/equation_of_motion.py, derivations/extensions/linearization.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are those in floating point. Bounds of rounding errors, output by output, are proved for all arguments
   where nothing overflows or underflows (derivations/codegen/rounding.py).
   u = 2^-53, kappa is the relative condition number of an output in all arguments. */

#ifndef LINEARIZATION_H
#define LINEARIZATION_H

#include <math.h>

#include "inline.h"

/* Damping of the linear oscillator, its slope by ln(sigma_v), and what of it is dry friction's.
   Equation (3). Domain: sigma_v > 0. Operations: 8. */
SF_KERNEL void linearization_equivalent_damping(double sigma_v, double mu, double zeta, double c_2, double *out)
{
    const double t0 = 1.5957691216057308 * c_2 * sigma_v;
    const double t1 = 0.79788456080286541 * mu / sigma_v;
    out[0] = t0 + t1 + 2.0 * zeta;
    out[1] = t0 - t1;
    out[2] = t1;
}

/* Z, and the slopes of -ln Z by ln k and ln c.
   Equation (3). Domain: Omega > 0, k > 0, c > 0. Operations: 10. */
SF_KERNEL void linearization_response(double Omega, double k, double c, double *out)
{
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
SF_KERNEL void linearization_steepest(double ratio, double *out)
{
    const double t0 = 1.0 / (ratio - 1.0);
    const double t1 = 0.5 / ratio;
    const double t2 = 1.0 / (ratio + 1.0);
    out[0] = t0 * t1;
    out[1] = t1 * t2;
    out[2] = -0.25 * t0 * t2 / (ratio * ratio);
}

#endif
