"""Forces off the centre that are no polynomials: against integrals, polynomials, and exact motions."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
import sympy as sp

from slowflow import Isolator, derive
from slowflow.answers.results import Remark
from slowflow.example import TABLE_1
from slowflow.off_centre.means import Steps
from slowflow.off_centre.turning_points import Charts
from tests.off_centre.test_off_centre import assert_boxes_hold

u, k, g, q, d, p, z = sp.symbols("u k g q d p z")
ABOVE = {"above": 0}
DAMPED = {"mu": 0.005, "zeta": 0.03}


@pytest.fixture(scope="module")
def magnet():
    """A magnet that repels at u = d, which no motion comes to."""
    pieces = [(u + q / (d - u) ** 2 - q / d**2, None)]
    return derive.mechanism("magnet", pieces, {"q": ABOVE, "d": ABOVE}, odd=False, compile=True)


@pytest.fixture(scope="module")
def cushion():
    """Free on the left and up to a gap, then ever stiffer."""
    pieces = [(u, g), (u + q * (sp.exp((u - g) / d) - 1), None)]
    return derive.mechanism("cushion_curves", pieces, {"q": ABOVE, "d": ABOVE, "g": {}}, odd=False, compile=True)


#: four pieces that differ in all: roots, a jump, bends, a saturating spring; powers of any parity, two jumps, a bend
PATCHED = {
    "curves": [
        (2 * u + p, -0.4),
        (sp.sqrt(1 + u * q) - 1, -0.1),
        (sp.sinh(u / q) * q / 2, 0.25),
        (u + p * sp.tanh((u - 0.25) / q), None),
    ],
    "powers": [
        (2 * u + p, -0.4),
        (u + u**3 / 2, -0.1),
        (u - q * u**2 + u**3, 0.25),
        (sp.Rational(3, 2) * (u - 0.25) + 0.25 - q * 0.25**2 + 0.25**3, None),
    ],
}


def patches(name):
    return derive.mechanism(f"patched_{name}", PATCHED[name], {"p": {}, "q": ABOVE}, odd=False)


@pytest.fixture(scope="module")
def patched():
    return patches("curves")


@pytest.mark.slow
@pytest.mark.parametrize("name", PATCHED)
@pytest.mark.parametrize(
    ("A", "B"), [(0.05, 0.1), (0.3, 0.0), (0.6, 0.1), (0.2, -0.5), (0.1, 0.6), (0.3, -0.25), (4.0, 0.3)]
)
@pytest.mark.part(3)
def test_means_are_those_of_exact_integrals(name, A, B):
    """The mean, the first harmonic, and their slopes as differences of these integrals at 30 digits."""
    oscillator = patches(name)(p=0.1, q=0.7, **DAMPED)
    steps = Steps(oscillator.model.mechanism, oscillator.model.parameters, 0.0)
    at = steps.at(np.array([A]), np.array([B]), 3)
    exact = {p: sp.Rational(0.1), q: sp.Rational(0.7)}
    pieces = [sp.lambdify(u, sp.nsimplify(force.subs(exact), rational=True), "mpmath") for force, _ in PATCHED[name]]
    ends = [mpmath.mpf(-2) / 5, mpmath.mpf(-1) / 10, mpmath.mpf(1) / 4]
    with mpmath.workdps(30):

        def whole(b, w):
            cuts = sorted(mpmath.acos((end - b) / A) for end in (*ends, mpmath.mpf(0)) if abs(end - b) < A)
            edges = [mpmath.mpf(0), *cuts, mpmath.pi]

            def law(y):
                x = b + A * mpmath.cos(y)
                return pieces[sum(x > end for end in ends)](x) * mpmath.cos(y) ** w

            return mpmath.quad(law, edges) / mpmath.pi

        for family, weight in ((at.c, 0), (at.s, 1)):
            for n in range(3):
                slope = mpmath.diff(lambda b, w=weight: whole(b, w), mpmath.mpf(B), n, h=1e-8)
                assert family[n][0] == pytest.approx(float(slope), rel=1e-11, abs=1e-13 * 20**n)


@pytest.mark.slow
def test_third_derivatives_are_slopes_of_second_ones(patched):
    """Also of motions that pass a bend, where f'' jumps."""
    model = patched(p=0.1, q=0.7, **DAMPED).model
    steps, step = Steps(model.mechanism, model.parameters, 0.0), 1e-5
    A, B = np.array([(0.3, 0.0), (0.6, 0.1), (0.2, -0.5), (0.1, 0.6), (0.3, -0.25), (4.0, 0.3)]).T
    at, above, below = steps.at(A, B, 3), steps.at(A, B + step, 2), steps.at(A, B - step, 2)
    np.testing.assert_allclose(at.c[3], (above.c[2] - below.c[2]) / (2 * step), rtol=1e-5, atol=1e-6)
    np.testing.assert_allclose(at.s[3], (above.s[2] - below.s[2]) / (2 * step), rtol=1e-5, atol=1e-6)


@pytest.mark.slow
def test_boxes_hold_all_that_motions_within_them_have(patched):
    """Also of an odd force, whose pieces on the left are those on the right turned."""
    forces = patched(p=0.1, q=0.7, **DAMPED), Isolator(**TABLE_1, force="untruncated", load=0.05)
    for model in (one.model for one in forces):
        assert_boxes_hold(Steps(model.mechanism, model.parameters, 0.0), np.random.default_rng(1), 200)


@pytest.mark.slow
def test_what_boxes_add_goes_with_the_square_of_their_size(patched):
    oscillator = patched(p=0.1, q=0.7, **DAMPED)
    charts = Charts(Steps(oscillator.model.mechanism, oscillator.model.parameters, 0.0))
    (chart,) = np.flatnonzero((charts.upper == 3) & (charts.lower == 0))

    def beyond(size: float) -> float:
        """Excess width of the mean's enclosure over its change across the box; its slopes by both ends are positive."""
        top, bottom = np.array([0.6, 0.6 + size]), np.array([-0.7, -0.7 + size])
        past = np.stack((top, -bottom[::-1])) + [[-1.0], [1.0]] * charts.place[:, [chart]]
        low, high = np.where(charts.rooted[:, [chart]], np.sqrt(past), past).T[..., np.newaxis]
        c_0 = charts.on(low, high, np.array([chart]))[0].c_0
        change = np.diff(charts.steps.at(0.5 * (top - bottom), 0.5 * (top + bottom), 0).c[0])
        return float((c_0.hi - c_0.lo - change)[0])

    assert 0 < beyond(1e-3) < 0.02 * beyond(1e-2) < 1e-5


