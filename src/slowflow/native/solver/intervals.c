/* The operations on intervals (program.h) over NumPy's operands, as slowflow/core/intervals.py takes them. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "elementary.h"
#include "program.h"
#include "solver.h"

typedef struct {
    const char *name;
    sf_interval (*of)(sf_interval a, sf_interval b);
} operation;

#define FUNCTION(x, value)                                                                                             \
    static sf_interval of_##x(sf_interval a, sf_interval b) {                                                          \
        (void)a, (void)b;                                                                                              \
        return value;                                                                                                  \
    }
#define ROW(x, value) {#x, of_##x},
SF_OPERATIONS_ON_INTERVALS(FUNCTION)
static const operation operations[] = {SF_OPERATIONS_ON_INTERVALS(ROW)};

#define IN(k) (*(const double *)(operands[k] + i * steps[k]))
#define OUT(k) (*(double *)(operands[k] + i * steps[k]))

static void loop(char **operands, const ptrdiff_t *dimensions, const ptrdiff_t *steps, void *data) {
    const operation *const operation = data;
    for (ptrdiff_t i = 0; i < dimensions[0]; i++) {
        const sf_interval found = operation->of(sfi_of(IN(0), IN(1)), sfi_of(IN(2), IN(3)));
        OUT(4) = found.lo, OUT(5) = found.hi;
    }
}

int sf_add_intervals(PyObject *module) {
    PyObject *const found = PyDict_New();
    int failed = found == NULL || PyModule_AddObjectRef(module, "INTERVALS", found) < 0;
    for (size_t i = 0; i < sizeof operations / sizeof *operations && !failed; i++) {
        PyObject *const ufunc = sf_new_ufunc(operations[i].name, "lo, hi, lo, hi -> lo, hi", "(),(),(),()->(),()",
                                             "dddddd", loop, (void *)&operations[i]);
        failed = ufunc == NULL || PyDict_SetItemString(found, operations[i].name, ufunc) < 0;
        Py_XDECREF(ufunc);
    }
    Py_XDECREF(found);
    return failed ? -1 : 0;
}
