"""The generated C headers as Python functions: a folder for the shared library in, callables out.

Every function of `generated/c` gets a wrapper `void wrap_NAME(const double *in, double *out)`.
"""

from __future__ import annotations

import ctypes
import importlib
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np

from slowflow_kernels import MODULES
from tests.native.compiler import COMPILER, FLAGS, GENERATED, INCLUDES, NATIVE, ROOT, WARNINGS, compiled, pointer

HEADERS = GENERATED / "c"
PROTOTYPE = re.compile(r"^(?:static inline|SF_KERNEL|SF_TWOFOLD) (double|void) (\w+)\(([^)]*)\)", re.MULTILINE)
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
WORD = re.compile(r"\b[A-Za-z_]\w*\b")
#: of the kernels with one regime each, in the lists that loops are made by
LISTED = re.compile(r"\bNUMBERS?\(of, (\w+),")
#: names that a macro of the solvers puts together begin so
PASTED = re.compile(r"\b(\w+)##")
WIDEST = 128
LIBRARY = "kernels.so"


def prototypes() -> dict[str, tuple[str, list[str]]]:
    """Return type and arguments of every function, by name."""
    found = {}
    for header in sorted(HEADERS.glob("*.h")):
        for kind, name, arguments in PROTOTYPE.findall(header.read_text()):
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
        text = COMMENT.sub("", header.read_text())
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


def compile_alone(header: Path, directory: Path) -> str:
    """What the compiler says about a header by itself."""
    source = directory / "alone.c"
    source.write_text(f'#include "{header.name}"\nint main(void) {{ return 0; }}\n')
    command = [COMPILER, *WARNINGS, *INCLUDES, "-c", str(source), "-o", str(directory / "alone.o")]
    return subprocess.run(command, capture_output=True, text=True).stderr


def build(directory: Path) -> None:
    """Compile all headers together, with all warnings as errors, into a library in a folder."""
    includes = [f'#include "{header.name}"' for header in sorted(HEADERS.glob("*.h"))]
    wrappers = []
    for name, (kind, arguments) in prototypes().items():
        call, used, outputs = [], 0, 0
        for argument in arguments:
            if argument.startswith("double *"):
                call.append(f"out + {outputs}")
                outputs += 1
            elif argument == "const double *p":
                call.append(f"in + {used}")
            else:
                call.append(f"in[{used}]")
                used += 1
        value = f"{name}({', '.join(call)})"
        body = f"*out = {value};" if kind == "double" else f"(void)out; {value};"
        wrappers.append(
            f"void wrap_{name}(const double *in, double *out);\n"
            f"void wrap_{name}(const double *in, double *out) {{ (void)in; {body} }}"
        )
    source, library = directory / "kernels.c", directory / LIBRARY
    source.write_text("\n".join([*includes, *wrappers]) + "\n")
    compiled(library, source, options=[*WARNINGS, *FLAGS], compiler=COMPILER)


def load(directory: Path) -> Callable[..., np.ndarray]:
    """The library in a folder: a function that takes a name, the arguments in one sequence, and how many come out."""
    loaded = ctypes.CDLL(str(directory / LIBRARY))

    def call(name: str, arguments: list[float], width: int) -> np.ndarray:
        values, out = np.array([*arguments, 0.0]), np.full(WIDEST, np.nan)
        getattr(loaded, f"wrap_{name}")(pointer(values), pointer(out))
        assert np.isnan(out[width:]).all()
        return out[:width]

    return call
