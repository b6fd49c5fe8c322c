# Signatures of slowflow_kernels.second_approximation, for type checkers and editors. Written by `make derive`; never edit.
# Answers are scalars for scalars and arrays for arrays: Any.

from typing import Any

from numpy.typing import ArrayLike

from slowflow_support.broadcast import Floats
from slowflow_support.record import Mechanism

__all__ = [
    "RESONANCE", "components", "detachment", "detachment_by_inertia", "folds", "response", "wave",
]

RESONANCE: float
def response(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike, h_3: ArrayLike, h_3_A: ArrayLike, h_3_AA: ArrayLike, h_5: ArrayLike, h_5_A: ArrayLike, h_5_AA: ArrayLike) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any]: ...
def detachment(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike, h_3: ArrayLike, h_3_A: ArrayLike, h_3_AA: ArrayLike, h_5: ArrayLike, h_5_A: ArrayLike, h_5_AA: ArrayLike) -> tuple[Any, Any, Any]: ...
def detachment_by_inertia(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike, h_3: ArrayLike, h_3_A: ArrayLike, h_3_AA: ArrayLike, h_5: ArrayLike, h_5_A: ArrayLike, h_5_AA: ArrayLike) -> tuple[Any, Any, Any]: ...
def folds(Omega: ArrayLike, A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike, h_AAA: ArrayLike, h_3: ArrayLike, h_3_A: ArrayLike, h_3_AA: ArrayLike, h_3_AAA: ArrayLike, h_5: ArrayLike, h_5_A: ArrayLike, h_5_AA: ArrayLike, h_5_AAA: ArrayLike) -> tuple[Any, Any, Any]: ...
def components(Omega: ArrayLike, A: ArrayLike, m: ArrayLike, h: ArrayLike, h_3: ArrayLike, h_5: ArrayLike) -> tuple[Any, Any, Any, Any, Any, Any, Any]: ...
def wave(turned: ArrayLike, Omega: ArrayLike, m: ArrayLike, A_1: ArrayLike, sine: ArrayLike, cosine: ArrayLike, a_3: ArrayLike, a_5: ArrayLike, kappa: ArrayLike) -> tuple[Any, Any]: ...
