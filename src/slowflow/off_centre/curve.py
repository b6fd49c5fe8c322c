"""The response curve off the centre. Takes all states at any frequency and all folds; returns the curves of these.

Between the frequencies of folds no state arises or ends: as many arcs as there are states lead from one to the next.
States are on one arc where their tangents lead from both to one place, and to no other one's; where that is not
plain, states at a frequency between are asked for. Past a fold what is not on the other side meets in it. So no arc is
lost, whatever the sheets of the balance do, and isolated curves, which have folds, are found with the others.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import chain, islice, pairwise
from typing import Any, NamedTuple

import numpy as np

from slowflow.core.mechanism import Flags, Ints
from slowflow.core.model import Floats
from slowflow.off_centre.flow import Slow
from slowflow.support.errors import NotSettled
from slowflow.support.text import Sentence

#: frequencies of a cell that are asked for at first, and how often a stretch is cut where its arcs are not told apart
FIRST, CUTS = 6, 12
#: how often points of a curve that are not near enough to their neighbours are asked again
PASSES = 24
#: points of a curve beyond those that there are to be, from which on it is thinned
MORE = 24
#: Newton's steps at most, and how short, beside A, one is after which there is no other
NEWTON, SETTLED = 8, 2.0**-50
#: folds nearer to one another than this, relatively, are taken for one frequency, as those of mirrored motions are
TOGETHER = 1e-12
#: folds of one curve so near, in Omega, A and B beside its amplitude, are a kink: a force that jumps by little turns it
#: there and back, and no frequency between them is asked for, as doubles may not tell the states apart there
KINK = 1e-7
#: what nearer by far is, and what near is beside the largest amplitude
BY_FAR, NEAR = 0.1, 0.02
#: how much nearer to a fold what meets in it is than what does not
MEET = 0.5

UNRESOLVED = Sentence(
    "the response is unresolved between {Omega} = {Omega[0]:.6g} and {Omega[1]:.6g}: which states are on one curve is "
    "undecided"
)


class Node(NamedTuple):
    """A state, by number, at a frequency, by number; a fold has the frequency -1."""

    at: int
    state: int


@dataclass(frozen=True, eq=False)
class Curves:
    """Points in order along each curve.

    Omega, A, B -- arrays of one length
    branch      -- number of the curve of each point; open curves first
    closed      -- of each curve whether it is closed
    """

    Omega: Floats
    A: Floats
    B: Floats
    branch: Ints
    closed: tuple[bool, ...]

    @classmethod
    def none(cls) -> Curves:
        """No curve at all."""
        none = np.empty(0)
        return cls(none, none, none, np.empty(0, dtype=np.intp), ())

    def behind(self, first: Curves) -> Curves:
        """Those given first and then these; the closed ones last."""
        names = ("Omega", "A", "B")
        Omega, A, B = (np.concatenate((getattr(first, name), getattr(self, name))) for name in names)
        closed = np.array((*first.closed, *self.closed), dtype=bool)
        branch = np.concatenate((first.branch, len(first.closed) + self.branch))
        order = np.argsort(closed, kind="stable")
        number = np.argsort(order, kind="stable")[branch] if closed.size else branch
        by_branch = np.argsort(number, kind="stable")
        return Curves(Omega[by_branch], A[by_branch], B[by_branch], number[by_branch], tuple(closed[order].tolist()))


def curves(
    of: Slow, folds: Floats, states: Callable[[Floats], tuple[Floats, Ints]], window: tuple[float, float], points: int
) -> Curves:
    """All curves in a window of frequencies.

    folds  -- Omega, A, B of every fold, shape (3, k)
    states -- every state at some frequencies: A and B, and the number of its frequency
    points -- about how many there are to be

    Raises ArithmeticError where it is not decided which states are on one curve.
    """
    low, high = window
    inside = folds[:, (folds[0] > low) & (folds[0] < high)]
    skeleton = _Skeleton(of, inside, states)
    skeleton.build(low, high)
    tours = [*skeleton.tours()]
    tours.sort(key=lambda tour: tour[1])
    return _points(of, skeleton, tours, points)


@dataclass
class _Part:
    """Two frequencies, by number, and the folds between them, by number."""

    a: int
    b: int
    folds: tuple[int, ...]
    cuts: int = 0


class _Skeleton:
    """States at some frequencies, and which of them follow one another on a curve."""

    def __init__(self, of: Slow, folds: Floats, states: Callable[[Floats], tuple[Floats, Ints]]) -> None:
        self.of, self.folds, self._states = of, folds, states
        self.Omega: list[float] = []
        self.x: list[Floats] = []
        self.links: dict[Node, list[Node]] = {}

    def build(self, low: float, high: float) -> None:
        """Links all states between two frequencies."""
        groups = _groups(self.folds)
        ends = [low, *(float(self.folds[0, group].mean()) for group in groups), high]
        segments: list[_Part] = []
        last = None
        for k, (a, b) in enumerate(pairwise(ends)):
            numbers = self._ask(_first(a, b, k > 0, k < len(groups)))
            if last is not None:
                segments.append(_Part(last, numbers[0], tuple(groups[k - 1])))
            segments += [_Part(one, two, ()) for one, two in pairwise(numbers)]
            last = numbers[-1]
        self.size = max((float(np.abs(x).max()) for x in self.x if x.size), default=0.0)
        while segments := [part for part in segments if not self._link(part)]:
            segments = self._cut(segments)

    def _ask(self, Omega: Sequence[float]) -> list[int]:
        """States at new frequencies; the numbers of these."""
        x, of = self._states(np.array(Omega))
        numbers = list(range(len(self.Omega), len(self.Omega) + len(Omega)))
        self.Omega += Omega
        self.x += [x[:, of == k] for k in range(len(Omega))]
        return numbers

    def _cut(self, segments: list[_Part]) -> list[_Part]:
        """Each in two, or, with a fold inside, a narrower one and what is beside it."""
        inner = [self._inside(part) for part in segments]
        numbers = iter(self._ask([*chain(*inner)]))
        found: list[_Part] = []
        for part, new in zip(segments, inner, strict=True):
            ends = pairwise([part.a, *islice(numbers, len(new)), part.b])
            found += [_Part(*pair, part.folds if k == 1 else (), part.cuts + 1) for k, pair in enumerate(ends)]
        return found

    def _inside(self, part: _Part) -> list[float]:
        """Where one is cut: in the middle, or on both sides of its folds."""
        a, b = self.Omega[part.a], self.Omega[part.b]
        if part.cuts > CUTS:
            raise NotSettled(UNRESOLVED.format((a, b)))
        if not part.folds:
            return [0.5 * (a + b)]
        fold = float(self.folds[0, list(part.folds)].mean())
        # where another fold is near on one side, as near on the other
        width = 0.25 * min(fold - a, b - fold)
        return [fold - width, fold + width]

    def _link(self, part: _Part) -> bool:
        """Links what is on one arc, if that is told of all states on both sides."""
        a, b = self.x[part.a], self.x[part.b]
        is_kink = self._is_kink(part.folds)
        if abs(a.shape[1] - b.shape[1]) != (0 if is_kink else 2 * len(part.folds)):
            return False
        pairs = self._pairs(part, a, b)
        if is_kink:
            return self._link_kink(part, pairs)
        if len(pairs) < min(a.shape[1], b.shape[1]):
            return False
        more, at = (0, part.a) if a.shape[1] > b.shape[1] else (1, part.b)
        x = (a, b)[more]
        meet = {fold: self._nearest(x, fold, 2) for fold in part.folds}
        if len(part.folds) == 1 and not meet[part.folds[0]]:
            # those that are left meet there, however near a third is
            left = set(range(x.shape[1])) - {pair[more] for pair in pairs}
            meet = {part.folds[0]: sorted(left)}
        if sorted((*chain(*meet.values()), *(pair[more] for pair in pairs))) != list(range(x.shape[1])):
            return False
        for fold, states in meet.items():
            for i in states:
                self._join(Node(at, i), Node(-1, fold))
        for i, j in pairs:
            self._join(Node(part.a, i), Node(part.b, j))
        return True

    def _is_kink(self, folds: tuple[int, ...]) -> bool:
        """Whether these are the two of a kink, and no mirrored ones."""
        return len(folds) == 2 and _is_near(self.folds[:, folds[0]], self.folds[:, folds[1]], KINK)

    def _link_kink(self, part: _Part, pairs: list[tuple[int, int]]) -> bool:
        """Links the state that comes to a kink on either side through its folds, and all others as they are paired."""
        ends = [i for at in (part.a, part.b) for i in self._nearest(self.x[at], part.folds[0], 1)]
        if len(ends) != 2:
            return False
        others = [pair for pair in pairs if pair[0] != ends[0] and pair[1] != ends[1]]
        if len(others) != self.x[part.a].shape[1] - 1:
            return False
        # between the folds there are two states more: a curve goes to the second, back to the first, and on
        first, second = (Node(-1, fold) for fold in part.folds)
        way = [Node(part.a, ends[0]), second, first, Node(part.b, ends[1])]
        for one, two in (*pairwise(way), *((Node(part.a, i), Node(part.b, j)) for i, j in others)):
            self._join(one, two)
        return True

    def _nearest(self, x: Floats, fold: int, n: int) -> list[int]:
        """The n states that are nearer to a fold than all others; none where these are near too."""
        apart = np.abs(x - self.folds[1:, fold, np.newaxis]).max(axis=0)
        order = np.argsort(apart)
        distinct = apart.size == n or (apart.size > n and apart[order[n - 1]] < MEET * apart[order[n]])
        return [int(i) for i in order[:n]] if distinct else []

    def _join(self, one: Node, two: Node) -> None:
        self.links.setdefault(one, []).append(two)
        self.links.setdefault(two, []).append(one)

    def _pairs(self, part: _Part, a: Floats, b: Floats) -> list[tuple[int, int]]:
        """Which states on the one side are on one arc with which on the other.

        Their tangents bring both to one place midway: nearer by far than to any other's, and near beside the curve.
        """
        if not (a.shape[1] and b.shape[1]):
            return []
        low, high = self.Omega[part.a], self.Omega[part.b]
        half = 0.5 * (high - low)
        slope_a, slope_b = (_tangents(self.of, np.full(x.shape[1], at), x) for x, at in ((a, low), (b, high)))
        apart = np.linalg.norm((a + half * slope_a)[:, :, np.newaxis] - (b - half * slope_b)[:, np.newaxis], axis=0)
        to_b, to_a = np.argmin(apart, axis=1), np.argmin(apart, axis=0)
        i = np.flatnonzero(to_a[to_b] == np.arange(a.shape[1]))
        j = to_b[i]
        others = apart.copy()
        others[i, j] = np.inf
        least = np.minimum(BY_FAR * np.minimum(others[i].min(axis=1), others[:, j].min(axis=0)), NEAR * self.size)
        linked = apart[i, j] < least
        pairs = [(int(one), int(two)) for one, two in zip(i[linked], j[linked], strict=True)]
        if not part.folds and len(pairs) == a.shape[1] - 1 == b.shape[1] - 1:
            # no arc ends between: what is left on either side is on one
            (one,), (two,) = (set(range(a.shape[1])) - {pair[side] for pair in pairs} for side in (0, 1))
            pairs.append((one, two))
        return pairs

    def tours(self) -> list[tuple[list[Node], bool]]:
        """Each curve as its nodes in order, and whether it is closed."""
        lone = [Node(at, i) for at, x in enumerate(self.x) for i in range(x.shape[1]) if Node(at, i) not in self.links]
        found: list[tuple[list[Node], bool]] = [([node], False) for node in lone]
        seen: set[Node] = set()
        ends = sorted(node for node, others in self.links.items() if len(others) == 1)
        for start in (*ends, *sorted(self.links)):
            if start in seen:
                continue
            tour, node = [], start
            while node not in seen:
                seen.add(node)
                tour.append(node)
                node = next((other for other in self.links[node] if other not in seen), start)
            closed = len(self.links[start]) == 2
            found.append(([*tour, start] if closed else tour, closed))
        return found

    def place(self, node: Node) -> tuple[float, float, float]:
        """Omega, A, B."""
        if node.at < 0:
            Omega, A, B = self.folds[:, node.state].tolist()
            return Omega, A, B
        A, B = self.x[node.at][:, node.state].tolist()
        return self.Omega[node.at], A, B


def _groups(folds: Floats) -> list[list[int]]:
    """Numbers of folds by rising frequency: those of one frequency together, and the two of a kink."""
    found: list[list[int]] = []
    for k in np.argsort(folds[0], kind="stable").tolist():
        last = folds[:, found[-1][0]] if found else None
        if last is not None and folds[0, k] - last[0] <= TOGETHER * folds[0, k]:
            found[-1].append(k)
        elif last is not None and len(found[-1]) == 1 and _is_near(folds[:, k], last, KINK):
            found[-1].append(k)
        else:
            found.append([k])
    return found


def _is_near(one: Floats, other: Floats, fraction: float) -> bool:
    """Whether two folds are near beside Omega, and beside A."""
    return bool((np.abs(one - other) <= fraction * one[[0, 1, 1]]).all())


def _first(low: float, high: float, after_fold: bool, before_fold: bool) -> list[float]:
    """Frequencies of a cell: they crowd towards a fold, without it; an edge of the window is one of them."""
    fraction = (np.arange(FIRST) + 0.5) / FIRST
    if after_fold and before_fold:
        fraction = np.sin(0.5 * np.pi * fraction) ** 2
    elif after_fold:
        fraction = np.append(fraction**2, 1.0)
    elif before_fold:
        fraction = np.append(0.0, 1 - (1 - fraction) ** 2)
    else:
        fraction = np.linspace(0.0, 1.0, FIRST + 1)
    found: list[float] = (low + (high - low) * fraction).tolist()
    if not before_fold:
        found[-1] = high
    return found


def _tangents(of: Slow, Omega: Floats, x: Floats) -> Floats:
    """dA/dOmega and dB/dOmega along the response at states (2, n)."""
    means = of.steps.at(x[0], x[1], 1)
    by_Omega = of.flow.F_Omega(Omega, x[0], -2 * means.s[0])
    return -_step(of, (0 * by_Omega, by_Omega, *of.state(Omega, x, means)[2:]))


def _step(of: Slow, state: Any) -> Floats:
    """Newton's step, 0 where the slopes do not tell one."""
    with np.errstate(all="ignore"):
        found = of.step(state)
    return np.where(np.isfinite(found), found, 0.0)


