"""Results in SI units.

Arguments are numbers in SI units (kg, N, N/m, m, s, Hz), strings such as "0.3 g", or pint quantities. Attributes of
results are numbers in SI units. Results print in N, mm, Hz and ms; `in_units()` converts to other units.
"""

from __future__ import annotations

import contextlib
import dataclasses
import functools
import math
import operator
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType, SimpleNamespace
from typing import TYPE_CHECKING, Any, Self, overload

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import PLAIN, Answer, Entry, Table, drawn, plain, shown
from slowflow.answers.table import QUANTITIES
from slowflow.core import validate
from slowflow.core.mechanism import Floats
from slowflow.support.errors import Refused, WrongType
from slowflow.support.record import Parameter, Scale
from slowflow.support.text import in_units
from slowflow_kernels.domains import DAMPING, DISSIPATION
from slowflow_kernels.rod_spring import MECHANISM as ROD_SPRING
from slowflow_kernels.scaling import AMPLITUDES, SCALES

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Protocol

    from matplotlib.axes import Axes

    from slowflow.answers.gradient import Gradient
    from slowflow.core.mechanism import Array

    class WithUnit(Protocol):
        """A quantity of pint."""

        @property
        def magnitude(self) -> Any:
            """Its number or numbers."""
            ...

        def to(self, unit: Any, /) -> Any:
            """Convert to another unit."""
            ...

    #: one number, which may be a string with a unit, an array of them, and the two ends of a window
    Plain = float | np.floating[Any] | np.integer[Any] | WithUnit
    Number = Plain | str
    Numbers = Number | Sequence[Plain] | Array
    Window = Sequence[Plain] | Array | WithUnit

