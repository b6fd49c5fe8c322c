"""Stationary Gaussian excitations: white noise, and spectral densities by points."""

from __future__ import annotations

import math
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np

from slowflow.core import validate
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import Flags, Floats, Ints
from slowflow.support.errors import OutOfRange, Refused
from slowflow_kernels import linearization

#: what makes numbers complex, whose functions then have their slopes as imaginary parts
IMAGINARY = 1e-40
#: over a natural frequency the ends of three bands near it, and by which factor mean densities of the outer ones may
#: differ from that of the inner one: up to there root mean squares were within 5 % of records of the motion, but for
#: distant peaks (docs/limits.md)
BANDS, MOST_UNEVEN = np.array([1 / 1.6, 1 / 1.2, 1.2, 1.6]), 3.0


@dataclass(frozen=True)
class White:
    """White noise with a constant two-sided density S_0: E[w(t) w(t + s)] = 2 pi S_0 delta(s)."""

    S_0: float

    def density(self, Omega: Floats) -> Floats:
        """One-sided, 2 S_0."""
        return np.full(Omega.shape, 2 * self.S_0)

    def is_uneven(self, Omega: Floats) -> Flags:
        """Whether the density varies much near frequencies: nowhere."""
        return np.zeros(Omega.shape, dtype=bool)

    def absolute(self, k: float, c: float) -> float:
        """Mean square of u + z, z'' = -w: infinite, from Omega = 0 on."""
        return math.inf

    @property
    def numbers(self) -> dict[str, float]:
        """By which moments are differentiated, by name."""
        return {"S_0": self.S_0}

    def by_numbers(self, k: float, c: float) -> Floats:
        """Slopes of ln I_0 and ln I_2 by these, (2, numbers): both are in proportion to S_0."""
        return np.full((2, 1), 1 / self.S_0)

    @property
    def for_C(self) -> float:
        """What C takes for it: c sigma_v^2."""
        return math.pi * self.S_0

    def slopes(self, k: float, c: float) -> Floats:
        """Of ln I_0 and ln I_2 by ln k and ln c, [i][j]."""
        p, q = np.log(k) + 1j * IMAGINARY * np.array([1, 0]), np.log(c) + 1j * IMAGINARY * np.array([0, 1])
        return np.log(linearization.white(self.S_0, np.exp(p), np.exp(q))).imag / IMAGINARY


class Tabulated:
    """A one-sided density by points, linear in log-log between these, 0 outside.

    Omega, G -- rising, > 0; the same Omega twice is a step
    """

    def __init__(self, Omega: Any, G: Any) -> None:
        self.Omega, self.G = validate.finite_array("Omega", Omega), validate.positive_array("G", G)
        if self.Omega.ndim != 1 or self.Omega.shape != self.G.shape or self.Omega.size < 2:
            raise Refused("psd must be two rows of one length, of at least two points: frequencies and densities")
        if not (self.Omega[0] > 0 and (np.diff(self.Omega) >= 0).all() and self.Omega[-1] > self.Omega[0]):
            raise Refused("the frequencies of psd must be positive and ascending")
        #: what C takes for it: `sf_table` of `native/exact/linearized.h`
        self.for_C = EXACT.table(np.stack((self.Omega, self.G), axis=1))
        # straight lines in log-log; between points with a step between them a density is that of its own line
        line = np.flatnonzero(np.diff(self.Omega) > 0)
        self._begin, self._G = self.Omega[line], self.G[line]
        self._width = np.log(self.Omega[line + 1] / self._begin)
        self._slope = np.log(self.G[line + 1] / self._G) / self._width

    def density(self, Omega: Floats) -> Floats:
        """One-sided."""
        line, x = self._line(Omega)
        within = (Omega >= self.Omega[0]) & (Omega <= self.Omega[-1])
        return np.where(within, self._G[line] * np.exp(self._slope[line] * x), 0.0)

    def is_uneven(self, Omega: Floats) -> Flags:
        """Whether the density varies much near frequencies; it does where there is none."""
        ends = Omega[..., np.newaxis] * BANDS
        below, about, above = np.moveaxis(np.diff(self._power(ends)) / np.diff(ends), -1, 0)
        least, most = np.minimum(below, above), np.maximum(below, above)
        return np.asarray(~((MOST_UNEVEN * least > about) & (MOST_UNEVEN * about > most)))

    def _power(self, Omega: Floats) -> Floats:
        """Mean square of the excitation at frequencies up to these."""
        from scipy.special import exprel  # (exp(x) - 1)/x: SciPy's special functions are quick to load

        def since(line: Ints, x: Floats) -> Floats:
            return np.asarray(self._G[line] * self._begin[line] * x * exprel((1 + self._slope[line]) * x))

        of_lines = since(np.arange(self._begin.size), self._width)
        line, x = self._line(np.clip(Omega, self.Omega[0], self.Omega[-1]))
        return np.asarray((np.cumsum(of_lines) - of_lines)[line] + since(line, x))

    def _line(self, Omega: Floats) -> tuple[Ints, Floats]:
        """In which line frequencies are, and their logarithms from its begin on."""
        line = np.clip(np.searchsorted(self._begin, Omega, side="right") - 1, 0, None)
        return line, np.log(Omega / self._begin[line])

    def absolute(self, k: float, c: float) -> float:
        """Mean square of u + z, z'' = -w: k^2 I_0 + c^2 I_2 of G/Omega^4, which is linear in log-log too."""
        with np.errstate(over="ignore", under="ignore"):
            density = self.G / self.Omega**2 / self.Omega**2
        if not ((density > 0) & np.isfinite(density)).all():
            raise OutOfRange("the density of the displacement of the base exceeds the range of doubles")
        of_z = EXACT.table(np.stack((self.Omega, density), axis=1))
        I_0, I_2 = np.exp(np.frombuffer(EXACT.moments(of_z, math.log(k), math.log(c), 0.0, 0.0))[:2])
        return float(k**2 * I_0 + c**2 * I_2)

    #: factors of all densities and of all frequencies
    numbers = MappingProxyType({"psd_G": 1.0, "psd_Omega": 1.0})

    def by_numbers(self, k: float, c: float) -> Floats:
        """As those of white noise: at frequencies s Omega, I_j is s^(j - 3) times that of k/s^2 and c/s."""
        by_p, by_q = self.slopes(k, c).T
        return np.stack((np.ones(2), np.array([-3, -1]) - 2 * by_p - by_q), axis=1)

    def slopes(self, k: float, c: float) -> Floats:
        """As those of white noise."""
        found = EXACT.moments(self.for_C, math.log(k), math.log(c), 0.0, 0.0)
        return np.frombuffer(found)[2:6].reshape(2, 2)


Excitation = White | Tabulated
