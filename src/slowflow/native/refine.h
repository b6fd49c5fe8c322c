/* Answers to their last digit. Takes an answer as the solvers found it; returns the double next to the exact one
 * of the oscillator as it was given.
 *
 * Newton's method on the equations that define the answer (derivations/systems/newton.py), their values in
 * double-double, their slopes in doubles: one step, but next to a double root or a breakpoint. An answer is left
 * alone where the first step is not small against it, or the slopes change along it by too much: there it may lead
 * to another answer. */
#pragma once

#include "exact_inputs.h"
#include "onset.h"

/* no first step is larger, relatively, or changes a slope by a larger share */
#define SF_LARGEST_STEP 0x1p-6
#define SF_LARGEST_TURN 0.25
/* steps are followed by another one while this is left to do, relatively; and a first one that is larger than this */
#define SF_LEFT_TO_DO 0x1p-58
#define SF_FEW_ROUNDINGS 0x1p-49
/* an answer that does not settle, and is off by more, relatively, has too few digits */
#define SF_FEW_DIGITS 0x1p-30
/* how far an answer is looked for from what doubles found, where Newton's method fails: so many doublings of a
 * double */
#define SF_ONE_DOUBLE 0x1p-52
enum { SF_MOST_DOUBLINGS = 32 };
/* the square of a step to a level is left out */
#define SF_LEVEL_STEP 0x1p-30
/* a square of this times a rounding is some rounding */
#define SF_SHARP 0x1p25
/* by how much the next step may be larger; and where a few last places change slopes by their size, as next to an end
 * of the force where it is singular: there the others still are near */
#define SF_LARGER 2
#define SF_LARGER_NEARBY 64
enum { SF_MOST_SETTLING = 8, SF_MOST_ABOVE = 24 };

typedef void (*sf_step)(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A,
                        sf_pair h_AA, sf_pair h_AAA, double *out);

/* An answer on its way, with its forcing */
typedef struct {
    sf_pair Omega, A, F_0;
} sf_settling;

/* Which of them an answer has: the last, the first two, or all */
typedef enum { SF_VARY_A = 1, SF_VARY_BOTH, SF_VARY_ALL } sf_varied;

static inline void sf_take_step(sf_step step, const sf_exactly *exactly, const sf_exact_sample *at,
                                const sf_settling *of, double out[4]) {
    step(of->Omega, at->A, of->F_0, exactly->m, exactly->zeta, at->h[0], at->h[1], at->h[2], at->h[3], out);
}

static inline void sf_change_by(sf_pair *x, double change) { *x = sfp_add(*x, sfp_point(change)); }

/* Whether a step is one to take, after one of the size `before`; last: whether the next would change nothing. size: of
 * the step, relatively. Errors fall by squares, or, as slopes are doubles, by the same share again: the next step is to
 * this one as this one to the one before; of the first only the slope's turn may be known, which is not all where a
 * peak is as sharp as rounding. */
static inline int sf_is_step(double size, double turn, double before, int *last) {
    const double ratio = before < HUGE_VAL ? size / before : size <= SF_FEW_ROUNDINGS ? fmax(fabs(turn), size) : 1;
    const double larger = before < SF_FEW_DIGITS ? SF_LARGER_NEARBY : SF_LARGER;
    *last = size * ratio <= SF_LEFT_TO_DO;
    return size <= fmin(SF_LARGEST_STEP, larger * before) && fabs(turn) <= SF_LARGEST_TURN;
}

/* The piece of the force that an amplitude reaches, by its number. */
static inline int sf_piece_of(const sf_model *model, double A) {
    int piece = 0;
    while (piece < model->breaks && A > model->b[piece])
        piece++;
    return piece;
}

/* Of a step, relatively */
static inline double sf_size_of_step(const double out[4], sf_varied unknowns, const sf_settling *of) {
    double size = fabs(out[unknowns > SF_VARY_A]) / of->A.high;
    if (unknowns > SF_VARY_A)
        size = fmax(size, fabs(out[0]) / of->Omega.high);
    if (unknowns == SF_VARY_ALL)
        size = fmax(size, fabs(out[2]) / of->F_0.high);
    return size;
}

