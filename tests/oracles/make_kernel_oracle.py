"""Writes `data/kernel_oracle.json`: every generated kernel's values to 40 digits at fixed points, by other routes.

In:  `kernels`, which has the values anywhere; Table 1 as typed from the paper, seeded points; for a mechanism that has
     no definitions there its file, see `stated`. Nothing that derives or computes.
Out: {module: {kernel: [{"at": arguments, "is": values, "scale": |f| + sum |x df/dx|}, ...]}}.

The routes: the averaged force by moments and elliptic integrals in balls, which are compared with quadrature of the
piecewise force; derivatives of F by Taylor series, coefficients of polynomials too, resultants as Sylvester
determinants over the rationals, the Jacobian by differentiating the averaged equations of motion, Den Hartog's
solution from its four linear conditions.

u * scale is the error that rounding the arguments and the result once each would cause: error/scale is measured in u.

After a change of the list of kernels: python -m tests.oracles.make_kernel_oracle [module ...] (all: ten minutes).
"""

from __future__ import annotations

import json
import random
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from mpmath import mpf

from derivations.mechanisms import all_mechanisms
from tests.oracles.definitions.averaged_force import (
    COMPOSED as KNOWN,
)
from tests.oracles.definitions.averaged_force import TOGETHER, coefficients, doubles_at_ends, stated
from tests.oracles.definitions.points import (
    DESIGNS,
    DUFFINGS,
    RANGES,
    STEEP_DESIGNS,
    around,
    close_to_one,
    parameters_of,
    points,
    shown,
)
from tests.oracles.kernels import AVERAGES, MODULES, averages, values
from tests.oracles.kernels import parameters_of as names_of

OUT = Path(__file__).parents[1] / "data" / "kernel_oracle.json"
#: what every mechanism has of the slow flow, and those of it that are functions of less than Omega, A and damping
COMPOSED = ("F", "F_A", "level", "phase", "jacobian", "stability", "transmissibility")
BARE = (
    *("backbone", "limit_envelope", "equivalent_damping"),
    *("response_quartic", "fold_quartic", "peak_cubic", "detachment"),
)
Point = tuple[str, Sequence[str], Sequence[float]]


def of_mechanism(name: str, rng: random.Random) -> Iterator[Point]:
    """Kernels of a mechanism with arguments: averages in every regime, the slow flow's functions at some amplitudes."""
    designs, parameters, amplitudes, some = numbers_of(name)
    inner = names_of(name)
    passed = {(A, p): sum(A > end for end in doubles_at_ends(name, p)) for A, p in amplitudes + some}

    def average(A: float, p: Sequence[float], count: int) -> list:
        return averages(name, passed[A, p], mpf(A), *map(mpf, p))[:count]

    for kernel in (*COMPOSED, *BARE):
        used = KNOWN[kernel][0].split()
        outer = [x for x in ("Omega", "A", "F_0", "mu", "zeta") if x != "F_0" or "F_0" in used]
        if kernel in BARE:
            outer = ["mu" if x == "m" else x for x in used if x[0] != "h"]
        for A, p in some:
            x = [A if argument == "A" else rng.uniform(*RANGES[argument]) for argument in outer]
            if kernel == "backbone" and average(A, p, 1)[0] > 0:
                continue
            yield kernel, (*outer, *(inner if "h" in used else ())), [*x, *(p if "h" in used else ())]
    if name != "rod_spring_untruncated":  # its average is no polynomial: there is no resultant
        for kernel, own in (("saddle_node_onset", "m zeta"), ("saddle_nodes", "F_0 m zeta")):
            for p in parameters:
                yield kernel, (*own.split(), *inner), [*points(rng, own, 1)[0], *p]
    # all averages at once where they are one algorithm
    several = TOGETHER.keys() - ({"averaged_all"} if name != "rod_spring_untruncated" else set())
    for kernel in sorted(AVERAGES.keys() - TOGETHER.keys() | several):
        for A, p in amplitudes:
            yield kernel, ("A", *inner), [A, *p]
    # the Duffing's design is its parameters
    for kernel in ("coefficients", "by_design"):
        for x in parameters if name == "duffing" else designs:
            yield kernel, [f"design_{k}" for k in range(len(x))], x
    for kernel in (
        "breakpoints",
        "jumps",
        "hardening",
        *(("steps", "steps_by") if name != "rod_spring_untruncated" else ()),
    ):
        for p in parameters:
            yield kernel, inner, p
    for p in parameters:
        ends = doubles_at_ends(name, p)
        scale = ends[-1] if ends else 1.0
        for factor in (-0.9, 1e-6, 0.7, 0.999, -1.2):
            yield "force", ("u", *inner), [factor * scale, *p]
        for k, factors in enumerate([(-0.9, 1e-6, 0.7, 0.999), *[(-1.2, 30.0)] * len(ends)], start=1):
            for factor in factors:
                for kernel in (f"force_{k}", f"force_{k}_u"):
                    yield kernel, ("u", *inner), [factor * scale, *p]
    for A, p in amplitudes:
        # as far as the untruncated force's are derived
        if A != 0 and not (name == "rod_spring_untruncated" and doubles_at_ends(name, p)[0] > 0.75):
            yield "harmonics", ("A", *inner), [A, *p]
    for A, p in amplitudes[1::3]:
        if A != 0:
            yield "by_parameter", ("A", "h", "h_A", "h_AA", *inner), [A, *map(float, average(A, p, 3)), *p]


