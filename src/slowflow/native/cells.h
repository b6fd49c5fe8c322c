/* Cells. Takes what is known at two amplitudes of one piece of the force; returns what h and its derivatives are on
 * all of the interval between.
 *
 * On each piece h_AAA is monotone: the derivation proves it (derivations/forces/monotone.py). So its values at the ends
 * bound it, and what is known of a slope bounds the function between two of its values. Of a force of which that is not
 * proved it is h_AAAA that is known. Where the force or its slope jumps, the
 * derivatives of h tend to infinity as A falls to the breakpoint: that is the sample at the beginning of a piece.
 *
 * k = h - A h_A is where the tangent of h meets A = 0.
 */
#pragma once

#include "interval.h"
#include "model.h"
#include "slow_flow_intervals.h"

/* A piece of the force: from its first amplitude (0 or a breakpoint, as its own side has it) to its last. */
typedef struct {
    sf_sample first, last;
} sf_stretch;

typedef struct {
    int n;
    sf_stretch at[SF_MOST_BREAKS + 1];
} sf_stretches;

/* What holds h and its derivatives at an amplitude, or, in a proof, at one that exceeds where its piece begins by
 * `A`. */
typedef struct {
    double A;
    sf_interval h, h_A, h_AA, h_AAA, k;
} sf_known;

/* What they are on all of an interval of A. */
typedef struct {
    sf_interval A, h, h_A, h_AA, h_AAA, k, k_A;
} sf_cell;

static inline sf_sample sf_sample_at(const sf_model *model, double A) {
    sf_sample at = sf_sample_without_k_at(model, A);
    if (fabs(at.k) < SF_CANCELLED * fabs(at.h))
        at.k = model->mechanism->intercept(model->mechanism, A, model->p);
    return at;
}

/* The limit from above at breakpoint i, from the sample on it: the force's jump makes h_A infinite there, a jump of its
 * slope h_AA. */
static inline void sf_tend_from_above(const sf_model *model, int i, sf_sample *at) {
    if (model->jump[i] != 0) {
        at->h_A = copysign(HUGE_VAL, model->jump[i]);
        at->k = -at->h_A;
        at->h_AA = -at->h_A, at->h_AAA = at->h_A;
    } else {
        sf_sample next = sf_sample_at(model, nextafter(model->b[i], HUGE_VAL));
        if (model->kink[i][0] == 0) {
            next.A = at->A;
            if (model->kink[i][1] != 0)
                next.h_AAA = copysign(HUGE_VAL, next.h_AAA - at->h_AAA);
            *at = next;
            return;
        }
        at->h_AA = copysign(HUGE_VAL, next.h_AA - at->h_AA);
        at->h_AAA = -at->h_AA;
    }
}

/* Whether there is any force on a piece. Where there is none, as in a dead zone, there is no fold. */
static inline int sf_has_force(const sf_stretch *piece) {
    const sf_sample *a = &piece->first, *b = &piece->last;
    return a->h != 0 || a->h_A != 0 || a->h_AA != 0 || a->h_AAA != 0 || b->h != 0 || b->h_A != 0 || b->h_AA != 0 ||
           b->h_AAA != 0;
}

/* The pieces up to A_max. */
static inline void sf_stretches_up_to(const sf_model *model, double A_max, sf_stretches *out) {
    int i;
    out->at[0].first = sf_sample_at(model, 0);
    for (i = 0; i < model->breaks && model->b[i] < A_max; i++) {
        out->at[i].last = sf_sample_at(model, model->b[i]);
        out->at[i + 1].first = out->at[i].last;
        sf_tend_from_above(model, i, &out->at[i + 1].first);
    }
    out->at[i].last = sf_sample_at(model, A_max);
    out->n = i + 1;
}

/* The least value between f_a and f_b, `width` apart, of what falls by `lo` < 0 and rises by `hi` > 0 at most: from
 * either end as far as where both lines meet; any other place is a bound too, so that rounding it does no harm. */
static inline double sf_least_between(double f_a, double f_b, double lo, double hi, double width) {
    const double meet = (f_b - f_a - hi * width) / (lo - hi), x = sfi_most(0, sfi_least(width, meet));
    const double from_a = sfi_down(f_a + sfi_product_down(lo, x));
    const double from_b = sfi_down(f_b - sfi_product_up(hi, sfi_up(width - x)));
    return from_a < from_b ? from_a : from_b;
}

