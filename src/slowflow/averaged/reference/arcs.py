"""Curves from roots: in go events along the amplitude, out come arcs, which of their ends meet, and tours through them.

Between neighbouring events the number of roots Omega is constant and each root is an arc, continuous in A. At an event
a pair of arcs may meet and end, or the lowest may end at Omega = 0; all others go on. As in native/arcs.h and locus.h.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from slowflow.averaged.reference.roots import Quartics, taken
from slowflow.model import Floats, Model
from slowflow_kernels import slow_flow_zeta0
from slowflow_kernels.conventions import COINCIDE, HARDLY, NO_WIDTH
from slowflow_support.errors import NotSettled

Ints = NDArray[np.intp]


class Kind(Enum):
    """What happens to the arcs at an event."""

    THROUGH = "all go on"
    CUT = "all end: an end of the range, or a jump"
    PAIR_LOW = "the two lowest of the richer side meet"
    PAIR_HIGH = "the two highest meet"
    TO_ZERO = "the lowest of the richer side ends at Omega = 0; of sides as rich as each other both do, and meet"
    TO_INFINITY = "the highest of the richer side ends at Omega = inf"


@dataclass(frozen=True)
class Event:
    """At an amplitude; gain: by how much the number of roots changes, where it is known."""

    A: float
    Omega: float
    kind: Kind
    gain: int = 0


@dataclass(eq=False)
class Arc:
    """Root `index` of `count` between two events; ends 0 and 1 by rising A.

    partner -- 2 * arc + end of the end that each of its ends meets, or -1
    """

    interval: int
    count: int
    index: int
    A: list[float] = field(default_factory=lambda: [0.0, 0.0])
    Omega: list[float] = field(default_factory=lambda: [0.0, 0.0])
    partner: list[int] = field(default_factory=lambda: [-1, -1])


@dataclass(frozen=True)
class Tour:
    """Arcs in order along one curve, each with whether A rises along it."""

    steps: list[tuple[int, bool]]
    closed: bool


class Along(Protocol):
    """The frequencies of one curve along the amplitude; F_0 is negative of the fold locus."""

    @property
    def model(self) -> Model: ...

    @property
    def F_0(self) -> float: ...

    def take(self, of: Ints) -> Along:
        """Of designs abreast, those of these; of one design, its own."""
        ...

    def count(self, A: Floats) -> Ints:
        """How many there are at each amplitude."""
        ...

    def at(self, A: Floats, count: Ints, index: Ints) -> Floats:
        """Number `index` of `count` at each amplitude."""
        ...

    def lower_pair(self, event: Event) -> tuple[bool, float]:
        """Whether the lower pair of roots meets at an event, and where."""
        ...


@dataclass(frozen=True)
class Roots:
    """The frequencies along the amplitude: of the response at F_0, or for F_0 < 0 of the fold locus."""

    model: Model
    F_0: Any

    def take(self, of: Ints) -> Roots:
        """See `Along`."""
        return Roots(self.model.take(of), taken(self.F_0, of))

    def _quartics(self, A: Floats) -> Quartics:
        h, h_A, _, _ = (value + np.zeros_like(A) for value in self.model.averaged(A))
        return Quartics(A, h, h_A, self.model.m, self.model.zeta, self.F_0)

    @property
    def _is_backbone(self) -> bool:
        """Whether there is one branch in closed form: R = 0, the other factor, is the backbone, at the level m."""
        return self._of_folds and self.model.undamped

    @property
    def _of_folds(self) -> bool:
        return bool(np.any(self.F_0 < 0))

    def count(self, A: Floats) -> Ints:
        """How many there are at each amplitude."""
        if self._is_backbone:
            return np.asarray(self.model.averaged(A)[1] < 0, dtype=np.intp)
        return self._quartics(A).count().astype(np.intp)

    def at(self, A: Floats, count: Ints, index: Ints) -> Floats:
        """Number `index` of `count` at each amplitude."""
        if self._is_backbone:
            return self._undamped(A)
        Omega = self._quartics(A).roots(count, index)
        if not self._of_folds or A.all():
            return Omega
        # at A = 0, where the quartic is none, what damping is too weak to hide begins at the stiffness there
        at_rest = self._undamped(A)
        return np.where((A == 0) & np.isfinite(at_rest), at_rest, Omega)

    def _undamped(self, A: Floats) -> Floats:
        return np.asarray(slow_flow_zeta0.undamped_Omega(np.minimum(self.model.averaged(A)[1], 0.0)))

    def lower_pair(self, event: Event) -> tuple[bool, float]:
        """Whether the lower pair of roots meets at an event, and where.

        That is as the event says, or, where it is none of these but roots vanish all the same (a breakpoint that is an
        extremum to rounding), by the critical value next to 0.
        """
        if event.kind in (Kind.PAIR_LOW, Kind.PAIR_HIGH):
            return event.kind == Kind.PAIR_LOW, event.Omega
        (w1, f1), (w2, f2) = self._quartics(np.array([event.A])).critical
        lower = bool(w1[0] > 0 and abs(f1[0]) < abs(f2[0]))
        return lower, float(w1[0] if lower else w2[0])


def merged(events: list[Event]) -> list[Event]:
    """The events, but one where the lower pair meets next to the end of one of its arcs at Omega = 0.

    With little friction and damping rounding may take the one place for the earlier: then an arc comes from Omega = 0.
    """
    found: list[Event] = []
    for event in events:
        last = found[-1] if found else event
        near = bool(found) and event.A - last.A <= COINCIDE * event.A
        if near and {last.kind, event.kind} == {Kind.PAIR_LOW, Kind.TO_ZERO}:
            found[-1] = replace(last, kind=Kind.TO_ZERO, gain=last.gain + event.gain)
        else:
            found.append(event)
    return found


class Graph:
    """The arcs between events and how they hang together.

    Raises ArithmeticError where the numbers of roots contradict each other.
    """

    roots: Along
    events: list[Event]
    counts: list[int]
    arcs: list[Arc]
    #: the number of each interval's first arc, and what `_at_events` has
    _first: list[int]
    _ends: dict[tuple[int, int], list[float]]

    @classmethod
    @np.errstate(all="ignore")
    def of(cls, roots: Along, events: list[Event]) -> Graph:
        """Of the frequencies along the amplitude, and the events there."""
        graph = cls()
        graph.roots, graph.events = roots, events
        graph.counts = graph._counted()
        graph.arcs = [Arc(k, n, i) for k, n in enumerate(graph.counts) for i in range(n)]
        graph._first = np.concatenate(([0], np.cumsum(graph.counts))).astype(int).tolist()
        graph._ends = graph._at_events()
        graph._link_all()
        return graph

    def _link_all(self) -> None:
        for k in range(1, len(self.events) - 1):
            self._link(k)
        if self.events[0].A > 0 or self.roots.F_0 < 0:
            self._end_all(0, 0, 0)
        else:  # the response comes from A = 0, at one frequency
            for i in range(self.counts[0]):
                self._end(i, 0, 0.0, self.events[0].Omega)
        self._end_all(len(self.events) - 1, len(self.events) - 2, 1)

    def _counted(self) -> list[int]:
        """Numbers of roots; where an interval is too narrow to hold an amplitude, the event's gain tells."""
        A = np.array([event.A for event in self.events])
        low, high = A[:-1], A[1:]
        middle = 0.5 * (low + high)
        wide = (middle > low + NO_WIDTH * low) & (middle < high)
        shown = self.roots.count(np.where(wide | (low == 0), middle, low))
        counts: list[int] = []
        for k, count in enumerate(shown.tolist()):
            if wide[k]:
                counts.append(count)
            elif k > 0 and self.events[k].kind != Kind.CUT:
                counts.append(counts[-1] + self.events[k].gain)
            else:  # next to a breakpoint, or between its two sides
                counts.append(0 if self.events[k + 1].kind == Kind.CUT else count)
            if not 0 <= counts[-1] <= 3 or self._contradict(counts):
                raise NotSettled("the response is unresolved: branches coincide within rounding")
        return counts

    def _contradict(self, counts: list[int]) -> bool:
        """Whether the last two numbers of a response's roots are not what the event between makes of them.

        Between events that are hardly apart rounding may have changed their order.
        """
        k = len(counts) - 1
        event = self.events[k]
        if k == 0 or self.roots.F_0 < 0 or event.kind in (Kind.CUT, Kind.THROUGH):
            return False
        apart = min(event.A - self.events[k - 1].A, self.events[k + 1].A - event.A) > HARDLY * event.A
        return apart and counts[-1] - counts[-2] != event.gain

    def _at_events(self) -> dict[tuple[int, int], list[float]]:
        """At each event the roots that go through it or end there: by its number and by how many they are."""
        last = len(self.events) - 1
        asked: list[tuple[int, int]] = []
        for k, event in enumerate(self.events):
            sides = [self.counts[side] for side in (k - 1, k) if 0 <= side < last]
            both = event.kind == Kind.CUT or len(sides) == 1
            known = k == 0 and event.A == 0 and self.roots.F_0 > 0  # where the response comes from
            asked += [(k, n) for n in sorted(set(sides if both else [min(sides)])) if n > 0 and not known]
        A, count, index = (
            np.array([value for k, n in asked for value in values(k, n)])
            for values in (lambda k, n: [self.events[k].A] * n, lambda _, n: [n] * n, lambda _, n: range(n))
        )
        if not asked:
            return {}
        found = self.roots.at(A.astype(float), count.astype(np.intp), index.astype(np.intp))
        Omega = iter(found.tolist())
        return {(k, n): [next(Omega) for _ in range(n)] for k, n in asked}

    def _end(self, arc: int, end: int, A: float, Omega: float) -> None:
        self.arcs[arc].A[end], self.arcs[arc].Omega[end] = A, Omega

    def _meet(self, one: int, end_one: int, other: int, end_other: int) -> None:
        self.arcs[one].partner[end_one] = 2 * other + end_other
        self.arcs[other].partner[end_other] = 2 * one + end_one

    def _end_all(self, k: int, interval: int, end: int) -> None:
        """Arcs of an interval that end at event k, each with the Omega that it has there."""
        for i in range(self.counts[interval]):
            self._end(self._first[interval] + i, end, self.events[k].A, self._ends[k, self.counts[interval]][i])

    def _link(self, k: int) -> None:
        """Event k, between intervals k - 1 and k: arcs of the richer side end, all others go on."""
        event, left, right = self.events[k], self.counts[k - 1], self.counts[k]
        if event.kind == Kind.CUT:
            self._end_all(k, k - 1, 1)
            self._end_all(k, k, 0)
            return
        rich, poor, rich_end = (k - 1, k, 1) if left >= right else (k, k - 1, 0)
        more, fewer = self.counts[rich], self.counts[poor]
        lost, gone = more - fewer, 0  # gone: index of the first arc of the richer side that does not go on
        first_rich, first_poor = self._first[rich], self._first[poor]
        if event.kind == Kind.TO_INFINITY and lost == 1:
            gone = fewer
            self._end(first_rich + gone, rich_end, event.A, np.inf)
        elif lost % 2 == 1:
            self._end(first_rich, rich_end, event.A, 0.0)
        if lost >= 2:
            lower, Omega = self.roots.lower_pair(event)
            lower = lower and lost == 2
            pair = first_rich if lower else first_rich + more - 2
            gone = 0 if lower or lost == 3 else more - 2
            self._end(pair, rich_end, event.A, Omega)
            self._end(pair + 1, rich_end, event.A, Omega)
            self._meet(pair, rich_end, pair + 1, rich_end)
        for i in range(fewer):
            other = first_rich + (i if i < gone else i + lost)
            # by other laws, where one ends at Omega = 0 and another begins they meet; without, one goes by
            at_rest = i == lost == 0 and event.kind == Kind.TO_ZERO and self.roots.model.laws.any
            Omega = 0.0 if at_rest else self._ends[k, fewer][i]
            self._end(first_poor + i, 1 - rich_end, event.A, Omega)
            self._end(other, rich_end, event.A, Omega)
            self._meet(first_poor + i, 1 - rich_end, other, rich_end)

    @cached_property
    def tours(self) -> list[Tour]:
        """Open curves from one loose end to the other, at the lower Omega first, then the closed ones.

        The curve that reaches A = 0 is the first: its end is the lowest.
        """
        lowest = [2 * n for n, arc in enumerate(self.arcs) if arc.interval == 0 and arc.partner[0] < 0]
        loose = [2 * n + end for n, arc in enumerate(self.arcs) for end in (0, 1) if arc.partner[end] < 0]
        visited: set[int] = set()
        tours: list[Tour] = []
        for end in (*lowest, *loose):
            steps = self._follow(end, visited)
            if steps and self._Omega(steps[0], first=True) > self._Omega(steps[-1], first=False):
                steps = [(arc, not upward) for arc, upward in reversed(steps)]
            tours += [Tour(steps, closed=False)] if steps else []
        for n in range(len(self.arcs)):
            steps = self._follow(2 * n, visited)
            tours += [Tour(steps, closed=True)] if steps else []
        return tours

    def _follow(self, end: int, visited: set[int]) -> list[tuple[int, bool]]:
        """The arcs from an end on, along the curve, until it ends or closes."""
        steps: list[tuple[int, bool]] = []
        while end >= 0 and end // 2 not in visited:
            arc, upward = end // 2, 1 - end % 2
            visited.add(arc)
            steps.append((arc, bool(upward)))
            end = self.arcs[arc].partner[upward]
        return steps

    def _Omega(self, step: tuple[int, bool], *, first: bool) -> float:
        return self.arcs[step[0]].Omega[int(step[1] != first)]
