"""Answers of the second approximation on NumPy: in go its balance and a curve, or averaging's answer, out come numbers.

The same functions as in `compiled`; `solvers` chooses. None where the answer is no correction of averaging's.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import numpy.typing as npt
from scipy.optimize import brentq, root

from slowflow.model import Floats
from slowflow.second.balance import Balance, Flags
from slowflow.second.curve import along, on_curve
from slowflow.second.found import Curve, Fold, Folds, State, told_of_folds
from slowflow_kernels.second_conventions import DONE, LONGEST, ROUNDING, SETTLED, SMALL, STEPS, VANISHED

__all__ = ["along", "cusp", "detachment", "folds", "peak", "saddle_nodes", "states"]


def saddle_nodes(balance: Balance, F_0: float) -> Folds | None:
    """None: here averaging's folds and peak, the curve about them and its folds are asked for one by one."""
    return None


def folds(balance: Balance, curve: Curve, F_0: float) -> Folds:
    """Every fold between points of the curve."""
    turns = np.flatnonzero((curve.stable[1:] != curve.stable[:-1]) & (np.diff(curve.branch) == 0))
    solved = [_fold(balance, curve, int(k), F_0) for k in turns]
    found = sorted(fold for fold in solved if fold is not None)
    # where points crowd the curve may turn to and fro within rounding
    found = [fold for k, fold in enumerate(found) if k == 0 or not np.allclose(fold, found[k - 1], SETTLED, 0)]
    at = [balance.response(Omega, A, F_0) for Omega, A, _, _ in found]
    told = [
        Fold(Omega, float(there.u_max), float(there.A_1), up, corner)
        for (Omega, _, corner, up), there in zip(found, at, strict=True)
    ]
    lost = sum(fold is None for fold in solved)
    return told_of_folds(told, lost, len(solved), curve.message, F_0)


def _fold(balance: Balance, curve: Curve, k: int, F_0: float) -> tuple[float, float, bool, bool] | None:
    """Where F_A changes its sign between points k and k + 1: Omega, A; whether on a corner, and stable below."""
    rising = [k, k + 1] if curve.A[k + 1] > curve.A[k] else [k + 1, k]
    frequencies, amplitudes = curve.Omega[rising], curve.A[rising]

    def at(A: float) -> tuple[float, float]:
        """Omega and F_A of the state at an amplitude."""
        averages = balance.averages(A)
        Omega = float(on_curve(balance, np.interp(A, amplitudes, frequencies), A, F_0, averages)[0])
        return Omega, float(balance.response(Omega, A, F_0, averages).F_A)

    def slope(A: float) -> float:
        return at(A)[1]

    ends = amplitudes.tolist()
    slopes = [slope(A) for A in ends]
    if (slopes[0] > 0) == (slopes[1] > 0):
        return None
    A = float(brentq(slope, *ends, xtol=4 * np.finfo(float).tiny, rtol=4 * np.finfo(float).eps))
    corners = [b for b in balance.model.breakpoints if abs(A - b) <= 8 * np.spacing(b)]
    # next to a tip the frequency may slip to its other side, and the slope with it
    Omega, left = at(A)
    if not corners and abs(left) > VANISHED * max(map(abs, slopes)):
        return None
    return Omega, corners[0] if corners else A, bool(corners), slopes[0] > 0


def states(balance: Balance, curve: Curve, Omega: Floats, F_0: float) -> list[State]:
    """Every state where the curve passes one of the frequencies, by their order, then by rising A."""
    number, low, A, high = _crossings(curve, Omega)
    A, solved = _between(balance, Omega[number], low, A, high, F_0)
    number, A = number[solved], A[solved]
    # a curve that turns beside a corner may cross a frequency to and fro within rounding
    other = np.append(True, (np.diff(number) != 0) | (np.abs(np.diff(A)) > SETTLED * A[1:]))[: A.size]
    at, A = Omega[number[other]], A[other]
    there = balance.response(at, A, F_0)
    columns = (at, there.u_max, there.A_1, there.phi, there.F_A > 0)
    return [State(*row) for row in zip(*(column.tolist() for column in columns), strict=True)]


def _crossings(curve: Curve, Omega: Floats) -> tuple[npt.NDArray[np.intp], Floats, Floats, Floats]:
    """Where a curve passes frequencies: number of the frequency; A below, there and above, by rising A for each."""
    found = []
    x = np.log(curve.A)
    for k, frequency in enumerate(Omega):
        beyond = curve.Omega > frequency
        row = np.flatnonzero((beyond[1:] != beyond[:-1]) & (np.diff(curve.branch) == 0))
        share = (frequency - curve.Omega[row]) / (curve.Omega[row + 1] - curve.Omega[row])
        between = x[row] + share * (x[row + 1] - x[row])
        order = between.argsort()
        ends = np.sort(np.column_stack((x[row], between, x[row + 1])), axis=1)[order]
        found.append(np.column_stack((np.full(row.size, float(k)), np.exp(ends))))
    number, low, A, high = np.concatenate(found).T
    return number.astype(np.intp), low, A, high


