"""Printed C expressions as a straight-line program: lists of operations on numbered registers.

In:  a kernel's `KernelView` in C, in one arithmetic: doubles, pairs (double-double) or intervals.
Out: `Function`: its branches as `Program`s, each operation in the order in which a compiler takes it, so that an
     interpreter gives the bits of the compiled code.

Registers hold the arguments, then the constants, then what is computed. An equal operation is computed once.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from ...conventions import OPERATION
from ...views import BranchView, KernelView
from ..printing import Unprintable

Constant = tuple[float, float]
#: what holds a value: an argument by number, a constant, or the operation by number that gives it
Value = tuple[str, int] | tuple[str, Constant]

OPCODES = {word.name.lower(): number for number, word in enumerate(OPERATION.entries)}
OPERATORS = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div"}
ULP = 2.0**-52


@dataclass(frozen=True)
class Arithmetic:
    """How C spells an arithmetic: what makes its constants, and functions with other names than the operations have."""

    constants: dict[str, Callable[..., Constant]]
    names: dict[str, str] = field(default_factory=dict)

    def operation(self, function: str) -> str:
        """The operation that a C function is. Raises Unprintable for one that is none."""
        name = self.names.get(function, function.lower().removeprefix("sfi_"))
        if name not in OPCODES:
            raise Unprintable(f"no operation of a program: {function}")
        return name

    def point(self, number: float) -> Constant:
        """A double."""
        return self.constants["POINT"](number)


DOUBLES = Arithmetic(
    {"POINT": lambda x: (x, 0.0)},
    {"pow": "power", "fabs": "abs"} | {f"angles_{name}": name for name in ("atan2", "atan2_swapped")},
)
PAIRS = Arithmetic({"POINT": lambda x: (x, 0.0), "CONSTANT": lambda high, low: (high, low)})
INTERVALS = Arithmetic(
    {"POINT": lambda x: (x, x), "CONSTANT": lambda high, _: (high - ULP * abs(high), high + ULP * abs(high))}
)


@dataclass(frozen=True)
class Program:
    """One branch.

    registers -- how many there are; the first `arguments` hold these, the next ones the constants
    code      -- operation, register of the result, registers of what it takes, twice the same where it takes one
    outputs   -- registers
    """

    arguments: int
    registers: int
    constants: tuple[Constant, ...]
    code: tuple[tuple[int, int, int, int], ...]
    outputs: tuple[int, ...]


@dataclass(frozen=True)
class Function:
    """Branches in the order in which they are tried; the last one holds where no other does.

    passed -- of each the number of breakpoints that are exceeded where it holds, -1 where that is not asked
    guards -- of each how many comparisons it needs besides: pairs of outputs of `sides`, in turn
    sides  -- what is compared
    """

    passed: tuple[int, ...]
    guards: tuple[int, ...]
    sides: Program
    branches: tuple[Program, ...]


class Assembler:
    """A program in the making."""

    def __init__(self, arithmetic: Arithmetic, arguments: Sequence[str]) -> None:
        self.arithmetic = arithmetic
        self.arguments = arguments
        self.named: dict[str, Value] = {name: ("argument", k) for k, name in enumerate(arguments)}
        self.done: dict[tuple[str, Value, Value], Value] = {}

    def let(self, name: str, text: str) -> None:
        """A line: a name for an expression."""
        self.named[name] = self.value(text)

    def value(self, text: str) -> Value:
        """What an expression gives."""
        return self._value(ast.parse(" ".join(text.split()), mode="eval").body)

    def _value(self, node: ast.expr) -> Value:
        match node:
            case ast.Constant(value=float()):
                return "constant", self.arithmetic.point(node.value)
            case ast.Name():
                return self.named[node.id]
            case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=float() as number)):
                return "constant", self.arithmetic.point(-number)
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return self._operation("neg", self._value(operand))
            case ast.BinOp(left=left, op=op, right=right) if type(op) in OPERATORS:
                return self._operation(OPERATORS[type(op)], self._value(left), self._value(right))
            case ast.Call(func=ast.Name(id=name), args=arguments):
                if name in self.arithmetic.constants:
                    return "constant", self.arithmetic.constants[name](*map(ast.literal_eval, arguments))
                return self._operation(self.arithmetic.operation(name), *map(self._value, arguments))
        raise Unprintable(f"no operation of a program: {ast.unparse(node)}")

    def _operation(self, name: str, first: Value, second: Value | None = None) -> Value:
        key = (name, first, first if second is None else second)
        return self.done.setdefault(key, ("operation", len(self.done)))

    def finished(self, outputs: Sequence[Value]) -> Program:
        """With a register for each value, which is given on where the value is not needed any more."""
        operations = list(self.done)
        last: dict[Value, float] = {}
        for number, (_, *taken) in enumerate(operations):
            last |= dict.fromkeys(taken, number)
        last |= dict.fromkeys(outputs, math.inf)
        constants = dict.fromkeys(value for value in last if value[0] == "constant")
        positions: dict[Value, int] = {("argument", k): k for k in range(len(self.arguments))}
        positions |= {value: len(positions) + k for k, value in enumerate(constants)}
        registers, free, code = len(positions), [], []
        for number, (name, *taken) in enumerate(operations):
            result: Value = ("operation", number)
            if result not in last:
                continue
            first, second = (positions[value] for value in taken)
            free += [positions[one] for one in dict.fromkeys(taken) if one[0] == "operation" and last[one] == number]
            if free:
                positions[result] = free.pop()
            else:
                positions[result], registers = registers, registers + 1
            code.append((OPCODES[name], positions[result], first, second))
        return Program(
            len(self.arguments),
            registers,
            tuple(value[1] for value in constants),  # type: ignore[misc]
            tuple(code),
            tuple(positions[value] for value in outputs),
        )


def function(
    view: KernelView, arithmetic: Arithmetic, conditions: Sequence[tuple[int, Sequence[tuple[str, str]]]] = ()
) -> Function:
    """A kernel's.

    conditions -- of each branch the number of breakpoints passed, and the sides of comparisons as C prints them; the
                  last one's are not needed
    """
    sides = Assembler(arithmetic, view.arguments)
    compared = [sides.value(side) for _, pairs in conditions[:-1] for pair in pairs for side in pair]
    return Function(
        (*(passed for passed, _ in conditions[:-1]), -1),
        (*(len(pairs) for _, pairs in conditions[:-1]), 0),
        sides.finished(compared),
        tuple(_branch(branch, view.arguments, arithmetic) for branch in view.branches),
    )


def _branch(branch: BranchView, arguments: Sequence[str], arithmetic: Arithmetic) -> Program:
    assembled = Assembler(arithmetic, arguments)
    for line in branch.lets:
        if line.function or line.number:
            raise Unprintable(f"no line of a program: {line.name}")
        assembled.let(line.name, line.value)
    return assembled.finished([assembled.value(output) for output in branch.outputs])
