/* Answers with their proof as Python functions: in go a model (records.c) and numbers; out come enclosures, or None
 * where no proof is possible. The solvers run without the GIL, in a workspace of their own.
 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

/* before NumPy, whose complex.h takes the name I */
#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>

/* Intervals as an array of shape (n, 2). */
static PyObject *new_intervals(npy_intp n, double **values)
{
    npy_intp shape[2] = {n, 2};
    PyObject *array = PyArray_SimpleNew(2, shape, NPY_DOUBLE);
    if (array != NULL)
        *values = PyArray_DATA((PyArrayObject *)array);
    return array;
}

/* status, Omega, A, corner, sign, doubts, A_max, bounded, whether there was room */
static PyObject *certificate(int status, const sf_certificate *found)
{
    const npy_intp n = status == SF_OK ? found->n : 0, doubts = status == SF_OK ? found->doubts : 0;
    double *Omega = NULL, *A = NULL, *doubt = NULL;
    PyObject *in_Omega = new_intervals(n, &Omega), *in_A = new_intervals(n, &A),
             *in_doubt = new_intervals(doubts, &doubt);
    PyObject *corner = PyArray_SimpleNew(1, &n, NPY_BOOL), *sign = PyArray_SimpleNew(1, &n, NPY_INT8);
    if (!in_Omega || !in_A || !in_doubt || !corner || !sign) {
        Py_XDECREF(in_Omega), Py_XDECREF(in_A), Py_XDECREF(in_doubt), Py_XDECREF(corner), Py_XDECREF(sign);
        return NULL;
    }
    for (npy_intp i = 0; i < n; i++) {
        Omega[2 * i] = found->at[i].Omega.lo, Omega[2 * i + 1] = found->at[i].Omega.hi;
        A[2 * i] = found->at[i].A.lo, A[2 * i + 1] = found->at[i].A.hi;
        ((npy_bool *)PyArray_DATA((PyArrayObject *)corner))[i] = (npy_bool)found->at[i].corner;
        ((npy_int8 *)PyArray_DATA((PyArrayObject *)sign))[i] = (npy_int8)found->at[i].sign;
    }
    for (npy_intp i = 0; i < doubts; i++)
        doubt[2 * i] = found->doubt[i].lo, doubt[2 * i + 1] = found->doubt[i].hi;
    return Py_BuildValue("iNNNNNdNN", status, in_Omega, in_A, corner, sign, in_doubt, found->A_max,
                         PyBool_FromLong(found->bounded), PyBool_FromLong(!found->full));
}

/* The oscillator that the arguments begin with, and a workspace; 1, 0 where no proof is possible, -1 with an
 * exception. */
static int start(PyObject *capsule, const sf_model **model, const sf_given **given, sf_room **room)
{
    *model = sf_model_in(capsule);
    if (*model == NULL)
        return -1;
    *given = sf_given_in(capsule);
    if (*given == NULL)
        return 0;
    *room = malloc(sizeof **room);
    if (*room == NULL)
        PyErr_NoMemory();
    return *room == NULL ? -1 : 1;
}

static PyObject *certify_folds(PyObject *self, PyObject *args)
{
    PyObject *capsule, *expected;
    double F_0;
    const sf_model *model;
    const sf_given *given;
    sf_room *room;
    sf_status status;
    (void)self;
    if (!PyArg_ParseTuple(args, "OdO", &capsule, &F_0, &expected))
        return NULL;
    PyArrayObject *hints = (PyArrayObject *)PyArray_FROMANY(expected, NPY_DOUBLE, 1, 1, NPY_ARRAY_IN_ARRAY);
    if (hints == NULL)
        return NULL;
    const int started = start(capsule, &model, &given, &room);
    if (started <= 0) {
        Py_DECREF(hints);
        return started < 0 ? NULL : Py_NewRef(Py_None);
    }
    const double *first = PyArray_DATA(hints);
    const int count = (int)PyArray_DIM(hints, 0);
    Py_BEGIN_ALLOW_THREADS
    status = sf_here()->certify_folds(model, given, F_0, first, count, &room->proof, &room->found);
    Py_END_ALLOW_THREADS
    Py_DECREF(hints);
    PyObject *result = certificate(status, &room->found);
    free(room);
    return result;
}

static PyObject *certify_states(PyObject *self, PyObject *args)
{
    PyObject *capsule;
    double F_0, Omega;
    const sf_model *model;
    const sf_given *given;
    sf_room *room;
    sf_status status;
    (void)self;
    if (!PyArg_ParseTuple(args, "Odd", &capsule, &F_0, &Omega))
        return NULL;
    const int started = start(capsule, &model, &given, &room);
    if (started <= 0)
        return started < 0 ? NULL : Py_NewRef(Py_None);
    Py_BEGIN_ALLOW_THREADS
    status = sf_here()->certify_states(model, given, F_0, Omega, &room->proof, &room->found);
    Py_END_ALLOW_THREADS
    PyObject *result = certificate(status, &room->found);
    free(room);
    return result;
}

static PyObject *certify_onset(PyObject *self, PyObject *capsule)
{
    const sf_model *model;
    const sf_given *given;
    sf_room *room;
    sf_proved_onset found = {0};
    sf_status status;
    (void)self;
    const int started = start(capsule, &model, &given, &room);
    if (started <= 0)
        return started < 0 ? NULL : Py_NewRef(Py_None);
    Py_BEGIN_ALLOW_THREADS
    status = sf_here()->certify_onset(model, given, &room->work, &room->proof, &found);
    Py_END_ALLOW_THREADS
    free(room);
    if (status != SF_OK)
        return Py_BuildValue("iN", (int)status, PyBool_FromLong(found.proved));
    return Py_BuildValue("i(dd)(dd)(dd)iN", (int)status, found.F_SN.lo, found.F_SN.hi, found.Omega.lo, found.Omega.hi,
                         found.A.lo, found.A.hi, (int)found.kind, PyBool_FromLong(found.proved));
}

static PyObject *certify_detachment(PyObject *self, PyObject *capsule)
{
    sf_interval F_cr, Omega_cr;
    (void)self;
    if (sf_model_in(capsule) == NULL)
        return NULL;
    const sf_given *given = sf_given_in(capsule);
    if (given == NULL)
        return Py_NewRef(Py_None);
    const sf_status status = sf_here()->certify_detachment(given, &F_cr, &Omega_cr);
    if (status != SF_OK)
        return Py_BuildValue("(i)", (int)status);
    return Py_BuildValue("i(dd)(dd)(dd)", (int)status, F_cr.lo, F_cr.hi, Omega_cr.lo, Omega_cr.hi, given->b[0].lo,
                         given->b[0].hi);
}

static PyMethodDef functions[] = {
    {"certify_folds", certify_folds, METH_VARARGS,
     "(model, F_0, A where folds are expected) -> status, Omega, A, corner, sign of F_AA, doubts, A_max, bounded, "
     "complete; "
     "or None"},
    {"certify_states", certify_states, METH_VARARGS, "(model, F_0, Omega) -> the same, with the sign of F_A; or None"},
    {"certify_onset", certify_onset, METH_O,
     "model -> status, F_SN, Omega, A, kind, whether it is proved; or status and that, or None"},
    {"certify_detachment", certify_detachment, METH_O, "model -> status, F_cr, Omega_cr, u_cr; or None"},
    {NULL, NULL, 0, NULL},
};

int sf_add_certificates(PyObject *module)
{
    if (PyArray_ImportNumPyAPI() < 0)
        return -1;
    return PyModule_AddFunctions(module, functions);
}
