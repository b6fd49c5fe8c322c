"""What kernels of a module compute alike, printed once, as functions that they call.

In:  the straight-line `Program`s of the kernels of a file.
Out: the same programs, where calls of a `Repeated` stand for the lets that several of them have.

Every operation stays what it is, in its order: results are the same to the last bit.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import sympy as sp

from ..forces.repeated import Output, Repeated
from ..kernels import Kernel, Let
from .passes import Program, operations

if TYPE_CHECKING:
    from .targets.printing import Rules

#: operations that a line of code has, and lines that a function has to save
PER_LINE, LEAST_SAVED = 12, 20
#: the same of one that has all outputs of its callers: these have nothing else to do
LEAST_SAVED_BY_OUTPUTS = 5
_NAME = re.compile(r"\b[A-Za-z_]\w*\b")


@dataclass
class _Branch:
    """The program of a kernel's branch.

    named  -- what the derivation has a name for
    values -- of each let, as printed, where the name of another let is the number of its value
    lets   -- by their values, those that named ones are computed from
    """

    kernel: str
    name: str
    program: Program
    named: set[sp.Symbol]
    values: dict[str, str] = field(default_factory=dict)
    lets: dict[str, sp.Symbol] = field(default_factory=dict)


#: values in order, and the branches that have them all
_Shared = tuple[list[str], list[_Branch]]


def with_calls(
    kernels: Iterable[Kernel], code: Mapping[str, tuple[Program, ...]], printer: Rules
) -> dict[str, tuple[Program, ...]]:
    """The programs of these kernels with calls of what they have in common, as long as that saves lines."""
    kernels = tuple(kernels)
    every = [
        _Branch(kernel.name, branch.name, _calling_by_one_name(program), {symbol for symbol, _ in branch.lets})
        for kernel in kernels
        for branch, program in zip(kernel.branches, code[kernel.name], strict=True)
    ]
    numbers: dict[str, str] = {}
    count = itertools.count(1)
    while True:
        for one in every:
            _evaluate(one, numbers, printer)
        shared = max(_shared(every), key=_saved, default=None)
        if shared is None or _saved(shared) < LEAST_SAVED:
            break
        _put_out(f"common_{next(count)}", *shared)
    for _, of_kernel in itertools.groupby(every, lambda one: one.kernel):
        _put_out_ends(list(of_kernel), count, printer)
    programs = iter(every)
    return {kernel.name: tuple(next(programs).program for _ in kernel.branches) for kernel in kernels}


def _calling_by_one_name(program: Program) -> Program:
    """Calls take a quantity by its first name, where several have the same value."""
    first: dict[sp.Expr, sp.Symbol] = {}
    name = {symbol: first.setdefault(value, symbol) for symbol, value in program.lets}
    lets = [
        (symbol, value.func(*(name.get(one, one) for one in value.args)) if isinstance(value, Output) else value)
        for symbol, value in program.lets
    ]
    read = set().union(*(output.free_symbols for output in program.outputs))
    return replace(program, lets=tuple(_leading_to(lets, read)))


def _evaluate(one: _Branch, numbers: dict[str, str], printer: Rules) -> None:
    """What each of its lets is; the numbers are those of all branches."""
    one.values, one.lets, called = {}, {}, _called(one)
    for symbol, value in one.program.lets:
        whole = _text(value, one.values, printer)
        one.values[symbol.name] = numbers.setdefault(whole, f"value^{len(numbers)}")
        if symbol not in called:
            one.lets[whole] = symbol
    kept = {symbol for symbol, _ in _leading_to(one.program.lets, one.named & {*one.lets.values()})}
    one.lets = {value: symbol for value, symbol in one.lets.items() if symbol in kept}


def _text(value: sp.Expr, known: Mapping[str, str], printer: Rules) -> str:
    """A value as printed, with what is known of names in their places."""
    text = f"{type(value)} {value.args}" if isinstance(value, Output) else printer.doprint(value)
    return _NAME.sub(lambda found: known.get(found[0], found[0]), text)


def _leading_to(lets: Iterable[Let], symbols: Iterable[sp.Symbol]) -> list[Let]:
    """The lets that these are, or are computed from."""
    needed, kept = set(symbols), []
    for symbol, value in reversed(tuple(lets)):
        if symbol in needed:
            needed |= value.free_symbols
            kept.append((symbol, value))
    return kept[::-1]


def _shared(every: Sequence[_Branch]) -> Iterator[_Shared]:
    """What two branches have, as far as named quantities need it, with all that have it."""
    for one, other in itertools.combinations(every, 2):
        same = {one.lets[value] for value in one.lets if value in other.lets}
        needed = {symbol for symbol, _ in _leading_to(one.program.lets, same & one.named)}
        values = [value for value, symbol in one.lets.items() if symbol in needed & same]
        if len(values) > 1:
            yield values, [each for each in every if each.lets.keys() >= {*values}]


def _saved(shared: _Shared) -> int:
    """Lines that a function of these saves."""
    same, users = shared
    values = dict(users[0].program.lets)
    return _saved_by([values[users[0].lets[value]] for value in same], len(users))


def _saved_by(values: Iterable[sp.Expr], calls: int) -> int:
    """The same of what it computes: it has about eight lines more than its values, and a call two."""
    return sum(1 + operations(value) // PER_LINE for value in values) * (calls - 1) - 8 - 2 * calls


def _put_out(name: str, same: Sequence[str], users: Sequence[_Branch]) -> None:
    """Put these lets into a function of this name, which the branches call for those that are named."""
    first, *_ = users
    own = {first.lets[value] for value in same}
    lets = tuple(let for let in first.program.lets if let[0] in own)
    arguments = sorted(set().union(*(value.free_symbols for _, value in lets)) - own, key=str)
    results = [value for value in same if any(_is_result(one.lets[value], same, one) for one in users)]
    function = Repeated(
        name,
        f"What {_named(users)} have in common.",
        tuple(arguments),
        lets,
        tuple((sp.Symbol(f"{first.lets[value]}_out"), first.lets[value]) for value in results),
        straight=True,
    )
    for one in users:
        # what earlier calls give has another name in each branch
        there = {one.values[symbol.name]: symbol for symbol, _ in one.program.lets}
        taken = [there.get(first.values.get(argument.name, ""), argument) for argument in arguments]
        outputs = [one.lets[value] for value in results]
        rest = [let for let in one.program.lets if let[0] not in outputs]
        called = _called(one)
        earlier = [let for let in rest if let[0] in called]
        needed = set().union(*(output.free_symbols for output in one.program.outputs))
        others = _leading_to([let for let in rest if let[0] not in called], needed)
        one.program = replace(one.program, lets=(*earlier, *function.at(taken, outputs), *others))


def _named(users: Iterable[_Branch]) -> str:
    return ", ".join(dict.fromkeys("_".join(filter(None, [one.kernel, one.name])) for one in users))


def _put_out_ends(branches: Sequence[_Branch], count: Iterator[int], printer: Rules) -> None:
    """Put into functions what regimes of a kernel make alike of quantities that the derivation names alike."""
    numbers: dict[str, str] = {}
    same_outputs: dict[tuple[str, ...], list[tuple[_Branch, dict[sp.Symbol, str]]]] = {}
    for one in branches:
        values: dict[sp.Symbol, str] = {}
        unnamed: dict[str, str] = {}
        for symbol, value in one.program.lets:
            text = _text(value, unnamed, printer)
            values[symbol] = numbers.setdefault(text, f"value^{len(numbers)}")
            if symbol not in one.named:
                unnamed[symbol.name] = values[symbol]
        outputs = tuple(_text(output, unnamed, printer) for output in one.program.outputs)
        same_outputs.setdefault(outputs, []).append((one, values))
    for users in same_outputs.values():
        _put_out_end([one for one, _ in users], [values for _, values in users], count)


def _put_out_end(users: Sequence[_Branch], values: Sequence[dict[sp.Symbol, str]], count: Iterator[int]) -> None:
    """The same of regimes with the same outputs, where that saves lines; `values` of lets, by named ones."""
    first, outputs = users[0], users[0].program.outputs
    read = set().union(*(output.free_symbols for output in outputs))

    def without(own: set[sp.Symbol]) -> tuple[list[Let], set[sp.Symbol]]:
        """The lets that the outputs are computed from, but for those of the regimes, and what they take of these."""
        lets = _leading_to([let for let in first.program.lets if let[0] not in own], read)
        return lets, read.union(*(value.free_symbols for _, value in lets)) - {symbol for symbol, _ in lets}

    # a call gives all of its outputs at once, where it was
    own = {one for one in first.named if len({each.get(one) for each in values}) > 1} | _called(first)
    _, taken = without(own)
    # what all of them have computed by then, they hand on
    done = set.intersection(*({symbol for symbol, _ in _leading_to(one.program.lets, taken)} for one in users))
    lets, taken = without(own | (done & first.named))
    if not taken & _called(first) <= first.named:  # other names elsewhere
        return
    if _saved_by([*(value for _, value in lets), *outputs], len(users)) < LEAST_SAVED_BY_OUTPUTS:
        return
    results = tuple((sp.Symbol(f"result_{k}"), output) for k, output in enumerate(outputs))
    arguments = sorted(taken, key=str)
    doc = f"The outputs of {_named(users)}."
    function = Repeated(f"common_{next(count)}", doc, tuple(arguments), tuple(lets), results, straight=True)
    names = [name for name, _ in results]
    for one in users:
        head = _leading_to(one.program.lets, taken | _called(one))
        one.program = replace(one.program, lets=(*head, *function.at(arguments, names)), outputs=tuple(names))


def _called(one: _Branch) -> set[sp.Symbol]:
    """What it has of calls of functions that were put out."""
    return {symbol for symbol, value in one.program.lets if isinstance(value, Output) and value.repeated.straight}


def _is_result(symbol: sp.Symbol, same: Sequence[str], one: _Branch) -> bool:
    """Whether it is named, and anything but these lets reads it."""
    within = {one.lets[value] for value in same}
    others = (value for name, value in one.program.lets if name not in within)
    return symbol in one.named and any(symbol in value.free_symbols for value in (*others, *one.program.outputs))
