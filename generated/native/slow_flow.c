/* Slow flow of any mechanism, in h = H - A and its derivatives: loops for NumPy.

   Written by `make derive` from slow_flow.h, the same functions for one number each; never edit. */

#include "slow_flow.h"

#include "kernels.h"

#define REGIMES_1(loop, ...) loop(_inwards, __VA_ARGS__) loop(_outwards, __VA_ARGS__)
#define REGIMES_2(loop, ...) loop(_over, __VA_ARGS__) loop(_apart, __VA_ARGS__)

/* name, number of arguments and, where there are several, of results */
#define KERNELS(NUMBER, NUMBERS, of) \
    NUMBER(of, friction, 1) NUMBER(of, R, 3) NUMBER(of, I, 4) NUMBER(of, F, 6) NUMBER(of, F_A, 6) \
    NUMBER(of, F_AA, 7) NUMBER(of, F_Omega, 5) NUMBER(of, F_AOmega, 6) NUMBER(of, F_OmegaOmega, 4) \
    NUMBER(of, phase, 5) NUMBER(of, backbone, 2) NUMBER(of, limit_envelope, 4) NUMBER(of, equivalent_damping, 4) \
    NUMBER(of, transmissibility, 6) NUMBERS(of, jacobian, 6, 4) NUMBER(of, stability, 6) \
    NUMBERS(of, response_quartic, 5, 4) NUMBERS(of, fold_quartic, 5, 4) NUMBERS(of, peak_cubic, 4, 3) \
    NUMBERS(of, detachment, 4, 4) NUMBER(of, level, 5) NUMBERS(of, rest, 4, 3) NUMBER(of, least_restoring, 2) \
    NUMBERS(of, intercept, 4, 2) NUMBER(of, most_restoring, 4) NUMBERS(of, fold, 8, 3) NUMBER(of, fold_square, 3) \
    NUMBERS(of, fold_moves, 3, 2) NUMBER(of, isola_Omega, 1) NUMBER(of, isola_level, 4) NUMBERS(of, isola, 6, 2) \
    NUMBERS(of, cusps, 6, 5) NUMBERS(of, cusp_R, 6, 2) NUMBERS(of, cusp, 10, 4) NUMBERS(of, cusp_balance, 7, 2) \
    NUMBERS(of, turn, 6, 2) NUMBERS(of, peak, 6, 2) NUMBER(of, peak_Omega_A, 5) NUMBER(of, mean_stiffness, 3) \
    NUMBER(of, Omega_A, 6) NUMBER(of, level_rise, 7) NUMBER(of, cusp_bend, 6) NUMBER(of, isola_bend, 5) \
    NUMBER(of, isola_hessian, 5) NUMBER(of, tail, 3) NUMBERS(of, response_quartic_mu0, 4, 4) \
    NUMBERS(of, detachment_mu0, 3, 3) NUMBERS(of, isola_mu0, 5, 2) NUMBERS(of, fold_mu0, 7, 3) \
    NUMBERS(of, detachment_zeta0, 2, 3) NUMBERS(of, fold_zeta0, 4, 2) NUMBER(of, undamped_Omega, 1) \
    NUMBER(of, undamped_level, 2) NUMBERS(of, undamped_rises, 3, 2) NUMBERS(of, undamped, 5, 4) \
    NUMBERS(of, detachment_mu0_zeta0, 1, 2)

KERNELS(SF_NUMBER, SF_NUMBERS, slow_flow)
REGIMES_1(SF_SCALAR, slow_flow_isolation, slow_flow_isolation, X(0), X(1), X(2), X(3))
SF_CHOOSE(slow_flow_isolation, 4, h <= 0.0 ? 0 : 1, const double h = X(3))
REGIMES_2(SF_SCALAR, slow_flow_offset_stiffness, slow_flow_offset_stiffness, X(0), X(1), X(2), X(3))
SF_CHOOSE(slow_flow_offset_stiffness, 4, 0.5 * fabs(h_A) + 0.5 * fabs(h) / A <= fabs(8.0 * Omega * Omega + h_A + h /
    A) ? 0 : 1, const double Omega = X(0), A = X(1), h = X(2), h_A = X(3))

static const sf_kernel kernels[] = {
    KERNELS(SF_NUMBER_KERNEL, SF_NUMBERS_KERNEL, slow_flow)
    {"isolation", 4, 1, SF_SEVERAL(slow_flow_isolation, REGIMES_1(SF_NAMED, slow_flow_isolation))},
    {"offset_stiffness", 4, 1, SF_SEVERAL(slow_flow_offset_stiffness, REGIMES_2(SF_NAMED, slow_flow_offset_stiffness))},
};

const sf_module sf_module_slow_flow = {"slow_flow", kernels, sizeof kernels / sizeof kernels[0]};
