"""The kernels of a mechanism: its averages, its force, its resultants, and the slow flow with its own h put in.

In:  `Results` and the slow flow's module.
Out: `mechanism_module`; `with_proofs`, the module with what proofs and compiled solvers ask besides.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import sympy as sp

from ...asymmetric.curved import of_untruncated
from ...asymmetric.off_centre import steps
from ...extensions.second_approximation import OF_HARMONIC
from ...forces import elliptic
from ...forces.elliptic import coefficients, evaluable
from ...forces.of_mechanism import OfMechanism
from ...kernels import Branch, Formulas, Kernel, Let, Lets
from ...mechanisms import Mechanism, Parameter
from ...paper.equation_of_motion import Dimensionless
from ...paper.restoring_force import Case, Restoring, average, forms
from ...paper.slow_flow import m
from ...symbols import F_0, A, mu, u, zeta
from ..compensated import copysign
from ..form import AVERAGED, NAMES, Composition, Law, Module, Record, Selection
from .force import Printed, formulas, state_data, state_pieces, state_steps
from .sided import state_curved

if TYPE_CHECKING:
    from ...extensions.scaling import Scale

#: What is emitted for each mechanism, and for whom.
#:
#: For the solvers, by the record: `averaged`, `averaged_2`, `intercept`, `harmonics`, `coefficients`,
#: `breakpoints`, `jumps`, `hardening`, `by_parameter`, `by_design`, and the pieces of the force with their slopes.
#: For users, who import them: `force`, the resultants `saddle_node_onset` (33) and `saddle_nodes`, and, thin because
#: each only calls another:
#:     h, H and derivatives     out of `averaged`, `averaged_2` and `averaged_H`
#:     functions of the slow flow, polynomials in Omega and (34), with the mechanism's h put in
COMPOSED = (
    *("F", "F_A", "level", "phase", "jacobian", "stability", "transmissibility"),
    *("backbone", "limit_envelope", "equivalent_damping"),
    *("response_quartic", "fold_quartic", "peak_cubic", "detachment"),
)


def mechanism_module(mechanisms: Mapping[str, OfMechanism], name: str, flow: Module | None) -> Module:
    """The module of one mechanism among others; composed with the slow flow where that is given."""
    derived = mechanisms[name]
    mechanism = derived.oscillator.mechanism
    if not mechanism.reach.is_extended_real or mechanism.reach.free_symbols:
        raise ArithmeticError(f"{name}: the reach has to be a number in the dimensionless displacement")
    of = formulas(mechanism.parameters)
    averages = together(of, derived) if is_spelled_out(derived) else one_by_one(of, derived, for_solvers=flow is None)
    state_harmonics(of, derived)
    state_by_parameter(of, derived)
    state_numbers(of, derived)
    laws = state_pieces(of, name, printed_pieces(derived), of_pieces(derived))
    state_force(of, derived)
    state_resultants(of, derived)
    terms = None
    if is_spelled_out(derived):
        *_, end = pieces_of(derived)
        terms = state_curved(of, of_untruncated(derived.whole.pieces, end, mechanism.parameters))
    return Module(
        name=name,
        title=mechanism.title[0].upper() + mechanism.title[1:],
        inputs=(f"mechanisms/{name}.py", *(["asymmetric/curved.py"] if terms else [])),
        stated=tuple(of.kernels.values()),
        selections=(*averages.selections, *selections(averages, compiled=not is_spelled_out(derived))),
        compositions=tuple(compositions(flow, mechanism, averages.pair, compiled=not is_spelled_out(derived)))
        if flow
        else (),
        flow=flow.name if flow else "",
        record=record(mechanisms, derived, laws, for_solvers=flow is None),
        off_centre=terms,
    )


def with_proofs(module: Module, derived: OfMechanism) -> Module:
    """The same with what compiled solvers and balls ask of it besides."""
    of = formulas(derived.oscillator.mechanism.parameters)
    state_given(of, derived)
    if is_spelled_out(derived):
        state_kinks(of, derived)
        state_closely(of, derived)
        state_in_balls(of, derived)
    else:
        state_known(of, derived)
    return replace(module, stated=(*module.stated, *of.kernels.values()))


@dataclass(frozen=True)
class Averages:
    """What gives h and three derivatives, h and h_A, H and H_A, h - A h_A; and the kernels and selections these are."""

    whole: Kernel | Selection
    pair: Kernel | Selection
    horizontal: Kernel | Selection | None
    intercept: Kernel | Selection

    @property
    def selections(self) -> list[Selection]:
        named = (self.whole, self.pair, self.horizontal, self.intercept)
        return [one for one in named if isinstance(one, Selection)]


def is_spelled_out(derived: OfMechanism) -> bool:
    """Whether the average is an algorithm in many steps, of which fewer derivatives save little.

    What calls it is no loop of its own either: that would be as long as the algorithm, for each of twenty functions.
    """
    return bool(derived.whole.cases)


def cases_of(restoring: Restoring) -> tuple[Case, ...]:
    """The forms of an average to evaluate; at a breakpoint the lower regime holds."""
    return restoring.cases or tuple(
        Case(name, guards, restoring.far_regimes[passed, far] if far else restoring.regimes[passed])
        for name, guards, passed, far in forms(restoring.breakpoints)
    )


def regime_branches(restoring: Restoring, count: int) -> tuple[Branch, ...]:
    """The regimes of an average and its first derivatives as branches."""
    return branches(cases_of(restoring), count)


def branches(cases: Sequence[Case], count: int | None = None, *, intercept: bool = False) -> tuple[Branch, ...]:
    """The first outputs of each case, with its intercept or without; a single one needs no name."""
    several = len(cases) > 1
    return tuple(
        Branch(
            c.name if several else "",
            c.guards,
            c.regime.lets,
            (*c.regime.derivatives[:count], *([c.regime.intercept] if intercept else [])),
            passed=len(c.regime.passed),
            remainders=c.regime.remainders,
        )
        for c in cases
    )


def state_averaged(
    of: Formulas, name: str, outputs: Sequence[str], cases: Sequence[Branch], doc: str = "", **keywords: object
) -> Kernel:
    """Some of h, H and their derivatives together, or what else `doc` says."""
    doc = doc or f"{', '.join(outputs)} together."
    if len(cases) == 1 and not cases[0].lets:
        cases = (by_squares(cases[0]),)
    of.add(name, cases, doc, "(20)-(22), (31)", "A >= 0", arguments=(A,), **keywords)
    return of.kernels[name]


def by_squares(branch: Branch) -> Branch:
    """Polynomials in A, odd or even, term by term: a parameter takes A^2 as often as its power asks for.

    By Horner's rule each product waits for the one before, and states of a batch take a tenth longer. Powers of A by
    themselves overflow where their parameter is 0, and the product is no number. Other averages stay as they are.
    """
    polynomials = [sp.Poly(value, A) for value in branch.outputs]
    terms = [[(n, *c.as_coeff_Mul()) for (n,), c in polynomial.terms()] for polynomial in polynomials]
    if any(n % 2 != of[0][0] % 2 or (n > 1 and not c.is_Symbol and c != 1) for of in terms for n, _, c in of):
        return branch
    lets: dict[sp.Symbol, sp.Expr] = {}

    def times_squares(parameter: sp.Expr, count: int) -> sp.Expr:
        if count == 0 or parameter == 1:
            return parameter * A ** (2 * count)
        name = sp.Symbol(f"{parameter}_A{2 * count}", real=True)
        lets[name] = A**2 * times_squares(parameter, count - 1)
        return name

    outputs = (
        A ** (of[0][0] % 2) * sp.Add(*(number * times_squares(c, n // 2) for n, number, c in of)) for of in terms
    )
    return replace(branch, outputs=tuple(outputs), lets=tuple(lets.items()))


#: names of h and of H with its derivatives; the further ones of H are those of h
OF_H, OF_BESIDE = tuple("h" + name for name in NAMES), ("H", "H_A")
#: the numbers that proofs compute with, and what they ask for together
OF_PROOFS = ("intervals", "pairs", "balls")
KNOWN = (*OF_H, "h - A h_A")


def one_by_one(of: Formulas, derived: OfMechanism, *, for_solvers: bool = False) -> Averages:
    """A kernel for each: what is not requested is not computed. H by itself, because h + A loses a small H's digits.

    for_solvers -- without H, which no solver evaluates
    """

    def named(name: str, outputs: tuple[str, ...], restoring: Restoring) -> Kernel:
        return state_averaged(of, name, outputs, regime_branches(restoring, len(outputs)))

    return Averages(
        named("averaged", OF_H, derived.whole),
        named("averaged_2", OF_H[:2], derived.whole),
        None if for_solvers else named("averaged_H", OF_BESIDE, derived.beside_vertical),
        state_averaged(of, "intercept", (), intercept_branches(derived), INTERCEPT),
    )


def together(of: Formulas, derived: OfMechanism) -> Averages:
    """One kernel for all: h and H are ends of the same steps."""
    whole, horizontal = (
        regime_branches(restoring, count)
        for restoring, count in ((derived.whole, len(OF_H)), (derived.beside_vertical, len(OF_BESIDE)))
    )
    if [branch.lets for branch in whole] != [branch.lets for branch in horizontal]:
        raise ArithmeticError("h and H are no ends of the same steps")
    cases = tuple(
        replace(one, outputs=(*one.outputs, *other.outputs, *last.outputs))
        for one, other, last in zip(whole, horizontal, intercept_branches(derived), strict=True)
    )
    names = (*OF_H, *OF_BESIDE, "h - A h_A")
    kernel = state_averaged(of, "averaged_all", names, cases)

    def some(name: str, outputs: Sequence[str]) -> Selection:
        chosen = tuple(names.index(output) for output in outputs)
        return Selection(name, kernel, chosen, f"{', '.join(outputs)} together.", kernel.equation)

    intercept = replace(some("intercept", names[-1:]), doc=INTERCEPT)
    return Averages(some("averaged", OF_H), some("averaged_2", OF_H[:2]), some("averaged_H", OF_BESIDE), intercept)


#: what `intercept` is
INTERCEPT = "h - A h_A, where the tangent of h meets A = 0; linear terms are none."


def intercept_branches(derived: OfMechanism) -> tuple[Branch, ...]:
    """h - A h_A, in a form of its own."""
    cases = zip(regime_branches(derived.whole, 0), cases_of(derived.whole), strict=True)
    return tuple(replace(branch, outputs=(case.regime.intercept,)) for branch, case in cases)


def state_given(of: Formulas, derived: OfMechanism) -> None:
    """The parameters from the design, and what the force loses at its breakpoints.

    That is a difference of larger numbers in the parameters, but not in the design: a number of its own.
    """
    whole, mechanism, values = derived.whole, derived.oscillator.mechanism, definitions_of(derived)
    ends = [(end, values[end]) for end in whole.breakpoints if values[end] != end]
    lost = [
        end * sp.factor(sp.simplify((jump / end).subs(values)))
        for end, jump in zip(whole.breakpoints, whole.jumps, strict=True)
    ]
    of.add(
        "given",
        Lets(ends, (*(name if name in whole.breakpoints else values[name] for name in mechanism.parameters), *lost)),
        "The parameters from the design, and what the force loses at each breakpoint.",
        "(5)-(7)",
        "any design",
        arguments=tuple(parameter.symbol for parameter in mechanism.design),
        packed=False,
        arithmetics=OF_PROOFS,
    )


def state_known(of: Formulas, derived: OfMechanism) -> None:
    """The average of a force of polynomials, by what it loses at its breakpoints too."""
    whole = derived.whole
    named = tuple(sp.Symbol(f"jump_{k}", real=True) for k in range(1, len(whole.breakpoints) + 1))
    of.parameters = (*of.parameters, *named)
    cases = [
        Case(name, guards, average(whole.pieces, whole.breakpoints, *passed, named))
        for name, guards, *passed in forms(whole.breakpoints)
    ]
    state_averaged(of, "known", KNOWN, branches(cases, intercept=True), arithmetics=OF_PROOFS)


def pieces_of(derived: OfMechanism) -> tuple[sp.Expr, sp.Expr, sp.Expr, elliptic.Corner]:
    """Of a force that is not truncated: a, b of its first piece, its second's slope, and where the first ends."""
    ((name, value),) = derived.oscillator.breakpoints.items()
    (a, b), (rest, _) = (coefficients(piece) for piece in derived.whole.pieces)
    return a, b, rest, elliptic.corner(name, value)


