"""What a mechanism says of itself, as one record that the derivation fills: `MECHANISM` in each generated module.

In:  what the generated modules state.
Out: `Parameter`, `Scale`, `Law` and `Mechanism`, all immutable. All is dimensionless, in the paper's symbols (3)-(7).
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite
from typing import Any, NamedTuple

#: a generated function of numbers or arrays that broadcast
Function = Callable[..., Any]


@dataclass(frozen=True)
class Parameter:
    """A dimensionless number, and which are allowed: finite ones within these bounds.

    name -- of the argument
    doc  -- one line: what it is
    unit -- what the dimensional quantity is measured in, "1" for a number
    above, least -- it is greater than the one, or not less than the other; None where nothing bounds it from below
    below, most  -- it is less than the one, or not greater than the other; None where nothing bounds it from above
    """

    name: str
    doc: str
    unit: str
    above: float | None = None
    least: float | None = None
    below: float | None = None
    most: float | None = None

    def holds(self, value: float) -> bool:
        """Whether a number is one of those allowed."""
        return (
            isfinite(value)
            and (self.above is None or value > self.above)
            and (self.least is None or value >= self.least)
            and (self.below is None or value < self.below)
            and (self.most is None or value <= self.most)
        )


class Scale(NamedTuple):
    """What a dimensionless number is measured in, factor k_v^p L^q m^s: times this it is the dimensional quantity (4).

    letter -- the paper's for that quantity
    powers -- of k_v, L and m
    """

    letter: str
    factor: float
    powers: tuple[float, float, float]


class Law(NamedTuple):
    """One piece of a force and its slope: functions of (u, *parameters), for any kind of number that has arithmetic.

    name -- of its Taylor recurrences in C; empty for a law that none were generated for
    """

    force: Function
    slope: Function
    name: str = ""


@dataclass(frozen=True, eq=False)
class Mechanism:
    """A restoring force u + F_k(u), its average and its parameters.

    name, title -- of the generated module, and one line
    design      -- what a user gives beside the damping
    parameters  -- what the functions below take, in their order
    coefficients -- the parameters from the design, as a tuple (5), (7)
    pieces      -- the force u + F_k(u), piece by piece by rising |u|; a piece holds up to its breakpoint and there
    breakpoints -- of the parameters: the |u| at which each piece but the last ends (5)
    jumps       -- of the parameters: what the force loses at each breakpoint, f below less f above
    hardening   -- of the parameters: f(u)/u rises with |u| where none of these numbers is negative
    averaged    -- h = H - A and its first three derivatives at (A, *parameters) (20)-(22), (31)
    intercept   -- h - A h_A at (A, *parameters) without what cancels in it
    harmonics   -- h_3, h_5, each with its first three derivatives, at (A, *parameters)
    harmonics_up_to -- the largest breakpoint for which `harmonics` holds
    reach, reach_reason -- largest |u| that the mechanism can take, inf if it has none, and what happens there
    truncated   -- whether the force is a Taylor polynomial that stands for another
    load_untruncated -- loads the record of the force that `truncated` stands for; None where there is none
    scales      -- what each number of the design is measured in; () where the design has no dimensional quantities
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
    scales: tuple[Scale, ...] = ()

    def __reduce__(self) -> tuple[Any, ...]:
        # compiled functions cannot be pickled: the module that states the record can be imported again
        return _stated, (self.pieces[0].force.__module__,)


def _stated(module: str) -> Mechanism:
    """The record that a generated module states, for pickle."""
    mechanism: Mechanism = importlib.import_module(module).MECHANISM
    return mechanism


def nothing(*parameters: Any) -> tuple[()]:
    """Of a force with one piece: no breakpoint, no jump."""
    return ()
