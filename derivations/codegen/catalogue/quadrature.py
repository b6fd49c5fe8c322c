"""The kernels of a mechanism whose average is a quadrature: integrands, what stands around them, the force, its data.

In:  a `Mechanism` and its `Quadrature`.
Out: `quadrature_module`.

The parameters are the design's numbers, and nothing is named between: a force of any kind has no coefficients. Their
names are users', so kernels have them with a line behind them, which nothing else in printed code has.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from ...asymmetric.curved import of_odd
from ...asymmetric.off_centre import steps
from ...extensions.second_approximation import OF_HARMONIC
from ...forces.contact import Contact, y
from ...forces.quadrature import BROKEN, DENSE, Quadrature, c, s, sums, v
from ...kernels import Branch, Formulas, Kernel, Let, Lets
from ...mechanisms import UNIT, Mechanism
from ...paper.restoring_force import ORDERS
from ...symbols import A, u
from ..compensated import copysign
from ..form import AVERAGED, Enclosed, Module, Record, Sums
from .force import Printed, formulas, state_data, state_pieces, state_steps
from .mechanism import INTERCEPT, is_stepped
from .sided import state_curved

#: of an odd force that is stated for u > 0
SIDE, SIZE = sp.Symbol("side", real=True), sp.Symbol("size", nonnegative=True)
SIDES = ((SIDE, copysign(1, u)), (SIZE, sp.Abs(u)))


def quadrature_module(name: str, mechanism: Mechanism, average: Quadrature) -> Module:
    """The module of one mechanism that is stated in a program."""
    stated = mechanism
    mechanism, average = renamed(mechanism, average)
    of = formulas(mechanism.parameters)
    state_numbers(of, mechanism, average)
    laws = state_pieces(of, name, printed_pieces(average), "(3), (5)")
    curved = of_odd(average, mechanism.parameters)
    terms = None if curved is None else state_curved(of, curved)
    averages = (*average_sums(of, average), parameter_sums(of, average))
    return Module(
        name=name,
        title=stated.title[0].upper() + stated.title[1:],
        inputs=("runtime.py", "forces/quadrature.py", *(["asymmetric/curved.py"] if terms else [])),
        stated=tuple(of.kernels.values()),
        record=Record(stated, stated.design or (UNIT,), laws, sp.oo, False, "", (), stepped=is_stepped(average.pieces)),
        native=False,
        sums=averages,
        enclosed=enclosed(mechanism, average),
        off_centre=terms,
    )


def renamed(mechanism: Mechanism, average: Quadrature) -> tuple[Mechanism, Quadrature]:
    """The same with the parameters as kernels call them."""
    names = {old: sp.Symbol(f"{old.name}_", **old.assumptions0) for old in mechanism.parameters}
    design = tuple(replace(parameter, symbol=names[parameter.symbol]) for parameter in mechanism.design)
    pieces = tuple(piece.xreplace(names) for piece in average.pieces)
    ends = {name: end.xreplace(names) for name, end in average.breakpoints.items()}
    return replace(mechanism, design=design, instead=tuple(names.values())), Quadrature(pieces, ends)


def average_sums(of: Formulas, average: Quadrature) -> tuple[Sums, ...]:
    """`averaged`, `intercept` and `harmonics`."""
    regimes = [average.regime(count) for count in range(len(average.pieces))]
    listed = ", ".join(str(symbol) for family in OF_HARMONIC.values() for symbol in family)
    found = []
    for number, (name, doc, equation) in enumerate(
        (
            ("averaged", ", ".join(map(str, AVERAGED)) + " together.", "(20)-(22), (31)"),
            ("intercept", INTERCEPT, "from (20)"),
            ("harmonics", f"Higher harmonics of the force, as h is its first: {listed}.", "beyond (20)"),
        )
    ):
        of_pieces = [average.integrands(piece)[number] for piece in average.from_begin]
        of_contacts = [average.of_contact(contact)[number] for contact in average.contacts]
        terms = under_the_integrals(of, name, equation, average, of_pieces, of_contacts)
        outputs = [(one.averaged, (one.intercept,), one.harmonics)[number] for one in regimes]
        cases = branches(average, [(one.lets, values) for one, values in zip(regimes, outputs, strict=True)])
        closing = closed(of, name, terms, cases, equation, "A >= 0")
        scalar = name == "intercept"
        found.append(Sums(name, terms, closing, doc, equation, graded(average), begins(average), scalar))
    return tuple(found)


def under_the_integrals(
    of: Formulas,
    name: str,
    equation: str,
    average: Quadrature,
    of_pieces: Sequence[tuple[sp.Expr, ...]],
    of_contacts: Sequence[tuple[sp.Expr, ...]],
) -> tuple[Kernel, ...]:
    """The kernels of integrands, one for each piece and for each contact: to the sums of the others these add 0.

    The sums of the pieces come first, then those of each contact.
    """
    own = len(of_pieces[0])
    width = own + sum(map(len, of_contacts))
    listed = [
        (f"{name}_terms_{k}", f"piece {k} of the force", values, 0, []) for k, values in enumerate(of_pieces, start=1)
    ]
    for k, (contact, values) in enumerate(zip(average.contacts, of_contacts, strict=True), start=1):
        what = f"what begins with piece {contact.begins + 1} as a power {contact.power}"
        listed.append((f"{name}_contact_{k}", what, values, own, contact.lets))
        own += len(values)
    for called, what, values, first, lets in listed:
        of.add(
            called,
            Lets(lets, (*(sp.Integer(0),) * first, *values, *(sp.Integer(0),) * (width - first - len(values)))),
            f"Under the integrals of `{name}` on {what}, which u = A sine is beyond the begin of.",
            equation,
            "where the piece holds",
            arguments=(v, s, c),
            generic=True,
        )
    return tuple(of.kernels[called] for called, *_ in listed)


def closed(
    of: Formulas, name: str, terms: Sequence[Kernel], cases: Sequence[Branch], equation: str, domain: str
) -> Kernel:
    """The kernel that closes these integrals."""
    text, integrals = f"`{name}` in the sums of its integrals over the pieces.", sums(terms[0].width)
    of.add(f"{name}_of", cases, text, equation, domain, arguments=(A, *integrals), returns="tuple")
    return of.kernels[f"{name}_of"]


def graded(average: Quadrature) -> tuple[int, ...]:
    """Of each piece and each contact."""
    first = BROKEN if average.is_broken else DENSE
    return (first, *(DENSE,) * (len(average.pieces) - 1), *(BROKEN,) * len(average.contacts))


def begins(average: Quadrature) -> tuple[int, ...]:
    """The number of the breakpoint at which each contact begins, from 0 on."""
    return tuple(contact.begins - 1 for contact in average.contacts)


def parameter_sums(of: Formulas, average: Quadrature) -> Sums:
    """How h, h_A and h_AA change with each parameter."""
    parameters = of.parameters
    doc, equation = "d/dp of h, h_A and h_AA at a fixed A, for each parameter p in turn.", "from (20)-(22), (31)"
    of_pieces = [
        tuple(value for parameter in parameters for value in average.changes(k, parameter))
        for k in range(len(average.pieces))
    ]
    of_contacts = [
        tuple(value for parameter in parameters for value in average.changes_of(contact, parameter))
        for contact in average.contacts
    ]
    terms = under_the_integrals(of, "by_parameter", equation, average, of_pieces, of_contacts)
    cases, wide = [], 3 * len(parameters)
    offsets = [wide * k for k in range(1, len(average.contacts) + 1)]
    for count in range(len(average.pieces)):
        values = [
            average.changed(count, parameter, 3 * place, [first + 3 * place for first in offsets])
            for place, parameter in enumerate(parameters)
        ]
        cases.append((average.regime(count).lets, tuple(value for one in values for value in one)))
    closing = closed(of, "by_parameter", terms, branches(average, cases), equation, "A > 0")
    return Sums("by_parameter", terms, closing, doc, equation, graded(average), begins(average), unused=AVERAGED[:3])


def branches(average: Quadrature, cases: list[tuple[tuple[Let, ...], tuple[sp.Expr, ...]]]) -> tuple[Branch, ...]:
    """One for each number of breakpoints that the amplitude exceeds."""
    ends = [*average.breakpoints.values()]
    return tuple(
        Branch(
            f"passed_{count}" if ends else "",
            ((A, ends[count]),) if count < len(ends) else (),
            lets,
            outputs,
            passed=count,
        )
        for count, (lets, outputs) in enumerate(cases)
    )


def state_numbers(of: Formulas, mechanism: Mechanism, average: Quadrature) -> None:
    """Parameters from the design, breakpoints, jumps, kinks, and of polynomials the steps."""
    design = tuple(parameter.symbol for parameter in mechanism.design)
    ends, jumps = tuple(average.breakpoints.values()), tuple(lost[0] for lost in average.losses)
    state_data(of, design, design or (sp.Integer(1),), ends, jumps, equations=("(4)", "(5)", "(5)"))
    of.add("hardening", (sp.Integer(-1),), "The force over the displacement, f(u)/u, is not known to rise.", "from (3)")
    state_kinks(of, average)
    if is_stepped(average.pieces):
        state_steps(of, steps(average.pieces, ends, jumps), average.pieces, ends)


def state_kinks(of: Formulas, average: Quadrature) -> None:
    """What tells where derivatives of h are infinite above a breakpoint."""
    text = "What its slope and its curvature lose at each breakpoint, as broken powers about them do too."
    of.add("kinks", tuple(value for lost in average.kinks for value in lost), text, "(5)")


def printed_pieces(average: Quadrature) -> Iterator[Printed]:
    """The pieces of the force and their slopes on both sides of u = 0."""
    for k, piece in enumerate(average.pieces):
        contacts = [contact for contact in average.contacts if contact.begins == k]
        yield from_contact(average.smooth[k], contacts) if contacts else on_both_sides(piece)


def on_both_sides(piece: sp.Expr) -> Printed:
    """A piece and its slope, stated for u > 0: as it is where it is odd, by the size of u and its side elsewhere."""
    inclined = sp.powsimp(sp.diff(piece, u))
    if sp.expand(piece.subs(u, -u) + piece) == 0:
        return Printed(piece, inclined)
    return Printed(SIDE * piece.subs(u, SIZE), inclined.subs(u, SIZE), SIDES)


def from_contact(smooth: sp.Expr, contacts: Sequence[Contact]) -> Printed:
    """The same of a piece with contacts, which are 0 below where they begin: integrators step there."""
    (begin,) = {contact.begin for contact in contacts}
    excess = SIZE - begin
    touching = sp.Add(*(v**contact.power * contact.factor for contact in contacts))
    inclined = sp.diff(smooth, u).subs(u, SIZE) + sp.powsimp(sp.expand(sp.diff(touching, v)))
    lets = (*SIDES, (v, (excess + sp.Abs(excess, evaluate=False)) / 2))
    return Printed(SIDE * (smooth.subs(u, SIZE) + touching), inclined, lets, begin)


def enclosed(mechanism: Mechanism, average: Quadrature) -> Enclosed:
    """What holds h and h_AAAA on an interval of amplitudes."""
    of = formulas(mechanism.parameters)
    about = ("(20), (31)", "on intervals")
    for k, piece in enumerate(average.from_begin, start=1):
        text = (
            f"Under the integrals of h and h_AAAA on piece {k} of the force, which u = A sine is beyond the begin of."
        )
        of.add(f"enclosed_terms_{k}", average.bent(piece), text, *about, arguments=(A, v, s), generic=True)
    terms = tuple(of.kernels.values())
    for k, contact in enumerate(average.contacts, start=1):
        of.add(
            f"enclosed_contact_{k}",
            Lets(contact.lets_between, contact.between),
            f"Over dy/sqrt(1 - y), what begins with piece {contact.begins + 1} as a power {contact.power}, and four "
            "derivatives; y is the share of what A exceeds its begin by.",
            *about,
            arguments=(A, y),
            generic=True,
        )
    contacts = tuple(of.kernels.values())[len(terms) :]
    integrals = sums(2 + sum(contact.width for contact in contacts))
    for count in range(len(average.pieces)):
        known = dict(list(average.breakpoints.items())[:count])
        numbers = {b: value for b, value in known.items() if value.is_number}
        lets = [(b, value) for b, value in known.items() if b not in numbers and b != value]
        roots = (sp.Symbol(f"root_{k}", nonnegative=True) for k in range(1, count + 1))
        of.add(
            f"enclosed_of_{count}",
            Lets(lets, tuple(value.xreplace(numbers) for value in average.bends(count))),
            f"h and h_A{'A' * ORDERS} in the integrals and sqrt(A^2 - b^2), beyond {count} breakpoints.",
            *about,
            arguments=(A, *roots, *integrals),
            generic=True,
        )
    closing = tuple(of.kernels.values())[len(terms) + len(contacts) :]
    return Enclosed(terms, closing, contacts, begins(average))
