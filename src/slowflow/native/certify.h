/* Answers with their proof. Takes an oscillator's exact inputs, and a forcing; returns enclosures of its folds or
 * states, of F_SN and of F_cr, and where doubles do not decide.
 *
 * A fold inside a piece is a zero of SF_FOLD_AT; on a breakpoint where the force jumps, it is a root of F = 0 at which
 * F_A has one sign below and another above.
 */
#pragma once

#include "certificate.h"
#include "onset.h"
#include "proof.h"

/* an interval of Omega that is wider, relatively, is searched for roots */
#define SF_BROAD 0x1p-20
/* by how much, relatively, the forcing up to which an onset is proved to be the lowest exceeds the one that was
 * found */
#define SF_ABOVE_ONSET 0x1p-20

static int sf_sign_of(sf_interval x) { return sfi_positive(x) - sfi_negative(x); }

static void sf_enclose(sf_certificate *out, sf_interval Omega, sf_interval A, int corner, int sign) {
    if (out->n == SF_MOST_ZEROS) {
        out->full = 1;
        return;
    }
    out->at[out->n].Omega = Omega, out->at[out->n].A = A;
    out->at[out->n].corner = corner, out->at[out->n++].sign = sign;
}

static void sf_leave_undecided(sf_certificate *out, sf_interval A) {
    if (out->n_undecided == SF_MOST_UNDECIDED)
        out->full = 1;
    else
        out->undecided[out->n_undecided++] = A;
}

static void sf_leave_all_undecided(const sf_inputs *inputs, const sf_proof *proof, sf_certificate *out) {
    out->full |= proof->full;
    for (int i = 0; i < proof->n_undecided; i++)
        sf_leave_undecided(out, sf_beyond(inputs, proof->undecided[i].piece,
                                          sfi_of(proof->undecided[i].low, proof->undecided[i].high)));
}

/* Whether no amplitude from A on is that of a steady state at F_0 or less, as sf_bounds in doubles. */
static int sf_is_bounded(const sf_inputs *inputs, double F_0, double A) {
    sf_known here, there;
    sf_cell cell;
    if (inputs->zeta.lo == 0 || (inputs->breaks > 0 && !(A > inputs->b[inputs->breaks - 1].hi)))
        return 0;
    sf_know_at(inputs, inputs->breaks, sfi_down(A - sf_beginning(inputs, inputs->breaks).hi), &here);
    sf_know_at(inputs, inputs->breaks, SF_ENDLESS * sfi_most(A, 1), &there);
    sf_make_cell_on(sfi_of(here.A, there.A), &here, &there, &cell);
    const sf_interval most = slow_flow_intervals_most_restoring(sfi_point(A), sfi_point(F_0), inputs->m, inputs->zeta);
    return here.h.lo > 0 ? here.h.lo > most.hi && cell.h_A.lo >= 0 : -here.h.hi > most.hi && cell.h_A.hi <= 0;
}

/* ==== Folds at a forcing ========================================================================================== */

/* k on a cell that holds a fold, where its size is not below the least. */
static sf_interval sf_k_of_fold(const sf_terms *terms, const sf_cell *cell) {
    const sf_interval k = cell->k;
    if (k.hi >= terms->least.lo)
        return sfi_of(sfi_most(k.lo, terms->least.lo), k.hi);
    return sfi_of(k.lo, sfi_least(k.hi, -terms->least.lo));
}

/* Omega of a fold from I, which exceeds m by little if damping is weak; then by F = 0. */
static sf_interval sf_fold_Omega_on(const sf_terms *terms, const sf_cell *cell) {
    const sf_at_amplitude q = sf_at_cell(SF_ROOTS_OF_F, terms, cell);
    sf_interval fold[3];
    if (terms->zeta.hi == 0)
        return slow_flow_intervals_undamped_Omega(cell->h_A);
    slow_flow_intervals_fold(cell->A, terms->F_0, terms->m, terms->zeta, cell->h, cell->h_A, sf_k_of_fold(terms, cell),
                             cell->k_A, fold);
    sf_interval Omega = sf_narrow_root(&q, fold[2]);
    if (Omega.hi - Omega.lo > SF_BROAD * Omega.hi) { /* two roots may lie in it: at the fold R has the sign of k */
        const int side = sf_sign_of(sf_k_of_fold(terms, cell));
        sf_proof roots;
        sf_interval root;
        int n = 0;
        sf_prove_roots_between(&q, Omega.lo, Omega.hi, &roots);
        for (int i = 0; i < roots.n + roots.n_undecided && !roots.full; i++) {
            sf_take_root(&roots, i, &root);
            if (sf_sign_of(slow_flow_intervals_R(root, cell->A, cell->h)) != -side)
                Omega = n++ > 0 ? sfi_join(Omega, root) : root;
        }
    }
    return Omega;
}

