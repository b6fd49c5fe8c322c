/* See design_lanes.h. */
#define SF_INTERVALS_IN_LANES
#include <math.h>

#include "clones.h"
#include "design_lanes.h"
#include "slow_flow.h"
#include "slow_flow_intervals.h"

/* rho of a power of A that h may nearly be, as in cells.h */
#define HIGHEST_POWER 16

/* The larger root of x^2 + 2 a x + b, b <= 0, but for less than SF_DOUBT of it: nothing cancels. */
static inline double larger_root_at(double a, double b)
{
    const double sum = sqrt(a * a - b) + fabs(a);
    return a > 0 ? -b / sum : sum;
}

/* The same on a cell, as sf_larger_root_range has it. */
static inline sf_interval larger_root(sf_interval a, sf_interval b, sf_interval root)
{
    const sf_interval sum = sfi_sub(root, a), quotient = sfi_neg(sfi_div(b, sfi_add(a, root)));
    const double most = larger_root_at(a.lo, b.lo) * (1 + SF_DOUBT), least = larger_root_at(a.hi, b.hi) * (1 - SF_DOUBT);
    double lo = sum.lo, hi = sum.hi;
    lo = (a.lo >= 0) & (quotient.lo > lo) ? quotient.lo : lo, hi = (a.lo >= 0) & (quotient.hi < hi) ? quotient.hi : hi;
    hi = (b.lo <= 0) & (most < hi) ? most : hi;
    lo = (b.hi <= 0) & (least > lo) ? least : lo;
    return sfi_of(lo, hi);
}

/* By a sign, 1 or -1 */
static inline sf_interval signed_as(double sign, sf_interval a)
{
    const double lo = sign * a.lo, hi = sign * a.hi, known = sfi_known(a);
    return sfi_of(known + SF_LESSER(lo, hi), known + SF_GREATER(lo, hi));
}

/* The larger root for a sign of 1, the smaller one for -1 */
static inline sf_interval root_on(sf_interval a, sf_interval b, sf_interval root, double sign)
{
    return signed_as(sign, larger_root(signed_as(sign, a), b, root));
}

static inline double root_at(double a, double b, double root, double sign)
{
    const double turned = sign * a, quotient = -b / (turned + root), sum = root - turned;
    return sign * (turned > 0 ? quotient : sum);
}

/* The function of a channel at an amplitude, as sf_ask_cusp has it; least: positive where it is defined */
typedef struct {
    double y, least;
} value;

static inline value value_at(double A, double h, double h_A, double h_AA, double h_AAA, double k, double m, double zeta, double sign)
{
    double q[5], R[2], cusp[4];
    slow_flow_cusps(A, zeta, h, h_A, h_AA, k, q);
    const double root = sqrt(SF_GREATER(q[4], 0.0)), X = root_at(q[2], q[3], root, sign), T = root_at(q[0], q[1], root, sign);
    slow_flow_cusp_R(A, zeta, h_AA, k, X, T, R);
    const double of_R = fabs(R[0]) < SF_CANCELLED * fabs(k) ? R[1] : R[0];
    slow_flow_cusp(A, m, zeta, h_AA, h_AAA, k, X, T, of_R, sign * root, cusp);
    const value found = {cusp[0], SF_LESSER(X, q[4] >= 0 ? 1.0 : -1.0)};
    return found;
}

/* The verdict on a channel of cell i, in terms of what `judge` knows of the cell: stated once, as gcc vectorises no loop in a
 * loop. The larger Omega^2, channel 0, has the larger t where h_AA > 0. */
#define JUDGE(CHANNEL, SIGN) \
    { \
        const double sign = SIGN; \
        const double sign_t = of_h_AA * sign; \
        const sf_interval t = root_on(q[0], q[1], root, sign_t), whole = slow_flow_intervals_cusp_X(A, h_A, h_AA, t); \
        const sf_interval X = sfi_of(whole.lo > 0 ? whole.lo : 0.0, whole.hi); \
        const sf_interval y = slow_flow_intervals_cusp_scaled(A, m, zeta, h_AA, kappa, X, t); \
        const sf_interval level = slow_flow_intervals_cusp_scaled_level(A, m, zeta, h_AA, kappa, X, t); \
        const sf_interval dy = slow_flow_intervals_cusp_scaled_slope(A, m, zeta, h_AA, kappa, rho, X, t, signed_as(sign_t, root)); \
        const int is_throughout = (whole.lo > 0) & (q[2].lo > 0); \
        const int is_nowhere = (kappa.lo >= 0) | (q[2].hi < 0) | (whole.hi <= 0) | (y.lo > 0) | (y.hi < 0) | (level.lo > most); \
        const int is_monotone = (dy.lo > 0) | (dy.hi < 0); \
        const value at_a = value_at(a, h_a, h1_a, h2_a, h3_a, k_a, m_, zeta_, sign); \
        const value at_b = value_at(b, h_b, h1_b, h2_b, h3_b, k_b, m_, zeta_, sign); \
        const double product = at_a.y * at_b.y, defined = SF_LESSER(at_a.least, at_b.least); \
        const int is_settled = is_scaled & is_throughout & is_monotone & (defined > 0); \
        const int has_none = (is_scaled & is_nowhere) | is_free | (is_settled & (product > 0)), has_one = is_settled & (product < 0); \
        cells->verdict[CHANNEL][i] = has_none ? SF_HAS_NONE : has_one ? SF_HAS_ONE : (double)SF_IS_OPEN; \
    }

