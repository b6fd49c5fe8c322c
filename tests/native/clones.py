"""The compiled loops for one processor target each: a directory in, a callable that runs a kernel out.

The extension module holds all clones of a loop and chooses by processor; here each target is a library of its own.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from tests.native.compiler import FLAGS, GENERATED, NATIVE, compiled


class Kernel(ctypes.Structure):
    """sf_kernel"""

    _fields_ = (
        ("name", ctypes.c_char_p),
        ("inputs", ctypes.c_int),
        ("outputs", ctypes.c_int),
        ("regimes", ctypes.c_int),
        ("choose", ctypes.c_void_p),
        ("loops", ctypes.c_void_p),
    )


class Module(ctypes.Structure):
    """sf_module"""

    _fields_ = (("name", ctypes.c_char_p), ("kernels", ctypes.POINTER(Kernel)), ("count", ctypes.c_int))


def build(directory: Path, target: str, module: str = "rod_spring") -> Callable[[str, Sequence], tuple]:
    """Compile a module's loops for one target; the function returned takes a kernel's name and its arguments."""
    library = directory / f"{module}_{target}.so"
    sources = NATIVE / "kernels.c", GENERATED / "native" / f"{module}.c"
    # as in setup.py, but for visibility
    options = ["-std=c11", *FLAGS, "-DSF_NO_CLONES", f"-march={target}"]
    loaded = ctypes.CDLL(str(compiled(library, *sources, options=options)))
    table = Module.in_dll(loaded, f"sf_module_{module}")
    kernels = {table.kernels[k].name.decode(): table.kernels[k] for k in range(table.count)}

    def run(name: str, arguments: Sequence) -> tuple:
        kernel = kernels[name]
        arrays = np.broadcast_arrays(*(np.asarray(argument, dtype=float) for argument in arguments))
        results = [np.full(arrays[0].shape, np.nan) for _ in range(kernel.outputs)]
        operands = [*arrays, *results]
        addresses = (ctypes.c_void_p * len(operands))(*(array.ctypes.data for array in operands))
        strides = (ctypes.c_ssize_t * len(operands))(*(array.strides[0] for array in operands))
        loaded.sf_run(addresses, (ctypes.c_ssize_t * 1)(arrays[0].size), strides, ctypes.byref(kernel))
        return tuple(results)

    run.names = {name: kernel.inputs for name, kernel in kernels.items()}
    return run
