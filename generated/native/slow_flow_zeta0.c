/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene zeta = 0: loops for NumPy.

   Written by `make derive` from slow_flow_zeta0.h, the same functions for one number each; never edit. */

#include "slow_flow_zeta0.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBER(of, limit_envelope, 4) NUMBERS(of, detachment, 4, 3) NUMBER(of, undamped_Omega, 1) \
    NUMBERS(of, fold, 4, 2) NUMBER(of, undamped_level, 2) NUMBERS(of, undamped_rises, 3, 2) \
    NUMBERS(of, undamped, 5, 4)

KERNELS(SF_NUMBER, SF_NUMBERS, slow_flow_zeta0)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, slow_flow_zeta0)
};

const sf_module sf_module_slow_flow_zeta0 = {"slow_flow_zeta0", kernels, sizeof kernels / sizeof kernels[0]};
