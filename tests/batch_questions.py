"""Every question about many designs, by name, as a function of designs or one of them and a forcing."""

from __future__ import annotations

from typing import Any

import numpy as np

#: frequency of states, frequencies of a load spectrum
OMEGA, ROWS = 0.9, (0.8, 1.1)
#: a base's acceleration at times
TAU, PULSE = np.array([0.0, 0.4, 1.1, 1.3, 2.5, 4.0]), np.array([0.0, 1.0, 0.3, -0.4, 0.7, 0.0])


def _at(F_0: Any) -> dict[str, dict[str, Any]]:
    """What each question takes at a forcing, which has the shape of the designs; rows are an axis more."""
    rows = F_0[..., None] if hasattr(F_0, "ndim") and F_0.ndim else F_0
    return {
        "detachment": {},
        "saddle_node_onset": {},
        "at_rest": {},
        "rest": {},
        "saddle_nodes": {"F_0": F_0},
        "peak": {"F_0": F_0},
        "amplitudes": {"Omega": OMEGA, "F_0": F_0},
        "frequency_response": {"F_0": F_0, "samples": 30},
        "certify": {"F_0": F_0},
        "margins": {"F_0": F_0},
        "hysteresis": {"F_0": F_0},
        "isolation": {"F_0": F_0},
        "spectrum": {"Omega": ROWS, "F_0": rows},
        "transient": {"acceleration": F_0, "duration": 2.0},
        "shock_spectrum": {"acceleration": F_0, "duration": 2.0},
        "random": {"S_0": 0.01 * F_0},
        "isolation at a level": {"F_0": F_0, "level_dB": -7.0},
        "transient of a record": {"acceleration": 5 * rows * PULSE, "tau": TAU, "after": 3.0},
    }


#: of designs about the centre
AVERAGED = tuple(name for name in _at(1.0) if name != "rest")
#: of these in the second approximation
SECOND = ("detachment", "saddle_node_onset", "saddle_nodes", "amplitudes", "frequency_response", "peak")
#: of designs under a load
OFF_CENTRE = tuple(name for name in _at(1.0) if name not in ("at_rest", "certify", "random"))
#: those of designs about the centre, at both depths
ALL = (*AVERAGED, *(f"second_approximation.{name}" for name in SECOND))


def ask(of: Any, question: str, F_0: Any, **more: Any) -> Any:
    """The answer of designs, or of one of them, to a question of one of these lists."""
    depth, _, name = question.rpartition(".")
    return getattr(getattr(of, depth) if depth else of, name.split()[0])(**{**_at(F_0)[name], **more})


def columns(answer: Any) -> dict[str, Any]:
    """Of a batch's answer."""
    return {name: value for name, value in answer._content().items()}
