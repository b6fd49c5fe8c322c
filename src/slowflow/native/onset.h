/* Critical forcings. Takes a model; returns detachment, the onset of folds, and the peak at a forcing.
 *
 * Cusps and isola points are explicit in A (along.h), so the onset needs no locus. The pieces of the force are
 * looked through from below; the last, which has no end, as far as a state at the best forcing found so far can lie.
 */
#pragma once

#include "law_peaks.h"

/* |u| at most in a motion of an amplitude. */
static double sf_largest_displacement(const sf_model *model, double A) {
    return A + fabs(model->mechanism->mean_offset(A, model->p));
}

static sf_status sf_detachment(const sf_model *model, double *F_cr, double *Omega_cr, double *u_cr) {
    *F_cr = *Omega_cr = *u_cr = NAN;
    if (model->breaks == 0)
        return SF_NONE;
    const sf_sample at = sf_sample_at(model, model->b[0]);
    *u_cr = sf_largest_displacement(model, at.A);
    *F_cr = sf_least_forcing(model, &at, Omega_cr);
    if (*F_cr < HUGE_VAL)
        return SF_OK;
    *F_cr = *Omega_cr = *u_cr = NAN;
    /* by inertia tended to as Omega tends to inf; of a force squares are beyond the range of doubles */
    return sf_inertial(model) ? SF_NONE : SF_NO_BOUND;
}

/* where a piece may be known to be left: at this share of its length, at the share of that, and so on */
enum { SF_MOST_LEAVING = 14 };
#define SF_LEAVING 0x1p-4
/* to either side of a frequency at which folds on a breakpoint may begin */
#define SF_NEAR_FOLDS 0x1p-30

static void sf_consider(double level, double Omega, double A, sf_onset_kind kind, sf_onset *best) {
    if (level < best->F_SN)
        best->F_SN = level, best->Omega = Omega, best->A = A, best->kind = kind;
}

/* An end of the fold locus at Omega = 0, from where the level rises along it unless there is no friction and F_Omega
 * falls below 0: then there are folds at every higher forcing, down to this one and without it. */
static void sf_consider_end(const sf_model *model, const sf_sample *at, double level, sf_onset *best) {
    if (model->m > 0 || sf_quarter_F_OmegaOmega(model, at, 0) >= 0)
        best->rest = fmin(best->rest, level);
}

/* Of a zero, what the level has there. */
static void sf_consider_zero(const sf_model *model, const sf_zero *zero, const sf_sample *at, sf_onset *best) {
    if (zero->question == SF_STIFFNESS && zero->channel == 0) /* h = 0 there, and so R: F_Omega does not fall */
        best->rest = fmin(best->rest, model->m);
    else if (zero->question == SF_STIFFNESS)
        sf_consider_end(model, at, sf_level(model, at, 0), best);
    else if (sf_is_minimum(model, zero->question, at, zero->Omega))
        sf_consider(sf_extremum_level(model, zero, at), zero->Omega, zero->A,
                    zero->question == SF_CUSP ? SF_CUSP_KIND : SF_ISOLA_KIND, best);
}

/* A piece without what lies next to the end of a play, where F_A is positive at any frequency: there both functions of
 * a system vanish together at Omega = 0, and boxes would be cut for ever. F_A/2 is R R_A >= -Omega^2 max(A |h_A|, |h|)
 * and I I_A, of which one part goes as Omega^2, too, and the others are positive. Unresolved where that part is 0, or
 * what it outweighs lies between two doubles, and where the level does not change with Omega. piece: its number */
static sf_status sf_leave_play(const sf_model *model, int piece, sf_stretch *of) {
    const sf_sample first = of->first;
    const double base = piece > 0 ? model->b[piece - 1] : 0;
    const int is_stationary = sf_inertial(model) && model->zeta + model->m == 0;
    double least[7], beyond = of->last.A - base;
    if (model->eta > 0)
        return SF_OK;
    if (is_stationary && (first.h > 0 || (piece == 0 && first.h_A > 0)))
        return SF_UNRESOLVED;
    if (!(piece > 0 && first.h == 0 && first.h_A == 0))
        return SF_OK;
    dissipation_fold_polynomial(base, model->m, 0, model->zeta, 0, model->d, model->d_3, 0, 0, least);
    if (!(least[2] > 0 && first.h_AA < 0) || (model->released && model->m > 0))
        return model->d > 0 && (is_stationary || !sf_inertial(model)) ? SF_UNRESOLVED : SF_OK;
    for (int i = 0; i < SF_MOST_LEAVING; i++, beyond *= SF_LEAVING) {
        sf_sample *at = &of->first;
        *at = sf_sample_at(model, base + beyond);
        /* h_AAA is monotone, of one sign at both ends: h_AA is negative between as there, and h_A and h fall from 0 */
        if (at->h_AA < 0 && !sf_opposite(at->h_AAA, first.h_AAA) && fmax(at->A * -at->h_A, -at->h) <= least[2] / 2)
            return SF_OK;
    }
    return SF_UNRESOLVED;
}

