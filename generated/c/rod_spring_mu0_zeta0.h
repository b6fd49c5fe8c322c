/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, in the scene mu = 0 and zeta = 0.

   Written by `make derive`; never edit.
   Input: derivations/mechanisms/rod_spring.py, sha256 76b1d63466e9529259acb51ca65a45e8a9acd6a1a923137e90a07d40549a4ff1
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. */

#ifndef ROD_SPRING_MU0_ZETA0_H
#define ROD_SPRING_MU0_ZETA0_H

#include <math.h>

#include "slow_flow_mu0_zeta0.h"
#include "rod_spring.h"

/* Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.
   Equation (33). Domain: roots with 0 < A <= u_cr.
   Operations: 6 structured, 6 common subexpressions, 6 power chains
 */
#define ROD_SPRING_MU0_ZETA0_SADDLE_NODE_ONSET_COUNT 3
static inline void rod_spring_mu0_zeta0_saddle_node_onset(double m, double zeta, const double *p, double *out)
{
    const double beta = p[1];
    const double gamma = p[2];
    (void)(m);
    (void)(zeta);
    out[0] = 27.0 * beta * beta;
    out[1] = 120.0 * beta * gamma;
    out[2] = 125.0 * gamma * gamma;
}

/* Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.
   Equation from (24), (30). Domain: roots with 0 < A <= u_cr.
   Operations: 8 structured, 8 common subexpressions, 8 power chains
 */
#define ROD_SPRING_MU0_ZETA0_SADDLE_NODES_COUNT 6
static inline void rod_spring_mu0_zeta0_saddle_nodes(double F_0, double m, double zeta, const double *p, double *out)
{
    const double beta = p[1];
    const double gamma = p[2];
    (void)(m);
    (void)(zeta);
    out[0] = -4.0 * F_0 * F_0;
    out[1] = 0.0;
    out[2] = 0.0;
    out[3] = 9.0 * beta * beta;
    out[4] = 30.0 * beta * gamma;
    out[5] = 25.0 * gamma * gamma;
}

/* Cosine balance, -F_0 cos phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_R(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(mu);
    (void)(zeta);
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_zeta0_R(Omega, A, average[0]);
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_I(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(p);
    return slow_flow_mu0_zeta0_I(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta);
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_F(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_zeta0_F(Omega, A, F_0, slow_flow_mu0_zeta0_friction(mu), zeta, average[0]);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_F_A(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_averaged_2(A, p, average);
    return slow_flow_mu0_zeta0_F_A(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta, average[0], average[1]);
}

/* d2F/dA2.
   Equation (24), (33). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_F_AA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[3];
    rod_spring_averaged_3(A, p, average);
    return slow_flow_mu0_zeta0_F_AA(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta, average[0], average[1], average[2]);
}

/* d3F/dA3.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_F_AAA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[4];
    rod_spring_averaged(A, p, average);
    return slow_flow_mu0_zeta0_F_AAA(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta, average[0], average[1], average[2], average[3]);
}

/* dF/dOmega.
   Equation (24), (34). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_F_Omega(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_zeta0_F_Omega(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta, average[0]);
}

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_F_AOmega(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_averaged_2(A, p, average);
    return slow_flow_mu0_zeta0_F_AOmega(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta, average[0], average[1]);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_phase(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_zeta0_phase(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta, average[0]);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. */
static inline void rod_spring_mu0_zeta0_jacobian(double Omega, double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_averaged_2(A, p, average);
    slow_flow_mu0_zeta0_jacobian(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta, average[0], average[1], out);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_stability(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_averaged_2(A, p, average);
    return slow_flow_mu0_zeta0_stability(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta, average[0], average[1]);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. */
static inline double rod_spring_mu0_zeta0_transmissibility(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_zeta0_transmissibility(Omega, A, F_0, slow_flow_mu0_zeta0_friction(mu), zeta, average[0]);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. */
static inline double rod_spring_mu0_zeta0_backbone(double A, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_zeta0_backbone(A, average[0]);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. */
static inline double rod_spring_mu0_zeta0_limit_envelope(double Omega, double F_0, double mu, double zeta)
{
    return slow_flow_mu0_zeta0_limit_envelope(Omega, F_0, slow_flow_mu0_zeta0_friction(mu), zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_zeta0_equivalent_damping(double Omega, double A, double mu, double zeta)
{
    return slow_flow_mu0_zeta0_equivalent_damping(Omega, A, slow_flow_mu0_zeta0_friction(mu), zeta);
}

#endif
