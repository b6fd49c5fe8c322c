"""What the page knows of the mechanisms, units and measured errors: in go the package's records, out comes plain data.

Nothing here is typed that a record has: names, domains, scales and words come from the derivation, errors from the
measurements. Only the designs that the page opens with are chosen.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any

from slowflow import Duffing, Isolator
from slowflow.averaged import words
from slowflow.averaged.remarks import NEAR_STICKING_BELOW, WORDS
from slowflow.isolator import ROD_SPRING
from slowflow.measured import table, validity
from slowflow.oscillator import Oscillator
from slowflow.paper.example import TABLE_1
from slowflow.physical import Physical
from slowflow.validate import WINDOW
from slowflow.version import __version__
from slowflow_kernels.conventions import OnsetKind, Status
from slowflow_kernels.domains import DAMPING, EXCITATIONS
from slowflow_kernels.scaling import AMPLITUDES, SCALES
from slowflow_support.record import Mechanism, Parameter

#: designs to begin with: a title, an oscillator, F_0, and the highest frequency that is shown
PRESETS: tuple[tuple[str, Oscillator, float, float], ...] = (
    ("Table 1 of the paper", Isolator(**TABLE_1), 0.04, WINDOW[1]),
    ("Table 1, force not truncated", Isolator(**TABLE_1, force="untruncated"), 0.04, WINDOW[1]),
    ("Springs leave early", Isolator(lam=3, r=2.0, delta_h=0.03, mu=0.003, zeta=0.02), 0.03, WINDOW[1]),
    ("Frictionless", Isolator(**{**TABLE_1, "mu": 0.0}), 0.03, WINDOW[1]),
    ("Hardening Duffing", Duffing(alpha=1.0, beta=4.0, mu=0.01, zeta=0.03), 0.06, 2.5),
    ("Softening Duffing", Duffing(alpha=1.0, beta=-0.5, mu=0.01, zeta=0.05), 0.1, WINDOW[1]),
    ("A floor that shakes", Isolator(**{**TABLE_1, "zeta": 0.05}, excitation="base"), 0.06, WINDOW[1]),
    ("A machine out of balance", Isolator(**{**TABLE_1, "zeta": 0.05}, excitation="unbalance"), 0.05, WINDOW[1]),
)
#: what excites, in the page's words
EXCITED_BY = {"force": "a force", "base": "a base that shakes", "unbalance": "an unbalance"}
#: the mount of the README, in SI units
MOUNT: Physical = Isolator.physical(
    m=12.0, k_v=2500.0, k_h=1700.0, n=3, L=0.080, preload=0.009, friction=0.4, zeta=0.02
)
MOUNT_FORCE = 5.0
#: what `Isolator.physical` calls the numbers that have another name without dimensions
PHYSICAL_NAMES = {"lam": "n", "r": "k_h", "delta_h": "preload", "mu": "friction", "F_0": "F", "Omega": "f"}

#: where the page compares itself: points of the curve, and a frequency as a share of the highest that is shown
REFERENCE_SAMPLES = 200
REFERENCE_AT = 0.45


def about() -> dict[str, Any]:
    """All of it, for JSON: lists, numbers and words."""
    mechanisms: dict[str, Any] = {}
    for _, oscillator, _, _ in PRESETS:
        record = oscillator.model.mechanism
        if record.name not in mechanisms:
            mechanisms[record.name] = _mechanism(record, oscillator)
    return {
        "version": __version__,
        "mechanisms": mechanisms,
        "damping": [_parameter(one) for one in DAMPING],
        "excitations": {
            name: {"title": title, **_parameter(EXCITATIONS[name]), "scale": dict(AMPLITUDES[name]._asdict())}
            for name, title in EXCITED_BY.items()
        },
        "scales": {name: dict(scale._asdict()) for name, scale in SCALES.items()},
        "physical_names": PHYSICAL_NAMES,
        "presets": [
            {
                "title": title,
                "mechanism": one.model.mechanism.name,
                "excitation": one.excitation,
                "values": _values(one, F_0),
                "shown": high,
            }
            for title, one, F_0, high in PRESETS
        ],
        "mount": _mount(),
        "status": {status.name: status.value for status in Status},
        "onset_kinds": {kind.value: kind.name.lower() for kind in OnsetKind},
        "words": {
            "remarks": {remark.name: text for remark, text in WORDS.items()},
            **{name: getattr(words, name) for name in ("NO_ONSET", "NO_DETACHMENT", "NO_PEAK", "NO_LOWEST")},
            "near_sticking": validity.NEAR_STICKING,
            "near_sticking_below": NEAR_STICKING_BELOW,
            "off_by": validity.OFF_BY,
            "off_unknown": validity.OFF_UNKNOWN,
            "not_measured": validity.NOT_MEASURED,
        },
        "references": [_reference(one, F_0, high) for _, one, F_0, high in PRESETS],
        "measured": {name: getattr(table, name) for name in dir(table) if name.isupper()},
        "worth": {"error": validity.WORTH, "truncation": validity.WORTH_TRUNCATION},
    }


def _mechanism(record: Mechanism, example: Oscillator) -> dict[str, Any]:
    """A record without its functions, how Python makes such an oscillator, and whether it moves a push-rod."""
    return {
        "title": record.title,
        "design": [_parameter(one) for one in record.design],
        "scales": [dict(scale._asdict()) for scale in record.scales],
        "reach": record.reach if math.isfinite(record.reach) else None,
        "reach_reason": record.reach_reason,
        "truncated": record.truncated,
        "constructor": type(example).__name__,
        "words": {name: value for name, value in example.given.items() if value == "untruncated"},
        "physical": hasattr(type(example), "physical"),
        "rod": record.design == ROD_SPRING.design,
    }


def _parameter(one: Parameter) -> dict[str, Any]:
    return {name: value for name, value in dataclasses.asdict(one).items() if value is not None}


def _values(one: Oscillator, F_0: float) -> dict[str, float]:
    design = zip((number.name for number in one.model.mechanism.design), one.model.design, strict=True)
    return {**dict(design), "mu": one.mu, "zeta": one.zeta, "F_0": F_0}


def _mount() -> dict[str, Any]:
    """The mount: m, k_v and L, and its other numbers in SI units, by the names that they have without dimensions."""
    given, scales = MOUNT.given, MOUNT.scales
    names = [number.name for number in (*MOUNT.oscillator.model.mechanism.design, *DAMPING)]
    values = {name: given[PHYSICAL_NAMES.get(name, name)] for name in names}
    return {
        "title": "The mount of the README",
        "mechanism": MOUNT.oscillator.model.mechanism.name,
        "excitation": MOUNT.oscillator.excitation,
        "base": {"m": scales.m, "k_v": scales.k_v, "L": scales.L},
        "values": {**values, "F_0": MOUNT_FORCE},
    }


def _reference(one: Oscillator, F_0: float, high: float) -> dict[str, Any]:
    """What this package answers for a design, for the page to compare itself with."""
    onset, off, folds = one.saddle_node_onset(), one.detachment(), one.saddle_nodes(F_0)
    Omega = REFERENCE_AT * high
    return {
        "mechanism": one.model.mechanism.name,
        "excitation": one.excitation,
        "numbers": [*one.model.design, one.mu, one.zeta],
        "F_0": F_0,
        "high": high,
        "samples": REFERENCE_SAMPLES,
        "onset": None if onset.F_SN is None else [onset.F_SN, onset.Omega, onset.A],
        "detachment": None if off.F_cr is None else [off.F_cr, off.Omega_cr],
        "folds": {"Omega": folds.Omega.tolist(), "A": folds.A.tolist()},
        "points": len(one.frequency_response(F_0, Omega=(0.0, high), samples=REFERENCE_SAMPLES)),
        "Omega": Omega,
        "states": one.amplitudes(Omega=Omega, F_0=F_0).A.tolist(),
    }