/* All points of a system on a piece at which the level is lower than the best so far; a least one that is none is no
 * lower than the one of its curve. */
static sf_status sf_consider_points(const sf_model *model, sf_law_system system, int piece, const sf_stretch *of,
                                    sf_law_search *search, sf_onset *best) {
    sf_begin_search(model, system, best->F_SN, search);
    sf_begin_piece(search, piece);
    sf_search_points(search, &of->first, &of->last);
    best->undecided |= search->found.undecided > 0;
    for (int i = 0; i < search->found.n; i++) {
        const sf_law_point *point = &search->found.at[i];
        sf_consider(sf_level_at_point(search, point), point->Omega, point->A,
                    system == SF_LAW_CUSPS ? SF_CUSP_KIND : SF_ISOLA_KIND, best);
    }
    return search->found.status;
}

/* Where the fold locus ends at Omega = 0: where h vanishes, and so R, I is what is left. */
static void sf_consider_end_by_laws(const sf_model *model, double A, sf_onset *best) {
    const sf_sample at = sf_sample_at(model, A);
    const sf_law_terms of = sf_law_terms_below(model, A);
    if (fabs(at.h) < fabs(A * at.h_A))
        best->rest = fmin(best->rest, of.rest[0]);
    else if (of.zeta[0] * of.rest[0] > 0 ||
             dissipation_F_OmegaOmega(0, A, of.rest[0], of.zeta[0], of.d, of.d_3, at.h) >= 0)
        best->rest = fmin(best->rest, sf_law_level(model, &at, 0));
}

/* As sf_consider_piece. Fewer levels are searched once the cusps are known. */
static sf_status sf_consider_piece_by_laws(const sf_model *model, const sf_stretch *piece, sf_work *work,
                                           sf_onset *best) {
    sf_stretch left = *piece;
    const int number = sf_piece_from(model, piece->first.A);
    sf_status status = sf_leave_play(model, number, &left);
    if (status != SF_OK)
        return status;
    if (!sf_inertial(model)) { /* at Omega = 0 the level is infinite */
        sf_clear_zeros(&work->zeros);
        sf_ask_all(model, SF_STIFFNESS, 0, &left, &work->zeros);
        best->undecided |= work->zeros.undecided;
        for (int i = 0; i < work->zeros.n; i++)
            sf_consider_end_by_laws(model, work->zeros.at[i].A, best);
        if (work->zeros.status != SF_OK)
            return work->zeros.status;
    }
    const int is_known = sf_consider_points(model, SF_LAW_ISOLAS, number, &left, &work->points, best) == SF_OK;
    status = sf_consider_points(model, SF_LAW_CUSPS, number, &left, &work->points, best);
    return is_known || status != SF_OK ? status
                                       : sf_consider_points(model, SF_LAW_ISOLAS, number, &left, &work->points, best);
}

/* Where the level may be least inside a piece: cusps, isola points, ends. Where h_A is negative on all of it, and so h
 * behind its beginning, nothing ends at Omega = 0 and there are no isola points; where h_AA and k have one sign, no
 * cusps (sf_range_cusp). */
static sf_status sf_consider_piece(const sf_model *model, const sf_stretch *piece, sf_work *work, sf_onset *best) {
    sf_zeros *zeros = &work->zeros;
    sf_task cusps = sf_task_of(SF_CUSP, model, 0);
    double most = best->F_SN;
    sf_known first, last;
    sf_cell cell;
    if (!sf_has_force(piece))
        return SF_OK;
    if (model->by_laws)
        return sf_consider_piece_by_laws(model, piece, work, best);
    sf_clear_zeros(zeros);
    sf_know(&piece->first, &first);
    sf_know(&piece->last, &last);
    sf_make_cell(model, &first, &last, &cell);
    if (sf_inertial(model)) { /* at Omega = 0 the level is infinite */
        sf_ask_all(model, SF_ISOLA, 0, piece, zeros);
    } else if (!(first.h.hi <= 0 && cell.h_A.hi < 0)) {
        sf_ask_all(model, SF_STIFFNESS, 0, piece, zeros);
        sf_ask_all(model, SF_ISOLA, 0, piece, zeros);
    }
    cusps.most = sf_inertial(model) ? NULL : &most; /* which is a force */
    if (!sf_are_alike(cell.h_AA, cell.k))
        sf_find_zeros(&cusps, piece, zeros);
    best->undecided |= zeros->undecided;
    for (int i = 0; i < zeros->n; i++) {
        const sf_sample at = sf_sample_at(model, zeros->at[i].A);
        sf_consider_zero(model, &zeros->at[i], &at, best);
    }
    return zeros->status;
}

