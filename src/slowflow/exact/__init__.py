"""Exact motions: periodic solutions, response curves and sweeps of the equation of motion (3).

`steady_state`, `exact_response`, `sweep` and `transient` take an `EquationOfMotion` and its excitation. Friction is not
smoothed: the times of slip, stick and detachment are computed as roots.
"""

from slowflow.core.mechanism import EquationOfMotion, Force, Law, Piece, linear
from slowflow.exact.response import Fold, Response, exact_response
from slowflow.exact.shooting import SteadyState, steady_state
from slowflow.exact.sweep import Sweep, sweep
from slowflow.exact.transient import ShockSpectrum, Transient, half_sine, record, transient

__all__ = [
    "EquationOfMotion",
    "Fold",
    "Force",
    "Law",
    "Piece",
    "Response",
    "ShockSpectrum",
    "SteadyState",
    "Sweep",
    "Transient",
    "exact_response",
    "half_sine",
    "linear",
    "record",
    "steady_state",
    "sweep",
    "transient",
]
