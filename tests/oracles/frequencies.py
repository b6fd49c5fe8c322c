"""Certified positive roots of F, F_A and F_Omega: binary parameters in, enclosures and condition numbers out.

The coefficients are expanded exactly as rationals and the roots isolated by FLINT, so nothing here shares a step with
the compiled solvers.  The seeded stress cases for tests and benchmarks live here too.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from flint import arb, arb_poly, ctx, fmpq, fmpq_poly

U = 2.0**-53
BITS = 320
#: of a parameter, relatively
STEP = Fraction(1, 2**100)
KINDS = {
    "response": ("A", "h", "m", "zeta", "F_0"),
    "fold": ("A", "h", "h_A", "m", "zeta"),
    "peak": ("A", "h", "m", "zeta"),
}


def _polynomial(kind: str, parameters: Sequence[Fraction]) -> fmpq_poly:
    """Of Omega, exactly: F, or F_A or F_Omega but for a factor."""
    x = dict(zip(KINDS[kind], parameters, strict=True))
    A, h, m, zeta = x["A"], x["h"], x["m"], x["zeta"]
    if kind == "response":
        powers = [h**2 + m**2 - x["F_0"] ** 2, 4 * zeta * A * m, 2 * A * h + 4 * zeta**2 * A**2, Fraction(0), A**2]
    elif kind == "fold":
        powers = [h * x["h_A"], 2 * zeta * m, h + A * x["h_A"] + 4 * zeta**2 * A, Fraction(0), A]
    else:
        powers = [zeta * m, h + 2 * zeta**2 * A, Fraction(0), A]
    return fmpq_poly([fmpq(one.numerator, one.denominator) for one in powers])


def roots(kind: str, parameters: tuple[float, ...]) -> list[tuple[arb, float]]:
    """Positive roots in rising order, as often as their multiplicity, each with its condition number kappa.

    kappa is the sum over the parameters x of |x/Omega dOmega/dx|, infinite for a multiple root: by quotients of exact
    differences, whose error is STEP.
    """
    ctx.prec = BITS
    exact = [Fraction(value) for value in parameters]
    poly = _polynomial(kind, exact)
    neighbours = [_polynomial(kind, [*exact[:k], x * (1 + STEP), *exact[k + 1 :]]) for k, x in enumerate(exact)]
    found: list[tuple[arb, float]] = []
    for root, multiplicity in poly.complex_roots():
        if root.imag != 0 or not root.real > 0:
            continue
        kappa = float("inf")
        if multiplicity == 1:
            changes = sum((abs(arb_poly(one - poly)(root.real)) for one in neighbours), arb(0)) * STEP.denominator
            kappa = float(changes / abs(root.real * arb_poly(poly.derivative())(root.real)))
        found += [(root.real, kappa)] * multiplicity
    return sorted(found, key=lambda pair: float(pair[0]))


def relative_error(value: float, exact: arb) -> float:
    """|value - exact| / exact, rounded upwards."""
    ctx.prec = BITS
    return float(abs((arb(value) - exact) / exact).upper())


def stress_cases(kind: str, count: int, seed: int) -> dict[str, np.ndarray]:
    """Named families of `count` parameter rows each, in the order of KINDS[kind]."""
    drawn = _columns(kind, count, np.random.default_rng(seed))
    return {name: np.column_stack(columns) for name, columns in drawn.items()}


def _columns(kind: str, count: int, rng: np.random.Generator) -> dict[str, tuple[np.ndarray, ...]]:
    """The same, a column for each parameter."""

    def uniform(low: float, high: float) -> np.ndarray:
        return rng.uniform(low, high, count)

    def decades(low: float, high: float) -> np.ndarray:
        return 10 ** rng.uniform(low, high, count)

    def sign() -> np.ndarray:
        return rng.choice([-1.0, 1.0], count)

    def nearly(low: float, high: float) -> np.ndarray:
        return 1 + sign() * decades(low, high)

    def to_ulps(value: np.ndarray, most: int) -> np.ndarray:
        return value + rng.integers(-most, most + 1, count) * np.spacing(value)

    zero = np.zeros(count)
    few_zeros = rng.choice([0.0, 1e-12, 1e-3, 0.1], (2, count))

    if kind == "peak":
        A, m = decades(-2, 1), decades(-3, 0)
        zeta, wc = decades(-3, 0), decades(-1, 1)
        brink = zeta * m / (2 * wc**3)  # A that makes both roots meet at wc, for p = -3 A wc^2
        level = -(3 * brink * wc**2 + 2 * zeta**2 * brink)
        return {
            "mild": (uniform(0.1, 2), uniform(-2, 1), uniform(0, 0.1), uniform(0, 0.2)),
            "decades": (A, sign() * decades(-3, 2), m, zeta),
            "zeros": (decades(-8, 3), sign() * decades(-3, 2), *few_zeros),
            "extreme A": (rng.choice([1e-8, 1e8], count) * uniform(1, 2), -decades(-9, 9), m, zeta),
            "near double": (brink, level * nearly(-16, -3), m, zeta),
            "double to an ulp": (brink, to_ulps(level, 4), m, zeta),
            "h near -2 zeta^2 A": (A, -2 * zeta**2 * A * nearly(-16, 0), m * 1e-6, zeta),
        }

    if kind == "fold":
        A, h, m, zeta, w = decades(-2, 1), -decades(-2, 1), decades(-4, -1), decades(-3, -0.5), decades(-0.5, 0.5)
        # F_A = 0 and its slope, solved for R and T = w^2 + h_A: R T = -X, A T + R = S; a double root but for rounding
        I = 2 * zeta * A * w + m
        X = 2 * zeta * w * I
        S = -zeta * (m + 4 * zeta * A * w) / w
        disc = np.sqrt(np.maximum(S**2 + 4 * A * X, 0))
        R2 = (S + sign() * disc) / 2
        h2, hA2 = R2 - A * w**2, -X / R2 - w**2
        return {
            "mild": (uniform(0.1, 2), uniform(-2, 1), uniform(-4, 1), uniform(0, 0.1), uniform(0, 0.2)),
            "decades": (A, sign() * decades(-3, 2), sign() * decades(-3, 3), m, decades(-4, 0)),
            "zeros": (decades(-3, 3), sign() * decades(-3, 2), sign() * decades(-3, 2), *few_zeros),
            "extreme A": (rng.choice([1e-8, 1e8], count), sign() * decades(-9, 9), sign() * decades(-2, 2), m, zeta),
            "beside a corner": (A, h, sign() * decades(3, 300), m, zeta),
            "near double": (A, h2, hA2 * nearly(-16, -3), m, zeta),
            "three roots": (A, decades(-6, -2), -decades(-2, 1), decades(-2, 0), decades(-2, 0)),
            "h = -A h_A nearly": (A, h, -h / A * nearly(-16, -1), m, zeta),
            "h = A h_A nearly": (A, h, h / A * nearly(-16, -1), m * 1e-6, zeta * 1e-3),
        }

    A, m, zeta, w = decades(-2, 1), decades(-4, -1), decades(-3, -0.5), decades(-0.7, 0.7)
    I = 2 * zeta * A * w + m
    R = -zeta * I / w  # F_Omega = 0 at w: the critical value is R^2 + I^2 - F_0^2
    touch = np.hypot(R, I)
    # (w1 is a maximum where q = zeta m is large beside it) and all three roots close together
    zeta3, w3 = decades(-1, 1), decades(-1, 1)
    m3 = 2 * A * w3**3 / zeta3
    h3 = -3 * A * w3**2 - 2 * zeta3**2 * A
    F3 = np.hypot(A * w3**2 + h3, 2 * zeta3 * A * w3 + m3)
    # three roots: F_0 between the values at 0, at the maximum and at the minimum of R^2 + I^2
    rho = 1 - decades(-5, -0.3)
    wc = np.cbrt(zeta3 * m3 / (2 * A * rho))
    three_h = -3 * A * wc**2 - 2 * zeta3**2 * A
    angle = np.arccos(rho) / 3
    level = [
        (A * y**2 + three_h) ** 2 + (2 * zeta3 * A * y + m3) ** 2
        for y in (zero, *(wc * (np.cos(angle) + side * np.sqrt(3) * np.sin(angle)) for side in (-1, 1)))
    ]
    floor = np.maximum(level[0], level[2])
    three_F = np.sqrt(floor + (level[1] - floor) * rng.choice([0.5, 1e-3, 1 - 1e-3, 1e-9, 1 - 1e-9], count))
    h0 = decades(-2, 1)
    m0 = h0 * decades(-2, 2)
    near_0 = np.hypot(h0, m0)
    triples = np.array([[3, 4, 5], [12, 5, 13], [8, 15, 17], [20, 21, 29]])[rng.integers(0, 4, count)].T / 16
    return {
        "mild": (uniform(0.1, 2), uniform(-2, 1), uniform(0, 0.1), uniform(0, 0.2), uniform(0.05, 2)),
        "decades": (A, sign() * decades(-3, 2), m, decades(-4, 0), decades(-3, 2)),
        "F_0 << |h|": (A, -h0, h0 * decades(-16, -8), decades(-15, -8), h0 * decades(-13, -6)),
        "near tangent": (A, R - A * w**2, m, zeta, touch * nearly(-16, -2)),
        "tangent to an ulp": (A, R - A * w**2, m, zeta, to_ulps(touch, 4)),
        "extreme A": (rng.choice([1e-8, 1e8], count) * uniform(1, 2), sign() * decades(-9, 9), m, zeta, decades(-2, 3)),
        "zeros": (decades(-3, 3), sign() * decades(-3, 2), *few_zeros, decades(-2, 2)),
        "zeta = 0, F_0 near m": (A, -h0, m, zero, m * (1 + decades(-16, -1))),
        "h near 0": (A, sign() * decades(-20, -3), m, decades(-4, 0), decades(-3, 0)),
        "F(0) near 0": (A, -h0, m, zeta, np.hypot(h0, m) * nearly(-16, -1)),
        "F(0) near 0 to an ulp": (A, -h0, m0, zeta, to_ulps(near_0, 1)),
        "F(0) = 0 to an ulp": (A, sign() * triples[0], triples[1], decades(-20, 0), to_ulps(triples[2], 1)),
        "three roots": (A, three_h, m3, zeta3, three_F),
        "near triple": (A, h3 * nearly(-16, -2), m3, zeta3, F3 * nearly(-16, -4)),
    }
