# Signatures of slowflow_kernels.den_hartog, for type checkers and editors. Written by `make derive`; never edit.
# Answers are scalars for scalars and arrays for arrays: Any.

from typing import Any

from numpy.typing import ArrayLike

from slowflow_support.broadcast import Floats
from slowflow_support.record import Mechanism

__all__ = [
    "S_ratio", "U", "V", "amplitude", "bound", "motion",
]

def V(Omega: ArrayLike) -> Any: ...
def U(Omega: ArrayLike) -> Any: ...
def S_ratio(tau: ArrayLike, Omega: ArrayLike) -> Any: ...
def amplitude(Omega: ArrayLike, F_0: ArrayLike, mu: ArrayLike) -> Any: ...
def bound(Omega: ArrayLike, F_0: ArrayLike, S: ArrayLike) -> Any: ...
def motion(tau: ArrayLike, Omega: ArrayLike, A: ArrayLike, mu: ArrayLike) -> Any: ...
