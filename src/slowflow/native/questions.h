/* The questions about one oscillator as rows: each answers a query (interface.h) by its items, a status first. */
#pragma once

#include "certify.h"
#include "interface.h"
#include "onset.h"
#include "second_answers.h"
#include "states.h"

/* ==== Items of an answer ========================================================================================== */

/* Lowest and highest of what is enclosed. */
static void sf_put_interval(sf_query *q, const sf_interval *of) { sf_put_column(q, SF_NUMBERS, 2, of, sizeof of->lo); }

/* Room that items lie in until they are read; NULL if there is none: an answer without items is out of memory. */
static void *sf_reserve(sf_query *q, long n, size_t size) {
    return q->reserve[q->reserved++] = malloc((size_t)(n > 0 ? n : 1) * size);
}

/* ==== Averaging =================================================================================================== */

static void sf_put_folds(sf_query *q, sf_status status, const sf_folds *found, int undecided) {
    const sf_fold *at = found->at;
    const long n = status == SF_OK ? found->n : 0;
    sf_put_columns(q, SF_NUMBERS, n, sizeof *at, (const void *[]){&at->Omega, &at->A, NULL});
    sf_put_columns(q, SF_FLAGS, n, sizeof *at, (const void *[]){&at->up, &at->corner, NULL});
    sf_put(q, SF_FLAG, undecided);
}

static void sf_answer_folds(sf_query *q) {
    sf_folds *found = &q->room->work.folds;
    const sf_status status = sf_settled_folds(q->model, q->inputs, q->number[0], q->room, found);
    sf_put(q, SF_INTEGER, status), sf_put_folds(q, status, found, found->undecided);
}

/* at_rest: whether folds that end at Omega = 0 are below it */
static void sf_put_onset(sf_query *q, sf_status status, const sf_onset *found, int at_rest) {
    sf_put(q, SF_INTEGER, status);
    sf_put(q, SF_NUMBER, found->F_SN), sf_put(q, SF_NUMBER, found->Omega), sf_put(q, SF_NUMBER, found->A);
    sf_put(q, SF_INTEGER, found->kind), sf_put(q, SF_FLAG, at_rest), sf_put(q, SF_NUMBER, found->rest);
}

static void sf_answer_onset(sf_query *q) {
    sf_onset found;
    const sf_status status = sf_settled_onset(q->model, q->exactly, &q->room->work, &found);
    sf_put_onset(q, status, &found, status != SF_UNBOUNDED && sf_is_rest_below(&found));
}

static void sf_put_detachment(sf_query *q, sf_status status, double F_cr, double Omega_cr, double u_cr) {
    sf_put(q, SF_INTEGER, status);
    sf_put(q, SF_NUMBER, F_cr), sf_put(q, SF_NUMBER, Omega_cr), sf_put(q, SF_NUMBER, u_cr);
}

static void sf_answer_detachment(sf_query *q) {
    double F_cr, Omega_cr, u_cr;
    const sf_status status = sf_settled_detachment(q->model, q->exactly, &F_cr, &Omega_cr, &u_cr);
    sf_put_detachment(q, status, F_cr, Omega_cr, u_cr);
}

static void sf_put_peak(sf_query *q, sf_status status, double A, double Omega) {
    sf_put(q, SF_INTEGER, status), sf_put(q, SF_NUMBER, A), sf_put(q, SF_NUMBER, Omega);
}

static void sf_answer_peak(sf_query *q) {
    double A, Omega;
    const sf_status status =
        sf_settled_peak(q->model, q->exactly, q->number[0], q->number[1], &q->room->work, &A, &Omega);
    sf_put_peak(q, status, A, Omega);
}

static void sf_answer_bound(sf_query *q) {
    double A_max;
    sf_put(q, SF_INTEGER, sf_range_at(q->model, q->number[0], &A_max));
    sf_put(q, SF_NUMBER, A_max);
}

static void sf_answer_cut(sf_query *q) { sf_put(q, SF_NUMBER, sf_undamped_cut(q->model, q->number[0])); }

static void sf_answer_spring(sf_query *q) { sf_put_column(q, SF_WORDS, 1, sf_spring(q->model), 0); }

static void sf_answer_closeness(sf_query *q) {
    sf_put(q, SF_FLAG, sf_are_events_close(q->model, q->number[0], q->number[1], &q->room->work));
}

