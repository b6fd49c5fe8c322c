"""Every compiled question once and again. Takes a folder with extension modules built for it; returns answers unread.

Run by `tests/native/test_sanitized.py` with modules that report what C must not do: python -m tests.native.asked FOLDER
"""

from __future__ import annotations

import importlib.util
import itertools
import math
import sys
import warnings
from pathlib import Path

import numpy as np

FOLDER = Path(sys.argv[1])


class Finder:
    """Finds the package's extension modules in the folder."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        file = FOLDER / f"{name}.so"
        return importlib.util.spec_from_file_location(name, file) if file.exists() else None


sys.meta_path.insert(0, Finder)
sys.modules["flint"] = None  # what balls are asked takes minutes, and nothing of it is compiled here
warnings.simplefilter("ignore")

from slowflow import Duffing, Isolator, backend  # noqa: E402
from slowflow.support.errors import SlowflowError  # noqa: E402

assert Path(backend.SOLVER.__file__).parent == Path(backend.EXACT.__file__).parent == FOLDER

#: usual numbers, and those at which formulas break
NUMBERS = [0.0, 5e-324, 1e-300, 1e-12, 0.01, 0.3, 1 - 2**-53, 1.0, 2.0, 1e12, 1e300]

#: some of them for an oscillator, others for the next
FORCINGS = itertools.cycle([(1e-300, 0.04, 5.0), (1e-3, 0.3, 1e300)])
LARGEST = itertools.cycle([0.5, 3.0, 1e6])
CURVES = itertools.cycle([(2, (0.0, 2.0)), (100, (0.3, 1.5)), (30, (0.0, 1e9)), (50, (0.9, 1.1))])


def asked(oscillator):
    """All averaged questions at some forcings."""
    yield oscillator.saddle_node_onset
    yield oscillator.detachment
    A_max = next(LARGEST)
    yield lambda: oscillator.cusps(A_max=A_max)
    yield lambda: oscillator.isola_points(A_max=A_max)
    yield lambda: oscillator.fold_locus(A_max=A_max, samples=50)
    for F_0 in next(FORCINGS):
        yield lambda F_0=F_0: oscillator.saddle_nodes(F_0)
        yield lambda F_0=F_0: oscillator.certify(F_0, Omega=0.7)
        yield lambda F_0=F_0: oscillator.peak(F_0)
        yield lambda F_0=F_0: oscillator.amplitudes(Omega=[1e-9, 0.7, 1.0, 40.0], F_0=F_0).gradient()
        yield lambda F_0=F_0: oscillator.saddle_nodes(F_0).gradient()
        yield lambda F_0=F_0: oscillator.peak(F_0).gradient()
        samples, window = next(CURVES)
        yield lambda F_0=F_0, n=samples, w=window: oscillator.frequency_response(F_0, samples=n, Omega=w)
        yield lambda F_0=F_0, w=window: oscillator.second_approximation.frequency_response(F_0, samples=40, Omega=w)
        yield lambda F_0=F_0: oscillator.second_approximation.saddle_nodes(F_0)


def asked_beyond(oscillator):
    """Other questions of the second approximation, and gradients of what has no forcing."""
    second = oscillator.second_approximation
    yield second.saddle_node_onset
    yield second.detachment
    for F_0 in next(FORCINGS):
        yield lambda F_0=F_0: second.peak(F_0)
        yield lambda F_0=F_0: second.amplitudes(Omega=[0.7, 1.0], F_0=F_0)
    yield lambda: oscillator.saddle_node_onset().gradient()
    yield lambda: oscillator.detachment().gradient()


def asked_moving(oscillator):
    """Exact motions of other laws, other excitations and of what stands under a load, and states they begin at."""
    yield lambda: oscillator.amplitudes(Omega=[0.7, 1.0], F_0=0.05)
    yield lambda: oscillator.steady_state(Omega=0.9, F_0=0.05)
    yield lambda: oscillator.exact_response(0.05, Omega=(0.9, 1.0), step=0.1)
    yield lambda: oscillator.sweep(Omega=[0.9, 1.0], F_0=0.05)
    yield lambda: oscillator.transient(acceleration=0.2, duration=2.0, after=1.0)
    yield lambda: oscillator.shock_spectrum(acceleration=0.2, duration=[1.0, 2.0])
    yield lambda: oscillator.random(S_0=1e-3)
    yield lambda: oscillator.random(psd=([0.5, 2.0], [1e-3, 1e-3]))


def ask_many(many, F_0):
    """Compiled questions about many designs, and gradients."""
    for name in ("detachment", "saddle_node_onset"):
        tried(lambda: getattr(many, name)().gradient())  # noqa: B023
    tried(lambda: many.peak(F_0).gradient())
    tried(lambda: many.saddle_nodes(F_0, places=1).gradient())
    tried(lambda: many.amplitudes(Omega=0.9, F_0=F_0, places=2).gradient())
    tried(lambda: many.frequency_response(F_0, samples=30, places=1))


def tried(question):
    """Refusals are answers too."""
    try:
        question()
    except SlowflowError:
        return


def main():
    rng = np.random.default_rng(3)
    for force, mu, zeta in itertools.product(("truncated", "untruncated"), (0.0, 0.01), (0.0, 1e-9, 0.03)):
        for lam, r, delta_h in ((3, 2.0, 0.08), (2, 1.0, 0.499999), (3, 2, 0.4), (1, 0.5, 0.0), (1, 1, 0.999)):
            for question in asked(Isolator(lam=lam, r=r, delta_h=delta_h, mu=mu, zeta=zeta, force=force)):
                tried(question)
    for excitation, mu, zeta in itertools.product(("base", "unbalance"), (0.0, 0.01), (1e-9, 0.03)):
        given = dict(mu=mu, zeta=zeta, excitation=excitation)
        for oscillator in (Isolator(lam=3, r=2.0, delta_h=0.08, **given), Duffing(1.0, 0.3, **given)):
            for question in asked(oscillator):
                tried(question)
    for excitation, force in itertools.product(("force", "base"), ("truncated", "untruncated")):
        for delta_h, mu in ((0.08, 0.0), (0.3, 0.01)):
            beyond = Isolator(lam=3, r=2, delta_h=delta_h, mu=mu, zeta=0.03, force=force, excitation=excitation)
            for question in asked_beyond(beyond):
                tried(question)
    for more in ({"eta": 0.05}, {"c_2": 0.05}, {"c_2": 0.05, "excitation": "base"}, {"load": 0.01}, {"mu_s": 0.02}):
        for question in asked_moving(Isolator(lam=3, r=2, delta_h=0.08, mu=0.01, zeta=0.05, **more)):
            tried(question)
    off = Isolator(lam=3, r=2, delta_h=0.08, mu=0.01, zeta=0.05).off_centre
    off.rest(), off.detachment(), off.amplitudes(Omega=0.9, F_0=0.05)
    few = Isolator(lam=3, r=2, delta_h=0.08, mu=0.01, zeta=0.05, load=0.03)
    few.saddle_nodes(0.05), few.saddle_node_onset(), few.peak(0.05), few.frequency_response(0.05)
    edge = np.zeros(2)
    backend.SOLVER.ends(np.zeros(7), edge, edge, edge, 0.0, 0), backend.SOLVER.step_means(1.0, 0.0, 0, 3, np.empty(200))
    for alpha, beta, mu, zeta in itertools.product((-0.5, 0.0, 1.0), (-0.3, 0.0, 2.0, 1e200), (0.0, 0.02), (0.0, 0.05)):
        for question in asked(Duffing(alpha, beta, mu, zeta)):
            tried(question)
    designs = [np.array([*NUMBERS, math.nan, math.inf, -1.0])[rng.integers(0, 14, 1000)] for _ in range(6)]
    for force in ("truncated", "untruncated"):
        many = Isolator.many(**dict(zip(("lam", "r", "delta_h", "mu", "zeta"), designs, strict=False)), force=force)
        ask_many(many, designs[5])
        many.certify(designs[5]), many.certify(designs[5], Omega=0.7)
        few = Isolator.many(lam=3, r=2, delta_h=[0.05, 0.3], mu=0.01, zeta=0.05, force=force)
        second = few.second_approximation
        second.detachment(), second.saddle_node_onset(), second.peak(0.05), second.saddle_nodes(0.05, places=1)
        second.amplitudes(Omega=0.9, F_0=0.05, places=1), second.frequency_response(0.05, samples=30)
    for excitation in ("force", "base", "unbalance"):
        names = dict(zip(("lam", "r", "delta_h", "mu", "zeta"), (one[:30] for one in designs), strict=False))
        part, F_0 = Isolator.many(**names, excitation=excitation), designs[5][:30]
        ask_many(part, F_0), part.margins(F_0), part.hysteresis(F_0)
    for more in ({"load": [0.01, math.nan]}, {"c_2": [0.05, -1.0]}):  # of these exact motions alone are compiled
        few = Isolator.many(lam=3, r=2, delta_h=0.08, mu=0.01, zeta=0.05, **more)
        few.shock_spectrum(acceleration=0.2, duration=2.0), few.transient(acceleration=0.2, duration=2.0)
    for zeta, mu in ((0.05, 0.0), (0.05, 0.02), (0.3, 0.03)):
        isolator = Isolator(lam=3, r=1.5, delta_h=0.15, mu=mu, zeta=zeta)
        for force in ("truncated", "untruncated"):
            tried(lambda: isolator.exact_response(0.06, Omega=(0.4, 1.6), force=force))  # noqa: B023
            tried(lambda: isolator.sweep(Omega=[0.5, 0.9, 1.0, 1.2], F_0=0.05, force=force))  # noqa: B023
            tried(lambda: isolator.steady_state(Omega=0.2, F_0=0.05, A=3.0, force=force))  # noqa: B023
    tried(lambda: Duffing(1.0, -1.0, 0.0, 0.01).steady_state(Omega=0.5, F_0=2.0))  # escapes
    Duffing.many(1.0, [-1.0, 0.0], 0.0, 0.05).transient(acceleration=3.0, duration=3.0)  # one does too
    designs = Isolator.many(lam=3, r=2.0, delta_h=np.linspace(0.0, 0.15, 7)[:, None], mu=[0.0, 0.02], zeta=0.02)
    designs.random(S_0=1e-3), Duffing.many(1.0, [-1.0, 0.0], 0.0, 0.05).random(S_0=[[1e-3], [0.1]], places=1)
    designs.transient(acceleration=[0.0, 0.5, -0.5], tau=[0.0, 1.0, 2.0], workers=2)


if __name__ == "__main__":
    main()
    print("asked")
