/* Slow flow of any mechanism, in h = H - A and its derivatives.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
   derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef SLOW_FLOW_H
#define SLOW_FLOW_H

#include <math.h>

#include "inline.h"
#include "angles.h"

SF_FAMILY_BEGIN

/* Dry friction's share of I.
   Equation (23). Domain: mu >= 0. Operations: 1. Error / u (1 + kappa): measured 0.76. */
SF_KERNEL double slow_flow_friction(double mu) {
    return 1.2732395447351628 * mu;
}

/* Cosine balance, -F_0 cos phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. Operations: 3. Error / u (1 + kappa): proved 1.01. */
SF_KERNEL double slow_flow_R(double Omega, double A, double h) {
    return A * Omega * Omega + h;
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. Operations: 4. Error / u (1 + kappa): proved 0.76. */
SF_KERNEL double slow_flow_I(double Omega, double A, double m, double zeta) {
    return 2.0 * A * Omega * zeta + m;
}

/* Frequency response; zero at a steady state.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.4. */
SF_KERNEL double slow_flow_F(double Omega, double A, double F_0, double m, double zeta, double h) {
    const double R = A * Omega * Omega + h;
    const double I_ = 2.0 * A * Omega * zeta + m;
    return R * R + (-F_0 + I_) * (F_0 + I_);
}

/* dF/dA; positive where stable.
   Equation (24), (30). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.1. */
SF_KERNEL double slow_flow_F_A(double Omega, double A, double m, double zeta, double h, double h_A) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = 2.0 * Omega * zeta;
    const double I_ = A * t1 + m;
    return 2.0 * (I_ * t1 + R * (h_A + t0));
}

/* d2F/dA2.
   Equation (24), (33). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.3. */
SF_KERNEL double slow_flow_F_AA(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = h_A + t0;
    return 2.0 * (R * h_AA + 4.0 * t0 * zeta * zeta + t1 * t1);
}

/* dF/dOmega.
   Equation (24), (34). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): proved 3.67. */
SF_KERNEL double slow_flow_F_Omega(double Omega, double A, double m, double zeta, double h) {
    const double R = A * Omega * Omega + h;
    const double I_ = 2.0 * A * Omega * zeta + m;
    return 4.0 * A * (I_ * zeta + Omega * R);
}

/* d2F/dA dOmega.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 17. Error / u (1 + kappa): proved 4.72. */
SF_KERNEL double slow_flow_F_AOmega(double Omega, double A, double m, double zeta, double h, double h_A) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = A * Omega;
    const double t2 = 2.0 * t1;
    const double I_ = m + t2 * zeta;
    return 4.0 * (I_ * zeta + Omega * R + t1 * (h_A + t0) + t2 * zeta * zeta);
}

/* d2F/dOmega2.
   Equation (24). Domain: Omega > 0, A > 0. Operations: 11. Error / u (1 + kappa): proved 2.67. */
SF_KERNEL double slow_flow_F_OmegaOmega(double Omega, double A, double zeta, double h) {
    const double t0 = A * Omega * Omega;
    const double R = h + t0;
    return 4.0 * A * (2.0 * A * zeta * zeta + R + 2.0 * t0);
}

/* Phase phi of a steady state, from -pi to 0.
   Equation (25). Domain: Omega > 0, A > 0. Operations: 8. Error / u (1 + kappa): measured 0.88. */
SF_KERNEL double slow_flow_phase(double Omega, double A, double m, double zeta, double h) {
    const double R = A * Omega * Omega + h;
    const double I_ = 2.0 * A * Omega * zeta + m;
    return angles_atan2(-I_, -R);
}

/* Frequency on the backbone.
   Equation (26). Domain: A > 0, h <= 0. Operations: 2. Error / u (1 + kappa): measured 0.71. */
SF_KERNEL double slow_flow_backbone(double A, double h) {
    const double turn = -h / A;
    return sqrt(turn);
}

/* Largest amplitude that the forcing can hold at this frequency.
   Equation (27). Domain: Omega > 0, F_0 > m; sticks otherwise. Operations: 4. Error / u (1 + kappa): proved 4.01. */
