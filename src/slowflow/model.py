"""One oscillator as numbers: in go a mechanism's kernels and parameters, out come the functions that solvers call.

The scene (which damping terms vanish) is chosen here, once: a scene has slow-flow kernels of its own, derived with the
zeros put in.
"""

from __future__ import annotations

import importlib
from dataclasses import dataclass, field
from functools import cached_property
from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt

from slowflow import backend
from slowflow_kernels import slow_flow as general_flow

Floats = npt.NDArray[np.float64]


def scene(mu: float, zeta: float) -> str:
    """Name of the damping scene: "", "mu0", "zeta0" or "mu0_zeta0"."""
    return "_".join(name for name, value in (("mu0", mu), ("zeta0", zeta)) if value == 0)


@dataclass(frozen=True)
class Model:
    """The slow flow of one oscillator, dimensionless.

    kernels    -- generated module of the mechanism
    parameters -- its parameters, in the order of `kernels.PARAMETERS`
    mu, zeta   -- dry friction and viscous damping ratio
    attached   -- whether the first piece of the force holds at every amplitude, as in the kernels of that scene
    m          -- 4 mu/pi, friction's share of I (23)
    flow       -- generated slow flow of the scene
    breakpoints, jumps -- where the pieces of the force end, and the force just below less the force just above
    reach      -- largest |u| of the mechanism, inf if it has none
    native     -- the same as the compiled solvers take it, None where they have no record of the mechanism
    """

    kernels: Any
    parameters: tuple[float, ...]
    mu: float
    zeta: float
    attached: bool = False
    m: float = field(init=False)
    flow: ModuleType = field(init=False)
    breakpoints: tuple[float, ...] = field(init=False)
    jumps: tuple[float, ...] = field(init=False)
    native: Any = field(init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        name = scene(self.mu, self.zeta)
        flow = importlib.import_module(f"slowflow_kernels.slow_flow_{name}") if name else general_flow
        object.__setattr__(self, "flow", flow)
        object.__setattr__(self, "m", float(general_flow.friction(self.mu)))
        ends = () if self.attached else map(float, self.kernels.breakpoints(*self.parameters))
        jumps = () if self.attached else map(float, self.kernels.jumps(*self.parameters))
        # A piece of no width (u_cr = 0 for a null preload) is no piece.
        kept = [(end, jump) for end, jump in zip(ends, jumps, strict=True) if end > 0]
        object.__setattr__(self, "breakpoints", tuple(end for end, _ in kept))
        object.__setattr__(self, "jumps", tuple(jump for _, jump in kept))
        object.__setattr__(self, "native", self._compiled())

    @cached_property
    def linear(self) -> bool:
        """Whether the averaged force is proportional to the amplitude."""
        return not self.breakpoints and bool(self.averaged(1.0)[2] == 0)

    @property
    def reach(self) -> float:
        return float(self.kernels.REACH)

    def _compiled(self) -> Any:
        record = backend.record_of(self.kernels)
        if backend.SOLVER is None or record is None:
            return None
        return backend.SOLVER.model(record, self.parameters, (self.mu, self.zeta), self.attached)

    def averaged(self, A: Any) -> tuple[Floats, Floats, Floats, Floats]:
        """h, h_A, h_AA, h_AAA at the amplitudes A (any shape)."""
        h, h_A, h_AA, h_AAA = self.kernels.averaged(A, *self.parameters)
        return h, h_A, h_AA, h_AAA

    def harmonics(self, A: Any) -> tuple[Floats, ...]:
        """h_3 and h_5, each with its three derivatives, at the amplitudes A (any shape)."""
        return tuple(self.kernels.harmonics(A, *self.parameters))
