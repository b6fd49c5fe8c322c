"""What the benchmarks compare with: the peers' problem against the kernels, and the judging."""

import math
import random
import subprocess
import sys
import time
from pathlib import Path

import mpmath
import numpy as np
import pytest

from benchmarks import bench_exact, certified, costs, document, questions, remote, work_precision
from benchmarks.document import with_earlier
from benchmarks.jobs import prepare
from benchmarks.peers import problem
from benchmarks.remote import Remote, in_turn
from slowflow.example import DESIGN, TABLE_1
from slowflow_kernels import rod_spring, slow_flow

P = tuple(float(x) for x in rod_spring.coefficients(*DESIGN))
AMPLITUDES = (0.05, 0.2, 0.39, 0.41, 0.5, 0.62)


def test_the_peers_get_table_1() -> None:
    """Typed once more for them, who run where slowflow is not installed."""
    assert (problem.LAM, problem.R_STIFF, problem.DELTA_H, problem.MU, problem.ZETA) == tuple(TABLE_1.values())


@pytest.mark.parametrize("A", AMPLITUDES)
def test_the_peers_problem_is_the_derived_one(A: float) -> None:
    h, h_A = (float(x) for x in rod_spring.averaged_2(A, *P))
    assert problem.averaged(A) == pytest.approx(h, rel=1e-13)
    assert problem.averaged_A(A) == pytest.approx(h_A, rel=1e-12)
    F, half_F_A = problem.response(0.9, A)
    m = float(slow_flow.friction(problem.MU))
    assert F == pytest.approx(float(slow_flow.F(0.9, A, problem.F_0, m, problem.ZETA, h)), rel=1e-9, abs=1e-16)
    assert 2 * half_F_A == pytest.approx(float(slow_flow.F_A(0.9, A, m, problem.ZETA, h, h_A)), rel=1e-9, abs=1e-16)


def test_the_peers_start_is_a_steady_state() -> None:
    rates = problem.slow_flow(problem.START_A, problem.START_PHI, problem.OMEGA_MIN)
    assert max(abs(rate) for rate in rates) < 1e-3


def test_folds_of_a_locus_are_judged_by_their_condition() -> None:
    """A rounding of Omega is one at a certified fold; folds' own digits are beyond it."""
    for Omega, A in certified.folds():
        at, rounding = float(Omega), float(Omega) * certified.U
        near, off = (certified.Table1().fold_error(at + shift, float(A)) for shift in (0.0, 8 * rounding))
        assert near < 1 < off < 9


def test_judging_counts_what_is_missed_and_what_is_false() -> None:
    expected = [[mpmath.mpf(1)], [mpmath.mpf(2)], [mpmath.mpf(3)]]
    errors, missed, false = work_precision.judge([[2.0], [1 + 2**-40], [2.5]], expected)
    assert errors == [2.0**-40, 0.0]
    assert (missed, false) == (1, 1)


def test_quantities_in_words() -> None:
    assert document.quantity(2.5e-4, "s") == "250 µs"
    assert document.quantity(math.pi, "s") == "3.14 s"
    assert document.quantity(2e6, "per second") == "2.00e6 per second"
    assert document.quantity(float(np.float64(0)), "MB") == "0 MB"


def test_tool_that_cannot_be_run_keeps_its_rows() -> None:
    """And says so; one that ran and failed has no time, whatever it had before."""
    measured = {"peer": "AUTO", "what": "continuation", "variant": "large steps", "seconds": 1.0}
    before = [measured, {**measured, "peer": "ran"}]
    missing = {"peer": "AUTO", "what": "continuation", "failure": "does not install: there is no gfortran"}
    ran = {"peer": "ran", "what": "", "variant": "large steps", "failure": "no answer"}
    new = {"peer": "new", "what": "", "failure": "does not install"}
    rows = with_earlier([missing, ran, new], before, "peer", "another")
    note = "measured earlier, on another; now it does not install: there is no gfortran"
    assert rows == [{**measured, "earlier": note}, ran, new]
    (again,) = with_earlier([missing], [rows[0]], "peer", "a third")
    assert again["earlier"] == note


