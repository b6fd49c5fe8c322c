"""Beside (28)-(30): whether a motion about the centre stays there; the averaging of (11) with a mean offset B.

In:  the shape of an odd force f(u) = u + F_k(u) alone, and h = -(1/pi) int_0^{2 pi} f(A cos psi) cos psi dpsi.
Out: `mean_stiffness`, d f_0/dB at B = 0 in A, h and h_A; f_0(A, B) is the mean of f(B + A cos psi) over a cycle.

With u = B + A cos psi the mean of the equation of motion is B'' + d B' + f_0(A, B) = 0, where d >= 0 is what both kinds
of damping leave. An odd force has f_0(A, 0) = 0, and to first order the equations of A and phi do not contain B: the
Jacobian (28) says nothing of it, and B = 0 attracts if and only if d f_0/dB > 0 there.
"""

from __future__ import annotations

import sympy as sp

from derivations.averaging import DISPLACEMENT, psi
from derivations.symbols import A, h, h_A

_f = sp.Function("f")(DISPLACEMENT)


def mean_stiffness() -> sp.Expr:
    """d f_0/dB = (1/(2 pi)) int_0^{2 pi} f'(A cos psi) dpsi.

    Its integrand and that of the result differ by the derivative of a function that is periodic in psi.
    """
    slope = sp.diff(_f, A).doit() / sp.diff(DISPLACEMENT, A)
    of_h = -_f * sp.cos(psi) / sp.pi
    of_h_A = sp.diff(of_h, A).doit()
    periodic = -_f * sp.sin(psi) / (2 * sp.pi * A)
    result = -(h_A + h / A) / 2
    integrand = result.subs({h: of_h, h_A: of_h_A})
    if sp.simplify(slope / (2 * sp.pi) - integrand - sp.diff(periodic, psi).doit()) != 0:
        raise ArithmeticError("the mean stiffness does not follow from h and h_A")
    return result
