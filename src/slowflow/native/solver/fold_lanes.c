/* See design_lanes.h. */
#include <math.h>

#include "clones.h"
#include "design_lanes.h"
#include "slow_flow.h"

/* where a fold is looked for at first, |k| over the least that it has there */
#define JUST_ABOVE 1.1

/* a step that is smaller, relatively, may lead out of the bracket by rounding */
#define NEARLY 0x1p-20

/* The function whose zeros are folds (`fold`) at an amplitude, its slope, Omega there and the square of the Omega by
 * its R. exists: whether it is defined, |k| being no less than sqrt(F_0^2 - m^2); is_close: whether rounding decides
 * that, or its sign */
typedef struct {
    double y, dy, Omega, square;
    int exists, is_close;
} value;

static inline value value_at(double A, double F_0, double m, double zeta, double h, double h_A, double h_AA, double k,
                             double least, double error_k) {
    double fold[3], tangent[2];
    slow_flow_intercept(A, h, h_A, h_AA, tangent);
    slow_flow_fold(A, F_0, m, zeta, h, h_A, k, tangent[1], fold);
    const double cosine = least / fabs(k), beyond = fabs(k) - least;
    const double of_k =
        fold[2] * slow_flow_I(fold[2], A, m, zeta) / (zeta * SF_GREATER((1 - cosine) * (1 + cosine), SF_CLOSE));
    const double size = F_0 + fabs(h) + A * (1 + SF_FINITE_SIZE(h_A)) + of_k;
    const int exists = beyond >= 0;
    return (value){fold[0], fold[1],
                   fold[2], slow_flow_fold_square(fold[2], A, fold[0]),
                   exists,  (!(fabs(beyond) > error_k)) | (exists & (!(fabs(fold[0]) > SF_CLOSE * size)))};
}

/* |k| at a fold with this Omega^2 */
static inline double size_of_k(double square, double A, double F_0, double m, double zeta, double least) {
    const double lag = 2 * zeta * A * sqrt(SF_GREATER(square, 0.0)), cosine = F_0 * lag / (least * least - m * lag);
    return least / sqrt(SF_GREATER((1 - cosine) * (1 + cosine), 0.01));
}

/* Where |k| is K next to where folds begin or end, by what is known at x: on the first piece it is nearly a power of x,
 * and above a breakpoint the jump's part of it falls with 1/x. */
static inline double where_k_is(double K, double x, double k, double k_x, double base, int begins) {
    const double ratio = K / fabs(k), power = k / (x * k_x), signed_K = (begins ? K : -K) * (k_x < 0 ? -1.0 : 1.0);
    const double by_power = x * ((1 + power) * ratio + (1 - power)) / ((1 - power) * ratio + (1 + power));
    const double by_jump = k_x * x * x / (k + k_x * x - signed_K);
    return base > 0 ? by_jump : by_power;
}

/* The amplitude of x, x^2 = A^2 - base^2 */
static inline double amplitude_at(double x, double base) { return base + x * x / (base + sqrt(base * base + x * x)); }

/* What `fold` has at a size of k: J falls as that rises, and I - m rises. */
typedef struct {
    double cosine, J, lag;
} at_k;

static inline at_k at_k_of(double k, double F_0, double m, double excess, double least) {
    const double t = least / k, cosine = sqrt(SF_GREATER((1 - t) * (1 + t), 0.0)), J = excess / (F_0 + m * cosine);
    return (at_k){cosine, J, J * cosine};
}

/* 0 times what has no bound is 0 */
#define TIMES(x, y) ((x) == 0 ? 0.0 : (y) == 0 ? 0.0 : (x) * (y))

