/* What the two functions of a search demand of R and of the frequency w on a cell of amplitudes. Takes the system, what
 * is known on the cell, and intervals of both; returns narrower ones, or that there is none. See points.h.
 */
#pragma once

#include "points_work.h"

/* rounds in which R and w narrow each other */
enum { SF_NARROWINGS = 2 };

/* What is known on a cell: over: h/A; rest: I_0 and derivatives; zeta: the damping ratio of a cycle and its
 * derivatives; level: I_0 - A I_0A */
typedef struct {
    sf_cell cell;
    sf_interval over, rest[4], zeta[4], level;
} sf_strip;

/* R and I, and their slopes along A at a frequency */
typedef struct {
    sf_interval R, R_A, I, I_A;
} sf_balances;

static inline sf_interval sf_all(void) { return sfi_of(-HUGE_VAL, HUGE_VAL); }
static inline int sf_is_none(sf_interval x) { return x.lo > x.hi; }
static inline sf_interval sf_with_0(sf_interval a) { return sfi_of(sfi_least(a.lo, 0), sfi_most(a.hi, 0)); }
static inline sf_interval sf_not_negative(sf_interval a) { return sfi_of(sfi_most(a.lo, 0), a.hi); }
static inline double sf_size_of(sf_interval a) { return sfi_most(fabs(a.lo), fabs(a.hi)); }

/* What q may be multiplied with to give p. */
static inline sf_interval sf_ratio(sf_interval p, sf_interval q) {
    return sfi_has_sign(p) || sfi_has_sign(q) ? sfi_div(p, q) : sf_all();
}

/* The same of what is not negative: of q counts what has the sign of p. */
static inline sf_interval sf_positive_ratio(sf_interval p, sf_interval q) {
    if (p.hi < 0)
        q.hi = sfi_least(q.hi, 0);
    if (p.lo > 0)
        q.lo = sfi_most(q.lo, 0);
    return sf_is_none(q) ? q : sf_ratio(p, q);
}

static void sf_node_at(const sf_law_search *search, double A, sf_node *out) {
    out->at = sf_sample_at(search->model, A);
    sf_know(&out->at, &out->known);
}

/* Between two places on a piece. */
static void sf_make_strip(const sf_law_search *search, const sf_node *a, const sf_node *b, sf_strip *out) {
    sf_cell *cell = &out->cell;
    sf_make_cell(search->model, &a->known, &b->known, cell);
    if (cell->A.lo > 0) {
        const sf_interval slope = sfi_neg(sfi_div(cell->k, sfi_square(cell->A)));
        const sf_interval low = sfi_div(a->known.h, sfi_point(a->at.A)), high = sfi_div(b->known.h, sfi_point(b->at.A));
        out->over = sfi_both(sfi_div(cell->h, cell->A), sf_along(low, high, slope, sfi_up(b->at.A - a->at.A)));
    } else {
        out->over = cell->h_A; /* h vanishes at A = 0 */
    }
    out->level = sf_rest_within(&search->laws, cell->A, out->rest);
    sf_zeta_within(&search->laws, cell->A, out->zeta);
}

static void sf_balances_at(const sf_law_search *search, const sf_strip *strip, sf_interval w, sf_balances *out) {
    const sf_cell *cell = &strip->cell;
    const sf_laws_within *laws = &search->laws;
    if (search->far) {
        sf_interval known[4];
        dissipation_intervals_far(w, cell->A, strip->rest[0], strip->rest[1], strip->zeta[0], strip->zeta[1], laws->d,
                                  cell->h, cell->h_A, known);
        out->R = known[0], out->R_A = known[1], out->I = known[2], out->I_A = known[3];
    } else {
        const sf_interval square = sfi_square(w);
        out->R = sfi_add(sfi_mul(cell->A, square), cell->h), out->R_A = sfi_add(square, cell->h_A);
        out->I = dissipation_intervals_I(w, cell->A, strip->rest[0], strip->zeta[0], laws->d, laws->d_3);
        out->I_A =
            dissipation_intervals_I_A(w, cell->A, strip->rest[1], strip->zeta[0], strip->zeta[1], laws->d, laws->d_3);
    }
}

