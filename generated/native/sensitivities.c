/* How answers move with the parameters: what the implicit function theorem asks for: loops for NumPy.

   Written by `make derive` from sensitivities.h, the same functions for one number each; never edit. */

#include "sensitivities.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, right, 27, 8) NUMBERS(of, of_state, 21, 2) NUMBERS(of, by_force, 2, 7) NUMBERS(of, by_inertia, 2, 7)

KERNELS(SF_NUMBER, SF_NUMBERS, sensitivities)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, sensitivities)
};

const sf_module sf_module_sensitivities = {"sensitivities", kernels, sizeof kernels / sizeof kernels[0]};
