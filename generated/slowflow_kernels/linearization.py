"""Stationary random vibration by statistical linearization.

Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/extensions/linearization.py;
never edit.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import from_c

__all__ = [
    "crossings", "damping_force", "equivalent_damping", "over_displacements", "resonance", "response", "steepest",
    "white",
]


def over_displacements(level: Any, within: Any, sigma_u: Any, mu: Any, zeta: Any, zeta_2: Any) -> tuple[Any, Any, Any, Any]:
    """Friction and viscous damping ratio in the mean over u, then their slopes by ln(sigma_u).

    Equation (3). Domain: level > 0, sigma_u > 0. Operations: 11.
    """
    t0 = sigma_u * sigma_u * zeta_2
    return mu * within, t0 + zeta, -0.79788456080286541 * level * mu * np.exp(-0.5 * level * level), 2.0 * t0


def equivalent_damping(sigma_v: Any, mu: Any, zeta: Any, c_2: Any, c_3: Any) -> tuple[Any, Any, Any]:
    """Damping of the linear oscillator, its slope by ln(sigma_v), and what of it is dry friction's.

    Equation (3). Domain: sigma_v > 0. Operations: 14.
    """
    t0 = c_3 * sigma_v * sigma_v
    t1 = 1.5957691216057308 * c_2 * sigma_v
    t2 = 0.79788456080286541 * mu / sigma_v
    return 3.0 * t0 + t1 + t2 + 2.0 * zeta, 6.0 * t0 + t1 - t2, t2


def damping_force(level: Any, within: Any, sigma_u: Any, sigma_v: Any, mu: Any, zeta: Any, c_2: Any, c_3: Any, zeta_2: Any) -> Any:
    """Mean square of the damping force of (3).

    Equation (3). Domain: level > 0. Operations: 65.
    """
    t0 = 0.79788456080286541 * c_2
    t1 = 12.0 * c_3
    sigma_u2 = sigma_u * sigma_u
    t2 = sigma_u2 * zeta_2
    t3 = mu * within
    t4 = 8.0 * zeta
    t5 = 3.1915382432114616 * t3
    t6 = 8.0 * t2
    sigma_v2 = sigma_v * sigma_v
    sigma_u4 = sigma_u2 * sigma_u2
    sigma_v3 = sigma_v * sigma_v2
    sigma_v4 = sigma_v2 * sigma_v2
    sigma_v6 = sigma_v3 * sigma_v3
    sigma_v5 = sigma_v * sigma_v4
    return (
        15.0 * c_3 * c_3 * sigma_v6 + 16.0 * c_3 * sigma_v5 * t0 + mu * mu * within + sigma_v *
        (-0.31830988618379069 * level * mu * t6 * np.exp(-0.5 * level * level) + t2 * t5 + t5 * zeta) + sigma_v2 *
        (2.0 * c_2 * t3 + 12.0 * sigma_u4 * zeta_2 * zeta_2 + t2 * t4 + 4.0 * zeta * zeta) + sigma_v3 * (c_3 * t5 +
        t0 * t4 + t0 * t6) + sigma_v4 * (3.0 * c_2 * c_2 + t1 * t2 + t1 * zeta)
    )


def response(Omega: Any, k: Any, c: Any) -> tuple[Any, Any, Any]:
    """Z, and the slopes of -ln Z by ln k and ln c.

    Equation (3). Domain: Omega > 0, k > 0, c > 0. Operations: 10.
    """
    t0 = Omega * Omega
    t1 = c * c * t0
    t2 = k - t0
    Z = t1 + t2 * t2
    t3 = 2.0 / Z
    return Z, -k * t2 * t3, -t1 * t3


def white(S_0: Any, k: Any, c: Any) -> tuple[Any, Any]:
    """Mean squares of displacement and velocity of the linear oscillator under white noise.

    Equation (3). Domain: k > 0, c > 0. Operations: 3.
    """
    t0 = 3.1415926535897931 * S_0 / c
    return t0 / k, t0


def crossings(end: Any, sigma_u: Any, sigma_v: Any) -> Any:
    """How often in a unit of tau a Gaussian motion passes u = end or u = -end outwards.

    Equation Rice. Domain: sigma_u > 0, sigma_v > 0. Operations: 8.
    """
    return 0.31830988618379069 * sigma_v * np.exp(-0.5 * end * end / (sigma_u * sigma_u)) / sigma_u

#: functions that no Python code calls, which are in C, with their arguments; see generated/c/linearization.h
FROM_C = {
    "steepest": "ratio",
    "resonance": "theta k c slope G E_re E_im D_re D_im",
}
globals().update(from_c("linearization", FROM_C))
