/* The record of a force that is known by its values. Takes the Chebyshev polynomials of its pieces
 * (slowflow/sampled/polynomial.py); returns a record whose averages are sums over them.
 *
 * A piece is v^power q(v), v = |u| - begin. Its averages are integrals over the quarter cycle (quarter.h), its bounds
 * those of the polynomial on parts of the piece. From the reach on the force is a straight line, which no answer is
 * about. All of it is of one design: the parameters change nothing.
 */
#pragma once

#include "chebyshev.h"
#include "program.h"
#include "sampled.h"
#include "sampled_intervals.h"

/* f to f'''', of which the averages take the first four */
enum { SF_SLOPES = 4 };

/* sizes: of the coefficients of q and its derivatives, 0 of a piece without extent; of each of `cells` parts of a piece
 * least and most value of f, then of f'''' */
typedef struct {
    int power, cells, sizes[SF_SLOPES + 1];
    double length;
    const double *of[SF_SLOPES + 1], *edges, *least[2], *most[2];
} sf_smooth;

/* ends: the breakpoints, and the reach; lost: of each, what f, f', f'', f''' lose there; line: value and slope of the
 * straight line; rough: what roundings make of each derivative, for each average in turn */
struct sf_sampled {
    void *room;
    sf_smooth piece[SF_MOST_BREAKS + 1];
    double ends[SF_MOST_BREAKS + 1], lost[SF_MOST_BREAKS + 1][SF_SLOPES], line[2];
    double rough[SF_AVERAGES][2 * SF_SLOPES];
    sf_quarter sums[SF_AVERAGES];
    sf_bent bent;
};

/* The derivatives from `first` to `last` of a piece, by Leibniz's rule. */
static void sf_smooth_at(const sf_smooth *of, double v, int first, int last, double *out) {
    const double x = 2 * v / of->length - 1;
    double q[SF_SLOPES + 1], powers[SF_SLOPES + 1] = {1};
    for (int k = 1; k <= of->power; k++)
        powers[k] = powers[k - 1] * v;
    for (int k = first > of->power ? first - of->power : 0; k <= last; k++)
        q[k] = sf_chebyshev(of->of[k], of->sizes[k] - 1, x);
    for (int k = first; k <= last; k++) {
        double factor = 1, sum = 0;
        for (int j = 0; j <= k && j <= of->power; j++) {
            sum += factor * powers[of->power - j] * q[k - j];
            factor *= (double)(k - j) / (j + 1) * (of->power - j);
        }
        out[k] = sum;
    }
}

static void sf_sampled_terms(const sf_quarter *of, int piece, int nodes, const double *beyond, const double *sine,
                             const double *cosine, const double *p, double *out) {
    const sf_sampled *force = of->programs;
    const int which = (int)(of - force->sums), bent = which == SF_INTERCEPT;
    (void)p;
    for (int j = 0; j < nodes; j++) {
        double f[SF_SLOPES] = {0};
        if (piece == of->pieces - 1)
            f[0] = force->line[0] + force->line[1] * beyond[j], f[1] = force->line[1];
        else if (force->piece[piece].sizes[0] > 0)
            sf_smooth_at(&force->piece[piece], beyond[j], bent ? 2 : 0, bent ? 2 : SF_SLOPES - 1, f);
        if (bent)
            out[j] = sampled_intercept_terms(1, sine[j], cosine[j], f[2]);
        else if (which == SF_HIGHER)
            sampled_harmonics_terms(sine[j], f[0], f[1], f[2], f[3], out + j * of->width);
        else
            sampled_averaged_terms(sine[j], f[0], f[1], f[2], f[3], out + j * of->width);
    }
}

/* The first integrals, so many as are required; what ends add to these is another matter. */
static void sf_sampled_sums(const sf_mechanism *self, int which, int count, double A, double *out) {
    const sf_sampled *force = self->sampled;
    sf_over_quarter(&force->sums[which], count, A, NULL, force->ends, out);
}

