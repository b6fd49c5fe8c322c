/* The extension module slowflow._exact: the equation of motion, integrated and solved without the GIL.
 *
 * An oscillator is a capsule that nothing changes after it is made; all else is on the stack or allocated by the call:
 * any number of threads may ask at once. Every function that integrates takes the steps that it may spend and returns
 * (outcome, steps spent, ...); see `sf_outcome`. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "taylor.h"
#include "gaussian.h"
#include "interpreted.h"
#include "offset.h"
#include "polynomials.h"
#include "shock.h"
#include "trace.h"

#define NAME "slowflow._exact.system"
#define LAW "slowflow._exact.law"
#define TABLE "slowflow._exact.laws"

/* with its laws, which are its context */
static void free_system(PyObject *capsule) {
    Py_XDECREF((PyObject *)PyCapsule_GetContext(capsule));
    PyMem_Free(PyCapsule_GetPointer(capsule, NAME));
}

/* the numbers of a tuple; with an error set if they are none */
static void numbers(PyObject *tuple, double *out, Py_ssize_t count) {
    for (Py_ssize_t i = 0; i < count && !PyErr_Occurred(); i++)
        out[i] = PyFloat_AsDouble(PyTuple_GetItem(tuple, i));
}

static void release(Py_buffer *const *buffers) {
    for (; *buffers != NULL; buffers++)
        PyBuffer_Release(*buffers);
}
#define RELEASE(...) release((Py_buffer *const[]){__VA_ARGS__, NULL})

/* pieces by rising u; constants less the side of u = 0 */
static PyObject *make_system(PyObject *self, PyObject *arguments) {
    PyObject *laws, *constants, *edges;
    double mu, zeta, load, c_2, mu_s, eta, c_3, zeta_2, jump = 0.0;
    int about, odd, inertial, released;
    if (!PyArg_ParseTuple(arguments, "O!O!O!ipddpddpdddd|d", &PyTuple_Type, &laws, &PyTuple_Type, &constants,
                          &PyTuple_Type, &edges, &about, &odd, &mu, &zeta, &inertial, &load, &c_2, &released, &mu_s,
                          &eta, &c_3, &zeta_2, &jump))
        return NULL;
    const Py_ssize_t pieces = PyTuple_Size(laws);
    if (pieces < 1 || PyTuple_Size(constants) != pieces || PyTuple_Size(edges) != pieces - 1 || about < 0 ||
        about >= pieces)
        return PyErr_Format(PyExc_ValueError, "%zd pieces of a force, with other numbers of constants or ends", pieces);
    size_t room = (size_t)pieces + 1;
    for (Py_ssize_t i = 0; i < pieces; i++) {
        const sf_law *const law = PyCapsule_GetPointer(PyTuple_GetItem(laws, i), LAW);
        PyObject *const own = PyTuple_GetItem(constants, i);
        if (law == NULL)
            return NULL;
        if (!PyTuple_Check(own) || PyTuple_Size(own) != law->constants)
            return PyErr_Format(PyExc_ValueError, "%s has to have as many constants as it takes, %d", law->name,
                                law->constants);
        room += 2 * ((size_t)law->constants + 1);
    }
    const size_t fixed = sizeof(sf_system) + (size_t)pieces * sizeof(sf_piece);
    sf_system *const system = PyMem_Calloc(1, fixed + room * sizeof(double));
    if (system == NULL)
        return PyErr_NoMemory();
    sf_piece *const piece = (sf_piece *)(system + 1);
    double *const edge = (double *)(piece + pieces), *at = edge + pieces + 1;
    *system = (sf_system){(int)pieces, about, odd,      piece, edge, mu,  zeta, inertial,
                          load,        c_2,   released, mu_s,  jump, eta, c_3,  zeta_2};
    edge[0] = -SF_FAR, edge[pieces] = SF_FAR;
    numbers(edges, edge + 1, pieces - 1);
    for (Py_ssize_t i = 0; i < pieces && !PyErr_Occurred(); i++) {
        const sf_law *const law = piece[i].law = PyCapsule_GetPointer(PyTuple_GetItem(laws, i), LAW);
        const Py_ssize_t count = law->constants;
        for (int side = 0; side < 2; side++, at += count + 1) {
            numbers(PyTuple_GetItem(constants, i), at, count);
            at[count] = jump != 0.0 ? (edge[i + 1] > 0.0) - (edge[i] < 0.0) : side ? 1.0 : -1.0;
            piece[i].p[side] = at;
        }
        piece[i].below = i > about ? &piece[i - 1] : i < about ? &piece[i + 1] : NULL;
    }
    PyObject *const capsule = PyErr_Occurred() ? NULL : PyCapsule_New(system, NAME, free_system);
    if (capsule == NULL)
        PyMem_Free(system);
    else
        PyCapsule_SetContext(capsule, Py_NewRef(laws));
    return capsule;
}

