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

/* no cusp is asked again whose function is 0 but for a smaller change of A, relatively */
#define SF_LAST_OF_CUSP 0x1p-44

/* the share of the stiffness below which zeta^2 is left alone: there the slopes by which a cusp is settled, which are
 * doubles, have lost too many digits for the last of them to be the same from wherever it begins */
#define SF_WEAK 0x1p-40

static const sf_lane_question sf_cusps_in_lanes = {sf_judge_cusps, sf_approach_cusps, sf_sample_at, SF_REMEMBERED_ROWS,
                                                   SF_LAST_OF_CUSP};

static void sf_search_cusps(sf_lane_block *block) {
    sf_search_block(&sf_cusps_in_lanes, block);
    sf_approach_block(&sf_cusps_in_lanes, block);
}

/* lanes: of its designs the cusps on their first pieces */
typedef struct {
    sf_lane_block lanes;
    sf_piece_ends ends[SF_ONSET_BLOCK];
    sf_onset best[SF_ONSET_BLOCK];
} sf_onset_block;

/* The cells with which the search for the cusps of design d begins, parts of its first piece for each channel; 0 where
 * it is left to onset.h, as where h_A is not negative: there may be more than cusps. */
static int sf_begin_cusps(sf_onset_block *block, int d) {
    sf_lane_design *of = &block->lanes.at[d];
    const sf_model *model = &of->model;
    const sf_piece_ends *ends = &block->ends[d];
    sf_sample at[SF_ONSET_PARTS + 1];
    of->n = 0;
    if (model->breaks == 0 || model->breaks < model->mechanism->breakpoints || ends->rest.h != 0 ||
        isinf(ends->rest.h_A) || !(ends->rest.h_A < 0 && ends->on[0].h_A < 0) ||
        !(model->zeta * model->zeta * model->b[0] > SF_WEAK * fabs(ends->on[0].h)))
        return 0;
    at[0] = ends->rest, at[SF_ONSET_PARTS] = ends->on[0];
    for (int k = 1; k < SF_ONSET_PARTS; k++)
        at[k] = sf_sample_at(model, sf_onset_parts[k] * model->b[0]);
    of->task[1] = model->zeta, of->task[2] = model->m, of->task[3] = block->best[d].F_SN;
    of->task[0] = 1; /* nearly always without cusps */
    sf_add_cell(&block->lanes, d, 0, &at[0], &at[1]);
    sf_add_cell(&block->lanes, d, 0, &at[1], &at[SF_ONSET_PARTS]);
    of->task[0] = -1;
    for (int k = 0; k < SF_ONSET_PARTS; k++)
        sf_add_cell(&block->lanes, d, 0, &at[k], &at[k + 1]);
    return 1;
}

/* The cusps that the block has found of a design, beside what is known of it. */
static void sf_consider_cusps(const sf_lane_design *of, sf_onset *best) {
    for (int i = 0; i < of->n; i++) {
        const sf_sample *at = &of->near[i];
        if (sf_is_minimum(&of->model, SF_CUSP, at, of->w[i]))
            sf_consider(sf_level(&of->model, at, of->w[i]), of->w[i], at->A, SF_CUSP_KIND, best);
    }
}
