"""The Duffing oscillator with viscous and dry friction damping: one polynomial of degree five, no breakpoint.

In:  a spring of linear, cubic and quintic stiffness beside k_v.
Out: `MECHANISM`; its whole restoring force is alpha u + beta u^3 + gamma u^5 once made dimensionless.
"""

import sympy as sp

from . import L, Mechanism, Parameter, Piece, k_v, x

k_1, k_3, k_5 = sp.symbols("k_1 k_3 k_5", real=True)
kappa_1, kappa_3, kappa_5 = sp.symbols("kappa_1 kappa_3 kappa_5", real=True)
alpha, beta, gamma = sp.symbols("alpha beta gamma", real=True)

MECHANISM = Mechanism(
    name="duffing",
    title="Duffing oscillator: one polynomial of degree five, no breakpoint",
    pieces=(Piece(k_1 * x + k_3 * x**3 + k_5 * x**5),),
    design=(
        Parameter(alpha, "linear stiffness k_v + k_1; alpha <= 0 is allowed", "k_v"),
        Parameter(beta, "cubic stiffness k_3; beta < 0 softens", "k_v/L^2"),
        Parameter(gamma, "quintic stiffness k_5; 0 is a cubic spring", "k_v/L^4"),
    ),
    ratios={kappa_1: k_1 / k_v, kappa_3: k_3 * L**2 / k_v, kappa_5: k_5 * L**4 / k_v},
    order=5,
    coefficients=({1: alpha, 3: beta, 5: gamma},),
)
