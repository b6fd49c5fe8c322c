"""The catalogue: which functions each generated module holds, with their arguments, equation numbers and domains.

In:  steps of the derivation.
Out: `Module`s of `Kernel`s (expressions to print) and `Composition`s (calls of other kernels): a room for each kind of
     module, and `every_module` for all.
"""
