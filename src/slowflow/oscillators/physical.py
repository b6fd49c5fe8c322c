"""Oscillators in SI units: newtons, metres and hertz.

Arguments are numbers in SI units, strings with a unit, or pint quantities. Results are `Quantities`.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from slowflow.answers.answer import joined
from slowflow.answers.quantities import DRAWN, LETTERS, SI, UNITS, Quantities, Scales, g, si
from slowflow.core import validate
from slowflow.core.mechanism import Floats
from slowflow.oscillators import range_checks
from slowflow.oscillators.arguments import PLAIN, REMARKS, TakesAmplitude, density, window
from slowflow.oscillators.measurements import Columns
from slowflow.support.errors import OutOfRange
from slowflow.support.text import in_units
from slowflow_kernels.domains import DISSIPATION

if TYPE_CHECKING:
    from typing import Unpack

    from matplotlib.axes import Axes

    from slowflow import exact
    from slowflow.answers import physical_answers as answers
    from slowflow.answers import results
    from slowflow.answers.physical_answers import Amplitude
    from slowflow.answers.quantities import Number, Numbers, Window
    from slowflow.averaged import checks
    from slowflow.averaged.plan import Plan
    from slowflow.core.mechanism import Unlabelled
    from slowflow.off_centre.answers import RestPositions
    from slowflow.oscillators.oscillator import Oscillator
    from slowflow.oscillators.physical_designs import PhysicalDesigns
    from slowflow.random_vibration.answers import RandomResponse

    #: the amplitude of the excitation, by its letter
    At = Amplitude[Number]

#: meaning of A for a motion with a mean displacement
LARGEST = "A is the largest |x|, the mean displacement included: x_max of an averaged motion"


@functools.cache
def _takes(question: Any) -> Mapping[str, inspect.Parameter]:
    """The parameters of a dimensionless question."""
    return inspect.signature(question).parameters


@validate.methods_check_arguments(*LETTERS)
@dataclass(frozen=True, repr=False)
class Physical(TakesAmplitude):
    """An oscillator in SI units: arguments and answers have forces in N, frequencies f in Hz, lengths in m.

    Most methods take the amplitude of the excitation as their first argument, or as a keyword: a force F in N, a
    displacement Y of the base in m, an acceleration a of the base in m/s^2, or an unbalance U in kg m, the rotating
    mass times its radius. Results use the same letter: Y_SN or a_cr instead of F_SN and F_cr. Under base excitation,
    methods accept either Y or a.

    oscillator -- the dimensionless oscillator, or its second approximation
    scales     -- the mass, stiffness and length that make its numbers dimensionless (4)
    given      -- the arguments that it was made from, for `replace`

    Objects are immutable. Arguments may also be strings such as "0.3 g" or pint quantities. Each method corresponds to
    that of the dimensionless `Oscillator` with the same name.
    """

    oscillator: Oscillator
    scales: Scales
    given: Mapping[str, Any] = dataclasses.field(compare=False)

    def __repr__(self) -> str:
        arguments = ", ".join(f"{name}={value!r}" for name, value in self.given.items())
        return f"{type(self.oscillator).__name__}.physical({arguments})"

    def replace(self, **changes: Any) -> Physical:
        """Return a copy with some of its arguments changed, by name."""
        return self._kind.physical(**self._changed(changes))

    @overload
    def many(self, **changes: Unlabelled | str) -> PhysicalDesigns: ...
    @overload
    def many(self, **changes: Any) -> Any: ...
    def many(self, **changes: Any) -> Any:
        """Make a batch of mounts from this mount, with some of its data replaced by arrays that broadcast.

        Parameters
        ----------
        **changes : array_like
            Data by the names of `Isolator.physical` or `Duffing.physical`, in SI units; `mounts`, `contact`, `force`
            and `excitation` are the same for all mounts. Arrays of xarray or dask make a map over named axes, which
            may be larger than memory.

        Returns
        -------
        PhysicalDesigns or PhysicalGrid
            The same questions, with arrays as arguments; a mount without a result has a status. Of a map, answers are
            xarray Datasets.

        Raises
        ------
        ValueError
            For arguments that are not real arrays, for shapes that do not broadcast, and with static friction.

        Warns
        -----
        Implausible
            For an allowed number that seems to be in another unit, as `Isolator.physical`.
        """
        from slowflow.oscillators.physical_designs import PhysicalDesigns

        laws = {self.scales.measures[one.name][0] for one in DISSIPATION}
        changed = self._changed(changes).items()
        sheet = {name: value for name, value in changed if not (name in laws and validate.is_zero(value))}
        of_kind = self._kind.physical
        validate.known_arguments(of_kind.__qualname__, sheet, tuple(inspect.signature(of_kind).parameters))
        make: Any = PhysicalDesigns
        if any(validate.is_labelled(getattr(value, "magnitude", value)) for value in changes.values()):
            from slowflow.oscillators.physical_grid import PhysicalGrid

            make = PhysicalGrid._of
        mounts = make(self._kind, sheet, hasattr(self.oscillator, "first"))
        range_checks.warn(mounts._range_checks())
        return mounts

    @property
    def _kind(self) -> Any:
        """The class of the oscillator."""
        return type(getattr(self.oscillator, "first", self.oscillator))

    def _changed(self, changes: Mapping[str, Any]) -> dict[str, Any]:
        """The arguments that it was made from, some of them changed; c and zeta say the same."""
        replaced = {one: other for one, other in (("c", "zeta"), ("zeta", "c")) if other in changes}
        return {**{name: value for name, value in self.given.items() if name not in replaced}, **changes}

    def at_rest(self) -> answers.AtRest[checks.AtRest]:
        """Compute the data of a data sheet: natural frequencies, stiffness, stroke, loads, friction.

        Returns
        -------
        Quantities
            .f_n in Hz: natural frequency of the mass on the vertical spring alone;
            .f_0 in Hz, .k_0 in N/m: frequency and stiffness of small motions about the centre, no f_0 if k_0 < 0;
            .x_cr in m: the stroke, at which the springs detach, None if they never touch;
            .preset in m: compression of k_v that carries the mass at the centre, m g/k_v;
            .lightest, .heaviest in kg: masses with an equilibrium at -x_cr and x_cr if k_v is preloaded for m; no
                lightest mass if the spring without any mass rests within the stroke;
            .break_loose in N: constant force that friction holds, static friction if specified;
            .rests_within in m: distance from the centre within which friction holds the mass, None if unlimited;
            .sticking in N: force amplitude up to which averaging predicts sticking, 4/pi times the friction (27).

        Raises
        ------
        ValueError
            With a load other than m: `rest` has its equilibria.
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
        mount: Any = Quantities(values, units, found.answer)
        return mount

    def sag(self, load: Number) -> float:
        """Compute the equilibrium, in m from the centre, of a mass `load` in kg on a spring k_v preloaded for m (5)."""
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

    def rest(self) -> answers.Rows[RestPositions]:
        """Find every equilibrium, without friction: .x in m, .stable, .stiffness in N/m, .load in kg."""
        return self._answer("rest")

    def force(self, x: Numbers) -> Floats:
        """Compute the restoring force in N at displacements x in m, without the weight that k_v carries."""
        return np.asarray(self._ask("force", x=x) * self.scales.sizes["force"])

    def stiffness(self, x: Numbers) -> Floats:
        """Compute the slope of the restoring force in N/m at displacements x in m, in their shape."""
        return np.asarray(self._ask("stiffness", x=x) * self.scales.sizes["stiffness"])

    def saddle_node_onset(self) -> answers.One[results.SaddleNodeOnset]:
        """Find the lowest amplitude that has a fold (33): .F_SN in N, .f in Hz, .A in m, .kind."""
        return self._answer("saddle_node_onset")

    def detachment(self) -> answers.One[results.Detachment]:
        """Find the lowest amplitude whose response reaches the stroke (34): .F_cr in N, .f_cr in Hz, .x_cr in m."""
        return self._answer("detachment")

    def saddle_nodes(self, amplitude: Number | None = None, /, **at: Unpack[At]) -> answers.AtOne[results.SaddleNodes]:
        """Find every fold at F in N (or Y, a, U), where a sweep jumps (30): .f in Hz, .A in m, .kind, .corner."""
        return self._answer("saddle_nodes", amplitude, at)

    def peak(self, amplitude: Number | None = None, /, **at: Unpack[At]) -> answers.One[results.Peak]:
        """Find the highest peak at F in N (or Y, a, U): .A in m at .f in Hz; under a load .x_max at .f_max too."""
        return self._answer("peak", amplitude, at)

    def amplitudes(self, *, f: Numbers, **at: Unpack[Amplitude[Numbers]]) -> answers.States[results.SteadyStates]:
        """Find every steady state at f (24), (30): .f in Hz, .A in m, .phi in rad, .stable, .transmissibility_dB.

        Under a load .A is the amplitude about the mean displacement .B, and .x_max = |B| + A the largest |x|, all in m.

        Parameters
        ----------
        f : array_like
            Frequencies in Hz, > 0.
        **at : array_like
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m.
        """
        return self._answer("amplitudes", None, at, f=f)

    def frequency_response(
        self,
        amplitude: Number | None = None,
        /,
        *,
        f: Window | None = None,
        samples: int = 1000,
        **at: Unpack[At],
    ) -> answers.AtOne[results.FrequencyResponse]:
        """Compute the response curve (24): .f in Hz, .A in m, .phi in rad, .stable, .branch, .transmissibility_dB.

        Parameters
        ----------
        amplitude, **at : float
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m.
        f : tuple of float, optional
            Window of frequencies in Hz, by default from 0 to twice f_n.
        samples : int
            Approximate number of points, 2 to 10^6.
        """
        return self._answer("frequency_response", amplitude, at, f=f, samples=samples)

    def fold_locus(self, *, samples: int = 1000, A_max: Number | None = None) -> answers.AtEach[results.FoldLocus]:
        """Trace the folds of every amplitude, F_A = 0 (30): .f in Hz, .A in m, .F in N, .branch.

        Parameters
        ----------
        samples : int
            Approximate number of points, 2 to 10^6.
        A_max : float, optional
            Largest amplitude in m, by default the mechanism's reach; `Duffing` needs it.
        """
        return self._answer("fold_locus", samples=samples, A_max=A_max)

    def cusps(self, *, A_max: Number | None = None) -> answers.AtEach[results.Cusps]:
        """Find the cusps, where two folds appear or merge, up to A_max in m: .F in N, .f in Hz, .A in m, .minimum."""
        return self._answer("cusps", A_max=A_max)

    def isola_points(self, *, A_max: Number | None = None) -> answers.AtEach[results.IsolaPoints]:
        """Find where isolated curves appear or merge, up to A_max in m: .F in N, .f in Hz, .A in m, .kind."""
        return self._answer("isola_points", A_max=A_max)

    @property
    def sticking_forcing(self) -> float:
        """Amplitude of the excitation, in SI units, up to which a mass sticks at every frequency, 4 mu/pi (27)."""
        return self.oscillator.sticking_forcing * self.scales.sizes[self.scales.amplitude]

    def transmissibility_floor(self, amplitude: Number | None = None, /, **at: Unpack[At]) -> float:
        """Compute the transmissibility as f tends to infinity at F in N (or Y, a, U), a ratio."""
        one, F_0 = self._excited(amplitude, at)
        return float(one._ask("transmissibility_floor", F_0=F_0))

    def backbone(self, A: Numbers) -> Floats:
        """Compute the frequency in Hz on the backbone (26) at amplitudes A > 0 in m, in their shape."""
        return np.asarray(self._ask("backbone", A=A) * self.scales.sizes["frequency"])

    def limit_envelope(self, *, f: Numbers, **at: Unpack[Amplitude[Numbers]]) -> Floats:
        """Compute the amplitude in m that no response exceeds (27), in the common shape of the arguments.

        Parameters
        ----------
        f : array_like
            Frequencies in Hz, > 0.
        **at : array_like
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m.
        """
        one, F_0 = self._excited(None, at)
        return np.asarray(one._ask("limit_envelope", f=f, F_0=F_0) * self.scales.sizes["length"])

    def certify(
        self, amplitude: Number | None = None, /, *, f: Number | None = None, **at: Unpack[At]
    ) -> answers.Certificate:
        """Prove all folds at one amplitude, F_SN and F_cr in N, and all states at a frequency.

        Print the result. The proof concerns the dimensionless numbers: `.answer` has the proved intervals, which are
        rounded here.

        Parameters
        ----------
        amplitude, **at : float
            Amplitude of the excitation: F in N or a in m/s^2.
        f : float, optional
            Frequency of the states in Hz, > 0.
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
        **at: Unpack[At],
    ) -> answers.SteadyState[exact.SteadyState]:
        """Find a periodic motion of the equation of motion (3), and its displacement over one period.

        Parameters
        ----------
        f : float
            Frequency in Hz, > 0.
        A : float, optional
            Select the motion with the amplitude nearest to A, in m; by default the one that a mass at rest tends to.
        samples : int
            Points over one period.
        x_0, v_0 : float, optional
            Displacement in m and velocity in m/s at t = 0, instead of A.
        **at : float
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m.

        Returns
        -------
        Quantities
            .A in m, the largest |x| (under a load comparable to .x_max of `amplitudes`); .stops, .stable, .period in s;
            .t in s, .x in m and .v in m/s, shape (samples,). `.answer` is the dimensionless motion.
        """
        one, F_0 = self._excited(None, at)
        found = one._ask("steady_state", f=f, F_0=F_0, A=A, x_0=x_0, v_0=v_0)
        message = joined("" if self.oscillator.load == 0 else LARGEST, found.message)
        series = dict(zip(("tau", "u", "v"), found.series(samples), strict=True))
        names = ("Omega", "A", "stops", "stable", "period")
        return one._named(found, (), *names, F_0=found.F_0, message=message, **series)

    def exact_response(
        self,
        amplitude: Number | None = None,
        /,
        *,
        f: Window | None = None,
        start: answers.SteadyState[exact.SteadyState] | None = None,
        step: float = 0.02,
        x_0: Number | None = None,
        v_0: Number = 0.0,
        **at: Unpack[At],
    ) -> answers.Response[exact.Response]:
        """Follow the response curve of the equation of motion (3): points, stability, stops, folds.

        Parameters
        ----------
        amplitude, **at : float
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m.
        f : tuple of float, optional
            Window of frequencies in Hz, by default from 1/2 to 3/2 of f_n.
        start : Quantities, optional
            A motion on the curve, from `steady_state`.
        step : float
            Largest relative distance between neighbouring points, > 0 and <= 0.5.
        x_0, v_0 : float, optional
            Initial displacement in m and velocity in m/s, instead of `start`.

        Returns
        -------
        Quantities
            .f in Hz, .A in m, the largest |x|, .stable, .stops, shape (n,); .folds with .f .A .kind .corner; .complete.
        """
        begun = getattr(start, "answer", start)
        one, F_0 = self._excited(amplitude, at)
        found = one._ask("exact_response", F_0=F_0, f=f, start=begun, step=step, x_0=x_0, v_0=v_0)
        columns: dict[str, Any] = {"Omega": float, "A": float, "kind": str, "corner": bool}
        folds = {name: np.array([getattr(one, name) for one in found.folds], of) for name, of in columns.items()}
        curve = one._named(found, ("Omega", "A", "stable", "stops"), "F_0", "closed", "message", "complete")
        values = {**curve.values, "folds": self.scales.named(folds, found.folds, tuple(columns))}
        return dataclasses.replace(curve, values=values)

    def sweep(
        self, *, f: Numbers, x_0: Number | None = None, v_0: Number = 0.0, **at: Unpack[At]
    ) -> answers.AtOne[exact.Sweep]:
        """Follow a stepped-sine test: .f in Hz, .A in m, .stops, .settled, and .jumps in Hz, shape (k, 2).

        Parameters
        ----------
        f : array_like
            Frequencies in Hz, > 0, in the order of the test.
        x_0, v_0 : float, optional
            Initial displacement in m and velocity in m/s; by default the mass is at rest.
        **at : float
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m.
        """
        one, F_0 = self._excited(None, at)
        found = one._ask("sweep", f=f, F_0=F_0, x_0=x_0, v_0=v_0)
        jumps = np.array(found.jumps).reshape(-1, 2)
        entry = ("Omega", "A", "stops", "settled")
        return one._named(found, entry, "F_0", "message", jumps=jumps)

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
    ) -> answers.Transient[exact.Transient]:
        """Integrate the response to a shock of the base, or the free motion from x_0 and v_0, by (3).

        Parameters
        ----------
        acceleration : array_like, optional
            Acceleration of the base in m/s^2: the peak of a half sine, or the samples of a record, shape (n,).
        duration : float, optional
            Duration of the half sine, in s.
        t : array_like, optional
            Times of the samples in s, ascending, shape (n,).
        after : float, optional
            Duration in s of the free motion afterwards, by default ten natural periods.
        samples : int
            Number of points over time.
        x_0, v_0 : float, optional
            Initial displacement in m and velocity in m/s relative to the base; by default the mass is at rest.

        Returns
        -------
        Quantities
            Relative to the base: .A in m, the largest |x|, at .t_A in s; .detaches, first at .t_detaches in s; .x_cr in
            m; .x_end in m, where friction holds the mass if .rests. Absolute: .a_max in m/s^2 at .t_a in s. The motion
            has .t .x .v .a and the acceleration of the base, .base, shape (samples,). `.answer` is the dimensionless
            motion.
        """
        pulse = {"acceleration": acceleration, "duration": duration, "t": t, "after": after}
        found = self._ask("transient", **pulse, x_0=x_0, v_0=v_0)
        names = (field.name for field in dataclasses.fields(found) if field.repr)
        return self._named(found, (), *names, **found.series(samples)._asdict())

    def shock_spectrum(self, *, acceleration: Numbers, duration: Numbers) -> answers.Rows[exact.ShockSpectrum]:
        """Compute the shock response spectrum of half sines of the base, one row for each.

        Parameters
        ----------
        acceleration, duration : array_like
            Peak in m/s^2 and duration in s, > 0; they broadcast.

        Returns
        -------
        Quantities
            .acceleration .duration .A in m, the largest deflection, .a_max in m/s^2, .ratio = a_max/peak, .detaches.
        """
        return self._answer("shock_spectrum", acceleration=acceleration, duration=duration)

    def random(self, *, psd: tuple[Numbers, Numbers] | Columns, unit: str = "g^2/Hz") -> answers.Random[RandomResponse]:
        """Find the stationary motions under random vibration by statistical linearization.

        Parameters
        ----------
        psd : tuple of array_like, or Columns
            Frequencies in Hz and one-sided densities, linear in log-log between the points, 0 outside; or the columns f
            and G of a file with their unit, see `slowflow.oscillators.measurements`.
        unit : str
            Unit of the densities: "g^2/Hz" or "(m/s^2)^2/Hz" for the base's acceleration, "N^2/Hz" for a force.

        Returns
        -------
        Quantities
            .B, the mean of x, and .x_rms about it in m, .v_rms in m/s, .a_rms in m/s^2, .f_e in Hz, .stiffness in N/m
            and .damping in N s/m of the equivalent linear oscillator, .beyond and .crossing_rate in 1/s of the stroke;
            shape (motions,).
        """
        excitation, table = density(self.scales, psd, unit)
        with self.scales.in_these_terms():
            found = self.oscillator.random(psd=table)
        scales: Any = dataclasses.replace(self.scales, excitation=excitation)
        return scales.quantities(found)

    def margins(self, amplitude: Number | None = None, /, **at: Unpack[At]) -> answers.One[checks.Margins]:
        """Compare F in N (or Y, a, U) with F_SN and F_cr: .of_SN = F_SN/F and .of_cr = F_cr/F, < 1 if exceeded."""
        return self._answer("margins", amplitude, at)

    def hysteresis(self, amplitude: Number | None = None, /, **at: Unpack[At]) -> answers.AtOne[checks.Hysteresis]:
        """Find bands with several stable motions at F in N (or Y, a, U): .f_low and .f_high in Hz, .motions."""
        return self._answer("hysteresis", amplitude, at)

    def isolation(
        self, amplitude: Number | None = None, /, level_dB: float = 0.0, **at: Unpack[At]
    ) -> answers.One[checks.Isolation]:
        """Find the frequency above which every stable motion transmits less than a level: .f in Hz, .A in m.

        Parameters
        ----------
        amplitude, **at : float
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m.
        level_dB : float
            Transmissibility in decibels, <= 0: -20 for a tenth of the force.
        """
        return self._answer("isolation", amplitude, at, level_dB=level_dB)

    def spectrum(self, *, f: Numbers, **at: Unpack[Amplitude[Numbers]]) -> answers.AtEach[checks.Spectrum]:
        """Find the largest stable motion for each row of a load spectrum, one tone at a time, in order.

        Parameters
        ----------
        f : array_like
            Frequencies in Hz, > 0.
        **at : array_like
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m.

        Returns
        -------
        Quantities
            .A in m, .transmissibility_dB, .motions, .crosses (a fold), .detaches, .sticks, shape (n,).
        """
        return self._answer("spectrum", None, at, f=f)

    def plot(
        self,
        amplitude: Numbers | None = None,
        /,
        *,
        f: Window | None = None,
        of: str = "A",
        ax: Axes | None = None,
        **at: Unpack[Amplitude[Numbers]],
    ) -> Axes:
        """Plot the response at one amplitude, or at each of several; return the Matplotlib axes, new ones by default.

        f  -- window of frequencies in Hz, by default from 0 to twice f_n
        of -- quantity over f: "A" in mm, under a load .x_max; "phi" or "transmissibility_dB"

        Symbols and colours as of `Averaged.plot`. Raises ValueError for another `of`, ImportError without Matplotlib.
        """
        from slowflow.answers import pictures

        validate.choice("of", of, DRAWN)
        one, F_0 = self._excited(amplitude, at)
        letter = one.scales.symbol("F_0")
        forces = validate.several(letter, si(letter, F_0, SI[one.scales.amplitude]))
        answers = ((one.frequency_response(force, f=f), one.saddle_nodes(force)) for force in forces)
        found = [(curve.in_units(), folds.in_units()) for curve, folds in answers]
        drawn = pictures.height(found[0][0]) if of == "A" else of
        ax = pictures.responses(ax, found, drawn)
        ends = validate.WINDOW if f is None else window(self.scales, f)
        pictures.window(ax, *(end * self.scales.sizes["frequency"] for end in ends))
        if of == "A":
            length = self.scales.sizes["length"] / UNITS["length"]["mm"]
            pictures.breakpoints(ax, [length * end for end in self.oscillator.breakpoints], "x")
        if drawn == "A":
            edge = self.oscillator.mu * length * self.scales.sizes["frequency"] ** 2
            pictures.stopping(ax, edge, r"$m A (2\pi f)^2 <$ friction")
        pictures.legend(ax, pictures.axis(found[0][0], letter))
        return ax

    def explain(self, question: str, amplitude: Number | None = None, /, **at: Unpack[At]) -> Plan:
        """List the steps of a question: which run, which are skipped, and why.

        Parameters
        ----------
        question : str
            Its name, such as "saddle_nodes".
        amplitude, **at : float
            Amplitude of the excitation: F in N, Y in m, a in m/s^2 or U in kg m, where the question takes one.

        Returns
        -------
        Plan
            Printing shows the steps.
        """
        one, F_0 = self._excited(amplitude, at) if at or amplitude is not None else (self, None)
        found = one._ask("explain", question=question, F_0=F_0)
        steps = tuple(step._replace(why=in_units(step.why, one.scales)) for step in found.steps)
        letter, unit = one.scales.symbol("F_0"), SI[one.scales.amplitude]
        where = "" if F_0 is None else f" at {letter} = {si(letter, F_0, unit):g} {unit}"
        return found._replace(steps=steps, where=where)

    @property
    def second_approximation(self) -> Physical:
        """The second approximation of the same questions, with the higher harmonics of force and friction."""
        with self.scales.in_these_terms():
            second: Any = self.oscillator.second_approximation
        return Physical(second, self.scales, self.given)

    # ---- arguments

    @functools.cached_property
    def _by_other_base(self) -> Physical:
        """The same mount under its base's acceleration in place of its displacement, or the other way round."""
        scales, of = dataclasses.replace(self.scales, excitation=self._other_base), self.oscillator
        oscillator: Any = getattr(of, "first", of).replace(excitation=scales.of_oscillator)
        oscillator = oscillator.second_approximation if hasattr(of, "first") else oscillator
        return Physical(oscillator, scales, {**self.given, "excitation": self._other_base})

    def _answer(
        self, question: str, amplitude: Any = None, at: Mapping[str, Any] | None = None, /, **arguments: Any
    ) -> Any:
        """The answer in SI units; at an amplitude of the excitation where `at` is known."""
        if at is None:
            return self.scales.quantities(self._ask(question, **arguments))
        one, F_0 = self._excited(amplitude, at)
        return one._answer(question, F_0=F_0, **arguments)

    def _named(self, found: Any, entry: tuple[str, ...], *names: str, **more: Any) -> Any:
        """Numbers of an answer by name, those of an entry first, in SI units."""
        return self.scales.named({**{name: getattr(found, name) for name in (*entry, *names)}, **more}, found, entry)

    def _ask(self, question: str, /, **arguments: Any) -> Any:
        """The dimensionless answer; errors are in newtons, metres and hertz, as the arguments are.

        The method's annotations say what an argument is: one number, an array or a window.
        """
        method = getattr(self.oscillator, question)
        takes, at = _takes(getattr(method, "__func__", method)), {}
        for name, value in arguments.items():
            plain = PLAIN.get(name, name)
            shown, kind = self.scales.kind(plain)
            if value is None and takes[plain].default is not inspect.Parameter.empty:
                continue
            if kind and takes[plain].annotation.startswith("tuple"):
                value = window(self.scales, value)
            elif kind:
                value = self._number(shown, value, kind, several=not takes[plain].annotation.startswith("float"))
            at[plain] = value
        with self.scales.in_these_terms():
            return method(**at)

    def _number(self, name: str, value: Any, kind: str, *, several: bool) -> Any:
        """A number or an array, made dimensionless."""
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
        if name in REMARKS:
            range_checks.warn(REMARKS[name](number, self.scales.sizes["frequency"]))
        return found