/* {name: law} of a table that ends with a law without a name */
static PyObject *laws_of(const sf_law *law) {
    PyObject *const laws = PyDict_New();
    for (; laws != NULL && law->name != NULL; law++) {
        PyObject *const capsule = PyCapsule_New((void *)law, LAW, NULL);
        const int failed = capsule == NULL || PyDict_SetItemString(laws, law->name, capsule) < 0;
        Py_XDECREF(capsule);
        if (failed) {
            Py_DECREF(laws);
            return NULL;
        }
    }
    return laws;
}

static PyObject *laws(PyObject *self, PyObject *table) {
    const sf_law *const law = PyCapsule_GetPointer(table, TABLE);
    return law == NULL ? NULL : laws_of(law);
}

/* A law from words and numbers of a program, in order; None where that is too large. */
static PyObject *interpreted(PyObject *self, PyObject *arguments) {
    const char *name;
    Py_buffer code, numbers;
    if (!PyArg_ParseTuple(arguments, "sy*y*", &name, &code, &numbers))
        return NULL;
    sf_reading status;
    const sf_law *const law = sf_read_law(name, code.buf, (size_t)code.len / sizeof(int), numbers.buf,
                                          (size_t)numbers.len / sizeof(double), &status);
    RELEASE(&code, &numbers);
    if (status == SF_NO_PROGRAM)
        return PyErr_Format(PyExc_ValueError, "%s: its force is no program", name);
    return status == SF_NO_ROOM     ? PyErr_NoMemory()
           : status == SF_TOO_LARGE ? Py_NewRef(Py_None)
                                    : PyCapsule_New((void *)law, LAW, NULL);
}

static void free_law(PyObject *capsule) { free(PyCapsule_GetPointer(capsule, LAW)); }

/* A law from rows of polynomials for u < 0 and for u > 0, see polynomials.h. */
static PyObject *polynomials(PyObject *self, PyObject *arguments) {
    enum { ROW = 4 + 2 * SF_SUMMED };
    Py_buffer below, above;
    if (!PyArg_ParseTuple(arguments, "y*y*", &below, &above))
        return NULL;
    const Py_buffer *const both[] = {&below, &above};
    const double (*rows[2])[ROW];
    int count[2], fits = 1;
    for (int s = 0; s < 2; s++) {
        const double (*const row)[ROW] = rows[s] = both[s]->buf;
        count[s] = (int)(both[s]->len / (Py_ssize_t)sizeof *row);
        fits &= count[s] > 0 && both[s]->len == count[s] * (Py_ssize_t)sizeof *row;
        for (int k = 0; fits && k < count[s]; k++)
            fits = row[k][1] > 0.0 && row[k][2] >= 0.0 && row[k][2] <= SF_MOST_POWER && row[k][3] >= 0.0 &&
                   row[k][3] <= SF_MOST_DEGREE && (k == 0 || row[k][0] > row[k - 1][0]);
    }
    sf_law *const law = fits ? sf_polynomial_law((const double (*const *)[ROW])rows, count) : NULL;
    RELEASE(&below, &above);
    if (law == NULL)
        return fits ? PyErr_NoMemory() : PyErr_Format(PyExc_ValueError, "rows that are no polynomials of a force");
    PyObject *const capsule = PyCapsule_New(law, LAW, free_law);
    if (capsule == NULL)
        free(law);
    return capsule;
}

/* The oscillator of a capsule, as "O&" of PyArg_ParseTuple takes it. */
static int oscillator(PyObject *capsule, void *to) {
    return (*(const sf_system **)to = PyCapsule_GetPointer(capsule, NAME)) != NULL;
}

/* Whether an oscillator has a piece of that number, and results fit their room; an error is set where not. */
static int has_piece(const sf_system *system, int region, int fits, const char *unfit) {
    if (region < -system->about || region >= system->pieces - system->about)
        PyErr_Format(PyExc_ValueError, "no piece of a force is number %d", region);
    else if (!fits)
        PyErr_SetString(PyExc_ValueError, unfit);
    return !PyErr_Occurred();
}

