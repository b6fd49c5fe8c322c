"""Values to measure errors against: Table 1 and 200 random isolators from tests/data, where each digit is proved, and
roots at 40 digits for any amplitude, from formulas of their own.

In:  amplitudes as doubles, taken exactly. Out: mpmath numbers.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np

from slowflow.example import TABLE_1

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
    """The averaged equations of Table 1 at 40 digits, the missing force integrated over the detached arc."""

    def __init__(self) -> None:
        with mpmath.workdps(DIGITS):
            lam, r, delta_h, mu, self.zeta = (mpmath.mpf(TABLE_1[key]) for key in TABLE_1)
            self.alpha = 1 - lam * r * delta_h
            self.beta = lam / 2 * r * (1 - delta_h)
            self.gamma = lam * r * (1 - delta_h) * 3 / 8
            self.u_cr = mpmath.sqrt(delta_h * (2 - delta_h))
            self.m = 4 * mu / mpmath.pi

    def averaged(self, A: float) -> tuple[Number, Number]:
        """h and dh/dA."""
        k = (self.alpha - 1, self.beta, self.gamma)
        with mpmath.workdps(DIGITS):
            A = mpmath.mpf(A)
            # 1/pi times the integral of cos^(2n) over a cycle
            weights = [mpmath.mpf(1), mpmath.mpf(3) / 4, mpmath.mpf(5) / 8]
            jump = mpmath.mpf(0)
            if A > self.u_cr:
                c = self.u_cr / A
                s, arc = mpmath.sqrt(1 - c * c), mpmath.acos(c)
                # the same over the detached arcs only
                C_2 = (arc + s * c) / 2
                C_4 = (3 * C_2 + s * c**3) / 4
                C_6 = (5 * C_4 + s * c**5) / 6
                weights = [w - 4 / mpmath.pi * C for w, C in zip(weights, (C_2, C_4, C_6), strict=True)]
                force = sum(k_n * self.u_cr ** (2 * n + 1) for n, k_n in enumerate(k))
                jump = 4 / mpmath.pi * force * c * c / (A * s)
            h = -A - sum(w * k_n * A ** (2 * n + 1) for n, (w, k_n) in enumerate(zip(weights, k, strict=True)))
            h_A = -1 - sum(
                (2 * n + 1) * w * k_n * A ** (2 * n) for n, (w, k_n) in enumerate(zip(weights, k, strict=True))
            )
            return h, h_A + jump

    def response(self, A: float) -> list[Number]:
        """All positive Omega with F = 0 (24), rising."""
        h, _ = self.averaged(A)
        with mpmath.workdps(DIGITS):
            A, F = mpmath.mpf(A), mpmath.mpf(F_0)
            return self._positive(
                [1, 0, 4 * self.zeta**2 + 2 * h / A, 4 * self.zeta * self.m / A, (h * h + self.m**2 - F * F) / A**2]
            )

    def fold(self, A: float) -> list[Number]:
        """All positive Omega with F_A = 0 (30), rising."""
        h, h_A = self.averaged(A)
        with mpmath.workdps(DIGITS):
            A = mpmath.mpf(A)
            return self._positive([1, 0, h_A + h / A + 4 * self.zeta**2, 2 * self.zeta * self.m / A, h * h_A / A])

    def fold_error(self, Omega: float, A: float) -> float:
        """Error of a point of the fold locus in u (1 + kappa), kappa the condition of its Omega in A.

        Just above u_cr, kappa is without bound: dh/dA goes to infinity there.
        """
        with mpmath.workdps(DIGITS):
            step = mpmath.mpf(10) ** (-DIGITS // 2)
            roots = self.fold(A)
            nearest = min(range(len(roots)), key=lambda i: abs(roots[i] - Omega))
            exact, neighbour = roots[nearest], self.fold(mpmath.mpf(A) * (1 + step))[nearest]
            kappa = abs(neighbour / exact - 1) / step
            return float(abs(Omega / exact - 1) / (1 + kappa) / U)

    @staticmethod
    def _positive(coefficients: Sequence[Number]) -> list[Number]:
        roots = mpmath.polyroots(coefficients, maxsteps=200, extraprec=200)
        near = mpmath.mpf(10) ** (5 - DIGITS)
        return sorted(z.real for z in roots if abs(z.imag) <= near * abs(z) and z.real > 0)


def _digits(text: str) -> Number:
    with mpmath.workdps(DIGITS + 5):
        return mpmath.mpf(text)


def _exact(number: Any) -> Fraction:
    return Fraction(float.fromhex(number[0])) if isinstance(number, list) else Fraction(number)
