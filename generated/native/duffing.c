/* Duffing oscillator: one cubic piece, no breakpoint: loops for NumPy.

   Written by `make derive`; never edit.
   Input: duffing.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "duffing.h"

#include "kernels.h"

void slow_flow_F_AAA_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_AA_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_AOmega_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_A_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_Omega_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_F_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_I_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_R_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_backbone_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_friction_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_jacobian_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_phase_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_stability_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_transmissibility_loop(ptrdiff_t n, const double *const *in, double *const *out);

SF_WIDE void duffing_averaged_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i]};
        double values[4];
        duffing_averaged(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static const sf_loop duffing_averaged_loops[] = {
    duffing_averaged_loop,
};

SF_WIDE void duffing_averaged_3_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i]};
        double values[3];
        duffing_averaged_3(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

static const sf_loop duffing_averaged_3_loops[] = {
    duffing_averaged_3_loop,
};

SF_WIDE void duffing_averaged_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i]};
        double values[2];
        duffing_averaged_2(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static const sf_loop duffing_averaged_2_loops[] = {
    duffing_averaged_2_loop,
};

SF_WIDE void duffing_h_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_h(A[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_h_loops[] = {
    duffing_h_loop,
};

SF_WIDE void duffing_h_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_h_A(A[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_h_A_loops[] = {
    duffing_h_A_loop,
};

SF_WIDE void duffing_h_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_h_AA(A[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_h_AA_loops[] = {
    duffing_h_AA_loop,
};

SF_WIDE void duffing_h_AAA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_h_AAA(A[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_h_AAA_loops[] = {
    duffing_h_AAA_loop,
};

SF_WIDE void duffing_H_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_H(A[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_H_loops[] = {
    duffing_H_loop,
};

SF_WIDE void duffing_H_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_H_A(A[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_H_A_loops[] = {
    duffing_H_A_loop,
};

SF_WIDE void duffing_H_AA_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_H_AA(A[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_H_AA_loops[] = {
    duffing_H_AA_loop,
};

SF_WIDE void duffing_harmonics_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    double *restrict out_4 = out[4];
    double *restrict out_5 = out[5];
    double *restrict out_6 = out[6];
    double *restrict out_7 = out[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i]};
        double values[8];
        duffing_harmonics(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
        out_7[i] = values[7];
    }
}

static const sf_loop duffing_harmonics_loops[] = {
    duffing_harmonics_loop,
};

SF_WIDE void duffing_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        double values[2];
        duffing_coefficients(alpha[i], beta[i], values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static const sf_loop duffing_coefficients_loops[] = {
    duffing_coefficients_loop,
};

SF_WIDE void duffing_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i]};
        double values[1];
        duffing_hardening(p, values);
        out_0[i] = values[0];
    }
}

static const sf_loop duffing_hardening_loops[] = {
    duffing_hardening_loop,
};

SF_WIDE void duffing_force_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_force(u[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_force_loops[] = {
    duffing_force_loop,
};

SF_WIDE void duffing_saddle_node_onset_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict m = in[0];
    const double *restrict zeta = in[1];
    const double *restrict alpha = in[2];
    const double *restrict beta = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    double *restrict out_4 = out[4];
    double *restrict out_5 = out[5];
    double *restrict out_6 = out[6];
    double *restrict out_7 = out[7];
    double *restrict out_8 = out[8];
    double *restrict out_9 = out[9];
    double *restrict out_10 = out[10];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i]};
        double values[11];
        duffing_saddle_node_onset(m[i], zeta[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
        out_7[i] = values[7];
        out_8[i] = values[8];
        out_9[i] = values[9];
        out_10[i] = values[10];
    }
}

static const sf_loop duffing_saddle_node_onset_loops[] = {
    duffing_saddle_node_onset_loop,
};

SF_WIDE void duffing_saddle_nodes_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict F_0 = in[0];
    const double *restrict m = in[1];
    const double *restrict zeta = in[2];
    const double *restrict alpha = in[3];
    const double *restrict beta = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    double *restrict out_4 = out[4];
    double *restrict out_5 = out[5];
    double *restrict out_6 = out[6];
    double *restrict out_7 = out[7];
    double *restrict out_8 = out[8];
    double *restrict out_9 = out[9];
    double *restrict out_10 = out[10];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i]};
        double values[11];
        duffing_saddle_nodes(F_0[i], m[i], zeta[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
        out_7[i] = values[7];
        out_8[i] = values[8];
        out_9[i] = values[9];
        out_10[i] = values[10];
    }
}

static const sf_loop duffing_saddle_nodes_loops[] = {
    duffing_saddle_nodes_loop,
};

static void duffing_R_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    duffing_h_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static const sf_loop duffing_R_loops[] = {
    duffing_R_chain_0,
};

static void duffing_I_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_I_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop duffing_I_loops[] = {
    duffing_I_chain_0,
};

static void duffing_F_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    duffing_h_loop(n, (const double *[]){in[1], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static const sf_loop duffing_F_loops[] = {
    duffing_F_chain_0,
};

static void duffing_F_A_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    duffing_averaged_2_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static const sf_loop duffing_F_A_loops[] = {
    duffing_F_A_chain_0,
};

static void duffing_F_AA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    duffing_averaged_3_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static const sf_loop duffing_F_AA_loops[] = {
    duffing_F_AA_chain_0,
};

static void duffing_F_AAA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    duffing_averaged_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static const sf_loop duffing_F_AAA_loops[] = {
    duffing_F_AAA_chain_0,
};

static void duffing_F_Omega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    duffing_h_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static const sf_loop duffing_F_Omega_loops[] = {
    duffing_F_Omega_chain_0,
};

static void duffing_F_AOmega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    duffing_averaged_2_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static const sf_loop duffing_F_AOmega_loops[] = {
    duffing_F_AOmega_chain_0,
};

static void duffing_phase_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    duffing_h_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static const sf_loop duffing_phase_loops[] = {
    duffing_phase_chain_0,
};

static void duffing_jacobian_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    duffing_averaged_2_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static const sf_loop duffing_jacobian_loops[] = {
    duffing_jacobian_chain_0,
};

static void duffing_stability_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    duffing_averaged_2_loop(n, (const double *[]){in[1], in[4], in[5]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static const sf_loop duffing_stability_loops[] = {
    duffing_stability_chain_0,
};

static void duffing_transmissibility_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    duffing_h_loop(n, (const double *[]){in[1], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static const sf_loop duffing_transmissibility_loops[] = {
    duffing_transmissibility_chain_0,
};

static void duffing_backbone_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    duffing_h_loop(n, (const double *[]){in[0], in[1], in[2]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static const sf_loop duffing_backbone_loops[] = {
    duffing_backbone_chain_0,
};

static void duffing_limit_envelope_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_limit_envelope_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop duffing_limit_envelope_loops[] = {
    duffing_limit_envelope_chain_0,
};

static void duffing_equivalent_damping_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_equivalent_damping_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop duffing_equivalent_damping_loops[] = {
    duffing_equivalent_damping_chain_0,
};

static const sf_kernel kernels[] = {
    {"averaged",
     "h, h_A, h_AA, h_AAA together. Equation (20)-(22), (31). Domain: A >= 0.",
     3, 4, 1, NULL, duffing_averaged_loops},
    {"averaged_3",
     "h, h_A, h_AA together. Equation (20)-(22), (31). Domain: A >= 0.",
     3, 3, 1, NULL, duffing_averaged_3_loops},
    {"averaged_2",
     "h, h_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     3, 2, 1, NULL, duffing_averaged_2_loops},
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
     "Whole dimensionless restoring force u + F_k(u), truncated. Equation (3), (6). Domain: any u.",
     3, 1, 1, NULL, duffing_force_loops},
    {"saddle_node_onset",
     "Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset. "
     "Equation (33). Domain: roots with A > 0.",
     4, 11, 1, NULL, duffing_saddle_node_onset_loops},
    {"saddle_nodes",
     "Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds. Equation "
     "from (24), (30). Domain: roots with A > 0.",
     5, 11, 1, NULL, duffing_saddle_nodes_loops},
    {"R",
     "Cosine balance, -F_0 cos phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_R_loops},
    {"I",
     "Sine balance, -F_0 sin phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_I_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, duffing_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_F_A_loops},
    {"F_AA",
     "d2F/dA2. Equation (24), (33). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_F_AA_loops},
    {"F_AAA",
     "d3F/dA3. Equation (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_F_AAA_loops},
    {"F_Omega",
     "dF/dOmega. Equation (24), (34). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_F_Omega_loops},
    {"F_AOmega",
     "d2F/dA dOmega. Equation (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, duffing_F_AOmega_loops},
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
};

const sf_module sf_module_duffing = {"duffing", kernels, sizeof kernels / sizeof kernels[0]};
