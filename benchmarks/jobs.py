"""What the questions are measured on, for `benchmarks.remote`: slowflow's public interface.

Jobs on Table 1 answer with the numbers that `benchmarks.questions` checks against certified values, batches with the
worst status, and `certified` with the critical forcings of the 200 certified isolators. A batch is named
"kind | question | number of designs"; its kind is "random", "Table 1", "second" (approximation), or "workers N".
"""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from benchmarks import certified
from benchmarks.remote import processor
from slowflow import Isolator
from slowflow.averaged.many import Designs
from slowflow.core.backend import SOLVER
from slowflow.example import TABLE_1, isolator
from slowflow_kernels import rod_spring, slow_flow

Job = tuple[Callable[[], Any], Callable[[Any], dict[str, Any]]]
SAMPLES = 1000
CHECKED = 40
#: questions that have a forcing, which is so much above that at which the mass sticks
FORCED, ABOVE = ("saddle_nodes", "peak", "amplitudes", "frequency_response"), 0.03


def table_1_designs(count: int) -> Designs:
    """Table 1 with lam from 2 to 4: the onset is a cusp below u_cr."""
    return Isolator.many(**{**TABLE_1, "lam": np.linspace(2, 4, count)})


def random_designs(count: int, seed: int = 5) -> Designs:
    """Designs of the size that the test suite's random isolators have; onsets in either regime or on the corner."""
    rng = np.random.default_rng(seed)
    lam, r = rng.uniform(1, 4, count), rng.uniform(0.4, 4, count)
    delta_h = np.minimum(rng.uniform(0.02, 0.97, count) / (lam * r), 0.9)
    mu = np.where(rng.random(count) < 0.15, 0.0, rng.uniform(0, 0.03, count))
    zeta = np.exp(rng.uniform(np.log(0.004), np.log(0.1), count))
    return Isolator.many(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta)


def amplitudes(count: int) -> np.ndarray:
    """From above 0 to beyond the highest peak of Table 1 at F_0 = 0.04."""
    return np.linspace(0.0, 0.65, count + 1)[1:]


def response(at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Every Omega at each amplitude."""
    iso = isolator()
    h, _ = rod_spring.averaged_2(at, iso.alpha, iso.beta, iso.gamma, iso.u_cr)
    return SOLVER.response_roots(at, h, iso.sticking_forcing, iso.zeta, certified.F_0)


def curve(second: bool) -> tuple[Any, Any]:
    """The response curve of Table 1 with its folds, of an isolator made anew."""
    iso: Any = isolator().second_approximation if second else isolator()
    return iso.frequency_response(certified.F_0, samples=SAMPLES), iso.saddle_nodes(certified.F_0)


def locus() -> tuple[Any, Any]:
    """The fold locus of Table 1 with its cusps, likewise."""
    iso = isolator()
    return iso.fold_locus(samples=SAMPLES), iso.cusps()


def batch(kind: str, question: str, count: int) -> Callable[[], Any]:
    """A question about so many designs."""
    designs = table_1_designs(count) if kind == "Table 1" else random_designs(count)
    arguments: dict[str, Any] = {"workers": int(kind.split()[1])} if kind.startswith("workers") else {}
    if question in FORCED:
        arguments["F_0"] = slow_flow.friction(designs.values["mu"]) + ABOVE
    if question == "amplitudes":
        arguments["Omega"] = np.random.default_rng(count).uniform(0.3, 1.5, count)
    return partial(getattr(designs.second_approximation if kind == "second" else designs, question), **arguments)


def clock(name: str) -> Callable[[], float]:
    """What a job is timed by: the processor's time, where it is not about how many of these there are."""
    return time.perf_counter if name.startswith("workers") else processor


# ---- answers as JSON


def listed(*columns: Any) -> dict[str, Any]:
    """Vectors of numbers, one column for each component."""
    return {"found": np.column_stack(columns).tolist()}


def vectors(found: Any) -> dict[str, Any]:
    """Vectors of numbers, one row for each."""
    return {"found": [list(map(float, row)) for row in found]}


def of_curve(found: tuple[Any, Any]) -> dict[str, Any]:
    """Number of points of the curve, and its folds."""
    points, folds = found
    return {"points": len(points), **listed(folds.Omega, folds.A)}


def of_locus(found: tuple[Any, Any]) -> dict[str, Any]:
    """Some points of the locus, evenly, and its lowest cusp."""
    points, cusps = found
    some, lowest = np.linspace(0, len(points) - 1, CHECKED).astype(int), cusps.F_0.argmin()
    cusp = [float(x[lowest]) for x in (cusps.F_0, cusps.Omega, cusps.A)]
    return {"points": len(points), **listed(points.Omega[some], points.A[some]), "cusp": cusp}


def of_response(found: tuple[np.ndarray, np.ndarray]) -> dict[str, Any]:
    """Roots of each amplitude without the unused places."""
    return {"found": [row[:count].tolist() for row, count in zip(*found, strict=True)]}


class Jobs(dict[str, Job]):
    """Jobs by name; a batch, and the response at so many amplitudes, are made when they are first requested."""

    def __missing__(self, name: str) -> Job:
        kind, *question, count = name.split(" | ")
        if kind == "response":
            self[name] = partial(response, amplitudes(int(count))), lambda found: {"points": len(found[0])}
        else:
            self[name] = batch(kind, *question, int(count)), lambda found: {"status": int(found.status.max())}
        return self[name]


def prepare() -> Jobs:
    """Jobs by name."""
    designs = Isolator.many(**certified.designs().parameters)
    return Jobs(
        {
            "curve": (partial(curve, False), of_curve),
            "second curve": (partial(curve, True), of_curve),
            "locus": (locus, of_locus),
            "certified detachment": (designs.detachment, lambda found: listed(found.F_cr, found.Omega_cr)),
            "certified onset": (designs.saddle_node_onset, lambda found: listed(found.F_SN, found.Omega, found.A)),
            "response": (partial(response, amplitudes(SAMPLES)), of_response),
            "folds": (lambda: isolator().saddle_nodes(certified.F_0), lambda found: listed(found.Omega, found.A)),
            "onset": (
                lambda: isolator().saddle_node_onset(),
                lambda found: listed([found.F_SN], [found.Omega], [found.A]),
            ),
        }
    )
