/* Batches of designs: in go a record and strided arrays, out come strided arrays.
 *
 * The loops have the form of NumPy's ufuncs: args[i] + k * steps[i] is argument i of design k, and `data` is the record.
 * The inputs are the design, the damping, and where needed F_0. Nothing is allocated per design.
 */
#ifndef SF_MANY_H
#define SF_MANY_H

#include <fenv.h>

#include "decide.h"
#include "settle.h"

static double sf_input(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k) {
    return *(const double *)(const void *)(args[i] + k * steps[i]);
}

static void sf_output(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k, double value) {
    *(double *)(void *)(args[i] + k * steps[i]) = value;
}

static void sf_output_code(char **args, const ptrdiff_t *steps, int i, ptrdiff_t k, int value) {
    *(signed char *)(args[i] + k * steps[i]) = (signed char)value;
}

/* Design k as the solvers take it; 0 if a number lies outside its domain. */
static int sf_design_at(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k,
                        sf_model *model) {
    double design[SF_MOST_DESIGN], damping[SF_MOST_DAMPING];
    int i;
    for (i = 0; i < mechanism->design_size; i++)
        design[i] = sf_input(args, steps, i, k);
    for (i = 0; i < mechanism->damping_size; i++)
        damping[i] = sf_input(args, steps, mechanism->design_size + i, k);
    if (!mechanism->parameters_of(design, model->p) || !mechanism->damping_of(damping, model->damping))
        return 0;
    sf_prepare(mechanism, model);
    return 1;
}

/* Design k as it was given; 0 where no proof is possible. */
static int sf_given_at(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k, sf_given *given) {
    double design[SF_MOST_DESIGN];
    const int damping = mechanism->design_size;
    int i;
    for (i = 0; i < mechanism->design_size; i++)
        design[i] = sf_input(args, steps, i, k);
    return sf_give(mechanism, design, sf_input(args, steps, damping, k), sf_input(args, steps, damping + 1, k), given);
}

/* The same in pairs; 0 where there is no such form. */
static int sf_exactly_at(const sf_mechanism *mechanism, char **args, const ptrdiff_t *steps, ptrdiff_t k, sf_exactly *exactly) {
    double design[SF_MOST_DESIGN];
    const int damping = mechanism->design_size;
    int i;
    for (i = 0; i < mechanism->design_size; i++)
        design[i] = sf_input(args, steps, i, k);
    return sf_make_exact(mechanism, design, sf_input(args, steps, damping, k), sf_input(args, steps, damping + 1, k), exactly);
}

/* A solver tries values that it then discards: the flags that these raise are no fault of the arguments. */
static void sf_quietly(sf_many loop, char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    fenv_t before;
    feholdexcept(&before);
    loop(args, dimensions, steps, data);
    fesetenv(&before);
}

/* design, damping -> F_cr, Omega_cr, u_cr, status */
static void sf_loop_detachment(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size;
    ptrdiff_t k;
    for (k = 0; k < dimensions[0]; k++) {
        sf_model model;
        double found[3] = {NAN, NAN, NAN};
        int i;
        sf_exactly exactly;
        sf_status status = SF_INVALID;
        if (sf_design_at(mechanism, args, steps, k, &model))
            status = sf_settled_detachment(&model, sf_exactly_at(mechanism, args, steps, k, &exactly) ? &exactly : NULL,
                                           &found[0], &found[1], &found[2]);
        for (i = 0; i < 3; i++)
            sf_output(args, steps, out + i, k, found[i]);
        sf_output_code(args, steps, out + 3, k, status);
    }
}

