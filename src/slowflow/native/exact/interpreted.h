/* The pieces of a force from data, without a compiler. Takes words and numbers that the derivation writes
 * (derivations/codegen/targets/program); returns laws whose functions interpret them, with the bits of printed ones. */
#pragma once

#include "step.h"
#include "straight.h"

/* begin: of the constants, their side and u the first coefficients of all series, and reciprocals. next: of n, 1/n,
 * these, the coefficients 0, 1, n - 1 of all series, the reciprocals, the sums and coefficient n of u those of all
 * others, and what they contribute to the sums, left and right in turn. */
typedef struct {
    int series, sums, value, slope;
    sf_straight begin, next;
} sf_recurrence;

/* law: first, so that a pointer to it is one to all */
typedef struct {
    sf_law law;
    int linear;
    sf_straight value, slope, begins;
    sf_recurrence force, both;
} sf_interpreted;

/* what expansions hand on in the place of the constants */
typedef struct {
    const sf_recurrence *by;
    int constants;
    const double *p;
} sf_interpreting;

static double sf_run_at(const sf_straight *of, const double *p, double u) {
    double x[SF_MOST_REGISTERS];
    memcpy(x, p, (size_t)(of->arguments - 1) * sizeof *x);
    x[of->arguments - 1] = u;
    sf_fill(of, x), sf_run(of, x);
    return x[of->output[0]];
}

#define SF_INTERPRETED(name, line)                                                                                     \
    static double name(const sf_law *self, const double *p, double u) {                                                \
        return sf_run_at(&((const sf_interpreted *)self)->line, p, u);                                                 \
    }
SF_INTERPRETED(sf_interpreted_value, value)
SF_INTERPRETED(sf_interpreted_slope, slope)
SF_INTERPRETED(sf_interpreted_begins, begins)
#undef SF_INTERPRETED

static void sf_interpreted_begin(const double *p, double *first, double *over) {
    const sf_interpreting *const of = (const sf_interpreting *)p;
    const sf_straight *const begin = &of->by->begin;
    const int series = of->by->series;
    double x[SF_MOST_REGISTERS];
    memcpy(x, of->p, (size_t)of->constants * sizeof *x);
    x[of->constants] = first[0];
    sf_fill(begin, x), sf_run(begin, x);
    over[0] = 0.0;
    for (int i = 1; i < series; i++)
        first[i] = x[begin->output[i - 1]], over[i] = x[begin->output[series - 2 + i]];
}

static void sf_interpreted_next(const sf_coefficients *c, const double *p, double *w, sf_four *left, sf_four *right) {
    const sf_interpreting *const of = (const sf_interpreting *)p;
    const sf_straight *const next = &of->by->next;
    const int series = of->by->series, sums = of->by->sums;
    const unsigned short *output = next->output;
    double x[SF_MOST_REGISTERS], *at = x;
    *at++ = c->n, *at++ = sf_over[c->n];
    memcpy(at, of->p, (size_t)of->constants * sizeof *x), at += of->constants;
    const double *const all[] = {c->first, c->second, c->last, c->over};
    for (int i = 0; i < 4; i++, at += series)
        memcpy(at, all[i], (size_t)series * sizeof *x);
    for (int i = 0; i < sums; i++)
        *at++ = sf_lane(c->sum, i);
    *at = w[0];
    sf_fill(next, x), sf_run(next, x);
    for (int i = 1; i < series; i++)
        w[i] = x[*output++];
    for (int i = 0; i < sums; i += 4, output += 8) {
        left[i / 4] = sf_four_of(x[output[0]], x[output[2]], x[output[4]], x[output[6]]);
        right[i / 4] = sf_four_of(x[output[1]], x[output[3]], x[output[5]], x[output[7]]);
    }
}

SF_FMA static void sf_interpreted_expand(const sf_law *self, const double *p, const sf_drive *drive, double theta,
                                         double u, double v, const sf_four *flow, sf_expansion *x) {
    const sf_interpreted *const all = (const sf_interpreted *)self;
    const sf_recurrence *const by = flow != NULL ? &all->both : &all->force;
    const sf_interpreting of = {by, self->constants + 1, p};
    double over[SF_MOST_SERIES], w[4 * SF_MOST_SERIES];
    sf_four left[SF_MOST_FOURS * SF_TERMS], right[SF_MOST_FOURS * SF_TERMS];
    sf_expand(sf_interpreted_begin, sf_interpreted_next, (const double *)&of, drive, theta, u, v, flow, by->series,
              by->sums / 4, by->value, by->slope, all->linear, over, w, left, right, x);
}

/* ---- reading */

static void sf_read_recurrence(sf_reader *from, int constants, int slope, sf_recurrence *out) {
    out->series = sf_size(from, 1, SF_MOST_SERIES);
    out->sums = 4 * sf_size(from, 0, SF_MOST_FOURS);
    out->value = sf_word(from, 0, out->series - 1);
    out->slope = slope ? sf_word(from, 0, out->series - 1) : 0;
    const int n = out->series, arguments = 3 + constants + 4 * n + out->sums;
    if (arguments > SF_MOST_REGISTERS)
        sf_refuse(from, SF_TOO_LARGE);
    if (from->status != SF_READ)
        return;
    sf_read_straight(from, sf_in_doubles, constants + 1, 2 * (n - 1), &out->begin);
    sf_read_straight(from, sf_in_doubles, arguments, n - 1 + 2 * out->sums, &out->next);
}

/* The law of a piece, which is never let go; NULL where the data is no program, is too large for it, or memory is
 * out. */
static const sf_law *sf_read_law(const char *name, const int *code, size_t count, const double *numbers, size_t length,
                                 sf_reading *status) {
    sf_reader from = {code, code + count, numbers, numbers + length, NULL, SF_READ};
    sf_interpreted *const made = sf_room_for(&from, 1, sizeof *made);
    char *const called = sf_room_for(&from, (int)strlen(name) + 1, 1);
    if (from.status == SF_READ) {
        const int constants = sf_size(&from, 0, SF_MOST_REGISTERS / 4), breaks = sf_word(&from, SF_SMOOTH, SF_BEGINS);
        made->linear = sf_word(&from, 0, 1);
        made->law = (sf_law){strcpy(called, name),
                             constants,
                             (sf_breaks)breaks,
                             sf_interpreted_value,
                             sf_interpreted_slope,
                             sf_interpreted_expand,
                             breaks == SF_BEGINS ? sf_interpreted_begins : NULL,
                             NULL,
                             NULL,
                             NULL};
        sf_read_straight(&from, sf_in_doubles, constants + 2, 1, &made->value);
        sf_read_straight(&from, sf_in_doubles, constants + 2, 1, &made->slope);
        if (breaks == SF_BEGINS)
            sf_read_straight(&from, sf_in_doubles, constants + 2, 1, &made->begins);
        sf_read_recurrence(&from, constants + 1, 0, &made->force);
        sf_read_recurrence(&from, constants + 1, 1, &made->both);
        if (from.word != from.last_word || from.number != from.last_number)
            sf_refuse(&from, SF_NO_PROGRAM);
    }
    *status = from.status;
    if (from.status != SF_READ)
        sf_leave_room(&from);
    return from.status == SF_READ ? &made->law : NULL;
}
