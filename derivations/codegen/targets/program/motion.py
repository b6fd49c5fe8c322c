"""The pieces of a force as data: what `c/taylor.py` prints as Taylor recurrences, for the integrator to interpret.

In:  the `Module` of one force.
Out: `text`, JSON: of each piece its law's name and two flat lists, `words` and `numbers`, in the order in which
     src/slowflow/native/exact/interpreted.h reads and checks them.
"""

from __future__ import annotations

import ast
import json
from collections.abc import Sequence

from ...form import Module
from ..c import taylor
from ..printing import Unprintable
from .assembler import DOUBLES, Assembler, Program, Value
from .encoder import Encoder

BREAKS = ("SF_SMOOTH", "SF_MEETS", "SF_BRANCHES", "SF_BEGINS")
NOTHING = ("constant", (0.0, 0.0))


def name_of(module: str) -> str:
    """Of the file."""
    return f"{module}_motion.json"


def text(module: Module) -> str:
    """The file."""
    laws = {}
    for law in taylor.laws([module]):
        encoder = Encoder()
        encoder.integers += [law.constants, BREAKS.index(law.breaks), law.linear]
        for name in ("value", "slope", "begins"):
            if name in law.scalars:
                encoder.program(scalar(law, name))
        for recurrence, takes in ((law.force, 1), (law.both, 2)):
            encoder.integers += [
                len(recurrence.lines) + 1,
                recurrence.fours,
                *(recurrence.value, recurrence.slope)[:takes],
            ]
            encoder.program(begin(law, recurrence))
            encoder.program(following(law, recurrence))
        laws[law.name] = {"words": encoder.integers, "numbers": encoder.numbers}
    return json.dumps(laws, separators=(",", ":")) + "\n"


class Line(Assembler):
    """Of a law: its scalar functions are written out, and so are the recurrences."""

    def __init__(self, law: taylor.Recurrences, arguments: Sequence[str]) -> None:
        super().__init__(DOUBLES, arguments)
        self.scalars = {f"{law.prefix}_{name}": body for name, body in law.scalars.items()}
        self.rules = {f"sf_{name}": rule for name, rule in taylor.RULES.items()}

    def _value(self, node: ast.expr) -> Value:
        match node:
            case ast.Subscript(value=ast.Name(id=name), slice=index):
                return self.named[f"{name}[{_number(index)}]"]
            case ast.Call(func=ast.Name(id=name), args=[_, _, at]) if name in self.scalars:
                return self.scalar(self.scalars[name], self._value(at))
            case ast.Call(func=ast.Name(id=name), args=[_, *given]) if name in self.rules:
                numbers, expression, _ = self.rules[name]
                taken = dict(zip(numbers.split(), (f"({ast.unparse(one)})" for one in given), strict=True))
                return self.value(expression.format(**taken))
        return super()._value(node)

    def scalar(self, body: taylor.Body, u: Value) -> Value:
        """What a function of the constants and u gives."""
        outside, self.named = self.named, {**self.named, "u": u}
        (statement,) = body.statements
        self.lines(body)
        found = self.value(statement.removeprefix("return ").removesuffix(";"))
        self.named = outside
        return found

    def lines(self, body: taylor.Body) -> None:
        """What is known beforehand."""
        for name, value in body.declarations:
            self.let(name, value.replace("c->", ""))

    def made(self, body: taylor.Body) -> None:
        """Assignments, as they stand."""
        self.lines(body)
        for statement in body.statements:
            target, value = statement.removesuffix(";").split(" = ", 1)
            if not value.startswith("sf_four_of"):
                self.let(target, value.replace("c->", ""))


def _number(index: ast.expr) -> int:
    """Of a series or of a sum."""
    match index:
        case ast.Constant(value=int(number)):
            return number
        case ast.BinOp(left=ast.Constant(value=int(number)), op=ast.Add(), right=ast.Constant(value=int(more))):
            return number + more
    raise Unprintable(f"no number of a series: {ast.unparse(index)}")


def _constants(law: taylor.Recurrences) -> list[str]:
    return [f"p[{k}]" for k in range(law.constants + 1)]


def scalar(law: taylor.Recurrences, name: str) -> Program:
    """The force, its slope, or where it begins."""
    line = Line(law, [*_constants(law), "u"])
    return line.finished([line.scalar(law.scalars[name], line.named["u"])])


def begin(law: taylor.Recurrences, of: taylor.Recurrence) -> Program:
    """First coefficients and reciprocals; 0 where none is wanted."""
    line = Line(law, [*_constants(law), "first[0]"])
    line.made(of.begin)
    series = range(1, len(of.lines) + 1)
    return line.finished([line.named.get(f"{name}[{k}]", NOTHING) for name in ("first", "over") for k in series])


def following(law: taylor.Recurrences, of: taylor.Recurrence) -> Program:
    """Coefficients n, and what they add to the sums."""
    series = range(len(of.lines) + 1)
    known = [f"{name}[{k}]" for name in ("first", "second", "last", "over") for k in series]
    sums = [f"sum[{k}]" for k in range(taylor.LANES * of.fours)]
    line = Line(law, ["n", "over_n", *_constants(law), *known, *sums, "w[0]"])
    line.made(of.next)
    added = [line.value(one.replace("c->", "")) for pair in of.padded for one in pair]
    return line.finished([*(line.named[f"w[{k}]"] for k in series[1:]), *added])
