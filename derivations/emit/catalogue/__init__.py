"""The catalogue: which functions each generated module holds, with their arguments, equation numbers and domains.

In:  `Results`.
Out: `all_modules`: `Module`s of `Kernel`s (expressions to print) and `Composition`s (calls of other kernels).
"""

from __future__ import annotations

from derivations.emit.catalogue.beyond import den_hartog_module, second_approximation_module
from derivations.emit.catalogue.flow import slow_flow_modules
from derivations.emit.catalogue.frequencies import frequencies_module
from derivations.emit.catalogue.mechanism import mechanism_module
from derivations.emit.catalogue.motion import motion_module
from derivations.emit.form import Module
from derivations.results import Results


def all_modules(results: Results) -> list[Module]:
    """Every generated module, in the order in which they depend on one another."""
    flows = slow_flow_modules(results)
    return [
        *flows,
        frequencies_module(results),
        motion_module(results),
        second_approximation_module(results),
        den_hartog_module(results),
        *(mechanism_module(results, name, flows[0]) for name in results.mechanisms),
    ]
