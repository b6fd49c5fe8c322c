/* See state_lanes.h. */
#include "state_lanes.h"

#include <math.h>

#include "clones.h"
#include "conventions.h"

#define LESSER(a, b) ((a) < (b) ? (a) : (b))
#define GREATER(a, b) ((a) > (b) ? (a) : (b))
#define FINITE_SIZE(x) (fabs(x) < HUGE_VAL ? fabs(x) : 0.0)

/* The least of what lies above the line that falls from f_a with the slope `falls` <= 0 and above the one that rises to f_b
 * with `rises` >= 0, on a cell of this width: where both meet. */
static inline double least_between(double f_a, double f_b, double falls, double rises, double width)
{
    const double apart = falls - rises, meet = (f_b - f_a - rises * width) / (apart < 0 ? apart : -1.0);
    const double within = meet > 0 ? LESSER(meet, width) : 0.0;
    const double by_a = f_a + falls * within, by_b = f_b - rises * (width - within);
    /* a line without end tells nothing */
    return fabs(falls) < HUGE_VAL ? (rises < HUGE_VAL ? LESSER(by_a, by_b) : f_a + falls * width) : f_b - rises * width;
}

SF_WIDE static void judge(ptrdiff_t n, sf_state_cells *cells)
{
    n &= ~(ptrdiff_t)(SF_STATE_VECTOR - 1);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double a = cells->low[0][i], h_a = cells->low[1][i], h1_a = cells->low[2][i], h2_a = cells->low[3][i];
        const double b = cells->high[0][i], h_b = cells->high[1][i], h1_b = cells->high[2][i], h2_b = cells->high[3][i];
        const double h3_a = cells->low[4][i], h3_b = cells->high[4][i], base = cells->base[i];
        const double X = cells->asked[0][i], c = cells->asked[1][i], m = cells->asked[2][i], F_0 = cells->asked[3][i];
        const double width = b - a;
        const int is_steep = !(fabs(h3_a) < HUGE_VAL);

        /* what kernels and the roundings below may make of h_A and h_AA */
        const double near_a = a > base ? (a + fabs(h_a)) / sqrt((a - base) * (a + base)) : 0.0;
        const double near_b = (b + fabs(h_b)) / sqrt((b - base) * (b + base));
        const double size2 = FINITE_SIZE(h2_a) + fabs(h2_b), size1 = FINITE_SIZE(h1_a) + fabs(h1_b);
        const double e2 = SF_CLOSE * size2 + 4 * SF_DOUBT * b * (FINITE_SIZE(h3_a) + fabs(h3_b));
        const double e1 = SF_CLOSE * size1 + 4 * SF_DOUBT * (b * size2 + near_a + near_b);

        /* h_AA: monotone where h_AAA has one sign */
        const double h3_lo = LESSER(h3_a, h3_b), h3_hi = GREATER(h3_a, h3_b);
        const int h3_signed = (h3_lo >= 0) | (h3_hi <= 0);
        const double falls3 = LESSER(h3_lo, 0.0), rises3 = GREATER(h3_hi, 0.0);
        const double h2_least = LESSER(h2_a, h2_b), h2_most = GREATER(h2_a, h2_b);
        const double h2_under = least_between(h2_a, h2_b, falls3, rises3, width);
        const double h2_over = -least_between(-h2_a, -h2_b, -rises3, -falls3, width);
        const double h2_lo = (h3_signed ? h2_least : h2_under) - e2, h2_hi = (h3_signed ? h2_most : h2_over) + e2;

        /* h_A likewise */
        const int h2_signed = (h2_lo >= 0) | (h2_hi <= 0);
        const double falls2 = LESSER(h2_lo, 0.0), rises2 = GREATER(h2_hi, 0.0);
        const double h1_least = LESSER(h1_a, h1_b), h1_most = GREATER(h1_a, h1_b);
        const double h1_under = least_between(h1_a, h1_b, falls2, rises2, width);
        const double h1_over = -least_between(-h1_a, -h1_b, -rises2, -falls2, width);
        const double S_lo = X + (h2_signed ? h1_least : h1_under) - e1, S_hi = X + (h2_signed ? h1_most : h1_over) + e1;

        /* R: above its chord where it is concave, below it where it is convex */
        const double R_a = X * a + h_a, R_b = X * b + h_b;
        const double slope = GREATER(FINITE_SIZE(S_lo), FINITE_SIZE(S_hi));
        const double eR = SF_CLOSE * (fabs(h_a) + fabs(h_b) + b * (X + slope)) + width * e1;
        const double R_least = LESSER(R_a, R_b), R_most = GREATER(R_a, R_b);
        const double fallsR = LESSER(S_lo, 0.0), risesR = GREATER(S_hi, 0.0);
        const double R_under = least_between(R_a, R_b, fallsR, risesR, width);
        const double R_over = -least_between(-R_a, -R_b, -risesR, -fallsR, width);
        const int R_monotone = (S_lo >= 0) | (S_hi <= 0);
        const double R_lo = (R_monotone | (h2_hi <= 0) ? R_least : R_under) - eR;
        const double R_hi = (R_monotone | (h2_lo >= 0) ? R_most : R_over) + eR;

        /* F by R and I alone */
        const double I_a = c * a + m, I_b = c * b + m;
        const double R_near = R_lo > 0 ? R_lo : R_hi < 0 ? -R_hi : 0.0, R_far = GREATER(-R_lo, R_hi);
        const double eF = SF_CLOSE * (R_far * R_far + I_b * I_b + F_0 * F_0);
        const int is_above = R_near * R_near + (I_a - F_0) * (I_a + F_0) > eF;
        const int is_below = R_far * R_far + (I_b - F_0) * (I_b + F_0) < -eF;

        /* F_A/2 = c I + R S */
        const double p1 = R_lo * S_lo, p2 = R_lo * S_hi, p3 = R_hi * S_lo, p4 = R_hi * S_hi;
        const double p_lo = LESSER(LESSER(p1, p2), LESSER(p3, p4)), p_hi = GREATER(GREATER(p1, p2), GREATER(p3, p4));
        const int p_known = p1 + p2 + p3 + p4 == p1 + p2 + p3 + p4; /* no product of 0 and infinity, nor both infinities */
        const int is_rising = p_known & (p_lo + c * I_a > SF_CLOSE * (FINITE_SIZE(p_lo) + c * I_b));
        const int is_falling = p_known & (p_hi + c * I_b < -SF_CLOSE * (FINITE_SIZE(p_hi) + c * I_b));

        /* F_AA/2 = S^2 + R h_AA + c^2 */
        const double q1 = R_lo * h2_lo, q2 = R_lo * h2_hi, q3 = R_hi * h2_lo, q4 = R_hi * h2_hi;
        const double q_lo = LESSER(LESSER(q1, q2), LESSER(q3, q4)), q_hi = GREATER(GREATER(q1, q2), GREATER(q3, q4));
        const int q_known = q1 + q2 + q3 + q4 == q1 + q2 + q3 + q4;
        const double S_near = S_lo > 0 ? S_lo : S_hi < 0 ? -S_hi : 0.0, S_far = GREATER(-S_lo, S_hi);
        const double bend_lo = S_near * S_near + q_lo + c * c, bend_hi = S_far * S_far + q_hi + c * c;
        const int is_convex = q_known & (bend_lo > SF_CLOSE * (FINITE_SIZE(q_lo) + S_near * S_near + c * c));
        const int is_concave = q_known & (bend_hi < -SF_CLOSE * (FINITE_SIZE(q_hi) + S_far * S_far + c * c));

        /* the ends, and where their tangents meet */
        const double S_a = X + h1_a, S_b = X + h1_b;
        const double F_a = R_a * R_a + (I_a - F_0) * (I_a + F_0), F_b = R_b * R_b + (I_b - F_0) * (I_b + F_0);
        const double T_a = 2 * (c * I_a + R_a * S_a), T_b = 2 * (c * I_b + R_b * S_b);
        const int negative_a = F_a < 0, negative_b = F_b < 0, passes = negative_a != negative_b;
        const double apart = T_a - T_b, meet = (F_b - F_a - T_b * width) / (apart != 0 ? apart : 1.0);
        const double within = meet > 0 ? LESSER(meet, width) : 0.0;
        const double at_meet = F_a + T_a * within, by_b = F_b - T_b * (width - within);
        const double eT = SF_CLOSE * (fabs(F_a) + fabs(F_b) + eF + width * (FINITE_SIZE(T_a) + fabs(T_b))) +
                          4 * width * (R_far * e1 + slope * eR);
        const double tangents_lo = LESSER(at_meet, by_b), tangents_hi = GREATER(at_meet, by_b);
        /* where F rises from the low end or falls to the high one, the tangents do not meet inside */
        const double least = T_a >= 0 ? F_a : T_b <= 0 ? F_b : tangents_lo;
        const double most = T_a <= 0 ? F_a : T_b >= 0 ? F_b : tangents_hi;
        const int stays = (is_convex & (least > eT)) | (is_concave & (most < -eT));

        const int is_monotone = is_rising | is_falling;
        const int curves_away = negative_a ? is_convex : is_concave;
        const int has_none = is_above | is_below | ((passes == 0) & (is_monotone | curves_away | stays));
        const int has_one = passes & (is_monotone | is_convex | is_concave);

        /* whether rounding may decide a sign at an end */
        const double doubt_a = SF_CLOSE * (fabs(h_a) + a * (1 + fabs(h1_a) + X)), doubt_b = SF_CLOSE * (fabs(h_b) + b * (1 + fabs(h1_b) + X));
        const int close_a = (fabs(h1_a) < HUGE_VAL) &
                            !(fabs(F_a) > doubt_a * (2 * fabs(R_a) + doubt_a) + SF_CLOSE * (I_a * I_a + F_0 * F_0));
        const int close_b = !(fabs(F_b) > doubt_b * (2 * fabs(R_b) + doubt_b) + SF_CLOSE * (I_b * I_b + F_0 * F_0));
        const int is_known = (fabs(F_a) < HUGE_VAL) & (h1_a == h1_a) & (h2_a == h2_a) & (h3_a == h3_a) & (fabs(h1_b) < HUGE_VAL) &
                             (fabs(h2_b) < HUGE_VAL) & (fabs(h3_b) < HUGE_VAL);
        const int is_doubtful = close_a | close_b | !is_known;

        /* where an open cell is cut: where F seems to turn, or well inside (sf_amid) */
        const double turn = T_a / (apart != 0 ? apart : 1.0);
        const int seems_to_turn = (passes == 0) & (negative_a ? (T_a > 0) & (T_b < 0) : (T_a < 0) & (T_b > 0)) & (fabs(T_a) < HUGE_VAL);
        const double from_a = GREATER(LESSER(turn, 0.9375), 0.0625);
        const double steps = base > 0 ? base : 1.0, pa = a / steps, pb = b / steps;
        const double mean = 0.5 * (sqrt(GREATER((pa - 1) * (pa + 1), 0.0)) + sqrt(GREATER((pb - 1) * (pb + 1), 0.0)));
        const double amid = base > 0 ? base * sqrt(1 + mean * mean) : 0.5 * (a + b);
        const double inside = b > 4 * a ? (a > 0 ? sqrt(a) * sqrt(b) : 0.5 * b) : amid;
        const double open_cut = seems_to_turn ? a + from_a * width : inside;

        /* where F vanishes: by both values and slopes the cubic that gives A, else the parabola from the end whose slope is known */
        const double over = 1 / (F_b - F_a), chord = width * over, flat_a = 1 / T_a, flat_b = 1 / T_b;
        const double bend = (chord - flat_a) * over, third = ((flat_b - chord) * over - bend) * over;
        const double by_cubic = a - F_a * flat_a + F_a * F_a * (bend - F_b * third);
        const double rise = -T_b * width, curve = F_a - F_b - rise;
        const double root = sqrt(GREATER(rise * rise - 4 * curve * F_b, 0.0));
        const double by_parabola = b + 2 * F_b * width / (rise + (F_b > 0 ? -root : root));
        const double zero = (by_cubic > a) & (by_cubic < b) & !is_steep ? by_cubic
                            : (by_parabola > a) & (by_parabola < b) ? by_parabola
                                                                    : inside;

        cells->verdict[i] = is_doubtful ? SF_IS_DOUBTFUL : has_none ? SF_HAS_NONE : has_one ? SF_HAS_ONE : (double)SF_IS_OPEN;
        cells->cut[i] = has_one ? zero : open_cut;
        cells->rises[i] = negative_a;
    }
}

