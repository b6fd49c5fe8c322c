/* The second approximation of many designs: in go a record and strided arrays, out come strided arrays, as in
 * many.h. */
#ifndef SF_SECOND_MANY_H
#define SF_SECOND_MANY_H

#include "many.h"
#include "second_answers.h"

/* Whether the spring's harmonics are known for this model. */
static int sf_has_second(const sf_model *model) {
    return model->mechanism->harmonics != NULL &&
           !(model->breaks > 0 && model->b[model->breaks - 1] > model->mechanism->harmonics_up_to);
}

/* The curve about some frequencies and what may lie beside them; NULL if there is no memory. */
static sf_second_curve *sf_second_around(const sf_model *model, double F_0, sf_wanted wanted, double low, double high,
                                         sf_work *work) {
    const long n = sf_show(model, F_0, low / SF_BEYOND, high * SF_BEYOND, SF_SAMPLES, work);
    double *room = malloc((size_t)(2 * n + 1) * sizeof *room);
    long long *branch = malloc((size_t)(n + 1) * sizeof *branch);
    unsigned char *flags = malloc((size_t)(n + work->shown.curves + 1));
    sf_second_curve *curve = NULL;
    if (room != NULL && branch != NULL && flags != NULL) {
        int i;
        sf_draw(model, F_0, SF_SAMPLES, &work->shown, room, room + n, flags, branch);
        for (i = 0; i < work->shown.curves; i++)
            flags[n + i] = (unsigned char)work->shown.closed[i];
        curve = sf_second_follow(model, F_0, wanted, n, room, room + n, branch, flags + n);
    }
    free(room);
    free(branch);
    free(flags);
    return curve;
}

/* Every fold at F_0; SF_NONE where nothing of the first approximation is there to start from. */
static sf_status sf_second_saddle_nodes(const sf_model *model, const sf_given *given, double F_0, sf_room *room,
                                        sf_second_folds *out)
{
    sf_work *work = &room->work;
    double A, Omega, low = HUGE_VAL, high = 0;
    sf_second_curve *curve;
    sf_status status = sf_settled_peak(model, given == NULL ? NULL : &given->exactly, F_0, work, &A, &Omega);
    int i;
    out->n = out->lost = out->tried = 0, out->status = SF_OK;
    if (status != SF_OK && status != SF_UNBOUNDED)
        return status;
    if (status == SF_OK && Omega > 0)
        low = high = Omega;
    status = sf_make_skeleton(model, given, F_0, room);
    if (status != SF_OK)
        return status;
    for (i = 0; i < work->folds.n; i++)
        low = fmin(low, work->folds.at[i].Omega), high = fmax(high, work->folds.at[i].Omega);
    if (high == 0)
        return SF_OK;
    curve = sf_second_around(model, F_0, SF_FOLDS_ONLY, low, high, work);
    if (curve == NULL)
        return SF_NO_MEMORY;
    sf_folds_on(model, F_0, curve, out);
    sf_second_free(curve);
    return out->status;
}

/* The highest peak at F_0, and its frequency. */
static sf_status sf_second_peak(const sf_model *model, const sf_given *given, double F_0, sf_room *room, double *u_max,
                                double *Omega)
{
    sf_work *work = &room->work;
    sf_second_point top;
    sf_second_curve *curve;
    double A, first;
    sf_status status = sf_settled_peak(model, given == NULL ? NULL : &given->exactly, F_0, work, &A, &first);
    if (status == SF_OK && first == 0)
        status = SF_NONE;
    if (status == SF_OK)
        status = sf_make_skeleton(model, given, F_0, room);
    if (status != SF_OK)
        return status;
    curve = sf_second_around(model, F_0, SF_TOP_ONLY, first, first, work);
    if (curve == NULL)
        return SF_NO_MEMORY;
    status = sf_peak_on(model, F_0, curve, &top) == SF_OK_SECOND ? SF_OK : SF_NONE;
    if (status == SF_OK)
        *u_max = top.at.u_max, *Omega = top.Omega;
    sf_second_free(curve);
    return status;
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
        if (status == SF_OK && sf_second_detach(&model, first[0], first[1], first[2], &F_cr, &Omega_cr) != SF_OK_SECOND)
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
            (first.kind != SF_CUSP_KIND || sf_second_cusp(&model, &first, &found, &u_max) != SF_OK_SECOND))
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
        sf_model model;
        sf_given given;
        double A = NAN, Omega = NAN;
        sf_status status = room == NULL ? SF_NO_MEMORY : SF_INVALID;
        if (room != NULL && mechanism->is_forcing(F_0) && sf_design_at(mechanism, args, steps, k, 1, &model) &&
            sf_has_second(&model))
            status = sf_second_peak(&model, sf_given_at(mechanism, args, steps, k, &given) ? &given : NULL, F_0,
                                    room, &A, &Omega);
        sf_write_peak(args, steps, out, k, A, Omega, status);
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
                &model, sf_given_at(mechanism, args, steps, k, &given) ? &given : NULL, F_0, room, &found));
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

static void sf_many_second_detachment(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_second_detachment, args, dimensions, steps, data);
}

static void sf_many_second_onsets(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_second_onsets, args, dimensions, steps, data);
}

static void sf_many_second_folds(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_second_folds, args, dimensions, steps, data);
}

static void sf_many_second_peaks(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_second_peaks, args, dimensions, steps, data);
}

#endif
