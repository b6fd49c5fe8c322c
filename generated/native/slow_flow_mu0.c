/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0: loops for NumPy.

   Written by `make derive` from slow_flow_mu0.h, the same functions for one number each; never edit. */

#include "slow_flow_mu0.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBERS(of, response_quartic, 5, 4) NUMBERS(of, detachment, 4, 3) NUMBERS(of, fold, 8, 3) \
    NUMBERS(of, isola, 6, 2)

KERNELS(SF_NUMBER, SF_NUMBERS, slow_flow_mu0)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, slow_flow_mu0)
};

const sf_module sf_module_slow_flow_mu0 = {"slow_flow_mu0", kernels, sizeof kernels / sizeof kernels[0]};
