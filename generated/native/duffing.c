/* Duffing oscillator: one cubic piece, no breakpoint: loops for NumPy.

   Written by `make derive`; never edit.
   Input: duffing.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "duffing.h"

#include "kernels.h"

static SF_WIDE void duffing_averaged_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[4];
        duffing_averaged(A, p, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_averaged_loops[] = {duffing_averaged_loop};

static SF_WIDE void duffing_averaged_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[2];
        duffing_averaged_2(A, p, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_averaged_2_loops[] = {duffing_averaged_2_loop};

static SF_WIDE void duffing_averaged_H_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[2];
        duffing_averaged_H(A, p, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_averaged_H_loops[] = {duffing_averaged_H_loop};

static SF_WIDE void duffing_intercept_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], alpha = in[1][i], beta = in[2][i];
        out[0][i] = duffing_intercept(A, alpha, beta);
    }
}

static const sf_loop duffing_intercept_loops[] = {duffing_intercept_loop};

static SF_WIDE void duffing_harmonics_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[8];
        duffing_harmonics(A, p, values);
        for (int k = 0; k < 8; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_harmonics_loops[] = {duffing_harmonics_loop};

static SF_WIDE void duffing_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double alpha = in[0][i], beta = in[1][i];
        double values[2];
        duffing_coefficients(alpha, beta, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_coefficients_loops[] = {duffing_coefficients_loop};

static SF_WIDE void duffing_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double p[] = {in[0][i], in[1][i]};
        double values[1];
        duffing_hardening(p, values);
        for (int k = 0; k < 1; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_hardening_loops[] = {duffing_hardening_loop};

static SF_WIDE void duffing_force_force_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double u = in[0][i], alpha = in[1][i], beta = in[2][i];
        out[0][i] = duffing_force_1(u, alpha, beta);
    }
}

static const sf_loop duffing_force_loops[] = {duffing_force_force_1_loop};

static SF_WIDE void duffing_saddle_node_onset_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double m = in[0][i], zeta = in[1][i];
        const double p[] = {in[2][i], in[3][i]};
        double values[11];
        duffing_saddle_node_onset(m, zeta, p, values);
        for (int k = 0; k < 11; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_saddle_node_onset_loops[] = {duffing_saddle_node_onset_loop};

static SF_WIDE void duffing_saddle_nodes_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double F_0 = in[0][i], m = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i]};
        double values[11];
        duffing_saddle_nodes(F_0, m, zeta, p, values);
        for (int k = 0; k < 11; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_saddle_nodes_loops[] = {duffing_saddle_nodes_loop};

static SF_WIDE void duffing_h_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[2];
        duffing_averaged_2(A, p, values);
        out[0][i] = values[0];
    }
}

static const sf_loop duffing_h_loops[] = {duffing_h_loop};

static SF_WIDE void duffing_h_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[2];
        duffing_averaged_2(A, p, values);
        out[0][i] = values[1];
    }
}

static const sf_loop duffing_h_A_loops[] = {duffing_h_A_loop};

static SF_WIDE void duffing_h_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[4];
        duffing_averaged(A, p, values);
        out[0][i] = values[2];
    }
}

static const sf_loop duffing_h_AA_loops[] = {duffing_h_AA_loop};

static SF_WIDE void duffing_h_AAA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[4];
        duffing_averaged(A, p, values);
        out[0][i] = values[3];
    }
}

static const sf_loop duffing_h_AAA_loops[] = {duffing_h_AAA_loop};

static SF_WIDE void duffing_H_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[2];
        duffing_averaged_H(A, p, values);
        out[0][i] = values[0];
    }
}

static const sf_loop duffing_H_loops[] = {duffing_H_loop};

static SF_WIDE void duffing_H_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[2];
        duffing_averaged_H(A, p, values);
        out[0][i] = values[1];
    }
}

static const sf_loop duffing_H_A_loops[] = {duffing_H_A_loop};

static SF_WIDE void duffing_H_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double values[4];
        duffing_averaged(A, p, values);
        out[0][i] = values[2];
    }
}

static const sf_loop duffing_H_AA_loops[] = {duffing_H_AA_loop};

static SF_WIDE void duffing_F_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
        const double p[] = {in[5][i], in[6][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        out[0][i] = slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
    }
}

static const sf_loop duffing_F_loops[] = {duffing_F_loop};

static SF_WIDE void duffing_F_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        out[0][i] = slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
    }
}

static const sf_loop duffing_F_A_loops[] = {duffing_F_A_loop};

static SF_WIDE void duffing_level_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        out[0][i] = slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
    }
}

static const sf_loop duffing_level_loops[] = {duffing_level_loop};

static SF_WIDE void duffing_phase_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        out[0][i] = slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
    }
}

static const sf_loop duffing_phase_loops[] = {duffing_phase_loop};

static SF_WIDE void duffing_jacobian_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        double values[4];
        slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_jacobian_loops[] = {duffing_jacobian_loop};

static SF_WIDE void duffing_stability_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        out[0][i] = slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
    }
}

static const sf_loop duffing_stability_loops[] = {duffing_stability_loop};

static SF_WIDE void duffing_transmissibility_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
        const double p[] = {in[5][i], in[6][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        out[0][i] = slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
    }
}

static const sf_loop duffing_transmissibility_loops[] = {duffing_transmissibility_loop};

static SF_WIDE void duffing_backbone_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        out[0][i] = slow_flow_backbone(A, average[0]);
    }
}

static const sf_loop duffing_backbone_loops[] = {duffing_backbone_loop};

static SF_WIDE void duffing_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
    }
}

static const sf_loop duffing_limit_envelope_loops[] = {duffing_limit_envelope_loop};

static SF_WIDE void duffing_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
    }
}

static const sf_loop duffing_equivalent_damping_loops[] = {duffing_equivalent_damping_loop};

static SF_WIDE void duffing_response_quartic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        double values[4];
        slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_response_quartic_loops[] = {duffing_response_quartic_loop};

static SF_WIDE void duffing_fold_quartic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        double values[4];
        slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_fold_quartic_loops[] = {duffing_fold_quartic_loop};

static SF_WIDE void duffing_peak_cubic_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        double values[3];
        slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_peak_cubic_loops[] = {duffing_peak_cubic_loop};

static SF_WIDE void duffing_detachment_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i]};
        double average[2];
        duffing_averaged_2(A, p, average);
        double values[4];
        slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop duffing_detachment_loops[] = {duffing_detachment_loop};

static const sf_kernel kernels[] = {
    {"averaged",
     "h, h_A, h_AA, h_AAA together. Equation (20)-(22), (31). Domain: A >= 0.",
     3, 4, 1, NULL, duffing_averaged_loops},
    {"averaged_2",
     "h, h_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     3, 2, 1, NULL, duffing_averaged_2_loops},
    {"averaged_H",
     "H, H_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     3, 2, 1, NULL, duffing_averaged_H_loops},
    {"intercept",
     "h - A h_A, where the tangent of h meets A = 0; linear terms are none. Equation (20)-(22), (31). Domain: A >= "
     "0.",
     3, 1, 1, NULL, duffing_intercept_loops},
    {"harmonics",
     "Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA. "
     "Equation beyond (20). Domain: A >= 0.",
     3, 8, 1, NULL, duffing_harmonics_loops},
    {"coefficients",
     "The parameters alpha, beta from the design. Equation (5), (7). Domain: any design.",
     2, 2, 1, NULL, duffing_coefficients_loops},
    {"hardening",
     "The force over the displacement, f(u)/u, rises with |u| where none of these is negative. Equation from (3). "
     "Domain: any parameters.",
     2, 1, 1, NULL, duffing_hardening_loops},
    {"force",
     "Whole dimensionless restoring force u + F_k(u). Equation (3), (5). Domain: any u.",
     3, 1, 1, NULL, duffing_force_loops},
    {"saddle_node_onset",
     "Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset. "
     "Equation (33). Domain: roots with A > 0.",
     4, 11, 1, NULL, duffing_saddle_node_onset_loops},
    {"saddle_nodes",
     "Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds. Equation "
     "from (24), (30). Domain: roots with A > 0.",
     5, 11, 1, NULL, duffing_saddle_nodes_loops},
    {"h",
     "The averaged restoring force h = H - A. Equation (20)-(22). Domain: A >= 0.",
     3, 1, 1, NULL, duffing_h_loops},
    {"h_A",
     "d/dA of the averaged restoring force h = H - A. Equation (31). Domain: A >= 0.",
     3, 1, 1, NULL, duffing_h_A_loops},
    {"h_AA",
     "d2/dA2 of the averaged restoring force h = H - A. Equation from (31). Domain: A >= 0.",
     3, 1, 1, NULL, duffing_h_AA_loops},
    {"h_AAA",
     "d3/dA3 of the averaged restoring force h = H - A. Equation from (31). Domain: A >= 0.",
     3, 1, 1, NULL, duffing_h_AAA_loops},
    {"H",
     "The averaged force H beside the vertical spring. Equation (20)-(22). Domain: A >= 0.",
     3, 1, 1, NULL, duffing_H_loops},
    {"H_A",
     "d/dA of the averaged force H beside the vertical spring. Equation (31). Domain: A >= 0.",
     3, 1, 1, NULL, duffing_H_A_loops},
    {"H_AA",
     "d2/dA2 of the averaged force H beside the vertical spring. Equation from (31). Domain: A >= 0.",
     3, 1, 1, NULL, duffing_H_AA_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, duffing_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_F_A_loops},
    {"level",
     "The forcing F_0 for which (Omega, A) is a steady state. Equation (24). Domain: Omega >= 0, A > 0.",
     6, 1, 1, NULL, duffing_level_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_phase_loops},
    {"jacobian",
     "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22. Equation (28). Domain: Omega > 0, A "
     "> 0.",
     6, 4, 1, NULL, duffing_jacobian_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_stability_loops},
    {"transmissibility",
     "Fundamental harmonic of the force on the base over F_0, at a steady state. Equation from (23). Domain: Omega > "
     "0, A > 0, F_0 > 0.",
     7, 1, 1, NULL, duffing_transmissibility_loops},
    {"backbone",
     "Frequency on the backbone. Equation (26). Domain: A > 0, h <= 0.",
     3, 1, 1, NULL, duffing_backbone_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, duffing_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, duffing_equivalent_damping_loops},
    {"response_quartic",
     "F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24). Domain: A > 0.",
     6, 4, 1, NULL, duffing_response_quartic_loops},
    {"fold_quartic",
     "F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24), (30). Domain: A > "
     "0.",
     5, 4, 1, NULL, duffing_fold_quartic_loops},
    {"peak_cubic",
     "F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3. Equation (34). Domain: A > 0.",
     5, 3, 1, NULL, duffing_peak_cubic_loops},
    {"detachment",
     "Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr. "
     "Equation (34). Domain: A > 0.",
     5, 4, 1, NULL, duffing_detachment_loops},
};

const sf_module sf_module_duffing = {"duffing", kernels, sizeof kernels / sizeof kernels[0]};
