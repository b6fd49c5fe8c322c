"""Whatever is asked of an oscillator: an answer, or a refusal in words; no NaN without one, no warning, no crash."""

from __future__ import annotations

import contextlib
import io
import math
import tempfile
import warnings
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from slowflow import Duffing, Isolator, cli, sizing
from slowflow.plausible import Implausible
from slowflow_kernels.conventions import Status

#: zero, subnormal, near one, the ends of the range: where formulas break
HARD = [0.0, -0.0, 5e-324, 1e-310, 1e-160, 1e-20, 1e-8, 0.99, 1 - 2**-53, 1.0, 1 + 2**-52, 1e8, 1e150, 1.7e308]
#: what no argument may be
WRONG = [math.nan, math.inf, -math.inf, -1.0, None, "1", [1.0], np.array([1.0, 2.0]), 1j, True, 10**400, object()]

usual = st.floats(1e-6, 2.0) | st.floats(-6, 1).map(lambda exponent: 10.0**exponent)
numbers = usual | st.sampled_from(HARD)
anything = numbers | st.sampled_from(WRONG)
damping = {"mu": st.floats(0, 0.05) | anything, "zeta": st.floats(0, 0.2) | anything}
isolators = st.fixed_dictionaries(
    {
        "lam": st.sampled_from([1, 2, 3, 4]) | anything,
        "r": st.floats(0.2, 4) | anything,
        "delta_h": st.floats(0, 0.6) | anything,
        "force": st.sampled_from(["truncated", "untruncated", "exact"]),
        **damping,
    }
)
duffings = st.fixed_dictionaries(
    {"alpha": st.floats(-0.5, 2) | anything, "beta": st.floats(-1, 3) | anything, **damping}
)
oscillators = st.tuples(st.just(Isolator), isolators) | st.tuples(st.just(Duffing), duffings)
windows = st.tuples(numbers, numbers) | st.sampled_from([(0.0, 2.0), (0.5, 1.5), None, (1.0,), (2.0, 1.0)])
samples = st.sampled_from([2, 10, 300, 1, 0, -3, 2.5, "many"])
questions = st.one_of(
    *(st.tuples(st.just(name), st.just(()), st.just({})) for name in ("saddle_node_onset", "detachment")),
    *(
        st.tuples(st.just(name), st.tuples(anything), st.just({}))
        for name in ("peak", "saddle_nodes", "backbone", "margins", "hysteresis", "isolation")
    ),
    st.tuples(
        st.just("frequency_response"),
        st.tuples(anything),
        st.fixed_dictionaries({"Omega": windows, "samples": samples}),
    ),
    *(
        st.tuples(st.just(name), st.just(()), st.fixed_dictionaries({"Omega": anything, "F_0": anything}))
        for name in ("amplitudes", "limit_envelope", "spectrum")
    ),
    *(
        st.tuples(st.just(name), st.just(()), st.fixed_dictionaries({"Omega": anything, "A": anything}))
        for name in ("stability", "equivalent_damping")
    ),
    st.tuples(st.just("fold_locus"), st.just(()), st.fixed_dictionaries({"A_max": anything, "samples": samples})),
    *(
        st.tuples(st.just(name), st.just(()), st.fixed_dictionaries({"A_max": anything}))
        for name in ("cusps", "isola_points")
    ),
    st.tuples(st.just("certify"), st.tuples(anything), st.fixed_dictionaries({"Omega": anything})),
    st.tuples(st.just("explain"), st.tuples(st.just("saddle_nodes"), anything), st.just({})),
)
#: a data sheet in SI units, and its questions: forces, frequencies
sheets = st.fixed_dictionaries(
    {
        "m": st.floats(0.1, 100) | anything,
        "k_v": st.floats(10, 1e5) | anything,
        "k_h": st.floats(10, 1e5) | anything,
        "L": st.floats(0.01, 1) | anything,
        "preload": st.floats(0, 0.01) | anything,
        "friction": st.floats(0, 1) | anything,
        "zeta": st.floats(0, 0.2) | anything,
        "load": st.none() | anything,
    }
)
physical = st.one_of(
    *(st.tuples(st.just(name), st.just(()), st.just({})) for name in ("at_rest", "saddle_node_onset", "detachment")),
    *(
        st.tuples(st.just(name), st.tuples(anything), st.just({}))
        for name in ("peak", "saddle_nodes", "margins", "hysteresis", "isolation", "force", "backbone", "sag")
    ),
    *(
        st.tuples(st.just(name), st.just(()), st.fixed_dictionaries({"f": anything, "F": anything}))
        for name in ("amplitudes", "limit_envelope", "spectrum")
    ),
    st.tuples(
        st.just("frequency_response"), st.tuples(anything), st.fixed_dictionaries({"f": windows, "samples": samples})
    ),
)
#: of the second approximation
second = st.one_of(
    *(st.tuples(st.just(name), st.just(()), st.just({})) for name in ("saddle_node_onset", "detachment")),
    *(st.tuples(st.just(name), st.tuples(anything), st.just({})) for name in ("peak", "saddle_nodes")),
    st.tuples(
        st.just("frequency_response"),
        st.tuples(anything),
        st.fixed_dictionaries({"Omega": windows, "samples": samples}),
    ),
    st.tuples(st.just("amplitudes"), st.just(()), st.fixed_dictionaries({"Omega": anything, "F_0": anything})),
)
#: of batches: their parameters are arrays of what single oscillators take
columns = st.lists(numbers, min_size=0, max_size=4) | anything
batches = st.fixed_dictionaries({name: columns for name in ("lam", "r", "delta_h", "mu", "zeta")})
of_batches = st.one_of(
    *(st.tuples(st.just(name), st.just(()), st.just({})) for name in ("saddle_node_onset", "detachment")),
    *(
        st.tuples(st.just(name), st.tuples(columns), st.just({}))
        for name in ("peak", "saddle_nodes", "certify", "margins", "hysteresis", "isolation")
    ),
    st.tuples(st.just("amplitudes"), st.just(()), st.fixed_dictionaries({"Omega": columns, "F_0": columns})),
    st.tuples(st.just("frequency_response"), st.tuples(columns), st.just({"samples": 5})),
)
#: motions of the equation itself, each of them a second at most
motions = st.tuples(st.just("steady_state"), st.just(()), st.fixed_dictionaries({"Omega": anything, "F_0": anything}))
#: refusals: each has words
REFUSED = (ValueError, TypeError, ArithmeticError)


