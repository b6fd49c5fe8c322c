/* Second approximation of any mechanism, with higher harmonics, in A = A_1 + a_3 + a_5: loops for NumPy.

   Written by `make derive`; never edit.
   Input: second_approximation.h, the same functions for one number each
   Tools: sympy 1.14.0, python-flint 0.9.0, jinja2 3.1.6 */

#include "second_approximation.h"

#include "kernels.h"

static SF_WIDE void second_approximation_response_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict Omega = in[0];
    const double *restrict A = in[1];
    const double *restrict F_0 = in[2];
    const double *restrict m = in[3];
    const double *restrict zeta = in[4];
    const double *restrict h = in[5];
    const double *restrict h_A = in[6];
    const double *restrict h_AA = in[7];
    const double *restrict h_3 = in[8];
    const double *restrict h_3_A = in[9];
    const double *restrict h_3_AA = in[10];
    const double *restrict h_5 = in[11];
    const double *restrict h_5_A = in[12];
    const double *restrict h_5_AA = in[13];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    double *restrict out_4 = out[4];
    double *restrict out_5 = out[5];
    double *restrict out_6 = out[6];
    double *restrict out_7 = out[7];
    double *restrict out_8 = out[8];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        double values[9];
        second_approximation_response(Omega[i], A[i], F_0[i], m[i], zeta[i], h[i], h_A[i], h_AA[i], h_3[i],
            h_3_A[i], h_3_AA[i], h_5[i], h_5_A[i], h_5_AA[i], values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
        out_4[i] = values[4];
        out_5[i] = values[5];
        out_6[i] = values[6];
        out_7[i] = values[7];
        out_8[i] = values[8];
    }
}

static const sf_loop second_approximation_response_loops[] = {
    second_approximation_response_loop,
};

static SF_WIDE void second_approximation_detachment_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict Omega = in[0];
    const double *restrict A = in[1];
    const double *restrict m = in[2];
    const double *restrict zeta = in[3];
    const double *restrict h = in[4];
    const double *restrict h_A = in[5];
    const double *restrict h_AA = in[6];
    const double *restrict h_3 = in[7];
    const double *restrict h_3_A = in[8];
    const double *restrict h_3_AA = in[9];
    const double *restrict h_5 = in[10];
    const double *restrict h_5_A = in[11];
    const double *restrict h_5_AA = in[12];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    double *restrict out_3 = out[3];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        double values[4];
        second_approximation_detachment(Omega[i], A[i], m[i], zeta[i], h[i], h_A[i], h_AA[i], h_3[i], h_3_A[i],
            h_3_AA[i], h_5[i], h_5_A[i], h_5_AA[i], values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
        out_3[i] = values[3];
    }
}

static const sf_loop second_approximation_detachment_loops[] = {
    second_approximation_detachment_loop,
};

static SF_WIDE void second_approximation_folds_loop(ptrdiff_t n, const double *const *in, double *const *out)
{
    const double *restrict Omega = in[0];
    const double *restrict A = in[1];
    const double *restrict F_0 = in[2];
    const double *restrict m = in[3];
    const double *restrict zeta = in[4];
    const double *restrict h = in[5];
    const double *restrict h_A = in[6];
    const double *restrict h_AA = in[7];
    const double *restrict h_AAA = in[8];
    const double *restrict h_3 = in[9];
    const double *restrict h_3_A = in[10];
    const double *restrict h_3_AA = in[11];
    const double *restrict h_3_AAA = in[12];
    const double *restrict h_5 = in[13];
    const double *restrict h_5_A = in[14];
    const double *restrict h_5_AA = in[15];
    const double *restrict h_5_AAA = in[16];
    double *restrict out_0 = out[0];
    double *restrict out_1 = out[1];
    double *restrict out_2 = out[2];
    n = SF_WHOLE(n);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        double values[3];
        second_approximation_folds(Omega[i], A[i], F_0[i], m[i], zeta[i], h[i], h_A[i], h_AA[i], h_AAA[i], h_3[i],
            h_3_A[i], h_3_AA[i], h_3_AAA[i], h_5[i], h_5_A[i], h_5_AA[i], h_5_AAA[i], values);
        out_0[i] = values[0];
        out_1[i] = values[1];
        out_2[i] = values[2];
    }
}

static const sf_loop second_approximation_folds_loops[] = {
    second_approximation_folds_loop,
};

static const sf_kernel kernels[] = {
    {"response",
     "Largest displacement, A_1 and phase, R, F, and dF/dA, dF/dOmega, dR/dA, dR/dOmega. Equation beyond (23). "
     "Domain: Omega > 0, A > 0, |h| < 9 A Omega^2.",
     14, 9, 1, NULL, second_approximation_response_loops},
    {"detachment",
     "R, I, largest displacement, and what vanishes where the forcing that reaches it is least. Equation beyond "
     "(23). Domain: Omega > 0, A > 0, |h| < 9 A Omega^2.",
     13, 4, 1, NULL, second_approximation_detachment_loops},
    {"folds",
     "F and its derivatives: a fold has F = F_A = 0, a cusp all three. Equation beyond (23). Domain: Omega > 0, A > "
     "0, |h| < 9 A Omega^2.",
     17, 3, 1, NULL, second_approximation_folds_loops},
};

const sf_module sf_module_second_approximation = {"second_approximation", kernels, sizeof kernels / sizeof kernels[0]};
