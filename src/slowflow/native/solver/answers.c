/* The questions about one oscillator as Python functions: in go a model (records.c) and numbers, out come a status and
 * arrays; the words are slowflow's. The solvers run without the GIL, in a workspace of their own.
 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

/* before NumPy, whose complex.h takes the name I */
#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>

static sf_work *new_work(void)
{
    sf_work *work = malloc(sizeof *work);
    if (work == NULL)
        PyErr_NoMemory();
    return work;
}

static sf_room *new_room(void)
{
    sf_room *room = malloc(sizeof *room);
    if (room == NULL)
        PyErr_NoMemory();
    return room;
}

/* The oscillator of a model's capsule in pairs, or NULL. */
static const sf_exactly *exactly_in(PyObject *capsule)
{
    const sf_given *given = sf_given_in(capsule);
    return given == NULL ? NULL : &given->exactly;
}

/* A new one-dimensional array; `*values` points into it. */
static PyObject *new_array(npy_intp n, int type, void *values)
{
    PyObject *array = PyArray_SimpleNew(1, &n, type);
    if (array != NULL)
        *(void **)values = PyArray_DATA((PyArrayObject *)array);
    return array;
}

/* (status, items...) with the references given away; NULL if one of them is. */
static PyObject *answer(int status, PyObject *const *items, int n)
{
    PyObject *tuple = PyTuple_New(n + 1);
    int whole = tuple != NULL && PyTuple_SetItem(tuple, 0, PyLong_FromLong(status)) == 0;
    for (int i = 0; i < n; i++) {
        if (items[i] == NULL || !whole) {
            Py_XDECREF(items[i]);
            whole = 0;
        } else {
            PyTuple_SetItem(tuple, i + 1, items[i]);
        }
    }
    if (!whole)
        Py_CLEAR(tuple);
    return tuple;
}

static PyObject *fold_arrays(sf_status status, const sf_folds *folds)
{
    double *Omega, *A;
    npy_bool *up, *corner;
    const int n = status == SF_OK ? folds->n : 0;
    PyObject *items[] = {new_array(n, NPY_DOUBLE, &Omega), new_array(n, NPY_DOUBLE, &A), new_array(n, NPY_BOOL, &up),
                         new_array(n, NPY_BOOL, &corner), PyBool_FromLong(status == SF_OK && folds->undecided)};
    if (items[0] && items[1] && items[2] && items[3])
        for (int i = 0; i < n; i++) {
            Omega[i] = folds->at[i].Omega, A[i] = folds->at[i].A;
            up[i] = (npy_bool)folds->at[i].up, corner[i] = (npy_bool)folds->at[i].corner;
        }
    return answer(status, items, 5);
}

static PyObject *saddle_nodes(PyObject *self, PyObject *args)
{
    PyObject *given;
    double F_0;
    sf_room *room;
    sf_status status;
    (void)self;
    if (!PyArg_ParseTuple(args, "Od", &given, &F_0))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL || (room = new_room()) == NULL)
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = sf_here()->saddle_nodes(model, sf_given_in(given), F_0, room, &room->work.folds);
    Py_END_ALLOW_THREADS
    PyObject *result = fold_arrays(status, &room->work.folds);
    free(room);
    return result;
}

static PyObject *onset(PyObject *self, PyObject *args)
{
    PyObject *given;
    sf_work *work;
    sf_onset found;
    sf_status status;
    (void)self;
    if (!PyArg_ParseTuple(args, "O", &given))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL || (work = new_work()) == NULL)
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = sf_here()->onset(model, exactly_in(given), work, &found);
    Py_END_ALLOW_THREADS
    free(work);
    return Py_BuildValue("idddid", (int)status, found.F_SN, found.Omega, found.A, (int)found.kind, found.rest);
}

static PyObject *detachment(PyObject *self, PyObject *args)
{
    PyObject *given;
    double F_cr, Omega_cr, u_cr;
    (void)self;
    if (!PyArg_ParseTuple(args, "O", &given))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL)
        return NULL;
    const sf_status status = sf_here()->detachment(model, exactly_in(given), &F_cr, &Omega_cr, &u_cr);
    return Py_BuildValue("iddd", (int)status, F_cr, Omega_cr, u_cr);
}

