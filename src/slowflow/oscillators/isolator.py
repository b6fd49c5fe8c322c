"""The shipped oscillators by name. Takes their parameters; returns oscillators that answer every question.

`Isolator` is the paper's mechanism, `Duffing` one polynomial. Names, domains and one-line docs are the records'.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from slowflow.answers.quantities import EXCITED, SHEET, SPRINGS, Scales, g, si
from slowflow.core import validate
from slowflow.core.mechanism import LINEAR, Force, Mechanism, described
from slowflow.core.model import THROUGHOUT, Laws, Model
from slowflow.oscillators import range_checks
from slowflow.oscillators.oscillator import FORCES, Oscillator, of_arrays_or_labelled
from slowflow.oscillators.physical import Physical
from slowflow.support.errors import Refused
from slowflow.support.text import text
from slowflow_kernels import duffing, rod_spring
from slowflow_kernels.domains import DAMPING, DISSIPATION
from slowflow_kernels.scaling import SCALES

if TYPE_CHECKING:
    from slowflow.answers.quantities import Number
    from slowflow.core.mechanism import Unlabelled
    from slowflow.grid.many import Designs


ROD_SPRING: Mechanism = rod_spring.MECHANISM
DUFFING: Mechanism = duffing.MECHANISM
#: of the numbers of a design and of its damping, by name
DOMAINS = {domain.name: domain for domain in (*ROD_SPRING.design, *DUFFING.design, *DAMPING, *DISSIPATION)}


NEGATIVE = (
    "delta_h = {delta_h:g} exceeds 1/(lam r) = {most:g}: negative stiffness at rest (alpha = {alpha:g}); the averaged "
    "motion is about {u} = 0"
)


def _averaged(force: Any) -> Mechanism:
    """The isolator's mechanism with the force that is to be averaged, one of `FORCES`."""
    untruncated = validate.choice("force", force, FORCES) == "untruncated"
    return ROD_SPRING.load_untruncated() if untruncated and ROD_SPRING.load_untruncated else ROD_SPRING


def _viscous(c: Any, zeta: float | None) -> dict[str, Any]:
    """The viscous damping of a data sheet, by the one name that it has there."""
    if c is not None and zeta is not None:
        raise Refused("c and zeta both define the viscous damping: specify one of them")
    return {"zeta": 0.0 if zeta is None else zeta} if c is None else {"c": c}


def _numbers(scales: Scales, known: Mapping[str, Any]) -> dict[str, Any]:
    """The dimensionless numbers of what is known of a data sheet, in SI units."""
    measured = scales.measures.items()
    return {
        name: scales.over(word, known[word], DOMAINS[name], scale) for name, (word, scale) in measured if word in known
    }


def _of_rods(
    known: Mapping[str, Any], of: type[Scales], *, mounts: int = 1, **settings: str
) -> tuple[Scales, dict[str, Any]]:
    """The scales of an isolator, or of many, and their dimensionless numbers, from a data sheet in SI units."""
    moving = known.get("load", known["m"])
    scales = of(m=moving, k_v=mounts * known["k_v"], L=known["L"], mounts=mounts, sheet=known, **settings)
    numbers = _numbers(scales, known)
    if "load" in known:
        numbers["load"] = (scales.m - known["m"]) * g / scales.sizes["force"]
    return scales, numbers


def _of_spring(known: Mapping[str, Any], of: type[Scales], **settings: str) -> tuple[Scales, dict[str, Any]]:
    """The same of springs without a rod: at x = L the first other term equals k_1 x; L is 1 m where there are not two.

    Without k_1 the first term that there is has the dimensionless factor 1.
    """
    k_1, k_3, k_5 = (np.abs(np.asarray(known[name], dtype=float)) for name in SPRINGS)
    with np.errstate(all="ignore"):
        L = np.fmin(np.sqrt(k_1 / k_3), np.sqrt(np.sqrt(k_1 / k_5)))
        L = np.where((k_1 != 0) & ((k_3 != 0) | (k_5 != 0)), L, 1.0)
        k_v = np.where(k_1 != 0, k_1, np.where(k_3 != 0, k_3, k_5))
    base: dict[str, Any] = {"k_v": k_v[()], "L": L[()], **settings}
    scales = of(m=known["m"], sheet=known, **base)
    return scales, _numbers(scales, known)