SF_KERNEL double slow_flow_limit_envelope(double Omega, double F_0, double m, double zeta) {
    return 0.5 * (F_0 - m) / (Omega * zeta);
}

/* Viscous damping ratio that dissipates as much as zeta and friction together.
   Equation (38). Domain: Omega > 0, A > 0. Operations: 4. Error / u (1 + kappa): proved 0.76. */
SF_KERNEL double slow_flow_equivalent_damping(double Omega, double A, double m, double zeta) {
    return zeta + 0.5 * m / (A * Omega);
}

/* Fundamental harmonic of the force on the base over F_0, at a steady state.
   Equation from (23). Domain: Omega > 0, A > 0, F_0 > 0. Operations: 6. Error / u (1 + kappa): measured 0.67. */
SF_KERNEL double slow_flow_transmissibility(double Omega, double A, double F_0, double m, double zeta, double h) {
    const double I_ = 2.0 * A * Omega * zeta + m;
    return hypot(h, I_) / F_0;
}

/* Frequency of a state that transmits sqrt(1 - reduction) of what drives it, though it moves.
   Equation from (23). Domain: A > 0, F_0 > 0, 0 <= reduction < 1. Operations: 6 in inwards, 8 in outwards. Error /
   u (1 + kappa): measured 0.83. */
SF_KERNEL double slow_flow_isolation_inwards(double A, double F_0, double reduction, double h) {
    const double removed = F_0 * sqrt(reduction);
    const double whole = hypot(h, removed);
    const double turn = (-h + whole) / A;
    return sqrt(turn);
}

SF_KERNEL double slow_flow_isolation_outwards(double A, double F_0, double reduction, double h) {
    const double removed = F_0 * sqrt(reduction);
    const double whole = hypot(h, removed);
    const double turn = removed * removed / (A * (h + whole));
    return sqrt(turn);
}

SF_KERNEL double slow_flow_isolation(double A, double F_0, double reduction, double h) {
    if (h <= 0.0)
        return slow_flow_isolation_inwards(A, F_0, reduction, h);
    else
        return slow_flow_isolation_outwards(A, F_0, reduction, h);
}

/* The forcing up to which a mass at rest stays there: that of a state as A tends to 0.
   Equation (24). Domain: preload >= 0, -h as A tends to 0. Operations: 1. Error / u (1 + kappa): measured 0.5. */
SF_KERNEL double slow_flow_held(double m, double preload) {
    return hypot(m, preload);
}

/* Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22.
   Equation (28). Domain: Omega > 0, A > 0. Operations: 13. Error / u (1 + kappa): proved 0.0, 2.01, 3.01, 3.01. */
SF_KERNEL void slow_flow_jacobian(double Omega, double A, double m, double zeta, double h, double h_A, double *out) {
    const double t0 = Omega * Omega;
    const double t1 = 0.5 / Omega;
    const double t2 = t1 / A;
    out[0] = -zeta;
    out[1] = t1 * (A * t0 + h);
    out[2] = t2 * (-h_A - t0);
    out[3] = t2 * (-2.0 * A * Omega * zeta - m);
}

/* 4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive.
   Equation (30). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.1. */
SF_KERNEL double slow_flow_stability(double Omega, double A, double m, double zeta, double h, double h_A) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = 2.0 * Omega * zeta;
    const double I_ = A * t1 + m;
    return (I_ * t1 + R * (h_A + t0)) / A;
}

/* F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24). Domain: A > 0. Operations: 15. Error / u (1 + kappa): proved -, 0.51, 1.61, 0.34; measured 0.98. */
SF_KERNEL void slow_flow_response_quartic(double A, double F_0, double m, double zeta, double h, double *out) {
    const double t0 = A * A;
    out[0] = h * h + (-F_0 + m) * (F_0 + m);
    out[1] = 4.0 * A * m * zeta;
    out[2] = 2.0 * A * h + 4.0 * t0 * zeta * zeta;
    out[3] = t0;
}

