/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr.

   Written by `make derive` from derivations/mechanisms/rod_spring.py; never edit.

   What arguments and comments mean is in inline.h. Regimes: passed_n where A exceeds n breakpoints, far_k where it
   exceeds k of them 21/20 times. */

#ifndef ROD_SPRING_H
#define ROD_SPRING_H

#include <math.h>

#include "inline.h"
#include "angles.h"
#include "slow_flow.h"

SF_FAMILY_BEGIN

/* alpha, beta, gamma, u_cr */
#define ROD_SPRING_PARAMETERS 4
#define ROD_SPRING_BREAKPOINTS 1

/* What averaged_passed_1_far_1, averaged_2_passed_1_far_1, averaged_H_passed_1_far_1, intercept_passed_1_far_1,
   by_parameter_passed_1_far_1 have in common. */
SF_COMMON void rod_spring_common_1(double A, double u_cr, double *root_out, double *x_out, double *y_out,
    double *M8_out, double *M6_out) {
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t0 = 1.0 / A;
    const double x = t0 * u_cr;
    const double y = root * t0;
    const double x2 = x * x;
    const double s = x / sqrt(2.0 * y + 2.0);
    const double s2 = s * s;
    const double s4 = s2 * s2;
    const double s8 = s4 * s4;
    const double s9 = s * s8;
    const double M8 = s9 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (3.6963081749325447e-05
        * s4 + 6.2301919302519632e-05) + 0.00011102157704373623) + 0.00021201233531153478) + 0.00044230925731169869)
        + 0.00103759765625) + 0.0028666834677419355) + 0.010127314814814815) + 0.05434782608695652) +
        0.73684210526315785) - 74.666666666666671) - 162.90909090909091) + s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (s4 * (s4 * (s4 * (s4 * (2.8978731853911948e-05 * s4 + 4.7688218677100145e-05) + 8.2529815179961072e-05) +
        0.00015194217363993326) + 0.00030240198461020863) + 0.00066602552259290536) + 0.0016830906723484848) +
        0.0051858836206896556) + 0.021874999999999999) + 0.16666666666666666) + 8.235294117647058) +
        172.30769230769232) + 56.888888888888886);
    const double x3 = x * x2;
    const double x6 = x3 * x3;
    const double x7 = x * x6;
    const double M6 = 1.1428571428571428 * M8 + 0.14285714285714285 * x7 * y;
    *root_out = root;
    *x_out = x;
    *y_out = y;
    *M8_out = M8;
    *M6_out = M6;
}

/* The outputs of harmonics_passed_1, harmonics_passed_1_far_1. */
SF_COMMON void rod_spring_common_2(double A, double W3_3, double W3_5, double W5_3, double W5_5, double alpha,
    double beta, double gamma, double root, double u_cr, double x, double y, double *result_0, double *result_1,
    double *result_2, double *result_3, double *result_4, double *result_5, double *result_6, double *result_7) {
    const double t0 = 1.0 / A;
    const double x2 = x * x;
    const double x3 = x * x2;
    const double t1 = x3 * y;
    const double W3_1 = -t1;
    const double W5_1 = -t1 * (2.6666666666666665 * x2 - 1.6666666666666667);
    const double t3 = alpha - 1.0;
    const double t4 = W3_1 * t3;
    const double A2 = A * A;
    const double t5 = W3_3 * beta;
    const double A4 = A2 * A2;
    const double t6 = A4 * gamma;
    const double t7 = W3_5 * t6;
    const double t8 = 1.2732395447351628 * A;
    const double t9 = 3.0 * beta;
    const double t10 = A2 * t9;
    const double t11 = 1.0 / A2;
    const double t12 = 1.0 / root;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    const double t13 = t11 * u_cr2;
    const double t14 = -4.0 * t13;
    const double t15 = -t14 - 3.0;
    const double t16 = gamma * u_cr2;
    const double t17 = t3 + u_cr2 * (beta + t16);
    const double t18 = 6.0 * t5;
    const double t19 = W3_5 * gamma;
    const double A3 = A * A2;
    const double t20 = 20.0 * A3;
    const double t21 = t17 * u_cr3;
    const double t22 = t12 * t21;
    const double t23 = 1.0 / A3;
    const double t24 = t15 * t23;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double t25 = 1.0 / root3;
    const double t26 = t21 * t25;
    const double t27 = t0 * t26;
    const double t28 = t14 + 1.0;
    const double t29 = -t3 - u_cr2 * (5.0 * t16 + t9);
    const double t30 = t12 * t29 * u_cr3;
    const double t31 = 60.0 * A2;
    const double t32 = 1.0 / A4;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double t33 = 10.0 * t16 + t9;
    const double t34 = t22 * t32;
    const double t35 = 3.0 * t28;
    const double t36 = t30 * t32;
    const double t37 = 3.0 / root2;
    const double t38 = W5_1 * t3;
    const double t39 = W5_3 * beta;
    const double t40 = W5_5 * t6;
    const double t41 = t32 * u_cr4;
    const double t42 = 16.0 * t41;
    const double t43 = -20.0 * t13 + t42 + 5.0;
    const double t44 = 6.0 * t39;
    const double t45 = W5_5 * gamma;
    const double t46 = t23 * t43;
    const double t47 = 12.0 * t11 * u_cr2 - t42 - 1.0;
    const double t48 = 5.0 * t47;
    *result_0 = -t8 * (A2 * t5 + t4 + t7);
    *result_1 = 1.2732395447351628 * (-W3_3 * t10 + t11 * t12 * t15 * t17 * u_cr3 - t4 - 5.0 * t7);
    *result_2 = 1.2732395447351628 * (-A * t18 + 3.0 * t12 * t17 * t23 * t28 * u_cr3 - t15 * t27 - t19 * t20 - t22 *
        t24 - t24 * t30);
    *result_3 = 1.2732395447351628 * (t11 * t15 * t25 * t29 * u_cr3 - t11 * t26 * t35 + 2.0 * t12 * t15 * t17 * t32
        * u_cr3 + 2.0 * t12 * t15 * t29 * t32 * u_cr3 + 2.0 * t12 * t15 * t32 * t33 * u_cr5 + 6.0 * t12 * t17 * t32
        * u_cr3 * (8.0 * t11 * u_cr2 - 1.0) - t18 - t19 * t31 - t26 * (-t11 * t15 + 3.0 * t11 * t28 - t15 * t37) -
        6.0 * t28 * t34 - t35 * t36);
    *result_4 = -t8 * (A2 * t39 + t38 + t40);
    *result_5 = 1.2732395447351628 * (-W5_3 * t10 + t11 * t12 * t17 * t43 * u_cr3 - t38 - 5.0 * t40);
    *result_6 = 1.2732395447351628 * (-A * t44 + 5.0 * t12 * t17 * t23 * t47 * u_cr3 - t20 * t45 - t22 * t46 - t27 *
        t43 - t30 * t46);
    *result_7 = 1.2732395447351628 * (t11 * t25 * t29 * t43 * u_cr3 - t11 * t26 * t48 + 2.0 * t12 * t17 * t32 * t43
        * u_cr3 + 10.0 * t12 * t17 * t32 * u_cr3 * (-24.0 * t13 + 48.0 * t41 + 1.0) + 2.0 * t12 * t29 * t32 * t43 *
        u_cr3 + 2.0 * t12 * t32 * t33 * t43 * u_cr5 - t26 * (-t11 * t43 + 5.0 * t11 * t47 - t37 * t43) - t31 * t45 -
        10.0 * t34 * t47 - t36 * t48 - t44);
}

