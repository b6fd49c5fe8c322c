"""Mechanisms that a program states: derived, compiled, asked; against quadrature, other integrators, the package."""

from __future__ import annotations

import gc
import hashlib
import json
import math
import os
import pickle
import re
import runpy
import shlex
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from slowflow import SlowflowError, derive, include
from slowflow.app.cli import main
from tests.oracles.by_time import turns_of
from tests.sampling import slow

u, k_1, k_2, gap, alpha, beta = sp.symbols("u k_1 k_2 gap alpha beta")
ABOVE_0 = {"above": 0}
#: an elastic stop behind a gap, on a spring that the user softens: no file of the package has it
STOP = {
    "name": "stop",
    "pieces": [(k_1 * u, gap), (k_1 * u + k_2 * (u - gap), None)],
    "parameters": {"k_1": ABOVE_0, "k_2": {"above": 0, "doc": "stiffness of the stop", "unit": "k_v"}, "gap": ABOVE_0},
}
NUMBERS = {"k_1": 0.8, "k_2": 6.0, "gap": 0.2, "mu": 0.01, "zeta": 0.02}
pytestmark = pytest.mark.usefixtures("folder")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """A folder of a module's own for what is derived in it."""
    import slowflow.derived

    with pytest.MonkeyPatch.context() as patch:
        made = tmp_path_factory.mktemp("derived")
        patch.setattr(slowflow.derived, "FOLDER", made)
        patch.setattr(slowflow.derived, "__path__", [str(made)])
        yield made


@pytest.fixture(scope="module")
def stop(folder):
    return derive.mechanism(**STOP)


def force(x):
    """Typed once more."""
    size = abs(x)
    inside = NUMBERS["k_1"] * size
    return math.copysign(inside + NUMBERS["k_2"] * max(size - NUMBERS["gap"], 0), x)


def average(A):
    """h of (20) by quadrature, the stop's angle being a node."""
    edges = [0, mp.acos(NUMBERS["gap"] / mp.mpf(A)), mp.pi / 2] if A > NUMBERS["gap"] else [0, mp.pi / 2]

    def integrand(t):
        size = mp.mpf(A) * mp.cos(t)
        whole = NUMBERS["k_1"] * size + NUMBERS["k_2"] * max(size - NUMBERS["gap"], 0)
        return whole * mp.cos(t)

    return -4 / mp.pi * mp.quad(integrand, edges)


@pytest.mark.parametrize("A", [0.05, 0.2, 0.201, 0.3, 0.7, 5.0])
def test_its_average_is_that_of_its_force(stop, A):
    with mp.workdps(30):
        expected = average(A)
    design = stop.record.coefficients(*(NUMBERS[name] for name in ("k_1", "k_2", "gap")))
    assert float(stop.record.averaged(A, *design)[0]) == pytest.approx(float(expected), rel=4e-15)


def test_its_force_is_what_was_stated(stop):
    x = np.linspace(-1, 1, 41)
    np.testing.assert_allclose(stop(**NUMBERS).force(x), [force(one) for one in x], rtol=1e-15, atol=1e-16)


@pytest.mark.slow
def test_its_exact_motion_returns_by_another_integrator(stop):
    """From the state that is given an integration of the force as it is typed here comes back after a period."""
    numbers = {**NUMBERS, "mu": 0.0, "zeta": 0.05}
    Omega, F_0 = 1.2, 0.1
    motion = stop(**numbers).steady_state(Omega=Omega, F_0=F_0)
    start = next(zip(*motion.series(3), strict=True))
    end, farthest, _ = turns_of(((force,), ()), (0.0, 0.05), Omega, F_0, start, 1, max_step=0.01)
    np.testing.assert_allclose(end, start[1:], atol=1e-7)
    assert farthest == pytest.approx(motion.A, rel=2e-5)


