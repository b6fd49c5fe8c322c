"""Whether the equation of motion has anything near a resonant averaged state, by the energy of exact free motions.

In:  slow flows, and steady states (Omega, A) of first-order averaging.
Out: which states are unsustained: no free motion nearby loses as little energy per cycle as the excitation can supply.

Averaging takes a motion for harmonic. Next to the top of a well, where the force vanishes and turns, it is not: the
free motion of the undamped equation u'' + f(u) = 0 becomes slow and flat there, and beyond it there is none about the
centre. Of the free motion of amplitude a let omega be the frequency, J the integral of u'^2 over a cycle, A_1 the first
harmonic. At omega a force of amplitude F supplies at most pi A_1 F per cycle, and viscous damping takes 2 zeta J: that
of a harmonic motion of amplitude a at the mean frequency J/(pi a^2). So what sustains the motion is F >= (a/A_1) I,
with I the sine balance (23) at that frequency; away from omega the cosine balance a (Omega^2 - omega^2) is added.
"""

from __future__ import annotations

from functools import partial
from operator import itemgetter
from typing import Any

import numpy as np

from slowflow.core.mechanism import Flags, Floats, Mechanism, by_piece
from slowflow.core.model import SlowFlow
from slowflow_kernels import slow_flow

#: how far from a state, relative in amplitude and in frequency, a motion that is sustained counts as near it; the
#: averaged folds of wells that are right to this are no artefacts (tests/averaged/test_sustained.py: what it detects)
AMPLITUDES, FREQUENCIES = 0.2, 0.05

#: of the excitation, what damping takes at least where a state is resonant; the free motion says nothing of others
RESONANT = 0.8

#: a force that changes its sign within this factor of an amplitude has free motions there that are far from harmonic
WITHIN = 2.0

#: places where the force's sign is looked at, amplitudes of free motions, and cells of a quarter of their cycle
SIGNS, MOTIONS, CELLS = 32, 96, 48

#: designs whose free motions are computed at once, some megabytes
AT_ONCE = 64


def _column(number: Any, size: int) -> Floats:
    """A number of designs with a row for each of so many; what is one for all is spread."""
    rows = np.reshape(number, (-1, 1))
    return rows if len(rows) == size else np.broadcast_to(rows, (size, 1))


def unsustained(flow: SlowFlow, Omega: Any, A: Any) -> Flags:
    """Which states (Omega, A) about u = 0 are resonant in averaging, and have no sustained motion near them.

    Omega, A -- of each design along the last axis; NaN is no state
    flow     -- of the designs, numbers with a last axis of length 1; or of one
    """
    mechanism, shape = flow.mechanism, np.shape(A)
    if not np.size(A):
        return np.zeros(shape, dtype=bool)
    A, Omega = (np.broadcast_to(value, shape).reshape(-1, shape[-1]) for value in (A, Omega))
    found = np.zeros(A.shape, dtype=bool)
    if not mechanism.odd:
        return found.reshape(shape)
    column = partial(_column, size=len(A))
    parameters = tuple(map(column, flow.parameters))
    with np.errstate(all="ignore"):  # amplitudes of any size, and none
        positions = WITHIN * np.fmax.reduce(A, axis=-1, keepdims=True) * (np.arange(1, SIGNS + 1) / SIGNS)
        # a state is looked at from half the amplitude on at which the force has changed its sign: beyond the reach too,
        # which may be the very top of the well
        force = by_piece(mechanism.pieces, mechanism.breakpoints(*parameters), positions, parameters)
        turned = (force < 0) & _pulls_back(mechanism, parameters)
        first = np.where(turned, positions, np.inf).min(axis=-1, keepdims=True) / WITHIN
        may = np.flatnonzero((A >= first).any(axis=-1))
        for some in (may[begin : begin + AT_ONCE] for begin in range(0, len(may), AT_ONCE)):
            near = A[some] >= first[some]
            found[some] = _unsustained(flow.each(column).each(itemgetter(some)), Omega[some], A[some], near)
    return found.reshape(shape)


def _pulls_back(mechanism: Mechanism, parameters: tuple[Any, ...]) -> Flags:
    """Whether u = 0 is the bottom of a well: between two wells damped motions exist that are far from free ones."""
    h, h_A, *_ = mechanism.at_rest(*parameters)
    return np.asarray((np.asarray(h) <= 0) & (np.asarray(h_A) < 0))


def _unsustained(flow: SlowFlow, Omega: Floats, A: Floats, selected: Flags) -> Flags:
    """The same of some designs, along the first axis, and of the selected states."""
    takes = flow.sine(Omega, A)
    level = slow_flow.level(Omega, A, takes, 0.0, flow.averaged(A)[0])
    selected = selected & (takes >= RESONANT * level)
    found = np.zeros(A.shape, dtype=bool)
    if not selected.any():
        return found
    own = np.where(selected, A, np.nan)
    low, high = np.fmin.reduce(own, axis=-1), np.fmax.reduce(own, axis=-1)
    a = np.geomspace((1 - AMPLITUDES) * low, (1 + AMPLITUDES) * high, MOTIONS, axis=-1)
    omega, J, A_1 = free_motions(flow.mechanism, flow.parameters, a)
    row, place = np.nonzero(selected)
    A, Omega, level = (values[row, place][:, np.newaxis] for values in (A, Omega, level))
    a, omega, J, A_1 = (values[row] for values in (a, omega, J, A_1))
    nearby = np.clip(omega, (1 - FREQUENCIES) * Omega, (1 + FREQUENCIES) * Omega)
    mean = J / (np.pi * a * a) * nearby / omega
    sine = flow.each(itemgetter(row)).sine(mean, a)
    needed = np.hypot(a * (nearby**2 - omega**2), a / A_1 * sine)
    available = level * (nearby / Omega) ** 2 if flow.inertial else level
    found[row, place] = ~((needed <= available) & (np.abs(a / A - 1) <= AMPLITUDES)).any(axis=-1)
    return found


def free_motions(mechanism: Mechanism, parameters: tuple[Any, ...], a: Floats) -> tuple[Floats, Floats, Floats]:
    """omega, J and A_1 of the free undamped motions about u = 0 of amplitudes a; NaN where there is none.

    By midpoints over the angle theta of u = a sin theta, which takes the singularity at the turning point away.

    a          -- of any shape; the parameters broadcast with it
    """
    edges = np.linspace(0.0, np.pi / 2, CELLS + 1)
    middles = (edges[1:] + edges[:-1]) / 2
    a = a[..., np.newaxis]
    u, ends = a * np.sin(middles), a * np.sin(edges[1:])
    own = tuple(np.asarray(value)[..., np.newaxis] for value in parameters)
    f = by_piece(mechanism.pieces, mechanism.breakpoints(*own), u, own)
    cells = f * np.diff(a * np.sin(edges), axis=-1)
    # u'^2/2 is the work of the force from u to a: that of the cells beyond, and of the rest of its own
    work = np.cumsum(cells[..., ::-1], axis=-1)[..., ::-1] - cells + f * (ends - u)
    speed = np.sqrt(2 * np.where((work > 0).all(axis=-1, keepdims=True), work, np.nan))
    time = a * np.cos(middles) / speed * (np.pi / 2 / CELLS)
    quarter = time.sum(axis=-1, keepdims=True)
    omega = np.pi / 2 / quarter
    J = 4 * (speed**2 * time).sum(axis=-1)
    A_1 = 2 * (u * np.sin(omega * (np.cumsum(time, axis=-1) - time / 2)) * time).sum(axis=-1) / quarter[..., 0]
    return omega[..., 0], J, A_1
