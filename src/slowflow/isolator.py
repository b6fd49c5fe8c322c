"""What a user holds: an oscillator with its parameters. In go numbers, out come curves, folds and critical forcings.

`Isolator` is the paper's mechanism, `Duffing` one cubic piece; the same solvers serve both. Everything is
dimensionless, as in (4): displacement in rod lengths, force in k_v L, frequency in sqrt(k_v/m).
"""

from __future__ import annotations

import dataclasses
import importlib
import math
import warnings
from functools import cached_property, partial
from types import ModuleType
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from slowflow import plan, solvers, validate, validity
from slowflow.folds import NO_FOLD
from slowflow.many import Designs
from slowflow.model import Floats, Model
from slowflow.results import (
    Cusps,
    Detachment,
    FoldLocus,
    FrequencyResponse,
    IsolaPoints,
    Peak,
    SaddleNodeOnset,
    SaddleNodes,
    SteadyStates,
    words,
)
from slowflow_kernels import duffing, rod_spring, rod_spring_attached

if TYPE_CHECKING:
    from slowflow import exact
    from slowflow.exact.force import Force
    from slowflow.second import SecondApproximation

Answer = TypeVar("Answer", FrequencyResponse, SteadyStates, SaddleNodes)

#: alpha and beta of the cubic oscillator that is linear
LINEAR = (1.0, 0.0)

#: what may be averaged: (6) or (5)
FORCES = ("truncated", "exact")
#: frequencies shown of the equation of motion, whose cycle has ever more stops as Omega tends to 0
EXACT_WINDOW = (0.5, 1.5)


def _exact_kernels() -> ModuleType:
    """The untruncated force's kernels, ten thousand lines that few need: loaded when they are."""
    return importlib.import_module("slowflow_kernels.rod_spring_exact")


