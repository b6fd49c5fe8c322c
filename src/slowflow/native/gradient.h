/* Gradients: in goes an answer with what it is, out come its moves with each number that a user gives.
 *
 * The moves are generated (slow_flow_moves_of_..., inertia_moves_of_...), in what one number does to h, m, zeta,
 * breakpoint, forcing and frequency; by the chain rule from the design to the force's parameters to the average. What
 * every number does is computed in one loop.
 */
#ifndef SF_GRADIENT_H
#define SF_GRADIENT_H

#include "interface.h"
#include "many.h"

enum {
    SF_MOVES = 3,      /* of A, Omega and F_0 */
    SF_STATE_MOVES = 5, /* of A, phase and transmissibility, then of Omega and F_0 */
    SF_BESIDE_MOVES = 4, /* what must not vanish, each with its size */
    SF_MOST_COLUMNS = SF_MOST_DESIGN + SF_MOST_DAMPING + 2
};

/* What each number that a user gives does. */
typedef struct {
    double h[3][SF_MOST_COLUMNS], m[SF_MOST_COLUMNS], zeta[SF_MOST_COLUMNS], end[SF_MOST_COLUMNS];
    double forcing[SF_MOST_COLUMNS], frequency[SF_MOST_COLUMNS];
} sf_causes;

/* An answer: where it is, what it is, and by what it is excited. */
typedef struct {
    sf_pinned kind;
    int inertial;
    double Omega, F_0;
    sf_sample at;
} sf_pinned_answer;

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

/* Row i of column j goes to out[i][j]; the last rows are what must not vanish, the same for all. */
static SF_FLAT void sf_move(const sf_pinned_answer *answer, const sf_model *model, const sf_causes *of, int columns,
                            double out[SF_MOVES + SF_BESIDE_MOVES][SF_MOST_COLUMNS])
{
    const sf_sample *at = &answer->at;
    const double w = answer->Omega, F_0 = answer->F_0;
    double found[SF_MOVES + SF_BESIDE_MOVES];
    int i, j;
#define SF_MOVES_OF(moves_of)                                                                                          \
    for (j = 0; j < columns; j++) {                                                                                    \
        moves_of(w, at->A, F_0, model->m, model->zeta, at->h, at->h_A, at->h_AA, at->h_AAA, of->h[0][j], of->h[1][j],  \
                 of->h[2][j], of->m[j], of->zeta[j], of->end[j], of->forcing[j], of->frequency[j], found);             \
        for (i = 0; i < SF_MOVES + SF_BESIDE_MOVES; i++)                                                               \
            out[i][j] = found[i];                                                                                      \
    }
#define SF_BY(by_force, by_inertia)                                                                                    \
    if (answer->inertial)                                                                                              \
        SF_MOVES_OF(by_inertia)                                                                                        \
    else                                                                                                               \
        SF_MOVES_OF(by_force)
    switch (answer->kind) {
    case SF_STATE_PINNED: SF_BY(slow_flow_moves_of_state, inertia_moves_of_state) return;
    case SF_FOLD_PINNED: SF_BY(slow_flow_moves_of_fold, inertia_moves_of_fold) return;
    case SF_CORNER_FOLD_PINNED: SF_BY(slow_flow_moves_of_corner_fold, inertia_moves_of_corner_fold) return;
    case SF_PEAK_PINNED: SF_BY(slow_flow_moves_of_peak, inertia_moves_of_peak) return;
    case SF_CUSP_PINNED: SF_BY(slow_flow_moves_of_cusp, inertia_moves_of_cusp) return;
    case SF_ISOLA_PINNED: SF_BY(slow_flow_moves_of_isola, inertia_moves_of_isola) return;
    case SF_CORNER_TOP_PINNED: SF_BY(slow_flow_moves_of_corner_top, inertia_moves_of_corner_top) return;
    case SF_CORNER_END_PINNED: SF_BY(slow_flow_moves_of_corner_end, inertia_moves_of_corner_end) return;
    case SF_CORNER_BACKBONE_PINNED: SF_BY(slow_flow_moves_of_corner_backbone, inertia_moves_of_corner_backbone) return;
    case SF_CORNER_REST_PINNED: SF_BY(slow_flow_moves_of_corner_rest, inertia_moves_of_corner_rest) return;
    }
#undef SF_BY
#undef SF_MOVES_OF
}

