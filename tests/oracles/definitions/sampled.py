"""A force that is known by its values: nodes of the quadrature and what is summed over them."""

from __future__ import annotations

import functools
import random

from mpmath import mp, mpf

from tests.oracles.definitions.points import Function, entry


def cut_off(lost, b, order=0):
    """What is lost at b, as the polynomial that acts below it, and its derivatives."""
    return lambda u: sum(
        one * (u - b) ** (k - order) / mp.factorial(k - order) for k, one in enumerate(lost) if k >= order
    )


@functools.cache
def nodes(precision):
    """Gauss's rule for what is a sum of a few sines."""
    return [*zip(*mp.gauss_quadrature(40, "legendre"), strict=True)]


def below_end(A, b, lost, n, order):
    """An integral of a derivative of that over 0 < u < b: sine^order and cos(n psi) stand beside it."""

    end = mp.asin(b / A)
    total = mpf(0)
    for x, weight in nodes(mp.prec):
        t = end * (1 + x) / 2
        s = mp.sin(t)
        total += weight * cut_off(lost, b, order)(A * s) * s**order * (-1) ** ((n - 1) // 2) * mp.sin(n * t)
    return -2 / mp.pi * end * total


def by_end(n, first, last):
    """What is in derivatives of h_n by A beyond the integrals of derivatives."""

    def f(A, b, *lost):
        def whole(a):
            return below_end(a, b, lost, n, 0)

        return [mp.diff(whole, A, k) - below_end(A, b, lost, n, k) for k in range(first, last + 1)]

    return f


def intercept_by_end(A, b, lost_0, lost_1):
    lost = (lost_0, lost_1)
    slope = mp.diff(lambda a: below_end(a, b, lost, 1, 0), A)
    # the integral of f'' has nothing of a straight line; what is at rest is told apart
    return [below_end(A, b, lost, 1, 0) - A * slope + 4 / mp.pi * cut_off(lost, b)(0)]


def on_sine(n, orders=4):
    return lambda s, *f: [-4 / mp.pi * f[k] * s**k * mp.cos(n * mp.acos(s)) for k in range(orders)]


SAMPLED: dict[str, Function] = {
    "at_rest": lambda f: [-4 / mp.pi * mp.quad(lambda t: f * mp.sin(t), [0, mp.pi / 2])],
    "averaged_terms": on_sine(1),
    "averaged_end": by_end(1, 1, 3),
    "intercept_terms": lambda A, s, c, f_uu: [4 / mp.pi * A**2 * f_uu * s * c**2],
    "intercept_end": intercept_by_end,
    "harmonics_terms": lambda *x: on_sine(3)(*x) + on_sine(5)(*x),
    "harmonics_end": lambda *x: by_end(3, 1, 3)(*x) + by_end(5, 1, 3)(*x),
    "bent_terms": lambda s, f, f_uuuu: [-4 / mp.pi * f * s, -4 / mp.pi * f_uuuu * s**5],
    **{
        f"bent_end_{lowest}": lambda A, b, *lost, lowest=lowest: by_end(1, 4, 4)(A, b, *(0,) * lowest, *lost)
        for lowest in range(4)
    },
}


def sampled_table(rng: random.Random) -> dict:
    """Ends beside amplitudes and far below them; forces and losses of any sign."""
    table = {}
    for kernel, f in SAMPLED.items():
        count = {"at_rest": 1, "intercept_terms": 1, "intercept_end": 2, "bent_terms": 2}.get(kernel, 4)
        count = 3 if kernel in ("averaged_end", "harmonics_end") else count
        count = 4 - int(kernel[-1]) if kernel.startswith("bent_end") else count
        rows = []
        for share in (0.05, 0.4, 0.8, 0.99, 0.9999):
            numbers = [rng.uniform(-1, 1) for _ in range(count)]
            A = rng.uniform(0.2, 1.0)
            before = [A, share * A] if "end" in kernel else [share] if kernel.endswith("s") else []
            before = [A, share, rng.uniform(0.1, 0.9)] if kernel == "intercept_terms" else before
            rows.append(entry(f, [*before, *numbers]))
        table[kernel] = rows
    return table
