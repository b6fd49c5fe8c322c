/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring.h"

#include "kernels.h"

SF_LOOP(rod_spring_averaged_passed_0_loop, 4,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_passed_0(A, p, values);
)
SF_LOOP(rod_spring_averaged_passed_1_loop, 4,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_passed_1(A, p, values);
)
SF_LOOP(rod_spring_averaged_passed_1_far_1_loop, 4,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_passed_1_far_1(A, p, values);
)

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

SF_LOOP(rod_spring_averaged_2_passed_0_loop, 2,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_2_passed_0(A, p, values);
)
SF_LOOP(rod_spring_averaged_2_passed_1_loop, 2,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_2_passed_1(A, p, values);
)
SF_LOOP(rod_spring_averaged_2_passed_1_far_1_loop, 2,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_2_passed_1_far_1(A, p, values);
)

static const sf_loop rod_spring_averaged_2_loops[] = {
    rod_spring_averaged_2_passed_0_loop, rod_spring_averaged_2_passed_1_loop,
    rod_spring_averaged_2_passed_1_far_1_loop
};

SF_LOOP(rod_spring_averaged_H_passed_0_loop, 2,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_H_passed_0(A, p, values);
)
SF_LOOP(rod_spring_averaged_H_passed_1_loop, 2,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_H_passed_1(A, p, values);
)
SF_LOOP(rod_spring_averaged_H_passed_1_far_1_loop, 2,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_averaged_H_passed_1_far_1(A, p, values);
)

static const sf_loop rod_spring_averaged_H_loops[] = {
    rod_spring_averaged_H_passed_0_loop, rod_spring_averaged_H_passed_1_loop,
    rod_spring_averaged_H_passed_1_far_1_loop
};

SF_LOOP(rod_spring_intercept_passed_0_loop, 1,
    const double A = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
    values[0] = rod_spring_intercept_passed_0(A, alpha, beta, gamma, u_cr);
)
SF_LOOP(rod_spring_intercept_passed_1_loop, 1,
    const double A = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
    values[0] = rod_spring_intercept_passed_1(A, alpha, beta, gamma, u_cr);
)
SF_LOOP(rod_spring_intercept_passed_1_far_1_loop, 1,
    const double A = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
    values[0] = rod_spring_intercept_passed_1_far_1(A, alpha, beta, gamma, u_cr);
)

static const sf_loop rod_spring_intercept_loops[] = {
    rod_spring_intercept_passed_0_loop, rod_spring_intercept_passed_1_loop, rod_spring_intercept_passed_1_far_1_loop
};

SF_LOOP(rod_spring_harmonics_passed_0_loop, 8,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_harmonics_passed_0(A, p, values);
)
SF_LOOP(rod_spring_harmonics_passed_1_loop, 8,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_harmonics_passed_1(A, p, values);
)
SF_LOOP(rod_spring_harmonics_passed_1_far_1_loop, 8,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    rod_spring_harmonics_passed_1_far_1(A, p, values);
)

static const sf_loop rod_spring_harmonics_loops[] = {
    rod_spring_harmonics_passed_0_loop, rod_spring_harmonics_passed_1_loop, rod_spring_harmonics_passed_1_far_1_loop
};

SF_LOOP(rod_spring_coefficients_loop, 4,
    const double lam = in[0][i], r = in[1][i], delta_h = in[2][i];
    rod_spring_coefficients(lam, r, delta_h, values);
)

SF_LOOP(rod_spring_breakpoints_loop, 1,
    const double p[] = {in[0][i], in[1][i], in[2][i], in[3][i]};
    rod_spring_breakpoints(p, values);
)

SF_LOOP(rod_spring_jumps_loop, 1,
    const double p[] = {in[0][i], in[1][i], in[2][i], in[3][i]};
    rod_spring_jumps(p, values);
)

SF_LOOP(rod_spring_hardening_loop, 3,
    const double p[] = {in[0][i], in[1][i], in[2][i], in[3][i]};
    rod_spring_hardening(p, values);
)

