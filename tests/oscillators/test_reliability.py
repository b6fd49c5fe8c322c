"""Nothing breaks it: threads, forks, interrupts, memory, the interpreter's switches, hard places."""

from __future__ import annotations

import multiprocessing
import os
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import mpmath
import pytest

from slowflow import Duffing, Isolator
from slowflow.averaged import chunks
from slowflow.example import isolator
from slowflow.support.errors import NotSettled
from slowflow_kernels.conventions import Status
from tests.interrupts import ENDING, interrupted
from tests.sampling import slow

EVERYTHING = """
from slowflow import Duffing, Isolator
iso = Isolator(lam=3.0, r=2.0, delta_h=0.15, mu=0.012, zeta=0.02)
print(iso, iso.explain("peak", 0.04))
print(iso.saddle_nodes(0.04), iso.saddle_node_onset(), iso.detachment(), iso.peak(0.04))
print(len(iso.frequency_response(0.04)), len(iso.fold_locus(A_max=1.0)))
print(iso.cusps(A_max=1.0), iso.isola_points(A_max=1.0))
print(iso.amplitudes(Omega=0.9, F_0=0.04), iso.second_approximation.saddle_nodes(0.04))
print(Duffing.many(1.0, [0.1, 0.2], 0.01, 0.02).saddle_nodes(0.1))
print(iso.steady_state(Omega=0.9, F_0=0.04).A)
"""


def answers(oscillator):
    """What an oscillator says to several questions, the cached ones among them, as text with all digits."""
    # lists: how NumPy prints arrays is one setting for all threads in NumPy 2.0
    return repr(
        (
            oscillator.saddle_node_onset(),
            oscillator.saddle_nodes(0.04).to_dict(),
            oscillator.detachment(),
            oscillator.peak(0.04),
            oscillator.frequency_response(0.04, samples=60).A.tolist(),
            oscillator.second_approximation.saddle_nodes(0.04).Omega.tolist(),
            oscillator.steady_state(Omega=0.9, F_0=0.04).series(8)[1].tolist(),
            oscillator.sweep(Omega=[0.6, 0.7], F_0=0.04).A.tolist(),
        )
    )


def test_sixteen_threads_share_one_oscillator():
    expected = answers(isolator())
    for _ in range(4):
        shared = isolator()  # nothing of it is known yet
        with ThreadPoolExecutor(16) as pool:
            assert set(pool.map(answers, [shared] * 64)) == {expected}


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork on this system")
def test_a_fork_answers_as_its_parent_does():
    """In a process of its own: a fork of the test runner would answer in its place."""
    program = """
import multiprocessing
from slowflow.example import isolator
def answers(oscillator):
    return repr((oscillator.saddle_node_onset(), oscillator.saddle_nodes(0.04), oscillator.peak(0.04)))
oscillator = isolator()
expected = answers(oscillator)
with multiprocessing.get_context("fork").Pool(2) as pool:
    assert pool.map(answers, [oscillator, isolator(), oscillator]) == [expected] * 3
"""
    subprocess.run([sys.executable, "-c", program], check=True, timeout=120)


def test_designs_that_take_50_ms_each_are_asked_few_at_a_time(monkeypatch):
    """By a clock of its own: every design once, in order, and less than a second between two times to hear Ctrl-C."""
    clock = [0.0]
    monkeypatch.setattr(chunks.time, "perf_counter", lambda: clock[0])
    done = 0
    for (part,) in chunks.blocks((1000,), 2**14):
        here = range(1000)[part]
        assert here.start == done and 0.05 * len(here) < 1
        done = here.stop
        clock[0] += 0.05 * len(here)
    assert done == 1000


