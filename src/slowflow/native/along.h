/* What is asked along the amplitude: in goes one sample of the averaged force, or a cell of amplitudes, out come
 * functions of A whose zeros count, or what these functions and their slopes are on all of the cell.
 *
 * Everything that can change along a locus changes at a zero of a function that is explicit in A:
 *
 *   SF_STIFFNESS  h and h_A                      the static state and its fold at Omega = 0
 *   SF_FOLD_AT    F = F_A = 0                    R, I and so Omega from both, put into R = A Omega^2 + h
 *   SF_ISOLA      F_A = F_Omega = 0              Omega from both, put into F_Omega
 *   SF_CUSP       F_A = F_AA = 0                 F_AA is biquadratic in Omega: both roots in closed form, put into F_A
 *   SF_TURN       F_A = F_AOmega = 0             F_A at its two critical points in Omega
 *   SF_UNDAMPED   cusps for zeta = 0             h_AA = 0, or the locus touches the backbone R = 0
 *   SF_PEAK       F = F_Omega = 0                F at its two critical points in Omega
 *   SF_REST       F = Omega = 0                  h^2 + m^2 = F_0^2
 *   SF_STATE      F = 0 at a given Omega         a steady state
 *
 * For an excitation by inertia SF_ISOLA and SF_PEAK are asked where the level of an amplitude is least, which is known
 * in closed form, and SF_REST has no zeros.
 *
 * The functions are generated, for numbers and for intervals: derivations/along.py eliminates Omega.
 */
#ifndef SF_ALONG_H
#define SF_ALONG_H

#include "cells.h"
#include "inertia_intervals.h"
#include "inertial.h"
#include "slow_flow_intervals.h"
#include "slow_flow_mu0_intervals.h"
#include "slow_flow_zeta0_intervals.h"

typedef enum {
    SF_STIFFNESS,
    SF_FOLD_AT,
    SF_ISOLA,
    SF_CUSP,
    SF_TURN,
    SF_UNDAMPED,
    SF_PEAK,
    SF_REST,
    SF_STATE
} sf_question;

/* Up to two functions (channels) of A. exists: whether each is defined here; Omega: what its zero has for Omega; level:
 * of a cusp, its forcing */
typedef struct {
    int exists[2];
    double y[2], dy[2], Omega[2], level[2];
    double Omega_A[2]; /* dOmega/dA, where it is known; else 0 */
    int edge;          /* the sign where the channel ends, if it ends next to the sample; 0 where that is not known */
} sf_answer;

typedef enum { SF_NOWHERE, SF_PARTLY, SF_THROUGHOUT } sf_where;

/* One of these functions on a cell: where it is defined, what holds it and its slope there, and in a proof that slope's
 * slope, if it is known. edge: its sign at the end of where it is defined, if there is one such end in the cell and the
 * sign is known; else 0 */
typedef struct {
    sf_where where;
    sf_interval y, dy, ddy;
    int edge;
} sf_range;

/* What holds damping and forcing. least: of |k| at a fold, sqrt(F_0^2 - m^2) */
typedef struct {
    sf_interval m, zeta, F_0, least;
} sf_terms;

/* A question with what it needs. F_0: of SF_FOLD_AT, SF_PEAK, SF_REST, SF_STATE; Omega: of SF_STATE. most: of SF_CUSP,
 * where only the lowest minimum of the level is wanted, a forcing above which cusps may be left out: each minimum
 * found lowers it; NULL for all cusps. highest: of SF_PEAK and SF_REST, whether only the highest zero that is a top
 * (zeros.h) is wanted */
typedef struct {
    sf_question question;
    const sf_model *model;
    double F_0, Omega;
    double least;
    double *most;
    int highest;
    sf_terms terms; /* the same as m, zeta, F_0 and least */
} sf_asked;

static inline sf_asked sf_asked_of(sf_question question, const sf_model *model, double F_0) {
    sf_asked asked;
    asked.question = question, asked.model = model, asked.F_0 = F_0, asked.Omega = 0, asked.most = NULL,
    asked.highest = 0;
    asked.least = question == SF_FOLD_AT ? slow_flow_least_restoring(F_0, model->m) : 0;
    asked.terms.m = sfi_point(model->m), asked.terms.zeta = sfi_point(model->zeta);
    asked.terms.F_0 = sfi_point(F_0), asked.terms.least = sfi_point(asked.least);
    return asked;
}

/* ==== At a sample ================================================================================================= */

/* h over A at A = 0 */
static inline void sf_ask_stiffness(const sf_sample *at, sf_answer *out) {
    out->exists[0] = out->exists[1] = 1;
    out->y[0] = at->A > 0 ? at->h : at->h_A, out->dy[0] = at->h_A;
    out->y[1] = at->h_A, out->dy[1] = at->h_AA;
}

/* Omega where a fold at F_0 may be, from I or from R, y being what the two lack of agreeing: the one that rounding
 * moves less. I exceeds m by little if damping is weak, and |k| the least if Omega is low. */
static inline double sf_fold_Omega(const sf_asked *asked, const sf_sample *at, double Omega, double y) {
    const double lag = slow_flow_I(Omega, at->A, 0, asked->model->zeta),
                 square = slow_flow_fold_square(Omega, at->A, y);
    const double least = asked->least / at->k;
    const double of_I = (lag + asked->model->m) / (lag * (1 - least) * (1 + least));
    const double of_R = (2 * fabs(at->h) + at->A * square) / (at->A * square);
    return square > 0 && !(of_R >= of_I) ? sqrt(square) : Omega;
}

