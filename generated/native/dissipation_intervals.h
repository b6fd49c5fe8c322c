/* Structural and quadratic damping, and dry friction of what is attached: on whole intervals.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/extensions/dissipation.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of dissipation.h. */

#ifndef DISSIPATION_INTERVALS_H
#define DISSIPATION_INTERVALS_H

#include "interval.h"
#include "inline.h"

SF_FAMILY_BEGIN

/* I_0, I at Omega = 0, and three derivatives by A: friction acts throughout. */
static inline void dissipation_intervals_at_rest(sf_interval A, sf_interval m, sf_interval eta, sf_interval *out)
{
    out[0] = sfi_add(sfi_mul(A, eta), m);
    out[1] = eta;
    out[2] = sfi_point(0.0);
    out[3] = sfi_point(0.0);
}

/* The same where friction acts for |u| < u_cr only. */
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

/* The viscous damping ratio of a cycle, and three derivatives by A. */
static inline void dissipation_intervals_viscous(sf_interval A, sf_interval zeta, sf_interval zeta_2, sf_interval *out)
{
    const sf_interval t0 = sfi_times(0.5, zeta_2);
    out[0] = sfi_add(sfi_times(0.25, sfi_mul(sfi_square(A), zeta_2)), zeta);
    out[1] = sfi_mul(A, t0);
    out[2] = t0;
    out[3] = sfi_point(0.0);
}

/* Sine balance, -F_0 sin phi at a fixed point. */
static inline sf_interval dissipation_intervals_I(sf_interval Omega, sf_interval A, sf_interval I_0, sf_interval zeta, sf_interval d, sf_interval d_3)
{
    const sf_interval A2 = sfi_square(A);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    return sfi_add(sfi_add(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, Omega), zeta)), sfi_mul(sfi_mul(A2,
        Omega2), d)), sfi_mul(sfi_mul(A3, Omega3), d_3)), I_0);
}

/* dI/dA. */
static inline sf_interval dissipation_intervals_I_A(sf_interval Omega, sf_interval A, sf_interval I_0A, sf_interval zeta, sf_interval zeta_A, sf_interval d, sf_interval d_3)
{
    const sf_interval t0 = sfi_times(2.0, Omega);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    return sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(3.0, sfi_mul(sfi_mul(sfi_square(A), Omega3), d_3)),
        sfi_times(2.0, sfi_mul(sfi_mul(A, Omega2), d))), sfi_mul(sfi_mul(A, t0), zeta_A)), I_0A), sfi_mul(t0, zeta));
}

/* R, R_A, I and I_A over Omega^2, at x = 1/Omega. */
static inline void dissipation_intervals_far(sf_interval x, sf_interval A, sf_interval I_0, sf_interval I_0A, sf_interval zeta, sf_interval zeta_A, sf_interval d, sf_interval h, sf_interval h_A, sf_interval *out)
{
    const sf_interval t0 = sfi_square(x);
    const sf_interval t1 = sfi_times(2.0, A);
    const sf_interval t2 = sfi_mul(x, zeta);
    out[0] = sfi_add(A, sfi_mul(h, t0));
    out[1] = sfi_add(sfi_mul(h_A, t0), sfi_point(1.0));
    out[2] = sfi_add(sfi_add(sfi_mul(sfi_square(A), d), sfi_mul(I_0, t0)), sfi_mul(t1, t2));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(I_0A, t0), sfi_mul(d, t1)), sfi_mul(sfi_mul(t1, x), zeta_A)),
        sfi_times(2.0, t2));
}

/* F at Omega = 0 by its halves h - c and h + c, c^2 = F_0^2 - I_0^2; and the slope of each. */
static inline void dissipation_intervals_static(sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval h, sf_interval h_A, sf_interval *out)
{
    const sf_interval c = sfi_sqrt(sfi_mul(sfi_sub(F_0, I_0), sfi_add(F_0, I_0)));
    const sf_interval t0 = sfi_div(sfi_mul(I_0, I_0A), c);
    out[0] = sfi_add(sfi_neg(c), h);
    out[1] = sfi_add(c, h);
    out[2] = sfi_add(h_A, t0);
    out[3] = sfi_sub(h_A, t0);
}

/* D/Omega^2 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D without cubic damping. */
static inline sf_interval dissipation_intervals_turn_share(sf_interval x, sf_interval A, sf_interval I_0, sf_interval I_0A, sf_interval zeta, sf_interval zeta_A, sf_interval d)
{
    const sf_interval A2 = sfi_square(A);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval t0 = sfi_mul(A, I_0);
    const sf_interval t1 = sfi_mul(A2, d);
    const sf_interval x2 = sfi_square(x);
    const sf_interval x3 = sfi_mul(x, x2);
    return sfi_add(sfi_add(sfi_add(sfi_times(4.0, sfi_mul(A3, sfi_square(d))), sfi_mul(x, sfi_add(sfi_times(3.0,
        sfi_mul(sfi_mul(A3, d), zeta_A)), sfi_times(9.0, sfi_mul(t1, zeta))))), sfi_mul(x2,
        sfi_add(sfi_add(sfi_add(sfi_times(4.0, sfi_mul(A, sfi_square(zeta))), sfi_times(4.0, sfi_mul(sfi_mul(A2,
        zeta), zeta_A))), sfi_mul(I_0A, t1)), sfi_times(2.0, sfi_mul(d, t0))))), sfi_mul(x3,
        sfi_add(sfi_add(sfi_mul(sfi_mul(A, I_0A), zeta), sfi_mul(I_0, zeta)), sfi_mul(t0, zeta_A))));
}

/* The size of R where F = 0. */
static inline sf_interval dissipation_intervals_R_of_response(sf_interval F_0, sf_interval I_)
{
    return sfi_sqrt(sfi_sub(sfi_square(F_0), sfi_square(I_)));
}

/* R where F_Omega = 0. */
static inline sf_interval dissipation_intervals_R_of_peak(sf_interval Omega, sf_interval A, sf_interval zeta, sf_interval d, sf_interval d_3, sf_interval I_)
{
    return sfi_mul(I_, sfi_sub(sfi_sub(sfi_neg(sfi_times(1.5, sfi_mul(sfi_mul(sfi_square(A), Omega), d_3))),
        sfi_mul(A, d)), sfi_div(zeta, Omega)));
}

/* Where a level by inertia is stationary, x = 1/Omega: what is not negative, lower and higher R/Omega^2. */
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