/* How the phase and what a state transmits move, from how the state does. */
static SF_FLAT void sf_move_phase(const sf_pinned_answer *answer, const sf_model *model, const sf_causes *of,
                                  int columns,
                                  double moved[SF_MOVES + SF_BESIDE_MOVES][SF_MOST_COLUMNS],
                                  double (*out)[SF_MOST_COLUMNS])
{
    const sf_sample *at = &answer->at;
    double found[2];
    int j;
#define SF_PHASE(moves_of_phase)                                                                                       \
    for (j = 0; j < columns; j++) {                                                                                    \
        moves_of_phase(answer->Omega, at->A, answer->F_0, model->m, model->zeta, at->h, at->h_A, of->h[0][j],          \
                       of->m[j], of->zeta[j], moved[0][j], moved[1][j], moved[2][j], found);                           \
        out[0][j] = found[0], out[1][j] = found[1];                                                                    \
    }
    if (answer->inertial)
        SF_PHASE(inertia_moves_of_phase)
    else
        SF_PHASE(slow_flow_moves_of_phase)
#undef SF_PHASE
}

/* What the damping, the forcing and the frequency do, which is the same everywhere: columns are the numbers of the
 * design first, then mu, zeta, F_0 and Omega. */
static void sf_begin_causes(const sf_mechanism *mechanism, sf_causes *out)
{
    const int design = mechanism->design_size;
    memset(out, 0, sizeof *out);
    out->m[design] = slow_flow_friction(1); /* to which it is proportional */
    out->zeta[design + 1] = out->forcing[design + 2] = out->frequency[design + 3] = 1;
}

/* What the numbers of the design do at an answer. */
static void sf_causes_of(const sf_model *model, int piece, const double *by_parameter, const double *by_design,
                         sf_causes *out)
{
    const sf_mechanism *mechanism = model->mechanism;
    const int design = mechanism->design_size;
    const double *of_end = by_design + (mechanism->parameters + piece) * design;
    int i, j, k;
    for (j = 0; j < design; j++) {
        double of_h[3] = {0, 0, 0};
        for (k = 0; k < mechanism->parameters; k++)
            for (i = 0; i < 3; i++)
                of_h[i] += by_parameter[3 * k + i] * by_design[k * design + j];
        for (i = 0; i < 3; i++)
            out->h[i][j] = of_h[i];
        out->end[j] = mechanism->breakpoints > 0 ? of_end[j] : 0;
    }
}

/* Whether both are the same design and damping. */
static int sf_are_same(const sf_mechanism *mechanism, const sf_numbers *one, const sf_numbers *other)
{
    int i, same = 1;
    for (i = 0; i < mechanism->design_size; i++)
        same &= one->design[i] == other->design[i];
    for (i = 0; i < mechanism->damping_size; i++)
        same &= one->damping[i] == other->damping[i];
    return same;
}

/* Moves of an answer, by row, then by column. */
typedef double sf_rows[SF_STATE_MOVES][SF_MOST_COLUMNS];

/* How an answer at A moves with each of so many numbers. CORNER_END stands for any onset on a breakpoint; `of_design`
 * is by_design, and `of` what `sf_begin_causes` leaves. */
