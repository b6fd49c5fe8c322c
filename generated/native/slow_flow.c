/* Slow flow of any mechanism, in h = H - A and its derivatives: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow.h"

#include "kernels.h"

SF_LOOP(slow_flow_friction_loop, 1,
    const double mu = in[0][i];
    values[0] = slow_flow_friction(mu);
)

SF_LOOP(slow_flow_R_loop, 1,
    const double Omega = in[0][i], A = in[1][i], h = in[2][i];
    values[0] = slow_flow_R(Omega, A, h);
)

SF_LOOP(slow_flow_I_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_I(Omega, A, m, zeta);
)

SF_LOOP(slow_flow_F_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i];
    values[0] = slow_flow_F(Omega, A, F_0, m, zeta, h);
)

SF_LOOP(slow_flow_F_A_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
    values[0] = slow_flow_F_A(Omega, A, m, zeta, h, h_A);
)

SF_LOOP(slow_flow_F_AA_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
        in[6][i];
    values[0] = slow_flow_F_AA(Omega, A, m, zeta, h, h_A, h_AA);
)

SF_LOOP(slow_flow_F_Omega_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    values[0] = slow_flow_F_Omega(Omega, A, m, zeta, h);
)

SF_LOOP(slow_flow_F_AOmega_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
    values[0] = slow_flow_F_AOmega(Omega, A, m, zeta, h, h_A);
)

SF_LOOP(slow_flow_phase_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    values[0] = slow_flow_phase(Omega, A, m, zeta, h);
)

SF_LOOP(slow_flow_backbone_loop, 1,
    const double A = in[0][i], h = in[1][i];
    values[0] = slow_flow_backbone(A, h);
)

SF_LOOP(slow_flow_limit_envelope_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_limit_envelope(Omega, F_0, m, zeta);
)

SF_LOOP(slow_flow_equivalent_damping_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_equivalent_damping(Omega, A, m, zeta);
)

SF_LOOP(slow_flow_transmissibility_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i];
    values[0] = slow_flow_transmissibility(Omega, A, F_0, m, zeta, h);
)

SF_LOOP(slow_flow_jacobian_loop, 4,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
    slow_flow_jacobian(Omega, A, m, zeta, h, h_A, values);
)

SF_LOOP(slow_flow_mean_stiffness_loop, 1,
    const double A = in[0][i], h = in[1][i], h_A = in[2][i];
    values[0] = slow_flow_mean_stiffness(A, h, h_A);
)

SF_LOOP(slow_flow_offset_stiffness_over_loop, 1,
    const double Omega = in[0][i], A = in[1][i], h = in[2][i], h_A = in[3][i];
    values[0] = slow_flow_offset_stiffness_over(Omega, A, h, h_A);
)
SF_LOOP(slow_flow_offset_stiffness_apart_loop, 1,
    const double Omega = in[0][i], A = in[1][i], h = in[2][i], h_A = in[3][i];
    values[0] = slow_flow_offset_stiffness_apart(Omega, A, h, h_A);
)

static SF_WIDE void slow_flow_offset_stiffness_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *Omega_ = in[0], *A_ = in[1], *h_ = in[2], *h_A_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double Omega = Omega_[i], A = A_[i], h = h_[i], h_A = h_A_[i];
        regime[i] = 0.5 * fabs(h_A) + 0.5 * fabs(h) / A <= fabs(8.0 * Omega * Omega + h_A + h / A) ? 0 : 1;
    }
}

static const sf_loop slow_flow_offset_stiffness_loops[] = {
    slow_flow_offset_stiffness_over_loop, slow_flow_offset_stiffness_apart_loop
};

SF_LOOP(slow_flow_stability_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
    values[0] = slow_flow_stability(Omega, A, m, zeta, h, h_A);
)

SF_LOOP(slow_flow_response_quartic_loop, 4,
    const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    slow_flow_response_quartic(A, F_0, m, zeta, h, values);
)

SF_LOOP(slow_flow_fold_quartic_loop, 4,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i];
    slow_flow_fold_quartic(A, m, zeta, h, h_A, values);
)

SF_LOOP(slow_flow_peak_cubic_loop, 3,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
    slow_flow_peak_cubic(A, m, zeta, h, values);
)

SF_LOOP(slow_flow_detachment_loop, 4,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
    slow_flow_detachment(A, m, zeta, h, values);
)

SF_LOOP(slow_flow_F_OmegaOmega_loop, 1,
    const double Omega = in[0][i], A = in[1][i], zeta = in[2][i], h = in[3][i];
    values[0] = slow_flow_F_OmegaOmega(Omega, A, zeta, h);
)

SF_LOOP(slow_flow_level_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    values[0] = slow_flow_level(Omega, A, m, zeta, h);
)

SF_LOOP(slow_flow_rest_loop, 3,
    const double F_0 = in[0][i], m = in[1][i], h = in[2][i], h_A = in[3][i];
    slow_flow_rest(F_0, m, h, h_A, values);
)

SF_LOOP(slow_flow_intercept_loop, 2,
    const double A = in[0][i], h = in[1][i], h_A = in[2][i], h_AA = in[3][i];
    slow_flow_intercept(A, h, h_A, h_AA, values);
)

SF_LOOP(slow_flow_fold_loop, 3,
    const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], k =
        in[6][i], k_A = in[7][i];
    slow_flow_fold(A, F_0, m, zeta, h, h_A, k, k_A, values);
)

SF_LOOP(slow_flow_fold_square_loop, 1,
    const double Omega = in[0][i], A = in[1][i], lacks = in[2][i];
    values[0] = slow_flow_fold_square(Omega, A, lacks);
)

SF_LOOP(slow_flow_fold_moves_loop, 2,
    const double A = in[0][i], k = in[1][i], R = in[2][i];
    slow_flow_fold_moves(A, k, R, values);
)

SF_LOOP(slow_flow_isola_Omega_loop, 1,
    const double h_A = in[0][i];
    values[0] = slow_flow_isola_Omega(h_A);
)

SF_LOOP(slow_flow_isola_level_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_isola_level(Omega, A, m, zeta);
)

SF_LOOP(slow_flow_isola_loop, 2,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i], h_AA = in[5][i];
    slow_flow_isola(A, m, zeta, h, h_A, h_AA, values);
)

SF_LOOP(slow_flow_cusps_loop, 5,
    const double A = in[0][i], zeta = in[1][i], h = in[2][i], h_A = in[3][i], h_AA = in[4][i], k = in[5][i];
    slow_flow_cusps(A, zeta, h, h_A, h_AA, k, values);
)

SF_LOOP(slow_flow_cusp_R_loop, 2,
    const double A = in[0][i], zeta = in[1][i], h_AA = in[2][i], k = in[3][i], X = in[4][i], T = in[5][i];
    slow_flow_cusp_R(A, zeta, h_AA, k, X, T, values);
)

SF_LOOP(slow_flow_cusp_loop, 4,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h_AA = in[3][i], h_AAA = in[4][i], k = in[5][i], X =
        in[6][i], T = in[7][i], R = in[8][i], root = in[9][i];
    slow_flow_cusp(A, m, zeta, h_AA, h_AAA, k, X, T, R, root, values);
)

SF_LOOP(slow_flow_cusp_balance_loop, 2,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], k = in[4][i], X = in[5][i], T =
        in[6][i];
    slow_flow_cusp_balance(A, m, zeta, h, k, X, T, values);
)

SF_LOOP(slow_flow_turn_loop, 2,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h_AA = in[4][i], k = in[5][i];
    slow_flow_turn(Omega, A, m, zeta, h_AA, k, values);
)

SF_LOOP(slow_flow_peak_loop, 2,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h_A = in[5][i];
    slow_flow_peak(Omega, A, F_0, m, zeta, h_A, values);
)

SF_LOOP(slow_flow_peak_Omega_A_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h_A = in[4][i];
    values[0] = slow_flow_peak_Omega_A(Omega, A, m, zeta, h_A);
)

SF_LOOP(slow_flow_Omega_A_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
    values[0] = slow_flow_Omega_A(Omega, A, m, zeta, h, h_A);
)

SF_LOOP(slow_flow_level_rise_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
        in[6][i];
    values[0] = slow_flow_level_rise(Omega, A, m, zeta, h, h_A, h_AA);
)

SF_LOOP(slow_flow_cusp_bend_loop, 1,
    const double Omega = in[0][i], A = in[1][i], zeta = in[2][i], h_AA = in[3][i], h_AAA = in[4][i], T = in[5][i];
    values[0] = slow_flow_cusp_bend(Omega, A, zeta, h_AA, h_AAA, T);
)

SF_LOOP(slow_flow_isola_bend_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h_AA = in[4][i];
    values[0] = slow_flow_isola_bend(Omega, A, m, zeta, h_AA);
)

SF_LOOP(slow_flow_isola_hessian_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h_AA = in[4][i];
    values[0] = slow_flow_isola_hessian(Omega, A, m, zeta, h_AA);
)

SF_LOOP(slow_flow_tail_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i], m = in[2][i];
    values[0] = slow_flow_tail(Omega, F_0, m);
)

SF_LOOP(slow_flow_most_restoring_loop, 1,
    const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_most_restoring(A, F_0, m, zeta);
)

SF_LOOP(slow_flow_least_restoring_loop, 1,
    const double F_0 = in[0][i], m = in[1][i];
    values[0] = slow_flow_least_restoring(F_0, m);
)

static const sf_kernel kernels[] = {
    {"friction", 1, 1, 1, NULL, SF_ONE(slow_flow_friction_loop)},
    {"R", 3, 1, 1, NULL, SF_ONE(slow_flow_R_loop)},
    {"I", 4, 1, 1, NULL, SF_ONE(slow_flow_I_loop)},
    {"F", 6, 1, 1, NULL, SF_ONE(slow_flow_F_loop)},
    {"F_A", 6, 1, 1, NULL, SF_ONE(slow_flow_F_A_loop)},
    {"F_AA", 7, 1, 1, NULL, SF_ONE(slow_flow_F_AA_loop)},
    {"F_Omega", 5, 1, 1, NULL, SF_ONE(slow_flow_F_Omega_loop)},
    {"F_AOmega", 6, 1, 1, NULL, SF_ONE(slow_flow_F_AOmega_loop)},
    {"phase", 5, 1, 1, NULL, SF_ONE(slow_flow_phase_loop)},
    {"backbone", 2, 1, 1, NULL, SF_ONE(slow_flow_backbone_loop)},
    {"limit_envelope", 4, 1, 1, NULL, SF_ONE(slow_flow_limit_envelope_loop)},
    {"equivalent_damping", 4, 1, 1, NULL, SF_ONE(slow_flow_equivalent_damping_loop)},
    {"transmissibility", 6, 1, 1, NULL, SF_ONE(slow_flow_transmissibility_loop)},
    {"jacobian", 6, 4, 1, NULL, SF_ONE(slow_flow_jacobian_loop)},
    {"mean_stiffness", 3, 1, 1, NULL, SF_ONE(slow_flow_mean_stiffness_loop)},
    {"offset_stiffness", 4, 1, 2, slow_flow_offset_stiffness_regime, slow_flow_offset_stiffness_loops},
    {"stability", 6, 1, 1, NULL, SF_ONE(slow_flow_stability_loop)},
    {"response_quartic", 5, 4, 1, NULL, SF_ONE(slow_flow_response_quartic_loop)},
    {"fold_quartic", 5, 4, 1, NULL, SF_ONE(slow_flow_fold_quartic_loop)},
    {"peak_cubic", 4, 3, 1, NULL, SF_ONE(slow_flow_peak_cubic_loop)},
    {"detachment", 4, 4, 1, NULL, SF_ONE(slow_flow_detachment_loop)},
    {"F_OmegaOmega", 4, 1, 1, NULL, SF_ONE(slow_flow_F_OmegaOmega_loop)},
    {"level", 5, 1, 1, NULL, SF_ONE(slow_flow_level_loop)},
    {"rest", 4, 3, 1, NULL, SF_ONE(slow_flow_rest_loop)},
    {"intercept", 4, 2, 1, NULL, SF_ONE(slow_flow_intercept_loop)},
    {"fold", 8, 3, 1, NULL, SF_ONE(slow_flow_fold_loop)},
    {"fold_square", 3, 1, 1, NULL, SF_ONE(slow_flow_fold_square_loop)},
    {"fold_moves", 3, 2, 1, NULL, SF_ONE(slow_flow_fold_moves_loop)},
    {"isola_Omega", 1, 1, 1, NULL, SF_ONE(slow_flow_isola_Omega_loop)},
    {"isola_level", 4, 1, 1, NULL, SF_ONE(slow_flow_isola_level_loop)},
    {"isola", 6, 2, 1, NULL, SF_ONE(slow_flow_isola_loop)},
    {"cusps", 6, 5, 1, NULL, SF_ONE(slow_flow_cusps_loop)},
    {"cusp_R", 6, 2, 1, NULL, SF_ONE(slow_flow_cusp_R_loop)},
    {"cusp", 10, 4, 1, NULL, SF_ONE(slow_flow_cusp_loop)},
    {"cusp_balance", 7, 2, 1, NULL, SF_ONE(slow_flow_cusp_balance_loop)},
    {"turn", 6, 2, 1, NULL, SF_ONE(slow_flow_turn_loop)},
    {"peak", 6, 2, 1, NULL, SF_ONE(slow_flow_peak_loop)},
    {"peak_Omega_A", 5, 1, 1, NULL, SF_ONE(slow_flow_peak_Omega_A_loop)},
    {"Omega_A", 6, 1, 1, NULL, SF_ONE(slow_flow_Omega_A_loop)},
    {"level_rise", 7, 1, 1, NULL, SF_ONE(slow_flow_level_rise_loop)},
    {"cusp_bend", 6, 1, 1, NULL, SF_ONE(slow_flow_cusp_bend_loop)},
    {"isola_bend", 5, 1, 1, NULL, SF_ONE(slow_flow_isola_bend_loop)},
    {"isola_hessian", 5, 1, 1, NULL, SF_ONE(slow_flow_isola_hessian_loop)},
    {"tail", 3, 1, 1, NULL, SF_ONE(slow_flow_tail_loop)},
    {"most_restoring", 4, 1, 1, NULL, SF_ONE(slow_flow_most_restoring_loop)},
    {"least_restoring", 2, 1, 1, NULL, SF_ONE(slow_flow_least_restoring_loop)},
};

const sf_module sf_module_slow_flow = {"slow_flow", kernels, sizeof kernels / sizeof kernels[0]};
