"""The linear oscillator with dry friction (Den Hartog, zeta = 0) in closed form between switches: any stops.

In:  Omega, F_0, mu and a state at rest, as mpmath numbers.
Out: the state and the rests one turn of the forcing later, to the working precision.

u'' + u = F_0 cos(Omega tau) - slip mu has the solution V F_0 cos(Omega tau) - slip mu + B cos(tau) + C sin(tau).
"""

import mpmath as mp


def one_turn(Omega, F_0, mu, tau, u, slip):
    """(u, tau, stops) when a turn has passed; the mass starts at rest at (tau, u) and slips in direction `slip`."""
    V = 1 / (1 - Omega**2)
    end, stops = tau + 2 * mp.pi / Omega, 0
    while True:
        if slip == 0:
            tau, slip = _break_away(Omega, F_0, mu, tau, u)
            if tau >= end - mp.mpf(10) ** -9:
                return u, tau, stops
            continue
        motion, velocity = _slip(Omega, F_0, mu, V, tau, u, slip)
        stop = _first_stop(velocity, tau, end + 1, slip)
        tau, u = stop, motion(stop)
        push = F_0 * mp.cos(Omega * tau) - u
        if abs(push) <= mu:
            slip, stops = 0, stops + 1
        else:
            slip = -slip
            if tau >= end - mp.mpf(10) ** -9:
                return u, tau, stops


def _slip(Omega, F_0, mu, V, tau_0, u_0, slip):
    b = u_0 - V * F_0 * mp.cos(Omega * tau_0) + slip * mu
    c = V * F_0 * Omega * mp.sin(Omega * tau_0)

    def motion(tau):
        s = tau - tau_0
        return V * F_0 * mp.cos(Omega * tau) - slip * mu + b * mp.cos(s) + c * mp.sin(s)

    def velocity(tau):
        s = tau - tau_0
        return -V * F_0 * Omega * mp.sin(Omega * tau) - b * mp.sin(s) + c * mp.cos(s)

    return motion, velocity


def _first_stop(velocity, tau, end, slip):
    step = mp.mpf(1) / 200
    at = tau + step / 100
    while at < end:
        if slip * velocity(at + step) < 0:
            return mp.findroot(velocity, (at, at + step), solver="anderson")
        at += step
    raise AssertionError("no stop")


def _break_away(Omega, F_0, mu, tau, u):
    found = []
    for slip in (1, -1):
        cosine = (u + slip * mu) / F_0
        if abs(cosine) < 1:
            angle = -slip * mp.acos(cosine)
            turns = mp.ceil((Omega * tau - angle) / (2 * mp.pi))
            found.append(((angle + 2 * mp.pi * turns) / Omega, slip))
    return min(found)
