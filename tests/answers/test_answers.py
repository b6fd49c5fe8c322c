"""Answers as objects: they do not change, equal each other, go through copies and processes, and become tables."""

from __future__ import annotations

import copy
import html
import json
import pickle
import re
import sys
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers import answer
from slowflow.answers.results import SteadyStates
from slowflow.averaged.batches import Batch
from slowflow.example import isolator
from slowflow.oscillators.oscillator import Oscillator
from slowflow.sizing import fit, front, meet, tolerances
from slowflow.support.text import Sentence
from slowflow_kernels import rod_spring
from tests.files import MOUNT


class Objects(Mapping):
    """A user's objects by name: each is made once, when a test first needs it."""

    def __init__(self, names, made=None):
        self.names, self.made = dict.fromkeys(names), {} if made is None else made

    def __getitem__(self, name):
        if name not in self.names:
            raise KeyError(name)
        if name not in self.made:
            self.made[name] = EVERYTHING[name]()
        return self.made[name]

    def __iter__(self):
        return iter(self.names)

    def __len__(self):
        return len(self.names)

    def only(self, kept):
        """Those with such a name."""
        return Objects(filter(kept, self.names), self.made)


def over(name):
    """Two values along an axis of that name, where xarray is installed."""
    return pytest.importorskip("xarray").DataArray([1.0, 2.0], dims=name)


