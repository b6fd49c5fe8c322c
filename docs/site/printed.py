"""What the code of a page prints, beneath it. Takes the text of a page; returns the same with its output."""

from __future__ import annotations

import contextlib
import io
import re
from typing import Any

from slowflow.core import backend

#: pages whose code shows what it does by what it prints; others show pictures
PAGES = re.compile(r"(index|tutorial|howto/\w+)$")
#: letters beyond which a line is words, no row of a table
WIDE = 110
BLOCK = re.compile(r"```python\n(.*?)```\n", re.DOTALL)


def inside(app: Any, name: str, source: list[str]) -> None:
    """Sphinx's hook. Without compiled solvers some of the code takes minutes: it is shown alone then."""
    if app.builder.format == "html" and PAGES.match(name) and backend.SOLVER is not None:
        source[0] = beneath(source[0], name)


def again(app: Any, environment: Any, added: set[str], changed: set[str], removed: set[str]) -> list[str]:
    """Sphinx's hook: these pages are read whenever the site is built, as what is asked may answer otherwise."""
    return [name for name in environment.all_docs if PAGES.match(name)]


def beneath(text: str, name: str) -> str:
    """The text with what each block prints; blocks of a page know the names of those before."""
    known: dict[str, Any] = {"__name__": name}

    def run(match: re.Match[str]) -> str:
        output = io.StringIO()
        with contextlib.redirect_stdout(output):
            exec(compile(match[1], name, "exec"), known)
        lines = [line.rstrip() for line in output.getvalue().strip("\n").splitlines()]
        if not lines:
            return match[0]
        shown = "printed wraps" if max(map(len, lines)) > WIDE else "printed"
        return "\n".join([match[0], "````{code-block} text", f":class: {shown}", "", *lines, "````", ""])

    return BLOCK.sub(run, text)
