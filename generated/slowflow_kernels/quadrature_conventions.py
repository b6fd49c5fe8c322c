"""What integrals over the quarter cycle and their enclosures have in common, in C and in Python.

Written by `make derive`; never edit.
Input: derivations/codegen/conventions.py
"""


# what halving may change of a sum that has settled, of its size
AGREED = 1.4210854715202004e-14
# what stands for a rounding of A and of a parameter, relatively
MOVED_BY = 8.8817841970012523e-16
# a part of the quarter that one panel is enough for
SHORT_PART = 9.5367431640625e-07
# from which on rounding is looked at
FEWEST_PANELS = 16
# after which a sum is given up
MOST_PANELS = 512
# of Gauss's rule on a panel
NODES = 16
# an amplitude next to 0
NEXT_TO_ZERO = 3.8725919148493183e-121
# of the quarter cycle, of each piece, in which an average by quadrature is enclosed
PARTS = 24
