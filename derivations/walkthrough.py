"""The paper, equation by equation: `python -m derivations.walkthrough` prints it as Markdown with LaTeX.

In:  the derivation of the paper's isolator, and the published formulas (`ledger/published.py`).
Out: for each equation in the paper's order: how it follows, as it is published, as it is derived, the proof that both
     are one, and the verdict; then the numbers of Tables 1 and 2.

Nothing is derived here: `paper/` derives, `ledger/` judges.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from .codegen.prose import in_markdown
from .ledger import balls, entries, published
from .ledger.facts import Facts
from .ledger.findings import check_averages, check_formulas
from .ledger.render import CITATION
from .ledger.rows import DIFFERS, IDENTICAL, Row
from .mechanisms import rod_spring
from .page import display, latex
from .results import derive

BEGIN = f"""# The derivation, equation by equation

These pages derive the equations of the paper, from the equation of motion (1) to the force F_SN = 0.0217 at which jumps
begin. The paper is {CITATION}.

Each equation is shown as published, and also as derived if the form differs. The verdict in bold states whether both
agree. In a proof, published minus derived is written as a quotient of polynomials over the rationals, with the
relations sin² + cos² = 1 and (√e)² = e. The equations agree if the numerator is the zero polynomial. The published
equations are typed by hand, including errors, in `ledger/published.py`, which shares nothing with the derivation.
"""


@dataclass(frozen=True)
class Section:
    """What the paper derives in one go: a title, the module that derives it, and how each equation follows."""

    title: str
    module: str
    steps: dict[str, str]


SECTIONS = (
    Section(
        "The oscillator",
        "equation_of_motion",
        {
            "(1)": "The equation of motion of a mass m on a vertical spring k_v with viscous damping c, dry friction "
            "F_c and a harmonic force.",
            "(2)": "The force of λ springs of stiffness k_h, compressed by Δh, that push horizontally on a rod of "
            "length L. They detach from the rod when they reach their free length.",
            "(3)": "Equation (1) with x = L u and the time in units of 1/ω_n, divided by k_v L.",
            "(4)": "The definitions of the quantities in (3).",
            "(5)": "The force (2) divided by k_v L, and the displacement u at which the springs detach.",
            "(6)": "The Taylor polynomial of fifth order of (5) up to u_cr. It is not zero there, so the force jumps.",
            "(7)": "The coefficients of (6) are derivatives of (5) at u = 0.",
        },
    ),
    Section(
        "Averaging",
        "averaging",
        {
            "(8)": "Equation (3) with small damping, friction, force and nonlinearity, near Ω = 1.",
            "(9)": "The small terms of (8) are all terms except the inertia term and Ω²u.",
            "(10)": "The small parameter ε: quantities with a bar are ε times those without, and Ω² = 1 + εσ.",
            "text after (10)": "The small terms G are periodic in τ, with the period T.",
            "(11)": "The assumed motion is a cosine whose amplitude and phase vary slowly.",
            "text after (11)": "The angle ψ of this motion.",
            "(12)": "The derivative of u = A cos ψ, with slowly varying A and φ.",
            "(13)": "The condition for (12) to take the form of (11).",
            "(14)": "The derivative of u' = −AΩ sin ψ.",
            "(15)": "Equation (8) after insertion of (14).",
            "(16)": "Equations (13) and (15) are linear in A' and Aφ'.",
            "(17)": "The solution of (16).",
            "(18)": "A and φ change little during a cycle, so the right-hand sides are replaced by their means over a "
            "cycle.",
            "(19)": "The integrals of (18). Friction is integrated over half-cycles, because u' changes its sign at "
            "ψ = π: the mean of −μ sign(u') sin ψ equals that of μ|sin ψ|. From here on ε = 1.",
        },
    ),
    Section(
        "The averaged restoring force",
        "restoring_force",
        {
            "(20)": "The contribution of the horizontal springs to (19), a function of the amplitude. In (19), (21) "
            "and (22) its prefactor is −1/π.",
            "(21)": "The integral (20) for A ≤ u_cr. The springs never detach, so powers of the cosine are integrated "
            "over the whole cycle.",
            "text before (22)": "For A > u_cr the springs detach twice in a cycle, at u = ±u_cr. ψ_0 is the angle at "
            "which u = u_cr.",
            "(22)": "The integral (20) for A > u_cr, over the intervals in which |u| < u_cr.",
        },
    ),
    Section(
        "The slow flow",
        "slow_flow",
        {
            "(23)": "The fixed points of (19), A' = φ' = 0. With H = h + A, R = AΩ² + h and I = 2ζAΩ + 4μ/π, they "
            "satisfy I + F_0 sin φ = 0 and R + F_0 cos φ = 0.",
            "(24)": "The response: sin² + cos² = 1 eliminates φ, which gives R² + I² = F_0². The derived form is not "
            "expanded, as digits cancel in the expanded form.",
            "(25)": "The phase: the quotient of both equations of (23).",
            "(26)": "The backbone: cos φ = 0, thus R = 0.",
            "(27)": "The limit envelope: sin φ = −1, thus I = F_0.",
            "text after (27)": "The force at which A_L = 0. Below this force the mass sticks.",
        },
    ),
    Section(
        "Stability",
        "slow_flow",
        {
            "(28)": "The Jacobian: (19) differentiated with respect to A and φ, with sin φ and cos φ from (23).",
            "(29)": "The eigenvalues of the Jacobian. Its trace is negative, so a fixed point is stable if the "
            "determinant is positive.",
            "(30)": "The boundary of stability. Since 4Ω² det D_qΓ = F_A/(2A), the response has a vertical tangent "
            "there.",
            "(31)": "The derivative of H_2 in (30), taken under the integral (20). The limits of integration depend on "
            "A, which adds the jump of the force.",
            "(32)": "Abbreviations used in (31).",
        },
    ),
    Section(
        "Critical forcings",
        "critical_forcings",
        {
            "(33)": "The onset: two folds appear where F_A = F_AA = 0. For A ≤ u_cr both are polynomials in Ω and A, "
            "and the resultant eliminates Ω. Its roots are candidates, which must be checked in both equations.",
            "(34)": "Detachment: at the lowest force that reaches A = u_cr, F = F_Ω = 0. The resultant eliminates Ω.",
            "text after (34)": "The preload at which the stiffness α is zero.",
        },
    ),
    Section(
        "Den Hartog's solution, equivalent damping",
        "den_hartog",
        {
            "(35)": "Den Hartog's amplitude. Without horizontal springs and viscous damping, the motion between two "
            "turning points is linear, and four conditions at its ends give its four constants.",
            "(36)": "The least amplitude at which the mass does not stop within the half-cycle, so that u' < 0 "
            "throughout.",
            "(37)": "The functions in (35) and (36).",
            "text of Section 4.1": "The sticking condition as a ratio of friction to force.",
            "(38)": "The viscous damping ratio that has the dissipative term of (23).",
            "text of Section 4.2": "The limit of (34) as the preload, and with it u_cr, tends to 0.",
        },
    ),
)

#: what stands on the left of an equation, one for each expression; those without one are relations, = 0. Where the
#: expression is not all of the right side, %s stands for it
LEFT = {
    "F_k_dimensional": (r"F_k(x)\big|_{|x| \le x_{cr}}", r"F_k(x)\big|_{|x| > x_{cr}}"),
    "x_cr": ("x_{cr}",),
    "F_k": (r"F_k(u)\big|_{|u| \le u_{cr}}", r"F_k(u)\big|_{|u| > u_{cr}}"),
    "u_cr": ("u_{cr}",),
    "F_k_taylor": (r"F_k(u)\big|_{|u| \le u_{cr}}", r"F_k(u)\big|_{|u| > u_{cr}}"),
    "alpha": (r"\alpha",),
    "beta": (r"\beta",),
    "gamma": (r"\gamma",),
    "G": ("G",),
    "period": ("T",),
    "first_order_solution": ("u", "u'"),
    "psi": (r"\psi",),
    "modulation": ("A'", r"A \phi'"),
    "averaged_modulation_integrand": (r"A' = \int_0^{2\pi} %s \, d\psi", r"A \phi' = \int_0^{2\pi} %s \, d\psi"),
    "Gamma": ("A'", r"A \phi'"),
    "H_i_integrand_minus": (r"H_i = \int_0^{2\pi} %s \, d\psi",),
    "H_i_integrand_plus": (r"H_i = \int_0^{2\pi} %s \, d\psi",),
    "H_1": ("H_1",),
    "H_2": ("H_2",),
    "F": ("F",),
    "tan_phi": (r"\tan\phi",),
    "A_L": ("A_L",),
    "F_0_sticking": ("F_0",),
    "D_q_Gamma": tuple(f"(D_q \\Gamma)_{{{row}{column}}}" for row in (1, 2) for column in (1, 2)),
    "dH_2_dA_inverse_A": (r"\frac{\partial H_2}{\partial A}",),
    "p": ("p",),
    "q": ("q",),
    "psi_0": (r"\psi_0",),
    "delta_h_qzs_inverse": (r"\delta_h",),
    "A_den_hartog": ("A",),
    "A_stick_slip": (r"A_{\min}",),
    "V": ("V",),
    "U": ("U",),
    "S_maximand_minus_minus": (r"S = \max_\tau %s",),
    "mu_over_F_0_sticking": (r"\mu/F_0",),
    "zeta_eq": (r"\zeta_{eq}",),
    "F_cr_limit_literal": ("F_{cr}",),
}

#: numbers of the paper's example that the equations above give, in their order
NUMBERS = ("u_cr", "F_cr", "Omega_cr", "F_SN", "Omega_SN", "A_SN")


def walkthrough(facts: Facts) -> str:
    """All of it. Call it at the ledger's precision. A formula that is not as published raises, with its equation."""
    rows = entries.formula_rows(facts)
    check_formulas(rows)
    check_averages(facts)
    lines = [BEGIN]
    for number, section in enumerate(SECTIONS, start=1):
        lines += [f"## {number}. {section.title}", "", f"Derived in `derivations/paper/{section.module}.py`.", ""]
        for where, step in section.steps.items():
            lines += [f"### {where[0].upper()}{where[1:]}", "", in_markdown(step), ""]
            lines += equations(where, [row for row in rows if row.where == where], facts)
    return "\n".join([*lines, *numbers(facts)]).rstrip() + "\n"


