"""A fit: in goes a measured response curve, out come the isolator's numbers with confidence intervals.

By SciPy's least squares on the averaged states; of several motions at a frequency the one nearest to the measured one
counts.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares
from scipy.stats import t as student

from slowflow import validate
from slowflow.answer import Table
from slowflow.mechanism import Floats
from slowflow.physical import Physical
from slowflow.sizing.subject import Subject

#: share of all fits whose interval holds the number, if the noise is normal and the equations are right
CONFIDENCE = 0.95
#: what a number may become, over what it was; a number that is 0 may become this share of 1
LEAST, MOST, FROM_NOTHING = 1e-3, 1e3, 1e-3


class Fitted(NamedTuple):
    """A row of `Fit`."""

    parameter: str
    value: float
    error: float
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Fit(Table):
    """Numbers that a measurement says, one row each.

    value     -- the number, in SI units of a mount
    error     -- its standard error; low, high -- its 95 % confidence interval
    design    -- the isolator or the mount that has these numbers
    residuals -- measured less fitted amplitude at each point, in the order of the points
    deviation -- standard deviation of the residuals, with as many degrees of freedom as points less numbers
    correlation -- of the numbers, shape (n, n)
    """

    entry: ClassVar[Any] = Fitted

    parameter: npt.NDArray[np.str_]
    value: Floats
    error: Floats
    low: Floats
    high: Floats
    design: Any = field(repr=False)
    residuals: Floats
    deviation: float
    correlation: Floats
    message: str


def fit(
    of: Any,
    *,
    A: Any,
    F: Any = None,
    f: Any = None,
    F_0: Any = None,
    Omega: Any = None,
    free: Sequence[str] | None = None,
) -> Fit:
    """Numbers of an isolator from measured amplitudes.

    of       -- an `Isolator`, or a mount in SI units: where the search begins, and what is not free
    A        -- measured amplitudes, in m of a mount
    F, f     -- the forces and frequencies at which they were measured, of a mount, in N and Hz; they broadcast with A
    F_0, Omega -- the same of an isolator
    free     -- names of the numbers to find; by default friction, damping, stiffness and preload of the springs

    Noise is taken to be normal and the same at all points; intervals know of noise alone, not that averaging is an
    approximation, which may move a number by a percent. Raises ValueError for what is not allowed, as fewer points
    than free numbers, and ArithmeticError where the points do not determine these.
    """
    subject = Subject(of)
    mount = isinstance(of, Physical)
    given = {"f": f, "F": F} if mount else {"Omega": Omega, "F_0": F_0}
    if any(value is None for value in given.values()):
        raise ValueError(f"{' and '.join(given)} are needed: where the amplitudes were measured")
    points = {**{name: validate.positive_array(name, value) for name, value in given.items()}}
    points["A"] = validate.positive_array("A", A)
    shape = validate.common_shape(points)
    at, forcing, measured = (np.broadcast_to(values, shape).ravel() for values in points.values())
    damping = "c" if "c" in subject.nominal else "zeta"
    default = ["friction", damping, "k_h", "preload"] if mount else ["mu", "zeta", "r", "delta_h"]
    names = default if free is None else list(free)
    subject.check_varied(names)
    if measured.size <= len(names):
        raise ValueError(f"{measured.size} points are too few for {len(names)} numbers")
    start = np.array([subject.nominal[name] or FROM_NOTHING for name in names])

    def residuals(x: Floats) -> Floats:
        """Measured less nearest amplitude; what is no design, or does not move, has amplitude 0."""
        try:
            design = subject.of.replace(**dict(zip(names, (x * start).tolist(), strict=True)))
        except ValueError:
            return measured.copy()
        return measured - _nearest(design, at, forcing, measured)

    found = least_squares(residuals, np.ones(len(names)), bounds=(LEAST, MOST), x_scale="jac", xtol=1e-12, ftol=1e-12)
    left = measured.size - len(names)
    deviation = float(np.sqrt(2 * found.cost / left))
    try:
        covariance = np.linalg.inv(found.jac.T @ found.jac) * deviation**2
    except np.linalg.LinAlgError:
        raise ArithmeticError(f"the points do not determine {', '.join(names)}") from None
    error = np.sqrt(np.diag(covariance))
    value, error, correlation = found.x * start, error * start, covariance / np.outer(error, error)
    half = float(student.ppf(0.5 * (1 + CONFIDENCE), left)) * error
    design = subject.of.replace(**dict(zip(names, value.tolist(), strict=True)))
    message = "" if found.success else f"the search did not end: {found.message}"
    columns = (np.array(names), value, error, value - half, value + half)
    return Fit(*columns, design, np.asarray(found.fun), deviation, correlation, message)


def _nearest(design: Any, at: Floats, forcing: Floats, measured: Floats) -> Floats:
    """The stable amplitude nearest to each measured one, 0 where there is none."""
    units = (
        design.scales.sizes if isinstance(design, Physical) else dict.fromkeys(("frequency", "force", "length"), 1.0)
    )
    isolator = design.oscillator if isinstance(design, Physical) else design
    Omega, F_0 = at / units["frequency"], forcing / units["force"]
    states = isolator.amplitudes(Omega=Omega, F_0=F_0)
    found = np.zeros_like(measured)
    for k, (x, y, A) in enumerate(zip(Omega, F_0, measured, strict=True)):
        here = states.A[(states.Omega == x) & (states.F_0 == y) & states.stable] * units["length"]
        if here.size:
            found[k] = here[np.argmin(np.abs(here - A))]
    return found
