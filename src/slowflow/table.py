# mypy: disable-error-code="empty-body"
"""The table of questions: of each its name, what it takes, and the columns of its answer, by system.

A row stands over the method that asks it of many designs, whose name, arguments and text are its own, and holds the
columns of the answer. From it follow the same of a grid, the type, axis, meaning and kind of unit of each column, the
layout of a store, and what is called otherwise in SI units.
"""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Mapping
from enum import IntEnum
from types import MappingProxyType
from typing import Any, Generic, NamedTuple, TypeVar, cast

import numpy as np
import numpy.typing as npt

from slowflow import validate
from slowflow_kernels.conventions import FoldKind, OnsetKind

#: by what a question is answered: first-order averaging about the centre, with higher harmonics, with a mean B
AVERAGING, SECOND, OFFSET = "averaging", "second approximation", "offset motion"
#: points of a batch's curves beyond the samples: one for each piece that folds, peaks and corners cut a curve into, and
#: one for each curve; in the second approximation what is put where the harmonics change fast, too
MORE_POINTS = {AVERAGING: 64, SECOND: 256, OFFSET: 64}


class Column(NamedTuple):
    """A column of an answer.

    name -- dimensionless
    text -- what it is
    kind -- of which kind of unit, a key of `quantities.UNITS`; "amplitude" is that of the excitation, "" is none
    si   -- its name with a unit, where that is another one
    type -- in batches
    none -- what is in an empty place there; NaN of doubles
    """

    name: str
    text: str
    kind: str = ""
    si: str = ""
    type: type = float
    none: int = 0

    def blank(self, shape: tuple[int, ...]) -> npt.NDArray[Any]:
        """Empty places."""
        return np.full(shape, np.nan if self.type is float else self.none, self.type)


