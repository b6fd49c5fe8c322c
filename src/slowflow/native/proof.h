/* Zeros along the amplitude, proved. Takes an oscillator's exact inputs and a question; returns intervals each of
 * which holds exactly one zero, and amplitudes between which doubles do not decide; elsewhere there is none.
 *
 * The search is that of scan.h, on intervals that hold the values: an interval of A is left when the function is proved
 * to have one sign on it, or to be monotone with proved signs at its ends. Newton's method on intervals makes a zero's
 * own interval narrow.
 */
#pragma once

#include "certificate.h"
#include "scan.h"

/* what is not decided after so many cells is left undecided */
#define SF_MOST_PROOF_CELLS 4000
/* in an interval that is narrower, relatively, a zero may lie on an end or be double: it is cut only as long as that
 * bounds it better, and not where the function ends */
#define SF_PROOF_NARROW 0x1p-36
/* nor one that ends so near to the beginning of its piece, relatively */
#define SF_PROOF_NEXT 0x1p-960

/* of the response, F = 0; of the fold locus, F_A = 0; of its peaks, F_Omega = 0 */
typedef enum { SF_ROOTS_OF_F, SF_ROOTS_OF_F_A, SF_ROOTS_OF_F_OMEGA } sf_roots_of;

typedef struct {
    sf_roots_of of;
    sf_interval A, h, h_A;
    sf_terms terms;
} sf_at_amplitude;

/* task: a question along the amplitude, of the inputs; at: NULL, or of what at one amplitude the roots in Omega are
 * looked for, which then takes the place of A; from: the first amplitude */
typedef struct {
    const sf_inputs *inputs;
    const sf_at_amplitude *at;
    sf_task task;
    int piece;
    double from;
    sf_proof *out;
} sf_proving;

/* range: the functions there, once they have been evaluated */
typedef struct {
    sf_known known;
    sf_range range[2];
    int task;
} sf_checked;

static inline sf_terms sf_terms_of(const sf_inputs *inputs, sf_interval F_0) {
    sf_terms terms;
    terms.m = inputs->m, terms.zeta = inputs->zeta, terms.F_0 = F_0;
    terms.least = slow_flow_intervals_least_restoring(F_0, inputs->m);
    return terms;
}

/* About zeros from A = 0 on. */
static inline sf_proving sf_proving_of(const sf_inputs *inputs, sf_question question, const sf_model *model, double F_0,
                                       sf_proof *out) {
    sf_proving proving;
    memset(&proving, 0, sizeof proving);
    proving.inputs = inputs, proving.out = out;
    proving.task = sf_task_of(question, model, F_0), proving.task.terms = sf_terms_of(inputs, sfi_point(F_0));
    return proving;
}

/* ==== Functions of Omega at one amplitude ========================================================================= */

static sf_at_amplitude sf_at_cell(sf_roots_of of, const sf_terms *terms, const sf_cell *cell) {
    return (sf_at_amplitude){of, cell->A, cell->h, cell->h_A, *terms};
}

static void sf_value_on(const sf_at_amplitude *q, sf_interval w, sf_interval *y, sf_interval *dy) {
    const sf_interval A = q->A, h = q->h, m = q->terms.m, zeta = q->terms.zeta;
    if (q->of == SF_ROOTS_OF_F) {
        *y = slow_flow_intervals_F(w, A, q->terms.F_0, m, zeta, h);
        *dy = slow_flow_intervals_F_Omega(w, A, m, zeta, h);
    } else if (q->of == SF_ROOTS_OF_F_A) {
        *y = slow_flow_intervals_F_A(w, A, m, zeta, h, q->h_A);
        *dy = slow_flow_intervals_F_AOmega(w, A, m, zeta, h, q->h_A);
    } else {
        sf_interval reduced[2];
        if (m.hi == 0)
            slow_flow_intervals_F_Omega_reduced_mu0(w, A, zeta, h, reduced);
        else if (zeta.hi == 0)
            slow_flow_intervals_F_Omega_reduced_zeta0(w, A, h, reduced);
        else
            slow_flow_intervals_F_Omega_reduced(w, A, m, zeta, h, reduced);
        *y = reduced[0], *dy = reduced[1];
    }
}

/* Beyond this frequency there is no root: R exceeds F_0 there, or is positive with Omega^2 + h_A. */
static double sf_highest_root(const sf_at_amplitude *q) {
    const sf_interval level = q->of == SF_ROOTS_OF_F ? q->terms.F_0 : sfi_point(0);
    const double highest = slow_flow_intervals_backbone(q->A, sfi_sub(q->h, level)).hi;
    return q->of == SF_ROOTS_OF_F_A ? sfi_most(highest, slow_flow_intervals_undamped_Omega(q->h_A).hi) : highest;
}