static inline void sf_ask_fold(const sf_asked *asked, const sf_sample *at, sf_answer *out) {
    const sf_model *model = asked->model;
    double fold[3], tangent[2];
    if (model->zeta > 0)
        out->edge = at->h_A > 0 ? 1 : -1; /* F_A has the sign of h_A where the channel ends */
    if (model->zeta == 0 ? !(at->h_A < 0) : !(fabs(at->k) >= asked->least))
        return;
    slow_flow_intercept(at->A, at->h, at->h_A, at->h_AA, tangent);
    if (model->zeta == 0) {
        slow_flow_zeta0_fold(asked->F_0, model->m, at->k, tangent[1], fold);
        out->Omega[0] = slow_flow_zeta0_undamped_Omega(at->h_A);
    } else {
        if (model->m == 0)
            slow_flow_mu0_fold(at->A, asked->F_0, 0, model->zeta, at->h, at->h_A, at->k, tangent[1], fold);
        else
            slow_flow_fold(at->A, asked->F_0, model->m, model->zeta, at->h, at->h_A, at->k, tangent[1], fold);
        out->Omega[0] = sf_fold_Omega(asked, at, fold[2], fold[0]);
    }
    out->exists[0] = !isnan(fold[0]); /* |k| may be the least but for the rounding of that */
    out->y[0] = fold[0], out->dy[0] = fold[1];
}

/* Omega at an isola point: Omega^2 = h_A, or, where h_A is small beside its terms, the root of F_Omega next to that,
 * which has no h_A in it. */
static inline double sf_isola_Omega(const sf_model *model, const sf_sample *at) {
    const double Omega = slow_flow_isola_Omega(at->h_A);
    double w[2];
    if (at->h_A * at->A < SF_SOFT * fabs(at->h) && sf_peak_roots(at->A, at->h, model->m, model->zeta, w) == 2 &&
        fabs(w[0] - Omega) < SF_BESIDE * Omega)
        return w[0];
    return Omega;
}

static inline void sf_ask_isola(const sf_model *model, const sf_sample *at, sf_answer *out) {
    double isola[2];
    if (!(at->h_A > 0))
        return;
    if (model->m == 0) /* without the factor Omega */
        slow_flow_mu0_isola(at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA, isola);
    else
        slow_flow_isola(at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA, isola);
    out->exists[0] = 1;
    out->Omega[0] = sf_isola_Omega(model, at);
    out->y[0] = isola[0], out->dy[0] = isola[1];
}

/* A root of x^2 + 2 a x + b: the larger or the smaller one, root^2 = a^2 - b. */
static inline double sf_quadratic_root(double a, double b, double root, int larger) {
    if (larger ? a > 0 : a < 0)
        return larger ? -b / (a + root) : b / (root - a);
    return larger ? root - a : -a - root;
}

/* Channel 0 is the larger root Omega^2 of F_AA. */
static inline void sf_ask_cusp(const sf_model *model, int open, const sf_sample *at, sf_answer *out) {
    double q[5];
    int i;
    slow_flow_cusps(at->A, model->zeta, at->h, at->h_A, at->h_AA, at->k, q);
    for (i = 0; i < 2 && q[4] >= 0; i++) {
        const double root = sqrt(q[4]), X = sf_quadratic_root(q[2], q[3], root, i == 0);
        const double T = sf_quadratic_root(q[0], q[1], root, i == 0);
        double R[2], cusp[4];
        int by_F_AA;
        if (!(X > 0 && open & 1 << i))
            continue;
        slow_flow_cusp_R(at->A, model->zeta, at->h_AA, at->k, X, T, R);
        by_F_AA = fabs(R[0]) < SF_CANCELLED * fabs(at->k); /* k + A T has lost digits */
        slow_flow_cusp(at->A, model->m, model->zeta, at->h_AA, at->h_AAA, at->k, X, T, R[by_F_AA],
                       i == 0 ? root : -root, cusp);
        out->exists[i] = 1;
        out->Omega[i] = sqrt(X);
        out->y[i] = cusp[0], out->dy[i] = cusp[2];
        out->level[i] = cusp[3];
        if (by_F_AA) { /* a rounding of A moves h_AA by much where that is steep, but no fold by F_A beside a cusp */
            double nearly[2], fold[2];
            slow_flow_cusp_balance(at->A, model->m, model->zeta, at->h, at->k, X, T, nearly);
            slow_flow_cusp_balance(at->A, model->m, model->zeta, at->h, at->k, nearly[0], T, fold);
            if (fold[0] > 0 && fold[1] > 0 &&
                fabs(slow_flow_R(sqrt(nearly[0]), at->A, at->h)) < SF_SOFT * fabs(at->h))
                out->Omega[i] = sqrt(fold[0]), out->level[i] = sqrt(fold[1]);
        }
    }
}

/* Critical values of a quartic. With q = 0 the lower one lies at Omega = 0 and belongs to other questions. */
static inline void sf_ask_critical(const sf_isolated *q, sf_answer *out) {
    out->exists[0] = q->exist && q->w1 > 0;
    out->exists[1] = q->exist;
    out->y[0] = q->f1, out->y[1] = q->f2;
    out->Omega[0] = q->w1, out->Omega[1] = q->w2;
}

