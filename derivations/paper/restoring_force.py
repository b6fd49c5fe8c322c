"""Step 3, equations (20)-(22), (31), (32): the averaged force of an odd piecewise polynomial, and its derivatives.

In:  polynomial pieces of a force by rising |u|, as they are for u > 0, and the names of the breakpoints between them;
     each may have even powers too, and a constant, which in the first is a preload.
Out: one `Regime` for each number of breakpoints that the amplitude exceeds, with the average and its first derivatives;
     beside these exact forms, one whose series keeps its digits where A exceeds a breakpoint by far.

With t = pi/2 - psi the average over the cycle, -(1/pi) int_0^{2 pi} f(A cos psi) cos psi dpsi, is four times that over
a quarter, -(4/pi) int_0^{pi/2} f(A sin t) sin t dt, and the piece that ends at |u| = b ends at sin(theta) = b/A.
Derivatives are taken under the integral sign (Leibniz), with boundary terms in the jumps of f^(n):

    d/dA  int f^(n)(A sin t) sin^(n+1) t dt  =  int f^(n+1)(A sin t) sin^(n+2) t dt  +  boundary terms

Differentiating the closed form instead, and sin(acos(b/A)) -> sqrt(1 - b^2/A^2) after it, is exact too but leaves a
difference of nearly equal numbers for A near b.

For A >> b the closed form of int_0^theta sin^n t dt is such a difference in turn (theta^(n+1)/(n+1) is what remains of
terms of size theta). There its power series in sin^2(theta/2) serves for the highest n, and

    (n - 1) int sin^(n-2) t dt  =  n int sin^n t dt + sin^(n-1) theta cos theta

for the lower ones: positive terms only. Once A exceeds all breakpoints by far, the last piece is averaged over the
whole cycle, in exact numbers, and each breakpoint b adds what it changes, power by power:

    dc A^n int_0^theta sin^(n+1) t dt       where the coefficient falls by dc

The two parts of the derivatives of that, integral and boundary, nearly cancel; by the same relation, read upwards, the
integral gives up its leading part to the boundary, and what is left is small.
"""

from __future__ import annotations

import functools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import sympy as sp

from ..symbols import A, u

# h_A ... h_AAA: what a fold, a cusp and a condition number need
ORDERS = 3

# A exceeds a breakpoint by far beyond this multiple of it: there sin^2(theta/2) < 0.35, and the closed form of the
# moments is a difference of numbers three times as large
FAR = sp.Rational(21, 20)
# and in double-double beyond this multiple, where the series of doubles has more digits than a pair
FAR_IN_PAIRS, OF_A_PAIR = sp.Integer(64), sp.Rational(1, 2**110)
# the series ends where its terms fall below this share of the first
NEGLIGIBLE = sp.Rational(1, 2**57)


@dataclass(frozen=True)
class Regime:
    """The average where A exceeds `passed` breakpoints and not the next."""

    passed: tuple[sp.Symbol, ...]  #: the breakpoints that A exceeds, by rising size
    #: those among them that it exceeds `FAR` times; if there are any the form is a truncated series
    far: tuple[sp.Symbol, ...]
    lets: tuple[tuple[sp.Symbol, sp.Expr], ...]  #: intermediate quantities (symbol, expression) in order of evaluation
    #: the average and its derivatives with respect to A, in A, the parameters and the lets
    derivatives: tuple[sp.Expr, ...]
    #: the average less A times its slope, from which linear terms are gone; None where no form is known, or none was
    #: asked for
    intercept: sp.Expr | None = None
    #: lets that stand for a series cut short, each with a bound of its relative error
    remainders: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()

    def closed_form(self, order: int = 0) -> sp.Expr:
        """The average, or a derivative, with the lets put back."""
        expression = self.derivatives[order]
        for symbol, value in reversed(self.lets):
            expression = expression.subs(symbol, value)
        return expression


@dataclass(frozen=True)
class Case:
    """A form of the average to evaluate, where every left <= right of its guards and no earlier case holds."""

    name: str
    guards: tuple[tuple[sp.Expr, sp.Expr], ...]
    regime: Regime