static PyObject *peak(PyObject *self, PyObject *args)
{
    PyObject *given;
    double F_0, most, A, Omega;
    sf_work *work;
    sf_status status;
    (void)self;
    if (!PyArg_ParseTuple(args, "Odd", &given, &F_0, &most))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL || (work = new_work()) == NULL)
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = sf_here()->peak(model, exactly_in(given), F_0, most, work, &A, &Omega);
    Py_END_ALLOW_THREADS
    free(work);
    return Py_BuildValue("idd", (int)status, A, Omega);
}

static PyObject *amplitude_bound(PyObject *self, PyObject *args)
{
    PyObject *given;
    double F_0, A_max;
    (void)self;
    if (!PyArg_ParseTuple(args, "Od", &given, &F_0))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL)
        return NULL;
    const sf_status status = sf_here()->range(model, F_0, &A_max);
    return Py_BuildValue("id", (int)status, A_max);
}

static PyObject *undamped_cut(PyObject *self, PyObject *args)
{
    PyObject *given;
    double F_0;
    (void)self;
    if (!PyArg_ParseTuple(args, "Od", &given, &F_0))
        return NULL;
    const sf_model *model = sf_model_in(given);
    return model == NULL ? NULL : PyFloat_FromDouble(sf_here()->undamped_cut(model, F_0));
}

static PyObject *spring(PyObject *self, PyObject *given)
{
    (void)self;
    const sf_model *model = sf_model_in(given);
    return model == NULL ? NULL : PyUnicode_FromString(sf_here()->spring(model));
}

static PyObject *are_events_close(PyObject *self, PyObject *args)
{
    PyObject *given;
    double F_0, A_max;
    sf_work *work;
    (void)self;
    if (!PyArg_ParseTuple(args, "Odd", &given, &F_0, &A_max))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL || (work = new_work()) == NULL)
        return NULL;
    const int close = sf_here()->are_events_close(model, F_0, A_max, work);
    free(work);
    return PyBool_FromLong(close);
}

static PyObject *extrema_list(const sf_model *model, const sf_exactly *exactly, const sf_zeros *extrema)
{
    PyObject *list = PyList_New(0);
    for (int i = 0; list != NULL && i < extrema->n; i++) {
        const sf_zero *zero = &extrema->at[i];
        if (zero->question == SF_UNDAMPED && zero->channel == 1)
            continue; /* there the locus only touches the backbone */
        const sf_extremum found = sf_here()->extremum(model, exactly, zero);
        PyObject *item = Py_BuildValue("dddiiii", found.F_0, found.Omega, found.A, found.isola, found.minimum,
                                       found.saddle, found.few_digits);
        if (item == NULL || PyList_Append(list, item) < 0)
            Py_CLEAR(list);
        Py_XDECREF(item);
    }
    return list;
}

/* (model, A_max, samples) -> status, Omega, A, F_0, branch, [(F_0, Omega, A, isola, minimum, saddle, few_digits)];
 * for no samples the last alone */
static PyObject *fold_locus(PyObject *self, PyObject *args)
{
    PyObject *given;
    long samples, n = 0;
    sf_work *work;
    sf_status status;
    double A_max, *Omega, *A, *F_0;
    npy_int64 *branch;
    (void)self;
    if (!PyArg_ParseTuple(args, "Odl", &given, &A_max, &samples))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL || (work = new_work()) == NULL)
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    status = (samples > 0 ? sf_here()->fold_locus : sf_here()->extrema)(model, A_max, work);
    if (status == SF_OK && samples > 0)
        n = sf_here()->draw_locus(model, samples, work, NULL, NULL, NULL, NULL);
    Py_END_ALLOW_THREADS
    PyObject *items[] = {new_array(n, NPY_DOUBLE, &Omega), new_array(n, NPY_DOUBLE, &A), new_array(n, NPY_DOUBLE, &F_0),
                         new_array(n, NPY_INT64, &branch),
                         extrema_list(model, exactly_in(given), &work->extrema)};
    if (n > 0 && items[0] && items[1] && items[2] && items[3]) {
        Py_BEGIN_ALLOW_THREADS
        sf_here()->draw_locus(model, samples, work, Omega, A, F_0, (long long *)branch);
        Py_END_ALLOW_THREADS
    }
    free(work);
    return answer(status, items, 5);
}

