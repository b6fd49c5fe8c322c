/* Structural and quadratic damping, and dry friction of what is attached: on whole intervals.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/paper/averaging.py, derivations/paper/slow_flow.py, derivations/extensions/dissipation.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef DISSIPATION_INTERVALS_H
#define DISSIPATION_INTERVALS_H

#include "interval.h"
#include "inline.h"

SF_FAMILY_BEGIN

/* I_0, I at Omega = 0, and three derivatives by A: friction acts throughout.
   Equation from (19). Domain: A > 0. */
static inline void dissipation_intervals_at_rest(sf_interval A, sf_interval m, sf_interval eta, sf_interval *out)
{
    out[0] = sfi_add(sfi_mul(A, eta), m);
    out[1] = eta;
    out[2] = sfi_point(0.0);
    out[3] = sfi_point(0.0);
}

/* The same where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. */
static inline void dissipation_intervals_released(sf_interval A, sf_interval m, sf_interval eta, sf_interval u_cr, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(m, u_cr);
    const sf_interval A2 = sfi_square(A);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval A4 = sfi_square(A2);
    out[0] = sfi_add(sfi_mul(A, eta), sfi_div(t0, A));
    out[1] = sfi_sub(eta, sfi_div(t0, A2));
    out[2] = sfi_div(sfi_times(2.0, t0), A3);
    out[3] = sfi_neg(sfi_div(sfi_times(6.0, t0), A4));
}

/* Sine balance, -F_0 sin phi at a fixed point.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline sf_interval dissipation_intervals_I(sf_interval Omega, sf_interval A, sf_interval I_0, sf_interval zeta, sf_interval d)
{
    return sfi_add(sfi_add(sfi_mul(sfi_mul(sfi_square(A), sfi_square(Omega)), d), sfi_times(2.0,
        sfi_mul(sfi_mul(A, Omega), zeta))), I_0);
}

/* dI/dA.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline sf_interval dissipation_intervals_I_A(sf_interval Omega, sf_interval A, sf_interval I_0A, sf_interval zeta, sf_interval d)
{
    return sfi_add(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, sfi_square(Omega)), d)), I_0A), sfi_times(2.0,
        sfi_mul(Omega, zeta)));
}

/* R, R_A, I and I_A over Omega^2, at x = 1/Omega.
   Equation (23). Domain: x >= 0, A > 0. */
static inline void dissipation_intervals_far(sf_interval x, sf_interval A, sf_interval I_0, sf_interval I_0A, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval *out)
{
    const sf_interval t0 = sfi_square(x);
    const sf_interval t1 = sfi_times(2.0, A);
    const sf_interval t2 = sfi_mul(x, zeta);
    out[0] = sfi_add(A, sfi_mul(h, t0));
    out[1] = sfi_add(sfi_mul(h_A, t0), sfi_point(1.0));
    out[2] = sfi_add(sfi_add(sfi_mul(sfi_square(A), d), sfi_mul(I_0, t0)), sfi_mul(t1, t2));
    out[3] = sfi_add(sfi_add(sfi_mul(I_0A, t0), sfi_mul(d, t1)), sfi_times(2.0, t2));
}

/* F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each.
   Equation from (24). Domain: F_0 > I_0. */
static inline void dissipation_intervals_static(sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval h, sf_interval h_A, sf_interval *out)
{
    const sf_interval c = sfi_sqrt(sfi_mul(sfi_sub(F_0, I_0), sfi_add(F_0, I_0)));
    const sf_interval t0 = sfi_div(sfi_mul(I_0, I_0A), c);
    out[0] = sfi_add(sfi_neg(c), h);
    out[1] = sfi_add(c, h);
    out[2] = sfi_add(h_A, t0);
    out[3] = sfi_sub(h_A, t0);
}

/* D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D.
   Equation from (30). Domain: x >= 0, A > 0. */
static inline sf_interval dissipation_intervals_turn_share(sf_interval x, sf_interval A, sf_interval I_0, sf_interval I_0A, sf_interval zeta, sf_interval d)
{
    const sf_interval A2 = sfi_square(A);
    const sf_interval t0 = sfi_mul(A2, d);
    const sf_interval x2 = sfi_square(x);
    const sf_interval x3 = sfi_mul(x, x2);
    const sf_interval A3 = sfi_mul(A, A2);
    return sfi_add(sfi_add(sfi_add(sfi_times(4.0, sfi_mul(A3, sfi_square(d))), sfi_times(9.0,
        sfi_mul(sfi_mul(t0, x), zeta))), sfi_mul(x2, sfi_add(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, I_0), d)),
        sfi_times(4.0, sfi_mul(A, sfi_square(zeta)))), sfi_mul(I_0A, t0)))), sfi_mul(x3, sfi_add(sfi_mul(sfi_mul(A,
        I_0A), zeta), sfi_mul(I_0, zeta))));
}

/* The size of R where F = 0.
   Equation (24). Domain: Omega >= 0, A > 0. */
