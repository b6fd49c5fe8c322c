"""The kernels in other languages: interfaces for Fortran and Julia, formulas for MATLAB.

Fortran and Julia call a library that is compiled from `exported.c`. A MATLAB class contains the formulas.
"""

from __future__ import annotations

import ast
import inspect
import json
import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from slowflow.version import include

__all__ = ["fortran", "headers", "julia", "matlab"]

WRITTEN = "Written by slowflow.languages; never edit."
#: arguments of C functions that are arrays, the mechanism's parameters and the outputs, as Fortran declares them
ARRAYS = {"p": "intent(in)", "out": "intent(out)"}
#: words of MATLAB that are names in Python
KEYWORDS = frozenset("case catch classdef elseif end function otherwise parfor persistent spmd switch".split())
#: of `slowflow.support.broadcast`, for the common size of MATLAB's arrays
SHARED = """\
function y = root(x)
    % The square root, NaN of a negative number.
    x(x < 0) = NaN;
    y = sqrt(x);
end

function varargout = broadcast_outputs(arguments, varargin)
    % Each value in the size to which the arguments expand.
    shape = 0;
    for k = 1:numel(arguments)
        shape = shape + zeros(size(arguments{k}));
    end
    varargout = cellfun(@(value) value + shape, varargin, 'UniformOutput', false);
end

function found = stacked(arguments, varargin)
    % Coefficients by rising power: a row each.
    rows = cell(1, numel(varargin));
    [rows{:}] = NAME.broadcast_outputs(arguments, varargin{:});
    rows = cellfun(@(row) row(:).', rows, 'UniformOutput', false);
    found = vertcat(rows{:});
end

function varargout = by_regime(guards, bodies, varargin)
    % Each element by the first function whose guard holds, or by the last.
    [varargin{1:end}] = NAME.broadcast_outputs(varargin, varargin{:});
    left = true(size(varargin{1}));
    varargout = repmat({NaN(size(left))}, 1, max(nargout, 1));
    for k = 1:numel(bodies)
        here = left;
        if k <= numel(guards)
            here = left & guards{k};
        end
        if any(here(:))
            elements = cellfun(@(argument) argument(here), varargin, 'UniformOutput', false);
            found = cell(size(varargout));
            [found{:}] = bodies{k}(elements{:});
            for j = 1:numel(found)
                varargout{j}(here) = found{j};
            end
        end
        left = left & ~here;
    end
end
"""


@dataclass(frozen=True)
class Prototype:
    """A C function: whether it returns a number, and its arguments, of which those in `ARRAYS` are arrays."""

    name: str
    scalar: bool
    arguments: tuple[str, ...]


def headers() -> list[Path]:
    """Find the installed C headers whose functions `exported.c` exports.

    Returns
    -------
    list of pathlib.Path
        In the order in which `exported.c` includes them.

    Examples
    --------
    >>> from slowflow import languages
    >>> languages.headers()[0].name
    'slow_flow.h'
    """
    folder = include()[1]
    names = re.findall(r'#include "(\w+\.h)"', (folder / "exported.c").read_text(encoding="utf-8"))
    return [folder / name for name in names]


def fortran(paths: Iterable[Path]) -> str:
    """Write a Fortran module with an interface (`bind(C)`) of each function of C headers.

    Parameters
    ----------
    paths : iterable of path_like
        `headers()`, or headers that `slowflow derive` wrote.

    Returns
    -------
    str
        The module `slowflow_kernels`, Fortran 2008. Functions have their C names, followed by `_upper` where another
        one differs in case only: `rod_spring_H_upper` next to `rod_spring_h`. `p` takes the mechanism's parameters,
        `out` the outputs; it must have room for them.

    Examples
    --------
    >>> from slowflow import languages
    >>> languages.fortran(languages.headers()).splitlines()[0]
    'module slowflow_kernels'
    """
    known = _prototypes(paths)
    names = _in_one_case([one.name for one in known])
    lines = ["module slowflow_kernels", f"  ! {WRITTEN}", "  implicit none", "  interface"]
    for one in known:
        arguments = _in_one_case(one.arguments)
        kind = "real(c_double) function" if one.scalar else "subroutine"
        head = f'pure {kind} {names[one.name]}({", ".join(arguments.values())}) bind(c, name="{one.name}")'
        lines += _continued(head, 4)
        lines.append("      use, intrinsic :: iso_c_binding, only: c_double")
        for name, shown in arguments.items():
            size = "(*)" if name in ARRAYS else ""
            lines.append(f"      real(c_double), {ARRAYS.get(name, 'value')} :: {shown}{size}")
        lines.append(f"    end {kind.split()[-1]}")
    return "\n".join([*lines, "  end interface", "end module", ""])


