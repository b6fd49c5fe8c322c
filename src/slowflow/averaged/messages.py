"""Messages of averaged answers, and of refusals. Takes numbers; returns text."""

from __future__ import annotations

import dataclasses
import math
import sys
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import numpy as np

from slowflow.answers.answer import joined
from slowflow.answers.results import NOTHING, Peak, Remark, SaddleNodeOnset
from slowflow.core import backend
from slowflow.core.mechanism import Flags
from slowflow.core.model import THROUGHOUT, Floats, Model, SlowFlow
from slowflow.support.text import Sentence, text, together
from slowflow_kernels import dissipation, inertia
from slowflow_kernels.conventions import CLOSE, Status

#: frequencies that a message names
MOST_NAMED = 3

#: messages of an answer at several forcings
MOST_MESSAGES = 3

STICKS = Sentence("sticks: {F_0 = :g} does not exceed 4 {mu}/pi = {sticking:g}")
STICKS_BELOW = Sentence("sticks up to {Omega = :g}: the inertia force does not exceed 4 {mu}/pi = {sticking:g} there")
STAYS_BELOW = Sentence(
    "a mass at rest stays there up to {Omega = :g}: the inertia force does not exceed "
    "4/pi sqrt({mu}^2 + c^2) = {sticking:g} there, c being the preload"
)
NO_FOLD = Sentence("no saddle node at {F_0 = :g}: the response is single-valued")
NO_LOCUS = Sentence("no saddle node with an amplitude up to {A:g}, whatever the forcing")
AT_JUMP = Sentence(", unless it lies within rounding of {A = :g}, where the force jumps")
NO_CUSP = Sentence("no cusp of the fold locus with an amplitude up to {A:g}")
FEW_DIGITS = Sentence("close to a singularity of the force: those at {A = :g} have few correct digits in doubles")
CUSPS_BY_BALLS = "close to a singularity of the force: their digits are from ball arithmetic"
NO_ISOLA = Sentence("no isola is born or merges with an amplitude up to {A:g}")
NO_LOWEST = Sentence(
    "no lowest forcing: without viscous damping there are folds arbitrarily close above 4 {mu}/pi = {sticking:g}"
)
STIFF_AT_REST = Sentence(
    "no lowest forcing: at ever smaller amplitudes there are folds arbitrarily close above 4 {mu}/pi = {sticking:g}, "
    "since the stiffness is infinite at {u} = 0"
)
NO_ONSET = "no saddle node"
AT_REST = Sentence("below it there are folds that end at {Omega = :g}, from {F_0 = :g} on")
OF_PRELOAD = Sentence(
    "below it there are folds down to 4 {mu}/pi = {sticking:g}, of motions that coexist with a mass held by a preload"
)
NONE_BUT_OF_PRELOAD = Sentence(
    "no lowest forcing: there are folds down to 4 {mu}/pi = {sticking:g}, of motions that coexist with a mass held by "
    "a preload"
)
PRELOAD_UNDAMPED = "the onset is unresolved: with a preload, and without viscous damping, it is not searched for"
NONE_BUT_AT_REST = Sentence("no saddle node is born: there are folds that end at {Omega = :g}, from {F_0 = :g} on")
NO_DETACHMENT = "no detachment: the force has one piece only"
NO_PEAK = "no peak: without viscous damping the response is unbounded"
NO_TOP = Sentence("no peak: the amplitude tends to {F_0 = :g} from below as {Omega} tends to inf")
ESCAPES = Sentence(
    "no peak within the well: at {F_0 = :g} the response passes its top, beyond which the spring force points outward "
    "and nothing holds the mass"
)
NOT_REACHED = Sentence(
    "the amplitude tends to {u_cr = :g} as {Omega} tends to inf, at {F_0 = :g}; below this forcing it is not reached"
)
BEYOND_RANGE = Sentence(
    "{F_cr} is not found: squares of the forces at the amplitude {u_cr = :g} are beyond the range of doubles"
)
NO_TOP_BELOW = Sentence("no peak: the amplitude tends to {A:g} from below as {Omega} tends to inf")
NOT_CLOSED = Sentence("the response does not close: it has states of any amplitude; cut at {A = :g}")
OPEN = text(
    "no lowest amplitude of the excitation: folds occur at ever lower ones as their amplitude A or {Omega} increases"
)

MOVES_EXACTLY = Sentence(
    "in the equation of motion friction holds the mass only up to {mu = :g}: from there to 4 {mu}/pi it moves "
    "slightly, with stick phases"
)

