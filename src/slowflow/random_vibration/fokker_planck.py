"""The stationary density of u and v under white noise. Takes a force and its damping; returns means over all motions.

The density p solves the Fokker-Planck equation of (3), with f less the load, for any damping force r:

    v p_u = d/dv [(f + r) p + D p_v],   D = pi S_0

For p = w q and w = exp(-int s dv/D), with a damping force s of v alone (`derivations/extensions/linearization.py`),

    v w q_u = d/dv (w [(f + r - s) q + D q_v])

Along v, q is a polynomial on either side of v = 0, where friction makes p_v jump (Galerkin); its integrals are those of
Gauss's rule for the weight w with a node at v = 0 (Radau), whose equation has no slope by u and yields q there. Along u
the equation is solved at Gauss's points of panels without a breakpoint within (collocation). At both ends, beyond all
motions, and at the centre of a symmetric motion, p has the same value at v and at -v.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import replace

import numpy as np
from numpy.polynomial import legendre

from slowflow.core.mechanism import EquationOfMotion, Floats
from slowflow.support.errors import NotSettled
from slowflow.support.quadrature import gauss
from slowflow_kernels import motion

#: -ln w from which on velocities are left out, and displacements of the same energy; up to so many root mean squares
FARTHEST, MOST_FAR = 45.0, 1e4
#: nodes on either side of v = 0, and panels to a root mean square of u, of each attempt; until two agree to a share
ATTEMPTS, AGREE = ((8, 2), (12, 3), (16, 4), (24, 6), (32, 8)), 1e-4
#: Gauss's points of a panel, and most panels on one side
POINTS, MOST_PANELS = 4, 1000
#: panels of velocities, and nodes in each, for integrals over w
FINE, NODES = 12, 40
GIVES_WAY = (
    "no stationary density is found: the spring or the damping is too weak to hold the mass, or the wells of the "
    "spring are too deep to leave"
)
UNSETTLED = "the stationary density is not resolved: root mean squares still change by more than 0.01 % with more nodes"

#: nodes and weights of a panel on (0, 1); to values and slopes there from values at both ends and between them
AT, WEIGHTS = gauss(POINTS)
_coefficients = np.linalg.inv(legendre.legvander(-np.cos(np.pi * np.arange(POINTS + 1) / POINTS), POINTS))
VALUES = legendre.legvander(2 * AT - 1, POINTS) @ _coefficients
SLOPES = 2 * legendre.legvander(2 * AT - 1, POINTS - 1) @ legendre.legder(_coefficients)


def averages(system: EquationOfMotion, S_0: float, B: float, u_rms: float, v_rms: float, beyond: float) -> Floats:
    """B, the mean of u; means of (u - B)^2, v^2, a^2 and of whether u is beyond the first piece; kurtosis of u.

    B, u_rms, v_rms, beyond -- of an equivalent linear oscillator, for scales

    Raises ArithmeticError where spring or damping is too weak to hold the mass, and where the means are not resolved.
    """
    D, friction = math.pi * S_0, system.mu * (1 - beyond if system.released else 1)
    reference = replace(system, mu=friction, zeta=system.zeta + system.zeta_2 * u_rms**2, zeta_2=0.0, released=False)
    far = _farthest(reference, D, v_rms)
    before = np.full(4, math.nan)
    for nodes, panels in ATTEMPTS:
        ends = _panels(system, B, u_rms / panels, 2 * v_rms**2 / panels, 0.5 * far**2)
        found = _means(system, reference, D, ends, _velocities(reference, D, far, nodes))
        # mean squares may come out negative where nodes are too few
        scale = np.append(math.sqrt(abs(found[1])), 2 * found[1:4])
        if (np.abs(found[:4] - before) <= AGREE * scale).all():
            return found
        before = found[:4]
    raise NotSettled(UNSETTLED)


def damping_force(system: EquationOfMotion, u: Floats, v: Floats) -> Floats:
    """What resists a velocity, of numbers whose shapes are one."""
    sign, laws = np.sign(v), (system.c_3, system.zeta_2)
    end = system.force.first_end
    acts = True if end is None or not system.released else np.abs(u) <= end
    resists, _, _ = motion.resistance(v, system.zeta, system.mu * acts * sign, system.c_2 * sign, *laws, u)
    return np.asarray(-motion.acceleration(0.0, v, 0.0, system.zeta, resists, 0.0))


def _less_log_w(reference: EquationOfMotion, D: float, v: Floats) -> Floats:
    """-ln w at v > 0, (n,), exactly, as the damping force is a polynomial of degree 3 there."""
    up_to = v[:, np.newaxis] * AT
    return np.asarray(v * (damping_force(reference, np.zeros(up_to.shape), up_to) @ WEIGHTS) / D)


def _farthest(reference: EquationOfMotion, D: float, v_rms: float) -> float:
    v = np.asarray(v_rms * 1.2 ** np.arange(math.ceil(math.log(MOST_FAR, 1.2))))
    left_out = v[_less_log_w(reference, D, v) > FARTHEST]
    if not left_out.size:
        raise NotSettled(GIVES_WAY)
    return float(left_out[0])


def _panels(system: EquationOfMotion, B: float, width: float, rise: float, energy: float) -> Floats:
    """Ends of panels up to where the potential is higher by `energy` on both sides of B, or on one side of the centre.

    width, rise -- of a panel, and of the energy within it, at most, or half of what it has risen by before
    """
    edges, sides = np.array(system.force.edges), []
    for side in (1.0,) if system.centred else (-1.0, 1.0):
        ends, potential, least = [B], 0.0, 0.0
        while potential - least < energy:
            ahead = side * (edges - ends[-1])
            step = min(width, ahead[ahead > 0].min(initial=math.inf))
            most = rise + 0.5 * (potential - least)
            while step * abs(system.force(np.array([ends[-1] + side * step]))[0] - system.load) > most:
                step *= 0.5
            potential += side * step * float((system.force(ends[-1] + side * step * AT) - system.load) @ WEIGHTS)
            least = min(least, potential)
            ends.append(ends[-1] + side * step)
            if len(ends) > MOST_PANELS:
                raise NotSettled(GIVES_WAY)
        sides.append(ends)
    return np.unique(np.concatenate(sides))


def _velocities(reference: EquationOfMotion, D: float, far: float, n: int) -> tuple[Floats, Floats, Floats, Floats]:
    """Nodes v, with v = 0 on either side, and weights, (2 n + 2,); matrices to values and slopes from 2 n + 1 values.

    Polynomials orthogonal under w have coefficients that are integrals (Stieltjes), whose matrix has the nodes as
    eigenvalues (Golub and Welsch), with its last element such that one of these is 0.
    """
    at, weights = gauss(NODES)
    v = far / FINE * (np.arange(FINE)[:, np.newaxis] + at).ravel()
    w = np.tile(weights, FINE) * np.exp(-_less_log_w(reference, D, v))
    p, before, norm = np.full(v.size, 1 / math.sqrt(w.sum())), np.zeros(v.size), 0.0
    J = np.zeros((n + 1, n + 1))
    for k in range(n):
        J[k, k] = w @ (v * p**2)
        p, before = (v - J[k, k]) * p - norm * before, p
        norm = math.sqrt(w @ p**2)
        p /= norm
        J[k, k + 1] = J[k + 1, k] = norm
    J[n, n] = norm**2 * np.linalg.inv(J[:n, :n])[-1, -1]
    nodes, vectors = np.linalg.eigh(J)
    nodes[0] = 0.0
    apart = nodes[:, np.newaxis] - nodes + np.eye(n + 1)
    products = np.prod(apart / nodes[-1], axis=1)
    slope = products[:, np.newaxis] / (products * apart)
    np.fill_diagonal(slope, 0.0)
    np.fill_diagonal(slope, -slope.sum(axis=1))
    nodes[0], weights = np.nextafter(0.0, 1.0), vectors[0] ** 2  # v = 0 keeps the sign of its side
    values, slopes = np.eye(2 * n + 1)[[*range(n + 1), *range(n, 2 * n + 1)]], np.zeros((2 * n + 2, 2 * n + 1))
    slopes[: n + 1, : n + 1], slopes[n + 1 :, n:] = -slope[::-1, ::-1], slope
    return np.append(-nodes[::-1], nodes), np.append(weights[::-1], weights), values, slopes


def _means(
    system: EquationOfMotion, reference: EquationOfMotion, D: float, ends: Floats, along_v: tuple[Floats, ...]
) -> Floats:
    """See `averages`; ends: of panels, along_v: what `_velocities` returns."""
    v, weights, values, slopes = along_v
    n, widths = v.size // 2 - 1, np.diff(ends)
    points = ends[:-1, np.newaxis] + widths[:, np.newaxis] * AT
    u, v = np.broadcast_arrays(points[..., np.newaxis], v)
    f, r = system.force(u) - system.load, damping_force(system, u, v)
    A = (slopes.T * weights) @ ((f + r - damping_force(reference, u, v))[..., np.newaxis] * values + D * slopes)
    # the equation at v = 0 yields q there from the others
    moving = np.delete(np.arange(2 * n + 1), n)
    at_0 = -A[..., n, moving] / A[..., n, n, np.newaxis]
    A = A[..., moving[:, np.newaxis], moving] + A[..., moving, n, np.newaxis] * at_0[..., np.newaxis, :]
    inertia = values.T @ (v[0, 0] * weights)
    q = _solved(A, inertia[moving], widths, f[..., 0])
    q = np.insert(q, n, (at_0 * q).sum(axis=-1), axis=-1)
    p = (q @ values.T) * weights * (widths[:, np.newaxis] * WEIGHTS)[..., np.newaxis]
    p /= p.sum()
    B = 0.0 if system.centred else float((p * u).sum())
    below, above = system.force.first_ends
    squares = [(p * of**2).sum() for of in (u - B, v, f + r)]
    beyond = (p * ((u < below) | (u > above))).sum()
    return np.array([B, *squares, beyond, (p * ((u - B) ** 2 / squares[0]) ** 2).sum()])


def _solved(A: Floats, inertia: Floats, widths: Floats, f: Floats) -> Floats:
    """Solution, but for a factor, of inertia q_u + A q = 0 at the points of panels, (panels, points, velocities).

    f -- at the points
    """
    from scipy.sparse import csc_matrix  # only this answer needs it
    from scipy.sparse.linalg import MatrixRankWarning, spsolve

    size = inertia.size
    terms = np.einsum("gj,pgab->pgajb", VALUES, A)
    terms += np.einsum("p,gj,ab->pgajb", 1 / widths, SLOPES, np.diag(inertia))
    nodes = POINTS * np.arange(widths.size)[:, np.newaxis] + np.arange(POINTS + 1)
    columns = size * nodes[:, np.newaxis, np.newaxis, :, np.newaxis] + np.arange(size)
    rows = np.arange(terms[..., 0, 0].size).reshape(*terms.shape[:3], 1, 1)
    # at both ends q is the same at v and -v; one of these equations, of the least v, follows from all others, as no
    # probability is lost, and gives way to one for the factor: the sum of q where the potential is least
    last, pairs = rows.size, np.arange(size // 2)[:, np.newaxis]
    mirrored = np.eye(size // 2, size) - np.eye(size // 2, size)[:, ::-1]
    instead = mirrored * (pairs < size // 2 - 1)
    least = size * POINTS * int(np.argmin(np.cumsum(f @ WEIGHTS * widths)))
    blocks = (
        (terms, rows, columns),
        (instead, last + pairs, np.arange(size)),
        (np.ones(size), np.array([last + size // 2 - 1]), least + np.arange(size)),
        (mirrored, last + size // 2 + pairs, last + np.arange(size)),
    )
    flat = zip(*(map(np.ravel, np.broadcast_arrays(*block)) for block in blocks), strict=True)
    entries, at_rows, at_columns = map(np.concatenate, flat)
    matrix = csc_matrix((entries, (at_rows, at_columns)), shape=(last + size, last + size))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", MatrixRankWarning)  # all is NaN then, and no two attempts agree
        q = spsolve(matrix, np.eye(1, last + size, last + size // 2 - 1)[0]).reshape(-1, size)
    return np.asarray(VALUES @ q[nodes])
