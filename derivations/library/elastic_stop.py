"""Elastic stops behind a gap, one on either side: free of them up to |x| = d, against one of them beyond.

    m x'' + c x' + F_c sign(x') + k_v x + F_k(x) = F cos(omega t)

    F_k(x) = 0                       |x| <= d
    F_k(x) = k_s (|x| - d) sign(x)   |x| > d

In:  the stiffness k_s of a stop and the gap d.
Out: `MECHANISM`.
"""

import sympy as sp

from ..mechanisms import L, Mechanism, Parameter, Piece, k_v, x

k_s, kappa, d, delta = sp.symbols("k_s kappa d delta", positive=True)
alpha_2, u_d = sp.symbols("alpha_2 u_d", real=True)

MECHANISM = Mechanism(
    name="elastic_stop",
    title="mass on a spring, between two elastic stops with a gap",
    pieces=(Piece(sp.Integer(0), until=x - d), Piece(k_s * (x - d))),
    design=(
        Parameter(kappa, "stiffness k_s of a stop", "k_v", above=0),
        Parameter(delta, "gap d to a stop", "L", above=0),
    ),
    ratios={kappa: k_s / k_v, delta: d / L},
    order=1,
    coefficients=({}, {1: alpha_2}),
    breakpoints=(u_d,),
)