@validate.methods_check_arguments()
class Isolator(Oscillator):
    __doc__ = f"""The high-static-low-dynamic-stiffness isolator (1)-(7), whose horizontal springs detach at u_cr.

    All numbers are dimensionless (4): stiffnesses are divided by k_v, lengths by L, forces by k_v L.

{described((*ROD_SPRING.design, *DAMPING, *DISSIPATION))}
    contact -- "throughout", or "attached": dry friction acts while the springs touch the push-rod, |u| < u_cr
    mu_s -- static friction, as in `Oscillator`
    force -- the averaged force: "truncated" for the fifth-order polynomial (6), which jumps at u_cr, "untruncated" for
        the force as the geometry gives it (5)
    excitation -- "force", "base" or "unbalance", as in `Oscillator`
    load -- static load in addition to that on the vertical spring at the centre, over k_v L, as in `Oscillator`

    For delta_h > 1/(lam r) the stiffness at the centre is negative, and a warning is issued. Raises ValueError for a
    number outside its domain, and for an unknown force.
    """

    lam: float
    r: float
    delta_h: float
    alpha: float
    beta: float
    gamma: float
    u_cr: float

    @validate.checks_arguments
    def __init__(
        self,
        *,
        lam: float,
        r: float,
        delta_h: float,
        mu: float = 0.0,
        zeta: float = 0.0,
        eta: float = 0.0,
        c_2: float = 0.0,
        c_3: float = 0.0,
        zeta_2: float = 0.0,
        contact: str = THROUGHOUT,
        mu_s: float = 0.0,
        force: str = "truncated",
        excitation: str = "force",
        load: float = 0.0,
    ) -> None:
        design = {"lam": lam, "r": r, "delta_h": delta_h}
        damping = {"mu": mu, "zeta": zeta, "eta": eta, "c_2": c_2, "c_3": c_3, "zeta_2": zeta_2}
        super().__init__(_averaged(force), contact=contact, mu_s=mu_s, excitation=excitation, **damping, **design)
        if self.delta_h == 0:  # the springs never touch the rod: a linear spring without a breakpoint
            self.__dict__["model"] = Model(
                DUFFING, LINEAR, self.mu, self.zeta, design=LINEAR, excitation=excitation, laws=self.model.laws
            )
        if not self.model.mechanism.truncated:
            coefficients = zip(ROD_SPRING.parameters, ROD_SPRING.coefficients(*self.design), strict=True)
            self.__dict__.update({name.name: float(value) for name, value in coefficients})
        del self.given["mechanism"]
        self.given["force"] = force
        if load != 0:
            self._put(load)
        if self.alpha < 0:
            negative = text(NEGATIVE, self.delta_h, 1 / (self.lam * self.r), self.alpha)
            range_checks.warn([negative], UserWarning)

    def restoring_force(self, which: str | None = None) -> Force:
        if which == "truncated":
            return Force.of(ROD_SPRING, (self.alpha, self.beta, self.gamma, self.u_cr))
        return super().restoring_force(which)

    @classmethod
    @validate.checks_arguments
    def physical(
        cls,
        *,
        m: Number,
        k_v: Number,
        k_h: Number,
        L: Number,
        preload: Number,
        n: int = 3,
        mounts: int = 1,
        friction: Number = 0.0,
        c: Number | None = None,
        zeta: float | None = None,
        eta: float = 0.0,
        c_2: Number = 0.0,
        c_3: Number = 0.0,
        c_xx: Number = 0.0,
        contact: str = THROUGHOUT,
        static_friction: Number | None = None,
        load: Number | None = None,
        force: str = "untruncated",
        excitation: str = "force",
    ) -> Physical:
        """Make an isolator from its data sheet, with arguments and answers in newtons, metres and hertz.

        Arguments are numbers in these units, strings such as "0.4 N", or pint quantities. A number that seems to be in
        another unit, such as L = 80, gives a warning.

        The vertical spring is preloaded by m g/k_v, so that the mass m rests at the centre, where the push-rods are
        horizontal. With another `load`, the mass rests off centre, at `rest()`, and results include the mean B of the
        motion.

        Parameters
        ----------
        m : float, kg
            Mass that moves.
        k_v, k_h : float, N/m
            Stiffness of the vertical spring, and of each horizontal one.
        L, preload : float, m
            Length of the push-rod, and compression of each horizontal spring at the centre.
        n : int
            Number of horizontal springs.
        mounts : int
            Number of equal mounts that share the mass: m and load are the whole mass, all other data those of one
            mount.
        friction : float, N
            Dry friction.
        c, zeta : float, N s/m, or dimensionless
            Viscous damping, or the damping ratio c/(2 sqrt(k_v m)): one of them, or neither for none.
        eta : float
            Structural damping, the loss factor of the vertical spring, dimensionless.
        c_2 : float, N s^2/m^2
            Quadratic damping, the factor of the squared velocity.
        c_3 : float, N s^3/m^3
            Cubic damping, the factor of the cubed velocity.
        c_xx : float, N s/m^3
            Growth of the viscous damping with the squared displacement, (c + c_xx x^2) x', as of a horizontal damper.
        contact : str
            Where friction acts: "throughout", or "attached", while the springs touch the push-rod.
        static_friction : float, N
            Break-loose force, if larger than `friction`; used by exact motions only.
        load : float, kg
            Mass that the mount carries, if it differs from the mass m that k_v is preloaded to carry.
        force : str
            "untruncated" as the geometry gives it (5), or "truncated" as the paper averages it (6).
        excitation : str
            "force", in N; "base" or "acceleration", base excitation by the displacement in m or the acceleration in
            m/s^2; "unbalance", a rotating mass times its radius, in kg m; the rotating mass is part of m.

        Returns
        -------
        Physical
            The mount.

        Raises
        ------
        ValueError
            For a number outside its domain, for combinations of damping laws as in `Isolator`, and for a load with
            contact="attached", for which offset motions are not derived.
        """
        excitation = validate.excitation(excitation, tuple(EXCITED))
        mounts = validate.count("mounts", mounts, least=1)
        (damping,) = viscous = _viscous(c, zeta)
        sheet = {"k_h": k_h, "n": n, "preload": preload, "friction": friction, "eta": eta, "c_2": c_2}
        sheet |= {"c_3": c_3, "c_xx": c_xx, "L": L, **viscous}
        known = {name: si(name, value, SHEET[name]) for name, value in sheet.items()}
        above_0 = {"m": m, "k_v": k_v, **({} if load is None else {"load": load})}
        known |= {
            name: validate.number(name, si(name, value, SHEET[name]), above=0.0) for name, value in above_0.items()
        }
        scales, numbers = _of_rods(known, Scales, excitation=excitation, damping=damping, mounts=mounts)
        mu_s, mu = 0.0, numbers["mu"]
        if static_friction is not None:
            static_force = si("static_friction", static_friction, "N")
            static = validate.number("static_friction", static_force, least=known["friction"])
            mu_s = max(mu, static * mounts / scales.of(SCALES["mu"]))
        laws = Laws.of(contact, **numbers)
        with scales.in_these_terms():
            isolator = cls(force=force, excitation=scales.of_oscillator, contact=laws.contact, mu_s=mu_s, **numbers)
        range_checks.warn(range_checks.of_mount(known, isolator.zeta, mounts))
        arguments: dict[str, Any] = dict(m=m, k_v=k_v, k_h=k_h, n=n, L=L, preload=preload, friction=friction)
        arguments |= {"mounts": mounts} if mounts > 1 else {}
        arguments |= {"c": c} if c is not None else {"zeta": isolator.zeta}
        in_terms = {"c_2": ("c_2", c_2), "c_3": ("c_3", c_3), "zeta_2": ("c_xx", c_xx)}
        arguments |= dict(in_terms.get(name, (name, value)) for name, value in laws.present.items())
        arguments |= {} if static_friction is None else {"static_friction": static_friction}
        arguments |= {"load": load, "force": force, "excitation": excitation}
        in_si = {name: si(name, value, SHEET[name]) for name, value in arguments.items() if value is not None}
        return Physical(isolator, dataclasses.replace(scales, sheet=in_si), arguments)

    _of_sheet = staticmethod(_of_rods)

    @of_arrays_or_labelled
    @validate.checks_arguments
    def many(  # type: ignore[override]
        cls,
        *,
        lam: Unlabelled,
        r: Unlabelled,
        delta_h: Unlabelled,
        mu: Unlabelled = 0.0,
        zeta: Unlabelled = 0.0,
        eta: Unlabelled = 0.0,
        c_2: Unlabelled = 0.0,
        c_3: Unlabelled = 0.0,
        zeta_2: Unlabelled = 0.0,
        contact: str = THROUGHOUT,
        force: str = "truncated",
        excitation: str = "force",
        load: Unlabelled = 0.0,
    ) -> Designs:
        """Make a batch of isolators from the arguments of `Isolator`, arrays that broadcast; see `Oscillator.many`.

        Arrays of xarray or dask make a map over named axes, which may be larger than memory; see
        `slowflow.grid.designs`.

        Raises ValueError for arguments that are not real arrays and for shapes that do not broadcast. Invalid designs
        raise nothing: each entry has a status.
        """
        numbers = {"lam": lam, "r": r, "delta_h": delta_h, "mu": mu, "zeta": zeta}
        numbers |= {"eta": eta, "c_2": c_2, "c_3": c_3, "zeta_2": zeta_2}
        found: Designs = super().many(_averaged(force), contact=contact, excitation=excitation, load=load, **numbers)
        return found


