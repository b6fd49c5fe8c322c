"""The frequencies at an amplitude: coefficients by interpolation, signs and roots by the polynomials themselves."""

from __future__ import annotations

from collections.abc import Sequence

from mpmath import mp, mpf

from tests.oracles.definitions.laws import Laws, balances
from tests.oracles.definitions.points import Definitions
from tests.oracles.definitions.slow_flow import SLOW_FLOW

ROUGH, FINE = mpf(2) ** -50, mpf(2) ** -98


NAMES = {"response": "Omega A F_0 m zeta h", "fold": "Omega A m zeta h h_A"}


def value(kind, *x):
    """F, or F_A/2."""
    laws = Laws(dict(zip(NAMES[kind].split(), x, strict=True)), 1)
    return laws("F") if kind == "response" else laws("F_A") / 2


def terms(kind, epsilon, *x):
    """What a quartic's rounding error is measured by, from the sizes of R's terms and the other factor's."""
    at = dict(zip(NAMES[kind].split(), x, strict=True))
    Omega, A, h, zeta = (at[name] for name in ("Omega", "A", "h", "zeta"))
    R, I = balances(Omega, A, at["m"], zeta, h)
    of_R = A * Omega**2 + abs(h)
    if kind == "response":
        return (abs(R) + epsilon * of_R) * of_R + (I + at["F_0"]) ** 2
    T = abs(at["h_A"])
    return (abs(R) + epsilon * of_R) * (Omega**2 + T) + abs(Omega**2 + at["h_A"]) * of_R + 2 * zeta * Omega * I


def at_0(F_0, m, h):
    return value("response", 0, 1, F_0, m, 0, h)


def quartic(kind, epsilon):
    """The value, and that."""
    return NAMES[kind], lambda *x: [value(kind, *x), terms(kind, epsilon, *x)]


def with_tail(kind):
    """At Omega + tail; the terms are those at Omega."""
    names = NAMES[kind].replace("Omega", "Omega tail")
    return names, lambda Omega, tail, *x: [value(kind, Omega + tail, *x), terms(kind, FINE, Omega, *x)]


def derivative(kind):
    """p, q and k of k (A w^3 + p w + q), from the quartic."""

    def of(A, *x):
        f = SLOW_FLOW[f"{kind}_quartic"][1]
        _, c_1, c_2, c_4 = f(A, 0, *x) if kind == "response" else f(A, *x)
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


FREQUENCIES: Definitions = {
    "response": quartic("response", ROUGH),
    "response_at_0": ("F_0 m h", lambda *x: [at_0(*x), x[2] ** 2 + (x[1] + x[0]) ** 2]),
    "fold": quartic("fold", ROUGH),
    "fold_at_0": ("h h_A", lambda h, h_A: [value("fold", 0, 1, 0, 0, h, h_A)]),
    "cubic": ("Omega A p q", lambda w, A, p, q: [A * w**3 + p * w + q]),
    "cubic_slope": ("Omega A p", lambda w, A, p: [mp.diff(lambda v: A * v**3 + p * v, w)]),
    "rise": ("Omega A p k", rise),
    "response_fine": quartic("response", FINE),
    "response_beside": with_tail("response"),
    "response_derivative": ("A m zeta h", derivative("response")),
    "response_exactly_at_0": ("F_0 m h", lambda *x: [at_0(*x)]),
    "fold_fine": quartic("fold", FINE),
    "fold_beside": with_tail("fold"),
    "fold_derivative": ("A m zeta h h_A", derivative("fold")),
    "cubic_fine": ("Omega A p p_low q q_low", lambda w, A, p, pp, q, qq: [A * w**3 + (p + pp) * w + (q + qq)]),
    "discriminant": ("A p p_low q q_low", cubic_discriminant),
}
