"""Motion from switch to switch: slip in one direction over one piece of the force, or rest.

In:  an oscillator, the forcing, a state at rest or in motion.
Out: its phases in order, each with its start, its end and what ended it.

Switches, all exact: the velocity reaches zero; |u| reaches a breakpoint; at rest |force cos theta - f(u)| <= mu holds
the mass, or mu_s in its place if that is more, and it breaks away when that bound is met, at an angle known in closed
form. theta = Omega tau; v = du/dtau.
"""

from __future__ import annotations

import functools
import math
from typing import NamedTuple

import numpy as np

from slowflow.exact.compiled import TaylorIntegrator
from slowflow.exact.integrate import PHASE_WORK, Drive, Integrator, Stalled, spend
from slowflow.mechanism import EquationOfMotion, Piece
from slowflow.text import Sentence
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import FAR, GRAZING, MOST_PHASES, OF_TURN, Event, Outcome
from slowflow_support.errors import NotSettled

TURN = 2.0 * math.pi
NUDGES = (1e-3, 1e-4, 1e-5, 1e-6)  # angles over which a start at rest moves off before stops are looked for

CHATTERS = Sentence(
    "the mass chatters near {u = :.6g}, where the restoring force jumps: more than {most:d} switches in one turn"
)
ESCAPES = Sentence("the motion escapes: |{u}| passes {u:g}, the restoring force does not hold it")
STALLS = Sentence(
    "the integration stalls near {u = :.6g}: its steps become too many, or the force is not defined there"
)
UNBOUNDED = Sentence("the integration stalls near {u = :.6g}, where the restoring force grows without bound")
AT = Sentence("{why:s}; at {Omega = :}, {F_0 = :}")
#: a force that has no bound near u is larger there, by this factor, than at `NEARER` u
GROWS, NEARER = 1e6, 0.9


class Lost(NotSettled):
    """A motion that is not followed further: why, in words without what drives it, and at which angle of that."""

    why: str
    theta: float


class Phase(NamedTuple):
    """A stretch of smooth motion.

    slip      -- sign of the velocity, 0 at rest
    region    -- index of the piece, signed like u
    undecided -- the velocity comes so near to zero on the way that rounding hides whether it gets there; only the
                 compiled integrator can tell
    """

    slip: int
    region: int
    theta: float
    u: float
    v: float
    end: float
    u_end: float
    v_end: float
    event: int
    undecided: bool = False


_phase = functools.partial(tuple.__new__, Phase)  # of as many fields as C has: `_make` would count them each time


class Forced(NamedTuple):
    """An oscillator under the force of an excitation F_0 times cos(Omega tau), with the integrator to be used."""

    system: EquationOfMotion
    Omega: float
    F_0: float
    integrator: Integrator

    @property
    def force(self) -> float:
        """Amplitude of the force."""
        return self.system.forcing(Omega=self.Omega, F_0=self.F_0)

    def piece(self, region: int) -> Piece:
        """The piece of the force in that region."""
        return self.system.force.piece(region)

    def drive(self, slip: int, region: int) -> Drive:
        """The constants of a slip phase in that region."""
        system = self.system
        friction = slip * system.friction(region) - system.load
        zeta, by_Omega = system.damping(self.Omega)
        return Drive(self.Omega, self.force, zeta, friction, slip * system.c_2, by_Omega)

    def push(self, region: int, theta: float, u: float) -> float:
        """The force less f(u): what friction has to hold at rest."""
        return float(motion.push(math.cos(theta), self.force, self.piece(region).value(u) - self.system.load))

    def push_slopes(self, region: int, theta: float, u: float) -> tuple[float, float, float]:
        """Derivatives of the push by theta, u, and the amplitude of the force."""
        by_theta, by_u, by_force = motion.push_slopes(
            math.cos(theta), math.sin(theta), self.force, self.piece(region).slope(u)
        )
        return by_theta, by_u, by_force

    def acceleration(self, slip: int, region: int, theta: float, u: float, v: float) -> float:
        """u'' in a slip phase."""
        drive = self.drive(slip, region)
        resists, _ = drive.resistance(v)
        return float(
            motion.acceleration(math.cos(theta), v, drive.F_0, drive.zeta, resists, self.piece(region).value(u))
        )


