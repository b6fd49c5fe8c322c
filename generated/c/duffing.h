/* Duffing oscillator: one cubic piece, no breakpoint.

   Written by `make derive`; never edit.
   Input: derivations/mechanisms/duffing.py, sha256 9cc742f303d96c79bad0568c2c4516c8f5944292cc72520ca6ccbb22912545d8
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. */

#ifndef DUFFING_H
#define DUFFING_H

#include <math.h>

#include "slow_flow.h"

/* alpha, beta */
#define DUFFING_PARAMETERS 2
#define DUFFING_BREAKPOINTS 0

/* h, h_A, h_AA, h_AAA together.
   Equation (20)-(22), (31). Domain: A >= 0.
   Operations where passed_0: 12 structured, 9 common subexpressions, 9 power chains
 */
static inline void duffing_averaged(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double t0 = A * A * beta;
    const double t1 = 4.5 * beta;
    out[0] = A * (-alpha - 0.75 * t0);
    out[1] = -alpha - 2.25 * t0;
    out[2] = -A * t1;
    out[3] = -t1;
}

/* h, h_A, h_AA together.
   Equation (20)-(22), (31). Domain: A >= 0.
   Operations where passed_0: 11 structured, 9 common subexpressions, 9 power chains
 */
static inline void duffing_averaged_3(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double t0 = A * A * beta;
    out[0] = A * (-alpha - 0.75 * t0);
    out[1] = -alpha - 2.25 * t0;
    out[2] = -4.5 * A * beta;
}

/* h, h_A together.
   Equation (20)-(22), (31). Domain: A >= 0.
   Operations where passed_0: 9 structured, 7 common subexpressions, 7 power chains
 */
static inline void duffing_averaged_2(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double t0 = A * A * beta;
    out[0] = A * (-alpha - 0.75 * t0);
    out[1] = -alpha - 2.25 * t0;
}

/* The averaged restoring force h = H - A.
   Equation (20)-(22). Domain: A >= 0.
   Operations where passed_0: 5 structured, 5 common subexpressions, 5 power chains
 */
static inline double duffing_h(double A, double alpha, double beta)
{
    return A * (-0.75 * A * A * beta - alpha);
}

/* d/dA of the averaged restoring force h = H - A.
   Equation (31). Domain: A >= 0.
   Operations where passed_0: 4 structured, 4 common subexpressions, 4 power chains
 */
static inline double duffing_h_A(double A, double alpha, double beta)
{
    return -2.25 * A * A * beta - alpha;
}

/* d2/dA2 of the averaged restoring force h = H - A.
   Equation from (31). Domain: A >= 0.
   Operations where passed_0: 2 structured, 2 common subexpressions, 2 power chains
 */
static inline double duffing_h_AA(double A, double alpha, double beta)
{
    (void)(alpha);
    return -4.5 * A * beta;
}

/* d3/dA3 of the averaged restoring force h = H - A.
   Equation from (31). Domain: A >= 0.
   Operations where passed_0: 1 structured, 1 common subexpressions, 1 power chains
 */
static inline double duffing_h_AAA(double A, double alpha, double beta)
{
    (void)(A);
    (void)(alpha);
    return -4.5 * beta;
}

/* The averaged force H beside the vertical spring.
   Equation (20)-(22). Domain: A >= 0.
   Operations where passed_0: 6 structured, 6 common subexpressions, 6 power chains
 */
static inline double duffing_H(double A, double alpha, double beta)
{
    return A * (-0.75 * A * A * beta - alpha + 1.0);
}

/* d/dA of the averaged force H beside the vertical spring.
   Equation (31). Domain: A >= 0.
   Operations where passed_0: 5 structured, 5 common subexpressions, 5 power chains
 */
static inline double duffing_H_A(double A, double alpha, double beta)
{
    return -2.25 * A * A * beta - alpha + 1.0;
}

/* d2/dA2 of the averaged force H beside the vertical spring.
   Equation from (31). Domain: A >= 0.
   Operations where passed_0: 2 structured, 2 common subexpressions, 2 power chains
 */
static inline double duffing_H_AA(double A, double alpha, double beta)
{
    (void)(alpha);
    return -4.5 * A * beta;
}

/* Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA.
   Equation beyond (20). Domain: A >= 0.
   Operations where passed_0: 10 structured, 9 common subexpressions, 8 power chains
 */
static inline void duffing_harmonics(double A, const double *p, double *out)
{
    const double beta = p[1];
    const double t0 = 1.5 * beta;
    const double A2 = A * A;
    const double A3 = A * A2;
    out[0] = -0.25 * A3 * beta;
    out[1] = -0.75 * A2 * beta;
    out[2] = -A * t0;
    out[3] = -t0;
    out[4] = 0.0;
    out[5] = 0.0;
    out[6] = 0.0;
    out[7] = 0.0;
}