/* ==== One cell ==================================================================================================== */

static sf_checked sf_check_at(const sf_proving *proving, double x) {
    sf_checked out;
    out.known.A = x, out.task = 0;
    if (proving->at == NULL)
        sf_know_at(proving->inputs, proving->piece, x, &out.known);
    return out;
}

static void sf_range_between(const sf_proving *proving, const sf_checked *a, const sf_checked *b, int open,
                             sf_cell *cell, sf_range range[2]) {
    const sf_interval A = sf_beyond(proving->inputs, proving->piece, sfi_of(a->known.A, b->known.A));
    const sf_task *task = &proving->task;
    range[0].where = range[1].where = SF_NOWHERE, range[0].edge = range[1].edge = 0;
    range[0].ddy = range[1].ddy = sfi_of(-HUGE_VAL, HUGE_VAL);
    if (proving->at != NULL) {
        range[0].where = SF_THROUGHOUT;
        sf_value_on(proving->at, A, &range[0].y, &range[0].dy);
        return;
    }
    sf_make_cell_on(A, &a->known, &b->known, cell);
    if (task->question == SF_STATE) /* the inputs are exact: all slopes of F are as sharp as F */
        sf_range_state(&task->terms, sfi_point(task->Omega), cell, &range[0]);
    else
        sf_find_range(task, &a->known, cell, open, range);
}

/* A function at something known. */
static const sf_range *sf_value_at(const sf_proving *proving, sf_checked *at, int c) {
    sf_cell cell;
    if (!at->task)
        sf_range_between(proving, at, at, 3, &cell, at->range);
    at->task = 1;
    return &at->range[c];
}

/* 1: one zero, from below; -1: one, from above; 0: none; 2: not known. last: if it need not be separated from the
 * end of the query, which smaller cells may do. The slope's range becomes narrower where its own slope is known. */
static int sf_crossing(const sf_proving *proving, sf_checked *a, sf_checked *b, int c, sf_range *range, int last) {
    const double width = sfi_up(b->known.A - a->known.A);
    if (range->where == SF_NOWHERE || sfi_has_sign(range->y))
        return 0;
    if (range->where != SF_THROUGHOUT && range->edge == 0)
        return 2;
    const sf_range *at_a = sf_value_at(proving, a, c), *at_b = sf_value_at(proving, b, c);
    const sf_interval low = at_a->y, high = at_b->y;
    /* it ends in between, with a sign that is known */
    if (range->edge != 0 && last && sfi_has_sign(range->dy)) {
        if (at_a->where == SF_NOWHERE && at_b->where == SF_THROUGHOUT && sfi_has_sign(high))
            return sfi_positive(high) == (range->edge > 0) ? 0 : -range->edge;
        if (at_b->where == SF_NOWHERE && at_a->where == SF_THROUGHOUT && sfi_has_sign(low))
            return sfi_positive(low) == (range->edge > 0) ? 0 : range->edge;
    }
    if (range->where != SF_THROUGHOUT)
        return 2;
    if (at_a->where != SF_THROUGHOUT || at_b->where != SF_THROUGHOUT)
        return 2;
    range->dy = sfi_both(range->dy, sf_along(at_a->dy, at_b->dy, range->ddy, width));
    if (sfi_has_sign(sfi_both(range->y, sf_along(low, high, range->dy, width))))
        return 0;
    if (!(sfi_has_sign(range->dy) && sfi_has_sign(low) && sfi_has_sign(high)))
        return 2;
    return sfi_positive(low) == sfi_positive(high) ? 0 : sfi_negative(low) ? 1 : -1;
}

/* The one zero between two amplitudes, made narrow: by Newton's method on intervals, until that gains no more. The
 * first step, from where cells are cut, which may be next to an end, need not gain. */
