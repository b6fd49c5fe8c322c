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

SF_FAMILY_BEGIN

/* Dry friction's share of I. */
static inline sf_interval slow_flow_intervals_friction(sf_interval mu)
{
    return sfi_mul(sfi_around(1.2732395447351628), mu);
}

/* Cosine balance, -F_0 cos phi at a fixed point. */
static inline sf_interval slow_flow_intervals_R(sf_interval Omega, sf_interval A, sf_interval h)
{
    return sfi_add(sfi_mul(A, sfi_square(Omega)), h);
}

/* Frequency response; zero at a steady state. */
static inline sf_interval slow_flow_intervals_F(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h)
{
    const sf_interval R = sfi_add(sfi_mul(A, sfi_square(Omega)), h);
    const sf_interval I_ = sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, Omega), zeta)), m);
    return sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
}

/* dF/dA; positive where stable. */
static inline sf_interval slow_flow_intervals_F_A(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A)
{
    const sf_interval t0 = sfi_square(Omega);
    const sf_interval R = sfi_add(sfi_mul(A, t0), h);
    const sf_interval t1 = sfi_times(2.0, sfi_mul(Omega, zeta));
    const sf_interval I_ = sfi_add(sfi_mul(A, t1), m);
    return sfi_times(2.0, sfi_add(sfi_mul(I_, t1), sfi_mul(R, sfi_add(h_A, t0))));
}

/* d2F/dA2. */
static inline sf_interval slow_flow_intervals_F_AA(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA)
{
    const sf_interval t0 = sfi_square(Omega);
    const sf_interval R = sfi_add(sfi_mul(A, t0), h);
    const sf_interval t1 = sfi_add(h_A, t0);
    return sfi_times(2.0, sfi_add(sfi_add(sfi_mul(R, h_AA), sfi_times(4.0, sfi_mul(t0, sfi_square(zeta)))),
        sfi_square(t1)));
}

/* dF/dOmega. */
static inline sf_interval slow_flow_intervals_F_Omega(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h)
{
    const sf_interval R = sfi_add(sfi_mul(A, sfi_square(Omega)), h);
    const sf_interval I_ = sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, Omega), zeta)), m);
    return sfi_times(4.0, sfi_mul(A, sfi_add(sfi_mul(I_, zeta), sfi_mul(Omega, R))));
}

/* d2F/dA dOmega. */
static inline sf_interval slow_flow_intervals_F_AOmega(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A)
{
    const sf_interval t0 = sfi_square(Omega);
    const sf_interval R = sfi_add(sfi_mul(A, t0), h);
    const sf_interval t1 = sfi_mul(A, Omega);
    const sf_interval t2 = sfi_times(2.0, t1);
    const sf_interval I_ = sfi_add(m, sfi_mul(t2, zeta));
    return sfi_times(4.0, sfi_add(sfi_add(sfi_add(sfi_mul(I_, zeta), sfi_mul(Omega, R)), sfi_mul(t1,
        sfi_add(h_A, t0))), sfi_mul(t2, sfi_square(zeta))));
}

/* d2F/dOmega2. */
static inline sf_interval slow_flow_intervals_F_OmegaOmega(sf_interval Omega, sf_interval A, sf_interval zeta, sf_interval h)
{
    const sf_interval t0 = sfi_mul(A, sfi_square(Omega));
    const sf_interval R = sfi_add(h, t0);
    return sfi_times(4.0, sfi_mul(A, sfi_add(sfi_add(sfi_times(2.0, sfi_mul(A, sfi_square(zeta))), R),
        sfi_times(2.0, t0))));
}

/* Frequency on the backbone. */
static inline sf_interval slow_flow_intervals_backbone(sf_interval A, sf_interval h)
{
    const sf_interval turn = sfi_neg(sfi_div(h, A));
    return sfi_sqrt(turn);
}

