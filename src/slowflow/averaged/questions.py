"""Averaged results of one oscillator: response curves, folds, critical forces.

All quantities are dimensionless, as in (4): displacements are divided by L, forces by k_v L, frequencies by
sqrt(k_v/m).
"""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from slowflow.answers.answer import joined
from slowflow.answers.questions import Questions
from slowflow.answers.results import (
    DRAWN,
    NOTHING,
    Cusps,
    Detachment,
    FoldLocus,
    FrequencyResponse,
    IsolaPoints,
    Peak,
    Remark,
    SaddleNodeOnset,
    SaddleNodes,
    SteadyStates,
)
from slowflow.averaged import diagnostics, messages, pairs, plan, proofs, solvers
from slowflow.averaged.defined import check_defined
from slowflow.core import validate
from slowflow.core.model import Floats, Model
from slowflow.support.errors import OutOfRange, Refused
from slowflow_kernels import dissipation, slow_flow
from slowflow_kernels.domains import DISSIPATION

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from slowflow.answers.certificate import Certificate, ProvedFolds
    from slowflow.core.mechanism import Reals

State = TypeVar("State", FrequencyResponse, SteadyStates)
NONE = np.empty(0)
#: of a peak: where the next lower one is looked for, by more than roundings below it
JUST_BELOW = 1 - 2.0**-30
#: of Newton's method
MOST_STEPS = 200

Answer = TypeVar("Answer", FrequencyResponse, SteadyStates, SaddleNodes, SaddleNodeOnset, Detachment, Peak)


