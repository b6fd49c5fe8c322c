/* Slow flow of any mechanism, in h = H - A and its derivatives: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow.h"

#include "kernels.h"

#define REGIMES_1(loop, ...) loop(_inwards, __VA_ARGS__) loop(_outwards, __VA_ARGS__)
#define REGIMES_2(loop, ...) loop(_over, __VA_ARGS__) loop(_apart, __VA_ARGS__)

SF_SCALAR(, slow_flow_friction, slow_flow_friction, X(0))
SF_SCALAR(, slow_flow_R, slow_flow_R, X(0), X(1), X(2))
SF_SCALAR(, slow_flow_I, slow_flow_I, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_F, slow_flow_F, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, slow_flow_F_A, slow_flow_F_A, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, slow_flow_F_AA, slow_flow_F_AA, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_SCALAR(, slow_flow_F_Omega, slow_flow_F_Omega, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, slow_flow_F_AOmega, slow_flow_F_AOmega, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, slow_flow_F_OmegaOmega, slow_flow_F_OmegaOmega, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_phase, slow_flow_phase, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, slow_flow_backbone, slow_flow_backbone, X(0), X(1))
SF_SCALAR(, slow_flow_limit_envelope, slow_flow_limit_envelope, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_equivalent_damping, slow_flow_equivalent_damping, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_transmissibility, slow_flow_transmissibility, X(0), X(1), X(2), X(3), X(4), X(5))
REGIMES_1(SF_SCALAR, slow_flow_isolation, slow_flow_isolation, X(0), X(1), X(2), X(3))
SF_CHOOSE(slow_flow_isolation, 4, h <= 0.0 ? 0 : 1, const double h = X(3))
SF_TUPLE(, slow_flow_jacobian, 4, slow_flow_jacobian, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, slow_flow_stability, slow_flow_stability, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, slow_flow_response_quartic, 4, slow_flow_response_quartic, X(0), X(1), X(2), X(3), X(4))
SF_TUPLE(, slow_flow_fold_quartic, 4, slow_flow_fold_quartic, X(0), X(1), X(2), X(3), X(4))
SF_TUPLE(, slow_flow_peak_cubic, 3, slow_flow_peak_cubic, X(0), X(1), X(2), X(3))
SF_TUPLE(, slow_flow_detachment, 4, slow_flow_detachment, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_level, slow_flow_level, X(0), X(1), X(2), X(3), X(4))
SF_TUPLE(, slow_flow_rest, 3, slow_flow_rest, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_least_restoring, slow_flow_least_restoring, X(0), X(1))
SF_TUPLE(, slow_flow_intercept, 2, slow_flow_intercept, X(0), X(1), X(2), X(3))
SF_SCALAR(, slow_flow_most_restoring, slow_flow_most_restoring, X(0), X(1), X(2), X(3))
SF_TUPLE(, slow_flow_fold, 3, slow_flow_fold, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7))
SF_SCALAR(, slow_flow_fold_square, slow_flow_fold_square, X(0), X(1), X(2))
SF_TUPLE(, slow_flow_fold_moves, 2, slow_flow_fold_moves, X(0), X(1), X(2))
SF_SCALAR(, slow_flow_isola_Omega, slow_flow_isola_Omega, X(0))
SF_SCALAR(, slow_flow_isola_level, slow_flow_isola_level, X(0), X(1), X(2), X(3))
SF_TUPLE(, slow_flow_isola, 2, slow_flow_isola, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, slow_flow_cusps, 5, slow_flow_cusps, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, slow_flow_cusp_R, 2, slow_flow_cusp_R, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, slow_flow_cusp, 4, slow_flow_cusp, X(0), X(1), X(2), X(3), X(4), X(5), X(6), X(7), X(8), X(9))
SF_TUPLE(, slow_flow_cusp_balance, 2, slow_flow_cusp_balance, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_TUPLE(, slow_flow_turn, 2, slow_flow_turn, X(0), X(1), X(2), X(3), X(4), X(5))
SF_TUPLE(, slow_flow_peak, 2, slow_flow_peak, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, slow_flow_peak_Omega_A, slow_flow_peak_Omega_A, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, slow_flow_mean_stiffness, slow_flow_mean_stiffness, X(0), X(1), X(2))
REGIMES_2(SF_SCALAR, slow_flow_offset_stiffness, slow_flow_offset_stiffness, X(0), X(1), X(2), X(3))
SF_CHOOSE(slow_flow_offset_stiffness, 4, 0.5 * fabs(h_A) + 0.5 * fabs(h) / A <= fabs(8.0 * Omega * Omega + h_A + h /
    A) ? 0 : 1, const double Omega = X(0), A = X(1), h = X(2), h_A = X(3))
SF_SCALAR(, slow_flow_Omega_A, slow_flow_Omega_A, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, slow_flow_level_rise, slow_flow_level_rise, X(0), X(1), X(2), X(3), X(4), X(5), X(6))
SF_SCALAR(, slow_flow_cusp_bend, slow_flow_cusp_bend, X(0), X(1), X(2), X(3), X(4), X(5))
SF_SCALAR(, slow_flow_isola_bend, slow_flow_isola_bend, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, slow_flow_isola_hessian, slow_flow_isola_hessian, X(0), X(1), X(2), X(3), X(4))
SF_SCALAR(, slow_flow_tail, slow_flow_tail, X(0), X(1), X(2))

static const sf_kernel kernels[] = {
    {"friction", 1, 1, SF_ONE(slow_flow_friction)},
    {"R", 3, 1, SF_ONE(slow_flow_R)},
    {"I", 4, 1, SF_ONE(slow_flow_I)},
    {"F", 6, 1, SF_ONE(slow_flow_F)},
    {"F_A", 6, 1, SF_ONE(slow_flow_F_A)},
    {"F_AA", 7, 1, SF_ONE(slow_flow_F_AA)},
    {"F_Omega", 5, 1, SF_ONE(slow_flow_F_Omega)},
    {"F_AOmega", 6, 1, SF_ONE(slow_flow_F_AOmega)},
    {"F_OmegaOmega", 4, 1, SF_ONE(slow_flow_F_OmegaOmega)},
    {"phase", 5, 1, SF_ONE(slow_flow_phase)},
    {"backbone", 2, 1, SF_ONE(slow_flow_backbone)},
    {"limit_envelope", 4, 1, SF_ONE(slow_flow_limit_envelope)},
    {"equivalent_damping", 4, 1, SF_ONE(slow_flow_equivalent_damping)},
    {"transmissibility", 6, 1, SF_ONE(slow_flow_transmissibility)},
    {"isolation", 4, 1, SF_SEVERAL(slow_flow_isolation, REGIMES_1(SF_NAMED, slow_flow_isolation))},
    {"jacobian", 6, 4, SF_ONE(slow_flow_jacobian)},
    {"stability", 6, 1, SF_ONE(slow_flow_stability)},
    {"response_quartic", 5, 4, SF_ONE(slow_flow_response_quartic)},
    {"fold_quartic", 5, 4, SF_ONE(slow_flow_fold_quartic)},
    {"peak_cubic", 4, 3, SF_ONE(slow_flow_peak_cubic)},
    {"detachment", 4, 4, SF_ONE(slow_flow_detachment)},
    {"level", 5, 1, SF_ONE(slow_flow_level)},
    {"rest", 4, 3, SF_ONE(slow_flow_rest)},
    {"least_restoring", 2, 1, SF_ONE(slow_flow_least_restoring)},
    {"intercept", 4, 2, SF_ONE(slow_flow_intercept)},
    {"most_restoring", 4, 1, SF_ONE(slow_flow_most_restoring)},
    {"fold", 8, 3, SF_ONE(slow_flow_fold)},
    {"fold_square", 3, 1, SF_ONE(slow_flow_fold_square)},
    {"fold_moves", 3, 2, SF_ONE(slow_flow_fold_moves)},
    {"isola_Omega", 1, 1, SF_ONE(slow_flow_isola_Omega)},
    {"isola_level", 4, 1, SF_ONE(slow_flow_isola_level)},
    {"isola", 6, 2, SF_ONE(slow_flow_isola)},
    {"cusps", 6, 5, SF_ONE(slow_flow_cusps)},
    {"cusp_R", 6, 2, SF_ONE(slow_flow_cusp_R)},
    {"cusp", 10, 4, SF_ONE(slow_flow_cusp)},
    {"cusp_balance", 7, 2, SF_ONE(slow_flow_cusp_balance)},
    {"turn", 6, 2, SF_ONE(slow_flow_turn)},
    {"peak", 6, 2, SF_ONE(slow_flow_peak)},
    {"peak_Omega_A", 5, 1, SF_ONE(slow_flow_peak_Omega_A)},
    {"mean_stiffness", 3, 1, SF_ONE(slow_flow_mean_stiffness)},
    {"offset_stiffness", 4, 1, SF_SEVERAL(slow_flow_offset_stiffness, REGIMES_2(SF_NAMED, slow_flow_offset_stiffness))},
    {"Omega_A", 6, 1, SF_ONE(slow_flow_Omega_A)},
    {"level_rise", 7, 1, SF_ONE(slow_flow_level_rise)},
    {"cusp_bend", 6, 1, SF_ONE(slow_flow_cusp_bend)},
    {"isola_bend", 5, 1, SF_ONE(slow_flow_isola_bend)},
    {"isola_hessian", 5, 1, SF_ONE(slow_flow_isola_hessian)},
    {"tail", 3, 1, SF_ONE(slow_flow_tail)},
};

const sf_module sf_module_slow_flow = {"slow_flow", kernels, sizeof kernels / sizeof kernels[0]};
