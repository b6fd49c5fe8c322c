"""One oscillator as numbers. Takes a mechanism's record and parameters; returns the functions that solvers call."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property
from itertools import pairwise
from typing import Any, ClassVar

import numpy as np

from slowflow.core import backend, validate
from slowflow.core.mechanism import Floats, Mechanism, Parameter, check_at_rest
from slowflow.support.errors import Refused, WrongType
from slowflow.support.text import Sentence, listed, text
from slowflow_kernels import dissipation, inertia, slow_flow
from slowflow_kernels.conventions import LARGEST
from slowflow_kernels.domains import CONTACTS, DAMPING, DISSIPATION

__all__ = ["Floats", "Laws", "Model", "check_names"]

FORCE_ALONE = "the response with cubic damping is derived for a force, or a base's acceleration"
WITHOUT_ZETA = "the damping of small motions would vanish faster than their amplitude"
WITHOUT_DAMPING = (
    "the response to an excitation by inertia is derived with viscous, structural or quadratic damping only"
)


BEYOND = Sentence("{numbers:s}: not allowed together, {name:s} would be beyond {most:g}")
NO_END = Sentence("{numbers:s}: not allowed together, there is no real {u} at which piece {number:d} of the force ends")
DO_NOT_RISE = Sentence(
    "{numbers:s}: not allowed together, the force's pieces end at |{u}| = {u:g}, which must be ascending{above:s}"
)
DO_NOT_RISE_SIDED = Sentence(
    "{numbers:s}: not allowed together, the force's pieces end at {u = :g}, which must be ascending{above:s}"
)
PUSHES = Sentence("{what:s} is not allowed for {name:s}: its force jumps at {u} = 0, and pushes outwards")
STIFF = Sentence("{what:s} is not allowed for {name:s}: its stiffness is infinite at {u} = 0")


#: names of `DAMPING`
OF_DAMPING = tuple(domain.name for domain in DAMPING)


def check_names(mechanism: Mechanism, values: Mapping[str, Any], optional: tuple[Parameter, ...] = ()) -> list[str]:
    """The names of a design's numbers, then mu and zeta, if the values have just these; else a TypeError names one.

    optional -- further names that the values may have: these come last
    """
    names = [*mechanism.design_names, *OF_DAMPING, *(domain.name for domain in optional if domain.name in values)]
    if values.keys() != set(names):
        wrong = next(name for name in (*values, *names) if name not in values or name not in names)
        what = "is missing for" if wrong in names else "is not a parameter of"
        raise WrongType(f"{wrong} {what} {mechanism.name}: it takes {', '.join(names)}")
    return names


#: where dry friction acts unless it is said
THROUGHOUT = next(iter(CONTACTS))


@dataclass(frozen=True)
class Laws:
    """The damping laws of an oscillator other than viscous damping and dry friction throughout.

    eta     -- loss factor of the vertical spring
    c_2     -- quadratic damping, c_2 |u'|u'
    c_3     -- cubic damping, c_3 u'^3
    zeta_2  -- viscous damping that grows with the displacement, 2 (zeta + zeta_2 u^2) u'
    contact -- where dry friction acts, a key of `CONTACTS`
    """

    eta: float = 0.0
    c_2: float = 0.0
    c_3: float = 0.0
    zeta_2: float = 0.0
    contact: str = THROUGHOUT

    @classmethod
    def of(cls, contact: Any, **numbers: Any) -> Laws:
        """From what a user gives. Raises ValueError for a number outside its domain, or another word."""
        where = validate.choice("contact", contact, tuple(CONTACTS))
        values = {domain.name: validate.within(domain, numbers.get(domain.name, 0.0)) for domain in DISSIPATION}
        return cls(contact=where, **values) if any(values.values()) or where != THROUGHOUT else NO_LAWS

    @property
    def numbers(self) -> dict[str, Any]:
        """Those of `DISSIPATION`, in its order."""
        return {domain.name: getattr(self, domain.name) for domain in DISSIPATION}

    @cached_property
    def present(self) -> dict[str, Any]:
        """Those that are present, by name."""
        return {
            field.name: getattr(self, field.name)
            for field in fields(self)
            if np.any(getattr(self, field.name) != field.default)
        }

    @cached_property
    def any(self) -> bool:
        """Whether there are any."""
        return bool(self.present)

    def description(self, *without: str) -> str:
        """The names and values of those that are present, without these names."""
        return listed({name: value for name, value in self.present.items() if name not in without})


NO_LAWS = Laws()
#: those of `DISSIPATION` whose share is derived for motions with a mean
WITH_MEAN = tuple(domain.name for domain in DISSIPATION if domain.name in ("eta", "c_2"))


def break_loose(m: Any, preload: Any) -> Floats:
    """The forcing up to which a mass at rest stays there, whatever the frequency: sqrt(R^2 + I^2) (24) at A = 0.

    That is m = 4 mu/pi, and more where a preload, -h as A tends to 0, pulls inwards: then there are motions beside the
    rest. Numbers or arrays; no square leaves the range of doubles.
    """
    return np.asarray(slow_flow.held(m, np.maximum(preload, 0.0)))


@dataclass(frozen=True)
class SlowFlow:
    """The slow flow of one oscillator, or of many, whose numbers are arrays that broadcast: functions of (Omega, A).

    mechanism  -- record of the restoring force
    parameters -- the force's parameters, in the order of `mechanism.parameters`
    mu, zeta   -- dry friction and viscous damping ratio
    excitation -- what the amplitude F_0 is of, a key of `EXCITATIONS`
    laws       -- what dissipates beside mu and zeta
    """

    mechanism: Mechanism
    parameters: tuple[Any, ...]
    mu: Any
    zeta: Any
    excitation: str = "force"
    laws: Laws = NO_LAWS

    _begins_beyond: ClassVar[Any] = False

    def each(self, function: Callable[[Any], Any]) -> SlowFlow:
        """That of others, by a function of each number."""
        parameters = tuple(map(function, self.parameters))
        laws = Laws(contact=self.laws.contact, **{name: function(value) for name, value in self.laws.numbers.items()})
        return SlowFlow(self.mechanism, parameters, function(self.mu), function(self.zeta), self.excitation, laws)

    @cached_property
    def m(self) -> Any:
        """4 mu/pi, friction's share of I (23)."""
        return slow_flow.friction(self.mu)

    @cached_property
    def breakpoints(self) -> tuple[Any, ...]:
        """Where the pieces of the force end."""
        return tuple(self.mechanism.breakpoints(*self.parameters))

    @property
    def first_end(self) -> Floats:
        """The lowest |u| at which a piece of the force ends; inf where there is one piece only."""
        found = np.full(np.broadcast_shapes(*map(np.shape, self.parameters)), math.inf)
        for end in reversed(self.breakpoints):
            found = np.where(np.asarray(end) > 0, end, found)
        return found

    @cached_property
    def preload(self) -> Any:
        """-h as A tends to 0: 4/pi times what an odd force jumps to at u = 0, which all but a few forces do not."""
        return -np.asarray(self._rest[0]) * self.mechanism.odd

    @cached_property
    def _rest(self) -> tuple[Floats, ...]:
        """The averages as A tends to 0, which several questions need."""
        return tuple(np.asarray(value) for value in self.mechanism.at_rest(*self.parameters))

    @cached_property
    def stays_centred(self) -> Any:
        """Whether every motion about u = 0 is known to stay about it.

        Where f(u)/u is positive and rises with |u| so does -h/A with A, and -h_A is positive with it: so is their mean.
        """
        hardening = np.broadcast_arrays(*self.mechanism.hardening(*self.parameters))
        pull, slope = self._rest[:2]
        return np.all([value >= 0 for value in hardening], axis=0) & ~(slope > 0) & ~(pull > 0)

    @cached_property
    def break_loose(self) -> Any:
        """The forcing up to which a mass at rest stays there, whatever the frequency: `held`."""
        return break_loose(self.m, self.preload)

    @property
    def undamped(self) -> Any:
        """Whether dry friction alone takes energy, which bounds no resonance."""
        values = np.broadcast_arrays(self.zeta, *self.laws.numbers.values())
        return np.all([value == 0 for value in values], axis=0) & (self.laws.contact == THROUGHOUT)

    @property
    def inertial(self) -> bool:
        """Whether the force is the amplitude of the excitation times Omega^2."""
        return self.excitation != "force"

    def force(self, F_0: Any, Omega: Any) -> Any:
        """Amplitude of the force at an amplitude F_0 of the excitation; shapes that broadcast."""
        return inertia.force(Omega, F_0) if self.inertial else F_0

    @cached_property
    def d(self) -> Any:
        """8 c_2/(3 pi), the factor of A^2 Omega^2 in I."""
        return dissipation.quadratic(self.laws.c_2)

    @cached_property
    def d_3(self) -> Any:
        """3 c_3/4, the factor of A^3 Omega^3 in I."""
        return dissipation.cubic(self.laws.c_3)

    def at_rest(self, A: Any) -> tuple[Floats, ...]:
        """The part of I (23) that knows no frequency, and three derivatives by A; shapes that broadcast."""
        within: tuple[Floats, ...] = dissipation.at_rest(A, self.m, self.laws.eta)
        if self.laws.contact == THROUGHOUT:
            return within
        u_cr = self.breakpoints[0]
        released = dissipation.released(np.maximum(A, u_cr), self.m, self.laws.eta, u_cr)
        return tuple(np.where(np.asarray(A) > u_cr, two, one) for one, two in zip(within, released, strict=True))

    def viscous(self, A: Any) -> tuple[Any, ...]:
        """The viscous damping ratio of a cycle, and three derivatives by A."""
        found: tuple[Any, ...] = dissipation.viscous(A, self.zeta, self.laws.zeta_2)
        return found

    def sine(self, Omega: Any, A: Any) -> Floats:
        """I, the sine balance (23), -F_0 sin phi at a steady state; shapes that broadcast."""
        if not self.laws.any:
            return np.asarray(slow_flow.I(Omega, A, self.m, self.zeta))
        return np.asarray(dissipation.I(Omega, A, self.at_rest(A)[0], self.viscous(A)[0], self.d, self.d_3))

    def equivalent_damping(self, Omega: Any, A: Any) -> tuple[Any, Any]:
        """m and zeta of the slow flow's kernels that have the same I at (Omega, A); only its slopes are others."""
        return (self.sine(Omega, A), 0.0) if self.laws.any else (self.m, self.zeta)

    def phase(self, Omega: Any, A: Any, h: Any) -> Any:
        """phi (25) at steady states."""
        return slow_flow.phase(Omega, A, *self.equivalent_damping(Omega, A), h)

    def transmissibility(self, Omega: Any, A: Any, F_0: Any, h: Any) -> Any:
        """What spring, damper and friction pass on at steady states, over the force."""
        return slow_flow.transmissibility(Omega, A, self.force(F_0, Omega), *self.equivalent_damping(Omega, A), h)

    @property
    def curve(self) -> Any:
        """The kernels of the response's slopes, by what dissipates; they take what `_damping` gives."""
        return dissipation if self.laws.any else slow_flow

    def _damping(self, A: Any, orders: int) -> tuple[Any, ...]:
        """What kernels of `curve` take between A and h: m, zeta, or I_0, zeta, slopes below `orders`, then d, d_3."""
        if self.curve is not dissipation:
            return self.m, self.zeta
        return *self.at_rest(A)[:orders], *self.viscous(A)[:orders], self.d, self.d_3

    def F_A(self, Omega: Any, A: Any, averages: Any = None) -> Floats:
        """dF/dA (24), positive where a steady state is stable (30), at (Omega, A), shapes that broadcast.

        averages -- h and its derivatives, by default those at A
        """
        h, h_A, *_ = averages or self.averaged(A)
        return np.asarray(self.curve.F_A(Omega, A, *self._damping(A, 2), h, h_A))

    def stability(self, Omega: Any, A: Any) -> Floats:
        """The left side of (30), likewise."""
        h, h_A, _, _ = self.averaged(A)
        return np.asarray(self.curve.stability(Omega, A, *self._damping(A, 2), h, h_A))

    def F_AA(self, Omega: Any, A: Any, averages: Any = None) -> Floats:
        """d2F/dA2 (24), likewise."""
        h, h_A, h_AA, *_ = averages or self.averaged(A)
        return np.asarray(self.curve.F_AA(Omega, A, *self._damping(A, 3), h, h_A, h_AA))

    def level(self, Omega: Any, A: Any, averages: Any = None) -> Floats:
        """The amplitude F_0 of the excitation for which (Omega, A) is a steady state (24), likewise."""
        kernels: Any = inertia if self.inertial else slow_flow
        h, *_ = averages or self.averaged(A)
        return np.asarray(kernels.level(Omega, A, *self.equivalent_damping(Omega, A), h))

    def sticks_at(self, F_0: Any, Omega: Any) -> Any:
        """Whether a mass at rest stays there at an excitation F_0 of frequency Omega; numbers, or arrays.

        Then A = 0 is a steady state: the force on the mass does not exceed what (24) takes as A tends to 0.
        """
        return self.force(F_0, Omega) + 0.0 * np.asarray(Omega) <= self.break_loose

    def full_level(self, A: Any) -> Any:
        """The amplitude of an excitation by inertia under which A is what the response tends to as Omega grows."""
        return np.sqrt(dissipation.far_by_inertia(0.0, A, 0.0, 0.0, 0.0, self.d, 0.0)[0])

    def floor(self, F_0: Any) -> Any:
        """What transmissibility tends to as Omega tends to inf, see `Averaged.transmissibility_floor`."""
        if self.inertial:
            return dissipation.I(1.0, dissipation.full_by_inertia(F_0, self.d), 0.0, 0.0, self.d, 0.0) / F_0
        with np.errstate(over="ignore"):  # a share of next to no force
            return np.minimum(1.0, slow_flow.transmissibility(1.0, 0.0, F_0, self.m, self.zeta, self.preload))

    def averaged(self, A: Any) -> tuple[Floats, Floats, Floats, Floats]:
        """h, h_A, h_AA, h_AAA at the amplitudes A (any shape)."""
        found = self.mechanism.averaged(A, *self.parameters)
        if self._begins_beyond:
            at_rest = self.mechanism.at_rest(*self.parameters)
            found = tuple(np.where(np.asarray(A) == 0, rest, one) for one, rest in zip(found, at_rest, strict=True))
        h, h_A, h_AA, h_AAA = found
        return h, h_A, h_AA, h_AAA


