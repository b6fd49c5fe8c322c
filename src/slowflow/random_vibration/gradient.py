"""How root mean squares move with the parameters. Takes motions of statistical linearization; returns their gradient.

By the implicit function theorem, from what holds of them with p = ln k and q = ln c:

    ln I_0(p, q) - 2 ln sigma_u = 0,  p = ln(E[u f]/sigma_u^2)     ln I_2(p, q) - 2 ln sigma_v = 0,  q = ln C(sigma_v)

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
from slowflow.random_vibration.energy import AT, WEIGHTS
from slowflow.random_vibration.excitation import IMAGINARY, White
from slowflow_kernels import linearization
from slowflow_kernels.conventions import GradientStatus

#: of `EquationOfMotion`
LAWS = "mu", "zeta", "c_2", "c_3", "zeta_2"
#: u/sigma up to which averages reach
FARTHEST = 12.0
#: a determinant below which two motions are one, that of two motions far apart being some units
SINGULAR = 1e-12


def gradient(found: Any, system: EquationOfMotion, oscillator: Any) -> Gradient:
    """See `RandomResponse.gradient`."""
    model = oscillator.model
    mechanism, names = model.mechanism, model.mechanism.design_names
    if mechanism.by_design is None:
        raise validate.NotAvailable((OF_FUNCTIONS if mechanism.told else OF_RECORD).format(mechanism.name))
    others = [name for name in LAWS[2:] if getattr(system, name) > 0]
    present = [*LAWS[:2], *others]
    laws = tuple(getattr(system, name) for name in present)
    power = (found.excitation.S_0,) if isinstance(found.excitation, White) else ()
    by = (*names, *present, *("S_0",) * len(power))
    parameters, ends = model.parameters, np.array(mechanism.breakpoints(*model.parameters), dtype=float)
    # of each parameter, then of each breakpoint, by each number of the design
    by_design = np.array(mechanism.by_design(*model.design), dtype=float).reshape(-1, len(names))
    count, size = 2 + len(names), 2 + len(names) + len(laws)
    slopes = np.empty((len(found), 3, len(by)))
    status = np.full(len(found), GradientStatus.OK, np.int8)
    for row, (u, v) in enumerate(zip(found.u_rms, found.v_rms, strict=True)):

        def at(step: Any, u: float = u, v: float = v) -> Any:
            shifts = by_design @ step[2:count]
            shifted = np.array(parameters) + shifts[: len(parameters)]
            edges = (ends + shifts[len(parameters) :])[ends > 0]
            resists = {name: value + change for name, value, change in zip(present, laws, step[count:], strict=True)}
            return _state(system, shifted, edges, resists, u * (1 + step[0]), v * (1 + step[1]))

        by_all = np.array([at(1j * IMAGINARY * one).imag / IMAGINARY for one in np.eye(size)]).T
        by_p_q = found.excitation.slopes(float(found.stiffness[row]), float(found.damping[row]))
        matrix = 2 * np.eye(2) - by_p_q @ by_all[:2, :2]
        if not abs(np.linalg.det(matrix)) > SINGULAR:
            status[row], slopes[row] = GradientStatus.MEETS, math.nan
            continue
        # I_0 and I_2 are in proportion to S_0, which nothing else depends on
        own = np.concatenate((by_p_q @ by_all[:2, 2:], 1 / np.tile(power, (2, 1))), axis=1)
        relative = np.linalg.solve(matrix, own)
        of_a = by_all[2, :2] @ relative + np.append(by_all[2, 2:], np.zeros(len(power)))
        slopes[row] = u * relative[0], v * relative[1], of_a / (2 * found.a_rms[row])
    values = found.u_rms, found.v_rms, found.a_rms
    return Gradient(("u_rms", "v_rms", "a_rms"), by, slopes, status, values, (*model.design, *laws, *power))


def _state(system: EquationOfMotion, parameters: Any, ends: Any, laws: dict[str, Any], u: Any, v: Any) -> Any:
    """ln k, ln c and E[a^2], of complex numbers."""
    means = np.zeros(3, complex)
    within: Any = 1.0
    first = system.force.innermost
    edges = (0.0, *ends, FARTHEST * u.real)
    for piece, (low, high) in zip(system.force.pieces[first:], itertools.pairwise(edges), strict=True):

        def integrand(x: Any, law: Any = piece.law) -> Any:
            f = law.force(x, *parameters)
            return np.array([x * f, f * f, np.ones_like(x)]) * np.exp(-0.5 * (x / u) ** 2) * math.sqrt(2 / math.pi) / u

        if low.real >= edges[-1]:
            break
        high = min(high, edges[-1], key=np.real)
        width = high.real - low.real
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
    return np.array([np.log(means[0] / u**2), np.log(c), of_a])
