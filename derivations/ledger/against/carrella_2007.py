"""Against Carrella, Brennan and Waters: the force of `library/three_spring`, as its geometry gives it and as a cubic.

There lengths are over half the distance of the feet, here over the free length of an oblique spring: u = y_hat/gamma,
and the force is gamma times that of the mechanism.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from types import SimpleNamespace
from typing import Any

import sympy as sp
from flint import arb

from ...symbols import u
from ..balls import ball, evaluate, isolate, rounded, significant
from ..proofs import canonical
from ..rows import FALSE, LOOSE, TRUE
from . import Claims, Derived, Judge, approximates, equal, solves, value

y_hat = sp.Symbol("y_hat", real=True)
gamma = sp.Symbol("gamma", positive=True)
alpha = sp.Symbol("alpha", positive=True)
#: what (19) asks of its namespace, on balls
BALLS = SimpleNamespace(power=lambda numerator, denominator, x: ((arb(numerator) / denominator).log() * x).exp())
LENGTHS = "ŷ = x̂ − √(1 − γ²), u = ŷ/γ"


def _force(derived: Derived) -> sp.Expr:
    """Force over k_v L_o as a function of y_hat, from where the load rests."""
    of = derived.library("three_spring").oscillator
    named = {"alpha": alpha, "ell": 1 / gamma}
    whole = (u + of.exact[0]).subs({symbol: named[symbol.name] for symbol in of.mechanism.ratios})
    # with 1 + u^2 as a quotient the root of its denominator is gamma
    return sp.expand(gamma * whole.subs(1 + u**2, (gamma**2 + y_hat**2) / gamma**2).subs(u, y_hat / gamma))


def _cubic(derived: Derived) -> sp.Expr:
    """The mechanism's polynomial in the same numbers, with no stiffness at rest."""
    of = derived.library("three_spring").oscillator
    named = {"alpha": gamma / (2 * (1 - gamma)), "ell": 1 / gamma}
    in_numbers = of.polynomials[0].subs(of.definitions)
    values = {symbol: named[symbol.name] for symbol in of.mechanism.ratios}
    return sp.factor(gamma * in_numbers.subs(values).subs(u, y_hat / gamma))


def _at_rest(derived: Derived) -> sp.Expr:
    """Stiffness at y_hat = 0."""
    return sp.factor(sp.diff(_force(derived), y_hat).subs(y_hat, 0))


def _quasi_zero(derived: Derived) -> sp.Expr:
    """Stiffness with the one alpha that leaves none at rest."""
    (only,) = sp.solve(_at_rest(derived), alpha)
    return sp.diff(_force(derived), y_hat).subs(alpha, only)


def _excursion(stiffness: arb, g: Any) -> Any:
    """y_hat at which the stiffness, none at rest, is this; what (14) says, by logarithms."""
    return g * (((1 - stiffness * (1 - g)).log() * arb(-2) / 3).exp() - 1).sqrt()


def _best(stiffness: arb) -> arb:
    """The gamma for which that is largest.

    With s = 1 - K_o (1 - gamma) the slope of its square has the sign of 3 s (1 - s^(2/3)) - gamma K_o.
    """

    def slope(g: Any) -> Any:
        s = 1 - stiffness * (1 - g)
        return 3 * s * (1 - (s.log() * arb(2) / 3).exp()) - stiffness * g

    (found,) = isolate(slope, arb("0.3"), arb("0.9"))
    return found


