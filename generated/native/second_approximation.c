/* Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5: loops for NumPy.

   Written by `make derive` from second_approximation.h, the same functions for one number each; never edit. */

#include "second_approximation.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, response, 14, 9) NUMBERS(of, detachment, 13, 3) NUMBERS(of, detachment_by_inertia, 13, 3) \
    NUMBERS(of, folds, 17, 3) NUMBERS(of, components, 6, 7) NUMBERS(of, wave, 9, 2)

KERNELS(SF_NUMBER, SF_NUMBERS, second_approximation)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, second_approximation)
};

const sf_module sf_module_second_approximation = {"second_approximation", kernels, sizeof kernels / sizeof kernels[0]};
