"""What whole waves pass on: closed forms, exact motions, and how the second approximation's error falls."""

from __future__ import annotations

import math

import numpy as np
import pytest

from slowflow import Duffing, Isolator, example
from slowflow.second.wave import Waves
from slowflow_kernels import den_hartog

EXCITATIONS = ("force", "base", "unbalance")


def second(oscillator, Omega, F_0, of):
    """Of the state with the lowest amplitude."""
    return tuple(
        column[0] for column in oscillator.second_approximation.amplitudes(Omega=Omega, F_0=F_0).transmitted(of)
    )


def exact(oscillator, Omega, F_0, of):
    return oscillator.steady_state(Omega=Omega, F_0=F_0).transmitted(of)


@pytest.mark.parametrize("way", [second, exact])
@pytest.mark.parametrize("excitation", EXCITATIONS)
def test_a_linear_mount_passes_on_a_pure_wave(excitation, way):
    alpha, zeta, F_0, Omega = 0.8, 0.07, 0.3, 1.7
    osc = Duffing(alpha, 0.0, zeta=zeta, excitation=excitation)
    below = complex(alpha - Omega**2, 2 * zeta * Omega)
    force = F_0 if excitation == "force" else F_0 * Omega**2
    u = force / below
    expected = {
        "force": abs(complex(alpha, 2 * zeta * Omega) / below),
        "relative": abs(u) / F_0,
        "absolute": abs(u + F_0) / F_0,
    }
    if excitation == "force":
        del expected["absolute"]
        with pytest.raises(ValueError, match="the base stands still"):
            way(osc, Omega, F_0, "absolute")
    for of, ratio in expected.items():
        assert way(osc, Omega, F_0, of) == pytest.approx((ratio, ratio, ratio / math.sqrt(2)), rel=1e-12), of
    with pytest.raises(ValueError, match="of = 'forces' is not allowed"):
        way(osc, Omega, F_0, "forces")


@pytest.mark.parametrize("Omega", [0.6, 0.9, 1.5, 4.0])
def test_with_friction_alone_the_wave_is_den_hartogs(Omega):
    """His motion over half a cycle, whose spring and friction are passed on: u - mu while the mass moves down."""
    mu, F_0 = 0.02, 0.2
    A = float(den_hartog.amplitude(Omega, F_0, mu))
    nodes, weights = np.polynomial.legendre.leggauss(60)
    tau = (nodes + 1) * math.pi / Omega / 2
    passed = den_hartog.motion(tau, Omega, A, mu) - mu
    first = 2 * abs(np.sum(weights / 2 * passed * np.exp(-1j * Omega * tau))) / F_0
    rms = math.sqrt(float(weights / 2 @ passed**2)) / F_0
    # it falls all the way: the largest is at its end, where the mass has come from above to -A
    found = second(Duffing(1.0, 0.0, mu, 0.0), Omega, F_0, "force")
    assert found == pytest.approx((first, (A + mu) / F_0, rms), rel=1e-12)
    u = den_hartog.motion(tau, Omega, A, mu)
    rms_of_u = math.sqrt(float(weights / 2 @ u**2)) / F_0
    assert second(Duffing(1.0, 0.0, mu, 0.0), Omega, F_0, "relative")[1:] == pytest.approx(
        (A / F_0, rms_of_u), rel=1e-12
    )


@pytest.mark.parametrize("of", ["force", "relative"])
def test_the_error_of_the_wave_falls_by_orders(of):
    """Of the nonlinearity, without friction: averaging's first harmonic misses what the harmonics add, as beta."""
    last = None
    for beta in (0.2, 0.1, 0.05):
        osc = Duffing(1.0, beta, 0.0, 0.02)
        averaged = osc.amplitudes(Omega=1.3, F_0=0.3)
        true = osc.steady_state(Omega=1.3, F_0=0.3, A=averaged.A[0]).transmitted(of)
        pure = averaged.transmissibility if of == "force" else averaged.relative
        of_first = abs(pure[0] / true.peak - 1)
        assert of_first > 0.003 * beta
        errors = np.abs(np.array(second(osc, 1.3, 0.3, of)) / np.array(true) - 1)
        assert (errors < 0.03 * beta * of_first).all()
        assert last is None or (errors < last / 4).all()
        last = errors


@pytest.mark.parametrize("excitation", EXCITATIONS)
def test_wave_with_springs_and_friction_is_near_exact_ones(excitation):
    """Friction's jump is a fifth of the largest value: of the first harmonic alone a tenth and more is missing."""
    iso = Isolator(**example.TABLE_1, force="untruncated", excitation=excitation)
    for Omega in (1.2, 1.6, 3.0):
        for of in ("force", "relative", "absolute")[: 2 if excitation == "force" else 3]:
            found, true = np.array(second(iso, Omega, 0.05, of)), np.array(exact(iso, Omega, 0.05, of))
            assert np.abs(found / true - 1).max() < 2e-4, (Omega, of)
        pure = float(iso.amplitudes(Omega=Omega, F_0=0.05).transmissibility[0])
        passed = exact(iso, Omega, 0.05, "force")
        assert abs(pure / passed.peak - 1) > 0.05


