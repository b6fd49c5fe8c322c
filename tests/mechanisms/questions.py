"""Every question put to a bilinear spring, in a project that was given its file.

In:  the generated record `bilinear`, compiled or not.
Out: which solvers answered; each answer is held against the describing function in closed form, brute force, or a
     direct integration.
"""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

from slowflow.oscillators.oscillator import Oscillator
from slowflow_kernels import bilinear

K_1, K_2, D, MU, ZETA = 1.0, 9.0, 0.2, 0.01, 0.03  # K_1 is the unit of stiffness
DESIGN = {"kappa": K_2, "delta": D, "mu": MU, "zeta": ZETA}
F_0 = 0.06
M = 4 * MU / math.pi


def force(u):
    """The spring's force."""
    return K_1 * u if abs(u) <= D else math.copysign(K_1 * D + K_2 * (abs(u) - D), u)


def stiffness(A):
    """The describing function of the spring: the stiffness of the linear one that its first harmonic is."""
    x = np.minimum(D / A, 1.0)
    return K_2 + (K_1 - K_2) * 2 / math.pi * (np.arcsin(x) + x * np.sqrt(1 - x**2))


def level(Omega, A):
    """The forcing that balances (24)."""
    return np.hypot((stiffness(A) - Omega**2) * A, 2 * ZETA * Omega * A + M)


def states(Omega, forcing=F_0):
    """The amplitudes at a frequency by brute force: changes of sign on a fine grid, refined by bisection."""
    A = np.geomspace(1e-3, 2.0, 40_000)
    over = level(Omega, A) > forcing
    found = []
    for i in np.flatnonzero(over[1:] != over[:-1]):
        low, high = A[i], A[i + 1]
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if (level(Omega, middle) > forcing) == over[i] else (low, middle)
        found.append(low)
    return np.array(found)


def close(one, other, within):
    """Both are the same, relatively."""
    np.testing.assert_allclose(one, other, rtol=within)


def averaged(oscillator):
    """Averages, states, curve, folds, onset, detachment, peak, loci."""
    A = np.array([0.05, D, 0.21, 0.3, 5.0])
    close(oscillator.backbone(A), np.sqrt(stiffness(A)), 1e-14)
    u = np.array([-0.5, -D, -0.1, 0.0, 0.1, 0.5])
    close(oscillator.force(u), [force(at) for at in u], 1e-14)
    for Omega in (0.5, 1.0, 1.2, 1.5, 1.9, 2.3):
        close(oscillator.amplitudes(Omega=Omega, F_0=F_0).A, states(Omega), 1e-11)
    curve = oscillator.frequency_response(F_0)
    close(level(curve.Omega, curve.A), F_0, 1e-12)
    folds = oscillator.saddle_nodes(F_0)
    assert folds.kind.tolist() == ["jump-up", "jump-down"]
    for Omega, sense in zip(folds.Omega, (1, -1), strict=True):
        # two states come into being at the lower fold and vanish at the upper one
        assert states(Omega * (1 + 1e-6 * sense)).size == 3 and states(Omega * (1 - 1e-6 * sense)).size == 1
    onset = oscillator.saddle_node_onset()
    close(level(onset.Omega, onset.A), onset.F_SN, 1e-13)
    frequencies = onset.Omega * (1 + np.linspace(-0.02, 0.05, 400))
    assert all(states(Omega, onset.F_SN * 0.999).size == 1 for Omega in frequencies)
    assert (
        len(oscillator.saddle_nodes(onset.F_SN * 0.999)) == 0 and len(oscillator.saddle_nodes(onset.F_SN * 1.001)) == 2
    )
    detachment = oscillator.detachment()
    assert detachment.u_cr == D
    lowest = minimize_scalar(lambda Omega: level(Omega, D), bounds=(0.5, 1.5), options={"xatol": 1e-10})
    close(detachment.F_cr, lowest.fun, 1e-12)
    peak = oscillator.peak(F_0)
    highest = minimize_scalar(lambda Omega: -states(Omega).max(), bounds=(1.9, folds.Omega[1]), options={"xatol": 1e-9})
    close(peak.A, -highest.fun, 1e-9)
    locus = oscillator.fold_locus(A_max=2.0)
    close(level(locus.Omega, locus.A), locus.F_0, 1e-12)
    # found on another range, from another bracket
    close(oscillator.cusps(A_max=2.0).F_0.min(), onset.F_SN, 1e-13)
    assert len(oscillator.isola_points(A_max=2.0)) == 0
    assert "pieces up to the largest amplitude" in str(oscillator.explain("saddle_nodes", F_0))


def exact(oscillator):
    """A motion, a curve, a sweep, and the second approximation between them and averaging."""
    motion = oscillator.steady_state(Omega=1.9, F_0=F_0, A=0.35)
    tau, u, v = motion.series(8)

    def rates(t, y):
        friction = MU * np.sign(y[1])
        return y[1], F_0 * math.cos(1.9 * t) - force(y[0]) - 2 * ZETA * y[1] - friction

    followed = solve_ivp(rates, (0, tau[-1]), (u[0], v[0]), t_eval=tau, rtol=1e-9, atol=1e-10, max_step=0.01).y
    assert np.abs(followed - (u, v)).max() < 1e-5  # the sign of the velocity is not located: a step's error
    curve = oscillator.exact_response(F_0, Omega=(1.0, 2.2), step=0.05)
    assert [fold.kind for fold in curve.folds] == ["jump-up", "jump-down"]
    jump_down = curve.folds[1].Omega
    averaging, second = oscillator.saddle_nodes(F_0), oscillator.second_approximation.saddle_nodes(F_0)
    assert abs(second.Omega[1] - jump_down) < 0.2 * abs(averaging.Omega[1] - jump_down)
    up = np.linspace(0.8, 2.3, 12)
    swept = oscillator.sweep(Omega=[*up, *up[::-1]], F_0=F_0)
    between = (up > curve.folds[0].Omega) & (up < 1.9)
    rising, falling = swept.A[:12][between], swept.A[12:][::-1][between]
    assert swept.settled.all() and (rising > 1.5 * falling).all()
    below_fold = up < curve.folds[0].Omega
    assert below_fold.any() and np.allclose(swept.A[:12][below_fold], swept.A[12:][::-1][below_fold], rtol=1e-7)


def batches(oscillator):
    """A batch is its single answers."""
    many = Oscillator.many(bilinear.MECHANISM, **{**DESIGN, "kappa": [K_2, -1.0, 1.0], "delta": [D, D, -1.0]})
    onsets, folds = many.saddle_node_onset(), many.saddle_nodes(F_0)
    close(onsets.F_SN[0], oscillator.saddle_node_onset().F_SN, 1e-13)
    assert folds.count.tolist()[0] == 2 and onsets.status[2] == many.detachment().status[2] == 1
    close(many.detachment().F_cr[0], oscillator.detachment().F_cr, 1e-14)
    close(many.peak(F_0).A[0], oscillator.peak(F_0).A, 1e-13)


if __name__ == "__main__":
    spring = Oscillator(bilinear.MECHANISM, **DESIGN)
    averaged(spring)
    exact(spring)
    batches(spring)
    print("compiled" if spring.model.native is not None else "NumPy")
