/* The second approximation's questions at one forcing: in goes a model, out come its curve in a window, its folds and
 * its peak. Averaging's curve, which they begin with, is drawn on the way.
 *
 * given: the oscillator as it was given, NULL where its numbers are not known; room: a workspace.
 */
#ifndef SF_SECOND_QUESTIONS_H
#define SF_SECOND_QUESTIONS_H

#include "second_answers.h"

/* Takes out points at which the mass is at rest, as where the response to an excitation by inertia begins; how many are
 * left. */
static long sf_moving(long n, double *Omega, double *A, long long *branch) {
    long i, left = 0;
    for (i = 0; i < n; i++)
        if (A[i] > 0)
            Omega[left] = Omega[i], A[left] = A[i], branch[left++] = branch[i];
    return left;
}

/* The curve in a window, of about so many samples, from the skeleton of room; NULL if there is no memory, or beyond the
 * range of doubles how far averaging's extends. */
static sf_second_curve *sf_second_shown(const sf_model *model, double F_0, sf_wanted wanted, double samples, double low,
                                        double high, sf_room *room, sf_status *status) {
    sf_work *work = &room->work;
    long n = sf_show(model, F_0, low, high, samples, work);
    double *Omega = malloc((size_t)(2 * (n < 0 ? 0 : n) + 1) * sizeof *Omega);
    long long *branch = malloc((size_t)((n < 0 ? 0 : n) + 1) * sizeof *branch);
    unsigned char *flags = malloc((size_t)((n < 0 ? 0 : n) + work->shown.curves + 1));
    sf_second_curve *curve = NULL;
    *status = n < 0 ? SF_NO_BOUND : SF_NO_MEMORY;
    if (n >= 0 && Omega != NULL && branch != NULL && flags != NULL) {
        int i;
        double *A = Omega + n;
        unsigned char *closed = flags + n;
        sf_draw(model, F_0, samples, &work->shown, Omega, A, flags, branch);
        for (i = 0; i < work->shown.curves; i++)
            closed[i] = (unsigned char)work->shown.closed[i];
        n = sf_moving(n, Omega, A, branch);
        curve = sf_second_follow(model, F_0, wanted, n, Omega, A, branch, closed);
        if (curve != NULL)
            *status = SF_OK;
    }
    free(Omega);
    free(branch);
    free(flags);
    return curve;
}

/* The same, of any skeleton; to be freed by sf_second_free. */
static sf_second_curve *sf_second_response(const sf_model *model, const sf_given *given, double F_0, sf_wanted wanted,
                                           double samples, double low, double high, sf_room *room, sf_status *status) {
    *status = sf_make_skeleton(model, given, F_0, room);
    return *status == SF_OK ? sf_second_shown(model, F_0, wanted, samples, low, high, room, status) : NULL;
}

/* The curve about some frequencies and what may lie beside them, from the skeleton of room. */
static sf_second_curve *sf_second_around(const sf_model *model, double F_0, sf_wanted wanted, double low, double high,
                                         sf_room *room, sf_status *status) {
    return sf_second_shown(model, F_0, wanted, SF_SAMPLES, low / SF_BEYOND, high * SF_BEYOND, room, status);
}

/* Every fold at F_0; beside says what of averaging's curve is left out, and how much of it was followed: 0 where there
 * is nothing to start from. Whether doubles tell averaging's folds says the room. */
static sf_status sf_second_saddle_nodes(const sf_model *model, const sf_given *given, double F_0, sf_room *room,
                                        sf_second_folds *out)
{
    const sf_work *work = &room->work;
    double A, Omega, low = HUGE_VAL, high = 0;
    sf_second_curve *curve;
    sf_status status = sf_settled_peak(model, given == NULL ? NULL : &given->exactly, F_0, HUGE_VAL, &room->work, &A, &Omega);
    int i;
    memset(&out->left, 0, sizeof out->left);
    out->n = out->lost = out->tried = 0, out->status = SF_OK;
    if (status != SF_OK && status != SF_UNBOUNDED && status != SF_NONE)
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
    curve = sf_second_around(model, F_0, SF_FOLDS_ONLY, low, high, room, &status);
    if (curve == NULL)
        return status;
    sf_folds_on(model, F_0, curve, out);
    out->left = curve->left;
    sf_second_free(curve);
    return out->status;
}

/* The highest peak at F_0, and its frequency. */
static sf_status sf_second_peak(const sf_model *model, const sf_given *given, double F_0, sf_room *room, double *u_max,
                                double *Omega)
{
    sf_second_point top;
    sf_second_curve *curve;
    double A, first;
    sf_status status = sf_settled_peak(model, given == NULL ? NULL : &given->exactly, F_0, HUGE_VAL, &room->work, &A, &first);
    if (status == SF_OK && first == 0)
        status = SF_NONE;
    if (status == SF_OK)
        status = sf_make_skeleton(model, given, F_0, room);
    if (status != SF_OK)
        return status;
    curve = sf_second_around(model, F_0, SF_TOP_ONLY, first, first, room, &status);
    if (curve == NULL)
        return status;
    status = sf_peak_on(model, F_0, curve, &top) == SF_OK_SECOND ? SF_OK : SF_NONE;
    if (status == SF_OK)
        *u_max = top.at.u_max, *Omega = top.Omega;
    sf_second_free(curve);
    return status;
}

#endif