static void sf_answer_locus(sf_query *q) {
    sf_work *work = &q->room->work;
    const long samples = (long)q->number[1];
    const sf_status status = sf_fold_locus(q->model, q->number[0], 1, work);
    const long n = status == SF_OK ? sf_draw_locus(q->model, samples, work, NULL, NULL, NULL, NULL) : 0;
    double *Omega = sf_reserve(q, n, 3 * sizeof *Omega);
    long long *branch = sf_reserve(q, n, sizeof *branch);
    if (Omega == NULL || branch == NULL)
        return;
    double *A = Omega + n, *F_0 = A + n;
    if (n > 0)
        sf_draw_locus(q->model, samples, work, Omega, A, F_0, branch);
    sf_put(q, SF_INTEGER, status);
    sf_put_columns(q, SF_NUMBERS, n, sizeof *Omega, (const void *[]){Omega, A, F_0, NULL});
    sf_put_column(q, SF_LONG_INTEGERS, n, branch, sizeof *branch);
}

static void sf_answer_extrema(sf_query *q) {
    const sf_zeros *zeros = &q->room->work.extrema;
    const sf_status status = sf_fold_locus(q->model, q->number[0], 0, &q->room->work);
    sf_extremum *at = sf_reserve(q, zeros->n, sizeof *at);
    long n = 0;
    if (at == NULL)
        return;
    for (int i = 0; i < zeros->n; i++)
        if (!(zeros->at[i].question == SF_UNDAMPED &&
              zeros->at[i].channel == 1)) /* there it only touches the backbone */
            at[n++] = sf_settled_extremum(q->model, q->exactly, &zeros->at[i]);
    sf_put(q, SF_INTEGER, status);
    sf_put_columns(q, SF_NUMBERS, n, sizeof *at, (const void *[]){&at->F_0, &at->Omega, &at->A, NULL});
    sf_put_columns(q, SF_FLAGS, n, sizeof *at,
                   (const void *[]){&at->isola, &at->minimum, &at->saddle, &at->few_digits, NULL});
}

/* The points of a response curve, so many; 0 where there is no memory. */
static int sf_reserve_curve(sf_query *q, sf_status *status, long *n, sf_points *at) {
    const double F_0 = q->number[0], samples = q->number[1], low = q->number[2], high = q->number[3];
    sf_skeleton *shown = &q->room->work.shown;
    sf_model model = *q->model;
    *n = 0;
    shown->curves = 0, model.lowest = low;
    *status = sf_make_skeleton(&model, q->inputs, F_0, q->room);
    if (*status == SF_OK && (*n = sf_show(&model, F_0, low, high, samples, &q->room->work)) < 0)
        *status = SF_NO_BOUND, *n = 0;
    double *block = sf_reserve(q, *n, SF_OF_POINT);
    if (block == NULL)
        return 0;
    *at = sf_points_in(block, *n);
    if (*n > 0)
        *n = sf_draw(&model, F_0, samples, shown, at);
    return 1;
}

static void sf_put_curve(sf_query *q, sf_status status, long n, const sf_points *at) {
    sf_put(q, SF_INTEGER, status);
    sf_put_columns(q, SF_NUMBERS, n, sizeof *at->Omega, (const void *[]){at->Omega, at->A, NULL});
    sf_put_column(q, SF_BYTE_FLAGS, n, at->stable, sizeof *at->stable);
    sf_put_column(q, SF_LONG_INTEGERS, n, at->branch, sizeof *at->branch);
}

static void sf_answer_response(sf_query *q) {
    const sf_skeleton *shown = &q->room->work.shown;
    sf_status status;
    sf_points at;
    long n;
    if (!sf_reserve_curve(q, &status, &n, &at))
        return;
    sf_put_curve(q, status, n, &at);
    sf_put_column(q, SF_FLAGS, shown->curves, shown->closed, sizeof *shown->closed);
    sf_put(q, SF_FLAG, status == SF_OK && q->room->undecided);
}

/* The same with whether the branch of each point is closed, and with the folds. */
static void sf_answer_response_and_folds(sf_query *q) {
    sf_status status;
    sf_points at;
    long n;
    if (!sf_reserve_curve(q, &status, &n, &at))
        return;
    unsigned char *closed = sf_reserve(q, n, sizeof *closed);
    if (closed == NULL)
        return;
    for (long i = 0; i < n; i++)
        closed[i] = q->room->work.shown.closed[at.branch[i]] != 0;
    sf_put_curve(q, status, n, &at);
    sf_put_column(q, SF_BYTE_FLAGS, n, closed, sizeof *closed);
    sf_put_folds(q, status, &q->room->work.folds, status == SF_OK && q->room->undecided);
}

