/* Onsets of batches of designs. Takes designs; returns the cusps below their first breakpoints, by blocks that go
 * through the search together.
 *
 * Most of an onset's time is this search. What is not settled is left to onset.h, as is all else.
 */
#pragma once

#include "many_lanes.h"

enum {
    SF_ONSET_BLOCK = 32, /* designs that go together */
    SF_ONSET_PARTS = 4   /* into which the first piece is cut at once */
};
/* as shares of it */
static const double sf_onset_parts[SF_ONSET_PARTS + 1] = {0, 0.125, 0.25, 0.5, 1};

/* no cusp is evaluated again whose function is 0 but for a smaller change of A, relatively */
#define SF_LAST_OF_CUSP 0x1p-44

/* the share of the stiffness below which zeta^2 is left alone: there the slopes by which a cusp is settled, which are
 * doubles, have lost too many digits for the last of them to be the same from wherever it begins */
#define SF_WEAK 0x1p-40

/* lanes: of its designs the cusps on their first pieces */
typedef struct {
    sf_lane_block lanes;
    sf_piece_ends ends[SF_ONSET_BLOCK];
    sf_onset best[SF_ONSET_BLOCK];
} sf_onset_block;

/* With parts of the first piece for each channel; not where h_A is not negative: there may be more than cusps. */
static int sf_enter_onset(const sf_call *at, const sf_exact_block *exact, sf_lane_block *lanes, int d) {
    sf_onset_block *block = (sf_onset_block *)(void *)lanes;
    sf_lane_design *of = &lanes->at[d];
    sf_model *model = &of->model;
    sf_piece_ends *ends = &block->ends[d];
    sf_sample part[SF_ONSET_PARTS + 1];
    of->n = 0;
    if (!sf_prepare_member(at, exact, d, model))
        return 0;
    sf_end_pieces(model, ends);
    sf_begin_onset(model, ends, &block->best[d]);
    if (model->breaks == 0 || ends->rest.h != 0 || isinf(ends->rest.h_A) ||
        !(ends->rest.h_A < 0 && ends->on[0].h_A < 0) ||
        !(model->zeta * model->zeta * model->b[0] > SF_WEAK * fabs(ends->on[0].h)))
        return 0;
    part[0] = ends->rest, part[SF_ONSET_PARTS] = ends->on[0];
    for (int k = 1; k < SF_ONSET_PARTS; k++)
        part[k] = sf_sample_at(model, sf_onset_parts[k] * model->b[0]);
    of->task[1] = model->zeta, of->task[2] = model->m, of->task[3] = block->best[d].F_SN;
    of->task[0] = 1; /* nearly always without cusps */
    sf_add_cell(lanes, d, 0, &part[0], &part[1]);
    sf_add_cell(lanes, d, 0, &part[1], &part[SF_ONSET_PARTS]);
    of->task[0] = -1;
    for (int k = 0; k < SF_ONSET_PARTS; k++)
        sf_add_cell(lanes, d, 0, &part[k], &part[k + 1]);
    return 1;
}

static int sf_leave_onset(const sf_call *at, const sf_exactly *exactly, sf_lane_block *lanes, int d, sf_query *q) {
    sf_onset_block *block = (sf_onset_block *)(void *)lanes;
    const sf_lane_design *of = &lanes->at[d];
    sf_onset *found = &block->best[d];
    for (int i = 0; i < of->n; i++) {
        const sf_sample *near = &of->near[i];
        if (sf_is_minimum(&of->model, SF_CUSP, near, of->w[i]))
            sf_consider(sf_level(&of->model, near, of->w[i]), of->w[i], near->A, SF_CUSP_KIND, found);
    }
    if (sf_end_onset(&of->model, &block->ends[d], 1, &q->room->work, found) != SF_OK ||
        !sf_settle_onset(&of->model, exactly, found))
        return 0;
    sf_put_onset(q, SF_OK, found, sf_is_rest_below(found));
    sf_write_answer(at, q);
    return 1;
}

static void sf_loop_onsets(sf_call *at) {
    static const sf_lane_question cusps = {sizeof(sf_onset_block), SF_ONSET_BLOCK, sf_enter_onset, sf_judge_cusps,
                                           sf_approach_cusps,      NULL,           sf_sample_at,   SF_REMEMBERED_ROWS,
                                           SF_LAST_OF_CUSP,        sf_leave_onset};
    sf_loop_in_lanes(at, &cusps);
}
