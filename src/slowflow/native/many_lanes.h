/* Designs that go through a search together: what the questions of many_states.h and many_peaks.h share.
 *
 * Cells of all designs of a block are judged at once, and all zeros are approached at once (design_lanes.h). A design
 * that is doubtful anywhere is left to the solvers of one.
 */
#ifndef SF_MANY_LANES_H
#define SF_MANY_LANES_H

#include "design_lanes.h"
#include "settle.h"

enum {
    SF_LANE_BLOCK = 128, /* designs that go together */
    SF_LANE_APPROACHES = 8,
    SF_LANE_ZEROS = 8 /* of one design */
};

/* no step to a zero needs a further one before it is settled if it is smaller, relatively: errors fall by cubes */
#define SF_LAST_APPROACH 0x1p-17

/* A design's numbers, and its damping. */
typedef struct {
    double design[SF_MOST_DESIGN], damping[SF_MOST_DAMPING];
} sf_numbers;

/* A member of a block. asked: its rows (design_lanes.h); ok: whether it is not left to the solvers of one; what was
 * found, by rising A: A, the bracket, whether F rises there, and what is known near by */
typedef struct {
    double F_0, Omega, asked[SF_ASKED_ROWS];
    sf_model model;
    int ok, n, rises[SF_LANE_ZEROS];
    double A[SF_LANE_ZEROS], w[SF_LANE_ZEROS], lo[SF_LANE_ZEROS], hi[SF_LANE_ZEROS];
    sf_sample near[SF_LANE_ZEROS];
} sf_lane_design;

typedef struct {
    sf_lane_design at[SF_LANE_BLOCK];
    sf_lane_cells cells[2];
    sf_lane_zeros zeros[2];
} sf_lane_block;

static inline void sf_probe_row(double (*rows)[SF_LANE_CELLS], int i, double A, const double *averages) {
    rows[0][i] = A, rows[1][i] = averages[0], rows[2][i] = averages[1], rows[3][i] = averages[2],
    rows[4][i] = averages[3];
}

/* Rows of the places `which` into those from k on. */
static inline void sf_take_rows(const double (*from)[SF_LANE_CELLS], int rows, const int *which, int n,
                                double (*to)[SF_LANE_CELLS], int k) {
    int row, j;
    for (row = 0; row < rows; row++)
        for (j = 0; j < n; j++)
            to[row][k + j] = from[row][which[j]];
}

/* A cell of design d between two samples. */
static inline void sf_add_cell(sf_lane_block *block, int d, double base, const sf_sample *low, const sf_sample *high) {
    sf_lane_cells *cells = &block->cells[0];
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

static inline void sf_average_row(const sf_lane_block *block, int d, double A, double (*rows)[SF_LANE_CELLS], int k) {
    const sf_model *model = &block->at[d].model;
    double averages[4];
    model->mechanism->averaged(1, &A, model->p, averages);
    sf_probe_row(rows, k, A, averages);
}

/* Cells with a zero as brackets. */
static void sf_add_brackets(sf_lane_block *block, const sf_lane_cells *cells, const int *which, int n) {
    sf_lane_zeros *zeros = &block->zeros[0];
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

/* Leaves what is in these places to the solvers of one. */
static inline void sf_leave(sf_lane_block *block, const int *of, const int *which, int n) {
    int j;
    for (j = 0; j < n; j++)
        block->at[of[which[j]]].ok = 0;
}

/* A zero into its place among those of its design, by rising A. */
static void sf_add_lane_zero(sf_lane_design *of, const sf_lane_zeros *zeros, int k) {
    const double A = zeros->next[k];
    int i;
    if (of->n == SF_LANE_ZEROS) {
        of->ok = 0;
        return;
    }
    for (i = of->n++; i > 0 && of->A[i - 1] > A; i--)
        of->A[i] = of->A[i - 1], of->w[i] = of->w[i - 1], of->lo[i] = of->lo[i - 1], of->hi[i] = of->hi[i - 1],
        of->rises[i] = of->rises[i - 1], of->near[i] = of->near[i - 1];
    of->A[i] = A, of->w[i] = zeros->Omega[k], of->lo[i] = zeros->lo[k], of->hi[i] = zeros->hi[k],
    of->rises[i] = zeros->rises[k] != 0;
    of->near[i].h_AA = zeros->at[3][k], of->near[i].h_AAA = zeros->at[4][k];
}

/* All brackets of a block, until all are next to their zeros. */
static void sf_approach_block(sf_lane_block *block, void (*approach)(sf_lane_zeros *)) {
    int far[SF_LANE_CELLS], near[SF_LANE_CELLS], round, i, j;
    for (round = 0; block->zeros[round % 2].n > 0; round++) {
        sf_lane_zeros *zeros = &block->zeros[round % 2], *next = &block->zeros[1 - round % 2];
        int n_far = 0, n_near = 0;
        approach(zeros);
        for (i = 0; i < zeros->n; i++) {
            const int is_near = zeros->moved[i] <= SF_LAST_APPROACH * zeros->next[i];
            far[n_far] = near[n_near] = i;
            n_far += !is_near, n_near += is_near;
        }
        for (j = 0; j < n_near; j++)
            sf_add_lane_zero(&block->at[zeros->of[near[j]]], zeros, near[j]);
        if (round == SF_LANE_APPROACHES) {
            sf_leave(block, zeros->of, far, n_far);
            n_far = 0;
        }
        next->n = n_far;
        sf_take_rows(zeros->asked, SF_ASKED_ROWS, far, n_far, next->asked, 0);
        for (j = 0; j < n_far; j++) {
            i = far[j];
            next->of[j] = zeros->of[i], next->lo[j] = zeros->lo[i], next->hi[j] = zeros->hi[i],
            next->rises[j] = zeros->rises[i];
            sf_average_row(block, zeros->of[i], zeros->next[i], next->at, j);
        }
    }
}

#endif
