"""What the questions are answered with: plain records of arrays; where there is no answer, `message` says why.

Answers do not change, their arrays included, and equal each other by content. Those that hold several entries have a
length, and an index or a loop gives one entry as a named tuple: `for fold in iso.saddle_nodes(0.04): fold.Omega`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import IntFlag
from functools import cached_property
from typing import Any, ClassVar, NamedTuple, Protocol

import numpy as np
import numpy.typing as npt

from slowflow import moves, validate
from slowflow.answer import Answer, Single, Table, frozen
from slowflow.gradient import Gradient
from slowflow.measured.validity import Validity, of_states
from slowflow.model import Floats, Model
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import OnsetKind, Status


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
    #: next to where folds meet, or states do: doubles do not tell how many there are, nor does a proof in intervals
    UNDECIDED = 128


class State(NamedTuple):
    """A steady state, as in `SteadyStates`."""

    Omega: float
    A: float
    phi: float
    stable: bool


class CurvePoint(NamedTuple):
    """A point of a response curve, as in `FrequencyResponse`."""

    Omega: float
    A: float
    phi: float
    stable: bool
    branch: int


class SaddleNode(NamedTuple):
    """A fold, as in `SaddleNodes`."""

    Omega: float
    A: float
    kind: str
    corner: bool


class SecondState(NamedTuple):
    """A steady state in the second approximation, as in `SecondStates`."""

    Omega: float
    A: float
    A_1: float
    phi: float
    stable: bool


class SecondCurvePoint(NamedTuple):
    """A point of a response curve in the second approximation, as in `SecondResponse`."""

    Omega: float
    A: float
    A_1: float
    phi: float
    stable: bool
    branch: int


class SecondFold(NamedTuple):
    """A fold in the second approximation, as in `SecondFolds`."""

    Omega: float
    A: float
    A_1: float
    kind: str
    corner: bool


class LocusPoint(NamedTuple):
    """A point of the fold locus, as in `FoldLocus`."""

    Omega: float
    A: float
    F_0: float
    branch: int


class Cusp(NamedTuple):
    """A cusp of the fold locus, as in `Cusps`."""

    F_0: float
    Omega: float
    A: float
    minimum: bool


class IsolaPoint(NamedTuple):
    """A point where an isolated curve is born, dies or merges, as in `IsolaPoints`."""

    F_0: float
    Omega: float
    A: float
    kind: str


class MeasuredState(NamedTuple):
    """One entry of `Measured`."""

    Omega: float
    A: float
    error: float
    stable: bool
    stops: int
    found: bool
    reason: str


class MeasuredFold(NamedTuple):
    """One entry of `MeasuredFolds`."""

    Omega: float
    A: float
    error: float
    error_of_A: float
    found: bool
    reason: str


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
    stable: npt.NDArray[np.bool_]
    stops: npt.NDArray[np.intp]
    found: npt.NDArray[np.bool_]
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
    found: npt.NDArray[np.bool_]
    reason: npt.NDArray[np.str_]
    message: str


class Measures(Protocol):
    """What an answer was asked of, as far as it can be held against the equation of motion."""

    def measured_states(self, found: SteadyStates, force: str | None) -> Measured:
        """See `SteadyStates.measure`."""
        ...

    def measured_folds(self, found: SaddleNodes, force: str | None) -> MeasuredFolds:
        """See `SaddleNodes.measure`."""
        ...


#: what may be drawn of a response curve
DRAWN = ("A", "phi", "transmissibility", "transmissibility_dB")
#: an answer of averaging alone, which knows no equation of motion
NOT_ASKED = "this answer was not asked of an oscillator: no equation of motion is known to measure it against"


#: an answer that is not of averaging
NOT_AVERAGED = "gradients are known of averaged answers, asked of an oscillator with a design: this is none"


def _given(model: Model | None) -> moves.Given:
    """Whose answer it is. Raises ValueError where nothing says it."""
    if model is None or not model.design:
        raise ValueError(NOT_AVERAGED)
    laws, numbers = model.laws, (*model.design, model.mu, model.zeta)
    if not laws.any:
        return moves.Given(model.mechanism, numbers, model.excitation)
    return moves.Given(model.mechanism, (*numbers, laws.eta, laws.c_2), model.excitation, laws.rubs)


@dataclass(frozen=True, eq=False)
class SteadyStates(Table):
    """Steady states, one entry each: flat arrays of one length.

    Omega, A -- frequency and amplitude, dimensionless
    stable   -- True where both eigenvalues of the Jacobian (28) have a negative real part
    F_0      -- the forcing, one number; an array with that of each state where several were asked for
    message  -- remarks in words; empty if there is nothing to say
    Omega_undecided -- those of the frequencies asked for at which doubles do not tell how many states there are
    """

    entry: ClassVar[Any] = State
    beside: ClassVar[tuple[str, ...]] = ("transmissibility_dB",)

    Omega: Floats
    A: Floats
    stable: npt.NDArray[np.bool_]
    F_0: float | Floats
    message: str
    Omega_undecided: Floats = field(default_factory=lambda: np.empty(0), kw_only=True)
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model = field(repr=False)
    _asked: Measures | None = field(default=None, kw_only=True, repr=False)

    @cached_property
    def phi(self) -> Floats:
        """Phase of u = A cos(Omega tau + phi) in radians, in [-pi, 0] (25); computed when first asked for."""
        h = self._model.averaged(self.A)[0]
        phase = self._model.flow.phase(self.Omega, self.A, *self._model.alike(self.Omega, self.A), h)
        return frozen(np.asarray(phase) + 0 * self.A)

    @property
    def force(self) -> float | Floats:
        """Amplitude of the force on the mass in each state: F_0, or F_0 Omega^2 for an excitation by inertia."""
        force: float | Floats = self._model.force(self.F_0, self.Omega)
        return force

    @cached_property
    def transmissibility(self) -> Floats:
        """Fundamental harmonic of what spring, damper and friction pass on, over `.force`, of each state.

        On a base that shakes it is as well the absolute displacement of the mass over that of the base.
        """
        h = self._model.averaged(self.A)[0]
        m, zeta = self._model.alike(self.Omega, self.A)
        return frozen(slow_flow.transmissibility(self.Omega, self.A, self.force, m, zeta, h))

    @property
    def transmissibility_dB(self) -> Floats:
        """The same in decibels, 20 log10; -inf where nothing is transmitted."""
        with np.errstate(divide="ignore"):
            return np.asarray(20.0 * np.log10(self.transmissibility))

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
        return of_states(self._model, self.Omega, self.A)

    def gradient(self) -> Gradient:
        """How A, phi and transmissibility of each state move with the parameters, F_0 and Omega, exactly.

        Where a state is a fold, or lies on a breakpoint at which the force jumps, it has no gradient, and `.status` and
        `.message` say so.
        """
        given = _given(self._model)
        return moves.of_states(given, self.Omega, self.A, self.F_0, self.phi, self.transmissibility)

    def measure(self, force: str | None = None) -> Measured:
        """How far each state is from the equation of motion (3): measured here and now, some 0.2 ms for each.

        Newton's iteration leads from a state to a motion of half to one and a half times its amplitude; of two states
        at one frequency that lead to the same motion, one is said to have none. `force`: "truncated" for (6),
        "untruncated" for (5), by default the one that was averaged. Raises ValueError where there is no such force, or
        where neither friction nor viscous damping lets a motion settle.
        """
        if self._asked is None:
            raise ValueError(NOT_ASKED)
        return self._asked.measured_states(self, force)


@dataclass(frozen=True, eq=False)
class FrequencyResponse(SteadyStates):
    """A response curve: points in order along each branch.

    branch -- number of the connected curve that a point lies on, from 0; isolated curves come last
    isola  -- for each branch, whether it is closed
    F_0    -- the forcing
    """

    entry: ClassVar[Any] = CurvePoint

    F_0: float
    branch: npt.NDArray[np.intp]
    isola: tuple[bool, ...]
    picture: ClassVar[str] = "response"

    def plot(self, ax: Any = None, *, of: str = "A") -> Any:
        """Draw the curve into Matplotlib axes, or new ones, and return these; stable is solid, unstable dashed.

        of -- what is drawn over Omega: "A", "phi", "transmissibility" or "transmissibility_dB"

        Raises ValueError for another one, ImportError without Matplotlib.
        """
        from slowflow import pictures

        return pictures.response(ax, self, validate.choice("of", of, DRAWN))


#: bits of a double
DOUBLES = 53


@dataclass(frozen=True, eq=False)
class Proved(Answer):
    """What is proved of the oscillator whose numbers are exactly the doubles that were given.

    proved  -- whether all of it is
    message -- what is not proved, and why; empty if there is nothing to say
    bits    -- of the arithmetic: `DOUBLES` of intervals of doubles, more of balls
    """

    proved: bool
    message: str
    bits: int


@dataclass(frozen=True, eq=False)
class ProvedStates(Proved):
    """All steady states at a frequency, by rising A; each interval of A holds one, no two the same.

    A       -- lowest and highest amplitude of each, shape (n, 2)
    stable  -- the sign of F_A (30), shape (n,)
    A_max   -- where it is proved there are no others up to this amplitude
    bounded -- whether it is proved that there are none above either, up to 2^60 times as high
    doubt   -- intervals of A in which it is not decided, shape (k, 2)
    """

    A: Floats
    stable: npt.NDArray[np.bool_]
    A_max: float
    bounded: bool
    doubt: Floats


@dataclass(frozen=True, eq=False)
class ProvedFolds(Proved):
    """All folds at a forcing, by rising Omega; each pair of intervals holds one, no two the same.

    Omega, A -- lowest and highest of each, shape (n, 2)
    kind     -- as in `SaddleNodes`, "" where the sign of F_AA is not proved
    corner   -- True where the fold sits on a breakpoint of the force
    A_max, bounded, doubt -- as in `ProvedStates`
    """

    Omega: Floats
    A: Floats
    kind: npt.NDArray[np.str_]
    corner: npt.NDArray[np.bool_]
    A_max: float
    bounded: bool
    doubt: Floats


@dataclass(frozen=True, eq=False)
class ProvedForcing(Proved):
    """A critical forcing: lowest and highest of F_0, Omega and A, each a pair of shape (2,); empty where there is none.

    kind -- of an onset, as in `SaddleNodeOnset`, "" if it is not proved
    """

    F_0: Floats
    Omega: Floats
    A: Floats
    kind: str


@dataclass(frozen=True, eq=False)
class Certificate(Answer):
    """What is proved at a forcing: `Oscillator.certify`. Print it.

    saddle_nodes -- all folds at F_0
    saddle_node_onset, detachment -- F_SN and F_cr
    amplitudes   -- all states at a frequency, None where none was asked for
    """

    F_0: float
    saddle_nodes: ProvedFolds
    saddle_node_onset: ProvedForcing
    detachment: ProvedForcing
    amplitudes: ProvedStates | None

    @property
    def proved(self) -> bool:
        """Whether all of it is."""
        parts = (self.saddle_nodes, self.saddle_node_onset, self.detachment, self.amplitudes)
        return all(part.proved for part in parts if part is not None)

    def __str__(self) -> str:
        return "\n".join(_in_words(self))


@dataclass(frozen=True, eq=False)
class SaddleNodes(Table):
    """Folds of the response curve at one forcing, by rising Omega: arrays of one length.

    kind   -- "jump-up": a sweep leaves the fold for a larger amplitude; "jump-down": for a smaller one
    corner -- True where the fold sits on a breakpoint of the force
    proof  -- enclosures of all folds, and whether these are proved to be all; None unless it was asked for
    """

    entry: ClassVar[Any] = SaddleNode

    Omega: Floats
    A: Floats
    kind: npt.NDArray[np.str_]
    corner: npt.NDArray[np.bool_]
    F_0: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    proof: ProvedFolds | None = field(default=None, kw_only=True)
    _model: Model = field(repr=False)
    _asked: Measures | None = field(default=None, kw_only=True, repr=False)

    @cached_property
    def validity(self) -> Validity:
        """How far each fold may be from the equation of motion, by measurement; looked up when first asked for."""
        return of_states(self._model, self.Omega, self.A, corner=bool(self.corner.any()))

    def gradient(self) -> Gradient:
        """How Omega and A of each fold move with the parameters and F_0, exactly; a corner moves with its breakpoint.

        Where a fold meets another, at a cusp or an isola point, or comes to a breakpoint or leaves it, it has no
        gradient, and `.status` and `.message` say so.
        """
        return moves.of_folds(_given(self._model), self.Omega, self.A, self.F_0, self.corner)

    def measure(self, force: str | None = None) -> MeasuredFolds:
        """How far each fold is from one of the equation of motion (3): measured here and now, some ms for each.

        The exact curve is followed from motions beside the fold, up to the first one that it meets. `force` and what
        is raised as in `SteadyStates.measure`.
        """
        if self._asked is None:
            raise ValueError(NOT_ASKED)
        return self._asked.measured_folds(self, force)

    picture: ClassVar[str] = "folds"

    def plot(self, ax: Any = None) -> Any:
        """Draw the folds, A over Omega, into Matplotlib axes, or new ones, and return these."""
        from slowflow import pictures

        return pictures.folds(ax, self)


#: why averaging's answers have these, and those of the second approximation have not
NOT_OF_SECOND = {
    "validity": "its errors are no table; docs/validity.md has what was measured of them",
    "measure": "averaging's answer has it, and steady_state the motion itself",
    "gradient": "its derivatives by parameters are not derived; averaging's answer has them",
}


class SecondTable(Table):
    """What answers of the second approximation share: why some of what averaging's have is not there."""

    def __getattr__(self, name: str) -> Any:
        """Raises AttributeError, with the reason where averaging's answers have what is asked for."""
        why = f": {NOT_OF_SECOND[name]}" if name in NOT_OF_SECOND else ""
        raise AttributeError(f"an answer of the second approximation has no {name}{why}")


