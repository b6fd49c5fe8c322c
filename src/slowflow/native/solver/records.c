/* Records and models as capsules. Takes a mechanism's name or a capsule and numbers; returns a capsule.
 *
 * RECORDS has those of the mechanisms that were compiled in, by name; MOST the most numbers of a design, parameters and
 * breakpoints of a record. What the functions take and return is in their table below.
 *
 * A record compiled elsewhere is a capsule named SF_RECORD around its sf_mechanism, which has to live as long as
 * the capsule and the functions for many designs that were made from it.
 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "inertial.h"
#include "laws.h"
#include "solver.h"

#define SF_RECORD "slowflow.core.mechanism"
#define SF_MODEL "slowflow.core.model"

const sf_solvers *sf_here(void) {
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
        __builtin_cpu_supports("bmi2"))
        return &sf_solvers_fma;
#endif
#ifdef SF_WITHOUT_BASELINE
    return NULL;
#else
    return &sf_solvers_baseline;
#endif
}

const sf_mechanism *sf_record_in(PyObject *capsule) {
    const sf_mechanism *record = PyCapsule_GetPointer(capsule, SF_RECORD);
    if (record == NULL)
        return NULL;
    if (record->form != SF_FORM || record->design_size > SF_MOST_DESIGN || record->damping_size > SF_MOST_DAMPING ||
        record->parameters > SF_MOST_PARAMETERS || record->breakpoints > SF_MOST_BREAKS) {
        PyErr_SetString(PyExc_ValueError, "the record was compiled for another form of mechanism.h");
        return NULL;
    }
    return record;
}

/* A function's definition, for as long as the process lives. */
int sf_add_function(PyObject *module, const char *name, const char *doc, PyCFunction call, int flags,
                    const void *data) {
    PyMethodDef *own = malloc(sizeof *own);
    PyObject *capsule = own == NULL ? PyErr_NoMemory() : PyCapsule_New((void *)data, NULL, NULL);
    if (capsule == NULL)
        return -1;
    *own = (PyMethodDef){name, call, flags, doc};
    PyObject *function = PyCFunction_New(own, capsule);
    const int failed = function == NULL ? -1 : PyModule_AddObjectRef(module, name, function);
    Py_DECREF(capsule);
    Py_XDECREF(function);
    return failed;
}

typedef struct {
    PyObject *(*make)(const sf_mechanism *, const void *);
    const void *how;
    PyObject *cache; /* by the record's address */
} maker;

static PyObject *made_once(PyObject *self, PyObject *capsule) {
    const maker *of = PyCapsule_GetPointer(self, NULL);
    const sf_mechanism *record = sf_record_in(capsule);
    PyObject *address = record == NULL ? NULL : PyLong_FromVoidPtr((void *)record);
    if (address == NULL)
        return NULL;
    PyObject *found = PyDict_GetItemWithError(of->cache, address);
    Py_XINCREF(found);
    if (found == NULL && !PyErr_Occurred()) {
        found = of->make(record, of->how);
        if (found != NULL && PyDict_SetItem(of->cache, address, found) < 0)
            Py_CLEAR(found);
    }
    Py_DECREF(address);
    return found;
}

int sf_add_maker(PyObject *module, const char *name, const char *doc,
                 PyObject *(*make)(const sf_mechanism *, const void *), const void *how) {
    maker *own = malloc(sizeof *own);
    PyObject *cache = own == NULL ? PyErr_NoMemory() : PyDict_New();
    if (cache == NULL)
        return -1;
    *own = (maker){make, how, cache};
    return sf_add_function(module, name, doc, made_once, METH_O, own);
}

/* How a copy of a record is changed. */
typedef struct {
    void (*change)(sf_mechanism *);
} variant;

static const variant excited_by_inertia = {sf_excite_by_inertia}, damped_by_laws = {sf_add_laws};

/* A record is never let go, as batches keep its address. */
static PyObject *new_variant(const sf_mechanism *record, const void *how) {
    sf_mechanism *made = malloc(sizeof *made);
    if (made == NULL)
        return PyErr_NoMemory();
    *made = *record;
    ((const variant *)how)->change(made);
    PyObject *found = PyCapsule_New(made, SF_RECORD, NULL);
    if (found == NULL)
        free(made);
    return found;
}

