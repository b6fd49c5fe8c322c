"""Parameter identification from amplitudes, phases, jump frequencies, decays and loops.

Parameters are found by least squares on averaged states, with SciPy. If there are several motions at a frequency, the
one nearest to the measured value is used.
"""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares
from scipy.special import stdtrit

from slowflow.answers.answer import Table, joined
from slowflow.answers.quantities import SHEET, SI, in_shown, si
from slowflow.core import validate
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import EquationOfMotion, Floats
from slowflow.core.model import THROUGHOUT
from slowflow.exact.motion import MOST_STEPS, handle, system_of
from slowflow.exact.transient import record
from slowflow.oscillators.range_checks import Implausible
from slowflow.random_vibration.record import accelerations
from slowflow.sizing.samples import CONSTANT, in_time, systematic, velocity
from slowflow.sizing.subject import Measured, Subject, first_jump
from slowflow.support.errors import NotSettled, Refused
from slowflow_kernels import slow_flow

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Fit", "Numbers", "fit"]

#: share of all fits whose interval holds the number, if the noise is normal and the equations are right
CONFIDENCE = 0.95
#: what a number may become, over what it was; a number that is 0 may become this share of 1
LEAST, MOST, FROM_NOTHING = 1e-3, 1e3, 1e-3
#: how near to an end of that range a number has run into it
AT_AN_END = 1e-3
RAN_OUT = "no fit: {} left the range from 1/1000 to 1000 times the start value: check units and start"
#: starts beside the given one, and how far from it they are, as a factor
STARTS, FAR = 5, 3.0
#: how often a lower minimum beside the one found is taken; from which share on a sum of squares is another one, and
#: up to which share of that of the measured values one is rounding
AGAIN, OTHER, NOTHING = 3, 1e-3, 1e-15
#: folds, or states, of a design; by doubles alone, as balls take longer and tell of pairs next to each other only
MAX_COUNT = 6
#: a narrower interval, as a share of the number, is one of rounding; a step of slopes, as a share of a number
WIDTH, STEP = 1e-9, 2.0**-26
#: by how much a motion may be off, as a share of the measured value, and be the one that is proved
SAME = 1e-6
#: designs of each group in the search for the ends of intervals, steps of these at most, and in how many of them no end
#: moves by more than a share of its distance from the middle when it is done
MEMBERS, GENERATIONS, PATIENCE, NEARLY = 12, 600, 40, 1e-2
#: decades between which the distance of designs lies that it begins with, as a share of the numbers found
DECADES = (-2.5, -0.3)
OTHER_START = "a search from the given start ends with a sum of squares of {:.3g}, from another one with {:.3g}"
OPEN = "the points do not determine {}: an interval has no end within 1/1000 to 1000 times the start value"
#: the displacement that a free decay begins with
RELEASED = "x_0"
LEAST_SAMPLES = 10
#: what is measured, by the arguments of `fit`
MEASURED = ("A", "phi", "jump_up", "jump_down", "backbone", "x", "t")
#: a velocity that leaves friction alone
SLOW = 1e-100
UNPROVED = (
    "at {} of the {} points the motions of the fitted design, which are proved, are not those that the search found: "
    "the fit may not be the best one"
)
ABSENT = "the fitted design has no such motion, or jump, at {} of the {} points"


#: of designs, a row each, what they leave at each point
Residuals = Callable[[Floats], Floats]
#: what designs have at each point, a row each, from their numbers by name, and whether doubles suffice without a proof
OfDesigns = Callable[[Mapping[str, Any], bool], Floats]


@dataclass(frozen=True, eq=False)
class Numbers(Table, entry="Fitted"):
    """Common part of fits: numbers with their standard errors and intervals, one row each."""

    parameter: npt.NDArray[np.str_]
    unit: npt.NDArray[np.str_]
    value: Floats
    error: Floats
    low: Floats
    high: Floats


