/* Gradients. Takes an answer with what it is; returns its derivatives by each number that a user gives.
 *
 * By the implicit function theorem: an answer holds three conditions (SF_SYSTEMS), whose slopes and right sides are
 * generated (sensitivities_...); by the chain rule from the design to the force's parameters to the average. What every
 * number does is computed in one loop.
 */
#pragma once

#include "laws.h"
#include "many.h"
#include "sensitivities.h"

enum {
    SF_UNKNOWNS = 3,   /* A, Omega and F_0 */
    SF_STATE_ROWS = 5, /* of A, phase and transmissibility, then of Omega and F_0 */
    SF_CONDITIONS = 8,
    SF_SIZES = SF_CONDITIONS * SF_UNKNOWNS, /* behind the slopes */
    SF_EXCITED = 7,
    SF_MOST_COLUMNS = SF_MOST_DESIGN + SF_MOST_DAMPING + 2
};

/* What each number that a user gives does: to h, I_0 and zeta with two derivatives each, ... */
typedef struct {
    double h[3][SF_MOST_COLUMNS], rest[3][SF_MOST_COLUMNS], zeta[3][SF_MOST_COLUMNS], d[2][SF_MOST_COLUMNS];
    double end[SF_MOST_COLUMNS], forcing[SF_MOST_COLUMNS], frequency[SF_MOST_COLUMNS];
} sf_causes;

/* An answer: where it is, what it is, and by what it is excited: its force, and what follows from that; I_0 and zeta
 * with three derivatives each, and whether these are taken beyond where friction ends. */
typedef struct {
    sf_pinned kind;
    int inertial;
    double Omega, F_0, excited[SF_EXCITED], R;
    sf_sample at;
    int beyond;
    sf_law_terms of;
} sf_pinned_answer;

/* Whether a value is so small a share of its size that rounding may have its sign. */
static inline int sf_vanishes(double value, double size, double tolerance) { return !(fabs(value) > tolerance * size); }

static int sf_is_on_break(sf_pinned kind) {
    return kind == SF_CORNER_FOLD_PINNED || kind == SF_CORNER_TOP_PINNED || kind == SF_CORNER_END_PINNED ||
           kind == SF_CORNER_BACKBONE_PINNED || kind == SF_CORNER_REST_PINNED;
}

/* Whether an answer that is on no breakpoint has come to one. States and peaks ask for h_A, which jumps there where the
 * force does, and for I_0A, which jumps where friction ends; the others for h_AA, which grows without bound next to it
 * too. */
static int sf_comes_to_break(const sf_model *model, sf_pinned kind, double A) {
    const int first = kind == SF_STATE_PINNED || kind == SF_PEAK_PINNED;
    for (int k = 0; k < model->breaks; k++)
        if (fabs(A - model->b[k]) <= (first ? SF_SAME : SF_COINCIDE) * model->b[k] &&
            (!first || model->jump[k] != 0 || (k == 0 && model->released && model->m > 0)))
            return 1;
    return 0;
}

/* The slopes of the conditions at an answer by A, Omega and F_0, and their sizes. */
SF_ALWAYS void sf_slopes_at(const sf_pinned_answer *answer, const sf_model *model, double slopes[2 * SF_SIZES]) {
    const sf_sample *at = &answer->at;
    const double *square = answer->excited + 3, *rest = answer->of.rest, *zeta = answer->of.zeta;
    sensitivities_slopes(answer->Omega, at->A, answer->R, rest[0], rest[1], rest[2], rest[3], zeta[0], zeta[1], zeta[2],
                         zeta[3], model->d, model->d_3, at->h, at->h_A, at->h_AA, at->h_AAA, square[0], square[1],
                         square[2], square[3], slopes);
}

/* Which of the answers on breakpoint k an onset there is: whatever comes next to vanishing. Folds leave it where F_A
 * vanishes, R where the force jumps, or F_A beyond where friction ends. */
