/* Detachment in batches of designs. Takes designs by blocks; returns Omega_cr and F_cr, settled.
 *
 * What sf_settled_detachment does for one design, by loops that vectorise: a root in doubles and what corrects the
 * level in pairs are long chains in which each operation waits for the one before, and designs do not wait for each
 * other. What is not the usual case there is left to it.
 */
#pragma once

#include "many_lanes.h"

/* A block of designs, row by row. A, h: on the breakpoint in doubles, NaN for what is no member; end: the breakpoint
 * and h on it in pairs, their high and low parts laid out as numbers are; change: of F_cr, NaN where the design is
 * left to sf_settled_detachment */
typedef struct {
    double mu[SF_LANE_BLOCK], m[SF_LANE_BLOCK], zeta[SF_LANE_BLOCK], A[SF_LANE_BLOCK], h[SF_LANE_BLOCK];
    double end[4 * SF_LANE_BLOCK], Omega[SF_LANE_BLOCK], F_0[SF_LANE_BLOCK], change[SF_LANE_BLOCK], u_cr[SF_LANE_BLOCK];
} sf_detaching;

/* sf_least_forcing, with one step of sf_polish_cubic, which is nearly always the last */
static SF_FLAT void sf_lane_least_forcings(ptrdiff_t n, sf_detaching *block) {
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const double A = block->A[i], h = block->h[i], m = block->m[i], zeta = block->zeta[i];
        double cubic[5];
        frequencies_response_derivative(A, m, zeta, h, cubic);
        const double p = cubic[0], q = cubic[2];
        const sf_lane_critical at = sf_lane_critical_at(A, p, q);
        const double near = q == 0 ? sqrt((p < 0 ? -p : 1.0) / A) : at.w2, slope = frequencies_cubic_slope(near, A, p);
        const double step = frequencies_cubic_fine(near, A, p, cubic[1], q, cubic[3]) / slope, next = near - step;
        const int is_step = fabs(step) <= SF_SIMPLE * near, has_one = (p < 0) & (at.rho <= 1 - SF_MAY_MEET);
        const int is_last = !is_step | (3 * A * next * step * step <= SF_POLISHED * next * fabs(slope));
        const double found = is_step ? next : near, last = has_one ? found : 0.0;
        const double at_rest = slow_flow_level(0, A, m, zeta, h), level = slow_flow_level(last, A, m, zeta, h);
        const double least = level < at_rest ? level : at_rest;
        const int is_known = ((has_one & is_last) | (p >= 0) | (at.rho > 1 + SF_MAY_MEET)) & (A > 0) & (m >= 0) &
                             (zeta >= 0) & (A + fabs(h) + m + zeta < HUGE_VAL) & (least < HUGE_VAL);
        block->Omega[i] = level < at_rest ? last : 0.0;
        block->F_0[i] = is_known ? least : NAN;
    }
}

/* What sf_settle_level_on asks */
static SF_FLAT void sf_lane_level_steps(ptrdiff_t n, sf_detaching *block) {
    const double *end = block->end;
    SF_INDEPENDENT
    for (ptrdiff_t i = 0; i < n; i++) {
        const sf_pair b = {end[i], end[SF_LANE_BLOCK + i]}, none = {0, 0};
        const sf_pair h = {end[2 * SF_LANE_BLOCK + i], end[3 * SF_LANE_BLOCK + i]};
        const sf_pair m = slow_flow_pairs_friction(sfp_point(block->mu[i]));
        double out[4];
        slow_flow_pairs_level_step(sfp_point(block->Omega[i]), b, sfp_point(block->F_0[i]), m,
                                   sfp_point(block->zeta[i]), h, none, none, none, out);
        block->change[i] = out[0];
    }
}

static void sf_settle_detachments(const sf_mechanism *mechanism, ptrdiff_t n, const sf_exact_block *exact,
                                  sf_detaching *block) {
    sf_lane_least_forcings(n, block);
    mechanism->on_first_end_in_pairs(mechanism, n, SF_LANE_BLOCK, exact->number, block->end);
    sf_lane_level_steps(n, block);
    for (ptrdiff_t d = 0; d < n; d++)
        sf_change_level(block->end[d], block->change[d], &block->F_0[d]);
}

/* Without a query, which takes half as long as this answer. */
static void sf_write_detachment(const sf_call *at, double F_cr, double Omega_cr, double u_cr, sf_status status) {
    sf_write_number(at, 0, F_cr), sf_write_number(at, 1, Omega_cr), sf_write_number(at, 2, u_cr);
    *sf_output(at, 3) = (char)status;
}

/* Detachment of one design, by itself. */
static void sf_detach_singly(const sf_call *at) {
    double F_cr = NAN, Omega_cr = NAN, u_cr = NAN;
    sf_status status = SF_INVALID;
    sf_numbers inputs;
    sf_model model;
    sf_exactly exactly;
    if (sf_design_at(at, 0, &inputs, &model))
        status =
            sf_settled_detachment(&model, sf_exactly_in(&inputs, at->mechanism, &exactly), &F_cr, &Omega_cr, &u_cr);
    sf_write_detachment(at, F_cr, Omega_cr, u_cr, status);
}

/* Design k, as member d, unless it has fewer breakpoints. */
static void sf_enter_detachment(const sf_call *at, const sf_exact_block *exact, sf_detaching *block, ptrdiff_t d) {
    const sf_mechanism *mechanism = at->mechanism;
    sf_model model;
    sf_sample end = {.A = NAN, .h = NAN};
    model.m = model.zeta = NAN;
    if (sf_take_member(at, exact, d, &model) && sf_prepare(mechanism, NULL, &model) &&
        model.breaks == mechanism->breakpoints) {
        end = sf_sample_without_k_at(&model, model.b[0]);
        block->u_cr[d] = sf_largest_displacement(&model, end.A);
    }
    block->mu[d] = sf_input(at, mechanism->design_size), block->m[d] = model.m, block->zeta[d] = model.zeta;
    block->A[d] = end.A, block->h[d] = end.h;
}

static void sf_loop_detachment(sf_call *at) {
    const sf_mechanism *mechanism = at->mechanism;
    const int together = mechanism->on_first_end_in_pairs != NULL && !mechanism->inertial && !sf_takes_laws(mechanism);
    sf_exact_block exact;
    sf_detaching block;
    ptrdiff_t end, d;
    for (ptrdiff_t first = 0; first < at->dimensions[0]; first = end) {
        at->k = first, end = sf_end_of_block(at, SF_LANE_BLOCK);
        if (together) {
            sf_make_exact_block(at, end, &exact);
            for (d = 0; at->k < end; at->k++, d++)
                sf_enter_detachment(at, &exact, &block, d);
            sf_settle_detachments(mechanism, d, &exact, &block);
        }
        for (at->k = first, d = 0; at->k < end; at->k++, d++)
            if (!together || isnan(block.change[d]))
                sf_detach_singly(at);
            else
                sf_write_detachment(at, block.F_0[d], block.Omega[d], block.u_cr[d], SF_OK);
    }
}
