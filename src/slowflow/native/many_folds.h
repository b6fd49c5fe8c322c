/* Folds of batches of designs. Takes designs; returns their folds, by blocks that go through the search together.
 *
 * Each fold is settled to its last digit as a single one is, so that it is the same double. A design at which rounding
 * may decide anything, or that is not settled by so many rounds, is left to resolve.h.
 */
#pragma once

#include "many_lanes.h"

/* designs that go together: they begin with more cells than states do */
enum { SF_FOLD_BLOCK = 64 };

/* of folds: Omega is off by squares of the last step */
#define SF_LAST_BY_SQUARES 0x1p-26
/* which way a sweep leaves a fold is decided where F_AA is no less than this share of its terms */
#define SF_TELLS_WAY 0x1p-16

/* A Omega^2 over F_0 at folds that blocks settle: beyond, as next to a breakpoint, the slopes by which a fold is
 * settled, which are doubles, have lost too many digits for the last of them to be the same from wherever it begins */
#define SF_LEAST_INERTIA 0x1p-8
#define SF_MOST_INERTIA 0x1p10
#define SF_ON_BREAK 0x1p-44

/* The cells of a first piece: what lies below where folds begin, nearly a cube of A, next to that, and the rest. */
static void sf_begin_first_piece(sf_lane_block *block, int d, const sf_sample *rest, const sf_sample *end) {
    const sf_lane_design *of = &block->at[d];
    const double least = slow_flow_least_restoring(of->F_0, of->model.m);
    sf_sample low = *rest;
    double A = SF_BELOW_FOLDS * end->A * cbrt(least / fabs(end->k));
    for (int i = 0; i < 2 && A < end->A; i++, A *= SF_FIRST_FOLDS) {
        const sf_sample high = sf_sample_at(&of->model, A);
        sf_add_cell(block, d, 0, &low, &high);
        low = high;
    }
    sf_add_cell(block, d, 0, &low, end);
}

/* With the cells of all pieces up to the largest amplitude. */
static int sf_enter_folds(const sf_call *at, const sf_exact_block *exact, sf_lane_block *block, int d) {
    sf_lane_design *of = &block->at[d];
    const sf_model *model = &of->model;
    if (!sf_enter_at_forcing(at, exact, of, d))
        return 0;
    for (int i = 0; i < model->breaks; i++)
        if (model->jump[i] == 0)
            return 0;
    return !sf_is_linear(model) && sf_amplitude_bound(model, of->F_0, &of->A_max) == SF_OK &&
           sf_begin_pieces(sf_sample_at, block, d, of->A_max, 3, sf_begin_first_piece);
}

/* Whether the last digits of a fold are the same from wherever it begins. */
static int sf_is_plain_fold(const sf_lane_design *of, double Omega, double A) {
    const int piece = sf_piece_of(&of->model, A);
    const double inertia = A * Omega * Omega;
    return inertia >= SF_LEAST_INERTIA * of->F_0 && inertia <= SF_MOST_INERTIA * of->F_0 &&
           (piece == 0 || A - of->model.b[piece - 1] > SF_ON_BREAK * A);
}

/* A fold that the block has found, to its last digit; 0 where it does not settle. */
static int sf_settle_block_fold(const sf_lane_design *of, int i, const sf_exactly *exactly, sf_folds *folds) {
    const sf_model *model = &of->model;
    const sf_sample *near = &of->near[i];
    sf_settling at = {sfp_point(of->w[i]), sfp_point(of->A[i]), sfp_point(of->F_0)};
    const double bend = sf_half_F_AA(model, near, of->w[i]);
    sf_sample straight = *near;
    double Omega = of->w[i], A = of->A[i];
    straight.h_AA = 0;
    if (!sf_is_plain_fold(of, of->w[i], of->A[i]) ||
        !(fabs(bend) >= SF_TELLS_WAY * sf_half_F_AA(model, &straight, of->w[i])))
        return 0;
    if (sf_settle_near(slow_flow_pairs_fold_step, SF_VARY_BOTH, 2, exactly, model, near, &at))
        Omega = at.Omega.high, A = at.A.high;
    else if (sf_settle_fold(exactly, model, of->F_0, &Omega, &A) > 0)
        return 0;
    if (!(A >= of->lo[i] * (1 - SF_CLOSE) && A <= of->hi[i] * (1 + SF_CLOSE)))
        return 0;
    sf_add_fold(folds, Omega, A, bend < 0, 0);
    return 1;
}

static int sf_leave_folds(const sf_call *at, const sf_exactly *exactly, sf_lane_block *block, int d, sf_query *q) {
    const sf_lane_design *of = &block->at[d];
    const sf_model *model = &of->model;
    sf_work *work = &q->room->work;
    sf_folds folds;
    folds.n = folds.undecided = folds.close = 0, folds.status = SF_OK;
    work->A_max = of->A_max;
    sf_corner_folds(model, of->F_0, work, &folds);
    if (sf_are_corners_close(model, NULL, of->F_0, work))
        return 0;
    sf_settle_folds(exactly, model, of->F_0, &folds);
    for (int i = 0; i < of->n; i++)
        if (!sf_settle_block_fold(of, i, exactly, &folds))
            return 0;
    for (int i = 1; i < folds.n; i++)
        if (folds.at[i].Omega == folds.at[i - 1].Omega)
            return 0;
    if (folds.status != SF_OK || sf_is_sharp(&folds, of->F_0))
        return 0;
    sf_put(q, SF_INTEGER, SF_OK), sf_put_folds(q, SF_OK, &folds, 0);
    sf_write_answer(at, q);
    return 1;
}

static void sf_loop_folds(sf_call *at) {
    static const sf_lane_question folds = {sizeof(sf_lane_block), SF_FOLD_BLOCK, sf_enter_folds, sf_judge_folds,
                                           sf_approach_folds,     NULL,          sf_sample_at,   SF_REMEMBERED_ROWS,
                                           SF_LAST_BY_SQUARES,    sf_leave_folds};
    sf_loop_in_lanes(at, &folds);
}
