"""What the solvers of the second approximation have in common, in C and in Python.

Written by `make derive`; never edit.
Input: derivations/conventions.py
"""

from enum import IntEnum


class SecondStatus(IntEnum):
    """How one answer of the second approximation fared.

    0  OK              an answer
    1  FIRST_HAS_NONE  the first approximation has none to start from
    2  NO_CUSP         the onset of the first approximation is no cusp, which is all that is followed
    3  STATIC          the first approximation's motion is at Omega = 0: it has no harmonics
    4  FAR             it does not come near the first approximation: the harmonics are not small
    """

    OK = 0
    FIRST_HAS_NONE = 1
    NO_CUSP = 2
    STATIC = 3
    FAR = 4


class Wanted(IntEnum):
    """What a curve of the second approximation is followed for.

    0  EVERY_POINT     all of its points
    1  FOLDS_ONLY      those beside which F_A may vanish
    2  TOP_ONLY        those beside which u_max may be largest
    """

    EVERY_POINT = 0
    FOLDS_ONLY = 1
    TOP_ONLY = 2


# change of ln A, ln Omega up to which it is a correction, share of A too
SMALL = 0.20000000000000001
# the same of the spring's harmonics: from 1/8 on the mass might not turn where they add up
HARMONICS = 0.10000000000000001
# of Newton's iteration, at most
STEPS = 25
# longest step in ln A, R/F_0 and ln Omega
LONGEST = 0.10000000000000001
# the step that ends the iteration
DONE = 9.9999999999999994e-12
# the last step of a point of a curve, where the next is its square
MOVED = 1e-08
# of R, over A Omega^2
ROUNDING = 1.7763568394002505e-15
# of ln Omega in the distance beside ln A and R/F_0
WEIGHT = 2.0
# steps to the frequency of a given R
MATCHING = 5
# relative distance up to which two answers are one
SETTLED = 9.9999999999999995e-08
# size of F_A where it has vanished, over that at the points beside
VANISHED = 0.001
# points of the curve on which folds and states are looked for
SAMPLES = 600
# how far that curve reaches beyond the frequencies that are asked for
BEYOND = 1.3
