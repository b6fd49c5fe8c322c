"""A user's questions put to the equation of motion. Takes an averaged oscillator and numbers; returns exact answers.

`Isolator` and `Duffing` delegate here. The averaged solution, which costs microseconds, gives the guesses.
"""

from __future__ import annotations

import dataclasses
import math
import sys
from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow import validate
from slowflow.answer import joined
from slowflow.averaged.diagnostics import WORDS
from slowflow.exact import response, shooting
from slowflow.exact.motion import check_forcing, only_rests, stays_at_rest, why_at_rest
from slowflow.exact.sweep import Sweep
from slowflow.exact.sweep import sweep as stepped
from slowflow.exact.transient import AFTER, NO_PULSE, Arc, ShockSpectrum, Transient, half_sine, record, shock_spectrum
from slowflow.exact.transient import transient as followed
from slowflow.loaded import Loaded
from slowflow.mechanism import EquationOfMotion
from slowflow.results import Remark
from slowflow.text import Sentence, text
from slowflow_kernels import inertia
from slowflow_support.errors import NotSettled, Refused

if TYPE_CHECKING:
    from slowflow.averaged.questions import Averaged

#: distance, relative in amplitude and frequency, from which on the averaged points are those of another curve
APART = 0.1

#: largest relative distance of an averaged fold from the frequency at which motions near it are looked for
BESIDE = 0.05

#: by how much the force exceeds friction where a curve begins that would else begin at rest
EXCEEDS = 1.05

RESTS = Sentence(
    "at this {F_0} friction holds the mass up to {Omega} = {Omega[0]:.4g}: the curve begins at {Omega} = {Omega[1]:.4g}"
)

OTHER = Sentence(
    "another curve is not part of this one: averaging has it at {Omega = :.4g}, {A = :.4g}; "
    "start = steady_state({Omega=:.4g}, {F_0=:.4g}, {A=:.4g}) leads to it"
)
#: a pulse, or a step of a record, whose frequency is beyond the range of doubles
SHORTEST = math.pi / sys.float_info.max
NOWHERE = text(
    "no motion from rest: there is no stable place of rest that the mass could begin at; {u_0}= says where it does"
)
SEVERAL = Sentence(
    "there are several stable places of rest, at {u = :.6g}: the mass begins at {u} = {u_0:.6g}, the nearest to the "
    "centre; {u_0}= has it begin elsewhere"
)
#: displacement at which it is asked where a force pushes that has no stiffness at u = 0
NEXT = 2.0**-20
BOTH = Sentence("{name:s} says which motion it is, {u_0} and v_0 from where one comes: not both")
ONLY = Sentence(
    "this is the only motion that averaging knows of, and not one that the mass was seen to come to: {why:s}"
)
UNKNOWN = Sentence("whether there are other curves is not known, averaging does not say: {why:s}")
NONE_NEAR = "no state at {Omega = :g} leads to a periodic motion of the equation of motion"
START = "start = {start:r} is not allowed: start must be a steady state at {F_0 = :g}, {Omega} in {Omega:r}"
ROWS = "{tau} and acceleration must be two rows of as many numbers, {tau} rising: not of {shapes:s}"


def steady_state(
    averaged: Averaged,
    system: EquationOfMotion,
    Omega: float,
    F_0: float,
    A: float | None,
    u_0: float | None,
    v_0: float,
) -> shooting.SteadyState:
    """See `slowflow.oscillator.Oscillator.steady_state`."""
    Omega = validate.number("Omega", Omega, above=0.0)
    F_0 = validate.number("F_0", F_0, above=0.0)
    wanted = None if A is None else validate.number("A", A, above=0.0)
    if wanted is None:
        return _from_rest(averaged, system, Omega, F_0, u_0, v_0)
    if u_0 is not None or v_0 != 0:
        raise Refused(BOTH.format("A"))
    if only_rests(system, Omega, F_0):
        return _from_rest(averaged, system, Omega, F_0)
    check_forcing(system, Omega, F_0)
    if not system.centred:
        return _off_centre(averaged, system, Omega, F_0, wanted)
    guesses = _guesses(averaged, Omega, F_0, wanted)
    found = [motion for motion in (shooting.near(system, Omega, F_0, guess) for guess in guesses) if motion is not None]
    found += _held(averaged, system, Omega, F_0)
    if found:
        return min(found, key=lambda motion: abs(motion.A - wanted))
    return shooting.steady_state(system, guesses[0], Omega=Omega, F_0=F_0)


