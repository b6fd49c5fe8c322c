"""The equation of motion (3) by SciPy, the spring typed by hand. Takes its pull, an oscillator's damping and F_0.

Out come motions, or settled ones: means over a turn of the forcing, or the largest |u|. Shares no integrator and no
switching with the package.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

Pull = Callable[[float], float]


def odd_of(force: Callable[[Any], Any]) -> Pull:
    """A force for all u, of one for u > 0."""
    return lambda u: math.copysign(float(force(abs(u))), u)


def motion(pull: Pull, push: Pull, zeta: float, span: tuple[float, float], state: Any, **options: Any) -> Any:
    """u'' + 2 zeta u' + pull(u) = push(tau) over a span of tau from a state (u, u'), as SciPy has it."""

    def rates(tau: float, y: Any) -> Any:
        return y[1], push(tau) - 2 * zeta * y[1] - pull(y[0])

    return solve_ivp(rates, span, state, **{"method": "DOP853", "rtol": 1e-10, "atol": 1e-12, **options})


def settled(
    pull: Pull, push: Pull, zeta: float, Omega: float, state: Any, turns: float, last: int = 1, **options: Any
) -> Any:
    """Times, u and u' over the last turns, `turns` after a state, with which the forcing begins anew."""
    turn = 2 * np.pi / Omega
    begun = motion(pull, push, zeta, (0, turns * turn), state, **options).y[:, -1]
    grid = np.linspace(0, last * turn, 2000 * last + 1)
    return grid, *motion(pull, push, zeta, (0, last * turn), begun, t_eval=grid, **options).y


def _force(osc: Any, Omega: float, F_0: float) -> float:
    return F_0 * Omega**2 if osc.model.inertial else F_0


def last_turn(pull: Pull, osc: Any, Omega: float, F_0: float, start: Any, turns: int, samples: int = 1024) -> Any:
    """Times and u over one turn after many; friction turns round within a step."""
    period, force, zeta = 2 * np.pi / Omega, _force(osc, Omega, F_0), osc.zeta + osc.eta / (2 * Omega)

    def rates(tau: float, y: Any) -> Any:
        drag = 2 * zeta * y[1] + osc.mu * np.sign(y[1]) + osc.c_2 * abs(y[1]) * y[1]
        return y[1], force * np.cos(Omega * tau) + (osc.load or 0.0) - drag - pull(y[0])

    options = {"method": "LSODA", "rtol": 1e-10, "atol": 1e-12}
    last = solve_ivp(rates, (0, turns * period), start, max_step=period / 60, **options).y[:, -1]
    grid = period * (np.arange(samples) + 0.5) / samples
    return grid, solve_ivp(rates, (0, period), last, t_eval=grid, max_step=period / 200, **options).y[0]


def mean_and_first(pull: Pull, osc: Any, Omega: float, F_0: float, start: Any, turns: int) -> tuple[float, float]:
    """The mean and the first harmonic of that turn."""
    grid, u = last_turn(pull, osc, Omega, F_0, start, turns)
    return u.mean(), abs(2 * (u * np.exp(-1j * Omega * grid)).mean())


class Stretch(NamedTuple):
    """Of a motion between switches: times, u and u', the sign of the velocity, which is 0 at rest."""

    t: Any
    u: Any
    v: Any
    slip: float


