/* States of batches of designs. Takes designs; returns their states, by blocks that go through the search together.
 *
 * Each state is settled to its last digit as a single one is, so that it is the same double. A design that is doubtful
 * anywhere, or not settled by so many rounds, is left to states.h.
 */
#pragma once

#include "many_lanes.h"
#include "states.h"

static const sf_lane_question sf_states_in_lanes = {sf_judge_states, sf_approach_states, sf_average_at,
                                                    SF_KEPT_ROWS, SF_LAST_BY_CUBES};

static void sf_search_states(sf_lane_block *block) {
    sf_search_block(&sf_states_in_lanes, block);
    sf_approach_block(&sf_states_in_lanes, block);
}

/* The cells with which the search for the states of design d begins, one for each piece of the force; 0 where it is
 * left to states.h, see sf_clear_states. */
static int sf_begin_states(sf_lane_block *block, int d, const sf_exact_block *exact) {
    sf_lane_design *of = &block->at[d];
    sf_model *model = &of->model;
    const sf_mechanism *mechanism = model->mechanism;
    double A_max;
    of->n = 0;
    if (!(model->zeta > 0) || sf_nearly_sticks(model, of->F_0))
        return 0;
    A_max = slow_flow_limit_envelope(of->Omega, of->F_0 * (1 + SF_CLOSE), model->m, model->zeta) * (1 + SF_CLOSE);
    if (!(A_max > SF_FIRST && A_max < SF_ENDLESS) || !sf_prepare(mechanism, NULL, model) ||
        model->breaks < mechanism->breakpoints)
        return 0;
    if (model->breaks > 0 && model->b[0] < A_max && !sf_take_jumps(exact, d, model))
        return 0;
    of->task[0] = of->Omega, of->task[1] = model->zeta, of->task[2] = model->m, of->task[3] = of->F_0;
    return sf_begin_pieces(&sf_states_in_lanes, block, d, A_max, 1, NULL);
}

/* The states of a design that the block has found, each to its last digit; 0 where one does not settle. */
static int sf_settle_block_states(const sf_lane_design *of, const sf_exactly *exactly, double *A) {
    for (int i = 0; i < of->n; i++) {
        sf_settling at = {sfp_point(of->Omega), sfp_point(of->A[i]), sfp_point(of->F_0)};
        if (!sf_settle_near(slow_flow_pairs_state_step, SF_MOVES_A, 2, exactly, &of->model, &of->near[i], &at) ||
            !(at.A.high >= of->lo[i] && at.A.high <= of->hi[i]) || (i > 0 && !(at.A.high > A[i - 1])))
            return 0;
        A[i] = at.A.high;
    }
    return 1;
}