/* How far, relatively, Newton's method would change what does not settle; 0 where pairs have too few digits. */
static inline double sf_is_off_by(sf_step step, sf_varied unknowns, int count, const sf_exactly *exactly,
                                  const sf_model *model, const sf_settling *of) {
    sf_exact_sample at;
    double out[4];
    if (!sf_exact_at(exactly, model, sf_piece_of(model, of->A.high), of->A, count, NULL, &at))
        return 0;
    sf_take_step(step, exactly, &at, of, out);
    const double off = sf_size_of_step(out, unknowns, of);
    return isnan(off) ? HUGE_VAL : off;
}

/* Returns whether an answer settled. count, near: as of sf_exact_at */
static inline int sf_settle_near(sf_step step, sf_varied unknowns, int count, const sf_exactly *exactly,
                                 const sf_model *model, const sf_sample *near, sf_settling *of) {
    double before = HUGE_VAL;
    const int piece = sf_piece_of(model, of->A.high);
    int last = 0;
    if (!(of->Omega.high > 0))
        return 0;
    for (int i = 0; i < SF_MOST_SETTLING && !last; i++) {
        sf_exact_sample at;
        double out[4];
        if (!sf_exact_at(exactly, model, piece, of->A, count, near, &at))
            return 0;
        sf_take_step(step, exactly, &at, of, out);
        const double size = sf_size_of_step(out, unknowns, of);
        if (!sf_is_step(size, out[unknowns], before, &last))
            return 0;
        sf_change_by(&of->A, out[unknowns > SF_VARY_A]);
        if (unknowns > SF_VARY_A)
            sf_change_by(&of->Omega, out[0]);
        if (unknowns == SF_VARY_ALL)
            sf_change_by(&of->F_0, out[2]);
        before = size;
    }
    return last && sf_piece_of(model, of->A.high) == piece;
}

/* The same of numbers, which stay as they are where they do not settle; F_0 does where it is no part of the answer */
static inline int sf_settle_numbers(sf_step step, sf_varied unknowns, int count, const sf_exactly *exactly,
                                    const sf_model *model, double *Omega, double *A, double *F_0) {
    sf_settling of = {sfp_point(*Omega), sfp_point(*A), sfp_point(*F_0)};
    if (exactly == NULL || !sf_settle_near(step, unknowns, count, exactly, model, NULL, &of))
        return 0;
    *Omega = of.Omega.high, *A = of.A.high, *F_0 = of.F_0.high;
    return 1;
}

/* The same of the breakpoints in pairs. */
static inline int sf_exact_piece_of(const sf_exactly *exactly, const sf_model *model, double A) {
    int piece = 0;
    while (piece < model->breaks && sfp_sub(sfp_point(A), exactly->b[piece]).high > 0)
        piece++;
    return piece;
}

/* The sides of each breakpoint that a double is on, and h there: how many breakpoints lie below; -1 where pairs have
 * too few digits. */
static inline int sf_exact_at_double(const sf_exactly *exactly, const sf_model *model, double A, sf_exact_sample *out) {
    const int piece = sf_exact_piece_of(exactly, model, A);
    return sf_exact_at(exactly, model, piece, sfp_point(A), 2, NULL, out) ? piece : -1;
}

/* An answer that is looked for between doubles, all but its amplitude; for peaks the frequency and level by which the
 * last amplitude missed it */
typedef struct {
    const sf_exactly *exactly;
    const sf_model *model;
    double F_0;
    sf_pair Omega;
    double missing;
    int piece;
} sf_sought;

/* Which way an answer lies from an amplitude, on the side of each breakpoint that the double is on; 0 where that is not
 * known.
 * size: by how much the amplitude misses it, in a unit that is the same at the next double */
typedef int (*sf_way)(sf_sought *of, double A, double *size);

/* By the sign of Newton's step. */
static inline int sf_way_to_state(sf_sought *of, double A, double *size) {
    const sf_settling from = {of->Omega, sfp_point(A), sfp_point(of->F_0)};
    sf_exact_sample at;
    double out[4];
    if (sf_exact_at_double(of->exactly, of->model, A, &at) < 0)
        return 0;
    sf_take_step(slow_flow_pairs_state_step, of->exactly, &at, &from, out);
    *size = fabs(out[0]);
    return (out[0] > 0) - (out[0] < 0);
}

