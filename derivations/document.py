"""The derivation of one mechanism as a document to read.

In:  a `Mechanism`, and its steps of the derivation.
Out: Markdown with LaTeX: equation of motion, force, parameters, slow flow, the average in each regime, response, folds.

What stands here is what `emit/` prints for programs, before its passes: the expressions are the same objects.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from .averaging import Averaged
from .mechanisms import DAMPING, FORCING, Parameter
from .restoring import Regime
from .results import OfMechanism
from .slow_flow import SlowFlow
from .slow_flow import m as friction
from .symbols import Omega, sigma, u

#: not more than
LESS = r"\le"


def document(derived: OfMechanism, equations: Averaged, flow: SlowFlow) -> str:
    """All of it, in the order in which it is derived."""
    mechanism = derived.oscillator.mechanism
    sections = (
        (mechanism.title[0].upper() + mechanism.title[1:], ()),
        ("Equation of motion", motion(derived)),
        ("Parameters", parameters(derived)),
        ("Slow flow", slow(equations, flow)),
        ("The average of the force", averages(derived)),
        ("Response and folds", response(flow)),
    )
    lines = []
    for number, (title, body) in enumerate(sections):
        lines += [f"{'##' if number else '#'} {title}", "", *body]
    return "\n".join(lines).rstrip() + "\n"


def display(*equations: tuple[str, sp.Expr | str], number: str = "") -> Iterator[str]:
    """Equations, one under the other, each with what stands on its left."""
    rows = [f"{left} &= {right if isinstance(right, str) else sp.latex(right)}" for left, right in equations]
    tag = f" \\tag{{{number}}}" if number else ""
    yield from ("$$", "\\begin{aligned}", " \\\\\n".join(rows), f"\\end{{aligned}}{tag}", "$$", "")


def motion(derived: OfMechanism) -> Iterator[str]:
    """(3), and the force piece by piece."""
    whole = derived.whole
    yield "With displacements in $L$, forces in $k_v L$ and time in $1/\\omega_n$, $\\omega_n^2 = k_v/m$:"
    yield ""
    yield from display(
        ("u'' + 2 \\zeta u' + \\mu\\, \\mathrm{sign}\\, u' + f(u)", "F_0 \\cos \\Omega\\tau"), number="3"
    )
    ends = [*map(sp.latex, whole.breakpoints), ""]
    yield "The force is odd. For $u > 0$:"
    yield ""
    for number, (piece, end) in enumerate(zip(whole.pieces, ends, strict=True), start=1):
        low, high = f"{ends[number - 2]} < " if number > 1 else "", rf" \le {end}" if end else ""
        where = rf"\quad {low}u{high}" if low or high else ""
        yield from display(("f(u)", sp.latex(sp.collect(sp.expand(piece), u)) + where))


def parameters(derived: OfMechanism) -> Iterator[str]:
    """The design's numbers with their domains, and what the force's coefficients are in them."""
    mechanism = derived.oscillator.mechanism
    yield from ("| number | measured in | what it is | allowed |", "|---|---|---|---|")
    for parameter in (*mechanism.design, *DAMPING, FORCING):
        unit = "" if parameter.unit == "1" else parameter.unit
        yield f"| ${sp.latex(parameter.symbol)}$ | {unit} | {parameter.doc} | {allowed(parameter)} |"
    yield ""
    given = {name: value for name, value in derived.oscillator.definitions.items() if name != value}
    if given:
        yield from display(*((sp.latex(name), value) for name, value in given.items()))


def allowed(parameter: Parameter) -> str:
    """A domain in words."""
    bounds = ((">", parameter.above), ("≥", parameter.least), ("<", parameter.below), ("≤", parameter.most))
    return ", ".join(f"{sign} {bound}" for sign, bound in bounds if bound is not None) or "any number"


def slow(equations: Averaged, flow: SlowFlow) -> Iterator[str]:
    """(11), (19), (23)."""
    yield r"With $u = A \cos\psi$, $u' = -A \Omega \sin\psi$, $\psi = \Omega\tau + \varphi$, averaged:"
    yield ""
    A_dot, A_phi_dot = (one.subs(sigma, Omega**2 - 1) for one in equations.slow_flow)
    yield from display(("A'", A_dot), ("A\\varphi'", A_phi_dot), number="19")
    yield "Steady states, with $h = H - A$ the negative average of the whole force:"
    yield ""
    yield from display(
        (sp.latex(friction), flow.m),
        ("R", flow.R),
        ("I", flow.I),
        ("0", "R^2 + I^2 - F_0^2"),
        number="23",
    )


def averages(derived: OfMechanism) -> Iterator[str]:
    """h and its slope in each regime."""
    whole = derived.whole
    yield from display(("h", "-\\frac{1}{\\pi} \\int_0^{2\\pi} f(A \\cos\\psi) \\cos\\psi \\, d\\psi"), number="20")
    regimes: Sequence[Regime] = whole.regimes
    for count, regime in enumerate(regimes):
        passed = [sp.latex(b) for b in whole.breakpoints[:count]]
        following = [sp.latex(b) for b in whole.breakpoints[count : count + 1]]
        if passed or following:
            yield f"For ${' < '.join([*passed[-1:], 'A'])}{''.join(rf' {LESS} {b}' for b in following)}$:"
            yield ""
        lets = [(sp.latex(symbol), value) for symbol, value in regime.lets]
        yield from display(*lets, ("h", regime.derivatives[0]), ("h_A", regime.derivatives[1]))


def response(flow: SlowFlow) -> Iterator[str]:
    """(24), (30), and the polynomials in Omega."""
    yield from display(("F", flow.F), ("F_A", flow.F_A), number="24, 30")
    yield r"A state is stable where $F_A > 0$; folds are where $F = F_A = 0$. Both are quartics in $\Omega$:"
    yield ""
    quartics = (("F + F_0^2", flow.response_quartic), ("F_A/2", flow.fold_quartic))
    yield from display(
        *((name, sp.Add(*(c * Omega**power for power, c in enumerate(quartic)))) for name, quartic in quartics)
    )
