"""Step 3 for a force of any kind, equations (20)-(22), (31): what a quadrature sums, and what it puts around the sums.

In:  the pieces of an odd force, each an expression in u and parameters that holds for u > 0, and where they end.
Out: `Quadrature`: integrands over the quarter cycle, piece by piece, and h, its derivatives, h - A h_A and the higher
     harmonics in the integrals' values; beside these h_AAAA, whose bounds tell what h_AAA does between two amplitudes.

A piece is written in what u exceeds its beginning by, of which no digit is lost where that is little.

As in `restoring` and `harmonics`, with u = A s, s = sin t, c = cos t:

    h_n = -(4/pi) sum over pieces of int f(A s) T_n(s) dt,   d/dA int f^(j) s^j T_n dt = int f^(j+1) s^(j+1) T_n dt

and at each breakpoint b the moving angle adds its terms, in what f, f', f'' lose there. By parts h - A h_A is a sum
without the difference of h and A h_A, f(0+) being what the force is next to rest:

    h - A h_A = (4/pi) [A^2 int f''(A s) s c^2 dt - f(0+) + sum over b of ((r/A) (J_0 - b J_1) - J_0 b^2/(A r))]

where J_0, J_1 are what f and f' lose at b, and r^2 = A^2 - b^2. Of a first piece with broken powers, whose f'' is
infinite at rest, f - u f' is integrated itself.

What begins at a breakpoint as a broken power of what u exceeds it by is a `Contact`, with integrals of its own, from
where it begins up to A; the pieces here are what is left.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy as sp
from sympy.codegen.cfunctions import log1p

from ..paper.restoring_force import ORDERS, slope
from ..symbols import A, u
from .contact import Contact, c, parted, s, v
from .elliptic import gauss
from .harmonics import HARMONICS, boundary, chebyshev, derivatives_of

#: nodes of Gauss's rule on each panel: halving a panel divides the error by 2^(2 NODES), of a power t^a by 2^(a + 1)
NODES = 16
#: the angle from where a piece begins is the power DENSE of what is divided into panels: where A is large all that a
#: force does at some u lies there. BROKEN in the first piece, for powers of u that are no whole numbers: t^a becomes
#: x^(BROKEN (a + 1) - 1)
DENSE, BROKEN = 3, 6
#: functions that a force may be made of: their derivatives are made of them too, and all targets know them
FUNCTIONS = (
    *(sp.exp, sp.log, log1p, sp.sin, sp.cos, sp.tan, sp.sinh, sp.cosh, sp.tanh),
    *(sp.asin, sp.acos, sp.atan, sp.asinh, sp.acosh, sp.atanh),
)

Let = tuple[sp.Symbol, sp.Expr]


@dataclass(frozen=True)
class Regime:
    """What stands around the integrals where A exceeds `passed` breakpoints and not the next.

    passed    -- their names
    lets      -- they in the parameters, and sqrt(A^2 - b^2) for each
    averaged  -- h, h_A, h_AA, h_AAA in the sums over the pieces
    intercept -- h - A h_A
    harmonics -- h_3 with its derivatives, then h_5
    """

    passed: tuple[sp.Symbol, ...]
    lets: tuple[Let, ...]
    averaged: tuple[sp.Expr, ...]
    intercept: sp.Expr
    harmonics: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Quadrature:
    """The average of a force of any kind.

    pieces      -- u + F_k(u) for u > 0, by rising u
    breakpoints -- where they end, by name
    """

    pieces: tuple[sp.Expr, ...]
    breakpoints: dict[sp.Symbol, sp.Expr]

    @cached_property
    def _parted(self) -> tuple[tuple[sp.Expr, ...], tuple[Contact, ...]]:
        smooth, contacts = [self.pieces[0]], []
        for begins, (piece, begin) in enumerate(zip(self.pieces[1:], self.breakpoints.values(), strict=True), start=1):
            left = piece - sp.Add(*(one.force for one in contacts))
            if singular_at(left, begin):
                left, found = parted(left, begins, begin)
                contacts += found
            smooth.append(left)
        return tuple(smooth), tuple(contacts)

    @property
    def smooth(self) -> tuple[sp.Expr, ...]:
        """The pieces without contacts."""
        return self._parted[0]

    @property
    def contacts(self) -> tuple[Contact, ...]:
        """What begins as a broken power, and acts from there on."""
        return self._parted[1]

    @cached_property
    def losses(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """What f, f', f'', f''' lose at each breakpoint, contacts apart."""
        ends = self.breakpoints.values()
        return tuple(
            tuple(lost_at(below - above, end, order) for order in range(ORDERS + 1))
            for below, above, end in zip(self.smooth, self.smooth[1:], ends, strict=False)
        )

    @cached_property
    def at_rest(self) -> sp.Expr:
        """f(0+): 0 but for a preload, which an odd force loses at u = 0."""
        value = sp.limit(self.pieces[0], u, 0, "+") if self.is_broken else self.pieces[0].subs(u, 0)
        return sp.simplify(value)

    @property
    def kinks(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """What of f', f'' is lost at each breakpoint, and the factors of broken powers that act alike.

        Where that of order k is not 0 h has an infinite derivative of order k + 1 as A falls to the breakpoint.
        """
        return tuple(
            tuple(
                lost[order] - sp.Add(*(one.lost(order) for one in self.contacts if one.begins == number))
                for order in (1, 2)
            )
            for number, lost in enumerate(self.losses, start=1)
        )

    @property
    def is_broken(self) -> bool:
        """Whether powers of u that are no whole numbers are in the first piece, or logarithms."""
        return bool(singular_at(self.pieces[0], sp.Integer(0)))

    @cached_property
    def from_begin(self) -> tuple[sp.Expr, ...]:
        """The pieces without contacts in what u exceeds their beginning by."""
        begins = (sp.Integer(0), *self.breakpoints.values())
        return tuple(piece.subs(u, begin + v) for piece, begin in zip(self.smooth, begins, strict=True))

    def integrands(self, piece: sp.Expr) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
        """Under the integral, at u = A s: of h and its derivatives, of h - A h_A, of the harmonics."""
        slopes = [without_constants(piece), *derivatives(piece, ORDERS)[1:]]
        averaged, *further = (
            tuple(value * s**order * chebyshev(n, s) for order, value in enumerate(slopes)) for n in (1, *HARMONICS)
        )
        bent = slopes[2] * s * c**2
        if singular_at(piece, sp.Integer(0)):
            # over -A^2, A being u/s
            bent = -sp.expand(sp.powsimp(sp.expand(_untilted(piece, v))) / v**2) * s**3
        return averaged, (bent,), tuple(value for one in further for value in one)

    def regime(self, count: int) -> Regime:
        """Where A exceeds the first `count` breakpoints."""
        names = tuple(self.breakpoints)[:count]
        roots = [sp.Symbol(f"root_{k}", nonnegative=True) for k in range(1, count + 1)]
        lets = [
            let for b, root in zip(names, roots, strict=True) for let in ((b, self.breakpoints[b]), (root, _root(b)))
        ]
        ends = [*zip(names, roots, self.losses[:count], strict=True)]
        contacts = [(one, names[one.begins - 1]) for one in self.contacts if one.begins <= count]
        orders = ORDERS + 1

        def around(n: int, first: int, of_contacts: int, wide: int) -> tuple[sp.Expr, ...]:
            """h_n and its derivatives; sums are numbered from `first` on, of contacts from another on, so many each."""
            total = derivatives_of(n, sums(orders, first), ends)
            for number, (contact, b) in enumerate(contacts):
                own = contact.average(sums(orders, of_contacts + number * wide), b)
                total = tuple(value - 4 / sp.pi * more for value, more in zip(total, own, strict=True))
            return total

        (integral,) = sums(1)
        at_ends = [untilted_at(lost, b, root) for b, root, lost in ends]
        at_rest = self.at_rest
        if self.is_broken:
            at_rest = _untilted(self.pieces[0], u).subs(u, names[0]) * roots[0] / A if count else sp.Integer(0)
        intercept = 4 / sp.pi * (A**2 * integral - at_rest + sum(at_ends))
        for number, (contact, b) in enumerate(contacts):
            value, inclined = contact.average(sums(2, 1 + 2 * number), b)
            intercept -= 4 / sp.pi * (value - A * inclined)
        wide = orders * len(HARMONICS)
        harmonics = [value for k, n in enumerate(HARMONICS) for value in around(n, k * orders, wide + k * orders, wide)]
        return Regime(names, tuple(lets), around(1, 0, orders, orders), intercept, tuple(harmonics))

    def of_contact(self, contact: Contact) -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
        """Under the integrals of one: of h and its derivatives, of h - A h_A, of the harmonics."""
        further = tuple(value for n in HARMONICS for value in contact.integrands(n, ORDERS))
        return contact.integrands(1, ORDERS), contact.integrands(1, 1), further

    # --- by the parameters ---

    def changes(self, number: int, parameter: sp.Symbol) -> tuple[sp.Expr, ...]:
        """Under the integrals of h_p, h_Ap, h_AAp on a piece: what changes at a fixed u."""
        begin = (sp.Integer(0), *self.breakpoints.values())[number]
        changed = sp.diff(self.smooth[number], parameter).subs(u, begin + v)
        return tuple(value * s ** (order + 1) for order, value in enumerate(derivatives(changed, 2)))

    def changes_of(self, contact: Contact, parameter: sp.Symbol) -> tuple[sp.Expr, ...]:
        """The same of a contact."""
        change = contact.changed(parameter)
        return (sp.Integer(0),) * 3 if change is None else change.integrands(1, 2)

    def changed(self, count: int, parameter: sp.Symbol, first: int, of_contacts: Sequence[int]) -> tuple[sp.Expr, ...]:
        """h_p, h_Ap, h_AAp in the sums from `first` on, where A exceeds `count` breakpoints, which may move.

        of_contacts -- from which sum on those of each contact are
        """
        terms, at_breakpoints = [], [sp.Integer(0)] * 3
        for k, (b, end) in enumerate(list(self.breakpoints.items())[:count]):
            root = sp.Symbol(f"root_{k + 1}", nonnegative=True)
            change = sp.diff(self.smooth[k] - self.smooth[k + 1], parameter)
            terms.append((b, root, [lost_at(change, end, order) for order in range(2)]))
            moving = -4 / sp.pi * self.losses[k][0] * sp.diff(end, parameter) * b / (A * root)
            for order in range(3):
                at_breakpoints[order] += moving
                moving = slope(moving, root)
        for contact, own in zip(self.contacts, of_contacts, strict=True):
            change = contact.changed(parameter)
            if contact.begins <= count and change is not None:
                b = tuple(self.breakpoints)[contact.begins - 1]
                at_breakpoints = [
                    one - 4 / sp.pi * more
                    for one, more in zip(at_breakpoints, change.average(sums(3, own), b), strict=True)
                ]
        return tuple(
            one + other for one, other in zip(derivatives_of(1, sums(3, first), terms), at_breakpoints, strict=True)
        )

    # --- between two amplitudes ---

    def bent(self, piece: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Under the integrals of h and h_AAAA.

        Next to rest a broken power's fourth derivative is infinite, but u^4 times it is a power again.
        """
        order = ORDERS + 1
        fourth = derivatives(piece, order)[-1]
        if singular_at(piece, sp.Integer(0)):
            scaled = sp.powsimp(sp.expand(fourth * v**order))
            powers = sorted((power for power in scaled.atoms(sp.Pow) if power.base == v), key=str)
            return nested(without_constants(piece)) * s, sp.collect(scaled, powers, sp.factor) * s / A**order
        return nested(without_constants(piece)) * s, nested(fourth) * s ** (order + 1)

    def bends(self, count: int) -> tuple[sp.Expr, sp.Expr]:
        """h and h_AAAA in their integrals where A exceeds `count` breakpoints.

        The terms of a breakpoint are one quotient, in whose numerator the loss of lowest order leads as A falls to b.
        """
        of_h, of_h_AAAA = sums(2)
        total = of_h_AAAA
        for k, (b, losses) in enumerate(zip(self.breakpoints, self.losses, strict=True), start=1):
            if k > count:
                break
            root = sp.Symbol(f"root_{k}", nonnegative=True)
            lowest = next((order for order, lost in enumerate(losses) if lost != 0), None)
            if lowest is None:
                continue
            total += bent_at(losses, lowest, b, root)
        for number, contact in enumerate(self.contacts):
            if contact.begins <= count:
                root = sp.Symbol(f"root_{contact.begins}", nonnegative=True)
                value, fourth = contact.bent(sums(ORDERS + 2, 2 + number * (ORDERS + 2)), root)
                of_h, total = of_h + value, total + fourth
        return -4 / sp.pi * of_h, -4 / sp.pi * total


