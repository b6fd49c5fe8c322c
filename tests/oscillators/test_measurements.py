"""Measured columns: units in the head, errors with file and line."""

from __future__ import annotations

import numpy as np
import pytest

from slowflow import Isolator, read_csv
from slowflow.answers.files import in_csv
from slowflow.sizing import fit
from tests import files

MOUNT = Isolator.physical(**files.MOUNT).replace(zeta=0.05)


@pytest.fixture
def file(tmp_path):
    def made(text):
        path = tmp_path / "points.csv"
        path.write_text(text, encoding="utf-8")
        return path

    return made


def test_columns_are_in_si_units_whatever_is_between_them(file):
    found = read_csv(file("# rig 3\nf [rpm]; a/g ; A [mm];phi\n120; 0.05; 3.2;-1\n\n# end\n300;;1;2\n"))
    assert found["f"].tolist() == [2.0, 5.0] and found["a"][0] == 0.05 * 9.80665 and np.isnan(found["a"][1])
    assert found["A"].tolist() == [0.0032, 0.001] and found["phi"].tolist() == [-1.0, 2.0]
    assert found.units == {"f": "Hz", "a": "m/s^2", "A": "m"} and not found["f"].flags.writeable
    assert read_csv(file("\ufefft [ms]\tacceleration/(m/s^2)\n10\t2\n"))["t"].tolist() == [0.01]


def test_what_slowflow_writes_is_read_again(file):
    locus = MOUNT.fold_locus(samples=30)
    found = read_csv(file(in_csv([({}, locus.in_units("rpm", "mm"))], {})))
    assert found.units == {"f": "Hz", "A": "m", "F": "N"}
    for name, column in found.items():
        np.testing.assert_allclose(column, getattr(locus, name), rtol=1e-15)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            "f [Hz], a [furlong]\n1, 1\n",
            "points.csv:1: the unit of 'a \\[furlong\\]' is not known: it must be one of N,",
        ),
        ("f [Hz], a [gg]\n1, 1\n", "Did you mean 'g'"),
        ("#\nf [Hz], a [g]\n1, 1\n2, x\n", "points.csv:4: a = 'x' is not a number"),
        ("f [Hz], a [g]\n1, 1\n2\n", "points.csv:3: 1 columns, but the header has 2"),
        ("1, 2\n3, 4\n", "points.csv:1: '1' is not the header of a column: write a name and a unit"),
        ("f, f\n3, 4\n", "points.csv:1: there are two columns f"),
        ("f [Hz]\n", "points.csv: there must be a head"),
    ],
)
def test_what_is_no_table_of_columns_is_refused_with_its_line(text, message, file):
    with pytest.raises(ValueError, match=message):
        read_csv(file(text))


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(ValueError, match=r"none\.csv: this file cannot be read as text"):
        read_csv(tmp_path / "none.csv")


def test_columns_are_the_arguments_of_questions(file):
    f = np.array([1.5, 1.9, 2.1, 2.6, 4.0, 6.0])
    A = MOUNT.amplitudes(f=f, F=2.0).A
    rows = "".join(f"{60 * one!r}, {1e3 * other!r}, 2\n" for one, other in zip(f.tolist(), A.tolist(), strict=True))
    found = fit(MOUNT.replace(zeta=0.06), **read_csv(file("f [rpm], A [mm], F [N]\n" + rows)), free=["zeta"])
    assert found.value[0] == pytest.approx(0.05, rel=1e-6)
    record = read_csv(file("t [ms], acceleration [g]\n0, 0\n5, 2\n12, 0\n"))
    assert MOUNT.transient(**record) == MOUNT.transient(t=[0, 0.005, 0.012], acceleration=[0, 2 * 9.80665, 0])
    for unit in ("g^2/Hz", "(m/s^2)^2/Hz", "N^2/Hz"):
        psd = read_csv(file(f"f [Hz], G [{unit}]\n1, 0.1\n100, 1e-3\n"))
        assert MOUNT.random(psd=psd) == MOUNT.random(psd=([1, 100], [0.1, 1e-3]), unit=unit)
    with pytest.raises(ValueError, match="psd needs the columns f and G: G is missing"):
        MOUNT.random(psd=read_csv(file("f [Hz], g [g^2/Hz]\n1, 1e-4\n100, 1e-6\n")))
