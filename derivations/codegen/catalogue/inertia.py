"""The kernels of an excitation by inertia: what differs from those of a force.

In:  `Results`.
Out: `inertia_module`.
"""

from __future__ import annotations

from ...results import Results
from ..form import Module
from ..requests import requested


def inertia_module(results: Results) -> Module:
    """The mechanism-free functions; those of `slow_flow` that know no forcing hold here too."""
    return Module(
        name="inertia",
        title="Excitation by inertia, F_0 Omega^2: a base that shakes, an unbalance",
        inputs=("paper/equation_of_motion.py", "paper/averaging.py", "paper/slow_flow.py", "extensions/inertia.py"),
        **requested("inertia", results.inertia.kernels.values()),
    )
