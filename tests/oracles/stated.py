"""A mechanism that has no definitions of its own in `definitions`: its file read as a definition.

In:  the file in derivations/mechanisms, the statement of its author: pieces, ends, ratios, names, domains.
Out: `Stated`: the same as numbers of mpmath, without anything that the derivation derives; random designs.

For forces that are polynomials, truncated or not; another needs definitions typed in `definitions`.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence

import sympy as sp
from mpmath import mp, mpf

from derivations.mechanisms import Mechanism

DESIGNS = 2


class Stated:
    """The force, parameters and designs of one mechanism."""

    def __init__(self, mechanism: Mechanism) -> None:
        if mechanism.order == sp.oo:
            raise NotImplementedError(
                f"{mechanism.name} is no polynomial: type its definitions in tests/oracles/definitions"
            )
        self.name = mechanism.name
        self.order = int(mechanism.order)
        self.names = [dict(sorted((power, str(name)) for power, name in n.items())) for n in mechanism.coefficients]
        self.parameters = tuple(map(str, mechanism.parameters))
        self.breakpoints = tuple(map(str, mechanism.breakpoints))
        self.design = mechanism.design
        # dimensionless: k_v = L = 1
        units = {mechanism.k_v: 1, mechanism.length: 1}
        ratios = tuple(mechanism.ratios)
        arguments = (mechanism.x, *ratios)

        def number(expression: sp.Expr) -> Callable:
            return sp.lambdify(arguments, expression.subs(mechanism.dimensional).subs(units), "mpmath")

        self.forces = [number(piece.force) for piece in mechanism.pieces]
        self.ends = [number(piece.until) for piece in mechanism.pieces if piece.until is not None]
        self.given_are_ratios = tuple(parameter.symbol for parameter in mechanism.design) == ratios

    def taylor(self, k: int, ratios: Sequence) -> list:
        """The coefficients of u + F_k(u) for u > 0."""
        found = mp.taylor(lambda u: self.forces[k](u, *ratios), 0, self.order)
        found[1] += 1
        return found

    def coefficients(self, *design: mpf) -> list:
        """The parameters from a design."""
        if not self.given_are_ratios:
            return list(design)
        named = [self.taylor(k, design)[power] for k, names in enumerate(self.names) for power in names]
        return named + [mp.findroot(lambda u, f=f: f(u, *design), mpf("0.1")) for f in self.ends]

    def polynomials(self, p: Sequence) -> list[dict]:
        """Each piece's coefficients for u > 0, by power: those named, 1 for u where none is, and a constant that makes
        the force continuous where the file has a constant without a name."""
        known_values = dict(zip(self.parameters, p, strict=True))
        known: list[dict] = []
        for k, names in enumerate(self.names):
            own = {power: known_values[name] for power, name in names.items()} or {1: 0 * p[0] + 1 if p else mpf(1)}
            if 0 not in names and k and self.has_constant(k):
                b = known_values[self.breakpoints[k - 1]]
                own[0] = sum(c * b**n for n, c in known[-1].items()) - sum(c * b**n for n, c in own.items())
            known.append(dict(sorted(own.items())))
        return known

    def has_constant(self, k: int) -> bool:
        """Whether a piece as stated does not vanish at u = 0, for some ratios."""
        some = [mpf(n + 2) / 7 for n in range(self.forces[k].__code__.co_argcount - 1)]
        return self.forces[k](mpf(0), *some) != 0

    def pieces(self, p: Sequence) -> tuple[list[Callable], list]:
        """The whole force, odd, and where its pieces end."""

        def odd(polynomial: dict) -> Callable:
            def force(u):
                side = 1 if u >= 0 else -1
                return side * sum(c * (side * u) ** n for n, c in polynomial.items())

            return force

        values = dict(zip(self.parameters, p, strict=True))
        return [odd(polynomial) for polynomial in self.polynomials(p)], [values[name] for name in self.breakpoints]

    def first(self, p: Sequence) -> list:
        """Coefficients of u, u^3, u^5, ... of the first piece."""
        polynomial = self.polynomials(p)[0]
        return [polynomial.get(n, 0 * p[0] if p else 0) for n in range(1, max(polynomial) + 1, 2)]

    def hardening(self, p: Sequence) -> list:
        """(d - 1) c_d has the sign of c_d, less that of a constant; then the jumps that the force has."""
        terms = [c if n > 1 else -c for polynomial in self.polynomials(p) for n, c in polynomial.items() if n != 1]
        return terms + [-jump for k, jump in enumerate(self.jumps(p)) if not self.is_continuous(k)]

    def is_continuous(self, k: int) -> bool:
        """Whether the constant of the piece above the breakpoint follows from the piece below it."""
        return 0 not in self.names[k + 1] and self.has_constant(k + 1)

    def jumps(self, p: Sequence) -> list:
        """f below each breakpoint less f above."""
        forces, ends = self.pieces(p)
        return [below(b) - above(b) for below, above, b in zip(forces, forces[1:], ends, strict=False)]

    def designs(self) -> list[tuple[float, ...]]:
        """Random ones within the domains."""
        rng = random.Random(self.name)
        return [tuple(self.within(parameter, rng) for parameter in self.design) for _ in range(DESIGNS)]

    @staticmethod
    def within(parameter, rng: random.Random) -> float:
        """A number in the domain of a parameter, about one where it is unbounded."""
        low, high = (
            next((float(b) for b in (one, other) if b is not None), None)
            for one, other in ((parameter.above, parameter.least), (parameter.below, parameter.most))
        )
        low = low if low is not None else -0.5 if high is None else high - 2
        high = high if high is not None else low + 2.5
        return low + (high - low) * rng.uniform(0.1, 0.9)
