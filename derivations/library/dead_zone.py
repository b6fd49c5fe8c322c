"""Play: no force up to |x| = d, a spring beyond, as between the teeth of gears.

    m x'' + c x' + F_c sign(x') + f(x) = F cos(omega t)

    f(x) = 0                       |x| <= d
    f(x) = k_v (|x| - d) sign(x)   |x| > d

In:  the play d. The spring is k_v: what is stated below is f less k_v x.
Out: `MECHANISM`.
"""

import sympy as sp

from ..mechanisms import L, Mechanism, Parameter, Piece, k_v, x

d, delta = sp.symbols("d delta", positive=True)
alpha_1, u_d = sp.symbols("alpha_1 u_d", real=True)

MECHANISM = Mechanism(
    name="dead_zone",
    title="mass with a dead zone between springs",
    pieces=(Piece(-k_v * x, until=x - d), Piece(-k_v * d)),
    design=(Parameter(delta, "clearance d on either side", "L", above=0),),
    ratios={delta: d / L},
    order=1,
    coefficients=({1: alpha_1}, {}),
    breakpoints=(u_d,),
)