/* Whether the level falls towards the point (b, w) of the fold locus along the piece below. */
static int sf_falls_from_below(const sf_model *model, const sf_sample *at, double w) {
    return slow_flow_level_rise(w, at->A, model->m, model->zeta, at->h, at->h_A, at->h_AA) < 0;
}

/* The same for an excitation by inertia: all that may bound the level of folds on the breakpoint, none of it lower than
 * they are; J = 0 where only the slope of the force jumps. Where they begin at R = 0 the level falls with Omega, by I
 * over Omega^2. */
static void sf_consider_inertial(const sf_model *model, const sf_sample *at, double J, sf_onset *best) {
    const double x = sf_least_x(model, at);
    double w[3];
    const int n = sf_fold_roots(at->A, at->h, at->h_A, model->m, model->zeta, w);
    for (int i = 0; i < n; i++)
        sf_consider(sf_level(model, at, w[i]), w[i], at->A, SF_CORNER_KIND, best);
    if (J != 0 && x > 0 && sf_half_F_A(model, at, 1 / x) * slow_flow_R(1 / x, at->A, at->h) * J < 0)
        sf_consider(sf_level(model, at, 1 / x), 1 / x, at->A, SF_CORNER_KIND, best);
}

/* The least forcing on a breakpoint where only the force's slope jumps: the locus goes on, but its level may turn, as
 * F_AA above is infinite, with the sign of `turn`. */
static void sf_consider_bend(const sf_model *model, const sf_sample *at, double turn, sf_onset *best) {
    double w[3];
    const int n = sf_fold_roots(at->A, at->h, at->h_A, model->m, model->zeta, w);
    for (int i = 0; i < n; i++) {
        const double R = slow_flow_R(w[i], at->A, at->h), F_Omega = sf_F_Omega(model, at, w[i]);
        if (sf_falls_from_below(model, at, w[i]) && F_Omega * sf_quarter_F_AOmega(model, at, w[i]) * R * turn < 0)
            sf_consider(sf_level(model, at, w[i]), w[i], at->A, SF_CORNER_KIND, best);
    }
}

/* The same where the force jumps by J. Folds sit on it where F_A has there the other sign than R J, which it has next
 * to it (sf_corner_folds): from where the locus below ends, and, for J < 0, from R = 0 on, where the locus above comes
 * in; both lead to a higher Omega and level. Between, the level may be stationary. */
static void sf_consider_jump(const sf_model *model, const sf_sample *at, double J, sf_onset *best) {
    double w[3];
    if (at->h < 0 && J < 0) {
        const double Omega = slow_flow_backbone(at->A, at->h);
        /* R is 0 there, and its rounding may exceed a weak damping's I */
        const double level = model->mechanism->dissipation(Omega, at->A, model->damping);
        sf_consider(level, Omega, at->A, SF_CORNER_KIND, best);
        if (at->k >= 0) /* h_A <= h/A < 0: up to Omega R and R_A are not positive, so F_A is; beyond, I is larger */
            return;
    }
    sf_consider_bend(model, at, J, best);
    const int n = sf_peak_roots(at->A, at->h, model->m, model->zeta, w);
    for (int i = 0; i < n; i++)
        if (sf_half_F_A(model, at, w[i]) * slow_flow_R(w[i], at->A, at->h) * J < 0 &&
            sf_quarter_F_OmegaOmega(model, at, w[i]) > 0)
            sf_consider(sf_level(model, at, w[i]), w[i], at->A, SF_CORNER_KIND, best);
    if (at->h_A * J < 0)
        sf_consider_end(model, at, sf_level(model, at, 0), best);
}

/* The same by other laws of damping. The locus below comes to the breakpoint where F_A vanishes; where the slope of the
 * force jumps its level may turn there. Folds sit on it where the sign of F_A changes across it: that begins and ends
 * where F_A vanishes on one side, or R where the force jumps; between, the level may be stationary. */
