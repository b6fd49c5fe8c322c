/* See second_lanes.h. */
#include "second_lanes.h"

#include "clones.h"
#include "second_approximation.h"

/* The loop of both; `phase` is known when it is compiled. */
#define OVER_STATES(phase)                                                                                             \
    const double *restrict h = known, *restrict h_A = known + n, *restrict h_AA = known + 2 * n;                       \
    const double *restrict h_3 = known + 4 * n, *restrict h_3_A = known + 5 * n, *restrict h_3_AA = known + 6 * n;     \
    const double *restrict h_5 = known + 8 * n, *restrict h_5_A = known + 9 * n, *restrict h_5_AA = known + 10 * n;    \
    double *restrict u_max = out, *restrict A_1 = out + n, *restrict phi = out + 2 * n, *restrict R = out + 3 * n;     \
    double *restrict F = out + 4 * n, *restrict F_A = out + 5 * n, *restrict F_Omega = out + 6 * n;                    \
    double *restrict R_A = out + 7 * n, *restrict R_Omega = out + 8 * n;                                               \
    n &= ~(ptrdiff_t)(SF_VECTOR - 1);                                                                                  \
    SF_INDEPENDENT                                                                                                     \
    for (ptrdiff_t i = 0; i < n; i++) {                                                                                \
        double values[SF_BALANCE];                                                                                     \
        second_approximation_response(Omega[i], A[i], F_0, m, zeta, h[i], h_A[i], h_AA[i], h_3[i], h_3_A[i],           \
                                      h_3_AA[i], h_5[i], h_5_A[i], h_5_AA[i], values);                                 \
        u_max[i] = values[0], A_1[i] = values[1];                                                                      \
        if (phase)                                                                                                     \
            phi[i] = values[2];                                                                                        \
        R[i] = values[3], F[i] = values[4], F_A[i] = values[5], F_Omega[i] = values[6], R_A[i] = values[7];            \
        R_Omega[i] = values[8];                                                                                        \
    }                                                                                                                  \
    (void)phi

SF_WIDE void sf_second_balances(ptrdiff_t n, const double *Omega, const double *A, double F_0, double m, double zeta,
                                const double *known, double *out)
{
    OVER_STATES(0);
}

SF_WIDE void sf_second_answers(ptrdiff_t n, const double *Omega, const double *A, double F_0, double m, double zeta,
                               const double *known, double *out)
{
    OVER_STATES(1);
}
