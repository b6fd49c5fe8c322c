"""Numbers of folds and states against proofs, by the million: seeded cases in, a line for each kind of question out.

`python -m benchmarks.stress.scale`. Proofs are those of `Isolator.many(...).certify`; the oscillators, forcings and
frequencies are drawn as in `tests/test_undecided.py`, where balls judge some of them too. Counted are answers that
differ from a proof without saying that they are undecided, answers that say so, and answers that claim a number where
doubles prove none.
"""

from __future__ import annotations

import argparse
import warnings

import numpy as np

from slowflow import Duffing, Isolator
from slowflow_kernels.conventions import Status
from tests.test_undecided import batch, drawn_isolators, drawn_springs, forcings, oscillator

SEED = 41
AT_ONCE = 50_000
KINDS = (("rod_spring", Isolator, drawn_isolators), ("duffing", Duffing, drawn_springs))
#: frequencies beside each fold, and anywhere
BESIDE, ANYWHERE = 60, 30
COUNTED = ("asked", "differ", "undecided", "not proved, said to be decided", "refused")


def folds(kind: type, draw: object, number: int, rng: np.random.Generator) -> np.ndarray:
    """What is counted, of folds at one forcing of each of so many oscillators."""
    numbers = draw(rng, number)  # type: ignore[operator]
    designs = batch(kind, numbers)
    F_0 = forcings(rng, designs, numbers[-2])
    found, proofs = designs.saddle_nodes(F_0, places=12, workers=-1), designs.certify(F_0, workers=-1)
    there = found.status == Status.OK
    said, proved = found.undecided != 0, proofs.proved == 1
    differ = proved & ~said & (found.count != proofs.count)
    refused = (found.status != Status.OK) & (found.status != Status.STICKS)
    return np.array([(there & one).sum() for one in (there, differ, said, ~said & ~proved)] + [refused.sum()])


def states(kind: type, draw: object, number: int, rng: np.random.Generator) -> np.ndarray:
    """The same of states at frequencies, most of them beside folds, of so many oscillators."""
    numbers = draw(rng, number)  # type: ignore[operator]
    total = np.zeros(len(COUNTED), dtype=np.int64)
    for k, F_0 in enumerate(forcings(rng, batch(kind, numbers), numbers[-2]).tolist()):
        *own, mu, zeta = (float(column[k]) for column in numbers)
        iso = oscillator(kind, *own, mu=mu, zeta=zeta)
        try:
            at = iso.saddle_nodes(F_0).Omega[:, np.newaxis]
            beside = at * (1 + rng.choice([-1, 1], BESIDE) * 10 ** rng.uniform(-16.3, -2, BESIDE))
            Omega = np.unique(np.concatenate((10 ** rng.uniform(-1, 0.5, ANYWHERE), beside[beside > 0])))
            found = iso.amplitudes(Omega=Omega, F_0=F_0)
        except ArithmeticError:
            total[-1] += 1
            continue
        count = np.searchsorted(found.Omega, Omega, "right") - np.searchsorted(found.Omega, Omega)
        proofs = batch(kind, (*own, mu, zeta)).certify(F_0, Omega=Omega, workers=-1)
        said, proved = np.isin(Omega, found.Omega_undecided), proofs.proved == 1
        differ = proved & ~said & (count != proofs.count)
        total[:-1] += [Omega.size, differ.sum(), said.sum(), (~said & ~proved).sum()]
    return total


def main() -> None:
    """Count and print."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--folds", type=int, default=1_000_000, help="oscillators of each kind, each at one forcing")
    parser.add_argument("--states", type=int, default=10_000, help="oscillators of each kind, each at many frequencies")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    for name, kind, draw in KINDS:
        for what, ask, number in (("folds", folds, options.folds), ("states", states, options.states)):
            rng = np.random.default_rng([SEED, len(name), len(what)])
            sizes = [min(AT_ONCE, number - first) for first in range(0, number, AT_ONCE)]
            total = sum((ask(kind, draw, size, rng) for size in sizes), np.zeros(len(COUNTED), dtype=np.int64))
            said = ", ".join(f"{label} {value:,}" for label, value in zip(COUNTED, total.tolist(), strict=True))
            print(f"{name}, {what}: {said}", flush=True)


if __name__ == "__main__":
    main()
