"""Oscillators in newtons, metres and hertz: in go a dimensionless one, m, k_v and L, out come its answers in SI units.

What each number is measured in is derived (4): `slowflow_kernels.scaling`. Arguments are plain SI numbers (kg, N, N/m,
m, s; frequencies in Hz), or quantities of pint. Answers are `Quantities`: plain SI numbers again, and printed, or
`in_units()`, in N, mm, Hz and ms.
"""

from __future__ import annotations

import contextlib
import dataclasses
import math
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from types import MappingProxyType, SimpleNamespace
from typing import Any

import numpy as np

from slowflow import physical_moves, validate
from slowflow.answer import PLAIN, Answer, Table, head, in_text, plain
from slowflow.averaged.plan import Plan
from slowflow.gradient import Gradient
from slowflow.mechanism import Floats
from slowflow_kernels.scaling import AMPLITUDES as AMPLITUDE_SCALES
from slowflow_kernels.scaling import SCALES
from slowflow_support.record import Parameter, Scale

#: what units there are of each kind, by their size in SI units; the first is SI's, and a turn is what Hz counts
UNITS: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "force": {"N": 1.0, "mN": 1e-3, "kN": 1e3},
        "length": {"m": 1.0, "mm": 1e-3, "um": 1e-6},
        "frequency": {"Hz": 1.0, "rpm": 1 / 60, "rad/s": 1 / math.tau},
        "time": {"s": 1.0, "ms": 1e-3},
        "speed": {"m/s": 1.0, "mm/s": 1e-3},
        "acceleration": {"m/s^2": 1.0, "g": physical_moves.g},
        "unbalance": {"kg m": 1.0, "kg mm": 1e-3, "g mm": 1e-6},
        "stiffness": {"N/m": 1.0, "N/mm": 1e3},
        "mass": {"kg": 1.0},
        "quadratic damping": {"N s^2/m^2": 1.0},
    }
)
#: those in which answers are shown, one of each kind
USUAL = ("N", "mm", "Hz", "ms", "mm/s", "m/s^2", "N/m", "kg", "kg m", "N s^2/m^2")
#: of which kind the numbers of an answer are, and what they are called with a unit
KINDS: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        **{name: (name, "length") for name in ("A", "A_1", "A_max", "B", "doubt")},
        "u_max": ("x_max", "length"),
        "load": ("load", "force"),
        "u_cr": ("x_cr", "length"),
        "u": ("x", "length"),
        "v": ("v", "speed"),
        "u_end": ("x_end", "length"),
        **{name: (name, "acceleration") for name in ("a", "base", "a_max", "acceleration")},
        "tau": ("t", "time"),
        **{f"tau_{name}": (f"t_{name}", "time") for name in ("A", "a", "detaches")},
        "duration": ("duration", "time"),
        "Omega": ("f", "frequency"),
        "Omega_low": ("f_low", "frequency"),
        "Omega_high": ("f_high", "frequency"),
        "Omega_cr": ("f_cr", "frequency"),
        "Omega_max": ("f_max", "frequency"),
        "Omega_undecided": ("f_undecided", "frequency"),
        "Omega_0": ("f_0", "frequency"),
        "Omega_sticks": ("f_sticks", "frequency"),
        "k_0": ("k_0", "stiffness"),
        "rests_within": ("rests_within", "length"),
        **{name: (name, "force") for name in ("break_loose", "sticking", "force")},
        "jumps": ("jumps", "frequency"),
        "period": ("period", "time"),
    }
)
#: amplitudes of the excitation: what is called F_0 without dimensions is F, Y or U, of this kind, and this to pint
AMPLITUDES = ("F_0", "F_SN", "F_cr")
EXCITED: Mapping[str, tuple[str, str, str]] = MappingProxyType(
    {
        "force": ("F", "force", "newton"),
        "base": ("Y", "length", "meter"),
        "unbalance": ("U", "unbalance", "kilogram*meter"),
    }
)
#: and which unit is of which kind
KIND_OF = {unit: kind for kind, units in UNITS.items() for unit in units}
#: the unit of each kind in which answers are shown
SHOWN = MappingProxyType({KIND_OF[unit]: unit for unit in USUAL})
#: words about dimensionless answers that are followed by numbers: which, by what they are replaced, and of which kind
PHRASES = (
    (r"(?<![\w/])F_0 = ", "{} = ", "amplitude"),
    (r"\b4 mu/pi = ", "4 friction/pi = ", "force"),
    (r"\bmu = ", "friction = ", "force"),
    (r"\bmu_s = ", "static_friction = ", "force"),
    (r"\btau = ", "t = ", "time"),
    (r"\bF_SN = ", "{}_SN = ", "amplitude"),
    (r"\bOmega = ", "f = ", "frequency"),
    (r"\bc_2 = ", "c_2 = ", "quadratic damping"),
    (r"\bload = ", "load = ", "force"),
    (r"\bfor Omega in \[", "for f in [", "frequency"),
    (r"\bA = ", "A = ", "length"),
    (r"\bamplitude up to ", "amplitude up to ", "length"),
    (r"\bamplitudes above ", "amplitudes above ", "length"),
)
#: arguments of a question, which are in SI units
CALLS = ((r"\bOmega=", "f=", "frequency"), (r"\bF_0=", "F=", "amplitude"), (r"\bA=", "A=", "length"))
#: and letters that stand alone
LETTERS = (
    (r"\bmu/\(A Omega\^2\)", "friction/(m A omega^2)"),
    (r"\bmu/\(F_0 Omega\^2\)", "friction over the force of inertia"),
    (r"\bF_0\b", "{}"),
    (r"\bmu\b", "friction"),
    (r"\btau\b", "t"),
    (r"\bOmega\b", "f"),
    (r"\bu_cr\b", "x_cr"),
    (r"\bu = 0\b", "x = 0"),
)
NUMBER = r"-?(?:\d+(?:\.\d+)?(?:e[+-]?\d+)?|inf)"
#: what can be drawn of a response curve
DRAWN = ("A", "phi", "transmissibility_dB")
#: what A is of a motion that is not about the centre
LARGEST = "A is the largest |x|, the mean displacement included: x_max of an averaged motion"
#: standard gravity, m/s^2
g = physical_moves.g