def formulas(derived: Derived) -> dict[str, Judge]:
    """Force, stiffness, conditions, excursion, and the approximations."""
    rest = sp.sqrt(1 - gamma**2)
    place = {"x_hat": rest + y_hat, "alpha": alpha, "gamma": gamma}
    force, cubic, quasi_zero = _force(derived), _cubic(derived), _quasi_zero(derived)
    stiffness, at_rest = sp.diff(force, y_hat), _at_rest(derived)
    (of_gamma,), (of_alpha,) = sp.solve(at_rest, alpha), sp.solve(at_rest, gamma)
    # K_o in what its cube root is taken of in (14)
    q = sp.Symbol("q", positive=True)
    K_o = (1 - q**-3) / (1 - gamma)
    two_thirds = arb(2) / 3

    def of_force(function: Callable[..., Any]) -> str:
        published = value(function, {"y_hat": y_hat, "gamma": gamma})
        exact = force.subs(alpha, of_gamma)

        def error(fraction: str) -> str:
            at = {gamma: two_thirds, y_hat: two_thirds * ball(fraction)}
            return f"{significant(evaluate(published, at) / evaluate(exact, at) - 1, 2)} at {fraction} γ"

        return _summary(published - cubic, "cubic of the mechanism", map(error, ("0.1", "0.25", "0.5")))

    def of_stiffness(function: Callable[..., Any]) -> str:
        published = value(function, {"y_hat": y_hat, "gamma": gamma})

        def error(K: str) -> str:
            at = {gamma: two_thirds, y_hat: _excursion(ball(K), two_thirds)}
            return f"{significant(evaluate(published, at) / ball(K) - 1, 2)} where it is {K}"

        return _summary(published - sp.diff(cubic, y_hat), "slope of the cubic", map(error, ("0.1", "0.5", "1")))

    def of_geometry(function: Callable[..., Any]) -> str:
        def error(K: str) -> str:
            published, best = function(K_o=ball(K), xp=BALLS), _best(ball(K))
            lost = 1 - _excursion(ball(K), published) / _excursion(ball(K), best)
            return f"{significant(published / best - 1, 2)} at K_o = {K} (excursion lower by {significant(lost, 2)})"

        return f"Relative error: {', '.join(map(error, ('0.1', '0.5', '0.9')))}."

    return {
        "force": equal(
            rest + force,
            place,
            rewriting=LENGTHS,
            remark="√(1 − γ²) is the force of the vertical spring at equilibrium.",
        ),
        "stiffness": equal(stiffness, place, rewriting=LENGTHS),
        "gamma_qzs": equal(of_alpha, {"alpha": alpha}, remark="The only zero of the stiffness at equilibrium."),
        "alpha_qzs": equal(of_gamma, {"gamma": gamma}, remark="The only zero of the stiffness at equilibrium."),
        "excursion": solves(
            lambda found: quasi_zero.subs(y_hat, found) - K_o, {"gamma": gamma, "K_o": K_o}, "K(ŷ) = K_o"
        ),
        "gamma_opt": approximates(of_geometry, "γ at the maximum of (14)"),
        "cubic_force": approximates(of_force, sp.sstr(cubic)),
        "cubic_stiffness": approximates(of_stiffness, sp.sstr(sp.diff(cubic, y_hat))),
    }


def _summary(difference: sp.Expr, name: str, errors: Iterable[str]) -> str:
    """Whether the published approximation is the derived one, and how far that goes."""
    same = f"The {name}, proved" if canonical(difference).is_zero else f"Not the {name}"
    return f"{same}. Relative error for γ = 2/3: {', '.join(errors)}."


def claims(derived: Derived) -> Claims:
    """Uniqueness, monotony, angles, and the cubic."""
    quasi_zero = _quasi_zero(derived)
    slope = sp.diff(quasi_zero, y_hat)
    positive = 3 * gamma**3 / ((1 - gamma) * sp.sqrt(gamma**2 + y_hat**2) ** 5)
    rises = canonical(slope - y_hat * positive).is_zero
    least, most = (_best(ball(K)).acos() * 180 / arb.pi() for K in ("0.001", "1"))
    agree = (rounded(least, 0), rounded(most, 0)) == ("48", "57")
    linear = _at_rest(derived)
    unique = len(sp.solve(linear, alpha)) == len(sp.solve(linear, gamma)) == 1
    return {
        "unique": (TRUE if unique else FALSE, "The stiffness at equilibrium has one zero in α, and one in γ."),
        "monotone": (
            TRUE if rises else FALSE,
            "With (11b) the stiffness has the slope 3γ³ŷ/((1 − γ)(γ² + ŷ²)^(5/2)), proved: it has the sign of ŷ.",
        ),
        "angles": (
            TRUE if agree else FALSE,
            f"The excursion is largest for arccos γ = {significant(least, 4)}° at K_o = 0.001, {significant(most, 4)}° "
            "at K_o = 1, the stiffness of the vertical spring alone.",
        ),
        "cubic": (LOOSE, "No range of displacements is stated: see (28) and (29)."),
    }
