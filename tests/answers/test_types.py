"""What type checkers know of questions and answers, and that it is what there is when a program runs."""

import ast
import importlib
import inspect
import re
import typing
from pathlib import Path

import numpy as np
import pytest

from docs.api import MODULES
from slowflow import Isolator
from slowflow.answers import physical_answers
from slowflow.answers.answer import Entry, Table
from slowflow.answers.quantities import Quantities
from slowflow.answers.table import QUESTIONS
from slowflow.oscillators import physical_designs
from slowflow.oscillators.physical import Physical
from tests.answers import user_script
from tests.oscillators.test_physical_designs import AT, SHEET, arguments
from tests.sampling import slow

#: a question of each kind, in SI units; a load takes the motion off the centre
ARGUMENTS = {
    **AT,
    **{"fold_locus": {"samples": 20}, "cusps": {}, "isola_points": {}, "steady_state": {"f": 3.0, "F": 20.0}},
    **{"exact_response": {"F": 20.0, "f": (2.9, 3.0)}, "sweep": {"f": [2.9, 3.0], "F": 20.0}},
}
ABOUT_THE_CENTRE = {"at_rest", "fold_locus", "cusps", "isola_points", "certify"}


def subclasses(kind):
    for one in kind.__subclasses__():
        yield one
        yield from subclasses(one)


def declared(kind):
    """The numbers of an answer, by name, as its type declares them."""
    cls = typing.get_origin(kind) or kind
    variables = {}
    for of in (kind, *(of for base in cls.__mro__ for of in vars(base).get("__orig_bases__", ()))):
        if parameters := getattr(typing.get_origin(of), "__parameters__", ()):
            variables |= zip(parameters, typing.get_args(of), strict=True)
    own = {
        name
        for base in cls.__mro__
        if base.__module__ == physical_answers.__name__
        for name in vars(base).get("__annotations__", ())
    }
    hints = typing.get_type_hints(cls)
    return {name: variables.get(hints[name], hints[name]) for name in own}


def is_of(value, hint):
    if typing.get_origin(hint) is np.ndarray:
        (kind,) = typing.get_args(typing.get_args(hint)[1])
        return isinstance(value, np.ndarray) and issubclass(value.dtype.type, kind)
    of = typing.get_origin(hint) or hint
    if isinstance(of, type) and issubclass(of, Quantities) and of is not Quantities:
        return isinstance(value, Quantities) and all(
            is_of(number, declared(hint)[name]) for name, number in value.values.items()
        )
    if options := typing.get_args(hint):
        return (
            isinstance(value, tuple) if typing.get_origin(hint) is tuple else any(is_of(value, one) for one in options)
        )
    return isinstance(value, hint)


def test_every_answer_in_si_units_has_a_type():
    public = {name: method for name, method in vars(Physical).items() if callable(method) and not name.startswith("_")}
    types = {name: method.__annotations__["return"] for name, method in public.items()}
    assert "Quantities" not in types.values()
    assert {name for name, kind in types.items() if kind.startswith("answers.")} == set(ARGUMENTS)


@pytest.mark.parametrize("load", [None, *slow(26.0)])
@pytest.mark.parametrize("excitation", ["force", *slow("base", "acceleration", "unbalance")])
def test_what_an_answer_has_its_type_declares(load, excitation):
    """Each of its numbers, whatever the mount: of any excitation, without a load and with one."""
    mount = Isolator.physical(**SHEET, load=load, excitation=excitation)
    for name in ARGUMENTS:
        if (load is not None and name in ABOUT_THE_CENTRE) or (
            mount.oscillator.excitation != "force" and name == "certify"
        ):
            continue
        declared_as, _, _ = getattr(Physical, name).__annotations__["return"].partition("[")
        kind = getattr(physical_answers, declared_as.removeprefix("answers."))
        found = getattr(mount, name)(**arguments(name, excitation, ARGUMENTS))
        for column, value in found.values.items():
            # a proof is asked for of the dimensionless oscillator only
            assert column == "proof" or is_of(value, declared(kind)[column]), (name, column, value)
        for entry in list(found)[:1] if found.has_rows else ():
            assert all(type(value).__name__ == Entry.__annotations__[one] for one, value in vars(entry).items()), name