static void sf_narrow(const sf_proving *proving, sf_checked *a, sf_checked *b, int c, sf_range range,
                      sf_interval *beyond, sf_cell *cell) {
    *beyond = sfi_of(a->known.A, b->known.A);
    for (int i = 0; i < SF_MOST_STEPS; i++) {
        const double low = beyond->lo, high = beyond->hi, x = i == 0 ? sf_amid(0, low, high) : 0.5 * low + 0.5 * high;
        sf_range on[2];
        if (!(x > low && x < high))
            return;
        sf_checked at = sf_check_at(proving, x);
        const sf_range *there = sf_value_at(proving, &at, c);
        if (there->where != SF_THROUGHOUT)
            return;
        const sf_interval next = sfi_both(*beyond, sfi_sub(sfi_point(x), sfi_div(there->y, range.dy)));
        if (!(next.lo <= next.hi) || !(i == 0 || next.hi - next.lo < 0.75 * (high - low)))
            return;
        if (next.lo > low)
            *a = sf_check_at(proving, next.lo);
        if (next.hi < high)
            *b = sf_check_at(proving, next.hi);
        *beyond = next;
        sf_range_between(proving, a, b, 1 << c, cell, on);
        if (on[c].where == SF_THROUGHOUT && sfi_has_sign(on[c].dy))
            range = on[c];
    }
}

static void sf_add_proven(const sf_proving *proving, const sf_checked *a, const sf_checked *b, int c,
                          const sf_range *range, const sf_cell *cell, int rising) {
    sf_proof *out = proving->out;
    sf_checked low = *a, high = *b;
    if (out->n == SF_MOST_ZEROS) {
        out->full = 1;
        return;
    }
    out->at[out->n].on = *cell, out->at[out->n].channel = c, out->at[out->n].rising = rising;
    out->at[out->n].piece = proving->piece;
    sf_narrow(proving, &low, &high, c, *range, &out->at[out->n].beyond, &out->at[out->n].on);
    out->n++;
}

static void sf_add_undecided(sf_proof *out, double low, double high, int piece, int c) {
    for (int i = 0; i < out->n_undecided; i++)
        if (out->undecided[i].channel == c && out->undecided[i].piece == piece && out->undecided[i].low == high) {
            out->undecided[i].low = low;
            return;
        }
    if (out->n_undecided == SF_MOST_UNDECIDED) {
        out->full = 1;
        return;
    }
    out->undecided[out->n_undecided].low = low, out->undecided[out->n_undecided].high = high;
    out->undecided[out->n_undecided].piece = piece, out->undecided[out->n_undecided++].channel = c;
}

/* Whether smaller cells bound a function no better: one that only rises or falls has its zero next to an end. What is
 * narrow against its amplitudes need not be so against how far these lie above their breakpoint. */
static int sf_is_cut_enough(const sf_proving *proving, sf_checked *a, sf_checked *b, int c, const sf_range *range) {
    const double low = a->known.A, high = b->known.A;
    const int narrow = high - low <= SF_PROOF_NARROW * high;
    if (!(high - low <= SF_PROOF_NARROW * (sf_beginning(proving->inputs, proving->piece).lo + high)))
        return 0;
    if (range->where != SF_THROUGHOUT || sfi_has_sign(range->dy))
        return narrow;
    const sf_range *at_a = sf_value_at(proving, a, c), *at_b = sf_value_at(proving, b, c);
    if (at_a->where != SF_THROUGHOUT || at_b->where != SF_THROUGHOUT)
        return narrow;
    return sf_is_noise(range->y, at_a->y, at_b->y);
}

static void sf_prove_between(const sf_proving *proving, sf_checked *a, sf_checked *b, int open) {
    const double low = a->known.A, high = b->known.A, x = sf_amid(0, low, high);
    const int end = !(x > low && x < high) ||
                    high <= SF_PROOF_NEXT * sf_beginning(proving->inputs, proving->piece).lo ||
                    proving->out->cells++ >= SF_MOST_PROOF_CELLS;
    sf_range range[2];
    sf_cell cell;
    sf_range_between(proving, a, b, open, &cell, range);
    for (int c = 0; c < 2; c++) {
        if (!(open & 1 << c))
            continue;
        const int last = end || sf_is_cut_enough(proving, a, b, c, &range[c]);
        const int crossing = sf_crossing(proving, a, b, c, &range[c], last);
        if (crossing == 1 || crossing == -1)
            sf_add_proven(proving, a, b, c, &range[c], &cell, crossing == 1);
        else if (crossing == 2 && last)
            sf_add_undecided(proving->out, low, high, proving->piece, c);
        if (crossing != 2 || last)
            open &= ~(1 << c);
    }
    if (open == 0)
        return;
    sf_checked middle = sf_check_at(proving, x);
    /* what is hard lies above a breakpoint more often than not: it comes last */
    sf_prove_between(proving, &middle, b, open);
    sf_prove_between(proving, a, &middle, open);
}

