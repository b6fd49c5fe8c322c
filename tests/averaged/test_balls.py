"""Proofs in balls: what doubles leave undecided is decided, and right; so is the force that is not truncated."""

import importlib.util
import itertools
import math
from fractions import Fraction

import flint
import mpmath
import numpy as np
import pytest

from slowflow import Duffing, Isolator, example
from slowflow.answers.results import Remark
from slowflow.averaged import messages, proofs, solvers
from slowflow.averaged.balls.search import AT_0, BallModel, Enclosure, averages_of
from tests.sampling import slow

#: designs of the force that is not truncated: as in Table 1, nearly quasi-zero stiffness, negative stiffness, steep
UNTRUNCATED = (
    {"lam": 3.0, "r": 2.0275974025974026, "delta_h": 0.08220, "mu": 0.012, "zeta": 0.02},
    {"lam": 2.0, "r": 4.0, "delta_h": 0.12, "mu": 0.004, "zeta": 0.01},
    {"lam": 3.0, "r": 2.0, "delta_h": 0.17, "mu": 0.01, "zeta": 0.03},
    {"lam": 1.0, "r": 0.6, "delta_h": 0.9, "mu": 0.01, "zeta": 0.02},
)


def untruncated(design):
    return Isolator(**design, force="untruncated")


OPERATIONS = {
    "add": lambda x, y: x + y,
    "sub": lambda x, y: x - y,
    "mul": lambda x, y: x * y,
    "div": lambda x, y: x / y,
    "square": lambda x, y: x.square(),
    "sqrt": lambda x, y: x.sqrt().square(),
}


@pytest.mark.parametrize("name", OPERATIONS)
def test_ball_operation_encloses_exact_arithmetic(name):
    rng = np.random.default_rng(5)
    ends = np.sort(rng.choice([-1, 1, 1], (300, 2, 2)) * 10.0 ** rng.uniform(-3, 3, (300, 2, 2)), axis=2)
    ends[::7, 0, 0], ends[::11, 1, 1] = -math.inf, math.inf
    with flint.ctx.workprec(40):  # fewer than a double has: each operation rounds
        for (a, b), (c, d) in ends.tolist():
            x, y = (Enclosure(flint.arb(low), flint.arb(high)) for low, high in ((a, b), (c, d)))
            found = OPERATIONS[name](x, y)
            for p, q in itertools.product((max(a, -1e9), b, 0.5 * (max(a, -1e9) + b)), (c, min(d, 1e9))):
                u, v = Fraction(p), Fraction(q)
                if (name == "sqrt" and u < 0) or (name == "div" and v == 0):
                    continue
                exact = {"add": u + v, "sub": u - v, "mul": u * v, "square": u * u, "sqrt": u}.get(name)
                value = flint.fmpq(*(u / v if exact is None else exact).as_integer_ratio())
                assert not found.lo > value
                assert not found.hi < value


def spring(design, u):
    """The force of the horizontal springs, of which each has lost 1 - sqrt(1 - u^2) of its preload."""
    root = mpmath.sqrt(1 - u * u)
    return -design["lam"] * design["r"] * (design["delta_h"] - 1 + root) * u / root


def average(design, A):
    """h of the force that is not truncated, by quadrature of that force, in mpmath's digits."""
    design = {name: mpmath.mpf(value) for name, value in design.items()}
    u_cr = mpmath.sqrt(design["delta_h"] * (2 - design["delta_h"]))
    theta = mpmath.pi / 2 if u_cr >= A else mpmath.asin(u_cr / A)
    integral = mpmath.quad(lambda t: spring(design, A * mpmath.sin(t)) * mpmath.sin(t), [0, theta / 2, theta])
    return -A - 4 / mpmath.pi * integral


