# mypy: disable-error-code="empty-body"
"""Functions of batches and the columns of their results.

Each function of `ManyQuestions` has a row in the table of questions, which contains its name, its arguments and the
columns of its result. Grids, stores, units and names in SI units follow from this row.
"""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterator, Mapping
from enum import IntEnum
from types import MappingProxyType
from typing import Any, Generic, NamedTuple, TypeVar, cast, get_args

import numpy as np
import numpy.typing as npt

from slowflow.core import validate
from slowflow.core.mechanism import Floats, Reals
from slowflow.support.text import text
from slowflow_kernels.conventions import FoldKind, OnsetKind

__all__ = ["Columns", "ManyQuestions"]

#: the systems that answer: first-order averaging about the centre, with higher harmonics, with a mean B
AVERAGING, SECOND, OFFSET = "averaging", "second approximation", "offset motion"
#: points of a batch's curves beyond the samples: one for each piece that folds, peaks and corners cut a curve into, and
#: one for each curve; in the second approximation also those inserted where the harmonics change fast
MORE_POINTS = {AVERAGING: 64, SECOND: 256, OFFSET: 64}
#: bits of a double
DOUBLES = 53


class Column(NamedTuple):
    """A column of an answer.

    name -- dimensionless
    text -- meaning
    kind -- kind of unit, a key of `quantities.UNITS`; "amplitude" for that of the excitation, "" for none
    si   -- name in SI units, if different
    type -- in batches
    none -- value of an empty entry there; NaN for doubles
    """

    name: str
    text: str
    kind: str = ""
    si: str = ""
    type: type = float
    none: int = 0

    def blank(self, shape: tuple[int, ...]) -> npt.NDArray[Any]:
        """Empty entries."""
        return np.full(shape, np.nan if self.type is float else self.none, self.type)


Codes = npt.NDArray[np.int8]
#: sizes that a code has no room for, counts, and flags that add up
Sizes = npt.NDArray[np.int16]
Counts = npt.NDArray[np.intc]
Sums = npt.NDArray[np.uint16]


def _column(meaning: str, kind: str = "", si: str = "", none: int = 0) -> Any:
    """A line of `Columns`, whose meaning may be a pattern of `slowflow.support.text`; its annotation says the type."""
    return Column("", text(meaning) if "{" in meaning else meaning, kind, si, none=none)


