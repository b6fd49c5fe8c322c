"""Equations of motion, one file each. A file here and a `make derive` is all that a new mechanism takes.

In:  the files of this folder.
Out: `Mechanism`, the form in which a restoring force is stated, `Parameter`, the form of a number that a user gives,
     `DAMPING` and `FORCING`, those that every oscillator has, `DISSIPATION` and `CONTACTS`, what may dissipate beside,
     `EXCITATIONS`, what else the forcing may be of, and `all_mechanisms()`, every one in this folder; x, k_v and L, the
     displacement, the vertical stiffness and a length that displacements are measured in.
"""

from __future__ import annotations

import importlib
import pkgutil
from dataclasses import dataclass

import sympy as sp

from ..symbols import F_0, c_2, c_3, eta, mu, zeta, zeta_2

x = sp.Symbol("x", real=True)
k_v, L = sp.symbols("k_v L", positive=True)


@dataclass(frozen=True)
class Parameter:
    """A dimensionless number that a user gives, and which are allowed: finite ones within these bounds.

    symbol -- its symbol, whose name is that of the argument
    doc    -- one line: what it is
    unit   -- what the dimensional quantity is measured in, "1" for a number
    above, least -- it is greater than the one, or not less than the other; None where nothing bounds it from below
    below, most  -- it is less than the one, or not greater than the other; None where nothing bounds it from above
    """

    symbol: sp.Symbol
    doc: str
    unit: str
    above: sp.Rational | int | None = None
    least: sp.Rational | int | None = None
    below: sp.Rational | int | None = None
    most: sp.Rational | int | None = None

    def __post_init__(self) -> None:
        for one, other in ((self.above, self.least), (self.below, self.most)):
            if one is not None and other is not None:
                raise ValueError(f"{self.symbol} has two bounds on one side: {one} and {other}")


#: the damping of every oscillator here, by its dimensionless groups (4)
DAMPING = (
    Parameter(mu, "dry friction", "k_v L", least=0),
    Parameter(zeta, "viscous damping ratio", "2 sqrt(k_v m)", least=0),
)
#: other laws of damping, which an oscillator has where it is said, and on which |u| dry friction acts: `dissipation`
#: derives their shares
DISSIPATION = (
    Parameter(eta, "structural damping, the loss factor of the vertical spring", "1", least=0),
    Parameter(c_2, "quadratic damping, the factor of |u'|u'", "m/L", least=0),
    Parameter(c_3, "cubic damping, the factor of u'^3", "sqrt(m^3/k_v)/L^2", least=0),
    Parameter(zeta_2, "growth of the viscous damping ratio with u^2", "2 sqrt(k_v m)/L^2", least=0),
)
CONTACTS = {
    "throughout": "dry friction acts at every displacement",
    "attached": "it acts while |u| is below the first breakpoint",
}
#: what kernels take of a force by sums that has no parameter, always 1, and do not ask for: in C they take an array
UNIT = Parameter(sp.Symbol("unit", positive=True), "one, of a force that has no other number", "1")
#: its excitation (4), and what else the amplitude may be of: `inertia` derives their forces
FORCING = Parameter(F_0, "forcing amplitude", "k_v L", above=0)
EXCITATIONS = {
    "force": FORCING,
    "base": Parameter(F_0, "displacement amplitude of the base; u is relative to the base", "L", above=0),
    "unbalance": Parameter(F_0, "unbalanced mass times its radius", "m L", above=0),
}


@dataclass(frozen=True)
class Piece:
    """An odd force on one interval of |x|, from the end of the previous piece to its own.

    force -- dimensional force F_k(x) for x > 0, beside the vertical spring k_v x that every oscillator here has
    until -- the piece ends where this expression in x vanishes; None for the last one
    """

    force: sp.Expr
    until: sp.Expr | None = None


@dataclass(frozen=True)
class Mechanism:
    """An oscillator m x'' + c x' + k_v x + F_c sign(x') + F_k(x) = F cos(omega t), as data."""

    name: str  #: name of the generated modules
    title: str  #: one line for headers
    pieces: tuple[Piece, ...]  #: the force F_k(x), piece by piece, by rising |x|
    #: what a user gives beside the damping: every ratio, or, where these say no more, every parameter
    design: tuple[Parameter, ...]
    ratios: dict[sp.Symbol, sp.Expr]  #: dimensionless design parameters by their definitions, e.g. {r: k_h/k_v}
    order: int | sp.Expr  #: degree of the Taylor polynomial that stands for each piece; `sp.oo` for the force as it is
    #: names of the Taylor coefficients of u + F_k(u) for u > 0, by power, of each piece that has any; the constant of
    #: a piece that begins where the one below it ends follows from that and has none
    coefficients: tuple[dict[int, sp.Symbol], ...]
    breakpoints: tuple[sp.Symbol, ...] = ()  #: names of the dimensionless ends of the pieces but the last
    #: ratios that the kernels take in place of the breakpoints, which follow from them; () none
    instead: tuple[sp.Symbol, ...] = ()
    reach: sp.Expr = sp.oo  #: largest |u| that the mechanism can take, in the ratios, or `sp.oo`
    reach_reason: str = ""  #: what happens there, in words
    #: what displacements are measured in; with x and k_v, the symbols in which the rest is stated
    length: sp.Symbol = L
    x: sp.Symbol = x
    k_v: sp.Symbol = k_v
    #: the first piece where as it was written it is another one for u < 0 than its mirror image; "" none
    mirrored: str = ""

    def __post_init__(self) -> None:
        symbols = tuple(parameter.symbol for parameter in self.design)
        if symbols not in (tuple(self.ratios), self.parameters):
            raise ValueError(f"{self.name}: the design {symbols} must be the ratios or the parameters, in their order")

    @property
    def dimensional(self) -> dict[sp.Symbol, sp.Expr]:
        """How the dimensional parameters follow from the ratios, e.g. {k_h: r*k_v}."""
        found = {}
        for ratio, group in self.ratios.items():
            (letter,) = group.free_symbols - {self.k_v, self.length}
            found[letter] = ratio * letter / group
        return found

    @property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """The parameters of the generated kernels, in their order: coefficients piece by piece, then breakpoints."""
        coefficients = tuple(name for piece in self.coefficients for name in piece.values())
        return coefficients + (self.instead if self.order == sp.oo else self.breakpoints)


def all_mechanisms() -> list[Mechanism]:
    """Every mechanism in this folder, by name."""
    names = sorted(module.name for module in pkgutil.iter_modules(__path__))
    return [importlib.import_module(f"{__name__}.{name}").MECHANISM for name in names]
