"""The equations of a periodic motion with fixed order of switches, and their Jacobian; Floquet multipliers.

A cycle starts when the mass begins to slip downwards, at (theta_0, u_0) with v = 0, and ends n half turns of the
forcing later in (-1)^n times the same state; n = 1 holds for the half-wave symmetric motions, n = 2 for any motion with
the forcing's period. Unknown are u_0, theta_0, the span of every phase, and the frequency. Each phase is integrated
over its span without looking for events; that its end is the switch is an equation. So everything stays smooth where a
phase appears or vanishes: its span passes through zero there, while the monodromy matrix itself is singular.
"""

from __future__ import annotations

import cmath
import functools
import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from slowflow.core.backend import EXACT
from slowflow.core.mechanism import EquationOfMotion, Floats
from slowflow.exact.motion import Forced, Phase, advance, edge_ahead, follow, handle, signature, spend, steps_left
from slowflow.support.errors import NotSettled
from slowflow.support.text import text
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import MOST_NEWTON, ON_TIME, OVER_END, TOLERANCE, ExtraKind

Signature = tuple[tuple[int, int], ...]
#: phase that has to follow a cycle by which a motion shows it
WHOLE = 0.3


class Border(NamedTuple):
    """A margin that is positive while no phase has to be inserted at a turning point, and its gradient, as a row.

    phase    -- index of the phase that ends there
    sticking -- False: distance of the turning point from the breakpoint ahead; True: excess of the force over friction
    """

    phase: int
    sticking: bool
    margin: float
    gradient: Floats


class Equations(NamedTuple):
    """residual (k+2), jacobian (k+2, k+4): columns u_0, theta_0, k spans, Omega, F_0; monodromy over the cycle (2, 2).

    A is the largest |u| at a switch, of_A its derivatives by the same unknowns; borders lists the margins within which
    the order of switches holds. `direction`, after Newton's iteration with one more equation: the change of the
    unknowns that keeps all others and raises the value of that one at rate 1, shape (k+3,).
    """

    residual: Floats
    jacobian: Floats
    monodromy: Floats
    A: float
    of_A: Floats
    borders: tuple[Border, ...]
    direction: Floats | None = None


