"""The report of a scene. Takes a scene with forcings; returns one HTML page that needs no network.

The answers with their margins, curves, transmissibility, a map of designs with the one at hand, how far to trust each
jump, the equations that are proved, and the data. Pictures are drawn by Matplotlib into the page. What an
oscillator has no answer to, as one under a load or with another law of damping, is left out, and that is said.
"""

from __future__ import annotations

import contextlib
import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from html import escape
from importlib import resources
from typing import Any

import numpy as np

import slowflow
from slowflow.answers import files, page, pictures
from slowflow.answers.answer import Answer, shown
from slowflow.answers.quantities import DATA_SHEET, SHEET, SHOWN, UNITS, in_shown
from slowflow.answers.results import Remark
from slowflow.answers.table import COLUMNS
from slowflow.answers.validity import IN_PYTHON, is_measured
from slowflow.app.query import FORCINGS, Query
from slowflow.app.scenes import Scene
from slowflow.app.verdict import in_words, verdict
from slowflow.core.validate import NotAvailable
from slowflow.oscillators.isolator import Isolator
from slowflow.oscillators.physical import Physical
from slowflow.sizing.fitting import loop_of_design
from slowflow.sizing.subject import Load, Subject
from slowflow.support.errors import Refused, SlowflowError
from slowflow.support.text import in_units

#: equations of the paper that the answers rest on
EQUATIONS = ("(3)", "(4)", "(5)", "(6)", "(7)", "(21)", "(22)", "(24)", "(25)", "(27)", "(30)", "(33)", "(34)")
#: verdicts of the ledger on what is proved
PROVED = ("identical", "equal after a stated rewriting")
#: designs of the map along each of two numbers, and how far these reach from the design at hand
MAPPED, REACH = 60, 0.5
#: amplitudes of what
EXCITATION = {
    "force": "force",
    "base": "displacement of the base",
    "acceleration": "acceleration of the base",
    "unbalance": "unbalance",
}
#: columns that tables leave out: words beside them have them
UNSHOWN = ("message", "remarks")
#: and what is not of a force
OF_INERTIA = ("f_sticks", "Omega_sticks")
#: columns that hold names of numbers
NAMES = ("answer", "parameter")
#: bands that need no picture
FEW = 2
#: tables of what is asked at each forcing, and of what else a scene may ask for
AT_EACH = {
    "margins": "Margins against jumps and detachment (a margin below 1 means that the limit is exceeded)",
    "peak": "Peak of the response curve",
    "isolation": "Frequency above which the transmissibility stays below its limit",
    "saddle_nodes": "Jumps of a frequency sweep",
    "hysteresis": "Frequency bands with several stable motions",
}
ALSO = {
    "isolation": "Frequency above which the transmissibility stays below a level",
    "amplitudes": "Motions at the requested frequencies",
    "cusps": "Points at which two folds appear or merge",
    "isola_points": "Points at which isolated curves appear or merge",
}
#: heads of the columns that compare with the equation of motion
BY_MOTION = ("equation of motion", "error of averaging")
#: what the numbers of a mount at rest are
MEANING = {one.si or one.name: one.text for one in COLUMNS.values()} | {
    "f_n": "natural frequency of the mass on the vertical spring alone",
    "x_cr": "displacement at which the horizontal springs detach",
    "sticking": "force amplitude up to which friction holds the mass, by averaging",
    "rests_within": "distance from the centre within which friction holds the mass",
    "preset": "compression of the vertical spring that holds the mass at the centre",
    "lightest": "mass that would rest at the upper end of the stroke",
    "heaviest": "mass that would rest at the lower end of the stroke",
}
#: errors that numbers of five digits do not show
UNSEEN = 1e-5
#: around the frequency of the peak, in its multiples, where the three depths are drawn
AROUND = (0.8, 1.2)


