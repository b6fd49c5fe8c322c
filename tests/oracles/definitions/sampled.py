"""A force that is known by its values: what is summed over nodes, and what is beside that where the force bends."""

from __future__ import annotations

from mpmath import mp, mpf

from tests.oracles.definitions.points import Definitions


def cut_off(lost, b, order=0):
    """What is lost at b, as the polynomial that acts below it, and its derivatives."""
    return lambda u: sum(
        one * (u - b) ** (k - order) / mp.factorial(k - order) for k, one in enumerate(lost) if k >= order
    )


def sine_integrals(end, count):
    """Of sin(t)^k over 0 < t < end, by parts from the two below."""
    with mp.extraprec(40 + count * max(0, -mp.mag(end))):
        s, c = mp.sin(end), mp.cos(end)
        found = [+end, 2 * mp.sin(end / 2) ** 2]
        for k in range(2, count):
            found.append(((k - 1) * found[k - 2] - s ** (k - 1) * c) / k)
        return found


#: cos(n psi) by powers of sin(t), where that is cos(psi)
ON_SINE = {1: {1: 1}, 3: {1: -3, 3: 4}, 5: {1: 5, 3: -20, 5: 16}}


def below_end(A, b, lost, n, order):
    """An integral of a derivative of that over 0 < u < b: sine^order and cos(n psi) stand beside it."""
    total = mpf(0)
    integrals = sine_integrals(mp.asin(b / A), len(lost) + 6 + order)
    for k, one in enumerate(lost):
        for j in range(k - order + 1):  # (A sine - b)^(k - order)
            power = A**j * (-b) ** (k - order - j) / (mp.factorial(j) * mp.factorial(k - order - j))
            total += one * power * sum(coefficient * integrals[j + order + m] for m, coefficient in ON_SINE[n].items())
    return -4 / mp.pi * total


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


LOST, TERMS = "A b lost_0 lost_1 lost_2", "sine f f_u f_uu f_uuu"
SAMPLED: Definitions = {
    "at_rest": ("f", lambda f: [-4 / mp.pi * f * sine_integrals(mp.pi / 2, 2)[1]]),
    "averaged_terms": (TERMS, on_sine(1)),
    "averaged_end": (LOST, by_end(1, 1, 3)),
    "intercept_terms": ("A sine cosine f_uu", lambda A, s, c, f_uu: [4 / mp.pi * A**2 * f_uu * s * c**2]),
    "intercept_end": ("A b lost_0 lost_1", intercept_by_end),
    "harmonics_terms": (TERMS, lambda *x: on_sine(3)(*x) + on_sine(5)(*x)),
    "harmonics_end": (LOST, lambda *x: by_end(3, 1, 3)(*x) + by_end(5, 1, 3)(*x)),
    "bent_terms": ("sine f f_uuuu", lambda s, f, f_uuuu: [-4 / mp.pi * f * s, -4 / mp.pi * f_uuuu * s**5]),
    **{
        f"bent_end_{lowest}": (
            " ".join(("A b", *(f"lost_{order}" for order in range(lowest, 4)))),
            lambda A, b, *lost, lowest=lowest: by_end(1, 4, 4)(A, b, *(0,) * lowest, *lost),
        )
        for lowest in range(4)
    },
}


#: forces and losses of any sign
BETWEEN = {name: (-1.0, 1.0) for name in "f f_u f_uu f_uuu f_uuuu lost_0 lost_1 lost_2 lost_3".split()}
BETWEEN |= {"A": (0.2, 1.0), "b": (0.0, 1.0), "sine": (0.0, 1.0), "cosine": (0.1, 0.9)}


def place(_: str, names: list[str], number: int, x: list[float]) -> None:
    """Ends beside amplitudes and far below them."""
    ratio = (0.05, 0.4, 0.8, 0.99, 0.9999)[number]
    if "b" in names:
        x[names.index("b")] = ratio * x[names.index("A")]
    elif "sine" in names:
        x[names.index("sine")] = ratio
