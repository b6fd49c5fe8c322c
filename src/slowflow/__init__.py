"""slowflow: response curves, folds and critical forcings of vibration isolators, from derived and generated equations.

In:  an oscillator's parameters. Out: `Isolator`, `Duffing`, `Oscillator` of any derived mechanism, and their answers:
     the classes of `slowflow.results`, in units `Quantities`.
"""

from slowflow.certificate import Certificate
from slowflow.gradient import Gradient
from slowflow.isolator import Duffing, Isolator
from slowflow.oscillator import Oscillator
from slowflow.physical import Physical
from slowflow.quantities import Quantities
from slowflow.results import (
    Cusps,
    Detachment,
    FoldLocus,
    FrequencyResponse,
    IsolaPoints,
    Peak,
    Remark,
    SaddleNodeOnset,
    SaddleNodes,
    SteadyStates,
)
from slowflow.version import __version__, include
from slowflow_support.errors import BuildFailed, NotSettled, OutOfRange, Refused, SceneError, SlowflowError, WrongType

__all__ = [
    "BuildFailed",
    "Certificate",
    "Cusps",
    "Detachment",
    "Duffing",
    "FoldLocus",
    "FrequencyResponse",
    "Gradient",
    "IsolaPoints",
    "Isolator",
    "NotSettled",
    "Oscillator",
    "OutOfRange",
    "Peak",
    "Physical",
    "Quantities",
    "Refused",
    "Remark",
    "SaddleNodeOnset",
    "SaddleNodes",
    "SceneError",
    "SlowflowError",
    "SteadyStates",
    "WrongType",
    "__version__",
    "include",
]
