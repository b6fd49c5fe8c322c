"""From modules to source text: passes, printers, then a template for each output.

In:  `Module`s.
Out: a dict from file name (below `generated/`) to text, and for the manifest the operation counts of each kernel.

A further output is a further `Target`: a printer, a template and a file name.
"""

from __future__ import annotations

import hashlib
import importlib.metadata
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import jinja2
import sympy as sp

from derivations.emit.kernels import AVERAGED, Branch, Composition, Kernel, Module
from derivations.emit.passes import Program, straight_line
from derivations.emit.printers import CPrinter, NumpyPrinter
from derivations.restoring import FAR
from derivations.slow_flow import m

HERE = Path(__file__).parent
WIDTH = 116
# the function that gives h and how many of its derivatives
AVERAGE_FUNCTION = {0: "", 1: "h", 2: "averaged_2", 3: "averaged_3", 4: "averaged"}
TOOLS = ("sympy", "python-flint", "jinja2")


@dataclass(frozen=True)
class Line:
    """One assignment, printed; wrapped where it is long."""

    name: str
    value: str


@dataclass(frozen=True)
class BranchView:
    """A branch as a template needs it."""

    name: str
    guard: str
    lets: tuple[Line, ...]
    outputs: tuple[str, ...]
    unused: tuple[str, ...]
    counts: dict[str, int]


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
    def doc(self) -> str:
        return self.kernel.doc

    @property
    def uses_angles(self) -> bool:
        """Whether it calls the generated arctangent."""
        texts = (text for branch in self.branches for text in (*branch.outputs, *(line.value for line in branch.lets)))
        return any("angles_" in text for text in texts)


@dataclass(frozen=True)
class Target:
    """One language: its printer, how it wraps, its template and file name."""

    name: str
    printer: sp.printing.printer.Printer
    template: str
    file_name: str
    conjunction: str
    wrap_in_parentheses: bool
    names: dict[str, str]


TARGETS = (
    Target("numpy", NumpyPrinter(), "numpy_module.py.jinja", "slowflow_kernels/{}.py", " & ", True, {}),
    Target("c", CPrinter(), "c_header.h.jinja", "c/{}.h", " && ", False, {"I": "I_"}),
)


def versions() -> dict[str, str]:
    """Of the tools that shape the output."""
    return {tool: importlib.metadata.version(tool) for tool in TOOLS}


def tools() -> str:
    """The same in words."""
    return ", ".join(f"{tool} {version}" for tool, version in versions().items())


def digest(path: Path) -> str:
    """SHA-256 of a file."""
    return hashlib.sha256(path.read_bytes()).hexdigest()


def programs(module: Module) -> dict[str, tuple[Program, ...]]:
    """The straight-line code of every branch, by kernel."""
    return {
        kernel.name: tuple(straight_line(branch.lets, branch.outputs, kernel.arguments) for branch in kernel.branches)
        for kernel in module.kernels
    }


def templates() -> jinja2.Environment:
    """The folder of templates; what they use and nobody defined is an error."""
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE / "templates"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )


def render(modules: Sequence[Module]) -> tuple[dict[str, str], dict[str, dict[str, object]]]:
    """All files but the manifest, and the kernels' entries in it."""
    environment = templates()
    environment.filters["fill"] = fill
    environment.filters["tuple"] = lambda names: f"({', '.join(names)}{',' if len(names) == 1 else ''})"
    shared = {"tools": tools(), "AVERAGED": [symbol.name for symbol in AVERAGED], "modules": modules}
    files = {}
    manifest: dict[str, dict[str, object]] = {}
    for module in modules:
        code = programs(module)
        manifest[module.name] = {kernel.name: operations(kernel, code[kernel.name]) for kernel in module.kernels}
        inputs = {f"derivations/{name}": digest(HERE.parent / name) for name in module.inputs if "/" in name}
        steps = [f"derivations/{name}" for name in module.inputs if "/" not in name]
        for target in TARGETS:
            views = [view(kernel, code[kernel.name], target) for kernel in module.kernels]
            text = environment.get_template(target.template).render(
                module=module,
                kernels=views,
                compositions=[composition_view(c, module, target) for c in module.compositions],
                exported=exported(module),
                includes=includes(module, views),
                regimes=regimes(module),
                imported=sorted(module.reexports[1], key=in_import),
                inputs=inputs,
                steps=steps,
                constants={name: constant(value) for name, value in module.constants.items()},
                **shared,
            )
            files[target.file_name.format(module.name)] = text
    for name, template in (("__init__.py", "numpy_init.py.jinja"), ("_broadcast.py", "numpy_broadcast.py.jinja")):
        files[f"slowflow_kernels/{name}"] = environment.get_template(template).render(**shared)
    return files, manifest


def operations(kernel: Kernel, code: Sequence[Program]) -> dict[str, dict[str, int]]:
    """Counts after each pass, by branch."""
    return {branch.name or "all": one.counts for branch, one in zip(kernel.branches, code, strict=True)}


