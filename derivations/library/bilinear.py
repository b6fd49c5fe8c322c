"""A bilinear spring: stiffness k_v up to |x| = d, k_2 beyond, without a jump of the force.

    m x'' + c x' + F_c sign(x') + k_v x + F_k(x) = F cos(omega t)

    F_k(x) = 0                               |x| <= d
    F_k(x) = (k_2 - k_v) (|x| - d) sign(x)   |x| > d

In:  the stiffness k_2 and the displacement d at which it takes over; k_2 < k_v softens, k_2 = 0 slips like a clutch.
Out: `MECHANISM`.
"""

import sympy as sp

from ..mechanisms import Mechanism, Parameter, Piece

x = sp.Symbol("x", real=True)
k_v, L, d = sp.symbols("k_v L d", positive=True)
k_2 = sp.Symbol("k_2", real=True)
kappa = sp.Symbol("kappa", real=True)
delta = sp.Symbol("delta", positive=True)
alpha_2, u_d = sp.symbols("alpha_2 u_d", real=True)

MECHANISM = Mechanism(
    name="bilinear",
    title="mass on a bilinear spring, whose stiffness changes at |x| = d",
    x=x,
    k_v=k_v,
    length=L,
    pieces=(Piece(sp.Integer(0), until=x - d), Piece((k_2 - k_v) * (x - d))),
    design=(
        Parameter(kappa, "stiffness k_2 beyond d", "k_v"),
        Parameter(delta, "displacement d at which the stiffness changes", "L", above=0),
    ),
    ratios={kappa: k_2 / k_v, delta: d / L},
    dimensional={k_2: kappa * k_v, d: delta * L},
    order=1,
    coefficients=({}, {1: alpha_2}),
    breakpoints=(u_d,),
)
