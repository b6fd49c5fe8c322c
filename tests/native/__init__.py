"""The C of the package, built for a test in other ways than the package builds it, as Python functions.

headers    every function of `generated/c`
clones     the kernels' loops for one processor target each
roots      the root solvers
solvers    the questions about the fold locus, on a mesh of one's choice
"""