def exported(module: Module) -> list[str]:
    """Public names of a Python module, sorted as in an import."""
    own = [*module.constants, *(kernel.name for kernel in module.kernels), *(c.name for c in module.compositions)]
    return sorted({*module.reexports[1], *own}, key=in_import)


def includes(module: Module, views: Sequence[KernelView]) -> list[str]:
    """Headers of ours that a C header needs."""
    angles = "angles" if any(view.uses_angles for view in views) else ""
    return [name for name in (angles, module.flow, module.reexports[0]) if name]


def regimes(module: Module) -> str:
    """What the names of the regimes mean, where there are any."""
    if not any("far" in branch.name for kernel in module.kernels for branch in kernel.branches):
        return ""
    return f"Regimes: passed_n where A exceeds n breakpoints, far_k where it exceeds k of them {FAR} times."


def in_import(name: str) -> tuple[bool, bool, str]:
    """Where a name stands in an import: constants, then what begins with a capital, then the rest."""
    return not (name.isupper() and len(name) > 1), not name[0].isupper(), name


def constant(value: object) -> str:
    """A module constant as Python source."""
    if isinstance(value, sp.Expr):
        return 'float("inf")' if value == sp.oo else repr(float(value))
    if isinstance(value, tuple):
        items = ", ".join(f'"{item}"' for item in value)
        return f"({items}{',' if len(value) == 1 else ''})"
    return f'"{value}"'


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


def view(kernel: Kernel, code: Sequence[Program], target: Target) -> KernelView:
    """A kernel printed for one target."""
    renamed = [target.names.get(argument.name, argument.name) for argument in kernel.arguments]
    branches, used_anywhere, used_by_guards = [], set(), set()
    reached = [True] * kernel.width
    for branch, program in zip(kernel.branches, code, strict=True):
        used = used_arguments(program, kernel)
        for k, names in enumerate(used):
            reached[k] = reached[k] and names == set(kernel.arguments)
        guard_symbols = set().union(*(side.free_symbols for pair in branch.guards for side in pair))
        used_by_guards |= guard_symbols
        used_here = set().union(*used) | guard_symbols
        used_anywhere |= used_here
        branches.append(branch_view(branch, program, kernel, set().union(*used), target))
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


def branch_view(branch: Branch, program: Program, kernel: Kernel, used: set[sp.Symbol], target: Target) -> BranchView:
    """A branch printed for one target."""
    show = target.printer.doprint

    def name_of(symbol: sp.Symbol) -> str:
        return target.names.get(symbol.name, symbol.name)

    lines = tuple(
        Line(name_of(symbol), wrapped(show(value), len(name_of(symbol)) + 3, target)) for symbol, value in program.lets
    )
    guard = target.conjunction.join(f"({show(left)} <= {show(right)})" for left, right in branch.guards)
    if len(branch.guards) == 1:
        guard = guard[1:-1]
    return BranchView(
        branch.name,
        guard,
        lines,
        tuple(show(output) for output in program.outputs),
        tuple(name_of(argument) for argument in kernel.arguments if argument not in used),
        program.counts,
    )


def wrapped(value: str, used: int, target: Target) -> str:
    """A long right-hand side over several lines, broken at spaces; `used` columns stand before it."""
    if not target.wrap_in_parentheses:
        return fill(value, 8, used + len("    const double "))
    if len(value) + used + 8 <= WIDTH:
        return value
    return f"(\n        {fill(value, 8, 8)}\n    )"


def composition_view(composition: Composition, module: Module, target: Target) -> dict[str, object]:
    """A composition as a template needs it: what to compute first, and the call of the inner kernel."""
    count = composition.derivatives
    plain = [argument.name for argument in composition.arguments]
    packed: list[str] = []
    if composition.parameters:
        plain, packed = plain[: -composition.parameters], plain[-composition.parameters :]
    if target.name == "c":
        friction, inner = f"{module.flow}_friction(mu)", f"{module.flow}_{composition.inner.name}"
        averages = [f"average[{k}]" for k in range(4)]
    else:
        friction, inner = "flow.friction(mu)", f"flow.{composition.inner.name}"
        averages = ["average" + symbol.name[1:] for symbol in AVERAGED]
    local = {symbol.name: average for symbol, average in zip(AVERAGED, averages, strict=True)} | {m.name: friction}
    passed = [local.get(argument.name, argument.name) for argument in composition.inner.arguments]
    return {
        "name": composition.name,
        "doc": composition.doc,
        "equation": composition.inner.equation,
        "domain": composition.inner.domain,
        "plain": plain,
        "packed": packed,
        "averages": averages[:count],
        "average_function": AVERAGE_FUNCTION[count],
        "inner": inner,
        "passed": passed,
        "returns": composition.inner.returns,
        "unused": [argument.name for argument in composition.unused],
    }