def html(scene: Scene) -> str:
    """The page. Raises ValueError where the scene has no forcing, no shock and no spectral density."""
    if not (scene.forcings() or scene.cases):
        raise Refused(f"{scene.path}: a report needs forcings in [ask], a shock, or a spectral density")
    report = Report(scene)
    sections = {
        "Verdict": report.verdict(),
        "Summary": report.summary(),
        "The design": report.design(),
        "Results": report.answers(),
        "Curves": report.curves(),
        "Folds": report.locus(),
        "Load spectrum": report.spectrum(),
        "Shocks": report.shocks(),
        "Random vibration": report.random(),
        "Measured loop": report.loop(),
        "Tolerances": report.tolerances(),
        "Neighbouring designs": report.map(),
        "Accuracy": report.trust(),
        "Equations": report.equations(),
        "Data": report.data(),
    }
    available = {name: blocks for name, section in sections.items() if (blocks := list(_available(section)))}
    return page.whole(f"Vibration isolator: {scene.path.stem.replace('_', ' ')}", available)


def _available(section: Iterator[str]) -> Iterator[str]:
    """The parts of a section, and what it cannot have, or what has no result."""
    try:
        yield from section
    except SlowflowError as error:
        yield _left_out([str(error)])


def _left_out(reasons: Sequence[str]) -> str:
    """Why parts are missing; nothing where none is."""
    return "".join(f"<p>Left out: {page.inline(reason)}.</p>" for reason in dict.fromkeys(reasons))


def _reason(missing: str, error: Exception) -> str:
    """A message, with what is missing if it does not name that."""
    message = str(error)
    return message if missing in message else f"{missing}: {message}"


