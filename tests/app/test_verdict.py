"""What a scene requires: limits, values and margins against closed forms and other answers, exit codes, refusals."""

import json
import math

import pytest
from scipy.optimize import brentq

from slowflow import Isolator
from slowflow.app import cli
from slowflow.app.scenes import read
from slowflow.app.verdict import in_words, meet, verdict
from slowflow.support.errors import SceneError
from tests.files import MOUNT, Lazily

report = Lazily("slowflow.app.report")

#: a linear mount: without a preload the springs never touch
LINEAR = {"m": 10.0, "k_v": 4000.0, "k_h": 1000.0, "L": 0.1, "preload": 0.0, "zeta": 0.1}
f_n = 20.0 / math.tau
SHOCK = "[shock]\nacceleration = [10, 30]\nduration = [0.011]\n"
PSD = "[psd]\nf = [1.0, 5.0, 100.0]\nG = [1e-4, 1e-4, 2.5e-7]\nunit = 'g^2/Hz'\n"


def scene(tmp_path, required, more="", parameters=LINEAR, F="F = [5.0]\n", kind="mount"):
    numbers = "\n".join(f"{name} = {value!r}" for name, value in parameters.items())
    path = tmp_path / "scene.toml"
    path.write_text(f"[{kind}]\n{numbers}\n[ask]\n{F}\n{more}\n[require]\n{required}\n")
    return path


def test_a_linear_mount_has_margins_in_closed_form(tmp_path):
    """Transmissibility of a viscous mount over r = f/f_n; its peak is F/(2 zeta sqrt(1 - zeta^2) k_v)."""
    required = 'jumps = "none"\ndetachment = "none"\ntransmissibility_dB = { below = -20, from_f = 14 }\n'
    required += 'relative_displacement = { below = "7 mm", under = "peak" }'
    found = verdict(read(scene(tmp_path, required)))
    assert found.met.tolist() == [True, True, True, True]
    assert found.margin[:2].tolist() == [math.inf, math.inf]
    r2 = (found.value[2] / f_n) ** 2
    assert (1 + 0.04 * r2) / ((1 - r2) ** 2 + 0.04 * r2) == pytest.approx(0.01, rel=1e-10)
    assert found.margin[2] == pytest.approx(14 / found.value[2])
    peak = 5.0 / (0.2 * math.sqrt(0.99) * 4000)
    assert found.value[3] == pytest.approx(1e3 * peak, rel=1e-12)
    assert found.limit[3] == 7.0 and found.unit[3] == "mm"
    assert found.margin[3] == pytest.approx(7e-3 / peak, rel=1e-12)
    assert (
        in_words(found) == "requirements met: 4 of 4; the smallest margin: relative_displacement, F = 5 N, margin 1.11"
    )


def test_a_peak_under_a_load_counts_from_the_centre(tmp_path):
    """As a shock does: the mean is part of the largest |x|, which an exact motion reaches but for averaging's error."""
    parameters = MOUNT | {"load": 14.0, "zeta": 0.05}
    required = 'relative_displacement = { below = "25 mm", under = "peak" }'
    found = verdict(read(scene(tmp_path, required, parameters=parameters)))
    mount = Isolator.physical(**parameters)
    peak = mount.peak(F=5.0)
    exact = mount.steady_state(f=peak.f_max, F=5.0, x_0=peak.x_max)
    assert found.met.tolist() == [False] and abs(peak.B) > 5e-3
    assert found.value[0] == pytest.approx(1e3 * peak.x_max, rel=1e-12)
    assert found.value[0] == pytest.approx(1e3 * exact.A, rel=0.05)


