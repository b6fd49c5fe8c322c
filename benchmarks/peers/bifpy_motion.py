"""bifpy: the exact motion of `benchmarks.motions` as a boundary value problem of AUTO-07p, by collocation.

Half a turn from stop to stop: friction has one sign there, so that nothing is smoothed. AUTO follows the motion over
F_0, its phase the second unknown, from a guess of two digits to the forcing that is asked, and writes ten digits.
"""

import math

from benchmarks.peers.problem import ALPHA, BETA, F_0, MU, ZETA

OMEGA, FROM_F_0 = 0.9, 0.041
GUESSED_A, GUESSED_PHASE = 0.13, 2.6
INTERVALS = (5, 10, 20)
HALF_A_TURN = math.pi / OMEGA


def flow(state, parameters):
    """Rates by the phase, a fraction of the half turn and the third unknown, on the way down."""
    u, v, phase = state
    force = u * (ALPHA + 2 * BETA * (1 / math.sqrt(1 - u * u) - 1))
    push = parameters[0] * math.cos(math.pi * phase + parameters[1])
    return [HALF_A_TURN * v, HALF_A_TURN * (push - force - 2 * ZETA * v + MU), 1.0]


def ends(left, right, _):
    """At rest at both ends, which are each other's opposite."""
    return [left[1], right[1], left[0] + right[0], left[2]]


def start(state, parameters, phase):
    """The guess."""
    angle = math.pi * phase
    state[:3] = GUESSED_A * math.cos(angle), -GUESSED_A * OMEGA * math.sin(angle), phase
    parameters[:2] = FROM_F_0, GUESSED_PHASE


def amplitude(intervals):
    """The amplitude at F_0."""
    from bifpy import auto

    settings = {
        "ips": auto.IPS_GENERAL_BVP,
        **{"ndim": 3, "nbc": 4, "nint": 0, "npar": 2, "ntst": intervals, "ncol": 4, "iad": 3, "nmx": 50, "npr": 50},
        **{"ilp": 0, "isp": 0, "jac": 0, "iads": 1, "itmx": 12, "itnw": 9, "nwtn": 3},
        **{"ds": -0.0005, "dsmin": 1e-7, "dsmax": 0.001, "rl0": 0.03, "rl1": 0.05, "a0": -1e300, "a1": 1e300},
        **{"epsl": 1e-11, "epsu": 1e-11, "epss": 1e-9},
    }
    found = auto.run(flow, start, settings, icu=[1, 2], bcnd=ends, uzstop={1: F_0})
    points = [point for branch in found.branches for point in branch.points]
    (point_at_F_0,) = (point for point in points if point.point_type.name == "USER_SPECIFIED_VALUE")
    return point_at_F_0.boundary_value_solution.state[0][0]


def of_amplitude(found):
    """The amplitude."""
    return {"found": [float(found)]}


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    return {
        f"motion | AUTO-07p via bifpy | {intervals} intervals": (
            lambda intervals=intervals: amplitude(intervals),
            of_amplitude,
        )
        for intervals in INTERVALS
    }
