"""The problem that every peer gets: Table 1 at F_0 = 0.04, averaged, in functions that need NumPy only.

In:  amplitude, phase, frequency. Out: averaged restoring force (21), (22), slow flow (19), F (24), F_A (30).

Written for the peers and independent of slowflow, so that a peer runs where slowflow is not installed: plain arithmetic
and NumPy functions, which bifpy can trace and numba can compile.
"""

import numpy as np

LAM, R_STIFF, DELTA_H = 3.0, 3747 / 1848, 1848 / (6 * 3747)
MU, ZETA, F_0 = 0.012, 0.02, 0.04
ALPHA = 1 - LAM * R_STIFF * DELTA_H
BETA = LAM / 2 * R_STIFF * (1 - DELTA_H)
GAMMA = 3 / 8 * LAM * R_STIFF * (1 - DELTA_H)
U_CR = (DELTA_H * (2 - DELTA_H)) ** 0.5
PI = float(np.pi)
M = 4 * MU / PI

#: the frequencies of the response, and a steady state at the first of them, from which a peer may start
OMEGA_MIN, OMEGA_MAX = 0.3, 2.0
START_A, START_PHI = 0.0858, -0.4200


def averaged(A):
    """h(A), on both sides of u_cr."""
    c_2, c_4, c_6, _ = detached(A)
    attached = -ALPHA * A - 0.75 * BETA * A**3 - 0.625 * GAMMA * A**5
    return attached + 4 / PI * ((ALPHA - 1) * A * c_2 + BETA * A**3 * c_4 + GAMMA * A**5 * c_6)


def detached(A):
    """Integrals of cos^2, cos^4, cos^6 over the detached part of a quarter cycle, and the sine of its end."""
    c = np.minimum(1.0, U_CR / A)
    s = np.sqrt(1 - c * c)
    c_2 = (np.arccos(c) + s * c) / 2
    c_4 = (3 * c_2 + s * c**3) / 4
    return c_2, c_4, (5 * c_4 + s * c**5) / 6, s


def averaged_A(A):
    """dh/dA; the force jumps at u_cr, which adds a term above it."""
    c_2, c_4, c_6, s = detached(A)
    h_A = -ALPHA - 2.25 * BETA * A**2 - 3.125 * GAMMA * A**4
    h_A += 4 / PI * ((ALPHA - 1) * c_2 + 3 * BETA * A**2 * c_4 + 5 * GAMMA * A**4 * c_6)
    if s > 0:
        h_A += 4 / PI * ((ALPHA - 1) * U_CR + BETA * U_CR**3 + GAMMA * U_CR**5) * U_CR**2 / (A**3 * s)
    return h_A


def slow_flow(A, phi, Omega):
    """A' and phi' (19), epsilon absorbed."""
    h = averaged(A)
    return (
        -(F_0 * np.sin(phi) + 2 * ZETA * Omega * A + M) / (2 * Omega),
        -(F_0 * np.cos(phi) + Omega * Omega * A + h) / (2 * Omega * A),
    )


def answer(found):
    """What an adapter's job tells: how many points, and (Omega, A) of each fold."""
    points, folds = found
    return {"points": int(points), "folds": [[float(x) for x in fold] for fold in folds]}


def response(Omega, A):
    """F (24) and F_A/2, whose sign is that of (30)."""
    h, h_A = averaged(A), averaged_A(A)
    R = A * Omega**2 + h
    friction = 2 * ZETA * A * Omega + M
    return R * R + (friction - F_0) * (friction + F_0), R * (Omega**2 + h_A) + 2 * ZETA * Omega * friction