#: of batches: each takes minutes
OF_DESIGNS = (
    *("saddle_nodes(0.05)", "saddle_nodes(0.05, workers=2)", "saddle_node_onset()", "saddle_node_onset(workers=2)"),
    *("peak(0.05)", "amplitudes(Omega=0.9, F_0=0.05)", "frequency_response(0.05, samples=2)", "certify(0.05)"),
    *("margins(0.05)", "hysteresis(0.05)", "isolation(0.05)", "second_approximation.saddle_nodes(0.05)"),
    *("second_approximation.peak(0.05)", "shock_spectrum(acceleration=0.1, duration=2.0)"),
)
#: minutes, each; a design of the second approximation takes half a millisecond, where an onset takes some microseconds
LONG = {
    **{f"a batch: {question}": f"designs.{question}" for question in OF_DESIGNS},
    "an answer": "isolator().amplitudes(Omega=np.linspace(0.1, 2.0, 3 * 10**7), F_0=0.04)",
    "slow designs": "Isolator.many(**batch | {'zeta': np.full(10**6, 0.02)}).second_approximation.saddle_nodes(0.04)",
    "a slow sweep": "Duffing(1.0, 0.1, 0.01, 0.01).sweep(Omega=np.linspace(0.01, 0.02, 10**6), F_0=0.1)",
    "an exact curve": "isolator().exact_response(0.04, step=1e-6)",
    "a sweep": "isolator().sweep(Omega=np.linspace(0.5, 1.5, 10**6), F_0=0.04)",
    "a record": "isolator().transient(acceleration=np.sin(np.arange(2e6)), tau=np.arange(2e6))",
    "a shock spectrum": "isolator().shock_spectrum(acceleration=np.full(10**6, 0.1), duration=2.0)",
    "a load spectrum": "isolator().spectrum(Omega=np.linspace(0.5, 1.5, 10**6), F_0=np.linspace(0.02, 0.04, 10**6))",
    "states off the centre": "isolator(load=0.01).amplitudes(Omega=np.linspace(0.5, 1.5, 10**6), F_0=0.04)",
    "folds of a batch off the centre": "Isolator.many(**batch, load=0.01).saddle_nodes(0.04)",
    "shocks of a batch off the centre": "Isolator.many(**batch, load=0.01).shock_spectrum(acceleration=1, duration=1)",
}


@pytest.mark.slow
@pytest.mark.parametrize("what", LONG)
@pytest.mark.part(4)
def test_ctrl_c_ends_what_takes_minutes(what):
    count = 10**6 if "frequency_response" in what or "shock" in what else 10**7
    # SciPy, which some ask for first, is not what is interrupted: its modules say so in words of their own
    program = (
        "import numpy as np, scipy.optimize; from slowflow import Duffing, Isolator\n"
        "from slowflow.example import isolator\n"
        "batch = dict(lam=3, r=2, delta_h=0.08, mu=0.01, zeta=np.linspace(0.02, 0.1, 10**5))\n"
        f"r = np.linspace(0.5, 2.0, {count if LONG[what].startswith('designs') else 1})\n"
        "designs = Isolator.many(lam=3, r=r, delta_h=0.2 / r, mu=0.01, zeta=0.02)\n"
        f"print('asked', flush=True); {LONG[what]}; print('answered', flush=True)"
    )
    assert interrupted(program) == ENDING


#: of the program that looks for memory that is kept
CALLS_A_ROUND = 8


