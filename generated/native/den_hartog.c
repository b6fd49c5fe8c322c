/* Den Hartog's exact solution of the linear oscillator with dry friction, without stops: loops for NumPy.

   Written by `make derive`; never edit.
   Input: den_hartog.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "den_hartog.h"

#include "kernels.h"

SF_SCALAR(, den_hartog_V, den_hartog_V, X(0))
SF_SCALAR(, den_hartog_U, den_hartog_U, X(0))
SF_SCALAR(, den_hartog_S_ratio, den_hartog_S_ratio, X(0), X(1))
SF_SCALAR(, den_hartog_amplitude, den_hartog_amplitude, X(0), X(1), X(2))
SF_SCALAR(, den_hartog_bound, den_hartog_bound, X(0), X(1), X(2))
SF_SCALAR(, den_hartog_motion, den_hartog_motion, X(0), X(1), X(2), X(3))

static const sf_kernel kernels[] = {
    {"V", 1, 1, SF_ONE(den_hartog_V)},
    {"U", 1, 1, SF_ONE(den_hartog_U)},
    {"S_ratio", 2, 1, SF_ONE(den_hartog_S_ratio)},
    {"amplitude", 3, 1, SF_ONE(den_hartog_amplitude)},
    {"bound", 3, 1, SF_ONE(den_hartog_bound)},
    {"motion", 4, 1, SF_ONE(den_hartog_motion)},
};

const sf_module sf_module_den_hartog = {"den_hartog", kernels, sizeof kernels / sizeof kernels[0]};
