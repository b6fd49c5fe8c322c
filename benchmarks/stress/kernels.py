"""Errors of every generated kernel, native and NumPy, at hard places: names in, the worst in u (1 + kappa) out.

Kernels are taken from the package as it is; one without a definition in `tests.oracles.kernels` is an error. The worst
points of the last search are tried again: a shorter search forgets none.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import json
import math
import sys
import warnings
import zlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from mpmath import mp, mpf

from benchmarks.stress import baseline, domains, search
from benchmarks.stress.search import Found, Point
from tests import backends
from tests.oracles import kernels as exact
from tests.oracles.definitions.points import shown

U = 2.0**-53
#: exact values at points of every kernel
STORED = Path(__file__).resolve().parents[2] / "tests" / "data" / "kernel_oracle.json"
LARGEST, SMALLEST = sys.float_info.max, sys.float_info.min
TARGET = 4.0
#: points kept of each kernel
KEPT = 2
#: definitions that leave tiny entries out
CHOPPED = {"jacobian", "stability"}
#: definitions that take a tenth of a second a point
SLOW = exact.BY_QUADRATURE | {"folds", "response", "amplitude", "smoothed_by_state", "discriminant", "critical"}


@functools.cache
def loaded() -> dict[str, dict[str, Any]]:
    """The kernels' modules by backend and name."""
    return {name: backends.load(name) for name in ("native", "numpy")}


@functools.cache
def named() -> dict[tuple[str, str], tuple[str, ...]]:
    """Every kernel by module and name, with its arguments' names; those of gradients are judged elsewhere."""
    found = {}
    for module, functions in loaded()["numpy"].items():
        for name in functions.__all__ if exact.knows(module) else ():
            function = getattr(functions, name)
            # what a scene has from another module is that one's
            own = getattr(function, "__module__", "").endswith(f".{module}")
            if own and hasattr(function, "__code__") and not exact.is_of_gradients(name):
                found[module, name] = tuple(inspect.signature(function).parameters)
    return found


def unsearched() -> dict[str, list[str]]:
    """The kernels of each module that have exact values at stored points alone."""
    found = {}
    for module, functions in loaded()["numpy"].items():
        if not exact.knows(module):
            own = ((name, getattr(functions, name)) for name in functions.__all__)
            found[module] = [name for name, f in own if getattr(f, "__module__", "").endswith(f".{module}")]
    return {module: names for module, names in found.items() if names}


def at_stored_points(module: str, kernel: str) -> float:
    """The largest error there, of each backend."""
    rows = json.loads(STORED.read_text(encoding="utf-8"))[module][kernel]
    errors = [0.0]
    for functions in loaded().values():
        for row in rows:
            values = np.ravel(np.array(getattr(functions[module], kernel)(*row["at"]), dtype=float))
            found = [
                measured(float(value), mpf(true), mpf(scale))
                for value, true, scale in zip(values, row["is"], row["scale"], strict=True)
            ]
            errors += [one for one in found if one is not None]
    return max(errors)


@functools.cache
def last_worst() -> dict[tuple[str, str], list[Point]]:
    """The worst points of the last search, by module and name."""
    found: dict[tuple[str, str], list[Point]] = {}
    for row in json.loads(baseline.OUT.read_text(encoding="utf-8"))["kernels"] if baseline.OUT.exists() else ():
        found.setdefault((row["module"], row["kernel"]), []).append(tuple(row["at"]))
    return found


@functools.cache
def designs() -> dict[str, Callable[..., Sequence[float]]]:
    """What makes the parameters of each mechanism from its design."""
    return {
        name: module.coefficients
        for name, module in loaded()["numpy"].items()
        if hasattr(module, "MECHANISM") and hasattr(module, "coefficients")
    }


