"""The report of a scene: in goes a scene with forcings, out comes one HTML page that needs no network.

The answers with their margins, curves, transmissibility, a map of designs with the one at hand, how far to trust each
jump, the equations with their verdicts, and the data. Pictures are drawn by Matplotlib into the page.
"""

from __future__ import annotations

import base64
import hashlib
import io
import re
from collections.abc import Iterable, Iterator, Sequence
from html import escape
from typing import Any

import matplotlib as mpl
import numpy as np

import slowflow
from slowflow import files, pictures
from slowflow.answer import Answer, head
from slowflow.paper.report import read_ledger
from slowflow.physical import Physical, Quantities
from slowflow.scenes import Scene
from slowflow.sizing.subject import Load, Subject

#: equations of the paper that the answers rest on
EQUATIONS = ("(3)", "(4)", "(5)", "(6)", "(7)", "(21)", "(22)", "(24)", "(25)", "(27)", "(30)", "(33)", "(34)")
#: designs of the map along each of two numbers, and how far these reach from the design at hand
MAPPED, REACH = 60, 0.5
#: numbers of the map, of a mount and of an isolator without dimensions
OF_MOUNT, OF_ISOLATOR = ("k_h", "preload"), ("r", "delta_h")

STYLE = """
:root { color-scheme: light dark; --text: #1a1a1a; --ground: #ffffff; --line: #767676; --head: #eef2f6; }
@media (prefers-color-scheme: dark) { :root { --text: #ececec; --ground: #16191d; --line: #8f8f8f; --head: #262c33; } }
body { color: var(--text); background: var(--ground); font: 16px/1.5 system-ui, sans-serif; margin: 0 auto;
       max-width: 60rem; padding: 1rem; }
table { border-collapse: collapse; }
.wide { overflow-x: auto; }
th, td { border-bottom: 1px solid var(--line); padding: .25rem .6rem; text-align: right; }
th { background: var(--head); } td:first-child, th:first-child { text-align: left; }
caption { text-align: left; font-weight: 600; padding: .5rem 0; }
figure { margin: 1rem 0; } figure svg { background: #ffffff; height: auto; max-width: 100%; }
a { color: inherit; }
@media print { body { max-width: none; } figure, table { break-inside: avoid; } }
"""


def html(scene: Scene) -> str:
    """The page. Raises ValueError where the scene has no forcing, or its oscillator is no isolator."""
    forcings = scene.forcings()
    if not forcings:
        raise ValueError(f"{scene.path}: a report needs forcings in [ask]")
    of = scene.oscillator
    subject = Subject(of)
    title = f"Vibration isolator: {scene.path.stem}"
    parts = [
        *_design(of, scene),
        *_answers(of, forcings),
        *_curves(of, forcings),
        *_tolerances(scene),
        *_map(subject),
        *_trust(of, forcings),
        *_equations(),
        *_data(of, forcings, scene),
    ]
    body = "\n".join(parts)
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{escape(title)}</title>\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<style>{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{escape(title)}</h1>\n{body}\n</main>\n</body>\n</html>\n"
    )


# ---- sections


def _design(of: Any, scene: Scene) -> Iterator[str]:
    yield "<h2>The design</h2>"
    yield f"<p><code>{escape(repr(of))}</code></p>"
    for text in scene.warnings:
        yield f"<p>Note: {escape(text)}</p>"
    if isinstance(of, Physical):
        yield _table("At rest", of.at_rest().in_units())


def _answers(of: Any, forcings: Sequence[float]) -> Iterator[str]:
    yield "<h2>What it does</h2>"
    yield _table("It jumps from this force on", _shown(of.saddle_node_onset()))
    yield _table("Its springs leave from this force on", _shown(of.detachment()))
    for caption, question in (
        ("Margins: of_SN and of_cr above 1 are safe", "margins"),
        ("The highest peak", "peak"),
        ("Less than the force is transmitted from this frequency on", "isolation"),
        ("Where a sweep jumps", "saddle_nodes"),
        ("Bands with several stable motions", "hysteresis"),
    ):
        yield _table(caption, *(_shown(getattr(of, question)(F)) for F in forcings))