SF_WIDE static void judge(ptrdiff_t n, sf_lane_cells *cells) {
    SF_EACH(i, n) {
        const double a = cells->low[0][i], h_a = cells->low[1][i], h1_a = cells->low[2][i], h2_a = cells->low[3][i];
        const double b = cells->high[0][i], h_b = cells->high[1][i], h1_b = cells->high[2][i], h2_b = cells->high[3][i];
        const double h3_a = cells->low[4][i], k_a = cells->low[5][i], h3_b = cells->high[4][i], k_b = cells->high[5][i];
        const double zeta = cells->task[1][i], m = cells->task[2][i], F_0 = cells->task[3][i], base = cells->base[i];
        const double width = b - a, excess = (F_0 - m) * (F_0 + m), least = sqrt(excess), of_zeta = 1 / (zeta * zeta);
        const sf_lane_slopes on = sf_slopes_on(a, h_a, h1_a, h2_a, h3_a, b, h_b, h1_b, h2_b, h3_b, base);

        /* h, and k, whose slope is -A h_AA */
        const double slope = SF_GREATER(SF_FINITE_SIZE(on.h1_lo), SF_FINITE_SIZE(on.h1_hi));
        const double error_h = SF_CLOSE * (F_0 + fabs(h_a) + fabs(h_b) + b * slope) + width * on.e1;
        const double h_lo = sf_lane_under(h_a, h_b, on.h1_lo, on.h1_hi, width) - error_h;
        const double h_hi = -sf_lane_under(-h_a, -h_b, -on.h1_hi, -on.h1_lo, width) + error_h;
        const double k1_lo = -(on.h2_hi * (on.h2_hi >= 0 ? b : a)), k1_hi = -(on.h2_lo * (on.h2_lo >= 0 ? a : b));
        const double error_k = SF_CLOSE * (SF_FINITE_SIZE(k_a) + fabs(k_b) + least) + b * on.e1;
        const double k_lo = sf_lane_under(k_a, k_b, k1_lo, k1_hi, width) - error_k;
        const double k_hi = -sf_lane_under(-k_a, -k_b, -k1_hi, -k1_lo, width) + error_k;

        /* folds are where |k| is no less than the least */
        const int is_above = k_hi >= least, is_below = k_lo <= -least, straddles = is_above & is_below;
        const double inner = is_above ? k_lo : -k_hi, outer = is_above ? k_hi : -k_lo;
        const double K_lo = SF_GREATER(inner, least), K_hi = SF_GREATER(outer, least);
        const at_k near = at_k_of(K_lo, F_0, m, excess, least), far = at_k_of(K_hi, F_0, m, excess, least);

        /* the function: h - F_0 J/k + A Omega^2 */
        const double of_k_lo = F_0 * far.J / K_hi, of_k_hi = F_0 * near.J / K_lo;
        const double inert_lo = 0.25 * of_zeta * near.lag * near.lag / b,
                     inert_hi = 0.25 * of_zeta * far.lag * far.lag / a;
        const double y_lo = h_lo + inert_lo + (is_above ? -of_k_hi : of_k_lo) - SF_CLOSE * (of_k_hi + inert_lo);
        const double y_hi = h_hi + inert_hi + (is_above ? -of_k_lo : of_k_hi) + SF_CLOSE * (of_k_hi + inert_hi);

        /* its slope: h_A - Omega^2 + F_0 J^2/k^2 (J/(2 zeta^2 A k) + (F_0 + m/share)/(F_0^2 - m^2)) k_A */
        const double rate_lo = 0.5 * of_zeta * far.J / (K_hi * b), rate_hi = 0.5 * of_zeta * near.J / (K_lo * a);
        const double force_lo = (F_0 + m / far.cosine) / excess,
                     force_hi = (F_0 + (m > 0 ? m / near.cosine : 0.0)) / excess;
        const double both_lo = is_above ? rate_lo + force_lo : force_lo - rate_hi,
                     both_hi = is_above ? rate_hi + force_hi : force_hi - rate_lo;
        const double P_lo = F_0 * (far.J / K_hi) * (far.J / K_hi), P_hi = F_0 * (near.J / K_lo) * (near.J / K_lo);
        const double C_lo = both_lo * (both_lo >= 0 ? P_lo : P_hi), C_hi = both_hi * (both_hi >= 0 ? P_hi : P_lo);
        const double p1 = TIMES(k1_lo, C_lo), p2 = TIMES(k1_lo, C_hi), p3 = TIMES(k1_hi, C_lo), p4 = TIMES(k1_hi, C_hi);
        const double p_lo = SF_LESSER(SF_LESSER(p1, p2), SF_LESSER(p3, p4)),
                     p_hi = SF_GREATER(SF_GREATER(p1, p2), SF_GREATER(p3, p4));
        const int p_known = p1 + p2 + p3 + p4 == p1 + p2 + p3 + p4;
        const double X_lo = inert_lo / b, X_hi = inert_hi / a;
        const double error_lo = SF_CLOSE * (SF_FINITE_SIZE(on.h1_lo) + SF_FINITE_SIZE(p_lo) + X_hi),
                     error_hi = SF_CLOSE * (SF_FINITE_SIZE(on.h1_hi) + SF_FINITE_SIZE(p_hi) + X_lo);
        const double dy_lo = on.h1_lo + p_lo - X_hi - error_lo, dy_hi = on.h1_hi + p_hi - X_lo + error_hi;
        const int is_monotone = p_known & ((dy_lo > 0) | (dy_hi < 0));

        /* the ends; where the channel begins or ends on the cell, at Omega = 0, it has the sign of h_A */
        const value at_a = value_at(a, F_0, m, zeta, h_a, h1_a, h2_a, k_a, least, error_k);
        const value at_b = value_at(b, F_0, m, zeta, h_b, h1_b, h2_b, k_b, least, error_k);
        const int begins = (at_a.exists == 0) & at_b.exists, ends = at_a.exists & (at_b.exists == 0);
        const int passes_least = ((k1_lo > 0) | (k1_hi < 0)) & ((on.h1_lo > 0) | (on.h1_hi < 0));
        const int is_throughout = inner > least;
        const int is_settled = (straddles == 0) & (is_throughout | ((begins | ends) & passes_least));
        const int negative_a = begins ? on.h1_hi < 0 : at_a.y < 0, negative_b = ends ? on.h1_hi < 0 : at_b.y < 0;
        const int passes = negative_a != negative_b;
        const double error_y = SF_CLOSE * (fabs(at_a.y) + fabs(at_b.y)) + error_h;
        const double under = sf_lane_under(at_a.y, at_b.y, dy_lo, dy_hi, width) - error_y,
                     over = -sf_lane_under(-at_a.y, -at_b.y, -dy_hi, -dy_lo, width) + error_y;
        const int stays = is_throughout & p_known & ((under > 0) | (over < 0));
        const int is_nowhere = (k_hi < least) & (k_lo > -least);
        const int has_none = is_nowhere | ((straddles == 0) & ((y_lo > 0) | (y_hi < 0) | stays)) |
                             (is_settled & is_monotone & (passes == 0));
        const int has_one = is_settled & is_monotone & passes;

        const int is_known = (fabs(h_a) < HUGE_VAL) & (h1_a == h1_a) & (h2_a == h2_a) & (h3_a == h3_a) & (k_a == k_a) &
                             (fabs(h1_b) < HUGE_VAL) & (fabs(h2_b) < HUGE_VAL) & (fabs(h3_b) < HUGE_VAL);

        /* an open cell is cut just below where the channel begins, or just above if it begins there, else where the
         * function seems to turn, or well inside */
        const double inside = sf_lane_amid(base, a, b), turn = at_a.dy / (at_a.dy - at_b.dy);
        const double below = 0.99 * where_k_is(least, b, k_b, -b * h2_b, 0, 1),
                     above = SF_GREATER(1.25 * a, 0.0625 * b);
        const int seems_to_turn = (at_a.dy * at_b.dy < 0) & is_throughout & (passes == 0);
        const double cosine = seems_to_turn ? SF_GREATER(SF_LESSER(turn, 0.75), 0.25) : (inside - a) / width;
        const double begun = (below > 1.001 * a) & (below < b) ? below : above;
        const double open_cut = begins & (b > 1.25 * a) ? begun : a + cosine * width;

        /* a zero lies next to where the channel begins or ends, or between its values; in x, x^2 = A^2 - base^2 */
        const double x_a = sqrt((a - base) * (a + base)), x_b = sqrt((b - base) * (b + base));
        const int from_a = ends & (fabs(k_a) < HUGE_VAL);
        const double A_0 = from_a ? a : b, x_0 = from_a ? x_a : x_b;
        const double k_0 = from_a ? k_a : k_b, h2_0 = from_a ? h2_a : h2_b;
        const double square = from_a ? at_a.square : at_b.square;
        const double K = fabs(k_0) >= least ? size_of_k(square, A_0, F_0, m, zeta, least) : JUST_ABOVE * least;
        const double last_step = where_k_is(K, x_0, k_0, -x_0 * h2_0, base, begins);
        const double at_end = (last_step > x_a) & (last_step < x_b) ? last_step : 0.5 * (x_a + x_b);
        const double between =
            sf_lane_zero(x_a, at_a.y, at_a.dy * x_a / a, x_b, at_b.y, at_b.dy * x_b / b, 0.5 * (x_a + x_b));
        const double at_zero = amplitude_at(is_throughout ? between : at_end, base);
        cells->cut[i] = has_one ? at_zero : open_cut;
        cells->verdict[i] = sf_verdict_of(at_a.is_close | at_b.is_close | (is_known == 0), has_none, has_one);
        cells->rises[i] = negative_a;
    }
}

