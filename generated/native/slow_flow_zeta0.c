/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene zeta = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow_zeta0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow_zeta0.h"

#include "kernels.h"

static SF_WIDE void slow_flow_zeta0_I_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_zeta0_I(Omega, A, m, zeta);
    }
}

static const sf_loop slow_flow_zeta0_I_loops[] = {slow_flow_zeta0_I_loop};

static SF_WIDE void slow_flow_zeta0_F_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i];
        out[0][i] = slow_flow_zeta0_F(Omega, A, F_0, m, zeta, h);
    }
}

static const sf_loop slow_flow_zeta0_F_loops[] = {slow_flow_zeta0_F_loop};

static SF_WIDE void slow_flow_zeta0_F_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_zeta0_F_A(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_zeta0_F_A_loops[] = {slow_flow_zeta0_F_A_loop};

static SF_WIDE void slow_flow_zeta0_F_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i];
        out[0][i] = slow_flow_zeta0_F_AA(Omega, A, m, zeta, h, h_A, h_AA);
    }
}

static const sf_loop slow_flow_zeta0_F_AA_loops[] = {slow_flow_zeta0_F_AA_loop};

static SF_WIDE void slow_flow_zeta0_F_Omega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_zeta0_F_Omega(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_zeta0_F_Omega_loops[] = {slow_flow_zeta0_F_Omega_loop};

static SF_WIDE void slow_flow_zeta0_F_AOmega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_zeta0_F_AOmega(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_zeta0_F_AOmega_loops[] = {slow_flow_zeta0_F_AOmega_loop};

static SF_WIDE void slow_flow_zeta0_phase_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_zeta0_phase(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_zeta0_phase_loops[] = {slow_flow_zeta0_phase_loop};

static SF_WIDE void slow_flow_zeta0_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_zeta0_limit_envelope(Omega, F_0, m, zeta);
    }
}

static const sf_loop slow_flow_zeta0_limit_envelope_loops[] = {slow_flow_zeta0_limit_envelope_loop};

static SF_WIDE void slow_flow_zeta0_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_zeta0_equivalent_damping(Omega, A, m, zeta);
    }
}

static const sf_loop slow_flow_zeta0_equivalent_damping_loops[] = {slow_flow_zeta0_equivalent_damping_loop};

