"""The compiled integrator: smooth motion by Taylor series of order 24, one rounding of error per step, without the GIL.

The pieces of a force have recurrences, compiled or interpreted, or are approximated by polynomials. The oscillator that
the C functions take is immutable and made once; they have no other state in common, so any thread may call them.
"""

from __future__ import annotations

import functools
import json
import math
import sys
from array import array
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from slowflow import backend
from slowflow.exact.work import spend, steps_left
from slowflow.mechanism import EquationOfMotion, Floats, Law, Piece
from slowflow.sampled import rows
from slowflow.support.errors import NotSettled
from slowflow_kernels.exact_conventions import FAR

EXACT = backend.EXACT
CACHE_SIZE = 64  # oscillators in C


#: the last oscillator and its handle, set as one tuple for thread safety
_last: tuple[EquationOfMotion | None, Any] = None, None


def recurrences(law: Law) -> Any:
    """A law's recurrences in C, those that are interpreted among them; None for one that has none, or too many."""
    if not law.name:
        return None
    if law.name not in EXACT.LAWS:
        _interpret(law.force)
    return EXACT.LAWS.get(law.name)


def _interpret(force: Any) -> None:
    """Makes laws of the programs in the folder of a force's module, if there are any."""
    module = sys.modules[force.__module__]
    path = Path(module.__file__ or "")
    path = path.with_name(f"{path.stem}_motion.json")
    for name, program in json.loads(path.read_text()).items() if path.exists() else ():
        lists = array("i", program["words"]).tobytes(), array("d", program["numbers"]).tobytes()
        EXACT.LAWS[name] = EXACT.interpreted(name, *lists)


def _law(piece: Piece, low: float, high: float) -> tuple[Any, tuple[float, ...]]:
    """The law for C of a piece that holds from low to high, and its constants: polynomials where it has no series."""
    series = recurrences(piece.law)
    if series is not None:
        return series, piece.constants
    sides = []
    for side in (-1.0, 1.0):
        begin, end = sorted((side * low, side * high))
        begin = max(begin, 0.0)
        # on a side where it does not hold Newton's iteration may try it
        end = end if end > begin else begin + 1.0
        first = end - begin if end < FAR else max(begin, 1.0)
        sides.append(rows(lambda v, side=side: side * _values(piece, side * v), begin, end, first))  # type: ignore[misc]
    return EXACT.polynomials(*sides), ()


def _values(piece: Piece, u: Floats) -> Floats:
    """A force at several displacements, NaN where it has none."""
    force = functools.partial(_value, piece)
    try:
        values = np.asarray(piece.law.force(u, *piece.constants), dtype=float)
    except Exception:
        values = np.empty(0)
    return values if values.shape == u.shape else np.array([force(one) for one in u.tolist()])


def _value(piece: Piece, u: float) -> float:
    try:
        return float(piece.law.force(u, *piece.constants))
    except Exception:
        return math.nan


def design_rows(values: Sequence[Any], count: int) -> Floats:
    """Numbers of so many designs, a row for each."""
    return np.array([np.broadcast_to(value, count) for value in values], dtype=float).reshape(-1, count).T


def handle(system: EquationOfMotion) -> Any:
    """The oscillator for C. The last one is compared by identity, as its hash takes longer than a step."""
    global _last
    known, compiled = _last
    if known is not system:
        compiled = _compile(system)
        _last = system, compiled
    return compiled


@functools.lru_cache(maxsize=CACHE_SIZE)
def _compile(system: EquationOfMotion) -> Any:
    force = system.force
    centre = -force.region_of(-math.inf)
    ends = (-FAR, *force.edges, FAR)
    if force.odd:  # each holds on both sides of u = 0
        positive = [_law(piece, *ends[centre + i : centre + i + 2]) for i, piece in enumerate(force.pieces)]
        laws_of = positive[:0:-1] + positive
    else:
        laws_of = [_law(piece, *ends[i : i + 2]) for i, piece in enumerate(force.pieces)]
    laws, constants = zip(*laws_of, strict=True)
    damping = system.mu, system.zeta, system.inertial, system.load, system.c_2, system.released, system.mu_s, system.eta
    return EXACT.system(laws, constants, force.edges, centre, force.odd, *damping, force.jump)


def advance(
    forced: Any, slip: int, region: int, theta: float, u: float, v: float, end: float
) -> tuple[float, float, Floats]:
    """State (u, v) at `end`, also before theta, and its derivatives by (u, v, Omega, F_0): shape (2, 4)."""
    system, Omega, F_0 = forced
    flow = np.empty((2, 4))
    outcome, steps, u, v = EXACT.advance(handle(system), Omega, F_0, slip, region, theta, u, v, end, steps_left(), flow)
    spend(steps)
    if outcome:
        raise NotSettled(f"the integration from theta = {theta} to {end} failed")
    return u, v, flow


def sample(forced: Any, phase: Any, grid: Floats) -> Floats:
    """u, v and the absolute acceleration of the mass within a phase: shape (grid.size, 3).

    grid -- does not fall, and lies at or after where the phase begins
    """
    system, Omega, F_0 = forced
    states = np.empty((grid.size, 3))
    outcome, steps = EXACT.sample(
        handle(system), Omega, F_0, *phase[:5], steps_left(), np.ascontiguousarray(grid), states
    )
    spend(steps)
    if outcome:
        raise NotSettled(f"the integration from theta = {phase.theta} to {grid[-1]} failed")
    return states