static int sf_has_states(double Omega) { return Omega > 0 && Omega <= SF_HIGHEST_OMEGA; }

/* Every state at one frequency. */
static void sf_answer_states_at(sf_query *q) {
    sf_room *room = q->room;
    sf_model model = *q->model;
    int n, undecided;
    sf_status status;
    if (!sf_has_states(q->number[1]))
        return;
    model.lowest = q->number[1], room->followed = 0;
    status = sf_states(&model, q->inputs, q->number[0], room, q->number[1], &n, room->A, room->stable, &undecided);
    sf_put(q, SF_INTEGER, status);
    sf_put_column(q, SF_NUMBERS, n, room->A, sizeof *room->A);
    sf_put_column(q, SF_BYTE_FLAGS, n, room->stable, sizeof *room->stable);
    sf_put(q, SF_FLAG, undecided);
}

/* A state, as its columns have it. */
typedef struct {
    double Omega, A;
    int stable;
} sf_state;

/* Every state at the frequencies of a list, in their order, and those of these at which their number is undecided. */
static void sf_answer_states_of(sf_query *q) {
    /* frequencies: some milliseconds; and as how many of them a proof counts */
    enum { BETWEEN_SIGNALS = 1 << 14, PROOF = 100 };
    sf_room *room = q->room;
    long n = 0, n_unresolved = 0, size = SF_MOST_STATES, since = 0;
    double *unresolved = sf_reserve(q, (long)q->length, sizeof *unresolved);
    sf_state *at = sf_reserve(q, size, sizeof *at);
    void **of_states = &q->reserve[q->reserved - 1];
    sf_model model = *q->model;
    sf_status status = SF_OK;
    if (unresolved == NULL || at == NULL)
        return;
    model.lowest = q->length > 0 ? q->values[0] : 0;
    for (long i = 1; i < q->length; i++)
        model.lowest = fmin(model.lowest, q->values[i]);
    room->followed = 0, room->proofs = 0;
    for (long i = 0; i < q->length && status == SF_OK; i++) {
        const double Omega = q->values[i];
        int here, undecided;
        if (n + SF_MOST_STATES > size) {
            void *more = realloc(at, (size_t)(size *= 2) * sizeof *at);
            if (more == NULL)
                return;
            *of_states = at = more;
        }
        status = sf_states(&model, q->inputs, q->number[0], room, Omega, &here, room->A, room->stable, &undecided);
        for (int k = 0; k < here; k++)
            at[n++] = (sf_state){Omega, room->A[k], room->stable[k]};
        if (undecided)
            unresolved[n_unresolved++] = Omega;
        since += 1 + PROOF * room->proofs, room->proofs = 0;
        if (since >= BETWEEN_SIGNALS && !q->goes_on(q))
            return;
        since %= BETWEEN_SIGNALS;
    }
    sf_put(q, SF_INTEGER, status);
    sf_put_columns(q, SF_NUMBERS, n, sizeof *at, (const void *[]){&at->Omega, &at->A, NULL});
    sf_put_column(q, SF_FLAGS, n, &at->stable, sizeof *at);
    sf_put_column(q, SF_NUMBERS, n_unresolved, unresolved, sizeof *unresolved);
}

/* ==== Proofs ====================================================================================================== */

static void sf_put_certificate(sf_query *q, sf_status status) {
    const sf_certificate *found = &q->room->found;
    const sf_enclosure *at = found->at;
    const long n = status == SF_OK ? found->n : 0, n_undecided = status == SF_OK ? found->n_undecided : 0;
    sf_put(q, SF_INTEGER, status);
    sf_put_columns(q, SF_INTERVALS, n, sizeof *at, (const void *[]){&at->Omega, &at->A, NULL});
    sf_put_column(q, SF_FLAGS, n, &at->corner, sizeof *at);
    sf_put_column(q, SF_INTEGERS, n, &at->sign, sizeof *at);
    sf_put_column(q, SF_INTERVALS, n_undecided, found->undecided, sizeof *found->undecided);
    sf_put(q, SF_NUMBER, found->A_max), sf_put(q, SF_FLAG, found->bounded), sf_put(q, SF_FLAG, !found->full);
}

