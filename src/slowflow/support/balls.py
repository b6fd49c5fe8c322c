"""Carlson's symmetric elliptic integrals in ball arithmetic, for averages of an untruncated force.

They take non-negative `flint.arb` or exact numbers, and enclose the integral to the digits of `flint.ctx`.
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
