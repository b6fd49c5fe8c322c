"""The restoring force as the integrators want it: pieces in |u|, each two generated expressions with their constants.

In:  the generated kernels of a mechanism, its parameters.
Out: `Force` (pieces and breakpoints) and `EquationOfMotion` (force, friction, damping), both immutable and hashable.

A piece's expressions are plain arithmetic and NumPy functions of (u, *constants), so one text serves floats, complex
numbers and an integrator's symbols. Integrators compile an expression once; constants are run-time parameters.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow_kernels import duffing as duffing_kernels
from slowflow_kernels import rod_spring as rod_spring_kernels

Expression = Callable[..., Any]


@dataclass(frozen=True)
class Piece:
    """One smooth piece of the force: f(u) = expression(u, *constants), odd in u, and df/du likewise."""

    expression: Expression
    by_u: Expression
    constants: tuple[float, ...]

    def __call__(self, u: Any) -> Any:
        """f(u), dimensionless, for whatever kind of number u is."""
        return self.expression(u, *self.constants)

    def value(self, u: float) -> float:
        """f(u), dimensionless."""
        return float(self(u))

    def slope(self, u: float) -> float:
        """df/du, dimensionless."""
        return float(self.by_u(u, *self.constants))


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
        if any(not b > a for a, b in zip((0.0, *self.breakpoints), self.breakpoints, strict=False)):
            raise ValueError(f"breakpoints = {self.breakpoints} must be positive and rise")

    def value(self, u: float) -> float:
        """f(u), dimensionless."""
        return self.pieces[sum(abs(u) > b for b in self.breakpoints)].value(u)


@dataclass(frozen=True)
class EquationOfMotion:
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


def linear() -> Force:
    """f(u) = u: the isolator without preload (delta_h = 0), Den Hartog's oscillator."""
    return rod_spring(0.0, 0.0, 0.0, 0.0)


def duffing(alpha: float, beta: float) -> Force:
    """f(u) = alpha u + beta u^3 without an end."""
    return from_kernels(duffing_kernels.FORCE, (float(alpha), float(beta)), ())


def rod_spring(alpha: float, beta: float, gamma: float, u_cr: float) -> Force:
    """Truncated force (6): alpha u + beta u^3 + gamma u^5 up to u_cr, u beyond; it jumps at u_cr."""
    constants = (float(alpha), float(beta), float(gamma), float(u_cr))
    return from_kernels(rod_spring_kernels.FORCE, constants, (constants[-1],))


def rod_spring_exact(lam: float, r: float, delta_h: float) -> Force:
    """Untruncated force (5) plus u; the springs detach at u_cr (7)."""
    u_cr = float(rod_spring_kernels.coefficients(lam, r, delta_h)[-1])
    return from_kernels(rod_spring_kernels.UNTRUNCATED_FORCE, (float(lam), float(r), float(delta_h)), (u_cr,))


def from_kernels(
    table: tuple[tuple[Expression, Expression], ...], constants: tuple[float, ...], breakpoints: tuple[float, ...]
) -> Force:
    """The force whose pieces, each with its slope, a generated module lists as FORCE or UNTRUNCATED_FORCE.

    A breakpoint at 0 (no preload) leaves only what lies beyond.
    """
    pieces = [Piece(expression, by_u, constants) for expression, by_u in table]
    kept = [i for i, end in enumerate(breakpoints) if end != 0.0]
    return Force((*(pieces[i] for i in kept), pieces[-1]), tuple(breakpoints[i] for i in kept))
