"""The record of a mechanism, filled by the derivation: `MECHANISM` of each generated module.

`Parameter`, `Scale`, `Law` and `Mechanism` are immutable. All numbers are dimensionless, symbols those of (3)-(7).
"""

from __future__ import annotations

import functools
import importlib
import sys
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from functools import cached_property
from itertools import pairwise
from math import inf, isfinite
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from slowflow.support.errors import Refused

#: where generated modules are, those that come with the package and those that were derived on this machine
GENERATED = ("slowflow_kernels", "slowflow.derived")
#: an amplitude that stands for 0 where a piece ends there, and the share of h by which it is rounded where it is
#: proportional to A
NEXT_TO_REST, LINEAR = 2.0**-100, 2.0**-50
#: a generated function of numbers or arrays that broadcast
Function = Callable[..., Any]


@dataclass(frozen=True)
class Parameter:
    """A dimensionless parameter and its domain: the finite numbers within these bounds.

    name -- name of the argument
    doc  -- description, one line
    unit -- scale of the dimensional quantity, "1" for a pure number
    above, least -- lower bounds, exclusive and inclusive; None for no bound
    below, most  -- upper bounds, exclusive and inclusive; None for no bound
    """

    name: str
    doc: str
    unit: str
    above: float | None = None
    least: float | None = None
    below: float | None = None
    most: float | None = None

    @property
    def bounds(self) -> dict[str, float]:
        """The bounds that are set, by name."""
        found = {"above": self.above, "least": self.least, "below": self.below, "most": self.most}
        return {name: bound for name, bound in found.items() if bound is not None}

    def holds(self, value: float) -> bool:
        """Return whether a number lies in the domain."""
        return (
            isfinite(value)
            and (self.above is None or value > self.above)
            and (self.least is None or value >= self.least)
            and (self.below is None or value < self.below)
            and (self.most is None or value <= self.most)
        )


class Scale(NamedTuple):
    """The scale factor k_v^p L^q m^s of a dimensionless number: their product is the dimensional quantity (4).

    letter -- the paper's symbol of that quantity
    powers -- exponents of k_v, L and m
    """

    letter: str
    factor: float
    powers: tuple[float, float, float]


class Law(NamedTuple):
    """One piece of a force and its slope: functions of (u, *parameters), for any kind of number that has arithmetic.

    name  -- name of its Taylor recurrences; empty if none were generated
    """

    force: Function
    slope: Function
    name: str = ""


class Curved(NamedTuple):
    """What the means of a force of any kind are summed from, where motions are off the centre.

    gained -- of the parameters: what f, f', f'' gain at each breakpoint
    pieces -- of each piece at (u, *parameters): f and its first three derivatives
    held   -- the same at (around, u, *parameters), on intervals
    gained_by -- of the parameters, which are the design: what each does to the gains of f and f', breakpoint by
              breakpoint
    moved  -- of each piece, by each parameter, at (u, *parameters): the derivative of f, and that one's first two by u;
              None where they are 0
    """

    gained: Function
    pieces: tuple[Function, ...]
    held: tuple[Function, ...]
    gained_by: Function
    moved: tuple[tuple[Function | None, ...], ...]


