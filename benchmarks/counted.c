/* How often a batch does what its time goes into, and what each of that costs here. Takes designs; returns counts and
 * seconds.
 *
 * The solvers are included as they are; the names that are counted are macros while they are read. Some of the calls
 * are kept and made once more by the clock; loops over many designs are timed where they stand.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#pragma GCC target("avx2,fma,bmi,bmi2,lzcnt")
#endif
#include <string.h>
#include <time.h>

#include "enclosures.h"

enum { KEPT = 4096, ROUNDS = 20, MOST_INPUTS = SF_MOST_DESIGN + SF_MOST_DAMPING + 2 };

typedef struct {
    sf_task task;
    sf_model model;
    sf_known a;
    sf_cell cell;
    int open;
} kept_range;
typedef struct {
    sf_task task;
    sf_model model;
    sf_sample at;
    int open;
} kept_value;
typedef struct {
    double A, p[SF_MOST_PARAMETERS];
} kept_average;
typedef struct {
    int passed, count;
    sf_pair A, beyond, p[SF_MOST_PARAMETERS + SF_MOST_BREAKS];
} kept_pairs;
typedef struct {
    int of_folds; /* else of the response */
    double A, h, m, zeta, more; /* F_0, or h_A of folds */
} kept_quartic;

static long ranges, values, averages, in_pairs, in_intervals, made, quartics_solved;
static kept_range range_kept[KEPT];
static kept_value value_kept[KEPT];
static kept_average average_kept[KEPT];
static kept_pairs pairs_kept[KEPT];
static kept_quartic quartic_kept[KEPT];
static const sf_mechanism *record;
static volatile double sink;

static void counted_range(const sf_task *task, const sf_known *a, sf_cell *cell, int open, sf_range out[2])
{
    const kept_range kept = {*task, *task->model, *a, *cell, open};
    range_kept[ranges++ % KEPT] = kept;
    sf_find_range(task, a, cell, open, out);
}

static void counted_value(const sf_task *task, int open, const sf_sample *at, sf_answer *out) {
    const kept_value kept = {*task, *task->model, *at, open};
    value_kept[values++ % KEPT] = kept;
    sf_ask(task, open, at, out);
}

static void counted_average(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out) {
    kept_average *kept = &average_kept[averages++ % KEPT];
    kept->A = *A;
    memcpy(kept->p, p, (size_t)record->parameters * sizeof *p);
    record->averaged(self, n, A, p, out);
}

static void counted_in_pairs(const sf_mechanism *self, int passed, int count, sf_pair A, sf_pair beyond, const sf_pair *p, sf_pair *out) {
    kept_pairs *kept = &pairs_kept[in_pairs++ % KEPT];
    kept->passed = passed, kept->count = count, kept->A = A, kept->beyond = beyond;
    memcpy(kept->p, p, (size_t)record->parameters * sizeof *p);
    record->averaged_in_pairs(self, passed, count, A, beyond, p, out);
}

static int counted_parameters(const sf_mechanism *self, const double *design, double *p) {
    made++;
    return record->parameters_of(self, design, p);
}

static void counted_within(const sf_mechanism *self, const double *design, sf_interval *p) {
    in_intervals++;
    record->parameters_within(self, design, p);
}

static void keep_quartic(int of_folds, double A, double h, double m, double zeta, double more) {
    const kept_quartic kept = {of_folds, A, h, m, zeta, more};
    quartic_kept[quartics_solved++ % KEPT] = kept;
}

static int counted_response_roots(double A, double h, double m, double zeta, double F_0, double *Omega) {
    keep_quartic(0, A, h, m, zeta, F_0);
    return sf_response_roots(A, h, m, zeta, F_0, Omega);
}

static int counted_fold_roots(double A, double h, double h_A, double m, double zeta, double *Omega) {
    keep_quartic(1, A, h, m, zeta, h_A);
    return sf_fold_roots(A, h, h_A, m, zeta, Omega);
}

