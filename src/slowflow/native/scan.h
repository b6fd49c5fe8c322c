/* Zeros along the amplitude. Takes a piece of the force and a question; returns all its zeros.
 *
 * None is missed: an interval of A is left only when it is proved to hold no zero of a channel, because the function
 * has one sign on all of it, or exactly one, because it is monotone and its ends lie on both sides of zero. Otherwise
 * it is cut in two. What bounds a function and its slope on the interval is in cells.h and along.h.
 *
 * Where that goes on until no amplitude lies between the ends (a double zero to rounding), the signs at the ends
 * decide, and that it was undecided is returned.
 */
#pragma once

#include "design_lanes.h"
#include "zeros.h"

/* of a cell in which cusps are looked for: the ratio of its ends up to which it is worth a look before it is cut, and
 * up to which one with a cusp in it is */
#define SF_WIDEST_CELL 4
#define SF_WIDEST_WITH_CUSP 2

/* A cell in which folds begin is cut at this share of where they seem to, and one that begins there at this multiple of
 * its beginning. */
#define SF_BELOW_FOLDS 0.99
#define SF_FIRST_FOLDS 1.25

/* A cell of states at whose beginning the force's slope has no limit is cut if the ratio of its ends is larger. */
#define SF_WIDEST_STEEP 2

/* no step beyond the last evaluation next to a zero is larger, relatively */
#define SF_LAST_OF_ZERO 0x1p-30

typedef struct {
    sf_task task;
    double base, end; /* where the piece begins and ends */
    sf_zeros *found;
} sf_search;

/* known: of those between which cells lie */
typedef struct {
    sf_sample at;
    sf_known known;
    sf_answer answer;
} sf_probe;

static void sf_probe_at(const sf_search *search, int open, double A, sf_probe *probe) {
    if (search->task.question == SF_PEAK || search->task.question == SF_REST)
        probe->at = sf_sample_without_k_at(search->task.model, A);
    else
        probe->at = sf_sample_at(search->task.model, A);
    sf_ask(&search->task, open, &probe->at, &probe->answer);
}

/* What a force, or its average, may be as large as at a sample; a stiffness of 1 is that of the vertical spring. */
static double sf_size_at(const sf_sample *at, double F_0) { return F_0 + fabs(at->h) + at->A * (1 + fabs(at->h_A)); }

/* What rounding may make of F = R^2 + I^2 - F_0^2 at a sample. */
static double sf_error_of_F(const sf_sample *at, double I, double F_0, double w) {
    const double R = slow_flow_R(w, at->A, at->h), of_R = SF_CLOSE * (sf_size_at(at, 0) + at->A * w * w);
    return of_R * (2 * fabs(R) + of_R) + SF_CLOSE * (I * I + F_0 * F_0);
}

static int sf_is_F_close(const sf_model *model, const sf_sample *at, double F_0, double w) {
    const int laws = model->by_laws;
    const double m = laws ? sf_law_I(model, at->A, w) : model->m, zeta = laws ? 0 : model->zeta; /* the same I */
    const double force = sf_force(model, F_0, w), I = slow_flow_I(w, at->A, m, zeta);
    return fabs(slow_flow_F(w, at->A, force, m, zeta, at->h)) <= sf_error_of_F(at, I, force, w);
}

/* Whether the function whose zeros are folds, or states, is as near to 0 as rounding may bring it. Two of its zeros
 * that are about to meet, or have met, lead the search there. Omega in it follows from I, as in sf_fold_Omega. */
static int sf_is_close(const sf_search *search, const sf_probe *probe) {
    const sf_task *task = &search->task;
    const sf_sample *at = &probe->at;
    const double zeta = task->model->zeta, Omega = probe->answer.Omega[0];
    double size = sf_size_at(at, task->F_0);
    if (task->question == SF_STATE) /* above a breakpoint F is what it is below */
        return fabs(at->h_A) < HUGE_VAL && sf_is_F_close(task->model, at, task->F_0, task->Omega);
    if (task->question != SF_FOLD_AT || !probe->answer.exists[0] || !(fabs(at->h_A) < HUGE_VAL))
        return 0;
    if (zeta > 0) {
        const double least = task->least / at->k;
        size += Omega * slow_flow_I(Omega, at->A, task->model->m, zeta) /
                (zeta * fmax((1 - least) * (1 + least), SF_CLOSE));
    } else {
        size *= size;
    }
    return fabs(probe->answer.y[0]) <= SF_CLOSE * size;
}

