"""What a user writes of a mechanism stays text in each language that it is printed in."""

from __future__ import annotations

import ast
import dataclasses
import functools
import json
import re
import shlex
import shutil
import subprocess
import sysconfig

import jinja2
import pytest
import sympy as sp
from hypothesis import example, given, settings
from hypothesis import strategies as st

from slowflow import derive, include
from tests.files import Lazily

runtime, document, pages = (Lazily(f"slowflow.derivation.{name}") for name in ("runtime", "document", "page"))
bytecode, prose, numpy, views = (
    Lazily(f"slowflow.derivation.codegen.{name}") for name in ("bytecode", "prose", "targets.numpy", "views")
)

u, k = sp.symbols("u k")
HOSTILE = (
    'x", print("EXECUTED") or "',
    '"""\nprint("EXECUTED")\n"""',
    "'''",
    '6" stop',
    "ends in a backslash \\",
    'ends in both \\"',
    "two\nlines, and \r, \x00, \u2028, \u202e",
    "*/ int executed = 1; /*",
    "**//* and /*/ and *\\\n/",
    "??/ ?" + "?/",
    "{{ 1/0 }} {% raw %} {# #}",
    r"$x$ \tag{1} | <script>alert(1)</script> **bold** `code` [a](b) &amp;",
    "Größe, μ, 弹簧, 🙂",
    "long " * 80,
    "x" * 200,
)
#: what such texts are made of, more often than chance has it
TEXTS = st.lists(st.sampled_from([*"\"'\\*/?|$#{}\n\r\t ", '"""', "*/", "/*", "\u2028"]) | st.characters(codec="utf-8"))


@functools.cache
def sources():
    """Of an ordinary force: its texts are changed after the derivation, which does not read them."""
    return runtime.sources(runtime.stated("stop", [(k * u, 1), (u, None)], {"k": {"above": 0}}))


def written(text):
    """The same with that text wherever a user has one."""
    base = sources()
    texts = {"doc": text, "unit": text}
    design = tuple(dataclasses.replace(one, **texts) for one in base.module.record.mechanism.design)
    mechanism = dataclasses.replace(base.module.record.mechanism, title=text, design=design, reach_reason=text)
    record = dataclasses.replace(base.module.record, mechanism=mechanism)
    return dataclasses.replace(base, module=dataclasses.replace(base.module, title=text, record=record))


@functools.cache
def code():
    module = sources().module
    return views.programs(module, numpy.contained(module))


def without_comments(text):
    return re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)


@functools.cache
def harmless():
    return {name: without_comments(text) for name, text in written("harmless").compiled.items()}


def each(test):
    for text in HOSTILE:
        test = example(text)(test)
    return test


