/* Onsets of batches of designs: in go designs, out come the cusps below their first breakpoints, by blocks that go
 * through the search together.
 *
 * Most of an onset's time is this search. What is not settled is left to onset.h, as is all else.
 */
#ifndef SF_MANY_ONSETS_H
#define SF_MANY_ONSETS_H

#include "many_lanes.h"

enum {
    SF_ONSET_BLOCK = 32,      /* designs that go together */
    SF_ONSET_ROUNDS = 8,      /* of cuts */
    SF_ONSET_PARTS = 4,       /* into which the first piece is cut at once */
    SF_ONSET_APPROACHES = 8
};
/* as shares of it */
static const double sf_onset_parts[SF_ONSET_PARTS + 1] = {0, 0.125, 0.25, 0.5, 1};

/* no cusp is asked again whose function is 0 but for a smaller change of A, relatively */
#define SF_LAST_OF_CUSP 0x1p-44

/* the share of the stiffness below which zeta^2 is left alone: there the slopes by which a cusp is settled, which are
 * doubles, have lost too many digits for the last of them to be the same from wherever it begins */
#define SF_WEAK 0x1p-40

/* ok: whether its cusps are known; begun: whether it has parameters that an onset may be asked of */
typedef struct {
    int begun, ok;
    sf_model model;
    sf_piece_ends ends;
    sf_onset best;
} sf_lane_onset;

/* A cell that is cut, and the channels that are open. */
typedef struct {
    int cell, open[2];
} sf_cusp_cut;

typedef struct {
    sf_lane_onset at[SF_ONSET_BLOCK];
    sf_cusp_probes probes;
    sf_cusp_cells cells[2];
    sf_cusp_cut cut[SF_LANE_CELLS];
    sf_cusp_zeros zeros[2];
} sf_onset_block;

static inline void sf_add_cusp_probe(sf_cusp_probes *probes, const sf_model *model, const sf_sample *at) {
    const int i = probes->n++;
    int k;
    probes->at[0][i] = at->A;
    for (k = 0; k < 5; k++)
        probes->at[k + 1][i] = at->averages[k];
    probes->asked[0][i] = model->m, probes->asked[1][i] = model->zeta;
}

/* Place i of some rows into place k of others. */
static inline void sf_copy_place(const double (*from)[SF_LANE_CELLS], int i, int rows, double (*to)[SF_LANE_CELLS],
                                 int k)
{
    int row;
    for (row = 0; row < rows; row++)
        to[row][k] = from[row][i];
}

/* Whether the search for the cusps of design d begins, with what is known between the parts of its first piece. */
static int sf_begin_cusps(sf_onset_block *block, int d) {
    sf_lane_onset *of = &block->at[d];
    const sf_model *model = &of->model;
    int k;
    if (model->breaks == 0 || model->breaks < model->mechanism->breakpoints || of->ends.rest.h != 0 ||
        isinf(of->ends.rest.h_A) ||
        !(model->zeta * model->zeta * model->b[0] > SF_WEAK * fabs(of->ends.on[0].h)))
        return 0;
    sf_add_cusp_probe(&block->probes, model, &of->ends.rest);
    for (k = 1; k < SF_ONSET_PARTS; k++) {
        sf_sample at;
        sf_sample_at(model, sf_onset_parts[k] * model->b[0], &at);
        sf_add_cusp_probe(&block->probes, model, &at);
    }
    sf_add_cusp_probe(&block->probes, model, &of->ends.on[0]);
    return 1;
}

/* The cells with which it begins, all designs that do so having their probes in turn. */
static void sf_make_cusp_cells(sf_onset_block *block) {
    sf_cusp_cells *cells = &block->cells[0];
    const double(*at)[SF_LANE_CELLS] = (const double(*)[SF_LANE_CELLS])block->probes.at;
    int d, k, low = 0;
    cells->n = 0;
    for (d = 0; d < SF_ONSET_BLOCK; d++) {
        const sf_lane_onset *of = &block->at[d];
        if (!of->ok)
            continue;
        for (k = 0; k < SF_ONSET_PARTS; k++, low++) {
            const int i = cells->n++;
            sf_copy_place(at, low, SF_CUSP_ROWS, cells->low, i);
            sf_copy_place(at, low + 1, SF_CUSP_ROWS, cells->high, i);
            cells->asked[0][i] = of->model.m, cells->asked[1][i] = of->model.zeta, cells->asked[2][i] = of->best.F_SN;
            cells->open[0][i] = cells->open[1][i] = 1, cells->of[i] = d;
        }
        low++;
    }
}

/* What is said of a channel of a cell; returns whether it stays open. */
static inline int sf_take_cusp(sf_onset_block *block, const sf_cusp_cells *cells, int i, int channel) {
    sf_cusp_zeros *zeros = &block->zeros[0];
    int row, k;
    if (cells->open[channel][i] == 0 || cells->verdict[channel][i] == SF_HAS_NONE)
        return 0;
    if (cells->verdict[channel][i] != SF_HAS_ONE)
        return 1;
    if (zeros->n == SF_LANE_CELLS) {
        block->at[cells->of[i]].ok = 0;
        return 0;
    }
    k = zeros->n++;
    for (row = 0; row < 3; row++) {
        const int from = row == 0 ? 0 : SF_CUSP_PROBE_ROWS + 2 * (row - 1) + channel;
        zeros->lo[row][k] = cells->low[from][i], zeros->hi[row][k] = cells->high[from][i];
    }
    zeros->asked[0][k] = cells->asked[0][i], zeros->asked[1][k] = cells->asked[1][i];
    zeros->sign[k] = channel == 0 ? 1 : -1, zeros->of[k] = cells->of[i];
    return 0;
}

