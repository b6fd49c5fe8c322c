/* The equation of motion of any mechanism, in the values of its force: loops for NumPy.

   Written by `make derive`; never edit.
   Input: motion.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "motion.h"

#include "kernels.h"

SF_SCALAR(, motion_turned, motion_turned, X(0), X(1))

static const sf_kernel kernels[] = {
    {"turned", 2, 1, SF_ONE(motion_turned)},
};

const sf_module sf_module_motion = {"motion", kernels, sizeof kernels / sizeof kernels[0]};
