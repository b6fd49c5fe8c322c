"""Against Landau and Lifshitz: where the averaged response of the oscillator with a cubic term begins to jump, exactly.

The onset in closed form: F_AA = 0 is linear in A^2, and what F_A = 0 then leaves is two quadratics in Omega.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy as sp

from ...symbols import F_0, A, Omega, h, zeta
from ..balls import ball, evaluate, significant
from ..proofs import canonical
from ..rows import TRUE
from . import Claims, Derived, Judge, approximates, value

#: displacements are over a length of 1: frequencies are over omega_0, forces over m omega_0^2
beta, m, omega_0 = sp.symbols("beta m omega_0", positive=True)
DAMPING = ("0.001", "0.01", "0.1")


@dataclass(frozen=True)
class Onset:
    """The point of the least forcing that has a fold: frequency, squares of amplitude and forcing; and kappa."""

    Omega: sp.Expr
    A2: sp.Expr
    F2: sp.Expr
    kappa: sp.Expr


def onset(derived: Derived) -> Onset:
    """In closed form, by elimination; ArithmeticError unless it is proved to be a solution."""
    average = derived.cubic(1, beta)
    y = sp.Symbol("y", positive=True)
    # the square of the forcing as a function of y = A^2: at the onset its first two derivatives vanish
    level = sp.expand(sp.expand(derived.response(average) + F_0**2).subs(A, sp.sqrt(y)))
    (at,) = sp.solve(sp.diff(level, y, 2), y)
    slope = sp.factor(sp.diff(level, y).subs(y, at))
    # the slope's zeros have Omega^2 - 1 = +-2 sqrt(3) zeta Omega; with - the square of the amplitude is negative
    frequency = sp.sqrt(3) * zeta + sp.sqrt(1 + 3 * zeta**2)
    if not canonical(slope.subs(Omega, frequency)).is_zero:
        raise ArithmeticError("the onset in closed form is none")
    backbone = derived.flow.backbone.subs(h, average)
    kappa = sp.diff(backbone.subs(A, sp.sqrt(y)), y).subs(y, 0)
    amplitude = sp.factor(at)
    force = sp.factor(level.subs(y, at).subs(zeta, (Omega**2 - 1) / (2 * sp.sqrt(3) * Omega)))
    return Onset(frequency, amplitude, force, sp.simplify(kappa))


def formulas(derived: Derived) -> dict[str, Judge]:
    """The three numbers of the onset, each an approximation for weak damping."""
    exact = onset(derived)
    lam, kappa, epsilon = zeta * omega_0, exact.kappa * omega_0, (exact.Omega - 1) * omega_0

    def over(published: sp.Expr, true: sp.Expr) -> str:
        """Their quotient, as damping vanishes and at three ratios."""
        quotient = (published / true).subs(Omega, exact.Omega)
        if quotient.has(m, omega_0):
            return f"Not of its dimension: over the exact one it is {sp.sstr(quotient)}."
        limit = sp.limit(quotient.subs(beta, 1), zeta, 0)
        errors = ", ".join(f"{_error(quotient, damping)} at ζ = {damping}" for damping in DAMPING)
        return f"{'Exact' if limit == 1 else f'Off by a factor {limit}'} as ζ → 0, proved. Relative error: {errors}."

    def detuning(function: Callable[..., Any]) -> str:
        # the positive zero of the relation, its square being linear
        square = sp.Symbol("square", positive=True)
        (found,) = sp.solve(value(function, {"epsilon": sp.sqrt(square), "lam": lam}), square)
        return over(sp.sqrt(found), epsilon)

    def amplitude(function: Callable[..., Any]) -> str:
        return over(value(function, {"epsilon": epsilon, "kappa": kappa}), exact.A2)

    def force(function: Callable[..., Any]) -> str:
        published = value(function, {"m": m, "omega_0": omega_0, "lam": lam, "kappa": kappa})
        true = (m * omega_0**2) ** 2 * exact.F2
        quotient = (published / true * Omega**3).subs(Omega, exact.Omega)
        proved = " It equals the exact one divided by Ω³, proved." if canonical(quotient - 1).is_zero else ""
        return over(published, true) + proved

    return {
        "detuning": approximates(detuning, f"Ω = {sp.sstr(exact.Omega)}"),
        "amplitude": approximates(amplitude, f"A² = {sp.sstr(exact.A2)}"),
        "critical_force": approximates(force, f"F_SN² = {sp.sstr(exact.F2)}"),
    }


def _error(quotient: sp.Expr, damping: str) -> str:
    """Its relative error at a damping ratio, beta = 1: none of the quotients has beta."""
    found = evaluate(quotient.subs(beta, 1), {zeta: ball(damping)}) - 1
    return significant(found, 2)


def claims(derived: Derived) -> Claims:
    """What the onset is."""
    onset(derived)
    return {
        "inflection": (
            TRUE,
            "At the onset the first two derivatives of the squared forcing with respect to A² vanish, proved: "
            "two folds have met.",
        )
    }