/* h, h_A, h_AA, h_AAA together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 19 in passed_0, 116 in passed_1, 167 in passed_1_far_1.
   Error / u (1 + kappa): proved in passed_0 5.51, 4.51, 2.34, 1.51; measured 2.2. */
SF_KERNEL void rod_spring_averaged_passed_0(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = -alpha;
    const double t1 = A * A;
    const double t2 = gamma * t1;
    const double t3 = 4.5 * beta;
    out[0] = A * (t0 + t1 * (-0.75 * beta - 0.625 * t2));
    out[1] = t0 + t1 * (-2.25 * beta - 3.125 * t2);
    out[2] = A * (-12.5 * t2 - t3);
    out[3] = -37.5 * t2 - t3;
}

SF_KERNEL void rod_spring_averaged_passed_1(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t0 = 1.0 / A;
    const double x = t0 * u_cr;
    const double y = root * t0;
    const double psi_0 = angles_atan2(root, u_cr);
    const double theta = angles_atan2_swapped(root, u_cr);
    const double t1 = x * y;
    const double t2 = 0.5 * t1;
    const double M2 = -t2 + 0.5 * theta;
    const double t3 = x * x;
    const double M4 = -t1 * (0.25 * t3 + 0.375) + 0.375 * theta;
    const double M6 = -t1 * (t3 * (0.16666666666666666 * t3 + 0.20833333333333334) + 0.3125) + 0.3125 * theta;
    const double S2_2 = 0.5 * psi_0 + t2;
    const double A2 = A * A;
    const double t4 = M4 * beta;
    const double A4 = A2 * A2;
    const double t5 = M6 * gamma;
    const double t6 = A4 * t5;
    const double t7 = M2 * alpha + S2_2;
    const double t8 = 3.0 * beta;
    const double t9 = 1.0 / A2;
    const double t10 = 1.0 / root;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    const double t11 = gamma * u_cr2;
    const double t12 = alpha - 1.0;
    const double t13 = t12 + u_cr2 * (beta + t11);
    const double t14 = 6.0 * t4;
    const double A3 = A * A2;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double t15 = u_cr3 / root3;
    const double t16 = t13 * t15;
    const double t17 = t10 * u_cr3;
    const double t18 = t17 / A3;
    const double t19 = -t12 - u_cr2 * (5.0 * t11 + t8);
    const double t20 = 1.0 / A4;
    const double t21 = t17 * t20;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    out[0] = -1.2732395447351628 * A * (A2 * t4 + t6 + t7);
    out[1] = 1.2732395447351628 * (-A2 * M4 * t8 + t10 * t13 * t9 * u_cr3 - 5.0 * t6 - t7);
    out[2] = -1.2732395447351628 * (A * t14 + 20.0 * A3 * t5 + t0 * t16 + 2.0 * t13 * t18 + t18 * t19);
    out[3] = 1.2732395447351628 * (-60.0 * A2 * t5 + 2.0 * t10 * t20 * u_cr5 * (10.0 * t11 + t8) + t13 * t15 * t9
        + 6.0 * t13 * t21 - t14 + t15 * t19 * t9 + t16 * (2.0 * t9 + 3.0 / root2) + 3.0 * t19 * t21);
}

SF_KERNEL void rod_spring_averaged_passed_1_far_1(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    double root, x, y, M8, M6;
    rod_spring_common_1(A, u_cr, &root, &x, &y, &M8, &M6);
    const double t0 = 1.0 / A;
    const double x2 = x * x;
    const double z = x2 / (y * y);
    const double x3 = x * x2;
    const double x6 = x3 * x3;
    const double x7 = x * x6;
    const double x4 = x2 * x2;
    const double x5 = x * x4;
    const double M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y;
    const double M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y;
    const double t1 = alpha - 1.0;
    const double t2 = A * A;
    const double t3 = gamma * t2;
    const double t4 = 1.0 / y;
    const double t5 = t4 * x3;
    const double t6 = t4 * x5;
    const double t7 = t4 * x7;
    const double t8 = t1 * t5;
    const double t9 = 7.2000000000000002 * M6;
    const double t10 = 1.2 * x2;
    const double t11 = 3.0 * z;
    out[0] = -1.2732395447351628 * A * (M2 * t1 + t2 * (M4 * beta + M6 * t3)) - A;
    out[1] = -1.2732395447351628 * (t1 * (M2 - t5) + t2 * (beta * (3.6000000000000001 * M6 + t6 *
        (-0.59999999999999998 * x2 - 0.40000000000000002)) + t3 * (5.7142857142857144 * M8 + t7 *
        (-0.7142857142857143 * x2 - 0.2857142857142857)))) - 1.0;
    out[2] = -1.2732395447351628 * t0 * (t2 * (beta * (t6 * (-t10 + z + 1.2) + t9) + t3 * (22.857142857142858 * M8
        + t7 * (-2.8571428571428572 * x2 + z + 0.8571428571428571))) + t8 * (z + 2.0));
    out[3] = -1.2732395447351628 * (t2 * (beta * (t6 * (-t10 + z * (-t11 - 6.0) - 4.7999999999999998) + t9) + t3 *
        (68.571428571428569 * M8 + t7 * (-8.5714285714285712 * x2 + z * (-t11 - 4.0) - 3.4285714285714284))) + t8 *
        (z * (-t11 - 8.0) - 8.0)) / t2;
}

SF_KERNEL void rod_spring_averaged(double A, const double *p, double *out) {
    const double u_cr = p[3];
    if (A <= u_cr)
        rod_spring_averaged_passed_0(A, p, out);
    else if (A <= 1.05 * u_cr)
        rod_spring_averaged_passed_1(A, p, out);
    else
        rod_spring_averaged_passed_1_far_1(A, p, out);
}

/* h, h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 13 in passed_0, 56 in passed_1, 117 in passed_1_far_1.
   Error / u (1 + kappa): proved in passed_0 5.51, 4.51; measured 1.6. */
