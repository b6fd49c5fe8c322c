"""From which frequency on less than a level is transmitted: closed forms, brute force, differences, an integrator."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from slowflow import Duffing, Isolator
from slowflow.app import scenes
from slowflow.averaged import isolating
from slowflow.support.errors import Refused
from slowflow_kernels.conventions import Status
from tests.files import MOUNT, scene
from tests.oracles import by_time
from tests.sampling import fewer

LEVELS = (0.0, -3.0, -20.0, -40.0)
EPS = np.finfo(float).eps


def linear(zeta: float, level_dB: float) -> float:
    """T^2 = (1 + 4 zeta^2 X)/((1 - X)^2 + 4 zeta^2 X) = kappa^2, a quadratic in X = Omega^2; its larger root."""
    kappa_2, damping = 10 ** (level_dB / 10), 4 * zeta**2
    half = 1 - 0.5 * damping + 0.5 * damping / kappa_2
    return math.sqrt(half + math.sqrt(half**2 - 1 + 1 / kappa_2))


@pytest.mark.parametrize("level_dB", LEVELS)
@pytest.mark.parametrize("zeta", [1e-4, 0.001, 0.05, 0.4, 1.5, 3.0])
@pytest.mark.parametrize("excitation", ["force", "base", "unbalance"])
@pytest.mark.part(3)
def test_isolation_of_a_linear_mount_is_the_closed_form(excitation, zeta, level_dB):
    """Of any damping from sqrt(2) times its natural frequency on, where the level is 0 dB; singly and in a batch."""
    omega_n = math.sqrt(2.0)
    expected = omega_n * linear(zeta / omega_n, level_dB)
    found = Duffing(2.0, 0.0, zeta=zeta, excitation=excitation).isolation(0.3, level_dB)
    many = Duffing.many(alpha=2.0, beta=0.0, zeta=[zeta], excitation=excitation).isolation(0.3, level_dB=level_dB)
    # an amplitude next to that of the base has the frequency in its last digits
    near = 64 * EPS * (1 if excitation == "force" else 10 ** (-level_dB / 10))
    assert found.Omega == pytest.approx(expected, rel=near)
    assert many.Omega[0] == pytest.approx(expected, rel=near)
    assert found.level_dB == level_dB and not found.at_fold


def test_a_crossing_far_below_the_peak_is_found_in_batches():
    """At -140 dB A is 1e-11 of that of the peak, below all amplitudes at which a batch looks: it is asked singly."""
    many = Duffing.many(alpha=1.0, beta=0.0, zeta=[0.001]).isolation(0.3, level_dB=-140.0)
    assert many.Omega[0] == pytest.approx(linear(0.001, -140.0), rel=64 * EPS)


def test_zeros_of_many_functions_are_known_to_their_last_digits():
    rng = np.random.default_rng(2)
    a, b, zero = rng.uniform(1, 3, 200), rng.uniform(0, 3, 200), rng.uniform(-3, 3, 200)

    def f(x):
        return a * (x - zero) + b * (x**3 - zero**3) + np.abs(x - 0.3) - np.abs(zero - 0.3)

    low, high = rng.uniform(-2, 0, 200), rng.uniform(0, 2, 200)
    zero[0], zero[1] = low[0], high[1]
    found, inside = isolating.zeros(f, low, high), (low <= zero) & (zero <= high)
    assert 50 < inside.sum() < 150
    assert found[inside] == pytest.approx(zero[inside], rel=16 * EPS, abs=16 * EPS)
    assert (np.abs(f(found)) == np.minimum(np.abs(f(low)), np.abs(f(high))))[~inside].all()


def test_fold_below_the_frequency_hides_no_crossing():
    """An effect of the truncation: the branch continues from an unstable fold to a point that transmits less."""
    parameters = {"lam": 1, "r": 3.429915195234352, "delta_h": 0.007162401664523088}
    parameters |= {"mu": 0.001103126706865959, "zeta": 0.004221581988793708}
    F_0, level_dB = 0.16455221143994167, -3.0
    one = Isolator(**parameters)
    many = Isolator.many(**parameters).isolation(F_0, level_dB=level_dB)
    assert not many.at_fold and max(one.saddle_nodes(F_0).Omega) < many.Omega
    assert passed(one, float(many.Omega), F_0) == pytest.approx(level_dB, abs=1e-9)
    assert many.Omega == pytest.approx(one.isolation(F_0, level_dB).Omega, rel=1e-13)


def random_design(rng: np.random.Generator, excitation: str) -> tuple[Isolator | Duffing, float]:
    damping = {"mu": 10 ** rng.uniform(-5, -3), "zeta": 10 ** rng.uniform(-1.7, -0.7)}
    if rng.random() < 0.5:
        one = Duffing(rng.uniform(0.2, 2), rng.uniform(-0.1, 2), excitation=excitation, **damping)
    else:
        spring = {"lam": 3, "r": rng.uniform(0.5, 3), "delta_h": rng.uniform(0.02, 0.3)}
        one = Isolator(**spring, excitation=excitation, **damping)
    return one, 10 ** rng.uniform(-2, -1)


def passed(one, Omega: float, F_0: float) -> float:
    """The most that a stable motion transmits, in dB."""
    states = one.amplitudes(Omega=Omega, F_0=F_0)
    return float(states.transmissibility_dB[states.stable].max(initial=-math.inf))


@pytest.mark.parametrize("excitation", ["force", "base"])
@pytest.mark.parametrize("seed", range(fewer(12, 4)))
def test_isolation_frequency_is_the_last_that_transmits_more(seed, excitation):
    one, F_0 = random_design(np.random.default_rng(seed), excitation)
    for level_dB in (0.0, -3.0, -12.0, -25.0):
        found = one.isolation(F_0, level_dB)
        if found.Omega is None:
            assert "transmits more" in found.message or one.transmissibility_floor(F_0) >= 10 ** (level_dB / 20)
            continue
        beyond = found.Omega * np.geomspace(1 + 1e-6, 30, 120)
        assert max(passed(one, Omega, F_0) for Omega in beyond.tolist()) <= level_dB + 1e-9
        assert passed(one, found.Omega * (1 - 1e-6), F_0) >= level_dB
        if not found.at_fold:
            assert passed(one, found.Omega, F_0) == pytest.approx(level_dB, abs=1e-12)


@pytest.mark.slow
@given(seed=st.integers(0, 2**32), levels=st.lists(st.floats(-60, 0), min_size=2, max_size=4))
def test_a_lower_level_never_begins_earlier(seed, levels):
    one, F_0 = random_design(np.random.default_rng(seed), "force")
    begins = [one.isolation(F_0, level_dB).Omega for level_dB in sorted(levels, reverse=True)]
    numbers = [math.inf if Omega is None else Omega for Omega in begins]
    assert all(before <= after * (1 + 1e-12) for before, after in pairwise(numbers))


def test_what_friction_passes_on_at_any_frequency_is_told():
    parameters, F_0 = {"alpha": 1.0, "beta": 0.5, "mu": 0.01, "zeta": 0.05}, 0.1
    floor = 20 * math.log10(4 * 0.01 / (math.pi * F_0))
    found = Duffing(**parameters).isolation(F_0, floor - 0.01)
    assert found.Omega is None and f"friction transmits {floor:.4g} dB" in found.message
    assert Duffing(**parameters).isolation(F_0, floor + 0.01).Omega > 10
    many = Duffing.many(**parameters).isolation(F_0, level_dB=[floor - 0.01, floor + 0.01, math.nan, 1.0])
    assert many.status.tolist() == [Status.NONE, Status.OK, Status.INVALID, Status.INVALID]
    stuck = Duffing(**parameters).isolation(0.01, -20.0)
    assert stuck.Omega is None and "sticks" in stuck.message


def test_quadratic_damping_transmits_a_share_at_any_frequency():
    parameters = {"alpha": 1.0, "beta": 0.0, "zeta": 0.05, "c_2": 0.5, "excitation": "base"}
    shaken = Duffing(**parameters)
    floor = 20 * math.log10(shaken.transmissibility_floor(0.2))
    assert "quadratic damping transmits" in shaken.isolation(0.2, floor - 0.1).message
    assert shaken.isolation(0.2, floor + 1.0).Omega > shaken.isolation(0.2).Omega
    many = Duffing.many(**parameters).isolation(0.2, level_dB=[floor - 0.1, floor + 1.0])
    assert many.status.tolist() == [Status.NONE, Status.OK]


@pytest.mark.parametrize("level_dB", [1e-9, 3, math.nan, "-20"])
def test_a_level_above_0_dB_is_refused(level_dB):
    with pytest.raises(Refused, match="level_dB"):
        Duffing(1.0, 0.0, zeta=0.1).isolation(0.3, level_dB)


@pytest.mark.slow
def test_under_a_load_it_is_that_of_the_states_there():
    loaded = Duffing(1.0, 0.5, mu=1e-3, zeta=0.05, load=0.2)
    begins = [loaded.isolation(0.05, level_dB) for level_dB in (0.0, -10.0)]
    assert begins[0].Omega < begins[1].Omega
    states = loaded.amplitudes(Omega=begins[1].Omega, F_0=0.05)
    assert states.transmissibility_dB[states.stable].max() == pytest.approx(-10, abs=1e-6)
    # a linear spring does not know the load
    assert Duffing(1.0, 0.0, zeta=0.1, load=0.2).isolation(0.3, -20.0).Omega == pytest.approx(
        linear(0.1, -20), rel=1e-12
    )
    many = Duffing.many(alpha=1.0, beta=0.5, mu=1e-3, zeta=0.05, load=[0.2]).isolation(0.05, level_dB=-10.0)
    assert many.Omega[0] == begins[1].Omega and many.B[0] == begins[1].B
    assert many.gradient()["Omega", "zeta"][0] == begins[1].gradient()["Omega", "zeta"]


def test_a_mount_answers_in_hertz():
    mount = Isolator.physical(**MOUNT)
    found = mount.isolation(5.0, level_dB=-12.0)
    assert mount.amplitudes(f=found.f, F=5.0).transmissibility_dB == pytest.approx(-12.0, abs=1e-7)
    softer = Isolator.physical(**{**MOUNT, "k_h": 1700.0 * (1 + 1e-6)}).isolation(5.0, level_dB=-12.0)
    assert found.gradient()["f", "k_h"] == pytest.approx((softer.f - found.f) / 1.7e-3, rel=1e-4)
    assert found.measure(of="peak").f != found.measure().f


def test_a_scene_asks_at_several_levels(tmp_path):
    path = scene(tmp_path, mount=MOUNT, ask={"F": [3, 5], "level_dB": [0, -12], "questions": ["isolation"]})
    found = scenes.read(path)
    assert [str(one) for one in found.queries][1] == "isolation at F = 3 N, level_dB = -12"
    begins = [found.answer(one).f for one in found.queries]
    assert begins[0] < begins[1] and begins[2] < begins[3]
    assert found.explain(found.queries[1]) is not None
    path.write_text(path.read_text().replace("[0, -12]", "3"))
    with pytest.raises(ValueError, match=r"scene.toml:12: level_dB = 3 is not allowed"):
        scenes.read(path)


def transmitted(alpha: float, beta: float, zeta: float, F_0: float, Omega: float) -> tuple[float, float]:
    """Peak and fundamental harmonic of what spring and damper pass on, over F_0, by SciPy."""
    turns, push = math.ceil(30 / zeta * Omega / (2 * math.pi)), lambda tau: F_0 * math.cos(Omega * tau)
    settled = by_time.settled(lambda u: alpha * u + beta * u**3, push, zeta, Omega, (0.0, 0.0), turns)
    at, u, v = (column[:-1] for column in settled)
    force = alpha * u + beta * u**3 + 2 * zeta * v
    return float(np.abs(force).max() / F_0), float(2 * abs((force * np.exp(-1j * Omega * at)).mean()) / F_0)


@pytest.mark.slow
@pytest.mark.parametrize("level_dB", [-3.0, -20.0])
def test_measured_it_is_where_an_integrator_finds_that_level(level_dB):
    parameters, F_0 = {"alpha": 0.5, "beta": 0.5, "zeta": 0.15}, 0.2  # one motion at each frequency
    found = Duffing(**parameters).isolation(F_0, level_dB)
    peak, first = found.measure("peak"), found.measure("first")
    assert 20 * math.log10(transmitted(**parameters, F_0=F_0, Omega=peak.Omega)[0]) == pytest.approx(level_dB, abs=1e-4)
    assert 20 * math.log10(transmitted(**parameters, F_0=F_0, Omega=first.Omega)[1]) == pytest.approx(
        level_dB, abs=1e-4
    )
    assert first.error == pytest.approx(found.Omega / first.Omega - 1, rel=1e-12)
    with pytest.raises(Refused, match="of = 'rms'"):
        found.measure("rms")


@pytest.mark.slow
def test_grid_and_store_take_levels_along_their_own_axis(tmp_path):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("zarr")
    levels = xarray.DataArray([0.0, -10.0], dims="level")
    grid = Duffing.many(alpha=1.0, beta=0.5, mu=1e-3, zeta=xarray.DataArray([0.02, 0.2], dims="damping"))
    found = grid.isolation(0.05, level_dB=levels)
    many = Duffing.many(alpha=1.0, beta=0.5, mu=1e-3, zeta=[[0.02], [0.2]]).isolation(0.05, level_dB=[0.0, -10.0])
    np.testing.assert_array_equal(found["Omega"].transpose("damping", "level"), many.Omega)
    assert found["level_dB"].attrs["long_name"] and found["level_dB"].dims == ("level",)
    stored = grid.store(tmp_path / "store", "isolation", F_0=0.05, level_dB=levels)
    xarray.testing.assert_equal(stored["Omega"].compute(), found["Omega"].compute())