/* By the least level at an amplitude, which rises to that of the peak. */
static inline int sf_way_to_peak_from(sf_sought *of, const sf_exact_sample *at, double *size) {
    sf_settling from = {of->Omega, at->A, sfp_point(of->F_0)};
    double out[4];
    int last = 0;
    for (int i = 0; i < SF_MOST_SETTLING && !last; i++) {
        sf_take_step(slow_flow_pairs_ridge_step, of->exactly, at, &from, out);
        if (!(fabs(out[0]) <= SF_LARGEST_STEP * from.Omega.high))
            return 0;
        sf_change_by(&from.Omega, out[0]);
        last = fabs(out[0]) <= SF_LEFT_TO_DO * from.Omega.high;
    }
    sf_take_step(slow_flow_pairs_level_step, of->exactly, at, &from, out);
    of->Omega = from.Omega, of->missing = -out[0], *size = fabs(out[0]);
    return last ? (of->missing > 0) - (of->missing < 0) : 0;
}

static inline int sf_way_to_peak(sf_sought *of, double A, double *size) {
    sf_exact_sample at;
    of->piece = sf_exact_at_double(of->exactly, of->model, A, &at);
    return of->piece < 0 ? 0 : sf_way_to_peak_from(of, &at, size);
}

/* Next to a breakpoint or a double root slopes turn too much for Newton's method: of two doubles between which an
 * answer lies, the one that it misses by less, and the other. NaN where there are no such doubles nearby. */
static inline double sf_double_between(sf_way way_from, sf_sought *of, double A, double *next) {
    double size = HUGE_VAL, other = HUGE_VAL, far = A, width = A * SF_ONE_DOUBLE;
    const int way = way_from(of, A, &size);
    int back = way;
    *next = A;
    if (way == 0 || of->model->breaks < of->exactly->breaks)
        return way == 0 && size == 0 ? A : NAN;
    for (int i = 0; i < SF_MOST_DOUBLINGS && back == way; i++, width *= 2) {
        if (i > 0)
            A = far, size = other;
        far = A + way * width;
        back = way_from(of, far, &other);
    }
    while (back == -way) {
        const double middle = 0.5 * A + 0.5 * far;
        double there = HUGE_VAL;
        if (middle == A || middle == far) {
            *next = size <= other ? far : A;
            return size <= other ? A : far;
        }
        const int on = way_from(of, middle, &there);
        if (on == way)
            A = middle, size = there;
        else if (on == back)
            far = middle, other = there;
        else
            return *next = middle, on == 0 && there == 0 ? middle : NAN;
    }
    return *next = far, back == 0 && other == 0 ? far : NAN;
}

/* An answer just above a breakpoint, where slopes are as steep as 1/root, root^2 = A^2 - b^2: Newton's method in Omega
 * and root, whose steps are the same but for how A follows from them. Begins with what doubles know, at most half of a
 * root at a time. first: of Omega alone, onto the response, where such parts of steps of both would leave it; or
 * NULL */
