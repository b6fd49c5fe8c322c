/* States of batches of designs: in go designs, out come their states, by blocks that go through the search together
 * (state_lanes.h).
 *
 * Cells of all designs of a block are judged at once, then all that stay open are cut, and all zeros are approached at once.
 * Each is settled to its last digit as a single one is, so that it is the same double. A design that is doubtful anywhere,
 * or not settled by so many rounds, is left to states.h.
 */
#ifndef SF_MANY_STATES_H
#define SF_MANY_STATES_H

#include "settle.h"
#include "state_lanes.h"
#include "states.h"

enum {
    SF_STATE_BLOCK = 128,   /* designs that go together */
    SF_STATE_ROUNDS = 12,  /* of cuts */
    SF_STATE_APPROACHES = 8,
    SF_LANE_STATES = 8     /* of one design */
};

/* no step to a zero needs a further one before it is settled if it is smaller, relatively: errors fall by cubes */
#define SF_LAST_APPROACH 0x1p-17

/* A design's numbers, and its damping. */
typedef struct {
    double design[SF_MOST_DESIGN], damping[SF_MOST_DAMPING];
} sf_numbers;

/* A member of a block. asked: its rows (state_lanes.h); ok: whether it is not left to states.h; what was found, by rising A: A,
 * the bracket, whether F rises there, and what is known near by */
typedef struct {
    double F_0, Omega, asked[SF_ASKED_ROWS];
    sf_model model;
    int ok, n, rises[SF_LANE_STATES];
    double A[SF_LANE_STATES], lo[SF_LANE_STATES], hi[SF_LANE_STATES];
    sf_sample near[SF_LANE_STATES];
} sf_lane_design;

typedef struct {
    sf_lane_design at[SF_STATE_BLOCK];
    sf_state_cells cells[2];
    sf_state_zeros zeros[2];
} sf_state_block;

static inline void sf_probe_row(double (*rows)[SF_STATE_CELLS], int i, double A, const double *averages) {
    rows[0][i] = A, rows[1][i] = averages[0], rows[2][i] = averages[1], rows[3][i] = averages[2], rows[4][i] = averages[3];
}

/* Rows of the places `which` into those from k on. */
static inline void sf_take_rows(const double (*from)[SF_STATE_CELLS], int rows, const int *which, int n,
                                double (*to)[SF_STATE_CELLS], int k) {
    int row, j;
    for (row = 0; row < rows; row++)
        for (j = 0; j < n; j++)
            to[row][k + j] = from[row][which[j]];
}

/* A cell of design d between two samples. */
static inline void sf_add_cell(sf_state_block *block, int d, double base, const sf_sample *low, const sf_sample *high) {
    sf_state_cells *cells = &block->cells[0];
    const int i = cells->n++;
    int row;
    sf_probe_row(cells->low, i, low->A, low->averages);
    sf_probe_row(cells->high, i, high->A, high->averages);
    for (row = 0; row < SF_ASKED_ROWS; row++)
        cells->asked[row][i] = block->at[d].asked[row];
    cells->base[i] = base, cells->of[i] = d;
}

static inline void sf_average_at(const sf_model *model, double A, sf_sample *at) {
    at->A = A;
    model->mechanism->averaged(1, &at->A, model->p, at->averages);
}

/* The cells with which the search for the states of design d begins, one for each piece of the force; 0 where it is left to
 * states.h, see sf_clear_states. given: its design and damping */