def equations(where: str, rows: list[Row], facts: Facts) -> Iterator[str]:
    """Every quantity of one equation."""
    number = where.strip("()") if where[0] == "(" else ""
    for quantity in dict.fromkeys(row.quantity.partition(" [")[0] for row in rows):
        readings = {row.id: row for row in rows if row.quantity.partition(" [")[0] == quantity}
        literal = [name for name in readings if facts.subjects[name].literal]
        holds = [name for name, row in readings.items() if row.verdict not in (DIFFERS, entries.AMBIGUOUS)]
        row = readings[[*literal, *holds, *readings][0]]
        printed, derived = facts.judgements[row.id].printed, facts.judgements[row.id].found
        left = LEFT.get(row.id, ())
        yield display(*(sides(left, printed) or [resultant(row.id, facts)]), number=number).markdown() + "\n"
        values = [value for _, value in derived]
        in_letters = sp.Tuple(*printed).free_symbols == sp.Tuple(*values).free_symbols
        repeated = not facts.subjects[row.id].shown or values == list(printed)
        in_order = row.verdict == IDENTICAL and in_letters and repeated
        if any(values) and not in_order:
            named = [(symbols(sp.Symbol(name)) if name else "0", symbols(value)) for name, value in derived]
            yield from ("Derived:", "")
            yield display(*(named if facts.subjects[row.id].shown else sides(left, values))).markdown() + "\n"
        if row.difference:
            yield from (f"Published minus derived: `{row.difference}`.", "")
        yield from (f"**{row.verdict.capitalize()}.** {in_markdown(row.evidence)}".rstrip(), "")
        if len(readings) > 1 and not literal:
            own, *others = (in_markdown(one.quantity.partition(" [")[2][:-1]) for one in (row, *readings.values()))
            others = [other for other in others if other != own]
            tried = f"The proved reading: {own}. Readings that differ: {'; '.join(others)}."
            if not holds:
                tried = f"All readings differ: {'; '.join((own, *others))}."
            yield from (f"Our plain-text copy of the paper is damaged here. {tried}", "")


