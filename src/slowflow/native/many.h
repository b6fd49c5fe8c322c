/* Batches of designs. Takes a record and strided arrays; returns strided arrays.
 *
 * The loops have the form of NumPy's ufuncs: args[i] + k * steps[i] is argument i of design k, and `data` is the
 * record.
 * The inputs are the design, the damping, and where needed F_0. Nothing is allocated per design.
 */
#ifndef SF_MANY_H
#define SF_MANY_H

#include "many_detachment.h"
#include "many_folds.h"
#include "many_onsets.h"
#include "many_peaks.h"
#include "many_states.h"

static double sf_input(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k) {
    return *(const double *)(const void *)(args[i] + k * steps[i]);
}

static void sf_output(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k, double value) {
    *(double *)(void *)(args[i] + k * steps[i]) = value;
}

static void sf_output_code(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k, int value) {
    *(signed char *)(args[i] + k * steps[i]) = (signed char)value;
}

static void sf_read_numbers_at(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                               sf_numbers *out) {
    int i;
    for (i = 0; i < mechanism->design_size; i++)
        out->design[i] = sf_input(args, steps, i, k);
    for (i = 0; i < mechanism->damping_size; i++)
        out->damping[i] = sf_input(args, steps, mechanism->design_size + i, k);
}

/* Design k as the solvers take it; 0 if a number lies outside its domain, or sf_prepare refuses it, or
 * with other laws of damping it has no answer.
 * jumps: whether it is asked what the force loses at its breakpoints, which takes longer than some answers. */
static int sf_design_at(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k, int jumps,
                        sf_model *model) {
    sf_numbers at;
    sf_read_numbers_at(mechanism, args, steps, k, &at);
    if (!mechanism->parameters_of(mechanism, at.design, model->p) || !mechanism->damping_of(at.damping, model->damping))
        return 0;
    return sf_prepare(mechanism, jumps ? at.design : NULL, model) && (!sf_has_laws(model) || sf_allows_laws(model));
}

/* Design k as it was given; 0 where no proof is possible. */
static int sf_given_at(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k, sf_given *given)
{
    sf_numbers at;
    sf_read_numbers_at(mechanism, args, steps, k, &at);
    return sf_give(mechanism, at.design, at.damping[0], at.damping[1], given);
}

/* The same in pairs; 0 where there is no such form. */
static int sf_exactly_at(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                         sf_exactly *exactly)
{
    sf_numbers at;
    sf_read_numbers_at(mechanism, args, steps, k, &at);
    return sf_make_exact(mechanism, at.design, at.damping[0], at.damping[1], exactly);
}

/* Designs first..end of a mechanism that has pairs. */
static void sf_make_exact_block(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t first,
                                ptrdiff_t end, sf_exact_block *block)
{
    ptrdiff_t k;
    int i;
    for (i = 0; i < mechanism->design_size; i++)
        for (k = first; k < end; k++)
            block->number[i * SF_LANE_BLOCK + (k - first)] = sf_input(args, steps, i, k);
    mechanism->many_in_pairs(mechanism, end - first, SF_LANE_BLOCK, block->number, block->part);
}

/* Member d of the block, which is design k. */
static void sf_exactly_of(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                          const sf_exact_block *block, ptrdiff_t d, sf_exactly *exactly)
{
    const double *part = block->part + d;
    int i;
    for (i = 0; i < mechanism->parameters + mechanism->breakpoints; i++)
        exactly->p[i] = (sf_pair){part[2 * i * SF_LANE_BLOCK], part[(2 * i + 1) * SF_LANE_BLOCK]};
    sf_complete_exact(mechanism, sf_input(args, steps, mechanism->design_size, k),
                      sf_input(args, steps, mechanism->design_size + 1, k), exactly);
}

/* ==== Answers, from output `out` on =============================================================================== */

/* Arrays of one more axis, whose steps stand behind those of all arguments: place i of output `at` of these. */
static void *sf_at_place(char **args, const ptrdiff_t *steps, const ptrdiff_t *inner, int out, int at, ptrdiff_t k,
                         ptrdiff_t i)
{
    return args[out + at] + k * steps[out + at] + i * inner[at];
}

/* How one design's search fared: SF_TOO_MANY is what has no place in an answer, and no search that ran out of room. */
static sf_status sf_of_search(sf_status status) { return status == SF_TOO_MANY ? SF_UNRESOLVED : status; }

