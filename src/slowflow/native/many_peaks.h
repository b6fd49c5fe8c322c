/* Peaks of batches of designs. Takes designs; returns their highest peaks, by blocks that go through the search
 * together.
 *
 * Most peaks lie on the last piece of the force, or high on the one before, and one look at these proves that there is
 * one and no higher one. Other designs are left to sf_settled_peak.
 */
#pragma once

#include "many_lanes.h"

/* how often a piece that begins at A = 0 is halved in the search for a peak: next to 0 nothing is known over all of
 * one */
enum { SF_PEAK_HALVES = 12 };

/* With the cell from the last breakpoint on. */
static int sf_enter_peak(const sf_call *at, const sf_exact_block *exact, sf_lane_block *block, int d) {
    sf_lane_design *of = &block->at[d];
    const sf_model *model = &of->model;
    if (!sf_enter_at_forcing(at, exact, of, d) || model->breaks == 0)
        return 0;
    const int last = model->breaks - 1;
    if (sf_amplitude_bound(model, of->F_0, &of->A_max) != SF_OK || !(of->A_max > model->b[last]))
        return 0;
    sf_sample low = sf_average_at(model, model->b[last]);
    sf_tend_from_above(model, last, &low);
    const sf_sample high = sf_average_at(model, of->A_max);
    sf_add_cell(block, d, model->b[last], &low, &high);
    return 1;
}

/* Below a last piece without a peak, the first piece or what is left of it: its upper half. */
static void sf_begin_below(sf_lane_block *block, int d, int halved) {
    sf_lane_design *of = &block->at[d];
    if (of->model.breaks != 1) {
        of->ok = 0;
        return;
    }
    const sf_sample low = sf_average_at(&of->model, ldexp(of->model.b[0], -halved - 1));
    const sf_sample high = sf_average_at(&of->model, ldexp(of->model.b[0], -halved));
    sf_add_cell(block, d, 0, &low, &high);
}

/* The brackets of the peaks of a block; designs without are left to sf_settled_peak. */
static void sf_search_peaks(sf_lane_block *block) {
    sf_lane_cells *cells = &block->cells[0];
    int with_one[SF_LANE_CELLS], without[SF_LANE_CELLS], others[SF_LANE_CELLS];
    block->zeros[0].n = 0;
    for (int round = 0; cells->n > 0; round++) {
        int n_one = 0, n_none = 0, n_others = 0;
        sf_judge_peaks(cells);
        for (int i = 0; i < cells->n; i++) {
            const int has_one = cells->verdict[i] == SF_HAS_ONE,
                      has_none = round < SF_PEAK_HALVES && cells->verdict[i] == SF_HAS_NONE;
            with_one[n_one] = without[n_none] = others[n_others] = i;
            n_one += has_one, n_none += has_none, n_others += !has_one && !has_none;
        }
        sf_leave(block, cells->of, others, n_others);
        sf_add_brackets(sf_average_at, block, cells, with_one, n_one);
        for (int i = 0; i < n_none; i++)
            without[i] = cells->of[without[i]];
        cells->n = 0;
        for (int i = 0; i < n_none; i++)
            sf_begin_below(block, without[i], round);
    }
}

/* To its last digit, if there is one. Without a query, which takes as long as some of this answer. */
static int sf_leave_peak(const sf_call *at, const sf_exactly *exactly, sf_lane_block *block, int d, sf_query *q) {
    const sf_lane_design *of = &block->at[d];
    sf_settling peak = {sfp_point(of->w[0]), sfp_point(of->A[0]), sfp_point(of->F_0)};
    (void)q;
    if (of->n != 1 ||
        !sf_settle_near(slow_flow_pairs_peak_step, SF_VARY_BOTH, 2, exactly, &of->model, &of->near[0], &peak) ||
        !(peak.A.high >= of->lo[0] && peak.A.high <= of->hi[0]))
        return 0;
    sf_write_number(at, 0, peak.A.high), sf_write_number(at, 1, peak.Omega.high);
    *sf_output(at, 2) = SF_OK;
    return 1;
}

static void sf_loop_peaks(sf_call *at) {
    static const sf_lane_question peaks = {sizeof(sf_lane_block), SF_LANE_BLOCK,   sf_enter_peak, sf_judge_peaks,
                                           sf_approach_peaks,     sf_search_peaks, sf_average_at, SF_KEPT_ROWS,
                                           SF_LAST_BY_CUBES,      sf_leave_peak};
    sf_loop_in_lanes(at, &peaks);
}
