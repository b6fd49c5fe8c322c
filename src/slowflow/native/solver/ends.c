/* Means over a cycle over NumPy's operands: of steps at numbers, and by the motion's ends on boxes in charts that are
 * packed into an array (turning_points.h); what vanishes there (balance.h), as a search in boxes takes it (boxes.h). */
#include <string.h>

#include "balance.h"
#include "boxes.h"
#include "curved.h"

#include "solver.h"

#define IN(k) (*(const double *)(operands[k] + i * steps[k]))

/* L_k and M_k of a step, k from -below up to highest, in places from L and M on.
 * whole: whether all of the motion is above it, wherever that is */
static void step_means(double A, double a, int whole, int below, int highest, double *L, double *M) {
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
void sf_step_means_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
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

/* Numbers of an operand of size n, one after the other. */
static const double *numbers_of(const char *at, ptrdiff_t step, ptrdiff_t n, double *out) {
    for (ptrdiff_t k = 0; k < n; k++, at += step)
        out[k] = *(const double *)(const void *)at;
    return out;
}

/* A box in a chart, what is known on it and in its middle, and what else a loop takes. */
typedef struct {
    sf_ended here, middle;
    double low[SF_MOST_UNKNOWNS], high[SF_MOST_UNKNOWNS], load, more[8];
} sf_on_box;

enum { SF_OF_BOX = 6, SF_OF_SYSTEM = sizeof(sf_values) / sizeof(double), SF_MOST_OUT = 4 * SF_OF_MOTION };

/* A function of boxes, for each: charts, low, high, chart, load, what else the force has or nothing, then numbers of
 * these sizes, 0 behind the last -> so many numbers. Where there are no such charts any number is allowed, so that
 * nothing is taken to be absent there. */
static void by_boxes(void (*call)(const sf_on_box *in, double *out), const int *sizes, int outputs, char **operands,
                     const ptrdiff_t *dimensions, const ptrdiff_t *steps) {
    const double *known = NULL;
    const ptrdiff_t d = dimensions[2], size = dimensions[3];
    sf_charts charts = {0};
    sf_curved curved = {0};
    int all = SF_OF_BOX, is_known = 0;
    while (sizes[all - SF_OF_BOX] > 0)
        all++;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const double *packed = (const double *)(const void *)(operands[0] + i * steps[0]);
        const double chart = IN(3), load = IN(4);
        const ptrdiff_t *core = steps + all + 1;
        double out[SF_MOST_OUT], *more;
        sf_on_box in = {0};
        if (packed != known) {
            is_known = core[0] == (ptrdiff_t)sizeof *packed && sf_read_charts(packed, dimensions[1], &charts);
            sf_leave_curved(&curved);
            if (size > 0)
                is_known = is_known && core[3] == (ptrdiff_t)sizeof *packed &&
                           sf_read_curved((const double *)(const void *)operands[5], size, &curved);
            known = packed;
        }
        numbers_of(operands[1] + i * steps[1], core[1], d, in.low);
        numbers_of(operands[2] + i * steps[2], core[2], d, in.high);
        in.load = load, more = in.more, core += 4;
        for (int operand = SF_OF_BOX; operand < all; more += sizes[operand++ - SF_OF_BOX])
            numbers_of(operands[operand] + i * steps[operand], sizes[operand - SF_OF_BOX] > 1 ? *core++ : 0,
                       sizes[operand - SF_OF_BOX], more);
        if (is_known && chart >= 0 && chart < charts.charts) {
            const double at[2] = {0.5 * (in.low[0] + in.high[0]), 0.5 * (in.low[1] + in.high[1])};
            sf_on_ends(&charts, in.low, at, in.high, (int)chart, size ? NAN : load, &in.here, &in.middle);
            if (size > 0)
                sf_add_curved(&curved, &charts, (int)chart, in.low, at, in.high, &in.here, &in.middle);
        } else
            for (int k = 0; k < 4 * SF_OF_MOTION; k++)
                ((double *)&in)[k] = k % 2 ? HUGE_VAL : -HUGE_VAL;
        call(&in, out);
        for (int k = 0; k < outputs; k++)
            *(double *)(void *)(operands[all] + i * steps[all] + k * *core) = out[k];
    }
    sf_leave_curved(&curved);
}