static void sf_answer_certified_folds(sf_query *q) {
    sf_put_certificate(q, sf_certify_folds(q->model, q->inputs, q->number[0], q->room));
}

static void sf_answer_certified_states(sf_query *q) {
    sf_put_certificate(q, sf_certify_states(q->model, q->inputs, q->number[0], q->number[1], q->room));
}

static void sf_answer_certified_onset(sf_query *q) {
    sf_proved_onset *found = sf_reserve(q, 1, sizeof *found);
    if (found == NULL)
        return;
    memset(found, 0, sizeof *found);
    sf_put(q, SF_INTEGER, sf_certify_onset(q->model, q->inputs, q->room, found));
    sf_put_interval(q, &found->F_SN), sf_put_interval(q, &found->Omega), sf_put_interval(q, &found->A);
    sf_put(q, SF_INTEGER, found->kind), sf_put(q, SF_FLAG, found->proved);
}

static void sf_answer_certified_detachment(sf_query *q) {
    sf_interval *found = sf_reserve(q, 2, sizeof *found);
    if (found == NULL)
        return;
    found[0] = found[1] = sfi_point(NAN);
    sf_put(q, SF_INTEGER, sf_certify_detachment(q->inputs, &found[0], &found[1]));
    sf_put_interval(q, &found[0]), sf_put_interval(q, &found[1]), sf_put_interval(q, &q->inputs->b[0]);
}

/* Of how many only, and whether it is proved that these are all. */
static void sf_put_number_proved(sf_query *q, sf_status status) {
    const sf_certificate *found = &q->room->found;
    sf_put(q, SF_INTEGER, status);
    sf_put(q, SF_INTEGER, status == SF_OK ? found->n : 0);
    sf_put(q, SF_FLAG, status == SF_OK ? sf_is_proved(found) : status == SF_STICKS && found->bounded);
}

static void sf_answer_proved_folds(sf_query *q) {
    sf_put_number_proved(q, sf_certify_folds(q->model, q->inputs, q->number[0], q->room));
}

static void sf_answer_proved_states(sf_query *q) {
    if (q->number[1] > 0 && q->number[1] < HUGE_VAL)
        sf_put_number_proved(q, sf_certify_states(q->model, q->inputs, q->number[0], q->number[1], q->room));
}

/* ==== The second approximation ==================================================================================== */

static void sf_put_left_out(sf_query *q, const sf_left_out *left) {
    sf_put(q, SF_INTEGER, (double)left->lost), sf_put(q, SF_INTEGER, (double)left->of);
    sf_put(q, SF_NUMBER, left->low), sf_put(q, SF_NUMBER, left->high);
}

static void sf_put_second_states(sf_query *q, long n, const sf_second_point *at) {
    sf_put_columns(q, SF_NUMBERS, n, sizeof *at,
                   (const void *[]){&at->Omega, &at->at.u_max, &at->at.A_1, &at->at.phi, NULL});
    sf_put_column(q, SF_POSITIVE, n, &at->at.F_A, sizeof *at);
}

/* Keeps a curve until its items are read; where there is none, one without points. */
static const sf_second_curve *sf_keep_curve(sf_query *q, sf_second_curve *curve) {
    static sf_second_point nowhere;
    static const sf_second_curve none = {.point = &nowhere};
    if (curve == NULL)
        return &none;
    q->reserve[q->reserved++] = curve->point, q->reserve[q->reserved++] = curve->closed;
    return q->reserve[q->reserved++] = curve;
}

static void sf_answer_second_curve(sf_query *q) {
    sf_status status;
    const sf_second_curve *curve =
        sf_keep_curve(q, sf_second_response(q->model, q->inputs, q->number[0], (sf_wanted)q->number[1], q->number[2],
                                            q->number[3], q->number[4], q->room, &status));
    sf_put(q, SF_INTEGER, status);
    sf_put_second_states(q, curve->n, curve->point);
    sf_put_column(q, SF_NUMBERS, curve->n, &curve->point->A, sizeof *curve->point);
    sf_put_column(q, SF_INTEGERS, curve->n, &curve->point->part, sizeof *curve->point);
    sf_put_column(q, SF_BYTE_FLAGS, curve->branches, curve->closed, sizeof *curve->closed);
    sf_put_left_out(q, &curve->left);
}

/* Whether the spring's harmonics are known for this model. */
static int sf_has_second(const sf_model *model) {
    return model->mechanism->harmonics != NULL &&
           !(model->breaks > 0 && model->b[model->breaks - 1] > model->mechanism->harmonics_up_to);
}

