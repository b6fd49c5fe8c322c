/* Batches of response curves. Takes a record and strided arrays; returns the points of each curve, and its folds.
 *
 * Points and folds are those of a single answer. A curve that has more points than there are places is not drawn.
 */
#ifndef SF_MANY_CURVES_H
#define SF_MANY_CURVES_H

#include "many.h"

/* The points of one curve as they are drawn. */
typedef struct {
    double *Omega, *A;
    long long *branch;
    unsigned char *stable;
} sf_points;

/* 0 where there is no memory. */
static int sf_new_points(ptrdiff_t places, sf_points *out) {
    const size_t n = places > 0 ? (size_t)places : 1;
    out->Omega = malloc(n * sizeof *out->Omega), out->A = malloc(n * sizeof *out->A);
    out->branch = malloc(n * sizeof *out->branch), out->stable = malloc(n);
    return out->Omega != NULL && out->A != NULL && out->branch != NULL && out->stable != NULL;
}

static void sf_free_points(sf_points *points) {
    free(points->Omega), free(points->A), free(points->branch), free(points->stable);
}

/* Leaves out those at rest, at which the response to an excitation by inertia begins; returns how many are left. */
static long sf_leave_rest_out(long n, sf_points *points) {
    long i, kept = 0;
    for (i = 0; i < n; i++)
        if (points->A[i] > 0) {
            points->Omega[kept] = points->Omega[i], points->A[kept] = points->A[i];
            points->branch[kept] = points->branch[i], points->stable[kept++] = points->stable[i];
        }
    return kept;
}

/* n points into their places, the others left empty; closed: of each branch. A column at a time: bytes may alias all
 * that a loop over all of them would have to read again at each point. */
static void sf_write_points(char **args, const ptrdiff_t *steps, const ptrdiff_t *inner, int out, ptrdiff_t k,
                            ptrdiff_t places, long n, const sf_points *points, const int *closed)
{
    const double *numbers[] = {points->Omega, points->A};
    const ptrdiff_t of_stable = inner[2], of_branch = inner[3], of_closed = inner[4];
    char *stable = sf_at_place(args, steps, inner, out, 2, k, 0),
         *branch = sf_at_place(args, steps, inner, out, 3, k, 0);
    char *is_closed = sf_at_place(args, steps, inner, out, 4, k, 0);
    ptrdiff_t i;
    int j;
    for (j = 0; j < 2; j++) {
        char *to = sf_at_place(args, steps, inner, out, j, k, 0);
        const ptrdiff_t step = inner[j];
        for (i = 0; i < places; i++)
            *(double *)(void *)(to + i * step) = i < n ? numbers[j][i] : NAN;
    }
    for (i = 0; i < places; i++)
        stable[i * of_stable] = (char)(i < n && points->stable[i]);
    for (i = 0; i < places; i++)
        *(short *)(void *)(branch + i * of_branch) = (short)(i < n ? points->branch[i] : -1);
    for (i = 0; i < places; i++)
        is_closed[i * of_closed] = (char)(i < n && closed[points->branch[i]]);
}

/* design, damping, F_0, samples, low, high -> Omega, A, stable, branch, whether it is closed (points), how many points;
 * Omega, A, kind of folds (places), count, undecided, status */
static void sf_loop_curves(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int at = mechanism->design_size + mechanism->damping_size, out = at + 4, of_folds = out + 6;
    const ptrdiff_t points = dimensions[1], places = dimensions[2], *inner = steps + out + 12;
    sf_room *room = malloc(sizeof *room);
    sf_points drawn;
    const int is_room = sf_new_points(points, &drawn) && room != NULL;
    ptrdiff_t k, i;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = sf_input(args, steps, at, k), samples = sf_input(args, steps, at + 1, k);
        const double low = sf_input(args, steps, at + 2, k), high = sf_input(args, steps, at + 3, k);
        sf_model model;
        sf_given given;
        sf_status status = is_room ? SF_INVALID : SF_NO_MEMORY;
        long n = 0;
        int folds = 0, undecided = 0;
        if (is_room && mechanism->is_forcing(F_0) && sf_design_at(mechanism, args, steps, k, 1, &model)) {
            const sf_given *exact = sf_given_at(mechanism, args, steps, k, &given) ? &given : NULL;
            model.lowest = low;
            status = sf_of_search(sf_make_skeleton(&model, exact, F_0, room));
            if (status == SF_OK) {
                n = sf_show(&model, F_0, low, high, samples, &room->work);
                folds = room->work.folds.n, undecided = room->undecided;
            }
            if (n > points) {
                status = SF_TOO_MANY;
            } else if (n < 0) {
                status = SF_NO_BOUND, n = 0, folds = undecided = 0;
            } else if (status == SF_OK) {
                sf_draw(&model, F_0, samples, &room->work.shown, drawn.Omega, drawn.A, drawn.stable, drawn.branch);
                n = sf_inertial(&model) ? sf_leave_rest_out(n, &drawn) : n;
            }
        }
        sf_write_points(args, steps, inner, out, k, points, n > points ? 0 : n, &drawn,
                        room != NULL ? room->work.shown.closed : NULL);
        *(int *)(void *)(args[out + 5] + k * steps[out + 5]) = (int)n;
        for (i = 0; i < places; i++)
            sf_write_fold(args, steps, inner + 5, of_folds, k, i, i < folds ? &room->work.folds.at[i] : NULL);
        sf_write_count(args, steps, of_folds + 3, k, folds, undecided, places, status);
    }
    sf_free_points(&drawn);
    free(room);
}

#endif
