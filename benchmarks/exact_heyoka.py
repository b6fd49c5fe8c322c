"""Smooth motion by heyoka, a Taylor integrator that shares nothing with the package.

In:  a piece of the force, the constants of the phase, a state, a span of theta = Omega tau.
Out: what `tests.oracles.exact_reference` asks of an integrator.
"""

from __future__ import annotations

import operator
import threading
from collections.abc import Callable
from typing import Any

import numpy as np

from slowflow.core.mechanism import Floats, Law, Piece

MOST_STEPS, CHUNK = 200_000, 20_000  # steps between two looks at Ctrl-C: some hundredths of a second


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

        self._heyoka = heyoka
        self._compiled: dict[Law, Any] = {}
        self._by_text: dict[str, Any] = {}
        self._end = heyoka.taylor_outcome.time_limit

    def _for(self, piece: Piece) -> Any:
        found = self._compiled.get(piece.law)
        if found is None:
            hy = self._heyoka
            constants = [_Traced(hy.par[5 + i]) for i in range(len(piece.constants))]
            force = piece.law.force(_Traced(hy.make_vars("u")), *constants).expression
            found = self._by_text.get(str(force))
            if found is None:
                found = self._by_text[str(force)] = self._compile(force)
            self._compiled[piece.law] = found
        return found

    def _compile(self, force: Any) -> Any:
        hy = self._heyoka
        u, v = hy.make_vars("u", "v")
        Omega, F_0, zeta, friction, quadratic = (hy.par[i] for i in range(5))
        acceleration = F_0 * hy.cos(hy.time) - 2.0 * zeta * v - force - friction - quadratic * v * v
        system = [(u, v / Omega), (v, acceleration / Omega)]
        return hy.taylor_adaptive(hy.var_ode_sys(system, args=[u, v, Omega, F_0], order=1), [0.0, 0.0])

    def _propagated(self, integrator: Any, end: float) -> Any:
        """heyoka's outcome at `end`; in chunks, as it is deaf to Ctrl-C."""
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
        integrator = self._for(piece)
        # an integrator has as many parameters as its expressions mention
        integrator.pars[:] = (*drive[:5], *piece.constants)[: len(integrator.pars)]
        integrator.time = theta
        state = integrator.state
        state[:] = (u, v, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)
        if self._propagated(integrator, end) != self._end:
            raise ArithmeticError(f"the integration from theta = {theta} to {end} failed at theta = {integrator.time}")
        return float(state[0]), float(state[1]), state[2:].reshape(2, 4).copy()
