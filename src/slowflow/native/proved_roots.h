/* Positive frequencies at one amplitude, proved. Takes intervals that hold A and h; returns intervals of Omega each of
 * which holds exactly one root, and some that may hold any; elsewhere there is none.
 */
#pragma once

#include "exact_inputs.h"

enum { SF_MOST_ROOTS = 8, SF_MOST_ROOT_CELLS = 1000 };

/* in a narrower interval, relatively, a root may be double: it is cut only as long as that tells more */
#define SF_ROOT_NARROW 0x1p-32
/* undecided intervals that are nearer to each other than this, relatively, are one */
#define SF_ROOTS_TOUCH 0x1p-30

/* of the response, F = 0; of the fold locus, F_A = 0; of its peaks, F_Omega = 0 */
typedef enum { SF_ROOTS_OF_F, SF_ROOTS_OF_F_A, SF_ROOTS_OF_F_OMEGA } sf_roots_of;

typedef struct {
    sf_roots_of of;
    sf_interval A, h, h_A, m, zeta, F_0;
} sf_at_amplitude;

/* undecided: whether the interval may hold no root, or several */
typedef struct {
    int n, full, cells;
    sf_interval at[SF_MOST_ROOTS];
    int undecided[SF_MOST_ROOTS];
} sf_roots;

static void sf_value_on(const sf_at_amplitude *q, sf_interval w, sf_interval *y, sf_interval *dy) {
    if (q->of == SF_ROOTS_OF_F) {
        *y = slow_flow_intervals_F(w, q->A, q->F_0, q->m, q->zeta, q->h);
        *dy = slow_flow_intervals_F_Omega(w, q->A, q->m, q->zeta, q->h);
    } else if (q->of == SF_ROOTS_OF_F_A) {
        *y = slow_flow_intervals_F_A(w, q->A, q->m, q->zeta, q->h, q->h_A);
        *dy = slow_flow_intervals_F_AOmega(w, q->A, q->m, q->zeta, q->h, q->h_A);
    } else {
        sf_interval reduced[2];
        if (q->m.hi == 0)
            slow_flow_mu0_intervals_F_Omega_reduced(w, q->A, q->m, q->zeta, q->h, reduced);
        else if (q->zeta.hi == 0)
            slow_flow_zeta0_intervals_F_Omega_reduced(w, q->A, q->m, q->zeta, q->h, reduced);
        else
            slow_flow_intervals_F_Omega_reduced(w, q->A, q->m, q->zeta, q->h, reduced);
        *y = reduced[0], *dy = reduced[1];
    }
}

/* Beyond this frequency there is no root: R exceeds F_0 there, or is positive with Omega^2 + h_A. */
static double sf_highest_root(const sf_at_amplitude *q) {
    const sf_interval level = q->of == SF_ROOTS_OF_F ? q->F_0 : sfi_point(0);
    const double highest = slow_flow_intervals_backbone(q->A, sfi_sub(q->h, level)).hi;
    return q->of == SF_ROOTS_OF_F_A ? sfi_most(highest, slow_flow_zeta0_intervals_undamped_Omega(q->h_A).hi) : highest;
}

static void sf_add_root(sf_roots *out, sf_interval w, int undecided) {
    const int last = out->n - 1;
    if (undecided && last >= 0 && out->undecided[last] && w.lo - out->at[last].hi <= SF_ROOTS_TOUCH * w.lo) {
        out->at[last].hi = w.hi; /* neighbours are one */
    } else if (out->n == SF_MOST_ROOTS) {
        out->full = 1;
    } else {
        out->at[out->n] = w, out->undecided[out->n++] = undecided;
    }
}

/* The one root in an interval on which the slope has a sign. */
static sf_interval sf_narrow_root(const sf_at_amplitude *q, sf_interval w) {
    for (int i = 0; i < SF_MOST_STEPS; i++) {
        const sf_interval x = sfi_point(0.5 * (w.lo + w.hi));
        sf_interval y, dy, unused;
        sf_value_on(q, x, &y, &unused);
        sf_value_on(q, w, &unused, &dy);
        const sf_interval next = sfi_both(w, sfi_sub(x, sfi_div(y, dy)));
        if (!(next.lo <= next.hi) || !(next.hi - next.lo < 0.75 * (w.hi - w.lo)))
            break;
        w = next;
    }
    return w;
}

static void sf_roots_between(const sf_at_amplitude *q, double low, double high, sf_roots *out) {
    const sf_interval w = sfi_of(low, high);
    const double middle = sf_amid(0, low, high);
    const int last = !(middle > low && middle < high) || out->cells++ > SF_MOST_ROOT_CELLS;
    sf_interval y, dy, at_low, at_high, unused;
    sf_value_on(q, w, &y, &dy);
    if (sfi_has_sign(y))
        return;
    sf_value_on(q, sfi_point(low), &at_low, &unused);
    sf_value_on(q, sfi_point(high), &at_high, &unused);
    if (sfi_has_sign(sf_along(at_low, at_high, dy, sfi_up(high - low))))
        return;
    if (sfi_has_sign(dy) && sfi_has_sign(at_low) && sfi_has_sign(at_high)) {
        if (sfi_positive(at_low) != sfi_positive(at_high))
            sf_add_root(out, sf_narrow_root(q, w), 0);
        return;
    }
    /* where it only rises or falls its root lies next to an end */
    if (last || (high - low <= SF_ROOT_NARROW * high && (sfi_has_sign(dy) || sf_is_noise(y, at_low, at_high)))) {
        sf_add_root(out, w, 1);
        return;
    }
    sf_roots_between(q, low, middle, out);
    sf_roots_between(q, middle, high, out);
}

static void sf_prove_roots(const sf_at_amplitude *q, sf_roots *out) {
    const double most = sf_highest_root(q);
    out->n = out->full = out->cells = 0;
    if (!(most < HUGE_VAL)) {
        out->full = 1;
        return;
    }
    /* twice: no root lies on the end of the search */
    sf_roots_between(q, 0, 2 * most, out);
}
