"""Records of random vibration. Takes an equation of motion and an excitation; returns averages over motions in time.

A record is a Gaussian process by its spectrum, straight between samples, whose motion is followed with every switch
between slip and stick and every change of piece.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from slowflow.core import validate
from slowflow.core.backend import EXACT
from slowflow.core.mechanism import EquationOfMotion, Floats
from slowflow.exact.motion import MOST_STEPS, handle, lost
from slowflow.exact.transient import record as arcs_of
from slowflow.random_vibration.excitation import Excitation, White
from slowflow.random_vibration.fokker_planck import damping_force
from slowflow.support.errors import NotSettled
from slowflow.support.text import Sentence
from slowflow_kernels import linearization

#: steps of time: of the slowest of natural periods over a turn, of the times in which damping acts on white noise, and
#: of the period over a turn of the highest frequency of a table that counts
FRACTION, DAMPED, SAMPLED = 0.1, 0.01, 0.7
#: what may be left out of the mean square of the velocity above the highest frequency
LEFT_OUT, GRID = 1e-5, 4001
#: times over that in which the energy of the linear oscillator decays that a record is followed before it counts, and
#: samples that this may take
BEFORE, MOST_BEFORE = 12.0, 4_000_000
SLOW = Sentence(
    "the motion is damped {ratio:.4g} times as much as critically: a record of it settles after more than {most:d} "
    "samples"
)
#: steps of integration that a sample may take on the average
STEPS = 50
#: samples of a record that are followed at once, between which it can be interrupted
AT_ONCE = 20_000


def measured(
    system: EquationOfMotion,
    excitation: Excitation,
    k: Floats,
    c: Floats,
    near: float,
    samples: int,
    records: int,
    seed: int,
) -> tuple[float, ...]:
    """Columns of `MeasuredRandom`; k, c: of the equivalent linear oscillators, near: the mean of the first one."""
    records = validate.count("records", records, least=2)
    each = validate.count("samples", samples, least=100 * records) // records
    step, top = steps(excitation, float(k.max()), c)
    # more damping than critical slows the way back to the mean
    decays = np.minimum(c, 4 * k / (c + np.sqrt(np.maximum(c**2 - 4 * k, 0.0))))
    if not BEFORE <= MOST_BEFORE * step * decays.min():
        raise NotSettled(SLOW.format(float((0.5 * c / np.sqrt(k)).max()), MOST_BEFORE))
    before = math.ceil(BEFORE / (step * float(decays.min())))
    system = replace(system, inertial=False)
    below, above = system.force.first_ends
    random = np.random.default_rng(seed)
    averages = []
    for _ in range(records):
        w = process(excitation, step, top, each + before, random)
        u, v = followed(system, w, step, near)[:, before:]
        a = accelerations(system, u, v, w[before + 1 :])
        y = u - near
        averages.append([np.mean(one) for one in (v**2, a**2, (u < below) | (u > above), y, y**2, y**3, y**4)])
    # the distribution of a mean of few numbers (Student): SciPy's special functions are quick to load
    from scipy.special import stdtrit

    student = float(stdtrit(records - 1, 0.975)) / math.sqrt(records)
    of_each = np.array(averages).T
    v_2, a_2, beyond, y_1, y_2, y_3, y_4 = of_each.mean(axis=1)
    off = 0.0 if system.centred else y_1
    squares = np.array([y_2 - off**2, v_2, a_2])
    fourth = y_4 - 4 * off * y_3 + 6 * off**2 * y_2 - 3 * off**4
    each_v, each_a, _, each_y, each_y_2, *_ = of_each
    rms = np.sqrt(squares)
    margins = student * np.std([each_y_2 - 2 * off * each_y, each_v, each_a], axis=1, ddof=1) / (2 * rms)
    B_margin = 0.0 if system.centred else student * np.std(each_y, ddof=1)
    fraction = math.nan if math.isinf(below) and math.isinf(above) else beyond
    averaged = fraction, fourth / squares[0] ** 2, records * each * step
    return tuple(map(float, (near + off, *rms, B_margin, *margins, *averaged)))


def steps(excitation: Excitation, k: float, c: Floats) -> tuple[float, float]:
    """The time between samples, and the highest frequency of the record, infinite of white noise."""
    if isinstance(excitation, White):
        return min(FRACTION / math.sqrt(k), DAMPED / float(c.max())), math.inf
    Omega = np.geomspace(excitation.Omega[0], excitation.Omega[-1], GRID)
    Z, _, _ = linearization.response(Omega, k, float(c[-1]))
    power = np.gradient(Omega) * excitation.density(Omega) * Omega**2 / Z
    passed = np.cumsum(power[::-1])[::-1]
    top = float(Omega[passed >= LEFT_OUT * passed[0]][-1])
    return min(FRACTION / math.sqrt(k), SAMPLED / top), top


def process(excitation: Excitation, step: float, top: float, count: int, random: np.random.Generator) -> Floats:
    """Samples of the excitation, (count + 1,): straight between these it has its spectrum up to the frequency `top`."""
    if isinstance(excitation, White):
        return random.normal(0.0, math.sqrt(2 * math.pi * excitation.S_0 / step), count + 1)
    size = 2 ** math.ceil(math.log2(count + 1))
    Omega = 2 * math.pi * np.arange(1, size // 2 + 1) / (size * step)
    density = np.where(Omega <= top, excitation.density(Omega), 0.0)
    # the straight lines between samples have sinc^2 of it
    amplitude = np.sqrt(density * Omega[0]) / np.sinc(0.5 * Omega * step / math.pi) ** 2
    terms = np.zeros(size // 2 + 1, dtype=complex)
    terms[1:] = 0.5 * size * amplitude * (random.normal(size=Omega.size) + 1j * random.normal(size=Omega.size))
    return np.fft.irfft(terms, size)[: count + 1]


def followed(system: EquationOfMotion, w: Floats, step: float, u: float = 0.0) -> Floats:
    """u and v at the end of each step, from rest at u, (2, n). Raises ArithmeticError where it is lost."""
    oscillator, v, pieces = handle(system), 0.0, []
    for first in range(0, w.size - 1, AT_ONCE):
        some = w[first : first + AT_ONCE + 1]
        # w pushes as a base does that is accelerated by -w
        arcs = arcs_of(step * np.arange(float(some.size)), -some)
        arguments = np.ascontiguousarray(arcs), u, v, MOST_STEPS, STEPS * some.size
        outcome, _, at, states = EXACT.record(oscillator, *arguments)
        if outcome:
            raise NotSettled(lost(outcome, system, at))
        pieces.append(np.frombuffer(states).reshape(-1, 2))
        u, v = pieces[-1][-1].tolist()
    return np.concatenate(pieces).T


def accelerations(system: EquationOfMotion, u: Floats, v: Floats, w: Floats) -> Any:
    """Of the mass as seen by who stands still, where the base is what pushes: it goes with the base where it sticks."""
    return np.where(v == 0, w, system.force(u) - system.load + damping_force(system, u, v))
