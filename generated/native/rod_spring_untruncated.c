/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring_untruncated.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring_untruncated.h"

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

SF_WIDE void rod_spring_untruncated_averaged_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[4];
        rod_spring_untruncated_averaged_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[4];
        rod_spring_untruncated_averaged_passed_0_steep(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[4];
        rod_spring_untruncated_averaged_passed_1_far(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[4];
        rod_spring_untruncated_averaged_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[4];
        rod_spring_untruncated_averaged_passed_1_steep_far(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[4];
        rod_spring_untruncated_averaged_passed_1_steep(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_averaged_loops[] = {
    rod_spring_untruncated_averaged_passed_0_loop,
    rod_spring_untruncated_averaged_passed_0_steep_loop,
    rod_spring_untruncated_averaged_passed_1_far_loop,
    rod_spring_untruncated_averaged_passed_1_loop,
    rod_spring_untruncated_averaged_passed_1_steep_far_loop,
    rod_spring_untruncated_averaged_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_averaged_3_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[3];
        rod_spring_untruncated_averaged_3_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_3_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[3];
        rod_spring_untruncated_averaged_3_passed_0_steep(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_3_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[3];
        rod_spring_untruncated_averaged_3_passed_1_far(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_3_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[3];
        rod_spring_untruncated_averaged_3_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_3_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[3];
        rod_spring_untruncated_averaged_3_passed_1_steep_far(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_3_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[3];
        rod_spring_untruncated_averaged_3_passed_1_steep(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_3_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_averaged_3_loops[] = {
    rod_spring_untruncated_averaged_3_passed_0_loop,
    rod_spring_untruncated_averaged_3_passed_0_steep_loop,
    rod_spring_untruncated_averaged_3_passed_1_far_loop,
    rod_spring_untruncated_averaged_3_passed_1_loop,
    rod_spring_untruncated_averaged_3_passed_1_steep_far_loop,
    rod_spring_untruncated_averaged_3_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_averaged_2_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[2];
        rod_spring_untruncated_averaged_2_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_2_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[2];
        rod_spring_untruncated_averaged_2_passed_0_steep(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_2_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[2];
        rod_spring_untruncated_averaged_2_passed_1_far(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_2_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[2];
        rod_spring_untruncated_averaged_2_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[2];
        rod_spring_untruncated_averaged_2_passed_1_steep_far(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

SF_WIDE void rod_spring_untruncated_averaged_2_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[2];
        rod_spring_untruncated_averaged_2_passed_1_steep(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_2_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_averaged_2_loops[] = {
    rod_spring_untruncated_averaged_2_passed_0_loop,
    rod_spring_untruncated_averaged_2_passed_0_steep_loop,
    rod_spring_untruncated_averaged_2_passed_1_far_loop,
    rod_spring_untruncated_averaged_2_passed_1_loop,
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop,
    rod_spring_untruncated_averaged_2_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_h_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_passed_0(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_passed_0_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_passed_1_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_passed_1(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_passed_1_steep_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_passed_1_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_h_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_h_loops[] = {
    rod_spring_untruncated_h_passed_0_loop,
    rod_spring_untruncated_h_passed_0_steep_loop,
    rod_spring_untruncated_h_passed_1_far_loop,
    rod_spring_untruncated_h_passed_1_loop,
    rod_spring_untruncated_h_passed_1_steep_far_loop,
    rod_spring_untruncated_h_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_h_A_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_A_passed_0(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_A_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_A_passed_0_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_A_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_A_passed_1_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_A_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_A_passed_1(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_A_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_A_passed_1_steep_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_A_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_A_passed_1_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_h_A_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_h_A_loops[] = {
    rod_spring_untruncated_h_A_passed_0_loop,
    rod_spring_untruncated_h_A_passed_0_steep_loop,
    rod_spring_untruncated_h_A_passed_1_far_loop,
    rod_spring_untruncated_h_A_passed_1_loop,
    rod_spring_untruncated_h_A_passed_1_steep_far_loop,
    rod_spring_untruncated_h_A_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_h_AA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AA_passed_0(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AA_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AA_passed_0_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AA_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AA_passed_1_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AA_passed_1(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AA_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AA_passed_1_steep_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AA_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AA_passed_1_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_h_AA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_h_AA_loops[] = {
    rod_spring_untruncated_h_AA_passed_0_loop,
    rod_spring_untruncated_h_AA_passed_0_steep_loop,
    rod_spring_untruncated_h_AA_passed_1_far_loop,
    rod_spring_untruncated_h_AA_passed_1_loop,
    rod_spring_untruncated_h_AA_passed_1_steep_far_loop,
    rod_spring_untruncated_h_AA_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_h_AAA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AAA_passed_0(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AAA_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AAA_passed_0_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AAA_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AAA_passed_1_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AAA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AAA_passed_1(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AAA_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AAA_passed_1_steep_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_h_AAA_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_h_AAA_passed_1_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_h_AAA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_h_AAA_loops[] = {
    rod_spring_untruncated_h_AAA_passed_0_loop,
    rod_spring_untruncated_h_AAA_passed_0_steep_loop,
    rod_spring_untruncated_h_AAA_passed_1_far_loop,
    rod_spring_untruncated_h_AAA_passed_1_loop,
    rod_spring_untruncated_h_AAA_passed_1_steep_far_loop,
    rod_spring_untruncated_h_AAA_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_H_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_passed_0(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_passed_0_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_passed_1_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_passed_1(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_passed_1_steep_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_passed_1_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_H_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_H_loops[] = {
    rod_spring_untruncated_H_passed_0_loop,
    rod_spring_untruncated_H_passed_0_steep_loop,
    rod_spring_untruncated_H_passed_1_far_loop,
    rod_spring_untruncated_H_passed_1_loop,
    rod_spring_untruncated_H_passed_1_steep_far_loop,
    rod_spring_untruncated_H_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_H_A_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_A_passed_0(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_A_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_A_passed_0_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_A_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_A_passed_1_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_A_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_A_passed_1(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_A_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_A_passed_1_steep_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_A_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_A_passed_1_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_H_A_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_H_A_loops[] = {
    rod_spring_untruncated_H_A_passed_0_loop,
    rod_spring_untruncated_H_A_passed_0_steep_loop,
    rod_spring_untruncated_H_A_passed_1_far_loop,
    rod_spring_untruncated_H_A_passed_1_loop,
    rod_spring_untruncated_H_A_passed_1_steep_far_loop,
    rod_spring_untruncated_H_A_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_H_AA_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_AA_passed_0(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_AA_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_AA_passed_0_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_AA_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_AA_passed_1_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_AA_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_AA_passed_1(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_AA_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_AA_passed_1_steep_far(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_H_AA_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_H_AA_passed_1_steep(A[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_H_AA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_H_AA_loops[] = {
    rod_spring_untruncated_H_AA_passed_0_loop,
    rod_spring_untruncated_H_AA_passed_0_steep_loop,
    rod_spring_untruncated_H_AA_passed_1_far_loop,
    rod_spring_untruncated_H_AA_passed_1_loop,
    rod_spring_untruncated_H_AA_passed_1_steep_far_loop,
    rod_spring_untruncated_H_AA_passed_1_steep_loop,
};

SF_WIDE void rod_spring_untruncated_harmonics_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
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
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[8];
        rod_spring_untruncated_harmonics_passed_0(A[i], p, values);
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

SF_WIDE void rod_spring_untruncated_harmonics_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict A = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
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
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[8];
        rod_spring_untruncated_harmonics_passed_1(A[i], p, values);
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

static SF_WIDE void rod_spring_untruncated_harmonics_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr ? 0 : 1;
    }
}

static const sf_loop rod_spring_untruncated_harmonics_loops[] = {
    rod_spring_untruncated_harmonics_passed_0_loop,
    rod_spring_untruncated_harmonics_passed_1_loop,
};

SF_WIDE void rod_spring_untruncated_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict lam = in[0];
    const double *restrict r = in[1];
    const double *restrict delta_h = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        double values[3];
        rod_spring_untruncated_coefficients(lam[i], r[i], delta_h[i], values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

static const sf_loop rod_spring_untruncated_coefficients_loops[] = {
    rod_spring_untruncated_coefficients_loop,
};

SF_WIDE void rod_spring_untruncated_breakpoints_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict u_cr = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[1];
        rod_spring_untruncated_breakpoints(p, values);
        out_0[i] = values[0];
    }
}

static const sf_loop rod_spring_untruncated_breakpoints_loops[] = {
    rod_spring_untruncated_breakpoints_loop,
};

SF_WIDE void rod_spring_untruncated_jumps_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict u_cr = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[1];
        rod_spring_untruncated_jumps(p, values);
        out_0[i] = values[0];
    }
}

static const sf_loop rod_spring_untruncated_jumps_loops[] = {
    rod_spring_untruncated_jumps_loop,
};

SF_WIDE void rod_spring_untruncated_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict u_cr = in[2];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[1];
        rod_spring_untruncated_hardening(p, values);
        out_0[i] = values[0];
    }
}

static const sf_loop rod_spring_untruncated_hardening_loops[] = {
    rod_spring_untruncated_hardening_loop,
};

SF_WIDE void rod_spring_untruncated_force_piece_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_force_piece_1(u[i], alpha[i], beta[i], u_cr[i]);
    }
}

SF_WIDE void rod_spring_untruncated_force_piece_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_force_piece_2(u[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_force_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict u_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double u = u_[i];
        const double u_cr = u_cr_[i];
        regime[i] = fabs(u) <= u_cr ? 0 : 1;
    }
}

static const sf_loop rod_spring_untruncated_force_loops[] = {
    rod_spring_untruncated_force_piece_1_loop,
    rod_spring_untruncated_force_piece_2_loop,
};

static void rod_spring_untruncated_R_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_R_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_R_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_R_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_R_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_R_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_R_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_R_loops[] = {
    rod_spring_untruncated_R_chain_0,
    rod_spring_untruncated_R_chain_1,
    rod_spring_untruncated_R_chain_2,
    rod_spring_untruncated_R_chain_3,
    rod_spring_untruncated_R_chain_4,
    rod_spring_untruncated_R_chain_5,
};

static void rod_spring_untruncated_I_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_I_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_untruncated_I_loops[] = {
    rod_spring_untruncated_I_chain_0,
};

static void rod_spring_untruncated_F_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_F_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_F_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_F_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_F_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_F_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_F_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_F_loops[] = {
    rod_spring_untruncated_F_chain_0,
    rod_spring_untruncated_F_chain_1,
    rod_spring_untruncated_F_chain_2,
    rod_spring_untruncated_F_chain_3,
    rod_spring_untruncated_F_chain_4,
    rod_spring_untruncated_F_chain_5,
};

static void rod_spring_untruncated_F_A_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_A_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_A_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_A_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_A_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_A_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_untruncated_F_A_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_F_A_loops[] = {
    rod_spring_untruncated_F_A_chain_0,
    rod_spring_untruncated_F_A_chain_1,
    rod_spring_untruncated_F_A_chain_2,
    rod_spring_untruncated_F_A_chain_3,
    rod_spring_untruncated_F_A_chain_4,
    rod_spring_untruncated_F_A_chain_5,
};

static void rod_spring_untruncated_F_AA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_F_AA_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_F_AA_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_F_AA_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_F_AA_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_F_AA_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static SF_WIDE void rod_spring_untruncated_F_AA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_F_AA_loops[] = {
    rod_spring_untruncated_F_AA_chain_0,
    rod_spring_untruncated_F_AA_chain_1,
    rod_spring_untruncated_F_AA_chain_2,
    rod_spring_untruncated_F_AA_chain_3,
    rod_spring_untruncated_F_AA_chain_4,
    rod_spring_untruncated_F_AA_chain_5,
};

static void rod_spring_untruncated_F_AAA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_F_AAA_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_F_AAA_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_F_AAA_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_F_AAA_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_F_AAA_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static SF_WIDE void rod_spring_untruncated_F_AAA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_F_AAA_loops[] = {
    rod_spring_untruncated_F_AAA_chain_0,
    rod_spring_untruncated_F_AAA_chain_1,
    rod_spring_untruncated_F_AAA_chain_2,
    rod_spring_untruncated_F_AAA_chain_3,
    rod_spring_untruncated_F_AAA_chain_4,
    rod_spring_untruncated_F_AAA_chain_5,
};

static void rod_spring_untruncated_F_Omega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_F_Omega_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_F_Omega_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_F_Omega_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_F_Omega_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_F_Omega_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_F_Omega_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_F_Omega_loops[] = {
    rod_spring_untruncated_F_Omega_chain_0,
    rod_spring_untruncated_F_Omega_chain_1,
    rod_spring_untruncated_F_Omega_chain_2,
    rod_spring_untruncated_F_Omega_chain_3,
    rod_spring_untruncated_F_Omega_chain_4,
    rod_spring_untruncated_F_Omega_chain_5,
};

static void rod_spring_untruncated_F_AOmega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_AOmega_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_AOmega_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_AOmega_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_AOmega_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_F_AOmega_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_untruncated_F_AOmega_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_F_AOmega_loops[] = {
    rod_spring_untruncated_F_AOmega_chain_0,
    rod_spring_untruncated_F_AOmega_chain_1,
    rod_spring_untruncated_F_AOmega_chain_2,
    rod_spring_untruncated_F_AOmega_chain_3,
    rod_spring_untruncated_F_AOmega_chain_4,
    rod_spring_untruncated_F_AOmega_chain_5,
};

static void rod_spring_untruncated_phase_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_phase_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_phase_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_phase_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_phase_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_phase_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_phase_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_phase_loops[] = {
    rod_spring_untruncated_phase_chain_0,
    rod_spring_untruncated_phase_chain_1,
    rod_spring_untruncated_phase_chain_2,
    rod_spring_untruncated_phase_chain_3,
    rod_spring_untruncated_phase_chain_4,
    rod_spring_untruncated_phase_chain_5,
};

static void rod_spring_untruncated_jacobian_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_jacobian_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_jacobian_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_jacobian_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_jacobian_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_jacobian_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_untruncated_jacobian_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_jacobian_loops[] = {
    rod_spring_untruncated_jacobian_chain_0,
    rod_spring_untruncated_jacobian_chain_1,
    rod_spring_untruncated_jacobian_chain_2,
    rod_spring_untruncated_jacobian_chain_3,
    rod_spring_untruncated_jacobian_chain_4,
    rod_spring_untruncated_jacobian_chain_5,
};

static void rod_spring_untruncated_stability_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_stability_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_stability_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_stability_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_stability_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_stability_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_untruncated_stability_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[6];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_stability_loops[] = {
    rod_spring_untruncated_stability_chain_0,
    rod_spring_untruncated_stability_chain_1,
    rod_spring_untruncated_stability_chain_2,
    rod_spring_untruncated_stability_chain_3,
    rod_spring_untruncated_stability_chain_4,
    rod_spring_untruncated_stability_chain_5,
};

static void rod_spring_untruncated_transmissibility_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_transmissibility_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_transmissibility_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_transmissibility_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_transmissibility_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_transmissibility_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_transmissibility_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[1];
    const double *restrict u_cr_ = in[7];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_transmissibility_loops[] = {
    rod_spring_untruncated_transmissibility_chain_0,
    rod_spring_untruncated_transmissibility_chain_1,
    rod_spring_untruncated_transmissibility_chain_2,
    rod_spring_untruncated_transmissibility_chain_3,
    rod_spring_untruncated_transmissibility_chain_4,
    rod_spring_untruncated_transmissibility_chain_5,
};

static void rod_spring_untruncated_backbone_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_backbone_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_backbone_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_backbone_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_backbone_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_backbone_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_backbone_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    const double *restrict A_ = in[0];
    const double *restrict u_cr_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i];
        const double u_cr = u_cr_[i];
        regime[i] = A <= u_cr && A <= 0.69999999999999996 ? 0 : A <= u_cr ? 1 : u_cr <= 0.75 && 1.05 * u_cr <= A ? 2 : u_cr <= 0.75 ? 3 : 1.05 * u_cr <= A ? 4 : 5;
    }
}

static const sf_loop rod_spring_untruncated_backbone_loops[] = {
    rod_spring_untruncated_backbone_chain_0,
    rod_spring_untruncated_backbone_chain_1,
    rod_spring_untruncated_backbone_chain_2,
    rod_spring_untruncated_backbone_chain_3,
    rod_spring_untruncated_backbone_chain_4,
    rod_spring_untruncated_backbone_chain_5,
};

static void rod_spring_untruncated_limit_envelope_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_limit_envelope_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_untruncated_limit_envelope_loops[] = {
    rod_spring_untruncated_limit_envelope_chain_0,
};

static void rod_spring_untruncated_equivalent_damping_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_equivalent_damping_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_untruncated_equivalent_damping_loops[] = {
    rod_spring_untruncated_equivalent_damping_chain_0,
};

static const sf_kernel kernels[] = {
    {"averaged",
     "h, h_A, h_AA, h_AAA together. Equation (20)-(22), (31). Domain: A >= 0.",
     4, 4, 6, rod_spring_untruncated_averaged_regime, rod_spring_untruncated_averaged_loops},
    {"averaged_3",
     "h, h_A, h_AA together. Equation (20)-(22), (31). Domain: A >= 0.",
     4, 3, 6, rod_spring_untruncated_averaged_3_regime, rod_spring_untruncated_averaged_3_loops},
    {"averaged_2",
     "h, h_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     4, 2, 6, rod_spring_untruncated_averaged_2_regime, rod_spring_untruncated_averaged_2_loops},
    {"h",
     "The averaged restoring force h = H - A. Equation (20)-(22). Domain: A >= 0.",
     4, 1, 6, rod_spring_untruncated_h_regime, rod_spring_untruncated_h_loops},
    {"h_A",
     "d/dA of the averaged restoring force h = H - A. Equation (31). Domain: A >= 0.",
     4, 1, 6, rod_spring_untruncated_h_A_regime, rod_spring_untruncated_h_A_loops},
    {"h_AA",
     "d2/dA2 of the averaged restoring force h = H - A. Equation from (31). Domain: A >= 0.",
     4, 1, 6, rod_spring_untruncated_h_AA_regime, rod_spring_untruncated_h_AA_loops},
    {"h_AAA",
     "d3/dA3 of the averaged restoring force h = H - A. Equation from (31). Domain: A >= 0.",
     4, 1, 6, rod_spring_untruncated_h_AAA_regime, rod_spring_untruncated_h_AAA_loops},
    {"H",
     "The averaged force H beside the vertical spring. Equation (20)-(22). Domain: A >= 0.",
     4, 1, 6, rod_spring_untruncated_H_regime, rod_spring_untruncated_H_loops},
    {"H_A",
     "d/dA of the averaged force H beside the vertical spring. Equation (31). Domain: A >= 0.",
     4, 1, 6, rod_spring_untruncated_H_A_regime, rod_spring_untruncated_H_A_loops},
    {"H_AA",
     "d2/dA2 of the averaged force H beside the vertical spring. Equation from (31). Domain: A >= 0.",
     4, 1, 6, rod_spring_untruncated_H_AA_regime, rod_spring_untruncated_H_AA_loops},
    {"harmonics",
     "Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA. "
     "Equation beyond (20). Domain: A >= 0, u_cr <= 3/4.",
     4, 8, 2, rod_spring_untruncated_harmonics_regime, rod_spring_untruncated_harmonics_loops},
    {"coefficients",
     "The parameters alpha, beta, u_cr from the design. Equation (5), (7). Domain: any design.",
     3, 3, 1, NULL, rod_spring_untruncated_coefficients_loops},
    {"breakpoints",
     "The |u| at which a piece of the force ends. Equation (5). Domain: any parameters.",
     3, 1, 1, NULL, rod_spring_untruncated_breakpoints_loops},
    {"jumps",
     "What the force loses at each breakpoint: f below less f above. Equation (5). Domain: any parameters.",
     3, 1, 1, NULL, rod_spring_untruncated_jumps_loops},
    {"hardening",
     "The force over the displacement, f(u)/u, rises with |u| where none of these is negative. Equation from (3). "
     "Domain: any parameters.",
     3, 1, 1, NULL, rod_spring_untruncated_hardening_loops},
    {"force",
     "Whole dimensionless restoring force u + F_k(u), untruncated. Equation (3), (5). Domain: |u| < 1.",
     4, 1, 2, rod_spring_untruncated_force_regime, rod_spring_untruncated_force_loops},
    {"R",
     "Cosine balance, -F_0 cos phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_R_regime, rod_spring_untruncated_R_loops},
    {"I",
     "Sine balance, -F_0 sin phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, rod_spring_untruncated_I_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     8, 1, 6, rod_spring_untruncated_F_regime, rod_spring_untruncated_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_F_A_regime, rod_spring_untruncated_F_A_loops},
    {"F_AA",
     "d2F/dA2. Equation (24), (33). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_F_AA_regime, rod_spring_untruncated_F_AA_loops},
    {"F_AAA",
     "d3F/dA3. Equation (24). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_F_AAA_regime, rod_spring_untruncated_F_AAA_loops},
    {"F_Omega",
     "dF/dOmega. Equation (24), (34). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_F_Omega_regime, rod_spring_untruncated_F_Omega_loops},
    {"F_AOmega",
     "d2F/dA dOmega. Equation (24). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_F_AOmega_regime, rod_spring_untruncated_F_AOmega_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_phase_regime, rod_spring_untruncated_phase_loops},
    {"jacobian",
     "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22. Equation (28). Domain: Omega > 0, A "
     "> 0.",
     7, 4, 6, rod_spring_untruncated_jacobian_regime, rod_spring_untruncated_jacobian_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_stability_regime, rod_spring_untruncated_stability_loops},
    {"transmissibility",
     "Fundamental harmonic of the force on the base over F_0, at a steady state. Equation from (23). Domain: Omega > "
     "0, A > 0, F_0 > 0.",
     8, 1, 6, rod_spring_untruncated_transmissibility_regime, rod_spring_untruncated_transmissibility_loops},
    {"backbone",
     "Frequency on the backbone. Equation (26). Domain: A > 0, h <= 0.",
     4, 1, 6, rod_spring_untruncated_backbone_regime, rod_spring_untruncated_backbone_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, rod_spring_untruncated_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, rod_spring_untruncated_equivalent_damping_loops},
};

const sf_module sf_module_rod_spring_untruncated = {"rod_spring_untruncated", kernels, sizeof kernels / sizeof kernels[0]};
