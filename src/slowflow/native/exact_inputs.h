/* The oscillator's exact inputs. Takes its numbers, taken exactly; returns its parameters and h with its derivatives to
 * some thirty digits, in double-double, and intervals that hold what follows from them.
 *
 * A proof is about this oscillator, not about its parameters rounded to doubles.
 */
#pragma once

#include "cells.h"
#include "slow_flow_intervals.h"
#include "slow_flow_pairs.h"

/* ==== In double-double ============================================================================================ */

/* so far above a breakpoint h_AA and h_AAA are differences that have lost too many of a pair's digits */
#define SF_PAIRS_REACH 64
/* nearer to it, relatively, doubles do not give the higher derivatives */
#define SF_PAIRS_NEXT 0x1p-20

/* b: the breakpoints > 0, as many as `breaks`; empty: how many pieces below them have no width */
typedef struct {
    const sf_mechanism *mechanism;
    sf_pair p[SF_MOST_PARAMETERS + SF_MOST_BREAKS], b[SF_MOST_BREAKS], m, zeta;
    int breaks, empty;
} sf_exactly;

typedef struct {
    sf_pair A, h[4]; /* h, h_A, h_AA, h_AAA */
} sf_exact_sample;

/* What follows from the parameters, which are there. */
static inline void sf_complete_exact(const sf_mechanism *mechanism, double mu, double zeta, sf_exactly *out) {
    sf_pair b[SF_MOST_BREAKS];
    out->mechanism = mechanism;
    out->m = slow_flow_pairs_friction(sfp_point(mu)), out->zeta = sfp_point(zeta);
    if (mechanism->breakpoints > 0)
        mechanism->ends_in_pairs(mechanism, out->p, b);
    out->empty = 0;
    while (out->empty < mechanism->breakpoints && b[out->empty].high == 0)
        out->empty++;
    out->breaks = mechanism->breakpoints - out->empty;
    for (int i = 0; i < mechanism->breakpoints; i++)
        out->b[i] = i < out->breaks ? b[out->empty + i] : sfp_point(0);
}

/* 0 where the mechanism has no form in pairs, or is excited by inertia, which these forms are not about. */
static inline int sf_make_exact(const sf_mechanism *mechanism, const double *design, double mu, double zeta,
                                sf_exactly *out) {
    if (mechanism->averaged_in_pairs == NULL || mechanism->inertial)
        return 0;
    mechanism->parameters_in_pairs(mechanism, design, out->p);
    sf_complete_exact(mechanism, mu, zeta, out);
    return 1;
}

/* At an amplitude whose double lies on that piece of the force; 0 where pairs have too few digits. count: how many of
 * h and its derivatives pairs are to give; the others are doubles', at hand in `near`, or of this amplitude if that is
 * NULL. */
static inline int sf_exact_at(const sf_exactly *exactly, const sf_model *model, int piece, sf_pair A, int count,
                              const sf_sample *near, sf_exact_sample *out) {
    sf_pair beyond = A;
    if (model->breaks != exactly->breaks)
        return 0;
    if (piece > 0) {
        beyond = sfp_sub(A, exactly->b[piece - 1]);
        if (!(beyond.high > 0) || (count > 2 && A.high > SF_PAIRS_REACH * exactly->b[piece - 1].high))
            return 0;
        if (beyond.high < SF_PAIRS_NEXT * A.high)
            count = 4;
    }
    out->A = A;
    exactly->mechanism->averaged_in_pairs(exactly->mechanism, exactly->empty + piece, count, A, beyond, exactly->p,
                                          out->h);
    if (count <= 2) {
        const sf_sample at = near == NULL ? sf_sample_without_k_at(model, A.high) : *near;
        for (int i = 2; i < 4; i++)
            out->h[i] = sfp_point(at.averages[i]);
    }
    return 1;
}

/* At breakpoint i as its lower side has it. */
static inline void sf_exact_on(const sf_exactly *exactly, int i, sf_exact_sample *out) {
    const sf_pair b = exactly->b[i];
    out->A = b, out->h[2] = out->h[3] = sfp_point(0);
    exactly->mechanism->averaged_in_pairs(exactly->mechanism, exactly->empty + i, 2, b,
                                          i > 0 ? sfp_sub(b, exactly->b[i - 1]) : b, exactly->p, out->h);
}

/* ==== On intervals ================================================================================================ */

/* of Newton's method on intervals, each of which takes a quarter of the interval or more */
enum { SF_MOST_STEPS = 60 };
/* what a function does on an interval is no more than what it is not known by at the ends, up to this */
#define SF_NOISE 4

/* breaks, empty: as in sf_exactly */
typedef struct {
    const sf_mechanism *mechanism;
    sf_interval p[SF_MOST_PARAMETERS + SF_MOST_BREAKS], m, zeta;
    sf_interval b[SF_MOST_BREAKS], jump[SF_MOST_BREAKS], kink[SF_MOST_BREAKS];
    int breaks, empty;
    sf_exactly exactly;
} sf_inputs;

/* 0 where no proof is possible: the mechanism has no form on intervals, the excitation is no force, or a breakpoint can
 * be shown neither to differ from 0 nor to be 0. What has such a form has one in pairs too. */