/* The sign of a channel at a probe; where it ends before that, its sign at the end. */
static int sf_is_negative(const sf_probe *probe, int channel, int edge) {
    return probe->answer.exists[channel] ? probe->answer.y[channel] < 0 : edge < 0;
}

/* Omega at the zero itself, which lies within roundings of A: where h_A is large, but no limit, that shifts Omega by
 * much. */
static double sf_Omega_at_zero(const sf_probe *probe, int channel) {
    const double Omega_A = probe->answer.Omega_A[channel];
    const double beyond = probe->answer.y[channel] / probe->answer.dy[channel];
    if (Omega_A != 0 && fabs(Omega_A) < HUGE_VAL && fabs(beyond) <= SF_AT_ROOT * probe->at.A)
        return probe->answer.Omega[channel] - Omega_A * beyond;
    return probe->answer.Omega[channel];
}

/* Where the parabola vanishes that has one value with its slope and another value, on the other side of zero. */
static double sf_between_values(const sf_probe *near, const sf_probe *far, int c) {
    const double width = far->at.A - near->at.A, y = near->answer.y[c], rise = near->answer.dy[c] * width;
    const double bend = far->answer.y[c] - y - rise;
    return near->at.A - 2 * y * width / (rise + copysign(sqrt(rise * rise - 4 * bend * y), -y));
}

/* Where a function may vanish next to a probe: by the probe before it too, or by Newton's step. first: whether the two
 * lie on either side */
static double sf_next_to(const sf_probe *probe, const sf_probe *before, int c, int first) {
    double next = NAN;
    if (first)
        next = sf_between_values(probe, before, c);
    else if (fabs(probe->answer.y[c]) < 0.5 * fabs(before->answer.y[c]))
        next = sf_zero_near(probe->at.A, probe->answer.y[c], probe->answer.dy[c], before->at.A, before->answer.y[c],
                            before->answer.dy[c]);
    return fabs(next) < HUGE_VAL ? next : probe->at.A - probe->answer.y[c] / probe->answer.dy[c];
}

/* Whether a zero is known without an evaluation there, which only one that has a given Omega may be: the step after one
 * of `moved`, which came after one of `last`, is negligible against A. Errors fall by squares at least. */
static int sf_is_last_of_zero(const sf_search *search, double change, double last, double A) {
    return search->task.question == SF_STATE && change <= SF_LAST_OF_ZERO * A &&
           change * (change / last) * (change / last) <= 0x1p-54 * A;
}

/* The zero between two probes with values on either side of it: steps from the last two values, kept in the bracket. */
static void sf_find_zero(const sf_search *search, const sf_probe *a, const sf_probe *b, int c, int edge) {
    const int rising = sf_is_negative(a, c, edge);
    const int is_first = fabs(a->answer.y[c]) < fabs(b->answer.y[c]) && fabs(a->answer.dy[c]) < HUGE_VAL;
    const sf_probe *lo = a, *hi = b, *probe = is_first ? a : b;
    const sf_probe *before = probe == a ? b : a;
    double last = b->at.A - a->at.A, step = 0;
    sf_probe place[4]; /* up to three of them are lo, hi and before */
    sf_zero zero;
    if (!probe->answer.exists[c])
        probe = a->answer.exists[c] ? a : b;
    for (int i = 0; i < 400; i++) {
        double next = probe->answer.exists[c] ? sf_next_to(probe, before, c, i == 0) : NAN;
        double change = fabs(next - probe->at.A);
        sf_probe *spare = &place[0];
        if (i > 0 && change <= 0x1p-52 * probe->at.A)
            break;
        if (i > 0 && next > lo->at.A && next < hi->at.A && sf_is_last_of_zero(search, change, last, probe->at.A)) {
            step = next - probe->at.A;
            break;
        }
        if (!(next > lo->at.A && next < hi->at.A) || change > SF_SLOW * last) {
            next = sf_amid(search->base, lo->at.A, hi->at.A);
            change = fabs(next - probe->at.A);
            if (!(next > lo->at.A && next < hi->at.A))
                break;
        }
        last = change, before = probe;
        while (spare == lo || spare == hi || spare == before)
            spare++;
        sf_probe_at(search, 1 << c, next, spare);
        probe = spare;
        if (sf_is_negative(probe, c, edge) == rising)
            lo = probe;
        else
            hi = probe;
    }
    if (!probe->answer.exists[c])
        probe = lo->answer.exists[c] ? lo : hi;
    zero.A = probe->at.A + step, zero.Omega = sf_Omega_at_zero(probe, c);
    zero.level = probe->answer.level[c];
    zero.question = search->task.question, zero.channel = c, zero.rising = rising;
    sf_add_zero(search->found, zero);
    if (search->task.most != NULL && sf_is_minimum(search->task.model, zero.question, &probe->at, zero.Omega))
        *search->task.most = fmin(*search->task.most, probe->answer.level[c]);
}

