"""A sample of the corpus: what slowflow answers is what it answered when the corpus was recorded."""

from __future__ import annotations

import json

import pytest

from tests.corpus.__main__ import RECORD, machine
from tests.corpus.families import FAMILIES
from tests.corpus.record import differences, reduced

#: these take seconds, or their counts hang on the last bit
SLOW = {"batch load", "single load", "derived", "grid", "store", "at the onset"} | {
    name for name in FAMILIES if name.startswith("damping")
}


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.slow if name in SLOW else [])
        for name, family in FAMILIES.items()
        if family.sample
    ],
)
def test_corpus_sample_is_unchanged(name):
    """Bits on the machine and build of the record, numbers of answers and refusals elsewhere."""
    record = json.loads(RECORD.read_text(encoding="utf-8"))
    old, new = record["sample"][name], reduced(FAMILIES[name].pairs(FAMILIES[name].sample))[0]
    if record["machine"] != machine():
        if name == "at the onset":
            pytest.skip("how many folds there are next to the onset hangs on the last bit")
        old, new = ({q: {**one, "bits": {}} for q, one in of.items()} for of in (old, new))
    assert differences(old, new, {}, {}) == []