/* The amplitude at which a cell is cut. */
static void sf_cut_cusps(sf_onset_block *block, const sf_cusp_cells *cells, int i) {
    const sf_model *model = &block->at[cells->of[i]].model;
    const double low = cells->low[0][i], high = cells->high[0][i];
    sf_sample at;
    sf_sample_at(model, low > 0 ? 0.5 * (low + high) : 0.125 * high, &at);
    sf_add_cusp_probe(&block->probes, model, &at);
}

/* The halves of all cells that are cut. */
static void sf_make_halves(const sf_onset_block *block, const sf_cusp_cells *cells, sf_cusp_cells *next) {
    const double(*at)[SF_LANE_CELLS] = (const double(*)[SF_LANE_CELLS])block->probes.at;
    int j, end;
    next->n = 0;
    for (j = 0; j < block->probes.n; j++) {
        const int i = block->cut[j].cell;
        for (end = 0; end < 2; end++) {
            const int k = next->n++;
            sf_copy_place(end == 0 ? (const double (*)[SF_LANE_CELLS])cells->low : at, end == 0 ? i : j, SF_CUSP_ROWS,
                          next->low, k);
            sf_copy_place(end == 0 ? at : (const double (*)[SF_LANE_CELLS])cells->high, end == 0 ? j : i, SF_CUSP_ROWS,
                          next->high, k);
            sf_copy_place((const double(*)[SF_LANE_CELLS])cells->asked, i, SF_CUSP_ASKED_ROWS, next->asked, k);
            next->open[0][k] = block->cut[j].open[0], next->open[1][k] = block->cut[j].open[1],
            next->of[k] = cells->of[i];
        }
    }
}

/* All cells of a block, until none is open. */
static void sf_search_cusps(sf_onset_block *block) {
    int round, i;
    if (block->probes.n == 0)
        return;
    sf_ask_cusps(&block->probes);
    sf_make_cusp_cells(block);
    for (round = 0; block->cells[round % 2].n > 0; round++) {
        sf_cusp_cells *cells = &block->cells[round % 2], *next = &block->cells[1 - round % 2];
        sf_judge_cusps(cells);
        block->probes.n = 0;
        for (i = 0; i < cells->n; i++) {
            sf_lane_onset *of = &block->at[cells->of[i]];
            sf_cusp_cut *cut = &block->cut[block->probes.n];
            if (round == 0 && cells->falls[i] == 0) /* there may be more than cusps */
                of->ok = 0;
            if (!of->ok)
                continue;
            cut->cell = i, cut->open[0] = sf_take_cusp(block, cells, i, 0),
            cut->open[1] = sf_take_cusp(block, cells, i, 1);
            if (!(cut->open[0] || cut->open[1]))
                continue;
            if (round == SF_ONSET_ROUNDS || block->probes.n == SF_LANE_CELLS / 2)
                of->ok = 0;
            else
                sf_cut_cusps(block, cells, i);
        }
        if (block->probes.n > 0)
            sf_ask_cusps(&block->probes);
        sf_make_halves(block, cells, next);
    }
}

/* A cusp that is known to its digits, beside what is known of its design. */
static void sf_consider_cusp(sf_lane_onset *of, const sf_cusp_zeros *zeros, int i) {
    sf_zero zero;
    sf_sample at;
    int k;
    at.A = zero.A = zeros->at[0][i], zero.Omega = zeros->Omega[i], zero.level = zeros->level[i],
    zero.question = SF_CUSP;
    for (k = 0; k < 5; k++)
        at.averages[k] = zeros->at[k + 1][i];
    sf_consider_zero(&of->model, &zero, &at, &of->best);
}

/* All cusps of a block, until all are known to their digits. */
static void sf_approach_block_cusps(sf_onset_block *block) {
    int round, i, row;
    if (block->zeros[0].n > 0)
        sf_start_cusps(&block->zeros[0]);
    for (round = 0; block->zeros[round % 2].n > 0; round++) {
        sf_cusp_zeros *zeros = &block->zeros[round % 2], *next = &block->zeros[1 - round % 2];
        for (i = 0; i < zeros->n; i++) {
            sf_sample at;
            sf_sample_at(&block->at[zeros->of[i]].model, zeros->next[i], &at);
            zeros->at[0][i] = at.A;
            for (row = 0; row < 5; row++)
                zeros->at[row + 1][i] = at.averages[row];
        }
        sf_approach_cusps(zeros);
        next->n = 0;
        for (i = 0; i < zeros->n; i++) {
            const int k = next->n;
            if (zeros->left[i] <= SF_LAST_OF_CUSP) {
                sf_consider_cusp(&block->at[zeros->of[i]], zeros, i);
                continue;
            }
            if (round == SF_ONSET_APPROACHES) {
                block->at[zeros->of[i]].ok = 0;
                continue;
            }
            sf_copy_place((const double(*)[SF_LANE_CELLS])zeros->lo, i, 3, next->lo, k);
            sf_copy_place((const double(*)[SF_LANE_CELLS])zeros->hi, i, 3, next->hi, k);
            sf_copy_place((const double(*)[SF_LANE_CELLS])zeros->last, i, 3, next->last, k);
            sf_copy_place((const double(*)[SF_LANE_CELLS])zeros->asked, i, 2, next->asked, k);
            next->sign[k] = zeros->sign[i], next->of[k] = zeros->of[i], next->next[k] = zeros->next[i];
            next->n++;
        }
    }
}

#endif
