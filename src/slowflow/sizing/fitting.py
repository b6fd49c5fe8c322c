"""A fit: in go a measured response curve or jump frequencies, out come an isolator's numbers with confidence intervals.

By SciPy's least squares on the averaged states; of several motions at a frequency the one nearest to the measured one
counts.
"""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares
from scipy.stats import t as student

from slowflow import validate
from slowflow.answer import Table, joined
from slowflow.mechanism import Floats
from slowflow.physical import Physical
from slowflow.plausible import Implausible
from slowflow.quantities import EXCITED, SHEET, UNITS, in_shown, si, turns
from slowflow.sizing.subject import Subject, first_jump
from slowflow_support.errors import NotSettled, Refused

#: share of all fits whose interval holds the number, if the noise is normal and the equations are right
CONFIDENCE = 0.95
#: what a number may become, over what it was; a number that is 0 may become this share of 1
LEAST, MOST, FROM_NOTHING = 1e-3, 1e3, 1e-3
#: how near to an end of that range a number has run into it
AT_AN_END = 1e-3
RAN_OUT = (
    "no fit: {} left the range from 1/1000 to 1000 times what the search began with. Are units and the start right?"
)
#: starts beside the given one, and how far from it they are, as a factor
STARTS, FAR = 5, 3.0
#: how often a lower minimum that a profile comes to is taken; from which share on a sum of squares is another one, and
#: up to which share of that of the measured values one is rounding
AGAIN, OTHER, NOTHING = 3, 1e-3, 1e-15
#: how nearly an end of an interval is found, as a share of its distance; steps towards it, and by how much they grow
NEARLY, STEPS, GROWS = 1e-2, 40, 1.6
#: a narrower interval, as a share of the number, is one of rounding
WIDTH = 1e-9
OTHER_START = "a search from the given start ends with a sum of squares of {:.3g}, from another one with {:.3g}"
OPEN = "the points do not determine {}: an interval has no end within 1/1000 to 1000 times what the search began with"
ABSENT = "the fitted design has no such motion, or jump, at {} of the {} points"


class Fitted(NamedTuple):
    """A row of `Fit`."""

    parameter: str
    unit: str
    value: float
    error: float
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class Fit(Table):
    """Numbers that a measurement says, one row each.

    value     -- the number, of a mount in SI units, which `unit` says
    error     -- its standard error, of the equations made linear; low, high -- its 95 % confidence interval by the
                 profile likelihood, with 0 or inf where the points do not bound it
    design    -- the isolator or the mount that has these numbers
    residuals -- measured less fitted amplitude, or jump frequency, at each point, in the order of the points; up first
    at        -- the frequency, or the forcing, of each point; names -- of `at` and `residuals`, with their units
    deviation -- standard deviation of the residuals, with as many degrees of freedom as points less numbers
    correlation -- of the numbers, shape (n, n)
    """

    entry: ClassVar[Any] = Fitted

    parameter: npt.NDArray[np.str_]
    unit: npt.NDArray[np.str_]
    value: Floats
    error: Floats
    low: Floats
    high: Floats
    design: Any = field(repr=False)
    residuals: Floats
    at: Floats
    names: tuple[str, str]
    deviation: float
    correlation: Floats
    message: str

    def plot(self, ax: Any = None) -> Any:
        """Draw the residuals into Matplotlib axes, or new ones, and return these; tinted within two deviations.

        Of a mount in mm, N, Hz.
        """
        from slowflow import pictures

        names, sizes = [], []
        for name in self.names:
            letter, _, unit = name.rpartition("/")
            shown, size = in_shown(unit if letter else "")
            names.append(f"{letter}/{shown}" if letter else name)
            sizes.append(size)
        at, left, deviation = self.at / sizes[0], self.residuals / sizes[1], self.deviation / sizes[1]
        return pictures.residuals(ax, at, left, deviation, (names[0], names[1]))


