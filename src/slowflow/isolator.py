"""The shipped oscillators by name: in go their parameters, out come oscillators that answer every question.

`Isolator` is the paper's mechanism, `Duffing` one cubic piece.
"""

from __future__ import annotations

import warnings
from functools import cached_property, partial
from types import ModuleType
from typing import Any

from slowflow import mechanism, validate
from slowflow.averaged.many import Designs
from slowflow.mechanism import Force
from slowflow.model import Model
from slowflow.oscillator import Oscillator
from slowflow_kernels import duffing, rod_spring, rod_spring_attached

#: alpha and beta of the cubic oscillator that is linear
LINEAR = (1.0, 0.0)

#: what may be averaged: (6) or (5)
FORCES = ("truncated", "untruncated")


def _untruncated_kernels() -> ModuleType:
    """The untruncated force's kernels, which few need: loaded when they are."""
    from slowflow_kernels import rod_spring_exact

    kernels: ModuleType = rod_spring_exact
    return kernels


class Isolator(Oscillator):
    """The high-static-low-dynamic-stiffness isolator of (1)-(7), springs leaving the push-rod at u_cr.

    lam     -- number of horizontal springs, > 0
    r       -- stiffness ratio k_h/k_v, > 0
    delta_h -- preload of the horizontal springs over the rod length, in [0, 1); 0 is a linear oscillator, and more than
               1/(lam r) is a negative stiffness at rest, which works with a warning
    mu, zeta -- dry friction and viscous damping ratio, >= 0
    force    -- what is averaged: "truncated" for the fifth-order polynomial (6), which jumps at u_cr, "untruncated" for
                the force as the geometry gives it (5)
    """

    def __init__(
        self, *, lam: float, r: float, delta_h: float, mu: float = 0.0, zeta: float = 0.0, force: str = "truncated"
    ) -> None:
        self.force = validate.choice("force", force, FORCES)
        self.lam = validate.number("lam", lam, above=0.0)
        self.r = validate.number("r", r, above=0.0)
        self.delta_h = validate.number("delta_h", delta_h, least=0.0, below=1.0)
        parameters = tuple(float(value) for value in rod_spring.coefficients(self.lam, self.r, self.delta_h))
        if self.delta_h == 0:  # the springs never touch the rod
            super().__init__(duffing, LINEAR, mu, zeta)
        else:
            kernels = _untruncated_kernels() if self.force == "untruncated" else rod_spring
            own = kernels.coefficients(self.lam, self.r, self.delta_h)
            super().__init__(kernels, tuple(map(float, own)), mu, zeta)
        self.alpha, self.beta, self.gamma, self.u_cr = parameters
        if self.alpha < 0:
            warnings.warn(
                f"delta_h = {self.delta_h:g} exceeds 1/(lam r) = {1 / (self.lam * self.r):g}: "
                f"negative stiffness at rest (alpha = {self.alpha:g}); the averaged motion is about u = 0",
                stacklevel=2,
            )

    @cached_property
    def first_piece(self) -> Model | None:
        """The first piece of the force alone, where a response to less than F_cr is known to stay on it; else None."""
        # While f(u)/u rises with |u| so does -h/A with A, and with both the least forcing that holds an amplitude: once
        # F_0 < F_cr leaves u_cr out of reach, it leaves all above out too. A negative averaged stiffness breaks this.
        model = self.model
        hardens = self.beta >= 0 and self.gamma >= 0 and all(jump <= 0 for jump in model.jumps)
        if (
            self.force == "untruncated"
            or not model.breakpoints
            or not hardens
            or model.averaged(model.breakpoints[0])[0] >= 0
        ):
            return None
        return Model(rod_spring_attached, model.parameters, self.mu, self.zeta, attached=True)

    def __repr__(self) -> str:
        force = "" if self.force == "truncated" else f", force={self.force!r}"
        return f"Isolator(lam={self.lam}, r={self.r}, delta_h={self.delta_h}, mu={self.mu}, zeta={self.zeta}{force})"

    def restoring_force(self, which: str | None = None) -> Force:
        if validate.choice("force", which or self.force, FORCES) == "untruncated":
            return mechanism.rod_spring_exact(self.lam, self.r, self.delta_h)
        return mechanism.rod_spring(self.alpha, self.beta, self.gamma, self.u_cr)

    @classmethod
    def many(
        cls, *, lam: Any, r: Any, delta_h: Any, mu: Any = 0.0, zeta: Any = 0.0, force: str = "truncated"
    ) -> Designs:
        """Many isolators at once, from arrays that broadcast; see `slowflow.averaged.many`.

        Raises ValueError for what is no real array and for shapes that do not broadcast, and nothing for a single
        design: each answer has a status.
        """
        untruncated = validate.choice("force", force, FORCES) == "untruncated"
        values = {"lam": lam, "r": r, "delta_h": delta_h, "mu": mu, "zeta": zeta}
        return Designs(partial(cls, force=force), _untruncated_kernels() if untruncated else rod_spring, values)


class Duffing(Oscillator):
    """u'' + 2 zeta u' + mu sign(u') + alpha u + beta u^3 = F_0 cos(Omega tau).

    alpha, beta -- linear and cubic stiffness; softening (beta < 0) and alpha <= 0 are allowed
    mu, zeta    -- dry friction and viscous damping ratio, >= 0
    """

    def __init__(self, alpha: float, beta: float, mu: float = 0.0, zeta: float = 0.0) -> None:
        self.alpha = validate.number("alpha", alpha)
        self.beta = validate.number("beta", beta)
        super().__init__(duffing, (self.alpha, self.beta), mu, zeta)

    def __repr__(self) -> str:
        return f"Duffing(alpha={self.alpha}, beta={self.beta}, mu={self.mu}, zeta={self.zeta})"

    def restoring_force(self, which: str | None = None) -> Force:
        # its force is a polynomial: nothing was truncated
        validate.choice("force", which or "untruncated", FORCES)
        return mechanism.duffing(self.alpha, self.beta)

    @classmethod
    def many(cls, alpha: Any, beta: Any, mu: Any = 0.0, zeta: Any = 0.0) -> Designs:
        """Many Duffing oscillators at once, as `Isolator.many`."""
        return Designs(cls, duffing, {"alpha": alpha, "beta": beta, "mu": mu, "zeta": zeta})