/* The end number i where an amplitude passes it, else NULL. */
static const double *sf_lost_at(const sf_mechanism *self, int i, double A) {
    const double end = self->sampled->ends[i];
    return end > 0 && A > end ? self->sampled->lost[i] : NULL;
}

/* Outputs are h, or a harmonic, and three derivatives, to which ends add. */
static void sf_sampled_averages(const sf_mechanism *self, int which, int outputs, ptrdiff_t n, const double *A,
                                double *out) {
    double at[2 * SF_SLOPES], more[2 * (SF_SLOPES - 1)];
    const double *lost;
    for (ptrdiff_t j = 0; j < n; j++) {
        sf_sampled_sums(self, which, outputs, A[j], at);
        for (int i = 0; i <= self->breakpoints; i++)
            if ((lost = sf_lost_at(self, i, A[j])) != NULL) {
                (which == SF_HIGHER ? sampled_harmonics_end : sampled_averaged_end)(A[j], self->sampled->ends[i],
                                                                                    lost[0], lost[1], lost[2], more);
                for (int k = 0; k < outputs; k++)
                    if (k % SF_SLOPES > 0)
                        at[k] += more[k - 1 - k / SF_SLOPES];
            }
        for (int k = 0; k < outputs; k++)
            out[k * n + j] = at[k];
    }
}

#define SF_SAMPLED_AVERAGE(name, which, outputs)                                                                       \
    static void name(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out) {           \
        (void)p;                                                                                                       \
        sf_sampled_averages(self, which, outputs, n, A, out);                                                          \
    }
SF_SAMPLED_AVERAGE(sf_sampled_averaged, SF_AVERAGED, SF_SLOPES)
SF_SAMPLED_AVERAGE(sf_sampled_averaged_2, SF_AVERAGED, 2)
SF_SAMPLED_AVERAGE(sf_sampled_harmonics, SF_HIGHER, 2 * SF_SLOPES)
#undef SF_SAMPLED_AVERAGE

static double sf_sampled_intercept(const sf_mechanism *self, double A, const double *p) {
    const sf_sampled *force = self->sampled;
    double sum, at_rest = 0;
    const double *lost;
    int i = 0;
    (void)p;
    sf_sampled_sums(self, SF_INTERCEPT, 1, A, &sum);
    while (force->piece[i].sizes[0] == 0)
        i++;
    sf_smooth_at(&force->piece[i], 0, 0, 0, &at_rest);
    sum *= A * A;
    for (i = 0; i <= self->breakpoints; i++)
        if ((lost = sf_lost_at(self, i, A)) != NULL)
            sum += sampled_intercept_end(A, force->ends[i], lost[0], lost[1]);
    return sum + sampled_at_rest(at_rest);
}

/* ---- on intervals */

/* f, or f'''', on displacements of a piece; beyond its end nothing is known. */
static sf_interval sf_smooth_on(const sf_smooth *of, int fourth, sf_interval v) {
    const double low = fmax(v.lo, 0), high = fmin(v.hi, of->length);
    sf_interval found = {HUGE_VAL, -HUGE_VAL};
    int i = 0;
    if (of->sizes[0] == 0)
        return sfi_point(0);
    if (!(v.hi <= of->length * (1 + 0x1p-40)))
        return sfi_of(-HUGE_VAL, HUGE_VAL);
    /* parts are dense where the piece begins, as squares are */
    if (low > 0)
        i = (int)fmax(fmin(of->cells * sqrt(low / of->length), of->cells) - 1, 0);
    while (i + 1 < of->cells && of->edges[i + 1] <= low)
        i++;
    do {
        found.lo = fmin(found.lo, of->least[fourth][i]), found.hi = fmax(found.hi, of->most[fourth][i]);
        i++;
    } while (i < of->cells && of->edges[i] < high);
    return found;
}

