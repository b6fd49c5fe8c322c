"""Motions and cycles by another integrator, phase by phase in Python: what the compiled ones are held against.

In:  a motion, an integrator of smooth motion: `ScipyIntegrator` here, in benchmarks heyoka's too.
Out: `assert_followed`, whether the phases of a motion are those of the mass; `again`, a periodic motion solved for once
     more, with its multipliers; `equations` of a cycle.

It states anew what src/slowflow/native/exact does with series, and shares with it the closed forms of slowflow_kernels
alone. The order of switches is that of the motion found, which `again` sees hold by the other integrator.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp

from slowflow.exact import EquationOfMotion, Force
from slowflow.exact.cycle import Cycle
from slowflow.exact.motion import EXACT, PHASE, Forced, Phase, advance, edge_ahead, handle
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import FAR, TOLERANCE, Event

MOST_CALLS = 200_000  # of one integration
WITHIN = 1e-9  # of displacements, velocities, forces and angles


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

    def path(self, piece: Any, drive: Any, theta: float, u: float, v: float, end: float) -> Any:
        """u and v at the integrator's own steps."""

        def field(at: float, y: Any) -> Any:
            resists, _ = resistance(drive, y[1])
            return motion.rates(np.cos(at), y[1], drive.Omega, drive.F_0, drive.zeta, resists, piece(y[0]))

        return self._solve(field, (theta, end), np.array([u, v])).y

    def _solve(self, field: Any, span: tuple[float, float], start: Any) -> Any:
        left = MOST_CALLS

        def counted(theta: float, y: Any) -> Any:
            nonlocal left
            left -= 1
            if left < 0:
                raise ArithmeticError(f"the integration from theta = {span[0]} stalls at theta = {theta}, u = {y[0]}")
            return field(theta, y)

        # a step tried may leave the range where the force is defined; it is then refused
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            solution = solve_ivp(counted, span, start, **self._tolerances)
        if solution.status < 0:
            raise ArithmeticError(f"the integration from theta = {span[0]} failed: {solution.message}")
        return solution


def assert_followed(forced: Forced, phases: Sequence[Phase]) -> None:
    """Assert that the mass goes through these phases, by SciPy: each begins where one ends, and holds no switch."""
    system = forced.system
    for before, phase in zip([None, *phases[:-1]], phases, strict=True):
        slip, region, theta, u, v, end, u_end, v_end, event, *_ = phase
        holds, edge = system.holds(region), edge_ahead(system, slip, region)
        if before is not None:
            assert np.allclose((theta, u, v), (before.end, before.u_end, before.v_end), rtol=0, atol=WITHIN)
        if slip == 0:
            pushes = [abs(forced.push(region, at, u)) for at in np.linspace(theta, end, 200)]
            assert max(pushes) <= holds + WITHIN
            continue
        if v == 0:
            assert slip * forced.push(region, theta, u) >= holds - WITHIN
        displacements, velocities = ScipyIntegrator().path(
            forced.piece(region), drive_of(forced, slip, region), *phase[2:6]
        )
        assert np.allclose((u_end, v_end), (displacements[-1], velocities[-1]), rtol=0, atol=WITHIN)
        assert (slip * velocities[1:-1] >= -1e-12).all() and (slip * (displacements - edge) <= WITHIN).all()
        assert abs({Event.STOP: v_end, Event.EDGE: u_end - edge}.get(event, 0.0)) <= WITHIN


def equations(cycle: Cycle, integrator: Any, z: Any, F_0: float) -> tuple[Any, Any, Any, list[Phase]]:
    """Residual at z, its derivatives by all of z but Omega, the monodromy matrix with saltation, and the phases."""
    system, order, Omega = cycle.system, cycle.signature, float(z[-1])
    phases: list[Phase] = []
    k = len(order)
    forced = Forced(system, Omega, F_0)
    u, v, theta = float(z[0]), 0.0, float(z[1])
    residual, jacobian = np.empty(k + 2), np.zeros((k + 2, k + 2))
    # derivatives of u, v, theta by the unknowns
    of_state, of_theta = np.eye(2, k + 2), np.eye(1, k + 2, 1)[0]
    of_state[1] = 0.0
    monodromy = np.eye(2)
    for i, (slip, region) in enumerate(order):
        start = theta, u, v
        end = theta + float(z[2 + i])
        next_slip, next_region = order[(i + 1) % k]
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
            phases.append(Phase(slip, region, *start, end, u, v, Event.STOP))
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
        phases.append(Phase(slip, region, *start, end, u, v, Event.STOP if next_region == region else Event.EDGE))
    residual[k] = u - cycle.sign * float(z[0])
    jacobian[k] = of_state[0]
    jacobian[k, 0] -= cycle.sign
    residual[k + 1] = float(np.sum(z[2:-1])) - math.pi * cycle.half_turns
    jacobian[k + 1, 2:] = 1.0
    return residual, jacobian, cycle.sign * monodromy, phases


def solved(found: Any, integrator: Any) -> Any:
    """A steady state once more, by Newton's iteration with the order of switches found: A, multipliers, phases.

    Raises AssertionError where the iteration does not converge.
    """
    cycle, z = found.cycle, found.unknowns.copy()
    for _ in range(8):
        residual, jacobian, *_ = equations(cycle, integrator, z, found.F_0)
        z[:-1] -= np.linalg.solve(jacobian, residual)
        if np.max(np.abs(residual)) <= 100 * TOLERANCE:
            break
    assert np.max(np.abs(residual)) <= 100 * TOLERANCE
    *_, monodromy, phases = equations(cycle, integrator, z, found.F_0)
    multipliers = cycle.multipliers(monodromy)
    A = max(max(abs(phase.u), abs(phase.u_end)) for phase in phases)
    return SimpleNamespace(A=A, multipliers=multipliers**2 if cycle.sign == -1 else multipliers, phases=phases)


def again(found: Any) -> Any:
    """The same by SciPy, and it is a motion."""
    other = solved(found, ScipyIntegrator())
    assert_followed(Forced(found.cycle.system, found.Omega, found.F_0), other.phases)
    return other
