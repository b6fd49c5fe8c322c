/* Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: slow_flow_mu0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "slow_flow_mu0.h"

#include "kernels.h"

static SF_WIDE void slow_flow_mu0_I_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_mu0_I(Omega, A, m, zeta);
    }
}

static const sf_loop slow_flow_mu0_I_loops[] = {slow_flow_mu0_I_loop};

static SF_WIDE void slow_flow_mu0_F_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i];
        out[0][i] = slow_flow_mu0_F(Omega, A, F_0, m, zeta, h);
    }
}

static const sf_loop slow_flow_mu0_F_loops[] = {slow_flow_mu0_F_loop};

static SF_WIDE void slow_flow_mu0_F_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_mu0_F_A(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_mu0_F_A_loops[] = {slow_flow_mu0_F_A_loop};

static SF_WIDE void slow_flow_mu0_F_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i];
        out[0][i] = slow_flow_mu0_F_AA(Omega, A, m, zeta, h, h_A, h_AA);
    }
}

static const sf_loop slow_flow_mu0_F_AA_loops[] = {slow_flow_mu0_F_AA_loop};

static SF_WIDE void slow_flow_mu0_F_Omega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_mu0_F_Omega(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_mu0_F_Omega_loops[] = {slow_flow_mu0_F_Omega_loop};

static SF_WIDE void slow_flow_mu0_F_AOmega_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_mu0_F_AOmega(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_mu0_F_AOmega_loops[] = {slow_flow_mu0_F_AOmega_loop};

static SF_WIDE void slow_flow_mu0_phase_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_mu0_phase(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_mu0_phase_loops[] = {slow_flow_mu0_phase_loop};

static SF_WIDE void slow_flow_mu0_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_mu0_limit_envelope(Omega, F_0, m, zeta);
    }
}

static const sf_loop slow_flow_mu0_limit_envelope_loops[] = {slow_flow_mu0_limit_envelope_loop};

static SF_WIDE void slow_flow_mu0_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_mu0_equivalent_damping(Omega, A, m, zeta);
    }
}

static const sf_loop slow_flow_mu0_equivalent_damping_loops[] = {slow_flow_mu0_equivalent_damping_loop};

static SF_WIDE void slow_flow_mu0_stability_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = slow_flow_mu0_stability(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop slow_flow_mu0_stability_loops[] = {slow_flow_mu0_stability_loop};

static SF_WIDE void slow_flow_mu0_response_quartic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        double values[4];
        slow_flow_mu0_response_quartic(A, F_0, m, zeta, h, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_mu0_response_quartic_loops[] = {slow_flow_mu0_response_quartic_loop};

static SF_WIDE void slow_flow_mu0_fold_quartic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i];
        double values[4];
        slow_flow_mu0_fold_quartic(A, m, zeta, h, h_A, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_mu0_fold_quartic_loops[] = {slow_flow_mu0_fold_quartic_loop};

static SF_WIDE void slow_flow_mu0_peak_cubic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
        double values[3];
        slow_flow_mu0_peak_cubic(A, m, zeta, h, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_mu0_peak_cubic_loops[] = {slow_flow_mu0_peak_cubic_loop};

static SF_WIDE void slow_flow_mu0_detachment_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
        double values[3];
        slow_flow_mu0_detachment(A, m, zeta, h, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_mu0_detachment_loops[] = {slow_flow_mu0_detachment_loop};

static SF_WIDE void slow_flow_mu0_level_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = slow_flow_mu0_level(Omega, A, m, zeta, h);
    }
}

static const sf_loop slow_flow_mu0_level_loops[] = {slow_flow_mu0_level_loop};

static SF_WIDE void slow_flow_mu0_fold_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], k =
            in[6][i], k_A = in[7][i];
        double values[3];
        slow_flow_mu0_fold(A, F_0, m, zeta, h, h_A, k, k_A, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_mu0_fold_loops[] = {slow_flow_mu0_fold_loop};

static SF_WIDE void slow_flow_mu0_isola_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i], h_AA = in[5][i];
        double values[2];
        slow_flow_mu0_isola(A, m, zeta, h, h_A, h_AA, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop slow_flow_mu0_isola_loops[] = {slow_flow_mu0_isola_loop};

static const sf_kernel kernels[] = {
    {"I",
     "Sine balance, -F_0 sin phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     4, 1, 1, NULL, slow_flow_mu0_I_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_mu0_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_mu0_F_A_loops},
    {"F_AA",
     "d2F/dA2. Equation (24), (33). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, slow_flow_mu0_F_AA_loops},
    {"F_Omega",
     "dF/dOmega. Equation (24), (34). Domain: Omega > 0, A > 0.",
     5, 1, 1, NULL, slow_flow_mu0_F_Omega_loops},
    {"F_AOmega",
     "d2F/dA dOmega. Equation (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_mu0_F_AOmega_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     5, 1, 1, NULL, slow_flow_mu0_phase_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, slow_flow_mu0_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, slow_flow_mu0_equivalent_damping_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, slow_flow_mu0_stability_loops},
    {"response_quartic",
     "F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24). Domain: A > 0.",
     5, 4, 1, NULL, slow_flow_mu0_response_quartic_loops},
    {"fold_quartic",
     "F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24), (30). Domain: A > "
     "0.",
     5, 4, 1, NULL, slow_flow_mu0_fold_quartic_loops},
    {"peak_cubic",
     "F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3. Equation (34). Domain: A > 0.",
     4, 3, 1, NULL, slow_flow_mu0_peak_cubic_loops},
    {"detachment",
     "Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr. "
     "Equation (34). Domain: A > 0.",
     4, 3, 1, NULL, slow_flow_mu0_detachment_loops},
    {"level",
     "The forcing F_0 for which (Omega, A) is a steady state. Equation (24). Domain: Omega >= 0, A > 0.",
     5, 1, 1, NULL, slow_flow_mu0_level_loops},
    {"fold",
     "Zero at a fold at F_0: R of (23) less the R of F = F_A = 0; its slope along A, and Omega. Equation from (24), "
     "(30). Domain: A > 0, F_0 > m, k^2 >= F_0^2 - m^2.",
     8, 3, 1, NULL, slow_flow_mu0_fold_loops},
    {"isola",
     "Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A. "
     "Equation from (30), (34). Domain: A > 0, h_A > 0; for m = 0 any h_A.",
     6, 2, 1, NULL, slow_flow_mu0_isola_loops},
};

const sf_module sf_module_slow_flow_mu0 = {"slow_flow_mu0", kernels, sizeof kernels / sizeof kernels[0]};
