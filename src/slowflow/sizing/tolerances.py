"""Tolerances: how results scatter when parameters vary, and Sobol sensitivity indices.

Samples are drawn by Latin hypercube sampling with a seed, and are the same on every machine. Sobol indices need the
package SALib: `pip install 'slowflow[sizing]'`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Unpack

import numpy as np
import numpy.typing as npt
import scipy  # its `stats`, half a second, when it is used

from slowflow.answers.answer import Table, frozen, optional
from slowflow.answers.quantities import in_shown, si
from slowflow.core import validate
from slowflow.core.mechanism import Floats
from slowflow.sizing.subject import Load, LoadCase, Subject
from slowflow.support import boundary, progress
from slowflow.support.errors import Refused

__all__ = ["Sobol", "Tolerances", "sobol", "tolerances"]

#: ends of a band: 95 of 100 samples lie within
LOW, HIGH = 0.025, 0.975
MOST_SAMPLES = 10**7
#: samples at once, between which progress is shown; how many there are if it is not said, and of Sobol' indices
AT_ONCE, SAMPLES, OF_INDICES = 2000, 10_000, 1024
#: the same of designs that are asked one by one
FEW_AT_ONCE, FEW_SAMPLES, FEW_OF_INDICES = 5, 100, 32
MISSING = "{} has no answer for {:.2g} of the samples, which its band excludes"


@dataclass(frozen=True, eq=False)
class Tolerances(Table, entry="Tolerance"):
    """Bands of answers over a tolerance.

    answer, unit -- name and unit of the answer
    nominal      -- value for the nominal design
    low, median, high -- 2.5, 50 and 97.5 % quantiles of the samples that have the answer
    share        -- fraction of samples that have the answer
    samples      -- the answers of all samples, by name
    drawn        -- the parameters of all samples, by name
    """

    answer: npt.NDArray[np.str_]
    unit: npt.NDArray[np.str_]
    nominal: Floats
    low: Floats
    median: Floats
    high: Floats
    share: Floats
    message: str
    samples: Mapping[str, Floats] = field(repr=False)
    drawn: Mapping[str, Floats] = field(repr=False)

    def in_units(self) -> Tolerances:
        """The same in the units in which answers are shown: N, mm, Hz, ... . Drawn parameters stay in SI units."""
        units, of = zip(*map(in_shown, self.unit.tolist()), strict=True)
        shown, sizes = np.array(units, dtype=np.str_), np.array(of)
        bands: dict[str, Any] = {name: getattr(self, name) / sizes for name in ("nominal", "low", "median", "high")}
        own = zip(self.samples.items(), sizes, strict=True)
        samples = {name: frozen(values / size) for (name, values), size in own}
        return replace(self, unit=shown, samples=samples, **bands)


@dataclass(frozen=True, eq=False)
class Sobol(Table, entry="Index"):
    """Sobol' indices: the fraction of an answer's variance due to a parameter; NaN if some samples have no answer.

    first, total -- index of the parameter alone, and index that includes its interactions with others
    first_error, total_error -- half width of their 95 % intervals
    """

    answer: npt.NDArray[np.str_]
    parameter: npt.NDArray[np.str_]
    first: Floats
    first_error: Floats
    total: Floats
    total_error: Floats
    message: str


def _drawn(subject: Subject, within: Mapping[str, Any], shares: Floats) -> dict[str, Floats]:
    """Numbers of the design below which that share of all values lies; shares of shape (samples, numbers)."""
    found = {}
    for (name, off), fraction in zip(within.items(), shares.T, strict=True):
        if hasattr(off, "ppf"):
            found[name] = np.asarray(off.ppf(fraction), dtype=float)
        else:
            share_of = f"within[{name!r}]"
            part = validate.number(share_of, si(share_of, off, ""), least=0.0, below=1.0)
            if part and not subject.nominal[name]:
                raise Refused(f"within[{name!r}] = {part:g} is relative to the nominal value 0: give a distribution")
            found[name] = subject.nominal[name] * (1 + part * (2 * fraction - 1))
    return found


def _within(value: Any) -> Mapping[str, Any]:
    """How far which numbers may be off, as it was given. Raises ValueError for what is not allowed."""
    within = validate.mapping("within", value, "tolerances")
    if not within:
        raise Refused("within = {} is not allowed: give at least one parameter with its tolerance")
    return within


def _answers(
    subject: Subject, drawn: Mapping[str, Floats], names: Sequence[str], load: Load, what: str
) -> dict[str, Floats]:
    """Answers of all that was drawn, in parts between which progress is shown."""
    count = len(next(iter(drawn.values())))
    found = {name: np.empty(count) for name in names}
    for part in progress.chunks(count, FEW_AT_ONCE if subject.one_by_one else AT_ONCE, what):
        for name, values in subject.ask({name: value[part] for name, value in drawn.items()}, names, load).items():
            found[name][part] = values
    return {name: frozen(values) for name, values in found.items()}


def tolerances(
    of: Any,
    within: Mapping[str, Any],
    *,
    answers: Iterable[str] | None = None,
    samples: int | None = None,
    seed: int = 0,
    **at: Unpack[LoadCase],
) -> Tolerances:
    """Propagate tolerances of an oscillator's parameters to its answers, by Latin hypercube sampling.

    Parameters
    ----------
    of : Oscillator or Physical
        The nominal design; a mount in SI units.
    within : mapping
        By name of a parameter: 0.05 for any value within 5 % of the nominal one, or a distribution of the value itself,
        anything with SciPy's `ppf`.
    answers : iterable of str, optional
        Names listed in `slowflow.sizing`; by default all that the load case allows.
    samples : int, optional
        Number of designs; by default 10,000. Under a static load and with other damping laws each takes up to tenths of
        a second: the default is then 100, and the ends of the bands are less accurate.
    seed : int
        Seed of the random numbers.
    **at : LoadCase
        Forcing by name, F, Y, a or U for a mount as in `Physical`, or F_0; frequency f in Hz or Omega; `shock`, peak
        and duration of a half sine of the base, for a mount in m/s^2 and s; `spectrum`, (f, F) or (Omega, F_0), two
        rows of equal length.

    Returns
    -------
    Tolerances
        .nominal .low .median .high .share, one entry per answer; for a mount in SI units.

    Raises
    ------
    ValueError
        For invalid arguments; the message states what is allowed.
    """
    subject = Subject(of, _within(within), at)
    load = subject.load()
    names = subject.answered(answers, load)
    if samples is None:
        samples = FEW_SAMPLES if subject.one_by_one else SAMPLES
    samples = validate.count("samples", samples, least=2, most=MOST_SAMPLES)
    seed = validate.count("seed", seed, least=0)
    drawn = _drawn(subject, within, scipy.stats.qmc.LatinHypercube(d=len(within), rng=seed).random(samples))
    boundary.begin()
    found, nominal = _answers(subject, drawn, names, load, "tolerances"), subject.ask({}, names, load)
    rows = []
    for name in names:
        there = found[name][~np.isnan(found[name])]
        # samples themselves: between infinities there is nothing to interpolate
        ends = np.quantile(there, (LOW, 0.5, HIGH), method="inverted_cdf") if there.size else np.full(3, np.nan)
        rows.append((float(nominal[name]), *ends.tolist(), there.size / samples))
    columns = np.array(rows).reshape(-1, 5).T
    missing = [MISSING.format(name, 1 - share) for name, share in zip(names, columns[4], strict=True) if share < 1]
    units = np.array([subject.unit(name) for name in names], dtype=np.str_)
    one, low, median, high, fraction = columns
    message = "; ".join(missing)
    return Tolerances(np.array(names, dtype=np.str_), units, one, low, median, high, fraction, message, found, drawn)


def sobol(
    of: Any,
    within: Mapping[str, Any],
    *,
    answers: Iterable[str] | None = None,
    samples: int | None = None,
    seed: int = 0,
    **at: Unpack[LoadCase],
) -> Sobol:
    """Rank tolerances by Sobol' indices, from samples times (parameters + 2) designs.

    Parameters
    ----------
    of, within, answers : as in `tolerances`
        The design, its tolerances and the answers.
    samples : int, optional
        A power of two; by default 1024, under a static load 32.
    seed, **at : as in `tolerances`
        The random numbers and the load case.

    Returns
    -------
    Sobol
        .first .total and their errors, dimensionless, one entry for each answer and parameter.

    Raises
    ------
    ValueError, ImportError
        For invalid arguments; without SALib.
    """
    subject = Subject(of, _within(within), at)
    load = subject.load()
    names = subject.answered(answers, load)
    if samples is None:
        samples = FEW_OF_INDICES if subject.one_by_one else OF_INDICES
    samples = validate.count("samples", samples, least=2, most=MOST_SAMPLES)
    seed = validate.count("seed", seed, least=0)
    if samples & (samples - 1):
        raise Refused(f"samples = {samples} is not allowed: samples must be a power of two")
    sample, analyse = (optional(f"SALib.{part}.sobol", "sobol", "sizing") for part in ("sample", "analyze"))
    problem = {"num_vars": len(within), "names": list(within), "bounds": [[0.0, 1.0]] * len(within)}
    shares = sample.sample(problem, samples, calc_second_order=False, seed=seed)
    found = _answers(subject, _drawn(subject, within, shares), names, load, "sobol")
    rows, missing = [], []
    for name in names:
        values = np.full((4, len(within)), np.nan)
        if np.isfinite(found[name]).all() and np.ptp(found[name]) > 0:
            indices = analyse.analyze(problem, found[name], calc_second_order=False, seed=seed)
            values = np.array([indices[key] for key in ("S1", "S1_conf", "ST", "ST_conf")])
        else:
            missing.append(f"{name} is not finite for all samples, or does not change: it has no indices")
        rows += [(name, parameter, *column) for parameter, column in zip(within, values.T.tolist(), strict=True)]
    answer, parameter, first, first_error, total, total_error = (np.array(column) for column in zip(*rows, strict=True))
    return Sobol(answer, parameter, first, first_error, total, total_error, "; ".join(missing))