static PyObject *advance(PyObject *self, PyObject *arguments) {
    sf_forced forced;
    int slip, region;
    double theta, u, v, end;
    Py_buffer out;
    if (!PyArg_ParseTuple(arguments, "O&ddiiddddlw*", oscillator, &forced.system, &forced.Omega, &forced.F_0, &slip,
                          &region, &theta, &u, &v, &end, &forced.left, &out))
        return NULL;
    sf_four flow[2];
    const long most = forced.left;
    sf_outcome outcome = SF_GOOD;
    if (has_piece(forced.system, region, out.len == (Py_ssize_t)sizeof flow, "room for too few derivatives")) {
        Py_BEGIN_ALLOW_THREADS
        const sf_drive drive = sf_drive_of(&forced, slip, region);
        outcome = sf_advance(sf_piece_of(forced.system, region), &drive, theta, end, &u, &v, flow, &forced.left);
        Py_END_ALLOW_THREADS
        memcpy(out.buf, flow, sizeof flow);
    }
    PyBuffer_Release(&out);
    return PyErr_Occurred() ? NULL : Py_BuildValue("ildd", (int)outcome, most - forced.left, u, v);
}

static PyObject *sample(PyObject *self, PyObject *arguments) {
    sf_forced forced;
    sf_phase phase = {0};
    Py_buffer grid, out;
    if (!PyArg_ParseTuple(arguments, "O&ddiidddly*w*", oscillator, &forced.system, &forced.Omega, &forced.F_0,
                          &phase.slip, &phase.region, &phase.theta, &phase.u, &phase.v, &forced.left, &grid, &out))
        return NULL;
    const long count = (long)(grid.len / (Py_ssize_t)sizeof(double)), most = forced.left;
    sf_outcome outcome = SF_GOOD;
    if (has_piece(forced.system, phase.region, out.len == 3 * grid.len, "room for too few states")) {
        Py_BEGIN_ALLOW_THREADS
        outcome = sf_sample(&forced, &phase, grid.buf, count, out.buf);
        Py_END_ALLOW_THREADS
    }
    RELEASE(&grid, &out);
    return PyErr_Occurred() ? NULL : Py_BuildValue("il", (int)outcome, most - forced.left);
}

/* (outcome, steps, numbers as `shocks` has them, phases as bytes, each an sf_stretch); in place of the numbers those of
 * sf_shocked.lost where the motion is lost. */
static PyObject *shock(PyObject *self, PyObject *arguments) {
    sf_shocked shock = {0};
    double begin, after, numbers[SF_SHOCK_NUMBERS] = {0};
    Py_buffer arcs;
    if (!PyArg_ParseTuple(arguments, "O&y*dddddll", oscillator, &shock.system, &arcs, &begin, &after, &shock.u,
                          &shock.v, &shock.rest, &shock.most, &shock.left))
        return NULL;
    const long all = shock.left;
    sf_outcome outcome;
    Py_BEGIN_ALLOW_THREADS
    outcome = sf_shock(&shock, arcs.buf, (long)(arcs.len / (Py_ssize_t)sizeof(sf_arc)), begin, after, numbers);
    Py_END_ALLOW_THREADS
    PyBuffer_Release(&arcs);
    const Py_ssize_t size = shock.count * (Py_ssize_t)sizeof *shock.at;
    PyObject *const phases = PyBytes_FromStringAndSize((const char *)shock.at, size);
    free(shock.phases.at);
    free(shock.at);
    if (phases == NULL)
        return NULL;
    const double *const n = numbers, *const at = shock.lost;
    return outcome != SF_GOOD ? Py_BuildValue("il(ddd)N", (int)outcome, all - shock.left, at[0], at[1], at[2], phases)
                              : Py_BuildValue("il(ddddddd)N", (int)outcome, all - shock.left, n[0], n[1], n[2], n[3],
                                              n[4], n[5], n[6], phases);
}

/* (outcome, steps, u where the motion is lost, u and v at the end of each arc as bytes) */
static PyObject *record(PyObject *self, PyObject *arguments) {
    sf_shocked shock = {0};
    Py_buffer arcs;
    if (!PyArg_ParseTuple(arguments, "O&y*ddll", oscillator, &shock.system, &arcs, &shock.u, &shock.v, &shock.most,
                          &shock.left))
        return NULL;
    const long all = shock.left, count = (long)(arcs.len / (Py_ssize_t)sizeof(sf_arc));
    PyObject *const states = PyBytes_FromStringAndSize(NULL, count * (Py_ssize_t)sizeof(double[2]));
    sf_outcome outcome = SF_GOOD;
    if (states != NULL) {
        double (*const out)[2] = (double (*)[2])(void *)PyBytes_AsString(states);
        Py_BEGIN_ALLOW_THREADS
        outcome = sf_recorded(&shock, arcs.buf, count, out);
        Py_END_ALLOW_THREADS
    }
    PyBuffer_Release(&arcs);
    free(shock.phases.at);
    free(shock.at);
    return states == NULL ? NULL : Py_BuildValue("ildN", (int)outcome, all - shock.left, shock.lost[1], states);
}

