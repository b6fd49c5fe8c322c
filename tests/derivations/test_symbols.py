"""One symbol, one meaning: SymPy takes two symbols of one name with the same assumptions for one."""

from __future__ import annotations

import ast
import functools
from collections import defaultdict

import pytest

from tests.project.test_rooms import DERIVATION

#: modules whose symbols are those of the rooms that come later, which make others
SHARED = ("symbols.py", "paper/averaging.py", "paper/slow_flow.py")
PAPER = ("symbols.py", *(f"paper/{path.name}" for path in sorted((DERIVATION / "paper").glob("*.py"))))
LATER = ("systems", "forces", "asymmetric", "extensions", "codegen")


def made(tree):
    """Each symbol that is made by its name: the name with its assumptions."""
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and ast.unparse(call.func) in ("sp.Symbol", "sp.symbols"):
            names, assumptions = call.args[0], sorted(map(ast.unparse, call.keywords))
            if isinstance(names, ast.Constant):
                yield from ((name, *assumptions) for name in names.value.replace(",", " ").split())


@functools.cache
def symbols(module, throughout=True):
    """Those of a module, or those that are not of one function."""
    tree = ast.parse((DERIVATION / module).read_text(encoding="utf-8"))
    if not throughout:
        tree.body = [statement for statement in tree.body if isinstance(statement, ast.Assign)]
    return frozenset(made(tree))


def test_a_symbol_of_the_paper_is_made_once():
    found = defaultdict(list)
    for module in PAPER:
        for symbol in symbols(module):
            found[symbol].append(module)
    assert len(found) > 60
    assert not {symbol: modules for symbol, modules in found.items() if len(modules) > 1}


@pytest.mark.parametrize("room", LATER)
def test_a_later_room_imports_symbols_of_the_paper(room):
    shared = frozenset().union(*(symbols(module, throughout=False) for module in SHARED))
    for path in sorted((DERIVATION / room).rglob("*.py")):
        assert not symbols(path.relative_to(DERIVATION).as_posix()) & shared, path
