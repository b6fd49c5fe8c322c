"""The compiled part of the package. Takes the C sources; returns extension modules, and README.md for an index.

All else says pyproject.toml.

What is built is compiled, or the build fails. On Linux without a C compiler, and without CC in the environment, it is
compiled by that of `ziglang`, from PyPI: an isolated build takes it, the Makefile installs it. SLOWFLOW_COMPILE=later
leaves compiling to another command, as the Makefile does. The C is committed: building it needs NumPy's headers and
nothing that derives or renders.

To the solver's extension a further source is added by putting it into src/slowflow/native/solver/.
"""

import os
import re
import shlex
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from importlib.util import find_spec
from itertools import chain, repeat
from pathlib import Path

import numpy as np
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.errors import BaseError, CompileError, LinkError

#: address of the repository, "https://host/owner/slowflow": every URL of the metadata follows from it, and the links of
#: README.md on the page of an index. None until it has one; CITATION.cff needs it as repository-code then.
SOURCE = None

NATIVE = Path("src/slowflow/native")
GENERATED = Path("generated")
HEADERS = sorted(str(path) for folder in (NATIVE, GENERATED) for path in folder.rglob("*.h"))
LATER = os.environ.get("SLOWFLOW_COMPILE") == "later"
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
#: it compiles for this very processor if nothing else is said, and has sanitizers on
OF_ZIG = ["-fno-sanitize=undefined", "-w"]


def compiles(command):
    """Whether a command compiles anything at all: it may be absent, or a placeholder that asks to be installed."""
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder, "empty.c")
        source.write_text("int slowflow_empty;\n", encoding="utf-8")
        try:
            done = subprocess.run([*command, "-c", str(source), "-o", f"{source}.o"], capture_output=True, check=False)
        except OSError:
            return False
    return done.returncode == 0


def lacks_compiler():
    """Whether a build has to take one from PyPI: where CC says which one it is to be, that is it."""
    if LATER or sys.platform != "linux" or "CC" in os.environ:
        return False
    return not compiles(shlex.split(sysconfig.get_config_var("CC") or "cc"))


LACKS_COMPILER = lacks_compiler()
FROM_PYPI = LACKS_COMPILER and find_spec("ziglang") is not None
if FROM_PYPI:
    ZIG = f"{shlex.quote(sys.executable)} -m ziglang cc"
    print("slowflow: no C compiler works here; compiled by ziglang, from PyPI.", file=sys.stderr)
    os.environ.update(CC=ZIG, LDSHARED=f"{ZIG} -shared")


class Build(build_ext):
    """Compiler flags by compiler; extensions, and the sources of each, at the same time."""

    def finalize_options(self):
        # here, as an editable install forgets what `options` says of this command
        self.parallel = self.parallel or os.cpu_count()
        super().finalize_options()

    def run(self):
        # before the base class, which builds in place as if it did not
        self.in_checkout = self.inplace or self.editable_mode
        if self.in_checkout:
            # what an earlier build left would be imported in place of what this one cannot make
            for path in chain(Path("src").rglob("_*"), GENERATED.rglob("_*")):
                if path.suffix in (".so", ".pyd"):
                    path.unlink()
        try:
            super().run()
        except (BaseError, CompileError, LinkError, OSError) as error:
            raise SystemExit(
                f"slowflow: the extension modules could not be compiled ({error}), see above. This needs a C compiler "
                "and the headers of Python (on Debian: apt install gcc python3-dev; a compiler is in PyPI's ziglang "
                "too, pip install ziglang)."
            ) from error

    def build_extensions(self):
        own = [*FLAGS.get(self.compiler.compiler_type, []), *(OF_ZIG if FROM_PYPI else [])]
        if FROM_PYPI and not self.in_checkout:
            own.append("-mcpu=baseline")
        for extension in self.extensions:
            # the user's have the last word
            extension.extra_compile_args = [*own, *CFLAGS]
        if self.in_checkout and (target := self.target_here()):
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
        macros = dict(line.split(" ", 2)[1:] for line in done.stdout.splitlines())
        if "__x86_64__" not in macros or "__clang__" in macros or int(macros.get("__GNUC__", 0)) < 12:
            return None
        return next((target for target, features in TARGETS.items() if features <= macros.keys()), None)


def extension(name, sources):
    """An extension module over C sources."""
    return Extension(
        name,
        sorted(str(path) for path in sources),
        include_dirs=[str(NATIVE), str(GENERATED / "c"), str(GENERATED / "native"), np.get_include()],
        depends=HEADERS,
        define_macros=[("Py_LIMITED_API", "0x030B0000")] if STABLE_ABI else [],
        py_limited_api=STABLE_ABI,
    )


def readme(text, address=None):
    """README.md for the page of a package index, where a path leads nowhere.

    address -- of the sources on the web: paths are looked up there. Without one a picture is left out with its caption,
               and of a link its words stay.
    """

    def place(match):
        picture, label, path, caption = match.groups()
        if address is None:
            return "" if picture else label + caption
        return f"{picture}[{label}]({address}/{'raw' if picture else 'blob'}/HEAD/{path}){caption}"

    picture = r"(!)\[([^]]*)\]\((?!\w+:)([^)]+)\)((?:\n+\*[^*]+\*)?\n+)"
    link = r"()\[([^]]*)\]\((?!\w+:)([^)]+)\)()"
    return re.sub(link, place, re.sub(picture, place, text))


def urls(address=None):
    """The project's pages on the web, as the metadata names them; the paper alone where the sources have no address."""
    pages = {
        "Source": "",
        "Documentation": "/blob/HEAD/docs/index.md",
        "Issues": "/issues",
        "Changelog": "/blob/HEAD/CHANGELOG.md",
    }
    own = {name: address + page for name, page in pages.items()} if address else {}
    return own | {"Paper": "https://doi.org/10.3390/app15084187"}


with open("pyproject.toml", "rb") as stated:
    PROJECT = tomllib.load(stated)["project"]

setup(
    long_description=readme(Path("README.md").read_text(encoding="utf-8"), SOURCE),
    long_description_content_type="text/markdown",
    project_urls=urls(SOURCE),
    ext_modules=[]
    if LATER
    else [
        extension("slowflow_kernels._native", [NATIVE / "kernels.c", *(GENERATED / "native").glob("*.c")]),
        extension("slowflow._native", (NATIVE / "solver").glob("*.c")),
        extension("slowflow._exact", (NATIVE / "exact").glob("*.c")),
    ],
    # which pip installs beside those of pyproject.toml
    setup_requires=PROJECT["optional-dependencies"]["explorer"] if LACKS_COMPILER and not FROM_PYPI else [],
    cmdclass={"build_ext": Build},
    options={"bdist_wheel": {"py_limited_api": "cp311"}} if STABLE_ABI else {},
)