#define sf_find_range counted_range
#define sf_ask counted_value
#include "scan.h"
#undef sf_find_range
#undef sf_ask
/* of a design they are asked on its breakpoints, and where Newton's method does not find them */
#define sf_response_roots counted_response_roots
#define sf_fold_roots counted_fold_roots
#include "refine.h"
#undef sf_response_roots
#undef sf_fold_roots
#include "design_lanes.h"
#include "root_lanes.h"
#include "second_lanes.h"

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* loops over many designs: how many cells they had, and their time with that of asking the clock */
typedef struct {
    long calls, cells;
    double seconds;
} lanes;
static lanes cells_in_lanes, amplitudes_in_lanes, averages_in_lanes, balances_in_lanes, made_in_lanes;

static void counted_many_in_pairs(const sf_mechanism *self, ptrdiff_t n, ptrdiff_t apart, const double *design, double *out) {
    const double start = now();
    record->many_in_pairs(self, n, apart, design, out);
    made_in_lanes.seconds += now() - start, made_in_lanes.calls++, made_in_lanes.cells += n;
}

#define COUNT_LANES(loop, type, kind) \
    static void counted_##loop(type *cells) { \
        const double start = now(); \
        loop(cells); \
        kind.seconds += now() - start, kind.calls++, kind.cells += cells->n; \
    }
COUNT_LANES(sf_judge_states, sf_lane_cells, cells_in_lanes)
COUNT_LANES(sf_judge_peaks, sf_lane_cells, cells_in_lanes)
COUNT_LANES(sf_judge_folds, sf_lane_cells, cells_in_lanes)
COUNT_LANES(sf_judge_cusps, sf_lane_cells, cells_in_lanes)
COUNT_LANES(sf_approach_states, sf_lane_zeros, amplitudes_in_lanes)
COUNT_LANES(sf_approach_peaks, sf_lane_zeros, amplitudes_in_lanes)
COUNT_LANES(sf_approach_folds, sf_lane_zeros, amplitudes_in_lanes)
COUNT_LANES(sf_approach_cusps, sf_lane_zeros, amplitudes_in_lanes)
#define sf_judge_states counted_sf_judge_states
#define sf_judge_peaks counted_sf_judge_peaks
#define sf_judge_folds counted_sf_judge_folds
#define sf_judge_cusps counted_sf_judge_cusps
#define sf_approach_states counted_sf_approach_states
#define sf_approach_peaks counted_sf_approach_peaks
#define sf_approach_folds counted_sf_approach_folds
#define sf_approach_cusps counted_sf_approach_cusps

static void counted_sf_second_balances(ptrdiff_t n, const double *Omega, const double *A, double F_0, int inertial,
                                       int phases, double m, double zeta, const double *known, double *out) {
    const double start = now();
    sf_second_balances(n, Omega, A, F_0, inertial, phases, m, zeta, known, out);
    balances_in_lanes.seconds += now() - start, balances_in_lanes.calls++, balances_in_lanes.cells += n;
}
#define sf_second_balances counted_sf_second_balances
#define SF_SOLVERS solvers_counted
/* in a source of its own */
#define SF_RECORDS sf_records_baseline
#include "solvers.h"

static double least(double a, double b) { return a < b ? a : b; }

/* What was kept is asked again by what the oscillator was then: pointers led to what is no more. */
static void mend(void) {
    for (int i = 0; i < KEPT; i++) {
        range_kept[i].model.mechanism = value_kept[i].model.mechanism = record;
        range_kept[i].task.model = &range_kept[i].model, value_kept[i].task.model = &value_kept[i].model;
        range_kept[i].task.most = value_kept[i].task.most = NULL;
    }
}

