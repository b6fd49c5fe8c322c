# mypy: disable-error-code="empty-body"
"""Types of questions in SI units, for type checkers: their arguments, and the numbers that each returns.

Nothing is of these classes when a program runs: an answer is `Quantities`, whose numbers are read by name. Which of the
declared numbers an answer has, its question says; by another excitation F is called Y, a or U, and a load adds a mean
displacement.
"""

from __future__ import annotations

from typing import Generic, TypedDict, TypeVar

import numpy as np
import numpy.typing as npt

from slowflow.answers import certificate, validity
from slowflow.answers.quantities import Quantities
from slowflow.answers.results import Remark
from slowflow.answers.table import SameColumns
from slowflow.core.mechanism import Flags, Floats, Ints

Strings = npt.NDArray[np.str_]


T = TypeVar("T")
Kind = TypeVar("Kind")
Dimensionless = TypeVar("Dimensionless", covariant=True)


class Amplitude(TypedDict, Generic[T], total=False):
    """The amplitude of the excitation by its letter: force, displacement or acceleration of the base, unbalance."""

    F: T
    Y: T
    a: T
    U: T


class Excited(Generic[T]):
    """With the amplitude of the excitation."""

    F: T
    Y: T
    a: T
    U: T


class Measured(Quantities):
    """Motions of the equation of motion, one for each entry of an averaged answer: of its `measure`."""

    answer: validity.Measured | validity.MeasuredFolds
    f: Floats
    A: Floats
    error: Floats
    error_of_A: Floats
    stable: Flags
    stops: Ints
    found: Flags
    reason: Strings
    message: str


class MeasuredPoint(Quantities, Excited[float | None]):
    """The point of the equation of motion that an averaged one is compared with, None if there is none."""

    answer: validity.MeasuredPoint
    f: float | None
    A: float | None
    error: float | None
    error_of_f: float | None
    message: str


class MeasuredRandom(Quantities):
    """Simulated random vibration, with half the 95 % confidence intervals."""

    B: float
    x_rms: float
    v_rms: float
    a_rms: float
    B_margin: float
    x_margin: float
    v_margin: float
    a_margin: float
    beyond: float
    kurtosis: float
    duration: float


class Explained(Quantities, Generic[Dimensionless]):
    """With diagnostics."""

    answer: Dimensionless
    message: str
    remarks: Remark
    load: float


class Rows(Explained[Dimensionless]):
    """Answers with several entries: arrays of one length."""

    f: Floats
    f_low: Floats
    f_high: Floats
    f_undecided: Floats
    jumps: Floats
    A: Floats
    B: Floats
    x: Floats
    x_max: Floats
    phi: Floats
    transmissibility_dB: Floats
    stiffness: Floats
    acceleration: Floats
    duration: Floats
    a_max: Floats
    ratio: Floats
    stable: Flags
    corner: Flags
    minimum: Flags
    settled: Flags
    crosses: Flags
    detaches: Flags
    sticks: Flags
    kind: Strings
    branch: Ints
    stops: Ints
    motions: Ints
    isola: tuple[bool, ...]

    def measure(self, force: str | None = None, **options: object) -> Measured: ...


class AtOne(Rows[Dimensionless], Excited[float]):
    """At one amplitude of the excitation: of `saddle_nodes`, `frequency_response`, `sweep` and `hysteresis`."""


class AtEach(Rows[Dimensionless], Excited[Floats]):
    """Of `fold_locus`, `cusps`, `isola_points` and `spectrum`."""


class States(Rows[Dimensionless], Excited[float | Floats]):
    """Of `amplitudes`."""


class One(Explained[Dimensionless], Excited[float]):
    """Answers with a single entry, None where there is none: forcings, peaks, isolation, margins."""

    F_SN: float | None
    Y_SN: float | None
    a_SN: float | None
    U_SN: float | None
    F_cr: float | None
    Y_cr: float | None
    a_cr: float | None
    U_cr: float | None
    of_SN: float | None
    of_cr: float | None
    f: float | None
    f_cr: float | None
    f_max: float | None
    f_sticks: float
    level_dB: float
    A: float | None
    B: float | None
    x_cr: float | None
    x_max: float | None
    kind: str
    folds: int
    detaches: bool
    sticks: bool
    at_fold: bool
    untruncated: One[object] | None

    def measure(self, force: str | None = None, **options: object) -> MeasuredPoint: ...


class Random(Explained[Dimensionless]):
    """Of `random`."""

    B: Floats
    x_rms: Floats
    v_rms: Floats
    a_rms: Floats
    stiffness: Floats
    damping: Floats
    f_e: Floats
    ratio_e: Floats
    beyond: Floats
    crossing_rate: Floats
    dry: Floats

    def measure(self, force: str | None = None, **options: object) -> MeasuredRandom: ...


class AtRest(Quantities, Generic[Dimensionless]):
    """Of `at_rest`."""

    answer: Dimensionless
    f_n: float
    f_0: float | None
    k_0: float
    x_cr: float | None
    preset: float
    lightest: float | None
    heaviest: float | None
    break_loose: float
    rests_within: float | None
    sticking: float


class Motion(Explained[Dimensionless]):
    """What motions have over time: displacement and velocity of the mass."""

    t: Floats
    x: Floats
    v: Floats


class SteadyState(Motion[Dimensionless], Excited[float]):
    """Of `steady_state`."""

    f: float
    A: float
    stops: int
    stable: bool
    period: float


class Transient(Motion[Dimensionless]):
    """Of `transient`."""

    A: float
    t_A: float
    a_max: float
    t_a: float
    x_cr: float | None
    detaches: bool
    t_detaches: float | None
    rests: bool
    x_end: float
    a: Floats
    base: Floats


class Response(AtOne[Dimensionless]):
    """Of `exact_response`."""

    closed: bool
    complete: bool
    folds: Rows[object]


class Proved(Quantities, Generic[T, Kind]):
    """What `certify` proves of folds, states and forcings; bounds have an axis of two."""

    answer: T
    proved: bool
    message: str
    bits: int
    F: Floats
    a: Floats
    f: Floats
    A: Floats
    A_max: float
    kind: Kind
    corner: Flags
    stable: Flags
    bounded: bool
    doubt: Floats


class Certificate(Quantities):
    """Of `certify`."""

    answer: certificate.Certificate
    F: float
    a: float
    saddle_nodes: Proved[certificate.ProvedFolds, Strings]
    saddle_node_onset: Proved[certificate.ProvedForcing, str]
    detachment: Proved[certificate.ProvedForcing, str]
    amplitudes: Proved[certificate.ProvedStates, Strings] | None


class Many(SameColumns, Excited[Floats]):
    """Of each question about many mounts: arrays of their shape, some with an additional axis."""

    F_SN: Floats
    Y_SN: Floats
    a_SN: Floats
    U_SN: Floats
    F_cr: Floats
    Y_cr: Floats
    a_cr: Floats
    U_cr: Floats
    f: Floats
    f_0: Floats
    f_cr: Floats
    f_max: Floats
    f_low: Floats
    f_high: Floats
    f_sticks: Floats
    f_e: Floats
    fold_f: Floats
    x: Floats
    x_cr: Floats
    x_max: Floats
    x_end: Floats
    x_rms: Floats
    t_A: Floats
    t_a: Floats
    t_detaches: Floats
