"""The kernels of other laws of damping: functions of I_0, the part of I that knows no frequency, and of d.

In:  `Results`.
Out: `dissipation_module`.
"""

from __future__ import annotations

from ...results import Results
from ..form import Module
from ..requests import requested


def dissipation_module(results: Results) -> Module:
    """The mechanism-free functions; R, and what contains I as a number, are those of `slow_flow`."""
    return Module(
        name="dissipation",
        title="Structural and quadratic damping, and dry friction of what is attached",
        inputs=("paper/averaging.py", "paper/slow_flow.py", "extensions/dissipation.py"),
        **requested("dissipation", results.dissipation.kernels.values()),
    )
