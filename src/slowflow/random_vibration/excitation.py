"""Stationary Gaussian excitations. Takes spectral densities; returns how far and fast a linear oscillator moves.

    I_j = int_0^inf G(Omega) Omega^j/|k - Omega^2 + i c Omega|^2 dOmega,   sigma_u^2 = I_0,  sigma_v^2 = I_2

over p = ln k and q = ln c (derivations/extensions/linearization.py), with bounds of the slopes of ln I_j on boxes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from slowflow import validate
from slowflow.mechanism import Floats
from slowflow.support.errors import Refused
from slowflow_kernels import linearization

#: nodes in each part of a table, which is at most that wide in ln(Omega)
NODES, WIDEST = 12, 1.0
_AT, _WEIGHTS = np.polynomial.legendre.leggauss(NODES)
_SHARES = 0.5 * (1 + _AT)
#: of a damping ratio below that parts do not become narrower towards the resonance
NARROWEST = 2.0**-40
#: of Newton's iteration for sigma_v: steps at most, and one after which as many digits come as there are
MOST_STEPS, LAST = 60, 2.0**-28
#: boxes whose integrals are formed together
TOGETHER = 2048


class Moments(NamedTuple):
    """ln I_0 and ln I_2 (2, n), and their slopes by p and q (2, 2, n); of boxes lower and upper ends of these."""

    value: Floats
    slopes: Floats


@dataclass(frozen=True)
class White:
    """White noise with a constant two-sided density S_0: E[w(t) w(t + s)] = 2 pi S_0 delta(s)."""

    S_0: Any

    def density(self, Omega: Floats) -> Floats:
        """One-sided, 2 S_0."""
        return np.full(Omega.shape, 2 * self.S_0)

    def velocity(self, mu: Any, zeta: Any, c_2: Any) -> tuple[Floats, Floats]:
        """Root mean squares of v and dampings c, c sigma_v^2 = pi S_0, of laws that broadcast with S_0.

        The slope of ln(c) by ln(sigma_v) rises from -1 on: from the second step on Newton's iteration comes from above.
        """
        power = math.pi * self.S_0
        v = np.sqrt(power)
        for _ in range(MOST_STEPS):
            c, slope, _ = linearization.equivalent_damping(v, mu, zeta, c_2)
            step = np.log(power / (c * v * v)) / (2 + slope / c)
            v = v * np.exp(step)
            if not (np.abs(step) > LAST).any():
                break
        return v, linearization.equivalent_damping(v, mu, zeta, c_2)[0]


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
        parts = [np.linspace(a, b, 1 + math.ceil((b - a) / WIDEST)) for a, b in zip(x[wide], x[wide + 1], strict=True)]
        self._edges = np.unique(np.concatenate(parts))

    def density(self, Omega: Floats) -> Floats:
        """One-sided."""
        x = np.log(Omega)
        return np.where((x >= self._x[0]) & (x <= self._x[-1]), self._within(x), 0.0)

    def _within(self, x: Floats) -> Floats:
        part = np.clip(np.searchsorted(self._begins, x, side="right") - 1, 0, None)
        return np.asarray(np.exp(self._y_begins[part] + self._slopes[part] * (x - self._begins[part])))

    @property
    def most(self) -> float:
        """The largest density."""
        return float(self.G.max())

    @cached_property
    def rms(self) -> float:
        """Root mean square of the excitation."""
        Omega, weights = self._nodes(self._edges)
        return math.sqrt(float((weights * self._within(np.log(Omega))).sum()))

    @cached_property
    def swept(self) -> float:
        """k I_0 - I_2 is at most this over c, as |y|/(y^2 + c^2 Omega^2) is at most 1/(2 c Omega)."""
        Omega, weights = self._nodes(self._edges)
        return 0.5 * float((weights * self._within(np.log(Omega)) / Omega).sum())

    @staticmethod
    def _nodes(edges: Floats) -> tuple[Floats, Floats]:
        """Frequencies and weights of a sum over Omega, from the edges of parts along the last axis."""
        width = np.diff(edges)[..., np.newaxis]
        Omega = np.exp(edges[..., :-1, np.newaxis] + width * _SHARES).reshape(*edges.shape[:-1], -1)
        return Omega, Omega * (width * 0.5 * _WEIGHTS).reshape(Omega.shape)

    def moments(self, p: Floats, q: Floats) -> Moments:
        """At points: parts shrink towards the resonance, down to its width."""
        value, slopes = np.empty((2, p.size)), np.empty((2, 2, p.size))
        ratio = np.clip(0.5 * np.exp(q - 0.5 * p), NARROWEST, 1.0)
        doublings = np.ceil(np.log2(WIDEST / ratio)).astype(int)
        for count in np.unique(doublings):
            for some in np.array_split(alike := np.flatnonzero(doublings == count), 1 + alike.size // TOGETHER):
                away = ratio[some, np.newaxis] * 2.0 ** np.arange(count + 1)
                at = 0.5 * p[some, np.newaxis]
                edges = np.broadcast_to(self._edges, (some.size, self._edges.size))
                edges = np.sort(np.concatenate((at - away[:, ::-1], at, at + away, edges), axis=1), axis=1)
                Omega, weights = self._nodes(np.clip(edges, self._x[0], self._x[-1]))
                weights = weights * self._within(np.log(Omega))
                k, c = (np.exp(one[some, np.newaxis]) for one in (p, q))
                Z, *by = linearization.response(Omega, k, c)
                for j, power in enumerate((np.ones_like(Omega), Omega * Omega)):
                    terms = weights * power / Z
                    whole = terms.sum(axis=1)
                    value[j, some] = np.log(whole)
                    for i, one in enumerate(by):
                        slopes[j, i, some] = (terms * one).sum(axis=1) / whole
        return Moments(value, slopes)

    def slopes_on(self, at: Moments, low: Floats, z: Floats, high: Floats) -> tuple[Floats, Floats]:
        """Between which ends slopes by p and q are on boxes, each (2, 2, n), from those at points in these.

        Slopes of ln I_j are weighted means of those of -ln Z, and slopes of these have the means of the second ones and
        covariances beside them.
        """
        r = np.maximum(high - z, z - low)
        ratio = 0.5 * np.exp(low[1] - 0.5 * high[0])
        with np.errstate(all="ignore"):
            least, most, peak = linearization.steepest(ratio)
        down, peak = np.where(ratio < 0.5, -least, 2.0), np.where(ratio < 0.5, peak, np.maximum(peak, 1.0))
        peak = np.where(ratio < math.sqrt(0.5), peak, 1.0)
        upper = np.stack((most, np.zeros_like(most)))
        lower = np.stack((-down, np.full_like(most, -2.0)))
        both, largest = 0.5 * (down + most), np.maximum(down, most)
        by_p = np.maximum(0.25 + 2 * peak, np.maximum(down * (down - 1), most * (most + 1)) + both**2)
        mixed = 2 * largest + both
        moved = np.stack((by_p * r[0] + mixed * r[1], mixed * r[0] + r[1]))
        return np.maximum(lower, at.slopes - moved), np.minimum(upper, at.slopes + moved)

    def least_rate(self, k: Floats, c: float) -> float:
        """A lower bound of sigma_v^2 for stiffness between two."""
        Omega, weights = self._nodes(self._edges)
        Z = np.max([linearization.response(Omega, one, c)[0] for one in k], axis=0)
        return float((weights * self._within(np.log(Omega)) * Omega**2 / Z).sum())


Excitation = White | Tabulated
