"""How much is proved at run time: random isolators in, shares proved, what is not and why, widths and times out.

Each isolator is asked for all folds at a forcing, all states at a frequency, F_SN and F_cr, each with its proof; and,
apart, for its folds next to F_SN, where two of them are about to meet and doubles cannot tell whether they have. The
same is asked of families that are hard for doubles, and of the force that is not truncated. What doubles leave open is
asked of balls.
"""

from __future__ import annotations

import math
import time
import warnings
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from slowflow import Isolator, example
from slowflow.answers.certificate import Proved
from slowflow.answers.table import DOUBLES
from slowflow.averaged import proofs

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
DISTANCES = (1e-3, 1e-6, 1e-9, 1e-12, 1e-14)
QUESTIONS = ("folds", "states", "F_SN", "F_cr")
#: what is counted by question: all, what is proved, by doubles alone
COUNTED = ("queries", "proved", "alone")
#: families, by what is drawn otherwise; the first is that of the targets
FAMILIES = ("anywhere", "delta_h to 1", "delta_h to 0", "alpha to 0", "F_0 to 4 mu/pi", "not truncated")
#: of the others, for each isolator of the first
FAMILY_FRACTION = 0.2
#: repetitions of what is timed
REPEATS = 5


def drawn(rng: np.random.Generator, family: str) -> tuple[Isolator, float, float]:
    """A random isolator of a family, a forcing that moves it, a frequency."""
    values = {name: float(10 ** rng.uniform(*decades)) for name, decades in DRAWN.items()}
    lam = int(rng.integers(1, MOST_SPRINGS + 1))
    if family == "delta_h to 1":
        values["delta_h"] = 1 - 10 ** rng.uniform(-16, -2)
    elif family == "delta_h to 0":
        values["delta_h"] = 10 ** rng.uniform(-12, -3)
    elif family == "alpha to 0":
        values["r"] = (1.05 + values["r"]) / lam
        values["delta_h"] = (1 + rng.choice([-1, 1]) * 10 ** rng.uniform(-16, -6)) / (lam * values["r"])
    elif family == "F_0 to 4 mu/pi":
        values["excess"] = 10 ** rng.uniform(-16, -6)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        design = {name: values[name] for name in ("r", "delta_h", "mu", "zeta")}
        force = "untruncated" if family == "not truncated" else "truncated"
        isolator = Isolator(lam=lam, **design, force=force)
    return isolator, isolator.sticking_forcing * (1 + values["excess"]), values["Omega"]


def empty() -> dict[str, Any]:
    """Nothing counted yet, by question, and nothing that is not proved."""
    return {**{name: dict.fromkeys(QUESTIONS, 0) for name in COUNTED}, "unproved": []}


def enter(tally: dict[str, Any], isolator: Isolator, F_0: float, what: str, proof: Proved) -> None:
    """One more question; of one that is not proved, which isolator, and why."""
    tally["queries"][what] += 1
    tally["proved"][what] += proof.proved
    tally["alone"][what] += proof.proved and proof.bits == DOUBLES
    if not proof.proved:
        forcing = "" if what.startswith("F_") else repr(F_0)
        tally["unproved"].append((what, repr(isolator), forcing, proof.message))


def of_family(rng: np.random.Generator, family: str, isolators: int) -> dict[str, Any]:
    """What is proved of some of a family, by doubles alone and with balls, the slowest proof in balls in seconds."""
    tally, slowest = empty(), 0.0
    for _ in range(isolators):
        isolator, F_0, Omega = drawn(rng, family)
        model = isolator.model
        questions: dict[str, Callable[[], Proved]] = {
            "folds": partial(proofs.folds, model, F_0),
            "states": partial(proofs.states, model, F_0, Omega),
            "F_SN": partial(proofs.onset, model),
            "F_cr": partial(proofs.detachment, model),
        }
        for what, ask in questions.items():
            start = time.process_time()
            proof = ask()
            slowest = max(slowest, time.process_time() - start)
            enter(tally, isolator, F_0, what, proof)
    return {**tally, "slowest": slowest}