/* The force's breakpoint i as a cell, as its lower side has it. */
static void sf_breakpoint_on(const sf_inputs *inputs, int i, sf_cell *on) {
    sf_known at;
    sf_know_below(inputs, i, &at);
    sf_make_cell_on(inputs->b[i], &at, &at, on);
}

static void sf_certify_corners(const sf_inputs *inputs, const sf_terms *terms, sf_certificate *out) {
    for (int k = 0; k < inputs->breaks; k++) {
        sf_proof roots;
        sf_cell on;
        const sf_interval b = inputs->b[k], jump = inputs->jump[k];
        if (sf_is_continuous_at(inputs, k))
            continue;
        if (b.lo > out->A_max)
            return;
        sf_breakpoint_on(inputs, k, &on);
        const sf_at_amplitude q = sf_at_cell(SF_ROOTS_OF_F, terms, &on);
        sf_prove_roots(&q, &roots);
        out->full |= roots.full;
        for (int i = 0; i < roots.n + roots.n_undecided; i++) {
            sf_interval w;
            const int undecided = sf_take_root(&roots, i, &w);
            const int stable_above = sf_sign_of(sfi_mul(slow_flow_intervals_R(w, b, on.h), jump));
            const int stable_below = sf_sign_of(slow_flow_intervals_F_A(w, b, inputs->m, inputs->zeta, on.h, on.h_A));
            if (stable_above != 0 && stable_above == stable_below)
                continue; /* no fold, however many roots there are */
            if (undecided || stable_above == 0 || stable_below == 0)
                sf_leave_undecided(out, b);
            else
                sf_enclose(out, w, b, 1, -stable_below);
        }
    }
}

static double sf_middle(sf_interval x) { return 0.5 * x.lo + 0.5 * x.hi; }

/* Whether a fold comes after another one: by rising Omega, by rising A where these overlap, the corner first
 * where both do. */
static int sf_follows(const sf_enclosure *one, const sf_enclosure *other) {
    if (one->Omega.lo > other->Omega.hi || one->Omega.hi < other->Omega.lo)
        return one->Omega.lo > other->Omega.hi;
    if (one->A.lo > other->A.hi || one->A.hi < other->A.lo)
        return one->A.lo > other->A.hi;
    return other->corner && !one->corner;
}

static int sf_is_higher(const sf_enclosure *one, const sf_enclosure *other) { return one->A.lo > other->A.lo; }

static void sf_sort_enclosures(sf_certificate *out, int (*follows)(const sf_enclosure *, const sf_enclosure *)) {
    int k;
    for (int i = 1; i < out->n; i++) {
        const sf_enclosure one = out->at[i];
        for (k = i; k > 0 && follows(&out->at[k - 1], &one); k--)
            out->at[k] = out->at[k - 1];
        out->at[k] = one;
    }
}

/* What an answer is before anything is proved: the range of A, and whether friction holds the mass. SF_UNRESOLVED
 * where exact inputs are not known, NULL. */
static sf_status sf_begin_certificate(const sf_model *model, const sf_inputs *inputs, sf_question question, double F_0,
                                      sf_room *room, sf_proving *proving) {
    sf_certificate *out = &room->found;
    out->n = out->n_undecided = out->full = 0, out->A_max = 0;
    if (inputs == NULL)
        return SF_UNRESOLVED;
    *proving = sf_proving_of(inputs, question, model, F_0, &room->proof);
    out->bounded = !(F_0 > inputs->m.lo);
    if (sf_sticks(model, F_0))
        return SF_STICKS;
    const sf_status status = sf_range_at(model, F_0, &out->A_max);
    if (status == SF_OK)
        out->bounded = sf_is_bounded(inputs, F_0, out->A_max);
    if (!(F_0 > inputs->m.hi))
        sf_leave_undecided(out, sfi_of(0, out->A_max));
    return status;
}

