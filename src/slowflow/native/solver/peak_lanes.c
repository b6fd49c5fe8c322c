/* See design_lanes.h. */
#include <math.h>

#include "clones.h"
#include "design_lanes.h"
#include "slow_flow.h"

/* distance of rho from 1 up to which critical points may meet, or have lost digits */
#define MAY_MEET 0x1p-20

/* F at a critical point w, and its slope along A. size: R^2 + I^2 + F_0^2. For m = 0 the lower one is w = 0, where
 * these are NaN: no verdict asks for it then */
typedef struct {
    double y, rise, size;
} value;

static inline value value_at(double w, double A, double F_0, double m, double zeta, double h_A) {
    double peak[2];
    slow_flow_peak(w, A, F_0, m, zeta, h_A, peak);
    return (value){peak[0], peak[1], peak[0] + 2 * F_0 * F_0};
}

/* Whether F at critical points between w_lo and w_hi, on amplitudes from a to b, has no zero, or one at most */
typedef struct {
    int has_sign, rises, falls;
} channel;

static inline channel channel_on(double w_lo, double w_hi, double a, double b, double F_0, double m, double zeta,
                                 sf_lane_slopes on) {
    const double q = m * zeta, e = 2 * zeta * zeta;
    const double R_lo = e * a + (m > 0 ? q / w_hi : 0.0), R_hi = e * b + (m > 0 ? q / w_lo : 0.0);
    const double I_lo = 2 * zeta * a * w_lo + m, I_hi = 2 * zeta * b * w_hi + m;
    const double error = 4 * SF_CLOSE * (R_hi * R_hi + I_hi * I_hi + F_0 * F_0);
    const double S_lo = w_lo * w_lo - on.h1_hi, S_hi = w_hi * w_hi - on.h1_lo;
    return (channel){(R_lo * R_lo + (I_lo - F_0) * (I_lo + F_0) > error) |
                         (R_hi * R_hi + (I_hi - F_0) * (I_hi + F_0) < -error),
                     S_lo > 4 * SF_CLOSE * (w_lo * w_lo + SF_FINITE_SIZE(on.h1_hi)),
                     S_hi < -4 * SF_CLOSE * (w_hi * w_hi + SF_FINITE_SIZE(on.h1_lo))};
}