/* F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. */
static inline void slow_flow_intervals_fold_quartic(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval *out)
{
    out[0] = sfi_mul(h, h_A);
    out[1] = sfi_times(2.0, sfi_mul(m, zeta));
    out[2] = sfi_add(sfi_mul(A, sfi_add(h_A, sfi_times(4.0, sfi_square(zeta)))), h);
    out[3] = A;
}

/* F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3. */
static inline void slow_flow_intervals_peak_cubic(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval *out)
{
    out[0] = sfi_mul(m, zeta);
    out[1] = sfi_add(sfi_times(2.0, sfi_mul(A, sfi_square(zeta))), h);
    out[2] = A;
}

/* The forcing F_0 for which (Omega, A) is a steady state. */
static inline sf_interval slow_flow_intervals_level(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h)
{
    const sf_interval R = sfi_add(sfi_mul(A, sfi_square(Omega)), h);
    const sf_interval I_ = sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, Omega), zeta)), m);
    return sfi_sqrt(sfi_add(sfi_square(I_), sfi_square(R)));
}

/* The |h| of a state at Omega = 0, and the least |h - A h_A| of a fold. */
static inline sf_interval slow_flow_intervals_least_restoring(sf_interval F_0, sf_interval m)
{
    return sfi_mul(sfi_sqrt(sfi_sub(F_0, m)), sfi_sqrt(sfi_add(F_0, m)));
}

/* k = h - A h_A, where the tangent of h meets A = 0, and its slope along A. */
static inline void slow_flow_intervals_intercept(sf_interval A, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval *out)
{
    out[0] = sfi_add(sfi_neg(sfi_mul(A, h_A)), h);
    out[1] = sfi_neg(sfi_mul(A, h_AA));
}

/* The largest |h| of a state with this amplitude: F_0 + (A Omega)^2/A at the highest Omega. */
static inline sf_interval slow_flow_intervals_most_restoring(sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta)
{
    const sf_interval c = sfi_neg(sfi_div(sfi_times(0.5, sfi_add(sfi_neg(F_0), m)), zeta));
    const sf_interval fastest = sfi_div(c, A);
    return sfi_add(F_0, sfi_mul(c, fastest));
}

/* Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega. */
static inline void slow_flow_intervals_fold(sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval k, sf_interval k_A, sf_interval *out)
{
    const sf_interval excess = sfi_mul(sfi_sub(F_0, m), sfi_add(F_0, m));
    const sf_interval least = sfi_sqrt(excess);
    const sf_interval t0 = sfi_inverse(k);
    const sf_interval t1 = sfi_mul(least, t0);
    const sf_interval share = sfi_sqrt(sfi_mul(sfi_sub(sfi_point(1.0), t1), sfi_add(t1, sfi_point(1.0))));
    const sf_interval J = sfi_div(excess, sfi_add(F_0, sfi_mul(m, share)));
    const sf_interval t2 = sfi_inverse(share);
    const sf_interval lag = sfi_div(excess, sfi_add(sfi_mul(F_0, t2), m));
    const sf_interval t3 = sfi_mul(J, t0);
    const sf_interval t4 = sfi_inverse(sfi_square(zeta));
    const sf_interval t5 = sfi_inverse(A);
    const sf_interval t6 = sfi_mul(t4, t5);
    const sf_interval t7 = sfi_times(0.25, sfi_square(lag));
    out[0] = sfi_add(sfi_add(sfi_neg(sfi_mul(F_0, t3)), h), sfi_mul(t6, t7));
    out[1] = sfi_sub(sfi_add(sfi_div(sfi_mul(sfi_mul(sfi_mul(F_0, sfi_square(J)), k_A), sfi_add(sfi_times(0.5,
        sfi_mul(t3, t6)), sfi_div(sfi_add(F_0, sfi_mul(m, t2)), excess))), sfi_square(k)), h_A), sfi_div(sfi_mul(t4,
        t7), sfi_square(A)));
    out[2] = sfi_div(sfi_times(0.5, sfi_mul(lag, t5)), zeta);
}

