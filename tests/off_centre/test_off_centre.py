"""Motions off the centre against closed forms, quadratures, the equation of motion, and the centred answers."""

from __future__ import annotations

import math
import pickle
import re
import time
from types import SimpleNamespace

import mpmath
import numpy as np
import pytest
import sympy
from scipy.optimize import brentq

from slowflow import Duffing, Isolator, Oscillator, derive
from slowflow.answers.results import Remark, SteadyStates
from slowflow.averaged.isolating import Level
from slowflow.core.backend import SOLVER
from slowflow.core.model import Model
from slowflow.example import TABLE_1, isolator
from slowflow.off_centre import answers, reach, solution_sheets
from slowflow.off_centre.complete import Complete
from slowflow.off_centre.means import ORDERS, Steps
from slowflow.off_centre.questions import OffCentre
from slowflow.off_centre.turning_points import Charts
from slowflow.oscillators.isolator import ROD_SPRING
from slowflow.support.errors import NotSettled
from slowflow_kernels.conventions import Status
from tests.files import MOUNT, ROOT, stored
from tests.sampling import part, slow

CERTIFIED = stored("off_centre")


@pytest.fixture(scope="module")
def loaded():
    return Isolator(**TABLE_1, load=0.03)


@pytest.mark.slow
def test_states_and_detachments_are_the_certified_ones():
    """24 cubic springs, 12 truncated isolators, to 40 digits."""
    assert len(CERTIFIED) == 36
    for case in CERTIFIED:
        if case["kind"] == "duffing":
            parameters = (case[name] for name in ("alpha", "beta", "mu", "zeta"))
            found = Duffing(*parameters, load=case["load"]).amplitudes(Omega=case["Omega"], F_0=case["F_0"])
            exact = [[float(state[name]) for state in case["states"]] for name in ("A", "B")]
            assert len(found) == len(case["states"]) and not found.message
            np.testing.assert_allclose([found.A, found.B], exact, rtol=4e-15, atol=0)
            assert found.stable.tolist() == [state["stable"] for state in case["states"]]
        else:
            model = Model(ROD_SPRING, tuple(case["parameters"]), case["mu"], case["zeta"])
            detached = OffCentre(model, case["load"]).detachment()
            for name, value in case["detachment"].items():
                assert getattr(detached, name) == pytest.approx(float(value), rel=4e-15)


def test_zero_load_leaves_the_centred_answers_to_the_digit():
    isolator = Isolator(**TABLE_1)
    states, off = (of.amplitudes(Omega=[0.7, 0.9, 1.1], F_0=0.04) for of in (isolator, isolator.off_centre))
    assert np.array_equal(states.A, off.A) and np.array_equal(states.stable, off.stable) and not off.B.any()
    folds, off = isolator.saddle_nodes(0.04), isolator.off_centre.saddle_nodes(0.04)
    assert np.array_equal(folds.A, off.A) and np.array_equal(folds.Omega, off.Omega) and not off.B.any()
    assert isolator.replace(load=0.1).replace(load=0.0) == isolator
    # of a spring that lets the mass leave the centre those at the centre are the same too
    well = Duffing(-0.5, 1.0, 0.0, 0.05)
    states, off = (of.amplitudes(Omega=1.2, F_0=0.05) for of in (well, well.off_centre))
    centred = off.B == 0
    assert np.array_equal(off.A[centred], states.A) and np.array_equal(off.stable[centred], states.stable)


def mean(force, ends, A, B, weight):
    """<f(B + A cos psi) cos^weight psi> of a polynomial between each two ends, by its exact Fourier series."""
    edges = sorted(mpmath.acos((end - B) / A) for end in ends if abs(end - B) < A)
    nodes = [mpmath.pi * (2 * j + 1) / 16 for j in range(8)]
    total = mpmath.mpf(0)
    for low, high in zip([mpmath.mpf(0), *edges], [*edges, mpmath.pi], strict=True):
        piece = force(B + A * mpmath.cos((low + high) / 2))
        values = [piece(B + A * mpmath.cos(node)) * mpmath.cos(node) ** weight for node in nodes]
        for k in range(8):
            term = mpmath.fsum(v * mpmath.cos(k * node) for v, node in zip(values, nodes, strict=True)) / 8
            total += term * (high - low) if k == 0 else 2 * term * (mpmath.sin(k * high) - mpmath.sin(k * low)) / k
    return total / mpmath.pi


@pytest.mark.parametrize(
    ("A", "B"),
    [
        (0.2, 0.05),
        (0.2, 0.7),
        (0.1, -0.45),
        *slow((0.5, 0.05), (0.2, 0.3), (0.9, -0.3)),
    ],
)
def test_means_in_every_regime_are_those_of_exact_integrals(loaded, A, B):
    """Derivatives, with the delta functions that jumps leave, as differences of the means of the force itself."""
    steps = Steps(loaded.model.mechanism, loaded.model.parameters, 0.0)
    found = steps.at(np.array([A]), np.array([B]), ORDERS)
    with mpmath.workdps(60):
        alpha, beta, gamma, u_cr = map(mpmath.mpf, loaded.model.parameters)

        def force(u):
            return (lambda u: alpha * u + beta * u**3 + gamma * u**5) if abs(u) <= u_cr else (lambda u: u)

        for family, weight in ((found.c, 0), (found.s, 1)):
            for n, value in enumerate(family):
                exact = mpmath.diff(
                    lambda b, w=weight: mean(force, (u_cr, -u_cr), mpmath.mpf(A), b, w), mpmath.mpf(B), n, h=1e-15
                )
                assert value[0] == pytest.approx(float(exact), rel=1e-12, abs=2e-15 * 100**n)


def test_a_preload_and_a_stop_are_steps_too():
    """A force that jumps at u = 0, of straight pieces, against sums over the cycle."""
    c, k_2, gap = 0.1, 3.0, 0.3
    rows = (c, 1.0, 0.0, k_2, c - k_2 * gap, 1.0 + k_2)
    record = SimpleNamespace(name="", odd=True, steps=lambda: rows, breakpoints=lambda: (gap,), jumps=lambda: (0.0,))
    steps = Steps(record, (), 0.0)
    psi = (np.arange(200_000) + 0.5) * np.pi / 200_000
    for A, B in ((0.2, 0.05), (0.5, -0.1), (0.2, 0.6)):
        u = B + A * np.cos(psi)
        force = np.sign(u) * (c + np.abs(u) + k_2 * np.maximum(np.abs(u) - gap, 0.0))
        at = steps.at(np.array([A]), np.array([B]), 2)
        assert at.c[0] == pytest.approx(force.mean(), abs=1e-6)
        assert at.s[0] == pytest.approx((force * np.cos(psi)).mean(), abs=1e-6)


