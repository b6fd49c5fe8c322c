"""Numbers of states and folds that an oscillator gives, against proved ones: seeded hard cases in, wrong counts out.

Forcings are drawn next to the levels at which a number changes, from an ulp on, and between them; frequencies next to
folds and at random. A case whose forcing is a level to within `UNDECIDED` is one that doubles cannot decide, as
rounding the inputs and h once each moves the level by as much: those are counted apart.

Doubles alone are asked, and may say that they do not decide. Of those that say so a share is asked again as users ask,
with balls.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from benchmarks.stress.answers import NAMES, design, oscillator
from benchmarks.stress.domains import ulps
from benchmarks.stress.search import Point
from slowflow.answers.results import Remark
from slowflow.averaged.proofs import Allowance
from slowflow.support.errors import NotSettled, SlowflowError
from tests.oracles import counts as proved
from tests.oracles.averaged import Duffing, RodSpring

SEED = 17
#: in u (1 + kappa) of the level
UNDECIDED = 4.0
ORACLES = {"rod_spring": RodSpring, "duffing": Duffing}
#: forcings to an oscillator and frequency, and to an oscillator
FORCINGS = {"states": 150, "folds": 60}
FREQUENCIES = 4
#: share of what doubles leave undecided that balls are asked, which take tens of milliseconds
ASKED_OF_BALLS = 0.1
#: what is counted: cases, those next to a level, those that doubles say they do not decide, of them next to a level,
#: wrong without a word next to one, asked of balls, left open by them, wrong after them, without a proof
NUMBERS = ("cases", "beside", "said", "said beside", "wrong beside", "balls", "open", "wrong by balls", "unproved")
#: right ones kept of each mechanism and question, by doubles and by balls: those next to a level
HARD = 3


def forcings(number: int, levels: list[float], m: float, rng: np.random.Generator) -> Iterator[float]:
    """Next to the levels, between them, and an ulp above 4 mu/pi."""
    for _ in range(number):
        draw = rng.random()
        if draw < 0.1 or not levels:
            F_0 = ulps(m, int(rng.integers(1, 4))) if m and draw < 0.05 else float(10 ** rng.uniform(-4, 1))
        elif draw < 0.2:
            F_0 = ulps(float(rng.choice(levels)), int(rng.integers(-3, 4)))
        elif draw < 0.8:
            F_0 = float(rng.choice(levels)) * (1 + float(rng.choice([-1, 1])) * 10 ** rng.uniform(-15, -1))
        else:
            a, b = rng.choice(levels, 2)
            F_0 = float(a + (b - a) * rng.random())
        if F_0 > m and F_0 > 0:
            yield F_0


def cases(mechanism: str, rng: np.random.Generator) -> Iterator[tuple[str, Any, Point, float, Callable[[], Any]]]:
    """What is asked about one oscillator: states at some frequencies, and folds; each with what proves the number."""
    _, own = design(mechanism, rng)
    own[-1] = min(max(own[-1], 1e-4), 0.5)  # the oracle's bounds need some damping
    iso = oscillator(mechanism, (*own, 1.0, 1.0))
    parameters = dict(zip(NAMES[mechanism][:-2], own, strict=True))
    exact = ORACLES[mechanism](**parameters)
    near = [c.Omega for c in iso.cusps(**({} if math.isfinite(iso.model.reach) else {"A_max": 5.0}))]
    for _ in range(FREQUENCIES):
        Omega = float(10 ** rng.uniform(-0.7, 0.5))
        if near and rng.random() < 0.6:
            Omega = float(rng.choice(near)) * float(1 + 10 ** rng.uniform(-6, -0.5))
        yield "states", iso, tuple(own), Omega, functools.partial(proved.States, exact, Omega)
    yield "folds", iso, tuple(own), math.nan, functools.partial(proved.Folds, exact)


def by_doubles(kind: str, iso: Any, at: Point) -> tuple[int, bool]:
    """The number of states or folds that doubles give, and whether they say that they do not decide it."""
    F_0, Omega = at[-2:]
    if kind == "states":
        states = iso.states(Omega=Omega, F_0=F_0, allowance=Allowance(0))
        return len(states), states.Omega_undecided.size > 0
    folds = iso.folds(F_0, allowance=Allowance(0))
    return len(folds), Remark.UNDECIDED in folds.remarks


def by_balls(kind: str, iso: Any, at: Point) -> tuple[int, bool]:
    """The same of what a user is given: where doubles do not decide, balls are asked."""
    F_0, Omega = at[-2:]
    answer = iso.amplitudes(Omega=Omega, F_0=F_0) if kind == "states" else iso.saddle_nodes(F_0)
    return len(answer), Remark.UNDECIDED in answer.remarks


def stress(mechanism: str, part: int, oscillators: int) -> dict[str, Any]:
    """A share of the oscillators: cases and wrong counts, decided and not."""
    rng = np.random.default_rng([SEED, part, len(mechanism)])
    table: dict[str, dict[str, Any]] = {
        kind: {**dict.fromkeys(NUMBERS, 0), "wrong": [], "refused": [], "hard": []} for kind in ("states", "folds")
    }
    for _ in range(oscillators):
        try:
            drawn = list(cases(mechanism, rng))
        except SlowflowError:
            continue
        for kind, iso, own, Omega, make in drawn:
            row = table[kind]
            try:
                truth = make()
                levels = [float(level.mid()) for level in truth.levels]
                levels = [level for level in levels if level > iso.model.m and math.isfinite(level)]
            except (SlowflowError, NotImplementedError):
                row["unproved"] += 1
                continue
            for F_0 in forcings(FORCINGS[kind], levels, iso.model.m, rng):
                again = rng.random() < ASKED_OF_BALLS
                _one(row, kind, iso, (*own, F_0, Omega), truth, again)
    for row in table.values():
        row["hard"] = [h for by in ("doubles", "balls") for h in sorted(h for h in row["hard"] if h[1] == by)[:HARD]]
    return {"mechanism": mechanism, "names": NAMES[mechanism], **table}


def _one(row: dict[str, Any], kind: str, iso: Any, at: Point, truth: Any, again: bool) -> None:
    F_0 = at[-2]
    try:
        number = truth.count(F_0)
    except NotSettled:
        row["unproved"] += 1
        return
    row["cases"] += 1
    distance = proved.distance(truth, F_0)
    close = distance[0] < UNDECIDED
    row["beside"] += close
    try:
        number_found, undecided = by_doubles(kind, iso, at)
    except NotSettled as refusal:
        row["refused"].append((str(refusal), at))
        return
    row["said"] += undecided
    row["said beside"] += undecided and close
    if undecided and again:
        _asked_again(row, kind, iso, at, number, distance[0])
    if not undecided and number_found != number:
        if close:
            row["wrong beside"] += 1
        else:
            row["wrong"].append((at, number_found, number, *distance))
    if not undecided and number_found == number and math.isfinite(distance[0]):
        row["hard"].append((distance[0], "doubles", at, number))


def _asked_again(row: dict[str, Any], kind: str, iso: Any, at: Point, number: int, units: float) -> None:
    count, undecided = by_balls(kind, iso, at)
    row["balls"] += 1
    row["open"] += undecided
    row["wrong by balls"] += not undecided and count != number
    if not undecided and count == number and math.isfinite(units):
        row["hard"].append((units, "balls", at, number))
