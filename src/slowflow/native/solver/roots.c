/* The root solvers of roots.h over NumPy's operands. */
#include "roots.h"

#include <fenv.h>
#include <stdint.h>

#include "clones.h"
#include "solver.h"

#define IN(k) (*(const double *)(operands[k] + i * steps[k]))

/* Roots and their number for element i; unused places are NaN. A solver tries values that it then discards: the flags
   that these raise are no fault of the arguments, whose faults the number -1 tells. */
#define ROOTS_LOOP(name, inputs, places, solve)                                                               \
    SF_FMA void name(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)        \
    {                                                                                                         \
        fenv_t before;                                                                                        \
        (void)data;                                                                                           \
        feholdexcept(&before);                                                                                \
        for (ptrdiff_t i = 0; i < dimensions[0]; i++) {                                                       \
            double Omega[places];                                                                             \
            const int32_t count = solve;                                                                      \
            for (int j = 0; j < places; j++)                                                                  \
                *(double *)(operands[inputs] + i * steps[inputs] + j * steps[(inputs) + 2]) = Omega[j];       \
            *(int32_t *)(operands[(inputs) + 1] + i * steps[(inputs) + 1]) = count;                           \
        }                                                                                                     \
        fesetenv(&before);                                                                                    \
    }

ROOTS_LOOP(sf_response_roots_loop, 5, 3, sf_response_roots(IN(0), IN(1), IN(2), IN(3), IN(4), Omega))
ROOTS_LOOP(sf_fold_roots_loop, 5, 3, sf_fold_roots(IN(0), IN(1), IN(2), IN(3), IN(4), Omega))
ROOTS_LOOP(sf_peak_roots_loop, 4, 2, sf_peak_roots(IN(0), IN(1), IN(2), IN(3), Omega))
