/* Batches of designs. Takes a record and strided arrays; returns strided arrays.
 *
 * The inputs are the design, the damping, and where needed F_0. Nothing is allocated per design.
 */
#pragma once

#include "many_detachment.h"
#include "many_folds.h"
#include "many_onsets.h"
#include "many_peaks.h"
#include "many_states.h"
#include "questions.h"

/* ==== Inputs ====================================================================================================== */

static double sf_input(const sf_call *at, int i) {
    return *(const double *)(const void *)(at->args[i] + at->k * at->steps[i]);
}

/* Number i behind the design and the damping. */
static double sf_number(const sf_call *at, int i) { return sf_input(at, at->out - at->row->at + i); }

static void sf_read_numbers_at(const sf_call *at, sf_numbers *out) {
    const sf_mechanism *mechanism = at->mechanism;
    for (int i = 0; i < mechanism->design_size; i++)
        out->design[i] = sf_input(at, i);
    for (int i = 0; i < mechanism->damping_size; i++)
        out->damping[i] = sf_input(at, mechanism->design_size + i);
}

/* What follows from the numbers of a design; 0 if one lies outside its domain. */
static int sf_take_numbers(const sf_mechanism *mechanism, const sf_numbers *inputs, sf_model *model) {
    return mechanism->parameters_of(mechanism, inputs->design, model->p) &&
           mechanism->damping_of(inputs->damping, model->damping);
}

/* Design k as the solvers take it; 0 if a number lies outside its domain, or sf_prepare refuses it, or
 * with other laws of damping it has no answer.
 * jumps: whether it is asked what the force loses at its breakpoints, which takes longer than some answers. */
static int sf_design_at(const sf_call *at, int jumps, sf_numbers *inputs, sf_model *model) {
    sf_read_numbers_at(at, inputs);
    return sf_take_numbers(at->mechanism, inputs, model) &&
           sf_prepare(at->mechanism, jumps ? inputs->design : NULL, model) &&
           (!sf_has_laws(model) || sf_allows_laws(model));
}