static double seconds_of_ranges(long n) {
    double best = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now();
        for (long i = 0; i < n; i++) {
            sf_cell cell = range_kept[i].cell;
            sf_range out[2];
            sf_find_range(&range_kept[i].task, &range_kept[i].a, &cell, range_kept[i].open, out);
            sink = out[0].y.lo;
        }
        best = least(best, (now() - start) / (double)n);
    }
    return best;
}

static double seconds_of_values(long n) {
    double best = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now();
        for (long i = 0; i < n; i++) {
            sf_answer out;
            sf_ask(&value_kept[i].task, value_kept[i].open, &value_kept[i].at, &out);
            sink = out.y[0];
        }
        best = least(best, (now() - start) / (double)n);
    }
    return best;
}

static double seconds_of_averages(long n) {
    double best = HUGE_VAL, h[4];
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now();
        for (long i = 0; i < n; i++) {
            record->averaged(record, 1, &average_kept[i].A, average_kept[i].p, h);
            sink = h[0];
        }
        best = least(best, (now() - start) / (double)n);
    }
    return best;
}

static double seconds_in_pairs(long n) {
    double best = HUGE_VAL;
    sf_pair h[4];
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now();
        for (long i = 0; i < n; i++) {
            const kept_pairs *kept = &pairs_kept[i];
            record->averaged_in_pairs(record, kept->passed, kept->count, kept->A, kept->beyond, kept->p, h);
            sink = h[0].high;
        }
        best = least(best, (now() - start) / (double)n);
    }
    return best;
}

static double seconds_of_quartics(long n) {
    double best = HUGE_VAL, Omega[3];
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now();
        for (long i = 0; i < n; i++) {
            const kept_quartic *q = &quartic_kept[i];
            sink = q->of_folds ? sf_fold_roots(q->A, q->h, q->more, q->m, q->zeta, Omega)
                               : sf_response_roots(q->A, q->h, q->m, q->zeta, q->more, Omega);
        }
        best = least(best, (now() - start) / (double)n);
    }
    return best;
}

/* What the numbers of a design take to become what the solvers take: as doubles, as intervals. */
static void seconds_of_designs(sf_call *at, double out[2]) {
    const double n = (double)at->dimensions[0];
    out[0] = out[1] = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++) {
        sf_interval within[SF_MOST_PARAMETERS + SF_MOST_BREAKS];
        sf_numbers inputs;
        sf_model model;
        double start = now(), reading;
        for (at->k = 0; at->k < at->dimensions[0]; at->k++)
            sf_read_numbers_at(at, &inputs), sink = inputs.design[0];
        reading = now() - start, start = now();
        for (at->k = 0; at->k < at->dimensions[0]; at->k++)
            sink = sf_design_at(at, 0, &inputs, &model) + model.p[0];
        out[0] = least(out[0], (now() - start) / n), start = now();
        for (at->k = 0; at->k < at->dimensions[0]; at->k++) {
            sf_read_numbers_at(at, &inputs);
            record->parameters_within(record, inputs.design, within), sink = within[0].lo;
        }
        out[1] = least(out[1], (now() - start - reading) / n);
    }
}

/* What an answer takes to be written, of states and folds two. */
static double seconds_of_writing(sf_call *at) {
    static const double A[2] = {1, 2};
    static const int flags[2];
    double best = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++) {
        const double start = now();
        for (at->k = 0; at->k < at->dimensions[0]; at->k++) {
            sf_query q = {.items = 0};
            sf_put(&q, SF_INTEGER, SF_OK);
            for (const char *type = at->row->types; type[1] != 0; type++) {
                if (*type == 'D')
                    sf_put_column(&q, SF_NUMBERS, 2, A, sizeof *A);
                else if (*type == 'B' || *type == 'K')
                    sf_put_column(&q, SF_FLAGS, 2, flags, 0);
                else if (*type != 'n')
                    sf_put(&q, SF_NUMBER, 1);
                if (*type == 'K')
                    sf_put_column(&q, SF_FLAGS, 2, flags, 0);
            }
            sf_write_answer(at, &q);
        }
        best = least(best, (now() - start) / (double)at->dimensions[0]);
    }
    return best;
}

