"""The compiled part of the package: in go the C sources, out come extension modules; and README.md for an index.

All else says pyproject.toml.

A checkout installs without a C compiler too (`pip install --editable`), and runs on NumPy. A wheel is compiled, or its
build fails; SLOWFLOW_PURE=1 asks for one that runs on NumPy, whose name says so. The C is committed: building it needs
NumPy's headers and nothing that derives or renders.

To the solver's extension a further source is added by putting it into src/slowflow/native/solver/.
"""

import os
import re
import shlex
import subprocess
import sysconfig
import tomllib
from concurrent.futures import ThreadPoolExecutor
from itertools import chain, repeat
from pathlib import Path

import numpy as np
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

NATIVE = Path("src/slowflow/native")
GENERATED = Path("generated")
HEADERS = sorted(str(path) for folder in (NATIVE, GENERATED) for path in folder.rglob("*.h"))
PURE = os.environ.get("SLOWFLOW_PURE") == "1"
# Without GIL there is no stable ABI yet.
STABLE_ABI = not sysconfig.get_config_var("Py_GIL_DISABLED")
# IEEE arithmetic: the same digits from every build; loops may vectorise past errno and traps. The ends of an interval
# in one register cost a third more time than apart.
STRICT = ["-std=c11", "-O3", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off", "-fno-tree-slp-vectorize"]
FLAGS = {
    "unix": [*STRICT, "-g0", "-fvisibility=hidden"],
    "mingw32": STRICT,
    "msvc": ["/std:c11", "/O2", "/fp:precise"],
}
# what the processor has of what the solvers and the loops are built for
FMA = {"__FMA__", "__AVX2__", "__BMI__", "__BMI2__", "__LZCNT__", "__F16C__", "__MOVBE__"}
TARGETS = {
    "x86-64-v4": FMA | {f"__AVX512{part}__" for part in ("F", "BW", "CD", "DQ", "VL")},
    "x86-64-v3": FMA,
}
CFLAGS = shlex.split(os.environ.get("CFLAGS", ""))


class Build(build_ext):
    """Compiler flags by compiler; extensions, and the sources of each, at the same time."""

    def finalize_options(self):
        # here, as an editable install forgets what `options` says of this command
        self.parallel = self.parallel or os.cpu_count()
        super().finalize_options()

    def run(self):
        # asked before, as setuptools builds a checkout as if it were none
        self.runs_here = self.inplace or self.editable_mode
        super().run()
        if self.runs_here:
            return
        missing = [one.name for one in self.extensions if not Path(self.get_ext_fullpath(one.name)).exists()]
        if missing:
            raise SystemExit(
                f"slowflow: {', '.join(missing)} could not be compiled, see above. This needs a C compiler and the "
                "headers of Python (on Debian: apt install gcc python3-dev). With SLOWFLOW_PURE=1 in the environment "
                "the package is built without: the same answers, slower."
            )

    def build_extensions(self):
        for extension in self.extensions:
            # the user's have the last word
            extension.extra_compile_args = [*FLAGS.get(self.compiler.compiler_type, []), *CFLAGS]
        if self.runs_here and (target := self.target_here()):
            for extension in self.extensions:
                extension.sources = [source for source in extension.sources if not source.endswith("_baseline.c")]
                extension.define_macros = [
                    *extension.define_macros,
                    ("SF_WITHOUT_BASELINE", "1"),
                    ("SF_HERE", f'"{target}"'),
                ]
        self.compiler.compile = self.in_parallel(self.compiler.compile)
        super().build_extensions()

    def in_parallel(self, compile):
        """The same `compile(sources, ...)` of the compiler, as many sources at a time as extensions."""

        def one(source, args, options):
            return compile([source], *args, **options)

        def compiled(sources, *args, **options):
            with ThreadPoolExecutor(self.parallel) as pool:
                # from the last on: solvers and shipped records take longest, and one begun late has nobody beside it
                made = pool.map(one, reversed(sources), repeat(args), repeat(options))
                return list(chain.from_iterable(made))

        return compiled

    def target_here(self):
        """The widest target that this machine takes: a checkout runs where it was built. None where it takes every one.

        gcc knows the names since its version 12.
        """
        command = [*getattr(self.compiler, "compiler", ["false"]), "-march=native", "-dM", "-E", "-x", "c", os.devnull]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        told = dict(line.split(" ", 2)[1:] for line in done.stdout.splitlines())
        if "__x86_64__" not in told or "__clang__" in told or int(told.get("__GNUC__", 0)) < 12:
            return None
        return next((target for target, features in TARGETS.items() if features <= told.keys()), None)


def extension(name, sources):
    """An optional extension module over C sources."""
    return Extension(
        name,
        sorted(str(path) for path in sources),
        include_dirs=[str(NATIVE), str(GENERATED / "c"), str(GENERATED / "native"), np.get_include()],
        depends=HEADERS,
        define_macros=[("Py_LIMITED_API", "0x030B0000")] if STABLE_ABI else [],
        py_limited_api=STABLE_ABI,
        optional=True,
    )


def readme(text, address=None):
    """README.md for the page of a package index, where a path leads nowhere.

    address -- of the sources on the web: paths are looked up there. Without one a picture is left out with its caption,
               and of a link its words stay.
    """

    def place(match):
        picture, words, path, caption = match.groups()
        if address is None:
            return "" if picture else words + caption
        return f"{picture}[{words}]({address}/{'raw' if picture else 'blob'}/HEAD/{path}){caption}"

    picture = r"(!)\[([^]]*)\]\((?!\w+:)([^)]+)\)((?:\n+\*[^*]+\*)?\n+)"
    link = r"()\[([^]]*)\]\((?!\w+:)([^)]+)\)()"
    return re.sub(link, place, re.sub(picture, place, text))


with open("pyproject.toml", "rb") as stated:
    SOURCE = tomllib.load(stated)["project"]["urls"].get("Source")

setup(
    long_description=readme(Path("README.md").read_text(encoding="utf-8"), SOURCE),
    long_description_content_type="text/markdown",
    ext_modules=[]
    if PURE
    else [
        extension("slowflow_kernels._native", [NATIVE / "kernels.c", *(GENERATED / "native").glob("*.c")]),
        extension("slowflow._native", (NATIVE / "solver").glob("*.c")),
        extension("slowflow._exact", (NATIVE / "exact").glob("*.c")),
    ],
    cmdclass={"build_ext": Build},
    options={"bdist_wheel": {"py_limited_api": "cp311"}} if STABLE_ABI and not PURE else {},
)
