"""From a kernel's expressions to a straight line of assignments: common subexpressions once, powers as chains.

In:  lets and outputs, exact SymPy expressions in structured form.
Out: `Program`: the assignments in order, the outputs, and how many operations it takes. Outputs of a
     `Repeated` stay what they are, one after the other; `program_of` is what computes them.

Nothing is expanded, factored or rounded here: the structured forms keep digits that an expansion cancels.
"""

from __future__ import annotations

import functools
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import sympy as sp

from ..forces.repeated import Output, Repeated

Let = tuple[sp.Symbol, sp.Expr]

#: an algorithm written in more lets than this has named what it shares, and SymPy's search would take seconds
SPELLED_OUT = 40


@dataclass(frozen=True)
class Program:
    """Straight-line code for one branch of a kernel.

    lets    -- assignments (symbol, expression) in order; an integer power in them is a square of a symbol
    outputs -- expressions in the arguments and the lets
    operations -- floating-point operations that it takes
    """

    lets: tuple[Let, ...]
    outputs: tuple[sp.Expr, ...]
    operations: int


@functools.cache
def operations(expression: sp.Expr, within_product: bool = False) -> int:
    """Additions, multiplications, divisions, roots and function calls in evaluating the expression as written.

    Without those of a `Repeated`, whose outputs are computed together.
    """
    if is_constant(expression) or expression.is_Symbol or isinstance(expression, Output):
        return 0
    inner = sum(operations(arg, expression.is_Mul) for arg in expression.args)
    if expression.is_Add:
        return inner + len(expression.args) - 1
    if expression.is_Mul:
        constants = [arg for arg in expression.args if is_constant(arg)]
        has_factor = sp.Mul(*constants).doit() not in (1, -1)
        return inner + len(expression.args) - len(constants) + has_factor - 1
    if expression.is_Pow:
        # the division by a factor of a product is the operation that joins it to the others
        divides = bool(expression.exp.is_negative) and not within_product
        return inner + divides + (abs(int(expression.exp)) - 1 if expression.exp.is_Integer else 1)
    return inner + 1


@functools.cache
def is_constant(expression: sp.Basic) -> bool:
    """A number, such as 5/8 or 4/pi: printed as one literal."""
    if not expression.args:
        return isinstance(expression, sp.Expr) and not expression.is_Symbol
    return isinstance(expression, sp.Expr) and all(is_constant(part) for part in expression.args)


def straight_line(
    lets: Sequence[Let], outputs: Sequence[sp.Expr], reserved: Iterable[sp.Symbol], named: bool = False
) -> Program:
    """All passes. `reserved` are the names that the code around uses (the arguments).

    named -- whether the lets are known to name all that is shared
    """
    outputs_as_written = tuple(_as_written(output) for output in outputs)
    needed = _needed([(symbol, _as_written(value)) for symbol, value in lets], outputs_as_written)
    return _passed(tuple(needed), outputs_as_written, tuple(symbol.name for symbol in reserved), named)


@functools.cache
def _passed(lets: tuple[Let, ...], outputs: tuple[sp.Expr, ...], reserved: tuple[str, ...], named: bool) -> Program:
    """`straight_line` of what is needed: regimes that differ in what is not are the same code."""
    names = {*reserved, *(symbol.name for symbol, _ in lets)}
    if not named and len(lets) <= SPELLED_OUT:
        lets, outputs = _common_subexpressions(lets, outputs)
    lets, outputs = _power_chains(lets, outputs)
    lets, outputs = _numbered(lets, outputs, names)
    return Program(tuple(lets), tuple(outputs), _counted(lets, outputs))


@functools.cache
def program_of(repeated: Repeated) -> Program:
    """Straight-line code of what is repeated."""
    if repeated.straight:
        outputs = tuple(value for _, value in repeated.outputs)
        return Program(repeated.lets, outputs, _counted(repeated.lets, outputs))
    return straight_line(repeated.lets, [value for _, value in repeated.outputs], repeated.arguments, named=True)


def _counted(lets: Sequence[Let], outputs: Sequence[sp.Expr]) -> int:
    """Operations, those of what is repeated as often as it is called."""
    calls = {(value.repeated, value.args) for _, value in lets if isinstance(value, Output)}
    own = sum(operations(e) for e in (*(value for _, value in lets), *outputs))
    turns = ((repeated, int(args[-1]) if repeated.state else 1) for repeated, args in calls)
    return own + sum(count * program_of(repeated).operations for repeated, count in turns)


@functools.cache
def _as_written(expression: sp.Expr) -> sp.Expr:
    """The expression with 2 (a + b) held as it is: rebuilding it, SymPy would multiply it out."""
    if not expression.args or is_constant(expression):
        return expression
    args = [_as_written(arg) for arg in expression.args]
    if expression.is_Mul and len(args) == 2 and args[0].is_Rational and args[0] != -1 and args[1].is_Add:
        return sp.Mul(sp.UnevaluatedExpr(args[0]), args[1])
    return expression.func(*args)


def _needed(lets: Sequence[Let], outputs: Sequence[sp.Expr]) -> list[Let]:
    """The lets that the outputs need, directly or through one another."""
    names = set().union(*(output.free_symbols for output in outputs))
    kept = []
    for symbol, value in reversed(lets):
        if symbol in names:
            names |= value.free_symbols
            kept.append((symbol, value))
    return kept[::-1]