/* (outcome, steps, phases as bytes, each an sf_phase) */
static PyObject *follow(PyObject *self, PyObject *arguments) {
    sf_forced forced = {0};
    double theta, u, v, end;
    int inputs, start[2];
    if (!PyArg_ParseTuple(arguments, "O&ddddddpiil", oscillator, &forced.system, &forced.Omega, &forced.F_0, &theta, &u,
                          &v, &end, &inputs, &start[0], &start[1], &forced.left))
        return NULL;
    const long most = forced.left;
    sf_phases phases = {0};
    sf_outcome outcome;
    Py_BEGIN_ALLOW_THREADS
    outcome = sf_follow(&forced, theta, u, v, end, inputs ? start : NULL, &phases);
    Py_END_ALLOW_THREADS
    PyObject *const bytes =
        PyBytes_FromStringAndSize((const char *)phases.at, phases.count * (Py_ssize_t)sizeof *phases.at);
    free(phases.at);
    return bytes == NULL ? NULL : Py_BuildValue("ilN", (int)outcome, most - forced.left, bytes);
}

/* (outcome, steps, A, monodromy, borders): residual, jacobian, of_A, gradients one after the other in `out`; z is
 * moved, `direction` filled where it is given. `extra` is None, a row with its value, or the number of a border. */
static PyObject *newton(PyObject *self, PyObject *arguments) {
    PyObject *result = NULL;
    const sf_system *system;
    Py_buffer signature, z, row, out, direction;
    double F_0, value, tolerance;
    int half_turns, kind, most;
    long border, left;
    if (!PyArg_ParseTuple(arguments, "O&y*iw*diy*dlidlw*w*", oscillator, &system, &signature, &half_turns, &z, &F_0,
                          &kind, &row, &value, &border, &most, &tolerance, &left, &out, &direction))
        return NULL;
    const long k = (long)(signature.len / (Py_ssize_t)(2 * sizeof(int))), n = k + 4;
    const Py_ssize_t unknowns = (k + 3) * (Py_ssize_t)sizeof(double);
    const size_t numbers_of_work = (size_t)((k + 3) * (k + 3) + 2 * (k + 3) + 3 * n);
    double *const work = malloc(numbers_of_work * sizeof *work);
    sf_border *const at = malloc((size_t)(2 * k + 1) * sizeof *at);
    const int fits = k > 0 && z.len == unknowns && out.len >= (Py_ssize_t)(sf_numbers(k) * sizeof(double)) &&
                     direction.len == unknowns && (kind != SF_ROW || row.len == unknowns);
    if (work == NULL || at == NULL)
        PyErr_NoMemory();
    else if (!fits)
        PyErr_SetString(PyExc_ValueError, "arrays that do not fit the phases of the cycle");
    else {
        sf_forced forced = {system, 0.0, F_0, left};
        const sf_cycle cycle = {k, signature.buf, half_turns, half_turns % 2 ? -1 : 1};
        sf_equations found = sf_equations_in(out.buf, at, k);
        const sf_extra extra = {kind, row.buf, value, border};
        sf_outcome outcome;
        Py_BEGIN_ALLOW_THREADS
        if (most > 0)
            outcome = sf_newton(&forced, &cycle, z.buf, &extra, most, tolerance, &found, direction.buf, work);
        else
            outcome = sf_cycle_equations(&forced, &cycle, z.buf, &found, work);
        Py_END_ALLOW_THREADS
        PyObject *const borders = PyTuple_New(outcome == SF_GOOD ? found.borders : 0);
        for (long i = 0; borders != NULL && outcome == SF_GOOD && i < found.borders; i++)
            PyTuple_SetItem(borders, i, Py_BuildValue("iid", at[i].phase, at[i].rest, at[i].margin));
        if (borders != NULL)
            result = Py_BuildValue("ild(dddd)N", (int)outcome, left - forced.left, found.A, found.monodromy[0][0],
                                   found.monodromy[0][1], found.monodromy[1][0], found.monodromy[1][1], borders);
    }
    free(work);
    free(at);
    RELEASE(&signature, &z, &row, &out, &direction);
    return result;
}

/* (points, steps, pause, step, travelled): the points' numbers row by row in `rows`, which sets how many there may be;
 * `points` holds z and tangent of the last point, of the one before if there is one; `first` those, or nothing. */