static void free_samples(PyObject *capsule) {
    sf_here()->records->free_samples(PyCapsule_GetPointer(capsule, SF_RECORD));
}

static void surround(sf_mechanism *made, int inertial, int with_laws) {
    if (inertial)
        sf_excite_by_inertia(made);
    if (with_laws)
        sf_add_laws(made);
}

static PyObject *read_record(PyObject *self, PyObject *args) {
    sf_mechanism *made;
    const char *name, *code, *numbers;
    Py_ssize_t count, length;
    int sampled, inertial = 0, with_laws = 0;
    if (!PyArg_ParseTuple(args, "psy#y#|pp", &sampled, &name, &code, &count, &numbers, &length, &inertial, &with_laws))
        return NULL;
    const sf_records *shipped = sf_here()->records;
    switch (shipped->read(sampled, shipped->all[0], name, (const int *)(const void *)code,
                          count / (Py_ssize_t)sizeof(int), (const double *)(const void *)numbers,
                          length / (Py_ssize_t)sizeof(double), &made)) {
    case SF_OK:
        surround(made, inertial, with_laws);
        return PyCapsule_New(made, SF_RECORD, sampled ? free_samples : NULL);
    case SF_TOO_MANY:
        Py_RETURN_NONE;
    case SF_NO_MEMORY:
        return PyErr_NoMemory();
    default:
        return PyErr_Format(PyExc_ValueError, "%s: its words and numbers are no %s", name,
                            sampled ? "polynomials" : "program");
    }
}

/* A function at an address, as what a record has in its place. */
#define SF_AT(record, name, address) memcpy(&(record)->name, &(address), sizeof(record)->name)

static int has_no_parameters_of(const sf_mechanism *self, const double *design, double *p) {
    (void)self, (void)design, (void)p;
    return 0;
}

static void free_called(PyObject *capsule) {
    free(PyCapsule_GetPointer(capsule, SF_RECORD));
    Py_XDECREF(PyCapsule_GetContext(capsule));
}

static PyObject *called(PyObject *self, PyObject *args) {
    PyObject *keep, *enclosed;
    const char *name;
    Py_ssize_t at[7];
    int sizes[3], inertial, with_laws;
    double reach, up_to;
    if (!PyArg_ParseTuple(args, "s(iii)dd(nnnnnnn)OppO", &name, &sizes[0], &sizes[1], &sizes[2], &reach, &up_to, &at[0],
                          &at[1], &at[2], &at[3], &at[4], &at[5], &at[6], &keep, &inertial, &with_laws, &enclosed))
        return NULL;
    const sf_mechanism *bounds = enclosed == Py_None ? NULL : sf_record_in(enclosed);
    if (enclosed != Py_None && bounds == NULL)
        return NULL;
    sf_mechanism *made = calloc(1, sizeof *made + strlen(name) + 1);
    if (made == NULL)
        return PyErr_NoMemory();
    sf_take_surroundings(sf_here()->records->all[0], made);
    made->name = strcpy((char *)(made + 1), name);
    made->design_size = sizes[0], made->parameters = sizes[1], made->breakpoints = sizes[2];
    made->reach = reach, made->harmonics_up_to = up_to, made->parameters_of = has_no_parameters_of;
    SF_AT(made, ends, at[0]), SF_AT(made, jumps, at[1]), SF_AT(made, kinks, at[2]), SF_AT(made, averaged, at[3]);
    SF_AT(made, averaged_2, at[4]), SF_AT(made, intercept, at[5]), SF_AT(made, harmonics, at[6]);
    if (bounds != NULL)
        made->bent = bounds->bent, made->program = bounds->program;
    surround(made, inertial, with_laws);
    PyObject *found = PyCapsule_New(made, SF_RECORD, free_called);
    if (found == NULL) {
        free(made);
        return NULL;
    }
    Py_INCREF(keep);
    PyCapsule_SetContext(found, keep);
    return found;
}

/* What the capsule of a model points to; it keeps its record. */
typedef struct {
    sf_model model;
    sf_inputs inputs;
    int is_given;
    PyObject *record;
} oscillator;

const sf_model *sf_model_in(PyObject *capsule, const sf_inputs **inputs) {
    const oscillator *made = PyCapsule_GetPointer(capsule, SF_MODEL);
    if (made == NULL)
        return NULL;
    *inputs = made->is_given ? &made->inputs : NULL;
    return &made->model;
}