def state_closely(of: Formulas, derived: OfMechanism) -> None:
    """The average of a force that is not truncated, piece by piece: on intervals, and in double-double.

    Where A exceeds the breakpoint it follows from parts in closed form, which are computed to more digits.
    """
    a, b, rest, end = pieces_of(derived)
    of_parts = elliptic.detached_closely(b, rest, end)
    few, steep = (branches([Case("", (), regime)], intercept=True) for regime in elliptic.attached_closely(a, b))
    below = f"{', '.join(KNOWN)} together. Where A does not exceed the breakpoint"
    numbers = {"arithmetics": ("intervals", "pairs")}
    state_averaged(of, "attached", (), few, f"{below}, nor {elliptic.FEW}.", **numbers)
    steep = state_averaged(of, "attached_steep", (), steep, f"{below}.", **numbers)
    text = "The same where it does, from the parts."
    of.add("detached", of_parts.whole, text, steep.equation, steep.domain, arguments=(A, *of_parts.names), **numbers)
    of.add(
        "ends",
        Lets(of_parts.lets, of_parts.ends),
        "A; sqrt(1 - u_cr^2); sine, cosine and angle of where the first piece ends.",
        "(5)",
        "beyond > 0",
        arguments=(of_parts.beyond,),
        arithmetics=("bounded",),
    )
    of.add(
        "parts",
        Lets(of_parts.integral_lets, of_parts.integral),
        "The average without the last piece, over b: h, h_A, h_AA, h_AAA, h - A h_A by Carlson's integrals.",
        "(20)-(22), (31)",
        "A > u_cr",
        arguments=(*of_parts.ends, *of_parts.carlson),
        packed=False,
        arithmetics=("bounded",),
    )


