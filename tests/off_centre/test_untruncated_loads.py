"""The isolator under a load with its force as the geometry gives it, against the equations typed here at 30 digits."""

import mpmath as mp
import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers.results import Remark
from slowflow.averaged import proofs
from tests.sampling import slow

TABLE_1 = {"lam": 3, "r": 3747 / 1848, "delta_h": 1848 / (6 * 3747), "mu": 0.012, "zeta": 0.02}
STEEP = {"lam": 2, "r": 0.6, "delta_h": 0.7, "mu": 0.02, "zeta": 0.05}
CASES = pytest.mark.parametrize(("design", "load", "F_0"), [(TABLE_1, 0.01, 0.04), *slow((STEEP, -0.2, 0.15))])


def restoring(lam, r, delta_h, **_):
    """f(u) of (5): springs at a rod of length 1, hinged 1 from the line of the mass, compressed by delta_h at u = 0."""

    def f(u):
        compression = mp.mpf(delta_h) - (1 - mp.sqrt(1 - u**2)) if abs(u) < 1 else -1
        return u - lam * mp.mpf(r) * compression * u / mp.sqrt(1 - u**2) if compression > 0 else u

    return f, mp.sqrt(1 - (1 - mp.mpf(delta_h)) ** 2)


def residuals(design, load, F_0, Omega, A, B):
    """Mean force less the load, and the forcing that balances the first harmonic over F_0, less 1."""
    f, u_cr = restoring(**design)
    inside = sorted(mp.acos((end - B) / A) for end in (-u_cr, u_cr) if abs(end - B) < A)
    turns = [0, *inside, mp.pi]
    mean, first = (mp.quad(lambda psi, p=p: f(B + A * mp.cos(psi)) * mp.cos(psi) ** p, turns) / mp.pi for p in (0, 1))
    I = 2 * mp.mpf(design["zeta"]) * A * Omega + 4 * mp.mpf(design["mu"]) / mp.pi
    return mean - load, mp.hypot(A * Omega**2 - 2 * first, I) / F_0 - 1


@CASES
def test_states_and_folds_satisfy_the_averaged_equations(design, load, F_0):
    iso = Isolator(**design, load=load, force="untruncated")
    folds = iso.saddle_nodes(F_0)
    found = [*zip(folds.Omega, folds.A, folds.B, strict=True)]
    states = iso.amplitudes(Omega=[0.5, 0.9, 1.3], F_0=F_0)
    found += zip(states.Omega, states.A, states.B, strict=True)
    assert len(found) >= 3
    with mp.workdps(30):
        for Omega, A, B in found:
            for one in residuals(design, load, F_0, *map(mp.mpf, (Omega, A, B))):
                assert abs(one) < 1e-12


def test_onset_at_a_jump_of_the_slope_is_the_lowest_forcing():
    """The motion just comes to u_cr: beyond it the level rises as a root does, and roundings count."""
    numbers = {"lam": 3, "r": 1.4015379083224386, "delta_h": 0.05, "mu": 0.0, "zeta": 0.0744492629009588}
    one = Isolator(**numbers, force="untruncated", load=-0.00315820991077285)
    onset = one.saddle_node_onset().F_SN
    assert [len(one.saddle_nodes(onset * (1 + change))) > 0 for change in (-1e-9, 1e-9)] == [False, True]


#: with the untruncated force onsets are next to a kink of the slope, where the second fold is within what is rounded
JUST_ABOVE = [
    Isolator(lam=3, r=1.4015379083224386, delta_h=0.05, zeta=0.0744492629009588, load=-0.003, force="untruncated"),
    Isolator(lam=3, r=0.608, delta_h=0.054, mu=0.002, zeta=0.0306, load=-0.00325, force="untruncated"),
    Isolator(lam=3, r=1.6, delta_h=0.0366, mu=0.002, zeta=0.062, load=0.000628, force="untruncated"),
    Isolator(**TABLE_1, load=0.1),
    Duffing(alpha=0.5, beta=1.0, mu=0.002, zeta=0.05, load=0.02),
]


@pytest.mark.parametrize("one", [JUST_ABOVE[0], *slow(*JUST_ABOVE[1:])], ids=repr)
def test_just_above_an_onset_folds_are_two_or_undecided(one):
    onset, decided = one.saddle_node_onset().F_SN, []
    for change in (1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3):
        folds = one.saddle_nodes(onset * (1 + change))
        decided.append(Remark.UNDECIDED not in folds.remarks)
        assert len(folds) == 2 if decided[-1] else len(folds) <= 2
        assert decided[-1] or "undecided" in folds.message
    assert decided[-2:] == [True, True]


def test_undecided_folds_are_undecided_in_what_rests_on_them():
    """Next to an onset on a corner none may be proved, and none excluded."""
    one, unproved = Isolator(**TABLE_1, load=0.1), 0
    for F_0 in one.saddle_node_onset().F_SN * (1 + 1e-15 * np.arange(-16, 9)):
        folds = one.saddle_nodes(F_0)
        if Remark.UNDECIDED in folds.remarks and not len(folds):
            unproved += 1
            for found in (one.frequency_response(F_0, samples=60), one.isolation(F_0), one.hysteresis(F_0)):
                assert Remark.UNDECIDED in found.remarks and folds.message in found.message
    assert unproved


@pytest.mark.parametrize(
    "one",
    [Duffing(alpha=0.25, beta=-1.0, mu=0.01, zeta=0.03), Isolator(lam=1.79, r=2.38, delta_h=0.24, mu=0.012, zeta=0.05)],
)
def test_folds_undecided_about_the_centre_are_undecided_off_it(monkeypatch, one):
    """As without python-flint, which decides more: those about the centre are among all motions."""
    monkeypatch.setattr(proofs, "ball_questions", lambda: None)
    onset, marked = one.saddle_node_onset().F_SN, []
    for F_0 in onset * (1 + 1e-15 * np.arange(-3, 4)):
        if Remark.UNDECIDED in one.saddle_nodes(F_0).remarks:
            found = [one.off_centre.saddle_nodes(F_0), one.off_centre.isolation(F_0)]
            marked += [Remark.UNDECIDED in each.remarks and "not resolved" in each.message for each in found]
            assert "single-valued" not in found[0].message
    assert marked and all(marked)


def test_response_undecided_about_the_centre_is_undecided_off_it(monkeypatch):
    monkeypatch.setattr(proofs, "ball_questions", lambda: None)
    one, marked = Isolator(**TABLE_1), []
    assert one.off_centre._keeps_centre
    for F_0 in one.saddle_node_onset().F_SN * (1 + 1e-15 * np.arange(-3, 4)):
        known, found = (of.frequency_response(F_0, samples=60) for of in (one, one.off_centre))
        if Remark.UNDECIDED in known.remarks:
            marked.append(Remark.UNDECIDED in found.remarks)
    assert marked and all(marked)
