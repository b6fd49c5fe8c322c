"""The kernels of the slow flow: functions of Omega, A, damping and h that know no mechanism, one module for each scene.

In:  `Results`.
Out: `slow_flow_modules`.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...kernels import Formulas, Kernel
from ...paper.slow_flow import SCENES, m
from ...results import Results
from ...symbols import mu
from ..form import GENERAL, Module, in_words, suffix
from ..requests import REQUESTS, requested

#: what a scene has of its own: where the mathematics changes. Elsewhere the general form divides by what vanishes, has
#: more coefficients, or a sum for a product
OWN = {
    "mu0": ("response_quartic", "detachment", "isola", "fold"),
    "zeta0": ("limit_envelope", "detachment", "fold", "undamped_Omega", "undamped_level", "undamped_rises", "undamped"),
    "mu0_zeta0": ("detachment",),
}
#: what else is asked in a scene, of a module in which less vanishes: `no_other` proves that it is the same there
IN_SCENES = (
    *("R", "I", "F", "F_A", "F_AA", "F_Omega", "F_AOmega", "level", "stability", "phase"),
    *("backbone", "limit_envelope", "equivalent_damping", "isola_Omega"),
    *("response_quartic", "fold_quartic", "peak_cubic"),
)


def slow_flow_modules(results: Results) -> list[Module]:
    """The mechanism-free functions, in general and in each scene."""
    kernels = {}
    for scene in SCENES:
        steps = [results.flows[scene], results.detachment[scene], results.along[scene]]
        steps += [] if scene else [results.offset, results.slopes, results.steps]
        kernels[scene] = {kernel.name: kernel for step in steps for kernel in step.kernels.values()}
    return [slow_flow_module(kernels, scene, results.flows[scene]) for scene in SCENES]


def slow_flow_module(kernels: Mapping[str, Mapping[str, Kernel]], scene: str, flow: Formulas) -> Module:
    """All of the general scene's; of another its own, and what it has on intervals alone."""
    name = GENERAL + suffix(scene)
    stated = kernels[scene].values()
    if scene:
        own = {*OWN[scene], *REQUESTS.get(name, {}).get("cells", "").split()}
        stated = [kernel for kernel in stated if kernel.name in own]
    return Module(
        name=name,
        title="Slow flow of any mechanism, in h = H - A and its derivatives" + in_words(scene),
        inputs=(
            "paper/averaging.py",
            "paper/slow_flow.py",
            "asymmetric/offset.py",
            "systems/along.py",
            "systems/slopes.py",
            "systems/newton.py",
            "paper/critical_forcings.py",
        ),
        borrowed=borrowed(kernels, scene) if scene else {},
        constants={"SCENE": description(flow, scene)},
        **requested(name, stated),
    )


def borrowed(kernels: Mapping[str, Mapping[str, Kernel]], scene: str) -> dict[str, tuple[str, ...]]:
    """What a scene has from other modules, by these: where less of it vanishes, or nothing."""
    zeros = {symbol for symbol in SCENES[scene]}
    others = [other for other in SCENES if other != scene and SCENES[other].keys() <= zeros]
    found: dict[str, list[str]] = {}
    for name in dict.fromkeys((*IN_SCENES, *(name for other in others for name in OWN.get(other, ())))):
        if name in kernels[scene] and name not in OWN[scene]:
            # the last that has it of its own
            other = [other for other in others if not other or name in OWN[other]][-1]
            no_other(kernels[other][name], kernels[scene][name], scene)
            found.setdefault(GENERAL + suffix(other), []).append(name)
    return {module: tuple(names) for module, names in found.items()}


def no_other(kernel: Kernel, in_scene: Kernel, scene: str) -> None:
    """That a kernel, where the scene's zeros are put in, is the one which is derived in the scene."""
    zeros = {m if symbol == mu else symbol: 0 for symbol in SCENES[scene]}
    if not set(in_scene.arguments) <= set(kernel.arguments) or kernel.width != in_scene.width:
        raise ArithmeticError(f"{kernel.name} takes or gives something else in the scene {scene}")
    for here, there in zip(whole(kernel), whole(in_scene), strict=True):
        left, right = here.subs(zeros), there.subs(zeros)
        if left != right and sp.simplify(left - right) != 0:
            raise ArithmeticError(f"{kernel.name} in the scene {scene}: {left} is not {right}")


def whole(kernel: Kernel) -> list[sp.Expr]:
    """Its outputs in its arguments."""
    (branch,) = kernel.branches
    outputs = list(branch.outputs)
    for symbol, value in reversed(branch.lets):
        outputs = [output.subs(symbol, value) for output in outputs]
    return outputs


def description(flow: Formulas, scene: str) -> str:
    """A scene in words: which damping terms vanish, and what F is for it."""
    vanishing = SCENES[scene]
    damping = " = ".join([*(symbol.name for symbol in vanishing), "0"]) if vanishing else "mu > 0, zeta > 0"
    if flow.response_quartic[1] == 0:
        return f"{damping}: F is a quadratic in Omega^2, roots in closed form"
    return f"{damping}: F is a quartic in Omega"
