"""What type checkers know of questions and answers, and that it is what there is when a program runs."""

import importlib
import re
import subprocess
import sys
import typing

import numpy as np
import pytest

from docs.api import MODULES
from slowflow import Isolator
from slowflow.answers import physical_answers
from slowflow.answers.answer import Entry, Table
from slowflow.answers.quantities import EXCITED
from slowflow.oscillators.physical import Physical
from tests.files import ROOT
from tests.sampling import slow

SHEET = dict(m=25, k_v=9000, k_h=4000, n=3, L=0.08, preload=0.006, friction=3.6, zeta=0.03)
#: a question of each kind, in SI units; a load takes the motion off the centre
ARGUMENTS = {
    "rest": {},
    "at_rest": {},
    "saddle_node_onset": {},
    "detachment": {},
    "saddle_nodes": {"F": 20.0},
    "peak": {"F": 20.0},
    "amplitudes": {"f": 3.0, "F": 20.0},
    "frequency_response": {"F": 20.0, "samples": 20},
    "fold_locus": {"samples": 20},
    "cusps": {},
    "isola_points": {},
    "certify": {"F": 20.0},
    "random": {"psd": ([1.0, 50.0], [1e-4, 1e-6])},
    "steady_state": {"f": 3.0, "F": 20.0},
    "exact_response": {"F": 20.0, "f": (2.9, 3.0)},
    "sweep": {"f": [2.9, 3.0], "F": 20.0},
    "transient": {"acceleration": 5.0, "duration": 0.01},
    "shock_spectrum": {"acceleration": [5.0, 6.0], "duration": 0.01},
    "margins": {"F": 20.0},
    "hysteresis": {"F": 20.0},
    "isolation": {"F": 20.0},
    "spectrum": {"f": [3.0, 4.0], "F": 20.0},
}
ABOUT_THE_CENTRE = {"at_rest", "fold_locus", "cusps", "isola_points", "certify"}
SCRIPT = """
import numpy as np
from slowflow import Duffing, Isolator
from slowflow.oscillators.physical import Physical

def dimensionless(iso: Isolator, duffing: Duffing) -> None:
    reveal_type(iso.saddle_nodes(0.04).Omega)
    reveal_type(iso.amplitudes(Omega=[0.9, 1.0], F_0=0.04).transmissibility_dB)
    reveal_type(iso.frequency_response(0.04).branch)
    reveal_type(duffing.peak(0.04).A)
    reveal_type(duffing.detachment().F_cr)
    reveal_type(duffing.saddle_node_onset().F_SN)
    reveal_type([fold.Omega for fold in iso.saddle_nodes(0.04)])
    Omega, A, kind, corner = iso.saddle_nodes(0.04)[0]
    reveal_type(iso.saddle_nodes(0.04).plot())

def physical(mount: Physical) -> None:
    reveal_type(mount.saddle_nodes(F=5).f)
    reveal_type(mount.amplitudes(f=np.linspace(3, 5), F=np.float32(5)).transmissibility_dB)
    reveal_type(mount.frequency_response(5.0, f=(1, 3)).A)
    reveal_type(mount.peak(5).A)
    reveal_type(mount.saddle_node_onset().F_SN)
    reveal_type(mount.saddle_nodes(5)[0].corner)
    reveal_type(mount.oscillator.peak(0.04).A)
    reveal_type(mount.steady_state(f=3, F=5).t)
    reveal_type(mount.many(m=[11.0, 12.0]).peak(F=[5.0, 6.0]).A)
    reveal_type(mount.many(m=[11.0, 12.0]).amplitudes(f=3, F=5, max_count=2).answer)
    reveal_type(mount.many(m=[11.0, 12.0]).random(psd=([1.0, 50.0], [1e-4, 1e-6])).x_rms)

def wrong(iso: Isolator, mount: Physical) -> None:
    iso.saddle_nodes("x")  # wrong
    iso.amplitudes(Omega="x", F_0=0.04)  # wrong
    iso.saddle_nodes(0.04).onmega  # wrong
    iso.saddle_nodes(0.04)[0].onmega  # wrong
    f, *_ = mount.saddle_nodes(5)[0]  # wrong
    mount.saddle_nodes(F=None)  # wrong
    mount.amplitudes(f=None, F=5)  # wrong
    mount.frequency_response(5, f="ab")  # wrong
    mount.saddle_nodes(F=[5])  # wrong
    mount.many(m=[11.0, 12.0]).peak(G=5)  # wrong
    mount.many(m=[11.0, 12.0]).amplitudes(F=5)  # wrong
"""