static inline void sf_ask_turn(const sf_model *model, const sf_sample *at, sf_answer *out) {
    sf_isolated q;
    if (!(at->A > 0))
        return;
    sf_isolate_fold(&q, at->A, at->h, at->h_A, model->m, model->zeta);
    sf_ask_critical(&q, out);
    if (q.exist) {
        out->dy[0] = sf_half_F_AA(model, at, q.w1);
        out->dy[1] = sf_half_F_AA(model, at, q.w2);
    }
}

/* Channel 1 is the minimum over Omega; without friction it is the only one. */
static inline void sf_ask_peak(const sf_model *model, double F_0, int open, const sf_sample *at, sf_answer *out) {
    sf_quartic cubic;
    double w[2];
    int i, n;
    if (!(at->A > 0 && model->zeta > 0))
        return;
    n = sf_unpolished_peak_roots(&cubic, at->A, at->h, model->m, model->zeta, w);
    for (i = 0; i < n; i++) {
        const int channel = i + 2 - n;
        double peak[2];
        if (!(open & 1 << channel))
            continue;
        w[i] = sf_polish_cubic(&cubic, w[i]);
        slow_flow_peak(w[i], at->A, F_0, model->m, model->zeta, at->h_A, peak);
        out->exists[channel] = 1;
        out->Omega[channel] = w[i];
        out->Omega_A[channel] = slow_flow_peak_Omega_A(w[i], at->A, model->m, model->zeta, at->h_A);
        out->y[channel] = peak[0], out->dy[channel] = peak[1];
    }
}

/* h_AA over A and R over A^3/3 at A = 0 */
static inline void sf_ask_undamped(const sf_sample *at, sf_answer *out) {
    double factors[4];
    if (!(at->h_A < 0))
        return;
    slow_flow_zeta0_undamped(at->A, at->h, at->h_A, at->h_AA, at->h_AAA, factors);
    out->exists[0] = out->exists[1] = 1;
    out->y[0] = factors[0], out->dy[0] = factors[1];
    out->y[1] = factors[2], out->dy[1] = factors[3];
    if (at->A == 0)
        out->y[0] = at->h_AAA, out->y[1] = -at->h_AAA;
    out->Omega[0] = out->Omega[1] = slow_flow_zeta0_undamped_Omega(at->h_A);
}

/* h^2 + m^2 = F_0^2 has two smooth halves */
static inline void sf_ask_rest(const sf_model *model, double F_0, const sf_sample *at, sf_answer *out) {
    double halves[3];
    slow_flow_rest(F_0, model->m, at->h, at->h_A, halves);
    out->exists[0] = out->exists[1] = 1;
    out->y[0] = halves[0], out->y[1] = halves[1];
    out->dy[0] = out->dy[1] = halves[2];
}

static inline void sf_ask_state(const sf_asked *asked, const sf_sample *at, sf_answer *out) {
    const sf_model *model = asked->model;
    out->exists[0] = 1;
    out->Omega[0] = asked->Omega;
    out->y[0] = slow_flow_F(asked->Omega, at->A, asked->F_0, model->m, model->zeta, at->h);
    out->dy[0] = slow_flow_F_A(asked->Omega, at->A, model->m, model->zeta, at->h, at->h_A);
}

/* Both at x = 1/Omega where the level is least; the peak is the pair's that is the upper one. */
static inline void sf_ask_inertial(const sf_asked *asked, const sf_sample *at, sf_answer *out) {
    const sf_model *model = asked->model;
    const double x = sf_least_x(model, at);
    const int channel = asked->question == SF_PEAK;
    double found[2];
    if (asked->question == SF_REST || x == 0)
        return;
    if (asked->question == SF_PEAK)
        inertia_peak(x, at->A, asked->F_0, model->m, model->zeta, at->h, at->h_A, found);
    else
        inertia_isola(x, at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA, found);
    out->exists[channel] = 1;
    out->Omega[channel] = 1 / x;
    out->Omega_A[channel] = inertia_least_Omega_A(x, at->A, model->m, model->zeta, at->h, at->h_A);
    out->y[channel] = found[0], out->dy[channel] = found[1];
}

/* Whether a question is another one for an excitation by inertia. */
static inline int sf_is_of_inertia(const sf_asked *asked) {
    return sf_inertial(asked->model) &&
           (asked->question == SF_ISOLA || asked->question == SF_PEAK || asked->question == SF_REST);
}

/* open: which channels are wanted, 1 and 2; of SF_CUSP and SF_PEAK others are not asked */
static inline void sf_ask(const sf_asked *asked, int open, const sf_sample *at, sf_answer *out) {
    const sf_model *model = asked->model;
    memset(out, 0, sizeof *out);
    if (sf_is_of_inertia(asked)) {
        sf_ask_inertial(asked, at, out);
        return;
    }
    switch (asked->question) {
    case SF_STIFFNESS:
        sf_ask_stiffness(at, out);
        break;
    case SF_FOLD_AT:
        sf_ask_fold(asked, at, out);
        break;
    case SF_ISOLA:
        sf_ask_isola(model, at, out);
        break;
    case SF_CUSP:
        sf_ask_cusp(model, open, at, out);
        break;
    case SF_TURN:
        sf_ask_turn(model, at, out);
        break;
    case SF_UNDAMPED:
        sf_ask_undamped(at, out);
        break;
    case SF_PEAK:
        sf_ask_peak(model, asked->F_0, open, at, out);
        break;
    case SF_REST:
        sf_ask_rest(model, asked->F_0, at, out);
        break;
    case SF_STATE:
        sf_ask_state(asked, at, out);
        break;
    }
}

