"""All of the catalogue: the generated modules in their order.

In:  `Results`.
Out: `all_modules`.
"""

from __future__ import annotations

from ...results import Results
from ..form import Module
from .beyond import den_hartog_module, second_approximation_module
from .flow import slow_flow_modules
from .frequencies import frequencies_module
from .mechanism import mechanism_module, with_proofs
from .sensitivities import sensitivities_module
from .stated import stated_module


def all_modules(results: Results) -> list[Module]:
    """Every generated module, in the order in which they depend on one another."""
    flows = slow_flow_modules(results)
    return [
        *flows,
        frequencies_module(results),
        stated_module("inertia", results),
        stated_module("off_centre", results),
        stated_module("dissipation", results),
        sensitivities_module(results),
        stated_module("sampled", results),
        stated_module("motion", results),
        second_approximation_module(results),
        den_hartog_module(results),
        *(
            with_proofs(mechanism_module(results.mechanisms, name, flows[0]), derived)
            for name, derived in results.mechanisms.items()
        ),
    ]
