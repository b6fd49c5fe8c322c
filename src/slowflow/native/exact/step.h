/* One step of the equation of motion (3) by its Taylor series. Takes a state in a piece of the force; returns series
 * of u and v = du/dtau in time, and of their derivatives by (u, v, Omega, F_0), with the step over which they hold. */
#pragma once

#include <stdint.h>
#include <string.h>

#include "motion.h"
#include "series.h"

/* the constants of a slip phase: friction is mu times the sign of the velocity, less a static load, and quadratic is
 * c_2 times it; structural damping is part of zeta, and has it go with Omega */
typedef struct {
    double Omega, F_0, zeta, friction, quadratic, zeta_by_Omega, c_3, zeta_2;
} sf_drive;

/* u^2, u v and v^2 in time, as far as c_3 and zeta_2 ask for them */
typedef struct {
    double uu[SF_TERMS], uv[SF_TERMS], vv[SF_TERMS];
} sf_products;

/* in time from the start of the step, coefficient by coefficient */
typedef struct {
    sf_series u, v;
    sf_four U[SF_TERMS], V[SF_TERMS]; /* by u and v at the start, Omega, F_0 */
} sf_expansion;

/* What a piece of an odd force is at u = 0: one power series; two that meet there; or two branches without a series
 * there, as of |u|^(3/2). The force is 0 there and its slope finite. SF_BEGINS: it has no series where it begins, at a
 * place other than 0, as behind a gap a contact (|u| - gap)^(3/2) has none. SF_SEAMS: its series change at places, of
 * which 0 may be one, and are those of a polynomial between them. */
typedef enum { SF_SMOOTH, SF_MEETS, SF_BRANCHES, SF_BEGINS, SF_SEAMS } sf_breaks;

/* One piece of a restoring force: f(u), df/du, and the expansion of the motion over it, with the derivatives by column
 * at a fixed theta = Omega tau from those in `flow`, or without where that is NULL. Its functions take the law itself,
 * `self`, by which one text serves many forces. After its constants, p holds the side of u = 0, 1 or -1. begins: the u
 * at which it begins without a series on the side of u, or NULL. Of SF_SEAMS: seam, the place ahead of u in a
 * direction, 0 among them where the piece is on both sides; at, what expansions take in place of p from u on in a
 * direction. The others have neither. powers: writes what a polynomial in u > 0 has next to u^0, u^1, ..., and returns
 * its degree, at most SF_FORCE_DEGREE; NULL for any other force. */
typedef struct sf_law sf_law;

struct sf_law {
    const char *name;
    int constants;
    sf_breaks breaks;
    double (*value)(const sf_law *self, const double *p, double u);
    double (*slope)(const sf_law *self, const double *p, double u);
    void (*expand)(const sf_law *self, const double *p, const sf_drive *drive, double theta, double u, double v,
                   const sf_four *flow, sf_expansion *x);
    double (*begins)(const sf_law *self, const double *p, double u);
    double (*seam)(const sf_law *self, double u, double direction, int both);
    const double *(*at)(const sf_law *self, double side, double u, double direction);
    int (*powers)(const double *p, double *c);
};

/* A piece with its constants for u < 0 and for u > 0, and the next one towards u = 0, or NULL. Where a force jumps at
 * u = 0 a piece is on one side, which both have. */
typedef struct sf_piece {
    const sf_law *law;
    const double *p[2];
    const struct sf_piece *below;
} sf_piece;

/* The piece that holds at u, or next to it: below where one begins without a series it has no values. */
static inline const sf_piece *sf_defined(const sf_piece *piece, double u) {
    if (piece->law->begins == NULL || piece->below == NULL)
        return piece;
    const double place = piece->law->begins(piece->law, piece->p[u > 0.0], u);
    return (u - place) * place < 0.0 ? piece->below : piece;
}

/* Whether a piece is on one side of 0; where it has no series there, whether u is beyond, as Newton's iteration tries
 * it. A force that stays what it is at 0 leaves the equations and their slopes at the solution as they are. */
static inline int sf_is_on_one_side(const sf_piece *piece) {
    const int n = piece->law->constants;
    return piece->p[0][n] == piece->p[1][n];
}

static inline int sf_is_beyond(const sf_piece *piece, double u) {
    return piece->law->breaks == SF_BRANCHES && sf_is_on_one_side(piece) &&
           u * piece->p[0][piece->law->constants] < 0.0;
}