def state_kinks(of: Formulas, derived: OfMechanism) -> None:
    """What the slope of a force that is not truncated loses where its springs leave."""
    *_, end = pieces_of(derived)
    height = sp.Symbol("c", positive=True)
    below, above = (sp.diff(piece, u).subs(elliptic.ROOT, height).subs(u, end.name) for piece in derived.whole.pieces)
    lets = ((end.name, end.value), (height, end.height))
    text = "What the slope of the force loses at each breakpoint."
    of.add("kinks", Lets(lets, (below - above,)), text, "(5)", arithmetics=OF_PROOFS)


def state_in_balls(of: Formulas, derived: OfMechanism) -> None:
    """What a proof asks for where an average is an algorithm that only approaches it: closed forms."""
    (end,) = derived.whole.breakpoints
    cases = [Case(f"passed_{k}", ((A, end),), regime) for k, regime in enumerate(derived.whole.regimes)]
    text = f"{', '.join(map(str, AVERAGED))}, h - A h_A at A = 0."
    at_rest = elliptic.at_rest(derived.whole.pieces[0])
    of.add("at_rest", at_rest, text, "(20)-(22), (31)", arithmetics=("balls",))
    state_averaged(of, "known", KNOWN, branches(cases, intercept=True), arithmetics=("balls",))


