/* What the solvers of averaged motions have in common, in C and in Python.

   Written by `make derive`; never edit.
   Input: derivations/conventions.py */

#ifndef CONVENTIONS_H
#define CONVENTIONS_H

/* How a solver fared. */
typedef enum {
    SF_OK = 0, /* an answer */
    SF_INVALID = 1, /* a parameter outside its domain */
    SF_STICKS = 2, /* sticks: F_0 <= 4 mu/pi */
    SF_NONE = 3, /* there is none (no fold, no breakpoint) */
    SF_UNBOUNDED = 4, /* no viscous damping: no end of the response, no lowest forcing */
    SF_NO_BOUND = 5, /* no amplitude was found that bounds the response */
    SF_TOO_MANY = 6, /* more of them than places */
    SF_UNRESOLVED = 7, /* branches coincide within rounding */
    SF_NO_MEMORY = 8 /* out of memory */
} sf_status;

/* What the lowest forcing with a fold is. */
typedef enum {
    SF_NO_KIND = 0, /* there is none */
    SF_CUSP_KIND = 1, /* two folds meet: the response gets a vertical inflection */
    SF_ISOLA_KIND = 2, /* an isolated curve is born */
    SF_CORNER_KIND = 3 /* at a breakpoint */
} sf_onset_kind;

/* Where a sweep goes that leaves a fold. */
typedef enum {
    SF_EMPTY = 0, /* an empty place */
    SF_JUMP_UP = 1, /* to a larger amplitude */
    SF_JUMP_DOWN = 2, /* to a smaller one */
    SF_JUMP_UP_AT_CORNER = 3, /* to a larger amplitude, from a corner at a breakpoint */
    SF_JUMP_DOWN_AT_CORNER = 4 /* to a smaller one, from a corner at a breakpoint */
} sf_fold_kind;

/* an undamped response without a reach is cut at this times F_0 */
#define SF_STATIC_MULTIPLE 100.0
/* the forcing is raised by this factor until the onset lies below it */
#define SF_RAISE 4.0
/* how often, at most */
#define SF_RAISES 30
/* amplitudes closer than this, relatively, are one */
#define SF_SAME 1.7763568394002505e-15

#endif
