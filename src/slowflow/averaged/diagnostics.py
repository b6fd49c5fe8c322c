"""Diagnostics of averaged answers. Takes the numbers of one oscillator or of many; returns codes and their messages.

A single answer has both, a batch the codes. Both are made here, so that they cannot disagree.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.answers.results import NOTHING, Remark
from slowflow.answers.validity_table import NEAR
from slowflow.averaged import sustained
from slowflow.core.mechanism import Flags, Floats, by_piece
from slowflow.core.model import THROUGHOUT, Model, SlowFlow
from slowflow.support.text import Sentence, text
from slowflow_kernels import slow_flow
from slowflow_kernels.conventions import ENDLESS

Codes = npt.NDArray[np.uint16]

#: how near above a breakpoint, in shares of it, a jump of the force is what makes the slope of h, if over twice that
#: distance the slope changes by this share of itself: as 1/sqrt(A - b) does, the jump's term, by all of itself
NEXT_TO_JUMP, OF_SLOPE = 1e-3, 0.25

NEAR_STICKING_BELOW = text(
    "at low frequencies {mu/(F_0 Omega^2)|the ratio of friction to inertia force} is near pi/4, where averaging fails"
)

MESSAGES: Mapping[Remark, str | Sentence] = {
    Remark.BEYOND_REACH: Sentence("amplitudes above {reach:g} are not reached: {reason:s}"),
    Remark.NEGATIVE_STIFFNESS: text("negative stiffness at rest: {u} = 0 is not a stable equilibrium"),
    Remark.LEAVES_CENTRE: text(
        "motions that leave the centre: the stiffness over their cycle does not restore the mean displacement; "
        "{.off_centre|.oscillator.off_centre} has those with another mean"
    ),
    Remark.HELD_AT_REST: Sentence(
        "a mass at rest stays there, whatever the frequency, up to {F_0} = {held:g}: {holds:s} it"
    ),
    Remark.UNDECIDED: text(
        "close to where folds or states merge, {Omega = :g} or 4 {mu}/pi: their number or position is not resolved", 0.0
    ),
    Remark.BEYOND_WELL: "states beyond the well reach amplitudes at which the spring force points outward: none "
    "is stable, as exact motions do not return from there",
    Remark.UNSUSTAINED: "states next to the top of the well may not exist in the equation of motion: a "
    "free motion of such an amplitude loses more energy per cycle than the excitation supplies; measure() checks it",
    Remark.BY_BALLS: "the number of results, or which is lowest, is resolved in ball arithmetic, as double precision "
    "is inconclusive",
    Remark.MIRRORED: Sentence(
        "{mirrored:s} is not odd: for {u} < 0 the force is that of |{u}| with the opposite sign; odd=False takes it "
        "as written"
    ),
    Remark.OF_TRUNCATION: text("a fold at {u_cr} is due to the discontinuity of the truncated force (6) there"),
}


def is_near_sticking(mu: Any, F_0: Any) -> Any:
    """Whether mu/F_0 is so near pi/4 that averaging fails; numbers, or arrays that broadcast."""
    return mu > NEAR * F_0


def keeps_centre(flow: SlowFlow, Omega: Any, A: Any) -> Flags:
    """Whether a motion about u = 0 of amplitude A > 0 stays about it; shapes that broadcast.

    It does where the mean stiffness over its cycle is positive, or 0 as within a play, where nothing moves it off; and
    else where the stiffness that changes twice in a cycle makes up for it.
    """
    with np.errstate(all="ignore"):  # amplitudes of any size; where the mean is not negative the other is not needed
        h, h_A, *_ = flow.mechanism.averaged(A, *flow.parameters)
        kept = np.asarray(slow_flow.mean_stiffness(A, h, h_A) >= 0)
        if kept.all():
            return kept
        return np.asarray(kept | (slow_flow.offset_stiffness(Omega, A, h, h_A) > 0))


def turns_beyond(flow: SlowFlow, A: Any) -> Flags:
    """Whether a motion about u = 0 of amplitude A > 0 turns beyond the top of a well; shapes that broadcast.

    The spring pushes on there, the more the farther, and pulls back at rest or, as the average does, in between. What
    averaging has there the equation of motion has not, but where averaging errs by so much that the exact motion turns
    within the well (`tests/averaged/test_remarks.py`).
    """
    mechanism, parameters = flow.mechanism, flow.parameters
    if not mechanism.odd:
        return np.zeros(np.shape(A), dtype=bool)
    with np.errstate(all="ignore"):  # amplitudes of any size
        at_rest = mechanism.at_rest(*parameters)
        pulls = ((at_rest[0] <= 0) & (at_rest[1] < 0)) | (mechanism.averaged(A, *parameters)[0] < 0)
        ends = mechanism.breakpoints(*parameters)
        pull, slope = (by_piece(mechanism.pieces, ends, A, parameters, order) for order in (0, 1))
        return np.asarray(pulls & (pull < 0) & (slope < 0))


def gives_way(flow: SlowFlow) -> Flags:
    """Whether states beyond the well there are at any force that moves the mass.

    At rest the spring pulls back, and of the largest motions the average pushes: in between it vanishes, where a force
    is a state's at rest and above.
    """
    mechanism, parameters = flow.mechanism, flow.parameters
    with np.errstate(all="ignore"):
        push, at_rest = (np.asarray(value) for value in mechanism.at_rest(*parameters)[:2])
        far = np.minimum(mechanism.reach_at(*parameters), ENDLESS)
        try:
            pushes = mechanism.averaged(far, *parameters)[0] > 0
        except ArithmeticError:  # its sum does not settle so far out: nothing is known of it
            pushes = np.zeros((), dtype=bool)
        return np.asarray(~(push > 0) & ~(at_rest > 0) & pushes)


def of_one_gives_way(model: Model) -> bool:
    """The same of one oscillator; of an excitation by inertia, no."""
    return not (model.inertial or model.stays_centred) and bool(gives_way(model))


def of_designs(flow: SlowFlow, force: Any, Omega: Any, A: Any, corner: Any) -> Codes:
    """What `Remark` has for states (Omega, A); NaN is no state.

    Omega, A, corner -- of each design, along one more, last axis; corner: of folds, which are on one, None of others
    force            -- on each state, of a shape that broadcasts with Omega; NaN where the question has none
    """
    mechanism, parameters = flow.mechanism, flow.parameters
    A = np.asarray(A, dtype=float)
    there = A > 0
    per_state = flow.each(lambda number: np.asarray(number, dtype=float)[..., np.newaxis])
    kept, beyond = look_at(flow, np.asarray(Omega), A)
    # at rest h_A is the stiffness with its sign turned, and h is 4/pi times a preload
    pull, at_rest = (np.asarray(value) for value in mechanism.at_rest(*parameters)[:2])
    # what is excited by inertia nothing holds at every frequency, see `Model.holds`
    may_hold = ((pull < 0) | (flow.laws.contact != THROUGHOUT)) & (not flow.inertial)
    break_loose = np.where(may_hold, flow.break_loose, -np.inf)
    on_jump = np.zeros(A.shape[:-1], dtype=bool)
    if mechanism.truncated and corner is not None:
        jumps = zip(per_state.breakpoints, mechanism.jumps(*per_state.parameters), strict=True)
        on_jump = (there & (corner | _next_to_jump(per_state, jumps, A))).any(axis=-1)
    codes = {
        Remark.NEAR_STICKING: is_near_sticking(per_state.mu, force).any(axis=-1),
        Remark.BEYOND_REACH: (there & (np.asarray(mechanism.reach_at(*parameters))[..., np.newaxis] < A)).any(axis=-1),
        Remark.NEGATIVE_STIFFNESS: (at_rest > 0) | (pull > 0),
        Remark.LEAVES_CENTRE: (there & ~kept).any(axis=-1),
        Remark.BEYOND_WELL: (there & beyond).any(axis=-1),
        Remark.UNSUSTAINED: _unsustained(flow, Omega, A),
        Remark.OF_TRUNCATION: on_jump,
        Remark.MIRRORED: np.full(A.shape[:-1], bool(mechanism.mirrored)),
        Remark.HELD_AT_REST: (force <= break_loose[..., np.newaxis]).any(axis=-1),
    }
    return np.asarray(sum(int(remark) * holds for remark, holds in codes.items()), dtype=np.uint16)


def of_one(model: Model, F_0: float, Omega: Any, A: Any, corner: Any = None, *, centred: bool = False) -> Remark:
    """The same for one oscillator; A is an array along one axis, or a number, and nothing is computed that is known.

    F_0     -- NaN where the question has none
    centred -- whether those that leave the centre are reported already
    """
    many = isinstance(A, np.ndarray)
    highest = A if not many else A.max() if A.size else math.nan
    codes = []  # few have any, and to add up flags takes longer than to look for them
    if model.mechanism.mirrored:
        codes.append(Remark.MIRRORED)
    if model.negative_stiffness:
        codes.append(Remark.NEGATIVE_STIFFNESS)
    if not math.isnan(F_0):
        if model.holds(F_0):
            codes.append(Remark.HELD_AT_REST)
        near = is_near_sticking(model.mu, model.force(F_0, Omega))
        if near.any() if isinstance(near, np.ndarray) else near:
            codes.append(Remark.NEAR_STICKING)
    if highest > model.reach:
        codes.append(Remark.BEYOND_REACH)
    if highest > 0 and not model.stays_centred:
        if not centred:
            if not keeps_centre(model, Omega, A).all():
                codes.append(Remark.LEAVES_CENTRE)
            if turns_beyond(model, A).any():
                codes.append(Remark.BEYOND_WELL)
        states = np.atleast_1d(Omega, A)
        if (sustained.unsustained(model, *states) & ~turns_beyond(model, states[1])).any():
            codes.append(Remark.UNSUSTAINED)
    if model.mechanism.truncated and corner is not None and highest > 0:
        if (corner.any() if many else corner) or _is_next_to_jump(model, A):
            codes.append(Remark.OF_TRUNCATION)
    return Remark(sum(codes)) if codes else NOTHING


def _is_next_to_jump(model: Model, A: Any) -> bool:
    """Whether any of a few amplitudes is `_next_to_jump`; those are looked for first by what takes less time."""
    few = A.tolist() if isinstance(A, np.ndarray) else (A,)
    for end in model.breakpoints:  # loops take half the time of `any`
        for one in few:
            if 0 < one - end <= NEXT_TO_JUMP * end:
                jumps = zip(model.breakpoints, model.jumps, strict=True)
                return bool(_next_to_jump(model, jumps, A).any())
    return False


def _next_to_jump(flow: SlowFlow, jumps: Iterable[tuple[Any, Any]], A: Any) -> Flags:
    """Which amplitudes lie so near above a jump of the force that it makes the slope of h, which is infinite there.

    jumps -- breakpoints, and what the force loses at them
    """
    found = np.zeros(np.shape(A), dtype=bool)
    for end, jump in jumps:
        beyond = A - end
        near = np.asarray((beyond > 0) & (beyond <= NEXT_TO_JUMP * end) & (jump != 0))
        if near.any():
            _, h_A, h_AA, _ = flow.mechanism.averaged(A, *flow.parameters)
            found |= near & (2 * beyond * np.abs(h_AA) > OF_SLOPE * np.abs(h_A))
    return found


def look_at(flow: SlowFlow, Omega: Any, A: Any) -> tuple[Flags, Flags]:
    """`keeps_centre` and `turns_beyond` of states of each of many designs, along one more axis.

    They are looked at where a design may do otherwise.
    """
    may = np.broadcast_to(~flow.stays_centred, A.shape[:-1])
    kept, beyond = np.ones(A.shape, dtype=bool), np.zeros(A.shape, dtype=bool)
    if may.any():
        own = tuple(np.broadcast_to(value, may.shape)[may][:, np.newaxis] for value in flow.parameters)
        chosen = replace(flow, parameters=own)
        at = np.broadcast_to(Omega, (*may.shape, Omega.shape[-1]))[may]
        kept[may] = keeps_centre(chosen, at, A[may])
        beyond[may] = turns_beyond(chosen, A[may])
    return kept, beyond


def _unsustained(flow: SlowFlow, Omega: Any, A: Floats) -> Flags:
    """Whether any state of each of many designs is `sustained.unsustained`, looked at where one may be."""
    found = np.array((A > 0).any(axis=-1) & ~flow.stays_centred)
    if found.any():
        chosen = flow.each(lambda value: np.broadcast_to(value, found.shape)[found][..., np.newaxis])
        states = sustained.unsustained(chosen, np.broadcast_to(Omega, A.shape)[found], A[found])
        # of those beyond the top of the well another remark tells
        found[found] = (states & ~turns_beyond(chosen, A[found])).any(axis=-1)
    return found


def messages(remarks: Remark, model: Model, F_0: float) -> list[str]:
    """The message of each remark."""
    if not remarks:  # what most answers have, and numbers that the sentences name take time
        return []
    near: list[str] = []
    if Remark.NEAR_STICKING in remarks:
        from slowflow.answers import validity

        near = [NEAR_STICKING_BELOW] if model.inertial else [validity.near_sticking(model, F_0)]
    known = {"reach": model.reach, "reason": model.mechanism.reach_reason, "held": model.break_loose}
    known["mirrored"] = model.mechanism.mirrored
    known["holds"] = "preload and friction hold" if model.preload > 0 else "friction holds"
    texts = (message for remark, message in MESSAGES.items() if remark in remarks)
    return [message.format(**known) if isinstance(message, Sentence) else message for message in texts] + near
