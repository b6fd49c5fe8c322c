/* Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5: loops for NumPy.

   Written by `make derive`; never edit.
   Input: second_approximation.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "second_approximation.h"

#include "kernels.h"

static SF_WIDE void second_approximation_response_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i],
            h_A = in[6][i], h_AA = in[7][i], h_3 = in[8][i], h_3_A = in[9][i], h_3_AA = in[10][i], h_5 = in[11][i],
            h_5_A = in[12][i], h_5_AA = in[13][i];
        double values[9];
        second_approximation_response(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA,
            values);
        for (int k = 0; k < 9; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop second_approximation_response_loops[] = {second_approximation_response_loop};

static SF_WIDE void second_approximation_detachment_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i], h_3 = in[7][i], h_3_A = in[8][i], h_3_AA = in[9][i], h_5 = in[10][i], h_5_A =
            in[11][i], h_5_AA = in[12][i];
        double values[4];
        second_approximation_detachment(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA,
            values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop second_approximation_detachment_loops[] = {second_approximation_detachment_loop};

static SF_WIDE void second_approximation_detachment_by_inertia_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], m = in[2][i], zeta = in[3][i], h = in[4][i], h_A = in[5][i],
            h_AA = in[6][i], h_3 = in[7][i], h_3_A = in[8][i], h_3_AA = in[9][i], h_5 = in[10][i], h_5_A =
            in[11][i], h_5_AA = in[12][i];
        double values[4];
        second_approximation_detachment_by_inertia(Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A,
            h_5_AA, values);
        for (int k = 0; k < 4; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop second_approximation_detachment_by_inertia_loops[] = {second_approximation_detachment_by_inertia_loop};

static SF_WIDE void second_approximation_folds_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    SF_EACH(i, n) {
        const double Omega = in[0][i], A = in[1][i], F_0 = in[2][i], m = in[3][i], zeta = in[4][i], h = in[5][i],
            h_A = in[6][i], h_AA = in[7][i], h_AAA = in[8][i], h_3 = in[9][i], h_3_A = in[10][i], h_3_AA =
            in[11][i], h_3_AAA = in[12][i], h_5 = in[13][i], h_5_A = in[14][i], h_5_AA = in[15][i], h_5_AAA =
            in[16][i];
        double values[3];
        second_approximation_folds(Omega, A, F_0, m, zeta, h, h_A, h_AA, h_AAA, h_3, h_3_A, h_3_AA, h_3_AAA, h_5,
            h_5_A, h_5_AA, h_5_AAA, values);
        for (int k = 0; k < 3; k++)
            out[k][i] = values[k];
    }
}

static const sf_loop second_approximation_folds_loops[] = {second_approximation_folds_loop};

static const sf_kernel kernels[] = {
    {"response",
     "Largest displacement, A_1 and phase, R, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega. Equation beyond (23). "
     "Domain: Omega > 0, A > 0, |h| < 9 A Omega^2.",
     14, 9, 1, NULL, second_approximation_response_loops},
    {"detachment",
     "R, I, largest displacement, and what vanishes where the forcing that reaches it is least. Equation beyond "
     "(23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2.",
     13, 4, 1, NULL, second_approximation_detachment_loops},
    {"detachment_by_inertia",
     "The same of an excitation by inertia. Equation beyond (23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2.",
     13, 4, 1, NULL, second_approximation_detachment_by_inertia_loops},
    {"folds",
     "F and its derivatives: a fold has F = F_A = 0, a cusp all three. Equation beyond (23). Domain: Omega > 0, A > "
     "0, |h| < 9 A Omega^2.",
     17, 3, 1, NULL, second_approximation_folds_loops},
};

const sf_module sf_module_second_approximation = {"second_approximation", kernels, sizeof kernels / sizeof kernels[0]};