@pytest.mark.slow
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the resident size is read from /proc")
def test_no_memory_is_kept():
    """Oscillators, answers and refusals by the ten thousand: the process stays as large as it was after the first."""
    program = """
import numpy as np
from slowflow import Duffing, Isolator
from slowflow.example import TABLE_1
from slowflow.support.errors import Refused
def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1])
def ask(k):
    oscillator = Isolator(**TABLE_1 | {"zeta": 0.01 + 1e-7 * k})
    oscillator.saddle_node_onset(), oscillator.saddle_nodes(0.04), oscillator.peak(0.04), oscillator.detachment()
    oscillator.frequency_response(0.04, samples=20), oscillator.amplitudes(Omega=0.9, F_0=0.04)
    Duffing.many([1.0, 2.0], 0.1, 0.01, 0.02).saddle_nodes(0.1)
    if k % 100 == 0:
        oscillator.steady_state(Omega=0.9, F_0=0.04)
    try:
        Isolator(**TABLE_1 | {"delta_h": 2.0})
    except Refused:
        pass
for k in range(3000):
    ask(k)
before = resident()
for k in range(ROUNDS):
    ask(k)
print((resident() - before) * 4096)
"""
    rounds = int(os.environ.get("SLOWFLOW_CALLS", 10**5)) // CALLS_A_ROUND
    done = subprocess.run(
        [sys.executable, "-c", program.replace("ROUNDS", str(rounds))], capture_output=True, text=True, check=True
    )
    assert int(done.stdout) < 2**20


@pytest.mark.slow
@pytest.mark.parametrize(
    ("switches", "variables"),
    [
        (["-O"], {}),
        (["-OO"], {}),
        (["-W", "error"], {}),
        (["-X", "dev", "-W", "error"], {}),
        ([], {"LC_ALL": "de_DE.UTF-8"}),
        ([], {"PYTHONHASHSEED": "7"}),
        ([], {"LC_ALL": "C", "PYTHONUTF8": "0"}),
    ],
)
def test_the_interpreters_switches_change_no_answer(switches, variables):
    if variables.get("LC_ALL", "").startswith("de"):
        known = subprocess.run(["locale", "-a"], capture_output=True, text=True).stdout
        if "de_DE.utf8" not in known:
            pytest.skip("no locale with a decimal comma on this system")
    plain, switched = (
        subprocess.run(
            [sys.executable, *options, "-c", EVERYTHING],
            capture_output=True,
            encoding="utf-8",
            check=True,
            env={**os.environ, "PYTHONIOENCODING": "utf-8", **more},
        )
        for options, more in (([], {}), (switches, variables))
    )
    assert switched.stdout == plain.stdout and switched.stderr == ""


def test_no_locale_is_asked_for():
    """On a machine without a decimal comma, too: numbers are neither read nor written by what a locale changes."""
    asks = r"\b(?:\w*printf|\w*scanf|strto\w+|ato[fil]|setlocale|localeconv|PyOS_string_to_double)\s*\("
    folders = [Path(sys.modules["slowflow"].__file__).parent, Path(sys.modules["slowflow_kernels"].__file__).parent]
    sources = [file for folder in folders for file in folder.rglob("*") if file.suffix in (".c", ".h", ".py")]
    assert len(sources) > 100
    for file in sources:
        text = file.read_text(encoding="utf-8")
        assert not re.search(asks, text) and "import locale" not in text and not re.search(r":[.\d]*n\}", text), file


OF_OTHER_QUESTIONS = ("certificate", "gradient", "sensitivities", "validity", "physical_answers")
DERIVED = """
import sympy as sp
from slowflow import derive
u, k, gap, further = sp.symbols("u k gap further")
above = {"above": 0}
pieces = [(u, gap), (u + k * (u - gap), gap + further), (u + 2 * k * (u - gap - further / 2), None)]
stops = derive.mechanism("stops", pieces, {"k": above, "gap": above, "further": above})
assert stops(k=3.0, gap=0.2, further=0.1, mu=0.01, zeta=0.03).saddle_nodes(0.1).Omega.size == 2
"""
#: programs, and modules that they do not need: what other questions return, what would take longer than deriving, such
#: as SymPy's units, which `simplify` brings in
NOT_IMPORTED = {
    "a first answer": (
        "from slowflow.example import isolator; isolator().saddle_nodes(0.04)",
        *("sympy", "matplotlib", "scipy", "jinja2", "heyoka", "slowflow.exact"),
        *(f"slowflow.answers.{name}" for name in OF_OTHER_QUESTIONS),
    ),
    "a batch": (
        "import slowflow, slowflow.grid.designs; slowflow.Isolator.many(lam=3, r=[1, 2], delta_h=0.1).detachment()",
        *("xarray", "dask", "distributed", "zarr", "pandas"),
    ),
    "a derived force": (DERIVED, "scipy", "sympy.physics", "slowflow.derivation.document"),
}