SF_LOOP(rod_spring_force_force_1_loop, 1,
    const double u = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
    values[0] = rod_spring_force_1(u, alpha, beta, gamma, u_cr);
)
SF_LOOP(rod_spring_force_force_2_loop, 1,
    const double u = in[0][i], alpha = in[1][i], beta = in[2][i], gamma = in[3][i], u_cr = in[4][i];
    values[0] = rod_spring_force_2(u, alpha, beta, gamma, u_cr);
)

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

SF_LOOP(rod_spring_saddle_node_onset_loop, 19,
    const double m = in[0][i], zeta = in[1][i];
    const double p[] = {in[2][i], in[3][i], in[4][i], in[5][i]};
    rod_spring_saddle_node_onset(m, zeta, p, values);
)

SF_LOOP(rod_spring_saddle_nodes_loop, 17,
    const double F_0 = in[0][i], m = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    rod_spring_saddle_nodes(F_0, m, zeta, p, values);
)

SF_LOOP(rod_spring_h_passed_0_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_2_passed_0(A, p, all);
    values[0] = all[0];
)
SF_LOOP(rod_spring_h_passed_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_2_passed_1(A, p, all);
    values[0] = all[0];
)
SF_LOOP(rod_spring_h_passed_1_far_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, all);
    values[0] = all[0];
)

static const sf_loop rod_spring_h_loops[] = {
    rod_spring_h_passed_0_loop, rod_spring_h_passed_1_loop, rod_spring_h_passed_1_far_1_loop
};

SF_LOOP(rod_spring_h_A_passed_0_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_2_passed_0(A, p, all);
    values[0] = all[1];
)
SF_LOOP(rod_spring_h_A_passed_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_2_passed_1(A, p, all);
    values[0] = all[1];
)
SF_LOOP(rod_spring_h_A_passed_1_far_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, all);
    values[0] = all[1];
)

static const sf_loop rod_spring_h_A_loops[] = {
    rod_spring_h_A_passed_0_loop, rod_spring_h_A_passed_1_loop, rod_spring_h_A_passed_1_far_1_loop
};

SF_LOOP(rod_spring_h_AA_passed_0_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_0(A, p, all);
    values[0] = all[2];
)
SF_LOOP(rod_spring_h_AA_passed_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_1(A, p, all);
    values[0] = all[2];
)
SF_LOOP(rod_spring_h_AA_passed_1_far_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_1_far_1(A, p, all);
    values[0] = all[2];
)

static const sf_loop rod_spring_h_AA_loops[] = {
    rod_spring_h_AA_passed_0_loop, rod_spring_h_AA_passed_1_loop, rod_spring_h_AA_passed_1_far_1_loop
};

SF_LOOP(rod_spring_h_AAA_passed_0_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_0(A, p, all);
    values[0] = all[3];
)
SF_LOOP(rod_spring_h_AAA_passed_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_1(A, p, all);
    values[0] = all[3];
)
SF_LOOP(rod_spring_h_AAA_passed_1_far_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_1_far_1(A, p, all);
    values[0] = all[3];
)

static const sf_loop rod_spring_h_AAA_loops[] = {
    rod_spring_h_AAA_passed_0_loop, rod_spring_h_AAA_passed_1_loop, rod_spring_h_AAA_passed_1_far_1_loop
};

SF_LOOP(rod_spring_H_passed_0_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_H_passed_0(A, p, all);
    values[0] = all[0];
)
SF_LOOP(rod_spring_H_passed_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_H_passed_1(A, p, all);
    values[0] = all[0];
)
SF_LOOP(rod_spring_H_passed_1_far_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_H_passed_1_far_1(A, p, all);
    values[0] = all[0];
)

static const sf_loop rod_spring_H_loops[] = {
    rod_spring_H_passed_0_loop, rod_spring_H_passed_1_loop, rod_spring_H_passed_1_far_1_loop
};