#: standard gravity, m/s^2
g = 9.80665
#: a pound in kg
LB = 0.45359237
#: the units of each kind, by their size in SI units; the first is SI's, and Hz counts turns
UNITS: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "force": {"N": 1.0, "mN": 1e-3, "kN": 1e3, "lbf": LB * g},
        "length": {"m": 1.0, "mm": 1e-3, "um": 1e-6, "in": 0.0254},
        "frequency": {"Hz": 1.0, "rpm": 1 / 60, "rad/s": 1 / math.tau},
        "time": {"s": 1.0, "h": 3600.0, "min": 60.0, "ms": 1e-3},
        "speed": {"m/s": 1.0, "mm/s": 1e-3},
        "acceleration": {"m/s^2": 1.0, "g": g},
        "unbalance": {"kg m": 1.0, "kg mm": 1e-3, "g mm": 1e-6},
        "stiffness": {"N/m": 1.0, "N/mm": 1e3, "lbf/in": LB * g / 0.0254},
        "cubic stiffness": {"N/m^3": 1.0, "N/mm^3": 1e9},
        "quintic stiffness": {"N/m^5": 1.0, "N/mm^5": 1e15},
        "angle": {"rad": 1.0, "deg": math.tau / 360},
        "mass": {"kg": 1.0, "lb": LB},
        "quadratic damping": {"N s^2/m^2": 1.0},
        "cubic damping": {"N s^3/m^3": 1.0},
        "growing damping": {"N s/m^3": 1.0},
        "damping": {"N s/m": 1.0},
        "rate": {"1/s": 1.0},
    }
)
#: those in which answers are shown, one of each kind
USUAL = (
    *("N", "mm", "Hz", "ms", "mm/s", "m/s^2", "N/m", "N/m^3", "N/m^5", "rad", "kg", "kg m", "1/s"),
    *("N s/m", "N s^2/m^2", "N s^3/m^3", "N s/m^3"),
)
#: amplitudes of the excitation: the dimensionless F_0 is F, Y, U or a, of this kind
EXCITED: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "force": ("F", "force"),
        "base": ("Y", "length"),
        "unbalance": ("U", "unbalance"),
        "acceleration": ("a", "acceleration"),
    }
)
LETTERS = tuple(letter for letter, _ in EXCITED.values())
#: those of base excitation
OF_A_BASE = ("base", "acceleration")
#: units of spectral densities: the root of each over its SI unit, and the kind of that
DENSITIES = {"g^2/Hz": (g, "acceleration"), "(m/s^2)^2/Hz": (1.0, "acceleration"), "N^2/Hz": (1.0, "force")}
#: the unit of each kind in SI
SI = MappingProxyType({kind: next(iter(units)) for kind, units in UNITS.items()})
#: the kind of each unit
KIND_OF = {unit: kind for kind, units in UNITS.items() for unit in units}
#: the unit of each kind in which answers are shown
SHOWN = MappingProxyType({KIND_OF[unit]: unit for unit in USUAL})
#: the numbers of a data sheet: their units, "" for none, and meaning
DATA_SHEET: Mapping[str, tuple[str, str]] = MappingProxyType(
    {
        "m": ("kg", "mass that the vertical spring is preloaded to carry"),
        "mounts": ("", "number of equal mounts that share the mass; the other data are those of one"),
        "load": ("kg", "mass on the mount, if different from m"),
        "k_v": ("N/m", "stiffness of the vertical spring"),
        "k_h": ("N/m", "stiffness of each horizontal spring"),
        "k_1": ("N/m", "stiffness of a spring at the centre"),
        "k_3": ("N/m^3", "factor of x^3 of a spring"),
        "k_5": ("N/m^5", "factor of x^5 of a spring"),
        "n": ("", "number of horizontal springs"),
        "L": ("m", "length of a push-rod"),
        "preload": ("m", "compression of a horizontal spring at the centre"),
        "friction": ("N", "dry friction"),
        "static_friction": ("N", "dry friction that holds a mass at rest"),
        "c": ("N s/m", "viscous damping"),
        "zeta": ("", "viscous damping ratio, c over 2 √(k_v m)"),
        "eta": ("", "loss factor of the vertical spring"),
        "c_2": ("N s^2/m^2", "quadratic damping"),
        "c_3": ("N s^3/m^3", "cubic damping"),
        "c_xx": ("N s/m^3", "growth of the viscous damping with the squared displacement"),
        "contact": ("", "where friction acts"),
        "force": ("", "the springs' force that is averaged: truncated (6), or untruncated (5)"),
        "excitation": ("", "kind of excitation"),
    }
)
SHEET: Mapping[str, str] = MappingProxyType({name: unit for name, (unit, _) in DATA_SHEET.items()})
#: stiffnesses of `Duffing.physical`
SPRINGS = ("k_1", "k_3", "k_5")
#: a mount's names for the letters of the scales of its design and its damping
NAMES = {"lam": "n", "k_h": "k_h", "Delta_h": "preload", "F_c": "friction", "c": "c", "c_q": "c_2", "c_c": "c_3"}
NAMES |= {one: one for one in ("c_xx", *SPRINGS)}
#: numbers of a mount that add up over several
PER_MOUNT = ("k_v", "k_h", "friction", "c", "c_2", "c_3", "c_xx")
#: the bases of all scales, in the order of their powers
BASE = ("k_v", "L", "m")
#: of a dimensionless number
PURE = Scale("", 1.0, (0.0, 0.0, 0.0))
#: scales of each kind of number, but for the turn of a frequency
OF_KIND: Mapping[str, Scale] = MappingProxyType(
    {
        "": PURE,
        "angle": PURE,
        "force": SCALES["F_0"],
        "length": SCALES["u"],
        "frequency": SCALES["Omega"],
        "time": SCALES["tau"],
        "unbalance": AMPLITUDES["unbalance"],
        "quadratic damping": SCALES["c_2"],
        "cubic damping": SCALES["c_3"],
        "growing damping": SCALES["zeta_2"],
        "acceleration": Scale("a", 1.0, (1.0, 1.0, -1.0)),
        "stiffness": Scale("k", 1.0, (1.0, 0.0, 0.0)),
        "damping": Scale("c", 1.0, (0.5, 0.0, 0.5)),
        "rate": Scale("omega_n", 1.0, (0.5, 0.0, -0.5)),
        "speed": Scale("v", 1.0, (0.5, 1.0, -0.5)),
    }
)
#: scales of the stiffnesses of `Duffing.physical`, by their dimensionless names
OF_SPRINGS = {
    name: Scale(spring, 1.0, (1.0, -2.0 * order, 0.0))
    for order, (name, spring) in enumerate(zip(("alpha", "beta", "gamma"), SPRINGS, strict=True))
}
WITHOUT_PRELOAD = "without preload the springs never touch the push-rod: none of their parameters affects an answer"
#: member that only the dimensionless answer has
OF_THE_ANSWER = "validity"
#: quantities that can be drawn of a response curve
DRAWN = ("A", "phi", "transmissibility_dB")