/* What asking the clock takes. */
static double seconds_of_clock(void) {
    double clock = HUGE_VAL;
    for (int round = 0; round < 1000; round++) {
        const double start = now();
        clock = least(clock, now() - start);
    }
    return clock;
}

/* Of a place of a loop, without the clock's own time. */
static double seconds_in_lanes(const lanes *of) {
    return of->cells > 0 ? (of->seconds - seconds_of_clock() * (double)of->calls) / (double)of->cells : 0;
}

static int find_record(const char *name) {
    record = NULL;
    for (int i = 0; i < sf_records_baseline.count; i++)
        if (strcmp(sf_records_baseline.all[i]->name, name) == 0)
            record = sf_records_baseline.all[i];
    return record != NULL;
}

/* What is counted of a design; the numbers of out in `count`. */
enum {
    AVERAGES,
    IN_PAIRS,
    VALUES,
    RANGES,
    CELLS,
    AMPLITUDES,
    QUARTICS,
    MADE,
    IN_INTERVALS,
    MADE_IN_PAIRS,
    WRITTEN,
    SPLIT
};

/* asked: 0 states, 1 folds, 2 peaks, 3 onsets; inputs: one column after another, n of each; out: how often a design has
 * its averages taken, in pairs too, a function's value at an amplitude and its range on a cell, of loops over many
 * designs a cell and an amplitude, a quartic solved by itself, its parameters made, on intervals and in pairs too, and
 * its answer written; then the seconds of one of each. Returns 0 where there is no such record. */
int count(int question, const char *name, long n, double *inputs, double *out) {
    void (*const loops[])(sf_call *) = {sf_loop_states, sf_loop_folds, sf_loop_peaks, sf_loop_onsets};
    const sf_batch *row = sf_rows_of_many;
    double *taken = out + SPLIT;
    static unsigned char answers[4096];
    char *args[MOST_INPUTS + 6];
    ptrdiff_t steps[2 * (MOST_INPUTS + 6)] = {0}, dimensions[2] = {n, 6};
    sf_mechanism counting;
    sf_call call;
    int i, read;
    if (!find_record(name))
        return 0;
    while (row->loop != loops[question])
        row++;
    read = record->design_size + record->damping_size + row->at;
    for (i = 0; i < read; i++)
        args[i] = (char *)(inputs + i * n), steps[i] = sizeof *inputs;
    for (i = 0; row->types[i] != 0; i++)
        args[read + i] = (char *)answers + 64 * i;
    call = (sf_call){&counting, row, read, args, dimensions, steps, steps + read + i, 0};
    counting = *record;
    counting.averaged = counted_average, counting.averaged_in_pairs = counted_in_pairs;
    counting.parameters_of = counted_parameters, counting.parameters_within = counted_within;
    counting.many_in_pairs = counted_many_in_pairs;
    ranges = values = averages = in_pairs = in_intervals = made = quartics_solved = 0;
    memset(&cells_in_lanes, 0, sizeof cells_in_lanes), memset(&amplitudes_in_lanes, 0, sizeof amplitudes_in_lanes);
    memset(&made_in_lanes, 0, sizeof made_in_lanes);
    row->loop(&call);
    call.mechanism = record;
    out[AVERAGES] = (double)averages, out[IN_PAIRS] = (double)in_pairs, out[VALUES] = (double)values;
    out[RANGES] = (double)ranges, out[QUARTICS] = (double)quartics_solved, out[MADE] = (double)made;
    out[IN_INTERVALS] = (double)in_intervals, out[MADE_IN_PAIRS] = (double)made_in_lanes.cells, out[WRITTEN] = (double)n;
    out[CELLS] = (double)cells_in_lanes.cells, out[AMPLITUDES] = (double)amplitudes_in_lanes.cells;
    for (i = 0; i < SPLIT; i++)
        out[i] /= (double)n;
    mend();
    taken[AVERAGES] = seconds_of_averages(averages < KEPT ? averages : KEPT);
    taken[IN_PAIRS] = seconds_in_pairs(in_pairs < KEPT ? in_pairs : KEPT);
    taken[VALUES] = values > 0 ? seconds_of_values(values < KEPT ? values : KEPT) : 0;
    taken[RANGES] = ranges > 0 ? seconds_of_ranges(ranges < KEPT ? ranges : KEPT) : 0;
    taken[CELLS] = seconds_in_lanes(&cells_in_lanes), taken[AMPLITUDES] = seconds_in_lanes(&amplitudes_in_lanes);
    taken[QUARTICS] = quartics_solved > 0 ? seconds_of_quartics(quartics_solved < KEPT ? quartics_solved : KEPT) : 0;
    seconds_of_designs(&call, taken + MADE);
    taken[MADE_IN_PAIRS] = seconds_in_lanes(&made_in_lanes);
    taken[WRITTEN] = seconds_of_writing(&call);
    return 1;
}

