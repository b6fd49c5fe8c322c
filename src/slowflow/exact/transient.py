"""Shock response: the motion under an acceleration of the base over time.

Relative to the base the mass moves by (3) with minus the base's acceleration as its forcing. A half sine is an arc of a
cosine, the integrator's own forcing. Between samples of a record the acceleration is an arc of `ARC`, which differs
from a straight line by less than ARC^2/8 of the samples: one integrator serves all, and switches stay exact.
"""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, NamedTuple

import numpy as np

from slowflow.answers.answer import Drawn, Table
from slowflow.core import validate
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import EquationOfMotion, Flags, Floats
from slowflow.exact.motion import MOST_STEPS, MOST_WORK, TURN, Forced, Phase, handle, limited, lost, sample, spend
from slowflow.support.errors import NotSettled
from slowflow.support.text import Sentence, text
from slowflow_kernels.exact_conventions import BACK, MOST_TURNS, Outcome

NO_PULSE = text("a pulse needs either its duration, of a half sine, or {tau}, the times of a record")
#: angle between two samples of a record
ARC = 1e-3
#: largest rounding error of the equilibrium, relative to the pulse
WEAK = 2.0**-10
TOO_WEAK = Sentence(
    "a pulse of {acceleration:g} is too weak compared with the equilibrium {u = :g}: rounding errors of the "
    "equilibrium and of its load are {share:.2g} of it"
)
#: for how long the free motion is shown: ten periods of the mass on k_v alone
AFTER = 10 * TURN
#: where a motion is lost: why, when, and what drives it then
LOST = Sentence("{why:s}; at {tau = :.6g}, {when:s}")
ACCELERATED, FREE = "while the base is accelerated", "in the free motion"


#: a phase as C has it: when its arc begins, the arc, the phase
STRETCH = struct.Struct("@d4diiddddddi?dl")


class Arc(NamedTuple):
    """The base's acceleration over a stretch of tau: -F cos(theta + Omega tau), F >= 0."""

    span: float
    Omega: float
    F: float
    theta: float


class Stretch(NamedTuple):
    """A phase of the motion, and the arc that it is under, which begins at tau = since."""

    since: float
    arc: Arc
    phase: Phase

    def tau(self, theta: Any) -> Any:
        """The time at angles of the arc."""
        return self.since + (theta - self.arc.theta) / self.arc.Omega


class Series(NamedTuple):
    """A motion over time: displacement and velocity relative to the base, absolute accelerations of mass and base."""

    tau: Floats
    u: Floats
    v: Floats
    a: Floats
    base: Floats