SF_LOOP(rod_spring_H_A_passed_0_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_H_passed_0(A, p, all);
    values[0] = all[1];
)
SF_LOOP(rod_spring_H_A_passed_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_H_passed_1(A, p, all);
    values[0] = all[1];
)
SF_LOOP(rod_spring_H_A_passed_1_far_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[2];
    rod_spring_averaged_H_passed_1_far_1(A, p, all);
    values[0] = all[1];
)

static const sf_loop rod_spring_H_A_loops[] = {
    rod_spring_H_A_passed_0_loop, rod_spring_H_A_passed_1_loop, rod_spring_H_A_passed_1_far_1_loop
};

SF_LOOP(rod_spring_H_AA_passed_0_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_0(A, p, all);
    values[0] = all[2];
)
SF_LOOP(rod_spring_H_AA_passed_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_1(A, p, all);
    values[0] = all[2];
)
SF_LOOP(rod_spring_H_AA_passed_1_far_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double all[4];
    rod_spring_averaged_passed_1_far_1(A, p, all);
    values[0] = all[2];
)

static const sf_loop rod_spring_H_AA_loops[] = {
    rod_spring_H_AA_passed_0_loop, rod_spring_H_AA_passed_1_loop, rod_spring_H_AA_passed_1_far_1_loop
};

SF_LOOP(rod_spring_F_passed_0_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
    const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    values[0] = slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
)
SF_LOOP(rod_spring_F_passed_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
    const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    values[0] = slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
)
SF_LOOP(rod_spring_F_passed_1_far_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
    const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    values[0] = slow_flow_F(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
)

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

SF_LOOP(rod_spring_F_A_passed_0_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    values[0] = slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
)
SF_LOOP(rod_spring_F_A_passed_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    values[0] = slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
)
SF_LOOP(rod_spring_F_A_passed_1_far_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    values[0] = slow_flow_F_A(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
)

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

SF_LOOP(rod_spring_level_passed_0_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    values[0] = slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
)
SF_LOOP(rod_spring_level_passed_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    values[0] = slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
)
SF_LOOP(rod_spring_level_passed_1_far_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    values[0] = slow_flow_level(Omega, A, slow_flow_friction(mu), zeta, average[0]);
)

static const sf_loop rod_spring_level_loops[] = {
    rod_spring_level_passed_0_loop, rod_spring_level_passed_1_loop, rod_spring_level_passed_1_far_1_loop
};

SF_LOOP(rod_spring_phase_passed_0_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    values[0] = slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
)
SF_LOOP(rod_spring_phase_passed_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    values[0] = slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
)
SF_LOOP(rod_spring_phase_passed_1_far_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    values[0] = slow_flow_phase(Omega, A, slow_flow_friction(mu), zeta, average[0]);
)

static const sf_loop rod_spring_phase_loops[] = {
    rod_spring_phase_passed_0_loop, rod_spring_phase_passed_1_loop, rod_spring_phase_passed_1_far_1_loop
};

SF_LOOP(rod_spring_jacobian_passed_0_loop, 4,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], values);
)
SF_LOOP(rod_spring_jacobian_passed_1_loop, 4,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], values);
)
SF_LOOP(rod_spring_jacobian_passed_1_far_1_loop, 4,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    slow_flow_jacobian(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1], values);
)

static const sf_loop rod_spring_jacobian_loops[] = {
    rod_spring_jacobian_passed_0_loop, rod_spring_jacobian_passed_1_loop, rod_spring_jacobian_passed_1_far_1_loop
};

SF_LOOP(rod_spring_stability_passed_0_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    values[0] = slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
)
SF_LOOP(rod_spring_stability_passed_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    values[0] = slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
)
SF_LOOP(rod_spring_stability_passed_1_far_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    values[0] = slow_flow_stability(Omega, A, slow_flow_friction(mu), zeta, average[0], average[1]);
)

static const sf_loop rod_spring_stability_loops[] = {
    rod_spring_stability_passed_0_loop, rod_spring_stability_passed_1_loop, rod_spring_stability_passed_1_far_1_loop
};

