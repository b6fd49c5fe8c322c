"""Resultants as Sylvester determinants over the rationals, and critical forcings by them."""

from __future__ import annotations

import itertools
from collections.abc import Callable

from flint import fmpq, fmpq_poly
from mpmath import mp, mpf


def determinant(matrix: list[list[fmpq_poly]]) -> fmpq_poly:
    """Bareiss' elimination without fractions."""
    matrix = [row[:] for row in matrix]
    size, previous, sign = len(matrix), fmpq_poly([1]), 1
    for k in range(size - 1):
        pivot = next((i for i in range(k, size) if matrix[i][k] != 0), None)
        if pivot is None:
            return fmpq_poly([0])
        if pivot != k:
            matrix[k], matrix[pivot], sign = matrix[pivot], matrix[k], -sign
        for i in range(k + 1, size):
            for j in range(k + 1, size):
                matrix[i][j] = (matrix[k][k] * matrix[i][j] - matrix[i][k] * matrix[k][j]) // previous
        previous = matrix[k][k]
    return sign * matrix[-1][-1]


def resultant(first: list[fmpq_poly], second: list[fmpq_poly]) -> fmpq_poly:
    """Of two polynomials in Omega, given by their coefficients, constant first."""
    zero = fmpq_poly([0])
    first, second = ([c for c in reversed(p)] for p in (first, second))
    while first[0] == 0:
        first = first[1:]
    while second[0] == 0:
        second = second[1:]
    n, k = len(first) - 1, len(second) - 1
    rows = [[zero] * i + first + [zero] * (k - 1 - i) for i in range(k)]
    rows += [[zero] * i + second + [zero] * (n - 1 - i) for i in range(n)]
    return determinant(rows)


def essential(polynomial: fmpq_poly, leading: fmpq) -> list[fmpq]:
    """Coefficients of even power of the product of distinct factors but the unknown itself, scaled to a leading one."""
    distinct = polynomial // polynomial.gcd(polynomial.derivative())
    if distinct[0] == 0:
        distinct = distinct // fmpq_poly([0, 1])
    distinct = distinct * (leading / distinct[distinct.degree()])
    assert all(distinct[k] == 0 for k in range(1, distinct.degree() + 1, 2))
    return [distinct[k] for k in range(0, distinct.degree() + 1, 2)]


def constant(x) -> fmpq_poly:
    return fmpq_poly([x])


X = fmpq_poly([0, 1])


def detachment(A, m, zeta, h):
    """Res(F, F_Omega) in F_0; its essential part is monic."""
    R, I = [constant(h), constant(0), constant(A)], [constant(m), constant(2 * zeta * A)]
    F = added(product(R, R), product(I, I), [-X * X])
    return essential(resultant(F, derived(F)), fmpq(1))


def product(a, b):
    result = [fmpq_poly([0])] * (len(a) + len(b) - 1)
    for (i, x), (j, y) in itertools.product(enumerate(a), enumerate(b)):
        result[i + j] = result[i + j] + x * y
    return result


def added(*polynomials):
    size = max(map(len, polynomials))
    return [sum((p[k] for p in polynomials if k < len(p)), fmpq_poly([0])) for k in range(size)]


def derived(polynomial):
    """By Omega."""
    return [k * c for k, c in enumerate(polynomial)][1:]


def by_amplitude(polynomial):
    return [c.derivative() for c in polynomial]


def first_regime(coefficients):
    """h of an odd polynomial force: the mean of 2 cos^(n+1) is 2 (n+1 choose (n+1)/2)/2^(n+1)."""
    total = fmpq_poly([0])
    for k, c in enumerate(coefficients):
        n = 2 * k + 1
        total = total - c * fmpq(2 * int(mp.binomial(n + 1, (n + 1) // 2)), 2 ** (n + 1)) * X**n
    return total


def in_amplitude(F_0, m, zeta, coefficients):
    """F as a polynomial in Omega over Q[A]."""
    R, I = [first_regime(coefficients), constant(0), X], [constant(m), 2 * zeta * X]
    return added(product(R, R), product(I, I), [constant(-F_0 * F_0)])


def saddle_node_onset(leading, m, zeta, *coefficients):
    F_A = by_amplitude(in_amplitude(fmpq(0), m, zeta, coefficients))
    return essential(resultant(F_A, by_amplitude(F_A)), leading)


def saddle_nodes(leading, F_0, m, zeta, *coefficients):
    F = in_amplitude(F_0, m, zeta, coefficients)
    return essential(resultant(F, by_amplitude(F)), leading)


#: the scale of a resultant is a convention: its leading coefficient once its factors are primitive over the integers
LEADING = {
    "saddle_node_onset": lambda zeta, a, b, c: 9765625 * c**8,
    "saddle_nodes": lambda zeta, a, b, c: 15625 * c**6 * zeta**4,
}


def rational(x) -> fmpq:
    """The number as it is."""
    sign, mantissa, exponent, _ = mpf(x)._mpf_
    return fmpq(-int(mantissa) if sign else int(mantissa)) * fmpq(2) ** int(exponent)


def of_reals(f: Callable[..., list[fmpq]]) -> Callable[..., list]:
    """The same of mpmath's numbers."""
    return lambda *x: [mpf(int(value.p)) / int(value.q) for value in f(*map(rational, x))]
