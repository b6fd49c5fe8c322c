/* The record of a force from data, without a compiler. Takes words and numbers that the derivation writes
 * (derivations/codegen/targets/program); returns a record whose functions interpret them.
 *
 * A program is straight lines (straight.h), in doubles for SF_LANES amplitudes or nodes side by side.
 * `sf_read_program` refuses, besides what these do, other sizes than the record's functions take and give, and words
 * or numbers too many or too few. */
#pragma once

#include "bent.h"
#include "conventions.h"
#include "mechanism.h"
#include "pair_angles.h"
#include "quarter.h"
#include "straight.h"

/* Branch i holds where so many breakpoints are passed, if that is not -1, and where `guards` pairs of sides, in turn,
 * compare; the last one where no other does. */
typedef struct {
    int branches;
    const int *passed, *guards;
    const sf_straight *branch;
    sf_straight sides;
} sf_function;

/* A number of the design is above 0, at least 1, below 2, at most 3 a bound. */
typedef struct {
    int place, relation;
    double bound;
} sf_condition;

/* Averages: h to h_AAA, or by a quadrature their closing; slots of `sums` are those of `averages`. */
enum { SF_AVERAGED, SF_HIGHER, SF_INTERCEPT, SF_BY_PARAMETER, SF_AVERAGES };

struct sf_program {
    int conditions, summed;
    const sf_condition *condition;
    sf_function coefficients, ends, jumps, kinks, by_design;
    sf_function averages[SF_AVERAGES], averaged_2;
    sf_quarter sums[SF_AVERAGES];
    sf_bent bent;
    sf_function given_in_pairs, ends_in_pairs, in_pairs, given_within, ends_within, within;
};

/* ---- one number at a time */