def julia(paths: Iterable[Path], library: str = "kernels.so") -> str:
    """Write a Julia module that calls each function of C headers by `ccall`.

    Parameters
    ----------
    paths : iterable of path_like
        `headers()`, or headers that `slowflow derive` wrote.
    library : str
        File name of the library compiled from `exported.c`, in the folder of the module.

    Returns
    -------
    str
        The module `slowflow_kernels`. Functions have their C names, followed by `!` where the last argument takes the
        outputs. It was not tested in Julia.
    """
    lines = ["module slowflow_kernels", f"# {WRITTEN}", f"const library = joinpath(@__DIR__, {json.dumps(library)})"]
    for one in _prototypes(paths):
        taken, returned = ", ".join(one.arguments), "Cdouble" if one.scalar else "Cvoid"
        types = "".join("Ptr{Cdouble}, " if name in ARRAYS else "Cdouble, " for name in one.arguments)
        lines.append(f"{one.name}{'' if one.scalar else '!'}({taken}) =")
        lines.append(f"    ccall((:{one.name}, library), {returned}, ({types.rstrip()}), {taken})")
    return "\n".join([*lines, "end", ""])


def matlab(module: ModuleType) -> str:
    """Write the kernels of a module as a MATLAB class, whose static methods have the same formulas.

    Parameters
    ----------
    module : module
        One of `slowflow_kernels`, or one that `slowflow derive` wrote.

    Returns
    -------
    str
        The content of a file named after the module, as `rod_spring.m`, for MATLAB and GNU Octave. Functions take
        numbers or arrays that expand to one size: `[h, h_A] = rod_spring.averaged(A, alpha, beta, gamma, u_cr)`. Those
        that combine a force with the slow flow call the class in `slow_flow.m`. Kernels on intervals, kernels by
        quadrature and kernels that exist in C alone are left out; the file lists them.
    """
    tree = ast.parse(inspect.getsource(module))
    kernels = [one for one in tree.body if isinstance(one, ast.FunctionDef)]
    writer = _Writer(module.__name__.rpartition(".")[2], vars(module), {one.name: _count(one) for one in kernels})
    methods = [method for one in kernels if (method := writer.method(one))]
    for one in tree.body:
        if isinstance(one, ast.Assign) and (table := ast.unparse(one.targets[0])).startswith("_NODES"):
            rows = ast.unparse(one.value).replace("), (", "; ").strip("()")
            methods.append(f"function rows = {table[1:]}()\n    rows = [{rows}];\nend\n")
    methods.append(SHARED.replace("NAME", writer.name))
    about = [(ast.get_docstring(tree) or "").partition("\n\n")[0], WRITTEN]
    left_out = [one.name for one in kernels if one.name in module.__all__ and one.name not in writer.written]
    if left_out := [*left_out, *getattr(module, "FROM_C", ())]:
        about.append(f"Without kernels on intervals, by quadrature or in C alone: {', '.join(left_out)}.")
    lines = [f"    % {line}" for text in about for line in textwrap.wrap(text, 110)]
    body = textwrap.indent("\n".join(methods), " " * 8)
    return "\n".join([f"classdef {writer.name}", *lines, "    methods (Static)", f"{body}    end", "end", ""])