class SameColumns:
    """The columns that have the same name in SI units."""

    jumps: Floats = _column("frequencies before and after each jump", "frequency")
    A: Floats = _column("amplitude; in the second approximation the largest displacement", "length")
    A_1: Floats = _column("amplitude of the fundamental harmonic", "length")
    A_max: Floats = _column("largest amplitude searched", "length")
    B: Floats = _column("mean displacement of a motion", "length")
    rests_within: Floats = _column("distance from the centre within which friction holds the mass", "length")
    doubt: Floats = _column("intervals of amplitude left undecided", "length")
    v_rms: Floats = _column("root mean square of the velocity", "speed")
    a_rms: Floats = _column("root mean square of the absolute acceleration", "acceleration")
    B_margin: Floats = _column("half the 95 % confidence interval of B", "length")
    v_margin: Floats = _column("half the 95 % confidence interval of v_rms", "speed")
    a_margin: Floats = _column("half the 95 % confidence interval of a_rms", "acceleration")
    S_0: Floats = _column("two-sided spectral density of white noise")
    damping: Floats = _column("damping of the equivalent linear oscillator", "damping")
    ratio_e: Floats = _column("damping ratio of the equivalent linear oscillator")
    dry: Floats = _column("fraction of that damping due to dry friction")
    beyond: Floats = _column("fraction of the time beyond the first breakpoint on either side")
    crossing_rate: Floats = _column("rate at which {u} crosses these outwards", "rate")
    v: Floats = _column("velocity", "speed")
    a: Floats = _column("acceleration of the mass", "acceleration")
    base: Floats = _column("acceleration of the base", "acceleration")
    a_max: Floats = _column("largest acceleration of the mass", "acceleration")
    acceleration: Floats = _column("{acceleration of the base, over k_v L/m|acceleration of the base}", "acceleration")
    duration: Floats = _column("duration of a half sine", "time")
    period: Floats = _column("period of a motion", "time")
    k_0: Floats = _column("stiffness at the centre", "stiffness")
    stiffness: Floats = _column("stiffness at an equilibrium, or of the equivalent linear oscillator", "stiffness")
    break_loose: Floats = _column("largest constant force that friction can hold", "force")
    sticking: Floats = _column(
        "force amplitude up to which the mass sticks, {4 mu/pi|4/pi times the friction} (27)", "force"
    )
    force: Floats = _column("restoring force", "force")
    load: Floats = _column("static load in addition to that on the vertical spring at the centre", "mass")
    phi: Floats = _column("phase in radians", "angle")
    of_SN: Floats = _column("{F_SN} over {F_0}: a margin above 1")
    of_cr: Floats = _column("{F_cr} over {F_0}: a margin above 1")
    ratio: Floats = _column("largest acceleration of the mass over that of the pulse")
    transmissibility: Floats = _column("transmitted force over the exciting force")
    transmissibility_dB: Floats = _column("transmissibility in decibels")
    level_dB: Floats = _column("upper bound of transmissibility in decibels")
    kind: Codes = _column("kind of fold")
    stable: Codes = _column("1 where a state is stable")
    at_rest: Codes = _column("1 where folds below the onset, or without it, end at {Omega} = 0")
    onset: Codes = _column("status of the onset: why there is no {F_SN}")
    folds: Codes = _column("number of folds")
    motions: Codes = _column("number of stable motions")
    crosses: Codes = _column("1 where a fold lies between the previous row and this one")
    detaches: Codes = _column("1 where the springs detach")
    sticks: Codes = _column("1 where the mass sticks")
    rests: Codes = _column("1 where friction holds the mass at the end")
    stands: Codes = _column("number of stable equilibria")
    at_fold: Codes = _column("1 where a motion that transmits more ends there in a fold")
    branch: Sizes = _column("number of the connected curve, from 0; -1 after the last point", none=-1)
    isola: Codes = _column("1 where that curve is closed")
    points: Counts = _column("number of points")
    fold_A: Floats = _column("amplitude of a fold", "length")
    fold_kind: Codes = _column("kind of fold")
    count: Codes = _column("number of entries, also where these exceed max_count, or number proved")
    proved: Codes = _column("1 where these are proved to be all")
    bits: Sizes = _column("bits of the proof: 53 for intervals of doubles, more for balls")
    undecided: Codes = _column("1 where neither double precision nor ball arithmetic decides the count")
    status: Codes = _column("status code: whether there is an answer, or why there is none")


class Columns(SameColumns):
    """The columns of answers about many designs, common to all questions; a type checker has their types from here."""

    F_0: Floats = _column("forcing, the amplitude of the excitation", "amplitude")
    F_SN: Floats = _column("lowest forcing that has a fold (33)", "amplitude")
    F_cr: Floats = _column("lowest forcing that reaches {u_cr} (34)", "amplitude")
    Omega: Floats = _column("frequency", "frequency", "f")
    Omega_cr: Floats = _column("frequency at which it is reached", "frequency", "f_cr")
    Omega_max: Floats = _column("frequency of the largest displacement", "frequency", "f_max")
    Omega_low: Floats = _column("lower end of a band with several stable motions", "frequency", "f_low")
    Omega_high: Floats = _column("upper end of that band", "frequency", "f_high")
    Omega_0: Floats = _column("natural frequency of small motions about the centre", "frequency", "f_0")
    Omega_sticks: Floats = _column("frequency up to which the mass sticks", "frequency", "f_sticks")
    Omega_undecided: Floats = _column("frequencies at which the count is undecided", "frequency", "f_undecided")
    u_max: Floats = _column("largest |{u}|", "length", "x_max")
    u_cr: Floats = _column("amplitude at which the springs detach", "length", "x_cr")
    u: Floats = _column("equilibrium position", "length", "x")
    u_end: Floats = _column("final displacement", "length", "x_end")
    u_rms: Floats = _column("root mean square of the displacement about its mean", "length", "x_rms")
    u_margin: Floats = _column("half the 95 % confidence interval of {u_rms}", "length", "x_margin")
    Omega_e: Floats = _column("natural frequency of the equivalent linear oscillator", "frequency", "f_e")
    tau: Floats = _column("times of the samples of a record", "time", "t")
    tau_A: Floats = _column("time of the largest deflection", "time", "t_A")
    tau_a: Floats = _column("time of the largest acceleration", "time", "t_a")
    tau_detaches: Floats = _column("time at which the springs first detach", "time", "t_detaches")
    fold_Omega: Floats = _column("frequency of a fold", "frequency", "fold_f")
    remarks: Sums = _column("diagnostics of the answer, codes that add up")


