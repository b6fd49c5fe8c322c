"""Inverse design: the nearest design that meets requirements, and Pareto-optimal designs.

The search is SciPy's differential evolution with a seed; each generation is one batch. Sequential quadratic programming
with finite differences then refines the nearest design.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np
import numpy.typing as npt
import scipy  # its `stats`, half a second, when it is used
from scipy.optimize import differential_evolution, minimize

from slowflow.answers.answer import Answer, Table, frozen, head
from slowflow.answers.quantities import SHEET, in_shown
from slowflow.core import validate
from slowflow.core.mechanism import Floats
from slowflow.oscillators.physical import Physical
from slowflow.sizing.subject import LoadCase, Subject
from slowflow.support import progress
from slowflow.support.errors import Refused

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Front", "Met", "front", "meet"]

#: what is missing of an answer that a design does not have: more than any two doubles differ, as the log of their ratio
ABSENT = 2e3
#: a requirement is met to rounding
MET = 1e-9
#: members of a generation for each free number, and generations
MEMBERS, GENERATIONS = 15, 300
#: where designs are asked one by one: designs for each free number from the best of which steps lead on, how many of
#: them do, how many steps, and by which share of its range a number is moved to see what an answer does
FEW, BEST, STEPS, APART = 8, 2, 25, 1e-6
INFEASIBLE = "infeasible: the binding requirement is {}, whose closest achievable value is {:.4g}"
#: points of a front, by how much an end may miss the best that there is, and how near two designs are one
POINTS, SLACK = 9, 1e-4
NO_TRADE = "no trade-off: this design is the best in both answers"
#: by how much farther off than the search's design its finish begins: on the edge itself no step seems to help
BACK = 1e-3


@dataclass(frozen=True, eq=False)
class Met(Answer):
    """The design that meets the requirements and is nearest to the nominal one, or that violates them least.

    design   -- an `Isolator`, or a mount
    feasible -- whether it meets them
    numbers  -- the free parameters, by name
    reached  -- the required answers, by name, for a mount in SI units, printed in N, mm, Hz
    units    -- of both, by name, if they have one
    binding  -- for an infeasible design the requirement with the largest violation, as text; otherwise ""
    """

    design: Any = field(repr=False)
    feasible: bool
    numbers: Mapping[str, float]
    reached: Mapping[str, float]
    binding: str
    message: str
    units: Mapping[str, str]

    def __hash__(self) -> int:
        return hash((self.design, self.binding))

    def in_units(self) -> Met:
        """The same in the units in which answers are shown: N, mm, Hz, ... . Free parameters are not converted."""
        shown = {name: in_shown(self.units.get(name, "")) for name in self.reached}
        reached = {name: value / shown[name][1] for name, value in self.reached.items()}
        units = {name: unit for name, (unit, _) in shown.items() if unit}
        return replace(self, reached=reached, units={**self.units, **units})

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """Whether they are met, the free parameters and the required answers by name, and the message."""
        found = {"feasible": self.feasible, **self.numbers, **self.reached}
        return {name: np.array([value]) for name, value in (found | {"message": self.message}).items()}

    def units_of_columns(self) -> Mapping[str, str]:
        """Units of the columns, by name."""
        return self.units


@dataclass(frozen=True, eq=False)
class Front(Table, entry="Compromise"):
    """Pareto-optimal designs for two answers, in ascending order of `one`.

    one, other -- the two answers, for a mount in SI units, printed in N, mm, Hz
    answers    -- their names
    units      -- their units, "" if dimensionless
    numbers    -- the free parameters of each design, by name, as on the data sheet
    message    -- if there is no design, the requirement that cannot be met; if there is one, that there is no trade-off
    """

    one: Floats
    other: Floats
    answers: tuple[str, str]
    units: tuple[str, str]
    numbers: Mapping[str, Floats]
    message: str
    _of: Any = field(repr=False)

    def __hash__(self) -> int:
        return hash((self.answers, self.one.tobytes(), self.other.tobytes()))

    def in_units(self) -> Front:
        """The same in the units in which answers are shown: N, mm, Hz, ... . Free parameters are not converted."""
        (shown, size), (other_unit, other) = (in_shown(unit) for unit in self.units)
        return replace(self, one=frozen(self.one / size), other=frozen(self.other / other), units=(shown, other_unit))

    def design(self, k: int) -> Any:
        """Make the oscillator or mount of row k."""
        return self._of.replace(**{name: float(values[k]) for name, values in self.numbers.items()})

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """The two answers by name, and the free parameters."""
        return {self.answers[0]: self.one, self.answers[1]: self.other, **self.numbers}

    def units_of_columns(self) -> Mapping[str, str]:
        """Units of the answers and of the parameters, if they have one."""
        known = {**dict(zip(self.answers, self.units, strict=True)), **_sheet(self._of, self.numbers)}
        return {name: unit for name, unit in known.items() if unit}

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot one answer over the other; return the Matplotlib axes, new ones by default."""
        from slowflow.answers import pictures

        shown = self.in_units()
        units = shown.units_of_columns()
        return pictures.front(ax, shown.one, shown.other, (head(self.answers[0], units), head(self.answers[1], units)))


