"""The derivation, in the paper's order: from an equation of motion to slow flow, polynomials and resultants.

In:  a `Mechanism` from `mechanisms/`: pieces of a restoring force as SymPy expressions, names of its parameters.
Out: exact SymPy expressions, which `emit/` prints as kernels and `ledger/` holds against the published formulas.

    oscillator     (1)-(7)    equation of motion, dimensionless form, Taylor coefficients, critical displacement
    averaging      (8)-(20)   variation of parameters and averaging over the cycle
    restoring      (20)-(22), (31), (32)   the averaged restoring force and its derivatives, piece by piece
    slow_flow      (23)-(30), (38)   fixed points, response, phase, envelope, Jacobian, stability boundary
    resultants     (33), (34) critical forcings by elimination
    den_hartog     (35)-(37)  the exact solution of the linear oscillator with dry friction

`python -m derivations` runs all of it and writes `generated/`.
"""