def sums(count: int, first: int = 0) -> list[sp.Symbol]:
    """Names of the integrals."""
    return [sp.Symbol(f"sum_{k}", real=True) for k in range(first, first + count)]


def rule() -> tuple[tuple[sp.Rational, sp.Rational], ...]:
    """Positive nodes of Gauss's rule on [-1, 1] and their weights."""
    return gauss(NODES // 2)


class _Tanh(sp.Function):
    """tanh, whose derivatives have no difference 1 - tanh^2."""

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return _Sech2(self.args[0])


class _Sech2(sp.Function):
    """1/cosh^2"""

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return -2 * _Tanh(self.args[0]) * self


def derivatives(piece: sp.Expr, count: int) -> list[sp.Expr]:
    """A piece and its derivatives, in forms in which little cancels."""
    current = piece.replace(sp.tanh, _Tanh)
    found = [current]
    for _ in range(count):
        current = sp.powsimp(sp.diff(current, v))
        if any(power.exp.is_Rational and not power.exp.is_Integer for power in current.atoms(sp.Pow)):
            # v^2/r^3 - 1/r of a root r
            current = min(current, sp.factor(current), key=sp.count_ops)
        found.append(current)
    return [one.replace(_Tanh, sp.tanh).replace(_Sech2, lambda argument: sp.cosh(argument) ** -2) for one in found]


def without_constants(piece: sp.Expr) -> sp.Expr:
    """A piece in a form that keeps its digits where it begins at 0: exp(v) - 1, for one, as 2 exp(v/2) sinh(v/2).

    Where a sum is 0 there whose terms are not, these are rewritten: exponentials, hyperbolic and circular cosines,
    logarithms and roots.
    """

    def vanishes(part: sp.Expr) -> bool:
        return bool(sp.simplify(part.subs(v, 0)) == 0)

    def opened(part: sp.Expr) -> sp.Expr:
        start = part.args[0].subs(v, 0)
        w = part.args[0] - start
        if isinstance(part, sp.exp):
            return sp.exp(start) * (1 + 2 * sp.exp(w / 2) * sp.sinh(w / 2))
        if isinstance(part, sp.log) and start.is_positive:
            return sp.log(start) + log1p(w / start)
        if isinstance(part, (sp.cosh, sp.cos)) and start == 0:
            half = sp.sinh(w / 2) ** 2 if isinstance(part, sp.cosh) else -(sp.sin(w / 2) ** 2)
            return 1 + 2 * half
        if isinstance(part, sp.Pow) and part.exp == sp.Rational(1, 2) and start.is_positive:
            return sp.sqrt(start) + w / (part + sp.sqrt(start))
        return part

    def summed(*terms: sp.Expr) -> sp.Expr:
        whole = sp.Add(*terms)
        if not vanishes(whole) or all(map(vanishes, terms)):
            return whole
        kinds = (sp.exp, sp.log, sp.cosh, sp.cos, sp.Pow)
        apart = sp.Add(*(sp.expand_mul(term.replace(lambda one: isinstance(one, kinds), opened)) for term in terms))
        constant, rest = apart.as_independent(v, as_Add=True)
        return rest if sp.simplify(constant) == 0 and not rest.has(sp.zoo, sp.nan) else whole

    found = piece.replace(sp.Add, summed)
    return found.replace(lambda one: isinstance(one, sp.log) and one.args[0].subs(v, 0) == 1, opened)


def lost_at(difference: sp.Expr, end: sp.Expr, order: int) -> sp.Expr:
    """A derivative of the difference of two pieces where the one ends; 0 where it is."""
    return sp.simplify(sp.diff(difference, u, order).subs(u, end))


def singular_at(piece: sp.Expr, place: sp.Expr) -> list[sp.Expr]:
    """What in a piece is not smooth at a displacement: broken powers, and logarithms, of what vanishes.

    Vanishing denominators are not listed: the force is infinite there.
    """
    bases = [(power, power.base) for power in piece.atoms(sp.Pow) if not power.exp.is_Integer]
    bases += [(value, value.args[0]) for value in piece.atoms(sp.log)]
    bases += [(value, 1 + value.args[0]) for value in piece.atoms(log1p)]
    where = {u: place, v: place}
    return sorted((whole for whole, base in bases if base.has(u, v) and sp.simplify(base.subs(where)) == 0), key=str)


def nested(expression: sp.Expr) -> sp.Expr:
    """A polynomial in Horner's form, in which intervals are narrower; anything else as it is."""
    return sp.horner(expression, v) if expression.is_polynomial(v) and expression.has(v) else expression


def _untilted(piece: sp.Expr, at: sp.Symbol) -> sp.Expr:
    """A force less what its slope makes of the displacement."""
    return piece - at * sp.diff(piece, at)


def untilted_at(lost: Sequence[sp.Expr], b: sp.Symbol, root: sp.Symbol) -> sp.Expr:
    """What a breakpoint adds to h - A h_A over 4/pi, by what f and f' lose there."""
    return root / A * (lost[0] - b * lost[1]) - lost[0] * b**2 / (A * root)


def bent_at(losses: Sequence[sp.Expr], lowest: int, b: sp.Symbol, root: sp.Symbol) -> sp.Expr:
    """What a breakpoint adds to h_AAAA over -4/pi: one quotient, by what is lost there from the lowest order on."""
    numerator = sp.Integer(0)
    for order in range(ORDERS, lowest - 1, -1):
        numerator = numerator * root**2 + losses[order] * _shape(order, b, root)
    return numerator / root ** (2 * (ORDERS - lowest) + 1)


def _root(b: sp.Symbol) -> sp.Expr:
    return sp.sqrt((A - b) * (A + b))


def _shape(order: int, b: sp.Symbol, root: sp.Symbol) -> sp.Expr:
    """What stands beside a loss of that order in h_AAAA, times root^(2 (ORDERS - order) + 1): a polynomial over A^n."""
    term = boundary(1, order, ORDERS - order, sp.Integer(1), b, root)
    value = sp.expand(sp.cancel(sp.expand(term * root ** (2 * (ORDERS - order) + 1))))
    return sp.factor(value)
