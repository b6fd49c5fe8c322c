"""What the generated modules of `slowflow_kernels` stand on, written by hand: NumPy in, nothing of slowflow's.

backend    the compiled kernels, in the place of NumPy's
broadcast  arguments as floats, one shape for all outputs, regimes by mask
errors     the errors raised on purpose
record     what a mechanism says of itself: `Mechanism`, `Parameter`
"""
