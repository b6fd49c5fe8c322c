"""Codes and constants of the solvers of averaged motions, in C and in Python.

Written by `make derive` from derivations/codegen/conventions.toml; never edit.
"""

from enum import IntEnum


class Status(IntEnum):
    """Status of a result.

    0  OK                   a result
    1  INVALID              a parameter outside its domain
    2  STICKS               sticks: F_0 <= 4 mu/pi
    3  NONE                 no such result: for example no fold, or no breakpoint
    4  UNBOUNDED            no viscous damping: the response is unbounded, there is no lowest forcing
    5  NO_BOUND             no amplitude was found that bounds the response
    6  TOO_MANY             more results than max_count
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
    """Kind of the lowest forcing with a fold.

    0  NO                   none
    1  CUSP                 two folds merge: the response has a vertical inflection
    2  ISOLA                an isolated curve is born
    3  CORNER               at a breakpoint
    """

    NO = 0
    CUSP = 1
    ISOLA = 2
    CORNER = 3


class FoldKind(IntEnum):
    """Direction of the jump at a fold.

    0  EMPTY                an unused slot
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


class PointType(IntEnum):
    """Kind of a result whose gradient is computed.

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


class GradientStatus(IntEnum):
    """Whether a result has a gradient.

    0  OK                   a gradient
    1  NOTHING              no result to differentiate
    2  MEETS                the result merges with another one, beyond which there is none; slopes are unbounded
    3  TURNS                the result reaches a breakpoint, with different gradients on either side
    4  BOUNDLESS            a slope is infinite, or a forcing is 0, as at the end of a parameter's domain
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
# represents an infinite amplitude, and an infinite multiple of one
ENDLESS = 1.152921504606847e+18
# where a search begins that cannot begin at A = 0
FIRST = 6.2230152778611417e-61
# of a curve's points: the length that each part has besides its own
SPREAD = 0.001
# share of its size that rounding may add to a value
CLOSE = 9.0949470177292824e-13
# share of its size below which what vanishes where answers meet leaves no digit of a gradient
MEETING = 2.9802322387695312e-08
# amplitudes closer than this, relatively, are one
SAME = 1.7763568394002505e-15

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
