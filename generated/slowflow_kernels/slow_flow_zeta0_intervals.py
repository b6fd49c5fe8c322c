"""Slow flow of any mechanism, in h = H - A and its derivatives, in the scene zeta = 0: on whole intervals.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

Each output holds every value that the function of the same name takes on the arguments: objects with operators and
the methods `square` and `sqrt`. Equations and domains that are not stated here are those of slow_flow_zeta0.py.
"""

__all__ = [
    "F_Omega_reduced", "fold", "undamped_Omega", "undamped_rises",
]


def undamped_Omega(h_A):
    """Omega of the folds."""
    return (-h_A).sqrt()


def fold(F_0, m, k, k_A):
    """Zero at a fold at F_0, where h_A < 0: R^2 + I^2 - F_0^2 on the undamped folds, and its slope along A."""
    excess = (F_0 - m) * (F_0 + m)
    least = excess.sqrt()
    return (k - least) * (k + least), 2.0 * k * k_A


def undamped_rises(h_AA, h_AAA, k):
    """The sign of the level's slope along A on the undamped folds; and, where that is 0, of the slope's own."""
    return -h_AA * k, -h_AAA * k


def F_Omega_reduced(Omega, A, m, zeta, h):
    """F_Omega/(4 A), without the factor Omega if it has that, and its slope along Omega.

    Equation (34). Domain: Omega > 0, A > 0.
    """
    return A * Omega.square() + h, 2.0 * A * Omega
