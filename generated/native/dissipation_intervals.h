/* Structural and quadratic damping, and dry friction of what is attached: on whole intervals.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/extensions/dissipation.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs. */

#ifndef DISSIPATION_INTERVALS_H
#define DISSIPATION_INTERVALS_H

#include "interval.h"
#include "inline.h"
#include "arithmetic_intervals.h"
#define OF(name) dissipation_intervals_##name
#include "dissipation_generic.h"

/* d2I/dA2.
   Equation (23). Domain: Omega > 0, A > 0. */
static inline sf_interval dissipation_intervals_I_AA(sf_interval Omega, sf_interval A, sf_interval I_0AA, sf_interval zeta_A, sf_interval zeta_AA, sf_interval d, sf_interval d_3) {
    const sf_interval Omega2 = SQUARE(Omega);
    const sf_interval Omega3 = MUL(Omega, Omega2);
    return ADD(ADD(ADD(ADD(MUL(MUL(TIMES(2.0, A), Omega), zeta_AA), MUL(MUL(TIMES(6.0, A), Omega3), d_3)),
        I_0AA), MUL(TIMES(4.0, Omega), zeta_A)), MUL(TIMES(2.0, Omega2), d));
}

/* R x^2, D x^4, I x^3 and I_A x^3 at x = 1/Omega, where F_AOmega/(4 Omega) = R + A R_A + D.
   Equation from (30). Domain: x >= 0, A > 0. */
static inline void dissipation_intervals_turn_terms(sf_interval x, sf_interval A, sf_interval I_0, sf_interval I_0A, sf_interval zeta, sf_interval zeta_A, sf_interval d, sf_interval d_3, sf_interval h, sf_interval *out) {
    const sf_interval x2 = SQUARE(x);
    const sf_interval A2 = SQUARE(A);
    const sf_interval A4 = SQUARE(A2);
    const sf_interval t0 = MUL(A4, d_3);
    const sf_interval t1 = MUL(A, zeta_A);
    const sf_interval A3 = MUL(A, A2);
    const sf_interval t2 = MUL(A3, d_3);
    const sf_interval t3 = TIMES(4.0, zeta_A);
    const sf_interval t4 = MUL(TIMES(2.0, A), d);
    const sf_interval t5 = MUL(A2, d);
    const sf_interval x3 = MUL(x, x2);
    const sf_interval t6 = MUL(A2, d_3);
    const sf_interval t7 = TIMES(2.0, zeta);
    const sf_interval x4 = SQUARE(x2);
    const sf_interval x5 = MUL(x, x4);
    const sf_interval A5 = MUL(A, A4);
    out[0] = ADD(A, MUL(h, x2));
    out[1] = ADD(ADD(ADD(ADD(ADD(BY_SQUARE(TIMES(9.0, A5), d_3), MUL(MUL(TIMES(12.5, d), t0), x)), MUL(x2,
        ADD(ADD(BY_SQUARE(TIMES(4.0, A3), d), MUL(t0, t3)), MUL(TIMES(16.0, t2), zeta)))), MUL(x3,
        ADD(ADD(ADD(MUL(MUL(TIMES(3.0, A3), d), zeta_A), MUL(TIMES(4.5, I_0), t6)), MUL(TIMES(1.5, I_0A), t2)),
        MUL(TIMES(9.0, t5), zeta)))), MUL(x4, ADD(ADD(ADD(BY_SQUARE(TIMES(4.0, A), zeta), MUL(MUL(A2, t3), zeta)),
        MUL(I_0, t4)), MUL(I_0A, t5)))), MUL(x5, ADD(ADD(MUL(MUL(A, I_0A), zeta), MUL(I_0, t1)), MUL(I_0, zeta))));
    out[2] = ADD(ADD(ADD(MUL(MUL(A, t7), x2), MUL(I_0, x3)), t2), MUL(t5, x));
    out[3] = ADD(ADD(ADD(MUL(I_0A, x3), MUL(t4, x)), TIMES(3.0, t6)), MUL(x2, ADD(TIMES(2.0, t1), t7)));
}