static void sf_answer_second_folds(sf_query *q) {
    sf_second_folds *found = sf_has_second(q->model) ? sf_reserve(q, 1, sizeof *found) : NULL;
    if (found == NULL)
        return;
    const sf_second_fold *at = found->at;
    q->room->undecided = 0;
    sf_put(q, SF_INTEGER,
           sf_second_saddle_nodes(q->model, q->inputs, q->number[0], q->number[1], q->number[2], q->room, found));
    sf_put_columns(q, SF_NUMBERS, found->n, sizeof *at, (const void *[]){&at->Omega, &at->u_max, NULL});
    sf_put_columns(q, SF_FLAGS, found->n, sizeof *at, (const void *[]){&at->up, &at->corner, NULL});
    sf_put(q, SF_FLAG, found->lost > 0);
    sf_put_column(q, SF_NUMBERS, found->n, &at->A_1, sizeof *at);
    sf_put(q, SF_FLAG, q->room->undecided), sf_put(q, SF_INTEGER, found->lost), sf_put(q, SF_INTEGER, found->tried);
    sf_put_left_out(q, &found->left);
}

static void sf_answer_second_states(sf_query *q) {
    double low = HUGE_VAL, high = 0;
    const sf_second_curve *curve;
    sf_second_point *at;
    sf_status status;
    long most = 0, n = 0;
    for (long i = 0; i < q->length; i++)
        low = fmin(low, q->values[i]), high = fmax(high, q->values[i]);
    curve = sf_keep_curve(
        q, sf_second_around(q->model, q->inputs, q->number[0], SF_EVERY_POINT, low, high, q->room, &status));
    for (long i = 0; i < q->length; i++)
        most += sf_most_crossings(curve, q->values[i]);
    at = sf_reserve(q, most, sizeof *at);
    for (long i = 0; i < q->length && at != NULL; i++) {
        n += sf_states_on(q->model, q->number[0], curve, q->values[i], at + n);
        if (!q->goes_on(q))
            return;
    }
    if (at == NULL)
        return;
    sf_put(q, SF_INTEGER, status);
    sf_put_second_states(q, n, at);
}

/* The highest point about a frequency, and the states at its own. */
static void sf_answer_second_peak(sf_query *q) {
    sf_second_curve *about = NULL;
    sf_second_point top = {0}, *at;
    const sf_status status = sf_second_peak(q->model, q->inputs, q->number[0], q->number[1], q->room, &about, &top);
    const sf_second_curve *curve = sf_keep_curve(q, about);
    at = sf_reserve(q, sf_most_crossings(curve, top.Omega), sizeof *at);
    if (at == NULL)
        return;
    const int n = sf_states_on(q->model, q->number[0], curve, top.Omega, at);
    sf_put(q, SF_INTEGER, status), sf_put(q, SF_NUMBER, top.at.u_max), sf_put(q, SF_NUMBER, top.Omega);
    sf_put_second_states(q, n, at);
    sf_put_left_out(q, &curve->left);
}

/* The highest point alone, about averaging's peak. */
static void sf_answer_second_top(sf_query *q) {
    sf_second_curve *curve = NULL;
    sf_second_point top = {0};
    double A, Omega;
    if (!sf_has_second(q->model))
        return;
    sf_status status = sf_settled_peak(q->model, q->exactly, q->number[0], HUGE_VAL, &q->room->work, &A, &Omega);
    if (status == SF_OK)
        status = Omega == 0 ? SF_NONE : sf_second_peak(q->model, q->inputs, q->number[0], Omega, q->room, &curve, &top);
    if (curve != NULL)
        sf_second_free(curve);
    sf_put_peak(q, status, status == SF_OK ? top.at.u_max : NAN, status == SF_OK ? top.Omega : NAN);
}

static void sf_answer_second_onset(sf_query *q) {
    sf_onset first = {q->number[0], q->number[1], q->number[2], SF_CUSP_KIND, HUGE_VAL, 0};
    sf_onset found = {NAN, NAN, NAN, SF_NO_KIND, HUGE_VAL, 0};
    double u_max = NAN;
    sf_status status = SF_OK;
    if (!sf_has_second(q->model))
        return;
    if (first.A == HUGE_VAL)
        status = sf_settled_onset(q->model, q->exactly, &q->room->work, &first);
    if (status == SF_OK && (first.kind != SF_CUSP_KIND || !sf_second_cusp(q->model, &first, &found, &u_max)))
        status = SF_NONE;
    found.A = u_max;
    sf_put_onset(q, status, &found, sf_is_rest_below(&first));
}