/* F and F_A/2; derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_folds_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(Omega);
    const sf_interval t1 = sfi_times(2.0, zeta);
    const sf_interval t2 = sfi_times(2.0, A);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t3 = sfi_mul(sfi_mul(sfi_square(A), Omega2), d_3);
    const sf_interval t4 = sfi_mul(t0, sfi_add(sfi_add(sfi_mul(sfi_mul(Omega, d), t2), t1), sfi_times(3.0, t3)));
    const sf_interval t5 = sfi_mul(R_A, t4);
    const sf_interval t6 = sfi_inverse(A);
    const sf_interval t7 = sfi_mul(R_A, t6);
    const sf_interval t8 = sfi_times(0.5, I_A);
    const sf_interval t9 = sfi_mul(A, Omega);
    const sf_interval t10 = sfi_times(4.0, d);
    const sf_interval t11 = sfi_mul(t0, sfi_add(sfi_add(sfi_add(t1, sfi_mul(t10, t9)), sfi_mul(t2, zeta_A)),
        sfi_times(9.0, t3)));
    const sf_interval t12 = sfi_times(0.5, I_);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[2] = sfi_times(2.0, sfi_mul(I_, sfi_sub(I_A, sfi_times(0.5, t5))));
    out[3] = sfi_add(sfi_mul(I_, t4), sfi_times(2.0, R));
    out[4] = sfi_add(sfi_add(sfi_mul(R, sfi_sub(h_AA, t7)), sfi_mul(t12,
        sfi_add(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_times(12.0, sfi_mul(sfi_mul(A, Omega3), d_3)), sfi_times(2.0,
        I_0AA)), sfi_times(8.0, sfi_mul(Omega, zeta_A))), sfi_mul(Omega2, t10)), sfi_mul(t11, t7)), sfi_times(4.0,
        sfi_mul(t9, zeta_AA))))), sfi_mul(t8, sfi_sub(sfi_times(2.0, I_A), t5)));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_mul(R, t6), R_A), sfi_mul(sfi_mul(t11, t12), t6)), sfi_mul(t4, t8));
}

/* F and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_peaks_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, d);
    const sf_interval t1 = sfi_inverse(Omega);
    const sf_interval t2 = sfi_mul(t1, zeta);
    const sf_interval t3 = sfi_mul(sfi_square(A), d_3);
    const sf_interval t4 = sfi_times(2.0, zeta);
    const sf_interval t5 = sfi_times(2.0, t0);
    const sf_interval t6 = sfi_square(Omega);
    const sf_interval t7 = sfi_times(3.0, t3);
    const sf_interval t8 = sfi_mul(t1, sfi_add(sfi_add(sfi_mul(Omega, t5), t4), sfi_mul(t6, t7)));
    const sf_interval t9 = sfi_mul(R_A, t8);
    const sf_interval t10 = sfi_mul(I_, t1);
    const sf_interval t11 = sfi_div(sfi_times(0.25, sfi_mul(t10, sfi_add(sfi_neg(sfi_div(t4, t6)), t7))), A);
    const sf_interval t12 = sfi_add(sfi_add(sfi_times(0.25, sfi_mul(Omega, t7)), sfi_times(0.5, t2)), sfi_times(0.25,
        t5));
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_times(1.5, sfi_mul(Omega, t3)), t0), t2)), R);
    out[2] = sfi_times(2.0, sfi_mul(I_, sfi_sub(I_A, sfi_times(0.5, t9))));
    out[3] = sfi_add(sfi_mul(I_, t8), sfi_times(2.0, R));
    out[4] = sfi_add(sfi_add(sfi_sub(sfi_mul(I_, sfi_add(sfi_times(3.0, sfi_mul(sfi_mul(A, Omega), d_3)), d)),
        sfi_mul(R_A, t11)), sfi_mul(t10, zeta_A)), sfi_mul(t12, sfi_sub(sfi_times(2.0, I_A), t9)));
    out[5] = sfi_add(sfi_add(t11, sfi_mul(t12, t8)), sfi_point(1.0));
}

/* F_A/2 and F_AA/2; derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_cusps_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(Omega, zeta_A);
    const sf_interval t1 = sfi_times(4.0, t0);
    const sf_interval t2 = sfi_mul(A, zeta_AA);
    const sf_interval t3 = sfi_mul(Omega, t2);
    const sf_interval t4 = sfi_times(2.0, t3);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t5 = sfi_mul(Omega2, d);
    const sf_interval t6 = sfi_times(2.0, t5);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    const sf_interval t7 = sfi_mul(Omega3, d_3);
    const sf_interval t8 = sfi_mul(A, t7);
    const sf_interval t9 = sfi_times(6.0, t8);
    const sf_interval t10 = sfi_inverse(A);
    const sf_interval t11 = sfi_mul(R_A, t10);
    const sf_interval t12 = sfi_sub(h_AA, t11);
    const sf_interval t13 = sfi_inverse(Omega);
    const sf_interval t14 = sfi_times(2.0, zeta);
    const sf_interval t15 = sfi_mul(Omega, d);
    const sf_interval t16 = sfi_times(2.0, t15);
    const sf_interval t17 = sfi_mul(sfi_mul(sfi_square(A), Omega2), d_3);
    const sf_interval t18 = sfi_mul(t13, sfi_add(sfi_add(sfi_mul(A, t16), t14), sfi_times(3.0, t17)));
    const sf_interval t19 = sfi_sub(I_A, sfi_times(0.5, sfi_mul(R_A, t18)));
    const sf_interval t20 = sfi_times(2.0, zeta_A);
    const sf_interval t21 = sfi_mul(t13, sfi_add(sfi_add(sfi_add(sfi_times(4.0, sfi_mul(A, t15)), sfi_mul(A, t20)), t14),
        sfi_times(9.0, t17)));
    const sf_interval t22 = sfi_add(sfi_add(sfi_add(sfi_sub(sfi_add(sfi_times(2.0, I_0AA), sfi_times(8.0, t0)),
        sfi_mul(t11, t21)), sfi_times(4.0, t3)), sfi_times(4.0, t5)), sfi_times(12.0, t8));
    const sf_interval t23 = sfi_times(0.5, I_);
    const sf_interval t24 = sfi_times(0.5, t18);
    const sf_interval t25 = sfi_mul(t10, t21);
    const sf_interval t26 = sfi_times(6.0, I_);
    const sf_interval t27 = sfi_mul(sfi_mul(I_, t13), sfi_add(sfi_add(sfi_add(sfi_times(9.0, sfi_mul(sfi_mul(A, Omega2),
        d_3)), t16), t2), t20));
    const sf_interval t28 = sfi_add(sfi_add(sfi_add(sfi_add(I_0AA, t1), t4), t6), t9);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AA), sfi_mul(I_, t1)),
        sfi_mul(I_, t4)), sfi_mul(I_, t6)), sfi_mul(I_, t9)), sfi_square(I_A)), sfi_mul(R, h_AA)), sfi_square(R_A));
    out[2] = sfi_add(sfi_add(sfi_mul(I_A, t19), sfi_mul(R, t12)), sfi_mul(t22, t23));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(I_A, t24), sfi_mul(R, t10)), R_A), sfi_mul(t23, t25));
    out[4] = sfi_add(sfi_add(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(2.0,
        sfi_mul(sfi_mul(sfi_mul(A, I_), Omega), zeta_AAA)), sfi_mul(I_, I_0AAA)), sfi_mul(I_A, t22)),
        sfi_mul(sfi_mul(Omega, t26), zeta_AA)), sfi_mul(R, h_AAA)), sfi_times(2.0, sfi_mul(R_A, t12))), sfi_mul(t11,
        t27)), sfi_mul(t19, t28)), sfi_mul(t26, t7));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_A, t25), h_AA), sfi_mul(t10, t27)), sfi_times(2.0, t11)),
        sfi_mul(t24, t28));
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_isolas_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, d);
    const sf_interval t1 = sfi_inverse(Omega);
    const sf_interval t2 = sfi_mul(t1, zeta);
    const sf_interval t3 = sfi_mul(sfi_square(A), d_3);
    const sf_interval t4 = sfi_inverse(A);
    const sf_interval t5 = sfi_mul(R_A, t4);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t6 = sfi_times(2.0, zeta);
    const sf_interval t7 = sfi_times(2.0, t0);
    const sf_interval t8 = sfi_times(3.0, t3);
    const sf_interval t9 = sfi_mul(t1, sfi_add(sfi_add(sfi_mul(Omega, t7), sfi_mul(Omega2, t8)), t6));
    const sf_interval t10 = sfi_sub(sfi_times(2.0, I_A), sfi_mul(R_A, t9));
    const sf_interval t11 = sfi_times(0.5, I_A);
    const sf_interval t12 = sfi_times(4.0, Omega);
    const sf_interval t13 = sfi_mul(A, d_3);
    const sf_interval t14 = sfi_mul(t1, sfi_add(sfi_add(sfi_add(sfi_times(2.0, sfi_mul(A, zeta_A)), sfi_times(9.0,
        sfi_mul(Omega2, t3))), sfi_mul(t0, t12)), t6));
    const sf_interval t15 = sfi_times(0.5, I_);
    const sf_interval t16 = sfi_mul(I_, t1);
    const sf_interval t17 = sfi_times(0.25, sfi_mul(t16, sfi_sub(t8, sfi_div(t6, Omega2))));
    const sf_interval t18 = sfi_add(sfi_add(sfi_times(0.25, sfi_mul(Omega, t8)), sfi_times(0.5, t2)), sfi_times(0.25,
        t7));
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_times(1.5, sfi_mul(Omega, t3)), t0), t2)), R);
    out[2] = sfi_add(sfi_add(sfi_mul(R, sfi_sub(h_AA, t5)), sfi_mul(t10, t11)), sfi_mul(t15,
        sfi_sub(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, t12), zeta_AA), sfi_times(2.0, I_0AA)),
        sfi_times(8.0, sfi_mul(Omega, zeta_A))), sfi_times(4.0, sfi_mul(Omega2, d))), sfi_times(12.0,
        sfi_mul(Omega3, t13))), sfi_mul(t14, t5))));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(R, t4), R_A), sfi_mul(t11, t9)), sfi_mul(sfi_mul(t14, t15), t4));
    out[4] = sfi_sub(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_times(3.0, sfi_mul(Omega, t13)), d)), sfi_mul(t10,
        t18)), sfi_mul(t16, zeta_A)), sfi_mul(t17, t5));
    out[5] = sfi_add(sfi_add(sfi_mul(t17, t4), sfi_mul(t18, t9)), sfi_point(1.0));
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_turns_by_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(R, R_A);
    const sf_interval t1 = sfi_mul(A, R_A);
    const sf_interval t2 = sfi_times(2.0, sfi_mul(I_, d));
    const sf_interval A2 = sfi_square(A);
    const sf_interval t3 = sfi_mul(I_A, d);
    const sf_interval t4 = sfi_inverse(Omega);
    const sf_interval t5 = sfi_mul(I_, t4);
    const sf_interval t6 = sfi_mul(t5, zeta);
    const sf_interval t7 = sfi_mul(t5, zeta_A);
    const sf_interval t8 = sfi_mul(t4, zeta);
    const sf_interval t9 = sfi_mul(I_A, t8);
    const sf_interval t10 = sfi_mul(A2, d_3);
    const sf_interval t11 = sfi_mul(I_, Omega);
    const sf_interval t12 = sfi_times(4.5, t11);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval t13 = sfi_mul(A3, d_3);
    const sf_interval t14 = sfi_mul(I_A, Omega);
    const sf_interval t15 = sfi_times(1.5, t14);
    const sf_interval t16 = sfi_inverse(A);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t17 = sfi_mul(d_3, t1);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    const sf_interval t18 = sfi_mul(t10, t15);
    const sf_interval t19 = sfi_mul(t16, t6);
    const sf_interval t20 = sfi_mul(A, t3);
    const sf_interval t21 = sfi_mul(A, d_3);
    const sf_interval t22 = sfi_times(4.0, zeta_A);
    const sf_interval t23 = sfi_mul(A, zeta);
    const sf_interval t24 = sfi_mul(A2, d);
    const sf_interval t25 = sfi_mul(Omega, d);
    const sf_interval t26 = sfi_mul(A2, zeta);
    const sf_interval t27 = sfi_times(2.0, zeta_AA);
    const sf_interval t28 = sfi_mul(A, t8);
    const sf_interval t29 = sfi_mul(I_A, t4);
    const sf_interval t30 = sfi_times(2.0, zeta_A);
    const sf_interval t31 = sfi_mul(d_3, t26);
    const sf_interval t32 = sfi_times(12.0, t31);
    const sf_interval t33 = sfi_mul(t13, zeta_A);
    const sf_interval t34 = sfi_times(3.0, t33);
    const sf_interval t35 = sfi_div(sfi_point(0.5), Omega3);
    const sf_interval t36 = sfi_mul(I_, t35);
    const sf_interval t37 = sfi_mul(t36, zeta_A);
    const sf_interval t38 = sfi_mul(sfi_mul(I_A, t35), zeta);
    const sf_interval t39 = sfi_mul(A2, sfi_square(d));
    const sf_interval t40 = sfi_times(4.0, t39);
    const sf_interval t41 = sfi_div(sfi_point(2.0), Omega2);
    const sf_interval t42 = sfi_mul(t41, sfi_square(zeta));
    const sf_interval t43 = sfi_times(2.25, t5);
    const sf_interval t44 = sfi_mul(t41, zeta_A);
    const sf_interval t45 = sfi_times(6.0, d);
    const sf_interval t46 = sfi_times(15.0, sfi_mul(t13, t25));
    const sf_interval t47 = sfi_times(6.0, Omega2);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval t48 = sfi_mul(A4, sfi_square(d_3));
    const sf_interval t49 = sfi_mul(sfi_mul(t16, t36), zeta);
    const sf_interval t50 = sfi_times(0.75, sfi_mul(t10, t29));
    const sf_interval t51 = sfi_mul(sfi_mul(t24, t30), t4);
    const sf_interval t52 = sfi_times(13.5, sfi_mul(Omega2, t48));
    const sf_interval Omega4 = sfi_square(Omega2);
    out[0] = sfi_add(sfi_mul(I_, I_A), t0);
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A, t2), sfi_mul(A, t7)),
        sfi_mul(A, t9)), sfi_mul(A2, t3)), R), t1), sfi_mul(t10, t12)), sfi_mul(t13, t15)), t6);
    out[2] = sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(2.0,
        sfi_mul(sfi_mul(sfi_mul(A, I_), Omega), zeta_AA)), sfi_times(6.0, sfi_mul(sfi_mul(sfi_mul(A, I_), Omega3),
        d_3))), sfi_mul(I_, I_0AA)), sfi_times(4.0, sfi_mul(sfi_mul(I_, Omega), zeta_A))), sfi_times(2.0,
        sfi_mul(sfi_mul(I_, Omega2), d))), sfi_square(I_A)), sfi_mul(R, h_AA)), sfi_mul(R_A, t18)), sfi_mul(R_A,
        t19)), sfi_mul(R_A, t2)), sfi_mul(R_A, t7)), sfi_mul(R_A, t9)), sfi_mul(t0, t16)), sfi_mul(t1, t3)),
        sfi_mul(t12, t17));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(R, t16), R_A), sfi_mul(t12,
        t21)), t18), t19), t2), t20), t7), t9);
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_sub(sfi_add(sfi_add(sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_sub(sfi_add(sfi_sub(sfi_sub(sfi_sub(sfi_add(sfi_add(sfi_sub(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A,
        h_AA), sfi_mul(sfi_mul(A, t29), t30)), sfi_mul(sfi_mul(A, t5), zeta_AA)), sfi_mul(sfi_mul(A3, t25), t27)),
        sfi_times(3.0, sfi_mul(sfi_mul(sfi_mul(A4, Omega2), d_3), zeta_AA))), sfi_times(1.5, sfi_mul(sfi_mul(I_0AA,
        Omega), t13))), sfi_mul(I_0AA, t24)), sfi_mul(I_0AA, t28)), sfi_mul(sfi_mul(Omega, t22), t24)),
        sfi_times(2.0, sfi_mul(Omega2, t39))), sfi_times(9.0, sfi_mul(sfi_mul(Omega3, d), t13))), sfi_times(9.0,
        sfi_mul(Omega4, t48))), sfi_mul(R_A, t32)), sfi_mul(R_A, t34)), sfi_mul(R_A, t37)), sfi_mul(R_A, t38)),
        sfi_mul(R_A, t40)), sfi_mul(R_A, t42)), sfi_mul(R_A, t46)), sfi_mul(R_A, t49)), sfi_mul(R_A, t50)),
        sfi_mul(R_A, t51)), sfi_mul(R_A, t52)), sfi_mul(sfi_mul(t1, t44), zeta)), sfi_mul(sfi_mul(t1, t45), t8)),
        sfi_times(9.0, sfi_mul(t10, t14))), sfi_times(9.0, sfi_mul(t11, t21))), sfi_mul(t17, t43)), t2),
        sfi_times(4.0, t20)), sfi_mul(t22, t23)), sfi_times(2.0, sfi_mul(t23, t25))), sfi_mul(t26, t27)),
        sfi_mul(t31, t47)), sfi_mul(t33, t47)), sfi_times(2.0, t7)), sfi_times(2.0, t9));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_sub(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(t21,
        t43), sfi_mul(t23, t44)), sfi_mul(t28, t45)), t32), t34), t37), t38), t40), t42), t46), t49), t50), t51),
        t52), sfi_point(2.0));
}

/* F and F_A/2; derivatives by A and by Omega of the first, then of the second. */
static inline void dissipation_intervals_folds_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    const sf_interval t1 = sfi_times(2.0, Omega);
    const sf_interval t2 = sfi_mul(R, t1);
    const sf_interval t3 = sfi_times(2.0, zeta);
    const sf_interval t4 = sfi_mul(A, t1);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t5 = sfi_mul(sfi_mul(sfi_square(A), Omega2), d_3);
    const sf_interval t6 = sfi_add(sfi_add(sfi_mul(d, t4), t3), sfi_times(3.0, t5));
    const sf_interval t7 = sfi_times(2.0, A);
    const sf_interval t8 = sfi_times(4.0, Omega);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = t0;
    out[2] = sfi_times(2.0, t0);
    out[3] = sfi_mul(t7, sfi_add(sfi_mul(I_, t6), t2));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(6.0, sfi_mul(sfi_mul(A,
        Omega3), d_3)), I_0AA), sfi_times(2.0, sfi_mul(Omega2, d))), sfi_mul(t4, zeta_AA)), sfi_mul(t8, zeta_A))),
        sfi_square(I_A)), sfi_mul(R, h_AA)), sfi_square(R_A));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, I_A), t6), sfi_mul(I_,
        sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, d), t8), t3), sfi_times(9.0, t5)), sfi_mul(t7, zeta_A)))),
        sfi_mul(R_A, t4)), t2);
}

