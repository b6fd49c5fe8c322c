/* Records that the proofs fill: zeros along the amplitude, and enclosures of what a query returns. */
#pragma once

#include "exact_inputs.h"
#include "points_work.h"
#include "work.h"

enum { SF_MOST_UNDECIDED = 32 };

/* One zero: the cell that holds it, by how much that exceeds the beginning of its piece, and whether the function rises
 * through it. */
typedef struct {
    sf_cell on;
    sf_interval beyond;
    int piece, channel, rising;
} sf_proven;

/* Amplitudes between which doubles do not decide, by how much they exceed the beginning of their piece. */
typedef struct {
    double low, high;
    int piece, channel;
} sf_undecided_between;

typedef struct {
    int n, n_undecided, cells, full;
    sf_proven at[SF_MOST_ZEROS];
    sf_undecided_between undecided[SF_MOST_UNDECIDED];
} sf_proof;

/* corner: on a breakpoint; sign: of F_AA at a fold, of F_A at a state, 0 where it is not known */
typedef struct {
    sf_interval Omega, A;
    int corner, sign;
} sf_enclosure;

/* Of the folds at a forcing, or of the states at a frequency. undecided: intervals of A in which doubles do not decide;
 * bounded: whether no state is proved to lie above A_max; full: more of something than there are places */
typedef struct {
    int n, n_undecided, full, bounded;
    sf_enclosure at[SF_MOST_ZEROS];
    sf_interval undecided[SF_MOST_UNDECIDED];
    double A_max;
} sf_certificate;

/* Whether all up to A_max are enclosed, and nothing else is there. */
static inline int sf_is_proved(const sf_certificate *found) { return found->n_undecided == 0 && !found->full; }

/* Of the lowest forcing that has a fold: what holds it, where it lies, and of what kind it is, if that is known.
 * proved: whether nothing lower is left undecided */
typedef struct {
    sf_interval F_SN, Omega, A;
    sf_onset_kind kind;
    int proved;
} sf_proved_onset;

/* Where answers are made that a proof decides if doubles are inconclusive. A, stable: states at a frequency;
 * inconclusive: whether doubles were on the folds, undecided: whether they still are; proofs: how many have been
 * tried of states; followed: whether the segments of the response are in work, or cannot be, by `status` */
typedef struct {
    sf_work work;
    sf_proof proof;
    sf_certificate found;
    double A[SF_MOST_SEGMENTS];
    unsigned char stable[SF_MOST_SEGMENTS];
    int inconclusive, undecided, followed;
    sf_status status;
    long proofs;
} sf_room;