def _columns() -> Iterator[tuple[str, Column]]:
    """The columns by name; what an array of each holds its annotation says."""
    kinds = Columns.__annotations__ | SameColumns.__annotations__  # names of this module; to evaluate them takes 1 ms
    for name, kind in kinds.items():
        (of,) = get_args(get_args(globals()[kind])[1])
        yield name, getattr(Columns, name)._replace(name=name, type=float if of is np.float64 else of)


#: by name
COLUMNS: Mapping[str, Column] = MappingProxyType(dict(_columns()))

#: quantities of messages and of measured answers that are no columns
QUOTED = (
    Column("mu", "dry friction", "force", "friction"),
    Column("mu_s", "static friction", "force", "static_friction"),
    Column("c_2", "quadratic damping", "quadratic damping"),
    Column("c_3", "cubic damping", "cubic damping"),
    Column("zeta_2", "growth of the viscous damping ratio with u^2", "growing damping", "c_xx"),
    Column("u_0", "initial displacement", "length", "x_0"),
    Column("v_0", "initial velocity", "speed"),
    Column("after", "duration of a free motion", "time"),
    Column("reach", "largest |u| for which the force is valid", "length"),
    Column("error_of_Omega", "relative error of an averaged frequency", si="error_of_f"),
    Column("held", "amplitude up to which friction holds a mass at rest", "amplitude"),
)
#: all quantities of messages, by name
QUANTITIES: Mapping[str, Column] = MappingProxyType({**COLUMNS, **{one.name: one for one in QUOTED}})


class Question(NamedTuple):
    """A question about many designs.

    name    -- of its method
    columns -- of its answer by system, each with its axis after those of the designs, "" for none
    takes   -- required arguments that broadcast with the designs; may -- optional ones
    options -- other arguments, the same for all designs, with their defaults
    argument_axes -- the axis of a table or a record that such an argument may have after those of the designs
    kinds   -- meaning of the numbers in `kind`
    """

    name: str
    columns: Mapping[str, Mapping[str, str]]
    takes: tuple[str, ...] = ()
    may: tuple[str, ...] = ()
    options: Mapping[str, Any] = MappingProxyType({})
    argument_axes: Mapping[str, str] = MappingProxyType({})
    kinds: type[IntEnum] | None = None

    def blank(self, system: str, shape: tuple[int, ...], **lengths: int) -> dict[str, npt.NDArray[Any]]:
        """Empty columns of designs of a shape; `lengths` are those of the axes after theirs."""
        inner = {"": (), **{axis: (length,) for axis, length in lengths.items()}}
        return {name: COLUMNS[name].blank((*shape, *inner[axis])) for name, axis in self.columns[system].items()}

    def layout(self, system: str) -> dict[str, tuple[str, np.dtype[Any]]]:
        """The axis and the type of each column, by name; remarks last."""
        columns = self.columns[system]
        own = {"remarks": "row"} if "row" in columns.values() else {"remarks": ""}
        return {name: (axis, np.dtype(COLUMNS[name].type)) for name, axis in {**columns, **own}.items()}


def _same(columns: str, *systems: str) -> dict[str, str]:
    """These columns for each of the systems."""
    return dict.fromkeys(systems, columns)