def _held(averaged: Averaged, system: EquationOfMotion, Omega: float, F_0: float) -> list[shooting.SteadyState]:
    """Of static friction, which averaging knows nothing of: what a mass at rest comes to, if it moves and settles."""
    if not system.mu_s > system.mu:
        return []
    try:
        at, _ = at_rest(averaged, system)
        if stays_at_rest(system, Omega, F_0, at):
            return []
        return [_from_rest(averaged, system, Omega, F_0)]
    except ArithmeticError:
        return []


def _off_centre(
    averaged: Averaged, system: EquationOfMotion, Omega: float, F_0: float, A: float
) -> shooting.SteadyState:
    """The motion nearest to an amplitude of those that states off the centre lead to: A is |B| + A of these.

    So does the amplitude itself about the mean of each, at resonance: averaging does not know all motions.
    Where none leads to one by Newton's iteration, what the nearest of them settles to.
    """
    found, states = [], _states(averaged, Omega, F_0)
    for state in states:
        own = [(A - abs(state.B), -math.pi / 2)] if abs(state.B) < A else []
        for guess in ((state.A, state.phi), *own):
            motion = shooting.near(system, Omega, F_0, guess, B=state.B)
            found += [] if motion is None else [motion]
    found += _held(averaged, system, Omega, F_0)
    if not found and states:
        nearest = min(states, key=lambda state: abs(state.A + abs(state.B) - A))
        start = (nearest.A + max(nearest.B, 0.0), nearest.phi)
        return shooting.steady_state(system, start, Omega=Omega, F_0=F_0)
    if not found:
        raise NotSettled(text(NONE_NEAR, Omega))
    return min(found, key=lambda motion: abs(motion.A - A))


def exact_response(
    averaged: Averaged,
    system: EquationOfMotion,
    F_0: float,
    Omega: tuple[float, float],
    start: shooting.SteadyState | None,
    step: float,
    u_0: float | None,
    v_0: float,
) -> response.Response:
    """See `slowflow.oscillator.Oscillator.exact_response`."""
    F_0 = validate.number("F_0", F_0, above=0.0)
    low, high = validate.window("Omega", Omega)
    low = validate.number("Omega[0]", low, above=0.0)
    step = validate.number("step", step, above=0.0, most=0.5)
    rests = ""
    if system.inertial and system.forcing(Omega=low, F_0=F_0) < EXCEEDS * system.holds(0):
        alone = float(inertia.moves_from(F_0, system.holds(0)))
        low = min(high, math.sqrt(EXCEEDS) * alone)
        rests = RESTS.format((alone, low))
    if start is None:
        start = _from_rest(averaged, system, low, F_0, u_0, v_0)
    elif u_0 is not None or v_0 != 0:
        raise Refused(BOTH.format("start"))
    elif not (isinstance(start, shooting.SteadyState) and low <= start.Omega <= high and start.F_0 == F_0):
        raise Refused(text(START, start, F_0, Omega))
    if start.cycle.stays:
        said = why_at_rest(system, start.Omega, F_0, float(start.unknowns[0]))
        return response.without_a_motion(F_0, joined(start.message, said))
    found = response.exact_response(system, F_0, Omega=(low, high), start=start, step=step)
    # what else there is cannot be told from a part
    said = _others(averaged, found, (low, high)) if found.complete else found.message
    return dataclasses.replace(found, message=joined(rests, start.message, said))