static PyObject *trace(PyObject *self, PyObject *arguments) {
    PyObject *result = NULL;
    const sf_system *system;
    Py_buffer signature, points, first, rows;
    sf_course course = {0};
    sf_trail trail = {0};
    double F_0;
    int half_turns;
    long left;
    if (!PyArg_ParseTuple(arguments, "O&y*ipd(dddddd)y*ddy*lw*", oscillator, &system, &signature, &half_turns,
                          &course.starts_from_rest, &F_0, &course.low, &course.high, &course.step, &course.straight,
                          &course.largest, &course.least, &points, &trail.step, &trail.travelled, &first, &left, &rows))
        return NULL;
    const long k = (long)(signature.len / (Py_ssize_t)(2 * sizeof(int))), n = k + 4, size = k + 3;
    const Py_ssize_t place = 2 * size * (Py_ssize_t)sizeof(double);
    const size_t of_newton = (size_t)(size * size + 2 * size + 3 * n), of_equations = sf_numbers(k);
    const long room = (long)((size_t)rows.len / sizeof(double) / sf_numbers_of_point(k));
    double *const work = malloc((of_newton + 3 * (size_t)size + of_equations) * sizeof *work);
    sf_border *const at = malloc((size_t)(2 * k + 1) * sizeof *at);
    if (work == NULL || at == NULL)
        PyErr_NoMemory();
    else if (!(k > 0 && room > 0 && (points.len == place || points.len == 2 * place) &&
               (first.len == 0 || first.len == place)))
        PyErr_SetString(PyExc_ValueError, "arrays that do not fit the phases of the cycle");
    else {
        sf_forced forced = {system, 0.0, F_0, left};
        const sf_cycle cycle = {k, signature.buf, half_turns, half_turns % 2 ? -1 : 1};
        const double *const z = points.buf, *const begin = first.buf;
        trail.last = (sf_curve_point){z, z + size};
        if (points.len > place)
            trail.before = (sf_curve_point){z + 2 * size, z + 3 * size};
        if (first.len)
            course.first = (sf_curve_point){begin, begin + size};
        sf_equations found = sf_equations_in(work + of_newton + 3 * (size_t)size, at, k);
        sf_phases phases = {0};
        sf_pause pause;
        long count;
        Py_BEGIN_ALLOW_THREADS
        count = sf_trace(&forced, &cycle, &course, &trail, rows.buf, room, &found, &phases, work, &pause);
        Py_END_ALLOW_THREADS
        free(phases.at);
        result = Py_BuildValue("llidd", count, left - forced.left, (int)pause, trail.step, trail.travelled);
    }
    free(work);
    free(at);
    RELEASE(&signature, &points, &first, &rows);
    return result;
}

/* An odd force of which each piece has the same constants, p[0] and p[1] by side; those that end at 0 are left out.
 * `piece` has room for 2 pieces - 1, `edge` for one more. */
static sf_system odd_system(const sf_law *const *law, Py_ssize_t pieces, const double *ends, const double *const p[2],
                            const double *damping, sf_piece *piece, double *edge) {
    int about = -1;
    for (Py_ssize_t i = 0; i < pieces; i++)
        about += i == pieces - 1 || ends[i] != 0.0;
    int j = 0;
    for (Py_ssize_t i = 0; i < pieces; i++) {
        const double end = i == pieces - 1 ? SF_FAR : ends[i];
        if (end == 0.0)
            continue;
        piece[about + j] = piece[about - j] = (sf_piece){law[i], {p[0], p[1]}, NULL};
        if (j > 0)
            piece[about + j].below = &piece[about + j - 1], piece[about - j].below = &piece[about - j + 1];
        edge[about + 1 + j] = end, edge[about - j] = -end;
        j++;
    }
    return (sf_system){2 * about + 1, about, 1, piece, edge, damping[0], damping[1], 0, 0.0};
}

/* Designs of one mechanism whose force is odd: laws of its pieces; for each design constants and the ends of its
 * pieces. */
typedef struct {
    Py_buffer constants, ends;
    Py_ssize_t count, size, pieces;
    const sf_law **law;
    sf_piece *piece;
    double *edge;
} sf_designs;