static void sf_write_detachment(char **args, const ptrdiff_t *steps, int out, ptrdiff_t k, double F_cr, double Omega_cr,
                                double u_cr, sf_status status) {
    sf_output(args, steps, out, k, F_cr);
    sf_output(args, steps, out + 1, k, Omega_cr);
    sf_output(args, steps, out + 2, k, u_cr);
    sf_output_code(args, steps, out + 3, k, status);
}

/* at_rest: whether folds that end at Omega = 0 are below it */
static void sf_write_onset(char **args, const ptrdiff_t *steps, int out, ptrdiff_t k, const sf_onset *found,
                           int at_rest, sf_status status)
{
    sf_output(args, steps, out, k, found->F_SN);
    sf_output(args, steps, out + 1, k, found->Omega);
    sf_output(args, steps, out + 2, k, found->A);
    sf_output_code(args, steps, out + 3, k, found->kind);
    sf_output_code(args, steps, out + 4, k, at_rest);
    sf_output_code(args, steps, out + 5, k, sf_of_search(status));
}

static void sf_write_peak(char **args, const ptrdiff_t *steps, int out, ptrdiff_t k, double A, double Omega,
                          sf_status status)
{
    sf_output(args, steps, out, k, A);
    sf_output(args, steps, out + 1, k, Omega);
    sf_output_code(args, steps, out + 2, k, sf_of_search(status));
}

/* How many there are, and the status, SF_TOO_MANY where there are no places for them. */
static void sf_write_count(char **args, const ptrdiff_t *steps, int out, ptrdiff_t k, int n, int undecided,
                           ptrdiff_t places, sf_status status)
{
    sf_output_code(args, steps, out, k, n);
    sf_output_code(args, steps, out + 1, k, undecided);
    sf_output_code(args, steps, out + 2, k, n > places && status == SF_OK ? SF_TOO_MANY : status);
}

static sf_fold_kind sf_kind_of(const sf_fold *fold) {
    if (fold->corner)
        return fold->up ? SF_JUMP_UP_AT_CORNER : SF_JUMP_DOWN_AT_CORNER;
    return fold->up ? SF_JUMP_UP : SF_JUMP_DOWN;
}

/* A fold into place i; NULL leaves it empty. */
static void sf_write_fold(char **args, const ptrdiff_t *steps, const ptrdiff_t *inner, int out, ptrdiff_t k,
                          ptrdiff_t i, const sf_fold *fold)
{
    *(double *)sf_at_place(args, steps, inner, out, 0, k, i) = fold != NULL ? fold->Omega : NAN;
    *(double *)sf_at_place(args, steps, inner, out, 1, k, i) = fold != NULL ? fold->A : NAN;
    *(signed char *)sf_at_place(args, steps, inner, out, 2, k, i) =
        (signed char)(fold != NULL ? sf_kind_of(fold) : SF_EMPTY);
}

/* ==== Questions ================================================================================================== */

/* Detachment of one design, by itself. */
static void sf_answer_detachment(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k) {
    sf_model model;
    sf_exactly exactly;
    double F_cr = NAN, Omega_cr = NAN, u_cr = NAN;
    sf_status status = SF_INVALID;
    if (sf_design_at(mechanism, args, steps, k, 0, &model))
        status = sf_settled_detachment(&model, sf_exactly_at(mechanism, args, steps, k, &exactly) ? &exactly : NULL,
                                       &F_cr, &Omega_cr, &u_cr);
    sf_write_detachment(args, steps, mechanism->design_size + mechanism->damping_size, k, F_cr, Omega_cr, u_cr, status);
}

/* Whether design k becomes a member of a block. */
static int sf_enter_detachment(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                               sf_detaching *block) {
    sf_numbers given;
    sf_model model;
    sf_read_numbers_at(mechanism, args, steps, k, &given);
    return mechanism->parameters_of(mechanism, given.design, model.p) &&
           mechanism->damping_of(given.damping, model.damping) &&
           sf_prepare(mechanism, NULL, &model) && sf_begin_detachment(block, k, &given, &model);
}