def _between(balance: Balance, Omega: Floats, low: Floats, A: Floats, high: Floats, F_0: float) -> tuple[Floats, Flags]:
    """The state at each frequency between two amplitudes, from one in between; and where it was found."""
    with np.errstate(all="ignore"):
        F_low, F_high = (balance.response(Omega, end, F_0).F for end in (low, high))
        between = (F_low > 0) != (F_high > 0)
        step = np.full_like(A, np.inf)
        for _ in range(STEPS):
            there = balance.response(Omega, A, F_0)
            above = (there.F > 0) == (F_high > 0)
            low, high = np.where(between & ~above, A, low), np.where(between & above, A, high)
            step = there.F / there.F_A
            outside = between & ((A - step < low) | (A - step > high)) & (np.abs(step) > DONE * A)
            A = np.where(outside, np.sqrt(low * high), np.clip(A - step, low, high))
        return A, np.abs(step) <= DONE * A


def peak(balance: Balance, curve: Curve, F_0: float) -> tuple[float, float] | None:
    """The highest point between points of the curve, u_max and its Omega."""
    inside = np.flatnonzero(curve.branch[2:] == curve.branch[:-2]) + 1
    if not inside.size:
        return None
    top = inside[curve.u_max[inside].argmax()]
    low, high = sorted((top - 1, top + 1), key=lambda k: float(curve.Omega[k]))
    if curve.u_max[top] < max(curve.u_max[low], curve.u_max[high]):
        return None

    def amplitude(Omega: float) -> float:
        A, step = float(curve.A[top]), math.inf
        for _ in range(STEPS):
            there = balance.response(Omega, A, F_0)
            step = float(np.clip(there.F / (there.F_A * A), -LONGEST, LONGEST))
            A *= math.exp(-step)
            if abs(step) <= DONE:
                return A
        return math.nan

    def turning(Omega: float) -> float:
        return float(balance.detachment(Omega, amplitude(Omega))[2])

    ends = float(curve.Omega[low]), float(curve.Omega[high])
    with np.errstate(all="ignore"):
        signs = [turning(end) for end in ends]
        if not signs[0] * signs[1] < 0:
            return None
        Omega = float(brentq(turning, *ends, rtol=1e-14))
        return float(balance.response(Omega, amplitude(Omega), F_0).u_max), Omega


def cusp(balance: Balance, F_SN: float, Omega: float, A: float) -> tuple[float, float, float] | None:
    """The cusp that averaging's moves to: F_SN, Omega, u_max."""

    def vanishing(x: Floats) -> Floats:
        Omega, A, F_0 = np.exp(x).tolist()
        F, F_A, F_AA = balance.folds(Omega, A, F_0)
        return np.asarray([F / F_0**2, A * F_A / F_0**2, A * A * F_AA / F_0**2])

    found = _solved(balance, vanishing, np.log([Omega, A, F_SN]))
    if found is None:
        return None
    Omega, A, F_SN = np.exp(found).tolist()
    return F_SN, Omega, float(balance.response(Omega, A, F_SN).u_max)


def _solved(balance: Balance, vanishing: Callable[[Floats], Floats], start: Floats) -> Floats | None:
    """The zero near a start, in logarithms of Omega, A and what follows; None where it is no correction."""
    with np.errstate(all="ignore"):
        found = root(vanishing, start, method="hybr", options={"xtol": 1e-13})
        x = np.asarray(found.x)
        near = bool(np.all(np.abs(x - start) <= SMALL)) and float(np.abs(found.fun).max()) < 1e-9
        return x if near and bool(balance.is_small(*np.exp(x[:2]))) else None


def detachment(balance: Balance, F_cr: float, Omega_cr: float, u_cr: float) -> tuple[float, float] | None:
    """The lowest forcing whose largest displacement is u_cr, and its frequency, beside averaging's."""

    def reaching(Omega: float) -> float:
        """A whose largest displacement is u_cr: above that by what friction's harmonics take off."""
        A = u_cr
        for _ in range(STEPS):
            share = u_cr / float(balance.detachment(Omega, A)[1])
            if abs(share - 1) <= ROUNDING:
                break
            A *= share
        return A

    def turning(Omega: float) -> float:
        return float(balance.detachment(Omega, reaching(Omega))[2])

    # no iteration over A and Omega at once: next to u_cr, above which the harmonics change, it gets stuck
    with np.errstate(all="ignore"):
        for width in SMALL * 0.5 ** np.arange(10, -1, -1):
            low, high = Omega_cr * math.exp(-width), Omega_cr * math.exp(width)
            if turning(low) < 0 < turning(high):
                Omega = float(brentq(turning, low, high, rtol=1e-14))
                A = reaching(Omega)
                forcing = float(balance.detachment(Omega, A)[0])
                # without damping it is nought to rounding
                near = abs(A / u_cr - 1) < SMALL and abs(forcing - F_cr) < SMALL * F_cr + DONE * u_cr
                if near and bool(balance.is_small(Omega, A)):
                    return forcing, Omega
    return None
