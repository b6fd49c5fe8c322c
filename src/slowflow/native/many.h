/* Batches of designs. Takes a record and strided arrays; returns strided arrays.
 *
 * The inputs are the design, the damping, and where needed F_0 and other numbers.
 */
#pragma once

#include "questions.h"

/* ==== Inputs ====================================================================================================== */

/* A design's numbers, and its damping. */
typedef struct {
    double design[SF_MOST_DESIGN], damping[SF_MOST_DAMPING];
} sf_numbers;

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

/* Design k as the solvers take it; 0 if a number lies outside its domain, or sf_prepare refuses it, or
 * with other laws of damping it has no answer.
 * jumps: whether the query needs what the force loses at its breakpoints, which takes longer than some answers. */
static int sf_design_at(const sf_call *at, int jumps, sf_numbers *inputs, sf_model *model) {
    sf_read_numbers_at(at, inputs);
    return sf_take_design(at->mechanism, inputs->design, model->p) &&
           at->mechanism->damping_of(inputs->damping, model->damping) &&
           sf_prepare(at->mechanism, jumps ? inputs->design : NULL, model) &&
           (!model->by_laws || sf_allows_laws(model));
}

/* A design in pairs, NULL where there is no such form. */
static const sf_exactly *sf_exactly_in(const sf_numbers *inputs, const sf_mechanism *mechanism, sf_exactly *exactly) {
    return sf_make_exact(mechanism, inputs->design, inputs->damping[0], inputs->damping[1], exactly) ? exactly : NULL;
}

/* ==== Answers ===================================================================================================== */

static char *sf_output(const sf_call *at, int i) { return at->args[at->out + i] + at->k * at->steps[at->out + i]; }

static void sf_write_number(const sf_call *at, int i, double value) { *(double *)(void *)sf_output(at, i) = value; }

/* up_corner: whether a sweep leaves the fold upwards, and whether it is on a corner */
static sf_fold_kind sf_kind_of(const int *up_corner) {
    if (up_corner[1])
        return up_corner[0] ? SF_JUMP_UP_AT_CORNER : SF_JUMP_DOWN_AT_CORNER;
    return up_corner[0] ? SF_JUMP_UP : SF_JUMP_DOWN;
}

/* A column's first n values into the places of an output, and nothing into those behind it. */
static void sf_write_places(const sf_item *of, long n, char type, ptrdiff_t max_count, char *to, ptrdiff_t step) {
    const ptrdiff_t apart = of->step;
    const char *from = of->first;
    ptrdiff_t i;
    if (type == 'D') {
        for (i = 0; i < n; i++, from += apart, to += step)
            *(double *)(void *)to = *(const double *)(const void *)from;
        for (; i < max_count; i++, to += step)
            *(double *)(void *)to = NAN;
    } else if (type == 'H') {
        for (i = 0; i < n; i++, from += apart, to += step)
            *(short *)(void *)to = (short)*(const long long *)(const void *)from;
        for (; i < max_count; i++, to += step)
            *(short *)(void *)to = -1;
    } else {
        for (i = 0; i < n; i++, from += apart, to += step)
            *to = type == 'K' ? (char)sf_kind_of((const int *)(const void *)from) : *from;
        for (; i < max_count; i++, to += step)
            *to = SF_EMPTY;
    }
}

/* The items of an answer into the outputs for design k, nothing but the status where there is no other item; the query
 * is free for the next one. A curve that has more points than there are places is not drawn; of others the first have
 * theirs. */
static void sf_write_answer(const sf_call *at, sf_query *q) {
    static const sf_item none = {SF_NUMBER, NAN, 0, NULL, 0};
    const sf_item *of = q->items > 1 ? q->item + 1 : &none;
    const int step = q->items > 1;
    const ptrdiff_t k = at->k, *steps = at->steps + at->out, *inner = at->inner, *max_count = at->dimensions + 1;
    const char *type = at->row->types;
    char *const *to = at->args + at->out;
    sf_status status = (sf_status)q->item[0].value;
    long taken = 0;
    if (status == SF_TOO_MANY) /* a search that ran out of room; below, an answer that has no place */
        status = SF_UNRESOLVED;
    for (; type[1] != 0; type++, to++, steps++) {
        char *here = *to + k * *steps;
        if (*type == 'n' || *type == 'i') {
            if (*type == 'n')
                *here = (char)taken;
            else
                *(int *)(void *)here = (int)taken;
            if (status == SF_OK && taken > *max_count)
                status = SF_TOO_MANY;
            max_count++;
            continue;
        }
        if (*type < 'a') {
            const int is_curve = type[strcspn(type, "ni")] == 'i';
            taken = of->n;
            sf_write_places(of,
                            taken <= *max_count ? taken
                            : is_curve          ? 0
                                                : (long)*max_count,
                            *type, *max_count, here, *inner++);
        } else if (*type == 'd')
            *(double *)(void *)here = of->value;
        else
            *here = (char)(step ? of->value : 0);
        of += *type == 'K' ? 2 * step : step;
    }
    *(*to + k * *steps) = (char)status;
    for (q->items = 0; q->reserved > 0;)
        free(q->reserve[--q->reserved]);
}

/* The query of design k by itself; 0 where it is none, or F_0 no forcing. Numbers that a batch does not take are
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
        sf_put(q, SF_INTEGER, q->room == NULL || q->reserved > 0 ? SF_NO_MEMORY : SF_INVALID);
    sf_write_answer(at, q);
}

/* Designs one after the other. */
static void sf_loop_singly(sf_call *at) {
    sf_query q = {.room = malloc(sizeof(sf_room))};
    for (at->k = 0; at->k < at->dimensions[0]; at->k++)
        sf_answer_singly(at, &q);
    free(q.room);
}

/* Where a block of so many designs ends that begins at design k. */
static ptrdiff_t sf_end_of_block(const sf_call *at, ptrdiff_t size) {
    return at->k + size < at->dimensions[0] ? at->k + size : at->dimensions[0];
}