def test_every_entry_of_a_table_has_its_numbers_declared():
    """Whatever the module: of averaging, of exact motions, of sizing; types are those of the arrays of its table."""
    for module in MODULES:
        importlib.import_module(module)
    scalars = {"Floats": "float", "Flags": "bool", "Ints": "int", "NDArray[np.int64]": "int", "NDArray[np.str_]": "str"}
    for table in subclasses(Table):
        for entry in (getattr(table, name, None) for name in ("entry", "with_mean")):
            kinds = {name: kind for one in table.__mro__ for name, kind in vars(one).get("__annotations__", {}).items()}
            for name in getattr(entry, "_fields", ()):
                kind = kinds.get(name, "Floats").removesuffix(" | None").removeprefix("npt.")  # phi is a property
                assert Entry.__annotations__[name] == scalars[kind], (table, name)


@pytest.mark.parametrize(
    "of, questions",
    {
        "iso": {*ARGUMENTS},
        "designs": {*QUESTIONS} - {"rest"},
        "mount": {*ARGUMENTS},
        "(mounts|loaded)": {*QUESTIONS},
    }.items(),
)
def test_each_question_is_in_the_script_that_lint_checks(of, questions):
    script = Path(user_script.__file__).read_text()
    assert not [name for name in questions if not re.search(rf"\b{of}\.{name}\(", script)]


@pytest.mark.slow
def test_what_type_checkers_accept_runs():
    """All of the script, but the function that is wrong on purpose."""
    r = np.array([1.9, 2.0])
    iso, mount = Isolator(lam=3, r=2.0, delta_h=0.08, mu=0.012, zeta=0.02), Isolator.physical(**SHEET)
    user_script.dimensionless(iso)
    user_script.many(Isolator.many(lam=3, r=r, delta_h=0.08, mu=0.012, zeta=0.02), r)
    user_script.physical(mount)
    user_script.many_mounts(mount.many(m=[25.0, 26.0]), mount.many(load=[25.0, 26.0]))
    xarray = pytest.importorskip("xarray", reason="the extra `grid` is not installed: xarray")
    user_script.maps(mount.many(m=xarray.DataArray([25.0, 26.0], dims="m")))


def test_what_many_mounts_take_is_declared():
    """Methods made of the table against the Protocols that type checkers have: names, kinds, what has a default."""
    (typed,) = (node for node in ast.parse(inspect.getsource(physical_designs)).body if isinstance(node, ast.If))
    calls = {one.name: one.body[0].args for one in typed.body if isinstance(one, ast.ClassDef)}
    for question in QUESTIONS:
        own = calls[physical_designs.PhysicalQuestions.__annotations__[question].removesuffix("[Found]")]
        keywords = zip(own.kwonlyargs, own.kw_defaults, strict=True)
        declared = {(one.arg, one_default is not None) for one, one_default in keywords}
        declared |= {("amplitude", True)} if own.posonlyargs else set()
        declared |= {(own.kwarg.arg, False)} if own.kwarg else set()
        _, *made = inspect.signature(getattr(physical_designs.PhysicalDesigns, question)).parameters.values()
        assert {(one.name, one.default is not one.empty) for one in made} == declared, question


def test_help_on_many_mounts_has_their_names_and_units():
    folds = physical_designs.PhysicalDesigns.saddle_nodes
    assert inspect.getdoc(folds).startswith("Find every fold at F (24), (30), sorted by f: .f in Hz, .A in m, .kind,")
    assert str(inspect.signature(folds)).startswith("(self, amplitude: 'Numbers | None' = None, /, *, max_count: 'int'")
