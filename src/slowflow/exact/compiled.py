"""The compiled integrator: in go questions about smooth motion, whole motions and cycles, out come C's answers.

In:  pieces of a force that the derivation generated recurrences for, for the package or a library of its own, states,
     orders of switches.
Out: `TaylorIntegrator`, an `Integrator` that also follows motions and solves cycles by itself, without the GIL.

What it computes is stated in `integrate`, `motion` and `cycle`, whose Python is the reference for it. The oscillator
that the C functions take is made once for each and never changes; they share nothing else, so any thread may call them.
"""

from __future__ import annotations

import functools
import math
import struct
from collections.abc import Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow import backend
from slowflow.exact.integrate import (
    MOST_STEPS,
    MOST_WORK,
    Array,
    Drive,
    Integrator,
    ScipyIntegrator,
    spend,
    steps_left,
)
from slowflow.mechanism import EquationOfMotion, Force, Law, OneSided, Piece
from slowflow_support.errors import NotSettled

EXACT: Any = backend.EXACT
PHASE = struct.Struct("@iiddddddi?0d")  # a phase as C has it, in the order of `motion.Phase`
# friction and damping of a piece by itself: a drive has its own
ALONE = (0.0, 0.0, False, 0.0, 0.0, False, 0.0, 0.0, 0.0)
KEPT = 64  # oscillators in C, of which a curve asks one again and again
TRACED = 50  # points of a curve at a time: some milliseconds, after which Ctrl-C is heard


#: the oscillator that was asked for last, and what it is for C; set as a whole, so that threads may share it
_last: tuple[EquationOfMotion | None, Any] = None, None


def recurrences(law: Law) -> Any:
    """A law's recurrences in C; None for one that was not generated or compiled, or without the extension."""
    return None if EXACT is None else EXACT.LAWS.get(law.name)


def compiles(system: EquationOfMotion) -> bool:
    """Whether every piece of the force has recurrences in C."""
    return all(recurrences(piece.law) is not None for piece in system.force.pieces)


def of_system(system: EquationOfMotion) -> Any:
    """The oscillator for C: of the one that was asked for last at once, as its hash takes longer than a step."""
    global _last
    known, compiled = _last
    if known is not system:
        compiled = _compiled(system)
        _last = system, compiled
    return compiled


@functools.lru_cache(maxsize=KEPT)
def _compiled(system: EquationOfMotion) -> Any:
    force = system.force
    pieces, edges = by_rising_u(force)
    about = -force.region_of(-math.inf)
    laws, constants = tuple(recurrences(piece.law) for piece in pieces), tuple(piece.constants for piece in pieces)
    damping = system.mu, system.zeta, system.inertial, system.load, system.c_2, system.released, system.mu_s, system.eta
    return EXACT.system(laws, constants, edges, about, force.odd, *damping, force.jump)


def by_rising_u(force: Force) -> tuple[tuple[Piece, ...], tuple[float, ...]]:
    """All pieces, and the u at which each but the last ends."""
    if not force.odd:
        return force.pieces, force.breakpoints
    return force.pieces[:0:-1] + force.pieces, (*(-end for end in reversed(force.breakpoints)), *force.breakpoints)


@functools.lru_cache(maxsize=KEPT)
def of_piece(piece: Piece) -> Any:
    """An oscillator of that piece alone."""
    side = piece.side if isinstance(piece, OneSided) else 0
    return EXACT.system((recurrences(piece.law),), (piece.constants,), (), 0, True, *ALONE, side)


