/* Duffing oscillator: one polynomial of degree five, no breakpoint.

   Written by `make derive` from derivations/mechanisms/duffing.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef DUFFING_H
#define DUFFING_H

#include <math.h>

#include "inline.h"
#include "slow_flow.h"

SF_FAMILY_BEGIN

/* alpha, beta, gamma */
#define DUFFING_PARAMETERS 3
#define DUFFING_BREAKPOINTS 0

/* h, h_A, h_AA, h_AAA together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 19. Error / u (1 + kappa): proved 5.76, 4.76, 2.34, 1.51. */
SF_KERNEL void duffing_averaged(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = A * A;
    const double gamma_A2 = gamma * t0;
    const double gamma_A4 = gamma_A2 * t0;
    const double beta_A2 = beta * t0;
    const double t1 = 4.5 * beta;
    out[0] = A * (-alpha - 0.75 * beta_A2 - 0.625 * gamma_A4);
    out[1] = -alpha - 2.25 * beta_A2 - 3.125 * gamma_A4;
    out[2] = A * (-12.5 * gamma_A2 - t1);
    out[3] = -37.5 * gamma_A2 - t1;
}

/* h, h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 13. Error / u (1 + kappa): proved 5.76, 4.76. */
SF_KERNEL void duffing_averaged_2(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = A * A;
    const double gamma_A2 = gamma * t0;
    const double gamma_A4 = gamma_A2 * t0;
    const double beta_A2 = beta * t0;
    out[0] = A * (-alpha - 0.75 * beta_A2 - 0.625 * gamma_A4);
    out[1] = -alpha - 2.25 * beta_A2 - 3.125 * gamma_A4;
}

/* H, H_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 14. Error / u (1 + kappa): proved 8.01, 6.67. */
SF_KERNEL void duffing_averaged_H(double A, const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = A * A;
    const double gamma_A2 = gamma * t0;
    const double gamma_A4 = gamma_A2 * t0;
    const double beta_A2 = beta * t0;
    const double t1 = alpha - 1.0;
    out[0] = A * (-0.75 * beta_A2 - 0.625 * gamma_A4 - t1);
    out[1] = -2.25 * beta_A2 - 3.125 * gamma_A4 - t1;
}

/* h - A h_A, where the tangent of h meets A = 0; linear terms are none.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 8. Error / u (1 + kappa): proved 4.61. */
SF_KERNEL double duffing_intercept(double A, double alpha, double beta, double gamma) {
    const double t0 = A * A;
    const double gamma_A2 = gamma * t0;
    const double gamma_A4 = gamma_A2 * t0;
    const double beta_A2 = beta * t0;
    return A * (1.5 * beta_A2 + 2.5 * gamma_A4);
}

/* Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.
   Equation beyond (20). Domain: A >= 0. Operations: 26. Error / u (1 + kappa): proved 4.11, 3.51, 2.34, 1.51, 0.72,
   0.84, 0.81, 0.76. */
