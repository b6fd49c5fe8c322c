/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated, in the scene mu = 0 and zeta = 0: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring_untruncated_mu0_zeta0.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring_untruncated_mu0_zeta0.h"

#include "kernels.h"

void rod_spring_untruncated_averaged_2_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_2_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_2_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_2_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_2_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_3_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_3_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_3_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_3_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_3_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_3_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_averaged_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_h_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_h_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_h_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_h_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_h_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out);
void rod_spring_untruncated_h_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_F_AAA_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_F_AA_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_F_AOmega_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_F_A_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_F_Omega_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_F_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_I_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_R_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_backbone_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_friction_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_jacobian_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_phase_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_stability_loop(ptrdiff_t n, const double *const *in, double *const *out);
void slow_flow_mu0_zeta0_transmissibility_loop(ptrdiff_t n, const double *const *in, double *const *out);

static void rod_spring_untruncated_mu0_zeta0_R_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_R_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_R_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_R_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_R_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_R_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_R_loop(n, (const double *[]){in[0], in[1], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_R_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_R_loops[] = {
    rod_spring_untruncated_mu0_zeta0_R_chain_0,
    rod_spring_untruncated_mu0_zeta0_R_chain_1,
    rod_spring_untruncated_mu0_zeta0_R_chain_2,
    rod_spring_untruncated_mu0_zeta0_R_chain_3,
    rod_spring_untruncated_mu0_zeta0_R_chain_4,
    rod_spring_untruncated_mu0_zeta0_R_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_I_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_mu0_zeta0_I_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_untruncated_mu0_zeta0_I_loops[] = {
    rod_spring_untruncated_mu0_zeta0_I_chain_0,
};

static void rod_spring_untruncated_mu0_zeta0_F_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_F_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_F_loops[] = {
    rod_spring_untruncated_mu0_zeta0_F_chain_0,
    rod_spring_untruncated_mu0_zeta0_F_chain_1,
    rod_spring_untruncated_mu0_zeta0_F_chain_2,
    rod_spring_untruncated_mu0_zeta0_F_chain_3,
    rod_spring_untruncated_mu0_zeta0_F_chain_4,
    rod_spring_untruncated_mu0_zeta0_F_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_F_A_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_A_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_A_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_A_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_A_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_A_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_A_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_F_A_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_F_A_loops[] = {
    rod_spring_untruncated_mu0_zeta0_F_A_chain_0,
    rod_spring_untruncated_mu0_zeta0_F_A_chain_1,
    rod_spring_untruncated_mu0_zeta0_F_A_chain_2,
    rod_spring_untruncated_mu0_zeta0_F_A_chain_3,
    rod_spring_untruncated_mu0_zeta0_F_A_chain_4,
    rod_spring_untruncated_mu0_zeta0_F_A_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_F_AA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_mu0_zeta0_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AA_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_mu0_zeta0_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AA_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_mu0_zeta0_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AA_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_mu0_zeta0_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AA_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_mu0_zeta0_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AA_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_3_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2});
    slow_flow_mu0_zeta0_F_AA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_F_AA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_F_AA_loops[] = {
    rod_spring_untruncated_mu0_zeta0_F_AA_chain_0,
    rod_spring_untruncated_mu0_zeta0_F_AA_chain_1,
    rod_spring_untruncated_mu0_zeta0_F_AA_chain_2,
    rod_spring_untruncated_mu0_zeta0_F_AA_chain_3,
    rod_spring_untruncated_mu0_zeta0_F_AA_chain_4,
    rod_spring_untruncated_mu0_zeta0_F_AA_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_F_AAA_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_mu0_zeta0_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AAA_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_mu0_zeta0_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AAA_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_mu0_zeta0_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AAA_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_mu0_zeta0_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AAA_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_mu0_zeta0_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AAA_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    double average_2[SF_BLOCK];
    double average_3[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1, average_2, average_3});
    slow_flow_mu0_zeta0_F_AAA_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1, average_2, average_3}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_F_AAA_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_F_AAA_loops[] = {
    rod_spring_untruncated_mu0_zeta0_F_AAA_chain_0,
    rod_spring_untruncated_mu0_zeta0_F_AAA_chain_1,
    rod_spring_untruncated_mu0_zeta0_F_AAA_chain_2,
    rod_spring_untruncated_mu0_zeta0_F_AAA_chain_3,
    rod_spring_untruncated_mu0_zeta0_F_AAA_chain_4,
    rod_spring_untruncated_mu0_zeta0_F_AAA_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_F_Omega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_Omega_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_Omega_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_Omega_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_Omega_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_Omega_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_F_Omega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_F_Omega_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_F_Omega_loops[] = {
    rod_spring_untruncated_mu0_zeta0_F_Omega_chain_0,
    rod_spring_untruncated_mu0_zeta0_F_Omega_chain_1,
    rod_spring_untruncated_mu0_zeta0_F_Omega_chain_2,
    rod_spring_untruncated_mu0_zeta0_F_Omega_chain_3,
    rod_spring_untruncated_mu0_zeta0_F_Omega_chain_4,
    rod_spring_untruncated_mu0_zeta0_F_Omega_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_F_AOmega_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_F_AOmega_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_F_AOmega_loops[] = {
    rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_0,
    rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_1,
    rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_2,
    rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_3,
    rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_4,
    rod_spring_untruncated_mu0_zeta0_F_AOmega_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_phase_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_phase_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_phase_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_phase_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_phase_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_phase_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_phase_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_phase_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_phase_loops[] = {
    rod_spring_untruncated_mu0_zeta0_phase_chain_0,
    rod_spring_untruncated_mu0_zeta0_phase_chain_1,
    rod_spring_untruncated_mu0_zeta0_phase_chain_2,
    rod_spring_untruncated_mu0_zeta0_phase_chain_3,
    rod_spring_untruncated_mu0_zeta0_phase_chain_4,
    rod_spring_untruncated_mu0_zeta0_phase_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_jacobian_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_jacobian_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_jacobian_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_jacobian_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_jacobian_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_jacobian_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_jacobian_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_jacobian_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_jacobian_loops[] = {
    rod_spring_untruncated_mu0_zeta0_jacobian_chain_0,
    rod_spring_untruncated_mu0_zeta0_jacobian_chain_1,
    rod_spring_untruncated_mu0_zeta0_jacobian_chain_2,
    rod_spring_untruncated_mu0_zeta0_jacobian_chain_3,
    rod_spring_untruncated_mu0_zeta0_jacobian_chain_4,
    rod_spring_untruncated_mu0_zeta0_jacobian_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_stability_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_stability_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_0_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_stability_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_stability_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_stability_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_far_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static void rod_spring_untruncated_mu0_zeta0_stability_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    double average_1[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    rod_spring_untruncated_averaged_2_passed_1_steep_loop(n, (const double *[]){in[1], in[4], in[5], in[6]},
        (double *[]){average_0, average_1});
    slow_flow_mu0_zeta0_stability_loop(n, (const double *[]){in[0], in[1], m, in[3], average_0, average_1}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_stability_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_stability_loops[] = {
    rod_spring_untruncated_mu0_zeta0_stability_chain_0,
    rod_spring_untruncated_mu0_zeta0_stability_chain_1,
    rod_spring_untruncated_mu0_zeta0_stability_chain_2,
    rod_spring_untruncated_mu0_zeta0_stability_chain_3,
    rod_spring_untruncated_mu0_zeta0_stability_chain_4,
    rod_spring_untruncated_mu0_zeta0_stability_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_transmissibility_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_transmissibility_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_transmissibility_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_transmissibility_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_transmissibility_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_transmissibility_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    double average_0[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[3]}, (double *[]){m});
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[1], in[5], in[6], in[7]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_transmissibility_loop(n, (const double *[]){in[0], in[1], in[2], m, in[4], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_transmissibility_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_transmissibility_loops[] = {
    rod_spring_untruncated_mu0_zeta0_transmissibility_chain_0,
    rod_spring_untruncated_mu0_zeta0_transmissibility_chain_1,
    rod_spring_untruncated_mu0_zeta0_transmissibility_chain_2,
    rod_spring_untruncated_mu0_zeta0_transmissibility_chain_3,
    rod_spring_untruncated_mu0_zeta0_transmissibility_chain_4,
    rod_spring_untruncated_mu0_zeta0_transmissibility_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_backbone_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_0_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_backbone_chain_1(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_0_steep_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_backbone_chain_2(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_far_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_backbone_chain_3(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_backbone_chain_4(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_steep_far_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static void rod_spring_untruncated_mu0_zeta0_backbone_chain_5(ptrdiff_t n, const double *const *in, double *const *out)
{
    double average_0[SF_BLOCK];
    rod_spring_untruncated_h_passed_1_steep_loop(n, (const double *[]){in[0], in[1], in[2], in[3]},
        (double *[]){average_0});
    slow_flow_mu0_zeta0_backbone_loop(n, (const double *[]){in[0], average_0}, out);
}

static SF_WIDE void rod_spring_untruncated_mu0_zeta0_backbone_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
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

static const sf_loop rod_spring_untruncated_mu0_zeta0_backbone_loops[] = {
    rod_spring_untruncated_mu0_zeta0_backbone_chain_0,
    rod_spring_untruncated_mu0_zeta0_backbone_chain_1,
    rod_spring_untruncated_mu0_zeta0_backbone_chain_2,
    rod_spring_untruncated_mu0_zeta0_backbone_chain_3,
    rod_spring_untruncated_mu0_zeta0_backbone_chain_4,
    rod_spring_untruncated_mu0_zeta0_backbone_chain_5,
};

static void rod_spring_untruncated_mu0_zeta0_limit_envelope_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_mu0_zeta0_limit_envelope_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_untruncated_mu0_zeta0_limit_envelope_loops[] = {
    rod_spring_untruncated_mu0_zeta0_limit_envelope_chain_0,
};

static void rod_spring_untruncated_mu0_zeta0_equivalent_damping_chain_0(ptrdiff_t n, const double *const *in, double *const *out)
{
    double m[SF_BLOCK];
    slow_flow_mu0_zeta0_friction_loop(n, (const double *[]){in[2]}, (double *[]){m});
    slow_flow_mu0_zeta0_equivalent_damping_loop(n, (const double *[]){in[0], in[1], m, in[3]}, out);
}

static const sf_loop rod_spring_untruncated_mu0_zeta0_equivalent_damping_loops[] = {
    rod_spring_untruncated_mu0_zeta0_equivalent_damping_chain_0,
};

static const sf_kernel kernels[] = {
    {"R",
     "Cosine balance, -F_0 cos phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_mu0_zeta0_R_regime, rod_spring_untruncated_mu0_zeta0_R_loops},
    {"I",
     "Sine balance, -F_0 sin phi at a fixed point. Equation (23). Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, rod_spring_untruncated_mu0_zeta0_I_loops},
    {"F",
     "Frequency response; zero at a steady state. Equation (24). Domain: Omega > 0, A > 0.",
     8, 1, 6, rod_spring_untruncated_mu0_zeta0_F_regime, rod_spring_untruncated_mu0_zeta0_F_loops},
    {"F_A",
     "dF/dA; positive where stable. Equation (24), (30). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_mu0_zeta0_F_A_regime, rod_spring_untruncated_mu0_zeta0_F_A_loops},
    {"F_AA",
     "d2F/dA2. Equation (24), (33). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_mu0_zeta0_F_AA_regime, rod_spring_untruncated_mu0_zeta0_F_AA_loops},
    {"F_AAA",
     "d3F/dA3. Equation (24). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_mu0_zeta0_F_AAA_regime, rod_spring_untruncated_mu0_zeta0_F_AAA_loops},
    {"F_Omega",
     "dF/dOmega. Equation (24), (34). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_mu0_zeta0_F_Omega_regime, rod_spring_untruncated_mu0_zeta0_F_Omega_loops},
    {"F_AOmega",
     "d2F/dA dOmega. Equation (24). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_mu0_zeta0_F_AOmega_regime, rod_spring_untruncated_mu0_zeta0_F_AOmega_loops},
    {"phase",
     "Phase phi of a steady state, from -pi to 0. Equation (25). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_mu0_zeta0_phase_regime, rod_spring_untruncated_mu0_zeta0_phase_loops},
    {"jacobian",
     "Jacobian of the slow flow (A', phi') at a fixed point: J11, J12, J21, J22. Equation (28). Domain: Omega > 0, A "
     "> 0.",
     7, 4, 6, rod_spring_untruncated_mu0_zeta0_jacobian_regime, rod_spring_untruncated_mu0_zeta0_jacobian_loops},
    {"stability",
     "4 Omega^2 det(jacobian) = F_A/(2 A); stable where positive. Equation (30). Domain: Omega > 0, A > 0.",
     7, 1, 6, rod_spring_untruncated_mu0_zeta0_stability_regime, rod_spring_untruncated_mu0_zeta0_stability_loops},
    {"transmissibility",
     "Fundamental harmonic of the force on the base over F_0, at a steady state. Equation from (23). Domain: Omega > "
     "0, A > 0, F_0 > 0.",
     8, 1, 6, rod_spring_untruncated_mu0_zeta0_transmissibility_regime, rod_spring_untruncated_mu0_zeta0_transmissibility_loops},
    {"backbone",
     "Frequency on the backbone. Equation (26). Domain: A > 0, h <= 0.",
     4, 1, 6, rod_spring_untruncated_mu0_zeta0_backbone_regime, rod_spring_untruncated_mu0_zeta0_backbone_loops},
    {"limit_envelope",
     "Largest amplitude that the forcing can hold at this frequency. Equation (27). Domain: Omega > 0, F_0 > m; "
     "sticks otherwise.",
     4, 1, 1, NULL, rod_spring_untruncated_mu0_zeta0_limit_envelope_loops},
    {"equivalent_damping",
     "Viscous damping ratio that dissipates as much as zeta and friction together. Equation (38). Domain: Omega > 0, "
     "A > 0.",
     4, 1, 1, NULL, rod_spring_untruncated_mu0_zeta0_equivalent_damping_loops},
};

const sf_module sf_module_rod_spring_untruncated_mu0_zeta0 = {"rod_spring_untruncated_mu0_zeta0", kernels, sizeof kernels / sizeof kernels[0]};