static void sf_pin_on_break(const sf_model *model, int k, const double *slopes, double size_of_R,
                            sf_pinned_answer *answer) {
    const int ends = model->released && model->jump[k] == 0;
    double beyond[2 * SF_SIZES];
    sf_pinned_answer past = *answer;
    double values[] = {slopes[0], slopes[1], answer->R}, sizes[] = {slopes[SF_SIZES], slopes[SF_SIZES + 1], size_of_R};
    int best = 0;
    if (ends) {
        past.beyond = 1;
        past.of = sf_law_terms_at(model, past.at.A, 1);
        sf_slopes_at(&past, model, beyond);
        values[2] = beyond[0], sizes[2] = beyond[SF_SIZES];
    }
    if (answer->kind == SF_CORNER_FOLD_PINNED) {
        for (int i = 0; i < 3; i += 2)
            if (sf_vanishes(values[i], sizes[i], SF_CLOSE))
                answer->kind = SF_CORNER_END_PINNED;
        return;
    }
    for (int i = 1; i < 3; i++)
        if (fabs(values[i]) * sizes[best] < fabs(values[best]) * sizes[i])
            best = i;
    if (best == 1)
        answer->kind = SF_CORNER_TOP_PINNED;
    else if (best == 2 && !ends)
        answer->kind = SF_CORNER_BACKBONE_PINNED;
    else if (best == 2)
        *answer = past;
}

/* The derivatives of A, Omega and F_0 by number j go to column j. Returns 0 where an answer meets another. */
static int sf_solve(const sf_pinned_answer *answer, const sf_model *model, const sf_causes *of, int columns,
                    double rates[SF_UNKNOWNS][SF_MOST_COLUMNS]) {
    static const signed char systems[][9] = SF_SYSTEMS;
    const signed char *rows = systems[answer->kind], *unknowns = rows + 3, together = rows[6], *vanishing = rows + 7;
    const sf_sample *at = &answer->at;
    double slopes[2 * SF_SIZES], determinant = 1;
    sf_slopes_at(answer, model, slopes);
    slopes[vanishing[0]] = slopes[vanishing[1]] = 0;
    for (int i = 0; i < 3 - 2 * together; i++) {
        const double *pivot = slopes + 3 * rows[i] + unknowns[i];
        if (sf_vanishes(pivot[0], pivot[SF_SIZES], SF_MEETING))
            return 0;
    }
    if (together) {
        const double *a = slopes + 3 * rows[1];
        const double *b = slopes + 3 * rows[2];
        const double *size_a = a + SF_SIZES;
        const double *size_b = b + SF_SIZES;
        const int x = unknowns[1], y = unknowns[2];
        determinant = a[x] * b[y] - a[y] * b[x];
        if (sf_vanishes(determinant, size_a[x] * size_b[y] + size_a[y] * size_b[x], SF_MEETING))
            return 0;
    }
    for (int j = 0; j < columns; j++) {
        double right[SF_CONDITIONS], found[SF_UNKNOWNS] = {0, 0, 0};
        sensitivities_right(answer->Omega, at->A, answer->R, answer->of.rest[0], answer->of.rest[1], answer->of.rest[2],
                            answer->of.zeta[0], answer->of.zeta[1], answer->of.zeta[2], model->d, model->d_3, at->h_A,
                            at->h_AA, of->h[0][j], of->h[1][j], of->h[2][j], of->rest[0][j], of->rest[1][j],
                            of->rest[2][j], of->zeta[0][j], of->zeta[1][j], of->zeta[2][j], of->d[0][j], of->d[1][j],
                            of->forcing[j], of->frequency[j], of->end[j], right);
        for (int i = 0; i < 3; i++) {
            const double *slope = slopes + 3 * rows[i];
            double known = right[rows[i]];
            for (int k = 0; k < (together ? i > 0 : i); k++)
                known -= slope[unknowns[k]] * found[unknowns[k]];
            if (together && i > 0)
                right[rows[i]] = known;
            else
                found[unknowns[i]] = known / slope[unknowns[i]];
        }
        if (together) {
            const double *a = slopes + 3 * rows[1], *b = slopes + 3 * rows[2];
            const int x = unknowns[1], y = unknowns[2];
            found[x] = (right[rows[1]] * b[y] - a[y] * right[rows[2]]) / determinant;
            found[y] = (a[x] * right[rows[2]] - right[rows[1]] * b[x]) / determinant;
        }
        for (int i = 0; i < SF_UNKNOWNS; i++)
            rates[i][j] = found[i];
    }
    return 1;
}

