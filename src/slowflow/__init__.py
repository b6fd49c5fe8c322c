"""Resonance of nonlinear vibration isolators: response curves, folds, detachment, stability.

`Isolator`, `Duffing` and, for any other spring model, `Oscillator` have a method for each question. Results are classes
of `slowflow.answers.results`; results in SI units are `Quantities`.
"""

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from slowflow.answers.certificate import Certificate
    from slowflow.answers.gradient import Gradient
    from slowflow.answers.quantities import Quantities
    from slowflow.answers.results import (
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
    from slowflow.oscillators.isolator import Duffing, Isolator
    from slowflow.oscillators.measurements import read_csv
    from slowflow.oscillators.oscillator import Oscillator
    from slowflow.oscillators.physical import Physical
    from slowflow.support.errors import (
        BuildFailed,
        NotSettled,
        OutOfRange,
        Refused,
        SceneError,
        SlowflowError,
        WrongType,
    )
    from slowflow.version import __version__, include

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
    "read_csv",
]

#: where they are defined; nothing is imported, and nothing has to be compiled, before it is used
_HOMES = (
    "version",
    "support.errors",
    "oscillators.isolator",
    "oscillators.physical",
    "answers.quantities",
    "oscillators.measurements",
    "answers.results",
    "answers.certificate",
    "answers.gradient",
)


def __getattr__(name: str) -> Any:
    for home in _HOMES if name in __all__ else ():
        module = importlib.import_module(f"slowflow.{home}")
        if hasattr(module, name):
            return globals().setdefault(name, getattr(module, name))
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return __all__
