"""How root mean squares move with the parameters. Takes motions of statistical linearization; returns their gradient.

By the implicit function theorem, from what holds of them with p = ln k and q = ln c:

    ln I_0(p, q) - 2 ln sigma_u = 0,  p = ln(E[u f]/sigma_u^2)     ln I_2(p, q) - 2 ln sigma_v = 0,  q = ln C(sigma_v)

and E[f] = load, where the mean B of u is not 0 and p has u - B.

Slopes of averages are imaginary parts at complex parameters next to the real ones, from which nothing cancels.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np

from slowflow.answers.gradient import Gradient
from slowflow.answers.sensitivities import OF_FUNCTIONS, OF_RECORD
from slowflow.core import validate
from slowflow.core.mechanism import EquationOfMotion
from slowflow.random_vibration.excitation import IMAGINARY
from slowflow.support.quadrature import gauss
from slowflow_kernels import linearization
from slowflow_kernels.conventions import GradientStatus

#: of `EquationOfMotion`
LAWS = "mu", "zeta", "c_2", "c_3", "zeta_2"
#: u/sigma up to which averages reach
FARTHEST = 12.0
#: of Gauss's rule for a panel of displacements
AT, WEIGHTS = gauss(20)
#: a determinant below which two motions are one, that of two motions far apart being some units
SINGULAR = 1e-12


def gradient(found: Any, system: EquationOfMotion, oscillator: Any) -> Gradient:
    """See `RandomResponse.gradient`."""
    model = oscillator.model
    mechanism, names = model.mechanism, model.mechanism.design_names
    if mechanism.by_design is None:
        raise validate.NotAvailable((OF_FUNCTIONS if mechanism.told else OF_RECORD).format(mechanism.name))
    others = [name for name in LAWS[2:] if getattr(system, name) > 0]
    present, offset = [*LAWS[:2], *others], not system.centred
    laws = tuple(getattr(system, name) for name in present)
    excitation = found.excitation
    by = (*names, *present, *("load",) * offset, *excitation.numbers)
    parameters, ends = model.parameters, np.array(mechanism.breakpoints(*model.parameters), dtype=float)
    # of each parameter, then of each breakpoint, by each number of the design
    by_design = np.array(mechanism.by_design(*model.design), dtype=float).reshape(-1, len(names))
    own = 2 + offset  # unknowns: sigma_u and sigma_v, relative, and B over sigma_u
    count, size = own + len(names), own + len(names) + len(laws) + offset
    slopes = np.empty((len(found), 3 + offset, len(by)))
    status = np.full(len(found), GradientStatus.OK, np.int8)
    for row, (B, u, v) in enumerate(zip(found.B, found.u_rms, found.v_rms, strict=True)):

        def at(step: Any, B: float = B, u: float = u, v: float = v) -> Any:
            shifts = by_design @ step[own:count]
            shifted = np.array(parameters) + shifts[: len(parameters)]
            edges = ends + shifts[len(parameters) :]
            edges = edges[ends > 0] if system.force.odd else edges
            shifts_of_laws = step[count : size - offset]
            resists = {name: one + change for name, one, change in zip(present, laws, shifts_of_laws, strict=True)}
            motion = B + u * (step[2] if offset else 0), u * (1 + step[0]), v * (1 + step[1])
            return _state(system, shifted, edges, resists, system.load + (step[-1] if offset else 0), *motion)

        by_all = np.array([at(1j * IMAGINARY * one).imag / IMAGINARY for one in np.eye(size)]).T
        k, c = float(found.stiffness[row]), float(found.damping[row])
        by_p_q, by_excitation = excitation.slopes(k, c), excitation.by_numbers(k, c)
        matrix = np.concatenate((2 * np.eye(2, own) - by_p_q @ by_all[:2, :own], by_all[3:, :own] / (k * u)))
        if not abs(np.linalg.det(matrix)) > SINGULAR:
            status[row], slopes[row] = GradientStatus.MEETS, math.nan
            continue
        others_by = np.concatenate((by_p_q @ by_all[:2, own:], -by_all[3:, own:] / (k * u)))
        of_moments = np.pad(by_excitation, ((0, int(offset)), (0, 0)))
        relative = np.linalg.solve(matrix, np.concatenate((others_by, of_moments), axis=1))
        of_a = by_all[2, :own] @ relative + np.append(by_all[2, own:], np.zeros(len(excitation.numbers)))
        slopes[row] = [u * relative[0], v * relative[1], of_a / (2 * found.a_rms[row]), *u * relative[2:]]
    values = found.u_rms, found.v_rms, found.a_rms, *(found.B,) * offset
    of = ("u_rms", "v_rms", "a_rms", *("B",) * offset)
    at_numbers = (*model.design, *laws, *(system.load,) * offset, *excitation.numbers.values())
    return Gradient(of, by, slopes, status, values, at_numbers)


def _pieces(system: EquationOfMotion, ends: Any, reach: tuple[float, float]) -> tuple[Any, Any]:
    """Pieces of the force and their edges, within a reach: about the centre those for u > 0."""
    pieces = system.force.pieces[system.force.innermost :]
    if system.centred:
        return pieces, (0.0, *ends, reach[1])
    if system.force.odd:
        jumps = system.force.innermost  # then there is an edge at u = 0
        mirrored = pieces[::-1] if jumps else pieces[:0:-1]
        return mirrored + pieces, (reach[0], *(-end for end in reversed(ends)), *(0.0,) * jumps, *ends, reach[1])
    return pieces, (reach[0], *ends, reach[1])


def _state(
    system: EquationOfMotion, parameters: Any, ends: Any, laws: dict[str, Any], load: Any, B: Any, u: Any, v: Any
) -> Any:
    """ln k, ln c and E[a^2], and off the centre E[f] - load, of complex numbers."""
    means = np.zeros(4, complex)
    within: Any = 1.0
    reach = B.real - FARTHEST * u.real, B.real + FARTHEST * u.real
    pieces, edges = _pieces(system, ends, reach)
    for piece, (low, high) in zip(pieces, itertools.pairwise(edges), strict=True):

        def integrand(x: Any, law: Any = piece.law) -> Any:
            f, y = law.force(x, *parameters) - load, x - B
            density = np.exp(-0.5 * (y / u) ** 2) * math.sqrt((2 if system.centred else 0.5) / math.pi) / u
            return np.array([y * f, f * f, np.ones_like(x), f]) * density

        low, high = (min(max(end, reach[0], key=np.real), reach[1], key=np.real) for end in (low, high))
        width = high.real - low.real
        if width <= 0:
            continue
        count = math.ceil(width / u.real)
        x = low.real + width * ((np.arange(count)[:, np.newaxis] + AT) / count).ravel()
        means += integrand(x) @ np.tile(WEIGHTS * width / count, count)
        # laws are of real displacements: what moves with an end is the integrand there (Leibniz)
        for end, sign in ((low, -1), (high, 1)):
            if end.imag:
                means += sign * 1j * end.imag * integrand(end.real)
        if system.released and low == 0:
            within = means[2]
    level = min(edges[1] / u, FARTHEST, key=np.real) if system.released else FARTHEST
    mu, zeta, c_2, c_3, zeta_2 = (laws.get(name, 0.0) for name in LAWS)
    friction, viscous, _, _ = linearization.over_displacements(level, within, u, mu, zeta, zeta_2)
    c, _, _ = linearization.equivalent_damping(v, friction, viscous, c_2, c_3)
    of_a = means[1] + linearization.damping_force(level, within, u, v, mu, zeta, c_2, c_3, zeta_2)
    found = np.log(means[0] / u**2), np.log(c), of_a, means[3]
    return np.array(found[: 3 + (not system.centred)])
