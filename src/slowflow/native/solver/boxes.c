/* The search in boxes (boxes.h) for equations that Python evaluates, on all boxes of a sweep at a time. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "boxes.h"

#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>

/* A new array of numbers, (d, n) or (n,), each a member of things that lie so far apart. */
static PyObject *column(int d, ptrdiff_t n, const void *first, size_t step)
{
    const npy_intp shape[2] = {d, n};
    PyObject *array = PyArray_SimpleNew(2, shape, NPY_DOUBLE);
    if (array != NULL)
        for (ptrdiff_t k = 0; k < n; k++)
            for (int i = 0; i < d; i++)
                *(double *)PyArray_GETPTR2((PyArrayObject *)array, i, k) =
                    ((const double *)(const void *)((const char *)first + (size_t)k * step))[i];
    return array;
}

static PyObject *numbers(ptrdiff_t n, const ptrdiff_t *first, size_t step)
{
    PyObject *array = PyArray_SimpleNew(1, &n, NPY_INTP);
    if (array != NULL)
        for (ptrdiff_t k = 0; k < n; k++)
            *(npy_intp *)PyArray_GETPTR1((PyArrayObject *)array, k) =
                *(const ptrdiff_t *)(const void *)((const char *)first + (size_t)k * step);
    return array;
}

/* One end of what is known of box k, from an array (2, d, n) or (2, d, d, n). */
static sf_interval interval(PyArrayObject *array, int i, int j, npy_intp k)
{
    double end[2];
    for (int up = 0; up < 2; up++)
        end[up] = *(const double *)(PyArray_NDIM(array) == 3 ? PyArray_GETPTR3(array, up, i, k)
                                                             : PyArray_GETPTR4(array, up, i, j, k));
    return sfi_of(end[0], end[1]);
}

/* An array of numbers (2, d, n) or (2, d, d, n) from a tuple's item; NULL with an exception set. */
static PyArrayObject *item(PyObject *tuple, Py_ssize_t number, int axes, int d, ptrdiff_t n)
{
    PyObject *inputs = PyTuple_GetItem(tuple, number);
    PyArrayObject *array =
        inputs == NULL ? NULL : (PyArrayObject *)PyArray_FROMANY(inputs, NPY_DOUBLE, axes, axes, NPY_ARRAY_ALIGNED);
    int fits = array != NULL && PyArray_DIM(array, 0) == 2 && PyArray_DIM(array, axes - 1) == n;
    for (int i = 1; fits && i < axes - 1; i++)
        fits = PyArray_DIM(array, i) == d;
    if (array != NULL && !fits) {
        PyErr_SetString(PyExc_ValueError, "equations gave arrays of another shape than boxes have");
        Py_CLEAR(array);
    }
    return array;
}

/* The function and how many unknowns it takes. */
typedef struct {
    PyObject *on;
    int d;
} called;

/* Asks the function: low, a point, high, numbers of systems -> values there, values and slopes on boxes, and between which
 * ends their solutions are, or all of these but the last. */
static int on(void *self, ptrdiff_t n, const sf_box_place *points, sf_values *out)
{
    const called *of = self;
    const int d = of->d;
    PyArrayObject *known[4] = {NULL};
    PyObject *result = PyObject_CallFunction(
        of->on, "NNNN", column(d, n, points->low, sizeof *points), column(d, n, points->at, sizeof *points),
        column(d, n, points->high, sizeof *points), numbers(n, &points->of, sizeof *points));
    const int count = result != NULL && PyTuple_Check(result) ? (int)PyTuple_Size(result) : 0;
    int done = count >= 3 && count <= 4;
    for (int i = 0; done && i < count; i++)
        done = (known[i] = item(result, i, i == 2 ? 4 : 3, d, n)) != NULL;
    for (ptrdiff_t k = 0; done && k < n; k++)
        for (int i = 0; i < d; i++) {
            out[k].at[i] = interval(known[0], i, 0, k), out[k].on[i] = interval(known[1], i, 0, k);
            out[k].holds[i] = count > 3 ? interval(known[3], i, 0, k) : sfi_of(-HUGE_VAL, HUGE_VAL);
            for (int j = 0; j < d; j++)
                out[k].slope[i][j] = interval(known[2], i, j, k);
        }
    for (int i = 0; i < 4; i++)
        Py_XDECREF((PyObject *)known[i]);
    Py_XDECREF(result);
    if (!done && !PyErr_Occurred())
        PyErr_SetString(PyExc_TypeError, "equations gave no tuple of three or four arrays");
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
                to[of][i] = *(const double *)PyArray_GETPTR2(inputs[of], i, k), boxes[k].doubt[i] = 0;
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
                "NNNN", column(of.d, found.count, found.found, sizeof *found.found),
                numbers(found.count, &found.found->of, sizeof *found.found),
                column(of.d, found.open, found.undecided->middle, sizeof *found.undecided),
                numbers(found.open, &found.undecided->of, sizeof *found.undecided));
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
