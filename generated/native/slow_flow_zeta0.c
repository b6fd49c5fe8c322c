/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene zeta = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow_zeta0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow_zeta0.h"

#include "kernels.h"

SF_SCALAR(, slow_flow_zeta0_limit_envelope, slow_flow_zeta0_limit_envelope, X(0), X(1), X(2), X(3))
SF_TUPLE(, slow_flow_zeta0_detachment, 3, slow_flow_zeta0_detachment, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_zeta0_undamped_Omega, slow_flow_zeta0_undamped_Omega, X(0))
SF_TUPLE(, slow_flow_zeta0_fold, 2, slow_flow_zeta0_fold, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_zeta0_undamped_level, slow_flow_zeta0_undamped_level, X(0), X(1))
SF_TUPLE(, slow_flow_zeta0_undamped_rises, 2, slow_flow_zeta0_undamped_rises, X(0), X(1), X(2))
SF_TUPLE(, slow_flow_zeta0_undamped, 4, slow_flow_zeta0_undamped, X(0), X(1), X(2), X(3), X(4))

static const sf_kernel kernels[] = {
    {"limit_envelope", 4, 1, SF_ONE(slow_flow_zeta0_limit_envelope)},
    {"detachment", 4, 3, SF_ONE(slow_flow_zeta0_detachment)},
    {"undamped_Omega", 1, 1, SF_ONE(slow_flow_zeta0_undamped_Omega)},
    {"fold", 4, 2, SF_ONE(slow_flow_zeta0_fold)},
    {"undamped_level", 2, 1, SF_ONE(slow_flow_zeta0_undamped_level)},
    {"undamped_rises", 3, 2, SF_ONE(slow_flow_zeta0_undamped_rises)},
    {"undamped", 5, 4, SF_ONE(slow_flow_zeta0_undamped)},
};

const sf_module sf_module_slow_flow_zeta0 = {"slow_flow_zeta0", kernels, sizeof kernels / sizeof kernels[0]};
