"""What the columns of a map mean: in go a question and a column's name, out come attributes, as CF has them.

A file outlives the program that wrote it: units, codes with their words, and which slowflow it was stand in it.
"""

from __future__ import annotations

import inspect
from enum import IntEnum
from typing import Any

from slowflow.grid.block import Ask
from slowflow.model import THROUGHOUT
from slowflow.results import Remark
from slowflow_kernels.conventions import FoldKind, OnsetKind, Status
from slowflow_kernels.domains import DAMPING, DISSIPATION

#: status of a design in a block that is not computed yet; none of the solvers'
NOT_YET = -1
UNITS = "dimensionless"
#: what a column is
WORDS = {
    "F_cr": "lowest forcing that reaches u_cr (34)",
    "Omega_cr": "frequency at which it does",
    "u_cr": "amplitude at which the springs leave",
    "F_SN": "lowest forcing that has a fold (33)",
    "Omega": "frequency",
    "A": "amplitude; in the second approximation the largest displacement",
    "B": "mean displacement of a motion",
    "u_max": "largest |u|",
    "Omega_max": "frequency of the motion that goes farthest",
    "u": "place of rest",
    "stiffness": "stiffness there",
    "load": "static load beside what the vertical spring holds at the centre",
    "Omega_0": "natural frequency of small motions about the centre",
    "k_0": "stiffness at the centre",
    "break_loose": "constant force that friction holds",
    "rests_within": "how far from the centre friction holds the mass",
    "sticking": "amplitude of a force up to which the mass is at rest, 4 mu/pi (27)",
    "of_SN": "F_SN over F_0: a margin above 1",
    "of_cr": "F_cr over F_0: a margin above 1",
    "onset": "status of the onset: why there is no F_SN",
    "folds": "number of folds",
    "detaches": "1 where the springs leave",
    "sticks": "1 where the mass stays at rest",
    "Omega_sticks": "frequency up to which the mass stays at rest",
    "Omega_low": "lower end of a band with several stable motions",
    "Omega_high": "its upper end",
    "motions": "number of stable motions",
    "at_fold": "1 where a motion that transmits more ends there in a fold",
    "transmissibility": "share of the force that is transmitted",
    "transmissibility_dB": "the same in decibels",
    "crosses": "1 where a fold lies on the way from the row before",
    "phi": "phase in radians",
    "branch": "number of the connected curve, from 0; -1 behind the last point",
    "isola": "1 where that curve is closed",
    "points": "number of points",
    "fold_Omega": "frequency of a fold",
    "fold_A": "amplitude of a fold",
    "fold_kind": "kind of fold",
    "acceleration": "acceleration of the base, over k_v L/m",
    "duration": "duration of a half sine",
    "tau": "times of the samples of a record",
    "tau_A": "when the largest deflection is reached",
    "a_max": "largest acceleration of the mass",
    "tau_a": "when it is reached",
    "tau_detaches": "when the springs leave first",
    "rests": "1 where friction holds the mass at the end",
    "u_end": "where the mass is at the end",
    "ratio": "largest acceleration of the mass over that of the pulse",
    "stands": "number of stable places of rest",
    "at_rest": "1 where there are folds below the onset, or without it, that end at Omega = 0",
    "stable": "1 where a state is stable",
    "count": "how many there are: folds or states, also where they are more than places, or what is proved",
    "proved": "1 where these are proved to be all",
    "bits": "of the arithmetic of the proof: 53 of intervals of doubles, more of balls",
    "undecided": "1 where neither doubles nor balls tell whether there is another pair",
    "kind": "kind of fold",
    "status": "whether there is an answer, and why there is none",
    "remarks": "what to bear in mind with the answer, codes that add up",
    "F_0": "forcing, the amplitude of the excitation",
}
KINDS: dict[str, type[IntEnum]] = {"saddle_node_onset": OnsetKind, "saddle_nodes": FoldKind, "margins": OnsetKind}
#: units of what is not dimensionless
UNITS_OF = {"phi": "rad", "transmissibility_dB": "dB"}


def of_map(ask: Ask) -> dict[str, Any]:
    """Of a whole map."""
    about = {"mechanism": ask.mechanism.name, "title": ask.mechanism.title, "excitation": ask.excitation}
    about |= {"question": ask.question, **({} if ask.rubs == THROUGHOUT else {"rubs": ask.rubs})}
    return {**about, "depth": ask.depth, **ask.made_by}


def of_column(ask: Ask, name: str) -> dict[str, Any]:
    """Of a column of an answer, or of one of the numbers that it was asked with."""
    known = {domain.name: domain.doc for domain in (*ask.mechanism.design, *DAMPING, *DISSIPATION)}
    found: dict[str, Any] = {"long_name": known.get(name) or WORDS[name]}
    if name == "remarks":
        codes = [remark for remark in Remark]
        return {**found, "flag_masks": [int(code) for code in codes], "flag_meanings": _words(codes)}
    if name == "status":
        values = [NOT_YET, *map(int, Status)]
        meanings = f"NOT_YET {_words(Status)}"
        return {**found, "flag_values": values, "flag_meanings": meanings, "meaning": _told(Status)}
    if name == "onset":
        return {
            **found,
            "flag_values": list(map(int, Status)),
            "flag_meanings": _words(Status),
            "meaning": _told(Status),
        }
    if name in ("kind", "fold_kind"):
        kind = KINDS[ask.question] if name == "kind" else FoldKind
        return {
            **found,
            "flag_values": [int(code) for code in kind],
            "flag_meanings": _words(kind),
            "meaning": _told(kind),
        }
    return {**found, "units": UNITS_OF.get(name, UNITS)}


def _words(codes: Any) -> str:
    return " ".join(code.name for code in codes)


def _told(kind: type[IntEnum]) -> str:
    """What each number stands for, as the derivation states it."""
    return inspect.cleandoc(kind.__doc__ or "")