static inline int sf_settle_above(sf_step step, sf_varied unknowns, sf_step first, const sf_exactly *exactly,
                                  const sf_model *model, int piece, sf_settling *of) {
    const sf_pair b = exactly->b[piece - 1];
    double beyond = sfp_sub(of->A, b).high;
    int last = 0;
    if (!(b.high > 0) || !(of->Omega.high > 0) || !(fabs(beyond) <= SF_PAIRS_NEXT * b.high))
        return 0;
    beyond = fmax(beyond, SF_LEFT_TO_DO * b.high);
    for (int i = 0; i < SF_MOST_ABOVE && !last; i++) {
        const double squared = beyond * (2 * b.high + beyond);
        sf_exact_sample at;
        double out[4];
        of->A = sfp_add(b, sfp_point(beyond));
        if (!sf_exact_at(exactly, model, piece, of->A, 4, NULL, &at))
            return 0;
        if (first != NULL) {
            sf_take_step(first, exactly, &at, of, out);
            if (!(fabs(out[0]) <= SF_LARGEST_STEP * of->Omega.high))
                return 0;
            sf_change_by(&of->Omega, out[0]);
        }
        sf_take_step(step, exactly, &at, of, out);
        const double change = out[unknowns > SF_VARY_A], ratio = change * of->A.high / squared;
        if (ratio != ratio || (unknowns > SF_VARY_A && !(fabs(out[0]) <= SF_LARGEST_STEP * of->Omega.high)))
            return 0;
        const double part = fabs(ratio) > 0.5 ? 0.5 / fabs(ratio) : 1;
        const double root = sqrt(squared) * (1 + part * ratio);
        beyond = root * root / (b.high + sqrt(b.high * b.high + root * root));
        last = part == 1 && fabs(change) <= SF_LEFT_TO_DO * of->A.high;
        if (unknowns > SF_VARY_A) {
            sf_change_by(&of->Omega, part * out[0]);
            last = last && fabs(out[0]) <= SF_LEFT_TO_DO * of->Omega.high;
        }
    }
    of->A = sfp_add(b, sfp_point(beyond));
    return last && beyond <= SF_PAIRS_NEXT * b.high;
}

static inline int sf_settle_state_above(const sf_exactly *exactly, const sf_model *model, int piece, double Omega,
                                        double F_0, double A, sf_settling *of) {
    *of = (sf_settling){sfp_point(Omega), sfp_point(A), sfp_point(F_0)};
    return piece > 0 && model->breaks == exactly->breaks &&
           sf_settle_above(slow_flow_pairs_state_step, SF_VARY_A, NULL, exactly, model, piece, of);
}

/* Of two doubles on both sides of a breakpoint steps do not show which is nearer: the state between them may be just
 * above it. */
static inline double sf_state_between(const sf_exactly *exactly, const sf_model *model, double Omega, double F_0,
                                      double A) {
    sf_sought of = {exactly, model, F_0, sfp_point(Omega), 0, 0};
    sf_settling above;
    double next;
    const double found = sf_double_between(sf_way_to_state, &of, A, &next);
    const double upper = fmax(found, next), lower = fmin(found, next);
    const int piece = sf_exact_piece_of(exactly, model, upper);
    if (found > 0 && piece > sf_exact_piece_of(exactly, model, lower) &&
        sf_settle_state_above(exactly, model, piece, Omega, F_0, upper, &above) && above.A.high >= lower &&
        above.A.high <= upper)
        return above.A.high;
    return found;
}

/* The frequency is in the level what it is in the missing level: a straight line between the doubles, or between one of
 * them and the breakpoint that parts them. */
static inline void sf_peak_between(const sf_exactly *exactly, const sf_model *model, double F_0, double *A,
                                   double *Omega) {
    sf_sought of = {exactly, model, F_0, sfp_point(*Omega), 0, 0}, end[2];
    double ends[2], size;
    ends[0] = sf_double_between(sf_way_to_peak, &of, *A, &ends[1]);
    if (!(ends[0] > 0))
        return;
    for (int i = 0; i < 2; i++) {
        end[i] = of;
        sf_way_to_peak(&end[i], ends[i], &size);
    }
    if (end[0].piece != end[1].piece) {
        const int upper = end[1].piece > end[0].piece;
        sf_exact_sample at;
        sf_exact_on(exactly, end[!upper].piece, &at);
        sf_way_to_peak_from(&of, &at, &size);
        if (of.missing > 0) {
            sf_settling above = {of.Omega, sfp_point(ends[upper]), sfp_point(F_0)};
            if (sf_settle_above(slow_flow_pairs_peak_step, SF_VARY_BOTH, NULL, exactly, model, end[upper].piece,
                                &above)) {
                *A = above.A.high, *Omega = above.Omega.high;
                return;
            }
        }
        end[(of.missing > 0) == (end[1].missing > 0)] = of;
    }
    if (end[0].missing != end[1].missing) {
        const double ratio = end[0].missing / (end[0].missing - end[1].missing);
        sf_change_by(&end[0].Omega, ratio * sfp_sub(end[1].Omega, end[0].Omega).high);
    }
    *A = ends[0], *Omega = end[0].Omega.high;
}

