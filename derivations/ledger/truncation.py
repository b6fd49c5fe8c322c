"""In: the derivation's results, Table 1. Out: Table 2's folds with the force (5) as it is, beside the truncated ones.

The averages are the closed forms by Carlson's R_D. Each fold of the untruncated force is the limit of Newton's steps
from the truncated one, at the ledger's precision: what the truncation moves, not a search for further folds.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb, arb_mat

from ..symbols import F_0, A, h, h_A
from . import published
from .balls import evaluate, significant
from .example import ATTACHED, Example, coefficients
from .facts import Facts

UNTRUNCATED = "rod_spring_untruncated"
#: of difference quotients, and how near Newton's steps have to come to rest; far below the digits shown
STEP, REST = arb(2) ** -80, arb(2) ** -110


class Untruncated:
    """R^2 + I^2 - F_0^2 and half its slope for the untruncated force, at the parameters of an example."""

    def __init__(self, facts: Facts, example: Example) -> None:
        derived = facts.results.mechanisms[UNTRUNCATED]
        self.example, self.u_cr = example, example.u_cr
        self.known = {**example.known, **coefficients(derived, example.parameters)}
        self.regimes = derived.whole.regimes

    def at(self, amplitude: arb) -> dict[Any, Any]:
        """A, h, h_A and the damping."""
        regime = self.regimes[0 if not amplitude > self.u_cr else 1]
        values = {**self.known, A: amplitude}
        for symbol, value in regime.lets:
            values[symbol] = evaluate(value, values)
        force, slope = (evaluate(form, values) for form in regime.derivatives)
        return {**values, h: force, h_A: slope}

    def response(self, frequency: arb, amplitude: arb, forcing: arb) -> arb:
        """F."""
        return self.example.at_Omega("response", frequency, {**self.at(amplitude), F_0: forcing})

    def stability(self, frequency: arb, amplitude: arb) -> arb:
        """F_A/2."""
        return self.example.at_Omega("fold", frequency, self.at(amplitude))

    def fold(self, forcing: arb, frequency: arb, amplitude: arb) -> tuple[arb, arb]:
        """Omega and A of the fold next to a point."""
        return _newton(lambda w, a: [self.response(w, a, forcing), self.stability(w, a)], [frequency, amplitude])

    def onset(self, frequency: arb, amplitude: arb) -> tuple[arb, arb, arb]:
        """F_SN, Omega and A next to a point: F_A = 0 and its slope."""

        def cusp(w: arb, a: arb) -> list[arb]:
            return [
                self.stability(w, a),
                (self.stability(w, a + STEP) - self.stability(w, a - STEP)) / (2 * STEP),
            ]

        w, a = _newton(cusp, [frequency, amplitude])
        return self.response(w, a, arb(0)).sqrt(), w, a

    def detachment(self, frequency: arb) -> tuple[arb, arb]:
        """F_cr and Omega_cr next to a frequency."""

        def peak(w: arb) -> list[arb]:
            return [self.example.at_Omega("peak", w, self.at(self.u_cr))]

        (w,) = _newton(peak, [frequency])
        return self.response(w, self.u_cr, arb(0)).sqrt(), w


def _newton(equations: Callable[..., list[arb]], start: list[arb]) -> list[arb]:
    """Newton's steps by difference quotients, on midpoints; an error if they do not come to rest."""
    x = [arb(value.mid()) for value in start]
    for _ in range(60):
        here = equations(*x)
        columns = [equations(*(v + STEP if j == k else v for j, v in enumerate(x))) for k in range(len(x))]
        slopes = [[(column[i] - here[i]) / STEP for column in columns] for i in range(len(x))]
        step = arb_mat([[arb(s.mid()) for s in row] for row in slopes]).solve(
            arb_mat([[arb(value.mid())] for value in here])
        )
        x = [arb((value - step[k, 0]).mid()) for k, value in enumerate(x)]
        if all(abs(step[k, 0]) < REST for k in range(len(x))):
            return x
    raise ArithmeticError("Newton's steps do not come to rest")


def cost(facts: Facts) -> list[dict[str, str]]:
    """A row for each quantity: what it is, truncated, untruncated, and the relative difference."""
    exact = Untruncated(facts, facts.example)
    onset, detachment = facts.example.onset, facts.example.detachment
    F_SN, *at_onset = exact.onset(onset.Omega, onset.A)
    F_cr, Omega_cr = exact.detachment(detachment.Omega)
    pairs = [
        ("F_SN", onset.F_0, F_SN),
        ("Omega_SN", onset.Omega, at_onset[0]),
        ("A_SN", onset.A, at_onset[1]),
        ("F_cr", detachment.F_0, F_cr),
        ("Omega_cr", detachment.Omega, Omega_cr),
    ]
    for label in forcings(facts):
        for kind in ("jump-up", "jump-down"):
            fold = facts.fold(label, kind)
            w, a = exact.fold(facts.forcing(label), fold.Omega, fold.A)
            if (a > exact.u_cr) == (fold.regime == ATTACHED):
                raise ArithmeticError(f"the fold at {label} changes its regime with the truncation")
            pairs += [(f"F_0 = {label}, {kind} Omega", fold.Omega, w), (f"F_0 = {label}, {kind} A", fold.A, a)]
    return [
        {
            "quantity": name,
            "truncated": significant(truncated),
            "untruncated": significant(untruncated),
            "difference": f"{float((truncated / untruncated - 1).mid()):+.1e}",
        }
        for name, truncated, untruncated in pairs
    ]


def forcings(facts: Facts) -> list[str]:
    """The forcings of Table 2 that are numbers."""
    return [row.F_0 for row in published.TABLE_2 if not row.F_0.startswith("F_")]