static sf_moves_status sf_gradient(const sf_model *model, const double *of_design, sf_causes *of,
                                   sf_pinned_answer *answer, double A, int rows, int columns, sf_rows out) {
    const sf_mechanism *mechanism = model->mechanism;
    const double w = answer->Omega, F_0 = answer->F_0;
    const sf_sample *at = &answer->at;
    double of_parameter[3 * SF_MOST_PARAMETERS];
    double moved[SF_MOVES + SF_BESIDE_MOVES][SF_MOST_COLUMNS];
    double averaged[3], beside[6];
    int i, j, piece = 0, infinite = 0;
    if (sf_is_on_break(answer->kind)) {
        if (model->breaks == 0)
            return SF_NOTHING_MOVES;
        piece = sf_nearest_break(model, A);
        A = model->b[piece];
        /* breakpoints of no width are left out of the model, and lie below the others */
        piece += mechanism->breakpoints - model->breaks;
    } else if (sf_comes_to_break(model, answer->kind, A)) {
        return SF_TURNS_MOVES;
    }
    sf_sample_at(model, A, &answer->at);
    if (answer->inertial)
        inertia_beside(w, A, F_0, model->m, model->zeta, at->h, at->h_A, beside);
    else
        slow_flow_beside(w, A, F_0, model->m, model->zeta, at->h, at->h_A, beside);
    if (sf_finds_forcing(answer->kind) &&
        sf_vanishes(answer->inertial ? inertia_force(w, F_0) : F_0, beside[5], SF_MEETING))
        return SF_BOUNDLESS_MOVES; /* neither friction nor damping: a level at 0 rises with either */
    if (answer->kind == SF_CORNER_FOLD_PINNED &&
        (sf_vanishes(beside[0], beside[1], SF_CLOSE) || sf_vanishes(beside[4], beside[5], SF_CLOSE)))
        return SF_TURNS_MOVES;
    if (answer->kind == SF_CORNER_END_PINNED)
        answer->kind = sf_pinned_on_break(beside);
    averaged[0] = at->h, averaged[1] = at->h_A, averaged[2] = at->h_AA;
    mechanism->by_parameter(mechanism, at->A, averaged, model->p, of_parameter);
    sf_causes_of(model, piece, of_parameter, of_design, of);
    sf_move(answer, model, of, columns, moved);
    if (sf_vanishes(moved[3][0], moved[4][0], SF_MEETING) || sf_vanishes(moved[5][0], moved[6][0], SF_MEETING))
        return SF_MEETS_MOVES;
    if (rows == SF_STATE_MOVES)
        sf_move_phase(answer, model, of, columns, moved, out + 1);
    for (i = 0; i < SF_MOVES; i++)
        for (j = 0; j < columns; j++)
            out[i > 0 ? rows - SF_MOVES + i : 0][j] = moved[i][j];
    for (i = 0; i < rows; i++)
        for (j = 0; j < columns; j++)
            infinite |= !(fabs(out[i][j]) <= DBL_MAX);
    return infinite ? SF_BOUNDLESS_MOVES : SF_OK_MOVES;
}

/* design, damping, F_0, Omega, A, what it is (a number of sf_pinned) -> moves (rows, columns), status; see
 * sf_gradient */
static void sf_loop_gradients(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps,
                              const sf_mechanism *mechanism, int inertial) {
    const int first = mechanism->design_size + mechanism->damping_size, moves = first + 4;
    const int rows = (int)dimensions[1], columns = (int)dimensions[2];
    const ptrdiff_t *inner = steps + moves + 2;
    double of_design[SF_MOST_DESIGN * (SF_MOST_PARAMETERS + SF_MOST_BREAKS)];
    sf_rows out;
    sf_causes of;
    sf_numbers before;
    sf_model model;
    int known = 0, valid = 0, i, j;
    ptrdiff_t k;
    sf_begin_causes(mechanism, &of);
    for (k = 0; k < dimensions[0]; k++) {
        const double A = sf_input(args, steps, first + 2, k);
        sf_pinned_answer answer = {(sf_pinned)sf_input(args, steps, first + 3, k), inertial,
                                   sf_input(args, steps, first + 1, k), sf_input(args, steps, first, k), {0}};
        sf_moves_status status = SF_NOTHING_MOVES;
        if (mechanism->by_parameter != NULL && A > 0 && A < HUGE_VAL && answer.Omega >= 0 && answer.Omega < HUGE_VAL &&
            answer.F_0 >= 0 && answer.F_0 < HUGE_VAL) {
            sf_numbers given;
            sf_read_numbers_at(mechanism, args, steps, k, &given);
            /* answers of one oscillator come one after the other */
            if (!known || !sf_are_same(mechanism, &given, &before)) {
                valid = sf_design_at(mechanism, args, steps, k, 1, &model);
                if (valid)
                    mechanism->by_design(mechanism, given.design, of_design);
                before = given, known = 1;
            }
            if (valid)
                status = sf_gradient(&model, of_design, &of, &answer, A, rows, columns, out);
        }
        for (i = 0; i < rows; i++) {
            char *row = args[moves] + k * steps[moves] + i * inner[0];
            for (j = 0; j < columns; j++)
                *(double *)(void *)(row + j * inner[1]) = status == SF_OK_MOVES ? out[i][j] : NAN;
        }
        sf_output_code(args, steps, moves + 1, k, status);
    }
}

static void sf_loop_forced_gradients(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_loop_gradients(args, dimensions, steps, data, 0);
}

static void sf_loop_inertial_gradients(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_loop_gradients(args, dimensions, steps, data, 1);
}

static void sf_many_gradients(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_forced_gradients, args, dimensions, steps, data);
}

static void sf_many_inertial_gradients(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quietly(sf_loop_inertial_gradients, args, dimensions, steps, data);
}

#endif
