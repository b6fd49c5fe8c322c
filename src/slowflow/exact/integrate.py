"""Smooth motion between two switches: (3) as it is generated, by theta = Omega tau.

In:  a piece of the force, the constants of the phase, a state, a span of theta.
Out: the state at its end, with its derivatives or up to the first stop or breakpoint, or on a grid.

Primes are derivatives by theta; v is the velocity du/dtau. `compiled` has the integrator in C that the derivation
generates recurrences for; SciPy's DOP853 here serves where there is no compiler, and for forces that were not compiled.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from contextvars import ContextVar
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from slowflow.mechanism import Piece
from slowflow.text import text
from slowflow_kernels import motion
from slowflow_kernels.exact_conventions import Event
from slowflow_support.errors import NotSettled

Array = NDArray[np.float64]

MOST_STEPS = 200_000  # of one integration, or calls by SciPy: a slip takes some tens, hundreds at low frequency
#: steps of one question, 240 times what a curve of 390 points takes: ten to twenty seconds, by SciPy less than a minute
MOST_WORK = 3_000_000
CALL_WORK = 2  # steps that a call by SciPy counts as
PHASE_WORK = 30  # steps that take as long as all else that is done for a phase of a motion


GIVEN_UP = "given up after {} integration steps, more than an answer should take"


class Stalled(NotSettled):
    """An integration that does not get to its end, and the angle and u that it gets to."""

    theta: float
    u: float

    @classmethod
    def at(cls, why: str, theta: float, u: float) -> Stalled:
        """One with these; the words alone make it, as those of any error, so that it can be pickled."""
        made = cls(why)
        made.theta, made.u = theta, u
        return made


class OutOfWork(Exception):
    """The question has used up its steps. No ArithmeticError: a trial that fails is replaced by another."""

    def __init__(self, most: int) -> None:
        super().__init__(GIVEN_UP.format(most))


_left: ContextVar[list[int] | None] = ContextVar("steps that the question has left", default=None)


@contextlib.contextmanager
def limited(most: int = MOST_WORK) -> Iterator[None]:
    """Bounds the steps of one question, inner questions included. Raises ArithmeticError where they do not suffice."""
    if _left.get() is not None:
        yield
        return
    token = _left.set([most, most])
    try:
        yield
    except OutOfWork as used_up:
        raise NotSettled(str(used_up)) from None
    finally:
        _left.reset(token)


def steps_left() -> int:
    """The steps that one integration may take now."""
    left = _left.get()
    return MOST_STEPS if left is None else max(0, min(MOST_STEPS, left[0] + 1))


def spend(steps: int, *, keep: bool = False) -> None:
    """Counts steps of an integrator against what the question has left.

    keep -- what was found with them is good: not this call is refused but the next
    """
    left = _left.get()
    if left is not None:
        left[0] -= steps
        if left[0] < 0 and not keep:
            raise OutOfWork(left[1])


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

    def resistance(self, v: Any) -> tuple[Any, Any]:
        """What resists like friction at a velocity, quadratic damping included, and zeta with its slope beside it."""
        if self.quadratic == 0:
            return self.friction, self.zeta
        resists, damps = motion.resistance(v, self.zeta, self.friction, self.quadratic)
        return resists, damps


class Integrator(Protocol):
    """What the motion needs from an integrator."""

    def advance(
        self, piece: Piece, drive: Drive, theta: float, u: float, v: float, end: float
    ) -> tuple[float, float, Array]:
        """State (u, v) at `end`, also before theta, and its derivatives by (u, v, Omega, F_0): shape (2, 4)."""
        ...

    def until(
        self, piece: Piece, drive: Drive, slip: int, edge: float, theta: float, u: float, v: float, end: float
    ) -> tuple[float, float, float, int]:
        """First stop (slip v falls through 0), arrival at u = edge, or `end`: (theta, u, v, `Event`)."""
        ...

    def sample(self, piece: Piece, drive: Drive, theta: float, u: float, v: float, grid: Array) -> Array:
        """States on the grid, which lies at or after theta and does not fall: shape (grid.size, 2)."""
        ...


class ScipyIntegrator:
    """DOP853 at the tightest tolerances it keeps; slower, needs nothing but SciPy."""

    name = "scipy"
    _tolerances = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-15}  # noqa: RUF012

    @staticmethod
    def _field(piece: Piece, drive: Drive) -> Any:
        def field(theta: float, y: Array) -> Any:
            resists, _ = drive.resistance(y[1])
            return motion.rates(np.cos(theta), y[1], drive.Omega, drive.F_0, drive.zeta, resists, piece(y[0]))

        return field

    def advance(
        self, piece: Piece, drive: Drive, theta: float, u: float, v: float, end: float
    ) -> tuple[float, float, Array]:
        """See `Integrator`."""
        Omega, F_0, zeta, *_ = drive

        def variational(at: float, y: Array) -> Array:
            resists, damps = drive.resistance(y[1])
            given = (np.cos(at), y[1], Omega, F_0, zeta, resists, piece(y[0]))
            # arrays of numbers: np.reshape of a tuple takes as long as all the rest
            by_state = np.array(motion.rates_by_state(Omega, damps, piece.slope(y[0]))).reshape(2, 2)
            by_parameter = np.array(motion.rates_by_parameter(*given)).reshape(2, -1)
            by_parameter[:, 0] += drive.zeta_by_Omega * by_parameter[:, 2]
            rates = np.empty(10)
            rates[:2] = motion.rates(*given)
            tangent = np.matmul(by_state, y[2:].reshape(2, 4), out=rates[2:].reshape(2, 4))
            tangent[:, 2:] += by_parameter[:, :2]
            return rates

        start = np.array([u, v, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0])
        if end == theta:
            return u, v, start[2:].reshape(2, 4)
        y = self._solve(variational, (theta, end), start).y[:, -1]
        return float(y[0]), float(y[1]), y[2:].reshape(2, 4)

    def until(
        self, piece: Piece, drive: Drive, slip: int, edge: float, theta: float, u: float, v: float, end: float
    ) -> tuple[float, float, float, int]:
        """See `Integrator`."""

        def stop(_: float, y: Array) -> float:
            return float(slip * y[1])

        def arrival(_: float, y: Array) -> float:
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

    def _refined(self, field: Any, edge: float, solution: Any, at: float, code: int) -> tuple[float, float, float, int]:
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

    def sample(self, piece: Piece, drive: Drive, theta: float, u: float, v: float, grid: Array) -> Array:
        """See `Integrator`."""
        times, where = np.unique(np.maximum(grid, theta), return_inverse=True)
        states = np.empty((times.size, 2))
        y = np.array([u, v])
        for i, at in enumerate(times):  # step by step: the dense output is too coarse
            if at > theta:
                y = self._solve(self._field(piece, drive), (theta, float(at)), y).y[:, -1]
            theta, states[i] = float(at), y
        return states[where]

    def _solve(self, field: Any, span: tuple[float, float], start: Array, **options: Any) -> Any:
        from scipy.integrate import solve_ivp

        left = MOST_STEPS

        def counted(theta: float, y: Array) -> Any:
            nonlocal left
            spend(CALL_WORK)
            left -= 1
            if left < 0:
                why = text(
                    "the integration from theta = {start:s} stalls at {theta = :}, {u = :}", str(span[0]), theta, y[0]
                )
                raise Stalled.at(why, theta, float(y[0]))
            return field(theta, y)

        # a step tried may leave the range where the force is defined; it is then refused
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            solution = solve_ivp(counted, span, start, **self._tolerances, **options)
        if solution.status < 0:
            theta, u = float(solution.t[-1]), float(solution.y[0, -1])
            raise Stalled.at(f"the integration from theta = {span[0]} failed: {solution.message}", theta, u)
        return solution