ENOUGH_BALLS = "ball arithmetic was used for {} points, not for the others"

#: of proofs
NO_DESIGN = "not certified: the design parameters are not known"
NO_INTERVALS = "not certified: the average of this force has no enclosure on intervals"
NO_BALLS = "ball arithmetic may resolve it: pip install 'slowflow[proofs]'"
FAILED = "not certified: the response is unresolved"
IN_DOUBT = Sentence("double precision is inconclusive for A in {where:s}")
BALLS_IN_DOUBT = Sentence("ball arithmetic with {bits:d} bits is inconclusive{where:s}")
BETWEEN = Sentence("[{A:.17g}]")
NO_ROOM = "there are more than the solver can store"
NOT_BOUNDED = Sentence("only amplitudes up to {A:.6g} are searched")
NEAR_STICKING = text("{F_0} is so close to 4 {mu}/pi that double precision does not decide whether the mass moves")
ONSET_IN_DOUBT = "double precision does not decide whether a lower forcing has a fold"
#: of an onset that there is not: what is not proved, and what is
OF_NO_LOWEST = (
    "not certified: it is not proved that there is no lowest forcing with a fold",
    text("no lowest forcing: zeta = 0, and there are folds arbitrarily close above 4 {mu}/pi"),
)
OF_NO_ONSET = (
    "not certified: it is not proved that no forcing has a fold",
    "no saddle node is born at any forcing",
)


