"""Answers of the second approximation: in goes a model with its curve, or averaging's answer, out come numbers.

None where an answer is no correction of averaging's.
"""

from __future__ import annotations

from slowflow import backend
from slowflow.answer import joined
from slowflow.averaged import solvers as averaged
from slowflow.averaged import words
from slowflow.model import Floats, Model
from slowflow.second.found import Curve, Fold, Folds, State, told, told_of_folds
from slowflow_kernels.conventions import Status
from slowflow_kernels.second_conventions import Wanted
from slowflow_support.errors import NotSettled


def along(
    model: Model, F_0: float, samples: int, window: tuple[float, float], wanted: Wanted = Wanted.EVERY_POINT
) -> Curve:
    """The curve that the first approximation's of about `samples` points in a window moves to, as far as wanted."""
    status, columns, native = backend.SOLVER.second_curve(model.native, F_0, wanted, samples, *window)
    averaged.check(status, model, F_0)
    Omega, A, u_max, A_1, phi, stable, part, closed, (lost, *left) = columns
    first = averaged.remark_of(model, F_0)
    message = first if left[0] else joined(first, words.empty_window(model, F_0, window))
    isola, message = tuple(closed.tolist()), told(message, lost, *left)
    return Curve(Omega, A, u_max, A_1, phi, stable, part, isola, message, lost > 0, native)


def saddle_nodes(model: Model, F_0: float) -> Folds | None:
    """Every fold beside averaging's and its highest peak; None where there is neither, or doubles do not tell."""
    status, undecided, found, lost, tried, left = backend.SOLVER.second_saddle_nodes(model.native, F_0)
    if status != Status.OK or undecided or not left[1]:
        return None
    of_curve = told(averaged.remark_of(model, F_0), *left)
    return told_of_folds([Fold(*fold) for fold in found], lost, tried, of_curve, F_0)


def folds(model: Model, curve: Curve, F_0: float) -> Folds:
    """Every fold between points of the curve."""
    status, found, lost, tried = backend.SOLVER.second_folds(model.native, F_0, curve.native)
    if status != Status.OK:
        raise NotSettled(words.unresolved(model, F_0))
    return told_of_folds([Fold(*fold) for fold in found], lost, tried, curve.message, F_0)


def states(model: Model, curve: Curve, Omega: Floats, F_0: float) -> list[State]:
    """Every state where the curve passes one of the frequencies, by their order, then by rising A."""
    found = backend.SOLVER.second_states(model.native, F_0, curve.native, Omega)
    return [State(Omega, u_max, A_1, phi, stable != 0) for Omega, u_max, A_1, phi, stable in found]


def peak(model: Model, curve: Curve, F_0: float) -> tuple[float, float] | None:
    """The highest point between points of the curve, u_max and its Omega."""
    status, u_max, Omega = backend.SOLVER.second_peak(model.native, F_0, curve.native)
    return (u_max, Omega) if status == Status.OK else None


def cusp(model: Model, F_SN: float, Omega: float, A: float) -> tuple[float, float, float] | None:
    """The cusp that averaging's moves to: F_SN, Omega, u_max."""
    status, *found = backend.SOLVER.second_onset(model.native, F_SN, Omega, A)
    return (found[0], found[1], found[2]) if status == Status.OK else None


def detachment(model: Model, F_cr: float, Omega_cr: float, u_cr: float) -> tuple[float, float] | None:
    """The lowest forcing whose largest displacement is u_cr, and its frequency, beside averaging's."""
    status, *found = backend.SOLVER.second_detachment(model.native, F_cr, Omega_cr, u_cr)
    return (found[0], found[1]) if status == Status.OK else None
