"""Random vibration of one oscillator. Takes its equation of motion and a spectrum; returns all stationary motions."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np

from slowflow.answers.answer import joined
from slowflow.answers.results import NOTHING, Remark
from slowflow.core import validate
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import EquationOfMotion, Floats
from slowflow.exact.motion import handle
from slowflow.random_vibration.answers import RandomResponse, crossings
from slowflow.random_vibration.excitation import MOST_UNEVEN, Excitation, Tabulated, White
from slowflow.random_vibration.gradient import LAWS
from slowflow.support import boundary
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
#: throughout about the centre and about a mean, of friction that ends, of c_2, c_3 and zeta_2 (docs/validity.md)
MOST_DRY, MOST_DRY_ABOUT, MOST_ATTACHED, MOST_NONLINEAR = 0.8, 0.6, 0.5, 0.5
#: of an equation of motion besides its spring
NUMBERS_OF_MOTION = *LAWS, "released", "load"
STUCK = "friction holds the mass nearly all of the time: no linear damping is equivalent to it"
NOT_PUSHED_BACK = (
    "random vibration about a mean needs a spring force that exceeds the load far from the centre, on both sides"
)
TOO_SMALL = (
    "the motion is too small compared with its mean for double precision: it is that of a linear oscillator about the "
    "equilibrium, which rest() has"
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
UNEVEN = Sentence(
    "the density of the excitation varies by a factor above {factor:g} near the natural frequency of the motion, which "
    "moves: root mean squares may be off by 9 % in a narrow band, with stops by 25 %, at the end of a band or at a "
    "narrow peak by more; measure() simulates the motion"
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

Diagnostics: TypeAlias = Iterator[tuple[Remark, Any, Sentence, tuple[Any, ...]]]


def random(oscillator: Any, system: EquationOfMotion, S_0: Any, psd: Any) -> RandomResponse:
    """See `slowflow.oscillators.oscillator.Oscillator.random`."""
    excitation = excited_by(S_0, psd)
    fields: dict[str, Any] = {**stationary(system, excitation), "excitation": excitation, "system": system}
    return RandomResponse._made(**fields, _equation=oscillator, _later=_remarked)


def _remarked(found: RandomResponse) -> dict[str, Any]:
    """Message and remarks of one oscillator."""
    message, remarks = [], NOTHING
    for remark, holds, sentence, numbers in diagnostics_of_one(found.system, found.excitation, vars(found)):
        if holds:
            message.append(sentence.format(*(np.asarray(one).item() for one in numbers)))
            remarks |= remark
    return {"message": joined(*message), "remarks": remarks}


def diagnostics_of_one(system: EquationOfMotion, excitation: Excitation, columns: Mapping[str, Any]) -> Diagnostics:
    """See `diagnostics`."""
    numbers = [getattr(system, name) for name in NUMBERS_OF_MOTION]
    return diagnostics(system.force, numbers, system.force.odd, excitation, columns, columns["u_rms"].size)


def diagnostics(
    force: Callable[[Floats], Floats],
    numbers: Sequence[Any],
    odd: bool,
    excitation: Excitation,
    columns: Mapping[str, Any],
    count: Any,
) -> Diagnostics:
    """How far statistical linearization is to be trusted: remarks, whose they are, and sentences with their numbers.

    numbers -- `NUMBERS_OF_MOTION` of one oscillator, or arrays of many
    columns -- of `RandomResponse`, with one more, last axis, of motions; NaN where there is none
    count   -- of motions
    """
    mu, zeta, c_2, c_3, zeta_2, released, load = (np.asarray(one)[..., np.newaxis] for one in numbers)
    B, u, v, a, k, c, Omega, *_, dry = (columns[name] for name in RandomResponse.entry._fields)
    exact = EXACT_DENSITY if isinstance(excitation, White) else IN_TIME
    offset = (load != 0) | (not odd)
    most = np.where(released, MOST_ATTACHED, np.where(offset, MOST_DRY_ABOUT, MOST_DRY))[..., 0]
    driest, nonlinear = (np.fmax.reduce(one, axis=-1) for one in (dry, 1 - dry - 2 * zeta / c))
    yield Remark.SEVERAL_MOTIONS, count > 1, SEVERAL, (count, exact)
    yield Remark.FAR_FROM_LINEAR, driest > most, DRY, (driest, most, exact)
    yield Remark.FAR_FROM_LINEAR, nonlinear > MOST_NONLINEAR, NONLINEAR, (nonlinear, MOST_NONLINEAR, exact)
    if offset.any():
        above = force(B[..., np.newaxis] + u[..., np.newaxis] * NEAR_MEAN) > load[..., np.newaxis]
        wells = offset & (np.diff(above, axis=-1).sum(axis=-1) > 1)
        of_force = a**2 - linearization.damping_force(THROUGHOUT, 1.0, u, v, mu, zeta, c_2, c_3, zeta_2)
        curved = np.fmax.reduce(np.where(offset, 1 - (k * u) ** 2 / of_force, 0.0), axis=-1)
        yield Remark.SEVERAL_MOTIONS, wells.any(axis=-1), WELLS, (exact,)
        yield Remark.FAR_FROM_LINEAR, curved > MOST_CURVED, CURVED, (curved, MOST_CURVED, exact)
    uneven = (Omega > 0) & excitation.is_uneven(Omega)
    yield Remark.UNEVEN_EXCITATION, uneven.any(axis=-1), UNEVEN, (MOST_UNEVEN,)


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
    boundary.begin()
    *left, found = EXACT.stationary(handle(system), excitation.for_C)
    if left[0] < 0:
        raise NotSettled({-1: STUCK, -2: NOT_PUSHED_BACK, -3: TOO_SMALL}[left[0]])
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
