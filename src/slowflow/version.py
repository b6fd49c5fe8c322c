"""Which slowflow this is, and where its C headers lie."""

from pathlib import Path

import slowflow_kernels

__version__ = "0.1.0"


def include() -> list[Path]:
    """The folders of the C headers: the solvers' own, and the generated ones, which they include.

    For a compiler's `-I`, as `numpy.get_include()`.
    """
    kernels = Path(slowflow_kernels.__file__).parent
    # of an installed package, or beside it in a checkout
    generated = kernels if (kernels / "c").is_dir() else kernels.parent
    return [Path(__file__).parent / "native", generated / "c", generated / "native"]
