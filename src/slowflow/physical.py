"""Oscillators in newtons, metres and hertz: in go a dimensionless one and its `Scales`, out come `Quantities`.

Questions take SI units, or quantities of pint, and are asked of the dimensionless oscillator: `slowflow.quantities` has
what a number is measured in, and what an answer with units is.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from slowflow import plausible, validate
from slowflow.answer import joined
from slowflow.averaged.plan import Plan
from slowflow.mechanism import Floats
from slowflow.physical_moves import g
from slowflow.quantities import DRAWN, EXCITED, UNITS, Quantities, Scales, si, turns
from slowflow.text import in_units
from slowflow_support.errors import OutOfRange, Refused
from slowflow_support.frozen import dataclass

if TYPE_CHECKING:
    from slowflow import physical_answers as answers
    from slowflow.physical_answers import Number, Numbers, Window

#: what A is of a motion that is not about the centre
LARGEST = "A is the largest |x|, the mean displacement included: x_max of an averaged motion"


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
        found = self._answer(self.oscillator.at_rest)
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

    def rest(self) -> answers.RestPositions:
        """Every place at which the mass rests without friction: .x .stable .load, see `Oscillator.rest`."""
        return self._answer(self.oscillator.rest)

    def force(self, x: Numbers) -> Floats:
        """The restoring force in N at displacements in m, without the weight that k_v is preset for."""
        return np.asarray(self._ask(self.oscillator.force, self._length("x", x)) * self.scales.sizes["force"])

    def stiffness(self, x: Numbers) -> Floats:
        """Its slope in N/m."""
        return np.asarray(self._ask(self.oscillator.stiffness, self._length("x", x)) * self.scales.k_v)

    def saddle_node_onset(self) -> answers.Onset:
        """The lowest force amplitude that has a fold: .F_SN .f .A, see `Averaged.saddle_node_onset`."""
        return self._answer(self.oscillator.saddle_node_onset)

    def detachment(self) -> answers.Detachment:
        """The lowest force amplitude that reaches the stroke: .F_cr .f_cr .x_cr, see `Averaged.detachment`."""
        return self._answer(self.oscillator.detachment)

    def saddle_nodes(self, F: Number) -> answers.Folds:
        """Where a sweep jumps at the force amplitude F: .f .A .kind .corner, see `Averaged.saddle_nodes`."""
        return self._answer(self.oscillator.saddle_nodes, self._amplitude(F))

    def peak(self, F: Number) -> answers.Peak:
        """The highest peak: .A .f, see `Averaged.peak`; under a load .x_max at .f_max as well, see `OffCentre.peak`."""
        return self._answer(self.oscillator.peak, self._amplitude(F))

    def amplitudes(self, *, f: Numbers, F: Numbers) -> answers.States:
        """Every steady state at f: .f .A .phi .stable .transmissibility_dB, see `Averaged.amplitudes`.

        Under a load .A is the amplitude about the mean displacement .B, and .x_max the largest |x|, |B| + A.
        """
        Omega, F_0 = self._frequencies(f), self._amplitudes(F)
        return self._answer(self.oscillator.amplitudes, Omega=Omega, F_0=F_0)

    def frequency_response(self, F: Number, *, f: Window | None = None, samples: int = 1000) -> answers.Curve:
        """The response curve for frequencies in the window f, of up to twice f_n without: `amplitudes` and .branch."""
        window = self._window(f)
        return self._answer(self.oscillator.frequency_response, self._amplitude(F), samples=samples, **window)

    def fold_locus(self, *, samples: int = 1000, A_max: Number | None = None) -> answers.FoldLocus:
        """The folds of every force amplitude: .f .A .F .branch, see `Averaged.fold_locus`."""
        return self._answer(self.oscillator.fold_locus, samples=samples, A_max=self._most(A_max))

    def cusps(self, *, A_max: Number | None = None) -> answers.Cusps:
        """Where two folds come into being or meet: .F .f .A .minimum, see `Averaged.cusps`."""
        return self._answer(self.oscillator.cusps, A_max=self._most(A_max))

    def isola_points(self, *, A_max: Number | None = None) -> answers.IsolaPoints:
        """Where isolated curves are born or merge: .F .f .A .kind, see `Averaged.isola_points`."""
        return self._answer(self.oscillator.isola_points, A_max=self._most(A_max))

    @property
    def sticking_forcing(self) -> float:
        """The amplitude of the excitation that leaves a mass at rest at every frequency, see `Averaged`."""
        _, kind, _ = EXCITED[self.scales.excitation]
        return self.oscillator.sticking_forcing * self.scales.sizes[kind]

    def transmissibility_floor(self, F: Number) -> float:
        """What the ratio that is transmitted tends to as f rises without end, see `Averaged.transmissibility_floor`."""
        return self._ask(self.oscillator.transmissibility_floor, self._amplitude(F))

    def backbone(self, A: Numbers) -> Floats:
        """f in Hz on the backbone at amplitudes in m, see `Averaged.backbone`."""
        return np.asarray(self._ask(self.oscillator.backbone, self._length("A", A)) * self.scales.sizes["frequency"])

    def limit_envelope(self, *, f: Numbers, F: Numbers) -> Floats:
        """The amplitude in m that no response exceeds, see `Averaged.limit_envelope`."""
        A = self._ask(self.oscillator.limit_envelope, Omega=self._frequencies(f), F_0=self._amplitudes(F))
        return np.asarray(A * self.scales.sizes["length"])

    def certify(self, F: Number, *, f: Number | None = None) -> answers.Certificate:
        """What is proved at a force amplitude: see `Averaged.certify`.

        Of the dimensionless numbers as they are: `.answer` has the intervals that are proved, and these are the same
        times what is measured in, rounded.
        """
        Omega = None if f is None else self._frequency(f)
        return self._answer(self.oscillator.certify, self._amplitude(F), Omega=Omega)

    def plot(self, F: Numbers, *, f: Window | None = None, of: str = "A", ax: Any = None) -> Any:
        """Draw the response at one force, or at each of several, into Matplotlib axes, or new ones, and return these.

        f  -- the window of frequencies, up to twice f_n without
        of -- what is drawn over frequency, in Hz: "A", in mm, under a load .x_max; "phi" or "transmissibility_dB"

        Signs and tints as of `Averaged.plot`. Raises ValueError for another word, ImportError without Matplotlib.
        """
        from slowflow import pictures

        validate.choice("of", of, DRAWN)
        letter, _, unit = EXCITED[self.scales.excitation]
        forces = validate.several(letter, si(letter, F, unit))
        answers = ((self.frequency_response(force, f=f), self.saddle_nodes(force)) for force in forces)
        found = [(curve.in_units(), folds.in_units()) for curve, folds in answers]
        drawn = pictures.height(found[0][0]) if of == "A" else of
        ax = pictures.responses(ax, found, drawn)
        window = validate.WINDOW if f is None else self._window(f)["Omega"]
        ax.set_xlim(*(end * self.scales.sizes["frequency"] for end in window))
        if of == "A":
            length = self.scales.sizes["length"] / UNITS["length"]["mm"]
            pictures.breakpoints(ax, [length * end for end in self.oscillator.breakpoints], "x")
        if drawn == "A":
            pictures.stopping(ax, self.oscillator.mu * length * self.scales.sizes["frequency"] ** 2)
        pictures.legend(ax, pictures.axis(found[0][0], letter))
        return ax

    def explain(self, question: str, F: Number | None = None) -> Plan:
        """What runs for a question and what is skipped, see `Averaged.explain`."""
        found = self._ask(self.oscillator.explain, question, None if F is None else self._amplitude(F))
        steps = tuple(dataclasses.replace(step, why=in_units(step.why, self.scales)) for step in found.steps)
        letter, kind, unit = EXCITED[self.scales.excitation]
        where = "" if F is None else f" at {letter} = {si(letter, F, unit):g} {next(iter(UNITS[kind]))}"
        return dataclasses.replace(found, steps=steps, where=where)

    @property
    def second_approximation(self) -> Physical:
        """The same questions, those that it answers, with the higher harmonics of force and friction."""
        with self.scales.in_these_terms():
            return Physical(self.oscillator.second_approximation, self.scales, self.given)

    def steady_state(
        self,
        *,
        f: Number,
        F: Number,
        A: Number | None = None,
        samples: int = 400,
        x_0: Number | None = None,
        v_0: Number = 0.0,
    ) -> answers.SteadyState:
        """One periodic motion of the equation of motion: .A .stops .stable .period, and .t .x .v over one period.

        x_0, v_0 -- displacement in m and velocity in m/s at the beginning, in place of A

        .A is the largest |x|; under a load that is what `amplitudes` calls .x_max, and .message says so. See
        `Oscillator.steady_state`, which `.answer` is from.
        """
        at = {"Omega": self._frequency(f), "F_0": self._amplitude(F), "A": self._most(A), **self._begins(x_0, v_0)}
        found = self._ask(self.oscillator.steady_state, **at)
        tau, u, v = found.series(samples)
        said = {name: getattr(found, name) for name in ("Omega", "A", "stops", "stable", "period")}
        said |= {"F_0": at["F_0"], "message": joined("" if self.oscillator.load == 0 else LARGEST, found.message)}
        return cast("answers.SteadyState", self.scales.named({**said, "tau": tau, "u": u, "v": v}, found))

    def exact_response(
        self,
        F: Number,
        *,
        f: Window | None = None,
        start: Quantities | None = None,
        step: float = 0.02,
        x_0: Number | None = None,
        v_0: Number = 0.0,
    ) -> answers.Response:
        """The curve of the equation of motion: .f .A .stable .stops, and .folds; see `Oscillator.exact_response`.

        start    -- what `steady_state` gave
        x_0, v_0 -- as in `steady_state`, in place of it
        """
        if not (start is None or isinstance(start, Quantities)):
            raise Refused(f"start = {start!r} is not allowed: start must be what steady_state gave")
        begun = None if start is None else start.answer
        at = {**self._window(f), **self._begins(x_0, v_0)}
        found = self._ask(self.oscillator.exact_response, self._amplitude(F), start=begun, step=step, **at)
        entry = ("Omega", "A", "stable", "stops")
        columns: dict[str, Any] = {"Omega": float, "A": float, "kind": str, "corner": bool}
        folds = {name: np.array([getattr(one, name) for one in found.folds], of) for name, of in columns.items()}
        said = {name: getattr(found, name) for name in (*entry, "F_0", "closed", "message", "complete")}
        curve = self.scales.named(said, found, entry)
        values = {**curve.values, "folds": self.scales.named(folds, found.folds, tuple(columns))}
        return cast("answers.Response", Quantities(values, curve.units, found, curve.entry, self.scales))

    def sweep(self, *, f: Numbers, F: Number, x_0: Number | None = None, v_0: Number = 0.0) -> answers.Sweep:
        """What an experiment sees that steps through frequencies: .f .A .stops .settled, and .jumps in Hz.

        x_0, v_0 -- as in `steady_state`

        See `Oscillator.sweep`.
        """
        at = {"Omega": self._frequencies(f), "F_0": self._amplitude(F), **self._begins(x_0, v_0)}
        found = self._ask(self.oscillator.sweep, **at)
        entry = ("Omega", "A", "stops", "settled")
        said = {name: getattr(found, name) for name in (*entry, "F_0", "message")}
        jumps = np.array(found.jumps).reshape(-1, 2)
        return cast("answers.Sweep", self.scales.named({**said, "jumps": jumps}, found, entry))

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
        pulse = self._begins(x_0, v_0)
        if acceleration is not None:
            pulse["acceleration"] = self._acceleration(acceleration)
        times = {"duration": duration, "tau": t, "after": after}
        pulse |= {name: self._time(name, value) for name, value in times.items() if value is not None}
        found = self._ask(self.oscillator.transient, **pulse)
        said = {field.name: getattr(found, field.name) for field in dataclasses.fields(found) if field.repr}
        return cast("answers.Transient", self.scales.named({**said, **found.series(samples)._asdict()}, found))

    def shock_spectrum(self, *, acceleration: Numbers, duration: Numbers) -> answers.ShockSpectrum:
        """What half sines of the base do: .acceleration .duration .A .a_max .ratio .detaches, a row for each.

        In m/s^2 and s, numbers or arrays that broadcast; see `Oscillator.shock_spectrum`.
        """
        pulses = {"acceleration": self._acceleration(acceleration), "duration": self._time("duration", duration)}
        return self._answer(self.oscillator.shock_spectrum, **pulses)

    def margins(self, F: Number) -> answers.Margins:
        """How far a force amplitude is from F_SN and F_cr: .of_SN .of_cr, see `Oscillator.margins`."""
        return self._answer(self.oscillator.margins, self._amplitude(F))

    def hysteresis(self, F: Number) -> answers.Hysteresis:
        """Bands with several stable motions: .f_low .f_high .motions, see `Oscillator.hysteresis`."""
        return self._answer(self.oscillator.hysteresis, self._amplitude(F))

    def isolation(self, F: Number, level_dB: float = 0.0) -> answers.Isolation:
        """The frequency from which on less than F is transmitted: .f .A, see `Oscillator.isolation`."""
        return self._answer(self.oscillator.isolation, self._amplitude(F), level_dB)

    def spectrum(self, *, f: Numbers, F: Numbers) -> answers.Spectrum:
        """A load spectrum, row by row, see `Oscillator.spectrum`."""
        Omega, F_0 = self._frequencies(f), self._amplitudes(F)
        return self._answer(self.oscillator.spectrum, Omega=Omega, F_0=F_0)

    def _answer(self, question: Callable[..., Any], *arguments: Any, **named: Any) -> Any:
        """The answer in SI units."""
        return self.scales.quantities(self._ask(question, *arguments, **named))

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

    def _begins(self, x_0: Any, v_0: Any) -> dict[str, Any]:
        """Displacement and velocity at the beginning, as the oscillator takes them."""
        v = self._over("v_0", si("v_0", v_0, "meter/second"), "speed")
        return {"u_0": None if x_0 is None else self._length("x_0", x_0), "v_0": v}

    def _acceleration(self, value: Any) -> Any:
        return self._over("acceleration", si("acceleration", value, "meter/second**2"), "acceleration")

    def _time(self, name: str, value: Any) -> Any:
        found = self._over("t" if name == "tau" else name, si(name, value, "second"), "time")
        if name == "duration" and np.size(found):
            longest = float(np.max(found)) * self.scales.sizes["time"]
            plausible.warn(plausible.of_duration(longest, self.scales.sizes["frequency"]), stacklevel=3)
        return found

    def _most(self, A: Any) -> Any:
        return None if A is None else self._length("A", A)

    def _frequency(self, value: Any) -> float:
        return self._frequencies(validate.number("f", turns("f", value), above=0.0))

    def _frequencies(self, value: Any) -> Any:
        """One, or an array of them."""
        f, f_n = turns("f", value), self.scales.sizes["frequency"]
        Omega = self._over("f", f, "frequency", above=0.0)
        if np.size(Omega):
            plausible.warn(plausible.of_frequency(float(np.max(Omega)) * f_n, f_n), stacklevel=3)
        return Omega

    def _window(self, f: Any) -> dict[str, Any]:
        """Of frequencies, as the oscillator takes it; nothing where it has its own."""
        if f is None:
            return {}
        try:
            low, high = f
        except (TypeError, ValueError):
            raise Refused(f"f = {f!r} is not allowed: f must be a pair of frequencies (low, high)") from None
        ends = validate.window("f", (turns("f[0]", low), turns("f[1]", high)))
        return {"Omega": tuple(end / self.scales.sizes["frequency"] for end in ends)}

    def _over(self, name: str, value: Any, kind: str, above: float = -math.inf) -> Any:
        """A number as one, or an array, over what it is measured in."""
        size = self.scales.sizes[kind]
        if validate.is_single(value):
            number: Any = validate.number(name, value, above=above)
        else:
            number = validate.finite_array(name, value) if above < 0 else validate.positive_array(name, value)
        with np.errstate(over="ignore"):
            found = number / size
        if not np.isfinite(found).all():
            raise OutOfRange(f"{name} = {value!r} is too large: over {size:.6g} it leaves the range of doubles")
        return found
