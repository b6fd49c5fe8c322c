"""Random vibration of one oscillator. Takes its equation of motion and a spectrum; returns all stationary motions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from slowflow import validate
from slowflow.answer import joined
from slowflow.mechanism import EquationOfMotion, Floats
from slowflow.random_vibration.answers import RandomResponse
from slowflow.random_vibration.excitation import Excitation, Tabulated, White
from slowflow.random_vibration.fixed_points import GIVES_WAY, fixed_points
from slowflow.random_vibration.gaussian import averages
from slowflow.support.errors import NotSettled, Refused
from slowflow.text import Sentence, text
from slowflow_kernels import linearization

ONE_OF = "random takes either S_0, of white noise, or psd, a table of frequencies and densities"
UNDAMPED = text("random vibration needs dry friction or viscous damping: {mu = :g} and zeta = 0 leave none", 0.0)
UNDECIDED = Sentence("there may be another equivalent linear oscillator next to {stiffness = :.4g}, {damping = :.4g}")
#: share of friction in the damping up to which sigma_u and sigma_v were within 4 % of records of the motion
MOST_DRY = 0.8
SEVERAL = Sentence(
    "{count:d} linear oscillators are equivalent: the motion moves from one to the other, with the averages of none; "
    "measure() follows it in time"
)
DRY = Sentence(
    "dry friction is {dry:.2g} of the equivalent damping: above {most:g} root mean squares may be off by more than "
    "4 %; measure() follows the motion in time"
)


def random(oscillator: Any, system: EquationOfMotion, S_0: Any, psd: Any) -> RandomResponse:
    """See `slowflow.oscillator.Oscillator.random`."""
    if (S_0 is None) == (psd is None):
        raise Refused(ONE_OF)
    validate.is_plain("random", f"rubs = {oscillator.rubs!r}" if system.released else "")
    if system.mu == system.zeta == 0:
        raise validate.NotAvailable(UNDAMPED)
    excitation: Excitation
    if psd is None:
        excitation = White(validate.number("S_0", S_0, above=0.0))
    else:
        excitation = Tabulated(*validate.two_rows("psd", psd, "frequencies and densities"))
    found = fixed_points(system, excitation)
    k, c = np.exp(found.x)
    if found.undecided.size:
        raise NotSettled(UNDECIDED.format(*np.exp(found.undecided[:, 0])))
    if not k.size:
        raise NotSettled(GIVES_WAY)
    return _answer(system, excitation, k, c, oscillator)


def _answer(system: EquationOfMotion, excitation: Excitation, k: Floats, c: Floats, asked: Any) -> RandomResponse:
    """Of stiffness and damping of each fixed point."""
    squares = np.exp(excitation.moments(np.log(k), np.log(c)).value)
    order = np.argsort(squares[0])
    k, c, (u, v) = k[order], c[order], np.sqrt(squares[:, order])
    laws = system.mu, system.zeta, system.c_2
    dry = linearization.equivalent_damping(v, *laws)[2] / c
    a = np.sqrt(averages(system.force, u).square + linearization.damping_force(v, *laws))
    end = math.nan if (first := system.force.first_end) is None else first
    beyond = np.array([math.erfc(end / (math.sqrt(2) * one)) for one in u.tolist()])
    rate = linearization.crossings(end, u, v)
    said = joined(
        SEVERAL.format(k.size) if k.size > 1 else "",
        DRY.format(float(dry.max()), MOST_DRY) if (dry > MOST_DRY).any() else "",
    )
    found = (u, v, a, k, c, np.sqrt(k), c / (2 * np.sqrt(k)), beyond, rate, dry)
    return RandomResponse(*found, said, excitation, system, asked)