@dataclass(frozen=True, eq=False)
class Quantities(Answer):
    """An answer in physical units; its numbers are read by name, as `.F_SN`, `.f`, `.A`. Print it.

    values -- numbers, words and arrays by name
    units  -- the unit of each that has one
    answer -- the same, dimensionless: its `.validity`, `.measure()` and so on
    entry  -- names of what makes up one entry; an answer with several has a length, and an index or a loop gives one
    scales -- what the numbers of the answer are measured in, None where they are no such answer's
    """

    values: Mapping[str, Any]
    units: Mapping[str, str]
    answer: Any
    entry: tuple[str, ...] = ()
    scales: Scales | None = dataclasses.field(default=None, repr=False)

    def __post_init__(self) -> None:
        for value in self.values.values():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False
        for name in ("values", "units"):
            self.__dict__[name] = MappingProxyType(dict(getattr(self, name)))

    def __reduce__(self) -> tuple[Any, ...]:
        return Quantities, (dict(self.values), dict(self.units), self.answer, self.entry, self.scales)

    def __getattr__(self, name: str) -> Any:
        values = self.__dict__.get("values", {})  # not there yet while it is made
        if name not in values:
            raise AttributeError(f"{name!r} is no part of this answer: it has {', '.join(values)}")
        return values[name]

    def __len__(self) -> int:
        return len(self.values[self._entries()[0]])

    def __getitem__(self, k: int) -> SimpleNamespace:
        return SimpleNamespace(**{name: self.values[name][k].item() for name in self._entries()})

    def __iter__(self) -> Iterator[SimpleNamespace]:
        return (self[k] for k in range(len(self)))

    def _entries(self) -> tuple[str, ...]:
        if not self.entry:
            raise TypeError("this answer has no entries: it is a single one")
        return self.entry

    def columns(self) -> dict[str, Any]:
        """As of the dimensionless answer, in SI units."""
        if not self.entry:
            return super().columns()
        return {name: self.values[name] for name in self.entry}

    def about(self) -> dict[str, Any]:
        """What holds for all rows, and the dimensionless parameters."""
        beside = self.answer.about() if isinstance(self.answer, Answer) else {}
        said = {name: plain(value) for name, value in self.values.items() if isinstance(value, PLAIN)}
        return {**beside, **(said if self.entry else {})}

    @property
    def has_rows(self) -> bool:
        """Whether it has entries."""
        return bool(self.entry)

    def units_of_columns(self) -> Mapping[str, str]:
        """`units`."""
        return self.units

    def _numbers(self) -> set[str]:
        return set(self.units)

    def _content(self) -> dict[str, Any]:
        return {**self.values, "units": tuple(self.units.items())}

    def to_dict(self) -> dict[str, Any]:
        """The answer in plain Python: lists for arrays, numbers and words, by name; and `units`, a dictionary."""
        return {**super().to_dict(), "units": dict(self.units)}

    def in_units(self, *units: str) -> Quantities:
        """The same in other units, as in_units("kN", "rpm"); those of a kind that is not given are N, mm, Hz, ms.

        Raises ValueError for a unit that is none of `UNITS`.
        """
        wanted = {}
        for unit in (*USUAL, *units):
            validate.choice("unit", unit, tuple(KIND_OF))
            wanted[KIND_OF[unit]] = unit
        values, found = dict(self.values), {}
        for name, unit in self.units.items():
            kind = KIND_OF[unit]
            found[name] = wanted[kind]
            values[name] = _times(values[name], UNITS[kind][unit] / UNITS[kind][wanted[kind]])
        for name, value in values.items():
            if isinstance(value, Quantities):
                values[name] = value.in_units(*units)
        return Quantities(values, found, self.answer, self.entry, self.scales)

    def gradient(self) -> Gradient:
        """How the numbers move with those of the mount and with what was asked at, exactly: d(number)/d(number).

        As the gradient of the dimensionless answer, but in SI units, whatever units this answer is in. `.of` are its
        names, as "Y_SN" or "A", `.by` those of the mount: "k_h", "preload", "friction", "zeta" or "c", "m", "k_v", "L",
        "n" as if it were any number, and F (Y, U) and f where it was asked there.
        Raises ValueError for what is no averaged answer, and for a mount without preload, whose springs never touch.
        """
        if self.scales is None or not hasattr(self.answer, "gradient"):
            raise ValueError("gradients are known of averaged answers: this is none")
        return physical_moves.in_units(self.answer.gradient(), self.scales)

    def __str__(self) -> str:
        return "\n".join(_lines(self.in_units()))

    def plot(self, ax: Any = None, *, of: str | None = None) -> Any:
        """Draw a curve, folds, a fold locus or a shock, in mm, Hz, N, into Matplotlib axes, or new ones; return these.

        of -- of a response curve what is drawn: "A", "phi" or "transmissibility_dB"

        Other units: `in_units` first. Raises ValueError where there is no picture of this answer, ImportError without
        Matplotlib.
        """
        picture = getattr(self.answer, "picture", None)
        if picture is None:
            raise ValueError(f"there is no picture of this answer: it has {', '.join(self.values)}")
        from slowflow import pictures

        shown = self if set(self.units.values()).isdisjoint(("m", "s")) else self.in_units()
        if picture != "response":
            return getattr(pictures, picture)(ax, shown)
        return pictures.response(ax, shown, "A" if of is None else validate.choice("of", of, DRAWN))


