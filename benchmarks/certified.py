"""Values to measure errors against: Table 1 and 200 random isolators from tests/data, where each digit is proved, and
roots at 40 digits for any amplitude.

In:  amplitudes as doubles, taken exactly. Out: mpmath numbers.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
from flint import arb

from slowflow.example import TABLE_1
from tests.oracles.averaged import BITS, RodSpring, digits, exact
from tests.oracles.certified_roots import precision

DATA = Path(__file__).resolve().parents[1] / "tests" / "data"
F_0 = 0.04
DIGITS = 40
U = 2.0**-53
Number = Any


def case() -> dict[str, Any]:
    """Table 1 with its parameters as doubles, not the decimals that they stand for."""
    cases = json.loads((DATA / "table_1.json").read_text())
    return next(c for c in cases if isinstance(c["parameters"]["mu"], list))


def folds() -> list[tuple[Number, Number]]:
    """(Omega, A) of both folds at F_0 = 0.04, by rising Omega."""
    at = next(f for f in case()["forcings"] if _exact(f["F_0"]) == Fraction(F_0))
    return [(_digits(fold["Omega"]), _digits(fold["A"])) for fold in at["folds"]]


def onset() -> tuple[Number, Number, Number]:
    """F_SN and its Omega and A."""
    F_SN, Omega, A = (_digits(case()["onset"][key]) for key in ("F_SN", "Omega", "A"))
    return F_SN, Omega, A


@dataclass(frozen=True)
class Designs:
    """Isolators with certified critical forcings: parameters by name as arrays, rows of values as digits."""

    parameters: dict[str, np.ndarray]
    detachment: list[tuple[Number, Number]]
    onset: list[tuple[Number, Number, Number]]


def designs() -> Designs:
    """The 200 random isolators."""
    cases = json.loads((DATA / "random_isolators.json").read_text())
    return Designs(
        {name: np.array([float(_exact(c["parameters"][name])) for c in cases]) for name in TABLE_1},
        [tuple(_digits(c["detachment"][key]) for key in ("F_cr", "Omega_cr")) for c in cases],
        [tuple(_digits(c["onset"][key]) for key in ("F_SN", "Omega", "A")) for c in cases],
    )


def relative_error(value: float, exact: Number) -> float:
    """|value/exact - 1|."""
    with mpmath.workdps(DIGITS):
        return float(abs(mpmath.mpf(value) / exact - 1))


def motion() -> Number:
    """A of the motion that `benchmarks.motions` follows, the lower one of two at its frequency."""
    return min(_digits(case["A"]) for case in _exact_cases() if case["Omega"] == 0.9)


def exact_folds() -> list[Number]:
    """Omega of the folds of the equation of motion at F_0 = 0.04, by rising Omega."""
    return sorted(_digits(case["Omega"]) for case in _exact_cases() if case["fold"])


def _exact_cases() -> list[dict[str, Any]]:
    """Motions and folds of Table 1, untruncated, to 40 digits."""
    cases = json.loads((DATA / "exact_motions.json").read_text())
    return [case for case in cases if case["force"] == "untruncated" and case["numbers"] == TABLE_1]


class Table1:
    """The averaged equations of Table 1, whose roots are enclosed."""

    def __init__(self) -> None:
        self._of = RodSpring(**TABLE_1)

    def response(self, A: float) -> list[Number]:
        """All positive Omega with F = 0 (24), rising."""
        return [_digits(digits(Omega)) for Omega in self._of.frequencies(A, F_0)]

    def fold_error(self, Omega: float, A: float) -> float:
        """Error of a point of the fold locus in u (1 + kappa), kappa the condition of its Omega in A.

        Just above u_cr, kappa is without bound: dh/dA goes to infinity there.
        """
        with precision(BITS):
            at, step, found = arb(exact(A)), arb(10) ** -DIGITS, arb(exact(Omega))
            root = min(self._of.fold_frequencies(at), key=lambda one: float(abs(one - found).mid()))
            neighbours = self._of.fold_frequencies((at * (1 + step)).mid())
            kappa = min((abs(one / root - 1) for one in neighbours), key=lambda one: float(one.mid())) / step
            return float((abs(found / root - 1) / (1 + kappa)).mid()) / U


def _digits(text: str) -> Number:
    with mpmath.workdps(DIGITS + 5):
        return mpmath.mpf(text)


def _exact(number: Any) -> Fraction:
    return Fraction(float.fromhex(number[0])) if isinstance(number, list) else Fraction(number)