class Oscillator:
    """A forced oscillator u'' + 2 zeta u' + u + mu sign(u') + F_k(u) = F_0 cos(Omega tau) (3), averaged.

    Not made directly: see `Isolator` and `Duffing`.
    """

    def __init__(self, kernels: ModuleType, parameters: tuple[float, ...], mu: Any, zeta: Any) -> None:
        self.mu = validate.number("mu", mu, least=0.0)
        self.zeta = validate.number("zeta", zeta, least=0.0)
        self._model = Model(kernels, parameters, self.mu, self.zeta)

    @property
    def sticking_forcing(self) -> float:
        """4 mu/pi: a forcing that does not exceed it leaves the mass at rest (27)."""
        return self._model.m

    @property
    def breakpoints(self) -> tuple[float, ...]:
        """Amplitudes at which the force passes from one piece to the next: (u_cr,), or none."""
        return self._model.breakpoints

    def frequency_response(
        self, F_0: float, samples: int = 1000, Omega: tuple[float, float] = validate.WINDOW
    ) -> FrequencyResponse:
        """The response curve at F_0, every branch and isola, for frequencies in the window `Omega` (24), (25), (30).

        About `samples` points; folds, peaks and corners are among them exactly. Raises ValueError for F_0 <= 0,
        samples < 2, or a window that is not 0 <= low < high. F_0 <= 4 mu/pi gives no point and a message.
        """
        return self._remarked(self._curve(F_0, samples, Omega), F_0)

    def _curve(self, F_0: float, samples: int, Omega: tuple[float, float]) -> FrequencyResponse:
        """`frequency_response` without the remarks on averaging."""
        F_0 = validate.number("F_0", F_0, above=0.0)
        samples = validate.count("samples", samples, least=2)
        shown = validate.window("Omega", Omega)
        planned = self._plan("frequency_response", F_0)
        if planned.model is None:
            none, flags = np.empty(0), np.empty(0, dtype=bool)
            return FrequencyResponse(none, none, flags, self._sticks(F_0), self._model, np.empty(0, np.intp), (), F_0)
        return solvers.frequency_response(planned.model, F_0, samples, shown)

    def amplitudes(self, Omega: Any, F_0: float) -> SteadyStates:
        """Every steady state at the frequency Omega, or at each of an array of frequencies (24), (30).

        Flat arrays .Omega, .A, .phi, .stable, in the order of Omega, then by rising A. Raises ValueError for Omega <= 0
        or F_0 <= 0. F_0 <= 4 mu/pi gives no state and a message.
        """
        return self._remarked(self._states(Omega, F_0), F_0)

    def _states(self, Omega: Any, F_0: float) -> SteadyStates:
        """`amplitudes` without the remarks on averaging."""
        at = validate.positive_array("Omega", Omega).ravel()
        F_0 = validate.number("F_0", F_0, above=0.0)
        planned = self._plan("amplitudes", F_0)
        if planned.model is None:
            none = np.empty(0)
            return SteadyStates(none, none, np.empty(0, dtype=bool), self._sticks(F_0), self._model)
        return solvers.amplitudes(planned.model, at, F_0)

    def saddle_nodes(self, F_0: float) -> SaddleNodes:
        """Every fold of the response curve at F_0, by rising Omega (24), (30). Raises ValueError for F_0 <= 0."""
        return self._remarked(self._folds(F_0), F_0)

    def _folds(self, F_0: float) -> SaddleNodes:
        """`saddle_nodes` without the remarks on averaging."""
        F_0 = validate.number("F_0", F_0, above=0.0)
        planned = self._plan("saddle_nodes", F_0)
        if planned.model is None or not planned.folds:
            none = np.empty(0)
            message = self._sticks(F_0) if planned.model is None else NO_FOLD.format(F_0)
            return SaddleNodes(none, none, np.empty(0, "U9"), np.empty(0, bool), F_0, message, self._model)
        return solvers.saddle_nodes(planned.model, F_0)

    def saddle_node_onset(self) -> SaddleNodeOnset:
        """The lowest forcing F_SN that has a fold, wherever it lies, with its Omega and A (33)."""
        return self._onset

    def detachment(self) -> Detachment:
        """The lowest forcing F_cr that reaches u_cr, and its frequency Omega_cr (34)."""
        return self._detachment

    def peak(self, F_0: float) -> Peak:
        """The highest peak of the response at F_0, isolas included: .A .Omega. Raises ValueError for F_0 <= 0.

        Where the amplitude only falls with Omega it is the static one, with Omega = 0.
        """
        F_0 = validate.number("F_0", F_0, above=0.0)
        planned = self._plan("peak", F_0)
        if planned.model is None:
            return Peak(None, None, F_0, self._sticks(F_0))
        return solvers.peak(planned.model, F_0)

    def fold_locus(self, samples: int = 1000, A_max: float | None = None) -> FoldLocus:
        """The saddle nodes of every forcing, on both sides of u_cr: about `samples` points with A up to A_max (30).

        A_max is the mechanism's reach unless it is given; a mechanism without an end (`Duffing`) needs it. Raises
        ValueError for samples < 2, A_max <= 0 or none where one is needed.
        """
        return solvers.fold_locus(self._model, self._up_to(A_max), validate.count("samples", samples, least=2))

    def cusps(self, A_max: float | None = None) -> Cusps:
        """Where two folds come into being or meet, F = F_A = F_AA = 0; A_max as in `fold_locus`."""
        return solvers.extrema(self._model, self._up_to(A_max))[0]

    def isola_points(self, A_max: float | None = None) -> IsolaPoints:
        """Where isolated curves are born or merge, F = F_A = F_Omega = 0; A_max as in `fold_locus`."""
        return solvers.extrema(self._model, self._up_to(A_max))[1]

    def backbone(self, A: Any) -> Floats:
        """Omega on the backbone at the amplitudes A > 0 (26); nan where the averaged stiffness is negative."""
        A = validate.positive_array("A", A)
        h = self._model.averaged(A)[0]
        with np.errstate(invalid="ignore"):
            return np.asarray(self._model.flow.backbone(A, h))

    def limit_envelope(self, Omega: Any, F_0: float) -> Floats:
        """A_L at the frequencies Omega > 0 (27), which no response exceeds; inf for zeta = 0, 0 where it sticks."""
        Omega = validate.positive_array("Omega", Omega)
        F_0 = validate.number("F_0", F_0, above=0.0)
        if F_0 <= self._model.m:
            return np.zeros_like(Omega)
        if self.zeta == 0:
            return np.full_like(Omega, np.inf)
        return np.asarray(self._model.flow.limit_envelope(Omega, F_0, self._model.m, self.zeta))

    def equivalent_damping(self, Omega: Any, A: Any) -> Floats:
        """zeta_eq at (Omega, A), broadcast: the viscous damping ratio that dissipates as much per cycle (38)."""
        Omega, A = validate.positive_array("Omega", Omega), validate.positive_array("A", A)
        return np.asarray(self._model.flow.equivalent_damping(Omega, A, self._model.m, self.zeta) + 0 * (Omega + A))

    def stability(self, Omega: Any, A: Any) -> Floats:
        """Left side of (30) at (Omega, A), broadcast: a steady state there is stable where it is positive."""
        Omega, A = validate.positive_array("Omega", Omega), validate.positive_array("A", A)
        h, h_A, _, _ = self._model.averaged(A)
        return np.asarray(self._model.flow.stability(Omega, A, self._model.m, self.zeta, h, h_A))

    def explain(self, question: str, F_0: float) -> plan.Plan:
        """What runs for "frequency_response", "amplitudes", "saddle_nodes" or "peak" at F_0, what is skipped, and why.

        Print it. The question itself follows this plan. Raises ValueError for another question or F_0 <= 0.
        """
        if question not in plan.QUESTIONS:
            raise ValueError(f"question = {question!r} is not allowed: it must be one of {', '.join(plan.QUESTIONS)}")
        return self._plan(question, validate.number("F_0", F_0, above=0.0))

    @cached_property
    def _onset(self) -> SaddleNodeOnset:
        return solvers.onset(self._model)

    @cached_property
    def _detachment(self) -> Detachment:
        return solvers.detachment(self._model)

    def _plan(self, question: str, F_0: float) -> plan.Plan:
        # finding the onset costs time too: it serves only where it has been asked for already
        known = self.__dict__.get("_onset")
        return plan.plan(question, F_0, self._model, self._attached_model, self._detachment.F_cr, known)

    @cached_property
    def _attached_model(self) -> Model | None:
        """The first piece alone, where a response to less than F_cr cannot leave it; else None."""
        return None

    def steady_state(
        self, Omega: float, F_0: float, A: float | None = None, *, force: str | None = None
    ) -> exact.SteadyState:
        """A periodic motion of the equation of motion (3) itself: series, harmonics, stops, multipliers, residual.

        A     -- the motion near the averaged state whose amplitude is nearest to A, stable or not, or what that state
                 settles to where there is none; without it the motion that a mass at rest comes to
        force -- "truncated" for (6), "exact" for (5); by default the one that is averaged

        Raises ValueError for parameters out of range, as F_0 <= mu, ArithmeticError if nothing periodic is found.
        """
        from slowflow.exact import questions

        return questions.steady_state(self, Omega, F_0, A, force)

    def exact_response(
        self,
        F_0: float,
        Omega: tuple[float, float] = EXACT_WINDOW,
        *,
        start: exact.SteadyState | None = None,
        step: float = 0.02,
        force: str | None = None,
    ) -> exact.Response:
        """The response curve of the equation of motion (3) in the window `Omega`: points, stability, stops, folds.

        It is the curve through the motion that a mass at rest comes to at the lowest frequency, or through `start`: an
        isolated curve needs its own, `start=steady_state(Omega, F_0, A)`, and where averaging knows of one that this
        is not, `.message` gives these numbers. `step` is the largest distance of neighbouring points, `force` as in
        `steady_state`. `.peak` is the highest motion of the curve.
        Raises ValueError for parameters out of range, as F_0 <= mu, ArithmeticError where it cannot be followed.
        """
        from slowflow.exact import questions

        return questions.exact_response(self, F_0, Omega, start, step, force)

    def sweep(self, F_0: float, Omega: Any, *, tolerance: float = 1e-9, force: str | None = None) -> exact.Sweep:
        """What an experiment sees that steps through the frequencies `Omega` in their order: amplitudes and jumps.

        (u, v) has settled once a turn of the forcing changes it by no more than `tolerance`; `force` as in
        `steady_state`. Raises ValueError for parameters out of range, as F_0 <= mu, ArithmeticError where the motion
        escapes a softening spring.
        """
        from slowflow.exact import questions

        return questions.sweep(self, F_0, Omega, tolerance, force)

    @cached_property
    def second_approximation(self) -> SecondApproximation:
        """The same questions with the higher harmonics of force and friction: closer to the equation of motion.

        Raises ValueError where these harmonics are not derived: for force="exact" with u_cr > 3/4.
        """
        from slowflow.second import SecondApproximation

        kernels = self._model.kernels
        for u_cr in self._model.breakpoints:
            if u_cr > kernels.HARMONICS_UP_TO:
                raise ValueError(
                    f"u_cr = {u_cr:g} is not allowed here: the harmonics of this force are derived for "
                    f"u_cr <= {kernels.HARMONICS_UP_TO:g}"
                )
        return SecondApproximation(self)

    def _restoring_force(self, which: str | None) -> Force:
        """The force for the equation of motion, `which` as in `steady_state`."""
        raise NotImplementedError

    def _up_to(self, A_max: float | None) -> float:
        """The amplitude up to which the fold locus is wanted."""
        if A_max is None and math.isfinite(self._model.reach):
            return self._model.reach
        return validate.number("A_max", A_max, above=0.0)

    def _sticks(self, F_0: float) -> str:
        return f"sticks: F_0 = {F_0:g} does not exceed 4 mu/pi = {self._model.m:g}"

    def _remarked(self, found: Answer, F_0: float) -> Answer:
        """The answer with remarks where averaging fails for friction, and where amplitudes exceed the reach."""
        if F_0 <= self._model.m:
            return found
        remark = words(self._beyond_reach(found.A, found.message), validity.near_sticking(self.mu, F_0))
        return dataclasses.replace(found, message=words(found.message, remark)) if remark else found

    def _beyond_reach(self, A: Floats, message: str) -> str:
        """The remark for amplitudes that the mechanism cannot take; empty for others, and where `message` says it."""
        reach = self._model.reach
        if not A.size or A.max() <= reach or "cut at" in message:
            return ""
        return f"amplitudes above {reach:g} are not reached: {self._model.kernels.REACH_REASON}"


