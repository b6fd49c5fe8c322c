"""Kernels derived from the equation of motion, printed for NumPy. Written by `make derive`; never edit.

    from slowflow_kernels import rod_spring

Nothing is imported before it is used. Everything is dimensionless; arguments broadcast like a ufunc's.
"""

import importlib

MODULES = (
    "slow_flow",
    "slow_flow_mu0",
    "slow_flow_zeta0",
    "slow_flow_mu0_zeta0",
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