/* F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24), (30). Domain: A > 0. Operations: 8. Error / u (1 + kappa): proved 0.34, 0.34, 2.34, 0.0. */
SF_KERNEL void slow_flow_fold_quartic(double A, double m, double zeta, double h, double h_A, double *out) {
    out[0] = h * h_A;
    out[1] = 2.0 * m * zeta;
    out[2] = A * (h_A + 4.0 * zeta * zeta) + h;
    out[3] = A;
}

/* F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3.
   Equation (34). Domain: A > 0. Operations: 5. Error / u (1 + kappa): proved 0.34, 1.01, 0.0. */
SF_KERNEL void slow_flow_peak_cubic(double A, double m, double zeta, double h, double *out) {
    out[0] = m * zeta;
    out[1] = 2.0 * A * zeta * zeta + h;
    out[2] = A;
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: A > 0. Operations: 37. Error / u (1 + kappa): proved -, -, 6.67, 0.0; measured 1.3. */
#define SLOW_FLOW_DETACHMENT_COUNT 4
SF_KERNEL void slow_flow_detachment(double A, double m, double zeta, double h, double *out) {
    const double m2 = m * m;
    const double zeta2 = zeta * zeta;
    const double t0 = A * zeta2;
    const double t1 = h + t0;
    const double t2 = h * t0;
    const double t3 = h * h;
    const double zeta4 = zeta2 * zeta2;
    const double t4 = A * A * zeta4;
    const double t5 = -t3;
    const double t6 = m2 + 4.0 * t2;
    const double m4 = m2 * m2;
    out[0] = -t6 * t6 * (m2 + t1 * t1);
    out[1] = 2.0 * m2 * (t2 + t3 + 10.0 * t4) + 3.0 * m4 - 8.0 * t0 * t1 * (-2.0 * t2 - 2.0 * t4 - t5);
    out[2] = -3.0 * m2 + 8.0 * t2 + 8.0 * t4 + t5;
    out[3] = 1.0;
}

/* The forcing F_0 for which (Omega, A) is a steady state.
   Equation (24). Domain: Omega >= 0, A > 0. Operations: 11. Error / u (1 + kappa): measured 1.4. */
SF_KERNEL double slow_flow_level(double Omega, double A, double m, double zeta, double h) {
    const double R = A * Omega * Omega + h;
    const double I_ = 2.0 * A * Omega * zeta + m;
    return sqrt(I_ * I_ + R * R);
}

/* F at Omega = 0 as a product: h - c, h + c, and the slope of both along A.
   Equation from (24). Domain: F_0 >= m. Operations: 6. Error / u (1 + kappa): measured 1.2. */
SF_KERNEL void slow_flow_rest(double F_0, double m, double h, double h_A, double *out) {
    const double product = -(-F_0 + m) * (F_0 + m);
    const double c = sqrt(product);
    out[0] = -c + h;
    out[1] = c + h;
    out[2] = h_A;
}

/* The |h| of a state at Omega = 0, and the least |h - A h_A| of a fold.
   Equation from (24), (30). Domain: F_0 >= m. Operations: 5. Error / u (1 + kappa): measured 1.1. */
SF_KERNEL double slow_flow_least_restoring(double F_0, double m) {
    return sqrt(F_0 - m) * sqrt(F_0 + m);
}

/* k = h - A h_A, where the tangent of h meets A = 0, and its slope along A.
   Equation from (24), (30). Domain: A >= 0. Operations: 3. Error / u (1 + kappa): proved 1.01, 0.34. */
SF_KERNEL void slow_flow_intercept(double A, double h, double h_A, double h_AA, double *out) {
    out[0] = -A * h_A + h;
    out[1] = -A * h_AA;
}

/* The largest |h| of a state with this amplitude: F_0 + (A Omega)^2/A at the highest Omega.
   Equation from (23). Domain: A > 0, F_0 >= m, zeta > 0. Operations: 6. Error / u (1 + kappa): measured 0.85. */
SF_KERNEL double slow_flow_most_restoring(double A, double F_0, double m, double zeta) {
    const double c = -0.5 * (-F_0 + m) / zeta;
    const double fastest = c / A;
    return F_0 + c * fastest;
}

/* Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega.
   Equation from (24), (30). Domain: A > 0, F_0 > m, k^2 >= F_0^2 - m^2. Operations: 48. Error / u (1 + kappa):
   measured 1.9. */
SF_KERNEL void slow_flow_fold(double A, double F_0, double m, double zeta, double h, double h_A, double k, double k_A, double *out) {
    const double excess = (F_0 - m) * (F_0 + m);
    const double least = sqrt(excess);
    const double t0 = 1.0 / k;
    const double t1 = least * t0;
    const double share = sqrt((1.0 - t1) * (t1 + 1.0));
    const double J = excess / (F_0 + m * share);
    const double t2 = 1.0 / share;
    const double lag = excess / (F_0 * t2 + m);
    const double t3 = J * t0;
    const double t4 = 1.0 / (zeta * zeta);
    const double t5 = 1.0 / A;
    const double t6 = t4 * t5;
    const double t7 = 0.25 * lag * lag;
    out[0] = -F_0 * t3 + h + t6 * t7;
    out[1] = F_0 * J * J * k_A * (0.5 * t3 * t6 + (F_0 + m * t2) / excess) / (k * k) + h_A - t4 * t7 / (A * A);
    out[2] = 0.5 * lag * t5 / zeta;
}

/* Omega^2 beside a fold by the R of F = F_A = 0, from the Omega by I and what R lacks of agreeing (`fold`).
   Equation from (23). Domain: A > 0. Operations: 3. Error / u (1 + kappa): proved 1.01. */
SF_KERNEL double slow_flow_fold_square(double Omega, double A, double lacks) {
    return Omega * Omega - lacks / A;
}

/* What F and F_A change by beside a fold, per what vanishes there (`fold`), at its A, Omega and I.
   Equation from (24), (30). Domain: A > 0. Operations: 4. Error / u (1 + kappa): proved 0.0, 3.01. */
SF_KERNEL void slow_flow_fold_moves(double A, double k, double R, double *out) {
    const double t0 = 2.0 * R;
    out[0] = t0;
    out[1] = -2.0 * (k - t0) / A;
}

/* Omega at an isola point.
   Equation from (30), (34). Domain: h_A >= 0. Operations: 1. Error / u (1 + kappa): measured 0.67. */
SF_KERNEL double slow_flow_isola_Omega(double h_A) {
    return sqrt(h_A);
}

/* The forcing at an isola point: of R from h rounding leaves nothing where damping is weak.
   Equation from (24), (30). Domain: Omega > 0. Operations: 7. Error / u (1 + kappa): measured 0.98. */
SF_KERNEL double slow_flow_isola_level(double Omega, double A, double m, double zeta) {
    const double I_ = 2.0 * A * Omega * zeta + m;
    return hypot(I_, -I_ * zeta / Omega);
}

/* Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A.
   Equation from (30), (34). Domain: A > 0, h_A > 0; for m = 0 any h_A. Operations: 18. Error / u (1 + kappa):
   measured 1.7. */
SF_KERNEL void slow_flow_isola(double A, double m, double zeta, double h, double h_A, double h_AA, double *out) {
    const double w = sqrt(h_A);
    const double t0 = 2.0 * zeta * zeta;
    const double bracket = A * (h_A + t0) + h;
    const double bracket_A = A * h_AA + 2.0 * h_A + t0;
    out[0] = bracket * w + m * zeta;
    out[1] = 0.5 * bracket * h_AA / w + bracket_A * w;
}

/* F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d.
   Equation from (33). Domain: A > 0. Operations: 15. Error / u (1 + kappa): proved 1.01, 1.01, 1.51, 1.01, -;
   measured 0.89. */
SF_KERNEL void slow_flow_cusps(double A, double zeta, double h, double h_A, double h_AA, double k, double *out) {
    const double t0 = zeta * zeta;
    const double half_e = 0.5 * A * h_AA + 2.0 * t0;
    const double t1 = 4.0 * h_A * t0 - h_AA * k;
    out[0] = half_e;
    out[1] = -t1;
    out[2] = h_A + half_e;
    out[3] = h * h_AA + h_A * h_A;
    out[4] = half_e * half_e + t1;
}

/* R where F_AA = 0 (`cusps`), in two forms: by its tangent, and from F_AA itself.
   Equation from (33). Domain: A > 0, X >= 0. Operations: 8. Error / u (1 + kappa): proved 1.01, 1.81. */
SF_KERNEL void slow_flow_cusp_R(double A, double zeta, double h_AA, double k, double X, double T, double *out) {
    out[0] = A * T + k;
    out[1] = (-T * T - 4.0 * X * zeta * zeta) / h_AA;
}

/* Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0.
   Equation from (33). Domain: A > 0, X > 0. Operations: 37. Error / u (1 + kappa): measured 1.2. */
SF_KERNEL void slow_flow_cusp(double A, double m, double zeta, double h_AA, double h_AAA, double k, double X, double T, double R, double root, double *out) {
    const double w = sqrt(X);
    const double t0 = m * zeta;
    const double t1 = 2.0 * t0 * w;
    const double t2 = 4.0 * A * zeta * zeta;
    out[0] = R * T + X * t2 + t1;
    out[1] = -A * h_AA * k + T * (-A * A * h_AA + k) + t1;
    out[2] = 0.5 * (R * h_AAA + 3.0 * T * h_AA) * (-A * T - R - t0 / w - t2) / root;
    out[3] = sqrt(A * t1 + R * k + m * m);
}

/* Omega^2 and F_0^2 at a cusp with R from F_A = 0, by an X = Omega^2 that is nearly right, and T (`cusps`).
   Equation from (30). Domain: A > 0, X > 0, T not 0. Operations: 14. Error / u (1 + kappa): measured 0.98. */
SF_KERNEL void slow_flow_cusp_balance(double A, double m, double zeta, double h, double k, double X, double T, double *out) {
    const double w = sqrt(X);
    const double t0 = 2.0 * w * zeta;
    const double t1 = A * t0;
    const double R = t0 * (-m - t1) / T;
    out[0] = (R - h) / A;
    out[1] = R * k + m * m + m * t1;
}

/* F_A/2 where F_AOmega = 0, an extremum of F_A over Omega, and its slope along A.
   Equation from (30). Domain: Omega > 0, A > 0. Operations: 28. Error / u (1 + kappa): measured 1.5. */
SF_KERNEL void slow_flow_turn(double Omega, double A, double m, double zeta, double h_AA, double k, double *out) {
    const double t0 = A * Omega * zeta;
    const double I_ = m + 2.0 * t0;
    const double drawn = 0.5 * zeta * (m + 4.0 * t0) / Omega;
    const double t1 = 0.5 * k;
    const double t2 = -drawn - t1;
    const double t3 = -drawn + t1;
    out[0] = 2.0 * I_ * Omega * zeta + t2 * t3 / A;
    out[1] = 4.0 * Omega * Omega * zeta * zeta + h_AA * t3 + t2 * t2 / (A * A);
}

/* F where F_Omega = 0: an extremum of F over Omega, and its slope along A.
   Equation from (24), (34). Domain: Omega > 0, A > 0. Operations: 18. Error / u (1 + kappa): proved -, 3.67;
   measured 1.1. */
SF_KERNEL void slow_flow_peak(double Omega, double A, double F_0, double m, double zeta, double h_A, double *out) {
    const double t0 = 2.0 * A;
    const double R = -t0 * zeta * zeta - m * zeta / Omega;
    const double I_ = Omega * t0 * zeta + m;
    out[0] = R * R + (-F_0 + I_) * (F_0 + I_);
    out[1] = -2.0 * R * (Omega * Omega - h_A);
}

/* dOmega/dA along F_Omega = 0: what a rounding of A does to Omega at a peak.
   Equation from (34). Domain: Omega > 0, A > 0. Operations: 12. Error / u (1 + kappa): measured 1.6. */
SF_KERNEL double slow_flow_peak_Omega_A(double Omega, double A, double m, double zeta, double h_A) {
    const double Omega2 = Omega * Omega;
    const double Omega3 = Omega * Omega2;
    return Omega2 * (Omega2 + h_A + 2.0 * zeta * zeta) / (-2.0 * A * Omega3 + m * zeta);
}

/* Mean of the stiffness over a cycle of a motion about u = 0, which stays about it where this is positive.
   Equation beside (30). Domain: A > 0. Operations: 4. Error / u (1 + kappa): proved 1.01. */
SF_KERNEL double slow_flow_mean_stiffness(double A, double h, double h_A) {
    return -0.5 * h_A - 0.5 * h / A;
}

/* What carries a small mean offset back; where the mean stiffness is negative this decides.
   Equation beside (30). Domain: Omega > 0, A > 0. Operations: 18 in over, 14 in apart. Error / u (1 + kappa):
   measured 2. */
SF_KERNEL double slow_flow_offset_stiffness_over(double Omega, double A, double h, double h_A) {
    const double t0 = Omega * Omega;
    const double t1 = 1.0 / A;
    const double t2 = h * t1;
    const double t3 = 4.0 * t0;
    return (h_A * (0.5 * h_A - 3.0 * t2 - t3) + t2 * (0.5 * h * t1 - t3)) / (h_A + 8.0 * t0 + t2);
}

SF_KERNEL double slow_flow_offset_stiffness_apart(double Omega, double A, double h, double h_A) {
    const double t0 = 1.0 / A;
    const double t1 = h * t0;
    const double t2 = h * t0 - h_A;
    return -0.5 * h_A - 0.5 * t1 + t2 * t2 / (8.0 * Omega * Omega + h_A + t1);
}

SF_KERNEL double slow_flow_offset_stiffness(double Omega, double A, double h, double h_A) {
    if (0.5 * fabs(h_A) + 0.5 * fabs(h) / A <= fabs(8.0 * Omega * Omega + h_A + h / A))
        return slow_flow_offset_stiffness_over(Omega, A, h, h_A);
    else
        return slow_flow_offset_stiffness_apart(Omega, A, h, h_A);
}

/* dOmega/dA along the response.
   Equation from (24). Domain: Omega > 0, A > 0. Operations: 18. Error / u (1 + kappa): measured 1.9. */
SF_KERNEL double slow_flow_Omega_A(double Omega, double A, double m, double zeta, double h, double h_A) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = 2.0 * Omega;
    const double I_ = A * t1 * zeta + m;
    const double t2 = I_ * zeta;
    const double F_A = 2.0 * (R * (h_A + t0) + t1 * t2);
    const double F_Omega = 4.0 * A * (Omega * R + t2);
    return -F_A / F_Omega;
}

