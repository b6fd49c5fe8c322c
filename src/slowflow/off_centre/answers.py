"""What the questions off the centre are answered with: as `slowflow.results`, with the mean displacement B beside A."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, NamedTuple, NoReturn

import numpy as np
import numpy.typing as npt

from slowflow import loads, validate
from slowflow.answer import Single, Table, frozen
from slowflow.gradient import Gradient
from slowflow.measured.validity import Validity, off_centre
from slowflow.model import Floats, Model
from slowflow.off_centre import moves
from slowflow.off_centre.flow import Flow
from slowflow.off_centre.moves import Given
from slowflow.results import DRAWN, NOT_ASKED, InDecibels, Measured, MeasuredFolds, Measures, Remark
from slowflow.transmitted import in_motion
from slowflow_kernels.conventions import Pinned
from slowflow_support.errors import Refused

NOT_MEASURED = "off the centre states and folds are measured, as amplitudes(...).measure(): this answer is neither"
WITHIN = "no gradient is derived where the mean turns back at the peak"


class Balanced:
    """What answers share that stand on the balance of the mean."""

    def measure(self) -> NoReturn:
        """Raises NotAvailable: off the centre states and folds are held against the equation of motion."""
        raise validate.NotAvailable(NOT_MEASURED)


class AveragedOff:
    """What answers share that averaging gives: a place of rest is one of the equation of motion itself."""

    #: of an answer, where its forcing is
    forcing: ClassVar[str] = "F_0"

    @cached_property
    def validity(self) -> Validity:
        """That how far these motions may be from the equation of motion was not measured off the centre."""
        of: Any = self
        return off_centre(of._model.mu, getattr(of, self.forcing), getattr(of, OMEGA.get(self.forcing, "Omega")), of.A)


#: the frequency of an answer that has another name
OMEGA = {"F_cr": "Omega_cr"}


class Rest(NamedTuple):
    """A place of rest, as in `RestPositions`."""

    u: float
    stiffness: float
    stable: bool


class OffCentreState(NamedTuple):
    """A steady state, as in `OffCentreStates`."""

    Omega: float
    A: float
    B: float
    phi: float
    stable: bool


class OffCentrePoint(NamedTuple):
    """A point of a response curve, as in `OffCentreResponse`."""

    Omega: float
    A: float
    B: float
    phi: float
    stable: bool
    branch: int


class OffCentreFold(NamedTuple):
    """A fold, as in `OffCentreFolds`."""

    Omega: float
    A: float
    B: float
    kind: str
    corner: bool


@dataclass(frozen=True, eq=False)
class RestPositions(Balanced, Table):
    """Where the mass stands without forcing and friction, f(u) = load, by rising u; friction holds it near by too.

    u      -- displacement
    stiffness -- df/du there over k_v: its square root is the frequency of small motions about it
    stable -- where that is positive
    load   -- the static load over k_v L
    """

    entry: ClassVar[Any] = Rest

    u: Floats
    stiffness: Floats
    stable: npt.NDArray[np.bool_]
    load: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How u and the stiffness of each place move with the parameters and the load, exactly.

        Where two places meet, and where one is a breakpoint of the force, there is none, and `.status` and `.message`
        say so. Raises as `OffCentreStates.gradient`.
        """
        return moves.of_rest(Given.of(self._model, self.load), self.u)


