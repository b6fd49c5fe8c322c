"""Equations as MathML, which browsers draw without a script or a network. Takes LaTeX; returns HTML.

`latex2mathml` converts a formula; the rows and columns of `aligned` are put together here.
"""

from __future__ import annotations

import re
from html import escape
from typing import Any

from latex2mathml.converter import convert

ALIGNED = re.compile(r"\\begin\{aligned\}(.*)\\end\{aligned\}", re.DOTALL)
TAG = re.compile(r"\\tag\{([^}]*)\}")


def formula(latex: str) -> str:
    """The inside of one formula."""
    found = convert(latex)
    return found[found.index(">") + 1 : found.rindex("</math>")]


def block(latex: str) -> str:
    """A displayed equation, or several one under the other, with its number at the right."""
    tag = TAG.search(latex)
    latex = TAG.sub("", latex).strip()
    aligned = ALIGNED.search(latex)
    rows = re.split(r"\\\\\s*\n", aligned[1].strip()) if aligned else [latex]
    table = "".join(
        "<mtr>"
        + "".join(f"<mtd>{formula(cell) if cell.strip() else ''}</mtd>" for cell in re.split(r"&(?==)", row))
        + "</mtr>"
        for row in rows
    )
    number = f'<span class="number">({escape(tag[1])})</span>' if tag else ""
    math = f'<math display="block"><mtable displaystyle="true">{table}</mtable></math>'
    return f'<div class="equation"><div class="wide">{math}</div>{number}</div>'


def register(app: Any) -> None:
    """As a renderer that html_math_renderer can name."""
    from docutils import nodes

    def inline(self: Any, node: Any) -> None:
        self.body.append(f"<math>{formula(node.astext())}</math>")
        raise nodes.SkipNode

    def display(self: Any, node: Any) -> None:
        self.body.append(block(node.astext()))
        raise nodes.SkipNode

    app.add_html_math_renderer("mathml", inline_renderers=(inline, None), block_renderers=(display, None))