@pytest.mark.parametrize("what", ["a first answer", *slow("a batch", "a derived force")])
def test_an_answer_imports_no_heavy_package(what, tmp_path):
    program, *heavy = NOT_IMPORTED[what]
    program += f"\nimport sys\nprint([name for name in {heavy} if name in sys.modules])"
    env = {**os.environ, "SLOWFLOW_DERIVED": str(tmp_path), "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, env=env)
    assert (done.returncode, done.stdout) == (0, "[]\n"), done.stderr


def test_nothing_is_written_into_the_package(tmp_path):
    """It may lie where nobody can write."""
    folders = [Path(path) for package in ("slowflow", "slowflow_kernels") for path in sys.modules[package].__path__]

    def files():
        return {
            (path, path.stat().st_mtime_ns)
            for folder in folders
            for path in folder.rglob("*")
            if "__pycache__" not in path.parts and not path.is_dir()
        }

    before = files()
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "HOME": str(tmp_path / "none")}
    environment["PYTHONPATH"] = os.pathsep.join(str(Path(path).resolve()) for path in sys.path)
    subprocess.run([sys.executable, "-c", EVERYTHING], check=True, capture_output=True, cwd=tmp_path, env=environment)
    assert files() == before and list(tmp_path.iterdir()) == []


# --- the equation of motion at its hard places -----------------------------------------------------------------------

HARD = {
    "near escape": (dict(alpha=1.0, beta=-1.0, mu=0.01, zeta=0.02), (0.1, 0.3, 0.6)),
    "many stops": (dict(alpha=1.0, beta=0.1, mu=0.05, zeta=0.01), (0.0625, 0.065, 0.1)),
    "quasi-zero stiffness": (dict(alpha=0.0, beta=1.0, mu=0.001, zeta=0.01), (0.0015, 0.01, 0.5)),
    "mu/F_0 to 1": (dict(alpha=1.0, beta=0.5, mu=0.1, zeta=0.05), (0.1000001, 0.101, 0.11)),
    "negative stiffness": (dict(alpha=-0.2, beta=1.0, mu=0.001, zeta=0.01), (0.01, 0.1, 0.5)),
}


def solved(oscillator, Omega, F_0):
    """Of a motion nothing, which is within its residual; else the words of the refusal; neither takes a minute."""
    start = time.process_time()
    try:
        found = oscillator.steady_state(Omega=Omega, F_0=F_0)
    except NotSettled as refusal:
        assert str(refusal)
        return str(refusal)
    finally:
        assert time.process_time() - start < 60
    assert found.residual <= 1e-9 * max(found.A, F_0)
    return ""


