"""Against NLvib's first example: the averaged response (24) of the oscillator with a cubic term, solved for Omega^2.

A harmonic balance with one harmonic is averaging. Its damping ratio is half of zeta there.
"""

from __future__ import annotations

import sympy as sp

from ...symbols import F_0, A, Omega
from ...symbols import zeta as ratio
from ..balls import ball, polynomial_zeros, significant
from ..formulas import SQUARES
from ..rows import LOOSE, TRUE
from . import Claims, Derived, Judge, equal

a, zeta, gamma, P, square = sp.symbols("a zeta gamma P square", positive=True)
#: of the example, and the amplitudes between which it has its samples
NUMBERS = {zeta: sp.Rational(5, 100), gamma: sp.Rational(1, 10), P: sp.Rational(18, 100)}
LEAST, MOST = 0.1, 3


def _response(derived: Derived) -> sp.Poly:
    """F of (24) in the symbols of the example, by Omega^2."""
    whole = derived.response(derived.cubic(1, gamma)).subs({A: a, ratio: zeta / 2, F_0: P})
    return sp.Poly(whole.subs(Omega, sp.sqrt(square)), square)


def formulas(derived: Derived) -> dict[str, Judge]:
    """Both frequencies."""
    highest, linear, constant = _response(derived).all_coeffs()
    middle = sp.expand(-linear / highest / 2)
    root = sp.sqrt(sp.expand(middle**2 - constant / highest))
    arguments, sample = {"a": a, "zeta": zeta, "gamma": gamma, "P": P}, {**NUMBERS, a: sp.Integer(1)}
    found = {"upper_frequency": sp.sqrt(middle + root), "lower_frequency": sp.sqrt(middle - root)}
    by = "solving F = 0 (24) for Ω², with μ = κ = 1"
    return {name: equal(one, arguments, rewriting=by, how=SQUARES, sample=sample) for name, one in found.items()}


def claims(derived: Derived) -> Claims:
    """The amplitudes with two frequencies: F, a quadratic in Omega^2, has two positive zeros."""
    quadratic = _response(derived)
    borders = [
        polynomial_zeros({power: ball(number) for (power,), number in sp.Poly(part.subs(NUMBERS), a).terms()})
        for part in (quadratic.coeff_monomial(1), sp.cancel(quadratic.discriminant() / a**2))
    ]
    (least,), (most,) = borders
    return {
        "two_frequencies": (
            LOOSE if LEAST < least < most < MOST else TRUE,
            "F (24) is quadratic in Ω². Both zeros are positive only between the amplitude at Ω → 0, where their "
            "product vanishes, and the peak, where their difference does. With the example's numbers these are a = "
            f"{significant(least, 4)} and {significant(most, 4)}, both within its samples from {LEAST} to {MOST}. "
            "Below this range there is one frequency, above it none; the program discards complex roots.",
        )
    }