/* w^2 by R, and R_A by it; where all is over Omega^2 and h may vanish R leaves w^2 unbounded. */
static sf_interval sf_square_of(const sf_law_search *search, const sf_strip *strip, sf_interval R) {
    const sf_cell *cell = &strip->cell;
    if (search->far)
        return sfi_both(sf_positive_ratio(sfi_sub(R, cell->A), cell->h),
                        sfi_sub(sf_ratio(R, cell->h), sfi_inverse(strip->over)));
    return sfi_sub(sfi_div(R, cell->A), strip->over);
}
static sf_interval sf_slope_of(const sf_law_search *search, const sf_strip *strip, sf_interval R) {
    const sf_cell *cell = &strip->cell;
    if (search->far)
        return sf_ratio(sfi_add(cell->k, sfi_mul(cell->h_A, R)), cell->h);
    return sfi_div(sfi_sub(R, cell->k), cell->A);
}

static inline int sf_is_forced(const sf_law_search *search) { return search->system <= SF_LAW_PEAKS; }
static inline int sf_is_folded(const sf_law_search *search) { return search->system != SF_LAW_PEAKS; }
static inline int sf_is_stationary(const sf_law_search *search) {
    return search->system == SF_LAW_PEAKS || search->system == SF_LAW_ISOLAS;
}

/* Damping takes no more than the force: I <= F_0. Over Omega^2 I has I_0 and d interchanged. */
static void sf_limit_by_damping(const sf_law_search *search, const sf_strip *strip, sf_interval *w) {
    const sf_laws_within *laws = &search->laws;
    const sf_interval A = strip->cell.A;
    sf_interval most = sf_all();
    if (!(search->F_0 < HUGE_VAL))
        return;
    if (search->far)
        most = dissipation_intervals_velocity(search->force, sfi_mul(laws->d, sfi_square(A)),
                                              sfi_mul(strip->zeta[0], A), strip->rest[0]);
    else if (A.lo > 0)
        most = sfi_div(dissipation_intervals_velocity(search->force, strip->rest[0], strip->zeta[0], laws->d), A);
    w->hi = sfi_least(w->hi, sfi_most(most.hi, 0));
}

/* And no less than R leaves: next to A = 0, where an excitation by inertia has R and F_0 Omega^2 to separate peaks from
 * what vanishes with A and 1/Omega. */
static void sf_limit_from_below(const sf_law_search *search, const sf_strip *strip, sf_interval R, sf_interval *w) {
    const sf_laws_within *laws = &search->laws;
    const sf_interval A = strip->cell.A, I = dissipation_intervals_R_of_response(search->force, R);
    const sf_interval least =
        dissipation_intervals_velocity(I, sfi_mul(laws->d, sfi_square(A)), sfi_mul(strip->zeta[0], A), strip->rest[0]);
    if (least.lo > w->lo)
        w->lo = least.lo;
}

/* R by its size, whose sign may be known. */
static sf_interval sf_of_size(sf_interval R, sf_interval size) {
    if (R.hi < size.lo && R.lo > -size.lo)
        return sfi_of(1, -1);
    return sfi_both(R, sfi_of(R.lo > -size.lo ? size.lo : -size.hi, R.hi < size.lo ? -size.lo : size.hi));
}

/* R where the level is stationary. */
static sf_interval sf_stationary_R(const sf_law_search *search, const sf_strip *strip, const sf_unknowns *of,
                                   sf_interval I) {
    const sf_laws_within *laws = &search->laws;
    const sf_interval A = strip->cell.A;
    sf_interval found[3];
    if (!search->far) /* by I, or as I may vanish with Omega by its parts */
        return sfi_both(
            sfi_both(of->R, dissipation_intervals_R_of_peak(of->w, A, strip->zeta[0], laws->d, laws->d_3, I)),
            dissipation_intervals_R_of_peak_by_rest(of->w, A, strip->rest[0], strip->zeta[0], laws->d, laws->d_3));
    dissipation_intervals_R_where_stationary(of->w, A, strip->rest[0], strip->zeta[0], laws->d, found);
    if (found[0].hi < 0)
        return sfi_of(1, -1);
    found[1] = sfi_both(of->R, found[1]), found[2] = sfi_both(of->R, found[2]);
    return sf_is_none(found[1]) ? found[2] : sf_is_none(found[2]) ? found[1] : sfi_join(found[1], found[2]);
}