def _curves(of: Any, forcings: Sequence[float]) -> Iterator[str]:
    yield "<h2>Curves</h2>"
    curves = [_shown(of.frequency_response(F)) for F in forcings]
    folds = [_shown(of.saddle_nodes(F)) for F in forcings]
    force = "F" if isinstance(of, Physical) else "F_0"
    for y, said in (("A", "Amplitude"), ("transmissibility_dB", "Transmissibility in decibels")):
        ax = pictures.responses(None, list(zip(curves, folds, strict=True)), y)
        pictures.legend(ax, pictures.axis(curves[0], force))
        yield _figure(ax, f"{said} over frequency, a curve for each force; unstable motions dashed.")


def _tolerances(scene: Scene) -> Iterator[str]:
    """What the scene asks of tolerances."""
    asked = [one for one in scene.asked if one.question == "tolerances"]
    if asked:
        yield "<h2>Tolerances</h2>"
        within = ", ".join(f"{name} within {100 * share:g} %" for name, share in asked[0].arguments["within"].items())
        yield f"<p>{escape(within)}; 95 of 100 lie between low and high.</p>"
    for one in asked:
        yield _table(str(one), scene.answer(one))


def _map(subject: Subject) -> Iterator[str]:
    x, y = OF_MOUNT if subject.mount else OF_ISOLATOR
    if not subject.nominal[y]:
        return
    share = np.linspace(1 - REACH, 1 + REACH, MAPPED)
    columns, rows = subject.nominal[x] * share, subject.nominal[y] * share
    values = subject.ask({x: columns[None, :], y: rows[:, None]}, ["F_SN"], Load(None, None))["F_SN"]
    unit = {"F_SN": subject.unit("F_SN")} if subject.mount else {}
    scale, of_y = (1e3, f"{y}/mm") if subject.mount else (1.0, y)
    ax = pictures.design_map(
        None,
        (f"{x}/(N/m)" if subject.mount else x, columns),
        (of_y, scale * rows),
        (head("F_SN", unit), np.where(np.isfinite(values), values, np.nan)),
    )
    ax.plot(subject.nominal[x], scale * subject.nominal[y], "o", color="white", markeredgecolor="black")
    yield "<h2>Designs beside it</h2>"
    yield _figure(ax, f"The force from which on it jumps, over {x} and {y}; the circle is the design at hand.")


def _trust(of: Any, forcings: Sequence[float]) -> Iterator[str]:
    """Jumps by averaging, the second approximation and the equation of motion."""
    yield "<h2>How far to trust it</h2>"
    name = "f" if isinstance(of, Physical) else "Omega"
    rows = []
    for F in forcings:
        found = of.saddle_nodes(F)
        plain = found.answer if isinstance(found, Quantities) else found
        unit = of.scales.sizes["frequency"] if isinstance(of, Physical) else 1.0
        if not len(plain):
            continue
        exact = [(one.Omega * unit, one.error, one.reason) for one in plain.measure()]
        better = getattr(of.second_approximation.saddle_nodes(F), name)
        for k, fold in enumerate(found):
            second = f"{better[k]:.5g}" if len(better) == len(found) else "another number of folds"
            Omega, error, reason = exact[k]
            last = (f"{Omega:.5g}", f"{100 * error:+.2g} %") if not reason else (escape(reason), "")
            rows.append((f"{F:.4g}", fold.kind, f"{getattr(fold, name):.5g}", second, *last))
    if not rows:
        yield "<p>There is no jump at these forces.</p>"
        return
    of_f = f"{name}/Hz" if isinstance(of, Physical) else name
    force = "F/N" if isinstance(of, Physical) else "F_0"
    heads = (force, "kind", f"{of_f}, averaged", "second approximation", "equation of motion", "error of averaging")
    yield _rows("Each jump by averaging, with higher harmonics, and by the equation of motion itself", heads, rows)


