/* Laws of damping other than viscous damping and dry friction on all of the way. Takes an amplitude; returns I and
 * its slopes there, and the frequencies of states and folds.
 *
 *   I = I_0 + 2 zeta(A) A Omega + d (A Omega)^2 + d_3 (A Omega)^3
 *
 * I_0 is friction, on all of the way or up to the first breakpoint, and structural damping; zeta(A) = zeta + zeta_2
 * A^2/4, in which zeta > 0 bounds it from below. F and F_A/2 are of degree 6 in Omega, 4 without d_3, of whose
 * coefficients that of Omega^2 alone may be negative besides the constant (derivations/extensions/dissipation.py): they
 * have at most two positive critical points, a maximum and then a minimum. Under an excitation by inertia, with d_3 =
 * 0, F over Omega^4 is such a polynomial in 1/Omega.
 */
#pragma once

#include "cells.h"
#include "dissipation.h"
#include "dissipation_intervals.h"

/* below it F_0^4 and what is its rounding count as 0 */
#define SF_LEAST_F_0 0x1p-240
/* below it squares of amplitudes are not far from where doubles lose digits */
#define SF_TINY 0x1p-400
/* of Newton's method, kept in a bracket */
enum { SF_MOST_LAW_STEPS = 200 };

/* Whether folds are looked for as points of amplitude and frequency (points.h): by other laws, or by inertia. */
static inline int sf_is_searched(const sf_model *model) { return model->by_laws || sf_inertial(model); }

/* mu, zeta, eta, c_2, c_3, zeta_2, and whether friction ends at the first breakpoint */
static inline int sf_laws_damping_of(const double *inputs, double *damping) {
    for (int i = 0; i < 6; i++)
        if (!(inputs[i] >= 0 && inputs[i] < HUGE_VAL))
            return 0;
    damping[0] = slow_flow_friction(inputs[0]), damping[1] = inputs[1], damping[2] = inputs[2];
    damping[3] = dissipation_quadratic(inputs[3]), damping[4] = dissipation_cubic(inputs[4]);
    damping[5] = inputs[5], damping[6] = inputs[6] != 0;
    /* without friction beyond the breakpoint something else has to dissipate there, and next to rest besides c_3
     * and zeta_2 */
    return (inputs[6] == 0 || inputs[1] + inputs[2] + inputs[3] > 0) && (inputs[4] + inputs[5] == 0 || inputs[1] > 0);
}

static inline int sf_inertial_laws_damping_of(const double *inputs, double *damping) {
    return sf_laws_damping_of(inputs, damping) && inputs[4] == 0 && inputs[1] + inputs[2] + inputs[3] > 0;
}

static inline int sf_takes_laws(const sf_mechanism *mechanism) { return mechanism->damping_size == SF_MOST_DAMPING; }

/* Makes a copy of a record one whose damping is of any law. */
static inline void sf_add_laws(sf_mechanism *record) {
    record->damping_size = SF_MOST_DAMPING;
    record->damping_of = record->inertial ? sf_inertial_laws_damping_of : sf_laws_damping_of;
}

/* Whether they have an answer: a force that jumps at u = 0 and pushes outwards has none, and one that is infinitely
 * stiff there none by other laws. */
static inline int sf_allows_laws(const sf_model *model) {
    const sf_sample at = sf_sample_without_k_at(model, 0);
    return at.h <= 0 && (fabs(at.h_A) < HUGE_VAL || !(model->eta != 0 || model->d != 0 || model->released != 0));
}

/* Friction that is left wherever the mass is. */
static inline double sf_friction_throughout(const sf_model *model) { return model->released ? 0 : model->m; }

/* What dissipates at an amplitude: I_0 and the viscous damping ratio of a cycle, each with three derivatives by A. */
typedef struct {
    double rest[4], zeta[4], d, d_3;
} sf_law_terms;

/* beyond: whether A is taken as beyond the first breakpoint */
static inline sf_law_terms sf_law_terms_at(const sf_model *model, double A, int beyond) {
    sf_law_terms of = {.zeta = {model->zeta}, .d = model->d, .d_3 = model->d_3};
    if (model->released && beyond)
        dissipation_released(fmax(A, model->b[0]), model->m, model->eta, model->b[0], of.rest);
    else
        dissipation_at_rest(A, model->m, model->eta, of.rest);
    if (model->zeta_2 != 0)
        dissipation_viscous(A, model->zeta, model->zeta_2, of.zeta);
    return of;
}

static inline int sf_is_beyond(const sf_model *model, double A) { return model->breaks > 0 && A > model->b[0]; }

/* On the piece that ends at A, or holds it. */
static inline sf_law_terms sf_law_terms_below(const sf_model *model, double A) {
    return sf_law_terms_at(model, A, sf_is_beyond(model, A));
}

