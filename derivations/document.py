"""The derivation of one mechanism as a document to read.

In:  a `Mechanism`, and its steps of the derivation, or its `Quadrature`.
Out: a `Page`: equation of motion, force, parameters, slow flow, the average in each regime, response, folds.

What stands here is what `codegen/` prints for programs, before its passes: the expressions are the same objects.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import sympy as sp

from .asymmetric.sided import Sided
from .codegen.prose import Prose
from .forces.of_mechanism import OfMechanism
from .forces.quadrature import Quadrature, sums
from .kernels import Formulas
from .mechanisms import DAMPING, FORCING, Mechanism, Parameter
from .page import Block, Equations, Page, Table, display, latex
from .paper import critical_forcings
from .paper.averaging import Averaged
from .paper.critical_forcings import Elimination
from .paper.restoring_force import ORDERS, Regime
from .paper.slow_flow import coefficients
from .paper.slow_flow import m as friction
from .symbols import F_0, A, Omega, sigma, u

#: not more than
LESS = r"\le"


def document(derived: OfMechanism, equations: Averaged, flow: Formulas) -> Page:
    """All of it, in the order in which it is derived."""
    whole = derived.whole
    return in_sections(
        derived.oscillator.mechanism,
        motion(whole.pieces, whole.breakpoints),
        parameters(derived.oscillator.mechanism, derived.oscillator.definitions),
        averages(derived),
        equations,
        flow,
        of_resultants=eliminated(derived, flow),
    )


def document_of_quadrature(mechanism: Mechanism, average: Quadrature, equations: Averaged, flow: Formulas) -> Page:
    """The same for a force whose average is a quadrature."""
    return in_sections(
        mechanism,
        motion(average.pieces, tuple(average.breakpoints)),
        parameters(mechanism, average.breakpoints),
        integrals(average),
        equations,
        flow,
    )


def document_of_sided(force: Sided, equations: Averaged, flow: Formulas) -> Page:
    """The same for a force that is not odd."""
    own = motion_of_sided(force), parameters(force, {}), balance(force)
    return in_sections(force, *own, equations, flow, displacement=r"B + A \cos\psi")


def motion_of_sided(force: Sided) -> Iterator[Block]:
    """The force piece by piece, for all u."""
    yield "The force is not odd:"
    yield from in_pieces(force.pieces, force.ends)


def balance(force: Sided) -> Iterator[Block]:
    """The mean of the force and h by the means over its steps."""
    yield r"The load $p$ equals the mean of the force. Means over $\psi$ are denoted by $\langle\cdot\rangle$:"
    of_motion = r"\langle f(B + A \cos\psi)"
    yield display(
        ("f_0", rf"{of_motion} \rangle - p = 0"),
        ("h", rf"-2 {of_motion} \cos\psi \rangle"),
    )
    yield "In $F_A$ below, $h_A$ is the derivative along $f_0 = 0$."
    if force.is_polynomial:
        yield (
            "Beyond the end $b$ of a piece the force of that piece changes by\n"
            r"$\sum D_k (u - b)^k/k!$, which adds to the means over the $\psi$ for which $u$ is beyond $b$:"
        )
        gains = force.steps[len(force.pieces) :]
    else:
        yield (
            "At the end $b$ of a piece the force jumps by $D_0$, its slope by $D_1$. The means of $D_0 + D_1 (u - b)$\n"
            r"over the $\psi$ for which $u$ is beyond $b$ are closed. The rest has a continuous slope and is summed:"
        )
        gains = tuple(row[:2] for row in force.curved.gains)
    for end, row in zip(force.ends, gains, strict=True):
        yield display(
            *((rf"D_{order}\big|_{{u = {latex(end)}}}", value) for order, value in enumerate(row) if value != 0)
        )


def in_sections(
    mechanism: Mechanism | Sided,
    of_motion: Iterator[Block],
    of_parameters: Iterator[Block],
    of_average: Iterator[Block],
    equations: Averaged,
    flow: Formulas,
    displacement: str = r"A \cos\psi",
    of_resultants: Iterable[Block] = (),
) -> Page:
    """The page; resultants where there are any."""
    sections = {
        "Equation of motion": (*equation_of_motion(), *of_motion),
        "Parameters": tuple(of_parameters),
        "Slow flow": tuple(slow(equations, flow, displacement)),
        "The average of the force": tuple(of_average),
        "Response and folds": tuple(response(flow)),
    }
    if elimination := tuple(of_resultants):
        sections["Resultants"] = elimination
    return Page(Prose(mechanism.title[0].upper() + mechanism.title[1:]), sections)


def motion(pieces: Sequence[sp.Expr], breakpoints: Sequence[sp.Symbol]) -> Iterator[Block]:
    """The force piece by piece."""
    yield "The force is odd. For $u > 0$:"
    yield from in_pieces(pieces, breakpoints)


def in_pieces(pieces: Sequence[sp.Expr], breakpoints: Sequence[sp.Expr]) -> Iterator[Block]:
    """Each piece with the u between which it is."""
    ends = [*map(latex, breakpoints), ""]
    for number, (piece, end) in enumerate(zip(pieces, ends, strict=True), start=1):
        low, high = f"{ends[number - 2]} < " if number > 1 else "", rf" {LESS} {end}" if end else ""
        where = rf"\quad {low}u{high}" if low or high else ""
        shown = sp.collect(sp.expand(piece), u) if piece.is_polynomial(u) else piece
        yield display(("f(u)", latex(shown) + where))


def equation_of_motion() -> Iterator[Block]:
    """(3)."""
    yield "Displacements are in units of $L$, forces of $k_v L$ and times of $1/\\omega_n$, with $\\omega_n^2 = k_v/m$:"
    yield display(("u'' + 2 \\zeta u' + \\mu\\, \\mathrm{sign}\\, u' + f(u)", "F_0 \\cos \\Omega\\tau"), number="3")


def parameters(mechanism: Mechanism | Sided, definitions: Mapping[sp.Symbol, sp.Expr]) -> Iterator[Block]:
    """The design's numbers with their domains, and what coefficients and breakpoints are in them."""
    rows = tuple(
        (f"${latex(one.symbol)}$", Prose("" if one.unit == "1" else one.unit), Prose(one.doc), allowed(one))
        for one in (*mechanism.design, *DAMPING, FORCING)
    )
    yield Table(("symbol", "scale", "meaning", "domain"), rows)
    formulas = {name: value for name, value in definitions.items() if name != value}
    if formulas:
        yield display(*((latex(name), value) for name, value in formulas.items()))


