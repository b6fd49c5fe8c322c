/* Stationary random vibration by statistical linearization: loops for NumPy.

   Written by `make derive`; never edit.
   Input: linearization.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "linearization.h"

#include "kernels.h"

SF_TUPLE(, linearization_steepest, 3, linearization_steepest, X(0))

static const sf_kernel kernels[] = {
    {"steepest", 1, 3, SF_ONE(linearization_steepest)},
};

const sf_module sf_module_linearization = {"linearization", kernels, sizeof kernels / sizeof kernels[0]};
