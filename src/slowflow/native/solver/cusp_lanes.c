/* See design_lanes.h. */
#include <math.h>

#include "clones.h"
#include "design_lanes.h"
#include "slow_flow.h"

/* rho of a power of A that h may nearly be; next to a steep corner h_AA grows faster */
#define HIGHEST_POWER 16
/* of A^3 h_AA^2, and of its inverse: beyond it products might underflow */
#define SMALLEST 0x1p-900

static inline double root_at(double a, double b, double root, double sign) {
    const double turned = sign * a, quotient = -b / (turned + root), sum = root - turned;
    return sign * (turned > 0 ? quotient : sum);
}

/* The function of a channel at an amplitude, its slope, and Omega of a cusp there, as sf_ask_cusp has it; least:
 * positive where it is defined. sign: 1 of the channel of the larger Omega^2, -1 of the other one */
typedef struct {
    double y, dy, Omega, least;
} value;

static inline value value_at(double A, double h, double h_A, double h_AA, double h_AAA, double k, double m, double zeta,
                             double sign) {
    double q[5], R[2], cusp[4];
    slow_flow_cusps(A, zeta, h, h_A, h_AA, k, q);
    const double root = sqrt(SF_GREATER(q[4], 0.0)), X = root_at(q[2], q[3], root, sign),
                 T = root_at(q[0], q[1], root, sign);
    slow_flow_cusp_R(A, zeta, h_AA, k, X, T, R);
    const double of_R = fabs(R[0]) < SF_CANCELLED * fabs(k) ? R[1] : R[0];
    slow_flow_cusp(A, m, zeta, h_AA, h_AAA, k, X, T, of_R, sign * root, cusp);
    return (value){cusp[0], cusp[2], sqrt(X), SF_LESSER(X, q[4] >= 0 ? 1.0 : -1.0)};
}

/* x times any number of a range from lo to hi, x > 0 from x_lo to x_hi: the least, or with the ends in turn the most */
#define LEAST(lo, x_lo, x_hi) ((lo) * ((lo) >= 0 ? (x_lo) : (x_hi)))
#define MOST(hi, x_lo, x_hi) ((hi) * ((hi) >= 0 ? (x_hi) : (x_lo)))

/* What is known of both channels on a cell, with B = A |h_AA|: tau = dR/dA / B is a root of tau^2 + 2 a tau + b, and
 * then Omega^2 = B tau - h_A; kappa = k/(A^2 h_AA), rho = A h_AAA/h_AA (derivations/systems/along.py claims all of it)
 */
typedef struct {
    double a, b, m, zeta, most, sign, B_lo, B_hi, P_lo, P_hi, h_A_lo, h_A_hi, kappa_lo, kappa_hi, rho_lo, rho_hi;
} shared;

typedef struct {
    int none, throughout, monotone;
} channel;

/* A channel whose tau lies between these. F_A/2 over P = A B^2 is (kappa - 1) (t - 1) - 1 + Q/P, t = dR/dA / (A h_AA),
 * Q = 2 m zeta Omega; its slope has the factors rho (kappa + t) + 3 t and kappa + 2 t + (m zeta/(A Omega) + 4
 * zeta^2)/(A h_AA), and no other that vanishes; F_0^2 is m^2 + A Q + A P kappa (kappa + t). Each is bounded by its
 * terms. */