def test_peers_not_at_hand_keep_their_figures() -> None:
    """And say so once, however often they are missed; what was never measured stays missing."""
    before = {"environment": {"processor": "another"}, "rows": [{"job": "quartic", "others": {"Boost.Math": "90 ns"}}]}
    for _ in range(2):
        (row,) = questions.with_others([{"job": "quartic", "others": {"Boost.Math": None, "ACM": None}}], before)
        assert row["others"] == {"Boost.Math": "90 ns (measured earlier, on another)", "ACM": None}
        before = {"environment": {"processor": "a third"}, "rows": [row]}
    (row,) = questions.with_others([{"job": "quartic", "others": {"Boost.Math": "80 ns"}}], before)
    assert row["others"] == {"Boost.Math": "80 ns"}
    row = {"job": "quartic", "comparison": "NumPy", "others": {"Boost.Math": "80 ns", "ACM": None}}
    assert document.comparison(row) == "NumPy; 80 ns; ACM is not installed here"


def test_the_pages_are_those_of_the_results(tmp_path: Path) -> None:
    for path in document.RESULTS.glob("*.json"):
        (tmp_path / path.name).write_bytes(path.read_bytes())
    document.write(tmp_path, tmp_path)
    for page in (document.DOCS / "benchmarks.md", document.RESULTS / "README.md"):
        assert (tmp_path / page.name).read_text(encoding="utf-8") == page.read_text(encoding="utf-8")


def test_processor_time_holds_what_a_process_waited_for() -> None:
    """And no time that it only waits."""
    start = remote.processor()
    time.sleep(0.2)
    assert remote.processor() - start < 0.1
    busy = "import time; start = time.process_time()\nwhile time.process_time() - start < 0.3: pass"
    subprocess.run([sys.executable, "-c", busy], check=True)
    assert remote.processor() - start > 0.3


def test_a_process_that_was_ended_is_said_to_be_so() -> None:
    """Also of its other jobs, when one took too long."""
    remote = Remote("benchmarks.peers.slowflow")
    remote.stop()
    _, failures = in_turn({"one": (remote, remote.jobs[0]), "other": (remote, remote.jobs[1])}, 1)
    assert set(failures) == {"one", "other"} and "was ended" in failures["other"]


def test_what_stops_cost_is_measured_from_motions_that_stop() -> None:
    """Few repeats: each number of stops that the curve has, once."""
    stops = [row["stops"] for row in bench_exact.by_stops(1)]
    assert len(stops) > 3 and stops == sorted(set(stops))


def test_wrong_answer_has_no_time() -> None:
    questions.check(True, "folds")
    with pytest.raises(RuntimeError, match="folds: the answers are wrong"):
        questions.check(False, "folds")


@pytest.mark.slow
def test_jobs_answer_with_what_is_checked() -> None:
    """A batch of every kind, and the folds of Table 1, which are right."""
    jobs = prepare()
    run, describe = jobs["curve"]
    assert questions.largest_error(describe(run())["found"], certified.folds()) < 1e-13
    for name in ("random | amplitudes", "Table 1 | detachment", "second | peak", "workers 2 | saddle_nodes"):
        run, describe = jobs[f"{name} | 10"]
        assert describe(run())["status"] < questions.UNSOLVED


@pytest.mark.parametrize("kind", costs.KINDS)
def test_scenes_whose_cost_is_measured_are_read(kind: str) -> None:
    """Their density lacked a unit after that was required: no cost could be measured."""
    for question in costs.QUESTIONS:
        assert question in {query.question for query in costs.scene(question, kind, random.Random(1)).queries}


def test_the_cost_of_tolerances_design_by_design_is_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    """A tenth of the samples, for ten times as long; it took arguments by a name that was gone."""
    taken: list[int] = []
    monkeypatch.setattr(costs, "tolerances", lambda of, samples, **_: taken.append(samples))
    of = costs.scene("tolerances", "load", random.Random(1))
    (query, *_) = (one for one in of.queries if one.question == "tolerances")
    assert costs.once(of, query) >= 0 and taken == [costs.FEW_SAMPLES // 10]