def _equations() -> Iterator[str]:
    yield "<h2>Equations</h2>"
    ledger = read_ledger()
    rows = [
        (row["where"], row["quantity"], row["verdict"])
        for row in ledger["rows"]
        if row["kind"] == "formula" and row["where"] in EQUATIONS
    ]
    yield f"<p>Equations of {escape(ledger['paper'])}, each held against the derivation:</p>"
    yield _rows("Verdicts", ("equation", "what", "verdict"), rows)


def _data(of: Any, forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    yield "<h2>Data</h2>"
    force = "F" if isinstance(of, Physical) else "F_0"
    yield "<ul>"
    for question in ("saddle_nodes", "frequency_response"):
        text = files.in_csv([({force: F}, _shown(getattr(of, question)(F))) for F in forcings])
        yield f"<li>{_download(f'{question}.csv', 'text/csv', text)}</li>"
    yield f"<li>{_download(scene.path.name, 'application/toml', scene.text)}</li>"
    yield "</ul>"
    yield f"<p>slowflow {slowflow.__version__}; scene {escape(scene.path.name)}, sha256 {scene.sha256}</p>"


# ---- pieces


def _shown(answer: Answer) -> Answer:
    return answer.in_units() if isinstance(answer, Quantities) else answer


def _table(caption: str, *answers: Answer) -> str:
    """Columns of answers to one question, one below the other, and what is said beside them."""
    columns = [answer.columns() for answer in answers]
    units = answers[0].units_of_columns()
    kept = [name for name in columns[0] if name not in ("message", "remarks")]
    beside = [_beside(answer, kept) for answer in answers]
    heads = [head(name, units) for name in (*beside[0], *kept)]
    rows = [
        (*map(_text, asked.values()), *(_text(value) for value in row))
        for found, asked in zip(columns, beside, strict=True)
        for row in zip(*(found[name].tolist() for name in kept), strict=True)
    ]
    said = dict.fromkeys(str(answer.to_dict().get("message") or "") for answer in answers)
    notes = "".join(f"<p>{escape(text)}</p>" for text in said if text)
    return _rows(caption, heads, rows) + notes if rows else notes


def _beside(answer: Answer, kept: Iterable[str]) -> dict[str, Any]:
    """The forcing of an answer, where it is no column of it."""
    known = answer.to_dict()
    return {name: known[name] for name in ("F", "F_0") if name in known and name not in kept}


def _text(value: Any) -> str:
    if isinstance(value, float):
        return "" if np.isnan(value) else f"{value:.4g}"
    return escape({True: "yes", False: "no"}.get(value, str(value)) if isinstance(value, bool) else str(value))


def _rows(caption: str, heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A table; its cells are HTML already, its heads are not."""
    lines = [f'<div class="wide"><table>\n<caption>{escape(caption)}</caption>']
    lines.append("<tr>" + "".join(f'<th scope="col">{escape(one)}</th>' for one in heads) + "</tr>")
    lines += ["<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows]
    return "\n".join([*lines, "</table></div>"])


def _figure(ax: Any, said: str) -> str:
    """Axes as SVG within the page, with a text for who does not see it; the figure is closed."""
    from matplotlib import pyplot

    text = io.StringIO()
    with mpl.rc_context({"svg.fonttype": "none", "svg.hashsalt": "slowflow"}):
        ax.figure.savefig(text, format="svg", metadata={"Date": None})
    pyplot.close(ax.figure)
    drawn = text.getvalue()
    drawn = drawn[drawn.index("<svg") :]
    # each drawing numbers its parts from 1: on one page they need names of their own
    own = hashlib.sha256(said.encode()).hexdigest()[:8]
    drawn = re.sub(r'(\bid="|url\(#|href="#)', rf"\g<1>{own}-", drawn)
    drawn = drawn.replace("<svg", f'<svg role="img" aria-label="{escape(said, quote=True)}"', 1)
    return f"<figure>\n{drawn}\n<figcaption>{escape(said)}</figcaption>\n</figure>"


def _download(name: str, kind: str, text: str) -> str:
    data = base64.b64encode(text.encode()).decode()
    return f'<a download="{escape(name)}" href="data:{kind};base64,{data}">{escape(name)}</a>'