/* Whether two factors may have a product of its sign. */
static int sf_may_be_product(sf_interval product, sf_interval one, sf_interval other) {
    if (product.lo > 0)
        return (one.hi > 0 && other.hi > 0) || (one.lo < 0 && other.lo < 0);
    if (product.hi < 0)
        return (one.hi > 0 && other.lo < 0) || (one.lo < 0 && other.hi > 0);
    return 1;
}

/* Narrows R and w to what the functions demand of them where both vanish; 0 where that is nothing. */
static int sf_narrow_unknowns(const sf_law_search *search, const sf_strip *strip, sf_unknowns *of) {
    const sf_cell *cell = &strip->cell;
    const sf_interval force = search->force;
    const int folded = sf_is_folded(search), forced = sf_is_forced(search), stationary = sf_is_stationary(search);
    /* where I I_A >= 0 R and its slope differ in sign: -h/A and -h_A enclose Omega^2, and R lies between 0 and k */
    const int apart = folded && strip->rest[1].lo >= 0;
    if (apart) {
        const sf_interval between = sfi_neg(sfi_join(strip->over, cell->h_A));
        if (!(between.hi > 0))
            return 0;
        of->w = sfi_both(of->w, sfi_sqrt(search->far ? sfi_inverse(sf_not_negative(between)) : between));
    }
    for (int pass = 0; pass < SF_NARROWINGS; pass++) {
        sf_balances at;
        sf_limit_by_damping(search, strip, &of->w);
        if (sf_is_none(of->w))
            return 0;
        sf_interval square = sfi_square(of->w);
        sf_balances_at(search, strip, of->w, &at);
        of->R = sfi_both(sfi_both(of->R, sfi_of(-force.hi, force.hi)), at.R);
        at.I = sfi_both(at.I, sfi_of(-HUGE_VAL, force.hi));
        if (sf_is_none(at.I))
            return 0;
        if (!forced && force.hi < HUGE_VAL) {
            const sf_interval most = dissipation_intervals_R_of_response(sfi_point(force.hi), at.I);
            of->R = sfi_both(of->R, sfi_of(-most.hi, most.hi));
        }
        if (stationary && forced) /* next to Omega = 0, where h vanishes too, this is the only bound */
            at.I = sfi_both(at.I, dissipation_intervals_R_of_response(force, of->R));
        if (sf_is_none(at.I))
            return 0;
        if (stationary)
            of->R = sf_stationary_R(search, strip, of, at.I);
        if (stationary && forced && search->far)
            sf_limit_from_below(search, strip, of->R, &of->w);
        if (sf_is_none(of->w))
            return 0;
        if (folded) {
            const sf_interval P = sfi_neg(sfi_mul(at.I, at.I_A)); /* R R_A */
            const sf_interval K = search->far ? sfi_mul(cell->k, square) : cell->k;
            /* R R_A is least where R is K/2 */
            if (!forced && sfi_add(sfi_times(0.25, sfi_square(K)), sfi_mul(cell->A, P)).hi < 0)
                return 0;
            if (apart) {
                of->R = sfi_both(of->R, sf_with_0(K));
                at.R_A = sfi_both(at.R_A, sf_with_0(sfi_neg(sfi_div(K, cell->A))));
            }
            of->R = sfi_both(of->R, sf_ratio(P, at.R_A));
            if (forced) {
                const sf_interval level =
                    search->far ? dissipation_intervals_sine_intercept_far(of->w, cell->A, strip->level, strip->zeta[1],
                                                                           search->laws.d)
                                : dissipation_intervals_sine_intercept(of->w, cell->A, strip->level, strip->zeta[1],
                                                                       search->laws.d, search->laws.d_3);
                /* k R + (I - A I_A) I = F_0^2 */
                of->R = sfi_both(of->R, sf_ratio(sfi_sub(sfi_square(force), sfi_mul(level, at.I)), K));
            }
            if (search->system == SF_LAW_CUSPS) {
                const sf_interval scale = search->far ? square : sfi_point(1);
                const sf_interval bend =
                    search->far ? dissipation_intervals_I_AA_far(of->w, cell->A, strip->rest[2], strip->zeta[1],
                                                                 strip->zeta[2], search->laws.d)
                                : dissipation_intervals_I_AA(of->w, cell->A, strip->rest[2], strip->zeta[1],
                                                             strip->zeta[2], search->laws.d, search->laws.d_3);
                const sf_interval rest = sfi_add(sfi_add(sfi_square(at.R_A), sfi_square(at.I_A)), sfi_mul(at.I, bend));
                /* next to a jump folds go to Omega = inf, where this is the only bound: no part of F_AA is negative */
                if (rest.lo >= 0 && ((of->R.lo > 0 && cell->h_AA.lo > 0) || (of->R.hi < 0 && cell->h_AA.hi < 0)))
                    return 0;
                of->R = sfi_both(of->R, sf_ratio(sfi_neg(rest), sfi_mul(cell->h_AA, scale)));
            }
            if (search->system == SF_LAW_TURNS) {
                const sf_laws_within *laws = &search->laws;
                const sf_interval x = sfi_inverse(of->w);
                sf_interval excess, both;
                if (laws->d_3.hi > 0) {
                    sf_interval of_x[4];
                    dissipation_intervals_turn_terms(x, cell->A, strip->rest[0], strip->rest[1], strip->zeta[0],
                                                     strip->zeta[1], laws->d, laws->d_3, cell->h, of_x);
                    excess = sfi_mul(of_x[1], sfi_square(square));
                    both = sfi_sub(sfi_mul(of_x[0], sfi_add(sfi_mul(sfi_square(x), of_x[0]), of_x[1])),
                                   sfi_mul(cell->A, sfi_mul(of_x[2], of_x[3])));
                } else {
                    sf_interval far[4];
                    const sf_interval ratio = dissipation_intervals_turn_share(
                        x, cell->A, strip->rest[0], strip->rest[1], strip->zeta[0], strip->zeta[1], laws->d);
                    excess = sfi_mul(ratio, square);
                    dissipation_intervals_far(x, cell->A, strip->rest[0], strip->rest[1], strip->zeta[0],
                                              strip->zeta[1], laws->d, cell->h, cell->h_A, far);
                    both = sfi_sub(sfi_mul(far[0], sfi_add(far[0], ratio)), sfi_mul(cell->A, sfi_mul(far[2], far[3])));
                }
                of->R = sfi_both(of->R, sfi_neg(sfi_add(sfi_mul(cell->A, at.R_A), excess)));
                at.R_A = sfi_both(at.R_A, sfi_neg(sfi_div(sfi_add(of->R, excess), cell->A)));
                if (sfi_has_sign(both)) /* both functions without h_A, over powers of Omega */
                    return 0;
            }
            at.R_A = sfi_both(at.R_A, sf_ratio(P, of->R));
            at.R_A = sfi_both(at.R_A, sf_slope_of(search, strip, of->R));
            /* 0 is no R where h_A is infinite at an end of the cell only */
            if (sf_is_none(at.R_A) || !sf_may_be_product(P, of->R, at.R_A))
                return 0;
        }
        if (sf_is_none(of->R))
            return 0;
        if (forced)
            of->R = sf_of_size(of->R, dissipation_intervals_R_of_response(force, at.I));
        if (folded)
            square = sfi_both(square, search->far ? sf_positive_ratio(sfi_sub(at.R_A, sfi_point(1)), cell->h_A)
                                                  : sfi_sub(at.R_A, cell->h_A));
        square = sf_not_negative(sfi_both(square, sf_square_of(search, strip, of->R)));
        if (sf_is_none(of->R) || sf_is_none(square))
            return 0;
        of->w = sfi_both(of->w, sfi_sqrt(square));
    }
    return !sf_is_none(of->w);
}
