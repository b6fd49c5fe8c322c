/* Gradients: in goes an answer with what it is, out come its moves with each number that a user gives.
 *
 * The moves are generated (slow_flow_moves_of_...), in what one number does to h, m, zeta, breakpoint, forcing and
 * frequency; by the chain rule from the design to the force's parameters to the average.
 */
#ifndef SF_GRADIENT_H
#define SF_GRADIENT_H

#include "interface.h"
#include "many.h"

enum {
    SF_MOVES = 3,      /* of A, Omega and F_0 */
    SF_STATE_MOVES = 5 /* and of phase and transmissibility */
};

/* What a number that a user gives does. */
typedef struct {
    double h[3], m, zeta, end, forcing, frequency;
} sf_cause;

/* Whether a value has lost its sign to rounding, as far as a share of its size says. */
static inline int sf_vanishes(double value, double size, double share) {
    return !(fabs(value) > share * size);
}

/* Which of the answers on a breakpoint an onset there is: whatever comes next to vanishing. */
static sf_pinned sf_pinned_on_break(const double *beside) {
    static const sf_pinned kinds[] = {SF_CORNER_END_PINNED, SF_CORNER_TOP_PINNED, SF_CORNER_BACKBONE_PINNED};
    int best = 0, i;
    for (i = 1; i < 3; i++)
        if (fabs(beside[2 * i]) * beside[2 * best + 1] < fabs(beside[2 * best]) * beside[2 * i + 1])
            best = i;
    return kinds[best];
}

static int sf_is_on_break(sf_pinned kind) {
    return kind == SF_CORNER_FOLD_PINNED || kind == SF_CORNER_TOP_PINNED || kind == SF_CORNER_END_PINNED ||
           kind == SF_CORNER_BACKBONE_PINNED || kind == SF_CORNER_REST_PINNED;
}

/* Whether an answer that is on no breakpoint has come to one. States and peaks ask for h_A, which jumps there where the
 * force does; the others for h_AA, which grows without bound next to it too. */
static int sf_comes_to_break(const sf_model *model, sf_pinned kind, double A) {
    const int first = kind == SF_STATE_PINNED || kind == SF_PEAK_PINNED;
    int k;
    for (k = 0; k < model->breaks; k++)
        if (fabs(A - model->b[k]) <= (first ? SF_SAME : SF_COINCIDE) * model->b[k] && (!first || model->jump[k] != 0))
            return 1;
    return 0;
}

/* Whether the forcing is one of the numbers found. */
static int sf_finds_forcing(sf_pinned kind) {
    return kind >= SF_CUSP_PINNED; /* those before are at a forcing */
}

static int sf_nearest_break(const sf_model *model, double A) {
    int best = 0, k;
    for (k = 1; k < model->breaks; k++)
        if (fabs(A - model->b[k]) < fabs(A - model->b[best]))
            best = k;
    return best;
}

static void sf_move(sf_pinned kind, const sf_model *model, double w, const sf_sample *at, double F_0,
                    const sf_cause *of, double *out)
{
#define SF_MOVES_OF(name)                                                                                              \
    slow_flow_moves_of_##name(w, at->A, F_0, model->m, model->zeta, at->h, at->h_A, at->h_AA, at->h_AAA, of->h[0],     \
                              of->h[1], of->h[2], of->m, of->zeta, of->end, of->forcing, of->frequency, out)
    switch (kind) {
    case SF_STATE_PINNED: SF_MOVES_OF(state); return;
    case SF_FOLD_PINNED: SF_MOVES_OF(fold); return;
    case SF_CORNER_FOLD_PINNED: SF_MOVES_OF(corner_fold); return;
    case SF_PEAK_PINNED: SF_MOVES_OF(peak); return;
    case SF_CUSP_PINNED: SF_MOVES_OF(cusp); return;
    case SF_ISOLA_PINNED: SF_MOVES_OF(isola); return;
    case SF_CORNER_TOP_PINNED: SF_MOVES_OF(corner_top); return;
    case SF_CORNER_END_PINNED: SF_MOVES_OF(corner_end); return;
    case SF_CORNER_BACKBONE_PINNED: SF_MOVES_OF(corner_backbone); return;
    case SF_CORNER_REST_PINNED: SF_MOVES_OF(corner_rest); return;
    }
#undef SF_MOVES_OF
}

/* The number of that column does this: those of the design first, then mu, zeta, F_0 and Omega. */
static void sf_cause_of(const sf_model *model, int column, int piece, const double *by_parameter,
                        const double *by_design, sf_cause *out)
{
    const sf_mechanism *mechanism = model->mechanism;
    const int design = mechanism->design_size;
    int i, k;
    memset(out, 0, sizeof *out);
    if (column < design) {
        for (k = 0; k < mechanism->parameters; k++)
            for (i = 0; i < 3; i++)
                out->h[i] += by_parameter[3 * k + i] * by_design[k * design + column];
        if (mechanism->breakpoints > 0)
            out->end = by_design[(mechanism->parameters + piece) * design + column];
        return;
    }
    switch (column - design) {
    case 0: out->m = slow_flow_friction(1); return; /* to which it is proportional */
    case 1: out->zeta = 1; return;
    case 2: out->forcing = 1; return;
    default: out->frequency = 1; return;
    }
}