@pytest.mark.slow
def test_its_derivation_reads_as_a_document(stop):
    text = stop.document()
    sections = [line[3:] for line in text.splitlines() if line.startswith("## ")]
    assert sections == [
        "Equation of motion", "Parameters", "Slow flow", "The average of the force", "Response and folds", "Resultants"
    ]  # fmt: skip
    assert "| $k_{2}$ | k_v | stiffness of the stop | $> 0$ |" in text
    assert text.count("$$") % 2 == 0 and r"\sigma" not in text
    # the two regimes, and in the second what is named before it is used
    attached, stopped = text.split("For $")[2:4]
    assert attached.startswith(r"A \le u_{1}$") and stopped.startswith("u_{1} < A$")
    rows = [row.partition(" &= ") for row in stopped.split(r"\begin{aligned}")[1].split("\n\\end")[0].split(r" \\")]
    names = [name.strip() for name, _, _ in rows]
    assert names[-2:] == ["h", "h_A"]
    for k, (_, _, value) in enumerate(rows):
        assert not [later for later in names[k:-2] if len(later) > 1 and later in value]


@pytest.mark.slow
def test_resultants_are_told_where_the_average_is_a_polynomial(folder):
    """Folds of a Duffing oscillator are roots of theirs, and its onset is one of the other's."""
    hardening = derive.mechanism("hardening", [(u + beta * u**3, None)], {"beta": ABOVE_0})
    section = hardening.document().partition("## Resultants")[2]
    assert "F = F_A = 0" in section and r"\tag{33}" in section and "\\tag{34}" not in section
    one = hardening(beta=0.5, mu=0.01, zeta=0.05)
    F_0, onset = 0.1, one.saddle_node_onset()
    numbers = {"c_{1 1}": 1.0, "c_{1 3}": 0.5, "m": one.model.m, r"\zeta": 0.05, "F_{0}": F_0}
    for letter, roots in (("a", one.saddle_nodes(F_0).A), ("b", [onset.A])):
        terms = re.findall(rf"^{letter}_{{(\d+)}} &= (.*?)(?: \\\\)?$", section, re.MULTILINE)
        values = {}
        for power, text in terms:
            text = re.sub(r"\^{(\d+)}", r"**\1", text)
            for name, number in numbers.items():
                text = text.replace(name, f"({number!r})")
            values[int(power)] = sp.sympify(re.sub(r"(?<=[\d)]) (?=\()", "*", text))
        assert len(values) > 5
        for A in roots:
            sizes = [float(value) * float(A) ** power for power, value in values.items()]
            assert abs(sum(sizes)) < 1e-11 * sum(map(abs, sizes))


@pytest.mark.slow
def test_a_gap_in_powers_of_a_piece_is_printed(folder):
    """A cubic spring that a linear one takes over from, with a jump: k gap^3 was no chain of multiplications."""
    pieces = [(u + beta * u**3, gap), (u + k_2 * (u - gap), None)]
    made = derive.mechanism("taken_over", pieces, dict.fromkeys(("beta", "k_2", "gap"), ABOVE_0))
    one = made(beta=1.5, k_2=2.0, gap=0.3, zeta=0.03)
    assert one.model.jumps == pytest.approx([1.5 * 0.3**3], rel=1e-15)
    assert one.saddle_nodes(0.1).kind.size


PROGRAM = """
import sympy as sp
from slowflow import derive

u, k_1, k_2, gap = sp.symbols("u k_1 k_2 gap")
above_0 = {"above": 0}
stop = derive.mechanism(
    "stop", [(k_1 * u, gap), (k_1 * u + k_2 * (u - gap), None)], {"k_1": above_0, "k_2": above_0, "gap": above_0}
)
"""


