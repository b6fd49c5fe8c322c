"""What a specification requires. Takes a scene with a table [require]; returns what is met, and by which margin."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import Table, joined, plain
from slowflow.answers.quantities import SI, in_shown
from slowflow.answers.table import COLUMNS
from slowflow.core.mechanism import Flags, Floats
from slowflow.oscillators.physical import Physical
from slowflow.support import progress
from slowflow.support.boundary import refusal
from slowflow.support.errors import SceneError, SlowflowError

if TYPE_CHECKING:
    from slowflow.sizing.requirements import Met

#: events that are not allowed: a jump, or springs that detach, at each forcing of [ask]
NONE = ("jumps", "detachment")
#: of what the largest is limited: its columns in the answers about peaks, shocks, and in the mean
AMOUNTS: Mapping[str, Mapping[str, str]] = {
    "relative_displacement": {"peak": "u_max", "shock": "A", "random": "u_rms"},
    "absolute_acceleration": {"shock": "a_max", "random": "a_rms"},
}
TRANSMISSIBILITY = "transmissibility_dB"
REQUIREMENTS = (*NONE, TRANSMISSIBILITY, *AMOUNTS)
#: margins of a design that is looked for: rounding is not to decide whether it meets what binds
SPARE = 1 + 1e-6
#: of how many products the share is that meets a requirement
PRODUCTS = 200


class Requirement(NamedTuple):
    """A requirement.

    name  -- one of `REQUIREMENTS`
    below -- its limit, in SI units or without dimensions; NaN of what must not be
    given -- the rest: from which frequency, in which cases, whether in the mean, and for how long
    """

    name: str
    below: float = math.nan
    options: Mapping[str, Any] = {}


@dataclass(frozen=True, eq=False)
class Verdict(Table, entry="Required"):
    """What a scene requires, a row for each requirement in each load case.

    limit, value -- of jumps and detachment the forcing from which on there are any, and the forcing; of
                    transmissibility the frequency from which on it stays below, required and reached
    margin  -- limit over value: above 1 it is met
    met     -- whether it is; a question without an answer meets nothing
    message -- what to bear in mind
    share   -- of a scene that asks for tolerances, of `PRODUCTS` within [tolerances], those that meet it
    products -- of these the share that meets all
    """

    requirement: npt.NDArray[np.str_]
    case: npt.NDArray[np.str_]
    limit: Floats
    value: Floats
    unit: npt.NDArray[np.str_]
    margin: Floats
    met: Flags
    message: str
    share: Floats | None = None
    products: float | None = None

    @property
    def all_met(self) -> bool:
        """Whether every requirement is met in every load case."""
        return bool(self.met.all())


def kind_of(amount: str) -> str:
    """Of which kind of unit one of `AMOUNTS` is."""
    return COLUMNS[AMOUNTS[amount]["shock"]].kind


def verdict(scene: Any) -> Verdict:
    """Of a scene, by the answers to its questions and others; where it asks for tolerances of its products too."""
    found = _of_design(scene)
    found = replace(found, message=joined(found.message, *_of_motion(scene)))
    if not (queries := scene.of("tolerances")):
        return found
    if "products" not in scene.answers:
        scene.answers["products"] = np.array([*_products(scene, queries[0].arguments["within"], len(found))])
    met = scene.answers["products"]
    return replace(found, share=met.mean(axis=0), products=float(met.all(axis=1).mean()))


def _products(scene: Any, within: Mapping[str, float], count: int) -> Iterator[Flags]:
    """Which of so many requirements each product meets; one that is no design meets none."""
    from slowflow import sizing  # here, not above: it imports SciPy

    numbers = sizing.tolerances(scene.oscillator, within, answers=(), samples=PRODUCTS).drawn
    for row in progress.each(zip(*numbers.values(), strict=True), PRODUCTS, "products"):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                product = scene.oscillator.replace(**dict(zip(numbers, map(float, row), strict=True)))
            yield _of_design(scene.of_design(product)).met
        except (ValueError, ArithmeticError):
            yield np.zeros(count, dtype=bool)


def _of_design(scene: Any) -> Verdict:
    """Of a scene's own design."""
    rows, texts = [], []
    for one in scene.requirements:
        for case, ask in _cases(scene, one):
            try:
                *row, message = ask()
            except SlowflowError as error:
                row, message = [math.nan, math.nan, "", math.nan, False], f"{one.name}, {case}: {error}"
            rows.append((one.name, case, *row))
            texts.append(message)
    columns: dict[str, Any] = dict(zip(Verdict.entry._fields, map(np.array, zip(*rows, strict=True)), strict=True))
    return Verdict(**columns, message=joined(*dict.fromkeys(texts)))


def _cases(scene: Any, one: Requirement) -> Iterator[tuple[str, Any]]:
    """The load cases of a requirement, and what gives limit, value, unit, margin, whether it is met, a message."""
    mount = isinstance(scene.oscillator, Physical)
    for case, at in _forcings(scene) if one.name not in AMOUNTS or "peak" in one.options["under"] else ():
        yield case, lambda at=at: _at_forcing(scene, one, at, mount)
    for query in scene.cases if one.name in AMOUNTS else ():
        under = "random" if query.question == "random" else "shock"
        if under in one.options["under"]:
            yield str(query), lambda query=query, under=under: _under(scene, one, query, under, mount)


def refusals(scene: Any) -> Iterator[tuple[str, str]]:
    """What is refused of a scene's questions and requirements, each with the reason; without their computation."""
    questions = [(str(query), partial(scene.ask, query.question, **query.arguments)) for query in scene.queries]
    questions += [(f"{one.name}, {case}", ask) for one in scene.requirements for case, ask in _cases(scene, one)]
    return ((what, why) for what, ask in questions if (why := refusal(ask)))