def _times(value: Any, size: float) -> Any:
    return None if value is None else value * size


def _digits(number: str) -> int:
    """As many as a number was written with, four at least."""
    return max(4, min(15, len(re.sub(r"e.*|[^\d]", "", number).lstrip("0"))))


def _told(name: str, size: float, unit: str, match: re.Match[str]) -> str:
    """Numbers of words times what they are measured in, after their name."""
    numbers = re.findall(NUMBER, match["numbers"])
    return name + ", ".join(f"{float(one) * size:.{_digits(one)}g}" for one in numbers) + unit


def _lines(shown: Quantities) -> Iterator[str]:
    """The answer, intervals that it holds, then answers that it holds."""
    yield from in_text(shown)
    for name, value in shown.values.items():
        if isinstance(value, np.ndarray) and value.dtype.kind == "f" and value.shape[-1:] == (2,) and not shown.entry:
            for low, high in value.reshape(-1, 2).tolist():
                yield f"{head(name, shown.units):14}{low:.15g} to {high:.15g}"
        if isinstance(value, Quantities):
            yield from (f"{name}:", *(f"  {line}" for line in _lines(value)))


# ---- what a user gives


def si(name: str, value: Any, unit: str) -> Any:
    """A number or array in SI units: a plain one as it is, a quantity of pint converted to `unit`."""
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    try:
        return value.to(unit).magnitude
    except TypeError:  # what pint raises for another dimension
        raise ValueError(f"{name} = {value} is not allowed: {name} must be measured in {unit}") from None


def turns(name: str, value: Any) -> Any:
    """A frequency in turns per second: a plain number is in Hz.

    A quantity of pint has to say whether it counts turns or radians, which pint takes for the same: 1/s does not.
    """
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    if "hertz" in str(value.units):
        return si(name, value, "hertz")
    if "radian" not in str(value.to_base_units().units):
        raise ValueError(f"{name} = {value} is not allowed: {name} must be in Hz, rpm, or rad/s")
    return si(name, value, "radian/second") / math.tau


def size(scale: Scale, *, m: Any, k_v: Any, L: Any) -> Any:
    """What a dimensionless number is measured in (4), of one oscillator or of many: numbers or arrays, in SI units."""
    return scale.factor * math.prod(base**power for base, power in zip((k_v, L, m), scale.powers, strict=True))