@dataclass(frozen=True)
class Model(SlowFlow):
    """The slow flow of one oscillator, dimensionless, its numbers checked.

    design     -- the numbers that the parameters follow from, as they were given; () where these are not known
    breakpoints, jumps -- where the pieces of the force end, and the force just below less the force just above
    native     -- the same as the compiled solvers take it; None of a force that is not odd
    """

    parameters: tuple[float, ...]
    mu: float
    zeta: float
    design: tuple[float, ...] = ()
    m: float = field(init=False)
    breakpoints: tuple[float, ...] = field(init=False)
    jumps: tuple[float, ...] = field(init=False)
    native: Any = field(init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        if self.inertial:
            self._check_inertia()
        if self.laws.contact != THROUGHOUT and self.zeta == self.laws.eta == self.laws.c_2 == 0:
            raise Refused(
                self.laws.description() + " is not allowed without zeta, eta or c_2: nothing would dissipate beyond"
            )
        for name in ("c_3", "zeta_2"):
            if self.zeta == 0 and name in self.laws.present:
                number = listed({name: self.laws.present[name]})
                raise Refused(number + f" is not allowed with zeta = 0: {WITHOUT_ZETA}")
        laws: tuple[float, ...] = ()
        if self.laws.any:
            laws = *self.laws.numbers.values(), float(self.laws.contact != THROUGHOUT)
        damping = self.mu, self.zeta, *laws
        native = backend.compiled_model(self.mechanism, self.parameters, damping, self.design, self.inertial)
        m, breakpoints, jumps = self._prepared() if native is None else backend.SOLVER.prepared(native)
        self.__dict__.update(m=m, breakpoints=breakpoints, jumps=jumps, native=native)
        if not self.mechanism.is_generated:
            check_at_rest(self.mechanism, self.parameters)
        if self.laws.any:
            self._check_laws()

    # before the parameters are known to be numbers of ordinary size
    @np.errstate(all="ignore")
    def _check_inertia(self) -> None:
        """Raises ValueError for an excitation by inertia that has no answer here."""
        if self.zeta == self.laws.eta == self.laws.c_2 == 0:
            raise Refused(f"excitation = {self.excitation!r} is not allowed with zeta = 0: {WITHOUT_DAMPING}")
        if self.laws.c_3 > 0:
            raise Refused(f"excitation = {self.excitation!r} is not allowed with c_3: {FORCE_ALONE}")
        self._check_preload(f"excitation = {self.excitation!r}")

    def _check_preload(self, what: str) -> None:
        """Raises ValueError for a preload that pushes outwards, together with what has no answer with it."""
        # a force that is not odd has no motions about u = 0
        if self.mechanism.odd and self.preload < 0:
            raise Refused(PUSHES.format(what, self.mechanism.name))

    @np.errstate(all="ignore")
    def _check_laws(self) -> None:
        """Raises ValueError for laws that have no answer here."""
        laws, odd = self.laws.description(), self.mechanism.odd
        self._check_preload(laws)
        if odd and not math.isfinite(self.mechanism.pieces[0].slope(0.0, *self.parameters)):
            raise Refused(STIFF.format(laws, self.mechanism.name))
        if self.laws.contact != THROUGHOUT and not self.breakpoints:
            raise Refused(
                laws + f" is not allowed for {self.mechanism.name}: its force has one piece, nothing detaches"
            )

    @np.errstate(all="ignore")
    def _prepared(self) -> tuple[float, tuple[float, ...], tuple[float, ...]]:
        """m, breakpoints and jumps, where the compiled solvers do not tell, or refuse the numbers.

        Raises ValueError for a parameter beyond `LARGEST`, and for pieces whose ends do not rise.
        """
        m = float(slow_flow.friction(self.mu))
        numbers = dict(zip((*self.mechanism.parameter_names, text("4 {mu}/pi")), (*self.parameters, m), strict=True))
        ends = tuple(map(float, self.mechanism.breakpoints(*self.parameters)))
        for name, value in numbers.items():
            # of an end that is no number it is said below which piece has it
            if not abs(value) <= LARGEST and not (math.isnan(value) and any(map(math.isnan, ends))):
                listing = listed({**self.numbers, "mu": self.mu, "zeta": self.zeta})
                raise Refused(BEYOND.format(listing, name, LARGEST))
        jumps = map(float, self.mechanism.jumps(*self.parameters))
        # A piece of no width (u_cr = 0 for a null preload) is no piece.
        odd = self.mechanism.odd
        kept = [(end, jump) for end, jump in zip(ends, jumps, strict=True) if end != 0 or not odd]
        first = 0.0 if odd else -np.inf
        if not all(above > below for (below, _), (above, _) in pairwise([(first, 0.0), *kept])):
            listing = listed(self.numbers)
            if not all(math.isfinite(end) for end in ends):
                lost = 1 + next(i for i, end in enumerate(ends) if not math.isfinite(end))
                raise Refused(NO_END.format(listing, lost))
            above = " from 0" if odd and min(ends) < 0 else ""
            raise Refused((DO_NOT_RISE if odd else DO_NOT_RISE_SIDED).format(listing, ends, above))
        return m, tuple(end for end, _ in kept), tuple(jump for _, jump in kept)

    def __reduce__(self) -> tuple[Any, ...]:
        arguments = (self.mechanism, self.parameters, self.mu, self.zeta, self.excitation, self.laws, self.design)
        return Model, arguments

    @classmethod
    def of(
        cls, mechanism: Mechanism, values: Mapping[str, Any], excitation: str = "force", laws: Laws = NO_LAWS
    ) -> Model:
        """The slow flow of a design, its numbers and mu and zeta given by name.

        Raises ValueError for a number outside its domain, TypeError for a name that is missing or unknown.
        """
        check_names(mechanism, values)
        domains = (*mechanism.design, *DAMPING)
        *own, mu, zeta = [validate.within(domain, values[domain.name]) for domain in domains]
        design = tuple(own)
        return cls(mechanism, backend.parameters_of(mechanism, design), mu, zeta, excitation, laws, design)

    @property
    def undamped(self) -> bool:
        """The same, a flag."""
        return self.zeta == 0 and not self.laws.any

    @cached_property
    def linear(self) -> bool:
        """Whether the averaged force is proportional to the amplitude."""
        if self.breakpoints or self.preload != 0:
            return False
        return bool(self.averaged(min(1.0, 0.5 * self.mechanism.reach))[2] == 0)

    @cached_property
    def spring(self) -> str:
        """Whether a spring "holds" the mass far away, "none" does, or one "levels off", by averages in closed form.

        Where none does, some force at Omega = 0 moves the mass as far as one likes.
        """
        return str(backend.SOLVER.spring(self.native))

    @cached_property
    def preload(self) -> float:
        """The same, a number."""
        return -float(self._rest[0]) if self.mechanism.odd else 0.0

    @cached_property
    def _rest(self) -> tuple[Floats, ...]:
        """The same, by the compiled averages."""
        return self.averaged(0.0)

    @cached_property
    def hardens(self) -> bool:
        """Whether f(u)/u is known to rise with |u|, jumps included."""
        return all(value >= 0 for value in self.mechanism.hardening(*self.parameters))

    @cached_property
    def negative_stiffness(self) -> bool:
        """Whether the stiffness at rest is negative, which is -h_A there, or a preload pushes outwards."""
        return self.preload < 0 or bool(self._rest[1] > 0)

    @cached_property
    def stays_centred(self) -> bool:
        """The same, a flag."""
        return self.hardens and not self.negative_stiffness

    def sticks(self, F_0: float) -> bool:
        """Whether friction leaves no motion at any frequency (27)."""
        return F_0 <= self.m and not self.inertial and self.laws.contact == THROUGHOUT

    @cached_property
    def break_loose(self) -> float:
        """The same, a number."""
        return float(break_loose(self.m, self.preload))

    def holds(self, F_0: float) -> bool:
        """Whether a mass at rest stays there while there are motions as well.

        A preload makes them, and friction that ends at u_cr: beyond, its share m u_cr/A may be as little as one asks.
        """
        has_motions = self.preload > 0 or self.laws.contact != THROUGHOUT
        return has_motions and not self.inertial and F_0 <= self.break_loose

    @cached_property
    def reach(self) -> float:
        """Largest |u| of the mechanism, inf if it has none, see `Mechanism.reach_at`.

        A breakpoint that rounds to it lies below it: folds on it are looked for.
        """
        reach = float(self.mechanism.reach_at(*self.parameters))
        last = max(self.breakpoints, default=0.0)
        return reach if last < reach else math.nextafter(last, math.inf)

    @property
    def has_design(self) -> bool:
        """Whether the numbers are known that the parameters follow from; a force may have none of its own."""
        return len(self.design) == len(self.mechanism.design)

    def arguments(self) -> dict[str, Any]:
        """Names of mechanism and excitation, and the numbers that make the oscillator, its design if that is known."""
        damping = {"mu": self.mu, "zeta": self.zeta}
        others = {"excitation": self.excitation, **self.laws.present}
        return {"mechanism": self.mechanism.name, **self.numbers, **damping, **others}

    @property
    def numbers(self) -> dict[str, float]:
        """The numbers of the force by name: its design if that is known, else its parameters."""
        of_force = zip(self.mechanism.parameter_names, self.parameters, strict=True)
        of_design = zip(self.mechanism.design_names, self.design, strict=False)
        return dict(of_design) if self.has_design else dict(of_force)

    @cached_property
    def _begins_beyond(self) -> bool:
        """Whether a piece of the force ends at u = 0, and has no extent."""
        return any(float(end) == 0 for end in self.mechanism.breakpoints(*self.parameters))

    def harmonics(self, A: Any) -> tuple[Floats, ...]:
        """h_3 and h_5, each with its three derivatives, at the amplitudes A (any shape)."""
        return tuple(self.mechanism.harmonics(A, *self.parameters))


# ---- off the centre

#: what a load leaves as it is
KNOWN = (
    *("mechanism", "parameters", "design", "mu", "zeta", "laws", "m"),
    *("excitation", "inertial", "force", "sticks", "breakpoints", "reach"),
)

#: of questions that look at motions about the centre, or begin there
CENTRED = Sentence("{question:s} is not available with {why:s}: it assumes motion about the centre")


def off_centre_by(mechanism: Mechanism, load: float) -> str:
    """What takes motions off the centre, in words; "" for nothing."""
    if not mechanism.odd:
        return "a force that is not odd"
    return text("{load = :g}", load) if load != 0 else ""


class Loaded:
    """The numbers of an oscillator under a load or with a force that is not odd; all else of it is refused.

    A load takes the mass off the centre, about which every answer is that does not say `B`. Those questions ask a
    `Model`; an oscillator with a load has this in its place, so that none can answer as if the load were none.
    """

    def __init__(self, model: Model, load: float) -> None:
        self.unloaded, self.load = model, load
        for name in KNOWN:
            setattr(self, name, getattr(model, name))
        # off the centre a preload does not change sides next to rest: friction alone holds the mass there
        self.break_loose, self.preload = model.m, 0.0

    def holds(self, F_0: float) -> bool:
        """Whether a mass at rest stays there while there are motions as well: none does, as the preload is 0."""
        return False

    def arguments(self) -> dict[str, Any]:
        """As of `Model`, with the load."""
        return {**self.unloaded.arguments(), "load": self.load}

    def __getattr__(self, name: str) -> Any:
        # what copying and pickling ask for is asked before there are any numbers
        if name.startswith("_") or "load" not in self.__dict__:
            raise AttributeError(name)
        raise validate.NoAttribute(CENTRED.format(name, off_centre_by(self.unloaded.mechanism, self.load)))
