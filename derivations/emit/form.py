"""What a kernel is: the forms in which the catalogue states functions, and in which the targets take them.

In:  exact SymPy expressions, and what is known of them: arguments, equation number, domain.
Out: `Kernel`, a function of numbers, regime by regime; `Composition`, a call of another; `Module`, a file of them.

Arguments come in one order everywhere: Omega, A, F_0, m or mu, zeta, h, h_A, h_AA, h_AAA, the mechanism's parameters.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import sympy as sp

from derivations.mechanisms import Mechanism, Parameter
from derivations.resultants import Elimination
from derivations.slow_flow import SCENES, m
from derivations.symbols import h, h_A, h_AA, h_AAA, mu

Let = tuple[sp.Symbol, sp.Expr]

AVERAGED = (h, h_A, h_AA, h_AAA)

#: of h or H and its derivatives
NAMES = ("", "_A", "_AA", "_AAA")


@dataclass(frozen=True)
class Branch:
    """One regime of a kernel.

    name    -- for the generated code
    guards  -- pairs (left, right): the branch holds where every left <= right and no earlier branch does
    lets    -- intermediate quantities in order
    outputs -- expressions in the arguments and the lets
    """

    name: str
    guards: tuple[tuple[sp.Expr, sp.Expr], ...]
    lets: tuple[Let, ...]
    outputs: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class Kernel:
    """A generated function of real numbers.

    parameters -- how many of the last arguments are the mechanism's parameters
    returns    -- "scalar", "tuple" or "stack" (one array, coefficients along its first axis)
    equation   -- number in the paper, or what it is derived from
    domain     -- where it holds
    generic    -- in Python for any kind of number that has arithmetic, and NumPy's functions where it calls them:
                  floats, complex numbers, arrays, an integrator's symbols
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

    @property
    def width(self) -> int:
        return len(self.branches[0].outputs)


@dataclass(frozen=True)
class Composition:
    """A function that calls `inner` of the slow flow with m = friction(mu) and h, h_A, ... of the mechanism put in."""

    name: str
    arguments: tuple[sp.Symbol, ...]
    inner: Kernel
    doc: str
    parameters: int = 0

    @property
    def derivatives(self) -> int:
        """How many of h, h_A, h_AA, h_AAA the inner kernel takes: 0, or up to the highest one."""
        return max((k + 1 for k, symbol in enumerate(AVERAGED) if symbol in self.inner.arguments), default=0)

    @property
    def unused(self) -> tuple[sp.Symbol, ...]:
        """Arguments that do not enter."""
        parameters = self.arguments[len(self.arguments) - self.parameters :] if self.derivatives else ()
        used = {*self.inner.arguments, *parameters, *((mu,) if m in self.inner.arguments else ())}
        return tuple(argument for argument in self.arguments if argument not in used)


@dataclass(frozen=True)
class Record:
    """What the generated record of a mechanism holds beside the module's kernels.

    mechanism       -- where it comes from
    parameters      -- what its kernels take, in their order
    harmonics_up_to -- the largest breakpoint for which the harmonics hold
    truncated       -- whether the force is a Taylor polynomial that stands for another
    untruncated     -- name of the mechanism with that other force; "" where there is none
    attached        -- whether the kernel `attached` averages the first piece alone
    """

    mechanism: Mechanism
    parameters: tuple[Parameter, ...]
    harmonics_up_to: sp.Expr
    truncated: bool
    untruncated: str
    attached: bool


@dataclass(frozen=True)
class TwofoldKernel:
    """A generated function in double-double, for floats and arrays as they are; see `compensated`.

    lets, values -- what to evaluate, in structured form
    lows    -- which arguments come with a low part, and its name
    returns -- "rounded": one value, as a double; "pairs": high, low for each; "distilled": one value, a sum of products
               of two doubles, with a certain sign
    beside  -- outputs in plain doubles that follow, in the arguments and the lets
    """

    name: str
    arguments: tuple[sp.Symbol, ...]
    lets: tuple[Let, ...]
    values: tuple[sp.Expr, ...]
    doc: str
    equation: str
    domain: str
    lows: dict[sp.Symbol, sp.Symbol] = field(default_factory=dict)
    returns: str = "rounded"
    beside: tuple[sp.Expr, ...] = ()


@dataclass(frozen=True)
class Module:
    """One generated module.

    inputs     -- file names below `derivations/` that it is derived from
    flow       -- name of the slow-flow module that compositions call
    family     -- name of the module whose h they call
    reexports  -- names taken over from another module of the same mechanism, as (module, names)
    constants  -- Python constants (name, value)
    twofolds   -- kernels in double-double
    pieces     -- tables of generic kernels by name: for each piece of a force, the names of those of force and slope
    record     -- of a mechanism's own module
    """

    name: str
    title: str
    inputs: tuple[str, ...]
    kernels: tuple[Kernel, ...]
    compositions: tuple[Composition, ...] = ()
    flow: str = ""
    family: str = ""
    reexports: tuple[str, tuple[str, ...]] = ("", ())
    constants: dict[str, object] = field(default_factory=dict)
    mechanism: Mechanism | None = None
    twofolds: tuple[TwofoldKernel, ...] = ()
    pieces: dict[str, tuple[tuple[str, ...], ...]] = field(default_factory=dict)
    record: Record | None = None

    @property
    def loops(self) -> bool:
        """Whether anything in it is compiled into loops over arrays."""
        return bool(self.compositions) or any(not kernel.generic for kernel in self.kernels)


def plain(
    name: str,
    arguments: Sequence[sp.Symbol],
    outputs: sp.Expr | Sequence[sp.Expr],
    doc: str,
    equation: str,
    domain: str = "Omega > 0, A > 0",
    lets: Sequence[Let] = (),
    **keywords: object,
) -> Kernel:
    """A kernel with one branch."""
    single = isinstance(outputs, sp.Expr)
    if not single:
        keywords.setdefault("returns", "tuple")
    branch = Branch("", (), tuple(lets), (outputs,) if single else tuple(outputs))
    return Kernel(name, tuple(arguments), (branch,), doc, equation, domain, **keywords)


def by_even_power(elimination: Elimination) -> tuple[sp.Expr, ...]:
    """Coefficients of the reduced resultant by even power of its unknown, constant first, zeros included."""
    odd = [power for power in elimination.reduced if power % 2]
    if odd:
        raise ArithmeticError(f"odd powers {odd} of {elimination.unknown} in a resultant that should be even")
    top = max(elimination.reduced)
    return tuple(elimination.reduced.get(power, sp.Integer(0)) for power in range(0, top + 1, 2))


def suffix(scene: str) -> str:
    """Of a module's name."""
    return f"_{scene}" if scene else ""


def in_words(scene: str) -> str:
    """What vanishes in a scene."""
    vanishing = [f"{symbol} = 0" for symbol in SCENES[scene]]
    return f", in the scene {' and '.join(vanishing)}" if vanishing else ""
