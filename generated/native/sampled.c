/* The average of a force that is known by its values and those of its derivatives, u = A sine: loops for NumPy.

   Written by `make derive`; never edit.
   Input: sampled.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "sampled.h"

#include "kernels.h"

SF_TUPLE(, sampled_averaged_terms, 4, sampled_averaged_terms, X(0), X(1), X(2), X(3), X(4))
SF_TUPLE(, sampled_averaged_end, 3, sampled_averaged_end, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, sampled_intercept_terms, sampled_intercept_terms, X(0), X(1), X(2), X(3))
SF_SCALAR(, sampled_intercept_end, sampled_intercept_end, X(0), X(1), X(2), X(3))
SF_TUPLE(, sampled_harmonics_terms, 8, sampled_harmonics_terms, X(0), X(1), X(2), X(3), X(4))
SF_TUPLE(, sampled_harmonics_end, 6, sampled_harmonics_end, X(0), X(1), X(2), X(3), X(4))

static const sf_kernel kernels[] = {
    {"averaged_terms", 5, 4, SF_ONE(sampled_averaged_terms)},
    {"averaged_end", 5, 3, SF_ONE(sampled_averaged_end)},
    {"intercept_terms", 4, 1, SF_ONE(sampled_intercept_terms)},
    {"intercept_end", 4, 1, SF_ONE(sampled_intercept_end)},
    {"harmonics_terms", 5, 8, SF_ONE(sampled_harmonics_terms)},
    {"harmonics_end", 5, 6, SF_ONE(sampled_harmonics_end)},
};

const sf_module sf_module_sampled = {"sampled", kernels, sizeof kernels / sizeof kernels[0]};