/* The parameters alpha, beta from the design.
   Equation (5), (7). Domain: any design.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline void duffing_coefficients(double alpha, double beta, double *out)
{
    out[0] = alpha;
    out[1] = beta;
}

/* The |u| at which a piece of the force ends.
   Equation (5). Domain: any parameters.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline void duffing_breakpoints(const double *p, double *out)
{
    (void)(out);
    (void)(p);
    (void)(out);
}

/* What the force loses at each breakpoint: f below less f above.
   Equation (6). Domain: any parameters.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline void duffing_jumps(const double *p, double *out)
{
    (void)(out);
    (void)(p);
    (void)(out);
}

/* The force over the displacement, f(u)/u, rises with |u| where none of these is negative.
   Equation from (3). Domain: any parameters.
   Operations: 0 structured, 0 common subexpressions, 0 power chains
 */
static inline void duffing_hardening(const double *p, double *out)
{
    const double beta = p[1];
    out[0] = beta;
}

/* Whole dimensionless restoring force u + F_k(u), truncated.
   Equation (3), (6). Domain: any u.
   Operations where piece_1: 4 structured, 4 common subexpressions, 4 power chains
 */
static inline double duffing_force(double u, double alpha, double beta)
{
    return u * (alpha + beta * u * u);
}

/* Piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (6). Domain: where it holds.
   Operations: 4 structured, 4 common subexpressions, 4 power chains
 */
static inline double duffing_force_1(double u, double alpha, double beta)
{
    return u * (alpha + beta * u * u);
}

/* d/du of piece 1 of the whole restoring force u + F_k(u).
   Equation (3), (6). Domain: where it holds.
   Operations: 4 structured, 4 common subexpressions, 4 power chains
 */
static inline double duffing_force_1_u(double u, double alpha, double beta)
{
    return alpha + 3.0 * beta * u * u;
}

/* Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.
   Equation (33). Domain: roots with A > 0.
   Operations: 137 structured, 78 common subexpressions, 53 power chains
 */
#define DUFFING_SADDLE_NODE_ONSET_COUNT 11
static inline void duffing_saddle_node_onset(double m, double zeta, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double t0 = alpha * alpha;
    const double zeta2 = zeta * zeta;
    const double zeta4 = zeta2 * zeta2;
    const double m2 = m * m;
    const double m4 = m2 * m2;
    const double t1 = m4 * zeta4;
    const double beta2 = beta * beta;
    const double t2 = alpha * zeta4;
    const double beta4 = beta2 * beta2;
    const double t3 = m2 * zeta2;
    const double beta5 = beta * beta4;
    const double beta3 = beta * beta2;
    const double beta6 = beta3 * beta3;
    const double beta7 = beta * beta6;
    const double beta8 = beta4 * beta4;
    out[0] = 4096.0 * t0 * t1;
    out[1] = 36864.0 * alpha * beta * t1;
    out[2] = 34560.0 * beta2 * t1;
    out[3] = 294912.0 * beta2 * m2 * t0 * zeta4;
    out[4] = 1658880.0 * beta3 * m2 * t2;
    out[5] = -1710720.0 * alpha * beta4 * t3 + 1430784.0 * beta4 * m2 * zeta4;
    out[6] = 5308416.0 * beta4 * t0 * zeta4 - 1819584.0 * beta5 * t3;
    out[7] = 11943936.0 * beta5 * t2;
    out[8] = -1119744.0 * alpha * beta6 * zeta2 + 6718464.0 * beta6 * zeta4;
    out[9] = -1259712.0 * beta7 * zeta2;
    out[10] = 59049.0 * beta8;
}

/* Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.
   Equation from (24), (30). Domain: roots with A > 0.
   Operations: 432 structured, 196 common subexpressions, 162 power chains
 */