/* design, damping -> F_SN, Omega, A, kind, whether folds that end at Omega = 0 are below it, status */
static void sf_loop_onsets(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size;
    sf_work *work = malloc(sizeof *work);
    ptrdiff_t k;
    for (k = 0; k < dimensions[0]; k++) {
        sf_model model;
        sf_exactly exactly;
        sf_onset found = {NAN, NAN, NAN, SF_NO_KIND, HUGE_VAL};
        sf_status status = work == NULL ? SF_NO_MEMORY : SF_INVALID;
        if (work != NULL && sf_design_at(mechanism, args, steps, k, &model))
            status = sf_settled_onset(&model, sf_exactly_at(mechanism, args, steps, k, &exactly) ? &exactly : NULL, work,
                                      &found);
        sf_output(args, steps, out, k, found.F_SN);
        sf_output(args, steps, out + 1, k, found.Omega);
        sf_output(args, steps, out + 2, k, found.A);
        sf_output_code(args, steps, out + 3, k, found.kind);
        sf_output_code(args, steps, out + 4, k, found.rest < (found.kind == SF_NO_KIND ? HUGE_VAL : found.F_SN));
        sf_output_code(args, steps, out + 5, k, status);
    }
    free(work);
}

/* design, damping, F_0 -> A, Omega, status */
static void sf_loop_peaks(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size + 1;
    sf_work *work = malloc(sizeof *work);
    ptrdiff_t k;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = sf_input(args, steps, out - 1, k);
        sf_model model;
        sf_exactly exactly;
        double A = NAN, Omega = NAN;
        sf_status status = work == NULL ? SF_NO_MEMORY : SF_INVALID;
        if (work != NULL && mechanism->is_forcing(F_0) && sf_design_at(mechanism, args, steps, k, &model))
            status = sf_settled_peak(&model, sf_exactly_at(mechanism, args, steps, k, &exactly) ? &exactly : NULL, F_0, work,
                                     &A, &Omega);
        sf_output(args, steps, out, k, A);
        sf_output(args, steps, out + 1, k, Omega);
        sf_output_code(args, steps, out + 2, k, status);
    }
    free(work);
}

static sf_fold_kind sf_kind_of(const sf_fold *fold) {
    if (fold->corner)
        return fold->up ? SF_JUMP_UP_AT_CORNER : SF_JUMP_DOWN_AT_CORNER;
    return fold->up ? SF_JUMP_UP : SF_JUMP_DOWN;
}

/* design, damping, F_0 -> Omega (places), A (places), kind (places), count, undecided, status */
static void sf_loop_folds(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size + 1;
    const ptrdiff_t places = dimensions[1], *inner = steps + out + 6;
    sf_room *room = malloc(sizeof *room);
    ptrdiff_t k, i;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = sf_input(args, steps, out - 1, k);
        sf_model model;
        sf_given given;
        sf_folds found;
        sf_status status = room == NULL ? SF_NO_MEMORY : SF_INVALID;
        found.n = found.undecided = 0;
        if (room != NULL && mechanism->is_forcing(F_0) && sf_design_at(mechanism, args, steps, k, &model)) {
            const int is_given = sf_given_at(mechanism, args, steps, k, &given);
            status = sf_settled_folds(&model, is_given ? &given : NULL, F_0, room, &found);
        }
        if (found.n > places && status == SF_OK)
            status = SF_TOO_MANY;
        for (i = 0; i < places; i++) {
            const int filled = i < found.n;
            *(double *)(void *)(args[out] + k * steps[out] + i * inner[0]) = filled ? found.at[i].Omega : NAN;
            *(double *)(void *)(args[out + 1] + k * steps[out + 1] + i * inner[1]) = filled ? found.at[i].A : NAN;
            *(signed char *)(args[out + 2] + k * steps[out + 2] + i * inner[2]) =
                (signed char)(filled ? sf_kind_of(&found.at[i]) : SF_EMPTY);
        }
        sf_output_code(args, steps, out + 3, k, found.n);
        sf_output_code(args, steps, out + 4, k, found.undecided);
        sf_output_code(args, steps, out + 5, k, status);
    }
    free(room);
}

static void sf_many_detachment(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_detachment, args, dimensions, steps, data);
}

static void sf_many_onsets(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_onsets, args, dimensions, steps, data);
}

static void sf_many_folds(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_folds, args, dimensions, steps, data);
}

static void sf_many_peaks(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_peaks, args, dimensions, steps, data);
}

#endif