def ended_forces():
    """The isolator, a spring without steps, a stop on one side, one on either side, a preload with a stop."""
    u, k, g = sympy.symbols("u k g")
    one_sided = derive.mechanism(
        "one_sided_stop", [(u, g), (u + k * (u - g), None)], {"k": {"above": 0}, "g": {}}, odd=False
    )(k=2.0, g=0.2, mu=0.005, zeta=0.03)
    others = Isolator(**TABLE_1, load=0.03), Duffing(1.0, 0.5, load=0.3, zeta=0.05), one_sided
    stop = derive.library("elastic_stop")(kappa=8, delta=0.2, mu=0.005, zeta=0.03, load=0.05)
    rows = (0.1, 1.0, 0.0, 3.0, 0.1 - 0.9, 4.0)
    record = SimpleNamespace(name="", odd=True, steps=lambda: rows, breakpoints=lambda: (0.3,), jumps=lambda: (0.0,))
    return [*(one.off_centre._steps for one in (*others, stop)), Steps(record, (), 0.0)]


def test_charts_that_cannot_be_read_hold_any_number():
    """They held NaN once, which has no zero: nothing was found, without a word."""
    edge = np.zeros(2)
    found = SOLVER.ends(np.zeros(7), edge, edge, 0, 0.0, np.empty(0))
    assert (found.reshape(-1, 2) == (-np.inf, np.inf)).all()


def test_cells_cut_in_blocks_are_those_cut_together(loaded, monkeypatch):
    """No more blocks are looked at than show that too many cells are left."""
    sheets = loaded.off_centre._complete.sheets
    cells = sheets.cells(1.0)
    together = sheets.cut(cells)
    monkeypatch.setattr(solution_sheets, "TOGETHER", 16)
    in_blocks, few = sheets.cut(cells), sheets.cut(cells, most=20)
    for name in ("low", "high", "chart"):
        np.testing.assert_array_equal(getattr(in_blocks, name), getattr(together, name))
    assert 20 < few.chart.size <= 20 + 16 < together.chart.size


def assert_boxes_hold(steps, rng, n=400):
    """In every chart, up to its edges, where c_1 has no bound: the slopes by x and y have."""
    charts = Charts(steps)
    for number in range(charts.passes.size):
        chart, rooted = np.full(n, number), charts.rooted[:, number]
        least, most = np.maximum(charts.low[:, number], -1.5), np.minimum(charts.high[:, number], 1.5)
        low = least[:, np.newaxis] + (most - least)[:, np.newaxis] * rng.uniform(0, 1, (2, n)) ** 2
        high = np.minimum(low + 10 ** rng.uniform(-8, -0.5, n), most[:, np.newaxis])
        boxes = charts.on(low, high, chart)[0]
        if charts.upper[number] - charts.lower[number] > 1:
            assert all(np.isfinite(getattr(boxes, name).ends).all() for name in ("c_0", "s_0", "c_x", "c_y"))
        for fraction in (0.25, 0.5, 0.8):
            x, y = low[0] + fraction * (high[0] - low[0]), low[1] + (1 - fraction) * (high[1] - low[1])
            A, B = charts.motion(x, y, chart)
            means = steps.at(A, B, 3)
            X, Y = np.where(rooted[0], x, 0.5), np.where(rooted[1], y, 0.5)
            P_1, Q_1, P_2, Q_2 = (means.c[k] + sign * means.s[k] for k in (1, 2) for sign in (1, -1))
            values = {
                "A": A,
                "B": B,
                "c_0": means.c[0],
                "s_0": means.s[0],
                "c_x": X * P_1,
                "c_y": -Y * Q_1,
                "c_xx": rooted[0] * P_1 + X * X * (2 * P_2 - means.s[1] / A),
                "c_yy": Y * Y * (2 * Q_2 - means.s[1] / A) - rooted[1] * Q_1,
                "c_3": means.c[3],
                "s_2": means.s[2],
            }
            # nearer to an edge A and B do not tell how far a step is passed
            inner = np.minimum(x - least[0], y - least[1]) > (1e-2 if charts.passes[number] else 1e-6)
            compared = (A > 1e-6) & inner & (np.minimum(most[0] - x, most[1] - y) > 1e-6)
            for name, value in values.items():
                ends = getattr(boxes, name).ends
                doubt = (1e-13 if name in ("A", "B", "c_0", "s_0") else 1e-7) * (1 + np.abs(value))
                assert ((ends[0] <= value + doubt) & (value - doubt <= ends[1]))[compared].all(), (number, name)


@pytest.mark.slow
def test_boxes_by_ends_enclose_means_and_slopes():
    rng = np.random.default_rng(5)
    for steps in ended_forces():
        assert_boxes_hold(steps, rng)


