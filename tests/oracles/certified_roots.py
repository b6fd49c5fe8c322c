"""Functions of one real variable in, all their real roots in a range out, each enclosed with a certificate.

Polynomials with rational coefficients go to FLINT's isolation of complex roots, which certifies the real ones. Analytic
functions are given as a callable on `arb_series` (Taylor polynomials with ball coefficients); a range is bisected until
on each piece the Taylor form with remainder either excludes zero or shows the function to be monotone.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from flint import arb, arb_series, ctx, fmpq_poly

TAYLOR_LENGTH = 12
MAX_DEPTH = 90
PRECISIONS = (100, 200, 400)


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work with `bits` bits of mantissa inside the block."""
    before = ctx.prec
    ctx.prec = bits
    try:
        yield
    finally:
        ctx.prec = before


def polynomial_roots(polynomial: fmpq_poly, bits: int = 300) -> list[arb]:
    """Distinct positive real roots of a rational polynomial, ascending, as disjoint balls."""
    if polynomial.is_zero():
        raise ArithmeticError("the zero polynomial has no isolated roots")
    while polynomial[0] == 0:
        polynomial = polynomial.right_shift(1)
    even = all(c == 0 for c in polynomial.coeffs()[1::2])
    if even:
        polynomial = fmpq_poly(polynomial.coeffs()[::2])
    if polynomial.degree() < 1:
        return []
    with precision(bits):
        roots = [root.real for root, _ in polynomial.complex_roots() if root.imag == 0 and not root.real < 0]
        if any(not root > 0 for root in roots):
            raise ArithmeticError("a real root could not be told from zero")
        roots.sort(key=lambda root: root.mid())
        return [root.sqrt() for root in roots] if even else roots


def _magnitude(x: arb) -> arb:
    return arb(x.abs_upper())


def _expansion(function: Callable, centre: arb, half_width: arb) -> list[arb]:
    """Coefficients of function(centre + half_width * x) for |x| <= 1; the last one encloses the Lagrange remainder."""
    ball = arb(centre.mid(), half_width)
    ctx.cap = TAYLOR_LENGTH
    inner = function(arb_series([centre, half_width]))
    ctx.cap = TAYLOR_LENGTH + 1
    outer = function(arb_series([ball, half_width]))
    return [inner[k] for k in range(TAYLOR_LENGTH)] + [outer[TAYLOR_LENGTH]]


def _sign(function: Callable, point: arb) -> int:
    ctx.cap = 1
    value = function(arb_series([point]))[0]
    if value > 0:
        return 1
    if value < 0:
        return -1
    raise ArithmeticError(f"sign not decided at {point}")


def isolate(function: Callable, start: arb, end: arb, *, exclude: Callable[[arb], bool] | None = None) -> list[arb]:
    """Balls, ascending, each with exactly one (simple) root of `function` in [start, end]; no root lies outside them.

    `exclude(ball)` may prove by other means that a piece holds nothing of interest. Raises ArithmeticError when the
    bisection does not settle (multiple root) or a root falls on a bisection point.
    """
    for bits in PRECISIONS:
        try:
            return _isolate(function, start, end, exclude, bits)
        except ArithmeticError:
            if bits == PRECISIONS[-1]:
                raise
    raise AssertionError


def _isolate(function: Callable, start: arb, end: arb, exclude: Callable[[arb], bool] | None, bits: int) -> list[arb]:
    found: list[arb] = []
    with precision(bits):
        stack = [(arb(start.mid()), arb(end.mid()), 0)]
        while stack:
            left, right, depth = stack.pop()
            centre, half_width = arb(((left + right) / 2).mid()), arb(((right - left) / 2).abs_upper())
            if depth >= MAX_DEPTH:
                raise ArithmeticError(f"roots not separated near {centre}")
            halves = [(centre, right, depth + 1), (left, centre, depth + 1)]
            try:
                if exclude is not None and exclude(arb(centre, half_width)):
                    continue
                a = _expansion(function, centre, half_width)
            except (ValueError, ZeroDivisionError):  # the ball is too wide for a division or a root
                stack += halves
                continue
            if abs(a[0]) > sum((_magnitude(c) for c in a[1:]), arb(0)):
                continue
            if abs(a[1]) > sum((k * _magnitude(c) for k, c in enumerate(a[2:], start=2)), arb(0)):
                if _sign(function, left) != _sign(function, right):
                    with precision(2 * bits):
                        found.append(_contract(function, arb(centre, half_width)))
                continue
            stack += halves
    return found


def _contract(function: Callable, ball: arb) -> arb:
    """Interval Newton steps on a ball that holds exactly one root of a monotone function."""
    for _ in range(60):
        centre = arb(ball.mid())
        ctx.cap = 1
        value = function(arb_series([centre]))[0]
        ctx.cap = 2
        slope = function(arb_series([ball, 1]))[1]
        if slope.contains(0):  # too wide for the plain enclosure of the slope: bisect
            left, right = arb(ball.lower()), arb(ball.upper())
            try:
                ball = left.union(centre) if _sign(function, left) != _sign(function, centre) else centre.union(right)
            except ArithmeticError:  # as small as what is known of the function allows
                return ball
            continue
        step = (centre - value / slope).intersection(ball)
        if arb(step.rad()) > arb(ball.rad()) * arb("0.9"):
            return step
        ball = step
    return ball