def undefined(value):
    """Whether there is a NaN in it."""
    return isinstance(value, (float, np.ndarray)) and np.asarray(value).dtype.kind == "f" and np.isnan(value).any()


def asked_all(make, asked):
    """Everything that is asked of what is made is answered, or refused in words, without a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # meant for the user
        warnings.filterwarnings("ignore", message=".*negative stiffness at rest")
        warnings.simplefilter("ignore", Implausible)
        try:
            oscillator = make()
        except REFUSED as refusal:
            assert str(refusal)
            return
        for name, arguments, named in asked:
            try:
                answer = getattr(oscillator, name)(*arguments, **named)
            except REFUSED as refusal:
                assert str(refusal)
                continue
            found = [value for value in vars(answer).values() if undefined(value)] if hasattr(answer, "message") else []
            assert not found or answer.message


@pytest.mark.both_backends
@settings(max_examples=300, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(oscillators, st.lists(questions, min_size=1, max_size=3))
def test_an_answer_or_a_refusal_in_words(made, asked):
    kind, parameters = made
    asked_all(lambda: kind(**parameters), asked)


@settings(max_examples=150, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(oscillators, st.lists(second, min_size=1, max_size=2))
def test_the_second_approximation_answers_or_refuses_in_words(made, asked):
    kind, parameters = made
    asked_all(lambda: kind(**parameters).second_approximation, asked)


@settings(max_examples=60, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(oscillators, st.lists(motions, min_size=1, max_size=2))
def test_an_exact_motion_is_answered_or_refused_in_words(made, asked):
    kind, parameters = made
    asked_all(lambda: kind(**parameters), asked)


@pytest.mark.both_backends
@settings(max_examples=150, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(batches, st.lists(of_batches, min_size=1, max_size=2))
def test_a_batch_has_numbers_or_a_status(given_numbers, asked):
    """No NaN where the status says that there is an answer, and no answer that is none of the right sign."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name, arguments, named in asked:
            try:
                found = getattr(Isolator.many(**given_numbers), name)(*arguments, **named)
            except REFUSED as refusal:
                assert str(refusal)
                continue
            answered = np.asarray(found.status) == Status.OK
            for column in ("F_cr", "F_SN", "A", "Omega", "Omega_cr"):
                values = np.asarray(getattr(found, column, 0.0))
                if values.shape == answered.shape:
                    assert (values[answered] >= 0).all()


SCENE = (Path(__file__).parents[1] / "scenes" / "table_1.toml").read_text(encoding="utf-8")
VALUES = st.one_of(
    numbers.map(repr),
    st.sampled_from(["nan", "inf", "-1", "'x'", "[]", "{}", "true", "1e400", "1979-05-27", "[1, 'a']", "1e-400", ""]),
)


@pytest.mark.slow
@settings(max_examples=150, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(st.integers(0, 6), VALUES)
def test_a_scene_with_any_value_is_answered_or_refused_in_words(place, value):
    """The file of Table 1 with one of its values replaced: an exit code and words, and no traceback."""
    lines = SCENE.splitlines()
    stated = [k for k, line in enumerate(lines) if "=" in line and not line.startswith("#")]
    k = stated[place % len(stated)]
    lines[k] = f"{lines[k].partition('=')[0]}= {value}"
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", message=".*negative stiffness at rest")
        file = Path(folder) / "scene.toml"
        file.write_text("\n".join(lines), encoding="utf-8")
        said, words = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(words):
            code = cli.main(["run", str(file), "--quiet"])
        assert code in (0, 1, 2)
        assert code == 0 or words.getvalue().strip()


@settings(max_examples=100, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@example(1.7e308, 1.0, 1.0, "mu")
@example(0.0, 1.0, 1e-160, "mu")
@example(0.0, 1.0, 5e-324, "mu")
@given(anything, anything, anything, st.sampled_from(["mu", "zeta", "r", "delta_h", "what"]))
def test_sizing_is_answered_or_refused_in_words(part, F_0, bound, name):
    isolator = Isolator(lam=3, r=2, delta_h=0.1, mu=0.01, zeta=0.02)
    asked = (
        lambda: sizing.tolerances(isolator, {name: part}, F_0=F_0, samples=20),
        lambda: sizing.meet(isolator, {name: (part, bound)}, at_least={"F_SN": bound}, F_0=F_0),
        lambda: sizing.fit(isolator, Omega=[0.8, 0.9, bound], A=[0.1, part, 0.2], F_0=F_0, free=[name]),
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", message=".*negative stiffness at rest")
        for ask in asked:
            try:
                answer = ask()
            except REFUSED as refusal:
                assert str(refusal)
            else:
                assert answer is not None


@pytest.mark.slow
@settings(max_examples=300, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(sheets, st.lists(physical, min_size=1, max_size=3))
def test_a_data_sheet_is_answered_or_refused_in_words(sheet, asked):
    asked_all(lambda: Isolator.physical(**sheet), asked)