@pytest.mark.slow
def test_means_far_out_and_next_to_a_step_are_exact_integrals():
    """Where a motion hardly passes a step, or is hundreds of times as large as all, differences keep no digits."""
    one = Isolator(lam=3.0, r=2.0, delta_h=0.08, mu=0.01, zeta=0.05, load=0.05)
    steps = Steps(one.model.mechanism, one.model.parameters, 0.05)
    charts = Charts(steps)
    lines = [mpmath.mpf(float(line)) for line in np.unique(steps.sides[1:] * steps.positions[1:])]

    def slope(u, order):
        piece = steps.pieces[sum(line < u for line in lines)]
        powers = enumerate(piece[order:].tolist())
        return mpmath.fsum(mpmath.mpf(D) * u**k / mpmath.factorial(k) for k, D in powers)

    (chart,) = np.flatnonzero(charts.rooted.all(axis=0) & (charts.upper - charts.lower == 2))
    positions = [(x, y) for x in (1e-9, 0.4, 6.0, 20.4, 130.0) for y in (1e-9, 1e-3, 0.7, 90.0)]
    with mpmath.workdps(40):
        for x, y in positions:
            at = np.array([[x], [y]])
            found = charts.on(at, at, np.array([chart]))[0]
            top = mpmath.mpf(x) ** 2 + mpmath.mpf(float(charts.place[0, chart]))
            bottom = mpmath.mpf(float(charts.place[1, chart])) - mpmath.mpf(y) ** 2
            A, B = (top - bottom) / 2, (top + bottom) / 2
            cuts = [0, *(mpmath.acos((line - B) / A) for line in lines[::-1]), mpmath.pi]

            def mean(order, weight, A=A, B=B, cuts=cuts):
                return (
                    mpmath.quad(lambda t: slope(B + A * mpmath.cos(t), order) * weight(mpmath.cos(t)), cuts) / mpmath.pi
                )

            # of what f gains at each line the mean with 1 +- cos
            gains = [
                (steps.gains[1, 0] / (mpmath.pi * mpmath.sqrt(A**2 - (line - B) ** 2)), (line - B) / A)
                for line in lines
            ]
            P, Q = (
                mean(1, lambda c, s=s: 1 + s * c) + mpmath.fsum(gain * (1 + s * c) for gain, c in gains)
                for s in (1, -1)
            )
            exact = {"c_0": mean(0, lambda c: 1), "s_0": mean(0, lambda c: c), "c_x": x * P, "c_y": -y * Q}
            for name, value in exact.items():
                (low,), (high,) = getattr(found, name).ends
                assert low <= value <= high, (x, y, name)
                assert high - low <= 1e-12 * (1 + A**5) * (1 + abs(value)), (x, y, name)


def test_off_the_centre_validity_says_that_nothing_was_measured(loaded):
    none = loaded.replace(load=0.45).detachment()
    answers = (loaded.amplitudes(Omega=0.9, F_0=0.04), loaded.saddle_nodes(0.04), loaded.detachment(), none)
    for answer, states in zip((*answers, loaded.peak(0.04)), (3, 2, 1, 0, 1), strict=True):
        assert str(answer.validity).startswith("not measured") and np.isnan(answer.validity.error).all()
        assert answer.validity.rest.shape == answer.validity.error.shape == (states,)
    (rest,) = answers[2].validity.rest
    assert rest == pytest.approx(loaded.mu / (answers[2].A * answers[2].Omega_cr ** 2), rel=1e-15)


def test_next_to_the_centre_folds_take_few_boxes(monkeypatch):
    """Corners on both sides are 1e-9 apart: there were 282 000 boxes, and at other forcings too many."""
    boxes = []
    operands = Charts.operands
    monkeypatch.setattr(Charts, "operands", lambda *arguments: boxes.append(arguments[3].size) or operands(*arguments))
    exact, found = Isolator(**TABLE_1).saddle_nodes(0.04), Isolator(**TABLE_1, load=1e-7).saddle_nodes(0.04)
    assert found.A == pytest.approx(exact.A, rel=1e-9) and found.Omega == pytest.approx(exact.Omega, rel=1e-9)
    assert sum(boxes) < 10_000


def test_large_motions_are_enclosed_as_by_the_outer_spring(loaded):
    """Beyond u_cr the force is that of the vertical spring: <f> = B but for less than what it lacks within u_cr."""
    charts = Charts(Steps(loaded.model.mechanism, loaded.model.parameters, 0.0))
    (chart,) = np.flatnonzero(charts.upper - charts.lower == 2)
    ends = (np.array([1400.0 + B, 1400.0 - B]) - charts.place[0, chart] for B in (-2.0, 2.0))
    (x, y), (x_high, y_low) = (np.sqrt(end) for end in ends)
    low, high = np.array([[x], [y_low]]), np.array([[x_high], [y]])
    on = charts.on(low, high, np.array([chart]))[0]
    assert -2.5 < on.c_0.lo[0] and on.c_0.hi[0] < 2.5


@pytest.mark.parametrize(
    ("oscillator", "Omega", "F_0"),
    [
        (Isolator(**TABLE_1, load=0.03), 0.9, 0.04),
        (Duffing(-0.5, 1.0, 0.0, 0.05, load=0.02), 1.2, 0.05),
        (Duffing(1.0, 0.5, 0.01, 0.05, load=0.3), 1.3, 0.2),
    ],
)
def test_state_lies_beside_a_motion_with_its_stability(oscillator, Omega, F_0):
    states = oscillator.amplitudes(Omega=Omega, F_0=F_0)
    assert len(states) == 3
    for state in states:
        motion = oscillator.steady_state(Omega=Omega, F_0=F_0, A=state.A + abs(state.B))
        mean, first = motion.harmonics(1)[:2]
        assert abs(first) == pytest.approx(state.A, rel=0.02) and mean.real == pytest.approx(state.B, rel=0.09)
        assert motion.stable == state.stable and motion.residual < 1e-9


#: lam, r, delta_h, mu, zeta, F_0
ON_CORNERS = (
    "2 3.9669428015531714 0.39718172265868795 0.0006320874749241436 0.023793613430806052 0.007074669648016597",
    "3 2.7428380903138434 0.31063264564195053 0.0030809331863611723 0.010971020543397292 0.017678984263452133",
    "3 3.662330695509826 0.28108370146147277 0.0026839812135887714 0.0034936693892093883 0.005515532439549685",
)


