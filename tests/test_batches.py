"""Batches in parts: shared by threads, stopped by Ctrl-C, in any shape and number type."""

from __future__ import annotations

import dataclasses
import signal

import numpy as np
import pytest

from slowflow import Isolator, backend
from slowflow.averaged import many as batches
from tests.interrupts import ENDING, interrupted

native_only = pytest.mark.skipif(backend.SOLVER is None, reason="the compiled solvers are not in use")

ASK = {
    "detachment": lambda designs, **more: designs.detachment(**more),
    "onset": lambda designs, **more: designs.saddle_node_onset(**more),
    "folds": lambda designs, **more: designs.saddle_nodes(0.05, **more),
    "peak": lambda designs, **more: designs.peak([[0.05], [0.2]], **more),
}


def columns(answer):
    return {name: value for name, value in vars(answer).items() if not name.startswith("_")}


@native_only
@pytest.mark.parametrize("question", ASK)
def test_threads_and_parts_give_the_same_bits(question, monkeypatch):
    """Designs of two and three axes, one of them broadcast; parts that end in the middle of an axis."""
    rng = np.random.default_rng(5)
    designs = Isolator.many(
        lam=rng.uniform(1, 4, (1, 9)), r=rng.uniform(0.5, 2, (2, 1)), delta_h=0.2, mu=[0.0, 0.01] * 4 + [-1], zeta=0.03
    )
    whole = columns(ASK[question](designs))
    for record in (batches.DETACHMENT, batches.ONSET, batches.SADDLE_NODES, batches.PEAK):
        monkeypatch.setitem(record.__dict__, "at_once", 4)
    for workers in (1, 3, -1):
        parts = columns(ASK[question](designs, workers=workers))
        for name, value in whole.items():
            assert value.shape == parts[name].shape and value.tobytes() == parts[name].tobytes()


@pytest.mark.parametrize("workers", [0, -2, 1.5, "all", None])
def test_a_number_of_workers_that_is_none_is_refused(workers):
    with pytest.raises(ValueError, match="workers"):
        Isolator.many(lam=3, r=1, delta_h=0.1).detachment(workers=workers)


@native_only
@pytest.mark.parametrize("question", ["saddle_nodes(0.05)", "saddle_nodes(0.05, workers=2)", "saddle_node_onset()"])
def test_ctrl_c_ends_a_batch(question):
    """A batch of minutes: the interrupt is heard while it runs."""
    program = (
        "import numpy as np; from slowflow import Isolator\n"
        "r = np.linspace(0.5, 2.0, 10**7)\n"
        "designs = Isolator.many(lam=3, r=r, delta_h=0.2 / r, mu=0.01, zeta=0.02)\n"
        f"print('asked', flush=True); designs.{question}; print('answered', flush=True)"
    )
    assert interrupted(program) == ENDING


@native_only
@pytest.mark.parametrize("workers", [1, 2])
def test_few_designs_are_begun_after_ctrl_c(workers):
    """However long a batch takes: of 20,000 designs, in parts of four, those of parts that are all but under way."""
    begun = []

    def counted(solver):
        def of_record(record):
            def solve(*given, out):
                begun.append(given[0].size)
                if len(begun) == 3:
                    signal.raise_signal(signal.SIGINT)
                solver.many_saddle_nodes(record)(*given, out=out)

            return solve

        return of_record

    question = dataclasses.replace(batches.SADDLE_NODES, batch=counted, at_once=4)
    designs = Isolator.many(lam=3, r=np.linspace(0.5, 2.0, 20_000), delta_h=0.1, mu=0.01, zeta=0.02)
    heard = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            designs.ask(question, workers, 0.05, 2)
    finally:
        signal.signal(signal.SIGINT, heard)
    assert set(begun) == {4} and sum(begun) < 10_000
    if workers == 1:
        assert len(begun) == 3


@pytest.mark.both_backends
@pytest.mark.parametrize(
    "kind", [np.float32, np.int64, np.longdouble, ">f8", "strided", "unaligned", "read-only", "Fortran", "empty"]
)
def test_arrays_of_any_kind_are_taken_as_their_numbers(kind):
    lam = np.array([1.0, 2.0, 3.0, 4.0])
    if kind == "strided":
        given = np.repeat(lam, 2)[::2]
    elif kind == "unaligned":
        given = np.frombuffer(b"\0" + lam.tobytes(), dtype=np.uint8)[1:].view(float)
    elif kind == "read-only":
        given = lam.copy()
        given.flags.writeable = False
    elif kind == "Fortran":
        lam = lam.reshape(2, 2)
        given = np.asfortranarray(lam)
    elif kind == "empty":
        lam = given = np.empty((0, 3))
    else:
        given = lam.astype(kind)
    expected = Isolator.many(lam=lam, r=0.5, delta_h=0.1, mu=0.01, zeta=0.02)
    designs = Isolator.many(lam=given, r=0.5, delta_h=0.1, mu=0.01, zeta=0.02)
    for ask in (ASK["detachment"], ASK["onset"], ASK["folds"]):
        for one, other in zip(columns(ask(expected)).values(), columns(ask(designs)).values(), strict=True):
            assert one.shape == other.shape and one.tobytes() == other.tobytes()
