"""Critical forcings: in goes a model, out come detachment, the onset of folds, and the peak at a forcing.

Cusps and isola points are explicit in A (see along), so the onset needs no locus. The last piece of the force, which
has no end, is looked through as far as a state at the best forcing found so far can lie. As in native/onset.h.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from slowflow.averaged import words
from slowflow.averaged.reference import dissipated, dissipated_points
from slowflow.averaged.reference.along import (
    Asked,
    Cusp,
    InertiaIsola,
    InertiaPeak,
    Isola,
    Peak,
    Rest,
    Stiffness,
    Undamped,
)
from slowflow.averaged.reference.bounds import amplitude_bound, least_forcing
from slowflow.averaged.reference.boxes import points_of
from slowflow.averaged.reference.cells import Samples, Stretch, sample_above, samples_at, stretches_up_to
from slowflow.averaged.reference.excited import stationary_at
from slowflow.averaged.reference.folds import saddle_nodes
from slowflow.averaged.reference.locus import of_cusps, of_isolas
from slowflow.averaged.reference.minima import cusp_is_minimum, isola_is_minimum
from slowflow.averaged.reference.roots import Ints, fold_roots, peak_roots, taken
from slowflow.averaged.reference.search import GIVEN_UP, find_zeros, find_zeros_abreast
from slowflow.intervals import Bools
from slowflow.model import THROUGHOUT, Floats, Model
from slowflow.results import Detachment, SaddleNodeOnset
from slowflow.results import Peak as PeakFound
from slowflow_kernels import dissipation, slow_flow, slow_flow_zeta0
from slowflow_kernels.conventions import (
    CLOSE,
    COINCIDE,
    ENDLESS,
    FALL,
    FALLS,
    FAR_OUT,
    FAR_RAISE,
    FAR_RAISES,
    FIRST_F_0,
    NEAR_BOUND,
    RAISE,
    RAISES,
    TENDS,
    Status,
)
from slowflow_support.errors import NotSettled, OutOfRange

#: of a force's size: what rounding its parameters may make of its jump
OF_ROUNDING = 2.0**-48
#: to either side of a frequency at which folds on a breakpoint may begin
NEAR = 2.0**-30
#: amplitudes that stand for endless ones
BEYOND = np.array([FAR_OUT, ENDLESS])


@dataclasses.dataclass
class _Best:
    """The lowest level so far, where it lies and what it is; rest: the lowest at which the locus ends at rest.

    undecided -- whether there may be one whose amplitude no double tells from others
    open      -- whether the response does not close at the last level that was looked at
    """

    F_SN: float = math.inf
    Omega: float = math.nan
    A: float = math.nan
    kind: str = ""
    rest: float = math.inf
    undecided: bool = False
    open: bool = False

    def consider(self, level: Floats, Omega: Floats, A: Floats, kind: str) -> None:
        """Points where the level may be least."""
        level = np.where(level < self.F_SN, level, math.inf)
        if np.isfinite(level).any():
            least = int(np.argmin(level))
            self.F_SN, self.Omega, self.A, self.kind = float(level[least]), float(Omega[least]), float(A[least]), kind

    def consider_ends(self, model: Model, A: Floats, level: Floats) -> None:
        """Ends of the fold locus at Omega = 0, from where the level rises along it.

        It does not where there is no friction and F_Omega falls below 0: then there are folds at every higher forcing,
        down to this one and without it.
        """
        if model.laws.any:
            counts = dissipated_points.rises_from_rest(model, A)
        else:
            counts = (model.m > 0) | (slow_flow.F_OmegaOmega(0.0, A, model.zeta, model.averaged(A)[0]) >= 0)
        self.rest = float(np.min(np.where(counts, level, math.inf), initial=self.rest))


@np.errstate(all="ignore")
def onset(model: Model) -> SaddleNodeOnset:
    """The lowest forcing that has a fold, in whatever regime it lies."""
    if model.zeta == 0 and not model.laws.any:
        return _onset_without_viscous_damping(model)
    come_down, base = next_to_rest(model)
    # of a preload they have R next to 0 and A Omega^2 next to it, as Omega tends to inf
    if come_down or (model.inertial and model.preload > 0):
        message = words.OPEN if model.inertial else words.STIFF_AT_REST.format(model.m)
        return SaddleNodeOnset(None, None, None, "", message, _status=Status.UNBOUNDED)
    if _comes_down_to_play(model) or _comes_down_to_rest(model):
        return SaddleNodeOnset(None, None, None, "", words.NO_LOWEST.format(model.m), _status=Status.UNBOUNDED)
    best = _lowest(model, base)
    if _hardly_jumps(model) or (best.undecided and _is_beside_breakpoint(model, best)):
        raise NotSettled(words.unresolved_onset(model))
    if best.open or (model.inertial and _falls_at_breakpoint(model, best)):
        return SaddleNodeOnset(None, None, None, "", words.OPEN, _status=Status.UNBOUNDED)
    if not best.kind:
        found = SaddleNodeOnset(None, None, None, "", words.NO_ONSET)
    else:
        found = SaddleNodeOnset(best.F_SN, best.Omega, best.A, best.kind, "")
    return words.with_folds_at_rest(model, found, best.rest)


def next_to_rest(model: Model) -> tuple[bool, float]:
    """Whether there are folds at ever smaller amplitudes, and else an amplitude below which there are none.

    As under a power of u below 1, which is infinitely stiff at u = 0; of any other force 0. R R_A is least,
    -k^2/(4 A), between the Omega at which R and R_A vanish. Where that outweighs I I_A ever more there is a fold at
    each A, with |R| < |k|, which tends to 0: the level tends to that of friction. Where it outweighs it ever less there
    is none.
    """
    if model.laws.any or model.preload > 0 or not np.isinf(samples_at(model, 0.0).h_A[0]):
        return False, 0.0
    at = samples_at(model, FALL ** np.arange(1.0, FALLS + 1))
    X = np.abs(at.h) / at.A, np.abs(at.h_A)

    def share(X: Floats) -> Floats:
        damping = 2 * model.zeta * np.sqrt(X)
        return at.k**2 / (4 * at.A) / (damping * (model.m + damping * at.A))

    of_folds, of_none = share(np.maximum(*X)), share(np.minimum(*X))
    if (of_folds > 1).all() and (np.diff(of_folds) > 0).all():
        return True, 0.0
    known = (of_none < 1) & np.append(np.diff(of_none) < 0, True)
    known = np.logical_and.accumulate(known[::-1])[::-1]
    return False, float(at.A[np.argmax(known)]) if known.any() else 0.0


def _ends_play(first: Samples) -> bool:
    """Whether a spring that only pulls begins there, smoothly, where none was."""
    return bool(first.A[0] > 0 and first.h[0] == first.h_A[0] == 0 and first.h_AA[0] < 0)


def _comes_down_to_play(model: Model) -> bool:
    """Whether there are folds at any forcing, next to where a play ends: by a force, with quadratic damping alone.

    |h_A| exceeds |h|/A there, so that R R_A = -a A Omega^4 where Omega^2 = |h_A|/(1 + a) and h is left out; I I_A is
    2 d^2 A^3 Omega^4. For a small Omega they do outweigh each other either way as a changes: F_A vanishes between, at a
    level that is of the size of Omega^2.
    """
    if model.inertial or not model.d > 0 or model.zeta + model.m + model.laws.eta > 0:
        return False
    return any(_ends_play(sample_above(model, i)) for i in range(len(model.breakpoints)))


def _comes_down_to_rest(model: Model) -> bool:
    """The same where no stiffness holds the mass at rest, by any excitation.

    Next to A = 0 either h_AA < 0, or |h_A| is convex: |h|/(A |h_A|) is at most a half, or tends to it. So R R_A is
    -a (1 - (1 + a)/2) A Omega^4 or less where Omega^2 = |h_A|/(1 + a), and beside it I I_A vanishes with A^2. The level
    is less than (A + d A^2) Omega^2.
    """
    if not model.d > 0 or model.zeta + model.m + model.laws.eta > 0 or model.mechanism.enclosed is not None:
        return False
    piece = stretches_up_to(model, 1.0)[0]
    first = piece.first
    return bool(first.h[0] == first.h_A[0] == 0 and np.isfinite(first.h_AA[0]) and _moves_from(piece, 0.0))


def _hardly_jumps(model: Model) -> bool:
    """Whether the force jumps by no more than rounding its parameters makes of it: then the jump's sign is not known.

    The compiled solvers know it from the design.
    """
    if model.native is not None or not model.mechanism.truncated:
        return False
    b, jump = np.array(model.breakpoints), np.array(model.jumps)
    return bool((np.abs(jump) <= OF_ROUNDING * b * (1 + np.abs(model.averaged(b)[1]))).any())


def _falls_at_breakpoint(model: Model, best: _Best) -> bool:
    """Whether folds of an excitation by inertia on a breakpoint come lower than the best as Omega tends to inf.

    There F_A and R are positive, so that folds sit on it where the force jumps by J < 0; and where the level of that
    amplitude only falls, it falls to the amplitude.
    """
    ends = zip(model.breakpoints, model.jumps, strict=True)
    return any(jump < 0 and b < best.F_SN and not stationary_at(model, b).size for b, jump in ends)


def _is_beside_breakpoint(model: Model, best: _Best) -> bool:
    """Whether there is no onset, or one so near to a breakpoint that few doubles lie between."""
    near = (abs(best.A - b) <= COINCIDE * b for b in model.breakpoints)
    return not best.kind or (best.kind != "corner" and any(near))


def _onset_without_viscous_damping(model: Model) -> SaddleNodeOnset:
    """zeta = 0: folds lie at Omega^2 = -h_A and their level is that of R = k.

    Where k tends to 0 on the way, as to A = 0 with a stiffness that is not negative next to it, or as A grows where
    springs have left, there are folds as near to m as one asks. Raises ArithmeticError where the level falls to another
    limit.
    """
    none = SaddleNodeOnset(None, None, None, "", words.NO_ONSET)
    no_lowest = dataclasses.replace(none, message=words.NO_LOWEST.format(model.m), _status=Status.UNBOUNDED)
    if model.preload > 0:
        # R = k at a fold, and k = -preload at rest: it passes 0 between folds of both signs
        A = saddle_nodes(model, float(slow_flow_zeta0.undamped_level(model.m, 0.5 * model.preload))).A
        h, h_A, h_AA, _ = model.averaged(A)
        if len(np.unique(slow_flow.intercept(A, h, h_A, h_AA)[0] < 0)) > 1:
            return no_lowest
        raise NotSettled(words.unresolved_onset(model))
    if model.inertial:
        return no_lowest if saddle_nodes(model, 2 * model.m + 1.0).A.size else none
    best, at = _Best(), samples_at(model, 0.0)
    first = at
    for i, b in enumerate((*model.breakpoints, ENDLESS)):
        last = samples_at(model, b)
        if any(one[0] != 0 for end in (first, last) for one in (end.h_AA, end.h_AAA)):
            piece = Stretch(first, last, first.A)
            from_0 = at.k[0] == 0 and _moves_from(piece, at.h_A[0]) and not (i > 0 and model.jumps[i - 1] != 0)
            if from_0 or _tends_to_friction(model, piece, best):
                return no_lowest
        if i < len(model.breakpoints):
            at, first = last, sample_above(model, i)
            if _tends_to_friction_on(model, at, first, model.jumps[i], best):
                return no_lowest
    beyond = samples_at(model, BEYOND)
    near, far = np.abs(beyond.k)
    if beyond.h_A[1] < 0 and far < near:
        if far < TENDS * near:
            return no_lowest
        raise NotSettled(words.unresolved_onset(model))
    found = SaddleNodeOnset(best.F_SN, best.Omega, best.A, best.kind, "") if best.kind else none
    return words.with_folds_at_rest(model, found, best.rest)


def _moves_from(piece: Stretch, h_A: float) -> bool:
    """Whether there are folds on a piece from its first amplitude on: h_A < 0 next to it, h_AAA being monotone."""
    bends = (*piece.first.h_AA, *piece.first.h_AAA, *piece.last.h_AAA)
    return bool(h_A < 0 or (h_A == 0 and next((bend for bend in bends if bend != 0), 0.0) < 0))


def _of_undamped(model: Model) -> list[Asked]:
    return [Stiffness(model), Undamped(model)]


def _tends_to_friction(model: Model, piece: Stretch, best: _Best) -> bool:
    """Whether k vanishes inside of a piece; if not, the least levels there."""
    ends, turns = find_zeros(model, _of_undamped(model), [piece])
    if (turns.channel == 1).any():
        return True
    at = samples_at(model, turns.A)
    least = slow_flow_zeta0.undamped_rises(at.h_AA, at.h_AAA, at.k)[1] > 0
    best.consider(slow_flow_zeta0.undamped_level(model.m, at.k)[least], turns.Omega[least], turns.A[least], "cusp")
    best.rest = float(np.min(model.level(0.0, ends.A[ends.channel == 1]), initial=best.rest))
    return False


def _tends_to_friction_on(model: Model, at: Samples, above: Samples, jump: float, best: _Best) -> bool:
    """The same on a breakpoint. Where the force jumps by J folds sit on it at Omega^2 > -h_A, if J < 0, or below."""
    (h,), (h_A,), (k,) = at.h, at.h_A, at.k
    moves = h_A < 0
    below, beyond = (slow_flow_zeta0.undamped_rises(side.h_AA, side.h_AAA, at.k)[0][0] for side in (at, above))
    turns, ends = moves and below < 0, False
    if jump == 0:
        turns = turns and beyond > 0
    elif jump < 0:
        if (k if moves else h) <= 0:
            return True
        ends = not moves
    else:
        if moves and h <= 0 <= k:
            return True
        turns, ends = turns and k < 0, moves and h > 0
    if turns:
        best.consider(
            slow_flow_zeta0.undamped_level(model.m, at.k), slow_flow_zeta0.undamped_Omega(at.h_A), at.A, "corner"
        )
    if ends:
        best.rest = min(best.rest, float(model.level(0.0, at.A)[0]))
    return False


def _lowest(model: Model, base: float) -> _Best:
    """Of all pieces and breakpoints, from an amplitude on; first what leaves less to search."""
    best, first = _Best(), samples_at(model, base)
    if (
        model.preload > 0
    ):  # R, -preload next to A = 0, vanishes at frequencies that tend to inf there, and F_0 tends to m
        best.rest = model.m
    bounded = []
    for i, (b, jump) in enumerate(zip(model.breakpoints, model.jumps, strict=True)):
        at, above = samples_at(model, b), sample_above(model, i)
        if model.laws.any:
            _consider_corner(model, i, best)
        else:
            _consider_breakpoint(model, at, jump, float(above.h_AA[0]), best)
        # where there is no force, as in a dead zone, there is no fold
        stretch = Stretch(first, at, first.A)
        if stretch.has_force:
            bounded.append(stretch)
        first = above
    if bounded:
        _consider_pieces(model, bounded, best)
    _consider_last(model, first, best)
    return best


def _of_force(model: Model, F_SN: Any) -> list[Asked]:
    return [Stiffness(model), Isola(model), Cusp(model, F_SN)]


def _of_inertia(model: Model) -> list[Asked]:
    return [InertiaIsola(model), Cusp(model)]


def _consider_pieces(model: Model, pieces: list[Stretch], best: _Best) -> None:
    """Where the level may be least inside of pieces: cusps, isola points, ends."""
    if model.laws.any:
        _consider_boxes(model, pieces, best)
        return
    if model.inertial:  # at Omega = 0 the level is infinite
        isolas, cusps = find_zeros(model, _of_inertia(model), pieces)
    else:
        ends, isolas, cusps = find_zeros(model, _of_force(model, best.F_SN), pieces)
        best.undecided |= bool(ends.undecided.any())
        turns = ends.A[ends.channel == 1]
        if turns.size:
            best.consider_ends(model, turns, model.level(0.0, turns))
        if (ends.channel == 0).any():  # h = 0 there, and so R: F_Omega does not fall
            best.rest = min(best.rest, model.m)
    best.undecided |= bool(isolas.undecided.any() or cusps.undecided.any())
    if len(isolas):
        least = isola_is_minimum(model, isolas.Omega, isolas.A)
        level = of_isolas(model, isolas.Omega, isolas.A)
        best.consider(level[least], isolas.Omega[least], isolas.A[least], "isola")
    if len(cusps):
        least = cusp_is_minimum(model, cusps.Omega, cusps.A)
        best.consider(of_cusps(model, cusps)[least], cusps.Omega[least], cusps.A[least], "cusp")


def _consider_boxes(model: Model, pieces: list[Stretch], best: _Best) -> None:
    """The same by other laws of damping; a least level that is none is no lower than the one of its curve.

    Only what lies below the best so far is looked for: next to u_cr, where friction ends and I falls, F_A and F_AA are
    nearly proportional on boxes that reach down to it, and far above the cusps isola points may be too badly
    conditioned for boxes.
    """
    pieces = [_beyond_play(model, piece) for piece in pieces]
    if not model.inertial:  # at Omega = 0 the level is infinite
        ends = points_of(model, "stiffness", pieces)
        best.undecided |= ends.undecided
        h, h_A = (np.asarray(value) for value in model.averaged(ends.A)[:2])
        balanced = np.abs(h) < np.abs(
            ends.A * h_A
        )  # of the two that end the locus h vanishes, and so R: I is what is left
        best.consider_ends(model, ends.A[~balanced], model.level(0.0, ends.A[~balanced]))
        best.rest = float(np.min(model.at_rest(ends.A[balanced])[0], initial=best.rest))

    def consider(system: str, kind: str) -> None:
        points = points_of(model, system, pieces, most=best.F_SN)
        best.undecided |= points.undecided
        best.consider(model.level(points.Omega, points.A), points.Omega, points.A, kind)

    isolas = dissipated_points.isolas_of(model)
    try:
        consider(isolas, "isola")
    except ArithmeticError:  # fewer levels are asked for once the cusps are known
        consider("cusps", "cusp")
        consider(isolas, "isola")
    else:
        consider("cusps", "cusp")


def _beyond_play(model: Model, piece: Stretch) -> Stretch:
    """A piece without what lies next to the end of a play, where F_A is positive at any frequency.

    There both functions of a system vanish together at Omega = 0, and boxes would be cut for ever. F_A/2 is
    R R_A >= -Omega^2 max(A |h_A|, |h|) and I I_A, of which one part goes as Omega^2, too, and the others are positive.
    Raises ArithmeticError where that part is 0, or what it outweighs lies between two doubles, and where the level does
    not change with Omega.
    """
    first = piece.first
    if model.d == 0 or model.laws.eta > 0 or (model.inertial and model.zeta + model.m > 0):
        return piece
    if model.inertial and (first.h[0] > 0 or (piece.base == 0 and first.h_A[0] > 0)):
        raise NotSettled(words.BALANCED)
    if not (piece.base > 0 and first.h[0] == 0 and first.h_A[0] == 0):
        return piece
    base = float(piece.base[0])
    least = dissipation.fold_quartic(base, model.m, 0.0, model.zeta, model.d, 0.0, 0.0)[2]
    if not (least > 0 and _ends_play(first) and model.laws.rubs == THROUGHOUT):
        raise NotSettled(words.SLIDES_FREE.format(base, 0.0))
    A = base + (piece.last.A[0] - base) * FALL ** np.arange(FALLS)
    at = samples_at(model, A)
    # h_AAA is monotone, of one sign at both ends: h_AA is negative between as there, and h_A and h fall from 0
    falls = (at.h_AA < 0) & (np.sign(at.h_AAA) == np.sign(first.h_AAA))
    known = falls & (np.maximum(A * -at.h_A, -at.h) <= least / 2)
    if not known.any():
        raise NotSettled(words.unresolved_onset(model))
    return Stretch(samples_at(model, float(A[np.argmax(known)])), piece.last, piece.base)


def _consider_corner(model: Model, i: int, best: _Best) -> None:
    """The least forcing on breakpoint i by other laws of damping: the level of the points that bound its folds."""
    b = model.breakpoints[i]
    if model.jumps[i] == 0 and not (i == 0 and model.laws.rubs != THROUGHOUT):
        return
    Omega = dissipated.corner_frequencies(model, i)
    signs = [np.sign(dissipated.is_stable_above(model, i, Omega * w) * 2.0 - 1.0) for w in (1 - NEAR, 1 + NEAR)]
    below = [np.sign(model.F_A(Omega * w, b)) for w in (1 - NEAR, 1 + NEAR)]
    beside = np.any([one != other for one, other in zip(signs, below, strict=True)], axis=0)
    Omega = Omega[beside]
    best.consider(model.level(Omega, np.full_like(Omega, b)), Omega, np.full_like(Omega, b), "corner")


def _consider_breakpoint(model: Model, at: Samples, jump: float, h_AA_above: float, best: _Best) -> None:
    """The least forcing on a breakpoint.

    Where the force jumps by J folds sit on the breakpoint where F_A has there the other sign than R J, which it has
    next to it: from where the locus below ends, and, for J < 0, from R = 0 on, where the locus above comes in; both
    lead to a higher Omega and level. Between, the level may be stationary. Where only the slope jumps the locus goes
    on, but its level may turn, as F_AA above is infinite.
    """
    m, zeta = model.m, model.zeta
    (b,), (h,), (h_A,), (h_AA,) = at.A, at.h, at.h_A, at.h_AA
    sign = jump if jump != 0 else math.copysign(1.0, h_AA_above)

    def consider(Omega: Floats, level: Floats | None = None) -> None:
        A = np.full_like(Omega, b)
        best.consider(model.level(Omega, A) if level is None else level, Omega, A, "corner")

    if h < 0 and jump < 0:
        Omega = np.array([slow_flow.backbone(b, h)])
        # R is 0 there, and its rounding may exceed a weak damping's I
        consider(Omega, None if model.inertial else model.sine(Omega, np.array([b])))
    roots, count = fold_roots(at.A, at.h, at.h_A, m, zeta)
    w = roots[0, : count[0]]
    if model.inertial:  # all that may bound the level of folds on the breakpoint: none of it is lower than they are
        consider(w)
        if jump != 0:
            w = stationary_at(model, b)
            consider(w[slow_flow.F_A(w, b, m, zeta, h, h_A) * slow_flow.R(w, b, h) * jump < 0])
        return
    turns = slow_flow.F_Omega(w, b, m, zeta, h) * slow_flow.F_AOmega(w, b, m, zeta, h, h_A)
    falls = slow_flow.level_rise(w, b, m, zeta, h, h_A, h_AA) < 0
    consider(w[falls & (turns * slow_flow.R(w, b, h) * sign < 0)])
    if jump == 0:
        return
    roots, count = peak_roots(at.A, at.h, m, zeta)
    w = roots[0, : count[0]]
    inside = slow_flow.F_A(w, b, m, zeta, h, h_A) * slow_flow.R(w, b, h) * jump < 0
    consider(w[inside & (slow_flow.F_OmegaOmega(w, b, zeta, h) > 0)])
    if h_A * jump < 0:
        best.consider_ends(model, at.A, slow_flow.level(0.0, at.A, m, zeta, at.h))


def _consider_last(model: Model, first: Samples, best: _Best) -> None:
    """The piece without an end.

    It is looked through as far as a state at the best forcing can lie, or at forcings raised until there is one; where
    the force levels off, up to the forcing beyond which no amplitude bounds the response.
    """
    base, looked_through, unbounded = first.A, model.m, math.inf
    F_0 = best.F_SN if best.kind else RAISE * max(model.m, FIRST_F_0)
    for number in range(RAISES + FAR_RAISES):
        try:
            A_max, cut = amplitude_bound(model, F_0)
            if cut and not model.inertial and model.levels_off:
                raise OutOfRange(words.unbounded(model, None))
        except OverflowError:
            if number >= RAISES or F_0 - looked_through <= NEAR_BOUND * looked_through:
                raise
            unbounded, F_0 = F_0, 0.5 * (looked_through + F_0)
            continue
        if A_max > first.A[0]:  # what lies below has been looked through
            last = samples_at(model, A_max)
            if first.A[0] == first.h[0] == 0 and last.h_AA[0] == last.h_AAA[0] == first.h_AAA[0] == 0:
                return  # linear
            _consider_pieces(model, [Stretch(first, last, base)], best)
            first = last
        if cut:  # where the response does not close folds of any amplitude may be lower
            best.open = not best.kind or bool(amplitude_bound(model, best.F_SN)[1])
            return
        if best.F_SN <= F_0:
            return
        looked_through = F_0
        if number >= RAISES - 1 and not best.kind:
            if A_max >= model.reach or _has_settled(first, samples_at(model, ENDLESS * first.A[0])):
                return
        F_0 = best.F_SN if best.kind else (RAISE if number < RAISES else FAR_RAISE) * F_0
        if F_0 >= unbounded:
            F_0 = 0.5 * (looked_through + unbounded)
    if math.isfinite(unbounded):
        raise OutOfRange(words.unbounded(model, None))
    raise NotSettled(words.unresolved_onset(model))


def _has_settled(at: Samples, far: Samples) -> bool:
    """Whether the force is as it is far away; not where it is still nearly its slope at rest, and bends farther on."""
    (h, k), (far_h, far_k) = (np.abs((one.h[0], one.k[0])) for one in (at, far))
    return not far_k * h > 2 * k * far_h


def detachment(model: Model) -> Detachment:
    """The lowest forcing for which the first breakpoint is a steady state (34)."""
    if not model.breakpoints:
        return Detachment(None, None, None, words.NO_DETACHMENT)
    if model.inertial and not model.laws.any:
        u_cr = model.breakpoints[0]
        falls = stationary_at(model, u_cr)
        if not falls.size:
            return Detachment(None, None, None, words.NOT_REACHED.format(u_cr, u_cr))
        return Detachment(float(model.level(falls[0], u_cr)), float(falls[0]), u_cr, "")
    if model.laws.any:
        u_cr = model.breakpoints[0]
        at = stationary_at(model, u_cr) if model.inertial else np.append(stationary_at(model, u_cr), 0.0)
        levels, full = model.level(at, np.full(at.size, u_cr)), model.full_level(u_cr)
        if model.inertial and not (levels < full).any():
            return Detachment(None, None, None, words.NOT_REACHED.format(u_cr, full))
        least = int(np.argmin(levels))
        return Detachment(float(levels[least]), float(at[least]), u_cr, "")
    level, Omega = least_forcing(model, np.array([model.breakpoints[0]]))
    if not level[0] < np.inf:
        raise OutOfRange(words.BEYOND_RANGE.format(model.breakpoints[0]))
    return Detachment(float(level[0]), float(Omega[0]), model.breakpoints[0], "")


def peak(model: Model, F_0: float, most: float = math.inf) -> PeakFound:
    """The highest peak at F_0 > m up to `most`, isolas included: where stable motions end, see `_is_top_at_rest`.

    Where A only falls with Omega it is the static amplitude at Omega = 0.
    """
    if model.zeta == 0 and not model.laws.any:
        return PeakFound(None, None, F_0, words.NO_PEAK, _status=Status.UNBOUNDED)
    A_max, cut = amplitude_bound(model, F_0)
    if cut:
        return PeakFound(None, None, F_0, cut, _status=Status.UNBOUNDED)
    A_max = min(A_max, most)
    if model.laws.any:
        return _peak_in_boxes(model, F_0, A_max, most)
    if model.inertial:
        (peaks,) = find_zeros(model, [InertiaPeak(model, F_0)], stretches_up_to(model, A_max))
        tops = peaks.take(peaks.rising)
        if not len(tops):
            return words.no_top(model, F_0, most)
        return PeakFound(float(tops.A[-1]), float(tops.Omega[-1]), F_0, "")
    A, Omega, given_up = peaks_abreast(model, F_0, A_max)
    if given_up.any():
        raise NotSettled(GIVEN_UP)
    if np.isnan(A[0]):
        return words.no_top(model, F_0, most)
    return PeakFound(float(A[0]), float(Omega[0]), F_0, "")


@np.errstate(all="ignore")
def peaks_abreast(model: Model, F_0: Any, A_max: Any) -> tuple[Floats, Floats, Bools]:
    """A and Omega of the highest peak of each of designs abreast, by a force, with viscous damping; and see `Folds`.

    NaN where nothing ends the response.
    """
    asked = [Peak(model, F_0), Rest(model, F_0)]
    (peaks, static), given_up = find_zeros_abreast(model, asked, stretches_up_to(model, A_max))
    # the second channel is the minimum of F over Omega: stable motions end where it rises with A
    tops = peaks.take(peaks.rising & (peaks.channel == 1))
    h_0, h_A0 = (value[static.of] for value in _at_rest_abreast(model))
    # the second half has h = -c: there the spring pulls
    static = static.take(np.where(static.channel == 1, ~static.rising, _pushes(h_0, h_A0) & static.rising))
    A, Omega = np.full((2, model.abreast), np.nan)
    last = _last_of_each(static.of)
    A[static.of[last]], Omega[static.of[last]] = static.A[last], 0.0
    goes_on = np.isfinite(A)
    goes_on[goes_on] = _goes_on_above_rest(model, F_0, A, np.flatnonzero(goes_on))
    A[goes_on] = Omega[goes_on] = np.nan
    last = _last_of_each(tops.of)
    A[tops.of[last]], Omega[tops.of[last]] = tops.A[last], tops.Omega[last]
    return A, Omega, given_up


def _last_of_each(of: Ints) -> Ints:
    """The places of the highest of each design, of what is in order."""
    return np.flatnonzero(np.append(of[1:] != of[:-1], True)[: len(of)])


def _pushes(h: Any, h_A: Any) -> Any:
    """Whether the spring pushes off at rest, by the averages there."""
    return (h > 0) | ((h == 0) & ~(h_A < 0))


def _at_rest_abreast(model: Model) -> tuple[Floats, Floats]:
    """h and h_A at rest, of each of designs abreast."""
    of = np.arange(model.abreast)
    h, h_A, *_ = model.take(of).averaged(np.zeros(of.size))
    return h, h_A


def _goes_on_above_rest(model: Model, F_0: Any, A: Floats, of: Ints) -> Bools:
    """Whether some frequency has a lower level than rest has, of some of designs abreast: a static state is no top."""
    own, A = model.take(of), A[of]
    h, m, forcing = own.averaged(A)[0], own.m, taken(F_0, of)
    w = peak_roots(A, h, m, own.zeta)[0]
    w = np.where(np.isnan(w), 0.0, w).max(axis=-1)
    R, lag = slow_flow.R(w, A, h), slow_flow.I(w, A, m, own.zeta)
    of_R = CLOSE * (np.abs(h) + A * w**2)
    doubt = of_R * (2 * np.abs(R) + of_R) + CLOSE * (lag**2 + np.square(forcing))
    return np.asarray((w > 0) & (slow_flow.F(w, A, forcing, m, own.zeta, h) < -doubt))


def _peak_in_boxes(model: Model, F_0: float, A_max: float, most: float) -> PeakFound:
    """The same by other laws of damping: where a pair of frequencies ends that is there below."""
    pieces = stretches_up_to(model, A_max)
    if model.inertial:
        peaks = points_of(model, "peaks_by_inertia", pieces, F_0)
        tops = peaks.take(dissipated_points.is_top(model, peaks, F_0))
        if not len(tops):
            return words.no_top(model, F_0, most)
        return PeakFound(float(tops.A[-1]), float(tops.Omega[-1]), F_0, "")
    peaks, static = dissipated_points.peaks_of(model, pieces, F_0), points_of(model, "rest", pieces, F_0)
    tops = peaks.take(dissipated_points.is_top(model, peaks, F_0))
    at_rest = static.A[[_is_top_at_rest(model, F_0, float(A)) for A in static.A]] if len(static) else static.A
    A, Omega = (tops.A, tops.Omega) if len(tops) else (at_rest, np.zeros(at_rest.size))
    if peaks.A_undecided.max(initial=0.0) > A.max(initial=0.0):
        raise NotSettled(words.peak_at_doubles(F_0, float(peaks.A_undecided.max())))
    if not A.size and F_0 <= model.m and most == math.inf:
        return PeakFound(None, None, F_0, words.sticks(model, F_0), _status=Status.STICKS)
    if not A.size:
        return words.no_top(model, F_0, most)
    highest = int(np.argmax(A))
    return PeakFound(float(A[highest]), float(Omega[highest]), F_0, "")


@np.errstate(all="ignore")
def _is_top_at_rest(model: Model, F_0: float, A: float) -> bool:
    """Whether stable motions end in a static state: the spring pulls there, F rises, and no frequency goes on above."""
    h = float(model.averaged(A)[0])
    if not model.F_A(0.0, A) > 0 or (h > 0 and not _pushes(*map(float, model.averaged(0.0)[:2]))):
        return False
    w = stationary_at(model, A)
    return not bool((model.level(w, np.full(w.size, A)) < F_0 * (1 - CLOSE)).any())
