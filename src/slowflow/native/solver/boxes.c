/* The search in boxes (boxes.h) for equations that Python evaluates, on all boxes of a sweep at a time. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "boxes.h"

#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>

/* A new array of numbers, (d, n) or (n,), from a member of n records, given by its offset: there may be none of these. */
static PyObject *column(int d, ptrdiff_t n, const void *records, size_t offset, size_t step)
{
    const npy_intp shape[2] = {d, n};
    PyObject *array = PyArray_SimpleNew(2, shape, NPY_DOUBLE);
    if (array != NULL)
        for (ptrdiff_t k = 0; k < n; k++)
            for (int i = 0; i < d; i++)
                *(double *)PyArray_GETPTR2((PyArrayObject *)array, i, k) =
                    ((const double *)(const void *)((const char *)records + offset + (size_t)k * step))[i];
    return array;
}

static PyObject *numbers(ptrdiff_t n, const void *records, size_t offset, size_t step)
{
    PyObject *array = PyArray_SimpleNew(1, &n, NPY_INTP);
    if (array != NULL)
        for (ptrdiff_t k = 0; k < n; k++)
            *(npy_intp *)PyArray_GETPTR1((PyArrayObject *)array, k) =
                *(const ptrdiff_t *)(const void *)((const char *)records + offset + (size_t)k * step);
    return array;
}

/* The function and how many unknowns it takes. */
typedef struct {
    PyObject *on;
    int d;
} called;

/* Asks the function: low, high, numbers of systems -> rows of numbers as `sf_values` has them. */
static int on(void *self, ptrdiff_t n, const sf_box_place *points, sf_values *out)
{
    const called *of = self;
    PyObject *result = PyObject_CallFunction(
        of->on, "NNN", column(of->d, n, points, offsetof(sf_box_place, low), sizeof *points),
        column(of->d, n, points, offsetof(sf_box_place, high), sizeof *points),
        numbers(n, points, offsetof(sf_box_place, of), sizeof *points));
    PyArrayObject *rows = result == NULL ? NULL
                                         : (PyArrayObject *)PyArray_FROMANY(result, NPY_DOUBLE, 2, 2, NPY_ARRAY_CARRAY_RO);
    const int done = rows != NULL && PyArray_NBYTES(rows) == n * (npy_intp)sizeof *out;
    if (done)
        memcpy(out, PyArray_DATA(rows), (size_t)n * sizeof *out);
    else if (!PyErr_Occurred())
        PyErr_SetString(PyExc_ValueError, "equations gave an array of another shape than boxes have");
    Py_XDECREF(result), Py_XDECREF((PyObject *)rows);
    return done;
}

/* Boxes from five arrays (d, n) and (n,): low, high, least, most, of; NULL with an exception set. */
static sf_box *read_boxes(PyArrayObject *const *inputs, int d, ptrdiff_t n)
{
    sf_box *boxes = malloc((size_t)(n > 0 ? n : 1) * sizeof *boxes);
    if (boxes == NULL)
        PyErr_NoMemory();
    for (ptrdiff_t k = 0; boxes != NULL && k < n; k++) {
        double *const to[4] = {boxes[k].low, boxes[k].high, boxes[k].least, boxes[k].most};
        boxes[k].of = *(const npy_intp *)PyArray_GETPTR1(inputs[4], k);
        for (int i = 0; i < d; i++)
            for (int of = 0; of < 4; of++)
                to[of][i] = *(const double *)PyArray_GETPTR2(inputs[of], i, k), boxes[k].error[i] = 0;
    }
    return boxes;
}

static PyObject *solve(PyObject *self, PyObject *args)
{
    PyObject *from[5], *result = NULL;
    PyArrayObject *inputs[5] = {NULL};
    called of;
    Py_ssize_t most;
    int fits = 1;
    (void)self;
    if (!PyArg_ParseTuple(args, "OOOOOOn", &of.on, &from[0], &from[1], &from[2], &from[3], &from[4], &most))
        return NULL;
    for (int i = 0; fits && i < 5; i++) {
        const int axes = i < 4 ? 2 : 1;
        inputs[i] =
            (PyArrayObject *)PyArray_FROMANY(from[i], i < 4 ? NPY_DOUBLE : NPY_INTP, axes, axes, NPY_ARRAY_ALIGNED);
        fits = inputs[i] != NULL && PyArray_DIM(inputs[i], axes - 1) == PyArray_DIM(inputs[0], 1) &&
               (i == 4 || PyArray_DIM(inputs[i], 0) == PyArray_DIM(inputs[0], 0));
    }
    of.d = fits ? (int)PyArray_DIM(inputs[0], 0) : 0;
    if (fits && of.d >= 1 && of.d <= SF_MOST_UNKNOWNS) {
        const ptrdiff_t n = PyArray_DIM(inputs[0], 1);
        const sf_box_equations equations = {of.d, on, &of};
        sf_box *boxes = read_boxes(inputs, of.d, n);
        sf_solutions found;
        const int state = boxes == NULL ? SF_BOXES_NOT_EVALUATED : sf_solve_boxes(&equations, boxes, n, most, &found);
        if (state == SF_BOXES_SOLVED)
            result = Py_BuildValue(
                "NNNN", column(of.d, found.count, found.found, offsetof(sf_solution, x), sizeof *found.found),
                numbers(found.count, found.found, offsetof(sf_solution, of), sizeof *found.found),
                column(of.d, found.open, found.undecided, offsetof(sf_solution, middle), sizeof *found.undecided),
                numbers(found.open, found.undecided, offsetof(sf_solution, of), sizeof *found.undecided));
        else if (state == SF_BOXES_TOO_MANY)
            result = Py_NewRef(Py_None);
        else if (state == SF_BOXES_NO_ROOM)
            PyErr_NoMemory();
        if (boxes != NULL)
            free(found.found), free(found.undecided);
    } else if (!PyErr_Occurred())
        PyErr_SetString(PyExc_ValueError, "boxes are arrays (d, n), d from 1 to 3, and their systems one (n,)");
    for (int i = 0; i < 5; i++)
        Py_XDECREF((PyObject *)inputs[i]);
    return result;
}

static PyMethodDef methods[] = {
    {"solve_boxes", solve, METH_VARARGS,
     "equations, low, high, least, most, of, most boxes -> x, of, undecided, its of; None for too many boxes."},
    {NULL, NULL, 0, NULL},
};

int sf_add_boxes(PyObject *module)
{
    return PyArray_ImportNumPyAPI() < 0 ? -1 : PyModule_AddFunctions(module, methods);
}