/* A function between two of its values whose slope is known. */
static inline sf_interval sf_between(double f_a, double f_b, sf_interval slope, double width) {
    const double lo = slope.lo, hi = slope.hi;
    if (lo >= 0 || hi <= 0)
        return sfi_hull(f_a, f_b);
    if (!(lo < 0 && hi > 0) || (lo == -HUGE_VAL && hi == HUGE_VAL))
        return sfi_of(-HUGE_VAL, HUGE_VAL);
    if (lo == -HUGE_VAL)
        return sfi_of(sfi_down(f_b - sfi_product_up(hi, width)), sfi_up(f_a + sfi_product_up(hi, width)));
    if (hi == HUGE_VAL)
        return sfi_of(sfi_down(f_a + sfi_product_down(lo, width)), sfi_up(f_b - sfi_product_down(lo, width)));
    return sfi_of(sf_least_between(f_a, f_b, lo, hi, width), -sf_least_between(-f_a, -f_b, -hi, -lo, width));
}

/* A value with what its kernel may err by: relatively, and as if its argument were a rounding away. */
static inline sf_interval sf_with_error(double f, double A, double slope) {
    const double relative = SF_ERROR * fabs(f), both = SF_ERROR * (fabs(f) + A * fabs(slope));
    const double error = both < HUGE_VAL ? both : relative;
    return error < HUGE_VAL ? sfi_of(f - error, f + error) : sfi_point(f);
}

/* A sample as something known. */
static inline void sf_know(const sf_sample *at, sf_known *out) {
    double tangent[2];
    out->A = at->A;
    out->h_AAA = sfi_point(at->h_AAA);
    out->h_AA = sf_with_error(at->h_AA, at->A, at->h_AAA);
    out->h_A = sf_with_error(at->h_A, at->A, at->h_AA);
    out->h = sf_with_error(at->h, at->A, at->h_A);
    slow_flow_intercept(at->A, at->h, at->h_A, at->h_AA, tangent);
    out->k = sf_with_error(at->k, at->A, tangent[1]);
}

/* A function between two of its values, of which bounds are known, and its slope in between. */
static inline sf_interval sf_along(sf_interval f_a, sf_interval f_b, sf_interval slope, double width) {
    return sfi_of(sf_between(f_a.lo, f_b.lo, slope, width).lo, sf_between(f_a.hi, f_b.hi, slope, width).hi);
}

/* Its lower derivatives, h and k, from what h_AAA is on a cell. */
static inline void sf_complete_cell(const sf_known *a, const sf_known *b, sf_cell *cell) {
    const double width = sfi_up(b->A - a->A);
    sf_interval tangent[2];
    cell->h_AA = sf_along(a->h_AA, b->h_AA, cell->h_AAA, width);
    cell->h_A = sf_along(a->h_A, b->h_A, cell->h_AA, width);
    cell->h = sf_along(a->h, b->h, cell->h_A, width);
    slow_flow_intervals_intercept(cell->A, cell->h, cell->h_A, cell->h_AA, tangent);
    cell->k_A = tangent[1];
    cell->k = sf_along(a->k, b->k, cell->k_A, width);
}

/* Where h_AAA is monotone. A: what holds the amplitudes of the cell */
static inline void sf_make_cell_on(sf_interval A, const sf_known *a, const sf_known *b, sf_cell *cell) {
    cell->A = A;
    cell->h_AAA = sfi_of(sfi_least(a->h_AAA.lo, b->h_AAA.lo), sfi_most(a->h_AAA.hi, b->h_AAA.hi));
    sf_complete_cell(a, b, cell);
}

/* Between two amplitudes; where h_AAA is not monotone, between what h_AAAA lets it be. */
static inline void sf_make_cell(const sf_model *model, const sf_known *a, const sf_known *b, sf_cell *cell) {
    const sf_interval A = sfi_of(a->A, b->A);
    sf_interval bent[2], low, high;
    if (model->mechanism->bent == NULL) {
        sf_make_cell_on(A, a, b, cell);
        return;
    }
    cell->A = A;
    model->mechanism->bent(model->mechanism, A, model->p, bent);
    low = sf_with_error(a->h_AAA.lo, a->A, bent[1].lo), high = sf_with_error(b->h_AAA.lo, b->A, bent[1].hi);
    cell->h_AAA = sf_along(low, high, bent[1], sfi_up(b->A - a->A));
    sf_complete_cell(a, b, cell);
}

/* An amplitude well inside: halfway in the coordinate in which h is smooth, in orders of magnitude if there are
 * many. */
static inline double sf_amid(double base, double a, double b) {
    if (a == 0)
        return 0.125 * b;
    if (b > 4 * a)
        return sqrt(a) * sqrt(b);
    /* far above the base the coordinate is A itself, and the square of A / base may overflow */
    if (a < SF_FAR_ABOVE * base) {
        const double p = a / base, q = b / base, r = 0.5 * (sqrt((p - 1) * (p + 1)) + sqrt((q - 1) * (q + 1)));
        return base + base * (r * r / (1 + sqrt(1 + r * r)));
    }
    return 0.5 * (a + b);
}
