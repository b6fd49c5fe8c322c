"""The tests. NumPy's OpenBLAS rounds as the processor that it finds: where there is AVX2, by those instructions."""

import os
from pathlib import Path

CPU = Path("/proc/cpuinfo")
if CPU.exists() and " avx2 " in CPU.read_text(encoding="utf-8"):
    os.environ.setdefault("OPENBLAS_CORETYPE", "Haswell")  # read once, when NumPy is imported
