/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance: loops for NumPy.

   Written by `make derive`; never edit.
   Input: inertia.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "inertia.h"

#include "kernels.h"

static SF_WIDE void inertia_force_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i];
        out[0][i] = inertia_force(Omega, F_0);
    }
}

static const sf_loop inertia_force_loops[] = {inertia_force_loop};

static SF_WIDE void inertia_force_slopes_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], F_0 = in[1][i];
        double values[2];
        inertia_force_slopes(Omega, F_0, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop inertia_force_slopes_loops[] = {inertia_force_slopes_loop};

static SF_WIDE void inertia_level_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = inertia_level(Omega, A, m, zeta, h);
    }
}

static const sf_loop inertia_level_loops[] = {inertia_level_loop};

static SF_WIDE void inertia_F_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i];
        out[0][i] = inertia_F(Omega, A, F_0, m, zeta, h);
    }
}

static const sf_loop inertia_F_loops[] = {inertia_F_loop};

static SF_WIDE void inertia_level_slope_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        out[0][i] = inertia_level_slope(Omega, A, m, zeta, h);
    }
}

static const sf_loop inertia_level_slope_loops[] = {inertia_level_slope_loop};

static SF_WIDE void inertia_Omega_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = inertia_Omega_A(Omega, A, m, zeta, h, h_A);
    }
}

static const sf_loop inertia_Omega_A_loops[] = {inertia_Omega_A_loop};

static SF_WIDE void inertia_outer_falling_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        double values[2];
        inertia_outer_falling(A, F_0, m, zeta, h, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void inertia_outer_rising_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
        double values[2];
        inertia_outer_rising(A, F_0, m, zeta, h, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static SF_WIDE void inertia_outer_regime(ptrdiff_t n, const double *const *in, unsigned char *regime)
{
    /* a char may alias the table of arrays */
    const double *A_ = in[0], *zeta_ = in[3], *h_ = in[4];
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = A_[i], zeta = zeta_[i], h = h_[i];
        regime[i] = 2.0 * A * zeta * zeta + h <= 0.0 ? 0 : 1;
    }
}

static const sf_loop inertia_outer_loops[] = {
    inertia_outer_falling_loop, inertia_outer_rising_loop
};

static SF_WIDE void inertia_terms_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
        double values[3];
        inertia_terms(A, m, zeta, h, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop inertia_terms_loops[] = {inertia_terms_loop};

static SF_WIDE void inertia_least_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double fall = in[0][i], linear = in[1][i], rest = in[2][i];
        out[0][i] = inertia_least(fall, linear, rest);
    }
}

static const sf_loop inertia_least_loops[] = {inertia_least_loop};

static SF_WIDE void inertia_least_Omega_A_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double x = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
        out[0][i] = inertia_least_Omega_A(x, A, m, zeta, h, h_A);
    }
}

static const sf_loop inertia_least_Omega_A_loops[] = {inertia_least_Omega_A_loop};

static SF_WIDE void inertia_peak_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double x = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i], h_A =
            in[6][i];
        double values[2];
        inertia_peak(x, A, F_0, m, zeta, h, h_A, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop inertia_peak_loops[] = {inertia_peak_loop};

static SF_WIDE void inertia_isola_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double x = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
            in[6][i];
        double values[2];
        inertia_isola(x, A, m, zeta, h, h_A, h_AA, values);
        for (int k = 0; k < 2; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop inertia_isola_loops[] = {inertia_isola_loop};

static SF_WIDE void inertia_level_rise_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i];
        out[0][i] = inertia_level_rise(Omega, A, m, zeta, h, h_A, h_AA);
    }
}

static const sf_loop inertia_level_rise_loops[] = {inertia_level_rise_loop};

static SF_WIDE void inertia_cusp_bend_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i], h_AAA = in[7][i];
        out[0][i] = inertia_cusp_bend(Omega, A, m, zeta, h, h_A, h_AA, h_AAA);
    }
}

static const sf_loop inertia_cusp_bend_loops[] = {inertia_cusp_bend_loop};

static SF_WIDE void inertia_hessian_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i];
        out[0][i] = inertia_hessian(Omega, A, m, zeta, h, h_A, h_AA);
    }
}

static const sf_loop inertia_hessian_loops[] = {inertia_hessian_loop};

