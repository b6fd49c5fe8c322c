"""What a kernel is: the forms in which the catalogue states functions, and in which the targets take them.

In:  exact SymPy expressions, and what is known of them: arguments, equation number, domain.
Out: `Kernel`, a function of numbers, regime by regime; `Selection` and `Composition`, which call another; `Module`, a
     file of them.

Arguments come in one order everywhere: Omega, A, F_0, m or mu, zeta, h, h_A, h_AA, h_AAA, the mechanism's parameters.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import sympy as sp

from ..kernels import Branch as Branch
from ..kernels import Called, Kernel, Let
from ..symbols import h, h_A, h_AA, h_AAA
from .prose import Prose

if TYPE_CHECKING:
    from ..asymmetric.sided import Sided
    from ..extensions.scaling import Scale
    from ..mechanisms import Mechanism, Parameter

AVERAGED = (h, h_A, h_AA, h_AAA)

#: name of the slow flow's module with all damping terms
GENERAL = "slow_flow"

#: of h or H and its derivatives
NAMES = ("", "_A", "_AA", "_AAA")


@dataclass(frozen=True)
class Selection(Called):
    """A function that takes some outputs of another with the same arguments.

    source   -- the other one; it returns a tuple
    chosen   -- numbers of the outputs taken
    compiled -- whether Python has it as a loop over arrays of floats, which computes these alone
    """

    name: str
    source: Kernel | Selection
    chosen: tuple[int, ...]
    doc: str
    equation: str
    compiled: bool = False

    @property
    def arguments(self) -> tuple[sp.Symbol, ...]:
        return self.source.arguments

    @property
    def domain(self) -> str:
        return self.source.domain

    @property
    def parameters(self) -> int:
        return self.source.parameters

    @property
    def width(self) -> int:
        return len(self.chosen)

    @property
    def returns(self) -> str:
        return "scalar" if self.width == 1 else "tuple"


@dataclass(frozen=True)
class Composition(Called):
    """A function that calls `inner` of the slow flow with m = friction(mu) and h, h_A, ... of the mechanism put in.

    average  -- what gives h and its first derivatives; None where the inner kernel takes none
    compiled -- whether Python has it as one loop over arrays of floats
    """

    name: str
    arguments: tuple[sp.Symbol, ...]
    inner: Kernel
    average: Kernel | Selection | None
    parameters: int = 0
    compiled: bool = False

    @property
    def doc(self) -> str:
        return self.inner.doc

    @property
    def equation(self) -> str:
        return self.inner.equation

    @property
    def domain(self) -> str:
        return self.inner.domain

    @property
    def width(self) -> int:
        return self.inner.width

    @property
    def returns(self) -> str:
        return self.inner.returns


@dataclass(frozen=True)
class Law:
    """One piece of a force as a mechanism's record has it, by names.

    force, slope -- of the generic kernels
    name         -- of the law itself, the same in every language: by it Python finds the Taylor recurrences in C
    begins       -- where it begins as a broken power of what |u| exceeds that by; None elsewhere
    """

    force: str
    slope: str
    name: str
    begins: sp.Expr | None = None


@dataclass(frozen=True)
class Record:
    """What the generated record of a mechanism holds beside the module's kernels.

    mechanism       -- where it comes from
    parameters      -- what its kernels take, in their order
    pieces          -- of the force, by rising |u|
    harmonics_up_to -- the largest breakpoint for which the harmonics hold
    truncated       -- whether the force is a Taylor polynomial that stands for another
    untruncated     -- name of the mechanism with that other force; "" where there is none
    scales          -- what the design's numbers are measured in
    stepped         -- whether the force is known as a sum of steps
    odd             -- whether the force is; averages about the centre are of such ones only
    """

    mechanism: Mechanism | Sided
    parameters: tuple[Parameter, ...]
    pieces: tuple[Law, ...]
    harmonics_up_to: sp.Expr
    truncated: bool
    untruncated: str
    scales: tuple[Scale, ...]
    stepped: bool = False
    odd: bool = True


@dataclass(frozen=True)
class TwofoldKernel:
    """A generated function in double-double, which only the compiled solvers call; see `compensated`.

    lets, values -- what to evaluate, in structured form
    lows    -- which arguments come with a low part, and its name
    returns -- "rounded": one value, as a double; "pairs": high, low for each; "distilled": one value, a sum of products
               of two doubles, with a certain sign
    plain   -- outputs in plain doubles that follow, in the arguments and the lets
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
    plain: tuple[sp.Expr, ...] = ()
    compiled = True

    @property
    def width(self) -> int:
        return (2 if self.returns == "pairs" else 1) * len(self.values) + len(self.plain)


