/* Answers to their last digit: in goes an answer as the solvers found it, out comes the double next to the exact one of the
 * oscillator as it was given.
 *
 * Newton's method on the equations that define the answer (derivations/newton.py), their values in double-double, their
 * slopes in doubles: one step, but next to a double root or a breakpoint. An answer is left alone where the first step is not small beside it, or the slopes change
 * along it by too much: there it may lead to another answer.
 */
#ifndef SF_SETTLE_H
#define SF_SETTLE_H

#include "exactly.h"
#include "onset.h"

/* no first step is larger, relatively, or changes a slope by a larger share */
#define SF_LARGEST_STEP 0x1p-6
#define SF_LARGEST_TURN 0.25
/* steps are followed by another one while this is left to do, relatively; and a first one that is larger than this */
#define SF_LEFT_TO_DO 0x1p-58
#define SF_FEW_ROUNDINGS 0x1p-49
/* how far a state is looked for from what doubles found, next to a breakpoint: so many doublings of a double */
#define SF_ONE_DOUBLE 0x1p-52
enum { SF_MOST_DOUBLINGS = 16 };
/* the square of a step to a level is left out */
#define SF_LEVEL_STEP 0x1p-30
enum { SF_MOST_SETTLING = 8 };

typedef void (*sf_step)(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A,
                        sf_pair h_AA, sf_pair h_AAA, double *out);

/* An answer on its way, with its forcing */
typedef struct {
    sf_pair Omega, A, F_0;
} sf_settling;

/* Which of them an answer has: the last, the first two, or all */
typedef enum { SF_MOVES_A = 1, SF_MOVES_BOTH, SF_MOVES_ALL } sf_moves;

static inline void sf_take_step(sf_step step, const sf_exactly *exactly, const sf_exact_sample *at, const sf_settling *of,
                                double out[4]) {
    step(of->Omega, at->A, of->F_0, exactly->m, exactly->zeta, at->h[0], at->h[1], at->h[2], at->h[3], out);
}

static inline void sf_change_by(sf_pair *x, double change) { *x = sfp_add(*x, sfp_point(change)); }

/* Whether a step is one to take, after one of the size `before`; last: whether the next would change nothing. size: of the
 * step, relatively. Errors fall by squares, or, as slopes are doubles, by the same share again: the next step is to this one
 * as this one to the one before; of the first only the slope's turn may be known, which is not all where a peak is as sharp
 * as rounding. */
static inline int sf_is_step(double size, double turn, double before, int *last) {
    const double share = before < HUGE_VAL ? size / before : size <= SF_FEW_ROUNDINGS ? fmax(fabs(turn), size) : 1;
    *last = size * share <= SF_LEFT_TO_DO;
    return size <= fmin(SF_LARGEST_STEP, 2 * before) && fabs(turn) <= SF_LARGEST_TURN;
}

/* The piece of the force that an amplitude reaches, by its number. */
static inline int sf_piece_of(const sf_model *model, double A) {
    int piece = 0;
    while (piece < model->breaks && A > model->b[piece])
        piece++;
    return piece;
}

/* Returns whether an answer settled. wanted, near: as of sf_exact_at */
static inline int sf_settle_near(sf_step step, sf_moves moves, int wanted, const sf_exactly *exactly, const sf_model *model,
                                 const sf_sample *near, sf_settling *of) {
    double before = HUGE_VAL;
    const int piece = sf_piece_of(model, of->A.high);
    int i, last = 0;
    if (!(of->Omega.high > 0) || model->breaks < exactly->mechanism->breakpoints)
        return 0;
    for (i = 0; i < SF_MOST_SETTLING && !last; i++) {
        sf_exact_sample at;
        double out[4], size;
        if (!sf_exact_at(exactly, model, piece, of->A, wanted, near, &at))
            return 0;
        sf_take_step(step, exactly, &at, of, out);
        size = fabs(out[moves > SF_MOVES_A]) / of->A.high;
        if (moves > SF_MOVES_A)
            size = fmax(size, fabs(out[0]) / of->Omega.high);
        if (moves == SF_MOVES_ALL)
            size = fmax(size, fabs(out[2]) / of->F_0.high);
        if (!sf_is_step(size, out[moves], before, &last))
            return 0;
        sf_change_by(&of->A, out[moves > SF_MOVES_A]);
        if (moves > SF_MOVES_A)
            sf_change_by(&of->Omega, out[0]);
        if (moves == SF_MOVES_ALL)
            sf_change_by(&of->F_0, out[2]);
        before = size;
    }
    return last && sf_piece_of(model, of->A.high) == piece;
}