def numbers_of(name: str) -> tuple:
    """Designs and parameters of a mechanism, amplitudes with parameters, and some of these."""
    ratios = (0.5, 1.1, 2.2)
    if name == "duffing":
        parameters = [(1 + kappa_1, *others) for kappa_1, *others in DUFFINGS]
        amplitudes, some = (
            [(A, p) for p in parameters for A in few] for few in ((0.0, 1e-8, 0.1, 0.7, 3.0), (0.1, 0.6))
        )
        return DUFFINGS, parameters, amplitudes, some
    if name == "rod_spring":
        designs, parameters = DESIGNS, [parameters_of(design) for design in DESIGNS]
        amplitudes = [(A, p) for k, p in enumerate(parameters) for A in around(p[-1], k in (0, 4))]
        return designs, parameters, amplitudes, [(A * p[-1], p) for p in parameters for A in ratios]
    if name == "rod_spring_untruncated":
        designs, parameters = STEEP_DESIGNS, [(*parameters_of(design)[:2], design[-1]) for design in STEEP_DESIGNS]
    else:
        other = stated(name)
        designs = other.designs()
        parameters = [tuple(float(c) for c in coefficients(name)(*map(mpf, design))) for design in designs]
    ends = {p: (doubles_at_ends(name, p) or [1.0])[-1] for p in parameters}
    steep = name == "rod_spring_untruncated"
    amplitudes = [(A, p) for p, b in ends.items() for A in (*around(b, False), *(close_to_one(b) if steep else ()))]
    return designs, parameters, amplitudes, [(A * ends[p], p) for p in parameters[:: 1 + steep] for A in ratios]


def made(module: str) -> dict[str, list[dict]]:
    """The kernels' rows of a module."""
    rng, rows = random.Random(module), {}
    drawn = MODULES[module].points(rng) if module in MODULES else of_mechanism(module, rng)
    for kernel, names, x in drawn:
        found, scales = values(module, kernel, names, x)
        row = {"at": list(x), "is": [shown(v) for v in found], "scale": [shown(s, 6) for s in scales]}
        rows.setdefault(kernel, []).append(row)
    return rows


def main(only: list[str]) -> None:
    """Makes the table, or anew the modules named."""
    modules = [*MODULES, *(one.name for one in all_mechanisms())]
    table = {module: rows for module, rows in json.loads(OUT.read_text()).items() if only and module in modules}
    table |= {module: made(module) for module in only or modules}
    lines = []
    for module, kernels in sorted(table.items()):
        inner = []
        for kernel, rows in kernels.items():
            body = ",\n".join("   " + json.dumps(row) for row in rows)
            inner.append(f'  "{kernel}": [\n{body}\n  ]')
        lines.append(f' "{module}": {{\n' + ",\n".join(inner) + "\n }")
    OUT.write_text("{\n" + ",\n".join(lines) + "\n}\n")


if __name__ == "__main__":
    main(sys.argv[1:])
