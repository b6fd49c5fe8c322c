"""What the solvers of every language have in common and no formula gives: how an answer fared, and where methods stop.

In:  decisions.
Out: `STATUS` and `ONSET_KINDS`, words by number; `NUMBERS` of the methods.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Word:
    """A name for the number that is its place in a table, and what it means, in one line."""

    name: str
    doc: str


@dataclass(frozen=True)
class Number:
    """A name for a number, and what it is, in one line."""

    name: str
    value: sp.Rational
    doc: str


#: how a solver fared
STATUS = (
    Word("OK", "an answer"),
    Word("INVALID", "a parameter outside its domain"),
    Word("STICKS", "sticks: F_0 <= 4 mu/pi"),
    Word("NONE", "there is none (no fold, no breakpoint)"),
    Word("UNBOUNDED", "no viscous damping: no end of the response, no lowest forcing"),
    Word("NO_BOUND", "no amplitude was found that bounds the response"),
    Word("TOO_MANY", "more of them than places"),
    Word("UNRESOLVED", "branches coincide within rounding"),
    Word("NO_MEMORY", "out of memory"),
)

#: what the lowest forcing with a fold is
ONSET_KINDS = (
    Word("no", "there is no onset"),
    Word("cusp", "two folds meet: the response gets a vertical inflection"),
    Word("isola", "an isolated curve is born"),
    Word("corner", "at a breakpoint"),
)

NUMBERS = (
    Number("STATIC_MULTIPLE", sp.Integer(100), "an undamped response without a reach is cut at this multiple of F_0"),
    Number("RAISE", sp.Integer(4), "the forcing is raised by this factor until the onset lies below it"),
    Number("RAISES", sp.Integer(30), "how often, at most"),
    Number("SAME", sp.Rational(1, 2**49), "amplitudes closer than this, relatively, are one"),
)