@dataclass(frozen=True, eq=False)
class Mechanism:
    """A restoring force u + F_k(u), its average and its parameters. Records compare by value.

    name, title -- name of the generated module, and a one-line description
    design      -- parameters of the design, without those of damping
    parameters  -- arguments of the functions below, in their order
    coefficients -- function of the design that returns the parameters (5), (7)
    pieces      -- the force u + F_k(u) in pieces, in ascending order of |u|; a breakpoint belongs to the inner piece
    breakpoints -- function of the parameters: the |u| at which each piece except the last ends (5)
    jumps       -- function of the parameters: the drop of the force at each breakpoint, f below minus f above
    hardening   -- function of the parameters: f(u)/u rises with |u| if none of its values is negative
    averaged    -- h = H - A and its first three derivatives at (A, *parameters) (20)-(22), (31)
    intercept   -- h - A h_A at (A, *parameters), without cancellation
    harmonics   -- h_3, h_5, each with its first three derivatives, at (A, *parameters)
    harmonics_up_to -- the largest breakpoint for which `harmonics` is valid
    reach, reach_reason -- largest |u| of the mechanism, inf if unlimited, and the reason; `reach_at` for a design
    truncated   -- whether the force is the Taylor polynomial of another one
    load_untruncated -- loads the record of that other force; None if there is none
    load_balls  -- loads the averages in ball arithmetic, for proofs; None if they are not generated
    scales      -- scale of each parameter of the design; () if the design has no dimensional quantities
    by_parameter -- d/dp of h, h_A, h_AA at (A, h, h_A, h_AA, *parameters), for each parameter p in turn
    by_design   -- derivatives of each parameter, then of each breakpoint, with respect to each parameter of the design;
                   without this and `by_parameter` there are no gradients
    kinks       -- function of the parameters: the drops of slope and curvature of the force at each breakpoint; None
                   if the force or its slope jumps at all breakpoints
    enclosed    -- for each piece the integrand of the average on intervals, at (around, A, u minus the start of the
                   piece, sine, *parameters); None if h_AAA is proved to be monotone on each piece; () if only `samples`
                   bound the force
    steps       -- function of the parameters: f and its derivatives just above u = 0; their increments at each
                   breakpoint; and those of the formula of the last piece at u = 0. None if a piece is not a polynomial.
                   For a force that is not odd: those of the formula of each piece at u = 0, and their increments
    steps_by    -- function of the parameters: derivatives of `steps` with respect to each parameter, at fixed u
    curved      -- functions that give the averages of offset motions if `steps` is None; None if there are none
    told        -- function of the parameters: a description of a force that is not a formula; None for a formula
    samples     -- function of the parameters: the data from which the compiled solvers evaluate a force that is not a
                   formula; None for a formula
    mirrored    -- text of the first piece if its expression is not odd, so that its mirror image is used for u < 0;
                   otherwise ""
    odd         -- whether the force is odd, with pieces for u > 0; otherwise pieces and breakpoints are in ascending
                   order of u, and the averages about the centre are `unknown`
    """

    name: str
    title: str
    design: tuple[Parameter, ...]
    parameters: tuple[Parameter, ...]
    coefficients: Function
    pieces: tuple[Law, ...]
    breakpoints: Function
    jumps: Function
    hardening: Function
    averaged: Function
    intercept: Function
    harmonics: Function
    harmonics_up_to: float
    reach: float
    reach_reason: str
    truncated: bool
    load_untruncated: Callable[[], Mechanism] | None
    load_balls: Callable[[], ModuleType] | None = None
    scales: tuple[Scale, ...] = ()
    by_parameter: Function | None = None
    by_design: Function | None = None
    kinks: Function | None = None
    enclosed: tuple[Function, ...] | None = None
    steps: Function | None = None
    steps_by: Function | None = None
    curved: Curved | None = None
    odd: bool = True
    told: Function | None = None
    samples: Function | None = None
    mirrored: str = ""

    @cached_property
    def design_names(self) -> tuple[str, ...]:
        """Names of the parameters of a design, in their order."""
        return tuple(one.name for one in self.design)

    @cached_property
    def parameter_names(self) -> tuple[str, ...]:
        """Names of the parameters, in their order."""
        return tuple(one.name for one in self.parameters)

    def at_rest(self, *parameters: Any) -> tuple[Any, ...]:
        """h and its first three derivatives (20)-(22) as A tends to 0, of the first piece that has an extent.

        A breakpoint may be 0; `averaged` at A = 0 would use the empty piece that ends there.
        """
        ends = [np.asarray(end) == 0 for end in self.breakpoints(*parameters)]
        if not np.any([end.any() for end in ends]):
            return tuple(self.averaged(0.0, *parameters))
        begins_beyond = functools.reduce(np.logical_or, ends)
        A = np.where(begins_beyond, NEXT_TO_REST, 0.0)
        found = self.averaged(A, *parameters)
        # what tends to 0 has |f - A f_A| <= A |f_A| next to it
        tends = (begins_beyond & (np.abs(f - A * f_A) <= A * np.abs(f_A)) for f, f_A in pairwise(found))
        return *(np.where(to_0, 0.0, f) for to_0, f in zip(tends, found, strict=False)), found[-1]

    def reach_at(self, *parameters: Any) -> Any:
        """The reach at parameters, in their shape: inf where only the last piece is left and is linear."""
        ends = [np.asarray(end) == 0 for end in self.breakpoints(*parameters)]
        if not (self.odd and ends and isfinite(self.reach)):
            return self.reach
        last = functools.reduce(np.logical_and, ends)
        if not last.any():
            return self.reach
        A = 0.5 * self.reach
        h, h_A, h_AA, _ = self.averaged(A, *parameters)
        linear = (h_AA == 0) & (np.abs(h - A * h_A) <= LINEAR * np.abs(h))
        return np.where(last & linear, inf, self.reach)

    @cached_property
    def is_generated(self) -> bool:
        """Whether this is the unchanged record of the generated module of its name, to which compiled code belongs."""
        module = self._module
        return module in (f"{package}.{self.name}" for package in GENERATED) and _record_in(module) is self

    @property
    def _module(self) -> str:
        return getattr(self.pieces[0].force, "__module__", None) or ""

    def __eq__(self, other: object) -> bool:
        if self is other:
            return True
        return not self._changes(other) if isinstance(other, Mechanism) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.name)

    def __reduce__(self) -> tuple[Any, ...]:
        # compiled functions cannot be pickled: the module that states the record can be imported again
        stated = _record_in(self._module)
        if stated is not None:
            return _stated, (self._module, self._changes(stated))
        return Mechanism, tuple(getattr(self, field.name) for field in fields(self))

    def _changes(self, other: Mechanism) -> dict[str, Any]:
        own = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: value for name, value in own.items() if value != getattr(other, name)}


def stated_by_module(mechanism: Mechanism) -> Mechanism | None:
    """The record as the module of its force states it, None where none does."""
    return _record_in(mechanism._module)


def _record_in(module: str) -> Mechanism | None:
    """The record that a module states as MECHANISM."""
    found = getattr(sys.modules.get(module), "MECHANISM", None)
    return found if isinstance(found, Mechanism) else None


def _stated(module: str, changes: dict[str, Any]) -> Mechanism:
    """The record that a module states, with what was changed in it, for pickle."""
    mechanism: Mechanism = importlib.import_module(module).MECHANISM
    return replace(mechanism, **changes) if changes else mechanism


def nothing(*parameters: Any) -> tuple[()]:
    """Of a force with one piece: no breakpoint, no jump."""
    return ()


def unknown(*numbers: Any) -> Any:
    """What is about the centre, of a force that is not odd: raises ValueError."""
    raise Refused("the force is not odd: its motions are not centred, and have no averages about the centre")
