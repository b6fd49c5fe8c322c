"""Designs abreast: in go models of one kind, out comes one model whose numbers are arrays, an element for each design.

A search on NumPy takes most of its time between operations, so that one which looks at many designs together takes a
fraction of what it takes for each. Samples say which of the designs they are of, and kernels take the numbers of those.
What a word says of a design, as its scene, or how its force jumps, is the same for all.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from slowflow.averaged.reference.roots import taken
from slowflow.model import Model

#: what is the same for all
_SAME = ("mechanism", "flow", "excitation", "laws", "undamped", "_begins_beyond")


def may_go(model: Model) -> bool:
    """Whether a design may go with others: of a force, by friction and viscous damping, its averages in closed form."""
    closed = model.native is None and model.mechanism.enclosed is None and model.mechanism.odd
    return closed and not (model.inertial or model.laws.any or model.linear)


def kind(model: Model) -> Hashable:
    """What designs have in common that go together."""
    jumps = [(jump != 0, slope != 0, bend != 0) for jump, (slope, bend) in zip(model.jumps, model.kinks, strict=True)]
    return model.mechanism, model.flow, *jumps, model._begins_beyond


class Abreast(Model):
    """Designs of one kind as one model: what is a number of a single one is an array here.

    each -- these designs
    """

    each: tuple[Model, ...]

    def __init__(self, models: Sequence[Model]) -> None:
        def numbers(name: str) -> Any:
            return np.array([getattr(one, name) for one in models])

        self.__dict__.update({name: getattr(models[0], name) for name in _SAME}, abreast=len(models), native=None)
        self.__dict__["each"] = tuple(models)
        self.__dict__.update({name: numbers(name) for name in ("m", "zeta")})
        self.__dict__.update({name: tuple(numbers(name).T) for name in ("parameters", "breakpoints", "jumps")})
        self.__dict__["kinks"] = tuple(map(tuple, numbers("kinks").transpose(1, 2, 0))) if self.jumps else ()

    @cached_property
    def preload(self) -> Any:
        """Of each."""
        return -self.averaged(np.zeros(self.abreast))[0]

    def take(self, of: Any) -> Abreast:
        """What kernels take at samples that are of these designs, and no more."""
        part = object.__new__(Abreast)
        part.__dict__.update({name: self.__dict__[name] for name in _SAME})
        part.__dict__.update(m=taken(self.m, of), zeta=taken(self.zeta, of))
        part.__dict__["parameters"] = tuple(taken(one, of) for one in self.parameters)
        return part
