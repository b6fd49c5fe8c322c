/* Proofs about many designs. Takes a record and strided arrays as in many.h; returns numbers of folds or states that
 * are proved, and whether they are.
 */
#ifndef SF_MANY_PROOFS_H
#define SF_MANY_PROOFS_H

#include "certify.h"
#include "many.h"

/* design, damping, F_0 and, for states, Omega -> count, whether it is proved, status */
static void sf_loop_proofs(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps,
                           const sf_mechanism *mechanism, int of_states)
{
    const int forcing = mechanism->design_size + mechanism->damping_size, out = forcing + 1 + of_states;
    sf_proof *proof = malloc(sizeof *proof);
    sf_certificate *found = malloc(sizeof *found);
    ptrdiff_t k;
    for (k = 0; k < dimensions[0]; k++) {
        const double F_0 = sf_input(args, steps, forcing, k),
                     Omega = of_states ? sf_input(args, steps, forcing + 1, k) : 1;
        sf_status status = proof == NULL || found == NULL ? SF_NO_MEMORY : SF_INVALID;
        sf_model model;
        sf_given given;
        int count = 0, proved = 0;
        if (status == SF_INVALID && mechanism->is_forcing(F_0) && Omega > 0 && Omega < HUGE_VAL &&
            sf_design_at(mechanism, args, steps, k, 1, &model)) {
            status = SF_UNRESOLVED;
            if (sf_given_at(mechanism, args, steps, k, &given)) {
                status = of_states ? sf_certify_states(&model, &given, F_0, Omega, proof, found)
                                   : sf_certify_folds(&model, &given, F_0, NULL, 0, proof, found);
                count = status == SF_OK ? found->n : 0;
                proved = status == SF_OK ? sf_is_proved(found) : status == SF_STICKS && found->bounded;
            }
        }
        sf_output_code(args, steps, out, k, count);
        sf_output_code(args, steps, out + 1, k, proved);
        sf_output_code(args, steps, out + 2, k, sf_of_search(status));
    }
    free(found);
    free(proof);
}

static void sf_loop_proved_folds(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_loop_proofs(args, dimensions, steps, data, 0);
}

static void sf_loop_proved_states(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_loop_proofs(args, dimensions, steps, data, 1);
}

#endif
