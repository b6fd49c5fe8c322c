"""Stationary Gaussian excitations: white noise, and spectral densities by points."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow import validate
from slowflow.backend import EXACT
from slowflow.mechanism import Floats
from slowflow.support.errors import NotSettled, Refused
from slowflow_kernels import linearization

#: nodes in each part of a table, which is at most that wide in ln(Omega), see `native/exact/linearized.h`
NODES, WIDEST = 12, 1.0
_AT, _WEIGHTS = np.polynomial.legendre.leggauss(NODES)
_SHARES = 0.5 * (1 + _AT)
#: what makes numbers complex, whose functions then have their slopes as imaginary parts
IMAGINARY = 1e-40
#: by how much less the lowest damping is taken to be
MARGIN = 1.5
STUCK = "friction holds the mass nearly all of the time: no linear damping is equivalent to it"


@dataclass(frozen=True)
class White:
    """White noise with a constant two-sided density S_0: E[w(t) w(t + s)] = 2 pi S_0 delta(s)."""

    S_0: float

    def density(self, Omega: Floats) -> Floats:
        """One-sided, 2 S_0."""
        return np.full(Omega.shape, 2 * self.S_0)

    def rows(self, mu: float, zeta: float, c_2: float) -> float:
        """What C takes for it: c sigma_v^2."""
        return math.pi * self.S_0

    def slopes(self, k: float, c: float) -> Floats:
        """Of ln I_0 and ln I_2 by ln k and ln c, [i][j]."""
        p, q = np.log(k) + 1j * IMAGINARY * np.array([1, 0]), np.log(c) + 1j * IMAGINARY * np.array([0, 1])
        return np.log(linearization.white(self.S_0, np.exp(p), np.exp(q))).imag / IMAGINARY


class Tabulated:
    """A one-sided density by points, straight in log-log between these, 0 outside.

    Omega, G -- rising, > 0; the same Omega twice is a step
    """

    def __init__(self, Omega: Any, G: Any) -> None:
        self.Omega, self.G = validate.finite_array("Omega", Omega), validate.positive_array("G", G)
        if self.Omega.ndim != 1 or self.Omega.shape != self.G.shape or self.Omega.size < 2:
            raise Refused("psd must be two rows of one length, of at least two points: frequencies and densities")
        if not (self.Omega[0] > 0 and (np.diff(self.Omega) >= 0).all() and self.Omega[-1] > self.Omega[0]):
            raise Refused("the frequencies of psd must be positive and rise")
        x = np.log(self.Omega)
        self._x, self._y = x, np.log(self.G)
        wide = np.flatnonzero(np.diff(x) > 0)
        #: between points with a step between them a density is that of its own interval
        self._slopes = np.diff(self._y)[wide] / np.diff(x)[wide]
        self._begins, self._y_begins = x[wide], self._y[wide]
        pieces = [np.linspace(a, b, 1 + math.ceil((b - a) / WIDEST)) for a, b in zip(x[wide], x[wide + 1], strict=True)]
        self._edges = np.unique(np.concatenate(pieces))

    def density(self, Omega: Floats) -> Floats:
        """One-sided."""
        x = np.log(Omega)
        return np.where((x >= self._x[0]) & (x <= self._x[-1]), self._within(x), 0.0)

    def _within(self, x: Floats) -> Floats:
        part = np.clip(np.searchsorted(self._begins, x, side="right") - 1, 0, None)
        return np.asarray(np.exp(self._y_begins[part] + self._slopes[part] * (x - self._begins[part])))

    def rows(self, mu: float, zeta: float, c_2: float) -> Floats:
        """What C takes for it, with the laws of damping: `sf_table` of `native/exact/linearized.h`.

        Below the lowest c the damping that it leads to is more at each k: c I_2 is at most pi times the largest
        density, and k I_0 that over c and what |y|/(y^2 + c^2 Omega^2) adds, which is at most 1/(2 c Omega).
        """
        Omega, weights = self._nodes(self._edges)
        of_w = weights * self._within(np.log(Omega))
        dry = float(linearization.equivalent_damping(1.0, mu, zeta, c_2)[2])
        if not dry < math.sqrt(of_w.sum()):
            raise NotSettled(STUCK)
        strength = math.pi * float(self.G.max())
        least = max(2 * zeta, dry**2 / strength)
        most = (strength + 0.5 * float((of_w / Omega).sum())) / least
        part = np.searchsorted(self._begins, self._edges[:-1], side="right") - 1
        bands = self._edges[:-1], self._edges[1:], self._begins[part], self._y_begins[part], self._slopes[part]
        half = slice(NODES // 2, None)
        return np.array([most, least / MARGIN, mu, zeta, c_2, *_AT[half], *_WEIGHTS[half], *np.stack(bands, 1).ravel()])

    def slopes(self, k: float, c: float) -> Floats:
        """As those of white noise."""
        found = EXACT.moments(self.rows(0.0, 0.5 * c, 0.0), math.log(k), math.log(c), 0.0, 0.0)
        return np.frombuffer(found)[2:6].reshape(2, 2)

    @staticmethod
    def _nodes(edges: Floats) -> tuple[Floats, Floats]:
        """Frequencies and weights of a sum over Omega, from the edges of parts along the last axis."""
        width = np.diff(edges)[..., np.newaxis]
        Omega = np.exp(edges[..., :-1, np.newaxis] + width * _SHARES).reshape(*edges.shape[:-1], -1)
        return Omega, Omega * (width * 0.5 * _WEIGHTS).reshape(Omega.shape)


Excitation = White | Tabulated