#: what is asked, not an answer
ASKS = {
    "isolator": lambda: isolator(),
    "duffing": lambda: Duffing(1.0, 0.1, 0.01, 0.02),
    "oscillator": lambda: Oscillator(rod_spring.MECHANISM, lam=3, r=2, delta_h=0.1),
    "second": lambda: OBJECTS["isolator"].second_approximation,
    "plan": lambda: OBJECTS["isolator"].explain("peak", 0.04),
    "restoring_force": lambda: OBJECTS["isolator"].restoring_force(),
    "equation_of_motion": lambda: OBJECTS["isolator"].equation_of_motion(),
    "designs": lambda: Isolator.many(lam=3, r=[[2.0], [3.0]], delta_h=[0.08, 0.1, 0.12], mu=0.012, zeta=0.02),
    "second designs": lambda: OBJECTS["designs"].second_approximation,
    "every law": lambda: isolator(eta=0.01, c_2=0.1, mu_s=0.02, contact="attached", excitation="base"),
    "off centre": lambda: Duffing(1.0, 0.5, 0.01, 0.05, load=0.3).off_centre,
    "plan off centre": lambda: isolator(load=0.03).explain("margins", 0.04),
    "designs under a load": lambda: Duffing.many(1.0, 0.5, 0.01, 0.05, load=[0.2, 0.3]),
    "mount": lambda: Isolator.physical(**MOUNT),
    "mounts": lambda: OBJECTS["mount"].many(m=[11.0, 12.0]),
    "map": lambda: Isolator.many(lam=3, r=over("r"), delta_h=0.1, mu=0.012, zeta=0.02),
    "second map": lambda: OBJECTS["map"].second_approximation,
    "map of mounts": lambda: OBJECTS["mount"].many(m=over("m")),
}
#: answers
SINGLE = {
    "peak": lambda: OBJECTS["isolator"].peak(0.04),
    "no peak": lambda: OBJECTS["isolator"].peak(0.01),
    "validity": lambda: OBJECTS["amplitudes"].validity,
    "saddle_node_onset": lambda: OBJECTS["isolator"].saddle_node_onset(),
    "detachment": lambda: OBJECTS["isolator"].detachment(),
    "certificate": lambda: OBJECTS["isolator"].certify(0.04, Omega=0.9),
    "steady_state": lambda: OBJECTS["isolator"].steady_state(Omega=0.9, F_0=0.04),
    "transient": lambda: OBJECTS["isolator"].transient(acceleration=0.4, duration=2.0),
    "margins": lambda: OBJECTS["isolator"].margins(0.04),
    "isolation": lambda: OBJECTS["isolator"].isolation(0.04),
    "at_rest": lambda: OBJECTS["isolator"].at_rest(),
    "slopes of folds": lambda: OBJECTS["isolator"].saddle_nodes(0.04).gradient(),
    "met": lambda: meet(OBJECTS["isolator"], {"zeta": (0.01, 0.1)}, at_least={"F_SN": 0.03}),
    "mount's answer": lambda: OBJECTS["mount"].margins(5),
    "mount's folds": lambda: OBJECTS["mount"].saddle_nodes(5),
    "mount at rest": lambda: OBJECTS["mount"].at_rest(),
}
#: those with several entries
ENTRIES = {
    "frequency_response": lambda: OBJECTS["isolator"].frequency_response(0.04, samples=50),
    "saddle_nodes": lambda: OBJECTS["isolator"].saddle_nodes(0.04),
    "certified": lambda: OBJECTS["isolator"].saddle_nodes(0.04, certify=True),
    "amplitudes": lambda: OBJECTS["isolator"].amplitudes(Omega=0.9, F_0=0.04),
    "measured": lambda: OBJECTS["amplitudes"].measure(),
    "measured folds": lambda: OBJECTS["saddle_nodes"].measure(),
    "fold_locus": lambda: OBJECTS["isolator"].fold_locus(samples=50),
    "cusps": lambda: OBJECTS["isolator"].cusps(),
    "isola_points": lambda: OBJECTS["isolator"].isola_points(),
    "second response": lambda: OBJECTS["second"].frequency_response(0.04, samples=50),
    "second folds": lambda: OBJECTS["second"].saddle_nodes(0.04),
    "second states": lambda: OBJECTS["second"].amplitudes(Omega=0.9, F_0=0.04),
    "exact_response": lambda: OBJECTS["isolator"].exact_response(0.04, Omega=(0.88, 0.92)),
    "sweep": lambda: OBJECTS["isolator"].sweep(Omega=[0.8, 0.9], F_0=0.04),
    "shock_spectrum": lambda: OBJECTS["isolator"].shock_spectrum(acceleration=0.4, duration=[1.0, 2.0]),
    "hysteresis": lambda: OBJECTS["isolator"].hysteresis(0.04),
    "front": lambda: front(
        OBJECTS["isolator"], {"zeta": (0.01, 0.1)}, high=["F_SN"], low=["A_peak"], F_0=0.04, points=2
    ),
    "fit": lambda: fit(OBJECTS["isolator"], A=[0.1, 0.2, 0.1], F_0=0.02, Omega=[0.7, 0.8, 0.9], free=["zeta"]),
    "spectrum": lambda: OBJECTS["isolator"].spectrum(Omega=[0.9, 1.4], F_0=0.04),
    "tolerances": lambda: tolerances(OBJECTS["isolator"], {"zeta": 0.1}, F_0=0.04, samples=20),
}
#: those of many designs
MANY = {
    "detachments": lambda: OBJECTS["designs"].detachment(),
    "onsets": lambda: OBJECTS["designs"].saddle_node_onset(),
    "folds": lambda: OBJECTS["designs"].saddle_nodes(0.04),
    "curves": lambda: OBJECTS["designs"].frequency_response(0.04, samples=20),
    "peaks": lambda: OBJECTS["designs"].peak([0.03, 0.04, 0.05]),
    "many margins": lambda: OBJECTS["designs"].margins(0.04),
    "many bands": lambda: OBJECTS["designs"].hysteresis(0.04),
    "many isolations": lambda: OBJECTS["designs"].isolation(0.04),
    "many spectra": lambda: OBJECTS["designs"].spectrum(Omega=[0.9, 1.4], F_0=[0.03, 0.05]),
    "many transients": lambda: OBJECTS["designs"].transient(acceleration=0.4, duration=2.0),
    "many shocks": lambda: OBJECTS["designs"].shock_spectrum(acceleration=0.4, duration=2.0),
    "states": lambda: OBJECTS["designs"].amplitudes(Omega=0.9, F_0=0.04),
    "many at rest": lambda: OBJECTS["designs"].at_rest(),
    "shocks under a load": lambda: OBJECTS["designs under a load"].shock_spectrum(acceleration=0.4, duration=2.0),
}
EVERYTHING = ASKS | SINGLE | ENTRIES | MANY

OBJECTS = Objects(EVERYTHING)
ANSWERS = OBJECTS.only(lambda name: name not in ASKS)
BATCHES, TABLES = ANSWERS.only(MANY.__contains__), ANSWERS.only(ENTRIES.__contains__)
COPIES = {"copy": copy.copy, "deepcopy": copy.deepcopy, "pickle": lambda one: pickle.loads(pickle.dumps(one))}