/* One curve at F_0 in a window of Omega, with its folds; design: its numbers, then those of the damping; size: of the
 * arrays for so many points at least. out: points, how often its segments have averages taken and ranges found, then
 * the seconds of the segments, of the points on them, and of the folds. Returns 0 where there is no such record, no
 * room or no such curve. */
int curve(const char *name, const double *design, double F_0, const double *window, double samples, long size,
          double *out)
{
    sf_mechanism counting;
    sf_model model;
    sf_inputs inputs;
    sf_room *room = malloc(sizeof *room);
    double *block = malloc((size_t)size * SF_OF_POINT);
    const sf_points points = sf_points_in(block, size);
    long n = 0;
    int answered = 0;
    if (block != NULL && room != NULL && find_record(name) &&
        sf_take_design(record, design, model.p) && record->damping_of(design + record->design_size, model.damping) &&
        sf_prepare(record, design, &model) &&
        sf_give(record, design, design[record->design_size], design[record->design_size + 1], &inputs)) {
        out[3] = out[4] = out[5] = HUGE_VAL;
        for (int round = 0; round < 10 * ROUNDS; round++) {
            double start = now();
            answered = sf_make_skeleton(&model, &inputs, F_0, room) == SF_OK;
            out[3] = least(out[3], now() - start), start = now();
            n = sf_show(&model, F_0, window[0], window[1], samples, &room->work);
            if (!answered || n > size)
                break;
            sf_draw(&model, F_0, samples, &room->work.shown, &points);
            out[4] = least(out[4], now() - start), start = now();
            sf_settled_folds(&model, &inputs, F_0, room, &room->work.folds);
            out[5] = least(out[5], now() - start);
        }
        counting = *record, counting.averaged = counted_average, model.mechanism = &counting;
        ranges = averages = 0;
        sf_make_skeleton(&model, &inputs, F_0, room);
        out[0] = (double)n, out[1] = (double)averages, out[2] = (double)ranges;
        answered &= n <= size;
    }
    free(room), free(block);
    return answered;
}

static void timed_averages(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out) {
    const double start = now();
    record->averaged(self, n, A, p, out);
    averages_in_lanes.seconds += now() - start, averages_in_lanes.calls++, averages_in_lanes.cells += n;
}

/* of the amplitudes whose averages were taken just before */
static void timed_harmonics(const sf_mechanism *self, ptrdiff_t n, const double *A, const double *p, double *out) {
    const double start = now();
    record->harmonics(self, n, A, p, out);
    averages_in_lanes.seconds += now() - start, averages_in_lanes.calls++;
}

/* What n points of averaging's curve move to, on branches that are not closed; design as for `curve`, extent: as in
 * second_conventions.h. out: amplitudes whose averages are taken, and states whose balance is, then the seconds of one
 * of each. Returns 0 where there is no such record or no room. */
