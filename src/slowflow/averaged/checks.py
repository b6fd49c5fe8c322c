"""Results of checks: margins, hysteresis, isolation, load spectra."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import pairwise
from typing import Any, ClassVar

import numpy as np

from slowflow.answers.answer import LOADED, Labels, Single, Table, joined, sentences
from slowflow.answers.gradient import NO_GRADIENT, Gradient
from slowflow.answers.results import OfPoint, Remark
from slowflow.answers.validity import MeasuredPoint
from slowflow.averaged import diagnostics, messages, solvers
from slowflow.averaged.isolating import (
    BEYOND,
    ISOLATES,
    LEAST,
    NEVER,
    WHOLE,
    Level,
    as_level,
    highest,
    isolated,
    lowest_passed,
    passes_on,
    rests_up_to,
)
from slowflow.core import validate
from slowflow.core.mechanism import Flags, Floats, Ints, Law, by_piece
from slowflow.core.model import THROUGHOUT, SlowFlow
from slowflow.support.errors import NotSettled
from slowflow.support.text import Sentence, text
from slowflow_kernels.conventions import ENDLESS, HIGHEST_OMEGA, Status

ISOLA = text("at {F_SN} an isolated curve is born: a sweep from rest neither reaches it nor jumps there")
APART = text(
    "motions beyond {u_cr} at a forcing below {F_cr} are on isolated curves, none of which passes {u_cr}, so that a "
    "slow change from rest does not reach them"
)
WITHIN = "motions whose mean stiffness vanishes may lose their stability within a band too"
NONE_STABLE = Sentence("no motion is stable at {Omega = :g}, {F_0 = :g}")
BETWEEN = Sentence("the motions between two folds at {Omega = :.10g} are not resolved")
#: relative distance of folds within which rounding may leave the states between them open
NARROW = 1e-8
#: amplitudes at which the highest frequency of the backbone is looked for, and points of a response curve
SAMPLES = 2000
#: places up to which friction may hold the mass, between which its force is looked at, and halvings that leave rounding
POSITIONS, HALVINGS = 256, 110
#: steps between two rows of a load spectrum whose forcings differ, and the share of the way that is cut no more
STEPS = 16
SHORTEST = 1e-6
#: into how many parts a way is cut: two, or as many as are asked of together at the cost of few
HALVES, AT_ONCE = 2, 16
#: forcings that many ways share where each takes hundredths of a second, and up to which fraction two are one
SHARED, ROUNDED = 32, 1e-13


class Composed:
    """Common part of answers that combine others."""

    def gradient(self) -> Gradient:
        """Raise Refused: only the answers that it combines have gradients."""
        raise validate.NotAvailable(NO_GRADIENT)


@dataclass(frozen=True, eq=False)
class AtRest(Composed, Single):
    """Data of an oscillator without excitation.

    Omega_0, k_0 -- natural frequency and stiffness of small motions about the centre; no frequency where k_0 < 0
    u_cr         -- the stroke, at which the springs detach; None for a force of one piece
    break_loose  -- the constant force that friction holds, static friction if specified
    rests_within -- distance from the centre within which friction holds the mass, by the untruncated force if there is
            one; None if unlimited
    sticking     -- the force amplitude up to which averaging predicts sticking, 4 mu/pi (27)
    """

    Omega_0: float | None
    k_0: float
    u_cr: float | None
    break_loose: float
    rests_within: float | None
    sticking: float


@dataclass(frozen=True, eq=False)
class Margins(Composed, Single):
    """The critical forcings, and their ratios to a forcing F_0; None if there is no such forcing.

    F_SN, F_cr  -- the lowest forcing that has a fold, and the lowest that detaches the springs; under base excitation
            or unbalance F_cr may be a limit that is not attained, as the frequency tends to inf
    of_SN, of_cr -- margins F_SN/F_0 and F_cr/F_0, above 1 if the limit is not exceeded
    kind        -- of the onset, as in `SaddleNodeOnset`
    folds       -- number of folds at F_0
    detaches    -- whether a stable motion at F_0 passes u_cr, also on isolated curves, which may exist below F_cr
    sticks      -- whether a mass at rest sticks at every frequency
    Omega_sticks -- frequency up to which a mass at rest sticks: 0 if it moves at every frequency, inf if at none
    message     -- diagnostics as text
    remarks     -- flags of the onset, the detachment and the folds
    """

    labels: ClassVar[Labels] = {"Omega_sticks": {0.0: "at no frequency", math.inf: "at every frequency"}}

    F_0: float
    F_SN: float | None
    F_cr: float | None
    of_SN: float | None
    of_cr: float | None
    kind: str
    folds: int
    detaches: bool
    sticks: bool
    Omega_sticks: float
    message: str
    remarks: Remark


@dataclass(frozen=True, eq=False)
class Hysteresis(Composed, Table, entry="Band"):
    """Bands of frequencies with more than one stable motion; which one is observed depends on the history.

    Omega_low, Omega_high -- ends of the band: folds, 0, or inf if a motion has no end, as without viscous damping
    motions -- number of stable motions in the band, including the equilibrium at which a preload holds the mass
    remarks -- flags of the folds; UNDECIDED also if the motions between two nearly equal folds are not resolved
    """

    Omega_low: Floats
    Omega_high: Floats
    motions: Ints
    F_0: float
    message: str
    remarks: Remark


@dataclass(frozen=True, eq=False)
class Isolation(OfPoint, Single):
    """The frequency above which every stable motion transmits less than the force, or a fraction of it, `level_dB`.

    Omega -- that frequency; 0 if every motion transmits less; None if there is no motion, or no such frequency
    A     -- the amplitude at Omega
    at_fold -- whether the motions that transmit more end at Omega in a fold, at which they exceed the level
    B, load -- under a load, the mean displacement at Omega, None if A is None, and the load over k_v L
    remarks -- flags of the response
    level_dB -- the transmissibility in decibels, not printed if 0
    """

    Omega: float | None
    A: float | None
    at_fold: bool
    F_0: float
    message: str
    remarks: Remark
    level_dB: float = field(default=0.0, kw_only=True)
    B: float | None = field(default=None, kw_only=True, metadata=LOADED)
    load: float | None = field(default=None, kw_only=True, metadata=LOADED)

    def _content(self) -> dict[str, Any]:
        found = super()._content()
        if not self.level_dB:
            del found["level_dB"]
        return found

    def measure(self, of: str = "first", force: str | None = None) -> MeasuredPoint:
        """Compute the frequency of isolation by the equation of motion (3), from neighbouring motions.

        of -- "first": the fundamental harmonic of the transmitted force, as in averaging; "peak": the peak of its
                waveform, which includes the jumps of friction

        If isolation begins at a fold, the fold of the exact curve is returned, unless the motions beyond it transmit
        more. `force` and errors as in `SteadyStates.measure`.
        """
        return self._measured(force, validate.choice("of", of, ("first", "peak")))

    def gradient(self) -> Gradient:
        """Differentiate Omega and A with respect to the parameters and F_0, as those of the state or fold there.

        The derivatives are exact. If isolation begins at a fixed frequency there is no gradient; `.status` and
        `.message` say so.
        """
        at = self.Omega, self.A, self.F_0, self.at_fold, Level.of(self.level_dB).ratio
        return self._gradient_from("isolation", *at)


@dataclass(frozen=True, eq=False)
class Spectrum(Composed, Table, entry="Load"):
    """A load spectrum, one tone at a time, row by row in the given order.

    A        -- the largest stable amplitude, about the mean; 0 if the mass sticks, nan if no motion is stable
    transmissibility_dB -- transmissibility of the motion with this amplitude; 0 if the mass sticks, nan if no motion is
            stable
    motions  -- number of stable motions
    crosses  -- whether a fold, at which a stable motion ends, lies on the straight line from the previous row
    detaches -- whether a stable motion passes u_cr
    sticks   -- whether the mass does not move
    """

    Omega: Floats
    F_0: Floats
    A: Floats
    transmissibility_dB: Floats
    motions: Ints
    crosses: Flags
    detaches: Flags
    sticks: Flags
    message: str
    _remarks: diagnostics.Codes = field(repr=False)  # of the states of each row


def at_rest(oscillator: Any) -> AtRest:
    """See `Oscillator.at_rest`; for an oscillator about its centre."""
    model = oscillator.model
    found = {name: float(value) for name, value in static(model, model.design, oscillator.mu_s).items()}
    none = {name for name, value in found.items() if not math.isfinite(value)}
    return AtRest(**{name: None if name in none else value for name, value in found.items()})  # type: ignore[arg-type]


def static(flow: SlowFlow, design: Sequence[Any], mu: Any) -> dict[str, Any]:
    """The columns of `AtRest`, of one oscillator or of many; NaN, or inf for `rests_within`, where there is none.

    design -- the numbers of the design; mu -- the friction that holds a mass at rest
    """
    law, of_law, end = flow.mechanism, flow.parameters, flow.first_end
    with np.errstate(all="ignore"):  # what is no design has no stiffness
        if law.load_untruncated is not None:
            law = law.load_untruncated()
            of_law = law.coefficients(*design)
        k_0 = 0.0 - flow._rest[1]  # a spring without stiffness at the centre has +0
        within = rests_within(law.pieces, of_law, law.breakpoints(*of_law), mu)
        if flow.laws.contact != THROUGHOUT:
            within = np.minimum(within, end)
        found = {"Omega_0": np.sqrt(k_0), "k_0": k_0, "u_cr": np.where(np.isfinite(end), end, np.nan)}
    return found | {"break_loose": mu, "rests_within": within, "sticking": flow.m}


def rests_within(laws: Sequence[Law], parameters: Sequence[Any], ends: Sequence[Any], mu: Any) -> Floats:
    """The |u| up to which friction holds the mass, |f(u)| <= mu; inf if everywhere.

    laws, ends -- of the pieces of the force, the last without end; parameters -- of all of them. Shapes broadcast
    """
    friction, *values = np.broadcast_arrays(*(np.asarray(value, dtype=float) for value in (mu, *parameters, *ends)))
    parameters, ends = values[: len(parameters)], values[len(parameters) :]

    def holds(u: Floats) -> Flags:
        return np.asarray(np.abs(by_piece(laws, ends, u, parameters)) <= friction)

    with np.errstate(all="ignore"):  # what is no design has none
        far = friction + 1.0 + (ends[-1] if ends else 0.0)
        low, high, left = np.zeros(friction.shape), np.full(friction.shape, math.inf), friction > 0
        for k in range(1, POSITIONS + 1):
            at, inside = far * (k / POSITIONS), holds(far * (k / POSITIONS))
            high = np.where(left & ~inside, at, high)
            low, left = np.where(left & inside, at, low), left & inside
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            inside = holds(middle) & (high < math.inf)
            low, high = np.where(inside, middle, low), np.where(inside, high, np.minimum(middle, high))
    return np.where(friction > 0, np.where(left, math.inf, low), np.where(friction == 0, 0.0, math.nan))


def margins(oscillator: Any, F_0: float) -> Margins:
    """See `ComposedQuestions.margins`; for an oscillator that answers them."""
    F_cr = oscillator._lowest_detaching()
    folds = oscillator.saddle_nodes(F_0)
    onset, detachment = oscillator.saddle_node_onset(), oscillator.detachment()
    model = oscillator.model
    # even if a mass at rest stays there, there may be motions that detach
    sticks = folds.F_0 <= oscillator.sticking_forcing
    detaches = not model.sticks(folds.F_0) and oscillator._detaches(folds.F_0)
    remarks = (folds.remarks | detachment.remarks) & ~onset.remarks
    texts = (
        folds.message if sticks or Remark.CUT in folds.remarks else "",
        ISOLA if onset.kind == "isola" and Remark.OF_TRUNCATION not in onset.remarks else "",
        onset.message,
        detachment.message if model.inertial else "",
        APART if detaches and F_cr is not None and folds.F_0 < F_cr else "",
        *diagnostics.messages(remarks, model, folds.F_0),
    )
    return Margins(
        folds.F_0,
        onset.F_SN,
        F_cr,
        None if onset.F_SN is None else onset.F_SN / folds.F_0,
        None if F_cr is None else F_cr / folds.F_0,
        onset.kind,
        len(folds),
        detaches,
        sticks,
        math.inf if sticks else math.sqrt(model.m / folds.F_0) if model.inertial else 0.0,
        joined(*dict.fromkeys(part for message in texts if message for part in sentences(message))),  # each once
        remarks | onset.remarks,
    )


def passes_first_end(oscillator: Any, F_0: float) -> bool:
    """Whether a stable motion passes the first breakpoint."""
    if not oscillator.breakpoints:
        return False
    model, peak = oscillator.model, oscillator.peak(F_0)
    if peak._status == Status.STICKS:
        return False
    if peak.A is not None and Remark.LEAVES_CENTRE not in peak.remarks:  # the highest motion is stable
        return bool(peak.A > oscillator.breakpoints[0])
    if model.inertial and peak.A is None and not peak._escapes:
        # it does not close, or only rises, towards F_0 or with quadratic damping towards less
        return not oscillator.closes(F_0) or F_0 > float(model.full_level(oscillator.breakpoints[0]))
    if model.undamped and resonates(model):
        return True
    curve = oscillator.frequency_response(F_0, samples=SAMPLES, Omega=(0.0, _window(oscillator, F_0)[1]))
    return bool((curve.A[curve.stable] > oscillator.breakpoints[0]).any())


def resonates(flow: SlowFlow) -> Any:
    """Whether motions of any amplitude have a frequency: without viscous damping they are then stable."""
    with np.errstate(all="ignore"):  # a force of one's own may go beyond the range of doubles
        return np.asarray(flow.averaged(ENDLESS)[1]) < 0


def hysteresis(oscillator: Any, F_0: float) -> Hysteresis:
    """See `ComposedQuestions.hysteresis`; for an oscillator that answers them."""
    folds = oscillator.saddle_nodes(F_0)
    # beyond the last fold the number of motions does not change any more
    ends = [0.0, *np.unique(folds.Omega).tolist(), math.inf]
    bands, unresolved = [], []
    for low, high in pairwise(ends) if len(folds) else ():
        middle = min(0.5 * (low + high) if high < math.inf else 2 * low, HIGHEST_OMEGA)
        if not low < middle < high:  # there is no frequency between them, or none that is answered
            continue
        try:
            stable = int(oscillator.amplitudes(Omega=middle, F_0=F_0).stable.sum())
        except NotSettled:
            if high - low > NARROW * high:
                raise
            unresolved.append(low)
            continue
        if stable > 1:
            bands.append((low, high, stable))
    low, high, motions = np.array(bands).reshape(-1, 3).T
    is_known = not (bands or unresolved or Remark.CUT in folds.remarks)
    none = "at each frequency at most one motion is stable" if is_known else ""
    between = BETWEEN.format(np.array(unresolved)) if unresolved else ""
    message = joined(folds.message, none, between, WITHIN if (folds.kind == "unstable").any() else "")
    remarks = folds.remarks | (Remark.UNDECIDED if unresolved else Remark(0))
    return Hysteresis(low, high, motions.astype(np.intp), folds.F_0, message, remarks)


def isolation(oscillator: Any, F_0: float, level_dB: float = 0.0) -> Isolation:
    """See `ComposedQuestions.isolation`: `isolated` of one response curve, with its message."""
    F_0, level, model = validate.number("F_0", F_0, above=0.0), as_level(level_dB), oscillator.model
    made = partial(Isolation, level_dB=level.dB, _model=model, _equation=oscillator._equation)
    if model.inertial and not (oscillator.closes(F_0) or solvers.is_cut(model, F_0)):
        return made(None, None, False, F_0, NEVER.format(str(level)), Remark(0))
    if F_0 <= oscillator.sticking_forcing and (at_rest := oscillator.peak(F_0))._status == Status.STICKS:
        return made(None, None, False, F_0, at_rest.message, at_rest.remarks)
    if why := passes_on(model, oscillator.transmissibility_floor(F_0), level):
        return made(None, None, False, F_0, why, Remark(0))
    curve = oscillator.frequency_response(F_0, samples=SAMPLES, Omega=_window(oscillator, F_0, level))
    if not len(curve):
        return made(None, None, False, F_0, curve.message, curve.remarks)
    at_fold, *at = isolated(model, curve, F_0, level)
    Omega, A = (None if math.isnan(one) else float(one) for one in at)
    none = NEVER if Omega is None else ISOLATES if Omega == 0 else None
    if none is None or solvers.is_cut(model, F_0):  # motions beyond the reach of the force are not known
        message = curve.message
    else:
        message = joined(curve.message, none.format(str(level)))
    return made(Omega, A, bool(at_fold), F_0, message, curve.remarks)


def _window(oscillator: Any, F_0: float, level: Level = WHOLE) -> tuple[float, float]:
    """Frequencies outside which no motion begins or ceases to transmit the force, or that fraction of it."""
    model, found = oscillator.model, oscillator.peak(F_0)
    # the whole curve, beyond the well as well
    peak = solvers.peak(model, F_0).A if found._escapes else found.A
    if model.inertial and peak is None and oscillator.closes(F_0):  # no amplitude exceeds F_0
        peak = F_0
    A_max = peak if peak is not None else model.reach
    lets_go = not (math.isfinite(A_max) or model.undamped)
    if not math.isfinite(A_max):
        A_max = messages.cut(model, F_0)[0]
    high = highest(model, A_max, F_0, level, SAMPLES)
    low = min(lowest_passed(model, A_max, F_0, level), LEAST * high) if lets_go else 0.0
    return low, max(high, min(BEYOND * float(rests_up_to(model, F_0)), float(HIGHEST_OMEGA)))


def spectrum(oscillator: Any, Omega: Any, F_0: Any) -> Spectrum:
    """See `ComposedQuestions.spectrum`; the oscillator may compute the folds of several forcings together."""
    arguments = {"Omega": validate.frequencies("Omega", Omega), "F_0": validate.positive_array("F_0", F_0)}
    shape = validate.common_shape(arguments)
    at, F = (np.broadcast_to(values, shape).ravel() for values in arguments.values())
    points = np.array([at, F])

    folds: dict[float, Floats] = {}  # rows share forcings
    folds_at = oscillator._folds_at
    ask = folds_at or (lambda several: [oscillator.saddle_nodes(one) for one in several])

    def sides(_: Any, Omega: Floats, F_0: Floats) -> Ints:
        new = [one for one in dict.fromkeys(F_0.tolist()) if one not in folds]
        folds.update({one: found.Omega[found.kind != "unstable"] for one, found in zip(new, ask(new), strict=True)})
        found = [on_both_sides(folds[one], np.asarray(at)) for at, one in zip(Omega, F_0.tolist(), strict=True)]
        return np.array(found, dtype=np.intp).reshape(-1, 2).T

    if folds_at is None or not at.size:
        ways = crossed(sides, points[:, :-1], points[:, 1:])
    else:
        shared = np.linspace(F.min(), F.max(), min(STEPS * at.size, SHARED))

        def on_shared(which: Ints, Omega: Floats, F_0: Floats) -> Ints:
            """At the forcings that ways share, to their last digit."""
            nearest = shared[np.abs(shared[:, np.newaxis] - F_0).argmin(axis=0)]
            return sides(which, Omega, np.where(np.abs(nearest - F_0) < ROUNDED * F_0, nearest, F_0))

        ways = crossed(on_shared, points[:, :-1], points[:, 1:], AT_ONCE, shared)
    crosses = np.concatenate(([False], ways))[: at.size]
    found = [_row(oscillator, *here) for here in zip(at.tolist(), F.tolist(), crosses.tolist(), strict=True)]
    rows, texts, codes = zip(*found, strict=True) if found else ((), (), ())
    names = Spectrum.entry._fields
    columns = zip(names, np.array(rows, dtype=float).reshape(-1, len(names)).T, strict=True)
    kinds = {"motions": np.intp, "crosses": np.bool_, "detaches": np.bool_, "sticks": np.bool_}
    typed: dict[str, Any] = {name: column.astype(kinds.get(name, float)) for name, column in columns}
    return Spectrum(**typed, message=messages.at_pairs(at, texts), _remarks=np.array(codes, dtype=np.uint16))


def on_both_sides(folds: Floats, Omega: Any) -> Ints:
    """Number of folds along the last axis (NaN for none) at or below Omega, and above it; shape (2, ...)."""
    above = folds > Omega[..., np.newaxis]
    return np.array([(~above & ~np.isnan(folds)).sum(axis=-1), above.sum(axis=-1)])


def _shares(start: float, end: float, forcings: Floats) -> Floats:
    """Of a way from one forcing to another, where it passes these, with its own ends."""
    if start == end:
        return np.array([0.0, 1.0])
    t = (forcings - start) / (end - start)
    return np.concatenate(([0.0], np.sort(t[(t > 0) & (t < 1)]), [1.0]))


def crossed(
    sides: Callable[[Ints, Floats, Floats], Ints],
    start: Floats,
    end: Floats,
    pieces: int = HALVES,
    forcings: Floats | None = None,
) -> Flags:
    """Which of the straight lines from one (Omega, F_0) to another, each of shape (2, n), cross a fold.

    sides    -- `on_both_sides` for lines by their index, at points (Omega, F_0) on them
    pieces   -- number of pieces into which a line is divided at once: more if several forcings cost little more than
            one
    forcings -- forcings at which lines are divided first; by default at `STEPS` fractions of each

    Since all folds of a forcing are known, a crossed fold is one that changes sides. Where folds appear or vanish, the
    line is divided until this happens on a negligibly short piece.
    """
    found = np.zeros(start.shape[1], dtype=bool)

    def at(which: Ints, t: Floats) -> Ints:
        here = start[:, which] + (end - start)[:, which] * t
        return sides(which, *np.where(t == 1, end[:, which], here))

    if forcings is None:
        steps = np.where(start[1] == end[1], 1, STEPS)
        which = np.repeat(np.arange(found.size), steps)
        number = np.arange(which.size) - np.repeat(np.cumsum(steps) - steps, steps)
        low, high = number / steps[which], (number + 1) / steps[which]
    else:
        cuts = [_shares(*ends, forcings) for ends in zip(start[1].tolist(), end[1].tolist(), strict=True)]
        which = np.repeat(np.arange(found.size), [len(one) - 1 for one in cuts])
        low, high = (np.concatenate([[], *(one[part] for one in cuts)]) for part in (slice(-1), slice(1, None)))
    known = at(np.repeat(which, 2), np.column_stack((low, high)).ravel())
    of_low, of_high = known[:, ::2], known[:, 1::2]
    while which.size:
        as_many = of_low.sum(axis=0) == of_high.sum(axis=0)
        found[which[as_many & (of_low != of_high).any(axis=0)]] = True
        left = np.flatnonzero(~as_many & (high - low >= SHORTEST) & ~found[which])
        which, low, high, of_low, of_high = which[left], low[left], high[left], of_low[:, left], of_high[:, left]
        ends = [low + (high - low) * (k / pieces) for k in range(1, pieces)]
        between = [*at(np.tile(which, pieces - 1), np.concatenate(ends)).reshape(2, pieces - 1, -1).transpose(1, 0, 2)]
        which = np.tile(which, pieces)
        low, high = np.concatenate((low, *ends)), np.concatenate((*ends, high))
        of_low, of_high = np.hstack((of_low, *between)), np.hstack((*between, of_high))
    return found


def _row(oscillator: Any, Omega: float, F_0: float, crosses: bool) -> tuple[Any, str, Remark]:
    """One row, with its message and the codes of its remarks."""
    states = oscillator.amplitudes(Omega=Omega, F_0=F_0)
    stable = np.flatnonzero(states.stable)
    if not stable.size:
        none = Spectrum.entry(Omega, F_0, math.nan, math.nan, 0, crosses, False, False)
        return none, joined(states.message, NONE_STABLE.format(Omega, F_0)), states.remarks
    top = stable[np.argmax(states.A[stable])]
    motions = int(np.count_nonzero(states.A[stable]))
    detaches = motions > 0 and bool(oscillator.breakpoints) and bool(oscillator._is_detached(states)[stable].any())
    A, dB = float(states.A[top]), float(states.transmissibility_dB[top])
    return Spectrum.entry(Omega, F_0, A, dB, motions, crosses, detaches, motions == 0), states.message, states.remarks