/* F and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second. */
static inline void dissipation_intervals_peaks_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(Omega);
    const sf_interval t1 = sfi_mul(I_0, t0);
    const sf_interval t2 = sfi_times(3.0, zeta);
    const sf_interval t3 = sfi_mul(A, Omega);
    const sf_interval t4 = sfi_mul(d, t3);
    const sf_interval t5 = sfi_add(sfi_add(sfi_mul(I_0, d), sfi_mul(t4, sfi_add(t2, t4))), sfi_times(2.0,
        sfi_square(zeta)));
    const sf_interval t6 = sfi_times(5.0, d);
    const sf_interval t7 = sfi_times(3.0, d_3);
    const sf_interval t8 = sfi_add(sfi_mul(t3, sfi_add(sfi_mul(t3, t7), t6)), sfi_times(8.0, zeta));
    const sf_interval t9 = sfi_add(sfi_times(3.0, I_0), sfi_mul(t3, t8));
    const sf_interval A2 = sfi_square(A);
    const sf_interval t10 = sfi_times(0.5, A2);
    const sf_interval t11 = sfi_mul(sfi_mul(d_3, t10), t9);
    const sf_interval t12 = sfi_times(2.0, zeta);
    const sf_interval t13 = sfi_times(2.0, t4);
    const sf_interval t14 = sfi_square(Omega);
    const sf_interval t15 = sfi_mul(A2, t7);
    const sf_interval t16 = sfi_times(2.0, A);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval t17 = sfi_mul(d_3, t14);
    const sf_interval t18 = sfi_add(t13, t2);
    const sf_interval t19 = sfi_mul(d_3, t3);
    const sf_interval t20 = sfi_add(sfi_mul(t3, sfi_add(sfi_times(6.0, t19), t6)), t8);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_mul(A, t5), sfi_mul(Omega, t11)), R), sfi_mul(t1, zeta));
    out[2] = sfi_times(2.0, sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A)));
    out[3] = sfi_mul(t16, sfi_add(sfi_mul(I_, sfi_add(sfi_add(t12, t13), sfi_mul(t14, t15))), sfi_times(2.0,
        sfi_mul(Omega, R))));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(0.5, sfi_mul(I_0A,
        sfi_add(sfi_add(sfi_mul(Omega, t15), sfi_mul(d, t16)), sfi_mul(t0, t12)))), R_A), sfi_mul(sfi_mul(t10, t17),
        t20)), sfi_mul(t18, t4)), sfi_mul(t19, t9)), t5), sfi_mul(zeta_A, sfi_add(sfi_add(sfi_mul(A,
        sfi_add(sfi_times(3.0, t4), sfi_times(4.0, zeta))), sfi_times(4.0, sfi_mul(A3, t17))), t1)));
    out[5] = sfi_add(sfi_add(sfi_sub(sfi_add(sfi_mul(sfi_mul(A2, d), t18), sfi_times(0.5,
        sfi_mul(sfi_mul(sfi_mul(A3, Omega), d_3), t20))), sfi_div(sfi_mul(I_0, zeta), t14)), t11), sfi_times(2.0,
        t3));
}

