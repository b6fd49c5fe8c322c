"""`generated/` is what the derivation writes: the same bytes under any hash seed, and no hand-edit goes unseen."""

from __future__ import annotations

import json
import shutil

import pytest

from derivations import __main__ as pipeline
from derivations.codegen.write import MANIFEST, differences, on_disk, write
from tests import sampling
from tests.files import ROOT

GENERATED = ROOT / "generated"


@pytest.fixture
def check(once, results, monkeypatch, capsys):
    """`python -m derivations --check --out FOLDER`: a folder in, exit code and report out.

    What is written anew is the derivation that other tests have too, under the hash seed of this process; in
    `make test-all` that of two fresh processes under two hash seeds. `change` may alter what they wrote.
    """

    def of_results(scratch):
        files = pipeline.generate(results)
        for seed in pipeline.HASH_SEEDS:
            write(files, scratch / seed)

    written = once("regenerated", pipeline.regenerate if sampling.ALL else of_results)

    def check(folder, change=lambda scratch: None):
        def regenerate(scratch):
            shutil.copytree(written, scratch, dirs_exist_ok=True)
            change(scratch)

        monkeypatch.setattr(pipeline, "regenerate", regenerate)
        return pipeline.main(["--check", "--out", str(folder)]), capsys.readouterr().out

    return check


@pytest.mark.slow
def test_what_is_committed_is_what_the_derivation_writes(check):
    """Byte for byte; under either hash seed in `make test-all`."""
    assert check(GENERATED) == (0, "")


@pytest.mark.slow
def test_check_sees_a_hand_edit_a_missing_and_a_stale_file(check, tmp_path):
    copy = tmp_path / "generated"
    shutil.copytree(GENERATED, copy, ignore=shutil.ignore_patterns("__pycache__", "*.so"))
    edited = copy / "c" / "slow_flow.h"
    edited.write_text(edited.read_text().replace("1.2732395447351628", "1.2732395447351629"))
    (copy / "slowflow_kernels" / "duffing.py").unlink()
    (copy / "slowflow_kernels" / "hardening.py").write_text("")
    code, text = check(copy)
    report = text.splitlines()
    assert code == 1
    assert report[0] == "missing: generated/slowflow_kernels/duffing.py"
    assert report[1] == "stale: generated/slowflow_kernels/hardening.py"
    assert report[2:4] == ["--- generated/c/slow_flow.h", "+++ regenerated/c/slow_flow.h"]
    changed = [line for line in report[4:] if line[0] in "+-"]
    assert [line[0] for line in changed] == ["-", "+"]
    assert "1.2732395447351629" in changed[0] and "1.2732395447351628" in changed[1]


@pytest.mark.slow
def test_check_sees_what_depends_on_the_hash_seed(check):
    def by_chance(scratch):
        (scratch / pipeline.HASH_SEEDS[1] / "slowflow_kernels" / "duffing.py").write_text("in another order\n")

    code, text = check(GENERATED, by_chance)
    assert code == 1
    reported = [line for line in text.splitlines() if line.startswith("hash seed")]
    assert reported == [f"hash seed {seed}:" for seed in pipeline.HASH_SEEDS]


def test_differences():
    generated = {"a.h": "one\ntwo\n", "b.h": "same\n"}
    assert differences(generated, dict(generated), "g") == []
    assert differences(generated, {"a.h": "one\ntwo\n"}, "g") == ["missing: g/b.h\n"]
    assert differences(generated, generated | {"c.h": ""}, "g") == ["stale: g/c.h\n"]
    report = "".join(differences(generated, generated | {"a.h": "one\nthree\n"}, "g"))
    assert report.startswith("--- g/a.h\n+++ regenerated/a.h\n") and "-three\n+two\n" in report


def test_a_changed_line_ending_is_a_difference():
    assert differences({"a": "one\n"}, {"a": "one\r\n"}, "g")
    assert differences({"a": "one\n"}, {"a": "one"}, "g")


def test_write_deletes_what_is_stale_and_nothing_else(tmp_path):
    (tmp_path / "thesis.tex").write_text("dear reader")
    for name in ("old", "new"):
        files = {f"c/{name}.h": f"{name}\n", "c/kept.h": f"{name} too\n"}
        write(files | {MANIFEST: json.dumps({"files": dict.fromkeys(files, "")})}, tmp_path)
    found = on_disk(tmp_path)
    assert found.pop(MANIFEST)
    assert found == {"thesis.tex": "dear reader", "c/kept.h": "new too\n", "c/new.h": "new\n"}


@pytest.fixture(scope="module")
def manifest():
    return json.loads((GENERATED / MANIFEST).read_text())


def test_manifest_lists_every_file(manifest):
    assert set(manifest["files"]) == on_disk(GENERATED).keys() - {MANIFEST}


def test_manifest_records_the_resultants(manifest):
    onset = manifest["resultants"]["rod_spring saddle_node_onset"]
    assert onset["degree"] == 36
    assert onset["vanishing powers"] == list(range(1, 36, 2))
    detachment = manifest["resultants"]["detachment"]
    assert detachment["degree"] == 6 and detachment["content"] == "-256"
    assert {"factor": "A", "multiplicity": 8} in detachment["factors"]


@pytest.mark.parametrize("name", ["slowflow_kernels/rod_spring.py", "c/rod_spring.h"])
def test_header_says_where_it_comes_from(name, manifest):
    text = (GENERATED / name).read_text()
    source = manifest["mechanisms"]["rod_spring"]
    assert f"Written by `make derive` from {source['file']}; never edit." in text