int second(const char *name, const double *design, double F_0, int count, long n, double *Omega, double *A,
           long long *branch, double *out) {
    const sf_points points = {.Omega = Omega, .A = A, .branch = branch};
    static const int closed[64];
    sf_mechanism counting;
    sf_model model;
    if (!find_record(name) || record->harmonics == NULL || !sf_take_design(record, design, model.p) ||
        !record->damping_of(design + record->design_size, model.damping) || !sf_prepare(record, design, &model))
        return 0;
    counting = *record, counting.averaged = timed_averages, counting.harmonics = timed_harmonics;
    model.mechanism = &counting;
    memset(&averages_in_lanes, 0, sizeof averages_in_lanes), memset(&balances_in_lanes, 0, sizeof balances_in_lanes);
    for (int round = 0; round < ROUNDS; round++) {
        sf_second_curve *solved = sf_second_follow(&model, F_0, (sf_wanted)count, n, &points, closed);
        if (solved == NULL)
            return 0;
        sf_second_free(solved);
    }
    out[0] = (double)averages_in_lanes.cells / ROUNDS, out[1] = (double)balances_in_lanes.cells / ROUNDS;
    out[2] = seconds_in_lanes(&averages_in_lanes), out[3] = seconds_in_lanes(&balances_in_lanes);
    return 1;
}

/* Roots in Omega of n quartics, rows of A, h, m, zeta, F_0, a whole number of blocks; out: of a quartic the roots in
 * lanes, those of them that go on by themselves, and how often its signs are unsure in double, then the seconds of the
 * signs of one in lanes, of a root there, of one that goes on, and of a quartic that is unsure. */
void quartics(long n, const double (*rows)[5], double *out) {
    const double clock = seconds_of_clock();
    long roots = 0, on = 0, unsure = 0;
    double taken[4] = {0};
    for (int round = 0; round < ROUNDS; round++)
        for (long first = 0; first < n; first += SF_QUARTICS) {
            static sf_quartics block;
            static sf_jobs jobs;
            double start;
            int i, k;
            for (i = 0; i < SF_QUARTICS; i++) {
                const double *row = rows[first + i];
                block.A[i] = row[0], block.h[i] = row[1], block.m[i] = row[2], block.zeta[i] = row[3],
                block.F_0[i] = row[4];
            }
            start = now(), sf_isolate_lanes(SF_QUARTICS, &block), taken[0] += now() - start - clock;
            for (i = jobs.n = 0; i < SF_QUARTICS; i++) {
                sf_place place[3];
                const int found = block.signs[i] == SF_UNSURE ? 0 : sf_places_of_signs((int)block.signs[i], place);
                for (k = 0; k < found; k++)
                    sf_add_job(&block, i, place[k], &jobs);
            }
            start = now(), sf_refine_lanes(&jobs), taken[1] += now() - start - clock, roots += jobs.n, start = now();
            for (k = 0; k < jobs.n; k++)
                if (jobs.is_last[k] == 0)
                    sink = sf_root_of_job(&jobs, k), on++;
            taken[2] += now() - start - clock, start = now();
            for (i = 0; i < SF_QUARTICS; i++)
                if (block.signs[i] == SF_UNSURE) {
                    double Omega[3];
                    sink = sf_response_roots(block.A[i], block.h[i], block.m[i], block.zeta[i], block.F_0[i], Omega),
                    unsure++;
                }
            taken[3] += now() - start - clock;
        }
    const double all = (double)ROUNDS * (double)n;
    out[0] = (double)roots / all, out[1] = (double)on / all, out[2] = (double)unsure / all;
    out[3] = taken[0] / all, out[4] = taken[1] / fmax((double)roots, 1), out[5] = taken[2] / fmax((double)on, 1);
    out[6] = taken[3] / fmax((double)unsure, 1);
}