/* clang-format off */
/* What pairs have, and intervals, each with its value at a and b. */
#define SF_OPERATIONS_IN_BOTH(OPERATION, prefix)                                                                       \
    OPERATION(ADD, prefix##add(a, b)) OPERATION(SUB, prefix##sub(a, b)) OPERATION(MUL, prefix##mul(a, b))              \
    OPERATION(DIV, prefix##div(a, b)) OPERATION(NEG, prefix##neg(a)) OPERATION(SQUARE, prefix##square(a))              \
    OPERATION(INVERSE, prefix##inverse(a))
#define SF_OPERATIONS_IN_PAIRS(OPERATION)                                                                              \
    SF_OPERATIONS_IN_BOTH(OPERATION, sfp_) OPERATION(SQRT, sfp_sqrt(a)) OPERATION(TIMES, sfp_times(a.high, b))         \
    OPERATION(ATAN2, pair_angles_atan2(a, b)) OPERATION(ATAN2_SWAPPED, pair_angles_atan2_swapped(a, b))
#define SF_OPERATIONS_ON_INTERVALS(OPERATION)                                                                          \
    SF_OPERATIONS_IN_BOTH(OPERATION, sfi_) SF_OPERATIONS_OF_ONE(OPERATION, sfi_) OPERATION(ATAN2, sfi_atan2(a, b))     \
    OPERATION(ATAN2_SWAPPED, sfi_atan2(b, a))                                                                          \
    OPERATION(TIMES, sfi_times(a.lo, b)) OPERATION(WITHIN, sfi_within(a, b.lo)) OPERATION(ROOT, sfi_root(a))           \
    OPERATION(POWER, sfi_power(a, b))

/* clang-format on */

SF_ARITHMETIC(sf_in_pairs, SF_OPERATIONS_IN_PAIRS)
SF_ARITHMETIC(sf_on_intervals, SF_OPERATIONS_ON_INTERVALS)

#define SF_OF_ONE(x, value)                                                                                            \
    case SF_##x##_OPERATION:                                                                                           \
        *result = (value);                                                                                             \
        break;
#define SF_RUN_OF(name, number, OPERATIONS)                                                                            \
    static SF_FLAT void name(const sf_straight *of, number *x) {                                                       \
        const sf_instruction *at = of->code, *const end = at + of->length;                                             \
        for (; at < end; at++) {                                                                                       \
            number *const result = x + at->result;                                                                     \
            const number a = x[at->first], b = x[at->second];                                                          \
            switch ((sf_operation)at->operation) {                                                                     \
                OPERATIONS(SF_OF_ONE)                                                                                  \
            default:                                                                                                   \
                break;                                                                                                 \
            }                                                                                                          \
        }                                                                                                              \
    }

SF_RUN_OF(sf_run_in_pairs, sf_pair, SF_OPERATIONS_IN_PAIRS)
SF_RUN_OF(sf_run_on_intervals, sf_interval, SF_OPERATIONS_ON_INTERVALS)
#undef SF_OF_ONE
#undef SF_RUN_OF

/* Constants of pairs and intervals. */
static inline void sf_fill_both(const sf_straight *of, void *x) {
    memcpy((double (*)[2])x + of->arguments, of->constant, (size_t)of->constants * sizeof *of->constant);
}

/* What C has no generic functions for: the number of the branch that holds at some arguments, and the outputs there. */
#define SF_FUNCTION_OF(number, branch_name, at_name, fill, run, compare)                                               \
    static inline int branch_name(const sf_function *of, int passed, const number *arguments) {                        \
        number x[SF_MOST_REGISTERS];                                                                                   \
        const sf_straight *sides = &of->sides;                                                                         \
        int i, j, side = 0, holds = 0;                                                                                 \
        if (of->branches == 1)                                                                                         \
            return 0;                                                                                                  \
        memcpy(x, arguments, (size_t)sides->arguments * sizeof *x);                                                    \
        fill(sides, x), run(sides, x);                                                                                 \
        for (i = 0; i < of->branches - 1 && !holds; i += !holds) {                                                     \
            holds = of->passed[i] < 0 || of->passed[i] == passed;                                                      \
            for (j = 0; j < of->guards[i]; j++, side += 2) {                                                           \
                const number one = x[sides->output[side]], other = x[sides->output[side + 1]];                         \
                holds &= (compare);                                                                                    \
            }                                                                                                          \
        }                                                                                                              \
        return i;                                                                                                      \
    }                                                                                                                  \
    static inline void at_name(const sf_function *of, int passed, const number *arguments, number *out) {              \
        number x[SF_MOST_REGISTERS];                                                                                   \
        const sf_straight *here = &of->branch[branch_name(of, passed, arguments)];                                     \
        int i;                                                                                                         \
        memcpy(x, arguments, (size_t)here->arguments * sizeof *x);                                                     \
        fill(here, x), run(here, x);                                                                                   \
        for (i = 0; i < here->outputs; i++)                                                                            \
            out[i] = x[here->output[i]];                                                                               \
    }

SF_FUNCTION_OF(double, sf_branch_at, sf_at, sf_fill, sf_run, one <= other)
SF_FUNCTION_OF(sf_pair, sf_branch_in_pairs, sf_at_in_pairs, sf_fill_both, sf_run_in_pairs, other.high > one.high)
SF_FUNCTION_OF(sf_interval, sf_branch_on_intervals, sf_at_on_intervals, sf_fill_both, sf_run_on_intervals,
               one.lo <= other.hi)
#undef SF_FUNCTION_OF

/* ---- doubles at many amplitudes, or nodes, side by side */

static SF_FLAT void sf_run_abreast(const sf_straight *of, double *x) { sf_run_lanes(of, x, SF_LANES); }

/* The registers of several lanes, and the line of which they hold the constants and the parameters. */
typedef struct {
    const sf_straight *holds;
    double x[SF_MOST_REGISTERS * SF_LANES];
} sf_lanes;

/* One line at n <= SF_LANES places: of the arguments the first vary, argument i at place k being at[i][k]; the others
 * are p. Output i of place k goes to out[i*apart + k*step]. */
static inline void sf_abreast(sf_lanes *lanes, const sf_straight *of, int varying, int n, const double *const *at,
                              const double *p, double *out, ptrdiff_t apart, ptrdiff_t step) {
    for (int i = 0; i < varying; i++)
        for (int k = 0; k < SF_LANES; k++)
            lanes->x[i * SF_LANES + k] = at[i][k < n ? k : 0];
    if (lanes->holds != of) {
        for (int i = varying; i < of->arguments; i++)
            for (int k = 0; k < SF_LANES; k++)
                lanes->x[i * SF_LANES + k] = p[i - varying];
        for (int i = 0; i < of->constants; i++)
            for (int k = 0; k < SF_LANES; k++)
                lanes->x[(of->arguments + i) * SF_LANES + k] = of->constant[i][0];
        lanes->holds = of;
    }
    sf_run_abreast(of, lanes->x);
    for (int i = 0; i < of->outputs; i++)
        for (int k = 0; k < n; k++)
            out[i * apart + k * step] = lanes->x[of->output[i] * SF_LANES + k];
}

/* A function of A and the parameters at n amplitudes; output k at amplitude i goes to out[k*n + i]. */
static inline void sf_at_amplitudes(const sf_function *of, int parameters, ptrdiff_t n, const double *A,
                                    const double *p, double *out) {
    double arguments[1 + SF_MOST_PARAMETERS];
    sf_lanes lanes;
    ptrdiff_t end;
    memcpy(arguments + 1, p, (size_t)parameters * sizeof *p);
    if (n == 1) {
        arguments[0] = A[0];
        sf_at(of, -1, arguments, out);
        return;
    }
    lanes.holds = NULL;
    for (ptrdiff_t first = 0; first < n; first = end) {
        const double *const at[] = {A + first};
        int branch;
        arguments[0] = A[first], branch = sf_branch_at(of, -1, arguments);
        for (end = first + 1; end < n && end < first + SF_LANES; end++) {
            arguments[0] = A[end];
            if (sf_branch_at(of, -1, arguments) != branch)
                break;
        }
        sf_abreast(&lanes, &of->branch[branch], 1, (int)(end - first), at, p, out + first, n, 1);
    }
}

/* ---- the record's functions */

static int sf_program_parameters_of(const sf_mechanism *self, const double *design, double *p) {
    const sf_program *of = self->program;
    for (int i = 0; i < of->conditions; i++) {
        const sf_condition *on = &of->condition[i];
        const double value = design[on->place], bound = on->bound;
        if (!(on->relation == 0   ? value > bound
              : on->relation == 1 ? value >= bound
              : on->relation == 2 ? value < bound
                                  : value <= bound))
            return 0;
    }
    sf_at(&of->coefficients, -1, design, p);
    return 1;
}

#define SF_PROGRAM_OF(name, number, at, of)                                                                            \
    static void name(const sf_mechanism *self, const number *p, number *out) { at(&self->program->of, -1, p, out); }
SF_PROGRAM_OF(sf_program_ends, double, sf_at, ends)
SF_PROGRAM_OF(sf_program_jumps, double, sf_at, jumps)
SF_PROGRAM_OF(sf_program_kinks, double, sf_at, kinks)
SF_PROGRAM_OF(sf_program_by_design, double, sf_at, by_design)
SF_PROGRAM_OF(sf_program_ends_in_pairs, sf_pair, sf_at_in_pairs, ends_in_pairs)
SF_PROGRAM_OF(sf_program_ends_within, sf_interval, sf_at_on_intervals, ends_within)
#undef SF_PROGRAM_OF

/* An average by quadrature at one amplitude: the first `count` integrals, and what closes them. */
static void sf_program_closed(const sf_mechanism *self, int which, int count, double A, const double *p, double *out) {
    const sf_program *of = self->program;
    double arguments[1 + SF_MOST_SUMS + SF_MOST_PARAMETERS] = {A}, ends[SF_MOST_BREAKS] = {0};
    const int width = of->sums[which].width;
    sf_at(&of->ends, -1, p, ends);
    sf_over_quarter(&of->sums[which], count, A, p, ends, arguments + 1);
    memcpy(arguments + 1 + width, p, (size_t)self->parameters * sizeof *p);
    sf_at(&of->averages[which], -1, arguments, out);
}

/* The first outputs of an average: by a quadrature from so many integrals, or as it is printed in a function of A. */
static void sf_program_average(const sf_mechanism *self, int which, int count, const sf_function *printed, int outputs,
                               ptrdiff_t n, const double *A, const double *p, double *out) {
    double at[3 * SF_MOST_PARAMETERS + 8];
    if (!self->program->summed) {
        sf_at_amplitudes(printed, self->parameters, n, A, p, out);
        return;
    }
    for (ptrdiff_t i = 0; i < n; i++) {
        sf_program_closed(self, which, count, A[i], p, at);
        for (int k = 0; k < outputs; k++)
            out[k * n + i] = at[k];
    }
}

#define SF_PROGRAM_AVERAGE(name, which, count, printed, outputs)                                                       \
    static void name(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out) {           \
        const sf_program *of = self->program;                                                                          \
        const sf_quarter *sums = &of->sums[which];                                                                     \
        sf_program_average(self, which, count, &of->printed, outputs, n, A, p, out);                                   \
    }
SF_PROGRAM_AVERAGE(sf_program_averaged, SF_AVERAGED, sums->width, averages[SF_AVERAGED], 4)
/* without contacts h and h_A need the first two integrals only */
SF_PROGRAM_AVERAGE(sf_program_averaged_2, SF_AVERAGED, sums->contacts > 0 ? sums->width : 2, averaged_2, 2)
SF_PROGRAM_AVERAGE(sf_program_harmonics, SF_HIGHER, sums->width, averages[SF_HIGHER], 8)
#undef SF_PROGRAM_AVERAGE

static double sf_program_intercept(const sf_mechanism *self, double A, const double *p) {
    const sf_program *of = self->program;
    double out;
    sf_program_average(self, SF_INTERCEPT, of->sums[SF_INTERCEPT].width, &of->averages[SF_INTERCEPT], 1, 1, &A, p,
                       &out);
    return out;
}

static void sf_program_by_parameter(const sf_mechanism *self, double A, const double *h, const double *p, double *out) {
    const sf_program *of = self->program;
    double arguments[4 + SF_MOST_PARAMETERS] = {A, h[0], h[1], h[2]};
    if (of->summed) {
        sf_program_closed(self, SF_BY_PARAMETER, of->sums[SF_BY_PARAMETER].width, A, p, out);
        return;
    }
    memcpy(arguments + 4, p, (size_t)self->parameters * sizeof *p);
    sf_at(&of->averages[SF_BY_PARAMETER], -1, arguments, out);
}

static void sf_program_bent(const sf_mechanism *self, sf_interval A, const double *p, sf_interval *out) {
    double ends[SF_MOST_BREAKS] = {0};
    sf_at(&self->program->ends, -1, p, ends);
    sf_enclose(&self->program->bent, ends, A, p, out);
}

/* In pairs, and on intervals: parameters of a design, and all averages where so many breakpoints are passed. */
#define SF_PROGRAM_EXACTLY(number, point, at, parameters_name, of_design, averaged_name, averages)                     \
    static void parameters_name(const sf_mechanism *self, const double *design, number *p) {                           \
        number inputs[SF_MOST_DESIGN];                                                                                 \
        for (int i = 0; i < self->design_size; i++)                                                                    \
            inputs[i] = point(design[i]);                                                                              \
        at(&self->program->of_design, -1, inputs, p);                                                                  \
    }                                                                                                                  \
    static void averaged_name(const sf_mechanism *self, int passed, number A, number beyond, const number *p,          \
                              number *out) {                                                                           \
        number arguments[2 + SF_MOST_PARAMETERS + SF_MOST_BREAKS] = {A, beyond};                                       \
        const int inputs = self->breakpoints > 0 ? 2 : 1;                                                              \
        memcpy(arguments + inputs, p, (size_t)(self->parameters + self->breakpoints) * sizeof *p);                     \
        at(&self->program->averages, passed, arguments, out);                                                          \
    }
SF_PROGRAM_EXACTLY(sf_pair, sfp_point, sf_at_in_pairs, sf_program_parameters_in_pairs, given_in_pairs,
                   sf_program_all_in_pairs, in_pairs)
SF_PROGRAM_EXACTLY(sf_interval, sfi_point, sf_at_on_intervals, sf_program_parameters_within, given_within,
                   sf_program_averaged_within, within)
#undef SF_PROGRAM_EXACTLY

static void sf_program_averaged_in_pairs(const sf_mechanism *self, int passed, int count, sf_pair A, sf_pair beyond,
                                         const sf_pair *p, sf_pair *out) {
    sf_pair all[5];
    sf_program_all_in_pairs(self, passed, A, beyond, p, all);
    memcpy(out, all, (count <= 2 ? 2 : 4) * sizeof *out);
}

/* Parameters and jumps in pairs of one of several designs. */
static inline void sf_program_design(const sf_mechanism *self, ptrdiff_t i, ptrdiff_t apart, const double *design,
                                     sf_pair *p) {
    double one[SF_MOST_DESIGN];
    for (int k = 0; k < self->design_size; k++)
        one[k] = design[k * apart + i];
    sf_program_parameters_in_pairs(self, one, p);
}

static void sf_program_many_in_pairs(const sf_mechanism *self, ptrdiff_t n, ptrdiff_t apart, const double *design,
                                     double *out) {
    sf_pair p[SF_MOST_PARAMETERS + SF_MOST_BREAKS];
    for (ptrdiff_t i = 0; i < n; i++) {
        sf_program_design(self, i, apart, design, p);
        for (int k = 0; k < self->parameters + self->breakpoints; k++)
            out[2 * k * apart + i] = p[k].high, out[(2 * k + 1) * apart + i] = p[k].low;
    }
}

static void sf_program_on_first_end_in_pairs(const sf_mechanism *self, ptrdiff_t n, ptrdiff_t apart,
                                             const double *design, double *out) {
    sf_pair p[SF_MOST_PARAMETERS + SF_MOST_BREAKS], b[SF_MOST_BREAKS], h[2];
    for (ptrdiff_t i = 0; i < n; i++) {
        sf_program_design(self, i, apart, design, p);
        sf_program_ends_in_pairs(self, p, b);
        sf_program_averaged_in_pairs(self, 0, 2, b[0], b[0], p, h);
        out[i] = b[0].high, out[apart + i] = b[0].low;
        out[2 * apart + i] = h[0].high, out[3 * apart + i] = h[0].low;
    }
}

/* All integrands of a piece at the nodes of a panel. */
static void sf_program_integrands(const sf_quarter *of, int piece, int nodes, const double *beyond, const double *sine,
                                  const double *cosine, const double *p, double *out) {
    const sf_function *integrands = (const sf_function *)of->programs + piece;
    sf_lanes lanes;
    lanes.holds = NULL;
    for (int first = 0; first < nodes; first += SF_LANES) {
        const double *const at[] = {beyond + first, sine + first, cosine + first};
        sf_abreast(&lanes, &integrands->branch[0], 3, nodes - first < SF_LANES ? nodes - first : SF_LANES, at, p,
                   out + first * of->width, 1, of->width);
    }
}

static void sf_program_enclosed(const sf_bent *of, int number, const sf_interval *arguments, sf_interval *out) {
    sf_at_on_intervals((const sf_function *)of->programs + number, -1, arguments, out);
}

/* ---- reading */

/* How reading ended; what was allocated stays where all is well. */
static inline sf_status sf_finished(sf_reader *from) {
    if (from->status == SF_READ)
        return SF_OK;
    sf_leave_room(from);
    return from->status == SF_TOO_LARGE ? SF_TOO_MANY : from->status == SF_NO_ROOM ? SF_NO_MEMORY : SF_INVALID;
}

/* pieces: how many numbers of breakpoints passed there are */
static inline void sf_read_function(sf_reader *from, sf_arithmetic has, int pieces, int arguments, int outputs,
                                    sf_function *out) {
    int *passed, *guards, sides = 0;
    sf_straight *branch;
    out->branches = sf_word(from, 1, (int)((from->last_word - from->word) / 2));
    passed = sf_room_for(from, out->branches, sizeof *passed);
    guards = sf_room_for(from, out->branches, sizeof *guards);
    branch = sf_room_for(from, out->branches, sizeof *branch);
    if (from->status != SF_READ)
        return;
    for (int i = 0; i < out->branches; i++) {
        const int last = i == out->branches - 1;
        passed[i] = sf_word(from, -1, last || has == sf_in_doubles ? -1 : pieces - 1);
        guards[i] = sf_word(from, 0, last ? 0 : SF_MOST_REGISTERS / 2);
        sides += 2 * guards[i];
        if (sides > SF_MOST_REGISTERS)
            sf_refuse(from, SF_NO_PROGRAM);
    }
    sf_read_straight(from, has, arguments, sides, &out->sides);
    for (int i = 0; i < out->branches && from->status == SF_READ; i++)
        sf_read_straight(from, has, arguments, outputs, &branch[i]);
    out->passed = passed, out->guards = guards, out->branch = branch;
}

/* Numbers of breakpoints at which contacts begin. */
static inline const int *sf_read_begins(sf_reader *from, int breakpoints, int *contacts) {
    int *begins;
    *contacts = sf_size(from, 0, SF_MOST_CONTACTS);
    begins = sf_room_for(from, *contacts, sizeof *begins);
    for (int i = 0; i < *contacts && begins != NULL; i++)
        begins[i] = sf_word(from, 0, breakpoints - 1);
    return begins;
}

/* Averages by quadrature: in the order of `enum`, but the intercept before the harmonics. */
static inline void sf_read_sums(sf_reader *from, const sf_mechanism *record, sf_program *out) {
    const int order[] = {SF_AVERAGED, SF_INTERCEPT, SF_HIGHER, SF_BY_PARAMETER};
    const int outputs[] = {4, 1, 8, 3 * record->parameters};
    const int pieces = record->breakpoints + 1, nodes = sf_word(from, 1, SF_NODES / 2);
    int contacts, *graded;
    double (*rule)[2] = sf_room_for(from, nodes, sizeof *rule);
    for (int i = 0; i < nodes && rule != NULL; i++)
        rule[i][0] = sf_finite(from), rule[i][1] = sf_finite(from);
    const int *begins = sf_read_begins(from, record->breakpoints, &contacts);
    graded = sf_room_for(from, pieces + contacts, sizeof *graded);
    for (int i = 0; i < pieces + contacts && graded != NULL; i++)
        graded[i] = sf_word(from, 1, 16);
    for (int k = 0; k < SF_AVERAGES && from->status == SF_READ; k++) {
        sf_quarter *sums = &out->sums[order[k]];
        sf_function *programs = sf_room_for(from, pieces + contacts, sizeof *programs);
        const int width = sf_size(from, k == 0 ? 4 + 4 * contacts : 0, SF_MOST_SUMS);
        if (programs == NULL)
            return;
        for (int i = 0; i < pieces + contacts; i++) {
            sf_read_function(from, sf_in_doubles, pieces, 3 + record->parameters, width, &programs[i]);
            if (programs[i].branches > 1)
                sf_refuse(from, SF_NO_PROGRAM);
        }
        sf_read_function(from, sf_in_doubles, pieces, 1 + width + record->parameters, outputs[k],
                         &out->averages[order[k]]);
        sums->pieces = pieces, sums->width = width, sums->parameters = record->parameters;
        sums->graded = graded, sums->nodes = nodes, sums->rule = (const double (*)[2])rule;
        sums->contacts = contacts, sums->begins = begins;
        sums->interpreted = sf_program_integrands, sums->programs = programs;
    }
}

static inline void sf_read_averages(sf_reader *from, const sf_mechanism *record, sf_program *out) {
    const int pieces = record->breakpoints + 1, p = record->parameters;
    sf_read_function(from, sf_in_doubles, pieces, 1 + p, 4, &out->averages[SF_AVERAGED]);
    sf_read_function(from, sf_in_doubles, pieces, 1 + p, 2, &out->averaged_2);
    sf_read_function(from, sf_in_doubles, pieces, 1 + p, 8, &out->averages[SF_HIGHER]);
    sf_read_function(from, sf_in_doubles, pieces, 1 + p, 1, &out->averages[SF_INTERCEPT]);
    sf_read_function(from, sf_in_doubles, pieces, 4 + p, 3 * p, &out->averages[SF_BY_PARAMETER]);
}

static inline void sf_read_bent(sf_reader *from, const sf_mechanism *record, sf_program *out) {
    sf_bent *bent = &out->bent;
    const int p = record->parameters, pieces = record->breakpoints + 1;
    sf_function *programs;
    bent->breakpoints = record->breakpoints, bent->parameters = p;
    bent->begins = sf_read_begins(from, record->breakpoints, &bent->contacts);
    programs = sf_room_for(from, 2 * pieces + bent->contacts, sizeof *programs);
    for (int i = 0; i < 2 * pieces + bent->contacts && from->status == SF_READ; i++) {
        const int closing = i - pieces - bent->contacts;
        const int arguments = i < pieces ? 3 : closing < 0 ? 2 : 3 + closing + SF_CONTACT_SUMS * bent->contacts;
        sf_read_function(from, sf_on_intervals, 0, arguments + p, i >= pieces && closing < 0 ? SF_CONTACT_SUMS : 2,
                         &programs[i]);
    }
    bent->at = sf_program_enclosed, bent->programs = programs;
}

static inline void sf_read_exact(sf_reader *from, int within, const sf_mechanism *record, sf_program *out) {
    const int inputs = record->parameters + record->breakpoints, pieces = record->breakpoints + 1;
    const int known = inputs + (record->breakpoints > 0 ? 2 : 1);
    sf_read_function(from, sf_in_pairs, 0, record->design_size, inputs, &out->given_in_pairs);
    if (within)
        sf_read_function(from, sf_on_intervals, 0, record->design_size, inputs, &out->given_within);
    if (record->breakpoints > 0) {
        sf_read_function(from, sf_in_pairs, 0, record->parameters, record->breakpoints, &out->ends_in_pairs);
        if (within)
            sf_read_function(from, sf_on_intervals, 0, record->parameters, record->breakpoints, &out->ends_within);
    }
    sf_read_function(from, sf_in_pairs, pieces, known, 5, &out->in_pairs);
    if (within)
        sf_read_function(from, sf_on_intervals, pieces, known, 5, &out->within);
}

static inline void sf_read_conditions(sf_reader *from, const sf_mechanism *record, sf_program *out) {
    sf_condition *condition;
    out->conditions = sf_word(from, 0, 4 * SF_MOST_DESIGN);
    out->condition = condition = sf_room_for(from, out->conditions, sizeof *condition);
    for (int i = 0; i < out->conditions && condition != NULL; i++) {
        condition[i].place = sf_word(from, 0, record->design_size - 1);
        condition[i].relation = sf_word(from, 0, 3);
        condition[i].bound = sf_number(from);
    }
}

/* A record's functions of the force from all words and numbers; what a force has no part in stays. */
static inline void sf_read_program(sf_reader *from, sf_mechanism *record, sf_program *out) {
    int bent, exact;
    sf_word(from, SF_PROGRAM_FORM, SF_PROGRAM_FORM);
    record->design_size = sf_size(from, 0, SF_MOST_DESIGN);
    record->parameters = sf_size(from, 0, SF_MOST_PARAMETERS);
    record->breakpoints = sf_size(from, 0, SF_MOST_BREAKS);
    const int pieces = record->breakpoints + 1;
    out->summed = sf_word(from, 0, 1), bent = sf_word(from, 0, 1), exact = sf_word(from, 0, 1);
    const int within = sf_word(from, 0, 1);
    record->reach = sf_number(from), record->harmonics_up_to = sf_number(from);
    sf_read_conditions(from, record, out);
    sf_read_function(from, sf_in_doubles, pieces, record->design_size, record->parameters, &out->coefficients);
    sf_read_function(from, sf_in_doubles, pieces, record->parameters, record->breakpoints, &out->ends);
    sf_read_function(from, sf_in_doubles, pieces, record->parameters, record->breakpoints, &out->jumps);
    if (bent)
        sf_read_function(from, sf_in_doubles, pieces, record->parameters, 2 * record->breakpoints, &out->kinks);
    sf_read_function(from, sf_in_doubles, pieces, record->design_size,
                     (record->parameters + record->breakpoints) * record->design_size, &out->by_design);
    if (out->summed)
        sf_read_sums(from, record, out);
    else
        sf_read_averages(from, record, out);
    if (bent)
        sf_read_bent(from, record, out);
    if (exact)
        sf_read_exact(from, within, record, out);
    if (from->word != from->last_word || from->number != from->last_number)
        sf_refuse(from, SF_NO_PROGRAM);
    record->parameters_of = sf_program_parameters_of;
    record->ends = sf_program_ends, record->jumps = sf_program_jumps;
    record->kinks = bent && record->breakpoints > 0 ? sf_program_kinks : NULL;
    record->averaged = sf_program_averaged, record->averaged_2 = sf_program_averaged_2;
    record->intercept = sf_program_intercept, record->harmonics = sf_program_harmonics;
    record->bent = bent ? sf_program_bent : NULL;
    record->by_parameter = sf_program_by_parameter, record->by_design = sf_program_by_design;
    record->parameters_within = within ? sf_program_parameters_within : NULL;
    record->ends_within = within && record->breakpoints > 0 ? sf_program_ends_within : NULL;
    record->averaged_within = within ? sf_program_averaged_within : NULL;
    record->parameters_in_pairs = exact ? sf_program_parameters_in_pairs : NULL;
    record->ends_in_pairs = exact && record->breakpoints > 0 ? sf_program_ends_in_pairs : NULL;
    record->averaged_in_pairs = exact ? sf_program_averaged_in_pairs : NULL;
    record->many_in_pairs = exact ? sf_program_many_in_pairs : NULL;
    record->on_first_end_in_pairs = exact && record->breakpoints > 0 ? sf_program_on_first_end_in_pairs : NULL;
    record->program = out;
}