static inline channel channel_on(shared of, double tau_lo, double tau_hi) {
    const double turned = of.sign > 0 ? 1.0 : 0.0, kappa_lo = of.kappa_lo, kappa_hi = of.kappa_hi;
    const double t_lo = turned > 0 ? tau_lo : -tau_hi, t_hi = turned > 0 ? tau_hi : -tau_lo;
    const double size = SF_GREATER(fabs(tau_lo), fabs(tau_hi)), deep = SF_GREATER(-kappa_lo, 1.0);
    const double error_X = SF_ERROR * (of.B_hi * size + SF_GREATER(fabs(of.h_A_lo), fabs(of.h_A_hi)));
    const double X_lo = LEAST(tau_lo, of.B_lo, of.B_hi) - of.h_A_hi - error_X;
    const double X_hi = MOST(tau_hi, of.B_lo, of.B_hi) - of.h_A_lo + error_X;
    const double w_lo = sqrt(SF_GREATER(X_lo, 0.0)), w_hi = sqrt(SF_GREATER(X_hi, 0.0));

    const double q = of.m * of.zeta, Q_lo = 2 * q * w_lo * (1 - SF_ERROR), Q_hi = 2 * q * w_hi * (1 + SF_ERROR);
    const double u_lo = 1 - kappa_hi, u_hi = 1 - kappa_lo, error_e = SF_ERROR * (u_hi * (1 + size) + 1);
    const double e_lo = LEAST(1 - t_hi, u_lo, u_hi) - 1 - error_e, e_hi = MOST(1 - t_lo, u_lo, u_hi) - 1 + error_e;
    const int is_positive = e_lo * of.P_hi + Q_lo > 0, is_negative = (e_hi < 0) & (e_hi * of.P_lo + Q_hi < 0);

    const double sum_lo = kappa_lo + t_lo, sum_hi = kappa_hi + t_hi, error_s = SF_ERROR * (size + deep);
    const double c = -MOST(sum_hi + error_s, -kappa_hi, -kappa_lo);
    const double level = of.m * of.m + of.a * Q_lo + LEAST(c, of.a * of.P_lo, of.b * of.P_hi);
    const double error_F = SF_ERROR * (of.m * of.m + of.a * Q_lo + of.b * of.P_hi * fabs(c));
    const int is_above = (kappa_hi <= 0) & (level - error_F > of.most * of.most);

    const double error_g = 4 * (1 + of.rho_hi) * error_s;
    const double g_lo = LEAST(sum_lo, of.rho_lo, of.rho_hi) + 3 * t_lo,
                 g_hi = MOST(sum_hi, of.rho_lo, of.rho_hi) + 3 * t_hi;
    const double of_zeta = 4 * of.zeta * of.zeta;
    const double by_hi = (q / (of.b * w_hi) + of_zeta) / of.B_hi * (1 - SF_ERROR);
    const double by_lo = (q / (of.a * w_lo) + of_zeta) / of.B_lo * (1 + SF_ERROR);
    const double k_lo = sum_lo + t_lo + (turned > 0 ? by_hi : -by_lo),
                 k_hi = sum_hi + t_hi + (turned > 0 ? by_lo : -by_hi);
    const double error_k = 4 * error_s + SF_ERROR * by_lo;
    return (channel){(X_hi <= 0) | is_positive | is_negative | is_above, X_lo > 0,
                     ((g_lo > error_g) | (g_hi < -error_g)) & ((k_lo > error_k) | (k_hi < -error_k))};
}