static sf_interval sf_bent_end(const double *lost, sf_interval A, sf_interval b) {
    const sf_interval f = sfi_point(lost[0]), f_u = sfi_point(lost[1]);
    const sf_interval f_uu = sfi_point(lost[2]), f_uuu = sfi_point(lost[3]);
    if (lost[0] != 0)
        return sampled_intervals_bent_end_0(A, b, f, f_u, f_uu, f_uuu);
    if (lost[1] != 0)
        return sampled_intervals_bent_end_1(A, b, f_u, f_uu, f_uuu);
    if (lost[2] != 0)
        return sampled_intervals_bent_end_2(A, b, f_uu, f_uuu);
    return lost[3] != 0 ? sampled_intervals_bent_end_3(A, b, f_uuu) : sfi_point(0);
}

/* Of a piece the terms at A, u less its begin and the sine; then by so many breakpoints passed what closes the sums. */
static void sf_sampled_enclosed(const sf_bent *of, int number, const sf_interval *arguments, sf_interval *out) {
    const sf_sampled *force = of->programs;
    const int passed = number - (of->breakpoints + 1);
    if (passed < 0) {
        const sf_smooth *piece = &force->piece[number];
        sampled_intervals_bent_terms(arguments[2], sf_smooth_on(piece, 0, arguments[1]),
                                     sf_smooth_on(piece, 1, arguments[1]), out);
        return;
    }
    out[0] = arguments[1 + passed], out[1] = arguments[2 + passed];
    for (int i = 0; i < passed; i++)
        if (force->ends[i] > 0)
            out[1] = sfi_add(out[1], sf_bent_end(force->lost[i], arguments[0], sfi_point(force->ends[i])));
}

static void sf_sampled_bent(const sf_mechanism *self, sf_interval A, const double *p, sf_interval *out) {
    (void)p;
    sf_enclose(&self->sampled->bent, self->sampled->ends, A, NULL, out);
}

/* ---- the record's other functions */

static int sf_sampled_parameters_of(const sf_mechanism *self, const double *design, double *p) {
    memcpy(p, design, (size_t)self->parameters * sizeof *p);
    return 1;
}

static void sf_sampled_ends(const sf_mechanism *self, const double *p, double *b) {
    (void)p;
    memcpy(b, self->sampled->ends, (size_t)self->breakpoints * sizeof *b);
}

static void sf_sampled_jumps(const sf_mechanism *self, const double *p, double *jump) {
    (void)p;
    for (int i = 0; i < self->breakpoints; i++)
        jump[i] = self->sampled->lost[i][0];
}

static void sf_sampled_kinks(const sf_mechanism *self, const double *p, double *kink) {
    (void)p;
    for (int i = 0; i < self->breakpoints; i++)
        kink[2 * i] = self->sampled->lost[i][1], kink[2 * i + 1] = self->sampled->lost[i][2];
}

/* ---- reading */

static const double *sf_read_numbers_of(sf_reader *from, int count) {
    double *read = sf_room_for(from, count, sizeof *read);
    for (int i = 0; i < count && read != NULL; i++)
        read[i] = sf_finite(from);
    return read;
}

static void sf_read_smooth(sf_reader *from, sf_smooth *out) {
    const int size = sf_word(from, 0, INT_MAX / 2);
    if (size == 0)
        return;
    out->power = sf_word(from, 0, SF_SLOPES), out->cells = sf_word(from, 1, 1 << 16);
    out->length = sf_finite(from);
    for (int k = 0; k <= SF_SLOPES; k++) {
        out->sizes[k] = size - k > 1 ? size - k : 1;
        out->of[k] = sf_read_numbers_of(from, out->sizes[k]);
    }
    out->edges = sf_read_numbers_of(from, out->cells + 1);
    for (int k = 0; k < 2; k++)
        out->least[k] = sf_read_numbers_of(from, out->cells), out->most[k] = sf_read_numbers_of(from, out->cells);
}

