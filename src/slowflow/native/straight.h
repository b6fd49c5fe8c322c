/* A straight line of operations on registers: the arguments, the constants, then what is computed; its values in
 * doubles, and how it is read.
 *
 * The operations are those of the C that `make derive` prints, in its order and in its arithmetic: so are their bits.
 *
 * Nothing of the data is trusted. `sf_read_straight` refuses an operation that the arithmetic has not, a register that
 * is not there, that holds nothing yet or that is not to be written, and a constant that is not finite.
 */
#pragma once

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "angles.h"
#include "clones.h"
#include "program_conventions.h"

typedef struct {
    unsigned short operation, result, first, second;
} sf_instruction;

/* One straight line; output: the registers of its results. */
typedef struct {
    int arguments, constants, registers, length, outputs;
    const sf_instruction *code;
    const unsigned short *output;
    const double (*constant)[2];
} sf_straight;

/* clang-format off */
/* Functions of one number, as an arithmetic's prefix names them. */
#define SF_OPERATIONS_OF_ONE(OPERATION, prefix)                                                                        \
    OPERATION(SQRT, prefix##sqrt(a)) OPERATION(CBRT, prefix##cbrt(a))                                                  \
    OPERATION(EXP, prefix##exp(a)) OPERATION(LOG, prefix##log(a)) OPERATION(LOG1P, prefix##log1p(a))                   \
    OPERATION(SIN, prefix##sin(a)) OPERATION(COS, prefix##cos(a)) OPERATION(TAN, prefix##tan(a))                       \
    OPERATION(SINH, prefix##sinh(a)) OPERATION(COSH, prefix##cosh(a)) OPERATION(TANH, prefix##tanh(a))                 \
    OPERATION(ASIN, prefix##asin(a)) OPERATION(ACOS, prefix##acos(a)) OPERATION(ATAN, prefix##atan(a))                 \
    OPERATION(ASINH, prefix##asinh(a)) OPERATION(ACOSH, prefix##acosh(a)) OPERATION(ATANH, prefix##atanh(a))
/* What doubles have, with its value at a and b. */
#define SF_OPERATIONS_IN_DOUBLES(OPERATION)                                                                            \
    OPERATION(ADD, a + b) OPERATION(SUB, a - b) OPERATION(MUL, a * b) OPERATION(DIV, a / b) OPERATION(NEG, -a)         \
    OPERATION(ATAN2, angles_atan2(a, b)) OPERATION(ATAN2_SWAPPED, angles_atan2_swapped(a, b))                          \
    OPERATION(POWER, pow(a, b)) OPERATION(HYPOT, hypot(a, b)) OPERATION(ABS, fabs(a))                                  \
    OPERATION(COPYSIGN, copysign(a, b)) SF_OPERATIONS_OF_ONE(OPERATION, )

/* clang-format on */

/* Whether an arithmetic has an operation. */
typedef int sf_arithmetic(int operation);

#define SF_IS_CASE(x, value) case SF_##x##_OPERATION:
#define SF_ARITHMETIC(name, OPERATIONS)                                                                                \
    static inline int name(int operation) {                                                                            \
        switch ((sf_operation)operation) {                                                                             \
            OPERATIONS(SF_IS_CASE)                                                                                     \
            return 1;                                                                                                  \
        default:                                                                                                       \
            return 0;                                                                                                  \
        }                                                                                                              \
    }

SF_ARITHMETIC(sf_in_doubles, SF_OPERATIONS_IN_DOUBLES)

#define SF_OF_LANES(x, value)                                                                                          \
    case SF_##x##_OPERATION:                                                                                           \
        SF_INDEPENDENT                                                                                                 \
        for (k = 0; k < lanes; k++) {                                                                                  \
            const double a = first[k], b = second[k];                                                                  \
            (void)b;                                                                                                   \
            result[k] = (value);                                                                                       \
        }                                                                                                              \
        break;

/* Register r is x[r*lanes] to x[r*lanes + lanes - 1]. */
static inline void sf_run_lanes(const sf_straight *of, double *x, const int lanes) {
    const sf_instruction *at = of->code, *const end = at + of->length;
    int k;
    for (; at < end; at++) {
        double *const result = x + at->result * lanes;
        const double *const first = x + at->first * lanes, *const second = x + at->second * lanes;
        switch ((sf_operation)at->operation) {
            SF_OPERATIONS_IN_DOUBLES(SF_OF_LANES)
        default: /* the arithmetic has no other */
            break;
        }
    }
}
#undef SF_OF_LANES

static SF_FLAT void sf_run(const sf_straight *of, double *x) { sf_run_lanes(of, x, 1); }
static inline void sf_fill(const sf_straight *of, double *x) {
    for (int i = 0; i < of->constants; i++)
        x[of->arguments + i] = of->constant[i][0];
}

/* ---- reading */

typedef enum { SF_READ, SF_NO_PROGRAM, SF_TOO_LARGE, SF_NO_ROOM } sf_reading;

/* room: all that is allocated, each with the one before it at its begin */
typedef struct {
    const int *word, *last_word;
    const double *number, *last_number;
    void *room;
    sf_reading status;
} sf_reader;

static inline void sf_refuse(sf_reader *from, sf_reading status) {
    if (from->status == SF_READ)
        from->status = status;
}

/* The next word if it lies between these, else the least. */
static inline int sf_word(sf_reader *from, int least, int most) {
    if (from->status == SF_READ && from->word < from->last_word && *from->word >= least && *from->word <= most)
        return *from->word++;
    sf_refuse(from, SF_NO_PROGRAM);
    return least;
}

/* A size that may be beyond what a record has room for. */
static inline int sf_size(sf_reader *from, int least, int most) {
    const int size = sf_word(from, least, INT_MAX);
    if (size <= most)
        return size;
    sf_refuse(from, SF_TOO_LARGE);
    return least;
}

static inline double sf_number(sf_reader *from) {
    if (from->status == SF_READ && from->number < from->last_number && !isnan(*from->number))
        return *from->number++;
    sf_refuse(from, SF_NO_PROGRAM);
    return 0;
}

static inline double sf_finite(sf_reader *from) {
    const double number = sf_number(from);
    if (!isfinite(number))
        sf_refuse(from, SF_NO_PROGRAM);
    return number;
}

/* Room for so many items, 0; NULL where there is none. */
static inline void *sf_room_for(sf_reader *from, int items, size_t size) {
    void **made;
    if (from->status != SF_READ)
        return NULL;
    made = calloc(1, 2 * sizeof *made + (size_t)items * size);
    if (made == NULL) {
        sf_refuse(from, SF_NO_ROOM);
        return NULL;
    }
    *made = from->room, from->room = made;
    return made + 2;
}

static inline void sf_read_straight(sf_reader *from, sf_arithmetic has, int arguments, int outputs, sf_straight *out) {
    unsigned char holds[SF_MOST_REGISTERS] = {0};
    sf_instruction *code;
    unsigned short *output;
    double (*constant)[2];
    out->arguments = sf_word(from, arguments, arguments);
    out->constants = sf_size(from, 0, SF_MOST_REGISTERS);
    const int first = out->arguments + out->constants;
    out->registers = sf_size(from, 0, SF_MOST_REGISTERS);
    out->length = sf_word(from, 0, (int)((from->last_word - from->word) / 4));
    out->outputs = sf_word(from, outputs, outputs);
    if (first > out->registers)
        sf_refuse(from, SF_NO_PROGRAM);
    code = sf_room_for(from, out->length, sizeof *code);
    output = sf_room_for(from, out->outputs, sizeof *output);
    constant = sf_room_for(from, out->constants, sizeof *constant);
    if (from->status != SF_READ)
        return;
    memset(holds, 1, (size_t)first);
    for (int i = 0; i < out->length; i++) {
        const int operation = sf_word(from, 0, SF_HYPOT_OPERATION), result = sf_word(from, first, out->registers - 1);
        const int one = sf_word(from, 0, out->registers - 1), other = sf_word(from, 0, out->registers - 1);
        if (from->status != SF_READ || !has(operation) || !holds[one] || !holds[other]) {
            sf_refuse(from, SF_NO_PROGRAM);
            return;
        }
        code[i] = (sf_instruction){(unsigned short)operation, (unsigned short)result, (unsigned short)one,
                                   (unsigned short)other};
        holds[result] = 1;
    }
    for (int i = 0; i < out->outputs; i++) {
        output[i] = (unsigned short)sf_word(from, 0, out->registers - 1);
        if (from->status != SF_READ || !holds[output[i]]) {
            sf_refuse(from, SF_NO_PROGRAM);
            return;
        }
    }
    for (int i = 0; i < out->constants; i++)
        constant[i][0] = sf_finite(from), constant[i][1] = sf_finite(from);
    out->code = code, out->output = output, out->constant = (const double (*)[2])constant;
}

/* Frees all of it. */
static inline void sf_leave_room(sf_reader *from) {
    while (from->room != NULL) {
        void **const last = from->room;
        from->room = *last;
        free(last);
    }
}