@pytest.mark.slow
def test_the_command_line_writes_what_a_program_derives(tmp_path, capsys):
    """A module that answers by itself, C that compiles against the package's headers, a document, hashes of all."""
    (tmp_path / "mine.py").write_text(PROGRAM)
    assert main(["derive", str(tmp_path / "mine.py"), "-o", str(tmp_path / "out")]) == 0
    folder = tmp_path / "out" / "stop"
    names = {path.name for path in folder.iterdir()}
    printed = capsys.readouterr().out
    assert all(name in printed for name in names)
    manifest = json.loads((folder / "MANIFEST.json").read_text())
    assert names == {*manifest["files"], "MANIFEST.json"}
    for name, kept in manifest["files"].items():
        assert hashlib.sha256((folder / name).read_bytes()).hexdigest() == kept
    markdown, tex = ((folder / f"derivation.{suffix}").read_text() for suffix in ("md", "tex"))
    assert re.findall("^## (.*)", markdown, re.MULTILINE) == re.findall(r"^\\section{(.*)}", tex, re.MULTILINE)
    assert markdown.count(r"\begin{aligned}") == tex.count(r"\begin{align}") > 8
    if shutil.which("pdflatex"):
        done = subprocess.run(["pdflatex", "-halt-on-error", "derivation.tex"], cwd=folder, capture_output=True)
        assert done.returncode == 0, done.stdout
    (module,) = folder.glob("stop_*.py")
    kernels = runpy.run_path(str(module))
    k_1, k_2, gap = (NUMBERS[name] for name in ("k_1", "k_2", "gap"))
    h = kernels["MECHANISM"].averaged(0.5, *kernels["MECHANISM"].coefficients(k_1, k_2, gap))[0]
    assert math.isclose(h, average(0.5), rel_tol=1e-14)
    compiler = shlex.split(sysconfig.get_config_var("CC") or "cc")
    if shutil.which(compiler[0]):
        headers = [f"-I{place}" for place in (folder, *include())]
        sources = sorted(folder.glob("*.c"))
        assert [path.stem for path in sources] == ["exported", module.stem, f"{module.stem}_motion"]
        done = subprocess.run(
            [*compiler, "-std=c11", "-fsyntax-only", *headers, *map(str, sources)], capture_output=True
        )
        assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    ("program", "message"),
    [
        ("x = 1", "defines no mechanism"),
        (PROGRAM.replace("(k_1 * u, gap)", "(k_1 * u * j, gap)"), "mine.py, line 8: NameError: name 'j'"),
        (PROGRAM.replace('"stop",', '"no name",'), "line 7: Refused: name = 'no name' is not allowed"),
        (None, "no such file"),
    ],
)
def test_a_program_that_derives_nothing_is_told_why(tmp_path, capsys, program, message):
    if program is not None:
        (tmp_path / "mine.py").write_text(program)
    assert main(["derive", str(tmp_path / "mine.py"), "-o", str(tmp_path / "out")]) == 2
    assert message in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


#: doubles that 15 digits do not name
HARD = (0.1414213562373095, 0.30000000000000004, 2 / 3)


def test_double_in_a_force_is_its_exact_value(folder):
    """Expected from the fraction that the bits are; each is off in its last digits where it goes by text."""
    from slowflow.derivation import given

    for number in HARD:
        long = sp.Float(sp.Rational(*number.as_integer_ratio()) / 3, 60)
        for value in (number, np.float64(number), sp.Float(number), np.float32(number), long):
            bits = sp.Rational(value) if isinstance(value, sp.Float) else sp.Rational(*float(value).as_integer_ratio())
            assert given.exact("a number", value) == given.expression("a number", value) == bits
            assert given.expression("a number", sp.tanh(value * u)) == sp.tanh(bits * u)
            assert given.reach(value) == given.parameters({"k": {"below": value}})["k"]["below"] == bits
        assert given.in_text(given.exact("a number", number) * u) == f"{number!r}*u"


@pytest.mark.parametrize("end", [HARD[0], *slow(*HARD[1:])])
def test_a_piece_ends_at_the_double_that_was_given(folder, end):
    for value in (end, sp.Float(end)):
        record = derive.mechanism("ends", [(k_1 * u, value), (u * sp.Rational(3, 2), None)], {"k_1": {}}).record
        assert [float(b) for b in record.breakpoints(*record.coefficients(1.2))] == [end]
    one, other = [(lambda u: u, sp.Float(end)), (lambda u: 2 * u, None)], sp.Float(2 * end)
    sampled = derive.mechanism("values", one, {}, reach=other).record
    assert [float(b) for b in sampled.breakpoints()] == [end] and sampled.reach == 2 * end