static void sf_consider_corner_by_laws(const sf_model *model, int k, const sf_sample *at, sf_onset *best) {
    const int beyond = sf_is_beyond(model, at->A);
    double w[9];
    int n = sf_law_frequencies(model, at, SF_OF_FOLDS, 0, beyond, w);
    for (int i = 0; i < n; i++)
        if (w[i] > 0)
            sf_consider(sf_law_level(model, at, w[i]), w[i], at->A, SF_CORNER_KIND, best);
    if (!sf_has_corner(model, k))
        return;
    n = sf_law_stationary(model, at, w);
    if (model->jump[k] == 0)
        n += sf_law_frequencies(model, at, SF_OF_FOLDS, 0, 1, w + n);
    else if (at->h < 0)
        w[n++] = slow_flow_backbone(at->A, at->h);
    for (int i = 0; i < n; i++) {
        int folds = 0;
        for (int side = -1; side <= 1; side += 2) {
            const double near = w[i] * (1 + side * SF_NEAR_FOLDS);
            folds |= (sf_law_F_A(model, at, near, beyond) > 0) != sf_is_stable_above(model, k, at, near);
        }
        if (w[i] > 0 && folds)
            sf_consider(sf_law_level(model, at, w[i]), w[i], at->A, SF_CORNER_KIND, best);
    }
}

/* Whether the force is as it is far away; not where it is still nearly its slope at rest, and bends farther on. */
static int sf_has_settled(const sf_model *model, const sf_sample *at) {
    const sf_sample far = sf_sample_at(model, SF_ENDLESS * at->A);
    return !(fabs(far.k) * fabs(at->h) > 2 * fabs(at->k) * fabs(far.h));
}

/* The last piece, which has no end: as far as a state at the best forcing can lie, or at forcings raised until there is
 * one; where the force levels off, up to the forcing beyond which no amplitude bounds the response. */
static sf_status sf_onset_in_last(const sf_model *model, const sf_sample *first, sf_work *work, sf_onset *best) {
    double F_0 = best->F_SN, A_max, looked_through = model->m, unbounded = HUGE_VAL;
    sf_status bounded = SF_OK;
    sf_stretch piece;
    piece.last = *first;
    if (!(F_0 < HUGE_VAL))
        F_0 = SF_RAISE * fmax(model->m, SF_FIRST_F_0);
    for (int i = 0; i < SF_RAISES + SF_FAR_RAISES; i++) {
        bounded = sf_range_by_spring(model, F_0, &A_max);
        if (bounded == SF_NO_BOUND && i < SF_RAISES && F_0 - looked_through > SF_NEAR_BOUND * looked_through) {
            unbounded = F_0, F_0 = 0.5 * (looked_through + F_0);
            continue;
        }
        if (bounded != SF_OK && bounded != SF_UNBOUNDED) {
            best->rest = F_0;
            return bounded;
        }
        if (A_max > piece.last.A) { /* what lies below has been looked through */
            piece.first = piece.last;
            piece.last = sf_sample_at(model, A_max);
            if (first->A == 0 && first->h == 0 && piece.last.h_AA == 0 && piece.last.h_AAA == 0 && first->h_AAA == 0)
                return SF_NONE; /* linear */
            const sf_status status = sf_consider_piece(model, &piece, work, best);
            if (status != SF_OK)
                return status;
        }
        if (bounded == SF_UNBOUNDED) /* where the response does not close folds of any amplitude may be lower */
            return best->F_SN < HUGE_VAL ? sf_range_by_spring(model, best->F_SN, &A_max) : bounded;
        if (best->F_SN <= F_0)
            return SF_OK;
        looked_through = F_0;
        if (i >= SF_RAISES - 1 && !(best->F_SN < HUGE_VAL) &&
            (A_max >= model->reach || sf_has_settled(model, &piece.last)))
            return SF_NONE;
        F_0 = best->F_SN < HUGE_VAL ? best->F_SN : (i < SF_RAISES ? SF_RAISE : SF_FAR_RAISE) * F_0;
        if (F_0 >= unbounded)
            F_0 = 0.5 * (looked_through + unbounded);
    }
    best->rest = unbounded;
    return unbounded < HUGE_VAL ? SF_NO_BOUND : SF_UNRESOLVED;
}

/* For zeta = 0, the sign of the level's slope along the folds, or, where that is 0, of the slope's own. */
static double sf_undamped_rises(double h_AA, double h_AAA, double k, int order) {
    double rises[2];
    slow_flow_undamped_rises(h_AA, h_AAA, k, rises);
    return rises[order];
}