@dataclass(frozen=True, eq=False)
class Quantities(Answer):
    """An answer in physical units; its numbers are attributes, such as `.F_SN`, `.f`, `.A`. It prints as a table.

    values -- numbers, texts and arrays by name
    units  -- the unit of each that has one
    answer -- the dimensionless answer, with `.validity` and so on
    entry  -- names of the columns of an entry; an answer with several entries has a length, indexing or iterating gives
            entries
    scales -- the scales of the answer's numbers, None if it has none
    chosen -- whether the units are those chosen by `in_units`; otherwise numbers print in N, mm, Hz, ms
    """

    values: Mapping[str, Any]
    units: Mapping[str, str]
    answer: Any
    entry: tuple[str, ...] = ()
    scales: Scales | None = dataclasses.field(default=None, repr=False)
    chosen: bool = dataclasses.field(default=False, repr=False)

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("values", "units"):
            self.__dict__[name] = MappingProxyType(dict(getattr(self, name)))
        self.__dict__["has_rows"] = bool(self.entry)

    def __reduce__(self) -> tuple[Any, ...]:
        own = (getattr(self, one.name) for one in dataclasses.fields(self))
        return type(self), tuple(dict(value) if isinstance(value, MappingProxyType) else value for value in own)

    if not TYPE_CHECKING:  # which numbers an answer has its type declares, see `physical_answers`

        def __getattr__(self, name: str) -> Any:
            values = self.__dict__.get("values", {})  # not there yet while it is made
            if name not in values:
                if name == OF_THE_ANSWER and isinstance(answer := self.__dict__.get("answer"), Answer):
                    getattr(answer, name)  # which may say why it has none
                    raise validate.NoAttribute(
                        f"{name!r} is not part of an answer in units: .answer.{name} is dimensionless"
                    )
                raise validate.NoAttribute(f"{name!r} is not part of this answer: it has {', '.join(values)}")
            return values[name]

    def __len__(self) -> int:
        return len(self.values[self._entries()[0]])

    @overload
    def __getitem__(self, k: int) -> Entry: ...
    @overload
    def __getitem__(self, k: slice) -> list[Entry]: ...
    def __getitem__(self, k: int | slice) -> Any:
        if isinstance(k, slice):
            return list(self)[k]
        return SimpleNamespace(**{name: self.values[name][operator.index(k)].item() for name in self._entries()})

    def __iter__(self) -> Iterator[Entry]:
        return (self[k] for k in range(len(self)))

    def _entries(self) -> tuple[str, ...]:
        if not self.entry:
            raise WrongType("this answer has no entries: it is a single answer")
        return self.entry

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """Return the columns of the dimensionless answer, in SI units."""
        if not self.entry:
            return super().columns()
        return {name: self.values[name] for name in self.entry}

    def about(self) -> dict[str, Any]:
        """Return values common to all rows, the data of the mount, and the dimensionless parameters."""
        extra = self.answer.about() if isinstance(self.answer, Answer) else {}
        known = {name: plain(value) for name, value in self.values.items() if isinstance(value, PLAIN)}
        sheet = {} if self.scales is None else self.scales.sheet
        return {**extra, **sheet, **(known if self.entry else {})}

    def units_of_about(self) -> Mapping[str, str]:
        """Units of the values of `about`."""
        return {name: unit for name in self.about() if (unit := self.units.get(name, SHEET.get(name, "")))}

    def units_of_columns(self) -> Mapping[str, str]:
        """Units of the columns, by name."""
        return self.units

    def text_of(self, name: str, value: object) -> str:
        """Text of the dimensionless answer: "none" and infinity do not depend on units."""
        if self.scales is None or not isinstance(self.answer, Answer):
            return ""
        plain_name = next((one for one in self.answer.labels if self.scales.kind(one)[0] == name), name)
        return self.answer.text_of(plain_name, value)

    def _numbers(self) -> set[str]:
        # those without a unit, as a margin, are called the same in the dimensionless answer
        return set(self.units) | (self.answer._numbers() if isinstance(self.answer, Answer) else set())

    def _content(self) -> dict[str, Any]:
        return {**self.values, "units": tuple(self.units.items())}

    def _members(self) -> Mapping[str, Any]:
        """As of any answer: without their units."""
        return self.values

    def to_dict(self) -> dict[str, Any]:
        """Convert to plain Python: lists for arrays, numbers and texts, by name; and `units`, a dictionary."""
        return {**super().to_dict(), "units": dict(self.units)}

    def in_units(self, *units: str) -> Self:
        """Convert to other units, such as in_units("kN", "rpm"); other quantities are in N, mm, Hz, ms.

        Raises ValueError for a unit that is not in `UNITS`.
        """
        target = {}
        for unit in (*USUAL, *units):
            validate.choice("unit", unit, tuple(KIND_OF))
            target[KIND_OF[unit]] = unit
        values, found = dict(self.values), {}
        for name, unit in self.units.items():
            kind = KIND_OF[unit]
            found[name] = target[kind]
            values[name] = _times(values[name], UNITS[kind][unit] / UNITS[kind][target[kind]])
        for name, value in values.items():
            if isinstance(value, Quantities):
                values[name] = value.in_units(*units)
        return dataclasses.replace(self, values=values, units=found, chosen=True)

    def gradient(self) -> Gradient:
        """Differentiate the numbers with respect to the data of the mount and the question's arguments.

        The derivatives are exact and in SI units, whatever units this answer is in. `.of` has the names of the numbers,
        such as "Y_SN" or "A", `.by` those of the parameters: "k_h", "preload", "friction", "zeta" or "c", "m", "k_v",
        "L", "n" as a real number, and F (Y, U) and f if the question took them; for random vibration psd_G, a common
        factor of all densities, and psd_f, one of all frequencies. Raises ValueError for answers that are not averaged,
        and for a mount without preload, whose springs never touch the push-rod.
        """
        if self.scales is None or not hasattr(self.answer, "gradient"):
            raise Refused("only averaged answers have gradients: this answer is not averaged")
        return self.scales.gradient(self.answer.gradient())

    def measure(self, force: str | None = None, **options: object) -> Quantities:
        """Compare averaged states, folds, a peak, an onset, a detachment with the equation of motion, in SI units.

        options -- for isolation of="first" or "peak"; for random vibration samples, records and seed

        Results and errors as `measure` of the dimensionless answer. Raises ValueError for answers that are not
        averaged.
        """
        if self.scales is None or not hasattr(self.answer, "measure"):
            raise Refused(
                "only averaged answers can be compared with the equation of motion: this answer is not averaged"
            )
        with self.scales.in_these_terms():
            return self.scales.quantities(self.answer.measure(force=force, **options))

    def largest(self, duration: Numbers) -> Floats:
        """Compute the mean largest |x| in m of random vibration within a duration in s: `RandomResponse.largest`."""
        answer, scales = self._random()
        with scales.in_these_terms():
            found = answer.largest(si("duration", duration, "s") / scales.sizes["time"])
        return np.asarray(found * scales.sizes["length"])

    def absolute_rms(self) -> Floats:
        """Root mean square in m of the absolute displacement in random vibration of the base, shape (motions,)."""
        answer, scales = self._random()
        if scales.excitation not in OF_A_BASE:
            raise Refused("the base stands still under a force: the absolute displacement is x_rms")
        return np.asarray(answer.absolute_rms() * scales.sizes["length"])

    def response_psd(self, f: Numbers) -> Floats:
        """Compute the one-sided density of x in m^2/Hz at frequencies in Hz, of random vibration, (motions, n)."""
        answer, scales = self._random()
        with scales.in_these_terms():
            density = answer.response_psd(np.asarray(si("f", f, "Hz"), dtype=float) / scales.sizes["frequency"])
        return np.asarray(density * scales.sizes["length"] ** 2 / scales.sizes["frequency"])

    def _random(self) -> tuple[Any, Scales]:
        if self.scales is None or not hasattr(self.answer, "response_psd"):
            raise Refused("only answers of random vibration have this")
        return self.answer, self.scales

    def _figure(self) -> str:
        return drawn(self, picture) if (picture := getattr(self.answer, "picture", "")) else ""

    def plot(self, ax: Axes | None = None, *, of: str | None = None) -> Axes:
        """Plot a curve, folds, a fold locus or a shock, in mm, Hz, N; return the Matplotlib axes, new ones by default.

        of -- quantity of a response curve: "A", "phi" or "transmissibility_dB"

        For other units call `in_units` first. Raises ValueError if this answer has no plot, ImportError without
        Matplotlib.
        """
        picture: str | None = getattr(self.answer, "picture", None)
        if picture is None:
            raise Refused(f"there is no plot of this answer: it has {', '.join(self.values)}")
        from slowflow.answers import pictures

        if picture != "response":
            return pictures.PICTURES[picture](ax, shown(self))
        return pictures.response(ax, shown(self), "A" if of is None else validate.choice("of", of, DRAWN))