static int sf_begin_states(sf_state_block *block, int d, const sf_numbers *given) {
    sf_lane_design *of = &block->at[d];
    sf_model *model = &of->model;
    const sf_mechanism *mechanism = model->mechanism;
    sf_sample low, high;
    double A_max;
    int i, pieces = 0;
    of->n = 0;
    if (!(model->zeta > 0) || sf_nearly_sticks(model, of->F_0))
        return 0;
    A_max = slow_flow_limit_envelope(of->Omega, of->F_0 * (1 + SF_CLOSE), model->m, model->zeta) * (1 + SF_CLOSE);
    if (!(A_max > SF_FIRST && A_max < SF_ENDLESS) || !sf_prepare(mechanism, NULL, model) || model->breaks < mechanism->breakpoints)
        return 0;
    while (pieces < model->breaks && model->b[pieces] < A_max)
        pieces++;
    if (pieces > 0 && !sf_prepare(mechanism, given->design, model))
        return 0;
    of->asked[0] = of->Omega * of->Omega, of->asked[1] = 2 * model->zeta * of->Omega, of->asked[2] = model->m, of->asked[3] = of->F_0;
    sf_average_at(model, 0, &low);
    if (block->cells[0].n + pieces + 1 > SF_STATE_CELLS || low.h != 0)
        return 0;
    for (i = 0; i <= pieces; i++) {
        sf_average_at(model, i < pieces ? model->b[i] : A_max, &high);
        sf_add_cell(block, d, i > 0 ? model->b[i - 1] : 0, &low, &high);
        if (i < pieces) {
            low = high;
            sf_tend_from_above(model, i, &low);
        }
    }
    return 1;
}

static inline void sf_average_row(const sf_state_block *block, int d, double A, double (*rows)[SF_STATE_CELLS], int k) {
    const sf_model *model = &block->at[d].model;
    double averages[4];
    model->mechanism->averaged(1, &A, model->p, averages);
    sf_probe_row(rows, k, A, averages);
}

/* The cells that stay open as two each of the next round, the lower ones first. */
static void sf_cut_cells(sf_state_block *block, const sf_state_cells *cells, const int *which, int n, sf_state_cells *next) {
    int j, row, end;
    next->n = 2 * n;
    sf_take_rows(cells->low, SF_PROBE_ROWS, which, n, next->low, 0);
    sf_take_rows(cells->high, SF_PROBE_ROWS, which, n, next->high, n);
    for (j = 0; j < n; j++) {
        const int i = which[j];
        sf_average_row(block, cells->of[i], cells->cut[i], next->high, j);
        block->at[cells->of[i]].ok &= cells->cut[i] > cells->low[0][i] && cells->cut[i] < cells->high[0][i];
    }
    for (row = 0; row < SF_PROBE_ROWS; row++)
        memcpy(&next->low[row][n], next->high[row], (size_t)n * sizeof(double));
    for (end = 0; end < 2 * n; end += n) {
        sf_take_rows(cells->asked, SF_ASKED_ROWS, which, n, next->asked, end);
        for (j = 0; j < n; j++)
            next->base[end + j] = cells->base[which[j]], next->of[end + j] = cells->of[which[j]];
    }
}

/* Cells with a zero as brackets. */
static void sf_add_brackets(sf_state_block *block, const sf_state_cells *cells, const int *which, int n) {
    sf_state_zeros *zeros = &block->zeros[0];
    int j;
    sf_take_rows(cells->asked, SF_ASKED_ROWS, which, n, zeros->asked, zeros->n);
    for (j = 0; j < n; j++) {
        const int i = which[j], k = zeros->n + j;
        zeros->of[k] = cells->of[i];
        zeros->lo[k] = cells->low[0][i], zeros->hi[k] = cells->high[0][i], zeros->rises[k] = cells->rises[i];
        sf_average_row(block, cells->of[i], cells->cut[i], zeros->at, k);
    }
    zeros->n += n;
}

/* Leaves what is in these places to states.h. */
static inline void sf_leave(sf_state_block *block, const int *of, const int *which, int n) {
    int j;
    for (j = 0; j < n; j++)
        block->at[of[which[j]]].ok = 0;
}

