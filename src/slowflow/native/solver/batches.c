/* The questions about many oscillators as generalised ufuncs: in goes a record, out comes its ufunc.
 *
 * A ufunc's loop is the same for all records and its data is the record. What is made once is kept.
 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

/* before NumPy, whose complex.h takes the name I */
#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>

#define D NPY_DOUBLE
#define B NPY_INT8
#define S NPY_SHORT
#define N NPY_INT

/* A question: the outputs behind the design, the damping and what is asked at, F_0 and Omega or less, and of an answer
 * A and what it is. */
typedef struct {
    const char *name, *out, *doc;
    int at, outputs;
    char types[12];
} question;

static const question detachment = {
    "many_detachment", "(),(),(),()", "design, damping -> F_cr, Omega_cr, u_cr, status", 0, 4, {D, D, D, B}};
static const question onset = {
    "many_onset", "(),(),(),(),(),()", "design, damping -> F_SN, Omega, A, kind, folds at rest, status", 0, 6,
    {D, D, D, B, B, B}};
static const question saddle_nodes = {
    "many_saddle_nodes", "(k),(k),(k),(),(),()",
    "design, damping, F_0 -> Omega, A, kind, count, undecided, status", 1, 6, {D, D, B, B, B, B}};
static const question amplitudes = {
    "many_amplitudes", "(k),(k),(),(),()", "design, damping, F_0, Omega -> A, stable, count, undecided, status", 2, 5,
    {D, B, B, B, B}};
static const question peak = {"many_peak", "(),(),()", "design, damping, F_0 -> A, Omega, status", 1, 3, {D, D, B}};

static const question frequency_response = {
    "many_frequency_response", "(n),(n),(n),(n),(n),(),(k),(k),(k),(),(),()",
    "design, damping, F_0, samples, low, high -> Omega, A, stable, branch, whether it is closed, points; Omega, A, "
    "kind of folds, count, undecided, status",
    4, 12, {D, D, B, S, B, N, D, D, B, B, B, B}};

static const question proved_folds = {
    "many_proved_saddle_nodes", "(),(),()",
    "design, damping, F_0 -> count, whether it is proved, status", 1, 3, {B, B, B}};
static const question proved_states = {
    "many_proved_amplitudes", "(),(),()", "design, damping, F_0, Omega -> count, whether it is proved, status", 2, 3,
    {B, B, B}};

static const question gradients = {
    "many_gradients", "(r,n),()", "design, damping, F_0, Omega, A, what it is -> moves, status", 4, 2, {D, B}};
static const question inertial_gradients = {
    "many_inertial_gradients", "(r,n),()",
    "design, damping, amplitude of the excitation, Omega, A, what it is -> moves, status", 4, 2, {D, B}};

/* of the parameters, not of the design */
static const question averages = {
    "many_averages", "(),(),(),()", "A, parameters -> h, h_A, h_AA, h_AAA", 0, 4, {D, D, D, D}};

enum { MOST_OPERANDS = SF_MOST_PARAMETERS + SF_MOST_DAMPING + 4 + 12 };

/* What NumPy keeps pointers to, for as long as the process lives. */
typedef struct {
    PyUFuncGenericFunction loop;
    void *data;
    char types[MOST_OPERANDS];
} kept;

/* A question and the loop that answers it. */
typedef struct {
    const question *asked;
    sf_many loop;
} answered;

static PyObject *new_batch(const sf_mechanism *record, const void *how)
{
    const question *asked = ((const answered *)how)->asked;
    const int inputs = asked == &averages ? 1 + record->parameters
                                          : record->design_size + record->damping_size + asked->at;
    char signature[3 * MOST_OPERANDS + 32] = "()";
    kept *own = malloc(sizeof *own);
    if (own == NULL)
        return PyErr_NoMemory();
    own->loop = (PyUFuncGenericFunction)((const answered *)how)->loop;
    own->data = (void *)record;
    for (int i = 1; i < inputs; i++)
        strcat(signature, ",()");
    strcat(strcat(signature, "->"), asked->out);
    for (int i = 0; i < inputs; i++)
        own->types[i] = D;
    memcpy(own->types + inputs, asked->types, (size_t)asked->outputs);
    PyObject *ufunc =
        PyUFunc_FromFuncAndDataAndSignature(&own->loop, &own->data, own->types, 1, inputs, asked->outputs,
                                            PyUFunc_None, asked->name, asked->doc, 0, signature);
    if (ufunc == NULL)
        free(own);
    return ufunc;
}

