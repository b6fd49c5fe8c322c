"""Many mounts in SI units: each question is answered as of each mount single, with units."""

import ast
import inspect
import itertools
import pickle
import warnings

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers.physical_answers import Many
from slowflow.answers.quantities import EXCITED, ManyScales
from slowflow.answers.table import COLUMNS, QUESTIONS, SECOND, SameColumns
from slowflow.averaged.many import CODED
from slowflow.oscillators.physical_designs import ManyQuantities, PhysicalDesigns, PhysicalQuestions
from slowflow.support.errors import WrongType
from slowflow_kernels.conventions import FoldKind, Status
from tests.sampling import slow

SHEET = dict(m=25, k_v=9000, k_h=4000, n=3, L=0.08, preload=0.006, friction=3.6, zeta=0.03)
#: data that vary, those of the scales included; the third mount is none
VARIED = {
    "m": np.array([22.0, 25.0, -1.0, 27.0]),
    "k_v": np.array([8500.0, 9000.0, 9000.0, 9400.0]),
    "L": np.array([0.08, 0.08, 0.08, 0.075]),
    "preload": np.array([0.006, 0.004, 0.006, 0.008]),
    "friction": np.array([3.0, 2.0, 3.6, 1.0]),
}
NONE = 2
#: what each question of the table takes, an amplitude first
AT = {
    **{name: {} for name in ("saddle_node_onset", "detachment", "at_rest", "rest")},
    **{name: {"F": 20.0} for name in ("saddle_nodes", "peak", "margins", "hysteresis", "certify")},
    "isolation": {"F": 20.0, "level_dB": -6.0},
    "amplitudes": {"f": 3.0, "F": 20.0},
    "frequency_response": {"F": 20.0, "f": (1.0, 5.0), "samples": 30},
    "spectrum": {"f": [3.0, 4.0], "F": [20.0, 10.0]},
    "transient": {"acceleration": 20.0, "duration": 0.011, "after": 0.5},
    "shock_spectrum": {"acceleration": 20.0, "duration": 0.011},
    "random": {"psd": ([1.0, 50.0], [1e-2, 1e-4])},
}
#: amplitudes that move the mass, by what is excited
AMPLITUDES = {"force": 20.0, "base": 0.003, "acceleration": 0.8, "unbalance": 0.05}
LOADED = dict(load=26.0)
#: columns that one answer has under other names, or in words
NOT_OF_ONE = ("status", "onset", "fold_f", "fold_A", "fold_kind", "stands", "proved", "bits")


def arguments(question, excitation, of=AT):
    own, of_it = dict(of[question]), AMPLITUDES[excitation] / AMPLITUDES["force"]
    return own | ({EXCITED[excitation][0]: np.multiply(own.pop("F"), of_it)} if "F" in own else {})


def answered(mounts, question, excitation):
    """The answer, or the words of the refusal."""
    try:
        return getattr(mounts, question)(**arguments(question, excitation))
    except (ValueError, ArithmeticError) as refusal:
        return str(refusal)


def mount_of(k, **more):
    """The mount number k by itself."""
    return Isolator.physical(**SHEET, **more).replace(**{name: float(value[k]) for name, value in VARIED.items()})


def single_columns(found, columns):
    """What one answer has of the columns of a batch; a code has another name there."""
    for name in columns:
        if name in CODED or name in NOT_OF_ONE:
            continue
        value = found.values.get(name, getattr(found.answer, name, None))
        yield name, np.nan if value is None else np.asarray(value, dtype=float)