/* Halley's step, kept in the bracket */
SF_WIDE static void approach(ptrdiff_t n, sf_state_zeros *zeros)
{
    n &= ~(ptrdiff_t)(SF_STATE_VECTOR - 1);
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = zeros->at[0][i], h = zeros->at[1][i], h_A = zeros->at[2][i], h_AA = zeros->at[3][i];
        const double X = zeros->asked[0][i], c = zeros->asked[1][i], m = zeros->asked[2][i], F_0 = zeros->asked[3][i];
        const double R = X * A + h, S = X + h_A, I = c * A + m;
        const double F = R * R + (I - F_0) * (I + F_0), slope = 2 * (c * I + R * S), bend = 2 * (S * S + R * h_AA + c * c);
        const int is_low = (F < 0) == (zeros->rises[i] != 0);
        const double lo = is_low ? A : zeros->lo[i], hi = is_low ? zeros->hi[i] : A;
        const double step = 2 * F * slope / (2 * slope * slope - F * bend), next = A - step;
        const int is_inside = (next >= lo) & (next <= hi);
        zeros->lo[i] = lo, zeros->hi[i] = hi;
        zeros->next[i] = is_inside ? next : 0.5 * (lo + hi);
        zeros->moved[i] = is_inside ? fabs(step) : HUGE_VAL;
    }
}