/* For zeta = 0 folds lie at Omega^2 = -h_A and their level is that of R = k. This is where a forcing is
 * the least inside a piece, and whether k tends to 0 there, so that the level only tends to m. */
static int sf_undamped_in(const sf_model *model, const sf_stretch *piece, sf_zeros *zeros, sf_onset *best) {
    int tends = 0;
    sf_ask_all(model, SF_STIFFNESS, 0, piece, zeros);
    sf_ask_all(model, SF_UNDAMPED, 0, piece, zeros);
    for (int i = 0; i < zeros->n; i++) {
        const sf_zero *zero = &zeros->at[i];
        const sf_sample at = sf_sample_at(model, zero->A);
        if (zero->question == SF_UNDAMPED && zero->channel == 1)
            tends = 1;
        else if (zero->question == SF_UNDAMPED && sf_undamped_rises(at.h_AA, at.h_AAA, at.k, 1) > 0)
            sf_consider(slow_flow_undamped_level(model->m, at.k), zero->Omega, zero->A, SF_CUSP_KIND, best);
        else if (zero->question == SF_STIFFNESS && zero->channel == 1)
            best->rest = fmin(best->rest, sf_level(model, &at, 0));
    }
    return tends;
}

/* The same on a breakpoint. Where the force jumps by J folds sit on it at Omega^2 > -h_A, if J < 0, or below. */
static int sf_undamped_on(const sf_model *model, const sf_sample *at, const sf_sample *above, double J,
                          sf_onset *best) {
    const int falls_off = at->h_A < 0, falls = falls_off && sf_undamped_rises(at->h_AA, at->h_AAA, at->k, 0) < 0;
    const double at_rest = sf_level(model, at, 0);
    int turns;
    if (J == 0) {
        turns = falls && sf_undamped_rises(above->h_AA, above->h_AAA, at->k, 0) > 0;
    } else if (J < 0) {
        if ((falls_off ? at->k : at->h) <= 0)
            return 1;
        turns = falls;
        if (!falls_off)
            best->rest = fmin(best->rest, at_rest);
    } else {
        if (falls_off && at->h <= 0 && at->k >= 0)
            return 1;
        turns = falls && at->k < 0;
        if (falls_off && at->h > 0)
            best->rest = fmin(best->rest, at_rest);
    }
    if (turns)
        sf_consider(slow_flow_undamped_level(model->m, at->k), slow_flow_undamped_Omega(at->h_A), at->A, SF_CORNER_KIND,
                    best);
    return 0;
}

static int sf_is_bent(const sf_stretch *piece) {
    return piece->first.h_AA != 0 || piece->first.h_AAA != 0 || piece->last.h_AA != 0 || piece->last.h_AAA != 0;
}

/* Whether there are folds on a piece from its first amplitude on: h_A is negative next to it, h_AAA being monotone. */
static int sf_leaves_rest(const sf_stretch *piece, double h_A) {
    const sf_sample *a = &piece->first;
    const double bend = a->h_AA != 0 ? a->h_AA : a->h_AAA != 0 ? a->h_AAA : piece->last.h_AAA;
    return h_A != 0 ? h_A < 0 : bend < 0;
}

/* What the level does as A grows without end: 1 if it tends to m, -1 if it falls to another limit, which is no
 * answer. */
static int sf_undamped_beyond(const sf_model *model) {
    const sf_sample near = sf_sample_at(model, SF_FAR_OUT);
    const sf_sample far = sf_sample_at(model, SF_ENDLESS);
    if (!(far.h_A < 0 && fabs(far.k) < fabs(near.k)))
        return 0;
    return fabs(far.k) < SF_TENDS * fabs(near.k) ? 1 : -1;
}

/* With a preload k is negative at rest: where folds of both signs of k are found it passes 0 between them, and folds
 * come as near to m as one asks. */
static sf_status sf_onset_of_preload(const sf_model *model, double h, sf_work *work) {
    const sf_status status = sf_saddle_nodes(model, slow_flow_undamped_level(model->m, 0.5 * h), work, &work->folds);
    int signs = 0;
    if (status != SF_OK)
        return status;
    for (int i = 0; i < work->folds.n; i++) {
        const sf_sample at = sf_sample_at(model, work->folds.at[i].A);
        signs |= at.k < 0 ? 1 : 2;
    }
    return signs == 3 ? SF_UNBOUNDED : SF_UNRESOLVED;
}

/* The lowest forcing without viscous damping. Where k tends to 0 on the way, as to A = 0 with a stiffness that is not
 * negative there, or as A grows where springs have left, there are folds as near to m as one asks, and no lowest. */
