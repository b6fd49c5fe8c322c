/* The second approximation's balance, and Newton's iteration in lanes. Takes points near its curve; returns those to
 * which each changes.
 */
#pragma once

#include "elementary.h"
#include "model.h"
#include "second_approximation.h"
#include "second_conventions.h"
#include "second_lanes.h"

enum { SF_LANES = 64 };

/* step to the frequency of a given R after which Newton's iteration takes over */
#define SF_MATCHED 1e-5

typedef struct {
    const sf_model *model;
    double F_0;
    sf_wanted extent;
} sf_second;

/* ==== The balance ================================================================================================= */

/* What the balance is at a state, in the order of the kernel. */
typedef union {
    double values[SF_BALANCE];
    struct {
        double u_max, A_1, phi, R, F, F_A, F_Omega, R_A, R_Omega;
    };
} sf_balance;

static void sf_second_known(const sf_model *model, ptrdiff_t n, const double *A, double *known) {
    model->mechanism->averaged(model->mechanism, n, A, model->p, known);
    model->mechanism->harmonics(model->mechanism, n, A, model->p, known + 4 * n);
}

static void sf_second_of(const sf_second *second, double Omega, double A, const double *known, sf_balance *out) {
    const double force = sf_force(second->model, second->F_0, Omega);
    second_approximation_response(Omega, A, force, second->model->m, second->model->zeta, known[0], known[1], known[2],
                                  known[4], known[5], known[6], known[8], known[9], known[10], out->values);
    if (sf_inertial(second->model))
        out->F_Omega -= sf_force_squared_slope(Omega, second->F_0);
}

/* The amplitude of the excitation for which this is a steady state, u_max, and what vanishes where that amplitude is
 * least. */
static void sf_second_level(const sf_model *model, double Omega, double A, double out[3]) {
    double k[SF_KNOWN];
    sf_second_known(model, 1, &A, k);
    (sf_inertial(model) ? second_approximation_detachment_by_inertia : second_approximation_detachment)(
        Omega, A, model->m, model->zeta, k[0], k[1], k[2], k[4], k[5], k[6], k[8], k[9], k[10], out);
}

/* The balance at whole vectors of states. */
static inline void sf_lane_balances(const sf_second *second, int phases, int n, const double *Omega, const double *A,
                                    const double *known, double *out) {
    sf_second_balances(n, Omega, A, second->F_0, sf_inertial(second->model), phases, second->model->m,
                       second->model->zeta, known, out);
}

static sf_balance sf_second_at(const sf_second *second, double Omega, double A) {
    sf_balance out;
    double known[SF_KNOWN];
    sf_second_known(second->model, 1, &A, known);
    sf_second_of(second, Omega, A, known, &out);
    return out;
}

/* Where the third harmonic is above its resonance. */
static inline int sf_off_resonance(double Omega, double A, double h) {
    return fabs(h) < SECOND_APPROXIMATION_RESONANCE * A * Omega * Omega;
}

/* Where the harmonics are a correction: the force's, and friction's, which take u_max below A. */
static inline int sf_is_small(double Omega, double A, double h, double A_1, double u_max) {
    return sf_off_resonance(Omega, A, h) && fabs(A_1 / A - 1) < SF_HARMONICS && fabs(u_max / A - 1) < SF_SMALL;
}

static int sf_second_is_small(const sf_second *second, double Omega, double A) {
    double known[SF_KNOWN];
    sf_balance at;
    sf_second_known(second->model, 1, &A, known);
    sf_second_of(second, Omega, A, known, &at);
    return sf_is_small(Omega, A, known[0], at.A_1, at.u_max);
}

static inline double sf_clipped(double step) { return fmin(fmax(step, -SF_LONGEST), SF_LONGEST); }

static inline double sf_grown(double x) { return fabs(x) < SF_SHORT ? sf_short_exp(x) : exp(x); }

/* ==== Newton's iteration in lanes ================================================================================= */

/* Points under way: where they are, and which they are. */
typedef struct {
    double Omega[SF_LANES], A[SF_LANES], R[SF_LANES];
    int which[SF_LANES];
    int n;
} sf_lanes;

