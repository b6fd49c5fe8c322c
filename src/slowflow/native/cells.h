/* Cells: in go two amplitudes of one piece of the force, out comes what h and its derivatives are on all of the interval.
 *
 * On each piece h_AAA is monotone: the derivation proves it (derivations/monotone.py). So its values at the ends bound it,
 * and what is known of a slope bounds the function between two of its values. Where the force or its slope jumps, the
 * derivatives of h tend to infinity as A falls to the breakpoint: that is the sample at the beginning of a piece.
 *
 * k = h - A h_A is where the tangent of h meets A = 0.
 */
#ifndef SF_CELLS_H
#define SF_CELLS_H

#include "interval.h"
#include "model.h"

/* kernels are right to a few units of rounding; this many are taken for granted on either side */
#define SF_DOUBT 0x1p-48
/* below this share of h the difference h - A h_A has lost too many digits */
#define SF_CANCELLED 0.25

/* A piece of the force: from its first amplitude (0 or a breakpoint, as its own side has it) to its last. */
typedef struct {
    sf_sample first, last;
} sf_stretch;

typedef struct {
    int n;
    sf_stretch at[SF_MOST_BREAKS + 1];
} sf_stretches;

typedef struct {
    const sf_sample *first, *last;
    sf_interval A, h, h_A, h_AA, h_AAA, k, k_A;
} sf_cell;

static inline void sf_sample_at(const sf_model *model, double A, sf_sample *at) {
    at->A = A;
    model->mechanism->averaged(1, &at->A, model->p, at->averages);
    at->k = at->h - A * at->h_A;
    if (fabs(at->k) < SF_CANCELLED * fabs(at->h) && model->mechanism->intercept != NULL)
        at->k = model->mechanism->intercept(A, model->p);
}

/* The limit from above at breakpoint i: the force's jump makes h_A infinite there, a jump of its slope h_AA. */
static inline void sf_sample_above(const sf_model *model, int i, sf_sample *at) {
    sf_sample_at(model, model->b[i], at);
    if (model->jump[i] != 0) {
        at->h_A = copysign(HUGE_VAL, model->jump[i]);
        at->k = -at->h_A;
        at->h_AA = -at->h_A, at->h_AAA = at->h_A;
    } else {
        sf_sample next;
        sf_sample_at(model, nextafter(model->b[i], HUGE_VAL), &next);
        at->h_AA = copysign(HUGE_VAL, next.h_AA - at->h_AA);
        at->h_AAA = -at->h_AA;
    }
}

/* The pieces up to A_max. */
static inline void sf_stretches_up_to(const sf_model *model, double A_max, sf_stretches *out) {
    int i;
    sf_sample_at(model, 0, &out->at[0].first);
    for (i = 0; i < model->breaks && model->b[i] < A_max; i++) {
        sf_sample_at(model, model->b[i], &out->at[i].last);
        sf_sample_above(model, i, &out->at[i + 1].first);
    }
    sf_sample_at(model, A_max, &out->at[i].last);
    out->n = i + 1;
}

/* A function between two of its values whose slope is known. */
static inline sf_interval sf_between(double f_a, double f_b, sf_interval slope, double width) {
    const double lo = slope.lo, hi = slope.hi;
    double below, above;
    if (lo >= 0 || hi <= 0)
        return sfi_hull(f_a, f_b);
    if (!(lo < 0 && hi > 0) || (lo == -HUGE_VAL && hi == HUGE_VAL))
        return sfi_of(-HUGE_VAL, HUGE_VAL);
    if (lo == -HUGE_VAL) {
        below = f_b - hi * width, above = f_a + hi * width;
    } else if (hi == HUGE_VAL) {
        below = f_a + lo * width, above = f_b - lo * width;
    } else {
        below = f_a + lo * sfi_most(0, sfi_least(width, (f_b - f_a - hi * width) / (lo - hi)));
        above = f_a + hi * sfi_most(0, sfi_least(width, (f_b - f_a - lo * width) / (hi - lo)));
    }
    return sfi_of(below - SF_DOUBT * (fabs(f_a) + fabs(f_b)), above + SF_DOUBT * (fabs(f_a) + fabs(f_b)));
}

/* By how much a kernel may err: relatively, and as if its argument were a rounding away. */
static inline double sf_doubt(double f, double A, double slope) {
    const double doubt = SF_DOUBT * (fabs(f) + A * fabs(slope));
    return doubt < HUGE_VAL ? doubt : SF_DOUBT * fabs(f);
}

