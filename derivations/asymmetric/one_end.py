"""A force of two linear pieces, as of a stop on one side: its average along the balance of the mean, in closed form.

In:  a `Sided` of two pieces, both linear in u, the first through u = 0.
Out: `OneEnd`: what such a force is about its place of rest; B, h and three derivatives of h along the balance.

About the place of rest, u = rest + side v, either such force is k (v + g (v - end)^+) with end > 0: a linear spring
whose stiffness gains g k beyond one displacement. For g > -1 it rises with v, and so does its mean with B: each
amplitude has one mean, there are no other motions, and the averaged questions are those about a centre with h(A) along
the balance.

With the motion v = B + A cos psi beyond the end for |psi| < a, and M and N the means of (cos psi - cos a)^+ with 1 and
with 2 cos psi,

    B = -g A M      h = -k A (1 + g N)      end/A = cos a - g M

so that everything is explicit in a: the last gives a at an amplitude, and derivatives by A are those by a over dA/da.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..claims import claim
from ..paper.averaging import psi
from ..symbols import A, u
from .sided import Sided

#: stiffness at rest, share that it gains beyond, the angle of contact
k, g, a = sp.symbols("k g a", positive=True)
#: sin a and cos a, and what dE/da is over -sin a, with E = end/A
S, C, s, E = sp.symbols("S C s E", real=True)
#: terms of a series in a^2 up to a = 1/2, to the last digit
TERMS = 8


@dataclass(frozen=True)
class OneEnd:
    """About the static equilibrium, and what follows from the angle of contact.

    parameters -- k, g, end, rest and side where the mass rests in the first piece, and where it rests in the second
    condition -- what is positive in the former
    M, N      -- of a
    known     -- h, h_A, h_AA, h_AAA and h - A h_A beyond the end, in k, g, A, S, C, s, E and N
    offset    -- B over -A
    slope     -- s, of a
    excess    -- 1 - end/A, of a: rises with a, with the slope S s
    """

    parameters: tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]
    condition: sp.Expr
    M: sp.Expr
    N: sp.Expr
    known: tuple[sp.Expr, ...]
    offset: sp.Expr
    slope: sp.Expr
    excess: sp.Expr


def derive(force: Sided) -> OneEnd:
    """Raises ArithmeticError for a force that has other pieces."""
    if len(force.pieces) != 2 or any(sp.degree(piece, u) != 1 for piece in force.pieces):
        raise ArithmeticError(f"{force.name}: two linear pieces are wanted")
    (low, high), (place,) = force.pieces, force.ends
    if low.subs(u, 0) != 0 or sp.simplify((high - low).subs(u, place)) != 0:
        raise ArithmeticError(f"{force.name}: it has to be continuous, and 0 at u = 0")
    first, second = sp.diff(low, u), sp.diff(high, u)
    (rest,) = sp.solve(high, u)
    parameters = (
        (first, sp.factor((second - first) / first), place, sp.Integer(0), sp.Integer(1)),
        (second, sp.factor((first - second) / second), sp.factor(rest - place), rest, sp.Integer(-1)),
    )
    M = sp.simplify(sp.integrate(sp.cos(psi) - sp.cos(a), (psi, 0, a)) / sp.pi)
    N = sp.simplify(2 * sp.integrate((sp.cos(psi) - sp.cos(a)) * sp.cos(psi), (psi, 0, a)) / sp.pi)
    slope = 1 + g * a / sp.pi
    claim(
        "derivative of the breakpoint over the amplitude by the angle of contact",
        sp.diff(sp.cos(a) - g * M, a) + sp.sin(a) * slope,
    )
    return OneEnd(parameters, place, M, N, _known(N), g * M, slope, 1 - sp.cos(a) + g * M)


def _known(N: sp.Expr) -> tuple[sp.Expr, ...]:
    mean = sp.Symbol("N")
    rising = A * S * s / E  # dA/da, of A = end/E
    by_a = {S: C, C: -S, s: g / sp.pi, E: -S * s, A: rising, mean: sp.diff(N, a).subs(sp.cos(2 * a), 1 - 2 * S**2)}
    by_a[mean] = sp.simplify(by_a[mean].subs({sp.sin(a): S, sp.cos(a): C}).subs(C**2, 1 - S**2))

    def by_angle(f: sp.Expr) -> sp.Expr:
        found = sum(sp.diff(f, variable) * slope for variable, slope in by_a.items()) / rising
        return sp.factor(sp.expand(sp.expand(found).subs(C**2, 1 - S**2)))

    rows = [-k * A * (1 + g * mean)]
    for _ in range(3):
        rows.append(by_angle(rows[-1]))
    rows.append(sp.factor(sp.expand(rows[0] - A * rows[1])))
    return tuple(rows)


def in_powers(f: sp.Expr) -> sp.Expr:
    """A mean as a series about a = 0, where its terms cancel."""
    return sp.horner(sp.series(f, a, 0, 2 * TERMS + 4).removeO(), a)
