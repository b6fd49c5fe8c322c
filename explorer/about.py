"""What the page knows of the mechanisms, units and measured errors. Takes the package's records; returns plain data.

Nothing here is typed that a record has: names, domains, scales and words come from the derivation, errors from the
measurements. Only the designs that the page opens with are chosen.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any, NamedTuple

from slowflow import Duffing, Isolator, derive
from slowflow.answers import validity
from slowflow.answers import validity_table as table
from slowflow.answers.quantities import DENSITIES, OF_KIND, Scales
from slowflow.answers.table import COLUMNS
from slowflow.averaged.diagnostics import MESSAGES, NEAR_STICKING_BELOW
from slowflow.averaged.messages import STICKS, STICKS_BELOW
from slowflow.core.validate import WINDOW
from slowflow.example import TABLE_1
from slowflow.oscillators.isolator import ROD_SPRING
from slowflow.oscillators.oscillator import Oscillator
from slowflow.oscillators.physical import Physical
from slowflow.support.record import Parameter
from slowflow.support.text import Sentence, in_units, text
from slowflow.version import __version__
from slowflow_kernels.conventions import OnsetKind, Status
from slowflow_kernels.domains import DAMPING, EXCITATIONS
from slowflow_kernels.scaling import AMPLITUDES, SCALES

#: designs to begin with: a title, an oscillator, F_0, and the highest frequency that is shown
PRESETS: tuple[tuple[str, Oscillator, float, float], ...] = (
    ("Table 1 of the paper", Isolator(**TABLE_1), 0.04, WINDOW[1]),
    ("Table 1, force not truncated", Isolator(**TABLE_1, force="untruncated"), 0.04, WINDOW[1]),
    ("Springs detach early", Isolator(lam=3, r=2.0, delta_h=0.03, mu=0.003, zeta=0.02), 0.03, WINDOW[1]),
    ("Frictionless", Isolator(**{**TABLE_1, "mu": 0.0}), 0.03, WINDOW[1]),
    ("Hardening Duffing", Duffing(alpha=1.0, beta=4.0, mu=0.01, zeta=0.03), 0.06, 2.5),
    ("Softening Duffing", Duffing(alpha=1.0, beta=-0.5, mu=0.01, zeta=0.05), 0.1, WINDOW[1]),
    ("Base excitation", Isolator(**{**TABLE_1, "zeta": 0.05}, excitation="base"), 0.06, WINDOW[1]),
    ("Rotating unbalance", Isolator(**{**TABLE_1, "zeta": 0.05}, excitation="unbalance"), 0.05, WINDOW[1]),
)
#: those of the library: a title, its name there, its numbers, F_0, and the highest frequency that is shown
LIBRARY: tuple[tuple[str, str, Mapping[str, float], float, float], ...] = (
    ("Elastic stops", "elastic_stop", {"kappa": 8.0, "delta": 0.2, "mu": 0.005, "zeta": 0.03}, 0.05, 2.5),
    ("One-sided stop", "one_sided_stop", {"kappa": 8.0, "delta": 0.2, "mu": 0.005, "zeta": 0.03}, 0.05, 2.0),
    ("Bilinear spring", "bilinear", {"kappa": 0.4, "delta": 0.2, "mu": 0.005, "zeta": 0.03}, 0.05, WINDOW[1]),
    ("Dead zone", "dead_zone", {"delta": 0.2, "mu": 0.005, "zeta": 0.05}, 0.05, WINDOW[1]),
    ("Three springs", "three_spring", {"alpha": 1.0, "ell": 1.5, "mu": 0.0, "zeta": 0.03}, 0.006, WINDOW[1]),
    ("Cams and rollers", "cam_roller", {"r": 0.8, "rho": 0.8, "c": 0.1, "mu": 0.003, "zeta": 0.03}, 0.04, WINDOW[1]),
)
#: kinds of excitation, as the page names them
EXCITED_BY = {
    "force": "force",
    "base": "base displacement",
    "acceleration": "base acceleration",
    "unbalance": "rotating unbalance",
}
#: the mount of the README, in SI units
MOUNT: Physical = Isolator.physical(
    m=12.0, k_v=2500.0, k_h=1700.0, n=3, L=0.080, preload=0.009, friction=0.4, zeta=0.02
)
MOUNT_FORCE = 5.0
#: where the mass stops within the cycle, in the letters of dimensionless answers
STOPS = text("friction stops the mass: {mu/(A Omega^2)|friction/(m A omega^2)} > 1")
#: what `Isolator.physical` calls the numbers that have another name without dimensions
PHYSICAL_NAMES = {"lam": "n", "r": "k_h", "delta_h": "preload", "mu": "friction", "F_0": "F", "Omega": "f"}

#: places of numbers in its words, by name
PLACEHOLDERS = {"reach": "{reach:g}", "held": "{held:g}"}
#: where the page compares itself: points of the curve, and a frequency as a share of the highest that is shown
REFERENCE_SAMPLES = 200
REFERENCE_AT = 0.45


class Design(NamedTuple):
    """A design to begin with; the mechanism as the page calls it, and what makes such an oscillator in Python."""

    title: str
    mechanism: str
    constructor: str
    oscillator: Oscillator
    F_0: float
    shown: float


def designs() -> list[Design]:
    """The package's, then the library's; these are derived and compiled."""
    found = [
        Design(title, one.model.mechanism.name, type(one).__name__, one, F_0, high) for title, one, F_0, high in PRESETS
    ]
    for title, name, numbers, F_0, high in LIBRARY:
        made = derive.library(name, compile=True)(**numbers)
        found.append(Design(title, name, f'derive.library("{name}")', made, F_0, high))
    return found


def about() -> dict[str, Any]:
    """All of it, for JSON: lists, numbers and words."""
    presets = designs()
    mechanisms: dict[str, Any] = {}
    for one in presets:
        if one.mechanism not in mechanisms:
            mechanisms[one.mechanism] = _mechanism(one)
    return {
        "version": __version__,
        "mechanisms": mechanisms,
        "damping": [_parameter(one) for one in DAMPING],
        "density": {"g": DENSITIES["g^2/Hz"][0], "most": 40},
        "excitations": {name: _excitation(name, title) for name, title in EXCITED_BY.items()},
        "scales": {name: dict(scale._asdict()) for name, scale in SCALES.items()},
        "physical_names": PHYSICAL_NAMES,
        "names": {name: COLUMNS[name].si for name in ("Omega", "u_cr")},
        "presets": [
            {
                "title": one.title,
                "mechanism": one.mechanism,
                "excitation": one.oscillator.excitation,
                "values": _values(one.oscillator, one.F_0),
                "shown": one.shown,
            }
            for one in presets
        ],
        "mount": _mount(),
        "status": {status.name: status.value for status in Status},
        "onset_kinds": {kind.value: kind.name.lower() for kind in OnsetKind},
        "words": messages(),
        # of a force that is not odd Python's digits are those of another search
        "references": [
            _reference(one.mechanism, one.oscillator, one.F_0, one.shown)
            for one in presets
            if one.oscillator.model.mechanism.odd
        ],
        "measured": {name: getattr(table, name) for name in dir(table) if name.isupper()},
        "worth": {"error": validity.WORTH, "truncation": validity.WORTH_TRUNCATION},
    }


def messages() -> dict[str, Any]:
    """The package's messages by name, with placeholders for numbers: "plain", and "si" by excitation, in its terms."""
    plain = {
        **{
            remark.name: text.format(**{name: PLACEHOLDERS.get(name, f"{{{name}}}") for name in text.names})
            if isinstance(text, Sentence)
            else text
            for remark, text in MESSAGES.items()
        },
        "STICKS": STICKS.format("{:g}", "{:g}"),
        "STICKS_BELOW": STICKS_BELOW.format("{:g}", "{:g}"),
        "NEAR_STICKING": validity.NEAR_STICKING.format("{:.3g}"),
        "NEAR_STICKING_BELOW": NEAR_STICKING_BELOW,
        "OFF_BY": validity.OFF_BY.removesuffix(validity.IN_PYTHON),
        "OFF_UNKNOWN": validity.OFF_UNKNOWN,
        "STOPS": STOPS,
    }
    # symbols are what is changed here: placeholders have no number yet, so any scales do
    scales = {name: Scales(m=1.0, k_v=1.0, L=1.0, excitation=name) for name in EXCITED_BY}
    si = {name: {key: in_units(text, of) for key, text in plain.items()} for name, of in scales.items()}
    return {"plain": plain, "si": si}


