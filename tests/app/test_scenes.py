"""Scenes and the command line: what they print and write, that nothing else is computed, and what they refuse."""

from __future__ import annotations

import contextlib
import csv
import json
import math
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest

import slowflow
from slowflow import Duffing, Isolator
from slowflow.answers import files
from slowflow.app import cli, scenes, starters, verdict
from slowflow.averaged import solvers
from slowflow.core import backend
from slowflow.example import isolator
from slowflow.sizing import tolerances
from slowflow.sizing.subject import IN_A_SHOCK, IN_A_SPECTRUM
from tests.files import ROOT

SHIPPED = sorted((ROOT / "scenes").glob("*.toml"))
MOUNT = (ROOT / "scenes" / "mount.toml").read_text().partition("\n[tolerances]")[0].replace(', "tolerances"', "")


def run(*arguments, capsys=None):
    """Exit code, what is printed, and what is said beside it."""
    code = cli.main([str(argument) for argument in arguments])
    return code, *capsys.readouterr()


def rows_of(path):
    """A CSV file as dictionaries."""
    return csv.DictReader(path.read_text().splitlines())


@pytest.fixture
def scene(tmp_path):
    """A file with that text."""

    def made(text: str) -> Path:
        path = tmp_path / "scene.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return made


@pytest.mark.parametrize(
    "path",
    [pytest.param(one, marks=pytest.mark.slow if one.stem in ("mount", "off_centre") else ()) for one in SHIPPED],
    ids=lambda path: path.stem,
)
def test_a_shipped_scene_runs(path, tmp_path, capsys):
    code, out, err = run("run", path, "-o", tmp_path / "out", capsys=capsys)
    content = json.loads((tmp_path / "out" / "answers.json").read_text())
    queries = scenes.read(path).queries
    # on a busy machine a question may say that it takes more than a second
    assert (code, out) == (0, "") and err.endswith(
        f"{len(queries)} answers are written to the folder {tmp_path / 'out'}\n"
    )
    assert [answer["question"] for answer in content["answers"]] == [one.question for one in queries]
    expected = {f"{one.question}.csv" for one in queries} | {"answers.json"}
    assert {file.name for file in (tmp_path / "out").iterdir()} == expected


def test_tolerances_cover_each_row_of_spectrum_and_shocks(scene, monkeypatch):
    text = (ROOT / "scenes" / "shaking_floor.toml").read_text().replace('"at_rest", ', '"tolerances", ')
    shock = "[shock]\nacceleration = 20.0\nduration = [0.011, 0.02]\n"
    read = scenes.read(scene(f"{text}\n[tolerances]\nk_h = 0.05\n\n{shock}"))
    queries = [one for one in read.queries if one.question == "tolerances"]
    monkeypatch.setattr(slowflow.sizing, "tolerances", lambda of, **arguments: arguments)
    found = [{name: value for name, value in read.answer(one).items() if name != "answers"} for one in queries]
    within, at_a_frequency = {"within": {"k_h": 0.05}}, [{}, {"f": 5.0}, {"f": 10.0}]
    expected = [{"Y": Y, **at, **within} for Y in (0.001, 0.004) for at in at_a_frequency]
    expected += [{"spectrum": ([2.2, 5.0, 25.0], [0.004, 0.002, 0.001]), **within}]
    expected += [{"shock": (20.0, duration), **within} for duration in (0.011, 0.02)]
    assert found == expected
    assert [str(one) for one in queries[-3:]] == [
        "tolerances in the load spectrum",
        "tolerances at acceleration = 20 m/s^2, duration = 11 ms",
        "tolerances at acceleration = 20 m/s^2, duration = 20 ms",
    ]


@pytest.mark.slow
def test_tolerances_over_spectrum_and_shocks_are_pythons(scene, tmp_path, capsys):
    ask = '[ask]\nquestions = ["tolerances"]\n[tolerances]\nzeta = 0.2\n'
    spectrum, shock = "[spectrum]\nf = [2.2, 5.0]\nF = [5, 3]\n", "[shock]\nacceleration = 20\nduration = 0.011\n"
    path = scene(MOUNT.partition("[ask]")[0] + ask + spectrum + shock)
    assert run("run", path, "-o", tmp_path, "--quiet", capsys=capsys) == (0, "", "")
    mount, rows = scenes.read(path).oscillator, list(rows_of(tmp_path / "tolerances.csv"))
    expected = [
        *tolerances(mount, {"zeta": 0.2}, spectrum=([2.2, 5.0], [5.0, 3.0]), answers=IN_A_SPECTRUM),
        *tolerances(mount, {"zeta": 0.2}, shock=(20.0, 0.011), answers=IN_A_SHOCK),
    ]
    assert [row["answer"] for row in rows] == [*IN_A_SPECTRUM, *IN_A_SHOCK]
    for row, one in zip(rows, expected, strict=True):
        in_metres = 1e-3 if row["unit"] == "mm" else 1.0
        assert float(row["high"]) * in_metres == pytest.approx(one.high, rel=1e-15)
        assert (row["duration/ms"] == "11.0") == (row["answer"] in IN_A_SHOCK)