@pytest.mark.parametrize("A", [1e-3, 0.3, 0.41, 0.9, 7.0])
def test_averages_in_balls_are_those_of_the_force(A):
    """h by quadrature; each derivative by differences of the one before."""
    design, step = UNTRUNCATED[0], flint.arb(2) ** -60
    model = untruncated(design).model
    with mpmath.workdps(30), flint.ctx.workprec(300):
        balls = BallModel(model, averages_of(model.mechanism))
        piece = int(A > model.breakpoints[0])
        beyond = (flint.arb(A) - balls.beyond(piece, AT_0).middle).mid()
        low, at, high = (balls.at(piece, beyond + shift) for shift in (-step, 0, step))
        h = average(design, mpmath.mpf((balls.beyond(piece, AT_0).middle + beyond).str(60, radius=False)))
        assert abs(mpmath.mpf(at.h.middle.str(50, radius=False)) / h - 1) < 1e-28
        for name, slope in (("h", "h_A"), ("h_A", "h_AA"), ("h_AA", "h_AAA"), ("k", None)):
            difference = (getattr(high, name).middle - getattr(low, name).middle) / (2 * step)
            exact = -A * at.h_AA.middle if slope is None else getattr(at, slope).middle
            assert abs(float(difference / exact) - 1) < 1e-14


@pytest.mark.parametrize("design", [UNTRUNCATED[0], *slow(*UNTRUNCATED[1:])])
def test_untruncated_folds_are_those_that_are_proved(design):
    iso = untruncated(design)
    F_0 = 1.3 * iso.saddle_node_onset().F_SN
    found = iso.saddle_nodes(F_0, certify=True)
    assert found.proof.proved and found.proof.bounded
    assert len(found) == len(found.proof.A) == len(proofs.folds.in_balls(iso.model, F_0).A) >= 2
    for values, ends in ((found.Omega, found.proof.Omega), (found.A, found.proof.A)):
        assert (ends[:, 0] <= values).all() and (values <= ends[:, 1]).all()


@pytest.mark.parametrize("design", UNTRUNCATED)
def test_untruncated_certificate_encloses_what_solvers_find(design):
    iso = untruncated(design)
    onset, detachment = iso.saddle_node_onset(), iso.detachment()
    found = iso.certify(1.5 * onset.F_SN, Omega=onset.Omega)
    assert found.proved
    states = iso.amplitudes(Omega=onset.Omega, F_0=1.5 * onset.F_SN)
    assert states.stable.tolist() == found.amplitudes.stable.tolist()
    for value, enclosed in (
        (onset.F_SN, found.saddle_node_onset.F_0),
        (detachment.F_cr, found.detachment.F_0),
        *zip(states.A, found.amplitudes.A, strict=True),
    ):
        assert enclosed == pytest.approx(value, rel=1e-13)


@pytest.mark.slow
def test_an_onset_that_doubles_refuse_is_proved():
    """delta_h = 1 - 1e-8: F_A and F_AA vanish there by quadrature of the force."""
    design = {"lam": 3.0, "r": 0.0507, "delta_h": 1 - 1e-8, "mu": 1e-4, "zeta": 0.02}
    iso = untruncated(design)
    with pytest.raises(ArithmeticError, match=r"unresolved: .*certify\(F_0\).saddle_node_onset may enclose it"):
        solvers.onset(iso.model)
    found, onset = proofs.onset.in_balls(iso.model), iso.saddle_node_onset()
    assert found.proved
    assert found.kind == onset.kind == "cusp"
    assert onset.remarks == Remark.BY_BALLS and "resolved in ball arithmetic" in onset.message
    for value, (low, high) in zip((onset.F_SN, onset.Omega, onset.A), (found.F_0, found.Omega, found.A), strict=True):
        assert low <= value <= high
    A, w = (mpmath.mpf(float(ends.mean())) for ends in (found.A, found.Omega))
    with mpmath.workdps(30):
        level = average(design, A) + A * w**2, 2 * design["zeta"] * A * w + 4 * mpmath.mpf(design["mu"]) / mpmath.pi
        assert abs(mpmath.hypot(*level) / found.F_0.mean() - 1) < 1e-9


def test_whether_a_mass_moves_is_decided_one_ulp_from_friction():
    iso = Duffing(1.0, 2.0, mu=0.01, zeta=0.02)
    with mpmath.workdps(40):
        m = 4 * mpmath.mpf(iso.mu) / mpmath.pi
        for F_0 in (math.nextafter(float(m), 0), float(m), math.nextafter(float(m), 1)):
            proof = proofs.folds(iso.model, F_0)
            assert proof.proved
            assert proof.message.startswith("sticks") is not (mpmath.mpf(F_0) > m)