def arrays(one):
    """Every array that can be reached through public attributes."""
    if isinstance(one, answer.Answer):
        return (yield from arrays((*vars(one).values(), *one._content().values())))
    for value in one if isinstance(one, tuple) else ():
        if isinstance(value, np.ndarray):
            yield value
        else:
            yield from arrays(value)


@pytest.mark.parametrize("name", OBJECTS)
def test_each_is_counted_as_what_it_is(name):
    one = OBJECTS[name]
    kinds = isinstance(one, answer.Answer), isinstance(one, Batch), isinstance(one, answer.Table)
    assert kinds == (name in ANSWERS, name in BATCHES, name in TABLES)


@pytest.mark.parametrize("name", ANSWERS)
def test_what_an_answer_has_is_listed_for_completion(name):
    one = OBJECTS[name]
    assert set(one._content()) <= set(dir(one))


@pytest.mark.parametrize("how", COPIES)
@pytest.mark.parametrize("name", OBJECTS)
def test_a_copy_is_what_it_was(name, how):
    one = OBJECTS[name]
    other = COPIES[how](one)
    assert other == one and hash(other) == hash(one) and type(other) is type(one)
    assert not any(array.flags.writeable for array in arrays(other))


@pytest.mark.parametrize("name", ["zeta", "zeeta", "values", "shape", "model", "scales", "_singles"])
@pytest.mark.parametrize("what", [what for what in ASKS if "plan" not in what])  # they are tuples
def test_whatever_is_asked_about_cannot_be_changed(what, name):
    """No attribute can be added, as by a misspelling; and its printed form stays."""
    one = OBJECTS[what]
    before, printed = dict(vars(one)), repr(one)
    with pytest.raises(AttributeError, match=rf"{name}.* cannot be set|cannot assign to field '{name}'"):
        setattr(one, name, 0.5)
    with pytest.raises(AttributeError, match=r"cannot be deleted|cannot delete field"):
        delattr(one, name)
    assert vars(one).keys() == before.keys() and all(vars(one)[key] is value for key, value in before.items())
    assert repr(one) == printed


@pytest.mark.parametrize("F_0", [0.01, 0.018, 0.04])
@pytest.mark.parametrize(
    "ask",
    [
        lambda one, F_0: one.saddle_nodes(F_0),
        lambda one, F_0: one.amplitudes(Omega=[0.5, 0.9], F_0=F_0),
        lambda one, F_0: one.frequency_response(F_0, samples=50),
        lambda one, F_0: one.peak(F_0),
        lambda one, F_0: one.saddle_node_onset(),
        lambda one, F_0: one.detachment(),
    ],
)
def test_words_are_made_when_they_are_read_and_go_with_copies(ask, F_0, monkeypatch):
    """For sticking, without folds and with folds: no sentence is formatted before it is read."""
    made = []
    monkeypatch.setattr(
        Sentence, "format", lambda *arguments, _format=Sentence.format: made.append(1) or _format(*arguments)
    )
    one = Isolator(lam=3, r=2.0, delta_h=0.08, mu=0.012, zeta=0.02)
    unread = ask(one, F_0)
    # a mass at rest is a state among others, whose words are made with it
    assert not made or (F_0 == 0.01 and isinstance(unread, SteadyStates) and unread.A.size)
    copies = [how(ask(one.replace(), F_0)) for how in COPIES.values()]
    assert all(other.message == unread.message and other.remarks == unread.remarks for other in copies)
    assert str(other := ask(one.replace(), F_0)) == str(unread) and other == unread


@pytest.mark.parametrize("name", ANSWERS)
def test_an_answer_asked_again_is_equal_and_another_is_not(name):
    one = ANSWERS[name]
    assert one != next(other for other in ANSWERS.values() if other is not one)
    assert not any(array.flags.writeable for array in arrays(one))
    assert list(arrays(one)) or name in {
        *("peak", "no peak", "saddle_node_onset", "detachment", "transient", "margins", "isolation", "at_rest", "met"),
        *("mount's answer", "mount at rest"),
    }


def test_cached_answer_does_not_change():
    states, folds = ANSWERS["amplitudes"], BATCHES["folds"]
    for values in (states.phi, states.transmissibility, folds.remarks, BATCHES["onsets"].untruncated):
        with pytest.raises(ValueError, match="read-only"):
            values[...] = 0