def test_margins_and_shocks_are_those_of_their_questions(tmp_path):
    required = 'jumps = "none"\ndetachment = "none"\nrelative_displacement = { below = 0.006, under = "shock" }\n'
    required += 'absolute_acceleration = { below = "0.2 g", under = "shock" }'
    found = verdict(read(scene(tmp_path, required, SHOCK, MOUNT, "F = [3.0]\n")))
    mount = Isolator.physical(**MOUNT)
    margins = mount.margins(3.0)
    assert found.margin[:2].tolist() == [margins.of_SN, margins.of_cr]
    assert found.met[:2].tolist() == [False, True]
    shocks = [mount.transient(acceleration=a, duration=0.011) for a in (10.0, 30.0)]
    assert found.value[2:4].tolist() == pytest.approx([1e3 * one.A for one in shocks], rel=1e-12)
    assert found.value[4:].tolist() == pytest.approx([one.a_max for one in shocks], rel=1e-12)
    assert found.met[2:].tolist() == [True, False, True, False]
    assert in_words(found).startswith("requirements not met: 3 of 6; the first: jumps, F = 3 N, margin 0.888")


def test_requirements_under_a_spectrum_are_of_random_vibration(tmp_path):
    required = 'relative_displacement = { below = 0.02, under = "random", duration = 3600 }\n'
    required += 'absolute_acceleration = { below = "0.05 g", under = "random", rms = true }'
    found = verdict(read(scene(tmp_path, required, PSD, MOUNT, "")))
    random = Isolator.physical(**MOUNT).random(psd=([1.0, 5.0, 100.0], [1e-4, 1e-4, 2.5e-7]))
    assert found.value[0] == pytest.approx(1e3 * random.largest(3600)[0])
    assert found.value[1] == pytest.approx(random.a_rms[0])
    assert found.limit[1] == pytest.approx(0.05 * 9.80665)
    assert found.met.tolist() == [True, False]


@pytest.mark.slow
def test_the_share_of_products_that_meet_all_is_in_closed_form(tmp_path, capsys):
    """Of dampings drawn evenly those that bound the peak, and those that isolate: all between two roots."""
    required = 'relative_displacement = { below = "6.5 mm", under = "peak" }\n'
    required += "transmissibility_dB = { below = -20, from_f = 13 }"
    ask = "F = [5.0]\nquestions = ['tolerances']\n"
    path = scene(tmp_path, required, "[tolerances]\nzeta = 0.5\n", F=ask)
    r2 = (13 / f_n) ** 2
    least = brentq(lambda zeta: 5 / (2 * zeta * math.sqrt(1 - zeta**2) * 4000) - 6.5e-3, 0.05, 0.15)
    most = math.sqrt((0.01 * (1 - r2) ** 2 - 1) / (0.99 * 4 * r2))
    assert 0.05 < least < most < 0.15
    found = verdict(read(path))
    expected = [(0.15 - least) / 0.1, (most - 0.05) / 0.1]
    assert found.share == pytest.approx(expected, abs=1 / 200)
    assert found.products == pytest.approx((most - least) / 0.1, abs=2 / 200)
    assert found.columns()["share"].tolist() == found.share.tolist()
    assert in_words(found).endswith(f"{100 * found.products:g} of 100 products within [tolerances] meet all")
    cli.main(["run", "--json", str(path)])
    assert json.loads(capsys.readouterr().out)["verdict"]["products"] == found.products


def test_a_duration_and_a_frequency_may_have_units(tmp_path):
    required = "relative_displacement = { below = 0.02, under = 'random', duration = %s }\n"
    required += "transmissibility_dB = { below = -20, from_f = %s }"
    plain, other = (verdict(read(scene(tmp_path, required % at, PSD))) for at in ((3600, 14), ("'1 h'", "'840 rpm'")))
    assert plain == other
    with pytest.raises(SceneError, match="duration = '20 mm' is not allowed: duration must be a number in s"):
        read(scene(tmp_path, "relative_displacement = { below = 1, under = 'random', duration = '20 mm' }", PSD))


