"""Pages that follow from the project, and links that lead out of the site. Takes the project; returns docs/_made.

The derivation runs: `derivations.walkthrough` is the paper's, `derivations.document` that of each mechanism.
"""

from __future__ import annotations

import inspect
import os
import re
import shutil
from enum import Enum
from importlib import import_module
from pathlib import Path
from typing import Any

from docs.api import EXAMPLES, MODULES, block, home, public

ROOT = Path(__file__).parents[2]
#: files that are pages of the site elsewhere
ELSEWHERE = {
    "README.md": "index.md",
    "CONTRIBUTING.md": "_made/contributing.md",
    "CHANGELOG.md": "_made/changelog.md",
    "generated/LEDGER.md": "_made/ledger/index.md",
    "docs/literature.md": "_made/literature/index.md",
    "docs/stability.md": "_made/stability/index.md",
    "docs/validity.md": "_made/validity/index.md",
}
#: letters of a page in whose folder each section gets a page, up to which the first sections stay on it
FIRST_PAGE = 4000
#: sections of the reference, with patterns of their modules: the first that matches
PURPOSES = {
    "Isolators and oscillators": r"^slowflow$|(physical|oscillator|composed|loads|example)$|(w|averaged)\.questions$",
    "Many designs": r"many|batches|designs|grid|\.table$",
    "Static loads and asymmetric forces": r"off_centre",
    "Exact motions and second approximation": r"exact|second",
    "Tolerances, requirements, fits": r"sizing",
    "Custom restoring forces": r"derive$|mechanism$",
    "Results": r"results|answer|quantities|certificate|gradient|transmissibility|checks|validity",
    "Input files, other languages, progress, codes": r"",
}
LINK = re.compile(r"(!?\[[^\]\n]+\])\((?!https?:|#|mailto:)([^)#\s]+)(?:#([^)\s]*))?\)")


def write(docs: Path) -> None:
    """All of them."""
    made = docs / "_made"
    shutil.rmtree(made, ignore_errors=True)
    (made / "derivation").mkdir(parents=True)
    (made / "reference").mkdir()
    for source, page in ELSEWHERE.items():
        if page.startswith("_made"):
            put(relinked(ROOT / source, docs / page), docs / page)
    derivation(made / "derivation")
    reference(made / "reference")


def put(text: str, page: Path) -> None:
    """Write a page; one that is the index of a folder keeps its first sections, and each other one is a page there."""
    page.parent.mkdir(exist_ok=True)
    if page.name == "index.md":
        first, *sections = re.split(r"^## ", text, flags=re.MULTILINE)
        while sections and len(first) + len(sections[0]) < FIRST_PAGE:
            first += f"## {sections.pop(0)}"
        for section in sections:
            raised = re.sub(r"^##(#+ )", r"#\1", f"# {section}", flags=re.MULTILINE)
            page.with_name(f"{slug(section)}.md").write_text(raised, encoding="utf-8")
        names = "\n".join(map(slug, sections))
        text = f"{first}\n```{{toctree}}\n:maxdepth: 1\n\n{names}\n```\n"
    page.write_text(text, encoding="utf-8")


def slug(section: str) -> str:
    """The name of a section's page, which is the anchor of its heading."""
    return re.sub(r"[^\w -]", "", section.partition("\n")[0].lower()).replace(" ", "-")


def relinked(source: Path, page: Path) -> str:
    """A file's text with its relative links as they are from the page."""

    def link(match: re.Match[str]) -> str:
        target = os.path.relpath(source.parent / match[2], page.parent)
        return f"{match[1]}({target}{f'#{match[3]}' if match[3] else ''})"

    return LINK.sub(link, source.read_text(encoding="utf-8"))