@pytest.mark.parametrize("numbers", [ON_CORNERS[0], *slow(*ON_CORNERS[1:])])
def test_a_fold_on_a_corner_under_a_load_has_all_digits(numbers):
    """A and B, rounded, pass the jump by an ulp: h, and Omega with it, was off by 1e-8 to 1e-7."""
    lam, r, delta_h, mu, zeta, F_0 = map(float, numbers.split())
    one = Isolator(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta, load=0.02)
    steps, found = one.off_centre._steps, one.saddle_nodes(F_0)
    assert found.corner.any()
    with mpmath.workdps(40):
        rows = steps.pieces[1].tolist()
        inner = [mpmath.mpf(D) / mpmath.factorial(k) for k, D in enumerate(rows)][::-1]
        for fold in (one for one, corner in zip(found, found.corner, strict=True) if corner):
            side = 1 if fold.B + fold.A > -(fold.B - fold.A) else -1
            edge = side * mpmath.mpf(float(steps.inner[1]))

            def mean(A, order, side=side, edge=edge):
                def of(t):
                    return mpmath.polyval(inner, edge - side * A + A * mpmath.cos(t)) * mpmath.cos(t) ** order

                return mpmath.quad(of, [0, mpmath.pi]) / mpmath.pi

            A = mpmath.findroot(lambda A: mean(A, 0) - mpmath.mpf(0.02), fold.A)
            h, m = -2 * mean(A, 1), 4 * mpmath.mpf(mu) / mpmath.pi
            friction = 4 * mpmath.mpf(zeta) * A * m
            viscous = (2 * mpmath.mpf(zeta) * A) ** 2
            quartic = [A**2, 0, 2 * A * h + viscous, friction, h**2 + m**2 - mpmath.mpf(F_0) ** 2]
            roots = [root.real for root in mpmath.polyroots(quartic, maxsteps=500, extraprec=400) if root.imag == 0]
            assert min(abs(root - fold.Omega) for root in roots) < 1e-13 * fold.Omega
            assert abs(A - fold.A) < 1e-13 * fold.A


def test_folds_on_corners_near_the_centre_need_no_load():
    """All its lengths are below 0.1. Two states begin on a corner and end 1e-8 from it, in each well."""
    wells = Isolator(lam=3.0, r=400.0, delta_h=0.004, zeta=0.05).off_centre
    folds = wells.saddle_nodes(0.00824)
    on = folds.Omega[folds.corner]
    assert (
        on.size == 2 and on[0] == on[1] and folds.B[folds.corner].sum() == 0 < np.abs(folds.B[folds.corner]).max() < 0.1
    )
    later = folds.Omega[folds.Omega > on[0]]
    counts = [
        len(wells.amplitudes(Omega=Omega, F_0=0.00824))
        for Omega in (on[0] - 1e-4, (on[0] + later[0]) / 2, on[0] + 1e-4)
    ]
    assert counts == [3, 7, 3]


@pytest.mark.parametrize("F_0", [0.1, 0.15, 0.2, 0.5])
def test_folds_in_two_wells_are_all_of_those_by_hand(F_0):
    """Off the centre B^2 = (1 - 3 A^2)/2 and F = 0 is quadratic in Omega^2: folds are where its roots turn."""
    zeta, A = 0.05, np.linspace(1e-4, np.sqrt(1 / 3), 200_001)
    stiffness = -0.5 + 0.75 * A**2 + 1.5 * (1 - 3 * A**2)
    half = stiffness - 2 * zeta**2
    with np.errstate(invalid="ignore"):
        spread = np.sqrt(half**2 - stiffness**2 + (F_0 / A) ** 2)
    turns = []
    for sign in (-1, 1):
        root = half + sign * spread
        rises = np.diff(root)
        at = 1 + np.flatnonzero((rises[1:] * rises[:-1] < 0) & (root[1:-1] > 0))
        turns += A[at].tolist()
    off = Duffing(-0.5, 1.0, zeta=zeta).off_centre.saddle_nodes(F_0)
    wells = off.B != 0
    assert not off.message and sorted(off.A[wells & (off.B > 0)]) == pytest.approx(sorted(turns), abs=1e-5)
    assert sorted(off.A[wells & (off.B < 0)]) == pytest.approx(sorted(turns), abs=1e-5)


def test_two_wells_have_responses_beside_the_centred_one():
    well = Duffing(-0.5, 1.0, 0.0, 0.05)
    found, centred = (of.frequency_response(0.05, Omega=(0.1, 1.8)) for of in (well.off_centre, well))
    assert np.array_equal(found.A[found.B == 0], centred.A)
    up, down = (np.sort(found.A[sign * found.B > 0]) for sign in (1, -1))
    assert up.size > 100 and up == pytest.approx(down, rel=1e-12)
    assert well.off_centre.frequency_response(1e-3).Omega.max() == 2.0
    stuck = well.replace(mu=0.1).off_centre.frequency_response(0.05)
    assert len(stuck) == 0 and "sticks" in stuck.message
    hardening = Duffing(1.0, 0.5, 0.0, 0.05)
    assert np.array_equal(hardening.off_centre.frequency_response(0.2).A, hardening.frequency_response(0.2).A)


def test_detachment_under_a_load_comes_sooner_and_at_the_edge(loaded):
    """At |B| + A = u_cr; A, B and the forcing have certified digits above."""
    found, centred = loaded.detachment(), loaded.replace(load=0.0).detachment()
    u_cr = loaded.breakpoints[0]
    assert found.B + found.A == pytest.approx(u_cr, rel=1e-15) and found.F_cr < centred.F_cr
    assert loaded.replace(load=-0.03).detachment().B == pytest.approx(-found.B, rel=1e-13)
    assert loaded.replace(load=0.45).detachment().F_cr is None
    assert loaded.replace(load=1e-12).detachment().F_cr == pytest.approx(centred.F_cr, rel=1e-10)


@pytest.mark.slow
@pytest.mark.parametrize("centred", [Isolator(**TABLE_1), Duffing(1.0, 0.5, 0.01, 0.05)])
def test_onset_tends_to_the_centred_one_as_the_load_squared(centred):
    at_centre = centred.saddle_node_onset()
    shifts = [centred.replace(load=load).saddle_node_onset().F_SN / at_centre.F_SN - 1 for load in (1e-3, 1e-4)]
    assert shifts[0] == pytest.approx(100 * shifts[1], rel=1e-3) and 0 < shifts[0] < 1e-3
    again = centred.off_centre.saddle_node_onset()
    assert (again.F_SN, again.A, again.B) == (at_centre.F_SN, at_centre.A, 0.0)
    loaded, mirrored = (centred.replace(load=load).saddle_node_onset() for load in (0.03, -0.03))
    assert mirrored.F_SN == pytest.approx(loaded.F_SN, rel=1e-13) and mirrored.B == pytest.approx(-loaded.B, rel=1e-9)


