/* The oscillator's exact inputs, in double-double. Takes its numbers; returns its parameters and h with its
 * derivatives to some thirty digits.
 */
#pragma once

#include "cells.h"
#include "slow_flow_pairs.h"

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

/* Whether the mechanism has a form in pairs, and its excitation is a force, which these forms are about. */
static inline int sf_has_pairs(const sf_mechanism *mechanism) {
    return mechanism->averaged_in_pairs != NULL && !mechanism->inertial;
}

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

/* 0 where there is no form in pairs. */
static inline int sf_make_exact(const sf_mechanism *mechanism, const double *design, double mu, double zeta,
                                sf_exactly *out) {
    if (!sf_has_pairs(mechanism))
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