/* What the damping, the forcing and the frequency do, which is the same everywhere: columns are the numbers of the
 * design first, then mu, zeta, of other laws eta, c_2, c_3 and zeta_2, then F_0 and Omega. */
static void sf_begin_causes(const sf_mechanism *mechanism, sf_causes *out) {
    const int design = mechanism->design_size, next = design + (sf_takes_laws(mechanism) ? 6 : 2);
    memset(out, 0, sizeof *out);
    out->rest[0][design] = slow_flow_friction(1); /* to which it is proportional */
    out->zeta[0][design + 1] = out->forcing[next] = out->frequency[next + 1] = 1;
    if (sf_takes_laws(mechanism))
        out->d[0][design + 3] = dissipation_quadratic(1), out->d[1][design + 4] = dissipation_cubic(1);
}

/* What friction, structural damping and, where friction ends, the breakpoint do to I_0 at an answer, and zeta_2 to
 * zeta. */
static void sf_causes_of_rest(const sf_model *model, const sf_pinned_answer *answer, const double *of_end,
                              sf_causes *out) {
    const int design = model->mechanism->design_size, released = model->released && answer->beyond;
    double of[9] = {0}, of_zeta[3];
    dissipation_viscous_moves(answer->at.A, of_zeta);
    if (released)
        dissipation_released_moves(fmax(answer->at.A, model->b[0]), model->m, model->b[0], of);
    else
        dissipation_rest_moves(answer->at.A, of);
    for (int i = 0; i < 3; i++) {
        out->rest[i][design] = slow_flow_friction(1) * of[i], out->rest[i][design + 2] = of[3 + i];
        out->zeta[i][design + 5] = of_zeta[i];
        for (int j = 0; j < design; j++)
            out->rest[i][j] = released ? of[6 + i] * of_end[j] : 0;
    }
}

/* What the numbers of the design do at an answer. */
static void sf_causes_of(const sf_model *model, int piece, const double *by_parameter, const double *by_design,
                         sf_causes *out) {
    const sf_mechanism *mechanism = model->mechanism;
    const int design = mechanism->design_size;
    const double *of_end = by_design + (mechanism->parameters + piece) * design;
    for (int j = 0; j < design; j++) {
        double of_h[3] = {0, 0, 0};
        for (int k = 0; k < mechanism->parameters; k++)
            for (int i = 0; i < 3; i++)
                of_h[i] += by_parameter[3 * k + i] * by_design[k * design + j];
        for (int i = 0; i < 3; i++)
            out->h[i][j] = of_h[i];
        out->end[j] = mechanism->breakpoints > 0 ? of_end[j] : 0;
    }
}

/* Whether both are the same design and damping. */
static int sf_are_same(const sf_mechanism *mechanism, const sf_numbers *one, const sf_numbers *other) {
    int same = 1;
    for (int i = 0; i < mechanism->design_size; i++)
        same &= one->design[i] == other->design[i];
    for (int i = 0; i < mechanism->damping_size; i++)
        same &= one->damping[i] == other->damping[i];
    return same;
}

/* Derivatives of an answer, by row, then by column. */
typedef double sf_rows[SF_STATE_ROWS][SF_MOST_COLUMNS];

/* The derivatives of an answer at A by so many numbers. CORNER_END is any onset on a breakpoint; `of_design`
 * is by_design, and `of` what `sf_begin_causes` leaves. */
