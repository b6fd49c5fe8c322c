/* States of many designs: in go blocks of cells of amplitudes and of brackets, out comes which cells hold a zero of F, and the
 * zeros, by loops that vectorise.
 *
 * A cell is told by F's first and second derivative along A, which follow from h's: h_AAA is monotone on a piece of the force
 * (cells.h). F has no zero where R is too large or too small on all of the cell, or where F has one sign at both ends and is
 * monotone, or curved so that it cannot come to 0 between; and one where the signs differ and F is monotone or of one curvature.
 * Bounds are computed in doubles and widened by more than rounding may make of them. Where a number of doubles is near to
 * deciding, or a design needs more cells than there are places, it is left to states.h.
 */
#ifndef SF_STATE_LANES_H
#define SF_STATE_LANES_H

#include <stddef.h>

enum { SF_STATE_CELLS = 264, SF_STATE_VECTOR = 8 };

/* What is known of an amplitude, as rows: A, h, h_A, h_AA, h_AAA */
enum { SF_PROBE_ROWS = 5 };

/* What a design is to these loops, as rows: Omega^2, 2 zeta Omega, m, F_0 */
enum { SF_ASKED_ROWS = 4 };

typedef enum { SF_HAS_NONE, SF_HAS_ONE, SF_IS_OPEN, SF_IS_DOUBTFUL } sf_verdict;

/* of: which design of the block; base: where the piece of the force begins; cut: where an open cell is cut, or where F is
 * likely to vanish in one that has a zero; falls: whether F is negative at its low end */
typedef struct {
    int n, of[SF_STATE_CELLS];
    double low[SF_PROBE_ROWS][SF_STATE_CELLS], high[SF_PROBE_ROWS][SF_STATE_CELLS];
    double asked[SF_ASKED_ROWS][SF_STATE_CELLS], base[SF_STATE_CELLS];
    double verdict[SF_STATE_CELLS], cut[SF_STATE_CELLS], rises[SF_STATE_CELLS];
} sf_state_cells;

/* Brackets with what is known of an amplitude inside. next: where F vanishes as far as that tells; left: by how much A may
 * be wrong then, relatively */
typedef struct {
    int n, of[SF_STATE_CELLS];
    double at[SF_PROBE_ROWS][SF_STATE_CELLS], asked[SF_ASKED_ROWS][SF_STATE_CELLS];
    double lo[SF_STATE_CELLS], hi[SF_STATE_CELLS], rises[SF_STATE_CELLS], next[SF_STATE_CELLS], moved[SF_STATE_CELLS];
} sf_state_zeros;

/* The verdicts of all cells; places that are left over of a vector are overwritten. */
void sf_judge_lanes(sf_state_cells *cells);
/* The next amplitudes of all brackets. */
void sf_approach_lanes(sf_state_zeros *zeros);

#endif