@dataclass(frozen=True, eq=False)
class SecondStates(SecondTable):
    """Steady states in the second approximation, one entry each: flat arrays of one length.

    Omega, A -- frequency, and largest displacement
    A_1, phi -- amplitude of the first harmonic, and its phase in radians, in [-pi, 0]
    stable   -- True where the steady state is stable
    message  -- remarks in words; empty if there is nothing to say
    F_0      -- the forcing, one number; an array with that of each state where several were asked for
    force    -- amplitude of the force on the mass in each state
    """

    entry: ClassVar[Any] = SecondState
    beside: ClassVar[tuple[str, ...]] = ("transmissibility_dB",)

    Omega: Floats
    A: Floats
    A_1: Floats
    phi: Floats
    stable: npt.NDArray[np.bool_]
    message: str
    F_0: float | Floats = field(kw_only=True)
    force: Floats = field(kw_only=True, repr=False)

    @property
    def transmissibility(self) -> Floats:
        """Fundamental harmonic of what spring, damper and friction pass on, over `.force`: the force less inertia."""
        return np.asarray(np.abs(1.0 + self.Omega**2 * self.A_1 / self.force * np.exp(1j * self.phi)))

    @property
    def transmissibility_dB(self) -> Floats:
        """The same in decibels, 20 log10; -inf where nothing is transmitted."""
        with np.errstate(divide="ignore"):
            return np.asarray(20.0 * np.log10(self.transmissibility))


