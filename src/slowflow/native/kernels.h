/* From a loop over contiguous arrays to the inner loop of a NumPy ufunc. Takes tables of kernels; returns `sf_run`.
 *
 * A kernel has one loop for each regime of the force and a function that finds each element's regime. NumPy's strides
 * are dealt with here, in blocks that stay in the cache: strided arguments are copied, constant ones (stride 0) spread
 * once, and where a block holds several regimes each one's elements are put side by side. What is left over of a block
 * that is no multiple of a vector is filled up to one. So every loop sees contiguous arrays of whole vectors that do
 * not overlap, and vectorises.
 */
#pragma once

#include <stddef.h>

#include "clones.h"

enum {
    SF_MOST_OPERANDS = 64, /* as NumPy */
    SF_BLOCK = 256         /* no loop is given more than a block, and whole vectors */
};

typedef void (*sf_loop)(ptrdiff_t n, const double *const *in, double *const *out);
typedef void (*sf_choose)(ptrdiff_t n, const double *const *in, unsigned char *regime);

/* Argument k of element i. */
#define X(k) in[k][i]

/* The loop of a kernel in one regime: the statements give the `values` of element i. */
#define SF_LOOP(name, outputs, ...)                                                                                    \
    static SF_WIDE void name(ptrdiff_t n, const double *const *in, double *const *out) {                               \
        SF_EACH(i, n) {                                                                                                \
            double values[outputs];                                                                                    \
            __VA_ARGS__                                                                                                \
            for (int k = 0; k < (outputs); k++)                                                                        \
                out[k][i] = values[k];                                                                                 \
        }                                                                                                              \
    }

/* Such loops by the function that they call, whose name ends with the regime, empty where there is one: of a number, of
 * several, and of several, `all` with their arguments, that further statements make the values of. */
#define SF_SCALAR(regime, kernel, source, ...)                                                                         \
    SF_LOOP(kernel##regime##_loop, 1, values[0] = source##regime(__VA_ARGS__);)
#define SF_TUPLE(regime, kernel, outputs, source, ...)                                                                 \
    SF_LOOP(kernel##regime##_loop, outputs, source##regime(__VA_ARGS__, values);)
#define SF_PART(regime, kernel, outputs, width, source, arguments, ...)                                                \
    SF_LOOP(kernel##regime##_loop, outputs, double all[width]; source##regime arguments; __VA_ARGS__)

/* The first n arguments of element i. */
#define SF_ARGUMENTS_1 X(0)
#define SF_ARGUMENTS_2 SF_ARGUMENTS_1, X(1)
#define SF_ARGUMENTS_3 SF_ARGUMENTS_2, X(2)
#define SF_ARGUMENTS_4 SF_ARGUMENTS_3, X(3)
#define SF_ARGUMENTS_5 SF_ARGUMENTS_4, X(4)
#define SF_ARGUMENTS_6 SF_ARGUMENTS_5, X(5)
#define SF_ARGUMENTS_7 SF_ARGUMENTS_6, X(6)
#define SF_ARGUMENTS_8 SF_ARGUMENTS_7, X(7)
#define SF_ARGUMENTS_9 SF_ARGUMENTS_8, X(8)
#define SF_ARGUMENTS_10 SF_ARGUMENTS_9, X(9)
#define SF_ARGUMENTS_11 SF_ARGUMENTS_10, X(10)
#define SF_ARGUMENTS_12 SF_ARGUMENTS_11, X(11)
#define SF_ARGUMENTS_13 SF_ARGUMENTS_12, X(12)
#define SF_ARGUMENTS_14 SF_ARGUMENTS_13, X(13)
#define SF_ARGUMENTS_15 SF_ARGUMENTS_14, X(14)
#define SF_ARGUMENTS_16 SF_ARGUMENTS_15, X(15)
#define SF_ARGUMENTS_17 SF_ARGUMENTS_16, X(16)
#define SF_ARGUMENTS_18 SF_ARGUMENTS_17, X(17)
#define SF_ARGUMENTS_19 SF_ARGUMENTS_18, X(18)
#define SF_ARGUMENTS_20 SF_ARGUMENTS_19, X(19)
#define SF_ARGUMENTS_21 SF_ARGUMENTS_20, X(20)
#define SF_ARGUMENTS_22 SF_ARGUMENTS_21, X(21)
#define SF_ARGUMENTS_23 SF_ARGUMENTS_22, X(22)
#define SF_ARGUMENTS_24 SF_ARGUMENTS_23, X(23)
#define SF_ARGUMENTS_25 SF_ARGUMENTS_24, X(24)
#define SF_ARGUMENTS_26 SF_ARGUMENTS_25, X(25)
#define SF_ARGUMENTS_27 SF_ARGUMENTS_26, X(26)

/* Of a kernel with one regime, whose function takes its arguments in order: the loop, and its entry in the table. */
#define SF_NUMBER(module, name, inputs) SF_SCALAR(, module##_##name, module##_##name, SF_ARGUMENTS_##inputs)
#define SF_NUMBERS(module, name, inputs, outputs)                                                                      \
    SF_TUPLE(, module##_##name, outputs, module##_##name, SF_ARGUMENTS_##inputs)
#define SF_NUMBER_KERNEL(module, name, inputs) {#name, inputs, 1, SF_ONE(module##_##name)},
#define SF_NUMBERS_KERNEL(module, name, inputs, outputs) {#name, inputs, outputs, SF_ONE(module##_##name)},

/* The function that chooses a kernel's regime by what is declared of element i. The arrays go into a table of its own,
 * as a char that is written may alias the one that is given. */
#define SF_CHOOSE(kernel, inputs, chosen, ...)                                                                         \
    static SF_WIDE void kernel##_regime(ptrdiff_t n, const double *const *columns, unsigned char *regime) {            \
        const double *in[inputs];                                                                                      \
        for (int k = 0; k < (inputs); k++)                                                                             \
            in[k] = columns[k];                                                                                        \
        SF_INDEPENDENT                                                                                                 \
        for (ptrdiff_t i = 0; i < n; i++) {                                                                            \
            __VA_ARGS__;                                                                                               \
            regime[i] = chosen;                                                                                        \
        }                                                                                                              \
    }

/* The table's entry for a kernel's regimes: of one, and of several, which a kernel's function chooses. */
#define SF_NAMED(regime, kernel) kernel##regime##_loop,
#define SF_ONE(kernel)                                                                                                 \
    1, NULL, (const sf_loop[]) { kernel##_loop }
#define SF_SEVERAL(kernel, ...)                                                                                        \
    sizeof((const sf_loop[]){__VA_ARGS__}) / sizeof(sf_loop), kernel##_regime, (const sf_loop[]) { __VA_ARGS__ }

/* loops: one for each regime; choose: NULL where there is one regime. What it gives says the function that calls it. */
typedef struct {
    const char *name;
    int inputs, outputs, regimes;
    sf_choose choose;
    const sf_loop *loops;
} sf_kernel;

typedef struct {
    const char *name;
    const sf_kernel *kernels;
    int count;
} sf_module;

/* NumPy's inner loop for the sf_kernel that is its data: addresses, number of elements, strides in bytes. */
void sf_run(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data);