/* Positive where the level rises with A along the fold locus, negative where it falls.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 28. Error / u (1 + kappa): measured 1.3. */
SF_KERNEL double slow_flow_level_rise(double Omega, double A, double m, double zeta, double h, double h_A, double h_AA) {
    const double t0 = Omega * Omega;
    const double R = A * t0 + h;
    const double t1 = A * Omega;
    const double t2 = 2.0 * t1;
    const double I_ = m + t2 * zeta;
    const double t3 = h_A + t0;
    const double t4 = zeta * zeta;
    const double F_AA = 2.0 * (R * h_AA + 4.0 * t0 * t4 + t3 * t3);
    const double t5 = I_ * zeta + Omega * R;
    const double F_Omega = 4.0 * A * t5;
    const double F_AOmega = 4.0 * (t1 * t3 + t2 * t4 + t5);
    return -F_AA * F_AOmega * F_Omega;
}

/* Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum; T = dR/dA.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 30. Error / u (1 + kappa): measured 0.97. */
SF_KERNEL double slow_flow_cusp_bend(double Omega, double A, double zeta, double h_AA, double h_AAA, double T) {
    const double t0 = Omega * Omega;
    const double t1 = 4.0 * t0 * zeta * zeta;
    const double R = (-T * T - t1) / h_AA;
    const double F_AAA = 2.0 * (R * h_AAA + 3.0 * T * h_AA);
    const double t2 = 2.0 * t0;
    const double t3 = 2.0 / Omega;
    const double F_Omega = A * R * t3 * (-T + t2);
    const double F_AOmega = t3 * (A * T * t2 + A * t1 - R * T + R * t2);
    return -F_AAA * F_AOmega * F_Omega / A;
}