@validate.methods_check_arguments()
class Duffing(Oscillator):
    __doc__ = f"""u'' + 2 zeta u' + mu sign(u') + alpha u + beta u^3 + gamma u^5 = F_0 cos(Omega tau): Duffing's.

{described((*DUFFING.design, *DAMPING, *DISSIPATION))}
    mu_s -- static friction, as in `Oscillator`
    excitation -- "force", "base" or "unbalance", as in `Oscillator`
    load -- static load on the right-hand side, over k_v L, as in `Oscillator`

    Raises ValueError for a number outside its domain, and for an unknown excitation.
    """

    alpha: float
    beta: float
    gamma: float

    @validate.checks_arguments
    def __init__(
        self,
        alpha: float,
        beta: float,
        mu: float = 0.0,
        zeta: float = 0.0,
        *,
        gamma: float = 0.0,
        eta: float = 0.0,
        c_2: float = 0.0,
        c_3: float = 0.0,
        zeta_2: float = 0.0,
        mu_s: float = 0.0,
        excitation: str = "force",
        load: float = 0.0,
    ) -> None:
        damping = {"mu": mu, "zeta": zeta, "eta": eta, "c_2": c_2, "c_3": c_3, "zeta_2": zeta_2, "mu_s": mu_s}
        springs = {"alpha": alpha, "beta": beta, "gamma": gamma}
        contact = THROUGHOUT  # one piece, without springs that detach
        super().__init__(DUFFING, contact=contact, excitation=excitation, load=load, **springs, **damping)
        del self.given["mechanism"]

    @classmethod
    @validate.checks_arguments
    def physical(
        cls,
        *,
        m: Number,
        k_1: Number,
        k_3: Number = 0.0,
        k_5: Number = 0.0,
        friction: Number = 0.0,
        c: Number | None = None,
        zeta: float | None = None,
        eta: float = 0.0,
        c_2: Number = 0.0,
        c_3: Number = 0.0,
        c_xx: Number = 0.0,
        excitation: str = "force",
    ) -> Physical:
        """Make a mass on a spring k_1 x + k_3 x^3 + k_5 x^5, in newtons, metres and hertz.

        Parameters
        ----------
        m : float, kg
            Mass that moves, at rest at x = 0.
        k_1, k_3, k_5 : float, N/m, N/m^3 and N/m^5
            A negative k_1 is a double well, a negative k_3 or k_5 softens. Signs may differ: a spring that
            softens and then hardens may have four folds.
        friction, c, zeta, eta, c_2, c_3, c_xx, excitation : as of `Isolator.physical`
            Here zeta is c/(2 sqrt(k m)) with k = |k_1|, or k = |k_3| (1 m)^2 if k_1 = 0, or |k_5| (1 m)^4 if both are.

        Returns
        -------
        Physical
            The mount.

        Raises
        ------
        ValueError
            For a number outside its domain, and without a spring.
        """
        (damping,) = viscous = _viscous(c, zeta)
        springs = {"k_1": k_1, "k_3": k_3, "k_5": k_5}
        laws = {"friction": friction, "eta": eta, "c_2": c_2, "c_3": c_3, "c_xx": c_xx, **viscous}
        excitation = validate.excitation(excitation, tuple(EXCITED))
        arguments: dict[str, Any] = {"m": m, **springs, **laws, "excitation": excitation}
        in_si = {name: si(name, value, SHEET[name]) for name, value in arguments.items()}
        in_si |= {name: validate.number(name, in_si[name]) for name in springs}
        if not any(in_si[name] for name in springs):
            raise Refused("k_1 = k_3 = k_5 = 0 is not allowed: there is no spring")
        scales, numbers = _of_spring(in_si, Scales, excitation=excitation, damping=damping)
        with scales.in_these_terms():
            oscillator = cls(excitation=scales.of_oscillator, **numbers)
        return Physical(oscillator, scales, arguments)

    _of_sheet = staticmethod(_of_spring)

    @of_arrays_or_labelled
    @validate.checks_arguments
    def many(  # type: ignore[override]
        cls,
        alpha: Unlabelled,
        beta: Unlabelled,
        mu: Unlabelled = 0.0,
        zeta: Unlabelled = 0.0,
        *,
        gamma: Unlabelled = 0.0,
        eta: Unlabelled = 0.0,
        c_2: Unlabelled = 0.0,
        c_3: Unlabelled = 0.0,
        zeta_2: Unlabelled = 0.0,
        excitation: str = "force",
        load: Unlabelled = 0.0,
    ) -> Designs:
        """Make a batch from the arguments of `Duffing`, arrays that broadcast; see `Isolator.many`."""
        damping = {"mu": mu, "zeta": zeta, "eta": eta, "c_2": c_2, "c_3": c_3, "zeta_2": zeta_2}
        springs = {"alpha": alpha, "beta": beta, "gamma": gamma}
        found: Designs = super().many(DUFFING, excitation=excitation, load=load, **springs, **damping)
        return found