@pytest.mark.slow
def test_a_coefficient_is_the_double_that_was_given(folder):
    for number in HARD:
        cubic = derive.mechanism("cubic", [(u + sp.Float(number) * u**3, None)], {})
        assert float(cubic.record.coefficients()[1]) == number
        assert f"{number!r}" in cubic.document()


@pytest.mark.slow
@pytest.mark.parametrize("digits", [HARD[0], "0.14142135623730950488016887"], ids=["double", "longer"])
def test_a_corner_is_proved_where_the_spring_ends(folder, digits):
    """An interval that is proved to hold the corner holds the number that the piece ends at."""
    end = sp.Float(digits) if isinstance(digits, float) else sp.Float(digits, 26)
    kinked = derive.mechanism("kinked", [(k_1 * u, end), (u * sp.Rational(3, 2), None)], {"k_1": {}}, compile=True)
    proof = kinked(k_1=0.6, mu=0.0, zeta=0.02).certify(0.05)
    exact = Fraction(*(int(part) for part in sp.Rational(end).as_numer_denom()))
    for low, high in (proof.detachment.A, proof.saddle_nodes.A[0]):
        assert Fraction(float(low)) <= exact <= Fraction(float(high))


def test_what_depends_on_time_is_refused_with_the_reason(folder):
    with pytest.raises(ValueError, match=r"piece 1 has t: a restoring force may not depend on time"):
        derive.mechanism("timed", [(u + sp.Symbol("t") * u, None)], {})


@pytest.mark.parametrize(
    ("force", "note"),
    [
        (u + beta * u**2, "beta*u**2 + u is not odd: for u < 0 the force is that of |u| with the other sign"),
        (beta + u, "beta + u is not odd: for u < 0 the force is that of |u| with the other sign, a preload of beta"),
        (u + beta * u**3, ""),
        (u + beta * u * sp.Abs(u), ""),
    ],
    ids=str,
)
def test_force_not_written_odd_says_what_stands_for_it(folder, force, note):
    made = derive.mechanism("even", [(force, None)], {"beta": ABOVE_0})
    how = "interpreted"
    assert repr(made).endswith(f"{how}; {note}" if note else how)
    assert made(beta=0.5, zeta=0.02).force([-0.3]) == -made(beta=0.5, zeta=0.02).force([0.3])


def test_a_load_on_a_preload_is_refused_for_the_jump_that_it_is(folder):
    preloaded = derive.mechanism("held", [(beta + u, None)], {"beta": ABOVE_0})
    with pytest.raises(ValueError, match=r"held_.*not derived for a force that jumps at u = 0, as a preload does"):
        preloaded(beta=0.1, zeta=0.02, load=0.3)


def test_end_below_0_and_acceleration_are_refused(stop):
    below = derive.mechanism(**{**STOP, "parameters": {"k_1": ABOVE_0, "k_2": ABOVE_0, "gap": {}}})
    with pytest.raises(ValueError, match=r"end at \|u\| = -0\.2, which must be ascending from 0"):
        below(**{**NUMBERS, "gap": -0.2})
    with pytest.raises(ValueError, match=r"'acceleration' is not allowed.*'base'.*is a force, F_0 = m a/\(k_v L\)"):
        stop(**NUMBERS, excitation="acceleration")


def test_what_is_derived_once_is_not_derived_again(stop, monkeypatch):
    import slowflow.derivation.runtime

    monkeypatch.setattr(slowflow.derivation.runtime, "sources", lambda _: pytest.fail("derived again"))
    again = derive.mechanism(**STOP)
    assert again.record is stop.record
    with pytest.raises(pytest.fail.Exception):
        derive.mechanism(**{**STOP, "pieces": [(k_1 * u, 2 * gap), (k_1 * u + k_2 * (u - 2 * gap), None)]})


