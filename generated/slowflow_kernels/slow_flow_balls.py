"""Slow flow of any mechanism, in h = H - A and its derivatives: in balls.

Written by `make derive` from derivations/paper/averaging.py, derivations/paper/slow_flow.py,
derivations/asymmetric/offset.py, derivations/systems/along.py, derivations/systems/slopes.py,
derivations/systems/newton.py, derivations/paper/critical_forcings.py; never edit.

Arguments are `flint.arb`, or numbers that are exact; each output holds the value of the function of the same name,
to the digits of `flint.ctx`. passed_n is meant where A exceeds n breakpoints; beyond: by how much it exceeds the
last of these. Equations and domains that are not stated here are those of slow_flow.py.
"""

from flint import arb

__all__ = [
    "friction",
]


def friction(mu):
    """Dry friction's share of I."""
    return (4 / arb.pi()) * mu