class Isolator(Oscillator):
    """The high-static-low-dynamic-stiffness isolator of (1)-(7), springs leaving the push-rod at u_cr.

    lam     -- number of horizontal springs, > 0
    r       -- stiffness ratio k_h/k_v, > 0
    delta_h -- preload of the horizontal springs over the rod length, in [0, 1); 0 is a linear oscillator, and more than
               1/(lam r) is a negative stiffness at rest, which works with a warning
    mu, zeta -- dry friction and viscous damping ratio, >= 0
    force    -- what is averaged: "truncated" for the fifth-order polynomial (6), which jumps at u_cr, "exact" for the
                force as the geometry gives it (5)
    """

    def __init__(
        self, *, lam: float, r: float, delta_h: float, mu: float = 0.0, zeta: float = 0.0, force: str = "truncated"
    ) -> None:
        self.force = validate.choice("force", force, FORCES)
        self.lam = validate.number("lam", lam, above=0.0)
        self.r = validate.number("r", r, above=0.0)
        self.delta_h = validate.number("delta_h", delta_h, least=0.0, below=1.0)
        parameters = tuple(float(value) for value in rod_spring.coefficients(self.lam, self.r, self.delta_h))
        if self.delta_h == 0:  # the springs never touch the rod
            super().__init__(duffing, LINEAR, mu, zeta)
        else:
            kernels = _exact_kernels() if self.force == "exact" else rod_spring
            own = kernels.coefficients(self.lam, self.r, self.delta_h)
            super().__init__(kernels, tuple(map(float, own)), mu, zeta)
        self.alpha, self.beta, self.gamma, self.u_cr = parameters
        if self.alpha < 0:
            warnings.warn(
                f"delta_h = {self.delta_h:g} exceeds 1/(lam r) = {1 / (self.lam * self.r):g}: "
                f"negative stiffness at rest (alpha = {self.alpha:g}); the averaged motion is about u = 0",
                stacklevel=2,
            )

    @cached_property
    def _attached_model(self) -> Model | None:
        # While f(u)/u rises with |u| so does -h/A with A, and with both the least forcing that holds an amplitude: once
        # F_0 < F_cr leaves u_cr out of reach, it leaves all above out too. A negative averaged stiffness breaks this.
        model = self._model
        hardens = self.beta >= 0 and self.gamma >= 0 and all(jump <= 0 for jump in model.jumps)
        if (
            self.force == "exact"
            or not model.breakpoints
            or not hardens
            or model.averaged(model.breakpoints[0])[0] >= 0
        ):
            return None
        return Model(rod_spring_attached, model.parameters, self.mu, self.zeta, attached=True)

    def __repr__(self) -> str:
        force = "" if self.force == "truncated" else f", force={self.force!r}"
        return f"Isolator(lam={self.lam}, r={self.r}, delta_h={self.delta_h}, mu={self.mu}, zeta={self.zeta}{force})"

    def _restoring_force(self, which: str | None) -> Force:
        from slowflow.exact import force

        if validate.choice("force", which or self.force, FORCES) == "exact":
            return force.rod_spring_exact(self.lam, self.r, self.delta_h)
        return force.rod_spring(self.alpha, self.beta, self.gamma, self.u_cr)

    @classmethod
    def many(
        cls, *, lam: Any, r: Any, delta_h: Any, mu: Any = 0.0, zeta: Any = 0.0, force: str = "truncated"
    ) -> Designs:
        """Many isolators at once, from arrays that broadcast; see `slowflow.many`.

        Raises ValueError for what is no real array and for shapes that do not broadcast, and nothing for a single
        design: each answer has a status.
        """
        suffix = "_exact" if validate.choice("force", force, FORCES) == "exact" else ""
        values = {"lam": lam, "r": r, "delta_h": delta_h, "mu": mu, "zeta": zeta}
        return Designs(partial(cls, force=force), "rod_spring" + suffix, values)


