/* Onsets of batches of designs: in go designs, out come the cusps below their first breakpoints, each between two amplitudes,
 * by blocks that go through the search together.
 *
 * Most of an onset's time is this search. What is not settled is left to onset.h, as is all else.
 */
#ifndef SF_MANY_ONSETS_H
#define SF_MANY_ONSETS_H

#include "many_lanes.h"

enum {
    SF_ONSET_BLOCK = 32, /* designs that go together */
    SF_ONSET_ROUNDS = 8, /* of cuts */
    SF_ONSET_PARTS = 4   /* into which the first piece is cut at once */
};
/* as shares of it */
static const double sf_onset_parts[SF_ONSET_PARTS + 1] = {0, 0.125, 0.25, 0.5, 1};

/* ok: whether its cusps are known; begun: whether it has parameters that an onset may be asked of */
typedef struct {
    int begun, ok;
    sf_model model;
    sf_onset best;
    sf_cusps_between cusps;
} sf_lane_onset;

typedef struct {
    sf_lane_onset at[SF_ONSET_BLOCK];
    sf_cusp_cells cells[2];
} sf_onset_block;

static inline void sf_cusp_row(double (*rows)[SF_LANE_CELLS], int i, const sf_sample *at) {
    int k;
    rows[0][i] = at->A;
    for (k = 0; k < 5; k++)
        rows[k + 1][i] = at->averages[k];
}

static inline void sf_cusp_sample(const double (*rows)[SF_LANE_CELLS], int i, sf_sample *at) {
    int k;
    at->A = rows[0][i];
    for (k = 0; k < 5; k++)
        at->averages[k] = rows[k + 1][i];
}

/* The cells with which the search for the cusps of design d begins; 0 where it is left to onset.h. */
static int sf_begin_cusps(sf_onset_block *block, int d) {
    sf_lane_onset *of = &block->at[d];
    const sf_model *model = &of->model;
    sf_cusp_cells *cells = &block->cells[0];
    sf_sample ends[SF_ONSET_PARTS + 1];
    int k;
    of->cusps.n = 0;
    if (!(model->zeta > 0) || model->breaks == 0 || model->breaks < model->mechanism->breakpoints)
        return 0;
    for (k = 0; k <= SF_ONSET_PARTS; k++)
        sf_sample_at(model, sf_onset_parts[k] * model->b[0], &ends[k]);
    if (ends[0].h != 0)
        return 0;
    for (k = 0; k < SF_ONSET_PARTS; k++) {
        const int i = cells->n++;
        sf_cusp_row(cells->low, i, &ends[k]);
        sf_cusp_row(cells->high, i, &ends[k + 1]);
        cells->asked[0][i] = model->m, cells->asked[1][i] = model->zeta, cells->asked[2][i] = of->best.F_SN;
        cells->open[0][i] = cells->open[1][i] = 1, cells->of[i] = d;
    }
    return 1;
}

/* What is said of a channel of a cell; returns whether it stays open. */
static inline int sf_take_cusp(sf_lane_onset *of, const sf_cusp_cells *cells, int i, int channel) {
    sf_cusps_between *cusps = &of->cusps;
    if (cells->open[channel][i] == 0 || cells->verdict[channel][i] == SF_HAS_NONE)
        return 0;
    if (cells->verdict[channel][i] != SF_HAS_ONE)
        return 1;
    if (cusps->n == SF_MOST_CUSPS) {
        of->ok = 0;
        return 0;
    }
    cusps->channel[cusps->n] = channel;
    sf_cusp_sample(cells->low, i, &cusps->low[cusps->n]);
    sf_cusp_sample(cells->high, i, &cusps->high[cusps->n]);
    cusps->n++;
    return 0;
}

/* Cell i as two of the next round; 0 where there are no places. */
static int sf_cut_cusps(sf_lane_onset *of, const sf_cusp_cells *cells, int i, const int *open, sf_cusp_cells *next) {
    const int k = next->n;
    sf_sample middle, low, high;
    int end, row;
    if (k + 2 > SF_LANE_CELLS)
        return 0;
    sf_sample_at(&of->model, cells->low[0][i] > 0 ? 0.5 * (cells->low[0][i] + cells->high[0][i]) : 0.125 * cells->high[0][i], &middle);
    sf_cusp_sample(cells->low, i, &low);
    sf_cusp_sample(cells->high, i, &high);
    sf_cusp_row(next->low, k, &low);
    sf_cusp_row(next->high, k, &middle);
    sf_cusp_row(next->low, k + 1, &middle);
    sf_cusp_row(next->high, k + 1, &high);
    for (end = 0; end < 2; end++) {
        for (row = 0; row < SF_CUSP_ASKED_ROWS; row++)
            next->asked[row][k + end] = cells->asked[row][i];
        next->open[0][k + end] = open[0], next->open[1][k + end] = open[1], next->of[k + end] = cells->of[i];
    }
    next->n += 2;
    return 1;
}

/* All cells of a block, until none is open. */
static void sf_search_cusps(sf_onset_block *block) {
    int round, i;
    for (round = 0; block->cells[round % 2].n > 0; round++) {
        sf_cusp_cells *cells = &block->cells[round % 2], *next = &block->cells[1 - round % 2];
        sf_judge_cusps(cells);
        next->n = 0;
        for (i = 0; i < cells->n; i++) {
            sf_lane_onset *of = &block->at[cells->of[i]];
            int open[2];
            if (!of->ok)
                continue;
            open[0] = sf_take_cusp(of, cells, i, 0), open[1] = sf_take_cusp(of, cells, i, 1);
            if ((open[0] || open[1]) && (round == SF_ONSET_ROUNDS || !sf_cut_cusps(of, cells, i, open, next)))
                of->ok = 0;
        }
    }
}

#endif
