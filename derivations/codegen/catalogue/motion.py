"""The kernels of the equation of motion (3), for every integrator and kind of number.

In:  `Results`.
Out: `motion_module`.
"""

from __future__ import annotations

from dataclasses import replace

from ...extensions.motion import (
    A_1,
    cosine,
    f,
    f_u,
    friction,
    inner,
    inner_u,
    left,
    nu,
    outer,
    outer_u,
    quadratic,
    right,
    sine,
    slip,
    v,
)
from ...extensions.switching import after, before, beyond, by_theta, by_u, growth, pull
from ...kernels import plain
from ...results import Results
from ...symbols import F_0, A, Omega, eta, mu, phi, zeta
from ..form import Module

#: what the compiled integrator asks for
IN_C = (
    *("push", "push_slopes", "breakaway", "acceleration", "resistance"),
    *("across", "turned", "released", "rates_by_state", "rates_by_parameter", "structural"),
)


def motion_module(results: Results) -> Module:
    """The equation of motion and its derivatives; v = u', f and f_u are the whole restoring force and its slope."""
    sharp, smoothed, switching = results.motion, results.smoothed, results.switching
    known = (cosine, v, Omega, F_0, zeta, friction, f)
    kernels = (
        plain(
            "push",
            (cosine, F_0, f),
            sharp.push,
            "What friction has to hold at rest; cosine of theta = Omega tau.",
            "(3)",
            "any",
            generic=True,
        ),
        plain(
            "push_slopes",
            (cosine, sine, F_0, f_u),
            sharp.push_slopes,
            "Derivatives of the push by theta, u, F_0.",
            "(3)",
            "any",
            generic=True,
        ),
        plain(
            "breakaway",
            (F_0, friction, f),
            sharp.cosine,
            "The cosine of theta at which a mass at rest breaks away against friction mu or -mu.",
            "(3)",
            "F_0 > 0",
            generic=True,
        ),
        plain(
            "acceleration",
            (cosine, v, F_0, zeta, friction, f),
            sharp.acceleration,
            "u'' of a slipping mass; friction is mu sign(u').",
            "(3)",
            "any",
            generic=True,
        ),
        plain(
            "resistance",
            (v, zeta, friction, quadratic),
            sharp.resistance,
            "Friction and quadratic damping, both times the sign of u'; and the zeta of the slope of all by u'.",
            "(3)",
            "any",
            generic=True,
        ),
        plain(
            "transmissibility",
            (Omega, A_1, F_0, phi),
            sharp.transmissibility,
            "Fundamental harmonic of what is passed on over F_0, where that of u is A_1 cos(theta + phi).",
            "(3)",
            "F_0 > 0",
            lets=sharp.transmissibility_lets,
            generic=True,
        ),
        plain(
            "stopping",
            (Omega, A, mu),
            sharp.stopping,
            "Friction over the largest force of inertia of A cos(theta), by which the mass stops within the cycle.",
            "(3)",
            "Omega > 0, A > 0",
            lets=sharp.stopping_lets,
            generic=True,
        ),
        plain(
            "structural",
            (Omega, eta),
            sharp.structural,
            "The zeta of structural damping at one frequency, and its slope by Omega.",
            "beside (3)",
            "Omega > 0",
            generic=True,
        ),
        plain(
            "across",
            (before, after, v),
            switching.across,
            "What u' gains of a deviation of u where u'' changes at an edge.",
            "beside (3)",
            "v other than 0",
            generic=True,
        ),
        plain(
            "turned",
            (before, after),
            switching.turned,
            "What is left of a deviation of u' where the velocity changes its sign and u'' with it; 0 where the mass "
            "stops.",
            "beside (3)",
            "before other than 0",
            generic=True,
        ),
        plain(
            "released",
            (after, Omega, by_theta, by_u),
            switching.released,
            "What u' is of a deviation of u where the push on a mass at rest, with these slopes, breaks it away.",
            "beside (3)",
            "Omega > 0, by_theta other than 0",
            generic=True,
        ),
        plain(
            "out",
            (beyond, pull),
            switching.out,
            "The time of a way beyond an edge, up to where a constant pull turns it.",
            "beside (3)",
            "beyond >= 0, pull > 0",
            lets=switching.out_lets,
            generic=True,
        ),
        plain(
            "back",
            (beyond, growth),
            switching.back,
            "The time of the way back to it from rest, under a push that grows steadily from 0.",
            "beside (3)",
            "beyond >= 0, growth > 0",
            lets=switching.back_lets,
            generic=True,
        ),
        plain("rates", known, sharp.rates, "u and v by theta.", "(3)", "Omega > 0", generic=True),
        plain(
            "rates_by_state",
            (Omega, zeta, f_u),
            sharp.by_state,
            "Derivatives of the rates by u, v: of the first, then of the second.",
            "(3)",
            "Omega > 0",
            generic=True,
        ),
        plain(
            "rates_by_parameter",
            known,
            sharp.by_parameter,
            "Derivatives of the rates by Omega, F_0, zeta, friction, f: of the first, then of the second.",
            "(3)",
            "Omega > 0",
            generic=True,
        ),
        plain(
            "smoothed",
            (cosine, v, F_0, mu, zeta, left, right, slip, inner, outer),
            smoothed.rates,
            "u and v by tau, smoothed: slip = tanh(nu v), left and right are logistic functions of nu (u +- u_cr).",
            "(A1), (A2)",
            "any",
            lets=smoothed.lets,
            generic=True,
        ),
        plain(
            "smoothed_by_state",
            (mu, zeta, nu, left, right, slip, inner, outer, inner_u, outer_u),
            smoothed.by_state,
            "Derivatives of these rates by u, v: of the first, then of the second.",
            "(A1), (A2)",
            "any",
            lets=smoothed.lets,
            generic=True,
        ),
    )
    return Module(
        name="motion",
        title="The equation of motion of any mechanism, in the values of its force",
        inputs=("paper/equation_of_motion.py", "extensions/motion.py", "extensions/switching.py"),
        # the recurrences of `taylor` are the rates in C; only the paper's own way is smoothed
        kernels=tuple(replace(kernel, in_c=kernel.name in IN_C) for kernel in kernels),
    )
