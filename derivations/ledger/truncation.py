"""In: the derivation's results, Table 1. Out: Table 2's folds with the force (5) as it is, beside the truncated ones.

The averages are the closed forms by Carlson's integrals. Each fold of the untruncated force is the limit of Newton's
steps from the truncated one, at the ledger's precision: what the truncation moves, not a search for further folds.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from flint import arb, arb_mat

from ..mechanisms.rod_spring import delta_h
from ..paper.restoring_force import Regime
from ..results import Results
from ..symbols import F_0, A, h, h_A
from . import published
from .balls import ball, evaluate, significant
from .example import ATTACHED, Example, Point, Polynomials, coefficients
from .facts import Facts

UNTRUNCATED = "rod_spring_untruncated"
#: of difference quotients, and how near Newton's steps have to come to rest; far below the digits shown
STEP, REST = arb(2) ** -80, arb(2) ** -110


class Untruncated(Example):
    """An example with the averages of the untruncated force: the equations of its points are the same."""

    def __init__(self, results: Results, of: Polynomials, parameters: Mapping[str, Fraction]) -> None:
        super().__init__(results, of, parameters)
        derived = results.mechanisms[UNTRUNCATED]
        self.known |= coefficients(derived, parameters) | {delta_h: ball(parameters["delta_h"])}
        self.regimes = derived.whole.regimes

    def attached(self, amplitude: Any) -> dict[Any, Any]:
        """A, h, h_A and the damping for A <= u_cr."""
        return self._by(self.regimes[0], amplitude)

    def at(self, amplitude: arb) -> dict[Any, Any]:
        """The same on the side of u_cr where the amplitude lies."""
        return self._by(self.regimes[1], amplitude) if amplitude > self.u_cr else self.attached(amplitude)

    def _by(self, regime: Regime, amplitude: Any) -> dict[Any, Any]:
        values = {**self.known, A: amplitude}
        for symbol, value in regime.lets:
            values[symbol] = evaluate(value, values)
        force, slope = (evaluate(form, values) for form in regime.derivatives[:2])
        return {**values, h: force, h_A: slope}

    def fold_near(self, point: Point) -> list[arb]:
        """Omega and A of the fold next to a point, at its forcing."""

        def fold(w: arb, a: arb) -> list[arb]:
            return [self.at_Omega("response", w, {**self.at(a), F_0: point.F_0}), self.stability(w, a)]

        return _newton(fold, [point.Omega, point.A])

    def onset_near(self, point: Point) -> list[arb]:
        """Omega and A next to a point where F_A and its slope vanish."""

        def cusp(w: arb, a: arb) -> list[arb]:
            return [self.stability(w, a), (self.stability(w, a + STEP) - self.stability(w, a - STEP)) / (2 * STEP)]

        return _newton(cusp, [point.Omega, point.A])


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
    exact = Untruncated(facts.results, facts.example.polynomials, facts.example.parameters)
    onset, detachment = facts.example.onset, facts.example.detachment
    at_onset = exact.onset_near(onset)
    pairs = [
        ("F_SN", onset.F_0, exact.forcing(*at_onset)),
        ("Omega_SN", onset.Omega, at_onset[0]),
        ("A_SN", onset.A, at_onset[1]),
        ("F_cr", detachment.F_0, exact.detachment.F_0),
        ("Omega_cr", detachment.Omega, exact.detachment.Omega),
    ]
    for label in (row.F_0 for row in published.TABLE_2 if not row.F_0.startswith("F_")):
        for kind in ("jump-up", "jump-down"):
            fold = facts.fold(label, kind)
            w, a = exact.fold_near(fold)
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
