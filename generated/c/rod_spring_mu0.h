/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, in the scene mu = 0.

   Written by `make derive`; never edit.
   Input: derivations/mechanisms/rod_spring.py, sha256 76b1d63466e9529259acb51ca65a45e8a9acd6a1a923137e90a07d40549a4ff1
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. */

#ifndef ROD_SPRING_MU0_H
#define ROD_SPRING_MU0_H

#include <math.h>

#include "slow_flow_mu0.h"
#include "rod_spring.h"

/* Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.
   Equation (33). Domain: roots with 0 < A <= u_cr.
   Operations: 60 structured, 44 common subexpressions, 38 power chains
 */
#define ROD_SPRING_MU0_SADDLE_NODE_ONSET_COUNT 7
static inline void rod_spring_mu0_saddle_node_onset(double m, double zeta, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double gamma = p[2];
    (void)(m);
    const double t0 = zeta * zeta;
    const double beta2 = beta * beta;
    const double t1 = beta2 * t0;
    const double beta3 = beta * beta2;
    const double gamma2 = gamma * gamma;
    const double t2 = gamma2 * t0;
    const double gamma3 = gamma * gamma2;
    const double beta4 = beta2 * beta2;
    const double gamma4 = gamma2 * gamma2;
    out[0] = -2304.0 * alpha * t1;
    out[1] = -11520.0 * alpha * beta * gamma * t0 - 2592.0 * beta3 * t0;
    out[2] = -14400.0 * alpha * t2 + 243.0 * beta4 - 15120.0 * gamma * t1;
    out[3] = -27600.0 * beta * t2 + 1890.0 * beta3 * gamma;
    out[4] = 5400.0 * beta2 * gamma2 - 15000.0 * gamma3 * t0;
    out[5] = 6750.0 * beta * gamma3;
    out[6] = 3125.0 * gamma4;
}

/* Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.
   Equation from (24), (30). Domain: roots with 0 < A <= u_cr.
   Operations: 66 structured, 48 common subexpressions, 44 power chains
 */
#define ROD_SPRING_MU0_SADDLE_NODES_COUNT 9
static inline void rod_spring_mu0_saddle_nodes(double F_0, double m, double zeta, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double gamma = p[2];
    (void)(m);
    const double F_0_2 = F_0 * F_0;
    const double t0 = zeta * zeta;
    const double beta2 = beta * beta;
    const double t1 = beta * gamma;
    const double gamma2 = gamma * gamma;
    const double t2 = alpha * t0;
    const double F_0_4 = F_0_2 * F_0_2;
    const double beta3 = beta * beta2;
    const double gamma3 = gamma * gamma2;
    out[0] = 8.0 * F_0_4;
    out[1] = 0.0;
    out[2] = 48.0 * F_0_2 * beta * t0;
    out[3] = -18.0 * F_0_2 * beta2 + 80.0 * F_0_2 * gamma * t0;
    out[4] = -60.0 * F_0_2 * t1 + 72.0 * alpha * beta2 * t0;
    out[5] = -50.0 * F_0_2 * gamma2 + 54.0 * beta3 * t0 + 240.0 * t1 * t2;
    out[6] = 225.0 * beta2 * gamma * t0 + 200.0 * gamma2 * t2;
    out[7] = 300.0 * beta * gamma2 * t0;
    out[8] = 125.0 * gamma3 * t0;
}

/* Cosine balance, -F_0 cos phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_R(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(mu);
    (void)(zeta);
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_R(Omega, A, average[0]);
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_I(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(p);
    return slow_flow_mu0_I(Omega, A, slow_flow_mu0_friction(mu), zeta);
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_F(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_F(Omega, A, F_0, slow_flow_mu0_friction(mu), zeta, average[0]);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_F_A(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_averaged_2(A, p, average);
    return slow_flow_mu0_F_A(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1]);
}

/* d2F/dA2.
   Equation (24), (33). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_F_AA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[3];
    rod_spring_averaged_3(A, p, average);
    return slow_flow_mu0_F_AA(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1], average[2]);
}

/* d3F/dA3.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_F_AAA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[4];
    rod_spring_averaged(A, p, average);
    return slow_flow_mu0_F_AAA(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1], average[2], average[3]);
}

/* dF/dOmega.
   Equation (24), (34). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_F_Omega(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_F_Omega(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0]);
}

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_F_AOmega(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_averaged_2(A, p, average);
    return slow_flow_mu0_F_AOmega(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1]);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_phase(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_phase(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0]);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. */
static inline void rod_spring_mu0_jacobian(double Omega, double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_averaged_2(A, p, average);
    slow_flow_mu0_jacobian(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1], out);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_stability(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_averaged_2(A, p, average);
    return slow_flow_mu0_stability(Omega, A, slow_flow_mu0_friction(mu), zeta, average[0], average[1]);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. */
static inline double rod_spring_mu0_transmissibility(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_transmissibility(Omega, A, F_0, slow_flow_mu0_friction(mu), zeta, average[0]);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. */
static inline double rod_spring_mu0_backbone(double A, const double *p)
{
    const double average[1] = {
        rod_spring_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_mu0_backbone(A, average[0]);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. */
static inline double rod_spring_mu0_limit_envelope(double Omega, double F_0, double mu, double zeta)
{
    return slow_flow_mu0_limit_envelope(Omega, F_0, slow_flow_mu0_friction(mu), zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. */
static inline double rod_spring_mu0_equivalent_damping(double Omega, double A, double mu, double zeta)
{
    return slow_flow_mu0_equivalent_damping(Omega, A, slow_flow_mu0_friction(mu), zeta);
}

#endif
