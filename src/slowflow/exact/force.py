"""The restoring force as the integrators want it: pieces in |u|, each an expression with constants.

In:  the force's expressions, from the derivation, and the isolator's parameters.
Out: `Force` (pieces and breakpoints) and `Oscillator` (force, friction, damping), both immutable and hashable.

A `Law` is an expression shared by every isolator: integrators compile it once. A `Piece` is a law with its constants,
which they take as run-time parameters. A law is written over a namespace `xp` that has `sqrt` (numpy, or heyoka), so
one text serves numbers and expressions alike.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

Expression = Callable[..., Any]


@dataclass(frozen=True)
class Law:
    """The expression of a piece: `value(xp, u, *constants)`, odd in u, and its derivative `slope(xp, u, *constants)`.

    `constants` is how many there are.
    """

    name: str
    value: Expression
    slope: Expression
    constants: int


@dataclass(frozen=True)
class Piece:
    """A law with its constants."""

    law: Law
    constants: tuple[float, ...]

    def value(self, u: float) -> float:
        """f(u), dimensionless."""
        return float(self.law.value(np, u, *self.constants))

    def slope(self, u: float) -> float:
        """df/du, dimensionless."""
        return float(self.law.slope(np, u, *self.constants))


@dataclass(frozen=True)
class Force:
    """The whole restoring force f(u) = u + F_k(u): piece i holds for breakpoints[i-1] < |u| <= breakpoints[i].

    It may jump at a breakpoint, as the truncated force (6) does at u_cr.
    """

    pieces: tuple[Piece, ...]
    breakpoints: tuple[float, ...]

    def __post_init__(self) -> None:
        if len(self.pieces) != len(self.breakpoints) + 1:
            raise ValueError(f"{len(self.pieces)} pieces need {len(self.pieces) - 1} breakpoints")
        if any(b <= a for a, b in zip((0.0, *self.breakpoints), self.breakpoints, strict=False)):
            raise ValueError(f"breakpoints = {self.breakpoints} must be positive and rise")

    def value(self, u: float) -> float:
        """f(u), dimensionless."""
        return self.pieces[sum(abs(u) > b for b in self.breakpoints)].value(u)


@dataclass(frozen=True)
class Oscillator:
    """Equation (3) without its forcing: f(u), mu >= 0, zeta >= 0, all dimensionless."""

    force: Force
    mu: float
    zeta: float

    def __post_init__(self) -> None:
        for name, value in (("mu", self.mu), ("zeta", self.zeta)):
            if not (np.isfinite(value) and value >= 0):
                raise ValueError(f"{name} = {value} must be finite and not negative")
        if self.mu == 0 and self.zeta == 0:
            raise ValueError(
                "mu = 0 and zeta = 0: without any damping the forced motion has no attracting steady state"
            )


# --- the expressions; to be replaced by the ones the derivation generates --------------------------------------------


def _odd(xp: Any, u: Any, c_1: Any, c_3: Any, c_5: Any) -> Any:
    square = u * u
    return u * (c_1 + square * (c_3 + square * c_5))


def _odd_slope(xp: Any, u: Any, c_1: Any, c_3: Any, c_5: Any) -> Any:
    square = u * u
    return c_1 + square * (3.0 * c_3 + square * (5.0 * c_5))


def _rod(xp: Any, u: Any, stiffness: Any, delta_h: Any) -> Any:
    root = xp.sqrt(1.0 - u * u)
    return u + stiffness * (1.0 - delta_h - root) * u / root


def _rod_slope(xp: Any, u: Any, stiffness: Any, delta_h: Any) -> Any:
    root = xp.sqrt(1.0 - u * u)
    return 1.0 - stiffness + stiffness * (1.0 - delta_h) / (root * root * root)


ODD_POLYNOMIAL = Law("odd_polynomial", _odd, _odd_slope, 3)
ROD = Law("rod", _rod, _rod_slope, 2)

# ----------------------------------------------------------------------------------------------------------------------


def polynomial(c_1: float, c_3: float = 0.0, c_5: float = 0.0) -> Piece:
    """c_1 u + c_3 u^3 + c_5 u^5."""
    return Piece(ODD_POLYNOMIAL, (float(c_1), float(c_3), float(c_5)))


def linear() -> Force:
    """f(u) = u: the isolator without preload (delta_h = 0), Den Hartog's oscillator."""
    return Force((polynomial(1.0),), ())


def rod_spring(alpha: float, beta: float, gamma: float, u_cr: float) -> Force:
    """Truncated force (6): alpha u + beta u^3 + gamma u^5 up to u_cr, u beyond; it jumps at u_cr."""
    return Force((polynomial(alpha, beta, gamma), polynomial(1.0)), (float(u_cr),))


def rod_spring_exact(lam: float, r: float, delta_h: float) -> Force:
    """Untruncated force (5) plus u, with u_cr = sqrt(1 - (1 - delta_h)^2)."""
    if delta_h == 0:
        return linear()
    u_cr = float(np.sqrt(delta_h * (2.0 - delta_h)))
    return Force((Piece(ROD, (float(lam * r), float(delta_h))), polynomial(1.0)), (u_cr,))
