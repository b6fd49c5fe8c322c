"""The equation of motion of any mechanism, in the values of its force.

Written by `make derive` from derivations/paper/equation_of_motion.py, derivations/extensions/motion.py,
derivations/extensions/switching.py; never edit.

Rounding errors were measured with A, A_1, growth, pull, zeta_2 0.01 to 1; F_0 0.03 to 0.1; Omega 0.3 to 2; after,
before, by_theta, by_u, f, inner, outer, u, v up to 1 of either sign; beyond 0.001 to 0.1; c_3 0.05 to 2; cosine,
sine, slip up to 0.99 of either sign; eta 0.005 to 0.2; f_u, inner_u, outer_u up to 2 of either sign; friction, mu
0.001 to 0.02; left, right 0.01 to 0.99; nu 10 to 1000; phi 0.05 to 3.1 of either sign; quadratic up to 0.5 of
either sign; zeta 0.004 to 0.1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.support.backend import from_c

__all__ = [
    "acceleration", "across", "back", "breakaway", "out", "push", "push_slopes", "rates", "rates_by_parameter",
    "rates_by_state", "released", "resistance", "smoothed", "smoothed_by_state", "stopping", "structural",
    "transmissibility", "turned",
]


def push(cosine: Any, F_0: Any, f: Any) -> Any:
    """What friction has to hold at rest; cosine of theta = Omega tau.

    Equation (3). Domain: any. Operations: 2. Error / u (1 + kappa): proved 1.01.
    """
    return F_0 * cosine - f


def push_slopes(cosine: Any, sine: Any, F_0: Any, f_u: Any) -> tuple[Any, Any, Any]:
    """Derivatives of the push by theta, u, F_0.

    Equation (3). Domain: any. Operations: 1. Error / u (1 + kappa): proved 0.34, 0.0, 0.0.
    """
    return -F_0 * sine, -f_u, cosine


def breakaway(F_0: Any, friction: Any, f: Any) -> Any:
    """The cosine of theta at which a mass at rest breaks away against friction mu or -mu.

    Equation (3). Domain: F_0 > 0. Operations: 2. Error / u (1 + kappa): proved 3.01.
    """
    return (f + friction) / F_0


def acceleration(cosine: Any, v: Any, F_0: Any, zeta: Any, friction: Any, f: Any) -> Any:
    """u'' of a slipping mass; friction is mu sign(u').

    Equation (3). Domain: any. Operations: 6. Error / u (1 + kappa): proved 3.01.
    """
    return F_0 * cosine - f - friction - 2.0 * v * zeta


def resistance(v: Any, zeta: Any, friction: Any, quadratic: Any, c_3: Any, zeta_2: Any, u: Any) -> tuple[Any, Any, Any]:
    """Friction, quadratic damping, both times the sign of u', and the others; zeta by the slope of all by u'; and what the slope by u adds to f_u.

    Equation (3). Domain: any. Operations: 20. Error / u (1 + kappa): proved 5.01, 4.26, 0.51.
    """
    v2 = v * v
    t0 = u * u * zeta_2
    v3 = v * v2
    return (
        c_3 * v3 + friction + quadratic * v2 + 2.0 * t0 * v,
        1.5 * c_3 * v2 + quadratic * v + t0 + zeta,
        4.0 * u * v * zeta_2,
    )


def transmissibility(Omega: Any, A_1: Any, F_0: Any, phi: Any) -> Any:
    """Fundamental harmonic of what is passed on over F_0, where that of u is A_1 cos(theta + phi).

    Equation (3). Domain: F_0 > 0. Operations: 9. Error / u (1 + kappa): measured 1.3.
    """
    of_inertia = A_1 * Omega * Omega / F_0
    return np.hypot(of_inertia * np.cos(phi) + 1.0, of_inertia * np.sin(phi))


def stopping(Omega: Any, A: Any, mu: Any) -> Any:
    """Friction over the largest force of inertia of A cos(theta), by which the mass stops within the cycle.

    Equation (3). Domain: Omega > 0, A > 0. Operations: 3. Error / u (1 + kappa): proved 0.61.
    """
    turn = Omega * Omega
    return mu / (A * turn)


def structural(Omega: Any, eta: Any) -> tuple[Any, Any]:
    """The zeta of structural damping at one frequency, and its slope by Omega.

    Equation beside (3). Domain: Omega > 0. Operations: 4. Error / u (1 + kappa): proved 0.34, 0.51.
    """
    t0 = 0.5 * eta
    return t0 / Omega, -t0 / (Omega * Omega)


def rates(cosine: Any, v: Any, Omega: Any, F_0: Any, zeta: Any, friction: Any, f: Any) -> tuple[Any, Any]:
    """u and v by theta.

    Equation (3). Domain: Omega > 0. Operations: 9. Error / u (1 + kappa): proved 0.67, 5.01.
    """
    t0 = 1.0 / Omega
    return t0 * v, t0 * (F_0 * cosine - f - friction - 2.0 * v * zeta)


def rates_by_state(Omega: Any, zeta: Any, f_u: Any) -> tuple[Any, Any, Any, Any]:
    """Derivatives of the rates by u, v: of the first, then of the second.

    Equation (3). Domain: Omega > 0. Operations: 4. Error / u (1 + kappa): proved 0.0, 0.51, 0.67, 0.67.
    """
    t0 = 1.0 / Omega
    return 0.0, t0, -f_u * t0, -2.0 * t0 * zeta


def rates_by_parameter(cosine: Any, v: Any, Omega: Any, F_0: Any, zeta: Any, friction: Any, f: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]:
    """Derivatives of the rates by Omega, F_0, zeta, friction, f: of the first, then of the second.

    Equation (3). Domain: Omega > 0. Operations: 13. Error / u (1 + kappa): proved 6.01 at most.
    """
    t0 = 1.0 / (Omega * Omega)
    t1 = 2.0 * v
    t2 = 1.0 / Omega
    t3 = -t2
    return (
        -t0 * v,
        0.0, 0.0, 0.0, 0.0,
        -t0 * (F_0 * cosine - f - friction - t1 * zeta),
        cosine * t2,
        -t1 * t2,
        t3, t3,
    )


def smoothed(cosine: Any, v: Any, F_0: Any, mu: Any, zeta: Any, left: Any, right: Any, slip: Any, inner: Any, outer: Any) -> tuple[Any, Any]:
    """u and v by tau, smoothed: slip = tanh(nu v), left and right are logistic functions of nu (u +- u_cr).

    Equation (A1), (A2). Domain: any. Operations: 11. Error / u (1 + kappa): proved 0.0, -; measured 1.7.
    """
    weight = left - right
    return v, F_0 * cosine - mu * slip - outer - 2.0 * v * zeta - weight * (inner - outer)


def smoothed_by_state(mu: Any, zeta: Any, nu: Any, left: Any, right: Any, slip: Any, inner: Any, outer: Any, inner_u: Any, outer_u: Any) -> tuple[Any, Any, Any, Any]:
    """Derivatives of these rates by u, v: of the first, then of the second.

    Equation (A1), (A2). Domain: any. Operations: 18. Error / u (1 + kappa): proved 0.0, 0.0, -, 4.51; measured 0.9.
    """
    weight = left - right
    weight_u = -nu * weight * (left + right - 1.0)
    return (
        0.0, 1.0,
        -inner_u * weight - outer_u * (1.0 - weight) - weight_u * (inner - outer),
        -mu * nu * (1.0 - slip * slip) - 2.0 * zeta,
    )


def across(before: Any, after: Any, v: Any) -> Any:
    """What u' gains of a deviation of u where u'' changes at an edge.

    Equation beside (3). Domain: v other than 0. Operations: 2. Error / u (1 + kappa): proved 3.01.
    """
    return (after - before) / v


def released(after: Any, Omega: Any, by_theta: Any, by_u: Any) -> Any:
    """What u' is of a deviation of u where the push on a mass at rest, with these slopes, breaks it away.

    Equation beside (3). Domain: Omega > 0, by_theta other than 0. Operations: 3. Error / u (1 + kappa): proved
    0.61.
    """
    return after * by_u / (Omega * by_theta)


def out(beyond: Any, pull: Any) -> Any:
    """The time of a way beyond an edge, up to where a constant pull turns it.

    Equation beside (3). Domain: beyond >= 0, pull > 0. Operations: 3. Error / u (1 + kappa): measured 0.68.
    """
    square = 2.0 * beyond / pull
    return np.sqrt(square)


def back(beyond: Any, growth: Any) -> Any:
    """The time of the way back to it from rest, under a push that grows steadily from 0.

    Equation beside (3). Domain: beyond >= 0, growth > 0. Operations: 3. Error / u (1 + kappa): measured 0.85.
    """
    cube = 6.0 * beyond / growth
    return np.cbrt(cube)

#: functions that no Python code calls, which are in C, with their arguments; see generated/c/motion.h
FROM_C = {
    "turned": "before after",
}
globals().update(from_c("motion", FROM_C))