/* I_0 - A I_0A: friction acts throughout.
   Equation from (19). Domain: A > 0. */
static inline sf_interval dissipation_intervals_rest_intercept(sf_interval m) {
    return m;
}

/* The same where friction acts for |u| < u_cr only.
   Equation from (19). Domain: A >= u_cr > 0. */
static inline sf_interval dissipation_intervals_released_intercept(sf_interval A, sf_interval m, sf_interval u_cr) {
    return DIV(MUL(TIMES(2.0, m), u_cr), A);
}

/* I - A I_A, by that of I_0.
   Equation from (23). Domain: Omega >= 0, A > 0. */
static inline sf_interval dissipation_intervals_sine_intercept(sf_interval Omega, sf_interval A, sf_interval level, sf_interval zeta_A, sf_interval d, sf_interval d_3) {
    const sf_interval A2 = SQUARE(A);
    const sf_interval Omega2 = SQUARE(Omega);
    const sf_interval A3 = MUL(A, A2);
    const sf_interval Omega3 = MUL(Omega, Omega2);
    return ADD(SUB(SUB(NEG(MUL(MUL(TIMES(2.0, A2), Omega), zeta_A)), MUL(MUL(A2, Omega2), d)),
        MUL(MUL(TIMES(2.0, A3), Omega3), d_3)), level);
}

/* The same over Omega^2, at x = 1/Omega.
   Equation from (23). Domain: x >= 0, A > 0. */
static inline sf_interval dissipation_intervals_sine_intercept_far(sf_interval x, sf_interval A, sf_interval level, sf_interval zeta_A, sf_interval d) {
    const sf_interval t0 = SQUARE(A);
    return SUB(ADD(NEG(MUL(d, t0)), BY_SQUARE(level, x)), MUL(MUL(TIMES(2.0, t0), x), zeta_A));
}

/* d2I/dA2 over it.
   Equation (23). Domain: x >= 0, A > 0. */
static inline sf_interval dissipation_intervals_I_AA_far(sf_interval x, sf_interval A, sf_interval I_0AA, sf_interval zeta_A, sf_interval zeta_AA, sf_interval d) {
    return ADD(ADD(ADD(MUL(MUL(TIMES(2.0, A), x), zeta_AA), BY_SQUARE(I_0AA, x)), TIMES(2.0, d)), MUL(TIMES(4.0,
        x), zeta_A));
}

/* R where F_Omega = 0, by I at Omega = 0.
   Equation from (24). Domain: Omega > 0, A > 0. */
static inline sf_interval dissipation_intervals_R_of_peak_by_rest(sf_interval Omega, sf_interval A, sf_interval I_0, sf_interval zeta, sf_interval d, sf_interval d_3) {
    const sf_interval t0 = MUL(A, Omega);
    const sf_interval t1 = MUL(d, t0);
    return SUB(SUB(NEG(MUL(MUL(MUL(BY_SQUARE(POINT(0.5), A), Omega), d_3), ADD(TIMES(3.0, I_0), MUL(t0,
        ADD(MUL(t0, ADD(TIMES(5.0, d), MUL(TIMES(3.0, d_3), t0))), TIMES(8.0, zeta)))))), MUL(A, ADD(ADD(MUL(I_0,
        d), MUL(t1, ADD(t1, TIMES(3.0, zeta)))), BY_SQUARE(POINT(2.0), zeta)))), DIV(MUL(I_0, zeta), Omega));
}

/* A Omega by I; no less than it where cubic damping dissipates too.
   Equation from (23). Domain: I >= I_0. */
static inline sf_interval dissipation_intervals_velocity(sf_interval I_, sf_interval I_0, sf_interval zeta, sf_interval d) {
    const sf_interval t0 = SUB(I_, I_0);
    return DIV(t0, ADD(zeta, SQRT(ADD(MUL(d, t0), SQUARE(zeta)))));
}

#include "arithmetic_end.h"
#endif
