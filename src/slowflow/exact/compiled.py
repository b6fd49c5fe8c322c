"""The compiled integrator: in go questions about smooth motion, whole motions and cycles, out come C's answers.

In:  pieces of a force whose recurrences are compiled or interpreted, or that are known by values, states, orders of
     switches.
Out: what Taylor series of order 24 give, with an error per step of one rounding, without the GIL.

The oscillator that the C functions take is made once for each and never changes; they share nothing else, so any thread
may call them.
"""

from __future__ import annotations

import functools
import json
import math
import struct
import sys
from array import array
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow import backend
from slowflow.exact.work import MOST_STEPS, MOST_WORK, spend, steps_left
from slowflow.mechanism import EquationOfMotion, Law, Piece
from slowflow.sampled import rows
from slowflow_kernels.exact_conventions import FAR
from slowflow_support.errors import NotSettled

EXACT = backend.EXACT
Array = npt.NDArray[np.float64]
PHASE = struct.Struct("@iiddddddi?0d")  # a phase as C has it, in the order of `motion.Phase`
#: a phase of a shock likewise: when its arc begins, the arc, the phase
STRETCH = struct.Struct("@d4diiddddddi?dl")
KEPT = 64  # oscillators in C, of which a curve asks one again and again


#: the oscillator that was asked for last, and what it is for C; set as a whole, so that threads may share it
_last: tuple[EquationOfMotion | None, Any] = None, None


def recurrences(law: Law) -> Any:
    """A law's recurrences in C, those that are interpreted among them; None for one that has none, or too many."""
    if not law.name:
        return None
    if law.name not in EXACT.LAWS:
        _interpret(law.force)
    return EXACT.LAWS.get(law.name)


def _interpret(force: Any) -> None:
    """Makes laws of the programs beside a force's module, if there are any."""
    module = sys.modules[force.__module__]
    place = Path(module.__file__ or "")
    place = place.with_name(f"{place.stem}_motion.json")
    for name, program in json.loads(place.read_text()).items() if place.exists() else ():
        lists = array("i", program["words"]).tobytes(), array("d", program["numbers"]).tobytes()
        EXACT.LAWS[name] = EXACT.interpreted(name, *lists)


def _law(piece: Piece, low: float, high: float) -> tuple[Any, tuple[float, ...]]:
    """The law for C of a piece that holds from low to high, and its constants: polynomials where it has no series."""
    found = recurrences(piece.law)
    if found is not None:
        return found, piece.constants
    sides = []
    for side in (-1.0, 1.0):
        begin, end = sorted((side * low, side * high))
        begin = max(begin, 0.0)
        # on a side where it does not hold Newton's iteration may try it
        end = end if end > begin else begin + 1.0
        first = end - begin if end < FAR else max(begin, 1.0)
        sides.append(rows(lambda v, side=side: side * _values(piece, side * v), begin, end, first))  # type: ignore[misc]
    return EXACT.polynomials(*sides), ()


def _values(piece: Piece, u: Array) -> Array:
    """A force at several displacements, NaN where it has none."""
    force = functools.partial(_value, piece)
    try:
        found = np.asarray(piece.law.force(u, *piece.constants), dtype=float)
    except Exception:
        found = np.empty(0)
    return found if found.shape == u.shape else np.array([force(one) for one in u.tolist()])


def _value(piece: Piece, u: float) -> float:
    try:
        return float(piece.law.force(u, *piece.constants))
    except Exception:
        return math.nan


def of_system(system: EquationOfMotion) -> Any:
    """The oscillator for C: of the one that was asked for last at once, as its hash takes longer than a step."""
    global _last
    known, compiled = _last
    if known is not system:
        compiled = _made(system)
        _last = system, compiled
    return compiled


@functools.lru_cache(maxsize=KEPT)
def _made(system: EquationOfMotion) -> Any:
    force = system.force
    about = -force.region_of(-math.inf)
    ends = (-FAR, *force.edges, FAR)
    if force.odd:  # each holds on both sides of u = 0
        of = [_law(piece, *ends[about + i : about + i + 2]) for i, piece in enumerate(force.pieces)]
        made = of[:0:-1] + of
    else:
        made = [_law(piece, *ends[i : i + 2]) for i, piece in enumerate(force.pieces)]
    laws, constants = zip(*made, strict=True)
    damping = system.mu, system.zeta, system.inertial, system.load, system.c_2, system.released, system.mu_s, system.eta
    return EXACT.system(laws, constants, force.edges, about, force.odd, *damping, force.jump)


def advance(
    forced: Any, slip: int, region: int, theta: float, u: float, v: float, end: float
) -> tuple[float, float, Array]:
    """State (u, v) at `end`, also before theta, and its derivatives by (u, v, Omega, F_0): shape (2, 4)."""
    system, Omega, F_0 = forced
    flow = np.empty((2, 4))
    outcome, steps, u, v = EXACT.advance(
        of_system(system), Omega, F_0, slip, region, theta, u, v, end, steps_left(), flow
    )
    spend(steps)
    if outcome:
        raise NotSettled(f"the integration from theta = {theta} to {end} failed")
    return u, v, flow


def sample(forced: Any, phase: Any, grid: Array) -> Array:
    """u, v and the acceleration of the mass, as seen by who stands still, within a phase: shape (grid.size, 3).

    grid -- does not fall, and lies at or after where the phase begins
    """
    system, Omega, F_0 = forced
    states = np.empty((grid.size, 3))
    outcome, steps = EXACT.sample(
        of_system(system), Omega, F_0, *phase[:5], steps_left(), np.ascontiguousarray(grid), states
    )
    spend(steps)
    if outcome:
        raise NotSettled(f"the integration from theta = {phase.theta} to {grid[-1]} failed")
    return states


def shock(
    system: EquationOfMotion, arcs: Array, *how: float
) -> tuple[int, tuple[float, ...], Iterator[tuple[Any, ...]]]:
    """What a mass does under the arcs: the outcome, numbers as `many_shocks` has them, and its phases.

    how -- when the arcs begin, how long the free motion is followed, u, v, and where the mass rests without friction
    Where it is not followed to the end the numbers are when that is, u there, and the amplitude of what drives it.
    """
    arcs = np.ascontiguousarray(arcs)
    outcome, steps, numbers, phases = EXACT.shock(of_system(system), arcs, *how, MOST_STEPS, MOST_WORK)
    spend(steps)
    return outcome, numbers, STRETCH.iter_unpack(phases)


def follow(
    system: EquationOfMotion,
    Omega: float,
    F_0: float,
    state: tuple[float, float, float],
    end: float,
    start: tuple[int, int] | None,
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
    )
    spend(steps)
    return outcome, PHASE.iter_unpack(phases)


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
