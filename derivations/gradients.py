"""Beside (23)-(34): how answers move with the parameters, by the implicit function theorem.

In:  a `Curve`, the response by what dissipates, and the force that an excitation of amplitude F_0 pushes with; the
     mechanism stays an open h(A).
Out: `Gradients`: for each kind of answer its moves, in what one parameter p does to h, to what dissipates, the
     breakpoint, the forcing and the frequency that are given.

An answer is a point (A, Omega, F_0) where three conditions hold; what each says of the moves A_p, Omega_p, F_0_p is
linear, and they are solved for together. F stands for R^2 + I^2 less the force's square S, and its derivatives by Omega
with it; of S by F_0 the moves take account of themselves. What vanishes at an answer is left out. The system's
determinant falls into factors, each with its size, the sum of its terms without their signs: where one vanishes the
answer has no derivative, as it meets another.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import sympy as sp

from .slow_flow import I, R, SlowFlow, m, slope
from .symbols import F_0, Omega, h, h_A, h_AA, mu, zeta

Let = tuple[sp.Symbol, sp.Expr]

#: what the parameter does: to h, h_A, h_AA at a fixed A, to m and zeta, to the breakpoint that the answer lies on, and
#: to the forcing and the frequency that are given
h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p = sp.symbols(
    "h_p h_Ap h_AAp m_p zeta_p end_p forcing_p frequency_p", real=True
)
OF_PARAMETER = (h_p, h_Ap, h_AAp, m_p, zeta_p, end_p, forcing_p, frequency_p)
#: and where other laws of damping make I (`dissipation`): what it does to I_0, I_0A, I_0AA at a fixed A, and to d
I_0p, I_0Ap, I_0AAp, d_p = sp.symbols("I_0p I_0Ap I_0AAp d_p", real=True)
OF_LAWS = (h_p, h_Ap, h_AAp, I_0p, I_0Ap, I_0AAp, zeta_p, d_p, end_p, forcing_p, frequency_p)
#: what the answer does
A_p, Omega_p, F_0_p = sp.symbols("A_p Omega_p F_0_p", real=True)
MOVES = (A_p, Omega_p, F_0_p)

#: F's derivatives at the answer, R's, and what the parameter does to them
F_A, F_AA, F_AAA, F_Omega, F_AOmega, F_AAOmega, F_OmegaOmega, R_A, R_Omega = sp.symbols(
    "F_A F_AA F_AAA F_Omega F_AOmega F_AAOmega F_OmegaOmega R_A R_Omega", real=True
)
F_p, F_Ap, F_AAp, F_Omegap = sp.symbols("F_p F_Ap F_AAp F_Omegap", real=True)
#: dS/dF_0, and its derivative by Omega
S_F, S_FOmega = sp.symbols("S_F S_FOmega", real=True)

#: what vanishes along with a condition, and what that says of the moves
CONDITIONS: dict[str, tuple[sp.Symbol | None, sp.Expr]] = {
    "level": (None, F_A * A_p + F_Omega * Omega_p + F_p - S_F * F_0_p),
    "fold": (F_A, F_AA * A_p + F_AOmega * Omega_p + F_Ap),
    "cusp": (F_AA, F_AAA * A_p + F_AAOmega * Omega_p + F_AAp),
    "top": (F_Omega, F_AOmega * A_p + F_OmegaOmega * Omega_p + F_Omegap - S_FOmega * F_0_p),
    "backbone": (R, R_A * A_p + R_Omega * Omega_p + h_p),
    "forcing": (None, F_0_p - forcing_p),
    "frequency": (None, Omega_p - frequency_p),
    "breakpoint": (None, A_p - end_p),
}

#: the kinds of answers: the conditions beside "level", and what it is
KINDS: dict[str, tuple[tuple[str, str], str]] = {
    "state": (("forcing", "frequency"), "a steady state; with Omega = 0 a peak at rest"),
    "fold": (("forcing", "fold"), "a fold at a forcing"),
    "corner_fold": (("forcing", "breakpoint"), "a fold at a forcing, on a breakpoint"),
    "peak": (("forcing", "top"), "a peak at a forcing"),
    "cusp": (("fold", "cusp"), "where two folds meet"),
    "isola": (("fold", "top"), "where an isolated curve is born"),
    "corner_top": (("breakpoint", "top"), "the least forcing on a breakpoint"),
    "corner_end": (("breakpoint", "fold"), "where the fold locus meets a breakpoint"),
    "corner_backbone": (("breakpoint", "backbone"), "where the backbone meets a breakpoint"),
    "corner_rest": (("breakpoint", "frequency"), "at Omega = 0 on a breakpoint"),
}


@dataclass(frozen=True)
class Curve:
    """The response (24), and by what it moves.

    R, ..., transmissibility -- as in `SlowFlow`
    moved -- what a parameter does at a fixed A to each symbol of these
    rises -- derivatives by A of their symbols, beside those of h
    """

    R: sp.Expr
    I: sp.Expr
    F: sp.Expr
    F_A: sp.Expr
    F_AA: sp.Expr
    F_AAA: sp.Expr
    F_Omega: sp.Expr
    F_AOmega: sp.Expr
    F_AAOmega: sp.Expr
    F_OmegaOmega: sp.Expr
    phase: sp.Expr
    transmissibility: sp.Expr
    moved: dict[sp.Symbol, sp.Symbol]
    rises: dict[sp.Symbol, sp.Symbol]

    @classmethod
    def of(cls, flow: SlowFlow) -> Curve:
        """With viscous damping and dry friction."""
        if sp.diff(flow.m, mu) * mu != flow.m:
            raise ArithmeticError("friction's share of I is not proportional to mu")
        own = {one.name: getattr(flow, one.name) for one in fields(cls) if hasattr(flow, one.name)}
        return cls(**own, moved={h: h_p, h_A: h_Ap, h_AA: h_AAp, m: m_p, zeta: zeta_p}, rises={})


@dataclass(frozen=True)
class Moves:
    """Of one kind of answer.

    lets   -- intermediate quantities in order
    values -- A_p, Omega_p, F_0_p
    pivots -- factors of the determinant, each with its size
    doc    -- what the answer is
    """

    lets: tuple[Let, ...]
    values: tuple[sp.Expr, ...]
    pivots: tuple[tuple[sp.Expr, sp.Expr], ...]
    doc: str


@dataclass(frozen=True)
class Gradients:
    """All of it.

    kinds -- by the names in `KINDS`
    beside_lets, beside -- of a point: F_A, F_Omega and R, each with its size
    of_state_lets, of_state -- how the phase and the transmissibility of a moving state change
    """

    kinds: dict[str, Moves]
    beside_lets: tuple[Let, ...]
    beside: tuple[tuple[sp.Expr, sp.Expr], ...]
    of_state_lets: tuple[Let, ...]
    of_state: tuple[sp.Expr, sp.Expr]


def gradients(flow: Curve, force: sp.Expr = F_0) -> Gradients:
    """All of it, for an excitation that pushes with `force`, in F_0 and Omega."""
    S = force**2
    of_flow = {F_A: flow.F_A, F_AA: flow.F_AA, F_AAA: flow.F_AAA, F_AOmega: flow.F_AOmega, F_AAOmega: flow.F_AAOmega}
    of_flow |= {F_Omega: flow.F_Omega - sp.diff(S, Omega), F_OmegaOmega: flow.F_OmegaOmega - sp.diff(S, Omega, 2)}
    of_force = {S_F: sp.diff(S, F_0), S_FOmega: sp.diff(S, F_0, Omega)}
    of_flow |= {R_A: slope(flow.R), R_Omega: sp.diff(flow.R, Omega)}
    whole = {R: flow.R, I: flow.I}
    of_flow |= {
        moved: _moved(flow, value)
        for moved, value in ((F_p, flow.F), (F_Ap, flow.F_A), (F_AAp, flow.F_AA), (F_Omegap, flow.F_Omega))
    }
    sizes = {symbol: size(value, whole) for symbol, value in of_flow.items()}

    def let(expressions: list[sp.Expr], vanished: set[sp.Symbol]) -> tuple[Let, ...]:
        """What the expressions need, in order; what vanishes is left out of it."""
        used = set().union(*(expression.free_symbols for expression in expressions))
        named = [
            (symbol, value.subs(dict.fromkeys(vanished, 0))) for symbol, value in of_flow.items() if symbol in used
        ]
        needs = used.union(*(value.free_symbols for _, value in named))
        return (*((symbol, value) for symbol, value in whole.items() if symbol in needs), *named)

    def of_kind(conditions: tuple[str, str], doc: str) -> Moves:
        asked = [CONDITIONS[name] for name in ("level", *conditions)]
        vanished = {symbol for symbol, _ in asked if symbol is not None}
        put_in = of_force | dict.fromkeys(vanished, 0)
        system = sp.Matrix([equation.subs(put_in) for _, equation in asked])
        matrix, right = system.jacobian(MOVES), -system.subs(dict.fromkeys(MOVES, 0))
        solved = [sp.factor(value) for value in matrix.LUsolve(right)]
        # F_0 and Omega are positive
        factors = [factor for factor, _ in sp.factor_list(matrix.det())[1] if factor.free_symbols - {F_0, Omega}]
        pivots = tuple((factor, size(factor, sizes, named=True)) for factor in factors)
        return Moves(let([*solved, *factors], vanished & {R}), tuple(solved), pivots, doc)

    beside = tuple((symbol, sizes[symbol]) for symbol in (F_A, F_Omega))
    of_state_lets, of_state = _of_state(flow, force)
    return Gradients(
        {name: of_kind(conditions, doc) for name, (conditions, doc) in KINDS.items()},
        let([F_A, F_Omega, R], set()),
        (*beside, (R, size(R, whole))),
        of_state_lets,
        of_state,
    )


def _moved(flow: Curve, expression: sp.Expr) -> sp.Expr:
    """d/dp of an expression in R, I and what they are made of, at fixed A, Omega and F_0."""
    direct = flow.moved
    of_R_and_I = {
        name: sum(sp.diff(value, symbol) * move for symbol, move in direct.items())
        for name, value in ((R, flow.R), (I, flow.I))
    }
    chain = direct | of_R_and_I
    return sp.factor_terms(sum(sp.diff(expression, symbol) * move for symbol, move in chain.items()))


def _of_state(flow: Curve, force: sp.Expr) -> tuple[tuple[Let, ...], tuple[sp.Expr, sp.Expr]]:
    """d phi/dp and d transmissibility/dp of a state, from its own moves."""
    R_moved, I_moved = sp.symbols("R_moved I_moved", real=True)

    def along(value: sp.Expr) -> sp.Expr:
        return sp.expand(_moved(flow, value) + slope(value, flow.rises) * A_p + sp.diff(value, Omega) * Omega_p)

    phase = sp.diff(flow.phase, R) * R_moved + sp.diff(flow.phase, I) * I_moved
    value = flow.transmissibility.subs(F_0, force)
    moves = {h: h_p + h_A * A_p, I: I_moved, F_0: F_0_p, Omega: Omega_p}
    transmitted = sum(sp.diff(value, symbol) * move for symbol, move in moves.items())
    lets = ((R, flow.R), (I, flow.I), (R_moved, along(flow.R)), (I_moved, along(flow.I)))
    return lets, (sp.factor_terms(sp.simplify(phase)), sp.factor_terms(transmitted))


def size(expression: sp.Expr, of: dict[sp.Symbol, sp.Expr], *, named: bool = False) -> sp.Expr:
    """The sum of an expression's terms without their signs, those of the symbols in `of` put in.

    named -- whether `of` holds sizes already
    """
    if expression in of:
        return of[expression] if named else size(of[expression], of)
    if expression.is_Add:
        return sp.Add(*(size(term, of, named=named) for term in expression.args))
    if expression.is_Mul:
        return sp.Mul(*(size(factor, of, named=named) for factor in expression.args))
    if expression.is_Pow:
        return size(expression.base, of, named=named) ** expression.exp
    return sp.Abs(expression)
