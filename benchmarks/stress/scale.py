"""Numbers of folds and states against proofs, by the million: a share of seeded cases in, what is counted out.

Answers are those of doubles alone, compiled or on NumPy: balls, which a public answer asks where these do not decide,
would take hours. Proofs are those of `Isolator.many(...).certify` in doubles; `tests/averaged/test_undecided.py` has
balls judge some of the same kind.
Counted are answers that differ from a proof without saying that they are undecided, answers that say so, and answers
that claim a number where doubles prove none.
"""

from __future__ import annotations

import dataclasses
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow import Duffing, Isolator
from slowflow.averaged.many import PROVED_FOLDS, PROVED_STATES, SADDLE_NODES
from slowflow.averaged.proofs import Allowance
from slowflow.support.errors import NotSettled
from slowflow_kernels.conventions import Status
from tests.oracles import draws

SEED = 41
AT_ONCE = 20_000
#: frequencies near each fold, and anywhere
NEAR_FOLDS, ANYWHERE = 15, 225
COUNTED = ("queries", "differ", "undecided", "unproved", "refused")
#: cases named of each kind that differ or that nothing proves
NAMED = 3
Tally = dict[str, Any]
Flags = npt.NDArray[np.bool_]
Numbers = tuple[draws.Floats, ...]