/* Omega at an isola point. */
static inline sf_interval slow_flow_intervals_isola_Omega(sf_interval h_A)
{
    return sfi_sqrt(h_A);
}

/* Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A. */
static inline void slow_flow_intervals_isola(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval *out)
{
    const sf_interval w = sfi_sqrt(h_A);
    const sf_interval t0 = sfi_times(2.0, sfi_square(zeta));
    const sf_interval bracket = sfi_add(sfi_mul(A, sfi_add(h_A, t0)), h);
    const sf_interval bracket_A = sfi_add(sfi_add(sfi_mul(A, h_AA), sfi_times(2.0, h_A)), t0);
    out[0] = sfi_add(sfi_mul(bracket, w), sfi_mul(m, zeta));
    out[1] = sfi_add(sfi_div(sfi_times(0.5, sfi_mul(bracket, h_AA)), w), sfi_mul(bracket_A, w));
}

/* F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d. */
static inline void slow_flow_intervals_cusps(sf_interval A, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval k, sf_interval *out)
{
    const sf_interval t0 = sfi_square(zeta);
    const sf_interval half_e = sfi_add(sfi_times(0.5, sfi_mul(A, h_AA)), sfi_times(2.0, t0));
    const sf_interval t1 = sfi_sub(sfi_times(4.0, sfi_mul(h_A, t0)), sfi_mul(h_AA, k));
    out[0] = half_e;
    out[1] = sfi_neg(t1);
    out[2] = sfi_add(h_A, half_e);
    out[3] = sfi_add(sfi_mul(h, h_AA), sfi_square(h_A));
    out[4] = sfi_add(sfi_square(half_e), t1);
}

/* R where F_AA = 0 (`cusps`), in two forms: by its tangent, and from F_AA itself. */
static inline void slow_flow_intervals_cusp_R(sf_interval A, sf_interval zeta, sf_interval h_AA, sf_interval k, sf_interval X, sf_interval T, sf_interval *out)
{
    out[0] = sfi_add(sfi_mul(A, T), k);
    out[1] = sfi_div(sfi_sub(sfi_neg(sfi_square(T)), sfi_times(4.0, sfi_mul(X, sfi_square(zeta)))), h_AA);
}

/* Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0. */
static inline void slow_flow_intervals_cusp(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h_AA, sf_interval h_AAA, sf_interval k, sf_interval X, sf_interval T, sf_interval R, sf_interval root, sf_interval *out)
{
    const sf_interval w = sfi_sqrt(X);
    const sf_interval t0 = sfi_mul(m, zeta);
    const sf_interval t1 = sfi_times(2.0, sfi_mul(t0, w));
    const sf_interval t2 = sfi_times(4.0, sfi_mul(A, sfi_square(zeta)));
    out[0] = sfi_add(sfi_add(sfi_mul(R, T), sfi_mul(X, t2)), t1);
    out[1] = sfi_add(sfi_add(sfi_neg(sfi_mul(sfi_mul(A, h_AA), k)), sfi_mul(T,
        sfi_add(sfi_neg(sfi_mul(sfi_square(A), h_AA)), k))), t1);
    out[2] = sfi_div(sfi_times(0.5, sfi_mul(sfi_add(sfi_mul(R, h_AAA), sfi_times(3.0, sfi_mul(T, h_AA))),
        sfi_sub(sfi_sub(sfi_sub(sfi_neg(sfi_mul(A, T)), R), sfi_div(t0, w)), t2))), root);
    out[3] = sfi_sqrt(sfi_add(sfi_add(sfi_mul(A, t1), sfi_mul(R, k)), sfi_square(m)));
}