static inline double sf_law_I(const sf_model *model, double A, double w) {
    const sf_law_terms of = sf_law_terms_below(model, A);
    return dissipation_I(w, A, of.rest[0], of.zeta[0], of.d, of.d_3);
}

/* As sf_level. */
static inline double sf_law_level(const sf_model *model, const sf_sample *at, double w) {
    return (sf_inertial(model) ? inertia_level : slow_flow_level)(w, at->A, sf_law_I(model, at->A, w), 0, at->h);
}

static inline double sf_law_F_A(const sf_model *model, const sf_sample *at, double w, int beyond) {
    const sf_law_terms of = sf_law_terms_at(model, at->A, beyond);
    return dissipation_F_A(w, at->A, of.rest[0], of.rest[1], of.zeta[0], of.zeta[1], of.d, of.d_3, at->h, at->h_A);
}

/* dOmega/dA along the response. */
static inline double sf_law_Omega_A(const sf_model *model, const sf_sample *at, double w) {
    const sf_law_terms of = sf_law_terms_below(model, at->A);
    return (model->mechanism->inertial ? dissipation_Omega_A_by_inertia : dissipation_Omega_A)(
        w, at->A, of.rest[0], of.rest[1], of.zeta[0], of.zeta[1], of.d, of.d_3, at->h, at->h_A);
}

static inline double sf_law_F_AA(const sf_model *model, const sf_sample *at, double w, int beyond) {
    const sf_law_terms of = sf_law_terms_at(model, at->A, beyond);
    return dissipation_F_AA(w, at->A, of.rest[0], of.rest[1], of.rest[2], of.zeta[0], of.zeta[1], of.zeta[2], of.d,
                            of.d_3, at->h, at->h_A, at->h_AA);
}

/* ==== The polynomial of an amplitude ============================================================================== */

typedef enum { SF_OF_RESPONSE, SF_OF_FOLDS } sf_law_polynomial_kind;

/* by_x: it is one in 1/Omega; exist: whether there are critical points w[0] <= w[1]; f: its values at 0 and at these.
 * unit: of Omega where by_x, other than 1 where A and F_0 are in units of 0x1p-600, lest their squares be lost */
typedef struct {
    sf_law_polynomial_kind kind;
    double A, F_0, h, h_A, c[7], w[2], f[3], unit;
    sf_law_terms of;
    int by_x, exist;
} sf_law_polynomial;

/* F or F_A/2 from R and I, in which nothing cancels but what cancels in them. */
static inline double sf_law_value(const sf_law_polynomial *q, double w) {
    const sf_law_terms *of = &q->of;
    double far[3];
    if (q->kind == SF_OF_FOLDS)
        return 0.5 * dissipation_F_A(w, q->A, of->rest[0], of->rest[1], of->zeta[0], of->zeta[1], of->d, of->d_3, q->h,
                                     q->h_A);
    if (!q->by_x)
        return dissipation_F(w, q->A, q->F_0, of->rest[0], of->zeta[0], of->d, of->d_3, q->h);
    dissipation_far_by_inertia(w, q->A, q->F_0, of->rest[0], of->zeta[0], of->d, q->h, far);
    return far[0];
}

/* Its derivative by w, and that one's. */
static inline double sf_polynomial_slope(const double c[7], double w) {
    return c[1] + w * (2 * c[2] + w * (3 * c[3] + w * (4 * c[4] + w * (5 * c[5] + w * (6 * c[6])))));
}
static inline double sf_polynomial_bend(const double c[7], double w) {
    return 2 * c[2] + w * (6 * c[3] + w * (12 * c[4] + w * (20 * c[5] + w * (30 * c[6]))));
}

/* Both positive zeros of the derivative, which is convex: Newton's steps from outside do not pass them. Its least value
 * lies where the second derivative vanishes, which is convex too. */
static inline void sf_find_critical(sf_law_polynomial *q) {
    const double *c = q->c;
    double least = -2 * c[2] / (1.5 * c[3] + sqrt(2.25 * c[3] * c[3] - 6 * c[4] * c[2])) / 2;
    q->w[0] = q->w[1] = 0;
    for (int i = 0; i < SF_MOST_LAW_STEPS && c[2] < 0 && c[5] + c[6] > 0; i++) {
        const double last = least;
        least -= sf_polynomial_bend(c, least) /
                 (6 * c[3] + least * (24 * c[4] + least * (60 * c[5] + least * (120 * c[6]))));
        if (!(fabs(least - last) > 0x1p-51 * least))
            break;
    }
    q->exist = c[2] < 0 && sf_polynomial_slope(c, least) < 0;
    if (!q->exist)
        return;
    q->w[1] = sqrt(-c[2] / (2 * c[4]));
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < SF_MOST_LAW_STEPS; i++) {
            const double w = q->w[k];
            const double step = sf_polynomial_slope(c, w) / sf_polynomial_bend(c, w);
            if (!(fabs(step) < HUGE_VAL))
                break;
            q->w[k] = k == 0 ? fmin(fmax(w - step, 0), least) : fmax(w - step, least);
            if (fabs(q->w[k] - w) <= 0x1p-51 * w)
                break;
        }
    }
}

