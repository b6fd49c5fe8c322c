"""Numbers of folds and states against proofs, by the million: a share of seeded cases in, what is counted out.

Proofs are those of `Isolator.many(...).certify` in doubles; `tests/test_undecided.py` has balls judge some of the same
kind.
Counted are answers that differ from a proof without saying that they are undecided, answers that say so, and answers
that claim a number where doubles prove none.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow import Duffing, Isolator
from slowflow.averaged.asked import PROVED_FOLDS, PROVED_STATES, SADDLE_NODES
from slowflow_kernels.conventions import Status
from tests.oracles.draws import batch, drawn_isolators, drawn_springs, forcings, oscillator

SEED = 41
AT_ONCE = 20_000
KINDS = {"rod_spring": (Isolator, drawn_isolators), "duffing": (Duffing, drawn_springs)}
#: frequencies beside each fold, and anywhere
BESIDE, ANYWHERE = 120, 60
COUNTED = ("asked", "differ", "undecided", "unproved", "refused")
#: cases named of each kind that differ or that nothing proves
NAMED = 3
Tally = dict[str, Any]
Flags = npt.NDArray[np.bool_]


def folds(kind: str, part: int, number: int) -> Tally:
    """What is counted, of folds at one forcing of each of so many oscillators."""
    rng, (made, draw) = np.random.default_rng([SEED, part, len(kind), 0]), KINDS[kind]
    tally = empty(kind, "folds")
    for first in range(0, number, AT_ONCE):
        numbers = draw(rng, min(AT_ONCE, number - first))
        designs = batch(made, numbers)
        F_0 = forcings(rng, designs, numbers[-2])
        *_, given, undecided, status = designs.ask(SADDLE_NODES, 1, F_0, 12)  # by doubles alone
        counted, proved, *_ = designs.ask(PROVED_FOLDS, 1, F_0)
        there = status == Status.OK
        said, other = undecided != 0, given != counted
        enter(tally, np.stack([*numbers, F_0], axis=-1)[there], said[there], proved[there] == 1, other[there])
        tally["refused"] += int((~there & (status != Status.STICKS)).sum())
    return tally


def states(kind: str, part: int, number: int) -> Tally:
    """The same of states at frequencies, most of them beside folds, of so many oscillators."""
    rng, (made, draw) = np.random.default_rng([SEED, part, len(kind), 1]), KINDS[kind]
    numbers, tally = draw(rng, number), empty(kind, "states")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for k, F_0 in enumerate(forcings(rng, batch(made, numbers), numbers[-2]).tolist()):
            *own, mu, zeta = (float(column[k]) for column in numbers)
            iso = oscillator(made, *own, mu=mu, zeta=zeta)
            try:
                at = iso.saddle_nodes(F_0).Omega[:, np.newaxis]
                beside = at * (1 + rng.choice([-1, 1], BESIDE) * 10 ** rng.uniform(-16.3, -2, BESIDE))
                Omega = np.unique(np.concatenate((10 ** rng.uniform(-1, 0.5, ANYWHERE), beside[beside > 0])))
                found = iso.amplitudes(Omega=Omega, F_0=F_0)
            except ArithmeticError:
                tally["refused"] += 1
                continue
            count = np.searchsorted(found.Omega, Omega, "right") - np.searchsorted(found.Omega, Omega)
            counted, proved, *_ = batch(made, (*own, mu, zeta)).ask(PROVED_STATES, 1, F_0, Omega=Omega)
            asked = np.stack(np.broadcast_arrays(*own, mu, zeta, F_0, Omega), axis=-1)
            enter(tally, asked, np.isin(Omega, found.Omega_undecided), proved == 1, count != counted)
    return tally


def empty(kind: str, what: str) -> Tally:
    """Nothing counted yet."""
    return {"mechanism": kind, "kind": what, **dict.fromkeys(COUNTED, 0), "named": []}


def enter(tally: Tally, at: npt.NDArray[np.float64], said: Flags, proved: Flags, other: Flags) -> None:
    """More cases: where they are, whether they are said to be undecided, proved, and another number is proved."""
    differ, unproved = proved & ~said & other, ~said & ~proved
    tally["asked"] += len(at)
    for name, which in (("differ", differ), ("undecided", said), ("unproved", unproved)):
        tally[name] += int(which.sum())
    for name, which in (("differ", differ), ("unproved", unproved)):
        room = NAMED - sum(one == name for one, _ in tally["named"])
        tally["named"] += [(name, point) for point in at[which][: max(room, 0)].tolist()]


def summed(found: list[Tally]) -> list[Tally]:
    """The shares of each mechanism and question together."""
    totals: dict[tuple[str, str], Tally] = {}
    for share in found:
        total = totals.setdefault((share["mechanism"], share["kind"]), empty(share["mechanism"], share["kind"]))
        for name in COUNTED:
            total[name] += share[name]
        total["named"] += share["named"]
    for total in totals.values():
        kinds = dict.fromkeys(name for name, _ in total["named"])
        total["named"] = [one for kind in kinds for one in [n for n in total["named"] if n[0] == kind][:NAMED]]
    return list(totals.values())