SF_KERNEL void rod_spring_averaged_2_passed_0(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = -alpha;
    const double t1 = A * A;
    const double t2 = gamma * t1;
    out[0] = A * (t0 + t1 * (-0.75 * beta - 0.625 * t2));
    out[1] = t0 + t1 * (-2.25 * beta - 3.125 * t2);
}

SF_KERNEL void rod_spring_averaged_2_passed_1(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t0 = 1.0 / A;
    const double x = t0 * u_cr;
    const double y = root * t0;
    const double psi_0 = angles_atan2(root, u_cr);
    const double theta = angles_atan2_swapped(root, u_cr);
    const double t1 = x * y;
    const double t2 = 0.5 * t1;
    const double M2 = -t2 + 0.5 * theta;
    const double t3 = x * x;
    const double M4 = -t1 * (0.25 * t3 + 0.375) + 0.375 * theta;
    const double M6 = -t1 * (t3 * (0.16666666666666666 * t3 + 0.20833333333333334) + 0.3125) + 0.3125 * theta;
    const double S2_2 = 0.5 * psi_0 + t2;
    const double A2 = A * A;
    const double t4 = A2 * M4 * beta;
    const double A4 = A2 * A2;
    const double t5 = A4 * M6 * gamma;
    const double t6 = M2 * alpha + S2_2;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    out[0] = -1.2732395447351628 * A * (t4 + t5 + t6);
    out[1] = 1.2732395447351628 * (-3.0 * t4 - 5.0 * t5 - t6 + u_cr3 * (alpha + u_cr2 * (beta + gamma * u_cr2) -
        1.0) / (A2 * root));
}

SF_KERNEL void rod_spring_averaged_2_passed_1_far_1(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    double root, x, y, M8, M6;
    rod_spring_common_1(A, u_cr, &root, &x, &y, &M8, &M6);
    const double x2 = x * x;
    const double x3 = x * x2;
    const double x6 = x3 * x3;
    const double x7 = x * x6;
    const double x4 = x2 * x2;
    const double x5 = x * x4;
    const double M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y;
    const double M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y;
    const double t1 = alpha - 1.0;
    const double t2 = A * A;
    const double t3 = gamma * t2;
    const double t4 = 1.0 / y;
    out[0] = -1.2732395447351628 * A * (M2 * t1 + t2 * (M4 * beta + M6 * t3)) - A;
    out[1] = -1.2732395447351628 * (t1 * (M2 - t4 * x3) + t2 * (beta * (3.6000000000000001 * M6 + t4 * x5 *
        (-0.59999999999999998 * x2 - 0.40000000000000002)) + t3 * (5.7142857142857144 * M8 + t4 * x7 *
        (-0.7142857142857143 * x2 - 0.2857142857142857)))) - 1.0;
}

SF_KERNEL void rod_spring_averaged_2(double A, const double *p, double *out) {
    const double u_cr = p[3];
    if (A <= u_cr)
        rod_spring_averaged_2_passed_0(A, p, out);
    else if (A <= 1.05 * u_cr)
        rod_spring_averaged_2_passed_1(A, p, out);
    else
        rod_spring_averaged_2_passed_1_far_1(A, p, out);
}

/* H, H_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 14 in passed_0, 52 in passed_1, 115 in passed_1_far_1.
   Error / u (1 + kappa): proved in passed_0 7.67, 6.34; measured 3. */
SF_KERNEL void rod_spring_averaged_H_passed_0(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = A * A;
    const double t1 = gamma * t0;
    const double t2 = 1.0 - alpha;
    out[0] = A * (t0 * (-0.75 * beta - 0.625 * t1) + t2);
    out[1] = t0 * (-2.25 * beta - 3.125 * t1) + t2;
}

SF_KERNEL void rod_spring_averaged_H_passed_1(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t0 = 1.0 / A;
    const double x = t0 * u_cr;
    const double y = root * t0;
    const double theta = angles_atan2_swapped(root, u_cr);
    const double t1 = x * y;
    const double M2 = -0.5 * t1 + 0.5 * theta;
    const double t2 = x * x;
    const double M4 = -t1 * (0.25 * t2 + 0.375) + 0.375 * theta;
    const double M6 = -t1 * (t2 * (0.16666666666666666 * t2 + 0.20833333333333334) + 0.3125) + 0.3125 * theta;
    const double t3 = alpha - 1.0;
    const double t4 = M2 * t3;
    const double A2 = A * A;
    const double t5 = A2 * M4 * beta;
    const double A4 = A2 * A2;
    const double t6 = A4 * M6 * gamma;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    out[0] = -1.2732395447351628 * A * (t4 + t5 + t6);
    out[1] = 1.2732395447351628 * (-t4 - 3.0 * t5 - 5.0 * t6 + u_cr3 * (t3 + u_cr2 * (beta + gamma * u_cr2)) / (A2
        * root));
}

SF_KERNEL void rod_spring_averaged_H_passed_1_far_1(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    double root, x, y, M8, M6;
    rod_spring_common_1(A, u_cr, &root, &x, &y, &M8, &M6);
    const double x2 = x * x;
    const double x3 = x * x2;
    const double x6 = x3 * x3;
    const double x7 = x * x6;
    const double x4 = x2 * x2;
    const double x5 = x * x4;
    const double M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y;
    const double M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y;
    const double t1 = alpha - 1.0;
    const double t2 = A * A;
    const double t3 = gamma * t2;
    const double t4 = 1.0 / y;
    out[0] = -1.2732395447351628 * A * (M2 * t1 + t2 * (M4 * beta + M6 * t3));
    out[1] = -1.2732395447351628 * (t1 * (M2 - t4 * x3) + t2 * (beta * (3.6000000000000001 * M6 + t4 * x5 *
        (-0.59999999999999998 * x2 - 0.40000000000000002)) + t3 * (5.7142857142857144 * M8 + t4 * x7 *
        (-0.7142857142857143 * x2 - 0.2857142857142857))));
}

SF_KERNEL void rod_spring_averaged_H(double A, const double *p, double *out) {
    const double u_cr = p[3];
    if (A <= u_cr)
        rod_spring_averaged_H_passed_0(A, p, out);
    else if (A <= 1.05 * u_cr)
        rod_spring_averaged_H_passed_1(A, p, out);
    else
        rod_spring_averaged_H_passed_1_far_1(A, p, out);
}

/* h - A h_A, where the tangent of h meets A = 0; linear terms are none.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 7 in passed_0, 45 in passed_1, 99 in passed_1_far_1. Error
   / u (1 + kappa): proved in passed_0 4.61; measured 3. */
SF_KERNEL double rod_spring_intercept_passed_0(double A, double alpha, double beta, double gamma, double u_cr) {
    const double A2 = A * A;
    const double A3 = A * A2;
    return A3 * (2.5 * A2 * gamma + 1.5 * beta);
}

