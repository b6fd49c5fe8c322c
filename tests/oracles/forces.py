"""Averages of forces of any kind to 40 certified digits: forces of `pieces` in, h and three derivatives by A out.

It shares nothing with `derivations/`: no derivative is taken under the integral by hand and no angle moves. In u the
average is, with A beyond the pieces' ends b but the last,

    h = -(4/pi) sum over pieces of int f(u) u/(A sqrt(A^2 - u^2)) du

and A is a power series A_0 + e in the integrand, whose coefficients are integrated one by one by FLINT's rigorous
quadrature. The ends b are fixed; the last piece's is u = A (1 - z^2) + b z^2, 0 < z < 1, where the root is gone:

    int f(u) u/(A sqrt(A^2 - u^2)) du = int 2 f(u) u sqrt(A - b)/(A sqrt(A + u)) dz

A contact's force is stated in sqrt(u - b): with z = sin w that is sqrt(A - b) cos w, whose root is gone as well.

`python -m tests.oracles.forces` writes tests/data/forces.json.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

from flint import acb, acb_series, arb, ctx

from tests.files import store
from tests.oracles.averaged import digits, exact
from tests.oracles.certified_roots import precision
from tests.oracles.pieces import AVERAGED, in_excess, on_series, root

BITS, TOLERANCE = 320, 280
ORDERS = 3
#: relative step of a difference that gives a condition number
STEP = arb(2) ** -80


def next_to(end: float) -> list[float]:
    """Amplitudes just beyond a piece's end."""
    return [end * (1 + excess) for excess in (5e-11, 1e-7)]


#: each force's numbers and amplitudes
FORCES: dict[str, tuple[dict[str, float], list[float]]] = {
    "pendulum": ({"k": 1.3}, [0.01, 0.5, 1.7, 3.0]),
    "preload": ({"c": 0.02, "k": 1.0}, [0.01, 0.3, 2.0]),
    "quadratic": ({"k": 0.3, "c": 1.0}, [0.05, 0.4, 3.0]),
    "preloaded_stop": (
        {"c": 0.02, "k": 1.0, "p": 8.0, "gap": 0.3},
        [0.2, 0.3 + 2.0**-40, 0.3001, 0.313, 0.33, 0.9, 40.0],
    ),
    "let_go": ({"c": 0.2, "k": 1.0, "p": 0.7, "gap": 0.5}, [0.02, 0.5 + 2.0**-40, 0.5001, 0.52, 0.6, 2.0, 300.0]),
    "wave": ({"k": 0.3, "c": 5.0}, [0.1, 0.9, 4.0]),
    "saturating": ({"k": 4.0}, [0.02, 0.3, 2.5]),
    "exponential": ({"k": 0.5, "c": 2.0}, [0.05, 0.7, 2.0]),
    "oblique": ({"k": 1.3, "c": 0.6}, [0.05, 0.5, 2.0]),
    "arctangent": ({"k": 0.3}, [0.05, 0.5, 3.0]),
    "dead": ({"k": 3.0, "gap": 0.1}, [0.1001, 0.15, 0.8]),
    "hard_stop": ({"k": 3.0, "gap": 0.1}, [0.1001, 0.13, 0.9]),
    "soft_stop": ({"k": 3.0, "c": 5.0, "gap": 0.2}, [0.2001, 0.25, 1.1]),
    "two_stops": (
        {"k": 3.0, "c": 5.0, "gap": 0.1, "end": 0.3, "p": 4.0},
        [0.05, *next_to(0.1), 0.13, 0.29, *next_to(0.3), 0.3001, 0.5, 2.0],
    ),
    "two_steps": (
        {"k": 1.5, "c": 2.0, "gap": 0.2, "end": 0.25, "p": 0.7},
        [0.1, *next_to(0.2), 0.21, 0.249, *next_to(0.25), 0.26, 1.0],
    ),
    "letting_go": ({"k": 1.5, "gap": 0.5}, [0.3, 0.5001, 0.6, 2.0]),
    "hertz": ({"k": 3.0, "gap": 0.1}, [0.05, 0.1 + 2.0**-40, 0.1001, 0.13, 0.9, 40.0]),
    "buffer": ({"k": 4.0, "c": 2.0, "gap": 0.2}, [0.2 + 2.0**-40, 0.21, 0.5, 2.0]),
}
#: whose last pieces are stated in the root of what u exceeds their begin by
CONTACTS = ("hertz", "buffer")


