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

extern const sf_module sf_module_slow_flow;
extern const sf_module sf_module_slow_flow_mu0;
extern const sf_module sf_module_slow_flow_zeta0;
extern const sf_module sf_module_slow_flow_mu0_zeta0;
extern const sf_module sf_module_second_approximation;
extern const sf_module sf_module_den_hartog;
extern const sf_module sf_module_duffing;
extern const sf_module sf_module_duffing_mu0;
extern const sf_module sf_module_duffing_zeta0;
extern const sf_module sf_module_duffing_mu0_zeta0;
extern const sf_module sf_module_rod_spring;
extern const sf_module sf_module_rod_spring_mu0;
extern const sf_module sf_module_rod_spring_zeta0;
extern const sf_module sf_module_rod_spring_mu0_zeta0;
extern const sf_module sf_module_rod_spring_attached;
extern const sf_module sf_module_rod_spring_exact;
extern const sf_module sf_module_rod_spring_exact_mu0;
extern const sf_module sf_module_rod_spring_exact_zeta0;
extern const sf_module sf_module_rod_spring_exact_mu0_zeta0;

static const sf_module *const modules[] = {
    &sf_module_slow_flow,
    &sf_module_slow_flow_mu0,
    &sf_module_slow_flow_zeta0,
    &sf_module_slow_flow_mu0_zeta0,
    &sf_module_second_approximation,
    &sf_module_den_hartog,
    &sf_module_duffing,
    &sf_module_duffing_mu0,
    &sf_module_duffing_zeta0,
    &sf_module_duffing_mu0_zeta0,
    &sf_module_rod_spring,
    &sf_module_rod_spring_mu0,
    &sf_module_rod_spring_zeta0,
    &sf_module_rod_spring_mu0_zeta0,
    &sf_module_rod_spring_attached,
    &sf_module_rod_spring_exact,
    &sf_module_rod_spring_exact_mu0,
    &sf_module_rod_spring_exact_zeta0,
    &sf_module_rod_spring_exact_mu0_zeta0,
};

static char all_double[SF_MOST_OPERANDS];
static PyUFuncGenericFunction run[] = {sf_run};

/* One ufunc; its data is the kernel's table entry, which lives as long as the process. */
static PyObject *ufunc_of(const sf_kernel *kernel)
{
    void **data = PyMem_Malloc(sizeof(void *));
    if (data == NULL)
        return PyErr_NoMemory();
    data[0] = (void *)kernel;
    return PyUFunc_FromFuncAndData(run, data, all_double, 1, kernel->inputs, kernel->outputs, PyUFunc_None,
                                   kernel->name, kernel->doc, 0);
}

static PyObject *load(PyObject *self, PyObject *name)
{
    (void)self;
    for (size_t k = 0; k < sizeof modules / sizeof modules[0]; k++) {
        if (PyUnicode_CompareWithASCIIString(name, modules[k]->name) != 0)
            continue;
        PyObject *found = PyDict_New();
        for (int i = 0; found != NULL && i < modules[k]->count; i++) {
            const sf_kernel *kernel = &modules[k]->kernels[i];
            PyObject *ufunc = ufunc_of(kernel);
            PyObject *pair = ufunc == NULL ? NULL : Py_BuildValue("(NC)", ufunc, (int)kernel->returns);
            if (pair == NULL || PyDict_SetItemString(found, kernel->name, pair) < 0)
                Py_CLEAR(found);
            Py_XDECREF(pair);
        }
        return found;
    }
    return PyErr_Format(PyExc_KeyError, "no generated module %R", name);
}

static PyMethodDef methods[] = {
    {"load", load, METH_O, "The compiled kernels of a generated module: name -> (ufunc, 's'|'t'|'c' for what it returns)."},
    {NULL, NULL, 0, NULL},
};

static int fill(PyObject *self)
{
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

PyMODINIT_FUNC PyInit__native(void)
{
    return PyModuleDef_Init(&definition);
}