@pytest.mark.slow
def test_a_double_state_that_is_exact_stays_undecided_in_words():
    """Where two states meet at numbers that are doubles no digits tell them apart."""
    iso = Duffing(2.5, -4.0, mu=0.0, zeta=0.0)
    # R = A (Omega^2 - 5/2) + 3 A^3 = -F_0 at Omega = 1/2: R is least where 9 A^2 = 9/4, at A = 1/2, and is -3/4 there
    proof = proofs.states(iso.model, 0.75, 0.5)
    assert not proof.proved
    assert messages.BALLS_IN_DOUBT.format(512, "") in proof.message
    assert proof.doubt[0, 0] < 0.5 < proof.doubt[0, 1]
    for F_0, count in ((math.nextafter(0.75, 0), 3), (math.nextafter(0.75, 1), 1)):
        found = proofs.states(iso.model, F_0, 0.5)
        assert found.proved
        assert len(found.A) == count


def test_without_flint_the_answer_says_how_to_have_it(monkeypatch):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    iso = untruncated(UNTRUNCATED[0])
    proof = proofs.folds(iso.model, float(np.nextafter(iso.saddle_node_onset().F_SN, 1)))
    assert not proof.proved
    assert messages.NO_BALLS in proof.message


def test_proofs_in_balls_are_the_same_in_threads():
    """FLINT's precision is one global number for all threads."""
    from concurrent.futures import ThreadPoolExecutor

    model = untruncated(UNTRUNCATED[1]).model
    single = proofs.folds.in_balls(model, 0.05)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: proofs.folds.in_balls(model, 0.05), range(4)))
    assert all(one == single for one in found)
    assert example.isolator().certify(0.04).proved


@pytest.mark.parametrize(
    ("alpha", "beta", "message"),
    [
        (-0.5, 1.0, messages.OF_NO_ONSET),  # k = 3 beta A^3/2 rises along the locus, which begins at Omega = 0
        (-0.5, -1.0, messages.OF_NO_ONSET),  # h_A > 0: no locus
        (0.0, -1.0, messages.OF_NO_ONSET),
        (0.0, 1.0, messages.OF_NO_LOWEST),  # the locus begins at A = 0, at 4 mu/pi
    ],
)
def test_undamped_birth_is_proved_for_any_stiffness_at_rest(alpha, beta, message):
    iso = Duffing(alpha, beta, mu=0.05, zeta=0.0)
    found = proofs.onset(iso.model)
    assert found.proved
    assert found.message == message[True]


@pytest.mark.slow
@pytest.mark.parametrize("delta_h", [1e-10, 1e-20, 1e-67])
@pytest.mark.parametrize("mu", [0.0, 0.01])
def test_undamped_folds_next_to_the_corner_have_a_frequency(delta_h, mu):
    """Both lie within 1e-10 of u_cr, where R^2 + m^2 = F_0^2: they were said to be proved at Omega = inf.

    Doubles do not tell them apart: balls do, where they are asked.
    """
    lam, r, F_0 = 3, 2.974727746287969, 0.49
    with mpmath.workdps(80):
        u, preload = mpmath.mpf(1), mpmath.mpf(delta_h)
        u = mpmath.sqrt(1 - (1 - preload) ** 2)
        stiffness, m = lam * mpmath.mpf(r), 4 * mpmath.mpf(mu) / mpmath.pi
        # (6) of Table 1's kind: 1 - lam r delta_h and so on, below u_cr
        alpha = 1 - stiffness * preload
        beta, gamma = stiffness * (1 - preload) / 2, stiffness * 3 * (1 - preload) / 8
        h = -(alpha * u + 3 * beta * u**3 / 4 + 5 * gamma * u**5 / 8)
        Omega = float(mpmath.sqrt((mpmath.sqrt(mpmath.mpf(F_0) ** 2 - m**2) - h) / u))
    one = Isolator(lam=lam, r=r, delta_h=delta_h, mu=mu)
    many = Isolator.many(lam=lam, r=r, delta_h=[delta_h, delta_h], mu=mu).saddle_nodes(F_0)
    for found in (one.saddle_nodes(F_0).Omega, many.Omega[0, : many.count[0]]):
        assert len(found) in (0, 2)
        assert found == pytest.approx([Omega] * len(found), rel=1e-9)
    proof = proofs.folds.in_balls(one.model, F_0)
    assert proof.proved and proof.Omega == pytest.approx(np.full((2, 2), Omega), rel=1e-9)