static void free_model(PyObject *capsule) {
    oscillator *made = PyCapsule_GetPointer(capsule, SF_MODEL);
    Py_DECREF(made->record);
    free(made);
}

int sf_read_numbers(PyObject *tuple, int n, const char *name, const char *what, double *values) {
    if (PyTuple_Size(tuple) != n) {
        PyErr_Format(PyExc_ValueError, "%s takes %d %s, not %zd", name, n, what, PyTuple_Size(tuple));
        return -1;
    }
    for (int i = 0; i < n; i++)
        values[i] = PyFloat_AsDouble(PyTuple_GetItem(tuple, i));
    return PyErr_Occurred() ? -1 : 0;
}

static PyObject *tuple_of(const double *values, int n) {
    PyObject *tuple = PyTuple_New(n);
    for (int i = 0; tuple != NULL && i < n; i++) {
        PyObject *value = PyFloat_FromDouble(values[i]);
        if (value == NULL || PyTuple_SetItem(tuple, i, value) < 0)
            Py_CLEAR(tuple);
    }
    return tuple;
}

static PyObject *parameters_of(PyObject *self, PyObject *args) {
    PyObject *capsule, *of_design;
    double design[SF_MOST_DESIGN], p[SF_MOST_PARAMETERS];
    if (!PyArg_ParseTuple(args, "OO!", &capsule, &PyTuple_Type, &of_design))
        return NULL;
    const sf_mechanism *record = sf_record_in(capsule);
    if (record == NULL ||
        sf_read_numbers(of_design, record->design_size, record->name, "numbers of the design", design) != 0)
        return NULL;
    if (sf_take_design(record, design, p))
        return tuple_of(p, record->parameters);
    PyErr_Format(PyExc_ValueError, "%s: the design is outside its domain", record->name);
    return NULL;
}

static PyObject *new_model(PyObject *self, PyObject *args) {
    PyObject *capsule, *parameters, *of_damping, *of_design = NULL;
    double damping[SF_MOST_DAMPING], design[SF_MOST_DESIGN];
    if (!PyArg_ParseTuple(args, "OO!O!|O!", &capsule, &PyTuple_Type, &parameters, &PyTuple_Type, &of_damping,
                          &PyTuple_Type, &of_design))
        return NULL;
    const sf_mechanism *record = sf_record_in(capsule);
    if (record == NULL)
        return NULL;
    const int known = of_design != NULL && PyTuple_Size(of_design) > 0;
    oscillator *made = calloc(1, sizeof *made);
    if (made == NULL)
        return PyErr_NoMemory();
    if (sf_read_numbers(parameters, record->parameters, record->name, "parameters", made->model.p) == 0 &&
        sf_read_numbers(of_damping, record->damping_size, record->name, "numbers of damping", damping) == 0 &&
        (!known ||
         sf_read_numbers(of_design, record->design_size, record->name, "numbers of the design", design) == 0)) {
        if (record->damping_of(damping, made->model.damping)) {
            if (!sf_prepare(record, known ? design : NULL, &made->model)) {
                free(made);
                Py_RETURN_NONE;
            }
            made->is_given = known && sf_give(record, design, damping[0], damping[1], &made->inputs);
            made->record = capsule;
            PyObject *result = PyCapsule_New(made, SF_MODEL, free_model);
            if (result != NULL) {
                Py_INCREF(capsule);
                return result;
            }
        } else {
            PyErr_Format(PyExc_ValueError, "%s: the damping is outside its domain", record->name);
        }
    }
    free(made);
    return NULL;
}

/* (record, parameters, A, out): of so many outputs 4 are h and its derivatives, 8 those of the harmonics, 1
 * h - A h_A, and 3 for each parameter what it does to h, h_A and h_AA where they are sums. */
