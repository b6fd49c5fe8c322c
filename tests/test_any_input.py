"""Whatever is asked of an oscillator: an answer, or a refusal in words; no NaN without one, no warning, no crash."""

from __future__ import annotations

import math
import warnings

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from slowflow import Duffing, Isolator

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
#: refusals: each has words
REFUSED = (ValueError, TypeError, ArithmeticError)


def undefined(value):
    """Whether there is a NaN in it."""
    return isinstance(value, (float, np.ndarray)) and np.asarray(value).dtype.kind == "f" and np.isnan(value).any()


def asked_all(make, asked):
    """Everything that is asked of what is made is answered, or refused in words, without a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", message=".*negative stiffness at rest")  # meant for the user
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


@settings(max_examples=300, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow])
@given(sheets, st.lists(physical, min_size=1, max_size=3))
def test_a_data_sheet_is_answered_or_refused_in_words(sheet, asked):
    asked_all(lambda: Isolator.physical(**sheet), asked)
