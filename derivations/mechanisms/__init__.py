"""Equations of motion, one file each. A file here and a `make derive` is all that a new mechanism takes.

In:  nothing.
Out: `Mechanism`, the form in which a restoring force is stated, and `all_mechanisms()`, every one in this folder.
"""

from __future__ import annotations

import importlib
import pkgutil
from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Piece:
    """An odd force on one interval of |x|, from the end of the previous piece to its own.

    force -- dimensional force F_k(x), beside the vertical spring k_v x that every oscillator here has
    until -- the piece ends where this expression in x vanishes; None for the last one
    """

    force: sp.Expr
    until: sp.Expr | None = None


@dataclass(frozen=True)
class Mechanism:
    """An oscillator m x'' + c x' + k_v x + F_c sign(x') + F_k(x) = F cos(omega t), as data.

    name         -- name of the generated modules
    title        -- one line for headers
    x, k_v, length -- symbols of displacement, vertical stiffness and the length that x is measured in
    pieces       -- the force F_k(x), piece by piece, by rising |x|
    ratios       -- dimensionless design parameters by their definitions, e.g. {r: k_h/k_v}
    dimensional  -- how the dimensional parameters follow from the ratios, e.g. {k_h: r*k_v}
    order        -- degree of the Taylor polynomial that stands for each piece; `sp.oo` for the force as it is
    coefficients -- names of the odd Taylor coefficients of u + F_k(u), by power, of each piece that has any
    breakpoints  -- names of the dimensionless ends of the pieces but the last
    reach        -- largest |u| that the mechanism can take, in the ratios, or `sp.oo`
    reach_reason -- what happens there, in words
    """

    name: str
    title: str
    x: sp.Symbol
    k_v: sp.Symbol
    length: sp.Symbol
    pieces: tuple[Piece, ...]
    ratios: dict[sp.Symbol, sp.Expr]
    dimensional: dict[sp.Symbol, sp.Expr]
    order: int | sp.Expr
    coefficients: tuple[dict[int, sp.Symbol], ...]
    breakpoints: tuple[sp.Symbol, ...] = ()
    reach: sp.Expr = sp.oo
    reach_reason: str = ""

    @property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """The parameters of the generated kernels, in their order: coefficients piece by piece, then breakpoints."""
        return tuple(name for piece in self.coefficients for name in piece.values()) + self.breakpoints


def all_mechanisms() -> list[Mechanism]:
    """Every mechanism in this folder, by name."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return [importlib.import_module(f"{__name__}.{name}").MECHANISM for name in names]