class _Search:
    """Free numbers, requirements, and the designs that meet these."""

    def __init__(
        self,
        of: Any,
        free: Mapping[str, Any],
        at_least: Any,
        at_most: Any,
        seed: int,
        at: Mapping[str, Any],
        margins: Callable[[Any], Mapping[str, float]] | None = None,
    ) -> None:
        self.subject = subject = Subject(of, validate.mapping("free", free, "pairs (lowest, highest)"), at)
        self.load, self.seed = subject.load(), validate.count("seed", seed, least=0)
        limits = (("at_least", at_least or {}, 1.0), ("at_most", at_most or {}, -1.0))
        limited = [
            (name, limit, sign)
            for which, values, sign in limits
            for name, limit in validate.mapping(which, values, "limits").items()
        ]
        self.names = subject.answered([name for name, _, _ in limited], self.load)
        self.targets = [
            (name, validate.number(name, subject.limit(name, limit), above=0.0), sign) for name, limit, sign in limited
        ]
        self.margins = margins or (lambda design: {})
        self.of_margins = list(self.margins(subject.of))
        self.one_by_one = subject.one_by_one or bool(self.of_margins)
        self.names += self.of_margins
        self.targets += [(name, 1.0, 1.0) for name in self.of_margins]
        self.free = list(free)
        ends = [subject.ends(name, pair) for name, pair in free.items()]
        self.low, self.high = np.array(ends, dtype=float).reshape(-1, 2).T
        self.start = np.array([subject.nominal[name] for name in free])
        # of designs that are asked one by one: answers by names and numbers, and shares of ranges that were tried
        self.known: dict[tuple[tuple[str, ...], bytes], tuple[float, ...]] = {}
        self.tried: list[Floats] = []

    def answers(self, values: Floats, names: Iterable[str]) -> dict[str, Floats]:
        """Answers of designs, values of shape (numbers, designs); those that take long are kept."""
        requested = tuple(dict.fromkeys(names))
        if not requested or not self.one_by_one:
            return self._ask(values, requested)
        keys = [(requested, column.tobytes()) for column in values.T]
        new = [k for k, key in enumerate(keys) if key not in self.known]
        if new:
            found = self._ask(values[:, new], requested)
            shown = [np.broadcast_to(found[name], len(new)).tolist() for name in requested]
            self.known |= {keys[k]: row for k, row in zip(new, zip(*shown, strict=True), strict=True)}
        columns = np.array([self.known.get(key, ()) for key in keys], dtype=float).T
        return dict(zip(requested, columns, strict=True))

    def _ask(self, values: Floats, names: Iterable[str]) -> dict[str, Floats]:
        numbers = dict(zip(self.free, values, strict=True))
        found = self.subject.ask(numbers, [name for name in names if name not in self.of_margins], self.load)
        if self.of_margins:
            rows = [self._margins(column.tolist()) for column in values.T]
            found |= {name: np.array([row[name] for row in rows]) for name in self.of_margins}
        return found

    def _margins(self, values: Sequence[float]) -> Mapping[str, float]:
        """The margins of one design, NaN of what is none."""
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # designs on the way to the one that is found
                return self.margins(self.subject.of.replace(**dict(zip(self.free, values, strict=True))))
        except (ValueError, ArithmeticError):
            return dict.fromkeys(self.of_margins, np.nan)

    def unit(self, name: str) -> str:
        """Of an answer; a margin has none."""
        return "" if name in self.of_margins else self.subject.unit(name)

    def short(self, values: Floats) -> Floats:
        """How far each requirement is from being met, by the log of a ratio: shape (requirements, designs)."""
        return np.clip(self.missing(values), 0.0, ABSENT)

    def missing(self, values: Floats) -> Floats:
        """The same, negative where it is met with something to spare."""
        found = self.answers(values, self.names)
        rows = [np.zeros(values.shape[1])]
        for name, limit, sign in self.targets:
            missing = sign * np.log(limit / found[name])
            rows.append(np.where(np.isnan(missing), ABSENT, np.clip(missing, -ABSENT, ABSENT)))
        return np.array(rows)[1:]

    def least(
        self,
        cost: Callable[[Floats], Floats],
        begin: Floats | None = None,
        beyond: Callable[[Floats], Floats] | None = None,
    ) -> Floats:
        """The free numbers with the least cost, a function of (numbers, designs), among those that meet all.

        beyond -- what is not to be positive besides, a function of the same

        Where none meets all, those that miss least; what they cost does not count.
        """
        span = self.high - self.low

        def at(y: Floats) -> Floats:
            """Numbers of shares of their ranges, shape (numbers, designs)."""
            return np.asarray(np.clip(self.low + span * y.T, self.low, self.high).T)

        def whole(y: Floats) -> Floats:
            values = at(y.reshape(len(self.free), -1))
            missed, costs = self.short(values).sum(axis=0), cost(values)
            if beyond is not None:
                over = beyond(values)
                costs = np.where(over > 0, 1 + over, costs)
            return np.asarray(np.where(missed > MET, 1 + missed, costs / (1 + costs)))

        begin = np.clip(((self.start if begin is None else begin) - self.low) / span, 0.0, 1.0)
        if self.one_by_one:
            return at(self._descended(whole, lambda y: self._terms(at(y), cost, beyond), begin)[:, None])[:, 0]
        found = differential_evolution(
            whole,
            [(0.0, 1.0)] * len(self.free),
            x0=begin,
            popsize=MEMBERS,
            maxiter=GENERATIONS,
            tol=1e-8,
            rng=self.seed,
            polish=False,
            updating="deferred",
            vectorized=True,
        )
        return at(found.x[:, None])[:, 0]

    def _terms(self, values: Floats, cost: Callable[[Floats], Floats], beyond: Any) -> Floats:
        """The cost of designs, then what is not to be positive, a row each."""
        rows = [cost(values)[np.newaxis], self.missing(values)]
        return np.concatenate(rows if beyond is None else [*rows, beyond(values)[np.newaxis]])

    def _descended(self, whole: Callable[[Floats], Floats], terms: Callable[[Floats], Floats], begin: Floats) -> Floats:
        """The best, by `whole`, that steps of sequential quadratic programming lead to; shares of ranges throughout.

        They begin at the best of some designs that are spread over the ranges, of those found before, and at `begin`;
        slopes are differences, asked for as one batch.
        """
        size = len(self.free)
        if not self.tried:
            self.tried += list(scipy.stats.qmc.LatinHypercube(d=size, rng=self.seed).random(FEW * size))
        self.tried.append(begin)
        seen: dict[bytes, Floats] = {}

        def around(y: Floats) -> Floats:
            """Terms at y, then at a step in each number, inwards."""
            y = np.clip(y, 0.0, 1.0)
            if (known := seen.get(y.tobytes())) is None:
                steps = np.where(y > 0.5, -APART, APART)
                known = seen[y.tobytes()] = terms(y[:, np.newaxis] + np.hstack((np.zeros((size, 1)), np.diag(steps))))
                known[:, 1:] = (known[:, 1:] - known[:, :1]) / steps
            return known

        costs = whole(np.array(self.tried).T)
        found = []
        for k in np.argsort(costs, kind="stable")[:BEST]:
            result = minimize(
                lambda y: around(y)[0, 0],
                self.tried[k],
                jac=lambda y: around(y)[0, 1:],
                bounds=[(0.0, 1.0)] * size,
                constraints={"type": "ineq", "fun": lambda y: -around(y)[1:, 0], "jac": lambda y: -around(y)[1:, 1:]},
                method="SLSQP",
                options={"maxiter": STEPS, "ftol": 1e-10},
            )
            found.append(np.clip(result.x, 0.0, 1.0))
        self.tried += [y for y in found if np.isfinite(y).all()]
        return self.tried[int(np.argmin(whole(np.array(self.tried).T)))]

    def nearest(self) -> Floats:
        """The free numbers nearest to the start that meet all: the search's, finished by steps along slopes."""
        span = self.high - self.low

        def away(values: Floats) -> Floats:
            return np.asarray((((values.T - self.start) / span) ** 2).sum(axis=-1))

        x = self.least(away)
        if self.short(x.reshape(-1, 1)).max() > MET:
            return x

        # of designs that are asked one by one fewer
        difference = "2-point" if self.one_by_one else "3-point"
        try:
            found = minimize(
                lambda y: float(away(self.low + span * y)),
                np.clip((x - self.low + BACK * (x - self.start)) / span, 0.0, 1.0),
                jac=difference,
                bounds=[(0.0, 1.0)] * len(x),
                constraints={
                    "type": "ineq",
                    "fun": lambda y: -self.missing((self.low + span * y)[:, np.newaxis])[:, 0],
                },
                method="SLSQP",
                options={"ftol": 1e-16},
            )
        except (ValueError, ArithmeticError):  # a design that is none
            return x
        finished = np.clip(self.low + span * found.x, self.low, self.high)
        meets = self.short(finished.reshape(-1, 1)).max() <= MET
        # the search's may be nearer by what it leaves unmet
        return finished if meets and away(finished) <= away(x) * (1 + SLACK) else x

    def binding(self, x: Floats) -> tuple[str, str]:
        """The requirement that a design misses most, and what to say of it; empty where it meets all."""
        if not self.targets:
            return "", ""
        missed = self.short(x.reshape(-1, 1))[:, 0]
        if missed.max() <= MET:
            return "", ""
        name, limit, sign = self.targets[int(missed.argmax())]
        unit, size = in_shown(self.unit(name))
        binding = f"{name} {'>=' if sign > 0 else '<='} {limit / size:g} {unit}".rstrip()
        return binding, INFEASIBLE.format(binding, float(self.answers(x.reshape(-1, 1), [name])[name][0]) / size)