SF_WIDE static void judge(ptrdiff_t n, sf_lane_cells *cells) {
    SF_EACH(i, n) {
        const double a = cells->low[0][i], h_a = cells->low[1][i], h1_a = cells->low[2][i], h2_a = cells->low[3][i];
        const double b = cells->high[0][i], h_b = cells->high[1][i], h1_b = cells->high[2][i], h2_b = cells->high[3][i];
        const double h3_a = cells->low[4][i], h3_b = cells->high[4][i], base = cells->base[i];
        const double zeta = cells->task[1][i], m = cells->task[2][i], F_0 = cells->task[3][i];
        const double width = b - a, q = m * zeta, e = 2 * zeta * zeta;
        const sf_lane_slopes on = sf_slopes_on(a, h_a, h1_a, h2_a, h3_a, b, h_b, h1_b, h2_b, h3_b, base);

        /* h, and p of the cubic: a critical point exists where both corners have it, and lies between theirs */
        const double slope = SF_GREATER(SF_FINITE_SIZE(on.h1_lo), SF_FINITE_SIZE(on.h1_hi));
        const double error_h = SF_CLOSE * (fabs(h_a) + fabs(h_b) + b * (e + slope)) + width * on.e1;
        const double h_least = SF_LESSER(h_a, h_b), h_most = SF_GREATER(h_a, h_b);
        const double h_under = sf_lane_under(h_a, h_b, on.h1_lo, on.h1_hi, width);
        const double h_over = -sf_lane_under(-h_a, -h_b, -on.h1_hi, -on.h1_lo, width);
        const double p_lo = (on.h2_hi <= 0 ? h_least : h_under) + e * a - error_h;
        const double p_hi = (on.h2_lo >= 0 ? h_most : h_over) + e * b + error_h;
        const sf_lane_critical low = sf_lane_critical_at(a, p_lo, q), high = sf_lane_critical_at(b, p_hi, q);
        const int is_nowhere = (p_lo >= 0) | (low.rho > 1 + MAY_MEET),
                  is_throughout = (p_hi < 0) & (high.rho < 1 - MAY_MEET);
        const channel lower = channel_on(low.w1 * (1 - SF_CLOSE), high.w1 * (1 + SF_CLOSE), a, b, F_0, m, zeta, on);
        const channel upper = channel_on(high.w2 * (1 - SF_CLOSE), low.w2 * (1 + SF_CLOSE), a, b, F_0, m, zeta, on);

        /* at the ends */
        double cubic_a[3], cubic_b[3];
        slow_flow_peak_cubic(a, m, zeta, h_a, cubic_a), slow_flow_peak_cubic(b, m, zeta, h_b, cubic_b);
        const sf_lane_critical at_a = sf_lane_critical_at(a, cubic_a[1], q),
                               at_b = sf_lane_critical_at(b, cubic_b[1], q);
        const value lower_a = value_at(at_a.w1, a, F_0, m, zeta, h1_a),
                    lower_b = value_at(at_b.w1, b, F_0, m, zeta, h1_b);
        const value upper_a = value_at(at_a.w2, a, F_0, m, zeta, h1_a),
                    upper_b = value_at(at_b.w2, b, F_0, m, zeta, h1_b);
        const int lower_known =
            (fabs(lower_a.y) > 8 * SF_CLOSE * lower_a.size) & (fabs(lower_b.y) > 8 * SF_CLOSE * lower_b.size);
        const int upper_known =
            (fabs(upper_a.y) > 8 * SF_CLOSE * upper_a.size) & (fabs(upper_b.y) > 8 * SF_CLOSE * upper_b.size);
        const int lower_passes = (lower_a.y < 0) != (lower_b.y < 0), upper_passes = (upper_a.y < 0) != (upper_b.y < 0);
        /* the maximum over Omega has a peak only where it falls to 0 */
        const int lower_none =
            (m == 0) | lower.has_sign | lower.rises | (lower.falls & lower_known & (lower_passes == 0));
        const int upper_none = upper.has_sign | ((upper.rises | upper.falls) & upper_known & (upper_passes == 0));
        const int upper_one = upper.rises & upper_known & upper_passes & (upper_a.y < 0);
        const int is_known = (fabs(h_a) < HUGE_VAL) & (h1_a == h1_a) & (h2_a == h2_a) & (h3_a == h3_a) &
                             (fabs(h_b) < HUGE_VAL) & (fabs(h1_b) < HUGE_VAL) & (fabs(h2_b) < HUGE_VAL) &
                             (fabs(h3_b) < HUGE_VAL) & (a > 0);
        const int has_none = is_nowhere | (is_throughout & lower_none & upper_none);
        const int has_one = is_throughout & lower_none & upper_one;
        cells->verdict[i] = sf_verdict_of(is_known == 0, has_none, has_one);
        cells->cut[i] = sf_lane_zero(a, upper_a.y, upper_a.rise, b, upper_b.y, upper_b.rise, sf_lane_amid(base, a, b));
        cells->rises[i] = 1.0;
    }
}

/* F at its minimum over Omega, and Omega there */
SF_WIDE static void approach(ptrdiff_t n, sf_lane_zeros *zeros) {
    SF_EACH(i, n) {
        const double A = zeros->at[0][i], h = zeros->at[1][i], h_A = zeros->at[2][i], h_AA = zeros->at[3][i];
        const double zeta = zeros->task[1][i], m = zeros->task[2][i], F_0 = zeros->task[3][i];
        double cubic[3];
        slow_flow_peak_cubic(A, m, zeta, h, cubic);
        const double q = cubic[0], p = cubic[1], rough = sf_lane_critical_at(A, p, q).w2;
        const double w =
            rough - (rough * (A * rough * rough + p) + q) / (3 * A * rough * rough + p); /* Newton's step */
        const value at = value_at(w, A, F_0, m, zeta, h_A);
        const double w_A = slow_flow_peak_Omega_A(w, A, m, zeta, h_A);
        const double bend =
            slow_flow_F_AA(w, A, m, zeta, h, h_A, h_AA) + slow_flow_F_AOmega(w, A, m, zeta, h, h_A) * w_A;
        const double step = sf_halley(zeros, i, A, at.y < 0, at.y, at.rise, bend);
        zeros->Omega[i] = w - w_A * step;
    }
}

SF_DEFINE_QUESTION(sf_judge_peaks, sf_approach_peaks)
