"""Brute force for the equation of motion (3): small fixed steps, switches refined by bisection. For tests only.

In:  a force typed from the paper as pieces and breakpoints, mu, zeta, a forcing, a state.
Out: the states on a grid, and the number of rests met.

Shares nothing with the package: its own force, its own integration (classical Runge-Kutta in tau), its own switching.
"""

import math


def truncated(alpha, beta, gamma, u_cr):
    """Force (6) plus u: pieces, breakpoints."""
    return (lambda u: alpha * u + beta * u**3 + gamma * u**5, lambda u: u), (u_cr,)


def untruncated(lam, r, delta_h):
    """Force (5) plus u: pieces, breakpoints."""

    def attached(u):
        root = math.sqrt(1 - u * u)
        return u + lam * r * (1 - delta_h - root) * u / root

    return (attached, lambda u: u), (math.sqrt(1 - (1 - delta_h) ** 2),)


def follow(force, mu, zeta, Omega, F_0, tau, u, v, turns, steps):
    """(u, v) after each of `steps` equal steps a turn of the forcing, from (tau, u, v), and how many stops."""
    pieces, breakpoints = force
    h = 2 * math.pi / Omega / steps

    def index(at):
        return sum(abs(at) > b for b in breakpoints)

    def push(at, where, piece):
        return F_0 * math.cos(Omega * at) - pieces[piece](where)

    def step(at, u, v, size, slip, piece):
        def acceleration(t, x, y):
            return push(t, x, piece) - 2 * zeta * y - slip * mu

        k1u, k1v = v, acceleration(at, u, v)
        k2u, k2v = v + size / 2 * k1v, acceleration(at + size / 2, u + size / 2 * k1u, v + size / 2 * k1v)
        k3u, k3v = v + size / 2 * k2v, acceleration(at + size / 2, u + size / 2 * k2u, v + size / 2 * k2v)
        k4u, k4v = v + size * k3v, acceleration(at + size, u + size * k3u, v + size * k3v)
        return u + size / 6 * (k1u + 2 * k2u + 2 * k3u + k4u), v + size / 6 * (k1v + 2 * k2v + 2 * k3v + k4v)

    def bisect(happened, size):
        low, high = 0.0, size
        while high - low > 1e-15 * max(1.0, abs(tau)):
            middle = (low + high) / 2
            if middle in (low, high):
                break
            low, high = (low, middle) if happened(middle) else (middle, high)
        return high

    tau, u, v = float(tau), float(u), float(v)
    states, stops = [], 0
    piece = index(u)
    slip = (v > 0) - (v < 0)
    if slip == 0 and abs(push(tau, u, piece)) > mu:
        slip = 1 if push(tau, u, piece) > 0 else -1
    start = tau
    for n in range(round(turns * steps)):
        target = start + (n + 1) * h
        while target - tau > 1e-14:
            size = target - tau
            if slip == 0:
                free = lambda s: abs(push(tau + s, u, piece)) > mu  # noqa: B023, E731
                if not free(size):
                    tau = target
                    continue
                tau += bisect(free, size)
                slip = 1 if push(tau, u, piece) > 0 else -1
                continue
            started = v == 0.0

            def ended(s):
                x, y = step(tau, u, v, s, slip, piece)  # noqa: B023
                return (slip * y < 0) or index(x) != piece  # noqa: B023

            if started and slip * step(tau, u, v, 1e-6, slip, piece)[1] <= 0:
                slip, stops = 0, stops + 1
                tau += 1e-6
                continue
            if not ended(size):
                u, v = step(tau, u, v, size, slip, piece)
                tau = target
                continue
            part = bisect(ended, size)
            x, y = step(tau, u, v, part, slip, piece)
            tau, u = tau + part, x
            if index(x) != piece:
                v, piece = y, index(x)
                continue
            v = 0.0
            sticks = abs(push(tau, u, piece)) <= mu and mu > 0
            slip, stops = (0, stops + 1) if sticks else (-slip, stops)
        states.append((u, v))
    return states, stops
