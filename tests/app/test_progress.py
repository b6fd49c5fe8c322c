"""What takes long logs how far it is, whatever thread works on it."""

from __future__ import annotations

import logging
import re
from itertools import pairwise

import numpy as np
import pytest

from slowflow import Isolator
from slowflow.averaged import many as batches
from slowflow.support import progress
from tests.batch_questions import ALL, OFF_CENTRE, ask


@pytest.fixture
def always(monkeypatch):
    """Each line is logged."""
    monkeypatch.setattr(progress, "EVERY", 0.0)
    monkeypatch.setattr(progress, "FRACTION", 0.0)


@pytest.fixture
def reported(caplog):
    """The messages of a call."""

    def messages(call):
        caplog.clear()
        with caplog.at_level("INFO", "slowflow"):
            call()
        return caplog.messages

    return messages


def assert_counts(messages, total=None):
    """Counts that rise up to the total, which itself is not printed, and start anew for another part."""
    found = [re.fullmatch(r"([a-z ]+): (\d+) of (\d+)", one) for one in messages]
    assert messages and all(found), messages
    assert all(int(one[2]) < int(one[3]) for one in found)
    if total is not None:
        assert any(one[3] == str(total) for one in found)


@pytest.mark.parametrize("question", ALL)
def test_batch_questions_report_progress(question, always, reported):
    r = np.linspace(0.5, 2.0, 40)
    designs = Isolator.many(lam=3, r=r, delta_h=0.1, mu=0.01, zeta=0.05)
    more = {} if re.match(r"second_approximation\.(amplitudes|frequency_response)", question) else {"workers": 2}
    assert_counts(reported(lambda: ask(designs, question, np.full(40, 0.04), **more)), 40)
    assert reported(lambda: None) == []


@pytest.mark.slow
@pytest.mark.parametrize("question", OFF_CENTRE)
def test_every_question_off_the_centre_says_so(question, always, reported):
    designs = Isolator.many(lam=3, r=1, delta_h=0.1, mu=0.01, zeta=[0.3, -1.0, -1.0], load=0.02)
    assert_counts(reported(lambda: ask(designs, question, np.full(3, 0.02))), 3)


@pytest.mark.parametrize("workers", [1, 3])
def test_each_part_of_a_batch_is_counted_once(workers, always, reported, monkeypatch):
    """Of two axes, the second of which is cut into four, four and two, in whatever order threads end."""
    monkeypatch.setitem(batches.BY_NAME["detachment"].__dict__, "at_once", 4)
    designs = Isolator.many(lam=[[2.0], [3.0], [4.0]], r=np.linspace(0.5, 2.0, 10), delta_h=0.1, zeta=0.05)
    messages = reported(lambda: designs.detachment(workers=workers))
    counts = sorted({int(one.split()[1]) for one in messages})
    assert {one.split()[-1] for one in messages} == {"30"} and set(counts) <= set(range(2, 30, 2))
    if workers == 1:
        assert counts == [4, 8, 10, 14, 18, 20, 24, 28]


@pytest.mark.slow
def test_a_store_says_how_many_blocks_are_written(always, reported, tmp_path):
    da = pytest.importorskip("dask.array")
    pytest.importorskip("zarr")
    pytest.importorskip("xarray")
    designs = Isolator.many(lam=3, r=da.linspace(0.5, 2.0, 12, chunks=3), delta_h=0.1, zeta=0.05)
    messages = reported(lambda: designs.store(tmp_path / "map.zarr", "detachment"))
    assert_counts([one for one in messages if one.startswith("blocks")], 4)


def test_nothing_is_said_within_a_second(reported):
    designs = Isolator.many(lam=3, r=[1.0, 2.0], delta_h=0.1, zeta=0.05)
    assert reported(lambda: designs.saddle_nodes(0.04)) == []


def test_lines_come_after_a_second_and_a_tenth_of_the_time(monkeypatch, capsys):
    """Within `shown`; behind it nothing is printed."""
    now = [0.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])

    def work():
        for _ in progress.each(range(600), 600):
            now[0] += 0.125  # 75 seconds in all

    with progress.shown():
        work()
    printed = capsys.readouterr().err.splitlines()
    assert_counts(printed, 600)
    times = [0.125 * int(one.split()[1]) for one in printed]
    assert times[:10] == [float(k) for k in range(1, 11)]
    assert all(a + 0.1 * a <= b < a + 0.1 * a + 0.125 for a, b in pairwise(times[9:]))
    work()
    assert capsys.readouterr().err == "" and not logging.getLogger("slowflow").handlers