@dataclass(frozen=True, eq=False)
class OffCentreStates(AveragedOff, InDecibels, Table):
    """Steady states u = B + A cos(Omega tau + phi), one entry each, by the order of the frequencies, then by rising A.

    Omega, A, B -- frequency, amplitude and mean displacement, dimensionless; `u_max` is the largest |u|, |B| + A. Where
                   friction holds the mass A = 0, and B each stable place of rest, about which it may hold it as well
    stable      -- where F_A (30) along the balance of the mean is positive, and the mean stiffness too
    F_0, load   -- forcing, an array with that of each state where several were asked for, and static load over k_v L
    message     -- remarks in words; empty if there is nothing to say
    Omega_undecided -- those of the frequencies asked for at which doubles do not tell how many states there are
    """

    entry: ClassVar[Any] = OffCentreState
    beside: ClassVar[tuple[str, ...]] = ("u_max", "transmissibility_dB")

    Omega: Floats
    A: Floats
    B: Floats
    stable: npt.NDArray[np.bool_]
    F_0: float | Floats
    load: float
    message: str
    Omega_undecided: Floats = field(default_factory=lambda: np.empty(0), kw_only=True)
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)
    _h: Floats = field(repr=False)
    _flow: Flow = field(repr=False)
    _asked: Measures | None = field(default=None, kw_only=True, repr=False)

    @cached_property
    def phi(self) -> Floats:
        """Phase in radians, in [-pi, 0] (25); computed when first asked for."""
        return frozen(np.asarray(self._flow.phase(self.Omega, self.A, self._h)) + 0 * self.A)

    @property
    def u_max(self) -> Floats:
        """The largest |u| of each motion: |B| + A."""
        return np.asarray(np.abs(self.B) + self.A)

    @cached_property
    def transmissibility(self) -> Floats:
        """Fundamental harmonic of what spring, damper and friction pass on, over the force, of each state.

        On a base that shakes it is as well the absolute displacement of the mass over that of the base.
        """
        with np.errstate(divide="ignore", invalid="ignore"):  # of a mass at rest on a base that hardly shakes
            passed = self._flow.transmissibility(self.Omega, self.A, self.F_0, self._h)
        return frozen(in_motion(self.A, passed))

    def measure(self, force: str | None = None) -> Measured:
        """How far each state is from the equation of motion, here and now; see `SteadyStates.measure`.

        `.A` of the answer is the largest |u| of the motion, and `.error` that of `u_max`.
        """
        if self._asked is None:
            raise Refused(NOT_ASKED)
        return self._asked.measured_states(self, force, self.B)

    def gradient(self) -> Gradient:
        """How A, B, phi and transmissibility of each state move with the parameters, the load, F_0 and Omega, exactly.

        Where a state is a fold it has no gradient, and `.status` and `.message` say so. Raises NotAvailable where it is
        not known how the force moves with the design.
        """
        of = {name: name for name in ("A", "B", "phi", "transmissibility")}
        point = self.A, self.B, self.Omega, self.F_0
        return moves.gradient(Given.of(self._model, self.load), Pinned.STATE, point, of, ("F_0", "Omega"))


@dataclass(frozen=True, eq=False)
class OffCentreResponse(OffCentreStates):
    """A response curve off the centre: points in order along each branch.

    branch -- number of the connected curve that a point lies on, from 0; isolated curves come last
    isola  -- for each branch, whether it is closed
    F_0    -- the forcing
    """

    entry: ClassVar[Any] = OffCentrePoint

    F_0: float
    branch: npt.NDArray[np.intp]
    isola: tuple[bool, ...]
    picture: ClassVar[str] = "response"

    def plot(self, ax: Any = None, *, of: str = "A") -> Any:
        """Draw the curve into Matplotlib axes, or new ones, and return these; stable is solid, unstable dashed.

        of -- what is drawn over Omega: "A", "B", "phi", "transmissibility" or "transmissibility_dB"

        Raises ValueError for another one, ImportError without Matplotlib.
        """
        from slowflow import pictures

        return pictures.response(ax, self, validate.choice("of", of, ("B", *DRAWN)))


@dataclass(frozen=True, eq=False)
class OffCentreFolds(AveragedOff, Table):
    """Folds of the response curve at one forcing, by rising Omega: arrays of one length.

    Omega, A, B -- as in `OffCentreStates`
    kind        -- "jump-up": a sweep leaves the fold for a larger amplitude; "jump-down": for a smaller one; "unstable"
                   where the motions that meet are both not stable
    corner      -- True where the fold sits where the motion comes to a breakpoint
    """

    entry: ClassVar[Any] = OffCentreFold

    Omega: Floats
    A: Floats
    B: Floats
    kind: npt.NDArray[np.str_]
    corner: npt.NDArray[np.bool_]
    F_0: float
    load: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)
    _asked: Measures | None = field(default=None, kw_only=True, repr=False)
    picture: ClassVar[str] = "folds"

    def plot(self, ax: Any = None) -> Any:
        """Draw those at which a sweep jumps, A over Omega, into Matplotlib axes, or new ones, and return these."""
        from slowflow import pictures

        return pictures.folds(ax, self)

    def measure(self, force: str | None = None) -> MeasuredFolds:
        """How far each fold is from one of the exact curve, here and now, about a second; see `SaddleNodes.measure`.

        `.A` of the answer is the largest |u| at the fold, and `.error_of_A` that of |B| + A.
        """
        if self._asked is None:
            raise Refused(NOT_ASKED)
        return self._asked.measured_folds(self, force, self.B)

    def gradient(self) -> Gradient:
        """How Omega, A and B of each fold move with the parameters, the load and F_0, exactly.

        Where a fold meets another, or sits on a corner that a jump of the force makes, it has no gradient, and
        `.status` and `.message` say so. Raises as `OffCentreStates.gradient`.
        """
        kinds = np.where(self.corner, int(Pinned.CORNER_FOLD), int(Pinned.FOLD))
        of = {name: name for name in ("Omega", "A", "B")}
        point = self.A, self.B, self.Omega, self.F_0
        return moves.gradient(Given.of(self._model, self.load), kinds, point, of, ("F_0",))