static SF_WIDE void inertia_bound_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], F_0 = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i], h_AA = in[5][i],
            h_AAA = in[6][i], lost = in[7][i];
        double values[4];
        inertia_bound(A, F_0, zeta, h, h_A, h_AA, h_AAA, lost, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop inertia_bound_loops[] = {inertia_bound_loop};

static SF_WIDE void inertia_share_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double A = in[0][i], zeta = in[1][i], h = in[2][i];
        out[0][i] = inertia_share(A, zeta, h);
    }
}

static const sf_loop inertia_share_loops[] = {inertia_share_loop};

static const sf_kernel kernels[] = {
    {"force",
     "Amplitude of the force on the mass. Equation beside (3). Domain: Omega >= 0.",
     2, 1, 1, NULL, inertia_force_loops},
    {"force_slopes",
     "Its slopes by Omega, F_0. Equation beside (3). Domain: Omega >= 0.",
     2, 2, 1, NULL, inertia_force_slopes_loops},
    {"level",
     "The amplitude F_0 of the excitation for which (Omega, A) is a steady state. Equation from (24). Domain: Omega "
     "> 0, A > 0.",
     5, 1, 1, NULL, inertia_level_loops},
    {"F",
     "Zero at a steady state. Equation from (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, inertia_F_loops},
    {"level_slope",
     "Omega^5 times the derivative of level^2 by Omega. Equation from (24). Domain: Omega > 0, A > 0.",
     5, 1, 1, NULL, inertia_level_slope_loops},
    {"Omega_A",
     "dOmega/dA along the response. Equation from (24). Domain: Omega > 0, A > 0.",
     6, 1, 1, NULL, inertia_Omega_A_loops},
    {"outer",
     "1/Omega^2 below the low frequency of an amplitude, and above the high one, where it has that. Equation from "
     "(24). Domain: A > 0, where F has a root.",
     5, 2, 2, inertia_outer_regime, inertia_outer_loops},
    {"terms",
     "What the least level of an amplitude follows from; it has one where the first, fall, is positive. Equation "
     "from (24). Domain: A > 0.",
     4, 3, 1, NULL, inertia_terms_loops},
    {"least",
     "x = 1/Omega where the level of an amplitude is least, by its `terms`. Equation from (24). Domain: fall > 0, "
     "linear >= 0, rest > 0.",
     3, 1, 1, NULL, inertia_least_loops},
    {"least_Omega_A",
     "dOmega/dA where the level of an amplitude is least: what a rounding of A does to Omega there. Equation from "
     "(24). Domain: x of `least`, h < 0.",
     6, 1, 1, NULL, inertia_least_Omega_A_loops},
    {"peak",
     "The least level of an amplitude less F_0, and its slope along A. Equation from (24). Domain: x of `least`, h < "
     "0.",
     7, 2, 1, NULL, inertia_peak_loops},
    {"isola",
     "Has the sign of F_A where an amplitude's level is least: zero at an isola point; its slope along A. Equation "
     "from (24), (30). Domain: x of `least`, h < 0.",
     7, 2, 1, NULL, inertia_isola_loops},
    {"level_rise",
     "Positive where the level rises with A along the fold locus, negative where it falls. Equation from (24), (30). "
     "Domain: Omega > 0, A > 0.",
     7, 1, 1, NULL, inertia_level_rise_loops},
    {"cusp_bend",
     "Positive at a cusp where the level has a minimum along the fold locus, negative at a maximum. Equation from "
     "(24), (30). Domain: Omega > 0, A > 0.",
     8, 1, 1, NULL, inertia_cusp_bend_loops},
    {"hessian",
     "At an isola point: negative where the level has a saddle in (A, Omega). Equation from (24), (30). Domain: "
     "Omega > 0, A > 0.",
     7, 1, 1, NULL, inertia_hessian_loops},
    {"bound",
     "Positive where no state has an amplitude A > F_0, if zeta^2 A <= lost |h|; three derivatives by A. Equation "
     "from (24). Domain: A > 0, h < 0, lost <= 1/2.",
     8, 4, 1, NULL, inertia_bound_loops},
    {"share",
     "What zeta^2 A is of |h|: `lost` of the `bound`. Equation from (24). Domain: h < 0.",
     3, 1, 1, NULL, inertia_share_loops},
};

const sf_module sf_module_inertia = {"inertia", kernels, sizeof kernels / sizeof kernels[0]};
