"""Beside (28)-(30): whether a motion about the centre stays there; (11) with a small mean offset B.

In:  the shape of an odd force f(u) = u + F_k(u) alone, and h = -(1/pi) int_0^{2 pi} f(A cos psi) cos psi dpsi.
Out: `Formulas`: `mean_stiffness` in A, h and h_A; `offset_stiffness` in Omega as well: what carries B back to 0 where
     positive.

A small d beside u = A cos psi obeys d'' + ... + f'(A cos psi) d = 0 (damping left out: it cannot hold what is driven
away). The stiffness k_0 + k_2 cos 2 psi + ... is even and of half the period, so that d = B + b cos 2 psi is apart from
the perturbations of A and phi, of which the Jacobian (28) tells. With the harmonics of d taken this far

    B'' + k_0 B + k_2 b/2 = 0        (k_0 - 4 Omega^2) b + k_2 B = 0

so B is carried back by k_0 + k_2^2/(2 (4 Omega^2 - k_0)). Where the mean stiffness k_0 is positive and below 4 Omega^2
that is positive too; where it is negative the cycle's changing stiffness may still hold the motion at the centre.
"""

from __future__ import annotations

import sympy as sp

from ..claims import claim
from ..kernels import Branch, Formulas
from ..paper.averaging import DISPLACEMENT, psi
from ..symbols import A, Omega, h, h_A

_f = sp.Function("f")(DISPLACEMENT)
_B, _b = sp.symbols("B b", real=True)


def _integral(integrand: sp.Expr, result: sp.Expr, multiple: sp.Expr) -> sp.Expr:
    """The result, a combination of h and h_A, if it is the integral of this multiple of f' (A cos psi) over a cycle.

    The integrands may differ by the derivative of a function that is periodic in psi: a multiple of f sin psi.
    """
    slope = sp.diff(_f, A).doit() / sp.diff(DISPLACEMENT, A)
    of_h = -_f * sp.cos(psi) / sp.pi
    of_h_A = sp.diff(of_h, A).doit()
    difference = multiple * integrand * slope - result.subs({h: of_h, h_A: of_h_A})
    fraction = sp.Symbol("share")
    apart = sp.expand(sp.expand_trig(difference - fraction * sp.diff(_f * sp.sin(psi), psi).doit()))
    apart = sp.expand(apart.subs(sp.sin(psi) ** 2, 1 - sp.cos(psi) ** 2))
    if not sp.solve(sp.Poly(apart, _f, slope, sp.cos(psi)).coeffs(), fraction):
        raise ArithmeticError(f"{result} is not the integral of {integrand} f'")
    return result


def offset() -> Formulas:
    """Both, by k_0 = (1/(2 pi)) int_0^{2 pi} f'(A cos psi) dpsi and k_2 = (1/pi) int f'(A cos psi) cos 2 psi dpsi."""
    of = Formulas((Omega, A, h, h_A))
    k_0 = _integral(sp.Integer(1), -(h_A + h / A) / 2, 1 / (2 * sp.pi))
    text = "Mean of the stiffness over a cycle of a motion about u = 0, which stays about it where this is positive."
    of.add("mean_stiffness", k_0, text, "beside (30)", "A > 0")

    @of.kernel("beside (30)")
    def offset_stiffness() -> tuple[Branch, Branch]:
        """What carries a small mean offset back; where the mean stiffness is negative this decides.

        apart -- k_0 + k_2^2/(2 (4 Omega^2 - k_0)): of the two one may be one and a half times the result where h/A and
                 Omega^2 are small beside h_A
        over  -- over D = 2 (4 Omega^2 - k_0), with its powers of h_A and h/A gathered: of no use where D is a small
                 difference, which then counts twice; where half of |h/A| + |h_A| is not larger than |D|
        """
        k_2 = _integral(sp.cos(2 * psi), h / A - h_A, 1 / sp.pi)
        k = sp.symbols("k_0 k_2", real=True)
        alternating = sp.solve((k[0] - 4 * Omega**2) * _b + k[1] * _B, _b)[0]
        carried = sp.expand((k[0] * _B + k[1] * alternating / 2) / _B)
        structured = k[0] + k[1] ** 2 / (2 * (4 * Omega**2 - k[0]))
        claim(
            "stiffness against a mean offset: `k_0 + k_2^2/(2 (4 Omega^2 - k_0))`",
            carried - structured,
            eq="in addition to (30)",
        )
        apart = structured.subs(dict(zip(k, (k_0, k_2), strict=True)))
        q = sp.Symbol("q", real=True)
        D = 2 * (4 * Omega**2 - k_0)
        whole = sp.expand(sp.cancel(apart * D).subs(h, q * A))
        of_h_A = sp.factor_terms(sp.expand(whole - whole.subs(h_A, 0)) / h_A)
        of_h_A, of_q = (sp.expand(part) for part in (of_h_A, whole.subs(h_A, 0) / q))
        over = ((h_A * of_h_A + q * of_q) / D).subs(q, h / A)
        claim("both forms of the stiffness against a mean offset are equal", over - apart, eq="in addition to (30)")
        far = (sp.Abs(h / A) / 2 + sp.Abs(h_A) / 2, sp.Abs(D))
        return Branch("over", (far,), (), (over,)), Branch("apart", (), (), (apart,))

    return of
