"""White noise by averages over cycles of one energy. Takes a force and its damping; returns means over all motions.

u and v have the density exp(-P)/N, where P is a function of the energy and rises with it by `linearization.energy_loss`
(`derivations/extensions/linearization.py`). A cycle of the amplitude a has the velocity v^2 = 2 int_u^a f(u) du, and

    J_X = int X |v| |du|,   L_Y = int Y/|v| |du|

The time that it is where X = 1 is dJ_X/dE, which has no bound where the force jumps. By parts there is none of it, for
X of u alone; Y that vanish with v, as v^2 and what r^2 is more than at v = 0, need no such step:

    N = int J_1 exp(-P) dP,   N E[X] = int J_X exp(-P) dP,   N E[Y] = int L_Y exp(-P) dE
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.polynomial import legendre

from slowflow.core.mechanism import EquationOfMotion, Floats, Piece
from slowflow.support.errors import NotSettled
from slowflow.support.text import Sentence
from slowflow_kernels import linearization, motion

#: nodes of Gauss's rule in a piece of the force, and in a panel of amplitudes
NODES = 20
#: P from which on motions are left out; most panels of amplitudes up to there
FARTHEST, MOST_PANELS = 50.0, 1000
PUSHES_AWAY = Sentence(
    "stochastic averaging of the energy is not available: near {u = :.4g} the spring pushes away from the centre"
)
GIVES_WAY = "stochastic averaging of the energy is not available: the spring is too weak to hold the mass"

_at, _weights = legendre.leggauss(NODES)
_inverse = np.linalg.inv(legendre.legvander(_at, NODES - 1))
#: of the rule on (0, 1): nodes, weights, and the integrals from 0 to each node
AT, WEIGHTS = 0.5 * (1 + _at), 0.5 * _weights
UP_TO = 0.5 * legendre.legvander(_at, NODES) @ legendre.legint(_inverse, lbnd=-1)


def averages(system: EquationOfMotion, S_0: float, scale: float) -> Floats:
    """Means of u^2, v^2, a^2, of whether |u| is beyond the first piece, and of u^4.

    scale -- of displacements

    Raises ArithmeticError where the spring pushes away from the centre or is too weak to hold the mass.
    """
    first = system.force.innermost
    pieces, ends = system.force.pieces[first:], (0.0, *system.force.breakpoints[first:], math.inf)
    P, of_u, of_v = 0.0, np.zeros(5), np.zeros(2)
    for number, begin, end in _panels(ends, scale):
        # next to a breakpoint what follows changes as a power of the square root of what is beyond it
        s = begin + (end - begin) * AT
        a = ends[number] + scale * s * s
        f = pieces[number](a)
        if not (f >= 0).all():
            raise NotSettled(PUSHES_AWAY.format(a[~(f >= 0)][0]))
        if not f.any():  # within a dead zone the energy is 0
            continue
        dE = f * 2 * scale * s * (end - begin)
        J, (lost, more) = _cycles(system, pieces[: number + 1], ends, a)
        dP = linearization.energy_loss(J[0], lost, S_0) * dE
        weights = WEIGHTS * np.exp(-P - UP_TO @ dP)
        of_u += J @ (weights * dP)
        of_v += np.array([J[0], more]) @ (weights * dE)
        P += WEIGHTS @ dP
        if P > FARTHEST:
            break
    else:
        raise NotSettled(GIVES_WAY)
    v_2, more = of_v / of_u[0]
    square, of_force, beyond, fourth = of_u[1:] / of_u[0]
    at_rest = system.mu**2 * (1 - beyond if system.released else 1)
    return np.array([square, v_2, of_force + at_rest + more, beyond, fourth])


def damping_force(system: EquationOfMotion, u: Floats, v: Floats) -> Floats:
    """What resists a velocity, of numbers whose shapes are one."""
    sign, laws = np.sign(v), (system.c_3, system.zeta_2)
    end = system.force.first_end
    acts = True if end is None or not system.released else np.abs(u) <= end
    resists, _, _ = motion.resistance(v, system.zeta, system.mu * acts * sign, system.c_2 * sign, *laws, u)
    return np.asarray(-motion.acceleration(0.0, v, 0.0, system.zeta, resists, 0.0))


def _panels(ends: Sequence[float], scale: float) -> Iterator[tuple[int, float, float]]:
    """Of the amplitudes beyond an end, by its number and sqrt((a - end)/scale)."""
    for number, (low, high) in enumerate(itertools.pairwise(ends)):
        most = min(math.sqrt((high - low) / scale), MOST_PANELS)
        edges = np.linspace(0.0, most, 1 + math.ceil(most)).tolist()
        yield from ((number, *panel) for panel in itertools.pairwise(edges))


def _cycles(
    system: EquationOfMotion, pieces: Sequence[Piece], ends: Sequence[float], a: Floats
) -> tuple[Floats, Floats]:
    """J_X of 1, u^2, f^2, whether u is beyond the first piece, and u^4; L_Y of v r, and of r^2 less that at v = 0."""
    L, J, square, top = np.zeros((2, a.size)), np.zeros((5, a.size)), np.zeros((a.size, 1)), a[:, np.newaxis]
    for number in reversed(range(len(pieces))):
        # next to a turning point v is the root of what is left
        width = top - ends[number]
        u, du = top - width * AT**2, 2 * width * AT
        f = pieces[number](u)
        v = np.sqrt(square + 2 * (f * du) @ UP_TO.T)
        weights = 4 * du * WEIGHTS
        r, friction = damping_force(system, u, v), 0.0 if system.released and number else system.mu
        L += (weights * np.array([r, (r - friction) * (r + friction) / v])).sum(axis=2)
        of_u = np.array([np.ones(u.shape), u**2, f**2, np.full(u.shape, number > 0), u**4])
        J += (weights * v * of_u).sum(axis=2)
        square, top = square + 2 * (f * du) @ WEIGHTS[:, np.newaxis], np.full_like(top, ends[number])
    return J, L
