"""Numerical stability, searched: kernels, roots, answers and counts at hard places against certified values.

domains    where arguments are drawn, and the hard places
search     from drawn points to the worst that small moves lead to
kernels    errors of generated kernels
roots      errors and counts of the roots in Omega
answers    errors of what an oscillator says
counts     numbers of states and folds against proved ones
scale      the same by the million, against proofs at run time: a command of its own
page       docs/stability.md and its pictures

`python -m benchmarks.stress` measures and writes all of it.
"""
