"""One oscillator, asked at three depths: in goes a mechanism with its numbers, out come averaged to exact answers.

The averaged questions come from `Averaged`; the second approximation and the exact motions are loaded when asked for.
"""

from __future__ import annotations

from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any

from slowflow import validate
from slowflow.averaged.questions import Averaged
from slowflow.mechanism import Force
from slowflow.model import Model

if TYPE_CHECKING:
    from slowflow import exact
    from slowflow.second import SecondApproximation

#: frequencies shown of the equation of motion, whose cycle has ever more stops as Omega tends to 0
EXACT_WINDOW = (0.5, 1.5)


class Oscillator(Averaged):
    """A forced oscillator u'' + 2 zeta u' + mu sign(u') + f(u) = F_0 cos(Omega tau) (3).

    Not made directly: see `Isolator` and `Duffing`.
    """

    def __init__(self, kernels: ModuleType, parameters: tuple[float, ...], mu: Any, zeta: Any) -> None:
        mu = validate.number("mu", mu, least=0.0)
        zeta = validate.number("zeta", zeta, least=0.0)
        super().__init__(Model(kernels, parameters, mu, zeta))

    def restoring_force(self, which: str | None = None) -> Force:
        """The force of the equation of motion, piece by piece: "truncated" for (6), "untruncated" for (5).

        Without `which` the one that is averaged. Raises ValueError for another word.
        """
        raise NotImplementedError

    def steady_state(
        self, *, Omega: float, F_0: float, A: float | None = None, force: str | None = None
    ) -> exact.SteadyState:
        """A periodic motion of the equation of motion (3) itself: series, harmonics, stops, multipliers, residual.

        A     -- the motion whose amplitude is nearest to A, stable or not, of those that averaging leads to: from its
                 states at Omega, its folds beside it, and A itself; where none of them leads to a motion near it, what
                 the averaged state nearest to A settles to. Without it the motion that a mass at rest comes to
        force -- "truncated" for (6), "untruncated" for (5); by default the one that is averaged

        Raises ValueError for parameters out of range, as F_0 <= mu, ArithmeticError if nothing periodic is found.
        """
        from slowflow.exact import questions

        return questions.steady_state(self, self.restoring_force(force), Omega, F_0, A)

    def exact_response(
        self,
        F_0: float,
        *,
        Omega: tuple[float, float] = EXACT_WINDOW,
        start: exact.SteadyState | None = None,
        step: float = 0.02,
        force: str | None = None,
    ) -> exact.Response:
        """The response curve of the equation of motion (3) in the window `Omega`: points, stability, stops, folds.

        It is the curve through the motion that a mass at rest comes to at the lowest frequency, or through `start`: an
        isolated curve needs its own, `start=steady_state(Omega=..., F_0=..., A=...)`, and where averaging knows of one
        that this is not, `.message` gives these numbers. `step` is the largest distance of neighbouring points, `force`
        as in `steady_state`. `.peak` is the highest motion of the curve.
        Raises ValueError for parameters out of range, as F_0 <= mu, ArithmeticError where it cannot be followed.
        """
        from slowflow.exact import questions

        return questions.exact_response(self, self.restoring_force(force), F_0, Omega, start, step)

    def sweep(self, *, Omega: Any, F_0: float, force: str | None = None) -> exact.Sweep:
        """What an experiment sees that steps through the frequencies `Omega` in their order: amplitudes and jumps.

        The motion is followed at each frequency until it is shown to tend to a stable periodic one, whose amplitude is
        given, and goes on from there; where it does not within 2000 turns of the forcing, `.settled` says so. `force`
        as in `steady_state`. Raises ValueError for parameters out of range, as F_0 <= mu, ArithmeticError where the
        motion escapes a softening spring.
        """
        from slowflow.exact import questions

        return questions.sweep(self, self.restoring_force(force), Omega, F_0)

    @cached_property
    def second_approximation(self) -> SecondApproximation:
        """The same questions with the higher harmonics of force and friction: closer to the equation of motion.

        Raises ValueError where these harmonics are not derived: for force="untruncated" with u_cr > 3/4.
        """
        from slowflow.second import SecondApproximation

        kernels = self.model.kernels
        for u_cr in self.model.breakpoints:
            if u_cr > kernels.HARMONICS_UP_TO:
                raise ValueError(
                    f"u_cr = {u_cr:g} is not allowed here: the harmonics of this force are derived for "
                    f"u_cr <= {kernels.HARMONICS_UP_TO:g}"
                )
        return SecondApproximation(self)
