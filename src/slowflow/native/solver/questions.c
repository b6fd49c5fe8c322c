/* The questions as Python functions, one for each row.
 *
 * About one oscillator: takes a model (records.c) and what the row takes; returns a tuple of the answer's items, or the
 * only one; the words are slowflow's. The solvers run without the GIL, in a workspace of their own.
 * About many: takes a record; returns its generalised ufunc, which is kept. A ufunc's loop is the same for all records
 * and its data is the record.
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

/* ==== About one oscillator ======================================================================================== */

/* A query that runs without the GIL. */
typedef struct {
    sf_query query;
    PyThreadState *thread;
} running;

static int goes_on(sf_query *q) {
    running *self = (running *)q;
    PyEval_RestoreThread(self->thread);
    const int is_quiet = PyErr_CheckSignals() == 0;
    self->thread = PyEval_SaveThread();
    return is_quiet;
}

/* The values of a column, each made of what is there, into those of an array. */
#define COPIED(type, what, value)                                                                                      \
    for (npy_intp i = 0; i < of->n; i++) {                                                                             \
        const what from = *(const what *)(const void *)((const char *)of->first + i * of->step);                       \
        ((type *)to)[i] = value;                                                                                       \
    }                                                                                                                  \
    break

/* A new array; all kinds of flags become bool, all integers int64. */
static PyObject *column(const sf_item *of) {
    const int is_flag = of->kind == SF_FLAGS || of->kind == SF_BYTE_FLAGS || of->kind == SF_POSITIVE;
    const int is_integer = of->kind == SF_INTEGERS || of->kind == SF_LONG_INTEGERS;
    npy_intp shape[2] = {of->n, 2};
    PyObject *array = PyArray_SimpleNew(of->kind == SF_INTERVALS ? 2 : 1, shape,
                                        is_flag      ? NPY_BOOL
                                        : is_integer ? NPY_INT64
                                                     : NPY_DOUBLE);
    if (array == NULL)
        return NULL;
    void *to = PyArray_DATA((PyArrayObject *)array);
    switch (of->kind) {
    case SF_INTERVALS:
        COPIED(sf_interval, sf_interval, from);
    case SF_INTEGERS:
        COPIED(npy_int64, int, from);
    case SF_LONG_INTEGERS:
        COPIED(npy_int64, long long, from);
    case SF_FLAGS:
        COPIED(npy_bool, int, from != 0);
    case SF_BYTE_FLAGS:
        COPIED(npy_bool, unsigned char, from != 0);
    case SF_POSITIVE:
        COPIED(npy_bool, double, from > 0);
    default:
        COPIED(double, double, from);
    }
    return array;
}

static PyObject *value_of(const sf_item *of) {
    switch (of->kind) {
    case SF_INTEGER:
        return PyLong_FromLong((long)of->value);
    case SF_FLAG:
        return PyBool_FromLong(of->value != 0);
    case SF_NUMBER:
        return PyFloat_FromDouble(of->value);
    case SF_WORDS:
        return PyUnicode_FromString(of->first);
    default:
        return column(of);
    }
}

static PyObject *items_of(const sf_query *q) {
    if (q->items == 0)
        return PyErr_Occurred() ? NULL : PyErr_NoMemory();
    if (q->items == 1)
        return value_of(&q->item[0]);
    PyObject *tuple = PyTuple_New(q->items);
    for (int i = 0; tuple != NULL && i < q->items; i++) {
        PyObject *value = value_of(&q->item[i]);
        if (value == NULL || PyTuple_SetItem(tuple, i, value) < 0)
            Py_CLEAR(tuple);
    }
    return tuple;
}

/* What a row takes, into a query; `list` holds its values. 0 with an exception set. */
static int read_query(const sf_row *row, PyObject *args, sf_query *q, PyArrayObject **list) {
    const int n = 1 + row->numbers + row->takes_list;
    if (PyTuple_Size(args) != n) {
        PyErr_Format(PyExc_TypeError, "%s takes %d arguments, not %zd", row->name, n, PyTuple_Size(args));
        return 0;
    }
    if ((q->model = sf_model_in(PyTuple_GetItem(args, 0), &q->inputs)) == NULL)
        return 0;
    q->exactly = q->inputs == NULL ? NULL : &q->inputs->exactly;
    for (int i = 0; i < row->numbers; i++)
        if ((q->number[i] = PyFloat_AsDouble(PyTuple_GetItem(args, 1 + i))) == -1 && PyErr_Occurred())
            return 0;
    if (row->takes_list) {
        *list = (PyArrayObject *)PyArray_FROMANY(PyTuple_GetItem(args, n - 1), NPY_DOUBLE, 1, 1, NPY_ARRAY_IN_ARRAY);
        if (*list == NULL)
            return 0;
        q->values = PyArray_DATA(*list), q->length = PyArray_DIM(*list, 0);
    }
    return 1;
}

static PyObject *answer(const sf_row *row, running *self) {
    sf_query *q = &self->query;
    if (row->of_given && q->inputs == NULL)
        return Py_NewRef(Py_None);
    if ((q->room = malloc(sizeof *q->room)) == NULL)
        return PyErr_NoMemory();
    self->thread = PyEval_SaveThread();
    row->answer(q);
    PyEval_RestoreThread(self->thread);
    PyObject *result = items_of(q);
    free(q->room);
    while (q->reserved > 0)
        free(q->reserve[--q->reserved]);
    return result;
}

static PyObject *ask(PyObject *of_row, PyObject *args) {
    const sf_row *row = PyCapsule_GetPointer(of_row, NULL);
    running self;
    PyArrayObject *list = NULL;
    self.query.goes_on = goes_on, self.query.items = self.query.reserved = 0;
    PyObject *result = read_query(row, args, &self.query, &list) ? answer(row, &self) : NULL;
    Py_XDECREF((PyObject *)list);
    return result;
}

/* ==== About many ================================================================================================== */

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
static void quietly(char **operands, const npy_intp *dimensions, const npy_intp *steps, void *data) {
    const kept *own = data;
    fenv_t before;
    feholdexcept(&before);
    own->loop(operands, dimensions, steps, own->of_loop);
    fesetenv(&before);
}

PyObject *sf_new_ufunc(const char *name, const char *doc, const char *signature, const char *types,
                       sf_gufunc_loop *loop, void *data) {
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

static void run_batch(char **args, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    sf_call call = *(const sf_call *)data;
    call.args = args, call.dimensions = dimensions, call.steps = steps;
    call.inner = steps + call.out + strlen(call.row->types);
    call.row->loop(&call);
}

static PyObject *new_batch(const sf_mechanism *record, const void *of_row) {
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

int sf_add_questions(PyObject *module) {
    const sf_solvers *here = sf_here();
    if (PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0)
        return -1;
    for (int i = 0; i < here->count_of_one; i++) {
        const sf_row *row = &here->of_one[i];
        if (sf_add_function(module, row->name, row->doc, ask, METH_VARARGS, row) < 0)
            return -1;
    }
    for (int i = 0; i < here->count_of_many; i++) {
        const sf_batch *row = &here->of_many[i];
        if (sf_add_maker(module, row->name, row->doc, new_batch, row) < 0)
            return -1;
    }
    return 0;
}