def _arm(of: Slow, Omega: Floats, x: Floats) -> Floats:
    """The sign that tells arms that meet at a fold: of what the slopes of f_0 and F by A and B span."""
    _, _, f_A, f_B, F_A, F_B = of.state(Omega, x)
    return np.asarray(np.sign(f_A * F_B - f_B * F_A))


def _points(of: Slow, skeleton: _Skeleton, tours: list[tuple[list[Node], bool]], points: int) -> Curves:
    """The nodes, and between two of them points by Newton's method, which has one state to go to there."""
    nodes = [np.array([skeleton.place(node) for node in tour]).T for tour, _ in tours]
    weights = [_weights(place) for place in nodes]
    total = sum(float(weight.sum()) for weight in weights) or 1.0
    columns, branch = [np.empty((3, 0))], [np.empty(0, dtype=np.intp)]
    for number, ((tour, _), place, weight) in enumerate(zip(tours, nodes, weights, strict=True)):
        is_fold = np.array([node.at < 0 for node in tour])
        inner = np.ceil(points * weight / total).astype(int) - 1
        found, order = _between(of, place, is_fold, inner)
        by_order = np.argsort(np.append(np.arange(len(tour)), order), kind="stable")
        whole = np.concatenate((place, found), axis=1)[:, by_order]
        always = by_order < len(tour)
        always[always] = is_fold
        whole = _thinned(whole, always, math.ceil(points * float(weight.sum()) / total))
        columns.append(whole)
        branch.append(np.full(whole.shape[1], number))
    Omega, A, B = np.concatenate(columns, axis=1)
    return Curves(Omega, A, B, np.concatenate(branch), tuple(closed for _, closed in tours))


