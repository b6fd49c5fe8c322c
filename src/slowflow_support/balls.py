"""Carlson's symmetric elliptic integrals of balls: what the averages of a force that is not truncated hold.

In:  `flint.arb` that are not negative, or numbers that are exact.
Out: `flint.arb` that holds the integral, to the digits of `flint.ctx`.
"""

from __future__ import annotations

from typing import Any

from flint import acb, arb


def R_F(x: Any, y: Any, z: Any) -> arb:
    """Of the first kind."""
    return acb.elliptic_rf(acb(x), acb(y), acb(z)).real


def R_D(x: Any, y: Any, z: Any) -> arb:
    """Of the second kind."""
    return acb.elliptic_rd(acb(x), acb(y), acb(z)).real