static void sf_answer_second_detachment(sf_query *q) {
    double *first = q->number, F_cr = NAN, Omega_cr = NAN;
    sf_status status = SF_OK;
    if (!sf_has_second(q->model))
        return;
    if (first[2] == HUGE_VAL)
        status = sf_detachment(q->model, &first[0], &first[1], &first[2]);
    if (status == SF_OK && !sf_second_detach(q->model, first[0], first[1], first[2], &F_cr, &Omega_cr))
        status = SF_NONE, F_cr = Omega_cr = NAN;
    sf_put_detachment(q, status, F_cr, Omega_cr, first[2]);
}

/* ==== The rows ==================================================================================================== */

static const sf_row sf_rows_of_one[] = {
    {"saddle_nodes", "F_0 -> status, Omega, A, up, corner, undecided", 1, 0, 0, sf_answer_folds},
    {"onset", "status, F_SN, Omega, A, kind, folds at rest, lowest level there", 0, 0, 0, sf_answer_onset},
    {"detachment", "status, F_cr, Omega_cr, u_cr", 0, 0, 0, sf_answer_detachment},
    {"peak", "F_0, most -> status, A, Omega", 2, 0, 0, sf_answer_peak},
    {"amplitude_bound", "F_0 -> status, A_max", 1, 0, 0, sf_answer_bound},
    {"undamped_cut", "F_0 -> A_max", 1, 0, 0, sf_answer_cut},
    {"spring", "whether a spring holds the mass, none does, or one that levels off", 0, 0, 0, sf_answer_spring},
    {"are_events_close", "F_0, A_max -> whether doubles leave open which peaks and static states a curve has", 2, 0, 0,
     sf_answer_closeness},
    {"fold_locus", "A_max, samples -> status, Omega, A, F_0, branch", 2, 0, 0, sf_answer_locus},
    {"extrema", "A_max -> status, F_0, Omega, A, isola, minimum, saddle, few_digits", 1, 0, 0, sf_answer_extrema},
    {"frequency_response", "F_0, samples, low, high -> status, Omega, A, stable, branch, closed, undecided", 4, 0, 0,
     sf_answer_response},
    {"steady_states", "F_0, [Omega] -> status, Omega, A, stable, Omega where undecided", 1, 1, 0, sf_answer_states_of},
    {"certify_folds", "F_0 -> status, Omega, A, corner, sign of F_AA, undecided, A_max, bounded, complete", 1, 0, 1,
     sf_answer_certified_folds},
    {"certify_states", "F_0, Omega -> the same, with the sign of F_A", 2, 0, 1, sf_answer_certified_states},
    {"certify_onset", "status, F_SN, Omega, A, kind, whether it is proved", 0, 0, 1, sf_answer_certified_onset},
    {"certify_detachment", "status, F_cr, Omega_cr, u_cr", 0, 0, 1, sf_answer_certified_detachment},
    {"second_curve",
     "F_0, wanted, samples, low, high -> status, Omega, u_max, A_1, phi, stable, A, part, closed parts; points lost, "
     "of, "
     "from, to",
     5, 0, 0, sf_answer_second_curve},
    {"second_saddle_nodes",
     "F_0, low, high of averaging's folds and peak, infinite where these are not known -> status, Omega, u_max, up, "
     "corner, whether some are lost, A_1, whether doubles leave averaging's undecided, folds lost, tried; points lost, "
     "of, from, to",
     3, 0, 0, sf_answer_second_folds},
    {"second_states", "F_0, [Omega] -> status, Omega, u_max, A_1, phi, stable", 1, 1, 0, sf_answer_second_states},
    {"second_peak",
     "F_0, Omega of averaging's -> status, u_max, Omega; of the states there Omega, u_max, A_1, phi, stable; points "
     "lost, of, from, to",
     2, 0, 0, sf_answer_second_peak},
    {"second_onset", "F_SN, Omega, A of a cusp, infinite where it is not known -> as onset, with u_max for A", 3, 0, 0,
     sf_answer_second_onset},
    {"second_detachment", "F_cr, Omega_cr, u_cr, infinite where these are not known -> status, F_cr, Omega_cr, u_cr", 3,
     0, 0, sf_answer_second_detachment},
};
