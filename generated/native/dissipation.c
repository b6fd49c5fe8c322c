/* Structural and quadratic damping, and dry friction of what is attached: loops for NumPy.

   Written by `make derive` from dissipation.h, the same functions for one number each; never edit. */

#include "dissipation.h"

#include "kernels.h"

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBER(of, restoring, 3) NUMBERS(of, released_moves, 3, 9) NUMBERS(of, viscous_moves, 1, 3) \
    NUMBERS(of, far, 9, 4) NUMBER(of, F_OmegaOmega, 7) NUMBER(of, F_AOmegaOmega, 10) NUMBER(of, Omega_A, 10) \
    NUMBER(of, Omega_A_by_inertia, 10) NUMBER(of, cusp_bend, 16) NUMBERS(of, isola_bend, 13, 2) \
    NUMBERS(of, static, 5, 4) NUMBERS(of, response_polynomial, 6, 7) NUMBERS(of, fold_polynomial, 9, 7) \
    NUMBER(of, turn_share, 7) NUMBER(of, F_A_halved, 4) NUMBER(of, R_of_response, 2) NUMBER(of, R_of_peak, 6) \
    NUMBERS(of, R_where_stationary, 5, 3) NUMBER(of, cusp_bend_by_inertia, 16) \
    NUMBERS(of, isola_bend_by_inertia, 13, 2) NUMBERS(of, structural_bound, 5, 2) NUMBER(of, quadratic_bound, 2) \
    NUMBERS(of, folds_by_R, 21, 6) NUMBERS(of, peaks_by_R, 21, 6) NUMBERS(of, cusps_by_R, 21, 6) \
    NUMBERS(of, isolas_by_R, 21, 6) NUMBERS(of, turns_by_R, 21, 6) NUMBERS(of, folds_by_Omega, 21, 6) \
    NUMBERS(of, peaks_by_Omega, 21, 6) NUMBERS(of, cusps_by_Omega, 21, 6) NUMBERS(of, isolas_by_Omega, 21, 6) \
    NUMBERS(of, turns_by_Omega, 21, 6) NUMBERS(of, folds_far_by_R, 21, 6) NUMBERS(of, peaks_far_by_R, 21, 6) \
    NUMBERS(of, cusps_far_by_R, 21, 6) NUMBERS(of, isolas_far_by_R, 21, 6) NUMBERS(of, folds_far_by_x, 21, 6) \
    NUMBERS(of, peaks_far_by_x, 21, 6) NUMBERS(of, cusps_far_by_x, 21, 6) NUMBERS(of, isolas_far_by_x, 21, 6)

KERNELS(SF_NUMBER, SF_NUMBERS, dissipation)

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, dissipation)
};

const sf_module sf_module_dissipation = {"dissipation", kernels, sizeof kernels / sizeof kernels[0]};
