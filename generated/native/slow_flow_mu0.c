/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow_mu0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow_mu0.h"

#include "kernels.h"

SF_TUPLE(, slow_flow_mu0_response_quartic, 4, slow_flow_mu0_response_quartic, X(0), X(1), X(2), X(3), X(4))
SF_TUPLE(, slow_flow_mu0_detachment, 3, slow_flow_mu0_detachment, X(0), X(1), X(2), X(3))
SF_TUPLE(, slow_flow_mu0_fold, 3, slow_flow_mu0_fold, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7))
SF_TUPLE(, slow_flow_mu0_isola, 2, slow_flow_mu0_isola, X(0), X(1), X(2), X(3), X(4), X(5))

static const sf_kernel kernels[] = {
    {"response_quartic", 5, 4, SF_ONE(slow_flow_mu0_response_quartic)},
    {"detachment", 4, 3, SF_ONE(slow_flow_mu0_detachment)},
    {"fold", 8, 3, SF_ONE(slow_flow_mu0_fold)},
    {"isola", 6, 2, SF_ONE(slow_flow_mu0_isola)},
};

const sf_module sf_module_slow_flow_mu0 = {"slow_flow_mu0", kernels, sizeof kernels / sizeof kernels[0]};