/* Where the function vanishes by this amplitude and the one before, in x; next to where the channel begins or ends at
 * first by what |k| is there. Omega from F = 0, which at a fold A changes to second order only. */
SF_WIDE static void approach(ptrdiff_t n, sf_lane_zeros *zeros) {
    SF_EACH(i, n) {
        const double A = zeros->at[0][i], h = zeros->at[1][i], h_A = zeros->at[2][i], h_AA = zeros->at[3][i],
                     k = zeros->at[5][i], base = zeros->base[i];
        const double zeta = zeros->task[1][i], m = zeros->task[2][i], F_0 = zeros->task[3][i];
        const double least = sqrt((F_0 - m) * (F_0 + m));
        const value at = value_at(A, F_0, m, zeta, h, h_A, h_AA, k, least, 0);
        /* where it is not defined, it has the sign that it has where it begins or ends */
        const int is_low = (at.exists ? at.y : h_A) * (1 - 2 * zeros->rises[i]) > 0,
                  begins = h_A * (1 - 2 * zeros->rises[i]) > 0;
        const double lo = is_low ? A : zeros->lo[i], hi = is_low ? zeros->hi[i] : A;
        const double x = sqrt((A - base) * (A + base)), x_lo = sqrt((lo - base) * (lo + base)),
                     x_hi = sqrt((hi - base) * (hi + base)), slope = at.dy * x / A;
        const double before = zeros->last[0][i], y_before = zeros->last[1][i], slope_before = zeros->last[2][i];
        const double by_y = sf_next_from(x, at.y, slope, before, y_before, slope_before, x_lo, x_hi);
        const double K = at.exists ? size_of_k(at.square, A, F_0, m, zeta, least) : JUST_ABOVE * least;
        const double by_k = where_k_is(K, x, k, -x * h_AA, base, begins);
        const int is_first = (at.exists == 0) | ((fabs(k) < 2 * least) & (before != before));
        const double far = is_first & (by_k > x_lo) & (by_k < x_hi) ? by_k : at.exists ? by_y : 0.5 * (x_lo + x_hi);
        const double step = at.exists ? at.y / slope : HUGE_VAL, next = fabs(step) <= NEARLY * x ? x - step : far;
        const double w = at.Omega, F = slow_flow_F(w, A, F_0, m, zeta, h);
        zeros->lo[i] = lo, zeros->hi[i] = hi;
        zeros->next[i] = amplitude_at(next, base);
        zeros->change[i] = fabs(step);
        zeros->Omega[i] = w - F / slow_flow_F_Omega(w, A, m, zeta, h);
        zeros->last[0][i] = at.exists ? x : NAN, zeros->last[1][i] = at.y, zeros->last[2][i] = slope;
    }
}

SF_DEFINE_QUESTION(sf_judge_folds, sf_approach_folds)