@pytest.mark.slow
def test_an_onset_on_a_corner_is_where_states_begin_to_be_three(loaded):
    heavy = loaded.replace(load=0.1)
    onset = heavy.saddle_node_onset()
    assert onset.kind == "corner" and "jump of the force" in onset.message
    assert onset.A + onset.B == pytest.approx(heavy.breakpoints[0], rel=1e-15)
    grid = onset.Omega * np.linspace(0.99, 1.03, 41)
    for ratio, most in ((0.97, 1), (1.03, 3)):
        states = heavy.amplitudes(Omega=grid, F_0=ratio * onset.F_SN)
        assert max((states.Omega == Omega).sum() for Omega in grid) == most and not states.message


@pytest.mark.slow
def test_boxes_that_get_no_narrower_are_undecided_at_once():
    """A box of a double's width came back 100,000 times, for eight minutes."""
    numbers = {"r": 1.685721009768477e-06, "delta_h": 0.011399253844244459, "load": 0.7978934549290119}
    began = time.process_time()
    onset = Isolator(lam=1.0, mu=0.8683033939728904, zeta=1.916589441808733, **numbers).saddle_node_onset()
    assert onset.F_SN is None and "undecided: too many boxes" in onset.message
    assert time.process_time() - began < 20


def test_at_four_mu_over_pi_itself_the_averaged_mass_sticks():
    """R^2 + I^2 = F_0^2 with I = m + 2 zeta A Omega: at F_0 = m = 4 mu/pi only A = 0 is left, a static state."""
    loaded = Duffing(1.0, 0.5, 0.01, 0.02, load=0.3)
    state = loaded.amplitudes(Omega=0.9, F_0=loaded.model.m)
    (place,) = loaded.rest().u
    assert state.A.tolist() == [0.0] and state.B == pytest.approx([place], rel=1e-15) and "sticks" in state.message


def test_where_no_onset_is_told_the_reason_is():
    assert "no saddle node" in Duffing(1.0, 0.0, 0.01, 0.05, load=0.3).saddle_node_onset().message
    well = Duffing(-0.5, 1.0, 0.005, 0.05, load=0.02).saddle_node_onset()
    assert well.F_SN is None and "undecided" in well.message
    with pytest.raises(ValueError, match="needs zeta > 0"):
        Isolator(**{**TABLE_1, "zeta": 0.0}, load=0.03).saddle_node_onset()


def test_every_place_of_rest_is_found():
    wells = Duffing(-0.5, 1.0, load=0.02).rest()
    terms = np.array([wells.u**3, -0.5 * wells.u, np.full(3, -0.02)])
    assert (np.abs(terms.sum(axis=0)) <= 2.0**-51 * np.abs(terms).sum(axis=0)).all()
    assert wells.stable.tolist() == [True, False, True]
    assert Isolator(**TABLE_1, load=0.45).rest().u == pytest.approx([0.45], rel=1e-15)
    assert len(Duffing(1.0, 0.5, load=-0.3).rest()) == 1
    unloaded = Isolator(lam=0.87, r=0.4, delta_h=0.0757, mu=0.03, zeta=0.05, force="untruncated")
    assert unloaded.rest().u.tolist() == [0.0]  # was -1.5e-185


def test_what_has_no_answer_off_the_centre_is_refused_in_words(loaded):
    questions = {
        "fold_locus": (), "cusps": (), "isola_points": (), "certify": (0.04,), "backbone": ([0.1],),
    }  # fmt: skip
    for name, arguments in questions.items():
        with pytest.raises(ValueError, match=r"load = 0\.03"):
            getattr(loaded, name)(*arguments)
    pairs = {"limit_envelope": "F_0", "stability": "A", "equivalent_damping": "A"}
    for name, other in pairs.items():
        with pytest.raises(ValueError, match=r"load = 0\.03"):
            getattr(loaded, name)(Omega=[0.9], **{other: [0.04] if other == "A" else 0.04})
    with pytest.raises(ValueError, match=r"load = 0\.03"):
        _ = loaded.second_approximation
    # and the page that tells of it has just these
    page = (ROOT / "docs" / "limits.md").read_text(encoding="utf-8")
    (row,) = [line for line in page.splitlines() if line.startswith("| a static load")]
    refused = {*questions, *pairs, "second_approximation", "fit"}
    assert set(re.findall(r"`(\w+)`", row)) == refused
    with pytest.raises(ValueError, match="it combines others"):
        loaded.margins(0.04).gradient()
    with pytest.raises(ValueError, match="load = nan"):
        Duffing(1.0, 0.5, load=float("nan"))
    with pytest.raises(ValueError, match="needs zeta > 0"):
        loaded.replace(zeta=0.0).amplitudes(Omega=0.9, F_0=0.04)
    sticks = loaded.amplitudes(Omega=0.9, F_0=0.01)
    assert sticks.A.tolist() == [0.0] and "sticks" in sticks.message


def test_what_lies_beyond_the_reach_is_said_off_the_centre_too(loaded):
    heavy = loaded.replace(load=0.9)
    for found in (heavy.amplitudes(Omega=1.0, F_0=0.05), loaded.replace(load=1.2).rest()):
        assert "above 1 are not reached: the push-rod stands vertical" in found.message
    assert loaded.rest().message == heavy.rest().message == loaded.amplitudes(Omega=1.0, F_0=0.05).message == ""


def test_a_load_is_part_of_what_an_oscillator_is(loaded):
    assert pickle.loads(pickle.dumps(loaded)) == loaded != loaded.replace(load=0.02)
    assert repr(loaded).endswith("load=0.03)") and "load" not in repr(loaded.replace(load=0.0))
    general = Oscillator(loaded.model.mechanism, **TABLE_1, load=0.03)
    assert np.array_equal(general.amplitudes(Omega=0.9, F_0=0.04).A, loaded.amplitudes(Omega=0.9, F_0=0.04).A)


@pytest.mark.slow
def test_a_force_that_only_bends_has_no_fold_where_it_does():
    """A stop in contact from delta on: its force is continuous, and one state lies on either side of A + B = delta."""
    stop = derive.library("elastic_stop")(kappa=8, delta=0.2, mu=0.005, zeta=0.03, load=0.05)
    assert not stop.off_centre._steps.gains[:, 0].any()
    assert len(stop.saddle_nodes(F_0=0.0155)) == 0