#: by name; what several questions have is the same
COLUMNS: Mapping[str, Column] = MappingProxyType(
    {
        one.name: one
        for one in (
            Column("F_0", "forcing, the amplitude of the excitation", "amplitude"),
            Column("F_SN", "lowest forcing that has a fold (33)", "amplitude"),
            Column("F_cr", "lowest forcing that reaches u_cr (34)", "amplitude"),
            Column("Omega", "frequency", "frequency", "f"),
            Column("Omega_cr", "frequency at which it does", "frequency", "f_cr"),
            Column("Omega_max", "frequency of the motion that goes farthest", "frequency", "f_max"),
            Column("Omega_low", "lower end of a band with several stable motions", "frequency", "f_low"),
            Column("Omega_high", "its upper end", "frequency", "f_high"),
            Column("Omega_0", "natural frequency of small motions about the centre", "frequency", "f_0"),
            Column("Omega_sticks", "frequency up to which the mass stays at rest", "frequency", "f_sticks"),
            Column("Omega_undecided", "frequencies at which the count is undecided", "frequency", "f_undecided"),
            Column("jumps", "frequencies before and after each jump", "frequency"),
            Column("A", "amplitude; in the second approximation the largest displacement", "length"),
            Column("A_1", "amplitude of the fundamental harmonic", "length"),
            Column("A_max", "largest amplitude that was looked at", "length"),
            Column("B", "mean displacement of a motion", "length"),
            Column("u_max", "largest |u|", "length", "x_max"),
            Column("u_cr", "amplitude at which the springs leave", "length", "x_cr"),
            Column("u", "place of rest", "length", "x"),
            Column("u_end", "where the mass is at the end", "length", "x_end"),
            Column("rests_within", "how far from the centre friction holds the mass", "length"),
            Column("doubt", "amplitudes between which nothing is decided", "length"),
            Column("u_rms", "root mean square of the displacement", "length", "x_rms"),
            Column("v_rms", "root mean square of the velocity", "speed"),
            Column("a_rms", "root mean square of the absolute acceleration", "acceleration"),
            Column("u_margin", "half the 95 % confidence interval of u_rms", "length", "x_margin"),
            Column("v_margin", "half the 95 % confidence interval of v_rms", "speed"),
            Column("a_margin", "half the 95 % confidence interval of a_rms", "acceleration"),
            Column("S_0", "two-sided spectral density of white noise"),
            Column("Omega_e", "natural frequency of the equivalent linear oscillator", "frequency", "f_e"),
            Column("damping", "damping of the equivalent linear oscillator", "damping"),
            Column("ratio_e", "damping ratio of the equivalent linear oscillator"),
            Column("dry", "share of dry friction in that damping"),
            Column("beyond", "share of the time beyond the first breakpoint"),
            Column("crossing_rate", "how often |u| passes the first breakpoint", "rate"),
            Column("v", "velocity", "speed"),
            Column("a", "acceleration of the mass", "acceleration"),
            Column("base", "acceleration of the base", "acceleration"),
            Column("a_max", "largest acceleration of the mass", "acceleration"),
            Column("acceleration", "acceleration of the base, over k_v L/m", "acceleration"),
            Column("tau", "times of the samples of a record", "time", "t"),
            Column("tau_A", "when the largest deflection is reached", "time", "t_A"),
            Column("tau_a", "when it is reached", "time", "t_a"),
            Column("tau_detaches", "when the springs leave first", "time", "t_detaches"),
            Column("duration", "duration of a half sine", "time"),
            Column("period", "period of a motion", "time"),
            Column("k_0", "stiffness at the centre", "stiffness"),
            Column("stiffness", "stiffness there", "stiffness"),
            Column("break_loose", "constant force that friction holds", "force"),
            Column("sticking", "amplitude of a force up to which the mass is at rest, 4 mu/pi (27)", "force"),
            Column("force", "restoring force", "force"),
            Column("load", "static load beside what the vertical spring holds at the centre", "mass"),
            Column("phi", "phase in radians", "angle"),
            Column("of_SN", "F_SN over F_0: a margin above 1"),
            Column("of_cr", "F_cr over F_0: a margin above 1"),
            Column("ratio", "largest acceleration of the mass over that of the pulse"),
            Column("transmissibility", "share of the force that is transmitted"),
            Column("transmissibility_dB", "the same in decibels"),
            Column("level_dB", "transmissibility in decibels below which it stays"),
            Column("kind", "kind of fold", type=np.int8),
            Column("stable", "1 where a state is stable", type=np.int8),
            Column("at_rest", "1 where folds below the onset, or without it, end at Omega = 0", type=np.int8),
            Column("onset", "status of the onset: why there is no F_SN", type=np.int8),
            Column("folds", "number of folds", type=np.int8),
            Column("motions", "number of stable motions", type=np.int8),
            Column("crosses", "1 where a fold lies on the way from the row before", type=np.int8),
            Column("detaches", "1 where the springs leave", type=np.int8),
            Column("sticks", "1 where the mass stays at rest", type=np.int8),
            Column("rests", "1 where friction holds the mass at the end", type=np.int8),
            Column("stands", "number of stable places of rest", type=np.int8),
            Column("at_fold", "1 where a motion that transmits more ends there in a fold", type=np.int8),
            Column("branch", "number of the connected curve, from 0; -1 behind the last point", type=np.int16, none=-1),
            Column("isola", "1 where that curve is closed", type=np.int8),
            Column("points", "number of points", type=np.intc),
            Column("fold_Omega", "frequency of a fold", "frequency"),
            Column("fold_A", "amplitude of a fold", "length"),
            Column("fold_kind", "kind of fold", type=np.int8),
            Column("count", "how many there are, also where they are more than places, or are proved", type=np.int8),
            Column("proved", "1 where these are proved to be all", type=np.int8),
            Column("bits", "of the arithmetic of the proof: 53 of intervals of doubles, more of balls", type=np.int16),
            Column("undecided", "1 where neither doubles nor balls tell whether there is another pair", type=np.int8),
            Column("status", "whether there is an answer, and why there is none", type=np.int8),
            Column("remarks", "what to bear in mind with the answer, codes that add up", type=np.uint16),
        )
    }
)  # fmt: skip


