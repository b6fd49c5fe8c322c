"""The paper's isolator with its force as the geometry gives it (5), not truncated.

In:  `rod_spring`, for geometry, ratios and reach.
Out: `MECHANISM`; two coefficients and the preload say all of the force.

Where the springs detach the force is as steep as 1/sqrt(1 - u_cr^2) = 1/(1 - delta_h). A double next to 1 does not say
1 - u_cr, but the one of delta_h says 1 - delta_h: so the kernels take delta_h, and u_cr follows from it.
"""

import dataclasses

import sympy as sp

from . import rod_spring

MECHANISM = dataclasses.replace(
    rod_spring.MECHANISM,
    name="rod_spring_untruncated",
    title=rod_spring.MECHANISM.title + ", force not truncated",
    order=sp.oo,
    coefficients=({1: rod_spring.alpha, 3: rod_spring.beta}, {}),
    instead=(rod_spring.delta_h,),
)
