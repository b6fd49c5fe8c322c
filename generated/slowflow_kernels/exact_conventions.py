"""What the integrators of the equation of motion have in common, in C and in Python.

Written by `make derive` from derivations/codegen/conventions.toml; never edit.
"""

from enum import IntEnum


class Outcome(IntEnum):
    """How a motion or a cycle fared.

    0  GOOD       an answer
    1  STALLS     more steps than allowed, or numbers that are not finite
    2  CHATTERS   more phases in a turn than allowed
    3  ESCAPES    the restoring force does not hold the mass
    4  SINGULAR   equations without a single solution
    5  DIVERGES   Newton's iteration does not converge
    6  NO_MEMORY  out of memory
    """

    GOOD = 0
    STALLS = 1
    CHATTERS = 2
    ESCAPES = 3
    SINGULAR = 4
    DIVERGES = 5
    NO_MEMORY = 6


class Event(IntEnum):
    """What ends smooth motion.

    0  TIME       the end of the time requested
    1  STOP       the velocity vanishes
    2  EDGE       a breakpoint
    3  NOTHING    not ended
    """

    TIME = 0
    STOP = 1
    EDGE = 2
    NOTHING = 3


class ExtraKind(IntEnum):
    """A cycle's further equation, by which Omega is free.

    0  NO_MORE    none: Omega is given
    1  ROW        row z = value
    2  BORDER     a border's margin vanishes
    """

    NO_MORE = 0
    ROW = 1
    BORDER = 2


class Pause(IntEnum):
    """Where a curve is not followed further without a decision.

    0  FULL       no room for more points
    1  TURNS      at a point beyond a fold, or beyond the largest amplitude
    2  CLOSES     at a point beyond the first one
    3  BENDS      before a point that is not near in a straight line
    4  LEAVES     before a point outside the range of Omega
    5  SWITCHES   before a point with another order of switches
    6  LOST       Newton's iteration finds no point
    """

    FULL = 0
    TURNS = 1
    CLOSES = 2
    BENDS = 3
    LEAVES = 4
    SWITCHES = 5
    LOST = 6


# in place of no breakpoint ahead: no motion of an isolator comes near
FAR = 1000000.0
# a velocity at a breakpoint that cannot be distinguished from rest: the way beyond is its square
GRAZING = 1e-13
# phase of the forcing within which a motion switches when the cycle's equations say
ON_TIME = 1.0000000000000001e-05
# in one turn of the forcing; more means that switches accumulate
MOST_PHASES = 400
# relative step of u_0 at which Newton's iteration ends
TIGHT = 1.0000000000000001e-09
# relative step beyond which it has not converged where rounding ends it
LOOSE = 9.9999999999999995e-07
# of a cycle's equations, where Newton's iteration ends
TOLERANCE = 1e-13
# steps of Newton's iteration to a cycle, at most
MOST_NEWTON = 12
# phase beyond a cycle's end in which its last switch is counted
OVER_END = 9.9999999999999995e-07
# after a shock, after which it is given up to see the mass turn twice
MOST_TURNS = 3000
# of a polynomial by which motions are followed where values tell a force, at most
MOST_DEGREE = 64
# of these, by which it begins behind its place of rest then
BACK = 7.1054273576010019e-15
# of a peak, from which on one is as high: the first of them is returned
SAME = 0.99999999999900002