/* design, damping -> F_cr, Omega_cr, u_cr, status */
static void sf_loop_detachment(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size, together = sf_detach_together(mechanism);
    ptrdiff_t first, k;
    for (first = 0; first < dimensions[0]; first += SF_DETACHING) {
        const ptrdiff_t end = first + SF_DETACHING < dimensions[0] ? first + SF_DETACHING : dimensions[0];
        sf_detaching block;
        int d;
        block.n = 0;
        for (k = first; k < end; k++)
            if (!(together && sf_enter_detachment(mechanism, args, steps, k, &block)))
                sf_answer_detachment(mechanism, args, steps, k);
        if (block.n > 0)
            sf_settle_detachments(mechanism, &block);
        for (d = 0; d < block.n; d++) {
            if (isnan(block.change[d]))
                sf_answer_detachment(mechanism, args, steps, block.k[d]);
            else
                sf_write_detachment(args, steps, out, block.k[d], block.F_0[d], block.Omega[d], block.u_cr[d], SF_OK);
        }
    }
}

/* Whether designs of a mechanism may go together: what is known of h on a cell, and in pairs. */
static int sf_goes_in_lanes(const sf_mechanism *mechanism) {
    return mechanism->bent == NULL && mechanism->averaged_in_pairs != NULL && !mechanism->inertial &&
           !sf_takes_laws(mechanism);
}

/* The onset of one design, by itself. */
static void sf_answer_onset(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                            sf_work *work)
{
    sf_onset found = {NAN, NAN, NAN, SF_NO_KIND, HUGE_VAL, 0};
    sf_status status = work == NULL ? SF_NO_MEMORY : SF_INVALID;
    sf_model model;
    sf_exactly exactly;
    if (work != NULL && sf_design_at(mechanism, args, steps, k, 1, &model))
        status = sf_settled_onset(&model, sf_exactly_at(mechanism, args, steps, k, &exactly) ? &exactly : NULL, work,
                                  &found);
    sf_write_onset(args, steps, mechanism->design_size + mechanism->damping_size, k, &found,
                   status != SF_UNBOUNDED && sf_is_rest_below(&found), status);
}

/* Whether design k begins the search of a block as its member d. */
static int sf_enter_onset(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                          const sf_exact_block *exact, sf_onset_block *block, int d)
{
    sf_model *model = &block->lanes.at[d].model;
    if (!sf_design_at(mechanism, args, steps, k, 0, model) || !sf_take_jumps(exact, d, model))
        return 0;
    sf_end_pieces(model, &block->ends[d]);
    sf_begin_onset(model, &block->ends[d], &block->best[d]);
    return sf_begin_cusps(block, d);
}

/* Whether the onset of a member, which is design k, settles, and is written. */
static int sf_leave_onset(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                          const sf_exact_block *exact, sf_onset_block *block, ptrdiff_t d, sf_work *work)
{
    const sf_lane_design *of = &block->lanes.at[d];
    sf_onset *found = &block->best[d];
    sf_exactly exactly;
    if (!of->ok)
        return 0;
    sf_consider_cusps(of, found);
    if (sf_end_onset(&of->model, &block->ends[d], 1, work, found) != SF_OK)
        return 0;
    sf_exactly_of(mechanism, args, steps, k, exact, d, &exactly);
    if (!sf_settle_onset(&of->model, &exactly, found))
        return 0;
    sf_write_onset(args, steps, mechanism->design_size + mechanism->damping_size, k, found, sf_is_rest_below(found),
                   SF_OK);
    return 1;
}

/* design, damping -> F_SN, Omega, A, kind, whether folds that end at Omega = 0 are below it, status */
static void sf_loop_onsets(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    sf_work *work = malloc(sizeof *work);
    sf_onset_block *block = work != NULL && sf_goes_in_lanes(mechanism) ? malloc(sizeof *block) : NULL;
    sf_exact_block exact;
    ptrdiff_t first, k;
    for (first = 0; first < dimensions[0]; first += SF_ONSET_BLOCK) {
        const ptrdiff_t end = first + SF_ONSET_BLOCK < dimensions[0] ? first + SF_ONSET_BLOCK : dimensions[0];
        if (block != NULL) {
            sf_make_exact_block(mechanism, args, steps, first, end, &exact);
            block->lanes.cells[0].n = 0;
            for (k = first; k < end; k++)
                block->lanes.at[k - first].ok =
                    sf_enter_onset(mechanism, args, steps, k, &exact, block, (int)(k - first));
            sf_search_block(&sf_cusps_in_lanes, &block->lanes);
            sf_approach_block(&sf_cusps_in_lanes, &block->lanes);
        }
        for (k = first; k < end; k++)
            if (block == NULL || !sf_leave_onset(mechanism, args, steps, k, &exact, block, k - first, work))
                sf_answer_onset(mechanism, args, steps, k, work);
    }
    free(block);
    free(work);
}