def _mechanism(design: Design) -> dict[str, Any]:
    """A record without its functions, how Python makes such an oscillator, and whether it moves a push-rod."""
    example = design.oscillator
    record = example.model.mechanism
    words_given = {name: value for name, value in example.given.items() if value == "untruncated"}
    called = design.constructor if record.name == design.mechanism else design.mechanism.replace("_", " ")
    return {
        "title": record.title,
        "design": [_parameter(one) for one in record.design],
        "scales": [dict(scale._asdict()) for scale in record.scales],
        "reach_reason": record.reach_reason,
        "truncated": record.truncated,
        "constructor": design.constructor,
        "words": words_given,
        "label": ", ".join([called, *words_given.values()]),
        "physical": hasattr(type(example), "physical"),
        "rod": record.design == ROD_SPRING.design,
        "odd": record.odd,
    }


def _excitation(name: str, title: str) -> dict[str, Any]:
    """The amplitude of one: that of a base's acceleration is a force m a without dimensions."""
    of = Scales(m=1.0, k_v=1.0, L=1.0, excitation=name).of_oscillator
    scale = AMPLITUDES[name] if name == of else OF_KIND[name]
    text = {} if name == of else {"doc": "amplitude of the base's acceleration; dimensionless m a/(k_v L)"}
    return {"title": title, "solved_as": of, **_parameter(EXCITATIONS[of]), **text, "scale": dict(scale._asdict())}


def _parameter(one: Parameter) -> dict[str, Any]:
    return {name: value for name, value in dataclasses.asdict(one).items() if value is not None}


def _values(one: Oscillator, F_0: float) -> dict[str, float]:
    design = zip((number.name for number in one.model.mechanism.design), one.model.design, strict=True)
    return {**dict(design), "mu": one.mu, "zeta": one.zeta, "F_0": F_0}


def _mount() -> dict[str, Any]:
    """The mount: m, k_v and L, and its other numbers in SI units, by the names that they have without dimensions."""
    parameters, scales = MOUNT.given, MOUNT.scales
    names = [number.name for number in (*MOUNT.oscillator.model.mechanism.design, *DAMPING)]
    values = {name: parameters[PHYSICAL_NAMES.get(name, name)] for name in names}
    return {
        "title": "The mount of the README",
        "mechanism": MOUNT.oscillator.model.mechanism.name,
        "excitation": MOUNT.oscillator.excitation,
        "base": {"m": scales.m, "k_v": scales.k_v, "L": scales.L},
        "values": {**values, "F_0": MOUNT_FORCE},
    }


def _reference(mechanism: str, one: Oscillator, F_0: float, high: float) -> dict[str, Any]:
    """What this package answers for a design, for the page to compare itself with."""
    onset, off, folds = one.saddle_node_onset(), one.detachment(), one.saddle_nodes(F_0)
    Omega = REFERENCE_AT * high
    return {
        "mechanism": mechanism,
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
