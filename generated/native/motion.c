/* The equation of motion of any mechanism, in the values of its force: loops for NumPy.

   Written by `make derive` from motion.h, the same functions for one number each; never edit. */

#include "motion.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBER(of, turned, 2)

KERNELS(SF_NUMBER, SF_NUMBERS, motion)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, motion)
};

const sf_module sf_module_motion = {"motion", kernels, sizeof kernels / sizeof kernels[0]};
