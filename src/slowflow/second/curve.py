"""The response curve of the second approximation: in goes the first approximation's, out comes what its points move to.

Points follow by Newton's iteration on the balance; those whose harmonics are no small correction are left out.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow.averaged import solvers
from slowflow.model import Floats
from slowflow.results import FrequencyResponse
from slowflow.second.balance import Balance, Flags
from slowflow.second.found import Curve, told
from slowflow_kernels.second_conventions import DONE, LONGEST, MATCHING, MOVED, ROUNDING, SMALL, STEPS, WEIGHT, Wanted

#: amplitudes over that of a breakpoint at which the force jumps, and whose fold has another close above
BESIDE = np.concatenate(([1 - 1e-6, 1.0], 1 + np.logspace(-13, -2, 34)))


def along(
    balance: Balance, F_0: float, samples: int, window: tuple[float, float], wanted: Wanted = Wanted.EVERY_POINT
) -> Curve:
    """The curve that the first approximation's of about `samples` points in a window moves to.

    All of its points, whatever they are wanted for.
    """
    first = solvers.frequency_response(balance.model, F_0, samples, window)
    at, A, kept = _moved(balance, first.Omega, first.A, F_0)
    at, A, lost = at[kept], A[kept], first.Omega[~kept]
    branch, isola = _parts(first, kept)
    for b, jump in zip(balance.model.breakpoints, balance.model.jumps, strict=True):
        if jump != 0:
            at, A, branch = _across(balance, b, at, A, branch, F_0)
    there = balance.response(at, A, F_0)
    stable = there.F_A > 0
    order = _order(at, stable, branch)
    at, A, stable = at[order], A[order], stable[order]
    ends = (lost.min(), lost.max()) if lost.size else (0.0, 0.0)
    message = told(first.message, lost.size, kept.size, *ends)
    u_max, A_1, phi = (column[order] for column in (there.u_max, there.A_1, there.phi))
    return Curve(at, A, u_max, A_1, phi, stable, branch, isola, message, lost.size > 0)


def _across(
    balance: Balance, b: float, Omega: Floats, A: Floats, branch: npt.NDArray[np.intp], F_0: float
) -> tuple[Floats, Floats, npt.NDArray[np.intp]]:
    """The curve with more points where it passes a breakpoint at which the force jumps: folds are close there."""
    passing = np.flatnonzero(((A[1:] > b) != (A[:-1] > b)) & (branch[1:] == branch[:-1]))
    if not passing.size:
        return Omega, A, branch
    rising = A[passing + 1] > b
    amplitudes = np.where(rising[:, np.newaxis], b * BESIDE, b * BESIDE[::-1])
    share = (b - A[passing]) / (A[passing + 1] - A[passing])
    at = np.repeat((Omega[passing] + share * (Omega[passing + 1] - Omega[passing]))[:, np.newaxis], BESIDE.size, 1)
    with np.errstate(all="ignore"):
        at, step = on_curve(balance, at, amplitudes, F_0, balance.averages(amplitudes))
    # inserted where the points on both sides do not lie nearer
    ends = np.sort(np.column_stack((A[passing], A[passing + 1])), axis=1)[:, :, np.newaxis]
    good = (np.abs(step) <= DONE) & (amplitudes > ends[:, 0]) & (amplitudes < ends[:, 1])
    where = np.repeat(passing[:, np.newaxis] + 1, BESIDE.size, 1)[good]
    return (
        np.insert(Omega, where, at[good]),
        np.insert(A, where, amplitudes[good]),
        np.insert(branch, where, branch[where - 1]),
    )


def _moved(balance: Balance, Omega_1: Floats, A_1: Floats, F_0: float) -> tuple[Floats, Floats, Flags]:
    """Points of the first approximation moved to the second: Omega, A, and where that is a correction.

    Each point takes the shortest way. The distance counts ln A, R/F_0, in which the curve keeps away from itself
    however sharp its peak is over Omega, and ln Omega, for where R hardly depends on that.
    """
    Omega, A = Omega_1.copy(), A_1.copy()
    R = balance.model.flow.R(Omega_1, A_1, balance.model.averaged(A_1)[0])
    step = np.full_like(A, np.inf)
    with np.errstate(all="ignore"):
        left = np.flatnonzero(balance.off_resonance(Omega, A))
        for _ in range(STEPS):
            amplitude, averages = A[left], balance.averages(A[left])
            at = _at_R(balance, Omega[left], amplitude, R[left], F_0, averages)
            there = balance.response(at, amplitude, F_0, averages)
            # by ln A and ln Omega
            F, F_x, F_z = (value / F_0**2 for value in (there.F, there.F_A * amplitude, there.F_Omega * at))
            R_x, R_z = there.R_A * amplitude / F_0, there.R_Omega * at / F_0
            # the gradient in the metric dx^2 + dR^2 + (WEIGHT dz)^2
            x, z = (R_z**2 + WEIGHT**2) * F_x - R_x * R_z * F_z, (1 + R_x**2) * F_z - R_x * R_z * F_x
            way = -F / (F_x * x + F_z * z)
            x, z = way * x, way * z
            y = R_x * x + R_z * z
            size = np.maximum(np.abs(x), np.maximum(np.abs(y), np.abs(z)))
            share = np.minimum(1.0, LONGEST / size)
            A[left], Omega[left] = amplitude * np.exp(share * x), at * np.exp(share * z)
            R[left], step[left] = there.R + F_0 * share * y, size
            left = left[size > _done(at, amplitude, F_0)]
            if not left.size:
                break
        Omega = _at_R(balance, Omega, A, R, F_0, balance.averages(A))
        near = (np.abs(np.log(A / A_1)) < SMALL) & (np.abs(np.log(Omega / Omega_1)) < SMALL)
        kept = near & (step <= _done(Omega, A, F_0)) & balance.is_small(Omega, A)
    return Omega, A, kept


def _done(Omega: Floats, A: Floats, F_0: float) -> Floats:
    """The step that ends Newton's iteration: on a peak as sharp as a needle R/F_0 is known to no more."""
    return np.asarray(MOVED + ROUNDING * A * Omega**2 / F_0)


