"""Frozen dataclasses that are defined quickly: in goes a class as `dataclasses.dataclass` takes it, out comes the same.

The standard library writes and compiles six functions for each frozen class, half of what importing slowflow took;
here a class gets its `__init__` from there, and shares the others.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from operator import attrgetter
from typing import TYPE_CHECKING, Any, TypeVar

from slowflow_support.errors import WrongType

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass  # what type checkers know of those holds of these
else:

    def dataclass(
        *, frozen: bool, eq: bool = True, repr: bool = True, kw_only: bool = False
    ) -> Callable[[type[Made]], type[Made]]:
        """As `dataclasses.dataclass` with the same arguments; `frozen` is always True.

        Methods that the class has itself stay. Raises TypeError for frozen=False.
        """
        if not frozen:
            raise WrongType("frozen=False: these dataclasses are frozen, dataclasses.dataclass makes others")

        def made(cls: type[Made]) -> type[Made]:
            given = {"__setattr__": _set_once, "__delattr__": _delete}
            if repr:
                given["__repr__"] = _repr
            if eq:
                given |= {"__eq__": _eq, "__hash__": _hash}
            for name, method in given.items():
                if name not in cls.__dict__:
                    setattr(cls, name, method)
            done = dataclasses.dataclass(eq=False, repr=False, kw_only=kw_only)(cls)
            fields = dataclasses.fields(done)
            done._set_by_init = frozenset(one.name for one in fields)
            if eq:
                done._compared = attrgetter(*(one.name for one in fields if one.compare))
            return done

        return made


Made = TypeVar("Made")


def _set_once(self: Any, name: str, value: Any) -> None:
    """A field, by `__init__`; never again."""
    if name in self.__dict__ or name not in self._set_by_init:
        raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")
    self.__dict__[name] = value


def _delete(self: Any, name: str) -> None:
    raise dataclasses.FrozenInstanceError(f"cannot delete field {name!r}")


def _repr(self: Any) -> str:
    said = ", ".join(f"{one.name}={getattr(self, one.name)!r}" for one in dataclasses.fields(self) if one.repr)
    return f"{type(self).__qualname__}({said})"


def _eq(self: Any, other: Any) -> Any:
    return self._compared(self) == other._compared(other) if type(other) is type(self) else NotImplemented


def _hash(self: Any) -> int:
    return hash(self._compared(self))