SF_WIDE static void judge(ptrdiff_t n, sf_cusp_cells *cells)
{
    n &= ~(ptrdiff_t)(SF_LANE_VECTOR - 1);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double a = cells->low[0][i], h_a = cells->low[1][i], h1_a = cells->low[2][i], h2_a = cells->low[3][i];
        const double b = cells->high[0][i], h_b = cells->high[1][i], h1_b = cells->high[2][i], h2_b = cells->high[3][i];
        const double h3_a = cells->low[4][i], k_a = cells->low[5][i], h3_b = cells->high[4][i], k_b = cells->high[5][i];
        const double m_ = cells->asked[0][i], zeta_ = cells->asked[1][i], most = cells->asked[2][i], width = b - a;
        const sf_lane_slopes on = sf_slopes_on(a, h_a, h1_a, h2_a, h3_a, b, h_b, h1_b, h2_b, h3_b, 0);
        const sf_interval A = sfi_of(a, b), h_A = sfi_of(on.h1_lo, on.h1_hi), h_AA = sfi_of(on.h2_lo, on.h2_hi);
        const sf_interval m = sfi_point(m_), zeta = sfi_point(zeta_);

        /* next to A = 0: sf_is_free_of_folds */
        const double square = zeta_ * zeta_, apart = h_A.hi - h_A.lo, of_slope = 16 * square * (h_A.hi + square);
        const int rises = ((h_A.lo >= 0) | (h_A.hi <= 0)) & (h_A.lo + 2 * square > SF_CLOSE * (fabs(h_A.lo) + square));
        const int is_free = (a + fabs(h_a) == 0) & (rises | (apart * apart + of_slope < -SF_CLOSE * (apart * apart + fabs(of_slope))));

        /* sf_scaled */
        const double of_h_AA = h2_a < 0 ? -1.0 : 1.0, from = fabs(h2_a);
        const double least_h_AA = signed_as(of_h_AA, h_AA).lo;
        const double s_lo = SF_LESSER(of_h_AA * h3_a, of_h_AA * h3_b), s_hi = SF_GREATER(of_h_AA * h3_a, of_h_AA * h3_b);
        const double rho_lo = SF_LESSER(a * s_lo / from, b * s_lo / (from + s_hi * width));
        const double rho_hi = SF_GREATER(a * s_hi / from, b * s_hi / (from + s_lo * width));
        const sf_interval rho = sfi_of((1 - SF_DOUBT) * rho_lo, (1 + SF_DOUBT) * rho_hi);
        const int is_scaled = (least_h_AA > 0) & (a > 0) & (s_lo >= 0) & (rho.hi < HIGHEST_POWER);
        const double first = k_a / (a * a * h2_a), last = k_b / (b * b * h2_b), doubt = 4 * SF_DOUBT * (1 + fabs(first));
        const sf_interval rough = sfi_of(SF_LESSER(first, -1 / (2 + rho.lo)) - doubt, SF_GREATER(first, -1 / (2 + rho.hi)) + doubt);
        const sf_interval bent = sfi_add(sfi_point(1), sfi_mul(rough, sfi_add(sfi_point(2), rho)));
        const sf_interval slope = sfi_neg(sfi_div(bent, A));
        const double off = 2 * doubt + SF_DOUBT * width * (fabs(slope.lo) + fabs(slope.hi));
        const sf_interval kappa = sfi_both(rough, sfi_of(sf_lane_under(first, last, slope.lo, slope.hi, width) - off,
                                                         -sf_lane_under(-first, -last, -slope.hi, -slope.lo, width) + off));

        /* sf_range_cusp_scaled */
        sf_interval q[3];
        slow_flow_intervals_cusps_scaled(A, zeta, h_A, h_AA, kappa, q);
        const sf_interval root = sfi_sqrt(q[2]);
        JUDGE(0, 1.0)
        JUDGE(1, -1.0)
    }
}

void sf_judge_cusps(sf_cusp_cells *cells)
{
    for (int k = 0; k < SF_CUSP_ROWS; k++)
        sf_fill(cells->low[k], cells->n), sf_fill(cells->high[k], cells->n);
    for (int k = 0; k < SF_CUSP_ASKED_ROWS; k++)
        sf_fill(cells->asked[k], cells->n);
    judge(sf_filled(cells->n), cells);
}
