/* The fold locus and its level crossings. Takes a model and a range of A; returns arcs, folds, cusps, isola points.
 *
 * Between neighbouring stations (cusps, isola points, turning points, ends at Omega = 0, breakpoints) the number of
 * branches is constant, and along each branch Omega and the level F_0 are monotone. So a branch has a fold at F_0 there
 * if and only if its ends lie on both sides of F_0.
 */
#pragma once

#include "arc_links.h"
#include "bounds.h"
#include "points.h"

/* by how much more than I the terms of R may be, as a share of I, or if squares of roundings are to count */
#define SF_FEW_LOST 4
#define SF_SQUARE_LOST 0x1p24
/* F_A at a fold is less, as a share of its terms: far more than rounding leaves, far less than next to a fold */
#define SF_OF_A_FOLD 0x1p-20

static void sf_ask_all(const sf_model *model, sf_question question, double F_0, const sf_stretch *piece,
                       sf_zeros *found) {
    const sf_task task = sf_task_of(question, model, F_0);
    sf_find_zeros(&task, piece, found);
}

/* By other laws of damping, in boxes. */
static void sf_ask_boxes(const sf_model *model, sf_question question, const sf_stretch *piece, sf_law_search *search,
                         sf_zeros *found) {
    const sf_law_system system = question == SF_CUSP    ? SF_LAW_CUSPS
                                 : question == SF_ISOLA ? SF_LAW_ISOLAS
                                                        : SF_LAW_TURNS;
    const int number = sf_piece_from(model, piece->first.A);
    sf_begin_search(model, system, HUGE_VAL, search);
    sf_begin_piece(search, number);
    sf_search_points(search, &piece->first, &piece->last);
    found->undecided |= search->found.undecided > 0;
    if (search->found.status != SF_OK)
        found->status = search->found.status;
    for (int i = 0; i < search->found.n; i++) {
        const double A = search->found.at[i].A, w = search->found.at[i].Omega;
        sf_zero zero = {A, w, sf_level_at_point(search, &search->found.at[i]), question, 0, 0};
        const sf_sample at = sf_sample_at(model, A);
        const sf_law_terms of = sf_law_terms_at(model, A, number > 0);
        zero.channel = !(dissipation_F_AOmegaOmega(w, A, of.rest[0], of.rest[1], of.zeta[0], of.zeta[1], of.d, of.d_3,
                                                   at.h, at.h_A) < 0);
        zero.rising = sf_law_F_AA(model, &at, w, sf_is_beyond(model, A)) > 0;
        sf_add_zero(found, zero);
    }
}

/* Cusps and isola points of a piece, added to those found; and for zeta = 0 where the locus touches the backbone. */
static void sf_extrema_on(const sf_model *model, const sf_stretch *piece, sf_law_search *search, sf_zeros *found) {
    if (model->by_laws) {
        sf_ask_boxes(model, SF_ISOLA, piece, search, found);
        sf_ask_boxes(model, SF_CUSP, piece, search, found);
    } else if (model->zeta == 0) {
        sf_ask_all(model, SF_UNDAMPED, 0, piece, found);
    } else {
        sf_ask_all(model, SF_ISOLA, 0, piece, found);
        sf_ask_all(model, SF_CUSP, 0, piece, found);
    }
}

/* undecided: whether rounding may hide some at which the level turns */
static void sf_locus_zeros(const sf_model *model, const sf_stretch *piece, int whole, sf_law_search *search,
                           sf_zeros *found) {
    sf_clear_zeros(found);
    if (whole)
        sf_ask_all(model, SF_STIFFNESS, 0, piece, found);
    found->undecided = 0;
    sf_extrema_on(model, piece, search, found);
    const int undecided = found->undecided;
    if (whole && model->by_laws)
        sf_ask_boxes(model, SF_TURN, piece, search, found);
    else if (whole && model->zeta > 0)
        sf_ask_all(model, SF_TURN, 0, piece, found);
    found->undecided = undecided;
    sf_sort_zeros(found);
}

