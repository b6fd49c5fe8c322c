/* What the files of the binding know of each other: capsules, loops of ufuncs, and the members that a file adds. */
#ifndef SF_SOLVER_H
#define SF_SOLVER_H

#include <stddef.h>

#include "interface.h"

/* Addresses, number of elements and core sizes, strides of the elements and then of the core axes in bytes. */
typedef void sf_gufunc_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data);

sf_gufunc_loop sf_response_roots_loop, sf_fold_roots_loop, sf_peak_roots_loop;
sf_gufunc_loop sf_law_roots_loop, sf_law_peak_roots_loop;
sf_gufunc_loop sf_step_means_loop, sf_ends_loop, sf_moved_loop;
sf_gufunc_loop sf_interval_product_loop, sf_interval_square_loop, sf_interval_inverse_loop;

/* The solvers for this processor. */
const sf_solvers *sf_here(void);

/* What a capsule holds, or NULL with an exception set; a PyObject. */
struct _object;
const sf_mechanism *sf_record_in(struct _object *capsule);
const sf_model *sf_model_in(struct _object *capsule);
/* The same as it was given, or NULL where no proof about it is possible; of a capsule that holds a model. */
const sf_given *sf_given_in(struct _object *capsule);

/* What is made of a record once: kept in the cache by the record's address, which what is made may hold. NULL with an
 * exception set. */
struct _object *sf_kept(struct _object *cache, struct _object *capsule,
                        struct _object *(*make)(const sf_mechanism *record, const void *how), const void *how);

/* As many numbers as the tuple has to hold; -1 with an exception set. */
int sf_read_numbers(struct _object *tuple, int n, const char *name, const char *what, double *values);

/* Members of a module: records and models, questions about one oscillator, those about many, proofs, and the second
 * approximation;
 * -1 with an exception set. */
int sf_add_records(struct _object *module);
int sf_add_answers(struct _object *module);
int sf_add_batches(struct _object *module);
int sf_add_certificates(struct _object *module);
int sf_add_second(struct _object *module);

#endif