class Report:
    """The sections of a scene's report, each the HTML of its parts.

    of       -- the oscillator; plain -- without dimensions
    mount    -- the same where it has dimensions, else None
    forcings -- amplitudes of the excitation that the scene asks at
    F, f     -- names of the arguments that are amplitude and frequency; letter -- what answers call the amplitude
    """

    def __init__(self, scene: Scene) -> None:
        self.scene, self.forcings = scene, scene.forcings()
        self.of: Any = scene.oscillator
        self.mount = self.of if isinstance(self.of, Physical) else None
        self.plain: Any = self.mount.oscillator if self.mount else self.of
        self.f = "f" if self.mount else "Omega"
        self.letter, self.unit, self.size = self._called("F_0")

    @property
    def excitation(self) -> str:
        """What the forcing is the amplitude of."""
        return self.mount.scales.excitation if self.mount else str(self.plain.excitation)

    def _ask(self, question: str, F: float | None = None, **arguments: Any) -> Any:
        """An answer, at an amplitude of the excitation if one is given."""
        return self.scene.ask(question, **arguments, **({} if F is None else {self.letter: F}))

    def _shown(self, question: str, F: float | None = None, **arguments: Any) -> Any:
        """The same in the units in which answers are shown."""
        return shown(self._ask(question, F, **arguments))

    def _plainly(self, question: str, F: float) -> Any:
        """The same without dimensions."""
        found = self._ask(question, F)
        return found.answer if self.mount else found

    def _at_each(self, question: str, forcings: Sequence[float], left_out: list[str]) -> list[Any]:
        """The answers at each forcing; none where such an oscillator has none, and why is added to `left_out`."""
        try:
            return [self._shown(question, F) for F in forcings]
        except SlowflowError as error:
            left_out.append(_reason(question, error))
            return []

    def _called(self, name: str) -> tuple[str, str, float]:
        """What a number is called, in which unit it is shown, and that one's size; none and 1 without dimensions."""
        if not self.mount:
            return name, "", 1.0
        symbol, kind = self.mount.scales.kind(name)
        return symbol, SHOWN[kind], UNITS[kind][SHOWN[kind]]

    def _in_unit(self, F: float) -> str:
        """An amplitude of the excitation in its unit."""
        return f"{F / self.size:.4g}"

    def _heads(self, *names: str) -> list[str]:
        """Heads of columns of these numbers."""
        return [page.term(*self._called(name)[:2]) for name in names]

    def _cases(self, question: str) -> list[Query]:
        """What the scene asks by a question of shocks or spectra, or requires there."""
        return self.scene.of(question) or [one for one in self.scene.cases if one.question == question]

    def _frequencies(self) -> Sequence[float]:
        """Those at which the scene asks for motions."""
        return next((one.arguments[self.f] for one in self.scene.of("amplitudes")), ())

    # ---- sections

    def verdict(self) -> Iterator[str]:
        """Which requirements are met, and by which margin."""
        if self.scene.requirements:
            found = verdict(self.scene)
            yield f"<p>{page.inline(in_words(found))}.</p>"
            yield _table("Requirements", found)

    def summary(self) -> Iterator[str]:
        """A few sentences for each force, and for the shocks."""
        lines = [" ".join([*self.in_short(F), *self._transmitted(F)]) for F in self.forcings]
        lines += self._of_shocks()
        if lines:
            yield f"<ul>{''.join(f'<li>{page.inline(line)}</li>' for line in lines)}</ul>"

    def _transmitted(self, F: float) -> Iterator[str]:
        """What stable motions transmit at the frequencies asked for."""
        for at in self._frequencies():
            states = self._shown("amplitudes", F, **{self.f: at})
            if found := [f"{one:.4g}" for one in states.transmissibility_dB[states.stable].tolist()]:
                yield f"At {_number(states, at, self.f)} its transmissibility is {' or '.join(found)} dB."

    def _of_shocks(self) -> Iterator[str]:
        """How many of the half sines lift the springs, and the worst of them."""
        answers = [(one, self.scene.answer(one)) for one in self._cases("transient")]
        if not answers:
            return
        for name, most in (("A", "deflection"), ("a_max", "acceleration of the mass")):
            one, found = max(answers, key=lambda pair: float(pair[1].columns()[name][0]))
            shock = str(one).partition(" at ")[2]
            yield f"Largest {most} in a shock: {_one(found, name)}{f', for {shock}' if shock else ''}."
        some, count = sum(bool(found.columns()["detaches"][0]) for _, found in answers), len(answers)
        if count > 1:
            yield f"In {some} of {count} shocks the springs detach."
        elif some:
            yield "The springs detach in this shock."

    def in_short(self, F: float) -> Iterator[str]:
        """Of a force: jumps, detachment, the highest motion, isolation."""
        folds = self._shown("saddle_nodes", F)
        onset = self._shown("saddle_node_onset")
        # without these the sentence is shorter; what is left out is said further down
        margins, peak, isolation = (self._at_each(one, [F], []) for one in ("margins", "peak", "isolation"))
        yield f"At {_one(folds, self.letter)}"
        if self.plain.model.sticks(self._plainly("saddle_nodes", F).F_0):
            yield "friction holds the mass: it does not move."
            return
        if len(folds):
            jumps = zip(folds.kind.tolist(), getattr(folds, self.f).tolist(), strict=True)
            *others, last = (f"{kind.removeprefix('jump-')} at {_number(folds, x, self.f)}" for kind, x in jumps)
            yield f"the isolator jumps {', '.join(others)}{' and ' if others else ''}{last}."
        elif (lowest := _one(onset, f"{self.letter[0]}_SN")) is None:
            yield "and at all other amplitudes of the excitation the isolator does not jump."
        else:
            yield f"the isolator does not jump; jumps occur only above {lowest}."
        if self.plain.breakpoints:
            yield self._detaching(F, margins)
        if peak and peak[0].A is not None:
            yield f"Its peak amplitude is {_one(peak[0], 'A')}, at {_one(peak[0], self.f)}."
        if isolation and (begin := _one(isolation[0], self.f)) is not None:
            open_ = ", as far as resolved" if isolation[0].remarks & Remark.UNDECIDED else ""
            yield f"Above {begin} its transmissibility is below 0 dB{open_}."
        for one in self.scene.of("isolation"):
            level = one.arguments.get("level_dB", 0.0) if one.forcing == F else 0.0
            if level and (begin := _one(self.scene.answer(one), self.f)) is not None:
                yield f"Above {begin} its transmissibility is below {level:g} dB."

    def _detaching(self, F: float, margins: Sequence[Any]) -> str:
        """Whether springs detach at a force, from its margins if these are available."""
        leaving, least = self._shown("detachment"), f"{self.letter[0]}_cr"
        most = _one((margins or [leaving])[0], least)
        if margins:
            stay = f"stay attached up to {most}" if most else "stay attached"
            return f"Its springs {'detach' if margins[0].detaches else stay}."
        if most is None:
            return f"{leaving.message[:1].upper()}{leaving.message[1:]}."
        attached = F < getattr(leaving, least)
        return f"Its springs {f'stay attached up to {most}' if attached else f'detach above {most}'}."

    def design(self) -> Iterator[str]:
        """The numbers that were given, and what they mean at rest."""
        heads: tuple[str, ...] = ("parameter", "value")
        sheet = self.mount.scales.sheet if self.mount else self.of.given
        rows: list[Any] = [(page.inline(name), page.cell(value)) for name, value in sheet.items()]
        if self.mount:
            heads = (*heads, "unit", "meaning")
            known = [DATA_SHEET[name] for name in sheet]
            rows = [(*row, unit, page.prose(meaning)) for row, (unit, meaning) in zip(rows, known, strict=True)]
        yield page.table("Design data", heads, rows)
        for text in self.scene.warnings:
            yield f"<p>Note: {page.inline(text)}</p>"
        if self.plain.load != 0:
            yield _table("Equilibrium under the load", self._shown("rest"))
        elif self.mount:
            found = self._shown("at_rest")
            units = found.units_of_columns()
            at_rest = [
                (page.inline(name), page.cell(value), escape(units.get(name, "")), page.prose(MEANING[name]))
                for name, (value,) in found.columns().items()
                if not np.isnan(value)
            ]
            yield page.table("At rest", ("quantity", *heads[1:]), at_rest)

    def answers(self) -> Iterator[str]:
        """What was asked at each force, and the forces from which on it jumps and its springs detach."""
        what, of_force = EXCITATION[self.excitation], self.plain.excitation == "force"
        left_out: list[str] = []
        if self.scene.frame:
            yield f"<p>{page.inline(self.scene.frame.capitalize())}.</p>"
        yield _table(f"Lowest {what} with jumps", self._shown("saddle_node_onset"))
        if self.plain.breakpoints:
            yield _table(f"Lowest {what} that detaches the springs", self._shown("detachment"))
        for question, caption in AT_EACH.items():
            if found := self._at_each(question, self.forcings, left_out):
                # a force moves the mass at all frequencies, or at none, which `sticks` says
                yield _table(caption, *found, left_out=(*UNSHOWN, *OF_INERTIA) if of_force else UNSHOWN)
        for question, caption in ALSO.items():
            queries = self.scene.of(question)
            if question == "isolation":  # that of 0 dB has its table
                queries = [one for one in queries if one.arguments.get("level_dB")]
            if also := [self.scene.answer(one) for one in queries]:
                yield _table(caption, *also)
        yield _left_out(left_out)

    def curves(self) -> Iterator[str]:
        """Amplitude and transmissibility over frequency, of all forces."""
        if not self.forcings:
            return
        windows = (one.arguments for one in self.scene.of("frequency_response"))
        own = {name: value for name, value in next(windows, {}).items() if name not in FORCINGS}  # the scene's window
        curves = [self._shown("frequency_response", F, **own) for F in self.forcings]
        folds = [self._shown("saddle_nodes", F) for F in self.forcings]
        letter, _, size = self._called("u")
        length = self.mount.scales.sizes["length"] / size if self.mount else 1.0
        # off the centre springs detach on one side first, where the largest displacement passes the stroke
        largest, what = ("A", "Amplitude") if self.plain.load == 0 else (f"{letter}_max", "Largest displacement")
        for y, quantity in ((largest, what), ("transmissibility_dB", "Transmissibility in decibels")):
            ax = pictures.responses(page.axes(), list(zip(curves, folds, strict=True)), y)
            if y == largest:
                pictures.breakpoints(ax, [length * end for end in self.plain.breakpoints], letter)
            pictures.legend(ax, pictures.axis(curves[0], self.letter), place="below")
            yield page.figure(
                ax, f"{quantity} over frequency, for each amplitude of the excitation. Unstable motions are dashed."
            )

    def locus(self) -> Iterator[str]:
        """The folds of every forcing, if the scene asks for them."""
        for one in self.scene.of("fold_locus"):
            ax = pictures.locus(page.axes(), self.scene.answer(one))
            yield page.figure(ax, "Fold locus: amplitude of the excitation over its frequency.")

    def spectrum(self) -> Iterator[str]:
        """A load spectrum, row by row."""
        for one in self.scene.of("spectrum"):
            yield _table("Response to each row of the load spectrum, as a single tone", self.scene.answer(one))

    def shocks(self) -> Iterator[str]:
        """What the scene asks of shocks, by the equation of motion."""
        queries = self._cases("transient")
        found = [self.scene.answer(one) for one in queries]
        if found:
            pulses = [one.numbers() for one in queries]
            more = (*UNSHOWN, "x_cr", "u_cr", "t_A", "tau_A", "t_a", "tau_a", "t_detaches", "tau_detaches")
            stroke = _one(found[0], "x_cr", "u_cr")
            remark = f" (the springs detach at {stroke})" if stroke else ""
            yield _table(
                f"Shocks of the base, by the equation of motion{remark}",
                *found,
                leading=pulses,
                units=queries[0].units(),
                left_out=more,
            )
            worst = max(range(len(found)), key=lambda k: float(found[k].columns()["A"][0]))
            ax = pictures.history(page.axes(), found[worst], "below")
            _, _, shock = str(queries[worst]).partition(" at ")  # nothing of a record
            caption = "The motion of the mass, relative to its base, in the shock with the largest deflection"
            yield page.figure(ax, f"{caption}{shock and ': ' + shock}.")
        for one in self.scene.of("shock_spectrum"):
            answer: Any = self.scene.answer(one)
            if not found:
                yield _table("Shocks of the base, by the equation of motion", answer)
            ax = pictures.shocks(page.axes(), answer, "below")
            yield page.figure(
                ax, "The largest acceleration of the mass over that of the pulse, as a function of the duration."
            )

    def random(self) -> Iterator[str]:
        """What the scene asks of random vibration, by statistical linearization."""
        for one in self._cases("random"):
            found: Any = self.scene.answer(one)
            yield _table("Stationary response to the spectral density, by statistical linearization", found)
            ax = pictures.psd(page.axes(), found, "below")
            yield page.figure(
                ax, "The one-sided spectral density of the displacement of the mass, relative to its base."
            )

    def loop(self) -> Iterator[str]:
        """A force-displacement loop that was measured, and the one of the design."""
        if self.scene.loop:
            x, F, force = loop_of_design(self.of, **self.scene.loop)
            (of_x, mm), (of_F, N) = in_shown("m"), in_shown("N")
            names = pictures.measured("x", of_x), pictures.measured("F", of_F)
            ax = pictures.loop(page.axes(), x / mm, F / N, force / N, names, "design")
            rms = float(np.sqrt(np.mean((F - force) ** 2)))
            difference = (
                f"{rms / N:.3g} {of_F} RMS, {100 * rms / float(np.ptp(F) / 2):.2g} % of the amplitude of the force"
            )
            yield page.figure(
                ax, f"The measured loop of one mount and the loop of this design. They differ by {difference}."
            )

    def tolerances(self) -> Iterator[str]:
        """What the scene asks of tolerances."""
        queries = self.scene.of("tolerances")
        if queries:
            shares = queries[0].arguments["within"].items()
            within = ", ".join(f"{page.inline(name)} within {100 * fraction:g} %" for name, fraction in shares)
            yield f"<p>Tolerances: {within}. For each result, 95 % of the designs lie between low and high.</p>"
        for one in queries:
            found: Any = self.scene.answer(one)
            yield _table(f"T{str(one)[1:]}", found)
            if len(found) > FEW:
                ax = pictures.bands(page.axes(), found)
                yield page.figure(
                    ax,
                    f"The range of 95 % of the designs over the nominal value, shown up to {pictures.WIDEST:g}: {one}.",
                )

    def map(self) -> Iterator[str]:
        """From which force on neighbouring designs jump."""
        subject = Subject(self.of)
        if subject.loaded:
            raise NotAvailable("a map of designs under a load, as each of its points takes tenths of a second")
        names = [name for name in map(subject.name, subject.mechanism.design_names) if subject.nominal[name]]
        if len(names) < 2:
            return
        *_, x, y = names
        factors = np.linspace(1 - REACH, 1 + REACH, MAPPED)
        columns, rows = subject.nominal[x] * factors, subject.nominal[y] * factors
        onset = next(name for name, plain in subject.answers.items() if plain == "F_SN")
        values = subject.ask({x: columns[None, :], y: rows[:, None]}, [onset], Load(None, None, None))[onset]
        if not np.isfinite(values).any():
            raise NotAvailable("a map of designs, none of which has a lowest amplitude of the excitation with a jump")
        in_si = (SHEET[x], SHEET[y]) if subject.mount else ("", "")
        units, (of_x, of_y, of_onset) = zip(*map(in_shown, (*in_si, subject.unit(onset))), strict=True)
        name_x, name_y, name = map(pictures.measured, (x, y, onset), units)
        found = (name, np.where(np.isfinite(values), values / of_onset, np.nan))
        ax = pictures.design_map(page.axes(), (name_x, columns / of_x), (name_y, rows / of_y), found)
        ax.plot(subject.nominal[x] / of_x, subject.nominal[y] / of_y, "o", color="white", markeredgecolor="black")
        what, over = EXCITATION[self.excitation], f"{x} and {y}"
        yield page.figure(ax, f"Lowest {what} with jumps, over {over}. The circle marks this design.")

    def trust(self) -> Iterator[str]:
        """Jumps by averaging, the second approximation and the equation of motion; amplitudes; curves."""
        if not self.forcings:
            return
        left_out: list[str] = []
        yield from _available(self._jumps_by_depths(left_out))
        measured = self.plain.load == 0 and is_measured(self.plain.model)
        yield from self._expected() if measured else self._checked()
        yield from self._depths(max(self.forcings), left_out)
        yield _left_out(left_out)

    def _jumps_by_depths(self, left_out: list[str]) -> Iterator[str]:
        """Each jump by averaging, with higher harmonics, and by the equation of motion."""
        unit = self.mount.scales.sizes["frequency"] if self.mount else 1.0
        rows = []
        for F in self.forcings:
            found, plain = self._ask("saddle_nodes", F), self._plainly("saddle_nodes", F)
            if not len(plain):
                continue
            try:
                better = [f"{f:.5g}" for f in getattr(self.of.second_approximation.saddle_nodes(F), self.f)]
                seconds = better if len(better) == len(found) else ["another number of folds"] * len(found)
            except NotAvailable as error:
                seconds = ["left out"] * len(found)
                left_out.append(str(error))
            for fold, exact, second in zip(found, plain.measure(), seconds, strict=True):
                last = (f"{exact.Omega * unit:.5g}", _error(exact.error))
                last = (escape(exact.reason), "") if exact.reason else last
                rows.append((self._in_unit(F), fold.kind, f"{getattr(fold, self.f):.5g}", second, *last))
        if not rows:
            yield "<p>There is no jump at these amplitudes of the excitation.</p>"
            return
        of_F, of_f = self._heads("F_0", "Omega")
        heads = (of_F, "kind", f"{of_f}, averaged", "second approximation", *BY_MOTION)
        caption = "Jump frequencies by averaging, by the second approximation and by the equation of motion"
        yield page.table(caption, heads, rows)

    def _checked(self) -> Iterator[str]:
        """The largest displacement by averaging and by the equation of motion, at the frequencies asked for."""
        _, of_A, size = self._called("A")
        rows = []
        for F in self.forcings:
            for at in self._frequencies():
                arguments = {self.f: at, self.letter: F}
                states = self.scene.ask("amplitudes", **arguments)
                if states.stable.any():
                    # off the centre A is about the mean
                    A = float(getattr(states, pictures.height(states))[states.stable].max())
                    try:
                        exact = self.of.steady_state(**arguments, A=A).A
                        compared = (f"{exact / size:.5g}", _error(A / exact - 1))
                    except ArithmeticError as error:
                        compared = (escape(str(error)), "")
                    rows.append((self._in_unit(F), f"{at:.4g}", f"{A / size:.5g}", *compared))
        heads = [*self._heads("F_0", "Omega"), f"averaged / {of_A}" if of_A else "averaged", *BY_MOTION]
        if rows:
            yield page.table("The largest displacement by averaging and by the equation of motion", heads, rows)
        else:
            yield "<p>Not compared with the equation of motion: the scene requests amplitudes at no frequency.</p>"

    def _expected(self) -> Iterator[str]:
        """What measurements say of the error of the highest motion, and of the curve's other points."""
        rows, remarks = [], []
        for F in self.forcings:
            curve = self._plainly("frequency_response", F)
            stable = np.flatnonzero(curve.stable)
            if stable.size:
                top, known = stable[curve.A[stable].argmax()], curve.validity
                shares = (
                    "" if np.isnan(one[top]) else f"{100 * one[top]:.2g} %" for one in (known.typical, known.error)
                )
                rows.append((self._in_unit(F), f"{known.ratio[top]:.3g}", *shares))
                if message := in_units(known.message, self.mount.scales if self.mount else None):
                    at = f"{self._in_unit(F)} {self.unit}".rstrip()
                    remarks.append(f"<p>Other points of the curve at {at}: {page.inline(message)}.</p>")
        if rows:
            heads = (*self._heads("F_0"), "friction / force", "median", "95th percentile")
            yield page.table("Error of the largest stable amplitude, measured on similar isolators", heads, rows)
        yield from remarks

    def _depths(self, F: float, left_out: list[str]) -> Iterator[str]:
        """The curve about its peak by averaging, with higher harmonics, and of the equation of motion."""
        peaks = self._at_each("peak", [F], left_out)
        at = getattr(peaks[0], self.f) if peaks else None
        if not at:
            return
        window = {self.f: (AROUND[0] * at, AROUND[1] * at)}
        curves: dict[str, Callable[[], Any]] = {
            "averaging": lambda: self.of.frequency_response(F, **window),
            "second approximation": lambda: self.of.second_approximation.frequency_response(F, **window),
            "equation of motion": lambda: self.of.exact_response(F, **window),
        }
        found, missing = {}, []
        for depth, ask in curves.items():
            try:
                curve = ask()
            except (ValueError, ArithmeticError) as error:
                left_out.append(_reason(depth, error))
                continue
            found[depth] = shown(curve)
            if not getattr(curve, "complete", True):
                missing.append(f"<p>By the {depth} {page.inline(curve.message)}.</p>")
        if len(found) > 1:
            ax = pictures.depths(page.axes(), found)
            at_F = f"{self._in_unit(F)} {self.unit}" if self.unit else f"{self.letter} = {F:g}"
            caption = f"by {'two' if len(found) == 2 else 'three'} methods of increasing accuracy."
            yield page.figure(ax, f"The response at {at_F} near its peak, {caption}")
        yield from missing

    def equations(self) -> Iterator[str]:
        """Those of the paper, of an isolator, that the derivation proves."""
        if not isinstance(self.plain, Isolator):
            return
        ledger = read_ledger()
        rows = [
            (row["where"], page.prose(row["quantity"]), page.formula(row["mathml"], row["published"]))
            for row in ledger["rows"]
            if row["kind"] == "formula" and row["where"] in EQUATIONS and row["verdict"] in PROVED
        ]
        yield f"<p>Equations of {escape(ledger['paper'])}, each proved by the derivation.</p>"
        if self.plain.load != 0:
            remark = "with the balance of the mean, which is not in the paper"
            yield f"<p>Under a load they apply to motions about a mean B, {remark}.</p>"
        yield page.table(
            "Averaged equations and their origin", ("number", "quantity", "expression that vanishes, or value"), rows
        )

    def data(self) -> Iterator[str]:
        """Answers as files, and the scene."""
        texts = {}
        for question in ("saddle_nodes", "frequency_response") if self.forcings else ():
            with contextlib.suppress(SlowflowError):
                found = [({self.letter: F / self.size}, self._shown(question, F)) for F in self.forcings]
                texts[question] = files.in_csv(found, {self.letter: self.unit})
        for question in ("spectrum", "tolerances", "transient", "shock_spectrum"):
            if queries := self.scene.of(question):
                with contextlib.suppress(SlowflowError):  # its own section says so
                    answers = [(one.numbers(), self.scene.answer(one)) for one in queries]
                    texts[question] = files.in_csv(answers, queries[0].units())
        links = [page.download(f"{question}.csv", "text/csv", text) for question, text in texts.items()]
        links.append(page.download(self.scene.path.name, "application/toml", self.scene.text))
        yield from ("<ul>", *(f"<li>{link}</li>" for link in links), "</ul>")
        made_from = f"scene {escape(self.scene.path.name)}, sha256 {self.scene.sha256}"
        yield f"<p>slowflow {slowflow.__version__}; {made_from}</p>"