def meet(
    of: Any,
    free: Mapping[str, tuple[float, float]],
    *,
    at_least: Mapping[str, float] | None = None,
    at_most: Mapping[str, float] | None = None,
    margins: Callable[[Any], Mapping[str, float]] | None = None,
    seed: int = 0,
    **at: Unpack[LoadCase],
) -> Met:
    """Find the design nearest to `of` that meets requirements.

    A missing answer violates its requirement; F_SN and F_cr are infinite if there is no such forcing.

    Parameters
    ----------
    of : Oscillator or Physical
        The nominal design; a mount in SI units.
    free : mapping
        By name, the lowest and the highest value of each free parameter; distances are fractions of this range.
    at_least, at_most : mapping, optional
        By name of an answer listed in `slowflow.sizing`, its lower or upper limit.
    margins : callable, optional
        Further requirements: a function of a design that returns positive margins by name, which have to be at least 1.
        Its designs are evaluated one by one.
    seed : int
        Seed of the search.
    **at : LoadCase
        As in `tolerances`.

    Returns
    -------
    Met
        .design; where no design meets all, .feasible is False and .message names the binding requirement.

    Raises
    ------
    ValueError
        For invalid arguments; the message states what is allowed.
    """
    search = _Search(of, free, at_least, at_most, seed, at, margins)
    subject = search.subject
    if not search.targets or not free:
        raise Refused("meet needs at least one requirement and one free parameter")
    # ranges as narrow as rounding, requirements as large as numbers are
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        x = search.nearest()
        answers = search.answers(x.reshape(-1, 1), search.names)
        binding, message = search.binding(x)
    numbers = dict(zip(free, x.tolist(), strict=True))
    reached = {name: float(values[0]) for name, values in answers.items()}
    units = {**{name: search.unit(name) for name in reached}, **_sheet(subject.of, free)}
    units = {name: unit for name, unit in units.items() if unit}
    return Met(subject.of.replace(**numbers), not binding, numbers, reached, binding, message, units)


