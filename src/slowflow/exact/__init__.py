"""The equation of motion (3) itself, solved without averaging: periodic motions, response curves, sweeps.

`steady_state`, `exact_response`, `sweep` and `transient` take an `EquationOfMotion` (restoring force in pieces, dry
friction, viscous damping) and its excitation. The times of slip, stick and detachment are roots of the solution, not
smoothed.
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
