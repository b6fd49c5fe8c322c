/* Designs that go through a search together: what many_states.h, many_peaks.h, many_folds.h and many_onsets.h share.
 *
 * Cells of all designs of a block are judged at once, and all zeros are approached at once (design_lanes.h). Cells that
 * stay open are cut, those of all designs at once. A design that is undecided anywhere is left to the solvers of one.
 */
#pragma once

#include "design_lanes.h"
#include "many.h"

enum {
    SF_LANE_BLOCK = 128,     /* designs that go together */
    SF_LANE_ROUNDS = 12,     /* of cuts */
    SF_LANE_APPROACHES = 16, /* of zeros: some folds take more than 8, and by themselves much longer */
    SF_LANE_ZEROS = 8        /* of one design */
};

/* the last step of a question whose errors fall by cubes */
#define SF_LAST_BY_CUBES 0x1p-17

/* Designs of a block in pairs, their parameters made at once: vectorised loops take a fraction of the time. */
typedef struct {
    double number[SF_MOST_DESIGN * SF_LANE_BLOCK], part[2 * (SF_MOST_PARAMETERS + SF_MOST_BREAKS) * SF_LANE_BLOCK];
} sf_exact_block;

/* What the force of a model, which is member d, loses at its breakpoints: as a difference of parameters in doubles it
 * may be all rounding. 0 where there are fewer breakpoints, or doubles have not half of the digits that pairs have,
 * whose sign then is certain. */
static inline int sf_take_jumps(const sf_exact_block *block, ptrdiff_t d, sf_model *model) {
    const sf_mechanism *mechanism = model->mechanism;
    for (int i = 0; i < model->breaks; i++) {
        const double lost = block->part[2 * (mechanism->parameters + i) * SF_LANE_BLOCK + d];
        if (!(fabs(model->jump[i] - lost) <= SF_HARDLY * fabs(lost)))
            return 0;
        model->jump[i] = lost;
    }
    return model->breaks == mechanism->breakpoints;
}

/* Member d of the block, which is design k, with its damping and, where they were lost, digits of its parameters; 0
 * if a number lies outside its domain. */
static int sf_take_member(const sf_call *at, const sf_exact_block *block, ptrdiff_t d, sf_model *model) {
    const sf_mechanism *mechanism = at->mechanism;
    sf_numbers inputs;
    sf_read_numbers_at(at, &inputs);
    if (!mechanism->parameters_of(mechanism, inputs.design, model->p) ||
        !mechanism->damping_of(inputs.damping, model->damping))
        return 0;
    sf_keep_digits(mechanism->parameters, block->part + d, 2 * SF_LANE_BLOCK, model->p);
    return 1;
}

/* The same with all else that a model has; 0 also where sf_prepare refuses it, or doubles have lost its jumps. */
static int sf_prepare_member(const sf_call *at, const sf_exact_block *block, int d, sf_model *model) {
    return sf_take_member(at, block, d, model) && sf_prepare(at->mechanism, NULL, model) &&
           sf_take_jumps(block, d, model);
}

/* Designs from k to `end` of a mechanism that has pairs. */
static void sf_make_exact_block(const sf_call *at, ptrdiff_t end, sf_exact_block *block) {
    const ptrdiff_t n = end - at->k;
    for (int i = 0; i < at->mechanism->design_size; i++)
        for (ptrdiff_t d = 0; d < n; d++)
            block->number[i * SF_LANE_BLOCK + d] =
                *(const double *)(const void *)(at->args[i] + (at->k + d) * at->steps[i]);
    at->mechanism->many_in_pairs(at->mechanism, n, SF_LANE_BLOCK, block->number, block->part);
}

/* Member d of the block, which is design k. */
static void sf_exactly_of(const sf_call *at, const sf_exact_block *block, int d, sf_exactly *exactly) {
    const sf_mechanism *mechanism = at->mechanism;
    const double *part = block->part + d;
    const double mu = sf_input(at, mechanism->design_size), zeta = sf_input(at, mechanism->design_size + 1);
    for (int i = 0; i < mechanism->parameters + mechanism->breakpoints; i++)
        exactly->p[i] = (sf_pair){part[2 * i * SF_LANE_BLOCK], part[(2 * i + 1) * SF_LANE_BLOCK]};
    sf_complete_exact(mechanism, mu, zeta, exactly);
}

