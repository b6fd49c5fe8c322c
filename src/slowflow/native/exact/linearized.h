/* Stationary motions under a Gaussian excitation with a spectral density, by statistical linearization. Takes an
 * oscillator and a table; returns every linear oscillator that is equivalent.
 *
 * sigma_u gives the stiffness, k = E[u f]/sigma_u^2, and that the damping: at each k there is at most one c, as
 * ln C(sigma_v) - ln c falls with c. What is left is one equation for sigma_u,
 *
 *     ln I_0(k, c(k)) - 2 ln sigma_u = 0,    I_j = int G Omega^j/|k - Omega^2 + i c Omega|^2 dOmega
 *
 * (derivations/extensions/linearization.py has the slopes, by p = ln k and q = ln c, and what bounds them). A cell of
 * sigma_u bounds k, and that L = ln I_0 by its slope: the cell holds no root, at most one, or is cut. */
#pragma once

#include <stddef.h>

#include "gaussian.h"

/* parts of a table in a unit of ln(Omega) at least, and more by its slope: so Gauss's rule is as near as roundings
 * where no pole is nearer than so many half widths */
#define SF_PARTS 2.0
#define SF_PARTS_BY_SLOPE 0.25
#define SF_POLE_NEAR 5.05
enum { SF_IN_PART = 2 * SF_NODES };
/* by how much less the lowest damping is taken to be; a lower damping ratio than that is taken for it */
#define SF_MARGIN 1.5
#define SF_LEAST_RATIO 0x1p-40
/* of k over the square of a table's lowest frequency, below which it does not matter; how much I_0 may change there */
#define SF_SOFT 1e-6
/* of ln(Omega): from where on a band is far from a pole; by how much -ln Z rises there with p at a constant damping
 * ratio */
#define SF_FAR_BAND 0.5
#define SF_FAR_RISES (2.0 / (1.0 - exp(-2.0 * SF_FAR_BAND)) - 1.0)
enum { SF_TRIALS = 5, SF_MOST_HALVINGS = 20 };
/* by how much more than its bound E[u f] is at the end of the search at most */
#define SF_MORE 1.5
/* how much of a cell its bounds may leave, or it is cut */
#define SF_SHRINKS 0.5
/* how accurate a damping has to be in a cell, over its size; far from a root; and at it, or where no size is known */
#define SF_AS_NEAR 0x1p-5
#define SF_ROUGH 0x1p-5
#define SF_NEAREST 0x1p-28

/* from low to high of ln(Omega); ln G is y + slope (ln Omega - x); G at low, the frequency `begin`, is by `rises` more
 * than below it; at the nodes Omega and G dOmega */
typedef struct {
    double low, high, x, y, slope, begin, rises, Omega[SF_IN_PART], weight[SF_IN_PART];
} sf_band;

/* strength: pi times the largest density; whole: int G dOmega; over: int G/Omega dOmega; least, most: of the slopes;
 * falls: G at the end, the frequency `end`. Python keeps its bytes, bands behind. */
typedef struct {
    double strength, whole, over, least, most, end, falls;
    int bands;
    sf_band band[];
} sf_table;

/* Of part of a band. G on both sides of its middle is a product and a quotient; Omega is as near as an exponential,
 * since next to a pole its rounding counts. */
static void sf_put_nodes(const sf_band *line, double low, double high, double *Omega, double *weight) {
    const double m = 0.5 * (low + high), h = 0.5 * (high - low), G = h * exp(line->y + line->slope * (m - line->x));
    for (int j = 0; j < SF_NODES; j++) {
        const double x = h * sf_gauss_node[j], grows = exp(line->slope * x), of = sf_gauss_weight[j] * G;
        Omega[j] = exp(m - x), Omega[SF_NODES + j] = exp(m + x);
        weight[j] = of / grows * Omega[j], weight[SF_NODES + j] = of * grows * Omega[SF_NODES + j];
    }
}

/* Parts of the straight line from a point (Omega, G) to the next one, 0 of a step. */
static int sf_parts(const double *at, double *slope) {
    const double width = log(at[2]) - log(at[0]);
    *slope = width > 0.0 ? (log(at[3]) - log(at[1])) / width : 0.0;
    return (int)ceil(width * (SF_PARTS + SF_PARTS_BY_SLOPE * fabs(*slope)));
}