@pytest.mark.slow
def test_c_is_printed_where_it_is_compiled(folder):
    """An interpreted mechanism needs none; compiled later it is derived again and is the same mechanism."""
    arguments = {**STOP, "name": "stop_twice"}
    interpreted = derive.mechanism(**arguments)
    assert {path.suffix for path in folder.iterdir() if path.name.startswith("stop_twice")} == {".json", ".py"}
    before = interpreted(**NUMBERS).saddle_nodes(0.05)
    assert not interpreted.compiled
    in_c = derive.mechanism(**arguments, compile=True)
    assert in_c.compiled and in_c.record is interpreted.record
    after = in_c(**NUMBERS).saddle_nodes(0.05)
    np.testing.assert_array_equal(after.Omega, before.Omega)
    assert len(after.Omega) == 2


@pytest.mark.parametrize("collects", [True, False])
def test_the_collector_is_left_as_it_was(folder, collects):
    """By what is derived, and by what is refused on the way."""
    was = gc.isenabled()
    try:
        (gc.enable if collects else gc.disable)()
        derive.mechanism(f"collected_{collects}", [(u + k_1 * u**3, None)], {"k_1": ABOVE_0})
        assert gc.isenabled() is collects
        with pytest.raises(ArithmeticError), derive._uncollected():
            raise ArithmeticError
        assert gc.isenabled() is collects
    finally:
        (gc.enable if was else gc.disable)()