def _prototypes(paths: Iterable[Path]) -> list[Prototype]:
    found = []
    for path in map(Path, paths):
        text = path.read_text(encoding="utf-8")
        for name in re.findall(r'#include "(\w+_generic\.h)"', text):
            shared = (path.parent / name).read_text(encoding="utf-8")
            text += re.sub(r"^KERNEL (\w+) OF\((\w+)\)", rf"SF_KERNEL \1 {path.stem}_\2", shared, flags=re.MULTILINE)
        for kind, name, taken in re.findall(
            r"^SF_(?:KERNEL|TWOFOLD) (double|REAL|void) (\w+)\(([^)]*)\) \{$", text, re.MULTILINE
        ):
            arguments = tuple(re.findall(r"(\w+)(?:,|$)", taken))
            found.append(Prototype(name, kind != "void", arguments))
    return found


def _in_one_case(names: Sequence[str]) -> dict[str, str]:
    """A name for each that differs from the others not in case only."""
    found: dict[str, str] = {}
    for name in sorted(names, reverse=True):  # a capital comes last
        found[name] = name + "_upper" * any(name.lower() == other.lower() for other in found)
    return {name: found[name] for name in names}


def _continued(line: str, indent: int) -> list[str]:
    """A statement of Fortran on lines of at most 100 characters."""
    return " &\n".join(textwrap.wrap(line, 96, initial_indent=" " * indent, subsequent_indent=" " * 8)).split("\n")


class _LeftOut(Exception):
    """A kernel has what MATLAB has not."""