/* Whether the level has a minimum along the fold locus at a cusp or an isola point, from its second derivative. */
static inline int sf_is_minimum(const sf_model *model, sf_question question, const sf_sample *at, double w) {
    const double m = model->m, zeta = model->zeta;
    if (sf_inertial(model) && question == SF_ISOLA)
        return sf_half_F_AA(model, at, w) > 0 && inertia_hessian(w, at->A, m, zeta, at->h, at->h_A, at->h_AA) > 0;
    if (sf_inertial(model))
        return inertia_cusp_bend(w, at->A, m, zeta, at->h, at->h_A, at->h_AA, at->h_AAA) > 0;
    if (question == SF_ISOLA)
        return slow_flow_isola_bend(w, at->A, m, zeta, at->h, at->h_A, at->h_AA) > 0;
    return slow_flow_cusp_bend(w, at->A, m, zeta, at->h, at->h_A, at->h_AA, at->h_AAA) > 0;
}

/* The channels that a question has, 1 and 2. */
static inline int sf_channels(sf_question question) {
    return question == SF_ISOLA || question == SF_FOLD_AT || question == SF_STATE ? 1 : 3;
}

/* before a function in which all calls are inlined */
#if defined(__GNUC__)
#define SF_FLAT __attribute__((flatten))
#else
#define SF_FLAT
#endif

/* farther from a breakpoint than this, relatively, the gains' roundings are lost in those of kernels */
#define SF_NEXT_TO_BREAK 1.01

/* ==== On a cell =================================================================================================== */

static inline sf_where sf_where_positive(sf_interval x) {
    return x.lo > 0 ? SF_THROUGHOUT : x.hi <= 0 ? SF_NOWHERE : SF_PARTLY;
}

static inline void sf_range_simple(sf_interval y, sf_interval dy, sf_where where, sf_range *out) {
    out->where = where, out->y = y, out->dy = dy, out->edge = 0;
}

/* With viscous damping the channel ends at Omega = 0, where |k| is the least; F_A there has the sign of h_A. */
static inline void sf_range_fold(const sf_terms *terms, const sf_cell *cell, sf_range *out) {
    const sf_interval least = terms->least;
    sf_interval k = cell->k, fold[3];
    out->edge = 0;
    if (terms->zeta.hi == 0) {
        slow_flow_zeta0_intervals_fold(terms->F_0, terms->m, k, cell->k_A, fold);
        out->where = sf_where_positive(sfi_neg(cell->h_A)), out->y = fold[0], out->dy = fold[1];
        return;
    }
    if (k.hi < least.lo && k.lo > -least.lo) {
        out->where = SF_NOWHERE;
        return;
    }
    out->where = SF_PARTLY;
    if (!(k.hi < least.lo || k.lo > -least.lo)) { /* on both sides */
        out->y = out->dy = sfi_of(-HUGE_VAL, HUGE_VAL);
        return;
    }
    if (k.lo >= least.hi || k.hi <= -least.hi) {
        out->where = SF_THROUGHOUT;
    } else {
        k = k.hi >= least.lo ? sfi_of(sfi_most(k.lo, least.lo), k.hi) : sfi_of(k.lo, sfi_least(k.hi, -least.lo));
        if (sfi_has_sign(cell->k_A) && sfi_has_sign(cell->h_A))
            out->edge = cell->h_A.lo > 0 ? 1 : -1;
    }
    slow_flow_intervals_fold(cell->A, terms->F_0, terms->m, terms->zeta, cell->h, cell->h_A, k, cell->k_A, fold);
    out->y = fold[0], out->dy = fold[1];
}

static inline void sf_range_isola(const sf_terms *terms, const sf_cell *cell, sf_range *out) {
    sf_interval isola[2];
    out->where = sf_where_positive(cell->h_A);
    if (out->where == SF_NOWHERE)
        return;
    if (terms->m.hi == 0)
        slow_flow_mu0_intervals_isola(cell->A, terms->m, terms->zeta, cell->h, cell->h_A, cell->h_AA, isola);
    else
        slow_flow_intervals_isola(cell->A, terms->m, terms->zeta, cell->h, cell->h_A, cell->h_AA, isola);
    sf_range_simple(isola[0], isola[1], out->where, out);
}

/* The larger root of x^2 + 2 a x + b, b <= 0, for numbers taken exactly. */
static inline sf_interval sf_larger_root_at(double a, double b) {
    const sf_interval root = sfi_sqrt(sfi_sub(sfi_square(sfi_point(a)), sfi_point(b)));
    return a > 0 ? sfi_div(sfi_point(-b), sfi_add(sfi_point(a), root)) : sfi_sub(root, sfi_point(a));
}

/* The same on a cell, from both forms; as it falls with b, and for b <= 0 with a, corners hold it too. */
static inline sf_interval sf_larger_root_range(sf_interval a, sf_interval b, sf_interval root) {
    sf_interval x = sfi_sub(root, a);
    if (a.lo >= 0)
        x = sfi_both(x, sfi_neg(sfi_div(b, sfi_add(a, root))));
    if (b.lo <= 0)
        x.hi = sfi_least(x.hi, sf_larger_root_at(a.lo, b.lo).hi);
    if (b.hi <= 0)
        x.lo = sfi_most(x.lo, sf_larger_root_at(a.hi, b.hi).lo);
    return x;
}

