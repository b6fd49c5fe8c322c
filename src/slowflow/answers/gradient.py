"""Gradients: derivatives of results with respect to all parameters.

If a derivative does not exist, the gradient gives the reason.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from slowflow.answers.answer import Answer
from slowflow.core.mechanism import Floats
from slowflow_kernels.conventions import GradientStatus

NO_GRADIENT = (
    "this answer has no gradient, as it combines others: those of saddle_node_onset, detachment, saddle_nodes, peak, "
    "amplitudes and isolation have one"
)
#: why an answer has no gradient
WITHOUT_GRADIENT = {
    GradientStatus.NOTHING: "there is no answer to differentiate",
    GradientStatus.MEETS: "it merges with another answer there, as at a fold, a cusp or an isola point: beyond "
    "it there is none, and close to it the derivative is unbounded",
    GradientStatus.TURNS: "it reaches a breakpoint of the force there, with a different gradient on either side",
    GradientStatus.BOUNDLESS: "a parameter is at the end of its domain: a derivative is unbounded, or a forcing is 0, "
    "or numbers are beyond the range of doubles",
}


class Slope(NamedTuple):
    """The derivative of one number of an answer with respect to one parameter, for each entry if there are several."""

    of: str
    by: str
    slope: Any


@dataclass(frozen=True, eq=False)
class Gradient(Answer):
    """The exact derivatives of an answer's numbers with respect to each parameter: d(number)/d(parameter).

    They are dimensionless, or in SI units if the answer has units.

    of      -- the numbers, such as "Omega", "A", "F_SN"
    by      -- the parameters: those of the design, mu, zeta, and the arguments of the question, F_0 and Omega
    slopes  -- shape (..., numbers, parameters), after the shape of the answer; NaN where there is no gradient
    status  -- code of `slowflow_kernels.conventions.GradientStatus`, 0 if there is a gradient
    message -- why some results have no gradient; empty if all have one

    `gradient["A", "delta_h"]` is one derivative for each entry of the answer, `gradient["A"]` has those with respect to
    all parameters. Iterating gives a `Slope` for each number and each parameter; in a table (pandas), each entry has
    its own row.
    """

    has_rows = True

    of: tuple[str, ...]
    by: tuple[str, ...]
    slopes: Floats
    status: npt.NDArray[np.int8]
    _values: tuple[Any, ...] = field(repr=False)
    _at: tuple[Any, ...] = field(repr=False)

    def __post_init__(self) -> None:
        # only what is its own: the parameters may be a user's arrays
        self.slopes.flags.writeable = self.status.flags.writeable = False

    def __getitem__(self, what: str | tuple[str, str]) -> Floats:
        of, by = (what, None) if isinstance(what, str) else what
        if of not in self.of or (by is not None and by not in self.by):
            raise KeyError(f"{what!r}: the numbers are {', '.join(self.of)}, the parameters {', '.join(self.by)}")
        found = self.slopes[..., self.of.index(of), :]
        return found if by is None else found[..., self.by.index(by)][()]

    def __iter__(self) -> Iterator[Slope]:
        return (Slope(of, by, self[of, by]) for of, by in self._pairs())

    def __len__(self) -> int:
        return len(self.of) * len(self.by)

    def columns(self) -> dict[str, npt.NDArray[Any]]:
        """Return a row for each derivative of each entry; a single answer has no column of entries."""
        rows = [(*entry, *pair) for entry in np.ndindex(self.status.shape) for pair in self._pairs()]
        names = [f"entry_{k}" if k else "entry" for k in range(self.status.ndim)]
        columns = zip(*rows, strict=True) if rows else ([],) * (len(names) + 2)
        found = dict(zip((*names, "of", "by"), map(np.array, columns), strict=True))
        return {**found, "slope": self.slopes.ravel()}

    def _pairs(self) -> list[tuple[str, str]]:
        return [(of, by) for of in self.of for by in self.by]

    def about(self) -> dict[str, Any]:
        """Return the message."""
        return {"message": self.message}

    @property
    def message(self) -> str:
        """Why some answers have no gradient; empty if all have one."""
        codes, counts = np.unique(self.status[self.status != GradientStatus.OK], return_counts=True)
        texts = []
        for code, count in zip(codes, counts, strict=True):
            of_all = f"{count} of {self.status.size}: " if self.status.ndim else ""
            texts.append(of_all + WITHOUT_GRADIENT[GradientStatus(code)])
        return f"no gradient: {'; '.join(texts)}" if texts else ""

    def condition(self, of: str) -> Floats:
        """Compute the relative condition number of a number: its relative change over that of the parameters.

        The sum of |p d(number)/dp|/|number| over the parameters, shape (...); NaN where there is no gradient.
        """
        with np.errstate(all="ignore"):
            change = sum(abs(at * self[of, by]) for at, by in zip(self._at, self.by, strict=True))
            found: Floats = change / np.abs(self._values[self.of.index(of)])
            return found
