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

static PyObject *left_out(const sf_left_out *left)
{
    return Py_BuildValue("lldd", left->lost, left->of, left->low, left->high);
}

/* What a curve is told by: a column for each number of its points, then one for its parts, then what is left out. */
static PyObject *told(const sf_second_curve *curve)
{
    const npy_intp n = curve->n, parts = curve->parts;
    static const int types[] = {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_BOOL, NPY_INT64, NPY_BOOL};
    enum { COLUMNS = sizeof types / sizeof *types, CLOSED = COLUMNS - 1 };
    PyObject *tuple = PyTuple_New(COLUMNS + 1), *left = tuple == NULL ? NULL : left_out(&curve->left);
    void *columns[COLUMNS];
    int failed = left == NULL;
    if (!failed)
        PyTuple_SetItem(tuple, COLUMNS, left);
    for (int i = 0; i < COLUMNS && !failed; i++) {
        PyObject *array = PyArray_SimpleNew(1, i == CLOSED ? &parts : &n, types[i]);
        if (array != NULL)
            columns[i] = PyArray_DATA((PyArrayObject *)array), PyTuple_SetItem(tuple, i, array);
        failed = array == NULL;
    }
    if (failed) {
        Py_XDECREF(tuple);
        return NULL;
    }
    double *const *numbers = (double *const *)columns;
    npy_bool *stable = columns[5];
    npy_int64 *part = columns[6];
    for (npy_intp i = 0; i < n; i++) {
        const sf_second_point *point = &curve->point[i];
        numbers[0][i] = point->Omega, numbers[1][i] = point->A, numbers[2][i] = point->at.u_max;
        numbers[3][i] = point->at.A_1, numbers[4][i] = point->at.phi;
        stable[i] = point->at.F_A > 0, part[i] = point->part;
    }
    if (parts > 0)
        memcpy(columns[CLOSED], curve->closed, (size_t)parts);
    return tuple;
}

static sf_room *new_room(void)
{
    sf_room *room = malloc(sizeof *room);
    if (room == NULL)
        PyErr_NoMemory();
    return room;
}

static PyObject *second_curve(PyObject *self, PyObject *args)
{
    PyObject *given, *capsule, *columns;
    double F_0, samples, low, high;
    sf_second_curve *curve;
    sf_status status;
    sf_room *room;
    int wanted;
    (void)self;
    if (!PyArg_ParseTuple(args, "Odiddd", &given, &F_0, &wanted, &samples, &low, &high))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL || (room = new_room()) == NULL)
        return NULL;
    const sf_given *exactly = sf_given_in(given);
    Py_BEGIN_ALLOW_THREADS
    curve = sf_here()->second_response(model, exactly, F_0, (sf_wanted)wanted, samples, low, high, room, &status);
    Py_END_ALLOW_THREADS
    free(room);
    if (curve == NULL) {
        const sf_second_curve nothing = {0};
        return Py_BuildValue("iNO", (int)status, told(&nothing), Py_None);
    }
    if ((capsule = PyCapsule_New(curve, CURVE, free_curve)) == NULL) {
        sf_here()->second_free(curve);
        return NULL;
    }
    if ((columns = told(curve)) == NULL) {
        Py_DECREF(capsule);
        return NULL;
    }
    return Py_BuildValue("iNN", (int)status, columns, capsule);
}

/* Folds as a list; NULL with an exception set. */
static PyObject *list_of(const sf_second_folds *found)
{
    PyObject *list = PyList_New(0);
    for (int i = 0; list != NULL && i < found->n; i++) {
        const sf_second_fold *fold = &found->at[i];
        PyObject *item = Py_BuildValue("dddii", fold->Omega, fold->u_max, fold->A_1, fold->up, fold->corner);
        if (item == NULL || PyList_Append(list, item) < 0)
            Py_CLEAR(list);
        Py_XDECREF(item);
    }
    return list;
}

static PyObject *second_saddle_nodes(PyObject *self, PyObject *args)
{
    PyObject *given;
    sf_second_folds found;
    sf_status status;
    sf_room *room;
    double F_0;
    (void)self;
    if (!PyArg_ParseTuple(args, "Od", &given, &F_0))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL || (room = new_room()) == NULL)
        return NULL;
    const sf_given *exactly = sf_given_in(given);
    room->undecided = 0;
    Py_BEGIN_ALLOW_THREADS
    status = sf_here()->second_saddle_nodes(model, exactly, F_0, room, &found);
    Py_END_ALLOW_THREADS
    const int undecided = room->undecided;
    free(room);
    PyObject *list = list_of(&found);
    if (list == NULL)
        return NULL;
    return Py_BuildValue("iNNiiN", (int)status, PyBool_FromLong(undecided), list, found.lost, found.tried,
                         left_out(&found.left));
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
    PyObject *list = list_of(&found);
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

static PyMethodDef functions[] = {
    {"second_curve", second_curve, METH_VARARGS,
     "(model, F_0, wanted, samples, low, high) -> status, (Omega, A, u_max, A_1, phi, stable, part, closed parts, (lost, "
     "of, from, to)), curve or None"},
    {"second_saddle_nodes", second_saddle_nodes, METH_VARARGS,
     "(model, F_0) -> status, whether doubles leave averaging's undecided, [(Omega, u_max, A_1, up, corner)], lost, "
     "tried, (lost, of, from, to)"},
    {"second_folds", second_folds, METH_VARARGS,
     "(model, F_0, curve) -> status, [(Omega, u_max, A_1, up, corner)], lost, tried"},
    {"second_states", second_states, METH_VARARGS, "(model, F_0, curve, Omega) -> [(Omega, u_max, A_1, phi, stable)]"},
    {"second_peak", second_peak, METH_VARARGS, "(model, F_0, curve) -> status, u_max, Omega"},
    {"second_onset", second_onset, METH_VARARGS, "(model, F_SN, Omega, A) of a cusp -> status, F_SN, Omega, u_max"},
    {"second_detachment", second_detachment, METH_VARARGS, "(model, F_cr, Omega_cr, u_cr) -> status, F_cr, Omega_cr"},
    {NULL, NULL, 0, NULL},
};

int sf_add_second(PyObject *module)
{
    if (PyArray_ImportNumPyAPI() < 0)
        return -1;
    return PyModule_AddFunctions(module, functions);
}