def fit(
    of: Any,
    *,
    A: Any = None,
    F: Any = None,
    f: Any = None,
    F_0: Any = None,
    Omega: Any = None,
    jump_up: Any = None,
    jump_down: Any = None,
    free: Sequence[str] | None = None,
) -> Fit:
    """Numbers of an isolator from measured amplitudes, or from the frequencies at which it jumps.

    of       -- an `Isolator`, or a mount in SI units: where the search begins, and what is not free
    A        -- measured amplitudes, in m of a mount
    F, f     -- the forcings and frequencies at which they were measured, of a mount, in N and Hz; they broadcast with
                A. On a base that shakes F is its amplitude, in m, with an unbalance mass times radius, in kg m
    F_0, Omega -- the same of an isolator
    jump_up, jump_down -- instead of A: the frequency at which it jumped at each force, up and down, in Hz of a mount;
                one or both, NaN where it was not seen
    free     -- names of the numbers to find; by default friction, damping, stiffness and preload of the springs

    Noise is taken to be normal and the same at all points; intervals know of noise alone, not that averaging is an
    approximation, which may move a number by a percent. They are those of the profile likelihood,
    with Student's t: of 40 fits each to amplitudes with noise of 1 %, of one, two, three, four free numbers 39 of 40,
    79 of 80, 114 of 120 and 153 of 160 intervals held the number; of four numbers on a curve that jumps, with noise of
    2 %, 37 of 44. A number that the points do not bound has an interval that ends at 0 or inf, and the message names
    it. It also says where a search from the given start ends in a minimum that is not the lowest found; six starts are
    tried, which does not prove that there is no lower one.

    Raises ValueError for what is not allowed, as fewer points than free numbers, and ArithmeticError where the points
    do not determine these.
    """
    subject = Subject(of, () if free is None else free)
    with contextlib.nullcontext() if subject.mount is None else subject.mount.scales.in_these_terms():
        (of if subject.mount is None else of.oscillator).at_centre("fit")
    if (A is None) == (jump_up is None and jump_down is None):
        raise Refused("a fit needs either measured amplitudes A, or jump_up or jump_down")
    if subject.mount:
        F, f, A = si("F", F, EXCITED[subject.excitation][2]), turns("f", f), si("A", A, "meter")
        jump_up, jump_down = turns("jump_up", jump_up), turns("jump_down", jump_down)
    if A is None:
        measured = _jumps(subject, F if subject.mount else F_0, jump_up, jump_down)
    else:
        measured = _amplitudes(subject, {"f": f, "F": F} if subject.mount else {"Omega": Omega, "F_0": F_0}, A)
    damping = "c" if "c" in subject.nominal else "zeta"
    default = ["friction", damping, "k_h", "preload"] if subject.mount else ["mu", "zeta", "r", "delta_h"]
    with np.errstate(
        over="ignore", divide="ignore", invalid="ignore"
    ):  # numbers at the ends of the range: words follow
        return _fitted(subject, measured, default if free is None else list(free))


@dataclass(frozen=True)
class _Measured:
    """What was measured: values, where, what a design has there, and the names of both."""

    values: Floats
    at: Floats
    of_design: Callable[[Any], Floats]
    names: tuple[str, str]


def _fitted(subject: Subject, measured: _Measured, names: list[str]) -> Fit:
    """The numbers that leave the least squares."""
    size = measured.values.size
    if not names:
        raise Refused("free = [] is not allowed: name at least one number to find")
    if size <= len(names):
        raise Refused(f"{size} points are too few for {len(names)} numbers")
    start = np.array([subject.nominal[name] or FROM_NOTHING for name in names])

    def residuals(x: Floats) -> Floats:
        """Measured less what the design has; what is no design, or does not move or jump, has 0."""
        with warnings.catch_warnings():  # there is nothing to say of what a search passes
            warnings.simplefilter("ignore")
            try:
                design = subject.of.replace(**dict(zip(names, (x * start).tolist(), strict=True)))
            except ValueError:
                return measured.values.copy()
        return measured.values - measured.of_design(design)

    found, own = _best(residuals, len(names))
    left = size - len(names)
    half = float(student.ppf(0.5 * (1 + CONFIDENCE), left))
    for _ in range(AGAIN):
        try:
            error = np.sqrt(np.diag(np.linalg.inv(found.jac.T @ found.jac)) * 2 * found.cost / left)
        except np.linalg.LinAlgError:
            raise NotSettled(f"the points do not determine {', '.join(names)}") from None
        error = np.where(np.isfinite(error), error, np.inf)
        profile = _Profile(residuals, found, half, left)
        ends = np.array([[profile.end(k, side, error[k]) for side in (-1.0, 1.0)] for k in range(len(names))])
        if profile.lower is None:
            break
        found = _search(residuals, profile.lower)  # a lower minimum beside the one whose ends were looked for
    covariance = np.linalg.inv(found.jac.T @ found.jac) * 2 * found.cost / left
    deviation = float(np.sqrt(2 * found.cost / left))
    error = np.sqrt(np.diag(covariance))
    value, error, correlation = found.x * start, error * start, covariance / np.outer(error, error)
    low, high = ends.T * start
    open_ = [name for name, two in zip(names, ends, strict=True) if two[0] == 0 or two[1] == np.inf]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", Implausible)  # the message says what numbers at the ends of the range are
        design = subject.of.replace(**dict(zip(names, value.tolist(), strict=True)))
    out = (found.x < LEAST * (1 + AT_AN_END)) | (found.x > MOST * (1 - AT_AN_END))
    scale = float(measured.values @ measured.values)
    absent = np.count_nonzero(found.fun == measured.values)
    message = joined(
        "" if found.success else f"the search did not end: {found.message}",
        RAN_OUT.format(", ".join(np.array(names)[out])) if out.any() else "",
        OTHER_START.format(2 * own, 2 * found.cost) if own > found.cost * (1 + OTHER) + NOTHING * scale else "",
        OPEN.format(", ".join(open_)) if open_ else "",
        ABSENT.format(absent, size) if absent else "",
    )
    units = np.array([SHEET[name] if subject.mount else "" for name in names], dtype=np.str_)
    columns = (np.array(names), units, value, error, low, high)
    return Fit(*columns, design, np.asarray(found.fun), measured.at, measured.names, deviation, correlation, message)