/* Room for so many designs, and whether what they are given as is theirs. */
static int designs_fit(sf_designs *of, PyObject *laws, Py_ssize_t count) {
    const Py_ssize_t one = (Py_ssize_t)sizeof(double);
    of->count = count, of->pieces = PyTuple_Size(laws), of->size = count ? of->constants.len / count / one : 0;
    of->law = PyMem_Calloc((size_t)of->pieces + 1, sizeof *of->law);
    of->piece = PyMem_Calloc(2 * (size_t)of->pieces + 1, sizeof *of->piece);
    of->edge = PyMem_Calloc(2 * (size_t)(of->pieces + of->size) + 2, sizeof *of->edge);
    int fits = of->law != NULL && of->piece != NULL && of->edge != NULL && of->pieces >= 1 &&
               of->constants.len == count * of->size * one && of->ends.len == count * (of->pieces - 1) * one;
    for (Py_ssize_t i = 0; fits && i < of->pieces; i++) {
        of->law[i] = PyCapsule_GetPointer(PyTuple_GetItem(laws, i), LAW);
        fits = of->law[i] != NULL && (count == 0 || of->law[i]->constants == of->size);
    }
    return fits;
}

/* Design k, until the next one is made. */
static sf_system design(const sf_designs *of, Py_ssize_t k, const double *damping) {
    double *const p[2] = {of->edge + 2 * of->pieces, of->edge + 2 * of->pieces + of->size + 1};
    const double *const both[2] = {p[0], p[1]};
    for (int side = 0; side < 2; side++) {
        memcpy(p[side], (const double *)of->constants.buf + k * of->size, (size_t)of->size * sizeof(double));
        p[side][of->size] = side ? 1.0 : -1.0;
    }
    return odd_system(of->law, of->pieces, (const double *)of->ends.buf + k * (of->pieces - 1), both, damping,
                      of->piece, of->edge);
}

/* Of designs that fit, or not: None, or NULL with an error. */
static PyObject *done_with(sf_designs *of, int fit) {
    if (!fit && !PyErr_Occurred())
        PyErr_SetString(PyExc_ValueError, "arrays that do not fit the designs");
    PyMem_Free(of->law);
    PyMem_Free(of->piece);
    PyMem_Free(of->edge);
    RELEASE(&of->constants, &of->ends);
    return PyErr_Occurred() ? NULL : Py_NewRef(Py_None);
}

/* Shocks of designs: for each mu and zeta, arcs and when they begin; out come the outcome and the numbers of each. */
static PyObject *shocks(PyObject *self, PyObject *arguments) {
    PyObject *laws;
    sf_designs of = {0};
    Py_buffer damping, arcs, begin, outcomes, out;
    double after;
    sf_shocked shock = {0};
    long all;
    if (!PyArg_ParseTuple(arguments, "O!y*y*y*y*y*dllw*w*", &PyTuple_Type, &laws, &of.constants, &of.ends, &damping,
                          &arcs, &begin, &after, &shock.most, &all, &outcomes, &out))
        return NULL;
    const Py_ssize_t one = (Py_ssize_t)sizeof(double), count = outcomes.len;
    const Py_ssize_t pulses = count ? arcs.len / count / (Py_ssize_t)sizeof(sf_arc) : 0;
    const int fit = designs_fit(&of, laws, count) && damping.len == 2 * count * one && begin.len == count * one &&
                    arcs.len == count * pulses * (Py_ssize_t)sizeof(sf_arc) &&
                    out.len == count * SF_SHOCK_NUMBERS * one;
    if (fit) {
        Py_BEGIN_ALLOW_THREADS
        for (Py_ssize_t k = 0; k < count; k++) {
            const sf_system system = design(&of, k, (const double *)damping.buf + 2 * k);
            double *const found = (double *)out.buf + k * SF_SHOCK_NUMBERS;
            shock.system = &system, shock.left = all, shock.u = shock.v = 0.0;
            const sf_outcome outcome = sf_shock(&shock, (const sf_arc *)arcs.buf + k * pulses, (long)pulses,
                                                ((const double *)begin.buf)[k], after, found);
            ((signed char *)outcomes.buf)[k] = (signed char)outcome;
            for (int i = 0; outcome != SF_GOOD && i < SF_SHOCK_NUMBERS; i++)
                found[i] = NAN;
        }
        Py_END_ALLOW_THREADS
        free(shock.phases.at);
        free(shock.at);
    }
    RELEASE(&damping, &arcs, &begin, &outcomes, &out);
    return done_with(&of, fit);
}

enum { SF_MOST_MOTIONS = 64, SF_DAMPED_BY = 7 };

