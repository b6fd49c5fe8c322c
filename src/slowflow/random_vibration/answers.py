"""Answers about random vibration. Take equivalent linear oscillators; return tables, spectra, averages of records."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from slowflow import validate
from slowflow.answer import Drawn, Single, Table, entry
from slowflow.gradient import Gradient
from slowflow.mechanism import EquationOfMotion, Floats
from slowflow.random_vibration.energy import averages
from slowflow.random_vibration.excitation import Excitation, Tabulated, White
from slowflow.random_vibration.gradient import gradient
from slowflow.random_vibration.record import measured
from slowflow.support.errors import Refused
from slowflow_kernels import linearization

Stationary = entry(
    "Stationary",
    "u_rms v_rms a_rms stiffness damping Omega_e ratio_e beyond crossing_rate dry",
    "One stationary motion of a `RandomResponse`.",
)
NO_CYCLES = "averages over cycles of one energy are available under white noise only: random(S_0=...)"
#: by how many root mean squares the largest displacement exceeds them at most, and steps up to there
FARTHEST, STEPS = 12.0, 4000
#: over natural frequencies how far up and down a picture goes
SHOWN = 10.0


@dataclass(frozen=True, eq=False)
class RandomResponse(Drawn, Table):
    """Stationary motions under a Gaussian excitation by statistical linearization, by rising u_rms; dimensionless.

    u_rms, v_rms -- root mean squares of displacement and velocity, seen from the base
    a_rms        -- of the absolute acceleration of the mass; of the transmitted force where a force is what excites
    stiffness, damping -- k and c of the linear oscillator u'' + c u' + k u = w that misses (3) least in the mean square
    Omega_e, ratio_e -- its natural frequency and its damping ratio
    beyond        -- share of the time in which |u| is beyond the first breakpoint, NaN where there is none
    crossing_rate -- how often in a unit of tau |u| passes it (Rice)
    dry           -- share of dry friction in the damping: how far the answer may be trusted
    message       -- what to bear in mind

    That there are no others is proved: see `native/exact/linearized.h`.
    """

    entry: ClassVar[Any] = Stationary
    picture: ClassVar[str] = "psd"

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
    excitation: Excitation = field(repr=False)
    system: EquationOfMotion = field(repr=False)
    _equation: Any = field(default=None, repr=False)

    @property
    def window(self) -> tuple[float, float]:
        """Frequencies between which there is something to see of the spectrum."""
        near = float(self.Omega_e.min()) / SHOWN, float(self.Omega_e.max()) * SHOWN
        of = self.excitation
        return (max(near[0], of.Omega[0]), min(near[1], of.Omega[-1])) if isinstance(of, Tabulated) else near

    def response_psd(self, Omega: Any) -> Floats:
        """One-sided spectral density of u at frequencies, (motions, n): that of the linear oscillators."""
        at = validate.positive_array("Omega", Omega)
        Z, _, _ = linearization.response(at, self.stiffness[:, np.newaxis], self.damping[:, np.newaxis])
        return np.asarray(self.excitation.density(at) / Z)

    @property
    def by_energy(self) -> ByEnergy:
        """Averages over cycles, with a damping that depends on the energy: nearer to (3) than linearization, see there.

        Raises ValueError where the excitation is no white noise; ArithmeticError where the spring pushes away from the
        centre, as of two wells, or gives way.
        """
        if not isinstance(self.excitation, White):
            raise Refused(NO_CYCLES)
        u, v, a, beyond, fourth = averages(self.system, self.excitation.S_0, float(self.u_rms[0])).tolist()
        fraction = math.nan if self.system.force.first_end is None else beyond
        return ByEnergy(math.sqrt(u), math.sqrt(v), math.sqrt(a), fraction, fourth / u**2)

    def largest(self, duration: float) -> Floats:
        """The mean of the largest |u| within a duration, (motions,).

        Passages of levels are as rare and as independent of each other as those of Poisson's process.
        """
        tau = validate.number("duration", duration, above=0.0)
        passes = linearization.crossings(0.0, self.u_rms, self.v_rms) * tau
        x, width = np.linspace(0.0, FARTHEST, STEPS, retstep=True)
        survives = -np.expm1(-passes[:, np.newaxis] * np.exp(-0.5 * x * x))
        return np.asarray(self.u_rms * np.trapezoid(survives, dx=width, axis=1))

    def gradient(self) -> Gradient:
        """How u_rms, v_rms and a_rms of each motion move with the design, mu, zeta, c_2 and S_0, exactly.

        c_2 where there is some, S_0 of white noise. Where two equivalent oscillators meet there is no gradient, and
        `.status` and `.message` say so. Raises ValueError where it is not known how the force moves with the design.
        """
        return gradient(self, self.system, self._equation)

    def measure(
        self, force: str | None = None, *, samples: int = 1_000_000, records: int = 16, seed: int = 0
    ) -> MeasuredRandom:
        """The same of the equation of motion (3) itself, followed under records of the excitation, with intervals.

        force   -- "truncated" for (6), "untruncated" for (5); by default the one that is averaged
        samples -- of all records together
        records -- how many records, whose averages make up the intervals
        seed    -- of the random numbers

        Raises ArithmeticError where the motion escapes.
        """
        system = self.system if force is None else self._equation.equation_of_motion(force)
        linear = self.excitation, self.stiffness, self.damping
        return MeasuredRandom(*measured(system, *linear, samples, records, seed))


@dataclass(frozen=True, eq=False)
class ByEnergy(Single):
    """Stationary motion under white noise by averages over cycles; dimensionless.

    Without dry friction and quadratic damping that is the solution of the Fokker-Planck equation: exact.

    u_rms, v_rms, a_rms -- as of `RandomResponse`
    beyond   -- share of the time beyond the first breakpoint, NaN where there is none
    kurtosis -- of u: 3 of a Gaussian motion
    """

    u_rms: float
    v_rms: float
    a_rms: float
    beyond: float
    kurtosis: float


@dataclass(frozen=True, eq=False)
class MeasuredRandom(Single):
    """Averages over records of the motion; dimensionless.

    u_rms, v_rms, a_rms -- as of `RandomResponse`
    u_margin, v_margin, a_margin -- half the confidence interval of each, 95 %
    beyond   -- share of the time beyond the first breakpoint, NaN where there is none
    kurtosis -- of u: 3 of a Gaussian motion
    duration -- of all records together
    """

    u_rms: float
    v_rms: float
    a_rms: float
    u_margin: float
    v_margin: float
    a_margin: float
    beyond: float
    kurtosis: float
    duration: float
