/* Batches of response curves. Takes a record and strided arrays; returns the points of each curve, and its folds.
 *
 * Points and folds are those of a single answer. A curve that has more points than there are places is not drawn.
 */
#pragma once

#include "many.h"

/* n points into their places, the others left empty; closed: of each branch. A column at a time: bytes may alias all
 * that a loop over all of them would have to read again at each point. */
static void sf_write_points(const sf_call *at, long n, const sf_points *points, const int *closed)
{
    const double *numbers[] = {points->Omega, points->A};
    const ptrdiff_t max_count = at->dimensions[1], of_stable = at->inner[2], of_branch = at->inner[3],
                    of_closed = at->inner[4];
    char *stable = sf_output(at, 2), *branch = sf_output(at, 3), *is_closed = sf_output(at, 4);
    for (int j = 0; j < 2; j++) {
        char *to = sf_output(at, j);
        const ptrdiff_t step = at->inner[j];
        for (ptrdiff_t i = 0; i < max_count; i++)
            *(double *)(void *)(to + i * step) = i < n ? numbers[j][i] : NAN;
    }
    for (ptrdiff_t i = 0; i < max_count; i++)
        stable[i * of_stable] = (char)(i < n && points->stable[i]);
    for (ptrdiff_t i = 0; i < max_count; i++)
        *(short *)(void *)(branch + i * of_branch) = (short)(i < n ? points->branch[i] : -1);
    for (ptrdiff_t i = 0; i < max_count; i++)
        is_closed[i * of_closed] = (char)(i < n && closed[points->branch[i]]);
}

static void sf_loop_curves(sf_call *at) {
    static const sf_batch with_folds = {.types = "DDKnbb"};
    const ptrdiff_t points = at->dimensions[1];
    sf_call of_folds = *at;
    sf_query q = {.room = malloc(sizeof(sf_room))};
    sf_points drawn;
    const int is_room = sf_new_points(points, &drawn) && q.room != NULL;
    of_folds.row = &with_folds, of_folds.out += 6, of_folds.dimensions++, of_folds.inner += 5;
    for (at->k = 0; at->k < at->dimensions[0]; at->k++) {
        sf_model model;
        sf_inputs inputs;
        sf_status status = is_room ? SF_INVALID : SF_NO_MEMORY;
        long n = 0;
        if (is_room && sf_prepare_query(at, &model, &inputs, &q)) {
            const double F_0 = q.number[0], samples = q.number[1];
            model.lowest = q.number[2];
            status = sf_make_skeleton(&model, q.inputs, F_0, q.room);
            if (status == SF_OK && (n = sf_show(&model, F_0, q.number[2], q.number[3], samples, &q.room->work)) < 0)
                status = SF_NO_BOUND, n = 0;
            if (n > 0 && n <= points)
                n = sf_draw(&model, F_0, samples, &q.room->work.shown, &drawn);
        }
        sf_write_points(at, n > points ? 0 : n, &drawn, q.room != NULL ? q.room->work.shown.closed : NULL);
        *(int *)(void *)sf_output(at, 5) = (int)n;
        if (q.room != NULL)
            sf_put_folds(&q, status, &q.room->work.folds, status == SF_OK && q.room->undecided);
        else
            sf_put(&q, SF_INTEGER, status);
        of_folds.k = at->k;
        sf_write_answer(&of_folds, &q);
        if (n > points)
            *sf_output(at, 11) = SF_TOO_MANY;
    }
    sf_free_points(&drawn);
    free(q.room);
}
