"""What the solvers of averaged motions have in common, in C and in Python.

Written by `make derive`; never edit.
Input: derivations/conventions.py
"""

from enum import IntEnum


class Status(IntEnum):
    """How a solver fared.

    0  OK                   an answer
    1  INVALID              a parameter outside its domain
    2  STICKS               sticks: F_0 <= 4 mu/pi
    3  NONE                 there is none (no fold, no breakpoint)
    4  UNBOUNDED            no viscous damping: no end of the response, no lowest forcing
    5  NO_BOUND             no amplitude was found that bounds the response
    6  TOO_MANY             more of them than places
    7  UNRESOLVED           branches coincide within rounding
    8  NO_MEMORY            out of memory
    """

    OK = 0
    INVALID = 1
    STICKS = 2
    NONE = 3
    UNBOUNDED = 4
    NO_BOUND = 5
    TOO_MANY = 6
    UNRESOLVED = 7
    NO_MEMORY = 8


class OnsetKind(IntEnum):
    """What the lowest forcing with a fold is.

    0  NO                   there is none
    1  CUSP                 two folds meet: the response gets a vertical inflection
    2  ISOLA                an isolated curve is born
    3  CORNER               at a breakpoint
    """

    NO = 0
    CUSP = 1
    ISOLA = 2
    CORNER = 3


class FoldKind(IntEnum):
    """Where a sweep goes that leaves a fold.

    0  EMPTY                an empty place
    1  JUMP_UP              to a larger amplitude
    2  JUMP_DOWN            to a smaller one
    3  JUMP_UP_AT_CORNER    to a larger amplitude, from a corner at a breakpoint
    4  JUMP_DOWN_AT_CORNER  to a smaller one, from a corner at a breakpoint
    """

    EMPTY = 0
    JUMP_UP = 1
    JUMP_DOWN = 2
    JUMP_UP_AT_CORNER = 3
    JUMP_DOWN_AT_CORNER = 4


class Pinned(IntEnum):
    """What an answer is whose gradient is asked for.

    0  STATE                a steady state; with Omega = 0 a peak at rest
    1  FOLD                 a fold at a forcing
    2  CORNER_FOLD          a fold at a forcing, on a breakpoint
    3  PEAK                 a peak at a forcing
    4  CUSP                 where two folds meet
    5  ISOLA                where an isolated curve is born
    6  CORNER_TOP           the least forcing on a breakpoint
    7  CORNER_END           where the fold locus meets a breakpoint
    8  CORNER_BACKBONE      where the backbone meets a breakpoint
    9  CORNER_REST          at Omega = 0 on a breakpoint
    """

    STATE = 0
    FOLD = 1
    CORNER_FOLD = 2
    PEAK = 3
    CUSP = 4
    ISOLA = 5
    CORNER_TOP = 6
    CORNER_END = 7
    CORNER_BACKBONE = 8
    CORNER_REST = 9


class MovesStatus(IntEnum):
    """Whether an answer has a gradient.

    0  OK                   it has
    1  NOTHING              there is no answer
    2  MEETS                it meets another one there: beyond it there is none, and before it moves without bound
    3  TURNS                it comes to a breakpoint there: on either side it moves in its own way
    4  BOUNDLESS            a slope is not finite, or a forcing 0, as at the end of a parameter's domain
    """

    OK = 0
    NOTHING = 1
    MEETS = 2
    TURNS = 3
    BOUNDLESS = 4