SF_KERNEL double rod_spring_intercept_passed_1(double A, double alpha, double beta, double gamma, double u_cr) {
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t0 = 1.0 / A;
    const double x = t0 * u_cr;
    const double y = root * t0;
    const double theta = angles_atan2_swapped(root, u_cr);
    const double t1 = x * x;
    const double t2 = x * y;
    const double M4 = -t2 * (0.25 * t1 + 0.375) + 0.375 * theta;
    const double M6 = -t2 * (t1 * (0.16666666666666666 * t1 + 0.20833333333333334) + 0.3125) + 0.3125 * theta;
    const double u_cr2 = u_cr * u_cr;
    const double A2 = A * A;
    const double A3 = A * A2;
    const double A4 = A2 * A2;
    const double A5 = A * A4;
    const double u_cr3 = u_cr * u_cr2;
    return 1.2732395447351628 * (2.0 * A3 * M4 * beta + 4.0 * A5 * M6 * gamma - t0 * u_cr3 * (alpha + u_cr2 *
        (beta + gamma * u_cr2) - 1.0) / root);
}

SF_KERNEL double rod_spring_intercept_passed_1_far_1(double A, double alpha, double beta, double gamma, double u_cr) {
    double root, x, y, M8, M6;
    rod_spring_common_1(A, u_cr, &root, &x, &y, &M8, &M6);
    const double x2 = x * x;
    const double x3 = x * x2;
    const double x6 = x3 * x3;
    const double x7 = x * x6;
    const double t1 = 1.0 / y;
    const double t2 = A * A;
    const double x4 = x2 * x2;
    const double x5 = x * x4;
    return -1.2732395447351628 * A * (t1 * x3 * (alpha - 1.0) + t2 * (beta * (-2.3999999999999999 * M6 + t1 * x5
        * (0.40000000000000002 * x2 + 0.59999999999999998)) + gamma * t2 * (-4.5714285714285712 * M8 + t1 * x7 *
        (0.5714285714285714 * x2 + 0.42857142857142855))));
}

SF_KERNEL double rod_spring_intercept(double A, double alpha, double beta, double gamma, double u_cr) {
    if (A <= u_cr)
        return rod_spring_intercept_passed_0(A, alpha, beta, gamma, u_cr);
    else if (A <= 1.05 * u_cr)
        return rod_spring_intercept_passed_1(A, alpha, beta, gamma, u_cr);
    else
        return rod_spring_intercept_passed_1_far_1(A, alpha, beta, gamma, u_cr);
}

/* Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.
   Equation beyond (20). Domain: A >= 0. Operations: 26 in passed_0, 278 in passed_1, 331 in passed_1_far_1. Error /
   u (1 + kappa): proved in passed_0 4.11, 3.51, 2.34, 1.51, 0.72, 0.84, 0.81, 0.76; measured 3.8. */
SF_KERNEL void rod_spring_harmonics_passed_0(double A, const double *p, double *out) {
    const double beta = p[1], gamma = p[2];
    const double A2 = A * A;
    const double A3 = A * A2;
    const double t0 = A2 * gamma;
    const double t1 = 1.5 * beta;
    const double A4 = A2 * A2;
    const double A5 = A * A4;
    out[0] = A3 * (-0.25 * beta - 0.3125 * t0);
    out[1] = A2 * (-0.75 * beta - 1.5625 * t0);
    out[2] = A * (-6.25 * t0 - t1);
    out[3] = -18.75 * t0 - t1;
    out[4] = -0.0625 * A5 * gamma;
    out[5] = -0.3125 * A4 * gamma;
    out[6] = -1.25 * A3 * gamma;
    out[7] = -3.75 * t0;
}

SF_KERNEL void rod_spring_harmonics_passed_1(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t0 = 1.0 / A;
    const double x = t0 * u_cr;
    const double y = root * t0;
    const double theta = angles_atan2_swapped(root, u_cr);
    const double x2 = x * x;
    const double t2 = x * y;
    const double W3_3 = -t2 * (x2 * (0.66666666666666663 * x2 + 0.083333333333333329) + 0.125) + 0.125 * theta;
    const double W3_5 = -t2 * (x2 * (x2 * (0.5 * x2 + 0.083333333333333329) + 0.10416666666666667) + 0.15625) +
        0.15625 * theta;
    const double x4 = x2 * x2;
    const double x5 = x * x4;
    const double W5_3 = -x5 * y * (2.0 * x2 - 1.0);
    const double W5_5 = -t2 * (x2 * (x2 * (x2 * (1.6000000000000001 * x2 - 0.69999999999999996) +
        0.016666666666666666) + 0.020833333333333332) + 0.03125) + 0.03125 * theta;
    rod_spring_common_2(A, W3_3, W3_5, W5_3, W5_5, alpha, beta, gamma, root, u_cr, x, y, &out[0], &out[1], &out[2],
        &out[3], &out[4], &out[5], &out[6], &out[7]);
}

SF_KERNEL void rod_spring_harmonics_passed_1_far_1(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t0 = 1.0 / A;
    const double x = t0 * u_cr;
    const double y = root * t0;
    const double s = x / sqrt(2.0 * y + 2.0);
    const double s2 = s * s;
    const double s4 = s2 * s2;
    const double s5 = s * s4;
    const double s10 = s5 * s5;
    const double s11 = s * s10;
    const double M10 = s11 * (s2 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 * (s4 *
        (-3.4702182012168982e-05 * s4 - 6.5400985614308773e-05) - 0.00013219458716256277) - 0.00029172897338867185)
        - 0.00072125690739329265) - 0.0020784945101351353) - 0.007457386363636364) - 0.037715517241379309) -
        0.35999999999999999) - 24.0) - 790.58823529411768) - 708.92307692307691) + s4 * (s4 * (s4 * (s4 * (s4 * (s4
        * (s4 * (s4 * (s4 * (s4 * (-4.7267075966704972e-05 * s4 - 9.2082602136275347e-05) - 0.00019396873230629778)
        - 0.00045130973638490189) - 0.0011972280649038462) - 0.0038085937499999999) - 0.015877016129032258) -
        0.10416666666666667) - 1.826086956521739) + 265.26315789473682) + 1075.2) + 186.18181818181819);
    const double x2 = x * x;
    const double x4 = x2 * x2;
    const double x8 = x4 * x4;
    const double x9 = x * x8;
    const double M8 = 1.1111111111111112 * M10 + 0.1111111111111111 * x9 * y;
    const double x3 = x * x2;
    const double x6 = x3 * x3;
    const double x7 = x * x6;
    const double M6 = 1.1428571428571428 * M8 + 0.14285714285714285 * x7 * y;
    const double x5 = x * x4;
    const double t1 = x5 * y;
    const double M4 = 1.2 * M6 + 0.20000000000000001 * t1;
    const double W3_3 = -3.0 * M4 + 4.0 * M6;
    const double W3_5 = -3.0 * M6 + 4.0 * M8;
    const double W5_3 = -t1 * (2.0 * x2 - 1.0);
    const double W5_5 = 16.0 * M10 + 5.0 * M6 - 20.0 * M8;
    rod_spring_common_2(A, W3_3, W3_5, W5_3, W5_5, alpha, beta, gamma, root, u_cr, x, y, &out[0], &out[1], &out[2],
        &out[3], &out[4], &out[5], &out[6], &out[7]);
}