/* Whether a zero of the channel that was found lies there. */
static int sf_holds_proven(const sf_proof *out, double low, double high, int piece, int c) {
    for (int i = 0; i < out->n; i++)
        if (out->at[i].channel == c && out->at[i].piece == piece && out->at[i].beyond.hi >= low &&
            out->at[i].beyond.lo <= high)
            return 1;
    return 0;
}

/* What is undecided from number `first` on once more, each with something around it: a zero may have lain on a
 * cell's end. */
static void sf_look_again(const sf_proving *proving, double least, double most, int first) {
    sf_proof *out = proving->out;
    int kept = first;
    for (int i = first; i < out->n_undecided; i++) {
        const sf_undecided_between open = out->undecided[i];
        double around = open.high - open.low;
        int settled = 0;
        for (int k = 0; k < 4 && !settled; k++) {
            sf_range range[2];
            sf_cell cell;
            around *= 16;
            if (!(open.low - around > least && open.high + around < most))
                break;
            sf_checked a = sf_check_at(proving, open.low - around);
            sf_checked b = sf_check_at(proving, open.high + around);
            sf_range_between(proving, &a, &b, 1 << open.channel, &cell, range);
            const int crossing = sf_crossing(proving, &a, &b, open.channel, &range[open.channel], 1);
            settled = crossing != 2;
            if (settled && crossing != 0 && !sf_holds_proven(out, a.known.A, b.known.A, open.piece, open.channel))
                sf_add_proven(proving, &a, &b, open.channel, &range[open.channel], &cell, crossing == 1);
        }
        if (!settled)
            out->undecided[kept++] = open;
    }
    out->n_undecided = kept;
}

static void sf_clear_proof(sf_proof *out) { out->n = out->n_undecided = out->cells = out->full = 0; }

/* All zeros between two places on a piece. */
static void sf_prove_on(const sf_proving *proving, sf_checked *first, sf_checked *last, int open) {
    const int before = proving->out->n_undecided;
    first->task = last->task = 0;
    sf_prove_between(proving, first, last, open);
    sf_look_again(proving, first->known.A, last->known.A, before);
}

/* All zeros up to A_max, piece by piece. */
static void sf_prove(sf_proving *proving, double A_max) {
    const sf_inputs *inputs = proving->inputs;
    sf_checked first, last;
    sf_clear_proof(proving->out);
    for (int i = 0; i <= inputs->breaks; i++) {
        const int ends = i < inputs->breaks && inputs->b[i].lo < A_max;
        proving->piece = i;
        if (i > 0)
            sf_know_above(inputs, i - 1, &first.known);
        else
            sf_know_at(inputs, 0, proving->from, &first.known);
        if (ends)
            sf_know_below(inputs, i, &last.known);
        else
            sf_know_at(inputs, i, sfi_up(A_max - sf_beginning(inputs, i).lo), &last.known);
        sf_prove_on(proving, &first, &last, sf_channels(proving->task.question));
        if (!ends)
            return;
    }
}

/* The roots in Omega at one amplitude between two frequencies. */
static void sf_prove_roots_between(const sf_at_amplitude *q, double low, double high, sf_proof *out) {
    const sf_proving proving = {.at = q, .out = out};
    sf_checked first = sf_check_at(&proving, low), last = sf_check_at(&proving, high);
    sf_clear_proof(out);
    if (high < HUGE_VAL)
        sf_prove_on(&proving, &first, &last, 1);
    else
        out->full = 1;
}

/* All of them, looked for twice as far as they may lie: none lies on the end of the search. */
static void sf_prove_roots(const sf_at_amplitude *q, sf_proof *out) {
    sf_prove_roots_between(q, 0, 2 * sf_highest_root(q), out);
}

/* Root number i, of which those that are undecided come last; whether it is one of them. */
static int sf_take_root(const sf_proof *roots, int i, sf_interval *Omega) {
    const int undecided = i >= roots->n;
    const sf_undecided_between *open = &roots->undecided[undecided ? i - roots->n : 0];
    *Omega = undecided ? sfi_of(open->low, open->high) : roots->at[i].beyond;
    return undecided;
}

/* The one root in an interval on which the slope has a sign. */
static sf_interval sf_narrow_root(const sf_at_amplitude *q, sf_interval w) {
    const sf_proving proving = {.at = q};
    sf_checked low = sf_check_at(&proving, w.lo), high = sf_check_at(&proving, w.hi);
    sf_range range[2];
    sf_cell cell;
    sf_range_between(&proving, &low, &high, 1, &cell, range);
    sf_narrow(&proving, &low, &high, 0, range[0], &w, &cell);
    return w;
}