def stretches(
    osc: Any,
    pull: Pull | Sequence[Pull],
    push: Pull,
    span: tuple[float, float],
    state: Any,
    preload: float = 0.0,
    **options: Any,
) -> Iterator[Stretch]:
    """u'' + damping + pull(u) = push(tau), all laws but structural damping, from switch to switch.

    These are breakpoints, at the first of which friction may end, turns, rests up to the break-loose force, and with a
    preload, which is added to the pull times the sign of u, the centre. A pull that jumps is one for each piece.
    """
    springs = [pull] * (1 + len(osc.breakpoints)) if callable(pull) else pull
    (t, end), (u, v), edges = span, map(float, state), osc.breakpoints
    beyond = [abs(u) > edge for edge in edges]
    side = np.sign(u) or np.sign(v) or np.sign(push(t))
    slip = np.sign(v)
    while t < end:
        spring = springs[sum(beyond)]

        def free(tau: Any, u: float = u, side: float = side, spring: Pull = spring) -> Any:
            return push(tau) - spring(u) - side * preload

        slides = osc.contact == "throughout" or not (beyond and beyond[0])
        if v == 0:
            if slides and abs(free(t)) <= osc.mu_s:
                later = np.linspace(t, end, 20_001)
                loose = np.flatnonzero(np.abs([free(tau) for tau in later]) > osc.mu_s)
                until = end
                if loose.size:
                    until = brentq(lambda tau: abs(free(tau)) - osc.mu_s, *later[[loose[0] - 1, loose[0]]], xtol=1e-14)
                yield Stretch(np.array([t, until]), np.array([u, u]), np.zeros(2), 0.0)
                t = until
                if t >= end:
                    return
            slip = np.sign(free(t))

        own = {"slip": slip, "mu": osc.mu * slides, "side": side, "spring": spring}

        def field(tau: float, y: Any, slip: float, mu: float, side: float, spring: Pull) -> Any:
            viscous = 2 * (osc.zeta + osc.zeta_2 * y[0] ** 2) + osc.c_3 * y[1] ** 2
            resists = viscous * y[1] + slip * (osc.c_2 * y[1] ** 2 + mu)
            return [y[1], push(tau) - spring(y[0]) - side * preload - resists]

        # at a start on a switch the value is a rounding: only the way back across it counts
        events = [lambda tau, y: y[1], lambda tau, y: y[0] if preload else 1.0]
        events += [lambda tau, y, edge=edge: abs(y[0]) - edge for edge in edges]
        for event, way in zip(events, (-slip, -side, *(-1 if one else 1 for one in beyond)), strict=True):
            event.terminal, event.direction = True, way  # type: ignore[attr-defined]
        precise = {"method": "DOP853", "rtol": 1e-9, "atol": 1e-12, **options}
        found = solve_ivp(partial(field, **own), (t, end), [u, v or slip * 1e-15], events=events, **precise)
        yield Stretch(found.t, *found.y, slip)
        t, (u, v) = float(found.t[-1]), map(float, found.y[:, -1])
        turned, centred, *passed = (times.size > 0 for times in found.t_events)
        if turned:
            v = 0.0
        elif centred:
            side = -side
            u = side * 1e-15
        beyond = [one != other for one, other in zip(beyond, passed, strict=True)]
        for edge, out, passes in zip(edges, beyond, passed, strict=True):
            if passes:  # off the switch: a motion that touches it would be on either side by turns
                u = np.sign(u) * edge * (1 + (1e-14 if out else -1e-14))


def turns_of(by_hand: Any, mu_zeta: Any, Omega: float, F_0: float, start: Any, turns: float, **options: Any) -> Any:
    """(u, u') some turns after (tau, u, u'), the largest |u|, and how many rests; pieces and their ends by hand."""
    (pieces, ends), (tau, *state), (mu, zeta) = by_hand, start, mu_zeta
    osc = SimpleNamespace(
        breakpoints=ends, contact="throughout", mu=mu, mu_s=mu, zeta=zeta, zeta_2=0.0, c_2=0.0, c_3=0.0
    )
    span, push = (tau, tau + turns * 2 * np.pi / Omega), lambda at: F_0 * np.cos(Omega * at)
    precise = {"rtol": 1e-12, "atol": 1e-14, **options}
    ways = list(stretches(osc, pieces, push, span, state, **precise))
    farthest = max(float(np.abs(one.u).max()) for one in ways)
    # a start that is just left may be called a rest within rounding
    stops = sum(one.slip == 0 and np.ptp(one.t) > 1e-9 for one in ways)
    return (ways[-1].u[-1], ways[-1].v[-1]), farthest, stops


def largest(pull: Pull, osc: Any, Omega: float, F_0: float, turns: int, preload: float = 0.0) -> float:
    """The largest |u| in the last tenth of many turns, for motions that never rest."""
    force, end, most = _force(osc, Omega, F_0), turns * 2 * np.pi / Omega, 0.0
    damped = osc.replace(eta=0.0, zeta=osc.zeta + osc.eta / (2 * Omega)) if osc.eta else osc
    start = np.array([preload > 0, preload > 0]) * 1e-3
    for one in stretches(damped, pull, lambda tau: force * np.cos(Omega * tau), (0.0, end), start, preload):
        assert one.slip
        if one.t[-1] > 0.9 * end:
            most = max(most, np.abs(one.u).max())
    return most


def shock(
    osc: Any, pull: Pull, acceleration: float, duration: float, end: float, step: float = 0.02
) -> tuple[float, float]:
    """The largest |u| and the largest force on the mass after a half sine of the base up to `end`."""

    def push(t: float) -> float:
        return -acceleration * math.sin(math.pi * t / duration) if t < duration else 0.0

    A, largest, state, options = 0.0, 0.0, (0.0, 0.0), {"rtol": 1e-11, "atol": 1e-13, "max_step": step}
    for span in ((0.0, duration), (duration, end)):
        for one in stretches(osc, pull, push, span, state, **options):
            A = max(A, np.abs(one.u).max())
            if one.slip:
                passed = [pull(u) + 2 * osc.zeta * v + osc.mu * one.slip for u, v in zip(one.u, one.v, strict=True)]
            else:  # the mass moves with its base
                passed = [push(t) for t in np.linspace(*one.t[[0, -1]], 200)]
            largest = max(largest, np.abs(passed).max())
            state = one.u[-1], one.v[-1]
    return A, largest
