/* Duffing oscillator: one cubic piece, no breakpoint.

   Written by `make derive` from derivations/mechanisms/duffing.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef DUFFING_H
#define DUFFING_H

#include <math.h>

#include "inline.h"
#include "slow_flow.h"

SF_FAMILY_BEGIN

/* alpha, beta */
#define DUFFING_PARAMETERS 2
#define DUFFING_BREAKPOINTS 0

/* h, h_A, h_AA, h_AAA together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 9. Error / u (1 + kappa): proved 1.84, 1.26, 0.67, 0.51. */
SF_KERNEL void duffing_averaged(double A, const double *p, double *out)
{
    const double alpha = p[0], beta = p[1];
    const double t0 = A * A * beta;
    const double t1 = 4.5 * beta;
    out[0] = A * (-alpha - 0.75 * t0);
    out[1] = -alpha - 2.25 * t0;
    out[2] = -A * t1;
    out[3] = -t1;
}

/* h, h_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 7. Error / u (1 + kappa): proved 1.84, 1.26. */
SF_KERNEL void duffing_averaged_2(double A, const double *p, double *out)
{
    const double alpha = p[0], beta = p[1];
    const double t0 = A * A * beta;
    out[0] = A * (-alpha - 0.75 * t0);
    out[1] = -alpha - 2.25 * t0;
}

/* H, H_A together.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 8. Error / u (1 + kappa): proved 6.01, 4.01. */
SF_KERNEL void duffing_averaged_H(double A, const double *p, double *out)
{
    const double alpha = p[0], beta = p[1];
    const double t0 = A * A * beta;
    const double t1 = alpha - 1.0;
    out[0] = A * (-0.75 * t0 - t1);
    out[1] = -2.25 * t0 - t1;
}

/* h - A h_A, where the tangent of h meets A = 0; linear terms are none.
   Equation (20)-(22), (31). Domain: A >= 0. Operations: 4. Error / u (1 + kappa): proved 0.81. */
SF_KERNEL double duffing_intercept(double A, double alpha, double beta)
{
    const double A2 = A * A;
    const double A3 = A * A2;
    return 1.5 * A3 * beta;
}

/* Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.
   Equation beyond (20). Domain: A >= 0. Operations: 8. Error / u (1 + kappa): proved 0.61, 0.76, 0.67, 0.51, 0.0,
   0.0, 0.0, 0.0. */
SF_KERNEL void duffing_harmonics(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double t0 = 1.5 * beta;
    const double A2 = A * A;
    const double A3 = A * A2;
    for (int k = 0; k < 8; k++)
        out[k] = 0.0;
    out[0] = -0.25 * A3 * beta;
    out[1] = -0.75 * A2 * beta;
    out[2] = -A * t0;
    out[3] = -t0;
}

/* d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.
   Equation from (20)-(22), (31). Domain: A > 0. Operations: 5. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.76,
   0.67, 0.51. */
SF_KERNEL void duffing_by_parameter(double A, double h, double h_A, double h_AA, const double *p, double *out)
{
    const double A2 = A * A;
    const double A3 = A * A2;
    out[0] = -A;
    out[1] = -1.0;
    out[2] = 0.0;
    out[3] = -0.75 * A3;
    out[4] = -2.25 * A2;
    out[5] = -4.5 * A;
}

/* d/d of each number of the design: of each parameter in turn, then of each breakpoint.
   Equation (5), (7). Domain: any design. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.0. */
SF_KERNEL void duffing_by_design(double alpha, double beta, double *out)
{
    out[0] = 1.0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 1.0;
}

/* The parameters alpha, beta from the design.
   Equation (5), (7). Domain: any design. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0. */
SF_KERNEL void duffing_coefficients(double alpha, double beta, double *out)
{
    out[0] = alpha;
    out[1] = beta;
}

/* The |u| at which a piece of the force ends.
   Equation (5). Domain: any parameters. Operations: 0. */
SF_KERNEL void duffing_breakpoints(const double *p, double *out)
{
}

/* What the force loses at each breakpoint: f below less f above.
   Equation (5). Domain: any parameters. Operations: 0. */
SF_KERNEL void duffing_jumps(const double *p, double *out)
{
}

/* The force over the displacement, f(u)/u, rises with |u| where none of these is negative.
   Equation from (3). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0. */
SF_KERNEL void duffing_hardening(const double *p, double *out)
{
    const double beta = p[1];
    out[0] = beta;
}

/* f and its derivatives just above 0, their gains at each breakpoint, and the last piece's by its formula at 0.
   Equation (3), (5). Domain: any parameters. Operations: 1. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.51, 0.0,
   0.0, 0.0, 0.51. */
SF_KERNEL void duffing_steps(const double *p, double *out)
{
    const double alpha = p[0], beta = p[1];
    const double t0 = 6.0 * beta;
    for (int k = 0; k < 8; k++)
        out[k] = 0.0;
    out[1] = alpha;
    out[3] = t0;
    out[5] = alpha;
    out[7] = t0;
}

/* What each parameter does to derivatives of each piece at u = 0, then to their gains at each breakpoint.
   Equation (3). Domain: any parameters. Operations: 0. Error / u (1 + kappa): proved 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
   0.0, 0.0. */
SF_KERNEL void duffing_steps_by(const double *p, double *out)
{
    for (int k = 0; k < 8; k++)
        out[k] = 0.0;
    out[1] = 1.0;
    out[7] = 6.0;
}

/* Piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds. Operations: 4. Error / u (1 + kappa): proved 1.67. */
SF_KERNEL double duffing_force_1(double u, double alpha, double beta)
{
    return u * (alpha + beta * u * u);
}

/* d/du of piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (5). Domain: where it holds. Operations: 4. Error / u (1 + kappa): proved 1.26. */
SF_KERNEL double duffing_force_1_u(double u, double alpha, double beta)
{
    return alpha + 3.0 * beta * u * u;
}

/* Whole dimensionless restoring force u + F_k(u).
   Equation (3), (5). Domain: any u. */
SF_KERNEL double duffing_force(double u, double alpha, double beta)
{
    
        return duffing_force_1(u, alpha, beta);
}

/* Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.
   Equation (33). Domain: roots with A > 0. Operations: 52. Error / u (1 + kappa): proved 7.67 at most. */
#define DUFFING_SADDLE_NODE_ONSET_COUNT 11
SF_KERNEL void duffing_saddle_node_onset(double m, double zeta, const double *p, double *out)
{
    const double alpha = p[0], beta = p[1];
    const double t0 = alpha * alpha;
    const double zeta2 = zeta * zeta;
    const double zeta4 = zeta2 * zeta2;
    const double m2 = m * m;
    const double m4 = m2 * m2;
    const double t1 = m4 * zeta4;
    const double beta2 = beta * beta;
    const double t2 = alpha * zeta4;
    const double beta4 = beta2 * beta2;
    const double t3 = beta4 * zeta2;
    const double beta3 = beta * beta2;
    const double beta5 = beta * beta4;
    const double beta6 = beta3 * beta3;
    const double beta7 = beta * beta6;
    const double beta8 = beta4 * beta4;
    out[0] = 4096.0 * t0 * t1;
    out[1] = 36864.0 * alpha * beta * t1;
    out[2] = 34560.0 * beta2 * t1;
    out[3] = 294912.0 * beta2 * m2 * t0 * zeta4;
    out[4] = 1658880.0 * beta3 * m2 * t2;
    out[5] = -31104.0 * m2 * t3 * (55.0 * alpha - 46.0 * zeta2);
    out[6] = -5184.0 * t3 * (351.0 * beta * m2 - 1024.0 * t0 * zeta2);
    out[7] = 11943936.0 * beta5 * t2;
    out[8] = -1119744.0 * beta6 * zeta2 * (alpha - 6.0 * zeta2);
    out[9] = -1259712.0 * beta7 * zeta2;
    out[10] = 59049.0 * beta8;
}

/* Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.
   Equation from (24), (30). Domain: roots with A > 0. Operations: 98. Error / u (1 + kappa): proved -, -, -, -, -,
   -, -, -, -, 0.91, 0.91; measured 1.2. */
#define DUFFING_SADDLE_NODES_COUNT 11
SF_KERNEL void duffing_saddle_nodes(double F_0, double m, double zeta, const double *p, double *out)
{
    const double alpha = p[0], beta = p[1];
    const double excess = (F_0 - m) * (F_0 + m);
    const double zeta2 = zeta * zeta;
    const double m2 = m * m;
    const double t0 = 2.0 * zeta2;
    const double t1 = excess * (alpha - t0);
    const double t2 = excess * m2;
    const double excess2 = excess * excess;
    const double excess3 = excess * excess2;
    const double t3 = beta * excess3;
    const double t4 = 3.0 * beta;
    const double t5 = excess2 * t4;
    const double t6 = alpha * alpha;
    const double m4 = m2 * m2;
    const double t7 = m4 * zeta2;
    const double zeta4 = zeta2 * zeta2;
    const double t8 = alpha * zeta4;
    const double beta2 = beta * beta;
    const double t9 = beta2 * zeta2;
    const double t10 = excess * t4;
    const double t11 = t6 * zeta2;
    const double beta4 = beta2 * beta2;
    const double t12 = beta4 * zeta2;
    const double excess4 = excess2 * excess2;
    const double beta3 = beta * beta2;
    const double beta5 = beta * beta4;
    const double beta6 = beta3 * beta3;
    out[0] = 16.0 * excess4;
    out[1] = 128.0 * t2 * zeta2 * (2.0 * m2 * zeta2 - t1);
    out[2] = 32.0 * zeta2 * (m2 * t5 + 6.0 * t3 + 8.0 * t6 * t7);
    out[3] = 24.0 * beta * (48.0 * m4 * t8 + 32.0 * t2 * t8 - 3.0 * t3);
    out[4] = 144.0 * t9 * (2.0 * excess2 * (alpha + t0) + 2.0 * t2 * (3.0 * alpha + 4.0 * zeta2) + 5.0 * t7);
    out[5] = 72.0 * t9 * (m2 * (t10 + 16.0 * t11) - t5);
    out[6] = 27.0 * beta3 * (excess * (t10 + 64.0 * t8) + 128.0 * m2 * t8);
    out[7] = -648.0 * t12 * (m2 * (2.0 * alpha - 3.0 * zeta2) + t1);
    out[8] = -162.0 * t12 * (6.0 * beta * m2 + t10 - 8.0 * t11);
    out[9] = 1944.0 * beta5 * t8;
    out[10] = 729.0 * beta6 * zeta4;
}

#include "arithmetic_doubles.h"
#define OF(name) duffing_##name
#include "mechanism_generic.h"
#include "arithmetic_end.h"

SF_FAMILY_END

#endif
