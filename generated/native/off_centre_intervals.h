/* Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle: on whole intervals.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/asymmetric/off_centre.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef OFF_CENTRE_INTERVALS_H
#define OFF_CENTRE_INTERVALS_H

#include "interval.h"

/* Slopes of s_0 by coordinates x and y of the motion's ends, and of c_x by y.
   Equation the mean of (3). Domain: A > 0. */
static inline void off_centre_intervals_ended_slopes(sf_interval A, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval X, sf_interval Y, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(A);
    const sf_interval t1 = sfi_mul(s_0, t0);
    out[0] = sfi_add(sfi_neg(sfi_mul(X, t1)), c_x);
    out[1] = sfi_sub(sfi_neg(sfi_mul(Y, t1)), c_y);
    out[2] = sfi_times(0.5, sfi_mul(t0, sfi_sub(sfi_neg(sfi_mul(X, c_y)), sfi_mul(Y, c_x))));
}

/* L_-1, L_0, M_-1, M_0 of a step at B + a that the motion passes at psi = angle.
   Equation the mean of (3). Domain: root = sqrt(A^2 - a^2). */
static inline void off_centre_intervals_begin(sf_interval A, sf_interval a, sf_interval root, sf_interval angle, sf_interval *out)
{
    const sf_interval t0 = sfi_div(sfi_around(0.31830988618379069), root);
    const sf_interval t1 = sfi_inverse(A);
    out[0] = t0;
    out[1] = sfi_mul(sfi_around(0.31830988618379069), angle);
    out[2] = sfi_mul(sfi_mul(a, t0), t1);
    out[3] = sfi_mul(sfi_around(0.31830988618379069), sfi_mul(root, t1));
}

/* L_(k-2) and M_(k-2) from the two above each.
   Equation the mean of (3). Domain: root > 0. */
static inline void off_centre_intervals_down(sf_interval k, sf_interval A, sf_interval a, sf_interval root, sf_interval L_1, sf_interval L_k, sf_interval M_1, sf_interval M_k, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(sfi_square(root));
    const sf_interval t1 = sfi_times(2.0, k);
    const sf_interval t2 = sfi_add(k, sfi_point(1.0));
    out[0] = sfi_mul(t0, sfi_add(sfi_mul(sfi_mul(L_1, a), sfi_sub(t1, sfi_point(1.0))), sfi_mul(L_k,
        sfi_square(k))));
    out[1] = sfi_mul(t0, sfi_add(sfi_add(sfi_neg(sfi_times(2.0, sfi_mul(A, L_1))), sfi_mul(sfi_mul(M_1, a),
        sfi_add(t1, sfi_point(1.0)))), sfi_mul(M_k, sfi_square(t2))));
}

#endif
