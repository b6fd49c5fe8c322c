/* Test functions along the amplitude. Takes one sample of the averaged force; returns functions of A whose zeros
 * count.
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
 * For an excitation by inertia SF_ISOLA and SF_PEAK are evaluated where the level of an amplitude is least, which is
 * known in closed form, and SF_REST has no zeros.
 *
 * The functions are generated, for numbers and for intervals: derivations/systems/along.py eliminates Omega.
 */
#pragma once

#include "inertial.h"
#include "laws.h"

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

/* What holds damping and forcing. least: of |k| at a fold, sqrt(F_0^2 - m^2) */
typedef struct {
    sf_interval m, zeta, F_0, least;
} sf_terms;

/* A question with what it needs. F_0: of SF_FOLD_AT, SF_PEAK, SF_REST, SF_STATE; Omega: of SF_STATE. most: of
 * SF_CUSP and SF_ISOLA, where only the lowest minimum of the level is required, a forcing above which others may be
 * left out: each minimum found lowers it; NULL for all. first: where the piece begins that is searched. highest: of
 * SF_PEAK and SF_REST, whether only the highest zero that is a top (zeros.h) is required; pushes: whether the spring
 * pushes off at rest */
typedef struct {
    sf_question question;
    const sf_model *model;
    double F_0, Omega;
    double least;
    double *most;
    const sf_sample *first;
    int highest, pushes;
    sf_terms terms; /* the same as m, zeta, F_0 and least */
} sf_task;

static inline sf_task sf_task_of(sf_question question, const sf_model *model, double F_0) {
    sf_task task;
    task.question = question, task.model = model, task.F_0 = F_0, task.Omega = 0, task.most = NULL, task.first = NULL,
    task.highest = task.pushes = 0;
    task.least = question == SF_FOLD_AT ? slow_flow_least_restoring(F_0, model->m) : 0;
    task.terms.m = sfi_point(model->m), task.terms.zeta = sfi_point(model->zeta);
    task.terms.F_0 = sfi_point(F_0), task.terms.least = sfi_point(task.least);
    return task;
}

/* ==== At a sample ================================================================================================= */

/* Whether I_0 changes with A on the piece that begins at or below A, as by other laws of damping. */
static inline int sf_has_sloping_rest(const sf_model *model, double A) {
    return model->by_laws && (model->eta > 0 || (model->released != 0 && model->m > 0 && A >= model->b[0]));
}

/* h over A at A = 0; where I_0 changes with A, F_A at Omega = 0 */
static inline void sf_ask_stiffness(const sf_task *task, const sf_sample *at, sf_answer *out) {
    const sf_model *model = task->model;
    out->exists[0] = 1;
    if (sf_has_sloping_rest(model, task->first->A)) {
        const int beyond = model->breaks > 0 && task->first->A >= model->b[0];
        out->y[0] = sf_law_F_A(model, at, 0, beyond), out->dy[0] = sf_law_F_AA(model, at, 0, beyond);
        return;
    }
    out->exists[1] = 1;
    out->y[0] = at->A > 0 ? at->h : at->h_A, out->dy[0] = at->h_A;
    out->y[1] = at->h_A, out->dy[1] = at->h_AA;
}

/* Omega where a fold at F_0 may be, from I or from R, y being what the two lack of agreeing: the one that rounding
 * changes less. I exceeds m by little if damping is weak, and |k| the least if Omega is low. */
static inline double sf_fold_Omega(const sf_task *task, const sf_sample *at, double Omega, double y) {
    const double lag = slow_flow_I(Omega, at->A, 0, task->model->zeta), square = slow_flow_fold_square(Omega, at->A, y);
    const double least = task->least / at->k;
    const double of_I = (lag + task->model->m) / (lag * (1 - least) * (1 + least));
    const double of_R = (2 * fabs(at->h) + at->A * square) / (at->A * square);
    return square > 0 && !(of_R >= of_I) ? sqrt(square) : Omega;
}