def sizes(*, m: Any, k_v: Any, L: Any) -> dict[str, Any]:
    """What numbers of each kind are measured in."""
    base = {"m": m, "k_v": k_v, "L": L}
    length, rate = size(SCALES["u"], **base), size(SCALES["Omega"], **base)
    return {
        "force": size(SCALES["F_0"], **base),
        "length": length,
        "frequency": rate / math.tau,
        "time": size(SCALES["tau"], **base),
        "speed": length * rate,
        "stiffness": k_v,
        "acceleration": length * rate**2,
        "unbalance": size(AMPLITUDE_SCALES["unbalance"], **base),
        "quadratic damping": size(SCALES["c_2"], **base),
    }


@dataclass(frozen=True, kw_only=True)
class Scales:
    """What the dimensionless numbers of an oscillator are measured in (4), in SI units: m in kg, k_v in N/m, L in m.

    excitation -- what F_0 is the amplitude of, a key of `EXCITED`: of a base in L, of an unbalance in m L
    damping    -- which number viscous damping is given by, "zeta" or "c"

    Numbers, or quantities of pint. Raises ValueError for one that is not > 0.
    """

    m: float
    k_v: float
    L: float
    excitation: str = "force"
    damping: str = "zeta"

    def __post_init__(self) -> None:
        for name, unit in (("m", "kilogram"), ("k_v", "newton/meter"), ("L", "meter")):
            self.__dict__[name] = validate.number(name, si(name, getattr(self, name), unit), above=0.0)
        if not all(0 < value < math.inf for value in self.sizes.values()):
            raise ValueError(
                f"m = {self.m:g}, k_v = {self.k_v:g}, L = {self.L:g}: not allowed together, beyond doubles"
            )

    @cached_property
    def sizes(self) -> dict[str, float]:
        """What numbers of each kind are measured in."""
        return sizes(m=self.m, k_v=self.k_v, L=self.L)

    def of(self, scale: Scale) -> float:
        """What one of these numbers is measured in."""
        return float(size(scale, m=self.m, k_v=self.k_v, L=self.L))

    def over(self, name: str, value: Any, domain: Parameter, scale: Scale) -> float:
        """A given number over what it is measured in. Raises ValueError, in its terms, outside the domain."""
        size = self.of(scale)
        bounds = {b: getattr(domain, b) for b in ("above", "least", "below", "most") if getattr(domain, b) is not None}
        allowed = {bound: limit * size for bound, limit in bounds.items()}
        return validate.number(name, value, **allowed) / size

    def quantities(self, answer: Answer) -> Quantities:
        """An answer to a dimensionless question in SI units, and those that it holds."""
        fields = dataclasses.fields(answer)  # type: ignore[arg-type]
        found = {field.name: getattr(answer, field.name) for field in fields if field.repr}
        entry = (*answer.entry._fields, *answer.beside) if isinstance(answer, Table) else ()
        if entry and "F_0" not in entry and np.ndim(found.get("F_0", 0.0)):
            entry += ("F_0",)
        return self.named({**{name: getattr(answer, name) for name in entry}, **found}, answer, entry)

    def worded(self, text: str) -> str:
        """Words about a dimensionless answer with its letters, and numbers in N, mm and Hz."""
        letter, of_amplitude, _ = EXCITED[self.excitation]
        for pattern, name, kind in PHRASES:
            kind = of_amplitude if kind == "amplitude" else kind
            size = self.sizes[kind] / UNITS[kind][SHOWN[kind]]
            told = partial(_told, name.format(letter), size, f" {SHOWN[kind]}")
            text = re.sub(rf"{pattern}(?P<numbers>{NUMBER}(?:, {NUMBER})*)", told, text)
        for pattern, name, kind in CALLS:
            size = self.sizes[of_amplitude if kind == "amplitude" else kind]
            text = re.sub(rf"{pattern}(?P<numbers>{NUMBER})", partial(_told, name, size, ""), text)
        for pattern, name in LETTERS:
            text = re.sub(pattern, name.format(letter), text)
        return text

    @contextlib.contextmanager
    def in_these_terms(self) -> Iterator[None]:
        """What the dimensionless oscillator refuses is said by `worded`."""
        try:
            yield
        except (ValueError, ArithmeticError) as error:
            error.args = (self.worded(str(error)),)
            raise

    def kind(self, name: str) -> tuple[str, str]:
        """What a dimensionless number is called with a unit, and of which kind it is; "" for none."""
        if name not in AMPLITUDES:
            return KINDS.get(name, (name, ""))
        letter, kind, _ = EXCITED[self.excitation]
        return letter if name == "F_0" else letter + name[1:], kind

    def named(self, found: Mapping[str, Any], answer: Any, entry: tuple[str, ...] = ()) -> Quantities:
        """Dimensionless numbers by name, as `kind` has them, in SI units."""
        values: dict[str, Any] = {}
        units = {}
        for name, value in found.items():
            shown, kind = self.kind(name)
            values[shown] = self.quantities(value) if isinstance(value, Answer) else value
            if name == "message":
                values[shown] = self.worded(value)
            if kind:
                values[shown] = _times(value, self.sizes[kind])
                units[shown] = next(iter(UNITS[kind]))
        return Quantities(values, units, answer, tuple(self.kind(name)[0] for name in entry), self)


