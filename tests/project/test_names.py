"""Names by the field's language: identifiers that are not defined again, each with the term in its place."""

import ast
import re

import pytest

from tests.files import ROOT

#: folders whose names are done, each with names that stay
ROOMS = {
    "src/slowflow": set(),
    "benchmarks": set(),
    # a step's and two kernels' names, which generated code has
    "derivations": {"along", "beside", "held"},
    "docs": set(),
    "examples": set(),
    "explorer": set(),
    "setup.py": set(),
    "tests": set(),
}
#: fields of public answers and records, and public keywords, which stay, by file of `src/slowflow`
PUBLIC = {
    "answers/answer.py": {"share"},
    "answers/table.py": {"rests", "stands"},
    "answers/physical_answers.py": {"rests"},
    "app/verdict.py": {"share"},
    "exact/transient.py": {"rests"},
    "oscillators/oscillator.py": {"given"},
    "oscillators/physical.py": {"given"},
    "sizing/tolerances.py": {"share"},
    "support/record.py": {"held", "moved", "told"},
}
#: whole identifiers, without leading underscores and in lower case
GONE = {
    "alike": "no noun: the same, or what is equal",
    "alone": "no noun: single, isolated",
    "along": "no noun: a direction, a component, or what varies",
    "asked": "a query, arguments, or indices of valid cases",
    "beside": "a neighbour, an offset, or further columns",
    "given": "parameters, arguments or known values",
    "held": "a bound, an enclosure, a static state or what is valid",
    "leaves": "a predicate says what: detaches, jumps",
    "moved": "a sensitivity, an offset or a change",
    "moves": "sensitivities, or the gradient",
    "parts": "chunks, pieces or terms",
    "places": "positions, equilibria or a count",
    "play": "a dead zone",
    "rubs": "contact, which says where dry friction acts",
    "rests": "equilibria, or stick phases",
    "said": "a message or diagnostics",
    "settle": "converge",
    "share": "a ratio, a fraction or a step",
    "stands": "a predicate says what: is stable, is at rest",
    "told": "a message, or what is known",
    "wanted": "a target or a request",
    "words": "messages",
}
#: further ones of C; a certificate's public field is `doubt`
GONE_IN_C = GONE | {"doubtful": "undecided", "doubts": "undecided intervals, or inconclusive", "sf_held": "sf_bounded"}


def defined(tree):
    """Names that a module defines: functions, classes, arguments, variables, attributes and aliases."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name) | ast.arg(arg=name):
                yield name
            case ast.Name(id=name, ctx=ast.Store()) | ast.Attribute(attr=name, ctx=ast.Store()):
                yield name
            case ast.alias(asname=str(name)):
                yield name


@pytest.mark.slow
@pytest.mark.parametrize(("room", "public"), ROOMS.items())
def test_names_that_are_gone_do_not_return(room, public):
    files = [ROOT / room] if room.endswith(".py") else sorted((ROOT / room).rglob("*.py"))
    for path in files:
        names = {name.strip("_").lower() for name in defined(ast.parse(path.read_text(encoding="utf-8")))}
        kept = public | PUBLIC.get(path.as_posix().partition("src/slowflow/")[2], set())
        assert not {name: GONE[name] for name in names & GONE.keys() - kept}, path


@pytest.mark.parametrize("room", ["src/slowflow/native", "tests/native"])
def test_names_that_are_gone_do_not_return_in_c(room):
    """Whole identifiers, but in comments and strings."""
    for path in sorted((ROOT / room).rglob("*.[ch]")):
        code = re.sub(r'/\*.*?\*/|"(?:\\.|[^"\\\n])*"', "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        names = {name.strip("_").lower() for name in re.findall(r"[A-Za-z_]\w*", code)}
        assert not {name: GONE_IN_C[name] for name in names & GONE_IN_C.keys()}, path
