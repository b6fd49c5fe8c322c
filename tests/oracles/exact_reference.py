"""Motions and cycles by another integrator, event by event in Python: what the compiled ones are held against.

In:  an oscillator, an integrator of smooth motion: `ScipyIntegrator` here, in benchmarks heyoka's too.
Out: `follow`, the phases of a motion; `again`, a periodic motion solved for once more, with its multipliers;
     `equations` of a cycle.

It states anew what src/slowflow/native/exact does with series, and shares with it the closed forms of slowflow_kernels
alone. The order of switches is that of the motion found, which `again` sees hold by the other integrator.
"""

from __future__ import annotations

import functools
import math
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

from slowflow.exact import EquationOfMotion, Force
from slowflow.exact.cycle import Cycle
from slowflow.exact.motion import EXACT, PHASE, Forced, Phase, advance, edge_ahead, handle, signature
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import FAR, GRAZING, MOST_PHASES, TOLERANCE, Event

TURN = 2 * math.pi
MOST_CALLS = 200_000  # of one integration
OF_TURN = 1e-14  # share of a turn by which rounding may miss its end
NUDGES = (1e-3, 1e-4, 1e-5, 1e-6)  # angles over which a start at rest moves off before stops are looked for


class Drive(NamedTuple):
    """The constants of a slip phase; friction and quadratic are mu and c_2 times the sign of the velocity.

    Of friction a static load is taken off. Structural damping is part of zeta, and has it go with Omega.
    """

    Omega: float
    F_0: float
    zeta: float
    friction: float
    quadratic: float = 0.0
    zeta_by_Omega: float = 0.0


def drive_of(forced: Forced, slip: int, region: int) -> Drive:
    """Those in a region."""
    system = forced.system
    zeta, by_Omega = system.zeta, 0.0
    if system.eta != 0:
        structural, by_Omega = map(float, motion.structural(forced.Omega, system.eta))
        zeta += structural
    friction = slip * system.friction(region) - system.load
    return Drive(forced.Omega, forced.force, zeta, friction, slip * system.c_2, by_Omega)


def resistance(drive: Any, v: Any) -> Any:
    """What resists like friction at a velocity, and zeta with its slope beside it."""
    if drive.quadratic == 0:
        return drive.friction, drive.zeta
    return motion.resistance(v, drive.zeta, drive.friction, drive.quadratic, 0.0, 0.0, 0.0)[:2]


def accelerated(forced: Forced, slip: int, region: int, theta: float, u: float, v: float) -> float:
    """u'' in a slip phase."""
    drive = drive_of(forced, slip, region)
    resists, spring = resistance(drive, v)[0], forced.piece(region).value(u)
    return float(motion.acceleration(math.cos(theta), v, drive.F_0, drive.zeta, resists, spring))


class Compiled:
    """The compiled integrator on one piece by itself."""

    name = "taylor"

    def advance(self, piece: Any, drive: Any, *way: float) -> Any:
        """State (u, v) at the end, also before the start, and its derivatives by (u, v, Omega, F_0): shape (2, 4)."""
        return advance(single_piece(piece, drive), slip_of(drive), 0, *way)

    def until(self, piece: Any, drive: Any, slip: int, edge: float, *way: float) -> Any:
        """First stop (slip v falls through 0), arrival at u = edge, or the end: (theta, u, v, `Event`)."""
        *state, end = way
        forced = single_piece(piece, drive, edge)
        at = forced.system.force.region_of(state[1])
        of, options = handle(forced.system), (True, slip, at, MOST_CALLS)
        outcome, _, phases = EXACT.follow(of, *forced[1:], *state, end, *options)
        first = Phase(*next(PHASE.iter_unpack(phases)))
        if outcome:
            raise ArithmeticError(f"the integration from theta = {way[0]} failed at theta = {first.end}")
        return first.end, first.u_end, first.v_end, first.event


def slip_of(drive: Drive) -> int:
    """The direction in which that resists; friction is taken for a load."""
    return -1 if drive.quadratic < 0 else 1