def _search(residuals: Callable[[Floats], Floats], x: Floats) -> Any:
    """The minimum that is found from x on."""
    return least_squares(residuals, x, bounds=(LEAST, MOST), x_scale="jac", xtol=1e-12, ftol=1e-12)


def _best(residuals: Callable[[Floats], Floats], n: int) -> tuple[Any, float]:
    """The lowest minimum from several starts, always the same ones, and half of the sum of squares from the given one.

    Without noise, where the given start leads to the numbers, none is lower.
    """
    found = _search(residuals, np.ones(n))
    own = float(found.cost)
    # a low-discrepancy sequence: the fractional parts of multiples of powers of the root of x^(n + 1) = x + 1
    root = float(np.max(np.real(np.roots([1.0, *[0.0] * (n - 1), -1.0, -1.0]))))
    for k in range(1, STARTS + 1):
        share = (0.5 + k * root ** -np.arange(1.0, n + 1)) % 1.0
        begin = FAR ** (2 * share - 1)
        other = least_squares(residuals, begin, bounds=(LEAST, MOST), x_scale="jac", xtol=1e-4, ftol=1e-4, max_nfev=30)
        if other.cost < found.cost * (1 - OTHER):
            found = min((found, _search(residuals, other.x)), key=lambda one: one.cost)
    return found, own


class _Profile:
    """Intervals by the profile likelihood: how far a number goes while the others make up for it.

    The sum of squares with that number held, least over the others, rises from the minimum by t^2 times the variance of
    the residuals at the ends; t is Student's. Of equations that are linear these are the ends of the usual interval.
    """

    def __init__(self, residuals: Callable[[Floats], Floats], found: Any, t: float, left: int) -> None:
        self.residuals, self.found, self.t, self.variance = residuals, found, t, 2 * found.cost / left
        self.lower: Floats | None = None

    def end(self, k: int, side: float, error: float) -> float:
        """The end of the interval of number k, 0 or inf where it has none within the range."""
        best, limit = self.found.x[k], LEAST if side < 0 else MOST
        far = self.t * error
        if far < WIDTH * best:  # without noise there is none
            return float(best + side * far)
        far = min(far, best) if np.isfinite(far) else best
        rest, inner, at_inner = np.delete(self.found.x, k), best, -self.t
        for _ in range(STEPS):
            outer = max(best - far, limit) if side < 0 else min(best + far, limit)
            at_outer, rest = self._excess(k, outer, rest)
            if self.lower is not None or at_outer >= 0:
                break
            if outer == limit:
                return 0.0 if side < 0 else np.inf
            inner, at_inner, far = outer, at_outer, GROWS * far
        while self.lower is None and abs(outer - inner) > NEARLY * abs(outer - best):
            share = min(max(at_inner / (at_inner - at_outer), NEARLY), 1 - NEARLY)
            middle = inner + share * (outer - inner)
            at_middle, rest = self._excess(k, middle, rest)
            if abs(at_middle) < NEARLY * self.t:
                return float(middle)
            if at_middle < 0:
                inner, at_inner, at_outer = middle, at_middle, 0.5 * at_outer
            else:
                outer, at_outer, at_inner = middle, at_middle, 0.5 * at_inner
        return float(outer)

    def _excess(self, k: int, value: float, rest: Floats) -> tuple[float, Floats]:
        """By how much the rise of the sum of squares exceeds t, as a root, and the other numbers."""

        def held(others: Floats) -> Floats:
            return self.residuals(np.insert(others, k, value))

        cost = 0.5 * float(np.sum(held(rest) ** 2))
        if rest.size:
            found = least_squares(held, rest, bounds=(LEAST, MOST), x_scale="jac", xtol=1e-6, ftol=1e-5, max_nfev=20)
            cost, rest = float(found.cost), found.x
        if cost < self.found.cost * (1 - OTHER):
            self.lower = np.insert(rest, k, value)
        return float(np.sqrt(max(cost - self.found.cost, 0.0) * 2 / self.variance)) - self.t, rest


