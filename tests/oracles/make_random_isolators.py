"""Seeds in; tests/data/*.json out: certified reference values for random oscillators and for the paper's Table 1.

    python -m tests.oracles.make_random_isolators

writes table_1.json, random_isolators.json (200 isolators), random_duffing.json (20 Duffing oscillators, hardening and
softening) and negative_stiffness.json (10 isolators with alpha < 0). The same seeds give the same bytes. Every number
comes from `averaged`; at each forcing the number of folds is found twice, by isolating the folds and by the extrema of
the fold locus, and a disagreement stops the run. data/README.md says what the fields mean.
"""

import math
import random
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from multiprocessing import Pool
from typing import Any

from flint import arb

from derivations.ledger import published
from tests.files import store
from tests.oracles.averaged import BITS, CORNER, Duffing, Number, Oscillator, Point, RodSpring, digits
from tests.oracles.certified_roots import precision
from tests.oracles.conditioning import Condition, Conditioning

SEED = "slowflow 2025"
MECHANISMS: dict[str, type[Oscillator]] = {"rod_spring": RodSpring, "duffing": Duffing}


# ---- the draws -----------------------------------------------------------------------------------------------------


def draw_isolator(rng: random.Random, fraction: tuple[float, float] = (0.02, 0.97)) -> dict[str, float]:
    """lam 1-4 (half of them integer), r 0.4-4, delta_h a fraction of its quasi-zero-stiffness value and below 0.9."""
    lam = float(rng.randint(1, 4)) if rng.random() < 0.5 else rng.uniform(1, 4)
    r = delta_h = math.inf
    while not delta_h < 0.9:
        r = rng.uniform(0.4, 4)
        delta_h = rng.uniform(*fraction) / (lam * r)
    return {"lam": lam, "r": r, "delta_h": delta_h, **draw_damping(rng, 0.15)}


def draw_damping(rng: random.Random, frictionless: float) -> dict[str, float]:
    """mu 0-0.03, exactly 0 with the given probability, and zeta 0.004-0.1, log-uniform."""
    mu = 0.0 if rng.random() < frictionless else rng.uniform(0, 0.03)
    return {"mu": mu, "zeta": log_uniform(rng, 0.004, 0.1)}


def draw_duffing(rng: random.Random, index: int) -> dict[str, float]:
    """alpha 0.2-2, |beta| 0.1-10, softening at every second index."""
    beta = log_uniform(rng, 0.1, 10)
    return {"alpha": rng.uniform(0.2, 2), "beta": -beta if index % 2 else beta, **draw_damping(rng, 0.35)}


def log_uniform(rng: random.Random, low: float, high: float) -> float:
    """A number whose logarithm is uniform."""
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def draw_forcing(rng: random.Random, oscillator: Oscillator) -> tuple[float, str]:
    """A forcing above 4 mu/pi and the reason it was chosen."""
    m = _float(oscillator.m)
    onset = oscillator.onset()
    if onset is None:
        return m + log_uniform(rng, 0.01, 1), "any"
    levels = [_float(p.F_0) for p in oscillator.extrema]
    F_SN = _float(onset.F_0)
    choice = rng.random()
    if choice < 0.1 and 0.98 * F_SN > 1.001 * m:
        return 0.98 * F_SN, "just below the onset"
    if choice < 0.2:
        return 1.02 * F_SN, "just above the onset"
    if choice < 0.35 and oscillator.u_cr is not None:
        F_cr = _float(oscillator.detachment().F_0)
        return F_cr * rng.uniform(0.98, 1.05), "around F_cr"
    if choice < 0.5 and len(levels) > 1:
        k = rng.randrange(len(levels) - 1)
        fraction = rng.uniform(0.05, 0.95)
        return levels[k] + fraction * (levels[k + 1] - levels[k]), "between two extrema of the fold locus"
    return log_uniform(rng, max(1.05 * m, 0.6 * F_SN), 6 * F_SN), "any"