/* The table of rising points, at least two; without one to write to only how many bands it has. */
static int sf_read_table(const double (*points)[2], int count, sf_table *to) {
    int bands = 0;
    double slope, below = 0.0, largest = 0.0;
    sf_table read = {.least = HUGE_VAL, .most = -HUGE_VAL};
    for (int i = 0; i + 1 < count; i++) {
        const int pieces = sf_parts(points[i], &slope);
        const double x = log(points[i][0]), y = log(points[i][1]), width = log(points[i + 1][0]) - x;
        for (int j = 0; to != NULL && j < pieces; j++) {
            sf_band *const band = &to->band[bands + j];
            *band = (sf_band){x + width * j / pieces, x + width * (j + 1) / pieces,   x,     y,    slope,
                              points[i][0],           j ? 0.0 : points[i][1] - below, {0.0}, {0.0}};
            sf_put_nodes(band, band->low, band->high, band->Omega, band->weight);
            for (int k = 0; k < SF_IN_PART; k++)
                read.whole += band->weight[k], read.over += band->weight[k] / band->Omega[k];
        }
        bands += pieces;
        largest = fmax(largest, fmax(points[i][1], points[i + 1][1]));
        if (pieces)
            below = points[i + 1][1], read.least = fmin(read.least, slope), read.most = fmax(read.most, slope);
    }
    if (to != NULL) {
        read.strength = 3.14159265358979324 * largest;
        read.end = points[count - 1][0];
        read.falls = below;
        read.bands = bands;
        memcpy(to, &read, offsetof(sf_table, band));
    }
    return bands;
}

/* At (p, q): ln I_0 and ln I_2, by p and q. far: the shares of bands farther from p/2 than a reach; near: between which
 * ends the slopes of the others are */
typedef struct {
    double value[2], by[2][2], far[2];
    sf_ends near;
} sf_moments;

/* middle, theta: parts of the pole next to the real axis, p/2 + i theta; infinite where there is none */
typedef struct {
    double k, c, middle, theta;
} sf_resonance;

/* By node of Gauss's rule: of I_0 and I_2 and their slopes by p and q. */
typedef struct {
    double of[2][3][SF_IN_PART];
} sf_by_node;

static inline void sf_add_nodes(const sf_resonance *at, const double *Omega, const double *weight, sf_by_node *to) {
    for (int j = 0; j < SF_IN_PART; j++) {
        double of[3];
        linearization_response(Omega[j], at->k, at->c, of);
        const double term = weight[j] / of[0], more = term * (Omega[j] * Omega[j]);
        to->of[0][0][j] += term, to->of[0][1][j] += term * of[1], to->of[0][2][j] += term * of[2];
        to->of[1][0][j] += more, to->of[1][1][j] += more * of[1], to->of[1][2][j] += more * of[2];
    }
}

/* Bands of one straight line next to a pole, from low to high. E, D: quadratures of 1/(x - X) and of its slope by X,
 * real and imaginary parts by node. */
typedef struct {
    const sf_band *line;
    double low, high, E[2][SF_IN_PART], D[2][SF_IN_PART];
} sf_near_pole;

static inline void sf_add_pole_nodes(const sf_resonance *at, double low, double high, sf_near_pole *to) {
    const double m = 0.5 * (low + high) - at->middle, h = 0.5 * (high - low), theta = at->theta;
    for (int j = 0; j < SF_IN_PART; j++) {
        const int k = j % SF_NODES;
        const double x = m + (j < SF_NODES ? -h : h) * sf_gauss_node[k], over = 1.0 / (x * x + theta * theta);
        const double term = h * sf_gauss_weight[k] * over;
        to->E[0][j] += term * x, to->E[1][j] += term * theta;
        to->D[0][j] += term * over * (x * x - theta * theta), to->D[1][j] += term * over * (2.0 * x * theta);
    }
}

static inline double sf_sum(const double *by_node) {
    double sum = 0.0;
    for (int j = 0; j < SF_IN_PART; j++)
        sum += by_node[j];
    return sum;
}

/* What the pole adds there: int dx/(x - X) less its quadrature, and the slope of both by X. */
static inline void sf_add_pole(const sf_resonance *at, const sf_near_pole *by, double sums[2][3]) {
    const double a = by->low - at->middle, b = by->high - at->middle, theta = at->theta;
    const double aa = a * a + theta * theta, bb = b * b + theta * theta;
    const double turns = atan2(theta * (b - a), a * b + theta * theta);
    const double E[2] = {0.5 * log(bb / aa) - sf_sum(by->E[0]), turns - sf_sum(by->E[1])};
    const double D[2] = {a / aa - b / bb - sf_sum(by->D[0]), theta / aa - theta / bb - sf_sum(by->D[1])};
    const double G = exp(by->line->y + by->line->slope * (at->middle - by->line->x));
    double adds[6];
    linearization_resonance(theta, at->k, at->c, by->line->slope, G, E[0], E[1], D[0], D[1], adds);
    for (int i = 0; i < 2; i++)
        for (int n = 0; n < 3; n++)
            sums[i][n] += adds[3 * i + n];
}

/* Of a box in which p differs by r at most, how far from p/2 bands are near. */
static inline double sf_band_reach(double r) { return 0.5 * r + SF_FAR_BAND; }

