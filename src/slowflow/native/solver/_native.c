/* The extension module slowflow._native: records, models, and the compiled solvers over them. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include "solver.h"

#include "build.h"

/* Every generalised ufunc of the solver: one line here, its loop in solver.h. */
static const struct {
    const char *name, *signature, *types, *doc;
    sf_gufunc_loop *loop;
} gufuncs[] = {
    {"response_roots", "(),(),(),(),()->(3),()", "ddddddi", "A, h, m, zeta, F_0 -> Omega, number of roots.",
     sf_response_roots_loop},
    {"fold_roots", "(),(),(),(),()->(3),()", "ddddddi", "A, h, h_A, m, zeta -> Omega, number of roots.",
     sf_fold_roots_loop},
    {"peak_roots", "(),(),(),()->(2),()", "dddddi", "A, h, m, zeta -> Omega, number of roots.", sf_peak_roots_loop},
    {"law_roots", "(),(),(),(),(),(),(),(),()->(3)", "dddddddddd",
     "A, h, h_A, m, zeta, eta, d, F_0 (< 0: of the fold locus), inertial -> Omega.", sf_law_roots_loop},
    {"law_peak_roots", "(),(),(),(),(),(),()->(2)", "dddddddd", "A, h, m, zeta, eta, d, inertial -> Omega.",
     sf_law_peak_roots_loop},
    {"step_means", "(),(),(),(),(n)->(n),(n)", "ddddddd", "A, a, whether whole, negative k, room -> L_k, M_k.",
     sf_step_means_loop},
    {"curved_means", "(k),(),(),()->(8)", "ddddd", "force without its steps, A, B, orders -> c_n, s_n.",
     sf_curved_means_loop},
    {"curved_between", "(k),(),()->(8)", "dddd",
     "force without its steps, low, high -> between which it and three derivatives are there.", sf_curved_between_loop},
    {"ends", "(n),(d),(d),(),(),(k)->(56)", "ddddddd",
     "charts, low, high, chart, load, force without its steps or nothing -> intervals on the box, and in its middle.",
     sf_ends_loop},
    {"on_balance", "(n),(d),(d),(),(),(k),()->(15)", "dddddddd",
     "box, centred -> low, high, p, resists, rising, A, B; whether that may be some.", sf_on_balance_loop},
    {"ended_state", "(n),(d),(d),(),(),(k),(),(),(4)->(36)", "dddddddddd",
     "box, Omega, force, damping -> as boxes.h has it.", sf_ended_state_loop},
    {"ended_fold", "(n),(d),(d),(),(),(k),(),(),(4),()->(36)", "ddddddddddd",
     "box, F_0, F_2, damping, centred -> as boxes.h has it.", sf_ended_fold_loop},
    {"ended_edge", "(n),(d),(d),(),(),(k),()->(36)", "dddddddd", "box, edge -> as boxes.h has it.", sf_ended_edge_loop},
    {"may_be_state", "(2),(2),(),(),(4)->()", "dddddd", "A, p, Omega, force, damping -> whether there may be states.",
     sf_may_be_state_loop},
    {"folds_between", "(2),(2),(2),(4),(),(),(),()->(2),()", "dddddddddd",
     "A, p, e, damping, inertial, sign of R, lowest, highest F_0 -> |R|; whether there are folds.",
     sf_folds_between_loop},
    {"moved", "(33)->(6)", "dd", "an answer by what is known there, and of that -> derivatives, whether it is single.",
     sf_slopes_loop},
};

static int fill(PyObject *self) {
    if (sf_here() == NULL) {
        PyErr_SetString(PyExc_ImportError,
                        "built on a processor with fma and AVX2, which this one has not: build again");
        return -1;
    }
    if (sf_add_records(self) < 0 || sf_add_questions(self) < 0 || sf_add_boxes(self) < 0 || sf_add_intervals(self) < 0)
        return -1;
    for (size_t i = 0; i < sizeof gufuncs / sizeof gufuncs[0]; i++) {
        PyObject *gufunc = sf_new_ufunc(gufuncs[i].name, gufuncs[i].doc, gufuncs[i].signature, gufuncs[i].types,
                                        gufuncs[i].loop, NULL);
        const int failed = gufunc == NULL || PyModule_AddObjectRef(self, gufuncs[i].name, gufunc) < 0;
        Py_XDECREF(gufunc);
        if (failed)
            return -1;
    }
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

PyMODINIT_FUNC PyInit__native(void) { return PyModuleDef_Init(&definition); }
