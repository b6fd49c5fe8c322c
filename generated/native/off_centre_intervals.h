/* Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle: on whole intervals.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/off_centre.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of off_centre.h. */

#ifndef OFF_CENTRE_INTERVALS_H
#define OFF_CENTRE_INTERVALS_H

#include "interval.h"
#include "arithmetic_intervals.h"

/* What vanishes at a steady state, by coordinates x and y of the motion's ends: the balance of the mean and F; slopes of each by x and y. */
static inline void off_centre_intervals_ended_state(sf_interval Omega, sf_interval A, sf_interval force, sf_interval I_, sf_interval I_A, sf_interval load, sf_interval c_0, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval X, sf_interval Y, sf_interval *out) {
    const sf_interval t0 = TIMES(2.0, s_0);
    const sf_interval t1 = SQUARE(Omega);
    const sf_interval R = SUB(MUL(A, t1), t0);
    const sf_interval t2 = TIMES(2.0, MUL(I_, I_A));
    const sf_interval t3 = DIV(t0, A);
    const sf_interval t4 = TIMES(2.0, R);
    out[0] = SUB(c_0, load);
    out[1] = SUB(ADD(SQUARE(I_), SQUARE(R)), SQUARE(force));
    out[2] = c_x;
    out[3] = c_y;
    out[4] = ADD(MUL(X, t2), MUL(t4, SUB(ADD(MUL(X, t1), MUL(X, t3)), TIMES(2.0, c_x))));
    out[5] = ADD(MUL(Y, t2), MUL(t4, ADD(ADD(MUL(Y, t1), MUL(Y, t3)), TIMES(2.0, c_y))));
}

/* Along the balance, by coordinates of the motion's ends: A's slope, and what F_A gains there by R. */
static inline void off_centre_intervals_ended_along(sf_interval A, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval X, sf_interval Y, sf_interval *out) {
    const sf_interval t0 = ADD(NEG(MUL(X, c_y)), MUL(Y, c_x));
    out[0] = t0;
    out[1] = ADD(MUL(MUL(A, c_x), c_y), MUL(s_0, t0));
}

/* Slopes of s_0 by coordinates x and y of the motion's ends, and of c_x by y. */
static inline void off_centre_intervals_ended_slopes(sf_interval A, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval X, sf_interval Y, sf_interval *out) {
    const sf_interval t0 = INVERSE(A);
    const sf_interval t1 = MUL(s_0, t0);
    out[0] = ADD(NEG(MUL(X, t1)), c_x);
    out[1] = SUB(NEG(MUL(Y, t1)), c_y);
    out[2] = TIMES(0.5, MUL(t0, SUB(NEG(MUL(X, c_y)), MUL(Y, c_x))));
}