def test_without_dimensions_limits_are_plain_numbers(tmp_path):
    parameters = {"lam": 3.0, "r": 2.0, "delta_h": 0.08, "mu": 0.001, "zeta": 0.1}
    required = (
        "transmissibility_dB = { below = -6, from_Omega = 3 }\nrelative_displacement = { below = 0.5, under = 'peak' }"
    )
    path = scene(tmp_path, required, parameters=parameters, F="F_0 = 0.05\n", kind="isolator")
    found = verdict(read(path))
    iso = Isolator(**parameters)
    assert found.value.tolist() == [iso.isolation(0.05, -6.0).Omega, iso.peak(0.05).A]
    assert found.unit.tolist() == ["", ""]


def test_what_has_no_answer_is_not_met_and_says_why(tmp_path):
    """Without damping nothing bounds the resonance."""
    parameters = {**LINEAR, "zeta": 0.0}
    found = verdict(
        read(scene(tmp_path, "relative_displacement = { below = 1, under = 'random', rms = true }", PSD, parameters))
    )
    assert found.met.tolist() == [False]
    assert "needs viscous damping, or dry friction" in found.message


@pytest.mark.slow
def test_the_exit_code_says_whether_all_is_met(tmp_path, capsys):
    path = scene(tmp_path, 'jumps = "none"')
    assert cli.main(["run", str(path)]) == 0
    assert capsys.readouterr().out.startswith("# requirements met: 1 of 1")
    path = scene(tmp_path, 'jumps = "none"', parameters=MOUNT)
    assert cli.main(["run", "--json", str(path)]) == 3
    assert json.loads(capsys.readouterr().out)["verdict"]["met"] == [False]
    assert cli.main(["check", str(path)]) == 0
    assert "to meet: jumps" in capsys.readouterr().out
    assert cli.main(["explain", str(path)]) == 0
    assert "then the requirements: jumps" in capsys.readouterr().out
    page = report.html(read(path))
    assert page.index("requirements not met: 1 of 1") < page.index("k_h")


#: the peak of 5 N, F/(2 zeta sqrt(1 - zeta^2) k_v), and with F_SN the greatest one without a jump
PEAK = "relative_displacement = { below = '6 mm', under = 'peak' }"
FREE = "\n[free]\nzeta = [0.01, 0.2]\n"


def test_the_nearest_design_has_nothing_to_spare_of_what_binds(tmp_path, capsys):
    """The damping of a linear mount in closed form; its transmissibility of -20 dB is less than -10 dB."""
    required = f"jumps = 'none'\ntransmissibility_dB = {{ below = -10, from_f = 14 }}\n{PEAK}{FREE}"
    path, out = scene(tmp_path, required), tmp_path / "met.toml"
    assert cli.main(["run", str(path)]) == 3
    assert cli.main(["meet", str(path), "-o", str(out)]) == 0
    printed = capsys.readouterr().out
    assert "feasible                        True" in printed
    assert "requirements met: 3 of 3; the smallest margin: relative_displacement, F = 5 N, margin 1\n" in printed
    zeta = read(out).content["mount"].pop("zeta")
    assert 2 * zeta * math.sqrt(1 - zeta**2) == pytest.approx(5.0 / (0.006 * 4000), rel=3e-6)
    assert {**read(path).content["mount"], "zeta": zeta} == read(out).content["mount"]
    assert cli.main(["run", str(out)]) == 0


def test_a_design_in_another_folder_reads_the_same_columns(tmp_path, monkeypatch):
    """Of a relative path and of an absolute one, from wherever it is called."""
    (tmp_path / "measured").mkdir()
    (tmp_path / "out").mkdir()
    (tmp_path / "measured/floor.csv").write_text("f [Hz], G [g^2/Hz]\n1, 1e-4\n5, 1e-4\n100, 2.5e-7\n")
    (tmp_path / "shock.csv").write_text("t [s], acceleration [m/s^2]\n0, 0\n0.01, 3\n0.02, 0\n")
    files = f"[psd]  # of the floor\nfile = 'measured/floor.csv'\n[shock]\nfile = {str(tmp_path / 'shock.csv')!r}\n"
    required = "relative_displacement = { below = '6 mm', under = ['random', 'shock'], rms = true }"
    path = scene(tmp_path, required + FREE, files, F="")
    monkeypatch.chdir(tmp_path / "out")
    assert cli.main(["meet", "../scene.toml", "-o", "met.toml", "--quiet"]) == 0
    assert "file = '../measured/floor.csv'" in (tmp_path / "out/met.toml").read_text()
    monkeypatch.chdir(tmp_path)
    changed, own = read(tmp_path / "out/met.toml"), read(path)
    assert {**changed.content, "mount": 0} == {**own.content, "mount": 0}


