"""Many designs in the second approximation: in go arrays of designs, out come critical forcings, folds and peaks.

The answers are those of `slowflow.averaged.batches`, with the largest displacement as A. A design has the status
`Status.NONE` where the second approximation has no answer though averaging may have one, as where its harmonics are not
small, and `Status.INVALID` also where the harmonics of its force are not derived. Designs that are excited by inertia
are answered one by one, on NumPy; states and curves of all designs one by one, some milliseconds each.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from slowflow import validate
from slowflow.answer import frozen
from slowflow.averaged import asked
from slowflow.averaged.batches import AlongCurves, AtFrequency, Codes, Detachments, Folds, Onsets, Peaks, States
from slowflow.averaged.many import Designs
from slowflow.averaged.questions import Averaged
from slowflow.mechanism import Floats
from slowflow.results import InDecibels, Remark
from slowflow.second.questions import SecondApproximation
from slowflow.transmitted import Transmitted, in_motion
from slowflow.transmitted import asked as asked_of
from slowflow_kernels import motion
from slowflow_kernels.conventions import OnsetKind, Status

#: points of curves beyond the samples: those of `asked.curves`, and what is put where the harmonics change fast
MORE_POINTS = 4 * asked.MORE_POINTS
#: why a question about designs has no answer here, where it has one of averaging
UNANSWERED = {
    "certify": "nothing is proved of the second approximation",
    **dict.fromkeys(("margins", "hysteresis", "isolation", "spectrum"), "it is put together from averaging's answers"),
    **dict.fromkeys(("at_rest", "transient", "shock_spectrum"), "it is asked of the designs, at each depth the same"),
}


@dataclass(frozen=True, eq=False)
class ManySecondStates(InDecibels, AtFrequency):
    """The steady states at one frequency and forcing, for each design; A to stable have one more axis, of places.

    A, A_1, phi, stable -- as in `SecondStates`, by the order of a single answer, then NaN and 0; A = 0 where friction
              holds the mass at rest, with `Status.STICKS` if nothing else is there
    count  -- how many states there are, also where they are more than places
    undecided -- 1 where averaging has more
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType(dict.fromkeys(("A", "A_1", "phi", "stable"), "place"))

    A: Floats
    A_1: Floats
    phi: Floats
    stable: Codes
    count: Codes
    undecided: Codes
    status: Codes

    @cached_property
    def transmissibility(self) -> Floats:
        """As of single `SecondStates`; NaN in an empty place. Computed when first asked for."""
        return _transmissibility(self, self._frequency)

    def transmitted(self, of: str = "force") -> Transmitted:
        """As of single `SecondStates`, NaN in an empty place; some 0.1 ms for each state."""
        return _transmitted(self, of, np.broadcast_to(self._frequency, self.A.shape))


@dataclass(frozen=True, eq=False)
class ManySecondCurves(InDecibels, AlongCurves):
    """The response curve at one forcing, for each design; what has points has one more axis, as in `Curves`.

    A, A_1, phi, stable -- as in `SecondResponse`
    branch, isola, points -- as in `Curves`
    undecided -- 1 where points of averaging's curve are left out, at which the harmonics are not small
    """

    inner: ClassVar[Mapping[str, str]] = MappingProxyType(
        dict.fromkeys(("Omega", "A", "A_1", "phi", "stable", "branch", "isola"), "point")
    )

    Omega: Floats
    A: Floats
    A_1: Floats
    phi: Floats
    stable: Codes
    branch: npt.NDArray[np.int16]
    isola: Codes
    points: npt.NDArray[np.intc]
    undecided: Codes
    status: Codes

    @cached_property
    def transmissibility(self) -> Floats:
        """As of single `SecondResponse`; NaN behind the last point. Computed when first asked for."""
        return _transmissibility(self, self.Omega)

    def transmitted(self, of: str = "force") -> Transmitted:
        """As of single `SecondResponse`, NaN behind the last point; some 0.1 ms for each point."""
        return _transmitted(self, of, self.Omega)


def _transmissibility(found: Any, Omega: Floats) -> Floats:
    """Of states with the first harmonic's amplitude and phase."""
    with np.errstate(all="ignore"):  # empty places
        passed = motion.transmissibility(Omega, found.A_1, found._force_at(Omega), found.phi)
        return frozen(in_motion(found.A, passed))


