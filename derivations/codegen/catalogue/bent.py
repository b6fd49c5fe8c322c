"""Beside the closed average of a piecewise polynomial: what holds it between two amplitudes, where that is not proved.

In:  the mechanism's module, and its steps of the derivation.
Out: `with_bends`, the module with enclosures of h and h_AAAA, of which solvers of any force make their search.
"""

from __future__ import annotations

from dataclasses import replace

from ...forces.of_mechanism import OfMechanism
from ...forces.quadrature import Quadrature
from ..form import Module
from .quadrature import enclosed, kink_kernel


def with_bends(module: Module, derived: OfMechanism) -> Module:
    """The same, searched by enclosures; the average is the closed one."""
    mechanism = derived.oscillator.mechanism
    average = Quadrature(tuple(derived.oscillator.polynomials), {end: end for end in mechanism.breakpoints})
    kernels = (*module.kernels, kink_kernel(mechanism.parameters, average))
    return replace(module, kernels=kernels, enclosed=enclosed(mechanism, average))