/* F_A/2 and F_AA/2; derivatives by A and by Omega of the first, then of the second. */
static inline void dissipation_intervals_cusps_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t0 = sfi_times(2.0, d);
    const sf_interval t1 = sfi_mul(Omega2, t0);
    const sf_interval t2 = sfi_times(4.0, zeta_A);
    const sf_interval t3 = sfi_mul(Omega, t2);
    const sf_interval t4 = sfi_times(2.0, A);
    const sf_interval t5 = sfi_mul(Omega, t4);
    const sf_interval t6 = sfi_mul(t5, zeta_AA);
    const sf_interval t7 = sfi_mul(A, d_3);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    const sf_interval t8 = sfi_times(6.0, Omega3);
    const sf_interval t9 = sfi_mul(t7, t8);
    const sf_interval t10 = sfi_add(sfi_add(sfi_square(I_A), sfi_mul(R, h_AA)), sfi_square(R_A));
    const sf_interval t11 = sfi_add(sfi_add(sfi_add(sfi_add(I_0AA, t1), t3), t6), t9);
    const sf_interval t12 = sfi_times(2.0, zeta);
    const sf_interval t13 = sfi_mul(sfi_mul(sfi_square(A), Omega2), d_3);
    const sf_interval t14 = sfi_mul(A, sfi_add(sfi_add(sfi_mul(sfi_mul(A, Omega), t0), t12), sfi_times(3.0, t13)));
    const sf_interval t15 = sfi_times(4.0, Omega);
    const sf_interval t16 = sfi_mul(d, t15);
    const sf_interval t17 = sfi_add(sfi_add(sfi_add(sfi_mul(A, t16), t12), sfi_times(9.0, t13)), sfi_mul(t4, zeta_A));
    const sf_interval t18 = sfi_mul(I_, zeta_AA);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AA), sfi_mul(I_, t1)), sfi_mul(I_, t3)),
        sfi_mul(I_, t6)), sfi_mul(I_, t9)), t10);
    out[2] = sfi_add(sfi_mul(I_, t11), t10);
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, t17), sfi_mul(I_A, t14)), sfi_times(2.0, sfi_mul(Omega, R))),
        sfi_mul(R_A, t5));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AAA), sfi_mul(sfi_mul(I_, d_3), t8)),
        sfi_mul(sfi_mul(I_, t5), zeta_AAA)), sfi_times(3.0, sfi_mul(I_A, t11))), sfi_times(6.0, sfi_mul(Omega,
        t18))), sfi_mul(R, h_AAA)), sfi_times(3.0, sfi_mul(R_A, h_AA)));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(18.0, sfi_mul(sfi_mul(I_, Omega2),
        t7)), sfi_mul(I_, t16)), sfi_mul(I_, t2)), sfi_times(2.0, sfi_mul(I_A, t17))), sfi_mul(R_A, t15)),
        sfi_mul(h_AA, t5)), sfi_mul(t11, t14)), sfi_mul(t18, t4));
}