@pytest.mark.slow
@each
@given(TEXTS.map("".join).filter(str.strip))
@settings(max_examples=25, deadline=None)
def test_python_reads_every_text_as_it_was_written(text):
    """What the module holds is what Python itself parses; nothing but texts differs from a harmless module."""
    source, plain = (numpy.text(written(one).module, code()) for one in (text, "harmless"))
    tree, other = ast.parse(source), ast.parse(plain)
    assert len(tree.body) == len(other.body)
    compile(source, "<printed>", "exec")
    strings = [node.value for node in ast.walk(tree) if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    # title, reach_reason, and doc and unit of one number
    assert strings.count(text) == 4
    for node, same in zip(ast.walk(tree), ast.walk(other), strict=True):
        assert type(node) is type(same)
    assert re.sub(r"\s", "", ast.get_docstring(tree)).startswith(re.sub(r"\s", "", text))


@pytest.mark.slow
@each
@given(TEXTS.map("".join))
@settings(max_examples=10, deadline=None)
def test_a_comment_in_c_holds_every_text(text):
    """Without its comments C is what it is with a harmless text."""
    assert {name: without_comments(one) for name, one in written(text).compiled.items()} == harmless()


@pytest.mark.slow
def test_a_compiler_takes_every_text(tmp_path):
    compiler = shlex.split(sysconfig.get_config_var("CC") or "cc")
    if not shutil.which(compiler[0]):
        pytest.skip("there is no C compiler")
    for name, text in written(" ".join(HOSTILE)).compiled.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    flags = ["-std=c11", "-Wall", "-Wextra", "-Wcomment", "-Wno-unused-function", "-Werror", "-fsyntax-only"]
    headers = [f"-I{place}" for place in (tmp_path, *include())]
    done = subprocess.run(
        [*compiler, *flags, *headers, *map(str, sorted(tmp_path.glob("*.c")))], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.slow
@each
@given(TEXTS.map("".join))
@settings(max_examples=25, deadline=None)
def test_markdown_shows_every_text(text):
    """By the rules of CommonMark: no mark is left that no backslash stands before, and a row stays a row."""
    shown = prose.in_markdown(text)
    assert len(shown.splitlines()) <= 1
    assert not re.search(r"(?<!\\)[`*\[\]<>#|$&]", re.sub(r"\\\\", "", shown))
    (table,) = document.parameters(written(text).module.record.mechanism, {})
    (row,) = (line for line in table.markdown().splitlines() if line.startswith("| $k$"))
    assert len(re.findall(r"(?<!\\)\|", re.sub(r"\\\\", "", row))) == 5


@each
@given(TEXTS.map("".join))
@settings(max_examples=25, deadline=None)
def test_latex_shows_every_text(text):
    """Nothing is left that TeX takes for a command, but those that set a letter, and no letter that its font lacks."""
    shown = prose.in_tex(text)
    rest = re.sub(r"\\[{}$&#_%]|\\text[a-z]+{}|\\ensuremath{(\\mathrm{[A-Z]}|\\[A-Za-z]+|o)}", "", shown)
    assert not re.search(r"[\\{}$&#_%~^`<>|]", rest) and len(shown.splitlines()) <= 1
    assert "\\" not in text or r"\textbackslash{}" in shown


def page_of(text):
    """With that text as a title and in a table, and symbols with names that TeX would read otherwise."""
    names = ("_", "__a", "a_", "k_größe", "λ_2", "弹簧", "hat", "lam", "soft")
    mechanism = written(text).module.record.mechanism
    symbols = pages.display(*((pages.latex(sp.Symbol(name)), sp.Symbol(name) ** 2 + u) for name in names), number="3")
    long = pages.display(("0", sp.Add(*(sp.Symbol(f"a_{n}") * (u**n + 1) for n in range(99)))))
    return pages.Page(
        prose.Prose(text), {"A": ["$u$ & 5 %", *document.parameters(mechanism, {})], "B": [symbols, long]}
    )


def test_long_sums_are_broken_between_terms():
    text = page_of("x").tex()
    assert text.count(r"a_{0} + ") == 1 and max(map(len, text.splitlines())) < 250
    assert r"$u$ \& 5 \%" in text and text.count(r"\tag{3}") == 1 and text.count(r"\begin{align}") == 2


@pytest.mark.slow
@pytest.mark.parametrize("text", [*HOSTILE, "".join(map(chr, range(0x20, 0x250))) + "α–Ω"])
def test_a_page_compiles_whatever_its_texts_say(tmp_path, text):
    if not shutil.which("pdflatex"):
        pytest.skip("there is no pdflatex: apt install texlive-latex-base")
    (tmp_path / "page.tex").write_text(page_of(text).tex(), encoding="utf-8")
    command = ["pdflatex", "-halt-on-error", "-interaction=nonstopmode", "-no-shell-escape", "page.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, errors="replace")
    assert done.returncode == 0, done.stdout


@pytest.mark.slow
@pytest.mark.parametrize("odd", [True, False])
def test_what_a_text_says_is_not_run(tmp_path, monkeypatch, capsys, odd):
    """From the statement to the module that is imported; the manifest is JSON, the heading one line."""
    import slowflow.derived

    monkeypatch.setattr(slowflow.derived, "FOLDER", tmp_path / "derived")
    monkeypatch.setattr(slowflow.derived, "__path__", [str(tmp_path / "derived")])
    text = "".join(HOSTILE)
    about = {"k": {"doc": text, "unit": text}}
    made = derive.mechanism("hostile", [(k * u, None)], about, title=text, reach=1.0, reach_reason=text, odd=odd)
    assert "EXECUTED" not in capsys.readouterr().out
    assert made.record.title.lower() == text.lower() and made.record.reach_reason == text
    assert (made.record.design[0].doc, made.record.design[0].unit) == (text, text)
    made.write(tmp_path / "out")
    assert json.loads((tmp_path / "out" / "MANIFEST.json").read_text())["mechanism"]["title"] == text
    headings = [line for line in (tmp_path / "out" / "derivation.md").read_text().splitlines() if line.startswith("#")]
    assert len(headings[0]) > len(text) and headings[1] == "## Equation of motion"


def test_text_that_no_file_can_hold_is_refused():
    with pytest.raises(ValueError, match="surrogate"):
        derive.mechanism("half", [(u, None)], {}, title="\ud800")


def test_templates_are_recompiled_after_environment_changes(tmp_path):
    """Bytecode of an environment that calls its filters otherwise would print their arguments in place of the text."""
    (tmp_path / "template.jinja").write_text("{{ 'text' | shown(8) }}")
    for k, shown in enumerate((lambda text, width: text, jinja2.pass_context(lambda context, text, width: text))):
        place = tmp_path / "environment.py"
        place.write_text(f"{k}\n")
        environment = jinja2.Environment(
            loader=jinja2.FileSystemLoader(tmp_path), bytecode_cache=bytecode.kept_beside(tmp_path, place)
        )
        environment.filters["shown"] = shown
        assert environment.get_template("template.jinja").render() == "text"
