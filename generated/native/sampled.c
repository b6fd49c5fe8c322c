/* The average of a force that is known by its values and those of its derivatives, u = A sine: loops for NumPy.

   Written by `make derive` from sampled.h, the same functions for one number each; never edit. */

#include "sampled.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, averaged_terms, 5, 4) NUMBERS(of, averaged_end, 5, 3) NUMBER(of, intercept_terms, 4) \
    NUMBER(of, intercept_end, 4) NUMBERS(of, harmonics_terms, 5, 8) NUMBERS(of, harmonics_end, 5, 6) \
    NUMBERS(of, bent_terms, 3, 2) NUMBER(of, bent_end_0, 6) NUMBER(of, bent_end_1, 5) NUMBER(of, bent_end_2, 4) \
    NUMBER(of, bent_end_3, 3)

KERNELS(SF_NUMBER, SF_NUMBERS, sampled)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, sampled)
};

const sf_module sf_module_sampled = {"sampled", kernels, sizeof kernels / sizeof kernels[0]};