/* The peak of one design, by itself. */
static void sf_answer_peak(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                           sf_work *work)
{
    const int out = mechanism->design_size + mechanism->damping_size + 1;
    const double F_0 = sf_input(args, steps, out - 1, k);
    sf_model model;
    sf_exactly exactly;
    double A = NAN, Omega = NAN;
    sf_status status = SF_INVALID;
    if (mechanism->is_forcing(F_0) && sf_design_at(mechanism, args, steps, k, 1, &model))
        status = sf_settled_peak(&model, sf_exactly_at(mechanism, args, steps, k, &exactly) ? &exactly : NULL, F_0,
                                 HUGE_VAL, work, &A, &Omega);
    sf_write_peak(args, steps, out, k, A, Omega, status);
}

/* Whether design k begins the search of a block for peaks or folds as its member d. begin: with its first cells */
static int sf_enter_at_forcing(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                               const sf_exact_block *exact, sf_lane_block *block, int d,
                               int (*begin)(sf_lane_block *, int))
{
    sf_lane_design *of = &block->at[d];
    of->F_0 = sf_input(args, steps, mechanism->design_size + mechanism->damping_size, k), of->Omega = 0;
    return mechanism->is_forcing(of->F_0) && sf_design_at(mechanism, args, steps, k, 0, &of->model) &&
           sf_take_jumps(exact, d, &of->model) && begin(block, d);
}

/* Whether the peak of member d, which is design k, settles, and is written. */
static int sf_leave_peak(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                         const sf_exact_block *exact, ptrdiff_t d, const sf_lane_design *of)
{
    sf_exactly exactly;
    double A, Omega;
    if (!of->ok)
        return 0;
    sf_exactly_of(mechanism, args, steps, k, exact, d, &exactly);
    if (!sf_settle_block_peak(of, &exactly, &A, &Omega))
        return 0;
    sf_write_peak(args, steps, mechanism->design_size + mechanism->damping_size + 1, k, A, Omega, SF_OK);
    return 1;
}

/* design, damping, F_0 -> A, Omega, status */
static void sf_loop_peaks(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    sf_work *work = malloc(sizeof *work);
    sf_lane_block *block = sf_goes_in_lanes(mechanism) ? malloc(sizeof *block) : NULL;
    sf_exact_block exact;
    ptrdiff_t first, k;
    for (first = 0; first < dimensions[0]; first += SF_LANE_BLOCK) {
        const ptrdiff_t end = first + SF_LANE_BLOCK < dimensions[0] ? first + SF_LANE_BLOCK : dimensions[0];
        if (block != NULL) {
            sf_make_exact_block(mechanism, args, steps, first, end, &exact);
            block->cells[0].n = 0;
            for (k = first; k < end; k++)
                block->at[k - first].ok = sf_enter_at_forcing(mechanism, args, steps, k, &exact, block,
                                                              (int)(k - first), sf_begin_peak);
            sf_search_peaks(block);
            sf_approach_block(&sf_peaks_in_lanes, block);
        }
        for (k = first; k < end; k++) {
            if (work == NULL)
                sf_write_peak(args, steps, mechanism->design_size + mechanism->damping_size + 1, k, NAN, NAN,
                              SF_NO_MEMORY);
            else if (block == NULL || !sf_leave_peak(mechanism, args, steps, k, &exact, k - first, &block->at[k - first]))
                sf_answer_peak(mechanism, args, steps, k, work);
        }
    }
    free(block);
    free(work);
}

/* The folds of design k into their places. */
static void sf_write_folds(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, int out, ptrdiff_t k,
                           const sf_folds *found, sf_status status)
{
    const ptrdiff_t places = dimensions[1], *inner = steps + out + 6;
    ptrdiff_t i;
    for (i = 0; i < places; i++)
        sf_write_fold(args, steps, inner, out, k, i, i < found->n ? &found->at[i] : NULL);
    sf_write_count(args, steps, out + 3, k, found->n, found->undecided, places, status);
}