/* The same at an isola point.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 33. Error / u (1 + kappa): measured 1. */
SF_KERNEL double slow_flow_isola_bend(double Omega, double A, double m, double zeta, double h_AA) {
    const double t0 = 2.0 * A;
    const double t1 = Omega * t0 * zeta + m;
    const double R = -t1 * zeta / Omega;
    const double Omega2 = Omega * Omega;
    const double t2 = 4.0 * zeta * zeta;
    const double Omega4 = Omega2 * Omega2;
    const double F_AA = 2.0 * (Omega2 * t2 + 4.0 * Omega4 + R * h_AA);
    const double Omega3 = Omega * Omega2;
    const double Omega5 = Omega * Omega4;
    return 8.0 * A * F_AA * t1 * zeta * (-Omega3 * h_AA * t0 - Omega3 * t2 - 4.0 * Omega5 + h_AA * m * zeta) /
        Omega2;
}

/* F_AA F_OmegaOmega - F_AOmega^2 at an isola point: negative at a saddle.
   Equation from (24), (30). Domain: Omega > 0, A > 0. Operations: 24. Error / u (1 + kappa): proved 14.01. */
SF_KERNEL double slow_flow_isola_hessian(double Omega, double A, double m, double zeta, double h_AA) {
    const double t0 = 2.0 * A;
    const double Omega2 = Omega * Omega;
    const double Omega3 = Omega * Omega2;
    const double Omega4 = Omega2 * Omega2;
    const double Omega5 = Omega * Omega4;
    return 8.0 * A * zeta * (Omega * t0 * zeta + m) * (-Omega3 * h_AA * t0 - 4.0 * Omega3 * zeta * zeta - 4.0 *
        Omega5 + h_AA * m * zeta) / Omega2;
}