/* F_A/2 where F_AOmega = 0, an extremum of F_A over Omega, and its slope along A. */
static inline void slow_flow_intervals_turn(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h_AA, sf_interval k, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(sfi_mul(A, Omega), zeta);
    const sf_interval I_ = sfi_add(m, sfi_times(2.0, t0));
    const sf_interval drawn = sfi_div(sfi_times(0.5, sfi_mul(zeta, sfi_add(m, sfi_times(4.0, t0)))), Omega);
    const sf_interval t1 = sfi_times(0.5, k);
    const sf_interval t2 = sfi_sub(sfi_neg(drawn), t1);
    const sf_interval t3 = sfi_add(sfi_neg(drawn), t1);
    out[0] = sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(I_, Omega), zeta)), sfi_div(sfi_mul(t2, t3), A));
    out[1] = sfi_add(sfi_add(sfi_times(4.0, sfi_mul(sfi_square(Omega), sfi_square(zeta))), sfi_mul(h_AA, t3)),
        sfi_div(sfi_square(t2), sfi_square(A)));
}

/* F where F_Omega = 0: an extremum of F over Omega, and its slope along A. */
static inline void slow_flow_intervals_peak(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h_A, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, A);
    const sf_interval R = sfi_sub(sfi_neg(sfi_mul(t0, sfi_square(zeta))), sfi_div(sfi_mul(m, zeta), Omega));
    const sf_interval I_ = sfi_add(sfi_mul(sfi_mul(Omega, t0), zeta), m);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_neg(sfi_times(2.0, sfi_mul(R, sfi_sub(sfi_square(Omega), h_A))));
}

/* Positive where the level rises with A along the fold locus, negative where it falls. */
static inline sf_interval slow_flow_intervals_level_rise(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA)
{
    const sf_interval t0 = sfi_square(Omega);
    const sf_interval R = sfi_add(sfi_mul(A, t0), h);
    const sf_interval t1 = sfi_mul(A, Omega);
    const sf_interval t2 = sfi_times(2.0, t1);
    const sf_interval I_ = sfi_add(m, sfi_mul(t2, zeta));
    const sf_interval t3 = sfi_add(h_A, t0);
    const sf_interval t4 = sfi_square(zeta);
    const sf_interval F_AA = sfi_times(2.0, sfi_add(sfi_add(sfi_mul(R, h_AA), sfi_times(4.0, sfi_mul(t0, t4))),
        sfi_square(t3)));
    const sf_interval t5 = sfi_add(sfi_mul(I_, zeta), sfi_mul(Omega, R));
    const sf_interval F_Omega = sfi_times(4.0, sfi_mul(A, t5));
    const sf_interval F_AOmega = sfi_times(4.0, sfi_add(sfi_add(sfi_mul(t1, t3), sfi_mul(t2, t4)), t5));
    return sfi_neg(sfi_mul(sfi_mul(F_AA, F_AOmega), F_Omega));
}

/* Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum; T = dR/dA. */
static inline sf_interval slow_flow_intervals_cusp_bend(sf_interval Omega, sf_interval A, sf_interval zeta, sf_interval h_AA, sf_interval h_AAA, sf_interval T)
{
    const sf_interval t0 = sfi_square(Omega);
    const sf_interval t1 = sfi_times(4.0, sfi_mul(t0, sfi_square(zeta)));
    const sf_interval R = sfi_div(sfi_sub(sfi_neg(sfi_square(T)), t1), h_AA);
    const sf_interval F_AAA = sfi_times(2.0, sfi_add(sfi_mul(R, h_AAA), sfi_times(3.0, sfi_mul(T, h_AA))));
    const sf_interval t2 = sfi_times(2.0, t0);
    const sf_interval t3 = sfi_div(sfi_point(2.0), Omega);
    const sf_interval F_Omega = sfi_mul(sfi_mul(sfi_mul(A, R), t3), sfi_add(sfi_neg(T), t2));
    const sf_interval F_AOmega = sfi_mul(t3, sfi_add(sfi_sub(sfi_add(sfi_mul(sfi_mul(A, T), t2), sfi_mul(A, t1)),
        sfi_mul(R, T)), sfi_mul(R, t2)));
    return sfi_neg(sfi_div(sfi_mul(sfi_mul(F_AAA, F_AOmega), F_Omega), A));
}