@dataclass(frozen=True, eq=False)
class OffCentreDetachment(Balanced, AveragedOff, Single):
    """The lowest forcing for which |B| + A reaches u_cr; None and a message where there is none.

    F_cr, Omega_cr -- forcing and frequency
    A, B           -- amplitude and mean displacement of the motion
    """

    F_cr: float | None
    Omega_cr: float | None
    A: float | None
    B: float | None
    load: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)
    forcing: ClassVar[str] = "F_cr"

    def gradient(self) -> Gradient:
        """How F_cr, Omega_cr, A and B move with the parameters and the load, exactly; one at rest stays there.

        Raises as `OffCentreStates.gradient`.
        """
        kind = Pinned.CORNER_REST if self.Omega_cr == 0 else Pinned.CORNER_TOP
        of = {"F_cr": "F_0", "Omega_cr": "Omega", "A": "A", "B": "B"}
        given = Given.of(self._model, self.load).first()
        return moves.gradient(given, kind, (self.A, self.B, self.Omega_cr, self.F_cr), of)


@dataclass(frozen=True, eq=False)
class OffCentrePeak(Balanced, AveragedOff, Single):
    """How far motions at one forcing go, isolated curves included; None and a message where there is no motion.

    A, B, Omega -- the largest amplitude, its mean displacement and its frequency
    u_max, Omega_max -- the largest |u|, |B| + A, which is what a stroke has to hold, and its frequency; it may be that
                   of another motion

    Of motions whose mean stiffness is positive, as that of stable ones is.
    """

    A: float | None
    B: float | None
    Omega: float | None
    u_max: float | None
    Omega_max: float | None
    F_0: float
    load: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)
    _turns: bool = field(default=False, kw_only=True, repr=False)

    def gradient(self) -> Gradient:
        """How A, B and Omega move with the parameters, the load and F_0, exactly, and u_max if it is that motion's.

        A peak at Omega = 0 stays there. Raises as `OffCentreStates.gradient`, and where the mean turns back there.
        """
        if self._turns:
            raise validate.NotAvailable(WITHIN)
        kind = Pinned.STATE if self.Omega == 0 else Pinned.PEAK
        named = ("A", "B", "Omega", *(["u_max"] if self.Omega == self.Omega_max else []))
        point = self.A, self.B, self.Omega, self.F_0
        return moves.gradient(Given.of(self._model, self.load), kind, point, {name: name for name in named}, ("F_0",))


@dataclass(frozen=True, eq=False)
class OffCentreOnset(Balanced, AveragedOff, Single):
    """The lowest forcing for which a stable motion ends at a fold; None and a message where none is found.

    F_SN, Omega -- forcing and frequency
    A, B        -- amplitude and mean displacement
    kind        -- "cusp" (the response gets a vertical inflection), "isola" (an isolated curve is born), "corner"
                   (where the motion comes to a jump of the force)
    """

    F_SN: float | None
    Omega: float | None
    A: float | None
    B: float | None
    kind: str
    load: float
    message: str
    remarks: Remark = field(default=Remark(0), kw_only=True)
    _model: Model | None = field(default=None, kw_only=True, repr=False)
    forcing: ClassVar[str] = "F_SN"

    def gradient(self) -> Gradient:
        """How F_SN, Omega, A and B move with the parameters and the load, exactly.

        On a corner that a jump of the force makes there is no gradient, nor where more than two folds are born
        together, and `.status` and `.message` say so. Raises as `OffCentreStates.gradient`.
        """
        kinds = {"cusp": Pinned.CUSP, "isola": Pinned.ISOLA}
        of = {"F_SN": "F_0", "Omega": "Omega", "A": "A", "B": "B"}
        point = self.A, self.B, self.Omega, self.F_SN
        return moves.gradient(Given.of(self._model, self.load), kinds.get(self.kind, Pinned.CORNER_END), point, of)


@dataclass(frozen=True, eq=False)
class OffCentreIsolation(loads.Isolation):
    """From where on every stable motion transmits less than the force, as `slowflow.loads.Isolation`.

    B    -- the mean displacement there, None as A is
    load -- the static load over k_v L
    """

    B: float | None = field(kw_only=True)
    load: float = field(kw_only=True)

    def gradient(self) -> Gradient:
        """How Omega, A and B move with the parameters, the load and F_0, exactly; see `slowflow.loads.Isolation`.

        Raises as `OffCentreStates.gradient`.
        """
        given, point = Given.of(self._model, self.load), (self.A, self.B, self.Omega, self.F_0)
        if self.at_fold:
            of = {name: name for name in ("Omega", "A", "B")}
            return moves.gradient(given, Pinned.FOLD, point, of, ("F_0",))
        return moves.of_isolation(given, point)