/* An sf_gaussian at each of several sigma, as bytes */
static PyObject *averages(PyObject *self, PyObject *arguments) {
    const sf_system *system;
    Py_buffer sigma;
    if (!PyArg_ParseTuple(arguments, "O&y*", oscillator, &system, &sigma))
        return NULL;
    const Py_ssize_t count = sigma.len / (Py_ssize_t)sizeof(double);
    PyObject *const found = PyBytes_FromStringAndSize(NULL, count * (Py_ssize_t)sizeof(sf_gaussian));
    if (found != NULL) {
        sf_gaussian *const out = (sf_gaussian *)(void *)PyBytes_AsString(found);
        Py_BEGIN_ALLOW_THREADS
        const double *const at = sigma.buf;
        double small = HUGE_VAL, large = 0.0;
        for (Py_ssize_t i = 0; i < count; i++)
            small = fmin(small, at[i]), large = fmax(large, at[i]);
        sf_positive force;
        sf_put_parts(system, small, large, &force);
        for (Py_ssize_t i = 0; i < count; i++)
            out[i] = sf_averages(&force, at[i]);
        Py_END_ALLOW_THREADS
    }
    RELEASE(&sigma);
    return found;
}

/* An sf_table as bytes, of points that rise: frequency and density of each */
static PyObject *table(PyObject *self, PyObject *arguments) {
    Py_buffer points;
    if (!PyArg_ParseTuple(arguments, "y*", &points))
        return NULL;
    const int count = (int)(points.len / (Py_ssize_t)(2 * sizeof(double)));
    const Py_ssize_t size =
        (Py_ssize_t)(sizeof(sf_table) + (size_t)sf_read_table(points.buf, count, NULL) * sizeof(sf_band));
    PyObject *const found = PyBytes_FromStringAndSize(NULL, size);
    if (found != NULL)
        sf_read_table(points.buf, count, (sf_table *)PyBytes_AsString(found));
    PyBuffer_Release(&points);
    return found;
}

/* ln I_0 and ln I_2 of a table, their slopes by p and q, and between which ends these and that by p at a constant
 * damping ratio are within radii of p and of the logarithm of that ratio: eighteen numbers as bytes */
static PyObject *moments(PyObject *self, PyObject *arguments) {
    Py_buffer table;
    double p, q, r[2], found[18];
    if (!PyArg_ParseTuple(arguments, "y*dddd", &table, &p, &q, &r[0], &r[1]))
        return NULL;
    const sf_moments at = sf_moments_at(table.buf, p, q, sf_band_reach(r[0]));
    sf_slopes_within(table.buf, &at, p, q, r, (sf_ends(*)[3])(void *)(found + 6));
    memcpy(found + 2, at.by, sizeof at.by);
    memcpy(found, at.value, sizeof at.value);
    RELEASE(&table);
    return PyBytes_FromStringAndSize((const char *)found, sizeof found);
}

/* (k and c next to which there may be others, or 0, k < 0 by the reason why nothing is known; an sf_stationary each, as
 * bytes), of the power of white noise or a table */
static PyObject *stationary(PyObject *self, PyObject *arguments) {
    PyObject *excitation;
    const sf_system *system;
    Py_buffer table = {0};
    sf_stationary at[SF_MOST_MOTIONS];
    sf_motions found = {.max_count = SF_MOST_MOTIONS, .at = at};
    if (!PyArg_ParseTuple(arguments, "O&O", oscillator, &system, &excitation))
        return NULL;
    const double power = PyFloat_Check(excitation) ? PyFloat_AsDouble(excitation) : 0.0;
    if (power == 0.0 && PyObject_GetBuffer(excitation, &table, PyBUF_SIMPLE) < 0)
        return NULL;
    Py_BEGIN_ALLOW_THREADS
    const int outcome = sf_motions_of(system, power, table.buf, &found);
    if (outcome < 1)
        found.undecided[0] = outcome - 1.0;
    Py_END_ALLOW_THREADS
    PyBuffer_Release(&table);
    if (found.count > found.max_count)
        found.count = found.max_count, found.undecided[0] = at[found.max_count - 1].k;
    return Py_BuildValue("ddy#", found.undecided[0], found.undecided[1], (const char *)at,
                         found.count * (Py_ssize_t)sizeof(sf_stationary));
}

/* The same of designs under white noise or a table, for each mu, zeta, c_2, c_3, zeta_2, whether friction ends at the
 * first breakpoint and load, and the power; out come how many there are, -1 where that is undecided, and places for
 * these. */
