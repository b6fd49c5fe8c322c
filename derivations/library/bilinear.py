"""A bilinear spring: stiffness k_v up to |x| = d, k_2 beyond, without a jump of the force.

    m x'' + c x' + F_c sign(x') + k_v x + F_k(x) = F cos(omega t)

    F_k(x) = 0                               |x| <= d
    F_k(x) = (k_2 - k_v) (|x| - d) sign(x)   |x| > d

In:  the stiffness k_2 and the displacement d at which it takes over; k_2 < k_v softens, k_2 = 0 slips like a clutch.
Out: `MECHANISM`.
"""

import sympy as sp

from ..mechanisms import L, Mechanism, Parameter, Piece, k_v, x

k_2, kappa = sp.symbols("k_2 kappa", real=True)
d, delta = sp.symbols("d delta", positive=True)
alpha_2, u_d = sp.symbols("alpha_2 u_d", real=True)

MECHANISM = Mechanism(
    name="bilinear",
    title="mass on a bilinear spring, whose stiffness changes at |x| = d",
    pieces=(Piece(sp.Integer(0), until=x - d), Piece((k_2 - k_v) * (x - d))),
    design=(
        Parameter(kappa, "stiffness k_2 beyond d", "k_v"),
        Parameter(delta, "displacement d at which the stiffness changes", "L", above=0),
    ),
    ratios={kappa: k_2 / k_v, delta: d / L},
    order=1,
    coefficients=({}, {1: alpha_2}),
    breakpoints=(u_d,),
)