def inside(app: Any, name: str, source: list[str]) -> None:
    """Sphinx's hook: links to pages of the site are kept, others become the name of the file."""
    here = Path(app.srcdir, name).parent

    def link(match: re.Match[str]) -> str:
        target = (here / match[2]).resolve()
        if not target.is_relative_to(ROOT):
            return match[0]
        path = target.relative_to(ROOT).as_posix()
        if path in ELSEWHERE:
            page = Path(app.srcdir, ELSEWHERE[path])
            section = page.with_name(f"{match[3]}.md")
            return f"{match[1]}({os.path.relpath(section if section.is_file() else page, here)})"
        if target.is_relative_to(app.srcdir) and target.is_file():
            return match[0]
        if not target.exists():
            raise ValueError(f"{name}: there is no {path}")
        shown = match[1][1:-1]
        return shown if shown.strip("`") == path else f"{shown} (`{path}`)"

    if name == "decisions/README":
        source[0] += "\n```{toctree}\n:hidden:\n:glob:\n\n*\n```\n"
    # indented lines are code
    source[0] = "\n".join(line if line.startswith("    ") else LINK.sub(link, line) for line in source[0].split("\n"))


def derivation(folder: Path) -> None:
    """The paper equation by equation, and a page for each mechanism."""
    from derivations import claims, library, walkthrough
    from derivations.mechanisms import all_mechanisms
    from derivations.runtime import description

    put(walkthrough.derived(), folder / "walkthrough" / "index.md")
    names = ["walkthrough/index"]
    for mechanism in (*all_mechanisms(), *map(library.stated, library.names())):
        (folder / f"{mechanism.name}.md").write_text(description(mechanism).markdown(), encoding="utf-8")
        names.append(mechanism.name)
    (folder / "proved.md").write_text(claims.page(), encoding="utf-8")
    names.append("proved")
    (folder / "index.md").write_text(
        (Path(__file__).parent / "derivation.txt").read_text(encoding="utf-8")
        + "\n```{toctree}\n:maxdepth: 1\n\n"
        + "\n".join(names)
        + "\n```\n",
        encoding="utf-8",
    )


def directive(kind: str, name: str, options: list[str]) -> list[str]:
    """Lines that show a docstring."""
    return ["```{eval-rst}", f".. auto{kind}:: {name}", *(f"   {option}" for option in options), "```", ""]


def reference(folder: Path) -> None:
    """A page for each public class, and one for each module with its functions and codes, from their docstrings."""
    pages: dict[str, list[str]] = {}
    for module in MODULES:
        begin = EXAMPLES.get(module, {}).get("begin", "")
        first = ["Examples on this page also begin with these lines:", "", *block(begin)] if begin else []
        here, elsewhere, pages[module] = [], [], [module.replace(".", "_")]
        for name, value in public(import_module(module)):
            there = home(name, value)
            own_page = inspect.isclass(value) and not issubclass(value, Exception | Enum)
            target = (f"{there}.{name}" if own_page else there).replace(".", "_")
            if own_page or there != module:
                elsewhere.append(f"[{name}]({target}.md)")
            else:
                here.append(name)
            if own_page and there == module:
                lines = [f"# {name}", "", *first, *directive("class", f"{module}.{name}", [":members:"])]
                (folder / f"{target}.md").write_text("\n".join(lines), encoding="utf-8")
                pages[module].append(target)
        shown = [f":members: {', '.join(here)}"] if here else []
        lines = [f"# {module}", "", *(first if here else []), *directive("module", module, shown)]
        lines += ["On their own pages: " + ", ".join(elsewhere) + ".", ""] if elsewhere else []
        (folder / f"{pages[module][0]}.md").write_text("\n".join(lines), encoding="utf-8")
    text = (Path(__file__).parent / "reference.txt").read_text(encoding="utf-8")
    text += "\n".join(["\nExamples begin with these lines:", "", *block(EXAMPLES["begin"])])
    for title, belongs in PURPOSES.items():
        here = [module for module in MODULES if next(p for p in PURPOSES.values() if re.search(p, module)) == belongs]
        entries = "\n".join(page for module in here for page in pages[module])
        text += f"\n## {title}\n\n```{{toctree}}\n:maxdepth: 1\n\n{entries}\n```\n"
    (folder / "index.md").write_text(text, encoding="utf-8")