_CURVE = "Omega:point A:point stable:point branch:point isola:point points"
_FOLDS_OF_IT = "fold_Omega:place fold_A:place fold_kind:place count undecided status"
_TRANSIENT = "A tau_A a_max tau_a detaches tau_detaches rests u_end status"

_ROWS: dict[str, Question] = {}
#: the questions by name, each as its method of `ManyQuestions` declares it
QUESTIONS: Mapping[str, Question] = MappingProxyType(_ROWS)

#: an answer, and numbers that broadcast with the designs
Found = TypeVar("Found", covariant=True)
Arrays = TypeVar("Arrays", contravariant=True)
Method = TypeVar("Method", bound=Callable[..., Any])


def asks(
    columns: Mapping[str, str],
    *,
    argument_axes: Mapping[str, str] = MappingProxyType({}),
    kinds: type[IntEnum] | None = None,
) -> Callable[[Method], Method]:
    """Register a question: columns by system; name, arguments and text are those of the decorated method.

    columns -- of each system, written "name" or "name:axis"
    """

    def declared(method: Method) -> Method:
        name, (_, *parameters) = method.__name__, inspect.signature(method).parameters.values()
        positional = [one.name for one in parameters if one.kind is one.POSITIONAL_OR_KEYWORD]
        defaults = {one.name: one.default for one in parameters if one.default is not one.empty}
        takes = tuple(one.name for one in parameters if one.name not in defaults)
        may = tuple(one.name for one in parameters if one.default is None and one.annotation == "Arrays | None")
        options = {one: value for one, value in defaults.items() if one not in (*may, "workers")}
        axes = {
            system: {one: axis for one, _, axis in (column.partition(":") for column in text.split())}
            for system, text in columns.items()
        }
        _ROWS[name] = Question(name, axes, takes, may, options, argument_axes, kinds)

        refuse_others = validate.checks_arguments(method)

        @functools.wraps(method)
        def ask(self: Any, /, *arguments: Any, **named: Any) -> Any:
            refuse_others(self, *arguments, **named)
            for one, value in zip(positional, arguments):  # noqa: B905
                named[one] = value
            return self._ask(name, **{**defaults, **named})

        return cast("Method", ask)

    return declared


class Unanswered:
    """Placeholder for a question that is not supported: access raises NoAttribute with the reason."""

    def __init__(self, why: str) -> None:
        self.why = why

    def __get__(self, one: Any, kind: Any = None) -> Any:
        if one is None:
            return self
        raise validate.NoAttribute(self.why)