def test_a_cubic_spring_meets_its_requirements_within_tolerances(tmp_path, capsys):
    """Linear: the peak is F/(2 zeta sqrt(1 - zeta^2) k_1), and k_1 is off by at most a tenth."""
    spring = {"m": 10.0, "k_1": 4000.0, "zeta": 0.1}
    path = scene(tmp_path, PEAK + FREE, "questions = ['tolerances']\n[tolerances]\nk_1 = 0.1", spring, kind="spring")
    assert cli.main(["meet", str(path), "-o", str(tmp_path / "met.toml"), "--quiet"]) == 0
    zeta = read(tmp_path / "met.toml").content["spring"]["zeta"]
    assert 2 * zeta * math.sqrt(1 - zeta**2) == pytest.approx(5.0 / (0.006 * 4000), rel=3e-6)
    # half of the products are softer
    assert verdict(read(tmp_path / "met.toml")).products == pytest.approx(0.5, abs=0.01)
    capsys.readouterr()


@pytest.mark.slow
def test_of_several_load_cases_the_one_that_binds_is_a_root(tmp_path):
    """By bisection over single answers: the springs from which on it jumps at the greater force."""
    required = "jumps = 'none'\nrelative_displacement = { below = 0.03, under = ['peak', 'shock'] }\n"
    path = scene(tmp_path, f"{required}[free]\nk_h = [500, '1.7 N/mm']\n", SHOCK, MOUNT, "F = [2.0, 3.0]\n")
    met, changed = meet(read(path))

    def spare(k_h):
        return Isolator.physical(**{**MOUNT, "k_h": k_h}).saddle_node_onset().F_SN - 3

    assert met.feasible and met.numbers["k_h"] == pytest.approx(brentq(spare, 500, 1700), rel=1e-5)
    found = verdict(changed)
    assert found.all_met and len(found) == 6 and list(met.reached.values()) == pytest.approx(found.margin, rel=2e-6)
    assert min(met.reached, key=met.reached.get) == "jumps, F = 3 N"


def test_where_no_design_meets_all_the_nearest_is_proposed(tmp_path, capsys):
    """No zeta up to 0.05 bounds the peak: the largest one misses it least."""
    path = scene(tmp_path, PEAK + FREE.replace("0.2", "0.05"))
    assert cli.main(["meet", "--json", str(path)]) == 3
    found = json.loads(capsys.readouterr().out)
    peak = 5.0 / (0.1 * math.sqrt(1 - 0.05**2) * 4000)
    assert found["design"]["numbers"]["zeta"] == pytest.approx(0.05) and found["verdict"]["met"] == [False]
    assert found["design"]["binding"] == "relative_displacement, F = 5 N >= 1"
    assert found["design"]["reached"]["relative_displacement, F = 5 N"] == pytest.approx(0.006 / peak, rel=3e-6)


def test_a_design_that_meets_all_stays_as_it_is(tmp_path):
    met, changed = meet(read(scene(tmp_path, "jumps = 'none'" + FREE)))
    assert met.feasible and met.numbers == {"zeta": 0.1} and verdict(changed).all_met


