"""Batches in parts: shared by threads, stopped by Ctrl-C, in any shape and number type."""

from __future__ import annotations

import dataclasses
import math
import signal

import numpy as np
import pytest

from slowflow import Duffing, Isolator
from slowflow.answers.results import Remark
from slowflow.averaged import many as batches
from slowflow.core import backend
from slowflow_kernels.conventions import Status
from tests import batch_questions
from tests.batch_questions import columns
from tests.sampling import slow

ASK = {
    "detachment": lambda designs, **more: designs.detachment(**more),
    "onset": lambda designs, **more: designs.saddle_node_onset(**more),
    "folds": lambda designs, **more: designs.saddle_nodes(0.05, **more),
    "peak": lambda designs, **more: designs.peak([[0.05], [0.2]], **more),
    "curves": lambda designs, **more: designs.frequency_response(0.05, samples=20, **more),
    "second": lambda designs, **more: designs.second_approximation.saddle_nodes(0.05, **more),
}


@pytest.mark.parametrize("question", ASK)
def test_threads_and_parts_give_the_same_bits(question, monkeypatch):
    """Designs of two and three axes, one of them broadcast; chunks that end in the middle of an axis."""
    rng = np.random.default_rng(5)
    designs = Isolator.many(
        lam=rng.uniform(1, 4, (1, 9)), r=rng.uniform(0.5, 2, (2, 1)), delta_h=0.2, mu=[0.0, 0.01] * 4 + [-1], zeta=0.03
    )
    whole = columns(ASK[question](designs))
    for record in batches.BY_NAME.values():
        monkeypatch.setitem(record.__dict__, "at_once", 4)
    query = batches.curves
    monkeypatch.setattr(batches, "curves", lambda *arguments: dataclasses.replace(query(*arguments), at_once=4))
    for workers in (1, 3, -1):
        chunked = columns(ASK[question](designs, workers=workers))
        for name, value in whole.items():
            assert value.shape == chunked[name].shape and value.tobytes() == chunked[name].tobytes()


@pytest.mark.parametrize("workers", [0, -2, 1.5, "all", None])
def test_a_number_of_workers_that_is_none_is_refused(workers):
    with pytest.raises(ValueError, match="workers"):
        Isolator.many(lam=3, r=1, delta_h=0.1).detachment(workers=workers)


@pytest.mark.parametrize("more", [{}, {"load": 0.01}], ids=["about the centre", "off it"])
def test_a_map_for_workers_is_refused_with_the_reason(more):
    """SciPy takes one, and so somebody will give one."""
    with pytest.raises(ValueError, match=r"workers = .*map.* is not allowed: threads write into shared arrays"):
        Isolator.many(lam=3, r=[1.0], delta_h=0.1, **more).detachment(workers=map)


@pytest.mark.parametrize("workers", [1, 2])
def test_few_designs_are_begun_after_ctrl_c(workers):
    """However long a batch takes: of 20,000 designs, in parts of four, those of parts that are all but under way."""
    begun = []

    def counted(record):
        def solve(*arguments, out):
            begun.append(arguments[0].size)
            if len(begun) == 3:
                signal.raise_signal(signal.SIGINT)
            backend.SOLVER.many_saddle_nodes(record)(*arguments, out=out)

        return solve

    question = dataclasses.replace(batches.BY_NAME["saddle_nodes"], batch=counted, at_once=4)
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


@pytest.mark.parametrize(
    "kind", [np.float32, np.int64, np.longdouble, ">f8", "strided", "unaligned", "read-only", "Fortran", "empty"]
)
def test_arrays_of_any_kind_are_taken_as_their_numbers(kind):
    lam = np.array([1.0, 2.0, 3.0, 4.0])
    if kind == "strided":
        array = np.repeat(lam, 2)[::2]
    elif kind == "unaligned":
        array = np.frombuffer(b"\0" + lam.tobytes(), dtype=np.uint8)[1:].view(float)
    elif kind == "read-only":
        array = lam.copy()
        array.flags.writeable = False
    elif kind == "Fortran":
        lam = lam.reshape(2, 2)
        array = np.asfortranarray(lam)
    elif kind == "empty":
        lam = array = np.empty((0, 3))
    else:
        array = lam.astype(kind)
    expected = Isolator.many(lam=lam, r=0.5, delta_h=0.1, mu=0.01, zeta=0.02)
    designs = Isolator.many(lam=array, r=0.5, delta_h=0.1, mu=0.01, zeta=0.02)
    for ask in (ASK["detachment"], ASK["onset"], ASK["folds"]):
        for one, other in zip(columns(ask(expected)).values(), columns(ask(designs)).values(), strict=True):
            assert one.shape == other.shape and one.tobytes() == other.tobytes()


