/* Motions off the centre, u = B + A cos psi, by the means of the force and its derivatives over a cycle: loops for NumPy.

   Written by `make derive` from off_centre.h, the same functions for one number each; never edit. */

#include "off_centre.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, ended_along, 6, 2) NUMBERS(of, begin, 4, 4) NUMBERS(of, up, 8, 2) NUMBERS(of, down, 8, 2)

KERNELS(SF_NUMBER, SF_NUMBERS, off_centre)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, off_centre)
};

const sf_module sf_module_off_centre = {"off_centre", kernels, sizeof kernels / sizeof kernels[0]};