static inline sf_interval dissipation_intervals_R_of_response(sf_interval F_0, sf_interval I_)
{
    return sfi_sqrt(sfi_sub(sfi_square(F_0), sfi_square(I_)));
}

/* R where F_Omega = 0.
   Equation from (24). Domain: Omega >= 0, A > 0. */
static inline sf_interval dissipation_intervals_R_of_peak(sf_interval Omega, sf_interval A, sf_interval zeta, sf_interval d, sf_interval I_)
{
    return sfi_mul(I_, sfi_sub(sfi_neg(sfi_mul(A, d)), sfi_div(zeta, Omega)));
}

/* Where a level by inertia is stationary, x = 1/Omega: what is not negative, lower and higher R/Omega^2.
   Equation from (24). Domain: Omega >= 0, A > 0. */
static inline void dissipation_intervals_R_where_stationary(sf_interval x, sf_interval A, sf_interval I_0, sf_interval zeta, sf_interval d, sf_interval *out)
{
    const sf_interval t0 = sfi_square(A);
    const sf_interval t1 = sfi_mul(A, zeta);
    const sf_interval t2 = sfi_mul(sfi_mul(x, sfi_add(sfi_mul(I_0, x), t1)), sfi_add(sfi_add(sfi_mul(I_0, sfi_square(x)),
        sfi_mul(d, t0)), sfi_times(2.0, sfi_mul(t1, x))));
    const sf_interval t3 = sfi_sub(t0, sfi_times(4.0, t2));
    const sf_interval t4 = sfi_add(sfi_times(0.5, A), sfi_times(0.5, sfi_sqrt(t3)));
    out[0] = t3;
    out[1] = sfi_div(t2, t4);
    out[2] = t4;
}

/* I/A, by I_0/A.
   Equation (23). Domain: Omega >= 0, A > 0. */
static inline sf_interval dissipation_intervals_I_scaled(sf_interval Omega, sf_interval A, sf_interval I_0_over_A, sf_interval zeta, sf_interval d)
{
    return sfi_add(sfi_add(sfi_mul(sfi_mul(A, sfi_square(Omega)), d), I_0_over_A), sfi_times(2.0, sfi_mul(Omega,
        zeta)));
}

/* F_A/(2 A), by h/A and I/A.
   Equation (30). Domain: Omega >= 0, A > 0. */
static inline sf_interval dissipation_intervals_F_A_scaled(sf_interval Omega, sf_interval h_over_A, sf_interval h_A, sf_interval I_over_A, sf_interval I_A)
{
    const sf_interval t0 = sfi_square(Omega);
    return sfi_add(sfi_mul(I_A, I_over_A), sfi_mul(sfi_add(h_A, t0), sfi_add(h_over_A, t0)));
}

/* F/Omega^4 at x = 1/Omega; and -Omega^3/4 dlevel^2/dOmega, less Omega times the third.
   Equation (24). Domain: x >= 0, A > 0. */
static inline void dissipation_intervals_far_by_inertia(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval zeta, sf_interval d, sf_interval h, sf_interval *out)
{
    const sf_interval t0 = sfi_square(x);
    const sf_interval A2 = sfi_square(A);
    const sf_interval t1 = sfi_mul(A2, d);
    const sf_interval t2 = sfi_mul(sfi_mul(A, x), zeta);
    const sf_interval t3 = sfi_add(A, sfi_mul(h, t0));
    const sf_interval t4 = sfi_add(sfi_add(sfi_mul(I_0, t0), t1), sfi_times(2.0, t2));
    const sf_interval A3 = sfi_mul(A, A2);
    out[0] = sfi_add(sfi_add(sfi_neg(sfi_square(F_0)), sfi_square(t3)), sfi_square(t4));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A, h), sfi_times(2.0, sfi_mul(A2, sfi_square(zeta)))),
        sfi_mul(I_0, t1)), sfi_times(3.0, sfi_mul(I_0, t2))), sfi_mul(t0, sfi_add(sfi_square(I_0), sfi_square(h))));
    out[2] = sfi_mul(sfi_mul(A3, d), zeta);
}