def test_equality_sees_every_field():
    one, other = isolator().saddle_nodes(0.04), isolator().saddle_nodes(0.0400000001)
    assert one != other and one == isolator().saddle_nodes(0.04)
    assert BATCHES["peaks"] != OBJECTS["designs"].peak([0.03, 0.04, 0.051])
    assert OBJECTS["designs"] != Isolator.many(lam=3, r=[[2.0], [3.0]], delta_h=[0.08, 0.1, 0.12], mu=0.012)


def folds_at(F_0):
    return OBJECTS["isolator"].saddle_nodes(F_0)


@pytest.mark.slow
def test_answers_come_back_from_other_processes():
    forcings = [0.03, 0.04, 0.05]
    expected = [folds_at(F_0) for F_0 in forcings]
    with ProcessPoolExecutor(1) as pool:
        assert list(pool.map(OBJECTS["isolator"].saddle_nodes, forcings)) == expected
    joblib = pytest.importorskip("joblib")
    ask_one = joblib.delayed(OBJECTS["isolator"].saddle_nodes)
    assert joblib.Parallel(n_jobs=2)(ask_one(F_0) for F_0 in forcings) == expected


# ---- tables --------------------------------------------------------------------------------------------------------


# a front's columns are called by its answers
@pytest.mark.parametrize("name", [name for name in TABLES if name != "front"])
def test_entries_are_the_columns(name):
    table = TABLES[name]
    assert len(list(table)) == len(table)
    for field in table._entry_of()._fields:
        assert [getattr(entry, field) for entry in table] == pytest.approx(getattr(table, field).tolist(), nan_ok=True)
    assert set(table._entry_of()._fields) <= set(table.columns())
    assert repr(table[:1]) == repr(list(table)[:1]) and repr(table[1:][:1]) == repr(list(table)[1:2])


@pytest.mark.parametrize("name", ANSWERS)
def test_the_columns_have_one_length(name):
    columns = ANSWERS[name].columns()
    assert columns and len({len(column) for column in columns.values()}) == 1


@pytest.mark.parametrize("name", ANSWERS)
def test_plain_python_goes_through_json(name):
    plain = ANSWERS[name].to_dict()
    known = json.loads(json.dumps(plain))
    assert known.keys() == plain.keys()
    if "multipliers" in known:
        real, imaginary = np.moveaxis(np.array(known["multipliers"]), -1, 0)
        np.testing.assert_array_equal(real + 1j * imaginary, ANSWERS[name].multipliers)


@pytest.mark.parametrize("name", ANSWERS)
def test_pandas_and_xarray_hold_the_columns(name):
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    found, columns = ANSWERS[name], ANSWERS[name].columns()
    frame, dataset = found.to_pandas(), found.to_xarray()
    assert list(frame.columns) == list(columns)
    for key, column in columns.items():
        assert np.array_equal(frame[key], column, equal_nan=column.dtype.kind == "f")
    if name not in BATCHES:
        assert all(
            np.array_equal(dataset[key], frame[key], equal_nan=columns[key].dtype.kind == "f") for key in columns
        )


def test_a_table_says_of_what_it_is():
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    curve = ANSWERS["frequency_response"]
    expected = {"F_0": 0.04, "message": "", "mechanism": "rod_spring", **OBJECTS["isolator"].given}
    del expected["force"]
    for attributes in (curve.to_pandas().attrs, curve.to_xarray().attrs):
        assert expected.items() <= attributes.items()
    mount = OBJECTS["mount"]
    dataset = mount.frequency_response(5).to_xarray()
    assert {name: dataset[name].attrs["units"] for name in ("f", "A", "phi")} == {"f": "Hz", "A": "m", "phi": "rad"}
    assert dataset.attrs["F"] == 5 and mount.peak(5).to_pandas().attrs["units"]["A"] == "m"
    assert np.isnan(mount.peak(0.1).to_pandas()["A"][0])


def test_a_batch_keeps_its_designs_beside_the_answers():
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    folds = BATCHES["folds"]
    dataset, frame = folds.to_xarray(), folds.to_pandas()
    assert dataset["Omega"].dims == ("design_0", "design_1", "place") and dataset["r"].dims == ("design_0", "design_1")
    row = frame[(frame["r"] == 3.0) & (frame["delta_h"] == 0.1)].iloc[0]
    single = isolator(r=3.0, delta_h=0.1, lam=3, mu=0.012, zeta=0.02).saddle_nodes(0.04)
    assert [row["Omega_0"], row["Omega_1"]] == pytest.approx(single.Omega.tolist(), rel=1e-12)
    assert {variable.attrs["units"] for name, variable in dataset.variables.items()} == {"1"}
    assert list(BATCHES["peaks"].to_pandas()["F_0"]) == [0.03, 0.04, 0.05] * 2


