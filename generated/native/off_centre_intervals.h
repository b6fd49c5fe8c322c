/* Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle: on whole intervals.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/off_centre.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of off_centre.h. */

#ifndef OFF_CENTRE_INTERVALS_H
#define OFF_CENTRE_INTERVALS_H

#include "interval.h"

/* What vanishes at a steady state, by coordinates x and y of the motion's ends: the balance of the mean and F; slopes of each by x and y. */
static inline void off_centre_intervals_ended_state(sf_interval Omega, sf_interval A, sf_interval force, sf_interval I_, sf_interval I_A, sf_interval load, sf_interval c_0, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval X, sf_interval Y, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, s_0);
    const sf_interval t1 = sfi_square(Omega);
    const sf_interval R = sfi_sub(sfi_mul(A, t1), t0);
    const sf_interval t2 = sfi_times(2.0, sfi_mul(I_, I_A));
    const sf_interval t3 = sfi_div(t0, A);
    const sf_interval t4 = sfi_times(2.0, R);
    out[0] = sfi_sub(c_0, load);
    out[1] = sfi_sub(sfi_add(sfi_square(I_), sfi_square(R)), sfi_square(force));
    out[2] = c_x;
    out[3] = c_y;
    out[4] = sfi_add(sfi_mul(X, t2), sfi_mul(t4, sfi_sub(sfi_add(sfi_mul(X, t1), sfi_mul(X, t3)), sfi_times(2.0,
        c_x))));
    out[5] = sfi_add(sfi_mul(Y, t2), sfi_mul(t4, sfi_add(sfi_add(sfi_mul(Y, t1), sfi_mul(Y, t3)), sfi_times(2.0,
        c_y))));
}

/* Along the balance, by coordinates of the motion's ends: A's slope, and what F_A gains there by R. */
static inline void off_centre_intervals_ended_along(sf_interval A, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval X, sf_interval Y, sf_interval *out)
{
    const sf_interval t0 = sfi_add(sfi_neg(sfi_mul(X, c_y)), sfi_mul(Y, c_x));
    out[0] = t0;
    out[1] = sfi_add(sfi_mul(sfi_mul(A, c_x), c_y), sfi_mul(s_0, t0));
}

/* Slopes of s_0 by coordinates x and y of the motion's ends, and of c_x by y. */
static inline void off_centre_intervals_ended_slopes(sf_interval A, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval X, sf_interval Y, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(A);
    const sf_interval t1 = sfi_mul(s_0, t0);
    out[0] = sfi_add(sfi_neg(sfi_mul(X, t1)), c_x);
    out[1] = sfi_sub(sfi_neg(sfi_mul(Y, t1)), c_y);
    out[2] = sfi_times(0.5, sfi_mul(t0, sfi_sub(sfi_neg(sfi_mul(X, c_y)), sfi_mul(Y, c_x))));
}