static sf_event_kind sf_locus_event(const sf_zero *zero) {
    if (zero->question == SF_STIFFNESS)
        return SF_TO_ZERO;
    if (zero->question == SF_TURN)
        return zero->channel == 0 ? SF_PAIR_LOW : SF_PAIR_HIGH;
    return SF_THROUGH;
}

/* By how much the number of roots changes at a turning point: where a maximum of F_A over Omega rises above zero a pair
 * is born. */
static int sf_locus_gain(const sf_zero *zero) {
    if (zero->question != SF_TURN)
        return 0;
    return zero->rising == (zero->channel == 0) ? 2 : -2;
}

/* Cusps and isola points up to A_max in work, and where `whole` the locus. Without it turns are left out, which are
 * beyond doubles where damping is weak: there its two branches all but cross. */
static sf_status sf_fold_locus(const sf_model *model, double A_max, int whole, sf_work *work) {
    sf_graph *graph = &work->locus;
    graph->events = 0, graph->status = SF_OK;
    work->A_max = A_max;
    sf_clear_zeros(&work->extrema);
    sf_stretches_up_to(model, A_max, &work->pieces);
    for (int i = 0; i < work->pieces.n; i++) {
        const sf_stretch *piece = &work->pieces.at[i];
        if (!sf_has_force(piece))
            continue;
        sf_locus_zeros(model, piece, whole, &work->points, &work->zeros);
        sf_add_event(graph, i == 0 ? 0 : nextafter(piece->first.A, HUGE_VAL), 0, SF_CUT, 0);
        for (int k = 0; k < work->zeros.n; k++) {
            const sf_zero *zero = &work->zeros.at[k];
            sf_add_event(graph, zero->A, zero->Omega, sf_locus_event(zero), sf_locus_gain(zero));
            if (zero->question == SF_CUSP || zero->question == SF_ISOLA || zero->question == SF_UNDAMPED)
                sf_add_zero(&work->extrema, *zero);
        }
        sf_add_event(graph, piece->last.A, 0, SF_CUT, 0);
        work->extrema.undecided |= work->zeros.undecided;
        if (work->zeros.status != SF_OK)
            return work->zeros.status;
    }
    if (!whole)
        return work->extrema.status;
    sf_merge_events(graph);
    if (graph->status == SF_OK)
        sf_trace_arcs(model, SF_ON_LOCUS, graph);
    return graph->status;
}

/* ==== Folds at a forcing ========================================================================================== */

/* Whether a fold comes after another one: by rising Omega, of one Omega by rising A, of one A too the corner first. */
static int sf_comes_after(const sf_fold *one, const sf_fold *other) {
    if (one->Omega != other->Omega)
        return one->Omega > other->Omega;
    return one->A != other->A ? one->A > other->A : other->corner && !one->corner;
}

static void sf_add_fold(sf_folds *folds, double Omega, double A, int up, int corner) {
    sf_fold fold;
    int i;
    if (folds->n == SF_MOST_FOLDS) {
        folds->status = SF_TOO_MANY;
        return;
    }
    fold.Omega = Omega, fold.A = A, fold.up = up, fold.corner = corner;
    for (i = folds->n++; i > 0 && sf_comes_after(&folds->at[i - 1], &fold); i--)
        folds->at[i] = folds->at[i - 1];
    folds->at[i] = fold;
}

/* All frequencies at an amplitude, by their size; returns their number. */
static int sf_frequencies(const sf_model *model, const sf_sample *at, double F_0, double Omega[3]) {
    if (sf_is_of_laws(model, F_0))
        return sf_law_frequencies(model, at, SF_OF_RESPONSE, F_0, sf_is_beyond(model, at->A), Omega);
    return sf_response_roots(at->A, at->h, model->m, model->zeta, F_0, Omega);
}

