/* Duffing oscillator: one cubic piece, no breakpoint, in the scene mu = 0.

   Written by `make derive`; never edit.
   Input: derivations/mechanisms/duffing.py, sha256 9cc742f303d96c79bad0568c2c4516c8f5944292cc72520ca6ccbb22912545d8
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. */

#ifndef DUFFING_MU0_H
#define DUFFING_MU0_H

#include <math.h>

#include "slow_flow_mu0.h"
#include "duffing.h"

/* Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.
   Equation (33). Domain: roots with A > 0.
   Operations: 8 structured, 7 common subexpressions, 7 power chains
 */
#define DUFFING_MU0_SADDLE_NODE_ONSET_COUNT 3
static inline void duffing_mu0_saddle_node_onset(double m, double zeta, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    (void)(m);
    const double t0 = zeta * zeta;
    out[0] = -256.0 * alpha * t0;
    out[1] = -288.0 * beta * t0;
    out[2] = 27.0 * beta * beta;
}

/* Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.
   Equation from (24), (30). Domain: roots with A > 0.
   Operations: 23 structured, 19 common subexpressions, 16 power chains
 */
#define DUFFING_MU0_SADDLE_NODES_COUNT 6
static inline void duffing_mu0_saddle_nodes(double F_0, double m, double zeta, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    (void)(m);
    const double F_0_2 = F_0 * F_0;
    const double t0 = zeta * zeta;
    const double beta2 = beta * beta;
    const double F_0_4 = F_0_2 * F_0_2;
    const double beta3 = beta * beta2;
    out[0] = 4.0 * F_0_4;
    out[1] = 0.0;
    out[2] = 24.0 * F_0_2 * beta * t0;
    out[3] = -9.0 * F_0_2 * beta2;
    out[4] = 36.0 * alpha * beta2 * t0;
    out[5] = 27.0 * beta3 * t0;
}

/* Cosine balance, -F_0 cos phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_R(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(mu);
    (void)(zeta);
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_mu0_R(Omega, A, average[0]);
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_I(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(p);
    return slow_flow_mu0_I(Omega, A, slow_flow_mu0_friction(mu), zeta);
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_F(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_mu0_F(Omega, A, F_0, slow_flow_mu0_friction(mu), zeta, average[0]);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_F_A(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    duffing_averaged_2(A, p, average);
    return slow_flow_mu0_F_A(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1]);
}

/* d2F/dA2.
   Equation (24), (33). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_F_AA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[3];
    duffing_averaged_3(A, p, average);
    return slow_flow_mu0_F_AA(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1], average[2]);
}

/* d3F/dA3.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_F_AAA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[4];
    duffing_averaged(A, p, average);
    return slow_flow_mu0_F_AAA(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1], average[2], average[3]);
}

/* dF/dOmega.
   Equation (24), (34). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_F_Omega(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_mu0_F_Omega(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0]);
}

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_F_AOmega(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    duffing_averaged_2(A, p, average);
    return slow_flow_mu0_F_AOmega(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1]);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_phase(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_mu0_phase(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0]);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. */
static inline void duffing_mu0_jacobian(double Omega, double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    duffing_averaged_2(A, p, average);
    slow_flow_mu0_jacobian(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1], out);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_stability(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    duffing_averaged_2(A, p, average);
    return slow_flow_mu0_stability(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1]);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. */
static inline double duffing_mu0_transmissibility(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_mu0_transmissibility(Omega, A, F_0, slow_flow_mu0_friction(mu), zeta, average[0]);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. */
static inline double duffing_mu0_backbone(double A, const double *p)
{
    const double average[1] = {
        duffing_h(A, p[0], p[1]),
    };
    return slow_flow_mu0_backbone(A, average[0]);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. */
static inline double duffing_mu0_limit_envelope(double Omega, double F_0, double mu, double zeta)
{
    return slow_flow_mu0_limit_envelope(Omega, F_0, slow_flow_mu0_friction(mu), zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. */
static inline double duffing_mu0_equivalent_damping(double Omega, double A, double mu, double zeta)
{
    return slow_flow_mu0_equivalent_damping(Omega, A, slow_flow_mu0_friction(mu), zeta);
}

#endif