@dataclass(frozen=True, repr=False)
class Physical:
    """An oscillator whose questions take forces in N, frequencies f in Hz and lengths in m, and are answered in these.

    F is the amplitude of its excitation: of a base that shakes the displacement of the base in m, of an unbalance the
    mass that turns times its radius in kg m. Answers call it Y and U then, and what would be F_SN and F_cr Y_SN, ...

    oscillator -- the dimensionless one, which is asked
    scales     -- what its numbers are measured in
    given      -- what it was made from, for `replace`

    It does not change. Arguments may be quantities of pint too. What is asked, and what is raised, is the oscillator's.
    """

    oscillator: Any
    scales: Scales
    given: Mapping[str, Any] = dataclasses.field(compare=False)

    def __repr__(self) -> str:
        told = ", ".join(f"{name}={value!r}" for name, value in self.given.items())
        return f"{type(self.oscillator).__name__}.physical({told})"

    def replace(self, **changes: Any) -> Physical:
        """Another one with some of the numbers changed that this one was made from, by name."""
        kept = dict(self.given)
        for one, other in (("c", "zeta"), ("zeta", "c")):  # they say the same
            if one in changes:
                kept.pop(other, None)
        found: Physical = type(self.oscillator).physical(**{**kept, **changes})
        return found

    def at_rest(self) -> Quantities:
        """What a data sheet says: natural frequencies, stiffness, stroke, loads, friction.

        f_n         -- natural frequency of the mass on the vertical spring alone
        f_0, k_0    -- of small motions about the centre; no f_0 where the stiffness k_0 there is negative
        x_cr        -- the stroke, at which the springs leave; None where they never touch
        preset      -- by how much k_v is compressed to hold the mass at the centre, m g/k_v
        lightest, heaviest -- masses that would rest at -x_cr and x_cr, k_v being preset for m; no lightest where even
                       none would rest above -x_cr
        break_loose -- the constant force that friction holds, the static one where it is given
        rests_within -- how far from the centre friction holds the mass at rest; None where anywhere
        sticking    -- the force amplitude up to which averaging has the mass at rest (27)

        Raises ValueError with a load that k_v is not preset for: `rest` tells where that stands.
        """
        if (first := getattr(self.oscillator, "first", None)) is not None:  # the springs are the same at each depth
            return dataclasses.replace(self, oscillator=first).at_rest()
        m, k_v = self.scales.m, self.scales.k_v
        found = self.scales.quantities(self._ask(self.oscillator.at_rest))
        beyond = None if found.x_cr is None else k_v * found.x_cr / g
        values = {
            "f_n": self.scales.sizes["frequency"],
            **found.values,
            "preset": m * g / k_v,
            "lightest": None if beyond is None or beyond >= m else m - beyond,
            "heaviest": None if beyond is None else m + beyond,
        }
        units = {"f_n": "Hz", **found.units, "preset": "m", "lightest": "kg", "heaviest": "kg"}
        return Quantities(values, units, found.answer)

    def sag(self, load: Any) -> float:
        """How far from the centre a mass in kg would rest, in m, when k_v is preset for m: the force is (5)."""
        load = validate.number("load", si("load", load, "kilogram"), above=0.0)
        preset = float(si("m", self.given["m"], "kilogram"))
        return self._resting((load - preset) * g / self.scales.sizes["force"])

    def _resting(self, weight: float) -> float:
        """A place, in m, at which the spring force (5) over k_v L is this; there may be several."""
        # here, not above: `import slowflow` does without SciPy
        from scipy.optimize import brentq

        force = self.oscillator.restoring_force("untruncated")
        far = abs(weight) + 1.0 + (force.breakpoints[-1] if force.breakpoints else 0.0)
        u = float(brentq(lambda u: math.copysign(force.value(abs(u)), u) - weight, -far, far))
        return u * self.scales.sizes["length"]

    # ---- the questions

    def rest(self) -> Quantities:
        """Every place at which the mass rests without friction: .x .stable .load, see `Oscillator.rest`."""
        return self.scales.quantities(self._ask(self.oscillator.rest))

    def force(self, x: Any) -> Floats:
        """The restoring force in N at displacements in m, without the weight that k_v is preset for."""
        return np.asarray(self._ask(self.oscillator.force, self._length("x", x)) * self.scales.sizes["force"])

    def stiffness(self, x: Any) -> Floats:
        """Its slope in N/m."""
        return np.asarray(self._ask(self.oscillator.stiffness, self._length("x", x)) * self.scales.k_v)

    def saddle_node_onset(self) -> Quantities:
        """The lowest force amplitude that has a fold: .F_SN .f .A, see `Averaged.saddle_node_onset`."""
        return self.scales.quantities(self._ask(self.oscillator.saddle_node_onset))

    def detachment(self) -> Quantities:
        """The lowest force amplitude that reaches the stroke: .F_cr .f_cr .x_cr, see `Averaged.detachment`."""
        return self.scales.quantities(self._ask(self.oscillator.detachment))

    def saddle_nodes(self, F: Any) -> Quantities:
        """Where a sweep jumps at the force amplitude F: .f .A .kind .corner, see `Averaged.saddle_nodes`."""
        return self.scales.quantities(self._ask(self.oscillator.saddle_nodes, self._amplitude(F)))

    def peak(self, F: Any) -> Quantities:
        """The highest peak: .A .f, see `Averaged.peak`; under a load .x_max at .f_max as well, see `OffCentre.peak`."""
        return self.scales.quantities(self._ask(self.oscillator.peak, self._amplitude(F)))

    def amplitudes(self, *, f: Any, F: Any) -> Quantities:
        """Every steady state at f: .f .A .phi .stable .transmissibility_dB, see `Averaged.amplitudes`.

        Under a load .A is the amplitude about the mean displacement .B, and .x_max the largest |x|, |B| + A.
        """
        Omega, F_0 = self._frequencies(f), self._amplitudes(F)
        return self.scales.quantities(self._ask(self.oscillator.amplitudes, Omega=Omega, F_0=F_0))

    def frequency_response(self, F: Any, *, f: Any = None, samples: int = 1000) -> Quantities:
        """The response curve for frequencies in the window f, of up to twice f_n without: `amplitudes` and .branch."""
        found = self._ask(self.oscillator.frequency_response, self._amplitude(F), samples=samples, **self._window(f))
        return self.scales.quantities(found)

    def fold_locus(self, *, samples: int = 1000, A_max: Any = None) -> Quantities:
        """The folds of every force amplitude: .f .A .F .branch, see `Averaged.fold_locus`."""
        return self.scales.quantities(self._ask(self.oscillator.fold_locus, samples=samples, A_max=self._most(A_max)))

    def cusps(self, *, A_max: Any = None) -> Quantities:
        """Where two folds come into being or meet: .F .f .A .minimum, see `Averaged.cusps`."""
        return self.scales.quantities(self._ask(self.oscillator.cusps, A_max=self._most(A_max)))

    def isola_points(self, *, A_max: Any = None) -> Quantities:
        """Where isolated curves are born or merge: .F .f .A .kind, see `Averaged.isola_points`."""
        return self.scales.quantities(self._ask(self.oscillator.isola_points, A_max=self._most(A_max)))

    def backbone(self, A: Any) -> Floats:
        """f in Hz on the backbone at amplitudes in m, see `Averaged.backbone`."""
        return np.asarray(self._ask(self.oscillator.backbone, self._length("A", A)) * self.scales.sizes["frequency"])

    def limit_envelope(self, *, f: Any, F: Any) -> Floats:
        """The amplitude in m that no response exceeds, see `Averaged.limit_envelope`."""
        A = self._ask(self.oscillator.limit_envelope, Omega=self._frequencies(f), F_0=self._amplitudes(F))
        return np.asarray(A * self.scales.sizes["length"])

    def certify(self, F: Any, *, f: Any = None) -> Quantities:
        """What is proved at a force amplitude: see `Averaged.certify`.

        Of the dimensionless numbers as they are: `.answer` has the intervals that are proved, and these are the same
        times what is measured in, rounded.
        """
        Omega = None if f is None else self._frequency(f)
        return self.scales.quantities(self._ask(self.oscillator.certify, self._amplitude(F), Omega=Omega))

    def plot(self, F: Any, *, f: Any = None, of: str = "A", ax: Any = None) -> Any:
        """Draw the response at one force, or at each of several, into Matplotlib axes, or new ones, and return these.

        f  -- the window of frequencies, up to twice f_n without
        of -- what is drawn over frequency, in Hz: "A", in mm, "phi" or "transmissibility_dB"

        Signs and tints as of `Averaged.plot`. Raises ValueError for another word, ImportError without Matplotlib.
        """
        from slowflow import pictures

        validate.choice("of", of, DRAWN)
        letter, _, unit = EXCITED[self.scales.excitation]
        forces = validate.several(letter, si(letter, F, unit))
        answers = ((self.frequency_response(force, f=f), self.saddle_nodes(force)) for force in forces)
        found = [(curve.in_units(), folds.in_units()) for curve, folds in answers]
        ax = pictures.responses(ax, found, of)
        window = validate.WINDOW if f is None else self._window(f)["Omega"]
        ax.set_xlim(*(end * self.scales.sizes["frequency"] for end in window))
        if of == "A":
            length = self.scales.sizes["length"] / UNITS["length"]["mm"]
            pictures.breakpoints(ax, [length * end for end in self.oscillator.breakpoints], "x")
            pictures.stopping(ax, self.oscillator.mu * length * self.scales.sizes["frequency"] ** 2)
        pictures.legend(ax, pictures.axis(found[0][0], letter))
        return ax

    def explain(self, question: str, F: Any = None) -> Plan:
        """What runs for a question and what is skipped, see `Averaged.explain`."""
        found: Plan = self._ask(self.oscillator.explain, question, None if F is None else self._amplitude(F))
        steps = tuple(dataclasses.replace(step, why=self.scales.worded(step.why)) for step in found.steps)
        letter, kind, unit = EXCITED[self.scales.excitation]
        where = "" if F is None else f" at {letter} = {si(letter, F, unit):g} {next(iter(UNITS[kind]))}"
        return dataclasses.replace(found, steps=steps, where=where)

    @property
    def second_approximation(self) -> Physical:
        """The same questions, those that it answers, with the higher harmonics of force and friction."""
        with self.scales.in_these_terms():
            return Physical(self.oscillator.second_approximation, self.scales, self.given)

    def steady_state(self, *, f: Any, F: Any, A: Any = None, samples: int = 400) -> Quantities:
        """One periodic motion of the equation of motion: .A .stops .stable .period, and .t .x .v over one period.

        .A is the largest |x|; under a load that is what `amplitudes` calls .x_max, and .message says so. See
        `Oscillator.steady_state`, which `.answer` is from.
        """
        at = {"Omega": self._frequency(f), "F_0": self._amplitude(F), "A": self._most(A)}
        found = self._ask(self.oscillator.steady_state, **at)
        tau, u, v = found.series(samples)
        said = {name: getattr(found, name) for name in ("Omega", "A", "stops", "stable", "period")}
        said |= {"F_0": at["F_0"], "message": "" if self.oscillator.load == 0 else LARGEST}
        return self.scales.named({**said, "tau": tau, "u": u, "v": v}, found)

    def exact_response(
        self, F: Any, *, f: Any = None, start: Quantities | None = None, step: float = 0.02
    ) -> Quantities:
        """The curve of the equation of motion: .f .A .stable .stops, and .folds; see `Oscillator.exact_response`.

        start -- what `steady_state` gave
        """
        if not (start is None or isinstance(start, Quantities)):
            raise ValueError(f"start = {start!r} is not allowed: start must be what steady_state gave")
        begun = None if start is None else start.answer
        found = self._ask(self.oscillator.exact_response, self._amplitude(F), start=begun, step=step, **self._window(f))
        entry = ("Omega", "A", "stable", "stops")
        columns = ("Omega", "A", "kind", "corner")
        folds = {name: np.array([getattr(fold, name) for fold in found.folds]) for name in columns}
        said = {name: getattr(found, name) for name in (*entry, "F_0", "closed", "message")}
        curve = self.scales.named(said, found, entry)
        values = {**curve.values, "folds": self.scales.named(folds, found.folds, columns)}
        return Quantities(values, curve.units, found, curve.entry, self.scales)

    def sweep(self, *, f: Any, F: Any) -> Quantities:
        """What an experiment sees that steps through frequencies: .f .A .stops .settled, and .jumps in Hz.

        See `Oscillator.sweep`.
        """
        found = self._ask(self.oscillator.sweep, Omega=self._frequencies(f), F_0=self._amplitude(F))
        entry = ("Omega", "A", "stops", "settled")
        said = {name: getattr(found, name) for name in (*entry, "F_0")}
        jumps = np.array(found.jumps).reshape(-1, 2)
        return self.scales.named({**said, "jumps": jumps}, found, entry)

    def transient(
        self, *, acceleration: Any, duration: Any = None, t: Any = None, after: Any = None, samples: int = 400
    ) -> Quantities:
        """A shock of the base: .A .a_max .detaches .rests, and .t .x .v .a .base over time.

        acceleration -- of the base, in m/s^2: the peak of a half sine, or the samples of a record
        duration     -- of the half sine, in s
        t            -- the times of the samples instead, in s
        after        -- for how long the free motion is followed that comes then, in s
        samples      -- points over time

        See `Oscillator.transient`, which `.answer` is from.
        """
        pulse = {"acceleration": self._acceleration(acceleration)}
        times = {"duration": duration, "tau": t, "after": after}
        pulse |= {name: self._time(name, value) for name, value in times.items() if value is not None}
        found = self._ask(self.oscillator.transient, **pulse)
        said = {field.name: getattr(found, field.name) for field in dataclasses.fields(found) if field.repr}
        return self.scales.named({**said, **found.series(samples)._asdict()}, found)

    def shock_spectrum(self, *, acceleration: Any, duration: Any) -> Quantities:
        """What half sines of the base do: .acceleration .duration .A .a_max .ratio .detaches, a row for each.

        In m/s^2 and s, numbers or arrays that broadcast; see `Oscillator.shock_spectrum`.
        """
        pulses = {"acceleration": self._acceleration(acceleration), "duration": self._time("duration", duration)}
        return self.scales.quantities(self._ask(self.oscillator.shock_spectrum, **pulses))

    def margins(self, F: Any) -> Quantities:
        """How far a force amplitude is from F_SN and F_cr: .of_SN .of_cr, see `Oscillator.margins`."""
        return self.scales.quantities(self._ask(self.oscillator.margins, self._amplitude(F)))

    def hysteresis(self, F: Any) -> Quantities:
        """Bands with several stable motions: .f_low .f_high .motions, see `Oscillator.hysteresis`."""
        return self.scales.quantities(self._ask(self.oscillator.hysteresis, self._amplitude(F)))

    def isolation(self, F: Any) -> Quantities:
        """The frequency from which on less than F is transmitted: .f .A, see `Oscillator.isolation`."""
        return self.scales.quantities(self._ask(self.oscillator.isolation, self._amplitude(F)))

    def spectrum(self, *, f: Any, F: Any) -> Quantities:
        """A load spectrum, row by row, see `Oscillator.spectrum`."""
        Omega, F_0 = self._frequencies(f), self._amplitudes(F)
        return self.scales.quantities(self._ask(self.oscillator.spectrum, Omega=Omega, F_0=F_0))

    def _ask(self, question: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
        """The dimensionless answer; refusals are in newtons, metres and hertz, as what was asked for is."""
        with self.scales.in_these_terms():
            return question(*arguments, **named)

    # ---- arguments

    def _amplitude(self, value: Any) -> float:
        """One amplitude of the excitation."""
        name, kind, unit = EXCITED[self.scales.excitation]
        return validate.number(name, si(name, value, unit), above=0.0) / self.scales.sizes[kind]

    def _amplitudes(self, value: Any) -> Any:
        """One, or an array of them."""
        name, kind, unit = EXCITED[self.scales.excitation]
        return self._over(name, si(name, value, unit), kind, above=0.0)

    def _length(self, name: str, value: Any) -> Any:
        return self._over(name, si(name, value, "meter"), "length")

    def _acceleration(self, value: Any) -> Any:
        return self._over("acceleration", si("acceleration", value, "meter/second**2"), "acceleration")

    def _time(self, name: str, value: Any) -> Any:
        return self._over("t" if name == "tau" else name, si(name, value, "second"), "time")

    def _most(self, A: Any) -> Any:
        return None if A is None else self._length("A", A)

    def _frequency(self, value: Any) -> float:
        return validate.number("f", turns("f", value), above=0.0) / self.scales.sizes["frequency"]

    def _frequencies(self, value: Any) -> Any:
        """One, or an array of them."""
        return self._over("f", turns("f", value), "frequency", above=0.0)

    def _window(self, f: Any) -> dict[str, Any]:
        """Of frequencies, as the oscillator takes it; nothing where it has its own."""
        if f is None:
            return {}
        try:
            low, high = f
        except (TypeError, ValueError):
            raise ValueError(f"f = {f!r} is not allowed: f must be a pair of frequencies (low, high)") from None
        ends = validate.window("f", (turns("f[0]", low), turns("f[1]", high)))
        return {"Omega": tuple(end / self.scales.sizes["frequency"] for end in ends)}

    def _over(self, name: str, value: Any, kind: str, above: float = -math.inf) -> Any:
        """A number as one, or an array, over what it is measured in."""
        size = self.scales.sizes[kind]
        if validate.is_single(value):
            return validate.number(name, value, above=above) / size
        array = validate.finite_array(name, value) if above < 0 else validate.positive_array(name, value)
        return array / size
