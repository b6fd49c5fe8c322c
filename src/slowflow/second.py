"""The second approximation: in goes an averaged oscillator, out come its answers with what the higher harmonics change.

The first approximation is complete and certain; the second starts from it and follows its points by Newton's iteration
on the generated balance of `slowflow_kernels.second_approximation`. It holds where the change is small. What does not
survive is left out, and `message` says so.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from scipy.optimize import brentq, root

from slowflow import validity
from slowflow.isolator import WINDOW
from slowflow.model import Floats, Model
from slowflow.results import (
    Detachment,
    FrequencyResponse,
    SaddleNodeOnset,
    SecondFolds,
    SecondResponse,
    SecondStates,
    words,
)
from slowflow_kernels import second_approximation as kernels

if TYPE_CHECKING:
    from slowflow.isolator import Oscillator

Flags = npt.NDArray[np.bool_]
Balance = Callable[[Floats], Floats]

#: relative change of amplitude or frequency, and share that friction takes off A, up to which they are a correction
SMALL = 0.2
#: the same for the share of the spring's harmonics in A; from 1/8 on the mass might not turn where they add up
HARMONICS = 0.1
#: Newton steps along the gradient, the longest one in ln A, R/F_0 and ln Omega, and the one that ends them
STEPS, LONGEST, DONE = 25, 0.1, 1e-11
#: rounding of R over A Omega^2
ROUNDING = 8 * float(np.finfo(float).eps)
#: weight of ln Omega in the distance beside ln A and R/F_0
WEIGHT = 2.0
#: Newton steps to the frequency of a given R
MATCHING = 5
#: distance in logarithms up to which two answers are one
SAME = 1e-7
#: size of F_A where it has vanished, over that between two points of the curve
VANISHED = 1e-3
#: points of the curve on which folds and states at one frequency are looked for, and how far it reaches beyond
SAMPLES, BEYOND = 600, 1.3

#: amplitudes over that of a breakpoint at which the force jumps, and whose fold has another close above
BESIDE = np.concatenate(([1 - 1e-6, 1.0], 1 + np.logspace(-13, -2, 34)))

LOST = (
    "left out: {} of {} points of the first approximation, at Omega from {:.3g} to {:.3g}; its harmonics are not small"
)
FEWER = "fewer states than in the first approximation at {} of {} frequencies"
UNSOLVED = "left out: {} of {} folds, next to which the curve is lost"
NO_FOLD = "no saddle node at F_0 = {:g} in the second approximation"
NO_CUSP = "the onset of the first approximation is of kind {}: the second follows a cusp only"
FAR = "the second approximation does not come near the first: its harmonics are not small"
STATIC = "the static amplitude reaches u_cr first: there is no motion whose harmonics could be told"


@dataclass(frozen=True)
class _Curve:
    """A response curve: Omega, A of the kernels, stability; number of the branch, whether each is closed; remarks."""

    Omega: Floats
    A: Floats
    stable: Flags
    branch: npt.NDArray[np.intp]
    isola: tuple[bool, ...]
    message: str


@dataclass(frozen=True)
class SecondApproximation:
    """The questions of an oscillator in the second approximation; `.second_approximation` of an oscillator makes it.

    Answers have the largest displacement as A, and the amplitude of the first harmonic as A_1. Arguments and errors are
    the oscillator's. Inside, as in the kernels, A is A_1 + a_3 + a_5: friction's harmonics take a little off it.

    first -- the oscillator, averaged
    model -- its slow flow
    """

    first: Oscillator
    model: Model = field(repr=False)

    def frequency_response(
        self, F_0: float, samples: int = 1000, Omega: tuple[float, float] = WINDOW
    ) -> SecondResponse:
        """The response curve, as the first approximation's points move to it."""
        curve, first = self._curve(F_0, samples, Omega)
        u_max, A_1, phi, *_ = self._response(curve.Omega, curve.A, first.F_0)
        message = self._remarked(curve.message, curve.Omega, u_max)
        return SecondResponse(curve.Omega, u_max, A_1, phi, curve.stable, message, curve.branch, curve.isola, first.F_0)

    def amplitudes(self, Omega: Any, F_0: float) -> SecondStates:
        """Every steady state at the frequency Omega, or at each of an array of frequencies: where the curve crosses."""
        first = self.first._states(Omega, F_0)
        wanted = np.asarray(Omega, dtype=float).ravel()
        if not wanted.size or not first.A.size:
            none = np.empty(0)
            return SecondStates(none, none, none, none, np.empty(0, dtype=bool), first.message)
        curve, _ = self._curve(F_0, SAMPLES, (wanted.min() / BEYOND, wanted.max() * BEYOND))
        F_0 = float(F_0)
        number, low, A, high = _crossings(curve, wanted)
        A, solved = self._states(wanted[number], low, A, high, F_0)
        number, A = number[solved], A[solved]
        # a curve that turns beside a corner may cross a frequency to and fro within rounding
        other = np.append(True, (np.diff(number) != 0) | (np.abs(np.diff(A)) > SAME * A[1:]))[: A.size]
        at, A = wanted[number[other]], A[other]
        u_max, A_1, phi, _, _, F_A, *_ = self._response(at, A, F_0)
        fewer = int(np.count_nonzero(_counts(wanted, at) < _counts(wanted, first.Omega)))
        message = words(first.message, FEWER.format(fewer, wanted.size) if fewer else "")
        message = self._remarked(message, at, u_max)
        return SecondStates(at, u_max, A_1, phi, F_A > 0, message)

    def saddle_nodes(self, F_0: float) -> SecondFolds:
        """Every fold of the response curve, by rising Omega."""
        first = self.first._folds(F_0)
        peak = self.first.peak(F_0)
        marks = [*first.Omega.tolist(), *([peak.Omega] if peak.Omega else [])]
        found: list[tuple[float, float, bool, bool]] = []
        message = first.message
        if marks:
            curve, _ = self._curve(F_0, SAMPLES, (min(marks) / BEYOND, max(marks) * BEYOND))
            turns = np.flatnonzero((curve.stable[1:] != curve.stable[:-1]) & (np.diff(curve.branch) == 0))
            solved = [self._fold(curve, int(k), first.F_0) for k in turns]
            found = sorted(fold for fold in solved if fold is not None)
            # where points crowd the curve may turn to and fro within rounding
            found = [fold for k, fold in enumerate(found) if k == 0 or not np.allclose(fold, found[k - 1], SAME, 0)]
            lost = sum(fold is None for fold in solved)
            none = "" if found else NO_FOLD.format(first.F_0)
            message = words(none, curve.message, UNSOLVED.format(lost, len(solved)) if lost else "")
        at, A, corner, below = np.array(found).reshape(-1, 4).T
        u_max, A_1, *_ = self._response(at, A, first.F_0)
        # what a sweep leaves for a larger amplitude has its stable side below
        kind = np.where(below != 0, "jump-up", "jump-down")
        message = self._remarked(message, at, u_max)
        return SecondFolds(at, u_max, A_1, kind, corner != 0, first.F_0, message)

    def saddle_node_onset(self) -> SaddleNodeOnset:
        """The lowest forcing that has a fold, where that is a cusp."""
        first = self.first.saddle_node_onset()
        if first.F_SN is None or first.Omega is None or first.A is None:
            return first
        if first.kind != "cusp":
            return SaddleNodeOnset(None, None, None, "", NO_CUSP.format(first.kind))

        def balance(x: Floats) -> Floats:
            Omega, A, F_0 = np.exp(x).tolist()
            F, F_A, F_AA = self._folds(Omega, A, F_0)
            return np.asarray([F / F_0**2, A * F_A / F_0**2, A * A * F_AA / F_0**2])

        found = self._solved(balance, np.log([first.Omega, first.A, first.F_SN]))
        if found is None:
            return SaddleNodeOnset(None, None, None, "", FAR)
        Omega, A, F_SN = np.exp(found).tolist()
        u_max = float(self._response(Omega, A, F_SN)[0])
        return SaddleNodeOnset(F_SN, Omega, u_max, first.kind, first.message)

    def detachment(self) -> Detachment:
        """The lowest forcing whose largest displacement is u_cr."""
        first = self.first.detachment()
        if first.F_cr is None or first.Omega_cr is None or first.u_cr is None:
            return first
        if first.Omega_cr == 0:
            return Detachment(None, None, first.u_cr, STATIC)
        u_cr = first.u_cr

        def reaching(Omega: float) -> float:
            """A whose largest displacement is u_cr: above that by what friction's harmonics take off."""
            A = u_cr
            for _ in range(STEPS):
                share = u_cr / float(self._detachment(Omega, A)[2])
                A *= share
                if abs(share - 1) <= DONE:
                    break
            return A

        def turning(Omega: float) -> float:
            return float(self._detachment(Omega, reaching(Omega))[3])

        # no iteration over A and Omega at once: next to u_cr, above which the harmonics change, it gets stuck
        with np.errstate(all="ignore"):
            for width in SMALL * 0.5 ** np.arange(10, -1, -1):
                low, high = first.Omega_cr * math.exp(-width), first.Omega_cr * math.exp(width)
                if turning(low) < 0 < turning(high):
                    Omega = float(brentq(turning, low, high, rtol=1e-14))
                    A = reaching(Omega)
                    R, I, *_ = self._detachment(Omega, A)
                    F_cr = float(np.hypot(R, I))
                    # without damping it is nought to rounding
                    near = abs(A / u_cr - 1) < SMALL and abs(F_cr - first.F_cr) < SMALL * first.F_cr + DONE * u_cr
                    if near and bool(self._small(Omega, A)):
                        return Detachment(F_cr, Omega, u_cr, first.message)
        return Detachment(None, None, u_cr, FAR)

    def _remarked(self, message: str, Omega: Floats, A: Floats) -> str:
        """The message with what there is to say of amplitudes beyond the reach, and of motions that stop."""
        return words(message, self.first._beyond_reach(A, message), validity.of_second(self.model.mu, Omega, A))

    def _curve(self, F_0: float, samples: int, Omega: tuple[float, float]) -> tuple[_Curve, FrequencyResponse]:
        """The response curve in the A of the kernels, and the first approximation's."""
        first = self.first._curve(F_0, samples, Omega)
        at, A, kept = self._moved(first.Omega, first.A, first.F_0)
        at, A, lost = at[kept], A[kept], first.Omega[~kept]
        branch, isola = _parts(first, kept)
        for b, jump in zip(self.model.breakpoints, self.model.jumps, strict=True):
            if jump != 0:
                at, A, branch = self._across(b, at, A, branch, first.F_0)
        stable = self._response(at, A, first.F_0)[5] > 0
        order = _order(at, stable, branch)
        at, A, stable = at[order], A[order], stable[order]
        remark = LOST.format(lost.size, kept.size, lost.min(), lost.max()) if lost.size else ""
        return _Curve(at, A, stable, branch, isola, words(first.message, remark)), first

    def _across(
        self, b: float, Omega: Floats, A: Floats, branch: npt.NDArray[np.intp], F_0: float
    ) -> tuple[Floats, Floats, npt.NDArray[np.intp]]:
        """The curve with more points where it passes a breakpoint at which the force jumps: folds are close there."""
        passing = np.flatnonzero(((A[1:] > b) != (A[:-1] > b)) & (branch[1:] == branch[:-1]))
        if not passing.size:
            return Omega, A, branch
        rising = A[passing + 1] > b
        amplitudes = np.where(rising[:, np.newaxis], b * BESIDE, b * BESIDE[::-1])
        share = (b - A[passing]) / (A[passing + 1] - A[passing])
        at = np.repeat((Omega[passing] + share * (Omega[passing + 1] - Omega[passing]))[:, np.newaxis], BESIDE.size, 1)
        step = np.full_like(at, np.inf)
        with np.errstate(all="ignore"):
            for _ in range(STEPS):
                _, _, _, _, F, _, F_Omega, *_ = self._response(at, amplitudes, F_0)
                step = np.clip(F / (F_Omega * at), -LONGEST, LONGEST)
                at = at * np.exp(-step)
        # inserted where the points on both sides do not lie nearer
        ends = np.sort(np.column_stack((A[passing], A[passing + 1])), axis=1)[:, :, np.newaxis]
        good = (np.abs(step) <= DONE) & (amplitudes > ends[:, 0]) & (amplitudes < ends[:, 1])
        where = np.repeat(passing[:, np.newaxis] + 1, BESIDE.size, 1)[good]
        return (
            np.insert(Omega, where, at[good]),
            np.insert(A, where, amplitudes[good]),
            np.insert(branch, where, branch[where - 1]),
        )

    def _moved(self, Omega_1: Floats, A_1: Floats, F_0: float) -> tuple[Floats, Floats, Flags]:
        """Points of the first approximation moved to the second: Omega, A, and where that is a correction.

        Each point takes the shortest way. The distance counts ln A, R/F_0, in which the curve keeps away from itself
        however sharp its peak is over Omega, and ln Omega, for where R hardly depends on that.
        """
        Omega, A = Omega_1.copy(), A_1.copy()
        R = self.model.flow.R(Omega_1, A_1, self.model.averaged(A_1)[0])
        step = np.full_like(A, np.inf)
        with np.errstate(all="ignore"):
            left = np.flatnonzero(self._off_resonance(Omega, A))
            for _ in range(STEPS):
                at, amplitude = self._at_R(Omega[left], A[left], R[left], F_0), A[left]
                _, _, _, reached, F, F_A, F_Omega, R_A, R_Omega = self._response(at, amplitude, F_0)
                # by ln A and ln Omega
                F, F_x, F_z = F / F_0**2, F_A * amplitude / F_0**2, F_Omega * at / F_0**2
                R_x, R_z = R_A * amplitude / F_0, R_Omega * at / F_0
                # the gradient in the metric dx^2 + dR^2 + (WEIGHT dz)^2
                x, z = (R_z**2 + WEIGHT**2) * F_x - R_x * R_z * F_z, (1 + R_x**2) * F_z - R_x * R_z * F_x
                way = -F / (F_x * x + F_z * z)
                x, z = way * x, way * z
                y = R_x * x + R_z * z
                size = np.maximum(np.abs(x), np.maximum(np.abs(y), np.abs(z)))
                share = np.minimum(1.0, LONGEST / size)
                A[left], Omega[left] = amplitude * np.exp(share * x), at * np.exp(share * z)
                R[left], step[left] = reached + F_0 * share * y, size
                left = left[size > self._done(at, amplitude, F_0)]
                if not left.size:
                    break
            Omega = self._at_R(Omega, A, R, F_0)
            near = (np.abs(np.log(A / A_1)) < SMALL) & (np.abs(np.log(Omega / Omega_1)) < SMALL)
            kept = near & (step <= self._done(Omega, A, F_0)) & self._small(Omega, A)
        return Omega, A, kept

    def _done(self, Omega: Floats, A: Floats, F_0: float) -> Floats:
        """The step that ends Newton's iteration: on a peak as sharp as a needle R/F_0 is known to no more."""
        return DONE + ROUNDING * A * Omega**2 / F_0

    def _at_R(self, Omega_0: Floats, A: Floats, R: Floats, F_0: float) -> Floats:
        """The frequency at which the cosine balance is R, the one given where R hardly depends on it."""
        averages = self._averages(A)
        Omega = Omega_0
        for _ in range(MATCHING):
            _, _, _, reached, _, _, _, _, R_Omega = self._response(Omega, A, F_0, averages)
            R_z, z = R_Omega * Omega / F_0, np.log(Omega / Omega_0)
            step = (R_z * (R - reached) / F_0 - WEIGHT**2 * z) / (R_z**2 + WEIGHT**2)
            step = np.clip(step, -LONGEST, LONGEST)
            Omega = Omega * np.exp(step)
            if not (np.abs(step) > DONE).any():
                break
        return Omega

    def _off_resonance(self, Omega: Any, A: Any) -> Flags:
        """Where the third harmonic is above its resonance."""
        return np.asarray(np.abs(self.model.averaged(A)[0]) < kernels.RESONANCE * A * Omega**2)

    def _small(self, Omega: Any, A: Any) -> Flags:
        """Where the harmonics are a correction: the force's, and friction's, which take u_max below A."""
        u_max, A_1, *_ = self._response(Omega, A, 1.0)
        small = (np.abs(A_1 / A - 1.0) < HARMONICS) & (np.abs(u_max / A - 1.0) < SMALL)
        return np.asarray(self._off_resonance(Omega, A) & small)

    def _states(self, Omega: Floats, low: Floats, A: Floats, high: Floats, F_0: float) -> tuple[Floats, Flags]:
        """The state at each frequency between two amplitudes, from one in between; and where it was found."""
        with np.errstate(all="ignore"):
            F_low, F_high = (self._response(Omega, end, F_0)[4] for end in (low, high))
            between = (F_low > 0) != (F_high > 0)
            step = np.full_like(A, np.inf)
            for _ in range(STEPS):
                _, _, _, _, F, F_A, *_ = self._response(Omega, A, F_0)
                above = (F > 0) == (F_high > 0)
                low, high = np.where(between & ~above, A, low), np.where(between & above, A, high)
                step = F / F_A
                outside = between & ((A - step < low) | (A - step > high)) & (np.abs(step) > DONE * A)
                A = np.where(outside, np.sqrt(low * high), np.clip(A - step, low, high))
            return A, np.abs(step) <= DONE * A

    def _fold(self, curve: _Curve, k: int, F_0: float) -> tuple[float, float, bool, bool] | None:
        """Where F_A changes its sign between points k and k + 1: Omega, A; whether on a corner, and stable below."""
        rising = [k, k + 1] if curve.A[k + 1] > curve.A[k] else [k + 1, k]
        frequencies, amplitudes = curve.Omega[rising], curve.A[rising]

        def on_curve(A: float) -> float:
            Omega = float(np.interp(A, amplitudes, frequencies))
            for _ in range(STEPS):
                _, _, _, _, F, _, F_Omega, *_ = self._response(Omega, A, F_0)
                step = float(np.clip(F / (F_Omega * Omega), -LONGEST, LONGEST))
                Omega *= math.exp(-step)
                if abs(step) <= DONE:
                    break
            return Omega

        def slope(A: float) -> float:
            return float(self._response(on_curve(A), A, F_0)[5])

        ends = amplitudes.tolist()
        slopes = [slope(A) for A in ends]
        if (slopes[0] > 0) == (slopes[1] > 0):
            return None
        A = float(brentq(slope, *ends, xtol=4 * np.finfo(float).tiny, rtol=4 * np.finfo(float).eps))
        corners = [b for b in self.model.breakpoints if abs(A - b) <= 8 * np.spacing(b)]
        # next to a tip `on_curve` may slip to its other side, and the slope with it
        if not corners and abs(slope(A)) > VANISHED * max(map(abs, slopes)):
            return None
        return on_curve(A), corners[0] if corners else A, bool(corners), slopes[0] > 0

    def _solved(self, balance: Balance, start: Floats) -> Floats | None:
        """The zero near a start, in logarithms of Omega, A and what follows; None where it is no correction."""
        with np.errstate(all="ignore"):
            found = root(balance, start, method="hybr", options={"xtol": 1e-13})
            x = np.asarray(found.x)
            near = bool(np.all(np.abs(x - start) <= SMALL)) and float(np.abs(found.fun).max()) < 1e-9
            return x if near and bool(self._small(*np.exp(x[:2]))) else None

    def _averages(self, A: Any) -> tuple[Floats, ...]:
        """h, h_3 and h_5, each with two derivatives."""
        h, h_A, h_AA, _ = self.model.averaged(A)
        h_3, h_3_A, h_3_AA, _, h_5, h_5_A, h_5_AA, _ = self.model.harmonics(A)
        return h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA

    def _response(
        self, Omega: Any, A: Any, F_0: float, averages: tuple[Floats, ...] | None = None
    ) -> tuple[Floats, ...]:
        """u_max, A_1, phi, R, F, F_A, F_Omega, R_A, R_Omega; `averages` of A if they are known."""
        known = self._averages(A) if averages is None else averages
        values: tuple[Floats, ...] = kernels.response(Omega, A, F_0, self.model.m, self.model.zeta, *known)
        return values

    def _detachment(self, Omega: Any, A: Any) -> tuple[Floats, ...]:
        """R, I, u_max, turning"""
        values: tuple[Floats, ...] = kernels.detachment(Omega, A, self.model.m, self.model.zeta, *self._averages(A))
        return values

    def _folds(self, Omega: Any, A: Any, F_0: Any) -> tuple[Floats, ...]:
        """F, F_A, F_AA"""
        m, zeta = self.model.m, self.model.zeta
        values: tuple[Floats, ...] = kernels.folds(
            Omega, A, F_0, m, zeta, *self.model.averaged(A), *self.model.harmonics(A)
        )
        return values


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


def _counts(wanted: Floats, values: Floats) -> npt.NDArray[np.intp]:
    """How often each wanted value is among the values."""
    known = np.sort(values)
    return np.searchsorted(known, wanted, "right") - np.searchsorted(known, wanted, "left")


def _crossings(curve: _Curve, Omega: Floats) -> tuple[npt.NDArray[np.intp], Floats, Floats, Floats]:
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