#: what sentences tell numbers of beside columns
QUOTED = (
    Column("mu", "dry friction", "force", "friction"),
    Column("mu_s", "static friction", "force", "static_friction"),
    Column("c_2", "quadratic damping", "quadratic damping"),
    Column("u_0", "displacement at the beginning", "length", "x_0"),
    Column("v_0", "velocity at the beginning", "speed"),
    Column("after", "for how long a free motion is followed", "time"),
    Column("reach", "largest |u| that makes sense", "length"),
    Column("held", "amplitude up to which a mass at rest is held", "amplitude"),
)
#: all that sentences tell numbers of, by name
QUANTITIES: Mapping[str, Column] = MappingProxyType({**COLUMNS, **{one.name: one for one in QUOTED}})


class Question(NamedTuple):
    """A question about many designs.

    name    -- of its method
    columns -- of its answer by system, each with the axis that it has behind those of the designs, "" for none
    takes   -- numbers that it takes beside the designs', which broadcast with these; may -- and those that it may
    options -- what else it takes, the same for all designs, with its default
    argument_axes -- the axis of a table or a record that such a number may have behind those of the designs
    kinds   -- what the numbers in `kind` stand for
    """

    name: str
    columns: Mapping[str, Mapping[str, str]]
    takes: tuple[str, ...] = ()
    may: tuple[str, ...] = ()
    options: Mapping[str, Any] = MappingProxyType({})
    argument_axes: Mapping[str, str] = MappingProxyType({})
    kinds: type[IntEnum] | None = None

    def blank(self, system: str, shape: tuple[int, ...], **lengths: int) -> dict[str, npt.NDArray[Any]]:
        """The columns of designs of a shape, with nothing in them, from the lengths of the axes behind theirs."""
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
#: the questions by name, each as the method of `ManyQuestions` declares it that asks it
QUESTIONS: Mapping[str, Question] = MappingProxyType(_ROWS)

Found = TypeVar("Found", covariant=True)
Method = TypeVar("Method", bound=Callable[..., Any])


def asks(
    columns: Mapping[str, str],
    *,
    argument_axes: Mapping[str, str] = MappingProxyType({}),
    kinds: type[IntEnum] | None = None,
) -> Callable[[Method], Method]:
    """Make a question's row of columns by system and of the method below, which has its name, arguments and text.

    columns -- of each system, written "name" or "name:axis"
    """

    def declared(method: Method) -> Method:
        name, (_, *parameters) = method.__name__, inspect.signature(method).parameters.values()
        positional = [one.name for one in parameters if one.kind is one.POSITIONAL_OR_KEYWORD]
        defaults = {one.name: one.default for one in parameters if one.default is not one.empty}
        takes = tuple(one.name for one in parameters if one.name not in defaults)
        may = tuple(one.name for one in parameters if one.default is None and one.annotation == "Any")
        options = {one: value for one, value in defaults.items() if one not in (*may, "workers")}
        axes = {
            system: {one: axis for one, _, axis in (column.partition(":") for column in text.split())}
            for system, text in columns.items()
        }
        _ROWS[name] = Question(name, axes, takes, may, options, argument_axes, kinds)

        @functools.wraps(method)
        def ask(self: Any, /, *arguments: Any, **named: Any) -> Any:
            method(self, *arguments, **named)  # does nothing but refuse what it does not take
            for one, value in zip(positional, arguments):  # noqa: B905
                named[one] = value
            return self._ask(name, **{**defaults, **named})

        return cast("Method", ask)

    return declared


class Unanswered:
    """In the place of a question's method where it has no answer: to look for it raises NoAttribute, which says why."""

    def __init__(self, why: str) -> None:
        self.why = why

    def __get__(self, one: Any, kind: Any = None) -> Any:
        if one is None:
            return self
        raise validate.NoAttribute(self.why)


