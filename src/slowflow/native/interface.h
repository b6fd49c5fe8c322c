/* What was built for one target, as tables: rows of questions about one oscillator, rows of those about many, and
 * records. The binding to Python reads the rows and knows no question by itself.
 */
#pragma once

#include "certificate.h"

/* The record of every mechanism that the package ships, and what makes one of words and numbers, a program or, where it
 * is sampled, polynomials: with the damping and the excitation of another one. */
typedef struct {
    const sf_mechanism *const *all;
    int count;
    sf_status (*read)(int sampled, const sf_mechanism *like, const char *name, const int *code, ptrdiff_t count,
                      const double *numbers, ptrdiff_t length, sf_mechanism **record);
    void (*free_samples)(const sf_mechanism *record);
} sf_records;

/* ==== Questions about one oscillator ============================================================================== */

/* What items an answer has: a value, or a column of n values. */
typedef enum {
    SF_INTEGER,
    SF_FLAG,
    SF_NUMBER,
    SF_WORDS,
    SF_NUMBERS,   /* of double */
    SF_INTERVALS, /* of sf_interval */
    SF_INTEGERS,  /* of int */
    SF_FLAGS,     /* of int */
    SF_BYTE_FLAGS,
    SF_POSITIVE, /* whether a double is above 0 */
    SF_LONG_INTEGERS
} sf_item_kind;

/* step: bytes from one item to the next */
typedef struct {
    sf_item_kind kind;
    double value;
    long n;
    const void *first;
    ptrdiff_t step;
} sf_item;

enum { SF_MOST_NUMBERS = 5, SF_MOST_ITEMS = 14, SF_MOST_RESERVED = 4 };

/* A question put to an oscillator, and its answer's items.
 *
 * inputs    -- its exact inputs, NULL where no proof about it is possible; exactly: the same in pairs
 * values    -- a list, behind the numbers
 * room      -- a workspace, which items may lie in; so may they in what is reserved
 * goes_on   -- to be called now and then by what takes long: 0 where it is interrupted, and the answer discarded
 */
typedef struct sf_query {
    const sf_model *model;
    const sf_inputs *inputs;
    const sf_exactly *exactly;
    double number[SF_MOST_NUMBERS];
    const double *values;
    ptrdiff_t length;
    sf_room *room;
    int (*goes_on)(struct sf_query *);
    int items, reserved;
    sf_item item[SF_MOST_ITEMS];
    void *reserve[SF_MOST_RESERVED];
} sf_query;

/* numbers: how many it takes behind the oscillator; takes_list: whether a list too; of_given: whether it is one about
 * an oscillator as it was given, else it has no answer */
typedef struct {
    const char *name, *doc;
    int numbers, takes_list, of_given;
    void (*answer)(sf_query *);
} sf_row;

static inline void sf_put(sf_query *q, sf_item_kind kind, double value) {
    q->item[q->items++] = (sf_item){kind, value, 0, NULL, 0};
}

/* A column of n values that lie `step` bytes apart. */
static inline void sf_put_column(sf_query *q, sf_item_kind kind, long n, const void *first, size_t step) {
    q->item[q->items++] = (sf_item){kind, 0, n, first, (ptrdiff_t)step};
}

/* Several of one kind, whose first values lie at places, NULL behind the last. */
static inline void sf_put_columns(sf_query *q, sf_item_kind kind, long n, size_t step, const void *const *first) {
    for (; *first != NULL; first++)
        sf_put_column(q, kind, n, *first, step);
}

/* ==== Questions about many ======================================================================================== */

typedef struct sf_call sf_call;

/* shape, types: of the outputs, behind the design, the damping and `at` numbers more, F_0 and Omega or others; by `d`
 * for double, `b` for int8; with places by `D`, `B`, `H` for short, and `K` for the kinds of folds, which are made of
 * two columns; behind these `n` for how many are taken, as int8, or `i`, as int, where all of a curve is to have its
 * places.
 *
 * loop      -- over its designs
 * answer    -- of one design: its status, which is the last output, then an item for each of the others but `n` and
 *              `i`; no items where it is no design to query
 * of_given  -- whether that needs the oscillator as it was given, not only in pairs
 */
typedef struct {
    const char *name, *shape, *types, *doc;
    int at;
    void (*loop)(sf_call *);
    void (*answer)(sf_query *);
    int of_given;
} sf_batch;

/* A batch, at design k: args[i] + k * steps[i] is operand i of a ufunc, `out` the first of the outputs; inner: the
 * steps of outputs along their places */
struct sf_call {
    const sf_mechanism *mechanism;
    const sf_batch *row;
    int out;
    char **args;
    const ptrdiff_t *dimensions, *steps, *inner;
    ptrdiff_t k;
};

typedef struct {
    const sf_row *of_one;
    const sf_batch *of_many;
    int count_of_one, count_of_many;
    /* of answers by what is known there, not of a record */
    void (*slopes)(const double *in, double *out);
    const sf_records *records;
} sf_solvers;

/* for any processor, and for those with fma */
extern const sf_solvers sf_solvers_baseline, sf_solvers_fma;
extern const sf_records sf_records_baseline, sf_records_fma;