/* The ufunc of a record for a question, made when it is first asked for. */
static PyObject *batch(PyObject *cache, PyObject *capsule, const question *asked, sf_many loop)
{
    const answered how = {asked, loop};
    return sf_kept(cache, capsule, new_batch, &how);
}

static PyObject *many_detachment(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &detachment, sf_here()->many_detachment);
}

static PyObject *many_onset(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &onset, sf_here()->many_onsets);
}

static PyObject *many_saddle_nodes(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &saddle_nodes, sf_here()->many_folds);
}

static PyObject *many_amplitudes(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &amplitudes, sf_here()->many_states);
}

static PyObject *many_peak(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &peak, sf_here()->many_peaks);
}

static PyObject *many_frequency_response(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &frequency_response, sf_here()->many_curves);
}

static PyObject *many_second_detachment(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &detachment, sf_here()->many_second_detachment);
}

static PyObject *many_second_onset(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &onset, sf_here()->many_second_onsets);
}

static PyObject *many_second_saddle_nodes(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &saddle_nodes, sf_here()->many_second_folds);
}

static PyObject *many_second_peak(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &peak, sf_here()->many_second_peaks);
}

static PyObject *many_proved_saddle_nodes(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &proved_folds, sf_here()->many_proved_folds);
}

static PyObject *many_proved_amplitudes(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &proved_states, sf_here()->many_proved_states);
}

static PyObject *many_gradients(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &gradients, sf_here()->many_gradients);
}

static PyObject *many_inertial_gradients(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &inertial_gradients, sf_here()->many_inertial_gradients);
}

static PyObject *many_averages(PyObject *cache, PyObject *record)
{
    return batch(cache, record, &averages, sf_here()->many_averages);
}

static PyMethodDef functions[] = {
    {"many_detachment", many_detachment, METH_O,
     "record -> ufunc of (design, damping) -> F_cr, Omega_cr, u_cr, status"},
    {"many_onset", many_onset, METH_O,
     "record -> ufunc of (design, damping) -> F_SN, Omega, A, kind, folds at rest, status"},
    {"many_saddle_nodes", many_saddle_nodes, METH_O,
     "record -> ufunc of (design, damping, F_0) -> Omega, A, kind, count, undecided, status"},
    {"many_amplitudes", many_amplitudes, METH_O,
     "record -> ufunc of (design, damping, F_0, Omega) -> A, stable, count, undecided, status"},
    {"many_peak", many_peak, METH_O, "record -> ufunc of (design, damping, F_0) -> A, Omega, status"},
    {"many_frequency_response", many_frequency_response, METH_O,
     "record -> ufunc of (design, damping, F_0, samples, low, high) -> Omega, A, stable, branch, closed, points; "
     "Omega, A, kind of folds, count, undecided, status"},
    {"many_second_detachment", many_second_detachment, METH_O, "as many_detachment, in the second approximation"},
    {"many_second_onset", many_second_onset, METH_O, "as many_onset, in the second approximation"},
    {"many_second_saddle_nodes", many_second_saddle_nodes, METH_O,
     "as many_saddle_nodes, in the second approximation, with whether some are lost for undecided"},
    {"many_second_peak", many_second_peak, METH_O, "as many_peak, in the second approximation"},
    {"many_proved_saddle_nodes", many_proved_saddle_nodes, METH_O,
     "record -> ufunc of (design, damping, F_0) -> count, whether it is proved, status"},
    {"many_proved_amplitudes", many_proved_amplitudes, METH_O,
     "record -> ufunc of (design, damping, F_0, Omega) -> count, whether it is proved, status"},
    {"many_gradients", many_gradients, METH_O,
     "record -> ufunc of (design, damping, F_0, Omega, A, what it is) -> moves (rows, columns), status"},
    {"many_inertial_gradients", many_inertial_gradients, METH_O, "as many_gradients, where inertia excites"},
    {"many_averages", many_averages, METH_O, "record -> ufunc of (A, parameters) -> h, h_A, h_AA, h_AAA"},
};

int sf_add_batches(PyObject *module)
{
    if (PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0)
        return -1;
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; i++) {
        PyObject *cache = PyDict_New();
        PyObject *function = cache == NULL ? NULL : PyCFunction_New(&functions[i], cache);
        const int failed = function == NULL || PyModule_AddObjectRef(module, functions[i].ml_name, function) < 0;
        Py_XDECREF(cache);
        Py_XDECREF(function);
        if (failed)
            return -1;
    }
    return 0;
}