@dataclasses.dataclass(frozen=True)
class Kind:
    """Oscillators of one force: what makes them, their numbers drawn, and further arguments."""

    made: type
    draw: Callable[[np.random.Generator, int], Numbers]
    also: dict[str, str] = dataclasses.field(default_factory=dict)

    def parameters(self, numbers: Any) -> dict[str, Any]:
        """By name."""
        names = ("lam", "r", "delta_h", "mu", "zeta") if self.made is Isolator else ("alpha", "beta", "mu", "zeta")
        return {**dict(zip(names, numbers, strict=True)), **self.also}

    def batch(self, numbers: Any) -> Any:
        """All of them."""
        return self.made.many(**self.parameters(numbers))  # type: ignore[attr-defined]

    def one(self, numbers: Any) -> Any:
        """One of them, without the warning of negative stiffness."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return self.made(**self.parameters(numbers))


def undamped_isolators(rng: np.random.Generator, count: int) -> Numbers:
    """Friction alone, or nothing."""
    lam, r, delta_h, mu, zeta = draws.drawn_isolators(rng, count)
    return lam, r, delta_h, mu, 0 * zeta


def isolators_without_stiffness(rng: np.random.Generator, count: int) -> Numbers:
    """lam r delta_h is 1 exactly."""
    _, _, _, mu, zeta = draws.drawn_isolators(rng, count)
    lam, delta_h = 2.0 ** rng.integers(0, 3, count), 2.0 ** -rng.integers(1, 11, count)
    return lam, 1 / (lam * delta_h), delta_h, mu, zeta


def undamped_springs(rng: np.random.Generator, count: int) -> Numbers:
    """Friction alone, or nothing."""
    *own, mu, zeta = draws.drawn_springs(rng, count)
    return *own, mu, 0 * zeta


def springs_without_stiffness(rng: np.random.Generator, count: int) -> Numbers:
    """A cubic force."""
    alpha, *others = draws.drawn_springs(rng, count)
    return 0 * alpha, *others


#: by the mechanism's name, then what is special
KINDS = {
    "rod_spring": Kind(Isolator, draws.drawn_isolators),
    "rod_spring, zeta = 0": Kind(Isolator, undamped_isolators),
    "rod_spring, alpha = 0": Kind(Isolator, isolators_without_stiffness),
    "rod_spring_untruncated": Kind(Isolator, draws.drawn_isolators, {"force": "untruncated"}),
    "duffing": Kind(Duffing, draws.drawn_springs),
    "duffing, zeta = 0": Kind(Duffing, undamped_springs),
    "duffing, alpha = 0": Kind(Duffing, springs_without_stiffness),
}


def folds(kind: str, part: int, number: int) -> Tally:
    """What is counted, of folds at one forcing of each of so many oscillators."""
    return _folds(kind, "folds", [SEED, part, len(kind), 0], number, in_use)


def in_use(kind: str, numbers: Numbers, F_0: draws.Floats) -> list[npt.NDArray[Any]]:
    """Number of folds, whether it is said to be undecided, status: by the solvers that are in use."""
    *_, count, undecided, status = KINDS[kind].batch(numbers).ask(SADDLE_NODES, 1, F_0, 12)
    return [count, undecided, status]


def _folds(kind: str, what: str, seed: list[int], number: int, answers: Callable[..., list[npt.NDArray[Any]]]) -> Tally:
    rng, tally = np.random.default_rng(seed), empty(kind, what)
    for first in range(0, number, AT_ONCE):
        numbers = KINDS[kind].draw(rng, min(AT_ONCE, number - first))
        designs = KINDS[kind].batch(numbers)
        F_0 = draws.forcings(rng, designs, numbers[-2])
        count, undecided, status = answers(kind, numbers, F_0)
        counted, proved, *_ = designs.ask(PROVED_FOLDS, 1, F_0)
        there = status == Status.OK
        marked, other = undecided != 0, count != counted
        enter(tally, np.stack([*numbers, F_0], axis=-1)[there], marked[there], proved[there] == 1, other[there])
        tally["refused"] += int((~there & (status != Status.STICKS)).sum())
    return tally


def states(kind: str, part: int, number: int) -> Tally:
    """The same of states at frequencies, some of them near folds, of so many oscillators."""
    rng, made = np.random.default_rng([SEED, part, len(kind), 1]), KINDS[kind]
    numbers, tally = made.draw(rng, number), empty(kind, "states")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for k, F_0 in enumerate(draws.forcings(rng, made.batch(numbers), numbers[-2]).tolist()):
            own = [float(column[k]) for column in numbers]
            iso = made.one(own)
            try:
                at = iso.folds(F_0, allowance=Allowance(0)).Omega[:, np.newaxis]
                near = at * (1 + rng.choice([-1, 1], NEAR_FOLDS) * 10 ** rng.uniform(-16.3, -2, NEAR_FOLDS))
                Omega = np.unique(np.concatenate((10 ** rng.uniform(-1, 0.5, ANYWHERE), near[near > 0])))
                found = iso.states(Omega=Omega, F_0=F_0, allowance=Allowance(0))
            except NotSettled:
                tally["refused"] += 1
                continue
            count = np.searchsorted(found.Omega, Omega, "right") - np.searchsorted(found.Omega, Omega)
            counted, proved, *_ = made.batch(own).ask(PROVED_STATES, 1, F_0, Omega=Omega)
            points = np.stack(np.broadcast_arrays(*own, F_0, Omega), axis=-1)
            enter(tally, points, np.isin(Omega, found.Omega_undecided), proved == 1, count != counted)
    return tally


def empty(kind: str, what: str) -> Tally:
    """Nothing counted yet."""
    return {"mechanism": kind, "kind": what, **dict.fromkeys(COUNTED, 0), "named": []}


def enter(tally: Tally, at: npt.NDArray[np.float64], marked: Flags, proved: Flags, other: Flags) -> None:
    """More cases: where they are, whether they are marked as undecided, proved, and another number is proved."""
    differ, unproved = proved & ~marked & other, ~marked & ~proved
    tally["queries"] += len(at)
    for name, which in (("differ", differ), ("undecided", marked), ("unproved", unproved)):
        tally[name] += int(which.sum())
    for name, which in (("differ", differ), ("unproved", unproved)):
        room = NAMED - sum(one == name for one, _ in tally["named"])
        tally["named"] += [(name, point) for point in at[which][: max(room, 0)].tolist()]


def summed(found: list[Tally]) -> list[Tally]:
    """The shares of each mechanism and question together."""
    totals: dict[tuple[str, str], Tally] = {}
    for tally in found:
        total = totals.setdefault((tally["mechanism"], tally["kind"]), empty(tally["mechanism"], tally["kind"]))
        for name in COUNTED:
            total[name] += tally[name]
        total["named"] += tally["named"]
    for total in totals.values():
        kinds = dict.fromkeys(name for name, _ in total["named"])
        total["named"] = [one for kind in kinds for one in [n for n in total["named"] if n[0] == kind][:NAMED]]
    return list(totals.values())
