/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring.h"

#include "kernels.h"

static SF_WIDE void rod_spring_averaged_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_0(A, p, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_averaged_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_1(A, p, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_averaged_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_1_far_1(A, p, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_averaged_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[0], *u_cr_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_averaged_loops[] = {
    rod_spring_averaged_passed_0_loop, rod_spring_averaged_passed_1_loop, rod_spring_averaged_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_averaged_2_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_0(A, p, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_averaged_2_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_1(A, p, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_averaged_2_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_averaged_2_loops[] = {
    rod_spring_averaged_2_passed_0_loop, rod_spring_averaged_2_passed_1_loop,
    rod_spring_averaged_2_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_averaged_H_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_0(A, p, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_averaged_H_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_1(A, p, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_averaged_H_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_1_far_1(A, p, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_averaged_H_loops[] = {
    rod_spring_averaged_H_passed_0_loop, rod_spring_averaged_H_passed_1_loop,
    rod_spring_averaged_H_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_intercept_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
        out[0][i] = rod_spring_intercept_passed_0(A, alpha, beta, gamma, u_cr);
    }
}

static SF_WIDE void rod_spring_intercept_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
        out[0][i] = rod_spring_intercept_passed_1(A, alpha, beta, gamma, u_cr);
    }
}

static SF_WIDE void rod_spring_intercept_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
        out[0][i] = rod_spring_intercept_passed_1_far_1(A, alpha, beta, gamma, u_cr);
    }
}

static const sf_loop rod_spring_intercept_loops[] = {
    rod_spring_intercept_passed_0_loop, rod_spring_intercept_passed_1_loop, rod_spring_intercept_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_harmonics_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[8];
        rod_spring_harmonics_passed_0(A, p, values);
        for (int k = 0; k < 8; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_harmonics_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[8];
        rod_spring_harmonics_passed_1(A, p, values);
        for (int k = 0; k < 8; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_harmonics_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[8];
        rod_spring_harmonics_passed_1_far_1(A, p, values);
        for (int k = 0; k < 8; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_harmonics_loops[] = {
    rod_spring_harmonics_passed_0_loop, rod_spring_harmonics_passed_1_loop, rod_spring_harmonics_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double lam = in[0][i], r = in[1][i], delta_h = in[2][i];
        double values[4];
        rod_spring_coefficients(lam, r, delta_h, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_coefficients_loops[] = {rod_spring_coefficients_loop};

static SF_WIDE void rod_spring_breakpoints_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double p[] = {in[0][i], in[1][i], in[2][i], in[3][i]};
        double values[1];
        rod_spring_breakpoints(p, values);
        for (int k = 0; k < 1; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_breakpoints_loops[] = {rod_spring_breakpoints_loop};

static SF_WIDE void rod_spring_jumps_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double p[] = {in[0][i], in[1][i], in[2][i], in[3][i]};
        double values[1];
        rod_spring_jumps(p, values);
        for (int k = 0; k < 1; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_jumps_loops[] = {rod_spring_jumps_loop};

static SF_WIDE void rod_spring_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double p[] = {in[0][i], in[1][i], in[2][i], in[3][i]};
        double values[3];
        rod_spring_hardening(p, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_hardening_loops[] = {rod_spring_hardening_loop};

static SF_WIDE void rod_spring_force_force_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double u = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
        out[0][i] = rod_spring_force_1(u, alpha, beta, gamma, u_cr);
    }
}

static SF_WIDE void rod_spring_force_force_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double u = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
        out[0][i] = rod_spring_force_2(u, alpha, beta, gamma, u_cr);
    }
}

static SF_WIDE void rod_spring_force_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *u_ = in[0], *u_cr_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double u = u_[i], u_cr = u_cr_[i];
        regime[i] = fabs(u) <= u_cr ? 0 : 1;
    }
}

static const sf_loop rod_spring_force_loops[] = {
    rod_spring_force_force_1_loop, rod_spring_force_force_2_loop
};

static SF_WIDE void rod_spring_saddle_node_onset_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double m = in[0][i], zeta = in[1][i];
        const double p[] = {in[2][i], in[3][i], in[4][i], in[5][i]};
        double values[19];
        rod_spring_saddle_node_onset(m, zeta, p, values);
        for (int k = 0; k < 19; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_saddle_node_onset_loops[] = {rod_spring_saddle_node_onset_loop};

static SF_WIDE void rod_spring_saddle_nodes_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double F_0 = in[0][i], m = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double values[17];
        rod_spring_saddle_nodes(F_0, m, zeta, p, values);
        for (int k = 0; k < 17; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_saddle_nodes_loops[] = {rod_spring_saddle_nodes_loop};

static SF_WIDE void rod_spring_h_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_0(A, p, values);
        out[0][i] = values[0];
    }
}

static SF_WIDE void rod_spring_h_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_1(A, p, values);
        out[0][i] = values[0];
    }
}

static SF_WIDE void rod_spring_h_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, values);
        out[0][i] = values[0];
    }
}

static const sf_loop rod_spring_h_loops[] = {
    rod_spring_h_passed_0_loop, rod_spring_h_passed_1_loop, rod_spring_h_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_h_A_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_0(A, p, values);
        out[0][i] = values[1];
    }
}

static SF_WIDE void rod_spring_h_A_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_1(A, p, values);
        out[0][i] = values[1];
    }
}

