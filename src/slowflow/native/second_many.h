/* The second approximation of many designs. Takes a record and strided arrays; returns strided arrays, as in
 * many.h. */
#ifndef SF_SECOND_MANY_H
#define SF_SECOND_MANY_H

#include "many.h"
#include "second_questions.h"

/* Whether the spring's harmonics are known for this model. */
static int sf_has_second(const sf_model *model) {
    return model->mechanism->harmonics != NULL &&
           !(model->breaks > 0 && model->b[model->breaks - 1] > model->mechanism->harmonics_up_to);
}

/* design, damping -> F_cr, Omega_cr, u_cr, status */
static void sf_loop_second_detachment(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size;
    ptrdiff_t k;
    for (k = 0; k < dimensions[0]; k++) {
        sf_model model;
        double first[3] = {NAN, NAN, NAN}, F_cr = NAN, Omega_cr = NAN;
        sf_status status = SF_INVALID;
        if (sf_design_at(mechanism, args, steps, k, 1, &model) && sf_has_second(&model))
            status = sf_detachment(&model, &first[0], &first[1], &first[2]);
        if (status == SF_OK && !sf_second_detach(&model, first[0], first[1], first[2], &F_cr, &Omega_cr))
            status = SF_NONE, F_cr = Omega_cr = NAN;
        sf_write_detachment(args, steps, out, k, F_cr, Omega_cr, first[2], status);
    }
}

/* design, damping -> F_SN, Omega, A, kind, whether folds that end at Omega = 0 are below it, status */
static void sf_loop_second_onsets(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size;
    sf_work *work = malloc(sizeof *work);
    ptrdiff_t k;
    for (k = 0; k < dimensions[0]; k++) {
        sf_model model;
        sf_onset first = {NAN, NAN, NAN, SF_NO_KIND, HUGE_VAL}, found = {NAN, NAN, NAN, SF_NO_KIND, HUGE_VAL};
        sf_exactly exactly;
        double u_max = NAN;
        sf_status status = work == NULL ? SF_NO_MEMORY : SF_INVALID;
        if (work != NULL && sf_design_at(mechanism, args, steps, k, 1, &model) && sf_has_second(&model))
            status = sf_settled_onset(&model, sf_exactly_at(mechanism, args, steps, k, &exactly) ? &exactly : NULL,
                                      work, &first);
        if (status == SF_OK &&
            (first.kind != SF_CUSP_KIND || !sf_second_cusp(&model, &first, &found, &u_max)))
            status = SF_NONE;
        found.A = u_max;
        sf_write_onset(args, steps, out, k, &found, sf_is_rest_below(&first), status);
    }
    free(work);
}

/* design, damping, F_0 -> A, Omega, status */
static void sf_loop_second_peaks(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size + 1;
    sf_room *room = malloc(sizeof *room);
    ptrdiff_t k;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = sf_input(args, steps, out - 1, k);
        const sf_given *exact;
        sf_second_curve *curve = NULL;
        sf_second_point top;
        sf_model model;
        sf_given given;
        double A = NAN, Omega = NAN;
        sf_status status = room == NULL ? SF_NO_MEMORY : SF_INVALID;
        if (room != NULL && mechanism->is_forcing(F_0) && sf_design_at(mechanism, args, steps, k, 1, &model) &&
            sf_has_second(&model)) {
            exact = sf_given_at(mechanism, args, steps, k, &given) ? &given : NULL;
            status = sf_settled_peak(&model, exact == NULL ? NULL : &exact->exactly, F_0, HUGE_VAL, &room->work, &A,
                                     &Omega);
            if (status == SF_OK)
                status = Omega == 0 ? SF_NONE : sf_second_peak(&model, exact, F_0, Omega, room, &curve, &top);
        }
        if (curve != NULL)
            sf_second_free(curve);
        if (status == SF_OK)
            sf_write_peak(args, steps, out, k, top.at.u_max, top.Omega, status);
        else
            sf_write_peak(args, steps, out, k, NAN, NAN, status);
    }
    free(room);
}

/* design, damping, F_0 -> Omega (places), A (places), kind (places), count, whether some are lost, status */
static void sf_loop_second_folds(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int out = mechanism->design_size + mechanism->damping_size + 1;
    const ptrdiff_t places = dimensions[1], *inner = steps + out + 6;
    sf_room *room = malloc(sizeof *room);
    ptrdiff_t k, i;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = sf_input(args, steps, out - 1, k);
        sf_model model;
        sf_given given;
        sf_second_folds found;
        sf_status status = room == NULL ? SF_NO_MEMORY : SF_INVALID;
        found.n = found.lost = 0;
        if (room != NULL && mechanism->is_forcing(F_0) && sf_design_at(mechanism, args, steps, k, 1, &model) &&
            sf_has_second(&model))
            status = sf_of_search(sf_second_saddle_nodes(
                &model, sf_given_at(mechanism, args, steps, k, &given) ? &given : NULL, F_0, HUGE_VAL, 0, room, &found));
        for (i = 0; i < found.n && i < places; i++) {
            const sf_second_fold *at = &found.at[i];
            const sf_fold fold = {at->Omega, at->u_max, at->up, at->corner};
            sf_write_fold(args, steps, inner, out, k, i, &fold);
        }
        for (; i < places; i++)
            sf_write_fold(args, steps, inner, out, k, i, NULL);
        sf_write_count(args, steps, out + 3, k, found.n, found.lost > 0, places, status);
    }
    free(room);
}

#endif