@pytest.mark.slow
def test_the_mount_is_answered_in_newtons_millimetres_and_hertz(tmp_path, capsys):
    run("run", ROOT / "scenes" / "mount.toml", "-o", tmp_path, capsys=capsys)
    rows = list(rows_of(tmp_path / "saddle_nodes.csv"))
    assert [(row["F/N"], round(float(row["f/Hz"]), 2), row["kind"]) for row in rows if row["F/N"] == "5.0"] == [
        ("5.0", 2.18, "jump-up"),
        ("5.0", 2.28, "jump-down"),
    ]
    (row,) = rows_of(tmp_path / "at_rest.csv")
    assert float(row["x_cr/mm"]) == pytest.approx(1e3 * math.sqrt(0.080**2 - 0.071**2), rel=1e-15)
    assert float(row["k_0/(N/m)"]) == 1926.25
    states = list(rows_of(tmp_path / "amplitudes.csv"))
    assert round(float(states[1]["transmissibility_dB"]), 1) == -12.8


#: amplitudes and pulses of the scenes, in the units in which answers are shown
IN_UNITS = {
    ("shaking_floor", "saddle_nodes"): ("Y/mm", 4.0),
    ("shaking_floor", "amplitudes"): ("Y/mm", 1.0),
    ("shaking_floor", "peak"): ("Y/mm", 1.0),
    ("machine", "isolation"): ("U/(kg m)", 0.030),
    ("mount", "tolerances"): ("F/N", 3.0),
    ("shock", "transient"): ("acceleration/(m/s^2)", 10.0),
    ("table_1", "saddle_nodes"): ("F_0", 0.025),
}


@pytest.mark.parametrize(
    "case",
    [pytest.param(one, marks=pytest.mark.slow if one[1] == "tolerances" else ()) for one in IN_UNITS],
    ids=" ".join,
)
def test_result_comes_first_in_the_unit_of_the_head(case, tmp_path, capsys):
    (name, question), (column, value) = case, IN_UNITS[case]
    text = (ROOT / "scenes" / f"{name}.toml").read_text()
    path = tmp_path / "scene.toml"
    path.write_text(re.sub(r"questions = .*", f'questions = ["{question}"]', text))
    assert run("run", path, "-o", tmp_path, "--quiet", capsys=capsys) == (0, "", "")
    row = next(rows_of(tmp_path / f"{question}.csv"))
    assert next(iter(row)) == column and float(row[column]) == pytest.approx(value, rel=1e-15)
    content = json.loads((tmp_path / "answers.json").read_text())
    units = content["answers"][0]["units_of_arguments"]  # JSON has what was asked as the scene has it
    assert (
        units
        == {
            "shaking_floor": {"Y": "m", "f": "Hz"} if question == "amplitudes" else {"Y": "m"},
            "machine": {"U": "kg m"},
            "mount": {"F": "N"},
            "shock": {"acceleration": "m/s^2", "duration": "s"},
            "table_1": {},
        }[name]
    )


def test_written_numbers_have_all_digits_and_their_origin(tmp_path, capsys):
    path = ROOT / "scenes" / "table_1.toml"
    run("run", path, "-o", tmp_path, "--quiet", capsys=capsys)
    folds = [row for row in rows_of(tmp_path / "saddle_nodes.csv") if row["F_0"] == "0.04"]
    assert [float(row["Omega"]) for row in folds] == isolator().saddle_nodes(0.04).Omega.tolist()
    content = json.loads((tmp_path / "answers.json").read_text())
    assert content["made_by"]["slowflow"] == slowflow.__version__ and content["scene"]["file"] == "table_1.toml"
    assert (
        content["scene"]["sha256"] == scenes.read(path).sha256 and content["scene"]["content"]["isolator"]["lam"] == 3
    )
    (onset,) = (answer for answer in content["answers"] if answer["question"] == "saddle_node_onset")
    assert onset["F_SN"] == isolator().saddle_node_onset().F_SN


@pytest.mark.slow
def test_json_is_printed_when_wanted_and_text_otherwise(capsys):
    code, out, _ = run("run", ROOT / "scenes" / "table_1.toml", "--json", capsys=capsys)
    assert code == 0 and json.loads(out)["failed"] == []
    _, out, _ = run("run", ROOT / "scenes" / "mount.toml", capsys=capsys)
    assert "# saddle_nodes at F = 5 N\n f/Hz   A/mm       kind  corner\n2.182  21.15    jump-up   False" in out


def test_only_what_is_asked_for_is_computed(scene, monkeypatch, capsys):
    for name in ("frequency_response", "onset", "folds", "peak", "fold_locus", "states", "extrema"):
        monkeypatch.setattr(solvers, name, lambda *_, name=name: pytest.fail(f"{name} was computed"))
    path = scene(MOUNT.partition("questions")[0] + 'questions = ["detachment"]\n')
    code, out, _ = run("run", path, capsys=capsys)
    assert code == 0 and "F_cr          4.078 N" in out


def test_explain_lists_the_plan_and_solves_nothing(scene, monkeypatch, capsys):
    solved = ("saddle_nodes", "onset", "detachment", "peak", "fold_locus", "extrema", "frequency_response")
    for name in (*solved, "steady_states", "amplitude_bound"):
        monkeypatch.setattr(backend.SOLVER, name, lambda *_, name=name: pytest.fail(f"{name} was computed"))
    monkeypatch.setattr(scenes.Scene, "answer", lambda *_: pytest.fail("it was answered"))
    path = scene(MOUNT.replace("F = [3.0, 5.0]", "F = [0.3]"))
    code, out, _ = run("explain", path, capsys=capsys)
    assert code == 0 and "saddle_nodes at F = 0.3 N\n  force         skipped  sticks" in out
    assert out.count("  takes         ") == len(scenes.read(path).queries) and "\nin total " in out
    left = "rest, margins, hysteresis, isolation, spectrum, transient, shock_spectrum, random, tolerances, "
    left += "exact_response, fold_locus, cusps, isola_points"
    assert out.endswith(f"not requested, not computed: {left}\n")


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_every_question_of_a_shipped_scene_has_an_estimate(path):
    read = scenes.read(path)
    assert all(read.seconds(query) > 0 for query in read.queries)


