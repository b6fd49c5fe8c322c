"""What the solvers of the second approximation have in common, in C and in Python.

Written by `make derive` from derivations/codegen/conventions.toml; never edit.
"""

from enum import IntEnum


class Wanted(IntEnum):
    """What a curve of the second approximation is followed for.

    0  EVERY_POINT  all of its points
    1  FOLDS_ONLY   those next to which F_A may vanish
    2  TOP_ONLY     those next to which u_max may be largest
    """

    EVERY_POINT = 0
    FOLDS_ONLY = 1
    TOP_ONLY = 2


# of Newton's iteration, at most
STEPS = 25
# of R, over A Omega^2
ROUNDING = 1.7763568394002505e-15
# points of the curve on which folds and states are looked for
SAMPLES = 600
# how far that curve reaches beyond the frequencies of the query
BEYOND = 1.3
