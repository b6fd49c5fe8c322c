/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0: on whole intervals.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
   derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of slow_flow_mu0.h. */

#ifndef SLOW_FLOW_MU0_INTERVALS_H
#define SLOW_FLOW_MU0_INTERVALS_H

#include "interval.h"
#include "inline.h"
#include "arithmetic_intervals.h"

SF_FAMILY_BEGIN

/* Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A. */
static inline void slow_flow_mu0_intervals_isola(sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval h_A, sf_interval h_AA, sf_interval *out) {
    const sf_interval t0 = TIMES(2.0, SQUARE(zeta));
    const sf_interval bracket = ADD(MUL(A, ADD(h_A, t0)), h);
    const sf_interval bracket_A = ADD(ADD(MUL(A, h_AA), TIMES(2.0, h_A)), t0);
    out[0] = bracket;
    out[1] = bracket_A;
}

/* F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.
   Equation (34). Domain: Omega > 0, A > 0. */
static inline void slow_flow_mu0_intervals_F_Omega_reduced(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval *out) {
    const sf_interval t0 = TIMES(2.0, A);
    const sf_interval p = ADD(h, MUL(t0, SQUARE(zeta)));
    out[0] = ADD(MUL(A, SQUARE(Omega)), p);
    out[1] = MUL(Omega, t0);
}

SF_FAMILY_END

#include "arithmetic_end.h"
#endif
