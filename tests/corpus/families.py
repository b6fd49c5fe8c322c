"""The families of the corpus: seeded designs and the questions put to each of them.

A family is a generator of (question, answer) pairs at a size: the number of designs. A refusal is an answer too.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from slowflow import Duffing, Isolator, SlowflowError, derive
from tests.batch_questions import OFF_CENTRE, SECOND, ask
from tests.oracles.draws import drawn_isolators, forcings

Pairs = Iterator[tuple[str, Any]]

#: of one design at a forcing F_0: every question with an answer of its own
SINGLE: dict[str, Callable[[Any, float], Any]] = {
    "saddle_node_onset": lambda one, F_0: one.saddle_node_onset(),
    "detachment": lambda one, F_0: one.detachment(),
    "saddle_nodes": lambda one, F_0: one.saddle_nodes(F_0),
    "peak": lambda one, F_0: one.peak(F_0),
    "amplitudes": lambda one, F_0: one.amplitudes(Omega=0.9, F_0=F_0),
    "frequency_response": lambda one, F_0: one.frequency_response(F_0, samples=60),
    "margins": lambda one, F_0: one.margins(F_0),
    "hysteresis": lambda one, F_0: one.hysteresis(F_0),
    "isolation": lambda one, F_0: one.isolation(F_0),
    "spectrum": lambda one, F_0: one.spectrum(Omega=(0.8, 1.1), F_0=F_0),
}
#: these too where motions are about the centre
CENTRED = {
    "cusps": lambda one, F_0: one.cusps(),
    "isola_points": lambda one, F_0: one.isola_points(),
    "fold_locus": lambda one, F_0: one.fold_locus(samples=60),
    "certify": lambda one, F_0: one.certify(F_0, Omega=0.9),
}
#: answers of these have a gradient
GRADIENTS = ("saddle_node_onset", "detachment", "saddle_nodes", "peak", "amplitudes")
BATCH = ("saddle_node_onset", "detachment", "saddle_nodes", "peak", "amplitudes")
EXACT: dict[str, Callable[[Any, float], Any]] = {
    "steady_state": lambda one, F_0: one.steady_state(Omega=0.9, F_0=F_0),
    "sweep": lambda one, F_0: one.sweep(F_0=F_0, Omega=[0.8, 0.9, 1.0]),
    "transient": lambda one, F_0: one.transient(acceleration=F_0, duration=2.0),
    "exact_response": lambda one, F_0: one.exact_response(F_0, Omega=(0.8, 1.1), step=0.1),
}


def answer(question: Callable[[], Any]) -> Any:
    """The answer, or the refusal."""
    try:
        return question()
    except SlowflowError as refusal:
        return refusal


def drawn(rng: np.random.Generator, low: float, high: float, size: int, zero: float = 0.0) -> np.ndarray:
    """Uniform in log10 between the exponents; a share `zero` is 0."""
    return np.where(rng.random(size) < zero, 0.0, 10.0 ** rng.uniform(low, high, size))


def damping(rng: np.random.Generator, n: int) -> dict[str, Any]:
    return {"mu": drawn(rng, -4, -1.5, n, 0.1), "zeta": drawn(rng, -3, -1, n, 0.1)}


def isolators(rng: np.random.Generator, n: int) -> dict[str, Any]:
    return {"lam": rng.integers(1, 5, n), "r": rng.uniform(0.3, 4, n), "delta_h": rng.uniform(0, 0.5, n)}


def duffings(rng: np.random.Generator, n: int) -> dict[str, Any]:
    return {"alpha": np.where(rng.random(n) < 0.1, 0.0, rng.uniform(0.1, 2, n)), "beta": rng.uniform(-0.5, 2, n)}


Draw = Callable[[np.random.Generator, int], dict[str, Any]]


def designs(draw: Draw, n: int, seed: int) -> tuple[dict[str, Any], np.ndarray]:
    """Parameters of n designs by column, and a forcing of each."""
    rng = np.random.default_rng(seed)
    return {**draw(rng, n), **damping(rng, n)}, drawn(rng, -2.5, -0.5, n)


def batch(kind: Any, draw: Draw, seed: int, questions: tuple[str, ...] = BATCH, **fixed: Any) -> Callable[[int], Pairs]:
    """Questions about all designs at once."""

    def pairs(n: int) -> Pairs:
        columns, F_0 = designs(draw, n, seed)
        many = kind.many(**columns, **fixed)
        for name in questions:
            yield name, answer(lambda name=name: ask(many, name, F_0))

    return pairs


def single(
    kind: Any, draw: Draw, seed: int, questions: dict[str, Callable[[Any, float], Any]], unit: float = 1.0, **fixed: Any
) -> Callable[[int], Pairs]:
    """Questions about one design after the other, with gradients where there are some; `unit` is that of F_0."""

    def pairs(n: int) -> Pairs:
        columns, forcing = designs(draw, n, seed)
        for k, F_0 in enumerate((unit * forcing).tolist()):
            one = answer(lambda k=k: kind(**{name: column[k].item() for name, column in columns.items()}, **fixed))
            if isinstance(one, SlowflowError):
                yield "design", one
                continue
            for name, question in questions.items():
                found = answer(lambda one=one, question=question, F_0=F_0: question(one, F_0))
                yield name, found
                if name in GRADIENTS and not isinstance(found, SlowflowError):
                    yield f"{name}.gradient", answer(lambda found=found: found.gradient())

    return pairs


def mount(lam: int, r: float, delta_h: float, mu: float, zeta: float) -> Any:
    """The same designs as data sheets in SI units."""
    return Isolator.physical(
        m=12.0,
        k_v=2500.0,
        k_h=2500.0 * r,
        n=lam,
        L=0.08,
        preload=0.08 * delta_h,
        friction=200.0 * mu,
        zeta=zeta,
        force="truncated",
    )


IN_UNITS: dict[str, Callable[[Any, float], Any]] = {
    name: question for name, question in SINGLE.items() if name not in ("amplitudes", "frequency_response", "spectrum")
}
IN_UNITS |= {
    "amplitudes": lambda one, F_0: one.amplitudes(f=2.1, F=F_0),
    "frequency_response": lambda one, F_0: one.frequency_response(F_0, samples=60),
    "at_rest": lambda one, F_0: one.at_rest(),
}


def at_the_onset(n: int) -> Pairs:
    """Folds next to the lowest forcing that has some, where rounding may decide how many there are."""
    columns, _ = designs(isolators, n, 71)
    onset = Isolator.many(**columns).saddle_node_onset().F_SN
    for k in np.flatnonzero(np.isfinite(onset)):
        one = Isolator(**{name: column[k].item() for name, column in columns.items()})
        for step in (-(2.0**-40), -(2.0**-52), 0.0, 2.0**-52, 2.0**-40):
            F_0 = float(onset[k]) * (1 + step)
            yield "saddle_nodes", answer(lambda one=one, F_0=F_0: one.saddle_nodes(F_0))


def undecided(n: int) -> Pairs:
    """Counts at hard places: designs next to quasi-zero stiffness, forcings next to those at which counts change."""
    rng = np.random.default_rng(72)
    lam, r, delta_h, mu, zeta = drawn_isolators(rng, n)
    many = Isolator.many(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta)
    F_0 = forcings(rng, many, mu)
    yield "saddle_nodes", answer(lambda: many.saddle_nodes(F_0))
    yield "amplitudes", answer(lambda: many.amplitudes(Omega=0.9, F_0=F_0))
    yield "certify", answer(lambda: many.certify(F_0, Omega=0.9))


def grid(stored: bool) -> Callable[[int], Pairs]:
    """Maps over two named axes, in memory or in stores."""

    def pairs(n: int) -> Pairs:
        import xarray

        r, preload = (
            xarray.DataArray(values, dims=name, coords={name: values})
            for name, values in (("r", np.linspace(0.5, 3.0, n)), ("share", np.linspace(0.1, 1.1, n)))
        )
        r = r.chunk({"r": 16}) if stored else r
        designs = Isolator.many(lam=2, r=r, delta_h=preload / (2 * r), mu=0.012, zeta=0.02)
        questions = {
            "detachment": {},
            "saddle_node_onset": {},
            "saddle_nodes": {"F_0": 0.05},
            "isolation": {"F_0": 0.05},
        }
        with tempfile.TemporaryDirectory() as folder:
            for name, arguments in questions.items():
                if stored:
                    store = str(Path(folder) / f"{name}.zarr")
                    found = answer(
                        lambda name=name, arguments=arguments, store=store: designs.store(store, name, **arguments)
                    )
                else:
                    found = answer(lambda name=name, arguments=arguments: getattr(designs, name)(**arguments))
                for column in () if isinstance(found, SlowflowError) else sorted(found.data_vars):
                    yield f"{name}.{column}", found[column].values
                if isinstance(found, SlowflowError):
                    yield name, found

    return pairs


def derived(compile: bool) -> Callable[[int], Pairs]:
    """Forces derived at run time; as many of them as the size says, three designs each."""

    def pairs(n: int) -> Pairs:
        import sympy as sp

        u, k, gap = sp.symbols("u k gap", positive=True)
        numbers = {"k": {"above": 0}, "gap": {"above": 0}}
        forces: list[tuple[list[Any], dict[str, Any]]] = [
            ([(u, gap), (u + k * (u - gap), None)], {}),
            ([(u + k * u**3, None)], {}),
            ([(u - k * u**3 / 5 + u**5, None)], {}),
            ([(u, gap), (u + k * (u - gap) ** 2, 2 * gap), (u + k * gap * (2 * u - 3 * gap), None)], {}),
            ([(u + k * u**3 + u**7, gap), (u + k * u**3 + u**7 + 2 * (u - gap), None)], {}),
            ([(u, gap), (u + k * (u - gap) ** sp.Rational(3, 2), None)], {}),
            ([(u + k * sp.atan(u / gap), None)], {}),
            ([(gap / 10 + u, None)], {}),
        ]
        for number, (pieces, more) in enumerate(forces[:n]):
            used = {str(name) for piece in pieces for part in piece if part is not None for name in part.free_symbols}
            of = {name: bounds for name, bounds in numbers.items() if name in used}
            mechanism = derive.mechanism(f"corpus_{number}", pieces, of, compile=compile, **more)
            for values in ({"k": 1.0, "gap": 0.2}, {"k": 4.0, "gap": 0.1}, {"k": 0.3, "gap": 0.5}):
                one = mechanism(**{name: values[name] for name in of}, mu=0.01, zeta=0.02)
                for name, question in SINGLE.items():
                    yield f"{number}.{name}", answer(lambda one=one, question=question: question(one, 0.05))

    return pairs


class Family(NamedTuple):
    """Pairs at a size, the size of `make corpus`, and that of the sample in `make test`."""

    pairs: Callable[[int], Pairs]
    size: int
    sample: int


LAWS = {"eta": {"eta": 0.05}, "c_2": {"c_2": 0.1}, "attached": {"contact": "attached"}}
LAWS |= {"c_3": {"c_3": 0.5}, "zeta_2": {"zeta_2": 0.5}}

FAMILIES: dict[str, Family] = {
    "batch isolator": Family(batch(Isolator, isolators, 11), 1_000_000, 200),
    "batch duffing": Family(batch(Duffing, duffings, 12), 200_000, 200),
    "batch untruncated": Family(batch(Isolator, isolators, 13, force="untruncated"), 20_000, 50),
    "batch base": Family(batch(Isolator, isolators, 14, excitation="base"), 20_000, 50),
    "batch unbalance": Family(batch(Duffing, duffings, 15, excitation="unbalance"), 20_000, 50),
    "batch second": Family(
        batch(Isolator, isolators, 16, tuple(f"second_approximation.{name}" for name in SECOND)), 500, 5
    ),
    "batch load": Family(batch(Isolator, isolators, 17, OFF_CENTRE[:6], load=0.02), 40, 1),
    "single isolator": Family(single(Isolator, isolators, 21, SINGLE | CENTRED), 3_000, 5),
    "single duffing": Family(single(Duffing, duffings, 22, SINGLE | CENTRED), 3_000, 5),
    "single untruncated": Family(single(Isolator, isolators, 23, SINGLE | CENTRED, force="untruncated"), 1_000, 2),
    "single base": Family(single(Isolator, isolators, 24, SINGLE, excitation="base"), 1_000, 2),
    "single unbalance": Family(single(Isolator, isolators, 25, SINGLE, excitation="unbalance"), 1_000, 2),
    "single load": Family(single(Isolator, isolators, 26, SINGLE, load=0.02), 40, 1),
    "physical": Family(single(mount, isolators, 27, IN_UNITS, unit=200.0), 500, 3),
    **{
        f"damping {name}": Family(single(Isolator, isolators, 31 + k, SINGLE, **law), 40, 1)
        for k, (name, law) in enumerate(LAWS.items())
    },
    "exact isolator": Family(single(Isolator, isolators, 41, EXACT), 250, 2),
    "exact duffing": Family(single(Duffing, duffings, 42, EXACT), 250, 2),
    "at the onset": Family(at_the_onset, 700, 5),
    "undecided": Family(undecided, 100_000, 200),
    "grid": Family(grid(stored=False), 40, 3),
    "store": Family(grid(stored=True), 20, 2),
    "derived": Family(derived(compile=False), 8, 1),
    "derived compiled": Family(derived(compile=True), 8, 0),
}
