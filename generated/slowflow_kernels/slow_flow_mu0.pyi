# Signatures of slowflow_kernels.slow_flow_mu0, for type checkers and editors. Written by `make derive`; never edit.
# Answers are scalars for scalars and arrays for arrays: Any.

from typing import Any

from numpy.typing import ArrayLike

from slowflow_kernels.slow_flow import F_A as F_A
from slowflow_kernels.slow_flow import F_AA as F_AA
from slowflow_kernels.slow_flow import F as F
from slowflow_kernels.slow_flow import F_AOmega as F_AOmega
from slowflow_kernels.slow_flow import F_Omega as F_Omega
from slowflow_kernels.slow_flow import I as I
from slowflow_kernels.slow_flow import R as R
from slowflow_kernels.slow_flow import backbone as backbone
from slowflow_kernels.slow_flow import equivalent_damping as equivalent_damping
from slowflow_kernels.slow_flow import fold_quartic as fold_quartic
from slowflow_kernels.slow_flow import isola_Omega as isola_Omega
from slowflow_kernels.slow_flow import level as level
from slowflow_kernels.slow_flow import limit_envelope as limit_envelope
from slowflow_kernels.slow_flow import peak_cubic as peak_cubic
from slowflow_kernels.slow_flow import phase as phase
from slowflow_kernels.slow_flow import stability as stability
from slowflow_support.broadcast import Floats
from slowflow_support.record import Mechanism

__all__ = [
    "F_A", "F_AA", "SCENE", "F", "F_AOmega", "F_Omega", "I", "R", "backbone", "detachment", "equivalent_damping",
    "fold", "fold_quartic", "isola", "isola_Omega", "level", "limit_envelope", "peak_cubic", "phase",
    "response_quartic", "stability",
]

SCENE: str
def response_quartic(A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> tuple[Any, Any, Any, Any]: ...
def detachment(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike) -> Floats: ...
def fold(A: ArrayLike, F_0: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, k: ArrayLike, k_A: ArrayLike) -> tuple[Any, Any, Any]: ...
def isola(A: ArrayLike, m: ArrayLike, zeta: ArrayLike, h: ArrayLike, h_A: ArrayLike, h_AA: ArrayLike) -> tuple[Any, Any]: ...
