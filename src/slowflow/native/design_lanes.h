/* Many designs at once. Takes blocks of cells of amplitudes and of brackets; returns which cells hold a zero, and the
 * zeros, by loops that vectorise.
 *
 * What h_A and h_AA are on a cell follows from their values at its ends, as h_AAA is monotone on a piece of the force
 * (cells.h). For states F's first and second derivative along A follow from these: F has no zero where R is too large
 * or too small on all of the cell, or where F has one sign at both ends and is monotone, or curved so that it cannot
 * come to 0 between; and one where the signs differ and F is monotone or of one curvature. For a peak it is F at its
 * critical points in Omega, for a fold what F = F_A = 0 leave of R, and for a cusp F_A at the zeros of F_AA, as in
 * along.h.
 * Bounds are computed in doubles and widened by more than rounding may make of them. Where a number of doubles is near
 * to deciding, or a design needs more cells than there are places, it is left to states.h.
 */
#pragma once

#include <math.h>
#include <stddef.h>

#include "clones.h"
#include "conventions.h"

enum { SF_LANE_CELLS = 264 };

/* What is known of an amplitude, as rows: A, h, h_A, h_AA, h_AAA, and for folds and cusps k = h - A h_A */
enum { SF_PROBE_ROWS = 6 };

/* What a design is to these loops, as rows: Omega, of which peaks and folds have none, zeta, m, F_0. Of cusps the first
 * is the channel (along.h), 1 for the larger Omega^2 and -1 for the other one; the last is the forcing above which they
 * may be left out */
enum { SF_TASK_ROWS = 4, SF_LAST_ROWS = 3 };

/* rows of inputs of these loops; of brackets those kept for the next round, and with the last evaluation */
enum { SF_INPUT_ROWS = 17, SF_KEPT_ROWS = 8, SF_REMEMBERED_ROWS = SF_KEPT_ROWS + SF_LAST_ROWS };

typedef enum { SF_HAS_NONE, SF_HAS_ONE, SF_IS_OPEN, SF_IS_UNDECIDED } sf_verdict;

/* of: which design of the block; base: where the piece of the force begins; cut: where an open cell is cut, or where F
 * is likely to vanish in one that has a zero; falls: whether F is negative at its low end */
typedef struct {
    int n, of[SF_LANE_CELLS];
    union {
        double inputs[SF_INPUT_ROWS][SF_LANE_CELLS];
        struct {
            double low[SF_PROBE_ROWS][SF_LANE_CELLS], high[SF_PROBE_ROWS][SF_LANE_CELLS];
            double task[SF_TASK_ROWS][SF_LANE_CELLS], base[SF_LANE_CELLS];
        };
    };
    double verdict[SF_LANE_CELLS], cut[SF_LANE_CELLS], rises[SF_LANE_CELLS];
} sf_lane_cells;

/* Brackets with what is known of an amplitude inside. next: where F vanishes by that estimate; change: how far that
 * is from there; base: where the piece of the force begins; last: of folds x, x^2 = A^2 - base^2, and of cusps A, the
 * function and its slope along that where it was evaluated before */
typedef struct {
    int n, of[SF_LANE_CELLS];
    union {
        double inputs[SF_INPUT_ROWS][SF_LANE_CELLS];
        struct {
            double at[SF_PROBE_ROWS][SF_LANE_CELLS], task[SF_TASK_ROWS][SF_LANE_CELLS];
            double lo[SF_LANE_CELLS], hi[SF_LANE_CELLS], rises[SF_LANE_CELLS], base[SF_LANE_CELLS];
            double last[SF_LAST_ROWS][SF_LANE_CELLS];
        };
    };
    double next[SF_LANE_CELLS], change[SF_LANE_CELLS], Omega[SF_LANE_CELLS]; /* Omega: but of states */
} sf_lane_zeros;

/* The verdicts of all cells; places that are left over of a vector are overwritten. */
void sf_judge_states(sf_lane_cells *cells);
/* The same of the highest peak, SF_HAS_ONE only of one at which F rises with A. */
void sf_judge_peaks(sf_lane_cells *cells);
/* The same of folds, zeta > 0. */
void sf_judge_folds(sf_lane_cells *cells);
/* The same of the cusps of a first piece on one channel, undecided where h_A < 0 is not sure on all of the cell. */
void sf_judge_cusps(sf_lane_cells *cells);
/* The next amplitudes of all brackets. */
void sf_approach_states(sf_lane_zeros *zeros);
void sf_approach_peaks(sf_lane_zeros *zeros);
void sf_approach_folds(sf_lane_zeros *zeros);
void sf_approach_cusps(sf_lane_zeros *zeros);

/* What is known of a cell, or is left to the solvers of one design. */
static inline double sf_verdict_of(int is_undecided, int has_none, int has_one) {
    return is_undecided ? SF_IS_UNDECIDED : has_none ? SF_HAS_NONE : has_one ? SF_HAS_ONE : (double)SF_IS_OPEN;
}

#define SF_LESSER(a, b) ((a) < (b) ? (a) : (b))
#define SF_GREATER(a, b) ((a) > (b) ? (a) : (b))
#define SF_FINITE_SIZE(x) (fabs(x) < HUGE_VAL ? fabs(x) : 0.0)