SF_FMA static sf_moments sf_moments_at(const sf_table *table, double p, double q, double reach) {
    const double ratio = fmax(0.5 * exp(q - 0.5 * p), SF_LEAST_RATIO);
    const sf_resonance at = {exp(p), exp(q), 0.5 * p, ratio < 1.0 ? asin(ratio) : HUGE_VAL};
    sf_by_node both[2] = {{{{{0.0}}}}};
    sf_near_pole pole = {.line = NULL};
    double sums[2][3] = {{0.0}}, Omega[SF_IN_PART], weight[SF_IN_PART];
    sf_moments found = {.near = {HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i < table->bands; i++) {
        const sf_band *const band = &table->band[i];
        const int is_far = band->high < at.middle - reach || band->low > at.middle + reach;
        sf_by_node *const to = &both[is_far];
        if (!is_far)
            found.near = (sf_ends){fmin(found.near.low, band->slope), fmax(found.near.high, band->slope)};
        const double m = 0.5 * (band->low + band->high) - at.middle, h = 0.5 * (band->high - band->low);
        if (!(m * m + at.theta * at.theta < SF_POLE_NEAR * SF_POLE_NEAR * h * h)) {
            sf_add_nodes(&at, band->Omega, band->weight, to);
            continue;
        }
        if (pole.line == NULL || pole.line->x != band->x) {
            if (pole.line != NULL)
                sf_add_pole(&at, &pole, sums);
            pole = (sf_near_pole){.line = band, .low = band->low};
        }
        pole.high = band->high;
        if (!(at.middle > band->low && at.middle < band->high)) {
            sf_add_nodes(&at, band->Omega, band->weight, to);
            sf_add_pole_nodes(&at, band->low, band->high, &pole);
            continue;
        }
        /* no node is next to the pole, where what a sum and the pole have in common would cancel */
        for (int above = 0; above < 2; above++) {
            const double low = above ? at.middle : band->low, high = above ? band->high : at.middle;
            sf_put_nodes(band, low, high, Omega, weight);
            sf_add_nodes(&at, Omega, weight, to);
            sf_add_pole_nodes(&at, low, high, &pole);
        }
    }
    if (pole.line != NULL)
        sf_add_pole(&at, &pole, sums);
    if (found.near.low > found.near.high)
        found.near = (sf_ends){table->least, table->most};
    for (int i = 0; i < 2; i++) {
        for (int by = 0; by < 3; by++)
            sums[i][by] += sf_sum(both[0].of[i][by]) + sf_sum(both[1].of[i][by]);
        found.value[i] = log(sums[i][0]), found.far[i] = sf_sum(both[1].of[i][0]) / sums[i][0];
        for (int by = 0; by < 2; by++)
            found.by[i][by] = sums[i][by + 1] / sums[i][0];
    }
    return found;
}

/* What the jumps of a table add to the slopes of ln I_j, j = 2 i, at a constant damping ratio, down and up: at most
 * dG Omega^(j+1)/(2 Z I_j), with I_j at the centre of the box. */
static void sf_jumps_within(const sf_table *table, int i, double value, const sf_ends *k, double ratio,
                            double jumps[2]) {
    const double c = 2.0 * ratio * sqrt(k->low), over = 0.5 * exp(-value);
    jumps[0] = jumps[1] = 0.0;
    for (int j = 0; j <= table->bands; j++) {
        const double rises = j < table->bands ? table->band[j].rises : -table->falls;
        if (rises == 0.0)
            continue;
        const double Omega = j < table->bands ? table->band[j].begin : table->end, square = Omega * Omega;
        const double away = fmax(fmax(k->low - square, square - k->high), 0.0), Z = away * away + c * c * square;
        jumps[rises > 0.0] += fabs(rises) * over * Omega * (i ? square : 1.0) / Z;
    }
}

/* In a box in which p differs by r[0] at most, and the logarithm of the damping ratio by r[1], whatever the table:
 * between which ends the slope of ln I_j by p is, at a constant q, and by how much its slopes by p, at a constant
 * damping ratio and by q differ from those at the centre. They are weighted means of slopes of -ln Z; their own ones
 * are means of the second ones and covariances. */
typedef struct {
    sf_ends by_p;
    double differ[3];
} sf_steepness;

enum { SF_BY_P, SF_BY_Q, SF_AT_RATIO };

static sf_steepness sf_steepness_within(double p, double q, const double r[2]) {
    const double ratio = 0.5 * exp(q - r[1] - 0.5 * p), by_q = r[1] + 0.5 * r[0];
    double of[3];
    linearization_steepest(ratio, of);
    const double down = ratio < 0.5 ? -of[0] : 2.0, most = of[1];
    const double peak = ratio < 0.5 ? of[2] : ratio < 0.70710678118654752 ? fmax(of[2], 1.0) : 1.0;
    const double both = 0.5 * (down + most), mixed = 2.0 * fmax(down, most) + both;
    const double by_p = fmax(0.25 + 2.0 * peak, fmax(down * (down - 1.0), most * (most + 1.0)) + both * both);
    const double of_p = by_p * r[0] + mixed * by_q, of_q = mixed * r[0] + by_q;
    return (sf_steepness){{-down, most}, {of_p, of_q, of_p + 0.5 * of_q}};
}

static inline void sf_intersect(sf_ends *to, double low, double high) {
    to->low = low > to->low ? low : to->low, to->high = high < to->high ? high : to->high;
}

/* Between which ends the slopes of ln I_j are in that box, j = 2 i, by p, by q, and by p at a constant damping ratio.
 * At that 1/Z is shifted along ln(Omega): the slope is (j - 3 + s)/2 in the mean of the slopes s of ln G, and what
 * jumps add; s is that of near bands, but for the share of the far ones. Away from its pole -ln Z rises with p by
 * SF_FAR_RISES at most, and I_j falls by no more than the bound of the slope has it, which is tried. By q the slope is
 * -2 y in the mean, 0 < y < 1, which changes with p as y and s/2 vary together, and with q by 1 at most. */
static void sf_slopes_within(const sf_table *table, const sf_moments *at, double p, double q, const double r[2],
                             sf_ends slopes[2][3]) {
    const sf_ends k = {exp(p - r[0]), exp(p + r[0])}, near = at->near;
    const double middle = 0.5 * (near.low + near.high), apart = fmax(table->most - middle, middle - table->least);
    const sf_steepness any = sf_steepness_within(p, q, r);
    for (int i = 0; i < 2; i++) {
        sf_ends *const by = slopes[i];
        const double there[3] = {at->by[i][0], at->by[i][1], at->by[i][0] + 0.5 * at->by[i][1]};
        double jumps[2], tried = 0.0;
        by[SF_BY_P] = any.by_p, by[SF_BY_Q] = (sf_ends){-2.0, 0.0}, by[SF_AT_RATIO] = (sf_ends){-HUGE_VAL, HUGE_VAL};
        for (int n = 0; n < 3; n++)
            sf_intersect(&by[n], there[n] - any.differ[n], there[n] + any.differ[n]);
        sf_jumps_within(table, i, at->value[i], &k, 0.5 * exp(q - 0.5 * p - r[1]), jumps);
        for (int n = 0; n < SF_TRIALS; n++) {
            const double less = exp(tried * r[0] + 2.0 * r[1]);
            const double far = fmin(1.0, at->far[i] * less * exp(SF_FAR_RISES * r[0]));
            const double least = i - 1.5 + 0.5 * (near.low - far * (near.low - table->least)) - less * jumps[0];
            const double most = i - 1.5 + 0.5 * (near.high + far * (table->most - near.high)) + less * jumps[1];
            if (fmax(-least, most) <= tried) {
                const double varies = 0.5 * (near.high - near.low) + far * apart + 2.0 * less * (jumps[0] + jumps[1]);
                const double shift = varies * r[0] + r[1];
                sf_intersect(&by[SF_AT_RATIO], least, most);
                sf_intersect(&by[SF_BY_Q], there[SF_BY_Q] - shift, there[SF_BY_Q] + shift);
                break;
            }
            tried = 1.1 * fmax(-least, most);
        }
        const sf_ends of_q = by[SF_BY_Q], of_p = by[SF_BY_P];
        sf_intersect(&by[SF_BY_P], by[SF_AT_RATIO].low - 0.5 * of_q.high, by[SF_AT_RATIO].high - 0.5 * of_q.low);
        sf_intersect(&by[SF_AT_RATIO], of_p.low + 0.5 * of_q.low, of_p.high + 0.5 * of_q.high);
    }
}

/* The damping at a stiffness and a sigma_u: by_p and by_q of ln I_0 and ln I_2 there; D: half the slope of ln C by
 * ln(sigma_v); by_u: its slope by ln(sigma_u); near: the last step to q, of which the square is left. */
typedef struct {
    double p, q, D, by_u, near;
    sf_moments moments;
} sf_equivalent;

/* dq/dp, and dq/dln(sigma_u) */
static inline double sf_damping_by_p(const sf_equivalent *at) {
    return at->D * at->moments.by[1][0] / (1.0 - at->D * at->moments.by[1][1]);
}
static inline double sf_damping_by_u(const sf_equivalent *at) {
    return at->by_u / (1.0 - at->D * at->moments.by[1][1]);
}

typedef struct {
    const sf_table *table;
    const sf_system *system;
} sf_under_table;

/* The damping that there is at least, at any stiffness: c sigma_v is at most the root of the mean square of the
 * excitation, c sigma_v^2 at most `strength`. Infinite where friction holds the mass nearly all of the time. */
static double sf_least_damping(const sf_under_table *of, double mu, double zeta) {
    double c[3];
    sf_equivalent_damping(of->system, 1.0, mu, zeta, c);
    const double slips = 1.0 - c[2] / sqrt(of->table->whole);
    return slips > 0.0 ? fmax(2.0 * zeta / slips, c[2] * c[2] / of->table->strength) : HUGE_VAL;
}

static int sf_is_held(const sf_under_table *of, double sigma) {
    return sf_least_damping(of, sf_damping_over_u(of->system, sigma).mu, 0.0) == HUGE_VAL;
}

/* k I_0 is at most that: c k I_0 is c I_2 and what |y|/(y^2 + c^2 Omega^2) adds, at most 1/(2 c Omega). */
static inline double sf_most(const sf_table *table, double least) {
    return (table->strength + 0.5 * table->over) / least;
}

/* By Newton's iteration for ln C - q, which falls, between ends that close in; from a q on, until a step is as near.
 * NaN where it is lost. */
static sf_equivalent sf_equivalent_at(const sf_under_table *of, const sf_over_u *damping, double p, double q,
                                      double reach, double near) {
    double low = log(sf_least_damping(of, damping->mu, damping->zeta) / SF_MARGIN), high = HUGE_VAL, c[3];
    sf_equivalent at = {.p = p, .q = fmax(q, low)};
    for (int i = 0; i < SF_MOST_STEPS; i++) {
        at.moments = sf_moments_at(of->table, p, at.q, reach);
        sf_equivalent_damping(of->system, exp(0.5 * at.moments.value[1]), damping->mu, damping->zeta, c);
        at.D = 0.5 * c[1] / c[0];
        const double excess = log(c[0]) - at.q, step = excess / (1.0 - at.D * at.moments.by[1][1]);
        if (excess > 0.0)
            low = at.q;
        else
            high = at.q;
        const double next = at.q + fmax(fmin(step, 2.0), -2.0);
        const int inside = next > low && next < high;
        if (fabs(step) <= near) { /* what is left is of second order */
            for (int j = 0; j < 2; j++)
                at.moments.value[j] += step * at.moments.by[j][1];
            at.q += step, at.near = fabs(step);
            at.by_u =
                ((damping->mu > 0.0 ? c[2] * damping->mu_slope / damping->mu : 0.0) + 2.0 * damping->zeta_slope) / c[0];
            return at;
        }
        at.q = inside ? next : high < HUGE_VAL ? 0.5 * (low + high) : low + 1.0;
    }
    at.q = NAN;
    return at;
}

static inline double sf_steepest_of(sf_ends of) { return fmax(-of.low, of.high); }

/* Between which ends dL/dp and dL/dln(sigma_u) are where p differs by no more than r[0], and ln(sigma_u) by r[1], in a
 * cell whose ends have the damping a and b; infinite where that is not known. */
static void sf_slope_within(const sf_under_table *of, const sf_equivalent *at, const sf_over_u *a, const sf_over_u *b,
                            const double r[2], sf_ends *by_p, sf_ends *by_u) {
    double apart = 1.5 * (fabs(sf_damping_by_p(at) - 0.5) * r[0] + fabs(sf_damping_by_u(at)) * r[1]);
    *by_p = *by_u = (sf_ends){-HUGE_VAL, HUGE_VAL};
    for (int i = 0; i < 6; i++) {
        const double square = at->moments.value[1], ratio = apart + at->near;
        sf_ends slopes[2][3], D, own;
        sf_slopes_within(of->table, &at->moments, at->p, at->q, (double[2]){r[0], ratio}, slopes);
        const sf_ends *const I_0 = slopes[0], *const I_2 = slopes[1];
        const double shift = sf_steepest_of(I_2[SF_AT_RATIO]) * r[0] - I_2[SF_BY_Q].low * ratio;
        sf_damping_within(of->system, a, b, (sf_ends){exp(0.5 * (square - shift)), exp(0.5 * (square + shift))}, &D,
                          &own);
        D.low *= 0.5, D.high *= 0.5;
        const sf_ends falls = sf_ends_of_product(D, I_2[SF_BY_Q]);
        if (!(falls.high < 1.0))
            return;
        /* of ln C = q = ln(ratio) + p/2 + ln 2 */
        const sf_ends over = {1.0 / (1.0 - falls.low), 1.0 / (1.0 - falls.high)};
        const sf_ends drives = sf_ends_of_product(D, I_2[SF_AT_RATIO]);
        const sf_ends ratio_by_p = sf_ends_of_product((sf_ends){drives.low - 0.5, drives.high - 0.5}, over);
        const sf_ends ratio_by_u = sf_ends_of_product(own, over);
        sf_ends q_by_p = sf_ends_of_product(sf_ends_of_product(D, I_2[SF_BY_P]), over);
        sf_intersect(&q_by_p, ratio_by_p.low + 0.5, ratio_by_p.high + 0.5);
        const sf_ends change = {q_by_p.low - 0.5, q_by_p.high - 0.5};
        const double goes = sf_steepest_of(change) * r[0] + sf_steepest_of(ratio_by_u) * r[1];
        if (goes <= apart) { /* the ratio does not leave the box */
            const sf_ends by_q = sf_ends_of_product(q_by_p, I_0[SF_BY_Q]);
            const sf_ends by_ratio = sf_ends_of_product(change, I_0[SF_BY_Q]);
            *by_p = (sf_ends){I_0[SF_BY_P].low + by_q.low, I_0[SF_BY_P].high + by_q.high};
            sf_intersect(by_p, I_0[SF_AT_RATIO].low + by_ratio.low, I_0[SF_AT_RATIO].high + by_ratio.high);
            *by_u = sf_ends_of_product(ratio_by_u, I_0[SF_BY_Q]);
            return;
        }
        apart = 1.25 * goes;
    }
}

/* near: where a damping was found last */
typedef struct {
    const sf_under_table *excited;
    const sf_positive *force;
    sf_equivalent near;
    int cells;
    sf_motions *found;
} sf_linearized;

static sf_equivalent sf_equivalent_by(sf_linearized *of, const sf_over_u *damping, double p, double reach,
                                      double near) {
    const double q = of->near.q + sf_damping_by_p(&of->near) * (p - of->near.p);
    const sf_equivalent at = sf_equivalent_at(of->excited, damping, p, q, reach, near);
    if (at.q == at.q)
        of->near = at;
    return at;
}

/* ln I_0 - 2 ln(sigma), with a damping as near as that */
static double sf_excess(sf_linearized *of, const sf_gaussian *at, double near, sf_equivalent *damped) {
    const sf_over_u damping = sf_damping_over_u(of->excited->system, at->sigma);
    *damped = sf_equivalent_by(of, &damping, log(sf_first(at)) - 2.0 * log(at->sigma), 0.0, near);
    return damped->moments.value[0] - 2.0 * log(at->sigma);
}

/* The root in a cell, if it has one: the excess rises or falls between two values of ln(sigma), and has no root
 * elsewhere. Newton's iteration between ends that close in, from a sigma on. Where that leaves the cell the sign at its
 * end says whether there is a root. The damping is as accurate as the step before is small: one integral serves
 * both. */
static void sf_put_stationary(sf_linearized *of, const sf_gaussian *a, const sf_gaussian *b, sf_ends t, int rises,
                              double from) {
    /* of the ends: whether the sign there is known */
    int known[2] = {!rises && t.low > log(a->sigma), !rises && t.high < log(b->sigma)};
    double low = known[0] ? exp(t.low) : a->sigma, high = known[1] ? exp(t.high) : b->sigma;
    double before = 0.0, near = SF_ROUGH;
    sf_gaussian at = sf_averages(of->force, from > low && from < high ? from : sqrt(low) * sqrt(high));
    sf_equivalent damped;
    for (int i = 0; i < SF_MOST_STEPS; i++) {
        const double excess = sf_excess(of, &at, near, &damped);
        if (isnan(excess))
            break;
        const int above = (excess < 0.0) == rises;
        if (at.sigma == (above ? b : a)->sigma)
            return;
        double (*const by)[2] = damped.moments.by;
        const double by_p = by[0][0] + by[0][1] * sf_damping_by_p(&damped), by_u = by[0][1] * sf_damping_by_u(&damped);
        const double stiffens = sf_third(&at) / sf_first(&at) - 3.0;
        const double step = -excess / (by_p * stiffens + by_u - 2.0), next = at.sigma * exp(step);
        if (fabs(excess) > damped.near) /* its sign is known */
            *(above ? &low : &high) = at.sigma;
        const int inside = next > low && next < high;
        /* steps are as the squares of those before: what follows is of the order of size^3/before^2 */
        const double size = fabs(step) + damped.near;
        if (size * size * size <= 0x1p-54 * before * before || size <= 0x1p-32 || high <= low * (1.0 + 0x1p-51)) {
            const double p = stiffens * step, q = sf_damping_by_p(&damped) * p + sf_damping_by_u(&damped) * step;
            const double v = exp(0.5 * (damped.moments.value[1] + by[1][0] * p + by[1][1] * q));
            at = sf_averages(of->force, next);
            sf_put_motion(of->excited->system, of->found, 0.0, next, at.square, v, sf_first(&at) / (next * next));
            return;
        }
        before = inside ? size : 0.0;
        near = inside ? fmax(fmin(step * step, SF_ROUGH), SF_NEAREST) : SF_NEAREST;
        if (inside)
            at = sf_averages(of->force, next);
        else if (known[above]++)
            at = sf_averages(of->force, sqrt(low * high));
        else
            at = above ? *b : *a;
    }
    of->found->undecided[0] = exp(of->near.p), of->found->undecided[1] = exp(of->near.q);
}

/* The stiffness in a cell, which rises where f/u does; of other forces its slope by ln(sigma) too, from averages, and
 * from what f/u is up to there. */
static sf_ends sf_stiffness_within(const sf_positive *force, const sf_gaussian *a, const sf_gaussian *b,
                                   sf_ends *slope) {
    const double grows = b->sigma / a->sigma, cube = grows * grows * grows, fifth = cube * grows * grows;
    const double aa = a->sigma * a->sigma, bb = b->sigma * b->sigma, width = log(grows);
    const double error = SF_ERROR * (b->first[0] + b->first[1]) / bb;
    if (force->hardens)
        return (sf_ends){sf_first(a) / aa - error, sf_first(b) / bb + error};
    const sf_ends secants = sf_secants_up_to(force, SF_FARTHEST * b->sigma);
    const double most = secants.high - secants.low;
    sf_ends K = {fmax(secants.low, a->first[0] / aa / cube - b->first[1] / bb * cube),
                 fmin(secants.high, b->first[0] / bb * cube - a->first[1] / aa / cube)};
    slope->low = fmax(-3.0 * most, a->third[0] / aa / fifth - b->third[1] / bb * fifth - 3.0 * K.high);
    slope->high = fmin(3.0 * most, b->third[0] / bb * fifth - a->third[1] / aa / fifth - 3.0 * K.low);
    const double low = fmin(slope->low, 0.0) * width, high = fmax(slope->high, 0.0) * width;
    K.low = fmax(K.low, fmax(sf_first(a) / aa + low, sf_first(b) / bb - high)) - error;
    K.high = fmin(K.high, fmin(sf_first(a) / aa + high, sf_first(b) / bb - low)) + error;
    return K;
}

/* The slope of a rising stiffness K by ln(sigma), between two values of that: E[x^2 u (f/u)'] at u = sigma x, of what
 * is positive, so that sigma^3 times it rises. So it is no more than at b times a cube, nor than allows K to gain from
 * there to b what it does at most. */
static sf_ends sf_stiffening_within(const sf_gaussian *a, const sf_gaussian *b, sf_ends K, sf_ends t) {
    const double aa = a->sigma * a->sigma, bb = b->sigma * b->sigma, begin = log(a->sigma), end = log(b->sigma);
    const double at_a = (sf_third(a) - 3.0 * sf_first(a)) / aa, at_b = (sf_third(b) - 3.0 * sf_first(b)) / bb;
    const double error = SF_ERROR * (b->third[0] + b->third[1] + 3.0 * (b->first[0] + b->first[1])) / bb;
    const double gains = 3.0 * (K.high - K.low) / (1.0 - exp(3.0 * (t.high - end)));
    return (sf_ends){fmax(at_a - error, 0.0) * exp(3.0 * (begin - t.high)),
                     fmin((at_b + error) * exp(3.0 * (end - t.low)), gains)};
}

/* Where a cell of a rising stiffness is cut: where ln k is between two values, or in its middle if it is not there
 * soon. */
static sf_gaussian sf_cut_between(const sf_positive *force, const sf_gaussian *a, const sf_gaussian *b, sf_ends p) {
    double low = a->sigma, high = b->sigma;
    const sf_gaussian middle = sf_averages(force, sqrt(low) * sqrt(high));
    sf_gaussian at = middle;
    for (int i = 0; i < SF_MOST_HALVINGS; i++) {
        const double there = log(sf_first(&at)) - 2.0 * log(at.sigma);
        if (there >= p.low && there <= p.high)
            return at;
        *(there > p.high ? &high : &low) = at.sigma;
        at = sf_averages(force, sqrt(low) * sqrt(high));
    }
    return middle;
}

static void sf_search_stationary(sf_linearized *of, const sf_gaussian *a, const sf_gaussian *b) {
    const sf_table *const table = of->excited->table;
    const double grows = b->sigma / a->sigma, soft = SF_SOFT * exp(2.0 * table->band[0].low);
    const sf_over_u first = sf_damping_over_u(of->excited->system, a->sigma);
    const sf_over_u last = sf_damping_over_u(of->excited->system, b->sigma);
    const double least = sf_least_damping(of->excited, last.mu, first.zeta);
    if (a->first[0] / grows - b->first[1] * grows > (1.0 + SF_ERROR) * sf_most(table, least))
        return;
    sf_ends slope;
    const sf_ends K = sf_stiffness_within(of->force, a, b, &slope);
    if (K.high <= 0.0)
        return;
    const double low = log(fmax(K.low, soft)), high = log(fmax(K.high, soft)), r = 0.5 * (high - low);
    const double middle_sigma = sqrt(a->sigma) * sqrt(b->sigma), width = 0.5 * log(grows);
    const sf_over_u damping = sf_damping_over_u(of->excited->system, middle_sigma);
    const sf_equivalent at = sf_equivalent_by(of, &damping, low + r, sf_band_reach(r), SF_AS_NEAR * (r + width));
    sf_ends by_p, by_u;
    sf_slope_within(of->excited, &at, &first, &last, (double[2]){r, width}, &by_p, &by_u);
    const double L = at.moments.value[0], error = at.near + (K.low < soft ? 4.0 * SF_SOFT : 0.0);
    const double shift = sf_steepest_of(by_p) * r + sf_steepest_of(by_u) * width + error;
    const double begin = log(a->sigma), end = log(b->sigma), from = 0.5 * (L - shift), to = 0.5 * (L + shift);
    const sf_ends left = {fmax(from, begin), fmin(to, end)};
    if (left.low > left.high)
        return;
    if (K.low >= soft) {
        if (of->force->hardens)
            slope = sf_stiffening_within(a, b, K, left);
        const sf_ends over = {1.0 / K.high, 1.0 / K.low};
        const sf_ends excess = sf_ends_of_product(by_p, sf_ends_of_product(slope, over));
        if (excess.high + by_u.high < 2.0 || excess.low + by_u.low > 2.0) {
            sf_put_stationary(of, a, b, left, excess.low + by_u.low > 2.0, exp(0.5 * L));
            return;
        }
    }
    of->cells += isnan(at.q) ? SF_MOST_STEPS : 1;
    if (!sf_can_be_cut(grows) || of->cells > SF_MOST_CELLS) {
        if (!isnan(sf_first(a)) && !isnan(sf_first(b)))
            of->found->undecided[0] = exp(at.p), of->found->undecided[1] = exp(at.q);
        return;
    }
    if (left.high - left.low < SF_SHRINKS * (end - begin)) {
        const sf_gaussian c = from > begin ? sf_averages(of->force, exp(from)) : *a;
        const sf_gaussian d = to < end ? sf_averages(of->force, exp(to)) : *b;
        sf_search_stationary(of, &c, &d);
        return;
    }
    const sf_gaussian middle = of->force->hardens && K.low >= soft
                                   ? sf_cut_between(of->force, a, b, (sf_ends){low + 0.5 * r, high - 0.5 * r})
                                   : sf_averages(of->force, middle_sigma);
    if (!(isnan(sf_first(a)) && isnan(sf_first(&middle))))
        sf_search_stationary(of, a, &middle);
    if (!(isnan(sf_first(&middle)) && isnan(sf_first(b))))
        sf_search_stationary(of, &middle, b);
}

/* Every stationary motion, by rising sigma_u; 0 where there is none, as friction holds the mass nearly all of the time:
 * that which ends at a displacement may do so up to some sigma_u. */
static int sf_tabulated(const sf_system *system, const sf_table *table, sf_motions *found) {
    const sf_under_table excited = {table, system};
    const double size =
        sqrt(sf_most(table, sf_least_damping(&excited, system->released ? 0.0 : system->mu, system->zeta)));
    if (size == 0.0)
        return 0;
    sf_positive force;
    sf_put_parts(system, fmin(size, 1.0), fmax(size, 1.0), &force);
    double from = force.small / SF_SEARCHED, to = force.large * SF_SEARCHED, high = to;
    if (sf_is_held(&excited, to))
        return 0;
    const int sticks = sf_is_held(&excited, from);
    if (sticks) {
        for (double m = sqrt(from * high); m > from && m < high; m = sqrt(from * high))
            *(sf_is_held(&excited, m) ? &from : &high) = m;
        from = high;
    }
    const sf_gaussian a = sf_averages(&force, from);
    sf_gaussian b = sf_averages(&force, to);
    /* E[u f] is size^2 at most, and rises with f/u: an end, to which Newton's iteration for its logarithm comes near */
    double sigma = size, more = 0.0;
    for (int i = 0;
         i < SF_MOST_STEPS && force.hardens && sigma > from && sigma < b.sigma && !(more > 1.0 && more < SF_MORE);
         i++) {
        const sf_gaussian at = sf_averages(&force, sigma);
        more = sf_first(&at) / ((1.0 + SF_ERROR) * size * size);
        if (more > 1.0)
            b = at;
        sigma = more > 0.0 ? sigma * pow(sqrt(SF_MORE) / more, 1.0 / (sf_third(&at) / sf_first(&at) - 1.0))
                           : sqrt(sigma) * sqrt(b.sigma);
    }
    sf_linearized of = {.excited = &excited, .force = &force, .near = {.q = -HUGE_VAL}, .found = found};
    sf_search_stationary(&of, &a, &b);
    return !sticks || found->count > 0 || found->undecided[0] != 0.0;
}
