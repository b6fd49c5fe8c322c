"""The derivation, in the paper's order: from an equation of motion to slow flow, polynomials and resultants.

In:  a `Mechanism` from `mechanisms/`: pieces of a restoring force as SymPy expressions, names of its parameters.
Out: exact SymPy expressions, which `emit/` prints as kernels and `ledger/` holds against the published formulas.

    oscillator     (1)-(7)    equation of motion, dimensionless form, Taylor coefficients, critical displacement
    averaging      (8)-(20)   variation of parameters and averaging over the cycle
    restoring      (20)-(22), (31), (32)   the averaged restoring force and its derivatives, piece by piece
    slow_flow      (23)-(30), (38)   fixed points, response, phase, envelope, Jacobian, stability boundary
    resultants     (33), (34) critical forcings by elimination
    den_hartog     (35)-(37)  the exact solution of the linear oscillator with dry friction

Beside the paper, for the solvers and the further depths:

    motion         (3), (A1)  the equation of motion as it is followed in time
    switching                 what a deviation from a motion becomes where the mass stops, moves off or passes an edge
    elliptic       (20)       the averaged force that is not truncated
    quadrature     (20)       the averaged force of any kind, as integrals
    sampled        (20)       the same of a force that is known by its values
    frequencies, along, slopes, bounds   what is solved at an amplitude, and what vanishes, rises, is bounded along it
    monotone                  proof of what the search along the amplitude stands on
    offset                    whether a motion about the centre stays there
    off_centre                motions about another place, where a static load or a force that is not odd puts them
    harmonics, second_approximation      the higher harmonics and what they add
    repeated                  stretches of an algorithm that it goes through many times
    conventions               words and numbers that both languages share

`python -m derivations` runs all of it and writes `generated/`.
"""