def definitions_of(derived: OfMechanism) -> dict[sp.Symbol, sp.Expr]:
    """Each parameter in the design's numbers."""
    mechanism = derived.oscillator.mechanism
    if tuple(parameter.symbol for parameter in mechanism.design) == tuple(mechanism.ratios):
        return derived.oscillator.definitions | {ratio: ratio for ratio in mechanism.instead}
    return {name: name for name in mechanism.parameters}


def selections(averages: Averages, *, compiled: bool) -> list[Selection]:
    """h and H with their derivatives, one by one."""
    slope = ("", "d/dA of ", "d2/dA2 of ", "d3/dA3 of ")
    result = []
    for letter, count, what in (
        ("h", len(NAMES), "the averaged restoring force h = H - A"),
        ("H", 3, "the averaged force H beside the vertical spring"),
    ):
        cheapest = averages.pair if letter == "h" else averages.horizontal
        if cheapest is None:
            continue
        for order in range(count):
            source = cheapest if order < cheapest.width else averages.whole
            text = slope[order] + what + "." if order else what[0].upper() + what[1:] + "."
            equation = "(20)-(22)" if order == 0 else "(31)" if order == 1 else "from (31)"
            result.append(Selection(letter + NAMES[order], source, (order,), text, equation, compiled))
    return result