def same(many, single, k):
    """Each column of mount k is that of the mount single, NaN or 0 after the last entry."""
    inner = many.inner
    for name, value in single_columns(single, many.values):
        column = np.asarray(many.values[name][k], dtype=float)
        if name in inner:
            size, rest = value.size, column[value.size :]
            assert np.isnan(rest).all() or not (rest > 0).any(), name
            column = column[:size]
        if many.answer.question.name == "margins" and np.isinf(column):
            column = np.nan  # where there is no such forcing
        np.testing.assert_allclose(column, value, rtol=1e-9, err_msg=name)


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("load", [{}, *slow(LOADED)])
@pytest.mark.parametrize("excitation", ["force", *slow("base", "acceleration", "unbalance")])
def test_each_of_many_mounts_is_answered_as_alone(question, load, excitation):
    mount = Isolator.physical(**SHEET, **load, excitation=excitation)
    found = answered(mount.many(**VARIED), question, excitation)
    for k in (1, 3) if load else (0, 1, 3):
        single = answered(mount_of(k, **load, excitation=excitation), question, excitation)
        if isinstance(found, str):
            assert question == "rest" or isinstance(single, str), (found, single)  # of one the mass rests at x = 0
            return
        same(found, single, k)
    assert (found.status[NONE] == Status.INVALID).all()


@pytest.mark.parametrize("question", [name for name, row in QUESTIONS.items() if SECOND in row.columns])
def test_the_second_approximation_of_many_mounts_is_each_alone(question):
    found = answered(Isolator.physical(**SHEET).many(**VARIED).second_approximation, question, "force")
    for k in (0, 1):
        same(found, answered(mount_of(k).second_approximation, question, "force"), k)


@pytest.mark.parametrize("question", [name for name in QUESTIONS if name != "rest"])
@pytest.mark.parametrize("law", [{}, {"c_2": 5.0}])
def test_a_law_that_cubic_springs_lack_is_no_obstacle(question, law):
    """To shocks, random vibration and proofs."""
    mount = Duffing.physical(m=12, k_1=2500, k_3=4e5, friction=0.4, c=8.0, **law)
    found = answered(mount.many(m=[11.0, 12.0]), question, "force")
    single = answered(mount, question, "force")
    if isinstance(found, str):
        assert "c_2" in found and isinstance(single, str)
    else:
        same(found, single, 1)


@pytest.mark.parametrize("damping", [{"zeta": 0.02}, {"c": 8.0}])
@pytest.mark.parametrize("springs", [(2500.0, 4e5), (2500.0, 0.0), (0.0, 4e5), (-500.0, 4e6)])
def test_many_cubic_springs_are_answered_as_alone(springs, damping):
    k_1, k_3 = springs
    mount = Duffing.physical(m=12, k_1=2500, k_3=4e5, friction=0.4, **damping)
    found = mount.many(k_1=[k_1, 2500.0], k_3=k_3, m=[[11.0], [12.0]]).peak(F=5.0)
    single = mount.replace(k_1=k_1, k_3=k_3, m=11.0).peak(F=5.0)
    assert found.shape == (2, 2) if hasattr(found, "shape") else found.A.shape == (2, 2)
    np.testing.assert_allclose(found.A[0, 0], np.nan if single.A is None else single.A, rtol=1e-9)


def test_several_mounts_and_every_law_of_damping_vary():
    mount = Isolator.physical(**SHEET, mounts=4, eta=0.01, c_2=5.0, c_xx=300.0, contact="attached")
    varied = {"eta": [0.0, 0.02], "c_2": [5.0, 9.0], "c_xx": [0.0, 500.0], "k_v": [9000.0, 2000.0]}
    found = mount.many(**varied).saddle_nodes(F=20.0)
    for k in range(2):
        single = mount.replace(**{name: value[k] for name, value in varied.items()}).saddle_nodes(F=20.0)
        same(found, single, k)


def test_amplitudes_and_data_broadcast_and_keep_their_units():
    mount = Isolator.physical(**SHEET, excitation="base")
    mounts = mount.many(preload=[0.006, 0.004])
    found = mounts.peak(a=np.array([[0.5], [0.8], [1.1]]))
    assert found.A.shape == (3, 2) and found.units == {"A": "m", "f": "Hz"}
    assert found.in_units("um", "rpm").f[0, 0] == pytest.approx(60 * found.f[0, 0])
    frame = found.to_xarray()
    assert frame.A.attrs["units"] == "m" and frame.a.attrs["units"] == "m/s^2" and frame.k_v.attrs["units"] == "N/m"
    rows = found.columns()
    assert rows["a"].tolist() == [0.5, 0.5, 0.8, 0.8, 1.1, 1.1] and "A/mm" in str(found)
    folds = mounts.saddle_nodes(Y="3 mm")
    assert folds.units_of_columns()["f_0"] == "Hz" and folds.kind.max() <= max(FoldKind)
    assert pickle.loads(pickle.dumps(found)) == found