/* Points where they end: with the last step, infinite where none was taken, and -1 where none is required; and what is
 * looked for there, F_A or u_max, of points that went their own way. */
typedef struct {
    double *Omega, *A, *R, *step, *value;
} sf_solved;

/* Whole vectors of lanes: the last one again and again. */
static int sf_whole_lanes(sf_lanes *lanes) {
    int n = lanes->n, i;
    for (i = n; i < SF_LANES && i % SF_WIDEST != 0; i++)
        lanes->Omega[i] = lanes->Omega[n - 1], lanes->A[i] = lanes->A[n - 1], lanes->R[i] = lanes->R[n - 1];
    return i;
}

/* Steps of the lanes to logarithms, which are taken: values times exp(step). */
static void sf_take_steps(int n, const double *restrict steps, const double *restrict grown, double *restrict values) {
    int is_long = 0;
    for (int i = 0; i < n; i++)
        is_long |= !(fabs(steps[i]) < SF_SHORT);
    if (!is_long) { /* a loop that vectorises */
        for (int i = 0; i < n; i++)
            values[i] *= grown[i];
        return;
    }
    for (int i = 0; i < n; i++)
        values[i] *= fabs(steps[i]) < SF_SHORT ? grown[i] : exp(steps[i]);
}

/* The frequency at which the cosine balance is R, the one given where R hardly depends on it. */
static void sf_second_match(const sf_second *second, int n, const double *known, sf_lanes *lanes) {
    double out[SF_BALANCE * SF_LANES], matches[SF_MATCH * SF_LANES], way[SF_LANES] = {0};
    for (int k = 0; k < SF_MATCHING; k++) {
        int open = 0;
        sf_lane_balances(second, 0, n, lanes->Omega, lanes->A, known, out);
        sf_second_matches(n, lanes->Omega, lanes->R, way, second->F_0, out, matches);
        sf_take_steps(n, matches, matches + n, lanes->Omega);
        for (int i = 0; i < n; i++) {
            way[i] += matches[i];
            open |= fabs(matches[i]) > SF_MATCHED;
        }
        if (!open)
            break;
    }
}

/* Newton's iteration of the lanes; match: whether they are so far that their frequencies should first match R. */
static void sf_second_settle(const sf_second *second, sf_lanes *lanes, int match, const sf_solved *solved) {
    const double F_0 = second->F_0;
    double known[SF_KNOWN * SF_LANES], out[SF_BALANCE * SF_LANES], newton[SF_NEWTON * SF_LANES];
    for (int k = 0; k < SF_STEPS && lanes->n > 0; k++) {
        const int n = sf_whole_lanes(lanes), count = lanes->n;
        const double *size = newton, *done = newton + n, *R = newton + 2 * n, *x = newton + 3 * n, *z = newton + 5 * n;
        sf_second_known(second->model, n, lanes->A, known);
        if (match)
            sf_second_match(second, n, known, lanes);
        sf_lane_balances(second, 0, n, lanes->Omega, lanes->A, known, out);
        sf_second_newton(n, lanes->Omega, lanes->A, F_0, out, newton);
        sf_take_steps(count, x, x + n, lanes->A);
        sf_take_steps(count, z, z + n, lanes->Omega);
        lanes->n = 0;
        for (int i = 0; i < count; i++) {
            const double Omega = lanes->Omega[i], A = lanes->A[i];
            const int which = lanes->which[i], to = lanes->n;
            solved->Omega[which] = Omega, solved->A[which] = A, solved->R[which] = R[i], solved->step[which] = size[i];
            if (size[i] > done[i]) { /* NaN ends it too */
                lanes->Omega[to] = Omega, lanes->A[to] = A, lanes->R[to] = R[i];
                lanes->which[to] = which, lanes->n++;
            }
        }
    }
    lanes->n = 0; /* what is not settled by now does not settle */
}

static void sf_enter_lane(const sf_second *second, int which, double Omega, double A, double R, int match,
                          sf_lanes *lanes, const sf_solved *solved) {
    lanes->Omega[lanes->n] = Omega, lanes->A[lanes->n] = A, lanes->R[lanes->n] = R;
    lanes->which[lanes->n++] = which;
    if (lanes->n == SF_LANES)
        sf_second_settle(second, lanes, match, solved);
}