def _common_subexpressions(lets: Sequence[Let], outputs: Sequence[sp.Expr]) -> tuple[list[Let], list[sp.Expr]]:
    """SymPy's cse over lets and outputs together."""
    expressions = [value for _, value in lets] + list(outputs)
    found, reduced = sp.cse(expressions, symbols=sp.numbered_symbols("cse_"), order="canonical")
    # a common constant is no subexpression: it is folded into a literal
    constants = {symbol: value for symbol, value in found if is_constant(value)}
    shared = [(symbol, value.xreplace(constants)) for symbol, value in found if symbol not in constants]
    reduced = [value.xreplace(constants) for value in reduced]
    named = [(symbol, value) for (symbol, _), value in zip(lets, reduced, strict=False)]
    new_outputs = reduced[len(lets) :]
    # a shared value may need a let and a let may need a shared value: as late as possible, in the order of the lets
    values = dict(shared)
    done: dict[sp.Symbol, sp.Expr] = {}

    def before(expression: sp.Expr) -> None:
        for symbol in sorted(expression.free_symbols & values.keys(), key=lambda s: int(s.name[4:])):
            if symbol not in done:
                before(values[symbol])
                done[symbol] = values[symbol]

    for symbol, value in named:
        before(value)
        done[symbol] = value
    for output in new_outputs:
        before(output)
    return list(done.items()), new_outputs


def _power_chains(lets: Sequence[Let], outputs: Sequence[sp.Expr]) -> tuple[list[Let], list[sp.Expr]]:
    """Every integer power by squarings and multiplications: x^5 = (x^2)^2 x. A square used once stays where it is."""
    # another name for an argument first: put in afterwards it would make one power of two
    own = {symbol for symbol, _ in lets}
    known = {symbol: value for symbol, value in lets if value.is_Symbol and value not in own}
    if known:
        lets = [(symbol, value.xreplace(known)) for symbol, value in lets if symbol not in known]
        outputs = [output.xreplace(known) for output in outputs]
    uses = Counter(
        (node.base, abs(int(node.exp)))
        for expression in (*(value for _, value in lets), *outputs)
        for node in sp.preorder_traversal(expression)
        if node.is_Pow and node.exp.is_Integer and abs(node.exp) > 1
    )
    exponents = Counter(base for base, _ in uses)
    result: list[Let] = []
    powers: dict[tuple[sp.Symbol, int], sp.Symbol] = {}
    bases: dict[sp.Expr, sp.Symbol] = {}

    def power(base: sp.Symbol, exponent: int) -> sp.Symbol:
        if exponent == 1:
            return base
        if (base, exponent) not in powers:
            half = power(base, exponent // 2) if exponent % 2 == 0 else power(base, exponent - 1)
            value = half**2 if exponent % 2 == 0 else half * base
            powers[base, exponent] = sp.Symbol(f"{base.name}^{exponent}")
            result.append((powers[base, exponent], value))
        return powers[base, exponent]

    def chained(expression: sp.Expr) -> sp.Expr:
        if is_constant(expression) or not expression.args:
            return expression
        if expression.is_Pow and expression.exp.is_Integer:
            base, exponent = chained(expression.base), int(expression.exp)
            if abs(exponent) > 1 and not base.is_Symbol:
                if base not in bases:
                    bases[base] = sp.Symbol(f"base^{len(bases)}")
                    result.append((bases[base], base))
                base = bases[base]
            once = abs(exponent) == 2 and uses[expression.base, 2] == 1 and exponents[expression.base] == 1
            if abs(exponent) == 1 or once:
                return base**exponent
            chain = power(base, abs(exponent))
            return 1 / chain if exponent < 0 else chain
        return expression.func(*(chained(arg) for arg in expression.args))

    for symbol, value in lets:
        result.append((symbol, chained(value)))
    outputs = [chained(output) for output in outputs]
    # a common subexpression that was a mere power is now another name for the chain's
    aliases: dict[sp.Symbol, sp.Symbol] = {}
    for symbol, value in result:
        if value.is_Symbol:
            aliases[symbol] = aliases.get(value, value)
    if aliases:
        result = [(symbol, value.xreplace(aliases)) for symbol, value in result if symbol not in aliases]
        outputs = [output.xreplace(aliases) for output in outputs]
    return result, outputs


def _numbered(lets: Sequence[Let], outputs: Sequence[sp.Expr], named: set[str]) -> tuple[list[Let], list[sp.Expr]]:
    """Names t0, t1, ... in order of assignment for what the passes introduced; powers of an argument as A2, A3."""
    rename: dict[sp.Symbol, sp.Symbol] = {}
    taken = set(named)
    number = 0
    for symbol, _ in lets:
        if symbol.name in named:
            continue
        base, _, exponent = symbol.name.partition("^")
        # F_0_2, because F_02 would read as another symbol
        name = base + ("_" if base[-1].isdigit() else "") + exponent
        if base not in named or name in taken:
            while f"t{number}" in taken:
                number += 1
            name, number = f"t{number}", number + 1
        taken.add(name)
        rename[symbol] = sp.Symbol(name)
    return (
        [(rename.get(symbol, symbol), value.xreplace(rename)) for symbol, value in lets],
        [output.xreplace(rename) for output in outputs],
    )
