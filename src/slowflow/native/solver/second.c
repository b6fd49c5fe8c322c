/* The second approximation of one oscillator as Python functions: in go a model, and points or answers of the first
 * approximation, out come arrays and numbers; the words are slowflow's. A curve stays here, as a capsule, for what is
 * asked about it. The solvers run without the GIL.
 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

/* before NumPy, whose complex.h takes the name I */
#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>

#define CURVE "slowflow second curve"

static void free_curve(PyObject *capsule)
{
    sf_here()->second_free(PyCapsule_GetPointer(capsule, CURVE));
}

/* Contiguous values of a one-dimensional array, which is given away in `*array`; NULL with an exception set. */
static const void *values_of(PyObject *given, int type, PyArrayObject **array)
{
    *array = (PyArrayObject *)PyArray_FROMANY(given, type, 1, 1, NPY_ARRAY_IN_ARRAY);
    return *array == NULL ? NULL : PyArray_DATA(*array);
}

/* A curve as a dictionary: the capsule, a column for each number of its points, and what was lost. */
static PyObject *told(sf_second_curve *curve, PyObject *capsule)
{
    const npy_intp n = curve->n, parts = curve->parts;
    static const char *const names[] = {"Omega", "A", "u_max", "A_1", "phi"};
    double *columns[5] = {NULL};
    npy_bool *stable = NULL, *closed = NULL;
    npy_int64 *part = NULL;
    PyObject *result = PyDict_New();
    int failed = result == NULL;
    for (int i = 0; i < 5 && !failed; i++) {
        PyObject *array = PyArray_SimpleNew(1, &n, NPY_DOUBLE);
        failed = array == NULL || PyDict_SetItemString(result, names[i], array) < 0;
        columns[i] = array == NULL ? NULL : PyArray_DATA((PyArrayObject *)array);
        Py_XDECREF((PyObject *)array);
    }
    PyObject *flags = PyArray_SimpleNew(1, &n, NPY_BOOL), *numbers = PyArray_SimpleNew(1, &n, NPY_INT64);
    PyObject *whole = PyArray_SimpleNew(1, &parts, NPY_BOOL);
    PyObject *lost = Py_BuildValue("lldd", curve->lost, curve->of, curve->lost_low, curve->lost_high);
    failed = failed || flags == NULL || numbers == NULL || whole == NULL || lost == NULL ||
             PyDict_SetItemString(result, "stable", flags) < 0 || PyDict_SetItemString(result, "part", numbers) < 0 ||
             PyDict_SetItemString(result, "closed", whole) < 0 || PyDict_SetItemString(result, "lost", lost) < 0 ||
             PyDict_SetItemString(result, "curve", capsule) < 0;
    if (!failed) {
        stable = PyArray_DATA((PyArrayObject *)flags), part = PyArray_DATA((PyArrayObject *)numbers);
        closed = PyArray_DATA((PyArrayObject *)whole);
        for (npy_intp i = 0; i < n; i++) {
            const sf_second_point *point = &curve->point[i];
            columns[0][i] = point->Omega, columns[1][i] = point->A, columns[2][i] = point->at.u_max;
            columns[3][i] = point->at.A_1, columns[4][i] = point->at.phi;
            stable[i] = point->at.F_A > 0, part[i] = point->part;
        }
        memcpy(closed, curve->closed, (size_t)parts);
    }
    Py_XDECREF(flags);
    Py_XDECREF(numbers);
    Py_XDECREF(whole);
    Py_XDECREF(lost);
    if (failed)
        Py_CLEAR(result);
    return result;
}