static PyObject *stationary_of_each(PyObject *self, PyObject *arguments) {
    PyObject *laws;
    sf_designs of = {0};
    Py_buffer damping, power, table, counts, out;
    if (!PyArg_ParseTuple(arguments, "O!y*y*y*y*y*w*w*", &PyTuple_Type, &laws, &of.constants, &of.ends, &damping,
                          &power, &table, &counts, &out))
        return NULL;
    const Py_ssize_t count = counts.len, one = (Py_ssize_t)sizeof(double);
    const Py_ssize_t max_count = count ? out.len / count / (Py_ssize_t)sizeof(sf_stationary) : 0;
    const int fit = designs_fit(&of, laws, count) && (table.len || power.len == count * one) &&
                    damping.len == SF_DAMPED_BY * count * one &&
                    out.len == count * max_count * (Py_ssize_t)sizeof(sf_stationary);
    if (fit) {
        Py_BEGIN_ALLOW_THREADS
        for (Py_ssize_t k = 0; k < count; k++) {
            const double *const own = (const double *)damping.buf + SF_DAMPED_BY * k;
            sf_system system = design(&of, k, own);
            system.c_2 = own[2];
            system.c_3 = own[3];
            system.zeta_2 = own[4];
            system.released = own[5] != 0.0;
            system.load = own[6];
            sf_motions found = {.max_count = (int)max_count, .at = (sf_stationary *)out.buf + k * max_count};
            if (sf_motions_of(&system, table.len ? 0.0 : ((const double *)power.buf)[k], table.buf, &found) < 1)
                found.undecided[0] = -1.0;
            ((signed char *)counts.buf)[k] = (signed char)(found.undecided[0] != 0.0 ? -1 : found.count);
        }
        Py_END_ALLOW_THREADS
    }
    RELEASE(&damping, &power, &table, &counts, &out);
    return done_with(&of, fit);
}

static PyMethodDef methods[] = {
    {"system", make_system, METH_VARARGS,
     "laws, constants, edges, about, odd, mu, zeta, inertial, load, c_2, released, mu_s, eta, c_3, zeta_2 -> an "
     "oscillator."},
    {"laws", laws, METH_O, "The laws of a table in a shared library, by name."},
    {"interpreted", interpreted, METH_VARARGS, "name, code, numbers -> a law, None where it is too large."},
    {"polynomials", polynomials, METH_VARARGS, "rows for u < 0, for u > 0 -> a law."},
    {"advance", advance, METH_VARARGS,
     "system, Omega, F_0, slip, region, theta, u, v, end, steps, derivatives -> outcome, spent, u, v."},
    {"sample", sample, METH_VARARGS,
     "system, Omega, F_0, slip, region, theta, u, v, steps, grid, states -> outcome, spent."},
    {"shock", shock, METH_VARARGS,
     "system, arcs, begin, after, u, v, rest, steps of one integration, of all -> outcome, spent, numbers, phases."},
    {"follow", follow, METH_VARARGS,
     "system, Omega, F_0, theta, u, v, end, started, slip, region, steps -> outcome, spent, phases."},
    {"newton", newton, METH_VARARGS,
     "system, phases, half_turns, z, F_0, extra, row, value, border, most, tolerance, steps, equations, along -> "
     "outcome, spent, A, monodromy, borders."},
    {"trace", trace, METH_VARARGS,
     "system, phases, half_turns, starts_from_rest, F_0, course, last points, step, travelled, first, steps, "
     "rows -> points, spent, pause, step, travelled."},
    {"record", record, METH_VARARGS,
     "system, arcs, u, v, steps of one integration, of all -> outcome, steps, u, states."},
    {"shocks", shocks, METH_VARARGS,
     "laws, constants, ends, damping, arcs, begin, after, steps of one integration, of all, outcomes, numbers -> "
     "None."},
    {"averages", averages, METH_VARARGS, "system, sigma -> Gaussian averages of the force as bytes."},
    {"moments", moments, METH_VARARGS, "table, p, q, radii -> ln I_0, ln I_2, ends of their slopes as bytes."},
    {"table", table, METH_VARARGS, "points of a spectral density -> what `stationary` takes, as bytes."},
    {"stationary", stationary, METH_VARARGS, "system, power or table -> k, c next to others or 0, motions as bytes."},
    {"stationary_of_each", stationary_of_each, METH_VARARGS,
     "laws, constants, ends, damping, powers or a table, counts, places for motions -> None."},
    {NULL, NULL, 0, NULL},
};

static int fill(PyObject *self) {
    PyObject *const laws = laws_of(sf_laws);
    const int failed = laws == NULL || PyModule_AddObjectRef(self, "LAWS", laws) < 0;
    Py_XDECREF(laws);
    return failed ? -1 : 0;
}

static PyModuleDef_Slot slots[] = {
    {Py_mod_exec, (void *)fill},
    {0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_exact", "The equation of motion, compiled.", 0, methods, slots, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit__exact(void) { return PyModuleDef_Init(&definition); }