static ptrdiff_t filled(ptrdiff_t n) { return (n + SF_STATE_VECTOR - 1) & ~(ptrdiff_t)(SF_STATE_VECTOR - 1); }

/* A row as far as whole vectors, with copies of the last. */
static void fill(double *row, ptrdiff_t n)
{
    for (ptrdiff_t i = n; i < filled(n); i++)
        row[i] = row[n - 1];
}

void sf_judge_lanes(sf_state_cells *cells)
{
    const ptrdiff_t n = cells->n;
    for (int k = 0; k < SF_PROBE_ROWS; k++)
        fill(cells->low[k], n), fill(cells->high[k], n);
    for (int k = 0; k < SF_ASKED_ROWS; k++)
        fill(cells->asked[k], n);
    fill(cells->base, n);
    judge(filled(n), cells);
}

void sf_approach_lanes(sf_state_zeros *zeros)
{
    const ptrdiff_t n = zeros->n;
    for (int k = 0; k < SF_PROBE_ROWS; k++)
        fill(zeros->at[k], n);
    for (int k = 0; k < SF_ASKED_ROWS; k++)
        fill(zeros->asked[k], n);
    fill(zeros->lo, n), fill(zeros->hi, n), fill(zeros->rises, n);
    approach(filled(n), zeros);
}