SF_KERNEL void rod_spring_harmonics(double A, const double *p, double *out) {
    const double u_cr = p[3];
    if (A <= u_cr)
        rod_spring_harmonics_passed_0(A, p, out);
    else if (A <= 1.05 * u_cr)
        rod_spring_harmonics_passed_1(A, p, out);
    else
        rod_spring_harmonics_passed_1_far_1(A, p, out);
}

/* d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.
   Equation from (20)-(22), (31). Domain: A > 0. Operations: 10 in passed_0, 109 in passed_1, 159 in passed_1_far_1.
   Error / u (1 + kappa): proved in passed_0 0.84 at most. */
SF_KERNEL void rod_spring_by_parameter_passed_0(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double A2 = A * A;
    const double A3 = A * A2;
    const double A4 = A2 * A2;
    const double A5 = A * A4;
    for (int k = 0; k < 12; k++)
        out[k] = 0.0;
    out[0] = -A;
    out[1] = -1.0;
    out[3] = -0.75 * A3;
    out[4] = -2.25 * A2;
    out[5] = -4.5 * A;
    out[6] = -0.625 * A5;
    out[7] = -3.125 * A4;
    out[8] = -12.5 * A3;
}

SF_KERNEL void rod_spring_by_parameter_passed_1(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double root = sqrt((A - u_cr) * (A + u_cr));
    const double t0 = 1.0 / A;
    const double x = t0 * u_cr;
    const double y = root * t0;
    const double theta = angles_atan2_swapped(root, u_cr);
    const double t1 = x * y;
    const double M2 = -0.5 * t1 + 0.5 * theta;
    const double t2 = x * x;
    const double M4 = -t1 * (0.25 * t2 + 0.375) + 0.375 * theta;
    const double M6 = -t1 * (t2 * (0.16666666666666666 * t2 + 0.20833333333333334) + 0.3125) + 0.3125 * theta;
    const double A2 = A * A;
    const double t3 = 1.0 / A2;
    const double t4 = 1.0 / root;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    const double A3 = A * A2;
    const double t5 = 1.0 / A3;
    const double root2 = root * root;
    const double root3 = root * root2;
    const double t6 = 1.0 / root3;
    const double t7 = t0 * t6;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    const double A4 = A2 * A2;
    const double u_cr6 = u_cr3 * u_cr3;
    const double u_cr7 = u_cr * u_cr6;
    const double t8 = 1.2732395447351628 * u_cr2 * (alpha + beta * u_cr2 + gamma * u_cr4 - 1.0);
    const double A5 = A * A4;
    const double root4 = root2 * root2;
    const double root5 = root * root4;
    out[0] = -1.2732395447351628 * A * M2;
    out[1] = 1.2732395447351628 * (-M2 + t3 * t4 * u_cr3);
    out[2] = 1.2732395447351628 * (-t4 * t5 * u_cr3 - t7 * u_cr3);
    out[3] = -1.2732395447351628 * A3 * M4;
    out[4] = 1.2732395447351628 * (-3.0 * A2 * M4 + t3 * t4 * u_cr5);
    out[5] = 1.2732395447351628 * (-6.0 * A * M4 + t4 * t5 * u_cr5 - t7 * u_cr5);
    out[6] = -1.2732395447351628 * A5 * M6;
    out[7] = 1.2732395447351628 * (-5.0 * A4 * M6 + t3 * t4 * u_cr7);
    out[8] = 1.2732395447351628 * (-20.0 * A3 * M6 + 3.0 * t4 * t5 * u_cr7 - t7 * u_cr7);
    out[9] = -t0 * t4 * t8;
    out[10] = t3 * t6 * t8 * (A2 + root2);
    out[11] = -t5 * t8 * (A2 * root2 + 3.0 * A4 + 2.0 * root4) / root5;
}

SF_KERNEL void rod_spring_by_parameter_passed_1_far_1(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    double root, x, y, M8, M6;
    rod_spring_common_1(A, u_cr, &root, &x, &y, &M8, &M6);
    const double t0 = 1.0 / A;
    const double x2 = x * x;
    const double z = x2 / (y * y);
    const double x3 = x * x2;
    const double x6 = x3 * x3;
    const double x7 = x * x6;
    const double x4 = x2 * x2;
    const double x5 = x * x4;
    const double M4 = 1.2 * M6 + 0.20000000000000001 * x5 * y;
    const double M2 = 1.3333333333333333 * M4 + 0.33333333333333331 * x3 * y;
    const double t1 = 1.2732395447351628 * A;
    const double t2 = 1.0 / y;
    const double t3 = t2 * x3;
    const double t4 = 1.2732395447351628 * t0;
    const double A2 = A * A;
    const double A3 = A * A2;
    const double t5 = 1.2732395447351628 * A3;
    const double t6 = t2 * x5;
    const double A4 = A2 * A2;
    const double t7 = t2 * x7;
    const double u_cr2 = u_cr * u_cr;
    const double u_cr4 = u_cr2 * u_cr2;
    const double t8 = u_cr2 * (alpha + beta * u_cr2 + gamma * u_cr4 - 1.0);
    const double root2 = root * root;
    const double t9 = 1.2732395447351628 * t8;
    const double A5 = A * A4;
    const double root3 = root * root2;
    const double root4 = root2 * root2;
    const double root5 = root * root4;
    out[0] = -M2 * t1;
    out[1] = -1.2732395447351628 * (M2 - t3);
    out[2] = -t3 * t4 * (z + 2.0);
    out[3] = -M4 * t5;
    out[4] = -1.2732395447351628 * A2 * (3.6000000000000001 * M6 + t6 * (-0.59999999999999998 * x2 -
        0.40000000000000002));
    out[5] = -t1 * (7.2000000000000002 * M6 + t6 * (-1.2 * x2 + z + 1.2));
    out[6] = -1.2732395447351628 * A5 * M6;
    out[7] = -1.2732395447351628 * A4 * (5.7142857142857144 * M8 + t7 * (-0.7142857142857143 * x2 -
        0.2857142857142857));
    out[8] = -t5 * (22.857142857142858 * M8 + t7 * (-2.8571428571428572 * x2 + z + 0.8571428571428571));
    out[9] = -t4 * t8 / root;
    out[10] = t9 * (A2 + root2) / (A2 * root3);
    out[11] = -t9 * (A2 * root2 + 3.0 * A4 + 2.0 * root4) / (A3 * root5);
}

