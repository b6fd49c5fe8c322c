"""Writes `data/kernel_oracle.json`: every generated kernel's values to 40 digits at fixed points, by other routes.

In:  `definitions`, Table 1 as typed from the paper, seeded points; for a mechanism that has no definitions
     there its file, see `stated`. Nothing that derives or computes.
Out: {module: {kernel: [{"at": arguments, "is": values, "scale": |f| + sum |x df/dx|}, ...]}}.

The routes: the averaged force by quadrature of the piecewise force, its derivatives and those of F by numerical
differentiation, coefficients of polynomials by interpolation, resultants as Sylvester determinants over the rationals,
the Jacobian by differentiating the averaged equations of motion, Den Hartog's solution from its four linear conditions.

u * scale is the error that rounding the arguments and the result once each would cause: error/scale is measured in u.

After a change of the list of kernels: python -m tests.oracles.make_kernel_oracle [module ...] (all: ten minutes).
"""

from __future__ import annotations

import functools
import importlib
import json
import random
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from flint import fmpq
from mpmath import mp, mpf

from derivations.codegen.catalogue.flow import OWN
from derivations.mechanisms import all_mechanisms
from tests.oracles.definitions import damping, inertia, linearization, motion, off_centre, sensitivities
from tests.oracles.definitions.along import BESIDE_FOLDS, DAMPED, LOCI, SIGNS, SLOPES, UNDAMPED
from tests.oracles.definitions.averaged_force import COMPOSED as KNOWN
from tests.oracles.definitions.averaged_force import (
    TOGETHER,
    TYPED,
    changes_table,
    composed,
    family,
    harmonics_table,
    of_force,
    passed_by,
    pieces,
    scale_of,
    second_approximation_table,
    stated,
)
from tests.oracles.definitions.den_hartog import DEN_HARTOG, exact_U, exact_V
from tests.oracles.definitions.frequencies import frequencies_table
from tests.oracles.definitions.points import (
    DESIGNS,
    DUFFINGS,
    RANGES,
    SCENES,
    STEEP_DESIGNS,
    Amplitudes,
    around,
    beside_backbone,
    close_to_one,
    entry,
    parameters_of,
    points,
    table_of,
    zeroed,
)
from tests.oracles.definitions.resultants import LEADING, detachment, saddle_node_onset, saddle_nodes
from tests.oracles.definitions.sampled import sampled_table
from tests.oracles.definitions.slow_flow import SLOW_FLOW

OUT = Path(__file__).parents[1] / "data" / "kernel_oracle.json"


def slow_flow_table(rng: random.Random, scene: str) -> dict:
    table = {}
    own = OWN.get(scene.removeprefix("_"))
    for name, (names, f) in (SLOW_FLOW if scene else SLOW_FLOW | SLOPES).items():
        if own and name not in own:
            continue
        chosen = points(rng, names, 6)
        for number, x in enumerate(chosen):
            beside_backbone(names.split(), number, x)
        if name == "isolation":  # where h pushes outwards, too
            for x in chosen[::2]:
                x[-1] *= -1
        table[name] = [entry(zeroed(f, names.split(), scene), x) for x in chosen]
    names = "A m zeta h"
    table["detachment"] = [
        entry(zeroed(detachment, names.split(), scene), x, exact=True) for x in points(rng, names, 6)
    ]
    for name, (names, f) in (LOCI | (UNDAMPED if "zeta" in SCENES[scene] else DAMPED)).items():
        if own and name not in own:
            continue
        chosen = points(rng, names, 6)
        if name in SIGNS:
            h_A = names.split().index("h_A")
            for x in chosen:
                x[h_A] = SIGNS[name] * abs(x[h_A])
        if "intercept" in names:
            with_it = [k for k, argument in enumerate(names.split()) if argument in ("intercept", "R")]
            for x in chosen[::2]:
                for k in with_it:
                    x[k] *= -1
        table[name] = [entry(zeroed(f, names.split(), scene), x) for x in chosen]
    return table | table_of({} if scene else BESIDE_FOLDS, rng)


def den_hartog_table(rng: random.Random) -> dict:
    frequencies = [0.4, 0.45, 0.55, 0.7, 0.9, 0.999, 1.0 + 1e-9, 1.001, 1.1, 1.5, 2.0, 3.0]
    table = {}
    for name, (names, f) in DEN_HARTOG.items():
        rows = []
        for Omega in frequencies:
            x = {other: rng.uniform(*RANGES[other]) for other in ("A", "F_0", "mu", "S")}
            x["Omega"] = Omega
            # friction small enough for a steady motion; tau in the first half of the half-cycle, where S is attained
            x["mu"] = x["F_0"] * abs(float(exact_V(mpf(Omega))[0] / exact_U(mpf(Omega))[0])) * rng.uniform(0.1, 0.9)
            taus = [1e-6, rng.uniform(0.05, 0.5) * float(mp.pi) / Omega] if "tau" in names else [0.0]
            for x["tau"] in taus:
                rows.append(entry(f, [x[other] for other in names.split()]))
        table[name] = rows
    return table