static inline int sf_settle_all(sf_step step, sf_moves moves, int wanted, const sf_exactly *exactly, const sf_model *model,
                                sf_settling *of) {
    return sf_settle_near(step, moves, wanted, exactly, model, NULL, of);
}

/* The same of numbers; F_0 stays what it is where it is no part of the answer */
static inline void sf_settle_numbers(sf_step step, sf_moves moves, int wanted, const sf_exactly *exactly,
                                     const sf_model *model, double *Omega, double *A, double *F_0) {
    sf_settling of = {sfp_point(*Omega), sfp_point(*A), sfp_point(*F_0)};
    if (exactly != NULL && sf_settle_all(step, moves, wanted, exactly, model, &of))
        *Omega = of.Omega.high, *A = of.A.high, *F_0 = of.F_0.high;
}

/* Which way a state at Omega lies from an amplitude: by the sign of Newton's step, on the side of each breakpoint that the
 * double is on; 0 where that is not known. size: of the step */
static inline int sf_way_to_state(const sf_exactly *exactly, const sf_model *model, double Omega, double F_0, double A,
                                  double *size) {
    const sf_settling of = {sfp_point(Omega), sfp_point(A), sfp_point(F_0)};
    sf_exact_sample at;
    double out[4];
    int piece = 0;
    while (piece < model->breaks && sfp_sub(of.A, exactly->b[piece]).high > 0)
        piece++;
    if (!sf_exact_at(exactly, model, piece, of.A, 2, NULL, &at))
        return 0;
    sf_take_step(slow_flow_pairs_state_step, exactly, &at, &of, out);
    *size = fabs(out[0]);
    return (out[0] > 0) - (out[0] < 0);
}

/* Next to a breakpoint a state's own slope turns too much for Newton's method: of two doubles between which it lies, the one
 * that is nearer by its step. NaN where there are no such doubles nearby. */
static inline double sf_state_between(const sf_exactly *exactly, const sf_model *model, double Omega, double F_0, double A) {
    double size = HUGE_VAL, other = HUGE_VAL, far = A, width = A * SF_ONE_DOUBLE;
    const int way = sf_way_to_state(exactly, model, Omega, F_0, A, &size);
    int i, back = way;
    if (way == 0 || model->breaks < exactly->mechanism->breakpoints)
        return NAN;
    for (i = 0; i < SF_MOST_DOUBLINGS && back == way; i++, width *= 2) {
        if (i > 0)
            A = far, size = other;
        far = A + way * width;
        back = sf_way_to_state(exactly, model, Omega, F_0, far, &other);
    }
    while (back == -way) {
        const double middle = 0.5 * A + 0.5 * far;
        double there = HUGE_VAL;
        int on;
        if (middle == A || middle == far)
            return size <= other ? A : far;
        on = sf_way_to_state(exactly, model, Omega, F_0, middle, &there);
        if (on == way)
            A = middle, size = there;
        else if (on == back)
            far = middle, other = there;
        else
            return on == 0 && there == 0 ? middle : NAN;
    }
    return back == 0 && other == 0 ? far : NAN;
}