@pytest.mark.slow
@pytest.mark.parametrize("place", HARD)
def test_a_motion_within_its_residual_or_a_refusal(place):
    """At hard places, slow frequencies among them, an answer solves the equation of motion; none takes a minute."""
    numbers, forcings = HARD[place]
    oscillator = Duffing(**numbers)
    for F_0 in forcings:
        for Omega in (0.05, 0.2, 0.5, 0.9, 1.0, 1.3, 2.7):
            solved(oscillator, Omega, F_0)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("force", "delta_h"),
    [
        *(("truncated", delta_h) for delta_h in (1e-310, 1e-305, 1e-300, 1e-200, 1e-100)),
        *(("untruncated", delta_h) for delta_h in (1e-310, 1e-200, 1e-100)),
    ],
)
def test_a_preload_next_to_none_moves_nothing(force, delta_h):
    """Springs that detach at u_cr of 1e-50 and less: the mass on k_v alone, linear (24), (34)."""
    mu, zeta, F_0, Omega = 0.01, 0.1, 0.1, 0.9
    iso = Isolator(lam=3, r=2, delta_h=delta_h, mu=mu, zeta=zeta, force=force)
    with mpmath.workdps(60):
        m = 4 * mpmath.mpf(mu) / mpmath.pi

        def amplitude(Omega):
            R, I = Omega**2 - 1, 2 * mpmath.mpf(zeta) * Omega
            return (mpmath.sqrt((I * m) ** 2 + (R**2 + I**2) * (mpmath.mpf(F_0) ** 2 - m**2)) - I * m) / (R**2 + I**2)

        top = mpmath.findroot(lambda w: mpmath.diff(amplitude, w), (0.9, 1.1), solver="anderson", tol=1e-20)
        expected, state = float(amplitude(top)), float(amplitude(mpmath.mpf(Omega)))
    peak = iso.peak(F_0)
    assert peak.A == pytest.approx(expected, rel=1e-14) and peak.Omega == pytest.approx(float(top), rel=1e-14)
    assert iso.amplitudes(Omega=Omega, F_0=F_0).A.tolist() == pytest.approx([state], rel=1e-14)
    assert iso.frequency_response(F_0).A.max() == pytest.approx(expected, rel=1e-14)
    if force == "untruncated":  # the truncated force jumps at u_cr, where folds lie then
        assert len(iso.saddle_nodes(F_0)) == 0


@pytest.mark.parametrize("r", [1e180, 1e250])
def test_a_detachment_beyond_the_range_of_doubles_is_refused(r):
    """It was said to be tended to as Omega tends to inf, or at F_0 = inf."""
    iso = Isolator(lam=3, r=r, delta_h=0.1, mu=0.01, zeta=0.1)
    with pytest.raises(OverflowError, match=r"squares of the forces at the amplitude u_cr = 0\.43589 are beyond"):
        iso.detachment()
    many = Isolator.many(lam=3, r=[r, 2.0], delta_h=0.1, mu=0.01, zeta=0.1).detachment()
    assert many.status.tolist() == [Status.NO_BOUND, Status.OK]


@pytest.mark.parametrize("F_0", [1e60, 1e120])
def test_force_whose_powers_leave_the_doubles_is_said_to(F_0):
    """It is answered, or refused in these words: branches were said to coincide, which are far apart."""
    spring = Duffing(1.0, 0.5, mu=0.01, zeta=0.1)
    with mpmath.workdps(30):  # where R = 0: 2 zeta A Omega + m = F_0, Omega^2 = 1 + 3/8 A^2, for A as large as that
        A = float(mpmath.sqrt(mpmath.mpf(F_0) / (2 * mpmath.mpf(0.1) * mpmath.sqrt(mpmath.mpf(3) / 8))))
    for ask in (lambda: spring.peak(F_0).A, lambda: spring.saddle_nodes(F_0).A[-1]):
        try:
            assert ask() == pytest.approx(A, rel=1e-12)
        except NotSettled as refusal:
            assert "leave the range of doubles" in str(refusal)
    try:
        spring.frequency_response(F_0)
    except NotSettled as refusal:
        assert "leave the range of doubles" in str(refusal)


@pytest.mark.parametrize("force", ["truncated", "untruncated"])
@pytest.mark.parametrize("gap", [1e-2, 1e-4, 1e-8, 2.0**-52])
def test_motion_next_to_the_largest_preload_is_right_or_refused(force, gap):
    """delta_h next to 1: where the springs detach the force as geometry gives it is as steep as 1/(1 - delta_h)."""
    oscillator = Isolator(lam=3, r=0.25, delta_h=1 - gap, mu=0.005, zeta=0.02, force=force)
    refusals = [solved(oscillator, Omega, F_0) for F_0 in (0.05, 0.2, 0.6) for Omega in (0.3, 0.6, 0.9, 1.2)]
    assert all("integration" in one or "residual" in one for one in refusals if one)
    assert refusals.count("") > 3