static PyObject *second_follow(PyObject *self, PyObject *args)
{
    PyObject *given, *columns[4], *result = NULL;
    PyArrayObject *kept[4] = {NULL};
    const int types[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_INT64, NPY_BOOL};
    const void *values[4];
    double F_0;
    sf_second_curve *curve;
    int i, wanted;
    (void)self;
    if (!PyArg_ParseTuple(args, "OdiOOOO", &given, &F_0, &wanted, &columns[0], &columns[1], &columns[2], &columns[3]))
        return NULL;
    const sf_model *model = sf_model_in(given);
    for (i = 0; i < 4 && model != NULL; i++)
        if ((values[i] = values_of(columns[i], types[i], &kept[i])) == NULL)
            break;
    if (model != NULL && i == 4) {
        const long n = (long)PyArray_DIM(kept[0], 0);
        Py_BEGIN_ALLOW_THREADS
        curve = sf_here()->second_follow(model, F_0, (sf_wanted)wanted, n, values[0], values[1], values[2], values[3]);
        Py_END_ALLOW_THREADS
        PyObject *capsule = curve == NULL ? PyErr_NoMemory() : PyCapsule_New(curve, CURVE, free_curve);
        if (capsule != NULL) {
            result = told(curve, capsule);
            Py_DECREF(capsule);
        } else if (curve != NULL) {
            sf_here()->second_free(curve);
        }
    }
    for (i = 0; i < 4; i++)
        Py_XDECREF((PyObject *)kept[i]);
    return result;
}

/* The model, the forcing and the curve of a question about a curve; 0 with an exception set. */
static int asked_of(PyObject *args, const sf_model **model, double *F_0, const sf_second_curve **curve, PyObject **more)
{
    PyObject *given, *capsule;
    if (!PyArg_ParseTuple(args, "OdO|O", &given, F_0, &capsule, more))
        return 0;
    *model = sf_model_in(given);
    *curve = *model == NULL ? NULL : PyCapsule_GetPointer(capsule, CURVE);
    return *curve != NULL;
}

static PyObject *second_folds(PyObject *self, PyObject *args)
{
    const sf_model *model;
    const sf_second_curve *curve;
    sf_second_folds found;
    double F_0;
    PyObject *more = NULL;
    (void)self;
    if (!asked_of(args, &model, &F_0, &curve, &more))
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    sf_here()->second_folds(model, F_0, curve, &found);
    Py_END_ALLOW_THREADS
    PyObject *list = PyList_New(0);
    for (int i = 0; list != NULL && i < found.n; i++) {
        const sf_second_fold *fold = &found.at[i];
        PyObject *item = Py_BuildValue("dddii", fold->Omega, fold->u_max, fold->A_1, fold->up, fold->corner);
        if (item == NULL || PyList_Append(list, item) < 0)
            Py_CLEAR(list);
        Py_XDECREF(item);
    }
    return list == NULL ? NULL : Py_BuildValue("iNii", (int)found.status, list, found.lost, found.tried);
}

/* The states at one frequency, appended to a list; -1 with an exception set. */
static int append_states(const sf_model *model, double F_0, const sf_second_curve *curve, double Omega, PyObject *list)
{
    const long most = sf_here()->second_most(curve, Omega);
    sf_second_point *found = malloc((size_t)(most + 1) * sizeof *found);
    int n, i, failed = 0;
    if (found == NULL) {
        PyErr_NoMemory();
        return -1;
    }
    Py_BEGIN_ALLOW_THREADS
    n = sf_here()->second_states(model, F_0, curve, Omega, found);
    Py_END_ALLOW_THREADS
    for (i = 0; i < n && !failed; i++) {
        const sf_balance *at = &found[i].at;
        PyObject *item = Py_BuildValue("ddddi", Omega, at->u_max, at->A_1, at->phi, at->F_A > 0);
        failed = item == NULL || PyList_Append(list, item) < 0;
        Py_XDECREF(item);
    }
    free(found);
    return failed || PyErr_CheckSignals() < 0 ? -1 : 0;
}