/* What F_A of a steady state is at a probe, but for roundings. */
static sf_interval sf_F_A_within(const sf_search *search, const sf_probe *probe) {
    const sf_model *model = search->task.model;
    const sf_sample *at = &probe->at;
    const double w = search->task.Omega, I_A = slow_flow_I(w, 1, 0, model->zeta), dy = probe->answer.dy[0];
    const double I = slow_flow_I(w, at->A, model->m, model->zeta);
    const double size = (fabs(at->h) + at->A * w * w) * (fabs(at->h_A) + w * w) + I * I_A;
    return sfi_of(dy - SF_CLOSE * size, dy + SF_CLOSE * size);
}

/* Whether a channel is settled on an interval, its zero being found if it has one; `last`: settled anyway. */
static int sf_settle(const sf_search *search, const sf_probe *a, const sf_probe *b, int c, const sf_range *range,
                     int last) {
    const int both = a->answer.exists[c] && b->answer.exists[c];
    const int passes = both && sf_opposite(a->answer.y[c], b->answer.y[c]);
    const int edge = range->edge == 0 && last && a->answer.edge == b->answer.edge ? a->answer.edge : range->edge;
    const double width = b->at.A - a->at.A;
    sf_interval y = range->y, dy = range->dy;
    if (range->where == SF_NOWHERE || sfi_has_sign(y))
        return 1;
    if (search->task.question == SF_STATE && !sfi_has_sign(dy))
        dy = sfi_both(dy, sf_along(sf_F_A_within(search, a), sf_F_A_within(search, b), range->ddy, sfi_up(width)));
    if (range->where == SF_THROUGHOUT && both && !passes) /* values may differ by roundings more than slopes allow */
        y = sfi_both(y, sf_between(a->answer.y[c], b->answer.y[c], dy, width));
    if (sfi_has_sign(y))
        return 1;
    if (!sfi_has_sign(dy) && !(search->task.question == SF_ISOLA && range->once)) {
        if (!last)
            return 0;
        search->found->undecided = 1;
    }
    if (both && (last || range->where == SF_THROUGHOUT)) {
        if (passes)
            sf_find_zero(search, a, b, c, 0);
        return 1;
    }
    if (edge != 0 && a->answer.exists[c] != b->answer.exists[c]) {
        if (sf_is_negative(a, c, edge) != sf_is_negative(b, c, edge))
            sf_find_zero(search, a, b, c, edge);
        return 1;
    }
    if (last && a->answer.exists[c] != b->answer.exists[c] && a->answer.edge * b->answer.edge < 0)
        search->found->undecided = 1; /* it ends where its sign there turns, which doubles do not resolve */
    return last;
}

/* A channel that is open and has values on either side of zero at the ends of a cell; -1 where there is none. */
static int sf_passing(const sf_probe *a, const sf_probe *b, int open) {
    for (int c = 0; c < 2; c++)
        if ((open & 1 << c) && a->answer.exists[c] && b->answer.exists[c] &&
            sf_opposite(a->answer.y[c], b->answer.y[c]))
            return c;
    return -1;
}

/* Whether the channel of folds begins in a cell of the first piece: where |k|, which rises there nearly as a cube of A,
 * is the least. */
static int sf_folds_begin(const sf_search *search, const sf_probe *a, const sf_probe *b) {
    return search->task.question == SF_FOLD_AT && search->task.model->zeta > 0 && search->base == 0 &&
           !a->answer.exists[0] && b->answer.exists[0] && b->at.A > SF_FIRST_FOLDS * a->at.A;
}

/* Where such a cell is cut: below the beginning, next to it, and then above, so that little is left of it. */
static double sf_cut_at_folds(const sf_search *search, const sf_probe *a, const sf_probe *b) {
    const double below = SF_BELOW_FOLDS * b->at.A * cbrt(search->task.least / fabs(b->at.k));
    if (below > (1 + 0x1p-10) * a->at.A)
        return below;
    return a->at.A > 0 ? SF_FIRST_FOLDS * a->at.A : sf_amid(0, a->at.A, b->at.A);
}

