"""Results of averaged functions.

If there is no result, `message` gives the reason. Results are immutable, including their arrays, and compare by value.
Results with several entries have a length; indexing or iterating gives named tuples, for example `for fold in
iso.saddle_nodes(0.04): fold.Omega`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import IntFlag
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import LOADED, UNLOADED, Drawn, Single, Table, TupleEntry, entry_of, frozen
from slowflow.answers.transmissibility import in_motion
from slowflow.core import validate
from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import Floats, Model
from slowflow.support.errors import Refused
from slowflow.support.text import text
from slowflow_kernels.conventions import Status

if TYPE_CHECKING:
    from slowflow.answers.certificate import ProvedFolds
    from slowflow.answers.gradient import Gradient
    from slowflow.answers.validity import Measured, MeasuredFolds, MeasuredPoint, Validity

ONLY_OFFSET = "only motions with a mean B have {u_max}: without a load A is the largest |{u}|"


class Remark(IntFlag):
    """Diagnostics of an answer, as flags; `.message` has them as text."""

    #: mu/F_0 is near pi/4, where averaging fails
    NEAR_STICKING = 1
    #: amplitudes above the mechanism's reach
    BEYOND_REACH = 2
    #: the stiffness at rest is negative: u = 0 is no stable equilibrium
    NEGATIVE_STIFFNESS = 4
    #: motions about u = 0 that drift away: the stiffness over their cycle does not restore the mean displacement
    LEAVES_CENTRE = 8
    #: a fold or an onset on a breakpoint at which a truncated force jumps: the untruncated force has none there
    OF_TRUNCATION = 16
    #: below the onset there are folds that end at Omega = 0, or with a preload at A = 0
    FOLDS_AT_REST = 32
    #: a preload, or friction that ends at u_cr, holds a mass at rest; the motions coexist with that equilibrium
    HELD_AT_REST = 64
    #: folds or states nearly merge: neither double precision nor a proof resolves their number, or folds have few
    #: digits
    UNDECIDED = 128
    #: larger amplitudes exist or may exist: the response is unbounded, or was cut at the mechanism's reach
    CUT = 256
    #: states that turn beyond the top of the potential well: exact motions do not return from there
    BEYOND_WELL = 512
    #: double precision was inconclusive on the number of folds or states, or on the onset; ball arithmetic resolved it
    BY_BALLS = 1024
    #: a user-defined force is not odd: for u < 0 the mirror image of its part for u > 0 is used
    MIRRORED = 2048
    #: resonant states close to the top of a well: every exact motion there dissipates more energy than is supplied
    UNSUSTAINED = 4096
    #: a random motion switches between several equivalent linear oscillators, or between wells
    SEVERAL_MOTIONS = 8192
    #: much of the damping is friction or nonlinear, or the force is curved: random motions are far from linear ones
    FAR_FROM_LINEAR = 16384
    #: the density of a random excitation varies much near the natural frequency of the motion
    UNEVEN_EXCITATION = 32768


NOTHING = Remark(0)


def _nothing() -> Remark:
    """The default of answers, by a function: a value of the class would come before what is made when it is read."""
    return NOTHING


#: quantities that may be drawn of a response curve
DRAWN = ("A", "phi", "transmissibility", "transmissibility_dB")
#: of an answer of averaging alone, without an equation of motion
NOT_ASKED = "this answer does not come from an oscillator: there is no equation of motion to compare it with"


NOT_MEASURED = (
    "for offset motions only states and folds can be compared with the equation of motion, as amplitudes(...).measure()"
)


@dataclass(frozen=True, eq=False)
class Moving:
    """Common part of averaged answers: comparison with exact motions, and gradients under a load."""

    #: the oscillator, whose `measured` compares an answer with the equation of motion
    _equation: Any = field(default=None, kw_only=True, repr=False)
    #: of an answer under a load: its gradient as a function of the answer and its question
    _gradient_of: Callable[[Any, str], Gradient] | None = field(default=None, kw_only=True, repr=False)

    def _against_motion(self, force: str | None, of: str = "") -> Any:
        """Compare the answer with the equation of motion."""
        if self._equation is None:
            raise Refused(NOT_ASKED)
        return self._equation.measured(self, force, of)

    def _gradient_from(self: Any, question: str, *numbers: Any) -> Gradient:
        """The gradient: under a load by the function that came with the answer."""
        return self._gradient_of(self, question) if self._gradient_of else _gradient(self._model, question, *numbers)


@dataclass(frozen=True, eq=False)
class OfPoint(Moving):
    """Common part of peak, onset and detachment: comparison with the equation of motion."""

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
        """Under a load: a message that the error of averaging has not been measured there."""
        if self.load is None or self._model is None:
            raise validate.NoAttribute("only states and folds, and answers under a load, have a validity")
        from slowflow.answers import validity

        return validity.off_centre(self._model.mu, *(getattr(self, name) for name in self.at))

    def measure(self, force: str | None = None) -> MeasuredPoint:
        """Compare the point with that of the equation of motion (3), in tenths of a second if compiled.

        For a peak, the exact curve is followed from nearby motions. The exact onset is the forcing at which the exact
        curve becomes vertical nearby, or gets folds at a corner; the birth of an isolated curve is not compared. The
        exact detachment is the forcing at which the exact curve of the first piece alone has a peak of u_cr. `force`
        and errors as in `SteadyStates.measure`; ArithmeticError if it takes too many steps.
        """
        return self._measured(force)


def _gradient(model: Model | None, question: str, *numbers: Any) -> Gradient:
    """The gradient of an answer about the centre, by the numbers that its question gave."""
    from slowflow.answers import sensitivities  # here, not above: the first answer does without

    return sensitivities.of_answer(model, question, *numbers)


class WithMean:
    """Common part of states and folds: the mean displacement, which is 0 without a load."""

    entry: ClassVar[type[TupleEntry]]
    with_mean: ClassVar[type[TupleEntry]]

    if TYPE_CHECKING:
        A: Floats
        B: Floats | None

    def __init_subclass__(cls, with_mean: str = "", **more: Any) -> None:
        super().__init_subclass__(**more)
        if with_mean:
            Omega, A, *others = cls.entry._fields
            cls.with_mean = entry_of(cls, "with_mean", with_mean, (Omega, A, "B", *others))

    def _entry_of(self) -> type[TupleEntry]:
        """The named tuple of an entry: with the mean, under a load."""
        return self.entry if self.B is None else self.with_mean

    @property
    def mean(self) -> Floats:
        """Mean displacement of each entry: B, or 0 without a load."""
        return np.zeros(self.A.size) if self.B is None else self.B


class InDecibels:
    """Common part of tables of states, for every approximation."""

    if TYPE_CHECKING:
        transmissibility: Any

    @property
    def transmissibility_dB(self) -> Floats:
        """`transmissibility` in decibels, 20 log10; -inf where nothing is transmitted."""
        with np.errstate(divide="ignore"):
            return np.asarray(20.0 * np.log10(self.transmissibility))


@dataclass(frozen=True, eq=False)
class SteadyStates(
    Moving, WithMean, InDecibels, Table, entry="State", columns="Omega A phi stable", with_mean="OffsetState"
):
    """Steady states, one entry each: flat arrays of one length.

    Omega, A -- frequency and amplitude, dimensionless; A = 0 where friction holds the mass at rest
    B        -- under a load the mean displacement, u = B + A cos(Omega tau + phi), so that |B| + A is the largest |u|,
            `u_max`; for a mass held by friction, each stable equilibrium (friction may also hold it nearby)
    stable   -- True where both eigenvalues of the Jacobian (28) have a negative real part; under a load, where F_A (30)
                along the balance of the mean and the mean stiffness are positive
    F_0      -- the forcing, a number; an array with the forcing of each state if the question had several
    load     -- the static load over k_v L, if there is one
    message  -- diagnostics as text; empty if there are none
    Omega_undecided -- frequencies of the question at which the number of states is undecided
    """

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
    #: under a load, h along the balance of the mean, and its slow flow
    _h: Floats | None = field(default=None, kw_only=True, repr=False)
    _flow: Any = field(default=None, kw_only=True, repr=False)

    def _beside_of(self) -> tuple[str, ...]:
        """`u_max` too, under a load."""
        return ("u_max", *self.extra_columns) if self.B is not None else self.extra_columns

    @property
    def u_max(self) -> Floats:
        """The largest |u| of each motion under a load, |B| + A; without a load it is `A`."""
        if self.B is None:
            raise validate.NoAttribute(text(ONLY_OFFSET))
        return np.asarray(np.abs(self.B) + self.A)

    @property
    def _balance(self) -> tuple[Any, Any]:
        """The slow flow of these states, and h at each."""
        return (self._model, self._model.averaged(self.A)[0]) if self._flow is None else (self._flow, self._h)

    @cached_property
    def phi(self) -> Floats:
        """Phase of u = A cos(Omega tau + phi) in radians, in [-pi, 0] (25); computed on first use.

        For a mass at rest it is the phase with which the motion begins, -pi/2 without a preload.
        """
        flow, h = self._balance
        return frozen(np.asarray(flow.phase(self.Omega, self.A, h)) + 0 * self.A)

    @property
    def force(self) -> float | Floats:
        """Amplitude of the force on the mass in each state: F_0, or F_0 Omega^2 for base excitation and unbalance."""
        return self._model.force(self.F_0, self.Omega)

    @cached_property
    def transmissibility(self) -> Floats:
        """First harmonic of the force of spring, damper and friction over `.force`, for each state, dimensionless.

        Under base excitation it is also the absolute displacement of the mass over that of the base. It is 1 for a mass
        at rest.
        """
        with np.errstate(divide="ignore", invalid="ignore"):  # of a mass at rest on a base that hardly shakes
            flow, h = self._balance
            return frozen(in_motion(self.A, flow.transmissibility(self.Omega, self.A, self.F_0, h)))

    @property
    def relative(self) -> Floats:
        """A over F_0 of each state, the ratio of two displacements.

        Under base excitation: relative displacement over that of the base; under a force: over the static deflection of
        the vertical spring alone; with an unbalance: over the limit of the amplitude as Omega tends to inf.
        """
        return np.asarray(self.A / self.F_0)

    @cached_property
    def validity(self) -> Validity:
        """Measured errors of averaging near each state, against the equation of motion; looked up on first use."""
        from slowflow.answers import validity

        if self.load is not None:
            return validity.off_centre(self._model.mu, self.F_0, self.Omega, self.A)
        return validity.of_states(self._model, self.Omega, self.A)

    def gradient(self) -> Gradient:
        """Differentiate A, phi and transmissibility of each state with respect to the parameters, F_0 and Omega.

        The derivatives are exact. A state that is a fold, or lies on a breakpoint at which the force jumps, has no
        gradient;
        `.status` and `.message` say so. Under a load also B, and with respect to the load; raises Refused if the
        derivatives of the force with respect to the design are not known.
        """
        return self._gradient_from("amplitudes", self.Omega, self.A, self.F_0, self.phi, self.transmissibility)

    def measure(self, force: str | None = None) -> Measured:
        """Compare each state with a motion of the equation of motion (3), in about 0.2 ms each.

        Newton's iteration starts from the state and accepts a motion of half to one and a half times its amplitude. If
        two states at one frequency lead to the same motion, only one of them keeps it.

        Parameters
        ----------
        force : {"truncated", "untruncated"}, optional
            The force of (6) or of (5); by default the one that was averaged.

        Returns
        -------
        Measured
            .A .error .stable .stops .found; under a load .A is the largest |u|, and .error the error of `u_max`.

        Raises
        ------
        ValueError
            If there is no such force, or if there is neither friction nor viscous damping.
        """
        return self._against_motion(force)


@dataclass(frozen=True, eq=False)
class FrequencyResponse(
    Drawn, SteadyStates, entry="CurvePoint", columns="Omega A phi stable branch", with_mean="OffsetPoint"
):
    """A response curve: points in order along each branch.

    branch -- index of the connected curve that contains the point, from 0; isolated curves come last
    isola  -- for each branch, whether it is closed
    F_0    -- the forcing
    """

    F_0: float
    branch: Ints
    isola: tuple[bool, ...]
    picture: ClassVar[str] = "response"

    @property
    def can_draw(self) -> tuple[str, ...]:
        """Quantities that `plot` may draw over Omega."""
        return DRAWN if self.B is None else ("B", *DRAWN)


@dataclass(frozen=True, eq=False)
class SaddleNodes(Moving, WithMean, Drawn, Table, entry="SaddleNode", with_mean="OffsetFold"):
    """Folds of the response curve at one forcing, in ascending order of Omega: arrays of one length.

    kind   -- "jump-up": a sweep jumps from the fold to a larger amplitude; "jump-down": to a smaller one; under a load
            "unstable" if both motions that merge are unstable
    corner -- True where the fold lies on a breakpoint of the force
    B, load -- under a load, the mean displacement of each fold, and the load over k_v L
    proof  -- enclosures of all folds, and whether the set is proved complete; None without certify=True
    """

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
        """Measured errors of averaging near each fold, against the equation of motion; looked up on first use."""
        from slowflow.answers import validity

        if self.load is not None:
            return validity.off_centre(self._model.mu, self.F_0, self.Omega, self.A)
        return validity.of_states(self._model, self.Omega, self.A, corner=bool(self.corner.any()))

    def gradient(self) -> Gradient:
        """Differentiate Omega and A of each fold with respect to the parameters and F_0; a corner stays on its
        breakpoint.

        The derivatives are exact. A fold that meets another, at a cusp or an isola point, or that reaches or leaves a
        breakpoint, has no gradient; `.status` and `.message` say so. Under a load as `SteadyStates.gradient`.
        """
        return self._gradient_from("saddle_nodes", self.Omega, self.A, self.F_0, self.corner)

    def measure(self, force: str | None = None) -> MeasuredFolds:
        """Compare each fold with one of the equation of motion (3), in a few ms each.

        The exact curve is followed from motions near the averaged fold up to its first fold. `force` and errors as in
        `SteadyStates.measure`; under a load `.A` is the largest |u| at the fold, and `.error_of_A` the error of |B| +
        A.
        """
        return self._against_motion(force)


@dataclass(frozen=True, eq=False)
class SaddleNodeOnset(Point):
    """The lowest forcing that has a fold; None and a message if there is none.

    kind -- "cusp" (the response has a vertical inflection), "isola" (an isolated curve is born), "corner" (at a
            breakpoint)
    untruncated -- the onset of the untruncated force, if this onset lies on a corner due to the truncation alone; if
            there is none, its message gives the reason, which may be that double precision is inconclusive
    B, load     -- under a load, the mean displacement, and the load over k_v L; the onset is then the lowest forcing
            for which a stable motion ends at a fold
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
    #: status of batches where there is none
    _status: Status = field(default=Status.NONE, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """Differentiate F_SN, Omega and A with respect to the parameters; an onset on a breakpoint stays on it.

        The derivatives are exact. If more than two folds are born together there is no gradient; `.status` and
        `.message` say so. Of two onsets at one forcing, the gradient is that of the reported one. Under a load also B,
        and with respect to the load; an onset where the force jumps, due to motions beyond the jump, then has no
        gradient.
        """
        at = self.Omega, self.A, self.F_SN, self.kind
        return self._gradient_from("saddle_node_onset", *at)


@dataclass(frozen=True, eq=False)
class FoldLocus(Drawn, Table, entry="LocusPoint"):
    """The saddle nodes of all forcings: points in order along each branch, in arrays of one length.

    Omega, A, F_0 -- a fold and the forcing that has it
    branch        -- index of the connected branch that contains the point, from 0; breakpoints separate branches
    """

    Omega: Floats
    A: Floats
    F_0: Floats
    branch: Ints
    message: str
    picture: ClassVar[str] = "locus"


@dataclass(frozen=True, eq=False)
class Cusps(Table, entry="Cusp"):
    """Cusps of the fold locus, F = F_A = F_AA = 0, in ascending order of amplitude: arrays of one length.

    minimum -- True if two folds appear as the forcing increases; False if two merge and vanish
    remarks -- `Remark.UNDECIDED` if double precision gives few digits, `Remark.BY_BALLS` if ball arithmetic gave them
    """

    F_0: Floats
    Omega: Floats
    A: Floats
    minimum: Flags
    message: str
    remarks: Remark = field(default_factory=_nothing, kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """Differentiate F_0, Omega and A of each cusp with respect to the parameters; exact derivatives."""
        return _gradient(self._model, "cusps", self.Omega, self.A, self.F_0)


@dataclass(frozen=True, eq=False)
class IsolaPoints(Table, entry="IsolaPoint"):
    """Points with F = F_A = F_Omega = 0, in ascending order of amplitude: arrays of one length.

    kind -- what happens there as the forcing increases: "birth" or "death" of an isolated curve, or "merger" of two
            pieces of the response curve (or their separation)
    remarks -- `Remark.UNDECIDED` if double precision gives few digits
    """

    F_0: Floats
    Omega: Floats
    A: Floats
    kind: npt.NDArray[np.str_]
    message: str
    remarks: Remark = field(default_factory=_nothing, kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """Differentiate F_0, Omega and A of each isola point with respect to the parameters; exact derivatives."""
        return _gradient(self._model, "isola_points", self.Omega, self.A, self.F_0)


@dataclass(frozen=True, eq=False)
class Peak(Point):
    """The highest peak of the response at one forcing, isolas included; None and a message if there is none.

    It is a maximum of A over Omega on a stable branch; for a softening spring it lies within the potential well.

    B, load  -- under a load, its mean displacement, and the load over k_v L
    u_max, Omega_max -- under a load, the largest |u| = |B| + A of all motions with positive mean stiffness, which the
            stroke must exceed, and its frequency; this motion may differ from the peak
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
    #: status of batches where there is none
    _status: Status = field(default=Status.NONE, kw_only=True, repr=False)
    #: whether that is because the response goes on beyond a well
    _escapes: bool = field(default=False, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """Differentiate A and Omega with respect to the parameters and F_0; a peak at Omega = 0 stays there.

        The derivatives are exact. A peak that is an isola point, or lies on a breakpoint at which the force jumps, has
        no gradient; `.status` and `.message` say so. Of two peaks of equal height, the gradient is that of the reported
        one. Under a load also B, and u_max if it belongs to the same motion; raises Refused if the peak lies at a
        turning point of the mean.
        """
        return self._gradient_from("peak", self.Omega, self.A, self.F_0)


@dataclass(frozen=True, eq=False)
class Detachment(Point):
    """The lowest forcing that reaches u_cr, its frequency, and u_cr; None and a message if there is no u_cr.

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
        """Differentiate F_cr, Omega_cr and u_cr with respect to the parameters; under a load A, B instead of u_cr."""
        return self._gradient_from("detachment", self.Omega_cr, self.u_cr, self.F_cr)