/* F and F_A/2; derivatives by A and by R of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_folds_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(Omega);
    const sf_interval t1 = sfi_mul(sfi_mul(A, Omega), d);
    const sf_interval t2 = sfi_mul(t0, sfi_add(t1, zeta));
    const sf_interval t3 = sfi_sub(I_A, sfi_mul(R_A, t2));
    const sf_interval t4 = sfi_inverse(A);
    const sf_interval t5 = sfi_mul(R_A, t4);
    const sf_interval t6 = sfi_mul(t0, sfi_add(sfi_times(2.0, t1), zeta));
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[2] = sfi_times(2.0, sfi_mul(I_, t3));
    out[3] = sfi_times(2.0, sfi_add(sfi_mul(I_, t2), R));
    out[4] = sfi_add(sfi_add(sfi_mul(I_, sfi_sub(sfi_add(I_0AA, sfi_times(2.0, sfi_mul(sfi_square(Omega), d))),
        sfi_mul(t5, t6))), sfi_mul(I_A, t3)), sfi_mul(R, sfi_sub(h_AA, t5)));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(I_, t4), t6), sfi_mul(I_A, t2)), sfi_mul(R, t4)), R_A);
}

/* F and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_peaks_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, d);
    const sf_interval t1 = sfi_inverse(Omega);
    const sf_interval t2 = sfi_add(t0, sfi_mul(t1, zeta));
    const sf_interval t3 = sfi_mul(t1, sfi_add(sfi_mul(Omega, t0), zeta));
    const sf_interval t4 = sfi_sub(I_A, sfi_mul(R_A, t3));
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    const sf_interval t5 = sfi_div(sfi_times(0.5, sfi_mul(I_, zeta)), sfi_mul(A, Omega3));
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_mul(I_, t2), R);
    out[2] = sfi_times(2.0, sfi_mul(I_, t4));
    out[3] = sfi_times(2.0, sfi_add(sfi_mul(I_, t3), R));
    out[4] = sfi_add(sfi_add(sfi_mul(I_, d), sfi_mul(R_A, t5)), sfi_mul(t2, t4));
    out[5] = sfi_add(sfi_sub(sfi_mul(t2, t3), t5), sfi_point(1.0));
}

/* F_A/2 and F_AA/2; derivatives by A and by R of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_cusps_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, d);
    const sf_interval t1 = sfi_mul(sfi_square(Omega), t0);
    const sf_interval t2 = sfi_inverse(A);
    const sf_interval t3 = sfi_mul(R_A, t2);
    const sf_interval t4 = sfi_sub(h_AA, t3);
    const sf_interval t5 = sfi_inverse(Omega);
    const sf_interval t6 = sfi_mul(A, Omega);
    const sf_interval t7 = sfi_mul(t5, sfi_add(sfi_mul(d, t6), zeta));
    const sf_interval t8 = sfi_sub(I_A, sfi_mul(R_A, t7));
    const sf_interval t9 = sfi_mul(t5, sfi_add(sfi_mul(t0, t6), zeta));
    const sf_interval t10 = sfi_add(I_0AA, t1);
    const sf_interval t11 = sfi_sub(t10, sfi_mul(t3, t9));
    const sf_interval t12 = sfi_mul(I_, t2);
    const sf_interval t13 = sfi_times(2.0, I_A);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AA), sfi_mul(I_, t1)), sfi_square(I_A)), sfi_mul(R,
        h_AA)), sfi_square(R_A));
    out[2] = sfi_add(sfi_add(sfi_mul(I_, t11), sfi_mul(I_A, t8)), sfi_mul(R, t4));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(I_A, t7), sfi_mul(R, t2)), R_A), sfi_mul(t12, t9));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_sub(sfi_mul(I_, I_0AAA), sfi_mul(sfi_mul(I_, t0), t3)),
        sfi_mul(R, h_AAA)), sfi_times(2.0, sfi_mul(R_A, t4))), sfi_mul(t10, t8)), sfi_mul(t11, t13));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_add(h_AA, sfi_mul(t0, t12)), sfi_mul(t10, t7)), sfi_mul(sfi_mul(t13, t2),
        t9)), sfi_times(2.0, t3));
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_isolas_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, d);
    const sf_interval t1 = sfi_inverse(Omega);
    const sf_interval t2 = sfi_add(t0, sfi_mul(t1, zeta));
    const sf_interval t3 = sfi_inverse(A);
    const sf_interval t4 = sfi_mul(R_A, t3);
    const sf_interval t5 = sfi_mul(Omega, t0);
    const sf_interval t6 = sfi_mul(t1, sfi_add(t5, zeta));
    const sf_interval t7 = sfi_sub(I_A, sfi_mul(R_A, t6));
    const sf_interval t8 = sfi_mul(t1, sfi_add(sfi_times(2.0, t5), zeta));
    const sf_interval t9 = sfi_mul(I_, t3);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    const sf_interval t10 = sfi_div(sfi_times(0.5, zeta), Omega3);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_mul(I_, t2), R);
    out[2] = sfi_add(sfi_add(sfi_mul(I_, sfi_sub(sfi_add(I_0AA, sfi_times(2.0, sfi_mul(Omega2, d))), sfi_mul(t4,
        t8))), sfi_mul(I_A, t7)), sfi_mul(R, sfi_sub(h_AA, t4)));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(I_A, t6), sfi_mul(R, t3)), R_A), sfi_mul(t8, t9));
    out[4] = sfi_add(sfi_add(sfi_mul(I_, d), sfi_mul(sfi_mul(I_, t10), t4)), sfi_mul(t2, t7));
    out[5] = sfi_add(sfi_add(sfi_neg(sfi_mul(t10, t9)), sfi_mul(t2, t6)), sfi_point(1.0));
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_turns_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(R, R_A);
    const sf_interval t1 = sfi_mul(A, R_A);
    const sf_interval t2 = sfi_times(2.0, d);
    const sf_interval t3 = sfi_mul(I_, t2);
    const sf_interval t4 = sfi_square(A);
    const sf_interval t5 = sfi_mul(I_A, d);
    const sf_interval t6 = sfi_div(zeta, Omega);
    const sf_interval t7 = sfi_mul(I_, t6);
    const sf_interval t8 = sfi_mul(I_A, t6);
    const sf_interval t9 = sfi_inverse(A);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t10 = sfi_mul(t7, t9);
    const sf_interval t11 = sfi_mul(A, t5);
    const sf_interval t12 = sfi_mul(A, t6);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    const sf_interval t13 = sfi_div(sfi_times(0.5, zeta), Omega3);
    const sf_interval t14 = sfi_mul(I_A, t13);
    const sf_interval t15 = sfi_mul(sfi_square(d), t4);
    const sf_interval t16 = sfi_times(4.0, t15);
    const sf_interval t17 = sfi_div(sfi_times(2.0, sfi_square(zeta)), Omega2);
    const sf_interval t18 = sfi_times(6.0, d);
    const sf_interval t19 = sfi_mul(sfi_mul(I_, t13), t9);
    out[0] = sfi_add(sfi_mul(I_, I_A), t0);
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A, t3), sfi_mul(A, t8)), R), t1), sfi_mul(t4, t5)),
        t7);
    out[2] = sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AA), sfi_times(2.0,
        sfi_mul(sfi_mul(I_, Omega2), d))), sfi_square(I_A)), sfi_mul(R, h_AA)), sfi_mul(R_A, t10)), sfi_mul(R_A,
        t3)), sfi_mul(R_A, t8)), sfi_mul(t0, t9)), sfi_mul(t1, t5));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(R, t9), R_A), t10), t11), t3), t8);
    out[4] = sfi_add(sfi_add(sfi_add(sfi_sub(sfi_add(sfi_sub(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(sfi_mul(A,
        Omega), t2), zeta), sfi_mul(A, h_AA)), sfi_mul(sfi_mul(I_0AA, d), t4)), sfi_mul(I_0AA, t12)), sfi_times(2.0,
        sfi_mul(Omega2, t15))), sfi_mul(R_A, t14)), sfi_mul(R_A, t16)), sfi_mul(R_A, t17)), sfi_mul(R_A, t19)),
        sfi_mul(sfi_mul(t1, t18), t6)), sfi_times(4.0, t11)), t3), sfi_times(2.0, t8));
    out[5] = sfi_add(sfi_sub(sfi_add(sfi_add(sfi_sub(sfi_mul(t12, t18), t14), t16), t17), t19), sfi_point(2.0));
}

/* F and F_A/2; derivatives by A and by Omega of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_folds_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    const sf_interval t1 = sfi_mul(Omega, R);
    const sf_interval t2 = sfi_mul(A, Omega);
    const sf_interval t3 = sfi_mul(d, t2);
    const sf_interval t4 = sfi_add(t3, zeta);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = t0;
    out[2] = sfi_times(2.0, t0);
    out[3] = sfi_times(4.0, sfi_mul(A, sfi_add(sfi_mul(I_, t4), t1)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(I_0AA, sfi_times(2.0, sfi_mul(sfi_square(Omega), d)))),
        sfi_square(I_A)), sfi_mul(R, h_AA)), sfi_square(R_A));
    out[5] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, I_A), t4), sfi_mul(I_,
        sfi_add(sfi_times(2.0, t3), zeta))), sfi_mul(R_A, t2)), t1));
}

/* F and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_peaks_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_div(zeta, Omega);
    const sf_interval t1 = sfi_times(3.0, zeta);
    const sf_interval t2 = sfi_mul(A, d);
    const sf_interval t3 = sfi_mul(Omega, t2);
    const sf_interval t4 = sfi_add(sfi_add(sfi_mul(I_0, d), sfi_mul(t3, sfi_add(t1, t3))), sfi_times(2.0,
        sfi_square(zeta)));
    const sf_interval t5 = sfi_add(t1, sfi_times(2.0, t3));
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_add(sfi_mul(A, t4), sfi_mul(I_0, t0)), R);
    out[2] = sfi_times(2.0, sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A)));
    out[3] = sfi_times(4.0, sfi_mul(A, sfi_add(sfi_mul(I_, sfi_add(t3, zeta)), sfi_mul(Omega, R))));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_mul(I_0A, sfi_add(t0, t2)), R_A), sfi_mul(t3, t5)), t4);
    out[5] = sfi_sub(sfi_add(sfi_mul(sfi_mul(sfi_square(A), d), t5), sfi_times(2.0, sfi_mul(A, Omega))),
        sfi_div(sfi_mul(I_0, zeta), sfi_square(Omega)));
}

/* F_A/2 and F_AA/2; derivatives by A and by Omega of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_cusps_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, d);
    const sf_interval t1 = sfi_mul(sfi_square(Omega), t0);
    const sf_interval t2 = sfi_add(sfi_add(sfi_square(I_A), sfi_mul(R, h_AA)), sfi_square(R_A));
    const sf_interval t3 = sfi_add(I_0AA, t1);
    const sf_interval t4 = sfi_mul(A, Omega);
    const sf_interval t5 = sfi_add(sfi_mul(t0, t4), zeta);
    const sf_interval t6 = sfi_mul(A, sfi_add(sfi_mul(d, t4), zeta));
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_mul(I_, I_0AA), sfi_mul(I_, t1)), t2);
    out[2] = sfi_add(sfi_mul(I_, t3), t2);
    out[3] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(I_, t5), sfi_mul(I_A, t6)), sfi_mul(Omega, R)),
        sfi_mul(R_A, t4)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AAA), sfi_times(3.0, sfi_mul(I_A, t3))), sfi_mul(R, h_AAA)),
        sfi_times(3.0, sfi_mul(R_A, h_AA)));
    out[5] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(I_, Omega), t0), sfi_times(2.0,
        sfi_mul(I_A, t5))), sfi_times(2.0, sfi_mul(Omega, R_A))), sfi_mul(h_AA, t4)), sfi_mul(t3, t6)));
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_isolas_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_div(zeta, Omega);
    const sf_interval t1 = sfi_times(3.0, zeta);
    const sf_interval t2 = sfi_mul(A, d);
    const sf_interval t3 = sfi_mul(Omega, t2);
    const sf_interval t4 = sfi_add(sfi_add(sfi_mul(I_0, d), sfi_mul(t3, sfi_add(t1, t3))), sfi_times(2.0,
        sfi_square(zeta)));
    const sf_interval t5 = sfi_square(Omega);
    const sf_interval t6 = sfi_mul(A, Omega);
    const sf_interval t7 = sfi_times(2.0, t3);
    const sf_interval t8 = sfi_add(t1, t7);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_mul(A, t4), sfi_mul(I_0, t0)), R);
    out[2] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(I_0AA, sfi_times(2.0, sfi_mul(d, t5)))),
        sfi_square(I_A)), sfi_mul(R, h_AA)), sfi_square(R_A));
    out[3] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, I_A), sfi_add(t3, zeta)), sfi_mul(I_,
        sfi_add(t7, zeta))), sfi_mul(Omega, R)), sfi_mul(R_A, t6)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_mul(I_0A, sfi_add(t0, t2)), R_A), sfi_mul(t3, t8)), t4);
    out[5] = sfi_add(sfi_sub(sfi_mul(sfi_mul(sfi_square(A), d), t8), sfi_div(sfi_mul(I_0, zeta), t5)),
        sfi_times(2.0, t6));
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by Omega of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_turns_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, R_A);
    const sf_interval t1 = sfi_times(2.0, d);
    const sf_interval t2 = sfi_mul(I_, t1);
    const sf_interval t3 = sfi_mul(A, t2);
    const sf_interval A2 = sfi_square(A);
    const sf_interval t4 = sfi_mul(A2, d);
    const sf_interval t5 = sfi_mul(I_A, t4);
    const sf_interval t6 = sfi_inverse(Omega);
    const sf_interval t7 = sfi_mul(I_, zeta);
    const sf_interval t8 = sfi_mul(I_A, zeta);
    const sf_interval t9 = sfi_mul(A, t8);
    const sf_interval t10 = sfi_square(Omega);
    const sf_interval t11 = sfi_times(4.0, A);
    const sf_interval t12 = sfi_mul(A, zeta);
    const sf_interval t13 = sfi_square(d);
    const sf_interval t14 = sfi_inverse(t10);
    const sf_interval A3 = sfi_mul(A, A2);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(R, t0), t3), t5), sfi_mul(t6, t7)), sfi_mul(t6, t9));
    out[2] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AA), sfi_square(I_A)), sfi_mul(R, h_AA)),
        sfi_square(R_A)), sfi_mul(t10, t2));
    out[3] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(Omega, R), sfi_mul(Omega, t0)),
        sfi_mul(Omega, t3)), sfi_mul(Omega, t5)), t7), t9));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A, h_AA), sfi_times(2.0,
        sfi_mul(sfi_mul(A2, t10), t13))), sfi_mul(sfi_mul(I_0AA, t12), t6)), sfi_mul(I_0AA, t4)),
        sfi_mul(sfi_mul(I_A, d), t11)), sfi_mul(sfi_mul(Omega, t1), t12)), sfi_times(2.0, R_A)), t2), sfi_times(2.0,
        sfi_mul(t6, t8)));
    out[5] = sfi_add(sfi_sub(sfi_sub(sfi_add(sfi_add(sfi_times(8.0, sfi_mul(sfi_mul(A3, Omega), t13)),
        sfi_mul(Omega, t11)), sfi_mul(sfi_mul(t11, t6), sfi_square(zeta))), sfi_mul(t14, t7)), sfi_mul(t14, t9)),
        sfi_times(12.0, sfi_mul(t4, zeta)));
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_folds_far_by_R(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(h);
    const sf_interval t1 = sfi_div(t0, x);
    const sf_interval t2 = sfi_mul(t1, sfi_add(sfi_mul(A, zeta), sfi_mul(I_0, x)));
    const sf_interval t3 = sfi_sub(I_A, sfi_mul(R_A, t2));
    const sf_interval t4 = sfi_square(x);
    const sf_interval t5 = sfi_mul(h_A, t0);
    const sf_interval t6 = sfi_mul(t1, sfi_add(sfi_mul(I_0A, x), zeta));
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[2] = sfi_times(2.0, sfi_mul(I_, t3));
    out[3] = sfi_times(2.0, sfi_add(sfi_mul(I_, t2), R));
    out[4] = sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_sub(sfi_mul(I_0AA, t4), sfi_mul(R_A, t6)), sfi_times(2.0,
        d))), sfi_mul(I_A, t3)), sfi_mul(R, sfi_add(sfi_neg(sfi_mul(R_A, t5)), sfi_mul(h_AA, t4))));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, t6), sfi_mul(I_A, t2)), sfi_mul(R, t5)), R_A);
}

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_peaks_far_by_R(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(h);
    const sf_interval t1 = sfi_inverse(x);
    const sf_interval t2 = sfi_mul(A, zeta);
    const sf_interval t3 = sfi_mul(t1, t2);
    const sf_interval t4 = sfi_add(sfi_mul(I_0, x), t2);
    const sf_interval t5 = sfi_mul(t0, t4);
    const sf_interval t6 = sfi_sub(I_A, sfi_mul(sfi_mul(R_A, t1), t5));
    const sf_interval t7 = sfi_mul(I_, t1);
    const sf_interval t8 = sfi_mul(I_, t0);
    const sf_interval x2 = sfi_square(x);
    const sf_interval x3 = sfi_mul(x, x2);
    const sf_interval t9 = sfi_div(sfi_times(0.5, t2), x3);
    const sf_interval t10 = sfi_add(I_0, t3);
    const sf_interval t11 = sfi_inverse(sfi_square(h));
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_mul(I_, sfi_add(sfi_mul(I_0, t0), sfi_mul(t0, t3))), R);
    out[2] = sfi_times(2.0, sfi_mul(I_, t6));
    out[3] = sfi_times(2.0, sfi_add(R, sfi_mul(t5, t7)));
    out[4] = sfi_mul(t0, sfi_add(sfi_add(sfi_sub(sfi_add(sfi_mul(I_, I_0A), sfi_mul(sfi_mul(R_A, t8), t9)),
        sfi_mul(sfi_mul(h_A, t10), t8)), sfi_mul(t10, t6)), sfi_mul(t7, zeta)));
    out[5] = sfi_add(sfi_add(sfi_neg(sfi_mul(sfi_mul(I_, t11), t9)), sfi_mul(sfi_mul(sfi_mul(t1, t10), t11), t4)),
        sfi_point(1.0));
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_cusps_far_by_R(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, d);
    const sf_interval t1 = sfi_square(x);
    const sf_interval t2 = sfi_mul(I_0AA, t1);
    const sf_interval t3 = sfi_mul(h_AA, t1);
    const sf_interval t4 = sfi_inverse(h);
    const sf_interval t5 = sfi_mul(h_A, t4);
    const sf_interval t6 = sfi_mul(R_A, t5);
    const sf_interval t7 = sfi_sub(sfi_mul(h_AA, t1), t6);
    const sf_interval t8 = sfi_add(sfi_mul(A, zeta), sfi_mul(I_0, x));
    const sf_interval t9 = sfi_div(t4, x);
    const sf_interval t10 = sfi_mul(R_A, t9);
    const sf_interval t11 = sfi_sub(I_A, sfi_mul(t10, t8));
    const sf_interval t12 = sfi_add(sfi_mul(I_0A, x), zeta);
    const sf_interval t13 = sfi_add(t0, t2);
    const sf_interval t14 = sfi_add(sfi_neg(sfi_mul(t10, t12)), t13);
    const sf_interval t15 = sfi_mul(t12, t9);
    const sf_interval t16 = sfi_mul(t8, t9);
    const sf_interval t17 = sfi_mul(t4, sfi_add(sfi_mul(I_, I_0AA), sfi_mul(R, h_AA)));
    const sf_interval t18 = sfi_times(2.0, I_A);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, t0), sfi_mul(I_, t2)), sfi_square(I_A)), sfi_mul(R, t3)),
        sfi_square(R_A));
    out[2] = sfi_add(sfi_add(sfi_mul(I_, t14), sfi_mul(I_A, t11)), sfi_mul(R, t7));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, t15), sfi_mul(I_A, t16)), sfi_mul(R, t5)), R_A);
    out[4] = sfi_add(sfi_add(sfi_add(sfi_sub(sfi_add(sfi_mul(sfi_mul(I_, I_0AAA), t1), sfi_mul(sfi_mul(R, h_AAA),
        t1)), sfi_mul(R_A, t17)), sfi_times(2.0, sfi_mul(R_A, t7))), sfi_mul(t11, t13)), sfi_mul(t14, t18));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(t13, t16), sfi_mul(t15, t18)), t17), t3), sfi_times(2.0, t6));
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_isolas_far_by_R(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(h);
    const sf_interval t1 = sfi_inverse(x);
    const sf_interval t2 = sfi_mul(A, zeta);
    const sf_interval t3 = sfi_mul(t1, t2);
    const sf_interval x2 = sfi_square(x);
    const sf_interval t4 = sfi_mul(h_A, t0);
    const sf_interval t5 = sfi_mul(R_A, t1);
    const sf_interval t6 = sfi_add(sfi_mul(I_0, x), t2);
    const sf_interval t7 = sfi_mul(t0, t6);
    const sf_interval t8 = sfi_sub(I_A, sfi_mul(t5, t7));
    const sf_interval t9 = sfi_mul(t0, sfi_add(sfi_mul(I_0A, x), zeta));
    const sf_interval t10 = sfi_mul(I_, t1);
    const sf_interval x3 = sfi_mul(x, x2);
    const sf_interval t11 = sfi_div(sfi_times(0.5, sfi_mul(I_, t2)), x3);
    const sf_interval t12 = sfi_add(I_0, t3);
    const sf_interval t13 = sfi_inverse(sfi_square(h));
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_mul(I_, sfi_add(sfi_mul(I_0, t0), sfi_mul(t0, t3))), R);
    out[2] = sfi_add(sfi_add(sfi_mul(I_, sfi_sub(sfi_add(sfi_mul(I_0AA, x2), sfi_times(2.0, d)), sfi_mul(t5,
        t9))), sfi_mul(I_A, t8)), sfi_mul(R, sfi_add(sfi_neg(sfi_mul(R_A, t4)), sfi_mul(h_AA, x2))));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(I_A, t1), t7), sfi_mul(R, t4)), R_A), sfi_mul(t10, t9));
    out[4] = sfi_mul(t0, sfi_add(sfi_add(sfi_add(sfi_sub(sfi_mul(I_, I_0A), sfi_mul(sfi_mul(I_, t12), t4)),
        sfi_mul(sfi_mul(R_A, t0), t11)), sfi_mul(t10, zeta)), sfi_mul(t12, t8)));
    out[5] = sfi_add(sfi_sub(sfi_mul(sfi_mul(sfi_mul(t1, t12), t13), t6), sfi_mul(t11, t13)), sfi_point(1.0));
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_folds_far_by_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    const sf_interval t1 = sfi_mul(R, x);
    const sf_interval t2 = sfi_add(sfi_mul(A, zeta), sfi_mul(I_0, x));
    const sf_interval t3 = sfi_square(x);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = t0;
    out[2] = sfi_times(2.0, t0);
    out[3] = sfi_times(4.0, sfi_add(sfi_mul(I_, t2), sfi_mul(h, t1)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_mul(I_0AA, t3), sfi_times(2.0, d))),
        sfi_square(I_A)), sfi_mul(sfi_mul(R, h_AA), t3)), sfi_square(R_A));
    out[5] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_mul(I_0A, x), zeta)), sfi_mul(I_A,
        t2)), sfi_mul(sfi_mul(R_A, h), x)), sfi_mul(h_A, t1)));
}

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_peaks_far_by_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(R, h);
    const sf_interval t1 = sfi_mul(A, zeta);
    const sf_interval t2 = sfi_mul(I_0, x);
    const sf_interval t3 = sfi_times(2.0, t1);
    const sf_interval t4 = sfi_square(A);
    const sf_interval t5 = sfi_div(d, x);
    const sf_interval t6 = sfi_add(sfi_add(t2, t3), sfi_mul(t4, t5));
    const sf_interval t7 = sfi_add(t1, t2);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_add(sfi_mul(I_, I_0), t0), sfi_mul(t1, t6));
    out[2] = sfi_times(2.0, sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A)));
    out[3] = sfi_times(4.0, sfi_add(sfi_mul(I_, t7), sfi_mul(t0, x)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_0, I_A), sfi_mul(I_0A, sfi_add(I_, sfi_mul(t1,
        x)))), sfi_mul(R, h_A)), sfi_mul(R_A, h)), sfi_mul(t3, sfi_add(sfi_mul(A, t5), zeta))), sfi_mul(t6, zeta));
    out[5] = sfi_add(sfi_add(sfi_times(2.0, sfi_mul(I_0, t7)), sfi_times(2.0, sfi_mul(sfi_square(h), x))),
        sfi_mul(t1, sfi_sub(I_0, sfi_div(sfi_mul(d, t4), sfi_square(x)))));
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (30), (33). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_cusps_far_by_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, d);
    const sf_interval x2 = sfi_square(x);
    const sf_interval t1 = sfi_mul(I_0AA, x2);
    const sf_interval t2 = sfi_mul(R, x2);
    const sf_interval t3 = sfi_add(sfi_add(sfi_square(I_A), sfi_square(R_A)), sfi_mul(h_AA, t2));
    const sf_interval t4 = sfi_add(t0, t1);
    const sf_interval t5 = sfi_mul(R, x);
    const sf_interval t6 = sfi_mul(R_A, x);
    const sf_interval t7 = sfi_add(sfi_mul(I_0A, x), zeta);
    const sf_interval t8 = sfi_add(sfi_mul(A, zeta), sfi_mul(I_0, x));
    const sf_interval x3 = sfi_mul(x, x2);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_mul(I_, t0), sfi_mul(I_, t1)), t3);
    out[2] = sfi_add(sfi_mul(I_, t4), t3);
    out[3] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(I_, t7), sfi_mul(I_A, t8)), sfi_mul(h, t6)),
        sfi_mul(h_A, t5)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(I_, I_0AAA), x2), sfi_times(3.0, sfi_mul(I_A, t4))),
        sfi_times(3.0, sfi_mul(sfi_mul(R_A, h_AA), x2))), sfi_mul(h_AAA, t2));
    out[5] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(I_, I_0AA), x), sfi_times(2.0,
        sfi_mul(I_A, t7))), sfi_mul(sfi_mul(h, h_AA), x3)), sfi_times(2.0, sfi_mul(h_A, t6))), sfi_mul(h_AA, t5)),
        sfi_mul(t4, t8)));
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second.
   Equation from (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_isolas_far_by_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, zeta);
    const sf_interval t1 = sfi_mul(I_0, x);
    const sf_interval t2 = sfi_times(2.0, t0);
    const sf_interval t3 = sfi_square(A);
    const sf_interval t4 = sfi_div(d, x);
    const sf_interval t5 = sfi_add(sfi_add(t1, t2), sfi_mul(t3, t4));
    const sf_interval t6 = sfi_square(x);
    const sf_interval t7 = sfi_mul(R, h_A);
    const sf_interval t8 = sfi_mul(R_A, h);
    const sf_interval t9 = sfi_add(t0, t1);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_mul(I_, I_0), sfi_mul(R, h)), sfi_mul(t0, t5));
    out[2] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_mul(I_0AA, t6), sfi_times(2.0, d))),
        sfi_square(I_A)), sfi_mul(sfi_mul(R, h_AA), t6)), sfi_square(R_A));
    out[3] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_mul(I_0A, x), zeta)), sfi_mul(I_A,
        t9)), sfi_mul(t7, x)), sfi_mul(t8, x)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_0, I_A), sfi_mul(I_0A, sfi_add(I_, sfi_mul(t0,
        x)))), sfi_mul(t2, sfi_add(sfi_mul(A, t4), zeta))), sfi_mul(t5, zeta)), t7), t8);
    out[5] = sfi_add(sfi_add(sfi_times(2.0, sfi_mul(I_0, t9)), sfi_times(2.0, sfi_mul(sfi_square(h), x))),
        sfi_mul(t0, sfi_sub(I_0, sfi_div(sfi_mul(d, t3), t6))));
}

/* I_0 - A I_0A: friction acts throughout.
   Equation from (19). Domain: A > 0. */
