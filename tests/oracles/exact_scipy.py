"""Half a turn of the equation of motion (3) by SciPy's integrator, the force typed in: a maximum in, a state out.

Shares no continuation, switching or integrator with the package. For motions without stops.
"""

import math

from scipy.integrate import solve_ivp


def half_turn(A, theta, Omega, F_0, mu, zeta, force, u_cr):
    """(u, v) half a turn after a maximum A at phase theta, by SciPy, the force typed in; split where |u| = u_cr."""
    attached, detached = force
    tau, end, y = 0.0, math.pi / Omega, [A, 0.0]
    while tau < end:
        outside = abs(y[0]) > u_cr or (abs(abs(y[0]) - u_cr) < 1e-13 and y[0] < 0)
        piece = detached if outside else attached

        def field(t, y, piece=piece):
            return [y[1], F_0 * math.cos(Omega * t + theta) - 2 * zeta * y[1] - piece(y[0]) + mu]

        level = u_cr if y[0] > u_cr else -u_cr

        def edge(t, y, level=level):
            return y[0] - level

        edge.terminal, edge.direction = True, -1
        events = None if outside and y[0] < 0 else [edge]
        run = solve_ivp(field, (tau, end), y, method="DOP853", rtol=1e-12, atol=1e-14, events=events)
        tau, y = float(run.t[-1]), list(run.y[:, -1])
        if run.status == 1:
            y[0] = level - 1e-15 if level < 0 else level * (1 - 1e-14)
    return y
