"""Spring and friction from a measured force-displacement loop.

The force is linear in the unknowns: F = F_mean + k_1 x + k_3 x^3 + friction sign(v) + c v, with k_5 x^5 for degree = 5.
A least-squares fit determines them, without the samples next to a reversal of the motion.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.answers.quantities import SHEET, SPRINGS, in_shown
from slowflow.core.mechanism import Floats
from slowflow.oscillators.isolator import Duffing
from slowflow.oscillators.physical import Physical
from slowflow.sizing.fitting import CONFIDENCE, Numbers
from slowflow.sizing.samples import CONSTANT, in_time, systematic, velocity
from slowflow.support.errors import NotSettled, Refused

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Loop", "from_loop"]

LEAST_SAMPLES = 50
#: standard deviation of speeds in one direction, over the largest, up to which they are one speed and its noise
CONSTANT_SPEED = 0.03
ONE_SPEED = "the loop does not distinguish friction from c at constant speed: without t, friction is the sum of both"


@dataclass(frozen=True, eq=False)
class Loop(Numbers):
    """Parameters identified from a force-displacement loop, one row each; values in SI units.

    error     -- standard errors
    low, high -- 95 % confidence intervals, for normal noise in the force
    F_mean    -- force at x = 0 between the branches, in N
    x, F      -- the loop
    fitted    -- the fitted force, NaN where the motion reverses
    deviation -- standard deviation of the residuals, in N
    """

    F_mean: float
    x: Floats = field(repr=False)
    F: Floats = field(repr=False)
    fitted: Floats = field(repr=False)
    deviation: float
    message: str

    def oscillator(self, *, m: Any, **more: Any) -> Physical:
        """Put a mass on this spring, with this friction and viscous damping.

        Parameters
        ----------
        m : float
            The mass in kg.
        **more : Any
            Other arguments of `Duffing.physical`, such as zeta, or replacements of identified ones.

        Returns
        -------
        Physical
            The mount, in SI units.
        """
        found = dict(zip(self.parameter.tolist(), self.value.tolist(), strict=True))
        return Duffing.physical(m=m, **{**found, **more})

    def plot(self, ax: Axes | None = None) -> Axes:
        """Plot the loop and the fit, in N and mm.

        Parameters
        ----------
        ax : matplotlib.axes.Axes, optional
            Where to draw; new axes by default.

        Returns
        -------
        matplotlib.axes.Axes
            The axes.
        """
        from slowflow.answers import pictures

        (length, mm), (force, _) = in_shown("m"), in_shown("N")
        return pictures.loop(ax, self.x / mm, self.F, self.fitted, (f"x/{length}", f"F/{force}"))


def from_loop(x: Any, F: Any, *, t: Any = None, degree: int = 3) -> Loop:
    """Identify spring and friction of a measured force-displacement loop, by linear least squares.

    Intervals account for normal noise in the force alone. Samples at which the motion reverses are left out. At one
    frequency structural damping is equivalent to viscous damping: its loss factor is then 2 pi f c/k_1.

    Parameters
    ----------
    x : array_like
        Displacement from the equilibrium, in m, shape (n,): sample by sample as measured, over one cycle or several.
    F : array_like
        Force in N, shape (n,).
    t : array_like, optional
        Times of the samples in s, ascending; the viscous damping c is then identified too.
    degree : {3, 5}
        Degree of the spring's polynomial: 5 identifies k_5 too.

    Returns
    -------
    Loop
        .value .error .low .high of k_1, k_3, k_5, friction and c, in SI units; `.oscillator(m=...)` makes an oscillator
        with these.

    Raises
    ------
    ValueError, ArithmeticError
        For invalid arguments, and for a loop with the wrong direction; if it does not determine the parameters.
    """
    if degree not in (3, 5):
        raise Refused(f"degree = {degree!r} is not allowed: it must be 3 or 5")
    rows = in_time({"x": x, "F": F} | ({} if t is None else {"t": t}), LEAST_SAMPLES)
    x, F = rows["x"], rows["F"]
    v, goes = velocity(x, rows.get("t"))
    columns = {
        "F_mean": np.ones_like(x),
        **{name: x**power for name, power in zip(SPRINGS, (1, 3, 5), strict=True) if power <= degree},
        "friction": np.sign(v),
        **({} if t is None else {"c": v}),
    }
    names = list(columns)
    size = np.array([np.abs(column).max() for column in columns.values()])
    if not (size > 0).all():
        raise NotSettled(CONSTANT)
    if t is not None and goes.any():
        each_way = (v[goes & (side * v > 0)] for side in (1, -1))
        if all(one.std() <= CONSTANT_SPEED * np.abs(v[goes]).max() for one in each_way if one.size):
            raise NotSettled(ONE_SPEED)
    of = np.stack(list(columns.values()), axis=1) / size
    value, _, rank, _ = np.linalg.lstsq(of[goes], F[goes])
    left = np.count_nonzero(goes) - len(names)
    if rank < len(names) or left < 1:
        raise NotSettled(f"the loop does not determine {', '.join(names)}")
    residuals = F - of @ value
    deviation = float(np.sqrt(np.sum(residuals[goes] ** 2) / left))
    error = deviation * np.sqrt(np.diag(np.linalg.inv(of[goes].T @ of[goes]))) / size
    # the quantile of few degrees of freedom (Student): SciPy's special functions are quick to load
    from scipy.special import stdtrit

    value, half = value / size, float(stdtrit(left, 0.5 * (1 + CONFIDENCE))) * error
    found = dict(zip(names, value.tolist(), strict=True))
    if found["friction"] + half[names.index("friction")] < 0:
        raise Refused("the loop has the wrong direction: where x rises, F must be larger than where x falls")
    message = systematic(residuals[goes], F)
    own = slice(1, None)  # F_mean is no number of the oscillator
    units = np.array([SHEET[name] for name in names[own]], dtype=np.str_)
    rows_of = value[own], error[own], (value - half)[own], (value + half)[own]
    fitted = np.where(goes, F - residuals, np.nan)
    return Loop(np.array(names[own]), units, *rows_of, found["F_mean"], x, F, fitted, deviation, message)
