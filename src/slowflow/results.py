"""What the questions are answered with: plain records of arrays; where there is no answer, `message` says why.

Answers do not change, their arrays included, and equal each other by content. Those that hold several entries have a
length, and an index or a loop gives one entry as a named tuple: `for fold in iso.saddle_nodes(0.04): fold.Omega`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import IntFlag
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from slowflow import sensitivities, validate
from slowflow.answer import LOADED, UNLOADED, Drawn, Single, Table, entry, frozen
from slowflow.certificate import ProvedFolds
from slowflow.gradient import Gradient
from slowflow.measured.validity import Validity, of_states, off_centre
from slowflow.mechanism import Flags, Ints
from slowflow.model import Floats, Model
from slowflow.support.errors import Refused
from slowflow.text import text
from slowflow.transmissibility import in_motion
from slowflow_kernels.conventions import OnsetKind, Pinned, Status

ONLY_OFFSET = "{u_max} is that of motions with a mean B: without a load A is the largest |{u}|"


class Remark(IntFlag):
    """What to bear in mind with an answer, as codes that add up; `.message` has them in words."""

    #: mu/F_0 is near pi/4, where averaging fails
    NEAR_STICKING = 1
    #: amplitudes above the mechanism's reach
    BEYOND_REACH = 2
    #: the stiffness at rest is negative: u = 0 is no resting place
    NEGATIVE_STIFFNESS = 4
    #: motions about u = 0 that leave it: the stiffness over their cycle does not carry the mean displacement back
    LEAVES_CENTRE = 8
    #: a fold or an onset on a breakpoint at which a truncated force jumps: the untruncated force has none there
    OF_TRUNCATION = 16
    #: below the onset there are folds that end at Omega = 0, or with a preload at A = 0
    FOLDS_AT_REST = 32
    #: a preload, or friction that ends at u_cr, holds a mass that is at rest; the motions are beside that
    HELD_AT_REST = 64
    #: next to where folds meet, or states do: doubles do not tell how many there are, nor does a proof in intervals; or
    #: they have few digits of where folds lie
    UNDECIDED = 128
    #: states of larger amplitudes there are, or may be: the response is cut, as nothing bounds it or at the reach
    CUT = 256
    #: states that turn beyond the top of the force's well, where it pushes on: exact motions do not come back from it
    BEYOND_WELL = 512
    #: doubles left undecided how many folds or states there are, or where folds are born, and balls of more digits
    #: decided it
    BY_BALLS = 1024
    #: the force was written so that for u < 0 it is another one than its mirror image, which was taken
    MIRRORED = 2048
    #: resonant states next to the top of a well, near which no exact motion loses as little energy as is supplied
    UNSUSTAINED = 4096


NOTHING = Remark(0)


def _nothing() -> Remark:
    """The default of answers, by a function: a value of the class would stand before what is made when it is read."""
    return NOTHING


State = entry("State", "Omega A phi stable", "A steady state, as in `SteadyStates`.")
CurvePoint = entry("CurvePoint", "Omega A phi stable branch", "A point of a response curve, as in `FrequencyResponse`.")
SaddleNode = entry("SaddleNode", "Omega A kind corner", "A fold, as in `SaddleNodes`.")
OffsetState = entry(
    "OffsetState", "Omega A B phi stable", "A steady state with its mean, as in `SteadyStates` under a load."
)
OffsetPoint = entry(
    "OffsetPoint",
    "Omega A B phi stable branch",
    "A point of a response curve with its mean, as in `FrequencyResponse` under a load.",
)
OffsetFold = entry("OffsetFold", "Omega A B kind corner", "A fold with its mean, as in `SaddleNodes` under a load.")
LocusPoint = entry("LocusPoint", "Omega A F_0 branch", "A point of the fold locus, as in `FoldLocus`.")
Cusp = entry("Cusp", "F_0 Omega A minimum", "A cusp of the fold locus, as in `Cusps`.")
IsolaPoint = entry(
    "IsolaPoint", "F_0 Omega A kind", "A point where an isolated curve is born, dies or merges, as in `IsolaPoints`."
)
MeasuredState = entry("MeasuredState", "Omega A error stable stops found reason", "One entry of `Measured`.")
MeasuredFold = entry("MeasuredFold", "Omega A error error_of_A found reason", "One entry of `MeasuredFolds`.")


@dataclass(frozen=True, eq=False)
class Measured(Table):
    """The motions of the equation of motion (3) that averaged states lead to: arrays with one entry for each state.

    Omega, A -- frequency, and largest |u| of the motion
    error    -- relative error of the averaged amplitude
    stable, stops -- whether the motion is stable; its rests in one period
    found    -- whether there is such a motion: A and error are nan where there is none
    reason   -- why there is none, in words
    message  -- how many states have none, and why; empty if all have one
    """

    entry: ClassVar[Any] = MeasuredState

    Omega: Floats
    A: Floats
    error: Floats
    stable: Flags
    stops: Ints
    found: Flags
    reason: npt.NDArray[np.str_]
    message: str


@dataclass(frozen=True, eq=False)
class MeasuredFolds(Table):
    """The folds of the equation of motion (3) that averaged ones lead to: arrays with one entry for each fold.

    Omega, A   -- of the exact fold
    error      -- relative error of the averaged frequency
    error_of_A -- relative error of the averaged amplitude
    found      -- whether there is such a fold: the rest is nan where there is none
    reason     -- why there is none, in words
    message    -- how many have none, and why; empty if all have one
    """

    entry: ClassVar[Any] = MeasuredFold

    Omega: Floats
    A: Floats
    error: Floats
    error_of_A: Floats
    found: Flags
    reason: npt.NDArray[np.str_]
    message: str


@dataclass(frozen=True, eq=False)
class MeasuredPoint(Single):
    """The peak, onset, detachment or isolation of the equation of motion (3) that an averaged one leads to; or None.

    F_0, Omega, A -- forcing, frequency, and largest |u| of the motion
    error    -- relative error of what was asked for: of a peak the averaged A, of an onset F_SN, of a detachment F_cr,
                of isolation Omega
    error_of_Omega -- relative error of the averaged frequency
    message  -- why there is none, in words
    """

    F_0: float | None
    Omega: float | None
    A: float | None
    error: float | None
    error_of_Omega: float | None
    message: str


#: what may be drawn of a response curve
DRAWN = ("A", "phi", "transmissibility", "transmissibility_dB")
#: an answer of averaging alone, which knows no equation of motion
NOT_ASKED = "this answer was not asked of an oscillator: no equation of motion is known to measure it against"


#: an answer that is not of averaging
NOT_AVERAGED = "gradients are known of averaged answers, asked of an oscillator with a design: this is none"


#: of an answer under a load, which says itself how its numbers move: a function of the answer
GradientOf = Callable[[Any], Gradient]
NOT_MEASURED = "off the centre states and folds are measured, as amplitudes(...).measure(): this answer is neither"


@dataclass(frozen=True, eq=False)
class Moving:
    """What averaged answers share, about whatever mean: what measures them, and under a load how their numbers move."""

    #: the oscillator, whose `measured` holds an answer against the equation of motion
    _equation: Any = field(default=None, kw_only=True, repr=False)
    _gradient_of: GradientOf | None = field(default=None, kw_only=True, repr=False)

    def _against_motion(self, force: str | None, of: str = "") -> Any:
        """What measuring it gives."""
        if self._equation is None:
            raise Refused(NOT_ASKED)
        return self._equation.measured(self, force, of)

    def _gradient_from(self: Any, of: Callable[..., Gradient], *numbers: Any) -> Gradient:
        """The gradient, without a load by a function of whose answer it is, and of its numbers."""
        return self._gradient_of(self) if self._gradient_of else of(of_model(self._model), *numbers)


@dataclass(frozen=True, eq=False)
class OfPoint(Moving):
    """What a peak, an onset and a detachment share: each is held against one of the equation of motion."""

    if TYPE_CHECKING:
        load: float | None

    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def _measured(self, force: str | None, of: str = "") -> MeasuredPoint:
        if self.load is not None:
            raise validate.NotAvailable(NOT_MEASURED)
        return self._against_motion(force, of)


@dataclass(frozen=True, eq=False)
class Point(OfPoint, Single):
    """A peak, an onset or a detachment.

    at -- names of its forcing, frequency and amplitude
    """

    at: ClassVar[tuple[str, str, str]]

    @property
    def validity(self) -> Validity:
        """Under a load, that how far the motion may be from the equation of motion was not measured."""
        if self.load is None or self._model is None:
            raise validate.NoAttribute("validity is known of states and folds, and under a load: of this it is not")
        return off_centre(self._model.mu, *(getattr(self, name) for name in self.at))

    def measure(self, force: str | None = None) -> MeasuredPoint:
        """How far it is from that of the equation of motion (3), here and now: tenths of a second where compiled.

        The exact curve is followed from motions beside a peak. An onset is the forcing at which the exact curve beside
        it becomes vertical, or gets folds at a corner; where an isolated curve is born there is no such forcing. A
        detachment is the forcing at which the exact curve of the first piece alone has a peak of u_cr. `force` and what
        is raised as in `SteadyStates.measure`, and ArithmeticError where that takes too many steps.
        """
        return self._measured(force)


def of_model(model: Model | None) -> sensitivities.Design:
    """Whose answer it is. Raises ValueError where nothing says it."""
    if model is None or not model.has_design:
        raise Refused(NOT_AVERAGED)
    laws, numbers = model.laws, (*model.design, model.mu, model.zeta)
    if not laws.any:
        return sensitivities.Design(model.mechanism, numbers, model.excitation)
    return sensitivities.Design(model.mechanism, (*numbers, laws.eta, laws.c_2), model.excitation, laws.rubs)


class WithMean:
    """What states and folds share: about a mean, which is 0 without a load."""

    entry: ClassVar[Any]
    with_mean: ClassVar[Any]

    if TYPE_CHECKING:
        A: Floats
        B: Floats | None

    def _entry_of(self) -> Any:
        """The named tuple that an entry is: with the mean, under a load."""
        return self.entry if self.B is None else self.with_mean

    @property
    def mean(self) -> Floats:
        """The mean displacement of each: B, and 0 without a load."""
        return np.zeros(self.A.size) if self.B is None else self.B


class InDecibels:
    """What tables of states share, at whatever depth and about whatever mean."""

    if TYPE_CHECKING:
        transmissibility: Any

    @property
    def transmissibility_dB(self) -> Floats:
        """`transmissibility` in decibels, 20 log10; -inf where nothing is transmitted."""
        with np.errstate(divide="ignore"):
            return np.asarray(20.0 * np.log10(self.transmissibility))


@dataclass(frozen=True, eq=False)
class SteadyStates(Moving, WithMean, InDecibels, Table):
    """Steady states, one entry each: flat arrays of one length.

    Omega, A -- frequency and amplitude, dimensionless; A = 0 where friction holds the mass at rest
    B        -- under a load the mean displacement, u = B + A cos(Omega tau + phi), so that |B| + A is the largest |u|,
                `u_max`; where friction holds the mass each stable place of rest, about which it may hold it as well
    stable   -- True where both eigenvalues of the Jacobian (28) have a negative real part; under a load where F_A (30)
                along the balance of the mean is positive, and the mean stiffness too
    F_0      -- the forcing, one number; an array with that of each state where several were asked for
    load     -- the static load over k_v L, where there is one
    message  -- remarks in words; empty if there is nothing to say
    Omega_undecided -- those of the frequencies asked for at which neither doubles nor balls tell how many states there
                       are
    """

    entry: ClassVar[Any] = State
    with_mean: ClassVar[Any] = OffsetState
    extra_columns: ClassVar[tuple[str, ...]] = ("transmissibility_dB",)

    Omega: Floats
    A: Floats
    B: Floats | None = field(default=None, kw_only=True, metadata=LOADED)
    stable: Flags
    F_0: float | Floats
    load: float | None = field(default=None, kw_only=True, metadata=LOADED)
    message: str
    Omega_undecided: Floats = field(default_factory=lambda: np.empty(0), kw_only=True)
    remarks: Remark = field(default_factory=_nothing, kw_only=True)
    _model: Model = field(repr=False)
    #: under a load, h along the balance of the mean, and the flow of which it is a number
    _h: Floats | None = field(default=None, kw_only=True, repr=False)
    _flow: Any = field(default=None, kw_only=True, repr=False)

    def _beside_of(self) -> tuple[str, ...]:
        """`u_max` too, under a load."""
        return ("u_max", *self.extra_columns) if self.B is not None else self.extra_columns

    @property
    def u_max(self) -> Floats:
        """The largest |u| of each motion: |B| + A, under a load; `A` is that without one."""
        if self.B is None:
            raise validate.NoAttribute(text(ONLY_OFFSET))
        return np.asarray(np.abs(self.B) + self.A)

    @property
    def _balance(self) -> tuple[Any, Any]:
        """The slow flow whose states these are, and h at each."""
        return (self._model, self._model.averaged(self.A)[0]) if self._flow is None else (self._flow, self._h)

    @cached_property
    def phi(self) -> Floats:
        """Phase of u = A cos(Omega tau + phi) in radians, in [-pi, 0] (25); computed when first asked for.

        Of a mass at rest it is the one with which it begins to move, -pi/2 without a preload.
        """
        flow, h = self._balance
        return frozen(np.asarray(flow.phase(self.Omega, self.A, h)) + 0 * self.A)

    @property
    def force(self) -> float | Floats:
        """Amplitude of the force on the mass in each state: F_0, or F_0 Omega^2 for an excitation by inertia."""
        return self._model.force(self.F_0, self.Omega)

    @cached_property
    def transmissibility(self) -> Floats:
        """Fundamental harmonic of what spring, damper and friction pass on, over `.force`, of each state.

        On a base that shakes it is as well the absolute displacement of the mass over that of the base. A mass at rest
        passes on all of it: 1.
        """
        with np.errstate(divide="ignore", invalid="ignore"):  # of a mass at rest on a base that hardly shakes
            flow, h = self._balance
            return frozen(in_motion(self.A, flow.transmissibility(self.Omega, self.A, self.F_0, h)))

    @property
    def relative(self) -> Floats:
        """A over F_0 of each state, a displacement over another one.

        On a base that shakes that from the base over the base's. Of a force it is over the static deflection of the
        vertical spring alone, of an unbalance over the amplitude that the mass tends to as Omega tends to inf.
        """
        return np.asarray(self.A / self.F_0)

    @cached_property
    def validity(self) -> Validity:
        """How far each state may be from the equation of motion, by measurement; looked up when first asked for."""
        if self.load is not None:
            return off_centre(self._model.mu, self.F_0, self.Omega, self.A)
        return of_states(self._model, self.Omega, self.A)

    def gradient(self) -> Gradient:
        """How A, phi and transmissibility of each state move with the parameters, F_0 and Omega, exactly.

        Where a state is a fold, or lies on a breakpoint at which the force jumps, it has no gradient, and `.status` and
        `.message` say so. Under a load B and the load take part; raises NotAvailable where it is not known how the
        force moves with the design.
        """
        return self._gradient_from(
            sensitivities.of_states, self.Omega, self.A, self.F_0, self.phi, self.transmissibility
        )

    def measure(self, force: str | None = None) -> Measured:
        """How far each state is from the equation of motion (3): measured here and now, some 0.2 ms for each.

        Newton's iteration leads from a state to a motion of half to one and a half times its amplitude; of two states
        at one frequency that lead to the same motion, one is said to have none. `force`: "truncated" for (6),
        "untruncated" for (5), by default the one that was averaged. Under a load `.A` of the answer is the largest |u|,
        and `.error` that of `u_max`. Raises ValueError where there is no such force, or where neither friction nor
        viscous damping lets a motion settle.
        """
        return self._against_motion(force)


@dataclass(frozen=True, eq=False)
class FrequencyResponse(Drawn, SteadyStates):
    """A response curve: points in order along each branch.

    branch -- number of the connected curve that a point lies on, from 0; isolated curves come last
    isola  -- for each branch, whether it is closed
    F_0    -- the forcing
    """

    entry: ClassVar[Any] = CurvePoint
    with_mean: ClassVar[Any] = OffsetPoint

    F_0: float
    branch: Ints
    isola: tuple[bool, ...]
    picture: ClassVar[str] = "response"

    @property
    def can_draw(self) -> tuple[str, ...]:
        """Which of its numbers `plot` may draw over Omega."""
        return DRAWN if self.B is None else ("B", *DRAWN)


@dataclass(frozen=True, eq=False)
class SaddleNodes(Moving, WithMean, Drawn, Table):
    """Folds of the response curve at one forcing, by rising Omega: arrays of one length.

    kind   -- "jump-up": a sweep leaves the fold for a larger amplitude; "jump-down": for a smaller one
              under a load "unstable" where the motions that meet are both not stable
    corner -- True where the fold sits on a breakpoint of the force
    B, load -- under a load, the mean displacement of each, and the load over k_v L
    proof  -- enclosures of all folds, and whether these are proved to be all; None unless it was asked for
    """

    entry: ClassVar[Any] = SaddleNode
    with_mean: ClassVar[Any] = OffsetFold

    Omega: Floats
    A: Floats
    B: Floats | None = field(default=None, kw_only=True, metadata=LOADED)
    kind: npt.NDArray[np.str_]
    corner: Flags
    F_0: float
    load: float | None = field(default=None, kw_only=True, metadata=LOADED)
    message: str
    remarks: Remark = field(default_factory=_nothing, kw_only=True)
    proof: ProvedFolds | None = field(default=None, kw_only=True, metadata=UNLOADED)
    _model: Model = field(repr=False)
    picture: ClassVar[str] = "folds"

    @cached_property
    def validity(self) -> Validity:
        """How far each fold may be from the equation of motion, by measurement; looked up when first asked for."""
        if self.load is not None:
            return off_centre(self._model.mu, self.F_0, self.Omega, self.A)
        return of_states(self._model, self.Omega, self.A, corner=bool(self.corner.any()))

    def gradient(self) -> Gradient:
        """How Omega and A of each fold move with the parameters and F_0, exactly; a corner moves with its breakpoint.

        Where a fold meets another, at a cusp or an isola point, or comes to a breakpoint or leaves it, it has no
        gradient, and `.status` and `.message` say so. Under a load as `SteadyStates.gradient`.
        """
        return self._gradient_from(sensitivities.of_folds, self.Omega, self.A, self.F_0, self.corner)

    def measure(self, force: str | None = None) -> MeasuredFolds:
        """How far each fold is from one of the equation of motion (3): measured here and now, some ms for each.

        The exact curve is followed from motions beside the fold, up to the first one that it meets. `force` and what
        is raised as in `SteadyStates.measure`; under a load `.A` of the answer is the largest |u| at the fold, and
        `.error_of_A` that of |B| + A.
        """
        return self._against_motion(force)


@dataclass(frozen=True, eq=False)
class SaddleNodeOnset(Point):
    """The lowest forcing that has a fold; None and a message where there is none.

    kind -- "cusp" (the response gets a vertical inflection), "isola" (an isolated curve is born), "corner" (at a
            breakpoint)
    untruncated -- the onset of the untruncated force, where this one is on a corner that only the truncation makes;
                   without one its message says why, which may be that doubles do not tell
    B, load     -- under a load, the mean displacement, and the load over k_v L; the onset is the lowest forcing for
                   which a stable motion ends at a fold then
    """

    at: ClassVar[tuple[str, str, str]] = ("F_SN", "Omega", "A")

    F_SN: float | None
    Omega: float | None
    A: float | None
    B: float | None = field(default=None, kw_only=True, metadata=LOADED)
    kind: str
    load: float | None = field(default=None, kw_only=True, metadata=LOADED)
    message: str
    untruncated: SaddleNodeOnset | None = field(default_factory=lambda: None, kw_only=True, metadata=UNLOADED)
    remarks: Remark = field(default_factory=_nothing, kw_only=True)
    #: where there is none, what batches say
    _status: Status = field(default=Status.NONE, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How F_SN, Omega and A move with the parameters, exactly; on a breakpoint with that.

        Where more than two folds are born together there is no gradient, and `.status` and `.message` say so. Of two
        onsets at one forcing, which it does not look for, it is that of the one which is given. Under a load B and the
        load take part, and on a corner that a jump of the force makes there is none.
        """
        kind = OnsetKind[self.kind.upper() or "NO"]
        return self._gradient_from(sensitivities.of_onset, self.F_SN, self.Omega, self.A, kind)


