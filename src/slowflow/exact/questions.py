"""A user's questions put to the equation of motion: in go an averaged oscillator and numbers, out come exact answers.

`Isolator` and `Duffing` delegate here. The averaged solution, which costs microseconds, gives the guesses.
"""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow import validate
from slowflow.exact import continuation, shooting
from slowflow.exact.force import Oscillator
from slowflow.exact.sweep import Sweep
from slowflow.exact.sweep import sweep as stepped

if TYPE_CHECKING:
    from slowflow.isolator import Oscillator as Averaged

#: distance, relative in amplitude and frequency, from which on the averaged points are those of another curve
APART = 0.1

OTHER = (
    "another curve is not part of this one: averaging has it at Omega = {Omega:.4g}, A = {A:.4g}; "
    "start = steady_state({Omega:.4g}, {F_0:.4g}, {A:.4g}) leads to it"
)


def oscillator(averaged: Averaged, which: str | None) -> Oscillator:
    """The equation of motion (3) of an averaged oscillator.

    which -- "truncated" for (6), "exact" for (5), None for the force that the averaged oscillator has

    Raises ValueError for anything else, and where neither friction nor viscous damping lets a motion settle.
    """
    return Oscillator(averaged._restoring_force(which), averaged.mu, averaged.zeta)


def steady_state(
    averaged: Averaged, Omega: float, F_0: float, A: float | None, which: str | None
) -> shooting.SteadyState:
    """See `slowflow.isolator.Oscillator.steady_state`."""
    Omega = validate.number("Omega", Omega, above=0.0)
    F_0 = validate.number("F_0", F_0, above=0.0)
    wanted = None if A is None else validate.number("A", A, above=0.0)
    system = oscillator(averaged, which)
    if wanted is None:
        return _from_rest(averaged, system, Omega, F_0)
    return shooting.steady_state(system, Omega, F_0, _guess(averaged, Omega, F_0, wanted))


def exact_response(
    averaged: Averaged,
    F_0: float,
    Omega: tuple[float, float],
    start: shooting.SteadyState | None,
    step: float,
    which: str | None,
) -> continuation.Response:
    """See `slowflow.isolator.Oscillator.exact_response`."""
    F_0 = validate.number("F_0", F_0, above=0.0)
    low, high = validate.window("Omega", Omega)
    low = validate.number("Omega[0]", low, above=0.0)
    step = validate.number("step", step, above=0.0, most=0.5)
    system = oscillator(averaged, which)
    if start is None:
        start = _from_rest(averaged, system, low, F_0)
    elif not (isinstance(start, shooting.SteadyState) and low <= start.Omega <= high and start.F_0 == F_0):
        raise ValueError(
            f"start = {start!r} is not allowed: start must be a steady state at F_0 = {F_0:g}, Omega in {Omega}"
        )
    found = continuation.exact_response(system, F_0, (low, high), start=start, step=step)
    return dataclasses.replace(found, message=_others(averaged, found, (low, high)))


def _others(averaged: Averaged, found: continuation.Response, window: tuple[float, float]) -> str:
    """Names a stable point of each averaged curve in the window that the exact one does not come near."""
    curve = averaged.frequency_response(found.F_0, samples=100, Omega=window)
    points = np.log(np.column_stack((curve.Omega, curve.A)))
    line = np.log(np.column_stack((found.Omega, found.A)))
    apart = np.array([np.abs(line - point).max(axis=1).min() for point in points])
    branches = [np.flatnonzero(curve.branch == branch) for branch in np.unique(curve.branch)]
    branches.sort(key=lambda on: float(np.median(apart[on])))
    remarks = []
    for on in branches[1:]:  # the nearest is this curve, however far friction keeps averaging from it
        stable = on[curve.stable[on]]
        if stable.size and np.median(apart[on]) > APART:
            at = stable[stable.size // 2]
            remarks.append(OTHER.format(Omega=curve.Omega[at], A=curve.A[at], F_0=found.F_0))
    return "; ".join(remarks)


def sweep(averaged: Averaged, F_0: float, Omega: Any, tolerance: float, which: str | None) -> Sweep:
    """See `slowflow.isolator.Oscillator.sweep`."""
    F_0 = validate.number("F_0", F_0, above=0.0)
    frequencies = validate.positive_array("Omega", Omega)
    tolerance = validate.number("tolerance", tolerance, above=0.0)
    return stepped(oscillator(averaged, which), F_0, frequencies, tolerance=tolerance)


def _from_rest(averaged: Averaged, system: Oscillator, Omega: float, F_0: float) -> shooting.SteadyState:
    """What a mass at rest comes to; where averaging knows of one state only, that one, without waiting for it."""
    states = averaged.amplitudes(Omega, F_0)
    if states.A.size == 1:
        found = shooting.steady_state(system, Omega, F_0, (float(states.A[0]), float(states.phi[0])))
        if found.stable:  # about u = 0 it need not be, where the stiffness is negative
            return found
    return shooting.steady_state(system, Omega, F_0)


def _guess(averaged: Averaged, Omega: float, F_0: float, A: float) -> tuple[float, float] | None:
    """(A, phi) of the averaged state nearest to A, or None: then from rest."""
    states = averaged.amplitudes(Omega, F_0)
    if not states.A.size:
        return None
    nearest = int(np.argmin(np.abs(states.A - A)))
    return float(states.A[nearest]), float(states.phi[nearest])
