"""The frequencies at an amplitude: coefficients by interpolation, signs and roots by the polynomials themselves."""

from __future__ import annotations

import random
from collections.abc import Sequence

from mpmath import mp, mpf

from tests.oracles.definitions.points import Function, shown, table_of
from tests.oracles.definitions.slow_flow import balances, fold_quartic, response, response_quartic, slope_of_response

ROUGH, FINE = mpf(2) ** -50, mpf(2) ** -98


def halved_slope(Omega, A, m, zeta, h, h_A):
    return slope_of_response(1, Omega, A, m, zeta, h, h_A) / 2


def terms(kind, epsilon, Omega, A, *x):
    """What a quartic's rounding error is measured by, from the sizes of R's terms and the other factor's."""
    *_, m, zeta, h = x[:-1] if kind == "fold" else x
    R, I = balances(Omega, A, m, zeta, h)
    of_R = A * Omega**2 + abs(h)
    if kind == "response":
        return (abs(R) + epsilon * of_R) * of_R + (I + x[0]) ** 2
    h_A = x[-1]
    return (abs(R) + epsilon * of_R) * (Omega**2 + abs(h_A)) + abs(Omega**2 + h_A) * of_R + 2 * zeta * Omega * I


def quartic(kind, epsilon):
    """The value, and that."""
    value = {"response": response, "fold": halved_slope}[kind]
    return lambda *x: [value(*x), terms(kind, epsilon, *x)]


def with_tail(kind):
    """At Omega + tail; the terms are those at Omega."""
    f = quartic(kind, FINE)
    return lambda Omega, tail, *x: [f(Omega + tail, *x)[0], f(Omega, *x)[1]]


def derivative(kind):
    """p, q and k of k (A w^3 + p w + q), by interpolation of the quartic."""

    def of(A, *x):
        _, c_1, c_2, c_4 = response_quartic(A, 0, *x) if kind == "response" else fold_quartic(A, *x)
        return [A * c_2 / (2 * c_4), A * c_1 / (4 * c_4), 4 * c_4 / A]

    return of


def in_pairs(values: Sequence, scales: Sequence) -> tuple[list, list]:
    """p and q as doubles with what they lack; k. The error of what they lack is measured by theirs."""
    pairs, of_pairs = [], []
    for value, scale in zip(values[:2], scales[:2], strict=True):
        high = mpf(float(value))
        pairs += [high, value - high]
        of_pairs += [scale, mp.ldexp(scale, -53)]
    return [*pairs, values[2]], [*of_pairs, scales[2]]


def rise(Omega, A, p, k):
    """Of a quartic whose derivative vanishes at Omega."""
    q = -A * Omega**3 - p * Omega
    value = mp.quad(lambda w: k * (A * w**3 + p * w + q), [0, Omega])
    return [value, k * Omega**2 * (3 * A * Omega**2 / 4 + abs(p) / 2)]


def cubic_discriminant(A, p, p_low, q, q_low):
    """By the roots: A^3 times the squares of their differences; and where it has a double root for q = 0."""
    p, q = p + p_low, q + q_low
    with mp.extradps(40):
        a, b, c = mp.polyroots([A, 0, p, q], maxsteps=500, extraprec=500)
        return [mp.re(A**3 * ((a - b) * (b - c) * (c - a)) ** 2), -4 * p**3]


FREQUENCIES: dict[str, tuple[str, Function]] = {
    "response": ("Omega A F_0 m zeta h", quartic("response", ROUGH)),
    "response_at_0": ("F_0 m h", lambda *x: [response(0, 1, x[0], x[1], 0, x[2]), x[2] ** 2 + (x[1] + x[0]) ** 2]),
    "fold": ("Omega A m zeta h h_A", quartic("fold", ROUGH)),
    "fold_at_0": ("h h_A", lambda h, h_A: [halved_slope(0, mpf(1), 0, 0, h, h_A)]),
    "cubic": ("Omega A p q", lambda w, A, p, q: [A * w**3 + p * w + q]),
    "cubic_slope": ("Omega A p", lambda w, A, p: [mp.diff(lambda v: A * v**3 + p * v, w)]),
    "rise": ("Omega A p k", rise),
    "response_fine": ("Omega A F_0 m zeta h", quartic("response", FINE)),
    "response_beside": ("Omega tail A F_0 m zeta h", with_tail("response")),
    "response_derivative": ("A m zeta h", derivative("response")),
    "response_exactly_at_0": ("F_0 m h", lambda *x: [response(0, 1, x[0], x[1], 0, x[2])]),
    "fold_fine": ("Omega A m zeta h h_A", quartic("fold", FINE)),
    "fold_beside": ("Omega tail A m zeta h h_A", with_tail("fold")),
    "fold_derivative": ("A m zeta h h_A", derivative("fold")),
    "cubic_fine": ("Omega A p p_low q q_low", lambda w, A, p, pp, q, qq: [A * w**3 + (p + pp) * w + (q + qq)]),
    "discriminant": ("A p p_low q q_low", cubic_discriminant),
}


def frequencies_table(rng: random.Random) -> dict:
    table = table_of(FREQUENCIES, rng)
    for row in (row for kind in ("response", "fold") for row in table[f"{kind}_derivative"]):
        values, scales = in_pairs(*(list(map(mpf, row[name])) for name in ("is", "scale")))
        row |= {"is": [shown(one) for one in values], "scale": [shown(one, 6) for one in scales]}
    return table