# ---- pieces


def _one(answer: Any, *names: str) -> str | None:
    """A number of an answer, the first of these that it has, with its unit; None where there is none."""
    name = next(name for name in names if hasattr(answer, name))
    value = getattr(answer, name)
    return None if value is None else _number(answer, value, name)


def _number(answer: Any, value: float, name: str) -> str:
    """A number with the unit that a name has in the answer; without dimensions with that name."""
    units = answer.units_of_columns()
    return f"{value:.4g}{page.TIED}{units[name]}" if name in units else f"{name} = {value:.4g}"


def _error(relative: float) -> str:
    """An error in percent; one that the printed digits do not show is not printed in powers of ten."""
    return f"{100 * relative:+.2g} %" if abs(relative) >= UNSEEN else f"below {100 * UNSEEN:g} %"


def _table(
    caption: str,
    *answers: Answer,
    leading: Sequence[Mapping[str, Any]] = (),
    units: Mapping[str, str] = {},
    left_out: Sequence[str] = UNSHOWN,
) -> str:
    """Columns of answers to one question, one below the other, and their messages.

    leading  -- numbers to put before the rows of each, by default its forcing, and units of these
    left_out -- columns that are not shown
    """
    columns = [answer.columns() for answer in answers]
    units = {**answers[0].units_of_columns(), **units}
    kept = [name for name in columns[0] if name not in left_out]
    kept.sort(key=lambda name: name not in pictures.AMPLITUDES or answers[0].has_rows)  # what it is asked at first
    before = leading or [_forcing_of(answer, kept) for answer in answers]
    heads = [page.term(name, units.get(name, "")) for name in (*before[0], *kept)]
    cells = [
        (at, [_cell(answers[0], name, value) for name, value in zip(kept, row, strict=True)])
        for found, at in zip(columns, before, strict=True)
        for row in zip(*(found[name].tolist() for name in kept), strict=True)
    ]
    notes = _notes(answers, leading or [_forcing_of(answer, ()) for answer in answers], units)
    found_any = any(
        cell and name not in pictures.AMPLITUDES for _, row in cells for name, cell in zip(kept, row, strict=True)
    )
    if not found_any:
        return page.untabled(caption, notes)
    rows = [(*map(page.cell, at.values()), *row) for at, row in cells]
    return page.table(caption, heads, rows) + notes