def _times(value: Any, size: float) -> Any:
    return None if value is None else value * size


# ---- arguments


def si(name: str, value: Any, unit: str) -> Any:
    """Convert a number or array to SI units: plain numbers are unchanged; `unit` is the target of others."""
    if isinstance(value, str) and unit:
        number, _, word = value.strip().partition(" ")
        known = UNITS[KIND_OF[unit]]
        with contextlib.suppress(ValueError):
            if word.strip() in known:
                return float(number) * known[word.strip()]
        one_of = f"a number in {unit}, or one with a unit of {', '.join(known)}, as '20 {tuple(known)[-1]}'"
        raise Refused(f"{name} = {value!r} is not allowed: {name} must be {one_of}")
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    if unit == SI["frequency"]:
        return _turns(name, value)
    try:
        return value.to(unit).magnitude  # pint reads them as they are written here
    except TypeError:  # what pint raises for another dimension
        measured = f"measured in {unit}" if unit else "a plain number"
        raise Refused(f"{name} = {value} is not allowed: {name} must be {measured}") from None


def in_shown(unit: str) -> tuple[str, float]:
    """Return the unit in which numbers of a unit are shown, and its size in that one; "" and 1 without a unit."""
    if not unit:
        return "", 1.0
    kind = KIND_OF[unit]
    return SHOWN[kind], UNITS[kind][SHOWN[kind]] / UNITS[kind][unit]


