"""How an answer moves with the numbers of a design: in goes a subject and its numbers, out come slopes by name.

By the gradients of averaged answers; a mount's numbers also change what its answers and its numbers are measured in,
which are products of powers (4).
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np

from slowflow.gradient import Gradient
from slowflow.isolator import ROD_SPRING, Isolator
from slowflow.physical import Physical, size
from slowflow.sizing.subject import KIND, WORDS, Load, Subject
from slowflow_kernels.domains import DAMPING
from slowflow_kernels.scaling import AMPLITUDES, SCALES

#: which scale a kind of answer is measured in
SCALE_OF = {"amplitude": "F_0", "length": "u", "frequency": "Omega"}
#: the base of all scales, in the order of their powers
BASE = ("k_v", "L", "m")


def slopes(subject: Subject, numbers: Mapping[str, float], answer: str, load: Load) -> dict[str, float] | None:
    """d(answer)/d(number) by name, of the design with these numbers and else nominal ones; None where none is known.

    answer -- as `slowflow.sizing` lists them: of F_SN, F_cr, A_peak, frequencies at rest, of peaks and of jumps
    """
    with warnings.catch_warnings():  # what there is to say of a design is said of the one that is found
        warnings.simplefilter("ignore")
        of = subject.of.replace(**numbers)
    isolator, mount = (of.oscillator, of) if isinstance(of, Physical) else (of, None)
    base = {} if mount is None else {name: getattr(mount.scales, name) for name in BASE}
    forcing = load.forcing
    measured = SCALES | {"F_0": AMPLITUDES[subject.excitation]}
    if forcing is not None and mount is not None:
        forcing /= size(measured["F_0"], **base)
    found = _moves(isolator, subject.answers[answer], forcing)
    if found is None:
        return None
    value, by = found
    if mount is None:
        return {name: slope for name, slope in by.items() if name != "F_0"}
    # the answer over what it is measured in, and each number over its own: all powers of the base
    kind = KIND[subject.answers[answer]]
    unit = subject.ask(numbers, [answer], load)[answer] / value
    powers = dict(zip(BASE, measured[SCALE_OF[kind]].powers, strict=True))
    moved = {name: value * powers[name] / base[name] for name in BASE}
    scales = dict(zip((one.name for one in ROD_SPRING.design), ROD_SPRING.scales, strict=True))
    scales |= {name: measured[name] for name in (*(one.name for one in DAMPING), "F_0")}
    result = {}
    for name, slope in by.items():
        scale = scales[name]
        if scale.letter == "c" and "zeta" in subject.nominal:
            result["zeta"] = slope * unit
            continue
        at = (forcing or 0.0) if name == "F_0" else float(getattr(isolator, name))
        for one, power in zip(BASE, scale.powers, strict=True):
            moved[one] -= slope * at * power / base[one]
        if name != "F_0":
            result[WORDS[scale.letter]] = slope * unit / size(scale, **base)
    return {name: float(slope) for name, slope in (result | {one: moved[one] * unit for one in BASE}).items()}


def _moves(isolator: Isolator, answer: str, F_0: float | None) -> tuple[float, dict[str, float]] | None:
    """The dimensionless answer, and its slopes by the parameters and F_0; None where none is known."""
    if answer in ("F_SN", "F_cr"):
        found: Any = isolator.saddle_node_onset() if answer == "F_SN" else isolator.detachment()
        return _first(found.gradient(), answer, getattr(found, answer))
    if answer == "rest":
        return _at_rest(isolator)
    if F_0 is None or answer not in ("A_peak", "peak", "jump_up", "jump_down"):
        return None
    if answer in ("A_peak", "peak"):
        peak, name = isolator.peak(F_0), "A" if answer == "A_peak" else "Omega"
        return _first(peak.gradient(), name, getattr(peak, name))
    folds = isolator.saddle_nodes(F_0)
    chosen = [k for k, fold in enumerate(folds) if fold.kind == answer.replace("_", "-")]
    if not chosen:
        return None
    k = chosen[0] if answer == "jump_up" else chosen[-1]
    moves = folds.gradient()
    if moves.status[k]:
        return None
    return float(folds.Omega[k]), dict(zip(moves.by, moves["Omega"][k].tolist(), strict=True))


def _at_rest(isolator: Isolator) -> tuple[float, dict[str, float]] | None:
    """The natural frequency sqrt(-h_A) at A = 0, and its slopes."""
    mechanism, parameters = isolator.model.mechanism, isolator.model.parameters
    averaged = [float(value) for value in mechanism.averaged(0.0, *parameters)[:3]]
    if mechanism.by_parameter is None or mechanism.by_design is None or not averaged[1] < 0:
        return None
    by_parameter = np.array(mechanism.by_parameter(0.0, *averaged, *parameters)).reshape(-1, 3)[:, 1]
    by_design = np.array(mechanism.by_design(*isolator.design)).reshape(-1, len(isolator.design))
    frequency = math.sqrt(-averaged[1])
    moved = -by_parameter @ by_design[: len(parameters)] / (2 * frequency)
    names = (one.name for one in mechanism.design)
    return frequency, dict(zip(names, moved.tolist(), strict=True)) | {one.name: 0.0 for one in DAMPING}


def _first(moves: Gradient, name: str, value: float | None) -> tuple[float, dict[str, float]] | None:
    if value is None or moves.status:
        return None
    return value, dict(zip(moves.by, moves[name].tolist(), strict=True))