static inline void sf_make_law_polynomial(const sf_model *model, const sf_sample *at, sf_law_polynomial_kind kind,
                                          double F_0, int beyond, sf_law_polynomial *q) {
    sf_law_terms of = sf_law_terms_at(model, at->A, beyond);
    q->kind = kind, q->by_x = sf_inertial(model) && kind == SF_OF_RESPONSE;
    q->A = at->A, q->F_0 = F_0, q->h = at->h, q->h_A = at->h_A, q->unit = 1;
    if (q->by_x && fmax(q->A, F_0) < SF_TINY)
        q->A *= 0x1p600, q->F_0 *= 0x1p600, of.zeta[0] *= 0x1p-300, of.d *= 0x1p-600, q->unit = 0x1p300;
    q->of = of;
    if (kind == SF_OF_FOLDS)
        dissipation_fold_polynomial(q->A, of.rest[0], of.rest[1], of.zeta[0], of.zeta[1], of.d, of.d_3, q->h, q->h_A,
                                    q->c);
    else
        dissipation_response_polynomial(q->A, of.rest[0], of.zeta[0], of.d, of.d_3, q->h, q->c);
    for (int i = 0; q->by_x && i < 2; i++) {
        const double swapped = q->c[i];
        q->c[i] = q->c[4 - i], q->c[4 - i] = swapped;
    }
    sf_find_critical(q);
    q->f[0] = sf_law_value(q, 0);
    for (int i = 0; i < 2; i++)
        q->f[1 + i] = q->exist ? sf_law_value(q, q->w[i]) : NAN;
}

/* Where it vanishes without the powers 1, 3, 5 and 6, which only raise it: above the largest root, or below the one
 * between its critical points. */
static inline double sf_law_bound(const sf_law_polynomial *q, int above) {
    const double *c = q->c, root = sqrt(fmax(c[2] * c[2] - 4 * c[4] * q->f[0], 0));
    const double sum = c[2] > 0 ? -c[2] - root : root - c[2];
    return sqrt(fmax((c[2] > 0) == above ? 2 * q->f[0] / sum : sum / (2 * c[4]), 0));
}

/* The root between two ends, from a place in between, or their middle. */
static inline double sf_law_root(const sf_law_polynomial *q, double low, double high, double w, int falls) {
    for (int i = 0; i < SF_MOST_LAW_STEPS; i++) {
        if (!(w > low && w < high))
            w = 0.5 * (low + high);
        const double before = w, f = sf_law_value(q, w);
        if ((f < 0) != falls)
            low = w;
        else
            high = w;
        w -= f / sf_polynomial_slope(q->c, w);
        if (fabs(w - before) <= 0x1p-52 * before)
            break;
    }
    return w;
}

/* How many there are; negative where squares of the coefficients are beyond the range of doubles. */
static inline int sf_law_count(const sf_law_polynomial *q) {
    sf_place place[3];
    const double squares = q->c[2] * q->c[2] + fabs(q->c[4] * q->f[0]);
    return squares < HUGE_VAL ? sf_places(q->exist, q->f[0] < 0, q->f[1] > 0, q->f[2] < 0, place) : -1;
}

static inline double sf_law_Omega(const sf_law_polynomial *q, double w) { return q->by_x ? q->unit / w : w; }

/* Number `index` of `count` by rising Omega. */
static inline double sf_law_branch(const sf_law_polynomial *q, int count, int index) {
    const sf_place place = sf_place_of(q->exist, q->f[0], q->f[1], q->f[2], count, q->by_x ? count - 1 - index : index);
    const int lower = place == SF_BELOW || place == SF_RISING, highest = place == SF_ABOVE || place == SF_RISING;
    double w = place == SF_AT_0 ? 0 : q->w[place != SF_AT_W1];
    if (place <= SF_RISING) {
        const double start = sf_law_bound(q, highest), most = start * (1 + 0x1p-20) + 1e-300;
        w = sf_law_root(q, lower ? 0 : q->w[place == SF_ABOVE], highest ? most : q->w[place == SF_BETWEEN], start,
                        place == SF_BETWEEN);
    }
    return sf_law_Omega(q, w);
}

/* Every Omega at which the amplitude is a steady state at F_0, or on the fold locus, by its size; returns how many.
 * beyond: as in sf_law_terms_at */