/* F_A/2 and what vanishes where the level is stationary; derivatives by A and by Omega of the first, then of the second. */
static inline void dissipation_intervals_isolas_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(Omega);
    const sf_interval t1 = sfi_mul(I_0, t0);
    const sf_interval t2 = sfi_times(3.0, zeta);
    const sf_interval t3 = sfi_mul(A, Omega);
    const sf_interval t4 = sfi_mul(d, t3);
    const sf_interval t5 = sfi_add(sfi_add(sfi_mul(I_0, d), sfi_mul(t4, sfi_add(t2, t4))), sfi_times(2.0,
        sfi_square(zeta)));
    const sf_interval A2 = sfi_square(A);
    const sf_interval t6 = sfi_mul(A2, Omega);
    const sf_interval t7 = sfi_times(5.0, d);
    const sf_interval t8 = sfi_times(3.0, d_3);
    const sf_interval t9 = sfi_add(sfi_mul(t3, sfi_add(sfi_mul(t3, t8), t7)), sfi_times(8.0, zeta));
    const sf_interval t10 = sfi_mul(d_3, sfi_add(sfi_times(3.0, I_0), sfi_mul(t3, t9)));
    const sf_interval t11 = sfi_times(0.5, t10);
    const sf_interval t12 = sfi_times(2.0, t3);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval t13 = sfi_times(2.0, d);
    const sf_interval t14 = sfi_times(6.0, d_3);
    const sf_interval t15 = sfi_times(2.0, zeta);
    const sf_interval t16 = sfi_times(2.0, t4);
    const sf_interval t17 = sfi_mul(A2, Omega2);
    const sf_interval t18 = sfi_mul(d_3, t17);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval t19 = sfi_mul(A3, d_3);
    const sf_interval t20 = sfi_add(t16, t2);
    const sf_interval t21 = sfi_add(sfi_times(0.5, sfi_mul(t3, sfi_add(sfi_mul(t14, t3), t7))), sfi_times(0.5, t9));
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_mul(A, t5), R), sfi_mul(t1, zeta)), sfi_mul(t11, t6));
    out[2] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, Omega3), t14),
        I_0AA), sfi_times(4.0, sfi_mul(Omega, zeta_A))), sfi_mul(Omega2, t13)), sfi_mul(t12, zeta_AA))),
        sfi_square(I_A)), sfi_mul(R, h_AA)), sfi_square(R_A));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, I_A), sfi_add(sfi_add(t15, t16), sfi_mul(t17, t8))),
        sfi_mul(I_, sfi_add(sfi_add(sfi_add(sfi_times(2.0, sfi_mul(A, zeta_A)), t15), sfi_times(9.0, t18)),
        sfi_times(4.0, t4)))), sfi_times(2.0, sfi_mul(Omega, R))), sfi_mul(R_A, t12));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(0.5, sfi_mul(I_0A,
        sfi_add(sfi_add(sfi_mul(A, t13), sfi_mul(t0, t15)), sfi_mul(t6, t8)))), R_A), sfi_mul(t10, t3)),
        sfi_mul(t18, t21)), sfi_mul(t20, t4)), t5), sfi_mul(zeta_A, sfi_add(sfi_add(sfi_mul(A,
        sfi_add(sfi_times(3.0, t4), sfi_times(4.0, zeta))), sfi_times(4.0, sfi_mul(Omega2, t19))), t1)));
    out[5] = sfi_add(sfi_add(sfi_sub(sfi_add(sfi_mul(sfi_mul(A2, d), t20), sfi_mul(A2, t11)), sfi_div(sfi_mul(I_0,
        zeta), Omega2)), sfi_mul(sfi_mul(Omega, t19), t21)), t12);
}