/* Whether a step of Newton's method is all that Omega is off a root of F = 0, which it then becomes. */
static int sf_is_next_to_root(const sf_model *model, double F_0, const sf_sample *at, double *Omega) {
    sf_quartic s;
    if (sf_inertial(model))
        return 0;
    s.kind = SF_RESPONSE;
    s.A = at->A, s.h = at->h, s.h_A = 0, s.m = model->m, s.zeta = model->zeta, s.F_0 = F_0;
    sf_derivative_coefficients(&s);
    const double C = sf_cubic(&s, *Omega), D = sf_cubic_slope(&s, *Omega), step = sf_value_fine(&s, *Omega) / (s.k * C);
    if (!(fabs(step) <= SF_LAST_STEP * *Omega && fabs(step * D) * fabs(step) <= SF_CORRECTED * fabs(C) * *Omega))
        return 0;
    *Omega -= step;
    return 1;
}

/* What rounding may leave of R at an amplitude, over a rounding. */
static double sf_size_of_R(const sf_sample *at, double w) {
    return fabs(at->h) + at->A * fabs(at->h_A) + at->A * w * w;
}

/* F_A at a frequency, as a share of what its terms may be: at a fold that is small. */
static double sf_share_of_F_A(const sf_model *model, const sf_sample *at, double w) {
    const double R = fabs(slow_flow_R(w, at->A, at->h)), S = fabs(w * w + at->h_A);
    const double size = 2 * model->zeta * w * slow_flow_I(w, at->A, model->m, model->zeta) +
                        R * (w * w + fabs(at->h_A)) + S * sf_size_of_R(at, w);
    return fabs(sf_half_F_A(model, at, w)) / size;
}

/* Omega from F = 0, where at a fold it does not depend on A to first order: the root next to the one by I or R. Where
 * damping is next to none neither has digits, and that root may be no fold: then the one at which F_A is. */
static double sf_settled_Omega(const sf_model *model, double F_0, const sf_sample *at, double Omega) {
    double w[3], nearest = HUGE_VAL, least = HUGE_VAL;
    int place = 0;
    if (sf_is_next_to_root(model, F_0, at, &Omega) && sf_share_of_F_A(model, at, Omega) <= SF_OF_A_FOLD)
        return Omega;
    int n = sf_frequencies(model, at, F_0, w);
    if (n == 0) /* beyond the tip of the curve by rounding: Omega from F_A = 0 after all */
        n = sf_fold_roots(at->A, at->h, at->h_A, model->m, model->zeta, w);
    for (int i = 0; i < n; i++)
        if (fabs(w[i] - Omega) < nearest)
            nearest = fabs(w[i] - Omega), place = i;
    if (n == 0 || sf_inertial(model) || sf_share_of_F_A(model, at, w[place]) <= SF_OF_A_FOLD)
        return n > 0 ? w[place] : Omega;
    for (int i = 0; i < n; i++) {
        const double fraction = sf_share_of_F_A(model, at, w[i]);
        if (fraction < least)
            least = fraction, place = i;
    }
    return w[place];
}

/* Whether the side below breakpoint b is stable at the state (b, w): F_A > 0. Where the state is, to rounding, the end
 * of the fold locus below, the sign of SF_FOLD_AT there decides, which decided whether that has a zero next to b. To
 * first order F and F_A are multiples of it, and F_A at the state is less by F_AOmega F/F_Omega; without viscous
 * damping it is F, and F_A is 0. */
static int sf_is_stable_below(const sf_model *model, double F_0, const sf_sample *at, double w) {
    const sf_task task = sf_task_of(SF_FOLD_AT, model, F_0);
    sf_answer fold;
    if (model->by_laws)
        return sf_law_F_A(model, at, w, sf_is_beyond(model, at->A)) > 0;
    if (sf_inertial(model))
        return sf_half_F_A(model, at, w) > 0;
    sf_ask(&task, 1, at, &fold);
    if (fold.exists[0] && fabs(fold.Omega[0] - w) < SF_NEAR_END * w) {
        const double turn = 4 * sf_quarter_F_AOmega(model, at, w) / sf_F_Omega(model, at, w);
        double shift[2] = {1, 0}; /* of F and F_A */
        if (model->zeta > 0)
            slow_flow_fold_moves(at->A, at->k, slow_flow_R(w, at->A, at->h), shift);
        return fold.y[0] * (shift[1] - turn * shift[0]) > 0;
    }
    return sf_half_F_A(model, at, w) > 0;
}

