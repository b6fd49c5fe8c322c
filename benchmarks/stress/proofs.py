"""How much is proved at run time: random isolators in, shares proved, what is not and why, widths and times out.

Each isolator is asked for all folds at a forcing, all states at a frequency, F_SN and F_cr, each with its proof; and,
apart, for its folds next to F_SN, where two of them are about to meet and doubles cannot tell whether they have.
"""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from slowflow import Isolator
from slowflow.certificate import Proved
from slowflow.paper import example

SEED = 29
#: by decades: of r, delta_h, mu, zeta, of F_0/(4 mu/pi) - 1, and Omega
DRAWN = {
    "r": (-2.0, 1.5),
    "delta_h": (-3.0, -0.02),
    "mu": (-5.0, -1.0),
    "zeta": (-4.0, -0.3),
    "excess": (-2.0, 3.0),
    "Omega": (-1.0, 0.5),
}
#: horizontal springs
MOST_SPRINGS = 4
#: how far from F_SN, relatively, on either side
BESIDE = (1e-3, 1e-6, 1e-9, 1e-12, 1e-14)
ASKED = ("folds", "states", "F_SN", "F_cr")
#: repetitions of what is timed
REPEATS = 5


def drawn(rng: np.random.Generator) -> tuple[Isolator, float, float]:
    """A random isolator, a forcing that moves it, a frequency."""
    values = {name: float(10 ** rng.uniform(*decades)) for name, decades in DRAWN.items()}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        design = {name: values[name] for name in ("r", "delta_h", "mu", "zeta")}
        isolator = Isolator(lam=int(rng.integers(1, MOST_SPRINGS + 1)), **design)
    return isolator, isolator.sticking_forcing * (1 + values["excess"]), values["Omega"]


def best(ask: Callable[[], Any]) -> float:
    """The shortest time of some."""
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        ask()
        times.append(time.perf_counter() - start)
    return min(times)


def told(isolator: Isolator, F_0: float | None, what: str, proof: Proved) -> tuple[str, ...]:
    """What is not proved, of which isolator, and why."""
    return what, repr(isolator), "" if F_0 is None else repr(F_0), proof.message


def stress(part: int, isolators: int) -> dict[str, Any]:
    """One share of the isolators."""
    rng = np.random.default_rng((SEED, part))
    asked, proved = dict.fromkeys(ASKED, 0), dict.fromkeys(ASKED, 0)
    beside = {f"{distance:g}": [0, 0] for distance in BESIDE}
    unproved: list[tuple[str, ...]] = []
    others: list[tuple[str, ...]] = []
    widths: list[float] = []
    ratios: list[float] = []
    for _ in range(isolators):
        isolator, F_0, Omega = drawn(rng)
        found = isolator.saddle_nodes(F_0)
        certificate = isolator.certify(F_0, Omega=Omega)
        answers: tuple[Proved | None, ...] = (
            certificate.saddle_nodes,
            certificate.amplitudes,
            certificate.saddle_node_onset,
            certificate.detachment,
        )
        for what, proof in zip(ASKED, answers, strict=True):
            assert proof is not None
            asked[what] += 1
            proved[what] += proof.proved
            if not proof.proved:
                unproved.append(told(isolator, None if what.startswith("F_") else F_0, what, proof))
        folds = certificate.saddle_nodes
        if folds.proved and len(folds.A) != len(found):
            others.append((repr(isolator), repr(F_0), str(len(found)), str(len(folds.A))))
        widths += [(high - low) / high for low, high in folds.A.tolist()]
        plain = partial(isolator.saddle_nodes, F_0)
        ratios.append(best(partial(plain, certify=True)) / best(plain))
        if certificate.saddle_node_onset.F_0.size and certificate.saddle_node_onset.proved:
            level = float(certificate.saddle_node_onset.F_0.mean())
            for distance in BESIDE:
                for side in (-1, 1):
                    near = isolator.saddle_nodes(level * (1 + side * distance), certify=True).proof
                    assert near is not None
                    beside[f"{distance:g}"][0] += 1
                    beside[f"{distance:g}"][1] += near.proved
    return {
        "isolators": isolators,
        "asked": asked,
        "proved": proved,
        "unproved": unproved,
        "others": others,
        "beside": beside,
        "widths": widths,
        "ratios": ratios,
    }


def table_2() -> float:
    """Seconds for everything of Table 2: folds at its forcings, F_SN and F_cr."""
    isolator = example.isolator()
    forcings = (0.025, 0.03, 0.04, 0.05)
    return best(lambda: [isolator.certify(F_0) for F_0 in forcings])


def summed(parts: list[dict[str, Any]]) -> dict[str, Any]:
    """All shares as one."""
    return {
        "isolators": sum(part["isolators"] for part in parts),
        "asked": {what: sum(part["asked"][what] for part in parts) for what in ASKED},
        "proved": {what: sum(part["proved"][what] for part in parts) for what in ASKED},
        "unproved": [one for part in parts for one in part["unproved"]],
        "others": [one for part in parts for one in part["others"]],
        "beside": {
            name: [sum(part["beside"][name][k] for part in parts) for k in range(2)] for name in parts[0]["beside"]
        },
        "width": median([float(x) for part in parts for x in part["widths"]]),
        "widest": max(float(x) for part in parts for x in part["widths"]),
        "ratio": median([float(x) for part in parts for x in part["ratios"]]),
        "table_2": table_2(),
    }


def median(values: list[float]) -> float:
    """NaN of none."""
    return float(np.median(values)) if values else math.nan