@pytest.mark.slow
def test_an_oscillator_is_pickled_into_another_process(stop, folder):
    code = "import pickle, sys; one = pickle.load(sys.stdin.buffer); print(repr(one.saddle_node_onset().F_SN))"
    one = stop(**NUMBERS)
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", code],
        input=pickle.dumps(one),
        capture_output=True,
        env={**os.environ, "SLOWFLOW_DERIVED": str(folder), "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    assert done.returncode == 0, done.stderr.decode()
    assert float(done.stdout.decode().replace("np.float64(", "").rstrip(")\n")) == one.saddle_node_onset().F_SN


# ---- what is refused


@pytest.mark.skipif(os.name != "posix", reason="owners and modes are looked at on POSIX only")
@pytest.mark.parametrize("how", ["open", "of another user", *slow("group", "above", "planted while it was open")])
def test_a_module_that_others_could_have_planted_does_not_run(tmp_path, how):
    """In a separate process; the same module in a folder of the user's own is imported."""
    import slowflow.derived

    folder = tmp_path / "above" / "derived"
    folder.mkdir(parents=True)
    for path in (folder.parent, folder):
        path.chmod(0o755)
    planted = folder / "planted_0123456789ab.py"
    planted.write_text("print('EXECUTED')")
    planted.chmod(0o644)
    program = [sys.executable, "-c", "import slowflow.derived.planted_0123456789ab"]
    env = {**os.environ, "SLOWFLOW_DERIVED": str(folder), "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run(program, env=env, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, "EXECUTED\n"), done.stderr
    messages = {
        "open": f"chmod 700 '{folder}'",
        "group": f"chmod 700 '{folder}'",
        "above": f"chmod go-w '{folder.parent}'",
    }
    if how == "of another user":
        if os.getuid() != 0:
            pytest.skip("only the superuser can give a file away")
        os.chown(planted, 12345, -1)
    elif how == "group":
        grp, pwd = pytest.importorskip("grp"), pytest.importorskip("pwd")
        if grp.getgrgid(folder.stat().st_gid).gr_name == pwd.getpwuid(os.getuid()).pw_name:
            if os.getuid() != 0:
                pytest.skip("the user's group is his own")
            os.chown(folder, -1, 12345)
        folder.chmod(0o775)
    else:
        {"open": folder, "above": folder.parent}.get(how, planted).chmod(0o777)
    done = subprocess.run(program, env=env, capture_output=True, text=True)
    assert done.returncode != 0 and "EXECUTED" not in done.stdout
    assert messages.get(how, str(planted)) in done.stderr and "SLOWFLOW_DERIVED" in done.stderr
    # nor where the folder was good when it was first looked at
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(slowflow.derived, "FOLDER", folder)
        with pytest.raises(SlowflowError, match="SLOWFLOW_DERIVED"):
            derive.mechanism(**STOP)


@pytest.mark.skipif(os.name != "posix", reason="owners and modes are looked at on POSIX only")
def test_a_folder_that_is_made_is_for_the_user_alone(tmp_path):
    import slowflow.derived

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(slowflow.derived, "FOLDER", tmp_path / "made")
        assert derive._folder().stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize(
    ("changes", "error", "message"),
    [
        ({"pieces": [("k_1*u", None)]}, TypeError, "strings are never read"),
        ({"pieces": [(k_1 * u, "0.2"), (u, None)]}, TypeError, "the end of piece 1"),
        ({"pieces": [(sp.Symbol("k_9") * u, None)]}, ValueError, "piece 1 has k_9, which is no parameter"),
        ({"pieces": [(k_1 * u, None), (u, None)]}, ValueError, "piece 1 must say where it ends"),
        ({"pieces": [(k_1 * u, gap)]}, ValueError, "piece 1 must have no end"),
        ({"pieces": []}, ValueError, "at least one"),
        ({"pieces": [(sp.Max(u, k_1), None)]}, ArithmeticError, "piece 1 contains Max, .* needs a piece of its own"),
        ({"pieces": [(k_1 / u, None)]}, ArithmeticError, "piece 1 is infinite at .u. = 0"),
        ({"pieces": [(sp.log(u - 1), None)], "reach": 2}, ArithmeticError, "piece 1 is not real at .u. = 0"),
        ({"pieces": [(u, 1), (u + sp.sqrt(-u), None)]}, ArithmeticError, "piece 2 is not real at .u. = 1"),
        ({"pieces": [(u + sp.sqrt(1 - u) - 1, None)], "reach": 2}, ArithmeticError, "piece 1 is not real at .u. = 2"),
        ({"pieces": [(u, gap), (u, gap - k_1), (u, None)]}, ArithmeticError, "piece 2 ends at .* not above gap"),
        ({"pieces": [(u, sp.sqrt(-gap)), (u, None)]}, ArithmeticError, "which is not above 0"),
        *(
            ({"pieces": [(u, gap), (u + force, None)]}, ArithmeticError, reasons)
            for force, reasons in (
                (sp.sqrt(u - gap), "whose power is not above 1/2: h has no slope there"),
                (sp.tanh((u - gap) ** 1.5), "no power of u - gap times what is smooth"),
                ((u - gap) ** k_1, "no power of u - gap times what is smooth"),
            )
        ),
        (
            {"pieces": [(u, gap), (u + (u - gap) ** 1.5 * sp.exp(-u), gap + 1), (u, None)]},
            ArithmeticError,
            "piece 2 has a power 3/2 .* only the last piece may",
        ),
        ({"pieces": [(u + (gap - u) ** 1.5, gap), (u, None)]}, ArithmeticError, "singular at .u. = gap, where it ends"),
        ({"name": "a stop"}, ValueError, "name = 'a stop' is not allowed"),
        ({"name": "__import__('os')"}, ValueError, "is not allowed"),
        ({"name": 5}, TypeError, "name = 5 is not allowed: it must be a string"),
        ({"pieces": 5}, TypeError, "pieces = 5 is not allowed: it must be a list of pairs"),
        ({"pieces": u + k_1 * u**3}, TypeError, "pieces = .* must be a list of pairs"),
        ({"pieces": [(u,)]}, TypeError, "piece 1 = .* must be a list of pairs"),
        ({"pieces": [(sp.I * u, None)]}, ValueError, "piece 1 = .* must be real and finite"),
        (
            {"pieces": [(u + 10**400 * u**3, None)]},
            ValueError,
            "piece 1 is not allowed: .* beyond the range of doubles",
        ),
        ({"pieces": [(u + u**3 / sp.Integer(10) ** 400, None)]}, ValueError, "piece 1 .* beyond the range of doubles"),
        ({"pieces": [(float("inf"), None)]}, ValueError, "piece 1 = inf is not allowed: it must be finite"),
        ({"parameters": ["k_1"]}, TypeError, "parameters = .* must be a mapping"),
        ({"parameters": {"k_1": None}}, TypeError, "parameter k_1 = None is not allowed"),
        ({"parameters": {"k_1": {"above": "0"}}}, TypeError, "parameter k_1: above = '0' .* must be a number"),
        ({"parameters": {"k_1": {"least": 1, "below": 1}}}, ValueError, "least = 1 and below = 1 leave no number"),
        ({"reach": -1.0}, ValueError, "reach = -1.0 is not allowed: it must be > 0"),
        ({"reach": "far"}, TypeError, "reach = 'far' is not allowed: it must be a number"),
        ({"title": 5}, TypeError, "title = 5 is not allowed"),
        ({"compile": "yes"}, TypeError, "compile = 'yes' is not allowed: it must be True or False"),
        ({"parameters": {"mu": {}}}, ValueError, "parameter 'mu' is not allowed"),
        ({"parameters": {"out": {}}}, ValueError, "parameter 'out' is not allowed"),
        ({"parameters": {"short": {}}}, ValueError, "it is a word of C"),
        *(
            (
                {"pieces": [(sp.Symbol(name) * u, None)], "parameters": {name: {}}},
                ValueError,
                "an attribute of that name",
            )
            for name in ("mu_s", "model", "peak")
        ),
        ({"parameters": {"k_1": {"over": 0}}}, ValueError, "'over' is not allowed"),
    ],
)
def test_what_cannot_be_had_is_refused_with_the_reason(folder, changes, error, message):
    before = sorted(folder.iterdir())
    with pytest.raises(error, match=message):
        derive.mechanism(**{**STOP, **changes})
    assert sorted(folder.iterdir()) == before


def test_numbers_outside_their_domain_are_refused(stop):
    with pytest.raises(ValueError, match=r"gap = 0.* must be"):
        stop(**{**NUMBERS, "gap": 0.0})
    with pytest.raises(TypeError, match="k_2"):
        stop(k_1=1.0, gap=0.1)


def test_a_compiler_that_fails_says_so(folder, monkeypatch):
    for compiler, message in (("false", "failed"), ("no-such-compiler", "does not run")):
        monkeypatch.setenv("CC", compiler)
        with pytest.raises(RuntimeError, match=message):
            derive.mechanism(**{**STOP, "name": "not_compiled"}, compile=True)
    assert not list(folder.glob("not_compiled*.so"))


def test_library_is_recompiled_where_headers_have_changed(tmp_path, monkeypatch):
    """An older library would hand the solvers a record of another form."""
    compiler = tmp_path / "cc"
    compiler.write_text('#!/bin/sh\nwhile [ "$1" != -o ]; do shift; done\ntouch "$2"\n')
    compiler.chmod(0o755)
    header = tmp_path / "record.h"
    monkeypatch.setenv("CC", str(compiler))
    monkeypatch.setattr(derive, "include", lambda: [tmp_path])
    libraries = []
    for form in (1, 1, 2):
        header.write_text(f"#define FORM {form}\n")
        libraries.append(derive._compiled(tmp_path, "stop"))
    assert libraries[0] == libraries[1] != libraries[2]


def test_without_the_extra_its_name_is_said(monkeypatch):
    monkeypatch.setitem(sys.modules, "slowflow.derivation.runtime", None)
    with pytest.raises(ImportError, match=r"slowflow\[derive\]"):
        derive.mechanism(**STOP)


def test_headers_are_where_it_is_said():
    solvers, kernels, records = include()
    assert (solvers / "mechanism.h").exists()
    assert (kernels / "slow_flow.h").exists()
    assert (records / "records.h").exists()
