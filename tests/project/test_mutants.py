"""Plausible errors are noticed by the tests that say so; all of them by `make mutate`."""

from __future__ import annotations

import random

import pytest

from tests.mutants.__main__ import NOTICED, edits, judged

SAMPLE = 20


def test_every_edit_is_of_a_file_and_changes_it():
    assert len(edits()) >= 60
    assert all(edit.old != edit.new and edit.tests for edit in edits())


@pytest.mark.slow
@pytest.mark.night
def test_twenty_plausible_errors_are_noticed():
    """Others in each run; one whose text is gone from its file has to be replaced."""
    found = judged(random.SystemRandom().sample(edits(), SAMPLE), quick=True)
    assert [(edit.file, edit.new, verdict) for edit, verdict in found if verdict != NOTICED] == []
