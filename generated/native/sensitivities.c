/* How answers move with the parameters: what the implicit function theorem asks for: loops for NumPy.

   Written by `make derive`; never edit.
   Input: sensitivities.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "sensitivities.h"

#include "kernels.h"

SF_TUPLE(, sensitivities_of_state, 2, sensitivities_of_state, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7), X(8),
    X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, sensitivities_by_force, 7, sensitivities_by_force, X(0), X(1))
SF_TUPLE(, sensitivities_by_inertia, 7, sensitivities_by_inertia, X(0), X(1))

static const sf_kernel kernels[] = {
    {"of_state", 21, 2, SF_ONE(sensitivities_of_state)},
    {"by_force", 2, 7, SF_ONE(sensitivities_by_force)},
    {"by_inertia", 2, 7, SF_ONE(sensitivities_by_inertia)},
};

const sf_module sf_module_sensitivities = {"sensitivities", kernels, sizeof kernels / sizeof kernels[0]};