static inline sf_interval sf_quadratic_root_range(sf_interval a, sf_interval b, sf_interval root, int larger) {
    return larger ? sf_larger_root_range(a, b, root) : sfi_neg(sf_larger_root_range(sfi_neg(a), b, root));
}

/* Of a cusp on a cell, nowhere at first: where its Omega^2 is real and positive, F_A/2 with its slope, the forcing, and
 * Omega^2. */
typedef struct {
    sf_where where;
    sf_interval y, dy, level, X;
} sf_cusp_range;

static inline sf_where sf_where_both(sf_interval discriminant, sf_interval X) {
    const sf_where where = sf_where_positive(X);
    return where == SF_THROUGHOUT && !(discriminant.lo > 0) ? SF_PARTLY : where;
}

static inline void sf_cusp_on(const sf_cell *cell, sf_interval m, sf_interval zeta, int larger, sf_cusp_range *out) {
    sf_interval q[5], root, X, T, R[2], cusp[4];
    slow_flow_intervals_cusps(cell->A, zeta, cell->h, cell->h_A, cell->h_AA, cell->k, q);
    if (q[4].hi < 0)
        return;
    root = sfi_sqrt(q[4]);
    X = sf_quadratic_root_range(q[2], q[3], root, larger);
    out->where = sf_where_both(q[4], X);
    if (out->where == SF_NOWHERE)
        return;
    X.lo = sfi_most(X.lo, 0);
    T = sf_quadratic_root_range(q[0], q[1], root, larger);
    slow_flow_intervals_cusp_R(cell->A, zeta, cell->h_AA, cell->k, X, T, R);
    slow_flow_intervals_cusp(cell->A, m, zeta, cell->h_AA, cell->h_AAA, cell->k, X, T, sfi_both(R[0], R[1]),
                             larger ? root : sfi_neg(root), cusp);
    out->y = sfi_both(cusp[0], cusp[1]), out->dy = cusp[2], out->level = cusp[3], out->X = X;
}

/* Whether a level may lie above what is still wanted. */
static inline int sf_is_limited(const sf_asked *asked) { return asked->most != NULL && *asked->most < HUGE_VAL; }

/* The same in numbers without scale; the larger Omega^2 has the larger t where h_AA > 0. What settles most cells comes
 * first. a, b: what is known at the ends, for the values of the cell, which few need */
static inline void sf_range_cusp_scaled(const sf_asked *asked, const sf_known *a, const sf_known *b, sf_cell *cell,
                                        sf_interval rho, sf_interval kappa, int open, sf_range out[2]) {
    const sf_interval m = asked->terms.m, zeta = asked->terms.zeta;
    const int limited = sf_is_limited(asked);
    sf_interval q[3], root;
    int i;
    slow_flow_intervals_cusps_scaled(cell->A, zeta, cell->h_A, cell->h_AA, kappa, q);
    if (q[2].hi < 0)
        return;
    root = sfi_sqrt(q[2]);
    for (i = 0; i < 2; i++) {
        const int larger_t = (i == 0) == (cell->h_AA.lo > 0);
        sf_interval X, t, y;
        sf_where where;
        if (!(open & 1 << i))
            continue;
        t = sf_quadratic_root_range(q[0], q[1], root, larger_t);
        X = slow_flow_intervals_cusp_X(cell->A, cell->h_A, cell->h_AA, t);
        if (!(X.lo > 0)) { /* near Omega = 0 that cancels */
            sf_interval by_X[5];
            sf_add_values(a, b, cell);
            slow_flow_intervals_cusps(cell->A, zeta, cell->h, cell->h_A, cell->h_AA, cell->k, by_X);
            X = sfi_both(X, sf_quadratic_root_range(by_X[2], by_X[3], sfi_sqrt(by_X[4]), i == 0));
        }
        where = sf_where_both(q[2], X);
        if (where == SF_NOWHERE)
            continue;
        X.lo = sfi_most(X.lo, 0);
        y = slow_flow_intervals_cusp_scaled(cell->A, m, zeta, cell->h_AA, kappa, X, t);
        if (sfi_has_sign(y) ||
            (limited &&
             slow_flow_intervals_cusp_scaled_level(cell->A, m, zeta, cell->h_AA, kappa, X, t).lo > *asked->most))
            continue;
        sf_range_simple(y,
                        slow_flow_intervals_cusp_scaled_slope(cell->A, m, zeta, cell->h_AA, kappa, rho, X, t,
                                                              larger_t ? root : sfi_neg(root)),
                        where, &out[i]);
    }
}

/* Whether two functions have one sign, or are 0. */
static inline int sf_are_alike(sf_interval x, sf_interval y) {
    return (x.lo >= 0 && y.lo >= 0) || (x.hi <= 0 && y.hi <= 0);
}

/* Whether F_A > 0 next to A = 0, where h_AA may be infinite, at all frequencies. With X = Omega^2 it is no less than
 * 2 A [(X + h/A) (X + h_A) + 4 zeta^2 X]. That is positive where no coefficient is negative, or where its discriminant
 * is, (h/A - h_A)^2 + 8 zeta^2 (h/A + h_A) + 16 zeta^4. Where h = 0 at A = 0, h/A is a slope of h. */
