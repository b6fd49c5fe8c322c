"""The Duffing oscillator with viscous and dry friction damping: one cubic piece, no breakpoint.

In:  a spring of linear and cubic stiffness beside k_v.
Out: `MECHANISM`; its whole restoring force is alpha u + beta u^3 once made dimensionless.
"""

import sympy as sp

from . import L, Mechanism, Parameter, Piece, k_v, x

k_1, k_3 = sp.symbols("k_1 k_3", real=True)
kappa_1, kappa_3 = sp.symbols("kappa_1 kappa_3", real=True)
alpha, beta = sp.symbols("alpha beta", real=True)

MECHANISM = Mechanism(
    name="duffing",
    title="Duffing oscillator: one cubic piece, no breakpoint",
    pieces=(Piece(k_1 * x + k_3 * x**3),),
    design=(
        Parameter(alpha, "linear stiffness k_v + k_1; alpha <= 0 is allowed", "k_v"),
        Parameter(beta, "cubic stiffness k_3; beta < 0 softens", "k_v/L^2"),
    ),
    ratios={kappa_1: k_1 / k_v, kappa_3: k_3 * L**2 / k_v},
    order=3,
    coefficients=({1: alpha, 3: beta},),
)