/* a force without its steps, A, B, orders -> c_n and s_n, NaN for others */
void sf_curved_means_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const double *packed = (const double *)(const void *)operands[0];
    sf_curved of = {0};
    const int is_known = steps[5] == (ptrdiff_t)sizeof *packed && sf_read_curved(packed, dimensions[1], &of);
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const int orders = (int)IN(3);
        double found[2 * SF_CURVED_ORDERS];
        for (int k = 0; k < 2 * SF_CURVED_ORDERS; k++)
            found[k] = NAN;
        if (is_known && orders >= 0 && orders < of.orders)
            sf_curved_means(&of, IN(1), IN(2), orders, found, found + SF_CURVED_ORDERS);
        for (int k = 0; k < 2 * SF_CURVED_ORDERS; k++)
            *(double *)(void *)(operands[4] + i * steps[4] + k * steps[6]) = found[k];
    }
    sf_leave_curved(&of);
}

/* a force without its steps, low, high -> what holds it and three derivatives in between, all numbers for others */
void sf_curved_between_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const double *packed = (const double *)(const void *)operands[0];
    sf_curved of = {0};
    const int is_known =
        steps[4] == (ptrdiff_t)sizeof *packed && sf_read_curved(packed, dimensions[1], &of) && of.enclosed;
    (void)data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const double low = IN(1), high = IN(2);
        sf_interval found[SF_CURVED_ORDERS][SF_BOX_PANELS];
        if (is_known)
            sf_curved_between(&of, 1, &low, &high, found);
        for (int k = 0; k < 2 * SF_CURVED_ORDERS; k++) {
            const sf_interval one = is_known ? found[k / 2][0] : sf_any_number;
            *(double *)(void *)(operands[3] + i * steps[3] + k * steps[5]) = k % 2 ? one.hi : one.lo;
        }
    }
    sf_leave_curved(&of);
}

/* inputs or outputs of a row at most */
enum { SF_MOST_OF_ROW = 40 };

/* A function of numbers in a row, for each element: inputs one after the other, then outputs.
 * sizes -- of the operands, 0 behind the last; core axes, of those above 1, have their strides behind all others */
