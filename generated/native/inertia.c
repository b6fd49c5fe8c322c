/* Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance: loops for NumPy.

   Written by `make derive`; never edit.
   Input: inertia.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "inertia.h"

#include "kernels.h"

SF_LOOP(inertia_force_loop, 1,
    const double Omega = in[0][i], F_0 = in[1][i];
    values[0] = inertia_force(Omega, F_0);
)

SF_LOOP(inertia_force_slopes_loop, 2,
    const double Omega = in[0][i], F_0 = in[1][i];
    inertia_force_slopes(Omega, F_0, values);
)

SF_LOOP(inertia_level_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    values[0] = inertia_level(Omega, A, m, zeta, h);
)

SF_LOOP(inertia_F_loop, 1,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i];
    values[0] = inertia_F(Omega, A, F_0, m, zeta, h);
)

SF_LOOP(inertia_level_slope_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    values[0] = inertia_level_slope(Omega, A, m, zeta, h);
)

SF_LOOP(inertia_Omega_A_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
    values[0] = inertia_Omega_A(Omega, A, m, zeta, h, h_A);
)

SF_LOOP(inertia_outer_falling_loop, 2,
    const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    inertia_outer_falling(A, F_0, m, zeta, h, values);
)
SF_LOOP(inertia_outer_rising_loop, 2,
    const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i];
    inertia_outer_rising(A, F_0, m, zeta, h, values);
)

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

SF_LOOP(inertia_terms_loop, 3,
    const double A = in[0][i], m = in[1][i], zeta = in[2][i], h = in[3][i];
    inertia_terms(A, m, zeta, h, values);
)

SF_LOOP(inertia_least_loop, 1,
    const double fall = in[0][i], linear = in[1][i], rest = in[2][i];
    values[0] = inertia_least(fall, linear, rest);
)

SF_LOOP(inertia_least_Omega_A_loop, 1,
    const double x = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i];
    values[0] = inertia_least_Omega_A(x, A, m, zeta, h, h_A);
)

SF_LOOP(inertia_peak_loop, 2,
    const double x = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i], h_A =
        in[6][i];
    inertia_peak(x, A, F_0, m, zeta, h, h_A, values);
)

SF_LOOP(inertia_isola_loop, 2,
    const double x = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
        in[6][i];
    inertia_isola(x, A, m, zeta, h, h_A, h_AA, values);
)

SF_LOOP(inertia_isola_apart_loop, 1,
    const double x = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], k = in[5][i], cubic =
        in[6][i];
    values[0] = inertia_isola_apart(x, A, m, zeta, h, k, cubic);
)

SF_LOOP(inertia_fold_slopes_loop, 3,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], k = in[4][i];
    inertia_fold_slopes(Omega, A, m, zeta, k, values);
)

SF_LOOP(inertia_fold_force_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], other = in[4][i];
    values[0] = inertia_fold_force(Omega, A, m, zeta, other);
)

SF_LOOP(inertia_fold_level_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], other = in[4][i];
    values[0] = inertia_fold_level(Omega, A, m, zeta, other);
)

SF_LOOP(inertia_peak_share_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i];
    values[0] = inertia_peak_share(Omega, A, m, zeta);
)

SF_LOOP(inertia_Omega_of_share_loop, 1,
    const double A = in[0][i], F_0 = in[1][i], m = in[2][i], zeta = in[3][i], share = in[4][i];
    values[0] = inertia_Omega_of_share(A, F_0, m, zeta, share);
)

SF_LOOP(inertia_level_rise_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
        in[6][i];
    values[0] = inertia_level_rise(Omega, A, m, zeta, h, h_A, h_AA);
)

SF_LOOP(inertia_cusp_bend_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
        in[6][i], h_AAA = in[7][i];
    values[0] = inertia_cusp_bend(Omega, A, m, zeta, h, h_A, h_AA, h_AAA);
)

SF_LOOP(inertia_hessian_loop, 1,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
        in[6][i];
    values[0] = inertia_hessian(Omega, A, m, zeta, h, h_A, h_AA);
)

SF_LOOP(inertia_bound_loop, 4,
    const double A = in[0][i], F_0 = in[1][i], zeta = in[2][i], h = in[3][i], h_A = in[4][i], h_AA = in[5][i], h_AAA
        = in[6][i], lost = in[7][i];
    inertia_bound(A, F_0, zeta, h, h_A, h_AA, h_AAA, lost, values);
)

SF_LOOP(inertia_share_loop, 1,
    const double A = in[0][i], zeta = in[1][i], h = in[2][i];
    values[0] = inertia_share(A, zeta, h);
)

static const sf_kernel kernels[] = {
    {"force", 2, 1, 1, NULL, SF_ONE(inertia_force_loop)},
    {"force_slopes", 2, 2, 1, NULL, SF_ONE(inertia_force_slopes_loop)},
    {"level", 5, 1, 1, NULL, SF_ONE(inertia_level_loop)},
    {"F", 6, 1, 1, NULL, SF_ONE(inertia_F_loop)},
    {"level_slope", 5, 1, 1, NULL, SF_ONE(inertia_level_slope_loop)},
    {"Omega_A", 6, 1, 1, NULL, SF_ONE(inertia_Omega_A_loop)},
    {"outer", 5, 2, 2, inertia_outer_regime, inertia_outer_loops},
    {"terms", 4, 3, 1, NULL, SF_ONE(inertia_terms_loop)},
    {"least", 3, 1, 1, NULL, SF_ONE(inertia_least_loop)},
    {"least_Omega_A", 6, 1, 1, NULL, SF_ONE(inertia_least_Omega_A_loop)},
    {"peak", 7, 2, 1, NULL, SF_ONE(inertia_peak_loop)},
    {"isola", 7, 2, 1, NULL, SF_ONE(inertia_isola_loop)},
    {"isola_apart", 7, 1, 1, NULL, SF_ONE(inertia_isola_apart_loop)},
    {"fold_slopes", 5, 3, 1, NULL, SF_ONE(inertia_fold_slopes_loop)},
    {"fold_force", 5, 1, 1, NULL, SF_ONE(inertia_fold_force_loop)},
    {"fold_level", 5, 1, 1, NULL, SF_ONE(inertia_fold_level_loop)},
    {"peak_share", 4, 1, 1, NULL, SF_ONE(inertia_peak_share_loop)},
    {"Omega_of_share", 5, 1, 1, NULL, SF_ONE(inertia_Omega_of_share_loop)},
    {"level_rise", 7, 1, 1, NULL, SF_ONE(inertia_level_rise_loop)},
    {"cusp_bend", 8, 1, 1, NULL, SF_ONE(inertia_cusp_bend_loop)},
    {"hessian", 7, 1, 1, NULL, SF_ONE(inertia_hessian_loop)},
    {"bound", 8, 4, 1, NULL, SF_ONE(inertia_bound_loop)},
    {"share", 3, 1, 1, NULL, SF_ONE(inertia_share_loop)},
};

const sf_module sf_module_inertia = {"inertia", kernels, sizeof kernels / sizeof kernels[0]};
