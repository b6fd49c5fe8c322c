/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring_untruncated.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring_untruncated.h"

#include "kernels.h"

SF_LOOP(rod_spring_untruncated_averaged_all_passed_0_end_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_0_end(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_0_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_0(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_0_steep_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_0_steep(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_1_far_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_1_far(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_1_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_1(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_1_steeper_far_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_1_steeper_far(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_1_steeper_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_1_steeper(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_1_steep_far_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_1_steep_far(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_1_steep_away_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_1_steep_away(A, p, values);
)
SF_LOOP(rod_spring_untruncated_averaged_all_passed_1_steep_loop, 7,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_averaged_all_passed_1_steep(A, p, values);
)

static SF_WIDE void rod_spring_untruncated_averaged_all_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[0], *delta_h_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], delta_h = delta_h_[i];
        regime[i] = A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) && sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 0 : A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) && A <= 0.69999999999999996 ? 1 : A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) ? 2 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75 && 1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 3 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75 ? 4 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004 && 1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 5 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004 ? 6 : 1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 7 : sqrt(-0.75 * delta_h * delta_h + 1.5 * delta_h + 0.25) <= A ? 8 : 9;
    }
}

static const sf_loop rod_spring_untruncated_averaged_all_loops[] = {
    rod_spring_untruncated_averaged_all_passed_0_end_loop, rod_spring_untruncated_averaged_all_passed_0_loop,
    rod_spring_untruncated_averaged_all_passed_0_steep_loop, rod_spring_untruncated_averaged_all_passed_1_far_loop,
    rod_spring_untruncated_averaged_all_passed_1_loop,
    rod_spring_untruncated_averaged_all_passed_1_steeper_far_loop,
    rod_spring_untruncated_averaged_all_passed_1_steeper_loop,
    rod_spring_untruncated_averaged_all_passed_1_steep_far_loop,
    rod_spring_untruncated_averaged_all_passed_1_steep_away_loop,
    rod_spring_untruncated_averaged_all_passed_1_steep_loop
};

SF_LOOP(rod_spring_untruncated_harmonics_passed_0_loop, 8,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_harmonics_passed_0(A, p, values);
)
SF_LOOP(rod_spring_untruncated_harmonics_passed_1_loop, 8,
    const double A = in[0][i];
    const double p[] = {in[1][i], in[2][i], in[3][i]};
    rod_spring_untruncated_harmonics_passed_1(A, p, values);
)

static SF_WIDE void rod_spring_untruncated_harmonics_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[0], *delta_h_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], delta_h = delta_h_[i];
        regime[i] = A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) ? 0 : 1;
    }
}

static const sf_loop rod_spring_untruncated_harmonics_loops[] = {
    rod_spring_untruncated_harmonics_passed_0_loop, rod_spring_untruncated_harmonics_passed_1_loop
};

SF_LOOP(rod_spring_untruncated_coefficients_loop, 3,
    const double lam = in[0][i], r = in[1][i], delta_h = in[2][i];
    rod_spring_untruncated_coefficients(lam, r, delta_h, values);
)

SF_LOOP(rod_spring_untruncated_breakpoints_loop, 1,
    const double p[] = {in[0][i], in[1][i], in[2][i]};
    rod_spring_untruncated_breakpoints(p, values);
)

SF_LOOP(rod_spring_untruncated_jumps_loop, 1,
    const double p[] = {in[0][i], in[1][i], in[2][i]};
    rod_spring_untruncated_jumps(p, values);
)

SF_LOOP(rod_spring_untruncated_hardening_loop, 1,
    const double p[] = {in[0][i], in[1][i], in[2][i]};
    rod_spring_untruncated_hardening(p, values);
)

SF_LOOP(rod_spring_untruncated_force_force_2_loop, 1,
    const double u = in[0][i], alpha = in[1][i], beta = in[2][i], delta_h = in[3][i];
    values[0] = rod_spring_untruncated_force_2(u, alpha, beta, delta_h);
)
SF_LOOP(rod_spring_untruncated_force_force_1_loop, 1,
    const double u = in[0][i], alpha = in[1][i], beta = in[2][i], delta_h = in[3][i];
    values[0] = rod_spring_untruncated_force_1(u, alpha, beta, delta_h);
)

static SF_WIDE void rod_spring_untruncated_force_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *u_ = in[0], *delta_h_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double u = u_[i], delta_h = delta_h_[i];
        regime[i] = sqrt(-delta_h * delta_h + 2.0 * delta_h) <= fabs(u) ? 0 : 1;
    }
}

static const sf_loop rod_spring_untruncated_force_loops[] = {
    rod_spring_untruncated_force_force_2_loop, rod_spring_untruncated_force_force_1_loop
};

SF_LOOP(rod_spring_untruncated_limit_envelope_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
)

SF_LOOP(rod_spring_untruncated_equivalent_damping_loop, 1,
    const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
    values[0] = slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
)

static const sf_kernel kernels[] = {
    {"averaged_all", 4, 7, 10, rod_spring_untruncated_averaged_all_regime, rod_spring_untruncated_averaged_all_loops},
    {"harmonics", 4, 8, 2, rod_spring_untruncated_harmonics_regime, rod_spring_untruncated_harmonics_loops},
    {"coefficients", 3, 3, 1, NULL, SF_ONE(rod_spring_untruncated_coefficients_loop)},
    {"breakpoints", 3, 1, 1, NULL, SF_ONE(rod_spring_untruncated_breakpoints_loop)},
    {"jumps", 3, 1, 1, NULL, SF_ONE(rod_spring_untruncated_jumps_loop)},
    {"hardening", 3, 1, 1, NULL, SF_ONE(rod_spring_untruncated_hardening_loop)},
    {"force", 4, 1, 2, rod_spring_untruncated_force_regime, rod_spring_untruncated_force_loops},
    {"limit_envelope", 4, 1, 1, NULL, SF_ONE(rod_spring_untruncated_limit_envelope_loop)},
    {"equivalent_damping", 4, 1, 1, NULL, SF_ONE(rod_spring_untruncated_equivalent_damping_loop)},
};

const sf_module sf_module_rod_spring_untruncated = {"rod_spring_untruncated", kernels, sizeof kernels / sizeof kernels[0]};
