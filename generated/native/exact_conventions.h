/* What the integrators of the equation of motion have in common, in C and in Python.

   Written by `make derive` from derivations/codegen/conventions.toml; never edit. */

#ifndef EXACT_CONVENTIONS_H
#define EXACT_CONVENTIONS_H

/* How a motion or a cycle fared. */
typedef enum {
    SF_GOOD = 0, /* an answer */
    SF_STALLS = 1, /* more steps than allowed, or numbers that are not finite */
    SF_CHATTERS = 2, /* more phases in a turn than allowed */
    SF_ESCAPES = 3, /* the restoring force does not hold the mass */
    SF_SINGULAR = 4, /* equations without a single solution */
    SF_DIVERGES = 5, /* Newton's iteration does not converge */
    SF_NO_MEMORY = 6 /* out of memory */
} sf_outcome;

/* What ends smooth motion. */
typedef enum {
    SF_TIME = 0, /* the end of the time requested */
    SF_STOP = 1, /* the velocity vanishes */
    SF_EDGE = 2, /* a breakpoint */
    SF_NOTHING = 3 /* not ended */
} sf_event;

/* A cycle's further equation, by which Omega is free. */
typedef enum {
    SF_NO_MORE = 0, /* none: Omega is given */
    SF_ROW = 1, /* row z = value */
    SF_BORDER = 2 /* a border's margin vanishes */
} sf_extra_kind;

/* Where a curve is not followed further without a decision. */
typedef enum {
    SF_FULL = 0, /* no room for more points */
    SF_TURNS = 1, /* at a point beyond a fold, or beyond the largest amplitude */
    SF_CLOSES = 2, /* at a point beyond the first one */
    SF_BENDS = 3, /* before a point that is not near in a straight line */
    SF_LEAVES = 4, /* before a point outside the range of Omega */
    SF_SWITCHES = 5, /* before a point with another order of switches */
    SF_LOST = 6 /* Newton's iteration finds no point */
} sf_pause;

/* in place of no breakpoint ahead: no motion of an isolator comes near */
#define SF_FAR 1000000.0
/* a velocity at a breakpoint that cannot be distinguished from rest: the way beyond is its square */
#define SF_GRAZING 1e-13
/* phase of the forcing within which a motion switches when the cycle's equations say */
#define SF_ON_TIME 1.0000000000000001e-05
/* in one turn of the forcing; more means that switches accumulate */
#define SF_MOST_PHASES 400
/* relative step of u_0 at which Newton's iteration ends */
#define SF_TIGHT 1.0000000000000001e-09
/* relative step beyond which it has not converged where rounding ends it */
#define SF_LOOSE 9.9999999999999995e-07
/* of a cycle's equations, where Newton's iteration ends */
#define SF_TOLERANCE 1e-13
/* steps of Newton's iteration to a cycle, at most */
#define SF_MOST_NEWTON 12
/* steps of Newton's iteration to the next point of a curve, at most */
#define SF_ALONG 8
/* phase beyond a cycle's end in which its last switch is counted */
#define SF_OVER_END 9.9999999999999995e-07
/* share of a turn by which rounding may miss its end */
#define SF_OF_TURN 1e-14
/* after a shock, after which it is given up to see the mass turn twice */
#define SF_MOST_TURNS 3000
/* of a polynomial by which motions are followed where values tell a force, at most */
#define SF_MOST_DEGREE 64
/* of a force whose coefficients are printed, at most */
#define SF_FORCE_DEGREE 9
/* speed over distance at which a mass that creeps back is at rest, or both over A */
#define SF_CREEPS 1.0000000000000001e-09
/* of load and shock, by which a mass at rest may be off balance */
#define SF_BALANCED 8.8817841970012523e-16
/* of these, by which it begins behind its place of rest then */
#define SF_BACK 7.1054273576010019e-15
/* along a phase at which its acceleration is looked at */
#define SF_POINTS 17
/* of twice as many about the largest of these */
#define SF_ROUNDS 3
/* of the largest, from which on a phase may have the largest of all */
#define SF_NEAR 0.94999999999999996
/* of a peak, from which on one is as high: the first of them is returned */
#define SF_SAME 0.99999999999900002

#endif