static inline void sf_ask_fold(const sf_task *task, const sf_sample *at, sf_answer *out) {
    const sf_model *model = task->model;
    double fold[3], tangent[2];
    if (model->zeta > 0)
        out->edge = at->h_A > 0 ? 1 : -1; /* F_A has the sign of h_A where the channel ends */
    if (model->zeta == 0 ? !(at->h_A < 0) : !(fabs(at->k) >= task->least))
        return;
    slow_flow_intercept(at->A, at->h, at->h_A, at->h_AA, tangent);
    if (model->zeta == 0) {
        slow_flow_fold_zeta0(task->F_0, model->m, at->k, tangent[1], fold);
        out->Omega[0] = slow_flow_undamped_Omega(at->h_A);
    } else {
        if (model->m == 0)
            slow_flow_fold_mu0(at->A, task->F_0, model->zeta, at->h, at->h_A, at->k, tangent[1], fold);
        else
            slow_flow_fold(at->A, task->F_0, model->m, model->zeta, at->h, at->h_A, at->k, tangent[1], fold);
        out->Omega[0] = sf_fold_Omega(task, at, fold[2], fold[0]);
    }
    out->exists[0] = !isnan(fold[0]); /* |k| may be the least but for the rounding of that */
    out->y[0] = fold[0], out->dy[0] = fold[1];
}

/* Omega at an isola point: Omega^2 = h_A, or, where h_A is small against its terms, the root of F_Omega next to that,
 * which has no h_A in it; where h_A is as small as its rounding that is all that is left of Omega. */
static inline double sf_isola_Omega(const sf_model *model, const sf_sample *at) {
    const double h_A = fmax(at->h_A, 0), rounding = SF_CLOSE * (fabs(at->h) / at->A + fabs(at->h_A));
    double w[2];
    if (h_A * at->A < SF_SOFT * fabs(at->h) && sf_peak_roots(at->A, at->h, model->m, model->zeta, w) == 2 &&
        fabs(w[0] * w[0] - h_A) < 2 * SF_SAME_ROOT * h_A + rounding)
        return w[0];
    return slow_flow_isola_Omega(h_A);
}

