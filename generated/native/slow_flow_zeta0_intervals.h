/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene zeta = 0: on whole intervals.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
   derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

   Each output holds every value that the function of the same name takes on the arguments; `out` takes the outputs.
   Equations and domains that are not stated here are those of slow_flow_zeta0.h. */

#ifndef SLOW_FLOW_ZETA0_INTERVALS_H
#define SLOW_FLOW_ZETA0_INTERVALS_H

#include "interval.h"
#include "inline.h"
#include "arithmetic_intervals.h"

SF_FAMILY_BEGIN

/* Omega of the folds. */
static inline sf_interval slow_flow_zeta0_intervals_undamped_Omega(sf_interval h_A) {
    return SQRT(NEG(h_A));
}

/* Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A. */
static inline void slow_flow_zeta0_intervals_fold(sf_interval F_0, sf_interval m, sf_interval k, sf_interval k_A, sf_interval *out) {
    const sf_interval excess = MUL(SUB(F_0, m), ADD(F_0, m));
    const sf_interval least = SQRT(excess);
    out[0] = MUL(SUB(k, least), ADD(k, least));
    out[1] = TIMES(2.0, MUL(k, k_A));
}

/* F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.
   Equation (34). Domain: Omega > 0, A > 0. */
static inline void slow_flow_zeta0_intervals_F_Omega_reduced(sf_interval Omega, sf_interval A, sf_interval m, sf_interval zeta, sf_interval h, sf_interval *out) {
    out[0] = ADD(MUL(A, SQUARE(Omega)), h);
    out[1] = TIMES(2.0, MUL(A, Omega));
}

SF_FAMILY_END

#include "arithmetic_end.h"
#endif