# highest frequency: for F_0 >= 1e-70 the square of A is in the range of doubles up to it
HIGHEST_OMEGA = 1e+40
# size of a force's parameter and of 4 mu/pi: beyond it ordinary amplitudes leave the range of doubles
LARGEST = 1.0000000000000001e+300
# an undamped response without a reach is cut at this times F_0
STATIC_MULTIPLE = 100.0
# the forcing is raised by this factor until the onset lies below it
RAISE = 4.0
# how often, at most
RAISES = 30
# by this factor from there on, where the force is still nearly its slope at rest
FAR_RAISE = 1048576.0
# how often, at most: fourth powers of it are in the range of doubles
FAR_RAISES = 15
# how nearly the forcing is known beyond which motions go ever farther
NEAR_BOUND = 1.52587890625e-05
# bounds that are tried on an amplitude, each twice the last
FINE_RUNGS = 12
# and in all, in steps that double too
RUNGS = 100
# until they exceed this
COARSEST = 10000.0
# stands for an infinite amplitude, and an infinite multiple of one
ENDLESS = 1.152921504606847e+18
# relative error that is taken for granted in a kernel's value
DOUBT = 3.5527136788005009e-15
# share of its first term below which a sum of two has lost digits
CANCELLED = 0.25
# share of |h| below which A h_A may have lost digits, and Omega^2 = h_A with it
SOFT = 0.01
# a root is the one meant if it lies, relatively, this near to what has lost digits
BESIDE = 0.001
# relative step of A up to which Newton's last step is taken
LAST_STEP = 1e-08
# where a search begins that cannot begin at A = 0
FIRST = 6.2230152778611417e-61
# an amplitude beside that where its piece begins, from which h is smooth
FAR_ABOVE = 1073741824.0
# relative width of an interval of A that is not cut any more
NARROW = 8.8817841970012523e-16
# intervals of A, after which a search is given up: numbers overflow
MOST_CELLS = 50000
# relative width of an interval that holds no amplitude
NO_WIDTH = 4.4408920985006262e-16
# share of the last step up to which a step is taken in a bracket
SLOW = 0.59999999999999998
# relative distance from an amplitude that rounding makes of none
AT_ROOT = 8.8817841970012523e-16
# forcing that is raised first where there is no friction
FIRST_F_0 = 9.9999999999999995e-07
# an amplitude beside `ENDLESS`, to tell what a level tends to
FAR_OUT = 1073741824.0
# amplitudes at which the rest is looked at fall by this
FALL = 9.5367431640625e-07
# how many of these there are
FALLS = 6
# share by which what tends to 0 falls from there to `ENDLESS`
TENDS = 9.5367431640625e-07
# about h_A at the next double above a breakpoint b, over J/b, where the force jumps by J
STEEP = 16777216.0
# frequencies farther apart than this, relatively, are told apart by any rounding
TOLD_APART = 0.001
# of a curve's points: the length that each part has beside its own
SPREAD = 0.001
# share of Omega's change below which A hardly changes, relatively
HARDLY = 1.4901161193847656e-08
# events closer than this, relatively, may have changed their order
COINCIDE = 5.6843418860808015e-14
# share of its size that rounding may add to a value
CLOSE = 9.0949470177292824e-13
# frequencies closer than this are one where a curve ends
NEAR_END = 9.0949470177292824e-13
# share of its size below which what vanishes where answers meet leaves no digit of a gradient
MEETING = 2.9802322387695312e-08
# amplitudes closer than this, relatively, are one
SAME = 1.7763568394002505e-15
# distance of rho from 1, where critical points meet
MAY_MEET = 1.4901161193847656e-08
# relative step up to which a critical point is not a double one
SIMPLE = 0.0009765625
# what Newton's iteration leaves of a critical point, relatively
POLISHED = 3.4694469519536142e-18
# share of its terms beyond which a value is its rise
BY_RISE = 9.0949470177292824e-13
# relative step, share of the way to a fold, of Halley's last
NEAR_ROOT = 0.000244140625
# what Newton's last step leaves of a root, relatively
CORRECTED = 6.9388939039072284e-18
# steps at most, of Newton's iteration to a critical point
POLISHING = 8
# of Halley's to a root
NEARING = 12
# of Newton's after that, kept in its bracket
CORRECTING = 100

# by what an answer is: three conditions in the order in which they are solved, for which unknowns, whether the last two together, and slopes that vanish
SYSTEMS = (
    (5, 6, 0, 2, 1, 0, 0, 5, 5),
    (5, 0, 1, 2, 1, 0, 0, 0, 0),
    (5, 7, 0, 2, 0, 1, 0, 5, 5),
    (5, 0, 3, 2, 0, 1, 0, 1, 1),
    (1, 0, 2, 1, 2, 0, 0, 0, 3),
    (0, 1, 3, 2, 0, 1, 1, 0, 1),
    (7, 0, 3, 0, 2, 1, 0, 1, 1),
    (7, 1, 0, 0, 1, 2, 0, 0, 0),
    (7, 4, 0, 0, 1, 2, 0, 5, 5),
    (7, 6, 0, 0, 1, 2, 0, 5, 5),
)
