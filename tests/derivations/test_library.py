"""The library's mechanisms; against their forces typed once more, averaged by quadrature."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from derivations import library
from derivations.paper.equation_of_motion import oscillator
from derivations.paper.restoring_force import restoring
from derivations.symbols import A
from slowflow import derive
from slowflow.app.cli import main
from slowflow.exact import steady_state, sweep
from tests.files import ROOT
from tests.oracles.exact_reference import again

PAGE = ROOT / "docs" / "mechanisms.md"
F = mp.mpf


def geometry_of_cams(u):
    """Two springs of stiffness 0.5 behind rollers of radius 0.8, still compressed by 0.1 on the flank."""
    across = mp.sqrt(1 - u**2)
    return -2 * F("0.5") * (F("0.1") + across - F("0.8")) * u / across


def geometry_of_springs(u):
    """Two springs of stiffness 0.9, half as long again as their place when they lie."""
    length = mp.sqrt(1 + u**2)
    return 2 * F("0.9") * (length - F("1.5")) * u / length


def polynomial(force, order):
    """Its Taylor polynomial at 0, by numerical differentiation."""
    coefficients = mp.taylor(force, 0, order)
    return lambda u: mp.polyval(coefficients[::-1], u)


#: numbers, the whole force for u > 0, and where it bends
CASES = {
    "bilinear": ({"kappa": "0.4", "delta": "0.2"}, lambda u: u - F("0.6") * max(u - F("0.2"), 0), "0.2"),
    "cam_roller": (
        {"r": "0.5", "rho": "0.8", "c": "0.1"},
        lambda u: u + (polynomial(geometry_of_cams, 5)(u) if u <= F("0.6") else 0),
        "0.6",
    ),
    "dead_zone": ({"delta": "0.2"}, lambda u: max(u - F("0.2"), 0), "0.2"),
    "elastic_stop": ({"kappa": "8", "delta": "0.2"}, lambda u: u + 8 * max(u - F("0.2"), 0), "0.2"),
    "three_spring": ({"alpha": "0.9", "ell": "1.5"}, lambda u: u + polynomial(geometry_of_springs, 3)(u), "2"),
}
#: of those that are not odd, for any u
SIDED = {"one_sided_stop": ({"kappa": 8, "delta": "0.2"}, lambda u: u + 8 * max(u - F("0.2"), 0), "0.2")}
#: forcings at Omega = 0.3 that take the mass beyond where the force bends; the three springs' is a polynomial up to 2
BEYOND_THE_BEND = {"bilinear": 0.3, "cam_roller": 0.7, "dead_zone": 0.3, "elastic_stop": 0.3, "one_sided_stop": 0.3}


def test_library_mechanisms_are_tested_and_documented():
    assert sorted({**CASES, **SIDED}) == library.names()
    shown = PAGE.read_text(encoding="utf-8")
    assert all(f'picture("{name}"' in shown for name in library.names())


@pytest.mark.parametrize("name", [pytest.param(one, marks=[pytest.mark.slow] * (one == "cam_roller")) for one in CASES])
def test_its_average_is_that_of_its_force(name):
    numbers, force, bend = CASES[name]
    stated = oscillator(library.stated(name))
    whole = restoring(stated.polynomials, tuple(stated.breakpoints))
    values = {symbol: sp.Rational(numbers[symbol.name]) for symbol in stated.mechanism.ratios}
    definitions = {symbol: value.subs(values) for symbol, value in stated.definitions.items()}
    with mp.workdps(30):
        for amplitude in ("0.15", "0.3", "0.9"):
            size, end = F(amplitude), F(bend)
            edges = [0, *([mp.acos(end / size)] if size > end else []), mp.pi / 2]
            expected = -4 / mp.pi * mp.quad(lambda t, size=size: force(size * mp.cos(t)) * mp.cos(t), edges)
            regime = whole.regimes[int(size > end)]
            found = regime.closed_form().subs(definitions).subs(A, sp.Rational(amplitude))
            assert mp.almosteq(F(str(sp.N(found, 30))), expected, rel_eps=F("1e-12"))


@pytest.mark.parametrize("name", SIDED)
def test_states_on_both_sides_have_their_forces_harmonics(name):
    numbers, force, bend = SIDED[name]
    one = derive.library(name)(**{key: float(value) for key, value in numbers.items()}, zeta=0.03)
    states = one.amplitudes(Omega=1.15, F_0=0.04)
    passes = states.A + states.B > float(bend)
    assert passes.any() and not passes.all()
    for Omega, size, mean in zip(states.Omega, states.A, states.B, strict=True):

        def motion(t, size=size, mean=mean):
            return F(mean) + F(size) * mp.cos(t)

        turn = (F(bend) - F(mean)) / F(size)
        edges = [0, *([mp.acos(turn)] if abs(turn) < 1 else []), mp.pi]
        middle, first = (mp.quad(lambda t, n=n, u=motion: force(u(t)) * mp.cos(t) ** n, edges) / mp.pi for n in (0, 1))
        assert abs(middle) < 1e-14
        assert mp.hypot(size * Omega**2 - 2 * first, 2 * one.zeta * size * Omega) == pytest.approx(0.04, rel=1e-12)


@pytest.mark.slow
def test_library_motions_are_independent_and_the_same_in_threads():
    """On both sides of the bend: to 1e-10 times the motion's condition, and of all threads the same digits.

    A sweep to that single frequency converges to them.
    """
    systems = {}
    for name, (numbers, _, _) in (CASES | SIDED).items():
        one = derive.library(name)(**{key: float(value) for key, value in numbers.items()}, mu=0.02, zeta=0.03)
        systems[name] = one.equation_of_motion()
    single = {name: steady_state(system, Omega=0.6, F_0=0.1) for name, system in systems.items()}
    with ThreadPoolExecutor(16) as pool:
        for one, found in zip(
            single.values(), pool.map(lambda one: steady_state(one, Omega=0.6, F_0=0.1), systems.values()), strict=True
        ):
            assert found.A == one.A and np.array_equal(found.multipliers, one.multipliers)
    beyond = {name: steady_state(systems[name], Omega=0.3, F_0=F_0) for name, F_0 in BEYOND_THE_BEND.items()}
    assert all(found.A > float((CASES | SIDED)[name][2]) for name, found in beyond.items())
    for name, found in [*single.items(), *beyond.items()]:
        assert found.residual <= 1e-14, name
        assert sweep(systems[name], Omega=[found.Omega], F_0=found.F_0).A[0] == found.A, name
        other = again(found)
        condition = 1.0 / (1.0 - np.max(np.abs(found.multipliers)))
        assert abs(other.A - found.A) <= 1e-10 * condition * found.A, name
        assert np.max(np.abs(other.multipliers - found.multipliers)) <= 1e-10 * condition, name


def test_unknown_library_name_is_refused_with_those_known(tmp_path, capsys):
    with pytest.raises(ValueError, match="'stop' is not in the library: it has bilinear, "):
        derive.library("stop")
    assert main(["derive", "stop", "-o", str(tmp_path / "out")]) == 2
    assert "no such file; Refused: 'stop' is not in the library" in capsys.readouterr().err
