"""The generated C headers as Python functions: a folder for the shared library in, callables out."""

from __future__ import annotations

import ctypes
import importlib
import re
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from slowflow_kernels import MODULES
from tests.native.compiler import COMPILER, FLAGS, GENERATED, NATIVE, ROOT, WARNINGS, compiled, pointer

HEADERS = GENERATED / "c"
PROTOTYPE = re.compile(r"^(?:SF_KERNEL|SF_TWOFOLD) (double|void) (\w+)\(([^)]*)\)", re.MULTILINE)
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
WORD = re.compile(r"\b[A-Za-z_]\w*\b")
#: of the kernels with one regime each, in the lists that loops are made by
LISTED = re.compile(r"\bNUMBERS?\(of, (\w+),")
#: names that a macro of the solvers puts together begin so
PASTED = re.compile(r"\b(\w+)##")
WIDEST = 128
LIBRARY = "kernels.so"


def expanded(header: Path, declared: str = "SF_KERNEL", number: str = "double") -> str:
    """The text of a generated header, with what it includes of functions on numbers of any kind as it has them."""
    text = header.read_text(encoding="utf-8")
    for name in re.findall(r'#include "(\w+_generic\.h)"', text):
        shared = next(path for path in (header.with_name(name), *GENERATED.glob(f"*/{name}")) if path.exists())
        own = re.sub(r"\bOF\((\w+)\)", rf"{header.stem}_\1", shared.read_text(encoding="utf-8"))
        text += re.sub(r"\bREAL\b", number, re.sub(r"^KERNEL\b", declared, own, flags=re.MULTILINE))
    return text


def prototypes(folder: Path = HEADERS) -> dict[str, tuple[str, list[str]]]:
    """Return type and arguments of every function with a symbol, by name."""
    found = {}
    for header in sorted(folder.glob("*.h")):
        for kind, name, arguments in PROTOTYPE.findall(expanded(header)):
            found[name] = (kind, [argument.strip() for argument in arguments.split(",")])
    return found


def from_c() -> set[str]:
    """The functions that Python has no text of."""
    modules = {name: importlib.import_module(f"slowflow_kernels.{name}") for name in MODULES}
    return {f"{name}_{kernel}" for name, module in modules.items() for kernel in getattr(module, "FROM_C", ())}


def called() -> set[str]:
    """Those of these functions that the solvers, the explorer or loops over arrays call, by themselves or by others.

    Loops over what only the solvers call do not count.
    """
    bodies: dict[str, set[str]] = {}
    for header in sorted(HEADERS.glob("*.h")):
        text = COMMENT.sub("", expanded(header))
        starts = [*PROTOTYPE.finditer(text)]
        for one, following in zip(starts, [*(start.start() for start in starts[1:]), len(text)], strict=False):
            bodies[one[2]] = set(WORD.findall(text[one.end() : following]))
    folders = (NATIVE, ROOT / "explorer", GENERATED / "native")
    loops = [*(GENERATED / "native").glob("*.c")]
    paths = {path for folder in folders for path in folder.rglob("*.[ch]")}.difference(loops)
    texts = [COMMENT.sub("", path.read_text()) for path in paths]
    found = {word for text in texts for word in WORD.findall(text)}
    looped = {path.stem: path.read_text() for path in loops}
    listed = {f"{module}_{name}" for module, text in looped.items() for name in LISTED.findall(text)}
    found |= {word for text in looped.values() for word in WORD.findall(text)}.union(listed).difference(from_c())
    pasted = {prefix for text in texts for prefix in PASTED.findall(text)}
    left = [name for name in bodies if name in found or any(map(name.startswith, pasted))]
    reached: set[str] = set()
    while left:
        name = left.pop()
        if name not in reached:
            reached.add(name)
            left += bodies[name] & bodies.keys()
    return reached


def build(directory: Path, folder: Path = HEADERS) -> None:
    """A library of a folder's `exported.c`: a symbol for every function of the headers."""
    options = [*WARNINGS, *FLAGS, f"-I{folder}"]
    compiled(directory / LIBRARY, folder / "exported.c", options=options, compiler=COMPILER)


def load(directory: Path, folder: Path = HEADERS) -> Callable[..., np.ndarray]:
    """The library in a directory: a function of a name, the arguments in one sequence, and how many come out."""
    library, known = ctypes.CDLL(str(directory / LIBRARY)), prototypes(folder)

    def call(name: str, arguments: Sequence[float], width: int) -> np.ndarray:
        kind, declared = known[name]
        values, out = np.array([*arguments, 0.0]), np.full(WIDEST, np.nan)
        numbers = sum(one.startswith("double ") and "*" not in one for one in declared)
        outputs = iter(range(WIDEST))
        operands = [ctypes.c_double(value) for value in values[:numbers]]
        operands += [
            pointer(values[numbers:]) if one == "const double *p" else pointer(out[next(outputs) :])
            for one in declared[numbers:]
        ]
        function = getattr(library, name)
        function.restype = ctypes.c_double if kind == "double" else None
        found = function(*operands)
        if kind == "double":
            out[0] = found
        assert np.isnan(out[width:]).all()
        return out[:width]

    return call