static SF_WIDE void rod_spring_h_A_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, values);
        out[0][i] = values[1];
    }
}

static const sf_loop rod_spring_h_A_loops[] = {
    rod_spring_h_A_passed_0_loop, rod_spring_h_A_passed_1_loop, rod_spring_h_A_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_h_AA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_0(A, p, values);
        out[0][i] = values[2];
    }
}

static SF_WIDE void rod_spring_h_AA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_1(A, p, values);
        out[0][i] = values[2];
    }
}

static SF_WIDE void rod_spring_h_AA_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_1_far_1(A, p, values);
        out[0][i] = values[2];
    }
}

static const sf_loop rod_spring_h_AA_loops[] = {
    rod_spring_h_AA_passed_0_loop, rod_spring_h_AA_passed_1_loop, rod_spring_h_AA_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_h_AAA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_0(A, p, values);
        out[0][i] = values[3];
    }
}

static SF_WIDE void rod_spring_h_AAA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_1(A, p, values);
        out[0][i] = values[3];
    }
}

static SF_WIDE void rod_spring_h_AAA_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_1_far_1(A, p, values);
        out[0][i] = values[3];
    }
}

static const sf_loop rod_spring_h_AAA_loops[] = {
    rod_spring_h_AAA_passed_0_loop, rod_spring_h_AAA_passed_1_loop, rod_spring_h_AAA_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_H_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_0(A, p, values);
        out[0][i] = values[0];
    }
}

static SF_WIDE void rod_spring_H_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_1(A, p, values);
        out[0][i] = values[0];
    }
}

static SF_WIDE void rod_spring_H_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_1_far_1(A, p, values);
        out[0][i] = values[0];
    }
}

static const sf_loop rod_spring_H_loops[] = {
    rod_spring_H_passed_0_loop, rod_spring_H_passed_1_loop, rod_spring_H_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_H_A_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_0(A, p, values);
        out[0][i] = values[1];
    }
}

static SF_WIDE void rod_spring_H_A_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_1(A, p, values);
        out[0][i] = values[1];
    }
}

static SF_WIDE void rod_spring_H_A_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[2];
        rod_spring_averaged_H_passed_1_far_1(A, p, values);
        out[0][i] = values[1];
    }
}

static const sf_loop rod_spring_H_A_loops[] = {
    rod_spring_H_A_passed_0_loop, rod_spring_H_A_passed_1_loop, rod_spring_H_A_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_H_AA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_0(A, p, values);
        out[0][i] = values[2];
    }
}

static SF_WIDE void rod_spring_H_AA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_1(A, p, values);
        out[0][i] = values[2];
    }
}

static SF_WIDE void rod_spring_H_AA_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double values[4];
        rod_spring_averaged_passed_1_far_1(A, p, values);
        out[0][i] = values[2];
    }
}

static const sf_loop rod_spring_H_AA_loops[] = {
    rod_spring_H_AA_passed_0_loop, rod_spring_H_AA_passed_1_loop, rod_spring_H_AA_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_F_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
        const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        out[0][i] = slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_F_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
        const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        out[0][i] = slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_F_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
        const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        out[0][i] = slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_F_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[1], *u_cr_ = in[8];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_F_loops[] = {
    rod_spring_F_passed_0_loop, rod_spring_F_passed_1_loop, rod_spring_F_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_F_A_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        out[0][i] = slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
    }
}

static SF_WIDE void rod_spring_F_A_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        out[0][i] = slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
    }
}

static SF_WIDE void rod_spring_F_A_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        out[0][i] = slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
    }
}

static SF_WIDE void rod_spring_F_A_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[1], *u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_F_A_loops[] = {
    rod_spring_F_A_passed_0_loop, rod_spring_F_A_passed_1_loop, rod_spring_F_A_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_level_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        out[0][i] = slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_level_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        out[0][i] = slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_level_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        out[0][i] = slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
    }
}

static const sf_loop rod_spring_level_loops[] = {
    rod_spring_level_passed_0_loop, rod_spring_level_passed_1_loop, rod_spring_level_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_phase_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        out[0][i] = slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_phase_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        out[0][i] = slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_phase_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        out[0][i] = slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
    }
}

