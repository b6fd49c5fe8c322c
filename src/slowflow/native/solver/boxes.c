/* The search in boxes (boxes.h) for equations that Python evaluates, on all boxes of a sweep at a time. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "boxes.h"

#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>

/* A new array of what n records have at an offset: (n,), or (d, n) of d numbers each. There may be no records. */
static PyObject *member(int type, int d, ptrdiff_t n, const void *records, size_t offset, size_t step) {
    const npy_intp shape[2] = {d, n}, steps[2] = {sizeof(double), (npy_intp)step};
    const int axis = d == 0;
    void *const first = n > 0 ? (char *)(void *)records + offset : NULL;
    PyObject *view = PyArray_New(&PyArray_Type, 2 - axis, shape + axis, type, steps + axis, first, 0, 0, NULL);
    PyObject *array = view == NULL ? NULL : PyArray_NewCopy((PyArrayObject *)view, NPY_CORDER);
    Py_XDECREF(view);
    return array;
}
#define COLUMNS(record, name, d, n, records) member(NPY_DOUBLE, d, n, records, offsetof(record, name), sizeof(record))
#define SYSTEMS(record, n, records) member(NPY_INTP, 0, n, records, offsetof(record, of), sizeof(record))

/* The function and how many unknowns it takes. */
typedef struct {
    PyObject *on;
    int d;
} called;

/* Asks the function: low, high, numbers of systems -> rows of numbers as `sf_values` has them. */
static int on(void *self, ptrdiff_t n, const sf_box_place *points, sf_values *out) {
    const called *of = self;
    PyObject *result =
        PyObject_CallFunction(of->on, "NNN", COLUMNS(sf_box_place, low, of->d, n, points),
                              COLUMNS(sf_box_place, high, of->d, n, points), SYSTEMS(sf_box_place, n, points));
    PyArrayObject *rows =
        result == NULL ? NULL : (PyArrayObject *)PyArray_FROMANY(result, NPY_DOUBLE, 2, 2, NPY_ARRAY_CARRAY_RO);
    const int done = rows != NULL && PyArray_NBYTES(rows) == n * (npy_intp)sizeof *out;
    if (done)
        memcpy(out, PyArray_DATA(rows), (size_t)n * sizeof *out);
    else if (!PyErr_Occurred())
        PyErr_SetString(PyExc_ValueError, "equations gave an array of another shape than boxes have");
    Py_XDECREF(result), Py_XDECREF((PyObject *)rows);
    return done;
}

static PyObject *solve(PyObject *self, PyObject *args) {
    PyObject *result = NULL;
    Py_buffer buffer;
    called of;
    Py_ssize_t most;
    if (!PyArg_ParseTuple(args, "Oiy*n", &of.on, &of.d, &buffer, &most))
        return NULL;
    const ptrdiff_t n = buffer.len / (ptrdiff_t)sizeof(sf_box);
    if (of.d >= 1 && of.d <= SF_MOST_UNKNOWNS && buffer.len == n * (ptrdiff_t)sizeof(sf_box)) {
        const sf_box_equations equations = {of.d, on, &of};
        sf_box *boxes = malloc((size_t)buffer.len + 1);
        sf_solutions found = {0};
        int state = SF_BOXES_NO_ROOM;
        if (boxes != NULL)
            state = sf_solve_boxes(&equations, memcpy(boxes, buffer.buf, (size_t)buffer.len), n, most, &found);
        if (state == SF_BOXES_SOLVED)
            result = Py_BuildValue("NNNN", COLUMNS(sf_solution, x, of.d, found.count, found.found),
                                   SYSTEMS(sf_solution, found.count, found.found),
                                   COLUMNS(sf_solution, middle, of.d, found.open, found.undecided),
                                   SYSTEMS(sf_solution, found.open, found.undecided));
        else if (state == SF_BOXES_TOO_MANY)
            result = Py_NewRef(Py_None);
        else if (state == SF_BOXES_NO_ROOM)
            PyErr_NoMemory();
        free(found.found), free(found.undecided);
    } else
        PyErr_SetString(PyExc_ValueError, "boxes of 1 to 3 unknowns are rows as sf_box of native/boxes.h has them");
    PyBuffer_Release(&buffer);
    return result;
}

static PyMethodDef methods[] = {
    {"solve_boxes", solve, METH_VARARGS,
     "equations, unknowns, boxes, most boxes -> x, of, undecided, its of; None for too many boxes."},
    {NULL, NULL, 0, NULL},
};

int sf_add_boxes(PyObject *module) {
    return PyArray_ImportNumPyAPI() < 0 ? -1 : PyModule_AddFunctions(module, methods);
}
