"""The worst points that the search of `make stress` found, replayed: no error grows beyond what was measured.

Kernels at stored points against stored exact values; answers and roots against solutions found anew in hundreds of
bits; numbers of states and folds against proved ones, at the stored wrong cases and at seeded ones.
"""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from benchmarks.document import DOCS, RESULTS
from benchmarks.stress import __main__ as stress
from benchmarks.stress import answers, baseline, counts, domains, kernels, roots
from tests import backends
from tests.files import stored
from tests.kernels.test_kernels import worst
from tests.oracles import kernels as exact
from tests.oracles.frequencies import KINDS
from tests.sampling import fewer

BASELINE = baseline.stored()
# the last digit of a stored error, and of a stored scale
ROUNDED = 1 + 1e-4


def grouped(rows, *names):
    """Rows of the baseline by some of their entries."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[name] for name in names), []).append(row)
    return groups


KERNELS = grouped(BASELINE["kernels"], "module", "kernel")
ANSWERS = grouped(BASELINE["answers"], "mechanism", "kind")
ROOTS = grouped(BASELINE["roots"], "kind")
COUNTS = grouped(BASELINE["counts"], "mechanism", "kind", "by")


@pytest.fixture(scope="module", params=["numpy", "native"])
def package(request):
    """The kernels' modules by name, on one backend, with its name."""
    return request.param, backends.load(request.param)


def test_every_kernel_has_worst_points():
    without_outputs = {("duffing", "breakpoints"), ("duffing", "jumps")}
    assert set(KERNELS) == set(kernels.named()) - without_outputs


def test_the_page_is_what_its_numbers_give():
    """Its numbers named kernels that were gone, and arguments that others had got since: it could not be written."""
    pytest.importorskip("matplotlib")
    from benchmarks.stress import page

    numbers = json.loads((RESULTS / "stability.json").read_text(encoding="utf-8"))
    for what in ("kernels", "extremes"):
        assert {(row["module"], row["kernel"]) for row in numbers[what]} <= set(kernels.named())
    assert page.page(numbers) == (DOCS / "stability.md").read_text(encoding="utf-8")


def test_boxes_are_those_of_the_arguments_that_kernels_take():
    names = baseline.arguments([{"module": module, "names": own} for (module, _), own in kernels.named().items()])
    boxes = {row["module"]: row["where"] for row in BASELINE["boxes"]}
    assert boxes == {module: domains.in_words(module, sorted(own)) for module, own in names.items()}


@pytest.mark.parametrize("module", sorted({module for module, _ in KERNELS}))
def test_no_kernel_is_worse_at_its_worst_points(package, module):
    backend, modules = package
    for row in (row for row in BASELINE["kernels"] if row["module"] == module):
        before = row["errors"][backend]
        if before is None or before == "inf":  # lost already: the page says where
            continue
        with np.errstate(all="ignore"):
            values = np.ravel(np.array(getattr(modules[module], row["kernel"])(*row["at"]), dtype=float))
        # the arctangent, sine and cube root of another library may differ by an ulp
        assert worst(values, row) <= max(before * ROUNDED, 0.5), (row["kernel"], row["at"])


@pytest.mark.parametrize("kind", KINDS)
def test_no_root_is_worse_at_its_worst_points(kind):
    for row in ROOTS[kind,]:
        error, _ = roots.error(kind, tuple(row["at"]))
        assert error <= row["error"] * ROUNDED, row["at"]


@pytest.mark.slow
@pytest.mark.parametrize(("mechanism", "kind"), ANSWERS)
def test_no_answer_is_worse_at_its_worst_points(mechanism, kind):
    for row in ANSWERS[mechanism, kind]:
        found = answers.measure(mechanism, kind)(tuple(row["at"]))
        assert found is not None, row["at"]
        # within one rounding of its condition, the target, an answer may come out a float away
        assert found[0] <= max(float(row["error"]) * ROUNDED, 1.0), row["at"]


@pytest.mark.slow
@pytest.mark.parametrize(("mechanism", "kind", "by"), COUNTS)
def test_no_stored_count_beside_a_level_is_wrong(mechanism, kind, by):
    """Within some u (1 + kappa) of a level: doubles count correctly or report that they are undecided."""
    if by == "balls":
        pytest.importorskip("flint")
    for row in COUNTS[mechanism, kind, by]:
        at = tuple(map(float, row["at"]))
        iso = answers.oscillator(mechanism, at)
        number, undecided = counts.by_doubles(kind, iso, at)
        assert undecided or number == row["proved"], at
        number, undecided = counts.by_balls(kind, iso, at)
        assert number == row["proved"] or (undecided and by != "balls"), at


def test_counts_of_both_kinds_are_stored_by_doubles_and_by_balls():
    assert {("states", "doubles"), ("folds", "doubles"), ("states", "balls")} <= {key[1:] for key in COUNTS}


@pytest.mark.slow
@pytest.mark.parametrize(("mechanism", "oscillators", "states"), [("rod_spring", 8, 4_000), ("duffing", 100, 40_000)])
def test_seeded_counts_are_proved(mechanism, oscillators, states):
    """Cases that `make stress` does not ask: no number of states or folds is wrong; 10^5 would take minutes.

    Of an eighth of the oscillators per push.
    """
    found = counts.stress(mechanism, part=1000, oscillators=fewer(oscillators, 8))
    assert found["states"]["cases"] > fewer(states, 16)
    for kind in ("states", "folds"):
        assert found[kind]["wrong"] == []
        assert found[kind]["wrong beside"] == found[kind]["wrong by balls"] == 0


@pytest.mark.slow
def test_the_oracle_of_kernels_agrees_with_the_quadratures():
    """Two routes to the averaged forces: balls and elliptic integrals, and quadrature of the force."""
    table = stored("kernel_oracle")
    names = {
        "rod_spring": "A alpha beta gamma u_cr",
        "rod_spring_untruncated": "A alpha beta delta_h",
        "duffing": "A alpha beta gamma",
    }
    for module, arguments in names.items():
        for row in table[module]["averaged"]:
            values, scales = exact.values(module, "averaged", arguments.split(), row["at"])
            for value, scale, text, size in zip(values, scales, row["is"], row["scale"], strict=True):
                assert abs(value - exact.mpf(text)) <= 1e-30 * exact.mpf(size)
                assert math.isclose(scale, exact.mpf(size), rel_tol=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("what", stress.GROUPS)
def test_each_part_of_the_search_runs(what):
    """At few points: what the search finds stands above."""
    part, found, seconds = stress.run((what, stress.jobs(1e-4)[what][0]))
    assert part == what and found is not None and seconds >= 0