static inline void sf_ask_isola(const sf_model *model, const sf_sample *at, sf_answer *out) {
    double isola[2];
    out->edge = model->m > 0 && model->zeta > 0; /* where the channel ends, at Omega = 0, F_Omega/(4 A) is m zeta */
    if (!(at->h_A > 0))
        return;
    if (model->m == 0) /* without the factor Omega */
        slow_flow_isola_mu0(at->A, model->zeta, at->h, at->h_A, at->h_AA, isola);
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

/* Next to Omega = 0 a rounding of A shifts the root X = Omega^2 of F_AA by more than X, but hardly the fold at A, whose
 * Omega is the root of F_A next to it. */
static inline void sf_take_fold_next_to(const sf_model *model, const sf_sample *at, int channel, sf_answer *out) {
    double w[3], nearest = HUGE_VAL;
    const double by_X = out->Omega[channel];
    const int n = sf_fold_roots(at->A, at->h, at->h_A, model->m, model->zeta, w);
    for (int i = 0; i < n; i++)
        if (fabs(w[i] - by_X) < nearest)
            nearest = fabs(w[i] - by_X), out->Omega[channel] = w[i];
    if (n > 0)
        out->level[channel] = slow_flow_level(out->Omega[channel], at->A, model->m, model->zeta, at->h);
}

/* Channel 0 is the larger root Omega^2 of F_AA. */
static inline void sf_ask_cusp(const sf_model *model, int open, const sf_sample *at, sf_answer *out) {
    double q[5];
    slow_flow_cusps(at->A, model->zeta, at->h, at->h_A, at->h_AA, at->k, q);
    if (fabs(q[3]) <= SF_CLOSE * q[2] * q[2]) /* a channel ends at Omega = 0, where F_A has the sign of h h_A */
        out->edge = at->h * at->h_A > 0 ? 1 : -1;
    for (int i = 0; i < 2 && q[4] >= 0; i++) {
        const double root = sqrt(q[4]), X = sf_quadratic_root(q[2], q[3], root, i == 0);
        const double T = sf_quadratic_root(q[0], q[1], root, i == 0);
        double R[2], cusp[4];
        if (!(X > 0 && open & 1 << i))
            continue;
        slow_flow_cusp_R(at->A, model->zeta, at->h_AA, at->k, X, T, R);
        const int by_F_AA = fabs(R[0]) < SF_CANCELLED * fabs(at->k); /* k + A T has lost digits */
        slow_flow_cusp(at->A, model->m, model->zeta, at->h_AA, at->h_AAA, at->k, X, T, R[by_F_AA],
                       i == 0 ? root : -root, cusp);
        out->exists[i] = 1;
        out->Omega[i] = sqrt(X);
        out->y[i] = cusp[0], out->dy[i] = cusp[2];
        out->level[i] = cusp[3];
        if (by_F_AA) { /* a rounding of A changes h_AA by much where that is steep, but no fold by F_A next to a cusp */
            double nearly[2], fold[2];
            slow_flow_cusp_balance(at->A, model->m, model->zeta, at->h, at->k, X, T, nearly);
            slow_flow_cusp_balance(at->A, model->m, model->zeta, at->h, at->k, nearly[0], T, fold);
            if (fold[0] > 0 && fold[1] > 0 && fabs(slow_flow_R(sqrt(nearly[0]), at->A, at->h)) < SF_SOFT * fabs(at->h))
                out->Omega[i] = sqrt(fold[0]), out->level[i] = sqrt(fold[1]);
        }
        if (X < SF_SOFT * fabs(q[2]))
            sf_take_fold_next_to(model, at, i, out);
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
    if (q.exist) { /* at the upper one F_A is all rounding of h if damping is weak */
        double turn[2];
        slow_flow_turn(q.w2, at->A, model->m, model->zeta, at->h_AA, at->k, turn);
        out->dy[0] = sf_half_F_AA(model, at, q.w1);
        out->y[1] = turn[0], out->dy[1] = turn[1];
    }
}

/* Channel 1 is the minimum over Omega; without friction it is the only one. */
static inline void sf_ask_peak(const sf_model *model, double F_0, int open, const sf_sample *at, sf_answer *out) {
    sf_quartic cubic;
    double w[2];
    if (!(at->A > 0 && model->zeta > 0))
        return;
    const int n = sf_unpolished_peak_roots(&cubic, at->A, at->h, model->m, model->zeta, w);
    for (int i = 0; i < n; i++) {
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
    slow_flow_undamped(at->A, at->h, at->h_A, at->h_AA, at->h_AAA, factors);
    out->exists[0] = out->exists[1] = 1;
    out->y[0] = factors[0], out->dy[0] = factors[1];
    out->y[1] = factors[2], out->dy[1] = factors[3];
    if (at->A == 0)
        out->y[0] = at->h_AAA, out->y[1] = -at->h_AAA;
    out->Omega[0] = out->Omega[1] = slow_flow_undamped_Omega(at->h_A);
}

/* h^2 + m^2 = F_0^2 has two smooth halves; by other laws of damping I_0 takes the place of m, and they end where it is
 * F_0: where nothing pulls the first is I_0 less F_0 */
static inline void sf_ask_rest(const sf_model *model, double F_0, const sf_sample *at, sf_answer *out) {
    double halves[4];
    if (model->by_laws) {
        const sf_law_terms of = sf_law_terms_below(model, at->A);
        if (at->h == 0 && at->h_A == 0) {
            out->exists[0] = 1, out->y[0] = of.rest[0] - F_0, out->dy[0] = of.rest[1];
            return;
        }
        dissipation_static(F_0, of.rest[0], of.rest[1], at->h, at->h_A, halves);
        out->edge = at->h > 0 ? 1 : at->h < 0 ? -1 : 0;
        out->exists[0] = out->exists[1] = !isnan(halves[0]);
    } else {
        slow_flow_rest(F_0, model->m, at->h, at->h_A, halves);
        halves[3] = halves[2];
        out->exists[0] = out->exists[1] = 1;
    }
    out->y[0] = halves[0], out->y[1] = halves[1];
    out->dy[0] = halves[2], out->dy[1] = halves[3];
}

static inline void sf_ask_state(const sf_task *task, const sf_sample *at, sf_answer *out) {
    const sf_model *model = task->model;
    out->exists[0] = 1;
    out->Omega[0] = task->Omega;
    out->y[0] = slow_flow_F(task->Omega, at->A, task->F_0, model->m, model->zeta, at->h);
    out->dy[0] = slow_flow_F_A(task->Omega, at->A, model->m, model->zeta, at->h, at->h_A);
}

/* Whether h lacks of being 0 what damping makes of it, so that x, where the level is least, is all rounding. */
static inline int sf_is_x_lost(const sf_model *model, const sf_sample *at) {
    double terms[3];
    inertia_terms(at->A, model->m, model->zeta, at->h, terms);
    return terms[0] <= SF_SOFT * at->A * (fabs(at->h) + at->A * fabs(at->h_A));
}

/* Omega at an isola point then: that on the fold locus at which h lacks the least of making the level stationary. */
static inline double sf_isola_Omega_by_inertia(const sf_model *model, const sf_sample *at) {
    double w[3], Omega = 0, least = HUGE_VAL;
    const int n = sf_fold_roots(at->A, at->h, at->h_A, model->m, model->zeta, w);
    for (int i = 0; i < n; i++) {
        const double lacks =
            fabs(inertia_level_slope(w[i], at->A, model->m, model->zeta, at->h) / slow_flow_R(w[i], at->A, at->h));
        if (w[i] > 0 && lacks < least)
            least = lacks, Omega = w[i];
    }
    return Omega;
}

/* Both at x = 1/Omega where the level is least; the peak is the pair's that is the upper one. */
static inline void sf_ask_inertial(const sf_task *task, const sf_sample *at, sf_answer *out) {
    const sf_model *model = task->model;
    const double x = sf_least_x(model, at);
    const int channel = task->question == SF_PEAK;
    double found[2], Omega = 0, part;
    if (model->zeta > 0) /* where a channel ends, as Omega tends to inf, F_A rises, and the level is the amplitude */
        out->edge = task->question == SF_ISOLA || at->A > task->F_0 ? 1 : -1;
    if (task->question == SF_REST || x == 0)
        return;
    if (task->question == SF_PEAK) {
        inertia_peak(x, at->A, task->F_0, model->m, model->zeta, at->h, at->h_A, found);
        if (sf_is_x_lost(model, at))
            Omega = sf_Omega_by_share(model, task->F_0, at, 0, &part);
    } else {
        inertia_isola(x, at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA, found);
        found[0] = inertia_isola_apart(x, at->A, model->m, model->zeta, at->h, at->k, 2 * at->h + at->k);
        if (sf_is_x_lost(model, at))
            Omega = sf_isola_Omega_by_inertia(model, at);
    }
    out->exists[channel] = 1;
    out->Omega[channel] = Omega > 0 ? Omega : 1 / x;
    if (Omega == 0)
        out->Omega_A[channel] = inertia_least_Omega_A(x, at->A, model->m, model->zeta, at->h, at->h_A);
    out->y[channel] = found[0], out->dy[channel] = found[1];
}

/* Whether a question is another one for an excitation by inertia. */
static inline int sf_is_of_inertia(const sf_task *task) {
    return sf_inertial(task->model) &&
           (task->question == SF_ISOLA || task->question == SF_PEAK || task->question == SF_REST);
}

/* open: which channels are needed, 1 and 2; of SF_CUSP and SF_PEAK others are not evaluated */
static inline void sf_ask(const sf_task *task, int open, const sf_sample *at, sf_answer *out) {
    const sf_model *model = task->model;
    memset(out, 0, sizeof *out);
    if (sf_is_of_inertia(task)) {
        sf_ask_inertial(task, at, out);
        return;
    }
    switch (task->question) {
    case SF_STIFFNESS:
        sf_ask_stiffness(task, at, out);
        break;
    case SF_FOLD_AT:
        sf_ask_fold(task, at, out);
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
        sf_ask_peak(model, task->F_0, open, at, out);
        break;
    case SF_REST:
        sf_ask_rest(model, task->F_0, at, out);
        break;
    case SF_STATE:
        sf_ask_state(task, at, out);
        break;
    }
}

/* T = dR/dA at a cusp, by its frequency. With R from F_AA = 0 F_A is T^3 + p T - q, whose root nothing cancels in; h_A
 * has few digits of it if damping is weak. */
static inline double sf_cusp_tangent(double w, double A, double m, double zeta, double h_AA) {
    const double q = 2 * zeta * w * slow_flow_I(w, A, m, zeta) * h_AA, size = cbrt(q);
    const double part = 2 * zeta * w / size, e = part * part;
    const double v = cbrt(0.5 + sqrt(0.25 + e * e * e / 27)), rest = e / (3 * v);
    return e < 1e30 ? size / (v * v + e / 3 + rest * rest) : size / e;
}

/* Whether F has a saddle in A and Omega at an isola point. */
static inline int sf_is_saddle(const sf_model *model, const sf_sample *at, double w) {
    if (sf_inertial(model))
        return inertia_hessian(w, at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA) < 0;
    return slow_flow_isola_hessian(w, at->A, model->m, model->zeta, at->h_AA) < 0;
}

/* Whether the level has a minimum along the fold locus at a cusp or an isola point, from its second derivative. */
static inline int sf_is_minimum(const sf_model *model, sf_question question, const sf_sample *at, double w) {
    const double m = model->m, zeta = model->zeta;
    if (sf_inertial(model) && question == SF_ISOLA)
        return sf_half_F_AA(model, at, w) > 0 && inertia_hessian(w, at->A, m, zeta, at->h, at->h_A, at->h_AA) > 0;
    if (sf_inertial(model))
        return inertia_cusp_bend(w, at->A, m, zeta, at->h, at->h_A, at->h_AA, at->h_AAA) > 0;
    if (question == SF_ISOLA)
        return slow_flow_isola_bend(w, at->A, m, zeta, at->h_AA) > 0;
    return slow_flow_cusp_bend(w, at->A, zeta, at->h_AA, at->h_AAA, sf_cusp_tangent(w, at->A, m, zeta, at->h_AA)) > 0;
}

/* By other laws of damping: whether the level has a minimum along the fold locus, and at an isola point F a saddle. */
static inline int sf_is_law_minimum(const sf_model *model, sf_question question, const sf_sample *at, double w,
                                    int *saddle) {
    const sf_law_terms of = sf_law_terms_below(model, at->A);
    const double A = at->A, *rest = of.rest, *zeta = of.zeta;
    double bend[2];
    *saddle = 0;
    if (question == SF_CUSP)
        return (sf_inertial(model) ? dissipation_cusp_bend_by_inertia : dissipation_cusp_bend)(
                   w, A, rest[0], rest[1], rest[2], rest[3], zeta[0], zeta[1], zeta[2], zeta[3], of.d, of.d_3, at->h,
                   at->h_A, at->h_AA, at->h_AAA) > 0;
    (sf_inertial(model) ? dissipation_isola_bend_by_inertia : dissipation_isola_bend)(
        w, A, rest[0], rest[1], rest[2], zeta[0], zeta[1], zeta[2], of.d, of.d_3, at->h, at->h_A, at->h_AA, bend);
    *saddle = bend[0] < 0;
    return bend[1] > 0;
}

/* The channels that a question has, 1 and 2. */
static inline int sf_channels(sf_question question) {
    return question == SF_ISOLA || question == SF_FOLD_AT || question == SF_STATE ? 1 : 3;
}
