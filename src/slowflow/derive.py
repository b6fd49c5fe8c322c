"""Custom spring models (mechanisms), derived at run time from the pieces of a force.

This needs the extra `slowflow[derive]`. The derivation, which is installed as `slowflow.derivation`, is imported by the
first call.

    import sympy as sp
    from slowflow import derive

    u, k_2, gap = sp.symbols("u k_2 gap")
    stop = derive.mechanism("stop", [(u, gap), (u + k_2 * (u - gap), None)], {"k_2": {"above": 0}, "gap": {"above": 0}})
    stop(k_2=12.0, gap=0.2, mu=0.01, zeta=0.02).saddle_nodes(0.3)
"""

from __future__ import annotations

import contextlib
import ctypes
import functools
import gc
import hashlib
import importlib
import inspect
import os
import shlex
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

from slowflow import sampled
from slowflow.answers import files
from slowflow.core import backend
from slowflow.core.mechanism import Mechanism, Parameter
from slowflow.core.model import THROUGHOUT
from slowflow.oscillators.oscillator import Oscillator
from slowflow.support.errors import BuildFailed, Refused, WrongType
from slowflow.support.ownership import check_own
from slowflow.version import include

__all__ = ["Derived", "Sampled", "Stated", "library", "mechanism"]

NEEDED = "deriving needs SymPy, python-flint, Jinja2 and platformdirs: pip install 'slowflow[derive]'"
#: IEEE arithmetic, as the package itself is compiled; -O3 takes a third longer, and answers are no sooner there
FLAGS = ("-std=c11", "-O2", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off", "-fPIC")
#: names of records whose libraries are attached
_attached: set[str] = set()
#: the source that is written after the others, and is there where they are
LAST_OF_C = "_motion.c"


class Stated:
    """A user-defined mechanism: calling it with parameters makes an oscillator, `many` a batch."""

    #: the same record as a generated module's `MECHANISM`
    record: Mechanism

    def __init__(self, record: Mechanism) -> None:
        self.record = record

    def __call__(self, *, excitation: str = "force", contact: str = THROUGHOUT, **numbers: float) -> Oscillator:
        """Make an oscillator from its parameters, damping included, as `Oscillator(record, ...)` does."""
        return Oscillator(self.record, excitation=excitation, contact=contact, **numbers)

    def many(self, *, excitation: str = "force", contact: str = THROUGHOUT, **numbers: Any) -> Any:
        """Make a batch of designs, as `Oscillator.many(record, ...)` does."""
        return Oscillator.many(self.record, excitation=excitation, contact=contact, **numbers)

    def _described(self, how: str) -> str:
        return f"{self.record.title}: {', '.join((*self.record.design_names, 'mu', 'zeta'))}; {how}"


class Sampled(Stated):
    """A mechanism whose force is given by Python functions, sampled instead of derived.

    Averages and exact motions use the polynomials that interpolate the samples.
    """

    def __repr__(self) -> str:
        return self._described("a Python function: by its values")


class Derived(Stated):
    """A derived mechanism: calling it with parameters makes an oscillator, `many` a batch."""

    #: where its sources are, and what was compiled of them
    folder: Path

    def __init__(self, record: Mechanism, folder: Path, stated: Any, remark: str = "") -> None:
        super().__init__(record)
        self.folder = folder
        self._stated, self._remark = stated, remark

    @property
    def stated_name(self) -> str:
        """The name in the call; the record's name includes a hash of everything it depends on."""
        return self._stated.name

    @property
    def compiled(self) -> bool:
        """Whether compiled code is used for this force; otherwise its programs are interpreted, with the same bits."""
        return self.record.name in _attached

    def document(self) -> str:
        """Describe the derivation: equation of motion, slow flow, average in each regime, response, folds.

        Returns
        -------
        str
            Markdown with LaTeX.
        """
        return _derivation().description(self._stated).markdown()

    def write(self, folder: Path) -> list[str]:
        """Write the kernels, as `make derive` does, and the derivation in Markdown and LaTeX.

        The files are a Python module of NumPy kernels (averages by quadrature are computed by slowflow's compiled code
        from a program in the folder); C headers, which include those of `include()`; C sources with the record that the
        solvers take and with the force as power series; for an odd force also the program that the solvers interpret
        and `exported.c`, which exports the functions; derivation.md and derivation.tex; MANIFEST.json with a hash of
        each file. Files of an earlier run are replaced.

        Parameters
        ----------
        folder : path_like
            Output folder; it is created if it does not exist.

        Returns
        -------
        list of str
            The files' names.
        """
        return _derivation().written(self._stated, Path(folder))

    def __repr__(self) -> str:
        how = "compiled" if self.compiled else "interpreted"
        if hasattr(sys.modules[self.record.pieces[0].force.__module__], "over_quarter"):
            how += ", by quadrature"
        if not self.record.odd:
            how = f"motions {'compiled' if self.compiled else 'interpreted'}, averages on NumPy"
        return self._described(how + self._remark)


def mechanism(
    name: str,
    pieces: Sequence[tuple[Any, Any]],
    parameters: Mapping[str, Mapping[str, Any]],
    *,
    title: str = "",
    reach: float | None = None,
    reach_reason: str = "",
    odd: bool = True,
    compile: bool = False,
) -> Stated:
    """Derive a mechanism from its restoring force f(u), dimensionless, in one or two seconds; results are cached.

    Polynomials are averaged in closed form; fractional powers and elementary functions by quadrature.

    Parameters
    ----------
    name : str
        Name of the module.
    pieces : sequence of tuple
        In ascending order of |u|: the force for u > 0, an expression in the SymPy symbol u and the parameters, and the
        |u| at which the piece ends, None for the last one. A constant in the first piece is a preload. The force is
        f(|u|) sign(u); printing the mechanism shows whether the expression itself is odd. Or all pieces are Python
        functions, called as f(u, **parameters) with a number or an array u; each ends at a number or at a function of
        the parameters. They require `reach`, must be smooth between their ends, and the first one must be odd. See
        `Sampled`.
    parameters : mapping
        For each parameter name a mapping with any of "doc", "unit" and the bounds "above", "least", "below", "most".
    title : str
        Title for documents and printing.
    reach, reach_reason : float and str, optional
        The largest |u| for which the force is valid, and the reason; by default unlimited.
    odd : bool
        Whether the force is odd; otherwise its pieces cover all u in ascending order, each with the u, of either sign,
        at which it ends; they are polynomials, or smooth up to their ends. Motions then have a mean B, see
        `Oscillator.off_centre`.
    compile : bool
        Generate C and call the C compiler (CC of the environment, or Python's own). Otherwise programs are interpreted,
        with the same bits; batches with polynomial forces then take up to four times as long.

    Returns
    -------
    Derived or Sampled
        `Sampled` for Python functions.

    Raises
    ------
    ValueError, TypeError
        For invalid arguments; the message states what is allowed.
    ArithmeticError, ImportError
        For a force that cannot be derived, with the reason; if the extra `slowflow[derive]` is missing.
    BuildFailed
        If the compiler fails, with its output, or if slowflow itself is not compiled.
    """
    furthest = () if reach is None else (reach, reach_reason or "the force is valid up to there only")
    inputs = _derivation("slowflow.derivation.given")
    functions = [_is_function(force) for force, _ in inputs.pieces(pieces)]
    if any(functions):
        if not all(functions):
            raise WrongType(
                f"piece {functions.index(False) + 1} is not a Python function: either all pieces are, or none"
            )
        return _sampled(name, pieces, parameters, title, reach, reach_reason, odd, compile)
    stated = _derivation().stated(name, pieces, parameters, title, *furthest, odd=odd)
    _check_names(stated.design)
    return _derived(stated, compile, _made_odd(inputs.expression("piece 1", pieces[0][0])) if odd else "")


def library(name: str, *, compile: bool = False) -> Derived:
    """Derive a mechanism of the library, such as `library("elastic_stop")`; docs/mechanisms.md shows them.

    Parameters
    ----------
    name : str
        A file of `slowflow.derivation.library`.
    compile : bool
        As in `mechanism`.

    Returns
    -------
    Derived
        Printing it lists its parameters.

    Raises
    ------
    ValueError
        For a name that is not in the library; otherwise as `mechanism`.
    """
    return _derived(_derivation("slowflow.derivation.library").stated(name), compile)


@functools.cache
def _taken() -> frozenset[str]:
    """Names that an oscillator has already: what it is made from, its parts, and its questions."""
    made_from = inspect.signature(Oscillator.__init__).parameters
    return frozenset((*made_from, *Oscillator.__annotations__, *dir(Oscillator), "model"))


def _check_names(design: Sequence[Any]) -> None:
    """Raises ValueError for a parameter that would hide something else of an oscillator."""
    for parameter in design:
        if parameter.symbol.name in _taken():
            raise Refused(
                f"parameter {parameter.symbol.name!r} is not allowed: an oscillator has an attribute of that name"
            )


def _is_function(force: Any) -> bool:
    """Whether a piece is a Python function; SymPy's symbols and functions can be called too."""
    return callable(force) and not hasattr(force, "free_symbols")


def _sampled(
    name: str,
    pieces: Sequence[tuple[Any, Any]],
    parameters: Mapping[str, Mapping[str, Any]],
    title: str,
    reach: Any,
    reach_reason: str,
    odd: bool,
    compile: bool,
) -> Sampled:
    """A mechanism whose pieces are Python functions, whose arguments are those of `mechanism`."""
    inputs, runtime = _derivation("slowflow.derivation.given"), _derivation()
    name, title = inputs.module_name(name), inputs.text("title", title)
    reach_reason = inputs.text("reach_reason", reach_reason)
    if inputs.flag("compile", compile):
        raise Refused("compile = True is not allowed: a Python function cannot be compiled, a SymPy expression can")
    if not inputs.flag("odd", odd):
        raise Refused("odd = False is not allowed: the pieces of an asymmetric force must be SymPy expressions")
    if reach is None:
        raise Refused("reach = None is not allowed: a Python function is sampled up to its reach")
    design = runtime.designed(inputs.parameters(parameters))
    _check_names(design)
    names = [parameter.symbol.name for parameter in design]
    functions, ends = [], []
    for number, (force, end) in enumerate(pieces, start=1):
        if (end is None) != (number == len(pieces)):
            message = "have no end, it is the last" if end is not None else "say where it ends"
            raise Refused(f"piece {number} must {message}")
        sampled.check_signature(f"piece {number}", force, names, 1)
        functions.append(force)
        if _is_function(end):
            sampled.check_signature(f"the end of piece {number}", end, names, 0)
            ends.append(end)
        elif end is not None:
            ends.append(float(inputs.exact(f"the end of piece {number}", end)))
    of_record = []
    for one in design:
        bounds = {key: float(bound) for key in inputs.BOUNDS if (bound := getattr(one, key)) is not None}
        of_record.append(Parameter(one.symbol.name, one.doc, one.unit, **bounds))
    stated = sampled.Stated(name, tuple(functions), tuple(ends), tuple(names), float(inputs.reach(reach)))
    titled = title or f"{name}, defined by Python functions"
    record = sampled.record(stated, titled[0].upper() + titled[1:], tuple(of_record), reach_reason)
    backend.check_room(record)
    return Sampled(record)


def _made_odd(force: Any) -> str:
    """That a first piece is not odd as it was written, and what stands for it; "" where it is."""
    u = next((symbol for symbol in force.free_symbols if symbol.name == "u"), None)
    preload, mirrored = (force, force) if u is None else (force.subs(u, 0), force.subs(u, -u))
    if (force + mirrored).expand() == 0:
        return ""
    shown = _derivation("slowflow.derivation.given").in_text
    jumps = f", a preload of {shown(preload)}" if preload != 0 else ""
    return f"; {shown(force)} is not odd: for u < 0 the force is that of |u| with the other sign{jumps}"


def _derived(stated: Any, compile: bool, remark: str = "") -> Derived:
    """Derived and printed, if it was not, and compiled on request."""
    if not isinstance(compile, bool):
        raise WrongType(f"compile = {compile!r} is not allowed: it must be True or False")
    runtime = _derivation()
    folder = _folder()
    module = runtime.name_of(stated)
    in_c, in_python = (not (folder / f"{module}{last}").exists() for last in (LAST_OF_C, ".py"))
    if in_python or (compile and in_c):
        with _uncollected():
            sources = runtime.sources(stated)
            if compile and in_c:
                _write(folder, sources.compiled)
            if in_python:
                _write(folder, sources.python)
    importlib.invalidate_caches()
    record: Mechanism = importlib.import_module(f"slowflow.derived.{module}").MECHANISM
    backend.check_room(record, interpreted=not compile)
    if compile and record.name not in _attached:
        _attach(record, _compiled(folder, module))
    return Derived(record, folder, stated, remark)


@contextlib.contextmanager
def _uncollected() -> Iterator[None]:
    """Without Python's search for cycles, which expressions are not in: it goes through all of them again and again."""
    was = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was:
            gc.enable()


def _derivation(module: str = "slowflow.derivation.runtime") -> ModuleType:
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise ImportError(f"{NEEDED} ({error})") from error


def _folder() -> Path:
    folder: Path = _derivation("slowflow.derived").FOLDER
    check_own(folder)
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    return folder


def _write(folder: Path, sources: Mapping[str, str]) -> None:
    """Each file under its name only when it is whole, in their order: the last one says that all are there."""
    for name, text in sources.items():
        files.write(folder / name, text)


def _compiled(folder: Path, module: str) -> Path:
    """The shared library of a mechanism, compiled if it is not there."""
    # one for each state of the headers: the record's form may change
    content = b"".join(path.read_bytes() for place in include() for path in sorted(place.rglob("*.h")))
    library = folder / f"{module}-{hashlib.sha256(content).hexdigest()[:12]}.so"
    if library.exists():
        return library
    compiler = shlex.split(os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc")
    headers = [f"-I{place}" for place in (folder, *include())]
    sources = [path for name in (f"{module}.c", f"{module}{LAST_OF_C}") if (path := folder / name).exists()]
    with tempfile.TemporaryDirectory(dir=folder) as place:
        objects = [f"{place}/{source.stem}.o" for source in sources]
        _side_by_side(
            [*compiler, *FLAGS, *headers, "-c", str(source), "-o", made]
            for source, made in zip(sources, objects, strict=True)
        )
        _side_by_side([[*compiler, "-shared", *objects, "-o", f"{place}/{library.name}", "-lm"]])
        os.replace(f"{place}/{library.name}", library)
    return library


def _side_by_side(commands: Iterable[list[str]]) -> None:
    """Calls of the compiler, each a process of its own. Raises BuildFailed where one fails, with its output."""
    running = {}
    for command in commands:
        try:
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        except OSError as error:
            raise BuildFailed(f"compile=True: the C compiler {command[0]!r} does not run: {error}") from error
        running[process] = command[0]
    outputs = {process: process.communicate()[1] for process in running}
    for process, output in outputs.items():
        if process.returncode:
            raise BuildFailed(f"compile=True: {running[process]} failed:\n{output}")


def _attach(record: Mechanism, library: Path) -> None:
    """Hands what is in a library to the compiled code, and never lets go of it.

    To the integrator the pieces of the force, to the solvers the record, which only an odd force has.
    """
    _attached.add(record.name)
    loaded = ctypes.CDLL(str(library))
    backend.EXACT.LAWS.update(backend.EXACT.laws(_capsule(loaded, "slowflow_laws", LAWS)))
    if record.odd:
        backend.SOLVER.RECORDS[record.name] = _capsule(loaded, "slowflow_record", CAPSULE)


def _capsule(loaded: ctypes.CDLL, name: str, kind: bytes) -> Any:
    """What a pointer of that name in a library points to, as extension modules take it."""
    new = ctypes.pythonapi.PyCapsule_New
    new.restype, new.argtypes = ctypes.py_object, (ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)
    return new(ctypes.c_void_p.in_dll(loaded, name).value, kind, None)


#: what capsules with a record and with pieces of a force are called, in mechanism.h and _exact.c; these names have to
#: outlive the capsules
CAPSULE, LAWS = b"slowflow.core.mechanism", b"slowflow._exact.laws"