def _transmitted(found: Any, of: str, Omega: Floats) -> Transmitted:
    """Of states of each design, one design after the other."""
    from slowflow.second.wave import Waves

    designs = found._designs
    asked_of(of, inertial=designs.excitation != "force")
    columns = Transmitted(*(np.full(found.A.shape, np.nan) for _ in Transmitted._fields))
    here = ~np.isnan(found.A)
    for at, numbers, (F_0,) in designs._each(here.any(axis=-1), found._F_0):
        model, rows = designs.model(dict(zip(designs.values, numbers, strict=True))), (*at, here[at])
        forcing = np.full(np.count_nonzero(here[at]), F_0)
        passed = Waves(model, Omega[rows], found.A[rows], found.phi[rows], forcing).transmitted(of)
        for column, value in zip(columns, passed, strict=True):
            column[rows] = value
    return Transmitted(*map(frozen, columns))


@dataclass(frozen=True)
class SecondDesigns:
    """The questions of many designs in the second approximation; `.second_approximation` of designs makes it.

    `workers` as of the designs.

    first -- the designs, averaged
    """

    first: Designs

    def __getattr__(self, name: str) -> Any:
        """Raises AttributeError, with the reason where averaging answers the question of that name."""
        why = f": {UNANSWERED[name]}" if name in UNANSWERED else ""
        raise AttributeError(f"the second approximation of many designs has no {name}{why}")

    def detachment(self, *, workers: int = 1) -> Detachments:
        """The lowest forcing whose largest displacement is u_cr, and its frequency, of every design."""
        return Detachments(*self.first.ask(DETACHMENT, workers), _designs=self.first)

    def saddle_node_onset(self, *, workers: int = 1) -> Onsets:
        """F_SN of every design whose onset is a cusp, with its Omega and largest displacement."""
        return Onsets(*self.first.ask(ONSET, workers), _designs=self.first)

    def saddle_nodes(self, F_0: Any, *, places: int = 6, workers: int = 1) -> Folds:
        """Every fold at F_0 that is found along the curve; `undecided` where one was lost.

        F_0 and places as of the designs.
        """
        places = validate.count("places", places, least=1)
        return Folds(*self.first.ask(SADDLE_NODES, workers, F_0, places), _designs=self.first, _F_0=F_0)

    def amplitudes(self, *, Omega: Any, F_0: Any, places: int = 6) -> ManySecondStates:
        """Every steady state at (Omega, F_0), which broadcast with the designs; one by one, as of single ones."""
        places = validate.count("places", places, least=1)
        A, A_1, phi, stable, count, undecided, status = self.first.ask(AMPLITUDES, 1, F_0, places, Omega=Omega)
        given: dict[str, Any] = {"_designs": self.first, "_F_0": F_0, "_Omega": Omega}
        none = np.zeros((*count.shape, 1))
        flags: Any = np.zeros(count.shape, np.int8)
        at_rest = States(none, flags[..., np.newaxis], flags, flags, flags, **given)
        columns = ((A, 0.0), (A_1, 0.0), (phi, at_rest.phi[..., 0]), (stable, 1))
        self.first._put_in_what_rests(Omega, F_0, columns, count, status)
        return ManySecondStates(A, A_1, phi, stable, count, undecided, status, **given)

    def frequency_response(
        self, F_0: Any, *, samples: int = 1000, Omega: tuple[float, float] = validate.WINDOW
    ) -> ManySecondCurves:
        """The response curve of every design at F_0, in the window `Omega`; one by one, as of single ones.

        `Status.TOO_MANY` where a curve has more points than samples and 256 more, which has none then.
        """
        found = self.first.ask(_curves(*validate.curve(samples, Omega)), 1, F_0)
        return ManySecondCurves(*found, _designs=self.first, _F_0=F_0)

    def peak(self, F_0: Any, *, workers: int = 1) -> Peaks:
        """The highest peak at F_0 beside averaging's: its largest displacement and frequency."""
        return Peaks(*self.first.ask(PEAK, workers, F_0), _designs=self.first, _F_0=F_0)


def _second(one: Callable[..., tuple[Any, ...]]) -> Callable[..., tuple[Any, ...]]:
    """The answer of one design, from its averaged oscillator or from None for a blank one."""

    def ask(oscillator: Averaged | None, *arguments: Any) -> tuple[Any, ...]:
        return one(None if oscillator is None else SecondApproximation(oscillator), *arguments)

    return ask