static inline double sf_value(const sf_piece *piece, double u) {
    piece = sf_defined(piece, u);
    return piece->law->value(piece->law, piece->p[u > 0.0], sf_is_beyond(piece, u) ? 0.0 : u);
}

static inline double sf_slope(const sf_piece *piece, double u) {
    piece = sf_defined(piece, u);
    return piece->law->slope(piece->law, piece->p[u > 0.0], sf_is_beyond(piece, u) ? 0.0 : u);
}

/* What the generated recurrences of a piece are: begin() computes the coefficients 0 of all its series from that of
 * series 0, which is u, and reciprocals; next() computes the coefficients n > 0 in w, likewise, and what they
 * contribute to the sums of the coefficients after it. */
typedef void sf_begin(const double *p, double *first, double *over);
typedef void sf_next(const sf_coefficients *c, const double *p, double *w, sf_four *left, sf_four *right);

/* sums of left[j] right[n - j] for from <= j <= n - from, group by group */
static SF_INLINE void sf_sums(const sf_four *left, const sf_four *right, int n, int from, int fours, sf_four *sum) {
    for (int k = 0; k < fours; k++) {
        sf_four even = sf_four_of(0.0, 0.0, 0.0, 0.0), odd = even;
        int low = from, high = n - from;
        for (; low < high; low++, high--) {
            even = sf_more(even, left[low * fours + k], right[high * fours + k]);
            odd = sf_more(odd, left[high * fours + k], right[low * fours + k]);
        }
        if (low == high)
            even = sf_more(even, left[low * fours + k], right[high * fours + k]);
        sum[k] = sf_plus(even, odd);
    }
}

/* Coefficients n of all series of a piece but u's, which is given; the coefficients w[0], w[1], w[n - 1] and w[n] take
 * turns in four parts of `w`. Gives where those of order n stand. */
static SF_INLINE const double *sf_carried(sf_next *next, const double *p, int n, double u, int series, int fours,
                                          const double *over, double *w, sf_four *left, sf_four *right) {
    static const double none[SF_MOST_SERIES] = {0.0};
    sf_four sum[SF_MOST_FOURS];
    double *const now = w + (n == 1 ? 1 : 2 + n % 2) * series;
    const double *const last = n < 3 ? none : w + (2 + (n - 1) % 2) * series;
    const sf_coefficients c = {n, w, w + series, last, now, over, sum};
    sf_sums(left, right, n, n < 3 ? 1 : 2, fours, sum);
    now[0] = u;
    next(&c, p, now, left + n * fours, right + n * fours);
    return now;
}

/* coefficient n of a product */
static SF_INLINE double sf_times_at(const sf_series a, const sf_series b, int n) {
    double sum = 0.0;
    for (int j = 0; j <= n; j++)
        sum += a[j] * b[n - j];
    return sum;
}

/* the same, times a number, added to a sum */
static SF_INLINE void sf_add_fours(double factor, const sf_series a, const sf_four *b, int n, sf_four *sum) {
    sf_four found = sf_all(0.0);
    for (int j = 0; j <= n; j++)
        found = sf_more(found, sf_all(a[j]), b[n - j]);
    *sum = sf_more(*sum, sf_all(factor), found);
}

static SF_INLINE int sf_has_products(const sf_drive *drive) { return drive->c_3 != 0.0 || drive->zeta_2 != 0.0; }

static SF_INLINE void sf_add_products(const sf_series u, const sf_series v, int n, sf_products *of) {
    of->uu[n] = sf_times_at(u, u, n), of->uv[n] = sf_times_at(u, v, n), of->vv[n] = sf_times_at(v, v, n);
}

/* v' where a step begins, in a force f, as in the events of a motion */
static SF_INLINE double sf_rate(const sf_drive *drive, double cosine, double f, double u, double v) {
    double resists[3];
    motion_resistance(v, drive->zeta, drive->friction, drive->quadratic, drive->c_3, drive->zeta_2, u, resists);
    return motion_acceleration(cosine, v, drive->F_0, drive->zeta, resists[0], f);
}