@dataclass(frozen=True, eq=False)
class SecondResponse(SecondStates):
    """A response curve in the second approximation: points in order along each branch.

    branch, isola, F_0 -- as in `FrequencyResponse`
    """

    entry: ClassVar[Any] = SecondCurvePoint

    F_0: float = field(kw_only=True)
    branch: npt.NDArray[np.intp]
    isola: tuple[bool, ...]
    picture: ClassVar[str] = "response"

    def plot(self, ax: Any = None, *, of: str = "A") -> Any:
        """Draw the curve as `FrequencyResponse.plot` does; `of` may be "A_1" too."""
        from slowflow import pictures

        return pictures.response(ax, self, validate.choice("of", of, ("A_1", *DRAWN)))


@dataclass(frozen=True, eq=False)
class SecondFolds(SecondTable):
    """Folds of the response curve in the second approximation, by rising Omega: arrays of one length.

    Omega, A, A_1 -- as in `SecondStates`; kind and corner as in `SaddleNodes`
    """

    entry: ClassVar[Any] = SecondFold

    Omega: Floats
    A: Floats
    A_1: Floats
    kind: npt.NDArray[np.str_]
    corner: npt.NDArray[np.bool_]
    F_0: float
    message: str
    #: folds that the message says are left out
    _lost: int = field(default=0, kw_only=True, repr=False)
    picture: ClassVar[str] = "folds"

    def plot(self, ax: Any = None) -> Any:
        """Draw the folds, A over Omega, into Matplotlib axes, or new ones, and return these."""
        from slowflow import pictures

        return pictures.folds(ax, self)