static const sf_loop rod_spring_phase_loops[] = {
    rod_spring_phase_passed_0_loop, rod_spring_phase_passed_1_loop, rod_spring_phase_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_jacobian_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        double values[4];
        slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_jacobian_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        double values[4];
        slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_jacobian_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        double values[4];
        slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_jacobian_loops[] = {
    rod_spring_jacobian_passed_0_loop, rod_spring_jacobian_passed_1_loop, rod_spring_jacobian_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_stability_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        out[0][i] = slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
    }
}

static SF_WIDE void rod_spring_stability_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        out[0][i] = slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
    }
}

static SF_WIDE void rod_spring_stability_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        out[0][i] = slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
    }
}

static const sf_loop rod_spring_stability_loops[] = {
    rod_spring_stability_passed_0_loop, rod_spring_stability_passed_1_loop, rod_spring_stability_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_transmissibility_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
        const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        out[0][i] = slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_transmissibility_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
        const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        out[0][i] = slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
    }
}

static SF_WIDE void rod_spring_transmissibility_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
        const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        out[0][i] = slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
    }
}

static const sf_loop rod_spring_transmissibility_loops[] = {
    rod_spring_transmissibility_passed_0_loop, rod_spring_transmissibility_passed_1_loop,
    rod_spring_transmissibility_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_backbone_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        out[0][i] = slow_flow_backbone(A, average[0]);
    }
}

static SF_WIDE void rod_spring_backbone_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        out[0][i] = slow_flow_backbone(A, average[0]);
    }
}

static SF_WIDE void rod_spring_backbone_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        out[0][i] = slow_flow_backbone(A, average[0]);
    }
}

static const sf_loop rod_spring_backbone_loops[] = {
    rod_spring_backbone_passed_0_loop, rod_spring_backbone_passed_1_loop, rod_spring_backbone_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
    }
}

static const sf_loop rod_spring_limit_envelope_loops[] = {rod_spring_limit_envelope_loop};

static SF_WIDE void rod_spring_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
    }
}

static const sf_loop rod_spring_equivalent_damping_loops[] = {rod_spring_equivalent_damping_loop};