def sides(left: Sequence[str], expressions: Sequence[sp.Expr]) -> list[tuple[str, str]]:
    """What stands on either side of each sign of equality."""
    if not left:
        return [(symbols(one), "0") for one in expressions]
    halves = [one.partition(" = ") for one in left]
    return [
        (before, (after or "%s") % symbols(one)) for (before, _, after), one in zip(halves, expressions, strict=True)
    ]


#: derivatives as `published.Resultant` names them
DERIVATIVES = {
    "F": "F",
    "dF/dA": r"\frac{\partial F}{\partial A}",
    "d2F/dA2": r"\frac{\partial^2 F}{\partial A^2}",
    "dF/dOmega": r"\frac{\partial F}{\partial \Omega}",
}


def resultant(name: str, facts: Facts) -> tuple[str, str]:
    """A resultant, and the polynomial that it is."""
    stated = getattr(published, name)()
    unknown, coefficient = symbols(sp.Symbol(stated.unknown)), stated.coefficients.partition("(")[0]
    of = f"{DERIVATIVES[stated.first]}, {DERIVATIVES[stated.second]}"
    left = rf"\mathrm{{Res}}_{{{symbols(sp.Symbol(stated.eliminated))}}} \left({of}\right)"
    powers = ", ".join(str(power) for power in range(0, 3 * stated.step, stated.step))
    return left, rf"\sum_{{i = {powers}, \dots, {stated.degree}}} {coefficient} {unknown}^i"


