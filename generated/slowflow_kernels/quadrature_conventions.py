"""What integrals over the quarter cycle and their enclosures have in common, in C and in Python.

Written by `make derive` from derivations/codegen/conventions.toml; never edit.
"""


# of Gauss's rule on a panel
NODES = 16
