/* See design_lanes.h. */
#include "design_lanes.h"

#include <math.h>

#include "clones.h"
#include "slow_flow.h"

SF_WIDE static void judge(ptrdiff_t n, sf_lane_cells *cells) {
    SF_EACH(i, n) {
        const double a = cells->low[0][i], h_a = cells->low[1][i], h1_a = cells->low[2][i], h2_a = cells->low[3][i];
        const double b = cells->high[0][i], h_b = cells->high[1][i], h1_b = cells->high[2][i], h2_b = cells->high[3][i];
        const double h3_a = cells->low[4][i], h3_b = cells->high[4][i], base = cells->base[i];
        const double Omega = cells->task[0][i], zeta = cells->task[1][i], m = cells->task[2][i],
                     F_0 = cells->task[3][i];
        const double width = b - a, X = Omega * Omega, c = 2 * zeta * Omega; /* slopes of R - h and of I */

        const sf_lane_slopes on = sf_slopes_on(a, h_a, h1_a, h2_a, h3_a, b, h_b, h1_b, h2_b, h3_b, base);
        const double S_lo = X + on.h1_lo, S_hi = X + on.h1_hi, h2_lo = on.h2_lo, h2_hi = on.h2_hi, e1 = on.e1;

        /* R: above its chord where it is concave, below it where it is convex */
        const double R_a = slow_flow_R(Omega, a, h_a), R_b = slow_flow_R(Omega, b, h_b);
        const double slope = SF_GREATER(SF_FINITE_SIZE(S_lo), SF_FINITE_SIZE(S_hi));
        const double eR = SF_CLOSE * (fabs(h_a) + fabs(h_b) + b * (X + slope)) + width * e1;
        const double R_least = SF_LESSER(R_a, R_b), R_most = SF_GREATER(R_a, R_b);
        const double R_under = sf_lane_under(R_a, R_b, S_lo, S_hi, width);
        const double R_over = -sf_lane_under(-R_a, -R_b, -S_hi, -S_lo, width);
        const double R_lo = (h2_hi <= 0 ? R_least : R_under) - eR;
        const double R_hi = (h2_lo >= 0 ? R_most : R_over) + eR;

        /* F by R and I alone */
        const double I_a = slow_flow_I(Omega, a, m, zeta), I_b = slow_flow_I(Omega, b, m, zeta);
        const double R_near = R_lo > 0 ? R_lo : R_hi < 0 ? -R_hi : 0.0, R_far = SF_GREATER(-R_lo, R_hi);
        const double eF = SF_CLOSE * (R_far * R_far + I_b * I_b + F_0 * F_0);
        const int is_above = R_near * R_near + (I_a - F_0) * (I_a + F_0) > eF;
        const int is_below = R_far * R_far + (I_b - F_0) * (I_b + F_0) < -eF;

        /* F_A/2 = c I + R S */
        const double p1 = R_lo * S_lo, p2 = R_lo * S_hi, p3 = R_hi * S_lo, p4 = R_hi * S_hi;
        const double p_lo = SF_LESSER(SF_LESSER(p1, p2), SF_LESSER(p3, p4)),
                     p_hi = SF_GREATER(SF_GREATER(p1, p2), SF_GREATER(p3, p4));
        const int p_known =
            p1 + p2 + p3 + p4 == p1 + p2 + p3 + p4; /* no product of 0 and infinity, nor both infinities */
        const int is_rising = p_known & (p_lo + c * I_a > SF_CLOSE * (SF_FINITE_SIZE(p_lo) + c * I_b));
        const int is_falling = p_known & (p_hi + c * I_b < -SF_CLOSE * (SF_FINITE_SIZE(p_hi) + c * I_b));

        /* F_AA/2 = S^2 + R h_AA + c^2 */
        const double q1 = R_lo * h2_lo, q2 = R_lo * h2_hi, q3 = R_hi * h2_lo, q4 = R_hi * h2_hi;
        const double q_lo = SF_LESSER(SF_LESSER(q1, q2), SF_LESSER(q3, q4)),
                     q_hi = SF_GREATER(SF_GREATER(q1, q2), SF_GREATER(q3, q4));
        const int q_known = q1 + q2 + q3 + q4 == q1 + q2 + q3 + q4;
        const double S_near = S_lo > 0 ? S_lo : S_hi < 0 ? -S_hi : 0.0, S_far = SF_GREATER(-S_lo, S_hi);
        const double bend_lo = S_near * S_near + q_lo + c * c, bend_hi = S_far * S_far + q_hi + c * c;
        const int is_convex = q_known & (bend_lo > SF_CLOSE * (SF_FINITE_SIZE(q_lo) + S_near * S_near + c * c));
        const int is_concave = q_known & (bend_hi < -SF_CLOSE * (SF_FINITE_SIZE(q_hi) + S_far * S_far + c * c));

        /* the ends, and where their tangents meet */
        const double F_a = slow_flow_F(Omega, a, F_0, m, zeta, h_a), F_b = slow_flow_F(Omega, b, F_0, m, zeta, h_b);
        const double T_a = slow_flow_F_A(Omega, a, m, zeta, h_a, h1_a),
                     T_b = slow_flow_F_A(Omega, b, m, zeta, h_b, h1_b);
        const int negative_a = F_a < 0, negative_b = F_b < 0, passes = negative_a != negative_b;
        const double apart = T_a - T_b, meet = (F_b - F_a - T_b * width) / (apart != 0 ? apart : 1.0);
        const double within = meet > 0 ? SF_LESSER(meet, width) : 0.0;
        const double at_meet = F_a + T_a * within, by_b = F_b - T_b * (width - within);
        const double eT = SF_CLOSE * (fabs(F_a) + fabs(F_b) + eF + width * (SF_FINITE_SIZE(T_a) + fabs(T_b))) +
                          4 * width * (R_far * e1 + slope * eR);
        const double tangents_lo = SF_LESSER(at_meet, by_b), tangents_hi = SF_GREATER(at_meet, by_b);
        /* where F rises from the low end or falls to the high one, the tangents do not meet inside */
        const double least = T_a >= 0 ? F_a : T_b <= 0 ? F_b : tangents_lo;
        const double most = T_a <= 0 ? F_a : T_b >= 0 ? F_b : tangents_hi;
        const int stays = (is_convex & (least > eT)) | (is_concave & (most < -eT));

        const int is_monotone = is_rising | is_falling;
        const int curves_away = negative_a ? is_convex : is_concave;
        const int has_none = is_above | is_below | ((passes == 0) & (is_monotone | curves_away | stays));
        const int has_one = passes & (is_monotone | is_convex | is_concave);

        /* whether rounding may decide a sign at an end */
        const double error_a = SF_CLOSE * (fabs(h_a) + a * (1 + fabs(h1_a) + X)),
                     error_b = SF_CLOSE * (fabs(h_b) + b * (1 + fabs(h1_b) + X));
        const int close_a = (fabs(h1_a) < HUGE_VAL) &
                            !(fabs(F_a) > error_a * (2 * fabs(R_a) + error_a) + SF_CLOSE * (I_a * I_a + F_0 * F_0));
        const int close_b = !(fabs(F_b) > error_b * (2 * fabs(R_b) + error_b) + SF_CLOSE * (I_b * I_b + F_0 * F_0));
        const int is_known = (fabs(F_a) < HUGE_VAL) & (h1_a == h1_a) & (h2_a == h2_a) & (h3_a == h3_a) &
                             (fabs(h1_b) < HUGE_VAL) & (fabs(h2_b) < HUGE_VAL) & (fabs(h3_b) < HUGE_VAL);

        /* where an open cell is cut: where F seems to turn, or well inside (sf_amid) */
        const double turn = T_a / (apart != 0 ? apart : 1.0);
        const int seems_to_turn =
            (passes == 0) & (negative_a ? (T_a > 0) & (T_b < 0) : (T_a < 0) & (T_b > 0)) & (fabs(T_a) < HUGE_VAL);
        const double from_a = SF_GREATER(SF_LESSER(turn, 0.9375), 0.0625);
        const double inside = sf_lane_amid(base, a, b);
        const double open_cut = seems_to_turn ? a + from_a * width : inside;

        cells->verdict[i] = sf_verdict_of(close_a | close_b | !is_known, has_none, has_one);
        cells->cut[i] = has_one ? sf_lane_zero(a, F_a, T_a, b, F_b, T_b, inside) : open_cut;
        cells->rises[i] = negative_a;
    }
}

SF_WIDE static void approach(ptrdiff_t n, sf_lane_zeros *zeros) {
    SF_EACH(i, n) {
        const double A = zeros->at[0][i], h = zeros->at[1][i], h_A = zeros->at[2][i], h_AA = zeros->at[3][i];
        const double Omega = zeros->task[0][i], zeta = zeros->task[1][i], m = zeros->task[2][i],
                     F_0 = zeros->task[3][i];
        const double F = slow_flow_F(Omega, A, F_0, m, zeta, h), slope = slow_flow_F_A(Omega, A, m, zeta, h, h_A);
        const double bend = slow_flow_F_AA(Omega, A, m, zeta, h, h_A, h_AA);
        const int is_low = (F < 0) == (zeros->rises[i] != 0);
        sf_halley(zeros, i, A, is_low, F, slope, bend);
    }
}

SF_DEFINE_QUESTION(sf_judge_states, sf_approach_states)