static void sf_read_samples(sf_reader *from, sf_mechanism *record, sf_sampled *out) {
    static const int widths[SF_AVERAGES] = {SF_SLOPES, 2 * SF_SLOPES, 1, 0};
    int *graded;
    record->design_size = record->parameters = sf_size(from, 0, SF_MOST_PARAMETERS);
    record->breakpoints = sf_size(from, 0, SF_MOST_BREAKS);
    const int nodes = sf_word(from, 1, SF_NODES / 2);
    const double *rule = sf_read_numbers_of(from, 2 * nodes);
    graded = sf_room_for(from, record->breakpoints + 2, sizeof *graded);
    for (int i = 0; i <= record->breakpoints && from->status == SF_READ; i++) {
        sf_read_smooth(from, &out->piece[i]);
        out->ends[i] = sf_finite(from);
        for (int k = 0; k < SF_SLOPES; k++)
            out->lost[i][k] = sf_finite(from);
    }
    for (int k = 0; k < 2; k++)
        out->line[k] = sf_finite(from);
    for (int k = 0; k < SF_SLOPES; k++)
        out->rough[SF_AVERAGED][k] = out->rough[SF_HIGHER][k] = out->rough[SF_HIGHER][SF_SLOPES + k] = sf_finite(from);
    out->rough[SF_INTERCEPT][0] = out->rough[SF_AVERAGED][2];
    if (from->word != from->last_word || from->number != from->last_number)
        sf_refuse(from, SF_NO_PROGRAM);
    if (from->status != SF_READ)
        return;
    for (int i = 0; i <= record->breakpoints + 1; i++)
        graded[i] = SF_DENSE;
    for (int i = 0; i < SF_AVERAGES; i++) {
        sf_quarter *sums = &out->sums[i];
        sums->pieces = record->breakpoints + 2, sums->width = widths[i], sums->graded = graded;
        sums->nodes = nodes, sums->rule = (const double (*)[2])(const void *)rule;
        sums->interpreted = sf_sampled_terms, sums->programs = out, sums->rough = out->rough[i];
    }
    out->bent.breakpoints = record->breakpoints;
    out->bent.at = sf_sampled_enclosed, out->bent.programs = out;
    record->reach = out->ends[record->breakpoints], record->harmonics_up_to = HUGE_VAL;
    record->parameters_of = sf_sampled_parameters_of;
    record->ends = sf_sampled_ends, record->jumps = sf_sampled_jumps, record->kinks = sf_sampled_kinks;
    record->averaged = sf_sampled_averaged, record->averaged_2 = sf_sampled_averaged_2;
    record->intercept = sf_sampled_intercept, record->harmonics = sf_sampled_harmonics;
    record->bent = sf_sampled_bent;
    out->room = from->room, record->sampled = out;
}

/* The record of a force by its program, which is never let go, or of one design by samples, which `sf_free_samples`
 * lets go. SF_INVALID where the data is neither, SF_TOO_MANY where the force is beyond what a record has room for.
 *
 * like: a record of any odd force, whose damping and excitation it takes */
static sf_status sf_read_record(int sampled, const sf_mechanism *like, const char *name, const int *code,
                                ptrdiff_t count, const double *numbers, ptrdiff_t length, sf_mechanism **record) {
    sf_reader from = {code, code + count, numbers, numbers + length, NULL, SF_READ};
    sf_mechanism *made = sf_room_for(&from, 1, sizeof *made);
    void *own = sf_room_for(&from, 1, sampled ? sizeof(sf_sampled) : sizeof(sf_program));
    char *called = sf_room_for(&from, (int)strlen(name) + 1, 1);
    if (from.status == SF_READ) {
        sf_take_surroundings(like, made);
        made->name = strcpy(called, name);
        if (sampled)
            sf_read_samples(&from, made, own);
        else
            sf_read_program(&from, made, own);
    }
    *record = made;
    return sf_finished(&from);
}

static void sf_free_samples(const sf_mechanism *record) {
    sf_reader of = {0};
    of.room = record->sampled->room;
    sf_leave_room(&of);
}