def measured(value: float, true: Any, scale: Any) -> float | None:
    """|value - true| in units of u scale; None where the value is beyond the range of doubles or below it."""
    if mp.isinf(true):
        return 0.0 if value == true else math.inf
    if abs(true) > LARGEST:
        return None
    if scale == 0:
        return 0.0 if value == 0 else math.inf
    if scale < SMALLEST:
        return None
    if not math.isfinite(value):
        return math.inf
    return float(abs(mpf(value) - true) / (U * scale))


def error(
    module: str, kernel: str, names: Sequence[str], at: Sequence[float], backend: str
) -> tuple[float, float] | None:
    """The largest error of the outputs in u (1 + kappa), and 1 + kappa of that output; None outside the domain."""
    try:
        true, scales = exact.values(module, kernel, names, at)
    except (ArithmeticError, ValueError):
        return None
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            values = np.ravel(np.array(getattr(loaded()[backend][module], kernel)(*at), dtype=float))
        except ZeroDivisionError:
            values = np.full(len(true), np.nan)
    if len(values) != len(true):  # a resultant whose degree falls, or that has a factor more
        return None
    found = [(measured(float(v), t, s), t, s) for v, t, s in zip(values, true, scales, strict=True)]
    errors = [(e, float(s / abs(t)) if t else math.inf) for e, t, s in found if e is not None]
    return max(errors, default=None)


def stress(module: str, kernel: str, size: float, backend: str = "native") -> dict[str, Any]:
    """One kernel: drawn points, the search from the worst of them, and the extremes apart."""
    names = named()[module, kernel]
    rng = np.random.default_rng([7, zlib.crc32(f"{module}.{kernel}".encode())])
    slow = kernel in SLOW or module == "second_approximation"
    count, restarts, steps = (20, 2, 10) if slow else (60, 2, 30)

    def measure(at: Sequence[float]) -> tuple[float, float] | None:
        if not domains.inside(module, names, at):
            return None
        return error(module, kernel, names, at, backend)

    known = [at for at in last_worst().get((module, kernel), []) if len(at) == len(names)]
    seen = [Found(*value, at, "of the last search") for at in known if (value := measure(at)) is not None]
    for _ in range(max(10, int(count * size))):
        place, at = domains.point(module, names, designs(), rng)
        value = measure(at)
        if value is not None:
            seen.append(Found(*value, at, place))
    found = search.worst(measure, seen, restarts, int(steps * size), rng)
    return {
        "module": module,
        "kernel": kernel,
        "names": names,
        "points": len(seen),
        "drawn": [(f.condition, f.error) for f in seen],
        "worst": [dataclasses.asdict(f) for f in found[:KEPT]],
        "rows": [row(module, kernel, names, f.at) for f in found[:KEPT]],
    }


def row(module: str, kernel: str, names: Sequence[str], at: Point) -> dict[str, Any]:
    """A point as `tests/data/kernel_oracle.json` has them, with the errors measured by backend."""
    true, scales = exact.values(module, kernel, names, at)
    errors = {}
    for backend in loaded():
        found = error(module, kernel, names, at, backend)
        errors[backend] = None if found is None else found[0]
    return {
        "at": list(at),
        "is": [shown(value) for value in true],
        "scale": [shown(scale, 6) for scale in scales],
        "errors": errors,
    }


def extremes(module: str, kernel: str, count: int) -> dict[str, Any] | None:
    """At 1e±150 and subnormals: how many points are within the target, and one that is not. None where not tried."""
    if kernel in SLOW | CHOPPED or module.startswith(domains.PLAIN) or module == "frequencies":
        return None
    names = named()[module, kernel]
    rng = np.random.default_rng([8, zlib.crc32(f"{module}.{kernel}".encode())])
    seen = []
    for _ in range(count):
        at = domains.extreme(module, names, rng)
        value = error(module, kernel, names, at, "native")
        if value is not None:
            seen.append(Found(*value, at, "extreme"))
    lost = [f for f in seen if f.error > TARGET]
    return {
        "points": len(seen),
        "lost": len(lost),
        "worst": dataclasses.asdict(max(seen, key=lambda f: f.error)) if seen else None,
    }