def front(
    of: Any,
    free: Mapping[str, tuple[float, float]],
    *,
    high: Iterable[str] = (),
    low: Iterable[str] = (),
    at_least: Mapping[str, float] | None = None,
    at_most: Mapping[str, float] | None = None,
    points: int = POINTS,
    seed: int = 0,
    **at: Unpack[LoadCase],
) -> Front:
    """Trace the Pareto front of two answers: no design is better in one without being worse in the other.

    First the best value of one answer is computed, then the best of the other at several levels of the first.

    Parameters
    ----------
    of, free : as in `meet`
        The design and its free parameters.
    high, low : iterable of str
        Names of answers to maximise, and to minimise: two in all.
    at_least, at_most : as in `meet`
        Optional requirements.
    points : int
        Number of designs along the front.
    seed, **at : as in `meet`
        The random numbers and the load case.

    Returns
    -------
    Front
        One row per design. A design that is best in both answers is the only row; if none meets the requirements there
        is no row. `.message` reports both cases.

    Raises
    ------
    ValueError
        For invalid arguments; the message states what is allowed.
    """
    search = _Search(of, free, at_least, at_most, seed, at)
    subject = search.subject
    pair = [(name, 1.0) for name in high] + [(name, -1.0) for name in low]
    if len({name for name, _ in pair}) != 2 or len(pair) != 2 or not free:
        raise Refused("front needs two answers, in high or in low, and at least one free parameter")
    names = one, other = (pair[0][0], pair[1][0])
    subject.answered(names, search.load)
    units = subject.unit(one), subject.unit(other)
    points = validate.count("points", points, least=2)
    nominal = subject.ask({}, names, search.load)
    size = {name: v if np.isfinite(v := float(nominal[name])) and v > 0 else 1.0 for name in names}

    last: list[Any] = [None, None]  # cost and what is not to be exceeded ask of the same designs

    def worth(values: Floats) -> Floats:
        """From 0, the best, to 1: rising functions of what is to be low, bounded as no force may be high enough."""
        if last[0] != (key := values.tobytes()):
            found, rows = search.answers(values, names), []
            for name, sign in pair:
                with np.errstate(invalid="ignore"):
                    ratio = np.where(np.isinf(found[name]), 1.0, found[name] / (found[name] + size[name]))
                rows.append(np.where(np.isnan(ratio), 1.0, 1 - ratio if sign > 0 else ratio))
            last[:] = key, np.array(rows)
        return np.asarray(last[1])

    best = search.least(lambda values: worth(values)[0])
    _, message = search.binding(best)
    if message:
        none = np.empty(0)
        return Front(none, none.copy(), names, units, dict.fromkeys(free, none), message, of)
    end = search.least(lambda values: worth(values)[1])
    # of all that are the best of the other answer, that with the best of the first
    level = float(worth(end.reshape(-1, 1))[1, 0]) + SLACK
    end = search.least(lambda values: worth(values)[0], end, partial(_over, worth, 1, level))
    least, most = (float(worth(x.reshape(-1, 1))[0, 0]) for x in (best, end))
    found = [end]
    for part in progress.chunks(points - 1, 1, "front"):
        level = least + (most - least) * part.start / (points - 1) + SLACK * (most - least)
        found.append(search.least(lambda values: worth(values)[1], best, partial(_over, worth, 0, level)))
    values = np.array(found).T
    kept = _undominated(worth(values))
    answers = search.answers(values[:, kept], names)
    order = np.argsort(answers[one])
    numbers = {name: row[kept][order] for name, row in zip(free, values, strict=True)}
    columns = (answers[one][order], answers[other][order])
    note = NO_TRADE if len(kept) == 1 else ""
    return Front(*columns, names, units, numbers, note, of)


def _over(worth: Callable[[Floats], Floats], which: int, level: float, values: Floats) -> Floats:
    """By how much a worth of designs is above a level."""
    return np.asarray(worth(values)[which] - level)


def _undominated(worth: Floats) -> list[int]:
    """Columns that no other one is as good as in both rows and better in one; of those within SLACK the better."""
    kept: list[int] = []
    for k in np.lexsort(worth[::-1]).tolist():
        one, other = worth[:, k]
        if kept and other >= worth[1, kept[-1]] - SLACK:
            continue
        if kept and one <= worth[0, kept[-1]] + SLACK:
            kept.pop()
        kept.append(k)
    return kept


def _sheet(of: Any, free: Iterable[str]) -> dict[str, str]:
    """The units of free numbers, where they are those of a data sheet."""
    return {name: SHEET[name] for name in free} if isinstance(of, Physical) else {}