SF_KERNEL void rod_spring_by_parameter(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double u_cr = p[3];
    if (A <= u_cr)
        rod_spring_by_parameter_passed_0(A, h, h_A, h_AA, p, out);
    else if (A <= 1.05 * u_cr)
        rod_spring_by_parameter_passed_1(A, h, h_A, h_AA, p, out);
    else
        rod_spring_by_parameter_passed_1_far_1(A, h, h_A, h_AA, p, out);
}

/* d/d of each number of the design: of each parameter in turn, then of each breakpoint.
   Equation (5), (7). Domain: any design that has a breakpoint. Operations: 17. */
SF_KERNEL void rod_spring_by_design(double lam, double r, double delta_h, double *out) {
    const double t0 = lam * r;
    const double t1 = delta_h - 1.0;
    const double t2 = 0.5 * t1;
    const double t3 = 0.375 * t1;
    const double t4 = -t1 / (sqrt(delta_h) * sqrt(2.0 - delta_h));
    for (int k = 0; k < 15; k++)
        out[k] = 0.0;
    out[0] = -delta_h * r;
    out[1] = -delta_h * lam;
    out[2] = -t0;
    out[3] = -r * t2;
    out[4] = -lam * t2;
    out[5] = -0.5 * t0;
    out[6] = -r * t3;
    out[7] = -lam * t3;
    out[8] = -0.375 * t0;
    out[11] = t4;
    out[14] = t4;
}

/* The parameters alpha, beta, gamma, u_cr from the design.
   Equation (5), (7). Domain: any design. Operations: 11. Error / u (1 + kappa): proved 1.34, 6.01, 8.01, -;
   measured 2.1. */
SF_KERNEL void rod_spring_coefficients(double lam, double r, double delta_h, double *out) {
    const double t0 = lam * r;
    const double t1 = t0 * (delta_h - 1.0);
    out[0] = -delta_h * t0 + 1.0;
    out[1] = -0.5 * t1;
    out[2] = -0.375 * t1;
    out[3] = sqrt(delta_h) * sqrt(2.0 - delta_h);
}

/* The |u| at which a piece of the force ends.
   Equation (5). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0. */
SF_KERNEL void rod_spring_breakpoints(const double *p, double *out) {
    const double u_cr = p[3];
    out[0] = u_cr;
}

/* What the force loses at each breakpoint: f below less f above.
   Equation (6). Domain: any parameters. Operations: 7. Error / u (1 + kappa): proved 7.67. */
SF_KERNEL void rod_spring_jumps(const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double t0 = u_cr * u_cr;
    out[0] = u_cr * (alpha + t0 * (beta + gamma * t0) - 1.0);
}

/* The force over the displacement, f(u)/u, rises with |u| where none of these is negative.
   Equation from (3). Domain: any parameters. Operations: 7. Error / u (1 + kappa): proved 0.0, 0.0, 7.67. */
SF_KERNEL void rod_spring_hardening(const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double t0 = u_cr * u_cr;
    out[0] = beta;
    out[1] = gamma;
    out[2] = -u_cr * (alpha + t0 * (beta + gamma * t0) - 1.0);
}

/* f and its derivatives just above 0, their gains at each breakpoint, and the last piece's by its formula at 0.
   Equation (3), (5). Domain: any parameters. Operations: 21. Error / u (1 + kappa): proved 7.67 at most. */
SF_KERNEL void rod_spring_steps(const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2], u_cr = p[3];
    const double t0 = 6.0 * beta;
    const double t1 = 120.0 * gamma;
    const double t2 = u_cr * u_cr;
    const double t3 = gamma * t2;
    for (int k = 0; k < 18; k++)
        out[k] = 0.0;
    out[1] = alpha;
    out[3] = t0;
    out[5] = t1;
    out[6] = -u_cr * (alpha + t2 * (beta + t3) - 1.0);
    out[7] = -alpha + t2 * (-3.0 * beta - 5.0 * t3) + 1.0;
    out[8] = u_cr * (-t0 - 20.0 * t3);
    out[9] = -t0 - 60.0 * t3;
    out[10] = -t1 * u_cr;
    out[11] = -t1;
    out[13] = 1.0;
}

/* What each parameter does to derivatives of each piece at u = 0, then to their gains at each breakpoint.
   Equation (3). Domain: any parameters. Operations: 10. Error / u (1 + kappa): proved 0.81 at most. */
SF_KERNEL void rod_spring_steps_by(const double *p, double *out) {
    const double u_cr = p[3];
    const double u_cr2 = u_cr * u_cr;
    const double u_cr3 = u_cr * u_cr2;
    const double u_cr4 = u_cr2 * u_cr2;
    const double u_cr5 = u_cr * u_cr4;
    for (int k = 0; k < 72; k++)
        out[k] = 0.0;
    out[1] = 1.0;
    out[12] = -u_cr;
    out[13] = -1.0;
    out[21] = 6.0;
    out[30] = -u_cr3;
    out[31] = -3.0 * u_cr2;
    out[32] = -6.0 * u_cr;
    out[33] = -6.0;
    out[41] = 120.0;
    out[48] = -u_cr5;
    out[49] = -5.0 * u_cr4;
    out[50] = -20.0 * u_cr3;
    out[51] = -60.0 * u_cr2;
    out[52] = -120.0 * u_cr;
    out[53] = -120.0;
}

/* Piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (6). Domain: where it holds. Operations: 6. Error / u (1 + kappa): proved 4.76. */
SF_KERNEL double rod_spring_force_1(double u, double alpha, double beta, double gamma, double u_cr) {
    const double t0 = u * u;
    return u * (alpha + t0 * (beta + gamma * t0));
}

/* d/du of piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (6). Domain: where it holds. Operations: 7. Error / u (1 + kappa): proved 4.51. */
SF_KERNEL double rod_spring_force_1_u(double u, double alpha, double beta, double gamma, double u_cr) {
    const double t0 = u * u;
    return alpha + t0 * (3.0 * beta + 5.0 * gamma * t0);
}

/* Piece 2 of the whole restoring force u + F_k(u).
   Equation (3), (6). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0. */
SF_KERNEL double rod_spring_force_2(double u, double alpha, double beta, double gamma, double u_cr) {
    return u;
}

/* d/du of piece 2 of the whole restoring force u + F_k(u).
   Equation (3), (6). Domain: where it holds. Operations: 0. Error / u (1 + kappa): proved 0.0. */