@dataclass(frozen=True)
class Cycle:
    """A periodic motion's order of switches; the unknowns z are (u_0, theta_0, spans..., Omega)."""

    system: EquationOfMotion
    signature: Signature
    half_turns: int

    @property
    def sign(self) -> int:
        """The factor of the state after the cycle."""
        return -1 if self.half_turns % 2 else 1

    @property
    def sticks(self) -> bool:
        """Whether the mass stays at rest all the time."""
        return len(self.signature) == 1 and self.starts_sticking

    @property
    def starts_sticking(self) -> bool:
        """Whether the mass breaks away at the start of the cycle, rather than turns round."""
        return self.signature[-1][0] == 0

    def equations(self, z: Floats, F_0: float) -> Equations:
        """Residual and derivatives at z, and the monodromy matrix with saltation at every switch.

        The monodromy matrix takes a deviation of (u, v) at the start, times `sign`, to one after the cycle; the start's
        own switch is counted at the end.
        """
        found = self.newton(z, F_0, most=0)
        if found is None:
            raise NotSettled(text("the cycle at {Omega = :} cannot be integrated", z[-1]))
        return found[1]

    @functools.cached_property
    def order(self) -> Signature:
        """The signature over a period, turned so that it does not depend on where the cycle starts."""
        phases = list(self.signature)
        if self.sign == -1:
            phases += [(-slip, -region) for slip, region in self.signature]
        return tuple(min(phases[i:] + phases[:i] for i in range(len(phases))))

    @functools.cached_property
    def consistent(self) -> bool:
        """Whether every phase begins in the region where the one before it ended."""
        first = (self.sign * self.signature[0][0], self.sign * self.signature[0][1])
        successors = [*self.signature[1:], first]
        return all(
            after[1] == region or (slip != 0 and after == (slip, self.system.force.beyond(slip, region)))
            for (slip, region), after in zip(self.signature, successors, strict=True)
        )

    def highest(self, z: Floats, F_0: float) -> int:
        """Index of the phase that starts from the farthest turning point or stop at which a cycle can start."""
        best, farthest = abs(float(z[0])), 0
        starts = []
        for i, (before, (slip, region)) in enumerate(pairwise(self.signature), 1):
            if slip == 0 or before == (slip, region) or before[1] != region or (slip == 1 and self.sign == 1):
                continue
            starts.append(i)
        # no phase is followed that none of these comes after
        ends = list(itertools.islice(self._ends(z, F_0), max(starts, default=0)))
        for i in starts:
            u = abs(ends[i - 1][1])
            if u > best * (1.0 + 1e-9):
                best, farthest = u, i
        return farthest

    def restart(self, z: Floats, F_0: float, phase: int) -> tuple[Cycle, Floats]:
        """The same motion as a cycle that starts with that phase, mirrored if the phase slips upwards."""
        if phase == 0:
            return self, z
        theta, u = self._end(z, F_0, phase - 1)
        image = [(self.sign * slip, self.sign * region) for slip, region in self.signature[:phase]]
        phases = [*self.signature[phase:], *image]
        spans = np.roll(z[2:-1], -phase)
        if phases[0][0] == 1:
            phases = [(-slip, -region) for slip, region in phases]
            theta, u = theta + math.pi * self.half_turns, -u
        return replace(self, signature=tuple(phases)), np.array([u, theta, *spans, z[-1]])

    def with_excursion(self, z: Floats, F_0: float, phase: int) -> tuple[Cycle, Floats] | None:
        """The cycle with an excursion beyond the breakpoint inserted where a phase turns, and trial unknowns.

        None where the mass would be accelerated outwards there, or sticks.
        """
        forced = Forced(self.system, float(z[-1]), F_0)
        phases, spans = list(self.signature), z[2:-1].tolist()
        slip, region = phases[phase]
        after = (phase + 1) % len(phases)
        if phases[after][0] == 0:
            return None
        theta, u = self._end(z, F_0, phase)
        excess = max(slip * (u - edge_ahead(self.system, slip, region)), 0.0)
        # constant deceleration on the way out, constant acceleration on the way back
        other = self.system.force.beyond(slip, region)
        decelerations = [-slip * forced.acceleration(s, other, theta, u) for s in (slip, -slip)]
        if min(decelerations) <= 0.0:
            return None
        out, back = (float(motion.out(excess, a)) * forced.Omega for a in decelerations)
        spans[phase] -= out
        spans[after] -= back
        if after == 0:  # the cycle begins on the way back
            phases = [(-self.sign * slip, self.sign * other), *phases, (slip, other)]
            spans = [back, *spans, out]
        else:
            phases[after:after], spans[after:after] = [(slip, other), (-slip, other)], [out, back]
        return replace(self, signature=tuple(phases)), np.array([z[0], z[1], *spans, z[-1]])

    def _end(self, z: Floats, F_0: float, phase: int) -> tuple[float, float]:
        """theta and u at the end of a phase, integrated over the spans."""
        return next(itertools.islice(self._ends(z, F_0), phase, None))

    def _ends(self, z: Floats, F_0: float) -> Iterator[tuple[float, float]]:
        """theta and u at the end of each phase, one after the other."""
        forced = Forced(self.system, float(z[-1]), F_0)
        theta, u, v = float(z[1]), float(z[0]), 0.0
        for (slip, region), span in zip(self.signature, z[2:-1].tolist(), strict=True):
            end = theta + span
            if slip != 0:
                u, v, _ = advance(forced, slip, region, theta, u, v, end)
            theta = end
            yield theta, u

    def phases(self, z: Floats, F_0: float) -> list[Phase]:
        """The motion that really starts at z's (theta_0, u_0), one phase beyond what the signature lists."""
        forced = Forced(self.system, float(z[-1]), F_0)
        start = self.signature[0] if self.starts_sticking else None
        theta = float(z[1])
        end = theta + math.pi * self.half_turns
        # the last switch falls on the end of the cycle, up to rounding: a little longer, to have it counted
        return follow(forced, theta, float(z[0]), 0.0, end + OVER_END, start)[: len(self.signature) + 1]

    def holds(self, z: Floats, F_0: float) -> bool:
        """Whether the motion from z's start really switches in the order of the signature."""
        return self.verified_phases(z, F_0) is not None

    def verified_phases(self, z: Floats, F_0: float) -> list[Phase] | None:
        """The phases of the motion from z's start, if it switches in the order of the signature; None if not."""
        spans = z[2:-1].tolist()
        if not self.consistent or min(spans) <= 0.0:
            return None
        try:
            found = self.phases(z, F_0)[: len(spans)]
        except ArithmeticError:
            return None
        if signature(found) != self.signature:
            return None
        # every switch at its time: the equations may also be solved with a slip whose velocity passes zero twice
        end = float(z[1])
        for phase, span in zip(found, spans, strict=True):
            end += span
            if not abs(phase.end - end) < ON_TIME:
                return None
        return found

    def newton(
        self,
        z: Floats,
        F_0: float,
        row: Floats | None = None,
        value: float = 0.0,
        *,
        border: int | None = None,
        most: int = MOST_NEWTON,
        tolerance: float = TOLERANCE,
    ) -> tuple[Floats, Equations] | None:
        """Newton's iteration; None where it does not converge or integration fails.

        Omega is kept unless there is one more equation: row @ z = value, or that the margin of a border vanishes.
        """
        z = np.array(z)
        k = len(self.signature)
        n = k + 4
        numbers, direction = np.empty((k + 2) * (k + 5) + (2 * k + 1) * n), np.zeros(z.size)
        kind = ExtraKind.ROW if row is not None else ExtraKind.NO_MORE if border is None else ExtraKind.BORDER
        more = kind, z if row is None else np.ascontiguousarray(row), value, border or 0
        system, steps = handle(self.system), steps_left()
        outcome, used, A, monodromy, borders = EXACT.newton(
            system, self.packed, self.half_turns, z, F_0, *more, most, tolerance, steps, numbers, direction
        )
        spend(used)
        if outcome:
            return None
        ends = np.cumsum((k + 2, (k + 2) * n, n, 2 * k * n))
        residual, jacobian, of_A, gradients = (numbers[a:b] for a, b in pairwise((0, *ends)))
        borders_at = tuple(
            Border(phase, bool(sticking), margin, gradients[i * n : (i + 1) * n])
            for i, (phase, sticking, margin) in enumerate(borders)
        )
        jacobian, monodromy = jacobian.reshape(k + 2, n), np.array(monodromy).reshape(2, 2)
        return z, Equations(residual, jacobian, monodromy, A, of_A, borders_at, direction if kind else None)

    @functools.cached_property
    def packed(self) -> bytes:
        """The signature as C takes it."""
        return np.array(self.signature, dtype=np.intc).tobytes()

    def multipliers(self, monodromy: Floats) -> NDArray[np.complex128]:
        """Floquet multipliers over the cycle of `half_turns`: their squares hold for a period if `sign` is -1."""
        a, b, c, d = monodromy.ravel().tolist()
        half_trace, determinant = 0.5 * (a + d), a * d - b * c
        root = cmath.sqrt((0.5 * (a - d)) ** 2 + b * c)
        # the larger first: the smaller one would be a difference
        larger = half_trace + (root if half_trace >= 0.0 else -root) if root.imag == 0.0 else half_trace + root
        smaller = half_trace - root if root.imag != 0.0 else determinant / larger if larger != 0 else 0.0
        return np.array((larger, smaller), dtype=np.complex128)

    @property
    def stops(self) -> int:
        """Rests in one period of the motion."""
        return sum(slip == 0 for slip, _ in self.signature) * (2 if self.sign == -1 else 1)


