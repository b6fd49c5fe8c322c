"""Slow flow of any mechanism, in h = H - A and its derivatives, in the scene mu = 0: on whole intervals.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

Each output holds every value that the function of the same name takes on the arguments: objects with operators and
the methods `square` and `sqrt`. Equations and domains that are not stated here are those of slow_flow_mu0.py.
"""

__all__ = [
    "F_Omega_reduced", "isola",
]


def isola(A, m, zeta, h, h_A, h_AA):
    """Zero at an isola point: F_Omega/(4 A) at its Omega, for m = 0 without the factor Omega; slope along A."""
    t0 = 2.0 * zeta.square()
    bracket = A * (h_A + t0) + h
    bracket_A = A * h_AA + 2.0 * h_A + t0
    return bracket, bracket_A


def F_Omega_reduced(Omega, A, m, zeta, h):
    """F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.

    Equation (34). Domain: Omega > 0, A > 0.
    """
    t0 = 2.0 * A
    p = h + t0 * zeta.square()
    return A * Omega.square() + p, Omega * t0