def edge_ahead(system: EquationOfMotion, slip: int, region: int) -> float:
    """The breakpoint towards which a mass in that region slips, with its sign; slip * FAR if there is none."""
    edge = system.force.edge_ahead(slip, region)
    return slip * FAR if edge is None else edge


def break_away(forced: Forced, region: int, theta: float, u: float) -> tuple[float, int]:
    """When and in which direction a mass at rest at u moves off, at or after theta; (inf, 0) if never."""
    holds, amplitude = forced.system.holds(region), forced.force
    force = forced.piece(region).value(u) - forced.system.load
    found = (math.inf, 0)
    for slip in (1, -1) if amplitude > 0 else ():
        cosine = motion.breakaway(amplitude, slip * holds, force)
        if abs(cosine) < 1.0:
            # cos theta rises through it for slip = 1 and falls for slip = -1
            angle = -slip * math.acos(cosine)
            at = angle + TURN * math.ceil((theta - angle) / TURN - OF_TURN)
            found = min(found, (max(at, theta), slip))
    return found


def after_stop(forced: Forced, slip: int, region: int, theta: float, u: float) -> int:
    """What follows a stop reached in direction `slip`: the next direction, 0 if friction holds the mass."""
    push, holds = forced.push(region, theta, u), forced.system.holds(region)
    if holds > 0 and abs(push) <= holds:
        return 0
    return -slip if slip else (1 if push > 0 else -1)


def follow(
    forced: Forced, theta: float, u: float, v: float, end: float, start: tuple[int, int] | None = None
) -> list[Phase]:
    """All phases from (theta, u, v) to `end`; `start` = (slip, region) overrides the state, e.g. at break-away.

    Raises `Lost` if switches accumulate (the mass chatters at a jump of the force), the motion escapes, or comes to
    where the integration stalls.
    """
    if not isinstance(forced.integrator, TaylorIntegrator):
        try:
            return _from_switch_to_switch(forced, theta, u, v, end, start)
        except Stalled as stalled:
            raise _lost(Outcome.STALLS, forced, stalled.theta, stalled.u) from None
    outcome, rows = forced.integrator.follow(forced.system, forced.Omega, forced.F_0, (theta, u, v), end, start)
    phases = list(map(_phase, rows))
    if outcome:
        last = phases[-1] if phases else None  # which ends where the motion is lost
        raise _lost(outcome, forced, *((theta, u) if last is None else (last.end, last.u_end)))
    return phases


