"""Whatever is asked of an oscillator: an answer, or a refusal in words; no NaN without one, no warning, no crash."""

from __future__ import annotations

import contextlib
import inspect
import io
import sys
import tempfile
import time
import warnings
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from slowflow import Duffing, Isolator, sizing
from slowflow.answers.answer import Answer
from slowflow.app import cli
from slowflow.averaged.batches import Batch
from slowflow.oscillators.physical_designs import ManyQuantities
from slowflow.oscillators.range_checks import Implausible
from slowflow.support.errors import SlowflowError, WrongType
from slowflow_kernels.conventions import Status
from tests import public_questions
from tests.files import MOUNT, ROOT
from tests.public_questions import any_of, anything, columns, numbers
from tests.sampling import fewer

#: refusals: each has words; anything else that is raised is a defect
REFUSED = SlowflowError
#: of an answer: what follows motions of the equation itself, and what draws
LONG = ("measure", "plot", "plot_map")
#: processor time within which a question is promised to end
AT_MOST = 60.0

often = settings(suppress_health_check=[HealthCheck.too_slow])


def undefined(value):
    """Whether there is a NaN in it."""
    return isinstance(value, (float, np.ndarray)) and np.asarray(value).dtype.kind == "f" and np.isnan(value).any()


def answered(question):
    """The answer, None for a refusal in words; neither takes longer than is promised."""
    start = time.process_time()
    try:
        return question()
    except REFUSED as refusal:
        assert str(refusal)
        return None
    finally:
        assert time.process_time() - start < AT_MOST


def read(answer, extra=()):
    """Read all attributes and methods without arguments of an answer: gradients, tables, decibels, messages."""
    if isinstance(answer, (Batch, ManyQuantities)):
        no_nan_with_an_answer(getattr(answer, "answer", answer))
    elif hasattr(answer, "message"):
        # a force of one piece has no breakpoint to be beyond of
        found = [name for name, value in vars(answer).items() if undefined(value)]
        found = [name for name in found if name not in ("beyond", "crossing_rate")]
        assert not found or answer.message
    if not isinstance(answer, Answer):
        assert not (isinstance(answer, float) and undefined(answer))
        return
    assert str(answer)
    for name in dir(type(answer)):
        if name.startswith("_") or (name in LONG and name not in extra):
            continue
        found = answered(lambda name=name: getattr(answer, name))
        if callable(found) and not isinstance(found, type):
            needed = [one.default is one.empty for one in inspect.signature(found).parameters.values()]
            if not any(needed):
                answered(found)


def no_nan_with_an_answer(batch):
    """No NaN where the status says that there is an answer, and none that is of the wrong sign."""
    known = {"A", "Omega", "F_SN", "F_cr", "Omega_cr"}
    known -= {"A"} if batch.question.name == "isolation" else set()  # where all isolates no motion transmits F_0
    known -= {"F_SN"} if batch.question.name == "margins" else set()  # its status is `onset`
    answered = np.asarray(batch.status) == Status.OK
    for column in known:
        values = np.asarray(getattr(batch, column, 0.0))
        if values.shape == answered.shape:
            assert (values[answered] >= 0).all()