/* Whether rounding may decide which folds there are on a breakpoint at which the force jumps by J, or between it and
 * the next double. Omega: the n frequencies of the response there */
static int sf_is_corner_close(const sf_model *model, double F_0, double J, const sf_sample *at, int n,
                              const double *Omega) {
    sf_quartic cubic;
    double w[3];
    int count;
    if (J == 0 || fabs(J) <= SF_CLOSE * at->A * (1 + fabs(at->h_A)))
        return 1;
    if (sf_is_of_laws(model, F_0))
        count = sf_law_stationary(model, at, w);
    else /* F is stationary there: their last digits change nothing */
        count = sf_unpolished_peak_roots(&cubic, at->A, at->h, model->m, model->zeta, w);
    w[count++] = 0;
    for (int i = 0; i < count; i++)
        if (sf_is_F_close(model, at, F_0, w[i]))
            return 1;
    for (int i = 0; i < n && Omega[i] < HUGE_VAL; i++) {
        const double R = slow_flow_R(Omega[i], at->A, at->h), size = sf_size_at(at, sf_force(model, F_0, Omega[i]));
        const double half_F_A = model->by_laws ? sf_law_F_A(model, at, Omega[i], sf_is_beyond(model, at->A)) / 2
                                               : sf_half_F_A(model, at, Omega[i]);
        const double slope = at->A * fabs(half_F_A);
        if (fabs(R) <= SF_CLOSE * size || slope <= SF_CLOSE * size * size || fabs(R * J) * SF_STEEP <= slope)
            return 1;
    }
    return 0;
}

/* Whether folds may sit on breakpoint i, as F_A may change its sign there without passing 0: where the force jumps, or
 * friction ends. */
static int sf_has_corner(const sf_model *model, int i) { return model->jump[i] != 0 || (i == 0 && model->released); }

/* Whether the side above it is stable at a state on it: where the force jumps by J, F_A = 2 R h_A + ... has next to it
 * the sign of R J. */
static int sf_is_stable_above(const sf_model *model, int i, const sf_sample *at, double w) {
    if (model->jump[i] != 0)
        return slow_flow_R(w, at->A, at->h) * model->jump[i] > 0;
    return sf_law_F_A(model, at, w, 1) > 0;
}

/* Folds on breakpoints. */
static void sf_corner_folds(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    for (int k = 0; k < model->breaks; k++) {
        sf_corner *corner = &work->corner[k];
        const double *w = corner->Omega;
        const sf_sample *at = &corner->at;
        if (!sf_has_corner(model, k) || !(model->b[k] < work->A_max))
            continue;
        corner->at = sf_sample_at(model, model->b[k]);
        corner->n = sf_frequencies(model, at, F_0, corner->Omega);
        for (int i = 0; i < corner->n && w[i] < HUGE_VAL; i++) {
            const int stable_below = sf_is_stable_below(model, F_0, at, w[i]);
            if (stable_below != sf_is_stable_above(model, k, at, w[i]))
                sf_add_fold(folds, w[i], at->A, stable_below, 1);
        }
    }
}

/* The level at a point of the fold locus: by k and F_A = 0, as rounding of h and A Omega^2 may leave nothing of R, but
 * where the two slopes that R may have all but meet and the root between them loses more; and under an excitation by
 * inertia 0 at A = 0, where the locus begins without friction and no Omega is known. */