def subclasses(kind):
    for one in kind.__subclasses__():
        yield one
        yield from subclasses(one)


def declared(cls):
    """The numbers of an answer, by name, as its type declares them."""
    hints = typing.get_type_hints(cls)
    own = {
        name
        for base in cls.__mro__
        if base.__module__ == physical_answers.__name__
        for name in vars(base).get("__annotations__", ())
    }
    excited = [typing.get_args(base)[0] for base in getattr(cls, "__orig_bases__", ()) if typing.get_args(base)]
    return {name: excited[0] if isinstance(hints[name], typing.TypeVar) else hints[name] for name in own}


def is_of(value, hint):
    if typing.get_origin(hint) is np.ndarray:
        (kind,) = typing.get_args(typing.get_args(hint)[1])
        return isinstance(value, np.ndarray) and issubclass(value.dtype.type, kind)
    if options := typing.get_args(hint):
        return (
            isinstance(value, tuple) if typing.get_origin(hint) is tuple else any(is_of(value, one) for one in options)
        )
    if issubclass(hint, physical_answers.Quantities) and hint is not physical_answers.Quantities:
        return all(is_of(number, declared(hint)[name]) for name, number in value.values.items())
    return isinstance(value, hint)


def test_every_answer_in_si_units_has_a_type():
    public = {name: method for name, method in vars(Physical).items() if callable(method) and not name.startswith("_")}
    types = {name: method.__annotations__["return"] for name, method in public.items()}
    assert "Quantities" not in types.values()
    assert {name for name, kind in types.items() if kind.startswith("answers.")} == set(ARGUMENTS)


@pytest.mark.parametrize("load", [None, *slow(26.0)])
@pytest.mark.parametrize(
    "excitation, F", [("force", 20.0), *slow(("base", 0.003), ("acceleration", 0.8), ("unbalance", 0.05))]
)
def test_what_an_answer_has_its_type_declares(load, excitation, F):
    """Each of its numbers, whatever the mount: of any excitation, without a load and with one."""
    mount = Isolator.physical(**SHEET, load=load, excitation=excitation)
    for name, arguments in ARGUMENTS.items():
        if (load is not None and name in ABOUT_THE_CENTRE) or (
            mount.oscillator.excitation != "force" and name == "certify"
        ):
            continue
        kind = getattr(physical_answers, getattr(Physical, name).__annotations__["return"].removeprefix("answers."))
        own = {one: value for one, value in arguments.items() if one != "F"}
        found = getattr(mount, name)(**own | ({EXCITED[excitation][0]: F} if "F" in arguments else {}))
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


@pytest.mark.slow
def test_mypy_knows_answers_and_refuses_words_for_numbers(tmp_path):
    """A user's script; of the package it reads what `make lint` has left in mypy's cache."""
    script = tmp_path / "script.py"
    script.write_text(SCRIPT)
    ask = [sys.executable, "-m", "mypy", "--hide-error-context", "--no-color-output", str(script)]
    report = subprocess.run(ask, capture_output=True, text=True, cwd=ROOT).stdout
    revealed = re.findall(r'note: Revealed type is "(.*)"', report)
    assert len(revealed) == SCRIPT.count("reveal_type"), report
    assert not {"Any", "float | Any"} & set(revealed), report
    wrong = {number for number, line in enumerate(SCRIPT.splitlines(), start=1) if "# wrong" in line}
    assert {int(number) for number in re.findall(r"script\.py:(\d+): error", report)} == wrong, report