/* F_A/2 and F_AOmega/(4 Omega); derivatives by A and by Omega of the first, then of the second. */
static inline void dissipation_intervals_turns_by_Omega(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, R_A);
    const sf_interval t1 = sfi_times(2.0, I_);
    const sf_interval t2 = sfi_mul(d, t1);
    const sf_interval A2 = sfi_square(A);
    const sf_interval t3 = sfi_mul(A2, d);
    const sf_interval t4 = sfi_mul(I_A, t3);
    const sf_interval t5 = sfi_inverse(Omega);
    const sf_interval t6 = sfi_mul(I_, zeta);
    const sf_interval t7 = sfi_mul(A, t5);
    const sf_interval t8 = sfi_mul(I_, zeta_A);
    const sf_interval t9 = sfi_mul(I_A, zeta);
    const sf_interval t10 = sfi_mul(I_, d_3);
    const sf_interval t11 = sfi_mul(A2, t10);
    const sf_interval t12 = sfi_times(4.5, t11);
    const sf_interval t13 = sfi_times(1.5, I_A);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval t14 = sfi_mul(A3, Omega);
    const sf_interval t15 = sfi_mul(d_3, t14);
    const sf_interval t16 = sfi_times(4.0, Omega);
    const sf_interval t17 = sfi_mul(I_, zeta_AA);
    const sf_interval t18 = sfi_times(2.0, Omega);
    const sf_interval t19 = sfi_mul(A, t18);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    const sf_interval t20 = sfi_mul(A, t10);
    const sf_interval t21 = sfi_mul(t1, zeta_A);
    const sf_interval t22 = sfi_times(2.0, t9);
    const sf_interval t23 = sfi_mul(A, t16);
    const sf_interval t24 = sfi_mul(A3, d_3);
    const sf_interval t25 = sfi_times(3.0, Omega2);
    const sf_interval t26 = sfi_times(4.0, A);
    const sf_interval t27 = sfi_mul(zeta, zeta_A);
    const sf_interval t28 = sfi_times(9.0, Omega);
    const sf_interval t29 = sfi_times(2.0, A2);
    const sf_interval t30 = sfi_mul(A2, d_3);
    const sf_interval t31 = sfi_mul(A3, d);
    const sf_interval t32 = sfi_times(6.0, Omega2);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval t33 = sfi_mul(A4, d_3);
    const sf_interval t34 = sfi_square(d);
    const sf_interval t35 = sfi_square(d_3);
    const sf_interval t36 = sfi_inverse(Omega2);
    const sf_interval t37 = sfi_mul(A, t36);
    const sf_interval Omega4 = sfi_square(Omega2);
    const sf_interval A5 = sfi_mul(A, A4);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A, t2), sfi_mul(Omega, t12)),
        R), t0), sfi_mul(t13, t15)), t4), sfi_mul(t5, t6)), sfi_mul(t7, t8)), sfi_mul(t7, t9));
    out[2] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AA), sfi_square(I_A)),
        sfi_mul(Omega2, t2)), sfi_times(6.0, sfi_mul(Omega3, t20))), sfi_mul(R, h_AA)), sfi_square(R_A)),
        sfi_mul(t16, t8)), sfi_mul(t17, t19));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A, t21), sfi_mul(A, t22)),
        sfi_mul(sfi_mul(I_, d), t23)), sfi_mul(sfi_mul(I_A, t24), t25)), sfi_times(9.0, sfi_mul(Omega2, t11))),
        sfi_mul(R, t18)), sfi_mul(t0, t18)), sfi_mul(t18, t4)), sfi_times(2.0, t6));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(A,
        h_AA), sfi_times(9.0, sfi_mul(sfi_mul(A4, Omega4), t35))), sfi_times(1.5, sfi_mul(I_0AA, t15))),
        sfi_mul(I_0AA, t3)), sfi_mul(sfi_mul(I_0AA, t7), zeta)), sfi_mul(sfi_mul(I_A, d), t26)),
        sfi_mul(sfi_mul(I_A, t28), t30)), sfi_times(2.0, sfi_mul(sfi_mul(I_A, t7), zeta_A))),
        sfi_mul(sfi_mul(Omega2, t29), t34)), sfi_times(9.0, sfi_mul(sfi_mul(Omega3, d_3), t31))), sfi_times(2.0,
        R_A)), sfi_mul(sfi_mul(d, t19), zeta)), sfi_mul(sfi_mul(t16, t3), zeta_A)), sfi_mul(t17, t7)),
        sfi_mul(sfi_mul(t18, t31), zeta_AA)), t2), sfi_mul(t20, t28)), sfi_mul(t21, t5)), sfi_mul(t22, t5)),
        sfi_mul(sfi_mul(t24, t32), zeta_A)), sfi_mul(sfi_mul(t25, t33), zeta_AA)), sfi_mul(t26, t27)),
        sfi_mul(sfi_mul(t29, zeta), zeta_AA)), sfi_mul(sfi_mul(t30, t32), zeta));
    out[5] = sfi_add(sfi_sub(sfi_sub(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(4.0,
        sfi_mul(sfi_mul(A2, t27), t5)), sfi_times(27.0, sfi_mul(sfi_mul(A5, Omega3), t35))), sfi_times(6.0,
        sfi_mul(sfi_mul(Omega, t33), zeta_A))), sfi_times(30.0, sfi_mul(sfi_mul(Omega2, d), t33))), t12),
        sfi_mul(t13, t24)), sfi_times(8.0, sfi_mul(t14, t34))), sfi_times(24.0, sfi_mul(t15, zeta))), t23),
        sfi_times(12.0, sfi_mul(t3, zeta))), sfi_times(4.0, sfi_mul(t31, zeta_A))), sfi_mul(t36, t6)), sfi_mul(t37,
        t8)), sfi_mul(t37, t9)), sfi_times(4.0, sfi_mul(t7, sfi_square(zeta))));
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_folds_far_by_R(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_inverse(h);
    const sf_interval t1 = sfi_div(t0, x);
    const sf_interval t2 = sfi_mul(t1, sfi_add(sfi_mul(A, zeta), sfi_mul(I_0, x)));
    const sf_interval t3 = sfi_sub(I_A, sfi_mul(R_A, t2));
    const sf_interval t4 = sfi_square(x);
    const sf_interval t5 = sfi_mul(h_A, t0);
    const sf_interval t6 = sfi_mul(t1, sfi_add(sfi_add(sfi_mul(A, zeta_A), sfi_mul(I_0A, x)), zeta));
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[2] = sfi_times(2.0, sfi_mul(I_, t3));
    out[3] = sfi_times(2.0, sfi_add(sfi_mul(I_, t2), R));
    out[4] = sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_sub(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, x),
        zeta_AA)), sfi_mul(I_0AA, t4)), sfi_mul(R_A, t6)), sfi_times(2.0, d)), sfi_times(4.0, sfi_mul(x, zeta_A)))),
        sfi_mul(I_A, t3)), sfi_mul(R, sfi_add(sfi_neg(sfi_mul(R_A, t5)), sfi_mul(h_AA, t4))));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, t6), sfi_mul(I_A, t2)), sfi_mul(R, t5)), R_A);
}

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_peaks_far_by_R(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
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
    out[4] = sfi_mul(t0, sfi_add(sfi_add(sfi_sub(sfi_add(sfi_add(sfi_mul(sfi_mul(A, t7), zeta_A), sfi_mul(I_,
        I_0A)), sfi_mul(sfi_mul(R_A, t8), t9)), sfi_mul(sfi_mul(h_A, t10), t8)), sfi_mul(t10, t6)), sfi_mul(t7,
        zeta)));
    out[5] = sfi_add(sfi_add(sfi_neg(sfi_mul(sfi_mul(I_, t11), t9)), sfi_mul(sfi_mul(sfi_mul(t1, t10), t11), t4)),
        sfi_point(1.0));
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_cusps_far_by_R(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, d);
    const sf_interval t1 = sfi_times(4.0, sfi_mul(x, zeta_A));
    const sf_interval t2 = sfi_square(x);
    const sf_interval t3 = sfi_mul(I_0AA, t2);
    const sf_interval t4 = sfi_mul(h_AA, t2);
    const sf_interval t5 = sfi_times(2.0, I_);
    const sf_interval t6 = sfi_mul(A, zeta_AA);
    const sf_interval t7 = sfi_mul(t6, x);
    const sf_interval t8 = sfi_inverse(h);
    const sf_interval t9 = sfi_mul(h_A, t8);
    const sf_interval t10 = sfi_mul(R_A, t9);
    const sf_interval t11 = sfi_sub(sfi_mul(h_AA, t2), t10);
    const sf_interval t12 = sfi_add(sfi_mul(A, zeta), sfi_mul(I_0, x));
    const sf_interval t13 = sfi_div(t8, x);
    const sf_interval t14 = sfi_mul(R_A, t13);
    const sf_interval t15 = sfi_sub(I_A, sfi_mul(t12, t14));
    const sf_interval t16 = sfi_add(sfi_add(sfi_mul(A, zeta_A), sfi_mul(I_0A, x)), zeta);
    const sf_interval t17 = sfi_add(sfi_add(sfi_add(t0, t1), t3), sfi_times(2.0, t7));
    const sf_interval t18 = sfi_add(sfi_neg(sfi_mul(t14, t16)), t17);
    const sf_interval t19 = sfi_mul(t12, t13);
    const sf_interval t20 = sfi_mul(t13, t16);
    const sf_interval t21 = sfi_mul(I_, x);
    const sf_interval t22 = sfi_mul(t13, sfi_add(sfi_add(sfi_add(sfi_mul(I_, t6), sfi_mul(I_0AA, t21)),
        sfi_mul(sfi_mul(R, h_AA), x)), sfi_mul(t5, zeta_A)));
    const sf_interval t23 = sfi_times(2.0, I_A);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, t0), sfi_mul(I_, t1)), sfi_mul(I_, t3)),
        sfi_square(I_A)), sfi_mul(R, t4)), sfi_square(R_A)), sfi_mul(t5, t7));
    out[2] = sfi_add(sfi_add(sfi_mul(I_, t18), sfi_mul(I_A, t15)), sfi_mul(R, t11));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, t20), sfi_mul(I_A, t19)), sfi_mul(R, t9)), R_A);
    out[4] = sfi_add(sfi_add(sfi_add(sfi_sub(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(sfi_mul(A, t5), x),
        zeta_AAA), sfi_mul(sfi_mul(I_, I_0AAA), t2)), sfi_mul(sfi_mul(R, h_AAA), t2)), sfi_times(2.0, sfi_mul(R_A,
        t11))), sfi_mul(R_A, t22)), sfi_mul(t15, t17)), sfi_mul(t18, t23)), sfi_times(6.0, sfi_mul(t21, zeta_AA)));
    out[5] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(2.0, t10), sfi_mul(t17, t19)), sfi_mul(t20, t23)), t22),
        t4);
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by R of the first, then of the second. */
static inline void dissipation_intervals_isolas_far_by_R(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
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
    const sf_interval t9 = sfi_mul(A, zeta_A);
    const sf_interval t10 = sfi_mul(t0, sfi_add(sfi_add(sfi_mul(I_0A, x), t9), zeta));
    const sf_interval t11 = sfi_mul(I_, t1);
    const sf_interval x3 = sfi_mul(x, x2);
    const sf_interval t12 = sfi_div(sfi_times(0.5, sfi_mul(I_, t2)), x3);
    const sf_interval t13 = sfi_add(I_0, t3);
    const sf_interval t14 = sfi_inverse(sfi_square(h));
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_mul(I_, sfi_add(sfi_mul(I_0, t0), sfi_mul(t0, t3))), R);
    out[2] = sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_sub(sfi_add(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, x),
        zeta_AA)), sfi_mul(I_0AA, x2)), sfi_times(2.0, d)), sfi_mul(t10, t5)), sfi_times(4.0, sfi_mul(x, zeta_A)))),
        sfi_mul(I_A, t8)), sfi_mul(R, sfi_add(sfi_neg(sfi_mul(R_A, t4)), sfi_mul(h_AA, x2))));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(I_A, t1), t7), sfi_mul(R, t4)), R_A), sfi_mul(t10, t11));
    out[4] = sfi_mul(t0, sfi_add(sfi_add(sfi_add(sfi_add(sfi_sub(sfi_mul(I_, I_0A), sfi_mul(sfi_mul(I_, t13),
        t4)), sfi_mul(sfi_mul(R_A, t0), t12)), sfi_mul(t11, t9)), sfi_mul(t11, zeta)), sfi_mul(t13, t8)));
    out[5] = sfi_add(sfi_sub(sfi_mul(sfi_mul(sfi_mul(t1, t13), t14), t6), sfi_mul(t12, t14)), sfi_point(1.0));
}

