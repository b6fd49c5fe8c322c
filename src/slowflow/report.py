"""The report of a scene: in goes a scene with forcings, out comes one HTML page that needs no network.

The answers with their margins, curves, transmissibility, a map of designs with the one at hand, how far to trust each
jump, the equations with their verdicts, and the data. Pictures are drawn by Matplotlib into the page. What an
oscillator has no answer to, as one under a load or with another law of damping, is left out, and that is said.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from html import escape
from importlib import resources
from typing import Any

import numpy as np

import slowflow
from slowflow import files, page, pictures
from slowflow.answer import Answer, head, shown
from slowflow.isolator import Isolator
from slowflow.measured.validity import IN_PYTHON
from slowflow.physical import Physical
from slowflow.quantities import SHEET, SHOWN, UNITS, Quantities, in_shown
from slowflow.results import Remark
from slowflow.scenes import FORCINGS, Scene
from slowflow.sizing.subject import Load, Subject
from slowflow.table import COLUMNS, SHOCKS
from slowflow.text import in_units
from slowflow.validate import NotAvailable
from slowflow_support.errors import Refused

#: equations of the paper that the answers rest on
EQUATIONS = ("(3)", "(4)", "(5)", "(6)", "(7)", "(21)", "(22)", "(24)", "(25)", "(27)", "(30)", "(33)", "(34)")
#: designs of the map along each of two numbers, and how far these reach from the design at hand
MAPPED, REACH = 60, 0.5
#: amplitudes of what
EXCITATION = {"force": "force", "base": "motion of the base", "unbalance": "unbalance"}
#: columns that tables leave out: words beside them have them
UNSHOWN = ("message", "remarks")
#: and what is not of a force
OF_INERTIA = ("f_sticks", "Omega_sticks")
#: columns that hold names of numbers
NAMES = ("answer", "parameter")
#: bands that need no picture
FEW = 2
#: what else a scene may ask for that is a table
ALSO = {
    "isolation": "From this frequency on less than a level is transmitted",
    "amplitudes": "Motions at the frequencies asked for",
    "cusps": "Where two folds come into being or meet",
    "isola_points": "Where isolated curves are born or merge",
}
#: numbers of the map, of a mount and of an isolator without dimensions
OF_MOUNT, OF_ISOLATOR = ("k_h", "preload"), ("r", "delta_h")
NUMBERS = {"k_h": "the stiffness of the springs", "preload": "their preload", "r": "the stiffness ratio"}
NUMBERS |= {"delta_h": "the preload"}

#: what the numbers of a mount are; then what a data sheet's mean
GIVEN = {
    "m": "mass for which the vertical spring is preset",
    "load": "mass that sits on it, where that is another one",
    "k_v": "stiffness of the vertical spring",
    "k_h": "stiffness of each horizontal spring",
    "n": "number of horizontal springs",
    "L": "length of a push-rod",
    "preload": "compression of a horizontal spring at the centre",
    "friction": "dry friction",
    "static_friction": "dry friction that holds a mass at rest",
    "c": "viscous damping",
    "zeta": "viscous damping ratio, c over 2 √(k_v m)",
    "eta": "loss factor of the vertical spring",
    "c_2": "quadratic damping",
    "rubs": "where friction acts",
    "force": "the springs' force that is averaged: truncated (6), or untruncated (5)",
    "excitation": "what shakes it",
}
MEANING = {one.si or one.name: one.text for one in COLUMNS.values()} | {
    "f_n": "natural frequency of the mass on the vertical spring alone",
    "x_cr": "stroke, at which the horizontal springs leave",
    "sticking": "force amplitude up to which averaging has the mass at rest",
    "rests_within": "how far from the centre friction holds the mass at rest",
    "preset": "compression of the vertical spring that holds the mass at the centre",
    "lightest": "mass that would rest at the upper end of the stroke",
    "heaviest": "mass that would rest at its lower end",
}
#: errors that numbers of five digits do not show
UNSEEN = 1e-5
#: around the frequency of the peak, in its multiples, where the three depths are drawn
BESIDE = (0.8, 1.2)


def html(scene: Scene) -> str:
    """The page. Raises ValueError where the scene has no forcing and no shock, or its oscillator is no isolator."""
    forcings = scene.forcings()
    shocks = any(one.question in SHOCKS for one in scene.asked)
    if not forcings and not shocks:
        raise Refused(f"{scene.path}: a report needs forcings in [ask], or a shock")
    of = scene.oscillator
    if not isinstance(_plain(of), Isolator):
        raise Refused(f"{scene.path}: a report is of an isolator: the scene must hold [mount] or [isolator]")
    title = f"Vibration isolator: {scene.path.stem.replace('_', ' ')}"
    sections = {
        "In short": _summary(forcings, scene),
        "The design": _design(of, scene),
        "What it does": _answers(of, forcings, scene),
        "Curves": _curves(of, forcings, scene),
        "Folds": _locus(scene),
        "Load spectrum": _spectrum(scene),
        "Shocks": _shocks(scene),
        "Tolerances": _tolerances(scene),
        "Designs beside it": _map(of),
        "How far to trust it": _trust(of, forcings, scene),
        "Equations": _equations(of),
        "Data": _data(of, forcings, scene),
    }
    told = {name: parts for name, section in sections.items() if (parts := list(_available(section)))}
    return page.whole(title, told)


def _plain(of: Any) -> Any:
    """The oscillator without dimensions."""
    return of.oscillator if isinstance(of, Physical) else of


def _available(section: Iterator[str]) -> Iterator[str]:
    """The parts of a section, and what it cannot have."""
    try:
        yield from section
    except NotAvailable as error:
        yield _left_out([str(error)])


def _left_out(reasons: Sequence[str]) -> str:
    """Why parts are missing; nothing where none is."""
    return "".join(f"<p>Left out: {page.inline(reason)}.</p>" for reason in reasons)


def _forced_by(scene: Scene, F: float) -> dict[str, float]:
    """The amplitude of the excitation as an argument of a question."""
    return {"F" if isinstance(scene.oscillator, Physical) else "F_0": F}


def _at_each(scene: Scene, question: str, forcings: Sequence[float], left_out: list[str]) -> list[Any]:
    """The answers at each forcing; none where such an oscillator has none, and why is added to `left_out`."""
    try:
        return [shown(scene.ask(question, **_forced_by(scene, F))) for F in forcings]
    except NotAvailable as error:
        said = str(error)
        left_out.append(said if question in said else f"{question}: {said}")
        return []


def _called(of: Any, name: str = "F_0") -> tuple[str, str, float]:
    """What a number is called, in which unit it is shown, and that one's size; none and 1 without dimensions."""
    if not isinstance(of, Physical):
        return name, "", 1.0
    symbol, kind = of.scales.kind(name)
    return symbol, SHOWN[kind], UNITS[kind][SHOWN[kind]]