/* A function between two samples: its values, in doubt, and its slope, at the ends and in between. */
static inline sf_interval sf_along(const sf_sample *a, const sf_sample *b, double f_a, double f_b, double slope_a,
                            double slope_b, sf_interval slope) {
    const double d_a = sf_doubt(f_a, a->A, slope_a), d_b = sf_doubt(f_b, b->A, slope_b), width = b->A - a->A;
    return sfi_of(sf_between(f_a - d_a, f_b - d_b, slope, width).lo, sf_between(f_a + d_a, f_b + d_b, slope, width).hi);
}

static inline void sf_make_cell(const sf_sample *a, const sf_sample *b, sf_cell *cell) {
    cell->first = a, cell->last = b;
    cell->A = sfi_of(a->A, b->A);
    cell->h_AAA = sfi_hull(a->h_AAA, b->h_AAA);
    cell->h_AA = sf_along(a, b, a->h_AA, b->h_AA, a->h_AAA, b->h_AAA, cell->h_AAA);
    cell->h_A = sf_along(a, b, a->h_A, b->h_A, a->h_AA, b->h_AA, cell->h_AA);
    cell->h = sf_along(a, b, a->h, b->h, a->h_A, b->h_A, cell->h_A);
    cell->k_A = sfi_neg(sfi_mul(cell->A, cell->h_AA));
    cell->k = sf_along(a, b, a->k, b->k, a->A * a->h_AA, b->A * b->h_AA, cell->k_A);
}

static inline double sf_kappa(const sf_sample *at) { return at->k / (at->A * at->A * at->h_AA); }

/* rho = A h_AAA/h_AA and kappa = k/(A^2 h_AA), which vary by little where h is nearly a power of A; 0 where they are not
 * known to. From the first amplitude on |h_AA| rises as h_AAA lets it, and kappa stays between what it is there and
 * -1/(2 + rho), with the slope -(1 + kappa (2 + rho))/A (derivations/along.py). */
static inline int sf_scaled(const sf_cell *cell, sf_interval *rho, sf_interval *kappa) {
    const sf_sample *a = cell->first, *b = cell->last;
    const sf_interval slope = cell->h_AA.hi < 0 ? sfi_neg(cell->h_AAA) : cell->h_AAA;
    const double from = fabs(a->h_AA), width = b->A - a->A;
    sf_interval bent, kappa_A;
    double first, last, doubt;
    if (!(a->A > 0 && sfi_has_sign(cell->h_AA) && slope.lo >= 0 && slope.hi < HUGE_VAL && from < HUGE_VAL))
        return 0;
    *rho = sfi_of((1 - SF_DOUBT) * sfi_least(a->A * slope.lo / from, b->A * slope.lo / (from + slope.hi * width)),
                  (1 + SF_DOUBT) * sfi_most(a->A * slope.hi / from, b->A * slope.hi / (from + slope.lo * width)));
    first = sf_kappa(a), last = sf_kappa(b);
    doubt = 4 * SF_DOUBT * (1 + fabs(first));
    *kappa = sfi_of(sfi_least(first, -1 / (2 + rho->lo)) - doubt, sfi_most(first, -1 / (2 + rho->hi)) + doubt);
    bent = sfi_add(sfi_point(1), sfi_mul(*kappa, sfi_add(sfi_point(2), *rho)));
    kappa_A = sfi_neg(sfi_div(bent, cell->A));
    *kappa = sfi_both(*kappa, sfi_of(sf_between(first - doubt, last - doubt, kappa_A, width).lo,
                                     sf_between(first + doubt, last + doubt, kappa_A, width).hi));
    return 1;
}

/* An amplitude well inside: halfway in the coordinate in which h is smooth, in orders of magnitude if there are many. */
static inline double sf_amid(double base, double a, double b) {
    if (a == 0)
        return 0.125 * b;
    if (b > 4 * a)
        return sqrt(a) * sqrt(b);
    if (base > 0) {
        const double p = a / base, q = b / base, r = 0.5 * (sqrt((p - 1) * (p + 1)) + sqrt((q - 1) * (q + 1)));
        return base + base * (r * r / (1 + sqrt(1 + r * r)));
    }
    return 0.5 * (a + b);
}

#endif
