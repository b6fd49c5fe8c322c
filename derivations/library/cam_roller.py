"""Cams between rollers, which leave them: quasi-zero stiffness that ends where the rollers pass onto the cams' flanks.

Such an isolator: J. Zhou, X. Wang, D. Xu, S. Bishop, J. Sound Vib. 346 (2015) 53. The force here follows from the
geometry; no formula is taken from there.

A round cam of radius R - r_r on either side of the mass, with a straight flank above and below; against each a roller
of radius r_r on a horizontal spring. Where the cam is touched the centres are R apart, sqrt(R^2 - x^2) of it across.
Where that has come down to r_r the roller touches the flank, at |x| = x_d: its spring is still compressed by C, but
pushes straight across. So the vertical force ends there, with a jump unless C = 0.

    m x'' + c x' + F_c sign(x') + k_v x + F_k(x) = F cos(omega t)

    F_k(x) = -2 k_h (C + sqrt(R^2 - x^2) - r_r) x/sqrt(R^2 - x^2)   |x| <= x_d = sqrt(R^2 - r_r^2)
    F_k(x) = 0                                                      |x| > x_d

In:  the stiffness k_h of a horizontal spring, R, r_r and C.
Out: `MECHANISM`, truncated at the fifth order as the paper's isolator is.
"""

import sympy as sp

from ..mechanisms import Mechanism, Parameter, Piece, k_v, x

k_h, R, r_r, C = sp.symbols("k_h R r_r C", positive=True)
r, rho, c = sp.symbols("r rho c", positive=True)
alpha, beta, gamma, u_d = sp.symbols("alpha beta gamma u_d", real=True)

across = sp.sqrt(R**2 - x**2)

MECHANISM = Mechanism(
    name="cam_roller",
    title="mass on a vertical spring, with cams between rollers that disengage at u_d",
    length=R,
    pieces=(Piece(-2 * k_h * (C + across - r_r) * x / across, until=across - r_r), Piece(sp.Integer(0))),
    design=(
        Parameter(r, "stiffness k_h of a horizontal spring", "k_v", above=0),
        Parameter(rho, "radius r_r of a roller", "R", above=0, below=1),
        Parameter(c, "compression C of a spring whose roller is on the flank", "R", least=0),
    ),
    ratios={r: k_h / k_v, rho: r_r / R, c: C / R},
    order=5,
    coefficients=({1: alpha, 3: beta, 5: gamma}, {}),
    breakpoints=(u_d,),
)