@dataclass(frozen=True, eq=False)
class Transient(Drawn):
    """Response to an acceleration of the base, or free motion. All dimensionless; accelerations over k_v L/m.

    A, tau_A      -- largest |u|, the deflection of the springs, static deflection included, and its time
    a_max, tau_a  -- largest absolute acceleration of the mass, and its time
    u_cr          -- the stroke; None if the springs never touch, and for a force that is not odd
    detaches      -- whether the springs detach, |u| > u_cr, or for an asymmetric force u leaves the piece about 0
    tau_detaches  -- time of the first detachment, None if never
    rests         -- whether friction holds the mass at the end of the computed motion, at u_end
    message       -- diagnostics as text
    stretches     -- the phases of the motion

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
    system: EquationOfMotion = field(repr=False)
    picture: ClassVar[str] = "history"

    def series(self, samples: int = 400) -> Series:
        """The motion at `samples` equal steps from the beginning of the pulse to the end of the computed motion."""
        samples = validate.count("samples", samples, least=1, most=validate.MOST_SAMPLES)
        first, last = self.stretches[0], self.stretches[-1]
        tau = np.linspace(first.since, last.tau(last.phase.end), samples)
        out = np.zeros((4, samples))
        begins = np.array([one.tau(one.phase.theta) for one in self.stretches])
        which = np.clip(np.searchsorted(begins, tau, side="right") - 1, 0, None)
        for number, (since, arc, phase) in enumerate(self.stretches):
            here = np.flatnonzero(which == number)
            if here.size:
                theta = np.clip(arc.theta + arc.Omega * (tau[here] - since), phase.theta, phase.end)
                out[:3, here] = sample(Forced(self.system, arc.Omega, arc.F), phase, theta).T
                out[3, here] = -arc.F * np.cos(theta)
        return Series(tau, *out)


def half_sine(acceleration: Any, duration: Any) -> Floats:
    """Make a half sine, acceleration sin(pi tau/duration) for 0 <= tau <= duration, as arcs, shape (..., 1, 4).

    An arc is a row (span, Omega, F, theta), the acceleration -F cos(theta + Omega tau) for 0 <= tau <= span.
    """
    a, span = np.broadcast_arrays(np.asarray(acceleration, dtype=float), np.asarray(duration, dtype=float))
    columns = span, math.pi / span, np.abs(a), np.copysign(0.5 * math.pi, a)
    return np.stack(columns, axis=-1)[..., np.newaxis, :]


def record(tau: Floats, acceleration: Floats) -> Floats:
    """Interpolate an acceleration sampled at ascending tau, shape (..., n), by arcs of `half_sine`, (..., n - 1, 4)."""
    before, after = -acceleration[..., :-1], -acceleration[..., 1:]
    # F cos theta at both ends of the arc
    quadrature = (before * math.cos(ARC) - after) / math.sin(ARC)
    spans = np.diff(tau)
    columns = (spans, ARC / spans, np.hypot(before, quadrature), np.arctan2(quadrature, before))
    return np.stack(np.broadcast_arrays(*columns), axis=-1)


@limited()
def transient(
    system: EquationOfMotion,
    arcs: Floats,
    *,
    begin: float = 0.0,
    after: float = AFTER,
    at: float = 0.0,
    v: float = 0.0,
    rest: float | None = None,
) -> Transient:
    """Integrate the motion from u = `at` with velocity v under arcs, as of `half_sine`, and free motion afterwards.

    begin -- tau at which the arcs begin
    after -- duration of the free motion; it is prolonged until the mass has reversed twice or friction holds it. As the
             mass only loses energy, A and a_max are then the largest for all time
    rest  -- equilibrium without friction, by default `at`

    Raises ArithmeticError if the motion escapes a softening spring, chatters where the force jumps, or does not
    reverse, and if a pulse is too weak compared with the load.
    """
    rest = at if rest is None else rest
    peak, rounding = float(arcs[:, 2].max(initial=0.0)), BACK * max(abs(at), abs(system.load))
    sticks = peak + rounding <= system.holds(system.force.region_of(at))
    if 0 < peak < rounding / WEAK and not sticks and at == rest and v == 0.0:
        raise NotSettled(TOO_WEAK.format(peak, at, rounding / peak))
    system = replace(system, inertial=False)  # an acceleration is a force, whatever else the oscillator is excited by
    arguments = np.ascontiguousarray(arcs), begin, after, at, v, rest, MOST_STEPS, MOST_WORK
    outcome, steps, numbers, packed = EXACT.shock(handle(system), *arguments)
    spend(steps)
    if outcome == Outcome.DIVERGES:
        raise NotSettled(
            f"within {MOST_TURNS} periods after the pulse the mass neither reverses twice nor comes to rest"
        )
    if outcome:  # the message has the time: an arc's frequency and force are not the user's
        tau, u, F = numbers
        raise NotSettled(LOST.format(lost(outcome, system, u), tau, ACCELERATED if F else FREE))
    A, tau_A, a_max, tau_a, left, rests, u_end = numbers
    off = not math.isnan(left)
    u_cr = system.force.first_end if system.force.odd else None
    stretches = tuple(Stretch(since, Arc(*by[:4]), Phase(*by[4:14])) for since, *by in STRETCH.iter_unpack(packed))
    return Transient(A, tau_A, a_max, tau_a, u_cr, off, left if off else None, rests == 1, u_end, "", stretches, system)


@dataclass(frozen=True, eq=False)
class ShockSpectrum(Drawn, Table, entry="Shock"):
    """Shock response spectrum of half sines of the base, pulse by pulse.

    acceleration, duration -- of the pulse, over k_v L/m and in tau
    A        -- the largest deflection of the springs, during or after the pulse, static deflection included
    a_max    -- the largest acceleration of the mass
    ratio    -- a_max over the peak of the pulse
    detaches -- whether the springs detach
    message  -- diagnostics as text
    """

    acceleration: Floats
    duration: Floats
    A: Floats
    a_max: Floats
    ratio: Floats
    detaches: Flags
    message: str
    picture: ClassVar[str] = "shocks"


def shock_spectrum(system: EquationOfMotion, acceleration: Floats, duration: Floats, at: float = 0.0) -> ShockSpectrum:
    """The spectrum pulse by pulse, from rest at u = `at`; shapes (n,)."""
    found = [transient(system, arcs, after=0.0, at=at) for arcs in half_sine(acceleration, duration)]
    A, a_max, detaches = (np.array([getattr(one, name) for one in found]) for name in ("A", "a_max", "detaches"))
    return ShockSpectrum(acceleration, duration, A, a_max, a_max / acceleration, detaches.astype(np.bool_), "")