@functools.cache
def single_piece(piece: Any, drive: Drive, edge: float = FAR) -> Forced:
    """One piece on both sides of an edge, with the forcing and damping of a drive."""
    force = Force((piece,), ()) if abs(edge) >= FAR else Force((piece, piece), (edge,), odd=False)
    eta = -2.0 * drive.Omega**2 * drive.zeta_by_Omega
    zeta = drive.zeta - eta / (2.0 * drive.Omega)
    system = EquationOfMotion(force, 0.0, zeta, load=-drive.friction, c_2=abs(drive.quadratic), eta=eta)
    return Forced(system, drive.Omega, drive.F_0)


class ScipyIntegrator:
    """DOP853 at the tightest tolerances it keeps; slower, needs nothing but SciPy."""

    name = "scipy"
    _tolerances = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-15}  # noqa: RUF012

    @staticmethod
    def _field(piece: Any, drive: Any) -> Any:
        def field(theta: float, y: Any) -> Any:
            resists, _ = resistance(drive, y[1])
            return motion.rates(np.cos(theta), y[1], drive.Omega, drive.F_0, drive.zeta, resists, piece(y[0]))

        return field

    def advance(self, piece: Any, drive: Any, theta: float, u: float, v: float, end: float) -> Any:
        """As of `slowflow.exact.motion`."""
        Omega, F_0, zeta, *_ = drive

        def variational(at: float, y: Any) -> Any:
            resists, damps = resistance(drive, y[1])
            arguments = (np.cos(at), y[1], Omega, F_0, zeta, resists, piece(y[0]))
            # arrays of numbers: np.reshape of a tuple takes as long as all the rest
            by_state = np.array(motion.rates_by_state(Omega, damps, piece.slope(y[0]))).reshape(2, 2)
            by_parameter = np.array(motion.rates_by_parameter(*arguments)).reshape(2, -1)
            by_parameter[:, 0] += drive.zeta_by_Omega * by_parameter[:, 2]
            rates = np.empty(10)
            rates[:2] = motion.rates(*arguments)
            tangent = np.matmul(by_state, y[2:].reshape(2, 4), out=rates[2:].reshape(2, 4))
            tangent[:, 2:] += by_parameter[:, :2]
            return rates

        start = np.array([u, v, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0])
        if end == theta:
            return u, v, start[2:].reshape(2, 4)
        y = self._solve(variational, (theta, end), start).y[:, -1]
        return float(y[0]), float(y[1]), y[2:].reshape(2, 4)

    def until(
        self, piece: Any, drive: Any, slip: int, edge: float, theta: float, u: float, v: float, end: float
    ) -> Any:
        """As of `slowflow.exact.motion`."""

        def stop(_: float, y: Any) -> float:
            return float(slip * y[1])

        def arrival(_: float, y: Any) -> float:
            return float(slip * (y[0] - edge))

        for event, direction in ((stop, -1.0), (arrival, 1.0)):
            event.terminal = True  # type: ignore[attr-defined]
            event.direction = direction  # type: ignore[attr-defined]
        field = self._field(piece, drive)
        solution = self._solve(field, (theta, end), np.array([u, v]), events=[stop, arrival])
        for code, times in ((Event.STOP, solution.t_events[0]), (Event.EDGE, solution.t_events[1])):
            if times.size:
                return self._refined(field, edge, solution, float(times[0]), code)
        return end, float(solution.y[0, -1]), float(solution.y[1, -1]), Event.TIME

    def _refined(self, field: Any, edge: float, solution: Any, at: float, code: int) -> Any:
        """The event's time by Newton from the start of its step: the dense output alone is too coarse."""
        begin, start = float(solution.t[-2]), solution.y[:, -2]
        for _ in range(8):
            u, v = self._solve(field, (begin, at), start).y[:, -1] if at != begin else start
            u_dot, v_dot = field(at, np.array([u, v]))
            change = v / v_dot if code == Event.STOP else (u - edge) / u_dot
            if not abs(change) > 1e-15 * max(1.0, abs(at)):
                break
            at -= change
        return at, float(u), float(v), code

    def _solve(self, field: Any, span: tuple[float, float], start: Any, **options: Any) -> Any:
        left = MOST_CALLS

        def counted(theta: float, y: Any) -> Any:
            nonlocal left
            left -= 1
            if left < 0:
                raise ArithmeticError(f"the integration from theta = {span[0]} stalls at theta = {theta}, u = {y[0]}")
            return field(theta, y)

        # a step tried may leave the range where the force is defined; it is then refused
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            solution = solve_ivp(counted, span, start, **self._tolerances, **options)
        if solution.status < 0:
            raise ArithmeticError(f"the integration from theta = {span[0]} failed: {solution.message}")
        return solution


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
    forced: Forced, integrator: Any, theta: float, u: float, v: float, end: float, start: tuple[int, int] | None = None
) -> list[Phase]:
    """All phases from (theta, u, v) to `end`, as `slowflow.exact.motion.follow` has them."""
    system = forced.system
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
            raise ArithmeticError(f"the mass chatters near u = {u}")
        if slip == 0:
            at, slip = break_away(forced, region, theta, u)
            theta = _rest(phases, region, theta, u, min(at, end), end)
            continue
        edge = edge_ahead(system, slip, region)
        if slip * u >= FAR:
            raise ArithmeticError("the motion escapes")
        if slip * (u - edge) >= 0.0:  # turned round within rounding of a breakpoint
            region += slip
            continue
        piece, drive = forced.piece(region), drive_of(forced, slip, region)
        from_theta, from_u, from_v = theta, u, v
        if v == 0.0:
            started = _move_off(integrator, piece, drive, slip, edge, theta, u, end)
            if started is None and system.holds(region) > 0:
                # the push exceeds friction by too little and for too short a time to be told from rounding
                region = 0 if u == 0.0 and system.force.jump != 0.0 else region
                at, slip = break_away(forced, region, theta + NUDGES[-1], u)
                theta = _rest(phases, region, theta, u, min(at, end), end)
                continue
            theta, u, v = started or (theta, u, v)
        if theta < end:
            theta, u, v, event = integrator.until(piece, drive, slip, edge, theta, u, v, end)
        else:
            event = Event.TIME
        if event == Event.STOP:
            v = 0.0
        elif event == Event.EDGE:
            u = edge
            beyond = system.force.beyond(slip, region)
            if abs(v) < GRAZING and slip * accelerated(forced, slip, beyond, theta, u, v) < 0.0:
                v, event = 0.0, Event.STOP
        phases.append(Phase(slip, region, from_theta, from_u, from_v, theta, u, v, event))
        if event == Event.STOP and u == 0.0 and system.force.jump != 0.0:
            region = 0
        if event == Event.STOP:
            slip = after_stop(forced, slip, region, theta, u)
        elif event == Event.EDGE:
            region += slip
    return phases


