"""Types of questions in SI units, for type checkers: what they take, and the numbers of `Quantities` that each gives.

Nothing is of these classes when a program runs: an answer is `Quantities`, and what it holds is read by name. Only what
is there whatever the mount is declared. By another excitation F is called Y or U, and a load adds a mean displacement:
these are read as before, but not checked.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from slowflow.mechanism import Array, Floats
from slowflow.quantities import Quantities

Flags = npt.NDArray[np.bool_]
Ints = npt.NDArray[np.intp]
Words = npt.NDArray[np.str_]


class WithUnit(Protocol):
    """A quantity of pint."""

    @property
    def magnitude(self) -> Any:
        """Its number or numbers."""
        ...

    def to(self, unit: Any, /) -> Any:
        """The same in another unit."""
        ...


#: one number, an array of them, and the two ends of a window
Number = float | np.floating[Any] | np.integer[Any] | WithUnit
Numbers = Number | Sequence[Number] | Array
Window = Sequence[Number] | Array | WithUnit


class Explained(Quantities):
    """With words on what is missing and what to bear in mind."""

    message: str


class RestPositions(Explained):
    """Of `rest`."""

    x: Floats
    stiffness: Floats
    stable: Flags


class AtRest(Quantities):
    """Of `at_rest`."""

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


class Onset(Explained):
    """Of `saddle_node_onset`."""

    F_SN: float | None
    f: float | None
    A: float | None
    kind: str


class Detachment(Explained):
    """Of `detachment`."""

    F_cr: float | None
    f_cr: float | None


class Folds(Explained):
    """Of `saddle_nodes`."""

    f: Floats
    A: Floats
    kind: Words
    corner: Flags
    F: float


class Peak(Explained):
    """Of `peak`."""

    A: float | None
    f: float | None
    F: float


class States(Explained):
    """Of `amplitudes`."""

    f: Floats
    A: Floats
    phi: Floats
    stable: Flags
    transmissibility_dB: Floats
    F: float | Floats
    f_undecided: Floats


class Curve(States):
    """Of `frequency_response`."""

    F: float
    branch: Ints
    isola: tuple[bool, ...]


class FoldLocus(Explained):
    """Of `fold_locus`."""

    f: Floats
    A: Floats
    F: Floats
    branch: Ints


class Cusps(Explained):
    """Of `cusps`."""

    F: Floats
    f: Floats
    A: Floats
    minimum: Flags


class IsolaPoints(Explained):
    """Of `isola_points`."""

    F: Floats
    f: Floats
    A: Floats
    kind: Words


class Certificate(Quantities):
    """Of `certify`."""

    F: float
    saddle_nodes: Quantities
    saddle_node_onset: Quantities
    detachment: Quantities
    amplitudes: Quantities | None


class SteadyState(Explained):
    """Of `steady_state`."""

    f: float
    A: float
    F: float
    stops: int
    stable: bool
    period: float
    t: Floats
    x: Floats
    v: Floats


class ExactFolds(Quantities):
    """The `folds` of `exact_response`."""

    f: Floats
    A: Floats
    kind: Words
    corner: Flags


class Response(Explained):
    """Of `exact_response`."""

    f: Floats
    A: Floats
    F: float
    stable: Flags
    stops: Ints
    closed: bool
    complete: bool
    folds: ExactFolds


class Sweep(Explained):
    """Of `sweep`."""

    f: Floats
    A: Floats
    F: float
    stops: Ints
    settled: Flags
    jumps: Floats


class Transient(Explained):
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
    t: Floats
    x: Floats
    v: Floats
    a: Floats
    base: Floats


class ShockSpectrum(Explained):
    """Of `shock_spectrum`."""

    acceleration: Floats
    duration: Floats
    A: Floats
    a_max: Floats
    ratio: Floats
    detaches: Flags


class Margins(Explained):
    """Of `margins`."""

    F: float
    F_SN: float | None
    F_cr: float | None
    of_SN: float | None
    of_cr: float | None
    kind: str
    folds: int
    detaches: bool
    sticks: bool
    f_sticks: float


class Hysteresis(Explained):
    """Of `hysteresis`."""

    f_low: Floats
    f_high: Floats
    motions: Ints
    F: float


class Isolation(Explained):
    """Of `isolation`."""

    f: float | None
    A: float | None
    at_fold: bool
    F: float


class Spectrum(Explained):
    """Of `spectrum`."""

    f: Floats
    F: Floats
    A: Floats
    transmissibility_dB: Floats
    motions: Ints
    crosses: Flags
    detaches: Flags
    sticks: Flags
