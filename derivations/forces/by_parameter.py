"""Step 3 by the parameters: how the averaged force and its first two slopes change with each parameter of the force.

In:  the pieces of a force with the names of its parameters, and its average (`Restoring`).
Out: `Case`s, as of an average: h_p, h_Ap, h_AAp of each parameter p, at a fixed A.

Under the integral sign again (Leibniz): the average of df/dp, and where a breakpoint b moves, what the force loses
there,

    d/db int f(A sin t) sin t dt  =  (f below - f above)(b) sin(theta) dtheta/db,    sin(theta) = b/A,

which is next to 0 where the force does not jump. An untruncated force is u (a + b/sqrt(1 - u^2)): its average is linear
in a and b, so that h itself says what they do, and its end acts by a linear force alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from ..paper.restoring_force import (
    END,
    GAINED,
    ROOT,
    Case,
    End,
    Regime,
    Restoring,
    at_breakpoint,
    at_end,
    average,
    forms,
)
from ..symbols import A, h, h_A, h_AA, u
from .elliptic import coefficients, corner

#: h and its slopes whose change is given
OF = (h, h_A, h_AA)

_inner = sp.Symbol("inner", real=True)


def by_parameter(
    whole: Restoring, breakpoints: Mapping[sp.Symbol, sp.Expr], parameters: Sequence[sp.Symbol]
) -> tuple[Case, ...]:
    """h_p, h_Ap, h_AAp of each parameter in turn; breakpoints by name, in the parameters."""
    if whole.cases:
        return _of_untruncated(whole, breakpoints, parameters)
    marks = {p: sp.Symbol(f"mark_{p.name}", real=True) for p in parameters}
    changes = [sp.Add(*(mark * sp.diff(piece, p) for p, mark in marks.items())) for piece in whole.pieces]
    split = _Shares(marks.values())
    cases = []
    for name, guards, passed, far in forms(whole.breakpoints):
        regime = average(changes, whole.breakpoints, passed, far, orders=len(OF) - 1, bent=False)
        values = []
        contributions = [split(value) for value in regime.derivatives]
        for p, mark in marks.items():
            moving = whole.breakpoints.index(p) if p in whole.breakpoints[:passed] else None
            of_end = (0, 0, 0) if moving is None else _of_end(whole, moving, passed)
            values += [
                of_mark.get(mark, sp.Integer(0)) + own for of_mark, own in zip(contributions, of_end, strict=True)
            ]
        lets = [(symbol, value) for symbol, value in regime.lets if not value.has(*marks.values())]
        cases.append(Case(name, guards, Regime(regime.passed, regime.far, tuple(lets), tuple(values))))
    return tuple(cases)


class _Shares:
    """Of expressions that are linear in marks: what each mark is multiplied by, all in one pass and each part once."""

    def __init__(self, marks: Iterable[sp.Symbol]) -> None:
        self._known: dict[sp.Expr, dict[sp.Symbol, sp.Expr]] = {mark: {mark: sp.Integer(1)} for mark in marks}

    def __call__(self, expression: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
        """By mark, those that it has."""
        if expression not in self._known:
            self._known[expression] = self._of(expression)
        return self._known[expression]

    def _of(self, expression: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
        shares = [self(part) for part in expression.args]
        marked = [k for k, of_part in enumerate(shares) if of_part]
        if not marked:
            return {}
        if expression.is_Add:
            marks = dict.fromkeys(mark for of_part in shares for mark in of_part)
            return {mark: sp.Add(*(one[mark] for one in shares if mark in one)) for mark in marks}
        if not expression.is_Mul or len(marked) > 1:
            raise ArithmeticError(f"{expression} is not linear in {', '.join(map(str, expression.free_symbols))}")
        (k,) = marked
        before, after = expression.args[:k], expression.args[k + 1 :]
        return {mark: sp.Mul(*before, value, *after) for mark, value in shares[k].items()}


def _of_end(whole: Restoring, k: int, passed: int) -> tuple[sp.Expr, ...]:
    """What a moving breakpoint does to the average and its slopes, where A exceeds it."""
    end = End(whole.breakpoints[k], f"_{k + 1}" if passed > 1 else "", far=False)
    lost = at_breakpoint(whole.pieces[k] - whole.pieces[k + 1], end.b)
    of_any_end = 4 / sp.pi * GAINED * END / (A * ROOT)
    return tuple(sp.factor(at_end(of_any_end, times, -lost, end.b, end.root)) for times in range(3))


def _of_untruncated(
    whole: Restoring, breakpoints: Mapping[sp.Symbol, sp.Expr], parameters: Sequence[sp.Symbol]
) -> tuple[Case, ...]:
    """The same by h and its slopes, which are given."""
    (a, b), (rest, _) = (coefficients(piece) for piece in whole.pieces)
    # u (constant + b/sqrt(1 - u^2))
    constant = a - b
    ((name, value),) = breakpoints.items()
    linear = (A, sp.Integer(1), sp.Integer(0))
    _check(whole, constant, b)

    def changed(p: sp.Symbol, of_linear: sp.Expr) -> list[sp.Expr]:
        """h = -(of_linear A + b E): by E, which h says."""
        return [
            sp.factor(-sp.diff(of_linear, p) * own + sp.diff(b, p) / b * (average + of_linear * own))
            for average, own in zip(OF, linear, strict=True)
        ]

    attached = [entry for p in parameters for entry in changed(p, constant)]
    cases = [Case("passed_0", ((A, value),), Regime((), (), (), tuple(attached)))]
    height = corner(name, value).height
    for label, guards, passed, far in forms((name,)):
        if not passed:
            continue
        own_guards = tuple((left.subs(name, value), right.subs(name, value)) for left, right in guards)
        values, lets = [], ()
        for p in parameters:
            # b u (1/sqrt(1 - u^2) - 1/height) beside the rest
            inner = -sp.diff(height, p) / height**2
            if inner == 0:
                values += changed(p, rest)
                continue
            regime = average([b * _inner * u, sp.Integer(0)], (name,), 1, far, orders=len(OF) - 1, bent=False)
            lets = ((name, value), (_inner, -inner), *regime.lets)
            values += [one + other for one, other in zip(changed(p, rest), regime.derivatives, strict=True)]
        cases.append(Case(label, own_guards, Regime((name,), (), lets, tuple(values))))
    return tuple(cases)


def _check(whole: Restoring, constant: sp.Expr, b: sp.Expr) -> None:
    """Proof that the force is u (constant + b/sqrt(1 - u^2)), with b in one parameter that it is proportional to."""
    form = u * (constant + b / sp.sqrt(1 - u**2))
    if sp.simplify(whole.pieces[0] - form) != 0 or any(sp.diff(b, p) * p != b for p in b.free_symbols):
        raise ArithmeticError(f"no way is known in which the average of {whole.pieces[0]} changes")
