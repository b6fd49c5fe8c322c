/* From a loop over contiguous arrays to the inner loop of a NumPy ufunc. Takes tables of kernels; returns `sf_run`.
 *
 * A kernel has one loop for each regime of the force and a function that says which regime holds where. NumPy's strides
 * are dealt with here, in blocks that stay in the cache: strided arguments are copied, constant ones (stride 0) spread
 * once, and where a block holds several regimes each one's elements are put side by side. What is left over of a block
 * that is no multiple of a vector is filled up to one. So every loop sees contiguous arrays of whole vectors that do
 * not overlap, and vectorises.
 */
#pragma once

#include <stddef.h>

#include "clones.h"

enum {
    SF_MOST_OPERANDS = 32,
    SF_BLOCK = 256 /* no loop is given more than a block, and whole vectors */
};

typedef void (*sf_loop)(ptrdiff_t n, const double *const *in, double *const *out);
typedef void (*sf_choose)(ptrdiff_t n, const double *const *in, unsigned char *regime);

/* Argument k of element i. */
#define X(k) in[k][i]

/* The loop of a kernel in one regime: the statements give the `values` of element i. */
#define SF_LOOP(name, outputs, ...) \
    static SF_WIDE void name(ptrdiff_t n, const double *const *in, double *const *out) \
    { \
        SF_EACH(i, n) { \
            double values[outputs]; \
            __VA_ARGS__ \
            for (int k = 0; k < (outputs); k++) \
                out[k][i] = values[k]; \
        } \
    }

/* Such loops by the function that they call, whose name ends with the regime, empty where there is one: of a number, of
 * several, and of several, `all` with their arguments, that further statements make the values of. */
#define SF_SCALAR(regime, kernel, source, ...) \
    SF_LOOP(kernel##regime##_loop, 1, values[0] = source##regime(__VA_ARGS__);)
#define SF_TUPLE(regime, kernel, outputs, source, ...) \
    SF_LOOP(kernel##regime##_loop, outputs, source##regime(__VA_ARGS__, values);)
#define SF_PART(regime, kernel, outputs, width, source, arguments, ...) \
    SF_LOOP(kernel##regime##_loop, outputs, double all[width]; source##regime arguments; __VA_ARGS__)

/* The function that chooses a kernel's regime by what is declared of element i. The arrays go into a table of its own,
 * as a char that is written may alias the one that is given. */
#define SF_CHOOSE(kernel, inputs, chosen, ...) \
    static SF_WIDE void kernel##_regime(ptrdiff_t n, const double *const *columns, unsigned char *regime) \
    { \
        const double *in[inputs]; \
        for (int k = 0; k < (inputs); k++) \
            in[k] = columns[k]; \
        SF_INDEPENDENT for (ptrdiff_t i = 0; i < n; i++) { \
            __VA_ARGS__; \
            regime[i] = chosen; \
        } \
    }

/* What the table says of a kernel's regimes: of one, and of several, which a kernel's function chooses. */
#define SF_NAMED(regime, kernel) kernel##regime##_loop,
#define SF_ONE(kernel) 1, NULL, (const sf_loop[]){kernel##_loop}
#define SF_SEVERAL(kernel, ...) \
    sizeof((const sf_loop[]){__VA_ARGS__}) / sizeof(sf_loop), kernel##_regime, (const sf_loop[]){__VA_ARGS__}

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
