/* Structural and quadratic damping, and dry friction of what is attached: loops for NumPy.

   Written by `make derive`; never edit.
   Input: dissipation.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "dissipation.h"

#include "kernels.h"

SF_SCALAR(, dissipation_restoring, dissipation_restoring, X(0), X(1), X(2))
SF_TUPLE(, dissipation_released_moves, 9, dissipation_released_moves, X(0), X(1), X(2))
SF_TUPLE(, dissipation_viscous_moves, 3, dissipation_viscous_moves, X(0))
SF_TUPLE(, dissipation_far, 4, dissipation_far, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7), X(8))
SF_SCALAR(, dissipation_F_AOmegaOmega, dissipation_F_AOmegaOmega, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7),
    X(8), X(9))
SF_SCALAR(, dissipation_Omega_A, dissipation_Omega_A, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7), X(8), X(9))
SF_SCALAR(, dissipation_Omega_A_by_inertia, dissipation_Omega_A_by_inertia, X(0), X(1), X(2), X(3), X(4), X(5),
    X(6), X(7), X(8), X(9))
SF_TUPLE(, dissipation_response_polynomial, 7, dissipation_response_polynomial, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, dissipation_fold_polynomial, 7, dissipation_fold_polynomial, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8))
SF_SCALAR(, dissipation_F_A_halved, dissipation_F_A_halved, X(0), X(1), X(2), X(3))
SF_SCALAR(, dissipation_R_of_peak, dissipation_R_of_peak, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, dissipation_least_scaled, 2, dissipation_least_scaled, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, dissipation_cusp_bend_by_inertia, dissipation_cusp_bend_by_inertia, X(0), X(1), X(2), X(3), X(4), X(5),
    X(6), X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15))
SF_TUPLE(, dissipation_isola_bend_by_inertia, 2, dissipation_isola_bend_by_inertia, X(0), X(1), X(2), X(3), X(4),
    X(5), X(6), X(7), X(8), X(9), X(10), X(11), X(12))
SF_TUPLE(, dissipation_structural_bound, 2, dissipation_structural_bound, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, dissipation_quadratic_bound, dissipation_quadratic_bound, X(0), X(1))
SF_TUPLE(, dissipation_folds_by_R, 6, dissipation_folds_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7), X(8),
    X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_peaks_by_R, 6, dissipation_peaks_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7), X(8),
    X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_cusps_by_R, 6, dissipation_cusps_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7), X(8),
    X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_isolas_by_R, 6, dissipation_isolas_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7),
    X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_turns_by_R, 6, dissipation_turns_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7), X(8),
    X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_folds_by_Omega, 6, dissipation_folds_by_Omega, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_peaks_by_Omega, 6, dissipation_peaks_by_Omega, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_cusps_by_Omega, 6, dissipation_cusps_by_Omega, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_isolas_by_Omega, 6, dissipation_isolas_by_Omega, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_turns_by_Omega, 6, dissipation_turns_by_Omega, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_folds_far_by_R, 6, dissipation_folds_far_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_peaks_far_by_R, 6, dissipation_peaks_far_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_cusps_far_by_R, 6, dissipation_cusps_far_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_isolas_far_by_R, 6, dissipation_isolas_far_by_R, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_folds_far_by_x, 6, dissipation_folds_far_by_x, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_peaks_far_by_x, 6, dissipation_peaks_far_by_x, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_cusps_far_by_x, 6, dissipation_cusps_far_by_x, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))
SF_TUPLE(, dissipation_isolas_far_by_x, 6, dissipation_isolas_far_by_x, X(0), X(1), X(2), X(3), X(4), X(5), X(6),
    X(7), X(8), X(9), X(10), X(11), X(12), X(13), X(14), X(15), X(16), X(17), X(18), X(19), X(20))

static const sf_kernel kernels[] = {
    {"restoring", 3, 1, SF_ONE(dissipation_restoring)},
    {"released_moves", 3, 9, SF_ONE(dissipation_released_moves)},
    {"viscous_moves", 1, 3, SF_ONE(dissipation_viscous_moves)},
    {"far", 9, 4, SF_ONE(dissipation_far)},
    {"F_AOmegaOmega", 10, 1, SF_ONE(dissipation_F_AOmegaOmega)},
    {"Omega_A", 10, 1, SF_ONE(dissipation_Omega_A)},
    {"Omega_A_by_inertia", 10, 1, SF_ONE(dissipation_Omega_A_by_inertia)},
    {"response_polynomial", 6, 7, SF_ONE(dissipation_response_polynomial)},
    {"fold_polynomial", 9, 7, SF_ONE(dissipation_fold_polynomial)},
    {"F_A_halved", 4, 1, SF_ONE(dissipation_F_A_halved)},
    {"R_of_peak", 6, 1, SF_ONE(dissipation_R_of_peak)},
    {"least_scaled", 5, 2, SF_ONE(dissipation_least_scaled)},
    {"cusp_bend_by_inertia", 16, 1, SF_ONE(dissipation_cusp_bend_by_inertia)},
    {"isola_bend_by_inertia", 13, 2, SF_ONE(dissipation_isola_bend_by_inertia)},
    {"structural_bound", 5, 2, SF_ONE(dissipation_structural_bound)},
    {"quadratic_bound", 2, 1, SF_ONE(dissipation_quadratic_bound)},
    {"folds_by_R", 21, 6, SF_ONE(dissipation_folds_by_R)},
    {"peaks_by_R", 21, 6, SF_ONE(dissipation_peaks_by_R)},
    {"cusps_by_R", 21, 6, SF_ONE(dissipation_cusps_by_R)},
    {"isolas_by_R", 21, 6, SF_ONE(dissipation_isolas_by_R)},
    {"turns_by_R", 21, 6, SF_ONE(dissipation_turns_by_R)},
    {"folds_by_Omega", 21, 6, SF_ONE(dissipation_folds_by_Omega)},
    {"peaks_by_Omega", 21, 6, SF_ONE(dissipation_peaks_by_Omega)},
    {"cusps_by_Omega", 21, 6, SF_ONE(dissipation_cusps_by_Omega)},
    {"isolas_by_Omega", 21, 6, SF_ONE(dissipation_isolas_by_Omega)},
    {"turns_by_Omega", 21, 6, SF_ONE(dissipation_turns_by_Omega)},
    {"folds_far_by_R", 21, 6, SF_ONE(dissipation_folds_far_by_R)},
    {"peaks_far_by_R", 21, 6, SF_ONE(dissipation_peaks_far_by_R)},
    {"cusps_far_by_R", 21, 6, SF_ONE(dissipation_cusps_far_by_R)},
    {"isolas_far_by_R", 21, 6, SF_ONE(dissipation_isolas_far_by_R)},
    {"folds_far_by_x", 21, 6, SF_ONE(dissipation_folds_far_by_x)},
    {"peaks_far_by_x", 21, 6, SF_ONE(dissipation_peaks_far_by_x)},
    {"cusps_far_by_x", 21, 6, SF_ONE(dissipation_cusps_far_by_x)},
    {"isolas_far_by_x", 21, 6, SF_ONE(dissipation_isolas_far_by_x)},
};

const sf_module sf_module_dissipation = {"dissipation", kernels, sizeof kernels / sizeof kernels[0]};