def test_mount_under_a_load_says_which_amplitude_it_means():
    """The first harmonic about the mean, by averaging; the largest |x|, of the equation of motion."""
    mount = Isolator.physical(**MOUNT, load=12.36)
    (state,) = mount.amplitudes(f=2.1, F=2)
    assert state.x_max == pytest.approx(abs(state.B) + state.A, rel=1e-15)
    exact = mount.steady_state(f=2.1, F=2)
    assert exact.A == pytest.approx(np.abs(exact.x).max(), rel=1e-4) and exact.A == pytest.approx(state.x_max, rel=5e-3)
    mean, first = exact.answer.harmonics(1)
    assert state.A == pytest.approx(0.08 * abs(first), rel=5e-3) and state.B == pytest.approx(
        0.08 * mean.real, rel=5e-3
    )
    assert "the mean displacement included" in str(exact) and "x_max/mm" in str(mount.amplitudes(f=2.1, F=2))
    assert "included" not in str(Isolator.physical(**MOUNT).steady_state(f=2.1, F=2))


def balance_of_a_cubic(alpha, beta, zeta, load, F_0, Omega, A, B):
    """f_0, F, R and I by hand, without friction."""
    R = A * (Omega**2 - alpha - 0.75 * beta * A**2 - 3 * beta * B**2)
    I = 2 * zeta * A * Omega
    return alpha * B + beta * (B**3 + 1.5 * A**2 * B) - load, R**2 + I**2 - F_0**2, R, I


def peak_by_hand(Omega, A, B, *numbers):
    f_0, F, R, I = balance_of_a_cubic(*numbers[:5], Omega, A, B)
    return f_0, F, Omega * R + numbers[2] * I


@pytest.mark.parametrize(("alpha", "beta", "load", "F_0"), [(1.0, 0.5, 0.3, 0.2), (-0.5, 1.0, 0.02, 0.2)])
def test_the_peak_is_where_the_response_by_hand_is_level(alpha, beta, load, F_0):
    """f_0 = F = dF/dOmega = 0 to 30 digits."""
    zeta = 0.05
    found = Duffing(alpha, beta, 0.0, zeta, load=load).peak(F_0)
    with mpmath.workdps(30):
        numbers = (alpha, beta, zeta, load, F_0)
        exact = mpmath.findroot(lambda *at: peak_by_hand(*at, *numbers), (found.Omega, found.A, found.B))
    assert [found.Omega, found.A, found.B] == pytest.approx([float(value) for value in exact], rel=1e-13)
    assert found.u_max == pytest.approx(found.A + abs(found.B), rel=1e-15)  # one motion has both here


def test_peak_without_a_load_is_the_centred_one():
    well = Duffing(-0.5, 1.0, 0.0, 0.05)
    off, centred = well.off_centre.peak(0.2), well.peak(0.2)
    assert (off.A, off.B, off.Omega, off.u_max) == (centred.A, 0.0, centred.Omega, centred.A)
    stuck = well.replace(mu=0.1, load=0.1).peak(0.05)
    assert stuck.A is None and "sticks" in stuck.message


@pytest.mark.slow
def test_springs_detach_from_the_detaching_force_on(loaded):
    F_cr = loaded.detachment().F_cr
    below, above = (loaded.margins(ratio * F_cr) for ratio in (0.97, 1.03))
    assert (below.detaches, above.detaches) == (False, True) and below.of_cr == pytest.approx(1 / 0.97, rel=1e-15)
    assert loaded.peak(0.97 * F_cr).u_max < loaded.breakpoints[0] < loaded.peak(1.03 * F_cr).u_max
    assert loaded.margins(0.015).sticks and not loaded.margins(0.015).detaches
    # one that rests beyond the first breakpoint has its springs off
    assert loaded.replace(load=0.45).margins(0.02).detaches


def test_folds_and_curves_under_a_load_are_drawn(loaded):
    folds, ax = loaded.saddle_nodes(0.04), loaded.saddle_nodes(0.04).plot()
    drawn = np.array([point for line in ax.lines for point in line.get_xydata() if np.isfinite(point).all()])
    assert {tuple(point) for point in drawn} == set(zip(folds.Omega, folds.A, strict=True)) and len(folds) == 2
    curve = loaded.frequency_response(0.04, samples=20)
    assert curve.plot(of="B").get_ylabel() == "mean displacement $B$"
    assert loaded.plot(0.04).get_ylabel() == "largest $|u|$"


def test_isolation_that_begins_at_a_fold_begins_exactly_there():
    duffing = Duffing(alpha=0.3174721, beta=9.8818251, zeta=0.02781846, load=0.0262015738)
    folds, found = duffing.saddle_nodes(0.0172011016), duffing.isolation(0.0172011016)
    assert found.at_fold and (found.Omega, found.A) == (folds.Omega[-1], folds.A[-1])


@pytest.mark.slow
def test_rows_of_many_forcings_cross_folds_as_pairs_do():
    """Ways share forcings; two rows by themselves share others."""
    loaded = isolator(load=0.03)
    Omega, F_0 = np.array([0.9, 0.95, 1.2, 0.76, 0.8]), np.array([0.03, 0.04, 0.02, 0.025, 0.035])
    crosses = loaded.spectrum(Omega=Omega, F_0=F_0).crosses[1:]
    pairs = [loaded.spectrum(Omega=Omega[k : k + 2], F_0=F_0[k : k + 2]).crosses[1] for k in range(4)]
    assert crosses.tolist() == pairs and any(pairs) and not all(pairs)


@pytest.mark.slow
def test_crossed_fold_under_a_load_changes_the_number_of_motions():
    spring = Duffing(1.0, 0.5, zeta=0.05, load=0.3)
    Omega, F_0 = np.linspace((1.0, 0.05), (1.3, 0.2), 30).T
    states = spring.amplitudes(Omega=Omega, F_0=F_0)
    changes = len({int((states.Omega == at).sum()) for at in Omega}) > 1
    found = spring.spectrum(Omega=Omega[[0, -1]], F_0=F_0[[0, -1]])
    assert found.crosses.tolist() == [False, changes] == [False, True]