static void by_rows(void (*call)(const double *in, double *out), int inputs, const int *sizes, char **operands,
                    const ptrdiff_t *dimensions, const ptrdiff_t *steps) {
    int all = 0;
    while (sizes[all] > 0)
        all++;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        double in[SF_MOST_OF_ROW], out[SF_MOST_OF_ROW], *next = in;
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

#define BOXES_LOOP(name, call, outputs, ...)                                                                           \
    void name(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {                      \
        static const int sizes[] = {__VA_ARGS__, 0};                                                                   \
        (void)data;                                                                                                    \
        by_boxes(call, sizes, outputs, operands, dimensions, steps);                                                   \
    }

#define ROWS_LOOP(name, call, inputs, ...)                                                                             \
    void name(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {                      \
        static const int sizes[] = {__VA_ARGS__, 0};                                                                   \
        (void)data;                                                                                                    \
        by_rows(call, inputs, sizes, operands, dimensions, steps);                                                     \
    }

static void ends(const sf_on_box *in, double *out) { memcpy(out, in, sizeof in->here + sizeof in->middle); }

/* more: whether motions about the centre are there */
static void on_balance(const sf_on_box *in, double *out) {
    struct {
        double low[2], high[2];
        sf_interval p, resists, rising, A, B;
        double some;
    } *found = (void *)out;
    memcpy(found->low, in->low, sizeof found->low), memcpy(found->high, in->high, sizeof found->high);
    found->A = in->here.A, found->B = in->here.B;
    found->some = sf_on_balance(&in->here, &in->middle, in->load, in->more[0] != 0, found->low, found->high, &found->p,
                                &found->resists, &found->rising);
}

/* Values at the middle and on the box and slopes on it, from d of each and d d of these, for a search in boxes. */
static void of_system(int d, const sf_on_box *in, const sf_interval *middle, const sf_interval *here, sf_values *out) {
    int wide = 1;
    for (int i = 0; i < d; i++) {
        out->at[i] = middle[i], out->on[i] = here[i], out->holds[i] = sfi_of(-HUGE_VAL, HUGE_VAL);
        for (int j = 0; j < d; j++)
            out->slope[i][j] = here[d + d * i + j];
        wide &= in->low[i] < in->high[i];
    }
    if (wide && in->here.A.hi <= 0) /* no motion is there */
        out->on[0] = sfi_point(1);
}

/* more: Omega, the force and the damping */
static void ended_state(const sf_on_box *in, double *out) {
    sf_interval middle[6], here[6];
    sf_ended_state(&in->middle, in->more[0], in->more[1], (const void *)&in->more[2], in->load, middle);
    sf_ended_state(&in->here, in->more[0], in->more[1], (const void *)&in->more[2], in->load, here);
    of_system(2, in, middle, here, (void *)out);
}

/* more: F_0 and F_2, the damping, and whether motions about the centre are there */
static void ended_fold(const sf_on_box *in, double *out) {
    const sf_interval R = {in->low[2], in->high[2]}, at = sfi_point(0.5 * (R.lo + R.hi));
    const double *of = in->more;
    sf_interval middle[13], here[13];
    sf_ended_fold(&in->middle, at, of[0], of[1], (const void *)&of[2], in->load, of[6] != 0, middle);
    sf_ended_fold(&in->here, R, of[0], of[1], (const void *)&of[2], in->load, of[6] != 0, here);
    of_system(3, in, middle, here, (void *)out);
    ((sf_values *)(void *)out)->holds[2] = here[12];
}

/* more: the edge, 0 for x = 0 and 1 for y = 0 */
static void ended_edge(const sf_on_box *in, double *out) {
    const sf_interval load = sfi_point(in->load), slope = in->more[0] != 0 ? in->here.c_x : in->here.c_y;
    const sf_interval middle = sfi_sub(in->middle.c_0, load), here[2] = {sfi_sub(in->here.c_0, load), slope};
    of_system(1, in, &middle, here, (void *)out);
}

static void folds_between(const double *in, double *out) {
    const struct {
        sf_interval A, p, e;
        sf_damping damping;
        double inertial, sign, lowest, highest;
    } *of = (const void *)in;
    out[2] = sf_folds_between(&of->damping, of->inertial != 0, of->sign, of->A, of->p, of->e, of->lowest, of->highest,
                              (void *)out);
}

static void may_be_state(const double *in, double *out) {
    const struct {
        sf_interval A, p;
        double Omega, force;
        sf_damping damping;
    } *of = (const void *)in;
    *out = sf_may_be_state(&of->damping, of->Omega, of->force, of->A, of->p);
}

/* Sensitivities of answers from what is known there (gradient.h). */
static void slopes_of(const double *in, double *out) { sf_here()->slopes(in, out); }

/* as their signatures in _native.c */
BOXES_LOOP(sf_ends_loop, ends, SF_MOST_OUT, 0)
BOXES_LOOP(sf_on_balance_loop, on_balance, 15, 1)
BOXES_LOOP(sf_ended_state_loop, ended_state, SF_OF_SYSTEM, 1, 1, 4)
BOXES_LOOP(sf_ended_fold_loop, ended_fold, SF_OF_SYSTEM, 1, 1, 4, 1)
BOXES_LOOP(sf_ended_edge_loop, ended_edge, SF_OF_SYSTEM, 1)
ROWS_LOOP(sf_may_be_state_loop, may_be_state, 5, 2, 2, 1, 1, 4, 1)
ROWS_LOOP(sf_folds_between_loop, folds_between, 8, 2, 2, 2, 4, 1, 1, 1, 1, 2, 1)
ROWS_LOOP(sf_slopes_loop, slopes_of, 1, 33, 6)
