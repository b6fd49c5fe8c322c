"""Proofs in balls: in go a model with the numbers that it was made from, out come enclosures, and what is proved.

As averaged/proofs.py has them from doubles, with twice as many bits and more, until all is decided or `BITS` are used
up. Also where doubles have no proof at all: the force is averaged by sums that only approach the integral, or the
solvers are not compiled. None where balls have none either.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Sequence
from typing import TypeVar

import numpy as np
import numpy.typing as npt
from flint import arb, ctx

from slowflow.answer import joined
from slowflow.averaged import solvers, words
from slowflow.averaged.balls.enclosure import INFINITE, ZERO, Enclosure
from slowflow.averaged.balls.given import Given, averages_of
from slowflow.averaged.balls.questions import (
    ABOVE_ONSET,
    Asked,
    Candidate,
    Candidates,
    Found,
    is_bounded,
    lowest_at_rest,
    lowest_next_to,
    lowest_of_all,
    lowest_undamped,
    tends_to_friction,
)
from slowflow.averaged.solvers import amplitude_bound
from slowflow.certificate import Proved, ProvedFolds, ProvedForcing, ProvedStates
from slowflow.mechanism import Mechanism
from slowflow.model import Floats, Model
from slowflow_kernels.conventions import ENDLESS, OnsetKind
from slowflow_support.frozen import dataclass

#: how many bits are tried, in turn
BITS = (128, 512)
#: relative width of an enclosure whose middle is right to a unit in the last place of doubles
SHARP = 2.0**-51

Answer = TypeVar("Answer", bound=Proved)

#: the digits of FLINT are one number for all threads
_DIGITS = threading.Lock()


def _are_sharp(*enclosures: Floats) -> bool:
    """Whether enclosures tell each fold or state to a unit in the last place."""
    return all(bool((high - low <= SHARP * high).all()) for low, high in (one.T for one in enclosures))


def _is_forcing_sharp(found: ProvedForcing) -> bool:
    return _are_sharp(*(one.reshape(-1, 2) for one in (found.F_0, found.Omega, found.A)))


def _decided(
    model: Model, ask: Callable[[Given], Answer | None], enough: Callable[[Answer], bool] = lambda found: True
) -> Answer | None:
    """An answer that is proved by as few bits as it takes for it to be good enough, or that of the most."""
    averages = averages_of(model.mechanism)
    if averages is None or not model.has_design:
        return None
    ends = model.mechanism.breakpoints(*model.parameters)  # of which a design without a preload has none above 0
    if not len(ends) == len(model.breakpoints) == len(model.jumps):
        return None
    found = None
    with _DIGITS, np.errstate(all="ignore"):
        for bits in BITS:
            with ctx.workprec(bits):
                more = ask(Given(model, averages))
            if more is None:
                break
            found = more if found is None or more.proved or not found.proved else found
            if more.proved and enough(more):
                break
    return found


def parameters(mechanism: Mechanism, design: Sequence[float]) -> tuple[float, ...] | None:
    """The doubles next to the parameters that follow from a design."""
    averages = averages_of(mechanism)
    if averages is None:
        return None
    with _DIGITS, ctx.workprec(BITS[0]):
        found = averages.given(*map(arb, design))
    return tuple(map(float, found[: len(mechanism.parameter_names)]))


def _double(end: arb, towards: float) -> float:
    """The double that is an exact number, or the next one on that side."""
    value = float(end)
    beyond = arb(value) > end if towards < 0 else arb(value) < end
    return math.nextafter(value, towards) if beyond else value


def _pair(x: Enclosure) -> list[float]:
    return [_double(x.lo, -math.inf), _double(x.hi, math.inf)]


def _pairs(enclosures: Sequence[Enclosure]) -> Floats:
    """Enclosures by doubles, shape (n, 2)."""
    return np.array([_pair(one) for one in enclosures], dtype=float).reshape(-1, 2)


def _remarks(found: Found, bounded: bool, A_max: float) -> str:
    said = []
    if found.doubts:
        where = words.intervals(_pairs(found.doubts))
        said.append(words.BALLS_IN_DOUBT.format(ctx.prec, " for A in " + where))
    if not bounded:
        said.append(words.NOT_BOUNDED.format(A_max))
    return joined(*said)


def _of_forcing(
    model: Model,
    F_0: float,
    ask: Callable[[Asked, float], Found],
    answer: Callable[..., Answer],
    enough: Callable[[Answer], bool] = lambda found: True,
) -> Answer | None:
    """Folds or states at a forcing."""

    def at(given: Given) -> Answer | None:
        if F_0 <= given.m.lo:
            return answer(True, words.sticks(model, F_0), Found(), 0.0, True)
        if not F_0 > given.m.hi:
            return answer(False, words.BALLS_IN_DOUBT.format(ctx.prec, " whether the mass moves"), Found(), 0.0, False)
        try:
            A_max = amplitude_bound(model, F_0)
        except OverflowError:
            return None
        found, bounded = ask(Asked(given, F_0), A_max), is_bounded(given, arb(F_0), A_max)
        return answer(not found.doubts, _remarks(found, bounded, A_max), found, A_max, bounded)

    return _decided(model, at, enough)


def saddle_nodes(model: Model, F_0: float) -> ProvedFolds | None:
    """Every fold at F_0, with what is proved of it."""
    kinds = {0: "", 1: "jump-down", -1: "jump-up"}

    def answer(proved: bool, message: str, found: Found, A_max: float, bounded: bool) -> ProvedFolds:
        kind = np.array([kinds[sign] for sign in found.sign], dtype="U9")
        corner = np.array(found.corner, dtype=bool)
        enclosed = _pairs(found.Omega), _pairs(found.A), kind, corner
        return ProvedFolds(proved, message, ctx.prec, *enclosed, A_max, bounded, _pairs(found.doubts))

    return _of_forcing(
        model, F_0, lambda asked, A_max: asked.folds(A_max), answer, lambda found: _are_sharp(found.Omega, found.A)
    )


def amplitudes(model: Model, Omega: float, F_0: float) -> ProvedStates | None:
    """Every state at (Omega, F_0), with what is proved of it."""

    def answer(proved: bool, message: str, found: Found, A_max: float, bounded: bool) -> ProvedStates:
        stable = np.array([sign > 0 for sign in found.sign], dtype=bool)
        return ProvedStates(proved, message, ctx.prec, _pairs(found.A), stable, A_max, bounded, _pairs(found.doubts))

    return _of_forcing(
        model, F_0, lambda asked, A_max: asked.states(Omega, A_max), answer, lambda found: _are_sharp(found.A)
    )


def _forcing(proved: bool, message: str, best: Candidate | None = None) -> ProvedForcing:
    if best is None:
        nothing = np.empty(0)
        return ProvedForcing(proved, message, ctx.prec, nothing, nothing, nothing, "")
    F_0, Omega, A = (np.array(_pair(one)) for one in (best.level, best.Omega, best.A))
    kind = best.kind.name.lower() if best.kind is not OnsetKind.NO else ""
    return ProvedForcing(proved, message, ctx.prec, F_0, Omega, A, kind)


def onset(model: Model) -> ProvedForcing | None:
    """F_SN, and that no fold is born at a lower forcing; or that there is none, or none that is the lowest."""
    try:
        F_SN = solvers.onset(model).F_SN if model.zeta > 0 else None
        A_max = math.nan if F_SN is None else amplitude_bound(model, F_SN * (1 + ABOVE_ONSET))
    except ArithmeticError:  # unresolved, or beyond the range of doubles
        F_SN, A_max = None, math.nan

    def at(given: Given) -> ProvedForcing | None:
        if model.zeta == 0 and tends_to_friction(given):
            return _forcing(True, words.OF_NO_LOWEST[True])
        if model.zeta == 0:
            best, proved = lowest_undamped(given)
        else:
            best, proved = lowest_of_all(given) if F_SN is None else lowest_next_to(given, F_SN, A_max)
        if best is None:
            said = words.OF_NO_ONSET if proved or model.zeta > 0 else words.OF_NO_LOWEST
            return _forcing(proved, said[proved])
        return _forcing(proved, "" if proved else words.BALLS_IN_DOUBT.format(ctx.prec, ""), best)

    return _decided(model, at, _is_forcing_sharp)


@dataclass(frozen=True, eq=False)
class ProvedCusps(Proved):
    """All cusps of the fold locus up to an amplitude, by rising A; each three intervals hold one, no two the same.

    F_0, Omega, A -- lowest and highest of each, shape (n, 2)
    minimum -- as in `Cusps`, shape (n,)
    """

    F_0: Floats
    Omega: Floats
    A: Floats
    minimum: npt.NDArray[np.bool_]


def cusps(model: Model, A_max: float) -> ProvedCusps | None:
    """Every cusp up to A_max, with what is proved of it."""

    def at(given: Given) -> ProvedCusps:
        candidates = Candidates(Asked(given, math.inf))
        found = sorted(candidates.cusps_up_to(A_max), key=lambda one: float(one[2].middle))
        proved = not candidates.full and all(sign for *_, sign in found)
        said = "" if proved else words.BALLS_IN_DOUBT.format(ctx.prec, "")
        levels, frequencies, amplitudes, signs = zip(*found, strict=True) if found else ((), (), (), ())
        minimum = np.array([sign > 0 for sign in signs], dtype=bool)
        return ProvedCusps(proved, said, ctx.prec, _pairs(levels), _pairs(frequencies), _pairs(amplitudes), minimum)

    return _decided(model, at, lambda found: _are_sharp(found.F_0, found.Omega, found.A))


def at_rest(model: Model, F_SN: float) -> ProvedForcing | None:
    """The lowest level at which the fold locus ends at Omega = 0; proved and of no number if it nowhere does.

    Not proved where states at F_SN may have amplitudes beyond the one that stands for infinite ones.
    """

    def at(given: Given) -> ProvedForcing | None:
        level = lowest_at_rest(given)
        if level is None or not is_bounded(given, arb(F_SN), ENDLESS):
            return _forcing(False, words.BALLS_IN_DOUBT.format(ctx.prec, ""))
        none = Enclosure(ZERO, ZERO)
        return _forcing(True, "", Candidate(level, none, none, OnsetKind.NO) if level.lo < INFINITE else None)

    return _decided(model, at, lambda found: _are_sharp(found.F_0.reshape(-1, 2)))


def detachment(model: Model) -> ProvedForcing | None:
    """F_cr: an enclosure of the lowest forcing that reaches the first breakpoint."""

    def at(given: Given) -> ProvedForcing | None:
        if not given.count:
            return _forcing(True, words.NO_DETACHMENT)
        found = Asked(given, math.inf).detachment()
        if found is None:
            return None
        level, Omega = found
        return _forcing(True, "", Candidate(level, Omega, given.b[0], OnsetKind.NO))

    return _decided(model, at)