#: symbols that are not spelt as they are set
SPELT = {
    "F_k_x": "F_k(x)",
    "F_k_u": "F_k(u)",
    "dH_i_dA": r"\frac{\partial H_i}{\partial A}",
    "eigenvalue": r"\lambda",
    "trace": r"\mathrm{tr}\,D_q\Gamma",
    "determinant": r"\det D_q\Gamma",
    "det(eigenvalue*1 - D_q_Gamma)": r"\det(\lambda 1 - D_q\Gamma)",
}


def symbols(expression: sp.Expr) -> str:
    """LaTeX in the paper's letters: a dot is a prime, a bar stands over its letter."""
    names = {}
    for symbol in expression.free_symbols:
        letter, _, mark = symbol.name.rpartition("_")
        if symbol.name in SPELT:
            names[symbol] = SPELT[symbol.name]
        elif mark in ("dot", "ddot"):
            names[symbol] = latex(sp.Symbol(letter)) + "'" * mark.count("d")
        elif mark == "bar":
            names[symbol] = rf"\bar{{{latex(sp.Symbol(letter))}}}"
    return latex(expression, names)


def numbers(facts: Facts) -> Iterator[str]:
    """What the equations give for the isolator of Table 1, published and derived, and Table 2."""
    rows = entries.number_rows(facts)
    yield from (
        "## 8. The numbers",
        "",
        "Derived values are certified to the digits shown. The parameters are those of Table 1:",
        "",
    )
    table = ", ".join(f"${latex(sp.Symbol(name))} = {value}$" for name, value in published.TABLE_1.items())
    yield from (table + ".", "", "| number | published | derived | verdict |", "|---|---|---|---|")
    for name in NUMBERS:
        row = next(row for row in rows if row.id == name)
        yield f"| ${latex(sp.Symbol(name))}$ | {row.published} | {row.derived} | {row.verdict} |"
    yield from (
        "",
        "Table 2 has the frequencies and amplitudes of the jumps. Each cell has the published and the derived value.",
        "",
    )
    yield from ("| F_0 | jump-up Ω | jump-up A | jump-down Ω | jump-down A |", "|---|---|---|---|---|")
    for line in entries.table_2(rows):
        cells = (entry["published"] + cell(entry) for entry in line.values())
        yield f"| {' | '.join(cells)} |"
    yield from (
        "",
        "The ledger explains why some numbers differ. It also has (A1), (A2) and all sentences of the paper.",
    )


def cell(entry: dict[str, str]) -> str:
    """What an entry of Table 2 is compared with."""
    if not entry["derived"] or entry["derived"] == entry["published"]:
        return ""
    return f" {'**≠**' if entry['verdict'] == DIFFERS else '='} {entry['derived']}"


def derived() -> str:
    """The same, with the derivation of the paper's mechanism before it."""
    with balls.precision():
        return walkthrough(Facts(derive([rod_spring.MECHANISM])))


if __name__ == "__main__":
    print(derived(), end="")
