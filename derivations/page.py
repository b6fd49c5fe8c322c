"""A page of text, tables and equations, made once and written in two languages.

In:  a title and sections of blocks: paragraphs, `Table`, `Equations`.
Out: `Page.markdown`, and `Page.tex`, an article that pdfLaTeX, LuaLaTeX and Tectonic compile.

A string is text of the project, in which $...$ is a formula; `Prose` is a user's text, and each language escapes all of
it. Formulas are LaTeX in both.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from .codegen.prose import GREEK, Prose, in_markdown, in_tex
from .given import in_decimals

#: a formula within text
FORMULA = re.compile(r"(\$[^$]*\$)")
#: a number with a decimal point, and what is said where there is one
DECIMAL = re.compile(r"\d\.\d")
DECIMALS = "A decimal number of up to 17 digits is the double that it names, or one rounded to that many."
#: names whose underscores begin an index
PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*")
#: letters of LaTeX that fit on one line of the article; a longer sum is broken between its terms
WIDTH = 180
#: names of equations are those of the paper where it has them, others are counted in each section
PREAMBLE = r"""\documentclass{article}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\numberwithin{equation}{section}
\allowdisplaybreaks
\date{}
"""


@dataclass(frozen=True)
class Table:
    """A row of headings, and rows of cells."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def markdown(self) -> str:
        """Its rows between bars."""
        head, *rows = (f"| {' | '.join(map(text_in_markdown, row))} |" for row in (self.head, *self.rows))
        return "\n".join((head, "|---" * len(self.head) + "|", *rows))

    def tex(self) -> str:
        """A tabular whose cells have the width of their text, the last but one excepted: it breaks its lines."""
        rows = [" & ".join(map(text_in_tex, row)) + r" \\" for row in (self.head, *self.rows)]
        return "\n".join([r"\begin{tabular}{llp{7cm}l}", rows[0], r"\hline", *rows[1:], r"\end{tabular}"])


@dataclass(frozen=True)
class Equations:
    """Equations, one under the other, as LaTeX of both sides; a number of the paper, if they have one."""

    rows: tuple[tuple[str, str], ...]
    number: str = ""

    @property
    def tag(self) -> str:
        """That number."""
        return rf" \tag{{{self.number}}}" if self.number else ""

    def markdown(self) -> str:
        """One display."""
        rows = " \\\\\n".join(f"{left} &= {right}" for left, right in self.rows)
        return f"$$\n\\begin{{aligned}}\n{rows}\n\\end{{aligned}}{self.tag}\n$$"

    def tex(self) -> str:
        """Rows that may go over the end of a page, the last one with the number."""
        rows = " \\notag \\\\\n".join(f"{left} &= {broken(right)}" for left, right in self.rows)
        return f"\\begin{{align}}\n{rows}{self.tag}\n\\end{{align}}"


Block = str | Table | Equations


def display(*rows: tuple[str, sp.Expr | str], number: str = "") -> Equations:
    """Equations by what stands on their left, and expressions."""
    return Equations(tuple((left, one if isinstance(one, str) else latex(one)) for left, one in rows), number)


@dataclass(frozen=True)
class Page:
    """A title, and sections by their titles."""

    title: str
    sections: Mapping[str, Sequence[Block]]

    def markdown(self) -> str:
        """With LaTeX between dollar signs."""
        lines = [f"# {text_in_markdown(self.title)}"]
        for title, blocks in self.sections.items():
            lines += [f"## {title}", *(text_in_markdown(b) if isinstance(b, str) else b.markdown() for b in blocks)]
        return "\n\n".join([*lines, *decimals(lines)]) + "\n"

    def tex(self) -> str:
        """A whole file."""
        lines = [PREAMBLE + rf"\title{{{text_in_tex(self.title)}}}", r"\begin{document}", r"\maketitle"]
        for title, blocks in self.sections.items():
            lines += [rf"\section{{{title}}}", *(text_in_tex(b) if isinstance(b, str) else b.tex() for b in blocks)]
        return "\n\n".join([*lines, *decimals(lines), r"\end{document}"]) + "\n"


def decimals(lines: Sequence[str]) -> list[str]:
    """What is said where there is a number with a decimal point."""
    return [DECIMALS] if any(map(DECIMAL.search, lines)) else []


def text_in_markdown(text: str) -> str:
    """A paragraph or a cell."""
    return in_markdown(text) if isinstance(text, Prose) else text


def text_in_tex(text: str) -> str:
    """The same, where all but the formulas of ours is escaped."""
    if isinstance(text, Prose):
        return in_tex(text)
    return "".join(part if number % 2 else in_tex(part) for number, part in enumerate(FORMULA.split(text)))


def latex(expression: sp.Expr, names: Mapping[sp.Symbol, str] | None = None) -> str:
    """LaTeX of one expression, long fractions as decimals, with the names that some of its symbols are set by."""
    named = {one: identifier(one.name) for one in expression.free_symbols if one.name.isidentifier()}
    names = named | dict(names or {})
    return str(sp.latex(in_decimals(expression), full_prec=False, inv_trig_style="full", symbol_names=names))


def identifier(name: str) -> str:
    """LaTeX of a name: SymPy knows no Greek letter lam. One that would not be a symbol, such as _a, is set as text."""
    spelt = "".join(GREEK.get(letter, letter) for letter in name)
    if not PLAIN.fullmatch(spelt):
        return rf"\text{{{in_tex(name)}}}"
    return str(sp.latex(sp.Symbol("lambda" if spelt == "lam" else spelt)))


def broken(formula: str) -> str:
    """LaTeX of a sum, a long one broken between its terms."""
    lines, depth = [""], 0
    for term in re.split(r"(?<= )(?=[+-] )", formula):
        if not depth and lines[-1] and len(lines[-1]) + len(term) > WIDTH:
            lines.append("")
        lines[-1] += term
        depth += term.count("{") - term.count("}") + term.count(r"\left") - term.count(r"\right")
    return " \\notag \\\\\n&\\quad ".join(lines)
