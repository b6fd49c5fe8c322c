"""mousai: harmonic balance by collocation in time, one harmonic, its Newton-Krylov solver at one frequency at a time.

It has no continuation: each frequency starts from the state at the one before, upwards and then downwards. A fold is
where such a walk leaves its branch, told by a step of the amplitude or by a solver that gives up.
"""

NAME = "mousai"
PACKAGES = ("mousai",)
WHAT = "solutions at single frequencies, upward and downward; folds where the amplitude jumps"

STEPS = {"large steps": 0.01, "small steps": 0.003}


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    import mousai
    import numpy as np
    from scipy.optimize import NoConvergence

    from benchmarks.peers.problem import F_0, OMEGA_MAX, OMEGA_MIN, START_A, START_PHI, ZETA, M, answer, averaged

    #: a step of the amplitude, as a part of the smaller one, that a branch does not make between neighbours
    JUMP = 0.2

    def acceleration(x, v, params):
        # with one harmonic A is the same at each time, and the averaged forces are those of a linear spring and damper
        Omega, t = params["omega"], params["cur_time"]
        A = np.hypot(x, v / Omega)
        k, m = -averaged(A) / A, M / A
        return np.array([F_0 * np.cos(Omega * t) - 2 * ZETA * v - k * x - m * v / Omega])

    def walk(frequencies, x):
        points, folds = 0, []
        before = None
        for Omega in frequencies:
            try:
                _, x_new, _, amplitude, _ = mousai.hb_time(acceleration, x, Omega, params={}, f_tol=1e-10, maxiter=40)
            except (NoConvergence, ValueError):
                x_new, amplitude = x, [np.nan]
            A = float(amplitude[0])
            if before is not None and not abs(A - before[1]) < JUMP * min(A, before[1]):
                folds.append(((Omega + before[0]) / 2, before[1]))
                if np.isnan(A):
                    break
            before = Omega, A
            x, points = x_new, points + 1
        return points, folds, x

    def curve(step):
        frequencies = np.arange(OMEGA_MIN, OMEGA_MAX, step)
        start = START_A * np.cos(2 * np.pi * np.arange(3) / 3 + START_PHI)[None]
        up, jumps_up, x = walk(frequencies, start)
        down, jumps_down, _ = walk(frequencies[::-1], x)
        return up + down, jumps_up + jumps_down

    return {name: (lambda step=step: curve(step), answer) for name, step in STEPS.items()}