/* The folds of one design, by itself. exact: its block in pairs, of which it is member d; NULL where there are none */
static void sf_answer_folds(const sf_mechanism *mechanism, char **args, const ptrdiff_t *dimensions,
                            const ptrdiff_t *steps, ptrdiff_t k, const sf_exact_block *exact, ptrdiff_t d,
                            sf_room *room)
{
    const int out = mechanism->design_size + mechanism->damping_size + 1;
    const double F_0 = sf_input(args, steps, out - 1, k);
    sf_model model;
    sf_given given;
    sf_folds found;
    sf_status status = room == NULL ? SF_NO_MEMORY : SF_INVALID;
    found.n = found.undecided = 0;
    if (room != NULL && mechanism->is_forcing(F_0) && sf_design_at(mechanism, args, steps, k, 1, &model)) {
        /* the numbers that follow from a design on intervals take time, and few designs need them */
        if (exact != NULL)
            sf_exactly_of(mechanism, args, steps, k, exact, d, &given.exactly);
        if (sf_has_laws(&model)) {
            /* only a jump that rounds to 0 is looked at in the design */
            const int is_given = sf_is_continuous(&model) && sf_given_at(mechanism, args, steps, k, &given);
            status = sf_law_folds(&model, is_given ? &given : NULL, F_0, &room->work, &found);
        } else if (!(exact != NULL && sf_told_folds(&model, &given.exactly, F_0, room, &found, &status))) {
            const int is_given = sf_given_at(mechanism, args, steps, k, &given);
            status = sf_settled_folds(&model, is_given ? &given : NULL, F_0, room, &found);
        }
        status = sf_of_search(status);
    }
    sf_write_folds(args, dimensions, steps, out, k, &found, status);
}

/* Whether the folds of member d, which is design k, settle, and are written. */
static int sf_leave_folds(const sf_mechanism *mechanism, char **args, const ptrdiff_t *dimensions,
                          const ptrdiff_t *steps, ptrdiff_t k, const sf_exact_block *exact, ptrdiff_t d,
                          const sf_lane_design *of, sf_room *room)
{
    sf_exactly exactly;
    sf_folds found;
    if (!of->ok)
        return 0;
    sf_exactly_of(mechanism, args, steps, k, exact, d, &exactly);
    if (!sf_settle_block_folds(of, &exactly, &room->work, &found))
        return 0;
    sf_write_folds(args, dimensions, steps, mechanism->design_size + mechanism->damping_size + 1, k, &found, SF_OK);
    return 1;
}

/* design, damping, F_0 -> Omega (places), A (places), kind (places), count, undecided, status */
static void sf_loop_folds(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    sf_room *room = malloc(sizeof *room);
    sf_lane_block *block = room != NULL && sf_goes_in_lanes(mechanism) ? malloc(sizeof *block) : NULL;
    const int has_pairs = sf_has_pairs(mechanism) && !sf_takes_laws(mechanism);
    sf_exact_block exact;
    ptrdiff_t first, k;
    for (first = 0; first < dimensions[0]; first += SF_FOLD_BLOCK) {
        const ptrdiff_t end = first + SF_FOLD_BLOCK < dimensions[0] ? first + SF_FOLD_BLOCK : dimensions[0];
        if (has_pairs)
            sf_make_exact_block(mechanism, args, steps, first, end, &exact);
        if (block != NULL) {
            block->cells[0].n = 0;
            for (k = first; k < end; k++)
                block->at[k - first].ok = sf_enter_at_forcing(mechanism, args, steps, k, &exact, block,
                                                              (int)(k - first), sf_begin_folds);
            sf_search_block(&sf_folds_in_lanes, block);
            sf_approach_block(&sf_folds_in_lanes, block);
        }
        for (k = first; k < end; k++)
            if (block == NULL || !sf_leave_folds(mechanism, args, dimensions, steps, k, &exact, k - first,
                                                 &block->at[k - first], room))
                sf_answer_folds(mechanism, args, dimensions, steps, k, has_pairs ? &exact : NULL, k - first, room);
    }
    free(block);
    free(room);
}

/* The states of design k into their places. */
static void sf_write_states(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, int out, ptrdiff_t k,
                            int n, const double *A, const unsigned char *stable, int undecided, sf_status status)
{
    const ptrdiff_t places = dimensions[1], *inner = steps + out + 5;
    ptrdiff_t i;
    for (i = 0; i < places; i++) {
        *(double *)sf_at_place(args, steps, inner, out, 0, k, i) = i < n ? A[i] : NAN;
        *(signed char *)sf_at_place(args, steps, inner, out, 1, k, i) = (signed char)(i < n && stable[i]);
    }
    sf_write_count(args, steps, out + 2, k, n, undecided, places, status);
}

