/* The quartics whose roots are the frequencies at an amplitude: F of the response, F_A/2 of the folds: loops for NumPy.

   Written by `make derive`; never edit.
   Input: frequencies.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "frequencies.h"

#include "kernels.h"

SF_TUPLE(, frequencies_response, 2, frequencies_response, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, frequencies_response_at_0, 2, frequencies_response_at_0, X(0), X(1), X(2))
SF_TUPLE(, frequencies_fold, 2, frequencies_fold, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, frequencies_fold_at_0, frequencies_fold_at_0, X(0), X(1))
SF_SCALAR(, frequencies_cubic, frequencies_cubic, X(0), X(1), X(2), X(3))
SF_SCALAR(, frequencies_cubic_slope, frequencies_cubic_slope, X(0), X(1), X(2))
SF_TUPLE(, frequencies_rise, 2, frequencies_rise, X(0), X(1), X(2), X(3))
SF_TUPLE(, frequencies_response_fine, 2, frequencies_response_fine, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, frequencies_response_beside, 2, frequencies_response_beside, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_TUPLE(, frequencies_response_derivative, 5, frequencies_response_derivative, X(0), X(1), X(2), X(3))
SF_SCALAR(, frequencies_response_exactly_at_0, frequencies_response_exactly_at_0, X(0), X(1), X(2))
SF_TUPLE(, frequencies_fold_fine, 2, frequencies_fold_fine, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, frequencies_fold_beside, 2, frequencies_fold_beside, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_TUPLE(, frequencies_fold_derivative, 5, frequencies_fold_derivative, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, frequencies_cubic_fine, frequencies_cubic_fine, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, frequencies_discriminant, 2, frequencies_discriminant, X(0), X(1), X(2), X(3), X(4))

static const sf_kernel kernels[] = {
    {"response", 6, 2, SF_ONE(frequencies_response)},
    {"response_at_0", 3, 2, SF_ONE(frequencies_response_at_0)},
    {"fold", 6, 2, SF_ONE(frequencies_fold)},
    {"fold_at_0", 2, 1, SF_ONE(frequencies_fold_at_0)},
    {"cubic", 4, 1, SF_ONE(frequencies_cubic)},
    {"cubic_slope", 3, 1, SF_ONE(frequencies_cubic_slope)},
    {"rise", 4, 2, SF_ONE(frequencies_rise)},
    {"response_fine", 6, 2, SF_ONE(frequencies_response_fine)},
    {"response_beside", 7, 2, SF_ONE(frequencies_response_beside)},
    {"response_derivative", 4, 5, SF_ONE(frequencies_response_derivative)},
    {"response_exactly_at_0", 3, 1, SF_ONE(frequencies_response_exactly_at_0)},
    {"fold_fine", 6, 2, SF_ONE(frequencies_fold_fine)},
    {"fold_beside", 7, 2, SF_ONE(frequencies_fold_beside)},
    {"fold_derivative", 5, 5, SF_ONE(frequencies_fold_derivative)},
    {"cubic_fine", 6, 1, SF_ONE(frequencies_cubic_fine)},
    {"discriminant", 5, 2, SF_ONE(frequencies_discriminant)},
};

const sf_module sf_module_frequencies = {"frequencies", kernels, sizeof kernels / sizeof kernels[0]};