/* How the answer (Omega, A) of that kind at the forcing F_0 moves with each of so many numbers: row i of column j goes
 * to out[i * columns + j]. CORNER_END stands for any onset on a breakpoint. */
static sf_moves_status sf_gradient(const sf_model *model, const double *design, sf_pinned kind, double Omega, double A,
                                   double F_0, int rows, int columns, double *out) {
    const sf_mechanism *mechanism = model->mechanism;
    double of_parameter[3 * SF_MOST_PARAMETERS];
    double of_design[SF_MOST_DESIGN * (SF_MOST_PARAMETERS + SF_MOST_BREAKS)];
    sf_moves_status status = SF_OK_MOVES;
    sf_sample at;
    double averaged[3], beside[6];
    int i, j, piece = 0;
    for (i = 0; i < rows * columns; i++)
        out[i] = NAN;
    if (sf_is_on_break(kind)) {
        if (model->breaks == 0)
            return SF_NOTHING_MOVES;
        piece = sf_nearest_break(model, A);
        A = model->b[piece];
        /* breakpoints of no width are left out of the model, and lie below the others */
        piece += mechanism->breakpoints - model->breaks;
    } else if (sf_comes_to_break(model, kind, A)) {
        return SF_TURNS_MOVES;
    }
    sf_sample_at(model, A, &at);
    slow_flow_beside(Omega, at.A, F_0, model->m, model->zeta, at.h, at.h_A, beside);
    if (sf_finds_forcing(kind) && sf_vanishes(F_0, beside[5], SF_MEETING))
        return SF_BOUNDLESS_MOVES; /* neither friction nor damping: a level at 0 rises with either */
    if (kind == SF_CORNER_FOLD_PINNED &&
        (sf_vanishes(beside[0], beside[1], SF_CLOSE) || sf_vanishes(beside[4], beside[5], SF_CLOSE)))
        return SF_TURNS_MOVES;
    if (kind == SF_CORNER_END_PINNED)
        kind = sf_pinned_on_break(beside);
    averaged[0] = at.h, averaged[1] = at.h_A, averaged[2] = at.h_AA;
    mechanism->by_parameter(at.A, averaged, model->p, of_parameter);
    mechanism->by_design(design, of_design);
    for (j = 0; j < columns; j++) {
        double found[SF_MOVES + 4] = {NAN, NAN, NAN, NAN, NAN, NAN, NAN};
        sf_cause cause;
        sf_cause_of(model, j, piece, of_parameter, of_design, &cause);
        sf_move(kind, model, Omega, &at, F_0, &cause, found);
        if (sf_vanishes(found[3], found[4], SF_MEETING) || sf_vanishes(found[5], found[6], SF_MEETING)) {
            status = SF_MEETS_MOVES;
            break;
        }
        for (i = 0; i < SF_MOVES; i++)
            out[i * columns + j] = found[i];
        if (rows == SF_STATE_MOVES) {
            slow_flow_moves_of_phase(Omega, at.A, F_0, model->m, model->zeta, at.h, at.h_A, cause.h[0], cause.m,
                                     cause.zeta, found[0], found[1], found[2], found + SF_MOVES);
            out[3 * columns + j] = found[3], out[4 * columns + j] = found[4];
        }
        for (i = 0; i < rows; i++)
            if (!isfinite(out[i * columns + j]))
                status = SF_BOUNDLESS_MOVES;
    }
    if (status != SF_OK_MOVES)
        for (i = 0; i < rows * columns; i++)
            out[i] = NAN;
    return status;
}

/* design, damping, F_0, Omega, A, what it is (a number of sf_pinned) -> moves (rows, columns), status; see
 * sf_gradient */
static void sf_loop_gradients(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const sf_mechanism *mechanism = data;
    const int first = mechanism->design_size + mechanism->damping_size, moves = first + 4;
    const int rows = (int)dimensions[1], columns = (int)dimensions[2];
    const ptrdiff_t *inner = steps + moves + 2;
    double out[SF_STATE_MOVES * (SF_MOST_DESIGN + SF_MOST_DAMPING + 2)];
    ptrdiff_t k;
    int i, j;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = sf_input(args, steps, first, k), Omega = sf_input(args, steps, first + 1, k),
                     A = sf_input(args, steps, first + 2, k);
        double design[SF_MOST_DESIGN];
        sf_model model;
        sf_moves_status status = SF_NOTHING_MOVES;
        for (i = 0; i < mechanism->design_size; i++)
            design[i] = sf_input(args, steps, i, k);
        for (i = 0; i < rows * columns; i++)
            out[i] = NAN;
        if (mechanism->by_parameter != NULL && A > 0 && A < HUGE_VAL && Omega >= 0 && Omega < HUGE_VAL && F_0 >= 0 &&
            F_0 < HUGE_VAL && sf_design_at(mechanism, args, steps, k, 1, &model))
            status = sf_gradient(&model, design, (sf_pinned)sf_input(args, steps, first + 3, k), Omega, A, F_0, rows,
                                 columns, out);
        for (i = 0; i < rows; i++)
            for (j = 0; j < columns; j++)
                *(double *)(void *)(args[moves] + k * steps[moves] + i * inner[0] + j * inner[1]) =
                    out[i * columns + j];
        sf_output_code(args, steps, moves + 1, k, status);
    }
}

static void sf_many_gradients(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_gradients, args, dimensions, steps, data);
}

#endif