def state_harmonics(of: Formulas, derived: OfMechanism) -> None:
    """The higher harmonics of the force and their derivatives, together."""
    listed = ", ".join(str(symbol) for family in OF_HARMONIC.values() for symbol in family)
    text = f"Higher harmonics of the force, as h is its first: {listed}."
    of.add(
        "harmonics",
        branches(derived.harmonics.cases),
        text,
        "beyond (20)",
        derived.harmonics.domain,
        arguments=(A,),
    )


def state_by_parameter(of: Formulas, derived: OfMechanism) -> None:
    """How the average changes with the parameters of the force."""
    text = "d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn."
    of.add(
        "by_parameter",
        branches(derived.by_parameter),
        text,
        "from (20)-(22), (31)",
        "A > 0",
        arguments=(A, *AVERAGED[:3]),
        looped=False,
    )


def state_force(of: Formulas, derived: OfMechanism) -> None:
    """The piecewise force out of its pieces; at a breakpoint the lower piece holds.

    Where that is steep beside the next, which it meets there, the next: a double next to the breakpoint is not at it.
    """
    mechanism = derived.oscillator.mechanism
    ends = derived.oscillator.breakpoints.values()
    guards = [*(((sp.Abs(u), end),) for end in ends), ()]
    pieces = [of.kernels[f"force_{k}"] for k in range(1, len(guards) + 1)]
    if is_spelled_out(derived):
        guards, pieces = [*(((end, sp.Abs(u)),) for end in ends), ()], pieces[::-1]
    cases = [
        replace(piece.branches[0], name=piece.name, guards=guard, kernel=piece.name)
        for guard, piece in zip(guards, pieces, strict=True)
    ]
    stands_for = ", truncated" if is_truncated(derived) else ", untruncated" if is_spelled_out(derived) else ""
    of.add(
        "force",
        cases,
        f"Whole dimensionless restoring force u + F_k(u){stands_for}.",
        of_pieces(derived),
        f"|u| < {mechanism.reach}" if is_spelled_out(derived) else "any u",
        arguments=(u,),
    )


def of_pieces(derived: OfMechanism) -> str:
    """The equations that the force is from."""
    return "(3), (6)" if is_truncated(derived) else "(3), (5)"


def odd(piece: sp.Expr) -> tuple[list[Let], sp.Expr]:
    """A polynomial piece, stated for u > 0, on both sides: even powers change their sign with u, which is a let."""
    side = sp.Symbol("side", real=True)
    terms = {power: coefficient * u**power for (power,), coefficient in sp.Poly(piece, u).terms()}
    even = sum((term for power, term in terms.items() if power % 2 == 0), sp.Integer(0))
    if even == 0:
        return [], sp.horner(piece, u)
    return [(side, copysign(1, u))], sp.horner(sp.expand(piece - even), u) + side * sp.horner(even, u)


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


