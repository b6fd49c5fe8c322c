"""The kernels of a mechanism: its averages, its force, its resultants, and the slow flow with its own h put in.

In:  `Results` and the slow flow's modules.
Out: `mechanism_modules`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from derivations.elliptic import evaluable, parts
from derivations.emit.form import (
    AVERAGED,
    NAMES,
    Branch,
    Composition,
    Kernel,
    Let,
    Module,
    Record,
    by_even_power,
    in_words,
    plain,
    suffix,
)
from derivations.mechanisms import Mechanism, Parameter
from derivations.oscillator import Oscillator
from derivations.restoring import Case, Restoring, forms
from derivations.results import OfMechanism, Results
from derivations.second_approximation import OF_HARMONIC
from derivations.slow_flow import SCENES, m
from derivations.symbols import F_0, A, Omega, h, mu, u, zeta

#: functions of the slow flow that every mechanism composes with its own h
COMPOSED = (
    *("R", "I", "F", "F_A", "F_AA", "F_AAA", "F_Omega", "F_AOmega"),
    *("phase", "jacobian", "stability", "transmissibility"),
)
#: those whose arguments say all: no mechanism enters, or nothing but A and the mechanism
BARE = ("backbone", "limit_envelope", "equivalent_damping")


def mechanism_modules(results: Results, name: str, flows: dict[str, Module]) -> list[Module]:
    """The modules of one mechanism: general, one for each damping scene, and attached-only for polynomials."""
    derived = results.mechanisms[name]
    mechanism = derived.oscillator.mechanism
    title = mechanism.title[0].upper() + mechanism.title[1:]
    inputs = (f"mechanisms/{name}.py",)
    pieces, tables = piece_kernels(derived)
    family = (*averaged_kernels(derived), harmonics_kernel(derived), *data_kernels(derived))
    if not mechanism.reach.is_extended_real or mechanism.reach.free_symbols:
        raise ArithmeticError(f"{name}: the reach has to be a number in the dimensionless displacement")
    constants = {
        "NAME": name,
        "PARAMETERS": tuple(map(str, mechanism.parameters)),
        "RATIOS": tuple(map(str, mechanism.ratios)),
        "REACH": mechanism.reach,
        "REACH_REASON": mechanism.reach_reason,
        "HARMONICS_UP_TO": derived.harmonics.most,
    }
    modules = []
    for scene in SCENES:
        modules.append(
            Module(
                name=name + suffix(scene),
                title=title + in_words(scene),
                inputs=inputs,
                kernels=(*(() if scene else (*family, *pieces)), *resultant_kernels(derived, scene)),
                compositions=tuple(compositions(flows[scene], mechanism)),
                flow=flows[scene].name,
                family=name,
                reexports=(name, (*constants, *(kernel.name for kernel in family))) if scene else ("", ()),
                constants={} if scene else constants,
                mechanism=mechanism,
                pieces={} if scene else tables,
                record=None if scene else record(results, derived),
            )
        )
    if has_attached(derived):
        data = tuple(kernel.name for kernel in data_kernels(derived))
        modules.append(
            Module(
                name=f"{name}_attached",
                title=f"{title}; amplitudes up to {mechanism.breakpoints[0]} only",
                inputs=inputs,
                kernels=tuple(averaged_kernels(derived, attached_only=True)),
                compositions=tuple(compositions(flows[""], mechanism)),
                flow=flows[""].name,
                family=f"{name}_attached",
                reexports=(name, (*constants, *data, "saddle_node_onset", "saddle_nodes")),
                mechanism=mechanism,
            )
        )
    return modules


def regime_branches(restoring: Restoring, orders: Sequence[int], attached_only: bool) -> tuple[Branch, ...]:
    """The regimes of an average as branches; at a breakpoint the lower regime holds."""
    cases = restoring.cases or tuple(
        Case(name, guards, restoring.far_regimes[count, far] if far else restoring.regimes[count])
        for name, guards, count, far in forms(restoring.breakpoints)
    )
    if attached_only:
        cases = (replace(cases[0], guards=()),)
    return tuple(
        Branch(c.name, c.guards, c.regime.lets, tuple(c.regime.derivatives[order] for order in orders)) for c in cases
    )


def averaged_kernels(derived: OfMechanism, attached_only: bool = False) -> list[Kernel]:
    """h, H and their derivatives, singly and together."""
    parameters = derived.oscillator.mechanism.parameters
    kernels = []
    domain = "A >= 0"
    if attached_only:
        domain = f"0 <= A <= {derived.whole.breakpoints[0]}"

    def kernel(name: str, restoring: Restoring, orders: Sequence[int], doc: str, equation: str) -> Kernel:
        return Kernel(
            name,
            (A, *parameters),
            regime_branches(restoring, orders, attached_only),
            doc,
            equation,
            domain,
            parameters=len(parameters),
            returns="scalar" if len(orders) == 1 else "tuple",
        )

    for count in (4, 3, 2):
        listed = ", ".join("h" + name for name in NAMES[:count])
        name = "averaged" if count == 4 else f"averaged_{count}"
        kernels.append(kernel(name, derived.whole, range(count), f"{listed} together.", "(20)-(22), (31)"))
    if has_attached(derived) and not attached_only:
        first = replace(regime_branches(derived.whole, range(4), True)[0], name="")
        text = f"The first piece alone: {', '.join('h' + name for name in NAMES)} together."
        domain = f"0 <= A <= {derived.whole.breakpoints[0]}"
        kernels.append(
            replace(kernels[0], name="attached", branches=(first,), doc=text, equation="(20), (21)", domain=domain)
        )
    slope = ("", "d/dA of ", "d2/dA2 of ", "d3/dA3 of ")
    for letter, restoring, orders, what in (
        ("h", derived.whole, range(4), "the averaged restoring force h = H - A"),
        ("H", derived.beside_vertical, range(3), "the averaged force H beside the vertical spring"),
    ):
        for order in orders:
            text = slope[order] + what + "." if order else what[0].upper() + what[1:] + "."
            equation = "(20)-(22)" if order == 0 else "(31)" if order == 1 else "from (31)"
            kernels.append(kernel(letter + NAMES[order], restoring, (order,), text, equation))
    return kernels


def harmonics_kernel(derived: OfMechanism) -> Kernel:
    """The higher harmonics of the force and their derivatives, together."""
    parameters = derived.oscillator.mechanism.parameters
    listed = ", ".join(str(symbol) for family in OF_HARMONIC.values() for symbol in family)
    return Kernel(
        "harmonics",
        (A, *parameters),
        tuple(Branch(c.name, c.guards, c.regime.lets, c.regime.derivatives) for c in derived.harmonics.cases),
        f"Higher harmonics of the force, as h is its first: {listed}.",
        "beyond (20)",
        derived.harmonics.domain,
        parameters=len(parameters),
        returns="tuple",
    )


def force_branches(pieces: Sequence[sp.Expr], ends: Sequence[sp.Expr]) -> tuple[Branch, ...]:
    """A piecewise force; at a breakpoint the lower piece holds."""
    guards = [*(((sp.Abs(u), end),) for end in ends), ()]
    numbered = enumerate(zip(guards, pieces, strict=True), start=1)
    return tuple(Branch(f"piece_{k}", guard, (), (piece,)) for k, (guard, piece) in numbered)


def force_slope(force: sp.Expr) -> tuple[list[Let], sp.Expr]:
    """df/du of a piece of a force; its square roots as lets."""
    if force.is_polynomial(u):
        return [], sp.horner(sp.diff(sp.expand(force), u), u)
    under = sorted({power.base for power in force.atoms(sp.Pow) if power.exp.is_Rational and power.exp.q == 2}, key=str)
    roots = {base: sp.Symbol(f"root_{k}", positive=True) for k, base in enumerate(under, start=1)}
    named = force.replace(
        lambda part: part.is_Pow and part.base in roots, lambda part: roots[part.base] ** (2 * part.exp)
    )
    slope = sp.diff(named, u) + sum(
        sp.diff(named, root) * sp.diff(base, u) / (2 * root) for base, root in roots.items()
    )
    return [(root, sp.sqrt(base)) for base, root in roots.items()], slope


def data_kernels(derived: OfMechanism) -> list[Kernel]:
    """Parameters from ratios, breakpoints, jumps, and the force itself."""
    dimensionless = derived.oscillator
    mechanism = dimensionless.mechanism
    parameters, ratios = mechanism.parameters, tuple(mechanism.ratios)
    count = len(parameters)
    whole = derived.whole
    design = tuple(parameter.symbol for parameter in mechanism.design)
    definitions = dimensionless.definitions if design == ratios else {name: name for name in parameters}
    kernels = [
        plain(
            "coefficients",
            design,
            tuple(definitions[name] for name in parameters),
            f"The parameters {', '.join(map(str, parameters))} from the design.",
            "(5), (7)",
            "any design",
        )
    ]
    for name, values, doc, equation in (
        ("breakpoints", whole.breakpoints, "The |u| at which a piece of the force ends.", "(5)"),
        (
            "jumps",
            whole.jumps,
            "What the force loses at each breakpoint: f below less f above.",
            "(5)" if whole.cases else "(6)",
        ),
        (
            "hardening",
            hardening(whole),
            "The force over the displacement, f(u)/u, rises with |u| where none of these is negative.",
            "from (3)",
        ),
    ):
        kernels.append(plain(name, parameters, values, doc, equation, "any parameters", parameters=count))
    kernels.append(
        Kernel(
            "force",
            (u, *parameters),
            force_branches(
                [evaluable(piece) if whole.cases else sp.horner(piece, u) for piece in whole.pieces], whole.breakpoints
            ),
            f"Whole dimensionless restoring force u + F_k(u), {'un' if whole.cases else ''}truncated.",
            "(3), (5)" if whole.cases else "(3), (6)",
            f"|u| < {mechanism.reach}" if whole.cases else "any u",
            parameters=count,
        )
    )
    return kernels


def piece_kernels(derived: OfMechanism) -> tuple[list[Kernel], dict[str, tuple[tuple[str, ...], ...]]]:
    """The pieces of the force and their slopes, one by one, for the equation of motion; and their table."""
    arguments = (u, *derived.oscillator.mechanism.parameters)
    texts = ("(3), (5)" if derived.whole.cases else "(3), (6)", "where it holds")
    kernels, table = [], []
    for k, stated in enumerate(derived.whole.pieces, start=1):
        piece = evaluable(stated) if derived.whole.cases else sp.horner(stated, u)
        name, what = f"force_{k}", f"iece {k} of the whole restoring force u + F_k(u)."
        lets, slope = force_slope(piece)
        kernels.append(plain(name, arguments, piece, "P" + what, *texts, generic=True))
        kernels.append(plain(f"{name}_u", arguments, slope, "d/du of p" + what, *texts, lets=lets, generic=True))
        table.append((name, f"{name}_u"))
    return kernels, {"FORCE": tuple(table)}


def hardening(whole: Restoring) -> tuple[sp.Expr, ...]:
    """What must not be negative for f(u)/u to rise with |u|: the slope's terms piece by piece, then the jumps.

    Of a polynomial piece d/du (f/u) is the sum of (d - 1) c_d u^(d - 2). Others are u (a + b (1/sqrt(1 - u^2) - 1)).
    """
    terms: list[sp.Expr] = []
    for piece in whole.pieces:
        if piece.is_polynomial(u):
            terms += [c * sp.sign(d - 1) for (d,), c in reversed(sp.Poly(piece, u).terms()) if d != 1]
        else:
            terms.append(sp.factor(parts(piece)[1]))
    return (*(term for term in terms if term != 0), *(-jump for jump in whole.jumps if jump != 0))


def described(dimensionless: Oscillator) -> tuple[Parameter, ...]:
    """The parameters of the kernels, each with one line and the unit of the dimensional quantity."""
    mechanism = dimensionless.mechanism
    given = {parameter.symbol: parameter for parameter in mechanism.design}
    several = len(mechanism.pieces) > 1
    result = []
    for number, names in enumerate(mechanism.coefficients, start=1):
        where = f"of piece {number} of the force" if several else "of the force"
        for power, name in names.items():
            unit = "k_v" if power == 1 else f"k_v/L^{power - 1}"
            doc = f"coefficient of u{f'^{power}' if power > 1 else ''} in the Taylor series {where}"
            result.append(given.get(name, Parameter(name, doc, unit)))
    ends = (
        Parameter(name, f"|u| at which piece {number} of the force ends", "L")
        for number, name in enumerate(mechanism.breakpoints, start=1)
    )
    return (*result, *ends)


def record(results: Results, derived: OfMechanism) -> Record:
    """What the record says that no kernel does."""
    mechanism = derived.oscillator.mechanism
    whole_force = mechanism.order == sp.oo

    def kept(force: sp.Expr) -> bool:
        return force.is_polynomial(u) and sp.degree(force, u) <= mechanism.order

    truncated = not whole_force and not all(kept(force) for force in derived.oscillator.exact)
    twins = [
        name
        for name, other in results.mechanisms.items()
        if truncated
        and other.oscillator.mechanism.order == sp.oo
        and other.oscillator.mechanism.pieces == mechanism.pieces
    ]
    return Record(
        mechanism,
        described(derived.oscillator),
        derived.harmonics.most,
        truncated,
        twins[0] if twins else "",
        has_attached(derived),
    )


def has_attached(derived: OfMechanism) -> bool:
    """Whether the first piece alone is averaged. An untruncated force ends at the reach: there is no average beyond."""
    return bool(derived.whole.breakpoints) and not derived.whole.cases


def resultant_kernels(derived: OfMechanism, scene: str) -> list[Kernel]:
    """Coefficients of the resultants of one scene, where there are any."""
    if not derived.saddle_nodes:
        return []
    parameters = derived.oscillator.mechanism.parameters
    first = derived.whole.breakpoints[:1]
    # the resultants hold for the first regime: its breakpoint does not enter
    domain = f"roots with 0 < A <= {first[0]}" if first else "roots with A > 0"
    return [
        plain(
            "saddle_node_onset",
            (m, zeta, *parameters),
            by_even_power(derived.saddle_node_onset[scene]),
            "Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.",
            "(33)",
            domain,
            parameters=len(parameters),
            returns="stack",
        ),
        plain(
            "saddle_nodes",
            (F_0, m, zeta, *parameters),
            by_even_power(derived.saddle_nodes[scene]),
            "Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.",
            "from (24), (30)",
            domain,
            parameters=len(parameters),
            returns="stack",
        ),
    ]


def compositions(flow: Module, mechanism: Mechanism) -> list[Composition]:
    """The slow flow's functions of Omega, A, F_0, mu, zeta and the mechanism's parameters."""
    by_name = {kernel.name: kernel for kernel in flow.kernels}
    parameters = mechanism.parameters
    result = []
    for name in COMPOSED:
        inner = by_name[name]
        forcing = (F_0,) if F_0 in inner.arguments else ()
        arguments = (Omega, A, *forcing, mu, zeta, *parameters)
        result.append(Composition(name, arguments, inner, inner.doc, len(parameters)))
    for name in BARE:
        inner = by_name[name]
        own = [mu if argument == m else argument for argument in inner.arguments if argument not in AVERAGED]
        needs = parameters if h in inner.arguments else ()
        result.append(Composition(name, (*own, *needs), inner, inner.doc, len(needs)))
    return result
