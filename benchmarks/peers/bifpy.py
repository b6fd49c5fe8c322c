"""bifpy: AUTO-07p from Python. Needs gfortran and make to install, and gfortran to compile a model."""

NAME = "AUTO-07p via bifpy"
PACKAGES = ("bifpy",)
PROGRAMS = ("gfortran", "make")
WHAT = "continuation of the equilibria of the slow flow, with the tool's fold detection"

STEPS = {"large steps": (0.005, 0.01), "small steps": (0.001, 0.003)}


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    from bifpy import auto

    from benchmarks.peers.problem import OMEGA_MAX, OMEGA_MIN, START_A, START_PHI, answer, slow_flow

    def flow(state, parameters):
        return list(slow_flow(state[0], state[1], parameters[0]))

    def start(state, parameters, _):
        state[0], state[1], parameters[0] = START_A, START_PHI, OMEGA_MIN

    def curve(steps, compiled):
        ds, ds_max = steps
        settings = {
            "ips": auto.IPS_EQUILIBRIUM,
            **{"ndim": 2, "npar": 1, "nmx": 5000, "npr": 5000, "ilp": 1, "isp": 1, "jac": 0},
            **{"iads": 1, "itmx": 12, "itnw": 7, "nwtn": 3, "ds": ds, "dsmin": 1e-7, "dsmax": ds_max},
            **{"rl0": OMEGA_MIN - 0.1, "rl1": OMEGA_MAX, "a0": -1e300, "a1": 1e300},
            **{"epsl": 1e-11, "epsu": 1e-11, "epss": 1e-9},
        }
        found = auto.run(flow, start, settings, icu=[1], transpile=compiled)
        points = [point for branch in found.branches for point in branch.points]
        folds = [(p.parameters[0], p.state[0]) for p in points if p.point_type.name == "FOLD"]
        return len(points), folds

    return {
        f"{name}, {kind}": (lambda steps=steps, compiled=compiled: curve(steps, compiled), answer)
        for name, steps in STEPS.items()
        for kind, compiled in (("model in Python", False), ("model compiled", True))
    }
