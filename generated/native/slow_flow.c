/* Slow flow of any mechanism, in h = H - A and its derivatives: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow.h"

#include "kernels.h"

static SF_WIDE void slow_flow_friction_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double mu = in[0][i];
        out[0][i] = slow_flow_friction(mu);
    }
}

static const sf_loop slow_flow_friction_loops[] = {slow_flow_friction_loop};

static SF_WIDE void slow_flow_R_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], h = in[2][i];
        out[0][i] = slow_flow_R(Omega, A, h);
    }
}

static const sf_loop slow_flow_R_loops[] = {slow_flow_R_loop};

static SF_WIDE void slow_flow_I_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_I(Omega, A, m, zeta);
    }
}

static const sf_loop slow_flow_I_loops[] = {slow_flow_I_loop};

static SF_WIDE void slow_flow_F_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i];
        out[0][i] = slow_flow_F(Omega, A, F_0, m, zeta, h);
    }
}

static const sf_loop slow_flow_F_loops[] = {slow_flow_F_loop};

static SF_WIDE void slow_flow_F_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_F_A(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_F_A_loops[] = {slow_flow_F_A_loop};

static SF_WIDE void slow_flow_F_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i];
        out[0][i] = slow_flow_F_AA(Omega, A, m, zeta, h, h_A, h_AA);
    }
}

static const sf_loop slow_flow_F_AA_loops[] = {slow_flow_F_AA_loop};

static SF_WIDE void slow_flow_F_Omega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_F_Omega(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_F_Omega_loops[] = {slow_flow_F_Omega_loop};

static SF_WIDE void slow_flow_F_AOmega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_F_AOmega(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_F_AOmega_loops[] = {slow_flow_F_AOmega_loop};

static SF_WIDE void slow_flow_phase_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_phase(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_phase_loops[] = {slow_flow_phase_loop};

static SF_WIDE void slow_flow_backbone_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], h = in[1][i];
        out[0][i] = slow_flow_backbone(A, h);
    }
}

static const sf_loop slow_flow_backbone_loops[] = {slow_flow_backbone_loop};

static SF_WIDE void slow_flow_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_limit_envelope(Omega, F_0, m, zeta);
    }
}

static const sf_loop slow_flow_limit_envelope_loops[] = {slow_flow_limit_envelope_loop};

static SF_WIDE void slow_flow_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_equivalent_damping(Omega, A, m, zeta);
    }
}

static const sf_loop slow_flow_equivalent_damping_loops[] = {slow_flow_equivalent_damping_loop};

static SF_WIDE void slow_flow_transmissibility_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i];
        out[0][i] = slow_flow_transmissibility(Omega, A, F_0, m, zeta, h);
    }
}

static const sf_loop slow_flow_transmissibility_loops[] = {slow_flow_transmissibility_loop};

static SF_WIDE void slow_flow_jacobian_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        double values[4];
        slow_flow_jacobian(Omega, A, m, zeta, h, h_A, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_jacobian_loops[] = {slow_flow_jacobian_loop};

static SF_WIDE void slow_flow_mean_stiffness_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], h = in[1][i], h_A = in[2][i];
        out[0][i] = slow_flow_mean_stiffness(A, h, h_A);
    }
}

static const sf_loop slow_flow_mean_stiffness_loops[] = {slow_flow_mean_stiffness_loop};

static SF_WIDE void slow_flow_offset_stiffness_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], h = in[2][i], h_A = in[3][i];
        out[0][i] = slow_flow_offset_stiffness(Omega, A, h, h_A);
    }
}

static const sf_loop slow_flow_offset_stiffness_loops[] = {slow_flow_offset_stiffness_loop};

static SF_WIDE void slow_flow_stability_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_stability(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_stability_loops[] = {slow_flow_stability_loop};

static SF_WIDE void slow_flow_response_quartic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        double values[4];
        slow_flow_response_quartic(A, F_0, m, zeta, h, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_response_quartic_loops[] = {slow_flow_response_quartic_loop};

static SF_WIDE void slow_flow_fold_quartic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i];
        double values[4];
        slow_flow_fold_quartic(A, m, zeta, h, h_A, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_fold_quartic_loops[] = {slow_flow_fold_quartic_loop};

static SF_WIDE void slow_flow_peak_cubic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
        double values[3];
        slow_flow_peak_cubic(A, m, zeta, h, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_peak_cubic_loops[] = {slow_flow_peak_cubic_loop};

static SF_WIDE void slow_flow_detachment_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
        double values[4];
        slow_flow_detachment(A, m, zeta, h, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_detachment_loops[] = {slow_flow_detachment_loop};

static SF_WIDE void slow_flow_F_OmegaOmega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], zeta = in[2][i], h = in[3][i];
        out[0][i] = slow_flow_F_OmegaOmega(Omega, A, zeta, h);
    }
}

static const sf_loop slow_flow_F_OmegaOmega_loops[] = {slow_flow_F_OmegaOmega_loop};

static SF_WIDE void slow_flow_level_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_level(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_level_loops[] = {slow_flow_level_loop};

static SF_WIDE void slow_flow_rest_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double F_0 = in[0][i], m = in[1][i], h = in[2][i], h_A = in[3][i];
        double values[3];
        slow_flow_rest(F_0, m, h, h_A, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_rest_loops[] = {slow_flow_rest_loop};

static SF_WIDE void slow_flow_intercept_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], h = in[1][i], h_A = in[2][i], h_AA = in[3][i];
        double values[2];
        slow_flow_intercept(A, h, h_A, h_AA, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_intercept_loops[] = {slow_flow_intercept_loop};

static SF_WIDE void slow_flow_fold_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], k =
            in[6][i], k_A = in[7][i];
        double values[3];
        slow_flow_fold(A, F_0, m, zeta, h, h_A, k, k_A, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_fold_loops[] = {slow_flow_fold_loop};

static SF_WIDE void slow_flow_fold_moves_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], k = in[1][i], R = in[2][i];
        double values[2];
        slow_flow_fold_moves(A, k, R, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_fold_moves_loops[] = {slow_flow_fold_moves_loop};

static SF_WIDE void slow_flow_isola_Omega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double h_A = in[0][i];
        out[0][i] = slow_flow_isola_Omega(h_A);
    }
}

static const sf_loop slow_flow_isola_Omega_loops[] = {slow_flow_isola_Omega_loop};

static SF_WIDE void slow_flow_isola_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i], h_AA = in[5][i];
        double values[2];
        slow_flow_isola(A, m, zeta, h, h_A, h_AA, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_isola_loops[] = {slow_flow_isola_loop};

static SF_WIDE void slow_flow_cusps_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], zeta = in[1][i], h = in[2][i], h_A = in[3][i], h_AA = in[4][i], k = in[5][i];
        double values[5];
        slow_flow_cusps(A, zeta, h, h_A, h_AA, k, values);
        for (int k = 0; k < 5; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_cusps_loops[] = {slow_flow_cusps_loop};

static SF_WIDE void slow_flow_cusp_R_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], zeta = in[1][i], h_AA = in[2][i], k = in[3][i], X = in[4][i], T = in[5][i];
        double values[2];
        slow_flow_cusp_R(A, zeta, h_AA, k, X, T, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_cusp_R_loops[] = {slow_flow_cusp_R_loop};

static SF_WIDE void slow_flow_cusp_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h_AA = in[3][i], h_AAA = in[4][i], k = in[5][i], X
            = in[6][i], T = in[7][i], R = in[8][i], root = in[9][i];
        double values[4];
        slow_flow_cusp(A, m, zeta, h_AA, h_AAA, k, X, T, R, root, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_cusp_loops[] = {slow_flow_cusp_loop};

static SF_WIDE void slow_flow_cusp_balance_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], k = in[4][i], X = in[5][i], T =
            in[6][i];
        double values[2];
        slow_flow_cusp_balance(A, m, zeta, h, k, X, T, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_cusp_balance_loops[] = {slow_flow_cusp_balance_loop};

static SF_WIDE void slow_flow_peak_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h_A = in[5][i];
        double values[2];
        slow_flow_peak(Omega, A, F_0, m, zeta, h_A, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_peak_loops[] = {slow_flow_peak_loop};

static SF_WIDE void slow_flow_peak_Omega_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h_A = in[4][i];
        out[0][i] = slow_flow_peak_Omega_A(Omega, A, m, zeta, h_A);
    }
}

static const sf_loop slow_flow_peak_Omega_A_loops[] = {slow_flow_peak_Omega_A_loop};

static SF_WIDE void slow_flow_Omega_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_Omega_A(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_Omega_A_loops[] = {slow_flow_Omega_A_loop};

static SF_WIDE void slow_flow_level_rise_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i];
        out[0][i] = slow_flow_level_rise(Omega, A, m, zeta, h, h_A, h_AA);
    }
}

static const sf_loop slow_flow_level_rise_loops[] = {slow_flow_level_rise_loop};

static SF_WIDE void slow_flow_cusp_bend_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i], h_AAA = in[7][i];
        out[0][i] = slow_flow_cusp_bend(Omega, A, m, zeta, h, h_A, h_AA, h_AAA);
    }
}

static const sf_loop slow_flow_cusp_bend_loops[] = {slow_flow_cusp_bend_loop};

static SF_WIDE void slow_flow_isola_bend_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i];
        out[0][i] = slow_flow_isola_bend(Omega, A, m, zeta, h, h_A, h_AA);
    }
}

static const sf_loop slow_flow_isola_bend_loops[] = {slow_flow_isola_bend_loop};

static SF_WIDE void slow_flow_hessian_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i];
        out[0][i] = slow_flow_hessian(Omega, A, m, zeta, h, h_A, h_AA);
    }
}

static const sf_loop slow_flow_hessian_loops[] = {slow_flow_hessian_loop};

static SF_WIDE void slow_flow_tail_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], m = in[2][i];
        out[0][i] = slow_flow_tail(Omega, F_0, m);
    }
}

static const sf_loop slow_flow_tail_loops[] = {slow_flow_tail_loop};

static SF_WIDE void slow_flow_most_restoring_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_most_restoring(A, F_0, m, zeta);
    }
}

static const sf_loop slow_flow_most_restoring_loops[] = {slow_flow_most_restoring_loop};

static SF_WIDE void slow_flow_least_restoring_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double F_0 = in[0][i], m = in[1][i];
        out[0][i] = slow_flow_least_restoring(F_0, m);
    }
}

static const sf_loop slow_flow_least_restoring_loops[] = {slow_flow_least_restoring_loop};

static const sf_kernel kernels[] = {
    {"friction",
     "Dry friction's share of I. Equation (23). Domain: mu >= 0.",
     1, 1, 1, NULL, slow_flow_friction_loops},
    {"R",
     "Cosine balance, -F_0 cos phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     3, 1, 1, NULL, slow_flow_R_loops},
    {"I",
     "Sine balance, -F_0 sin phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     4, 1, 1, NULL, slow_flow_I_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_F_A_loops},
    {"F_AA",
     "d2F/dA2. Equation (24), (33). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, slow_flow_F_AA_loops},
    {"F_Omega",
     "dF/dOmega. Equation (24), (34). Domain: Omega > 0, A > 0.",
     5, 1, 1, NULL, slow_flow_F_Omega_loops},
    {"F_AOmega",
     "d2F/dA dOmega. Equation (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_F_AOmega_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     5, 1, 1, NULL, slow_flow_phase_loops},
    {"backbone",
     "Frequency on the backbone. Equation (26). Domain: A > 0, h <= 0.",
     2, 1, 1, NULL, slow_flow_backbone_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, slow_flow_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, slow_flow_equivalent_damping_loops},
    {"transmissibility",
     "Fundamental harmonic of the force on the base over F_0, at a steady state. Equation from (23). Domain: Omega > "
     "0, A > 0, F_0 > 0.",
     6, 1, 1, NULL, slow_flow_transmissibility_loops},
    {"jacobian",
     "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22. Equation (28). Domain: Omega > 0, A "
     "> 0.",
     6, 4, 1, NULL, slow_flow_jacobian_loops},
    {"mean_stiffness",
     "Mean of the stiffness over a cycle of a motion about u = 0, which stays about it where this is positive. "
     "Equation beside (30). Domain: A > 0.",
     3, 1, 1, NULL, slow_flow_mean_stiffness_loops},
    {"offset_stiffness",
     "What carries a small mean offset back; where the mean stiffness is negative this decides. Equation beside "
     "(30). Domain: Omega > 0, A > 0.",
     4, 1, 1, NULL, slow_flow_offset_stiffness_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_stability_loops},
    {"response_quartic",
     "F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24). Domain: A > 0.",
     5, 4, 1, NULL, slow_flow_response_quartic_loops},
    {"fold_quartic",
     "F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24), (30). Domain: A > "
     "0.",
     5, 4, 1, NULL, slow_flow_fold_quartic_loops},
    {"peak_cubic",
     "F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3. Equation (34). Domain: A > 0.",
     4, 3, 1, NULL, slow_flow_peak_cubic_loops},
    {"detachment",
     "Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr. "
     "Equation (34). Domain: A > 0.",
     4, 4, 1, NULL, slow_flow_detachment_loops},
    {"F_OmegaOmega",
     "d2F/dOmega2. Equation (24). Domain: Omega > 0, A > 0.",
     4, 1, 1, NULL, slow_flow_F_OmegaOmega_loops},
    {"level",
     "The forcing F_0 for which (Omega, A) is a steady state. Equation (24). Domain: Omega >= 0, A > 0.",
     5, 1, 1, NULL, slow_flow_level_loops},
    {"rest",
     "F at Omega = 0 as a product: h - c, h + c, and the slope of both along A. Equation from (24). Domain: F_0 >= "
     "m.",
     4, 3, 1, NULL, slow_flow_rest_loops},
    {"intercept",
     "k = h - A h_A, where the tangent of h meets A = 0, and its slope along A. Equation from (24), (30). Domain: A "
     ">= 0.",
     4, 2, 1, NULL, slow_flow_intercept_loops},
    {"fold",
     "Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega. Equation from (24), "
     "(30). Domain: A > 0, F_0 > m, k^2 >= F_0^2 - m^2.",
     8, 3, 1, NULL, slow_flow_fold_loops},
    {"fold_moves",
     "What F and F_A change by beside a fold, per what vanishes there (`fold`), at its A, Omega and I. Equation from "
     "(24), (30). Domain: A > 0.",
     3, 2, 1, NULL, slow_flow_fold_moves_loops},
    {"isola_Omega",
     "Omega at an isola point. Equation from (30), (34). Domain: h_A >= 0.",
     1, 1, 1, NULL, slow_flow_isola_Omega_loops},
    {"isola",
     "Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A. "
     "Equation from (30), (34). Domain: A > 0, h_A > 0; for m = 0 any h_A.",
     6, 2, 1, NULL, slow_flow_isola_loops},
    {"cusps",
     "F_AA/2 = T^2 + 2 a T + b = X^2 + 2 c X + d, T = dR/dA, X = Omega^2: a, b, c, d, and a^2 - b = c^2 - d. "
     "Equation from (33). Domain: A > 0.",
     6, 5, 1, NULL, slow_flow_cusps_loops},
    {"cusp_R",
     "R where F_AA = 0 (`cusps`), in two forms: by its tangent, and from F_AA itself. Equation from (33). Domain: A "
     "> 0, X >= 0.",
     6, 2, 1, NULL, slow_flow_cusp_R_loops},
    {"cusp",
     "Where F_AA = 0 (`cusps`; root = a + T): F_A/2, the same less A F_AA/2, its slope along A, F_0 if it is 0. "
     "Equation from (33). Domain: A > 0, X > 0.",
     10, 4, 1, NULL, slow_flow_cusp_loops},
    {"cusp_balance",
     "Omega^2 and F_0^2 at a cusp with R from F_A = 0, by an X = Omega^2 that is nearly right, and T (`cusps`). "
     "Equation from (30). Domain: A > 0, X > 0, T not 0.",
     7, 2, 1, NULL, slow_flow_cusp_balance_loops},
    {"peak",
     "F where F_Omega = 0: an extremum of F over Omega, and its slope along A. Equation from (24), (34). Domain: "
     "Omega > 0, A > 0.",
     6, 2, 1, NULL, slow_flow_peak_loops},
    {"peak_Omega_A",
     "dOmega/dA along F_Omega = 0: what a rounding of A does to Omega at a peak. Equation from (34). Domain: Omega > "
     "0, A > 0.",
     5, 1, 1, NULL, slow_flow_peak_Omega_A_loops},
    {"Omega_A",
     "dOmega/dA along the response. Equation from (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_Omega_A_loops},
    {"level_rise",
     "Positive where the level rises with A along the fold locus, negative where it falls. Equation from (24), (30). "
     "Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, slow_flow_level_rise_loops},
    {"cusp_bend",
     "Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum. Equation from "
     "(24), (30). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, slow_flow_cusp_bend_loops},
    {"isola_bend",
     "The same at an isola point. Equation from (24), (30). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, slow_flow_isola_bend_loops},
    {"hessian",
     "F_AA F_OmegaOmega - F_AOmega^2: negative at a saddle. Equation from (24). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, slow_flow_hessian_loops},
    {"tail",
     "An amplitude of the size of that far above resonance. Equation from (24). Domain: Omega > 0, F_0 >= m.",
     3, 1, 1, NULL, slow_flow_tail_loops},
    {"most_restoring",
     "The largest |h| of a state with this amplitude: F_0 + (A Omega)^2/A at the highest Omega. Equation from (23). "
     "Domain: A > 0, F_0 >= m, zeta > 0.",
     4, 1, 1, NULL, slow_flow_most_restoring_loops},
    {"least_restoring",
     "The |h| of a state at Omega = 0, and the least |h - A h_A| of a fold. Equation from (24), (30). Domain: F_0 >= "
     "m.",
     2, 1, 1, NULL, slow_flow_least_restoring_loops},
};

const sf_module sf_module_slow_flow = {"slow_flow", kernels, sizeof kernels / sizeof kernels[0]};
