/* Slow flow of any mechanism, in h = H - A and its derivatives: on whole intervals.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
   derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of slow_flow.h. */

#ifndef SLOW_FLOW_INTERVALS_H
#define SLOW_FLOW_INTERVALS_H

#include "interval.h"
#include "inline.h"
#include "arithmetic_intervals.h"

SF_FAMILY_BEGIN

/* Dry friction's share of I. */
static inline sf_interval slow_flow_intervals_friction(sf_interval mu) {
    return MUL(CONSTANT(1.2732395447351628, -7.8714706700729944e-17), mu);
}

/* Cosine balance, -F_0 cos phi at a fixed point. */
static inline sf_interval slow_flow_intervals_R(sf_interval Omega, sf_interval A, sf_interval h) {
    return ADD(MUL(A, SQUARE(Omega)), h);
}

/* Frequency response; zero at a steady state. */
static inline sf_interval slow_flow_intervals_F(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h) {
    const sf_interval R = ADD(MUL(A, SQUARE(Omega)), h);
    const sf_interval I_ = ADD(TIMES(2.0, MUL(MUL(A, Omega), zeta)), m);
    return ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
}

/* dF/dA; positive where stable. */
static inline sf_interval slow_flow_intervals_F_A(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A) {
    const sf_interval t0 = SQUARE(Omega);
    const sf_interval R = ADD(MUL(A, t0), h);
    const sf_interval t1 = TIMES(2.0, MUL(Omega, zeta));
    const sf_interval I_ = ADD(MUL(A, t1), m);
    return TIMES(2.0, ADD(MUL(I_, t1), MUL(R, ADD(h_A, t0))));
}

/* d2F/dA2. */
static inline sf_interval slow_flow_intervals_F_AA(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA) {
    const sf_interval t0 = SQUARE(Omega);
    const sf_interval R = ADD(MUL(A, t0), h);
    const sf_interval t1 = ADD(h_A, t0);
    return TIMES(2.0, ADD(ADD(MUL(R, h_AA), TIMES(4.0, MUL(t0, SQUARE(zeta)))), SQUARE(t1)));
}

/* dF/dOmega. */
static inline sf_interval slow_flow_intervals_F_Omega(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h) {
    const sf_interval R = ADD(MUL(A, SQUARE(Omega)), h);
    const sf_interval I_ = ADD(TIMES(2.0, MUL(MUL(A, Omega), zeta)), m);
    return TIMES(4.0, MUL(A, ADD(MUL(I_, zeta), MUL(Omega, R))));
}

/* d2F/dA dOmega. */
static inline sf_interval slow_flow_intervals_F_AOmega(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A) {
    const sf_interval t0 = SQUARE(Omega);
    const sf_interval R = ADD(MUL(A, t0), h);
    const sf_interval t1 = MUL(A, Omega);
    const sf_interval t2 = TIMES(2.0, t1);
    const sf_interval I_ = ADD(m, MUL(t2, zeta));
    return TIMES(4.0, ADD(ADD(ADD(MUL(I_, zeta), MUL(Omega, R)), MUL(t1, ADD(h_A, t0))), MUL(t2, SQUARE(zeta))));
}

/* d2F/dOmega2. */
static inline sf_interval slow_flow_intervals_F_OmegaOmega(sf_interval Omega, sf_interval A, sf_interval zeta, sf_interval h) {
    const sf_interval t0 = MUL(A, SQUARE(Omega));
    const sf_interval R = ADD(h, t0);
    return TIMES(4.0, MUL(A, ADD(ADD(TIMES(2.0, MUL(A, SQUARE(zeta))), R), TIMES(2.0, t0))));
}

/* Frequency on the backbone. */
static inline sf_interval slow_flow_intervals_backbone(sf_interval A, sf_interval h) {
    const sf_interval turn = NEG(DIV(h, A));
    return SQRT(turn);
}

/* F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. */
static inline void slow_flow_intervals_fold_quartic(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval *out) {
    out[0] = MUL(h, h_A);
    out[1] = TIMES(2.0, MUL(m, zeta));
    out[2] = ADD(MUL(A, ADD(h_A, TIMES(4.0, SQUARE(zeta)))), h);
    out[3] = A;
}