def state_numbers(of: Formulas, derived: OfMechanism) -> None:
    """Parameters from the design, breakpoints, jumps, whether the force hardens, and its steps."""
    whole, ends, definitions = derived.whole, derived.oscillator.breakpoints, definitions_of(derived)
    state_data(
        of,
        tuple(parameter.symbol for parameter in derived.oscillator.mechanism.design),
        tuple(definitions[name] for name in of.parameters),
        tuple(ends.values()),
        whole.jumps,
        ends_by_design=[definitions[name] for name in derived.oscillator.mechanism.breakpoints],
        equations=("(5), (7)", "(5)", "(6)" if is_truncated(derived) else "(5)"),
    )
    if ends:
        of.kernels["breakpoints"] = replace(of.kernels["breakpoints"], arithmetics=("doubles", *OF_PROOFS))
    text = "The force over the displacement, f(u)/u, rises with |u| where none of these is negative."
    of.add("hardening", hardening(whole), text, "from (3)")
    if is_stepped(whole.pieces):
        state_steps(of, steps(whole.pieces, whole.breakpoints, whole.jumps), whole.pieces, whole.breakpoints)


def is_stepped(pieces: Sequence[sp.Expr]) -> bool:
    """Whether the force is a sum of steps in powers of u, and continuous at u = 0: then it is known off the centre."""
    return all(piece.is_polynomial(u) for piece in pieces) and pieces[0].subs(u, 0) == 0


def printed_pieces(derived: OfMechanism) -> Iterator[Printed]:
    """The pieces of the force and their slopes on both sides of u = 0."""
    for piece in derived.whole.pieces:
        lets, value = ([], evaluable(piece)) if is_spelled_out(derived) else odd(piece)
        roots, slope = force_slope(value)
        yield Printed(value, slope, (*lets, *roots))


def hardening(whole: Restoring) -> tuple[sp.Expr, ...]:
    """What must not be negative for f(u)/u to rise with |u|: the slope's terms piece by piece, then the jumps.

    Of a polynomial piece d/du (f/u) is the sum of (d - 1) c_d u^(d - 2). Others are u (a + b (1/sqrt(1 - u^2) - 1)).
    """
    terms: list[sp.Expr] = []
    for piece in whole.pieces:
        if piece.is_polynomial(u):
            terms += [c * sp.sign(d - 1) for (d,), c in reversed(sp.Poly(piece, u).terms()) if d != 1]
        else:
            terms.append(sp.factor(coefficients(piece)[1]))
    return (*(term for term in terms if term != 0), *(-jump for jump in whole.jumps if jump != 0))


def described(dimensionless: Dimensionless) -> tuple[Parameter, ...]:
    """The parameters of the kernels, each with one line and the unit of the dimensional quantity."""
    mechanism = dimensionless.mechanism
    known = {parameter.symbol: parameter for parameter in mechanism.design}
    several = len(mechanism.pieces) > 1
    result = []
    for number, names in enumerate(mechanism.coefficients, start=1):
        where = f"of piece {number} of the force" if several else "of the force"
        for power, name in names.items():
            unit = "k_v" if power == 1 else f"k_v/L^{power - 1}"
            doc = f"coefficient of u{f'^{power}' if power > 1 else ''} in the Taylor series {where}"
            result.append(known.get(name, Parameter(name, doc, unit)))
    ends = (
        Parameter(name, f"|u| at which piece {number} of the force ends", "L")
        for number, name in enumerate(() if mechanism.instead else mechanism.breakpoints, start=1)
    )
    return (*result, *ends, *(known[ratio] for ratio in mechanism.instead))


