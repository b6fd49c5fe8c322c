"""A force of two linear pieces along the balance of its mean: closed forms by quadrature, and what solvers rest on."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import mpmath
import pytest
import sympy as sp

from derivations.asymmetric import one_end
from derivations.library import stated

mp: Any = mpmath.mp.clone()
mp.dps = 40


@cache
def derived() -> Any:
    return one_end.derive(stated("one_sided_stop"))


def force(v: Any, kappa: Any, delta: Any) -> Any:
    return v + (kappa * (v - delta) if v > delta else 0)


def mean(f: Any, A: Any, B: Any, delta: Any) -> Any:
    """Of f(psi) over a cycle, cut where the motion meets the stop."""
    at = (delta - B) / A
    cuts = [mp.acos(at)] if abs(at) < 1 else []
    return mp.quad(f, [0, *cuts, mp.pi]) / mp.pi


def balanced(A: Any, kappa: Any, delta: Any) -> tuple[Any, Any]:
    """B and h by bisection and quadrature."""

    def f_0(B: Any) -> Any:
        return mean(lambda psi: force(B + A * mp.cos(psi), kappa, delta), A, B, delta)

    B = mp.findroot(f_0, (-A, A / 100), solver="anderson", tol=1e-60)
    return B, -2 * mean(lambda psi: force(B + A * mp.cos(psi), kappa, delta) * mp.cos(psi), A, B, delta)


def numbers(A: Any, kappa: Any, delta: Any) -> tuple[list[Any], Any]:
    """The derived h, h_A, h_AA, h_AAA, h - A h_A, and B."""
    of = derived()
    design = {one.symbol: value for one, value in zip(stated("one_sided_stop").design, (kappa, delta), strict=True)}
    k, g, end, rest, side = (mp.mpf(sp.N(one.subs(design), 45)) for one in of.parameters[0 if delta >= 0 else 1])
    excess = sp.lambdify((one_end.a, one_end.g), of.excess, mp)
    a = mp.findroot(lambda a: excess(a, g) - (1 - end / A), (mp.mpf("1e-12"), mp.pi), solver="anderson", tol=1e-70)
    N = sp.lambdify(one_end.a, of.N, mp)(a)
    s = sp.lambdify((one_end.a, one_end.g), of.slope, mp)(a, g)
    symbols = (one_end.k, one_end.g, one_end.A, one_end.S, one_end.C, one_end.s, one_end.E, sp.Symbol("N"))
    rows = sp.lambdify(symbols, of.known, mp)(k, g, A, mp.sin(a), mp.cos(a), s, end / A, N)
    return rows, rest - side * A * sp.lambdify((one_end.a, one_end.g), of.offset, mp)(a, g)


@pytest.mark.slow
@pytest.mark.parametrize(("kappa", "delta", "A"), [("8", "0.2", "0.3"), ("8", "-0.9", "0.2"), ("0.3", "0.2", "5")])
def test_the_closed_forms_are_the_averages_along_the_balance(kappa: str, delta: str, A: str) -> None:
    stiff, gap, at = mp.mpf(kappa), mp.mpf(delta), mp.mpf(A)
    rows, B = numbers(at, stiff, gap)
    B_found, h_found = balanced(at, stiff, gap)
    assert abs(B - B_found) < 1e-25 and abs(rows[0] - h_found) < 1e-25
    for order in (1, 2, 3):
        slope = mp.diff(lambda x, order=order: numbers(x, stiff, gap)[0][order - 1], at)
        assert abs(rows[order] - slope) < mp.mpf("1e-15") * abs(slope)
    assert abs(rows[4] - (rows[0] - at * rows[1])) < 1e-30


@pytest.mark.parametrize("g", ["-0.99", "-0.5", "-0.01", "0.01", "1", "30", "10000"])
def test_the_third_derivative_is_monotone_beyond_the_end(g: str) -> None:
    """By the angle of contact, up to that of endless amplitudes; end = k = 1."""
    of, gain = derived(), mp.mpf(g)
    excess = sp.lambdify((one_end.a, one_end.g), of.excess, mp)
    slope = sp.lambdify((one_end.a, one_end.g), of.slope, mp)
    row = sp.lambdify((one_end.k, one_end.g, one_end.A, one_end.S, one_end.C, one_end.s, one_end.E), of.known[3], mp)
    low, high = mp.mpf(0), mp.pi
    for _ in range(120):
        middle = (low + high) / 2
        low, high = (middle, high) if excess(middle, gain) < 1 else (low, middle)
    found = []
    for i in range(1, 200):
        a = low * i / 200
        E = 1 - excess(a, gain)
        found.append(row(1, gain, 1 / E, mp.sin(a), mp.cos(a), slope(a, gain), E))
    steps = [after - before for before, after in pairwise(found)]
    assert all(step * steps[0] > 0 for step in steps)
