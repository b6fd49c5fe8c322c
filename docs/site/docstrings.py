"""Docstrings as reStructuredText that reads the same: a Sphinx hook.

Sections of NumPy's style and lines `name -- what it is` become terms with their definitions; indented text is shown as
it is; nothing else has a meaning. The example of docs/api.toml follows.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from docs.api import EXAMPLES

FIELD = re.compile(r"^(\s*)([\w., *]+?)\s+-- (.*)$")


def escaped(text: str) -> str:
    """Without what reStructuredText would take for markup; names between backticks stay code."""
    pieces = re.split(r"(`[^`]+`)", text)
    return "".join(
        f"``{part[1:-1]}``"
        if part.startswith("`") and len(part) > 2
        else re.sub(r"([\\*|`])|(?<=\w)(_)(?!\w)", r"\\\g<0>", part)
        for part in pieces
    )


def paragraph(lines: list[str]) -> Iterator[str]:
    """A section of NumPy's style, fields, a block that is set in, or text."""
    if len(lines) > 1 and set(lines[1]) == {"-"}:
        yield f"**{lines[0]}**"
        yield ""
        if lines[0] == "Notes":
            yield from (escaped(line.strip()) for line in lines[2:])
            lines = []
        for line in lines[2:]:
            name, _, kind = line.partition(" : ")
            term = f"``{name}``" + (f" : {escaped(kind)}" if kind else "")
            yield f"    {escaped(line.strip())}" if line.startswith(" ") else term
    elif FIELD.match(lines[0]):
        fields: list[tuple[str, str]] = []
        for line in lines:
            found = FIELD.match(line)
            if found:
                fields.append((found[2], found[3]))
            else:
                fields[-1] = (fields[-1][0], f"{fields[-1][1]} {line.strip()}")
        for name, text in fields:
            yield f"``{name}``"
            yield f"    {escaped(text)}"
    elif lines[0].startswith(" "):
        yield "::"
        yield ""
        yield from (f"    {line}" for line in lines)
    else:
        yield from (escaped(line.strip()) for line in lines)
    yield ""


def as_rst(app: Any, what: str, name: str, of: Any, options: Any, lines: list[str]) -> None:
    """Sphinx's hook: changes the lines in place."""
    found: list[str] = []
    for part in re.split(r"\n\s*\n", "\n".join(lines).strip("\n")):
        if part.strip():
            found += paragraph(part.split("\n"))
    lines[:] = found + list(example(name))


def unsaid(app: Any, what: str, name: str, of: Any, skip: bool, options: Any) -> bool | None:
    """Sphinx's hook: leave out fields of a named tuple, which its signature has, and classes named by an attribute."""
    field = str(getattr(of, "__doc__", "")).startswith("Alias for field number")
    return True if field or (what == "class" and isinstance(of, type)) else None


def example(name: str) -> Iterator[str]:
    """That of a name with its module before it, if it has one."""
    for path, examples in EXAMPLES.items():
        if path != "begin" and name.startswith(f"{path}.") and name.removeprefix(f"{path}.") in examples:
            code = examples[name.removeprefix(f"{path}.")].strip()
            yield from ("::", "", *(f"    {line}" for line in code.split("\n")), "")
