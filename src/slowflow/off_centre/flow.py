"""What excites and what dissipates off the centre. Takes a slow flow; returns what it has beside f_0 and h.

The mean displacement has no part in it: with h and h_A along the balance of the mean, frequencies, levels and stability
are those about the centre, whatever the damping and the excitation (native/roots.h and native/laws.h). With
p = -h/A, e = -h_A - p and y = Omega^2 - p a fold has y (e - y) A = I I_A, with y of the sign of e, and R = A y.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from slowflow.core.backend import SOLVER
from slowflow.core.intervals import Interval
from slowflow.core.mechanism import Flags
from slowflow.core.model import THROUGHOUT, Floats, SlowFlow
from slowflow.off_centre.means import Means, Steps
from slowflow_kernels import dissipation, off_centre, slow_flow

#: what rounding does to a bound
ROUNDED = 2.0**-40


class Flow(SlowFlow):
    """Of one oscillator whose friction acts throughout; h and its slopes are those along the balance of the mean."""

    curve = dissipation

    @classmethod
    def of(cls, flow: SlowFlow) -> Flow:
        """Of an oscillator, wherever its friction acts."""
        laws = replace(flow.laws, contact=THROUGHOUT)
        return cls(flow.mechanism, flow.parameters, flow.mu, flow.zeta, flow.excitation, laws)

    @property
    def plain(self) -> bool:
        """Whether it is a force, with friction and viscous damping only."""
        return not (self.laws.any or self.inertial)

    # ==== At points ===================================================================================================

    def sine_A(self, Omega: Any, A: Any) -> Any:
        """The slope of the sine balance (23) by A."""
        return dissipation.I_A(Omega, A, self.laws.eta, self.zeta, 0.0, self.d, 0.0)

    def force(self, F_0: Any, Omega: Any) -> Any:
        """Amplitude of the force on the mass, of the shape of both."""
        return super().force(F_0, Omega) + 0.0 * Omega

    def forcing(self, F_0: Any) -> tuple[Any, Any]:
        """F_0 and F_2 of the force F_0 + F_2 Omega^2."""
        return (0.0 * F_0, F_0) if self.inertial else (F_0, 0.0 * F_0)

    @property
    def damps(self) -> bool:
        """Whether what is dissipated grows with the amplitude, so that a state is bounded by the force."""
        return bool(self.zeta + self.laws.eta + self.d > 0)

    def bound(self, Omega: Any, force: Any) -> Any:
        """The amplitude at which I alone would take all of the force, with friction or, for m = 0, without."""
        if not self.laws.any:
            return slow_flow.limit_envelope(Omega, force, self.m, self.zeta)
        return dissipation.limit_envelope(Omega, force, self.m, self.zeta, self.laws.eta, self.d)

    def level(self, Omega: Any, A: Any, averages: Any = None) -> Any:
        """The F_0 for which (Omega, A) is a steady state (24); that of an excitation by inertia at Omega = inf too."""
        with np.errstate(all="ignore"):
            found = super().level(Omega, A, averages)
            return np.where(np.isinf(Omega), self.full_level(A), found) if self.inertial else found

    def F_Omega(self, Omega: Any, A: Any, h: Any) -> Any:
        """Slope of F by Omega at a state: that of the squared level, times Omega^4 under an excitation by inertia."""
        I_0, zeta, d, d_3 = self._damping(A, 1)
        if not self.inertial:
            return dissipation.F_Omega(Omega, A, I_0, zeta, d, d_3, h)
        _, stays, grows = dissipation.far_by_inertia(1 / Omega, A, 0.0, I_0, zeta, d, h)
        return -4.0 * Omega * (stays + Omega * grows)

    # ==== Frequencies =================================================================================================

    @property
    def damping(self) -> tuple[float, ...]:
        """The coefficients of I."""
        return self.m, self.zeta, self.laws.eta, self.d

    def frequencies(self, A: Floats, h: Floats, F_0: float) -> Floats:
        """Every Omega at which these are steady states at F_0, (n, k) with NaN where there are less."""
        if self.plain:
            return np.asarray(SOLVER.response_roots(A, h, self.m, self.zeta, np.array([F_0]))[0])
        return np.asarray(SOLVER.law_roots(A, h, 0.0, *self.damping, F_0, self.inertial))

    def fold_frequencies(self, A: Floats, h: Floats, h_A: Floats) -> Floats:
        """Every Omega at which F_A vanishes, likewise."""
        if not self.laws.any:
            return np.asarray(SOLVER.fold_roots(A, h, h_A, self.m, self.zeta)[0])
        return np.asarray(SOLVER.law_roots(A, h, h_A, *self.damping, -1.0, self.inertial))

    def stationary(self, A: Floats, h: Floats) -> Floats:
        """Every Omega at which the level is stationary, likewise, and the end at which it may be least: 0 or inf."""
        if self.plain:
            found = SOLVER.peak_roots(A, h, self.m, self.zeta)[0]
        else:
            found = SOLVER.law_peak_roots(A, h, *self.damping, self.inertial)
        end = np.full((A.size, 1), np.inf if self.inertial else 0.0)
        return np.concatenate((end, found), axis=1)

    def least_forcing(self, A: Floats, h: Floats) -> tuple[Floats, Floats]:
        """The lowest F_0 for which each amplitude is a steady state, and its Omega; inf where it is only tended to."""
        with np.errstate(all="ignore"):
            Omega = self.stationary(A, h)
            level = self.level(Omega, A[:, np.newaxis], (h[:, np.newaxis],))
        return _lowest(np.where(np.isnan(level), np.inf, level), Omega)

    def least_fold(self, A: Floats, h: Floats, h_A: Floats) -> tuple[Floats, Floats]:
        """The lowest F_0 with a fold at each amplitude, inf where there is none, and its Omega."""
        known = np.isfinite(h_A) & (A > 0)
        Omega = np.full((A.size, 4), np.nan)
        with np.errstate(all="ignore"):
            if known.any():
                found = self.fold_frequencies(A[known], h[known], h_A[known])
                Omega[np.flatnonzero(known)[:, np.newaxis], np.arange(found.shape[1])] = found
            level = self.level(Omega, A[:, np.newaxis], (h[:, np.newaxis],))
        return _lowest(np.where(Omega > 0, level, np.inf), Omega)

    # ==== On boxes ====================================================================================================

    def balances(self, Omega: Interval, A: Interval) -> tuple[Interval, Interval]:
        """I and I_A, which rise with both."""
        ends = self.sine(Omega.ends, A.ends), self.sine_A(Omega.ends, A.ends)
        I, I_A = (Interval(np.stack((one[0] * (1 - ROUNDED), one[1] * (1 + ROUNDED)))) for one in ends)
        return I, I_A

    def needed(self, A: Interval, p: Interval) -> Floats:
        """What the forcing of states is not less than; 4 mu/pi, or 0 under inertia, where nothing is known.

        It rises with A. Of a force it rises with |p|: where p > 0 it is least at Omega^2 <= p. Of an excitation by
        inertia it falls as p rises, since with the frequency that goes as sqrt(p) only I falls beside Omega^2.
        """
        if self.inertial:
            nearest = p.hi
        else:
            nearest = np.where(p.lo > 0, p.lo, np.where(p.hi < 0, p.hi, 0.0))
        needed = np.full(nearest.size, 0.0 if self.inertial else self.m)
        known = np.isfinite(nearest) & (nearest != 0) & (A.lo > 0)
        least = A.lo[known]
        needed[known] = self.least_forcing(least, -least * nearest[known])[0]
        return needed

    def folds_between(
        self, A: Interval, p: Interval, e: Interval, sign: Any, lowest: Any, highest: Any
    ) -> tuple[Floats, Flags]:
        """Between which |R| there may be folds with R of that sign at the highest of forcings, (2, ..., n).

        And whether there may be some at forcings between the two. Signs and forcings broadcast.
        e -- of that sign, NaN or inf where it is not known
        """
        known = A.ends.T, p.ends.T, e.ends.T, self.damping, self.inertial
        R, may = SOLVER.folds_between(*known, sign, lowest, highest)
        return np.moveaxis(R, -1, 0), may != 0


class Slow(NamedTuple):
    """An averaged oscillator at a forcing, or at one of each state."""

    steps: Steps
    flow: Flow
    F_0: Any

    def state(self, Omega: Any, x: Floats, means: Means | None = None) -> Any:
        """f_0 and F, and their slopes by A and B, at states x (2, n) or beside them; by their means, if known."""
        flow, means = self.flow, means or self.steps.at(x[0], x[1], 1)
        arguments = flow.force(self.F_0, Omega), flow.sine(Omega, x[0]), flow.sine_A(Omega, x[0]), self.steps.load
        return off_centre.state(Omega, x[0], *arguments, *means.c, *means.s)

    def fold(self, x: Floats) -> Any:
        """What vanishes at folds x (3, n), by A, B and R = A Omega^2 + h, and its slopes by these."""
        means, (m, zeta, eta, d) = self.steps.at(x[0], x[1], 2), self.flow.damping
        arguments = *self.flow.forcing(self.F_0), m, eta, zeta, d, self.steps.load
        return off_centre.fold(x[2], x[0], *arguments, *means.c, *means.s)

    def stability(self, Omega: Any, A: Floats, B: Floats) -> tuple[Flags, Floats]:
        """Where states are stable, those at rest too, and h there."""
        means, averages = self.steps.averaged(A, B)
        with np.errstate(all="ignore"):
            turns = self.flow.F_A(Omega, A, averages)
        return ((turns > 0) | (A == 0)) & (means.c[1] > 0), np.asarray(averages[0])

    def step(self, state: Any) -> Floats:
        """Newton's to f_0 = F = 0."""
        f_0, F, f_A, f_B, F_A, F_B = state
        return np.asarray(np.stack((F_B * f_0 - f_B * F, f_A * F - F_A * f_0)) / (f_A * F_B - f_B * F_A))


def _lowest(level: Floats, Omega: Floats) -> tuple[Floats, Floats]:
    lowest = np.argmin(level, axis=1)[:, np.newaxis]
    return np.take_along_axis(level, lowest, 1)[:, 0], np.take_along_axis(Omega, lowest, 1)[:, 0]
