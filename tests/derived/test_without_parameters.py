"""A force that has no number of its own: it answers as the same force does with its numbers as parameters."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from slowflow import Duffing, derive
from tests.sampling import slow

u, k, gap = sp.symbols("u k gap")
STOP = sp.Rational(1, 5)
#: the pieces in numbers, the same with parameters, and these
FORCES = {
    "cubic": ([(u + u**3, None)], [(u + k * u**3, None)], {"k": 1.0}),
    "stop": ([(u, STOP), (2 * u - STOP, None)], [(u, gap), (2 * u - gap, None)], {"gap": 0.2}),
    "curved": (
        [(u, STOP), (u + sp.sinh(u - STOP), None)],
        [(u, STOP), (u + k * sp.sinh(u - STOP), None)],
        {"k": 1.0},
    ),
    "pendulum": ([(sp.sin(u), None)], [(k * sp.sin(u), None)], {"k": 1.0}),
}
DAMPING = {"mu": 0.01, "zeta": 0.03}
F_0 = 0.06
#: name and whether it is compiled; each is derived twice
CASES = [
    ("cubic", False),
    *slow(("stop", False), ("pendulum", False)),
    *slow(*((name, True) for name in ("cubic", "stop", "pendulum"))),
]


def pair(name, compile=False):
    bare, named, parameters = FORCES[name]
    reach = {"reach": 3.1} if name == "pendulum" else {}
    whole = derive.mechanism(f"bare_{name}", bare, {}, compile=compile, **reach)
    return (
        whole,
        derive.mechanism(f"named_{name}", named, {one: {"above": 0} for one in parameters}, **reach),
        parameters,
    )


@pytest.mark.parametrize(("name", "compile"), CASES)
def test_answers_are_those_of_the_force_with_parameters(name, compile):
    made, other, parameters = pair(name, compile)
    one, same = made(**DAMPING), other(**parameters, **DAMPING)
    for ask in (
        lambda osc: osc.saddle_nodes(F_0).A,
        lambda osc: osc.amplitudes(Omega=[0.7, 1.1], F_0=F_0).A,
        lambda osc: osc.saddle_node_onset().F_SN,
        lambda osc: osc.peak(F_0).A,
        lambda osc: osc.second_approximation.amplitudes(Omega=0.9, F_0=F_0).A,
        lambda osc: osc.replace(eta=0.02).saddle_nodes(F_0).A,
        lambda osc: osc.replace(excitation="base").amplitudes(Omega=1.1, F_0=F_0).A,
        lambda osc: osc.steady_state(Omega=0.8, F_0=F_0).A,
    ):
        assert ask(one) == pytest.approx(ask(same), rel=1e-12)
    assert repr(one).endswith("mu=0.01, zeta=0.03)") and one.replace(zeta=0.03) == one


@pytest.mark.slow
@pytest.mark.parametrize(("name", "compile"), CASES)
def test_gradients_are_by_damping_and_the_forcing_alone(name, compile):
    made, other, parameters = pair(name, compile)
    one, same = made(**DAMPING), other(**parameters, **DAMPING)
    found, expected = one.saddle_nodes(F_0).gradient(), same.saddle_nodes(F_0).gradient()
    assert found.by == ("mu", "zeta", "F_0")
    for which in found.by:
        for of in ("Omega", "A"):
            assert found[of, which] == pytest.approx(expected[of, which], rel=1e-9)


@pytest.mark.parametrize("compile", [False, *slow(True)])
def test_batches_are_over_damping(compile):
    made, _, _ = pair("cubic", compile)
    zeta = np.array([0.03, 0.05])
    found = made.many(mu=0.01, zeta=zeta).saddle_node_onset()
    singles = [Duffing(1.0, 1.0, mu=0.01, zeta=one).saddle_node_onset().F_SN for one in zeta]
    assert found.F_SN == pytest.approx(singles, rel=1e-14)


@pytest.mark.parametrize(
    ("name", "odd", "load"), [("stop", False, 0.0), *slow(("curved", True, 0.1), ("curved", False, 0.1))]
)
def test_off_the_centre_too(name, odd, load):
    """A stop on one side; a force that is no polynomial, odd under a load, and on one side with an end."""
    bare, named, parameters = FORCES[name]
    damping, about = {"mu": 0.0, "zeta": 0.04, "load": load}, {one: {"above": 0} for one in parameters}
    one = derive.mechanism(f"bare_{name}_{odd}", bare, {}, odd=odd)(**damping)
    same = derive.mechanism(f"named_{name}_{odd}", named, about, odd=odd)(**parameters, **damping)
    for ask in (lambda osc: osc.amplitudes(Omega=1.1, F_0=F_0), lambda osc: osc.saddle_nodes(F_0)):
        found, expected = ask(one), ask(same)
        assert (found.A, found.B) == (pytest.approx(expected.A, rel=1e-12), pytest.approx(expected.B, rel=1e-12))
        of, to = found.gradient(), expected.gradient()
        assert of.by == tuple(by for by in to.by if by not in parameters)
        for by in of.by:
            assert of["A", by] == pytest.approx(to["A", by], rel=1e-9)
