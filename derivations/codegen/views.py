"""Kernels as a template needs them: printed line by line, with what each branch and output depends on.

In:  a `Kernel` with the straight-line `Program`s of its branches, or a `Composition`; a printer of `targets`.
Out: `KernelView`, or a dict for what only calls others.
"""

from __future__ import annotations

import functools
import itertools
import re
import textwrap
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import jinja2
import sympy as sp

from ..forces.repeated import TURNS, Output, Repeated
from ..paper.restoring_force import FAR
from ..paper.slow_flow import m
from .bytecode import kept_beside
from .compensated import Exact, twofold
from .form import AVERAGED, Branch, Composition, Kernel, Module, TwofoldKernel
from .passes import Let, Program, program_of, straight_line
from .prose import Prose, escaped
from .proved import in_words

if TYPE_CHECKING:
    from .targets.printing import Rules

#: the straight-line code of every branch, by kernel
Code = dict[str, tuple[Program, ...]]

WIDTH = 116
#: of outputs whose bounds a comment lists
MOST_BOUNDS = 8


@dataclass(frozen=True)
class Line:
    """One assignment, printed; wrapped where it is long.

    number   -- its type, where that is not the kernel's own
    function -- what is called, if it is one that is printed beside the kernels: `name` are all its outputs then, and
                `value` its arguments
    columns, table -- of a loop that calls it: arguments that vary, and what they are in each turn; `name` are the sums
                of its outputs over all turns
    state    -- where it is a loop itself: what it begins from, before its other arguments
    """

    name: str
    value: str
    number: str = ""
    function: str = ""
    columns: tuple[str, ...] = ()
    table: tuple[tuple[str, ...], ...] = ()
    state: tuple[str, ...] = ()


@dataclass(frozen=True)
class RepeatedView:
    """What kernels of a module repeat, as a template needs it.

    state   -- of a loop, the first arguments, which are the outputs of the turn before
    columns -- where it is summed over the rows of a table, the arguments that are in a row
    """

    name: str
    doc: str
    arguments: tuple[str, ...]
    state: tuple[str, ...]
    columns: tuple[str, ...]
    lets: tuple[Line, ...]
    outputs: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class BranchView:
    """A branch as a template needs it.

    name     -- where it holds
    function -- what computes it, after the module's prefix
    printed  -- whether that function is printed with this kernel
    proved   -- bounds of its outputs' rounding errors, where they are proved
    """

    name: str
    function: str
    printed: bool
    guard: str
    lets: tuple[Line, ...]
    outputs: tuple[str, ...]
    unused: tuple[str, ...]
    operations: int
    proved: str


@dataclass(frozen=True)
class KernelView:
    """A kernel as a template needs it. `partial` says of each output whether it lacks an argument."""

    kernel: Kernel
    arguments: tuple[str, ...]
    branches: tuple[BranchView, ...]
    partial: bool
    outputs_partial: tuple[bool, ...]
    unused: tuple[str, ...]
    guard_names: tuple[str, ...]

    @property
    def plain(self) -> tuple[str, ...]:
        """The arguments before a mechanism's parameters."""
        return self.arguments[: len(self.kernel.plain)]

    @property
    def packed(self) -> tuple[str, ...]:
        """The parameters."""
        return self.arguments[len(self.kernel.plain) :]

    @property
    def doc(self) -> str:
        return self.kernel.doc

    @property
    def proved(self) -> bool:
        """Whether every output has a proved bound in every regime."""
        return all(branch.proved and "-" not in branch.proved for branch in self.branches)

    def facts(self, measured: Mapping[str, str]) -> str:
        """Equation, domain, operations and rounding errors, by regime where there are several, in a sentence each."""
        named = {f" in {branch.name}" if branch.name else "": branch for branch in self.branches if branch.printed}
        operations = ", ".join(f"{branch.operations}{regime}" for regime, branch in named.items())
        errors = [f"proved{regime} {worst(branch.proved)}" for regime, branch in named.items() if branch.proved]
        if not self.proved and self.kernel.name in measured:
            errors.append(f"measured {measured[self.kernel.name]}")
        known = [f"Equation {self.kernel.equation}. Domain: {self.kernel.domain}."]
        known += [f"Operations: {operations}."] if operations else []
        known += [f"Error / u (1 + kappa): {'; '.join(errors)}."] if errors else []
        return " ".join(known)

    @property
    def leaves_out(self) -> bool:
        """Whether it has no use for an argument in some regime."""
        return not self.kernel.width or any(branch.unused for branch in self.branches)


@dataclass(frozen=True)
class Calls:
    """How a language calls other functions within a composition.

    friction -- m from mu
    inner    -- the slow flow's function, from its name
    averages -- what h, h_A, ... are called
    """

    friction: str
    inner: Callable[[str], str]
    averages: tuple[str, ...]