def draw_frequencies(rng: random.Random, folds: list[Point], peaks: list[Point]) -> list[float]:
    """One frequency anywhere, one in the range of the folds, one between two neighbouring folds or near the peak."""
    at = [_float(p.Omega) for p in folds]
    tops = [_float(p.Omega) for p in peaks if p.sense == "max"]
    chosen = [rng.uniform(0.2, 1.9)]
    if len(at) > 1:
        chosen.append(rng.uniform(at[0], at[-1]))
        k = rng.randrange(len(at) - 1)
        chosen.append(rng.uniform(at[k], at[k + 1]))
    else:
        centre = at[0] if at else tops[-1] if tops else 1.0
        chosen += [centre * rng.uniform(0.9, 1.1), centre * rng.uniform(0.98, 1.02)]
    return chosen


# ---- the records ---------------------------------------------------------------------------------------------------


def _float(x: arb) -> float:
    return float(x.mid())


def encoded(x: Number) -> list[Any] | str:
    """A float as [hex, number]; an exact fraction as text."""
    return f"{x.numerator}/{x.denominator}" if isinstance(x, Fraction) else [float(x).hex(), float(x)]


def conditions(c: Condition | None) -> dict[str, Any]:
    """The condition numbers of a point, to three digits."""
    if c is None:
        return {"condition": None, "condition_kernel": None}
    return {
        "condition": {k: float(f"{v:.3g}") for k, v in c.inputs.items()},
        "condition_kernel": {k: float(f"{v:.3g}") for k, v in c.kernel.items()},
    }


def row(p: Any, names: str, condition: Condition | None, **more: Any) -> dict[str, Any]:
    """What is recorded of a point or a state: numbers to forty digits, words, and its condition."""
    found: dict[str, Any] = {}
    for name in names.split():
        one = p.regime == CORNER if name == "corner" else more[name] if name in more else getattr(p, name)
        found[name] = one if isinstance(one, (str, bool)) else digits(one)
    return {**found, **conditions(condition)}


def answered(
    oscillator: Oscillator,
    folds: Sequence[Point],
    F_0: Number,
    frequencies: Sequence[Number],
    of_folds: str = "Omega A kind corner",
    of_states: str = "A phi stable",
    before: Callable[[Any], dict[str, Any]] = lambda one: {},
) -> dict[str, Any]:
    """Folds and the states at some frequencies, each after what `before` says of it."""
    conditioning = Conditioning(oscillator)
    with precision(BITS):
        shown = [{**before(p), **row(p, of_folds, conditioning.fold(p))} for p in folds]
    states = []
    for Omega in frequencies:
        steady = oscillator.amplitudes(Omega, F_0)
        with precision(BITS):
            rows = [{**before(a), **row(a, of_states, conditioning.amplitude(a, Omega, F_0))} for a in steady]
        states.append({"Omega": encoded(Omega), "steady": rows})
    return {"folds": shown, "amplitudes": states}


def forcing_record(oscillator: Oscillator, F_0: Number, why: str, rng: random.Random) -> dict:
    """All that is recorded at one forcing."""
    folds = oscillator.folds(F_0)
    if len(folds) != oscillator.fold_count(F_0):
        raise AssertionError(f"{len(folds)} folds found, {oscillator.fold_count(F_0)} counted: {oscillator.parameters}")
    peaks = oscillator.peaks(F_0)
    top = max((_float(p.A) for p in peaks), default=1.0)
    amplitudes = [top * rng.uniform(0.02, 1.1) for _ in range(5)]
    rows = []
    for A in amplitudes:
        Omega = oscillator.frequencies(A, F_0)
        rows.append({"A": encoded(A), "count": len(Omega), "Omega": [digits(x) for x in Omega]})
    frequencies = draw_frequencies(rng, folds, peaks)
    known = answered(oscillator, folds, F_0, frequencies, "Omega A kind corner regime", "A phi stable regime")
    return {
        "F_0": encoded(F_0),
        "chosen": why,
        "folds": known["folds"],
        "peaks": [{"Omega": digits(p.Omega), "A": digits(p.A), "sense": p.sense, "regime": p.regime} for p in peaks],
        "frequencies": rows,
        "amplitudes": known["amplitudes"],
    }


