"""Subject of sizing. Takes an oscillator or mount and parameter values; returns the answers of all these designs.

Parameters of a mount are varied in SI units; some, such as m or k_v, change the scales of the answers.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np

from slowflow.answers.answer import frozen
from slowflow.answers.physical_answers import Amplitude
from slowflow.answers.quantities import LETTERS, PURE, SHEET, SI, UNITS, Scales, si, size
from slowflow.answers.table import COLUMNS
from slowflow.averaged.batch_checks import full, lifting
from slowflow.averaged.batches import Batch
from slowflow.core import validate
from slowflow.core.mechanism import Floats
from slowflow.grid.many import Designs
from slowflow.off_centre.many import OffCentreDesigns
from slowflow.oscillators.isolator import Isolator, _averaged
from slowflow.oscillators.oscillator import Oscillator
from slowflow.oscillators.physical import Physical
from slowflow.oscillators.physical_designs import PhysicalDesigns
from slowflow.support.errors import Refused, WrongType
from slowflow_kernels import inertia, slow_flow
from slowflow_kernels.conventions import FoldKind, Status
from slowflow_kernels.domains import DISSIPATION

#: what can be asked of designs, and which column of `table` that is one of; a frequency is called with an f of a mount,
#: with an Omega of an oscillator
OF_ALL_FORCINGS = {"F_SN": "F_SN", "F_cr": "F_cr", "rest": "Omega"}
OF_FRICTION = {"break_loose": "break_loose", "sticking": "sticking"}
OF_FREQUENCIES = ("peak", "jump_up", "jump_down", "band", "isolation")
OF_MARGINS = {"of_SN": "of_SN", "of_cr": "of_cr"}
AT_A_FORCING = {**OF_MARGINS, "A_peak": "A", **dict.fromkeys(OF_FREQUENCIES, "Omega")}
AT_A_FREQUENCY = {"A": "A", "transmissibility": "transmissibility"}
IN_A_SPECTRUM = {f"{name}_spectrum": name for name in (*AT_A_FREQUENCY, *OF_MARGINS)}
#: and which rows of it are counted, by the column that tells
ROWS = {"rows_several": "motions", "rows_cross": "crosses", "rows_detach": "detaches", "rows_stick": "sticks"}
IN_A_SPECTRUM |= ROWS
IN_A_SHOCK = {"A_shock": "A", "a_shock": "a_max", "of_cr_shock": "of_cr"}
#: only under a load, only about the centre, and there only of an excitation by inertia, whose force rises with Omega
UNDER_A_LOAD = {"stroke": "u_max"}
ABOUT_THE_CENTRE = {"rests_within": "rests_within"}
OF_INERTIA = {"sticks": "Omega_sticks"}
COLUMN = OF_ALL_FORCINGS | OF_FRICTION | ABOUT_THE_CENTRE | AT_A_FORCING | OF_INERTIA | UNDER_A_LOAD
COLUMN |= AT_A_FREQUENCY | IN_A_SPECTRUM | IN_A_SHOCK

#: what a load spectrum is
PAIR = "({1}, {0}), the columns of a table"


#: of an oscillator without dimensions
UNSCALED = Scales(m=1.0, k_v=1.0, L=1.0)
#: laws of damping beside mu and zeta, by the names of their numbers, and a mount's word for mu_s
LAWS, STATIC = tuple(one.name for one in DISSIPATION), "static_friction"


class Measured(Amplitude[Any], total=False):
    """Conditions of a measurement: the amplitude of the excitation by name, or F_0; the frequency."""

    F_0: Any
    f: Any
    Omega: Any


class LoadCase(Measured, total=False):
    """A load case; the shock and the load spectrum are pairs."""

    shock: tuple[Any, Any] | None
    spectrum: tuple[Any, Any] | None


@dataclass(frozen=True)
class Load:
    """A load case, None for what is not specified; for a mount in SI units.

    forcing -- amplitude of the excitation
    frequency -- of the excitation
    shock   -- peak acceleration and duration of a half sine of the base
    spectrum -- frequencies and forcings of a load spectrum, row by row
    """

    forcing: float | None
    frequency: float | None
    shock: tuple[float, float] | None
    spectrum: tuple[Floats, Floats] | None = None


class Subject:
    """An oscillator or a mount whose numbers are varied.

    varied  -- names of those that are
    nominal -- the numbers that can be varied, by name, as they are
    answers -- names of what can be asked of it, and what they are among `COLUMN`
    loaded  -- whether it is under a load
    one_by_one -- whether few designs are asked: under a load, where each takes up to some tenths of a second, or with
               other laws of damping than mu and zeta
    excitation -- what the forcing is the amplitude of

    at      -- the load case; of a base its letter tells whether displacement or acceleration is meant

    Raises ValueError for what is no oscillator or has a force that is not odd, for a number that cannot be varied, and
    for a load of the other one.
    """

    def __init__(self, of: Any, varied: Iterable[str] = (), at: Mapping[str, Any] = MappingProxyType({})) -> None:
        self.at = {name: value for name, value in at.items() if value is not None}
        if unknown := self.at.keys() - LoadCase.__annotations__:
            raise WrongType(
                f"{min(unknown)!r} is not an argument: a load case has {', '.join(LoadCase.__annotations__)}"
            )
        if isinstance(of, Physical) and (forcing := {name: self.at[name] for name in LETTERS if name in self.at}):
            of, _ = of._excited(None, forcing)
        self.of = of
        self.mount = of if isinstance(of, Physical) else None
        oscillator = of.oscillator if isinstance(of, Physical) else of
        if not isinstance(oscillator, Oscillator):
            raise Refused(f"{of!r} is not allowed: it must be an oscillator, or a mount in SI units")
        # an isolator without preload is answered as a linear spring, which has none of its numbers
        named = isinstance(oscillator, Isolator)
        self.mechanism = _averaged(oscillator.given["force"]) if named else oscillator.model.mechanism
        self.excitation, self.loaded, self.contact = oscillator.excitation, oscillator.load != 0, oscillator.contact
        if not self.mechanism.odd:
            raise Refused(f"{of!r} is not allowed: its force is not odd")
        plain = {one: (one, PURE) for one in (*self.mechanism.design_names, "mu", "zeta", *LAWS)}
        known = plain if self.mount is None else self.mount.scales.measures
        #: names and sizes here of the numbers of a design, by their names there; under a load without other laws
        self._measures = {name: row for name, row in known.items() if not (self.loaded and name in LAWS)}
        self.mounts = 1 if self.mount is None else self.mount.scales.mounts
        self.nominal = self._numbers(oscillator)
        for name in varied:
            if name not in self.nominal:
                allowed = f"{', '.join(self.nominal)}{validate.meant(name, self.nominal)}"
                raise Refused(f"{name!r} cannot be varied: it must be one of {allowed}")
        # laws of damping beside mu and zeta that some design has
        self.laws = {*oscillator.model.laws.present, *(name for name in LAWS if name in varied)}
        self.one_by_one = self.loaded or bool(self.laws)
        letter = "Omega" if self.mount is None else "f"
        self.names = ("F_0", letter) if self.mount is None else (self.mount.scales.symbol("F_0"), letter)
        for what, own, names in zip(
            ("forcing", "frequency"), self.names, ((*LETTERS, "F_0"), ("f", "Omega")), strict=True
        ):
            if any(name != own for name in names if name in self.at):
                raise Refused(f"the {what} of {'a mount' if self.mount else 'an oscillator'} is {own}")
        others = ABOUT_THE_CENTRE if self.loaded else UNDER_A_LOAD
        others = others | (OF_INERTIA if self.loaded or self.excitation == "force" else {})
        others = others | (IN_A_SHOCK if "eta" in self.laws else {})
        kinds = {name: COLUMNS[column].kind for name, column in COLUMN.items() if name not in others}
        self.answers = {f"{letter}_{name}" if kind == "frequency" else name: name for name, kind in kinds.items()}
        if self.mount is not None:
            self.answers = {self.mount.scales.kind(name)[0]: plain for name, plain in self.answers.items()}

    def _numbers(self, oscillator: Oscillator) -> dict[str, float]:
        """What an oscillator was made from, a mount's in SI units; static friction only where it is given."""
        scales = UNSCALED if self.mount is None else self.mount.scales
        base = {name: getattr(scales, name) for name in ("m", "k_v", "L")}
        own = {word: getattr(oscillator, name) * size(scale, **base) for name, (word, scale) in self._measures.items()}
        if self.mount is None:
            return own | {name: oscillator.given[name] for name in ("load", "mu_s") if name in oscillator.given}
        if "k_1" in own:
            return {"m": base["m"], **own}
        # what moves is the load; m is what the vertical spring is preset for
        masses = {"load": base["m"], "m": float(si("m", self.mount.given["m"], "kg"))} if self.loaded else {}
        found: dict[str, float] = {**base, "k_v": base["k_v"] / scales.mounts, **masses, **own}
        if (static := self.mount.given.get(STATIC)) is not None:
            # as it was given: rounded, it may be less than friction
            found[STATIC] = max(float(si(STATIC, static, "N")), found["friction"])
        return found

    def name(self, plain: str) -> str:
        """Of a dimensionless number, as it can be varied."""
        return self._measures[plain][0]

    @property
    def amplitude(self) -> str:
        """Of which kind the forcing is."""
        return "force" if self.mount is None else self.mount.scales.amplitude

    def kind(self, answer: str) -> str:
        """Of an answer, a key of `UNITS`, "" of what has no unit."""
        kind = COLUMNS[COLUMN[self.answers[answer]]].kind
        return self.amplitude if kind == "amplitude" else kind

    def unit(self, answer: str) -> str:
        """Of an answer; "" without dimensions."""
        kind = self.kind(answer)
        return SI[kind] if self.mount and kind else ""

    def number(self, name: str, value: Any) -> Any:
        """A value of a number of the design, of a mount in SI units if it is a quantity of pint."""
        return si(name, value, SHEET[name]) if self.mount else value

    def ends(self, name: str, pair: Any) -> tuple[float, float]:
        """A range of a number of the design, of a mount in SI units. Raises ValueError for what is none."""
        low, high = validate.pair(name, pair, validate.LOW_AND_HIGH)
        return validate.window(name, (self.number(name, low), self.number(name, high)))

    def limit(self, answer: str, value: Any) -> Any:
        """A value of an answer, of a mount in SI units if it is a quantity of pint."""
        return si(answer, value, self.unit(answer)) if self.mount else value

    def measured(self) -> tuple[Any, Any]:
        """Forcing and frequency as they were given, None where they were not; of a mount in SI units."""
        forcing, frequency = (self.at.get(name) for name in self.names)
        if self.mount is None:
            return forcing, frequency
        return si(self.names[0], forcing, SI[self.amplitude]), si("f", frequency, "Hz")

    def load(self) -> Load:
        """The load case that was given."""
        names, unit, shock, spectrum = self.names, SI[self.amplitude], self.at.get("shock"), self.at.get("spectrum")
        forcing, frequency = (
            None if value is None else validate.number(name, value, above=0.0)
            for name, value in zip(names, self.measured(), strict=True)
        )
        pulse: Any = None if shock is None else validate.pair("shock", shock, "(acceleration, duration)")
        table: Any = None if spectrum is None else validate.pair("spectrum", spectrum, PAIR.format(*names))
        if self.mount:
            pulse = pulse and (si("shock[0]", pulse[0], "m/s^2"), si("shock[1]", pulse[1], "s"))
            table = table and (si("spectrum[0]", table[0], "Hz"), si("spectrum[1]", table[1], unit))
        if pulse is not None:
            pulse = tuple(validate.number(f"shock[{k}]", value, above=0.0) for k, value in enumerate(pulse))
        if table is not None:
            arrays = {
                f"spectrum[{k}]": validate.positive_array(f"spectrum[{k}]", value) for k, value in enumerate(table)
            }
            rows = validate.common_shape(arrays)
            table = tuple(np.broadcast_to(values, rows).ravel() for values in arrays.values())
            if not table[0].size:
                raise Refused("spectrum has no row")
        return Load(forcing, frequency, pulse, table)

    def answered(self, names: Iterable[str] | None, load: Load) -> list[str]:
        """The requested answers, by default all that the load allows.

        Raises ValueError for an unknown one, and for one that needs a forcing or a shock where there is none.
        """
        forcing, frequency = self.names
        missing = {} if load.frequency is not None else dict.fromkeys(AT_A_FREQUENCY, frequency)
        if load.forcing is None:
            missing |= dict.fromkeys((*AT_A_FORCING, *UNDER_A_LOAD, *OF_INERTIA, *AT_A_FREQUENCY), forcing)
        missing |= {} if load.shock is not None else dict.fromkeys(IN_A_SHOCK, "shock")
        missing |= {} if load.spectrum is not None else dict.fromkeys(IN_A_SPECTRUM, "spectrum")
        if names is None:
            return [name for name, plain in self.answers.items() if plain not in missing]
        for name in names:
            if name in IN_A_SHOCK:
                validate.is_in_time(name, self.laws)
            if name not in self.answers:
                allowed = f"{', '.join(self.answers)}{validate.meant(name, self.answers)}"
                raise Refused(f"{name!r} is not an answer: it must be one of {allowed}")
            if needed := missing.get(self.answers[name]):
                known = {"shock": "a shock of the base", "spectrum": "a load spectrum", frequency: "a frequency"}
                what = known.get(needed, "a forcing")
                raise Refused(f"{name} needs {what}: give {needed}")
        return list(names)

    def ask(self, values: Mapping[str, Any], names: Iterable[str], load: Load) -> dict[str, Floats]:
        """These answers of designs whose numbers are as given, arrays of one shape, and else nominal.

        NaN for what there is not, or for what is no design.
        """
        designs, mu_s, units = self.designs(values)
        shape = np.broadcast_shapes(*(np.shape(value) for value in values.values()))
        F_0 = None if load.forcing is None else np.broadcast_to(load.forcing / units[self.amplitude], shape)
        Omega = None if load.frequency is None else np.broadcast_to(load.frequency / units["frequency"], shape)
        pulse = load.shock and (load.shock[0] / units["acceleration"], load.shock[1] / units["time"])
        table = None
        if load.spectrum is not None:
            rows = zip(load.spectrum, (units["frequency"], units[self.amplitude]), strict=True)
            table = tuple(value / np.broadcast_to(unit, shape)[..., np.newaxis] for value, unit in rows)
        batch = _Batch(designs, mu_s, F_0, Omega, pulse, table)
        return {name: frozen(batch.answer(self.answers[name]) * units[self.kind(name)]) for name in names}

    def designs(self, values: Mapping[str, Any]) -> tuple[Any, Any, dict[str, Any]]:
        """Designs whose numbers are as given, arrays that broadcast, and else nominal.

        With mu_s of each, None where friction holds while it slides, and the size of what an answer of each kind is in.
        """
        numbers: dict[str, Any] = {**self.nominal, **values}
        shape = np.broadcast_shapes(*(np.shape(value) for value in numbers.values()))
        units: dict[str, Any] = dict.fromkeys((*UNITS, ""), 1.0)
        static, kinetic = numbers.pop(STATIC if self.mount else "mu_s", None), numbers[self.name("mu")]
        if self.mount is not None:
            # a load that is m moves nothing from the centre, and of batches only shocks know static friction
            without = (STATIC, *(["load"] if not self.loaded else []))
            others = {name: None for name in without if name in self.mount.given}
            # not by `many`, which warns: designs on trial may be far from the mount
            sheet = self.mount._changed({**numbers, **others})
            scales, numbers = PhysicalDesigns(self.mount._kind, sheet).dimensionless
            units = {**scales.sizes, "": 1.0}
        numbers = {name: value for name, value in numbers.items() if name not in LAWS or name in self.laws}
        arrays = {name: np.broadcast_to(np.asarray(value, dtype=float), shape) for name, value in numbers.items()}
        mu_s = None
        if static is not None:  # less of it than of the kinetic one is no design
            arrays["mu"] = np.where(np.less_equal(kinetic, static), arrays["mu"], np.nan)
            mu_s = np.maximum(arrays["mu"], np.broadcast_to(static * self.mounts / units["force"], shape))
        if self.loaded:
            loads = {**arrays, "load": arrays.pop("load")}
            return OffCentreDesigns(self.mechanism, loads, self.excitation), mu_s, units
        return Designs(self.mechanism, arrays, self.excitation, self.contact), mu_s, units


