/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring.h"

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

SF_WIDE void rod_spring_averaged_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
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

SF_WIDE void rod_spring_averaged_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
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

SF_WIDE void rod_spring_averaged_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
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

SF_WIDE void rod_spring_averaged_3_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[3];
        rod_spring_averaged_3_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

SF_WIDE void rod_spring_averaged_3_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[3];
        rod_spring_averaged_3_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

SF_WIDE void rod_spring_averaged_3_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[3];
        rod_spring_averaged_3_passed_1_far_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

static SF_WIDE void rod_spring_averaged_3_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_averaged_3_loops[] = {
    rod_spring_averaged_3_passed_0_loop,
    rod_spring_averaged_3_passed_1_loop,
    rod_spring_averaged_3_passed_1_far_1_loop,
};

SF_WIDE void rod_spring_averaged_2_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_averaged_2_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

SF_WIDE void rod_spring_averaged_2_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[2];
        rod_spring_averaged_2_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

SF_WIDE void rod_spring_averaged_2_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
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

SF_WIDE void rod_spring_attached_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], gamma[i], u_cr[i]};
        double values[4];
        rod_spring_attached(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static const sf_loop rod_spring_attached_loops[] = {
    rod_spring_attached_loop,
};

SF_WIDE void rod_spring_h_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_passed_0(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_h_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_passed_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_h_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_passed_1_far_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_h_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_h_loops[] = {
    rod_spring_h_passed_0_loop,
    rod_spring_h_passed_1_loop,
    rod_spring_h_passed_1_far_1_loop,
};

SF_WIDE void rod_spring_h_A_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_A_passed_0(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_h_A_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_A_passed_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_h_A_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_A_passed_1_far_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_h_A_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_h_A_loops[] = {
    rod_spring_h_A_passed_0_loop,
    rod_spring_h_A_passed_1_loop,
    rod_spring_h_A_passed_1_far_1_loop,
};

SF_WIDE void rod_spring_h_AA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_AA_passed_0(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_h_AA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_AA_passed_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_h_AA_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_AA_passed_1_far_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_h_AA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_h_AA_loops[] = {
    rod_spring_h_AA_passed_0_loop,
    rod_spring_h_AA_passed_1_loop,
    rod_spring_h_AA_passed_1_far_1_loop,
};

SF_WIDE void rod_spring_h_AAA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_AAA_passed_0(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_h_AAA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_AAA_passed_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_h_AAA_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_h_AAA_passed_1_far_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_h_AAA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_h_AAA_loops[] = {
    rod_spring_h_AAA_passed_0_loop,
    rod_spring_h_AAA_passed_1_loop,
    rod_spring_h_AAA_passed_1_far_1_loop,
};

SF_WIDE void rod_spring_H_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_passed_0(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_H_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_passed_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_H_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_passed_1_far_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_H_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_H_loops[] = {
    rod_spring_H_passed_0_loop,
    rod_spring_H_passed_1_loop,
    rod_spring_H_passed_1_far_1_loop,
};

SF_WIDE void rod_spring_H_A_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_A_passed_0(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_H_A_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_A_passed_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_H_A_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_A_passed_1_far_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_H_A_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_H_A_loops[] = {
    rod_spring_H_A_passed_0_loop,
    rod_spring_H_A_passed_1_loop,
    rod_spring_H_A_passed_1_far_1_loop,
};

SF_WIDE void rod_spring_H_AA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_AA_passed_0(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_H_AA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_AA_passed_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_H_AA_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_H_AA_passed_1_far_1(A[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_H_AA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_H_AA_loops[] = {
    rod_spring_H_AA_passed_0_loop,
    rod_spring_H_AA_passed_1_loop,
    rod_spring_H_AA_passed_1_far_1_loop,
};

SF_WIDE void rod_spring_harmonics_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
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

SF_WIDE void rod_spring_harmonics_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
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

SF_WIDE void rod_spring_harmonics_passed_1_far_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
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

SF_WIDE void rod_spring_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict lam = in[0];
    const double *restrict r = in[1];
    const double *restrict delta_h = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
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

SF_WIDE void rod_spring_breakpoints_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict gamma = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
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

SF_WIDE void rod_spring_jumps_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict gamma = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
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

SF_WIDE void rod_spring_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict gamma = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
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

SF_WIDE void rod_spring_force_piece_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_force_piece_1(u[i], alpha[i], beta[i], gamma[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_force_piece_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict gamma = in[3];
    const double *restrict u_cr = in[4];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_force_piece_2(u[i], alpha[i], beta[i], gamma[i], u_cr[i]);
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
    rod_spring_force_piece_1_loop,
    rod_spring_force_piece_2_loop,
};

SF_WIDE void rod_spring_saddle_node_onset_loop(ptrdiff_t n, const double *const *in, double *const *out)
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

SF_WIDE void rod_spring_saddle_nodes_loop(ptrdiff_t n, const double *const *in, double *const *out)
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

static void rod_spring_R_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_R_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_R_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_h_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static SF_WIDE void rod_spring_R_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_R_loops[] = {
    rod_spring_R_chain_0,
    rod_spring_R_chain_1,
    rod_spring_R_chain_2,
};

static void rod_spring_I_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_I_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_I_loops[] = {
    rod_spring_I_chain_0,
};

static void rod_spring_F_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_h_passed_0_loop(n, (const double *[]){in[1], in[5], in[6], in[7], in[8]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_F_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_h_passed_1_loop(n, (const double *[]){in[1], in[5], in[6], in[7], in[8]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_F_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_h_passed_1_far_1_loop(n, (const double *[]){in[1], in[5], in[6], in[7], in[8]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static SF_WIDE void rod_spring_F_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[8];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_F_loops[] = {
    rod_spring_F_chain_0,
    rod_spring_F_chain_1,
    rod_spring_F_chain_2,
};

static void rod_spring_F_A_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_F_A_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_F_A_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_F_A_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_F_A_loops[] = {
    rod_spring_F_A_chain_0,
    rod_spring_F_A_chain_1,
    rod_spring_F_A_chain_2,
};

static void rod_spring_F_AA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_3_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_F_AA_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_3_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_F_AA_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_3_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static SF_WIDE void rod_spring_F_AA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_F_AA_loops[] = {
    rod_spring_F_AA_chain_0,
    rod_spring_F_AA_chain_1,
    rod_spring_F_AA_chain_2,
};

static void rod_spring_F_AAA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_F_AAA_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_F_AAA_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static SF_WIDE void rod_spring_F_AAA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_F_AAA_loops[] = {
    rod_spring_F_AAA_chain_0,
    rod_spring_F_AAA_chain_1,
    rod_spring_F_AAA_chain_2,
};

static void rod_spring_F_Omega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_F_Omega_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_F_Omega_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_h_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static SF_WIDE void rod_spring_F_Omega_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_F_Omega_loops[] = {
    rod_spring_F_Omega_chain_0,
    rod_spring_F_Omega_chain_1,
    rod_spring_F_Omega_chain_2,
};

static void rod_spring_F_AOmega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_F_AOmega_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_F_AOmega_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_F_AOmega_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_F_AOmega_loops[] = {
    rod_spring_F_AOmega_chain_0,
    rod_spring_F_AOmega_chain_1,
    rod_spring_F_AOmega_chain_2,
};

static void rod_spring_phase_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_phase_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_phase_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_h_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static SF_WIDE void rod_spring_phase_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_phase_loops[] = {
    rod_spring_phase_chain_0,
    rod_spring_phase_chain_1,
    rod_spring_phase_chain_2,
};

static void rod_spring_jacobian_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_jacobian_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_jacobian_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_jacobian_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_jacobian_loops[] = {
    rod_spring_jacobian_chain_0,
    rod_spring_jacobian_chain_1,
    rod_spring_jacobian_chain_2,
};

static void rod_spring_stability_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_stability_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_stability_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_averaged_2_passed_1_far_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6], in[7]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_stability_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_stability_loops[] = {
    rod_spring_stability_chain_0,
    rod_spring_stability_chain_1,
    rod_spring_stability_chain_2,
};

static void rod_spring_transmissibility_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_h_passed_0_loop(n, (const double *[]){in[1], in[5], in[6], in[7], in[8]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_transmissibility_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_h_passed_1_loop(n, (const double *[]){in[1], in[5], in[6], in[7], in[8]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_transmissibility_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_h_passed_1_far_1_loop(n, (const double *[]){in[1], in[5], in[6], in[7], in[8]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static SF_WIDE void rod_spring_transmissibility_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[8];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : A <= 1.25 * u_cr ? 1 : 2;
    }
}

static const sf_loop rod_spring_transmissibility_loops[] = {
    rod_spring_transmissibility_chain_0,
    rod_spring_transmissibility_chain_1,
    rod_spring_transmissibility_chain_2,
};

static void rod_spring_backbone_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_h_passed_0_loop(n, (const double *[]){in[0], in[1], in[2], in[3], in[4]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_backbone_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_h_passed_1_loop(n, (const double *[]){in[0], in[1], in[2], in[3], in[4]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_backbone_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_h_passed_1_far_1_loop(n, (const double *[]){in[0], in[1], in[2], in[3], in[4]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static SF_WIDE void rod_spring_backbone_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_backbone_loops[] = {
    rod_spring_backbone_chain_0,
    rod_spring_backbone_chain_1,
    rod_spring_backbone_chain_2,
};

static void rod_spring_limit_envelope_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_limit_envelope_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_limit_envelope_loops[] = {
    rod_spring_limit_envelope_chain_0,
};

static void rod_spring_equivalent_damping_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_equivalent_damping_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_equivalent_damping_loops[] = {
    rod_spring_equivalent_damping_chain_0,
};

static const sf_kernel kernels[] = {
    {"averaged",
     "h, h_A, h_AA, h_AAA together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 4, 3, rod_spring_averaged_regime, rod_spring_averaged_loops},
    {"averaged_3",
     "h, h_A, h_AA together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 3, 3, rod_spring_averaged_3_regime, rod_spring_averaged_3_loops},
    {"averaged_2",
     "h, h_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     5, 2, 3, rod_spring_averaged_2_regime, rod_spring_averaged_2_loops},
    {"attached",
     "The first piece alone: h, h_A, h_AA, h_AAA together. Equation (20), (21). Domain: 0 <= A <= u_cr.",
     5, 4, 1, NULL, rod_spring_attached_loops},
    {"h",
     "The averaged restoring force h = H - A. Equation (20)-(22). Domain: 0 <= A <= u_cr.",
     5, 1, 3, rod_spring_h_regime, rod_spring_h_loops},
    {"h_A",
     "d/dA of the averaged restoring force h = H - A. Equation (31). Domain: 0 <= A <= u_cr.",
     5, 1, 3, rod_spring_h_A_regime, rod_spring_h_A_loops},
    {"h_AA",
     "d2/dA2 of the averaged restoring force h = H - A. Equation from (31). Domain: 0 <= A <= u_cr.",
     5, 1, 3, rod_spring_h_AA_regime, rod_spring_h_AA_loops},
    {"h_AAA",
     "d3/dA3 of the averaged restoring force h = H - A. Equation from (31). Domain: 0 <= A <= u_cr.",
     5, 1, 3, rod_spring_h_AAA_regime, rod_spring_h_AAA_loops},
    {"H",
     "The averaged force H beside the vertical spring. Equation (20)-(22). Domain: 0 <= A <= u_cr.",
     5, 1, 3, rod_spring_H_regime, rod_spring_H_loops},
    {"H_A",
     "d/dA of the averaged force H beside the vertical spring. Equation (31). Domain: 0 <= A <= u_cr.",
     5, 1, 3, rod_spring_H_A_regime, rod_spring_H_A_loops},
    {"H_AA",
     "d2/dA2 of the averaged force H beside the vertical spring. Equation from (31). Domain: 0 <= A <= u_cr.",
     5, 1, 3, rod_spring_H_AA_regime, rod_spring_H_AA_loops},
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
    {"R",
     "Cosine balance, -F_0 cos phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_R_regime, rod_spring_R_loops},
    {"I",
     "Sine balance, -F_0 sin phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, rod_spring_I_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     9, 1, 3, rod_spring_F_regime, rod_spring_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_F_A_regime, rod_spring_F_A_loops},
    {"F_AA",
     "d2F/dA2. Equation (24), (33). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_F_AA_regime, rod_spring_F_AA_loops},
    {"F_AAA",
     "d3F/dA3. Equation (24). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_F_AAA_regime, rod_spring_F_AAA_loops},
    {"F_Omega",
     "dF/dOmega. Equation (24), (34). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_F_Omega_regime, rod_spring_F_Omega_loops},
    {"F_AOmega",
     "d2F/dA dOmega. Equation (24). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_F_AOmega_regime, rod_spring_F_AOmega_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_phase_regime, rod_spring_phase_loops},
    {"jacobian",
     "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22. Equation (28). Domain: Omega > 0, A "
     "> 0.",
     8, 4, 3, rod_spring_jacobian_regime, rod_spring_jacobian_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     8, 1, 3, rod_spring_stability_regime, rod_spring_stability_loops},
    {"transmissibility",
     "Fundamental harmonic of the force on the base over F_0, at a steady state. Equation from (23). Domain: Omega > "
     "0, A > 0, F_0 > 0.",
     9, 1, 3, rod_spring_transmissibility_regime, rod_spring_transmissibility_loops},
    {"backbone",
     "Frequency on the backbone. Equation (26). Domain: A > 0, h <= 0.",
     5, 1, 3, rod_spring_backbone_regime, rod_spring_backbone_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, rod_spring_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, rod_spring_equivalent_damping_loops},
};

const sf_module sf_module_rod_spring = {"rod_spring", kernels, sizeof kernels / sizeof kernels[0]};
