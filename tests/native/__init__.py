"""The C of the package, built for a test in other ways than the package builds it, as Python functions.

compiler   sources, flags and headers
headers    every function of `generated/c`
clones     the kernels' loops for one processor target each
roots      the root solvers
intervals  double-doubles, intervals, and what is generated on them
records    records of mechanisms
instrumented  a session with modules that are built for it
"""
