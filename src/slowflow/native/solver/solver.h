/* What the files of the binding know of each other: capsules, loops of ufuncs, and the members that a file adds. */
#pragma once

#include <stddef.h>

#include "interface.h"

/* Addresses, number of elements and core sizes, strides of the elements and then of the core axes in bytes. */
typedef void sf_gufunc_loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data);

sf_gufunc_loop sf_response_roots_loop, sf_fold_roots_loop, sf_peak_roots_loop;
sf_gufunc_loop sf_law_roots_loop, sf_law_peak_roots_loop;
sf_gufunc_loop sf_step_means_loop, sf_ends_loop, sf_on_balance_loop, sf_ended_state_loop, sf_ended_fold_loop;
sf_gufunc_loop sf_curved_means_loop, sf_curved_between_loop, sf_ended_edge_loop, sf_may_be_state_loop,
    sf_folds_between_loop, sf_slopes_loop;

/* The solvers for this processor. */
const sf_solvers *sf_here(void);

/* What a capsule holds, or NULL with an exception set; a PyObject. inputs: its exact inputs, NULL where no proof
 * about it is possible */
struct _object;
const sf_mechanism *sf_record_in(struct _object *capsule);
const sf_model *sf_model_in(struct _object *capsule, const sf_inputs **inputs);

/* A generalised ufunc of a loop, for as long as the process lives; types: of all operands, `d`, `b`, `h` and `i` for
 * double, int8, short and int. NULL with an exception set. */
struct _object *sf_new_ufunc(const char *name, const char *doc, const char *signature, const char *types,
                             sf_gufunc_loop *loop, void *data);

/* Adds a function to a module, which finds `data` in the capsule that is its first argument; -1 with an exception. */
int sf_add_function(struct _object *module, const char *name, const char *doc,
                    struct _object *(*call)(struct _object *, struct _object *), int flags, const void *data);

/* Adds a function of a record to a module: what is made of it and `how`, which is made once, and may hold its address.
 * Its maker returns NULL with an exception set. -1 with an exception */
int sf_add_maker(struct _object *module, const char *name, const char *doc,
                 struct _object *(*make)(const sf_mechanism *record, const void *how), const void *how);

/* Members of a module: records and models, questions about one oscillator and about many, the search in boxes,
 * operations on intervals; -1 with an exception set. */
int sf_add_records(struct _object *module);
int sf_add_questions(struct _object *module);
int sf_add_boxes(struct _object *module);
int sf_add_intervals(struct _object *module);