/* A design in pairs, NULL where there is no such form. */
static const sf_exactly *sf_exactly_in(const sf_numbers *inputs, const sf_mechanism *mechanism, sf_exactly *exactly) {
    return sf_make_exact(mechanism, inputs->design, inputs->damping[0], inputs->damping[1], exactly) ? exactly : NULL;
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

/* ==== Answers ===================================================================================================== */

/* How one design's search fared: SF_TOO_MANY is what has no place in an answer, and no search that ran out of room. */
static sf_status sf_of_search(sf_status status) { return status == SF_TOO_MANY ? SF_UNRESOLVED : status; }

static char *sf_output(const sf_call *at, int i) { return at->args[at->out + i] + at->k * at->steps[at->out + i]; }

static void sf_write_number(const sf_call *at, int i, double value) { *(double *)(void *)sf_output(at, i) = value; }

/* up_corner: whether a sweep leaves the fold upwards, and whether it is on a corner */
static sf_fold_kind sf_kind_of(const int *up_corner) {
    if (up_corner[1])
        return up_corner[0] ? SF_JUMP_UP_AT_CORNER : SF_JUMP_DOWN_AT_CORNER;
    return up_corner[0] ? SF_JUMP_UP : SF_JUMP_DOWN;
}

/* A column into the places of an output, and nothing into those behind it. */
static void sf_write_places(const sf_item *of, char type, ptrdiff_t max_count, char *to, ptrdiff_t step) {
    const ptrdiff_t apart = of->step, n = of->n < max_count ? of->n : max_count;
    const char *from = of->first;
    ptrdiff_t i;
    if (type == 'D') {
        for (i = 0; i < n; i++, from += apart, to += step)
            *(double *)(void *)to = *(const double *)(const void *)from;
        for (; i < max_count; i++, to += step)
            *(double *)(void *)to = NAN;
    } else {
        for (i = 0; i < n; i++, from += apart, to += step)
            *to = type == 'K' ? (char)sf_kind_of((const int *)(const void *)from) : *from;
        for (; i < max_count; i++, to += step)
            *to = SF_EMPTY;
    }
}

/* The items of an answer into the outputs for design k, nothing but the status where there is no other item; the query
 * is free for the next one. */
static void sf_write_answer(const sf_call *at, sf_query *q) {
    static const sf_item none = {SF_NUMBER, NAN, 0, NULL, 0};
    const sf_item *of = q->items > 1 ? q->item + 1 : &none;
    const int step = q->items > 1;
    const ptrdiff_t k = at->k, *steps = at->steps + at->out, *inner = at->inner;
    const char *type = at->row->types;
    char *const *to = at->args + at->out;
    sf_status status = sf_of_search((sf_status)q->item[0].value);
    long taken = 0;
    for (; type[1] != 0; type++, to++, steps++) {
        char *here = *to + k * *steps;
        if (*type == 'n') {
            *here = (char)taken;
            continue;
        }
        if (*type < 'a')
            sf_write_places(of, *type, at->dimensions[1], here, *inner++), taken = of->n;
        else if (*type == 'd')
            *(double *)(void *)here = of->value;
        else
            *here = (char)(step ? of->value : 0);
        of += *type == 'K' ? 2 * step : step;
    }
    if (status == SF_OK && taken > 0 && taken > at->dimensions[1])
        status = SF_TOO_MANY;
    *(*to + k * *steps) = (char)status;
    for (q->items = 0; q->reserved > 0;)
        free(q->reserve[--q->reserved]);
}

/* What design k is asked, by itself; 0 where it is none, or F_0 no forcing. Numbers that a batch does not take are
 * infinite. */
static int sf_prepare_query(const sf_call *at, sf_model *model, sf_inputs *inputs, sf_query *q) {
    sf_numbers numbers;
    for (int i = 0; i < SF_MOST_NUMBERS; i++)
        q->number[i] = i < at->row->at ? sf_number(at, i) : HUGE_VAL;
    if ((at->row->at > 0 && !at->mechanism->is_forcing(q->number[0])) || !sf_design_at(at, 1, &numbers, model))
        return 0;
    q->model = model;
    q->inputs = NULL;
    if (at->row->of_given && sf_give(at->mechanism, numbers.design, numbers.damping[0], numbers.damping[1], inputs))
        q->inputs = inputs;
    q->exactly = q->inputs != NULL ? &inputs->exactly : sf_exactly_in(&numbers, at->mechanism, &inputs->exactly);
    return 1;
}

/* The answer for design k by itself. */
static void sf_answer_singly(const sf_call *at, sf_query *q) {
    sf_model model;
    sf_inputs inputs;
    if (q->room != NULL && sf_prepare_query(at, &model, &inputs, q))
        at->row->answer(q);
    if (q->items == 0)
        sf_put(q, SF_INTEGER, q->room == NULL ? SF_NO_MEMORY : SF_INVALID);
    sf_write_answer(at, q);
}

/* Designs one after the other. */
static void sf_loop_singly(sf_call *at) {
    sf_query q = {.room = malloc(sizeof(sf_room))};
    for (at->k = 0; at->k < at->dimensions[0]; at->k++)
        sf_answer_singly(at, &q);
    free(q.room);
}

/* ==== Blocks ====================================================================================================== */

/* Where a block of so many designs ends that begins at design k. */
static ptrdiff_t sf_end_of_block(const sf_call *at, ptrdiff_t size) {
    return at->k + size < at->dimensions[0] ? at->k + size : at->dimensions[0];
}

/* Without a query, which takes half as long as this answer. */
static void sf_write_detachment(const sf_call *at, double F_cr, double Omega_cr, double u_cr, sf_status status) {
    sf_write_number(at, 0, F_cr), sf_write_number(at, 1, Omega_cr), sf_write_number(at, 2, u_cr);
    *sf_output(at, 3) = (char)status;
}

/* Detachment of one design, by itself. */
static void sf_detach_singly(const sf_call *at) {
    double F_cr = NAN, Omega_cr = NAN, u_cr = NAN;
    sf_status status = SF_INVALID;
    sf_numbers inputs;
    sf_model model;
    sf_exactly exactly;
    if (sf_design_at(at, 0, &inputs, &model))
        status = sf_settled_detachment(&model, sf_exactly_in(&inputs, at->mechanism, &exactly), &F_cr, &Omega_cr,
                                       &u_cr);
    sf_write_detachment(at, F_cr, Omega_cr, u_cr, status);
}

/* Whether design k becomes a member of a block. */
static int sf_enter_detachment(const sf_call *at, sf_detaching *block) {
    sf_numbers inputs;
    sf_model model;
    sf_read_numbers_at(at, &inputs);
    return sf_take_numbers(at->mechanism, &inputs, &model) && sf_prepare(at->mechanism, NULL, &model) &&
           sf_begin_detachment(block, at->k, &inputs, &model);
}

static void sf_loop_detachment(sf_call *at) {
    const int together = sf_detach_together(at->mechanism);
    ptrdiff_t end;
    for (at->k = 0; at->k < at->dimensions[0]; at->k = end) {
        sf_detaching block;
        block.n = 0, end = sf_end_of_block(at, SF_DETACHING);
        for (; at->k < end; at->k++)
            if (!(together && sf_enter_detachment(at, &block)))
                sf_detach_singly(at);
        if (block.n > 0)
            sf_settle_detachments(at->mechanism, &block);
        for (int d = 0; d < block.n; d++) {
            at->k = block.k[d];
            if (isnan(block.change[d]))
                sf_detach_singly(at);
            else
                sf_write_detachment(at, block.F_0[d], block.Omega[d], block.u_cr[d], SF_OK);
        }
    }
}

/* ==== Designs in lanes ============================================================================================ */

/* Whether designs of a mechanism may go together: what is known of h on a cell, and in pairs. */
static int sf_goes_in_lanes(const sf_mechanism *mechanism) {
    return mechanism->bent == NULL && mechanism->averaged_in_pairs != NULL && !mechanism->inertial &&
           !sf_takes_laws(mechanism);
}

/* What a question is to the designs of a block, which is or begins with a sf_lane_block.
 *
 * enter  -- whether design k begins the search as member d
 * search -- from where they began to next to their zeros
 * leave  -- whether the answer of member d, which is design k, settles, and is written; others are asked singly
 */
typedef struct {
    size_t of_block;
    int designs;
    int (*enter)(const sf_call *, const sf_exact_block *, sf_lane_block *, int d);
    void (*search)(sf_lane_block *);
    int (*leave)(const sf_call *, const sf_exactly *, sf_lane_block *, int d, sf_query *);
} sf_lane_loop;

SF_ALWAYS void sf_loop_in_lanes(sf_call *at, const sf_lane_loop *by) {
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
            by->search(block);
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

static int sf_enter_onset(const sf_call *at, const sf_exact_block *exact, sf_lane_block *lanes, int d) {
    sf_onset_block *block = (sf_onset_block *)(void *)lanes;
    sf_model *model = &lanes->at[d].model;
    sf_numbers inputs;
    if (!sf_design_at(at, 0, &inputs, model) || !sf_take_jumps(exact, d, model))
        return 0;
    sf_end_pieces(model, &block->ends[d]);
    sf_begin_onset(model, &block->ends[d], &block->best[d]);
    return sf_begin_cusps(block, d);
}

static int sf_leave_onset(const sf_call *at, const sf_exactly *exactly, sf_lane_block *lanes, int d, sf_query *q) {
    sf_onset_block *block = (sf_onset_block *)(void *)lanes;
    const sf_lane_design *of = &lanes->at[d];
    sf_onset *found = &block->best[d];
    sf_consider_cusps(of, found);
    if (sf_end_onset(&of->model, &block->ends[d], 1, &q->room->work, found) != SF_OK ||
        !sf_settle_onset(&of->model, exactly, found))
        return 0;
    sf_put_onset(q, SF_OK, found, sf_is_rest_below(found));
    sf_write_answer(at, q);
    return 1;
}

static void sf_loop_onsets(sf_call *at) {
    static const sf_lane_loop by = {sizeof(sf_onset_block), SF_ONSET_BLOCK, sf_enter_onset, sf_search_cusps,
                                    sf_leave_onset};
    sf_loop_in_lanes(at, &by);
}

/* For peaks or folds. begin: with the first cells */
SF_ALWAYS int sf_enter_at_forcing(const sf_call *at, const sf_exact_block *exact, sf_lane_block *block, int d,
                                  int (*begin)(sf_lane_block *, int))
{
    sf_lane_design *of = &block->at[d];
    sf_numbers inputs;
    of->F_0 = sf_number(at, 0), of->Omega = 0;
    return at->mechanism->is_forcing(of->F_0) && sf_design_at(at, 0, &inputs, &of->model) &&
           sf_take_jumps(exact, d, &of->model) && begin(block, d);
}

static int sf_enter_peak(const sf_call *at, const sf_exact_block *exact, sf_lane_block *block, int d) {
    return sf_enter_at_forcing(at, exact, block, d, sf_begin_peak);
}

/* Without a query, which takes as long as some of this answer. */
static int sf_leave_peak(const sf_call *at, const sf_exactly *exactly, sf_lane_block *block, int d, sf_query *q) {
    double A, Omega;
    (void)q;
    if (!sf_settle_block_peak(&block->at[d], exactly, &A, &Omega))
        return 0;
    sf_write_number(at, 0, A), sf_write_number(at, 1, Omega);
    *sf_output(at, 2) = SF_OK;
    return 1;
}

static void sf_loop_peaks(sf_call *at) {
    static const sf_lane_loop by = {sizeof(sf_lane_block), SF_LANE_BLOCK, sf_enter_peak, sf_search_peaks,
                                    sf_leave_peak};
    sf_loop_in_lanes(at, &by);
}

static int sf_enter_folds(const sf_call *at, const sf_exact_block *exact, sf_lane_block *block, int d) {
    return sf_enter_at_forcing(at, exact, block, d, sf_begin_folds);
}

static int sf_leave_folds(const sf_call *at, const sf_exactly *exactly, sf_lane_block *block, int d, sf_query *q) {
    sf_folds found;
    if (!sf_settle_block_folds(&block->at[d], exactly, &q->room->work, &found))
        return 0;
    sf_put_folds(q, SF_OK, &found, 0);
    sf_write_answer(at, q);
    return 1;
}

static void sf_loop_folds(sf_call *at) {
    static const sf_lane_loop by = {sizeof(sf_lane_block), SF_FOLD_BLOCK, sf_enter_folds, sf_search_folds,
                                    sf_leave_folds};
    sf_loop_in_lanes(at, &by);
}

static int sf_enter_states(const sf_call *at, const sf_exact_block *exact, sf_lane_block *block, int d) {
    sf_lane_design *of = &block->at[d];
    sf_numbers inputs;
    of->F_0 = sf_number(at, 0), of->Omega = sf_number(at, 1), of->model.mechanism = at->mechanism;
    if (!(at->mechanism->is_forcing(of->F_0) && sf_has_states(of->Omega)))
        return 0;
    sf_read_numbers_at(at, &inputs);
    return sf_take_numbers(at->mechanism, &inputs, &of->model) && sf_begin_states(block, d, exact);
}

/* Without a query, as peaks. */
static int sf_leave_states(const sf_call *at, const sf_exactly *exactly, sf_lane_block *block, int d, sf_query *q) {
    const ptrdiff_t max_count = at->dimensions[1];
    const sf_lane_design *of = &block->at[d];
    double A[SF_LANE_ZEROS];
    const sf_item amplitudes = {SF_NUMBERS, 0, of->n, A, sizeof *A}, stable = {SF_BYTE_FLAGS, 0, of->n, of->rises, 1};
    (void)q;
    if (!sf_settle_block_states(of, exactly, A))
        return 0;
    sf_write_places(&amplitudes, 'D', max_count, sf_output(at, 0), at->inner[0]);
    sf_write_places(&stable, 'B', max_count, sf_output(at, 1), at->inner[1]);
    *sf_output(at, 2) = (char)of->n, *sf_output(at, 3) = 0;
    *sf_output(at, 4) = of->n > max_count ? SF_TOO_MANY : SF_OK;
    return 1;
}

static void sf_loop_states(sf_call *at) {
    static const sf_lane_loop by = {sizeof(sf_lane_block), SF_LANE_BLOCK, sf_enter_states, sf_search_states,
                                    sf_leave_states};
    sf_loop_in_lanes(at, &by);
}