def best(ask: Callable[[], Any]) -> float:
    """The shortest time of some."""
    times = []
    for _ in range(REPEATS):
        start = time.perf_counter()
        ask()
        times.append(time.perf_counter() - start)
    return min(times)


def stress(part: int, isolators: int) -> dict[str, Any]:
    """One share of the isolators."""
    rng = np.random.default_rng((SEED, part))
    tally, near_onset = empty(), {f"{distance:g}": [0, 0, 0] for distance in DISTANCES}
    others: list[tuple[str, ...]] = []
    widths: list[float] = []
    ratios: list[float] = []
    for _ in range(isolators):
        isolator, F_0, Omega = drawn(rng, FAMILIES[0])
        found = isolator.saddle_nodes(F_0)
        certificate = isolator.certify(F_0, Omega=Omega)
        answers: tuple[Proved | None, ...] = (
            certificate.saddle_nodes,
            certificate.amplitudes,
            certificate.saddle_node_onset,
            certificate.detachment,
        )
        for what, proof in zip(QUESTIONS, answers, strict=True):
            assert proof is not None
            enter(tally, isolator, F_0, what, proof)
        folds = certificate.saddle_nodes
        if folds.proved and len(folds.A) != len(found):
            others.append((repr(isolator), repr(F_0), str(len(found)), str(len(folds.A))))
        widths += [(high - low) / high for low, high in folds.A.tolist()]
        plain = partial(isolator.saddle_nodes, F_0)
        ratios.append(best(partial(plain, certify=True)) / best(plain))
        if certificate.saddle_node_onset.F_0.size and certificate.saddle_node_onset.proved:
            level = float(certificate.saddle_node_onset.F_0.mean())
            for distance in DISTANCES:
                for side in (-1, 1):
                    near = isolator.saddle_nodes(level * (1 + side * distance), certify=True).proof
                    assert near is not None
                    near_onset[f"{distance:g}"][0] += 1
                    near_onset[f"{distance:g}"][1] += near.proved
                    near_onset[f"{distance:g}"][2] += near.proved and near.bits == DOUBLES
    return {
        "isolators": isolators,
        **tally,
        "families": {name: of_family(rng, name, round(FAMILY_FRACTION * isolators)) for name in FAMILIES[1:]},
        "others": others,
        "beside": near_onset,
        "widths": widths,
        "ratios": ratios,
    }


def table_2() -> float:
    """Seconds for everything of Table 2: folds at its forcings, F_SN and F_cr."""
    isolator = example.isolator()
    forcings = (0.025, 0.03, 0.04, 0.05)
    return best(lambda: [isolator.certify(F_0) for F_0 in forcings])


def joined(chunks: list[dict[str, Any]], name: str) -> list[Any]:
    """One list of all shares."""
    return [one for part in chunks for one in part[name]]


def of_all(chunks: list[dict[str, Any]]) -> dict[str, Any]:
    """What all shares counted."""
    counts = {name: {what: sum(part[name][what] for part in chunks) for what in QUESTIONS} for name in COUNTED}
    return {**counts, "unproved": joined(chunks, "unproved")}


def summed(chunks: list[dict[str, Any]]) -> dict[str, Any]:
    """All shares as one."""
    families = {name: [part["families"][name] for part in chunks] for name in FAMILIES[1:]}
    widths = joined(chunks, "widths")
    return {
        "isolators": sum(part["isolators"] for part in chunks),
        **of_all(chunks),
        "families": {
            name: {**of_all(found), "slowest": max(part["slowest"] for part in found)}
            for name, found in families.items()
        },
        "others": joined(chunks, "others"),
        "beside": {
            name: [sum(part["beside"][name][k] for part in chunks) for k in range(3)] for name in chunks[0]["beside"]
        },
        "width": median(widths),
        "widest": max(widths),
        "ratio": median(joined(chunks, "ratios")),
        "table_2": table_2(),
    }


def median(values: list[float]) -> float:
    """NaN of none."""
    return float(np.median(values)) if values else math.nan