@pytest.mark.slow
def test_its_derivation_is_told(cushion):
    """It asked for the degree of each piece, which only a polynomial has."""
    assert r"D_1\big|_{u = g} &= \frac{q}{d}" in cushion.document()


@pytest.mark.slow
def test_no_motion_passes_a_wall(magnet):
    oscillator = magnet(q=0.01, d=0.5, load=0.05, **DAMPED)
    model = oscillator.model.unloaded
    (above, below) = Steps(model.mechanism, model.parameters, 0.05).beyond
    assert above.wall == pytest.approx(0.5, rel=1e-9) and below.wall == np.inf
    found = oscillator.peak(0.05)
    assert found.A + found.B < 0.5 < found.u_max and (oscillator.rest().u < 0.5).all()


@pytest.mark.slow
def test_states_off_the_centre_say_where_those_about_it_are_cut():
    """A force that ends at |u| = 5, at which there is a state about the centre: beyond there may be others."""
    well = derive.mechanism("ended_well", [(-u / 2 + u**3 / (1 + u**2), None)], {}, reach=5.0, reach_reason="it ends")
    one = well(mu=0.01, zeta=0.0005)
    centred, every = (of.amplitudes(Omega=0.9, F_0=0.05) for of in (one, one.off_centre))
    assert "cut at A = 5, it ends" in centred.message
    assert Remark.CUT in every.remarks and every.message == "cut at A = 5, it ends"


def levelling_off(A, B):
    """<f> and h of f = u^3/(1 + u^2) = u - Re 1/(u + i) along B + A cos(psi), in closed form."""
    root = np.sqrt(B + 1j - A) * np.sqrt(B + 1j + A)
    return B - (1 / root).real, -A + 2 * ((1 - (B + 1j) / root) / A).real


