"""The equation of motion. Takes a motion; returns its rates and their derivatives by state and parameters."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from mpmath import mp, mpf

from tests.oracles.definitions.points import Definitions


def rates_by_tau(cosine, v, F_0, zeta, friction, f):
    """u' and u'' of (3)."""
    return [v, F_0 * cosine - 2 * zeta * v - friction - f]


def rates_by_theta(cosine, v, Omega, F_0, zeta, friction, f):
    """theta = Omega tau."""
    return [rate / Omega for rate in rates_by_tau(cosine, v, F_0, zeta, friction, f)]


def matrix(f: Callable, at: Sequence) -> list:
    """The derivatives of each of f's two values by each argument, row by row."""

    def by(k, row):
        return mp.diff(lambda x: f(*at[:k], x, *at[k + 1 :])[row], at[k])

    return [by(k, row) for row in (0, 1) for k in range(len(at))]


def push(cosine, F_0, f):
    """The friction that keeps a mass at rest from accelerating."""
    return mp.findroot(lambda friction: rates_by_tau(cosine, 0, F_0, 0, friction, f)[1], mpf(1))


def push_slopes(cosine, sine, F_0, f_u):
    turned = mp.diff(lambda x: push(cosine * mp.cos(x) - sine * mp.sin(x), F_0, 0), 0)
    return [turned, mp.diff(lambda x: push(cosine, F_0, f_u * x), 0), mp.diff(lambda x: push(cosine, x, 0), F_0)]


def rates_by_state(Omega, zeta, f_u):
    return matrix(lambda u, v: rates_by_theta(0, v, Omega, 0, zeta, 0, f_u * u), (mpf(0), mpf(0)))


def rates_by_parameter(cosine, v, Omega, *others):
    return matrix(lambda *x: rates_by_theta(cosine, v, *x), (Omega, *others))


def smoothed(cosine, v, F_0, mu, zeta, left, right, slip, inner, outer):
    force = inner * (left - right) + outer * (1 - left + right)
    return rates_by_tau(cosine, v, F_0, zeta, mu * slip, force)


def smoothed_by_state(mu, zeta, nu, left, right, slip, inner, outer, inner_u, outer_u):
    """By differentiating logistic functions and tanh that have these values."""

    def shifted(value, x):
        return 1 / (1 + (1 / value - 1) * mp.exp(-nu * x))

    def rates(u, v):
        steps = shifted(left, u), shifted(right, u), mp.tanh(mp.atanh(slip) + nu * v)
        return smoothed(0, v, 0, mu, zeta, *steps, inner + inner_u * u, outer + outer_u * u)

    return matrix(rates, (mpf(0), mpf(0)))


def resisting(v, zeta, friction, quadratic, c_3, zeta_2, u):
    """By the derivatives of all that resists."""

    def whole(v, u):
        return 2 * (zeta + zeta_2 * u**2) * v + friction + quadratic * v**2 + c_3 * v**3

    by_v, by_u = (mp.diff(whole, (v, u), order) for order in ((1, 0), (0, 1)))
    return [whole(v, u) - 2 * zeta * v, by_v / 2, by_u]


def passed_on(Omega, A_1, F_0, phi):
    """The first harmonic of the force less the acceleration of A_1 cos(theta + phi), by its Fourier integrals."""

    def passed(theta):
        return F_0 * mp.cos(theta) - mp.diff(lambda t: A_1 * mp.cos(t + phi), theta, 2) * Omega**2

    # the trapezoidal rule is exact for harmonics
    angles = [2 * mp.pi * k / 8 for k in range(8)]
    return mp.hypot(*(sum(passed(t) * f(t) for t in angles) / 4 for f in (mp.cos, mp.sin))) / F_0


def of_structural(Omega, eta):
    """By the work of a cycle of amplitude 1: pi eta, and that of a damper 2 zeta u'; and its slope."""

    def zeta(at):
        cycle = [2 * mp.pi * k / (8 * at) for k in range(8)]
        return mp.pi * eta / sum(2 * mp.diff(lambda t: mp.cos(at * t), t) ** 2 * mp.pi / (4 * at) for t in cycle)

    return [zeta(Omega), mp.diff(zeta, Omega)]


def stopping(Omega, A, mu):
    return [mu / abs(mp.diff(lambda t: A * mp.cos(Omega * t), 0, 2))]


def passed_edge(before, after, v):
    """What v is of u that is ahead by d: it meets the edge the earlier, and has what follows it for as long."""

    def later(d):
        tau = mp.findroot(lambda s: d + v * s + before * s**2 / 2, -d / v) if d else mpf(0)
        return v + before * tau - after * tau

    return mp.diff(later, 0)


def turned_round(before, after):
    """What is left of v that is larger by d: it vanishes the later."""
    return mp.diff(lambda d: after * (0 - mp.findroot(lambda s: d + before * s, -d / before)) if d else mpf(0), 0)


def broken_away(after, Omega, by_theta, by_u):
    """What v is of u that is ahead by d: the push is as large as friction at another time."""

    def later(d):
        tau = mp.findroot(lambda s: by_u * d + by_theta * Omega * s, mpf(0)) if d else mpf(0)
        return after * (0 - tau)

    return mp.diff(later, 0)


def falling(order):
    """Time after which what has that derivative, and no lower one, is `far` from where it began."""
    return lambda far, rate: [
        mp.findroot(lambda s: rate * s**order / mp.factorial(order) - far, mp.root(far / rate, order))
    ]


MOTION: Definitions = {
    "push": ("cosine F_0 f", lambda *x: [push(*x)]),
    "push_slopes": ("cosine sine F_0 f_u", push_slopes),
    "breakaway": ("F_0 mu f", lambda F_0, mu, f: [mp.findroot(lambda cosine: push(cosine, F_0, f) - mu, mpf(1))]),
    "acceleration": ("cosine v F_0 zeta mu f", lambda *x: [rates_by_tau(*x)[1]]),
    "rates": ("cosine v Omega F_0 zeta mu f", rates_by_theta),
    "rates_by_state": ("Omega zeta f_u", rates_by_state),
    "rates_by_parameter": ("cosine v Omega F_0 zeta mu f", rates_by_parameter),
    "smoothed": ("cosine v F_0 mu zeta left right slip inner outer", smoothed),
    "smoothed_by_state": ("mu zeta nu left right slip inner outer inner_u outer_u", smoothed_by_state),
    "resistance": ("v zeta friction quadratic c_3 zeta_2 u", resisting),
    "transmissibility": ("Omega A_1 F_0 phi", lambda *x: [passed_on(*x)]),
    "stopping": ("Omega A mu", stopping),
    "structural": ("Omega eta", of_structural),
    "across": ("before after v", lambda *x: [passed_edge(*x)]),
    "turned": ("before after", lambda *x: [turned_round(*x)]),
    "released": ("after Omega by_theta by_u", lambda *x: [broken_away(*x)]),
    "out": ("beyond pull", falling(2)),
    "back": ("beyond growth", falling(3)),
}
