"""How often the 95 % intervals of `fit` hold the true numbers, by how many are free, with and without a jump.

    python -m benchmarks.coverage [fits]

Isolators about that of the paper, each number times up to exp(0.3) or over it, measured at 30 frequencies about their
peak, with normal noise that is the same at all points: 1 % of the largest amplitude below the onset, 2 % above it,
where the mass follows the upper branch up to its end. A fit begins as far from the truth. Two numbers of `OTHERS` are
fitted, with structural damping, friction while attached, or under a load, in a quarter as many fits. By hand: it takes
an hour.
"""

from __future__ import annotations

import sys
import time
import warnings
from typing import Any

import numpy as np

from slowflow import Isolator
from slowflow.sizing import fit

#: n free numbers are the first n of these
NAMES = ("zeta", "mu", "delta_h", "r")
PAPER = Isolator(lam=3, r=3747 / 1848, delta_h=1848 / (6 * 3747), mu=0.012, zeta=0.02)
#: that of the paper with another law of damping, or under a load
OTHERS: dict[str, dict[str, Any]] = {
    "eta": {"eta": 0.02},
    "friction while attached": {"contact": "attached"},
    "a load": {"load": 0.03, "force": "truncated"},
    "a load, untruncated": {"load": 0.03},
}
#: of noise as a share of the largest amplitude, and the forcing as shares of the onset, from and to
CASES = {"no jump": (0.01, 0.5, 0.9), "a jump": (0.02, 1.05, 1.6)}


def measured(
    of: Isolator, random: np.random.Generator, noise: float, low: float, high: float
) -> tuple[Isolator, dict[str, Any]]:
    """An isolator, and a measurement of it as `fit` takes one."""
    while True:
        one = of.replace(**{name: of.given[name] * np.exp(random.uniform(-0.3, 0.3)) for name in NAMES})
        F_SN, F_0 = one.saddle_node_onset().F_SN, random.uniform(low, high)
        if F_SN is None or not (Omega := one.peak(F_0 * F_SN).Omega):
            continue
        at = np.linspace(0.6, 1.5, 30) * Omega
        states = one.amplitudes(Omega=at, F_0=F_0 * F_SN)
        A = np.array([states.A[(states.Omega == x) & states.stable].max() for x in at])
        A += noise * A.max() * random.standard_normal(A.size)
        if (A > 0).all():
            return one, {"Omega": at, "F_0": F_0 * F_SN, "A": A}


def coverage(of: Isolator, free: tuple[str, ...], case: str, fits: int, seed: int = 5) -> tuple[int, int, float]:
    """Intervals that cover their number, how many there are, and the median time of a fit in seconds of a processor."""
    random, covered, times = np.random.default_rng(seed), [], []
    for _ in range(fits):
        one, points = measured(of, random, *CASES[case])
        start = one.replace(**{name: one.given[name] * np.exp(random.uniform(-0.3, 0.3)) for name in free})
        begin = time.process_time()
        found = fit(start, **points, free=free)
        times.append(time.process_time() - begin)
        covered += [row.low < one.given[row.parameter] < row.high for row in found]
    return sum(covered), len(covered), float(np.median(times))


def main(fits: int = 100) -> None:
    """Print the table."""
    warnings.simplefilter("ignore")  # of what a fit ends with the message tells
    several = [("", PAPER, NAMES[: n + 1], fits) for n in range(len(NAMES))]
    several += [(f" with {name}", PAPER.replace(**laws), NAMES[:2], fits // 4) for name, laws in OTHERS.items()]
    for name, of, free, count in several:
        for case in CASES:
            covered, size, seconds = coverage(of, free, case, count)
            print(f"{len(free)} free{name}, {case}: {covered} of {size} intervals, {seconds:.2f} s a fit", flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:2]))
