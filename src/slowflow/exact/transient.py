"""Shocks: in go an oscillator at rest and the acceleration of its base over time, out comes what the mass does then.

Seen from the base the mass moves by (3) with minus the base's acceleration as its forcing. A half sine is an arc of a
cosine, which the integrator has as it is. Between samples of a record the acceleration is an arc of `ARC`, which
differs from a straight line by less than ARC^2/8 of the samples: one integrator serves all, and switches stay exact.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from slowflow.answer import Drawn
from slowflow.exact import compiled
from slowflow.exact.motion import TURN, Forced, Lost, Phase, follow
from slowflow.exact.work import limited
from slowflow.mechanism import EquationOfMotion
from slowflow.text import Sentence, text
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import CREEPS, MOST_TURNS, NEAR, POINTS, ROUNDS, SAME, Event
from slowflow_support.errors import NotSettled

Array = NDArray[np.float64]

NO_PULSE = text("a pulse needs either its duration, of a half sine, or {tau}, the times of a record")
#: angle between two samples of a record
ARC = 1e-3
#: share of load and forcing by which their balance may be off, and by which a motion begins behind its place of rest
ROUNDING, BACK = 2.0**-50, 2.0**-47
#: what the place of rest is off by may be this share of a pulse
WEAK = 2.0**-10
TOO_WEAK = Sentence(
    "a pulse of {acceleration:g} is too weak to be followed beside {u = :g}, where the mass rests: rounding of that "
    "place and of its load is {share:.2g} of it"
)
#: for how long the free motion is shown: ten periods of the mass on k_v alone
AFTER = 10 * TURN
#: where a motion is lost: why, when, and what drives it then
LOST = Sentence("{why:s}; at {tau = :.6g}, {when:s}")
ACCELERATED, FREE = "while the base is accelerated", "in the free motion"


class Arc(NamedTuple):
    """The base's acceleration over a stretch of tau: -F cos(theta + Omega tau), F >= 0."""

    span: float
    Omega: float
    F: float
    theta: float


class Stretch(NamedTuple):
    """A stretch of tau from `since` on under one arc, whose angle is `theta` there, in its phases."""

    since: float
    theta: float
    forced: Forced
    phases: list[Phase]

    def tau(self, theta: Any) -> Any:
        """The time at angles of the arc."""
        return self.since + (theta - self.theta) / self.forced.Omega


class Series(NamedTuple):
    """A motion over time: place and speed of the mass as seen from the base, accelerations of mass and base."""

    tau: Array
    u: Array
    v: Array
    a: Array
    base: Array


@dataclass(frozen=True, eq=False)
class Transient(Drawn):
    """What a mass does when its base is accelerated, or when it is let go. All dimensionless; accelerations in k_v L/m.

    A, tau_A      -- largest |u|, the deflection of the springs, under a load with that at rest, and when it is reached
    a_max, tau_a  -- largest acceleration of the mass, as seen by who stands still, and when
    u_cr          -- the stroke, None where the springs never touch, and of a force that is not odd
    detaches      -- whether the springs leave, |u| > u_cr, or u the piece about 0
    tau_detaches  -- when first, None if never
    rests         -- whether friction holds the mass at the end of what was followed, at u_end
    message       -- what to bear in mind
    stretches     -- the motion in its phases

    `series` gives the motion over time.
    """

    A: float
    tau_A: float
    a_max: float
    tau_a: float
    u_cr: float | None
    detaches: bool
    tau_detaches: float | None
    rests: bool
    u_end: float
    message: str
    stretches: tuple[Stretch, ...] = field(repr=False)
    picture: ClassVar[str] = "history"

    def series(self, samples: int = 400) -> Series:
        """The motion at `samples` equal steps from the pulse's beginning to the end of what was followed."""
        first, last = self.stretches[0], self.stretches[-1]
        tau = np.linspace(first.since, last.tau(last.phases[-1].end), samples)
        out = np.zeros((4, samples))
        begins = np.array([stretch.tau(phase.theta) for stretch, phase in self._phases()])
        which = np.clip(np.searchsorted(begins, tau, side="right") - 1, 0, None)
        for number, (stretch, phase) in enumerate(self._phases()):
            here = np.flatnonzero(which == number)
            if here.size:
                theta = stretch.theta + stretch.forced.Omega * (tau[here] - stretch.since)
                out[:, here] = _states(stretch.forced, phase, np.clip(theta, phase.theta, phase.end))
        return Series(tau, *out)

    def _phases(self) -> Iterator[tuple[Stretch, Phase]]:
        return ((stretch, phase) for stretch in self.stretches for phase in stretch.phases)


