/* How an extension module was built, as a dictionary BUILD in it. */
#pragma once

#include "clones.h"

#define SF_TEXT_(x) #x
#define SF_TEXT(x) SF_TEXT_(x)

#if defined(Py_LIMITED_API)
#define SF_ABI "abi3, Python " SF_TEXT(PY_MAJOR_VERSION) "." SF_TEXT(PY_MINOR_VERSION) " headers"
#else
#define SF_ABI "Python " SF_TEXT(PY_MAJOR_VERSION) "." SF_TEXT(PY_MINOR_VERSION) " only"
#endif

/* builds: the targets that the loops were built for; chosen: the one that runs here */
static int sf_add_build(PyObject *module, const char *builds, const char *chosen) {
#ifdef SF_HERE
    if (!SF_HAS(SF_HERE)) {
        PyErr_SetString(PyExc_ImportError, "they were compiled for a processor of " SF_HERE);
        return -1;
    }
#endif
    PyObject *build = Py_BuildValue("{s:s,s:s,s:s,s:s,s:s}", "compiler", SF_COMPILER, "abi", SF_ABI, "builds", builds,
                                    "chosen", chosen, "processor", SF_PROCESSOR);
    if (build == NULL)
        return -1;
    const int failed = PyModule_AddObjectRef(module, "BUILD", build);
    Py_DECREF(build);
    return failed;
}