def test_folds_of_a_force_that_levels_off_are_all_found():
    """By turning points of Omega along the balance at F_0; on large boxes its formula by itself says nothing."""
    one = derive.mechanism("levelling", [(q * u**3 / (1 + u**2), None)], {"q": ABOVE})(q=1, zeta=0.05, load=0.1)
    A, low, high = np.geomspace(1e-2, 1500.0, 20_000), np.full(20_000, -1600.0), np.full(20_000, 1600.0)
    for _ in range(50):
        B = (low + high) / 2
        low, high = (np.where((levelling_off(A, B)[0] < 0.1) == side, B, end) for side, end in ((1, low), (0, high)))
    p, level = -levelling_off(A, B)[1] / A, (0.4 / A) ** 2
    with np.errstate(invalid="ignore"):  # of other amplitudes there is no motion
        turn = np.sqrt(level - 4 * 0.05**2 * (p - 0.05**2))
        curves = [np.sqrt(p - 2 * 0.05**2 + sign * turn) for sign in (1, -1)]
    at = [curve[1:-1][np.abs(np.diff(np.sign(np.diff(curve)))) == 2] for curve in curves]
    found = one.saddle_nodes(F_0=0.4)
    assert len(found) == 2 and found.Omega == pytest.approx(np.sort(np.concatenate(at)), rel=1e-6)
    assert one.saddle_node_onset().F_SN < 0.4 < one.peak(0.4).A


def test_what_is_not_smooth_is_refused_with_where_it_is():
    """A pole and a root between the ends of a piece; a root that a piece begins with."""
    pole = derive.mechanism("pole", [(u + q / (d - u), 1), (u, None)], {"q": ABOVE, "d": ABOVE}, odd=False)
    with pytest.raises(ValueError, match=r"piece 1 of its force is not smooth at u = 0.5"):
        pole(q=0.1, d=0.5, **DAMPED)
    ended = derive.mechanism("ended", [(u - q * sp.sqrt(d - u), None)], {"q": ABOVE, "d": ABOVE}, odd=False)
    with pytest.raises(ValueError, match=r"piece 1 of its force is not smooth at u = 0.5"):
        ended(q=0.1, d=0.5, **DAMPED)
    with pytest.raises(ArithmeticError, match="singular at u = g"):
        derive.mechanism("hertz", [(u, g), (u + k * (u - g) ** sp.Rational(3, 2), None)], {"k": {}, "g": {}}, odd=False)
    with pytest.raises(ArithmeticError, match="whose average is not known"):
        derive.mechanism("gamma", [(sp.gamma(u), None)], {}, odd=False)


@pytest.mark.slow
@pytest.mark.parametrize("Omega", [1.15, 1.3])
def test_exact_motions_are_what_averaging_says_to_its_order(cushion, Omega):
    """Every stable state has a motion of the equation of motion next to it, with its mean."""
    oscillator = cushion(q=0.05, d=0.2, g=0.05, **DAMPED)
    states = oscillator.amplitudes(Omega=Omega, F_0=0.02)
    assert states.stable.any()
    for state in (one for one in states if one.stable):
        motion = oscillator.steady_state(Omega=Omega, F_0=0.02, A=state.A + abs(state.B))
        assert motion.A == pytest.approx(state.A + abs(state.B), rel=0.1)
        assert motion.stable


@pytest.mark.slow
def test_motions_against_a_magnet_are_those_of_its_average(magnet):
    oscillator = magnet(q=0.01, d=0.5, load=0.05, **DAMPED)
    (state,) = (one for one in oscillator.amplitudes(Omega=0.9, F_0=0.03) if one.stable)
    motion = oscillator.steady_state(Omega=0.9, F_0=0.03, A=state.A + abs(state.B))
    assert motion.A == pytest.approx(state.A + abs(state.B), rel=0.03)


@pytest.mark.slow
def test_a_closed_gap_is_refused_under_a_load():
    """Its stiffness counted twice, or nothing was found, without a word."""
    closing = derive.mechanism("closing", [(sp.sin(u), g), (3 * u + u**3, None)], {"g": {"least": 0}}, reach=2)
    with pytest.raises(ValueError, match="a force whose first piece ends at u = 0"):
        closing(g=0.0, mu=0.01, zeta=0.05, load=0.05)
    assert closing(g=0.1, mu=0.01, zeta=0.05, load=0.05).rest().stable.all()