static sf_status sf_onset_undamped(const sf_model *model, sf_work *work, sf_onset *best) {
    sf_stretch piece;
    int tends = 0;
    piece.first = sf_sample_at(model, 0);
    if (piece.first.h < 0)
        return sf_onset_of_preload(model, piece.first.h, work);
    if (sf_inertial(model)) {
        const sf_status status = sf_saddle_nodes(model, 2 * model->m + 1, work, &work->folds);
        return status != SF_OK ? status : work->folds.n > 0 ? SF_UNBOUNDED : SF_NONE;
    }
    sf_sample at = piece.first;
    for (int k = 0; !tends && k <= model->breaks; k++) {
        piece.last = sf_sample_at(model, k < model->breaks ? model->b[k] : SF_ENDLESS);
        if (sf_is_bent(&piece)) {
            tends = at.k == 0 && sf_leaves_rest(&piece, at.h_A) && !(k > 0 && model->jump[k - 1] != 0);
            sf_clear_zeros(&work->zeros);
            tends |= !tends && sf_undamped_in(model, &piece, &work->zeros, best);
            if (work->zeros.status != SF_OK)
                return work->zeros.status;
        }
        if (k < model->breaks) {
            at = piece.first = piece.last;
            sf_tend_from_above(model, k, &piece.first);
            tends |= sf_undamped_on(model, &at, &piece.first, model->jump[k], best);
        }
    }
    if (!tends)
        tends = sf_undamped_beyond(model);
    if (tends) {
        best->kind = SF_NO_KIND, best->rest = HUGE_VAL;
        return tends > 0 ? SF_UNBOUNDED : SF_UNRESOLVED;
    }
    return best->kind != SF_NO_KIND ? SF_OK : SF_NONE;
}

/* Whether there is no onset, or one so near to a breakpoint that few doubles lie between. */
static int sf_is_near_break(const sf_model *model, const sf_onset *best) {
    for (int k = 0; k < model->breaks; k++)
        if (best->kind != SF_CORNER_KIND && fabs(best->A - model->b[k]) <= SF_COINCIDE * model->b[k])
            return 1;
    return best->kind == SF_NO_KIND;
}

/* Whether folds of an excitation by inertia on a breakpoint come lower than the best as Omega tends to inf. There F_A
 * and R are positive, so that folds sit on it where the force jumps by J < 0; and where the level of that amplitude
 * only falls, it falls to the amplitude, or by quadratic damping to what is above it. */
static int sf_falls_at_break(const sf_model *model, const sf_onset *best) {
    double w[2];
    for (int k = 0; k < model->breaks; k++) {
        const sf_sample at = sf_sample_at(model, model->b[k]);
        if (model->jump[k] < 0 && sf_full_level(model, &at) < best->F_SN && sf_law_stationary(model, &at, w) == 0)
            return 1;
    }
    return 0;
}

/* The ends of the pieces: at rest, on breakpoints, and above them. */
typedef struct {
    sf_sample rest, on[SF_MOST_BREAKS], above[SF_MOST_BREAKS];
} sf_piece_ends;

static void sf_end_pieces(const sf_model *model, sf_piece_ends *ends) {
    ends->rest = sf_sample_at(model, 0);
    for (int k = 0; k < model->breaks; k++) {
        ends->on[k] = sf_sample_at(model, model->b[k]);
        ends->above[k] = ends->on[k];
        sf_tend_from_above(model, k, &ends->above[k]);
    }
}

/* What is known of the lowest forcing before the pieces are searched: for zeta > 0 that on breakpoints, which leaves
 * less to search. */
static void sf_begin_onset(const sf_model *model, const sf_piece_ends *ends, sf_onset *best) {
    best->F_SN = best->rest = HUGE_VAL;
    best->Omega = best->A = NAN, best->kind = SF_NO_KIND, best->undecided = 0;
    if (model->zeta == 0 && !model->by_laws)
        return;
    if (ends->rest.h <
        0) /* R, -preload next to A = 0, vanishes at frequencies that tend to infinity there, and F_0 tends to m */
        best->rest = model->m;
    for (int k = 0; k < model->breaks; k++) {
        if (model->by_laws)
            sf_consider_corner_by_laws(model, k, &ends->on[k], best);
        else if (sf_inertial(model))
            sf_consider_inertial(model, &ends->on[k], model->jump[k], best);
        else if (model->jump[k] != 0)
            sf_consider_jump(model, &ends->on[k], model->jump[k], best);
        else
            sf_consider_bend(model, &ends->on[k], copysign(1, ends->above[k].h_AA), best);
    }
}

