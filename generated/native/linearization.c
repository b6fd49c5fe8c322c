/* Stationary random vibration by statistical linearization: loops for NumPy.

   Written by `make derive` from linearization.h, the same functions for one number each; never edit. */

#include "linearization.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, steepest, 1, 3) NUMBERS(of, resonance, 9, 6)

KERNELS(SF_NUMBER, SF_NUMBERS, linearization)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, linearization)
};

const sf_module sf_module_linearization = {"linearization", kernels, sizeof kernels / sizeof kernels[0]};