def _thinned(place: Floats, always: Flags, points: int) -> Floats:
    """Points in order, those that are always kept and of the others about as many as there are to be.

    Next to folds, and where arcs were hard to tell apart, many more states than that may have been asked for.
    """
    if place.shape[1] <= points + MORE:
        return place
    length = np.append(0.0, np.cumsum(_weights(place)))
    stretch = np.floor(length * (points / length[-1]))
    always[[0, -1]] = True
    return place[:, always | (np.diff(stretch, prepend=-1.0) > 0)]


def _weights(place: Floats) -> Floats:
    """How long each step of a tour is drawn: a frequency, an amplitude and a mean of 1 count as much."""
    return np.asarray(np.abs(np.diff(place, axis=1)).sum(axis=0) + 1e-6)


def _between(of: Slow, place: Floats, is_fold: Flags, inner: Ints) -> tuple[Floats, Floats]:
    """Omega, A, B of points between neighbours, and their positions in the order.

    What Newton's method does not bring near enough to what its neighbours predict is repeated once there are nearer
    ones: so the points climb a resonance from both sides.
    """
    step = np.repeat(np.arange(inner.size), np.maximum(inner, 0))
    first = np.cumsum(np.maximum(inner, 0)) - np.maximum(inner, 0)
    fraction = (np.arange(step.size) - first[step] + 1) / (inner[step] + 1)
    # next to a fold A and B go as the root of the frequency
    position = np.where(is_fold[step], fraction**2, np.where(is_fold[step + 1], 1 - (1 - fraction) ** 2, fraction))
    Omega, order = place[0, step] + (place[0, step + 1] - place[0, step]) * position, step + fraction
    known, key, folded = place, np.arange(place.shape[1], dtype=float), is_fold
    for _ in range(PASSES):
        if not order.size:
            break
        right = np.searchsorted(key, order)
        ends, folds = (known[:, right - 1], known[:, right]), (folded[right - 1], folded[right])
        x, near = _near(of, Omega, ends, folds)
        if not near.any():
            break
        by_key = np.argsort(np.concatenate((key, order[near])), kind="stable")
        key = np.concatenate((key, order[near]))[by_key]
        known = np.concatenate((known, np.stack((Omega, *x))[:, near]), axis=1)[:, by_key]
        folded = np.concatenate((folded, np.zeros(int(near.sum()), dtype=bool)))[by_key]
        Omega, order = Omega[~near], order[~near]
    new = key % 1 > 0
    return known[:, new], key[new]