def half_sine(acceleration: Any, duration: Any) -> Array:
    """acceleration sin(pi tau/duration) up to the duration, as arcs: shape (..., 1, 4) of numbers that broadcast."""
    a, span = np.broadcast_arrays(np.asarray(acceleration, dtype=float), np.asarray(duration, dtype=float))
    columns = span, math.pi / span, np.abs(a), np.copysign(0.5 * math.pi, a)
    return np.stack(columns, axis=-1)[..., np.newaxis, :]


def record(tau: Array, acceleration: Array) -> Array:
    """The acceleration through samples, as arcs: shape (..., n - 1, 4) of those of shape (..., n), tau rising."""
    before, after = -acceleration[..., :-1], -acceleration[..., 1:]
    # F cos theta at both ends of the arc
    across = (before * math.cos(ARC) - after) / math.sin(ARC)
    spans = np.diff(tau)
    columns = (spans, ARC / spans, np.hypot(before, across), np.arctan2(across, before))
    return np.stack(np.broadcast_arrays(*columns), axis=-1)


@limited()
def transient(
    system: EquationOfMotion,
    arcs: Array,
    *,
    begin: float = 0.0,
    after: float = AFTER,
    at: float = 0.0,
    v: float = 0.0,
    rest: float | None = None,
) -> Transient:
    """The motion from u = `at` with the velocity v under the arcs, rows of `Arc`, and freely for `after` after them.

    rest -- where the mass rests without friction; `at` if it is not given

    It is followed until the mass has turned twice since, or friction holds it: a free motion only loses energy, so that
    A and a_max are the largest for all time. Raises ArithmeticError where the motion escapes a softening spring,
    chatters where the force jumps, or does not turn, and off the centre where a pulse is lost beside the load.
    """
    rest = at if rest is None else rest
    peak, off_by = float(arcs[:, 2].max(initial=0.0)), BACK * max(abs(at), abs(system.load))
    held = peak + off_by <= system.holds(system.force.region_of(at))
    if 0 < peak < off_by / WEAK and not held and at == rest and v == 0.0:
        raise NotSettled(TOO_WEAK.format(peak, at, off_by / peak))
    forced = replace(system, inertial=False)  # an acceleration is a force, whatever else the oscillator is excited by
    stretches = list(_followed(forced, arcs, begin, after, (at, v), rest))
    phases = [(stretch, phase) for stretch in stretches for phase in stretch.phases]
    last = phases[-1][1]
    # between switches u is monotone
    reached = [(abs(phase.u_end), stretch.tau(phase.end)) for stretch, phase in phases]
    if at != 0.0:
        reached.insert(0, (abs(at), begin))
    A = max(spot for spot, _ in reached)
    tau_A = next(tau for spot, tau in reached if spot >= A * SAME)
    innermost = system.force.innermost
    off = next((stretch.tau(phase.theta) for stretch, phase in phases if abs(phase.region) > innermost), None)
    a_max, tau_a = _largest_acceleration(phases)
    u_cr = next(iter(system.force.breakpoints[innermost:]), None) if system.force.odd else None
    rests, stated = last.slip == 0, tuple(stretches)
    return Transient(A, tau_A, a_max, tau_a, u_cr, off is not None, off, rests, last.u_end, "", stated)