SF_KERNEL double rod_spring_force_2_u(double u, double alpha, double beta, double gamma, double u_cr) {
    return 1.0;
}

/* Whole dimensionless restoring force u + F_k(u), truncated.
   Equation (3), (6). Domain: any u. */
SF_KERNEL double rod_spring_force(double u, double alpha, double beta, double gamma, double u_cr) {
    if (fabs(u) <= u_cr)
        return rod_spring_force_1(u, alpha, beta, gamma, u_cr);
    else
        return rod_spring_force_2(u, alpha, beta, gamma, u_cr);
}

/* Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.
   Equation (33). Domain: roots with 0 < A <= u_cr. Operations: 238. Error / u (1 + kappa): proved 0.82, 0.91, 6.01,
   4.01, 8.17, -, -, -, -, -, -, -, -, -, -, 4.8, 5.04, 0.89, 0.89; measured 4.2. */
#define ROD_SPRING_SADDLE_NODE_ONSET_COUNT 19
SF_KERNEL void rod_spring_saddle_node_onset(double m, double zeta, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = alpha * alpha;
    const double zeta2 = zeta * zeta;
    const double zeta4 = zeta2 * zeta2;
    const double m2 = m * m;
    const double m4 = m2 * m2;
    const double t1 = m4 * zeta4;
    const double t2 = alpha * beta;
    const double t3 = alpha * gamma;
    const double beta2 = beta * beta;
    const double t4 = 9.0 * beta2;
    const double t5 = m2 * zeta4;
    const double gamma2 = gamma * gamma;
    const double beta4 = beta2 * beta2;
    const double t6 = alpha * beta4;
    const double t7 = beta4 * zeta2;
    const double t8 = beta2 * t3;
    const double t9 = t8 * zeta2;
    const double t10 = gamma2 * zeta2;
    const double t11 = 1600.0 * t10;
    const double t12 = t0 * t11;
    const double t13 = m2 * zeta2;
    const double t14 = t0 * zeta2;
    const double beta3 = beta * beta2;
    const double t15 = 27648.0 * beta3;
    const double t16 = alpha * t10;
    const double t17 = gamma * zeta2;
    const double t18 = beta2 * t17;
    const double t19 = beta * zeta2;
    const double gamma3 = gamma * gamma2;
    const double beta6 = beta3 * beta3;
    const double gamma4 = gamma2 * gamma2;
    const double t20 = gamma2 * zeta4;
    const double t21 = alpha * gamma3 * zeta4;
    const double t22 = gamma4 * t13;
    const double t23 = beta2 * t20;
    const double beta8 = beta4 * beta4;
    const double gamma5 = gamma * gamma4;
    const double gamma6 = gamma3 * gamma3;
    const double gamma7 = gamma * gamma6;
    const double gamma8 = gamma4 * gamma4;
    out[0] = 4096.0 * t0 * t1;
    out[1] = 36864.0 * t1 * t2;
    out[2] = 3840.0 * t1 * (20.0 * t3 + t4);
    out[3] = 3072.0 * beta * t5 * (96.0 * beta * t0 + 35.0 * gamma * m2);
    out[4] = 2880.0 * t5 * (25.0 * gamma2 * m2 + 64.0 * t2 * (8.0 * t3 + t4));
    out[5] = 1152.0 * t13 * (t12 - 1485.0 * t6 + 1242.0 * t7 + 9840.0 * t9);
    out[6] = -192.0 * t19 * (m2 * (9477.0 * beta4 - 133600.0 * t16 - 59040.0 * t18 + 88740.0 * t8) - t14 * t15);
    out[7] = -48.0 * zeta2 * (-alpha * t15 * zeta2 * (40.0 * t3 + t4) + 5.0 * gamma * m2 * (82053.0 * beta4 -
        80000.0 * t16 - 136080.0 * t18 + 264240.0 * t8));
    out[8] = -288.0 * t19 * (-432.0 * beta * (t12 - 9.0 * t6 + 54.0 * t7 + 1040.0 * t9) + 25.0 * gamma2 * m2 *
        (11583.0 * beta2 - 5560.0 * t17 + 14520.0 * t3));
    out[9] = -32.0 * zeta2 * (-54.0 * beta * (318400.0 * beta2 * t16 - 8280.0 * beta4 * t3 - 729.0 * beta6 +
        45360.0 * gamma * t7 + 192000.0 * gamma3 * t14) + 125.0 * gamma3 * m2 * (42921.0 * beta2 - 4300.0 * t17 +
        16100.0 * t3));
    out[10] = -170100000.0 * beta * t22 + 1140480000.0 * beta2 * t21 + 371692800.0 * beta4 * t20 - 17146080.0 *
        beta6 * t17 + 59049.0 * beta8 + 207360000.0 * gamma4 * t0 * zeta4 - 75427200.0 * t10 * t6;
    out[11] = -60.0 * gamma * (27.0 * beta * (129600.0 * alpha * beta2 * gamma2 * zeta2 + 60840.0 * beta4 * gamma *
        zeta2 - 567.0 * beta6 - 704000.0 * t21 - 563200.0 * t23) + 1062500.0 * t22);
    out[12] = -4500.0 * gamma2 * (72320.0 * alpha * beta2 * gamma2 * zeta2 + 68868.0 * beta4 * gamma * zeta2 -
        1377.0 * beta6 - 96000.0 * t21 - 270080.0 * t23);
    out[13] = -22500.0 * beta * gamma3 * (-1053.0 * beta4 + 11840.0 * t16 + 25560.0 * t18 - 36800.0 * t20);
    out[14] = -56250.0 * gamma4 * (alpha * t11 - 999.0 * beta4 + 11184.0 * t18 - 4000.0 * t20);
    out[15] = 37500.0 * beta * gamma5 * (2259.0 * beta2 - 10000.0 * t17);
    out[16] = 187500.0 * gamma6 * (423.0 * beta2 - 500.0 * t17);
    out[17] = 42187500.0 * beta * gamma7;
    out[18] = 9765625.0 * gamma8;
}

/* Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.
   Equation from (24), (30). Domain: roots with 0 < A <= u_cr. Operations: 355. Error / u (1 + kappa): measured 1.9. */
