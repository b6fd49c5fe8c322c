"""The paper's isolator with its force as the geometry gives it (5), not truncated.

In:  `rod_spring`, for geometry, ratios and reach.
Out: `MECHANISM`; two coefficients and u_cr say all of the force.
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
)