@dataclass(frozen=True)
class Restoring:
    """The averaged restoring force of an oscillator."""

    pieces: tuple[sp.Expr, ...]  #: the force, by rising |u|
    breakpoints: tuple[sp.Symbol, ...]  #: where they end
    jumps: tuple[sp.Expr, ...]  #: f just below each breakpoint less f just above: what the truncation leaves there
    regimes: tuple[Regime, ...]  #: the average, one exact `Regime` for 0, 1, ... breakpoints passed
    #: the average to working precision, by numbers of breakpoints (passed, passed by far)
    far_regimes: dict[tuple[int, int], Regime]
    #: all forms to evaluate, by how many breakpoints are passed; none where those above are meant
    cases: tuple[Case, ...] = ()


@functools.cache
def moment_parts(power: int) -> tuple[sp.Rational, sp.Poly]:
    """The rational a and the even polynomial P with int_0^theta sin^power t dt = a theta - x y P(x).

    x = sin theta and y = cos theta. By symmetry int_0^psi cos^power t dt = a psi + x y P(x) with x = cos psi and
    y = sin psi: for psi = pi/2 - theta the same x, y and P serve both ends. All coefficients of P are positive, so
    neither end cancels within the second form.

    By parts: n int sin^n t dt = (n - 1) int sin^(n-2) t dt - sin^(n-1) theta cos theta.
    """
    if power % 2:
        raise ArithmeticError(f"only even powers of the sine have this form, not {power}")
    x = sp.Symbol("x", positive=True)
    if power == 0:
        return sp.Integer(1), sp.Poly(0, x)
    secular, polynomial = moment_parts(power - 2)
    factor = sp.Rational(power - 1, power)
    return factor * secular, factor * polynomial + sp.Poly(x ** (power - 2), x) * sp.Rational(1, power)


@functools.cache
def odd_moment(power: int) -> sp.Poly:
    """The polynomial P with int_theta^(pi/2) sin^power t dt = y P(x), power odd; all its coefficients are positive.

    By parts: n int sin^n t dt = sin^(n-1) theta cos theta + (n - 1) int sin^(n-2) t dt.
    """
    x = sp.Symbol("x", positive=True)
    if power == 1:
        return sp.Poly(1, x)
    return (sp.Poly(x ** (power - 1), x) + (power - 1) * odd_moment(power - 2)) * sp.Rational(1, power)


@functools.cache
def quarter_moment(power: int) -> sp.Expr:
    """int_0^(pi/2) sin^power t dt"""
    return odd_moment(power).eval(0) if power % 2 else moment_parts(power)[0] * sp.pi / 2


@functools.cache
def moment_series(power: int) -> sp.Poly:
    """The polynomial P with int_0^theta sin^power t dt = s^(power + 1) P(s^2), s = sin(theta/2), for A >= FAR b.

    With q = sin^2(t/2), sin t = 2 sqrt(q (1 - q)) and dt = dq/sqrt(q (1 - q)): the integrand is a power of q times a
    binomial series, which ends for odd powers: for these P holds everywhere.
    """
    q = sp.Symbol("q", positive=True)
    # where to end is a choice, by floats; what is left out `series_remainder` bounds
    largest, negligible = float(_largest_q()), float(NEGLIGIBLE)
    coefficients = [_term(power, 0)]
    while abs(float(coefficients[-1] / coefficients[0])) * largest ** (len(coefficients) - 1) > negligible:
        coefficients.append(_term(power, len(coefficients)))
    return sp.Poly(coefficients[::-1], q)


@functools.cache
def series_remainder(power: int, multiple: sp.Expr = FAR) -> sp.Expr:
    """A bound of the relative error of `moment_series` where A is at least this multiple of the breakpoint.

    With e = (power - 1)/2 its coefficients fall in size from k = e on, as |e - k| <= k + 1 there, so that what is left
    out is below a geometric series; and the whole is not below its first term times (1 - q)^e, a factor of the
    integrand.
    """
    kept, exponent, largest = moment_series(power).degree() + 1, sp.Rational(power - 1, 2), _largest_q(multiple)
    if kept < exponent:
        raise ArithmeticError(f"the series of the power {power} is cut while its coefficients may still grow")
    left_out = abs(_term(power, kept)) * largest**kept / (1 - largest)
    return left_out / (_term(power, 0) * (1 - largest) ** exponent)


