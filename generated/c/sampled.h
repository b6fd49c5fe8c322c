/* The average of a force that is known by its values and those of its derivatives, u = A sine.

   Written by `make derive` from derivations/forces/quadrature.py, derivations/forces/sampled.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef SAMPLED_H
#define SAMPLED_H

#include <math.h>

#include "inline.h"

#include "arithmetic_doubles.h"
#define OF(name) sampled_##name
#include "sampled_generic.h"
#include "arithmetic_end.h"

/* h as A tends to 0.
   Equation (20). Domain: any. Operations: 1. Error / u (1 + kappa): measured 0.73. */
SF_KERNEL double sampled_at_rest(double f) {
    return -1.2732395447351628 * f;
}

/* Under the integrals of h, h_A, h_AA, h_AAA over the quarter cycle.
   Equation (20)-(22), (31). Domain: any. Operations: 11. Error / u (1 + kappa): measured 0.66. */
SF_KERNEL void sampled_averaged_terms(double sine, double f, double f_u, double f_uu, double f_uuu, double *out) {
    const double sine2 = sine * sine;
    const double sine3 = sine * sine2;
    const double sine4 = sine2 * sine2;
    out[0] = -1.2732395447351628 * f * sine;
    out[1] = -1.2732395447351628 * f_u * sine2;
    out[2] = -1.2732395447351628 * f_uu * sine3;
    out[3] = -1.2732395447351628 * f_uuu * sine4;
}

/* What a breakpoint adds to h_A, h_AA, h_AAA.
   Equation (21), (22), (31). Domain: A > b > 0. Operations: 49. Error / u (1 + kappa): measured 0.94. */
SF_KERNEL void sampled_averaged_end(double A, double b, double lost_0, double lost_1, double lost_2, double *out) {
    const double root = sqrt(A - b) * sqrt(A + b);
    const double A2 = A * A;
    const double t0 = 1.2732395447351628;
    const double t1 = t0 / root;
    const double b2 = b * b;
    const double t2 = b2 * lost_0;
    const double A3 = A * A2;
    const double t3 = 1.0 / A3;
    const double b3 = b * b2;
    const double t4 = b3 * lost_1;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double t5 = t0 / root3;
    const double A4 = A2 * A2;
    const double t6 = 1.0 / A4;
    const double b4 = b2 * b2;
    const double root4 = root2 * root2;
    const double root5 = root * root4;
    out[0] = t1 * t2 / A2;
    out[1] = t1 * t3 * t4 - t2 * t3 * t5 * (A2 + 2.0 * root2);
    out[2] = b4 * lost_2 * t1 * t6 - t4 * t5 * t6 * (A2 + 3.0 * root2) + 3.8197186342054881 * t2 * t6 * (A2 *
        root2 + A4 + 2.0 * root4) / root5;
}

/* Under the integral of h - A h_A, which `at_rest` adds to.
   Equation from (20). Domain: any. Operations: 6. Error / u (1 + kappa): measured 0.52. */
SF_KERNEL double sampled_intercept_terms(double A, double sine, double cosine, double f_uu) {
    return 1.2732395447351628 * A * A * cosine * cosine * f_uu * sine;
}

/* What a breakpoint adds to h - A h_A.
   Equation from (20). Domain: A > b > 0. Operations: 16. Error / u (1 + kappa): measured 2.7. */
SF_KERNEL double sampled_intercept_end(double A, double b, double lost_0, double lost_1) {
    const double root = sqrt(A - b) * sqrt(A + b);
    const double t0 = 1.0 / A;
    return 1.2732395447351628 * (-b * b * lost_0 * t0 / root + root * t0 * (-b * lost_1 + lost_0));
}

/* Under the integrals of h_3 and three derivatives, then of h_5.
   Equation beyond (20). Domain: any. Operations: 23. Error / u (1 + kappa): measured 1.4. */
