"""Certificates: results of proofs, as enclosures of folds, states and forces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import Answer, joined
from slowflow.answers.table import DOUBLES
from slowflow.core.mechanism import Flags
from slowflow.core.model import Floats
from slowflow.support.text import text


@dataclass(frozen=True, eq=False)
class Proved(Answer):
    """Statements proved for the oscillator whose parameters are exactly the given doubles.

    proved  -- whether everything is proved
    message -- what is not proved, and why; empty if all is
    bits    -- precision: `DOUBLES` for intervals of doubles, more for balls
    """

    proved: bool
    message: str
    bits: int


@dataclass(frozen=True, eq=False)
class ProvedStates(Proved):
    """All steady states at a frequency, in ascending order of A; each interval of A contains exactly one.

    A       -- bounds of each amplitude, shape (n, 2)
    stable  -- the sign of F_A (30), shape (n,)
    A_max   -- amplitude up to which it is proved that there are no further states
    bounded -- whether it is also proved that there are none from A_max to 2^60 A_max
    doubt   -- undecided intervals of A, shape (k, 2)
    """

    A: Floats
    stable: Flags
    A_max: float
    bounded: bool
    doubt: Floats


@dataclass(frozen=True, eq=False)
class ProvedFolds(Proved):
    """All folds at a forcing, in ascending order of Omega; each pair of intervals contains exactly one.

    Omega, A -- bounds of the frequency and of the amplitude of each fold, shape (n, 2)
    kind     -- as in `SaddleNodes`, "" if the sign of F_AA is not proved
    corner   -- True where the fold lies on a breakpoint of the force
    A_max, bounded, doubt -- as in `ProvedStates`
    """

    Omega: Floats
    A: Floats
    kind: npt.NDArray[np.str_]
    corner: Flags
    A_max: float
    bounded: bool
    doubt: Floats


@dataclass(frozen=True, eq=False)
class ProvedForcing(Proved):
    """A critical forcing: bounds of F_0, Omega and A, each of shape (2,); empty if there is none.

    kind -- kind of an onset, as in `SaddleNodeOnset`, "" if it is not proved
    """

    F_0: Floats
    Omega: Floats
    A: Floats
    kind: str


@dataclass(frozen=True, eq=False)
class Certificate(Answer):
    """Proofs at one forcing, from `Oscillator.certify`; printing shows what is proved.

    saddle_nodes -- all folds at F_0
    saddle_node_onset, detachment -- F_SN and F_cr
    amplitudes   -- all states at a frequency, None without a frequency
    """

    F_0: float
    saddle_nodes: ProvedFolds
    saddle_node_onset: ProvedForcing
    detachment: ProvedForcing
    amplitudes: ProvedStates | None

    @property
    def proved(self) -> bool:
        """Whether all of its statements are proved."""
        proofs = (self.saddle_nodes, self.saddle_node_onset, self.detachment, self.amplitudes)
        return all(part.proved for part in proofs if part is not None)

    def __str__(self) -> str:
        return "\n".join(_in_words(self))


def _in_words(found: Certificate) -> Iterator[str]:
    """A certificate, line by line."""
    folds = found.saddle_nodes
    yield text("Folds at {F_0 = :.17g}: {verdict:s}", found.F_0, _verdict(folds, f"{len(folds.A)} and no others"))
    for Omega, A, kind, corner in zip(folds.Omega, folds.A, folds.kind, folds.corner, strict=True):
        where = " on a breakpoint" if corner else ""
        yield text("  {Omega} in [{Omega:.17g}], A in [{A:.17g}]  {kind:s}{where:s}", Omega, A, kind, where)
    states = found.amplitudes
    if states is not None:
        yield f"States at this frequency: {_verdict(states, f'{len(states.A)} and no others')}"
        for A, stable in zip(states.A, states.stable, strict=True):
            yield text("  A in [{A:.17g}]  {stable:s}", A, "stable" if stable else "unstable")
    onset, detachment = found.saddle_node_onset, found.detachment
    for what, forcing in (("Onset {F_SN}: {verdict:s}", onset), ("Detachment {F_cr}: {verdict:s}", detachment)):
        yield text(what, _verdict(forcing, forcing.kind))
        if forcing.F_0.size:
            yield text(ENCLOSED, forcing.F_0, forcing.Omega, forcing.A)


ENCLOSED = "  {F_0} in [{F_0:.17g}], {Omega} in [{Omega:.17g}], A in [{A:.17g}]"


def _verdict(found: Proved, what: str) -> str:
    proved = "proved" if found.bits == DOUBLES else f"proved in balls of {found.bits} bits"
    return joined(joined(proved if found.proved else "not proved", what if found.proved else ""), found.message)
