"""Points of other laws of damping: in go a model and a forcing, out come events along the curves, kinds of points.

Where the number of frequencies changes along the amplitude boxes find: peaks, static states, turns of the fold locus.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from slowflow.averaged.reference.along import Rest
from slowflow.averaged.reference.arcs import Event, Kind, merged
from slowflow.averaged.reference.boxes import Points, points_of, slopes_at
from slowflow.averaged.reference.cells import Stretch, doubtful, samples_at, stretches_up_to
from slowflow.averaged.reference.dissipated import Quartics
from slowflow.averaged.reference.search import find_zeros
from slowflow.intervals import Bools
from slowflow.model import THROUGHOUT, Floats, Model
from slowflow_kernels import dissipation, inertia, slow_flow
from slowflow_kernels.conventions import DOUBT, HARDLY


def response_events(model: Model, F_0: float, A_max: float) -> tuple[list[Event], bool]:
    """Where the number of frequencies of the response may change, by rising A: peaks, static states, breakpoints.

    And whether doubles leave open if there are more.
    """
    if model.inertial:
        return _events_of_inertia(model, F_0, A_max)
    pieces = stretches_up_to(model, A_max)
    peaks, static = peaks_of(model, pieces, F_0), points_of(model, "rest", pieces, F_0)
    found = [Event(0.0, np.inf, Kind.CUT)]
    with np.errstate(all="ignore"):
        rises, bends = _rises(model, peaks), _bends(model, peaks, F_0)
        at_rest = model.F_A(0.0, static.A) > 0
        coefficients = Quartics(model, F_0, static.A).c
        # where F falls from Omega = 0 on, it is a second root that comes from there
        second = (coefficients[1] == 0) & (coefficients[2] < 0)
    for number, piece in enumerate(pieces):
        inside = []
        for i in np.flatnonzero(peaks.piece == number):
            up = 1 if rises[i] else -1
            kind, gain = (Kind.PAIR_LOW, 2 * up) if bends[i] else (Kind.PAIR_HIGH, -2 * up)
            inside.append(Event(float(peaks.A[i]), float(peaks.Omega[i]), kind, gain))
        for i in np.flatnonzero(static.piece == number):
            up = 1 if at_rest[i] else -1
            inside.append(Event(float(static.A[i]), 0.0, Kind.TO_ZERO, up if second[i] else -up))
        found += sorted(inside, key=lambda event: event.A)
        if number + 1 < len(pieces):
            found.append(Event(float(piece.last.A[0]), 0.0, Kind.THROUGH))
    return merged([*found, Event(A_max, 0.0, Kind.CUT)]), peaks.undecided or static.undecided


def peaks_of(model: Model, pieces: list[Stretch], F_0: float) -> Points:
    """Peaks under a force. Where there is no spring all of F rises with Omega: there are none, and at Omega = 0 F is
    flat to the fourth power, which boxes do not tell from a peak."""
    held = np.flatnonzero([piece.has_force for piece in pieces])
    if not held.size:
        return Points(held, np.empty(0), np.empty(0), np.empty(0))
    if model.zeta == model.d == 0 and model.laws.rubs == THROUGHOUT:
        return _peak_by_structure(model, pieces, F_0)
    found = points_of(model, "peaks", [pieces[number] for number in held], F_0)
    return replace(found, piece=held[found.piece])


def _peak_by_structure(model: Model, pieces: list[Stretch], F_0: float) -> Points:
    """The peak where I knows no frequency: F_Omega = 0 leaves R = 0, and F = 0 then I = F_0, each of one variable.

    Where damping is weak F bends so much beside it that boxes are small before they tell, as small as what rounding
    leaves of R: on the edge of two neither did.
    """
    A = float(dissipation.limit_envelope(1.0, F_0, model.m, 0.0, model.laws.eta, 0.0))
    low, high = A * (1 - DOUBT), A * (1 + DOUBT)
    ends = [(float(piece.first.A[0]), float(piece.last.A[0])) for piece in pieces]
    number = np.flatnonzero(
        [a < low and high < b and piece.has_force for (a, b), piece in zip(ends, pieces, strict=True)]
    )
    at = samples_at(model, A)
    h = doubtful(at.h, at.A, at.h_A)
    # next to a breakpoint it is not known on which of the pieces, nor where h vanishes, whether Omega^2 > 0
    undecided = any(low <= end <= high for both in ends for end in both) or (number.size > 0 and not h.has_sign[0])
    number = number[:0] if undecided or h.hi[0] > 0 else number
    of_it = np.ones(number.size)
    return Points(number, A * of_it, slow_flow.backbone(A, at.h) * of_it, np.full(int(undecided), A))


def _events_of_inertia(model: Model, F_0: float, A_max: float) -> tuple[list[Event], bool]:
    """The same under an excitation by inertia, which leaves none at rest: a frequency comes from inf."""
    pieces = stretches_up_to(model, A_max)
    peaks = points_of(model, "peaks_by_inertia", pieces, F_0)
    full = float(dissipation.full_by_inertia(F_0, model.d))
    with np.errstate(all="ignore"):
        rises, bends = _rises(model, peaks), _bends(model, peaks, F_0)
    falls = _falls_from_infinity(model, F_0, full, peaks.Omega[bends])
    inside = [Event(full, np.inf, Kind.TO_INFINITY, 1 if falls else -1)]
    for A, Omega, up, low in zip(peaks.A.tolist(), peaks.Omega.tolist(), rises.tolist(), bends.tolist(), strict=True):
        gain = 2 if up == low else -2
        inside.append(Event(A, Omega, Kind.PAIR_HIGH if low else Kind.PAIR_LOW, gain))
    inside += [Event(float(piece.last.A[0]), 0.0, Kind.THROUGH) for piece in pieces[:-1]]
    if model.zeta == model.m == model.laws.eta == 0:
        inside += _where_nothing_pulls(model, F_0, pieces)
    inside.sort(key=lambda event: event.A)
    start = float(inertia.moves_from(F_0, model.held))
    # a pair that meets there is known to do so
    undecided = np.abs(peaks.A_undecided - full) > (HARDLY * full if falls else 0.0)
    return [Event(0.0, start, Kind.CUT), *inside, Event(A_max, 0.0, Kind.CUT)], bool(undecided.any())


def _where_nothing_pulls(model: Model, F_0: float, pieces: list[Stretch]) -> list[Event]:
    """By quadratic damping alone: where h = 0 frequencies come from 0, as all but h falls with Omega^2.

    Next to there h/Omega^2 is -A -+ r with r^2 = F_0^2 - (d A^2)^2: both on one side, or one on either.
    """
    zeros = find_zeros(model, [Rest(model, 0.0)], [piece for piece in pieces if piece.has_force])[0]
    found = []
    for A, rising in zip(zeros.A[zeros.channel == 0].tolist(), zeros.rising[zeros.channel == 0].tolist(), strict=True):
        beyond = dissipation.far_by_inertia(0.0, A, F_0, 0.0, 0.0, model.d, 0.0)[0]  # A^2 - r^2
        if beyond < 0:
            found.append(Event(A, 0.0, Kind.TO_ZERO))
        elif beyond < A**2:
            found.append(Event(A, 0.0, Kind.PAIR_LOW, -2 if rising else 2))
    return found


def _falls_from_infinity(model: Model, F_0: float, full: float, meet: Floats) -> bool:
    """Whether above the amplitude that the response tends to there is one more frequency than below, not one less.

    There F over Omega^4 is x (c_1 + c_2 x) next to x = 0, c_1 >= 0. For c_2 < 0 a pair meets at x = -c_1/(2 c_2), at
    an amplitude that is lower by c_1^2/|c_2| over F_0^2, or less: next to nothing where damping is weak.

    meet -- frequencies at which a higher pair is known to meet
    """
    _, c_1, c_2, *_ = (float(one[0]) for one in Quartics(model, F_0, np.array([full])).c)
    hardly_lower = c_2 < 0 and c_1**2 <= HARDLY * -c_2 * F_0**2
    return hardly_lower and not (c_1 * meet > -c_2).any()


def _rises(model: Model, peaks: Points) -> Bools:
    """Whether F rises with A at these peaks: of a force by the R that F_Omega = 0 leaves, in which nothing cancels."""
    Omega, A = peaks.Omega, peaks.A
    if model.inertial:
        return np.asarray(model.F_A(Omega, A) > 0)
    I_0, I_0A, *_ = model.at_rest(A)
    lag = dissipation.I(Omega, A, I_0, model.zeta, model.d)
    R = dissipation.R_of_peak(Omega, A, model.zeta, model.d, lag)
    slopes = Omega**2 + model.averaged(A)[1], dissipation.I_A(Omega, A, I_0A, model.zeta, model.d)
    return np.asarray(dissipation.F_A_halved(R, slopes[0], lag, slopes[1]) > 0)


def _bends(model: Model, peaks: Points, F_0: float) -> Bools:
    """Whether F has a maximum over Omega at these peaks."""
    if not model.inertial:
        return np.asarray(_F_OmegaOmega(model, peaks.Omega, peaks.A) < 0)
    # F_OmegaOmega is -4/Omega times that of the second function by Omega
    return np.asarray(slopes_at(model, "peaks_by_inertia", peaks, F_0)[3] > 0)


def is_top(model: Model, peaks: Points, F_0: float) -> Bools:
    """Whether two frequencies that are there below these peaks meet in them, and F rises: stable motions end."""
    with np.errstate(all="ignore"):
        return np.asarray(_rises(model, peaks) & ~_bends(model, peaks, F_0))


def isolas_of(model: Model) -> str:
    """The system of isola points, where the level of the excitation is stationary."""
    return "isolas_by_inertia" if model.inertial else "isolas"


def rises_from_rest(model: Model, A: Floats) -> Bools:
    """Whether the level rises with Omega from Omega = 0 on at these amplitudes, or F at least does not fall."""
    I_0 = model.at_rest(A)[0]
    return np.asarray((model.zeta * I_0 > 0) | (_F_OmegaOmega(model, np.zeros_like(A), A) >= 0))


def _F_OmegaOmega(model: Model, Omega: Floats, A: Floats) -> Floats:
    return np.asarray(
        dissipation.F_OmegaOmega(Omega, A, model.at_rest(A)[0], model.zeta, model.d, model.averaged(A)[0])
    )