def _near(of: Slow, Omega: Floats, ends: tuple[Floats, Floats], folds: tuple[Flags, Flags]) -> tuple[Floats, Flags]:
    """States (2, n) at frequencies between neighbours, and which of them are as near as these predict."""
    (start, end), (from_fold, to_fold) = ends, folds
    span = end[0] - start[0]
    part = np.clip((Omega - start[0]) / span, 0.0, 1.0)
    fraction = np.where(from_fold, np.sqrt(part), np.where(to_fold, 1 - np.sqrt(1 - part), part))
    guess = start[1:] + (end[1:] - start[1:]) * fraction
    apart = np.abs(end[1:] - start[1:]).max(axis=0)
    smooth = ~(from_fold | to_fold)
    if smooth.any():
        slopes = [_tangents(of, one[0, smooth], one[1:, smooth]) * span[smooth] for one in ends]
        guess[:, smooth] = _cubic(fraction[smooth], start[1:, smooth], end[1:, smooth], *slopes)
        apart[smooth] = 0.5 * (apart[smooth] + np.maximum(*(np.abs(slope).max(axis=0) for slope in slopes)))
    x, change = newton(of, Omega, guess)
    nearest = np.minimum(np.abs(x - start[1:]).max(axis=0), np.abs(x - end[1:]).max(axis=0))
    near = np.where(smooth, np.abs(x - guess).max(axis=0), nearest) <= apart
    inner = np.where(from_fold, end, start)
    near &= (_arm(of, Omega, x) == _arm(of, inner[0], inner[1:])) | (from_fold & to_fold)
    return x, near & (np.abs(change).max(axis=0) <= 1e-9 * np.abs(x).max(axis=0))


def newton(of: Slow, Omega: Floats, guess: Floats) -> tuple[Floats, Floats]:
    """States (2, n) at frequencies, from states near by, and the last step to them."""
    x, change, left = guess.copy(), np.zeros_like(guess), np.arange(Omega.size)
    for _ in range(NEWTON):
        change[:, left] = _step(of, of.state(Omega[left], x[:, left]))
        x[:, left] -= change[:, left]
        x[0] = np.maximum(x[0], 1e-3 * guess[0])
        left = left[(np.abs(change[:, left]) > SETTLED * x[0, left]).any(axis=0)]
        if not left.size:
            break
    return x, change


def _cubic(fraction: Floats, start: Floats, end: Floats, slope: Floats, slope_at_end: Floats) -> Floats:
    """Hermite's cubic between values with these slopes by the share."""
    rest = 1 - fraction
    return np.asarray(
        start * rest**2 * (1 + 2 * fraction)
        + end * fraction**2 * (1 + 2 * rest)
        + fraction * rest * (rest * slope - fraction * slope_at_end)
    )