class TaylorIntegrator:
    """Taylor series of order 24 from the generated recurrences, error per step of one rounding."""

    name = "taylor"

    def advance(
        self, piece: Piece, drive: Drive, theta: float, u: float, v: float, end: float
    ) -> tuple[float, float, Array]:
        """See `Integrator`."""
        flow = np.empty((2, 4))
        outcome, steps, u, v = EXACT.advance(of_piece(piece), drive, theta, u, v, end, steps_left(), flow)
        spend(steps)
        if outcome:
            raise NotSettled(f"the integration from theta = {theta} to {end} failed")
        return u, v, flow

    def until(
        self, piece: Piece, drive: Drive, slip: int, edge: float, theta: float, u: float, v: float, end: float
    ) -> tuple[float, float, float, int]:
        """See `Integrator`."""
        outcome, steps, at, u, v, event, _ = EXACT.until(
            of_piece(piece), drive, slip, edge, theta, u, v, end, steps_left()
        )
        spend(steps)
        if outcome:
            raise NotSettled(f"the integration from theta = {theta} failed at theta = {at}")
        return at, u, v, event

    def sample(self, piece: Piece, drive: Drive, theta: float, u: float, v: float, grid: Array) -> Array:
        """See `Integrator`."""
        states = np.empty((grid.size, 2))
        outcome, steps = EXACT.sample(
            of_piece(piece), drive, theta, u, v, steps_left(), np.ascontiguousarray(grid), states
        )
        spend(steps)
        if outcome:
            raise NotSettled(f"the integration from theta = {theta} to {grid[-1]} failed")
        return states

    def follow(
        self,
        system: EquationOfMotion,
        Omega: float,
        F_0: float,
        state: tuple[float, float, float],
        end: float,
        start: tuple[int, int] | None,
        last_only: bool = False,
    ) -> tuple[int, Iterator[tuple[Any, ...]]]:
        """The outcome and the phases of `motion.follow`, each as its fields in order."""
        outcome, steps, phases = EXACT.follow(
            of_system(system),
            Omega,
            F_0,
            *state,
            end,
            start is not None,
            *(start or (0, 0)),
            steps_left(),
            last_only,
        )
        spend(steps)
        return outcome, PHASE.iter_unpack(phases)

    def newton(
        self,
        system: EquationOfMotion,
        signature: bytes,
        half_turns: int,
        z: Array,
        F_0: float,
        extra: tuple[int, Array, float, int],
        most: int,
        tolerance: float,
    ) -> tuple[int, Array, Array, tuple[Any, ...]]:
        """Newton's iteration from z, which it moves, or the equations at z where `most` is 0.

        extra -- kind, row, value, number of the border
        Gives the outcome, the equations' arrays one after the other, the direction in which they all stay zero, and A,
        the monodromy matrix row by row and the borders.
        """
        k = z.size - 3
        equations, along = np.empty((k + 2) * (k + 5) + (2 * k + 1) * (k + 4)), np.zeros(z.size)
        kind, row, value, border = extra
        outcome, steps, *rest = EXACT.newton(
            of_system(system),
            signature,
            half_turns,
            z,
            F_0,
            kind,
            row,
            value,
            border,
            most,
            tolerance,
            steps_left(),
            equations,
            along,
        )
        spend(steps)
        return outcome, equations, along, tuple(rest)

    def trace(
        self,
        system: EquationOfMotion,
        signature: bytes,
        half_turns: int,
        starts_from_rest: bool,
        F_0: float,
        course: tuple[float, float, float, float, float, float],
        point: Array,
        came_from: bool,
        size: float,
        travelled: float,
        first: Array,
    ) -> tuple[Array, float, float]:
        """Points of the curve after one, up to the first step with which anything is to be decided.

        course -- least and greatest Omega, largest step, least cosine between tangents, largest amplitude, and the
                  least that steps of u_0 are measured in
        point  -- unknowns, tangent, and what `came_from` says is there: those of the point before, with its row
        first  -- unknowns and tangent of the point where the curve began, or nothing
        Gives a row for each point (unknowns, tangent, A, dA along the curve, monodromy), the next step's length, and
        that of the curve so far.
        """
        k = point.size // 5 - 3
        rows = np.empty((TRACED, 2 * (k + 3) + 6))
        count, steps, _, size, travelled = EXACT.trace(
            of_system(system),
            signature,
            half_turns,
            starts_from_rest,
            F_0,
            course,
            point,
            came_from,
            size,
            travelled,
            first,
            steps_left(),
            rows,
        )
        spend(steps, keep=count > 0)
        return rows[:count], size, travelled

    def sweep(
        self, system: EquationOfMotion, Omega: Array, F_0: float, u: float, v: float, tries: bytes, most_turns: int
    ) -> Array:
        """What a sweep from (u, v) settles to at the first frequencies: rows of u, v, A, turns and stops of each.

        tries -- half turns of cycles as C takes them

        Up to one at which anything is unusual, or to where some tens of milliseconds are over: there may be no row.
        """
        rows = np.empty((Omega.size, 5))
        count, steps = EXACT.sweep(of_system(system), Omega, F_0, u, v, tries, most_turns, rows)
        spend(steps, keep=True)
        return rows[:count]


def many_shocks(
    laws: tuple[Any, ...], oscillators: list[Array], arcs: Array, begin: Array, after: float
) -> tuple[npt.NDArray[np.int8], Array]:
    """Shocks of oscillators whose pieces have these recurrences: their outcomes, and a row of numbers for each.

    oscillators -- rows of the force's parameters, of its breakpoints, of mu and zeta
    arcs, begin -- of `transient`, shape (n, arcs, 4), and when they begin
    Numbers are A, tau_A, a_max, tau_a, when the springs leave, whether the mass rests at the end, u_end.
    """
    outcomes, numbers = np.empty(begin.size, np.int8), np.empty((begin.size, 7))
    rows = (np.ascontiguousarray(values) for values in (*oscillators, arcs, begin))
    EXACT.shocks(laws, *rows, after, MOST_STEPS, MOST_WORK, outcomes, numbers)
    return outcomes, numbers


TAYLOR, SCIPY = TaylorIntegrator(), ScipyIntegrator()  # they hold nothing: one of each serves all


def default_integrator(system: EquationOfMotion) -> Integrator:
    """The compiled one where every piece of the force has recurrences in C, SciPy's elsewhere."""
    return TAYLOR if compiles(system) else SCIPY