def _followed(
    system: EquationOfMotion,
    arcs: Array,
    tau: float,
    after: float,
    begins: tuple[float, float],
    rest: float,
) -> Iterator[Stretch]:
    (u, v), A = begins, 0.0
    for arc in map(Arc._make, arcs.tolist()):
        stretch = _under(Forced(system, arc.Omega, arc.F), tau, arc, u, v)
        u, v = stretch.phases[-1].u_end, stretch.phases[-1].v_end
        tau += arc.span
        A = max(A, *(abs(phase.u_end - rest) for phase in stretch.phases))
        yield stretch
    over, turned = tau + after, 0
    for _ in range(MOST_TURNS):
        free = Arc(max(over - tau, TURN), 1.0, 0.0, 0.0)
        stretch = _under(Forced(system, free.Omega, free.F), tau, free, u, v)
        u, v = stretch.phases[-1].u_end, stretch.phases[-1].v_end
        tau += free.span
        yield stretch
        turned += sum(phase.event == Event.STOP for phase in stretch.phases)
        A = max(A, *(abs(phase.u_end - rest) for phase in stretch.phases))
        # a mass that is damped much creeps back, and turns once at most: until it does not move, or has come back
        off = abs(u - rest)
        creeps = abs(v) <= off * CREEPS or max(off, abs(v)) <= A * CREEPS + BACK * abs(rest)
        if tau >= over and (turned >= 2 or stretch.phases[-1].slip == 0 or creeps):
            return
    raise NotSettled(f"within {MOST_TURNS} turns after the pulse the mass does not turn twice, and does not rest")


def _under(forced: Forced, tau: float, arc: Arc, u: float, v: float) -> Stretch:
    """The motion from (u, v) on under one arc."""
    end, system = arc.theta + arc.Omega * arc.span, forced.system
    region = system.force.region_of(u)
    push, holds = abs(forced.push(region, arc.theta, u)), system.holds(region)
    # at rest the spring holds the load but for a rounding, which tells nothing of where the mass goes
    doubt = ROUNDING * (abs(system.load) + arc.F) if system.load != 0.0 else 0.0
    balanced = v == 0.0 and push <= max(holds, doubt)
    if arc.F == 0.0 and balanced:
        rest = Phase(0, region, arc.theta, u, 0.0, end, u, 0.0, Event.TIME)
        return Stretch(tau, arc.theta, forced, [rest])
    if balanced and holds < doubt:  # some roundings back from where F cos(theta) begins to push, so that it goes there
        u += math.copysign(BACK, math.sin(arc.theta)) * max(abs(u), abs(system.load), arc.F)
    try:
        return Stretch(tau, arc.theta, forced, follow(forced, arc.theta, u, v, end))
    except Lost as lost:  # of the arc, whose frequency and force are none that anybody gave, it says the time
        at = tau + (lost.theta - arc.theta) / arc.Omega
        raise NotSettled(LOST.format(lost.why, at, ACCELERATED if arc.F else FREE)) from None


def _states(forced: Forced, phase: Phase, theta: Array) -> Array:
    """u, v, acceleration of the mass and of the base at angles within a phase that do not fall: shape (4, n)."""
    base = -forced.F_0 * np.cos(theta)
    if phase.slip == 0:
        return np.array([np.full(theta.size, phase.u), np.zeros(theta.size), base, base])
    drive, piece = forced.drive(phase.slip, phase.region), forced.piece(phase.region)
    u, v = compiled.sample(forced.system, phase.region, drive, phase.theta, phase.u, phase.v, theta).T
    # seen by who stands still the forcing is no force
    a = motion.acceleration(0.0, v, drive.F_0, drive.zeta, drive.resistance(v), piece(u))
    return np.array([u, v, a, base])


def _largest_acceleration(phases: list[tuple[Stretch, Phase]]) -> tuple[float, float]:
    """The largest |a| and its time: looked for at points of each phase, then ever nearer to the largest of these."""
    found = []
    for stretch, phase in phases:
        theta = np.linspace(phase.theta, phase.end, POINTS)
        a = np.abs(_states(stretch.forced, phase, theta)[2])
        found.append((float(a.max()), stretch, phase, theta, int(a.argmax())))
    most = max(one[0] for one in found)
    largest, at = 0.0, 0.0
    for value, stretch, phase, theta, k in found:
        if value < NEAR * most:
            continue
        for _ in range(ROUNDS):
            theta = np.linspace(theta[max(k - 1, 0)], theta[min(k + 1, theta.size - 1)], 2 * POINTS)
            a = np.abs(_states(stretch.forced, phase, theta)[2])
            k = int(a.argmax())
        if a[k] * SAME > largest:
            largest, at = float(a[k]), float(stretch.tau(theta[k]))
    return largest, at
