"""How answers off the centre move. Takes answers and what they are; returns their gradients, exact.

By the implicit function theorem. What a number of the design does to the force, piece by piece, makes the means over a
cycle move (`Steps.moved`), these move the balance and h along it (`off_centre.moved`), and from there on the answers
move as those about the centre do (`slowflow.answers.sensitivities`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from slowflow.answers import sensitivities
from slowflow.answers.gradient import Gradient
from slowflow.core.backend import SOLVER
from slowflow.core.model import WITH_MEAN, Floats, Model
from slowflow.core.validate import NotAvailable
from slowflow.off_centre.curved import Curved
from slowflow.off_centre.flow import Flow
from slowflow.off_centre.means import ORDERS, Means, Steps, short_of
from slowflow_kernels import dissipation, off_centre, slow_flow
from slowflow_kernels.conventions import MEETING, SAME, GradientStatus, PointType

#: answers that hold an end of a motion on a breakpoint
ON_A_BREAKPOINT = (PointType.CORNER_FOLD, PointType.CORNER_TOP, PointType.CORNER_END, PointType.CORNER_REST)

NO_DESIGN = "no gradient: the record of this force does not have its derivatives with respect to the design"


@dataclass(frozen=True)
class Design:
    """The oscillator of an answer: the slow flow, its force as steps, and the sensitivity of the force to the design.

    gains, positions -- sensitivities of those of the steps to each parameter, (numbers, steps, orders) and
                        (numbers, steps)
    curved           -- that of the rest of the force, None where the force is a piecewise polynomial
    """

    model: Model
    steps: Steps
    gains: Floats
    positions: Floats
    curved: tuple[Curved | None, ...]

    @classmethod
    def of(cls, model: Model | None, load: float) -> Design:
        """Under a load. Raises NotAvailable where the force's sensitivity to the design is not known."""
        if model is None or not model.has_design or model.mechanism.by_design is None:
            raise NotAvailable(NO_DESIGN)
        steps = Steps(model.mechanism, model.parameters, load)
        of_force = model.mechanism, model.parameters
        of_parameters, of_ends = _by_design(model)
        gains = np.einsum("psk,pd->dsk", steps.by_parameter(*of_force), of_parameters)
        return cls(model, steps, gains, steps.by_step(of_ends.T), tuple(steps.curved_by(*of_force, of_parameters)))

    def within(self, A: Floats, B: Floats) -> Design:
        """With the pieces alone that one motion passes, as if the outermost held everywhere beyond."""
        own, curved = self.steps.passed(A, B), tuple(one and one.within(*short_of(A, B)) for one in self.curved)
        return Design(self.model, self.steps.within(A, B), self.gains[:, own], self.positions[:, own], curved)

    def sensitivities(self, A: Floats, B: Floats, numbers: int) -> Floats:
        """Sensitivities of c_n and s_n to so many parameters, those of the design first: (2, ORDERS, numbers, n)."""
        found = np.zeros((2, ORDERS, numbers, A.size))
        for k, of in enumerate(zip(self.gains, self.positions, self.curved, strict=True)):
            sensitivity = self.steps.sensitivity(A, B, *of)
            found[0, :, k], found[1, :, k] = sensitivity.c, sensitivity.s
        return found

    @property
    def names(self) -> tuple[str, ...]:
        """The numbers that answers depend on, besides arguments of the query."""
        return (*self.model.mechanism.design_names, *self.damping, "load")

    @property
    def damping(self) -> dict[str, float]:
        """Of all laws where there are others than friction and viscous damping."""
        model, laws = self.model, self.model.laws
        others = {name: getattr(laws, name) for name in WITH_MEAN} if laws.any else {}
        return {"mu": model.mu, "zeta": model.zeta, **others}


def _by_design(model: Model) -> tuple[Floats, Floats]:
    """What each number of the design does to the force's parameters, and to the ends of its pieces; rows by these."""
    mechanism, count = model.mechanism, len(model.parameters)
    assert mechanism.by_design is not None
    with np.errstate(divide="ignore", invalid="ignore"):  # at the end of a domain a slope may have no bound
        slopes = np.array(mechanism.by_design(*model.design), dtype=float)
    ends = len(mechanism.breakpoints(*model.parameters))
    slopes = slopes.reshape(count + ends, len(model.design))
    return slopes[:count], slopes[count:]