def _amplitudes(subject: Subject, given: Mapping[str, Any], A: Any) -> _Measured:
    """Amplitudes at frequencies and forcings."""
    if any(value is None for value in given.values()):
        raise Refused(f"{' and '.join(given)} are needed: where the amplitudes were measured")
    points = {name: validate.positive_array(name, value) for name, value in {**given, "A": A}.items()}
    shape = validate.common_shape(points)
    at, forcing, measured = (np.broadcast_to(values, shape).ravel() for values in points.values())
    names = ("f/Hz", "measured less fitted A/m") if subject.mount else (next(iter(given)), "measured less fitted A")
    return _Measured(measured, at, lambda design: _nearest(subject, design, at, forcing, measured), names)


def _jumps(subject: Subject, forcing: Any, up: Any, down: Any) -> _Measured:
    """Frequencies of jumps at forcings."""
    force, frequency = ("F", "f/Hz") if subject.mount else ("F_0", "Omega")
    if forcing is None:
        raise Refused(f"{force} is needed: at which it jumped")
    forces = validate.positive_array(force, forcing).ravel()
    seen = []
    for name, value in (("jump_up", up), ("jump_down", down)):
        row = np.full(forces.size, np.nan) if value is None else validate.real_array(name, value).astype(float)
        if row.shape != forces.shape or (row <= 0).any() or np.isinf(row).any():
            raise Refused(f"{name} is not allowed: it must have a frequency > 0, or NaN, for each {force}")
        seen.append(row)
    measured = np.array(seen)
    there = ~np.isnan(measured)

    def of_design(design: Any) -> Floats:
        """0 where the design does not jump."""
        mount = isinstance(design, Physical)
        isolator, units = (design.oscillator, design.scales.sizes) if mount else (design, None)
        F_0 = forces / units[subject.amplitude] if units else forces
        known = {name: value for name, value in isolator.given.items() if name != "mu_s"}  # no fold asks for it
        folds = type(isolator).many(**known).saddle_nodes(F_0)
        found = np.array([first_jump(folds, True), first_jump(folds, False)]) * (units["frequency"] if units else 1.0)
        return np.asarray(np.nan_to_num(found)[there])

    letter, kind, _ = EXCITED[subject.excitation]
    names = (f"{letter}/{next(iter(UNITS[kind]))}" if subject.mount else force, f"measured less fitted {frequency}")
    return _Measured(measured[there], np.broadcast_to(forces, there.shape)[there], of_design, names)


def _nearest(subject: Subject, design: Any, at: Floats, forcing: Floats, measured: Floats) -> Floats:
    """The stable amplitude nearest to each measured one, 0 where there is none."""
    units = design.scales.sizes if isinstance(design, Physical) else dict.fromkeys(UNITS, 1.0)
    isolator = design.oscillator if isinstance(design, Physical) else design
    Omega, F_0 = at / units["frequency"], forcing / units[subject.amplitude]
    states = isolator.amplitudes(Omega=Omega, F_0=F_0)
    found = np.zeros_like(measured)
    for k, (x, y, A) in enumerate(zip(Omega, F_0, measured, strict=True)):
        here = states.A[(states.Omega == x) & (states.F_0 == y) & states.stable] * units["length"]
        if here.size:
            found[k] = here[np.argmin(np.abs(here - A))]
    return found