def _largest_q(multiple: sp.Expr = FAR) -> sp.Expr:
    """sin^2(theta/2) where A exceeds a breakpoint that many times, at most."""
    return (1 - sp.sqrt(1 - 1 / multiple**2)) / 2


def _term(power: int, k: int) -> sp.Expr:
    """Coefficient k of `moment_series`."""
    exponent = sp.Rational(power - 1, 2)
    return 2**power * (-1) ** k * sp.binomial(exponent, k) / (exponent + k + 1)


@functools.cache
def at_breakpoint(force: sp.Expr, breakpoint_: sp.Expr) -> sp.Expr:
    """A polynomial at a breakpoint, in Horner form; 0 where it vanishes."""
    value = sp.horner(force, u).subs(u, breakpoint_)
    return sp.Integer(0) if sp.expand(value) == 0 else value


@functools.cache
def slope(expression: sp.Expr, root: sp.Symbol) -> sp.Expr:
    """d/dA of an expression in A and root = sqrt(A^2 - b^2)."""
    return sp.diff(expression, A) + sp.diff(expression, root) * A / root


#: what a force, or a derivative of it, gains at any end; its |u|, and its root
GAINED, END, ROOT = sp.Dummy("gained", real=True), sp.Dummy("b", positive=True), sp.Dummy("root", nonnegative=True)


@functools.cache
def _sloped(of_any_end: sp.Expr, times: int) -> sp.Expr:
    return slope(_sloped(of_any_end, times - 1), ROOT) if times else of_any_end


def at_end(of_any_end: sp.Expr, times: int, gained: sp.Expr, b: sp.Expr, root: sp.Symbol) -> sp.Expr:
    """So many derivatives by A of a product with `GAINED`, in `END` and `ROOT`, at one end: taken once for all ends."""
    known = {GAINED: gained, END: b, ROOT: root}
    return sp.Integer(0) if gained == 0 else _sloped(of_any_end, times).xreplace(known)


def forms(breakpoints: Sequence[sp.Symbol]) -> Iterator[tuple[str, tuple[tuple[sp.Expr, sp.Expr], ...], int, int]]:
    """The forms to evaluate, in order: name, guards, numbers of breakpoints passed and passed by far."""
    for count in range(len(breakpoints) + 1):
        below = [(A, b) for b in breakpoints[count : count + 1]]
        for far in range(count + 1):
            near = [(A, FAR * b) for b in breakpoints[far:count][:1]]
            yield f"passed_{count}" + (f"_far_{far}" if far else ""), (*below, *near), count, far


