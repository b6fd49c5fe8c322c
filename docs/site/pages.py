"""Pages that follow from the project, and links that lead out of the site: in goes the project, out comes docs/_made.

The derivation runs: `derivations.walkthrough` is the paper's, `derivations.document` that of each mechanism.
"""

from __future__ import annotations

import os
import re
import shutil
from importlib import import_module
from pathlib import Path
from typing import Any

from docs.api import EXAMPLES, MODULES, block

ROOT = Path(__file__).parents[2]
#: files outside docs that are pages of the site
ELSEWHERE = {
    "README.md": "index.md",
    "CONTRIBUTING.md": "_made/contributing.md",
    "generated/LEDGER.md": "_made/ledger.md",
    "CHANGELOG.md": "_made/changelog.md",
}
#: what one wants from the reference, by patterns of modules: the first that fits
PURPOSES = {
    "Isolators and oscillators": r"^slowflow$|(physical|oscillator|composed|loads|example)$|(w|averaged)\.questions$",
    "Many designs": r"many|batches|asked|designs|grid|\.table$",
    "Static loads and asymmetric forces": r"off_centre",
    "Exact motions and second approximation": r"exact|second",
    "Tolerances, requirements, fits": r"sizing",
    "Custom restoring forces": r"derive$|mechanism$",
    "Results": r"results|answer|quantities|certificate|gradient|transmitted|validity",
    "Input files, progress, codes": r"",
}
LINK = re.compile(r"(?<!!)\[([^\]\n]+)\]\((?!https?:|#|mailto:)([^)#\s]+)(#[^)\s]*)?\)")


def write(docs: Path) -> None:
    """All of them."""
    made = docs / "_made"
    shutil.rmtree(made, ignore_errors=True)
    (made / "derivation").mkdir(parents=True)
    (made / "reference").mkdir()
    for source, page in ELSEWHERE.items():
        if page.startswith("_made"):
            (docs / page).write_text(moved(ROOT / source, docs / page), encoding="utf-8")
    derivation(made / "derivation")
    reference(made / "reference")


def moved(source: Path, page: Path) -> str:
    """A file's text with its relative links as they are from the page."""

    def link(match: re.Match[str]) -> str:
        target = os.path.relpath(source.parent / match[2], page.parent)
        return f"[{match[1]}]({target}{match[3] or ''})"

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
            return f"[{match[1]}]({os.path.relpath(Path(app.srcdir, ELSEWHERE[path]), here)})"
        if target.is_relative_to(app.srcdir) and target.is_file():
            return match[0]
        if not target.exists():
            raise ValueError(f"{name}: there is no {path}")
        return match[1] if match[1].strip("`") == path else f"{match[1]} (`{path}`)"

    if name == "decisions/README":
        source[0] += "\n```{toctree}\n:hidden:\n:glob:\n\n*\n```\n"
    # indented lines are code
    source[0] = "\n".join(line if line.startswith("    ") else LINK.sub(link, line) for line in source[0].split("\n"))


def derivation(folder: Path) -> None:
    """The paper equation by equation, and a page for each mechanism."""
    from derivations import claims, library, walkthrough
    from derivations.live import told
    from derivations.mechanisms import all_mechanisms

    (folder / "walkthrough.md").write_text(walkthrough.derived(), encoding="utf-8")
    names = ["walkthrough"]
    for mechanism in (*all_mechanisms(), *map(library.stated, library.names())):
        (folder / f"{mechanism.name}.md").write_text(told(mechanism), encoding="utf-8")
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


def told_later(module: str) -> list[str]:
    """Names of it that are defined in no public module and stand on a later page too: Sphinx takes them once."""
    later = [import_module(other) for other in MODULES[MODULES.index(module) + 1 :]]
    listed = {id(getattr(other, name)) for other in later for name in getattr(other, "__all__", ())}
    own = {name: getattr(import_module(module), name) for name in getattr(import_module(module), "__all__", ())}
    elsewhere = {name for name, value in own.items() if getattr(value, "__module__", module) not in MODULES}
    return sorted(name for name in elsewhere if id(own[name]) in listed)


def reference(folder: Path) -> None:
    """A page for each public module, from its docstrings."""
    for module in MODULES:
        name = module.replace(".", "_")
        # a function that has the name of a module beside it would be listed twice
        children = [other.rpartition(".")[2] for other in MODULES if other.rpartition(".")[0] == module]
        twice = any(callable(getattr(import_module(module), child, None)) for child in children)
        options = ["   :no-index:"] if twice else []
        if again := told_later(module):
            options.append(f"   :exclude-members: {', '.join(again)}")
        begin = EXAMPLES.get(module, {}).get("begin", "")
        first = ["Examples here begin with these lines too:", "", *block(begin)] if begin else []
        lines = [f"# {module}", "", *first, "```{eval-rst}", f".. automodule:: {module}", *options, "```", ""]
        (folder / f"{name}.md").write_text("\n".join(lines), encoding="utf-8")
    text = (Path(__file__).parent / "reference.txt").read_text(encoding="utf-8")
    text += "\n".join(["\nExamples begin with these lines:", "", *block(EXAMPLES["begin"])])
    for title, belongs in PURPOSES.items():
        here = [module for module in MODULES if next(p for p in PURPOSES.values() if re.search(p, module)) == belongs]
        entries = "\n".join(module.replace(".", "_") for module in here)
        text += f"\n## {title}\n\n```{{toctree}}\n:maxdepth: 1\n\n{entries}\n```\n"
    (folder / "index.md").write_text(text, encoding="utf-8")
