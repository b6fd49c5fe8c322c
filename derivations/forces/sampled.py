"""Step 3 for a force that is known by its values, (20)-(22), (31): what stands under the integrals, and what ends add.

In:  the force and its derivatives at u = A s, s = sin t, as numbers; what they lose at a breakpoint b.
Out: `Formulas`: integrands of h and its derivatives, of h - A h_A and of the harmonics over the quarter cycle, what a
     breakpoint that is passed adds to the integrals, and the same of h_AAAA.

It is `quadrature`, in which the force is a formula, with numbers in its place: the same terms stand under the integrals
and around them.
"""

from __future__ import annotations

import sympy as sp

from ..kernels import Formulas, Lets
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


#: of arguments
ORDER = (A, b, s, c, *f, *lost)


def sampled() -> Formulas:
    """What stands under its integrals, and what ends of its pieces add to them: of each a share."""
    of = Formulas(ORDER, domain="any")

    def under(of_psi: sp.Expr) -> tuple[sp.Expr, ...]:
        return tuple(_FACTOR * f[order] * s**order * of_psi for order in range(ORDERS + 1))

    def end(n: int) -> tuple[sp.Expr, ...]:
        _, *found = derivatives_of(n, [sp.Integer(0)] * (ORDERS + 1), [(b, root, lost)])
        return tuple(sp.collect(sp.expand(value), lost, sp.factor) for value in found)

    for n, one in _T.items():
        if sp.expand(sp.expand(one.subs(terms_lets[::-1])) - chebyshev(n, s)) != 0:
            raise ArithmeticError(f"cos({n} psi)")
    averages, beyond = "(20)-(22), (31)", "A > b > 0"
    of.add("at_rest", _FACTOR * f[0], "h as A tends to 0.", "(20)")
    of.add("averaged_terms", under(s), "Under the integrals of h, h_A, h_AA, h_AAA over the quarter cycle.", averages)
    text = "What a breakpoint adds to h_A, h_AA, h_AAA."
    of.add("averaged_end", Lets(lets, end(1)), text, "(21), (22), (31)", beyond)
    text = "Under the integral of h - A h_A, which `at_rest` adds to."
    of.add("intercept_terms", -_FACTOR * A**2 * f[2] * s * c**2, text, "from (20)")
    by_end = Lets(lets, -_FACTOR * untilted_at(lost, b, root))
    of.add("intercept_end", by_end, "What a breakpoint adds to h - A h_A.", "from (20)", beyond)
    terms = Lets(terms_lets, tuple(value for n in HARMONICS for value in under(_T[n])))
    of.add("harmonics_terms", terms, "Under the integrals of h_3 and three derivatives, then of h_5.", "beyond (20)")
    by_end = Lets(lets, tuple(value for n in HARMONICS for value in end(n)))
    text = "What a breakpoint adds to the three derivatives of h_3, then of h_5."
    of.add("harmonics_end", by_end, text, "beyond (20)", beyond)
    bent = (_FACTOR * f[0] * s, _FACTOR * f[ORDERS + 1] * s ** (ORDERS + 2))
    highest = f"h_A{'A' * ORDERS}"
    of.add("bent_terms", bent, f"Under the integrals of h and {highest}.", "(20), (31)")
    for lowest in range(ORDERS + 1):
        by_end = Lets(lets, _FACTOR * bent_at(lost, lowest, b, root))
        text = f"What a breakpoint adds to {highest}; derivatives of order {lowest} are the first to be lost."
        of.add(f"bent_end_{lowest}", by_end, text, "(31)", beyond)
    return of
