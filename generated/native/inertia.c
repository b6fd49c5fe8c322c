/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance: loops for NumPy.

   Written by `make derive` from inertia.h, the same functions for one number each; never edit. */

#include "inertia.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBER(of, force, 2) NUMBERS(of, force_slopes, 2, 2) NUMBER(of, isolation, 4) NUMBER(of, level, 5) \
    NUMBER(of, F, 6) NUMBER(of, level_slope, 5) NUMBER(of, Omega_A, 6) NUMBERS(of, terms, 4, 3) NUMBER(of, least, 3) \
    NUMBER(of, least_Omega_A, 6) NUMBERS(of, peak, 7, 2) NUMBERS(of, isola, 7, 2) NUMBER(of, isola_apart, 7) \
    NUMBERS(of, fold_slopes, 5, 3) NUMBER(of, fold_force, 5) NUMBER(of, fold_level, 5) NUMBER(of, peak_share, 4) \
    NUMBER(of, Omega_of_share, 5) NUMBER(of, cusp_bend, 8) NUMBER(of, hessian, 7) NUMBERS(of, bound, 8, 4) \
    NUMBER(of, share, 3)

KERNELS(SF_NUMBER, SF_NUMBERS, inertia)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, inertia)
};

const sf_module sf_module_inertia = {"inertia", kernels, sizeof kernels / sizeof kernels[0]};
