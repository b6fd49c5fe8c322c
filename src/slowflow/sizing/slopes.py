"""How an answer moves with the numbers of a design: in goes a subject and its numbers, out come slopes by name.

By the gradients of averaged answers, of a mount in its own terms.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np

from slowflow.gradient import Gradient
from slowflow.isolator import Isolator
from slowflow.model import OF_DAMPING
from slowflow.physical import Physical
from slowflow.sizing.subject import LAWS, OF_MARGINS, STATIC, Load, Subject
from slowflow_kernels.conventions import MovesStatus


def slopes(subject: Subject, numbers: Mapping[str, float], answer: str, load: Load) -> dict[str, float] | None:
    """d(answer)/d(number) by name, of the design with these numbers and else nominal ones; None where none is known.

    By eta and c_2 too, of a design that has one of these or rubs="attached".

    answer -- as `slowflow.sizing` lists them: of F_SN, F_cr, their margins, A_peak, and frequencies at rest, of peaks
              and of jumps
    """
    with warnings.catch_warnings():  # what there is to say of a design is said of the one that is found
        warnings.simplefilter("ignore")
        of = subject.of.replace(**numbers)
    plain, over = subject.answers[answer], 1.0
    if plain in OF_MARGINS and load.forcing is not None:
        plain, over = f"F_{plain[3:]}", load.forcing
        answer = next(name for name, one in subject.answers.items() if one == plain)
    name = answer if plain in ("F_SN", "F_cr") else "A" if plain == "A_peak" else "f" if subject.mount else "Omega"
    found = _moves(of, plain, load.forcing)
    if found is None:
        return None
    gradient, k = found
    if gradient.status[k]:
        return None
    by = dict(zip(gradient.by, (gradient[name][k] / over).tolist(), strict=True))
    by |= {name: 0.0 for name in ("mu_s", STATIC) if name in subject.nominal}  # averaging does not ask for it
    return {number: by[number] for number in subject.nominal if number in by}


def _moves(of: Any, answer: str, F: float | None) -> tuple[Gradient, Any] | None:
    """A gradient of an isolator or a mount, and which entry of it; None where none is known."""
    if answer == "rest":
        at_rest = _at_rest(of.oscillator if isinstance(of, Physical) else of)
        if at_rest is None:
            return None
        return of.scales.gradient(at_rest) if isinstance(of, Physical) else at_rest, ()
    if answer == "F_SN":
        return of.saddle_node_onset().gradient(), ()
    if answer == "F_cr":
        return of.detachment().gradient(), ()
    if F is None or answer not in ("A_peak", "peak", "jump_up", "jump_down"):
        return None
    if answer in ("A_peak", "peak"):
        return of.peak(F).gradient(), ()
    folds = of.saddle_nodes(F)
    chosen = [k for k, fold in enumerate(folds) if fold.kind == answer.replace("_", "-")]
    return (folds.gradient(), chosen[0] if answer == "jump_up" else chosen[-1]) if chosen else None


def _at_rest(isolator: Isolator) -> Gradient | None:
    """Of the natural frequency sqrt(-h_A) at A = 0."""
    mechanism, parameters = isolator.model.mechanism, isolator.model.parameters
    averaged = [float(value) for value in mechanism.averaged(0.0, *parameters)[:3]]
    if mechanism.by_parameter is None or mechanism.by_design is None or not averaged[1] < 0:
        return None
    by_parameter = np.array(mechanism.by_parameter(0.0, *averaged, *parameters)).reshape(-1, 3)[:, 1]
    by_design = np.array(mechanism.by_design(*isolator.design)).reshape(-1, len(isolator.design))
    frequency = math.sqrt(-averaged[1])
    moved = -by_parameter @ by_design[: len(parameters)] / (2 * frequency)
    damping = (*OF_DAMPING, *(LAWS if isolator.model.laws.any else ()))
    slopes = np.array([[*moved, *(0.0 for _ in damping)]])
    status = np.array(int(MovesStatus.OK), dtype=np.int8)
    numbers = (*isolator.design, *(getattr(isolator, name) for name in damping))
    return Gradient(("Omega",), (*mechanism.design_names, *damping), slopes, status, (frequency,), numbers)