def _turns(name: str, value: Any) -> Any:
    """Convert a frequency to Hz: it has to say whether it counts turns or radians, which pint takes for the same.

    1/s does not.
    """
    if "hertz" in str(value.units):
        return value.to("hertz").magnitude
    if "radian" not in str(value.to_base_units().units):
        raise Refused(f"{name} = {value} is not allowed: {name} must be in Hz, rpm, or rad/s")
    return value.to("radian/second").magnitude / math.tau


def size(scale: Scale, *, m: Any, k_v: Any, L: Any) -> Any:
    """Compute the scale of a dimensionless number (4), of one oscillator or of many: numbers or arrays, in SI units."""
    return scale.factor * math.prod(base**power for base, power in zip((k_v, L, m), scale.powers, strict=True))


def sizes(*, m: Any, k_v: Any, L: Any) -> dict[str, Any]:
    """Compute the scale of each kind of number."""
    found = {kind: size(scale, m=m, k_v=k_v, L=L) for kind, scale in OF_KIND.items() if scale is not PURE}
    length, rate = found["length"], found["frequency"]
    turning = {"frequency": rate / math.tau, "speed": length * rate, "acceleration": length * rate**2}
    return {**found, **turning, "angle": 1.0}


@dataclass(frozen=True, kw_only=True)
class Scales:
    """The scales of the dimensionless numbers of an oscillator (4), in SI units: m in kg, k_v in N/m, L in m.

    mounts     -- number of equal mounts that share the mass: k_v is that of all mounts, `measures` are those of one
    excitation -- kind of excitation with the amplitude F_0, a key of `EXCITED`
    damping    -- name of viscous damping, "zeta" or "c"
    sheet      -- the data of the mount, in the units of `SHEET`

    Values are numbers or quantities of pint. Raises ValueError for a scale that is not > 0.
    """

    m: float
    k_v: float
    L: float
    excitation: str = "force"
    damping: str = "zeta"
    mounts: int = 1
    sheet: Mapping[str, Any] = dataclasses.field(default_factory=dict, compare=False, repr=False)

    def __post_init__(self) -> None:
        for name, unit in (("m", "kg"), ("k_v", "N/m"), ("L", "m")):
            self.__dict__[name] = validate.number(name, si(name, getattr(self, name), unit), above=0.0)
        try:
            doubles = all(0 < value < math.inf for value in self.sizes.values())
        except OverflowError:  # a power of Python's numbers that NumPy would call infinite
            doubles = False
        if not doubles:
            raise Refused(
                f"m = {self.m:g}, k_v = {self.k_v:g}, L = {self.L:g}: not allowed together, out of the range of doubles"
            )

    @functools.cached_property
    def sizes(self) -> dict[str, Any]:
        """Scales by kind of number."""
        return sizes(m=self.m, k_v=self.k_v, L=self.L)

    @property
    def amplitude(self) -> str:
        """Kind of unit of the amplitude of the excitation."""
        return EXCITED[self.excitation][1]

    @property
    def of_oscillator(self) -> str:
        """Excitation of the dimensionless oscillator: an acceleration a of the base is a force m a on the mass."""
        return "force" if self.excitation == "acceleration" else self.excitation

    @functools.cached_property
    def measures(self) -> dict[str, tuple[str, Scale]]:
        """For each number of a design and its damping, by name: the mount's name, and the scale."""
        design = (
            OF_SPRINGS if "k_1" in self.sheet else dict(zip(ROD_SPRING.design_names, ROD_SPRING.scales, strict=True))
        )
        scales = design | {one.name: SCALES[one.name] for one in (*DAMPING, *DISSIPATION)}
        scales |= {"zeta": PURE} if self.damping == "zeta" else {}
        found = {}
        for name, scale in scales.items():
            word = NAMES.get(scale.letter) or self.symbol(name)
            count = self.mounts if word in PER_MOUNT else 1
            found[name] = word, scale._replace(factor=scale.factor / count)
        return found

    def of(self, scale: Scale) -> Any:
        """Return the size of a scale."""
        return size(scale, m=self.m, k_v=self.k_v, L=self.L)

    def over(self, name: str, value: Any, domain: Parameter, scale: Scale) -> float:
        """Make a number of a mount dimensionless. Raises ValueError, in the mount's terms, outside the domain."""
        size = self.of(scale)
        allowed = {bound: limit * size for bound, limit in domain.bounds.items()}
        return float(validate.number(name, value, **allowed) / size)

    def quantities(self, answer: Answer) -> Quantities:
        """Convert a dimensionless answer, and the answers in it, to SI units."""
        found = answer._content()
        entry = (*answer._entry_of()._fields, *answer._beside_of()) if isinstance(answer, Table) else ()
        if entry and "F_0" not in entry and np.ndim(found.get("F_0", 0.0)):
            entry += ("F_0",)
        return self.named({**{name: getattr(answer, name) for name in entry}, **found}, answer, entry)

    def symbol(self, name: str) -> str:
        """Return the symbol of a dimensionless number in messages with units."""
        return self.kind(name)[0]

    def unit(self, name: str) -> str:
        """Return the unit in which numbers of a name are shown, "" for none."""
        return SHOWN.get(self.kind(name)[1], "")

    def number(self, name: str, value: float, *, si: bool = False) -> float | str:
        """Convert a dimensionless number to the unit of printed answers, or to SI units; a load is the whole mass."""
        if name == "load":
            return f"{self.m:g}"
        kind = self.kind(name)[1]
        return float(value * self.sizes[kind]) / (1.0 if si else UNITS[kind][SHOWN[kind]])

    @contextlib.contextmanager
    def in_these_terms(self) -> Iterator[None]:
        """Report errors of the dimensionless oscillator in the symbols and units of the mount."""
        try:
            yield
        except (ValueError, ArithmeticError) as error:
            error.args = tuple(in_units(message, self) for message in error.args)
            raise

    def kind(self, name: str) -> tuple[str, str]:
        """Return the name in SI units of a dimensionless number, and its kind of unit; "" for none."""
        column = QUANTITIES.get(name)
        if column is None or column.kind != "amplitude":
            return (name, "") if column is None else (column.si or name, column.kind)
        letter, kind = EXCITED[self.excitation]
        return letter if name == "F_0" else letter + name[1:], kind

    def named(self, found: Mapping[str, Any], answer: Any, entry: tuple[str, ...] = ()) -> Quantities:
        """Convert dimensionless numbers by name to SI units, under the names of `kind`."""
        values: dict[str, Any] = {}
        units = {}
        for name, value in found.items():
            shown, kind = self.kind(name)
            values[shown] = self.quantities(value) if isinstance(value, Answer) else value
            if name == "message":
                values[shown] = in_units(value, self)
            if name == "load":
                values[shown], units[shown] = self.m, SHEET[name]
            elif kind:
                values[shown] = _times(value, self.sizes[kind])
                units[shown] = SI[kind]
        return Quantities(values, units, answer, tuple(self.kind(name)[0] for name in entry), self)

    def gradient(self, found: Gradient) -> Gradient:
        """Convert a gradient to SI units, with respect to a mount's data. Raises ValueError if these are not known.

        Answers and data of a mount are dimensionless numbers times powers of k_v, L and m (4): derivatives with respect
        to k_v, L and m account for both.
        """
        from slowflow.answers.gradient import Gradient  # here, not above: the first answer does without

        springs = "k_1" in self.sheet
        if not springs and found.by[: len(ROD_SPRING.design)] != ROD_SPRING.design_names:
            raise Refused(WITHOUT_PRELOAD)
        arguments = {"F_0": OF_KIND[self.amplitude], "Omega": SCALES["Omega"], "load": SCALES["F_0"]}
        known = self.measures | {name: (self.symbol(name), scale) for name, scale in arguments.items()}
        # factors of the densities of a table, the square of what excites over a frequency, and of its frequencies
        density = 2 * np.array(arguments["F_0"].powers) - arguments["Omega"].powers
        known |= {"psd_G": ("psd_G", PURE._replace(powers=tuple(density))), "psd_Omega": ("psd_f", SCALES["Omega"])}
        by, measures = zip(*(known[name] for name in found.by), strict=True)
        of, kinds = zip(*(self.kind(name) for name in found.of), strict=True)
        answers = [OF_KIND[kind] for kind in kinds]
        # a frequency is in turns, not in radians; a factor has no unit
        sizes = [self.sizes[kind] if kind else 1.0 for kind in kinds]
        sized = {"f": self.sizes["frequency"], "psd_G": 1.0, "psd_f": 1.0}
        units = [sized[name] if name in sized else self.of(one) for name, one in zip(by, measures, strict=True)]
        values, at, base, size_of, size_by = (
            np.stack([np.broadcast_to(np.asarray(one, dtype=float), found.status.shape) for one in numbers], axis=-1)
            for numbers in (found._values, found._at, [getattr(self, name) for name in BASE], sizes, units)
        )
        own, others = (np.array([one.powers for one in measured]) for measured in (answers, measures))
        by_base = values[..., np.newaxis] * own - (found.slopes * at[..., np.newaxis, :]) @ others
        slopes = np.concatenate(
            (found.slopes / size_by[..., np.newaxis, :], by_base / base[..., np.newaxis, :]), axis=-1
        )
        slopes *= size_of[..., np.newaxis]
        numbers: tuple[Any, ...] = (*np.moveaxis(at * size_by, -1, 0), *np.moveaxis(base, -1, 0))
        names = (*by, *BASE)
        slopes[..., names.index("k_v")] *= self.mounts
        numbers = tuple(one / self.mounts if name == "k_v" else one for name, one in zip(names, numbers, strict=True))
        if "load" in by:
            slopes, numbers = _by_masses(names, slopes, numbers)
        if springs:
            names, slopes, numbers = _by_springs(names, slopes, numbers)
        return Gradient(of, names, slopes, found.status.copy(), tuple(np.moveaxis(values * size_of, -1, 0)), numbers)