@dataclass(frozen=True)
class End:
    """An interval's end |u| = b on the quarter cycle: theta = asin(b/A) and its complement psi_0."""

    b: sp.Symbol
    suffix: str
    far: bool

    def symbol(self, name: str) -> sp.Symbol:
        """A let of this end."""
        return sp.Symbol(name + self.suffix, positive=True)

    @property
    def root(self) -> sp.Symbol:
        # not positive: SymPy would put atan(b/root) for theta, and the quotient's rounding into it
        return sp.Symbol("root" + self.suffix, nonnegative=True)

    def lets(self, powers: Sequence[int]) -> list[tuple[sp.Symbol, sp.Expr]]:
        """What the moments below need, and those from zero for these powers."""
        root, x, y, s = self.root, self.symbol("x"), self.symbol("y"), self.symbol("s")
        lets = [
            (root, sp.sqrt((A - self.b) * (A + self.b))),
            (x, self.b / A),
            (y, root / A),
        ]
        if self.far:
            lets.append((self.symbol("z"), (x / y) ** 2))
        even, odd = ([power for power in powers if power % 2 == parity] for parity in (0, 1))
        if not self.far:
            theta = self.symbol("theta")
            # atan2 because acos(b/A) loses half the digits for A near b
            lets += [(self.symbol("psi_0"), sp.atan2(root, self.b)), (theta, sp.atan2(self.b, root))]
            for power in even:
                secular, polynomial = moment_parts(power)
                lets.append((self.from_zero(power), secular * theta - x * y * _horner(polynomial, x)))
        by_series = [same for same in (even if self.far else [], odd) if same]
        if by_series:
            lets.append((s, x / sp.sqrt(2 * (1 + y))))
        for same in by_series:
            top = max(same)
            lets.append((self.from_zero(top), s ** (top + 1) * _halved(moment_series(top), s**2)))
            for power in range(top, min(same), -2):
                higher = power * self.from_zero(power) + x ** (power - 1) * y
                lets.append((self.from_zero(power - 2), higher / (power - 1)))
        return lets

    def remainders(self, powers: Sequence[int]) -> list[tuple[sp.Symbol, sp.Expr]]:
        """Of the lets for these powers, what is a series cut short, and a bound of its relative error."""
        even = [power for power in powers if power % 2 == 0]
        if not self.far or not even:
            return []
        if series_remainder(max(even), FAR_IN_PAIRS) > OF_A_PAIR:
            raise ArithmeticError(f"the series of the power {max(even)} has too few terms for a pair")
        return [(self.from_zero(max(even)), series_remainder(max(even)))]

    def from_zero(self, power: int) -> sp.Symbol:
        """int_0^theta sin^power t dt"""
        return self.symbol(f"M{power}")

    def to_quarter(self, power: int) -> sp.Expr:
        """int_theta^(pi/2) sin^power t dt"""
        if power % 2:
            return self.symbol("y") * _horner(odd_moment(power), self.symbol("x"))
        secular, polynomial = moment_parts(power)
        if self.far:
            # theta is below 1: nothing cancels, and no angle is needed
            return secular * sp.pi / 2 - self.from_zero(power)
        x, y = self.symbol("x"), self.symbol("y")
        return secular * self.symbol("psi_0") + x * y * _horner(polynomial, x)

    def changes(self, n: int, orders: int) -> tuple[tuple[sp.Expr, ...], sp.Expr]:
        """A^n int_0^theta sin^(n+1) t dt over A^n, its j-th derivative over A^(n-j); and the value less A its slope."""
        slopes, intercept = _of_any_end(n)
        own = {_ANY.symbol(name): self.symbol(name) for name in ("x", "y", "z", f"M{n + 1}", f"M{n + 3}")}
        return tuple(value.xreplace(own) for value in slopes[: orders + 1]), intercept.xreplace(own)

    def changes_anew(self, n: int) -> tuple[tuple[sp.Expr, ...], sp.Expr]:
        """All of `changes`.

        Beyond linear terms by (n + 2) int sin^(n+1) t dt = (n + 3) int sin^(n+3) t dt + sin^(n+2) theta cos theta.
        """
        x, y = self.symbol("x"), self.symbol("y")
        power = n + 1 if n < 2 else n + 3
        moment = self.from_zero(power)
        values = [A**n * (moment if n < 2 else ((n + 3) * moment + x ** (n + 2) * y) / (n + 2))]
        for _ in range(ORDERS):
            value = values[-1]
            of_angle = sp.diff(value, x) * y - sp.diff(value, y) * x + sp.diff(value, moment) * x**power
            values.append(sp.expand(sp.diff(value, A) - of_angle * x / (A * y)))
        slopes = [self._gathered(value / A ** (n - j), moment, n) for j, value in enumerate(values)]
        intercept = self._gathered((values[0] - A * values[1]) / A**n, moment, n)
        return (self.from_zero(n + 1), *slopes[1:]), intercept

    def _gathered(self, value: sp.Expr, moment: sp.Symbol, n: int) -> sp.Expr:
        """A multiple of a moment, and x^(n+2)/y times a polynomial in x^2 = 1 - y^2 and z = 1/y^2 - 1, both small."""
        x, y, z = self.symbol("x"), self.symbol("y"), self.symbol("z")
        value, over = sp.expand(value), sp.Symbol("over", positive=True)
        of_moment = value.coeff(moment) * moment
        rest = sp.expand((value - of_moment) * y / x ** (n + 2)).subs(x, sp.sqrt(1 - y**2))
        rest = sp.expand(sp.expand(rest).subs(y, 1 / sp.sqrt(over)))
        under = rest.coeff(over, -1)
        polynomial = sp.expand((rest - under / over).subs(over, 1 + z) + under * (1 - x**2))
        return of_moment + x ** (n + 2) / y * sp.horner(polynomial, z)


#: an end like any other
_ANY = End(sp.Symbol("b", positive=True), "", far=True)


@functools.cache
def _of_any_end(n: int) -> tuple[tuple[sp.Expr, ...], sp.Expr]:
    """`End.changes_anew`, once for all ends."""
    return _ANY.changes_anew(n)


