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
from typing import Any

import numpy as np
from mpmath import mp, mpf

from benchmarks.stress import baseline, domains, search
from benchmarks.stress.search import Found, Point
from tests import backends
from tests.oracles import kernels as exact
from tests.oracles.definitions.points import shown

U = 2.0**-53
LARGEST, SMALLEST = sys.float_info.max, sys.float_info.min
TARGET = 4.0
#: the exact value's own digits
ROUNDED = 1e-20
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
    """Every kernel by module and name, with its arguments' names; those of most gradients are judged elsewhere.

    Those that are defined by integrals over densities are held at the points of the kernels' oracle alone.
    """
    found = {}
    for module, functions in loaded()["numpy"].items():
        for name in functions.__all__:
            function = getattr(functions, name)
            # what a scene has from another module is that one's
            own = getattr(function, "__module__", "").endswith(f".{module}")
            elsewhere = exact.is_of_gradients(name) and module not in domains.OF_MODULE
            if own and hasattr(function, "__code__") and not elsewhere and module != "linearization":
                found[module, name] = tuple(inspect.signature(function).parameters)
    return found


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
    found = float(abs(mpf(value) - true) / (U * scale))
    return found if found > ROUNDED else 0.0


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


def effort(module: str, kernel: str) -> tuple[int, int, int]:
    """Points drawn, how many of them the search begins at, and its steps from each, by what a definition takes."""
    if exact.is_of_gradients(kernel) and module != "off_centre":
        return 12, 1, 6
    # differentiated, and for each argument anew
    many = module in domains.OF_MODULE and (len(named()[module, kernel]) > 7 or "_end" in kernel)
    return (16, 2, 8) if many or kernel in SLOW or module == "second_approximation" else (40, 2, 25)


def stress(module: str, kernel: str, size: float, backend: str = "native") -> dict[str, Any]:
    """One kernel: drawn points, the search from the worst of them, and the extremes apart."""
    names = named()[module, kernel]
    rng = np.random.default_rng([7, zlib.crc32(f"{module}.{kernel}".encode())])
    count, restarts, steps = effort(module, kernel)

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
    if kernel in SLOW | CHOPPED or module.startswith(domains.PLAIN) or module in ("frequencies", *domains.OF_MODULE):
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