def on_curve(balance: Balance, Omega: Any, A: Any, F_0: float, averages: tuple[Floats, ...]) -> tuple[Floats, Floats]:
    """The frequency near the one given at which A is a steady state, and the last step to its logarithm."""
    step = np.full_like(Omega, np.inf)
    for _ in range(STEPS):
        there = balance.response(Omega, A, F_0, averages)
        step = np.clip(there.F / (there.F_Omega * Omega), -LONGEST, LONGEST)
        Omega = Omega * np.exp(-step)
        if not (np.abs(step) > DONE).any():
            break
    return Omega, step


def _at_R(balance: Balance, Omega_0: Floats, A: Floats, R: Floats, F_0: float, averages: tuple[Floats, ...]) -> Floats:
    """The frequency at which the cosine balance is R, the one given where R hardly depends on it."""
    Omega = Omega_0
    for _ in range(MATCHING):
        there = balance.response(Omega, A, F_0, averages)
        R_z, z = there.R_Omega * Omega / F_0, np.log(Omega / Omega_0)
        step = (R_z * (R - there.R) / F_0 - WEIGHT**2 * z) / (R_z**2 + WEIGHT**2)
        step = np.clip(step, -LONGEST, LONGEST)
        Omega = Omega * np.exp(step)
        if not (np.abs(step) > DONE).any():
            break
    return Omega


def _parts(first: FrequencyResponse, kept: Flags) -> tuple[npt.NDArray[np.intp], tuple[bool, ...]]:
    """What is left of each branch: number of its part for each point that is kept, and whether the part is closed."""
    left = np.flatnonzero(kept)
    begins = np.append(True, (np.diff(first.branch[left]) != 0) | (np.diff(left) > 1))[: left.size]
    whole = [first.isola[k] and bool(kept[first.branch == k].all()) for k in first.branch[left[begins]]]
    return np.cumsum(begins) - 1, tuple(whole)


def _order(Omega: Floats, stable: Flags, branch: npt.NDArray[np.intp]) -> npt.NDArray[np.intp]:
    """The points in order where some have overtaken others: only at a fold, where stability changes, Omega turns."""
    begins = np.append(True, (np.diff(branch) != 0) | (stable[1:] != stable[:-1]))[: Omega.size]
    stretch = np.cumsum(begins) - 1
    low = np.flatnonzero(begins)
    high = np.append(low[1:], Omega.size)[: low.size] - 1
    rising = np.where(Omega[high] >= Omega[low], 1.0, -1.0)
    return np.lexsort((rising[stretch] * Omega, stretch))