/* F and F_A/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second. */
static inline void dissipation_intervals_folds_far_by_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    const sf_interval t1 = sfi_mul(R, x);
    const sf_interval t2 = sfi_add(sfi_mul(A, zeta), sfi_mul(I_0, x));
    const sf_interval t3 = sfi_square(x);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = t0;
    out[2] = sfi_times(2.0, t0);
    out[3] = sfi_times(4.0, sfi_add(sfi_mul(I_, t2), sfi_mul(h, t1)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, x),
        zeta_AA)), sfi_mul(I_0AA, t3)), sfi_times(2.0, d)), sfi_times(4.0, sfi_mul(x, zeta_A)))), sfi_square(I_A)),
        sfi_mul(sfi_mul(R, h_AA), t3)), sfi_square(R_A));
    out[5] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_mul(A, zeta_A), sfi_mul(I_0A,
        x)), zeta)), sfi_mul(I_A, t2)), sfi_mul(sfi_mul(R_A, h), x)), sfi_mul(h_A, t1)));
}

/* F and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second. */
static inline void dissipation_intervals_peaks_far_by_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(R, h);
    const sf_interval t1 = sfi_mul(A, zeta);
    const sf_interval t2 = sfi_times(2.0, t1);
    const sf_interval t3 = sfi_mul(I_0, x);
    const sf_interval t4 = sfi_square(A);
    const sf_interval t5 = sfi_div(d, x);
    const sf_interval t6 = sfi_add(t3, sfi_mul(t4, t5));
    const sf_interval t7 = sfi_add(t2, t6);
    const sf_interval t8 = sfi_add(t1, t3);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = sfi_add(sfi_add(sfi_mul(I_, I_0), t0), sfi_mul(t1, t7));
    out[2] = sfi_times(2.0, sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A)));
    out[3] = sfi_times(4.0, sfi_add(sfi_mul(I_, t8), sfi_mul(t0, x)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, zeta_A), sfi_add(sfi_times(4.0,
        t1), t6)), sfi_mul(I_0, I_A)), sfi_mul(I_0A, sfi_add(I_, sfi_mul(t1, x)))), sfi_mul(R, h_A)), sfi_mul(R_A,
        h)), sfi_mul(t2, sfi_add(sfi_mul(A, t5), zeta))), sfi_mul(t7, zeta));
    out[5] = sfi_add(sfi_add(sfi_times(2.0, sfi_mul(I_0, t8)), sfi_times(2.0, sfi_mul(sfi_square(h), x))),
        sfi_mul(t1, sfi_sub(I_0, sfi_div(sfi_mul(d, t4), sfi_square(x)))));
}

/* F_A/2 and F_AA/2 of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second. */
static inline void dissipation_intervals_cusps_far_by_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_times(2.0, d);
    const sf_interval x2 = sfi_square(x);
    const sf_interval t1 = sfi_mul(I_0AA, x2);
    const sf_interval t2 = sfi_times(4.0, sfi_mul(x, zeta_A));
    const sf_interval t3 = sfi_times(2.0, I_);
    const sf_interval t4 = sfi_mul(A, zeta_AA);
    const sf_interval t5 = sfi_mul(t4, x);
    const sf_interval t6 = sfi_mul(R, x2);
    const sf_interval t7 = sfi_add(sfi_add(sfi_square(I_A), sfi_square(R_A)), sfi_mul(h_AA, t6));
    const sf_interval t8 = sfi_add(sfi_add(sfi_add(t0, t1), t2), sfi_times(2.0, t5));
    const sf_interval t9 = sfi_mul(R, x);
    const sf_interval t10 = sfi_mul(R_A, x);
    const sf_interval t11 = sfi_add(sfi_mul(A, zeta), sfi_mul(I_0, x));
    const sf_interval t12 = sfi_add(sfi_add(sfi_mul(A, zeta_A), sfi_mul(I_0A, x)), zeta);
    const sf_interval t13 = sfi_mul(I_, x);
    const sf_interval x3 = sfi_mul(x, x2);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, t0), sfi_mul(I_, t1)), sfi_mul(I_, t2)), sfi_mul(t3,
        t5)), t7);
    out[2] = sfi_add(sfi_mul(I_, t8), t7);
    out[3] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(I_, t12), sfi_mul(I_A, t11)), sfi_mul(h, t10)),
        sfi_mul(h_A, t9)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(sfi_mul(A, t3), x), zeta_AAA),
        sfi_mul(sfi_mul(I_, I_0AAA), x2)), sfi_times(3.0, sfi_mul(I_A, t8))), sfi_times(3.0, sfi_mul(sfi_mul(R_A,
        h_AA), x2))), sfi_mul(h_AAA, t6)), sfi_times(6.0, sfi_mul(t13, zeta_AA)));
    out[5] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, t4),
        sfi_mul(I_0AA, t13)), sfi_times(2.0, sfi_mul(I_A, t12))), sfi_mul(sfi_mul(h, h_AA), x3)), sfi_times(2.0,
        sfi_mul(h_A, t10))), sfi_mul(h_AA, t9)), sfi_mul(t11, t8)), sfi_mul(t3, zeta_A)));
}

/* F_A/2 and what vanishes where the level is stationary of an excitation by inertia, over powers of Omega, x = 1/Omega; derivatives by A and by x of the first, then of the second. */
static inline void dissipation_intervals_isolas_far_by_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval I_0AAA, sf_interval zeta, sf_interval zeta_A, sf_interval zeta_AA, sf_interval zeta_AAA, sf_interval d, sf_interval d_3, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval h_AAA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
{
    const sf_interval t0 = sfi_mul(A, zeta);
    const sf_interval t1 = sfi_times(2.0, t0);
    const sf_interval t2 = sfi_mul(I_0, x);
    const sf_interval t3 = sfi_square(A);
    const sf_interval t4 = sfi_div(d, x);
    const sf_interval t5 = sfi_add(t2, sfi_mul(t3, t4));
    const sf_interval t6 = sfi_add(t1, t5);
    const sf_interval t7 = sfi_square(x);
    const sf_interval t8 = sfi_times(2.0, x);
    const sf_interval t9 = sfi_mul(R, h_A);
    const sf_interval t10 = sfi_mul(R_A, h);
    const sf_interval t11 = sfi_add(t0, t2);
    const sf_interval t12 = sfi_mul(A, zeta_A);
    out[0] = sfi_add(sfi_mul(I_, I_A), sfi_mul(R, R_A));
    out[1] = sfi_add(sfi_add(sfi_mul(I_, I_0), sfi_mul(R, h)), sfi_mul(t0, t6));
    out[2] = sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, t8), zeta_AA),
        sfi_mul(I_0AA, t7)), sfi_times(2.0, d)), sfi_times(4.0, sfi_mul(x, zeta_A)))), sfi_square(I_A)),
        sfi_mul(sfi_mul(R, h_AA), t7)), sfi_square(R_A));
    out[3] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_mul(I_, sfi_add(sfi_add(sfi_mul(I_0A, x), t12), zeta)),
        sfi_mul(I_A, t11)), sfi_mul(t10, x)), sfi_mul(t9, x)));
    out[4] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_0, I_A), sfi_mul(I_0A, sfi_add(I_,
        sfi_mul(t0, x)))), sfi_mul(t1, sfi_add(sfi_mul(A, t4), zeta))), t10), sfi_mul(t12, sfi_add(sfi_times(4.0,
        t0), t5))), sfi_mul(t6, zeta)), t9);
    out[5] = sfi_add(sfi_add(sfi_times(2.0, sfi_mul(I_0, t11)), sfi_mul(sfi_square(h), t8)), sfi_mul(t0,
        sfi_sub(I_0, sfi_div(sfi_mul(d, t3), t7))));
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
static inline sf_interval dissipation_intervals_sine_intercept(sf_interval Omega, sf_interval A, sf_interval level, sf_interval zeta_A, sf_interval d, sf_interval d_3)
{
    const sf_interval A2 = sfi_square(A);
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    return sfi_add(sfi_sub(sfi_sub(sfi_neg(sfi_times(2.0, sfi_mul(sfi_mul(A2, Omega), zeta_A))),
        sfi_mul(sfi_mul(A2, Omega2), d)), sfi_times(2.0, sfi_mul(sfi_mul(A3, Omega3), d_3))), level);
}

