/* Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5: loops for NumPy.

   Written by `make derive`; never edit.
   Input: second_approximation.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "second_approximation.h"

#include "kernels.h"

SF_TUPLE(, second_approximation_response, 9, second_approximation_response, X(0), X(1), X(2), X(3), X(4), X(5),
    X(6), X(7), X(8), X(9), X(10), X(11), X(12), X(13))
SF_TUPLE(, second_approximation_detachment, 3, second_approximation_detachment, X(0), X(1), X(2), X(3), X(4), X(5),
    X(6), X(7), X(8), X(9), X(10), X(11), X(12))
SF_TUPLE(, second_approximation_detachment_by_inertia, 3, second_approximation_detachment_by_inertia, X(0), X(1),
    X(2), X(3), X(4), X(5), X(6), X(7), X(8), X(9), X(10), X(11), X(12))
SF_TUPLE(, second_approximation_folds, 3, second_approximation_folds, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16))
SF_TUPLE(, second_approximation_components, 7, second_approximation_components, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, second_approximation_wave, 2, second_approximation_wave, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7),
    X(8))

static const sf_kernel kernels[] = {
    {"response", 14, 9, SF_ONE(second_approximation_response)},
    {"detachment", 13, 3, SF_ONE(second_approximation_detachment)},
    {"detachment_by_inertia", 13, 3, SF_ONE(second_approximation_detachment_by_inertia)},
    {"folds", 17, 3, SF_ONE(second_approximation_folds)},
    {"components", 6, 7, SF_ONE(second_approximation_components)},
    {"wave", 9, 2, SF_ONE(second_approximation_wave)},
};

const sf_module sf_module_second_approximation = {"second_approximation", kernels, sizeof kernels / sizeof kernels[0]};