SF_LOOP(rod_spring_transmissibility_passed_0_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
    const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    values[0] = slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
)
SF_LOOP(rod_spring_transmissibility_passed_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
    const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    values[0] = slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
)
SF_LOOP(rod_spring_transmissibility_passed_1_far_1_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], mu = in[3][i], zeta = in[4][i];
    const double p[] = {in[5][i], in[6][i], in[7][i], in[8][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    values[0] = slow_flow_transmissibility(Omega, A, F_0, slow_flow_friction(mu), zeta, average[0]);
)

static const sf_loop rod_spring_transmissibility_loops[] = {
    rod_spring_transmissibility_passed_0_loop, rod_spring_transmissibility_passed_1_loop,
    rod_spring_transmissibility_passed_1_far_1_loop
};

SF_LOOP(rod_spring_backbone_passed_0_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    values[0] = slow_flow_backbone(A, average[0]);
)
SF_LOOP(rod_spring_backbone_passed_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    values[0] = slow_flow_backbone(A, average[0]);
)
SF_LOOP(rod_spring_backbone_passed_1_far_1_loop, 1,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i], in[4][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    values[0] = slow_flow_backbone(A, average[0]);
)

static const sf_loop rod_spring_backbone_loops[] = {
    rod_spring_backbone_passed_0_loop, rod_spring_backbone_passed_1_loop, rod_spring_backbone_passed_1_far_1_loop
};

SF_LOOP(rod_spring_limit_envelope_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
)

SF_LOOP(rod_spring_equivalent_damping_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
)

SF_LOOP(rod_spring_response_quartic_passed_0_loop, 4,
    const double A = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], values);
)
SF_LOOP(rod_spring_response_quartic_passed_1_loop, 4,
    const double A = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], values);
)
SF_LOOP(rod_spring_response_quartic_passed_1_far_1_loop, 4,
    const double A = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
    const double p[] = {in[4][i], in[5][i], in[6][i], in[7][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    slow_flow_response_quartic(A, F_0, slow_flow_friction(mu), zeta, average[0], values);
)

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

SF_LOOP(rod_spring_fold_quartic_passed_0_loop, 4,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], values);
)
SF_LOOP(rod_spring_fold_quartic_passed_1_loop, 4,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], values);
)
SF_LOOP(rod_spring_fold_quartic_passed_1_far_1_loop, 4,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    slow_flow_fold_quartic(A, slow_flow_friction(mu), zeta, average[0], average[1], values);
)

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

SF_LOOP(rod_spring_peak_cubic_passed_0_loop, 3,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], values);
)
SF_LOOP(rod_spring_peak_cubic_passed_1_loop, 3,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], values);
)
SF_LOOP(rod_spring_peak_cubic_passed_1_far_1_loop, 3,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    slow_flow_peak_cubic(A, slow_flow_friction(mu), zeta, average[0], values);
)

static const sf_loop rod_spring_peak_cubic_loops[] = {
    rod_spring_peak_cubic_passed_0_loop, rod_spring_peak_cubic_passed_1_loop,
    rod_spring_peak_cubic_passed_1_far_1_loop
};

SF_LOOP(rod_spring_detachment_passed_0_loop, 4,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_0(A, p, average);
    slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], values);
)
SF_LOOP(rod_spring_detachment_passed_1_loop, 4,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_1(A, p, average);
    slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], values);
)
SF_LOOP(rod_spring_detachment_passed_1_far_1_loop, 4,
    const double A = in[0][i], mu = in[1][i], zeta = in[2][i];
    const double p[] = {in[3][i], in[4][i], in[5][i], in[6][i]};
    double average[2];
    rod_spring_averaged_2_passed_1_far_1(A, p, average);
    slow_flow_detachment(A, slow_flow_friction(mu), zeta, average[0], values);
)

static const sf_loop rod_spring_detachment_loops[] = {
    rod_spring_detachment_passed_0_loop, rod_spring_detachment_passed_1_loop,
    rod_spring_detachment_passed_1_far_1_loop
};