def _rest(phases: list[Phase], region: int, theta: float, u: float, until: float, end: float) -> float:
    """Adds a rest, or prolongs one that the last phase is; returns its end."""
    event = Event.STOP if until < end else Event.TIME
    if phases and phases[-1].slip == 0:
        phases[-1] = phases[-1]._replace(end=until, event=event)
    else:
        phases.append(Phase(0, region, theta, u, 0.0, until, u, 0.0, event))
    return until


def _move_off(
    integrator: Any, piece: Any, drive: Any, slip: int, edge: float, theta: float, u: float, end: float
) -> tuple[float, float, float] | None:
    """Leave rest by a short step without event detection, as rounding could find a stop at the very start.

    The start itself where a breakpoint is too near; None if the mass does not move off.
    """
    slips = False
    for nudge in NUDGES:
        later = min(theta + nudge, end)
        there_u, there_v, _ = integrator.advance(piece, drive, theta, u, 0.0, later)
        if slip * there_v > 0.0:
            slips = True
            if slip * (there_u - edge) < 0.0:
                return later, there_u, there_v
    return (theta, u, 0.0) if slips else None


def equations(cycle: Cycle, integrator: Any, z: Any, F_0: float) -> tuple[Any, Any, Any]:
    """Residual at z, its derivatives by all of z but Omega, and the monodromy matrix with saltation at every switch."""
    system, phases, Omega = cycle.system, cycle.signature, float(z[-1])
    k = len(phases)
    forced = Forced(system, Omega, F_0)
    u, v, theta = float(z[0]), 0.0, float(z[1])
    residual, jacobian = np.empty(k + 2), np.zeros((k + 2, k + 2))
    # derivatives of u, v, theta by the unknowns
    of_state, of_theta = np.eye(2, k + 2), np.eye(1, k + 2, 1)[0]
    of_state[1] = 0.0
    monodromy = np.eye(2)
    for i, (slip, region) in enumerate(phases):
        end = theta + float(z[2 + i])
        next_slip, next_region = phases[(i + 1) % k]
        if i == k - 1:
            next_slip, next_region = cycle.sign * next_slip, cycle.sign * next_region
        if slip == 0:
            of_theta[2 + i] = 1.0
            of_state[1] = 0.0
            residual[i] = forced.push(region, end, u) - next_slip * system.holds(region)
            slope = forced.piece(region).slope(u)
            by_theta, by_u, _ = motion.push_slopes(math.cos(end), math.sin(end), forced.force, slope)
            jacobian[i] = by_theta * of_theta + by_u * of_state[0]
            # v is forgotten; where the push that breaks it away exceeds friction the acceleration jumps from 0, and
            # u tells when
            jump = accelerated(forced, next_slip, region, end, u, 0.0) if system.mu_s > system.mu else 0.0
            monodromy[1] = motion.released(jump, Omega, by_theta, by_u) * monodromy[0]
            v, theta = 0.0, end
            continue
        piece, drive = forced.piece(region), drive_of(forced, slip, region)
        rate = np.array([v, accelerated(forced, slip, region, theta, u, v)]) / Omega
        u, v, flow = integrator.advance(piece, drive, theta, u, v, end)
        of_state = flow[:, :2] @ (of_state - np.outer(rate, of_theta))
        of_theta[2 + i] = 1.0
        acceleration = accelerated(forced, slip, region, end, u, v)
        of_state += np.outer((v / Omega, acceleration / Omega), of_theta)
        monodromy = flow[:, :2] @ monodromy
        theta = end
        if next_region != region:
            residual[i] = u - edge_ahead(system, slip, region)
            jacobian[i] = of_state[0]
            if v != 0.0:
                after = accelerated(forced, slip, next_region, end, u, v)
                monodromy[1] += motion.across(acceleration, after, v) * monodromy[0]
        else:
            residual[i] = v
            jacobian[i] = of_state[1]
            if next_slip == 0:
                monodromy[1] = 0.0
            elif acceleration != 0.0:
                monodromy[1] *= motion.turned(acceleration, accelerated(forced, next_slip, region, end, u, v))
    residual[k] = u - cycle.sign * float(z[0])
    jacobian[k] = of_state[0]
    jacobian[k, 0] -= cycle.sign
    residual[k + 1] = float(np.sum(z[2:-1])) - math.pi * cycle.half_turns
    jacobian[k + 1, 2:] = 1.0
    return residual, jacobian, cycle.sign * monodromy