def _told(of: Any, F: float) -> str:
    """An amplitude of the excitation in its unit."""
    return f"{F / _called(of)[2]:.4g}"


# ---- sections


def _summary(forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    """A few sentences for each force, and for the shocks."""
    lines = [" ".join([*_in_short(scene, F), *_transmitted(scene, F)]) for F in forcings]
    lines += _of_shocks(scene)
    if lines:
        yield f"<ul>{''.join(f'<li>{page.inline(line)}</li>' for line in lines)}</ul>"


def _frequencies(scene: Scene) -> Sequence[float]:
    """Those at which the scene asks for motions."""
    asked = (one.arguments for one in scene.of("amplitudes"))
    return next((given.get("f", given.get("Omega")) for given in asked), ())


def _transmitted(scene: Scene, F: float) -> Iterator[str]:
    """What stable motions transmit at the frequencies asked for."""
    name, *_ = _called(scene.oscillator, "Omega")
    for at in _frequencies(scene):
        states = shown(scene.ask("amplitudes", **{name: at}, **_forced_by(scene, F)))
        if found := [f"{one:.4g}" for one in states.transmissibility_dB[states.stable].tolist()]:
            yield f"At {_number(states, at, name)} it transmits {' or '.join(found)} dB."


def _of_shocks(scene: Scene) -> Iterator[str]:
    """How many of the half sines lift the springs, and the worst of them."""
    answers = [(one, scene.answer(one)) for one in scene.of("transient")]
    if not answers:
        return
    for name, most in (("A", "deflects it most, by"), ("a_max", "accelerates it most, to")):
        one, found = max(answers, key=lambda pair: float(pair[1].columns()[name][0]))
        shock = str(one).partition(" at ")[2]
        yield f"The shock that {most} {_one(found, name)}{f', has {shock}' if shock else ''}."
    leave, count = sum(bool(found.columns()["detaches"][0]) for _, found in answers), len(answers)
    yield f"In {leave} of {count} shocks the springs leave." if count > 1 else "Its springs leave." if leave else ""


def _in_short(scene: Scene, F: float) -> Iterator[str]:
    folds = shown(scene.ask("saddle_nodes", **_forced_by(scene, F)))
    onset, leaving = shown(scene.ask("saddle_node_onset")), shown(scene.ask("detachment"))
    # without these the sentence is shorter; what is left out is said further down
    margins, peak, isolation = (_at_each(scene, one, [F], []) for one in ("margins", "peak", "isolation"))
    yield f"At {_one(folds, *pictures.AMPLITUDES)}"
    if _plain(scene.oscillator).model.sticks(folds.answer.F_0 if isinstance(folds, Quantities) else folds.F_0):
        yield "friction holds the mass: it does not move."
        return
    if len(folds):
        jumps = zip(folds.kind.tolist(), getattr(folds, _called(scene.oscillator, "Omega")[0]).tolist(), strict=True)
        at = ", ".join(f"{kind.replace('-', 's ')} at {_number(folds, x, 'f', 'Omega')}" for kind, x in jumps)
        yield f"it {at};"
    elif (lowest := _one(onset, *(f"{letter[0]}_SN" for letter in pictures.AMPLITUDES))) is None:
        yield "it does not jump, nor at any other amplitude of the excitation;"
    else:
        yield f"it does not jump: it would from {lowest} on;"
    least = [f"{letter[0]}_cr" for letter in pictures.AMPLITUDES]
    if not margins:
        name = next(name for name in least if hasattr(leaving, name))
        if (most := _one(leaving, name)) is None:
            yield f"{leaving.message}."
        else:
            yield f"its springs {f'leave from {most} on' if F >= getattr(leaving, name) else f'stay up to {most}'}."
    elif margins[0].detaches:
        yield "its springs leave."
    else:
        most = _one(margins[0], *least)
        yield "its springs stay" + (f" up to {most}." if most is not None else ".")
    if peak and peak[0].A is not None:
        yield f"Its highest motion is {_one(peak[0], 'A')}, at {_one(peak[0], 'f', 'Omega')}."
    if isolation and (begin := _one(isolation[0], "f", "Omega")) is not None:
        open_ = ", as far as is decided" if isolation[0].remarks & Remark.UNDECIDED else ""
        yield f"From {begin} on it transmits less than what drives it{open_}."
    for one in scene.asked:
        level = one.arguments.get("level_dB", 0.0) if one.question == "isolation" and one.forcing == F else 0.0
        if level and (begin := _one(scene.answer(one), "f", "Omega")) is not None:
            yield f"From {begin} on it transmits less than {level:g} dB."


def _one(answer: Any, *names: str) -> str | None:
    """A number of an answer, the first of these that it has, with its unit; None where there is none."""
    name = next(name for name in names if hasattr(answer, name))
    value = getattr(answer, name)
    return None if value is None else _number(answer, value, name)


def _number(answer: Any, value: float, *names: str) -> str:
    """A number with the unit that the first of these names has in the answer; without dimensions with its name."""
    units = answer.units_of_columns()
    name = next(name for name in names if hasattr(answer, name))
    return f"{value:.4g}{page.TIED}{units[name]}" if name in units else f"{name} = {value:.4g}"


def _design(of: Any, scene: Scene) -> Iterator[str]:
    mount = isinstance(of, Physical)
    given = of.scales.sheet if mount else of.given
    if mount:
        rows = [
            (page.inline(name), page.cell(value), SHEET[name], page.words(GIVEN[name])) for name, value in given.items()
        ]
        yield page.table("As it was given", ("number", "value", "unit", "what it is"), rows)
    else:
        numbers = [(page.inline(name), page.cell(value)) for name, value in given.items()]
        yield page.table("As it was given", ("number", "value"), numbers)
    for text in scene.warnings:
        yield f"<p>Note: {page.inline(text)}</p>"
    if mount and _plain(of).load == 0:
        centred = shown(scene.ask("at_rest"))
        units = centred.units_of_columns()
        found = {name: column[0] for name, column in centred.columns().items()}
        at_rest = [
            (page.inline(name), page.cell(value), escape(units.get(name, "")), page.words(MEANING[name]))
            for name, value in found.items()
            if not np.isnan(value)
        ]
        yield page.table("At rest", ("number", "value", "unit", "what it is"), at_rest)
    elif _plain(of).load != 0:
        yield _table("Where it stands under its load", shown(scene.ask("rest")))


def _answers(of: Any, forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    what, of_force = EXCITATION[_plain(of).excitation], _plain(of).excitation == "force"
    left_out: list[str] = []
    yield _table(f"It jumps from this {what} on", shown(scene.ask("saddle_node_onset")))
    yield _table(f"Its springs leave from this {what} on", shown(scene.ask("detachment")))
    for caption, question in (
        ("Margins to jumps and to detachment: above 1 is safe", "margins"),
        ("The highest peak", "peak"),
        ("Less is transmitted from this frequency on than what drives it", "isolation"),
        ("Where a sweep jumps", "saddle_nodes"),
        ("Bands with several stable motions", "hysteresis"),
    ):
        if found := _at_each(scene, question, forcings, left_out):
            # a force moves the mass at all frequencies, or at none, which `sticks` says
            yield _table(caption, *found, left_out=(*UNSHOWN, *OF_INERTIA) if of_force else UNSHOWN)
    for question, caption in ALSO.items():
        asked = scene.of(question)
        if question == "isolation":  # that of 0 dB has its table
            asked = [one for one in asked if one.arguments.get("level_dB")]
        if also := [scene.answer(one) for one in asked]:
            yield _table(caption, *also)
    yield _left_out(left_out)


def _curves(of: Any, forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    if not forcings:
        return
    asked = (one.arguments for one in scene.of("frequency_response"))
    own = {name: value for name, value in next(asked, {}).items() if name not in FORCINGS}  # the scene's window
    curves = [shown(scene.ask("frequency_response", **_forced_by(scene, F), **own)) for F in forcings]
    folds = [shown(scene.ask("saddle_nodes", **_forced_by(scene, F))) for F in forcings]
    force, *_ = _called(of)
    oscillator = _plain(of)
    letter, _, size = _called(of, "u")
    length = of.scales.sizes["length"] / size if isinstance(of, Physical) else 1.0
    # off the centre springs leave on one side first, where the largest displacement passes the stroke
    largest = "A" if oscillator.load == 0 else f"{letter}_max"
    what = "Amplitude" if oscillator.load == 0 else "Largest displacement"
    for y, said in ((largest, what), ("transmissibility_dB", "Transmissibility in decibels")):
        ax = pictures.responses(page.axes(), list(zip(curves, folds, strict=True)), y)
        if y == largest:
            pictures.breakpoints(ax, [length * end for end in oscillator.breakpoints], letter)
        pictures.legend(ax, pictures.axis(curves[0], force), place="below")
        yield page.figure(
            ax, f"{said} over frequency, a curve for each amplitude of the excitation; unstable motions dashed."
        )


def _locus(scene: Scene) -> Iterator[str]:
    """The folds of every forcing, if the scene asks for them."""
    for one in scene.of("fold_locus"):
        ax = pictures.locus(page.axes(), scene.answer(one))
        yield page.figure(ax, "The amplitudes of the excitation that have a fold, over its frequency.")


def _spectrum(scene: Scene) -> Iterator[str]:
    for one in scene.of("spectrum"):
        yield _table("Each tone by itself, in the order of the table", scene.answer(one))


def _shocks(scene: Scene) -> Iterator[str]:
    """What the scene asks of shocks, by the equation of motion."""
    asked = scene.of("transient")
    found = [scene.answer(one) for one in asked]
    if found:
        pulses = [{head(name, one.units()): value for name, value in one.numbers().items()} for one in asked]
        more = (*UNSHOWN, "x_cr", "u_cr", "t_A", "tau_A", "t_a", "tau_a", "t_detaches", "tau_detaches")
        stroke = _one(found[0], "x_cr", "u_cr")
        leaves = f'; beyond the stroke, {stroke}, "detaches" says yes' if stroke else ""
        yield _table(f"Shocks of the base, by the equation of motion{leaves}", *found, beside=pulses, left_out=more)
        worst = max(range(len(found)), key=lambda k: float(found[k].columns()["A"][0]))
        ax = pictures.history(page.axes(), found[worst], "below")
        _, _, shock = str(asked[worst]).partition(" at ")  # nothing of a record
        said = "The motion of the mass, seen from its base, in the shock that deflects it most"
        yield page.figure(ax, f"{said}{shock and ': ' + shock}.")
    for one in scene.of("shock_spectrum"):
        answer: Any = scene.answer(one)
        if not found:
            yield _table("Shocks of the base, by the equation of motion", answer)
        ax = pictures.shocks(page.axes(), answer, "below")
        yield page.figure(ax, "The largest acceleration of the mass over the pulse's, over the duration of the pulse.")


def _tolerances(scene: Scene) -> Iterator[str]:
    """What the scene asks of tolerances."""
    asked = scene.of("tolerances")
    if asked:
        shares = asked[0].arguments["within"].items()
        within = ", ".join(f"{page.inline(name)} within {100 * share:g} %" for name, share in shares)
        yield f"<p>{within}; 95 of 100 lie between low and high.</p>"
    for one in asked:
        found: Any = scene.answer(one)
        yield _table(f"T{str(one)[1:]}", found)
        if len(found) > FEW:
            ax = pictures.bands(page.axes(), found)
            yield page.figure(ax, f"Where 95 of 100 designs lie, over the nominal value, as far as twice that: {one}.")


def _map(of: Any) -> Iterator[str]:
    subject = Subject(of)
    if subject.loaded or subject.laws:
        which = "under a load" if subject.loaded else "with other laws of damping than friction and viscous damping"
        raise NotAvailable(f"a map of designs {which}, as each of its points takes tenths of a second")
    x, y = OF_MOUNT if subject.mount else OF_ISOLATOR
    if not subject.nominal[y]:
        return
    share = np.linspace(1 - REACH, 1 + REACH, MAPPED)
    columns, rows = subject.nominal[x] * share, subject.nominal[y] * share
    onset = next(name for name, plain in subject.answers.items() if plain == "F_SN")
    values = subject.ask({x: columns[None, :], y: rows[:, None]}, [onset], Load(None, None, None))[onset]
    if not np.isfinite(values).any():
        raise NotAvailable("a map of designs, none of which has a lowest amplitude of the excitation with a jump")
    given = (SHEET[x], SHEET[y]) if subject.mount else ("", "")
    units, (of_x, of_y, of_onset) = zip(*map(in_shown, (*given, subject.unit(onset))), strict=True)
    name_x, name_y, name = map(pictures.measured, (x, y, onset), units)
    found = (name, np.where(np.isfinite(values), values / of_onset, np.nan))
    ax = pictures.design_map(page.axes(), (name_x, columns / of_x), (name_y, rows / of_y), found)
    ax.plot(subject.nominal[x] / of_x, subject.nominal[y] / of_y, "o", color="white", markeredgecolor="black")
    what = EXCITATION[subject.excitation]
    yield page.figure(
        ax, f"The {what} from which on it jumps, over {NUMBERS[x]} and {NUMBERS[y]}; the circle is the design at hand."
    )


def _trust(of: Any, forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    """Jumps by averaging, the second approximation and the equation of motion; amplitudes; curves."""
    if not forcings:
        return
    yield from _available(_jumps_by_depths(of, forcings, scene))
    plain = _plain(of)
    # measurements are of isolators under a force, about the centre, with viscous damping and dry friction
    is_measured = plain.excitation == "force" and plain.load == 0 and not plain.model.laws.told()
    yield from _expected(of, forcings, scene) if is_measured else _checked(of, forcings, scene)
    yield from _depths(of, max(forcings), scene)


def _jumps_by_depths(of: Any, forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    """Each jump by averaging, with higher harmonics, and by the equation of motion."""
    name, of_f, _ = _called(of, "Omega")
    rows = []
    for F in forcings:
        found = scene.ask("saddle_nodes", **_forced_by(scene, F))
        plain = found.answer if isinstance(found, Quantities) else found
        unit = of.scales.sizes["frequency"] if isinstance(of, Physical) else 1.0
        if not len(plain):
            continue
        exact = [(one.Omega * unit, one.error, one.reason) for one in plain.measure()]
        better = getattr(of.second_approximation.saddle_nodes(F), name)
        for k, fold in enumerate(found):
            second = f"{better[k]:.5g}" if len(better) == len(found) else "another number of folds"
            Omega, error, reason = exact[k]
            last = (f"{Omega:.5g}", _error(error)) if not reason else (escape(reason), "")
            rows.append((_told(of, F), fold.kind, f"{getattr(fold, name):.5g}", second, *last))
    if not rows:
        yield "<p>There is no jump at these amplitudes of the excitation.</p>"
        return
    heads = (
        page.term(*_called(of)[:2]),
        "kind",
        f"{page.term(name, of_f)}, averaged",
        "second approximation",
        "equation of motion",
        "error of averaging",
    )
    yield page.table("Each jump by averaging, with higher harmonics, and by the equation of motion itself", heads, rows)


def _checked(of: Any, forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    """The largest displacement by averaging and by the equation of motion, at the frequencies asked for."""
    (name, unit, _), (_, of_A, size) = _called(of, "Omega"), _called(of, "A")
    rows = []
    for F in forcings:
        for at in _frequencies(scene):
            states = scene.ask("amplitudes", **{name: at}, **_forced_by(scene, F))
            if states.stable.any():
                # off the centre A is about the mean
                largest = getattr(states, next(one for one in ("x_max", "u_max", "A") if hasattr(states, one)))
                A = float(largest[states.stable].max())
                try:
                    exact = of.steady_state(**{name: at, "A": A}, **_forced_by(scene, F)).A
                    compared = (f"{exact / size:.5g}", _error(A / exact - 1))
                except ArithmeticError as error:
                    compared = (escape(str(error)), "")
                rows.append((_told(of, F), f"{at:.4g}", f"{A / size:.5g}", *compared))
    averaged = f"averaged / {of_A}" if of_A else "averaged"
    heads = (page.term(*_called(of)[:2]), page.term(name, unit), averaged, "equation of motion", "error of averaging")
    if rows:
        yield page.table("The largest displacement by averaging and by the equation of motion itself", heads, rows)
    else:
        yield "<p>Not compared with the equation of motion: the scene asks for amplitudes at no frequency.</p>"


def _expected(of: Any, forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    """What measurements say of the error of the highest motion, and of the curve's other points."""
    rows, remarks = [], []
    force, unit, _ = _called(of)
    for F in forcings:
        found = scene.ask("frequency_response", **_forced_by(scene, F))
        curve = found.answer if isinstance(found, Quantities) else found
        stable = np.flatnonzero(curve.stable)
        if stable.size:
            top, known = stable[curve.A[stable].argmax()], curve.validity
            shares = ("" if np.isnan(one[top]) else f"{100 * one[top]:.2g} %" for one in (known.typical, known.error))
            rows.append((_told(of, F), f"{known.ratio[top]:.3g}", *shares))
            said = in_units(known.message, of.scales if isinstance(of, Physical) else None)
            remarks += (
                [f"<p>At {_told(of, F)}{unit and ' ' + unit} elsewhere on the curve: {page.inline(said)}.</p>"]
                if said
                else []
            )
    if rows:
        heads = (page.term(force, unit), "friction over force", "half of them within", "95 of 100 within")
        yield page.table("Error of the highest stable amplitude, as measured for such isolators", heads, rows)
    yield from remarks


def _depths(of: Any, F: float, scene: Scene) -> Iterator[str]:
    """The curve about its peak by averaging, with higher harmonics, and of the equation of motion."""
    name, *_ = _called(of, "Omega")
    left_out: list[str] = []
    peaks = _at_each(scene, "peak", [F], left_out)
    yield _left_out(left_out)
    at = getattr(peaks[0], name) if peaks else None
    if not at:
        return
    window = {name: (BESIDE[0] * at, BESIDE[1] * at)}
    curves: dict[str, Callable[[], Any]] = {"averaging": lambda: of.frequency_response(F, **window)}
    curves["second approximation"] = lambda: of.second_approximation.frequency_response(F, **window)
    curves["equation of motion"] = lambda: of.exact_response(F, **window)
    found, missing = {}, []
    for depth, ask in curves.items():
        try:
            curve = ask()
        except (ValueError, ArithmeticError) as error:
            missing.append(f"<p>No {depth} here: {page.inline(str(error))}.</p>")
            continue
        found[depth] = shown(curve)
        if not getattr(curve, "complete", True):
            missing.append(f"<p>By the {depth} {page.inline(curve.message)}.</p>")
    if len(found) > 1:
        ax = pictures.depths(page.axes(), found)
        force, unit, _ = _called(of)
        at_F = f"{_told(of, F)} {unit}" if unit else f"{force} = {F:g}"
        said = f"by {'two' if len(found) == 2 else 'three'} depths: they lie the closer the better."
        yield page.figure(ax, f"The response at {at_F} about its peak, {said}")
    yield from missing


def _equations(of: Any) -> Iterator[str]:
    ledger = read_ledger()
    rows = [
        (
            row["where"],
            f"{page.WORDS}{page.inline(row['quantity'])}",
            page.words(row["verdict"]),
            page.formula(row["mathml"], row["published"]),
        )
        for row in ledger["rows"]
        if row["kind"] == "formula" and row["where"] in EQUATIONS
    ]
    yield f"<p>Equations of {escape(ledger['paper'])}, each held against the derivation:</p>"
    if _plain(of).load != 0:
        yield "<p>Under a load these hold about a mean B, with its balance beside them, which the paper has not.</p>"
    yield page.table("Verdicts", ("equation", "what", "verdict", "as published; what vanishes, or the value"), rows)


def _data(of: Any, forcings: Sequence[float], scene: Scene) -> Iterator[str]:
    force, unit, size = _called(of)
    yield "<ul>"
    for question in ("saddle_nodes", "frequency_response") if forcings else ():
        found = [(F, shown(scene.ask(question, **_forced_by(scene, F)))) for F in forcings]
        text = files.in_csv([({force: F / size}, answer) for F, answer in found], {force: unit})
        yield f"<li>{page.download(f'{question}.csv', 'text/csv', text)}</li>"
    for question in ("spectrum", "tolerances", "transient", "shock_spectrum"):
        alike = scene.of(question)
        try:
            answers = [(one.numbers(), scene.answer(one)) for one in alike]
        except NotAvailable:  # its own section says so
            continue
        if alike:
            text = files.in_csv(answers, alike[0].units())
            yield f"<li>{page.download(f'{question}.csv', 'text/csv', text)}</li>"
    yield f"<li>{page.download(scene.path.name, 'application/toml', scene.text)}</li>"
    yield "</ul>"
    yield f"<p>slowflow {slowflow.__version__}; scene {escape(scene.path.name)}, sha256 {scene.sha256}</p>"


# ---- pieces


def _error(share: float) -> str:
    """An error in percent; one that the digits beside it do not show is not told in powers of ten."""
    return f"{100 * share:+.2g} %" if abs(share) >= UNSEEN else f"below {100 * UNSEEN:g} %"


def _table(
    caption: str, *answers: Answer, beside: Sequence[Mapping[str, Any]] = (), left_out: Sequence[str] = UNSHOWN
) -> str:
    """Columns of answers to one question, one below the other, and what is said beside them.

    beside   -- numbers to put before the rows of each, by default its forcing
    left_out -- columns that are not shown
    """
    columns = [answer.columns() for answer in answers]
    units = answers[0].units_of_columns()
    kept = [name for name in columns[0] if name not in left_out]
    kept.sort(key=lambda name: name not in pictures.AMPLITUDES or answers[0].has_rows)  # what it is asked at first
    before = beside or [_beside(answer, kept) for answer in answers]
    # what a pulse is has its unit in its name
    heads = [page.term(*_with_unit(name)) for name in before[0]] if beside else []
    heads = heads or [page.term(name, units.get(name, "")) for name in before[0]]
    heads += [page.term(name, units.get(name, "")) for name in kept]
    told = [
        (asked, [_cell(answers[0], name, value) for name, value in zip(kept, row, strict=True)])
        for found, asked in zip(columns, before, strict=True)
        for row in zip(*(found[name].tolist() for name in kept), strict=True)
    ]
    notes = _notes(answers, beside or [_beside(answer, ()) for answer in answers], units)
    found_any = any(
        cell and name not in pictures.AMPLITUDES for _, row in told for name, cell in zip(kept, row, strict=True)
    )
    if not found_any:
        return page.untabled(caption, notes)
    rows = [(*map(page.cell, asked.values()), *row) for asked, row in told]
    return page.table(caption, heads, rows) + notes


def _cell(answer: Answer, name: str, value: Any) -> str:
    """A cell of a column; one that names a number has that as it is read."""
    if name in NAMES:
        return f"{page.WORDS}{page.term(value)}"
    return answer.words_of(name, value) or page.cell(value)


def _notes(answers: Sequence[Answer], before: Sequence[Mapping[str, Any]], units: Mapping[str, str]) -> str:
    """What answers have to say, and which ones where these are not all."""
    told: dict[str, list[str]] = {}
    for answer, asked in zip(answers, before, strict=True):
        if message := str(answer.to_dict().get("message") or "").replace(IN_PYTHON, ""):
            at = " and ".join(_at(name, value, units) for name, value in asked.items())
            # some say by themselves at which forcing
            told.setdefault(message, []).append("" if any(f" {name} = " in message for name in asked) else at)
    of = {text: f"At {', '.join(at)}: " if len(at) < len(answers) and all(at) else "" for text, at in told.items()}
    return "".join(f"<p>{page.inline(at + text)}.</p>" for text, at in of.items())


def _with_unit(name: str) -> tuple[str, str]:
    """Of a name that has its unit in it: both."""
    name, _, unit = name.partition("/")
    return name, unit.removeprefix("(").removesuffix(")")


def _at(name: str, value: Any, units: Mapping[str, str]) -> str:
    """What an answer was asked at, in words."""
    name, unit = _with_unit(head(name, units))
    return f"{name} = {page.cell(value)} {unit.replace('^2', '²')}".rstrip()


def _beside(answer: Answer, kept: Iterable[str]) -> dict[str, Any]:
    """The forcing of an answer, where it is no column of it."""
    known = answer.to_dict()
    return {name: known[name] for name in pictures.AMPLITUDES if name in known and name not in kept}


def read_ledger() -> dict[str, Any]:
    """The ledger for programs, as the derivation wrote it beside the kernels."""
    text = resources.files("slowflow_kernels").joinpath("ledger.json").read_text(encoding="utf-8")
    ledger: dict[str, Any] = json.loads(text)
    return ledger