def gradient(
    design: Design,
    kinds: Any,
    point: tuple[Any, Any, Any, Any],
    of: Mapping[str, str],
    arguments: tuple[str, ...] = (),
) -> Gradient:
    """The gradient of answers at A, B, Omega and a forcing.

    kinds -- their `PointType`; CORNER_END for any onset on a breakpoint
    of    -- numbers by name: "A", "B", "Omega", "F_0", "u_max", and of states "phi" and "transmissibility"
    arguments -- of the query: "F_0" and "Omega", or less
    """
    shape = np.shape(point[0])
    A, B, Omega, F_0 = (np.atleast_1d(np.broadcast_to(np.asarray(one, dtype=float), shape)).ravel() for one in point)
    kinds = np.broadcast_to(np.asarray(kinds), A.shape)
    names = (*design.names, *arguments)
    slopes, status = np.full((A.size, len(of), len(names)), np.nan), np.full(A.size, GradientStatus.OK, np.int8)
    values = np.full((len(of), A.size), np.nan)
    with np.errstate(all="ignore"):
        for kind in np.unique(kinds):
            here = np.flatnonzero(kinds == kind)
            # on a breakpoint means are those of the pieces that each motion passes
            for some in here[:, np.newaxis] if kind in ON_A_BREAKPOINT else [here]:
                at = (x[some] for x in (A, B, Omega, F_0))
                found, known, status[some] = _of_kind(design, PointType(int(kind)), names, *at)
                for row, name in enumerate(of.values()):
                    slopes[some, row], values[row, some] = found[name].T, known[name]
    status[~np.isfinite(slopes).all(axis=(1, 2)) & (status == GradientStatus.OK)] = GradientStatus.BOUNDLESS
    status[~(np.isfinite(A) & np.isfinite(F_0))] = GradientStatus.NOTHING
    slopes[status != GradientStatus.OK] = np.nan
    query = {"F_0": point[3], "Omega": point[2]}
    numbers = (*design.model.design, *design.damping.values(), design.steps.load, *(query[name] for name in arguments))
    whole = slopes.reshape(*shape, len(of), len(names)), status.reshape(shape)
    return Gradient(tuple(of), names, *whole, tuple(row.reshape(shape) for row in values), numbers)


def of_isolation(design: Design, point: tuple[Any, Any, Any, Any], ratio: Any) -> Gradient:
    """The gradient of the state at A, B, Omega and a forcing of this transmissibility."""
    of = {name: name for name in ("A", "B", "transmissibility")}
    state = gradient(design, PointType.STATE, point, of, ("F_0", "Omega"))
    A, B, Omega = (np.asarray(one, dtype=float) for one in point[:3])
    slopes, status = sensitivities.along_frequency(state.slopes, state.status, Omega, A, ratio)
    return Gradient(("Omega", "A", "B"), state.by[:-1], slopes, status, (Omega, A, B), state._at[:-1])


@np.errstate(all="ignore")  # at the ends of doubles a slope has no bound, or is no number
def of_rest(design: Design, u: Floats) -> Gradient:
    """The gradient of equilibria, f(u) = load, and of the stiffness there."""
    none, steps = np.zeros(u.shape), design.steps
    _, slope, curvature = steps.at(none, u, ORDERS - 1).c
    names, size = design.names, np.abs(slope).max(initial=1.0)
    f_p, slope_p = design.sensitivities(none, u, len(names))[0][:2]
    f_p[names.index("load")] -= 1.0
    u_p = -f_p / slope
    slopes = np.stack((u_p, slope_p + curvature * u_p), axis=-1).transpose(1, 2, 0)
    ends = steps.positions[1:] * steps.sides[1:]
    comes = np.abs(u[:, np.newaxis] - ends) <= SAME * np.abs(ends)
    status = np.where(np.abs(slope) > MEETING * size, GradientStatus.OK, GradientStatus.MEETS)
    status = np.where(comes.any(axis=1), GradientStatus.TURNS, status)
    status[~np.isfinite(slopes).all(axis=(1, 2)) & (status == GradientStatus.OK)] = GradientStatus.BOUNDLESS
    slopes[status != GradientStatus.OK] = np.nan
    numbers = (*design.model.design, *design.damping.values(), steps.load)
    return Gradient(("u", "stiffness"), names, slopes, status.astype(np.int8), (u, slope), numbers)