def test_a_package_that_is_missing_is_asked_for_in_words(monkeypatch):
    for package in ("pandas", "xarray"):
        monkeypatch.setitem(sys.modules, package, None)
        for name in ("peak", "folds"):
            with pytest.raises(ImportError, match=rf"to_{package} needs {package}: pip install 'slowflow\[tables\]'"):
                getattr(ANSWERS[name], f"to_{package}")()


#: what is printed of answers that a user meets first; the digits are those of the records
PRINTED = {
    "saddle_node_onset": "F_SN          0.02171\nOmega         0.7762\nA             0.1825\nkind          cusp",
    "no peak": "F_0           0.01\nmessage       sticks: F_0 = 0.01 does not exceed 4 mu/pi = 0.0152789",
    "detachment": "F_cr          0.03002\nOmega_cr      0.9279\nu_cr          0.397",
    "met": "feasible      True\nzeta          0.03681\nF_SN          0.03",
}


@pytest.mark.parametrize("name", PRINTED)
def test_a_single_answer_prints_as_a_small_table(name):
    assert str(ANSWERS[name]) == PRINTED[name]


@pytest.mark.parametrize("name", ANSWERS)
def test_no_answer_prints_raw(name):
    """No codes of remarks and no objects, but head, rows, how many more, message; `repr` differs."""
    one = ANSWERS[name]
    printed = str(one)
    assert not any(raw in printed for raw in ("<", "array(", "Remark", f"{type(one).__name__}(", "None"))
    assert repr(one).startswith(f"{type(one).__name__}(") and repr(one) != printed
    lines = printed.splitlines()
    assert len(lines) <= answer.SHOWN + 3 and max(map(len, lines)) <= 200


@pytest.mark.parametrize("name", ANSWERS)
def test_a_notebook_shows_what_is_printed(name):
    """A table or the lines, without the answers within it; curves also have a plot."""
    pytest.importorskip("matplotlib")
    one = ANSWERS[name]
    text, figure, _ = one._repr_html_().partition("<figure>")
    tokens = html.unescape(re.sub(r"<[^>]*>", " ", text)).split()
    assert len(tokens) > 1 and str(one).split()[: len(tokens)] == tokens
    assert bool(figure) == (getattr(one, "picture", "folds") != "folds")


def test_what_is_printed_of_an_answer_are_its_numbers():
    """Every number of a single answer to four digits, with its name; None is left out."""
    for name in ("peak", "no peak", "margins", "isolation", "at_rest", "transient"):
        one = ANSWERS[name]
        printed = dict(line.split(None, 1) for line in str(one).splitlines())
        known = {key: value for key, value in one.to_dict().items() if value not in (None, "")}
        assert printed.keys() == known.keys() - {"remarks", "tau_detaches"} | (printed.keys() & {"tau_detaches"})
        for key, value in known.items():
            if isinstance(value, float) and key in printed and not one.text_of(key, value):
                assert float(printed[key]) == pytest.approx(value, rel=6e-4)


def test_remarks_are_printed_in_words():
    for name, one in ANSWERS.items():
        if not isinstance(one, Batch) and getattr(one, "remarks", 0):
            assert one.message and one.message in str(one), name
    near = isolator().peak(0.0155)
    assert near.remarks and str(near).endswith(f"message       {near.message}")


def test_answer_arrays_are_columns_and_intervals_have_two_ends():
    state = ANSWERS["steady_state"]
    lines = [line.split() for line in str(state).splitlines()]
    assert ["A", f"{state.A:.4g}"] in lines and ["stable", "True"] in lines
    at = next(k for k, line in enumerate(lines) if "multipliers" in line)
    column = lines[at].index("multipliers")
    assert [complex(line[column]) for line in lines[at + 1 :]] == pytest.approx(list(state.multipliers), rel=1e-3)
    proof = ANSWERS["certified"].proof
    printed = str(ANSWERS["certified"])
    for low, high in proof.Omega.tolist():
        assert f"  Omega         {low!r} to {high!r}" in printed