@dataclass(frozen=True, eq=False)
class SaddleNodeOnset(Single):
    """The lowest forcing that has a fold; None and a message where there is none.

    kind -- "cusp" (the response gets a vertical inflection), "isola" (an isolated curve is born), "corner" (at a
            breakpoint)
    untruncated -- the onset of the untruncated force, where this one is on a corner that only the truncation makes
    """

    F_SN: float | None
    Omega: float | None
    A: float | None
    kind: str
    message: str
    untruncated: SaddleNodeOnset | None = field(default=None, kw_only=True)
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)
    #: where there is none, what batches say
    _status: Status = field(default=Status.NONE, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How F_SN, Omega and A move with the parameters, exactly; on a breakpoint with that.

        Where more than two folds are born together there is no gradient, and `.status` and `.message` say so. Of two
        onsets at one forcing, which it does not look for, it is that of the one which is given.
        """
        kind = OnsetKind[self.kind.upper() or "NO"]
        return moves.of_onset(_given(self._model), self.F_SN, self.Omega, self.A, kind)


@dataclass(frozen=True, eq=False)
class FoldLocus(Table):
    """The saddle nodes of every forcing: points in order along each branch, in arrays of one length.

    Omega, A, F_0 -- a fold and the forcing that has it
    branch        -- number of the connected branch that a point lies on, from 0; breakpoints separate branches
    """

    entry: ClassVar[Any] = LocusPoint

    Omega: Floats
    A: Floats
    F_0: Floats
    branch: npt.NDArray[np.intp]
    message: str
    picture: ClassVar[str] = "locus"

    def plot(self, ax: Any = None) -> Any:
        """Draw F_0 over Omega into Matplotlib axes, or new ones, and return these.

        The axes end at four times the least forcing: the locus goes on to forcings and frequencies without a bound.
        """
        from slowflow import pictures

        return pictures.locus(ax, self)


@dataclass(frozen=True, eq=False)
class Cusps(Table):
    """Cusps of the fold locus, F = F_A = F_AA = 0, by rising amplitude: arrays of one length.

    minimum -- True where two folds come into being as the forcing rises; False where two meet and vanish
    """

    entry: ClassVar[Any] = Cusp

    F_0: Floats
    Omega: Floats
    A: Floats
    minimum: npt.NDArray[np.bool_]
    message: str
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How F_0, Omega and A of each cusp move with the parameters, exactly."""
        return moves.of_cusps(_given(self._model), self.F_0, self.Omega, self.A)


@dataclass(frozen=True, eq=False)
class IsolaPoints(Table):
    """Points with F = F_A = F_Omega = 0, by rising amplitude: arrays of one length.

    kind -- what happens there as the forcing rises: an isolated curve's "birth", its "death", or a "merger" of two
            parts of the response curve (or their separation)
    """

    entry: ClassVar[Any] = IsolaPoint

    F_0: Floats
    Omega: Floats
    A: Floats
    kind: npt.NDArray[np.str_]
    message: str
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How F_0, Omega and A of each isola point move with the parameters, exactly."""
        return moves.of_isola_points(_given(self._model), self.F_0, self.Omega, self.A)


@dataclass(frozen=True, eq=False)
class Peak(Single):
    """The highest peak of the response at one forcing, isolas included; None and a message where there is none."""

    A: float | None
    Omega: float | None
    F_0: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)
    #: where there is none, what batches say
    _status: Status = field(default=Status.NONE, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How A and Omega move with the parameters and F_0, exactly; a peak at Omega = 0 stays there.

        Where the peak is an isola point, or lies on a breakpoint at which the force jumps, it has no gradient, and
        `.status` and `.message` say so. Of two peaks of one height it is that of the one which is given.
        """
        return moves.of_peak(_given(self._model), self.A, self.Omega, self.F_0)


@dataclass(frozen=True, eq=False)
class Detachment(Single):
    """The lowest forcing that reaches u_cr, its frequency, and u_cr; None and a message where there is no u_cr."""

    F_cr: float | None
    Omega_cr: float | None
    u_cr: float | None
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How F_cr, Omega_cr and u_cr move with the parameters, exactly."""
        return moves.of_detachment(_given(self._model), self.F_cr, self.Omega_cr, self.u_cr)


def joined(*remarks: Any) -> str:
    """Remarks joined into one message."""
    return "; ".join(str(remark) for remark in remarks if remark)


def _in_words(found: Certificate) -> Iterator[str]:
    """A certificate, line by line."""
    folds = found.saddle_nodes
    yield f"Folds at F_0 = {found.F_0:.17g}: {_verdict(folds, f'{len(folds.A)} and no others')}"
    for Omega, A, kind, corner in zip(folds.Omega, folds.A, folds.kind, folds.corner, strict=True):
        where = " on a breakpoint" if corner else ""
        yield f"  Omega in {_interval(Omega)}, A in {_interval(A)}  {kind}{where}"
    states = found.amplitudes
    if states is not None:
        yield f"States at this frequency: {_verdict(states, f'{len(states.A)} and no others')}"
        for A, stable in zip(states.A, states.stable, strict=True):
            yield f"  A in {_interval(A)}  {'stable' if stable else 'unstable'}"
    for what, forcing in (("Onset F_SN", found.saddle_node_onset), ("Detachment F_cr", found.detachment)):
        yield f"{what}: {_verdict(forcing, forcing.kind)}"
        if forcing.F_0.size:
            yield f"  F_0 in {_interval(forcing.F_0)}, Omega in {_interval(forcing.Omega)}, A in {_interval(forcing.A)}"


def _verdict(found: Proved, what: str) -> str:
    proved = "proved" if found.bits == DOUBLES else f"proved in balls of {found.bits} bits"
    return joined(joined(proved if found.proved else "not proved", what if found.proved else ""), found.message)


def _interval(ends: Floats) -> str:
    """With all digits that doubles need."""
    return f"[{ends[0]:.17g}, {ends[1]:.17g}]"