class Duffing(Oscillator):
    """u'' + 2 zeta u' + mu sign(u') + alpha u + beta u^3 = F_0 cos(Omega tau).

    alpha, beta -- linear and cubic stiffness; softening (beta < 0) and alpha <= 0 are allowed
    mu, zeta    -- dry friction and viscous damping ratio, >= 0
    """

    def __init__(self, alpha: float, beta: float, mu: float = 0.0, zeta: float = 0.0) -> None:
        self.alpha = validate.number("alpha", alpha)
        self.beta = validate.number("beta", beta)
        super().__init__(duffing, (self.alpha, self.beta), mu, zeta)

    def __repr__(self) -> str:
        return f"Duffing(alpha={self.alpha}, beta={self.beta}, mu={self.mu}, zeta={self.zeta})"

    def _restoring_force(self, which: str | None) -> Force:
        from slowflow.exact import force

        # its force is a polynomial: nothing was truncated
        validate.choice("force", which or "exact", FORCES)
        return force.duffing(self.alpha, self.beta)

    @classmethod
    def many(cls, alpha: Any, beta: Any, mu: Any = 0.0, zeta: Any = 0.0) -> Designs:
        """Many Duffing oscillators at once, as `Isolator.many`."""
        return Designs(cls, "duffing", {"alpha": alpha, "beta": beta, "mu": mu, "zeta": zeta})
