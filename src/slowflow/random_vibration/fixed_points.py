"""All fixed points of statistical linearization: none is missed, and each that is given is proved to be there, once.

In:  an equation of motion (3), and the table of its excitation.
Out: ln k and ln c of each equivalent linear oscillator.

With p = ln k and q = ln c what vanishes is

    1 - K(sigma_u)/k        ln C(sigma_v) - q        sigma_u^2 = I_0(k, c),  sigma_v^2 = I_2(k, c)

where K and C are stiffness and damping of force and damping under a Gaussian motion. Both are held on boxes of p and q,
with their slopes (see `off_centre.boxes`).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from slowflow.intervals import Interval
from slowflow.mechanism import EquationOfMotion, Floats, Ints
from slowflow.off_centre.boxes import Equations, Solutions, solve
from slowflow.random_vibration.excitation import Tabulated
from slowflow.random_vibration.gaussian import WIDE, Secants, averages, on_ranges, sizes
from slowflow.support.errors import NotSettled
from slowflow_kernels import linearization

#: relative error of an average or an integral, by far
DOUBT = Interval(np.array([[-(2.0**-42)], [2.0**-42]]))
#: root mean squares at which the range of the stiffness is looked for
SAMPLES = 160
#: by how much ranges are taken to be larger
MARGIN = 1.5
#: parts of both ranges that are looked at first; doublings of damping in search of its range
PARTS, MOST_DOUBLINGS = 8, 200
GIVES_WAY = "no linear oscillator is equivalent: in the mean the spring pushes away from the centre, or gives way"
HELD = "friction holds the mass nearly all of the time: no linear damping is equivalent to it"


class Linearized(Equations):
    """In p and q."""

    def __init__(self, system: EquationOfMotion, excitation: Tabulated) -> None:
        self.force, self.excitation, self.secants = system.force, excitation, Secants(system.force)
        self.laws = system.mu, system.zeta, system.c_2

    def limits(self, of: Ints) -> tuple[Any, Any]:
        """See `boxes.Equations`."""
        return -np.inf, np.inf

    def _damping(self, ln_square: Floats) -> tuple[Floats, Floats]:
        """ln C and its slope, by ln sigma_v^2."""
        c, slope, _ = linearization.equivalent_damping(np.exp(0.5 * ln_square), *self.laws)
        return np.log(c), 0.5 * slope / c

    def on(self, low: Floats, x: Floats, high: Floats, of: Ints) -> tuple[Floats, ...]:
        """See `boxes.Equations`."""
        at = self.excitation.moments(x[0], x[1])
        lower, upper = self.excitation.slopes_on(at, low, x, high)
        (p_0, q_0), (p_2, q_2) = (
            [Interval.of(*ends) for ends in zip(*both, strict=True)] for both in zip(lower, upper, strict=True)
        )
        move = [Interval.of(a - at_x, b - at_x) for a, at_x, b in zip(low, x, high, strict=True)]
        over, over_x = Interval.of(np.exp(-high[0]), np.exp(-low[0])), Interval.point(np.exp(-x[0]))
        # by how much ln I_0 and ln I_2 differ on the box from what they are at x
        of_u, of_v = (by_p * move[0] + by_q * move[1] + DOUBT for by_p, by_q in ((p_0, q_0), (p_2, q_2)))
        sigma = np.exp(0.5 * (at.value[0] + of_u.ends))
        K_on, T = on_ranges(self.force, self.secants, *sigma)
        middle = averages(self.force, np.exp(0.5 * at.value[0]))
        K = Interval.point(middle.stiffness) + DOUBT * Interval.point(middle.first.sum(axis=0))
        K_on = K_on.both(K + 0.5 * (T * of_u))
        # the slope of ln C rises with sigma_v
        C, _ = self._damping(at.value[1])
        D = Interval(np.sort(self._damping(at.value[1] + of_v.ends)[1], axis=0))
        C_at = Interval.point(C) + DOUBT
        at_x = 1 - K * over_x, C_at - x[1]
        on_box = 1 - K_on * over, C_at + D * of_v - Interval.of(low[1], high[1])
        slopes = (
            ((K_on - 0.5 * (T * p_0)) * over, -(0.5 * (T * q_0)) * over),
            (D * p_2, D * q_2 - 1.0),
        )
        values = (np.stack([one.ends for one in both], axis=1) for both in (at_x, on_box))
        return *values, np.stack([np.stack([one.ends for one in row], axis=1) for row in slopes], axis=1)


def fixed_points(system: EquationOfMotion, excitation: Tabulated) -> Solutions:
    """All that there are. Raises ArithmeticError where there is no stationary motion, or where they stay undecided."""
    ends = ranges(system, excitation)
    edges = np.linspace(*ends, PARTS + 1, axis=-1)
    low, high = (np.stack(np.meshgrid(*some)).reshape(2, -1) for some in (edges[:, :-1], edges[:, 1:]))
    return solve(Linearized(system, excitation), low, high, np.zeros(low.shape[1], dtype=np.intp))


def ranges(system: EquationOfMotion, excitation: Tabulated) -> tuple[Floats, Floats]:
    """Lowest and highest p and q of a fixed point.

    Below the lowest c the damping that it leads to is more at each k, above the highest one less: c sigma_v rises with
    c, and all that C sigma_v has beside friction falls.
    """
    laws = system.mu, system.zeta, system.c_2
    dry = float(linearization.equivalent_damping(1.0, *laws)[2])
    if not dry < excitation.rms:
        raise NotSettled(HELD)
    strength = math.pi * excitation.most  # c I_2 is at most that
    least = max(2 * system.zeta, dry**2 / strength)
    sigma = sizes(system.force, SAMPLES)
    K = averages(system.force, sigma).stiffness
    # k I_0, which at a fixed point is E[u f], is at most that
    K = K[K * sigma**2 <= (strength + excitation.swept) / least]
    if not (K > 0).any():
        raise NotSettled(GIVES_WAY)
    k = np.array([max(K.min(), K.max() / WIDE) / MARGIN, K.max() * MARGIN])
    most = least
    for _ in range(MOST_DOUBLINGS):
        sigma_v = min(excitation.rms / most, math.sqrt(strength / most))
        needed = float(linearization.equivalent_damping(sigma_v, *laws)[0]) * sigma_v
        if most**2 * excitation.least_rate(k, most) > needed**2:
            return np.log([k[0], least / MARGIN]), np.log([k[1], most * MARGIN])
        most *= 2.0
    raise NotSettled(HELD)