static SF_WIDE void rod_spring_response_quartic_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        double values[4];
        slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_response_quartic_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        double values[4];
        slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_response_quartic_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
        const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        double values[4];
        slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_response_quartic_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[0], *u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_response_quartic_loops[] = {
    rod_spring_response_quartic_passed_0_loop, rod_spring_response_quartic_passed_1_loop,
    rod_spring_response_quartic_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_fold_quartic_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        double values[4];
        slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_fold_quartic_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        double values[4];
        slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_fold_quartic_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        double values[4];
        slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_fold_quartic_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[0], *u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.05 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_fold_quartic_loops[] = {
    rod_spring_fold_quartic_passed_0_loop, rod_spring_fold_quartic_passed_1_loop,
    rod_spring_fold_quartic_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_peak_cubic_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        double values[3];
        slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_peak_cubic_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        double values[3];
        slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_peak_cubic_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        double values[3];
        slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_peak_cubic_loops[] = {
    rod_spring_peak_cubic_passed_0_loop, rod_spring_peak_cubic_passed_1_loop,
    rod_spring_peak_cubic_passed_1_far_1_loop
};

static SF_WIDE void rod_spring_detachment_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_0(A, p, average);
        double values[4];
        slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_detachment_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_1(A, p, average);
        double values[4];
        slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_detachment_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
        const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
        double average[2];
        rod_spring_averaged_2_passed_1_far_1(A, p, average);
        double values[4];
        slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_detachment_loops[] = {
    rod_spring_detachment_passed_0_loop, rod_spring_detachment_passed_1_loop,
    rod_spring_detachment_passed_1_far_1_loop
};

static const sf_kernel kernels[] = {
    {"averaged",
     "h, h_A, h_AA, h_AAA together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 4, 3, rod_spring_averaged_regime, rod_spring_averaged_loops},
    {"averaged_2",
     "h, h_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 2, 3, rod_spring_averaged_regime, rod_spring_averaged_2_loops},
    {"averaged_H",
     "H, H_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 2, 3, rod_spring_averaged_regime, rod_spring_averaged_H_loops},
    {"intercept",
     "h - A h_A, where the tangent of h meets A = 0; linear terms are none. Equation (20)-(22), (31). Domain: A >= "
     "0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_intercept_loops},
    {"harmonics",
     "Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA. "
     "Equation beyond (20). Domain: A >= 0.",
     5, 8, 3, rod_spring_averaged_regime, rod_spring_harmonics_loops},
    {"coefficients",
     "The parameters alpha, beta, gamma, u_cr from the design. Equation (5), (7). Domain: any design.",
     3, 4, 1, NULL, rod_spring_coefficients_loops},
    {"breakpoints",
     "The |u| at which a piece of the force ends. Equation (5). Domain: any parameters.",
     4, 1, 1, NULL, rod_spring_breakpoints_loops},
    {"jumps",
     "What the force loses at each breakpoint: f below less f above. Equation (6). Domain: any parameters.",
     4, 1, 1, NULL, rod_spring_jumps_loops},
    {"hardening",
     "The force over the displacement, f(u)/u, rises with |u| where none of these is negative. Equation from (3). "
     "Domain: any parameters.",
     4, 3, 1, NULL, rod_spring_hardening_loops},
    {"force",
     "Whole dimensionless restoring force u + F_k(u), truncated. Equation (3), (6). Domain: any u.",
     5, 1, 2, rod_spring_force_regime, rod_spring_force_loops},
    {"saddle_node_onset",
     "Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset. "
     "Equation (33). Domain: roots with 0 < A <= u_cr.",
     6, 19, 1, NULL, rod_spring_saddle_node_onset_loops},
    {"saddle_nodes",
     "Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds. Equation "
     "from (24), (30). Domain: roots with 0 < A <= u_cr.",
     7, 17, 1, NULL, rod_spring_saddle_nodes_loops},
    {"h",
     "The averaged restoring force h = H - A. Equation (20)-(22). Domain: A >= 0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_h_loops},
    {"h_A",
     "d/dA of the averaged restoring force h = H - A. Equation (31). Domain: A >= 0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_h_A_loops},
    {"h_AA",
     "d2/dA2 of the averaged restoring force h = H - A. Equation from (31). Domain: A >= 0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_h_AA_loops},
    {"h_AAA",
     "d3/dA3 of the averaged restoring force h = H - A. Equation from (31). Domain: A >= 0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_h_AAA_loops},
    {"H",
     "The averaged force H beside the vertical spring. Equation (20)-(22). Domain: A >= 0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_H_loops},
    {"H_A",
     "d/dA of the averaged force H beside the vertical spring. Equation (31). Domain: A >= 0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_H_A_loops},
    {"H_AA",
     "d2/dA2 of the averaged force H beside the vertical spring. Equation from (31). Domain: A >= 0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_H_AA_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     9, 1, 3, rod_spring_F_regime, rod_spring_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_F_A_regime, rod_spring_F_A_loops},
    {"level",
     "The forcing F_0 for which (Omega, A) is a steady state. Equation (24). Domain: Omega >= 0, A > 0.",
     8, 1, 3, rod_spring_F_A_regime, rod_spring_level_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_F_A_regime, rod_spring_phase_loops},
    {"jacobian",
     "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22. Equation (28). Domain: Omega > 0, A "
     "> 0.",
     8, 4, 3, rod_spring_F_A_regime, rod_spring_jacobian_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_F_A_regime, rod_spring_stability_loops},
    {"transmissibility",
     "Fundamental harmonic of the force on the base over F_0, at a steady state. Equation from (23). Domain: Omega > "
     "0, A > 0, F_0 > 0.",
     9, 1, 3, rod_spring_F_regime, rod_spring_transmissibility_loops},
    {"backbone",
     "Frequency on the backbone. Equation (26). Domain: A > 0, h <= 0.",
     5, 1, 3, rod_spring_averaged_regime, rod_spring_backbone_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, rod_spring_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, rod_spring_equivalent_damping_loops},
    {"response_quartic",
     "F as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24). Domain: A > 0.",
     8, 4, 3, rod_spring_response_quartic_regime, rod_spring_response_quartic_loops},
    {"fold_quartic",
     "F_A/2 as a polynomial in Omega: coefficients of 1, Omega, Omega^2, Omega^4. Equation (24), (30). Domain: A > "
     "0.",
     7, 4, 3, rod_spring_fold_quartic_regime, rod_spring_fold_quartic_loops},
    {"peak_cubic",
     "F_Omega/(4 A) as a polynomial in Omega: coefficients of 1, Omega, Omega^3. Equation (34). Domain: A > 0.",
     7, 3, 3, rod_spring_fold_quartic_regime, rod_spring_peak_cubic_loops},
    {"detachment",
     "Reduced resultant of F and F_Omega: coefficients of F_0^0, F_0^2, ...; its roots are candidates for F_cr. "
     "Equation (34). Domain: A > 0.",
     7, 4, 3, rod_spring_fold_quartic_regime, rod_spring_detachment_loops},
};

const sf_module sf_module_rod_spring = {"rod_spring", kernels, sizeof kernels / sizeof kernels[0]};
