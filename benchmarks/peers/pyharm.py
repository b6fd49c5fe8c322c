"""pyHarm-os: harmonic balance with arc-length continuation, one harmonic, the averaged forces as an element of its own.

It has no fold detection: folds are the turning points of a parabola through the three points about each reversal.
"""

NAME = "pyHarm-os"
PACKAGES = ("pyHarm-os",)
WHAT = "continuation with one harmonic; folds interpolated between points of the curve"

STEPS = {"large steps": 0.01, "small steps": 0.003}


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    import logging

    import numpy as np
    from pyHarm.BaseUtilFuncs import pyHarm_plugin
    from pyHarm.Elements.NodeToNodeElements.NodeToNodeElement import NodeToNodeElement
    from pyHarm.Maestro import Maestro

    from benchmarks.peers.problem import (
        F_0,
        OMEGA_MAX,
        OMEGA_MIN,
        START_A,
        START_PHI,
        ZETA,
        M,
        answer,
        averaged,
        averaged_A,
    )

    class Averaged(NodeToNodeElement):
        """First harmonic of restoring force and dry friction, u = c cos + s sin."""

        factory_keyword = "Averaged"

        def __flag_update__(self):
            self.flag_nonlinear = True

        def adim(self, lc, wc):
            raise NotImplementedError

        def evalResidual(self, x, om):
            c, s = x[self.indices]
            A = np.hypot(c, s)
            k, m = -averaged(A) / A, M / A
            return np.array([k * c + m * s, k * s - m * c])

        def evalJacobian(self, x, om):
            c, s = x[self.indices]
            A = np.hypot(c, s)
            h, h_A = averaged(A), averaged_A(A)
            k, m = -h / A, M / A
            k_A, m_A = (-h_A - k) / A, -m / A
            radial = np.array([c, s]) / A
            force_A = np.array([k_A * c + m_A * s, k_A * s - m_A * c])
            self.J, self.dJdom = np.array([[k, m], [-m, k]]) + np.outer(force_A, radial), np.zeros(2)
            return self.J, self.dJdom

    logging.disable(logging.CRITICAL)
    pyHarm_plugin(Averaged)
    link = {"connect": {"mass": [0]}, "dirs": [0]}
    matrices = {"M": [[1.0]], "C": [[2 * ZETA]], "K": [[0.0]], "G": [[0.0]]}
    scene = {
        "system": {"type": "Base", "nh": [1], "nti": 64},
        "substructures": {"mass": {"matrix": {k: np.array(v) for k, v in matrices.items()}, "ndofs": 1}},
        "connectors": {
            "forcing": {"type": "CosinusForcing", "amp": F_0, **link},
            "averaged": {"type": "Averaged", **link},
        },
        "kinematics": {},
    }
    study = {
        **{"study": "frf", "solver": "scipyroot", "verbose": False},
        "solver_options": {"root": {"method": "hybr", "options": {"xtol": 1e-12}}, "residual_tolerance": 1e-9},
        **{"puls_inf": OMEGA_MIN, "puls_sup": OMEGA_MAX, "puls_start": OMEGA_MIN, "sign_ds": 1},
    }

    def curve(ds):
        maestro = Maestro({**scene, "analysis": {"frf": {**study, "ds_max": ds, "ds0": ds, "ds_min": 1e-7}}})
        maestro.operate(x0=START_A * np.array([np.cos(START_PHI), -np.sin(START_PHI)]))
        c, s, Omega = np.array([point.x for point in maestro.nls["frf"].SolList if point.flag_accepted]).T
        A = np.hypot(c, s)
        folds = []
        for i in np.flatnonzero(np.diff(Omega[1:]) * np.diff(Omega[:-1]) < 0) + 1:
            parabola = np.polyfit(A[i - 1 : i + 2] - A[i], Omega[i - 1 : i + 2], 2)
            top = -parabola[1] / (2 * parabola[0])
            folds.append((np.polyval(parabola, top), A[i] + top))
        return A.size, folds

    return {name: (lambda ds=ds: curve(ds), answer) for name, ds in STEPS.items()}
