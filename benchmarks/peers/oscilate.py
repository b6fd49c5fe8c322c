"""OSCILATE: the method of multiple scales in SymPy, which derives a slow flow and solves it for the frequency.

Its forces are polynomials. Dry friction ends in an IndexError of its own, springs that leave cannot be stated: it gets
the attached springs without friction, which is another oscillator. What it derives is timed, as that is its work.
"""

NAME = "OSCILATE"
PACKAGES = ("oscilate",)
WHAT = "derives the slow flow with attached springs and without friction; frequencies from its formula"

#: amplitudes at which the formula is evaluated
SAMPLES = 300


def prepare():
    """Variants by name; see `benchmarks.remote`."""
    import contextlib
    import io

    import numpy as np
    import sympy as sp
    from oscilate.MMS import Dynamical_system, Multiple_scales_oscillator, Steady_state
    from oscilate.MMS.mms import scale_parameters

    from benchmarks.peers.problem import ALPHA, BETA, F_0, GAMMA, ZETA, answer

    def derived():
        """Omega - omega_0 at an amplitude, below and above the resonance, with numbers put in."""
        t, epsilon, *parameters = sp.symbols("t epsilon omega_0 F c beta gamma", positive=True)
        omega_0, F, c, beta, gamma = parameters
        x = sp.Function("x", real=True)(t)
        motion = x.diff(t, 2) + omega_0**2 * x + c * x.diff(t) + beta * x**3 + gamma * x**5
        scaled, scaling = scale_parameters([c, beta, gamma, F], [1, 1, 1, 1], epsilon)
        with contextlib.redirect_stdout(io.StringIO()):
            system = Multiple_scales_oscillator(
                Dynamical_system(t, x, motion, omega_0, F=F), epsilon, 1, omega_0, scaling
            )
            system.apply_MMS()
            steady = Steady_state(system)
            steady.solve_forced(solve_dof=0)
        numbers = {omega_0: ALPHA**0.5, epsilon: 1}
        numbers |= dict(zip(scaled, (2 * ZETA, BETA, GAMMA, F_0), strict=True))
        detunings = [detuning.subs(numbers) for detuning in steady.sol_forced.sigma]
        (amplitude,) = {symbol for detuning in detunings for symbol in detuning.free_symbols}
        return sp.lambdify(amplitude, detunings, "numpy")

    def curve(detunings):
        A = np.linspace(0, F_0 / (2 * ZETA * ALPHA**0.5), SAMPLES + 2)[1:-1]
        folds = []
        for Omega in ALPHA**0.5 + np.array(detunings(A)):
            for i in np.flatnonzero(np.diff(Omega[1:]) * np.diff(Omega[:-1]) < 0) + 1:
                folds.append((Omega[i], A[i]))
        return 2 * A.size, folds

    once = derived()
    return {
        "derivation and curve": (lambda: curve(derived()), answer),
        "curve alone": (lambda: curve(once), answer),
    }
