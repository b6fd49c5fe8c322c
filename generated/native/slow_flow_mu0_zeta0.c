/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0 and zeta = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow_mu0_zeta0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow_mu0_zeta0.h"

#include "kernels.h"

SF_TUPLE(, slow_flow_mu0_zeta0_detachment, 2, slow_flow_mu0_zeta0_detachment, X(0), X(1), X(2), X(3))

static const sf_kernel kernels[] = {
    {"detachment", 4, 2, SF_ONE(slow_flow_mu0_zeta0_detachment)},
};

const sf_module sf_module_slow_flow_mu0_zeta0 = {"slow_flow_mu0_zeta0", kernels, sizeof kernels / sizeof kernels[0]};