static inline int sf_law_frequencies(const sf_model *model, const sf_sample *at, sf_law_polynomial_kind kind,
                                     double F_0, int beyond, double Omega[3]) {
    sf_law_polynomial q;
    sf_make_law_polynomial(model, at, kind, F_0, beyond, &q);
    const int n = sf_law_count(&q);
    for (int i = 0; i < n; i++)
        Omega[i] = sf_law_branch(&q, n, i);
    return n;
}

/* Every Omega > 0 at which the level of the amplitude is stationary, by its size; returns how many. */
static inline int sf_law_stationary(const sf_model *model, const sf_sample *at, double Omega[2]) {
    sf_law_polynomial q;
    int n = 0;
    sf_make_law_polynomial(model, at, SF_OF_RESPONSE, 0, sf_is_beyond(model, at->A), &q);
    for (int i = 0; q.exist && i < 2; i++) {
        const double w = q.w[q.by_x ? 1 - i : i];
        if (w > 0)
            Omega[n++] = sf_law_Omega(&q, w);
    }
    return n;
}

/* The amplitude of an excitation by inertia under which A is what the response tends to as Omega tends to inf. */
static inline double sf_full_level(const sf_model *model, const sf_sample *at) {
    const sf_law_terms of = sf_law_terms_below(model, at->A);
    double far[3];
    dissipation_far_by_inertia(0, at->A, 0, of.rest[0], of.zeta[0], of.d, at->h, far);
    return sqrt(far[0]);
}

/* As sf_least_forcing; infinite where an excitation by inertia only tends to it. */
static inline double sf_least_by_laws(const sf_model *model, const sf_sample *at, double *Omega) {
    double w[3], full = HUGE_VAL, least = HUGE_VAL;
    int n = sf_law_stationary(model, at, w);
    if (sf_inertial(model))
        full = sf_full_level(model, at);
    else
        w[n++] = 0;
    for (int i = 0; i < n; i++) {
        const double level = sf_law_level(model, at, w[i]);
        if (level < fmin(full, least))
            least = level, *Omega = w[i];
    }
    return least;
}

/* Whether doubles hold squares of coefficients of the polynomials up to an amplitude, and (d F_0)^2; and F_0^4. */
static inline int sf_laws_are_in_range(const sf_model *model, double F_0, double A_max) {
    sf_law_polynomial q;
    int bounded = F_0 >= SF_LEAST_F_0 && model->d * F_0 * (model->d * F_0) < HUGE_VAL;
    const sf_sample at = sf_sample_without_k_at(model, A_max);
    sf_make_law_polynomial(model, &at, SF_OF_RESPONSE, F_0, sf_is_beyond(model, A_max), &q);
    for (int i = 0; i < 7; i++)
        bounded = bounded && q.c[i] * q.c[i] < HUGE_VAL;
    return bounded;
}

/* ==== On a cell ================================================================================================== */

/* What dissipates, as intervals; beyond: on amplitudes beyond where friction ends */
typedef struct {
    sf_interval m, zeta, eta, d, d_3, zeta_2, u_cr;
    int beyond;
} sf_laws_within;

static inline void sf_hold_laws(const sf_model *model, int piece, sf_laws_within *out) {
    out->m = sfi_point(model->m), out->zeta = sfi_point(model->zeta);
    out->eta = sfi_point(model->eta), out->d = sfi_point(model->d);
    out->d_3 = sfi_point(model->d_3), out->zeta_2 = sfi_point(model->zeta_2);
    out->beyond = model->released && piece > 0;
    out->u_cr = sfi_point(out->beyond ? model->b[0] : 0);
}

/* I_0 and three derivatives; returns I_0 - A I_0A. */
static inline sf_interval sf_rest_within(const sf_laws_within *laws, sf_interval A, sf_interval rest[4]) {
    if (laws->beyond) {
        const sf_interval of = sfi_of(sfi_most(A.lo, laws->u_cr.lo), sfi_most(A.hi, laws->u_cr.lo));
        dissipation_intervals_released(of, laws->m, laws->eta, laws->u_cr, rest);
        return dissipation_intervals_released_intercept(of, laws->m, laws->u_cr);
    }
    dissipation_intervals_at_rest(A, laws->m, laws->eta, rest);
    return dissipation_intervals_rest_intercept(laws->m);
}

/* As sf_law_terms has it. */
static inline void sf_zeta_within(const sf_laws_within *laws, sf_interval A, sf_interval zeta[4]) {
    zeta[0] = laws->zeta, zeta[1] = zeta[2] = zeta[3] = sfi_point(0);
    if (laws->zeta_2.hi != 0)
        dissipation_intervals_viscous(A, laws->zeta, laws->zeta_2, zeta);
}
