"""An elastic stop behind a gap on one side only: free of it up to x = d, against it beyond.

    m x'' + c x' + F_c sign(x') + f(x) = F cos(omega t)

    f(x) = k_v x                 x <= d
    f(x) = k_v x + k_s (x - d)   x > d

Such a force is not odd: motions that reach the stop have a mean. It is stated without dimensions, with the length L of
which the gap is a share: f over k_v L, in u = x/L.

In:  the stiffness k_s of the stop and the gap d; with d < 0 the stop presses on a mass at x = 0.
Out: `MECHANISM`, a `Sided`.
"""

import sympy as sp

from ..asymmetric.sided import Sided
from ..mechanisms import Parameter
from ..symbols import u

kappa = sp.Symbol("kappa", positive=True)
delta = sp.Symbol("delta", real=True)

MECHANISM = Sided(
    name="one_sided_stop",
    title="mass on a spring, with an elastic stop with a gap on one side",
    pieces=(u, u + kappa * (u - delta)),
    ends=(delta,),
    design=(
        Parameter(kappa, "stiffness k_s of the stop", "k_v", above=0),
        Parameter(delta, "gap d to the stop, < 0 where it presses on a mass at x = 0", "L"),
    ),
)