def has(name: str, kernel: str) -> bool:
    """Whether a mechanism has that kernel of several averages: all at once where they are one algorithm."""
    return kernel != "averaged_all" or name == "rod_spring_untruncated"


def family_table(name: str, amplitudes: Amplitudes) -> dict:
    """h, H and their derivatives, singly and together."""
    table: dict[str, list] = {}
    for A, p in amplitudes:
        passed = passed_by(name, A, p)
        values = {}
        for letter, vertical in (("h", False), ("H", True)):
            row = entry(lambda *x, n=passed, v=vertical: family(name, n, v, *x), [A, *p])
            for order, value, scale in zip(("", "_A", "_AA", "_AAA"), row["is"], row["scale"], strict=True):
                values[letter + order] = value, scale
        del values["H_AAA"]

        def add(kernel: str, outputs: Sequence[str], values=values, at=row["at"]) -> None:
            chosen = [values[output] for output in outputs]
            one = {"at": at, "is": [value for value, _ in chosen], "scale": [scale for _, scale in chosen]}
            table.setdefault(kernel, []).append(one)

        for output in values:
            add(output, (output,))

        def intercept(*x, n=passed):
            h, h_A, *_ = family(name, n, False, *x)
            return [h - x[0] * h_A]

        row = entry(intercept, [A, *p])
        values["intercept"] = row["is"][0], row["scale"][0]
        add("intercept", ("intercept",))
        for kernel, outputs in TOGETHER.items():
            if has(name, kernel):
                add(kernel, outputs)
    return table


#: what every mechanism has of the slow flow, and those of it that are functions of less than Omega, A and damping
COMPOSED = ("F", "F_A", "level", "phase", "jacobian", "stability", "transmissibility")
BARE = (
    *("backbone", "limit_envelope", "equivalent_damping"),
    *("response_quartic", "fold_quartic", "peak_cubic", "detachment"),
)


def composed_table(rng: random.Random, name: str, amplitudes: Amplitudes) -> dict:
    """The slow flow's functions with the mechanism put in."""
    table: dict[str, list] = {}
    for kernel in (*COMPOSED, *BARE):
        inner = KNOWN[kernel][0].split()
        outer = [x for x in ("Omega", "A", "F_0", "mu", "zeta") if x != "F_0" or "F_0" in inner]
        if kernel in BARE:
            outer = ["mu" if x == "m" else x for x in inner if x[0] != "h"]
        for A, p in amplitudes:
            average = functools.partial(family, name, passed_by(name, A, p), False)
            x = [A if argument == "A" else rng.uniform(*RANGES[argument]) for argument in outer]
            if kernel == "backbone" and average(mpf(A), *map(mpf, p))[0] > 0:
                continue
            f = composed(kernel, outer, average)
            table.setdefault(kernel, []).append(entry(f, [*x, *(p if "h" in inner else ())]))
    return table


def resultant_table(rng: random.Random, name: str, parameters: list[tuple[float, ...]]) -> dict:
    table: dict[str, list] = {}
    # the breakpoint does not enter
    count = 2 if name == "duffing" else 3
    for kernel, f, own in (
        ("saddle_node_onset", saddle_node_onset, ["m", "zeta"]),
        ("saddle_nodes", saddle_nodes, ["F_0", "m", "zeta"]),
    ):

        def whole(*x, f=f, kernel=kernel, last=len(own) - 1):  # noqa: B008
            if other := stated(name):
                found = f(fmpq(1), *x[: last + 1], *other.first(x[last + 1 :]))
                # the scale is a convention: that of the kernel
                scale = getattr(importlib.import_module(f"slowflow_kernels.{name}"), kernel)(
                    *(float(v.p) / float(v.q) for v in x)
                )[-1]
                return [fmpq(*float(scale).as_integer_ratio()) * c for c in found]
            used = x[: last + 1 + count]
            return f(LEADING[name, kernel](*used[last:]), *used)

        for p in parameters:
            x = points(rng, " ".join(own), 1)[0]
            table.setdefault(kernel, []).append(entry(whole, [*x, *p], exact=True))
    return table


def by_design(name: str, coefficients: Callable, *design) -> list:
    """Derivatives of each parameter, then of each breakpoint, by each number of a design."""

    def all_of(*x):
        parameters = coefficients(*x)
        return [*parameters, *pieces(name, parameters)[1]]

    count = len(all_of(*design))
    orders = [tuple(int(k == n) for n in range(len(design))) for k in range(len(design))]
    return [
        mp.chop(mp.diff(lambda *x, j=j: all_of(*x)[j], design, order), tol=mpf(10) ** -42)
        for j in range(count)
        for order in orders
    ]


