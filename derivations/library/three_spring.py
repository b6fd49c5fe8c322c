"""Three springs, quasi-zero stiffness: a vertical one bears the load, two oblique ones take its stiffness away.

A. Carrella, M. J. Brennan, T. P. Waters, Static analysis of a passive vibration isolator with quasi-zero-stiffness
characteristic, J. Sound Vib. 301 (2007) 678.

    m x'' + c x' + F_c sign(x') + k_v x + F_k(x) = F cos(omega t)

    F_k(x) = 2 k_o (sqrt(a^2 + x^2) - L_o) x/sqrt(a^2 + x^2)

x is counted from where the oblique springs lie horizontal, which is where the load rests. They are longer than their
place there: L_o > a, so they push, and away from the middle. The stiffness is zero for k_o/k_v = 1/(2 (L_o/a - 1)).

In:  the stiffness k_o and free length L_o of an oblique spring, and a, half the distance of their feet.
Out: `MECHANISM`, with the cubic for the geometric force, as in the paper; docs/literature.md says how far that goes.
"""

import sympy as sp

from ..mechanisms import Mechanism, Parameter, Piece, k_v, x

k_o, L_o, a = sp.symbols("k_o L_o a", positive=True)
alpha, ell = sp.symbols("alpha ell", positive=True)
k_1, k_3 = sp.symbols("k_1 k_3", real=True)

length = sp.sqrt(a**2 + x**2)

MECHANISM = Mechanism(
    name="three_spring",
    title="mass on three springs, a vertical one and two oblique ones: quasi-zero stiffness",
    length=a,
    pieces=(Piece(2 * k_o * (length - L_o) * x / length),),
    design=(
        Parameter(alpha, "stiffness k_o of an oblique spring", "k_v", above=0),
        Parameter(ell, "free length L_o of an oblique spring", "a", above=1),
    ),
    ratios={alpha: k_o / k_v, ell: L_o / a},
    order=3,
    coefficients=({1: k_1, 3: k_3},),
    reach=sp.Rational(1, 2),
    reach_reason="the cubic approximation of the oblique springs' force is 18 % too high there",
)