@functools.cache
def _halved(polynomial: sp.Poly, at: sp.Expr) -> sp.Expr:
    """A long polynomial at a point as two nested ones of its square: half as many operations wait for one another."""
    coefficients = polynomial.all_coeffs()[::-1]
    square = sp.Symbol("square")
    even, odd = (sp.Poly(coefficients[start::2][::-1], square) for start in (0, 1))
    return _horner(even, at**2) + at * _horner(odd, at**2)


@functools.cache
def _horner(polynomial: sp.Poly, at: sp.Expr) -> sp.Expr:
    """A polynomial at a point, nested."""
    return functools.reduce(lambda nested, coefficient: nested * at + coefficient, polynomial.all_coeffs())


def _moment(ends: Sequence[End], k: int, power: int) -> sp.Expr:
    """int sin^power t dt over the k-th interval of the quarter cycle."""
    if not ends:
        return quarter_moment(power)
    if k == 0:
        return ends[0].from_zero(power)
    if k == len(ends):
        return ends[-1].to_quarter(power)
    return ends[k].from_zero(power) - ends[k - 1].from_zero(power)


def _beyond_all(pieces: Sequence[sp.Expr], ends: Sequence[End], orders: int, bent: bool) -> tuple[sp.Expr, ...]:
    """The average and its derivatives, then its intercept if wanted, where A exceeds each breakpoint by far."""
    passed, last = pieces[: len(ends)], pieces[len(ends)]
    whole = -4 / sp.pi * sum(c * A**n * quarter_moment(n + 1) for (n,), c in sp.Poly(last, u).terms())
    totals = [sp.diff(whole, A, j) for j in range(orders + 1)]
    if bent:
        totals.append(whole - A * sp.diff(whole, A))
    totals = [sp.horner(sp.expand(total), A) for total in totals]
    for end, piece, following in zip(ends, passed, (*passed[1:], last), strict=True):
        # what makes two pieces continuous is their difference at the end: two products would be rounded apart
        terms = [(n, sp.collect(c, end.b)) for (n,), c in reversed(sp.Poly(piece - following, u).terms()) if c != 0]
        changes = [(n, c, end.changes(n, orders)) for n, c in terms]
        for j in range(orders + 1):
            totals[j] += -4 / sp.pi * _nested([(n, c * slopes[j]) for n, c, (slopes, _) in changes], j)
        if bent:
            totals[-1] += -4 / sp.pi * _nested([(n, c * intercept) for n, c, (_, intercept) in changes], 0)
    return tuple(totals)


def _nested(terms: Sequence[tuple[int, sp.Expr]], order: int) -> sp.Expr:
    """The sum of A^(n - order) times a value over some n, which rise: nested."""
    total, above = sp.Integer(0), 0
    for n, value in reversed(terms):
        total, above = value + A ** (above - n) * total, n
    return A ** (above - order) * total


@functools.cache
def _terms(piece: sp.Expr, order: int = 0) -> tuple[tuple[int, sp.Expr], ...]:
    """Powers of u in a derivative of a polynomial with their coefficients, the highest first; none in 0."""
    return tuple((power, value) for (power,), value in sp.Poly(sp.diff(piece, u, order), u).terms() if value != 0)