SF_WIDE static void judge(ptrdiff_t n, sf_lane_cells *cells) {
    SF_EACH(i, n) {
        const double a = cells->low[0][i], h_a = cells->low[1][i], h1_a = cells->low[2][i], h2_a = cells->low[3][i];
        const double b = cells->high[0][i], h_b = cells->high[1][i], h1_b = cells->high[2][i], h2_b = cells->high[3][i];
        const double h3_a = cells->low[4][i], k_a = cells->low[5][i], h3_b = cells->high[4][i], k_b = cells->high[5][i];
        const double which = cells->task[0][i], zeta = cells->task[1][i], m = cells->task[2][i],
                     most = cells->task[3][i], width = b - a;
        const sf_lane_slopes on = sf_slopes_on(a, h_a, h1_a, h2_a, h3_a, b, h_b, h1_b, h2_b, h3_b, 0);
        const value at_a = value_at(a, h_a, h1_a, h2_a, h3_a, k_a, m, zeta, which);
        const value at_b = value_at(b, h_b, h1_b, h2_b, h3_b, k_b, m, zeta, which);

        /* next to A = 0: sf_is_free_of_folds */
        const double square = zeta * zeta, apart = on.h1_hi - on.h1_lo, of_slope = 16 * square * (on.h1_hi + square);
        const int rises =
            ((on.h1_lo >= 0) | (on.h1_hi <= 0)) & (on.h1_lo + 2 * square > SF_CLOSE * (fabs(on.h1_lo) + square));
        const int is_free =
            (a + fabs(h_a) == 0) & (rises | (apart * apart + of_slope < -SF_CLOSE * (apart * apart + fabs(of_slope))));

        /* rho, and kappa from its values at the ends: where h is nearly a power of A both vary by little. From the
         * first amplitude on |h_AA| rises as h_AAA lets it, and kappa stays between what it is there and -1/(2 + rho)
         */
        const double sign = h2_a < 0 ? -1.0 : 1.0, from = fabs(h2_a);
        const double least = sign > 0 ? on.h2_lo : -on.h2_hi, greatest = sign > 0 ? on.h2_hi : -on.h2_lo;
        const double s_lo = SF_LESSER(sign * h3_a, sign * h3_b), s_hi = SF_GREATER(sign * h3_a, sign * h3_b);
        const double rho_lo = (1 - SF_ERROR) * SF_LESSER(a * s_lo / from, b * s_lo / (from + s_hi * width));
        const double rho_hi = (1 + SF_ERROR) * SF_GREATER(a * s_hi / from, b * s_hi / (from + s_lo * width));
        const double first = k_a / (a * a * h2_a), last = k_b / (b * b * h2_b),
                     error = 4 * SF_ERROR * (1 + fabs(first));
        const double rough_lo = SF_LESSER(first, -1 / (2 + rho_lo)) - error;
        const double rough_hi = SF_GREATER(first, -1 / (2 + rho_hi)) + error;
        /* its slope is -(1 + kappa (2 + rho))/A */
        const double bent_lo = 1 + LEAST(rough_lo, 2 + rho_lo, 2 + rho_hi),
                     bent_hi = 1 + MOST(rough_hi, 2 + rho_lo, 2 + rho_hi);
        const double steep = SF_ERROR * (1 + fabs(rough_lo) + fabs(rough_hi)) * (2 + rho_hi);
        const double slope_lo = -MOST(bent_hi + steep, 1 / b, 1 / a), slope_hi = -LEAST(bent_lo - steep, 1 / b, 1 / a);
        const double off = 2 * error + SF_ERROR * width * (fabs(slope_lo) + fabs(slope_hi));
        const double under = sf_lane_under(first, last, slope_lo, slope_hi, width) - off;
        const double over = -sf_lane_under(-first, -last, -slope_hi, -slope_lo, width) + off;
        const double kappa_lo = SF_GREATER(rough_lo, under), kappa_hi = SF_LESSER(rough_hi, over);

        /* tau as a root of its quadratic */
        const double B_lo = a * least * (1 - SF_ERROR), B_hi = b * greatest * (1 + SF_ERROR);
        const double P_lo = a * B_lo * B_lo, P_hi = b * B_hi * B_hi;
        const shared of = {a,    b,    m,        zeta,     most,     sign,     B_lo,   B_hi,
                           P_lo, P_hi, on.h1_lo, on.h1_hi, kappa_lo, kappa_hi, rho_lo, rho_hi};
        const int is_scaled = (least > 0) & (a > 0) & (s_lo >= 0) & (rho_hi < HIGHEST_POWER) & (kappa_hi < 1) &
                              (P_lo > SMALLEST) & (P_hi < 1 / SMALLEST);
        const double z_lo = 2 * square / B_hi, z_hi = 2 * square / B_lo;
        const double p_lo = z_lo + 0.5 * sign, p_hi = z_hi + 0.5 * sign;
        const double less_lo = SF_LESSER(2 * on.h1_lo * z_lo / B_hi, 2 * on.h1_lo * z_hi / B_lo);
        const double less_hi = SF_GREATER(2 * on.h1_hi * z_lo / B_hi, 2 * on.h1_hi * z_hi / B_lo);
        const double c_lo = kappa_lo - less_hi, c_hi = kappa_hi - less_lo;
        const double error_c = SF_ERROR * (fabs(kappa_lo) + fabs(kappa_hi) + fabs(less_lo) + fabs(less_hi));
        const double near = (p_lo > 0) | (p_hi < 0) ? SF_LESSER(fabs(p_lo), fabs(p_hi)) : 0.0,
                     far = SF_GREATER(fabs(p_lo), fabs(p_hi));
        const double b_lo = c_lo - error_c, b_hi = c_hi + error_c,
                     error_d = SF_ERROR * (far * far + fabs(b_lo) + fabs(b_hi));
        const double disc_lo = near * near - b_hi - error_d, disc_hi = far * far - b_lo + error_d;
        /* the root's size, that of the lower channel with -p in place of p; it rises with that, and falls with b, where
         * b <= 0 */
        const int corners = b_hi <= 0;
        const double turned_lo = which > 0 ? -p_hi : p_lo, turned_hi = which > 0 ? -p_lo : p_hi;
        const double root_lo = sqrt(SF_GREATER(disc_lo, 0.0)), root_hi = sqrt(SF_GREATER(disc_hi, 0.0));
        const double corner_lo = sqrt(SF_GREATER(turned_lo * turned_lo - b_hi, 0.0)),
                     corner_hi = sqrt(SF_GREATER(turned_hi * turned_hi - b_lo, 0.0));
        const double error_t = 4 * SF_ERROR * (far + root_hi);
        const double size_lo = turned_lo + (corners ? corner_lo : root_lo) - error_t,
                     size_hi = turned_hi + (corners ? corner_hi : root_hi) + error_t;
        const channel found = channel_on(of, which > 0 ? size_lo : -size_hi, which > 0 ? size_hi : -size_lo);

        const double product = (at_a.least > 0 ? at_a.y : NAN) * (at_b.least > 0 ? at_b.y : NAN);
        const int is_settled = is_scaled & found.throughout & found.monotone & (disc_lo > 0);
        const int has_none =
            (is_scaled & ((kappa_lo >= 0) | (disc_hi < 0) | found.none)) | is_free | (is_settled & (product > 0));
        const int has_one = is_settled & (product < 0);
        const double inside = a > 0 ? 0.5 * (a + b) : 0.125 * b;
        cells->verdict[i] = sf_verdict_of(!(on.h1_hi < 0), has_none, has_one);
        cells->cut[i] = has_one ? sf_lane_zero(a, at_a.y, at_a.dy, b, at_b.y, at_b.dy, inside) : inside;
        cells->rises[i] = at_a.y < 0;
    }
}