/* No onset, for the reason in a status. limit: what the level of folds comes down to, if that is known */
static sf_status sf_without_onset(sf_status status, double limit, sf_onset *best) {
    best->F_SN = best->Omega = best->A = NAN, best->kind = SF_NO_KIND;
    if (status == SF_UNBOUNDED)
        best->rest = limit;
    return status;
}

/* Whether there are folds at any forcing above m, by quadratic damping alone.
 *
 * By a force next to where a play ends: |h_A| exceeds |h|/A there, so that R R_A = -a A Omega^4 where
 * Omega^2 = |h_A|/(1 + a) and h is left out; I I_A is 2 d^2 A^3 Omega^4. For a small Omega they do outweigh each other
 * either way as a changes: F_A vanishes between, at a level that is of the size of Omega^2.
 *
 * By any excitation where no stiffness holds the mass at rest: next to A = 0 either h_AA < 0, or |h_A| is convex:
 * |h|/(A |h_A|) is at most a half, or tends to it. So R R_A is -a (1 - (1 + a)/2) A Omega^4 or less where
 * Omega^2 = |h_A|/(1 + a), and next to it I I_A vanishes with A^2. The level is less than (A + d A^2) Omega^2. */
static int sf_comes_down(const sf_model *model, const sf_piece_ends *ends) {
    sf_stretch piece;
    if (!(model->d > 0) || model->zeta + model->m + model->eta > 0)
        return 0;
    for (int k = 0; k < model->breaks && !sf_inertial(model); k++)
        if (ends->above[k].h == 0 && ends->above[k].h_A == 0 && ends->above[k].h_AA < 0)
            return 1;
    piece.first = ends->rest;
    piece.last = sf_sample_at(model, model->breaks > 0 ? fmin(model->b[0], 1) : 1);
    return model->mechanism->bent == NULL && piece.first.h == 0 && piece.first.h_A == 0 &&
           fabs(piece.first.h_AA) < HUGE_VAL && sf_leaves_rest(&piece, 0);
}

/* The amplitude from which on there may be folds, next to a force that is infinitely stiff at u = 0, as under a power
 * of u below 1; of any other force 0; negative where there are folds at ever smaller amplitudes.
 *
 * R R_A is least, -k^2/(4 A), between the Omega at which R and R_A vanish. Where that outweighs I I_A ever more there
 * is a fold at each A, with |R| < |k|, which tends to 0: the level tends to that of friction. Where it outweighs it
 * ever less there is none. */
static double sf_first_with_folds(const sf_model *model, const sf_sample *rest) {
    double A = 1, from = 0, outweighed = 0, outweighs = 0;
    int come_down = 1;
    if (rest->h < 0 || !isinf(rest->h_A))
        return 0;
    for (int k = 0; k < SF_FALLS; k++) {
        const double last = outweighed, lasts = outweighs;
        A *= SF_FALL;
        const sf_sample at = sf_sample_at(model, A);
        const double slow = 2 * model->zeta * sqrt(fmin(fabs(at.h) / A, fabs(at.h_A)));
        const double fast = 2 * model->zeta * sqrt(fmax(fabs(at.h) / A, fabs(at.h_A)));
        const double ratio = at.k * at.k / (4 * A);
        outweighs = ratio / (fast * (model->m + fast * A));
        outweighed = ratio / (slow * (model->m + slow * A));
        come_down &= outweighs > 1 && (k == 0 || outweighs > lasts);
        if (!(outweighed < 1) || (k > 0 && !(outweighed < last)))
            from = 0;
        if (from == 0 && outweighed < 1)
            from = A;
    }
    return come_down ? -1 : from;
}