static sf_moves_status sf_gradient(const sf_model *model, const double *of_design, sf_causes *of,
                                   sf_pinned_answer *answer, double A, int rows, int columns, sf_rows out) {
    const sf_mechanism *mechanism = model->mechanism;
    const double w = answer->Omega, F_0 = answer->F_0;
    const sf_sample *at = &answer->at;
    double of_parameter[3 * SF_MOST_PARAMETERS], rates[SF_UNKNOWNS][SF_MOST_COLUMNS];
    double averaged[3], size_of_R;
    int piece = 0, infinite = 0;
    if (sf_is_on_break(answer->kind)) {
        if (model->breaks == 0)
            return SF_NOTHING_MOVES;
        piece = sf_nearest_break(model, A);
        A = model->b[piece];
    } else if (sf_comes_to_break(model, answer->kind, A)) {
        return SF_TURNS_MOVES;
    }
    answer->at = sf_sample_at(model, A);
    answer->beyond = sf_is_beyond(model, A);
    answer->of = sf_law_terms_at(model, A, answer->beyond);
    (answer->inertial ? sensitivities_by_inertia : sensitivities_by_force)(w, F_0, answer->excited);
    answer->R = slow_flow_R(w, A, at->h), size_of_R = slow_flow_R(w, A, fabs(at->h));
    /* kinds before it are at a given forcing */
    if (answer->kind >= SF_CUSP_PINNED && sf_vanishes(answer->excited[0], size_of_R, SF_MEETING))
        return SF_BOUNDLESS_MOVES; /* neither friction nor damping: a level at 0 rises with either */
    if (answer->kind == SF_CORNER_FOLD_PINNED || answer->kind == SF_CORNER_END_PINNED) {
        double slopes[2 * SF_SIZES];
        const int is_fold = answer->kind == SF_CORNER_FOLD_PINNED;
        sf_slopes_at(answer, model, slopes);
        sf_pin_on_break(model, piece, slopes, size_of_R, answer);
        if (is_fold && answer->kind != SF_CORNER_FOLD_PINNED)
            return SF_TURNS_MOVES;
    }
    if (answer->kind == SF_CORNER_BACKBONE_PINNED)
        answer->R = 0;
    averaged[0] = at->h, averaged[1] = at->h_A, averaged[2] = at->h_AA;
    mechanism->by_parameter(mechanism, at->A, averaged, model->p, of_parameter);
    /* breakpoints of no width are left out of the model, and lie below the others */
    sf_causes_of(model, piece + mechanism->breakpoints - model->breaks, of_parameter, of_design, of);
    if (sf_takes_laws(mechanism))
        sf_causes_of_rest(
            model, answer,
            of_design + (mechanism->parameters + mechanism->breakpoints - model->breaks) * mechanism->design_size, of);
    if (!sf_solve(answer, model, of, columns, rates))
        return SF_MEETS_MOVES;
    for (int i = 0; i < SF_UNKNOWNS; i++)
        for (int j = 0; j < columns; j++)
            out[i > 0 ? rows - SF_UNKNOWNS + i : 0][j] = rates[i][j];
    for (int j = 0; j < columns && rows == SF_STATE_ROWS; j++) {
        double found[2];
        sensitivities_of_state(w, at->A, answer->of.rest[0], answer->of.rest[1], answer->of.zeta[0], answer->of.zeta[1],
                               model->d, model->d_3, at->h, at->h_A, answer->excited[0], answer->excited[1],
                               answer->excited[2], of->h[0][j], of->rest[0][j], of->zeta[0][j], of->d[0][j],
                               of->d[1][j], rates[0][j], rates[1][j], rates[2][j], found);
        out[1][j] = found[0], out[2][j] = found[1];
    }
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            infinite |= !(fabs(out[i][j]) <= DBL_MAX);
    return infinite ? SF_BOUNDLESS_MOVES : SF_OK_MOVES;
}

/* An answer by what is known there, and what one number does to that: A, Omega, F_0, what it is, whether inertia
 * excites; h, I_0 and zeta with three derivatives each; d, d_3; then of h, I_0 and zeta with two derivatives each, d,
 * d_3, the forcing, the frequency and an end. Returns derivatives as of `sf_gradient`, and 1; where the answer meets
 * another NaN, and 0. */