@dataclass(frozen=True, eq=False)
class Fit(Numbers):
    """Parameters fitted to a measurement, one row each.

    value     -- the fitted value, for a mount in SI units, given by `unit`
    error     -- its standard error, from the linearized equations
    low, high -- its 95 % confidence interval by the profile likelihood, with 0 or inf where the data do not bound it
    design    -- the oscillator or mount with the fitted values
    residuals -- measured minus fitted amplitude, phase, jump frequency, displacement or force at each point, in order;
                 upward jumps first
    at        -- the frequency, the forcing, the time or the displacement of each point
    names     -- names of `at` and `residuals`, with units
    deviation -- standard deviation of the residuals, with (points - parameters) degrees of freedom
    correlation -- correlation matrix of the parameters, shape (n, n)
    """

    design: Any = field(repr=False)
    residuals: Floats
    at: Floats
    names: tuple[str, str]
    deviation: float
    correlation: Floats
    message: str

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot the residuals, for a mount in mm, N, Hz; return the Matplotlib axes, new ones by default.

        The band of two standard deviations is shaded.
        """
        from slowflow.answers import pictures

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
    *sets: Mapping[str, Any],
    A: Any = None,
    phi: Any = None,
    jump_up: Any = None,
    jump_down: Any = None,
    backbone: Any = None,
    x: Any = None,
    t: Any = None,
    free: Sequence[str] | None = None,
    **at: Unpack[Measured],
) -> Fit:
    """Fit parameters of an oscillator to measured amplitudes, phases, jumps, a backbone, a free decay or a loop.

    The residuals are minimized by least squares; those of several data sets are weighted by their standard deviations.

    Noise is assumed to be normal and equal at all points; with noise in proportion to the amplitude the intervals are
    too narrow. The intervals account for noise alone, not for the error of averaging, which may shift a parameter by a
    percent. They use the profile likelihood with Student's t: in 100 fits of one to four parameters, 91 to 96 % of the
    intervals contained the true value, 88 to 97 % for curves that jump; under a load, 95 % of 192 did. If the data do
    not bound a parameter, its interval ends at 0 or inf, and the message names the parameter. Six starting points are
    tried, which does not prove that there is no lower minimum; the message reports if the given start leads to a higher
    one. The search finds motions without a proof; the residuals are those of proved motions of the fitted design, and
    the message reports where the search found others.

    Parameters
    ----------
    of : Oscillator or Physical
        The starting point, and the values of the parameters that are not free; a mount in SI units.
    *sets : mapping
        Several data sets together: for each, the arguments below by name, and `deviation`, its standard deviation, by
        which it is weighted. The `deviation` of the fit is then about 1, unless a given one is wrong.
    A : array_like, optional
        Measured amplitudes, for a mount in m.
    phi : array_like, optional
        Instead of A: phases of the first harmonic, in radians, as in `amplitudes`: -pi/2 is a lag of a quarter cycle.
        Multiples of 2 pi do not matter.
    jump_up, jump_down : array_like, optional
        Instead of A: the frequency of the jump at each forcing, for a mount in Hz; one or both, NaN where none was
        observed.
    backbone : array_like, optional
        With A and no forcing: frequencies of free vibration at these amplitudes, or of resonance, for a mount in Hz.
    x, t : array_like, optional
        A free decay: displacements (for a mount in m) and their times (in s), released from rest at the first sample.
        The equation of motion is integrated from an initial displacement x_0 that is fitted too. The decay of the
        starting point must stay in phase with the data, within a fraction of a cycle. Or, with forces F in N, a
        force-displacement loop, whose viscous part needs the times; its mean force is ignored.
    free : sequence of str, optional
        Names of the parameters to fit; by default friction, damping and stiffnesses.
    **at : Measured
        Forcings by name, F, Y, a or U for a mount as in `Physical`, F_0 for an oscillator, and frequencies, f in Hz or
        Omega; they broadcast with A or phi.

    Returns
    -------
    Fit
        .value .error .low .high, one entry per parameter; .design has the fitted values.

    Raises
    ------
    ValueError, ArithmeticError
        For invalid arguments, such as fewer points than free parameters; if the data do not determine the parameters.
    """
    own = {"A": A, "phi": phi, "jump_up": jump_up, "jump_down": jump_down, "backbone": backbone, "x": x, "t": t, **at}
    if not sets:
        subject, measured = _one_set(of, free, own)
    elif any(value is not None for value in own.values()):
        raise Refused("a fit takes either data sets or keyword arguments: put the latter into a data set of their own")
    else:
        found = [_one_set(of, free, {name: one[name] for name in one if name != "deviation"}) for one in sets]
        subject, measured = found[0][0], _together([one for _, one in found], [one.get("deviation") for one in sets])
    # the number of springs is known, and a spring without a quintic term is cubic
    start = getattr(of, "oscillator", of)
    known = {"lam"} | ({"gamma"} if getattr(start, "gamma", None) == 0 else set())
    default = [subject.name(one) for one in ("mu", "zeta", *subject.mechanism.design_names) if one not in known]
    with np.errstate(
        over="ignore", divide="ignore", invalid="ignore"
    ):  # numbers at the ends of the range: words follow
        return _fitted(subject, measured, default if free is None else list(free))


def _one_set(of: Any, free: Sequence[str] | None, data: Mapping[str, Any]) -> tuple[Subject, _Measured]:
    """What is varied, and one data set of it, as `fit` takes it. Raises ValueError for what is not allowed."""
    A, phi, jump_up, jump_down, backbone, x, t = map(data.get, MEASURED)
    at = {name: value for name, value in data.items() if name not in MEASURED}
    F = at.pop("F", None) if x is not None else None
    subject = Subject(of, () if free is None else free, at)
    kinds = [A is None or backbone is not None, phi is None, jump_up is None and jump_down is None, backbone is None]
    if [*kinds, x is None].count(False) != 1:
        raise Refused(
            "a fit needs either measured amplitudes A, or phases phi, or jump_up or jump_down, or a backbone, or x"
        )
    if t is not None and x is None:
        raise Refused("t needs x, the displacements at these times")
    if x is not None:
        return subject, _in_time(subject, {"x": x, "t": t, "F": F})
    if subject.mount:
        A, backbone = si("A", A, "m"), si("backbone", backbone, "Hz")
        jump_up, jump_down = si("jump_up", jump_up, "Hz"), si("jump_down", jump_down, "Hz")
    if backbone is not None:
        if subject.loaded:
            raise validate.NotAvailable("a fit to a backbone is not available with a load")
        return subject, _backbone(subject, A, backbone)
    if A is None and phi is None:
        return subject, _jumps(subject, subject.measured()[0], jump_up, jump_down)
    points = dict(zip(reversed(subject.names), reversed(subject.measured()), strict=True))
    return subject, _states(subject, points, "phi" if A is None else "A", phi if A is None else A)


def _together(sets: Sequence[_Measured], deviations: Sequence[Any]) -> _Measured:
    """Several data sets as one, each over its standard deviation."""
    each = [
        validate.number("deviation", si("deviation", one, of.unit), above=0.0)
        for of, one in zip(sets, deviations, strict=True)
    ]

    def of_designs(numbers: Mapping[str, Any], by_doubles: bool) -> Floats:
        rows = [of.of_designs(numbers, by_doubles) / one for of, one in zip(sets, each, strict=True)]
        return np.concatenate(rows, axis=-1)

    values = np.concatenate([of.values / one for of, one in zip(sets, each, strict=True)])
    names = ("point", "measured minus fitted, over its standard deviation")
    ends = np.cumsum([of.values.size for of in sets]).tolist()
    series = tuple(slice(end - of.values.size, end) for of, end in zip(sets, ends, strict=True) if of.series)
    released = [of.released for of in sets if of.released]
    if len(released) > 1:
        raise Refused("more than one free decay is not allowed: each has an x_0 of its own")
    return _Measured(values, np.arange(1.0, values.size + 1), of_designs, names, sum(released), series)


@dataclass(frozen=True)
class _Measured:
    """What was measured: values, where, what designs have there, a row each, from their numbers, and names of both.

    released -- of a free decay from which displacement, 0 of what is none
    series   -- which of the values are samples in time, of one motion each
    """

    values: Floats
    at: Floats
    of_designs: OfDesigns
    names: tuple[str, str]
    released: float = 0.0
    series: tuple[slice, ...] = ()

    @property
    def unit(self) -> str:
        """Of the values."""
        return self.names[1].partition("/")[2]


def _fitted(subject: Subject, measured: _Measured, names: list[str]) -> Fit:
    """The numbers that leave the least squares."""
    size = measured.values.size
    if not names:
        raise Refused("free = [] is not allowed: name at least one parameter to fit")
    if size <= len(names):
        raise Refused(f"{size} points are too few for {len(names)} parameters")
    start = np.array([subject.nominal[name] or FROM_NOTHING for name in names])
    if measured.released:
        names, start = [*names, RELEASED], np.append(start, measured.released)

    def residuals(x: Floats, by_doubles: bool = True) -> Floats:
        """Measured less what designs have, a row each; all that was measured where there is none, or no design."""
        columns = dict(zip(names, (x * start).T[..., np.newaxis], strict=True))
        return np.asarray(measured.values - measured.of_designs(columns, by_doubles))

    found, own = _best(residuals, len(start))
    left = size - len(names)
    half = float(stdtrit(left, 0.5 * (1 + CONFIDENCE)))
    ends = None
    for _ in range(AGAIN):
        ran_out = (found.x < LEAST * (1 + AT_AN_END)) | (found.x > MOST * (1 - AT_AN_END))
        error = np.sqrt(np.diag(_covariance(found, left)))
        # without noise they are narrower than rounding
        if ran_out.any() or (half * error < WIDTH * found.x).all():
            break
        ends, lower = _region(residuals, found, half, left)
        if lower is None:
            break
        found = _search(residuals, lower)
    covariance = _covariance(found, left)
    if not (np.isfinite(covariance).all() or ran_out.any()):
        raise NotSettled(f"the points do not determine {', '.join(names)}")
    deviation = float(np.sqrt(2 * found.cost / left))
    error = np.sqrt(np.diag(covariance))
    if ends is None:
        ends = np.maximum(np.stack((found.x - half * error, found.x + half * error)), 0.0)
    value, correlation = found.x * start, covariance / np.outer(error, error)
    low, high = np.sort(ends * start, axis=0)
    open_ = [name for name, one, other in zip(names, *ends, strict=True) if one == 0 or other == np.inf]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", Implausible)  # the message says what numbers at the ends of the range are
        found_by_name = dict(zip(names, value.tolist(), strict=True))
        design = subject.of.replace(**{name: one for name, one in found_by_name.items() if name != RELEASED})
    scale = float(measured.values @ measured.values)
    (proved,) = residuals(found.x[np.newaxis], by_doubles=False)
    others = np.count_nonzero(np.abs(proved - found.fun) > SAME * np.abs(measured.values))
    absent = np.count_nonzero(proved == measured.values)
    message = joined(
        "" if found.success else f"the search did not converge: {found.message}",
        RAN_OUT.format(", ".join(np.array(names)[ran_out])) if ran_out.any() else "",
        OTHER_START.format(2 * own, 2 * found.cost) if own > found.cost * (1 + OTHER) + NOTHING * scale else "",
        OPEN.format(", ".join(open_)) if open_ else "",
        UNPROVED.format(others, size) if others else "",
        ABSENT.format(absent, size) if absent else "",
        *dict.fromkeys(systematic(proved[of], measured.values[of]) for of in measured.series),
    )
    sheet = {**SHEET, RELEASED: "m"}
    units = np.array([sheet[name] if subject.mount else "" for name in names], dtype=np.str_)
    columns = (np.array(names), units, value, error * np.abs(start), low, high)
    return Fit(*columns, design, proved, measured.at, measured.names, deviation, correlation, message)


def _covariance(found: Any, left: int) -> Floats:
    """Of the numbers, by the equations made linear; not finite where these do not determine them."""
    try:
        return np.asarray(np.linalg.inv(found.jac.T @ found.jac) * 2 * found.cost / left)
    except np.linalg.LinAlgError:
        return np.full((found.x.size, found.x.size), np.inf)


def _search(residuals: Residuals, x: Floats, tolerance: float = 1e-12, most: int | None = None) -> Any:
    """The minimum that is found from x on, by slopes from steps of all numbers together."""

    def slopes(x: Floats) -> Floats:
        steps = STEP * np.diag(x)
        rows = residuals(np.concatenate((x[np.newaxis], x + steps, x - steps)))
        up, down = rows[1 : 1 + x.size] - rows[0], rows[0] - rows[1 + x.size :]
        # the step that does not take a fold past the point
        return np.asarray((np.where(np.abs(up) < np.abs(down), up, down) / np.diag(steps)[:, np.newaxis]).T)

    bounds, ends = (LEAST, MOST), {"xtol": tolerance, "ftol": tolerance, "max_nfev": most}
    return least_squares(lambda x: residuals(x[np.newaxis])[0], x, slopes, bounds=bounds, x_scale="jac", **ends)


def _best(residuals: Residuals, n: int) -> tuple[Any, float]:
    """The lowest minimum from several starts, always the same ones, and half of the sum of squares from the given one.

    Without noise, where the given start leads to the numbers, none is lower.
    """
    found = _search(residuals, np.ones(n))
    own = float(found.cost)
    # a low-discrepancy sequence: the fractional parts of multiples of powers of the root of x^(n + 1) = x + 1
    root = float(np.max(np.real(np.roots([1.0, *[0.0] * (n - 1), -1.0, -1.0]))))
    for k in range(1, STARTS + 1):
        fraction = (0.5 + k * root ** -np.arange(1.0, n + 1)) % 1.0
        other = _search(residuals, FAR ** (2 * fraction - 1), tolerance=1e-4, most=30)
        if other.cost < found.cost * (1 - OTHER):
            found = min((found, _search(residuals, other.x)), key=lambda one: one.cost)
    return found, own


def _region(residuals: Residuals, found: Any, t: float, left: int) -> tuple[Floats, Floats | None]:
    """Ends of the numbers of all designs whose sum of squares S exceeds the least by t^2 variances at most.

    Shape (2, n), 0 or inf where there is none within the range; and numbers whose S is lower than that of the minimum
    found, None if none is. Of equations that are linear these are the ends of the usual interval; others are those of
    the profile likelihood, t being Student's.

    Where a curve jumps S does too, as a fold passes a measured frequency: a search along slopes stops at such a wall,
    far from the end. So designs take steps that are differences of others, by differential evolution. A group of them
    goes for each end, and one for the least S; outside of the region a lower S comes first. Differences of numbers, or
    of their logarithms: in the region friction makes up for damping along a line, stiffness for preload in proportion.
    """
    random, n = np.random.default_rng(0), found.x.size
    # of each number: down, up; and of none
    towards = np.concatenate((-np.eye(n), np.eye(n), np.zeros((1, n))))[:, np.newaxis]
    shape = (len(towards), MEMBERS, n)
    x = np.clip(_first(random, found, t, left, shape), LEAST, MOST)
    S = np.sum(residuals(x.reshape(-1, n)) ** 2, axis=-1).reshape(shape[:2])
    least, lowest, above, reached = 2 * found.cost, found.x, 1 + t * t / left, []
    for _ in range(GENERATIONS):
        y = np.clip(_mixed(random, x), LEAST, MOST)
        S_y = np.sum(residuals(y.reshape(-1, n)) ** 2, axis=-1).reshape(shape[:2])
        further = np.sum((y - x) * towards, axis=-1) >= 0
        further[-1] = S_y[-1] <= S[-1]
        better = np.where(S > least * above, S_y <= S, (S_y <= least * above) & further)
        x[better], S[better] = y[better], S_y[better]
        if S.min() < least:
            least, lowest = float(S.min()), x.reshape(-1, n)[S.argmin()].copy()
        inside = x[S <= least * above]
        reached.append(np.stack((inside.min(axis=0), inside.max(axis=0))))
        change = np.abs(reached[-1] - reached[-1 - PATIENCE :][0])
        if len(reached) > PATIENCE and (change <= 0.5 * NEARLY * np.ptp(reached[-1], axis=0)).all():
            break
    ends = np.where(reached[-1] <= LEAST, 0.0, np.where(reached[-1] >= MOST, np.inf, reached[-1]))
    return ends, lowest if least < 2 * found.cost * (1 - OTHER) else None


def _first(random: np.random.Generator, found: Any, t: float, left: int, shape: tuple[int, int, int]) -> Floats:
    """Designs to begin with: of each group one at the end that linear equations have, others within it and far off."""
    best, n = found.x, found.x.size
    covariance = np.linalg.pinv(found.jac.T @ found.jac) * 2 * found.cost / left
    squares, axes = np.linalg.eigh(covariance)
    near = random.standard_normal(shape) @ (axes * np.sqrt(np.maximum(squares, 0.0))).T * t / np.sqrt(n)
    far = best * 10 ** random.uniform(*DECADES, (*shape[:2], 1)) * random.standard_normal(shape)
    x = best + np.concatenate((near[:, : MEMBERS // 2], far[:, MEMBERS // 2 :]), axis=1)
    error = np.sqrt(np.maximum(np.diag(covariance), np.finfo(float).tiny))
    to_end = t * covariance / error[:, np.newaxis]
    x[:-1, 0], x[-1, 0] = best + np.concatenate((-to_end, to_end)), best
    return np.asarray(x)


def _mixed(random: np.random.Generator, x: Floats) -> Floats:
    """A new design for each: one of its group, moved by the difference of two, or by their ratio in each number."""
    groups, members, n = x.shape
    of_group = np.arange(groups)[:, np.newaxis] * members
    base, *own = (of_group + random.integers(members, size=(groups, members)) for _ in range(3))
    others = random.integers(groups * members, size=(2, groups, members))
    one, other = np.where(random.random((groups, members)) < 0.5, own, others)
    weight = random.uniform(0.4, 1.0, (groups, members, 1)) * 2.38 / np.sqrt(2 * n)
    weight = np.where(random.random((groups, members, 1)) < 0.3, 1.0, weight)
    flat = x.reshape(-1, n)
    by_ratio = random.random((groups, members, 1)) < 0.5
    ratio, difference = (flat[one] / flat[other]) ** weight, weight * (flat[one] - flat[other])
    return np.asarray(np.where(by_ratio, flat[base] * ratio, flat[base] + difference))


def _states(subject: Subject, conditions: Mapping[str, Any], name: str, values: Any) -> _Measured:
    """Amplitudes A or phases phi, as `name` says, at frequencies and forcings."""
    if any(value is None for value in conditions.values()):
        raise Refused(f"{' and '.join(conditions)} are needed, at which the {name} were measured")
    points = {word: validate.positive_array(word, value) for word, value in conditions.items()}
    points[name] = validate.finite_array(name, values, positive=name == "A")
    shape = validate.common_shape(points)
    at, forcing, measured = (np.broadcast_to(array, shape).ravel() for array in points.values())

    def of_designs(values: Mapping[str, Any], by_doubles: bool) -> Floats:
        """Of the stable state nearest to each measured one, 0 where there is none or the mass rests."""
        designs, _, units = subject.designs(values)
        ask = designs._by_doubles if by_doubles else designs._ask
        F_0, Omega = forcing / units[subject.amplitude], at / units["frequency"]
        states = ask("amplitudes", max_count=MAX_COUNT, F_0=F_0, Omega=Omega)
        if name == "A":
            there = states.A * np.asarray(units["length"])[..., np.newaxis]
        else:
            # as many whole cycles away as the measured one
            there = states.phi + 2 * np.pi * np.round((measured[:, np.newaxis] - states.phi) / (2 * np.pi))
        there = np.where((states.stable == 1) & (states.A > 0), there, np.inf)
        nearest = np.argmin(np.abs(there - measured[:, np.newaxis]), axis=-1)[..., np.newaxis]
        found = np.take_along_axis(there, nearest, -1)[..., 0]
        return np.where(np.isfinite(found), found, 0.0)

    names = _names(subject, subject.names[1], name, "Hz", "m" if name == "A" else "")
    return _Measured(measured, at, of_designs, names)


def _names(subject: Subject, at: str, what: str, *units: str) -> tuple[str, str]:
    """Names of where and of what was measured, over their units if it was of a mount."""
    over, over_left = (f"/{unit}" if unit and subject.mount else "" for unit in units)
    return f"{at}{over}", f"measured minus fitted {what}{over_left}"


def _jumps(subject: Subject, forcing: Any, up: Any, down: Any) -> _Measured:
    """Frequencies of jumps at forcings."""
    force, frequency = subject.names
    if forcing is None:
        raise Refused(f"{force} is needed, at which it jumped")
    forces = validate.positive_array(force, forcing).ravel()
    seen = []
    for name, value in (("jump_up", up), ("jump_down", down)):
        row = np.full(forces.size, np.nan) if value is None else validate.real_array(name, value).astype(float)
        if row.shape != forces.shape or (row <= 0).any() or np.isinf(row).any():
            raise Refused(f"{name} is not allowed: it must have a frequency > 0, or NaN, for each {force}")
        seen.append(row)
    measured = np.array(seen)
    there = ~np.isnan(measured)

    def of_designs(values: Mapping[str, Any], by_doubles: bool) -> Floats:
        """0 where a design does not jump."""
        designs, _, units = subject.designs(values)
        ask = designs._by_doubles if by_doubles else designs._ask
        folds = ask("saddle_nodes", max_count=MAX_COUNT, F_0=forces / units[subject.amplitude])
        found = np.stack([first_jump(folds, True), first_jump(folds, False)], axis=-2)
        found = found * np.asarray(units["frequency"])[..., np.newaxis]
        return np.asarray(np.nan_to_num(found)[..., there])

    names = _names(subject, force, frequency, SI[subject.amplitude], "Hz")
    return _Measured(measured[there], np.broadcast_to(forces, there.shape)[there], of_designs, names)


def _backbone(subject: Subject, amplitudes: Any, frequencies: Any) -> _Measured:
    """Frequencies of the backbone at amplitudes."""
    if amplitudes is None:
        raise Refused("A is needed, the amplitudes of the backbone")
    points = {
        "A": validate.positive_array("A", amplitudes),
        "backbone": validate.positive_array("backbone", frequencies),
    }
    A, measured = (np.broadcast_to(one, validate.common_shape(points)).ravel() for one in points.values())

    def of_designs(values: Mapping[str, Any], _: bool) -> Floats:
        """0 where a design gives way."""
        designs, _, units = subject.designs(values)
        flow, at = designs._flow, A / units["length"]
        found = slow_flow.backbone(at, flow.averaged(at)[0]) * units["frequency"]
        return np.asarray(np.nan_to_num(found))

    return _Measured(measured, A, of_designs, _names(subject, "A", subject.names[1], "m", "Hz"))


def _in_time(subject: Subject, rows: Mapping[str, Any]) -> _Measured:
    """Displacements of a free decay at times, or forces of a loop at displacements."""
    rows = {name: row for name, row in rows.items() if row is not None}
    if len(rows) < 2:
        raise Refused("x needs t, the times of a free decay, or F, the forces of a loop")
    known = in_time(rows, LEAST_SAMPLES, in_si=subject.mount is not None)
    validate.is_in_time("a fit to motions in time", subject.laws)
    return _loop(subject, **known) if "F" in known else _decay(subject, **known)


def loop_of_design(of: Any, x: Any, F: Any, t: Any = None) -> tuple[Floats, Floats, Floats]:
    """Compare a loop measured on one mount with the force of the design.

    Parameters
    ----------
    of : Physical
        The design, of one mount or several equal ones.
    x, F, t : array_like
        Displacements in m, forces in N, times in s (optional), as in `fit`.

    Returns
    -------
    tuple of numpy.ndarray
        Displacements, measured and computed forces less their means, without the samples at which the motion reverses.

    Raises
    ------
    ValueError
        As `fit`.
    """
    subject = Subject(of)
    measured = _in_time(subject, {"x": x, "F": np.multiply(F, subject.mounts), "t": t})
    (force,) = measured.of_designs({name: np.array([[value]]) for name, value in subject.nominal.items()}, False)
    return measured.at, measured.values / subject.mounts, force / subject.mounts


def _systems(subject: Subject, values: Mapping[str, Any]) -> Iterator[tuple[int, EquationOfMotion, dict[str, float]]]:
    """Equations of motion of designs with their numbers and scales; none of what is no design."""
    designs, _, units = subject.designs({name: value for name, value in values.items() if name != RELEASED})
    count = np.size(next(iter(values.values())))
    numbers = {name: np.broadcast_to(value, (count, 1))[:, 0].tolist() for name, value in designs.values.items()}
    sizes = {kind: np.broadcast_to(units[kind], (count, 1))[:, 0].tolist() for kind in ("length", "time", "force")}
    for k in range(count):
        with contextlib.suppress(ValueError):
            one = {name: column[k] for name, column in numbers.items()}
            system = system_of(designs, one, one.get("load", 0.0))
            yield k, system, {kind: column[k] for kind, column in sizes.items()}


def _decay(subject: Subject, x: Floats, t: Floats) -> _Measured:
    """A free decay, from rest at the first sample."""
    if not x[0]:
        raise Refused("x is not allowed: a free decay must begin with a displacement")

    def of_designs(values: Mapping[str, Any], _: bool) -> Floats:
        """0 where a design's motion is lost."""
        begins = np.ravel(values[RELEASED])
        found = np.zeros((begins.size, x.size))
        for k, system, sizes in _systems(subject, values):
            arcs = record((t - t[0]) / sizes["time"], np.zeros(t.size))
            begin = float(begins[k]) / sizes["length"]
            outcome, _, _, states = EXACT.record(
                handle(system), np.ascontiguousarray(arcs), begin, 0.0, *[MOST_STEPS] * 2
            )
            if not outcome:
                found[k] = np.append(begin, np.frombuffer(states)[::2]) * sizes["length"]
        return found

    return _Measured(x, t, of_designs, _names(subject, "t", "x", "s", "m"), float(x[0]), (slice(x.size),))


def _loop(subject: Subject, x: Floats, F: Floats, t: Floats | None = None) -> _Measured:
    """A force-displacement loop where the motion does not turn, less its mean force; slow where there are no times."""
    if subject.contact != THROUGHOUT:
        raise validate.NotAvailable(f"a fit to a loop is not available with contact = {subject.contact!r}")
    v, goes = velocity(x, t)
    if not goes.any():
        raise NotSettled(CONSTANT)
    x, v, F = x[goes], v[goes] if t is not None else SLOW * np.sign(v[goes]), F[goes]

    def of_designs(values: Mapping[str, Any], _: bool) -> Floats:
        found = np.zeros((np.size(next(iter(values.values()))), x.size))
        for k, system, sizes in _systems(subject, values):
            scaled = v * (sizes["time"] / sizes["length"])
            forces = accelerations(system, x / sizes["length"], scaled, np.zeros(x.size)) * sizes["force"]
            found[k] = forces - forces.mean()
        return found

    return _Measured(F - F.mean(), x, of_designs, _names(subject, "x", "F", "m", "N"), series=(slice(x.size),))
