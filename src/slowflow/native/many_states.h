/* States of batches of designs. Takes designs; returns their states, by blocks that go through the search together.
 *
 * Each state is settled to its last digit as a single one is, so that it is the same double. A design that is undecided
 * anywhere, or not settled by so many rounds, is left to states.h.
 */
#pragma once

#include "many_lanes.h"
#include "states.h"

/* With one cell for each piece of the force, see sf_clear_states. */
static int sf_enter_states(const sf_call *at, const sf_exact_block *exact, sf_lane_block *block, int d) {
    sf_lane_design *of = &block->at[d];
    sf_model *model = &of->model;
    const sf_mechanism *mechanism = at->mechanism;
    of->F_0 = sf_number(at, 0), of->Omega = sf_number(at, 1), of->n = 0, model->mechanism = mechanism;
    if (!(mechanism->is_forcing(of->F_0) && sf_has_states(of->Omega)))
        return 0;
    if (!sf_take_member(at, exact, d, model) || !(model->zeta > 0) || sf_nearly_sticks(model, of->F_0))
        return 0;
    const double A_max = sf_above_states(model, of->F_0, of->Omega);
    if (!(A_max > SF_FIRST && A_max < SF_ENDLESS) || !sf_prepare(mechanism, NULL, model) ||
        model->breaks < mechanism->breakpoints)
        return 0;
    if (model->breaks > 0 && model->b[0] < A_max && !sf_take_jumps(exact, d, model))
        return 0;
    of->task[0] = of->Omega, of->task[1] = model->zeta, of->task[2] = model->m, of->task[3] = of->F_0;
    return sf_begin_pieces(sf_average_at, block, d, A_max, 1, NULL);
}

/* Without a query, as peaks. */
static int sf_leave_states(const sf_call *at, const sf_exactly *exactly, sf_lane_block *block, int d, sf_query *q) {
    const sf_lane_design *of = &block->at[d];
    const long max_count = (long)at->dimensions[1], n = of->n < max_count ? of->n : max_count;
    double A[SF_LANE_ZEROS];
    const sf_item amplitudes = {SF_NUMBERS, 0, of->n, A, sizeof *A}, stable = {SF_BYTE_FLAGS, 0, of->n, of->rises, 1};
    (void)q;
    for (int i = 0; i < of->n; i++) {
        sf_settling near = {sfp_point(of->Omega), sfp_point(of->A[i]), sfp_point(of->F_0)};
        if (!sf_settle_near(slow_flow_pairs_state_step, SF_VARY_A, 2, exactly, &of->model, &of->near[i], &near) ||
            !(near.A.high >= of->lo[i] && near.A.high <= of->hi[i]) || (i > 0 && !(near.A.high > A[i - 1])))
            return 0;
        A[i] = near.A.high;
    }
    sf_write_places(&amplitudes, n, 'D', max_count, sf_output(at, 0), at->inner[0]);
    sf_write_places(&stable, n, 'B', max_count, sf_output(at, 1), at->inner[1]);
    *sf_output(at, 2) = (char)of->n, *sf_output(at, 3) = 0;
    *sf_output(at, 4) = of->n > max_count ? SF_TOO_MANY : SF_OK;
    return 1;
}

static void sf_loop_states(sf_call *at) {
    static const sf_lane_question states = {sizeof(sf_lane_block), SF_LANE_BLOCK,  sf_enter_states, sf_judge_states,
                                            sf_approach_states,    NULL,           sf_average_at,   SF_KEPT_ROWS,
                                            SF_LAST_BY_CUBES,      sf_leave_states};
    sf_loop_in_lanes(at, &states);
}
