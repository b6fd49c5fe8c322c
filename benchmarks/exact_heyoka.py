"""Smooth motion by heyoka, a Taylor integrator that shares nothing with the package.

In:  a piece of the force, the constants of the phase, a state, a span of theta = Omega tau.
Out: what `tests.oracles.exact_reference` asks of an integrator.
"""

from __future__ import annotations

import operator
import threading
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from slowflow.core.mechanism import Floats, Law, Piece
from slowflow_kernels.exact_conventions import FAR, Event

MOST_STEPS, CHUNK = 200_000, 20_000  # steps between two looks at Ctrl-C: some hundredths of a second


class _Compiled(NamedTuple):
    variations: Any
    events: Any


class _Traced(np.lib.mixins.NDArrayOperatorsMixin):
    """A symbol of heyoka's that NumPy's operators and functions can be applied to."""

    def __init__(self, expression: Any) -> None:
        self.expression = expression

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **_: Any) -> Any:
        function = _UFUNCS.get(ufunc.__name__)
        if function is None or method != "__call__":
            raise TypeError(f"a force with numpy.{ufunc.__name__} cannot be translated for heyoka")
        return _Traced(function(*(i.expression if isinstance(i, _Traced) else float(i) for i in inputs)))


def _square_root(expression: Any) -> Any:
    import heyoka

    return heyoka.sqrt(expression)


def _with_sign(size: Any, sign: Any) -> Any:
    """For a size that is not negative."""
    import heyoka

    return heyoka.select(heyoka.gte(sign, 0.0), size, -size)


_UFUNCS: dict[str, Callable[..., Any]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "divide": operator.truediv,
    "negative": operator.neg,
    "sqrt": _square_root,
    "copysign": _with_sign,
}


class HeyokaIntegrator(threading.local):
    """Taylor series of order 20, error per step of one rounding; each expression is compiled once, in about 0.4 s.

    Its compiled integrators hold state: every thread has its own, whichever motions share this object.
    """

    name = "heyoka"

    def __init__(self) -> None:
        import heyoka

        # it warns where it cannot separate two stops within one rounding of each other, which is what a border is
        heyoka.set_logger_level_error()
        self._heyoka = heyoka
        self._compiled: dict[Law, _Compiled] = {}
        self._by_text: dict[str, _Compiled] = {}
        self._end = heyoka.taylor_outcome.time_limit

    def _for(self, piece: Piece) -> _Compiled:
        found = self._compiled.get(piece.law)
        if found is None:
            hy = self._heyoka
            constants = [_Traced(hy.par[7 + i]) for i in range(len(piece.constants))]
            force = piece.law.force(_Traced(hy.make_vars("u")), *constants).expression
            found = self._by_text.get(str(force))
            if found is None:
                found = self._by_text[str(force)] = self._compile(force)
            self._compiled[piece.law] = found
        return found

    def _compile(self, force: Any) -> _Compiled:
        hy = self._heyoka
        u, v = hy.make_vars("u", "v")
        Omega, F_0, zeta, friction, quadratic, slip, edge = (hy.par[i] for i in range(7))
        acceleration = F_0 * hy.cos(hy.time) - 2.0 * zeta * v - force - friction - quadratic * v * v
        system = [(u, v / Omega), (v, acceleration / Omega)]
        variational = hy.var_ode_sys(system, args=[u, v, Omega, F_0], order=1)
        events = [
            hy.t_event(slip * v, direction=hy.event_direction.negative),
            hy.t_event(slip * (u - edge), direction=hy.event_direction.positive),
        ]
        return _Compiled(
            hy.taylor_adaptive(variational, [0.0, 0.0]), hy.taylor_adaptive(system, [0.0, 0.0], t_events=events)
        )

    @staticmethod
    def _set(integrator: Any, piece: Piece, drive: Any, slip: float, edge: float, theta: float) -> None:
        # an integrator has as many parameters as its expressions mention
        integrator.pars[:] = (*drive[:5], slip, edge, *piece.constants)[: len(integrator.pars)]
        integrator.time = theta

    def _propagated(self, integrator: Any, end: float) -> Any:
        """heyoka's outcome at `end` or at an event; in chunks, as it is deaf to Ctrl-C."""
        left = MOST_STEPS
        while True:
            outcome, _, _, steps, *_ = integrator.propagate_until(end, max_steps=min(CHUNK, left))
            left -= int(steps)
            if outcome != self._heyoka.taylor_outcome.step_limit or left <= 0:
                return outcome

    def advance(
        self, piece: Piece, drive: Any, theta: float, u: float, v: float, end: float
    ) -> tuple[float, float, Floats]:
        """As of `exact_reference.Compiled`."""
        integrator = self._for(piece).variations
        self._set(integrator, piece, drive, 0.0, FAR, theta)
        state = integrator.state
        state[:] = (u, v, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)
        if self._propagated(integrator, end) != self._end:
            raise ArithmeticError(f"the integration from theta = {theta} to {end} failed at theta = {integrator.time}")
        return float(state[0]), float(state[1]), state[2:].reshape(2, 4).copy()

    def until(
        self, piece: Piece, drive: Any, slip: int, edge: float, theta: float, u: float, v: float, end: float
    ) -> tuple[float, float, float, int]:
        """As of `exact_reference.Compiled`."""
        integrator = self._for(piece).events
        self._set(integrator, piece, drive, slip, edge, theta)
        state = integrator.state
        state[:] = (u, v)
        integrator.reset_cooldowns()
        outcome = self._propagated(integrator, end)
        if outcome == self._end:
            event = Event.TIME
        else:
            # heyoka numbers a terminal event i that stops the integration -i - 1
            index = -int(outcome) - 1
            if index not in (0, 1):
                raise ArithmeticError(f"the integration from theta = {theta} failed at theta = {integrator.time}")
            event = Event.EDGE if index else Event.STOP
        return float(integrator.time), float(state[0]), float(state[1]), event
