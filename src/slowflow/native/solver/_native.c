/* The extension module slowflow._native: records, models, and the compiled solvers over them. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

/* before NumPy, whose complex.h takes the name I */
#include "solver.h"

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>

#include "build.h"

/* Every generalised ufunc of the solver: one line here, its loop in solver.h. */
static const struct {
    const char *name, *signature, *doc;
    int inputs, outputs;
    sf_gufunc_loop *loop;
    char types[10];
} gufuncs[] = {
    {"response_roots", "(),(),(),(),()->(3),()", "A, h, m, zeta, F_0 -> Omega, number of roots.", 5, 2,
     sf_response_roots_loop, {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32}},
    {"fold_roots", "(),(),(),(),()->(3),()", "A, h, h_A, m, zeta -> Omega, number of roots.", 5, 2,
     sf_fold_roots_loop, {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32}},
    {"peak_roots", "(),(),(),()->(2),()", "A, h, m, zeta -> Omega, number of roots.", 4, 2,
     sf_peak_roots_loop, {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_INT32}},
    {"law_roots", "(),(),(),(),(),(),(),(),()->(3)",
     "A, h, h_A, m, zeta, eta, d, F_0 (< 0: of the fold locus), inertial -> Omega.", 9, 1, sf_law_roots_loop,
     {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE,
      NPY_DOUBLE}},
    {"law_peak_roots", "(),(),(),(),(),(),()->(2)", "A, h, m, zeta, eta, d, inertial -> Omega.", 7, 1,
     sf_law_peak_roots_loop,
     {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE}},
    {"step_means", "(),(),(),(),(n)->(n),(n)", "A, a, whether whole, negative k, room -> L_k, M_k.", 5, 2,
     sf_step_means_loop, {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE}},
    {"ends", "(n),(),(),(),(),()->(14),(14)", "charts, lo and hi of x, of y, chart -> lower ends, upper ends.", 6, 2,
     sf_ends_loop,
     {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE}},
    {"moved", "(26)->(6)", "an answer by what is known there, and of that -> moves, whether it meets no other.", 1, 1,
     sf_moved_loop, {NPY_DOUBLE, NPY_DOUBLE}},
    {"interval_product", "(),(),(),()->(),()", "lo, hi, lo, hi -> lo, hi", 4, 2, sf_interval_product_loop,
     {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE}},
    {"interval_square", "(),()->(),()", "lo, hi -> lo, hi", 2, 2, sf_interval_square_loop,
     {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE}},
    {"interval_inverse", "(),()->(),()", "lo, hi -> lo, hi", 2, 2, sf_interval_inverse_loop,
     {NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE, NPY_DOUBLE}},
};

enum { COUNT = sizeof gufuncs / sizeof gufuncs[0] };

static PyUFuncGenericFunction loops[COUNT];
static void *data[COUNT];

static int fill(PyObject *self)
{
    if (PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0)
        return -1;
    if (sf_here() == NULL) {
        PyErr_SetString(PyExc_ImportError,
                        "built on a processor with fma and AVX2, which this one has not: build again");
        return -1;
    }
    for (int i = 0; i < COUNT; i++) {
        loops[i] = (PyUFuncGenericFunction)gufuncs[i].loop;
        PyObject *gufunc = PyUFunc_FromFuncAndDataAndSignature(
            &loops[i], &data[i], (char *)gufuncs[i].types, 1, gufuncs[i].inputs, gufuncs[i].outputs, PyUFunc_None,
            gufuncs[i].name, gufuncs[i].doc, 0, gufuncs[i].signature);
        if (gufunc == NULL)
            return -1;
        const int failed = PyModule_AddObjectRef(self, gufuncs[i].name, gufunc);
        Py_DECREF(gufunc);
        if (failed)
            return -1;
    }
    if (sf_add_records(self) < 0 || sf_add_answers(self) < 0 || sf_add_batches(self) < 0 ||
        sf_add_certificates(self) < 0 || sf_add_second(self) < 0)
        return -1;
#ifdef SF_WITHOUT_BASELINE
    return sf_add_build(self, SF_FMA_TARGET, SF_FMA_CHOSEN);
#else
    return sf_add_build(self, SF_FMA_BUILDS, SF_FMA_CHOSEN);
#endif
}

static PyModuleDef_Slot slots[] = {
    {Py_mod_exec, (void *)fill},
    {0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_native", "Compiled solvers.", 0, NULL, slots, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit__native(void)
{
    return PyModuleDef_Init(&definition);
}
