"""A bilinear spring: stiffness k_1 up to |x| = d, k_2 beyond, without a jump of the force.

In:  two stiffnesses beside k_v and the displacement at which they change places.
Out: `MECHANISM`.
"""

import sympy as sp

from derivations.mechanisms import Mechanism, Parameter, Piece

x = sp.Symbol("x", real=True)
k_v, L, d = sp.symbols("k_v L d", positive=True)
k_1, k_2 = sp.symbols("k_1 k_2", real=True)
kappa_1, kappa_2 = sp.symbols("kappa_1 kappa_2", real=True)
delta = sp.Symbol("delta", positive=True)
alpha_1, alpha_2, u_d = sp.symbols("alpha_1 alpha_2 u_d", real=True)

MECHANISM = Mechanism(
    name="bilinear",
    title="bilinear spring: another stiffness beyond |x| = d",
    x=x,
    k_v=k_v,
    length=L,
    pieces=(Piece(k_1 * x, until=x - d), Piece(k_2 * x + (k_1 - k_2) * d)),
    design=(
        Parameter(kappa_1, "stiffness beside k_v up to d", "k_v"),
        Parameter(kappa_2, "stiffness beside k_v beyond d", "k_v"),
        Parameter(delta, "displacement d at which the stiffness changes", "L", above=0),
    ),
    ratios={kappa_1: k_1 / k_v, kappa_2: k_2 / k_v, delta: d / L},
    dimensional={k_1: kappa_1 * k_v, k_2: kappa_2 * k_v, d: delta * L},
    order=1,
    coefficients=({1: alpha_1}, {1: alpha_2}),
    breakpoints=(u_d,),
)
