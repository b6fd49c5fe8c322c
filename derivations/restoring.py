"""Step 3, equations (20)-(22), (31), (32): the averaged restoring force of a piecewise odd polynomial, and its derivatives.

In:  polynomial pieces of a force by rising |u|, and the names of the breakpoints between them.
Out: one `Regime` for each number of breakpoints that the amplitude exceeds, with the average and its first derivatives.

With t = pi/2 - psi the average over the cycle, -(1/pi) int_0^{2 pi} f(A cos psi) cos psi dpsi, is four times that over a
quarter, -(4/pi) int_0^{pi/2} f(A sin t) sin t dt, and the piece that ends at |u| = b ends at sin(theta) = b/A. Derivatives
are taken under the integral sign (Leibniz):

    d/dA  int f^(n)(A sin t) sin^(n+1) t dt  =  int f^(n+1)(A sin t) sin^(n+2) t dt  +  boundary terms in the jumps of f^(n)

Differentiating the closed form instead, and sin(acos(b/A)) -> sqrt(1 - b^2/A^2) after it, is exact too but leaves a
difference of nearly equal numbers for A near b.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from derivations.averaging import cycle_integral, psi
from derivations.symbols import A, u

# h_A ... h_AAA: what a fold, a cusp and a condition number need
ORDERS = 3


@dataclass(frozen=True)
class Regime:
    """The average where A exceeds `passed` breakpoints and not the next.

    passed -- the breakpoints that A exceeds, by rising size
    lets   -- intermediate quantities (symbol, expression) in order of evaluation
    derivatives -- the average and its derivatives with respect to A, in A, the parameters and the lets
    """

    passed: tuple[sp.Symbol, ...]
    lets: tuple[tuple[sp.Symbol, sp.Expr], ...]
    derivatives: tuple[sp.Expr, ...]

    def closed_form(self, order: int = 0) -> sp.Expr:
        """The average, or a derivative, with the lets put back."""
        expression = self.derivatives[order]
        for symbol, value in reversed(self.lets):
            expression = expression.subs(symbol, value)
        return expression


@dataclass(frozen=True)
class Restoring:
    """The averaged restoring force of an oscillator.

    pieces      -- the polynomials, by rising |u|
    breakpoints -- where they end
    jumps       -- f just below each breakpoint less f just above: what the truncation leaves there
    regimes     -- the average, one `Regime` for 0, 1, ... breakpoints passed
    """

    pieces: tuple[sp.Expr, ...]
    breakpoints: tuple[sp.Symbol, ...]
    jumps: tuple[sp.Expr, ...]
    regimes: tuple[Regime, ...]


@functools.cache
def moment_parts(power: int) -> tuple[sp.Rational, sp.Poly]:
    """The rational a and the polynomial P with int_0^theta sin^power t dt = a theta - x y P(x^2), x = sin theta, y = cos theta.

    By symmetry int_0^psi cos^power t dt = a psi + x y P(x^2) with x = cos psi, y = sin psi: for psi = pi/2 - theta the
    same x, y and P serve both ends. All coefficients of P are positive, so neither end cancels within the second form.
    """
    if power % 2:
        raise ArithmeticError(f"an odd force gives even powers of the sine only, not {power}")
    theta, x, y = sp.symbols("theta x y", positive=True)
    integral = sp.expand(sp.expand_trig(cycle_integral(sp.sin(psi) ** power, 0, theta)))
    secular = integral.coeff(theta)
    rest = sp.expand((secular * theta - integral).subs({sp.sin(theta): x, sp.cos(theta): y}) / (x * y))
    polynomial = sp.rem(sp.Poly(rest, y), sp.Poly(y**2 + x**2 - 1, y))
    return secular, sp.Poly(polynomial.as_expr(), x)


def at_breakpoint(force: sp.Expr, breakpoint_: sp.Expr) -> sp.Expr:
    """An odd polynomial at a breakpoint, in Horner form."""
    return sp.horner(force, u).subs(u, breakpoint_)


@dataclass(frozen=True)
class _End:
    """An interval's end |u| = b on the quarter cycle: theta = asin(b/A), its complement, x = b/A, xy = sin theta cos theta."""

    b: sp.Symbol
    root: sp.Symbol
    theta: sp.Symbol
    psi_0: sp.Symbol
    x: sp.Symbol
    xy: sp.Symbol

    @classmethod
    def at(cls, b: sp.Symbol, suffix: str) -> _End:
        names = ("root", "theta", "psi_0", "x", "xy")
        return cls(b, *(sp.Symbol(name + suffix, positive=True) for name in names))

    def lets(self) -> list[tuple[sp.Symbol, sp.Expr]]:
        """Their values; atan2 because acos(b/A) loses half the digits for A near b."""
        return [
            (self.root, sp.sqrt((A - self.b) * (A + self.b))),
            (self.theta, sp.atan2(self.b, self.root)),
            (self.psi_0, sp.atan2(self.root, self.b)),
            (self.x, self.b / A),
            (self.xy, self.x * self.root / A),
        ]

    def from_zero(self, power: int) -> sp.Expr:
        """int_0^theta sin^power t dt"""
        secular, polynomial = moment_parts(power)
        return secular * self.theta - self.xy * sp.horner(polynomial.as_expr()).subs(polynomial.gen, self.x)

    def to_quarter(self, power: int) -> sp.Expr:
        """int_theta^(pi/2) sin^power t dt"""
        secular, polynomial = moment_parts(power)
        return secular * self.psi_0 + self.xy * sp.horner(polynomial.as_expr()).subs(polynomial.gen, self.x)

    def slope(self, expression: sp.Expr) -> sp.Expr:
        """d/dA of an expression in A and root."""
        return sp.diff(expression, A) + sp.diff(expression, self.root) * A / self.root


