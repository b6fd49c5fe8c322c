"""Averaged results for motions with a mean: static load, asymmetric force, double well.

The motion is u = B + A cos psi. The mean B follows from the balance f_0(A, B) = 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial, wraps
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np

from slowflow.answers.answer import joined
from slowflow.answers.results import (
    Detachment,
    FrequencyResponse,
    Peak,
    Remark,
    SaddleNodeOnset,
    SaddleNodes,
    SteadyStates,
)
from slowflow.averaged import checks, diagnostics, isolating, messages, solvers
from slowflow.averaged.composed import ComposedQuestions
from slowflow.averaged.pairs import at_pairs
from slowflow.averaged.questions import Averaged
from slowflow.core import validate
from slowflow.core.mechanism import Ints
from slowflow.core.model import CENTRED, Floats, Loaded, Model, off_centre_by
from slowflow.off_centre import answers
from slowflow.off_centre.answers import RestPositions
from slowflow.off_centre.boxes import Solutions, solve
from slowflow.off_centre.by_turning_points import at_rest
from slowflow.off_centre.complete import AT_CENTRE, SUBDIVISIONS, Complete
from slowflow.off_centre.curve import Curves, curves
from slowflow.off_centre.flow import Flow, Slow
from slowflow.off_centre.means import Steps
from slowflow.off_centre.reach import AMPLITUDE, LARGEST, Farthest, Measure, Reach
from slowflow.support import boundary
from slowflow.support.errors import NotSettled, OutOfRange, Refused
from slowflow.support.immutable import Unchanging
from slowflow.support.text import Sentence, together
from slowflow_kernels import dissipation, inertia, off_centre

#: a force that has shorter lengths is small beside what is rounded, as the size of a problem is taken to be 1 at least
SHORTEST = 2.0**-40
TOO_SMALL = Sentence(
    "offset motions are unresolved: lengths of the force, {A[0]:.3g} at most, are too small against "
    "{A[1]:.3g}; in smaller units of length they may be resolved"
)
#: of no fold: A, B and R, and on which kind of corner
NO_FOLDS = np.empty((3, 0)), np.empty(0, dtype=str)
#: answers that are kept of one oscillator
KEPT = 64
#: motions whose A and B differ by less beside A are one, found twice
SAME = 2.0**-20
#: above the frequency from which on a base moves the mass, and of the highest one of a window, where curves begin
BEGINS = 2.0**-10
UNDAMPED = "{} needs zeta > 0, eta > 0 or c_2 > 0 for offset motions: without damping that grows they are unbounded"
BY_ITSELF = Sentence(
    "{question:s} is not available with {what:s} for motions that leave the centre without a load: it takes "
    "excitation = 'force', {mu} and zeta there"
)
OPEN = Sentence("isolation is unresolved: motions beyond {A = :g} are not searched, and the response may not close")
CUT = Sentence("no peak up to {A = :g}, the end of the search: the response may not close")
TENDED_TO = Sentence(
    "the motion tends to the first breakpoint as {Omega} tends to inf, at {F_0 = :g}; below this it is not reached"
)
NO_MARGINS = "margins is unresolved: "
BEYOND = "at rest the mass is already at the first breakpoint or beyond it"
ONE_PIECE = "no detachment: the force has one piece only"
NOT_REACHED = "no motion reaches the first breakpoint"
UNKNOWN = "whether motions reach the first breakpoint is undecided, as the equilibrium is"
TURNS = "the largest displacement is at a turning point of the mean; it is known to a relative 2^-24"
NO_ONSET = "no saddle node at any forcing, up to amplitudes far beyond the size of the problem"
UNDECIDED_ONSET = Sentence("the onset is undecided: {why:s}")
ON_CORNER = "on a corner due to the jump of the force: a force without this jump has none there"
UNDECIDED = Sentence("the number of states is undecided at {Omega = :.6g}{more:s}")
UNDECIDED_BEYOND = Sentence("whether a stable motion transmits {what:s} at a higher frequency too is undecided")
UNDECIDED_FOLDS = Sentence("whether there are others is undecided next to {A = :.6g}{more:s}")
UNDECIDED_REST = Sentence("whether there are others is undecided next to {u = :.6g}{more:s}")


_Answered = TypeVar("_Answered")
Method = TypeVar("Method", bound=Callable[..., Any])


class _Notes(NamedTuple):
    """Message and diagnostics of an answer."""

    message: str = ""
    remarks: Remark = Remark(0)

    def combine(self, other: _Notes) -> _Notes:
        """Both, this first, and a message that both have once."""
        message = self.message if other.message in self.message else joined(self.message, other.message)
        return _Notes(message, self.remarks | other.remarks)


def _kept(answer: Method) -> Method:
    """Keep what a method answers for a while, by what it takes."""

    @wraps(answer)
    def known(self: OffCentre, *arguments: Any) -> Any:
        key = (answer.__name__, *arguments)
        if (found := self._known.get(key)) is None:
            found = self._known[key] = answer(self, *arguments)
            if len(self._known) > KEPT:
                self._known.pop(next(iter(self._known)), None)
        return found

    return cast("Method", known)


@validate.methods_check_arguments()
class OffCentre(Unchanging, ComposedQuestions):
    """An averaged oscillator under a static load, or one whose motions may leave the centre.

    load     -- the static load over k_v L, in addition to the load that the vertical spring carries at the centre
    equation -- the oscillator that compares answers with the equation of motion, if known

    Answers are cached for some time, because some use others: a response curve uses its folds, margins use almost all.
    The force may be any piecewise polynomial, odd or not, and any other that is smooth up to the ends of its pieces.
    Excitation and damping are as for centred motions, except friction that ends at u_cr; motions that leave the centre
    by themselves, without a load, require a force as excitation, viscous damping and friction.
    """

    stays = "oscillators are immutable"
    instead = "replace({}=...) of the oscillator itself makes another"

    model: Loaded
    _model: Model
    _equation: Any
    _steps: Steps
    _flow: Flow
    _reach: Reach
    _complete: Complete
    _known: dict[tuple[Any, ...], Any]

    def __init__(self, model: Model, load: float, equation: Any = None) -> None:
        steps, flow = Steps(model.mechanism, model.parameters, load), Flow.of(model)
        # not by attribute: these cannot be set
        self.__dict__.update(model=Loaded(model, load), _model=model, _equation=equation)
        self.__dict__.update(_steps=steps, _flow=flow, _known={})
        complete = Complete(steps, flow)
        self.__dict__.update(_complete=complete, _reach=Reach(complete.sheets, flow, complete.A_max))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, OffCentre):
            return NotImplemented
        return (self._model, self.load) == (other._model, other.load)

    def __hash__(self) -> int:
        return hash((self._model, self.load))

    def _made(self, kind: Callable[..., _Answered], *columns: Any, **extra: Any) -> _Answered:
        """An answer with the load, that knows whom it was asked of, and how its numbers move."""
        extra |= {"load": self.load, "_model": self._model, "_gradient_of": answers.gradient}
        return kind(*columns, **extra, _equation=self._equation)

    @property
    def load(self) -> float:
        """The static load over k_v L."""
        return self._steps.load

    @property
    def sticking_forcing(self) -> float:
        """4 mu/pi: up to this forcing a mass at rest stays at its equilibrium (27); 0 for base or unbalance."""
        return 0.0 if self._flow.inertial else self._model.m

    @property
    def breakpoints(self) -> tuple[float, ...]:
        """The |u| at which the force passes from one piece to the next; u if the force is not odd."""
        return self._model.breakpoints

    @_kept
    def rest(self) -> RestPositions:
        """Every equilibrium, f(u) = load. Raises ArithmeticError in a dead zone, where all positions are equilibria."""
        # a bound of 0, as of a linear force without a load, leaves u = 0: it is looked for in a box around it
        bound = self._complete.offset_bound(0.0) or 1.0
        self._steps.check_balanced()
        edges = np.concatenate(
            (np.linspace(-bound, bound, SUBDIVISIONS + 1), self._steps.positions * self._steps.sides)
        )
        edges = np.unique(edges[(edges >= -bound) & (edges <= bound)])
        on = partial(at_rest, self._complete.sheets.charts)
        found = solve(on, edges[np.newaxis, :-1], edges[np.newaxis, 1:], np.zeros(edges.size - 1, int))
        (u,) = found.x
        u = np.sort(u)
        if self._complete.has_centre:  # Newton's method only tends to 0
            u = np.where(np.abs(u) <= AT_CENTRE, 0.0, u)
        stiffness = self._steps.at(np.zeros(u.size), u, 1).c[1]
        notes = self._beyond_reach(0.0, u)
        if found.undecided_of.size:
            notes = _Notes(_listed(UNDECIDED_REST, found.undecided[0]), Remark.UNDECIDED).combine(notes)
        return RestPositions(u, stiffness, stiffness > 0, self.load, **notes._asdict(), _model=self._model)

    @_kept
    def _detachment(self) -> Detachment:
        if not self.breakpoints:
            return self._no_detachment(ONE_PIECE)
        if self._rests_beyond():
            return self._no_detachment(BEYOND)
        found = self._reaching()
        if found is None and not self.rest().stable.any() and Remark.UNDECIDED in self.rest().remarks:
            return replace(self._no_detachment(UNKNOWN), remarks=Remark.UNDECIDED)
        if found is None:
            return self._no_detachment(NOT_REACHED)
        F_cr, Omega_cr, A_cr, B_cr = found
        if math.isinf(Omega_cr):
            return self._no_detachment(TENDED_TO.format(F_cr))
        return self._made(Detachment, F_cr, Omega_cr, None, "", A=A_cr, B=B_cr)

    @_kept
    def _reaching(self) -> tuple[float, float, float, float] | None:
        """The lowest forcing whose motion comes to an end of the first piece, Omega, which may be inf, A and B."""
        A, B = self._complete.detaching()
        if not A.size:
            return None
        # of the piece alone to whose end each comes
        s_0 = [self._steps.within(a, b).at(a, b, 0).s[0] for a, b in np.stack((A, B), axis=1)[..., np.newaxis]]
        level, Omega = self._flow.least_forcing(A, -2 * np.concatenate(s_0))
        F_cr, Omega_cr, A_cr, B_cr = np.stack((level, Omega, A, B))[:, int(np.argmin(level))].tolist()
        return F_cr, Omega_cr, A_cr, B_cr

    def _rests_beyond(self) -> bool:
        """Whether at rest the mass stands at an end of the first piece or beyond it, wherever it rests."""
        (lower, upper), at_rest = self._steps.inner, self.rest()
        steady = at_rest.u[at_rest.stable]
        return bool(steady.size and ((steady >= upper) | (steady <= lower)).all())

    def _no_detachment(self, message: str) -> Detachment:
        return self._made(Detachment, None, None, None, message)

    def _at_pairs(self, Omega: Any, F_0: Any) -> SteadyStates:
        found = at_pairs(self._amplitudes, Omega, F_0, ("Omega", "A", "B", "stable", "_h"))
        return self._made(SteadyStates, **found.columns, F_0=found.F_0, _flow=self._flow, **found.notes())

    def _amplitudes(self, at: Floats, F_0: float) -> SteadyStates:
        self._check_answered("amplitudes")
        x, of, undecided = np.empty((2, 0)), np.empty(0, dtype=np.intp), np.empty(0, dtype=np.intp)
        force = self._flow.force(F_0, at)
        sticks, moving = np.flatnonzero(force <= self._model.m), np.flatnonzero(force > self._model.m)
        exactly = _Notes(messages.moves_exactly(self._model, force))
        equilibria = self._stable_equilibria() if sticks.size else of
        static = np.stack((np.zeros(sticks.size * equilibria.size), np.tile(equilibria, sticks.size)))
        if self._model.sticks(F_0) or not at.size:
            notes = _Notes(messages.STICKS.format(F_0, self._model.m)) if self._model.sticks(F_0) else _Notes()
            notes = notes.combine(exactly)
            return self._states(at, static[0], static[1], F_0, notes, np.empty(0), np.repeat(sticks, equilibria.size))
        if moving.size and not self._keeps_centre:
            x, of, undecided = self._complete.states(at[moving], F_0)
            of, undecided = moving[of], moving[undecided]
        if self._complete.has_centre:
            centred = Averaged(self._model).states(Omega=at, F_0=F_0)
            of_centred = np.concatenate([np.flatnonzero(at == Omega) for Omega in np.unique(centred.Omega)] or [of])
            of_centred = np.repeat(of_centred, [int((centred.Omega == at[i]).sum()) for i in of_centred])
            x = np.concatenate((x, (centred.A, 0 * centred.A)), axis=1)
            of = np.concatenate((of, of_centred))
            undecided = np.concatenate((undecided, np.flatnonzero(np.isin(at, centred.Omega_undecided))))
        x, of = np.concatenate((x, static), axis=1), np.concatenate((of, np.repeat(sticks, equilibria.size)))
        order = np.lexsort((x[1], x[0], of))
        missing = np.unique(at[undecided])
        notes = _Notes(_listed(UNDECIDED, missing), Remark.UNDECIDED) if missing.size else _Notes()
        if self._complete.has_centre:
            notes = notes.combine(self._of_cut(centred, F_0, float(at.min())))
        notes = notes.combine(_Notes(messages.sticks_below(self._model, F_0, at))).combine(exactly)
        return self._states(at, x[0, order], x[1, order], F_0, notes, missing, of[order])

    def _stable_equilibria(self) -> Floats:
        """The stable equilibria; in a dead zone, where each is one, u = 0."""
        try:
            at_rest = self.rest()
        except ArithmeticError:
            return np.zeros(1)
        return at_rest.u[at_rest.stable]

    @property
    def _keeps_centre(self) -> bool:
        """Whether every motion is known to be about the centre: it may be, and the spring only stiffens.

        Where f(u)/u is positive and rises with |u| so does f with u, and with it the mean of f with B.
        """
        return self._complete.has_centre and self._model.stays_centred

    @_kept
    def _frequency_response(self, F_0: float, samples: int, window: tuple[float, float]) -> FrequencyResponse:
        # no branch is lost: folds and the states at frequencies between them are all there are, and neighbouring states
        # are shown to be on one arc
        self._check_answered("frequency_response")
        low, high = window
        if self._model.sticks(F_0):
            return self._response(Curves.none(), F_0, _Notes(messages.STICKS.format(F_0, self._model.m)))
        found, notes = Curves.none(), _Notes()
        if self._flow.inertial:
            # at rest it begins, with no amplitude: there all states meet
            begin = max(low, float(inertia.moves_from(F_0, self._model.m)) * (1 + BEGINS), high * BEGINS)
            if begin >= high:
                return self._response(found, F_0, _Notes(messages.empty_window(self._model, F_0, (low, high))))
            low = begin
        if not self._keeps_centre:
            folds = self.saddle_nodes(F_0)
            off = np.abs(folds.mean) > AT_CENTRE if self._complete.has_centre else np.ones(len(folds), dtype=bool)
            positions = np.stack((folds.Omega, folds.A, folds.mean))[:, off]
            slow = Slow(self._steps, self._flow, F_0)
            found = curves(slow, positions, partial(self._off, F_0=F_0), (low, high), samples)
            notes = _of_folds(folds)
        if self._complete.has_centre:
            centred = Averaged(self._model).frequency_response(F_0, samples=samples, Omega=(low, high))
            found = found.behind(Curves(centred.Omega, centred.A, 0 * centred.A, centred.branch, centred.isola))
            notes = notes.combine(_of_centred(centred)).combine(self._of_cut(centred, F_0, low))
        return self._response(found, F_0, notes)

    def _off(self, Omega: Floats, F_0: float) -> tuple[Floats, Ints]:
        """Every state at some frequencies, without a load those off the centre, and the number of its frequency."""
        x, of, undecided = self._complete.states(Omega, F_0)
        if undecided.size:
            raise NotSettled("the response is unresolved: double precision is inconclusive close to a fold")
        return x, of

    def _check_proof(self) -> None:
        """Raises ValueError: there is no proof of motions with a mean."""
        why = off_centre_by(self._model.mechanism, self.load) or "a mean B"
        raise validate.NotAvailable(CENTRED.format("certify", why))

    @_kept
    def _saddle_nodes(self, F_0: float) -> SaddleNodes:
        self._check_answered("saddle_nodes")
        if self._model.sticks(F_0):
            return self._folds(*NO_FOLDS, F_0, _Notes(messages.STICKS.format(F_0, self._model.m)))
        centred = Averaged(self._model).saddle_nodes(F_0) if self._complete.has_centre else None
        if centred is not None and self._keeps_centre:
            return self._folds(*NO_FOLDS, F_0, _Notes(centred.message, centred.remarks), centred)
        return self._folds_of(self._complete.folds(np.array([F_0])), centred, F_0)

    def _folds_at(self, F_0: list[float]) -> list[SaddleNodes]:
        """`saddle_nodes` at several forcings together."""
        several = [one for one in F_0 if not self._model.sticks(one) and ("_saddle_nodes", one) not in self._known]
        if len(several) > 1 and not self._complete.has_centre:
            self._check_answered("saddle_nodes")
            found = self._complete.folds(np.array(several))
            for i, one in enumerate(several):
                here, open_ = found.of == i, found.undecided_of == i
                part = Solutions(found.x[:, here], found.of[here], found.undecided[:, open_], found.undecided_of[open_])
                self._known["_saddle_nodes", one] = self._folds_of(part, None, one)
        return [self.saddle_nodes(one) for one in F_0]

    def _folds_of(self, found: Solutions, centred: SaddleNodes | None, F_0: float) -> SaddleNodes:
        """With those on corners."""
        corners, kinds, undecided = self._complete.corners(F_0)
        x, open_ = (np.concatenate(pair, axis=1) for pair in ((found.x, corners), (found.undecided, undecided)))
        kind = np.array([""] * found.x.shape[1] + kinds)
        notes = _Notes() if centred is None else _of_centred(centred).combine(self._of_cut(centred, F_0))
        if open_.size:
            folds = _listed(UNDECIDED_FOLDS, np.unique(np.round(open_[0], 12)))
            notes = notes.combine(_Notes(folds, Remark.UNDECIDED))
        if not (x.size or notes.remarks or (centred is not None and len(centred))):
            notes = _Notes(messages.NO_FOLD.format(F_0))
        return self._folds(x, kind, F_0, notes, centred)

    @_kept
    def _saddle_node_onset(self) -> SaddleNodeOnset:
        self._check_answered("saddle_node_onset")
        if self._keeps_centre:
            centred = Averaged(self._model).saddle_node_onset()
            B, notes = None if centred.F_SN is None else 0.0, _Notes(centred.message, centred.remarks)
            columns = centred.F_SN, centred.Omega, centred.A, centred.kind
            return self._made(SaddleNodeOnset, *columns, B=B, **notes._asdict())
        try:
            with np.errstate(over="ignore"):  # it is looked for up to amplitudes of any size
                found = self._complete.lowest()
        except ArithmeticError as failure:
            why = UNDECIDED_ONSET.format(failure.args[0])
            return self._made(SaddleNodeOnset, None, None, None, "", why, remarks=Remark.UNDECIDED)
        if found is None:
            return self._made(SaddleNodeOnset, None, None, None, "", NO_ONSET)
        truncated = Remark.OF_TRUNCATION if self._model.mechanism.truncated else Remark(0)
        jumps = found.kind == "corner" and self._steps.gains[self._steps.reached(found.A, found.B), 0] != 0
        notes = _Notes(ON_CORNER, truncated) if jumps else _Notes()
        columns = found.F_0, found.Omega, found.A, found.kind
        return self._made(SaddleNodeOnset, *columns, B=found.B, **notes._asdict())

    @_kept
    def _peak(self, F_0: float) -> Peak:
        self._check_answered("peak")
        if self._model.sticks(F_0):
            return self._made(Peak, None, None, F_0, messages.STICKS.format(F_0, self._model.m))
        if self._keeps_centre:
            centred = Averaged(self._model).peak(F_0)
            B = None if centred.A is None else 0.0
            far = {"B": B, "u_max": centred.A, "Omega_max": centred.Omega, "remarks": centred.remarks}
            return self._made(Peak, centred.A, centred.Omega, F_0, centred.message, **far)
        if self._flow.inertial and (why := self._no_top(F_0)):
            return self._made(Peak, None, None, F_0, why)
        highest, widest = (self._farthest(F_0, measure) for measure in (AMPLITUDE, LARGEST))
        if highest is None or widest is None:
            raise NotSettled("the largest motion is unresolved: none is found")
        if max(abs(widest.A - highest.A), abs(abs(widest.B) - abs(highest.B))) <= SAME * highest.A:
            widest = replace(highest, value=highest.A + abs(highest.B))
        notes = _Notes(TURNS) if highest.turns or widest.turns else _Notes()
        notes = notes.combine(self._beyond_reach(highest.A, widest.value - highest.A))
        far = {"B": highest.B, "u_max": widest.value, "Omega_max": widest.Omega, "_turns": highest.turns}
        return self._made(Peak, highest.A, highest.Omega, F_0, **notes._asdict(), **far)

    def _no_top(self, F_0: float) -> str:
        """Why an excitation by inertia has no motion that goes farthest, "" where it has one."""
        highest, full = self._farthest(F_0, AMPLITUDE), float(dissipation.full_by_inertia(F_0, self._flow.d))
        if highest is None or highest.A <= full * (1 + BEGINS):
            return messages.NO_TOP_BELOW.format(full)
        return CUT.format(self.A_max(F_0)) if self._is_cut(F_0) else ""

    def _is_cut(self, F_0: float) -> bool:
        """Whether there are motions beyond the amplitude up to which is looked."""
        highest = None if self._keeps_centre else self._farthest(F_0, AMPLITUDE)
        return highest is not None and highest.A > self.A_max(F_0)

    @_kept
    def _farthest(self, F_0: float, measure: Measure) -> Farthest | None:
        """The motion that goes farthest; of one about the centre as its own solvers have it."""
        found = self._reach.farthest(F_0, measure)
        if found is None or not self._complete.has_centre or abs(found.B) > AT_CENTRE:
            return found
        centred = Averaged(self._model).peak(F_0)
        if centred.A is None or centred.Omega is None:
            return found
        return Farthest(centred.A, centred.Omega, centred.A, 0.0, found.turns)

    def _lowest_detaching(self) -> float | None:
        detachment = self.detachment()
        if Remark.UNDECIDED in detachment.remarks:
            raise NotSettled(NO_MARGINS + detachment.message)
        if detachment.F_cr is not None or detachment.message in (ONE_PIECE, BEYOND, NOT_REACHED):
            return detachment.F_cr
        (F_cr, *_) = self._reaching() or (None,)
        return F_cr

    def _detaches(self, F_0: float) -> bool:
        """Whether a stable motion passes the first breakpoint."""
        F_cr = self._lowest_detaching()
        if F_cr is None:
            return bool(self.breakpoints) and self._rests_beyond()
        if F_0 <= F_cr or self.detachment().F_cr is None:  # below F_cr none reaches it; above a limit fast ones pass
            return F_0 > F_cr
        if self._steps.odd:
            u_max = self.peak(F_0).u_max
            return u_max is not None and u_max > self._steps.inner[1]
        curve = self.frequency_response(F_0)
        return bool((self._is_detached(curve) & curve.stable).any())

    def _is_detached(self, states: SteadyStates) -> Any:
        """Which motions pass an end of the first piece."""
        lower, upper = self._steps.inner
        return (states.mean + states.A > upper) | (states.mean - states.A < lower)

    def _isolation(self, F_0: float, level_dB: float) -> checks.Isolation:
        F_0, level = validate.number("F_0", F_0, above=0.0), isolating.as_level(level_dB)
        self._check_answered("isolation")
        made: Callable[..., checks.Isolation] = partial(self._made, checks.Isolation, level_dB=level.dB)
        sticks = messages.STICKS.format(F_0, self._model.m) if self._model.sticks(F_0) else ""
        floor = Averaged(self._model).transmissibility_floor(F_0)
        if why := sticks or isolating.passes_on(self._model, floor, level):
            return made(None, None, False, F_0, why, Remark(0))
        if self._flow.inertial and self._is_cut(F_0):
            raise NotSettled(OPEN.format(self.A_max(F_0)))
        folds = self.saddle_nodes(F_0)
        h = -2 * self._steps.at(folds.A, folds.mean, 0).s[0]
        passes = (folds.kind != "unstable") & isolating.transmits(self._flow, folds.Omega, folds.A, F_0, level, h)
        ends = np.stack((folds.Omega, folds.A, folds.mean))[:, passes].T.tolist()
        Omega, A, B = ends[-1] if ends else (0.0, None, None)
        last, is_proved = self._reach.last_transmitting(F_0, level, Omega)
        if last is not None:
            Omega, A, B = last.Omega, last.A, last.B
        notes = _of_folds(folds)
        if A is not None:
            notes = notes.combine(self._beyond_reach(A, B))
        elif is_proved:
            notes = notes.combine(_Notes(isolating.ISOLATES.format(str(level))))
        else:
            Omega = None
        if not is_proved:
            notes = notes.combine(_Notes(UNDECIDED_BEYOND.format(str(level)), Remark.UNDECIDED))
        return made(Omega, A, bool(ends) and last is None, F_0, **notes._asdict(), B=B)

    def A_max(self, F_0: float) -> float:
        """Amplitude up to which folds at F_0 are searched: 2^8 times the characteristic length of the problem.

        Raises ValueError for F_0 <= 0, and otherwise as `saddle_nodes`.
        """
        self._check_answered("A_max")
        return self._complete.A_max(validate.number("F_0", F_0, above=0.0))

    def _folds(
        self, x: Floats, on_corner: Any, F_0: float, notes: _Notes, centred: SaddleNodes | None = None
    ) -> SaddleNodes:
        """Folds in A, B and R, or Omega on a corner; of which kind those are, "" for others.

        centred -- those about the centre, by their own solvers
        """
        A, B, R = x
        means, averages = self._steps.averaged(A, B)
        with np.errstate(all="ignore"):
            Omega = np.where(on_corner == "", self._frequency(A, R, F_0, averages[0]), R)
            bends = self._flow.F_AA(Omega, A, averages)
        kind = np.where(bends < 0, "jump-up", "jump-down")
        kind, corner = np.where(means.c[1] > 0, kind, "unstable"), on_corner != ""
        kind = np.where(corner, on_corner, kind)
        if centred is None:
            notes = notes.combine(self._beyond_reach(A, B))
        else:
            rises = self._steps.at(centred.A, 0 * centred.A, 1).c[1] > 0
            about = centred.Omega, centred.A, 0 * centred.A, np.where(rises, centred.kind, "unstable"), centred.corner
            pairs = zip(about, (Omega, A, B, kind, corner), strict=True)
            Omega, A, B, kind, corner = (np.concatenate(pair) for pair in pairs)
        order = np.argsort(Omega, kind="stable")
        Omega, A, B = Omega[order], A[order], B[order]
        return self._made(SaddleNodes, Omega, A, kind[order], corner[order], F_0, B=B, **notes._asdict())

    def _of_cut(self, centred: SaddleNodes | SteadyStates, F_0: float, lowest: float = 0.0) -> _Notes:
        """Where the response about the centre is cut, at Omega from the lowest one on; nothing where it is not."""
        if Remark.CUT not in centred.remarks:
            return _Notes()
        return _Notes(solvers.remark_of(self._model, F_0, lowest), Remark.CUT)

    def _frequency(self, A: Floats, R: Floats, F_0: Any, h: Any) -> Floats:
        """Omega of a fold from R = A Omega^2 + h, or from I = m + 2 zeta A Omega where that moves it less."""
        with np.errstate(all="ignore"):
            I = np.sqrt((F_0 - R) * (F_0 + R))
            lag, square = off_centre.frequency_by_phase(A, R, I, self._model.m, self._model.zeta, h)
            if not self._flow.plain:
                return np.asarray(np.sqrt(np.maximum(square, 0.0)))
            by_R = (np.abs(R) + np.abs(h)) * (I - self._model.m) < 2 * A * square * (I + self._model.m)
            return np.asarray(np.where((square > 0) & by_R, np.sqrt(np.maximum(square, 0.0)), lag))

    def _states(
        self, at: Floats, A: Floats, B: Floats, F_0: float, notes: _Notes, undecided: Floats, of: Ints
    ) -> SteadyStates:
        Omega = at[of]
        stable, h = Slow(self._steps, self._flow, F_0).stability(Omega, A, B)
        notes = notes.combine(self._beyond_reach(A, B))
        extra = {"Omega_undecided": undecided, "_h": h, "_flow": self._flow, **notes._asdict()}
        return self._made(SteadyStates, Omega, A, stable, F_0, B=B, **extra)

    def _beyond_reach(self, A: Any, B: Any) -> _Notes:
        """That displacements |B| + A are beyond what the mechanism reaches, and why; nothing where none is."""
        reach, reason = self._model.reach, self._model.mechanism.reach_reason
        if not (np.abs(B) + A > reach).any():
            return _Notes()
        return _Notes(diagnostics.MESSAGES[Remark.BEYOND_REACH].format(reach=reach, reason=reason), Remark.BEYOND_REACH)

    def _response(self, found: Curves, F_0: float, notes: _Notes) -> FrequencyResponse:
        stable, h = Slow(self._steps, self._flow, F_0).stability(found.Omega, found.A, found.B)
        notes = notes.combine(self._beyond_reach(found.A, found.B))
        extra = {"branch": found.branch, "isola": found.closed, "_h": h, "_flow": self._flow, **notes._asdict()}
        return self._made(FrequencyResponse, found.Omega, found.A, stable, F_0, B=found.B, **extra)

    def _check_answered(self, question: str) -> None:
        """Raises where a question has no answer: what is too small, without damping, or leaves the centre by itself.

        Its computation begins after that.
        """
        if self._steps.length < SHORTEST and not self._keeps_centre:
            raise OutOfRange(TOO_SMALL.format((self._steps.length, 1.0)))
        if not self._flow.damps:
            raise Refused(UNDAMPED.format(question))
        if self._complete.has_centre and not self._flow.plain and not self._keeps_centre:
            extra = [f"excitation = {self._model.excitation!r}"] * self._model.inertial
            causes = together(", ", (*extra, *([self._model.laws.description()] if self._model.laws.any else [])))
            raise validate.NotAvailable(BY_ITSELF.format(question, causes))
        boundary.begin()


def _of_folds(folds: SaddleNodes) -> _Notes:
    """What folds have to bear in mind, found or not: that there are none is no remark, that some are undecided is."""
    return _Notes(folds.message, folds.remarks) if folds.remarks else _Notes()


def _of_centred(centred: SaddleNodes | FrequencyResponse) -> _Notes:
    """What an answer about the centre leaves undecided; where it is cut is `_of_cut`, and other remarks are of motions
    that leave the centre.
    """
    if Remark.UNDECIDED not in centred.remarks:
        return _Notes()
    return _Notes(diagnostics.MESSAGES[Remark.UNDECIDED].format(), Remark.UNDECIDED)


def _listed(sentence: Sentence, values: Floats) -> str:
    """A sentence with the first few of some numbers, of which a zero has no sign."""
    return sentence.format(values[:3] + 0.0, ", ..." * (len(values) > 3))