static inline int sf_is_free_of_folds(const sf_known *a, const sf_cell *cell, sf_interval zeta) {
    const sf_interval slope = cell->h_A, square = sfi_square(zeta), apart = sfi_square(sfi_sub(slope, slope));
    if (cell->A.lo > 0 || a->h.lo != 0 || a->h.hi != 0)
        return 0;
    if ((slope.lo >= 0 || slope.hi <= 0) && sfi_add(slope, sfi_times(2, square)).lo > 0)
        return 1;
    return sfi_add(apart, sfi_mul(sfi_times(16, square), sfi_add(slope, square))).hi < 0;
}

/* On the fold locus R has the sign of k: F_AA/2 = (dR/dA)^2 + h_AA R + 4 zeta^2 Omega^2 vanishes only if h_AA has the
 * other one. */
static inline void sf_range_cusp(const sf_asked *asked, const sf_known *a, const sf_known *b, sf_cell *cell, int open,
                                 sf_range out[2]) {
    sf_interval rho, kappa;
    int i;
    out[0].where = out[1].where = SF_NOWHERE;
    if (sf_scaled(cell, &rho, &kappa)) {
        if (!(kappa.lo >= 0))
            sf_range_cusp_scaled(asked, a, b, cell, rho, kappa, open, out);
        return;
    }
    sf_add_values(a, b, cell);
    if (sf_are_alike(cell->h_AA, cell->k) || sf_is_free_of_folds(a, cell, asked->terms.zeta))
        return;
    for (i = 0; i < 2; i++) {
        sf_cusp_range cusp = {SF_NOWHERE, {0, 0}, {0, 0}, {0, 0}, {0, 0}};
        if (!(open & 1 << i))
            continue;
        sf_cusp_on(cell, asked->terms.m, asked->terms.zeta, i == 0, &cusp);
        if (cusp.where != SF_NOWHERE && !sfi_has_sign(cusp.y) &&
            !(sf_is_limited(asked) && cusp.level.lo > *asked->most))
            sf_range_simple(cusp.y, cusp.dy, cusp.where, &out[i]);
    }
}

/* Next to A = 0 a function that vanishes there has the sign of its slope, if that has one. */
static inline void sf_range_stiffness(const sf_cell *cell, sf_range out[2]) {
    sf_range_simple(cell->A.lo > 0 ? cell->h : cell->h_A, cell->A.lo > 0 ? cell->h_A : cell->h_AA, SF_THROUGHOUT,
                    &out[0]);
    sf_range_simple(cell->h_A, cell->h_AA, SF_THROUGHOUT, &out[1]);
}

static inline void sf_range_undamped(const sf_cell *cell, sf_range out[2]) {
    const sf_where where = sf_where_positive(sfi_neg(cell->h_A));
    const sf_interval unknown = sfi_of(-HUGE_VAL, HUGE_VAL);
    sf_range_simple(cell->A.lo > 0 ? cell->h_AA : cell->h_AAA, cell->A.lo > 0 ? cell->h_AAA : unknown, where, &out[0]);
    sf_range_simple(cell->A.lo > 0 ? cell->k : sfi_neg(cell->h_AAA), cell->A.lo > 0 ? cell->k_A : unknown, where,
                    &out[1]);
}

/* Positive roots w1 < w2 of A w^3 + p w + q for q > 0: both exist where p is low enough. As A and p rise w1 rises and
 * w2 falls, so the corners of the box (A, p) hold them. */
typedef struct {
    sf_where where;
    sf_interval w1, w2;
} sf_critical_box;

static inline int sf_critical_at(double A, double p, double q, double *w1, double *w2) {
    sf_quartic s;
    s.A = A, s.p = p, s.p_low = 0, s.q = q, s.q_low = 0;
    return sf_critical_points(&s, w1, w2);
}

/* Next to A = 0, where p vanishes too, p is asked over A: that of the slopes of h. */
static inline void sf_critical_of(const sf_cell *cell, sf_interval p, double q, sf_critical_box *out) {
    const sf_interval A = cell->A;
    double low[2], high[2];
    out->where = SF_NOWHERE;
    out->w1 = out->w2 = sfi_point(0);
    if (A.lo == 0) {
        /* with friction there is none for small A */
        if (p.lo < 0 && sf_critical_at(A.hi, p.lo * (1 + SF_DOUBT) * A.hi, q, &low[0], &low[1])) {
            out->where = SF_PARTLY;
            out->w1 = out->w2 = sfi_of(0, sqrt(-p.lo) * (1 + SF_DOUBT));
        }
        return;
    }
    if (!sf_critical_at(A.lo, p.lo, q, &low[0], &low[1]))
        return;
    out->where = sf_critical_at(A.hi, p.hi, q, &high[0], &high[1]) ? SF_THROUGHOUT : SF_PARTLY;
    if (out->where == SF_PARTLY) /* they meet in between, or at 0 */
        high[0] = q > 0 ? low[1] : 0, high[1] = low[0];
    out->w1 = sfi_of(low[0] * (1 - SF_DOUBT), high[0] * (1 + SF_DOUBT));
    out->w2 = sfi_of(high[1] * (1 - SF_DOUBT), low[1] * (1 + SF_DOUBT));
}

