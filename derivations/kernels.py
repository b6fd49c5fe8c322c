"""What a kernel is, and how a step of the derivation states one beside its formula.

In:  exact SymPy expressions, and what is known of them: equation number, domain, what they are in a sentence.
Out: `Kernel`, a function of numbers, regime by regime; `Formulas`, what a step states: `@of.kernel(...)` on the
     function that derives a formula, whose name and docstring the kernel takes, or `of.add` of one expression.

Who wants a kernel in which arithmetic and language is said in `codegen.requests`.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import sympy as sp

Let = tuple[sp.Symbol, sp.Expr]
Outputs = sp.Expr | Sequence[sp.Expr]

#: in C doubles, intervals, pairs (double-double) and bounded pairs, which know their error; in Python doubles,
#: enclosures (intervals of any arithmetic) and balls
ARITHMETICS = ("doubles", "intervals", "pairs", "bounded", "enclosures", "balls")


@dataclass(frozen=True)
class Branch:
    """One regime of a kernel.

    name    -- for the generated code
    kernel  -- name of another kernel of the same arguments that computes it; "" where it is printed with this one
    passed  -- how many breakpoints the amplitude exceeds, where that is what makes the regime
    remainders -- lets that stand for a series cut short, each with a bound of its relative error
    guards  -- pairs (left, right): the branch holds where every left <= right and no earlier branch does
    lets    -- intermediate quantities in order
    outputs -- expressions in the arguments and the lets
    """

    name: str
    guards: tuple[tuple[sp.Expr, sp.Expr], ...]
    lets: tuple[Let, ...]
    outputs: tuple[sp.Expr, ...]
    kernel: str = ""
    passed: int = 0
    remainders: tuple[Let, ...] = ()

    @property
    def free_symbols(self) -> set[sp.Symbol]:
        """What it takes: all symbols but its lets."""
        expressions = [
            *self.outputs,
            *(value for _, value in self.lets),
            *(one for pair in self.guards for one in pair),
        ]
        return set().union(*(one.free_symbols for one in expressions)) - {symbol for symbol, _ in self.lets}


class Called:
    """What is printed as a function: the last of its arguments may be a mechanism's parameters, an array in C."""

    arguments: tuple[sp.Symbol, ...]
    parameters: int

    @property
    def plain(self) -> tuple[sp.Symbol, ...]:
        """The arguments before the parameters."""
        return self.arguments[: len(self.arguments) - self.parameters]

    @property
    def packed(self) -> tuple[sp.Symbol, ...]:
        """The parameters."""
        return self.arguments[len(self.arguments) - self.parameters :]


@dataclass(frozen=True)
class Kernel(Called):
    """A generated function of real numbers.

    parameters -- how many of the last arguments are the mechanism's parameters
    returns    -- "scalar", "tuple" or "stack" (one array, coefficients along its first axis)
    equation   -- number in the paper, or what it is derived from
    domain     -- where it holds
    generic    -- in Python for any kind of number that has arithmetic, and NumPy's functions where it calls them:
                  floats, complex numbers, arrays, an integrator's symbols
    looped     -- whether Python may have it as a compiled loop over arrays of floats: asked once an answer, it need not
    in_c       -- whether anything in C calls it, where a module is in C at all
    in_python  -- whether Python has its text; what no Python code calls it has from C
    arithmetics -- the kinds of numbers that it is printed for, of `ARITHMETICS`
    to_pairs   -- of one in double-double: the lets that are wanted so, what is left to do being done in doubles; all
                  of it where there are none
    """

    name: str
    arguments: tuple[sp.Symbol, ...]
    branches: tuple[Branch, ...]
    doc: str
    equation: str
    domain: str
    parameters: int = 0
    returns: str = "scalar"
    generic: bool = False
    looped: bool = True
    in_c: bool = True
    in_python: bool = True
    arithmetics: tuple[str, ...] = ("doubles",)
    to_pairs: tuple[sp.Symbol, ...] = ()

    @property
    def width(self) -> int:
        return len(self.branches[0].outputs)

    @property
    def compiled(self) -> bool:
        """Whether Python has it as a loop over arrays of floats."""
        return not self.in_python or (self.width > 0 and self.looped and not self.generic)


class Lets(NamedTuple):
    """A formula with the intermediate quantities that it is in."""

    lets: Sequence[Let]
    value: Outputs


class Formulas:
    """What a step of the derivation states: its kernels by name, and what else it finds, all as attributes too.

    order  -- of the symbols: a kernel takes those that its formula has, in this order
    lets   -- intermediate quantities: a formula without lets of its own has those of them that are in it
    domain -- of the kernels for which no other is given
    parameters -- of a mechanism: the last arguments of its kernels, whether these have them or not
    """

    def __init__(
        self,
        order: Sequence[sp.Symbol],
        lets: Mapping[sp.Symbol, sp.Expr] = {},
        domain: str = "Omega > 0, A > 0",
        parameters: Sequence[sp.Symbol] = (),
    ) -> None:
        self.order = tuple(order)
        self.lets = dict(lets)
        self.domain = domain
        self.parameters = tuple(parameters)
        self.kernels: dict[str, Kernel] = {}

    def __getattr__(self, name: str) -> Any:
        # only for what is not there; here so that attributes may be of any kind
        raise AttributeError(f"no formula {name} is stated")

    def add(
        self,
        name: str,
        value: Outputs | Lets | Sequence[Branch],
        doc: str,
        equation: str,
        domain: str = "",
        *,
        arguments: Sequence[sp.Symbol] | None = None,
        packed: bool = True,
        **keywords: object,
    ) -> Any:
        """State a kernel, and return its formula without lets.

        value     -- its output or outputs, with lets of their own or without; or branches
        arguments -- where the order is another, or it takes more than it has
        packed    -- whether the mechanism's parameters follow them: an array in C
        """
        if name in self.kernels:
            raise ArithmeticError(f"two formulas {name}")
        lets, outputs = value if isinstance(value, Lets) else (None, value)
        single = isinstance(outputs, sp.Expr)
        several = (outputs,) if single else tuple(outputs)
        if several and isinstance(several[0], Branch):
            branches, single = several, len(several[0].outputs) == 1
        else:
            if lets is None:
                numbers = {symbol: whole for symbol, whole in self.lets.items() if whole.is_number}
                several = tuple(one.subs(numbers) for one in several) if numbers else several
                lets = [let for let in self.lets.items() if any(one.has(let[0]) for one in several)]
            branches = (Branch("", (), tuple(lets), several),)
        parameters = self.parameters if packed else ()
        if arguments is None:
            needed = set().union(*(branch.free_symbols for branch in branches)).difference(parameters)
            if unknown := needed.difference(self.order):
                raise ArithmeticError(f"{name} has {unknown}, which no order of arguments knows")
            arguments = [symbol for symbol in self.order if symbol in needed]
        keywords.setdefault("returns", "scalar" if single else "tuple")
        keywords |= {"parameters": len(parameters)}
        arguments = (*arguments, *parameters)
        self.kernels[name] = Kernel(name, arguments, branches, doc, equation, domain or self.domain, **keywords)
        setattr(self, name, outputs)
        return outputs

    def kernel(self, equation: str, domain: str = "", **keywords: Any) -> Callable[[Callable[[], Any]], Any]:
        """Of a function without arguments: state what it derives under its name; the docstring begins with what it is.

        The name then is the formula.
        """

        def stated(derive: Callable[[], Any]) -> Any:
            doc = " ".join(inspect.getdoc(derive).partition("\n\n")[0].split())
            return self.add(derive.__name__, derive(), doc, equation, domain, **keywords)

        return stated
