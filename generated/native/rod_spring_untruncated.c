/* Mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr, force not truncated: loops for NumPy.

   Written by `make derive`; never edit.
   Input: rod_spring_untruncated.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "rod_spring_untruncated.h"

#include "kernels.h"

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_0_end_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_0_end(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_0(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_0_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_0_steep(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1_far(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_steeper_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1_steeper_far(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_steep_far_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1_steep_far(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_steep_away_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1_steep_away(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_passed_1_steep_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[7];
        rod_spring_untruncated_averaged_all_passed_1_steep(A, p, values);
        for (int k = 0; k < 7; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_averaged_all_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[0], *delta_h_ = in[3];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], delta_h = delta_h_[i];
        regime[i] = A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) && sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 0 : A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) && A <= 0.69999999999999996 ? 1 : A <= sqrt(-delta_h * delta_h + 2.0 * delta_h) ? 2 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75 && 1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 3 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.75 ? 4 : sqrt(-delta_h * delta_h + 2.0 * delta_h) <= 0.92000000000000004 && 1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 5 : 1.05 * sqrt(-delta_h * delta_h + 2.0 * delta_h) <= A ? 6 : sqrt(-0.75 * delta_h * delta_h + 1.5 * delta_h + 0.25) <= A ? 7 : 8;
    }
}

static const sf_loop rod_spring_untruncated_averaged_all_loops[] = {
    rod_spring_untruncated_averaged_all_passed_0_end_loop, rod_spring_untruncated_averaged_all_passed_0_loop,
    rod_spring_untruncated_averaged_all_passed_0_steep_loop, rod_spring_untruncated_averaged_all_passed_1_far_loop,
    rod_spring_untruncated_averaged_all_passed_1_loop,
    rod_spring_untruncated_averaged_all_passed_1_steeper_far_loop,
    rod_spring_untruncated_averaged_all_passed_1_steep_far_loop,
    rod_spring_untruncated_averaged_all_passed_1_steep_away_loop,
    rod_spring_untruncated_averaged_all_passed_1_steep_loop
};

static SF_WIDE void rod_spring_untruncated_harmonics_passed_0_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[8];
        rod_spring_untruncated_harmonics_passed_0(A, p, values);
        for (int k = 0; k < 8; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void rod_spring_untruncated_harmonics_passed_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i];
        const double p[] = {in[1][i], in[2][i], in[3][i]};
        double values[8];
        rod_spring_untruncated_harmonics_passed_1(A, p, values);
        for (int k = 0; k < 8; k++)
            out[k][i] = values[k];
    }
}

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

static SF_WIDE void rod_spring_untruncated_coefficients_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double lam = in[0][i], r = in[1][i], delta_h = in[2][i];
        double values[3];
        rod_spring_untruncated_coefficients(lam, r, delta_h, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_untruncated_coefficients_loops[] = {rod_spring_untruncated_coefficients_loop};

static SF_WIDE void rod_spring_untruncated_breakpoints_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double p[] = {in[0][i], in[1][i], in[2][i]};
        double values[1];
        rod_spring_untruncated_breakpoints(p, values);
        for (int k = 0; k < 1; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_untruncated_breakpoints_loops[] = {rod_spring_untruncated_breakpoints_loop};

static SF_WIDE void rod_spring_untruncated_jumps_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double p[] = {in[0][i], in[1][i], in[2][i]};
        double values[1];
        rod_spring_untruncated_jumps(p, values);
        for (int k = 0; k < 1; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_untruncated_jumps_loops[] = {rod_spring_untruncated_jumps_loop};

static SF_WIDE void rod_spring_untruncated_hardening_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double p[] = {in[0][i], in[1][i], in[2][i]};
        double values[1];
        rod_spring_untruncated_hardening(p, values);
        for (int k = 0; k < 1; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop rod_spring_untruncated_hardening_loops[] = {rod_spring_untruncated_hardening_loop};

static SF_WIDE void rod_spring_untruncated_force_force_2_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double u = in[0][i], alpha = in[1][i], beta = in[2][i], delta_h = in[3][i];
        out[0][i] = rod_spring_untruncated_force_2(u, alpha, beta, delta_h);
    }
}

static SF_WIDE void rod_spring_untruncated_force_force_1_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double u = in[0][i], alpha = in[1][i], beta = in[2][i], delta_h = in[3][i];
        out[0][i] = rod_spring_untruncated_force_1(u, alpha, beta, delta_h);
    }
}

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

static SF_WIDE void rod_spring_untruncated_limit_envelope_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i], mu = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_limit_envelope(Omega, F_0, slow_flow_friction(mu), zeta);
    }
}

static const sf_loop rod_spring_untruncated_limit_envelope_loops[] = {rod_spring_untruncated_limit_envelope_loop};

static SF_WIDE void rod_spring_untruncated_equivalent_damping_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], mu = in[2][i], zeta = in[3][i];
        out[0][i] = slow_flow_equivalent_damping(Omega, A, slow_flow_friction(mu), zeta);
    }
}

static const sf_loop rod_spring_untruncated_equivalent_damping_loops[] = {rod_spring_untruncated_equivalent_damping_loop};

static const sf_kernel kernels[] = {
    {"averaged_all",
     "h, h_A, h_AA, h_AAA, H, H_A, h - A h_A together. Equation (20)-(22), (31). Domain: A >= 0.",
     4, 7, 9, rod_spring_untruncated_averaged_all_regime, rod_spring_untruncated_averaged_all_loops},
    {"harmonics",
     "Higher harmonics of the force, as h is its first: h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A, h_5_AA, h_5_AAA. "
     "Equation beyond (20). Domain: A >= 0, u_cr <= 3/4.",
     4, 8, 2, rod_spring_untruncated_harmonics_regime, rod_spring_untruncated_harmonics_loops},
    {"coefficients",
     "The parameters alpha, beta, delta_h from the design. Equation (5), (7). Domain: any design.",
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
