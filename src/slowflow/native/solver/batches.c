/* The questions about many oscillators as Python functions, one for each row. Takes a record; returns its
 * generalised ufunc.
 *
 * A ufunc's loop is the same for all records and its data is the record. What is made once is kept.
 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <fenv.h>

/* before NumPy, whose complex.h takes the name I */
#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>

enum { MOST_OPERANDS = SF_MOST_PARAMETERS + SF_MOST_DAMPING + 4 + 12 };

/* What NumPy keeps pointers to. */
typedef struct {
    PyUFuncGenericFunction quiet;
    void *data;
    sf_gufunc_loop *loop;
    void *of_loop;
    char types[MOST_OPERANDS];
} kept;

/* A solver tries values that it then discards: the flags that these raise are no fault of the arguments. */
static void quietly(char **operands, const npy_intp *dimensions, const npy_intp *steps, void *data)
{
    const kept *own = data;
    fenv_t before;
    feholdexcept(&before);
    own->loop(operands, dimensions, steps, own->of_loop);
    fesetenv(&before);
}

PyObject *sf_new_ufunc(const char *name, const char *doc, const char *signature, const char *types, sf_gufunc_loop *loop,
                       void *data)
{
    const int operands = (int)strlen(types);
    int inputs = 0;
    kept *own = malloc(sizeof *own);
    if (own == NULL)
        return PyErr_NoMemory();
    *own = (kept){quietly, own, loop, data, {0}};
    for (int i = 0; i < operands; i++)
        own->types[i] = strchr("dD", types[i]) != NULL ? NPY_DOUBLE
                        : types[i] == 'H'              ? NPY_SHORT
                        : types[i] == 'i'              ? NPY_INT
                                                       : NPY_INT8;
    for (const char *at = signature; *at != '-'; at++)
        inputs += *at == '(';
    PyObject *ufunc = PyUFunc_FromFuncAndDataAndSignature(&own->quiet, &own->data, own->types, 1, inputs,
                                                          operands - inputs, PyUFunc_None, name, doc, 0, signature);
    if (ufunc == NULL)
        free(own);
    return ufunc;
}

static void run_batch(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data)
{
    sf_call call = *(const sf_call *)data;
    call.args = args, call.dimensions = dimensions, call.steps = steps;
    call.inner = steps + call.out + strlen(call.row->types);
    call.row->loop(&call);
}

static PyObject *new_batch(const sf_mechanism *record, const void *of_row)
{
    const sf_batch *row = of_row;
    const int inputs = record->design_size + record->damping_size + row->at;
    sf_call *call = malloc(sizeof *call);
    if (call == NULL)
        return PyErr_NoMemory();
    *call = (sf_call){.mechanism = record, .row = row, .out = inputs};
    char signature[4 * MOST_OPERANDS] = "()", types[MOST_OPERANDS + 1] = "d";
    for (int i = 1; i < inputs; i++)
        strcat(signature, ",()"), strcat(types, "d");
    strcat(strcat(signature, "->"), row->shape);
    PyObject *ufunc = sf_new_ufunc(row->name, row->doc, signature, strcat(types, row->types), run_batch, call);
    if (ufunc == NULL)
        free(call);
    return ufunc;
}

int sf_add_batches(PyObject *module)
{
    const sf_solvers *here = sf_here();
    if (PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0)
        return -1;
    for (int i = 0; i < here->count_of_many; i++)
        if (sf_add_maker(module, here->of_many[i].name, here->of_many[i].doc, new_batch, &here->of_many[i]) < 0)
            return -1;
    return 0;
}
