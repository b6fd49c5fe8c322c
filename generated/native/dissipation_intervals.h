/* Structural and quadratic damping, and dry friction of what is attached: on whole intervals.

   Written by `make derive`; never edit.
   Input: none but the equation of motion in derivations/averaging.py, derivations/slow_flow.py, derivations/dissipation.py, derivations/gradients.py
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef DISSIPATION_INTERVALS_H
#define DISSIPATION_INTERVALS_H

#include "interval.h"

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

/* The size of R where F = 0.
   Equation (24). Domain: Omega >= 0, A > 0. */
static inline sf_interval dissipation_intervals_R_of_response(sf_interval F_0, sf_interval I_)
{
    return sfi_sqrt(sfi_sub(sfi_square(F_0), sfi_square(I_)));
}

/* F and F_A; derivatives by A and by Omega of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_folds(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0A, sf_interval I_0AA, sf_interval zeta, sf_interval d, sf_interval h_A, sf_interval h_AA, sf_interval R, sf_interval I_, sf_interval *out)
{
    const sf_interval t0 = sfi_square(Omega);
    const sf_interval t1 = sfi_add(h_A, t0);
    const sf_interval t2 = sfi_times(2.0, Omega);
    const sf_interval t3 = sfi_mul(A, d);
    const sf_interval t4 = sfi_times(2.0, t0);
    const sf_interval t5 = sfi_add(sfi_add(I_0A, sfi_mul(t2, zeta)), sfi_mul(t3, t4));
    const sf_interval t6 = sfi_times(2.0, sfi_add(sfi_mul(I_, t5), sfi_mul(R, t1)));
    const sf_interval t7 = sfi_mul(Omega, R);
    const sf_interval t8 = sfi_mul(A, Omega);
    const sf_interval t9 = sfi_add(sfi_mul(d, t8), zeta);
    out[0] = sfi_add(sfi_square(R), sfi_mul(sfi_add(sfi_neg(F_0), I_), sfi_add(F_0, I_)));
    out[1] = t6;
    out[2] = t6;
    out[3] = sfi_times(4.0, sfi_mul(A, sfi_add(sfi_mul(I_, t9), t7)));
    out[4] = sfi_times(2.0, sfi_add(sfi_add(sfi_add(sfi_add(sfi_mul(I_, I_0AA), sfi_mul(sfi_mul(I_, d), t4)),
        sfi_mul(R, h_AA)), sfi_square(t1)), sfi_square(t5)));
    out[5] = sfi_times(4.0, sfi_add(sfi_add(sfi_add(sfi_mul(sfi_mul(A, t5), t9), sfi_mul(I_, sfi_add(sfi_mul(t2,
        t3), zeta))), sfi_mul(t1, t8)), t7));
}

/* F and F_A/2, in A and R; derivatives by the one and by the other of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_folds_in_R(sf_interval Omega, sf_interval A, sf_interval F_0, sf_interval I_0AA, sf_interval zeta, sf_interval d, sf_interval h_AA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
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

/* F and F_A/2 by inertia over Omega^4, x = 1/Omega, in A and R; derivatives by the one and by the other of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_folds_far(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
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

/* The same in A and x; derivatives by the one and by the other of the first, then of the second.
   Equation from (24), (30). Domain: Omega > 0, A > 0. */
static inline void dissipation_intervals_folds_far_in_x(sf_interval x, sf_interval A, sf_interval F_0, sf_interval I_0, sf_interval I_0A, sf_interval I_0AA, sf_interval zeta, sf_interval d, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval R, sf_interval I_, sf_interval R_A, sf_interval I_A, sf_interval *out)
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

/* A Omega by I.
   Equation from (23). Domain: I >= I_0. */
static inline sf_interval dissipation_intervals_velocity(sf_interval I_, sf_interval I_0, sf_interval zeta, sf_interval d)
{
    const sf_interval t0 = sfi_sub(I_, I_0);
    return sfi_div(t0, sfi_add(zeta, sfi_sqrt(sfi_add(sfi_mul(d, t0), sfi_square(zeta)))));
}

#endif