/* Whether a cell is cut without a look. Where a function passes through zero and its slopes at the ends differ in sign,
 * none settles it; all of a piece, and orders of magnitude, are seldom settled where cusps are, a slope without limit
 * where states are. */
static int sf_is_too_wide(const sf_search *search, const sf_probe *a, const sf_probe *b, int open, int passing) {
    const double low = a->at.A, high = b->at.A;
    const int turns = passing >= 0 && open == 1 << passing && a->answer.dy[passing] * b->answer.dy[passing] < 0;
    if (search->task.question == SF_CUSP)
        return (high > (passing < 0 ? SF_WIDEST_CELL : SF_WIDEST_WITH_CUSP) * low &&
                (low > 0 || high == search->end)) ||
               turns;
    if (search->task.question == SF_STATE && search->base > 0 && !(fabs(a->at.h_A) < HUGE_VAL))
        return high > SF_WIDEST_STEEP * low;
    return turns || sf_folds_begin(search, a, b);
}

/* Where a cell is cut: well inside; where folds begin, there; and next to A = 0, where there is a state as often as
 * elsewhere, in the middle. */
static double sf_cut(const sf_search *search, const sf_probe *a, const sf_probe *b) {
    if (sf_folds_begin(search, a, b))
        return sf_cut_at_folds(search, a, b);
    if (search->task.question == SF_STATE && a->at.A == 0)
        return 0.5 * b->at.A;
    return sf_amid(search->base, a->at.A, b->at.A);
}

static void sf_search_between(const sf_search *search, const sf_probe *a, const sf_probe *b, int open) {
    const int passing = sf_passing(a, b, open);
    const double A = sf_cut(search, a, b);
    const int last = !(A > a->at.A && A < b->at.A) || b->at.A - a->at.A <= SF_NARROW * b->at.A;
    sf_probe middle;
    sf_range range[2];
    sf_cell cell;
    if (search->found->cells++ == SF_MOST_CELLS || isnan(a->at.h) || isnan(b->at.h)) /* an average that is not known */
        search->found->status = SF_UNRESOLVED;
    if (search->found->status != SF_OK)
        return;
    if (last || !sf_is_too_wide(search, a, b, open, passing)) {
        sf_make_cell(search->task.model, &a->known, &b->known, &cell);
        sf_find_range(&search->task, &a->known, &cell, open, range);
        for (int c = 0; c < 2; c++)
            if ((open & 1 << c) && sf_settle(search, a, b, c, &range[c], last))
                open &= ~(1 << c);
        if (open == 0)
            return;
    }
    sf_probe_at(search, open, A, &middle);
    search->found->close |= sf_is_close(search, &middle);
    sf_know(&middle.at, &middle.known);
    if (search->task.highest) {
        sf_search_between(search, &middle, b, open);
        if (sf_top(search->found, search->task.pushes) == NULL)
            sf_search_between(search, a, &middle, open);
        return;
    }
    sf_search_between(search, a, &middle, open);
    sf_search_between(search, &middle, b, open);
}

/* Whether cells from A = 0 on are searched for something over A that has no limit there: with a preload h is not 0. */
static int sf_begins_above_rest(sf_question question, const sf_sample *rest) {
    const int over_A =
        question == SF_STIFFNESS || question == SF_TURN || question == SF_UNDAMPED || question == SF_PEAK;
    return over_A && rest->h != 0;
}

/* All zeros of a question's channels on a piece, added to those found; a zero at its last amplitude counts, one at A =
 * 0 does not. */
static void sf_find_zeros(const sf_task *task, const sf_stretch *piece, sf_zeros *found) {
    sf_search search = {*task, piece->first.A, piece->last.A, found};
    const int open = sf_channels(task->question);
    sf_probe low, high;
    search.task.first = &piece->first;
    low.at = piece->first, high.at = piece->last;
    sf_ask(&search.task, open, &low.at, &low.answer);
    sf_ask(&search.task, open, &high.at, &high.answer);
    if (low.at.A == 0 &&
        (sf_begins_above_rest(task->question, &low.at) || (low.answer.exists[0] && low.answer.y[0] == 0) ||
         (low.answer.exists[1] && low.answer.y[1] == 0)))
        sf_probe_at(&search, open, SF_FIRST, &low);
    found->close |= sf_is_close(&search, &low) | sf_is_close(&search, &high);
    sf_know(&low.at, &low.known);
    sf_know(&high.at, &high.known);
    sf_search_between(&search, &low, &high, open);
}
