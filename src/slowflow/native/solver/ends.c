/* Means over a cycle over NumPy's operands: of steps at numbers, and by the motion's ends on boxes in charts that are
 * packed into an array (ends.h). */
#include "ends.h"

#include "solver.h"

#define IN(k) (*(const double *)(operands[k] + i * steps[k]))

/* L_k and M_k of a step, k from -below up to highest, in places from L and M on.
 * whole: whether all of the motion is above it, wherever that is */
static void step_means(double A, double a, int whole, int below, int highest, double *L, double *M)
{
    const double span = (A - a) * (A + a);
    double found[4] = {0, 1, 0, 0}, *L_0 = L + below, *M_0 = M + below;
    int k;
    for (k = 0; k <= below + highest; k++)
        L[k] = M[k] = 0;
    if (!whole && a >= A)
        return;
    if (!whole && a > -A) {
        const double root = sqrt(span);
        off_centre_begin(A, a, root, atan2(root, a), found);
        L_0[-1] = found[0], M_0[-1] = found[2];
        L_0[0] = found[1], M_0[0] = found[3];
        for (k = 0; k > 1 - below; k--) {
            off_centre_down(k, A, a, root, L_0[k - 1], L_0[k], M_0[k - 1], M_0[k], found);
            L_0[k - 2] = found[0], M_0[k - 2] = found[1];
        }
    } else {
        L_0[0] = 1;
    }
    for (k = 1; k <= highest; k++) {
        off_centre_up(k, A, a, span, L_0[k - 2], L_0[k - 1], M_0[k - 2], M_0[k - 1], found);
        L_0[k] = found[0], M_0[k] = found[1];
    }
}

/* A, a, whether the step is below all of the motion, how many k are negative, room for all k -> L_k, M_k */
void sf_step_means_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    enum { MOST = SF_MOST_POWERS + 8 };
    const int places = (int)dimensions[1];
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        double L[MOST], M[MOST];
        const int below = (int)IN(3), is_room = places <= MOST && below > 0 && below < places;
        if (is_room)
            step_means(IN(0), IN(1), IN(2) != 0, below, places - 1 - below, L, M);
        for (int k = 0; k < places; k++) {
            *(double *)(void *)(operands[5] + i * steps[5] + k * steps[8]) = is_room ? L[k] : NAN;
            *(double *)(void *)(operands[6] + i * steps[6] + k * steps[9]) = is_room ? M[k] : NAN;
        }
    }
}

/* charts, lo and hi of x, of y, number of the chart -> lower ends, upper ends; NaN where there are no such charts. */
void sf_ends_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    const double *known = NULL;
    sf_charts charts = {0};
    int is_known = 0;
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const double *packed = (const double *)(const void *)(operands[0] + i * steps[0]), chart = IN(5);
        sf_ended found;
        const sf_interval *of = &found.A;
        if (packed != known) {
            is_known = steps[8] == (ptrdiff_t)sizeof *packed && sf_read_charts(packed, dimensions[1], &charts);
            known = packed;
        }
        const int is_chart = is_known && chart >= 0 && chart < charts.charts;
        if (is_chart)
            sf_on_ends(&charts, sfi_of(IN(1), IN(2)), sfi_of(IN(3), IN(4)), (int)chart, &found);
        for (int j = 0; j < SF_OF_MOTION; j++) {
            *(double *)(void *)(operands[6] + i * steps[6] + j * steps[9]) = is_chart ? of[j].lo : NAN;
            *(double *)(void *)(operands[7] + i * steps[7] + j * steps[10]) = is_chart ? of[j].hi : NAN;
        }
    }
}

/* How answers move that are told by what is known there (gradient.h). */
void sf_moved_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    sf_here()->told(operands, dimensions, steps, data);
}
