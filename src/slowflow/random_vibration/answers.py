"""Results of random vibration: equivalent oscillators, spectra, simulated averages."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from slowflow.answers.answer import Drawn, Single, Table
from slowflow.answers.gradient import Gradient
from slowflow.answers.results import Remark
from slowflow.core import validate
from slowflow.core.mechanism import EquationOfMotion, Floats, Reals
from slowflow.random_vibration.excitation import Excitation, Tabulated, White
from slowflow.random_vibration.fokker_planck import averages
from slowflow.random_vibration.gradient import gradient
from slowflow.random_vibration.passages import largest
from slowflow.random_vibration.record import measured
from slowflow.support.errors import Refused
from slowflow_kernels import linearization

NOT_WHITE = "the Fokker-Planck equation is solved under white noise only: random(S_0=...)"
#: over natural frequencies how far up and down a picture goes
SHOWN = 10.0


@dataclass(frozen=True, eq=False)
class RandomResponse(Drawn, Table, entry="Stationary"):
    """Stationary motions under a Gaussian excitation by statistical linearization, in ascending order of u_rms.

    B            -- mean displacement, 0 without a load if the force is odd; all numbers are dimensionless
    u_rms, v_rms -- root mean squares of displacement about the mean, and of velocity, relative to the base
    a_rms        -- of the absolute acceleration of the mass; under a force, of the transmitted force less the load
    stiffness, damping -- k and c of the linear oscillator u'' + c u' + k u = w with the least mean square error in (3)
    Omega_e, ratio_e -- natural frequency and damping ratio of this linear oscillator
    beyond        -- fraction of the time in which u is beyond the first breakpoint on either side, NaN if there is none
    crossing_rate -- rate at which u crosses the breakpoints outwards, per unit of tau (Rice)
    dry           -- fraction of the damping due to dry friction, on which the accuracy depends
    message       -- diagnostics as text
    remarks       -- diagnostics as flags of `slowflow.Remark`

    It is proved that there are no other solutions: without a load about the centre, with a load or for an asymmetric
    force about any mean. About a mean the proof has two assumptions: a force that is not a polynomial is close to its
    Legendre series of degree 7 in each of some 300 cells; under a PSD, the least RMS is found on a grid of
    stiffnesses. See `native/exact/linearized.h` and `native/exact/offset.h`.
    """

    picture: ClassVar[str] = "psd"

    B: Floats
    u_rms: Floats
    v_rms: Floats
    a_rms: Floats
    stiffness: Floats
    damping: Floats
    Omega_e: Floats
    ratio_e: Floats
    beyond: Floats
    crossing_rate: Floats
    dry: Floats
    message: str
    remarks: Remark
    excitation: Excitation = field(repr=False)
    system: EquationOfMotion = field(repr=False)
    _equation: Any = field(default=None, repr=False)

    @property
    def window(self) -> tuple[float, float]:
        """Range of frequencies for plots of the spectrum."""
        near = float(self.Omega_e.min()) / SHOWN, float(self.Omega_e.max()) * SHOWN
        of = self.excitation
        return (max(near[0], of.Omega[0]), min(near[1], of.Omega[-1])) if isinstance(of, Tabulated) else near

    def response_psd(self, Omega: Reals) -> Floats:
        """One-sided spectral density of u at frequencies, for the linear oscillators, shape (motions, n)."""
        at = validate.positive_array("Omega", Omega)
        Z, _, _ = linearization.response(at, self.stiffness[:, np.newaxis], self.damping[:, np.newaxis])
        return np.asarray(self.excitation.density(at) / Z)

    def absolute_rms(self) -> Floats:
        """Root mean square of the absolute displacement of the mass, if the base's acceleration is the excitation.

        It is that of the equivalent linear oscillators, about the mean, shape (motions,); inf for white noise, in which
        the base itself moves without bound.
        """
        linear = zip(self.stiffness.tolist(), self.damping.tolist(), strict=True)
        return np.sqrt([self.excitation.absolute(k, c) for k, c in linear])

    @property
    def fokker_planck(self) -> FokkerPlanck:
        """The exact stationary density under white noise, for any force and damping: all that random() approximates.

        Raises ValueError if the excitation is not white noise; ArithmeticError if the spring or the damping is too weak
        to hold the mass, or the motion does not leave the wells of the spring.
        """
        if not isinstance(self.excitation, White):
            raise Refused(NOT_WHITE)
        scales = (float(column[0]) for column in (self.B, self.u_rms, self.v_rms, self.beyond))
        B, u, v, a, beyond, kurtosis = averages(self.system, self.excitation.S_0, *scales).tolist()
        fraction = math.nan if math.isnan(self.beyond[0]) else beyond
        return FokkerPlanck(B, math.sqrt(u), math.sqrt(v), math.sqrt(a), fraction, kurtosis)

    def largest(self, duration: float) -> Floats:
        """Mean of the largest |u| within a duration, shape (motions,).

        By stochastic averaging of the energy, with the force and the damping of (3); passages of a level come in
        clusters. In simulations it is 2 % too low to 5 % too high, with dry friction up to 0.92 of the damping; up to
        16 % too high, or 4 % too low, where the density of the excitation varies much near Omega_e.
        """
        tau = validate.number("duration", duration, above=0.0)
        return np.array([largest(self, self.system, motion, tau) for motion in range(self.u_rms.size)])

    def gradient(self) -> Gradient:
        """Differentiate u_rms, v_rms and a_rms of each motion with respect to the design, damping and excitation.

        The derivatives are exact. They are taken with respect to c_2, c_3 and zeta_2 if these are not 0; for white
        noise with respect to S_0; for a PSD with respect to common factors of all densities (psd_G) and of all
        frequencies (psd_Omega). Motions about a mean also have the derivatives of B, and those with respect to the
        load. Where two equivalent oscillators merge there is no gradient; `.status` and `.message` say so. Raises
        ValueError if the derivatives of the force with respect to the design are not known.
        """
        return gradient(self, self.system, self._equation)

    def measure(
        self, force: str | None = None, *, samples: int = 1_000_000, records: int = 16, seed: int = 0
    ) -> MeasuredRandom:
        """Simulate the equation of motion (3) under records of the excitation; averages with confidence intervals.

        force   -- "truncated" for (6), "untruncated" for (5); by default the one that is averaged
        samples -- total number of samples
        records -- number of records, whose averages give the intervals
        seed    -- of the random numbers

        Raises ArithmeticError if the motion escapes, and if it is damped so much that no record of it settles.
        """
        system = self.system if force is None else self._equation.equation_of_motion(force)
        linear = self.excitation, self.stiffness, self.damping
        return MeasuredRandom(*measured(system, *linear, float(self.B[0]), samples, records, seed))


def crossings(ends: Any, mean: Any, u_rms: Any, v_rms: Any) -> Any:
    """Rate at which a Gaussian motion about a mean passes either of two ends outwards, per unit of tau (Rice)."""
    with np.errstate(over="ignore"):  # an end that lies many u_rms away is never passed
        below, above = (linearization.crossings(end - mean, u_rms, v_rms) for end in ends)
    return (below + above) / 2


@dataclass(frozen=True, eq=False)
class FokkerPlanck(Single):
    """Stationary motion under white noise, from the Fokker-Planck equation of (3); dimensionless.

        u' dp/du = d/du' ((f + r) p) + pi S_0 d^2 p/du'^2

    p is the density of u and u', r the damping force, f less the load. It is solved until root mean squares change by
    less than 0.01 % with more nodes.

    B, u_rms, v_rms, a_rms -- as in `RandomResponse`
    beyond   -- fraction of the time beyond the first breakpoint, NaN if there is none
    kurtosis -- of u about its mean: 3 for a Gaussian motion
    """

    B: float
    u_rms: float
    v_rms: float
    a_rms: float
    beyond: float
    kurtosis: float


@dataclass(frozen=True, eq=False)
class MeasuredRandom(Single):
    """Averages over records of the motion; dimensionless.

    B, u_rms, v_rms, a_rms -- as in `RandomResponse`
    B_margin, u_margin, v_margin, a_margin -- half widths of their 95 % confidence intervals
    beyond   -- fraction of the time beyond the first breakpoint, NaN if there is none
    kurtosis -- of u about its mean: 3 for a Gaussian motion
    duration -- total duration of the records
    """

    B: float
    u_rms: float
    v_rms: float
    a_rms: float
    B_margin: float
    u_margin: float
    v_margin: float
    a_margin: float
    beyond: float
    kurtosis: float
    duration: float
