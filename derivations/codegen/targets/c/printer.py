"""SymPy expressions as C99, and the functions that they call."""

from __future__ import annotations

from typing import ClassVar

import sympy as sp
from sympy.codegen.cfunctions import hypot

from ....forces.quadrature import FUNCTIONS
from ...compensated import copysign, fma
from ..printing import SharedArctangent


class CPrinter(SharedArctangent):
    """C99, with math.h's functions, most of which have SymPy's names, and the arctangent of `arctangent`."""

    infinity = "INFINITY"
    functions: ClassVar = {function: function.__name__ for function in (*FUNCTIONS, sp.sqrt, sp.cbrt, hypot)} | {
        sp.Abs: "fabs",
        sp.Pow: "pow",
        fma: "fma",
        copysign: "copysign",
        sp.atan2: "angles_atan2",
    }
