"""Beside step 1: what a deviation from a motion becomes where the equation of motion (3) switches.

In:  the state (u, v) of a motion that comes to a switch, its rates before and after.
Out: `Formulas`: the entries of the saltation matrix that are no 0 or 1; guesses of the time of a way put into a cycle.

A deviation x meets the surface g(x, tau) = 0 of the switch later by dtau, where g_x x + (g_tau + g_x f) dtau = 0. So it
becomes x + (f - f_after) dtau: f is the rates (u', v') before the switch, f_after those after it.
"""

from __future__ import annotations

import sympy as sp

from ..kernels import Formulas, Lets
from ..symbols import Omega
from .motion import v

#: u'' before and after; derivatives of the push by theta and u
before, after = sp.symbols("before after", real=True)
by_theta, by_u = sp.symbols("by_theta by_u", real=True)
#: how far beyond an edge a motion turns; what pulls it back; the rate at which the push on a mass at rest grows
beyond, pull, growth = sp.symbols("beyond pull growth", positive=True)
#: of a time
square, cube = sp.symbols("square cube", positive=True)


#: of arguments
ORDER = (before, after, beyond, pull, growth, v, Omega, by_theta, by_u)


def saltation(rates: tuple[sp.Expr, sp.Expr], after_it: tuple[sp.Expr, sp.Expr], g: tuple[sp.Expr, ...]) -> sp.Matrix:
    """The matrix by which a deviation of (u, v) passes a switch; g: derivatives of what vanishes there by u, v, tau."""
    x, later = sp.Matrix(sp.symbols("x_u x_v", real=True)), sp.Symbol("later", real=True)
    f, f_after, g_x = sp.Matrix(rates), sp.Matrix(after_it), sp.Matrix([g[:2]])
    (dtau,) = sp.solve((g_x * x)[0] + (g[2] + (g_x * f)[0]) * later, later)
    return (x + (f - f_after) * dtau).jacobian(x).applyfunc(sp.cancel)


def switching() -> Formulas:
    """Of states (u, v), from the entries that every such matrix has to have."""
    edge = saltation((v, before), (v, after), (1, 0, 0))
    turn = saltation((sp.S.Zero, before), (sp.S.Zero, after), (0, 1, 0))
    release = saltation((sp.S.Zero, sp.S.Zero), (sp.S.Zero, after), (by_u, 0, Omega * by_theta))
    for matrix, expected in ((edge, {0: 1, 1: 0, 3: 1}), (turn, {0: 1, 1: 0, 2: 0}), (release, {0: 1, 1: 0, 3: 1})):
        if any(matrix[number] != value for number, value in expected.items()):
            raise ArithmeticError(f"a switch mixes what it should not: {matrix}")
    of, equation = Formulas(ORDER), "beside (3)"
    text = "What u' gains of a deviation of u where u'' changes at an edge."
    of.add("across", sp.factor_terms(edge[2]), text, equation, "v other than 0")
    text = (
        "What is left of a deviation of u' where the velocity changes its sign and u'' with it; 0 where the mass stops."
    )
    of.add("turned", turn[3], text, equation, "before other than 0")
    # a mass at rest does not feel v: its row is that of u alone
    text = "What u' is of a deviation of u where the push on a mass at rest, with these slopes, breaks it away."
    of.add("released", release[2], text, equation, "Omega > 0, by_theta other than 0")
    time = sp.Symbol("time", positive=True)

    @of.kernel(equation, "beyond >= 0, pull > 0")
    def out() -> Lets:
        """The time of a way beyond an edge, up to where a constant pull turns it."""
        (found,) = sp.solve(sp.integrate(pull, time, time) - beyond, time**2)
        return Lets([(square, found)], sp.sqrt(square))

    @of.kernel(equation, "beyond >= 0, growth > 0")
    def back() -> Lets:
        """The time of the way back to it from rest, under a push that grows steadily from 0."""
        found = sp.solve(sp.integrate(growth * time, time, time) - beyond, time**3)[0]
        return Lets([(cube, found)], sp.cbrt(cube))

    return of