def test_less_force_is_transmitted_from_the_isolation_on(loaded):
    begins = loaded.isolation(0.04)
    (at,) = loaded.amplitudes(Omega=begins.Omega, F_0=0.04)
    assert at.A == pytest.approx(begins.A, rel=1e-9) and not begins.at_fold
    assert loaded.amplitudes(Omega=begins.Omega, F_0=0.04).transmissibility == pytest.approx([1.0], rel=1e-9)
    beyond = loaded.amplitudes(Omega=begins.Omega * np.linspace(1.0001, 3.0, 24), F_0=0.04)
    assert (beyond.transmissibility[beyond.stable] < 1).all()


def test_transmission_beyond_a_frequency_is_found(loaded):
    true, last = loaded.isolation(0.04), loaded.off_centre._reach.last_transmitting
    assert Remark.UNDECIDED not in true.remarks and not true.message
    motion, is_proved = last(0.04, Level.of(0.0), 0.97 * true.Omega)
    assert is_proved and motion.Omega == pytest.approx(true.Omega, rel=1e-14)
    assert last(0.04, Level.of(0.0), 1.0001 * true.Omega) == (None, True)


def test_undecided_folds_next_to_rest_are_at_no_minus_zero(monkeypatch):
    """Isolation, which repeats what folds leave undecided, had them next to A = -0."""
    monkeypatch.setattr(Complete, "corners", lambda *_: (np.empty((3, 0)), [], np.array([[-1e-14], [0.1], [0.0]])))
    assert Isolator(**TABLE_1, load=0.03).isolation(0.04).message.endswith("next to A = 0")


def test_isolation_that_is_not_proved_is_undecided(loaded, monkeypatch):
    monkeypatch.setattr(reach, "MOST_BOXES", 1)
    assert loaded.isolation(0.04).remarks & Remark.UNDECIDED and "undecided" in loaded.isolation(0.04).message
    values = {name: [value] for name, value in {**TABLE_1, "load": 0.03}.items()}
    many = Isolator.many(**values).isolation(0.04)
    assert (many.remarks[0] & Remark.UNDECIDED) and many.status[0] == Status.OK


def test_curve_without_folds_climbs_a_narrow_resonance():
    """Its points are not nearer to one another than its ends are: they were left out, and the resonance with them."""
    osc = Duffing(1.0, 0.577, mu=0.006, zeta=0.052, load=0.22)
    peak, curve = osc.peak(0.0206), osc.frequency_response(0.0206, Omega=(0.02, 4.0))
    assert curve.A.max() == pytest.approx(peak.A, rel=1e-3)
    assert np.diff(np.sort(curve.Omega)).max() < 0.005
    assert curve.A[::100] == pytest.approx(osc.amplitudes(Omega=curve.Omega[::100], F_0=0.0206).A, rel=1e-9)


@pytest.mark.parametrize(
    ("alpha", "beta", "zeta", "load", "F_0"), [(1.0, -0.82, 0.015, 0.165, 0.064), (-0.28, 1.92, 0.033, 0.022, 0.078)]
)
def test_curves_pass_all_states_where_the_mean_turns(alpha, beta, zeta, load, F_0):
    osc = Duffing(alpha, beta, zeta=zeta, load=load)
    curve = osc.frequency_response(F_0)
    for Omega in (0.1, 0.45, 0.62, 0.8, 1.3):
        on_both_sides = (curve.Omega[1:] - Omega) * (curve.Omega[:-1] - Omega) < 0
        crossed = int((on_both_sides & (np.diff(curve.branch) == 0)).sum())
        assert crossed == len(osc.amplitudes(Omega=Omega, F_0=F_0))


@pytest.mark.parametrize(
    ("r", "delta_h", "zeta", "c_2", "load", "F_0"),
    [(2.95, 0.0689, 0.01736, 0.0405, 0.00984, 0.5527), (2.407, 0.07675, 0.0194, 0.0357, 0.0963, 0.6792)],
)
def test_curve_between_close_folds_is_no_isola(r, delta_h, zeta, c_2, load, F_0):
    """It passes an amplitude as often as there are frequencies of it: a closed curve would need two more."""
    osc = Isolator(lam=3.0, r=r, delta_h=delta_h, zeta=zeta, c_2=c_2, load=load)
    folds, curve = osc.saddle_nodes(F_0), osc.frequency_response(F_0)
    steps, flow = osc.off_centre._steps, osc.off_centre._flow
    close = np.flatnonzero(np.diff(folds.Omega) < 1e-5)
    assert close.size and not any(curve.isola)
    for k in close:
        A, B = steps.balanced(np.array([[folds.A[k : k + 2].mean()], [folds.B[k]]]))[0]
        Omega = flow.frequencies(A, -2 * steps.at(A, B, 0).s[0], F_0)
        assert ((curve.A[1:] - A) * (curve.A[:-1] - A) < 0).sum() == np.isfinite(Omega).sum()


def test_missing_gradient_under_a_load_is_explained(loaded):
    heavy = loaded.replace(load=0.1).saddle_node_onset()
    assert heavy.kind == "corner" and "reaches a breakpoint" in heavy.gradient().message
    none = loaded.replace(load=0.45).detachment()
    assert none.F_cr is None and "no answer to differentiate" in none.gradient().message
    bent = Duffing(1.0, 0.5, 0.0, 0.05, load=0.3)
    folds = bent.saddle_nodes(0.2)
    made = SteadyStates(folds.Omega, folds.A, folds.kind == "", 0.2, "", bent.off_centre._model, B=folds.B, load=0.3)
    on_folds = answers.gradient(made, "amplitudes")
    assert "2 of 2: it merges with another answer there" in on_folds.message and np.isnan(on_folds.slopes).all()


def test_an_onset_whose_search_begins_at_it_is_answered():
    """The neighbouring onset agrees with the gradient by zeta to the square of the step."""
    onset = Duffing(1.0, 0.5, 0.01, 0.03, load=0.3).saddle_node_onset()
    neighbour = Duffing(1.0, 0.5, 0.01, 0.03 - 1e-5, load=0.3).saddle_node_onset()
    expected = onset.F_SN - 1e-5 * onset.gradient()["F_SN", "zeta"]
    assert neighbour.F_SN == pytest.approx(expected, rel=(1e-5 / 0.03) ** 2)