def data_table(name: str, designs: Sequence, parameters: list[tuple[float, ...]]) -> dict:
    """Parameters, breakpoints, jumps and the force itself, whole and by its pieces, with their slopes."""
    coefficients = of_force(name, "coefficients")
    # the Duffing's design is its parameters
    arguments = parameters if name == "duffing" else designs
    table: dict[str, list] = {"coefficients": [entry(lambda *x: coefficients(*x), x) for x in arguments]}
    table["by_design"] = [entry(functools.partial(by_design, name, coefficients), x) for x in arguments]
    polynomial = ("steps", "steps_by") if name != "rod_spring_untruncated" else ()
    for kernel in ("breakpoints", "jumps", *polynomial, "hardening"):
        table[kernel] = [entry(of_force(name, kernel), p) for p in parameters]
    for p in parameters:
        for factor in (-0.9, 1e-6, 0.7, 0.999, -1.2):
            u = factor * scale_of(name, p)
            row = entry(of_force(name, "force", passed_by(name, abs(u), p)), [u, *p])
            table.setdefault("force", []).append(row)
    for p in parameters:
        count = len(pieces(name, p)[0])
        for k, factors in enumerate([(-0.9, 1e-6, 0.7, 0.999), *[(-1.2, 30.0)] * (count - 1)], start=1):
            for factor in factors:
                for kernel in (f"force_{k}", f"force_{k}_u"):
                    row = entry(of_force(name, kernel), [factor * scale_of(name, p), *p])
                    table.setdefault(kernel, []).append(row)
    return table


def tables() -> dict[str, Callable[[random.Random], dict]]:
    """How to make the table of each module."""
    made: dict[str, Callable[[random.Random], dict]] = {}
    for scene in SCENES:
        made["slow_flow" + scene] = functools.partial(slow_flow_table, scene=scene)
    made["inertia"] = functools.partial(table_of, inertia.INERTIA, place=inertia.place)
    made["dissipation"] = functools.partial(table_of, damping.DISSIPATION, place=damping.place)
    made["linearization"] = functools.partial(table_of, linearization.LINEARIZATION)
    made["sensitivities"] = functools.partial(table_of, sensitivities.SENSITIVITIES)
    made["motion"] = functools.partial(table_of, motion.MOTION)
    offset = {"count": 5, "place": off_centre.place, "ranges": off_centre.BETWEEN}
    made["off_centre"] = functools.partial(table_of, off_centre.OFF_CENTRE, **offset)
    made["second_approximation"] = second_approximation_table
    made["frequencies"] = frequencies_table
    made["sampled"] = sampled_table
    made["den_hartog"] = den_hartog_table
    isolators = [parameters_of(design) for design in DESIGNS]
    untruncated = [(*parameters_of(design)[:2], design[-1]) for design in STEEP_DESIGNS]
    ends = {p: scale_of("rod_spring_untruncated", p) for p in untruncated}
    made |= mechanism_tables(
        "rod_spring_untruncated",
        STEEP_DESIGNS,
        untruncated,
        [(A, p) for p, b in ends.items() for A in (*around(b, False), *close_to_one(b))],
        [(A * ends[p], p) for p in untruncated[::2] for A in (0.5, 1.1, 2.2)],
    )
    made |= mechanism_tables(
        "rod_spring",
        DESIGNS,
        isolators,
        [(A, p) for k, p in enumerate(isolators) for A in around(p[-1], k in (0, 4))],
        [(A * p[-1], p) for p in isolators for A in (0.5, 1.1, 2.2)],
    )
    parameters = [(1 + kappa_1, kappa_3) for kappa_1, kappa_3 in DUFFINGS]
    made |= mechanism_tables(
        "duffing",
        DUFFINGS,
        parameters,
        [(A, p) for p in parameters for A in (0.0, 1e-8, 0.1, 0.7, 3.0)],
        [(A, p) for p in parameters for A in (0.1, 0.6)],
    )
    for name in (one.name for one in all_mechanisms() if one.name not in TYPED):
        other = stated(name)
        designs = other.designs()
        parameters = [tuple(float(c) for c in other.coefficients(*map(mpf, design))) for design in designs]
        made |= mechanism_tables(
            name,
            designs,
            parameters,
            [(A, p) for p in parameters for A in around(scale_of(name, p), False)],
            [(A * scale_of(name, p), p) for p in parameters for A in (0.5, 1.1, 2.2)],
        )
    return made


def mechanism_tables(name: str, designs, parameters, amplitudes: Amplitudes, some: Amplitudes) -> dict:
    """The module of a mechanism: its averages at all `amplitudes`, the composed functions at `some`."""

    def table(rng: random.Random) -> dict:
        own = composed_table(rng, name, some)
        if name != "rod_spring_untruncated":  # its average is no polynomial: there is no resultant
            own |= resultant_table(rng, name, parameters)
        own |= family_table(name, amplitudes) | data_table(name, designs, parameters)
        # of some amplitudes in each regime
        return own | {
            "harmonics": harmonics_table(name, amplitudes),
            "by_parameter": changes_table(name, amplitudes[1::3]),
        }

    return {name: table}


def main(only: list[str]) -> None:
    """Makes the table, or anew the modules named."""
    made = tables()
    table = {module: rows for module, rows in json.loads(OUT.read_text()).items() if only and module in made}
    for module, make in made.items():
        if not only or module in only:
            table[module] = make(random.Random(module))
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
