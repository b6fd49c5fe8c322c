"""The second approximation: in goes an averaged oscillator, out come its answers with what the higher harmonics change.

The first approximation is complete and certain; the second starts from it and follows its points by Newton's iteration
on the generated balance of `slowflow_kernels.second_approximation`. It holds where the change is small. What does not
survive is left out, and `message` says so.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from scipy.optimize import brentq, root

from slowflow import validate
from slowflow.averaged import remarks
from slowflow.measured import validity
from slowflow.model import Floats
from slowflow.results import Detachment, Remark, SaddleNodeOnset, SecondFolds, SecondResponse, SecondStates, joined
from slowflow.second.balance import SMALL, Balance, Flags
from slowflow.second.curve import DONE, STEPS, Curve, follow, on_curve

if TYPE_CHECKING:
    from slowflow.averaged.questions import Averaged

#: distance in logarithms up to which two answers are one
SAME = 1e-7
#: size of F_A where it has vanished, over that between two points of the curve
VANISHED = 1e-3
#: points of the curve on which folds and states at one frequency are looked for, and how far it reaches beyond
SAMPLES, BEYOND = 600, 1.3

FEWER = "fewer states than in the first approximation at {} of {} frequencies"
UNSOLVED = "left out: {} of {} folds, next to which the curve is lost"
NO_FOLD = "no saddle node at F_0 = {:g} in the second approximation"
NO_CUSP = "the onset of the first approximation is of kind {}: the second follows a cusp only"
FAR = "the second approximation does not come near the first: its harmonics are not small"
STATIC = "the static amplitude reaches u_cr first: there is no motion whose harmonics could be told"


@dataclass(frozen=True)
class SecondApproximation:
    """The questions of an oscillator in the second approximation; `.second_approximation` of an oscillator makes it.

    Answers have the largest displacement as A, and the amplitude of the first harmonic as A_1. Arguments and errors are
    the oscillator's. Inside, as in the kernels, A is A_1 + a_3 + a_5: friction's harmonics take a little off it.
    Raises ValueError where these harmonics are not derived.

    first -- the oscillator, averaged
    """

    first: Averaged

    def __post_init__(self) -> None:
        mechanism = self.first.model.mechanism
        for u_cr in self.first.breakpoints:
            if u_cr > mechanism.harmonics_up_to:
                raise ValueError(
                    f"u_cr = {u_cr:g} is not allowed here: the harmonics of this force are derived for "
                    f"u_cr <= {mechanism.harmonics_up_to:g}"
                )

    def frequency_response(
        self, F_0: float, *, samples: int = 1000, Omega: tuple[float, float] = validate.WINDOW
    ) -> SecondResponse:
        """The response curve, as the first approximation's points move to it."""
        first = self.first.curve(F_0, samples, Omega)
        curve = follow(self._balance, first)
        at = self._balance.response(curve.Omega, curve.A, first.F_0)
        message = self._remarked(curve.message, curve.Omega, at.u_max)
        return SecondResponse(
            curve.Omega, at.u_max, at.A_1, at.phi, curve.stable, message, curve.branch, curve.isola, first.F_0
        )

    def amplitudes(self, *, Omega: Any, F_0: float) -> SecondStates:
        """Every steady state at the frequency Omega, or at each of an array of frequencies: where the curve crosses."""
        first = self.first.states(Omega=Omega, F_0=F_0)
        wanted = np.asarray(Omega, dtype=float).ravel()
        if not wanted.size or not first.A.size:
            none = np.empty(0)
            return SecondStates(none, none, none, none, np.empty(0, dtype=bool), first.message)
        curve = self._around(F_0, wanted)
        F_0 = float(F_0)
        number, low, A, high = _crossings(curve, wanted)
        A, solved = self._states(wanted[number], low, A, high, F_0)
        number, A = number[solved], A[solved]
        # a curve that turns beside a corner may cross a frequency to and fro within rounding
        other = np.append(True, (np.diff(number) != 0) | (np.abs(np.diff(A)) > SAME * A[1:]))[: A.size]
        at, A = wanted[number[other]], A[other]
        there = self._balance.response(at, A, F_0)
        fewer = int(np.count_nonzero(_counts(wanted, at) < _counts(wanted, first.Omega)))
        message = joined(first.message, FEWER.format(fewer, wanted.size) if fewer else "")
        message = self._remarked(message, at, there.u_max)
        return SecondStates(at, there.u_max, there.A_1, there.phi, there.F_A > 0, message)

    def saddle_nodes(self, F_0: float) -> SecondFolds:
        """Every fold of the response curve, by rising Omega."""
        first = self.first.folds(F_0)
        peak = self.first.peak(F_0)
        marks = [*first.Omega.tolist(), *([peak.Omega] if peak.Omega else [])]
        found: list[tuple[float, float, bool, bool]] = []
        message = first.message
        if marks:
            curve = self._around(F_0, np.array(marks))
            turns = np.flatnonzero((curve.stable[1:] != curve.stable[:-1]) & (np.diff(curve.branch) == 0))
            solved = [self._fold(curve, int(k), first.F_0) for k in turns]
            found = sorted(fold for fold in solved if fold is not None)
            # where points crowd the curve may turn to and fro within rounding
            found = [fold for k, fold in enumerate(found) if k == 0 or not np.allclose(fold, found[k - 1], SAME, 0)]
            lost = sum(fold is None for fold in solved)
            none = "" if found else NO_FOLD.format(first.F_0)
            message = joined(none, curve.message, UNSOLVED.format(lost, len(solved)) if lost else "")
        at, A, corner, below = np.array(found).reshape(-1, 4).T
        u_max, A_1, *_ = self._balance.response(at, A, first.F_0)
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
            F, F_A, F_AA = self._balance.folds(Omega, A, F_0)
            return np.asarray([F / F_0**2, A * F_A / F_0**2, A * A * F_AA / F_0**2])

        found = self._solved(balance, np.log([first.Omega, first.A, first.F_SN]))
        if found is None:
            return SaddleNodeOnset(None, None, None, "", FAR)
        Omega, A, F_SN = np.exp(found).tolist()
        u_max = float(self._balance.response(Omega, A, F_SN).u_max)
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
                share = u_cr / float(self._balance.detachment(Omega, A)[2])
                A *= share
                if abs(share - 1) <= DONE:
                    break
            return A

        def turning(Omega: float) -> float:
            return float(self._balance.detachment(Omega, reaching(Omega))[3])

        # no iteration over A and Omega at once: next to u_cr, above which the harmonics change, it gets stuck
        with np.errstate(all="ignore"):
            for width in SMALL * 0.5 ** np.arange(10, -1, -1):
                low, high = first.Omega_cr * math.exp(-width), first.Omega_cr * math.exp(width)
                if turning(low) < 0 < turning(high):
                    Omega = float(brentq(turning, low, high, rtol=1e-14))
                    A = reaching(Omega)
                    R, I, *_ = self._balance.detachment(Omega, A)
                    F_cr = float(np.hypot(R, I))
                    # without damping it is nought to rounding
                    near = abs(A / u_cr - 1) < SMALL and abs(F_cr - first.F_cr) < SMALL * first.F_cr + DONE * u_cr
                    if near and bool(self._balance.is_small(Omega, A)):
                        return Detachment(F_cr, Omega, u_cr, first.message)
        return Detachment(None, None, u_cr, FAR)

    def _remarked(self, message: str, Omega: Floats, A: Floats) -> str:
        """The message with what there is to say of amplitudes beyond the reach, and of motions that stop."""
        model = self.first.model
        beside = remarks.of_one(model, math.nan, Omega, A) & ~Remark.OF_TRUNCATION
        return joined(message, *remarks.in_words(beside, model, math.nan), validity.of_second(model, Omega, A))

    def _around(self, F_0: float, Omega: Floats) -> Curve:
        """The curve that holds some frequencies and what may lie beside them."""
        shown = (float(Omega.min()) / BEYOND, float(Omega.max()) * BEYOND)
        return follow(self._balance, self.first.curve(F_0, SAMPLES, shown))

    @cached_property
    def _balance(self) -> Balance:
        return Balance(self.first.model)

    def _states(self, Omega: Floats, low: Floats, A: Floats, high: Floats, F_0: float) -> tuple[Floats, Flags]:
        """The state at each frequency between two amplitudes, from one in between; and where it was found."""
        with np.errstate(all="ignore"):
            F_low, F_high = (self._balance.response(Omega, end, F_0).F for end in (low, high))
            between = (F_low > 0) != (F_high > 0)
            step = np.full_like(A, np.inf)
            for _ in range(STEPS):
                there = self._balance.response(Omega, A, F_0)
                above = (there.F > 0) == (F_high > 0)
                low, high = np.where(between & ~above, A, low), np.where(between & above, A, high)
                step = there.F / there.F_A
                outside = between & ((A - step < low) | (A - step > high)) & (np.abs(step) > DONE * A)
                A = np.where(outside, np.sqrt(low * high), np.clip(A - step, low, high))
            return A, np.abs(step) <= DONE * A

    def _fold(self, curve: Curve, k: int, F_0: float) -> tuple[float, float, bool, bool] | None:
        """Where F_A changes its sign between points k and k + 1: Omega, A; whether on a corner, and stable below."""
        rising = [k, k + 1] if curve.A[k + 1] > curve.A[k] else [k + 1, k]
        frequencies, amplitudes = curve.Omega[rising], curve.A[rising]

        def frequency(A: float) -> float:
            return float(on_curve(self._balance, np.interp(A, amplitudes, frequencies), A, F_0)[0])

        def slope(A: float) -> float:
            return float(self._balance.response(frequency(A), A, F_0).F_A)

        ends = amplitudes.tolist()
        slopes = [slope(A) for A in ends]
        if (slopes[0] > 0) == (slopes[1] > 0):
            return None
        A = float(brentq(slope, *ends, xtol=4 * np.finfo(float).tiny, rtol=4 * np.finfo(float).eps))
        corners = [b for b in self.first.breakpoints if abs(A - b) <= 8 * np.spacing(b)]
        # next to a tip `frequency` may slip to its other side, and the slope with it
        if not corners and abs(slope(A)) > VANISHED * max(map(abs, slopes)):
            return None
        return frequency(A), corners[0] if corners else A, bool(corners), slopes[0] > 0

    def _solved(self, balance: Callable[[Floats], Floats], start: Floats) -> Floats | None:
        """The zero near a start, in logarithms of Omega, A and what follows; None where it is no correction."""
        with np.errstate(all="ignore"):
            found = root(balance, start, method="hybr", options={"xtol": 1e-13})
            x = np.asarray(found.x)
            near = bool(np.all(np.abs(x - start) <= SMALL)) and float(np.abs(found.fun).max()) < 1e-9
            return x if near and bool(self._balance.is_small(*np.exp(x[:2]))) else None


def _counts(wanted: Floats, values: Floats) -> npt.NDArray[np.intp]:
    """How often each wanted value is among the values."""
    known = np.sort(values)
    return np.searchsorted(known, wanted, "right") - np.searchsorted(known, wanted, "left")


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
