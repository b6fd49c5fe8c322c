/* Test functions along the amplitude, on a cell. Takes a question of along.h and what is known at a cell's ends;
 * returns ranges that hold each function, and its slope, for every amplitude of the cell.
 */
#pragma once

#include "along.h"
#include "cells.h"
#include "inertia_intervals.h"
#include "slow_flow_intervals.h"

typedef enum { SF_NOWHERE, SF_PARTLY, SF_THROUGHOUT } sf_where;

/* One of these functions on a cell: where it is defined, what holds it and its slope there, and in a proof that slope's
 * slope, if it is known. edge: its sign at the end of where it is defined, if there is one such end in the cell and the
 * sign is known; else 0. once: of isola points, whether it has one zero at most, its slope apart */
typedef struct {
    sf_where where;
    sf_interval y, dy, ddy;
    int edge, once;
} sf_range;

/* farther from a breakpoint than this, relatively, the gains' roundings are lost in those of kernels */
#define SF_NEXT_TO_BREAK 1.01

static inline sf_where sf_where_positive(sf_interval x) {
    return x.lo > 0 ? SF_THROUGHOUT : x.hi <= 0 ? SF_NOWHERE : SF_PARTLY;
}

static inline void sf_range_simple(sf_interval y, sf_interval dy, sf_where where, sf_range *out) {
    out->where = where, out->y = y, out->dy = dy, out->edge = out->once = 0;
}

/* What rounding may make of a force on a cell, as sf_size_at of a sample. */
static inline double sf_rounding_on(const sf_cell *cell, double F_0) {
    const double h = fmax(fabs(cell->h.lo), fabs(cell->h.hi)), h_A = fmax(fabs(cell->h_A.lo), fabs(cell->h_A.hi));
    return SF_CLOSE * (F_0 + h + cell->A.hi * (1 + h_A));
}

/* With viscous damping the channel ends at Omega = 0, where |k| is the least; F_A there has the sign of h_A. If that
 * turns on the cell, a fold may lie so near to the end that it is rounding of the least, F_0^2 - m^2, that decides. */