def sticks_at_jump(system: EquationOfMotion, phases: list[Phase]) -> bool:
    """Whether the mass sticks at u = 0, where the force jumps."""
    return system.force.jump != 0.0 and any(phase.slip == phase.region == 0 for phase in phases)


def required_half_turns(half_turns: int) -> int:
    """Half turns of a motion that contain a cycle of that length, wherever it begins.

    A period may have only one downward slip; it is two cycles if the second one mirrors the first.
    """
    return (3 if half_turns % 2 else 2) * half_turns + 1


def closed_cycle(forced: Forced, half_turns: int, phases: list[Phase]) -> tuple[Cycle, Floats] | None:
    """The cycle and trial unknowns that a followed motion suggests: from its highest beginning of a downward slip.

    `phases` must span `required_half_turns(half_turns)`, or half_turns + 2 from such a slip on; None where no downward
    slip is followed by its image, or the mass sticks where the force jumps, after passing that point ever more often.
    """
    span = math.pi * half_turns
    sign = -1 if half_turns % 2 else 1
    starts = [
        i
        for i, phase in enumerate(phases)
        if phase.slip == -1 and phase.v == 0.0 and phase.theta + span < phases[-1].end - WHOLE
    ]
    if not starts:
        return None
    first = max(starts, key=lambda i: phases[i].u)
    theta = phases[first].theta
    images = [i for i, phase in enumerate(phases) if i > first and phase.slip == -sign and phase.v == 0.0]
    if not images:
        return None
    last = min(images, key=lambda i: abs(phases[i].theta - theta - span))
    cycle_phases = phases[first:last]
    if sticks_at_jump(forced.system, cycle_phases):
        return None
    spans = [phase.end - phase.theta for phase in cycle_phases]
    z = np.array([phases[first].u, theta % (2.0 * math.pi), *spans, forced.Omega])
    return Cycle(forced.system, signature(cycle_phases), half_turns), z