/* F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3. */
static inline void slow_flow_intervals_peak_cubic(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval *out) {
    out[0] = MUL(m, zeta);
    out[1] = ADD(TIMES(2.0, MUL(A, SQUARE(zeta))), h);
    out[2] = A;
}

/* The forcing F_0 for which (Omega, A) is a steady state. */
static inline sf_interval slow_flow_intervals_level(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h) {
    const sf_interval R = ADD(MUL(A, SQUARE(Omega)), h);
    const sf_interval I_ = ADD(TIMES(2.0, MUL(MUL(A, Omega), zeta)), m);
    return SQRT(ADD(SQUARE(I_), SQUARE(R)));
}

/* The |h| of a state at Omega = 0, and the least |h - A h_A| of a fold. */
static inline sf_interval slow_flow_intervals_least_restoring(sf_interval F_0, sf_interval m) {
    return MUL(SQRT(SUB(F_0, m)), SQRT(ADD(F_0, m)));
}

/* k = h - A h_A, where the tangent of h meets A = 0, and its slope along A. */
static inline void slow_flow_intervals_intercept(sf_interval A, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval *out) {
    out[0] = ADD(NEG(MUL(A, h_A)), h);
    out[1] = NEG(MUL(A, h_AA));
}

/* F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.
   Equation (34). Domain: Omega > 0, A > 0. */
static inline void slow_flow_intervals_F_Omega_reduced(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval *out) {
    const sf_interval p = ADD(TIMES(2.0, MUL(A, SQUARE(zeta))), h);
    const sf_interval t0 = MUL(A, SQUARE(Omega));
    out[0] = ADD(MUL(Omega, ADD(p, t0)), MUL(m, zeta));
    out[1] = ADD(p, TIMES(3.0, t0));
}

/* R by its definition, and by its tangent along A, which meets A = 0 at k = h - A h_A.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_intervals_state_R(sf_interval Omega, sf_interval A, sf_interval h, sf_interval h_A, sf_interval k, sf_interval *out) {
    const sf_interval t0 = SQUARE(Omega);
    out[0] = ADD(MUL(A, t0), h);
    out[1] = ADD(MUL(A, ADD(h_A, t0)), k);
}

/* F and its first two derivatives along A, by R (`state_R`).
   Equation (24), (30), (33). Domain: Omega > 0, A > 0. */
static inline void slow_flow_intervals_state(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h_A, sf_interval h_AA, sf_interval R, sf_interval *out) {
    const sf_interval t0 = TIMES(2.0, MUL(Omega, zeta));
    const sf_interval I_ = ADD(MUL(A, t0), m);
    const sf_interval t1 = SQUARE(Omega);
    const sf_interval t2 = ADD(h_A, t1);
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = TIMES(2.0, ADD(MUL(I_, t0), MUL(R, t2)));
    out[2] = TIMES(2.0, ADD(ADD(MUL(R, h_AA), TIMES(4.0, MUL(t1, SQUARE(zeta)))), SQUARE(t2)));
}

/* The largest |h| of a state with this amplitude: F_0 + (A Omega)^2/A at the highest Omega. */
static inline sf_interval slow_flow_intervals_most_restoring(sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta) {
    const sf_interval c = NEG(DIV(TIMES(0.5, ADD(NEG(F_0), m)), zeta));
    const sf_interval fastest = DIV(c, A);
    return ADD(F_0, MUL(c, fastest));
}

/* Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega. */
static inline void slow_flow_intervals_fold(sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval k, sf_interval k_A, sf_interval *out) {
    const sf_interval excess = MUL(SUB(F_0, m), ADD(F_0, m));
    const sf_interval least = SQRT(excess);
    const sf_interval t0 = INVERSE(k);
    const sf_interval t1 = MUL(least, t0);
    const sf_interval share = SQRT(MUL(SUB(POINT(1.0), t1), ADD(t1, POINT(1.0))));
    const sf_interval J = DIV(excess, ADD(F_0, MUL(m, share)));
    const sf_interval t2 = INVERSE(share);
    const sf_interval lag = DIV(excess, ADD(MUL(F_0, t2), m));
    const sf_interval t3 = MUL(J, t0);
    const sf_interval t4 = INVERSE(SQUARE(zeta));
    const sf_interval t5 = INVERSE(A);
    const sf_interval t6 = MUL(t4, t5);
    const sf_interval t7 = TIMES(0.25, SQUARE(lag));
    out[0] = ADD(ADD(NEG(MUL(F_0, t3)), h), MUL(t6, t7));
    out[1] = SUB(ADD(DIV(MUL(MUL(MUL(F_0, SQUARE(J)), k_A), ADD(TIMES(0.5, MUL(t3, t6)), DIV(ADD(F_0, MUL(m, t2)),
        excess))), SQUARE(k)), h_A), DIV(MUL(t4, t7), SQUARE(A)));
    out[2] = DIV(TIMES(0.5, MUL(lag, t5)), zeta);
}

/* F_A/(2 A) without friction as X^2 + b X + c in X = Omega^2, by h/A and h/A - h_A: b, and b^2 - 4 c.
   Equation from (30). Domain: A > 0. */
static inline void slow_flow_intervals_fold_least(sf_interval zeta, sf_interval h_A, sf_interval over_A, sf_interval apart, sf_interval *out) {
    const sf_interval t0 = SQUARE(zeta);
    const sf_interval t1 = ADD(h_A, over_A);
    out[0] = ADD(TIMES(4.0, t0), t1);
    out[1] = ADD(SQUARE(apart), TIMES(8.0, MUL(t0, ADD(TIMES(2.0, t0), t1))));
}

/* Omega at an isola point. */
static inline sf_interval slow_flow_intervals_isola_Omega(sf_interval h_A) {
    return SQRT(h_A);
}

/* Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A. */
static inline void slow_flow_intervals_isola(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval *out) {
    const sf_interval w = SQRT(h_A);
    const sf_interval t0 = TIMES(2.0, SQUARE(zeta));
    const sf_interval bracket = ADD(MUL(A, ADD(h_A, t0)), h);
    const sf_interval bracket_A = ADD(ADD(MUL(A, h_AA), TIMES(2.0, h_A)), t0);
    out[0] = ADD(MUL(bracket, w), MUL(m, zeta));
    out[1] = ADD(DIV(TIMES(0.5, MUL(bracket, h_AA)), w), MUL(bracket_A, w));
}

/* F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d. */
static inline void slow_flow_intervals_cusps(sf_interval A, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval k, sf_interval *out) {
    const sf_interval t0 = SQUARE(zeta);
    const sf_interval half_e = ADD(TIMES(0.5, MUL(A, h_AA)), TIMES(2.0, t0));
    const sf_interval t1 = SUB(TIMES(4.0, MUL(h_A, t0)), MUL(h_AA, k));
    out[0] = half_e;
    out[1] = NEG(t1);
    out[2] = ADD(h_A, half_e);
    out[3] = ADD(MUL(h, h_AA), SQUARE(h_A));
    out[4] = ADD(SQUARE(half_e), t1);
}

/* R where F_AA = 0 (`cusps`), in two forms: by its tangent, and from F_AA itself. */
static inline void slow_flow_intervals_cusp_R(sf_interval A, sf_interval zeta, sf_interval h_AA, sf_interval k, sf_interval X, sf_interval T, sf_interval *out) {
    out[0] = ADD(MUL(A, T), k);
    out[1] = DIV(SUB(NEG(SQUARE(T)), TIMES(4.0, MUL(X, SQUARE(zeta)))), h_AA);
}

/* Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0. */
static inline void slow_flow_intervals_cusp(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h_AA, sf_interval h_AAA, sf_interval k, sf_interval X, sf_interval T, sf_interval R, sf_interval root, sf_interval *out) {
    const sf_interval w = SQRT(X);
    const sf_interval t0 = MUL(m, zeta);
    const sf_interval t1 = TIMES(2.0, MUL(t0, w));
    const sf_interval t2 = TIMES(4.0, MUL(A, SQUARE(zeta)));
    out[0] = ADD(ADD(MUL(R, T), MUL(X, t2)), t1);
    out[1] = ADD(ADD(NEG(MUL(MUL(A, h_AA), k)), MUL(T, ADD(NEG(MUL(SQUARE(A), h_AA)), k))), t1);
    out[2] = DIV(TIMES(0.5, MUL(ADD(MUL(R, h_AAA), TIMES(3.0, MUL(T, h_AA))), SUB(SUB(SUB(NEG(MUL(A, T)), R),
        DIV(t0, w)), t2))), root);
    out[3] = SQRT(ADD(ADD(MUL(A, t1), MUL(R, k)), SQUARE(m)));
}

/* F_A/2 where F_AOmega = 0, an extremum of F_A over Omega, and its slope along A. */
static inline void slow_flow_intervals_turn(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h_AA, sf_interval k, sf_interval *out) {
    const sf_interval t0 = MUL(MUL(A, Omega), zeta);
    const sf_interval I_ = ADD(m, TIMES(2.0, t0));
    const sf_interval drawn = DIV(TIMES(0.5, MUL(zeta, ADD(m, TIMES(4.0, t0)))), Omega);
    const sf_interval t1 = TIMES(0.5, k);
    const sf_interval t2 = SUB(NEG(drawn), t1);
    const sf_interval t3 = ADD(NEG(drawn), t1);
    out[0] = ADD(TIMES(2.0, MUL(MUL(I_, Omega), zeta)), DIV(MUL(t2, t3), A));
    out[1] = ADD(ADD(TIMES(4.0, MUL(SQUARE(Omega), SQUARE(zeta))), MUL(h_AA, t3)), DIV(SQUARE(t2), SQUARE(A)));
}

/* F where F_Omega = 0: an extremum of F over Omega, and its slope along A. */
static inline void slow_flow_intervals_peak(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h_A, sf_interval *out) {
    const sf_interval t0 = TIMES(2.0, A);
    const sf_interval R = SUB(NEG(MUL(t0, SQUARE(zeta))), DIV(MUL(m, zeta), Omega));
    const sf_interval I_ = ADD(MUL(MUL(Omega, t0), zeta), m);
    out[0] = ADD(SQUARE(R), MUL(ADD(NEG(F_0), I_), ADD(F_0, I_)));
    out[1] = NEG(TIMES(2.0, MUL(R, SUB(SQUARE(Omega), h_A))));
}

/* Positive where the level rises with A along the fold locus, negative where it falls. */
static inline sf_interval slow_flow_intervals_level_rise(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA) {
    const sf_interval t0 = SQUARE(Omega);
    const sf_interval R = ADD(MUL(A, t0), h);
    const sf_interval t1 = MUL(A, Omega);
    const sf_interval t2 = TIMES(2.0, t1);
    const sf_interval I_ = ADD(m, MUL(t2, zeta));
    const sf_interval t3 = ADD(h_A, t0);
    const sf_interval t4 = SQUARE(zeta);
    const sf_interval F_AA = TIMES(2.0, ADD(ADD(MUL(R, h_AA), TIMES(4.0, MUL(t0, t4))), SQUARE(t3)));
    const sf_interval t5 = ADD(MUL(I_, zeta), MUL(Omega, R));
    const sf_interval F_Omega = TIMES(4.0, MUL(A, t5));
    const sf_interval F_AOmega = TIMES(4.0, ADD(ADD(MUL(t1, t3), MUL(t2, t4)), t5));
    return NEG(MUL(MUL(F_AA, F_AOmega), F_Omega));
}

/* Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum; T = dR/dA. */
static inline sf_interval slow_flow_intervals_cusp_bend(sf_interval Omega, sf_interval A, sf_interval zeta, sf_interval h_AA, sf_interval h_AAA, sf_interval T) {
    const sf_interval t0 = SQUARE(Omega);
    const sf_interval t1 = TIMES(4.0, MUL(t0, SQUARE(zeta)));
    const sf_interval R = DIV(SUB(NEG(SQUARE(T)), t1), h_AA);
    const sf_interval F_AAA = TIMES(2.0, ADD(MUL(R, h_AAA), TIMES(3.0, MUL(T, h_AA))));
    const sf_interval t2 = TIMES(2.0, t0);
    const sf_interval t3 = DIV(POINT(2.0), Omega);
    const sf_interval F_Omega = MUL(MUL(MUL(A, R), t3), ADD(NEG(T), t2));
    const sf_interval F_AOmega = MUL(t3, ADD(SUB(ADD(MUL(MUL(A, T), t2), MUL(A, t1)), MUL(R, T)), MUL(R, t2)));
    return NEG(DIV(MUL(MUL(F_AAA, F_AOmega), F_Omega), A));
}

/* The same at an isola point. */
static inline sf_interval slow_flow_intervals_isola_bend(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h_AA) {
    const sf_interval t0 = TIMES(2.0, A);
    const sf_interval t1 = ADD(MUL(MUL(Omega, t0), zeta), m);
    const sf_interval R = NEG(DIV(MUL(t1, zeta), Omega));
    const sf_interval Omega2 = SQUARE(Omega);
    const sf_interval t2 = TIMES(4.0, SQUARE(zeta));
    const sf_interval Omega4 = SQUARE(Omega2);
    const sf_interval F_AA = TIMES(2.0, ADD(ADD(MUL(Omega2, t2), TIMES(4.0, Omega4)), MUL(R, h_AA)));
    const sf_interval Omega3 = MUL(Omega, Omega2);
    const sf_interval Omega5 = MUL(Omega, Omega4);
    return DIV(TIMES(8.0, MUL(MUL(MUL(MUL(A, F_AA), t1), zeta), ADD(SUB(SUB(NEG(MUL(MUL(Omega3, h_AA), t0)),
        MUL(Omega3, t2)), TIMES(4.0, Omega5)), MUL(MUL(h_AA, m), zeta)))), Omega2);
}

/* Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A. */
static inline void slow_flow_intervals_isola_mu0(sf_interval A, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval *out) {
    const sf_interval t0 = TIMES(2.0, SQUARE(zeta));
    const sf_interval bracket = ADD(MUL(A, ADD(h_A, t0)), h);
    const sf_interval bracket_A = ADD(ADD(MUL(A, h_AA), TIMES(2.0, h_A)), t0);
    out[0] = bracket;
    out[1] = bracket_A;
}

/* F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.
   Equation (34). Domain: m = 0, Omega > 0, A > 0. */
static inline void slow_flow_intervals_F_Omega_reduced_mu0(sf_interval Omega, sf_interval A, sf_interval zeta, sf_interval h, sf_interval *out) {
    const sf_interval t0 = TIMES(2.0, A);
    const sf_interval p = ADD(h, MUL(t0, SQUARE(zeta)));
    out[0] = ADD(MUL(A, SQUARE(Omega)), p);
    out[1] = MUL(Omega, t0);
}

/* Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A. */
static inline void slow_flow_intervals_fold_zeta0(sf_interval F_0, sf_interval m, sf_interval k, sf_interval k_A, sf_interval *out) {
    const sf_interval excess = MUL(SUB(F_0, m), ADD(F_0, m));
    const sf_interval least = SQRT(excess);
    out[0] = MUL(SUB(k, least), ADD(k, least));
    out[1] = TIMES(2.0, MUL(k, k_A));
}

/* F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.
   Equation (34). Domain: zeta = 0, Omega > 0, A > 0. */
static inline void slow_flow_intervals_F_Omega_reduced_zeta0(sf_interval Omega, sf_interval A, sf_interval h, sf_interval *out) {
    out[0] = ADD(MUL(A, SQUARE(Omega)), h);
    out[1] = TIMES(2.0, MUL(A, Omega));
}

/* Omega of the folds. */
static inline sf_interval slow_flow_intervals_undamped_Omega(sf_interval h_A) {
    return SQRT(NEG(h_A));
}

SF_FAMILY_END

#include "arithmetic_end.h"
#endif