/* Every fold at F_0. */
static sf_status sf_certify_folds(const sf_model *model, const sf_inputs *inputs, double F_0, sf_room *room) {
    sf_certificate *out = &room->found;
    sf_proving proving;
    const sf_status status = sf_begin_certificate(model, inputs, SF_FOLD_AT, F_0, room, &proving);
    if (status != SF_OK || out->n_undecided > 0)
        return status;
    sf_prove(&proving, out->A_max);
    sf_leave_all_undecided(inputs, &room->proof, out);
    for (int i = 0; i < room->proof.n; i++) {
        const sf_cell *on = &room->proof.at[i].on;
        const sf_interval Omega = sf_fold_Omega_on(&proving.task.terms, on);
        const sf_interval F_AA =
            slow_flow_intervals_F_AA(Omega, on->A, inputs->m, inputs->zeta, on->h, on->h_A, on->h_AA);
        sf_enclose(out, Omega, on->A, 0, sf_sign_of(F_AA));
    }
    sf_certify_corners(inputs, &proving.task.terms, out);
    sf_sort_enclosures(out, sf_follows);
    return SF_OK;
}

/* ==== States at a frequency ======================================================================================= */

/* Every state at (Omega, F_0), by rising A. */
static sf_status sf_certify_states(const sf_model *model, const sf_inputs *inputs, double F_0, double Omega,
                                   sf_room *room) {
    sf_certificate *out = &room->found;
    sf_proving proving;
    const sf_status status = sf_begin_certificate(model, inputs, SF_STATE, F_0, room, &proving);
    if (status != SF_OK || out->n_undecided > 0)
        return status;
    proving.task.Omega = Omega;
    sf_prove(&proving, out->A_max);
    sf_leave_all_undecided(inputs, &room->proof, out);
    for (int i = 0; i < room->proof.n; i++)
        sf_enclose(out, sfi_point(Omega), room->proof.at[i].on.A, 0, room->proof.at[i].rising ? 1 : -1);
    sf_sort_enclosures(out, sf_is_higher);
    return SF_OK;
}

/* ==== Critical forcings =========================================================================================== */

/* What may be the lowest forcing. */
typedef struct {
    sf_interval level, Omega, A;
    sf_onset_kind kind;
} sf_candidate;

/* undecided: the lowest level that is undecided */
typedef struct {
    int n, full;
    sf_candidate at[SF_MOST_ZEROS];
    double undecided;
} sf_candidates;

/* Enters a level that is a minimum along the fold locus if `sign` is positive, none if it is negative. */
static void sf_enter(sf_candidates *list, sf_interval level, sf_interval Omega, sf_interval A, sf_onset_kind kind,
                     int sign) {
    if (sign == 0)
        list->undecided = sfi_least(list->undecided, level.lo);
    if (sign <= 0)
        return;
    if (list->n == SF_MOST_ZEROS) {
        list->full = 1;
        return;
    }
    list->at[list->n].level = level, list->at[list->n].Omega = Omega, list->at[list->n].A = A;
    list->at[list->n++].kind = kind;
}

static void sf_enter_isola(const sf_terms *terms, const sf_cell *on, sf_candidates *list) {
    const sf_interval Omega = slow_flow_intervals_isola_Omega(on->h_A);
    const sf_interval bend = slow_flow_intervals_isola_bend(Omega, on->A, terms->m, terms->zeta, on->h_AA);
    sf_enter(list, sf_level_on(terms, Omega, on), Omega, on->A, SF_ISOLA_KIND, sf_sign_of(bend));
}

static void sf_enter_cusp(const sf_terms *terms, const sf_cell *on, int channel, sf_candidates *list) {
    sf_cusp_range cusp = {0};
    sf_cusp_on(on, terms->m, terms->zeta, channel == 0, &cusp);
    const sf_interval Omega = sfi_sqrt(cusp.X);
    const sf_interval bend = slow_flow_intervals_cusp_bend(Omega, on->A, terms->zeta, on->h_AA, on->h_AAA, cusp.T);
    sf_enter(list, sfi_both(cusp.level, sf_level_on(terms, Omega, on)), Omega, on->A, SF_CUSP_KIND, sf_sign_of(bend));
}