def _from_switch_to_switch(
    forced: Forced, theta: float, u: float, v: float, end: float, start: tuple[int, int] | None
) -> list[Phase]:
    """`follow`, without the compiled integrator. Raises `Stalled` where the integration does."""
    system, integrator = forced.system, forced.integrator
    if start is not None:
        slip, region = start
    else:
        region = system.force.region_of(u)
        slip = (1 if v > 0 else -1) if v != 0 else after_stop(forced, 0, region, theta, u)
        if slip != 0 and u == edge_ahead(system, slip, region):
            region += slip
    phases: list[Phase] = []
    most = MOST_PHASES * (1 + math.ceil((end - theta) / TURN))
    while theta < end:
        if len(phases) >= most:
            raise _lost(Outcome.CHATTERS, forced, theta, u)
        if slip == 0:
            at, slip = break_away(forced, region, theta, u)
            theta = _rest(phases, region, theta, u, min(at, end), end)
            continue
        edge = edge_ahead(system, slip, region)
        if slip * u >= FAR:
            raise _lost(Outcome.ESCAPES, forced, theta, u)
        if slip * (u - edge) >= 0.0:  # turned round within rounding of a breakpoint
            region += slip
            continue
        spend(PHASE_WORK)
        piece, drive = forced.piece(region), forced.drive(slip, region)
        from_theta, from_u, from_v = theta, u, v
        if v == 0.0:
            moved = _move_off(integrator, piece, drive, slip, edge, theta, u, end)
            if moved is None and system.holds(region) > 0:
                # the push exceeds friction by too little and for too short a time to be told from rounding
                region = 0 if u == 0.0 and system.force.jump != 0.0 else region
                at, slip = break_away(forced, region, theta + NUDGES[-1], u)
                theta = _rest(phases, region, theta, u, min(at, end), end)
                continue
            theta, u, v = moved or (theta, u, v)
        if theta < end:
            theta, u, v, event = integrator.until(piece, drive, slip, edge, theta, u, v, end)
        else:
            event = Event.TIME
        if event == Event.STOP:
            v = 0.0
        elif event == Event.EDGE:
            u = edge
            beyond = system.force.beyond(slip, region)
            if abs(v) < GRAZING and slip * forced.acceleration(slip, beyond, theta, u, v) < 0.0:
                v, event = 0.0, Event.STOP
        phases.append(Phase(slip, region, from_theta, from_u, from_v, theta, u, v, event))
        if event == Event.STOP and u == 0.0 and system.force.jump != 0.0:
            region = 0
        if event == Event.STOP:
            slip = after_stop(forced, slip, region, theta, u)
        elif event == Event.EDGE:
            region += slip
    return phases


def _lost(outcome: int, forced: Forced, theta: float, u: float) -> Exception:
    """In words why a motion is given up at an angle, and at u."""
    if outcome == Outcome.NO_MEMORY:
        return MemoryError("no memory for the phases of the motion")
    if outcome == Outcome.CHATTERS:
        why = CHATTERS.format(u, MOST_PHASES)
    elif outcome == Outcome.ESCAPES:
        why = ESCAPES.format(FAR)
    else:
        why = (UNBOUNDED if _grows_without_bound(forced.system, u) else STALLS).format(u)
    lost = Lost(AT.format(why, forced.Omega, forced.F_0) if forced.F_0 else why)
    lost.why, lost.theta = why, theta
    return lost


def _grows_without_bound(system: EquationOfMotion, u: float) -> bool:
    """Whether the restoring force is beyond all measure at u, where an integration has stalled."""
    with np.errstate(all="ignore"):  # it may have no value there
        at, nearer = (abs(system.force.value(spot)) for spot in (u, NEARER * u))
    return bool(np.isinf(at) or at > GROWS * nearer)


def _rest(phases: list[Phase], region: int, theta: float, u: float, until: float, end: float) -> float:
    """Adds a rest, or prolongs one that the last phase is; returns its end."""
    event = Event.STOP if until < end else Event.TIME
    if phases and phases[-1].slip == 0:
        phases[-1] = phases[-1]._replace(end=until, event=event)
    else:
        phases.append(Phase(0, region, theta, u, 0.0, until, u, 0.0, event))
    return until


def _move_off(
    integrator: Integrator, piece: Piece, drive: Drive, slip: int, edge: float, theta: float, u: float, end: float
) -> tuple[float, float, float] | None:
    """A short way from rest without looking for a stop, which rounding could find at the very start.

    The start itself where a breakpoint is too near; None if the mass does not move off.
    """
    moves = False
    for nudge in NUDGES:
        later = min(theta + nudge, end)
        there_u, there_v, _ = integrator.advance(piece, drive, theta, u, 0.0, later)
        if slip * there_v > 0.0:
            moves = True
            if slip * (there_u - edge) < 0.0:
                return later, there_u, there_v
    return (theta, u, 0.0) if moves else None


def signature(phases: list[Phase]) -> tuple[tuple[int, int], ...]:
    """(slip, region) of each phase: the order of switches, which smooth continuation keeps."""
    return tuple((phase.slip, phase.region) for phase in phases)


def stops(phases: list[Phase]) -> int:
    """How many of the phases are rests."""
    return sum(phase.slip == 0 for phase in phases)