class ManyScales(Scales):
    """The scales of many mounts: arrays that broadcast, NaN where these are not > 0."""

    def __post_init__(self) -> None:
        with np.errstate(all="ignore"):
            base = {name: np.asarray(getattr(self, name), dtype=float) for name in BASE}
            made = (np.isfinite(value) & (value > 0) for value in (*base.values(), *sizes(**base).values()))
            allowed = functools.reduce(np.logical_and, made)
        self.__dict__.update({name: np.where(allowed, value, np.nan) for name, value in base.items()})

    def over(self, name: str, value: Any, domain: Parameter, scale: Scale) -> Any:
        """Make the numbers of mounts dimensionless; those outside the domain are not refused."""
        with np.errstate(all="ignore"):
            return np.asarray(value, dtype=float) / self.of(scale)

    def unit(self, name: str) -> str:
        """Return an empty text: messages about many mounts have no numbers."""
        return ""

    @functools.cached_property
    def by_entry(self) -> Self:
        """The scales with one more axis, of places or rows."""
        base: Any = {name: getattr(self, name)[..., np.newaxis] for name in BASE}
        return dataclasses.replace(self, **base)


def _by_springs(
    names: tuple[str, ...], slopes: Floats, numbers: tuple[Any, ...]
) -> tuple[tuple[str, ...], Floats, tuple[Any, ...]]:
    """Convert to derivatives by the data of `Duffing.physical`, of which k_v and L are none.

    A damping ratio and a loss factor refer to the first stiffness that is not 0: at a constant ratio the damping
    changes with it.
    """
    found, known = slopes.copy(), dict(zip(names, numbers, strict=True))
    softer: Any = True  # whether all stiffnesses before are 0
    for spring in SPRINGS:
        stiffness = np.where(softer & (known[spring] != 0), known[spring], np.inf)
        softer &= known[spring] == 0
        for ratio, power in (("zeta", 0.5), ("eta", 1.0)):
            if ratio in names:
                change = power * known[ratio] / stiffness
                found[..., names.index(spring)] += slopes[..., names.index(ratio)] * change[..., np.newaxis]
    kept = [k for k, name in enumerate(names) if name not in ("k_v", "L")]
    return tuple(names[k] for k in kept), found[..., kept], tuple(numbers[k] for k in kept)


def _by_masses(names: tuple[str, ...], slopes: Floats, numbers: tuple[Any, ...]) -> tuple[Floats, tuple[Any, ...]]:
    """Convert to derivatives by masses: `load` is the one that moves, m that which the vertical spring is preset for.

    Up to here `load` is a weight, g (load - m), and m the mass that moves.
    """
    weight, mass = names.index("load"), names.index("m")
    found, values = slopes.copy(), list(numbers)
    found[..., weight] = slopes[..., mass] + g * slopes[..., weight]
    found[..., mass] = -g * slopes[..., weight]
    values[weight], values[mass] = numbers[mass], numbers[mass] - numbers[weight] / g
    return found, tuple(values)