def test_columns_of_a_scene_are_those_of_a_file(scene, tmp_path):
    (tmp_path / "floor.csv").write_text("f [Hz], G [(m/s^2)^2/Hz]\n1, 0.01\n5, 0.01\n100, 2e-5\n")
    (tmp_path / "pulse.csv").write_text("t [ms]; acceleration [g]\n0; 0\n5; 2\n12; 0\n")
    (tmp_path / "table.csv").write_text("# of the ship\nF [N]\tf [rpm]\n5\t120\n3\t300\n")
    files = '[psd]\nfile = "floor.csv"\n[shock]\nfile = "pulse.csv"\n[spectrum]\nfile = "table.csv"\n'
    head = MOUNT.partition("questions")[0] + 'questions = ["random", "transient", "spectrum"]\n\n'
    lists = {
        "floor": "[psd]\nf = [1, 5, 100]\nG = [0.01, 0.01, 2e-5]\nunit = '(m/s^2)^2/Hz'\n",
        "pulse": f"[shock]\nt = [0.0, 0.005, 0.012]\nacceleration = [0.0, {2 * 9.80665}, 0]\n",
        "table": "[spectrum]\nF = [5.0, 3.0]\nf = [2.0, 5.0]\n",
    }
    read, same = (scenes.read(scene(head + text)) for text in (files, "".join(lists.values())))
    for one, other in zip(read.queries, same.queries, strict=True):
        assert read.answer(one) == same.answer(other)
    (tmp_path / "table.csv").write_text("F [N], f [Hz]\n5, 2\n3, 5 Hz\n")
    with pytest.raises(ValueError, match=r"table.csv:3: f = '5 Hz' is not a number"):
        scenes.read(scene(head + files))
    with pytest.raises(scenes.SceneError, match=r"file = 3 in \[psd\] is not allowed"):
        scenes.read(scene(head + "[psd]\nfile = 3\n"))


def test_a_measured_loop_is_refused_where_it_is_read(scene):
    for rows, message in (
        ("x = [0.0, 1.0]", "F is missing"),
        ("x = [0.0, 1.0]\nF = [2.0]", "x, F must be rows of one length"),
    ):
        with pytest.raises(scenes.SceneError, match=rf"scene.toml:\d+: .*{message}"):
            scenes.read(scene(f"{MOUNT}\n[loop]\n{rows}\n"))
    with pytest.raises(scenes.SceneError, match=r"\[loop\] needs \[mount\] or \[spring\]: a loop is in SI units"):
        scenes.read(scene((ROOT / "scenes" / "table_1.toml").read_text() + "\n[loop]\nx = [0.0]\nF = [0.0]\n"))


def test_tables_say_what_motions_are_relative_to(capsys):
    for name, stated in (("shaking_floor", True), ("specification", True), ("mount", False), ("machine", False)):
        _, out, _ = run("run", ROOT / "scenes" / f"{name}.toml", capsys=capsys)
        assert ("# displacements are relative to the base; transmissibility and acceleration" in out) == stated


def test_a_base_is_given_by_its_acceleration_in_a_scene(scene):
    text = (ROOT / "scenes" / "shaking_floor.toml").read_text()
    text = text.replace("Y = [0.001, 0.004]", 'a = ["0.5 m/s^2", 1.0]').replace(
        "Y = [0.004, 0.002, 0.001]", "a = [0.5, 2, 9]"
    )
    read = scenes.read(scene(text))
    mount = Isolator.physical(**read.content["mount"]).replace(excitation="acceleration")
    found = {str(one): read.ask(one.question, **one.arguments) for one in read.queries}
    assert found["saddle_node_onset"].a_SN == mount.saddle_node_onset().a_SN
    assert found["peak at a = 0.5 m/s^2"] == mount.peak(0.5)
    assert found["spectrum"] == mount.spectrum(f=[2.2, 5.0, 25.0], a=[0.5, 2.0, 9.0])
    with pytest.raises(scenes.SceneError, match=r"Y is not a key of \[ask\] here: .*'acceleration' is a, in m/s"):
        scenes.read(scene(text.replace("[ask]", "[ask]\nY = 0.001")))


def test_a_cubic_spring_is_a_scene_in_newtons_and_metres(scene):
    text = '[spring]\nm = "12 kg"\nk_1 = "2 N/mm"\nk_3 = "0.005 N/mm^3"\nfriction = 0.8\nc = 12.0\n'
    text += '[ask]\nF = [2.0, 4.0]\nquestions = ["saddle_node_onset", "peak"]\n'
    read = scenes.read(scene(text))
    mount = Duffing.physical(m=12, k_1=2000, k_3=5e6, friction=0.8, c=12)
    assert read.oscillator == mount
    (onset,) = read.of("saddle_node_onset")
    assert read.answer(onset) == mount.saddle_node_onset().in_units()
    assert [one.arguments for one in read.of("peak")] == [{"F": 2.0}, {"F": 4.0}]
    base = scenes.read(scene(text.replace("c = 12.0", 'c = 12.0\nexcitation = "base"').replace("F =", 'a = "0.1 g" #')))
    assert base.of("peak")[0].arguments == {"a": pytest.approx(0.980665)}
    for right, wrong, message in (
        ('"2 N/mm"', '"2 N/cm"', "3: k_1 = '2 N/cm' is not allowed"),
        ("k_1 =", "k_v =", "3: k_v is not a key of [spring]"),
        ("F =", "F_0 =", "8: F_0 is not a key of [ask] here"),
    ):
        with pytest.raises(scenes.SceneError, match=re.escape(f"scene.toml:{message}")):
            scenes.read(scene(text.replace(right, wrong)))


