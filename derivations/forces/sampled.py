"""Step 3 for a force that is known by its values, (20)-(22), (31): what stands under the integrals, and what ends add.

In:  the force and its derivatives at u = A s, s = sin t, as numbers; what they lose at a breakpoint b.
Out: `Sampled`: integrands of h and its derivatives, of h - A h_A and of the harmonics over the quarter cycle, what a
     breakpoint that is passed adds to the integrals, and the same of h_AAAA.

It is `quadrature`, in which the force is a formula, with numbers in its place: the same terms stand under the integrals
and around them.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..paper.restoring_force import ORDERS
from ..symbols import A
from .harmonics import HARMONICS, chebyshev, derivatives_of
from .quadrature import bent_at, c, s, untilted_at

#: the force and four derivatives
f = sp.symbols("f f_u f_uu f_uuu f_uuuu", real=True)
#: a breakpoint, what the force and three derivatives lose there, and sqrt(A^2 - b^2)
b = sp.Symbol("b", positive=True)
lost = sp.symbols(f"lost_0:{ORDERS + 1}", real=True)
root = sp.Symbol("root", nonnegative=True)
lets = ((root, sp.sqrt((A - b) * (A + b))),)
_FACTOR = -4 / sp.pi
#: cos(n psi) in s, by lower ones: the terms of the fifth as a polynomial cancel
_T_2 = sp.Symbol("T_2", real=True)
_T = {n: sp.Symbol(f"T_{n}", real=True) for n in HARMONICS}
terms_lets = ((_T_2, 2 * s**2 - 1), (_T[3], s * (2 * _T_2 - 1)), (_T[5], 2 * _T_2 * _T[3] - s))


@dataclass(frozen=True)
class Sampled:
    """Each output is a share of what its integrals and ends sum up to.

    at_rest    -- h as A tends to 0, of the force there
    averaged   -- under the integrals of h, h_A, h_AA, h_AAA
    averaged_end -- what a breakpoint adds to h_A, h_AA, h_AAA
    intercept, intercept_end -- the same of h - A h_A, to which what is at rest adds itself
    harmonics, harmonics_end -- of h_3 and its derivatives, then of h_5; under the integrals in `terms_lets`
    bent       -- under the integrals of h and h_AAAA
    bent_end   -- what a breakpoint adds to h_AAAA, by the lowest order of what is lost there
    """

    at_rest: sp.Expr
    averaged: tuple[sp.Expr, ...]
    averaged_end: tuple[sp.Expr, ...]
    intercept: sp.Expr
    intercept_end: sp.Expr
    harmonics: tuple[sp.Expr, ...]
    harmonics_end: tuple[sp.Expr, ...]
    bent: tuple[sp.Expr, sp.Expr]
    bent_end: tuple[sp.Expr, ...]


def sampled() -> Sampled:
    """All of it."""

    def under(of_psi: sp.Expr) -> tuple[sp.Expr, ...]:
        return tuple(_FACTOR * f[order] * s**order * of_psi for order in range(ORDERS + 1))

    def end(n: int) -> tuple[sp.Expr, ...]:
        _, *found = derivatives_of(n, [sp.Integer(0)] * (ORDERS + 1), [(b, root, lost)])
        return tuple(sp.collect(sp.expand(value), lost, sp.factor) for value in found)

    for n, one in _T.items():
        if sp.expand(sp.expand(one.subs(terms_lets[::-1])) - chebyshev(n, s)) != 0:
            raise ArithmeticError(f"cos({n} psi)")
    return Sampled(
        _FACTOR * f[0],
        under(s),
        end(1),
        -_FACTOR * A**2 * f[2] * s * c**2,
        -_FACTOR * untilted_at(lost, b, root),
        tuple(value for n in HARMONICS for value in under(_T[n])),
        tuple(value for n in HARMONICS for value in end(n)),
        (_FACTOR * f[0] * s, _FACTOR * f[ORDERS + 1] * s ** (ORDERS + 2)),
        tuple(_FACTOR * bent_at(lost, lowest, b, root) for lowest in range(ORDERS + 1)),
    )
