/* The root solvers over NumPy's operands: of the response by blocks (root_lanes.h), what these leave and the others by
   roots.h, by other laws of damping by laws.h. */
#include "laws.h"
#include "root_lanes.h"

#include <stdint.h>

#include "clones.h"
#include "solver.h"

#define IN(k) (*(const double *)(operands[k] + i * steps[k]))

/* Roots and their number for element i; unused places are NaN. A solver tries values that it then discards: the flags
   that these raise are no fault of the arguments, whose faults have the number -1. */
#define ROOTS_LOOP(name, inputs, most, solve)                                                                          \
    SF_FMA void name(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {               \
        (void)data;                                                                                                    \
        for (ptrdiff_t i = 0; i < dimensions[0]; i++) {                                                                \
            double Omega[most];                                                                                        \
            const int32_t count = solve;                                                                               \
            for (int j = 0; j < most; j++)                                                                             \
                *(double *)(operands[inputs] + i * steps[inputs] + j * steps[(inputs) + 2]) = Omega[j];                \
            *(int32_t *)(operands[(inputs) + 1] + i * steps[(inputs) + 1]) = count;                                    \
        }                                                                                                              \
    }

/* The roots of the first n quartics of a block, three places for each, and their numbers. */
SF_FMA static void roots_of_block(ptrdiff_t n, sf_quartics *block, sf_jobs *jobs, double Omega[][3], int32_t *count) {
    jobs->n = 0;
    sf_isolate_lanes(n, block);
    for (int i = 0; i < n; i++) {
        sf_place place[3];
        count[i] = block->signs[i] == SF_UNSURE ? -1 : sf_places_of_signs((int)block->signs[i], place);
        for (int j = 0; j < 3; j++)
            Omega[i][j] = NAN;
        for (int j = 0; j < count[i]; j++)
            sf_add_job(block, i, place[j], jobs);
    }
    sf_refine_lanes(jobs);
    for (int k = 0, j = 0; k < jobs->n; k++) {
        const int i = jobs->of[k];
        j = k > 0 && jobs->of[k - 1] == i ? j + 1 : 0;
        Omega[i][j] = sf_root_of_job(jobs, k);
    }
    for (int i = 0; i < n; i++)
        if (count[i] == -1)
            count[i] =
                sf_response_roots(block->A[i], block->h[i], block->m[i], block->zeta[i], block->F_0[i], Omega[i]);
}

void sf_response_roots_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_quartics block;
    sf_jobs jobs;
    (void)data;
    for (ptrdiff_t first = 0; first < dimensions[0]; first += SF_QUARTICS) {
        const ptrdiff_t left = dimensions[0] - first, n = left < SF_QUARTICS ? left : SF_QUARTICS;
        double Omega[SF_QUARTICS][3];
        int32_t count[SF_QUARTICS];
        for (ptrdiff_t k = 0; k < n; k++) {
            const ptrdiff_t i = first + k;
            block.A[k] = IN(0), block.h[k] = IN(1), block.m[k] = IN(2), block.zeta[k] = IN(3), block.F_0[k] = IN(4);
        }
        roots_of_block(n, &block, &jobs, Omega, count);
        for (ptrdiff_t k = 0; k < n; k++) {
            const ptrdiff_t i = first + k;
            for (int j = 0; j < 3; j++)
                *(double *)(operands[5] + i * steps[5] + j * steps[7]) = Omega[k][j];
            *(int32_t *)(operands[6] + i * steps[6]) = count[k];
        }
    }
}

ROOTS_LOOP(sf_fold_roots_loop, 5, 3, sf_fold_roots(IN(0), IN(1), IN(2), IN(3), IN(4), Omega))
ROOTS_LOOP(sf_peak_roots_loop, 4, 2, sf_peak_roots(IN(0), IN(1), IN(2), IN(3), Omega))

/* Roots by other laws of damping of element i, places behind the last NaN. Operands are A, h and maybe h_A, from `k` on
   m, zeta, eta and d, and last whether inertia excites. */
#define LAW_ROOTS_LOOP(name, k, inputs, most, solve)                                                                   \
    void name(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {                      \
        (void)data;                                                                                                    \
        for (ptrdiff_t i = 0; i < dimensions[0]; i++) {                                                                \
            const sf_sample at = {.A = IN(0), .h = IN(1), .h_A = (k) > 2 ? IN(2) : 0};                                 \
            const sf_mechanism record = {.inertial = IN((inputs) - 1) != 0};                                           \
            sf_model model = {.mechanism = &record};                                                                   \
            double Omega[most];                                                                                        \
            model.m = IN(k), model.zeta = IN((k) + 1), model.eta = IN((k) + 2), model.d = IN((k) + 3);                 \
            const int n = solve;                                                                                       \
            char *to = operands[inputs] + i * steps[inputs];                                                           \
            for (int j = 0; j < most; j++, to += steps[(inputs) + 1])                                                  \
                *(double *)to = j < n ? Omega[j] : NAN;                                                                \
        }                                                                                                              \
    }

LAW_ROOTS_LOOP(sf_law_roots_loop, 3, 9, 3,
               sf_law_frequencies(&model, &at, IN(7) < 0 ? SF_OF_FOLDS : SF_OF_RESPONSE, IN(7), 0, Omega))
LAW_ROOTS_LOOP(sf_law_peak_roots_loop, 2, 7, 2, sf_law_stationary(&model, &at, Omega))