static double sf_locus_level(const sf_model *model, const sf_sample *at, double w) {
    const double slope = w * w + at->h_A;
    double m = model->m, zeta = model->zeta, slopes[3], level;
    if (sf_inertial(model) && at->A == 0)
        return 0;
    if (model->by_laws) { /* these have the same I and I_A there */
        const sf_law_terms of = sf_law_terms_below(model, at->A);
        const double I_A = dissipation_I_A(w, at->A, of.rest[1], of.zeta[0], of.zeta[1], of.d, of.d_3);
        level = sf_law_level(model, at, w);
        m = sf_law_I(model, at->A, w) - at->A * I_A, zeta = I_A / (2 * w);
    } else {
        level = sf_level(model, at, w);
    }
    if (!(zeta > 0 && w > 0 && at->k * at->k > 0 && fabs(at->k) < HUGE_VAL))
        return level;
    inertia_fold_slopes(w, at->A, m, zeta, at->k, slopes);
    const double other = slopes[fabs(slope - slopes[0]) <= fabs(slope - slopes[1])];
    if (!(fabs(slopes[0] - slopes[1]) * sf_size_of_R(at, w) >= fabs(at->k * other)))
        return level;
    if (sf_inertial(model))
        return inertia_fold_level(w, at->A, m, zeta, other);
    /* by what the record's excitation differs from a force */
    return inertia_fold_force(w, at->A, m, zeta, other) * (level / slow_flow_level(w, at->A, m, zeta, at->h));
}

/* Omega of a fold of an excitation by inertia where damping is so weak that what rounding leaves of R takes it off the
 * response: by I and F_A = 0, if h is that of the amplitude but for roundings; else as it was. */
static double sf_sharp_Omega(const sf_model *model, double F_0, const sf_sample *at, double Omega) {
    double fraction;
    const double w = sf_Omega_by_share(model, F_0, at, 1, &fraction), I = inertia_force(w, F_0);
    const double size = sf_size_of_R(at, w), loss = size / I;
    if (w > 0 && (fabs(fraction) * loss > SF_FEW_LOST || loss > SF_SQUARE_LOST) &&
        fabs(slow_flow_R(w, at->A, at->h) + fraction * I) <= SF_CLOSE * size)
        return w;
    return Omega;
}

/* The level on an arc of the fold locus less F_0. */
static double sf_excess(const sf_model *model, double F_0, const sf_arc *arc, double A, double *Omega) {
    const sf_sample at = sf_sample_at(model, A);
    *Omega = A == arc->A[0]   ? arc->Omega[0]
             : A == arc->A[1] ? arc->Omega[1]
                              : sf_branch_at(model, &at, SF_ON_LOCUS, arc->count, arc->index);
    return *Omega > 0 || A == 0 ? sf_locus_level(model, &at, *Omega) - F_0 : HUGE_VAL;
}

/* Where the level, which is monotone along the arc, passes F_0: regula falsi (Illinois), and halves where that is
 * slow. */
static double sf_level_crossing(const sf_model *model, double F_0, const sf_arc *arc, double low, double high,
                                double *Omega) {
    double a = arc->A[0], b = arc->A[1], f_a = low, f_b = high;
    for (int i = 0; i < 400; i++) {
        double A = b - f_b * ((b - a) / (f_b - f_a));
        if (!(A > a && A < b) || i % 4 == 3)
            A = sf_amid(0, a, b);
        if (!(A > a && A < b) || b - a <= 0x1p-52 * b)
            break;
        const double f = sf_excess(model, F_0, arc, A, Omega);
        if ((f < 0) == (low < 0)) {
            a = A, f_a = f, f_b *= 0.5;
        } else {
            b = A, f_b = f, f_a *= 0.5;
        }
        if (f == 0)
            break;
    }
    sf_excess(model, F_0, arc, fabs(f_a) < fabs(f_b) ? a : b, Omega);
    return fabs(f_a) < fabs(f_b) ? a : b;
}

/* Of an excitation by inertia at an amplitude, with the last digits of Omega. */
static void sf_add_fold_by_inertia(const sf_model *model, double F_0, const sf_sample *at, double Omega,
                                   sf_folds *folds) {
    Omega = sf_settled_Omega(model, F_0, at, Omega);
    if (model->zeta > 0)
        Omega = sf_sharp_Omega(model, F_0, at, Omega);
    sf_add_fold(folds, Omega, at->A, sf_half_F_AA(model, at, Omega) < 0, 0);
}

