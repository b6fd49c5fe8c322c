"""What does not change. Takes a name and a value that somebody would set; returns the reason why not."""

from __future__ import annotations

from typing import Any, ClassVar


class Unchanging:
    """Whose numbers can be read and not be set: what is known of it is known of these numbers."""

    #: that it does not change, and what to do instead with a name
    stays: ClassVar[str] = "designs are immutable"
    instead: ClassVar[str] = "many({}=...) makes others"

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{name} cannot be set, {self.stays}: {self.instead.format(name)}")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{name} cannot be deleted, {self.stays}")