def _others(averaged: Averaged, found: response.Response, window: tuple[float, float]) -> str:
    """Names a stable point of each averaged curve in the window that the exact one does not come near."""
    try:
        curve, A = _averaged(averaged, found.F_0, window)
    except (ArithmeticError, ValueError) as error:
        return UNKNOWN.format(error.args[0])
    points = np.log(np.column_stack((curve.Omega, A)))
    line = np.log(np.column_stack((found.Omega, found.A)))
    apart = np.array([np.abs(line - point).max(axis=1).min() for point in points])
    branches = [np.flatnonzero(curve.branch == branch) for branch in np.unique(curve.branch)]
    branches.sort(key=lambda on: float(np.median(apart[on])))
    remarks = []
    for on in branches[1:]:  # the nearest is this curve, however far friction keeps averaging from it
        stable = on[curve.stable[on]]
        if stable.size and np.median(apart[on]) > APART:
            at = stable[stable.size // 2]
            remarks.append(OTHER.format(Omega=curve.Omega[at], A=A[at], F_0=found.F_0))
    return joined(*remarks)


def _averaged(averaged: Any, F_0: float, window: tuple[float, float]) -> tuple[Any, Any]:
    """The averaged curve with the largest |u| of its motions: off the centre their mean is part of it."""
    if isinstance(averaged.model, Loaded):
        curve = averaged.frequency_response(F_0, samples=100, Omega=window)
        return curve, curve.A + np.abs(curve.B)
    curve = averaged.curve(F_0, samples=100, Omega=window)
    return curve, curve.A


def sweep(averaged: Any, system: EquationOfMotion, Omega: Any, F_0: float, u_0: float | None, v_0: float) -> Sweep:
    """See `slowflow.oscillator.Oscillator.sweep`."""
    F_0 = validate.number("F_0", F_0, above=0.0)
    frequencies = validate.positive_array("Omega", Omega)
    u, v, said = _beginning(averaged, system, u_0, v_0)
    return dataclasses.replace(stepped(system, Omega=frequencies, F_0=F_0, u_0=u, v_0=v), message=said)


def transient(
    averaged: Any,
    system: EquationOfMotion,
    acceleration: Any,
    duration: Any,
    tau: Any,
    after: Any,
    u_0: float | None = None,
    v_0: float = 0.0,
) -> Transient:
    """See `slowflow.oscillator.Oscillator.transient`; of an `Averaged`, or of an `OffCentre`."""
    released = acceleration is None and duration is None and tau is None and (u_0 is not None or v_0 != 0)
    if not released and (duration is None) == (tau is None):
        raise Refused(NO_PULSE)
    begin = 0.0
    if released:
        arcs = np.empty((0, len(Arc._fields)))
    elif duration is not None:
        peak = validate.number("acceleration", acceleration)
        arcs = half_sine(peak, validate.number("duration", duration, above=SHORTEST))
    else:
        times, samples = validate.finite_array("tau", tau), validate.finite_array("acceleration", acceleration)
        if times.ndim != 1 or times.shape != samples.shape or times.size < 2 or not (np.diff(times) > SHORTEST).all():
            raise Refused(text(ROWS, f"{times.shape} and {samples.shape}"))
        arcs, begin = record(times, samples), float(times[0])
    last = AFTER if after is None else validate.number("after", after, least=0.0)
    at, v, said = _beginning(averaged, system, u_0, v_0)
    rest = at if u_0 is None else at_rest(averaged, system)[0]
    found = followed(system, arcs, begin=begin, after=last, at=at, v=v, rest=rest)
    return dataclasses.replace(found, message=joined(said, _beyond_reach(averaged, found.A)))


def _beginning(averaged: Any, system: EquationOfMotion, u_0: Any, v_0: Any) -> tuple[float, float, str]:
    """Displacement and velocity that a motion begins with, and what there is to say: by default at rest."""
    v = validate.number("v_0", v_0)
    if u_0 is not None:
        return validate.number("u_0", u_0), v, ""
    at, said = at_rest(averaged, system)
    return at, v, said


def rests_at_centre(system: EquationOfMotion) -> bool:
    """Whether u = 0 is a place of rest that the force does not push the mass away from, on either side."""
    force = system.force
    if force.jump != 0:
        return force.jump > 0
    if force.value(0.0) != system.load:
        return False
    for side in (1.0, -1.0):
        stiffness = force.piece(force.region_of(side * NEXT)).slope(0.0)
        if not (stiffness > 0 or (stiffness == 0 and side * (force.value(side * NEXT) - system.load) >= 0)):
            return False
    return True


def at_rest(averaged: Any, system: EquationOfMotion) -> tuple[float, str]:
    """Where the mass rests, f(u) = load, and what there is to say: of the stable places the nearest to the centre.

    Of two that are as near that with u > 0. Friction holds it beside these too, but that is no place of its own.
    Raises ArithmeticError where there is none.
    """
    stands = rests_at_centre(system)
    if stands and system.centred:
        return 0.0, ""
    found, force = averaged.rest(), system.force
    places = found.u[found.stable]
    if not places.size and stands:
        return 0.0, ""
    if not places.size:
        raise NotSettled(NOWHERE)
    near = places[places > 0] if system.centred else places
    from scipy.optimize import root_scalar  # a motion about the centre does without SciPy

    # of the force that is followed, which may be another one than is averaged
    at = root_scalar(
        lambda u: force.value(u) - system.load,
        fprime=lambda u: force.piece(force.region_of(u)).slope(u),
        x0=float(near[np.argmin(np.abs(near))]),
        method="newton",
    )
    if not at.converged:
        raise NotSettled(NOWHERE)
    u = float(at.root)
    if places.size == 1:
        return u, ""
    return u, SEVERAL.format(places, u)


def _beyond_reach(averaged: Any, A: float) -> str:
    """That a deflection is beyond what the mechanism reaches, and why; empty where it is not."""
    model = averaged.model
    if A <= model.reach:
        return ""
    return WORDS[Remark.BEYOND_REACH].format(reach=model.reach, reason=model.mechanism.reach_reason)


def shocks(averaged: Any, system: EquationOfMotion, acceleration: Any, duration: Any) -> ShockSpectrum:
    """See `slowflow.oscillator.Oscillator.shock_spectrum`; likewise."""
    pulses = {
        "acceleration": validate.positive_array("acceleration", acceleration),
        "duration": validate.positive_array("duration", duration),
    }
    shape = validate.common_shape(pulses)
    validate.number("duration", float(pulses["duration"].min(initial=1.0)), above=SHORTEST)
    at, said = at_rest(averaged, system)
    peaks, spans = (np.broadcast_to(values, shape).ravel() for values in pulses.values())
    found = shock_spectrum(system, peaks, spans, at)
    return dataclasses.replace(found, message=joined(said, _beyond_reach(averaged, float(found.A.max(initial=0.0)))))


def _from_rest(
    averaged: Averaged, system: EquationOfMotion, Omega: float, F_0: float, u_0: float | None = None, v_0: float = 0.0
) -> shooting.SteadyState:
    """What a mass at rest comes to, or one that begins with (u_0, v_0), followed.

    Where that is not seen to be periodic, the only one that averaging knows of, with words that it is not that.
    """
    u, v, said = _beginning(averaged, system, u_0, v_0)
    if (resting := shooting.comes_to_rest(system, Omega, F_0, u, v)) is not None:
        return dataclasses.replace(resting, message=said)
    try:
        return dataclasses.replace(shooting.steady_state(system, Omega=Omega, F_0=F_0, u_0=u, v_0=v), message=said)
    except shooting.NotPeriodic as unseen:
        states = list(averaged.states(Omega=Omega, F_0=F_0)) if system.centred else _states(averaged, Omega, F_0)
        if len(states) == 1:
            B = 0.0 if system.centred else states[0].B
            found = shooting.near(system, Omega, F_0, (states[0].A, states[0].phi), B=B)
            if found is not None and found.stable:
                return dataclasses.replace(found, message=joined(said, ONLY.format(unseen.args[0])))
        raise


def _states(averaged: Any, Omega: float, F_0: float) -> list[Any]:
    """States of `OffCentreStates` in which the mass moves."""
    return [state for state in averaged.amplitudes(Omega=Omega, F_0=F_0) if state.A > 0]


def _guesses(averaged: Averaged, Omega: float, F_0: float, A: float) -> list[tuple[float, float]]:
    """(A, phi) from which Newton's iteration may come to a motion of amplitude A, the averaged state nearest first.

    Averaging's folds lie beside the exact ones: where it has no such state the motion may still be there, so the folds
    next to Omega are tried, and the amplitude itself with the phase that averaging gives it.
    """
    model = averaged.model
    states, folds = averaged.states(Omega=Omega, F_0=F_0), averaged.folds(F_0)
    beside = np.abs(folds.Omega / Omega - 1.0) < BESIDE
    amplitudes = np.concatenate((folds.A[beside], [A]))
    frequencies = np.concatenate((folds.Omega[beside], [Omega]))
    h = model.averaged(amplitudes)[0]
    phases = model.flow.phase(frequencies, amplitudes, *model.alike(frequencies, amplitudes), h)
    known = sorted(zip(states.A, states.phi, strict=True), key=lambda state: abs(state[0] - A))
    return [(float(a), float(phi)) for a, phi in (*known[:1], *zip(amplitudes, phases, strict=True))]