class _Batch:
    """Answers to a batch of designs, each question once; mu_s is None where static friction equals the kinetic one."""

    def __init__(self, designs: Any, mu_s: Any, F_0: Any, Omega: Any, pulse: Any, table: Any) -> None:
        self.designs, self.F_0, self.Omega, self.pulse, self.table = designs, F_0, Omega, pulse, table
        self.mu = np.asarray(designs.values["mu"], dtype=float)
        self.mu_s, self.holds = mu_s, self.mu if mu_s is None else mu_s
        self.cache: dict[Callable[..., Any], Any] = {}

    def _ask(self, question: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
        if question not in self.cache:
            self.cache[question] = question(*arguments, **named)
        return self.cache[question]

    def answer(self, name: str) -> Floats:
        """One of `COLUMN`, dimensionless."""
        if name in OF_MARGINS:
            with np.errstate(over="ignore"):  # of a forcing next to nothing no margin is a double
                return np.asarray(self.answer(f"F_{name[3:]}") / self.F_0)
        if name in IN_A_SPECTRUM:
            return self._in_a_spectrum(name)
        if name == "sticking":
            return np.asarray(slow_flow.friction(self.mu))
        if name == "break_loose":
            return self.holds
        if name == "rests_within":
            designs = Designs(
                self.designs.mechanism, {**self.designs.values, "mu": self.holds}, contact=self.designs.contact
            )
            return np.asarray(designs.at_rest().rests_within)
        if name == "sticks":
            with np.errstate(all="ignore"):  # what is no design does not stick
                return np.asarray(inertia.moves_from(self.F_0, slow_flow.friction(self.mu)))
        if name == "F_SN":
            onsets = self._ask(self.designs.saddle_node_onset)
            lowest = np.where(onsets.status == Status.NONE, math.inf, onsets.F_SN)
            # folds below it end at Omega = 0; under a load the onset is undecided then
            return np.where(getattr(onsets, "at_rest", False), np.nan, lowest)
        if name == "F_cr" and "load" in self.designs.values and self.designs.excitation != "force":
            # where there is none it may be tended to as Omega rises, at what is not known of batches
            return np.asarray(self._ask(self.designs.detachment).F_cr)
        if name == "F_cr":
            return lifting(self.designs, self._ask(self.designs.detachment))
        if name == "rest" and "load" in self.designs.values:
            return np.sqrt(self._where_it_rests("stiffness"))
        if name == "stroke":
            peaks = self._ask(self.designs.peak, self.F_0)
            largest = np.where(peaks.status == Status.UNBOUNDED, math.inf, peaks.u_max)
            return np.where(peaks.status == Status.STICKS, np.abs(self._where_it_rests("u")), largest)
        if name == "rest":
            with np.errstate(all="ignore"):  # what is no design has no frequency
                flow = self.designs._flow
                stiffness = -np.asarray(flow.mechanism.at_rest(*flow.parameters)[1])
                return np.sqrt(np.where(stiffness > 0, stiffness, np.nan))
        if name == "isolation":
            return np.asarray(self._ask(self.designs.isolation, self.F_0).Omega)
        if name == "band":
            bands = self._ask(self.designs.hysteresis, self.F_0)
            width = np.nansum(bands.Omega_high - bands.Omega_low, axis=-1)
            return np.where(np.isin(bands.status, (Status.OK, Status.STICKS)), width, np.nan)
        if name in AT_A_FREQUENCY:
            states = self._ask(self.designs.amplitudes, Omega=self.Omega, F_0=self.F_0)
            return _of_the_largest(states, name)
        if name in IN_A_SHOCK:
            peak, span = self.pulse
            shock = self._ask(self.designs._ask, "shock_spectrum", acceleration=peak, duration=span, mu_s=self.mu_s)
            if name == "of_cr_shock":
                with np.errstate(all="ignore"):
                    return np.asarray(self.designs._flow.first_end / shock.A)
            return np.asarray(shock.A if name == "A_shock" else shock.a_max)
        if name in ("A_peak", "peak"):
            peaks = self._ask(self.designs.peak, self.F_0)
            if name == "peak":
                return np.asarray(peaks.Omega)
            bounded = np.where(peaks.status == Status.UNBOUNDED, math.inf, peaks.A)
            if self.designs.excitation != "force" and self.F_0 is not None:
                bounded = np.where(peaks.status == Status.NONE, full(self.designs, self.F_0), bounded)
            return np.where(peaks.status == Status.STICKS, 0.0, bounded)
        return first_jump(self._ask(self.designs.saddle_nodes, self.F_0), name == "jump_up")

    def _in_a_spectrum(self, name: str) -> Floats:
        """One of `IN_A_SPECTRUM`: the largest of all rows, or how many; NaN where one of these is not known."""
        Omega, F_0 = self.table
        if name.removesuffix("_spectrum") in OF_MARGINS:
            largest = np.asarray(F_0).max(axis=-1)
            return np.asarray(self.answer(f"F_{name.removesuffix('_spectrum')[3:]}") / largest)
        rows = self._ask(self.designs.spectrum, Omega=Omega, F_0=F_0)
        known = np.isin(rows.status, (Status.OK, Status.STICKS, Status.NONE)).all(axis=-1)
        if name == "A_spectrum":
            return np.asarray(rows.A.max(axis=-1))
        if name == "transmissibility_spectrum":
            return np.asarray(10 ** (rows.transmissibility_dB.max(axis=-1) / 20))
        counted = np.asarray(getattr(rows, ROWS[name])) > (1 if name == "rows_several" else 0)
        return np.where(known, counted.sum(axis=-1), np.nan)

    def _where_it_rests(self, column: str) -> Floats:
        """Of the place of rest, if one only is stable; else NaN."""
        equilibria = self._ask(self.designs.rest)
        stable = equilibria.stiffness > 0
        (first,) = np.take_along_axis(getattr(equilibria, column), stable.argmax(axis=-1)[..., np.newaxis], -1).T
        return np.where(stable.sum(axis=-1) == 1, first.T, np.nan)


def _of_the_largest(states: Batch, name: str) -> Floats:
    """Of the stable state with the largest amplitude, at rest where the mass sticks; NaN where there is none."""
    A = np.where(states.stable == 1, states.A, -math.inf)
    largest = np.argmax(A, axis=-1)[..., np.newaxis]
    found = np.take_along_axis(np.asarray(getattr(states, name)), largest, -1)[..., 0]
    return np.where(A.max(axis=-1) >= 0, found, np.nan)


def first_jump(folds: Batch, up: bool) -> Floats:
    """The lowest fold that is left upwards, or the highest that is left downwards; NaN where there is none."""
    kinds = (FoldKind.JUMP_UP, FoldKind.JUMP_UP_AT_CORNER) if up else (FoldKind.JUMP_DOWN, FoldKind.JUMP_DOWN_AT_CORNER)
    there = np.isin(folds.kind, kinds)
    sign = 1.0 if up else -1.0
    first = sign * np.where(there, sign * folds.Omega, math.inf).min(axis=-1)
    return np.where(there.any(axis=-1), first, np.nan)
