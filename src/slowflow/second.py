"""The second approximation: in goes an averaged oscillator, out come its answers with what the higher harmonics change.

The first approximation is complete and certain; the second starts from it and follows its points by Newton's iteration
on the generated balance of `slowflow_kernels.second_approximation`. It holds where the change is small. What does not
survive is left out, and `message` says so.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt
from scipy.optimize import root

from slowflow.isolator import WINDOW
from slowflow.model import Floats, Model
from slowflow.results import Detachment, SaddleNodeOnset, SecondFolds, SecondResponse, SecondStates, words
from slowflow_kernels import second_approximation as kernels

if TYPE_CHECKING:
    from slowflow.isolator import Oscillator

Flags = npt.NDArray[np.bool_]
Balance = Callable[[Floats], Floats]

#: relative change of amplitude, frequency or displacement up to which it is a correction
SMALL = 0.2
#: Newton steps along the gradient, the longest one in ln A, R/F_0 and ln Omega, and the one that ends them
STEPS, LONGEST, DONE = 25, 0.1, 1e-11
#: distance in logarithms up to which two answers are one
SAME = 1e-7
#: points of the curve on which folds and states at one frequency are looked for, and how far it reaches beyond
SAMPLES, BEYOND = 600, 1.3

LOST = (
    "left out: {} of {} points of the first approximation, Omega from {:.3g} to {:.3g}; their harmonics are not small"
)
FEWER = "fewer states than in the first approximation at {} of {} frequencies"
UNSOLVED = "left out: {} of {} folds, for which Newton's iteration does not settle"
NO_FOLD = "no saddle node at F_0 = {:g} in the second approximation"
NO_CUSP = "the onset of the first approximation is of kind {}: the second follows a cusp only"
FAR = "the second approximation does not come near the first: its higher harmonics are no small correction"
STATIC = "the static amplitude reaches u_cr first: there is no motion whose harmonics could be told"


@dataclass(frozen=True)
class SecondApproximation:
    """The questions of an oscillator in the second approximation; `.second_approximation` of an oscillator makes it.

    A is the amplitude of the first harmonic, u_max the largest displacement. Arguments and errors are the oscillator's.

    first     -- the oscillator, averaged
    model     -- its slow flow
    harmonics -- h_3, h_5 and their derivatives at amplitudes A, as `slowflow_kernels.*.harmonics` returns them
    """

    first: Oscillator
    model: Model
    harmonics: Callable[[Any], tuple[Floats, ...]]

    def frequency_response(
        self, F_0: float, samples: int = 1000, Omega: tuple[float, float] = WINDOW
    ) -> SecondResponse:
        """The response curve, as the first approximation's points move to it."""
        first = self.first.frequency_response(F_0, samples, Omega)
        at, A, kept = self._moved(first.Omega, first.A, first.F_0)
        at, A, lost = at[kept], A[kept], first.Omega[~kept]
        u_max, phi, *_, F_A, _, _, _ = self._response(at, A, first.F_0)
        remark = LOST.format(lost.size, kept.size, lost.min(), lost.max()) if lost.size else ""
        message = words(first.message, remark)
        return SecondResponse(at, A, u_max, phi, F_A > 0, message, first.branch[kept], first.isola, first.F_0)

    def amplitudes(self, Omega: Any, F_0: float) -> SecondStates:
        """Every steady state at the frequency Omega, or at each of an array of frequencies: where the curve crosses."""
        first = self.first.amplitudes(Omega, F_0)
        wanted = np.asarray(Omega, dtype=float).ravel()
        if not wanted.size or not first.A.size:
            none = np.empty(0)
            return SecondStates(none, none, none, none, np.empty(0, dtype=bool), first.message)
        curve = self.frequency_response(F_0, SAMPLES, (wanted.min() / BEYOND, wanted.max() * BEYOND))
        number, low, A, high = _crossings(curve, wanted)
        at = wanted[number]
        step = np.full_like(A, np.inf)
        for _ in range(STEPS):
            *_, F, F_A, _, _, _ = self._response(at, A, curve.F_0)
            step = F / F_A
            A = np.clip(A - step, low, high)
        # where points crowd beside a breakpoint the curve may cross a frequency to and fro
        kept = (np.abs(step) <= DONE * A) & np.append(True, (np.diff(number) != 0) | (np.diff(A) > SAME * A[1:]))[
            : A.size
        ]
        at, A, number = at[kept], A[kept], number[kept]
        u_max, phi, *_, F_A, _, _, _ = self._response(at, A, curve.F_0)
        expected = np.count_nonzero(first.Omega == wanted[:, np.newaxis], axis=1)
        fewer = int(np.count_nonzero(np.bincount(number, minlength=wanted.size) < expected))
        message = words(first.message, FEWER.format(fewer, wanted.size) if fewer else "")
        return SecondStates(at, A, u_max, phi, F_A > 0, message)

    def saddle_nodes(self, F_0: float) -> SecondFolds:
        """Every fold of the response curve, by rising Omega, but for those on a corner of the force."""
        first = self.first.saddle_nodes(F_0)
        peak = self.first.peak(F_0)
        marks = [*first.Omega.tolist(), *([peak.Omega] if peak.Omega else [])]
        found: list[Floats] = []
        message = first.message
        lost = 0
        if marks:
            curve = self.frequency_response(F_0, SAMPLES, (min(marks) / BEYOND, max(marks) * BEYOND))
            starts = self._turns(curve)
            for Omega, A, reach in starts:
                solution = self._solved(self._fold_at(curve.F_0), np.log([Omega, A]), reach)
                if solution is None:
                    lost += 1
                elif not any(np.abs(solution - other).max() < SAME for other in found):
                    found.append(solution)
            message = words(curve.message, UNSOLVED.format(lost, len(starts)) if lost else "")
            message = message or ("" if found else NO_FOLD.format(curve.F_0))
        points = np.exp(np.array(found).reshape(-1, 2))
        at, amplitude = points[points[:, 0].argsort()].T
        u_max = self._response(at, amplitude, first.F_0)[0]
        F_AA = self._folds(at, amplitude, first.F_0)[2]
        return SecondFolds(at, amplitude, u_max, np.where(F_AA < 0, "jump-up", "jump-down"), first.F_0, message)

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
        return SaddleNodeOnset(F_SN, Omega, A, first.kind, first.message)

    def detachment(self) -> Detachment:
        """The lowest forcing whose largest displacement is u_cr."""
        first = self.first.detachment()
        if first.F_cr is None or first.Omega_cr is None or first.u_cr is None:
            return first
        if first.Omega_cr == 0:
            return Detachment(None, None, first.u_cr, STATIC)
        F_cr, u_cr = first.F_cr, first.u_cr

        def balance(x: Floats) -> Floats:
            Omega, A = np.exp(x)
            _, _, u_max, turning = self._detachment(Omega, A)
            return np.array([u_max / u_cr - 1.0, turning * Omega / F_cr**2])

        # A that makes u_max u_cr, nearly: at u_cr itself the slopes of the harmonics jump
        added = float(self._detachment(first.Omega_cr, u_cr)[2]) - u_cr
        found = self._solved(balance, np.log([first.Omega_cr, u_cr - added]))
        if found is None:
            return Detachment(None, None, u_cr, FAR)
        Omega, A = np.exp(found)
        R, I, *_ = self._detachment(Omega, A)
        return Detachment(float(np.hypot(R, I)), float(Omega), u_cr, first.message)

    def _moved(self, Omega_1: Floats, A_1: Floats, F_0: float) -> tuple[Floats, Floats, Flags]:
        """Points of the first approximation moved to the second: Omega, A, and where that is a correction.

        In the plane of R/F_0 and ln A the curve keeps its distance from itself, however sharp its peak is over Omega:
        there each point takes the shortest way, from where R is what it was.
        """
        Omega, A = Omega_1.copy(), A_1.copy()
        R_1 = self.model.flow.R(Omega_1, A_1, self.model.averaged(A_1)[0])
        step = np.full_like(A, np.inf)
        with np.errstate(all="ignore"):
            left = np.flatnonzero(self._off_resonance(Omega, A))
            for k in range(STEPS):
                at, amplitude = Omega[left], A[left]
                *_, R, _, F, F_A, F_Omega, R_A, R_Omega = self._response(at, amplitude, F_0)
                if k < 2:
                    x, y = np.zeros_like(at), (R_1[left] - R) / F_0
                else:
                    by_y, by_x = F_Omega / (R_Omega * F_0), (F_A - F_Omega * R_A / R_Omega) * amplitude / F_0**2
                    way = -F / F_0**2 / (by_x**2 + by_y**2)
                    x, y = (np.clip(way * by, -LONGEST, LONGEST) for by in (by_x, by_y))
                z = np.clip((F_0 * y - R_A * amplitude * x) / (R_Omega * at), -LONGEST, LONGEST)
                A[left], Omega[left] = amplitude * np.exp(x), at * np.exp(z)
                step[left] = np.maximum(np.abs(x), np.abs(z))
                if k >= 2:
                    left = left[step[left] > DONE]
            near = (np.abs(np.log(A / A_1)) < SMALL) & (np.abs(np.log(Omega / Omega_1)) < SMALL)
            kept = near & (step <= DONE) & self._small(Omega, A)
        return Omega, A, kept

    def _off_resonance(self, Omega: Any, A: Any) -> Flags:
        """Where the third harmonic is above its resonance."""
        return np.asarray(np.abs(self.model.averaged(A)[0]) < kernels.RESONANCE * A * Omega**2)

    def _small(self, Omega: Any, A: Any) -> Flags:
        """Where the harmonics are a correction."""
        u_max = self._response(Omega, A, 1.0)[0]
        return np.asarray(self._off_resonance(Omega, A) & (np.abs(u_max / A - 1.0) < SMALL))

    def _turns(self, curve: SecondResponse) -> list[tuple[float, float, float]]:
        """Where F_A changes its sign along the curve: Omega, A, and the distance of the points there, in logarithms."""
        # just beyond a breakpoint, by less than what the harmonics add, their linear effect tells nothing
        trusted = np.ones(curve.A.size, dtype=bool)
        for b in self.model.breakpoints:
            trusted &= (curve.A <= b) | (curve.A - b > np.abs(curve.u_max - curve.A))
        rows = np.flatnonzero(trusted)
        turned = (curve.stable[rows[1:]] != curve.stable[rows[:-1]]) & (np.diff(curve.branch[rows]) == 0)
        points = np.log(np.column_stack((curve.Omega, curve.A)))
        result = []
        for i, j in zip(rows[:-1][turned], rows[1:][turned], strict=True):
            Omega, A = np.exp((points[i] + points[j]) / 2)
            result.append((float(Omega), float(A), float(np.linalg.norm(points[i] - points[j]))))
        return result

    def _fold_at(self, F_0: float) -> Balance:
        def balance(x: Floats) -> Floats:
            Omega, A = np.exp(x)
            F, F_A, _ = self._folds(Omega, A, F_0)
            return np.array([F, A * F_A]) / F_0**2

        return balance

    def _solved(self, balance: Balance, start: Floats, reach: float = SMALL) -> Floats | None:
        """The zero near a start; None where there is none within `reach`, or where it is no correction."""
        with np.errstate(all="ignore"):
            found = root(balance, start, method="hybr", options={"xtol": 1e-13})
            x = np.asarray(found.x)
            near = bool(np.all(np.abs(x - start) <= reach)) and float(np.abs(found.fun).max()) < 1e-9
            return x if near and bool(np.all(self._small(*np.exp(x[:2])))) else None

    def _response(self, Omega: Any, A: Any, F_0: float) -> tuple[Floats, ...]:
        """u_max, phi, R, I, F, F_A, F_Omega, R_A, R_Omega"""
        h, h_A, h_AA, _ = self.model.averaged(A)
        h_3, h_3_A, h_3_AA, _, h_5, h_5_A, h_5_AA, _ = self.harmonics(A)
        m, zeta = self.model.m, self.model.zeta
        values: tuple[Floats, ...] = kernels.response(
            Omega, A, F_0, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA
        )
        return values

    def _folds(self, Omega: Any, A: Any, F_0: Any) -> tuple[Floats, ...]:
        """F, F_A, F_AA"""
        m, zeta = self.model.m, self.model.zeta
        values: tuple[Floats, ...] = kernels.folds(Omega, A, F_0, m, zeta, *self.model.averaged(A), *self.harmonics(A))
        return values

    def _detachment(self, Omega: Any, A: Any) -> tuple[Floats, ...]:
        """R, I, u_max, turning"""
        h, h_A, h_AA, _ = self.model.averaged(A)
        h_3, h_3_A, h_3_AA, _, h_5, h_5_A, h_5_AA, _ = self.harmonics(A)
        m, zeta = self.model.m, self.model.zeta
        values: tuple[Floats, ...] = kernels.detachment(
            Omega, A, m, zeta, h, h_A, h_AA, h_3, h_3_A, h_3_AA, h_5, h_5_A, h_5_AA
        )
        return values


def _crossings(curve: SecondResponse, Omega: Floats) -> tuple[npt.NDArray[np.intp], Floats, Floats, Floats]:
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
