"""Frozen dataclasses of slowflow_support against those of the standard library."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from typing import Any, ClassVar

import pytest

from slowflow_support import frozen


def _described(dataclass: Any, **arguments: Any) -> type[Any]:
    @dataclass(frozen=True, **arguments)
    class Described:
        """With each kind of field."""

        name: str
        size: float = 1.5
        parts: tuple[int, ...] = dataclasses.field(default=(1, 2), compare=False)
        hidden: float = dataclasses.field(default=0.0, repr=False)
        kind: ClassVar[str] = "one"

    return Described


def _with_post_init(dataclass: Any) -> type[Any]:
    @dataclass(frozen=True)
    class Doubled:
        """With a field that it sets by itself."""

        size: float
        twice: float = dataclasses.field(init=False)

        def __post_init__(self) -> None:
            object.__setattr__(self, "twice", 2 * self.size)

    return Doubled


OURS, THEIRS = _described(frozen.dataclass), _described(dataclasses.dataclass)
Described = OURS
Described.__qualname__ = "Described"  # as pickle finds it


def test_says_of_itself_what_the_standard_library_says() -> None:
    assert repr(OURS("a", hidden=2.0)) == repr(THEIRS("a", hidden=2.0)).rpartition("<locals>.")[2]
    assert dataclasses.asdict(OURS("a")) == dataclasses.asdict(THEIRS("a"))
    assert repr(_described(frozen.dataclass, repr=False)("a")).startswith("<")


def test_equals_and_hashes_by_what_is_compared() -> None:
    for other, same in ((("a",), True), (("a", 1.5, (3,)), True), (("b",), False), (("a", 2.0), False)):
        for kind in (OURS, THEIRS):
            assert (kind("a") == kind(*other)) is same
            assert (hash(kind("a")) == hash(kind(*other))) is same
    assert OURS("a") != THEIRS("a")
    by_identity = _described(frozen.dataclass, eq=False)
    assert by_identity("a") != by_identity("a")


@pytest.mark.parametrize("name", ["name", "size", "kind", "unheard_of"])
def test_cannot_be_changed(name: str) -> None:
    for kind in (OURS, THEIRS):
        one = kind("a")
        with pytest.raises(dataclasses.FrozenInstanceError, match=name):
            setattr(one, name, "b")
        with pytest.raises(dataclasses.FrozenInstanceError, match=name):
            delattr(one, name)
        assert one == kind("a")


def test_is_replaced_copied_and_pickled() -> None:
    one = OURS("a", 2.0)
    assert dataclasses.replace(one, name="b") == OURS("b", 2.0)
    assert copy.deepcopy(one) == copy.copy(one) == pickle.loads(pickle.dumps(one)) == one


def test_arguments() -> None:
    with pytest.raises(TypeError, match="frozen=False"):
        frozen.dataclass(frozen=False)
    with pytest.raises(TypeError, match="positional"):
        _described(frozen.dataclass, kw_only=True)("a")
    with pytest.raises(TypeError, match="name"):
        OURS()


def test_a_class_may_set_what_it_makes_by_itself() -> None:
    for dataclass in (frozen.dataclass, dataclasses.dataclass):
        assert _with_post_init(dataclass)(3.0).twice == 6.0