/* coefficient n of v', n > 0, from those of cos theta and f: of what resists a constant is in the first alone */
static SF_INLINE double sf_rate_of(const sf_drive *drive, double cosine, double f, const sf_series v,
                                   const sf_products *of, int n) {
    double resists = drive->quadratic != 0.0 ? drive->quadratic * sf_times_at(v, v, n) : 0.0;
    if (sf_has_products(drive))
        resists += drive->c_3 * sf_times_at(v, of->vv, n) + 2.0 * drive->zeta_2 * sf_times_at(v, of->uu, n);
    return motion_acceleration(cosine, v[n], drive->F_0, drive->zeta, resists, f);
}

/* What v' falls by per V, by zeta; of what is quadratic in v it is the same of that times v. */
static SF_INLINE double sf_damped(double zeta) {
    double by_state[4];
    motion_rates_by_state(1.0, zeta, 0.0, by_state);
    return -by_state[3];
}

/* What a rate in time changes by with Omega at a fixed theta, over the rate. */
static SF_INLINE double sf_by_Omega(double Omega) {
    double by_parameter[10];
    motion_rates_by_parameter(0.0, 1.0, Omega, 0.0, 0.0, 0.0, 0.0, by_parameter);
    return by_parameter[0] * Omega;
}

/* u' = v and v' by the equation of motion. The piece has `series`, f is number `value` of them; `fours` groups of sums.
 * Where `flow` is not NULL, with the derivatives from those in it: of u, U' = V; of v, V' = -f'(u) U less what resists
 * it, plus cos theta in the column of F_0; and in that of Omega what the rates of u and v have of it at a fixed theta,
 * and what zeta has. f' is series `slope`; where it is linear, its first coefficient. */
static SF_INLINE void sf_expand(sf_begin *begin, sf_next *next, const double *p, const sf_drive *drive, double theta,
                                double u, double v, const sf_four *flow, int series, int fours, int value, int slope,
                                int linear, double *over, double *w, sf_four *left, sf_four *right, sf_expansion *x) {
    const int both = flow != NULL;
    const double by_Omega = both ? sf_by_Omega(drive->Omega) : 0.0;
    const double damped_more = both ? sf_damped(drive->zeta_by_Omega) : 0.0;
    const sf_four damped = sf_all(both ? sf_damped(drive->zeta) : 0.0);
    const double damped_by_v = both ? sf_damped(drive->quadratic) : 0.0;
    double cosine = cos(theta), sine = sin(theta);
    sf_four slopes[SF_TERMS], pull;
    sf_products products;
    memset(w + series, 0, (size_t)series * sizeof *w); /* taken while coefficients 1 are put in, times zero */
    w[0] = u;
    begin(p, w, over);
    x->u[0] = u, x->v[0] = v;
    double rate = sf_rate(drive, cosine, w[value], u, v);
    if (sf_has_products(drive))
        sf_add_products(x->u, x->v, 0, &products);
    x->u[1] = v;
    slopes[0] = pull = sf_all(both ? w[slope] : 0.0);
    if (both) {
        x->U[0] = flow[0], x->V[0] = flow[1];
        pull = sf_times(pull, flow[0]);
    }
    for (int n = 1;; n++) {
        x->v[n] = rate * sf_over[n];
        if (both) {
            const sf_four each = sf_all(sf_over[n]);
            x->U[n] = sf_times(sf_plus(x->V[n - 1], sf_four_of(0.0, 0.0, x->v[n - 1] * by_Omega, 0.0)), each);
            sf_four resisted = sf_more(pull, damped, x->V[n - 1]);
            if (drive->quadratic != 0.0)
                sf_add_fours(damped_by_v, x->v, x->V, n - 1, &resisted);
            if (sf_has_products(drive)) { /* as `motion_resistance` has the slopes by u and v */
                sf_add_fours(3.0 * drive->c_3, products.vv, x->V, n - 1, &resisted);
                sf_add_fours(2.0 * drive->zeta_2, products.uu, x->V, n - 1, &resisted);
                sf_add_fours(4.0 * drive->zeta_2, products.uv, x->U, n - 1, &resisted);
            }
            const double of_Omega = rate * by_Omega - damped_more * x->v[n - 1];
            x->V[n] = sf_times(sf_less(sf_four_of(0.0, 0.0, of_Omega, cosine), resisted), each);
        }
        if (n == SF_ORDER)
            break;
        x->u[n + 1] = rate * (sf_over[n] * sf_over[n + 1]);
        const double turned = -drive->Omega * sine * sf_over[n];
        sine = drive->Omega * cosine * sf_over[n], cosine = turned;
        const double *const now = sf_carried(next, p, n, x->u[n], series, fours, over, w, left, right);
        if (sf_has_products(drive))
            sf_add_products(x->u, x->v, n, &products);
        rate = sf_rate_of(drive, cosine, now[value], x->v, &products, n);
        if (both)
            pull = sf_times(slopes[0], x->U[n]);
        if (both && !linear) {
            sf_four below;
            slopes[n] = sf_all(now[slope]);
            sf_sums(slopes, x->U, n, 1, 1, &below);
            pull = sf_plus(pull, sf_more(below, slopes[n], x->U[0]));
        }
    }
}