def scales(mechanism: Mechanism) -> tuple[Scale, ...]:
    """What the design's numbers are measured in."""
    from ...extensions.scaling import (
        of_design,  # here, not above: who derives a mechanism alone has no numbers in SI units
    )

    return of_design(mechanism)


def record(
    mechanisms: Mapping[str, OfMechanism], derived: OfMechanism, pieces: tuple[Law, ...], *, for_solvers: bool
) -> Record:
    """What the record says that no kernel does; `for_solvers` without scales, which no solver needs."""
    mechanism = derived.oscillator.mechanism
    truncated = is_truncated(derived)
    twins = [
        name
        for name, other in mechanisms.items()
        if truncated
        and other.oscillator.mechanism.order == sp.oo
        and other.oscillator.mechanism.pieces == mechanism.pieces
    ]
    return Record(
        mechanism,
        described(derived.oscillator),
        pieces,
        derived.harmonics.most,
        truncated,
        twins[0] if twins else "",
        () if for_solvers else scales(mechanism),
        is_stepped(derived.whole.pieces),
    )


def is_truncated(derived: OfMechanism) -> bool:
    """Whether a Taylor polynomial stands for the force."""
    order = derived.oscillator.mechanism.order
    forces = derived.oscillator.exact
    return order != sp.oo and not all(force.is_polynomial(u) and sp.degree(force, u) <= order for force in forces)


def state_resultants(of: Formulas, derived: OfMechanism) -> None:
    """Coefficients of the resultants, where there are any."""
    if not derived.saddle_nodes:
        return
    first = derived.whole.breakpoints[:1]
    # the resultants hold for the first regime: its breakpoint does not enter
    domain = f"roots with 0 < A <= {first[0]}" if first else "roots with A > 0"
    excess = sp.Symbol("excess", real=True)
    by_excess = {power: in_excess(value, excess) for power, value in derived.saddle_nodes.reduced.items()}
    of.add(
        "saddle_node_onset",
        derived.saddle_node_onset.by_even_power,
        "Reduced resultant of F_A and F_AA: coefficients of A^0, A^2, ...; its roots are candidates for the onset.",
        "(33)",
        domain,
        arguments=(m, zeta),
        returns="stack",
        in_python=False,
    )
    of.add(
        "saddle_nodes",
        Lets([(excess, (F_0 - m) * (F_0 + m))], replace(derived.saddle_nodes, reduced=by_excess).by_even_power),
        "Reduced resultant of F and F_A: coefficients of A^0, A^2, ...; its roots are candidates for folds.",
        "from (24), (30)",
        domain,
        arguments=(F_0, m, zeta),
        returns="stack",
        in_python=False,
    )


def in_excess(value: sp.Expr, excess: sp.Symbol) -> sp.Expr:
    """A polynomial in F_0^2 by what this exceeds m^2 by, of which it has high powers: it is small next to sticking."""
    terms = sp.Poly(value, F_0).terms()
    if any(power % 2 for (power,), _ in terms):
        raise ArithmeticError("a resultant that is not even in F_0")
    return sum(coefficient * (excess + m**2) ** (power // 2) for (power,), coefficient in terms)


def compositions(
    flow: Module, mechanism: Mechanism, average: Kernel | Selection, *, compiled: bool
) -> list[Composition]:
    """The slow flow's functions with the mechanism's h put in; m = 4 mu/pi."""
    by_name = {kernel.name: kernel for kernel in flow.kernels}
    result = []
    for name in COMPOSED:
        inner = by_name[name]
        own = [mu if argument == m else argument for argument in inner.arguments if argument not in AVERAGED]
        averages = [argument for argument in inner.arguments if argument in AVERAGED]
        if not set(averages) <= set(AVERAGED[: average.width]):
            raise ArithmeticError(f"{name} needs more derivatives of h than {average.name} gives")
        parameters = mechanism.parameters if averages else ()
        used = average if averages else None
        result.append(Composition(name, (*own, *parameters), inner, used, len(parameters), compiled or not averages))
    return result