/* A member of a block. A_max: of folds; task: its rows (design_lanes.h); ok: whether it is not left to the solvers of
 * one; what was found, by rising A: A, the bracket, whether F rises there, and what is known near by */
typedef struct {
    double F_0, Omega, A_max, task[SF_TASK_ROWS];
    sf_model model;
    int ok, n;
    unsigned char rises[SF_LANE_ZEROS];
    double A[SF_LANE_ZEROS], w[SF_LANE_ZEROS], lo[SF_LANE_ZEROS], hi[SF_LANE_ZEROS];
    sf_sample near[SF_LANE_ZEROS];
} sf_lane_design;

typedef struct {
    sf_lane_design at[SF_LANE_BLOCK];
    sf_lane_cells cells[2];
    sf_lane_zeros zeros[2];
} sf_lane_block;

/* What is known of a design at an amplitude. */
typedef sf_sample sf_lane_sample(const sf_model *model, double A);

/* A question about the designs of a block, which is or begins with a sf_lane_block.
 *
 * designs   -- how many go together
 * enter     -- whether design k begins the search as member d
 * judge, approach -- the loops of design_lanes.h over cells and over brackets
 * search    -- cells until none is open, where that is not sf_search_block; else NULL
 * kept      -- how many rows of a bracket the next round takes
 * last_step -- no smaller step to a zero, relatively, needs a further one before it is settled
 * leave     -- whether the answer of member d, which is design k, settles, and is written; others are answered singly
 */
typedef struct {
    size_t of_block;
    int designs;
    int (*enter)(const sf_call *, const sf_exact_block *, sf_lane_block *, int d);
    void (*judge)(sf_lane_cells *), (*approach)(sf_lane_zeros *), (*search)(sf_lane_block *);
    sf_lane_sample *sample;
    int kept;
    double last_step;
    int (*leave)(const sf_call *, const sf_exactly *, sf_lane_block *, int d, sf_query *);
} sf_lane_question;

static inline void sf_probe_row(double (*rows)[SF_LANE_CELLS], int i, const sf_sample *at) {
    rows[0][i] = at->A;
    for (int k = 1; k < SF_PROBE_ROWS; k++)
        rows[k][i] = at->averages[k - 1];
}

/* Rows of the places `which` into those from k on. */
static inline void sf_take_rows(const double (*from)[SF_LANE_CELLS], int rows, const int *which, int n,
                                double (*to)[SF_LANE_CELLS], int k) {
    for (int row = 0; row < rows; row++)
        for (int j = 0; j < n; j++)
            to[row][k + j] = from[row][which[j]];
}

/* A cell of design d between two samples. */
static inline void sf_add_cell(sf_lane_block *block, int d, double base, const sf_sample *low, const sf_sample *high) {
    sf_lane_cells *cells = &block->cells[0];
    const int i = cells->n++;
    sf_probe_row(cells->low, i, low);
    sf_probe_row(cells->high, i, high);
    for (int row = 0; row < SF_TASK_ROWS; row++)
        cells->task[row][i] = block->at[d].task[row];
    cells->base[i] = base, cells->of[i] = d;
}

/* For a question without k. */
static inline sf_sample sf_average_at(const sf_model *model, double A) {
    sf_sample at = {.A = A};
    model->mechanism->averaged(model->mechanism, 1, &at.A, model->p, at.averages);
    return at;
}

/* These take functions that are known where they are called, so that they are called without a pointer. */

SF_ALWAYS void sf_sample_row(sf_lane_sample *sample, const sf_lane_block *block, int d, double A,
                             double (*rows)[SF_LANE_CELLS], int k) {
    const sf_sample at = sample(&block->at[d].model, A);
    sf_probe_row(rows, k, &at);
}

/* The cells with which the search for design d begins, one for each piece of the force up to an amplitude; of the first
 * piece those that `first` makes, if it is not NULL, `more` at most. 0 where there are no places for them, or a
 * preload. */