#: a forcing above it has powers beyond the range of doubles: the discriminant of the quartic F in Omega (24) has the
#: cube of its last coefficient, h^2 + m^2 - F_0^2, and so F_0^6
HIGHEST_FORCING = 2.0 ** (sys.float_info.max_exp // 6)


def of_states(model: Model, F_0: float, cut: str, Omega: Floats, found: Floats, undecided: Floats) -> str:
    """The message of states at the frequencies `Omega` of the query.

    cut       -- where the response is cut, in words or empty
    found     -- frequencies of the states
    undecided -- those of these frequencies at which their number is
    """
    if model.sticks(F_0):
        return sticks(model, F_0)
    missing = np.setdiff1d(np.setdiff1d(Omega[~model.sticks_at(F_0, Omega)], undecided), found)
    none = NO_STATE.format(missing) if missing.size else ""
    more = ", ..." * (undecided.size > MOST_NAMED)
    at = UNDECIDED_AT.format(undecided[:MOST_NAMED], more) if undecided.size else ""
    return joined(cut, none, sticks_below(model, F_0, Omega), at)


def intervals(doubt: Iterable[Any]) -> str:
    """Intervals of amplitudes."""
    return together(", ", tuple(map(BETWEEN.format, doubt)))


def codes(undecided: bool, cut: str) -> Remark:
    """The codes of an answer whose count rounding may decide; `cut` is a message, empty if the response is not cut."""
    if not (undecided or cut):  # of most, and to make a code takes longer
        return NOTHING
    return Remark(int(Remark.UNDECIDED) * bool(undecided) + int(Remark.CUT) * bool(cut))


def of_points(A: Floats, few: Flags, none: str) -> dict[str, Any]:
    """The message of cusps or isola points at A: which of them have few digits; `none` if there are none."""
    if few.any():
        return {"message": FEW_DIGITS.format(A[few]), "remarks": Remark.UNDECIDED}
    return {"message": "" if A.size else none}


def of_folds(model: Model, F_0: float, any_folds: bool, cut: str) -> tuple[str | Callable[[], str], str]:
    """The message of folds, or what makes it, and what it has of where the response is cut, `cut`, in words or empty.

    any_folds -- whether there are folds, or may be
    """
    if model.sticks(F_0):
        return partial(sticks, model, F_0), ""
    kept = cut if cut and (any_folds or leaves_out(model)) else ""
    return kept if any_folds or kept else partial(NO_FOLD.format, F_0), kept


def leaves_out(flow: SlowFlow) -> Any:
    """Whether a cut may leave out folds where there are none below it, of one oscillator or of many.

    An undamped response ends where what is beyond has no fold, unless the force ends there; without a spring there is
    no fold at all.
    """
    if flow.inertial or flow.mechanism.enclosed is not None:
        return True
    return ~np.asarray(flow.undamped) & (bool(flow.breakpoints) | (flow.averaged(1.0)[0] != 0))


def sticks(model: Model, F_0: float) -> str:
    """Why the mass stays at rest (27); where F_0 is the double next to 4 mu/pi, by how much."""
    message = STICKS.format(F_0, model.m)
    return message + " by more than rounding" if F_0 == model.m else message


UNRESOLVED = Sentence("the response is unresolved at {F_0 = :.17g}: {why:s}")
POWERS = "powers of it leave the range of doubles; in larger units of length it may be resolved"
COINCIDE = "branches coincide within rounding"
COINCIDE_AS = Sentence(
    "branches coincide within rounding, as {F_0} exceeds 4 {mu}/pi = {sticking:.17g} by no more than rounding"
)
SQUARES = Sentence(
    "the response is unresolved at {F_0 = :.17g}{laws:s}: squares of the forces at its amplitudes leave the range of "
    "doubles"
)


def unresolved(model: Model, F_0: float) -> str:
    """That branches coincide within rounding, and why where F_0 hardly moves the mass, or that they are too large."""
    if F_0 > HIGHEST_FORCING:
        return UNRESOLVED.format(F_0, POWERS)
    near = not model.inertial and F_0 <= model.m * (1 + CLOSE)
    return UNRESOLVED.format(F_0, (COINCIDE_AS.format(model.m) if near else COINCIDE) + _or_not_known(model))


def _or_not_known(model: Model) -> str:
    """What else may leave an answer unresolved where averages are quadratures."""
    return ", or the average does not converge at some amplitude" if model.mechanism.enclosed is not None else ""


UNBOUNDED_AT = Sentence("no amplitude bounds the response at {F_0 = :g}")
UNBOUNDED = "no amplitude bounds the response"
ENDS_BY_REACH = Sentence(
    ": the force of {name:s} does not bound motions of any size, or is beyond the range of doubles there; give its "
    "`reach`, a number > 0, the largest |{u}| for which it is valid: mechanism(..., reach=...)"
)


def unbounded(model: Model, F_0: float | None) -> str:
    """That no amplitude was found that bounds the response, and what helps a force that is not known far away."""
    message = UNBOUNDED if F_0 is None else UNBOUNDED_AT.format(F_0)
    if model.mechanism.enclosed is None or math.isfinite(model.reach):
        return message
    return message + ENDS_BY_REACH.format(model.mechanism.name)


SLIDES_FREE = Sentence(
    "the onset is not resolved: up to |{u}| = {u:.6g} there is no spring, and no damping at {Omega = :g} that grows "
    "with the amplitude, so there are folds down to {Omega = :g}; eta > 0 resolves it"
)
BALANCED = text(
    "the onset is not resolved: with quadratic damping alone the forcing of a fold does not depend on {Omega} where "
    "the averaged stiffness is 0, as between negative stiffness at the centre and the springs beyond it; zeta > 0 or "
    "eta > 0 resolves it"
)
NEXT_TO = Sentence(
    "the onset is unresolved: double precision does not resolve which folds are born at the breakpoint {A = :g}{why:s}"
)
IN_BALLS = text("; certify({F_0}).saddle_node_onset may enclose it, by ball arithmetic")


def unresolved_onset(model: Model) -> str:
    """That rounding may decide where folds are born, and next to which amplitudes."""
    if model.zeta == 0 and model.preload > 0:
        return PRELOAD_UNDAMPED
    if model.laws.c_2 > 0 and model.laws.eta == 0:
        quadratic_only = model.zeta + model.m == 0
        plays = [b for b in model.breakpoints if model.averaged(b)[0] == model.averaged(b)[1] == 0]
        if plays and (quadratic_only or (model.laws.contact != THROUGHOUT and not model.inertial)):
            return SLIDES_FREE.format(plays[-1], 0.0)
        if quadratic_only and model.inertial:
            return BALANCED
    other = _or_not_known(model)
    if not model.breakpoints:
        return "the onset is unresolved: folds are born within rounding of each other" + other
    message = NEXT_TO.format(model.breakpoints, other)
    # `certify` takes a force and plain damping only, and averages that are derived in closed form
    proved = not model.inertial and not model.laws.any and model.mechanism.enclosed is None
    return message + IN_BALLS if proved else message


CUT = Sentence("unbounded without viscous damping: cut at {A = :g}{why:s}")
LEVELS_OFF = "the spring force levels off and does not hold the mass"
CUT_TOWARDS_REST = Sentence("unbounded as {Omega} tends to 0, where {why:s}: cut at {A = :g}")
CUT_AT_REACH = Sentence("cut at {A = :g}, {why:s}")
EVERYWHERE = Sentence(
    "no response curve: {A = :.17g} at every frequency, as all forces on the mass are proportional to {Omega}^2"
)
PEAK_AT = Sentence("the peak is unresolved at {F_0 = :.17g}: there may be one within rounding of {A = :.17g}")


def cut(model: Model, F_0: float) -> tuple[float, str]:
    """Where the response is cut that has no viscous damping and is unbounded for F_0 > m (27), and a remark."""
    A_max = backend.SOLVER.undamped_cut(model.native, F_0)
    return A_max, CUT.format(A_max, f", {model.mechanism.reach_reason}" if math.isfinite(model.reach) else "")


def no_top(model: Model, F_0: float, most: float) -> Peak:
    """The answer where nothing ends a response up to an amplitude, or up to any.

    A response to inertia tends to an amplitude then; that to a force is of a spring that gives way.
    """
    if not model.inertial or most < math.inf:
        return Peak(None, None, F_0, ESCAPES.format(F_0), _status=Status.UNBOUNDED, _escapes=True)
    if model.laws.any:
        return Peak(None, None, F_0, NO_TOP_BELOW.format(float(dissipation.full_by_inertia(F_0, model.d))))
    return Peak(None, None, F_0, NO_TOP.format(F_0))


def with_folds_at_rest(model: Model, onset: SaddleNodeOnset, rest: float) -> SaddleNodeOnset:
    """The onset, with the remark that there are folds at lower forcings: the locus ends at rest at this level.

    That is at Omega = 0, or with a preload at A = 0, as Omega tends to inf.
    """
    if not rest < (math.inf if onset.F_SN is None else onset.F_SN):
        return onset
    of_preload = rest == model.m and model.preload > 0
    none, below = (NONE_BUT_OF_PRELOAD, OF_PRELOAD) if of_preload else (NONE_BUT_AT_REST, AT_REST)
    message = (none if onset.F_SN is None else below).format(Omega=0.0, F_0=rest, sticking=rest)
    return dataclasses.replace(onset, message=message, remarks=Remark.FOLDS_AT_REST)


NO_STATE = Sentence("no steady state at {Omega = :g}")
UNDECIDED_AT = Sentence("the number of states is undecided at {Omega = :.17g}{more:s}")
EMPTY_WINDOW = Sentence("no steady state for {Omega} in [{Omega:g}]")


def sticks_below(model: Model, F_0: float, Omega: Floats) -> str:
    """That the force of an excitation by inertia does not move the mass at the lower ones of the frequencies."""
    if not model.inertial or not np.any(model.sticks_at(F_0, Omega)):
        return ""
    with np.errstate(over="ignore"):  # beyond any double it is at all
        begin = inertia.moves_from(F_0, model.break_loose)
    if model.preload > 0:
        return STAYS_BELOW.format(begin, model.break_loose)
    return STICKS_BELOW.format(begin, model.m)


def moves_exactly(model: Model, force: Floats) -> str:
    """That by the equation of motion a mass that averaging has at rest under forces of these amplitudes moves."""
    if model.preload > 0 or not np.any((force > model.mu) & (force <= model.break_loose)):
        return ""
    return MOVES_EXACTLY.format(model.mu)


#: what arrays of both frequencies and forcings could be taken for
TONES = text(
    "each pair of {Omega} and {F_0} is a single tone; simultaneous tones are not covered, as their motions do "
    "not superpose"
)


def at_pairs(Omega: Floats, messages: Iterable[str]) -> str:
    """Each message at pairs of frequencies and forcings once, the first `SAID`; and that tones do not act together."""
    distinct = list(dict.fromkeys(message for message in messages if message))
    more = f"and {len(distinct) - MOST_MESSAGES} more remarks" if len(distinct) > MOST_MESSAGES else ""
    return joined(*distinct[:MOST_MESSAGES], more, TONES if np.unique(Omega).size > 1 else "")


def empty_window(model: Model, F_0: float, window: tuple[float, float], cut: str = "") -> str:
    """That a curve has no point in the window, as where friction holds the mass throughout."""
    if model.sticks(F_0):
        return sticks(model, F_0)
    if model.inertial and model.sticks_at(F_0, window[1]):
        return joined(cut, sticks_below(model, F_0, np.array(window[1])))
    return joined(cut, EMPTY_WINDOW.format(window))
