"""The paper's isolator: horizontal springs on a push-rod, which they leave when they reach their free length (2).

In:  the geometry, as sketched in the paper's Figure 1.
Out: `MECHANISM`, the force as the geometry gives it; the Taylor coefficients and u_cr are derived, not stated.
"""

import sympy as sp

from . import L, Mechanism, Parameter, Piece, k_v, x

k_h, Delta_h = sp.symbols("k_h Delta_h", positive=True)
lam, r, delta_h = sp.symbols("lam r delta_h", positive=True)

# A rod of length L, hinged L from the line of the mass: at displacement x its end stands sqrt(L^2 - x^2) away. The
# spring is compressed by Delta_h at x = 0 and has lost that compression where the rod has drawn back by Delta_h.
projection = sp.sqrt(L**2 - x**2)
compression = Delta_h - (L - projection)
horizontal_force = lam * k_h * compression
vertical_component = -horizontal_force * x / projection

alpha, beta, gamma, u_cr = sp.symbols("alpha beta gamma u_cr", real=True)

MECHANISM = Mechanism(
    name="rod_spring",
    title="mass on a vertical spring, with preloaded horizontal springs on a push-rod that detach at u_cr",
    pieces=(Piece(vertical_component, until=compression), Piece(sp.Integer(0))),
    design=(
        Parameter(lam, "number of horizontal springs", "1", above=0),
        Parameter(r, "stiffness k_h of one of them", "k_v", above=0),
        Parameter(delta_h, "their preload Delta_h; 0 is a linear oscillator", "L", least=0, below=1),
    ),
    ratios={lam: lam, r: k_h / k_v, delta_h: Delta_h / L},
    order=5,
    coefficients=({1: alpha, 3: beta, 5: gamma}, {}),
    breakpoints=(u_cr,),
    reach=sp.Integer(1),
    reach_reason="the push-rod stands vertical",
)