def test_an_onset_is_the_same_after_other_questions():
    """A larger forcing needs larger amplitudes, which have no part in the search for the least one."""
    design = dict(lam=4.0, r=6.28, delta_h=0.0246, mu=0.00014, zeta=0.0153, excitation="unbalance", load=-0.00765)
    first, after = Isolator(**design), Isolator(**design)
    after.saddle_nodes(0.1)
    assert first.saddle_node_onset().F_SN == after.saddle_node_onset().F_SN is not None


def test_motion_unknown_to_averaging_is_found_by_amplitude():
    """Averaging has one at A = 0.1275 there, of which the exact one is unstable; what a sweep sees is larger."""
    design = {"lam": 4, "r": 1.7557163929700856, "delta_h": 0.1196097311753126, "zeta": 0.013149868738899468}
    loaded, at = Isolator(**design, load=0.012862148104504246), {"Omega": 0.95482, "F_0": 0.04221152153801278}
    (seen,) = loaded.sweep(Omega=[at["Omega"]], F_0=at["F_0"]).A
    found = loaded.steady_state(**at, A=seen)
    assert found.A == pytest.approx(seen, rel=1e-6) and found.stable
    assert min(abs(loaded.amplitudes(**at).u_max - seen)) > 0.05


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.0, 0.01])
@pytest.mark.parametrize(("softer", "harder"), [(1.0, 1.5), (0.3, 4.0)])
def test_bilinear_spring_isolates_at_twice_its_backbone(mu, softer, harder):
    """Without a size h = -p A and B = -q A at any amplitude, by the mean of the force; as much as F_0 is transmitted
    where R = -h, at Omega^2 = 2 p. Boxes next to rest did not end, and it was unresolved.
    """
    u, a, b = sympy.symbols("u a b")
    numbers = {name: {"above": 0} for name in ("a", "b")}
    made = derive.mechanism("both_sides", [(a * u, 0), (b * u, None)], numbers, odd=False)
    psi = np.linspace(0, np.pi, 400_001)

    def over_a_cycle(q, weight):
        way = np.cos(psi) - q
        return float(np.trapezoid(np.where(way > 0, harder, softer) * way * weight, psi)) / np.pi

    q = brentq(lambda q: over_a_cycle(q, 1.0), 0.0, 1.0)
    p = 2 * over_a_cycle(q, np.cos(psi))
    found = made(a=softer, b=harder, mu=mu, zeta=0.03).isolation(0.05)
    assert found.Omega == pytest.approx(math.sqrt(2 * p), rel=1e-7) and not found.message


def test_forcing_beyond_all_sizes_is_refused_before_memory():
    """Its motions span a thousand octaves, and boxes of all of them tens of gigabytes."""
    with pytest.raises(ArithmeticError, match=r"amplitudes may be as large as .* beyond the range of doubles"):
        Isolator(lam=3, r=2.03, delta_h=0.082, mu=0.012, zeta=0.02, load=0.03).saddle_nodes(1e290)


def test_undamped_range_of_folds_is_refused():
    """It divided by the damping, with a warning."""
    with pytest.raises(ValueError, match="A_max needs zeta > 0, eta > 0 or c_2 > 0 for offset motions"):
        Isolator(lam=2, r=0.3, delta_h=0.3).off_centre.A_max(1.3)
    with pytest.raises(ValueError, match=r"F_0 = -1\.0 is not allowed"):
        isolator().off_centre.A_max(-1.0)


@pytest.mark.slow
def test_load_of_any_size_is_answered_or_refused():
    """Bounds on the mean are products that leave the range of doubles: they did with a warning."""
    for load in part((1e60, 1e150, 1.7e308), 3):
        loaded = Isolator(lam=3, r=2, delta_h=0.08, zeta=0.1, load=load)
        for ask in (loaded.rest, loaded.detachment, lambda of=loaded: of.saddle_nodes(0.1)):
            try:
                assert ask().message
            except NotSettled as refusal:
                assert "unresolved" in str(refusal)
    many = Isolator.many(lam=3, r=2, delta_h=0.08, zeta=0.1, load=[1.7e308, 0.01]).rest()
    assert many.status.tolist() == [Status.NO_BOUND, Status.OK]


def test_peak_of_undetermined_frequency_is_refused():
    """Its Omega was NaN, beside A = 7e15, with a warning: damping is next to none, and the spring at rest too."""
    spring = Duffing(0.0, 0.003, zeta=3e-15, eta=0.085, excitation="unbalance", load=0.003)
    for F_0 in (1e-6, 1e-3, 0.1):
        try:
            found = spring.peak(F_0)
        except NotSettled as refusal:
            assert "double precision does not resolve the frequency" in str(refusal)
        else:
            assert found.message if found.Omega is None else found.Omega > 0


@pytest.mark.parametrize("octaves", [-100, 60, *slow(-150, -45, -20, -10, 150)])
def test_answers_scale_with_the_unit_of_length_or_are_refused(octaves):
    """On a base lengths of 1e-30 gave a peak at Omega = 1e32 without a word."""

    def mount(s):
        return Duffing(1.0, 1.0405215808494257 / s / s, 0.01 * s, 0.0283, load=0.1 * s, excitation="base")

    s, F_0 = 2.0**octaves, 0.19427233724301723
    if octaves < -40:
        for ask in ("saddle_nodes", "peak"):
            with pytest.raises(OverflowError, match="are too small against 1; in smaller units of length"):
                getattr(mount(s), ask)(F_0 * s)
        return
    one, other = (mount(unit).amplitudes(Omega=1.5756199434710894, F_0=F_0 * unit) for unit in (1.0, s))
    for name in ("A", "B"):
        assert getattr(other, name) / s == pytest.approx(getattr(one, name), rel=1e-9)
    one, other = (mount(unit).saddle_node_onset() for unit in (1.0, s))
    assert [other.F_SN / s, other.Omega] == pytest.approx([one.F_SN, one.Omega], rel=1e-9)
    assert "no peak up to A" in mount(s).peak(F_0 * s).message
    one, other = (mount(unit).saddle_nodes(F_0 * unit) for unit in (1.0, s))
    assert [other.A[0] / s, other.Omega[0]] == pytest.approx([one.A[0], one.Omega[0]], rel=1e-9) and len(other) == len(
        one
    )
