"""Which text of kernels in C holds for numbers of two kinds.

In:  a `Module` with the straight-line code of its kernels.
Out: its `KernelView`s that stand in MODULE_generic.h, with the branches that are in both.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..common import LEAST_SAVED
from ..form import Module
from ..views import BranchView, Code, KernelView
from . import interval, pair


def in_both(module: Module, code: Code) -> tuple[str, list[KernelView]]:
    """What intervals share with pairs, or in a module without these with doubles, as long as that saves lines.

    And the folder of its header. Digits of pairs and the widths of proofs depend on the order of operations.
    """
    doubled = interval.as_doubles(module, code)
    texts = {text(one, branch) for one in doubled or pair.in_c(module, code) for branch in one.branches}
    shared = [
        replace(one, branches=tuple(branch for branch in one.branches if text(one, branch) in texts))
        for one in interval.in_c(module, code)
    ]
    if sum(len(branch.lets) + len(branch.outputs) for one in shared for branch in one.branches) < LEAST_SAVED:
        return "", []
    return "c" if doubled else "native", [one for one in shared if one.branches]


def without(printed: KernelView, shared: Sequence[KernelView]) -> KernelView:
    """A kernel with what is left of its branches."""
    gone = {text(one, branch) for one in shared for branch in one.branches}
    return replace(printed, branches=tuple(branch for branch in printed.branches if text(printed, branch) not in gone))


def text(printed: KernelView, branch: BranchView) -> tuple[object, ...]:
    """What a function is: its name and lines."""
    return printed.kernel.name, branch.name, branch.lets, branch.outputs