static const sf_kernel kernels[] = {
    {"averaged", 5, 4, 3, rod_spring_averaged_regime, rod_spring_averaged_loops},
    {"averaged_2", 5, 2, 3, rod_spring_averaged_regime, rod_spring_averaged_2_loops},
    {"averaged_H", 5, 2, 3, rod_spring_averaged_regime, rod_spring_averaged_H_loops},
    {"intercept", 5, 1, 3, rod_spring_averaged_regime, rod_spring_intercept_loops},
    {"harmonics", 5, 8, 3, rod_spring_averaged_regime, rod_spring_harmonics_loops},
    {"coefficients", 3, 4, 1, NULL, SF_ONE(rod_spring_coefficients_loop)},
    {"breakpoints", 4, 1, 1, NULL, SF_ONE(rod_spring_breakpoints_loop)},
    {"jumps", 4, 1, 1, NULL, SF_ONE(rod_spring_jumps_loop)},
    {"hardening", 4, 3, 1, NULL, SF_ONE(rod_spring_hardening_loop)},
    {"force", 5, 1, 2, rod_spring_force_regime, rod_spring_force_loops},
    {"saddle_node_onset", 6, 19, 1, NULL, SF_ONE(rod_spring_saddle_node_onset_loop)},
    {"saddle_nodes", 7, 17, 1, NULL, SF_ONE(rod_spring_saddle_nodes_loop)},
    {"h", 5, 1, 3, rod_spring_averaged_regime, rod_spring_h_loops},
    {"h_A", 5, 1, 3, rod_spring_averaged_regime, rod_spring_h_A_loops},
    {"h_AA", 5, 1, 3, rod_spring_averaged_regime, rod_spring_h_AA_loops},
    {"h_AAA", 5, 1, 3, rod_spring_averaged_regime, rod_spring_h_AAA_loops},
    {"H", 5, 1, 3, rod_spring_averaged_regime, rod_spring_H_loops},
    {"H_A", 5, 1, 3, rod_spring_averaged_regime, rod_spring_H_A_loops},
    {"H_AA", 5, 1, 3, rod_spring_averaged_regime, rod_spring_H_AA_loops},
    {"F", 9, 1, 3, rod_spring_F_regime, rod_spring_F_loops},
    {"F_A", 8, 1, 3, rod_spring_F_A_regime, rod_spring_F_A_loops},
    {"level", 8, 1, 3, rod_spring_F_A_regime, rod_spring_level_loops},
    {"phase", 8, 1, 3, rod_spring_F_A_regime, rod_spring_phase_loops},
    {"jacobian", 8, 4, 3, rod_spring_F_A_regime, rod_spring_jacobian_loops},
    {"stability", 8, 1, 3, rod_spring_F_A_regime, rod_spring_stability_loops},
    {"transmissibility", 9, 1, 3, rod_spring_F_regime, rod_spring_transmissibility_loops},
    {"backbone", 5, 1, 3, rod_spring_averaged_regime, rod_spring_backbone_loops},
    {"limit_envelope", 4, 1, 1, NULL, SF_ONE(rod_spring_limit_envelope_loop)},
    {"equivalent_damping", 4, 1, 1, NULL, SF_ONE(rod_spring_equivalent_damping_loop)},
    {"response_quartic", 8, 4, 3, rod_spring_response_quartic_regime, rod_spring_response_quartic_loops},
    {"fold_quartic", 7, 4, 3, rod_spring_fold_quartic_regime, rod_spring_fold_quartic_loops},
    {"peak_cubic", 7, 3, 3, rod_spring_fold_quartic_regime, rod_spring_peak_cubic_loops},
    {"detachment", 7, 4, 3, rod_spring_fold_quartic_regime, rod_spring_detachment_loops},
};

const sf_module sf_module_rod_spring = {"rod_spring", kernels, sizeof kernels / sizeof kernels[0]};