@validate.methods_check_arguments()
class Averaged(Questions[SteadyStates, FrequencyResponse, SaddleNodes]):
    """A forced oscillator u'' + 2 zeta u' + mu sign(u') + f(u) = F_0 cos(Omega tau) (3), averaged.

    model    -- its slow flow
    mu, zeta -- dry friction over k_v L, and viscous damping ratio

    F_0 is the amplitude of the excitation. For base excitation and unbalance the force is F_0 Omega^2, and u is the
    displacement relative to the base.
    """

    model: Model
    mu: float
    zeta: float
    #: what measures answers against the equation of motion, where that is known
    _equation: Any = None
    #: what finds the folds of several forcings together, where that takes less time
    _folds_at: Any = None

    def __init__(self, model: Model) -> None:
        check_defined(model)
        # not by attribute: what inherits from this cannot be changed
        self.__dict__.update(model=model, mu=model.mu, zeta=model.zeta)

    @property
    def sticking_forcing(self) -> float:
        """Amplitude of the excitation up to which a mass at rest sticks at every frequency: 4 mu/pi (27).

        With a preload c sign(u) it is 4/pi sqrt(mu^2 + c^2), the limit of F_0 as A tends to 0; above 4 mu/pi, with
        contact="attached" even below, motions may coexist with the mass at rest, and a message reports them. It is 0
        for base excitation and unbalance, which move the mass from Omega = sqrt(4 mu/(pi F_0)) on, however small they
        are.
        """
        return 0.0 if self.model.inertial else self.model.break_loose

    @property
    def breakpoints(self) -> tuple[float, ...]:
        """Amplitudes at which the force passes from one piece to the next: (u_cr,), or none."""
        return self.model.breakpoints

    def _frequency_response(self, F_0: float, samples: int, window: tuple[float, float]) -> FrequencyResponse:
        return self._remarked(self.curve(F_0, samples=samples, Omega=window), F_0)

    def curve(
        self, F_0: float, *, samples: int, Omega: tuple[float, float], allowance: proofs.Allowance | None = None
    ) -> FrequencyResponse:
        """`frequency_response` without the diagnostics of averaging, as a start for other approximations."""
        found = solvers.frequency_response(self.model, F_0, samples, Omega)
        return self._centred(proofs.decided_curve(found, self.model, Omega, allowance))

    def _amplitudes(self, at: Floats, F_0: float, allowance: proofs.Allowance | None = None) -> SteadyStates:
        return self._with_rests(self._remarked(self.states(Omega=at, F_0=F_0, allowance=allowance), F_0), at)

    def _at_pairs(self, Omega: Any, F_0: Any) -> SteadyStates:
        ask = functools.partial(self._amplitudes, allowance=proofs.Allowance())
        found = pairs.at_pairs(ask, Omega, F_0, ("Omega", "A", "stable"))
        equation = found.answers[-1]._equation if found.answers else None
        return SteadyStates(**found.columns, F_0=found.F_0, **found.notes(), _model=self.model, _equation=equation)

    def _with_rests(self, found: SteadyStates, Omega: Any) -> SteadyStates:
        """The states with those at which friction holds the mass."""
        if found.F_0 > self.model.break_loose and not self.model.inertial:
            return found
        at = validate.frequencies("Omega", Omega).ravel()
        sticks = self.model.sticks_at(found.F_0, at)
        if not sticks.any():
            return found
        columns = {"Omega": (found.Omega, at[sticks]), "A": (found.A, 0.0), "stable": (found.stable, True)}
        message = messages.moves_exactly(self.model, self.model.force(found.F_0, at))
        merged: dict[str, Any] = pairs.with_rests(at, sticks, found.Omega, columns)
        return dataclasses.replace(found, **merged, message=joined(found.message, message))

    def states(self, *, Omega: Reals, F_0: float, allowance: proofs.Allowance | None = None) -> SteadyStates:
        """`amplitudes` of moving masses without the diagnostics of averaging, as a start for other approximations."""
        at = validate.frequencies("Omega", Omega).ravel()
        allowance = allowance or proofs.Allowance()
        try:
            found = solvers.states(self.model, at, F_0)
        except OverflowError:
            raise
        except ArithmeticError:  # branches coincide within rounding
            found = proofs.nothing_decided(self.model, at, F_0)
            if (by_balls := proofs.decided_states(found, self.model, at, F_0, allowance)) is found:
                raise
            return self._centred(by_balls)
        return self._centred(proofs.decided_states(found, self.model, at, F_0, allowance))

    def at_centre(self, question: str) -> None:
        """Raise Refused for a question that has no answer under a load; here there is none."""

    def _check_proof(self) -> None:
        """Raises ValueError where no proof of the averaged equations is derived."""
        validate.has_proof(self.model.excitation, self.model.laws.description())

    def _check_envelope(self) -> None:
        """Raises ValueError where no envelope is derived."""
        laws = [one.name for one in DISSIPATION]
        validate.is_plain("limit_envelope", self.model.laws.description(*laws), *laws)

    def _saddle_nodes(self, F_0: float) -> SaddleNodes:
        return self._remarked(self.folds(F_0), F_0)

    def certify(self, F_0: float, *, Omega: float | None = None) -> Certificate:
        """Prove in interval arithmetic all folds at F_0, F_SN, F_cr, and all states at a frequency.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.
        Omega : float, optional
            Frequency of the states, > 0 and <= 1e40.

        Returns
        -------
        Certificate
            Enclosures, and whether each is proved, for the oscillator whose parameters are exactly the given doubles.
            Where intervals of doubles are inconclusive, ball arithmetic is used, with python-flint
            (`pip install 'slowflow[proofs]'`); `bits` is the precision used.

        Raises
        ------
        ValueError
            For an invalid number, for base excitation and unbalance, and for damping laws other than mu and zeta.
        """
        self.at_centre("certify")
        self._check_proof()
        found = self.saddle_nodes(F_0)
        states = None
        if Omega is not None:
            (at,) = validate.frequencies("Omega", validate.number("Omega", Omega)).ravel()
            states = proofs.states(self.model, found.F_0, float(at))
        folds = self._proved_folds(found)
        from slowflow.answers.certificate import Certificate

        return Certificate(found.F_0, folds, proofs.onset(self.model), proofs.detachment(self.model), states)

    def _proved_folds(self, found: SaddleNodes) -> ProvedFolds:
        """What is proved of an answer's folds."""
        proof = proofs.folds(self.model, found.F_0)
        if not proof.proved or len(proof.A) == len(found):
            return proof
        note = f"{len(proof.A)} folds are proved, saddle_nodes gives {len(found)}"
        return dataclasses.replace(proof, message=joined(proof.message, note))

    def folds(self, F_0: float, *, allowance: proofs.Allowance | None = None) -> SaddleNodes:
        """`saddle_nodes` without the diagnostics of averaging, as a start for other approximations."""
        # finding the onset costs time too: it is used only if it is known already
        if plan.may_have_folds(F_0, self.model, self.__dict__.get("_onset")):
            return proofs.decided(solvers.folds(self.model, F_0), self.model, allowance)
        message, _ = messages.of_folds(self.model, F_0, False, "")
        none: dict[str, Any] = {"Omega": NONE, "A": NONE, "kind": np.empty(0, "U9"), "corner": np.empty(0, bool)}
        return SaddleNodes._made(**none, F_0=F_0, message=message, remarks=NOTHING, _model=self.model)

    def _saddle_node_onset(self) -> SaddleNodeOnset:
        # not as a cached property: in Python 3.11 its lock takes longer than all diagnostics
        if (known := self.__dict__.get("_onset")) is None:
            known = self.__dict__["_onset"] = self._onset_with_words()
        return known

    def _onset_with_words(self) -> SaddleNodeOnset:
        return self._remarked(self.onset(), math.nan)

    def _detachment(self) -> Detachment:
        if (known := self.__dict__.get("_detached")) is None:
            solves = not plan.needs_no_solver("detachment", self.model)
            found = solvers.detachment(self.model) if solves else Detachment(None, None, None, messages.NO_DETACHMENT)
            known = self.__dict__["_detached"] = self._remarked(found, math.nan)
        return known

    def _peak(self, F_0: float) -> Peak:
        found = solvers.peak(self.model, F_0)
        while found.A is not None and not self.model.stays_centred:
            if not diagnostics.turns_beyond(self.model, found.A):
                break
            found = solvers.peak(self.model, F_0, JUST_BELOW * found.A)
        if not self.model.sticks(F_0) and (diagnostics.of_one_gives_way(self.model) or found._escapes):
            found = dataclasses.replace(found, remarks=Remark.BEYOND_WELL)
        return self._remarked(found, F_0)

    def _is_detached(self, states: SteadyStates) -> Any:
        """Which motions pass the first breakpoint."""
        return states.A > self.breakpoints[0]

    def transmissibility_floor(self, F_0: float) -> float:
        """Compute the limit of the transmissibility as Omega tends to infinity: 4 mu/(pi F_0) under a force.

        Under a force only friction and a preload are transmitted in this limit. Under base excitation and
        unbalance the limit is 0, or 8 c_2 A^2/(3 pi F_0) with quadratic damping, which grows with Omega^2 like the
        force; A is the limit of the amplitude.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.

        Returns
        -------
        float
            A ratio, dimensionless.

        Raises
        ------
        ValueError
            For F_0 <= 0.
        """
        return float(self.model.floor(validate.number("F_0", F_0, above=0.0)))

    def closes(self, F_0: float) -> bool:
        """Determine whether the response at F_0 is known to have a largest amplitude.

        A response has none if friction is the only damping, if a hardening spring does not end the resonance under a
        large base motion, or if a user-defined force softens up to its reach.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.

        Returns
        -------
        bool
            True also if the mass sticks.

        Raises
        ------
        ValueError
            For F_0 <= 0.
        """
        F_0 = validate.number("F_0", F_0, above=0.0)
        if self.model.sticks(F_0):
            return True
        return not self.model.undamped and solvers.closes(self.model, F_0)

    def fold_locus(self, *, samples: int = 1000, A_max: float | None = None) -> FoldLocus:
        """Trace the saddle nodes of every forcing, F_A = 0 (30), on both sides of u_cr.

        Parameters
        ----------
        samples : int
            Approximate number of points, 2 to 10^6.
        A_max : float, optional
            Largest amplitude, > 0, over L; by default the mechanism's reach. Required for a mechanism without reach,
            such as `Duffing`.

        Returns
        -------
        FoldLocus
            .Omega .A .F_0 .branch, shape (n,).

        Raises
        ------
        ValueError
            For an invalid number, or a missing A_max.
        """
        samples = validate.count("samples", samples, least=2, most=validate.MOST_SAMPLES)
        return solvers.fold_locus(self.model, self._up_to(A_max, "fold_locus"), samples)

    def cusps(self, *, A_max: float | None = None) -> Cusps:
        """Find where two folds merge as the forcing changes, F = F_A = F_AA = 0.

        Within a unit in the last place of a singularity of the force, double precision gives few digits; ball
        arithmetic gives more, with python-flint, in up to a second. `Remark.UNDECIDED` marks cusps for which it does
        not.

        Parameters
        ----------
        A_max : float, optional
            Largest amplitude, as in `fold_locus`.

        Returns
        -------
        Cusps
            .F_0 .Omega .A .minimum, shape (n,).
        """
        limit = self._up_to(A_max, "cusps")
        found = proofs.decided_cusps(solvers.extrema(self.model, limit)[0], self.model, limit)
        return dataclasses.replace(found, _model=self.model)

    def isola_points(self, *, A_max: float | None = None) -> IsolaPoints:
        """Find where isolated curves are born or merge as the forcing changes, F = F_A = F_Omega = 0.

        Parameters
        ----------
        A_max : float, optional
            Largest amplitude, as in `fold_locus`.

        Returns
        -------
        IsolaPoints
            .F_0 .Omega .A .kind, shape (n,).
        """
        limit = self._up_to(A_max, "isola_points")
        return dataclasses.replace(solvers.extrema(self.model, limit)[1], _model=self.model)

    @np.errstate(all="ignore")
    def backbone(self, A: Reals) -> Floats:
        """Compute the frequency on the backbone, sqrt(-h/A) (26).

        Parameters
        ----------
        A : array_like
            Amplitudes, > 0, over L.

        Returns
        -------
        ndarray
            Omega in the shape of A; nan where the averaged stiffness is negative.
        """
        A = validate.positive_array("A", A)
        h = self.model.averaged(A)[0]
        return np.asarray(slow_flow.backbone(A, h))

    @np.errstate(all="ignore")
    def limit_envelope(self, *, Omega: Reals, F_0: Reals) -> Floats:
        """Compute the amplitude A_L that no response exceeds at (Omega, F_0) (27).

        Parameters
        ----------
        Omega, F_0 : array_like
            Frequencies and amplitudes of the excitation, > 0, that broadcast.

        Returns
        -------
        ndarray
            A_L in their common shape; inf for zeta = 0, 0 where the mass sticks.

        Raises
        ------
        ValueError
            For contact="attached": beyond u_cr the friction term of I decreases, and I = F_0 has no closed form.
        """
        self.at_centre("limit_envelope")
        self._check_envelope()
        Omega, F_0 = validate.positive_array("Omega", Omega), validate.positive_array("F_0", F_0)
        shape = validate.common_shape({"Omega": Omega, "F_0": F_0})
        force = self.model.force(F_0, Omega)
        bounded = np.inf
        if self.model.laws.any:
            model, eta = self.model, self.model.laws.eta
            bounded = dissipation.limit_envelope(Omega, force, model.m, self.zeta, eta, model.d)
            # with c_3 or zeta_2 it lies above: I is convex in A, so that Newton's method falls to where I = F_0
            for _ in range(MOST_STEPS if model.laws.c_3 + model.laws.zeta_2 > 0 else 0):
                (zeta, zeta_A, *_), above = model.viscous(bounded), bounded
                excess = dissipation.I(Omega, above, model.m + eta * above, zeta, model.d, model.d_3) - force
                bounded = above - excess / dissipation.I_A(Omega, above, eta, zeta, zeta_A, model.d, model.d_3)
                if np.all(bounded >= above):
                    break
        elif self.zeta != 0:
            bounded = slow_flow.limit_envelope(Omega, force, self.model.m, self.zeta)
        return np.broadcast_to(np.where(force <= self.model.m, 0.0, bounded), shape).copy()

    @np.errstate(all="ignore")
    def equivalent_damping(self, *, Omega: Reals, A: Reals) -> Floats:
        """Compute zeta_eq, the viscous damping ratio that dissipates as much per cycle (38).

        Parameters
        ----------
        Omega, A : array_like
            Frequencies and amplitudes, > 0, that broadcast.

        Returns
        -------
        ndarray
            In their common shape.

        Raises
        ------
        OverflowError
            Where a part of it exceeds the range of doubles.
        """
        Omega, A = validate.positive_array("Omega", Omega), validate.positive_array("A", A)
        of_laws = self.model.equivalent_damping(Omega, A)
        damping = slow_flow.equivalent_damping(Omega, A, *of_laws) + 0 * (Omega + A)
        return _in_range("the equivalent damping", damping)

    @np.errstate(all="ignore")
    def stability(self, *, Omega: Reals, A: Reals) -> Floats:
        """Compute the left side of (30): a steady state at (Omega, A) is stable where it is positive.

        Parameters
        ----------
        Omega, A : array_like
            Frequencies and amplitudes, > 0, that broadcast.

        Returns
        -------
        ndarray
            In their common shape.

        Raises
        ------
        OverflowError
            Where a part of it exceeds the range of doubles.
        """
        Omega, A = validate.positive_array("Omega", Omega), validate.positive_array("A", A)
        return _in_range("the left side of (30)", self.model.stability(Omega, A))

    def plot(
        self,
        F_0: Reals,
        *,
        Omega: tuple[float, float] = validate.WINDOW,
        of: str = "A",
        ax: Axes | None = None,
    ) -> Axes:
        """Draw the response at one forcing, or at each of several, into Matplotlib axes.

        Stable states are solid, unstable ones dashed; folds are triangles that point in the direction of the jump. For
        the amplitude, the regions beyond u_cr and with stick phases, A Omega^2 < mu, are shaded.

        Parameters
        ----------
        F_0 : float or sequence of float
            Amplitudes of the excitation, > 0, dimensionless.
        Omega : tuple of float
            Window of frequencies.
        of : str
            Quantity plotted over Omega: "A" (under a load .u_max), "phi", "transmissibility" or "transmissibility_dB".
        ax : matplotlib.axes.Axes, optional
            Where to draw; new axes by default.

        Returns
        -------
        matplotlib.axes.Axes
            The axes.

        Raises
        ------
        ValueError
            As `frequency_response`.
        ImportError
            Without Matplotlib.
        """
        from slowflow.answers import pictures

        forcings = validate.several("F_0", F_0)
        validate.choice("of", of, DRAWN)
        found = [(self.frequency_response(F, Omega=Omega), self.saddle_nodes(F)) for F in forcings]
        drawn = pictures.height(found[0][0]) if of == "A" else of
        ax = pictures.responses(ax, found, drawn)
        pictures.window(ax, *Omega)
        if of == "A":
            pictures.breakpoints(ax, self.breakpoints)
        if drawn == "A":
            pictures.stopping(ax, self.mu)
        pictures.legend(ax, "$F_0$")
        return ax

    def explain(self, question: str, F_0: float | None = None) -> plan.Plan:
        """List the steps of a question: which run, which are skipped, and why; the question itself follows this plan.

        Parameters
        ----------
        question : str
            Its name, such as "saddle_nodes".
        F_0 : float, optional
            Amplitude of the excitation, > 0. Required by questions at one forcing, such as "saddle_nodes", "margins" or
            "exact_response"; not accepted by those about all forcings, such as "saddle_node_onset", or by those that
            take rows or pulses, such as "spectrum" or "transient".

        Returns
        -------
        Plan
            Printing shows the steps.

        Raises
        ------
        ValueError
            For an unknown question, F_0 <= 0, and a missing or unexpected F_0.
        """
        if question not in plan.QUESTIONS:
            allowed = f"{', '.join(plan.QUESTIONS)}{validate.meant(question, plan.QUESTIONS)}"
            raise Refused(f"question = {question!r} is not allowed: it must be one of {allowed}")
        if question == "certify":
            self._check_proof()
        if question == "limit_envelope":
            self._check_envelope()
        return plan.plan(question, plan.forcing(question, F_0), self.model, self.__dict__.get("_onset"))

    def onset(self, allowance: proofs.Allowance | None = None) -> SaddleNodeOnset:
        """`saddle_node_onset` without the diagnostics of averaging, as a start for other approximations."""
        if plan.needs_no_solver("saddle_node_onset", self.model):
            return SaddleNodeOnset(None, None, None, "", messages.NO_ONSET)
        try:
            return solvers.onset(self.model)
        except OverflowError:
            raise
        except ArithmeticError:
            if (by_balls := proofs.decided_onset(self.model, allowance)) is None:
                raise
            return by_balls

    def _up_to(self, A_max: float | None, question: str) -> float:
        """The amplitude up to which a question about all forcings is answered."""
        self.at_centre(question)
        if A_max is None:
            if math.isinf(self.model.reach):
                raise Refused(f"{question} needs A_max, the largest amplitude: this force has no reach")
            return self.model.reach
        return validate.number("A_max", A_max, above=0.0)

    def _centred(self, found: State) -> State:
        """The answer, its states stable only if they stay about u = 0, and within its well, as well.

        They are looked at where that is not known beforehand.
        """
        if self.model.stays_centred:
            return found
        kept = diagnostics.keeps_centre(self.model, found.Omega, found.A)
        beyond = diagnostics.turns_beyond(self.model, found.A)
        drifts = NOTHING if kept.all() else Remark.LEAVES_CENTRE
        swings = Remark.BEYOND_WELL if beyond.any() else NOTHING
        stable = found.stable & kept & ~beyond
        return dataclasses.replace(found, stable=stable, remarks=found.remarks | drifts | swings)

    def _remarked(self, found: Answer, F_0: float) -> Answer:
        """The answer with its message and diagnostics; F_0 is NaN where the question has none."""
        # an answer does not change; this one has not been given yet
        own = found.__dict__
        own["_model"], own["_equation"] = self.model, self._equation
        if not self.model.sticks(F_0):
            known = own.pop("message", None), own.pop("remarks"), own.get("_later")
            own["_later"] = functools.partial(_messages, self.model, F_0, *known)
            if self.model.mechanism.enclosed is not None:  # its averages may not settle: that is said here and now
                getattr(found, "message")  # noqa: B009
        return found


