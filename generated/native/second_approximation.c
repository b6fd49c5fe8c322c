/* Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5: loops for NumPy.

   Written by `make derive`; never edit.
   Input: second_approximation.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "second_approximation.h"

#include "kernels.h"

SF_LOOP(second_approximation_response_loop, 9,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i], h_A =
        in[6][i], h_AA = in[7][i], h_3 = in[8][i], h_3_A = in[9][i], h_3_AA = in[10][i], h_5 = in[11][i], h_5_A =
        in[12][i], h_5_AA = in[13][i];
    second_approximation_response(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA,
        values);
)

SF_LOOP(second_approximation_detachment_loop, 3,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
        in[6][i], h_3 = in[7][i], h_3_A = in[8][i], h_3_AA = in[9][i], h_5 = in[10][i], h_5_A = in[11][i], h_5_AA =
        in[12][i];
    second_approximation_detachment(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA,
        values);
)

SF_LOOP(second_approximation_detachment_by_inertia_loop, 3,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i], h_AA =
        in[6][i], h_3 = in[7][i], h_3_A = in[8][i], h_3_AA = in[9][i], h_5 = in[10][i], h_5_A = in[11][i], h_5_AA =
        in[12][i];
    second_approximation_detachment_by_inertia(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A,
        h_5_AA, values);
)

SF_LOOP(second_approximation_folds_loop, 3,
    const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i], h_A =
        in[6][i], h_AA = in[7][i], h_AAA = in[8][i], h_3 = in[9][i], h_3_A = in[10][i], h_3_AA = in[11][i], h_3_AAA
        = in[12][i], h_5 = in[13][i], h_5_A = in[14][i], h_5_AA = in[15][i], h_5_AAA = in[16][i];
    second_approximation_folds(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_3, h_3_A, h_3_AA, h_3_AAA, h_5, h_5_A,
        h_5_AA, h_5_AAA, values);
)

SF_LOOP(second_approximation_components_loop, 7,
    const double Omega = in[0][i], A = in[1][i], m = in[2][i], h = in[3][i], h_3 = in[4][i], h_5 = in[5][i];
    second_approximation_components(Omega, A, m, h, h_3, h_5, values);
)

SF_LOOP(second_approximation_wave_loop, 2,
    const double turned = in[0][i], Omega = in[1][i], m = in[2][i], A_1 = in[3][i], sine = in[4][i], cosine =
        in[5][i], a_3 = in[6][i], a_5 = in[7][i], kappa = in[8][i];
    second_approximation_wave(turned, Omega, m, A_1, sine, cosine, a_3, a_5, kappa, values);
)

static const sf_kernel kernels[] = {
    {"response", 14, 9, 1, NULL, SF_ONE(second_approximation_response_loop)},
    {"detachment", 13, 3, 1, NULL, SF_ONE(second_approximation_detachment_loop)},
    {"detachment_by_inertia", 13, 3, 1, NULL, SF_ONE(second_approximation_detachment_by_inertia_loop)},
    {"folds", 17, 3, 1, NULL, SF_ONE(second_approximation_folds_loop)},
    {"components", 6, 7, 1, NULL, SF_ONE(second_approximation_components_loop)},
    {"wave", 9, 2, 1, NULL, SF_ONE(second_approximation_wave_loop)},
};

const sf_module sf_module_second_approximation = {"second_approximation", kernels, sizeof kernels / sizeof kernels[0]};