/* The folds of an excitation by inertia inside of pieces, where a search in boxes leaves some open: where the level
 * passes F_0 along the arcs of the fold locus. */
static sf_status sf_locus_folds(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    const sf_status status = sf_fold_locus(model, work->A_max, 1, work);
    if (status != SF_OK)
        return status;
    folds->undecided |= work->extrema.undecided;
    for (int i = 0; i < work->locus.arcs; i++) {
        const sf_arc *arc = &work->locus.arc[i];
        double Omega;
        const double low = sf_excess(model, F_0, arc, arc->A[0], &Omega),
                     high = sf_excess(model, F_0, arc, arc->A[1], &Omega);
        folds->undecided |= fabs(low) <= SF_CLOSE * F_0 || fabs(high) <= SF_CLOSE * F_0;
        if (!sf_opposite(low, high))
            continue;
        const double A = sf_level_crossing(model, F_0, arc, low, high, &Omega);
        const sf_sample at = sf_sample_at(model, A);
        sf_add_fold_by_inertia(model, F_0, &at, Omega, folds);
    }
    return SF_OK;
}

/* The folds of a force inside of pieces. */
static sf_status sf_forced_folds(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    sf_zeros *found = &work->zeros;
    sf_stretches_up_to(model, work->A_max, &work->pieces);
    for (int i = 0; i < work->pieces.n; i++) {
        sf_clear_zeros(found);
        sf_ask_all(model, SF_FOLD_AT, F_0, &work->pieces.at[i], found);
        if (found->status != SF_OK)
            return found->status;
        folds->undecided |= found->undecided, folds->close |= found->close;
        for (int k = 0; k < found->n; k++) {
            const double A = found->at[k].A;
            const sf_sample at = sf_sample_at(model, A);
            const double Omega = sf_settled_Omega(model, F_0, &at, found->at[k].Omega);
            /* leaving a fold, a sweep goes the way of the saddle: up where the stable branch lies below it */
            sf_add_fold(folds, Omega, A, sf_half_F_AA(model, &at, Omega) < 0, 0);
        }
    }
    return SF_OK;
}

/* By other laws of damping, or of an excitation by inertia: points of a system (points.h). What these leave open by
 * inertia the locus has, though that takes several times as long. */
static sf_status sf_searched_folds(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    const sf_law_points *found = &work->points.found;
    sf_stretches_up_to(model, work->A_max, &work->pieces);
    sf_search_pieces(model, SF_LAW_FOLDS, F_0, &work->pieces, &work->points);
    if (!model->by_laws && (found->status != SF_OK || found->undecided > 0))
        return sf_locus_folds(model, F_0, work, folds);
    folds->undecided = found->undecided > 0;
    for (int i = 0; i < found->n; i++) {
        const sf_sample at = sf_sample_at(model, found->at[i].A);
        if (model->by_laws)
            sf_add_fold(folds, found->at[i].Omega, at.A,
                        sf_law_F_AA(model, &at, found->at[i].Omega, sf_is_beyond(model, at.A)) < 0, 0);
        else
            sf_add_fold_by_inertia(model, F_0, &at, found->at[i].Omega, folds);
    }
    return found->status;
}

/* Every fold at F_0 > m, or at any where friction ends, by rising Omega; the pieces up to the largest amplitude stay in
 * work. */
static sf_status sf_saddle_nodes(const sf_model *model, double F_0, sf_work *work, sf_folds *folds) {
    folds->n = folds->undecided = folds->close = 0, folds->status = SF_OK;
    if (sf_sticks(model, F_0) && !model->released)
        return SF_STICKS;
    sf_status status = sf_range_at(model, F_0, &work->A_max);
    if (status != SF_OK && status != SF_UNBOUNDED)
        return status;
    status = (sf_is_searched(model) ? sf_searched_folds
              : sf_inertial(model)  ? sf_locus_folds
                                    : sf_forced_folds)(model, F_0, work, folds);
    if (status != SF_OK)
        return status;
    sf_corner_folds(model, F_0, work, folds);
    return folds->status;
}