def _of_kind(
    design: Design, kind: PointType, names: tuple[str, ...], A: Floats, B: Floats, Omega: Floats, F_0: Floats
) -> tuple[Mapping[str, Floats], Mapping[str, Floats], Any]:
    """The sensitivities of the answers to each parameter, (names, n) each; the answers; their status."""
    model, steps, flow = design.model, design.steps, Flow.of(design.model)
    ends, full = np.zeros((len(names), A.size)), design
    if kind in ON_A_BREAKPOINT:
        reached, design = steps.reached(A, B), design.within(A, B)
        side, ends[: len(model.design)] = steps.sides[reached], full.positions[:, reached, np.newaxis]
    means, (h, h_A, h_AA, h_AAA) = design.steps.averaged(A, B)
    turns = False
    if kind == PointType.CORNER_END:
        kind, turns = _onset_type(flow, A, Omega, means, side if steps.gains[reached, 0] else None)
    of_load, of_F_0, of_Omega = (
        (np.array(names) == name)[:, np.newaxis] * np.ones(A.size) for name in ("load", "F_0", "Omega")
    )
    c_p, s_p = design.sensitivities(A, B, len(names))
    # mypy takes a starred argument for all that are left
    B_p, *of_h = off_centre.moved(A, *means.c[1:], *means.s[1:], *c_p, *s_p, of_load)  # type: ignore[call-arg]
    if kind in ON_A_BREAKPOINT:
        (ends,) = off_centre.moved_at_end(side, means.c[1], means.s[1], c_p[0], of_load, ends)
    place, causes = len(model.design), np.zeros((8, len(names), A.size))
    of_m, of_eta = np.reshape([np.broadcast_to(one, A.shape) for one in dissipation.rest_moves(A)], (2, 3, A.size))
    causes[:3, place], causes[3, place + 1] = slow_flow.friction(1.0) * of_m, 1.0
    if model.laws.any:
        causes[:3, place + 2], causes[6, place + 3] = of_eta, dissipation.quadratic(1.0)
    at = A, Omega, F_0, kind, model.inertial, h, h_A, h_AA, h_AAA, *flow.at_rest(A), *flow.viscous(A), flow.d, flow.d_3
    columns = np.broadcast_arrays(*at, *of_h, *causes, of_F_0, of_Omega, ends)
    A_p, phi_p, passed_p, Omega_p, F_0_p, isolated = np.moveaxis(SOLVER.moved(np.stack(columns, axis=-1)), -1, 0)
    found = {"A": A_p, "B": B_p - means.s[1] / means.c[1] * A_p, "Omega": Omega_p, "F_0": F_0_p}
    found["u_max"] = found["A"] + np.sign(B) * found["B"]
    found |= {"phi": phi_p, "transmissibility": passed_p}
    values = {
        "A": A,
        "B": B,
        "u_max": A + np.abs(B),
        "Omega": Omega,
        "F_0": F_0,
        "phi": flow.phase(Omega, A, h),
        "transmissibility": flow.transmissibility(Omega, A, F_0, h),
    }
    if turns:
        return found, values, GradientStatus.TURNS
    return found, values, np.where(isolated[0] == 1, GradientStatus.OK, GradientStatus.MEETS)


def _onset_type(flow: Flow, A: Floats, Omega: Floats, means: Means, jump: float | None) -> tuple[PointType, bool]:
    """What an onset on a breakpoint is besides, by its frequency, and whether it belongs to motions beyond.

    jump -- the side of a jump of the force, where h_A has another limit beyond: there c_1 grows without bound and with
            it side s_1
    """
    h, curvature = -2 * means.s[0], 2 * means.s[0] / A
    slopes = [curvature - 2 * (means.c[1] - means.s[1] ** 2 / means.c[1])]
    if jump is not None:
        slopes.append(curvature - 4 * (means.c[1] - jump * means.s[1]))
    candidates = [flow.stationary(A, h), *(flow.fold_frequencies(A, h, slope) for slope in slopes)]
    nearest = int(np.argmin([np.nanmin(np.abs(one - Omega), initial=np.inf) for one in candidates]))
    return (PointType.CORNER_END if nearest else PointType.CORNER_TOP), nearest == 2
