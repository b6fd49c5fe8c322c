"""SymPy expressions as NumPy source."""

from __future__ import annotations

import re
from typing import ClassVar

import sympy as sp
from sympy.codegen.cfunctions import hypot

from ....forces.quadrature import FUNCTIONS
from ...compensated import copysign
from ..printing import InPython


class NumpyPrinter(InPython):
    """NumPy, imported as np; an inverse is arcsin, not asin."""

    functions: ClassVar = {function: f"np.{re.sub('^a', 'arc', function.__name__)}" for function in FUNCTIONS} | {
        sp.sqrt: "np.sqrt",
        sp.cbrt: "np.cbrt",
        hypot: "np.hypot",
        sp.Abs: "np.abs",
        sp.Pow: "np.power",
        copysign: "np.copysign",
        sp.atan2: "np.arctan2",
    }