SF_KERNEL void duffing_harmonics(double A, const double *p, double *out) {
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

/* d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.
   Equation from (20)-(22), (31). Domain: A > 0. Operations: 10. Error / u (1 + kappa): proved 0.84 at most. */
SF_KERNEL void duffing_by_parameter(double A, double h, double h_A, double h_AA, const double *p, double *out) {
    const double A2 = A * A;
    const double A3 = A * A2;
    const double A4 = A2 * A2;
    const double A5 = A * A4;
    out[0] = -A;
    out[1] = -1.0;
    out[2] = 0.0;
    out[3] = -0.75 * A3;
    out[4] = -2.25 * A2;
    out[5] = -4.5 * A;
    out[6] = -0.625 * A5;
    out[7] = -3.125 * A4;
    out[8] = -12.5 * A3;
}

/* d/d of each number of the design: of each parameter in turn, then of each breakpoint.
   Equation (5), (7). Domain: any design. Operations: 0. Error / u (1 + kappa): proved 0.0 at most. */
SF_KERNEL void duffing_by_design(double alpha, double beta, double gamma, double *out) {
    for (int k = 0; k < 9; k++)
        out[k] = 0.0;
    out[0] = 1.0;
    out[4] = 1.0;
    out[8] = 1.0;
}

/* The parameters alpha, beta, gamma from the design.
   Equation (5), (7). Domain: any design. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0. */
SF_KERNEL void duffing_coefficients(double alpha, double beta, double gamma, double *out) {
    out[0] = alpha;
    out[1] = beta;
    out[2] = gamma;
}

/* The |u| at which a piece of the force ends.
   Equation (5). Domain: any parameters. Operations: 0. */
SF_KERNEL void duffing_breakpoints(const double *p, double *out) {
}

/* What the force loses at each breakpoint: f below less f above.
   Equation (5). Domain: any parameters. Operations: 0. */
SF_KERNEL void duffing_jumps(const double *p, double *out) {
}

/* The force over the displacement, f(u)/u, rises with |u| where none of these is negative.
   Equation from (3). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0. */
SF_KERNEL void duffing_hardening(const double *p, double *out) {
    const double beta = p[1], gamma = p[2];
    out[0] = beta;
    out[1] = gamma;
}

/* f and its derivatives just above 0, their gains at each breakpoint, and the last piece's by its formula at 0.
   Equation (3), (5). Domain: any parameters. Operations: 2. Error / u (1 + kappa): proved 0.51 at most. */
SF_KERNEL void duffing_steps(const double *p, double *out) {
    const double alpha = p[0], beta = p[1], gamma = p[2];
    const double t0 = 6.0 * beta;
    const double t1 = 120.0 * gamma;
    for (int k = 0; k < 12; k++)
        out[k] = 0.0;
    out[1] = alpha;
    out[3] = t0;
    out[5] = t1;
    out[7] = alpha;
    out[9] = t0;
    out[11] = t1;
}

/* What each parameter does to derivatives of each piece at u = 0, then to their gains at each breakpoint.
   Equation (3). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0 at most. */
SF_KERNEL void duffing_steps_by(const double *p, double *out) {
    for (int k = 0; k < 18; k++)
        out[k] = 0.0;
    out[1] = 1.0;
    out[9] = 6.0;
    out[17] = 120.0;
}

/* Piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds. Operations: 6. Error / u (1 + kappa): proved 4.76. */
SF_KERNEL double duffing_force_1(double u, double alpha, double beta, double gamma) {
    const double t0 = u * u;
    return u * (alpha + t0 * (beta + gamma * t0));
}

/* d/du of piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds. Operations: 7. Error / u (1 + kappa): proved 4.51. */
SF_KERNEL double duffing_force_1_u(double u, double alpha, double beta, double gamma) {
    const double t0 = u * u;
    return alpha + t0 * (3.0 * beta + 5.0 * gamma * t0);
}

/* Whole dimensionless restoring force u + F_k(u).
   Equation (3), (5). Domain: any u. */
SF_KERNEL double duffing_force(double u, double alpha, double beta, double gamma) {
    
        return duffing_force_1(u, alpha, beta, gamma);
}

/* Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.
   Equation (33). Domain: roots with A > 0. Operations: 238. Error / u (1 + kappa): proved 0.82, 0.91, 6.01, 4.01,
   8.17, -, -, -, -, -, -, -, -, -, -, 4.8, 5.04, 0.89, 0.89; measured 0.94. */
#define DUFFING_SADDLE_NODE_ONSET_COUNT 19
SF_KERNEL void duffing_saddle_node_onset(double m, double zeta, const double *p, double *out) {
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
   Equation from (24), (30). Domain: roots with A > 0. Operations: 355. Error / u (1 + kappa): measured 0.63. */
#define DUFFING_SADDLE_NODES_COUNT 17
SF_KERNEL void duffing_saddle_nodes(double F_0, double m, double zeta, const double *p, double *out) {
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
#define OF(name) duffing_##name
#include "mechanism_generic.h"
#include "arithmetic_end.h"

SF_FAMILY_END

#endif
