/* Codes and constants of the solvers of averaged motions, in C and in Python.

   Written by `make derive` from derivations/codegen/conventions.toml; never edit. */

#ifndef CONVENTIONS_H
#define CONVENTIONS_H

/* Status of a result. */
typedef enum {
    SF_OK = 0, /* a result */
    SF_INVALID = 1, /* a parameter outside its domain */
    SF_STICKS = 2, /* sticks: F_0 <= 4 mu/pi */
    SF_NONE = 3, /* no such result: for example no fold, or no breakpoint */
    SF_UNBOUNDED = 4, /* no viscous damping: the response is unbounded, there is no lowest forcing */
    SF_NO_BOUND = 5, /* no amplitude was found that bounds the response */
    SF_TOO_MANY = 6, /* more results than max_count */
    SF_UNRESOLVED = 7, /* branches coincide within rounding */
    SF_NO_MEMORY = 8 /* out of memory */
} sf_status;

/* Kind of the lowest forcing with a fold. */
typedef enum {
    SF_NO_KIND = 0, /* none */
    SF_CUSP_KIND = 1, /* two folds merge: the response has a vertical inflection */
    SF_ISOLA_KIND = 2, /* an isolated curve is born */
    SF_CORNER_KIND = 3 /* at a breakpoint */
} sf_onset_kind;

/* Direction of the jump at a fold. */
typedef enum {
    SF_EMPTY = 0, /* an unused slot */
    SF_JUMP_UP = 1, /* to a larger amplitude */
    SF_JUMP_DOWN = 2, /* to a smaller one */
    SF_JUMP_UP_AT_CORNER = 3, /* to a larger amplitude, from a corner at a breakpoint */
    SF_JUMP_DOWN_AT_CORNER = 4 /* to a smaller one, from a corner at a breakpoint */
} sf_fold_kind;

/* Kind of a result whose gradient is computed. */
typedef enum {
    SF_STATE_PINNED = 0, /* a steady state; with Omega = 0 a peak at rest */
    SF_FOLD_PINNED = 1, /* a fold at a forcing */
    SF_CORNER_FOLD_PINNED = 2, /* a fold at a forcing, on a breakpoint */
    SF_PEAK_PINNED = 3, /* a peak at a forcing */
    SF_CUSP_PINNED = 4, /* where two folds meet */
    SF_ISOLA_PINNED = 5, /* where an isolated curve is born */
    SF_CORNER_TOP_PINNED = 6, /* the least forcing on a breakpoint */
    SF_CORNER_END_PINNED = 7, /* where the fold locus meets a breakpoint */
    SF_CORNER_BACKBONE_PINNED = 8, /* where the backbone meets a breakpoint */
    SF_CORNER_REST_PINNED = 9 /* at Omega = 0 on a breakpoint */
} sf_pinned;

/* Whether a result has a gradient. */
typedef enum {
    SF_OK_MOVES = 0, /* a gradient */
    SF_NOTHING_MOVES = 1, /* no result to differentiate */
    SF_MEETS_MOVES = 2, /* the result merges with another one, beyond which there is none; slopes are unbounded */
    SF_TURNS_MOVES = 3, /* the result reaches a breakpoint, with different gradients on either side */
    SF_BOUNDLESS_MOVES = 4 /* a slope is infinite, or a forcing is 0, as at the end of a parameter's domain */
} sf_moves_status;