@pytest.mark.parametrize("question, of", [("saddle_node_onset", "F_SN"), ("saddle_nodes", "A"), ("peak", "f")])
def test_gradients_of_many_mounts_are_those_of_each(question, of):
    found = answered(Isolator.physical(**SHEET).many(**VARIED), question, "force").gradient()
    expected = np.atleast_2d(answered(mount_of(1), question, "force").gradient()[of])
    np.testing.assert_allclose(np.atleast_2d(found[of][1])[: len(expected)], expected, rtol=1e-8)


def test_what_many_mounts_cannot_be_asked_is_refused():
    mount = Isolator.physical(**SHEET)
    with pytest.raises(ValueError, match="static_friction is not available"):
        mount.replace(static_friction=4.0).many(m=[20.0, 25.0])
    with pytest.raises(TypeError, match="no argument 'mass': it must be one of m"):
        mount.many(mass=[20.0, 25.0])
    with pytest.raises(ValueError, match=r"shapes do not broadcast: m \(2,\)"):
        mount.many(m=[20.0, 25.0], k_v=[1.0, 2.0, 3.0])
    xarray = pytest.importorskip("xarray")
    with pytest.raises(ValueError, match="F has named axes"):
        mount.many(m=[20.0, 25.0]).peak(F=xarray.DataArray([20.0, 25.0], dims="F"))
    with pytest.raises(TypeError, match="the amplitude of the excitation is needed once, F in N: got U"):
        mount.many(m=[20.0, 25.0]).peak(U=0.1)
    with pytest.raises(WrongType, match="no argument 'S_0': it must be one of psd, unit, max_count, workers"):
        mount.many(m=[20.0, 25.0]).random(psd=([1.0, 50.0], [1e-4, 1e-6]), S_0=1.0)
    with pytest.raises(WrongType, match="random has no argument 'S_0': it must be one of psd, unit"):
        mount.random(psd=([1.0, 50.0], [1e-4, 1e-6]), S_0=1.0)
    with pytest.raises(WrongType, match=r"random takes psd, unit: .*'psd'"):
        mount.random()
    with pytest.raises(ValueError, match="load"):
        mount.many(load=[20.0, 25.0]).at_rest()


def test_frequencies_that_look_like_rpm_are_told():
    with pytest.warns(UserWarning, match="is it in rpm"):
        Isolator.physical(**SHEET).many(m=[20.0, 25.0]).amplitudes(f=[3.0, 900.0], F=20.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        Isolator.physical(**SHEET).many(m=[20.0, -1.0]).amplitudes(f=[3.0, 4.0], F=20.0)


def test_every_column_in_si_units_has_a_type():
    """Those of the table, whatever is excited, and what is computed when it is read."""
    declared = {*Many.__annotations__, *SameColumns.__annotations__, "F", "Y", "a", "U"}
    for excitation in EXCITED:
        scales = ManyScales(m=1.0, k_v=1.0, L=1.0, excitation=excitation)
        columns = {
            scales.symbol(name) for row in QUESTIONS.values() for system in row.columns.values() for name in system
        }
        assert columns <= declared
    assert {name for name in QUESTIONS if not hasattr(PhysicalDesigns, name)} == set()
    assert all(hasattr(ManyQuantities, name) for name in ("remarks", "untruncated", "gradient", "plot_map"))
    assert {COLUMNS[name].si for name in ("Omega", "fold_Omega")} == {"f", "fold_f"}


def test_editors_show_the_first_sentence_of_help():
    """The docstrings of attributes, which only editors read, are those of the methods made from the table."""
    (described,) = ast.parse(inspect.getsource(PhysicalQuestions)).body
    shown = {
        attribute.target.id: text.value.value
        for attribute, text in itertools.pairwise(described.body)
        if isinstance(attribute, ast.AnnAssign)
    }
    assert shown == {name: getattr(PhysicalQuestions, name).__doc__.partition(": .")[0] + "." for name in QUESTIONS}
