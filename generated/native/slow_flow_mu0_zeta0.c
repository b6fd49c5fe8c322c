/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0 and zeta = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow_mu0_zeta0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow_mu0_zeta0.h"

#include "kernels.h"

SF_LOOP(slow_flow_mu0_zeta0_detachment_loop, 2,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
    slow_flow_mu0_zeta0_detachment(A, m, zeta, h, values);
)

static const sf_kernel kernels[] = {
    {"detachment", 4, 2, 1, NULL, SF_ONE(slow_flow_mu0_zeta0_detachment_loop)},
};

const sf_module sf_module_slow_flow_mu0_zeta0 = {"slow_flow_mu0_zeta0", kernels, sizeof kernels / sizeof kernels[0]};