static PyObject *averages(PyObject *self, PyObject *args) {
    PyObject *capsule, *parameters;
    Py_buffer A, out;
    double p[SF_MOST_PARAMETERS];
    if (!PyArg_ParseTuple(args, "OO!y*w*", &capsule, &PyTuple_Type, &parameters, &A, &out))
        return NULL;
    const sf_mechanism *record = sf_record_in(capsule);
    if (record != NULL && sf_read_numbers(parameters, record->parameters, record->name, "parameters", p) == 0) {
        const Py_ssize_t n = A.len / (Py_ssize_t)sizeof(double);
        if (out.len == 4 * A.len)
            record->averaged(record, n, A.buf, p, out.buf);
        else if (out.len == 8 * A.len)
            record->harmonics(record, n, A.buf, p, out.buf);
        else if (out.len == A.len)
            for (Py_ssize_t i = 0; i < n; i++)
                ((double *)out.buf)[i] = record->intercept(record, ((const double *)A.buf)[i], p);
        else if (out.len == 3 * record->parameters * A.len)
            for (Py_ssize_t i = 0; i < n; i++) {
                const double at = ((const double *)A.buf)[i], none[3] = {0};
                double by[3 * SF_MOST_PARAMETERS];
                record->by_parameter(record, at, none, p, by);
                for (int k = 0; k < 3 * record->parameters; k++)
                    ((double *)out.buf)[k * n + i] = by[k];
            }
        else
            PyErr_SetString(PyExc_ValueError, "room for other numbers than averages");
    }
    PyBuffer_Release(&A);
    PyBuffer_Release(&out);
    return PyErr_Occurred() ? NULL : Py_NewRef(Py_None);
}

static PyObject *prepared(PyObject *self, PyObject *capsule) {
    const sf_inputs *inputs;
    const sf_model *model = sf_model_in(capsule, &inputs);
    if (model == NULL)
        return NULL;
    return Py_BuildValue("dNN", model->m, tuple_of(model->b, model->breaks), tuple_of(model->jump, model->breaks));
}

static PyMethodDef functions[] = {
    {"prepared", prepared, METH_O, "(oscillator) -> 4 mu/pi, breakpoints, jumps at these; none at 0"},
    {"averages", averages, METH_VARARGS, "(record, parameters, A, out) -> None"},
    {"record", read_record, METH_VARARGS,
     "(sampled, name, code, numbers, inertial, with_laws) -> a record of C ints and doubles, as bytes: one that "
     "interprets a program, or of one design of a force that is known by its values, let go with the last oscillator "
     "that was made of it; ValueError where they are none, None where the force is beyond what a record has room for"},
    {"called", called, METH_VARARGS,
     "(name, sizes, reach, harmonics_up_to, addresses, keep, inertial, with_laws, enclosed) -> a record that calls "
     "functions at addresses, 0 for those that are not known, and keeps what these live in; enclosed: a record whose "
     "bounds hold for it, or None"},
    {"parameters_of", parameters_of, METH_VARARGS,
     "(record, design) -> parameters; ValueError where the design is outside its domain"},
    {"model", new_model, METH_VARARGS,
     "(record, parameters, damping, design) -> an oscillator, prepared for the questions about one; what is proved of "
     "it "
     "is proved of the design, () where that is not known"},
    {NULL, NULL, 0, NULL},
};

int sf_add_records(PyObject *module) {
    const sf_records *shipped = sf_here()->records;
    PyObject *records = PyDict_New();
    PyObject *most = Py_BuildValue("iii", SF_MOST_DESIGN, SF_MOST_PARAMETERS, SF_MOST_BREAKS);
    int failed =
        records == NULL || most == NULL || PyModule_AddObjectRef(module, "MOST", most) < 0 ||
        PyModule_AddFunctions(module, functions) < 0 || PyModule_AddObjectRef(module, "RECORDS", records) < 0 ||
        sf_add_maker(module, "inertial", "record -> the same mechanism excited by inertia, F_0 Omega^2; zeta > 0",
                     new_variant, &excited_by_inertia) < 0 ||
        sf_add_maker(module, "with_laws",
                     "record -> the same mechanism with damping by any law: mu, zeta, eta, c_2, and whether "
                     "friction ends at the first breakpoint",
                     new_variant, &damped_by_laws) < 0;
    for (int i = 0; i < shipped->count && !failed; i++) {
        PyObject *capsule = PyCapsule_New((void *)shipped->all[i], SF_RECORD, NULL);
        failed = capsule == NULL || PyDict_SetItemString(records, shipped->all[i]->name, capsule) < 0;
        Py_XDECREF(capsule);
    }
    Py_XDECREF(most);
    Py_XDECREF(records);
    return failed ? -1 : 0;
}