def asked_all(make, queries, extra=()):
    """Assert that each query of an oscillator has an answer or a refusal with a message, without a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # meant for the user
        warnings.filterwarnings("ignore", message=".*negative stiffness at rest")
        warnings.simplefilter("ignore", Implausible)
        if (oscillator := answered(make)) is None:
            return
        for name, (arguments, named) in queries:
            read(answered(lambda: getattr(oscillator, name)(*arguments, **named)), extra)  # noqa: B023  asked at once


@pytest.mark.parametrize("kind", public_questions.OF_CLASS)
def test_every_public_question_is_asked_here(kind):
    public = {name for name in dir(kind) if not name.startswith("_") and callable(getattr(kind, name))}
    assert public - public_questions.NO_QUESTIONS == set(public_questions.OF_CLASS[kind])


def made(kind):
    """An oscillator, or many, of a class of `OF_CLASS`."""
    one, mount = Isolator(lam=3, r=0.7, delta_h=0.1, mu=0.01, zeta=0.02), Isolator.physical(**MOUNT)
    load = {"lam": 3, "r": 0.7, "delta_h": 0.1, "zeta": [0.02, 0.03]}
    every = (one, one.second_approximation, one.replace(load=0.02).off_centre, mount, mount.many(m=[12.0, 13.0]))
    many = (one.many(**load), one.many(**load).second_approximation, one.many(**load, load=0.02))
    return next(found for found in (*every, *many) if type(found) is kind)


@pytest.mark.parametrize("kind", public_questions.OF_CLASS)
def test_an_unknown_argument_is_refused_with_those_there_are(kind):
    """By every question, before anything else."""
    of = made(kind)
    for name in sorted(set(public_questions.OF_CLASS[kind]) - {"replace"}):
        one_or_none = r"has no argument 'zetta': it must be one of \w|takes no argument: .*'zetta'"
        with pytest.raises(WrongType, match=rf"^{name} ({one_or_none})"):
            getattr(of, name)(zetta=0.1)


oscillators = st.tuples(st.just(Isolator), st.fixed_dictionaries(public_questions.ISOLATORS))
oscillators |= st.tuples(st.just(Duffing), st.fixed_dictionaries(public_questions.DUFFINGS))
batches = st.tuples(st.just(Isolator.many), st.fixed_dictionaries(public_questions.BATCHES))
loaded = st.tuples(st.just(Isolator.many), st.fixed_dictionaries({**public_questions.BATCHES, "load": columns}))
sheets = st.tuples(st.just(Isolator.physical), st.fixed_dictionaries(public_questions.SHEETS))
varied = st.fixed_dictionaries({}, optional={name: columns for name in ("m", "k_v", "k_h", "L", "preload", "friction")})
mounts = st.tuples(st.just(Isolator.physical(m=12, k_v=2500, k_h=1700, L=0.08, preload=0.009, zeta=0.02).many), varied)
#: objects, their attribute that is queried, its questions, how many at most, examples, what is read in addition
CASES = {
    "an oscillator": (oscillators, "", public_questions.AVERAGED, 3, fewer(300, 5), ()),
    "the second approximation": (oscillators, "second_approximation", public_questions.SECOND, 2, fewer(150, 5), ()),
    "motions off the centre": (oscillators, "off_centre", public_questions.OFF_CENTRE, 2, fewer(60, 5), ()),
    "exact motions": (oscillators, "", public_questions.MOTIONS, 2, fewer(60, 5), ()),
    "pictures and measured errors": (
        oscillators,
        "",
        {**public_questions.PICTURES, **public_questions.AT},
        1,
        12,
        ("measure", "plot"),
    ),
    "a batch": (batches, "", public_questions.OF_BATCHES, 2, fewer(150, 5), ()),
    "a batch in the second approximation": (
        batches,
        "second_approximation",
        public_questions.OF_SECOND_BATCHES,
        2,
        fewer(100, 5),
        (),
    ),
    "a batch off the centre": (loaded, "", public_questions.OF_LOADED_BATCHES, 1, fewer(60, 5), ()),
    "many mounts": (mounts, "", public_questions.OF_MOUNTS, 2, fewer(100, 5), ()),
    "a data sheet": (sheets, "", public_questions.IN_UNITS, 3, fewer(300, 5), ()),
    "motions of a data sheet": (sheets, "", public_questions.MOTIONS_IN_UNITS, 1, fewer(30, 5), ()),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_there_is_an_answer_a_status_or_a_refusal_in_words(name):
    made, part, questions, most, examples, extra = CASES[name]
    if "plot" in extra:
        pytest.importorskip("matplotlib")

    @settings(often, max_examples=examples)
    @given(made, st.lists(any_of(questions), min_size=1, max_size=most))
    def ask(made, queries):
        make, numbers = made
        asked_all(lambda: getattr(make(**numbers), part) if part else make(**numbers), queries, extra)
        if "plot" in extra:
            sys.modules["matplotlib.pyplot"].close("all")

    ask()


SCENE = (ROOT / "scenes" / "table_1.toml").read_text(encoding="utf-8")
VALUES = st.one_of(
    numbers.map(repr),
    st.sampled_from(["nan", "inf", "-1", "'x'", "[]", "{}", "true", "1e400", "1979-05-27", "[1, 'a']", "1e-400", ""]),
)


@pytest.mark.slow
@settings(often, max_examples=fewer(150, 5))
@given(st.integers(0, 6), VALUES)
def test_a_scene_with_any_value_is_answered_or_refused_in_words(place, value):
    """The file of Table 1 with one of its values replaced: an exit code and a message, and no traceback."""
    lines = SCENE.splitlines()
    stated = [k for k, line in enumerate(lines) if "=" in line and not line.startswith("#")]
    k = stated[place % len(stated)]
    lines[k] = f"{lines[k].partition('=')[0]}= {value}"
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", message=".*negative stiffness at rest")
        file = Path(folder) / "scene.toml"
        file.write_text("\n".join(lines), encoding="utf-8")
        output, errors = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            code = cli.main(["run", str(file), "--quiet"])
        assert code in (0, 1, 2)
        assert code == 0 or errors.getvalue().strip()


@pytest.mark.slow
@settings(often, max_examples=fewer(100, 5))
@example(1.7e308, 1.0, 1.0, "mu")
@example(0.0, 1.0, 1e-160, "mu")
@example(0.0, 1.0, 5e-324, "mu")
@given(anything, anything, anything, st.sampled_from(["mu", "zeta", "r", "delta_h", "what"]))
def test_sizing_is_answered_or_refused_in_words(part, F_0, bound, name):
    isolator = Isolator(lam=3, r=2, delta_h=0.1, mu=0.01, zeta=0.02)
    queries = (
        lambda: sizing.tolerances(isolator, {name: part}, F_0=F_0, samples=20),
        lambda: sizing.meet(isolator, {name: (part, bound)}, at_least={"F_SN": bound}, F_0=F_0),
        lambda: sizing.fit(isolator, Omega=[0.8, 0.9, bound], A=[0.1, part, 0.2], F_0=F_0, free=[name]),
    )
    for ask in queries:
        try:
            answer = ask()
        except REFUSED as refusal:
            assert str(refusal)
        else:
            assert answer is not None


def test_many_at_the_end_of_the_range_warn_of_nothing():
    """Found by random input at night: a mass near the largest double, and an end that lies 1e150 u_rms away."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        warnings.simplefilter("ignore", Implausible)
        sheet = dict(k_v=2500, k_h=1700, n=3, L=0.08, preload=0.009, zeta=0.02)
        mounts = Isolator.physical(m=12, **sheet).many(m=[12.0, 1.7e308])
        assert mounts.saddle_node_onset().status.tolist() == [Status.OK, Status.INVALID]
        designs = Isolator.many(lam=1.0, r=1.2415, delta_h=0.5, mu=[1.0, 1e150], zeta=1.0)
        assert designs.random(S_0=[1.0, 1e-6]).crossing_rate[1, 0] == 0
