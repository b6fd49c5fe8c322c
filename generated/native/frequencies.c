/* The quartics whose roots are the frequencies at an amplitude: F of the response, F_A/2 of the folds: loops for NumPy.

   Written by `make derive` from frequencies.h, the same functions for one number each; never edit. */

#include "frequencies.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, response, 6, 2) NUMBERS(of, response_at_0, 3, 2) NUMBERS(of, fold, 6, 2) NUMBER(of, fold_at_0, 2) \
    NUMBER(of, cubic, 4) NUMBER(of, cubic_slope, 3) NUMBERS(of, rise, 4, 2) NUMBERS(of, response_fine, 6, 2) \
    NUMBERS(of, response_beside, 7, 2) NUMBERS(of, response_derivative, 4, 5) NUMBER(of, response_exactly_at_0, 3) \
    NUMBERS(of, fold_fine, 6, 2) NUMBERS(of, fold_beside, 7, 2) NUMBERS(of, fold_derivative, 5, 5) \
    NUMBER(of, cubic_fine, 6) NUMBERS(of, discriminant, 5, 2)

KERNELS(SF_NUMBER, SF_NUMBERS, frequencies)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, frequencies)
};

const sf_module sf_module_frequencies = {"frequencies", kernels, sizeof kernels / sizeof kernels[0]};