/* All cells of a block, until none is open. */
static void sf_search_block(sf_state_block *block) {
    int open[SF_STATE_CELLS], with_one[SF_STATE_CELLS], doubtful[SF_STATE_CELLS], round, i;
    block->zeros[0].n = 0;
    for (round = 0; block->cells[round % 2].n > 0; round++) {
        sf_state_cells *cells = &block->cells[round % 2], *next = &block->cells[1 - round % 2];
        int n_open = 0, n_one = 0, n_doubtful = 0;
        sf_judge_lanes(cells);
        for (i = 0; i < cells->n; i++) { /* without a branch that nothing foretells */
            const int verdict = (int)cells->verdict[i];
            open[n_open] = with_one[n_one] = doubtful[n_doubtful] = i;
            n_open += verdict == SF_IS_OPEN, n_one += verdict == SF_HAS_ONE, n_doubtful += verdict == SF_IS_DOUBTFUL;
        }
        sf_leave(block, cells->of, doubtful, n_doubtful);
        if (round == SF_STATE_ROUNDS || 2 * n_open > SF_STATE_CELLS) {
            sf_leave(block, cells->of, open, n_open);
            n_open = 0;
        }
        if (block->zeros[0].n + n_one > SF_STATE_CELLS) {
            sf_leave(block, cells->of, with_one, n_one);
            n_one = 0;
        }
        sf_add_brackets(block, cells, with_one, n_one);
        sf_cut_cells(block, cells, open, n_open, next);
    }
}

/* A zero into its place among those of its design, by rising A. */
static void sf_add_lane_state(sf_lane_design *of, const sf_state_zeros *zeros, int k) {
    const double A = zeros->next[k];
    int i;
    if (of->n == SF_LANE_STATES) {
        of->ok = 0;
        return;
    }
    for (i = of->n++; i > 0 && of->A[i - 1] > A; i--)
        of->A[i] = of->A[i - 1], of->lo[i] = of->lo[i - 1], of->hi[i] = of->hi[i - 1], of->rises[i] = of->rises[i - 1],
        of->near[i] = of->near[i - 1];
    of->A[i] = A, of->lo[i] = zeros->lo[k], of->hi[i] = zeros->hi[k], of->rises[i] = zeros->rises[k] != 0;
    of->near[i].h_AA = zeros->at[3][k], of->near[i].h_AAA = zeros->at[4][k];
}

/* All brackets of a block, until all are next to their zeros. */
static void sf_approach_block(sf_state_block *block) {
    int far[SF_STATE_CELLS], near[SF_STATE_CELLS], round, i, j;
    for (round = 0; block->zeros[round % 2].n > 0; round++) {
        sf_state_zeros *zeros = &block->zeros[round % 2], *next = &block->zeros[1 - round % 2];
        int n_far = 0, n_near = 0;
        sf_approach_lanes(zeros);
        for (i = 0; i < zeros->n; i++) {
            const int is_near = zeros->moved[i] <= SF_LAST_APPROACH * zeros->next[i];
            far[n_far] = near[n_near] = i;
            n_far += !is_near, n_near += is_near;
        }
        for (j = 0; j < n_near; j++)
            sf_add_lane_state(&block->at[zeros->of[near[j]]], zeros, near[j]);
        if (round == SF_STATE_APPROACHES) {
            sf_leave(block, zeros->of, far, n_far);
            n_far = 0;
        }
        next->n = n_far;
        sf_take_rows(zeros->asked, SF_ASKED_ROWS, far, n_far, next->asked, 0);
        for (j = 0; j < n_far; j++) {
            i = far[j];
            next->of[j] = zeros->of[i], next->lo[j] = zeros->lo[i], next->hi[j] = zeros->hi[i], next->rises[j] = zeros->rises[i];
            sf_average_row(block, zeros->of[i], zeros->next[i], next->at, j);
        }
    }
}

/* The states of a design that the block has found, each to its last digit; 0 where one does not settle. */
static int sf_settle_block_states(const sf_lane_design *of, const sf_exactly *exactly, double *A) {
    int i;
    for (i = 0; i < of->n; i++) {
        sf_settling at = {sfp_point(of->Omega), sfp_point(of->A[i]), sfp_point(of->F_0)};
        if (!sf_settle_near(slow_flow_pairs_state_step, SF_MOVES_A, 2, exactly, &of->model, &of->near[i], &at) ||
            !(at.A.high >= of->lo[i] && at.A.high <= of->hi[i]) || (i > 0 && !(at.A.high > A[i - 1])))
            return 0;
        A[i] = at.A.high;
    }
    return 1;
}

#endif