static inline int sf_give(const sf_mechanism *mechanism, const double *design, double mu, double zeta, sf_inputs *out) {
    sf_interval b[SF_MOST_BREAKS], kink[SF_MOST_BREAKS];
    if (mechanism->averaged_within == NULL)
        return 0;
    out->mechanism = mechanism;
    if (!sf_make_exact(mechanism, design, mu, zeta, &out->exactly))
        return 0;
    out->m = slow_flow_intervals_friction(sfi_point(mu)), out->zeta = sfi_point(zeta);
    out->breaks = out->exactly.breaks, out->empty = out->exactly.empty;
    mechanism->parameters_within(mechanism, design, out->p);
    if (mechanism->breakpoints > 0)
        mechanism->ends_within(mechanism, out->p, b);
    for (int i = 0; i < out->empty; i++)
        if (!(b[i].lo == 0 && b[i].hi == 0))
            return 0;
    if (mechanism->kinks_within != NULL)
        mechanism->kinks_within(mechanism, out->p, kink);
    for (int i = 0; i < out->breaks; i++) {
        const int of = out->empty + i;
        out->b[i] = b[of], out->jump[i] = out->p[mechanism->parameters + of];
        out->kink[i] = mechanism->kinks_within != NULL ? kink[of] : sfi_of(-HUGE_VAL, HUGE_VAL);
    }
    for (int i = 0; i < out->breaks; i++)
        if (!(out->b[i].lo > (i > 0 ? out->b[i - 1].hi : 0)))
            return 0;
    return 1;
}

static inline sf_interval sf_or_unknown(sf_interval x) { return x.lo <= x.hi ? x : sfi_of(-HUGE_VAL, HUGE_VAL); }

static inline void sf_know_within(const sf_inputs *inputs, int piece, sf_interval A, sf_interval beyond,
                                  sf_known *out) {
    sf_interval values[5];
    inputs->mechanism->averaged_within(inputs->mechanism, inputs->empty + piece, A, beyond, inputs->p, values);
    out->h = sf_or_unknown(values[0]), out->h_A = sf_or_unknown(values[1]);
    out->h_AA = sf_or_unknown(values[2]), out->h_AAA = sf_or_unknown(values[3]);
    out->k = sf_or_unknown(values[4]);
}

/* Where a piece begins. */
static inline sf_interval sf_beginning(const sf_inputs *inputs, int piece) {
    return piece > 0 ? inputs->b[piece - 1] : sfi_point(0);
}

/* The amplitudes that exceed it by so much. */
static inline sf_interval sf_beyond(const sf_inputs *inputs, int piece, sf_interval x) {
    return piece > 0 ? sfi_add(inputs->b[piece - 1], x) : x;
}

/* At the amplitude that exceeds the beginning of its piece by x. */
static inline void sf_know_at(const sf_inputs *inputs, int piece, double x, sf_known *out) {
    sf_know_within(inputs, piece, sf_beyond(inputs, piece, sfi_point(x)), sfi_point(x), out);
    out->A = x;
}

/* At breakpoint i as its lower side has it. */
static inline void sf_know_below(const sf_inputs *inputs, int i, sf_known *out) {
    const sf_interval x = i > 0 ? sfi_sub(inputs->b[i], inputs->b[i - 1]) : inputs->b[i];
    sf_know_within(inputs, i, inputs->b[i], x, out);
    out->A = x.hi;
}

/* Whether the force does not jump at breakpoint i. */
static inline int sf_is_continuous_at(const sf_inputs *inputs, int i) {
    return inputs->jump[i].lo == 0 && inputs->jump[i].hi == 0;
}

/* The limit from above at breakpoint i, as `sf_tend_from_above`: a jump of the force makes h_A infinite there, one of
 * its slope h_AA; nothing is known of the derivatives where neither is proved. */
static inline void sf_know_above(const sf_inputs *inputs, int i, sf_known *out) {
    const sf_interval jump = inputs->jump[i], kink = inputs->kink[i];
    sf_know_below(inputs, i, out);
    out->A = 0;
    if (sf_is_continuous_at(inputs, i) && sfi_has_sign(kink)) {
        out->h_AA = sfi_point(kink.lo > 0 ? HUGE_VAL : -HUGE_VAL);
        out->h_AAA = sfi_neg(out->h_AA);
        return;
    }
    if (sfi_has_sign(jump)) {
        out->h_A = out->h_AAA = sfi_point(jump.lo > 0 ? HUGE_VAL : -HUGE_VAL);
        out->k = out->h_AA = sfi_neg(out->h_A);
    } else {
        out->h_A = out->k = out->h_AA = out->h_AAA = sfi_of(-HUGE_VAL, HUGE_VAL);
    }
}

/* Whether smaller intervals bound a function no better, which on this narrow one is `on`: it hardly varies, and at
 * neither end its sign is known. */
static inline int sf_is_noise(sf_interval on, sf_interval at_low, sf_interval at_high) {
    const double least = sfi_least(at_low.hi - at_low.lo, at_high.hi - at_high.lo);
    return !sfi_has_sign(at_low) && !sfi_has_sign(at_high) && !(on.hi - on.lo > SF_NOISE * least);
}