/* As many places from n on as fill a vector. */
static inline ptrdiff_t sf_filled(ptrdiff_t n) { return SF_WHOLE(n + SF_WIDEST - 1); }

/* A row as far as whole vectors, with copies of the last. */
static inline void sf_fill(double *row, ptrdiff_t n) {
    for (ptrdiff_t i = n; i < sf_filled(n); i++)
        row[i] = row[n - 1];
}

static inline void sf_fill_rows(double (*rows)[SF_LANE_CELLS], ptrdiff_t n) {
    for (int k = 0; k < SF_INPUT_ROWS; k++)
        sf_fill(rows[k], n);
}

/* What a question of cells and brackets is to others, of the loops `judge` and `approach` of its file. */
#define SF_DEFINE_QUESTION(JUDGE, APPROACH)                                                                            \
    void JUDGE(sf_lane_cells *cells) {                                                                                 \
        sf_fill_rows(cells->inputs, cells->n);                                                                         \
        judge(sf_filled(cells->n), cells);                                                                             \
    }                                                                                                                  \
    void APPROACH(sf_lane_zeros *zeros) {                                                                              \
        sf_fill_rows(zeros->inputs, zeros->n);                                                                         \
        approach(sf_filled(zeros->n), zeros);                                                                          \
    }

/* Halley's step from A to where a function vanishes that has this value, slope and bend there, kept in bracket i.
 * is_low: whether it is not there yet. Returns the step. */
static inline double sf_halley(sf_lane_zeros *zeros, ptrdiff_t i, double A, int is_low, double f, double slope,
                               double bend) {
    const double lo = is_low ? A : zeros->lo[i], hi = is_low ? zeros->hi[i] : A;
    const double step = 2 * f * slope / (2 * slope * slope - f * bend), next = A - step;
    const int is_inside = (next >= lo) & (next <= hi);
    zeros->lo[i] = lo, zeros->hi[i] = hi;
    zeros->next[i] = is_inside ? next : 0.5 * (lo + hi);
    zeros->change[i] = is_inside ? fabs(step) : HUGE_VAL;
    return step;
}

/* The least of what lies above the line that falls from f_a with the slope `falls` <= 0 and above the one that rises to
 * f_b with `rises` >= 0, on a cell of this width: where both meet. */
static inline double sf_lane_least(double f_a, double f_b, double falls, double rises, double width) {
    const double apart = falls - rises, meet = (f_b - f_a - rises * width) / (apart < 0 ? apart : -1.0);
    const double within = meet > 0 ? SF_LESSER(meet, width) : 0.0;
    const double by_a = f_a + falls * within, by_b = f_b - rises * (width - within);
    /* a vertical line is no bound */
    return fabs(falls) < HUGE_VAL ? (rises < HUGE_VAL ? SF_LESSER(by_a, by_b) : f_a + falls * width)
                                  : f_b - rises * width;
}

/* What h_A and h_AA are on a cell; e1: what rounding may make of h_A, which is in these */
typedef struct {
    double h1_lo, h1_hi, h2_lo, h2_hi, e1;
} sf_lane_slopes;

static inline sf_lane_slopes sf_slopes_on(double a, double h_a, double h1_a, double h2_a, double h3_a, double b,
                                          double h_b, double h1_b, double h2_b, double h3_b, double base) {
    const double width = b - a;
    /* what kernels and the roundings below may make of h_A and h_AA; sf_widen_gains */
    const double near_a = a > base ? (a + fabs(h_a)) / sqrt((a - base) * (a + base)) : 0.0;
    const double near_b = (b + fabs(h_b)) / sqrt((b - base) * (b + base));
    const double size2 = SF_FINITE_SIZE(h2_a) + fabs(h2_b), size1 = SF_FINITE_SIZE(h1_a) + fabs(h1_b);
    const double e2 = SF_CLOSE * size2 + 4 * SF_ERROR * b * (SF_FINITE_SIZE(h3_a) + fabs(h3_b));
    const double e1 = SF_CLOSE * size1 + 4 * SF_ERROR * (b * size2 + near_a + near_b);
    /* h_AA is monotone where h_AAA has one sign */
    const double h3_lo = SF_LESSER(h3_a, h3_b), h3_hi = SF_GREATER(h3_a, h3_b);
    const int h3_signed = (h3_lo >= 0) | (h3_hi <= 0);
    const double falls3 = SF_LESSER(h3_lo, 0.0), rises3 = SF_GREATER(h3_hi, 0.0);
    const double h2_least = SF_LESSER(h2_a, h2_b), h2_most = SF_GREATER(h2_a, h2_b);
    const double h2_under = sf_lane_least(h2_a, h2_b, falls3, rises3, width);
    const double h2_over = -sf_lane_least(-h2_a, -h2_b, -rises3, -falls3, width);
    const double h2_lo = (h3_signed ? h2_least : h2_under) - e2, h2_hi = (h3_signed ? h2_most : h2_over) + e2;
    /* h_A likewise */
    const int h2_signed = (h2_lo >= 0) | (h2_hi <= 0);
    const double falls2 = SF_LESSER(h2_lo, 0.0), rises2 = SF_GREATER(h2_hi, 0.0);
    const double h1_least = SF_LESSER(h1_a, h1_b), h1_most = SF_GREATER(h1_a, h1_b);
    const double h1_under = sf_lane_least(h1_a, h1_b, falls2, rises2, width);
    const double h1_over = -sf_lane_least(-h1_a, -h1_b, -rises2, -falls2, width);
    return (sf_lane_slopes){(h2_signed ? h1_least : h1_under) - e1, (h2_signed ? h1_most : h1_over) + e1, h2_lo, h2_hi,
                            e1};
}