/* The states of one design, by itself. */
static void sf_answer_states(const sf_mechanism *mechanism, char **args, const ptrdiff_t *dimensions,
                             const ptrdiff_t *steps, ptrdiff_t k, sf_room *room)
{
    const int forcing = mechanism->design_size + mechanism->damping_size;
    const double F_0 = sf_input(args, steps, forcing, k), Omega = sf_input(args, steps, forcing + 1, k);
    double A[SF_MOST_STATES];
    unsigned char stable[SF_MOST_STATES];
    sf_model model;
    sf_given given;
    sf_status status = SF_INVALID;
    int n = 0, undecided = 0;
    if (mechanism->is_forcing(F_0) && Omega > 0 && Omega <= SF_HIGHEST_OMEGA &&
        sf_design_at(mechanism, args, steps, k, 1, &model)) {
        const sf_given *exact = sf_given_at(mechanism, args, steps, k, &given) ? &given : NULL;
        room->followed = 0, model.lowest = Omega;
        status = sf_of_search(sf_states(&model, exact, F_0, room, Omega, &n, A, stable, &undecided));
    }
    sf_write_states(args, dimensions, steps, forcing + 2, k, n, A, stable, undecided, status);
}

/* Whether design k begins the search of a block as its member d. */
static int sf_enter_states(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                           const sf_exact_block *exact, sf_lane_block *block, int d)
{
    const int forcing = mechanism->design_size + mechanism->damping_size;
    sf_lane_design *of = &block->at[d];
    sf_numbers given;
    of->F_0 = sf_input(args, steps, forcing, k), of->Omega = sf_input(args, steps, forcing + 1, k);
    of->model.mechanism = mechanism;
    if (!(mechanism->is_forcing(of->F_0) && of->Omega > 0 && of->Omega <= SF_HIGHEST_OMEGA))
        return 0;
    sf_read_numbers_at(mechanism, args, steps, k, &given);
    return mechanism->parameters_of(mechanism, given.design, of->model.p) &&
           mechanism->damping_of(given.damping, of->model.damping) && sf_begin_states(block, d, exact);
}

/* Whether the states of member d, which is design k, settle, and are written. */
static int sf_leave_states(const sf_mechanism *mechanism, char **args, const ptrdiff_t *dimensions,
                           const ptrdiff_t *steps, ptrdiff_t k, const sf_exact_block *exact, ptrdiff_t d,
                           const sf_lane_design *of)
{
    double A[SF_LANE_ZEROS];
    sf_exactly exactly;
    unsigned char stable[SF_LANE_ZEROS];
    int i;
    if (!of->ok)
        return 0;
    sf_exactly_of(mechanism, args, steps, k, exact, d, &exactly);
    if (!sf_settle_block_states(of, &exactly, A))
        return 0;
    for (i = 0; i < of->n; i++)
        stable[i] = (unsigned char)of->rises[i];
    sf_write_states(args, dimensions, steps, mechanism->design_size + mechanism->damping_size + 2, k, of->n, A, stable,
                    0, SF_OK);
    return 1;
}

/* design, damping, F_0, Omega -> A (places), whether it is stable (places), count, undecided, status */
static void sf_loop_states(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    sf_room *room = malloc(sizeof *room);
    sf_lane_block *block = sf_goes_in_lanes(mechanism) ? malloc(sizeof *block) : NULL;
    sf_exact_block exact;
    ptrdiff_t first, k;
    for (first = 0; first < dimensions[0]; first += SF_LANE_BLOCK) {
        const ptrdiff_t end = first + SF_LANE_BLOCK < dimensions[0] ? first + SF_LANE_BLOCK : dimensions[0];
        if (block != NULL) {
            sf_make_exact_block(mechanism, args, steps, first, end, &exact);
            block->cells[0].n = 0;
            for (k = first; k < end; k++)
                block->at[k - first].ok = sf_enter_states(mechanism, args, steps, k, &exact, block, (int)(k - first));
            sf_search_block(&sf_states_in_lanes, block);
            sf_approach_block(&sf_states_in_lanes, block);
        }
        for (k = first; k < end; k++) {
            if (room == NULL)
                sf_write_states(args, dimensions, steps, mechanism->design_size + mechanism->damping_size + 2, k, 0,
                                NULL, NULL, 0, SF_NO_MEMORY);
            else if (block == NULL || !sf_leave_states(mechanism, args, dimensions, steps, k, &exact, k - first,
                                                          &block->at[k - first]))
                sf_answer_states(mechanism, args, dimensions, steps, k, room);
        }
    }
    free(block);
    free(room);
}

#endif
