/* The extension module slowflow_kernels._native: the compiled kernels of all modules.

   Written by `make derive`; never edit. */

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_2_0_API_VERSION
#define NPY_TARGET_VERSION NPY_2_0_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>

#include "build.h"
#include "kernels.h"

_Static_assert(35 <= SF_MOST_OPERANDS, "more room for arguments and results in kernels.h");
static char all_double[SF_MOST_OPERANDS];
static PyUFuncGenericFunction run[] = {sf_run};

/* One ufunc; its data is the kernel's table entry, which lives as long as the process. */
static PyObject *ufunc_of(const sf_kernel *kernel) {
    void **data = PyMem_Malloc(sizeof(void *));
    if (data == NULL)
        return PyErr_NoMemory();
    data[0] = (void *)kernel;
    return PyUFunc_FromFuncAndData(run, data, all_double, 1, kernel->inputs, kernel->outputs, PyUFunc_None,
                                   kernel->name, "", 0);
}

/* The compiled kernels of a generated module, in the order in which it assigns them. */
static PyObject *ufuncs_of(const sf_module *module) {
    PyObject *ufuncs = PyTuple_New(module->count);
    for (int i = 0; ufuncs != NULL && i < module->count; i++) {
        PyObject *ufunc = ufunc_of(&module->kernels[i]);
        if (ufunc == NULL || PyTuple_SetItem(ufuncs, i, ufunc) < 0)
            Py_CLEAR(ufuncs);
    }
    return ufuncs;
}

#define LOADS(module) \
    extern const sf_module sf_module_##module; \
    static PyObject *load_##module(PyObject *self, PyObject *none) \
    { \
        (void)self, (void)none; \
        return ufuncs_of(&sf_module_##module); \
    }

#define LOADED(module) { #module, load_##module, METH_NOARGS, "The compiled kernels of slowflow_kernels." #module "."},

#define MODULES(EACH) \
    EACH(slow_flow) EACH(frequencies) EACH(inertia) EACH(off_centre) EACH(dissipation) EACH(linearization) \
    EACH(sensitivities) EACH(sampled) EACH(motion) EACH(second_approximation) EACH(den_hartog) EACH(duffing) \
    EACH(rod_spring) EACH(rod_spring_untruncated)

MODULES(LOADS)

static PyMethodDef methods[] = {
    MODULES(LOADED)
    {NULL, NULL, 0, NULL},
};

static int fill(PyObject *self) {
    if (PyArray_ImportNumPyAPI() < 0 || PyUFunc_ImportUFuncAPI() < 0)
        return -1;
    for (int i = 0; i < SF_MOST_OPERANDS; i++)
        all_double[i] = NPY_DOUBLE;
    return sf_add_build(self, SF_WIDE_BUILDS, SF_WIDE_CHOSEN);
}

static PyModuleDef_Slot slots[] = {
    {Py_mod_exec, (void *)fill},
    {0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_native", "Compiled kernels.", 0, methods, slots, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit__native(void) {
    return PyModuleDef_Init(&definition);
}
