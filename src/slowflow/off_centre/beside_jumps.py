"""States next to a jump of the force: in goes what boxes leave undecided there, out come the states there.

Where a motion just passes a jump, f_0 and F go as the root of how far: no box in A and B is narrow enough for their
slopes. On either side alone they are smooth: of motions that do not reach it without the step, of others in its angle.
"""

from __future__ import annotations

import numpy as np

from slowflow.averaged.reference.intervals import Bools
from slowflow.model import Floats
from slowflow.off_centre.boxes import NARROW, Solutions, solve
from slowflow.off_centre.equations import Past, State

#: angle up to which a motion just passes a step; how far from the edge of a region what is inside is told
JUST, ROUNDED = 0.1, 2.0**-48


def decided(found: Solutions, state: State) -> Solutions:
    """The same solutions of `state` with those next to jumps, as far as they are decided in this way."""
    for system in np.unique(found.undecided_of):
        here = found.undecided_of == system
        known = _beside(found.undecided[:, here], state, int(system)) if state.steps.jumps else None
        if known is None:
            continue
        x, low, high = known
        kept = (found.of != system) | ~_inside(found.x, low, high)
        found = Solutions(
            np.concatenate((found.x[:, kept], x), axis=1),
            np.concatenate((found.of[kept], np.full(x.shape[1], system))),
            found.undecided[:, ~here],
            found.undecided_of[~here],
        )
    order = np.lexsort((*found.x[::-1], found.of))
    return Solutions(found.x[:, order], found.of[order], found.undecided, found.undecided_of)


def _beside(open_: Floats, state: State, system: int) -> tuple[Floats, Floats, Floats] | None:
    """All states in a region that holds boxes, and its lower and upper corner; None where they are not next to a jump.

    open_ -- the centres of the boxes (2, n)
    """
    steps = state.steps
    margin = 4 * NARROW * np.maximum(np.abs(open_).max(axis=1), 1.0)
    low, high = open_.min(axis=1) - margin, open_.max(axis=1) + margin
    step = min(steps.jumps, key=lambda j: float(np.abs(_beyond(open_, state, j)).max()))
    side = float(steps.sides[step])
    most = high[0] + max(side * low[1], side * high[1]) - float(steps.places[step])
    # A (1 - cos psi) = 2 A sin(psi/2)^2 is how far it is passed
    share = np.sqrt(max(most, 0.0) / (2 * low[0])) if low[0] > 0 else 1.0
    if share > JUST / 2:
        return None
    angle = 2 * np.arcsin(share) * (1 + 2.0**-40)
    of = np.array([system])
    without = State(steps.touching(step), state.m, state.zeta, state.Omega, state.F_0)
    short = solve(without, low[:, np.newaxis], high[:, np.newaxis], of)
    equations = Past(state, step)
    past = solve(equations, np.array([[0.0], [low[0]]]), np.array([[angle], [high[0]]]), of)
    if short.undecided_of.size or past.undecided_of.size:
        return None
    psi, A = past.x
    beyond = np.concatenate((-_beyond(short.x, state, step), psi))
    x = np.concatenate((short.x, [A, equations.offset(psi, A)]), axis=1)
    inside, certain = _inside(x, low, high), _inside(x, low + ROUNDED, high - ROUNDED)
    if (inside & ~certain).any() or (np.abs(beyond[inside]) < ROUNDED).any():
        return None
    return x[:, inside & (beyond > 0)], low, high


def _beyond(x: Floats, state: State, step: int) -> Floats:
    """How far motions pass a step."""
    return np.asarray(x[0] + state.steps.sides[step] * x[1] - state.steps.places[step])


def _inside(x: Floats, low: Floats, high: Floats) -> Bools:
    """Which points are in a box."""
    return np.asarray(((x >= low[:, np.newaxis]) & (x <= high[:, np.newaxis])).all(axis=0))