@functools.cache
def _in_moments(
    pieces: tuple[sp.Expr, ...], ends: tuple[End, ...], jumps: tuple[sp.Symbol, ...], orders: int, bent: bool
) -> tuple[tuple[sp.Expr, ...], dict[sp.Symbol, tuple[int, int]]]:
    """Of `average`: its derivatives, then the intercept if wanted; moments in them, with interval and power of each.

    They do not depend on which ends are exceeded by far, as long as one is not: then the moments do.
    """
    moments: dict[sp.Symbol, tuple[int, int]] = {}

    def under_the_integral(order: int, forces: Sequence[sp.Expr] = pieces) -> sp.Expr:
        """int f^(order)(A sin t) sin^(order + 1) t dt over the quarter cycle, piece by piece."""
        total = sp.Integer(0)
        for k, piece in enumerate(forces):
            for degree, coefficient in _terms(piece, order):
                power = degree + order + 1
                symbol = sp.Symbol(f"S{k + 1}_{power}", real=True)
                moments[symbol] = (k, power)
                total += coefficient * A**degree * (symbol if ends else quarter_moment(power))
        return total

    def boundary(order: int, end: End, k: int, times: int = 0) -> sp.Expr:
        """jump of f^(order) at b, times sin^(order + 1) theta dtheta/dA, where dtheta/dA = -b/(A root); derived."""
        jump = sp.diff(pieces[k] - pieces[k + 1], u, order)
        lost = jumps[k] if jumps and order == 0 else at_breakpoint(jump, end.b)
        return at_end(GAINED * END ** (order + 2) / (A ** (order + 2) * ROOT), times, -lost, end.b, end.root)

    def times_factor(total: sp.Expr) -> sp.Expr:
        return sp.factor_terms(-4 * total / sp.pi) if ends else sp.horner(sp.expand(-4 * total / sp.pi), A)

    derivatives = []
    for order in range(orders + 1):
        total = under_the_integral(order)
        for k, end in enumerate(ends):
            for lower in range(order):
                total += boundary(lower, end, k, order - 1 - lower)
        derivatives.append(times_factor(total))
    if bent:
        # f(A s) - A s f'(A s), s = sin t, under the integral: what is linear is gone before it is integrated
        without = [sp.expand(piece - u * sp.diff(piece, u)) for piece in pieces]
        intercept = under_the_integral(0, without) - A * sum(boundary(0, end, k) for k, end in enumerate(ends))
        derivatives.append(times_factor(intercept))
    return tuple(derivatives), moments


def average(
    pieces: Sequence[sp.Expr],
    breakpoints: Sequence[sp.Symbol],
    count: int,
    far: int = 0,
    jumps: Sequence[sp.Symbol] = (),
    orders: int = ORDERS,
    bent: bool = True,
) -> Regime:
    """(20)-(22), (31): the average of a piecewise force where A exceeds `count` breakpoints, and its derivatives.

    The first `far` of these it exceeds `FAR` times: there the moments are the series'. `jumps` are names for what the
    force loses at the breakpoints, where these stand for numbers of their own; `orders` is how many derivatives are
    wanted, `bent` whether the intercept is.
    """
    ends = [End(b, f"_{k + 1}" if count > 1 else "", k < far) for k, b in enumerate(breakpoints[:count])]
    moments: dict[sp.Symbol, sp.Expr] = {}
    if count and far == count and not jumps:
        found = _beyond_all(pieces, ends, orders, bent)
    else:
        near = tuple(replace(end, far=False) for end in ends)
        found, named = _in_moments(tuple(pieces[: count + 1]), near, tuple(jumps), orders, bent)
        moments = {symbol: _moment(ends, *which) for symbol, which in named.items()}
    used = set().union(*(value.free_symbols for value in (*moments.values(), *found)))
    powers = range(1, max((power for piece in pieces for power, _ in _terms(piece)), default=0) + 4)
    of_ends = [(end, [power for power in powers if end.from_zero(power) in used]) for end in ends]
    lets = [let for end, orders_used in of_ends for let in end.lets(orders_used)]
    remainders = tuple(remainder for end, orders_used in of_ends for remainder in end.remainders(orders_used))
    if count:
        lets += moments.items()
    passed, passed_far = tuple(breakpoints[:count]), tuple(breakpoints[:far])
    derivatives, (intercept,) = found[: orders + 1], found[orders + 1 :] or (None,)
    return Regime(passed, passed_far, tuple(lets), derivatives, intercept, remainders)


def restoring(pieces: Sequence[sp.Expr], breakpoints: Sequence[sp.Symbol], orders: int = ORDERS) -> Restoring:
    """All of step 3 for the pieces of a force, with so many derivatives.

    Give u + F_k for h (the whole force), F_k for H (the paper's H_i).
    """
    jumps = tuple(
        at_breakpoint(below - above, b) for below, above, b in zip(pieces, pieces[1:], breakpoints, strict=False)
    )
    regimes = tuple(average(pieces, breakpoints, count, orders=orders) for count in range(len(pieces)))
    far_regimes = {
        (count, far): average(pieces, breakpoints, count, far, orders=orders)
        for count in range(1, len(pieces))
        for far in range(1, count + 1)
    }
    return Restoring(tuple(pieces), tuple(breakpoints), jumps, regimes, far_regimes)