static inline void sf_range_turn(const sf_model *model, const sf_cell *cell, int open, sf_range out[2]) {
    const sf_interval m = sfi_point(model->m), zeta = sfi_point(model->zeta);
    const sf_interval one = sfi_point(1);
    const int next_to_0 = cell->A.lo == 0;
    sf_interval quartic[4];
    sf_critical_box box;
    int i;
    slow_flow_intervals_fold_quartic(next_to_0 ? one : cell->A, m, zeta, next_to_0 ? cell->h_A : cell->h, cell->h_A,
                                     quartic);
    sf_critical_of(cell, sfi_of(0.5 * quartic[2].lo, 0.5 * quartic[2].hi), 0.25 * quartic[1].lo, &box);
    for (i = 0; i < 2; i++) {
        const sf_interval w = i == 0 ? box.w1 : box.w2;
        out[i].where = i == 0 && model->m == 0 ? SF_NOWHERE : box.where;
        if (out[i].where == SF_NOWHERE || !(open & 1 << i))
            continue;
        if (next_to_0) { /* F_A over A, where h/A is a slope of h */
            const sf_interval per_A = sfi_div(m, cell->A);
            sf_range_simple(slow_flow_intervals_F_A(w, one, per_A, zeta, cell->h_A, cell->h_A),
                            sfi_of(-HUGE_VAL, HUGE_VAL), box.where, &out[i]);
            continue;
        }
        sf_range_simple(slow_flow_intervals_F_A(w, cell->A, m, zeta, cell->h, cell->h_A),
                        slow_flow_intervals_F_AA(w, cell->A, m, zeta, cell->h, cell->h_A, cell->h_AA), box.where,
                        &out[i]);
        out[i].y.lo *= 0.5, out[i].y.hi *= 0.5, out[i].dy.lo *= 0.5, out[i].dy.hi *= 0.5;
    }
}

/* What F does not exceed at an extremum over Omega: R = -zeta I/Omega is not positive there, so that |R| <= |h| and
 * A Omega^2 <= |h|. Of small amplitudes this tells all, also where h/A has no bound. */
static inline double sf_most_of_peak(const sf_model *model, double F_0, const sf_cell *cell) {
    const double size = sfi_most(fabs(cell->h.lo), fabs(cell->h.hi));
    const double lag =
        slow_flow_I(sqrt(cell->A.hi * size), 1, model->m, model->zeta); /* A Omega = sqrt(A size) at most */
    return (size * size + lag * lag) * (1 + SF_DOUBT) - F_0 * F_0 * (1 - SF_DOUBT);
}

/* The critical values rise with A where Omega^2 > h_A, and fall where it is less. */
static inline void sf_range_peak(const sf_model *model, double F_0, const sf_cell *cell, int open, sf_range out[2]) {
    const sf_interval m = sfi_point(model->m), zeta = sfi_point(model->zeta);
    const sf_interval one = sfi_point(1);
    const int next_to_0 = cell->A.lo == 0;
    const double most = sf_most_of_peak(model, F_0, cell);
    sf_interval cubic[3], peak[2];
    sf_critical_box box;
    int i;
    slow_flow_intervals_peak_cubic(next_to_0 ? one : cell->A, m, zeta, next_to_0 ? cell->h_A : cell->h, cubic);
    sf_critical_of(cell, cubic[1], cubic[0].lo, &box);
    for (i = 0; i < 2; i++) {
        const sf_interval w = i == 0 ? box.w1 : box.w2;
        out[i].where = model->zeta == 0 || (i == 0 && model->m == 0) ? SF_NOWHERE : box.where;
        if (out[i].where == SF_NOWHERE || !(open & 1 << i))
            continue;
        slow_flow_intervals_peak(w, cell->A, sfi_point(F_0), m, zeta, cell->h_A, peak);
        peak[0].lo = peak[0].lo > -HUGE_VAL ? peak[0].lo : -HUGE_VAL;
        peak[0].hi = sfi_least(peak[0].hi, most);
        sf_range_simple(peak[0], peak[1], box.where, &out[i]);
    }
}

/* F at Omega = 0 */
static inline void sf_range_rest(const sf_model *model, double F_0, const sf_cell *cell, sf_range out[2]) {
    double halves[3];
    slow_flow_rest(F_0, model->m, 0, 0, halves); /* -c, c */
    sf_range_simple(sfi_add(cell->h, sfi_around(halves[0])), cell->h_A, SF_THROUGHOUT, &out[0]);
    sf_range_simple(sfi_add(cell->h, sfi_around(halves[1])), cell->h_A, SF_THROUGHOUT, &out[1]);
}

/* F by R and its tangent, F_A and F_AA. */
static inline void sf_range_state(const sf_terms *terms, sf_interval Omega, const sf_cell *cell, sf_range *out) {
    sf_interval R[2], state[3];
    slow_flow_intervals_state_R(Omega, cell->A, cell->h, cell->h_A, cell->k, R);
    slow_flow_intervals_state(Omega, cell->A, terms->F_0, terms->m, terms->zeta, cell->h_A, cell->h_AA,
                              sfi_both(R[0], R[1]), state);
    sf_range_simple(state[0], state[1], SF_THROUGHOUT, out);
    out->ddy = state[2];
}

/* Parameters are rounded, and with them what the force gains at a breakpoint: next to it that moves h_A, as the inverse
 * of the root there, by more than k, which has the gain itself. */