def _cell(answer: Answer, name: str, value: Any) -> str:
    """A cell of a column; one that names a number has that as it is read."""
    if name in NAMES:
        return f"{page.TEXT}{page.term(value)}"
    return answer.text_of(name, value) or page.cell(value)


def _notes(answers: Sequence[Answer], before: Sequence[Mapping[str, Any]], units: Mapping[str, str]) -> str:
    """What answers have to say, and which ones where these are not all."""
    by_message: dict[str, list[str]] = {}
    for answer, arguments in zip(answers, before, strict=True):
        if message := str(answer.to_dict().get("message") or "").replace(IN_PYTHON, ""):
            at = " and ".join(_at(name, value, units) for name, value in arguments.items())
            # some say by themselves at which forcing
            by_message.setdefault(message, []).append("" if any(f" {name} = " in message for name in arguments) else at)
    of = {
        text: f"At {', '.join(at)}: " if len(at) < len(answers) and all(at) else "" for text, at in by_message.items()
    }
    return "".join(f"<p>{page.inline(at + text)}.</p>" for text, at in of.items())


def _at(name: str, value: Any, units: Mapping[str, str]) -> str:
    """A description of an argument of an answer."""
    return f"{name} = {page.cell(value)} {units.get(name, '').replace('^2', '²')}".rstrip()


def _forcing_of(answer: Answer, kept: Iterable[str]) -> dict[str, Any]:
    """The forcing of an answer, where it is no column of it."""
    known = answer.to_dict()
    return {name: known[name] for name in pictures.AMPLITUDES if name in known and name not in kept}


def read_ledger() -> dict[str, Any]:
    """The ledger for programs, as the derivation wrote it beside the kernels."""
    text = resources.files("slowflow_kernels").joinpath("ledger.json").read_text(encoding="utf-8")
    ledger: dict[str, Any] = json.loads(text)
    return ledger
