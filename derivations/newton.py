"""Steps 4 and on: Newton's method on the equations that define an answer, one step in closed form.

In:  `SlowFlow`; the mechanism stays an open h(A).
Out: `steps`, by the kind of answer what its unknowns change by, in R, I and the derivatives of h: J step = -f, where f
     is what should vanish and J its Jacobian. Beside it `turn`, the share by which the slope of one of the equations
     changes along the step: where that is no small number the step is not the last.

    state        F = 0               A at Omega and F_0
    fold         F = F_A = 0         Omega and A at F_0
    peak         F = F_Omega = 0     Omega and A at F_0
    cusp         F_A = F_AA = 0      Omega and A, and with them F_0
    isola        F_A = F_Omega = 0   Omega and A, and with them F_0
    corner       F = 0               Omega at F_0, A being a breakpoint

Evaluated with more digits than a double has, a step from an answer that is nearly right leaves its rounding alone.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from .slow_flow import SlowFlow
from .symbols import A, Omega


@dataclass(frozen=True)
class Step:
    """In the derivatives of F.

    lets    -- these derivatives, in R, I, h and the derivatives of h
    changes -- of the unknowns, in the order of `EQUATIONS`
    turn    -- as above; 0 where the slope is no equation of any answer
    """

    lets: tuple[tuple[sp.Symbol, sp.Expr], ...]
    changes: tuple[sp.Expr, ...]
    turn: sp.Expr


#: by the answer: what vanishes, in which unknowns, and which of it turns first
EQUATIONS = {
    "state": (("F",), (A,), "F"),
    "fold": (("F", "F_A"), (Omega, A), "F_A"),
    "peak": (("F", "F_Omega"), (Omega, A), "F"),
    "cusp": (("F_A", "F_AA"), (Omega, A), "F_AA"),
    "isola": (("F_A", "F_Omega"), (Omega, A), "F_A"),
    "corner": (("F",), (Omega,), "F"),
}
#: derivatives of these along A and along Omega
ALONG = {
    "F": ("F_A", "F_Omega"),
    "F_A": ("F_AA", "F_AOmega"),
    "F_AA": ("F_AAA", "F_AAOmega"),
    "F_Omega": ("F_AOmega", "F_OmegaOmega"),
}


def steps(flow: SlowFlow) -> dict[str, Step]:
    """By the kind of answer."""
    return {kind: _step(flow, *stated) for kind, stated in EQUATIONS.items()}


def _step(flow: SlowFlow, equations: tuple[str, ...], unknowns: tuple[sp.Symbol, ...], turning: str) -> Step:
    """By Cramer's rule, the derivatives of F being names."""

    def slope(equation: str, unknown: sp.Symbol) -> str:
        return ALONG[equation][unknown == Omega]

    names: dict[str, sp.Symbol] = {}

    def named(name: str) -> sp.Symbol:
        return names.setdefault(name, sp.Symbol(name, real=True))

    values = sp.Matrix([named(name) for name in equations])
    jacobian = sp.Matrix([[named(slope(name, unknown)) for unknown in unknowns] for name in equations])
    determinant = jacobian.det()
    changes = []
    for column in range(len(unknowns)):
        replaced = jacobian.copy()
        replaced[:, column] = -values
        changes.append(replaced.det() / determinant)
    first = slope(turning, unknowns[-1])
    turn = sp.Integer(0)
    if first in ALONG:
        turned = sum(named(slope(first, unknown)) * change for unknown, change in zip(unknowns, changes, strict=True))
        turn = turned / named(first)
    lets = tuple((symbol, getattr(flow, name)) for name, symbol in names.items())
    return Step(lets, tuple(changes), turn)