#define ROD_SPRING_SADDLE_NODES_COUNT 17
SF_KERNEL void rod_spring_saddle_nodes(double F_0, double m, double zeta, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double excess = (F_0 - m) * (F_0 + m);
    const double m2 = m * m;
    const double zeta2 = zeta * zeta;
    const double t0 = m2 * zeta2;
    const double t1 = excess * t0;
    const double excess2 = excess * excess;
    const double excess3 = excess * excess2;
    const double t2 = 6.0 * beta;
    const double t3 = beta * excess2;
    const double m4 = m2 * m2;
    const double t4 = alpha * alpha;
    const double t5 = t4 * zeta2;
    const double t6 = 128.0 * zeta2;
    const double zeta4 = zeta2 * zeta2;
    const double t7 = beta * zeta4;
    const double t8 = alpha * t7;
    const double beta2 = beta * beta;
    const double t9 = 9.0 * beta2;
    const double t10 = gamma * zeta2;
    const double t11 = 40.0 * t10;
    const double t12 = excess * gamma;
    const double t13 = 5.0 * t12;
    const double t14 = alpha * zeta2;
    const double t15 = beta * t14;
    const double t16 = alpha * gamma;
    const double t17 = m4 * zeta4;
    const double t18 = alpha * beta2;
    const double t19 = gamma * t7;
    const double gamma2 = gamma * gamma;
    const double t20 = excess * gamma2;
    const double t21 = -25.0 * t20;
    const double beta3 = beta * beta2;
    const double t22 = beta3 * zeta2;
    const double t23 = 120.0 * alpha;
    const double t24 = beta * t10;
    const double t25 = excess * t10;
    const double t26 = 48.0 * beta;
    const double beta4 = beta2 * beta2;
    const double t27 = 81.0 * excess;
    const double t28 = beta3 * zeta4;
    const double t29 = 1728.0 * alpha;
    const double t30 = t20 * zeta4;
    const double t31 = 200.0 * t20;
    const double t32 = 45.0 * beta2 * t12;
    const double t33 = 243.0 * beta4;
    const double t34 = t10 * t18;
    const double t35 = 400.0 * gamma2;
    const double t36 = 720.0 * t16;
    const double beta5 = beta * beta4;
    const double t37 = 243.0 * beta5;
    const double gamma3 = gamma * gamma2;
    const double t38 = excess * gamma3;
    const double t39 = beta3 * t10;
    const double t40 = beta4 * zeta4;
    const double t41 = beta2 * gamma2;
    const double t42 = gamma3 * zeta2;
    const double t43 = alpha * zeta4;
    const double t44 = 43200.0 * t20;
    const double gamma4 = gamma2 * gamma2;
    const double t45 = gamma2 * t5;
    const double t46 = 40.0 * t16;
    const double excess4 = excess2 * excess2;
    const double beta6 = beta3 * beta3;
    const double gamma5 = gamma * gamma4;
    const double gamma6 = gamma3 * gamma3;
    out[0] = 64.0 * excess4;
    out[1] = 512.0 * t1 * (-excess * (alpha - 2.0 * zeta2) + 2.0 * m2 * zeta2);
    out[2] = t6 * (excess3 * t2 + 3.0 * m2 * t3 + 8.0 * m4 * t5);
    out[3] = -32.0 * excess3 * (-t11 + t9) + 4608.0 * m4 * t8 + 192.0 * t1 * (t13 + 16.0 * t15);
    out[4] = excess * m2 * t6 * (alpha * t11 + 36.0 * beta2 * zeta2 + 27.0 * t18) + 320.0 * t17 * (20.0 * t16 +
        t9) + 192.0 * t3 * (-t13 + t14 * t2 + 12.0 * t7);
    out[5] = 96.0 * beta * t0 * (excess * t9 + t12 * t23 + 140.0 * t25 + t26 * t5) + 32.0 * excess2 * (240.0 * t19
        + t21 - 27.0 * t22 + t23 * t24) + 6720.0 * m4 * t19;
    out[6] = 4.0 * excess * (-1260.0 * beta2 * t25 + beta4 * t27 + 800.0 * t14 * t20 + t28 * t29 + 1600.0 * t30) +
        3600.0 * gamma2 * t17 + 48.0 * t0 * (288.0 * alpha * t22 + alpha * t31 + 320.0 * t24 * t4 + t31 * zeta2 +
        t32);
    out[7] = -excess * t26 * (54.0 * alpha * beta3 * zeta2 + 200.0 * excess * gamma2 * zeta2 - 108.0 * t28 - t32 -
        t36 * t7) + 32.0 * m2 * zeta2 * (-162.0 * alpha * beta4 + t33 * zeta2 + 1980.0 * t34 + t35 * t5);
    out[8] = -16.0 * t0 * (2160.0 * beta3 * t16 - 6000.0 * gamma2 * t15 + t37 + 125.0 * t38 - 2700.0 * t39) + 24.0
        * (-720.0 * alpha * beta3 * t25 - beta5 * t27 * zeta2 + 225.0 * excess2 * t41 - 250.0 * excess2 * t42 +
        1260.0 * t12 * t28 + 2400.0 * t20 * t8 + 216.0 * t4 * t40);
    out[9] = 64800.0 * beta2 * t30 - 14580.0 * beta4 * t25 + 7776.0 * beta5 * t43 + 34560.0 * gamma * t28 * t4 +
        6000.0 * gamma3 * t3 - 120.0 * m2 * t10 * (-735.0 * beta2 * t10 + beta2 * t36 - t14 * t35 + t33) - t18 * t44
        * zeta2 + 32000.0 * t38 * t43;
    out[10] = -1200.0 * beta * gamma2 * m2 * zeta2 * (72.0 * beta2 - 65.0 * t10 + 80.0 * t16) + 2916.0 * beta6 *
        zeta4 + 2500.0 * excess2 * gamma4 - 48000.0 * t15 * t38 + 58320.0 * t16 * t40 - t22 * t44 + 60000.0 * t38 *
        t7 + 86400.0 * t4 * t41 * zeta4;
    out[11] = -100.0 * t10 * (200.0 * alpha * excess * gamma3 - 960.0 * beta * t45 + 630.0 * beta2 * excess *
        gamma2 + 10.0 * gamma2 * m2 * (126.0 * beta2 - 25.0 * t10 + t46) - t29 * t39 - t37 * zeta2 - 200.0 * t38 *
        zeta2);
    out[12] = -25.0 * gamma2 * zeta2 * (1800.0 * beta * excess * gamma2 + 3600.0 * beta * gamma2 * m2 - 3321.0 *
        beta4 * zeta2 - 10080.0 * t34 - 1600.0 * t45);
    out[13] = -500.0 * t42 * (-360.0 * alpha * t24 + 50.0 * gamma2 * m2 - t21 - 297.0 * t22);
    out[14] = 1250.0 * gamma4 * zeta4 * (117.0 * beta2 + t46);
    out[15] = 75000.0 * gamma5 * t7;
    out[16] = 15625.0 * gamma6 * zeta4;
}

#include "arithmetic_doubles.h"
#define OF(name) rod_spring_##name
#include "mechanism_generic.h"
#include "arithmetic_end.h"

SF_FAMILY_END

#endif
