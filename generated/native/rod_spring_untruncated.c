/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring_untruncated.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring_untruncated.h"

#include "kernels.h"

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_0(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_0_steep(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1_far(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1_steep_far(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double p[] = {alpha[i], beta[i], u_cr[i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1_steep(A[i], p, values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_averaged_all_loops[] = {
    rod_spring_untruncated_averaged_all_passed_0_loop,
    rod_spring_untruncated_averaged_all_passed_0_steep_loop,
    rod_spring_untruncated_averaged_all_passed_1_far_loop,
    rod_spring_untruncated_averaged_all_passed_1_loop,
    rod_spring_untruncated_averaged_all_passed_1_steep_far_loop,
    rod_spring_untruncated_averaged_all_passed_1_steep_loop,
};

static SF_WIDE void rod_spring_untruncated_harmonics_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
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

static SF_WIDE void rod_spring_untruncated_harmonics_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
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
    n = SF_WHOLE(n);
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

static SF_WIDE void rod_spring_untruncated_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict lam = in[0];
    const double *restrict r = in[1];
    const double *restrict delta_h = in[2];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    n = SF_WHOLE(n);
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

static SF_WIDE void rod_spring_untruncated_breakpoints_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict u_cr = in[2];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
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

static SF_WIDE void rod_spring_untruncated_jumps_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict u_cr = in[2];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
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

static SF_WIDE void rod_spring_untruncated_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict alpha = in[0];
    const double *restrict beta = in[1];
    const double *restrict u_cr = in[2];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
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

static SF_WIDE void rod_spring_untruncated_force_force_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_force_1(u[i], alpha[i], beta[i], u_cr[i]);
    }
}

static SF_WIDE void rod_spring_untruncated_force_force_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict u = in[0];
    const double *restrict alpha = in[1];
    const double *restrict beta = in[2];
    const double *restrict u_cr = in[3];
    double *restrict out_0 = out[0];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        out_0[i] = rod_spring_untruncated_force_2(u[i], alpha[i], beta[i], u_cr[i]);
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
    rod_spring_untruncated_force_force_1_loop,
    rod_spring_untruncated_force_force_2_loop,
};

static const sf_kernel kernels[] = {
    {"averaged_all",
     "h, h_A, h_AA, h_AAA, H, H_A, h - A h_A together. Equation (20)-(22), (31). Domain: A >= 0; digits are lost for "
     "u_cr > 0.9998.",
     4, 7, 6, rod_spring_untruncated_averaged_all_regime, rod_spring_untruncated_averaged_all_loops},
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
};

const sf_module sf_module_rod_spring_untruncated = {"rod_spring_untruncated", kernels, sizeof kernels / sizeof kernels[0]};
