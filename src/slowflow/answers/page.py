"""HTML of a page that needs nothing else. Takes captions, cells and Matplotlib's axes; returns tables and figures.

Cells, heads and parts are HTML already; captions are not. Names are set by `term`, words with names by `inline`.
Everything can be read aloud and reached by keys.
"""

from __future__ import annotations

import base64
import hashlib
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from html import escape, unescape
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np

from slowflow.answers.pictures import in_brackets, label

#: what a cell of words begins with until it is written
TEXT = "\0"
#: how Matplotlib's labels write what is Greek, and what stands below a letter
LETTERS = ("alpha", "beta", "gamma", "delta", "zeta", "eta", "lambda", "mu", "pi", "tau", "phi", "psi", "omega")
GREEK = {name: unescape(f"&{name};") for name in (*LETTERS, "Phi", "Omega")}
GREEK |= {"lam": "λ", "varphi": "φ", "dOmega": "dΩ"}
#: whole powers, as they stand above the line
RAISED = dict(zip("23456789", "²³⁴⁵⁶⁷⁸⁹", strict=True))
#: what stands between a letter and its unit, which stay on one line
TIED = "\N{NO-BREAK SPACE}"
BELOW = re.compile(r"([^\W_]+)_(?:\{(?:\\mathrm\{)?([^{}]*)\}+|(\w+))")
#: colours light and dark; what is too wide for a screen is scrolled, and on paper it is smaller
STYLE = """
:root { color-scheme: light dark; --text: #1a1a1a; --ground: #ffffff; --line: #767676; --head: #eef2f6; }
@media screen and (prefers-color-scheme: dark) {
  :root { --text: #ececec; --ground: #16191d; --line: #8f8f8f; --head: #262c33; } }
body { color: var(--text); background: var(--ground); font: 16px/1.5 system-ui, sans-serif; margin: 0 auto;
       max-width: 60rem; padding: 1rem; overflow-wrap: anywhere; }
h2 { border-top: 1px solid var(--line); margin-top: 2.5rem; padding-top: 1rem; }
nav ul { display: flex; flex-wrap: wrap; gap: .25rem 1.25rem; list-style: none; padding: 0; }
table { border-collapse: collapse; overflow-wrap: normal; }
.wide { overflow-x: auto; margin: 1rem 0; }
th, td { border-bottom: 1px solid var(--line); padding: .25rem .6rem; text-align: right; white-space: nowrap; }
th { background: var(--head); white-space: normal; } td:first-child, th:first-child, .words { text-align: left; }
.words { white-space: normal; min-width: 9rem; max-width: 32rem; }
math { display: block; math-style: normal; margin: .5rem 0;
       font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", "DejaVu Math TeX Gyre", math, serif; }
caption, .caption { font-weight: 600; }
caption { text-align: left; padding: .5rem 0; width: max-content; max-width: 90vw; }
figure { margin: 1rem 0; } figure svg { background: #ffffff; height: auto; width: 100%; max-width: 42rem; }
a { color: inherit; }
@media (max-width: 40rem) { th, td { padding: .2rem .3rem; font-size: .875rem; } .words { min-width: 4.5rem; } }
@media print { :root { color-scheme: light; }
               body { max-width: none; } nav { display: none; } figure, tr { break-inside: avoid; }
               h2, caption, tr:nth-child(-n+2), tr:nth-last-child(2) { break-after: avoid; } table { font-size: 9pt; }
               .wide { overflow: visible; } td, th { padding: .1rem .3rem; }
               .words { max-width: none; } math { font-size: 9pt; }
               figure svg { max-width: 30rem; } body { font-size: 11pt; } }
"""


def whole(title: str, sections: Mapping[str, Sequence[str]]) -> str:
    """The page: its sections under their names, with links to them at the top."""
    links = "".join(f'<li><a href="#{_anchor(name)}">{escape(name)}</a></li>' for name in sections)
    body = "\n".join(
        line
        for name, blocks in sections.items()
        for at in (_anchor(name),)
        for line in (f'<section aria-labelledby="{at}">', f'<h2 id="{at}">{escape(name)}</h2>', *blocks, "</section>")
    )
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{escape(title)}</title>\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<style>{STYLE}</style>\n</head>\n<body>\n<header><h1>{escape(title)}</h1>\n"
        f'<nav aria-label="Contents"><ul>{links}</ul></nav></header>\n'
        f"<main>\n{body}\n</main>\n</body>\n</html>\n"
    )


def _anchor(name: str) -> str:
    return name.lower().replace(" ", "-")


def cell(value: Any) -> str:
    """A cell of a number, four digits of it, a truth, a word or a sentence; empty for NaN."""
    if isinstance(value, float):
        return "" if np.isnan(value) else f"{value:.4g}"
    if isinstance(value, str) and " " in value:
        return prose(value)
    return escape({True: "yes", False: "no"}.get(value, str(value)) if isinstance(value, bool) else str(value))


