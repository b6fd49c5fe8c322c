"""Random vibration of one oscillator. Takes its equation of motion and a spectrum; returns all stationary motions."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from slowflow.answers.answer import joined
from slowflow.core import validate
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import EquationOfMotion, Floats
from slowflow.exact.motion import handle
from slowflow.random_vibration.answers import RandomResponse, crossings
from slowflow.random_vibration.excitation import Excitation, Tabulated, White
from slowflow.support.errors import NotSettled, Refused
from slowflow.support.text import Sentence, text
from slowflow_kernels import linearization

ONE_OF = "random takes either S_0, of white noise, or psd, a table of frequencies and densities"
UNDAMPED = text(
    "random vibration needs viscous damping, or dry friction that acts throughout; under white noise c_2 suffices: "
    "{mu = :g} and zeta = 0 leave no damping",
    0.0,
)
UNDECIDED = Sentence("there may be another equivalent linear oscillator next to {stiffness = :.4g}, {damping = :.4g}")
#: over sigma_u where friction ends that acts throughout
THROUGHOUT = 40.0
#: of a stationary motion: `sf_stationary` of `native/exact/gaussian.h`
NUMBERS = 8
#: up to these shares in the damping sigma_u and sigma_v were within 5 % of records of the motion: of friction
#: throughout about the centre and about a mean, of friction that ends, of c_2, c_3 and zeta_2; and from so many times
#: the lowest frequency of the excitation to its highest one (docs/validity.md)
MOST_DRY, MOST_DRY_ABOUT, MOST_ATTACHED, MOST_NONLINEAR, NARROW = 0.8, 0.6, 0.5, 0.5, 4.0
STUCK = "friction holds the mass nearly all of the time: no linear damping is equivalent to it"
NOT_PUSHED_BACK = (
    "random vibration about a mean needs a spring force that exceeds the load far from the centre, on both sides"
)
GIVES_WAY = (
    "there is no equivalent linear oscillator: on average the spring pushes away from the centre, or is too weak to "
    "hold the mass"
)
SEVERAL = Sentence(
    "there are {count:d} equivalent linear oscillators: the motion switches between them, and its averages match none "
    "of theirs; {exact:s}"
)
DRY = Sentence(
    "dry friction is {dry:.2g} of the equivalent damping: above {most:g} root mean squares may be off by more than "
    "5 %; {exact:s}"
)
NONLINEAR = Sentence(
    "nonlinear damping is {nonlinear:.2g} of the equivalent damping: above {most:g} root mean squares may be off by "
    "8 %; {exact:s}"
)
IN_A_BAND = (
    "the excitation is narrow-band, and the natural frequency of the motion moves in and out of the band: root mean "
    "squares may be off by 9 %, with stops by 25 %; measure() simulates the motion"
)
#: about a mean: up to this fraction of the mean square of the force that is not linear they were within 4 % of the
#: exact density (docs/limits.md); by how many root mean squares equilibria are looked for
MOST_CURVED, NEAR_MEAN = 0.1, np.linspace(-6.0, 6.0, 241)
CURVED = Sentence(
    "{curved:.2g} of the mean square of the force is not linear about the mean: above {most:g} the mean and root mean "
    "squares may be off by more than 4 %; {exact:s}"
)
WELLS = Sentence(
    "the force has several equilibria within reach of the motion, which switches between them: mean and root mean "
    "squares about one of them may match none of its averages; {exact:s}"
)
#: where averages are without these errors, of white noise and of others
EXACT_DENSITY, IN_TIME = "fokker_planck has the exact density", "measure() simulates the motion"


def random(oscillator: Any, system: EquationOfMotion, S_0: Any, psd: Any) -> RandomResponse:
    """See `slowflow.oscillators.oscillator.Oscillator.random`."""
    excitation = excited_by(S_0, psd)
    columns = stationary(system, excitation)
    message = functools.partial(_diagnostics, system, excitation, columns)
    return RandomResponse._made(**columns, message=message, excitation=excitation, system=system, _equation=oscillator)


def _diagnostics(system: EquationOfMotion, excitation: Excitation, columns: dict[str, Floats]) -> str:
    """How far statistical linearization is to be trusted, as text."""
    u, dry, exact = columns["u_rms"], columns["dry"], EXACT_DENSITY if isinstance(excitation, White) else IN_TIME
    most = MOST_ATTACHED if system.released else MOST_DRY if system.centred else MOST_DRY_ABOUT
    nonlinear = 1 - dry - 2 * system.zeta / columns["damping"]
    return joined(
        SEVERAL.format(u.size, exact) if u.size > 1 else "",
        DRY.format(float(dry.max()), most, exact) if (dry > most).any() else "",
        NONLINEAR.format(float(nonlinear.max()), MOST_NONLINEAR, exact) if (nonlinear > MOST_NONLINEAR).any() else "",
        "" if system.centred else _about_means(system, columns, exact),
        IN_A_BAND if isinstance(excitation, Tabulated) and excitation.Omega[-1] < NARROW * excitation.Omega[0] else "",
    )


def _about_means(system: EquationOfMotion, columns: dict[str, Floats], exact: str) -> str:
    """What to bear in mind of motions about a mean: equilibria within reach, a force that is far from linear."""
    B, u, v, a, k = (columns[name] for name in ("B", "u_rms", "v_rms", "a_rms", "stiffness"))
    above = system.force(B[:, np.newaxis] + u[:, np.newaxis] * NEAR_MEAN) > system.load
    laws = system.mu, system.zeta, system.c_2, system.c_3, system.zeta_2
    of_force = a**2 - linearization.damping_force(THROUGHOUT, 1.0, u, v, *laws)
    curved = float((1 - (k * u) ** 2 / of_force).max())
    return joined(
        WELLS.format(exact) if (np.diff(above, axis=1).sum(axis=1) > 1).any() else "",
        CURVED.format(curved, MOST_CURVED, exact) if curved > MOST_CURVED else "",
    )


def excited_by(S_0: Any, psd: Any) -> Excitation:
    """The excitation of one oscillator. Raises ValueError for both or none of these, and where they are not allowed."""
    if (S_0 is None) == (psd is None):
        raise Refused(ONE_OF)
    if psd is None:
        return White(validate.number("S_0", S_0, above=0.0))
    return Tabulated(*validate.two_rows("psd", psd, "frequencies and densities"))


def stationary(system: EquationOfMotion, excitation: Excitation) -> dict[str, Floats]:
    """The columns of `RandomResponse`, by rising u_rms. Raises as `Oscillator.random`."""
    if not is_damped(system.mu, system.zeta, system.c_2, system.released, isinstance(excitation, White)):
        raise validate.NotAvailable(UNDAMPED)
    *left, found = EXACT.stationary(handle(system), excitation.for_C)
    if left[0] < 0:
        raise NotSettled(STUCK if left[0] > -2 else NOT_PUSHED_BACK)
    if left[0]:
        raise NotSettled(UNDECIDED.format(*left))
    if not found:
        raise NotSettled(GIVES_WAY)
    return columns(np.frombuffer(found).reshape(-1, NUMBERS), system.force.first_ends)


def is_damped(mu: Any, zeta: Any, c_2: Any, released: bool, white: bool) -> Any:
    """Whether there are stationary motions at any stiffness, of numbers or arrays."""
    return (zeta != 0) | (mu != 0) & (white or not released) | (c_2 != 0) & white


def columns(motions: Floats, ends: Any) -> dict[str, Floats]:
    """Columns of stationary motions, (..., NUMBERS), for the ends of the force's first piece."""
    mean, u, v, square, k, c, dry, beyond = (motions[..., number] for number in range(NUMBERS))
    Omega, none = np.sqrt(k), np.isinf(ends[0]) & np.isinf(ends[1])
    rate = np.where(none, np.nan, crossings(ends, mean, u, v))
    found = mean, u, v, np.sqrt(square), k, c, Omega, c / (2 * Omega), np.where(none, np.nan, beyond), rate, dry / c
    return dict(zip(RandomResponse.entry._fields, found, strict=True))