SF_KERNEL void sampled_harmonics_terms(double sine, double f, double f_u, double f_uu, double f_uuu, double *out) {
    const double sine2 = sine * sine;
    const double T_2 = 2.0 * sine2 - 1.0;
    const double t0 = 2.0 * T_2;
    const double T_3 = sine * (t0 - 1.0);
    const double T_5 = T_3 * t0 - sine;
    const double t1 = 1.2732395447351628 * f;
    const double t2 = 1.2732395447351628 * T_3;
    const double t3 = f_u * sine;
    const double t4 = f_uu * sine2;
    const double sine3 = sine * sine2;
    const double t5 = f_uuu * sine3;
    const double t6 = 1.2732395447351628 * T_5;
    out[0] = -T_3 * t1;
    out[1] = -t2 * t3;
    out[2] = -t2 * t4;
    out[3] = -t2 * t5;
    out[4] = -T_5 * t1;
    out[5] = -t3 * t6;
    out[6] = -t4 * t6;
    out[7] = -t5 * t6;
}

/* What a breakpoint adds to the three derivatives of h_3, then of h_5.
   Equation beyond (20). Domain: A > b > 0. Operations: 156. Error / u (1 + kappa): measured 2.7. */
SF_KERNEL void sampled_harmonics_end(double A, double b, double lost_0, double lost_1, double lost_2, double *out) {
    const double root = sqrt(A - b) * sqrt(A + b);
    const double A2 = A * A;
    const double A4 = A2 * A2;
    const double b2 = b * b;
    const double t0 = 4.0 * b2 * lost_0;
    const double t1 = 0.31830988618379069 / root;
    const double t2 = t1 * (-3.0 * A2 + 4.0 * b2);
    const double A5 = A * A4;
    const double t3 = 1.0 / A5;
    const double t4 = 4.0 * t2;
    const double b3 = b * b2;
    const double t5 = b3 * lost_1;
    const double root2 = root * root;
    const double t6 = A2 * root2;
    const double t7 = -4.0 * A2 * b2 + 3.0 * A4;
    const double root3 = root * root2;
    const double t8 = 0.31830988618379069 / root3;
    const double t9 = t0 * t8;
    const double A3 = A * A2;
    const double A6 = A3 * A3;
    const double t10 = 1.0 / A6;
    const double b4 = b2 * b2;
    const double t11 = b4 * lost_2;
    const double t12 = 4.0 * t5;
    const double t13 = t12 * t8;
    const double root4 = root2 * root2;
    const double t14 = A2 * root4;
    const double t15 = A4 * root2;
    const double t16 = t0 * t10;
    const double root5 = root * root4;
    const double t17 = 0.31830988618379069 / root5;
    const double t18 = 16.0 * b4;
    const double t19 = t1 * (-20.0 * A2 * b2 + 5.0 * A4 + t18);
    const double A7 = A * A6;
    const double t20 = 1.0 / A7;
    const double t21 = b4 * root2;
    const double t22 = A2 * t18 - 20.0 * A4 * b2 + 5.0 * A6;
    const double A8 = A4 * A4;
    const double t23 = 1.0 / A8;
    out[0] = t0 * t2 / A4;
    out[1] = t3 * t4 * t5 - t3 * t9 * (16.0 * b2 * root2 - 6.0 * t6 - t7);
    out[2] = t10 * t11 * t4 - t10 * t13 * (20.0 * b2 * root2 - 9.0 * t6 - t7) + t16 * t17 * (28.0 * A2 * b2 *
        root2 + 12.0 * A4 * b2 - 9.0 * A6 + 80.0 * b2 * root4 - 18.0 * t14 - 9.0 * t15);
    out[3] = t16 * t19;
    out[4] = t12 * t19 * t20 - t20 * t9 * (-80.0 * b2 * t6 + 10.0 * t15 + 96.0 * t21 + t22);
    out[5] = t0 * t17 * t23 * (-140.0 * A4 * b2 * root2 + 48.0 * A4 * b4 + 30.0 * A4 * root4 - 60.0 * A6 * b2 +
        15.0 * A6 * root2 + 15.0 * A8 - 400.0 * b2 * t14 + 672.0 * b4 * root4 + 176.0 * b4 * t6) + 4.0 * t11 * t19 *
        t23 - t13 * t23 * (-100.0 * b2 * t6 + 15.0 * t15 + 112.0 * t21 + t22);
}

#endif
