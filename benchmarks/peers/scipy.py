"""SciPy's solvers as an engineer's script uses them: sweeps with `optimize.root`, and integration of a slow sweep."""

NAME = "SciPy"
PACKAGES = ("numpy", "scipy")
WHAT = "sweeps up and down; the unstable branch is not found"


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    import numpy as np
    from scipy.integrate import solve_ivp
    from scipy.optimize import root

    from benchmarks.peers.problem import OMEGA_MAX, OMEGA_MIN, START_A, START_PHI, answer, response, slow_flow

    def root_sweep(frequencies):
        """Up, then down; where the state jumps, a solution of F = F_A = 0 is sought from the last one before."""
        folds, points, state = [], 0, np.array([START_A, START_PHI])
        for grid in (np.linspace(OMEGA_MIN, OMEGA_MAX, frequencies), np.linspace(OMEGA_MAX, OMEGA_MIN, frequencies)):
            step = abs(grid[1] - grid[0])
            for Omega in grid:
                found = root(lambda x, Omega=Omega: slow_flow(x[0], x[1], Omega), state, tol=1e-13)
                new = found.x
                if not found.success or new[0] <= 0 or abs(new[0] - state[0]) > 0.2 * state[0]:
                    fold = root(lambda x: response(x[0], x[1]), (Omega, state[0]), tol=1e-12)
                    if fold.success and abs(fold.x[0] - Omega) < 2 * step:
                        folds.append(tuple(fold.x))
                    new = steady_state(Omega, state)
                state, points = new, points + 1
        return points, folds

    def steady_state(Omega, state):
        """The steady state reached in time after a jump."""
        state = solve_ivp(lambda _, x: slow_flow(x[0], x[1], Omega), (0, 1000), state, method="LSODA", rtol=1e-8)
        return state.y[:, -1]

    def integrated_sweep(rate):
        """Omega rises, then falls, with time; a jump is where A changes fastest."""
        folds, points, state = [], 0, np.array([START_A, START_PHI])
        for first, last in ((OMEGA_MIN, OMEGA_MAX), (OMEGA_MAX, OMEGA_MIN)):
            turn = np.sign(last - first) * rate
            found = solve_ivp(
                lambda t, x, first=first, turn=turn: slow_flow(x[0], x[1], first + turn * t),
                *((0, (last - first) / turn), state),
                **{"method": "LSODA", "rtol": 1e-8, "atol": 1e-10},
            )
            late = found.t > 100  # after the start's own transient
            fastest = np.argmax(np.where(late[1:], np.abs(np.diff(found.y[0]) / np.diff(found.t)), 0))
            folds.append((first + turn * found.t[fastest], found.y[0, fastest]))
            state, points = found.y[:, -1], points + found.t.size
        return points, folds

    return {
        "optimize.root, 500 frequencies each way": (lambda: root_sweep(500), answer),
        "solve_ivp (LSODA), sweep of 17000 time units each way": (lambda: integrated_sweep(1e-4), answer),
    }