def programs(module: Module, kernels: Iterable[Kernel] | None = None) -> Code:
    """The straight-line code of every branch, by kernel: of all of a module, or of those requested."""
    every = (*module.stated, *module.on_intervals)
    every += module.enclosed.contacts + module.enclosed.closing if module.enclosed else ()
    return {
        kernel.name: tuple(straight_line(branch.lets, branch.outputs, kernel.arguments) for branch in kernel.branches)
        for kernel in (every if kernels is None else kernels)
    }


@functools.cache
def templates(folder: Path) -> jinja2.Environment:
    """The templates below `folder`, which is a target's, each compiled once; what they use undefined is an error."""
    environment = jinja2.Environment(
        # of C's what other kinds of header share with it
        loader=jinja2.FileSystemLoader([folder / "templates", Path(__file__).parent / "targets" / "c" / "templates"]),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        finalize=_shown,
        bytecode_cache=kept_beside(folder / "templates", Path(__file__)),
    )
    environment.filters["fill"] = _filled
    environment.filters["returned"] = returned
    environment.filters["tuple"] = lambda names: f"({', '.join(names)}{',' if len(names) == 1 else ''})"
    return environment


@jinja2.pass_context
def _shown(context: jinja2.runtime.Context, value: object) -> object:
    """What a template prints of a value: of what people wrote, text in its language."""
    return escaped(value, str(context.name)) if isinstance(value, Prose) else value


@jinja2.pass_context
def _filled(context: jinja2.runtime.Context, text: str, indent: int, first: int = 0) -> str:
    """`fill`, of the text as it is printed."""
    return fill(str(_shown(context, text)), indent, first)


def heading(module: Module) -> str:
    """What a generated file is from. The manifest has hashes and the tools' versions."""
    return f"Written by `make derive` from {', '.join(f'derivations/{name}' for name in module.inputs)}; never edit."


def regimes(module: Module) -> str:
    """What the names of the regimes mean, where there are any."""
    if not any("far" in branch.name for kernel in module.kernels for branch in kernel.branches):
        return ""
    return f"Regimes: passed_n where A exceeds n breakpoints, far_k where it exceeds k of them {FAR} times."


