"""All of the catalogue: the generated modules in their order.

In:  `Results`.
Out: `all_modules`.
"""

from __future__ import annotations

from ...results import Results
from ..form import Module
from .flow import slow_flow_module
from .frequencies import frequencies_module
from .mechanism import mechanism_module, with_proofs
from .stated import MODULES, stated_module


def all_modules(results: Results) -> list[Module]:
    """Every generated module, in the order in which they depend on one another."""
    flow = slow_flow_module(results)
    return [
        flow,
        frequencies_module(results),
        *(stated_module(name, results) for name in MODULES),
        *(
            with_proofs(mechanism_module(results.mechanisms, name, flow), derived)
            for name, derived in results.mechanisms.items()
        ),
    ]