/* An amplitude of the size of that far above resonance.
   Equation from (24). Domain: Omega > 0, F_0 >= m. Operations: 7. Error / u (1 + kappa): measured 1.7. */
SF_KERNEL double slow_flow_tail(double Omega, double F_0, double m) {
    const double square = (F_0 - m) * (F_0 + m);
    return sqrt(square) / (Omega * Omega + 1.0);
}

/* F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4.
   Equation (24). Domain: m = 0, A > 0. Operations: 10. Error / u (1 + kappa): proved -, 0.0, 1.61, 0.34; measured
   0.92. */
SF_KERNEL void slow_flow_response_quartic_mu0(double A, double F_0, double zeta, double h, double *out) {
    const double t0 = A * A;
    out[0] = (-F_0 + h) * (F_0 + h);
    out[1] = 0.0;
    out[2] = 2.0 * A * h + 4.0 * t0 * zeta * zeta;
    out[3] = t0;
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: m = 0, A > 0. Operations: 14. Error / u (1 + kappa): proved 4.01, 5.67, 0.0. */
#define SLOW_FLOW_DETACHMENT_MU0_COUNT 3
SF_KERNEL void slow_flow_detachment_mu0(double A, double zeta, double h, double *out) {
    const double t0 = h * h;
    const double zeta2 = zeta * zeta;
    const double t1 = A * zeta2;
    const double t2 = 4.0 * t1;
    const double zeta4 = zeta2 * zeta2;
    out[0] = -t0 * t2 * (h + t1);
    out[1] = 4.0 * A * A * zeta4 + h * t2 - t0;
    out[2] = 1.0;
}

/* Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A.
   Equation from (30), (34). Domain: m = 0, A > 0, h_A > 0; for m = 0 any h_A. Operations: 9. Error / u (1 + kappa):
   proved 2.34, 1.67. */
SF_KERNEL void slow_flow_isola_mu0(double A, double zeta, double h, double h_A, double h_AA, double *out) {
    const double t0 = 2.0 * zeta * zeta;
    const double bracket = A * (h_A + t0) + h;
    const double bracket_A = A * h_AA + 2.0 * h_A + t0;
    out[0] = bracket;
    out[1] = bracket_A;
}

/* Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega.
   Equation from (24), (30). Domain: m = 0, A > 0, F_0 > m, k^2 >= F_0^2 - m^2. Operations: 39. Error / u (1 +
   kappa): measured 1.4. */
SF_KERNEL void slow_flow_fold_mu0(double A, double F_0, double zeta, double h, double h_A, double k, double k_A, double *out) {
    const double excess = F_0 * F_0;
    const double least = sqrt(excess);
    const double t0 = 1.0 / k;
    const double t1 = least * t0;
    const double share = sqrt((1.0 - t1) * (t1 + 1.0));
    const double t2 = excess / F_0;
    const double lag = share * t2;
    const double t3 = t0 * t2;
    const double t4 = 1.0 / (zeta * zeta);
    const double t5 = 1.0 / A;
    const double t6 = t4 * t5;
    const double t7 = 0.25 * lag * lag;
    out[0] = -F_0 * t3 + h + t6 * t7;
    out[1] = F_0 * k_A * t2 * t2 * (F_0 / excess + 0.5 * t3 * t6) / (k * k) + h_A - t4 * t7 / (A * A);
    out[2] = 0.5 * lag * t5 / zeta;
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: zeta = 0, A > 0. Operations: 6. Error / u (1 + kappa): proved 0.81, 0.67, 0.0. */
#define SLOW_FLOW_DETACHMENT_ZETA0_COUNT 3
SF_KERNEL void slow_flow_detachment_zeta0(double m, double h, double *out) {
    const double t0 = m * m;
    const double t1 = h * h;
    out[0] = t0 * (t0 + t1);
    out[1] = -2.0 * t0 - t1;
    out[2] = 1.0;
}

/* Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A.
   Equation from (24), (30). Domain: zeta = 0, F_0 > m. Operations: 9. Error / u (1 + kappa): measured 0.62. */
SF_KERNEL void slow_flow_fold_zeta0(double F_0, double m, double k, double k_A, double *out) {
    const double excess = (F_0 - m) * (F_0 + m);
    const double least = sqrt(excess);
    out[0] = (k - least) * (k + least);
    out[1] = 2.0 * k * k_A;
}

/* Omega of the folds.
   Equation from (30). Domain: zeta = 0, h_A <= 0. Operations: 1. Error / u (1 + kappa): measured 0.67. */
SF_KERNEL double slow_flow_undamped_Omega(double h_A) {
    return sqrt(-h_A);
}

/* The forcing of a fold, whose R is k.
   Equation from (24), (30). Domain: zeta = 0, h_A <= 0. Operations: 4. Error / u (1 + kappa): measured 0.99. */
SF_KERNEL double slow_flow_undamped_level(double m, double k) {
    return sqrt(k * k + m * m);
}

/* The sign of the level's slope along A on the undamped folds; and, where that is 0, of the slope's own.
   Equation from (24), (30). Domain: zeta = 0, h_A <= 0. Operations: 2. Error / u (1 + kappa): proved 0.34, 0.34. */
SF_KERNEL void slow_flow_undamped_rises(double h_AA, double h_AAA, double k, double *out) {
    out[0] = -h_AA * k;
    out[1] = -h_AAA * k;
}

/* The factors of F_AA/2 at the folds, each with its slope along A: h_AA, R.
   Equation from (30), (33). Domain: zeta = 0, A > 0. Operations: 3. Error / u (1 + kappa): proved 0.0, 0.0, 1.01,
   0.34. */
SF_KERNEL void slow_flow_undamped(double A, double h, double h_A, double h_AA, double h_AAA, double *out) {
    out[0] = h_AA;
    out[1] = h_AAA;
    out[2] = -A * h_A + h;
    out[3] = -A * h_AA;
}

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: m = 0, zeta = 0, A > 0. Operations: 1. Error / u (1 + kappa): proved 0.34, 0.0. */
#define SLOW_FLOW_DETACHMENT_MU0_ZETA0_COUNT 2
SF_KERNEL void slow_flow_detachment_mu0_zeta0(double h, double *out) {
    out[0] = -h * h;
    out[1] = 1.0;
}

SF_FAMILY_END

#endif