@pytest.mark.parametrize("force", ["truncated", "untruncated"])
def test_proofs_of_a_batch_survive_a_breakpoint_at_rest(force):
    """delta_h = 0: it has no folds, or nothing is proved of it; balls took its force for one of one piece."""
    found = Isolator.many(lam=5e-324, r=0.01, delta_h=[0.0, 0.1], mu=1e-300, zeta=0.3, force=force).certify(2.0)
    assert found.count[0] == 0 and found.proved[0] == (force == "truncated") and found.status[1] == Status.OK


# ---- response curves ------------------------------------------------------------------------------------------------


def test_curves_of_many_say_where_there_are_none():
    """One that is all right, one that sticks, one that is none; with places for fewer folds than it has."""
    many = Isolator.many(lam=3, r=2.03, delta_h=0.082, mu=0.012, zeta=[0.02, 0.02, -1.0])
    F_0 = np.array([0.04, 0.01, 0.04])
    found = many.frequency_response(F_0, samples=30)
    assert found.status.tolist() == [Status.OK, Status.STICKS, Status.INVALID]
    one = Isolator(lam=3, r=2.03, delta_h=0.082, mu=0.012, zeta=0.02)
    assert found.points[1:].tolist() == [0, 0] and np.isnan(found.A[1:]).all() and not found.remarks[1:].any()
    few = many.frequency_response(F_0, samples=30, max_count=1)
    assert few.status[0] == Status.TOO_MANY and few.fold_A.shape == (3, 1) and few.count[0] == found.count[0] > 1
    np.testing.assert_array_equal(few.A, found.A)
    assert many.frequency_response(F_0, samples=30, Omega=(5.0, 6.0)).points[0] < found.points[0]
    for wrong in ({"samples": 1}, {"Omega": (1.0, 1.0)}, {"max_count": 0}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            many.frequency_response(F_0, **wrong)
    columns = found.columns()
    assert {len(column) for column in columns.values()} == {found.points[0]} and columns["zeta"][0] == 0.02
    np.testing.assert_array_equal(columns["A"], one.frequency_response(0.04, samples=30).A)


def test_response_beyond_doubles_is_refused_or_has_a_status():
    """Its spring and damper are so weak that the first amplitude to bound it is infinite: once that passed for one."""
    alpha, beta, zeta, F_0 = 5.606793145963986e-165, 8.671754066100369e-116, 6.603238163424822e-186, 1.6766505645178e122
    one, many = Duffing(alpha, beta, 0.0, zeta), Duffing.many([alpha, 1.0], [beta, 0.1], 0.0, [zeta, 0.02])
    for ask in (one.frequency_response, one.saddle_nodes, lambda F: one.amplitudes(Omega=1.0, F_0=F)):
        with pytest.raises(OverflowError, match="no amplitude bounds the response"):
            ask(F_0)
    found = many.frequency_response([F_0, 0.1], samples=10)
    assert found.status.tolist() == [Status.NO_BOUND, Status.OK] and found.points[0] == 0


@pytest.mark.parametrize("load", [0.0, 0.02])
def test_answers_by_doubles_are_those_of_the_questions(load):
    """Of the first design the lower states leave the centre, where no balls are needed."""
    designs, F_0 = Duffing.many([-0.2, 1.0], 1.0, 0.0, 0.05, load=load), np.array([0.05])
    for question, at in (("saddle_nodes", {}), ("amplitudes", {"Omega": np.array([0.3])})):
        found = columns(designs._by_doubles(question, max_count=3, F_0=F_0, **at))
        for name, value in columns(getattr(designs, question)(max_count=3, F_0=F_0, **at)).items():
            np.testing.assert_allclose(found[name], value, rtol=1e-14 if load else 0.0, err_msg=name)


@pytest.mark.parametrize("force", ["truncated", "untruncated"])
def test_springs_that_never_touch_leave_a_linear_mount(force):
    """delta_h = 0 among others: closed forms, also where a rod with springs would stand vertical."""
    parameters = {"lam": 4, "r": 1.6, "mu": 0.0, "force": force}
    designs = Isolator.many(**parameters, delta_h=[0.0, 0.1], zeta=[[0.0], [0.01]])
    F_0, Omega = 10.0, 0.9
    states = designs.amplitudes(Omega=Omega, F_0=F_0)
    expected = F_0 / np.hypot(1 - Omega**2, 2 * np.array([0.0, 0.01]) * Omega)
    np.testing.assert_allclose(states.A[:, 0, 0], expected, rtol=1e-14)
    assert states.remarks[:, 0].tolist() == [Remark.CUT, 0] and states.remarks[1, 1] == Remark.BEYOND_REACH
    onset = designs.saddle_node_onset()
    assert onset.status[:, 0].tolist() == [Status.NONE] * 2 and np.isinf(designs.margins(F_0).F_SN[:, 0]).all()
    np.testing.assert_allclose(designs.isolation(F_0).Omega[:, 0], math.sqrt(2), rtol=1e-13)
    curve = designs.frequency_response(F_0, samples=50, Omega=(1.1, 2.0))
    seen = curve.A[0, 0, : curve.points[0, 0]], curve.Omega[0, 0, : curve.points[0, 0]]
    np.testing.assert_allclose(seen[0], F_0 / (seen[1] ** 2 - 1), rtol=1e-11)
    shock = designs.transient(acceleration=4.0, duration=2.0)
    assert (shock.A > 1).all() and shock.remarks.tolist() == [[0, Remark.BEYOND_REACH]] * 2


#: designs of which the middle one has numbers within their domains, and a parameter or 4 mu/pi beyond 1e300
BEYOND_DOUBLES = {
    "stiff springs": (Isolator, {"lam": 3, "r": [1.0, 1e300, 2.0], "delta_h": 0.1, "mu": 0.012}),
    "much friction": (Isolator, {"lam": 3, "r": 2.0, "delta_h": 0.1, "mu": [0.01, 1e300, 0.0]}),
    "stiff": (Duffing, {"alpha": [1.0, 1.7e308, 0.5], "beta": 0.1, "mu": 0.012}),
    "hard": (Duffing, {"alpha": 1.0, "beta": [1.0, -1.7e308, -0.1], "mu": 0.0}),
}


@pytest.mark.parametrize("zeta", [0.02, *slow(0.0)])
@pytest.mark.parametrize("case", BEYOND_DOUBLES)
@pytest.mark.parametrize("question", batch_questions.ALL)
def test_design_beyond_doubles_has_a_status_and_spoils_no_other(question, case, zeta):
    kind, parameters = BEYOND_DOUBLES[case]
    parameters = {**parameters, "zeta": zeta}
    numbers = {name: np.broadcast_to(value, 3) for name, value in parameters.items()}
    with pytest.raises(ValueError, match="beyond 1e\\+300"):
        kind(**{name: float(value[1]) for name, value in numbers.items()})
    F_0 = np.array([0.04, 0.04, 0.06])
    found = batch_questions.columns(batch_questions.ask(kind.many(**parameters), question, F_0))
    assert (found["status"][1] == Status.INVALID).all()
    others = kind.many(**{name: value[::2] for name, value in numbers.items()})
    for name, value in batch_questions.columns(batch_questions.ask(others, question, F_0[::2])).items():
        np.testing.assert_array_equal(found[name][::2], value, strict=True)


def test_friction_beyond_doubles_has_a_status_without_a_warning():
    onset = Isolator.many(lam=1.0, r=1.0, delta_h=0.5, mu=[0.01, 1.7e308], zeta=0.02).saddle_node_onset()
    assert (onset.status[1] != Status.OK) and onset.remarks.shape == (2,)
