/* See second_lanes.h. */
#include "second_lanes.h"

#include "clones.h"
#include "second_approximation.h"
#include "second_conventions.h"

/* phases: known when it is compiled */
SF_ALWAYS void balances(ptrdiff_t n, const double *Omega, const double *A, double F_0, int inertial, int phases,
                        double m, double zeta, const double *known, double *out) {
    SF_EACH(i, n) {
        const double *const k = known + i;
        double values[SF_BALANCE];
        second_approximation_response(Omega[i], A[i], inertial ? inertia_force(Omega[i], F_0) : F_0, m, zeta, k[0],
                                      k[n], k[2 * n], k[4 * n], k[5 * n], k[6 * n], k[8 * n], k[9 * n], k[10 * n],
                                      values);
        values[6] -= inertial ? sf_force_squared_slope(Omega[i], F_0) : 0;
        for (int row = 0; row < SF_BALANCE; row++)
            out[row * n + i] = row == 2 && !phases ? NAN : values[row];
    }
}

SF_WIDE void sf_second_balances(ptrdiff_t n, const double *Omega, const double *A, double F_0, int inertial, int phases,
                                double m, double zeta, const double *known, double *out) {
    if (phases)
        balances(n, Omega, A, F_0, inertial, 1, m, zeta, known, out);
    else
        balances(n, Omega, A, F_0, inertial, 0, m, zeta, known, out);
}

static inline double larger(double a, double b) { return a > b ? a : b; }

SF_WIDE void sf_second_matches(ptrdiff_t n, const double *Omega, const double *R, const double *way, double F_0,
                               const double *balances, double *out) {
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
                              double *out) {
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
