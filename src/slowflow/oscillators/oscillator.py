"""Oscillators: averaged results, second approximation and exact motions.

Averaged results are methods of `Averaged`, from which oscillators inherit.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, Concatenate, Generic, ParamSpec, Protocol, Self, TypeVar, overload

import numpy as np

from slowflow.answers.answer import joined, sentences
from slowflow.answers.results import Remark, SaddleNodeOnset
from slowflow.answers.table import IN_TIME
from slowflow.averaged.composed import ComposedQuestions
from slowflow.averaged.plan import OFF_CENTRE, plan_off_centre
from slowflow.averaged.questions import Averaged
from slowflow.core import validate
from slowflow.core.mechanism import EquationOfMotion, Floats, Force, Mechanism, followed
from slowflow.core.model import CENTRED, THROUGHOUT, WITH_MEAN, Laws, Loaded, Model, off_centre_by
from slowflow.support.errors import Refused
from slowflow.support.immutable import Unchanging
from slowflow.support.text import Sentence, text
from slowflow_kernels.domains import EXCITATIONS

if TYPE_CHECKING:
    from slowflow import exact
    from slowflow.averaged import checks
    from slowflow.averaged.plan import Plan
    from slowflow.core.mechanism import Reals, Unlabelled
    from slowflow.exact.questions import Motions
    from slowflow.grid.many import Designs
    from slowflow.off_centre.answers import RestPositions
    from slowflow.off_centre.questions import OffCentre
    from slowflow.random_vibration.answers import RandomResponse
    from slowflow.second import SecondApproximation

P = ParamSpec("P")
R = TypeVar("R", covariant=True)
if TYPE_CHECKING:

    class Many(Protocol[P, R]):
        """What makes designs of plain arrays, and of arrays with named axes or in blocks a `Grid`."""

        @overload
        def __call__(self, *arguments: P.args, **named: P.kwargs) -> R: ...
        @overload
        def __call__(self, *labelled: Any, **named: Any) -> Any: ...

    class of_arrays_or_labelled(Generic[P, R]):
        """A classmethod that is `Many` to type checkers."""

        def __init__(self, method: Callable[Concatenate[Any, P], R]) -> None: ...
        def __get__(self, one: object, kind: object = None) -> Many[P, R]: ...

else:
    of_arrays_or_labelled = classmethod

#: frequencies shown of the equation of motion, whose cycle has ever more stops as Omega tends to 0
EXACT_WINDOW = (0.5, 1.5)

#: the force of the equation of motion: (6), or (5)
FORCES = ("truncated", "untruncated")

#: arguments that an oscillator's repr leaves out
DEFAULTS = (("force", FORCES[0]), ("excitation", "force"))

LESS_THAN_MU = "{mu_s = :r} is not allowed: static friction must be at least {mu = :r}"
WITHOUT_TRUNCATION = Sentence("without truncation {F_SN = :.4g}, a {kind:s}")


@validate.methods_check_arguments()
class Oscillator(Unchanging, ComposedQuestions, Averaged):
    """A forced oscillator u'' + 2 zeta u' + mu sign(u') + f(u) = F_0 cos(Omega tau) (3), dimensionless.

    Parameters
    ----------
    mechanism : Mechanism
        The record of its restoring force, `MECHANISM` of a module of `slowflow_kernels`.
    mu, zeta : float
        Dry friction over k_v L, and viscous damping ratio, >= 0.
    eta, c_2, c_3, zeta_2 : float
        Structural damping, the loss factor of the vertical spring; quadratic damping c_2 |u'|u', over m/L, and cubic
        damping c_3 u'^3; viscous damping that grows with the displacement, 2 (zeta + zeta_2 u^2) u'. All >= 0; the
        last two need zeta > 0.
    contact : {"throughout", "attached"}
        Where dry friction acts: at all u, or for |u| below the first breakpoint only.
    mu_s : float
        Static friction over k_v L, >= mu: it holds a mass at rest in exact motions; averaging does not use it.
    excitation : {"force", "base", "unbalance"}
        The excitation of amplitude F_0: a force over k_v L, a displacement of the base over L, or a rotating mass times
        its radius over m L. The last two act as forces F_0 Omega^2; they require c_3 = 0 and at least one of zeta, eta
        and c_2 > 0, and have no proofs. A base whose acceleration has a constant amplitude a acts as a force, F_0 = m
        a/(k_v L).
    load : float
        Static load over k_v L in addition to the load that the vertical spring carries at the centre. Motions then have
        a mean displacement; questions that do not support it raise ValueError, see `off_centre`.
    **design : float
        The parameters that `mechanism.design` names, each within its domain.

    Raises
    ------
    ValueError
        For a number outside its domain.
    TypeError
        For a name that is missing or unknown.

    Notes
    -----
    With eta, c_2, c_3, zeta_2 or contact="attached" there are no proofs and no second approximation; with eta > 0,
    which is defined at one frequency, there are no shocks and no random vibration. Oscillators are immutable: each
    parameter can be read by its name, and `replace` returns a changed copy.
    """

    stays = "oscillators are immutable"
    instead = "replace({}=...) makes another"

    given: dict[str, Any]
    design: tuple[float, ...]
    eta: float
    c_2: float
    c_3: float
    zeta_2: float
    contact: str
    mu_s: float
    excitation: str
    load: float

    def __init__(
        self,
        mechanism: Mechanism,
        *,
        mu: float = 0.0,
        zeta: float = 0.0,
        eta: float = 0.0,
        c_2: float = 0.0,
        c_3: float = 0.0,
        zeta_2: float = 0.0,
        contact: str = THROUGHOUT,
        mu_s: float = 0.0,
        excitation: str = "force",
        load: float = 0.0,
        **design: float,
    ) -> None:
        values = {**design, "mu": mu, "zeta": zeta}
        laws = Laws.of(contact, eta=eta, c_2=c_2, c_3=c_3, zeta_2=zeta_2)
        known_as = validate.excitation(excitation, tuple(EXCITATIONS))
        if not mechanism.odd:  # nothing is averaged about the centre, which these would be asked of
            self._check_offset(off_centre_by(mechanism, 0.0), laws)
        super().__init__(Model.of(mechanism, values, known_as, laws))
        model = self.model
        own = dict(zip(mechanism.design_names, model.design, strict=True))
        arguments = {"mechanism": mechanism, **own, "mu": model.mu, "zeta": model.zeta, "excitation": excitation}
        # not by attribute: these cannot be set
        self.__dict__.update(zip(mechanism.parameter_names, model.parameters, strict=True))
        self.__dict__.update(
            own, design=model.design, given={**arguments, **laws.present}, excitation=known_as, load=0.0
        )
        self.__dict__.update(laws.numbers, contact=laws.contact, mu_s=model.mu)
        if isinstance(mu_s, np.ndarray) or mu_s != 0:
            if not (static := validate.number("mu_s", mu_s, least=0.0)) >= self.mu:
                raise Refused(text(LESS_THAN_MU, static, self.mu))
            self.given["mu_s"] = self.__dict__["mu_s"] = static
        if isinstance(load, np.ndarray) or load != 0 or not mechanism.odd:
            self._put(load)

    def _put(self, load: float) -> None:
        """Offset the motion by a load or by a force that is not odd: the slow flow about the centre is gone then."""
        load = validate.number("load", load)
        why = off_centre_by(self.model.mechanism, load)
        self._check_offset(why, self.model.laws)
        if load != 0:
            self.given["load"] = self.__dict__["load"] = load
        self.__dict__["model"] = Loaded(self.model, load)
        self.off_centre  # noqa: B018  refuses a force that nothing is derived for

    @staticmethod
    def _check_offset(question: str, laws: Laws) -> None:
        """Refuse laws that are not derived for offset motions, of which |u| passes u_cr on one side only."""
        validate.is_plain(question, laws.description(*WITH_MEAN), *WITH_MEAN)

    @property
    def _off_centre_by(self) -> str:
        """What gives motions a mean displacement; "" for nothing."""
        return off_centre_by(self.model.mechanism, self.load) if isinstance(self.model, Loaded) else ""

    @cached_property
    def _off_centre(self) -> OffCentre:
        """`off_centre` for equilibria, in which friction has no part, whatever its law."""
        from slowflow.off_centre.questions import OffCentre

        return OffCentre(self.model.unloaded if isinstance(self.model, Loaded) else self.model, self.load, self)

    @property
    def off_centre(self) -> OffCentre:
        """Questions about offset motions, with a mean displacement B: all equilibria, states and folds.

        Also without a load: a mass in a double well, or on a softening spring, may leave the centre by itself. Raises
        ValueError for a force whose offset motions are not derived, and for friction that ends at u_cr.
        """
        self._check_offset("off_centre", self.model.laws)
        return self._off_centre

    def at_centre(self, question: str) -> None:
        if self._off_centre_by:
            raise validate.NotAvailable(CENTRED.format(question, self._off_centre_by))

    @property
    def _system(self) -> Any:
        """The system that answers: under a load `off_centre`, with the mean B."""
        return self.off_centre if isinstance(self.model, Loaded) else self

    def rest(self) -> RestPositions:
        """Find every equilibrium under the load, without friction: .u .stiffness .stable; see `OffCentre.rest`."""
        return self._off_centre.rest()

    def explain(self, question: str, F_0: float | None = None) -> Plan:
        if question in IN_TIME:
            validate.is_in_time(question, self.model.laws.present)
        if not self._off_centre_by:
            return super().explain(question, F_0)
        if question not in OFF_CENTRE:
            self.at_centre(question)
        return plan_off_centre(question, F_0, self.off_centre.model.unloaded)

    def replace(self, **changes: Any) -> Self:
        """Return a copy with some of its arguments changed, by name."""
        return type(self)(**{**self.given, **changes})

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Oscillator) and self.given == other.given

    def __hash__(self) -> int:
        return hash((type(self), *self.given.values()))

    def __reduce__(self) -> tuple[Any, ...]:
        return _remade, (type(self), self.given)

    def __repr__(self) -> str:
        # a mechanism by its name
        arguments = {name: getattr(value, "name", value) for name, value in self.given.items()}
        shown = (f"{name}={value!r}" for name, value in arguments.items() if (name, value) not in DEFAULTS)
        return f"{type(self).__name__}({', '.join(shown)})"

    def force(self, u: Reals) -> Floats:
        """Compute the averaged restoring force f(u) (3) at displacements u of any shape, dimensionless."""
        return self.restoring_force()(validate.finite_array("u", u))

    def stiffness(self, u: Reals) -> Floats:
        """Compute df/du at displacements u of any shape, dimensionless; at a breakpoint that of the inner piece."""
        return self.restoring_force().stiffness(validate.finite_array("u", u))

    def _onset_with_words(self) -> SaddleNodeOnset:
        found = super()._onset_with_words()
        if self.model.mechanism.load_untruncated is not None:
            own = found.__dict__
            for name in ("message", "remarks", "untruncated"):
                own.pop(name, None)
            own["_later"] = partial(self._with_untruncated, own["_later"])
        return found

    def _with_untruncated(self, makes: Callable[[Any], dict[str, Any]], found: SaddleNodeOnset) -> dict[str, Any]:
        """The messages of an onset, and that of the untruncated force where it is one of truncation."""
        notes, load = makes(found), self.model.mechanism.load_untruncated
        if load is None or Remark.OF_TRUNCATION not in notes["remarks"]:
            return {**notes, "untruncated": None}
        values = dict(zip(self.model.mechanism.design_names, self.design, strict=True))
        model = Model.of(load(), {**values, "mu": self.mu, "zeta": self.zeta}, self.excitation, self.model.laws)
        try:
            other = Averaged(model).saddle_node_onset()
        except ArithmeticError as unresolved:  # this force's onset is known all the same
            other = SaddleNodeOnset(None, None, None, "", unresolved.args[0])
        if other.F_SN is None:
            why, *more = sentences(other.message)
            remark = joined("without truncation: " + why, *more)
        else:
            remark = WITHOUT_TRUNCATION.format(other.F_SN, other.kind)
        return {**notes, "untruncated": other, "message": joined(notes["message"], remark)}

    def restoring_force(self, which: str | None = None) -> Force:
        """Return the force of the equation of motion, piece by piece.

        Parameters
        ----------
        which : {"truncated", "untruncated"}, optional
            The force of (6) or of (5); by default the one that is averaged.

        Returns
        -------
        Force
            Dimensionless.

        Raises
        ------
        ValueError
            For an unknown force, and if the mechanism does not have it.
        """
        mechanism = self.model.mechanism
        own = FORCES[0] if mechanism.truncated else FORCES[1]
        target = own if which is None else validate.choice("force", which, FORCES)
        if target == own:
            return Force.of(mechanism, self.model.parameters)
        if mechanism.load_untruncated is None:
            raise Refused(f"force = {which!r} is not allowed: the force of {mechanism.name} is {own}, it has no other")
        other = mechanism.load_untruncated()
        return Force.of(other, tuple(float(value) for value in other.coefficients(*self.design)))

    def equation_of_motion(self, which: str | None = None) -> EquationOfMotion:
        """Return equation (3) without its forcing, with the force of `restoring_force`.

        Structural damping is (eta/Omega) u' in a motion at Omega. Raises ValueError as `restoring_force`, and for a
        force without a finite stiffness at u = 0.
        """
        if which not in self._equations:
            laws, force = self.model.laws, followed(self.restoring_force(which), self.model.mechanism.name)
            others = {"released": laws.contact != THROUGHOUT, "mu_s": self.given.get("mu_s", 0.0), **laws.numbers}
            at = self.mu, self.zeta, self.model.inertial, self.load
            self._equations[which] = EquationOfMotion(force, *at, **others)
        return self._equations[which]

    @cached_property
    def _equations(self) -> dict[str | None, EquationOfMotion]:
        """What `equation_of_motion` returned, by its argument: oscillators are immutable."""
        return {}

    def _motions(self, system: EquationOfMotion) -> Motions:
        """Its motions by an equation of motion, whose integrator is imported on first use."""
        from slowflow.exact.questions import Motions

        return Motions(self, system)

    def steady_state(
        self,
        *,
        Omega: float,
        F_0: float,
        A: float | None = None,
        force: str | None = None,
        u_0: float | None = None,
        v_0: float = 0.0,
    ) -> exact.SteadyState:
        """Find a periodic motion of the equation of motion (3): series, harmonics, stops, multipliers, residual.

        Parameters
        ----------
        Omega, F_0 : float
            Frequency and amplitude of the excitation, > 0, dimensionless.
        A : float, optional
            Select the motion with the amplitude nearest to A, stable or not. Newton's iteration starts from the
            averaged states at Omega, from the averaged folds near it (not under a load) and from A itself; if none
            converges, the motion from the averaged state nearest to A is followed until it settles, from rest where
            friction holds all of these. With static friction the motion that a mass at rest tends to is a candidate
            too. Close to a fold the nearest one may be unstable, see `.stable`. By default the motion that a mass at
            rest tends to.
        force : {"truncated", "untruncated"}, optional
            As in `restoring_force`.
        u_0, v_0 : float, optional
            Initial displacement and velocity at tau = 0, where the forcing is largest, instead of A: the result is the
            motion that the mass then tends to. By default the mass starts from rest at u = 0 if that is a stable
            equilibrium, else at the stable equilibrium of `rest` nearest to it (u > 0 if two are equally near). If
            there are several, `.message` names the one used.

        Returns
        -------
        SteadyState
            .A .stops .stable .period .multipliers; `.force` is the force on the mass, F_0 Omega^2 for base excitation
            and unbalance.

        Raises
        ------
        ValueError
            For parameters out of range, such as a force <= mu.
        ArithmeticError
            Where nothing periodic is found.
        """
        return self._motions(self.equation_of_motion(force)).steady_state(Omega, F_0, A, u_0, v_0)

    def exact_response(
        self,
        F_0: float,
        *,
        Omega: tuple[float, float] = EXACT_WINDOW,
        start: exact.SteadyState | None = None,
        step: float = 0.02,
        force: str | None = None,
        u_0: float | None = None,
        v_0: float = 0.0,
    ) -> exact.Response:
        """Follow the response curve of the equation of motion (3): points, stability, stops, folds.

        The curve passes through the motion that a mass at rest, or with u_0 and v_0, tends to at the lowest frequency,
        or through `start`. That there are no other curves is not proved.

        Parameters
        ----------
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.
        Omega : tuple of float
            Window of frequencies, 0 < low < high.
        start : SteadyState, optional
            A motion on the curve. An isolated curve needs its own start, `steady_state(Omega=..., F_0=..., A=...)`; if
            averaging predicts another curve, `.message` gives these numbers.
        step : float
            Largest distance between neighbouring points, > 0 and <= 0.5, relative.
        force : {"truncated", "untruncated"}, optional
            As in `restoring_force`.
        u_0, v_0 : float, optional
            Initial displacement and velocity, as in `steady_state`.

        Returns
        -------
        Response
            .Omega .A .stable .folds .peak; .A is the largest |u|, also of offset motions. At low frequencies the force
            of base excitation or unbalance may not overcome friction: the curve then begins near the frequency at which
            the mass starts to move, as `.message` reports; if friction holds the mass throughout, the curve has no
            point. A curve that takes more than about ten seconds, or that cannot be followed further, is returned as
            far as it was computed: `.complete` is False, and `.message` gives the place and the reason.

        Raises
        ------
        ValueError
            For parameters out of range.
        ArithmeticError
            If no starting motion is found, or if the resonance is unbounded.
        """
        return self._motions(self.equation_of_motion(force)).exact_response(F_0, Omega, start, step, u_0, v_0)

    def sweep(
        self, *, Omega: Reals, F_0: float, force: str | None = None, u_0: float | None = None, v_0: float = 0.0
    ) -> exact.Sweep:
        """Follow a stepped-sine test through the frequencies in their order: amplitudes and jumps.

        At each frequency the motion is followed until it is shown to tend to a stable periodic motion, whose amplitude
        is returned; the next frequency continues from there. `.settled` is False where it does not settle within 2000
        periods of the forcing.

        Parameters
        ----------
        Omega : array_like
            Frequencies, > 0, shape (n,).
        F_0 : float
            Amplitude of the excitation, > 0, dimensionless.
        force : {"truncated", "untruncated"}, optional
            As in `restoring_force`.
        u_0, v_0 : float, optional
            Initial displacement and velocity, as in `steady_state`.

        Returns
        -------
        Sweep
            .Omega .A .settled, shape (n,), and .jumps, shape (k, 2): frequencies before and after each jump.

        Raises
        ------
        ValueError
            For parameters out of range, such as a force <= mu.
        ArithmeticError
            Where the motion escapes a softening spring.
        """
        return self._motions(self.equation_of_motion(force)).sweep(Omega, F_0, u_0, v_0)

    def transient(
        self,
        *,
        acceleration: Reals | None = None,
        duration: float | None = None,
        tau: Reals | None = None,
        after: float | None = None,
        force: str | None = None,
        u_0: float | None = None,
        v_0: float = 0.0,
    ) -> exact.Transient:
        """Integrate the response to a shock of the base, or the free motion from u_0 and v_0, by (3).

        Parameters
        ----------
        acceleration : array_like, optional
            Acceleration of the base over k_v L/m: the peak of a half sine, or the samples of a record, shape (n,). By
            default none: the mass moves freely from u_0 and v_0.
        duration : float, optional
            Duration of the half sine, in tau.
        tau : array_like, optional
            Times of the samples of a record, ascending, shape (n,); the acceleration is linear between them.
        after : float, optional
            Duration of the free motion afterwards, by default ten natural periods; longer until the mass has reversed
            twice.
        force : {"truncated", "untruncated"}, optional
            As in `restoring_force`.
        u_0, v_0 : float, optional
            Initial displacement and velocity relative to the base, by default as in `steady_state`.

        Returns
        -------
        Transient
            Largest deflection .A and acceleration .a_max, whether the springs detach, .detaches, the final displacement
            .u_end, and by `.series()` the motion relative to the base.

        Raises
        ------
        ValueError
            For invalid arguments; the message states what is allowed.
        ArithmeticError
            Where the motion escapes a softening spring.
        """
        validate.is_in_time("transient", self.model.laws.present)
        return self._motions(self.equation_of_motion(force)).transient(acceleration, duration, tau, after, u_0, v_0)

    def shock_spectrum(self, *, acceleration: Reals, duration: Reals, force: str | None = None) -> exact.ShockSpectrum:
        """Compute the shock response spectrum: largest deflection and acceleration after half sines of the base.

        Parameters
        ----------
        acceleration, duration : array_like
            Peak and duration of the pulse as in `transient`, > 0; they broadcast.
        force : {"truncated", "untruncated"}, optional
            The force of (6) or of (5); by default the one that is averaged.

        Returns
        -------
        ShockSpectrum
            One row per pulse: .A .a_max .ratio .detaches.

        Raises
        ------
        ValueError
            For invalid arguments; the message states what is allowed.
        ArithmeticError
            Where the motion escapes a softening spring.
        """
        validate.is_in_time("shock_spectrum", self.model.laws.present)
        return self._motions(self.equation_of_motion(force)).shock_spectrum(acceleration, duration)

    def random(self, *, S_0: float | None = None, psd: tuple[Reals, Reals] | None = None) -> RandomResponse:
        """Find the stationary motions under a Gaussian excitation w(tau), by statistical linearization.

        Under base excitation w is minus the acceleration of the base, over k_v L/m; otherwise a force, over k_v L, in
        place of F_0 cos(Omega tau).

        Parameters
        ----------
        S_0 : float, optional
            Constant two-sided spectral density of white noise, E[w(t) w(t + s)] = 2 pi S_0 delta(s).
        psd : tuple of array_like, optional
            One-sided density instead: frequencies and densities, linear in log-log between the points, 0 outside; the
            integral over Omega is the mean square of w.

        Returns
        -------
        RandomResponse
            .B, the mean, .u_rms about it, .v_rms .a_rms, .stiffness and .damping of the equivalent linear oscillator,
            .beyond and .crossing_rate of the first breakpoint; one entry per motion, in ascending order of u_rms.
            `RandomResponse` states what is proved about their number. If there are several, or if dry friction
            dominates the damping, `.message` reports it; `.measure()` compares with simulated motions.

        Raises
        ------
        ValueError
            If both or neither of S_0 and psd are given; for eta > 0; if zeta and mu are 0, unless c_2 > 0 under white
            noise; under a psd also if zeta is 0 and contact="attached".
        ArithmeticError
            Where there is no stationary motion; under a load also if the spring force does not exceed the load at
            large displacements.
        """
        from slowflow.random_vibration.questions import random

        validate.is_in_time("random", self.model.laws.present)
        return random(self, self.equation_of_motion(None), S_0, psd)

    def at_rest(self) -> checks.AtRest:
        """Compute data that do not depend on the forcing: .Omega_0 .k_0 .u_cr .break_loose .rests_within .sticking.

        Raises ValueError under a load, and for a force that is not odd: `rest` has the equilibria.
        """
        from slowflow.averaged import checks

        self.at_centre("at_rest")
        return checks.at_rest(self)

    @property
    def _equation(self) -> Self:
        """Itself: it has an equation of motion."""
        return self

    def measured(self, found: Any, force: str | None, of: str = "") -> Any:
        """Compare an averaged answer with the equation of motion; the `measure` of answers calls this."""
        from slowflow.exact import measure

        return measure.measured(self, found, force, of)

    @cached_property
    def second_approximation(self) -> SecondApproximation:
        """The same questions with higher harmonics of force and friction, which is closer to the equation of motion.

        Raises ValueError if these harmonics are not derived: for force="untruncated" with u_cr > 3/4.
        """
        from slowflow.second import SecondApproximation

        self.at_centre("second_approximation")
        validate.is_plain("second_approximation", self.model.laws.description())
        return SecondApproximation(self)

    @of_arrays_or_labelled
    def many(
        cls,
        /,
        mechanism: Mechanism,
        *,
        mu: Unlabelled = 0.0,
        zeta: Unlabelled = 0.0,
        eta: Unlabelled = 0.0,
        c_2: Unlabelled = 0.0,
        c_3: Unlabelled = 0.0,
        zeta_2: Unlabelled = 0.0,
        contact: str = THROUGHOUT,
        excitation: str = "force",
        load: Unlabelled = 0.0,
        **design: Unlabelled,
    ) -> Designs:
        """Make a batch of designs of one mechanism from arrays that broadcast; see `slowflow.averaged.many`.

        Arrays of xarray or dask make a map over named axes; see `slowflow.grid.designs`. With a load, or for a force
        that is not odd, answers include the mean B; see `slowflow.off_centre.many`. Raises ValueError for arguments
        that are not real arrays and for shapes that do not broadcast, TypeError for a missing or unknown name. Invalid
        designs raise nothing: each entry has a status.
        """
        from slowflow.grid import designs_of

        values, laws = {**design, "mu": mu, "zeta": zeta}, {"eta": eta, "c_2": c_2, "c_3": c_3, "zeta_2": zeta_2}
        found: Designs = designs_of(mechanism, values, laws, contact, excitation, load)
        return found


def _remade(kind: type[Oscillator], arguments: dict[str, Any]) -> Oscillator:
    """For pickle: its warnings were given when the oscillator was first made."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return kind(**arguments)
