"""Scenes to begin with. Takes nothing, or a measured force-displacement loop; returns a scene's text."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from slowflow.oscillators.isolator import Duffing
from slowflow.oscillators.measurements import read_csv
from slowflow.sizing import from_loop
from slowflow.support.errors import Refused

#: a scene to begin with
STARTER = """\
# slowflow run scene.toml           prints the answers
# slowflow run scene.toml -o DIR    writes them as CSV and JSON
# slowflow explain scene.toml       lists what runs

[mount]                 # a data sheet, in SI units: kg, N/m, m, N
m = 12.0                # mass that the vertical spring is preloaded to carry
k_v = 2500.0            # vertical spring
k_h = 1700.0            # each of the n horizontal springs
n = 3
L = 0.080               # push-rod
preload = 0.009         # compression of a horizontal spring at the centre
friction = 0.4          # dry friction; leave it out for none
zeta = 0.02             # damping ratio; or c, in N s/m

[ask]
F = [3.0, 5.0]          # force amplitudes, N
f = [5.0]               # frequencies, Hz, for "amplitudes"
window = [0.5, 6.0]     # frequency range of response curves, Hz
questions = [
    "at_rest",              # natural frequency, stroke, break-loose force
    "saddle_node_onset",    # lowest force with jumps
    "detachment",           # lowest force that detaches the springs
    "saddle_nodes",         # jump frequencies
    "margins",              # margins of each force against these
    "hysteresis",           # frequency bands with several motions
    "isolation",            # frequency above which it transmits less than the force
    "peak",
    "amplitudes",           # every motion at the frequencies f, with its transmissibility
    "frequency_response",   # every branch
]
"""

#: the same of a measured loop
OF_A_LOOP = """\
[spring]                # measured in {file!r}, with intervals of 95 %
m = {m!r}
{numbers}

[ask]
F = [{F:.3g}]               # force amplitudes, N: {why}
questions = ["saddle_node_onset", "saddle_nodes", "peak", "isolation", "frequency_response"]
"""


def of_loop(path: Path, m: Any) -> str:
    """A scene's text: a mass in kg on spring and dampers of a measured force-displacement loop.

    path -- of a CSV file with columns x, F and, for viscous damping, t

    A number whose interval holds 0 is left out. Raises ValueError for an invalid loop, with file and line.
    """
    columns, units = read_csv(path), {"x": "m", "F": "N", "t": "s"}
    if not {"x", "F"} <= columns.keys() <= units.keys():
        raise Refused(f"{columns.head}: a loop has columns x, F and, for viscous damping, t, not {', '.join(columns)}")
    for name, unit in columns.units.items():
        if unit != units[name]:
            raise Refused(f"{columns.head}: {name} in {unit} is not allowed: {name} must have a unit of {units[name]}")
    try:
        loop = from_loop(columns["x"], columns["F"], t=columns.get("t"))
        known: dict[str, Any] = {one.parameter: one.value for one in loop if not one.low <= 0 <= one.high}
        mount = Duffing.physical(m=m, **{"k_1": 0.0, **known})
    except (ValueError, ArithmeticError) as error:
        raise Refused(f"{path}: {error}") from None
    lines = [f"# {loop.message}"] if loop.message else []
    for name, unit, value, _, low, high in loop:
        line = f"{name} = {value!r}"
        lines.append(f"{line if name in known else f'# {line}':23} # {low:.5g} to {high:.5g} {unit}")
    F, why = 2 * mount.sticking_forcing, "twice what friction holds"
    if not F:
        F, why = 0.1 * float(abs(loop.F).max()), "a tenth of the largest in the loop"
    return OF_A_LOOP.format(file=path.name, m=m, numbers="\n".join(lines), F=F, why=why)
