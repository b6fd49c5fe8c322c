/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr; amplitudes up to u_cr only.

   Written by `make derive`; never edit.
   Input: derivations/mechanisms/rod_spring.py, sha256 76b1d63466e9529259acb51ca65a45e8a9acd6a1a923137e90a07d40549a4ff1
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Everything is dimensionless. C99. `p` holds the mechanism's parameters in their order, `out` takes the outputs.
   Operations are counted after each pass. */

#ifndef ROD_SPRING_ATTACHED_H
#define ROD_SPRING_ATTACHED_H

#include <math.h>

#include "slow_flow.h"
#include "rod_spring.h"

/* h, h_A, h_AA, h_AAA together.
   Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 28 structured, 19 common subexpressions, 19 power chains
 */
static inline void rod_spring_attached_averaged(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double gamma = p[2];
    const double t0 = -alpha;
    const double t1 = A * A;
    const double t2 = gamma * t1;
    const double t3 = 4.5 * beta;
    out[0] = A * (t0 + t1 * (-0.75 * beta - 0.625 * t2));
    out[1] = t0 + t1 * (-2.25 * beta - 3.125 * t2);
    out[2] = A * (-12.5 * t2 - t3);
    out[3] = -37.5 * t2 - t3;
}

/* h, h_A, h_AA together.
   Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 23 structured, 17 common subexpressions, 17 power chains
 */
static inline void rod_spring_attached_averaged_3(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double gamma = p[2];
    const double t0 = -alpha;
    const double t1 = A * A;
    const double t2 = gamma * t1;
    out[0] = A * (t0 + t1 * (-0.75 * beta - 0.625 * t2));
    out[1] = t0 + t1 * (-2.25 * beta - 3.125 * t2);
    out[2] = A * (-4.5 * beta - 12.5 * t2);
}

/* h, h_A together.
   Equation (20)-(22), (31). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 17 structured, 13 common subexpressions, 13 power chains
 */
static inline void rod_spring_attached_averaged_2(double A, const double *p, double *out)
{
    const double alpha = p[0];
    const double beta = p[1];
    const double gamma = p[2];
    const double t0 = -alpha;
    const double t1 = A * A;
    const double t2 = gamma * t1;
    out[0] = A * (t0 + t1 * (-0.75 * beta - 0.625 * t2));
    out[1] = t0 + t1 * (-2.25 * beta - 3.125 * t2);
}

/* The averaged restoring force h = H - A.
   Equation (20)-(22). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 9 structured, 8 common subexpressions, 8 power chains
 */
static inline double rod_spring_attached_h(double A, double alpha, double beta, double gamma, double u_cr)
{
    (void)(u_cr);
    const double t0 = A * A;
    return A * (-alpha + t0 * (-0.75 * beta - 0.625 * gamma * t0));
}

/* d/dA of the averaged restoring force h = H - A.
   Equation (31). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 8 structured, 7 common subexpressions, 7 power chains
 */
static inline double rod_spring_attached_h_A(double A, double alpha, double beta, double gamma, double u_cr)
{
    (void)(u_cr);
    const double t0 = A * A;
    return -alpha + t0 * (-2.25 * beta - 3.125 * gamma * t0);
}

/* d2/dA2 of the averaged restoring force h = H - A.
   Equation from (31). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 6 structured, 6 common subexpressions, 6 power chains
 */
static inline double rod_spring_attached_h_AA(double A, double alpha, double beta, double gamma, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
    return A * (-12.5 * A * A * gamma - 4.5 * beta);
}

/* d3/dA3 of the averaged restoring force h = H - A.
   Equation from (31). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 5 structured, 5 common subexpressions, 5 power chains
 */
static inline double rod_spring_attached_h_AAA(double A, double alpha, double beta, double gamma, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
    return -37.5 * A * A * gamma - 4.5 * beta;
}

/* The averaged force H beside the vertical spring.
   Equation (20)-(22). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 10 structured, 9 common subexpressions, 9 power chains
 */
static inline double rod_spring_attached_H(double A, double alpha, double beta, double gamma, double u_cr)
{
    (void)(u_cr);
    const double t0 = A * A;
    return A * (-alpha + t0 * (-0.75 * beta - 0.625 * gamma * t0) + 1.0);
}

/* d/dA of the averaged force H beside the vertical spring.
   Equation (31). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 9 structured, 8 common subexpressions, 8 power chains
 */
static inline double rod_spring_attached_H_A(double A, double alpha, double beta, double gamma, double u_cr)
{
    (void)(u_cr);
    const double t0 = A * A;
    return -alpha + t0 * (-2.25 * beta - 3.125 * gamma * t0) + 1.0;
}

/* d2/dA2 of the averaged force H beside the vertical spring.
   Equation from (31). Domain: 0 <= A <= u_cr.
   Operations where passed_0: 6 structured, 6 common subexpressions, 6 power chains
 */
static inline double rod_spring_attached_H_AA(double A, double alpha, double beta, double gamma, double u_cr)
{
    (void)(alpha);
    (void)(u_cr);
    return A * (-12.5 * A * A * gamma - 4.5 * beta);
}

/* Cosine balance, -F_0 cos phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_R(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(mu);
    (void)(zeta);
    const double average[1] = {
        rod_spring_attached_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_R(Omega, A, average[0]);
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_I(double Omega, double A, double mu, double zeta, const double *p)
{
    (void)(p);
    return slow_flow_I(Omega, A, slow_flow_friction(mu), zeta);
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_F(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_attached_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_F_A(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_attached_averaged_2(A, p, average);
    return slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* d2F/dA2.
   Equation (24), (33). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_F_AA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[3];
    rod_spring_attached_averaged_3(A, p, average);
    return slow_flow_F_AA(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], average[2]);
}

/* d3F/dA3.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_F_AAA(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[4];
    rod_spring_attached_averaged(A, p, average);
    return slow_flow_F_AAA(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], average[2], average[3]);
}

/* dF/dOmega.
   Equation (24), (34). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_F_Omega(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_attached_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_F_Omega(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_F_AOmega(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_attached_averaged_2(A, p, average);
    return slow_flow_F_AOmega(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_phase(double Omega, double A, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_attached_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. */
static inline void rod_spring_attached_jacobian(double Omega, double A, double mu, double zeta, const double *p, double *out)
{
    double average[2];
    rod_spring_attached_averaged_2(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], out);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_stability(double Omega, double A, double mu, double zeta, const double *p)
{
    double average[2];
    rod_spring_attached_averaged_2(A, p, average);
    return slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. */
static inline double rod_spring_attached_transmissibility(double Omega, double A, double F_0, double mu, double zeta, const double *p)
{
    const double average[1] = {
        rod_spring_attached_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. */
static inline double rod_spring_attached_backbone(double A, const double *p)
{
    const double average[1] = {
        rod_spring_attached_h(A, p[0], p[1], p[2], p[3]),
    };
    return slow_flow_backbone(A, average[0]);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. */
static inline double rod_spring_attached_limit_envelope(double Omega, double F_0, double mu, double zeta)
{
    return slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. */
static inline double rod_spring_attached_equivalent_damping(double Omega, double A, double mu, double zeta)
{
    return slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
}

#endif
