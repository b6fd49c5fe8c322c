/* The inner loops of the solver's generalised ufuncs: NumPy's operands in, the solvers' answers out. */
#ifndef SF_SOLVER_H
#define SF_SOLVER_H

#include <stddef.h>

/* Addresses, number of elements and core sizes, strides of the elements and then of the core axes in bytes. */
typedef void sf_gufunc_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data);

sf_gufunc_loop sf_response_roots_loop, sf_fold_roots_loop, sf_peak_roots_loop;

/* The solvers of whole questions (answers.c) as further members of a module, a PyObject; -1 with an exception set. */
struct _object;
int sf_add_answers(struct _object *module);

#endif