/* Minima on breakpoint k, where the force jumps, see sf_consider_jump, or its slope: there the locus bends and does no
 * more. */
static void sf_enter_corners(const sf_inputs *inputs, const sf_terms *terms, int k, sf_candidates *list) {
    const sf_interval b = inputs->b[k];
    const int jumps = !sf_is_continuous_at(inputs, k), J = sf_sign_of(jumps ? inputs->jump[k] : inputs->kink[k]);
    sf_cell on;
    sf_proof roots;
    sf_breakpoint_on(inputs, k, &on);
    if (jumps && on.h.lo < 0 && J <= 0) {
        const sf_interval Omega = slow_flow_intervals_backbone(b, on.h);
        sf_enter(list, sf_level_on(terms, Omega, &on), Omega, b, SF_CORNER_KIND, on.h.hi < 0 ? -J : 0);
    }
    sf_at_amplitude q = sf_at_cell(SF_ROOTS_OF_F_A, terms, &on);
    for (int side = 0; side < 1 + jumps; side++, q.of = SF_ROOTS_OF_F_OMEGA) {
        sf_prove_roots(&q, &roots);
        list->full |= roots.full;
        for (int i = 0; i < roots.n + roots.n_undecided; i++) {
            const sf_interval m = terms->m, zeta = terms->zeta;
            sf_interval w;
            const int undecided = sf_take_root(&roots, i, &w);
            const int rises = -J * sf_sign_of(slow_flow_intervals_R(w, b, on.h));
            int one, other;
            if (q.of == SF_ROOTS_OF_F_A) {
                one = -sf_sign_of(slow_flow_intervals_level_rise(w, b, m, zeta, on.h, on.h_A, on.h_AA));
                other = rises * sf_sign_of(sfi_mul(slow_flow_intervals_F_Omega(w, b, m, zeta, on.h),
                                                   slow_flow_intervals_F_AOmega(w, b, m, zeta, on.h, on.h_A)));
            } else {
                one = rises * sf_sign_of(slow_flow_intervals_F_A(w, b, m, zeta, on.h, on.h_A));
                other = sf_sign_of(slow_flow_intervals_F_OmegaOmega(w, b, zeta, on.h));
            }
            sf_enter(list, sf_level_on(terms, w, &on), w, b, SF_CORNER_KIND,
                     undecided              ? 0
                     : one < 0 || other < 0 ? -1
                                            : one * other);
        }
    }
}

/* The lowest of what was entered. */
static void sf_lowest(const sf_candidates *list, sf_proved_onset *out) {
    int known = 0;
    out->F_SN = sfi_point(HUGE_VAL), out->kind = SF_NO_KIND;
    for (int i = 0; i < list->n; i++) {
        out->F_SN.lo = sfi_least(out->F_SN.lo, list->at[i].level.lo);
        out->F_SN.hi = sfi_least(out->F_SN.hi, list->at[i].level.hi);
    }
    for (int i = 0; i < list->n; i++) {
        const sf_candidate *one = &list->at[i];
        if (!(one->level.lo <= out->F_SN.hi))
            continue;
        out->Omega = known ? sfi_join(out->Omega, one->Omega) : one->Omega;
        out->A = known ? sfi_join(out->A, one->A) : one->A;
        out->kind = known && out->kind != one->kind ? SF_NO_KIND : one->kind;
        known = 1;
    }
}

/* F_cr, the least level on the first breakpoint: at Omega = 0 or where F_Omega vanishes. Each place that is tried is a
 * bound from above, and the least lies at one of them: so undecided places do no harm. */
static sf_status sf_certify_detachment(const sf_inputs *inputs, sf_interval *F_cr, sf_interval *Omega_cr) {
    const sf_terms terms = sf_terms_of(inputs, sfi_point(0));
    sf_candidates list;
    sf_proved_onset least;
    sf_proof roots;
    sf_cell on;
    if (inputs->breaks == 0)
        return SF_NONE;
    sf_breakpoint_on(inputs, 0, &on);
    const sf_at_amplitude q = sf_at_cell(SF_ROOTS_OF_F_OMEGA, &terms, &on);
    sf_prove_roots(&q, &roots);
    if (roots.full)
        return SF_UNRESOLVED;
    list.n = 0;
    for (int i = 0; i <= roots.n + roots.n_undecided; i++) {
        sf_interval w = sfi_point(0);
        if (i < roots.n + roots.n_undecided)
            sf_take_root(&roots, i, &w);
        sf_enter(&list, sf_level_on(&terms, w, &on), w, on.A, SF_CORNER_KIND, 1);
    }
    sf_lowest(&list, &least);
    *F_cr = least.F_SN, *Omega_cr = least.Omega;
    return SF_OK;
}

