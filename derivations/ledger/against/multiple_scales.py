"""Against multiple scales: the slow flow (19), (23) with the same small parameter, to first order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp
from flint import acb, arb

from ...paper.averaging import H
from ...symbols import F_0, A, Omega, h, phi
from ...symbols import mu as friction
from ...symbols import sigma as of_Omega
from ...symbols import zeta as ratio
from ..balls import ball, evaluate, significant
from ..proofs import canonical
from ..rows import FALSE, LOOSE, TRUE
from . import Claims, Derived, Judge, approximates, equal, value

epsilon, sigma, gamma = sp.symbols("epsilon sigma gamma", real=True)
omega_0, alpha, mu, F = sp.symbols("omega_0 alpha mu F", positive=True)
SCALED = "Ω = ω₀ + εσ, ζ = εμ, F_0 = εF, φ = −γ, to first order in ε"
#: alpha a^2 over omega_0^2
BENDS = ("0.01", "0.1", "1")


def _scaled(derived: Derived) -> dict[sp.Symbol, sp.Expr]:
    """The derivation's symbols in those of the article."""
    # zeta stands beside Omega: 2 zeta u' is 2 epsilon mu x'
    return {
        h: derived.cubic(omega_0**2, epsilon * alpha),
        ratio: epsilon * mu,
        F_0: epsilon * F,
        phi: -gamma,
        friction: sp.Integer(0),
    }


def _first_order(expression: sp.Expr) -> sp.Expr:
    return sp.cancel(sp.diff(expression.subs(Omega, omega_0 + epsilon * sigma), epsilon).subs(epsilon, 0))


def _rates(derived: Derived) -> tuple[sp.Expr, sp.Expr]:
    """a' and gamma' by T_1."""
    values = _scaled(derived)
    rates = [rate.subs({of_Omega: Omega**2 - 1, H: h + A}).subs(values) for rate in derived.averaged.slow_flow]
    return _first_order(rates[0]), _first_order(-rates[1] / A)


def _response(derived: Derived) -> sp.Expr:
    """F over (2 omega_0 a)^2 at its lowest order, the second."""
    whole = derived.response(h).subs(_scaled(derived)).subs(Omega, omega_0 + epsilon * sigma)
    return sp.expand(sp.diff(whole, epsilon, 2).subs(epsilon, 0) / 2 / (2 * omega_0 * A) ** 2)


def _cusp(derived: Derived) -> sp.Expr:
    """F^2 alpha/sigma^3 where the first two derivatives of F^2 by a^2 vanish."""
    y = sp.Symbol("y", positive=True)
    level = sp.expand(sp.solve(_response(derived), F**2)[0].subs(A, sp.sqrt(y)))
    (at,) = sp.solve(sp.diff(level, y, 2), y)
    (damping,) = sp.solve(sp.diff(level, y).subs(y, at), mu**2)
    return sp.simplify(level.subs(y, at).subs(mu**2, damping) * alpha / sigma**3)


def formulas(derived: Derived) -> dict[str, Judge]:
    """Backbone, rates, response, cusp, and the time constant."""
    amplitude_rate, phase_rate = _rates(derived)
    names = {"a": A, "gamma": gamma, "mu": mu, "F": F, "omega_0": omega_0, "sigma": sigma, "alpha": alpha}

    def of(*chosen: str) -> dict[str, sp.Expr]:
        return {name: names[name] for name in chosen}

    # the amplitude's rate is linear in a at the peak: its slope is the rate of decay
    decay = -sp.diff(amplitude_rate, A)
    return {
        "frequency": approximates(lambda function: _backbone_error(derived, function), "exactly π√(ω₀² + εαa²)/(2K)"),
        "amplitude_rate": equal(amplitude_rate, of("a", "gamma", "mu", "F", "omega_0"), rewriting=SCALED),
        "phase_rate": equal(
            phase_rate,
            of("a", "gamma", "sigma", "alpha", "F", "omega_0"),
            rewriting=SCALED,
            remark="The forcing term has the wrong sign. With it the response of a linear oscillator would lag by "
            "less than a quarter of a cycle above its resonance. The frequency response has the term squared.",
        ),
        "response": equal(
            _response(derived),
            of("a", "sigma", "mu", "alpha", "F", "omega_0"),
            rewriting=f"{SCALED.removesuffix(', to first order in ε')}; F of (24) over (2ω₀a)², to second order in ε",
        ),
        "cusp": equal(_cusp(derived), {}, remark="It is right for ω₀ = 1."),
        "relaxation": equal(1 / (epsilon * decay), {"epsilon": epsilon, "mu": mu}, rewriting=SCALED),
    }


def _backbone_error(derived: Derived, function: Callable[..., Any]) -> str:
    """Of the article's frequency and of the averaged one, against the exact one, which is an elliptic integral."""
    bend = sp.Symbol("bend", positive=True)  # epsilon alpha a^2/omega_0^2
    averaged = sp.sqrt(sp.expand(derived.flow.backbone.subs(h, derived.cubic(1, bend / A**2)) ** 2))
    at = {"a": A, "omega_0": omega_0, "epsilon": epsilon, "alpha": bend * omega_0**2 / (epsilon * A**2)}
    published = sp.cancel(value(function, at) / omega_0)
    if published.free_symbols != {bend}:
        return f"Not of its dimension: over ω₀ it is {sp.sstr(published)}."
    each = []
    for at_bend in BENDS:
        b = ball(at_bend)
        exact = arb.pi() * (1 + b).sqrt() / (2 * acb(b / (2 * (1 + b))).elliptic_k().real)
        errors = [significant(evaluate(one, {bend: b}) / exact - 1, 2) for one in (published, averaged)]
        each.append(f"{errors[0]} at εαa²/ω₀² = {at_bend} (averaged, (26): {errors[1]})")
    agrees = sp.diff(published - averaged, bend).subs(bend, 0) == 0
    return (
        f"{'Equal' if agrees else 'Not equal'} to (26) to first order in ε, proved. Relative error: {', '.join(each)}."
    )


def claims(derived: Derived) -> Claims:
    """The cusp's ratio, and the decay at the peak."""
    cusp = _cusp(derived)
    amplitude_rate, _ = _rates(derived)
    at_peak = canonical(sp.diff(amplitude_rate, gamma).subs(gamma, sp.pi / 2)).is_zero
    decays = sp.diff(amplitude_rate, A, 2) == 0
    return {
        "universal": (
            LOOSE if cusp.has(omega_0) else TRUE,
            f"The ratio is {sp.sstr(cusp)}: it has the dimension of ω₀³ and is universal in units in which ω₀ = 1.",
        ),
        "exponential": (
            TRUE if at_peak and decays else FALSE,
            "At the peak γ = π/2, where ∂a'/∂γ = 0: a disturbance of the amplitude decays by itself, as exp(−εμt). One "
            "of the phase, driven by that of the amplitude, decays as t exp(−εμt): the eigenvalue is double.",
        ),
    }