/* Omega on breakpoint i. */
static inline void sf_settle_on(sf_step step, const sf_exactly *exactly, int i, double F_0, double *Omega) {
    sf_exact_sample at;
    sf_settling of = {sfp_point(*Omega), {0, 0}, sfp_point(F_0)};
    double before = HUGE_VAL, out[4];
    int k, last = 0;
    if (exactly == NULL || !(*Omega > 0) || !(exactly->b[i].high > 0))
        return;
    sf_exact_on(exactly, i, &at);
    for (k = 0; k < SF_MOST_SETTLING && !last; k++) {
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

/* The breakpoint that an amplitude is. */
static inline int sf_breakpoint_at(const sf_model *model, double A) {
    int i = 0;
    while (i + 1 < model->breaks && model->b[i] != A)
        i++;
    return i;
}

/* Folds, which stay in order: one that would pass the next, where this settles too, stays as it was. */
static void sf_settle_folds(const sf_exactly *exactly, const sf_model *model, double F_0, sf_folds *folds) {
    double Omega[SF_MOST_FOLDS], A[SF_MOST_FOLDS];
    int i;
    for (i = 0; i < folds->n; i++) {
        const sf_fold *fold = &folds->at[i];
        Omega[i] = fold->Omega, A[i] = fold->A;
        /* one above a breakpoint by less than a double has the frequency of those on it */
        if (fold->corner || (model->breaks > 0 && fold->A == model->b[sf_breakpoint_at(model, fold->A)]))
            sf_settle_on(slow_flow_pairs_corner_step, exactly, sf_breakpoint_at(model, fold->A), F_0, &Omega[i]);
        else
            sf_settle_numbers(slow_flow_pairs_fold_step, SF_MOVES_BOTH, 2, exactly, model, &Omega[i], &A[i], &F_0);
    }
    for (i = 0; i < folds->n; i++) {
        const double low = i > 0 ? folds->at[i - 1].Omega : 0;
        const double high = i + 1 < folds->n ? fmax(Omega[i + 1], folds->at[i + 1].Omega) : HUGE_VAL;
        if (low <= Omega[i] && Omega[i] <= high)
            folds->at[i].Omega = Omega[i], folds->at[i].A = A[i];
        else
            folds->at[i].Omega = fmax(low, folds->at[i].Omega);
    }
}

static void sf_settle_onset(const sf_model *model, const sf_exactly *exactly, sf_onset *out) {
    if (out->kind == SF_CUSP_KIND)
        sf_settle_numbers(slow_flow_pairs_cusp_step, SF_MOVES_ALL, 4, exactly, model, &out->Omega, &out->A, &out->F_SN);
    if (out->kind == SF_ISOLA_KIND)
        sf_settle_numbers(slow_flow_pairs_isola_step, SF_MOVES_ALL, 2, exactly, model, &out->Omega, &out->A, &out->F_SN);
}

static sf_status sf_settled_onset(const sf_model *model, const sf_exactly *exactly, sf_work *work, sf_onset *out) {
    const sf_status status = sf_find_onset(model, work, out);
    if (status == SF_OK)
        sf_settle_onset(model, exactly, out);
    return status;
}

static sf_status sf_settled_detachment(const sf_model *model, const sf_exactly *exactly, double *F_cr, double *Omega_cr,
                                       double *u_cr) {
    const sf_status status = sf_detachment(model, F_cr, Omega_cr, u_cr);
    if (status == SF_OK)
        sf_settle_level_on(exactly, 0, *Omega_cr, F_cr);
    return status;
}

static sf_extremum sf_settled_extremum(const sf_model *model, const sf_exactly *exactly, const sf_zero *zero) {
    sf_extremum out = sf_extremum_at(model, zero);
    if (zero->question == SF_CUSP)
        sf_settle_numbers(slow_flow_pairs_cusp_step, SF_MOVES_ALL, 4, exactly, model, &out.Omega, &out.A, &out.F_0);
    else if (zero->question == SF_ISOLA)
        sf_settle_numbers(slow_flow_pairs_isola_step, SF_MOVES_ALL, 2, exactly, model, &out.Omega, &out.A, &out.F_0);
    return out;
}

static sf_status sf_settled_peak(const sf_model *model, const sf_exactly *exactly, double F_0, sf_work *work, double *A,
                                 double *Omega) {
    const sf_status status = sf_peak(model, F_0, work, A, Omega);
    if (status == SF_OK)
        sf_settle_numbers(slow_flow_pairs_peak_step, SF_MOVES_BOTH, 2, exactly, model, Omega, A, &F_0);
    return status;
}

#endif
