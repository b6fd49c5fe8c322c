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
                                   kernel->name, "", 0);
}

/* The compiled kernels of a generated module, in the order in which it assigns them. */
static PyObject *ufuncs_of(const sf_module *module)
{
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

LOADS(slow_flow)
LOADS(slow_flow_mu0)
LOADS(slow_flow_zeta0)
LOADS(slow_flow_mu0_zeta0)
LOADS(frequencies)
LOADS(inertia)
LOADS(off_centre)
LOADS(dissipation)
LOADS(linearization)
LOADS(sensitivities)
LOADS(sampled)
LOADS(motion)
LOADS(second_approximation)
LOADS(den_hartog)
LOADS(duffing)
LOADS(rod_spring)
LOADS(rod_spring_untruncated)

static PyMethodDef methods[] = {
    {"slow_flow", load_slow_flow, METH_NOARGS, "The compiled kernels of slowflow_kernels.slow_flow."},
    {"slow_flow_mu0", load_slow_flow_mu0, METH_NOARGS, "The compiled kernels of slowflow_kernels.slow_flow_mu0."},
    {"slow_flow_zeta0", load_slow_flow_zeta0, METH_NOARGS, "The compiled kernels of slowflow_kernels.slow_flow_zeta0."},
    {"slow_flow_mu0_zeta0", load_slow_flow_mu0_zeta0, METH_NOARGS, "The compiled kernels of slowflow_kernels.slow_flow_mu0_zeta0."},
    {"frequencies", load_frequencies, METH_NOARGS, "The compiled kernels of slowflow_kernels.frequencies."},
    {"inertia", load_inertia, METH_NOARGS, "The compiled kernels of slowflow_kernels.inertia."},
    {"off_centre", load_off_centre, METH_NOARGS, "The compiled kernels of slowflow_kernels.off_centre."},
    {"dissipation", load_dissipation, METH_NOARGS, "The compiled kernels of slowflow_kernels.dissipation."},
    {"linearization", load_linearization, METH_NOARGS, "The compiled kernels of slowflow_kernels.linearization."},
    {"sensitivities", load_sensitivities, METH_NOARGS, "The compiled kernels of slowflow_kernels.sensitivities."},
    {"sampled", load_sampled, METH_NOARGS, "The compiled kernels of slowflow_kernels.sampled."},
    {"motion", load_motion, METH_NOARGS, "The compiled kernels of slowflow_kernels.motion."},
    {"second_approximation", load_second_approximation, METH_NOARGS, "The compiled kernels of slowflow_kernels.second_approximation."},
    {"den_hartog", load_den_hartog, METH_NOARGS, "The compiled kernels of slowflow_kernels.den_hartog."},
    {"duffing", load_duffing, METH_NOARGS, "The compiled kernels of slowflow_kernels.duffing."},
    {"rod_spring", load_rod_spring, METH_NOARGS, "The compiled kernels of slowflow_kernels.rod_spring."},
    {"rod_spring_untruncated", load_rod_spring_untruncated, METH_NOARGS, "The compiled kernels of slowflow_kernels.rod_spring_untruncated."},
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