def _moment(ends: Sequence[_End], k: int, power: int) -> sp.Expr:
    """int sin^power t dt over the k-th interval of the quarter cycle."""
    if not ends:
        return moment_parts(power)[0] * sp.pi / 2
    if k == 0:
        return ends[0].from_zero(power)
    if k == len(ends):
        return ends[-1].to_quarter(power)
    return ends[k].from_zero(power) - ends[k - 1].from_zero(power)


def average(pieces: Sequence[sp.Expr], breakpoints: Sequence[sp.Symbol], count: int) -> Regime:
    """(20)-(22), (31): the average of a piecewise force where A exceeds `count` breakpoints, and its derivatives."""
    ends = [_End.at(b, f"_{k + 1}" if count > 1 else "") for k, b in enumerate(breakpoints[:count])]
    moments: dict[sp.Symbol, sp.Expr] = {}

    def under_the_integral(order: int) -> sp.Expr:
        """int f^(order)(A sin t) sin^(order + 1) t dt over the quarter cycle, piece by piece."""
        total = sp.Integer(0)
        for k, piece in enumerate(pieces[: count + 1]):
            for (degree,), coefficient in sp.Poly(sp.diff(piece, u, order), u).terms():
                if coefficient != 0:
                    power = degree + order + 1
                    symbol = sp.Symbol(f"S{k + 1}_{power}", real=True)
                    moments[symbol] = _moment(ends, k, power)
                    total += coefficient * A**degree * (symbol if count else moments[symbol])
        return total

    def boundary(order: int, end: _End, k: int) -> sp.Expr:
        """jump of f^(order) at b, times sin^(order + 1) theta dtheta/dA, where dtheta/dA = -b/(A root)"""
        jump = sp.diff(pieces[k] - pieces[k + 1], u, order)
        return -at_breakpoint(jump, end.b) * end.b ** (order + 2) / (A ** (order + 2) * end.root)

    derivatives = []
    for order in range(ORDERS + 1):
        total = under_the_integral(order)
        for k, end in enumerate(ends):
            for lower in range(order):
                term = boundary(lower, end, k)
                for _ in range(order - 1 - lower):
                    term = end.slope(term)
                total += term
        derivatives.append(
            sp.factor_terms(-4 * total / sp.pi) if count else sp.horner(sp.expand(-4 * total / sp.pi), A)
        )
    lets = [let for end in ends for let in end.lets()] + (list(moments.items()) if count else [])
    return Regime(tuple(breakpoints[:count]), tuple(lets), tuple(derivatives))


def restoring(pieces: Sequence[sp.Expr], breakpoints: Sequence[sp.Symbol]) -> Restoring:
    """All of step 3 for the pieces of a force. Give u + F_k for h (the whole force), F_k for H (the paper's H_i)."""
    jumps = tuple(
        at_breakpoint(below - above, b) for below, above, b in zip(pieces, pieces[1:], breakpoints, strict=False)
    )
    regimes = tuple(average(pieces, breakpoints, count) for count in range(len(pieces)))
    return Restoring(tuple(pieces), tuple(breakpoints), jumps, regimes)
