/* Den Hartog's exact solution of the linear oscillator with dry friction, without stops: loops for NumPy.

   Written by `make derive` from den_hartog.h, the same functions for one number each; never edit. */

#include "den_hartog.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBER(of, V, 1) NUMBER(of, U, 1) NUMBER(of, S_ratio, 2) NUMBER(of, amplitude, 3) NUMBER(of, bound, 3) \
    NUMBER(of, motion, 4)

KERNELS(SF_NUMBER, SF_NUMBERS, den_hartog)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, den_hartog)
};

const sf_module sf_module_den_hartog = {"den_hartog", kernels, sizeof kernels / sizeof kernels[0]};