/* What vanishes at a fold, by R, with the force F_0 + F_2 Omega^2, by coordinates x and y of the motion's ends: the balance, F along it times A/2, and F; slopes of each by x, y and R. */
static inline void off_centre_intervals_ended_fold(sf_interval R, sf_interval A, sf_interval F_0, sf_interval F_2, sf_interval m, sf_interval eta, sf_interval zeta, sf_interval d, sf_interval load, sf_interval c_0, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval c_xx, sf_interval c_yy, sf_interval X, sf_interval Y, sf_interval X_x, sf_interval Y_y, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(A);
    const sf_interval t1 = sfi_add(R, sfi_times(2.0, s_0));
    const sf_interval square = sfi_mul(t0, t1);
    const sf_interval speed = sfi_mul(sfi_sqrt(A), sfi_sqrt(t1));
    const sf_interval force = sfi_add(F_0, sfi_mul(F_2, square));
    const sf_interval t2 = sfi_times(2.0, zeta);
    const sf_interval t3 = sfi_mul(d, sfi_square(speed));
    const sf_interval I_ = sfi_add(sfi_add(sfi_add(sfi_mul(A, eta), m), sfi_mul(speed, t2)), t3);
    const sf_interval drift = sfi_add(sfi_neg(m), t3);
    const sf_interval t4 = sfi_square(force);
    const sf_interval t5 = sfi_add(sfi_mul(I_, drift), t4);
    const sf_interval t6 = sfi_mul(X, c_y);
    const sf_interval t7 = sfi_mul(Y, c_x);
    const sf_interval t8 = sfi_add(sfi_neg(t6), t7);
    const sf_interval t9 = sfi_times(4.0, A);
    const sf_interval t10 = sfi_mul(c_y, t9);
    const sf_interval t11 = sfi_times(4.0, s_0);
    const sf_interval t12 = sfi_add(sfi_mul(c_x, t10), sfi_mul(t11, t8));
    const sf_interval t13 = sfi_times(4.0, t6);
    const sf_interval t14 = sfi_mul(R, t11);
    const sf_interval t15 = sfi_times(2.0, A);
    const sf_interval t16 = sfi_add(sfi_mul(R, X), sfi_mul(c_x, t15));
    const sf_interval t17 = sfi_mul(sfi_mul(I_, d), t8);
    const sf_interval t18 = sfi_mul(s_0, t0);
    const sf_interval t19 = sfi_add(sfi_neg(sfi_mul(X, t18)), c_x);
    const sf_interval t20 = sfi_mul(R, sfi_sub(sfi_times(4.0, sfi_mul(Y, c_x)), t13));
    const sf_interval t21 = sfi_add(sfi_mul(R, sfi_add(sfi_mul(Y, t11), t10)), sfi_mul(Y, t5));
    const sf_interval t22 = sfi_div(sfi_add(sfi_times(2.0, sfi_mul(d, speed)), t2), speed);
    const sf_interval t23 = sfi_times(0.5, t22);
    const sf_interval t24 = sfi_add(sfi_mul(X, eta), sfi_mul(t16, t23));
    const sf_interval t25 = sfi_mul(drift, t8);
    const sf_interval t26 = sfi_sub(sfi_mul(R, sfi_add(sfi_neg(sfi_mul(X, t11)), sfi_mul(c_x, t9))), sfi_mul(X, t5));
    const sf_interval t27 = sfi_times(0.5, sfi_mul(t0, sfi_sub(sfi_neg(t6), t7)));
    const sf_interval t28 = sfi_div(t1, sfi_square(A));
    const sf_interval t29 = sfi_times(2.0, t0);
    const sf_interval t30 = sfi_mul(F_2, force);
    const sf_interval t31 = sfi_times(2.0, t30);
    const sf_interval t32 = sfi_mul(t31, sfi_add(sfi_neg(sfi_mul(X, t28)), sfi_mul(t19, t29)));
    const sf_interval t33 = sfi_sub(sfi_mul(R, Y), sfi_mul(c_y, t15));
    const sf_interval t34 = sfi_sub(sfi_neg(sfi_mul(Y, t18)), c_y);
    const sf_interval t35 = sfi_add(sfi_mul(Y, eta), sfi_mul(t23, t33));
    const sf_interval t36 = sfi_mul(t31, sfi_add(sfi_neg(sfi_mul(Y, t28)), sfi_mul(t29, t34)));
    const sf_interval t37 = sfi_mul(t29, t30);
    out[0] = sfi_sub(c_0, load);
    out[1] = sfi_add(sfi_mul(R, t12), sfi_mul(t5, t8));
    out[2] = sfi_sub(sfi_add(sfi_square(I_), sfi_square(R)), t4);
    out[3] = c_x;
    out[4] = c_y;
    out[5] = sfi_point(0.0);
    out[6] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(R, c_x), t13), sfi_mul(X_x,
        sfi_sub(sfi_neg(sfi_mul(c_y, t14)), sfi_mul(c_y, t5)))), sfi_mul(c_xx, t21)), sfi_mul(t16, t17)),
        sfi_mul(t19, t20)), sfi_mul(t24, t25)), sfi_mul(t26, t27)), sfi_mul(t32, t8));
    out[7] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(4.0, sfi_mul(sfi_mul(R, c_y), t7)),
        sfi_mul(Y_y, sfi_add(sfi_mul(c_x, t14), sfi_mul(c_x, t5)))), sfi_mul(c_yy, t26)), sfi_mul(t17, t33)),
        sfi_mul(t20, t34)), sfi_mul(t21, t27)), sfi_mul(t25, t35)), sfi_mul(t36, t8));
    out[8] = sfi_add(sfi_add(sfi_add(sfi_mul(A, t17), sfi_mul(sfi_mul(A, t23), t25)), t12), sfi_mul(t37, t8));
    out[9] = sfi_sub(sfi_times(2.0, sfi_mul(I_, t24)), t32);
    out[10] = sfi_sub(sfi_times(2.0, sfi_mul(I_, t35)), t36);
    out[11] = sfi_sub(sfi_add(sfi_mul(sfi_mul(A, I_), t22), sfi_times(2.0, R)), t37);
}

/* (c_1^2 - s_1^2)/c_1 of an odd force without a load where f_0 = 0 and B is not 0, with c_3 and s_2 of some B between 0 and there. */
static inline sf_interval off_centre_intervals_beside(sf_interval B, sf_interval c_3, sf_interval s_2)
{
    return sfi_sub(sfi_mul(sfi_around(0.33333333333333331), sfi_mul(sfi_square(B), c_3)), sfi_div(sfi_times(3.0,
        sfi_square(s_2)), c_3));
}

/* L_-1, L_0, M_-1, M_0 of a step at B + a that the motion passes at psi = angle. */
static inline void off_centre_intervals_begin(sf_interval A, sf_interval a, sf_interval root, sf_interval angle, sf_interval *out)
{
    const sf_interval t0 = sfi_div(sfi_around(0.31830988618379069), root);
    const sf_interval t1 = sfi_inverse(A);
    out[0] = t0;
    out[1] = sfi_mul(sfi_around(0.31830988618379069), angle);
    out[2] = sfi_mul(sfi_mul(a, t0), t1);
    out[3] = sfi_mul(sfi_around(0.31830988618379069), sfi_mul(root, t1));
}

/* L_(k-2) and M_(k-2) from the two above each. */
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
