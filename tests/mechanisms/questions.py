"""Every question put to a bilinear spring, in a project that was given its file.

In:  the generated record `bilinear`.
Out: which solvers answered; each answer is held against that of the same spring derived at run time, which is held
     against certified values (`test_certified_cases.py`) and SciPy's motions (`test_library.py`).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from slowflow import SlowflowError, derive
from slowflow.oscillators.oscillator import Oscillator
from slowflow_kernels import bilinear
from tests.batch_questions import ALL, ask
from tests.corpus.record import fields

F_0 = 0.06
DESIGN = {"kappa": 9.0, "delta": 0.2, "mu": 0.01, "zeta": 0.03}
#: two of which are none
DESIGNS = DESIGN | {"kappa": [9.0, -1.0, 1.0, 0.4], "delta": [0.2, 0.2, -1.0, 0.2]}
UP = np.linspace(0.8, 2.3, 12)
#: those about one design alone
SINGLE: dict[str, Callable[[Any], Any]] = {
    "force": lambda of: of.force(np.array([-0.5, -0.2, -0.1, 0.0, 0.1, 0.5])),
    "backbone": lambda of: of.backbone(np.array([0.05, 0.2, 0.21, 0.3, 5.0])),
    "fold_locus": lambda of: of.fold_locus(A_max=2.0),
    "cusps": lambda of: of.cusps(A_max=2.0),
    "isola_points": lambda of: of.isola_points(A_max=2.0),
    "steady_state": lambda of: of.steady_state(Omega=1.9, F_0=F_0, A=0.35),
    "exact_response": lambda of: of.exact_response(F_0, Omega=(1.0, 2.2), step=0.05),
    "sweep": lambda of: of.sweep(Omega=[*UP, *UP[::-1]], F_0=F_0),
}


def answered(question: Callable[[Any], Any], of: Any) -> dict[str, Any]:
    """Each number, array and text of the answer by its name, or the refusal.

    Without the bits of proofs, which one has by balls, the other by intervals, and what both say next to the kink.
    """
    try:
        return {name: value for name, value in fields(question(of)) if not name.endswith(("bits", ".message"))}
    except SlowflowError as refusal:
        return {"refusal": type(refusal).__name__}


def compare(questions: dict[str, Callable[[Any], Any]], of_file: Any, derived: Any) -> None:
    """Assert that both answer them alike, but for the order in which they round."""
    refused = set()
    for name, question in questions.items():
        found, expected = (answered(question, of) for of in (of_file, derived))
        assert found.keys() == expected.keys(), name
        refused |= {name} if "refusal" in found else set()
        for column, value in found.items():
            if np.asarray(value).dtype.kind in "biufc":
                np.testing.assert_allclose(value, expected[column], rtol=1e-9, err_msg=f"{name} {column}")
            else:
                assert np.array_equal(value, expected[column]), (name, column)
    assert len(refused) < len(questions) / 4, refused


if __name__ == "__main__":
    spring, derived = Oscillator(bilinear.MECHANISM, **DESIGN), derive.library("bilinear")
    about_all = {question: partial(ask, question=question, F_0=F_0) for question in ALL}
    compare(about_all | SINGLE, spring, derived(**DESIGN))
    about_all = {question: partial(ask, question=question, F_0=np.full(4, F_0)) for question in ALL}
    compare(about_all, Oscillator.many(bilinear.MECHANISM, **DESIGNS), derived.many(**DESIGNS))
    print("compiled" if spring.model.native is not None else "NumPy")
