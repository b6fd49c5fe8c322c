/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance: loops for NumPy.

   Written by `make derive`; never edit.
   Input: inertia.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "inertia.h"

#include "kernels.h"

SF_SCALAR(, inertia_force, inertia_force, X(0), X(1))
SF_TUPLE(, inertia_force_slopes, 2, inertia_force_slopes, X(0), X(1))
SF_SCALAR(, inertia_isolation, inertia_isolation, X(0), X(1), X(2), X(3))
SF_SCALAR(, inertia_level, inertia_level, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, inertia_F, inertia_F, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, inertia_level_slope, inertia_level_slope, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, inertia_Omega_A, inertia_Omega_A, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, inertia_terms, 3, inertia_terms, X(0), X(1), X(2), X(3))
SF_SCALAR(, inertia_least, inertia_least, X(0), X(1), X(2))
SF_SCALAR(, inertia_least_Omega_A, inertia_least_Omega_A, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, inertia_peak, 2, inertia_peak, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_TUPLE(, inertia_isola, 2, inertia_isola, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_SCALAR(, inertia_isola_apart, inertia_isola_apart, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_TUPLE(, inertia_fold_slopes, 3, inertia_fold_slopes, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, inertia_fold_force, inertia_fold_force, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, inertia_fold_level, inertia_fold_level, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, inertia_peak_share, inertia_peak_share, X(0), X(1), X(2), X(3))
SF_SCALAR(, inertia_Omega_of_share, inertia_Omega_of_share, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, inertia_level_rise, inertia_level_rise, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_SCALAR(, inertia_cusp_bend, inertia_cusp_bend, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7))
SF_SCALAR(, inertia_hessian, inertia_hessian, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_TUPLE(, inertia_bound, 4, inertia_bound, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7))
SF_SCALAR(, inertia_share, inertia_share, X(0), X(1), X(2))

static const sf_kernel kernels[] = {
    {"force", 2, 1, SF_ONE(inertia_force)},
    {"force_slopes", 2, 2, SF_ONE(inertia_force_slopes)},
    {"isolation", 4, 1, SF_ONE(inertia_isolation)},
    {"level", 5, 1, SF_ONE(inertia_level)},
    {"F", 6, 1, SF_ONE(inertia_F)},
    {"level_slope", 5, 1, SF_ONE(inertia_level_slope)},
    {"Omega_A", 6, 1, SF_ONE(inertia_Omega_A)},
    {"terms", 4, 3, SF_ONE(inertia_terms)},
    {"least", 3, 1, SF_ONE(inertia_least)},
    {"least_Omega_A", 6, 1, SF_ONE(inertia_least_Omega_A)},
    {"peak", 7, 2, SF_ONE(inertia_peak)},
    {"isola", 7, 2, SF_ONE(inertia_isola)},
    {"isola_apart", 7, 1, SF_ONE(inertia_isola_apart)},
    {"fold_slopes", 5, 3, SF_ONE(inertia_fold_slopes)},
    {"fold_force", 5, 1, SF_ONE(inertia_fold_force)},
    {"fold_level", 5, 1, SF_ONE(inertia_fold_level)},
    {"peak_share", 4, 1, SF_ONE(inertia_peak_share)},
    {"Omega_of_share", 5, 1, SF_ONE(inertia_Omega_of_share)},
    {"level_rise", 7, 1, SF_ONE(inertia_level_rise)},
    {"cusp_bend", 8, 1, SF_ONE(inertia_cusp_bend)},
    {"hessian", 7, 1, SF_ONE(inertia_hessian)},
    {"bound", 8, 4, SF_ONE(inertia_bound)},
    {"share", 3, 1, SF_ONE(inertia_share)},
};

const sf_module sf_module_inertia = {"inertia", kernels, sizeof kernels / sizeof kernels[0]};