static inline void sf_range_fold(const sf_terms *terms, const sf_cell *cell, sf_range *out) {
    const sf_interval least = terms->least;
    sf_interval k = cell->k, fold[3];
    out->edge = 0;
    if (terms->zeta.hi == 0) {
        slow_flow_intervals_fold_zeta0(terms->F_0, terms->m, k, cell->k_A, fold);
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
    if (out->where == SF_PARTLY && !sfi_has_sign(cell->h_A) && least.lo == least.hi) {
        const double rounding = sf_rounding_on(cell, terms->F_0.hi);
        out->y = sfi_add(out->y, sfi_of(-rounding, rounding));
    }
}

/* Whether a level may lie above what is still required. */
static inline int sf_is_limited(const sf_task *task) { return task->most != NULL && *task->most < HUGE_VAL; }

static inline sf_interval sf_level_on(const sf_terms *terms, sf_interval Omega, const sf_cell *cell) {
    return slow_flow_intervals_level(Omega, cell->A, terms->m, terms->zeta, cell->h);
}

static inline void sf_range_isola(const sf_task *task, const sf_cell *cell, sf_range *out) {
    const sf_terms *terms = &task->terms;
    sf_interval isola[2];
    out->where = sf_where_positive(cell->h_A);
    if (out->where != SF_NOWHERE && sf_is_limited(task) &&
        sf_level_on(terms, slow_flow_intervals_isola_Omega(cell->h_A), cell).lo > *task->most)
        out->where = SF_NOWHERE;
    if (out->where == SF_NOWHERE)
        return;
    if (terms->m.hi == 0)
        slow_flow_intervals_isola_mu0(cell->A, terms->zeta, cell->h, cell->h_A, cell->h_AA, isola);
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

/* Of a cusp on a cell, nowhere at first: where its Omega^2 is real and positive, F_A/2 with its slope, the forcing,
 * Omega^2 and T = dR/dA. */
typedef struct {
    sf_where where;
    sf_interval y, dy, level, X, T;
} sf_cusp_range;

static inline sf_where sf_where_both(sf_interval discriminant, sf_interval X) {
    const sf_where where = sf_where_positive(X);
    return where == SF_THROUGHOUT && !(discriminant.lo > 0) ? SF_PARTLY : where;
}

static inline void sf_cusp_on(const sf_cell *cell, sf_interval m, sf_interval zeta, int larger, sf_cusp_range *out) {
    sf_interval q[5], R[2], cusp[4];
    slow_flow_intervals_cusps(cell->A, zeta, cell->h, cell->h_A, cell->h_AA, cell->k, q);
    if (q[4].hi < 0)
        return;
    const sf_interval root = sfi_sqrt(q[4]);
    sf_interval X = sf_quadratic_root_range(q[2], q[3], root, larger);
    out->where = sf_where_both(q[4], X);
    if (out->where == SF_NOWHERE)
        return;
    X.lo = sfi_most(X.lo, 0);
    const sf_interval T = sf_quadratic_root_range(q[0], q[1], root, larger);
    slow_flow_intervals_cusp_R(cell->A, zeta, cell->h_AA, cell->k, X, T, R);
    slow_flow_intervals_cusp(cell->A, m, zeta, cell->h_AA, cell->h_AAA, cell->k, X, T, sfi_both(R[0], R[1]),
                             larger ? root : sfi_neg(root), cusp);
    out->y = sfi_both(cusp[0], cusp[1]), out->dy = cusp[2], out->level = cusp[3], out->X = X, out->T = T;
}

/* Whether two functions have one sign, or are 0. */
static inline int sf_are_alike(sf_interval x, sf_interval y) {
    return (x.lo >= 0 && y.lo >= 0) || (x.hi <= 0 && y.hi <= 0);
}

/* Whether F_A > 0 at all frequencies, which is known also where h_AA is infinite: where without friction no coefficient
 * of it is negative, or where its discriminant is. Next to A = 0, where h = 0 there, h/A is a slope of h. */
static inline int sf_is_free_of_folds(const sf_known *a, const sf_cell *cell, sf_interval zeta) {
    const sf_interval slope = cell->h_A;
    const int inside = cell->A.lo > 0;
    const sf_interval over_A = inside ? sfi_div(cell->h, cell->A) : slope;
    const sf_interval apart = inside ? sfi_div(cell->k, cell->A) : sfi_sub(slope, slope);
    sf_interval least[2];
    if (!inside && (a->h.lo != 0 || a->h.hi != 0))
        return 0;
    slow_flow_intervals_fold_least(zeta, slope, over_A, apart, least);
    return (sf_are_alike(over_A, slope) && least[0].lo > 0) || least[1].hi < 0;
}

/* On the fold locus R has the sign of k: F_AA/2 = (dR/dA)^2 + h_AA R + 4 zeta^2 Omega^2 vanishes only if h_AA has the
 * other one. */
static inline void sf_range_cusp(const sf_task *task, const sf_known *a, const sf_cell *cell, int open,
                                 sf_range out[2]) {
    out[0].where = out[1].where = SF_NOWHERE;
    if (sf_are_alike(cell->h_AA, cell->k) || sf_is_free_of_folds(a, cell, task->terms.zeta))
        return;
    for (int i = 0; i < 2; i++) {
        sf_cusp_range cusp = {0};
        if (!(open & 1 << i))
            continue;
        sf_cusp_on(cell, task->terms.m, task->terms.zeta, i == 0, &cusp);
        if (cusp.where != SF_NOWHERE && !(sf_is_limited(task) && cusp.level.lo > *task->most))
            sf_range_simple(cusp.y, cusp.dy, cusp.where, &out[i]);
    }
}

/* Next to A = 0 a function that vanishes there has the sign of its slope, if that has one. Where h is constant, as
 * under a preload alone, F_A vanishes at Omega = 0 throughout: nothing ends there. */
static inline void sf_range_stiffness(const sf_cell *cell, sf_range out[2]) {
    const int flat = cell->h_A.lo == 0 && cell->h_A.hi == 0, inside = cell->A.lo > 0 || flat;
    sf_range_simple(inside ? cell->h : cell->h_A, inside ? cell->h_A : cell->h_AA, SF_THROUGHOUT, &out[0]);
    sf_range_simple(cell->h_A, cell->h_AA, flat ? SF_NOWHERE : SF_THROUGHOUT, &out[1]);
}

static inline void sf_range_stiffness_by_laws(const sf_model *model, const sf_cell *cell, sf_range out[2]) {
    const sf_interval h_A = cell->h_A;
    sf_laws_within laws;
    sf_interval rest[4];
    sf_hold_laws(model, model->breaks > 0 && cell->A.lo >= model->b[0], &laws);
    sf_rest_within(&laws, cell->A, rest);
    const sf_interval slope = sfi_add(sfi_add(sfi_square(h_A), sfi_mul(cell->h, cell->h_AA)),
                                      sfi_add(sfi_square(rest[1]), sfi_mul(rest[0], rest[2])));
    sf_range_simple(sfi_times(2, sfi_add(sfi_mul(cell->h, h_A), sfi_mul(rest[0], rest[1]))), sfi_times(2, slope),
                    SF_THROUGHOUT, &out[0]);
    out[1].where = SF_NOWHERE;
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

/* Next to A = 0, where p vanishes too, p is taken over A: that of the slopes of h. */
static inline void sf_critical_of(const sf_cell *cell, sf_interval p, double q, sf_critical_box *out) {
    const sf_interval A = cell->A;
    double low[2], high[2];
    out->where = SF_NOWHERE;
    out->w1 = out->w2 = sfi_point(0);
    if (A.lo == 0) {
        /* with friction there is none for small A */
        if (p.lo < 0 && sf_critical_at(A.hi, p.lo * (1 + SF_ERROR) * A.hi, q, &low[0], &low[1])) {
            out->where = SF_PARTLY;
            out->w1 = out->w2 = sfi_of(0, sqrt(-p.lo) * (1 + SF_ERROR));
            out->w2.lo = sqrt(sfi_most(-p.hi, 0) / 3) * (1 - SF_ERROR); /* where the cubic's slope is 0 */
        }
        return;
    }
    if (!sf_critical_at(A.lo, p.lo, q, &low[0], &low[1]))
        return;
    out->where = sf_critical_at(A.hi, p.hi, q, &high[0], &high[1]) ? SF_THROUGHOUT : SF_PARTLY;
    if (out->where == SF_PARTLY) /* they meet in between, or at 0 */
        high[0] = q > 0 ? low[1] : 0, high[1] = low[0];
    out->w1 = sfi_of(low[0] * (1 - SF_ERROR), high[0] * (1 + SF_ERROR));
    out->w2 = sfi_of(high[1] * (1 - SF_ERROR), low[1] * (1 + SF_ERROR));
}

static inline void sf_range_turn(const sf_model *model, const sf_cell *cell, int open, sf_range out[2]) {
    const sf_interval m = sfi_point(model->m), zeta = sfi_point(model->zeta);
    const int next_to_0 = cell->A.lo == 0;
    const sf_interval A = next_to_0 ? sfi_point(1) : cell->A, h = next_to_0 ? cell->h_A : cell->h;
    const sf_interval per_A = next_to_0 ? sfi_div(m, cell->A) : m;
    sf_interval quartic[4], turn[2], y, dy;
    sf_critical_box box;
    slow_flow_intervals_fold_quartic(A, m, zeta, h, cell->h_A, quartic);
    sf_critical_of(cell, sfi_of(0.5 * quartic[2].lo, 0.5 * quartic[2].hi), 0.25 * quartic[1].lo, &box);
    for (int i = 0; i < 2; i++) {
        const sf_interval w = i == 0 ? box.w1 : box.w2;
        out[i].where = i == 0 && model->m == 0 ? SF_NOWHERE : box.where;
        if (out[i].where == SF_NOWHERE || !(open & 1 << i))
            continue;
        if (i == 0) { /* next to A = 0 over A, where h/A is a slope of h */
            y = sfi_times(0.5, slow_flow_intervals_F_A(w, A, per_A, zeta, h, cell->h_A));
            dy = sfi_times(0.5, slow_flow_intervals_F_AA(w, A, per_A, zeta, h, cell->h_A, cell->h_AA));
        } else { /* and k/A one of k */
            slow_flow_intervals_turn(w, A, per_A, zeta, cell->h_AA, next_to_0 ? cell->k_A : cell->k, turn);
            y = turn[0], dy = turn[1];
        }
        sf_range_simple(y, next_to_0 ? sfi_of(-HUGE_VAL, HUGE_VAL) : dy, box.where, &out[i]);
    }
}

/* What F does not exceed at an extremum over Omega: R = -zeta I/Omega is not positive there, so that |R| <= |h| and
 * A Omega^2 <= |h|. This suffices for small amplitudes, also where h/A has no bound. */
static inline double sf_most_of_peak(const sf_model *model, double F_0, const sf_cell *cell) {
    const double size = sfi_most(fabs(cell->h.lo), fabs(cell->h.hi));
    const double lag =
        slow_flow_I(sqrt(cell->A.hi * size), 1, model->m, model->zeta); /* A Omega = sqrt(A size) at most */
    return (size * size + lag * lag) * (1 + SF_ERROR) - F_0 * F_0 * (1 - SF_ERROR);
}

/* The critical values rise with A where Omega^2 > h_A, and fall where it is less. */
static inline void sf_range_peak(const sf_model *model, double F_0, const sf_cell *cell, int open, sf_range out[2]) {
    const sf_interval m = sfi_point(model->m), zeta = sfi_point(model->zeta);
    const sf_interval one = sfi_point(1);
    const int next_to_0 = cell->A.lo == 0;
    const double most = sf_most_of_peak(model, F_0, cell);
    sf_interval cubic[3], peak[2];
    sf_critical_box box;
    slow_flow_intervals_peak_cubic(next_to_0 ? one : cell->A, m, zeta, next_to_0 ? cell->h_A : cell->h, cubic);
    sf_critical_of(cell, cubic[1], cubic[0].lo, &box);
    for (int i = 0; i < 2; i++) {
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
static inline void sf_range_rest_by_laws(const sf_model *model, double F_0, const sf_cell *cell, sf_range out[2]) {
    sf_laws_within laws;
    sf_interval halves[4], rest[4];
    sf_hold_laws(model, model->breaks > 0 && cell->A.lo >= model->b[0], &laws);
    sf_rest_within(&laws, cell->A, rest);
    if (cell->h.lo == 0 && cell->h.hi == 0 && cell->h_A.lo == 0 && cell->h_A.hi == 0) {
        sf_range_simple(sfi_sub(rest[0], sfi_point(F_0)), rest[1], SF_THROUGHOUT, &out[0]);
        sf_range_simple(sfi_point(1), sfi_point(0), SF_NOWHERE, &out[1]);
        return;
    }
    const sf_where where = sf_where_positive(sfi_sub(sfi_point(F_0), rest[0]));
    rest[0].hi = sfi_least(rest[0].hi, F_0);
    dissipation_intervals_static(sfi_point(F_0), rest[0], rest[1], cell->h, cell->h_A, halves);
    for (int i = 0; i < 2; i++) {
        sf_range_simple(halves[i], halves[2 + i], where, &out[i]);
        if (where == SF_PARTLY && sfi_has_sign(cell->h))
            out[i].edge = cell->h.lo > 0 ? 1 : -1;
    }
}

static inline void sf_range_rest(const sf_model *model, double F_0, const sf_cell *cell, sf_range out[2]) {
    double halves[3];
    if (model->by_laws) {
        sf_range_rest_by_laws(model, F_0, cell, out);
        return;
    }
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

/* Parameters are rounded, and with them what the force gains at a breakpoint: next to it that changes h_A, as the
 * inverse of the root there, by more than k, which has the gain itself. */
static inline void sf_widen_gains(const sf_model *model, sf_cell *cell) {
    const double A[2] = {cell->A.lo, cell->A.hi}, size = SF_ERROR * (A[1] + fabs(cell->h.lo));
    double error[2];
    for (int i = 0; i < model->breaks; i++) {
        const double b = model->b[i];
        if (!(A[0] >= b && A[0] <= SF_NEXT_TO_BREAK * b))
            continue;
        for (int end = 0; end < 2; end++)
            error[end] = size / sqrt((A[end] - b) * (A[end] + b));
        cell->h_A.lo -= error[cell->h_AA.hi <= 0], cell->h_A.hi += error[cell->h_AA.lo >= 0];
    }
}

/* The same, F_A and F_AA only where what comes before them has no sign on the cell. Inlined, so that no call computes
 * what is not taken of it. */
SF_FLAT static inline void sf_range_state_in_turn(const sf_terms *terms, sf_interval Omega, const sf_cell *cell,
                                                  sf_range *out) {
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

/* 3 h - A h_A, which is 2 h + k, on a cell; also from where its piece begins: far out, where h is like A^3, it is a
 * small difference of large terms there, and its second derivative h_AA - A h_AAA is small on all of the way. */
static inline sf_interval sf_cubic_on(const sf_task *task, const sf_cell *cell) {
    const sf_interval direct = sfi_add(sfi_times(2, cell->h), cell->k);
    const sf_sample *first = task->first;
    sf_known from;
    if (task->model->mechanism->bent != NULL || first == NULL)
        return direct;
    sf_know(first, &from);
    const sf_interval way = sfi_sub(cell->A, sfi_point(first->A));
    sf_interval bend = sfi_of(sfi_least(first->h_AAA, cell->h_AAA.lo), sfi_most(first->h_AAA, cell->h_AAA.hi));
    const sf_interval slope = sfi_sub(sfi_times(2, from.h_A), sfi_times(first->A, from.h_AA));
    bend = sfi_add(sfi_sub(from.h_AA, sfi_times(first->A, bend)), sfi_mul(way, sfi_sub(bend, bend)));
    const sf_interval cubic = sfi_add(sfi_add(sfi_times(2, from.h), from.k),
                                      sfi_mul(way, sfi_add(slope, sfi_times(0.5, sfi_mul(way, bend)))));
    return cubic.hi - cubic.lo < HUGE_VAL ? sfi_both(direct, cubic) : direct;
}

/* Whether a cell has one isola point at most, as one next to a zero of h, which doubles may not separate from it:
 * where |h| is small against k and 3 h - A h_A, A F_A is zero there where zeta A^2 + m A x = cubic zeta A x^2 + k m
 * x^3, which one x is, and as h rises to where the least level ends, x falls to 0. */
static inline int sf_has_one_isola(sf_interval h, sf_interval h_A, sf_interval k, sf_interval cubic) {
    return sfi_has_sign(h_A) && -h.lo <= SF_SAME_ROOT * sfi_least(k.lo, cubic.lo);
}

/* x rises with the first of its terms and falls with the others, so their corners hold it. No level of A is above A, so
 * that a peak exceeds F_0; and below the least amplitude that is looked at the force is its slope, where nothing
 * vanishes. */
static inline void sf_range_inertial(const sf_task *task, const sf_cell *cell, sf_range out[2]) {
    const sf_interval m = task->terms.m, zeta = task->terms.zeta;
    sf_range *own = &out[task->question == SF_PEAK];
    sf_interval terms[3], x, h = cell->h, found[2];
    out[0].where = out[1].where = SF_NOWHERE;
    if (task->question == SF_REST || cell->A.hi <= SF_FIRST || (task->question == SF_PEAK && cell->A.hi < task->F_0))
        return;
    if (cell->A.lo == 0) {
        own->where = SF_PARTLY, own->y = own->dy = sfi_of(-HUGE_VAL, HUGE_VAL), own->edge = own->once = 0;
        return;
    }
    inertia_intervals_terms(cell->A, m, zeta, cell->h, terms);
    own->where = sf_where_positive(terms[0]);
    if (own->where == SF_NOWHERE)
        return;
    x.lo = terms[0].lo > 0 ? inertia_least(terms[0].lo, terms[1].hi, terms[2].hi) * (1 - SF_ERROR) : 0;
    x.hi = inertia_least(terms[0].hi, terms[1].lo, terms[2].lo) * (1 + SF_ERROR);
    if (task->question == SF_PEAK)
        inertia_intervals_peak(x, cell->A, task->terms.F_0, m, zeta, cell->h, cell->h_A, found);
    else
        inertia_intervals_isola(x, cell->A, m, zeta, cell->h, cell->h_A, cell->h_AA, found);
    sf_range_simple(found[0], found[1], own->where, own);
    if (task->question == SF_ISOLA && !sfi_has_sign(own->y)) {
        const sf_interval cubic = sf_cubic_on(task, cell);
        h.hi = sfi_least(h.hi, -2 * zeta.lo * zeta.lo * cell->A.lo * (1 - SF_ERROR)); /* where there is a least level */
        own->y = sfi_both(own->y, inertia_intervals_isola_apart(x, cell->A, m, zeta, h, cell->k, cubic));
        own->once = sf_has_one_isola(h, cell->h_A, cell->k, cubic);
    }
}

/* open: which channels are required; a: what is known where the cell begins */
static inline void sf_find_range(const sf_task *task, const sf_known *a, sf_cell *cell, int open, sf_range out[2]) {
    const sf_model *model = task->model;
    if (sf_is_of_inertia(task)) {
        sf_range_inertial(task, cell, out);
        return;
    }
    switch (task->question) {
    case SF_STIFFNESS:
        if (sf_has_sloping_rest(model, cell->A.lo))
            sf_range_stiffness_by_laws(model, cell, out);
        else
            sf_range_stiffness(cell, out);
        break;
    case SF_FOLD_AT:
        sf_range_fold(&task->terms, cell, out);
        break;
    case SF_ISOLA:
        sf_range_isola(task, cell, out);
        break;
    case SF_CUSP:
        sf_range_cusp(task, a, cell, open, out);
        break;
    case SF_TURN:
        sf_range_turn(model, cell, open, out);
        break;
    case SF_UNDAMPED:
        sf_range_undamped(cell, out);
        break;
    case SF_PEAK:
        sf_range_peak(model, task->F_0, cell, open, out);
        break;
    case SF_REST:
        sf_range_rest(model, task->F_0, cell, out);
        break;
    case SF_STATE:
        sf_widen_gains(model, cell);
        sf_range_state_in_turn(&task->terms, sfi_point(task->Omega), cell, out);
        break;
    }
}