#define DUFFING_SADDLE_NODES_COUNT 11
static inline void duffing_saddle_nodes(double F_0, double m, double zeta, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double F_0_2 = F_0 * F_0;
    const double m2 = m * m;
    const double m3 = m * m2;
    const double m6 = m3 * m3;
    const double F_0_4 = F_0_2 * F_0_2;
    const double m4 = m2 * m2;
    const double F_0_3 = F_0 * F_0_2;
    const double F_0_6 = F_0_3 * F_0_3;
    const double zeta2 = zeta * zeta;
    const double t0 = m6 * zeta2;
    const double t1 = 128.0 * alpha;
    const double zeta4 = zeta2 * zeta2;
    const double t2 = 256.0 * zeta4;
    const double t3 = F_0_2 * m4;
    const double t4 = F_0_4 * m2;
    const double t5 = beta * zeta2;
    const double t6 = alpha * alpha;
    const double beta2 = beta * beta;
    const double t7 = 72.0 * beta2;
    const double t8 = alpha * zeta4;
    const double t9 = 216.0 * beta2;
    const double t10 = F_0_2 * alpha * zeta4;
    const double t11 = beta2 * zeta4;
    const double t12 = alpha * zeta2;
    const double t13 = beta2 * t12;
    const double t14 = m2 * zeta2;
    const double beta3 = beta * beta2;
    const double t15 = beta3 * zeta2;
    const double beta4 = beta2 * beta2;
    const double t16 = 81.0 * beta4;
    const double t17 = beta4 * m2;
    const double t18 = 1728.0 * beta3;
    const double t19 = F_0_2 * zeta2;
    const double beta5 = beta * beta4;
    const double t20 = 486.0 * beta5;
    const double m8 = m4 * m4;
    const double F_0_8 = F_0_4 * F_0_4;
    const double beta6 = beta3 * beta3;
    out[0] = -64.0 * F_0_2 * m6 + 96.0 * F_0_4 * m4 - 64.0 * F_0_6 * m2 + 16.0 * F_0_8 + 16.0 * m8;
    out[1] = 256.0 * F_0_2 * alpha * m4 * zeta2 + 256.0 * F_0_4 * m2 * zeta4 - t0 * t1 - t1 * t4 * zeta2 - t2 * t3;
    out[2] = 192.0 * F_0_6 * t5 - 96.0 * beta * t0 + m4 * t2 * t6 + 384.0 * t3 * t5 - 480.0 * t4 * t5;
    out[3] = -F_0_6 * t7 + 768.0 * beta * m2 * t10 + 384.0 * beta * m4 * t8 + m6 * t7 - t3 * t9 + t4 * t9;
    out[4] = 288.0 * F_0_2 * alpha * beta2 * t14 + 576.0 * F_0_4 * t11 + 288.0 * F_0_4 * t13 + 144.0 * m4 * t11 -
        576.0 * m4 * t13;
    out[5] = 648.0 * F_0_2 * beta3 * m2 * zeta2 - 216.0 * F_0_4 * t15 + 1152.0 * beta2 * m2 * t6 * zeta4 - 432.0 *
        m4 * t15;
    out[6] = -162.0 * F_0_2 * t17 + F_0_4 * t16 + m2 * t18 * t8 + m4 * t16 + t10 * t18;
    out[7] = 1296.0 * F_0_2 * beta4 * zeta4 - 648.0 * alpha * beta4 * t19 + 648.0 * beta4 * m2 * zeta4 - 648.0 *
        t12 * t17;
    out[8] = 1296.0 * beta4 * t6 * zeta4 - t14 * t20 - t19 * t20;
    out[9] = 1944.0 * beta5 * t8;
    out[10] = 729.0 * beta6 * zeta4;
}

/* Cosine balance, -F_0 cos phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double duffing_R(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(mu);
    (void)(zeta);
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_R(Omega, A, average[0]);
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double duffing_I(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(p);
    return slow_flow_I(Omega, A, slow_flow_friction(mu), zeta);
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double duffing_F(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. */
static inline double duffing_F_A(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    duffing_averaged_2(A, p, average);
    return slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* d2F/dA2.
   Equation (24), (33). Domain: Omega > 0, A > 0. */
static inline double duffing_F_AA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[3];
    duffing_averaged_3(A, p, average);
    return slow_flow_F_AA(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], average[2]);
}

/* d3F/dA3.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double duffing_F_AAA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[4];
    duffing_averaged(A, p, average);
    return slow_flow_F_AAA(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], average[2], average[3]);
}

/* dF/dOmega.
   Equation (24), (34). Domain: Omega > 0, A > 0. */
static inline double duffing_F_Omega(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_F_Omega(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double duffing_F_AOmega(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    duffing_averaged_2(A, p, average);
    return slow_flow_F_AOmega(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. */
static inline double duffing_phase(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. */
static inline void duffing_jacobian(double Omega, double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    duffing_averaged_2(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], out);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. */
static inline double duffing_stability(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    duffing_averaged_2(A, p, average);
    return slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. */
static inline double duffing_transmissibility(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. */
static inline double duffing_backbone(double A, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_backbone(A, average[0]);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. */
static inline double duffing_limit_envelope(double Omega, double F_0, double mu, double zeta)
{
    return slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. */
static inline double duffing_equivalent_damping(double Omega, double A, double mu, double zeta)
{
    return slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
}

#endif