def test_an_estimate_grows_with_what_is_asked(scene):
    few, many = (
        scenes.read(scene(MOUNT.partition("f = [5.0]")[0] + f'f = {f}\nquestions = ["amplitudes"]\n'))
        for f in ([5.0], [1.0, 2.0, 3.0, 4.0, 5.0])
    )
    assert many.seconds(many.queries[0]) == 5 * few.seconds(few.queries[0])


@pytest.mark.parametrize("more", ["eta = 0.02", 'excitation = "base"', 'excitation = "unbalance"', "load = 12.4"])
def test_explain_refuses_nothing_that_run_answers(more, scene, capsys):
    letter = {"base": "Y", "unbalance": "U"}.get(more.partition('"')[2].rstrip('"'), "F")
    text = MOUNT.partition("[ask]")[0] + f'{more}\n[ask]\n{letter} = [0.005]\nquestions = ["rest"]\n'
    assert run("run", scene(text), capsys=capsys)[0] == 0
    code, out, _ = run("explain", scene(text), capsys=capsys)
    assert code == 0 and "refused" not in out


def test_explain_and_check_say_what_run_refuses(scene, capsys):
    text = (
        MOUNT.partition("[ask]")[0]
        + 'eta = 0.02\n[ask]\nF = [3.0]\nquestions = ["transient", "random", "detachment"]\n'
    )
    path = scene(
        text + "[shock]\nacceleration = 10\nduration = 0.01\n[psd]\nf = [1, 5]\nG = [1e-4, 1e-4]\nunit = 'g^2/Hz'\n"
    )
    code, _, err = run("run", path, capsys=capsys)
    assert code == 1 and "structural damping is defined at one frequency" in err
    code, out, _ = run("explain", path, capsys=capsys)
    assert code == 0 and "detachment\n" in out
    code, _, checked = run("check", path, capsys=capsys)
    assert code == 2 and len(checked.splitlines()) == 2
    for question in ("transient", "random"):
        assert f"  refused       {question} is not available with eta: structural damping" in out
        assert f": {question} is not available with eta: structural damping" in checked
    required = '[require]\nabsolute_acceleration = { below = "1 g", rms = true, under = "random" }\n'
    path.write_text(path.read_text().replace('"transient", "random", ', "") + required)
    code, _, checked = run("check", path, capsys=capsys)
    assert code == 2 and ": random is not available with eta" in checked


#: oscillators that some questions refuse: no damping, none that grows, laws that shocks or PSDs lack, loads, no spring
REFUSING = {
    "undamped": "[duffing]\nalpha = 1\nbeta = 0.5",
    "quadratic": "[spring]\nm = 12\nk_1 = 2500\nk_3 = 1e5\nc_2 = 2.0",
    "structural": "[isolator]\nlam = 3\nr = 2\ndelta_h = 0.05\neta = 0.02",
    "friction under a load": "[duffing]\nalpha = 1\nbeta = 0.5\nmu = 0.01\nload = 0.02",
    "undamped under a load": MOUNT.partition("[ask]")[0].replace("zeta = 0.02", "load = 12.2").replace("0.4", "0.0"),
    "attached": "[isolator]\nlam = 2\nr = 1\ndelta_h = 0.1\nmu = 0.01\nc_2 = 0.1\ncontact = 'attached'",
    "no spring": "[duffing]\nalpha = 0\nbeta = 0\nzeta = 0.05",
    "base": "[isolator]\nlam = 2\nr = 1\ndelta_h = 0.1\nzeta = 0.05\nexcitation = 'base'\nload = 0.01",
}


@pytest.mark.parametrize("table", REFUSING.values(), ids=REFUSING)
def test_check_refuses_what_run_refuses_word_for_word(table):
    content = tomllib.loads(table)
    si = bool(content.keys() & {"mount", "spring"})
    F, f = ("F", "f") if si else ("F_0", "Omega")
    at = {F: [0.05], f: [2.0]}
    content |= {
        "ask": {**at, "samples": 20, "questions": [one for one in scenes.QUESTIONS if one != "tolerances"]},
        "spectrum": {f: [2.0, 2.5], F: [0.05, 0.05]},
        "shock": {"acceleration": 1.0, "duration": 0.02 if si else 0.5},
        "psd": {f: [0.5, 20.0], "G": [1e-4, 1e-4], **({"unit": "g^2/Hz"} if si else {})},
        "require": {"jumps": "none", "absolute_acceleration": {"below": 1.0, "rms": True, "under": ["random"]}},
    }
    scene, refused = scenes.from_tables(content), {}
    for query in scene.queries:
        try:
            scene.answer(query)
        except ValueError as error:
            refused[str(query)] = str(error)
        except ArithmeticError:
            pass  # found by computing
    checked = dict(verdict.refusals(scenes.from_tables(content)))
    outcome = verdict.verdict(scene)
    for place, case in enumerate(zip(outcome.requirement, outcome.case, strict=True)):
        assert (", ".join(case) in checked) <= bool(np.isnan(outcome.limit[place]))
    required = {name: why for name, why in checked.items() if name.startswith(scenes.REQUIREMENTS)}
    assert {name: why for name, why in checked.items() if name not in required} == refused != {}
    assert all(why in outcome.message for why in required.values())