def _forcings(scene: Any) -> Iterator[tuple[str, dict[str, float]]]:
    """Those of [ask], as text and as arguments."""
    scales = scene.oscillator.scales if isinstance(scene.oscillator, Physical) else None
    letter, (unit, size) = scales.symbol("F_0") if scales else "F_0", in_shown(SI[scales.amplitude] if scales else "")
    for F in scene.given_forcings:
        yield f"{letter} = {F / size:.4g} {unit}".rstrip(), {letter: F}


def _of_motion(scene: Any) -> Iterator[str]:
    """From which frequency on the motion itself meets a required transmissibility, by first harmonic and by peak."""
    mount = isinstance(scene.oscillator, Physical)
    for one in scene.requirements:
        for case, at in _forcings(scene) if one.name == TRANSMISSIBILITY else ():
            where = f"{one.name}, {case}: in the equation of motion"
            try:
                isolation = scene.ask("isolation", **at, level_dB=one.below)
                waves = (("first", "first harmonic"), ("peak", "peak")) if isolation.A else ()
                found = {wave: isolation.measure(of=of) for of, wave in waves}
            except SlowflowError as error:
                yield f"{where}: {error}"
                continue
            Omega = {wave: _column(point, "Omega", mount) for wave, point in found.items() if not point.message}
            if Omega:
                begins = (f"from {f:.4g}{' Hz' * mount} on for the {wave}" for wave, f in Omega.items())
                yield f"{where}, it is below {one.below:g} dB {' and '.join(begins)}"
            yield from (f"{where}, {wave}: {point.message}" for wave, point in found.items() if point.message)


def _column(found: Any, name: str, mount: bool) -> Any:
    """A column of an answer by its name without dimensions."""
    return getattr(found, (COLUMNS[name].si or name) if mount else name)


def _at_forcing(scene: Any, one: Requirement, at: dict[str, float], mount: bool) -> tuple[Any, ...]:
    (F,) = at.values()
    if one.name in NONE:
        amplitude = SI[scene.oscillator.scales.amplitude] if mount else ""
        found, (unit, size) = scene.ask("margins", **at), in_shown(amplitude)
        ratio, met = (found.of_SN, found.folds == 0) if one.name == "jumps" else (found.of_cr, not found.detaches)
        ratio = math.inf if ratio is None else ratio
        return ratio * F / size, F / size, unit, ratio, bool(met), str(found.message)
    if one.name == TRANSMISSIBILITY:
        found = scene.ask("isolation", **at, level_dB=one.below)
        begins, limit = _column(found, "Omega", mount), one.options["from"]
        value = math.inf if begins is None else begins
        return limit, value, "Hz" if mount else "", _over(limit, value), value <= limit, str(found.message)
    found = scene.ask("peak", **at)
    loaded = (found.answer if mount else found).load is not None
    value = _column(found, AMOUNTS[one.name]["peak"], mount) if loaded else found.A  # about the centre they are one
    return _amount(one, math.inf if value is None else value, mount, str(found.message))


def _under(scene: Any, one: Requirement, query: Any, under: str, mount: bool) -> tuple[Any, ...]:
    """In a shock, or under a spectral density: the largest of its stationary motions, in the mean or within a time."""
    found = scene.ask(query.question, **query.arguments)
    if under == "random" and not one.options["rms"]:
        values = found.largest(one.options["duration"])
    else:
        values = _column(found, AMOUNTS[one.name][under], mount)
    return _amount(one, float(np.max(values)), mount, str(found.message))


def _amount(one: Requirement, value: float, mount: bool, message: str) -> tuple[Any, ...]:
    unit, size = in_shown(SI[kind_of(one.name)] if mount else "")
    return one.below / size, value / size, unit, _over(one.below, value), value < one.below, message


def _over(limit: float, value: float) -> float:
    return limit / value if value else math.inf


def meet(scene: Any) -> tuple[Met, Any]:
    """The design nearest to a scene's that meets what it requires, of numbers within [free], and the scene with it.

    Where none does, the one that comes nearest.
    """
    from slowflow import sizing  # here, not above: it imports SciPy

    if not scene.free:
        raise SceneError(f"{scene.path}: meet needs [free], the numbers that may change with their ranges")
    found = sizing.meet(scene.oscillator, scene.free, margins=lambda design: _margins(scene.of_design(design)))
    return found, scene.of_design(found.design)


def _margins(scene: Any) -> dict[str, float]:
    """Of each requirement in each load case, over `SPARE`: below 1 where it is not met, or only to rounding."""
    found = _of_design(scene)
    # jumps may be absent beyond the forcing from which on there are any, and present below it
    agrees = found.met == (found.margin > 1)
    margins = np.where(agrees, found.margin, np.where(found.met, SPARE, math.nan)) / SPARE
    names = [f"{name}, {case}" for name, case in zip(found.requirement, found.case, strict=True)]
    return dict(zip(names, margins.tolist(), strict=True))


def in_words(found: Verdict) -> str:
    """Met or not, with the least margin."""
    k = int(np.argmin(np.where(found.met, found.margin, -1.0)))
    margin = "" if math.isnan(found.margin[k]) else f", margin {plain(found.margin[k]):.3g}"
    least = f"{found.requirement[k]}, {found.case[k]}{margin}"
    count = int(found.met.sum())
    share = "" if found.products is None else f"; {100 * found.products:g} of 100 products within [tolerances] meet all"
    if found.all_met:
        return f"requirements met: {count} of {count}; the smallest margin: {least}{share}"
    return f"requirements not met: {len(found) - count} of {len(found)}; the first: {least}{share}"