static PyObject *closed_flags(const sf_skeleton *shown)
{
    PyObject *tuple = PyTuple_New(shown->curves);
    for (int i = 0; tuple != NULL && i < shown->curves; i++)
        PyTuple_SetItem(tuple, i, PyBool_FromLong(shown->closed[i]));
    return tuple;
}

/* (model, F_0, samples, low, high) -> status, Omega, A, stable, branch, closed, undecided */
/* A model that is asked for frequencies from the lowest on. */
static const sf_model *asked_from(const sf_model *model, double lowest, sf_model *own)
{
    *own = *model, own->lowest = lowest;
    return own;
}

static PyObject *frequency_response(PyObject *self, PyObject *args)
{
    PyObject *given;
    double F_0, samples, low, high, *Omega, *A;
    long n = 0;
    npy_bool *stable;
    npy_int64 *branch;
    sf_room *room;
    sf_status status;
    (void)self;
    if (!PyArg_ParseTuple(args, "Odddd", &given, &F_0, &samples, &low, &high))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL || (room = new_room()) == NULL)
        return NULL;
    room->work.shown.curves = 0;
    sf_model own;
    model = asked_from(model, low, &own);
    Py_BEGIN_ALLOW_THREADS
    status = sf_here()->skeleton(model, sf_given_in(given), F_0, room);
    if (status == SF_OK)
        n = sf_here()->show(model, F_0, low, high, samples, &room->work);
    Py_END_ALLOW_THREADS
    if (n < 0)
        status = SF_NO_BOUND, n = 0;
    PyObject *items[] = {new_array(n, NPY_DOUBLE, &Omega), new_array(n, NPY_DOUBLE, &A),
                         new_array(n, NPY_BOOL, &stable),  new_array(n, NPY_INT64, &branch),
                         closed_flags(&room->work.shown),  PyBool_FromLong(status == SF_OK && room->undecided)};
    if (n > 0 && items[0] && items[1] && items[2] && items[3]) {
        Py_BEGIN_ALLOW_THREADS
        sf_here()->draw(model, F_0, samples, &room->work.shown, Omega, A, stable, (long long *)branch);
        Py_END_ALLOW_THREADS
    }
    free(room);
    return answer(status, items, 6);
}

/* frequencies: some milliseconds; and as how many of them a proof counts */
enum { BETWEEN_SIGNALS = 1 << 14, PROOF = 100 };

/* States, and frequencies at which doubles do not tell how many there are, so many of `places` and
 * `places_in_doubt`. */
typedef struct {
    npy_intp n, doubts, places, places_in_doubt;
    double *Omega, *A, *doubt;
    npy_bool *stable;
} states;

static int grow(void *array, npy_intp places, size_t size)
{
    void *more = realloc(*(void **)array, (size_t)places * size);
    if (more != NULL)
        *(void **)array = more;
    return more != NULL;
}

/* Room for all that there may be at one more frequency. */
static int make_place(states *found)
{
    if (found->places - found->n < sf_here()->most_states) {
        found->places = 2 * found->places + sf_here()->most_states;
        if (!grow(&found->Omega, found->places, sizeof *found->Omega) ||
            !grow(&found->A, found->places, sizeof *found->A) ||
            !grow(&found->stable, found->places, sizeof *found->stable))
            return 0;
    }
    if (found->doubts == found->places_in_doubt) {
        found->places_in_doubt = 2 * found->places_in_doubt + 1;
        return grow(&found->doubt, found->places_in_doubt, sizeof *found->doubt);
    }
    return 1;
}

/* All states at the frequencies asked for; -1 with an exception set where it was interrupted or there was no room. */
static int all_states(const sf_model *model, const sf_given *given, double F_0, sf_room *room, const double *asked,
                      npy_intp asked_n, states *found, sf_status *status)
{
    npy_intp i = 0;
    int is_room = 1;
    *status = SF_OK;
    while (i < asked_n && is_room && *status == SF_OK) {
        Py_BEGIN_ALLOW_THREADS
        const npy_intp first = i;
        const long proofs = room->proofs;
        while (i < asked_n && i - first + PROOF * (room->proofs - proofs) < BETWEEN_SIGNALS && *status == SF_OK &&
               (is_room = make_place(found))) {
            int here, undecided;
            *status = sf_here()->states(model, given, F_0, room, asked[i], &here, found->A + found->n,
                                        found->stable + found->n, &undecided);
            for (int j = 0; j < here; j++)
                found->Omega[found->n++] = asked[i];
            if (undecided)
                found->doubt[found->doubts++] = asked[i];
            i++;
        }
        Py_END_ALLOW_THREADS
        if (PyErr_CheckSignals() < 0)
            return -1;
    }
    if (!is_room)
        PyErr_NoMemory();
    return is_room ? 0 : -1;
}