def allowed(parameter: Parameter) -> str:
    """A domain."""
    bounds = ((">", parameter.above), (r"\ge", parameter.least), ("<", parameter.below), (LESS, parameter.most))
    stated = (f"${sign} {latex(sp.sympify(bound))}$" for sign, bound in bounds if bound is not None)
    return ", ".join(stated) or "any number"


def slow(equations: Averaged, flow: Formulas, displacement: str) -> Iterator[Block]:
    """(11), (19), (23)."""
    yield rf"With $u = {displacement}$, $u' = -A \Omega \sin\psi$, $\psi = \Omega\tau + \phi$, averaging gives:"
    A_dot, A_phi_dot = (one.subs(sigma, Omega**2 - 1) for one in equations.slow_flow)
    yield display(("A'", A_dot), ("A\\phi'", A_phi_dot), number="19")
    yield "Steady states satisfy these equations, where $h = H - A$ is the negative average of the whole force:"
    yield display(
        (latex(friction), flow.friction),
        ("R", flow.R),
        ("I", flow.I),
        ("0", "R^2 + I^2 - F_0^2"),
        number="23",
    )


def average(integral: str = "") -> Equations:
    """(20)."""
    definition = "-\\frac{1}{\\pi} \\int_0^{2\\pi} f(A \\cos\\psi) \\cos\\psi \\, d\\psi"
    return display(("h", definition + integral), number="20")


def regime_of(breakpoints: Sequence[sp.Symbol], count: int) -> Iterator[Block]:
    """Which amplitudes exceed that many breakpoints; nothing where there are none."""
    passed = [latex(b) for b in breakpoints[:count]]
    following = [latex(b) for b in breakpoints[count : count + 1]]
    if passed or following:
        yield f"For ${' < '.join([*passed[-1:], 'A'])}{''.join(rf' {LESS} {b}' for b in following)}$:"


def integrals(average_: Quadrature) -> Iterator[Block]:
    """h and its slopes by integrals over the quarter cycle, and what moving angles add."""
    yield average(r" = -\frac{4}{\pi} \int_0^{\pi/2} f(A \sin t) \sin t \, dt")
    yield "Derivatives are taken under the integral, and the integrals are computed by Gauss's rule, piece by piece:"
    orders = range(ORDERS + 1)
    names = [f"\\Sigma_{order}" for order in orders]
    slopes = ("f", "f'", "f''", "f'''")
    values = [rf"\int_0^{{\pi/2}} {slopes[order]}(A \sin t) \sin^{order + 1} t \, dt" for order in orders]
    yield display(*zip(names, values, strict=True))
    for number in range(len(average_.contacts)):
        yield from contact(average_, number)
        names += [contact_sum(number, order) for order in orders]
    shown = {symbol: sp.Symbol(name) for symbol, name in zip(sums(len(names)), names, strict=True)}
    breakpoints = tuple(average_.breakpoints)
    for count in range(len(average_.pieces)):
        yield from regime_of(breakpoints, count)
        regime = average_.regime(count)
        roots = [(latex(symbol), value) for symbol, value in regime.lets if symbol not in average_.breakpoints]
        closed = zip(("h", "h_A", "h_{AA}", "h_{AAA}"), regime.averaged, strict=True)
        yield display(*roots, *((name, value.subs(shown)) for name, value in closed))