class ManyQuestions(Generic[Found]):
    """The questions about many designs: each returns a `Batch`, of a grid an xarray Dataset.

    F_0, Omega, acceleration and duration are numbers or arrays that broadcast with the designs; `workers` threads
    share these (-1: one for each processor) and give the same digits. Columns that have several entries for a design
    have one more axis, of `places` entries, NaN and 0 behind the last one: `Status.TOO_MANY` where there are more. For
    a design without an answer nothing is raised: `status` says why. Raises ValueError for arrays that do not broadcast,
    and for what is the same for all designs and not allowed.
    """

    def _ask(self, question: str, /, *, workers: int = 1, **arguments: Any) -> Found:
        """The answer to a question by its name, from what its method takes."""
        raise NotImplementedError

    @asks(_same("F_cr Omega_cr u_cr status", AVERAGING, SECOND) | {OFFSET: "F_cr Omega_cr A B status"})
    def detachment(self, *, workers: int = 1) -> Found:
        """The lowest forcing that reaches u_cr, its frequency, and u_cr (34): .F_cr .Omega_cr .u_cr.

        With a load the motion that comes to a breakpoint, .A and .B, on either side. `Status.NONE` without one.
        """

    @asks(
        _same("F_SN Omega A kind at_rest status", AVERAGING, SECOND) | {OFFSET: "F_SN Omega A B kind status"},
        kinds=OnsetKind,
    )
    def saddle_node_onset(self, *, workers: int = 1) -> Found:
        """The lowest forcing that has a fold (33): .F_SN .Omega .A .kind .at_rest; with a load .B.

        kind    -- a number of `OnsetKind`: a cusp, an isola's birth, on a breakpoint
        at_rest -- 1 where there are folds below it, or without it, that end at Omega = 0

        `.untruncated` is F_SN of the untruncated force where the onset is on a corner that only the truncation makes.
        What doubles do not tell is asked of balls, as of single designs; of the first 20 designs. With a load
        `Status.UNRESOLVED` where the onset is undecided.
        """

    @asks(
        _same("Omega:place A:place kind:place count undecided status", AVERAGING, SECOND)
        | {OFFSET: "Omega:place A:place B:place kind:place count undecided status"},
        kinds=FoldKind,
    )
    def saddle_nodes(self, F_0: Any, *, places: int = 6, workers: int = 1) -> Found:
        """Every fold at F_0, by rising Omega (24), (30): .Omega .A .kind .count .undecided; with a load .B.

        kind      -- a number of `FoldKind`: where a sweep goes that leaves the fold, and whether it sits on a corner at
                     a breakpoint; 0 where the motions that meet are both not stable
        count     -- how many folds there are, also where they are more than places
        undecided -- 1 where neither doubles nor balls tell whether there is another pair, or where one lies

        What doubles leave undecided is asked of balls, as of single designs, see `certify`; of the first 200 designs.
        """

    @asks(
        {
            AVERAGING: "A:place stable:place count undecided status",
            SECOND: "A:place A_1:place phi:place stable:place count undecided status",
            OFFSET: "A:place B:place phi:place transmissibility:place stable:place count undecided status",
        }
    )
    def amplitudes(self, *, F_0: Any, Omega: Any, places: int = 6, workers: int = 1) -> Found:
        """Every steady state at (Omega, F_0), by rising A (24), (30): .A .phi .stable .count .undecided .transmissibility.

        A      -- 0 where friction holds the mass at rest, with `Status.STICKS` if nothing else is there; in the second
                  approximation the largest displacement, beside .A_1 of the fundamental harmonic
        B      -- with a load, the mean displacement
        stable -- 1 where both eigenvalues of the Jacobian (28) have a negative real part
        count  -- how many states there are, also where they are more than places

        Undecided ones as of `saddle_nodes`.
        """  # noqa: E501

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
        F_0: Any,
        *,
        samples: int = 1000,
        Omega: tuple[float, float] = validate.WINDOW,
        places: int = 6,
        workers: int = 1,
    ) -> Found:
        """The response curve at F_0 in the window `Omega` (24), (30), with every fold: .Omega .A .stable .branch .isola.

        Points lie along one more axis, in order along each branch: as long as `samples` and 64 more (256 in the second
        approximation), behind the last of `.points` NaN, branch -1 and 0. `Status.TOO_MANY` where a curve has more
        points, which has none then, or more folds than `places`. Some 25 bytes a point.

        stable -- 1 where both eigenvalues of the Jacobian (28) have a negative real part
        branch -- number of the connected curve that a point lies on, from 0; isolated curves come last
        isola  -- 1 where that curve is closed
        fold_Omega, fold_A, fold_kind, count -- as of `saddle_nodes`; not in the second approximation
        """  # noqa: E501

    @asks(_same("A Omega status", AVERAGING, SECOND) | {OFFSET: "A B Omega u_max Omega_max status"})
    def peak(self, F_0: Any, *, workers: int = 1) -> Found:
        """The highest peak at F_0, isolas included: .A .Omega, which is 0 where A only falls with Omega.

        Of a spring that gives way that within the well. `Status.UNBOUNDED` where nothing ends a response, within it. With
        a load .B, and .u_max at .Omega_max of the motion that goes farthest.
        """  # noqa: E501

    @asks({AVERAGING: "count proved bits status"})
    def certify(self, F_0: Any, *, Omega: Any = None, workers: int = 1) -> Found:
        """How many folds at F_0, or states at (Omega, F_0), are proved: .count .proved .bits; of motions about the centre.

        proved -- 1 where these are proved to be all, with amplitudes as in a single `certify`; 0 where undecided
        bits   -- of the arithmetic: 53 of intervals of doubles, more of balls

        What intervals of doubles leave undecided is asked of balls, as of single designs: one by one, with python-flint
        (`pip install 'slowflow[proofs]'`), some hundredths of a second each; these do not share `workers`.
        `Status.UNRESOLVED` where no proof is possible: of a force whose averages are known in neither.
        """  # noqa: E501

    @asks({OFFSET: "u:place stiffness:place count status"})
    def rest(self, *, places: int = 3, workers: int = 1) -> Found:
        """Where the mass stands under a load, by rising u: .u .stiffness .count."""

    @asks({AVERAGING: "Omega_0 k_0 u_cr break_loose rests_within sticking status"})
    def at_rest(self, *, workers: int = 1) -> Found:
        """What holds whatever the forcing: .Omega_0 .k_0 .u_cr, and by friction .break_loose .rests_within .sticking.

        As of a single `at_rest`: NaN where there is no frequency or no stroke; rests_within may be inf.
        """

    @asks(
        _same("F_SN F_cr of_SN of_cr kind folds detaches sticks Omega_sticks onset status", AVERAGING, OFFSET),
        kinds=OnsetKind,
    )
    def margins(self, F_0: Any, *, workers: int = 1) -> Found:
        """How far F_0 is from F_SN and F_cr: .of_SN .of_cr .folds .detaches .sticks .Omega_sticks .onset.

        F_SN, F_cr, of_SN, of_cr -- inf where there is no such forcing, and F_SN NaN where none is the lowest, or which
                    is not known: `onset` tells; F_cr as in `slowflow.checks.Margins`
        kind     -- of the onset, a number of `OnsetKind`: no sweep jumps at an isola's birth
        detaches, sticks -- 1 where a stable motion passes u_cr, isolated curves included, which may be there below
                    F_cr, and where a mass at rest stays there, whatever the frequency
        onset    -- the status of the onset
        status   -- that of the folds, or of the onset, the detachment or the peak where one of these is not known
        """

    @asks(_same("Omega_low:place Omega_high:place motions:place count status", AVERAGING, OFFSET))
    def hysteresis(self, F_0: Any, *, places: int = 3, workers: int = 1) -> Found:
        """Bands of frequencies with several stable motions at F_0, by rising frequency: .Omega_low .Omega_high .motions.

        count -- how many bands there are, also where they are more than places
        """  # noqa: E501

    @asks({AVERAGING: "Omega A at_fold status", OFFSET: "Omega A at_fold status B"})
    def isolation(self, F_0: Any, *, level_dB: Any = None, workers: int = 1) -> Found:
        """The frequency from which on less than F_0 is transmitted: .Omega .A .at_fold; with a load .B.

        level_dB -- numbers that broadcast: the transmissibility in decibels, <= 0, below which it stays; without all of F_0

        0 and NaN where every motion transmits less; NaN where there is no such frequency, `Status.NONE`.
        """  # noqa: E501

    @asks(
        _same(
            "A:row transmissibility_dB:row motions:row crosses:row detaches:row sticks:row status:row",
            AVERAGING,
            OFFSET,
        ),
        argument_axes={"Omega": "row", "F_0": "row"},
    )
    def spectrum(self, *, Omega: Any, F_0: Any, workers: int = 1) -> Found:
        """A load spectrum, one tone at a time: .A .transmissibility_dB .motions .crosses .detaches .sticks.

        The last axis of Omega and F_0, which broadcast, is that of the rows; what they have before it broadcasts with
        the designs. Answers have the axes of the designs, then that of the rows. `Status.NONE` where no motion is
        stable, and of what fails that of the states, or of the folds on the way.
        """

    @asks(
        {AVERAGING: _TRANSIENT, OFFSET: f"{_TRANSIENT} stands"},
        argument_axes={"tau": "instant", "acceleration": "instant"},
    )
    def transient(
        self, *, acceleration: Any, duration: Any = None, tau: Any = None, after: float | None = None, workers: int = 1
    ) -> Found:
        """What a shock of the base does: .A .tau_A .a_max .tau_a .detaches .tau_detaches .rests .u_end.

        Peak and duration of a half sine broadcast with the designs; of a record the last axis of `tau` and
        `acceleration` is that of its samples, and what they have before it broadcasts with the designs. Some thirty
        thousand designs in a second. `Status.UNRESOLVED` where the motion escapes or chatters; with a load .stands, the
        number of stable places of rest, of which it begins at that nearest to the centre, in hundredths of a second a
        design.
        """

    @asks({AVERAGING: "A a_max ratio detaches status", OFFSET: "A a_max ratio detaches status stands"})
    def shock_spectrum(self, *, acceleration: Any, duration: Any, workers: int = 1) -> Found:
        """What a half sine of the base does: .A .a_max .ratio .detaches; with a load .stands, as of `transient`.

        Raises ValueError for structural damping. Designs with other laws of damping are followed one by one, in
        milliseconds each.
        """

    @asks(
        {
            AVERAGING: "u_rms:place v_rms:place a_rms:place stiffness:place damping:place Omega_e:place ratio_e:place "
            "beyond:place crossing_rate:place dry:place count status"
        }
    )
    def random(
        self, *, S_0: Any = None, psd: tuple[Any, Any] | None = None, places: int = 3, workers: int = 1
    ) -> Found:
        """Stationary random vibration, by rising u_rms: .u_rms .v_rms .a_rms .stiffness .damping .beyond .dry .count.

        S_0 -- of white noise, numbers that broadcast with the designs
        psd -- frequencies and densities instead, the same for all designs, in milliseconds each

        As of a single `random`; of several motions, or where dry is above 0.8, what is said there holds.
        `Status.UNRESOLVED` also where there is no stationary motion.
        """


#: those about motions in time, which a pulse or a record of the base excites
SHOCKS = tuple(name for name, row in QUESTIONS.items() if "acceleration" in row.takes)