@cache
def pieces_of(name: str) -> tuple[list[Callable[..., Any]], list[str]]:
    """The force's pieces on series, and where they end."""
    pieces = AVERAGED[name]
    forces = [force for force, _ in pieces]
    if name in CONTACTS:
        forces[-1] = in_excess(forces[-1], pieces[-2][1])
    return [on_series(force) for force in forces], [str(until) for _, until in pieces[:-1]]


def average(name: str, A: arb, numbers: dict[str, arb]) -> list[arb]:
    """h and its derivatives."""
    pieces, names = pieces_of(name)

    def number(key: str) -> acb:
        return acb(numbers[key])

    at, ends = acb(A), [number(end) for end in names if numbers[end] < A]
    totals = [acb(0)] * (ORDERS + 1)
    for k, (low, high) in enumerate(zip([acb(0), *ends], [*ends, None], strict=True)):
        for order in range(ORDERS + 1):

            def coefficient(z: acb, _: bool, order: int = order, k: int = k, low=low, high=high) -> acb:
                ctx.cap = ORDERS + 1
                a = acb_series([at, 1])
                try:
                    if high is None and k and name in CONTACTS:
                        u, turn = a * z.cos() ** 2 + low * z.sin() ** 2, z.cos()
                        excess = root(a - low) * turn
                        value = 2 * pieces[k](u, number, excess) * u * root(a - low) * turn / (a * root(a + u))
                    elif high is None:
                        u = a * (1 - z * z) + low * z * z
                        value = 2 * pieces[k](u, number) * u * root(a - low) / (a * root(a + u))
                    else:
                        value = pieces[k](acb_series([z]), number) * z / (a * root(a * a - z * z))
                except ValueError:
                    return acb("nan")
                return value[order]

            last = acb.pi() / 2 if k and name in CONTACTS else acb(1)
            limits = (acb(0), last) if high is None else (low, high)
            totals[order] += acb.integral(
                coefficient, *limits, rel_tol=arb(2) ** -TOLERANCE, abs_tol=arb(2) ** -TOLERANCE
            )
    return [(-4 / arb.pi() * total.real) * math.factorial(order) for order, total in enumerate(totals)]


def case(name: str, A: float) -> dict[str, Any]:
    """The values at one amplitude, and their condition: the sum of |dh/dp p/h| over A and the numbers."""
    parameters = FORCES[name][0]
    with precision(BITS):
        amplitude, numbers = arb(exact(A)), {key: arb(exact(value)) for key, value in parameters.items()}
        values = average(name, amplitude, numbers)
        shifted = [average(name, amplitude * (1 + STEP), numbers)]
        shifted += [average(name, amplitude, {**numbers, key: value * (1 + STEP)}) for key, value in numbers.items()]
        conditions = []
        for order, value in enumerate(values):
            total = sum(abs(float((one[order] - value) / STEP)) for one in shifted)
            conditions.append(float(f"{total / abs(float(value)):.3g}") if not vanishes(value) else None)
        printed = ["0" if vanishes(value) else digits(value) for value in values]
    return {"force": name, "numbers": parameters, "A": A, "h": printed, "condition": conditions}


def vanishes(value: arb) -> bool:
    """Whether a derivative is 0, as the third one of a parabola: it is below 1e-45."""
    return bool(abs(value) < arb(10) ** -45)


if __name__ == "__main__":
    store("forces", [case(name, A) for name, (_, amplitudes) in FORCES.items() for A in amplitudes])
