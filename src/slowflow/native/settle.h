/* Answers to their last digit: in goes an answer as the solvers found it, out comes the double next to the exact one of the
 * oscillator as it was given.
 *
 * Newton's method, in double-double, on the equations that define the answer (derivations/newton.py): one step, but next to
 * a double root or a breakpoint. An answer is left alone where the first step is not small beside it, or the slopes change
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
enum { SF_MOST_SETTLING = 8 };

typedef void (*sf_step)(sf_pair Omega, sf_pair A, sf_pair F_0, sf_pair m, sf_pair zeta, sf_pair h, sf_pair h_A,
                        sf_pair h_AA, sf_pair h_AAA, sf_pair *out);

/* An answer on its way */
typedef struct {
    sf_pair Omega, A;
} sf_settling;

static inline void sf_take_step(sf_step step, const sf_exactly *exactly, const sf_exact_sample *at, sf_pair Omega, double F_0,
                                sf_pair out[3]) {
    step(Omega, at->A, sfp_point(F_0), exactly->m, exactly->zeta, at->h[0], at->h[1], at->h[2], at->h[3], out);
}

/* Whether a step is one to take, after one of the size `before`; last: whether the next would change nothing. size: of the
 * step, relatively. Errors fall by squares: the next step is to this one as this one to the one before; of the first only
 * the slope's turn may be known, which is not all where a peak is as sharp as rounding. */
static inline int sf_is_step(double size, double turn, double before, int *last) {
    const int is_told = turn != 0 && size <= SF_FEW_ROUNDINGS;
    const double share = before < HUGE_VAL ? size / before : is_told ? fmax(fabs(turn), size) : 1;
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

/* Omega and A; returns whether they settled. moves: 1, A alone, or 2. wanted: as of sf_exact_at */
static inline int sf_settle_both(sf_step step, int moves, int wanted, const sf_exactly *exactly, const sf_model *model,
                                 double F_0, sf_settling *of) {
    double before = HUGE_VAL;
    const int piece = sf_piece_of(model, of->A.high);
    int i, last = 0;
    if (!(of->Omega.high > 0) || model->breaks < exactly->mechanism->breakpoints)
        return 0;
    for (i = 0; i < SF_MOST_SETTLING && !last; i++) {
        sf_exact_sample at;
        sf_pair out[3];
        double size;
        if (!sf_exact_at(exactly, model, piece, of->A, wanted, &at))
            return 0;
        sf_take_step(step, exactly, &at, of->Omega, F_0, out);
        size = fmax(moves > 1 ? fabs(out[0].high) / of->Omega.high : 0, fabs(out[moves - 1].high) / of->A.high);
        if (!sf_is_step(size, out[moves].high, before, &last))
            return 0;
        if (moves > 1)
            of->Omega = sfp_add(of->Omega, out[0]);
        of->A = sfp_add(of->A, out[moves - 1]);
        before = size;
    }
    return last && sf_piece_of(model, of->A.high) == piece;
}

static inline double sf_settled_level(const sf_exactly *exactly, const sf_exact_sample *at, sf_pair Omega) {
    return slow_flow_pairs_level(Omega, at->A, exactly->m, exactly->zeta, at->h[0]).high;
}

/* The same of numbers; level: NULL where the forcing is no part of the answer */
static inline void sf_settle_numbers(sf_step step, int wanted, const sf_exactly *exactly, const sf_model *model, double F_0,
                                     double *Omega, double *A, double *level) {
    sf_settling of = {sfp_point(*Omega), sfp_point(*A)};
    sf_exact_sample at;
    if (exactly == NULL || !sf_settle_both(step, 2, wanted, exactly, model, F_0, &of))
        return;
    *Omega = of.Omega.high, *A = of.A.high;
    if (level != NULL && sf_exact_at(exactly, model, sf_piece_of(model, *A), of.A, 2, &at))
        *level = sf_settled_level(exactly, &at, of.Omega);
}

/* Omega on breakpoint i. */
static inline void sf_settle_on(sf_step step, const sf_exactly *exactly, int i, double F_0, double *Omega) {
    sf_exact_sample at;
    sf_pair w = sfp_point(*Omega), out[3];
    double before = HUGE_VAL;
    int k, last = 0;
    if (exactly == NULL || !(*Omega > 0) || !(exactly->b[i].high > 0))
        return;
    sf_exact_on(exactly, i, &at);
    for (k = 0; k < SF_MOST_SETTLING && !last; k++) {
        const double size = (sf_take_step(step, exactly, &at, w, F_0, out), fabs(out[0].high) / w.high);
        if (!sf_is_step(size, out[1].high, before, &last))
            return;
        w = sfp_add(w, out[0]), before = size;
    }
    if (last)
        *Omega = w.high;
}

/* The breakpoint that an amplitude is. */
static inline int sf_breakpoint_at(const sf_model *model, double A) {
    int i = 0;
    while (i + 1 < model->breaks && model->b[i] != A)
        i++;
    return i;
}

/* Folds, which stay in order. */
static void sf_settle_folds(const sf_exactly *exactly, const sf_model *model, double F_0, sf_folds *folds) {
    int i;
    for (i = 0; i < folds->n; i++) {
        sf_fold *fold = &folds->at[i];
        const double low = i > 0 ? folds->at[i - 1].Omega : 0;
        const double high = i + 1 < folds->n ? folds->at[i + 1].Omega : HUGE_VAL;
        double Omega = fold->Omega, A = fold->A;
        if (fold->corner)
            sf_settle_on(slow_flow_pairs_corner_step, exactly, sf_breakpoint_at(model, A), F_0, &Omega);
        else
            sf_settle_numbers(slow_flow_pairs_fold_step, 2, exactly, model, F_0, &Omega, &A, NULL);
        if (low <= Omega && Omega <= high)
            fold->Omega = Omega, fold->A = A;
    }
}

static sf_status sf_settled_onset(const sf_model *model, const sf_exactly *exactly, sf_work *work, sf_onset *out) {
    const sf_status status = sf_find_onset(model, work, out);
    if (status == SF_OK && out->kind == SF_CUSP_KIND)
        sf_settle_numbers(slow_flow_pairs_cusp_step, 4, exactly, model, 0, &out->Omega, &out->A, &out->F_SN);
    if (status == SF_OK && out->kind == SF_ISOLA_KIND)
        sf_settle_numbers(slow_flow_pairs_isola_step, 4, exactly, model, 0, &out->Omega, &out->A, &out->F_SN);
    return status;
}

static sf_extremum sf_settled_extremum(const sf_model *model, const sf_exactly *exactly, const sf_zero *zero) {
    sf_extremum out = sf_extremum_at(model, zero);
    if (zero->question == SF_CUSP)
        sf_settle_numbers(slow_flow_pairs_cusp_step, 4, exactly, model, 0, &out.Omega, &out.A, &out.F_0);
    else if (zero->question == SF_ISOLA)
        sf_settle_numbers(slow_flow_pairs_isola_step, 4, exactly, model, 0, &out.Omega, &out.A, &out.F_0);
    return out;
}

static sf_status sf_settled_peak(const sf_model *model, const sf_exactly *exactly, double F_0, sf_work *work, double *A,
                                 double *Omega) {
    const sf_status status = sf_peak(model, F_0, work, A, Omega);
    if (status == SF_OK)
        sf_settle_numbers(slow_flow_pairs_peak_step, 2, exactly, model, F_0, Omega, A, NULL);
    return status;
}

#endif
