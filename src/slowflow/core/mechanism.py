"""Mechanisms, restoring forces and the equation of motion.

A `Mechanism` with values of its parameters is a `Force`, which has pieces and breakpoints. With friction and damping it
is an `EquationOfMotion`. Functions of a piece take (u, *constants) and accept floats, complex numbers and symbols of an
integrator.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from slowflow.support.errors import Refused
from slowflow.support.record import Law, Mechanism, Parameter
from slowflow.support.text import text
from slowflow_kernels import duffing, inertia, slow_flow

__all__ = [
    "LINEAR",
    "EquationOfMotion",
    "Floats",
    "Force",
    "Law",
    "Mechanism",
    "Parameter",
    "Piece",
    "described",
    "linear",
]

Floats = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]
Ints = npt.NDArray[np.intp]


class Array(Protocol):
    """An array of any kind, as NumPy takes it."""

    def __array__(self) -> npt.NDArray[Any]:
        """As one of NumPy's."""
        ...


#: what is taken for one real number or several
Reals = float | Sequence[float] | Sequence[Sequence[float]] | Array
#: the same, without names of axes and not in blocks
Numeric = np.floating[Any] | np.integer[Any]
Unlabelled = float | Numeric | Sequence[float] | Sequence[Sequence[float]] | npt.NDArray[Numeric]


@dataclass(frozen=True)
class Piece:
    """One smooth piece of the force with its numbers: f(u) = law.force(u, *constants), odd in u, and df/du likewise."""

    law: Law
    constants: tuple[float, ...]

    def __call__(self, u: Any) -> Any:
        """f(u), dimensionless, for whatever kind of number u is."""
        return self.law.force(u, *self.constants)

    def value(self, u: float) -> float:
        """f(u), dimensionless."""
        return float(self(u))

    def slope(self, u: float) -> float:
        """df/du, dimensionless."""
        return float(self.law.slope(u, *self.constants))


@dataclass(frozen=True)
class OneSided(Piece):
    """A piece on one side of u = 0, where the force jumps; beyond that, where an integrator tries it, its tangent.

    side -- 1 or -1; 0 for what is left between: f = 0 at u = 0
    """

    side: int

    def _inside(self, u: Any) -> Any:
        # u = 0 keeps the sign of the side
        return self.side * (np.maximum(self.side * u, 0.0) + 0.0)

    def __call__(self, u: Any) -> Any:
        """See `Piece`."""
        if self.side == 0:
            return 0.0 * u
        inside = self._inside(u)
        return self.law.force(inside, *self.constants) + self.slope(self.side * 0.0) * (u - inside)

    def slope(self, u: float) -> float:
        """See `Piece`."""
        return float(self.law.slope(self._inside(u), *self.constants))