/* Omega on breakpoint i. */
static inline void sf_settle_on(sf_step step, const sf_exactly *exactly, int i, double F_0, double *Omega) {
    sf_exact_sample at;
    sf_settling of = {sfp_point(*Omega), {0, 0}, sfp_point(F_0)};
    double before = HUGE_VAL, out[4];
    int last = 0;
    if (exactly == NULL || !(*Omega > 0) || !(exactly->b[i].high > 0))
        return;
    sf_exact_on(exactly, i, &at);
    for (int k = 0; k < SF_MOST_SETTLING && !last; k++) {
        const double size = (sf_take_step(step, exactly, &at, &of, out), fabs(out[0]) / of.Omega.high);
        if (!sf_is_step(size, out[1], before, &last))
            return;
        sf_change_by(&of.Omega, out[0]), before = size;
    }
    if (last)
        *Omega = of.Omega.high;
}

/* A level that Newton's method changes by so much on a breakpoint b. */
static inline void sf_change_level(double b, double change, double *F_0) {
    if (*F_0 > 0 && b > 0 && fabs(change) <= SF_LEVEL_STEP * *F_0)
        *F_0 += change;
}

/* F_cr: the level at Omega on breakpoint i, where it is least, so that Omega has digits enough. */
static inline void sf_settle_level_on(const sf_exactly *exactly, int i, double Omega, double *F_0) {
    sf_exact_sample at;
    sf_settling of = {sfp_point(Omega), {0, 0}, sfp_point(*F_0)};
    double out[4];
    if (exactly == NULL || !(*F_0 > 0) || !(exactly->b[i].high > 0))
        return;
    sf_exact_on(exactly, i, &at);
    sf_take_step(slow_flow_pairs_level_step, exactly, &at, &of, out);
    sf_change_level(exactly->b[i].high, out[0], F_0);
}

static int sf_nearest_break(const sf_model *model, double A) {
    int best = 0;
    for (int k = 1; k < model->breaks; k++)
        if (fabs(A - model->b[k]) < fabs(A - model->b[best]))
            best = k;
    return best;
}

/* Returns how far off the fold is left, relatively; 0 where it settled. */
static inline double sf_settle_fold(const sf_exactly *exactly, const sf_model *model, double F_0, double *Omega,
                                    double *A) {
    const sf_settling begin = {sfp_point(*Omega), sfp_point(*A), sfp_point(F_0)};
    sf_settling above = begin;
    const int piece = sf_piece_of(model, *A);
    if (exactly == NULL ||
        sf_settle_numbers(slow_flow_pairs_fold_step, SF_VARY_BOTH, 2, exactly, model, Omega, A, &F_0))
        return 0;
    if (!(piece > 0 && model->breaks == exactly->breaks &&
          sf_settle_above(slow_flow_pairs_fold_step, SF_VARY_BOTH, slow_flow_pairs_corner_step, exactly, model, piece,
                          &above)))
        return sf_is_off_by(slow_flow_pairs_fold_step, SF_VARY_BOTH, 2, exactly, model, &begin);
    *Omega = above.Omega.high, *A = fmax(above.A.high, nextafter(model->b[piece - 1], HUGE_VAL));
    return 0;
}

/* Folds, by rising Omega also where doubles had them in another order. Two that were apart do not become one. Returns
 * how far off one of them is left, relatively. */