def test_meet_needs_requirements_and_ranges(tmp_path, capsys):
    path = scene(tmp_path, FREE.lstrip())
    path.write_text(path.read_text().replace("[require]", "questions = ['at_rest']"))
    assert cli.main(["meet", str(path)]) == 2
    assert "[free] needs [require]" in capsys.readouterr().err
    assert cli.main(["meet", str(scene(tmp_path, "jumps = 'none'"))]) == 2
    assert "meet needs [free]" in capsys.readouterr().err


def test_a_scene_without_a_line_for_each_number_is_not_written(tmp_path, capsys):
    path = scene(tmp_path, PEAK + FREE)
    text = path.read_text()
    path.write_text(
        "".join(f"mount.{name} = {value}\n" for name, value in LINEAR.items()) + text[text.index("[ask]") :]
    )
    assert cli.main(["meet", str(path), "-o", str(tmp_path / "met.toml")]) == 2
    assert "must have one parameter per line" in capsys.readouterr().err
    assert not (tmp_path / "met.toml").exists()


RANGES = "jumps = 'none'\n[free]\n"


@pytest.mark.parametrize(
    ("required", "message"),
    (
        (f"{RANGES}zeta = 0.1", "zeta = 0.1 is not allowed: zeta must be a pair"),
        (f"{RANGES}zeta = [0.2, 0.1]", "zeta.1. = 0.1 is not allowed"),
        (f"{RANGES}k_v = ['1 kN', 2000]", "k_v = '1 kN' is not allowed"),
        (f"{RANGES}stiffness = [1, 2]", "stiffness is not a key of .free."),
        (f"{RANGES}c = [1, 2]", "'c' cannot be varied"),
        (f"{RANGES}load = [1, 2]", "load is not a key of .free."),
        ("jump = 'none'", "jump is not a key of .require."),
        ("jumps = 'few'", "jumps"),
        ("transmissibility_dB = -20", "must be a table with below and from_f"),
        ("transmissibility_dB = { below = 3, from_f = 8 }", "below"),
        ("transmissibility_dB = { below = -3, from_f = '8 mm' }", "from_f = '8 mm' is not allowed"),
        ("relative_displacement = { below = '20 kg', under = 'peak' }", "below = '20 kg' is not allowed"),
        ("relative_displacement = { below = '20', under = 'peak' }", "below = '20' is not allowed"),
        ("relative_displacement = { below = 1, under = 'flood' }", "under"),
        ("relative_displacement = { below = 1, under = 'shock' }", "needs .shock."),
        ("absolute_acceleration = { below = 1, under = 'peak' }", "under"),
        (f"relative_displacement = {{ below = 1, under = 'random' }}\n{PSD}", "rms = true, or for a displacement the"),
        ("relative_displacement = { below = 1, under = [] }", "under must have some of peak, shock, random"),
        ("relative_displacement = { below = 1, under = 'peak', rms = 'yes' }", "rms = 'yes' is not allowed"),
        ("relative_displacement = { below = 1, under = 'peak', rms = true }", "is of 'random' only"),
        ("relative_displacement = { below = 1, under = 'peak', duration = 1 }", "is of 'random' only"),
        (
            f"relative_displacement = {{ below = 1, under = 'random', rms = true, duration = 1 }}\n{PSD}",
            "rms = true or a duration, one of them",
        ),
        ("", "is empty: it must have some of jumps, detachment"),
    ),
)
def test_what_a_requirement_must_be_is_told_with_its_line(tmp_path, required, message):
    with pytest.raises(SceneError, match=f"scene.toml:1[0-9]: .*{message}"):
        read(scene(tmp_path, required))


def test_requirements_at_forcings_need_forcings(tmp_path):
    with pytest.raises(SceneError, match=r"F is missing in .ask."):
        read(scene(tmp_path, "jumps = 'none'", F=""))


def test_a_load_case_is_named_by_its_excitation(tmp_path):
    parameters, letter = {**LINEAR, "excitation": "base"}, "Y = [0.002]\n"
    found = verdict(read(scene(tmp_path, "jumps = 'none'", parameters=parameters, F=letter)))
    assert found.case.tolist() == ["Y = 2 mm"]