@dataclass(frozen=True)
class Force:
    """The whole restoring force f(u) = u + F_k(u), piece by piece; a breakpoint belongs to the inner one.

    pieces, breakpoints -- in ascending order of |u|, for u > 0: piece i is valid for breakpoints[i-1] < |u| <=
           breakpoints[i]. If the force jumps at u = 0, as with a preload, the first piece is the point u = 0 itself,
           with f = 0, where a mass may rest. For a force that is not odd they are in ascending order of u
    odd -- whether the force is odd, so that a motion may be its own mirror image half a period later

    The force may jump at a breakpoint, as the truncated force (6) does at u_cr. Regions are the numbers of the pieces,
    counted from the piece about u = 0, negative on the side of lower u.
    """

    pieces: tuple[Piece, ...]
    breakpoints: tuple[float, ...]
    odd: bool = True

    def __post_init__(self) -> None:
        if len(self.pieces) != len(self.breakpoints) + 1:
            raise Refused(f"{len(self.pieces)} pieces need {len(self.pieces) - 1} breakpoints")
        ends = self.breakpoints[self.innermost :]
        if self.odd and any(not b > a for a, b in pairwise((0.0, *ends))):
            raise Refused(f"breakpoints = {ends} must be positive and ascending")
        if not self.odd and any(not b > a for a, b in pairwise(ends)):
            raise Refused(text("the pieces of the force end at {u = :r}: these must be ascending", ends))

    @staticmethod
    def of(mechanism: Mechanism, parameters: tuple[float, ...]) -> Force:
        """Make the force of a mechanism from its parameters; a piece that ends at u = 0 is left out."""
        pieces = tuple(Piece(law, parameters) for law in mechanism.pieces)
        ends = tuple(float(end) for end in mechanism.breakpoints(*parameters))
        if not mechanism.odd:
            return Force(pieces, ends, odd=False)
        kept = [i for i, end in enumerate(ends) if end != 0.0]
        return Force((*(pieces[i] for i in kept), pieces[-1]), tuple(ends[i] for i in kept))

    @property
    def innermost(self) -> int:
        """Number of the first piece in which a mass can move: 1 if the force jumps at u = 0, else 0."""
        return int(isinstance(self.pieces[0], OneSided))

    @property
    def first_end(self) -> float | None:
        """End of that piece, for an odd force; None if there is only one piece."""
        return next(iter(self.breakpoints[self.innermost :]), None)

    @cached_property
    def first_ends(self) -> tuple[float, float]:
        """Ends of that piece below and above u = 0 for any force, infinite where it does not end."""
        below, above = (self.edge_ahead(side, side * self.innermost) for side in (-1, 1))
        return -math.inf if below is None else below, math.inf if above is None else above

    @property
    def jump(self) -> float:
        """f(0+), the height of the jump at u = 0, which may hold a mass there in addition to friction."""
        return self.pieces[1].value(0.0) if self.innermost else 0.0

    @property
    def edges(self) -> tuple[float, ...]:
        """The u at which each piece except the last ends, in ascending order."""
        return (*(-end for end in reversed(self.breakpoints)), *self.breakpoints) if self.odd else self.breakpoints

    @property
    def _about(self) -> int:
        """How many of these lie below the piece about u = 0."""
        return len(self.breakpoints) if self.odd else sum(b < 0 for b in self.breakpoints)

    def beyond(self, slip: int, region: int) -> int:
        """Return the region that a mass enters from another one, by the direction of its slip."""
        return region + slip or self.innermost * slip

    def region_of(self, u: float) -> int:
        """Return the region of a displacement u."""
        if not self.odd:
            return sum(u > b for b in self.breakpoints) - self._about
        index = sum(abs(u) > b for b in self.breakpoints)
        return index if u > 0 else -index

    def piece(self, region: int) -> Piece:
        """Return the piece of a region; next to a jump at u = 0, on its side of it."""
        piece = self.pieces[abs(region) if self.odd else self._about + region]
        return OneSided(piece.law, piece.constants, region) if self.innermost and abs(region) == 1 else piece

    def edge_ahead(self, slip: int, region: int) -> float | None:
        """Return the breakpoint ahead of a mass that slips within a region, with its sign; None if there is none."""
        ahead, edges = self._about + region - (slip < 0), self.edges
        return edges[ahead] if 0 <= ahead < len(edges) else None

    def value(self, u: float) -> float:
        """f(u), dimensionless."""
        return self.piece(self.region_of(u)).value(u)

    def __call__(self, u: Floats) -> Floats:
        """f(u) at displacements of any shape, dimensionless."""
        return self._by_piece(u, lambda piece, u: piece(u))

    def stiffness(self, u: Floats) -> Floats:
        """df/du at displacements of any shape, dimensionless; at a breakpoint that of the inner piece."""
        return self._by_piece(u, lambda piece, u: piece.law.slope(u, *piece.constants))

    def _by_piece(self, u: Floats, function: Callable[[Piece, Floats], Floats]) -> Floats:
        region = np.searchsorted(self.breakpoints, np.abs(u) if self.odd else u, side="left")
        values = np.empty_like(u)
        for number, piece in enumerate(self.pieces):
            values[region == number] = function(piece, u[region == number])
        return values