/* All that may be the lowest up to an amplitude, with levels up to F_0, and the lowest of that; what is undecided fills
 * the list.
 * Minima of the level along the fold locus are its cusps and isola points, ends of its pieces on breakpoints, and ends
 * at Omega = 0, where no fold is born. */
static void sf_enter_all(const sf_model *model, const sf_inputs *inputs, double F_0, double A_max, sf_proof *proof,
                         sf_candidates *list, sf_proved_onset *lowest) {
    sf_proving proving = sf_proving_of(inputs, SF_ISOLA, model, F_0, proof);
    const sf_terms *terms = &proving.task.terms;
    list->n = list->full = 0, list->undecided = HUGE_VAL;
    proving.task.most = &F_0;
    /* without friction both functions vanish at 0: amplitudes of 1e-60 and less are left out */
    proving.from = inputs->m.hi > 0 ? 0 : SF_FIRST;
    for (int i = 0; i < 2; i++, proving.task.question = SF_CUSP) {
        sf_prove(&proving, A_max);
        list->full |= proof->full || proof->n_undecided > 0;
        for (int k = 0; k < proof->n; k++)
            if (i == 0)
                sf_enter_isola(terms, &proof->at[k].on, list);
            else
                sf_enter_cusp(terms, &proof->at[k].on, proof->at[k].channel, list);
    }
    for (int k = 0; k < inputs->breaks; k++)
        sf_enter_corners(inputs, terms, k, list);
    sf_lowest(list, lowest);
}

/* Without viscous damping, whether folds come as near to m as one asks: their level is hypot(m, k), which is m at A = 0
 * only, and there they are as long as h_A < 0. */
static int sf_tends_to_friction(const sf_inputs *inputs) {
    sf_known first, last;
    sf_cell cell;
    double A = inputs->breaks > 0 ? sfi_least(inputs->b[0].lo, 1) : 1;
    sf_know_at(inputs, 0, 0, &first);
    for (; A > SF_FIRST; A *= 0.125) {
        sf_know_at(inputs, 0, A, &last);
        sf_make_cell_on(sfi_of(0, A), &first, &last, &cell);
        if (cell.h_A.hi < 0)
            return sfi_has_sign(last.k);
    }
    return 0;
}

/* The lowest forcing at which folds are born; what lies above the forcing that was found is left out. Where the
 * status is that there is none, whether that is proved. For zeta = 0 a lowest one is not proved. */
static sf_status sf_certify_onset(const sf_model *model, const sf_inputs *inputs, sf_room *room, sf_proved_onset *out) {
    sf_candidates list;
    sf_onset best;
    double A_max;
    sf_status status = sf_find_onset(model, &room->work, &best);
    out->proved = 0;
    if (status == SF_NONE && model->zeta > 0) { /* at any forcing, up to amplitudes that stand for infinite ones */
        sf_enter_all(model, inputs, HUGE_VAL, SF_ENDLESS, &room->proof, &list, out);
        out->proved = list.n == 0 && !list.full && list.undecided == HUGE_VAL;
    }
    if (status == SF_UNBOUNDED && model->zeta == 0)
        out->proved = sf_tends_to_friction(inputs);
    if (status != SF_OK)
        return status;
    const double F_0 = best.F_SN * (1 + SF_ABOVE_ONSET);
    status = sf_amplitude_bound(model, F_0, &A_max);
    if (status != SF_OK)
        return status;
    sf_enter_all(model, inputs, F_0, A_max, &room->proof, &list, out);
    out->proved = list.n > 0 && !list.full && sf_is_bounded(inputs, F_0, A_max) && list.undecided > out->F_SN.hi &&
                  out->F_SN.hi < F_0;
    return SF_OK;
}