def contact(average_: Quadrature, number: int) -> Iterator[Block]:
    """The integrals of what begins as a broken power."""
    one = average_.contacts[number]
    b = latex(tuple(average_.breakpoints)[one.begins - 1])
    part, power = latex(one.force), latex(one.exponent)
    yield f"There $f$ excludes the fractional power that begins at ${b}$:"
    yield display((f"f_{{{number + 1}}}(u)", part))
    yield f"This term is differentiated at a fixed fraction $y$ of $A - {b}$, with $u = {b} + (A - {b}) y$:"
    under = (
        rf"\frac{{f_{{{number + 1}}}(u)}}{{(A - {b})^{{{latex(one.power)}}}}} \frac{{u}}{{A}} "
        rf"\sqrt{{\frac{{A + {b}}}{{A + u}}}}"
    )
    before = rf"\frac{{(A - {b})^{{{power}}}}}{{\sqrt{{A + {b}}}}}"
    values = [
        (
            contact_sum(number, order),
            rf"{before} \int_0^1 \frac{{\partial^{order}}}{{\partial A^{order}}} "
            rf"\left({under}\right) \frac{{dy}}{{\sqrt{{1 - y}}}}",
        )
        for order in range(ORDERS + 1)
    ]
    yield display(*values)


def contact_sum(number: int, order: int) -> str:
    """The name of such an integral."""
    return rf"\Gamma_{{{number + 1},{order}}}"


def averages(derived: OfMechanism) -> Iterator[Block]:
    """h and its slope in each regime."""
    whole = derived.whole
    yield average()
    regimes: Sequence[Regime] = whole.regimes
    for count, regime in enumerate(regimes):
        yield from regime_of(whole.breakpoints, count)
        lets = [(latex(symbol), value) for symbol, value in regime.lets]
        yield display(*lets, ("h", regime.derivatives[0]), ("h_A", regime.derivatives[1]))


def response(flow: Formulas) -> Iterator[Block]:
    """(24), (30), and the polynomials in Omega."""
    yield display(("F", flow.F), ("F_A", flow.F_A), number="24, 30")
    yield (
        r"A state is stable if $F_A > 0$. At a fold, $F = F_A = 0$. Both functions are polynomials of degree 4 in "
        r"$\Omega$:"
    )
    quartics = (("F + F_0^2", flow.F + F_0**2), ("F_A/2", flow.F_A / 2))
    by_power = [(name, coefficients(value.subs(flow.lets), 4)) for name, value in quartics]
    powers = (0, 1, 2, 4)
    yield display(
        *((name, sp.Add(*(c * Omega**n for n, c in zip(powers, values, strict=True)))) for name, values in by_power)
    )


#: the highest power of A in h up to which Omega is eliminated: some seconds
MOST_ELIMINATED = 7


def eliminated(derived: OfMechanism, flow: Formulas) -> Iterator[Block]:
    """(33), (34) and folds at a forcing by elimination of Omega, where h is a polynomial."""
    whole = derived.whole
    first = whole.regimes[0].derivatives[0]
    degree = sp.degree(first, A) if first.has(A) else 0
    # of even powers h has multiples of 1/pi: elimination takes rational numbers
    if 1 < degree <= MOST_ELIMINATED and not first.has(sp.pi):
        yield (
            "Up to the first breakpoint, if any, $h$ is a polynomial in $A$, and $\\Omega$ can be eliminated.\n"
            "Elimination adds roots, so each root must be checked in the original equations.\n"
            "Folds at a given force satisfy $F = F_A = 0$:"
        )
        yield polynomial(critical_forcings.saddle_nodes(flow, whole), "a")
        yield "Two folds appear where $F_A = F_{AA} = 0$, at a candidate for the lowest force with a fold:"
        yield polynomial(critical_forcings.saddle_node_onset(flow, whole), "b", number="33")
    if whole.breakpoints:
        yield f"At the lowest force that reaches $A = {latex(whole.breakpoints[0])}$, $F = F_\\Omega = 0$:"
        yield polynomial(critical_forcings.detachment(flow), "d", number="34")


def polynomial(found: Elimination, letter: str, number: str = "") -> Equations:
    """A resultant without its trivial factors, by its coefficients."""
    unknown = latex(found.unknown)
    terms = (f"{letter}_{{{power}}}" + (f" {unknown}^{{{power}}}" if power else "") for power in found.reduced)
    values = ((f"{letter}_{{{power}}}", value) for power, value in found.reduced.items())
    return display(("0", " + ".join(terms)), *values, number=number)