def _messages(
    model: Model, F_0: float, message: str | None, codes: Remark, makes: Any, found: Answer
) -> dict[str, str | Remark]:
    """The message and diagnostics of an answer, made when they are read; `makes` makes the message if there is none."""
    centred = isinstance(found, SteadyStates)  # `_centred` has looked at these
    remarks = diagnostics.of_one(model, F_0, *_states(found), centred=centred) | codes
    text = makes(found)["message"] if message is None else message
    return {"message": joined(text, *diagnostics.messages(remarks, model, F_0)), "remarks": remarks}


def _in_range(what: str, values: Any) -> Floats:
    """The values, infinite ones included; OverflowError where one is the difference of two such."""
    found = np.asarray(values)
    if np.isnan(found).any():
        raise OutOfRange(f"{what} cannot be evaluated there: intermediate values exceed the range of doubles")
    return found


def _states(found: Any) -> tuple[Any, Any, Any]:
    """Omega and A of an answer's states, NaN for none, and of folds which sit on a corner, None of others."""
    if isinstance(found, SaddleNodeOnset) and found.A is not None:
        return found.Omega, found.A, found.kind == "corner"
    if isinstance(found, SaddleNodes):
        return found.Omega, found.A, found.corner
    if isinstance(found, Detachment):
        return (np.nan, np.nan, None) if found.F_cr is None else (found.Omega_cr, found.u_cr, None)
    return (np.nan, np.nan, None) if found.A is None else (found.Omega, found.A, None)