/* ==== The locus itself ============================================================================================ */

/* The forcing at an extremum, in the forms that lose no digits where damping is small. */
static double sf_extremum_level(const sf_model *model, const sf_zero *zero, const sf_sample *at) {
    if (zero->question == SF_ISOLA && !sf_inertial(model))
        return slow_flow_isola_level(zero->Omega, zero->A, model->m, model->zeta);
    if (zero->question != SF_CUSP)
        return sf_level(model, at, zero->Omega);
    if (sf_inertial(model))
        return inertia_amplitude(zero->Omega, zero->level);
    /* by what the record's excitation differs from a force */
    return zero->level *
           (sf_level(model, at, zero->Omega) / slow_flow_level(zero->Omega, at->A, model->m, model->zeta, at->h));
}

static sf_extremum sf_extremum_at(const sf_model *model, const sf_zero *zero) {
    sf_extremum out;
    const sf_sample at = sf_sample_at(model, zero->A);
    out.Omega = zero->Omega;
    out.A = zero->A;
    out.isola = zero->question == SF_ISOLA;
    out.few_digits = 0;
    if (model->by_laws) {
        out.F_0 = zero->level;
        out.minimum = sf_is_law_minimum(model, zero->question, &at, out.Omega, &out.saddle);
        return out;
    }
    out.F_0 = sf_extremum_level(model, zero, &at);
    out.minimum = sf_is_minimum(model, zero->question, &at, out.Omega);
    out.saddle = zero->question == SF_ISOLA && sf_is_saddle(model, &at, out.Omega);
    return out;
}

static double sf_locus_weight(const sf_arc *arc, double A_max) {
    const double way = fabs(arc->Omega[1] / (1 + arc->Omega[1]) - arc->Omega[0] / (1 + arc->Omega[0]));
    return (isnan(way) ? 0 : way) + (arc->A[1] - arc->A[0]) / A_max + SF_SPREAD;
}

/* About `samples` points along the locus in work, in order along each branch; returns their number, and with Omega NULL
 * only that. */
static long sf_draw_locus(const sf_model *model, long samples, sf_work *work, double *Omega, double *A, double *F_0,
                          long long *branch) {
    const sf_graph *locus = &work->locus;
    double total = 0;
    long n = 0;
    sf_make_tour(locus, &work->tour);
    for (int i = 0; i < locus->arcs; i++)
        total += sf_locus_weight(&locus->arc[i], work->A_max);
    for (int c = 0; c < work->tour.curves; c++)
        for (int i = work->tour.start[c]; i < work->tour.start[c + 1]; i++) {
            const int upward = work->tour.step[i] % 2, last = i + 1 == work->tour.start[c + 1];
            const sf_arc *arc = &locus->arc[work->tour.step[i] / 2];
            const int steps = (int)ceil((double)samples * sf_locus_weight(arc, work->A_max) / total);
            /* of a force that jumps at u = 0 no Omega is known at A = 0, where the locus begins */
            const int from = isnan(arc->Omega[1 - upward]), to = steps + last - (last && isnan(arc->Omega[upward]));
            if (Omega == NULL) {
                n += to - from;
                continue;
            }
            for (int k = from; k < to; k++, n++) {
                const double fraction = 0.5 - 0.5 * cos(3.14159265358979312 * (upward ? k : steps - k) / steps);
                const int end = k == 0 ? 1 - upward : upward;
                A[n] = k == 0 || k == steps ? arc->A[end] : arc->A[0] + (arc->A[1] - arc->A[0]) * fraction;
                const sf_sample at = sf_sample_at(model, A[n]);
                Omega[n] = k == 0 || k == steps ? arc->Omega[end]
                                                : sf_branch_at(model, &at, SF_ON_LOCUS, arc->count, arc->index);
                F_0[n] = sf_locus_level(model, &at, Omega[n]);
                branch[n] = c;
            }
        }
    return n;
}
