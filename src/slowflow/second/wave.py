"""Waveforms of steady states in the second approximation, and their transmissibility.

The motion over half a cycle is the generated `wave`, with all harmonics of friction; the transmitted force is that of
spring, damper and friction, as for exact motions. In the other half cycle it has the opposite sign.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from slowflow.answers.transmissibility import Transmitted
from slowflow.core.mechanism import Force, Ints
from slowflow.core.model import Floats, Model
from slowflow.support.quadrature import gauss
from slowflow_kernels import motion
from slowflow_kernels import second_approximation as kernels
from slowflow_kernels.second_conventions import ROUNDING, STEPS

#: nodes of Gauss's rule between two angles at which a piece of the force ends
NODES = 32
#: states at once: some hundred numbers for each node
AT_ONCE = 1024
#: steps that bisect an angle, or narrow in on a largest value, to rounding
HALVINGS = 52
GOLDEN_STEPS = 40
GOLDEN = (5**0.5 - 1) / 2


@dataclass(frozen=True)
class Waves:
    """States of one oscillator: flat arrays of one length.

    Omega, u_max, phi -- frequency, largest displacement, phase of the first harmonic
    F_0               -- amplitude of the excitation
    """

    model: Model
    Omega: Floats
    u_max: Floats
    phi: Floats
    F_0: Floats

    def transmitted(self, of: str) -> Transmitted:
        """Transmissibility by first harmonic, peak and root mean square of the waveform; `of` as in `OF`."""
        moving = np.flatnonzero(self.u_max > 0)
        # a mass at rest passes on all that drives it
        size = 0.0 if of == "relative" else 1.0
        found = Transmitted(*(np.full(self.Omega.size, size * ratio) for ratio in (1.0, 1.0, math.sqrt(0.5))))
        for k in range(0, moving.size, AT_ONCE):
            rows = moving[k : k + AT_ONCE]
            for column, values in zip(found, self._part(rows)._transmitted(of), strict=True):
                column[rows] = values
        return found

    def _part(self, rows: Ints) -> Waves:
        return Waves(self.model, *(column[rows] for column in (self.Omega, self.u_max, self.phi, self.F_0)))

    def _transmitted(self, of: str) -> Transmitted:
        _, A_1, sine, cosine, *_ = self._components
        force = np.asarray(self.model.force(self.F_0, self.Omega))
        # the forcing is cos(turned + lag)
        lag = np.arctan2(sine, cosine) - self.phi
        if of == "force":
            first, scale = np.asarray(motion.transmissibility(self.Omega, A_1, force, self.phi)), force
        elif of == "relative":
            first, scale = A_1 / self.F_0, self.F_0
        else:
            # of a shaken base its displacement is the force over -Omega^2, and that of the mass is what is passed on
            first, scale = np.asarray(motion.transmissibility(self.Omega, A_1, force, self.phi)), self.F_0

        def value(turned: Floats, rows: tuple[slice | None, ...]) -> Floats:
            u, v = self._wave(turned, rows)
            if of == "relative":
                return u
            if of == "absolute":
                return np.asarray(u + self.F_0[rows] * np.cos(turned + lag[rows]))
            # seen by who stands still the forcing is no force; until it turns again the mass moves down
            model = self.model
            return -np.asarray(motion.acceleration(0.0, v, 0.0, model.zeta, -model.mu, self._force(u)))

        edges = self._edges()
        nodes, weights = gauss(NODES)
        low, high = edges[:, :-1, np.newaxis], edges[:, 1:, np.newaxis]
        turned = low + (high - low) * nodes
        weight = (high - low) * weights / np.pi
        values = value(turned, (slice(None), None, None))
        # its harmonics beside the first one, which the balance has
        square = (weight * values**2).sum(axis=(1, 2))
        own = 2.0 * (weight * values * np.exp(-1j * turned)).sum(axis=(1, 2))
        rest = np.maximum(square - 0.5 * np.abs(own) ** 2, 0.0)
        rms = np.sqrt(0.5 * first**2 + rest / scale**2)
        within = np.concatenate((low, turned, high), axis=2)
        peak = _largest(lambda at: np.abs(value(at, (slice(None),))), within, np.abs(values)) / scale
        return Transmitted(first, peak, rms)

    @cached_property
    def _components(self) -> tuple[Floats, ...]:
        """What `kernels.components` gives where its u_max is that of the states."""
        model, A = self.model, self.u_max
        for _ in range(STEPS):
            h = model.averaged(A)[0]
            of_A = model.harmonics(A)
            found = tuple(np.asarray(one) for one in kernels.components(self.Omega, A, model.m, h, of_A[0], of_A[4]))
            ratio = self.u_max / found[0]
            A = A * ratio
            if not (np.abs(ratio - 1) > ROUNDING).any():
                break
        return found

    def _wave(self, turned: Floats, rows: tuple[slice | None, ...]) -> tuple[Floats, Floats]:
        """u and u' of each state at its angles, for which its numbers get axes by `rows`."""
        _, A_1, sine, cosine, a_3, a_5, kappa = (one[rows] for one in self._components)
        u, v = kernels.wave(turned, self.Omega[rows], self.model.m, A_1, sine, cosine, a_3, a_5, kappa)
        return np.asarray(u), np.asarray(v)

    @cached_property
    def _force(self) -> Force:
        return Force.of(self.model.mechanism, self.model.parameters)

    def _edges(self) -> Floats:
        """0, the angles at which the mass passes the end of a piece, pi: by rising angle, along the second axis."""
        ends = [*self.model.breakpoints, *([0.0] if self.model.preload else [])]
        columns = [np.zeros_like(self.Omega), np.full_like(self.Omega, np.pi)]
        for b in sorted({*ends, *(-end for end in ends)}):
            low, high = np.zeros_like(self.Omega), np.full_like(self.Omega, np.pi)
            for _ in range(HALVINGS):
                middle = 0.5 * (low + high)
                above = self._wave(middle, (slice(None),))[0] > b
                low, high = np.where(above, middle, low), np.where(above, high, middle)
            columns.append(low)
        return np.sort(np.stack(columns, axis=1), axis=1)


def _largest(value: Callable[[Floats], Floats], turned: Floats, sizes: Floats) -> Floats:
    """The largest value of each row, between the angles beside the node that has the largest.

    turned -- angles, (rows, parts, nodes + 2), of which the first and the last end a part
    sizes  -- values at the nodes
    """
    rows = np.arange(len(turned))
    of_row = sizes.reshape(len(turned), math.prod(sizes.shape[1:]))
    part, node = np.unravel_index(of_row.argmax(axis=1), sizes.shape[1:])
    top, low, high = sizes[rows, part, node], turned[rows, part, node], turned[rows, part, node + 2]
    for _ in range(GOLDEN_STEPS):
        width = GOLDEN * (high - low)
        left, right = high - width, low + width
        of_left, of_right = value(left), value(right)
        top = np.maximum(top, np.maximum(of_left, of_right))
        rises = of_left < of_right
        low, high = np.where(rises, left, low), np.where(rises, high, right)
    return np.asarray(top)
