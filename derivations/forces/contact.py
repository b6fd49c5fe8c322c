"""Step 3 for contacts: forces that begin behind a gap as a broken power of what u exceeds it by, as Hertz's does.

In:  a piece of an odd force and where it begins.
Out: `parted`, the piece as a smooth one and `Contact`s; of these the integrals over the quarter cycle and what stands
     around them, h and its derivatives, the higher harmonics, and the same between two amplitudes.

A term v^e X(v) of the force, v = u - b, e no whole number and X smooth, cannot be differentiated under the integral at
a fixed angle: its third derivative has no integral. It can at a fixed share y of A - b: with d = A - b, u = b + d y

    int v^e X T_n(s) dt = d^(e + 1/2)/sqrt(A + b) M(A)
    M = int_0^1 y^e X(d y) T_n(u/A) sqrt((A + b)/(A + u)) / sqrt(1 - y) dy

where all that is under the last integral is smooth in A, down to A = b. The derivatives of the product are those of
its factors, which are sums of terms of one sign where X is constant. So h is d^(e + 1/2) times a power series: for e =
3/2 its second derivative is what jumps at the gap, and all derivatives are bounded. In the angle that is summed over,
dt = sqrt(d) dy/sqrt((1 - y) (A + u)).

A contact acts on all u > b: what a later piece does not have of it is taken off that piece.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from sympy.codegen.cfunctions import log1p

from slowflow.support.errors import NotSettled

from ..given import in_text
from ..paper.restoring_force import ORDERS
from ..symbols import A, u

#: what u exceeds the gap by, its share of A - b
v, y = sp.symbols("beyond share", nonnegative=True)
#: sine and cosine of the angle, u = A sine
s, c = sp.symbols("sine cosine", positive=True)
#: what the slopes of T_n(u/A) sqrt((A + b)/(A + u)) are made of: b (1 - y)/A^2, 2 b y/((A + b) (A + u)), and the sum of
#: (1 + y)/(A + u) and 1/(A + b), whose difference that is
_shift, _falls, _grows, _wide = sp.symbols("moved falls grows wide", nonnegative=True)
#: below this power, and there, h has no slope where the contact begins
LEAST = sp.Rational(1, 2)

Let = tuple[sp.Symbol, sp.Expr]


@dataclass(frozen=True)
class Contact:
    """A force v^power factor(v) on all u > b, v = u - b.

    begins -- how many breakpoints A has to exceed
    begin  -- the last of these, b
    power  -- no whole number
    factor -- smooth in v
    """

    begins: int
    begin: sp.Expr
    power: sp.Rational
    factor: sp.Expr

    @property
    def force(self) -> sp.Expr:
        """In u."""
        return (v**self.power * self.factor).subs(v, u - self.begin)

    @property
    def exponent(self) -> sp.Rational:
        """The power of A - b that h begins with."""
        return self.power + sp.Rational(1, 2)

    def lost(self, order: int) -> sp.Expr:
        """The factor of the power of v between order - 1/2 and order + 1/2, for which a derivative of h is infinite.

        The derivative of order + 1; 0 where none is, as where h has whole powers of d.
        """
        place = order + sp.Rational(1, 2) - self.power
        if place.is_Integer or place < 0:
            return sp.Integer(0)
        number = int(sp.floor(place))
        return sp.diff(self.factor, v, number).subs(v, 0) / sp.factorial(number)

    def changed(self, parameter: sp.Symbol) -> Contact | None:
        """How it changes with a parameter at a fixed u: a contact again; None where it does not."""
        shift = sp.diff(self.begin, parameter)
        by_factor = sp.diff(self.factor, parameter)
        if shift == 0:
            return None if by_factor == 0 else Contact(self.begins, self.begin, self.power, by_factor)
        inclined = self.power * self.factor + v * sp.diff(self.factor, v)
        factor = sp.expand(v * by_factor - shift * inclined)
        return Contact(self.begins, self.begin, self.power - 1, factor)

    # --- over the quarter cycle ---

    @property
    def lets(self) -> list[Let]:
        """What the integrands need at an angle, from v, sine and cosine, in sums of terms of one sign."""
        end, at, amplitude, left, beyond = _names
        return [
            (end, self.begin),
            (at, end + v),
            (amplitude, at / s),
            (left, amplitude * c**2 / (1 + s)),
            (beyond, v + left),
            (y, v / beyond),
            (_shift, end * left / (beyond * amplitude**2)),
            (_grows, (1 + y) / (amplitude + at)),
            (_wide, 1 / (amplitude + end)),
            (_falls, 2 * end * y * _wide / (amplitude + at)),
        ]

    def integrands(self, n: int, orders: int) -> tuple[sp.Expr, ...]:
        """Under the integrals over the angle: v^e times what makes the derivatives of M, in `lets`."""
        values = _of_M(self.factor, n, orders)
        return tuple(v**self.power * value.subs(A, _names[2]) for value in values)

    def average(self, sums: Sequence[sp.Expr], b: sp.Symbol) -> tuple[sp.Expr, ...]:
        """The integral and its derivatives by A, from those of `integrands`; b is where it begins."""
        ratio = b / (A - b)
        return tuple(
            sp.Add(*(sums[order - k] * _slope(self.exponent, order, k, ratio) / (A + b) ** k for k in range(order + 1)))
            for order in range(len(sums))
        )

    # --- between two amplitudes ---

    @property
    def lets_between(self) -> list[Let]:
        """What `between` needs, from A and y."""
        end, at, *_ = _names
        return [
            (end, self.begin),
            (at, end * (1 - y) + A * y),
            (s, y + end * (1 - y) / A),
            (_shift, end * (1 - y) / A**2),
            (_grows, (1 + y) / (A + at)),
            (_wide, 1 / (A + end)),
            (_falls, 2 * end * y * _wide / (A + at)),
            (v, (A - end) * y),
        ]

    @property
    def between(self) -> tuple[sp.Expr, ...]:
        """What M and its derivatives are integrals of, over dy/sqrt(1 - y), in `lets_between`."""
        ratio = sp.sqrt((A + _names[0]) / (A + _names[1]))
        return tuple(ratio * y**self.power * value for value in _of_M(self.factor, 1, ORDERS + 1))

    def bent(self, sums: Sequence[sp.Expr], root: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
        """The integral and its fourth derivative, from M and its derivatives; `root` is sqrt(A^2 - b^2)."""
        d, order = sp.Symbol(f"d_{self.begins}", positive=True), ORDERS + 1
        before = d**self.exponent / sp.sqrt(A + self.begin)
        slopes = [sp.expand(before * _slope(self.exponent, order, k, self.begin / d)) for k in range(order + 1)]
        fourth = sp.Add(*(slopes[k] * sums[order - k] / (A + self.begin) ** k for k in range(order + 1)))
        of_root = root**2 / (A + self.begin)
        return (before * sums[0]).subs(d, of_root), fourth.subs(d, of_root)


_names = sp.symbols("end at amplitude left exceeds", positive=True)
#: b/d
_ratio = sp.Symbol("share_of", nonnegative=True)


def parted(piece: sp.Expr, begins: int, begin: sp.Expr) -> tuple[sp.Expr, list[Contact]]:
    """A piece without what is singular where it begins, and that.

    Raises ArithmeticError with the reason where it is no sum of broken powers of v with smooth factors.
    """
    smooth = sp.Integer(0)
    factors: dict[sp.Rational, sp.Expr] = {}
    for term in sp.Add.make_args(sp.expand(piece.subs(u, begin + v))):
        power, factor = sp.Integer(0), sp.Integer(1)
        for part in sp.Mul.make_args(term):
            base, exponent = part.as_base_exp()
            if base == v and exponent.is_Rational:
                power += exponent
            else:
                factor *= part
        if not _is_smooth(factor):
            raise NotSettled(
                f"{in_text(term.subs(v, u - begin))}, which is no power of u - {in_text(begin)} times what is smooth"
            )
        if power.is_Integer:
            smooth += term
            continue
        if power <= LEAST:
            raise NotSettled(f"{in_text(term.subs(v, u - begin))}, whose power is not above 1/2: h has no slope there")
        lowest = next((known for known in factors if (power - known).is_Integer), power)
        if power < lowest:
            factors[power] = v ** (lowest - power) * factors.pop(lowest)
            lowest = power
        factors[lowest] = factors.get(lowest, sp.Integer(0)) + factor * v ** (power - lowest)
    contacts = [Contact(begins, begin, power, sp.expand(factor)) for power, factor in sorted(factors.items())]
    return smooth.subs(v, u - begin), contacts


def _is_smooth(factor: sp.Expr) -> bool:
    """At v = 0."""
    bases = [power.base for power in factor.atoms(sp.Pow) if not power.exp.is_Integer]
    bases += [value.args[0] for value in factor.atoms(sp.log)]
    bases += [1 + value.args[0] for value in factor.atoms(log1p)]
    return not any(base.has(v) and sp.simplify(base.subs(v, 0)) == 0 for base in bases)


def _shapes(n: int, orders: int) -> list[sp.Expr]:
    """T_n(u/A) sqrt((A + b)/(A + u)) and its derivatives by A at a fixed y, over that root."""
    found = [sp.expand(sp.chebyshevt(n, s))]
    for _ in range(orders):
        one = found[-1]
        slopes = {s: -_shift, _shift: -2 * _shift / A, _falls: -_falls * (_grows + _wide)}
        slopes |= {_grows: -(_grows**2), _wide: -(_wide**2), A: 1}
        found.append(sp.expand(sum(rate * sp.diff(one, at) for at, rate in slopes.items()) - one * _falls / 2))
    return found


def _of_M(factor: sp.Expr, n: int, orders: int) -> list[sp.Expr]:
    """The same with the factor of the force, whose argument grows with A."""
    shapes = _shapes(n, orders)
    slopes = [sp.diff(factor, v, k) * y**k for k in range(orders + 1)]
    return [
        sp.Add(*(sp.binomial(order, k) * slopes[k] * shapes[order - k] for k in range(order + 1)))
        for order in range(orders + 1)
    ]


def _slope(exponent: sp.Rational, order: int, k: int, ratio: sp.Expr) -> sp.Expr:
    """Beside the derivative of order - k of M: that of order k of d^exponent/sqrt(A + b), over it and times (A + b)^k.

    ratio -- b/d, as A + b = d (1 + 2 ratio)
    """
    terms = (
        sp.binomial(k, i) * sp.ff(exponent, k - i) * sp.ff(-sp.Rational(1, 2), i) * (1 + 2 * _ratio) ** (k - i)
        for i in range(k + 1)
    )
    return sp.binomial(order, k) * sp.expand(sum(terms)).subs(_ratio, ratio)
