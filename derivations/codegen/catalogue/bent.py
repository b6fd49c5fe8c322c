"""Beside the closed average of a piecewise polynomial: what holds it between two amplitudes, where that is not proved.

In:  the mechanism's module, and its steps of the derivation.
Out: `with_bends`, the module with enclosures of h and h_AAAA, of which solvers of any force make their search.
"""

from __future__ import annotations

from dataclasses import replace

from ...forces.of_mechanism import OfMechanism
from ...forces.quadrature import Quadrature
from ..form import Module
from .force import formulas
from .quadrature import enclosed, state_kinks


def with_bends(module: Module, derived: OfMechanism) -> Module:
    """The same, searched by enclosures; the average is the closed one."""
    mechanism = derived.oscillator.mechanism
    average = Quadrature(tuple(derived.oscillator.polynomials), {end: end for end in mechanism.breakpoints})
    of = formulas(mechanism.parameters)
    state_kinks(of, average)
    stated = (*module.stated, *of.kernels.values())
    return replace(module, stated=stated, enclosed=enclosed(mechanism, average))