class _Writer(ast.NodeTransformer):
    """Methods of a MATLAB class from a module's functions, one after another.

    name   -- of the class
    values -- what the module's names stand for
    counts -- how many values its functions return
    """

    def __init__(self, name: str, values: Mapping[str, Any], counts: Mapping[str, int]) -> None:
        self.name, self.values, self.counts = name, values, counts
        self.written: set[str] = set()

    def method(self, kernel: ast.FunctionDef) -> str:
        """The text, "" for a kernel that is left out."""
        outputs = [f"out_{k}" for k in range(1, self.counts[kernel.name] + 1)]
        self.bodies: list[str] = []
        taken = ", ".join(_name(one.arg) for one in kernel.args.args)
        try:
            lines = [line for one in kernel.body for line in self.statement(one, outputs, taken)]
        except _LeftOut:
            return ""
        self.written.add(kernel.name)
        head = f"function {_assigned(outputs)}{kernel.name.lstrip('_')}({taken})"
        return "\n".join([head, *("    " + line for line in lines), "end", ""])

    def statement(self, one: ast.stmt, outputs: Sequence[str], taken: str) -> list[str]:
        """Its lines."""
        match one:
            case ast.Expr(ast.Constant(str(text))):
                return [f"% {line}".rstrip() for line in inspect.cleandoc(text).splitlines()]
            case ast.Assign(value=ast.Call(ast.Name("floats"))):
                return []
            case ast.Assign([ast.Name("bodies")], ast.Tuple(bodies)):
                self.bodies = [
                    f"@(varargin) {self.name}.{ast.unparse(one).lstrip('_')}(varargin{{:}})" for one in bodies
                ]
                return []
            case ast.Assign([ast.Tuple(names)], ast.Tuple(values)):
                return [f"{_assigned(map(self.text, names))}deal({', '.join(map(self.text, values))});"]
            case ast.Assign([ast.Tuple(names)], value):
                return [f"{_assigned(map(self.text, names))}{self.text(value)};"]
            case ast.Assign([ast.Name(name)], ast.Call(ast.Name(called)) as value) if self.counts.get(called, 1) > 1:
                # its elements are called by number
                return [f"{_assigned([f'{name}_{k}' for k in range(self.counts[called])])}{self.text(value)};"]
            case ast.Assign(names, value):
                return [f"{self.text(name)} = {self.text(value)};" for name in names]
            case ast.For(ast.Tuple(names), table, body):
                each = [f"    {self.text(name)} = row({k});" for k, name in enumerate(names, start=1)]
                inner = [f"    {line}" for one in body for line in self.statement(one, outputs, taken)]
                return [f"for row = {self.name}.{ast.unparse(table)[1:]}().'", *each, *inner, "end"]
            case ast.For(ast.Name("_"), ast.Call(ast.Name("range"), [ast.Name(count)]), body):
                inner = [f"    {line}" for one in body for line in self.statement(one, outputs, taken)]
                return [f"for turn = 1:{count}", *inner, "end"]
            case ast.Return(ast.Tuple(values)):
                return [f"{name} = {self.text(value)};" for name, value in zip(outputs, values, strict=True)]
            case ast.Return(ast.Subscript(ast.Call() as value, ast.Constant(int(k)))):
                return [f"{_assigned(['~'] * k + list(outputs))}{self.text(value)};"]
            case ast.Return(ast.Call(ast.Name("by_regime" | "number_by_regime"), [ast.Tuple(guards), *_])):
                whole = f"{{{', '.join(map(self.text, guards))}}}, {{{', '.join(self.bodies)}}}"
                return [f"{_assigned(outputs)}{self.name}.by_regime({whole}, {taken});"]
            case ast.Return(ast.expr() as value):
                return [f"{_assigned(outputs)}{self.text(value)};"]
        raise _LeftOut

    def text(self, expression: ast.expr) -> str:
        """An expression: MATLAB writes Python's, but for products and quotients of elements and names of functions."""
        text = ast.unparse(self.visit(expression))
        return re.sub(r" ([*/]) ", r" .\1 ", text)

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return ast.Name("~" if node.id == "_" else _name(node.id))

    def visit_Attribute(self, node: ast.Attribute) -> ast.expr:
        """What NumPy, or the slow flow's module, calls so."""
        match node:
            case ast.Attribute(ast.Name("np"), "sqrt"):
                return ast.Name(f"{self.name}.root")
            case ast.Attribute(ast.Name("np"), name):
                return ast.Name(re.sub("^arc", "a", name))
            case ast.Attribute(ast.Name("flow"), name):
                return ast.Name(f"{self.values['flow'].__name__.rpartition('.')[2]}.{name}")
        raise _LeftOut

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
        match node:
            case ast.Subscript(ast.Name(name), ast.Constant(int(k))):
                return ast.Name(f"{name}_{k}")
        raise _LeftOut

    def visit_Call(self, node: ast.Call) -> ast.expr:
        match node:
            case ast.Call(ast.Attribute(ast.Name("np"), "cbrt"), [value]):
                return ast.Call(ast.Name("nthroot"), [self.visit(value), ast.Constant(3)], [])
            case ast.Call(ast.Name("full"), [value, ast.Call(ast.Name("common_shape"), [arguments])]):
                node = ast.Call(ast.Name("broadcast_outputs"), [arguments, value], [])
        match node:
            case ast.Call(ast.Name("broadcast_outputs" | "stacked" as name), [ast.Tuple(shaped_by), *values]):
                # cells look like Python's sets
                taken = [ast.Set([*map(self.visit, shaped_by)]), *map(self.visit, values)]
                return ast.Call(ast.Name(f"{self.name}.{name}"), taken, [])
            case ast.Call(ast.Name(name)) if name in self.written:
                return ast.Call(ast.Name(f"{self.name}.{name.lstrip('_')}"), [*map(self.visit, node.args)], [])
            case ast.Call(ast.Attribute()):
                return ast.Call(self.visit(node.func), [*map(self.visit, node.args)], [])
        raise _LeftOut


def _count(kernel: ast.FunctionDef) -> int:
    """How many values it returns: as its annotation has it, or of what is private its last line."""
    if isinstance(kernel.returns, ast.Subscript):
        return ast.unparse(kernel.returns).count("Any")
    match kernel:
        case ast.FunctionDef(returns=None, body=[*_, ast.Return(ast.Tuple(values))]):
            return len(values)
    return 1


def _name(name: str) -> str:
    return name + "_" * (name in KEYWORDS)


def _assigned(names: Iterable[str]) -> str:
    """What stands before values in MATLAB."""
    listed = ", ".join(names)
    return f"[{listed}] = " if listed else ""