static PyObject *second_states(PyObject *self, PyObject *args)
{
    const sf_model *model;
    const sf_second_curve *curve;
    double F_0;
    PyObject *asked = NULL;
    PyArrayObject *array = NULL;
    (void)self;
    if (!asked_of(args, &model, &F_0, &curve, &asked) || asked == NULL)
        return NULL;
    const double *Omega = values_of(asked, NPY_DOUBLE, &array);
    PyObject *list = Omega == NULL ? NULL : PyList_New(0);
    for (npy_intp i = 0; list != NULL && i < PyArray_DIM(array, 0); i++)
        if (append_states(model, F_0, curve, Omega[i], list) < 0)
            Py_CLEAR(list);
    Py_XDECREF((PyObject *)array);
    return list;
}

static PyObject *second_peak(PyObject *self, PyObject *args)
{
    const sf_model *model;
    const sf_second_curve *curve;
    sf_second_point top;
    double F_0;
    PyObject *more = NULL;
    (void)self;
    if (!asked_of(args, &model, &F_0, &curve, &more))
        return NULL;
    memset(&top, 0, sizeof top);
    const sf_second_status status = sf_here()->second_peak(model, F_0, curve, &top);
    return Py_BuildValue("idd", (int)status, top.at.u_max, top.Omega);
}

static PyObject *second_onset(PyObject *self, PyObject *args)
{
    PyObject *given;
    sf_onset first = {0, 0, 0, SF_CUSP_KIND, HUGE_VAL}, found = {NAN, NAN, NAN, SF_NO_KIND, HUGE_VAL};
    double u_max = NAN;
    (void)self;
    if (!PyArg_ParseTuple(args, "Oddd", &given, &first.F_SN, &first.Omega, &first.A))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL)
        return NULL;
    const sf_second_status status = sf_here()->second_cusp(model, &first, &found, &u_max);
    return Py_BuildValue("iddd", (int)status, found.F_SN, found.Omega, u_max);
}

static PyObject *second_detachment(PyObject *self, PyObject *args)
{
    PyObject *given;
    double F_first, Omega_first, u_cr, F_cr = NAN, Omega_cr = NAN;
    (void)self;
    if (!PyArg_ParseTuple(args, "Oddd", &given, &F_first, &Omega_first, &u_cr))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL)
        return NULL;
    const sf_second_status status = sf_here()->second_detach(model, F_first, Omega_first, u_cr, &F_cr, &Omega_cr);
    return Py_BuildValue("idd", (int)status, F_cr, Omega_cr);
}

/* Whether the record knows the spring's harmonics. */
static PyObject *has_second(PyObject *self, PyObject *given)
{
    (void)self;
    const sf_model *model = sf_model_in(given);
    return model == NULL ? NULL : PyBool_FromLong(model->mechanism->harmonics != NULL);
}

static PyMethodDef functions[] = {
    {"second_follow", second_follow, METH_VARARGS,
     "(model, F_0, wanted, Omega, A, branch, closed) of the first approximation -> columns, closed parts, (lost, of, "
     "from, to), curve"},
    {"second_folds", second_folds, METH_VARARGS,
     "(model, F_0, curve) -> status, [(Omega, u_max, A_1, up, corner)], lost, tried"},
    {"second_states", second_states, METH_VARARGS, "(model, F_0, curve, Omega) -> [(Omega, u_max, A_1, phi, stable)]"},
    {"second_peak", second_peak, METH_VARARGS, "(model, F_0, curve) -> status, u_max, Omega"},
    {"second_onset", second_onset, METH_VARARGS, "(model, F_SN, Omega, A) of a cusp -> status, F_SN, Omega, u_max"},
    {"second_detachment", second_detachment, METH_VARARGS, "(model, F_cr, Omega_cr, u_cr) -> status, F_cr, Omega_cr"},
    {"has_second", has_second, METH_O, "(model) -> whether the spring's harmonics are known"},
    {NULL, NULL, 0, NULL},
};

int sf_add_second(PyObject *module)
{
    if (PyArray_ImportNumPyAPI() < 0)
        return -1;
    return PyModule_AddFunctions(module, functions);
}