/* The lowest forcing at which folds are born, from there. pieces: how many of the first have been considered */
static sf_status sf_end_onset(const sf_model *model, const sf_piece_ends *ends, int pieces, sf_work *work,
                              sf_onset *best) {
    const int undamped = model->zeta == 0 && !model->by_laws;
    const double from = undamped ? 0 : sf_first_with_folds(model, &ends->rest);
    sf_sample rest = ends->rest;
    sf_stretch piece;
    sf_status status;
    if (undamped) {
        status = sf_onset_undamped(model, work, best);
        return best->kind == SF_NO_KIND ? sf_without_onset(status, model->m, best) : status;
    }
    if (!model->by_laws && sf_is_free(model))
        return sf_without_onset(SF_NONE, HUGE_VAL, best);
    if (from < 0 || sf_comes_down(model, ends))
        return sf_without_onset(SF_UNBOUNDED, model->m, best);
    /* of a preload they have R next to 0 and A Omega^2 next to it, as Omega tends to infinity */
    if (sf_inertial(model) && ends->rest.h < 0)
        return sf_without_onset(SF_UNBOUNDED, HUGE_VAL, best);
    if (from > 0)
        rest = sf_sample_at(model, from);
    if (model->sign_lost) /* whether a corner is the lowest is the sign of a jump */
        return sf_without_onset(SF_UNRESOLVED, 0, best);
    for (int k = pieces; k < model->breaks; k++) {
        piece.first = k > 0 ? ends->above[k - 1] : rest, piece.last = ends->on[k];
        status = sf_consider_piece(model, &piece, work, best);
        if (status != SF_OK)
            return sf_without_onset(status, 0, best);
    }
    status = sf_onset_in_last(model, model->breaks > 0 ? &ends->above[model->breaks - 1] : &rest, work, best);
    if (best->undecided && sf_is_near_break(model, best))
        status = SF_UNRESOLVED;
    if (sf_inertial(model) && (status == SF_OK || status == SF_NONE) && sf_falls_at_break(model, best))
        status = SF_UNBOUNDED;
    if (status == SF_OK && best->kind == SF_NO_KIND)
        status = SF_NONE;
    return status == SF_OK ? status : sf_without_onset(status, HUGE_VAL, best);
}

static sf_status sf_find_onset(const sf_model *model, sf_work *work, sf_onset *best) {
    sf_piece_ends ends;
    sf_end_pieces(model, &ends);
    sf_begin_onset(model, &ends, best);
    return sf_end_onset(model, &ends, 0, work, best);
}

/* ==== Peak ======================================================================================================== */

/* The highest top of one question on the pieces, from above. */
static sf_status sf_highest(const sf_model *model, sf_question question, double F_0, sf_work *work, sf_point *out) {
    sf_task task = sf_task_of(question, model, F_0);
    const sf_sample *rest = &work->pieces.at[0].first;
    sf_zeros *found = &work->zeros;
    task.highest = 1;
    task.pushes = rest->h > 0 || (rest->h == 0 && !(rest->h_A < 0));
    for (int k = work->pieces.n - 1; k >= 0; k--) {
        sf_clear_zeros(found);
        sf_find_zeros(&task, &work->pieces.at[k], found);
        if (found->status != SF_OK)
            return found->status;
        const sf_zero *top = sf_top(found, task.pushes);
        if (top != NULL) {
            out->A = top->A, out->Omega = top->Omega;
            return SF_OK;
        }
    }
    return SF_NONE;
}

/* Whether some frequency has a lower level than rest has: then the static state is no top, the response goes on above
 * it. */
static int sf_goes_on_above_rest(const sf_model *model, double F_0, double A) {
    const sf_sample at = sf_sample_without_k_at(model, A);
    const double w = sf_last_stationary(model, &at), I = slow_flow_I(w, A, model->m, model->zeta);
    return w > 0 && slow_flow_F(w, A, F_0, model->m, model->zeta, at.h) < -sf_error_of_F(&at, I, F_0, w);
}

/* The highest peak of the response at F_0 up to `most`, isolas included, and its frequency: one at which F
 * rises with A, so that stable motions end there; where there is none, as A only falls with Omega, the static amplitude
 * at Omega = 0. SF_NONE under a force where nothing ends the response: its spring gives way. For zeta > 0. */
static sf_status sf_peak(const sf_model *model, double F_0, double most, sf_work *work, double *A, double *Omega) {
    sf_point found;
    *A = *Omega = NAN;
    if (model->by_laws)
        return sf_law_peak(model, F_0, most, work, A, Omega);
    if (sf_sticks(model, F_0))
        return SF_STICKS;
    if (model->zeta == 0)
        return SF_UNBOUNDED;
    sf_status status = sf_range_at(model, F_0, &work->A_max);
    if (status != SF_OK)
        return status;
    work->A_max = fmin(work->A_max, most);
    sf_stretches_up_to(model, work->A_max, &work->pieces);
    status = sf_highest(model, SF_PEAK, F_0, work, &found);
    if (status == SF_NONE) {
        status = sf_highest(model, SF_REST, F_0, work, &found);
        if (status == SF_OK && sf_goes_on_above_rest(model, F_0, found.A))
            status = SF_NONE;
    }
    if (status == SF_OK)
        *A = found.A, *Omega = found.Omega;
    return status;
}