static inline double sf_greater(double a, double b) { return a > b ? a : b; }
static inline double sf_lesser(double a, double b) { return a < b ? a : b; }

/* log2 |x| to 0.1 */
static inline double sf_log2(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits &= INT64_MAX;
    return (double)(int64_t)bits * 0x1p-52 - 1023.0;
}

static inline double sf_largest(const sf_four *row) {
    const double pair = sf_greater(fabs(sf_lane(row, 0)), fabs(sf_lane(row, 1)));
    return sf_greater(pair, sf_greater(fabs(sf_lane(row, 2)), fabs(sf_lane(row, 3))));
}

/* log2 of the step at which the last two terms are a rounding of the largest of the first four, of which three
 * vanish at rest under no force; of what vanishes the logarithm is -1023 */
static SF_INLINE double sf_reach(const double head[4], double before, double last) {
    const double of_before = sf_log2(before) + 54.0, of_last = sf_log2(last) + 54.0;
    double to_before = -HUGE_VAL, to_last = -HUGE_VAL;
    for (int k = 0; k < 4; k++) {
        const double size = sf_log2(head[k]);
        to_before = sf_greater(to_before, (size - of_before) * (1.0 / (SF_ORDER - 1 - k)));
        to_last = sf_greater(to_last, (size - of_last) * (1.0 / (SF_ORDER - k)));
    }
    return sf_lesser(to_before, to_last);
}

/* The step over which the last two terms of every series are no more than a rounding; very long where all vanish. */
static SF_INLINE double sf_step_of(const sf_expansion *x, int variations) {
    double least = sf_lesser(sf_reach(x->u, x->u[SF_ORDER - 1], x->u[SF_ORDER]),
                             sf_reach(x->v, x->v[SF_ORDER - 1], x->v[SF_ORDER]));
    for (int i = 0; variations && i < 2; i++) {
        const sf_four *const of = i ? x->V : x->U;
        const double head[4] = {sf_largest(&of[0]), sf_largest(&of[1]), sf_largest(&of[2]), sf_largest(&of[3])};
        least = sf_lesser(least, sf_reach(head, sf_largest(&of[SF_ORDER - 1]), sf_largest(&of[SF_ORDER])));
    }
    return exp2(least);
}

/* a in units of h: a[k] h^k, times a sign */
static inline void sf_scaled(const double *a, double h, double sign, double *out) {
    const double square = h * h;
    double even = sign, odd = sign * h;
    out[0] = sign * a[0];
    for (int k = 1; k < SF_ORDER; k += 2) {
        even *= square;
        out[k] = odd * a[k], out[k + 1] = even * a[k + 1];
        odd *= square;
    }
}

/* by Horner's rule, for even and odd powers apart */
static inline double sf_at(const double *series, double h) {
    const double square = h * h;
    double even = series[SF_ORDER], odd = series[SF_ORDER - 1];
    for (int k = SF_ORDER - 2; k >= 2; k -= 2)
        even = even * square + series[k], odd = odd * square + series[k - 1];
    return series[0] + (h * odd + square * even);
}

static inline void sf_four_at(const sf_four *series, double h, sf_four *out) {
    const sf_four step = sf_all(h), square = sf_all(h * h);
    sf_four even = series[SF_ORDER], odd = series[SF_ORDER - 1];
    for (int k = SF_ORDER - 2; k >= 2; k -= 2)
        even = sf_more(series[k], even, square), odd = sf_more(series[k - 1], odd, square);
    *out = sf_plus(series[0], sf_more(sf_times(step, odd), square, even));
}
