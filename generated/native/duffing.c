/* Duffing oscillator: one cubic piece, no breakpoint: loops for NumPy.

   Written by `make derive`; never edit.
   Input: duffing.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "duffing.h"

#include "kernels.h"

static SF_WIDE void duffing_averaged_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    n = SF_WHOLE(n);
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

static SF_WIDE void duffing_averaged_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
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

static SF_WIDE void duffing_averaged_H_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i]};
        double values[2];
        duffing_averaged_H(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static const sf_loop duffing_averaged_H_loops[] = {
    duffing_averaged_H_loop,
};

static SF_WIDE void duffing_intercept_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_intercept(A[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_intercept_loops[] = {
    duffing_intercept_loop,
};

static SF_WIDE void duffing_harmonics_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
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

static SF_WIDE void duffing_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
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

static SF_WIDE void duffing_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
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

static SF_WIDE void duffing_force_force_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = duffing_force_1(u[i], alpha[i], beta[i]);
    }
}

static const sf_loop duffing_force_loops[] = {
    duffing_force_force_1_loop,
};

static SF_WIDE void duffing_saddle_node_onset_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
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

static SF_WIDE void duffing_saddle_nodes_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
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
};

const sf_module sf_module_duffing = {"duffing", kernels, sizeof kernels / sizeof kernels[0]};
