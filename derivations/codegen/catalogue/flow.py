"""The kernels of the slow flow: functions of Omega, A, damping and h that know no mechanism.

In:  `Results`.
Out: `slow_flow_module`.
"""

from __future__ import annotations

from dataclasses import replace

from ...kernels import Kernel
from ...paper.slow_flow import SCENES, m
from ...results import Results
from ...symbols import mu
from ..form import GENERAL, Module
from ..requests import requested

#: what is taken from a scene where some damping vanishes: there the general form divides by what is 0, has more
#: coefficients, or a sum for a product. Everything else holds there unchanged
OWN = {
    "mu0": ("response_quartic", "detachment", "isola", "fold", "F_Omega_reduced"),
    "zeta0": (
        *("detachment", "fold", "F_Omega_reduced"),
        *("undamped_Omega", "undamped_level", "undamped_rises", "undamped"),
    ),
    "mu0_zeta0": ("detachment",),
}


def slow_flow_module(results: Results) -> Module:
    """All functions of the general scene, and those of `OWN`, with the scene behind a name that both have."""
    kernels: dict[str, Kernel] = {}
    for scene, vanishing in SCENES.items():
        steps = [results.flows[scene], results.detachment[scene], results.along[scene]]
        steps += [] if scene else [results.offset, results.slopes, results.steps]
        stated = {name: kernel for step in steps for name, kernel in step.kernels.items()}
        zeros = "".join(f"{m if symbol == mu else symbol} = 0, " for symbol in vanishing)
        for name in OWN.get(scene, stated):
            called = f"{name}_{scene}" if name in kernels else name
            kernels[called] = replace(stated[name], name=called, domain=zeros + stated[name].domain)
    return Module(
        name=GENERAL,
        title="Slow flow of any mechanism, in h = H - A and its derivatives",
        inputs=(
            "paper/averaging.py",
            "paper/slow_flow.py",
            "asymmetric/offset.py",
            "systems/along.py",
            "systems/slopes.py",
            "systems/newton.py",
            "paper/critical_forcings.py",
        ),
        stated=requested(GENERAL, kernels.values()),
    )