static double sf_settle_folds(const sf_exactly *exactly, const sf_model *model, double F_0, sf_folds *folds) {
    double Omega[SF_MOST_FOLDS], A[SF_MOST_FOLDS], off = 0;
    for (int i = 0; i < folds->n; i++) {
        const sf_fold *fold = &folds->at[i];
        Omega[i] = fold->Omega, A[i] = fold->A;
        /* one above a breakpoint by less than a double has the frequency of those on it */
        if (fold->corner || (model->breaks > 0 && fold->A == model->b[sf_nearest_break(model, fold->A)]))
            sf_settle_on(slow_flow_pairs_corner_step, exactly, sf_nearest_break(model, fold->A), F_0, &Omega[i]);
        else
            off = fmax(off, sf_settle_fold(exactly, model, F_0, &Omega[i], &A[i]));
    }
    for (int i = 1; i < folds->n; i++)
        for (int j = 0; j < i; j++) {
            const sf_fold *one = &folds->at[i], *other = &folds->at[j];
            if (Omega[i] == Omega[j] && A[i] == A[j] && fabs(one->A - other->A) > SF_FEW_ROUNDINGS * one->A) {
                const int back = fabs(A[i] - one->A) > fabs(A[j] - other->A) ? i : j;
                Omega[back] = folds->at[back].Omega, A[back] = folds->at[back].A;
            }
        }
    for (int i = 0; i < folds->n; i++)
        folds->at[i].Omega = Omega[i], folds->at[i].A = A[i];
    for (int i = 1; i < folds->n; i++)
        for (int j = i; j > 0 && sf_comes_after(&folds->at[j - 1], &folds->at[j]); j--) {
            const sf_fold fold = folds->at[j];
            folds->at[j] = folds->at[j - 1], folds->at[j - 1] = fold;
        }
    return off;
}

/* Returns whether an onset settled, or is on a breakpoint, where it is what it is. */
static int sf_settle_onset(const sf_model *model, const sf_exactly *exactly, sf_onset *out) {
    if (out->kind == SF_CUSP_KIND)
        return sf_settle_numbers(slow_flow_pairs_cusp_step, SF_VARY_ALL, 4, exactly, model, &out->Omega, &out->A,
                                 &out->F_SN);
    if (out->kind == SF_ISOLA_KIND)
        return sf_settle_numbers(slow_flow_pairs_isola_step, SF_VARY_ALL, 2, exactly, model, &out->Omega, &out->A,
                                 &out->F_SN);
    return 1;
}

static sf_status sf_settled_onset(const sf_model *model, const sf_exactly *exactly, sf_work *work, sf_onset *out) {
    const sf_status status = sf_find_onset(model, work, out);
    if (status == SF_OK && !model->by_laws)
        sf_settle_onset(model, exactly, out);
    return status;
}

static sf_status sf_settled_detachment(const sf_model *model, const sf_exactly *exactly, double *F_cr, double *Omega_cr,
                                       double *u_cr) {
    const sf_status status = sf_detachment(model, F_cr, Omega_cr, u_cr);
    if (status == SF_OK && !model->by_laws)
        sf_settle_level_on(exactly, 0, *Omega_cr, F_cr);
    return status;
}

static sf_extremum sf_settled_extremum(const sf_model *model, const sf_exactly *exactly, const sf_zero *zero) {
    sf_extremum out = sf_extremum_at(model, zero);
    const int is_isola = zero->question == SF_ISOLA, count = is_isola ? 2 : 4;
    const sf_step step = is_isola ? slow_flow_pairs_isola_step : slow_flow_pairs_cusp_step;
    const sf_settling begin = {sfp_point(out.Omega), sfp_point(out.A), sfp_point(out.F_0)};
    if (exactly == NULL || zero->question == SF_UNDAMPED || model->by_laws)
        return out;
    if (!sf_settle_numbers(step, SF_VARY_ALL, count, exactly, model, &out.Omega, &out.A, &out.F_0))
        out.few_digits = sf_is_off_by(step, SF_VARY_ALL, count, exactly, model, &begin) > SF_FEW_ROUNDINGS;
    return out;
}

static sf_status sf_settled_peak(const sf_model *model, const sf_exactly *exactly, double F_0, double most,
                                 sf_work *work, double *A, double *Omega) {
    const sf_status status = sf_peak(model, F_0, most, work, A, Omega);
    if (status != SF_OK || exactly == NULL || model->by_laws)
        return status;
    if (!sf_settle_numbers(slow_flow_pairs_peak_step, SF_VARY_BOTH, 2, exactly, model, Omega, A, &F_0) && *A > 0 &&
        *Omega > 0 && model->breaks > 0)
        sf_peak_between(exactly, model, F_0, A, Omega);
    return status;
}