@dataclass(frozen=True)
class Sums:
    """A function of A that closes integrals over the quarter cycle, summed by `slowflow.support.quadrature`.

    terms   -- of each piece of the force, the generic kernel of what stands under the integrals
               then of each contact, from where it begins up to A
    closing -- the kernel of A, the integrals and the parameters that gives the outputs
    graded  -- of each of these the power of what is divided into panels that its angle is
    begins  -- the number of the breakpoint at which each contact begins
    scalar  -- whether it gives a number
    unused  -- arguments after A that it has no use for
    """

    name: str
    terms: tuple[Kernel, ...]
    closing: Kernel
    doc: str
    equation: str
    graded: tuple[int, ...]
    begins: tuple[int, ...] = ()
    scalar: bool = False
    unused: tuple[sp.Symbol, ...] = ()

    @property
    def parameters(self) -> tuple[sp.Symbol, ...]:
        """Of the mechanism."""
        return self.closing.packed


@dataclass(frozen=True)
class Enclosed:
    """What holds the average on an interval of amplitudes, by names of kernels on intervals.

    terms   -- of each piece of the force, what stands under the integrals of h and h_AAAA
    closing -- both in the integrals, by how many breakpoints the amplitude exceeds
    contacts -- of each contact what M and its derivatives are integrals of
    begins  -- the number of the breakpoint at which each begins
    """

    terms: tuple[Kernel, ...]
    closing: tuple[Kernel, ...]
    contacts: tuple[Kernel, ...] = ()
    begins: tuple[int, ...] = ()

    @property
    def kernels(self) -> tuple[Kernel, ...]:
        """All of them."""
        return self.terms + self.contacts + self.closing


@dataclass(frozen=True)
class OffCentreTerms:
    """What the means of a force that is no polynomial are summed from, where motions are off the centre.

    gained  -- the kernel of its gains
    pieces  -- of each piece with its derivatives
    bounded -- the same of each piece on intervals
    gained_by, by_parameter -- of what each parameter does to the gains, and to each piece; None where that is nothing
    """

    gained: Kernel
    pieces: tuple[Kernel, ...]
    bounded: tuple[Kernel, ...]
    gained_by: Kernel
    by_parameter: tuple[tuple[Kernel | None, ...], ...]


@dataclass(frozen=True)
class Module:
    """One generated module.

    stated     -- its kernels on numbers of any kind
    inputs     -- file names below `derivations/` that it is derived from
    flow       -- name of the slow-flow module that compositions call
    constants  -- Python constants (name, value)
    twofolds   -- kernels in double-double
    record     -- of a mechanism's own module
    native     -- whether its loops over arrays are compiled into the package
    in_c       -- whether anything in C calls it: loops over arrays, or a solver
    sums       -- averages by quadrature
    enclosed   -- what holds the average on intervals; None where h_AAA is proved to be monotone
    off_centre -- what means off the centre are summed from; None where they are sums over steps, or not known
    """

    name: str
    title: str
    inputs: tuple[str, ...]
    stated: tuple[Kernel, ...]
    selections: tuple[Selection, ...] = ()
    compositions: tuple[Composition, ...] = ()
    flow: str = ""
    constants: dict[str, object] = field(default_factory=dict)
    twofolds: tuple[TwofoldKernel, ...] = ()
    record: Record | None = None
    native: bool = True
    in_c: bool = True
    sums: tuple[Sums, ...] = ()
    enclosed: Enclosed | None = None
    off_centre: OffCentreTerms | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "title", Prose(self.title))

    @property
    def on_intervals(self) -> tuple[Kernel, ...]:
        """What Python has on intervals with elementary functions."""
        return (*(self.enclosed.terms if self.enclosed else ()), *(self.off_centre.bounded if self.off_centre else ()))

    @property
    def looped(self) -> tuple[Kernel | TwofoldKernel | Selection | Composition, ...]:
        """What is compiled into loops over arrays."""
        every = (*self.kernels, *self.twofolds, *self.selections, *self.compositions)
        return tuple(one for one in every if one.compiled)

    @property
    def from_c(self) -> tuple[Kernel | TwofoldKernel, ...]:
        """What Python has from C, as loops over arrays, because no Python code calls it."""
        return (*(kernel for kernel in self.kernels if not kernel.in_python), *self.twofolds)

    def on(self, arithmetic: str) -> tuple[Kernel, ...]:
        """The kernels on numbers of one kind."""
        return tuple(one for one in self.stated if arithmetic in one.arithmetics)

    @property
    def kernels(self) -> tuple[Kernel, ...]:
        """The kernels on doubles."""
        return self.on("doubles")

    @property
    def is_proved(self) -> bool:
        """Whether it has what proofs take."""
        return any(one.name == "given" for one in self.stated)
