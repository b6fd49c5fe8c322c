"""The equation of motion (3) itself, solved without averaging: periodic motions, response curves, sweeps.

In:  an `EquationOfMotion` (restoring force in pieces, dry friction, viscous damping), a forcing, a frequency.
Out: `steady_state`, `exact_response`, `sweep`; motions switch exactly between slip, stick, attached and detached.
"""

from slowflow.exact.continuation import Fold, Response, exact_response
from slowflow.exact.shooting import SteadyState, steady_state
from slowflow.exact.sweep import Sweep, sweep
from slowflow.mechanism import EquationOfMotion, Force, Law, Piece, linear

__all__ = [
    "EquationOfMotion",
    "Fold",
    "Force",
    "Law",
    "Piece",
    "Response",
    "SteadyState",
    "Sweep",
    "exact_response",
    "linear",
    "steady_state",
    "sweep",
]