/* The same over Omega^2, at x = 1/Omega.
   Equation from (23). Domain: x >= 0, A > 0. */
static inline sf_interval dissipation_intervals_sine_intercept_far(sf_interval x, sf_interval A, sf_interval level, sf_interval zeta_A, sf_interval d)
{
    const sf_interval t0 = sfi_square(A);
    return sfi_sub(sfi_add(sfi_neg(sfi_mul(d, t0)), sfi_mul(level, sfi_square(x))), sfi_times(2.0,
        sfi_mul(sfi_mul(t0, x), zeta_A)));
}

/* d2I/dA2.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline sf_interval dissipation_intervals_I_AA(sf_interval Omega, sf_interval A, sf_interval I_0AA, sf_interval zeta_A, sf_interval zeta_AA, sf_interval d, sf_interval d_3)
{
    const sf_interval Omega2 = sfi_square(Omega);
    const sf_interval Omega3 = sfi_mul(Omega, Omega2);
    return sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, Omega), zeta_AA)), sfi_times(6.0,
        sfi_mul(sfi_mul(A, Omega3), d_3))), I_0AA), sfi_times(4.0, sfi_mul(Omega, zeta_A))), sfi_times(2.0,
        sfi_mul(Omega2, d)));
}

/* d2I/dA2 over it.
   Equation (23). Domain: x >= 0, A > 0. */
static inline sf_interval dissipation_intervals_I_AA_far(sf_interval x, sf_interval A, sf_interval I_0AA, sf_interval zeta_A, sf_interval zeta_AA, sf_interval d)
{
    return sfi_add(sfi_add(sfi_add(sfi_times(2.0, sfi_mul(sfi_mul(A, x), zeta_AA)), sfi_mul(I_0AA,
        sfi_square(x))), sfi_times(2.0, d)), sfi_times(4.0, sfi_mul(x, zeta_A)));
}

/* R where F_Omega = 0, by I at Omega = 0.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline sf_interval dissipation_intervals_R_of_peak_by_rest(sf_interval Omega, sf_interval A, sf_interval I_0, sf_interval zeta, sf_interval d, sf_interval d_3)
{
    const sf_interval t0 = sfi_mul(A, Omega);
    const sf_interval t1 = sfi_mul(d, t0);
    return sfi_sub(sfi_sub(sfi_neg(sfi_times(0.5, sfi_mul(sfi_mul(sfi_mul(sfi_square(A), Omega), d_3),
        sfi_add(sfi_times(3.0, I_0), sfi_mul(t0, sfi_add(sfi_mul(t0, sfi_add(sfi_times(5.0, d), sfi_times(3.0,
        sfi_mul(d_3, t0)))), sfi_times(8.0, zeta))))))), sfi_mul(A, sfi_add(sfi_add(sfi_mul(I_0, d), sfi_mul(t1,
        sfi_add(t1, sfi_times(3.0, zeta)))), sfi_times(2.0, sfi_square(zeta))))), sfi_div(sfi_mul(I_0, zeta),
        Omega));
}

/* A Omega by I; no less than it where cubic damping dissipates too.
   Equation from (23). Domain: I >= I_0. */
static inline sf_interval dissipation_intervals_velocity(sf_interval I_, sf_interval I_0, sf_interval zeta, sf_interval d)
{
    const sf_interval t0 = sfi_sub(I_, I_0);
    return sfi_div(t0, sfi_add(zeta, sfi_sqrt(sfi_add(sfi_mul(d, t0), sfi_square(zeta)))));
}

/* R x^2, D x^4, I x^3 and I_A x^3 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D.
   Equation from (30). Domain: x >= 0, A > 0. */
static inline void dissipation_intervals_turn_terms(sf_interval x, sf_interval A, sf_interval I_0, sf_interval I_0A, sf_interval zeta, sf_interval zeta_A, sf_interval d, sf_interval d_3, sf_interval h, sf_interval *out)
{
    const sf_interval x2 = sfi_square(x);
    const sf_interval A2 = sfi_square(A);
    const sf_interval A4 = sfi_square(A2);
    const sf_interval t0 = sfi_mul(A4, d_3);
    const sf_interval t1 = sfi_mul(A, zeta_A);
    const sf_interval A3 = sfi_mul(A, A2);
    const sf_interval t2 = sfi_mul(A3, d_3);
    const sf_interval t3 = sfi_times(4.0, zeta_A);
    const sf_interval t4 = sfi_times(2.0, sfi_mul(A, d));
    const sf_interval t5 = sfi_mul(A2, d);
    const sf_interval x3 = sfi_mul(x, x2);
    const sf_interval t6 = sfi_mul(A2, d_3);
    const sf_interval t7 = sfi_times(2.0, zeta);
    const sf_interval x4 = sfi_square(x2);
    const sf_interval x5 = sfi_mul(x, x4);
    const sf_interval A5 = sfi_mul(A, A4);
    out[0] = sfi_add(A, sfi_mul(h, x2));
    out[1] = sfi_add(sfi_add(sfi_add(sfi_add(sfi_add(sfi_times(9.0, sfi_mul(A5, sfi_square(d_3))), sfi_times(12.5,
        sfi_mul(sfi_mul(d, t0), x))), sfi_mul(x2, sfi_add(sfi_add(sfi_times(4.0, sfi_mul(A3, sfi_square(d))),
        sfi_mul(t0, t3)), sfi_times(16.0, sfi_mul(t2, zeta))))), sfi_mul(x3, sfi_add(sfi_add(sfi_add(sfi_times(3.0,
        sfi_mul(sfi_mul(A3, d), zeta_A)), sfi_times(4.5, sfi_mul(I_0, t6))), sfi_times(1.5, sfi_mul(I_0A, t2))),
        sfi_times(9.0, sfi_mul(t5, zeta))))), sfi_mul(x4, sfi_add(sfi_add(sfi_add(sfi_times(4.0, sfi_mul(A,
        sfi_square(zeta))), sfi_mul(sfi_mul(A2, t3), zeta)), sfi_mul(I_0, t4)), sfi_mul(I_0A, t5)))), sfi_mul(x5,
        sfi_add(sfi_add(sfi_mul(sfi_mul(A, I_0A), zeta), sfi_mul(I_0, t1)), sfi_mul(I_0, zeta))));
    out[2] = sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, t7), x2), sfi_mul(I_0, x3)), t2), sfi_mul(t5, x));
    out[3] = sfi_add(sfi_add(sfi_add(sfi_mul(I_0A, x3), sfi_mul(t4, x)), sfi_times(3.0, t6)), sfi_mul(x2,
        sfi_add(sfi_times(2.0, t1), t7)));
}

SF_FAMILY_END

#endif