/* What vanishes at a fold, by R, with the force F_0 + F_2 Omega^2, by coordinates x and y of the motion's ends: the balance, F along it times A/2, and F; slopes of each by x, y and R. */
static inline void off_centre_intervals_ended_fold(sf_interval R, sf_interval A, sf_interval F_0, sf_interval F_2, sf_interval m, sf_interval eta, sf_interval zeta, sf_interval d, sf_interval load, sf_interval c_0, sf_interval s_0, sf_interval c_x, sf_interval c_y, sf_interval c_xx, sf_interval c_yy, sf_interval X, sf_interval Y, sf_interval X_x, sf_interval Y_y, sf_interval *out) {
    const sf_interval t0 = INVERSE(A);
    const sf_interval t1 = ADD(R, TIMES(2.0, s_0));
    const sf_interval square = MUL(t0, t1);
    const sf_interval speed = MUL(SQRT(A), SQRT(t1));
    const sf_interval force = ADD(F_0, MUL(F_2, square));
    const sf_interval t2 = TIMES(2.0, zeta);
    const sf_interval t3 = MUL(d, SQUARE(speed));
    const sf_interval I_ = ADD(ADD(ADD(MUL(A, eta), m), MUL(speed, t2)), t3);
    const sf_interval drift = ADD(NEG(m), t3);
    const sf_interval t4 = SQUARE(force);
    const sf_interval t5 = ADD(MUL(I_, drift), t4);
    const sf_interval t6 = MUL(X, c_y);
    const sf_interval t7 = MUL(Y, c_x);
    const sf_interval t8 = ADD(NEG(t6), t7);
    const sf_interval t9 = TIMES(4.0, A);
    const sf_interval t10 = MUL(c_y, t9);
    const sf_interval t11 = TIMES(4.0, s_0);
    const sf_interval t12 = ADD(MUL(c_x, t10), MUL(t11, t8));
    const sf_interval t13 = TIMES(4.0, t6);
    const sf_interval t14 = MUL(R, t11);
    const sf_interval t15 = TIMES(2.0, A);
    const sf_interval t16 = ADD(MUL(R, X), MUL(c_x, t15));
    const sf_interval t17 = MUL(MUL(I_, d), t8);
    const sf_interval t18 = MUL(s_0, t0);
    const sf_interval t19 = ADD(NEG(MUL(X, t18)), c_x);
    const sf_interval t20 = MUL(R, SUB(TIMES(4.0, MUL(Y, c_x)), t13));
    const sf_interval t21 = ADD(MUL(R, ADD(MUL(Y, t11), t10)), MUL(Y, t5));
    const sf_interval t22 = DIV(ADD(TIMES(2.0, MUL(d, speed)), t2), speed);
    const sf_interval t23 = TIMES(0.5, t22);
    const sf_interval t24 = ADD(MUL(X, eta), MUL(t16, t23));
    const sf_interval t25 = MUL(drift, t8);
    const sf_interval t26 = SUB(MUL(R, ADD(NEG(MUL(X, t11)), MUL(c_x, t9))), MUL(X, t5));
    const sf_interval t27 = TIMES(0.5, MUL(t0, SUB(NEG(t6), t7)));
    const sf_interval t28 = DIV(t1, SQUARE(A));
    const sf_interval t29 = TIMES(2.0, t0);
    const sf_interval t30 = MUL(F_2, force);
    const sf_interval t31 = TIMES(2.0, t30);
    const sf_interval t32 = MUL(t31, ADD(NEG(MUL(X, t28)), MUL(t19, t29)));
    const sf_interval t33 = SUB(MUL(R, Y), MUL(c_y, t15));
    const sf_interval t34 = SUB(NEG(MUL(Y, t18)), c_y);
    const sf_interval t35 = ADD(MUL(Y, eta), MUL(t23, t33));
    const sf_interval t36 = MUL(t31, ADD(NEG(MUL(Y, t28)), MUL(t29, t34)));
    const sf_interval t37 = MUL(t29, t30);
    out[0] = SUB(c_0, load);
    out[1] = ADD(MUL(R, t12), MUL(t5, t8));
    out[2] = SUB(ADD(SQUARE(I_), SQUARE(R)), t4);
    out[3] = c_x;
    out[4] = c_y;
    out[5] = POINT(0.0);
    out[6] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(MUL(MUL(R, c_x), t13), MUL(X_x, SUB(NEG(MUL(c_y, t14)), MUL(c_y, t5)))),
        MUL(c_xx, t21)), MUL(t16, t17)), MUL(t19, t20)), MUL(t24, t25)), MUL(t26, t27)), MUL(t32, t8));
    out[7] = ADD(ADD(ADD(ADD(ADD(ADD(ADD(TIMES(4.0, MUL(MUL(R, c_y), t7)), MUL(Y_y, ADD(MUL(c_x, t14), MUL(c_x,
        t5)))), MUL(c_yy, t26)), MUL(t17, t33)), MUL(t20, t34)), MUL(t21, t27)), MUL(t25, t35)), MUL(t36, t8));
    out[8] = ADD(ADD(ADD(MUL(A, t17), MUL(MUL(A, t23), t25)), t12), MUL(t37, t8));
    out[9] = SUB(TIMES(2.0, MUL(I_, t24)), t32);
    out[10] = SUB(TIMES(2.0, MUL(I_, t35)), t36);
    out[11] = SUB(ADD(MUL(MUL(A, I_), t22), TIMES(2.0, R)), t37);
}

/* (c_1^2 - s_1^2)/c_1 of an odd force without a load where f_0 = 0 and B is not 0, with c_3 and s_2 of some B between 0 and there. */
static inline sf_interval off_centre_intervals_beside(sf_interval B, sf_interval c_3, sf_interval s_2) {
    return SUB(MUL(CONSTANT(0.33333333333333331, 1.8503717077085941e-17), MUL(SQUARE(B), c_3)), DIV(TIMES(3.0,
        SQUARE(s_2)), c_3));
}

/* L_-1, L_0, M_-1, M_0 of a step at B + a that the motion passes at psi = angle. */
static inline void off_centre_intervals_begin(sf_interval A, sf_interval a, sf_interval root, sf_interval angle, sf_interval *out) {
    const sf_interval t0 = DIV(CONSTANT(0.31830988618379069, -1.9678676675182486e-17), root);
    const sf_interval t1 = INVERSE(A);
    out[0] = t0;
    out[1] = MUL(CONSTANT(0.31830988618379069, -1.9678676675182486e-17), angle);
    out[2] = MUL(MUL(a, t0), t1);
    out[3] = MUL(CONSTANT(0.31830988618379069, -1.9678676675182486e-17), MUL(root, t1));
}

/* L_(k-2) and M_(k-2) from the two above each. */
static inline void off_centre_intervals_down(sf_interval k, sf_interval A, sf_interval a, sf_interval root, sf_interval L_1, sf_interval L_k, sf_interval M_1, sf_interval M_k, sf_interval *out) {
    const sf_interval t0 = INVERSE(SQUARE(root));
    const sf_interval t1 = TIMES(2.0, k);
    const sf_interval t2 = ADD(k, POINT(1.0));
    out[0] = MUL(t0, ADD(MUL(MUL(L_1, a), SUB(t1, POINT(1.0))), MUL(L_k, SQUARE(k))));
    out[1] = MUL(t0, ADD(ADD(NEG(TIMES(2.0, MUL(A, L_1))), MUL(MUL(M_1, a), ADD(t1, POINT(1.0)))), MUL(M_k,
        SQUARE(t2))));
}

#include "arithmetic_end.h"
#endif