def test_curve_and_batch_transmit_what_their_states_do():
    delta_h, F_0 = np.array([0.08, 0.1, -1.0]), 0.04
    design = {"lam": 3.0, "r": 2.0, "mu": 0.012, "zeta": 0.02, "excitation": "base"}
    many = Isolator.many(**design, delta_h=delta_h).second_approximation
    states = many.amplitudes(Omega=0.9, F_0=F_0)
    curves = many.frequency_response(F_0, samples=60, Omega=(0.7, 1.1))
    for of in ("force", "relative", "absolute"):
        of_states, of_curves = states.transmitted(of), curves.transmitted(of)
        for k in range(2):
            one = Isolator(**design, delta_h=delta_h[k]).second_approximation
            curve = one.frequency_response(F_0, samples=60, Omega=(0.7, 1.1))
            passed = curve.transmitted(of)
            here = one.amplitudes(Omega=0.9, F_0=F_0)
            for name in passed._fields:
                assert np.array_equal(getattr(of_curves, name)[k, : len(curve)], getattr(passed, name)), name
                assert np.array_equal(getattr(of_states, name)[k, : len(here)], getattr(here.transmitted(of), name))
            assert np.isnan(of_curves.peak[k, len(curve) :]).all()
            assert np.array_equal(passed.dB.rms, 20 * np.log10(passed.rms))
            # a point of the curve is a state at its frequency
            point = len(curve) // 3
            there = one.amplitudes(Omega=curve.Omega[point], F_0=F_0)
            nearest = np.abs(there.A - curve.A[point]).argmin()
            assert there.transmitted(of).peak[nearest] == pytest.approx(passed.peak[point], rel=1e-9)
        assert np.isnan(of_states.rms[2]).all() and np.isnan(of_curves.rms[2]).all()
    with pytest.raises(ValueError, match="of = 'all' is not allowed"):
        curves.transmitted("all")


def test_far_out_friction_alone_is_passed_on_as_a_square_wave():
    """Whose largest value and root mean square are mu, and whose first harmonic the floor 4 mu/pi."""
    iso, F_0 = Isolator(**example.TABLE_1), 0.04
    for way, Omega in ((second, 3e4), (exact, 300.0)):
        first, peak, rms = way(iso, Omega, F_0, "force")
        assert first == pytest.approx(iso.transmissibility_floor(F_0), rel=2e-3)
        assert (peak, rms) == pytest.approx((iso.mu / F_0, iso.mu / F_0), rel=2e-3)


def test_a_preload_jumps_where_the_mass_passes_its_place():
    """Far out what a preload and friction leave are square waves a quarter of a turn apart."""
    import sympy as sp

    from slowflow import derive

    u, stiff, preload = sp.symbols("u stiff preload")
    preloaded = derive.mechanism(
        "preloaded_here", [(stiff * u + preload, None)], {"stiff": {"above": 0}, "preload": {"above": 0}}
    )
    one = preloaded(stiff=1.0, preload=0.02, mu=0.01, zeta=0.02)
    first, peak, rms = second(one, 3e3, 0.2, "force")
    assert first == pytest.approx(one.transmissibility_floor(0.2), rel=1e-2)
    assert (peak, rms) == pytest.approx((0.03 / 0.2, math.hypot(0.02, 0.01) / 0.2), rel=5e-3)


@pytest.mark.slow
@pytest.mark.parametrize("laws", [{}, {"eta": 0.02}, {"c_2": 0.1}, {"load": 0.02}])
@pytest.mark.parametrize("excitation", EXCITATIONS)
def test_curves_of_many_designs_have_what_single_ones_pass_on(excitation, laws):
    arguments = {"mu": 0.01, "zeta": 0.03, "excitation": excitation, **laws}
    curves = Duffing.many(1.0, [0.3, 0.5], **arguments).frequency_response(0.05, samples=30)
    for k, beta in enumerate((0.3, 0.5)):
        single = Duffing(1.0, beta, **arguments).frequency_response(0.05, samples=30)
        n = len(single)
        for name in ("phi", "transmissibility", "transmissibility_dB", *(["relative"] if "load" not in laws else [])):
            column = getattr(curves, name)[k]
            np.testing.assert_allclose(column[:n], getattr(single, name), rtol=1e-13)
            assert np.isnan(column[n:]).all()


def test_all_of_next_to_no_force_is_passed_on_without_a_warning():
    """4 mu/(pi F_0) is beyond the range of doubles."""
    assert Duffing(1.0, 0.1, mu=0.1).transmissibility_floor(1e-310) == 1.0


@pytest.mark.parametrize(("of", "size"), [("relative", 0.0), ("absolute", 1.0), ("force", 1.0)])
def test_a_mass_that_friction_holds_goes_with_its_base(of, size):
    """It does not move against it, and passes the whole wave on."""
    iso = Isolator(lam=3, r=0.8, delta_h=0.1, mu=0.02, zeta=0.1, excitation="base")
    waves = Waves(iso.model, np.array([0.05]), np.zeros(1), np.zeros(1), np.array([0.02]))
    assert np.ravel(waves.transmitted(of)) == pytest.approx([size, size, size * math.sqrt(0.5)])