/* A function between its values at the ends of a cell whose slope is known. */
static inline double sf_lane_under(double f_a, double f_b, double slope_lo, double slope_hi, double width) {
    const int monotone = (slope_lo >= 0) | (slope_hi <= 0);
    const double least = SF_LESSER(f_a, f_b);
    const double under = sf_lane_least(f_a, f_b, SF_LESSER(slope_lo, 0.0), SF_GREATER(slope_hi, 0.0), width);
    return monotone ? least : under;
}

/* The critical points of F in Omega, as sf_critical_points has them: positive roots of A w^3 + p w + q, q >= 0, which
 * exist for p < 0 up to rho = 1 */
typedef struct {
    double rho, w1, w2;
} sf_lane_critical;

static inline sf_lane_critical sf_lane_critical_at(double A, double p, double q) {
    const double c0 = 0.86602540378443865, rise = 0.13397459621556135;
    const double below = p < 0 ? -p : 1.0, r = sqrt(below / (3 * A)), rho = 1.5 * q / (below * r);
    const double from = c0 + rho * (1. / 6 + rho * ((3 * rise - 4. / 9) + rho * (5. / 18 - 2 * rise)));
    const double nearer = (8 * from * from * from + rho) / (12 * from * from - 3);
    const double c = (8 * nearer * nearer * nearer + rho) / (12 * nearer * nearer - 3), gap = (1 - rho) * (1 + rho);
    const double y2 = c + 1.7320508075688773 * sqrt(SF_GREATER(gap, 0.0)) / (4 * c * c - 1);
    return (sf_lane_critical){rho, r * rho / (y2 * c), r * y2};
}

/* An amplitude well inside a cell, as sf_amid; next to A = 0 in the middle. */
static inline double sf_lane_amid(double base, double a, double b) {
    const int near = a < SF_FAR_ABOVE * base;
    const double steps = near ? base : 1.0, pa = a / steps, pb = b / steps;
    const double mean = 0.5 * (sqrt(SF_GREATER((pa - 1) * (pa + 1), 0.0)) + sqrt(SF_GREATER((pb - 1) * (pb + 1), 0.0)));
    const double amid = near ? base * sqrt(1 + mean * mean) : 0.5 * (a + b);
    return b > 4 * a ? (a > 0 ? sqrt(a) * sqrt(b) : 0.5 * b) : amid;
}

/* Where a function vanishes that has these values and slopes at two amplitudes, an estimate: by the cubic that
 * gives A */
static inline double sf_zero_near(double a, double y_a, double slope_a, double b, double y_b, double slope_b) {
    const double over = 1 / (y_b - y_a), chord = (b - a) * over, flat_a = 1 / slope_a, flat_b = 1 / slope_b;
    const double bend = (chord - flat_a) * over, third = ((flat_b - chord) * over - bend) * over;
    return a - y_a * flat_a + y_a * y_a * (bend - y_b * third);
}

/* Where a function with values on either side of zero is likely to vanish: by both values and slopes the cubic that
 * gives A, else the parabola from the end whose slope is known, else `inside`. */
static inline double sf_lane_zero(double a, double y_a, double slope_a, double b, double y_b, double slope_b,
                                  double inside) {
    const double width = b - a, by_cubic = sf_zero_near(a, y_a, slope_a, b, y_b, slope_b);
    const double rise = -slope_b * width, curve = y_a - y_b - rise;
    const double root = sqrt(SF_GREATER(rise * rise - 4 * curve * y_b, 0.0));
    const double by_parabola = b + 2 * y_b * width / (rise + (y_b > 0 ? -root : root));
    return (by_cubic > a) & (by_cubic < b) & (fabs(slope_a) < HUGE_VAL) ? by_cubic
           : (by_parabola > a) & (by_parabola < b)                      ? by_parabola
                                                                        : inside;
}

/* Into the bracket by `sf_zero_near`, else by Newton's step from the first, else in the middle */
static inline double sf_next_from(double a, double y_a, double slope_a, double b, double y_b, double slope_b, double lo,
                                  double hi) {
    const double guess = sf_zero_near(a, y_a, slope_a, b, y_b, slope_b), step = a - y_a / slope_a;
    const int is_near = (fabs(y_a) < 0.5 * fabs(y_b)) | ((y_a < 0) != (y_b < 0));
    return is_near & (guess > lo) & (guess < hi) ? guess : (step > lo) & (step < hi) ? step : 0.5 * (lo + hi);
}