def fill(text: str, indent: int, first: int = 0) -> str:
    """A paragraph wrapped at the line length, continued at `indent`, its first line `first` wide already."""
    whole = textwrap.TextWrapper(
        WIDTH,
        initial_indent=" " * first,
        subsequent_indent=" " * indent,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return whole.fill(text)[first:]


def returned(outputs: Sequence[str], shaped_by: Sequence[str] = (), function: str = "broadcast_outputs") -> str:
    """A tuple as a function in Python returns it: on one line where that holds it, else an output a line.

    Names and numbers that follow one another share theirs. `shaped_by`: the arguments whose shape a function gives the
    outputs.
    """
    of = f"{function}(({', '.join(shaped_by)}{',' if len(shaped_by) == 1 else ''}), " if shaped_by else ""
    line = f"{of}{', '.join(outputs)}{')' if shaped_by else ''}"
    if (len(outputs) > 1 or shaped_by) and len(f"    return {line}") <= WIDTH:
        return line
    runs = itertools.groupby(outputs, lambda output: bool(re.fullmatch(r"-?[\w.]+", output)))
    together = (one for is_short, run in runs for one in ([", ".join(run)] if is_short else run))
    lines = "".join(f"        {fill(one, 8, 8)},\n" for one in together)
    return f"{of.rstrip() or '('}\n{lines}    )"


def worst(proved: str) -> str:
    """Bounds output by output; of many that are all proved the largest."""
    bounds = proved.split(", ")
    return proved if "-" in bounds or len(bounds) <= MOST_BOUNDS else f"{max(bounds, key=float)} at most"


def view(
    kernel: Kernel, code: Sequence[Program], printer: Rules, with_calls: Sequence[Program] | None = None
) -> KernelView:
    """A kernel printed for one language, with calls of what it has in common with others where these are stated."""
    renamed = [*map(printer.doprint, kernel.arguments)]
    branches, used_anywhere, used_by_guards = [], set(), set()
    reached = [True] * kernel.width
    for branch, program, shown in zip(kernel.branches, code, with_calls or code, strict=True):
        used = used_arguments(program, kernel)
        for k, names in enumerate(used):
            reached[k] = reached[k] and names == set(kernel.arguments)
        guard_symbols = set().union(*(side.free_symbols for pair in branch.guards for side in pair))
        used_by_guards |= guard_symbols
        used_here = set().union(*used) | guard_symbols
        used_anywhere |= used_here
        branches.append(branch_view(branch, program, kernel, set().union(*used), printer, shown))
    return KernelView(
        kernel,
        tuple(renamed),
        tuple(branches),
        not all(reached),
        tuple(not full for full in reached),
        tuple(name for name, symbol in zip(renamed, kernel.arguments, strict=True) if symbol not in used_anywhere),
        tuple(name for name, symbol in zip(renamed, kernel.arguments, strict=True) if symbol in used_by_guards),
    )


def used_arguments(program: Program, kernel: Kernel) -> list[set[sp.Symbol]]:
    """Which arguments each output depends on."""
    depends: dict[sp.Symbol, set[sp.Symbol]] = {argument: {argument} for argument in kernel.arguments}

    def of(expression: sp.Expr) -> set[sp.Symbol]:
        return set().union(*(depends[symbol] for symbol in expression.free_symbols))

    for symbol, value in program.lets:
        depends[symbol] = of(value)
    return [of(output) for output in program.outputs]


def branch_view(
    branch: Branch, program: Program, kernel: Kernel, used: set[sp.Symbol], printer: Rules, shown: Program
) -> BranchView:
    """A branch printed for one language, `shown` in place of its program."""
    show = printer.doprint
    lines = printed(shown.lets, printer)
    guard = printer.conjunction.join(f"({show(left)} <= {show(right)})" for left, right in branch.guards)
    if len(branch.guards) == 1:
        guard = guard[1:-1]
    return BranchView(
        branch.name,
        branch.kernel or (f"{kernel.name}_{branch.name}" if branch.name else kernel.name),
        not branch.kernel,
        guard,
        lines,
        tuple(show(output) for output in shown.outputs),
        tuple(show(argument) for argument in kernel.arguments if argument not in used),
        program.operations,
        in_words(program, kernel.arguments),
    )


def printed(lets: Sequence[Let], printer: Rules) -> tuple[Line, ...]:
    """Lets as lines; the outputs of one call are one line, and calls whose outputs are only summed are one loop."""
    lines: list[Line] = []
    summed: set[sp.Symbol] = set()
    calls = [list(together) for _, together in itertools.groupby(lets, _call)]
    runs = itertools.groupby(calls, lambda call: getattr(call[0][1], "repeated", None))
    for repeated, run in runs:
        here = list(run)
        if repeated is None:
            plain = (let for call in here for let in call if let[0] not in summed)
            lines += (_assigned(symbol, value, printer) for symbol, value in plain)
            continue
        if any([one.number for _, one in call] != list(range(len(repeated.outputs))) for call in here):
            raise ArithmeticError(f"not every output of {repeated.name} is used, or not in their order")
        sums = _sums(here, lets)
        if sums:
            lines.append(_loop(here, sums, printer))
            gone = {symbol for call in here for symbol, _ in call}
            others = {symbol.name for name, value in lets for symbol in {name, *value.free_symbols} - gone}
            if taken := others & {*lines[-1].columns}:
                raise ArithmeticError(f"{repeated.name} called in a loop hides {sorted(taken)}")
            summed |= {symbol for symbol, _ in sums}
        else:
            lines += (_called(call, printer) for call in here)
    return tuple(lines)


def _call(let: Let) -> object:
    """What the outputs of one call have in common; a let of anything else stands alone."""
    return (let[1].repeated, let[1].args) if isinstance(let[1], Output) else let


def _assigned(symbol: sp.Symbol, value: sp.Expr, printer: Rules) -> Line:
    name = printer.doprint(symbol)
    return Line(name, wrapped(printer.doprint(value), len(name) + 3, printer))


def _called(call: Sequence[Let], printer: Rules) -> Line:
    symbols, (value, *_) = zip(*call, strict=True)
    named, count = zip(value.repeated.arguments, value.args, strict=True), len(value.repeated.state)
    arguments = [str(one) if name is TURNS else printer.doprint(one) for name, one in named]
    return Line(
        ", ".join(printer.doprint(symbol) for symbol in symbols),
        ", ".join(arguments[count:]),
        function=value.repeated.name,
        state=tuple(arguments[:count]),
    )


def _sums(calls: Sequence[Sequence[Let]], lets: Sequence[Let]) -> list[Let]:
    """The lets that are the sums of each output over several calls, where nothing else reads these outputs."""
    columns = [{call[k][0] for call in calls} for k in range(len(calls[0]))]
    readers = [let for let in lets if any(not column.isdisjoint(let[1].free_symbols) for column in columns)]
    if len(calls) == 1 or len(readers) != len(columns):
        return []
    found = [next((let for let in readers if let[1].is_Add and set(let[1].args) == column), None) for column in columns]
    return [] if None in found else found


def _loop(calls: Sequence[Sequence[Let]], sums: Sequence[Let], printer: Rules) -> Line:
    """These calls by a table of what varies, in the order in which the first sum has them."""
    by_name = {call[0][0]: call[0][1] for call in calls}
    turns = [by_name[name] for name in printer._as_ordered_terms(sums[0][1])]
    repeated = turns[0].repeated
    varies = [len({turn.args[k] for turn in turns}) > 1 for k in range(len(turns[0].args))]
    show = printer.doprint
    own = [*map(show, repeated.arguments)]
    return Line(
        ", ".join(show(symbol) for symbol, _ in sums),
        ", ".join(own[k] if vary else show(turns[0].args[k]) for k, vary in enumerate(varies)),
        function=repeated.name,
        columns=tuple(itertools.compress(own, varies)),
        table=tuple(tuple(map(show, itertools.compress(turn.args, varies))) for turn in turns),
    )


def repeated_views(code: Code, printer: Rules, views: Iterable[KernelView] = ()) -> list[RepeatedView]:
    """What the kernels of a module repeat, printed, by name; `views` are those that sum some of it over tables."""
    found: dict[str, Repeated] = {}
    columns = {line.function: line.columns for line in _lines_of(views) if line.table}

    def gather(lets: Iterable[Let]) -> None:
        # what calls others stands behind them
        for one in sorted({value.repeated for _, value in lets if isinstance(value, Output)}, key=lambda one: one.name):
            gather(program_of(one).lets)
            found.setdefault(one.name, one)

    gather(let for programs_ in code.values() for program in programs_ for let in program.lets)
    repeated = []
    for name, one in found.items():
        program = program_of(one)
        outputs = zip((symbol.name for symbol, _ in one.outputs), program.outputs, strict=True)
        repeated.append(
            RepeatedView(
                name,
                one.doc,
                tuple(map(printer.doprint, one.arguments)),
                tuple(map(printer.doprint, one.state)),
                columns.get(name, ()),
                printed(program.lets, printer),
                tuple((output, printer.doprint(value)) for output, value in outputs),
            )
        )
    return repeated


def tables(views: Iterable[KernelView]) -> list[tuple[tuple[str, ...], tuple[tuple[str, ...], ...]]]:
    """The tables that these kernels loop over, each once: columns and rows."""
    return list(dict.fromkeys((line.columns, line.table) for line in _lines_of(views) if line.table))


def _lines_of(views: Iterable[KernelView]) -> list[Line]:
    """All lines of these kernels."""
    return [line for view in views for branch in view.branches for line in branch.lets]


def wrapped(value: str, used: int, printer: Rules) -> str:
    """A long right-hand side over several lines, broken at spaces; `used` columns stand before it."""
    if not printer.bracketed:
        return fill(value, 8, used + len("    const double "))
    if len(value) + used + 8 <= WIDTH:
        return value
    return f"(\n        {fill(value, 8, 8)}\n    )"


def twofold_view(kernel: TwofoldKernel, printer: Rules) -> dict[str, object]:
    """A kernel in double-double as a template needs it; `op` says which lines are exact sums and products."""
    show = printer.doprint
    code = twofold(kernel)
    known = {line.high if isinstance(line, Exact) else line[0] for line in code.lines}
    plain_outputs = straight_line((), kernel.plain, {*kernel.arguments, *known})

    def plain(symbol: sp.Symbol, value: sp.Expr) -> dict[str, str]:
        name = printer.doprint(symbol)
        return {"op": "", "name": name, "value": wrapped(show(value), len(name) + 3, printer)}

    lines = [
        {
            "op": line.op,
            "name": printer.doprint(line.high),
            "low": line.low.name,
            "left": show(line.left),
            "right": show(line.right),
        }
        if isinstance(line, Exact)
        else plain(*line)
        for line in code.lines
    ]
    exact = Counter(line.op.removeprefix("two_") for line in code.lines if isinstance(line, Exact))
    return {
        "kernel": kernel,
        "arguments": [*map(show, kernel.arguments)],
        "lines": [*lines, *(plain(symbol, value) for symbol, value in plain_outputs.lets)],
        "distilled": [show(part) for part in code.distilled],
        "outputs": [show(output) for output in (*code.outputs, *plain_outputs.outputs)],
        "exact": " and ".join(f"{count} {op}{'s' if count > 1 else ''}" for op, count in sorted(exact.items())),
    }


def composition_view(composition: Composition, calls: Calls) -> dict[str, object]:
    """A composition with the call of the inner kernel: its arguments, and what the average gives of them."""
    average = composition.average
    outputs = AVERAGED[: average.width] if average else ()
    local = {symbol.name: name for symbol, name in zip(AVERAGED, calls.averages, strict=True)}
    local[m.name] = calls.friction
    return {
        "of": composition,
        "averages": [local[symbol.name] if symbol in composition.inner.arguments else "_" for symbol in outputs],
        "inner": calls.inner(composition.inner.name),
        "passed": [local.get(argument.name, argument.name) for argument in composition.inner.arguments],
    }
