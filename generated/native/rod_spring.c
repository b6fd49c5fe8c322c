/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring.h"

#include "kernels.h"

static SF_WIDE void rod_spring_averaged_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[4];
        rod_spring_averaged_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static SF_WIDE void rod_spring_averaged_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[4];
        rod_spring_averaged_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static SF_WIDE void rod_spring_averaged_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[4];
        rod_spring_averaged_passed_1_far_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static SF_WIDE void rod_spring_averaged_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_averaged_loops[] = {
    rod_spring_averaged_passed_0_loop,
    rod_spring_averaged_passed_1_loop,
    rod_spring_averaged_passed_1_far_1_loop,
};

static SF_WIDE void rod_spring_averaged_2_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_averaged_2_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static SF_WIDE void rod_spring_averaged_2_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_averaged_2_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static SF_WIDE void rod_spring_averaged_2_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_averaged_2_passed_1_far_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static SF_WIDE void rod_spring_averaged_2_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_averaged_2_loops[] = {
    rod_spring_averaged_2_passed_0_loop,
    rod_spring_averaged_2_passed_1_loop,
    rod_spring_averaged_2_passed_1_far_1_loop,
};

static SF_WIDE void rod_spring_averaged_H_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_averaged_H_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static SF_WIDE void rod_spring_averaged_H_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_averaged_H_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static SF_WIDE void rod_spring_averaged_H_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_averaged_H_passed_1_far_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static SF_WIDE void rod_spring_averaged_H_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_averaged_H_loops[] = {
    rod_spring_averaged_H_passed_0_loop,
    rod_spring_averaged_H_passed_1_loop,
    rod_spring_averaged_H_passed_1_far_1_loop,
};

static SF_WIDE void rod_spring_intercept_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_intercept_passed_0(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_intercept_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_intercept_passed_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_intercept_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_intercept_passed_1_far_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_intercept_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_intercept_loops[] = {
    rod_spring_intercept_passed_0_loop,
    rod_spring_intercept_passed_1_loop,
    rod_spring_intercept_passed_1_far_1_loop,
};

static SF_WIDE void rod_spring_harmonics_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
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
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[8];
        rod_spring_harmonics_passed_0(A[i], p, values);
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

static SF_WIDE void rod_spring_harmonics_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
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
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[8];
        rod_spring_harmonics_passed_1(A[i], p, values);
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

static SF_WIDE void rod_spring_harmonics_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
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
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[8];
        rod_spring_harmonics_passed_1_far_1(A[i], p, values);
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

static SF_WIDE void rod_spring_harmonics_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_harmonics_loops[] = {
    rod_spring_harmonics_passed_0_loop,
    rod_spring_harmonics_passed_1_loop,
    rod_spring_harmonics_passed_1_far_1_loop,
};

static SF_WIDE void rod_spring_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict lam = in[0];
    const double *restrict r = in[1];
    const double *restrict delta_h = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        double values[4];
        rod_spring_coefficients(lam[i], r[i], delta_h[i], values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static const sf_loop rod_spring_coefficients_loops[] = {
    rod_spring_coefficients_loop,
};

static SF_WIDE void rod_spring_breakpoints_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict gamma = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[1];
        rod_spring_breakpoints(p, values);
        out_0[i] = values[0];
    }
}

static const sf_loop rod_spring_breakpoints_loops[] = {
    rod_spring_breakpoints_loop,
};

static SF_WIDE void rod_spring_jumps_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict gamma = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[1];
        rod_spring_jumps(p, values);
        out_0[i] = values[0];
    }
}

static const sf_loop rod_spring_jumps_loops[] = {
    rod_spring_jumps_loop,
};

static SF_WIDE void rod_spring_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict gamma = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[3];
        rod_spring_hardening(p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

static const sf_loop rod_spring_hardening_loops[] = {
    rod_spring_hardening_loop,
};

static SF_WIDE void rod_spring_force_force_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_force_1(u[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_force_force_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_force_2(u[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_force_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict u_ = in[0];
    const double *restrict u_cr_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double u = u_[i];
        const double u_cr = u_cr_[i];
        regime[i] = fabs(u) <= u_cr ? 0 : 1;
    }
}

static const sf_loop rod_spring_force_loops[] = {
    rod_spring_force_force_1_loop,
    rod_spring_force_force_2_loop,
};

static SF_WIDE void rod_spring_saddle_node_onset_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict m = in[0];
    const double *restrict zeta = in[1];
    const double *restrict alpha = in[2];
    const double *restrict beta = in[3];
    const double *restrict gamma = in[4];
    const double *restrict u_cr = in[5];
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
    double *restrict out_11 = out[11];
    double *restrict out_12 = out[12];
    double *restrict out_13 = out[13];
    double *restrict out_14 = out[14];
    double *restrict out_15 = out[15];
    double *restrict out_16 = out[16];
    double *restrict out_17 = out[17];
    double *restrict out_18 = out[18];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[19];
        rod_spring_saddle_node_onset(m[i], zeta[i], p, values);
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
        out_11[i] = values[11];
        out_12[i] = values[12];
        out_13[i] = values[13];
        out_14[i] = values[14];
        out_15[i] = values[15];
        out_16[i] = values[16];
        out_17[i] = values[17];
        out_18[i] = values[18];
    }
}

static const sf_loop rod_spring_saddle_node_onset_loops[] = {
    rod_spring_saddle_node_onset_loop,
};

static SF_WIDE void rod_spring_saddle_nodes_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict F_0 = in[0];
    const double *restrict m = in[1];
    const double *restrict zeta = in[2];
    const double *restrict alpha = in[3];
    const double *restrict beta = in[4];
    const double *restrict gamma = in[5];
    const double *restrict u_cr = in[6];
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
    double *restrict out_11 = out[11];
    double *restrict out_12 = out[12];
    double *restrict out_13 = out[13];
    double *restrict out_14 = out[14];
    double *restrict out_15 = out[15];
    double *restrict out_16 = out[16];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[17];
        rod_spring_saddle_nodes(F_0[i], m[i], zeta[i], p, values);
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
        out_11[i] = values[11];
        out_12[i] = values[12];
        out_13[i] = values[13];
        out_14[i] = values[14];
        out_15[i] = values[15];
        out_16[i] = values[16];
    }
}

static const sf_loop rod_spring_saddle_nodes_loops[] = {
    rod_spring_saddle_nodes_loop,
};

static const sf_kernel kernels[] = {
    {"averaged",
     "h, h_A, h_AA, h_AAA together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 4, 3, rod_spring_averaged_regime, rod_spring_averaged_loops},
    {"averaged_2",
     "h, h_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 2, 3, rod_spring_averaged_2_regime, rod_spring_averaged_2_loops},
    {"averaged_H",
     "H, H_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 2, 3, rod_spring_averaged_H_regime, rod_spring_averaged_H_loops},
    {"intercept",
     "h - A h_A, where the tangent of h meets A = 0; linear terms are none. Equation (20)-(22), (31). Domain: A >= "
     "0.",
     5, 1, 3, rod_spring_intercept_regime, rod_spring_intercept_loops},
    {"harmonics",
     "Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA. "
     "Equation beyond (20). Domain: A >= 0.",
     5, 8, 3, rod_spring_harmonics_regime, rod_spring_harmonics_loops},
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
};

const sf_module sf_module_rod_spring = {"rod_spring", kernels, sizeof kernels / sizeof kernels[0]};
