/* See second_lanes.h. */
#include "second_lanes.h"

#include "clones.h"
#include "second_approximation.h"
#include "second_conventions.h"

/* The loop of all; `phase` and `by_inertia` are known when it is compiled. */
#define OVER_STATES(phase, by_inertia)                                                                                 \
    const double *restrict h = known, *restrict h_A = known + n, *restrict h_AA = known + 2 * n;                       \
    const double *restrict h_3 = known + 4 * n, *restrict h_3_A = known + 5 * n, *restrict h_3_AA = known + 6 * n;     \
    const double *restrict h_5 = known + 8 * n, *restrict h_5_A = known + 9 * n, *restrict h_5_AA = known + 10 * n;    \
    double *restrict u_max = out, *restrict A_1 = out + n, *restrict phi = out + 2 * n, *restrict R = out + 3 * n;     \
    double *restrict F = out + 4 * n, *restrict F_A = out + 5 * n, *restrict F_Omega = out + 6 * n;                    \
    double *restrict R_A = out + 7 * n, *restrict R_Omega = out + 8 * n;                                               \
    SF_EACH(i, n) {                                                                                                    \
        double values[SF_BALANCE];                                                                                     \
        second_approximation_response(Omega[i], A[i], (by_inertia) ? inertia_force(Omega[i], F_0) : F_0, m, zeta, h[i], \
                                      h_A[i], h_AA[i], h_3[i], h_3_A[i], h_3_AA[i], h_5[i], h_5_A[i], h_5_AA[i],       \
                                      values);                                                                         \
        u_max[i] = values[0], A_1[i] = values[1];                                                                      \
        phi[i] = (phase) ? values[2] : NAN;                                                                            \
        R[i] = values[3], F[i] = values[4], F_A[i] = values[5], R_A[i] = values[7];                                    \
        F_Omega[i] = values[6] - ((by_inertia) ? sf_force_squared_slope(Omega[i], F_0) : 0);                           \
        R_Omega[i] = values[8];                                                                                        \
    }

SF_WIDE void sf_second_balances(ptrdiff_t n, const double *Omega, const double *A, double F_0, int inertial, int phases,
                                double m, double zeta, const double *known, double *out)
{
    if (inertial && phases) {
        OVER_STATES(1, 1);
    } else if (inertial) {
        OVER_STATES(0, 1);
    } else if (phases) {
        OVER_STATES(1, 0);
    } else {
        OVER_STATES(0, 0);
    }
}

static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

SF_WIDE void sf_second_matches(ptrdiff_t n, const double *Omega, const double *R, const double *way, double F_0,
                               const double *balances, double *out)
{
    const double *restrict at_R = balances + 3 * n, *restrict R_Omega = balances + 8 * n;
    double *restrict steps = out, *restrict growth = out + n;
    SF_EACH(i, n) {
        const double R_z = R_Omega[i] * Omega[i] / F_0, off = (R[i] - at_R[i]) / F_0;
        const double step = (R_z * off - SF_WEIGHT * SF_WEIGHT * way[i]) / (R_z * R_z + SF_WEIGHT * SF_WEIGHT);
        const double below = step > SF_LONGEST ? SF_LONGEST : step, within = below > -SF_LONGEST ? below : -SF_LONGEST;
        steps[i] = within, growth[i] = sf_short_exp(within);
    }
}

SF_WIDE void sf_second_newton(ptrdiff_t n, const double *Omega, const double *A, double F_0, const double *balances,
                              double *out)
{
    const double *restrict R = balances + 3 * n, *restrict at_F = balances + 4 * n, *restrict F_A = balances + 5 * n;
    const double *restrict F_Omega = balances + 6 * n, *restrict R_A = balances + 7 * n;
    const double *restrict R_Omega = balances + 8 * n;
    double *restrict sizes = out, *restrict done = out + n, *restrict next_R = out + 2 * n;
    double *restrict to_A = out + 3 * n, *restrict growth_A = out + 4 * n;
    double *restrict to_Omega = out + 5 * n, *restrict growth_Omega = out + 6 * n;
    const double per = 1 / F_0;
    SF_EACH(i, n) {
        const double F = at_F[i] * per * per, F_x = F_A[i] * A[i] * per * per, F_z = F_Omega[i] * Omega[i] * per * per;
        const double R_x = R_A[i] * A[i] * per, R_z = R_Omega[i] * Omega[i] * per;
        /* the gradient in the metric dx^2 + dR^2 + (WEIGHT dz)^2 */
        const double to_x = (R_z * R_z + SF_WEIGHT * SF_WEIGHT) * F_x - R_x * R_z * F_z;
        const double to_z = (1 + R_x * R_x) * F_z - R_x * R_z * F_x;
        const double way = -F / (F_x * to_x + F_z * to_z), x = way * to_x, z = way * to_z;
        const double y = R_x * x + R_z * z, size = larger(fabs(x), larger(fabs(y), fabs(z)));
        const double ratio = size > SF_LONGEST ? SF_LONGEST / size : 1;
        sizes[i] = size, next_R[i] = R[i] + F_0 * ratio * y;
        /* on a peak as sharp as a needle R/F_0 is known to no more */
        done[i] = SF_MOVED + SF_ROUNDING * A[i] * Omega[i] * Omega[i] / F_0;
        to_A[i] = ratio * x, growth_A[i] = sf_short_exp(ratio * x);
        to_Omega[i] = ratio * z, growth_Omega[i] = sf_short_exp(ratio * z);
    }
}