/* The same at an isola point. */
static inline sf_interval slow_flow_intervals_isola_bend(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h_AA)
{
    const sf_interval t0 = sfi_times(2.0, A);
    const sf_interval t1 = sfi_add(sfi_mul(sfi_mul(Omega, t0), zeta), m);
    const sf_interval R = sfi_neg(sfi_div(sfi_mul(t1, zeta), Omega));
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t2 = sfi_times(4.0, sfi_square(zeta));
    const sf_interval Omega4 = sfi_square(Omega2);
    const sf_interval F_AA = sfi_times(2.0, sfi_add(sfi_add(sfi_mul(Omega2, t2), sfi_times(4.0, Omega4)), sfi_mul(R,
        h_AA)));
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    const sf_interval Omega5 = sfi_mul(Omega, Omega4);
    return sfi_div(sfi_times(8.0, sfi_mul(sfi_mul(sfi_mul(sfi_mul(A, F_AA), t1), zeta),
        sfi_add(sfi_sub(sfi_sub(sfi_neg(sfi_mul(sfi_mul(Omega3, h_AA), t0)), sfi_mul(Omega3, t2)), sfi_times(4.0,
        Omega5)), sfi_mul(sfi_mul(h_AA, m), zeta)))), Omega2);
}

/* F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.
   Equation (34). Domain: Omega > 0, A > 0. */
static inline void slow_flow_intervals_F_Omega_reduced(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval *out)
{
    const sf_interval p = sfi_add(sfi_times(2.0, sfi_mul(A, sfi_square(zeta))), h);
    const sf_interval t0 = sfi_mul(A, sfi_square(Omega));
    out[0] = sfi_add(sfi_mul(Omega, sfi_add(p, t0)), sfi_mul(m, zeta));
    out[1] = sfi_add(p, sfi_times(3.0, t0));
}

/* R by its definition, and by its tangent along A, which meets A = 0 at k = h - A h_A.
   Equation (24). Domain: Omega > 0, A > 0. */
static inline void slow_flow_intervals_state_R(sf_interval Omega, sf_interval A, sf_interval h, sf_interval h_A, sf_interval k, sf_interval *out)
{
    const sf_interval t0 = sfi_square(Omega);
    out[0] = sfi_add(sfi_mul(A, t0), h);
    out[1] = sfi_add(sfi_mul(A, sfi_add(h_A, t0)), k);
}

/* F and its first two derivatives along A, by R (`state_R`).
   Equation (24), (30), (33). Domain: Omega > 0, A > 0. */
static inline void slow_flow_intervals_state(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval m, sf_interval zeta, sf_interval h_A, sf_interval h_AA, sf_interval R, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, sfi_mul(Omega, zeta));
    const sf_interval I_ = sfi_add(sfi_mul(A, t0), m);
    const sf_interval t1 = sfi_square(Omega);
    const sf_interval t2 = sfi_add(h_A, t1);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_times(2.0, sfi_add(sfi_mul(I_, t0), sfi_mul(R, t2)));
    out[2] = sfi_times(2.0, sfi_add(sfi_add(sfi_mul(R, h_AA), sfi_times(4.0, sfi_mul(t1, sfi_square(zeta)))),
        sfi_square(t2)));
}

/* F_A/(2 A) without friction as X^2 + b X + c in X = Omega^2, by h/A and h/A - h_A: b, and b^2 - 4 c.
   Equation from (30). Domain: A > 0. */
static inline void slow_flow_intervals_fold_least(sf_interval zeta, sf_interval h_A, sf_interval over_A, sf_interval apart, sf_interval *out)
{
    const sf_interval t0 = sfi_square(zeta);
    const sf_interval t1 = sfi_add(h_A, over_A);
    out[0] = sfi_add(sfi_times(4.0, t0), t1);
    out[1] = sfi_add(sfi_square(apart), sfi_times(8.0, sfi_mul(t0, sfi_add(sfi_times(2.0, t0), t1))));
}

SF_FAMILY_END

#endif
