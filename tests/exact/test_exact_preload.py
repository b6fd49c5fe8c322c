"""Exact motions under a force that jumps at u = 0: against SciPy from event to event, on one side at a time."""

import math

import numpy as np
import pytest
import sympy as sp

from slowflow import Oscillator, derive
from tests.oracles import by_time
from tests.oracles.exact_reference import again
from tests.sampling import slow

u, c, k, hard, gap = sp.symbols("u c k hard gap")
ABOVE_0 = {"above": 0}
C, K, MU, ZETA = 0.05, 1.0, 0.01, 0.05


@pytest.fixture(scope="module", params=[False, *slow(True)], ids=["interpreted", "compiled"])
def spring(request):
    """A preload on a linear spring."""
    made = derive.mechanism("sprung", [(c + k * u, None)], {"c": ABOVE_0, "k": ABOVE_0}, compile=request.param)
    return made(c=C, k=K, mu=MU, zeta=ZETA)


PRECISE = {"rtol": 1e-13, "atol": 1e-15, "max_step": 0.1}


def slips(spring, Omega, F_0, span, state):
    """Motion from a state on, without rests, by SciPy."""
    push = lambda tau: F_0 * math.cos(Omega * tau)  # noqa: E731
    return by_time.stretches(spring, lambda u: K * u, push, span, state, preload=C, **PRECISE)


def over_a_period(spring, Omega, F_0, state):
    """The state a period later."""
    *_, last = slips(spring, Omega, F_0, (0.0, 2 * math.pi / Omega), state)
    return np.array([last.u[-1], last.v[-1]])


def multipliers_at(spring, Omega, F_0, here, step=1e-5):
    """Of the map over a period, by differences."""
    differences = [
        over_a_period(spring, Omega, F_0, here + step * e) - over_a_period(spring, Omega, F_0, here - step * e)
        for e in np.eye(2)
    ]
    return np.sort_complex(np.linalg.eigvals(np.column_stack(differences) / (2 * step)))


@pytest.mark.slow
@pytest.mark.parametrize("Omega", [0.8, 1.3])
def test_multipliers_are_those_of_integration_between_events(spring, Omega):
    F_0 = 0.15
    found = spring.steady_state(Omega=Omega, F_0=F_0)
    assert found.stops == 0 and found.symmetric and len(found.phases) == 2
    here = np.array(found._state(0.0))
    assert np.max(np.abs(over_a_period(spring, Omega, F_0, here) - here)) <= 1e-13
    np.testing.assert_allclose(np.sort_complex(found.multipliers), multipliers_at(spring, Omega, F_0, here), atol=1e-7)
    assert abs(found.A / spring.amplitudes(Omega=Omega, F_0=F_0).A[0] - 1) < 0.05


def test_a_curve_passes_from_motions_with_stops_to_such_without(spring):
    curve = spring.exact_response(0.15, Omega=(0.4, 2.0))
    assert {0, 2} <= set(curve.stops.tolist()) and curve.stable[curve.Omega > 0.6].all()
    # below, a motion that is its own mirror image gives way to two that are not
    state = curve.steady_state(int(np.argmin(np.abs(curve.Omega - 0.545))))
    assert state.symmetric and not state.stable and state.stops == 0
    parted = multipliers_at(spring, state.Omega, 0.15, np.array(state._state(0.0)))
    np.testing.assert_allclose(np.sort_complex(state.multipliers), parted, atol=1e-6)
    settles = spring.steady_state(Omega=state.Omega, F_0=0.15)
    assert settles.stable and not settles.symmetric
    top = int(np.argmax(curve.A))
    # in between the jump is as a force of its first harmonic: averaging errs by its third, a ninth of 4 c/pi
    assert curve.A[top] == pytest.approx(spring.peak(0.15).A, rel=0.02)
    swept = spring.sweep(Omega=[0.5, 0.9, 1.2, 1.6], F_0=0.15)
    assert swept.settled.all()
    for Omega, A in zip(swept.Omega, swept.A, strict=True):
        assert spring.steady_state(Omega=Omega, F_0=0.15).A == pytest.approx(A, rel=1e-9)


@pytest.mark.slow
@pytest.mark.part(2)
def test_rest_on_a_jump_of_the_force_is_followed_and_said(spring):
    """It moves off where F_0 cos(theta) = mu + c, and how far it gets is known from there on."""
    Omega, F_0 = 0.2, 0.065
    swept = spring.sweep(Omega=[Omega], F_0=F_0)
    start = -math.acos((MU + C) / F_0) / Omega
    slip = next(one for one in slips(spring, Omega, F_0, (start, 10.0), (0.0, 0.0)) if one.slip)
    A = slip.u[-1]
    assert abs(slip.v[-1]) < 1e-12 and swept.settled.all() and swept.A[0] == pytest.approx(A, rel=1e-7)
    with pytest.raises(ArithmeticError, match="the mass comes to rest at u = 0 in each period, where the force jumps"):
        spring.steady_state(Omega=Omega, F_0=F_0)


@pytest.mark.slow
def test_force_below_friction_and_preload_leaves_a_mass_at_rest(spring):
    state = spring.steady_state(Omega=0.6, F_0=0.0599)  # mu and what the force jumps to at u = 0 are 0.06
    assert state.A == 0 and state.stable
    assert spring.transient(acceleration=0.0599, duration=3.0).A == 0
    shock = spring.transient(acceleration=0.2, duration=3.0)
    many = Oscillator.many(spring.model.mechanism, c=[C], k=K, mu=MU, zeta=ZETA)
    assert shock.A > 0.05 and many.shock_spectrum(acceleration=0.2, duration=3.0).A[0] == shock.A


@pytest.mark.slow
def test_broken_power_behind_a_preload_has_scipys_motions():
    pieces = [(c + k * u ** sp.Rational(3, 2), None)]
    one = derive.mechanism("broken", pieces, {"c": ABOVE_0, "k": ABOVE_0})(c=C, k=K, mu=MU, zeta=ZETA)
    for Omega in (0.5, 0.8, 1.2):
        found = one.steady_state(Omega=Omega, F_0=0.15)
        other = again(found)
        assert other.A == pytest.approx(found.A, rel=1e-12)
        np.testing.assert_allclose(
            np.sort_complex(found.multipliers), np.sort_complex(other.multipliers), rtol=0, atol=1e-10
        )


@pytest.mark.slow
def test_detachment_behind_a_preload_is_the_first_pieces_peak(spring):
    force = c + k * u
    pieces = [(force, gap), (force + hard * (u - gap), None)]
    stop = derive.mechanism("sprung_stop", pieces, dict.fromkeys(("c", "k", "hard", "gap"), ABOVE_0))
    reach = 0.3
    found = stop(c=0.01, k=K, hard=3.0, gap=reach, mu=MU, zeta=ZETA).detachment().measure()
    window = (0.9 * found.Omega, 1.1 * found.Omega)
    assert spring.replace(c=0.01).exact_response(found.F_0, Omega=window).peak.A == pytest.approx(reach, rel=1e-6)
    assert abs(found.error) < 0.01
