/* From a loop over contiguous arrays to the inner loop of a NumPy ufunc: in go tables of kernels, out comes `sf_run`.
 *
 * A kernel has one loop for each regime of the force and a function that says which regime holds where. NumPy's strides
 * are dealt with here, in blocks that stay in the cache: strided arguments are copied, constant ones (stride 0) spread
 * once, and where a block holds several regimes each one's elements are put side by side. What is left over of a block
 * that is no multiple of a vector is filled up to one. So every loop sees contiguous arrays of whole vectors that do
 * not overlap, and vectorises.
 */
#ifndef SF_KERNELS_H
#define SF_KERNELS_H

#include <stddef.h>

#include "clones.h"

enum {
    SF_MOST_OPERANDS = 32,
    SF_BLOCK = 256, /* no loop is given more than a block */
    SF_WIDEST = 8   /* numbers in a vector; a loop is given whole vectors */
};

/* The same number, with which a compiler sees that it is one of whole vectors: the code for what would be left over is
 * as long as the loop itself, and loops are long. */
#define SF_WHOLE(n) ((n) & ~(ptrdiff_t)(SF_WIDEST - 1))

/* The head of such a loop. */
#define SF_EACH(i, n) SF_INDEPENDENT for (ptrdiff_t i = 0; i < SF_WHOLE(n); i++)

typedef void (*sf_loop)(ptrdiff_t n, const double *const *in, double *const *out);
typedef void (*sf_choose)(ptrdiff_t n, const double *const *in, unsigned char *regime);

/* The loop of a kernel in one regime: the statements give the `values` of element i of `in`. */
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

/* The table of a kernel with one loop. */
#define SF_ONE(loop) ((const sf_loop[]){loop})

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

#endif
