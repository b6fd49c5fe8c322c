/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0 and zeta = 0.

   Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
   derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
   derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

   What arguments and comments mean is in inline.h. */

#ifndef SLOW_FLOW_MU0_ZETA0_H
#define SLOW_FLOW_MU0_ZETA0_H

#include <math.h>

#include "inline.h"

SF_FAMILY_BEGIN

/* Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr.
   Equation (34). Domain: A > 0. Operations: 1. Error / u (1 + kappa): proved 0.34, 0.0. */
#define SLOW_FLOW_MU0_ZETA0_DETACHMENT_COUNT 2
SF_KERNEL void slow_flow_mu0_zeta0_detachment(double A, double m, double zeta, double h, double *out) {
    out[0] = -h * h;
    out[1] = 1.0;
}

SF_FAMILY_END

#endif