SF_ALWAYS int sf_begin_pieces(sf_lane_sample *sample, sf_lane_block *block, int d, double A_max, int more,
                              void (*first)(sf_lane_block *, int, const sf_sample *, const sf_sample *)) {
    const sf_model *model = &block->at[d].model;
    int pieces = 0;
    while (pieces < model->breaks && model->b[pieces] < A_max)
        pieces++;
    sf_sample low = sample(model, 0);
    if (block->cells[0].n + pieces + more > SF_LANE_CELLS || low.h != 0)
        return 0;
    for (int i = 0; i <= pieces; i++) {
        const sf_sample high = sample(model, i < pieces ? model->b[i] : A_max);
        if (i == 0 && first != NULL)
            first(block, d, &low, &high);
        else
            sf_add_cell(block, d, i > 0 ? model->b[i - 1] : 0, &low, &high);
        if (i < pieces) {
            low = high;
            sf_tend_from_above(model, i, &low);
        }
    }
    return 1;
}

/* Cells with a zero as brackets. */
SF_ALWAYS void sf_add_brackets(sf_lane_sample *sample, sf_lane_block *block, const sf_lane_cells *cells,
                               const int *which, int n) {
    sf_lane_zeros *zeros = &block->zeros[0];
    sf_take_rows(cells->task, SF_TASK_ROWS, which, n, zeros->task, zeros->n);
    for (int j = 0; j < n; j++) {
        const int i = which[j], k = zeros->n + j;
        zeros->of[k] = cells->of[i];
        zeros->lo[k] = cells->low[0][i], zeros->hi[k] = cells->high[0][i], zeros->rises[k] = cells->rises[i];
        zeros->base[k] = cells->base[i], zeros->last[0][k] = zeros->last[1][k] = zeros->last[2][k] = NAN;
        sf_sample_row(sample, block, cells->of[i], cells->cut[i], zeros->at, k);
    }
    zeros->n += n;
}

/* Leaves what is in these places to the solvers of one. */
static inline void sf_leave(sf_lane_block *block, const int *of, const int *which, int n) {
    for (int j = 0; j < n; j++)
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
    of->near[i].A = zeros->at[0][k];
    for (int row = 1; row < SF_PROBE_ROWS; row++)
        of->near[i].averages[row - 1] = zeros->at[row][k];
}

/* The cells that stay open as two each of the next round, the lower ones first. */
SF_ALWAYS void sf_cut_cells(sf_lane_sample *sample, sf_lane_block *block, const sf_lane_cells *cells, const int *which,
                            int n, sf_lane_cells *next) {
    const int behind = 2 * SF_PROBE_ROWS; /* the rows of both ends */
    next->n = 2 * n;
    sf_take_rows(cells->low, SF_PROBE_ROWS, which, n, next->low, 0);
    sf_take_rows(cells->high, SF_PROBE_ROWS, which, n, next->high, n);
    for (int end = 0; end < 2 * n; end += n) {
        sf_take_rows(cells->inputs + behind, SF_INPUT_ROWS - behind, which, n, next->inputs + behind, end);
        for (int j = 0; j < n; j++)
            next->of[end + j] = cells->of[which[j]];
    }
    for (int j = 0; j < n; j++) {
        const int i = which[j];
        sf_sample_row(sample, block, cells->of[i], cells->cut[i], next->high, j);
        block->at[cells->of[i]].ok &= cells->cut[i] > cells->low[0][i] && cells->cut[i] < cells->high[0][i];
    }
    for (int row = 0; row < SF_PROBE_ROWS; row++)
        memcpy(&next->low[row][n], next->high[row], (size_t)n * sizeof(double));
}

/* All cells of a block, until none is open. */
SF_ALWAYS void sf_search_block(const sf_lane_question *question, sf_lane_block *block) {
    int open[SF_LANE_CELLS], with_one[SF_LANE_CELLS], undecided[SF_LANE_CELLS];
    block->zeros[0].n = 0;
    for (int round = 0; block->cells[round % 2].n > 0; round++) {
        sf_lane_cells *cells = &block->cells[round % 2], *next = &block->cells[1 - round % 2];
        int n_open = 0, n_one = 0, n_undecided = 0;
        question->judge(cells);
        for (int i = 0; i < cells->n; i++) { /* without a branch that nothing foretells */
            const int verdict = (int)cells->verdict[i];
            open[n_open] = with_one[n_one] = undecided[n_undecided] = i;
            n_open += verdict == SF_IS_OPEN, n_one += verdict == SF_HAS_ONE, n_undecided += verdict == SF_IS_UNDECIDED;
        }
        sf_leave(block, cells->of, undecided, n_undecided);
        if (round == SF_LANE_ROUNDS || 2 * n_open > SF_LANE_CELLS) {
            sf_leave(block, cells->of, open, n_open);
            n_open = 0;
        }
        if (block->zeros[0].n + n_one > SF_LANE_CELLS) {
            sf_leave(block, cells->of, with_one, n_one);
            n_one = 0;
        }
        sf_add_brackets(question->sample, block, cells, with_one, n_one);
        sf_cut_cells(question->sample, block, cells, open, n_open, next);
    }
}