@dataclass(frozen=True, eq=False)
class FoldLocus(Drawn, Table):
    """The saddle nodes of every forcing: points in order along each branch, in arrays of one length.

    Omega, A, F_0 -- a fold and the forcing that has it
    branch        -- number of the connected branch that a point lies on, from 0; breakpoints separate branches
    """

    entry: ClassVar[Any] = LocusPoint

    Omega: Floats
    A: Floats
    F_0: Floats
    branch: Ints
    message: str
    picture: ClassVar[str] = "locus"


@dataclass(frozen=True, eq=False)
class Cusps(Table):
    """Cusps of the fold locus, F = F_A = F_AA = 0, by rising amplitude: arrays of one length.

    minimum -- True where two folds come into being as the forcing rises; False where two meet and vanish
    remarks -- `Remark.UNDECIDED` where doubles have few digits of one, `Remark.BY_BALLS` where balls told them
    """

    entry: ClassVar[Any] = Cusp

    F_0: Floats
    Omega: Floats
    A: Floats
    minimum: Flags
    message: str
    remarks: Remark = field(default_factory=_nothing, kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How F_0, Omega and A of each cusp move with the parameters, exactly."""
        return sensitivities.of_extrema(of_model(self._model), Pinned.CUSP, self.F_0, self.Omega, self.A)


@dataclass(frozen=True, eq=False)
class IsolaPoints(Table):
    """Points with F = F_A = F_Omega = 0, by rising amplitude: arrays of one length.

    kind -- what happens there as the forcing rises: an isolated curve's "birth", its "death", or a "merger" of two
            parts of the response curve (or their separation)
    remarks -- `Remark.UNDECIDED` where doubles have few digits of one
    """

    entry: ClassVar[Any] = IsolaPoint

    F_0: Floats
    Omega: Floats
    A: Floats
    kind: npt.NDArray[np.str_]
    message: str
    remarks: Remark = field(default_factory=_nothing, kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How F_0, Omega and A of each isola point move with the parameters, exactly."""
        return sensitivities.of_extrema(of_model(self._model), Pinned.ISOLA, self.F_0, self.Omega, self.A)


@dataclass(frozen=True, eq=False)
class Peak(Point):
    """The highest peak of the response at one forcing, isolas included; None and a message where there is none.

    It is a top of the curve at which stable motions end, within the well of a spring that gives way.

    B, load  -- under a load, its mean displacement, and the load over k_v L
    u_max, Omega_max -- under a load, the largest |u|, |B| + A, which is what a stroke has to hold, and its frequency,
                which may be that of another motion. Of motions whose mean stiffness is positive, as of stable ones
    """

    at: ClassVar[tuple[str, str, str]] = ("F_0", "Omega", "A")

    A: float | None
    B: float | None = field(default=None, kw_only=True, metadata=LOADED)
    Omega: float | None
    u_max: float | None = field(default=None, kw_only=True, metadata=LOADED)
    Omega_max: float | None = field(default=None, kw_only=True, metadata=LOADED)
    F_0: float
    load: float | None = field(default=None, kw_only=True, metadata=LOADED)
    message: str
    remarks: Remark = field(default_factory=_nothing, kw_only=True)
    #: whether the mean turns back there
    _turns: bool = field(default=False, kw_only=True, repr=False)
    #: where there is none, what batches say
    _status: Status = field(default=Status.NONE, kw_only=True, repr=False)
    #: whether that is because the response goes on beyond a well
    _escapes: bool = field(default=False, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How A and Omega move with the parameters and F_0, exactly; a peak at Omega = 0 stays there.

        Where the peak is an isola point, or lies on a breakpoint at which the force jumps, it has no gradient, and
        `.status` and `.message` say so. Of two peaks of one height it is that of the one which is given. Under a load B
        and the load take part, and u_max if it is that motion's; where the mean turns back there, NotAvailable is
        raised.
        """
        return self._gradient_from(sensitivities.of_peak, self.A, self.Omega, self.F_0)


@dataclass(frozen=True, eq=False)
class Detachment(Point):
    """The lowest forcing that reaches u_cr, its frequency, and u_cr; None and a message where there is no u_cr.

    A, B, load -- under a load, amplitude and mean displacement of the motion with |B| + A = u_cr, and the load over
                  k_v L
    """

    at: ClassVar[tuple[str, str, str]] = ("F_cr", "Omega_cr", "A")

    F_cr: float | None
    Omega_cr: float | None
    u_cr: float | None = field(metadata=UNLOADED)
    A: float | None = field(default=None, kw_only=True, metadata=LOADED)
    B: float | None = field(default=None, kw_only=True, metadata=LOADED)
    load: float | None = field(default=None, kw_only=True, metadata=LOADED)
    message: str
    remarks: Remark = field(default_factory=_nothing, kw_only=True)

    def gradient(self) -> Gradient:
        """How F_cr, Omega_cr and u_cr move with the parameters, exactly; under a load A and B instead of u_cr."""
        return self._gradient_from(sensitivities.of_detachment, self.F_cr, self.Omega_cr, self.u_cr)