@pytest.mark.parametrize("target", ["scene.toml", "folder", "none/report.html"])
def test_output_that_cannot_be_written_is_refused_before_work(target, scene, tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    path = scene(MOUNT + "[require]\njumps = 'none'\n[free]\nzeta = [0.02, 0.5]\n")
    (tmp_path / "folder").mkdir()
    monkeypatch.setattr(scenes.Scene, "ask", lambda *_, **__: pytest.fail("it was answered"))
    before, target = {one: one.is_dir() or one.read_bytes() for one in tmp_path.iterdir()}, tmp_path / target
    for command in (("report", path, "-o"), ("meet", path, "-o"), ("run", path, "-o", tmp_path / "new", "--report")):
        code, out, err = run(*command, target, capsys=capsys)
        assert (code, out) == (2, "") and err.startswith(f"{target}") and "Errno" not in err
    assert {one: one.is_dir() or one.read_bytes() for one in tmp_path.iterdir()} == before


def test_a_shock_of_a_scene_has_a_direction(scene):
    """Under a load, the centre is not in the middle of the springs' range."""
    text = MOUNT.partition("[ask]")[0] + "load = 13\n[ask]\nquestions = ['transient']\n"
    found = scenes.read(scene(text + "[shock]\nacceleration = [20, '-2 g']\nduration = 0.011\n"))
    up, down = (found.answer(query).A for query in found.queries)
    mount = Isolator.physical(**{**found.oscillator.given})
    assert down == 1e3 * mount.transient(acceleration=-2 * 9.80665, duration=0.011).A != up


def test_cusps_of_a_cubic_spring_are_asked_up_to_an_amplitude(scene):
    text = "[spring]\nm = 12\nk_1 = 2500\nk_3 = 1e5\nzeta = 0.02\n[ask]\nquestions = 'cusps'\n"
    (query,) = (found := scenes.read(scene(text + "A_max = '80 mm'\n"))).queries
    mount = Duffing.physical(m=12, k_1=2500, k_3=1e5, zeta=0.02)
    assert found.answer(query) == mount.cusps(A_max=0.08).in_units() and str(query) == "cusps at A_max = 80 mm"


def test_a_report_that_cannot_be_made_says_why(scene, capsys):
    pytest.importorskip("matplotlib")
    path = scene("[duffing]\nalpha = 1\nbeta = 1\n[ask]\nquestions = ['saddle_node_onset']\n")
    code, _, err = run("report", path, "-o", path.with_name("page.html"), capsys=capsys)
    assert code == 2 and "a report needs forcings in [ask]" in err


STUCK = """[spring]\nm = 12\nk_1 = 2500\nk_3 = 1e5\nfriction = 5\n[ask]\nF = [10.0, 1e308]\nquestions = ["cusps"]
[psd]\nf = [1, 20]\nG = [1e-9, 1e-9]\nunit = "g^2/Hz"
"""


def test_a_report_says_of_what_has_no_result_why(scene, capsys):
    """Friction holds the mass under this spectral density, and no force is bounded at one forcing."""
    pytest.importorskip("matplotlib")
    path = scene(STUCK)
    assert run("report", path, "-o", path.with_name("page.html"), capsys=capsys)[:2] == (0, "")
    text = path.with_name("page.html").read_text()
    for why in ("friction holds the mass nearly all of the time", "cusps needs A", "the response is unresolved at F"):
        assert f"Left out: {why}" in re.sub("<[^>]*>", "", text)
    assert "Lowest force with jumps" in text


def test_numbers_of_any_size_are_taken_or_refused_in_words(scene):
    """Powers of Python's numbers raise where NumPy's give infinity."""
    sizes = (1e-320, 1e-200, 1e-100, 1e100, 1e200, 1e308)
    for name, right in (("m", "12.0"), ("k_v", "2500.0"), ("L", "0.080"), ("k_h", "1700.0"), ("preload", "0.009")):
        for size in sizes:
            with contextlib.suppress(slowflow.SlowflowError):
                scenes.read(scene(MOUNT.replace(f"{name} = {right}", f"{name} = {size!r}")))


def test_answers_of_an_earlier_scene_go_and_others_are_refused(scene, tmp_path, capsys):
    out, ask = tmp_path / "out", MOUNT.partition("questions")[0]
    first, second = '["detachment", "saddle_nodes"]', '["detachment"]'
    assert run("run", scene(f"{ask}questions = {first}\n"), "-o", out, "--quiet", capsys=capsys)[0] == 0
    (out / "notes.csv").write_text("mine")
    assert run("run", scene(f"{ask}questions = {second}\n"), "-o", out, "--quiet", capsys=capsys)[0] == 0
    assert {path.name for path in out.iterdir()} == {"answers.json", "detachment.csv", "notes.csv"}
    for name in ("peak.csv", "detachment.csv"):  # one that slowflow did not write, one that was changed since
        before = (out / name).read_text() if (out / name).exists() else None
        (out / name).write_text("changed")
        code, printed, err = run("run", scene(f"{ask}questions = {second}\n"), "-o", out, "--quiet", capsys=capsys)
        assert (code, printed) == (2, "") and err.startswith(f"{out / name} differs from what slowflow wrote")
        assert (out / name).read_text() == "changed"
        (out / name).unlink() if before is None else (out / name).write_text(before)


@pytest.mark.skipif(sys.platform == "win32", reason="pipes of POSIX")
def test_a_reader_who_stops_is_no_error():
    command = [sys.executable, "-m", "slowflow", "run", str(ROOT / "scenes" / "table_1.toml"), "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        running.stdout.close()
        errors = running.stderr.read()
        assert running.wait() == cli.NOBODY_READS == 128 + 13 and errors == b""


def test_scenes_are_checked_in_turn_without_computing(scene, monkeypatch, capsys):
    monkeypatch.setattr(scenes.Scene, "answer", lambda *_: pytest.fail("it was answered"))
    right = sorted((ROOT / "scenes").glob("*.toml"))
    code, out, err = run("check", *right, capsys=capsys)
    assert (code, err) == (0, "") and [line.partition(":")[0] for line in out.splitlines()] == list(map(str, right))
    assert "to answer: rest, detachment, saddle_node_onset, saddle_nodes at F = 3 N, saddle_nodes at F = 5 N" in out
    code, out, err = run("check", scene(MOUNT.replace("L = 0.080", "L = 0")), right[0], capsys=capsys)
    assert code == 2 and ":8: L = 0 is not allowed" in err and out.startswith(str(right[0]))


def test_the_starter_runs_and_is_not_written_over(tmp_path, capsys):
    path = tmp_path / "mine.toml"
    assert run("new", path, capsys=capsys)[0] == 0 and path.read_text() == starters.STARTER
    assert run("run", path, capsys=capsys)[0] == 0
    path.write_text("mine")
    code, _, err = run("new", path, capsys=capsys)
    assert code == 2 and "already exists" in err and path.read_text() == "mine"


@pytest.fixture
def loop(tmp_path):
    """Five cycles of a stiffening spring with friction and a damper, in other units, in a file."""
    t = np.linspace(0.0, 5.0, 1000)
    x, v = 0.02 * np.sin(math.tau * t), 0.02 * math.tau * np.cos(math.tau * t)
    F = 1500 * x + 2e6 * x**3 + 0.7 * np.sign(v) + 9.0 * v + 0.05 * np.random.default_rng(0).standard_normal(t.size)
    path = tmp_path / "loop.csv"

    def written(head="# rig 7\nt [ms], x [mm], F [N]", columns=(1e3 * t, 1e3 * x, F)):
        rows = [", ".join(map(repr, row)) for row in np.transpose(columns).tolist()]
        path.write_text("\n".join([head, *rows]))
        return path

    return written


@pytest.mark.slow
def test_a_scene_of_a_measured_loop_is_ready_to_run(loop, tmp_path, capsys):
    out = tmp_path / "rig.toml"
    assert run("new", out, "--from", loop(), "--mass", "8 kg", capsys=capsys)[0] == 0
    mount = scenes.read(out).oscillator
    truth = {"m": 8.0, "k_1": 1500.0, "k_3": 2e6, "friction": 0.7, "c": 9.0}
    assert {name: mount.scales.sheet[name] for name in truth} == pytest.approx(truth, rel=0.03)
    intervals = re.findall(r"^(\w+) = \S+ *# (\S+) to (\S+) N", out.read_text(), re.MULTILINE)
    assert [name for name, *_ in intervals] == ["k_1", "k_3", "friction", "c"]
    assert all(float(low) < truth[name] < float(high) for name, low, high in intervals)
    code, answers, err = run("run", out, capsys=capsys)
    assert (code, err) == (0, "") and "saddle_node_onset" in answers
    assert run("new", out, "--from", loop(), "--mass", "8 kg", capsys=capsys)[0] == 2


@pytest.mark.slow
def test_numbers_that_a_loop_does_not_show_are_left_out(loop, tmp_path, capsys):
    """A linear spring alone, its times unknown."""
    x = 20 * np.sin(np.linspace(0.0, 5 * math.tau, 1000))
    columns = x, x + 0.02 * np.random.default_rng(1).standard_normal(x.size)
    path, out = loop("x [mm], F [N]", columns), tmp_path / "rig.toml"
    assert run("new", out, "--from", path, "--mass", "8", capsys=capsys)[0] == 0
    text = out.read_text()
    assert "# k_3 = " in text and "# friction = " in text and "a tenth of the largest in the loop" in text
    assert scenes.read(out).oscillator == Duffing.physical(m=8, k_1=float(re.search(r"k_1 = (\S+)", text)[1]))


@pytest.mark.parametrize(
    ("head", "message"),
    (
        ("t [ms], x [mm], y [N]", "loop.csv:1: a loop has columns x, F and, for viscous damping, t, not t, x, y"),
        ("# rig\nt [ms], x [N], F [N]", "loop.csv:2: x in N is not allowed: x must have a unit of m"),
        ("t [ms], x [mm], F [pound]", "loop.csv:1: the unit of 'F [pound]' is not known"),
        ("t [ms], x [mm], F [N]\n1, two, 3", "loop.csv:2: x = 'two' is not a number"),
        ("t [ms], x [mm], F [N]\n1, , 3", "loop.csv: x = nan is not allowed"),
        ("x [mm], t [ms], F [N]", "loop.csv: t is not allowed: the times must be ascending"),
    ),
)
def test_what_is_no_measured_loop_is_refused_with_its_line(head, message, loop, tmp_path, capsys):
    code, _, err = run("new", tmp_path / "rig.toml", "--from", loop(head), "--mass", "8", capsys=capsys)
    assert code == 2 and message in err and not (tmp_path / "rig.toml").exists()


def test_a_loop_needs_a_mass(loop, tmp_path, capsys):
    for options in (("--from", loop()), ("--mass", "8")):
        code, _, err = run("new", tmp_path / "rig.toml", *options, capsys=capsys)
        assert code == 2 and "must be used together" in err
    code, _, err = run("new", tmp_path / "rig.toml", "--from", loop(), "--mass", "8 g", capsys=capsys)
    assert code == 2 and "m = '8 g' is not allowed: m must be a number in kg" in err


#: the commonest wrong scenes
WRONG = tomllib.loads((ROOT / "tests" / "data" / "wrong_scenes.toml").read_text())


@pytest.mark.parametrize("what", WRONG)
def test_wrong_scene_is_refused_with_line_key_and_value(what, scene, capsys):
    case = WRONG[what]
    assert case["right"] in MOUNT
    path = scene(MOUNT.replace(case["right"], case["wrong"]))
    for command in ("run", "check", "explain"):
        code, out, err = run(command, path, capsys=capsys)
        assert (code, out) == (2, "") and err.startswith(f"{path}:{case['message']}")


def test_a_file_that_cannot_be_read_is_named(tmp_path, capsys):
    for command in ("run", "check", "explain", "report"):
        code, out, err = run(command, tmp_path / "none.toml", capsys=capsys)
        assert (code, out) == (2, "") and err.startswith(f"{tmp_path / 'none.toml'}: there is no such file")
        assert run(command, tmp_path, capsys=capsys) == (2, "", f"{tmp_path}: this is a folder, not a scene\n")
    (tmp_path / "taken").write_text("")
    (tmp_path / "scene.toml").write_text(MOUNT)
    code, out, err = run("run", tmp_path / "scene.toml", "-o", tmp_path / "taken", capsys=capsys)
    assert (code, out) == (2, "") and err.startswith(f"{tmp_path / 'taken'} is a file")
    (tmp_path / "bytes.toml").write_bytes(b"\xff\xfe")
    assert run("run", tmp_path / "bytes.toml", capsys=capsys)[0] == 2


def test_text_of_a_scene_is_never_evaluated(scene, capsys, monkeypatch):
    """Nothing but numbers is taken where a number is meant."""
    monkeypatch.setattr(os, "system", lambda *_: pytest.fail("it was run"))
    for evil in ("\"__import__('os').system('true')\"", '"1/0"', "true", "{ a = 1 }"):
        assert run("run", scene(MOUNT.replace("m = 12.0", f"m = {evil}")), capsys=capsys)[0] == 2
    forced = MOUNT.replace("F = [3.0, 5.0]", "F = [3.0, true]")
    assert forced != MOUNT and run("run", scene(forced), capsys=capsys)[0] == 2


def test_question_without_an_answer_is_said_and_others_written(scene, tmp_path, capsys):
    """Without damping no exact motion settles: the exit code is 1."""
    text = MOUNT.replace("friction = 0.4\nzeta = 0.02\n", "").partition("questions")[0]
    path = scene(text + 'questions = ["exact_response", "detachment"]\n')
    code, _, err = run("run", path, "-o", tmp_path / "out", capsys=capsys)
    assert code == 1 and "exact_response at F = 3 N: friction = 0 N and zeta = 0" in err
    content = json.loads((tmp_path / "out" / "answers.json").read_text())
    assert len(content["failed"]) == 2 and content["answers"][0]["question"] == "detachment"


def test_a_load_spectrum_is_a_table_of_pairs(scene, tmp_path, capsys):
    text = (
        MOUNT.partition("questions")[0]
        + 'questions = ["spectrum"]\n\n[spectrum]\nf = [2.0, 2.2, 5.0]\nF = [5, 5, 0.3]\n'
    )
    assert run("run", scene(text), "-o", tmp_path / "out", "--quiet", capsys=capsys) == (0, "", "")
    rows = list(rows_of(tmp_path / "out" / "spectrum.csv"))
    assert [(row["f/Hz"], row["F/N"], row["motions"], row["sticks"]) for row in rows] == [
        ("2.0", "5.0", "1", "false"),
        ("2.2", "5.0", "2", "false"),
        ("5.0", "0.3", "0", "true"),
    ]
    assert [row["crosses"] for row in rows[:2]] == ["false", "true"] and rows[2]["transmissibility_dB"] == "0.0"
    code, _, err = run("run", scene(text.replace("F = [5, 5, 0.3]", "F = [5, 5]")), capsys=capsys)
    assert code == 2 and ":21: F has 2 numbers, and f has 3: they are pairs" in err


@pytest.mark.slow
def test_tolerances_are_a_table_of_shares(scene, tmp_path, capsys):
    text = MOUNT.partition("questions")[0] + 'questions = ["tolerances"]\n\n[tolerances]\nk_h = 0.05\n'
    assert run("run", scene(text), "-o", tmp_path / "out", "--quiet", capsys=capsys) == (0, "", "")
    rows = list(rows_of(tmp_path / "out" / "tolerances.csv"))
    expected = tolerances(Isolator.physical(**scenes.read(scene(text)).content["mount"]), {"k_h": 0.05}, F=3)
    low = [float(row["low"]) for row in rows if row["F/N"] == "3.0" and not row["f/Hz"]]
    assert low == expected.in_units().low.tolist()
    for wrong, message in (
        ("k_h = 1.5", "20: k_h = 1.5 is not allowed"),
        ("kh = 0.05", "20: kh is not a key of [tolerances]: it must be one of m,"),
    ):
        code, _, err = run("run", scene(text.replace("k_h = 0.05", wrong)), capsys=capsys)
        assert code == 2 and message in err


def test_shock_is_peaks_by_durations_or_a_record(scene, tmp_path, capsys):
    head = MOUNT.partition("[ask]")[0] + '[ask]\nquestions = ["transient", "shock_spectrum"]\n\n[shock]\n'
    path = scene(head + "acceleration = [10.0, 30]\nduration = [0.011, 0.05, 0.1]\n")
    assert run("run", path, "-o", tmp_path / "out", "--quiet", capsys=capsys) == (0, "", "")
    rows = {name: list(rows_of(tmp_path / "out" / f"{name}.csv")) for name in ("transient", "shock_spectrum")}
    mount = scenes.read(path).oscillator
    assert [one.count() for one in scenes.read(path).queries if one.question == "shock_spectrum"] == [6]
    for one, row in zip(*rows.values(), strict=True):
        pulse = {"acceleration": float(one["acceleration/(m/s^2)"]), "duration": float(one["duration/ms"]) / 1e3}
        found = mount.transient(**pulse)
        assert float(one["A/mm"]) == 1e3 * found.A == float(row["A/mm"]), pulse
        assert float(row["duration/ms"]) == pytest.approx(1e3 * pulse["duration"], rel=1e-15)
    _, out, _ = run("explain", path, capsys=capsys)
    assert "averaging     skipped  not needed: the motion is not a steady state" in out
    record = head.replace(', "shock_spectrum"', "") + "acceleration = [0, 20.0, -5.0, 0]\nt = [0, 0.01, 0.02, 0.03]\n"
    assert run("run", scene(record), "-o", tmp_path / "two", "--quiet", capsys=capsys) == (0, "", "")
    (row,) = rows_of(tmp_path / "two" / "transient.csv")
    assert float(row["A/mm"]) == 1e3 * mount.transient(acceleration=[0, 20.0, -5.0, 0], t=[0, 0.01, 0.02, 0.03]).A
    for text, message in (
        (record.replace("0, 0.01, ", "0.01, "), "must have one time for each sample of acceleration"),
        (head, "acceleration is missing: [shock] needs acceleration, duration"),
        (head.partition("[shock]")[0], "questions = 'transient' needs a table [shock], which is missing"),
    ):
        code, _, err = run("run", scene(text), capsys=capsys)
        assert code == 2 and message in err


def test_laws_of_damping_are_keys_of_every_table(scene, capsys):
    text = (
        MOUNT.partition("[ask]")[0]
        + 'eta = 0.02\nc_2 = 30.0\ncontact = "attached"\n[ask]\nquestions = ["detachment"]\n'
    )
    mount = scenes.read(scene(text)).oscillator
    assert mount.given["c_2"] == 30.0 and mount.oscillator.contact == "attached"
    for table, parameters, same in (
        ("isolator", {"lam": 3, "r": 0.5, "delta_h": 0.02}, {"zeta": 0.03, "eta": 0.01, "contact": "attached"}),
        ("duffing", {"alpha": 1.0, "beta": 0.5}, {"eta": 0.05, "c_2": 0.2}),
    ):
        lines = "\n".join(f"{name} = {value!r}" for name, value in (parameters | same).items())
        path = scene(f'[{table}]\n{lines}\n[ask]\nF_0 = 0.03\nquestions = ["peak"]\n')
        made = {"isolator": Isolator, "duffing": slowflow.Duffing}[table](**parameters, **same)
        assert scenes.read(path).oscillator == made
    code, out, _ = run("run", path, capsys=capsys)
    assert code == 0 and f"{made.peak(0.03).A:.4g}" in out


def test_a_warning_about_the_design_is_passed_on(scene, capsys):
    code, _, err = run("run", scene(MOUNT.replace("preload = 0.009", "preload = 0.045")), capsys=capsys)
    assert code == 0 and "negative stiffness at rest" in err


def test_slips_of_units_are_told_when_a_scene_is_checked(scene, capsys):
    path = scene(MOUNT.replace("L = 0.080", "L = 80").replace("f = [5.0]", "f = [1500.0]"))
    code, _, err = run("check", path, capsys=capsys)
    assert code == 0 and [line.partition(f"{path}: ")[2][:12] for line in err.splitlines()] == [
        "L = 80 m is ",
        "f = 1500 Hz ",
    ]
    assert run("run", path, "--quiet", capsys=capsys)[0] == 0  # without another warning, which would be an error


def test_a_file_is_written_whole_or_not_at_all(tmp_path, monkeypatch):
    path = tmp_path / "answers.json"
    files.write(path, "first")
    monkeypatch.setattr(os, "replace", lambda *_: (_ for _ in ()).throw(OSError("disk full")))
    with pytest.raises(OSError, match="disk full"):
        files.write(path, "second")
    assert path.read_text() == "first" and list(tmp_path.iterdir()) == [path]


def test_json_has_null_for_what_there_is_not():
    text = files.in_json({"a": [math.nan, math.inf, 1.0], "b": {"c": 1 + 2j}})
    assert json.loads(text) == {"a": [None, "inf", 1.0], "b": {"c": [1.0, 2.0]}}


@pytest.mark.slow
def test_the_command_line_says_its_version_and_is_a_module_too():
    done = subprocess.run([sys.executable, "-m", "slowflow", "--version"], capture_output=True, text=True, check=True)
    assert done.stdout == f"slowflow {slowflow.__version__}\n"
    helped = subprocess.run([sys.executable, "-m", "slowflow", "--help"], capture_output=True, text=True, check=True)
    assert "Exit codes: 0 success; 1 a question without an answer" in " ".join(helped.stdout.split())


def test_a_file_that_is_no_text_is_named(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(scenes.SceneError, match=r"scene\.toml: this is not UTF-8: invalid start byte at byte 0"):
        scenes.read(path)