SF_WIDE static void approach(ptrdiff_t n, sf_lane_zeros *zeros) {
    SF_EACH(i, n) {
        const double A = zeros->at[0][i], h = zeros->at[1][i], h_A = zeros->at[2][i], h_AA = zeros->at[3][i];
        const double h_AAA = zeros->at[4][i], k = zeros->at[5][i], zeta = zeros->task[1][i], m = zeros->task[2][i];
        const value at = value_at(A, h, h_A, h_AA, h_AAA, k, m, zeta, zeros->task[0][i]);
        const int is_low = (at.y < 0) == (zeros->rises[i] != 0);
        const double lo = is_low ? A : zeros->lo[i], hi = is_low ? zeros->hi[i] : A;
        zeros->lo[i] = lo, zeros->hi[i] = hi;
        zeros->next[i] = sf_next_from(A, at.y, at.dy, zeros->last[0][i], zeros->last[1][i], zeros->last[2][i], lo, hi);
        zeros->last[0][i] = A, zeros->last[1][i] = at.y, zeros->last[2][i] = at.dy;
        zeros->change[i] = at.least > 0 ? fabs(at.y / at.dy) : HUGE_VAL;
        zeros->Omega[i] = at.Omega;
    }
}

SF_DEFINE_QUESTION(sf_judge_cusps, sf_approach_cusps)
