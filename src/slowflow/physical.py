"""Oscillators in newtons, metres and hertz. Takes a dimensionless one and its `Scales`; returns `Quantities`.

Questions take SI units, or quantities of pint, and are asked of the dimensionless oscillator: the table of columns has
the dimensionless name and the kind of each number, `slowflow.quantities` what it is measured in.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from slowflow import range_checks, validate
from slowflow.answer import joined
from slowflow.averaged.plan import Plan
from slowflow.measurements import Columns
from slowflow.mechanism import Floats
from slowflow.quantities import DENSITIES, DRAWN, EXCITED, OF_A_BASE, SI, UNITS, Quantities, Scales, g, si
from slowflow.support.errors import OutOfRange, Refused, WrongType
from slowflow.table import QUANTITIES
from slowflow.text import in_units

if TYPE_CHECKING:
    from typing import Unpack

    from slowflow import physical_answers as answers
    from slowflow.physical_answers import Amplitude, Amplitudes, Number, Numbers, Window

#: dimensionless names of what is called otherwise here
PLAIN = {column.si: column.name for column in QUANTITIES.values() if column.si}
#: what is said of numbers that look as if they were in another unit
REMARKS = {"f": range_checks.of_frequency, "duration": range_checks.of_duration}
#: what A is of a motion that is not about the centre
LARGEST = "A is the largest |x|, the mean displacement included: x_max of an averaged motion"


@functools.cache
def _takes(question: Any) -> Mapping[str, inspect.Parameter]:
    """What a dimensionless question takes."""
    return inspect.signature(question).parameters


@dataclass(frozen=True, repr=False)
class Physical:
    """An oscillator whose questions take forces in N, frequencies f in Hz and lengths in m, and are answered in these.

    A question takes the amplitude of its excitation first, or by its letter: a force F in N, the displacement Y of the
    base in m or its acceleration a in m/s^2, an unbalance U, the mass that turns times its radius, in kg m. Answers
    have it by that letter, and what is called F_SN and F_cr of a force as Y_SN, a_cr, ... Of a mount that its base
    shakes each question takes a or Y, whichever its `excitation` says: the motion relative to the base is that under a
    force m a, whatever the frequency.

    oscillator -- the dimensionless one, which is asked
    scales     -- what its numbers are measured in
    given      -- what it was made from, for `replace`

    It does not change. Arguments may be quantities of pint too. What is asked, and what is raised, is the oscillator's.
    """

    oscillator: Any
    scales: Scales
    given: Mapping[str, Any] = dataclasses.field(compare=False)

    def __repr__(self) -> str:
        arguments = ", ".join(f"{name}={value!r}" for name, value in self.given.items())
        return f"{type(self.oscillator).__name__}.physical({arguments})"

    def replace(self, **changes: Any) -> Physical:
        """Another one with some of the numbers changed that this one was made from, by name."""
        kept = dict(self.given)
        for one, other in (("c", "zeta"), ("zeta", "c")):  # they say the same
            if one in changes:
                kept.pop(other, None)
        return type(self.oscillator).physical(**{**kept, **changes})

    def at_rest(self) -> answers.AtRest:
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
        found = self._answer("at_rest")
        beyond = None if found.x_cr is None else k_v * found.x_cr / g
        values = {
            "f_n": self.scales.sizes["frequency"],
            **found.values,
            "preset": m * g / k_v,
            "lightest": None if beyond is None or beyond >= m else m - beyond,
            "heaviest": None if beyond is None else m + beyond,
        }
        units = {"f_n": "Hz", **found.units, "preset": "m", "lightest": "kg", "heaviest": "kg"}
        return cast("answers.AtRest", Quantities(values, units, found.answer))

    def sag(self, load: Number) -> float:
        """How far from the centre a mass in kg would rest, in m, when k_v is preset for m: the force is (5)."""
        load = validate.number("load", si("load", load, "kg"), above=0.0)
        preset = float(si("m", self.given["m"], "kg"))
        weight = (load - preset) * g / self.scales.sizes["force"]
        # here, not above: `import slowflow` does without SciPy
        from scipy.optimize import brentq

        force = self.oscillator.restoring_force("untruncated")
        far = abs(weight) + 1.0 + (force.breakpoints[-1] if force.breakpoints else 0.0)
        u = float(brentq(lambda u: math.copysign(force.value(abs(u)), u) - weight, -far, far))
        return u * self.scales.sizes["length"]

    # ---- the questions

    def rest(self) -> answers.Rows:
        """Every place at which the mass rests without friction: .x .stable .load, see `Oscillator.rest`."""
        return self._answer("rest")

    def force(self, x: Numbers) -> Floats:
        """The restoring force in N at displacements in m, without the weight that k_v is preset for."""
        return np.asarray(self._ask("force", x=x) * self.scales.sizes["force"])

    def stiffness(self, x: Numbers) -> Floats:
        """Its slope in N/m."""
        return np.asarray(self._ask("stiffness", x=x) * self.scales.sizes["stiffness"])

    def saddle_node_onset(self) -> answers.One:
        """The lowest force amplitude that has a fold: .F_SN .f .A, see `Averaged.saddle_node_onset`."""
        return self._answer("saddle_node_onset")

    def detachment(self) -> answers.One:
        """The lowest force amplitude that reaches the stroke: .F_cr .f_cr .x_cr, see `Averaged.detachment`."""
        return self._answer("detachment")

    def saddle_nodes(self, amplitude: Number | None = None, /, **at: Unpack[Amplitude]) -> answers.AtOne:
        """Where a sweep jumps at the force amplitude F: .f .A .kind .corner, see `Averaged.saddle_nodes`."""
        return self._answer("saddle_nodes", amplitude, at)

    def peak(self, amplitude: Number | None = None, /, **at: Unpack[Amplitude]) -> answers.One:
        """The highest peak: .A .f, see `Averaged.peak`; under a load .x_max at .f_max as well, see `OffCentre.peak`."""
        return self._answer("peak", amplitude, at)

    def amplitudes(self, *, f: Numbers, **at: Unpack[Amplitudes]) -> answers.States:
        """Every steady state at f: .f .A .phi .stable .transmissibility_dB, see `Averaged.amplitudes`.

        Under a load .A is the amplitude about the mean displacement .B, and .x_max the largest |x|, |B| + A.
        """
        return self._answer("amplitudes", None, at, f=f)

    def frequency_response(
        self,
        amplitude: Number | None = None,
        /,
        *,
        f: Window | None = None,
        samples: int = 1000,
        **at: Unpack[Amplitude],
    ) -> answers.AtOne:
        """The response curve for frequencies in the window f, of up to twice f_n without: `amplitudes` and .branch."""
        return self._answer("frequency_response", amplitude, at, f=f, samples=samples)

    def fold_locus(self, *, samples: int = 1000, A_max: Number | None = None) -> answers.AtEach:
        """The folds of every force amplitude: .f .A .F .branch, see `Averaged.fold_locus`."""
        return self._answer("fold_locus", samples=samples, A_max=A_max)

    def cusps(self, *, A_max: Number | None = None) -> answers.AtEach:
        """Where two folds come into being or meet: .F .f .A .minimum, see `Averaged.cusps`."""
        return self._answer("cusps", A_max=A_max)

    def isola_points(self, *, A_max: Number | None = None) -> answers.AtEach:
        """Where isolated curves are born or merge: .F .f .A .kind, see `Averaged.isola_points`."""
        return self._answer("isola_points", A_max=A_max)

    @property
    def sticking_forcing(self) -> float:
        """The amplitude of the excitation that leaves a mass at rest at every frequency, see `Averaged`."""
        return self.oscillator.sticking_forcing * self.scales.sizes[self.scales.amplitude]

    def transmissibility_floor(self, amplitude: Number | None = None, /, **at: Unpack[Amplitude]) -> float:
        """What the ratio that is transmitted tends to as f rises without end, see `Averaged.transmissibility_floor`."""
        one, F_0 = self._excited(amplitude, at)
        return float(one._ask("transmissibility_floor", F_0=F_0))

    def backbone(self, A: Numbers) -> Floats:
        """f in Hz on the backbone at amplitudes in m, see `Averaged.backbone`."""
        return np.asarray(self._ask("backbone", A=A) * self.scales.sizes["frequency"])

    def limit_envelope(self, *, f: Numbers, **at: Unpack[Amplitudes]) -> Floats:
        """The amplitude in m that no response exceeds, see `Averaged.limit_envelope`."""
        one, F_0 = self._excited(None, at)
        return np.asarray(one._ask("limit_envelope", f=f, F_0=F_0) * self.scales.sizes["length"])

    def certify(
        self, amplitude: Number | None = None, /, *, f: Number | None = None, **at: Unpack[Amplitude]
    ) -> answers.Certificate:
        """What is proved at a force amplitude: see `Averaged.certify`.

        Of the dimensionless numbers as they are: `.answer` has the intervals that are proved, and these are the same
        times what is measured in, rounded.
        """
        return self._answer("certify", amplitude, at, f=f)

    def steady_state(
        self,
        *,
        f: Number,
        A: Number | None = None,
        samples: int = 400,
        x_0: Number | None = None,
        v_0: Number = 0.0,
        **at: Unpack[Amplitude],
    ) -> answers.SteadyState:
        """One periodic motion of the equation of motion: .A .stops .stable .period, and .t .x .v over one period.

        x_0, v_0 -- displacement in m and velocity in m/s at the beginning, in place of A

        .A is the largest |x|; under a load that is what `amplitudes` calls .x_max, and .message says so. See
        `Oscillator.steady_state`, which `.answer` is from.
        """
        one, F_0 = self._excited(None, at)
        found = one._ask("steady_state", f=f, F_0=F_0, A=A, x_0=x_0, v_0=v_0)
        message = joined("" if self.oscillator.load == 0 else LARGEST, found.message)
        series = dict(zip(("tau", "u", "v"), found.series(samples), strict=True))
        names = ("Omega", "A", "stops", "stable", "period")
        return cast("answers.SteadyState", one._named(found, (), *names, F_0=found.F_0, message=message, **series))

    def exact_response(
        self,
        amplitude: Number | None = None,
        /,
        *,
        f: Window | None = None,
        start: Quantities | None = None,
        step: float = 0.02,
        x_0: Number | None = None,
        v_0: Number = 0.0,
        **at: Unpack[Amplitude],
    ) -> answers.Response:
        """The curve of the equation of motion: .f .A .stable .stops, and .folds; see `Oscillator.exact_response`.

        start    -- what `steady_state` gave
        x_0, v_0 -- as in `steady_state`, in place of it
        """
        if not (start is None or isinstance(start, Quantities)):
            raise Refused(f"start = {start!r} is not allowed: start must be what steady_state gave")
        begun = None if start is None else start.answer
        one, F_0 = self._excited(amplitude, at)
        found = one._ask("exact_response", F_0=F_0, f=f, start=begun, step=step, x_0=x_0, v_0=v_0)
        columns: dict[str, Any] = {"Omega": float, "A": float, "kind": str, "corner": bool}
        folds = {name: np.array([getattr(one, name) for one in found.folds], of) for name, of in columns.items()}
        curve = one._named(found, ("Omega", "A", "stable", "stops"), "F_0", "closed", "message", "complete")
        values = {**curve.values, "folds": self.scales.named(folds, found.folds, tuple(columns))}
        return cast("answers.Response", dataclasses.replace(curve, values=values))

    def sweep(
        self, *, f: Numbers, x_0: Number | None = None, v_0: Number = 0.0, **at: Unpack[Amplitude]
    ) -> answers.AtOne:
        """What an experiment sees that steps through frequencies: .f .A .stops .settled, and .jumps in Hz.

        x_0, v_0 -- as in `steady_state`

        See `Oscillator.sweep`.
        """
        one, F_0 = self._excited(None, at)
        found = one._ask("sweep", f=f, F_0=F_0, x_0=x_0, v_0=v_0)
        jumps = np.array(found.jumps).reshape(-1, 2)
        entry = ("Omega", "A", "stops", "settled")
        return cast("answers.AtOne", one._named(found, entry, "F_0", "message", jumps=jumps))

    def transient(
        self,
        *,
        acceleration: Numbers | None = None,
        duration: Number | None = None,
        t: Numbers | None = None,
        after: Number | None = None,
        samples: int = 400,
        x_0: Number | None = None,
        v_0: Number = 0.0,
    ) -> answers.Transient:
        """A shock of the base, or a release: .A .a_max .detaches .rests, and .t .x .v .a .base over time.

        acceleration -- of the base, in m/s^2: the peak of a half sine, or the samples of a record
        duration     -- of the half sine, in s
        t            -- the times of the samples instead, in s
        after        -- for how long the free motion is followed that comes then, in s
        samples      -- points over time
        x_0, v_0     -- displacement in m and velocity in m/s at the beginning, seen from the base

        See `Oscillator.transient`, which `.answer` is from.
        """
        pulse = {"acceleration": acceleration, "duration": duration, "t": t, "after": after}
        found = self._ask("transient", **pulse, x_0=x_0, v_0=v_0)
        names = (field.name for field in dataclasses.fields(found) if field.repr)
        return cast("answers.Transient", self._named(found, (), *names, **found.series(samples)._asdict()))

    def shock_spectrum(self, *, acceleration: Numbers, duration: Numbers) -> answers.Rows:
        """What half sines of the base do: .acceleration .duration .A .a_max .ratio .detaches, a row for each.

        In m/s^2 and s, numbers or arrays that broadcast; see `Oscillator.shock_spectrum`.
        """
        return self._answer("shock_spectrum", acceleration=acceleration, duration=duration)

    def random(self, *, psd: tuple[Numbers, Numbers] | Columns, unit: str = "g^2/Hz") -> answers.Random:
        """Stationary random vibration: .x_rms .v_rms .a_rms, .f_e .damping, .beyond, see `Oscillator.random`.

        psd  -- frequencies in Hz and one-sided densities, straight in log-log between these, 0 outside; or
                the columns f and G of a file, see `slowflow.measurements`, whose head has the unit
        unit -- of the densities: "g^2/Hz" or "(m/s^2)^2/Hz" of the base's acceleration, "N^2/Hz" of a force
        """
        if isinstance(psd, Columns):
            if missing := {"f", "G"} - psd.keys():
                raise Refused(f"psd needs the columns f and G: {min(missing)} is missing")
            unit, psd = psd.units.get("G", unit), (psd["f"], psd["G"])
        of_unit, kind = DENSITIES[validate.choice("unit", unit, tuple(DENSITIES))]
        f, G = validate.two_rows("psd", psd, "frequencies in Hz and densities")
        sizes = self.scales.sizes
        at = validate.positive_array("f", si("f", f, "Hz")) / sizes["frequency"]
        density = validate.positive_array("G", G) * (of_unit / sizes[kind]) ** 2 * sizes["frequency"]
        with self.scales.in_these_terms():
            found = self.oscillator.random(psd=(at, density))
        return cast("answers.Random", self.scales.quantities(found))

    def margins(self, amplitude: Number | None = None, /, **at: Unpack[Amplitude]) -> answers.One:
        """How far a force amplitude is from F_SN and F_cr: .of_SN .of_cr, see `Oscillator.margins`."""
        return self._answer("margins", amplitude, at)

    def hysteresis(self, amplitude: Number | None = None, /, **at: Unpack[Amplitude]) -> answers.AtOne:
        """Bands with several stable motions: .f_low .f_high .motions, see `Oscillator.hysteresis`."""
        return self._answer("hysteresis", amplitude, at)

    def isolation(
        self, amplitude: Number | None = None, /, level_dB: float = 0.0, **at: Unpack[Amplitude]
    ) -> answers.One:
        """The frequency from which on less than F is transmitted: .f .A, see `Oscillator.isolation`."""
        return self._answer("isolation", amplitude, at, level_dB=level_dB)

    def spectrum(self, *, f: Numbers, **at: Unpack[Amplitudes]) -> answers.AtEach:
        """A load spectrum, row by row, see `Oscillator.spectrum`."""
        return self._answer("spectrum", None, at, f=f)

    def plot(
        self,
        amplitude: Numbers | None = None,
        /,
        *,
        f: Window | None = None,
        of: str = "A",
        ax: Any = None,
        **at: Unpack[Amplitudes],
    ) -> Any:
        """Draw the response at one amplitude, or at each of several, into Matplotlib axes, or new ones; return these.

        f  -- the window of frequencies, up to twice f_n without
        of -- what is drawn over frequency, in Hz: "A", in mm, under a load .x_max; "phi" or "transmissibility_dB"

        Signs and tints as of `Averaged.plot`. Raises ValueError for another word, ImportError without Matplotlib.
        """
        from slowflow import pictures

        validate.choice("of", of, DRAWN)
        one, F_0 = self._excited(amplitude, at)
        letter = one.scales.symbol("F_0")
        forces = validate.several(letter, si(letter, F_0, SI[one.scales.amplitude]))
        answers = ((one.frequency_response(force, f=f), one.saddle_nodes(force)) for force in forces)
        found = [(curve.in_units(), folds.in_units()) for curve, folds in answers]
        drawn = pictures.height(found[0][0]) if of == "A" else of
        ax = pictures.responses(ax, found, drawn)
        window = validate.WINDOW if f is None else self._window(f)
        ax.set_xlim(*(end * self.scales.sizes["frequency"] for end in window))
        if of == "A":
            length = self.scales.sizes["length"] / UNITS["length"]["mm"]
            pictures.breakpoints(ax, [length * end for end in self.oscillator.breakpoints], "x")
        if drawn == "A":
            pictures.stopping(ax, self.oscillator.mu * length * self.scales.sizes["frequency"] ** 2)
        pictures.legend(ax, pictures.axis(found[0][0], letter))
        return ax

    def explain(self, question: str, amplitude: Number | None = None, /, **at: Unpack[Amplitude]) -> Plan:
        """What runs for a question and what is skipped, see `Averaged.explain`."""
        one, F_0 = self._excited(amplitude, at) if at or amplitude is not None else (self, None)
        found = one._ask("explain", question=question, F_0=F_0)
        steps = tuple(dataclasses.replace(step, why=in_units(step.why, one.scales)) for step in found.steps)
        letter, unit = one.scales.symbol("F_0"), SI[one.scales.amplitude]
        where = "" if F_0 is None else f" at {letter} = {si(letter, F_0, unit):g} {unit}"
        return dataclasses.replace(found, steps=steps, where=where)

    @property
    def second_approximation(self) -> Physical:
        """The same questions, those that it answers, with the higher harmonics of force and friction."""
        with self.scales.in_these_terms():
            return Physical(self.oscillator.second_approximation, self.scales, self.given)

    # ---- arguments

    def _excited(self, amplitude: Any, at: Mapping[str, Any]) -> tuple[Physical, Any]:
        """The mount that an amplitude is of, first or by its letter, and that; of a base by a or Y, whichever it is."""
        if amplitude is not None and not at:
            return self, amplitude
        own = self.scales.excitation
        allowed = OF_A_BASE if own in OF_A_BASE else (own,)
        for one in allowed:
            if amplitude is None and at.keys() == {letter := EXCITED[one][0]}:
                return (self if one == own else self._by_other_base), at[letter]
        known = " or ".join(f"{letter} in {SI[kind]}" for letter, kind in map(EXCITED.__getitem__, allowed))
        found = ", ".join((*([] if amplitude is None else [EXCITED[own][0]]), *at)) or "none"
        raise WrongType(f"the amplitude of the excitation is needed once, {known}: got {found}")

    @functools.cached_property
    def _by_other_base(self) -> Physical:
        """The same mount with its base's acceleration given in place of its displacement, or the other way."""
        (other,) = {*OF_A_BASE} - {self.scales.excitation}
        scales, of = dataclasses.replace(self.scales, excitation=other), self.oscillator
        oscillator = getattr(of, "first", of).replace(excitation=scales.of_oscillator)
        oscillator = oscillator.second_approximation if hasattr(of, "first") else oscillator
        return Physical(oscillator, scales, {**self.given, "excitation": other})

    def _answer(
        self, question: str, amplitude: Any = None, at: Mapping[str, Any] | None = None, /, **arguments: Any
    ) -> Any:
        """The answer in SI units; at an amplitude of the excitation where `at` is given."""
        if at is None:
            return self.scales.quantities(self._ask(question, **arguments))
        one, F_0 = self._excited(amplitude, at)
        return one._answer(question, F_0=F_0, **arguments)

    def _named(self, found: Any, entry: tuple[str, ...], *names: str, **more: Any) -> Quantities:
        """Numbers of an answer by name, those of an entry first, in SI units."""
        return self.scales.named({**{name: getattr(found, name) for name in (*entry, *names)}, **more}, found, entry)

    def _ask(self, question: str, /, **arguments: Any) -> Any:
        """The dimensionless answer; refusals are in newtons, metres and hertz, as the query is.

        What the question takes without dimensions, says its method: one number, an array of them or a window.
        """
        method = getattr(self.oscillator, question)
        takes, at = _takes(getattr(method, "__func__", method)), {}
        for name, value in arguments.items():
            plain = PLAIN.get(name, name)
            shown, kind = self.scales.kind(plain)
            if value is None and takes[plain].default is not inspect.Parameter.empty:
                continue
            if kind and takes[plain].annotation.startswith("tuple"):
                value = self._window(value)
            elif kind:
                value = self._number(shown, value, kind, several=not takes[plain].annotation.startswith("float"))
            at[plain] = value
        with self.scales.in_these_terms():
            return method(**at)

    def _number(self, name: str, value: Any, kind: str, *, several: bool) -> Any:
        """A number, or an array of them, over what it is measured in."""
        value, size = si(name, value, SI[kind]), self.scales.sizes[kind]
        above = 0.0 if name in (self.scales.symbol("F_0"), "f") else -math.inf
        if validate.is_single(value) or not several:
            number: Any = validate.number(name, value, above=above)
        else:
            number = validate.finite_array(name, value, positive=above == 0)
        with np.errstate(over="ignore"):
            found = number / size
        if not np.isfinite(found).all():
            raise OutOfRange(f"{name} = {value!r} is too large: over {size:.6g} it leaves the range of doubles")
        if name in REMARKS and np.size(found):
            range_checks.warn(REMARKS[name](float(np.max(found)) * size, self.scales.sizes["frequency"]), stacklevel=5)
        return found

    def _window(self, f: Any) -> tuple[float, float]:
        """Of frequencies, as the oscillator takes it."""
        low, high = validate.pair("f", f, "of frequencies (low, high)")
        low, high = validate.window("f", (si("f[0]", low, "Hz"), si("f[1]", high, "Hz")))
        return low / self.scales.sizes["frequency"], high / self.scales.sizes["frequency"]