static inline void sf_doubt_gains(const sf_model *model, sf_cell *cell) {
    const double A[2] = {cell->A.lo, cell->A.hi}, size = SF_DOUBT * (A[1] + fabs(cell->h.lo));
    double doubt[2];
    int i, end;
    for (i = 0; i < model->breaks; i++) {
        const double b = model->b[i];
        if (!(A[0] >= b && A[0] <= SF_NEXT_TO_BREAK * b))
            continue;
        for (end = 0; end < 2; end++)
            doubt[end] = size / sqrt((A[end] - b) * (A[end] + b));
        cell->h_A.lo -= doubt[cell->h_AA.hi <= 0], cell->h_A.hi += doubt[cell->h_AA.lo >= 0];
    }
}

/* The same, F_A and F_AA only where what comes before them has no sign on the cell. Inlined, so that no call computes
 * what is not taken of it. */
SF_FLAT static inline void sf_range_state_in_turn(const sf_terms *terms, sf_interval Omega, const sf_cell *cell,
                                                  sf_range *out)
{
    const sf_interval F_0 = terms->F_0, m = terms->m, zeta = terms->zeta, A = cell->A, h_A = cell->h_A,
                      h_AA = cell->h_AA;
    sf_interval R[2], state[3];
    slow_flow_intervals_state_R(Omega, A, cell->h, h_A, cell->k, R);
    R[0] = sfi_both(R[0], R[1]);
    slow_flow_intervals_state(Omega, A, F_0, m, zeta, h_A, h_AA, R[0], state);
    sf_range_simple(state[0], sfi_of(-HUGE_VAL, HUGE_VAL), SF_THROUGHOUT, out);
    out->ddy = out->dy;
    if (sfi_has_sign(out->y))
        return;
    slow_flow_intervals_state(Omega, A, F_0, m, zeta, h_A, h_AA, R[0], state);
    out->dy = state[1];
    if (sfi_has_sign(out->dy))
        return;
    slow_flow_intervals_state(Omega, A, F_0, m, zeta, h_A, h_AA, R[0], state);
    out->ddy = state[2];
}

/* x rises with the first of its terms and falls with the others, so their corners hold it. No level of A is above A, so
 * that a peak exceeds F_0; and below the least amplitude that is looked at the force is its slope, where nothing
 * vanishes. */
static inline void sf_range_inertial(const sf_asked *asked, const sf_cell *cell, sf_range out[2]) {
    const sf_interval m = asked->terms.m, zeta = asked->terms.zeta;
    sf_range *own = &out[asked->question == SF_PEAK];
    sf_interval terms[3], x, found[2];
    out[0].where = out[1].where = SF_NOWHERE;
    if (asked->question == SF_REST || cell->A.hi <= SF_FIRST || (asked->question == SF_PEAK && cell->A.hi < asked->F_0))
        return;
    if (cell->A.lo == 0) {
        own->where = SF_PARTLY, own->y = own->dy = sfi_of(-HUGE_VAL, HUGE_VAL), own->edge = 0;
        return;
    }
    inertia_intervals_terms(cell->A, m, zeta, cell->h, terms);
    own->where = sf_where_positive(terms[0]);
    if (own->where == SF_NOWHERE)
        return;
    x.lo = terms[0].lo > 0 ? inertia_least(terms[0].lo, terms[1].hi, terms[2].hi) * (1 - SF_DOUBT) : 0;
    x.hi = inertia_least(terms[0].hi, terms[1].lo, terms[2].lo) * (1 + SF_DOUBT);
    if (asked->question == SF_PEAK)
        inertia_intervals_peak(x, cell->A, asked->terms.F_0, m, zeta, cell->h, cell->h_A, found);
    else
        inertia_intervals_isola(x, cell->A, m, zeta, cell->h, cell->h_A, cell->h_AA, found);
    sf_range_simple(found[0], found[1], own->where, own);
}

/* open: which channels are wanted; a, b: what is known at the ends of the cell, of which only the slopes are made */
static inline void sf_find_range(const sf_asked *asked, const sf_known *a, const sf_known *b, sf_cell *cell, int open,
                                 sf_range out[2]) {
    const sf_model *model = asked->model;
    if (asked->question == SF_CUSP) {
        sf_range_cusp(asked, a, b, cell, open, out);
        return;
    }
    sf_add_values(a, b, cell);
    if (sf_is_of_inertia(asked)) {
        sf_range_inertial(asked, cell, out);
        return;
    }
    switch (asked->question) {
    case SF_STIFFNESS:
        sf_range_stiffness(cell, out);
        break;
    case SF_FOLD_AT:
        sf_range_fold(&asked->terms, cell, out);
        break;
    case SF_ISOLA:
        sf_range_isola(&asked->terms, cell, out);
        break;
    case SF_CUSP:
        break;
    case SF_TURN:
        sf_range_turn(model, cell, open, out);
        break;
    case SF_UNDAMPED:
        sf_range_undamped(cell, out);
        break;
    case SF_PEAK:
        sf_range_peak(model, asked->F_0, cell, open, out);
        break;
    case SF_REST:
        sf_range_rest(model, asked->F_0, cell, out);
        break;
    case SF_STATE:
        sf_doubt_gains(model, cell);
        sf_range_state_in_turn(&asked->terms, sfi_point(asked->Omega), cell, out);
        break;
    }
}

#endif