@dataclass(frozen=True)
class EquationOfMotion:
    """Equation (3) without its forcing: f(u), mu >= 0, zeta >= 0, all dimensionless.

    inertial -- whether inertia excites it (base excitation, unbalance), so that the force is F_0 Omega^2
    load     -- static force in addition to F_0 cos(Omega tau)
    c_2      -- quadratic damping, c_2 |u'|u'
    released -- whether friction acts on the first piece of the force only
    mu_s     -- static friction, if larger than mu
    eta      -- structural damping, (eta/Omega) u' in a motion at Omega
    c_3      -- cubic damping, c_3 u'^3
    zeta_2   -- viscous damping that grows with the displacement, 2 (zeta + zeta_2 u^2) u'
    """

    force: Force
    mu: float
    zeta: float
    inertial: bool = False
    load: float = 0.0
    c_2: float = 0.0
    released: bool = False
    mu_s: float = 0.0
    eta: float = 0.0
    c_3: float = 0.0
    zeta_2: float = 0.0

    def __post_init__(self) -> None:
        for name in ("mu", "zeta", "c_2", "mu_s", "eta", "c_3", "zeta_2"):
            value = getattr(self, name)
            if not (np.isfinite(value) and value >= 0):
                raise Refused(f"{name} = {value} must be finite and not negative")

    @property
    def centred(self) -> bool:
        """Whether motions may be symmetric about u = 0: the force is odd, and there is no load."""
        return self.load == 0 and self.force.odd

    def friction(self, region: int) -> float:
        """Return the kinetic friction in a region."""
        return 0.0 if self.released and region != 0 else self.mu

    def holds(self, region: int) -> float:
        """Return the largest force against which friction can hold a mass at rest in a region."""
        bound = 0.0 if self.released and region != 0 else max(self.mu, self.mu_s)
        return bound + self.force.jump if region == 0 else bound

    @property
    def is_damped(self) -> bool:
        """Whether there is any damping or friction."""
        return not self.mu == self.zeta == self.c_2 == self.eta == 0

    def forcing(self, *, Omega: float, F_0: float) -> float:
        """Return the amplitude of the force for an amplitude F_0 of the excitation."""
        return float(inertia.force(Omega, F_0)) if self.inertial else F_0


def by_piece(laws: Sequence[Any], ends: Sequence[Any], u: Any, parameters: Sequence[Any], order: int = 0) -> Floats:
    """A force whose laws hold up to these ends, or its slope, order 1, at u > 0; shapes that broadcast."""
    value = np.asarray(laws[0][order](u, *parameters))
    for end, law in zip(ends, laws[1:], strict=True):
        value = np.where(u > end, law[order](u, *parameters), value)
    return value


def followed(force: Force, name: str) -> Force:
    """A force as its motions are followed, by laws that hold wherever these go.

    Raises ValueError where they are not, of a mechanism by its name.
    """
    if force.odd and force.value(0.0) != 0:
        first = force.pieces[0]
        force = Force((OneSided(first.law, first.constants, 0), *force.pieces), (0.0, *force.breakpoints))
    with np.errstate(all="ignore"):
        stiffness = force.pieces[force.innermost].slope(0.0) if force.odd else 0.0
    if not math.isfinite(stiffness):
        raise Refused(text("motions of {name:s} are not followed: its stiffness is infinite at {u} = 0", name))
    return force


#: alpha, beta and gamma of the Duffing oscillator that is linear
LINEAR = (1.0, 0.0, 0.0)


#: of the numbers that h and its slope are made of: what rounding in a formula of another's may cost
LOST_AT_REST = 1e-6


def check_at_rest(mechanism: Mechanism, parameters: tuple[float, ...]) -> None:
    """Raises ValueError for a record whose average at A = 0 is not that of its force: -4/pi f (20), and -df/du.

    A formula of h that is 0/0 there, or wrong, is no formula at rest, where every search begins.
    """
    if not mechanism.odd:
        return
    piece = Force.of(mechanism, parameters).pieces[0]
    with np.errstate(all="ignore"):
        f, slope = piece.value(0.0), piece.slope(0.0)
        found = tuple(float(value) for value in mechanism.at_rest(*parameters)[:2])
        expected = -float(slow_flow.friction(f)), -slope
    near = LOST_AT_REST * max(map(abs, (*parameters, *expected, 1.0)))
    for name, value, target in zip(("h", "h_A"), found, expected, strict=True):
        if math.isfinite(target) and not abs(value - target) <= near:
            raise Refused(
                f"the record of {mechanism.name} does not hold at A = 0: averaged gives {name} = {value:g} there, "
                f"while its force has f(0) = {f:g} and df/du = {slope:g}, so that {name} is {target:g}"
            )


def linear() -> Force:
    """f(u) = u: the isolator without preload (delta_h = 0), Den Hartog's oscillator."""
    return Force.of(duffing.MECHANISM, LINEAR)


def described(domains: Iterable[Parameter]) -> str:
    """Return parameters and their domains, one line each, for a docstring."""
    return "\n".join(f"    {domain.name} -- {domain.doc}, {allowed(domain)}" for domain in domains)


def allowed(domain: Parameter) -> str:
    """A description of the numbers in a domain."""
    limits = ((">", domain.above), (">=", domain.least), ("<", domain.below), ("<=", domain.most))
    return " and ".join(f"{sign} {limit:g}" for sign, limit in limits if limit is not None) or "any finite number"
