/* The second approximation's questions at one forcing. Takes a model; returns its curve in a window, its folds and
 * its peak. Averaging's curve, which they begin with, is drawn on the way.
 *
 * inputs: the oscillator's exact inputs, NULL where its numbers are not known; room: a workspace.
 */
#pragma once

#include "states.h"
#include "second_answers.h"

/* The curve in a window, of about so many samples, from the skeleton of room; NULL if there is no memory, or beyond the
 * range of doubles how far averaging's extends. */
static sf_second_curve *sf_second_shown(const sf_model *model, double F_0, sf_wanted extent, double samples, double low,
                                        double high, sf_room *room, sf_status *status) {
    long n = sf_show(model, F_0, low, high, samples, &room->work);
    sf_second_curve *curve = NULL;
    sf_points drawn;
    *status = n < 0 ? SF_NO_BOUND : SF_NO_MEMORY;
    if (sf_new_points(n, &drawn) && n >= 0) {
        n = sf_draw(model, F_0, samples, &room->work.shown, &drawn);
        curve = sf_second_follow(model, F_0, extent, n, &drawn, room->work.shown.closed);
        if (curve != NULL)
            *status = SF_OK;
    }
    sf_free_points(&drawn);
    return curve;
}

/* The same, of any skeleton; to be freed by sf_second_free. */
static sf_second_curve *sf_second_response(const sf_model *model, const sf_inputs *inputs, double F_0, sf_wanted extent,
                                           double samples, double low, double high, sf_room *room, sf_status *status) {
    *status = sf_make_skeleton(model, inputs, F_0, room);
    return *status == SF_OK ? sf_second_shown(model, F_0, extent, samples, low, high, room, status) : NULL;
}

/* The curve about some frequencies and what may lie beside them. */
static sf_second_curve *sf_second_around(const sf_model *model, const sf_inputs *inputs, double F_0, sf_wanted extent,
                                         double low, double high, sf_room *room, sf_status *status) {
    return sf_second_response(model, inputs, F_0, extent, SF_SAMPLES, low / SF_BEYOND, high * SF_BEYOND, room, status);
}

/* Every fold at F_0; `left` says what of averaging's curve is left out, and how much of it was followed: 0 where there
 * is nothing to start from. Whether doubles tell averaging's folds says the room.
 *
 * low, high: frequencies between which averaging's folds and its peak lie; infinite where these are not known */
static sf_status sf_second_saddle_nodes(const sf_model *model, const sf_inputs *inputs, double F_0, double low,
                                        double high, sf_room *room, sf_second_folds *out)
{
    const sf_folds *first = &room->work.folds;
    const int known = high < HUGE_VAL;
    sf_second_curve *curve;
    sf_status status = SF_NONE;
    double A, Omega;
    memset(&out->left, 0, sizeof out->left);
    out->n = out->lost = out->tried = 0, out->status = SF_OK;
    if (!known) {
        high = 0;
        status = sf_settled_peak(model, inputs == NULL ? NULL : &inputs->exactly, F_0, HUGE_VAL, &room->work, &A,
                                 &Omega);
    }
    if (status != SF_OK && status != SF_UNBOUNDED && status != SF_NONE)
        return status;
    if (status == SF_OK && Omega > 0)
        low = high = Omega;
    status = sf_make_skeleton(model, inputs, F_0, room);
    if (status != SF_OK)
        return status;
    for (int i = 0; i < first->n && !known; i++)
        low = fmin(low, first->at[i].Omega), high = fmax(high, first->at[i].Omega);
    if (high == 0)
        return SF_OK;
    curve = sf_second_shown(model, F_0, SF_FOLDS_ONLY, SF_SAMPLES, low / SF_BEYOND, high * SF_BEYOND, room, &status);
    if (curve == NULL)
        return status;
    sf_folds_on(model, F_0, curve, out);
    out->left = curve->left;
    sf_second_free(curve);
    return out->status;
}

/* The highest peak of the curve about a frequency, which is to be freed if there is one. */
static sf_status sf_second_peak(const sf_model *model, const sf_inputs *inputs, double F_0, double near, sf_room *room,
                                sf_second_curve **curve, sf_second_point *top)
{
    sf_status status;
    *curve = sf_second_around(model, inputs, F_0, SF_TOP_ONLY, near, near, room, &status);
    return *curve != NULL && !sf_peak_on(model, F_0, *curve, top) ? SF_NONE : status;
}
