"""All of the catalogue: the generated modules in their order.

In:  `Results`.
Out: `all_modules`.
"""

from __future__ import annotations

from ...results import Results
from ..form import Module
from .beyond import den_hartog_module, second_approximation_module
from .dissipation import dissipation_module
from .flow import slow_flow_modules
from .frequencies import frequencies_module
from .inertia import inertia_module
from .mechanism import mechanism_module, with_proofs
from .motion import motion_module
from .off_centre import off_centre_module
from .sampled import sampled_module
from .sensitivities import sensitivities_module


def all_modules(results: Results) -> list[Module]:
    """Every generated module, in the order in which they depend on one another."""
    flows = slow_flow_modules(results)
    return [
        *flows,
        frequencies_module(results),
        inertia_module(results),
        off_centre_module(results),
        dissipation_module(results),
        sensitivities_module(results),
        sampled_module(results),
        motion_module(results),
        second_approximation_module(results),
        den_hartog_module(results),
        *(
            with_proofs(mechanism_module(results.mechanisms, name, flows[0]), derived)
            for name, derived in results.mechanisms.items()
        ),
    ]