def again(found: Any, integrator: Any) -> Any:
    """A steady state once more, by Newton's iteration with the order of switches found: A, multipliers, unknowns.

    Raises AssertionError where the iteration does not converge, or the motion has another order of switches.
    """
    cycle, F_0, z = found.cycle, found.F_0, found.unknowns.copy()
    for _ in range(8):
        residual, jacobian, monodromy = equations(cycle, integrator, z, F_0)
        z[:-1] -= np.linalg.solve(jacobian, residual)
        if np.max(np.abs(residual)) <= 100 * TOLERANCE:
            break
    assert np.max(np.abs(residual)) <= 100 * TOLERANCE
    start = cycle.signature[0] if cycle.starts_sticking else None
    forced, theta = Forced(cycle.system, found.Omega, F_0), float(z[1])
    phases = follow(forced, integrator, theta, float(z[0]), 0.0, theta + math.pi * cycle.half_turns + 1e-6, start)
    phases = phases[: len(cycle.signature)]
    assert signature(phases) == cycle.signature
    multipliers = cycle.multipliers(monodromy)
    A = max(max(abs(phase.u), abs(phase.u_end)) for phase in phases)
    return SimpleNamespace(A=A, multipliers=multipliers**2 if cycle.sign == -1 else multipliers, unknowns=z)