static void sf_slopes_of(const double *in, double *out) {
    sf_pinned_answer answer = {.kind = (sf_pinned)in[3], .inertial = in[4] != 0, .Omega = in[1], .F_0 = in[2]};
    double rates[SF_UNKNOWNS][SF_MOST_COLUMNS];
    sf_causes of;
    sf_model model;
    answer.at.A = in[0];
    memcpy(answer.at.averages, in + 5, 4 * sizeof *in);
    memcpy(answer.of.rest, in + 9, 4 * sizeof *in);
    memcpy(answer.of.zeta, in + 13, 4 * sizeof *in);
    model.d = in[17], model.d_3 = in[18];
    for (int i = 0; i < 3; i++)
        of.h[i][0] = in[19 + i], of.rest[i][0] = in[22 + i], of.zeta[i][0] = in[25 + i];
    of.d[0][0] = in[28], of.d[1][0] = in[29];
    of.forcing[0] = in[30], of.frequency[0] = in[31], of.end[0] = in[32];
    (answer.inertial ? sensitivities_by_inertia : sensitivities_by_force)(in[1], in[2], answer.excited);
    answer.R = answer.kind == SF_CORNER_BACKBONE_PINNED ? 0 : slow_flow_R(in[1], in[0], in[5]);
    out[SF_STATE_ROWS] = sf_solve(&answer, &model, &of, 1, rates);
    for (int i = 0; i < SF_STATE_ROWS; i++)
        out[i] = NAN;
    if (out[SF_STATE_ROWS] == 0)
        return;
    out[0] = rates[0][0], out[3] = rates[1][0], out[4] = rates[2][0];
    sensitivities_of_state(in[1], in[0], in[9], in[10], in[13], in[14], in[17], in[18], in[5], in[6], answer.excited[0],
                           answer.excited[1], answer.excited[2], in[19], in[22], in[25], in[28], in[29], out[0], out[3],
                           out[4], out + 1);
}

/* design, damping, F_0, Omega, A, what it is (a number of sf_pinned), whether inertia excites -> derivatives (rows,
 * columns), status; see sf_gradient */
static void sf_loop_gradients(sf_call *at) {
    const sf_mechanism *mechanism = at->mechanism;
    const int rows = (int)at->dimensions[1], columns = (int)at->dimensions[2];
    double of_design[SF_MOST_DESIGN * (SF_MOST_PARAMETERS + SF_MOST_BREAKS)];
    sf_rows out;
    sf_causes of;
    sf_numbers before;
    sf_model model;
    int known = 0, valid = 0;
    sf_begin_causes(mechanism, &of);
    for (at->k = 0; at->k < at->dimensions[0]; at->k++) {
        const double A = sf_number(at, 2);
        sf_pinned_answer answer = {.kind = (sf_pinned)sf_number(at, 3),
                                   .inertial = sf_number(at, 4) != 0,
                                   .Omega = sf_number(at, 1),
                                   .F_0 = sf_number(at, 0)};
        sf_moves_status status = SF_NOTHING_MOVES;
        if (mechanism->by_parameter != NULL && A > 0 && A < HUGE_VAL && answer.Omega >= 0 && answer.Omega < HUGE_VAL &&
            answer.F_0 >= 0 && answer.F_0 < HUGE_VAL) {
            sf_numbers inputs;
            sf_read_numbers_at(at, &inputs);
            /* answers of one oscillator come one after the other */
            if (!known || !sf_are_same(mechanism, &inputs, &before)) {
                valid = sf_design_at(at, 1, &inputs, &model);
                if (valid)
                    mechanism->by_design(mechanism, inputs.design, of_design);
                before = inputs, known = 1;
            }
            if (valid)
                status = sf_gradient(&model, of_design, &of, &answer, A, rows, columns, out);
        }
        for (int i = 0; i < rows; i++) {
            char *row = sf_output(at, 0) + i * at->inner[0];
            for (int j = 0; j < columns; j++)
                *(double *)(void *)(row + j * at->inner[1]) = status == SF_OK_MOVES ? out[i][j] : NAN;
        }
        *sf_output(at, 1) = (char)status;
    }
}