static inline sf_interval dissipation_intervals_rest_intercept(sf_interval m)
{
    return m;
}

/* The same where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. */
static inline sf_interval dissipation_intervals_released_intercept(sf_interval A, sf_interval m, sf_interval u_cr)
{
    return sfi_div(sfi_times(2.0, sfi_mul(m, u_cr)), A);
}

/* I - A I_A, by that of I_0.
   Equation from (23). Domain: Omega >= 0, A > 0. */
static inline sf_interval dissipation_intervals_sine_intercept(sf_interval Omega, sf_interval A, sf_interval level, sf_interval d)
{
    return sfi_add(sfi_neg(sfi_mul(sfi_mul(sfi_square(A), sfi_square(Omega)), d)), level);
}

/* The same over Omega^2, at x = 1/Omega.
   Equation from (23). Domain: x >= 0, A > 0. */
static inline sf_interval dissipation_intervals_sine_intercept_far(sf_interval x, sf_interval A, sf_interval level, sf_interval d)
{
    return sfi_add(sfi_neg(sfi_mul(sfi_square(A), d)), sfi_mul(level, sfi_square(x)));
}

/* R where F_Omega = 0, by I at Omega = 0.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline sf_interval dissipation_intervals_R_of_peak_by_rest(sf_interval Omega, sf_interval A, sf_interval I_0, sf_interval zeta, sf_interval d)
{
    const sf_interval t0 = sfi_mul(sfi_mul(A, Omega), d);
    return sfi_sub(sfi_neg(sfi_mul(A, sfi_add(sfi_add(sfi_mul(I_0, d), sfi_mul(t0, sfi_add(t0, sfi_times(3.0,
        zeta)))), sfi_times(2.0, sfi_square(zeta))))), sfi_div(sfi_mul(I_0, zeta), Omega));
}

/* A Omega by I.
   Equation from (23). Domain: I >= I_0. */
static inline sf_interval dissipation_intervals_velocity(sf_interval I_, sf_interval I_0, sf_interval zeta, sf_interval d)
{
    const sf_interval t0 = sfi_sub(I_, I_0);
    return sfi_div(t0, sfi_add(zeta, sfi_sqrt(sfi_add(sfi_mul(d, t0), sfi_square(zeta)))));
}

SF_FAMILY_END

#endif