def prose(text: str) -> str:
    """A cell of text, which may break over lines."""
    return f"{TEXT}{inline(text)}"


def formula(set_: Sequence[str], text: str) -> str:
    """A cell of formulas in MathML; as text where there are none."""
    mathml = "".join(f"<math>{one}</math>" for one in set_).replace("<mo>-</mo>", "<mo>\N{MINUS SIGN}</mo>")
    return f"{TEXT}{mathml or inline(text)}"


def inline(text: str) -> str:
    """Words with names in them, these set: Greek letters, powers, and what stands below a letter."""
    html = re.sub(r"\bd2(\w)/d(\w)2\b", r"d²\1/d\2²", escape(text.replace(">=", "≥").replace("<=", "≤")))
    html = BELOW.sub(_lowered, html)
    html = re.sub(r"\b[A-Za-z]+\b(?!&|;)", lambda found: GREEK.get(found[0], found[0]), html)
    return re.sub(r"\^([2-9])", lambda found: RAISED[found[1]], html)


def term(name: str, unit: str = "") -> str:
    """A name of a number as it is read: its words, or its letter with what stands below it; and its unit."""
    html = re.sub(r"\$([^$]*)\$", lambda found: _math(found[1]), escape(label(name), quote=False))
    html = html if html != name else inline(name) if _is_symbol(name) else escape(name.replace("_", " "))
    return f"{html}{TIED}/{TIED}{in_brackets(unit).replace(' ', TIED)}" if unit else html


def _is_symbol(name: str) -> bool:
    """Whether a name is that of a letter, with something below it or not."""
    first = name.partition("_")[0]
    return len(first) == 1 or first in GREEK


def _math(text: str) -> str:
    """Of Matplotlib's mathematics."""
    plain = re.sub(r"\\(?!mathrm)([A-Za-z]+)", lambda found: GREEK.get(found[1], found[1]), text.replace(r"\ ", " "))
    html = BELOW.sub(_lowered, plain)
    return html if "<" in html else f"<i>{html}</i>"


def _lowered(found: re.Match[str]) -> str:
    """A letter with what stands below it; words that are joined apart from each other."""
    name, below = found[1], (found[2] or found[3]).replace("_", " ")
    if not _is_symbol(name) and name != "Res":
        return f"{name} {below}"
    return f"<i>{GREEK.get(name, name)}</i><sub>{GREEK.get(below, below)}</sub>"


def untabled(caption: str, notes: str) -> str:
    """What there is to say where a table of that caption would have no number."""
    return f'<p class="caption">{inline(caption)}</p>{notes}' if notes else ""


def table(caption: str, heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; its cells and heads are HTML already. What is too wide is scrolled, by keys too."""
    summary = escape(caption, quote=True)
    lines = [f'<div class="wide" role="region" tabindex="0" aria-label="{summary}"><table>']
    lines.append(f"<caption>{inline(caption)}</caption>")
    listed = [list(row) for row in rows]
    worded = [any(row[k].startswith(TEXT) for row in listed) for k in range(len(heads))]
    kinds = [' class="words"' if one else "" for one in worded]
    header = (f'<th scope="col"{kind}>{one}</th>' for one, kind in zip(heads, kinds, strict=True))
    lines.append("<tr>" + "".join(header) + "</tr>")
    for row in listed:
        cells = (f"<td{kind}>{cell.removeprefix(TEXT)}</td>" for cell, kind in zip(row, kinds, strict=True))
        lines.append("<tr>" + "".join(cells) + "</tr>")
    return "\n".join([*lines, "</table></div>"])


def axes() -> Any:
    """Of a picture that is read on a phone too."""
    return plt.subplots(figsize=(5.4, 4.4), layout="constrained")[1]


def figure(ax: Any, caption: str) -> str:
    """Axes as SVG within the page, with a text for who does not see it; the figure is closed."""
    text = io.StringIO()
    with mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": "slowflow"}):
        ax.figure.savefig(text, format="svg", metadata={"Date": None})
    plt.close(ax.figure)
    drawn = text.getvalue()
    drawn = drawn[drawn.index("<svg") :]
    # each drawing numbers its parts from 1: on one page they need names of their own
    own = hashlib.sha256(caption.encode()).hexdigest()[:8]
    drawn = re.sub(r'(\bid="|url\(#|href="#)', rf"\g<1>{own}-", drawn)
    drawn = drawn.replace("<svg", f'<svg role="img" aria-label="{escape(caption, quote=True)}"', 1)
    return f"<figure>\n{drawn}\n<figcaption>{inline(caption)}</figcaption>\n</figure>"


def download(name: str, kind: str, text: str) -> str:
    """A link that has a file of that kind in itself."""
    data = base64.b64encode(text.encode()).decode()
    return f'<a download="{escape(name)}" href="data:{kind};base64,{data}">{escape(name)}</a>'