/* All brackets of a block, until all are next to their zeros. */
SF_ALWAYS void sf_approach_block(const sf_lane_question *question, sf_lane_block *block) {
    int far[SF_LANE_CELLS], near[SF_LANE_CELLS], i;
    for (int round = 0; block->zeros[round % 2].n > 0; round++) {
        sf_lane_zeros *zeros = &block->zeros[round % 2], *next = &block->zeros[1 - round % 2];
        int n_far = 0, n_near = 0;
        question->approach(zeros);
        for (i = 0; i < zeros->n; i++) {
            const int is_near = zeros->change[i] <= question->last_step * zeros->next[i];
            far[n_far] = near[n_near] = i;
            n_far += !is_near, n_near += is_near;
        }
        for (int j = 0; j < n_near; j++)
            sf_add_lane_zero(&block->at[zeros->of[near[j]]], zeros, near[j]);
        if (round == SF_LANE_APPROACHES) {
            sf_leave(block, zeros->of, far, n_far);
            n_far = 0;
        }
        next->n = n_far;
        sf_take_rows(zeros->inputs + SF_PROBE_ROWS, question->kept, far, n_far, next->inputs + SF_PROBE_ROWS, 0);
        for (int j = 0; j < n_far; j++) {
            i = far[j], next->of[j] = zeros->of[i];
            sf_sample_row(question->sample, block, zeros->of[i], zeros->next[i], next->at, j);
        }
    }
}

/* Whether designs of a mechanism may go together: what is known of h on a cell, and in pairs. */
static int sf_goes_in_lanes(const sf_mechanism *mechanism) {
    return mechanism->bent == NULL && mechanism->averaged_in_pairs != NULL && !mechanism->inertial &&
           !sf_takes_laws(mechanism);
}

SF_ALWAYS void sf_loop_in_lanes(sf_call *at, const sf_lane_question *by) {
    sf_query q = {.room = malloc(sizeof(sf_room))};
    sf_lane_block *block = q.room != NULL && sf_goes_in_lanes(at->mechanism) ? malloc(by->of_block) : NULL;
    sf_exact_block exact;
    sf_exactly exactly;
    ptrdiff_t end;
    int d;
    for (ptrdiff_t first = 0; first < at->dimensions[0]; first = end) {
        at->k = first, end = sf_end_of_block(at, by->designs);
        if (block != NULL) {
            sf_make_exact_block(at, end, &exact);
            block->cells[0].n = 0;
            for (d = 0; at->k < end; at->k++, d++)
                block->at[d].ok = by->enter(at, &exact, block, d);
            if (by->search != NULL)
                by->search(block);
            else
                sf_search_block(by, block);
            sf_approach_block(by, block);
        }
        for (at->k = first, d = 0; at->k < end; at->k++, d++) {
            int is_left = block != NULL && block->at[d].ok;
            if (is_left) {
                sf_exactly_of(at, &exact, d, &exactly);
                is_left = by->leave(at, &exactly, block, d, &q);
            }
            if (!is_left)
                sf_answer_singly(at, &q);
        }
    }
    free(block);
    free(q.room);
}

/* Whether design k, as member d, may have its answer at a forcing from lanes: its damping is viscous too, and it
 * neither sticks nor all but sticks. */
static int sf_enter_at_forcing(const sf_call *at, const sf_exact_block *exact, sf_lane_design *of, int d) {
    of->F_0 = sf_number(at, 0), of->Omega = 0, of->n = 0;
    if (!at->mechanism->is_forcing(of->F_0) || !sf_prepare_member(at, exact, d, &of->model) || !(of->model.zeta > 0) ||
        sf_sticks(&of->model, of->F_0) || sf_nearly_sticks(&of->model, of->F_0))
        return 0;
    of->task[0] = 0, of->task[1] = of->model.zeta, of->task[2] = of->model.m, of->task[3] = of->F_0;
    return 1;
}