/* A new array with a copy of n elements. */
static PyObject *array_of(npy_intp n, int type, const void *values, size_t size)
{
    void *into;
    PyObject *array = new_array(n, type, &into);
    if (array != NULL && n > 0)
        memcpy(into, values, (size_t)n * size);
    return array;
}

/* (model, F_0, Omega: contiguous doubles) -> status, Omega, A, stable: every state, by the order of Omega; and those of
 * the frequencies at which their number is undecided */
static PyObject *steady_states(PyObject *self, PyObject *args)
{
    PyObject *given, *frequencies, *result = NULL;
    double F_0;
    sf_room *room;
    sf_status status;
    states found = {0};
    (void)self;
    if (!PyArg_ParseTuple(args, "OdO", &given, &F_0, &frequencies))
        return NULL;
    const sf_model *model = sf_model_in(given);
    if (model == NULL)
        return NULL;
    PyArrayObject *array = (PyArrayObject *)PyArray_FROMANY(frequencies, NPY_DOUBLE, 1, 1, NPY_ARRAY_IN_ARRAY);
    if (array == NULL)
        return NULL;
    if ((room = new_room()) == NULL) {
        Py_DECREF(array);
        return NULL;
    }
    room->followed = 0, room->proofs = 0;
    const double *at = PyArray_DATA(array);
    const npy_intp n = PyArray_DIM(array, 0);
    double lowest = n > 0 ? at[0] : 0;
    for (npy_intp i = 1; i < n; i++)
        lowest = fmin(lowest, at[i]);
    sf_model own;
    if (all_states(asked_from(model, lowest, &own), sf_given_in(given), F_0, room, at, n, &found,
                   &status) == 0) {
        PyObject *items[] = {array_of(found.n, NPY_DOUBLE, found.Omega, sizeof *found.Omega),
                             array_of(found.n, NPY_DOUBLE, found.A, sizeof *found.A),
                             array_of(found.n, NPY_BOOL, found.stable, sizeof *found.stable),
                             array_of(found.doubts, NPY_DOUBLE, found.doubt, sizeof *found.doubt)};
        result = answer(status, items, 4);
    }
    free(found.Omega);
    free(found.A);
    free(found.stable);
    free(found.doubt);
    free(room);
    Py_DECREF(array);
    return result;
}

static PyMethodDef functions[] = {
    {"saddle_nodes", saddle_nodes, METH_VARARGS, "(model, F_0) -> status, Omega, A, up, corner, undecided"},
    {"onset", onset, METH_VARARGS, "(model,) -> status, F_SN, Omega, A, kind, lowest level at rest"},
    {"detachment", detachment, METH_VARARGS, "(model,) -> status, F_cr, Omega_cr, u_cr"},
    {"peak", peak, METH_VARARGS, "(model, F_0, most) -> status, A, Omega"},
    {"amplitude_bound", amplitude_bound, METH_VARARGS, "(model, F_0) -> status, A_max"},
    {"undamped_cut", undamped_cut, METH_VARARGS, "(model, F_0) -> A_max"},
    {"spring", spring, METH_O, "(model) -> whether a spring holds the mass, none does, or one that levels off"},
    {"are_events_close", are_events_close, METH_VARARGS,
     "(model, F_0, A_max) -> whether doubles leave open which peaks and static states a curve has"},
    {"fold_locus", fold_locus, METH_VARARGS, "(model, A_max, samples) -> status, Omega, A, F_0, branch, extrema"},
    {"frequency_response", frequency_response, METH_VARARGS,
     "(model, F_0, samples, low, high) -> status, Omega, A, stable, branch, closed, undecided"},
    {"steady_states", steady_states, METH_VARARGS,
     "(model, F_0, Omega) -> status, Omega, A, stable, Omega where undecided"},
    {NULL, NULL, 0, NULL},
};

int sf_add_answers(PyObject *module)
{
    if (PyArray_ImportNumPyAPI() < 0)
        return -1;
    return PyModule_AddFunctions(module, functions);
}
