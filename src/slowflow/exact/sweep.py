"""A frequency sweep as an experiment sees it: the motion is simply followed while the frequency is stepped.

In:  an oscillator, F_0, the frequencies in the order they are visited.
Out: `Sweep`: the amplitude that settles at each, and the jumps between branches.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slowflow.answer import Table
from slowflow.exact.compiled import TaylorIntegrator, default_integrator
from slowflow.exact.integrate import Integrator, limited
from slowflow.exact.motion import Forced, stops
from slowflow.exact.shooting import at_rest, calmed, check_forcing, check_numbers, lengths, settle
from slowflow.mechanism import EquationOfMotion
from slowflow_support.errors import Refused

Array = NDArray[np.float64]

AT_ONCE = 4096  # frequencies that C is given at a time: as many rows are made
JUMP = 0.1  # relative change of amplitude between neighbouring frequencies, from which on a jump is looked for


class SweepPoint(NamedTuple):
    """One frequency of a `Sweep`."""

    Omega: float
    A: float
    stops: int
    turns: int
    settled: bool


@dataclass(frozen=True, eq=False)
class Sweep(Table):
    """What a stepped sweep shows; arrays in the order of the frequencies.

    Omega   -- the frequencies
    A       -- largest |u| of the stable motion that is settled to; where none is, over the last turn of the forcing;
               where friction holds the mass, as at low frequencies of an excitation by inertia, how far off it rests;
               within a play, where no force brings the mean back, it is about the place that the sweep left it at
    stops   -- rests in one period of it, or in that turn
    turns   -- turns of the forcing followed before it was shown that the motion tends there
    settled -- whether it was, within the turns that are followed at most
    jumps   -- pairs (Omega before, Omega after) between which the motion left its branch
    message -- what to bear in mind; empty if there is nothing to say
    """

    entry: ClassVar[Any] = SweepPoint

    F_0: float
    Omega: Array
    A: Array
    stops: NDArray[np.int64]
    turns: NDArray[np.int64]
    settled: NDArray[np.bool_]
    jumps: tuple[tuple[float, float], ...]
    message: str = ""
    picture: ClassVar[str] = "sweep"

    def plot(self, ax: Any = None) -> Any:
        """Draw A over Omega into Matplotlib axes, or new ones, and return these; arrows where it jumps."""
        from slowflow import pictures

        return pictures.sweep(ax, self)


def sweep(
    system: EquationOfMotion,
    *,
    Omega: Sequence[float] | Array,
    F_0: float,
    most_turns: int = 2000,
    integrator: Integrator | None = None,
    u_0: float = 0.0,
    v_0: float = 0.0,
) -> Sweep:
    """Follows the motion from (u_0, v_0) through the frequencies, keeping state and phase of the forcing at each step.

    most_turns -- at one frequency

    At each frequency the motion is followed until it is shown to tend to a periodic one; from that one it goes on.
    A jump is a change of amplitude by more than 10 %, and more than three times what either neighbouring step shows.
    Raises ValueError for parameters out of range, or where the mass would never move, ArithmeticError where the motion
    escapes or chatters.
    """
    frequencies = np.array(Omega, dtype=float, order="C")
    if frequencies.ndim != 1 or frequencies.size == 0:
        raise Refused(f"Omega must be a non-empty list of frequencies, not an array of shape {frequencies.shape}")
    for frequency in frequencies:
        check_numbers(system, float(frequency), F_0)
    check_forcing(system, float(frequencies.max()), F_0, begins=(u_0, v_0))
    integrator, tries = integrator or default_integrator(system), lengths(system)
    A, rests, spent = np.empty(frequencies.size), np.empty(frequencies.size, int), np.empty(frequencies.size, int)
    settled, rested = (np.zeros(frequencies.size, bool) for _ in range(2))
    u, v, i = u_0, v_0, 0
    while i < frequencies.size:
        if isinstance(integrator, TaylorIntegrator):
            packed = np.array(tries, dtype=np.intc).tobytes()
            rows = integrator.sweep(system, frequencies[i : i + AT_ONCE], F_0, u, v, packed, most_turns)
            if len(rows):
                passed = slice(i, i + len(rows))
                A[passed], spent[passed], rests[passed] = rows[:, 2:].T
                settled[passed] = True
                u, v = rows[-1, :2].tolist()
                i += len(rows)
                continue
        with limited():
            forced = Forced(system, float(frequencies[i]), F_0, integrator)
            end = settle(forced, 0.0, u, v, tries, most_turns)
            if end.adrift is not None:
                end = calmed(forced, 0.0, end, most_turns)
        drifts = end.adrift is not None and end.turns < most_turns
        rested[i] = at_rest(end.phases)
        u, v, spent[i] = end.u, end.v, end.turns
        settled[i] = end.found is not None or end.repeats or rested[i] or drifts
        if end.found is None:
            A[i] = max(max(abs(phase.u), abs(phase.u_end)) for phase in end.phases)
            rests[i] = stops(end.phases)
        else:
            A[i], rests[i] = end.found.A, end.found.stops
        i += 1
    return Sweep(F_0, frequencies, A, rests, spent, settled, _jumps(frequencies, np.where(rested, np.nan, A)))


def _jumps(Omega: Array, A: Array) -> tuple[tuple[float, float], ...]:
    """NaN where the mass rests: to begin to move is no jump."""
    change = np.abs(np.diff(A))
    relative = change / np.maximum(A[1:], A[:-1])
    known = np.nan_to_num(change)
    beside = np.zeros(change.size)
    beside[1:] = known[:-1]
    beside[:-1] = np.maximum(beside[:-1], known[1:])
    found = np.flatnonzero((relative > JUMP) & (change > 3.0 * beside))
    return tuple((float(Omega[i]), float(Omega[i + 1])) for i in found if math.isfinite(relative[i]))
