/* Records that the solvers fill, and the workspace that they share: allocated once, used for any number of designs. */
#pragma once

#include "arcs.h"
#include "points_work.h"

enum { SF_MOST_FOLDS = 48, SF_MOST_SEGMENTS = SF_MOST_ARCS + SF_MOST_FOLDS };

/* up: whether a sweep leaves the fold for a larger amplitude */
typedef struct {
    double Omega, A;
    int up, corner;
} sf_fold;

/* What is known on a breakpoint at which the force jumps, and the frequencies at which the response passes it */
typedef struct {
    sf_sample at;
    int n;
    double Omega[3];
} sf_corner;

/* undecided: whether there may be another pair, whose amplitudes are the same double; close: whether rounding may have
 * decided how many there are */
typedef struct {
    int n, undecided, close;
    sf_status status;
    sf_fold at[SF_MOST_FOLDS];
} sf_folds;

typedef struct {
    double F_SN, Omega, A;
    sf_onset_kind kind;
    /* lowest level at which the fold locus ends at Omega = 0, or with a preload at A = 0, or infinite; with SF_NO_BOUND
     * a forcing that none bounds */
    double rest;
    int undecided; /* whether there may be one that doubles do not resolve */
} sf_onset;

/* Whether folds that end at Omega = 0, or with a preload at A = 0, are below it, or without it. */
static inline int sf_is_rest_below(const sf_onset *found) {
    return found->rest < (found->kind == SF_NO_KIND ? HUGE_VAL : found->F_SN);
}

/* isola: an isola point, else a cusp; minimum: of the level along the fold locus; saddle: F has a saddle in (A,
 * Omega); few_digits: it does not settle, and is off by more than roundings, or by an unknown amount */
typedef struct {
    double F_0, Omega, A;
    int isola, minimum, saddle, few_digits;
} sf_extremum;

/* A stretch of curve monotone in A and in Omega, with one stability. Ends 0 and 1 by rising A; upward: whether A rises
 * along the curve; root `index` of `count` */
typedef struct {
    double A[2], Omega[2];
    int index, count, curve, upward, stable;
} sf_segment;

/* Segments in order along each curve; segment start[c] is the first of curve c. */
typedef struct {
    int segments, curves;
    int start[SF_MOST_SEGMENTS + 1], closed[SF_MOST_SEGMENTS];
    sf_segment segment[SF_MOST_SEGMENTS];
} sf_skeleton;

/* extrema: cusps and isola points of the locus; corner: of each breakpoint below A_max */
typedef struct {
    double A_max;
    sf_stretches pieces;
    sf_zeros zeros, extrema;
    sf_graph locus, response;
    sf_tour tour;
    sf_folds folds;
    sf_corner corner[SF_MOST_BREAKS];
    sf_skeleton skeleton, shown;
    sf_law_search points;
} sf_work;

static inline double sf_first_of(const sf_segment *segment, const double ends[2]) { return ends[1 - segment->upward]; }
static inline double sf_last_of(const sf_segment *segment, const double ends[2]) { return ends[segment->upward]; }