def case_record(
    mechanism: str, parameters: dict[str, Number], forcings: list[tuple[Number, str]] | None, rng: random.Random
) -> dict:
    """One oscillator with everything about it; three drawn forcings unless they are given."""
    oscillator = MECHANISMS[mechanism](**parameters)
    conditioning = Conditioning(oscillator)
    with precision(BITS):
        onset, ends = oscillator.onset(), oscillator.ends
        record: dict[str, Any] = {
            "mechanism": mechanism,
            "parameters": {k: encoded(v) for k, v in parameters.items()},
            **{k: digits(arb(getattr(oscillator, k))) for k in ("alpha", "beta", "gamma")},
            "m": digits(oscillator.m),
        }
        if oscillator.u_cr is not None:
            d = oscillator.detachment()
            record["u_cr"] = digits(oscillator.u_cr)
            record["detachment"] = {
                "F_cr": digits(d.F_0),
                "Omega_cr": digits(d.Omega),
                "attained": d.sense == "min",
                **conditions(conditioning.detachment(d)),
            }
        extrema = [row(p, "F_0 Omega A kind sense regime", conditioning.extremum(p)) for p in oscillator.extrema]
        record["onset"] = None
        if onset is not None:
            lowest = extrema[oscillator.extrema.index(onset)]
            record["onset"] = {
                "F_SN": lowest["F_0"],
                "global": all(onset.F_0 < level for level, trend, _ in ends if trend > 0),
                **{k: v for k, v in lowest.items() if k not in ("F_0", "sense")},
            }
        record["fold_locus"] = {
            "extrema": extrema,
            "ends": [{"F_0": digits(level), "A": digits(A), "trend": trend} for level, trend, A in ends],
        }
        if forcings is None:
            forcings = [draw_forcing(rng, oscillator) for _ in range(3)]
    record["forcings"] = [forcing_record(oscillator, F_0, why, rng) for F_0, why in forcings]
    return record


# ---- the files -------------------------------------------------------------------------------------------------------


#: by file: a word of the seed, mechanism, how many, what draws numbers; stiffness is negative above a fraction of 1
FILES: dict[str, tuple[str, str, int, Callable[[random.Random, int], dict[str, float]]]] = {
    "random_duffing": ("duffing", "duffing", 20, draw_duffing),
    "negative_stiffness": ("negative", "rod_spring", 10, lambda rng, _: draw_isolator(rng, (1.01, 1.5))),
    "random_isolators": ("isolator", "rod_spring", 200, lambda rng, _: draw_isolator(rng)),
}


def drawn_case(file: str, index: int) -> dict:
    """Random oscillator number `index` of a file."""
    word, mechanism, _, draw = FILES[file]
    rng = random.Random(f"{SEED} {word} {index}")
    return case_record(mechanism, draw(rng, index), None, rng)


def table_1_cases() -> list[dict]:
    """The paper's isolator: as exact rationals with exact decimal forcings, and as the nearest doubles."""
    cases = []
    for convert in (Fraction, float):
        parameters: dict[str, Number] = {k: convert(v) for k, v in published.TABLE_1.items()}
        F_cr = _float(RodSpring(**parameters).detachment().F_0)
        chosen: list[tuple[Number, str]] = [
            (convert(Fraction(text)), "given") for text in ("0.025", "0.03", "0.03005", "0.0301", "0.04", "0.05")
        ]
        chosen.append((F_cr, "the double nearest to F_cr"))
        cases.append(case_record("rod_spring", parameters, chosen, random.Random(f"{SEED} table 1")))
    return cases


def main() -> None:
    store("table_1", table_1_cases())
    with Pool(2) as pool:
        for file, (_, _, count, _) in FILES.items():
            store(file, pool.map(partial(drawn_case, file), range(count), chunksize=1))


if __name__ == "__main__":
    main()
