/* Duffing oscillator: one cubic piece, no breakpoint: loops for NumPy.

   Written by `make derive`; never edit.
   Input: duffing.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "duffing.h"

#include "kernels.h"

SF_LOOP(duffing_averaged_loop, 4,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    duffing_averaged(A, p, values);
)

SF_LOOP(duffing_averaged_2_loop, 2,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    duffing_averaged_2(A, p, values);
)

SF_LOOP(duffing_averaged_H_loop, 2,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    duffing_averaged_H(A, p, values);
)

SF_LOOP(duffing_intercept_loop, 1,
    const double A = in[0][i], alpha = in[1][i], beta = in[2][i];
    values[0] = duffing_intercept(A, alpha, beta);
)

SF_LOOP(duffing_harmonics_loop, 8,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    duffing_harmonics(A, p, values);
)

SF_LOOP(duffing_coefficients_loop, 2,
    const double alpha = in[0][i], beta = in[1][i];
    duffing_coefficients(alpha, beta, values);
)

SF_LOOP(duffing_hardening_loop, 1,
    const double p[] = {in[0][i], in[1][i]};
    duffing_hardening(p, values);
)

SF_LOOP(duffing_force_force_1_loop, 1,
    const double u = in[0][i], alpha = in[1][i], beta = in[2][i];
    values[0] = duffing_force_1(u, alpha, beta);
)

SF_LOOP(duffing_saddle_node_onset_loop, 11,
    const double m = in[0][i], zeta = in[1][i];
    const double p[] = {in[2][i], in[3][i]};
    duffing_saddle_node_onset(m, zeta, p, values);
)

SF_LOOP(duffing_saddle_nodes_loop, 11,
    const double F_0 = in[0][i], m = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i]};
    duffing_saddle_nodes(F_0, m, zeta, p, values);
)

SF_LOOP(duffing_h_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    double all[2];
    duffing_averaged_2(A, p, all);
    values[0] = all[0];
)

SF_LOOP(duffing_h_A_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    double all[2];
    duffing_averaged_2(A, p, all);
    values[0] = all[1];
)

SF_LOOP(duffing_h_AA_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    double all[4];
    duffing_averaged(A, p, all);
    values[0] = all[2];
)

SF_LOOP(duffing_h_AAA_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    double all[4];
    duffing_averaged(A, p, all);
    values[0] = all[3];
)

SF_LOOP(duffing_H_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    double all[2];
    duffing_averaged_H(A, p, all);
    values[0] = all[0];
)

SF_LOOP(duffing_H_A_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    double all[2];
    duffing_averaged_H(A, p, all);
    values[0] = all[1];
)

SF_LOOP(duffing_H_AA_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    double all[4];
    duffing_averaged(A, p, all);
    values[0] = all[2];
)

SF_LOOP(duffing_F_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
    const double p[] = {in[5][i], in[6][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    values[0] = slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
)

SF_LOOP(duffing_F_A_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    values[0] = slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
)

SF_LOOP(duffing_level_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    values[0] = slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
)

SF_LOOP(duffing_phase_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    values[0] = slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
)

SF_LOOP(duffing_jacobian_loop, 4,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], values);
)

SF_LOOP(duffing_stability_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    values[0] = slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
)

SF_LOOP(duffing_transmissibility_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
    const double p[] = {in[5][i], in[6][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    values[0] = slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
)

SF_LOOP(duffing_backbone_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    values[0] = slow_flow_backbone(A, average[0]);
)

SF_LOOP(duffing_limit_envelope_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
)

SF_LOOP(duffing_equivalent_damping_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
)

SF_LOOP(duffing_response_quartic_loop, 4,
    const double A = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], values);
)

SF_LOOP(duffing_fold_quartic_loop, 4,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], values);
)

SF_LOOP(duffing_peak_cubic_loop, 3,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], values);
)

SF_LOOP(duffing_detachment_loop, 4,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i]};
    double average[2];
    duffing_averaged_2(A, p, average);
    slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], values);
)

static const sf_kernel kernels[] = {
    {"averaged", 3, 4, 1, NULL, SF_ONE(duffing_averaged_loop)},
    {"averaged_2", 3, 2, 1, NULL, SF_ONE(duffing_averaged_2_loop)},
    {"averaged_H", 3, 2, 1, NULL, SF_ONE(duffing_averaged_H_loop)},
    {"intercept", 3, 1, 1, NULL, SF_ONE(duffing_intercept_loop)},
    {"harmonics", 3, 8, 1, NULL, SF_ONE(duffing_harmonics_loop)},
    {"coefficients", 2, 2, 1, NULL, SF_ONE(duffing_coefficients_loop)},
    {"hardening", 2, 1, 1, NULL, SF_ONE(duffing_hardening_loop)},
    {"force", 3, 1, 1, NULL, SF_ONE(duffing_force_force_1_loop)},
    {"saddle_node_onset", 4, 11, 1, NULL, SF_ONE(duffing_saddle_node_onset_loop)},
    {"saddle_nodes", 5, 11, 1, NULL, SF_ONE(duffing_saddle_nodes_loop)},
    {"h", 3, 1, 1, NULL, SF_ONE(duffing_h_loop)},
    {"h_A", 3, 1, 1, NULL, SF_ONE(duffing_h_A_loop)},
    {"h_AA", 3, 1, 1, NULL, SF_ONE(duffing_h_AA_loop)},
    {"h_AAA", 3, 1, 1, NULL, SF_ONE(duffing_h_AAA_loop)},
    {"H", 3, 1, 1, NULL, SF_ONE(duffing_H_loop)},
    {"H_A", 3, 1, 1, NULL, SF_ONE(duffing_H_A_loop)},
    {"H_AA", 3, 1, 1, NULL, SF_ONE(duffing_H_AA_loop)},
    {"F", 7, 1, 1, NULL, SF_ONE(duffing_F_loop)},
    {"F_A", 6, 1, 1, NULL, SF_ONE(duffing_F_A_loop)},
    {"level", 6, 1, 1, NULL, SF_ONE(duffing_level_loop)},
    {"phase", 6, 1, 1, NULL, SF_ONE(duffing_phase_loop)},
    {"jacobian", 6, 4, 1, NULL, SF_ONE(duffing_jacobian_loop)},
    {"stability", 6, 1, 1, NULL, SF_ONE(duffing_stability_loop)},
    {"transmissibility", 7, 1, 1, NULL, SF_ONE(duffing_transmissibility_loop)},
    {"backbone", 3, 1, 1, NULL, SF_ONE(duffing_backbone_loop)},
    {"limit_envelope", 4, 1, 1, NULL, SF_ONE(duffing_limit_envelope_loop)},
    {"equivalent_damping", 4, 1, 1, NULL, SF_ONE(duffing_equivalent_damping_loop)},
    {"response_quartic", 6, 4, 1, NULL, SF_ONE(duffing_response_quartic_loop)},
    {"fold_quartic", 5, 4, 1, NULL, SF_ONE(duffing_fold_quartic_loop)},
    {"peak_cubic", 5, 3, 1, NULL, SF_ONE(duffing_peak_cubic_loop)},
    {"detachment", 5, 4, 1, NULL, SF_ONE(duffing_detachment_loop)},
};

const sf_module sf_module_duffing = {"duffing", kernels, sizeof kernels / sizeof kernels[0]};
