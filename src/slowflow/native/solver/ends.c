/* Means over a cycle over NumPy's operands: of steps at numbers, and by the motion's ends on boxes in charts that are
 * packed into an array (turning_points.h); what vanishes there (balance.h). */
#include <string.h>

#include "balance.h"

#include "solver.h"

#define IN(k) (*(const double *)(operands[k] + i * steps[k]))

/* L_k and M_k of a step, k from -below up to highest, in places from L and M on.
 * whole: whether all of the motion is above it, wherever that is */
static void step_means(double A, double a, int whole, int below, int highest, double *L, double *M)
{
    const double span = (A - a) * (A + a);
    double found[4] = {0, 1, 0, 0}, *L_0 = L + below, *M_0 = M + below;
    for (int k = 0; k <= below + highest; k++)
        L[k] = M[k] = 0;
    if (!whole && a >= A)
        return;
    if (!whole && a > -A) {
        const double root = sqrt(span);
        off_centre_begin(A, a, root, atan2(root, a), found);
        L_0[-1] = found[0], M_0[-1] = found[2];
        L_0[0] = found[1], M_0[0] = found[3];
        for (int k = 0; k > 1 - below; k--) {
            off_centre_down(k, A, a, root, L_0[k - 1], L_0[k], M_0[k - 1], M_0[k], found);
            L_0[k - 2] = found[0], M_0[k - 2] = found[1];
        }
    } else {
        L_0[0] = 1;
    }
    for (int k = 1; k <= highest; k++) {
        off_centre_up(k, A, a, span, L_0[k - 2], L_0[k - 1], M_0[k - 2], M_0[k - 1], found);
        L_0[k] = found[0], M_0[k] = found[1];
    }
}

/* A, a, whether the step is below all of the motion, how many k are negative, room for all k -> L_k, M_k */
void sf_step_means_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    enum { MOST = SF_MOST_POWERS + 8 };
    const int orders = (int)dimensions[1];
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        double L[MOST], M[MOST];
        const int below = (int)IN(3), is_room = orders <= MOST && below > 0 && below < orders;
        if (is_room)
            step_means(IN(0), IN(1), IN(2) != 0, below, orders - 1 - below, L, M);
        for (int k = 0; k < orders; k++) {
            *(double *)(void *)(operands[5] + i * steps[5] + k * steps[8]) = is_room ? L[k] : NAN;
            *(double *)(void *)(operands[6] + i * steps[6] + k * steps[9]) = is_room ? M[k] : NAN;
        }
    }
}

/* charts, low, a point, high, load, number of the chart -> on the box, at the point; any number where there are no such
 * charts, so that nothing is taken to be absent there. */
void sf_ends_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    const double *known = NULL;
    sf_charts charts = {0};
    int is_known = 0;
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const double *packed = (const double *)(const void *)(operands[0] + i * steps[0]), chart = IN(5);
        double box[3][2];
        sf_ended found[2];
        if (packed != known) {
            is_known = steps[7] == (ptrdiff_t)sizeof *packed && sf_read_charts(packed, dimensions[1], &charts);
            known = packed;
        }
        for (int k = 0; k < 6; k++)
            box[k / 2][k % 2] = *(const double *)(operands[1 + k / 2] + i * steps[1 + k / 2] + k % 2 * steps[8 + k / 2]);
        if (is_known && chart >= 0 && chart < charts.charts)
            sf_on_ends(&charts, box[0], box[1], box[2], (int)chart, IN(4), &found[0], &found[1]);
        else
            for (int k = 0; k < 4 * SF_OF_MOTION; k++)
                ((double *)found)[k] = k % 2 ? HUGE_VAL : -HUGE_VAL;
        for (int k = 0; k < 4 * SF_OF_MOTION; k++)
            *(double *)(void *)(operands[6] + i * steps[6] + k * steps[11]) = ((const double *)found)[k];
    }
}

/* A function of numbers in a row, for each element: inputs one after the other, then outputs.
 * sizes -- of the operands, 0 behind the last; core axes, of those above 1, have their strides behind all others */
static void by_rows(void (*call)(const double *in, double *out), int inputs, const int *sizes, char **operands,
                    const ptrdiff_t *dimensions, const ptrdiff_t *steps)
{
    int all = 0;
    while (sizes[all] > 0)
        all++;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        double in[4 * SF_OF_MOTION + 8], out[2 * SF_OF_MOTION], *next = in;
        const ptrdiff_t *core = steps + all;
        for (int operand = 0; operand < all; operand++) {
            char *at = operands[operand] + i * steps[operand];
            const ptrdiff_t step = sizes[operand] > 1 ? *core++ : 0;
            if (operand == inputs)
                call(in, out), next = out;
            for (int k = 0; k < sizes[operand]; k++, at += step, next++)
                if (operand < inputs)
                    *next = *(const double *)(const void *)at;
                else
                    *(double *)(void *)at = *next;
        }
    }
}

#define ROWS_LOOP(name, call, inputs, ...)                                                                    \
    void name(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)               \
    {                                                                                                         \
        static const int sizes[] = {__VA_ARGS__, 0};                                                          \
        (void)data;                                                                                           \
        by_rows(call, inputs, sizes, operands, dimensions, steps);                                            \
    }

static void on_balance(const double *in, double *out)
{
    const struct {
        sf_ended here, middle;
        double low[2], high[2], load, centred;
    } *of = (const void *)in;
    struct {
        double low[2], high[2];
        sf_interval p, resists, rising;
        double some;
    } *found = (void *)out;
    memcpy(out, of->low, sizeof of->low + sizeof of->high);
    found->some = sf_on_balance(&of->here, &of->middle, of->load, of->centred != 0, found->low, found->high, &found->p,
                                &found->resists, &found->rising);
}

static void ended_state(const double *in, double *out)
{
    const struct {
        sf_ended here;
        double Omega, force;
        sf_damping damping;
        double load;
    } *of = (const void *)in;
    sf_ended_state(&of->here, of->Omega, of->force, &of->damping, of->load, (void *)out);
}

static void ended_fold(const double *in, double *out)
{
    const struct {
        sf_ended here;
        sf_interval R;
        double F_0, F_2;
        sf_damping damping;
        double load, centred;
    } *of = (const void *)in;
    sf_ended_fold(&of->here, of->R, of->F_0, of->F_2, &of->damping, of->load, of->centred != 0, (void *)out);
}

static void folds_between(const double *in, double *out)
{
    const struct {
        sf_interval A, p, e;
        sf_damping damping;
        double inertial, sign, lowest, highest;
    } *of = (const void *)in;
    out[2] = sf_folds_between(&of->damping, of->inertial != 0, of->sign, of->A, of->p, of->e, of->lowest, of->highest,
                              (void *)out);
}

/* Sensitivities of answers from what is known there (gradient.h). */
static void slopes_of(const double *in, double *out) { sf_here()->slopes(in, out); }

/* as their signatures in _native.c */
ROWS_LOOP(sf_on_balance_loop, on_balance, 6, 28, 28, 2, 2, 1, 1, 10, 1)
ROWS_LOOP(sf_ended_state_loop, ended_state, 5, 28, 1, 1, 4, 1, 12)
ROWS_LOOP(sf_ended_fold_loop, ended_fold, 7, 28, 2, 1, 1, 4, 1, 1, 26)
ROWS_LOOP(sf_folds_between_loop, folds_between, 8, 2, 2, 2, 4, 1, 1, 1, 1, 2, 1)
ROWS_LOOP(sf_slopes_loop, slopes_of, 1, 26, 6)