def _onset(second: SecondApproximation | None, _: int) -> tuple[Any, ...]:
    if second is None:
        return np.nan, np.nan, np.nan, 0, 0, Status.NONE
    found = second.saddle_node_onset()
    at_rest = Remark.FOLDS_AT_REST in second.first.saddle_node_onset().remarks
    if found.F_SN is None:
        return np.nan, np.nan, np.nan, 0, at_rest, found._status
    return found.F_SN, found.Omega, found.A, OnsetKind.CUSP, at_rest, Status.OK


def _saddle_nodes(second: SecondApproximation | None, F_0: float, places: int) -> tuple[Any, ...]:
    found = None if second is None else second.saddle_nodes(F_0)
    return asked.in_places(found, places, found is not None and found._lost > 0)


def _peak(second: SecondApproximation | None, F_0: float, _: int) -> tuple[Any, ...]:
    found = second and second.peak(F_0)
    if not found or found.A is None:
        return np.nan, np.nan, found._status if found else Status.NONE
    return found.A, found.Omega, Status.OK


def _detachment(second: SecondApproximation | None, _: int) -> tuple[Any, ...]:
    found = second and second.detachment()
    if not found or found.F_cr is None:
        return np.nan, np.nan, np.nan if not found or found.u_cr is None else found.u_cr, Status.NONE
    return found.F_cr, found.Omega_cr, found.u_cr, Status.OK


def _amplitudes(second: SecondApproximation | None, F_0: float, Omega: float, places: int) -> tuple[Any, ...]:
    A, A_1, phi = (np.full(places, np.nan) for _ in range(3))
    stable = np.zeros(places, np.int8)
    if second is None:
        return A, A_1, phi, stable, 0, False, Status.NONE
    found = second.amplitudes(Omega=Omega, F_0=F_0)
    moves = found.A > 0  # those at rest are put in for all designs together
    count = int(np.count_nonzero(moves))
    n = min(places, count)
    for column, of in ((A, found.A), (A_1, found.A_1), (phi, found.phi), (stable, found.stable)):
        column[:n] = of[moves][:n]
    fits = Status.OK if n == count else Status.TOO_MANY
    return A, A_1, phi, stable, count, found._lost, fits if count else Status.NONE


def _curves(samples: int, window: tuple[float, float]) -> asked.Question:
    """The question about response curves of so many samples in a window of Omega."""
    n = samples + MORE_POINTS

    def one(second: SecondApproximation | None, F_0: float, _: int) -> tuple[Any, ...]:
        found = None if second is None else second.frequency_response(F_0, samples=samples, Omega=window)
        size = 0 if found is None else len(found)
        Omega, A, A_1, phi = (np.full(n, np.nan) for _ in range(4))
        branch = np.full(n, -1, np.int16)
        stable, isola = np.zeros(n, np.int8), np.zeros(n, np.int8)
        columns: tuple[npt.NDArray[Any], ...] = Omega, A, A_1, phi, stable, branch, isola
        lost = found is not None and found._lost
        if found is None or not 0 < size <= n:
            return *columns, size, lost, Status.TOO_MANY if size else Status.NONE
        own = found.Omega, found.A, found.A_1, found.phi, found.stable, found.branch
        for column, of in zip(columns, (*own, np.array(found.isola)[found.branch]), strict=True):
            column[:size] = of
        return *columns, size, lost, Status.OK

    points = [*[((n,), float)] * 4, ((n,), np.int8), ((n,), np.int16), ((n,), np.int8), ((), np.intc)]
    return asked.Question(_second(one), lambda _: [*points, *[((), np.int8)] * 2], None, 1, by_inertia=False)


AMPLITUDES = asked.Question(
    _second(_amplitudes),
    lambda k: [*[((k,), float)] * 3, ((k,), np.int8), *[((), np.int8)] * 3],
    None,
    at_once=1,
    by_inertia=False,
)


def _in_lanes(question: asked.Question, one: asked.One, name: str, at_once: int) -> asked.Question:
    """The same question of the second approximation: by itself on NumPy, by that function of the compiled solvers."""
    return replace(
        question,
        one=_second(one),
        batch=lambda native: getattr(native, name),
        at_once=at_once,
        by_inertia=False,
        abreast=None,
    )


DETACHMENT = _in_lanes(asked.DETACHMENT, _detachment, "many_second_detachment", 2**13)
ONSET = _in_lanes(asked.ONSET, _onset, "many_second_onset", 2**13)
SADDLE_NODES = _in_lanes(asked.SADDLE_NODES, _saddle_nodes, "many_second_saddle_nodes", 2**9)
PEAK = _in_lanes(asked.PEAK, _peak, "many_second_peak", 2**9)