static SF_WIDE void slow_flow_zeta0_stability_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_zeta0_stability(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_zeta0_stability_loops[] = {slow_flow_zeta0_stability_loop};

static SF_WIDE void slow_flow_zeta0_response_quartic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        double values[4];
        slow_flow_zeta0_response_quartic(A, F_0, m, zeta, h, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_zeta0_response_quartic_loops[] = {slow_flow_zeta0_response_quartic_loop};

static SF_WIDE void slow_flow_zeta0_fold_quartic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i];
        double values[4];
        slow_flow_zeta0_fold_quartic(A, m, zeta, h, h_A, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_zeta0_fold_quartic_loops[] = {slow_flow_zeta0_fold_quartic_loop};

static SF_WIDE void slow_flow_zeta0_peak_cubic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
        double values[3];
        slow_flow_zeta0_peak_cubic(A, m, zeta, h, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_zeta0_peak_cubic_loops[] = {slow_flow_zeta0_peak_cubic_loop};

static SF_WIDE void slow_flow_zeta0_detachment_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
        double values[3];
        slow_flow_zeta0_detachment(A, m, zeta, h, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_zeta0_detachment_loops[] = {slow_flow_zeta0_detachment_loop};

static SF_WIDE void slow_flow_zeta0_level_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_zeta0_level(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_zeta0_level_loops[] = {slow_flow_zeta0_level_loop};

static SF_WIDE void slow_flow_zeta0_undamped_Omega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double h_A = in[0][i];
        out[0][i] = slow_flow_zeta0_undamped_Omega(h_A);
    }
}

static const sf_loop slow_flow_zeta0_undamped_Omega_loops[] = {slow_flow_zeta0_undamped_Omega_loop};

static SF_WIDE void slow_flow_zeta0_fold_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double F_0 = in[0][i], m = in[1][i], k = in[2][i], k_A = in[3][i];
        double values[2];
        slow_flow_zeta0_fold(F_0, m, k, k_A, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_zeta0_fold_loops[] = {slow_flow_zeta0_fold_loop};

static SF_WIDE void slow_flow_zeta0_undamped_level_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double m = in[0][i], k = in[1][i];
        out[0][i] = slow_flow_zeta0_undamped_level(m, k);
    }
}

static const sf_loop slow_flow_zeta0_undamped_level_loops[] = {slow_flow_zeta0_undamped_level_loop};

static SF_WIDE void slow_flow_zeta0_undamped_rises_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double h_AA = in[0][i], h_AAA = in[1][i], k = in[2][i];
        double values[2];
        slow_flow_zeta0_undamped_rises(h_AA, h_AAA, k, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_zeta0_undamped_rises_loops[] = {slow_flow_zeta0_undamped_rises_loop};

static SF_WIDE void slow_flow_zeta0_undamped_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], h = in[1][i], h_A = in[2][i], h_AA = in[3][i], h_AAA = in[4][i];
        double values[4];
        slow_flow_zeta0_undamped(A, h, h_A, h_AA, h_AAA, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_zeta0_undamped_loops[] = {slow_flow_zeta0_undamped_loop};

static const sf_kernel kernels[] = {
    {"I",
     "Sine balance, -F_0 sin phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     4, 1, 1, NULL, slow_flow_zeta0_I_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_zeta0_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_zeta0_F_A_loops},
    {"F_AA",
     "d2F/dA2. Equation (24), (33). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, slow_flow_zeta0_F_AA_loops},
    {"F_Omega",
     "dF/dOmega. Equation (24), (34). Domain: Omega > 0, A > 0.",
     5, 1, 1, NULL, slow_flow_zeta0_F_Omega_loops},
    {"F_AOmega",
     "d2F/dA dOmega. Equation (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_zeta0_F_AOmega_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     5, 1, 1, NULL, slow_flow_zeta0_phase_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, slow_flow_zeta0_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, slow_flow_zeta0_equivalent_damping_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_zeta0_stability_loops},
    {"response_quartic",
     "F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24). Domain: A > 0.",
     5, 4, 1, NULL, slow_flow_zeta0_response_quartic_loops},
    {"fold_quartic",
     "F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24), (30). Domain: A > "
     "0.",
     5, 4, 1, NULL, slow_flow_zeta0_fold_quartic_loops},
    {"peak_cubic",
     "F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3. Equation (34). Domain: A > 0.",
     4, 3, 1, NULL, slow_flow_zeta0_peak_cubic_loops},
    {"detachment",
     "Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr. "
     "Equation (34). Domain: A > 0.",
     4, 3, 1, NULL, slow_flow_zeta0_detachment_loops},
    {"level",
     "The forcing F_0 for which (Omega, A) is a steady state. Equation (24). Domain: Omega >= 0, A > 0.",
     5, 1, 1, NULL, slow_flow_zeta0_level_loops},
    {"undamped_Omega",
     "Omega of the folds. Equation from (30). Domain: h_A <= 0.",
     1, 1, 1, NULL, slow_flow_zeta0_undamped_Omega_loops},
    {"fold",
     "Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A. Equation "
     "from (24), (30). Domain: F_0 > m.",
     4, 2, 1, NULL, slow_flow_zeta0_fold_loops},
    {"undamped_level",
     "The forcing of a fold, whose R is k. Equation from (24), (30). Domain: h_A <= 0.",
     2, 1, 1, NULL, slow_flow_zeta0_undamped_level_loops},
    {"undamped_rises",
     "The sign of the level's slope along A on the undamped folds; and, where that is 0, of the slope's own. "
     "Equation from (24), (30). Domain: h_A <= 0.",
     3, 2, 1, NULL, slow_flow_zeta0_undamped_rises_loops},
    {"undamped",
     "The factors of F_AA/2 at the folds, each with its slope along A: h_AA, R. Equation from (30), (33). Domain: A "
     "> 0.",
     5, 4, 1, NULL, slow_flow_zeta0_undamped_loops},
};

const sf_module sf_module_slow_flow_zeta0 = {"slow_flow_zeta0", kernels, sizeof kernels / sizeof kernels[0]};
