"""Programs as two flat lists. Takes `Program`s; returns integers and doubles in the order in which C reads them."""

from __future__ import annotations

from .assembler import Program


class Encoder:
    """The two lists, and what writes to them."""

    def __init__(self) -> None:
        self.integers: list[int] = []
        self.numbers: list[float] = []

    def program(self, one: Program) -> None:
        """Sizes, operations, the registers of outputs; constants."""
        self.integers += [one.arguments, len(one.constants), one.registers, len(one.code), len(one.outputs)]
        for operation in one.code:
            self.integers += operation
        self.integers += one.outputs
        for constant in one.constants:
            self.numbers += constant