/* highest frequency: for F_0 >= 1e-70 the square of A is in the range of doubles up to it */
#define SF_HIGHEST_OMEGA 1e+40
/* size of a force's parameter and of 4 mu/pi: beyond it ordinary amplitudes leave the range of doubles */
#define SF_LARGEST 1.0000000000000001e+300
/* an undamped response without a reach is cut at this times F_0 */
#define SF_STATIC_MULTIPLE 100.0
/* the forcing is raised by this factor until the onset lies below it */
#define SF_RAISE 4.0
/* how often, at most */
#define SF_RAISES 30
/* by this factor from there on, where the force is still nearly its slope at rest */
#define SF_FAR_RAISE 1048576.0
/* how often, at most: fourth powers of it are in the range of doubles */
#define SF_FAR_RAISES 15
/* how nearly the forcing is known beyond which motions go ever farther */
#define SF_NEAR_BOUND 1.52587890625e-05
/* bounds that are tried on an amplitude, each twice the last */
#define SF_FINE_RUNGS 12
/* and in all, in steps that double too */
#define SF_RUNGS 100
/* until they exceed this */
#define SF_COARSEST 10000.0
/* multiple of the last breakpoint from which on a force that levels off does not rise any more */
#define SF_NEAR_ENDLESS 1048576.0
/* represents an infinite amplitude, and an infinite multiple of one */
#define SF_ENDLESS 1.152921504606847e+18
/* relative error that is taken for granted in a kernel's value */
#define SF_ERROR 3.5527136788005009e-15
/* share of its first term below which a sum of two has lost digits */
#define SF_CANCELLED 0.25
/* share of |h| below which A h_A may have lost digits, and Omega^2 = h_A with it */
#define SF_SOFT 0.01
/* a root is the one meant if it lies, relatively, this near to what has lost digits */
#define SF_SAME_ROOT 0.001
/* relative step of A up to which Newton's last step is taken */
#define SF_LAST_STEP 1e-08
/* where a search begins that cannot begin at A = 0 */
#define SF_FIRST 6.2230152778611417e-61
/* an amplitude over that where its piece begins, from which h is smooth */
#define SF_FAR_ABOVE 1073741824.0
/* relative width of an interval of A that is not cut any more */
#define SF_NARROW 8.8817841970012523e-16
/* intervals of A, after which a search is given up: numbers overflow */
#define SF_MOST_CELLS 50000
/* relative width of an interval that holds no amplitude */
#define SF_NO_WIDTH 4.4408920985006262e-16
/* share of the last step up to which a step is taken in a bracket */
#define SF_SLOW 0.59999999999999998
/* relative distance from an amplitude that rounding makes of none */
#define SF_AT_ROOT 8.8817841970012523e-16
/* forcing that is raised first where there is no friction */
#define SF_FIRST_F_0 9.9999999999999995e-07
/* an amplitude below `ENDLESS`, to tell what a level tends to */
#define SF_FAR_OUT 1073741824.0
/* amplitudes at which the rest is looked at fall by this */
#define SF_FALL 9.5367431640625e-07
/* how many of these there are */
#define SF_FALLS 6
/* share by which what tends to 0 falls from there to `ENDLESS` */
#define SF_TENDS 9.5367431640625e-07
/* about h_A at the next double above a breakpoint b, over J/b, where the force jumps by J */
#define SF_STEEP 16777216.0
/* frequencies farther apart than this, relatively, are distinct whatever the rounding */
#define SF_DISTINCT 0.001
/* of a curve's points: the length that each part has besides its own */
#define SF_SPREAD 0.001
/* share of Omega's change below which A hardly changes, relatively */
#define SF_HARDLY 1.4901161193847656e-08
/* events closer than this, relatively, may have changed their order */
#define SF_COINCIDE 5.6843418860808015e-14
/* share of its size that rounding may add to a value */
#define SF_CLOSE 9.0949470177292824e-13
/* frequencies closer than this are one where a curve ends */
#define SF_NEAR_END 9.0949470177292824e-13
/* share of its size below which what vanishes where answers meet leaves no digit of a gradient */
#define SF_MEETING 2.9802322387695312e-08
/* amplitudes closer than this, relatively, are one */
#define SF_SAME 1.7763568394002505e-15
/* distance of rho from 1, where critical points meet */
#define SF_MAY_MEET 1.4901161193847656e-08
/* relative step up to which a critical point is not a double one */
#define SF_SIMPLE 0.0009765625
/* what Newton's iteration leaves of a critical point, relatively */
#define SF_POLISHED 3.4694469519536142e-18
/* share of its terms beyond which a value is its rise */
#define SF_BY_RISE 9.0949470177292824e-13
/* relative step, share of the way to a fold, of Halley's last */
#define SF_NEAR_ROOT 0.000244140625
/* what Newton's last step leaves of a root, relatively */
#define SF_CORRECTED 6.9388939039072284e-18
/* steps at most, of Newton's iteration to a critical point */
#define SF_POLISHING 8
/* of Halley's to a root */
#define SF_NEARING 12
/* of Newton's after that, kept in its bracket */
#define SF_CORRECTING 100

/* by what an answer is: three conditions in the order in which they are solved, for which unknowns, whether the last two together, and slopes that vanish */
#define SF_SYSTEMS { \
    {5, 6, 0, 2, 1, 0, 0, 5, 5}, \
    {5, 0, 1, 2, 1, 0, 0, 0, 0}, \
    {5, 7, 0, 2, 0, 1, 0, 5, 5}, \
    {5, 0, 3, 2, 0, 1, 0, 1, 1}, \
    {1, 0, 2, 1, 2, 0, 0, 0, 3}, \
    {0, 1, 3, 2, 0, 1, 1, 0, 1}, \
    {7, 0, 3, 0, 2, 1, 0, 1, 1}, \
    {7, 1, 0, 0, 1, 2, 0, 0, 0}, \
    {7, 4, 0, 0, 1, 2, 0, 5, 5}, \
    {7, 6, 0, 0, 1, 2, 0, 5, 5}, \
}

#endif
