# Signatures of slowflow_kernels.sensitivities, for type checkers and editors. Written by `make derive`; never edit.
# Answers are scalars for scalars and arrays for arrays: Any.

from typing import Any

from numpy.typing import ArrayLike

from slowflow_support.broadcast import Floats
from slowflow_support.record import Mechanism

__all__ = [
    "by_force", "by_inertia", "of_state", "right", "slopes",
]

def slopes(Omega: Any, A: Any, R: Any, I_0: Any, I_0A: Any, I_0AA: Any, I_0AAA: Any, zeta: Any, d: Any, h: Any, h_A: Any, h_AA: Any, h_AAA: Any, S_Omega: Any, S_OmegaOmega: Any, S_F: Any, S_FOmega: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any, Any]: ...
def right(Omega: Any, A: Any, R: Any, I_0: Any, I_0A: Any, I_0AA: Any, zeta: Any, d: Any, h_A: Any, h_AA: Any, h_p: Any, h_Ap: Any, h_AAp: Any, I_0p: Any, I_0Ap: Any, I_0AAp: Any, zeta_p: Any, d_p: Any, forcing_p: Any, frequency_p: Any, end_p: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any, Any]: ...
def of_state(Omega: Any, A: Any, I_0: Any, I_0A: Any, zeta: Any, d: Any, h: Any, h_A: Any, force: Any, force_Omega: Any, force_F: Any, h_p: Any, I_0p: Any, zeta_p: Any, d_p: Any, A_p: Any, Omega_p: Any, F_0_p: Any) -> tuple[Any, Any]: ...
def by_force(Omega: Any, F_0: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any]: ...
def by_inertia(Omega: Any, F_0: Any) -> tuple[Any, Any, Any, Any, Any, Any, Any]: ...
