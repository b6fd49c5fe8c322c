"""The equation of motion (3) itself, solved without averaging: periodic motions, response curves, sweeps.

In:  an `EquationOfMotion` (restoring force in pieces, dry friction, viscous damping), a forcing, a frequency.
Out: `steady_state`, `exact_response`, `sweep`, `transient`; motions switch exactly between slip and stick, attached and
     detached.
"""

from slowflow.exact.response import Fold, Response, exact_response
from slowflow.exact.shooting import SteadyState, steady_state
from slowflow.exact.sweep import Sweep, sweep
from slowflow.exact.transient import ShockSpectrum, Transient, half_sine, record, transient
from slowflow.mechanism import EquationOfMotion, Force, Law, Piece, linear

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