class ManyQuestions(Generic[Found, Arrays]):
    """The questions about many designs, dimensionless: each returns a `Batch`, of a grid an xarray Dataset.

    F_0, Omega, acceleration, duration -- numbers or arrays that broadcast with the designs
    max_count -- largest number of entries per design, along an additional axis of the columns, filled with NaN and 0;
            `count` is the number of entries, `Status.TOO_MANY` marks designs with more
    workers   -- threads that share the designs, -1 for one per processor; the results do not depend on it
    stable    -- 1 where both eigenvalues of the Jacobian (28) have a negative real part
    undecided -- 1 where neither double precision nor ball arithmetic resolves the number of entries, or the position of
            one

    A design without a result raises nothing: `status` has the reason. Raises ValueError for arrays that do not
    broadcast, and for an invalid argument that is common to all designs.
    """

    def _ask(self, question: str, /, *, workers: int = 1, **arguments: Any) -> Found:
        """The answer to a question by its name, from its method's arguments."""
        raise NotImplementedError

    @asks(_same("F_cr Omega_cr u_cr status", AVERAGING, SECOND) | {OFFSET: "F_cr Omega_cr A B status"})
    def detachment(self, *, workers: int = 1) -> Found:
        """Find the lowest forcing whose response reaches u_cr (34): .F_cr .Omega_cr .u_cr; with a load .A .B.

        With a load the lowest forcing whose motion reaches a breakpoint, on either side; `Status.NONE` if none does.
        """

    @asks(
        _same("F_SN Omega A kind at_rest status", AVERAGING, SECOND) | {OFFSET: "F_SN Omega A B kind status"},
        kinds=OnsetKind,
    )
    def saddle_node_onset(self, *, workers: int = 1) -> Found:
        """Find the lowest forcing that has a fold (33): .F_SN .Omega .A .kind .at_rest; with a load .B.

        kind    -- an `OnsetKind`: a cusp, an isola's birth, on a breakpoint
        at_rest -- 1 where there are folds below the onset, or without an onset, that end at Omega = 0

        `.untruncated` is F_SN of the untruncated force where the onset lies on a corner due to the truncation alone.
        Where double precision is inconclusive, ball arithmetic resolves the first 20 designs, as for single designs.
        With a load `Status.UNRESOLVED` marks an undecided onset.
        """

    @asks(
        _same("Omega:place A:place kind:place count undecided status", AVERAGING, SECOND)
        | {OFFSET: "Omega:place A:place B:place kind:place count undecided status"},
        kinds=FoldKind,
    )
    def saddle_nodes(self, F_0: Arrays, *, max_count: int = 6, workers: int = 1) -> Found:
        """Find every fold at F_0 (24), (30), sorted by Omega: .Omega .A .kind .count .undecided; with a load .B.

        Parameters
        ----------
        F_0, max_count, workers : as in the class
            Amplitudes of the excitation, > 0; largest number of folds; threads.

        Returns
        -------
        Batch
            .kind is a `FoldKind`: direction of the jump, and whether the fold is a corner at a breakpoint; 0 if both
            motions that merge are unstable. Where double precision is inconclusive, ball arithmetic resolves the first
            200 designs, as for single designs; see `certify`.
        """

    @asks(
        {
            AVERAGING: "A:place stable:place count undecided status",
            SECOND: "A:place A_1:place phi:place stable:place count undecided status",
            OFFSET: "A:place B:place phi:place transmissibility:place stable:place count undecided status",
        }
    )
    def amplitudes(self, *, F_0: Arrays, Omega: Arrays, max_count: int = 6, workers: int = 1) -> Found:
        """Find every steady state at (Omega, F_0) (24), (30), sorted by A: .A .phi .stable .count .transmissibility.

        Parameters
        ----------
        F_0, Omega, max_count, workers : as in the class
            Amplitudes and frequencies of the excitation, > 0; largest number of states; threads.

        Returns
        -------
        Batch
            .A is 0 where friction holds the mass at rest, with `Status.STICKS` if there is no other state; in the
            second approximation it is the largest displacement, and .A_1 the amplitude of the first harmonic. With a
            load .B is the mean displacement. .undecided as in `saddle_nodes`.
        """

    @asks(
        {
            AVERAGING: f"{_CURVE} {_FOLDS_OF_IT}",
            SECOND: "Omega:point A:point A_1:point phi:point stable:point branch:point isola:point points "
            "undecided status",
            OFFSET: f"{_CURVE} {_FOLDS_OF_IT} B:point phi:point transmissibility:point",
        }
    )
    def frequency_response(
        self,
        F_0: Arrays,
        *,
        samples: int = 1000,
        Omega: tuple[float, float] = validate.WINDOW,
        max_count: int = 6,
        workers: int = 1,
    ) -> Found:
        """Compute the response curve at F_0 (24), (30), with every fold: .Omega .A .stable .branch .isola .points.

        Parameters
        ----------
        F_0, samples, Omega : array_like, int, tuple of float
            Amplitudes of the excitation, > 0; approximate number of points and window of frequencies, the same for all
            designs.
        max_count, workers : int
            Largest number of folds; threads.

        Returns
        -------
        Batch
            Points lie along an additional axis of `samples` + 64 entries (+ 256 in the second approximation), in order
            along each branch; the first .points entries are used, the others are NaN, 0 and branch -1. .branch is the
            index of the connected curve, from 0, isolated curves last, .isola 1 where it is closed; .fold_Omega .fold_A
            .fold_kind .count are as in `saddle_nodes`, not in the second approximation. `Status.TOO_MANY` marks a curve
            with more points, which is left empty, or with more folds than `max_count`. About 25 bytes per point.
        """

    @asks(_same("A Omega status", AVERAGING, SECOND) | {OFFSET: "A B Omega u_max Omega_max status"})
    def peak(self, F_0: Arrays, *, workers: int = 1) -> Found:
        """Find the highest peak at F_0, isolas included: .A .Omega, which is 0 if A decreases with Omega throughout.

        Returns
        -------
        Batch
            For a softening spring, the peak within the potential well. `Status.UNBOUNDED` marks a response that does
            not close within it. With a load also .B, and .u_max at .Omega_max of the motion with the largest
            displacement.
        """

    @asks({AVERAGING: "count proved bits status"})
    def certify(self, F_0: Arrays, *, Omega: Arrays | None = None, workers: int = 1) -> Found:
        """Prove the number of folds at F_0, or of states at (Omega, F_0), about the centre: .count .proved .bits.

        Parameters
        ----------
        F_0, Omega, workers : as in the class
            Amplitudes of the excitation and, for states, frequencies, > 0; threads.

        Returns
        -------
        Batch
            .proved is 1 where the count is proved, with amplitudes as in a single `certify`, 0 where undecided; .bits
            is the precision: 53 for intervals of doubles, more for balls. Where intervals are inconclusive, ball
            arithmetic is used, with python-flint (`pip install 'slowflow[proofs]'`), one design after the other, in
            some hundredths of a second each. `Status.UNRESOLVED` where no proof is possible: for a force whose averages
            have no enclosures.
        """

    @asks({OFFSET: "u:place stiffness:place count status"})
    def rest(self, *, max_count: int = 3, workers: int = 1) -> Found:
        """Find every equilibrium under a load, sorted by u: .u .stiffness .count."""

    @asks({AVERAGING: "Omega_0 k_0 u_cr break_loose rests_within sticking status"})
    def at_rest(self, *, workers: int = 1) -> Found:
        """Compute data that do not depend on the forcing: .Omega_0 .k_0 .u_cr .break_loose .rests_within .sticking.

        As `at_rest` of a single design: NaN if there is no frequency or no stroke; rests_within may be inf.
        """

    @asks(
        _same("F_SN F_cr of_SN of_cr kind folds detaches sticks Omega_sticks onset status", AVERAGING, OFFSET),
        kinds=OnsetKind,
    )
    def margins(self, F_0: Arrays, *, workers: int = 1) -> Found:
        """Compare F_0 with F_SN and F_cr: .of_SN .of_cr .folds .detaches .sticks .Omega_sticks .onset.

        Returns
        -------
        Batch
            .F_SN .F_cr .of_SN .of_cr are inf if there is no such forcing; F_SN is NaN if there is no lowest one, or if
            it is unknown, as given by the status .onset; F_cr as in `averaged.checks.Margins`. .kind is an `OnsetKind`;
            at the birth of an isola no sweep jumps. .detaches is 1 if a stable motion passes u_cr, also on isolated
            curves, which may exist below F_cr; .sticks is 1 if a mass at rest sticks at every frequency. .status is
            that of the folds, or of the onset, the detachment or the peak if one of these is unknown.
        """

    @asks(_same("Omega_low:place Omega_high:place motions:place count status", AVERAGING, OFFSET))
    def hysteresis(self, F_0: Arrays, *, max_count: int = 3, workers: int = 1) -> Found:
        """Find the bands of Omega with several stable motions at F_0: .Omega_low .Omega_high .motions .count.

        Parameters
        ----------
        F_0, max_count, workers : as in the class
            Amplitudes of the excitation, > 0; largest number of bands; threads.
        """

    @asks({AVERAGING: "Omega A at_fold status", OFFSET: "Omega A at_fold status B"})
    def isolation(self, F_0: Arrays, *, level_dB: Arrays | None = None, workers: int = 1) -> Found:
        """Find the frequency above which less than F_0, or a given fraction of it, is transmitted: .Omega .A .at_fold.

        Parameters
        ----------
        F_0, level_dB, workers : as in the class
            Amplitudes of the excitation, > 0; levels in decibels, <= 0, by default 0, which broadcast too; threads.

        Returns
        -------
        Batch
            .Omega is 0 and .A NaN if every motion transmits less; both are NaN, with `Status.NONE`, if there is no such
            frequency.
        """

    @asks(
        _same(
            "A:row transmissibility_dB:row motions:row crosses:row detaches:row sticks:row status:row",
            AVERAGING,
            OFFSET,
        ),
        argument_axes={"Omega": "row", "F_0": "row"},
    )
    def spectrum(self, *, Omega: Arrays, F_0: Arrays, workers: int = 1) -> Found:
        """Evaluate a load spectrum, one tone at a time: .A .transmissibility_dB .motions .crosses .detaches .sticks.

        Parameters
        ----------
        Omega, F_0, workers : as in the class
            Frequencies and amplitudes, > 0, with the rows along the last axis; the other axes broadcast with the
            designs; threads.

        Returns
        -------
        Batch
            The axes are those of the designs, then that of the rows. `Status.NONE` if no motion is stable; otherwise
            the status of the states that fail, or of the folds in between.
        """

    @asks(
        {AVERAGING: _TRANSIENT, OFFSET: f"{_TRANSIENT} stands"},
        argument_axes={"tau": "instant", "acceleration": "instant"},
    )
    def transient(
        self,
        *,
        acceleration: Arrays,
        duration: Arrays | None = None,
        tau: Arrays | None = None,
        after: float | None = None,
        workers: int = 1,
    ) -> Found:
        """Integrate the response to a shock of the base: .A .tau_A .a_max .tau_a .detaches .tau_detaches .rests .u_end.

        Parameters
        ----------
        acceleration, duration, tau : array_like
            Peak and duration of a half sine, which broadcast with the designs; or samples and times of a record along
            their last axis, whose other axes broadcast.
        after, workers : as in `Oscillator.transient`
            Duration of the free motion afterwards, in tau; threads.

        Returns
        -------
        Batch
            15,000 to 50,000 designs per second. `Status.UNRESOLVED` if the motion escapes or chatters. With a load also
            .stands, the number of stable equilibria; the motion begins at the one nearest to the centre, and a design
            takes hundredths of a second.
        """

    @asks({AVERAGING: "A a_max ratio detaches status", OFFSET: "A a_max ratio detaches status stands"})
    def shock_spectrum(self, *, acceleration: Arrays, duration: Arrays, workers: int = 1) -> Found:
        """Compute the shock response spectrum of half sines: .A .a_max .ratio .detaches; with a load .stands too.

        Parameters
        ----------
        acceleration, duration, workers : as in the class
            Peaks and durations, > 0; threads.

        Raises
        ------
        ValueError
            For structural damping. Designs with other damping laws are integrated one by one, in milliseconds each.
        """

    @asks(
        _same(
            "B:place u_rms:place v_rms:place a_rms:place stiffness:place damping:place Omega_e:place ratio_e:place "
            "beyond:place crossing_rate:place dry:place count status",
            AVERAGING,
            OFFSET,
        )
    )
    def random(
        self, *, S_0: Arrays | None = None, psd: tuple[Reals, Reals] | None = None, max_count: int = 3, workers: int = 1
    ) -> Found:
        """Find stationary random vibration: .B .u_rms, ascending, .v_rms .a_rms .stiffness .damping .beyond .dry.

        Parameters
        ----------
        S_0, psd : array_like, tuple of array_like
            Densities of white noise, which broadcast with the designs; or frequencies and densities, the same for all
            designs, at about 10 microseconds per design, with a load half a millisecond.
        max_count, workers : as in the class
            Largest number of motions; threads.

        Returns
        -------
        Batch
            As `random` of a single design. `Status.UNRESOLVED` also if there is no stationary motion.
        """


#: questions about motions in time under a pulse or a record of the base's acceleration
SHOCKS = tuple(name for name, row in QUESTIONS.items() if "acceleration" in row.takes)
#: questions about motions that have no frequency: their excitation is that of their arguments, not F_0
IN_TIME = tuple(name for name, row in QUESTIONS.items() if (row.takes or row.may) and "F_0" not in row.takes)
