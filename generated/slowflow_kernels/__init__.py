"""Kernels derived from the equation of motion, printed for NumPy. Written by `make derive`; never edit.

    from slowflow_kernels import rod_spring

Nothing is imported before it is used. Everything is dimensionless. Arguments broadcast; each output has their common
shape, NumPy scalars for scalars, where arguments are of type ArrayLike. Where they are of type Any they may be any kind
of number that has arithmetic, as complex numbers or an integrator's symbols, and each output has the shape of those that
it depends on.

Each docstring gives equation number, domain and floating-point operations, by regime where there are several. Rounding
errors are in u (1 + kappa), u = 2^-53: proved ones hold wherever nothing overflows or underflows, measured ones are the
worst of all outputs that a search found, with the arguments that the module's docstring states.
"""

import importlib

MODULES = (
    "slow_flow",
    "frequencies",
    "inertia",
    "off_centre",
    "dissipation",
    "linearization",
    "sensitivities",
    "sampled",
    "motion",
    "second_approximation",
    "den_hartog",
    "duffing",
    "rod_spring",
    "rod_spring_untruncated",
)

__all__ = ["MODULES", *MODULES]


def __getattr__(name):
    if name in MODULES:
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
